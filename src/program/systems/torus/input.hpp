// What a scene says of a flow on the torus: the size of its matrices, its radius of deformation, and how it
// begins.
#pragma once

#include "actio/quantized_torus/torus_harmonics.hpp"
#include "program/registry/system.hpp"

namespace actio::scene {

/// A flow at the start.
struct TorusStart {
  int n = 0;                        ///< N
  double gamma = 0;                 ///< 1 over the square of the radius of deformation; 0 for Euler's fluid
  torus::TorusHarmonics vorticity;  ///< its mean is zero
  std::string key;                  ///< of [initial] that says it
};

/// [system] of a flow.
struct TorusKeys : KeyTable {
  Key<int> N =
      key("N", whole("an odd whole number, 3 or more", 3, 1 << 20), needed,
          "The size of the matrices, odd: functions have the wave numbers up to (N - 1)/2 in x and in y. "
          "Time grows with N^3 and memory with N^2; interactions of waves of the wave number k are those of "
          "the torus but for a part of about pi^2 k^4/(6 N^2). Sizes with small factors are the fastest.",
          "65");
  Key<double> deformation =
      key("deformation", number.called("a number from 0.001 to 1000").in("lengths, of which a side has 2 pi"),
          LeftOut{"none: Euler's fluid"},
          "The radius of deformation of a layer, or of the drift waves of a plasma (Charney, Hasegawa "
          "and Mima): (Laplacian - 1/deformation^2) psi = potential vorticity, which is then the "
          "vorticity of the scene, in [initial], rows and snapshots.",
          "0.3");
};
inline TorusKeys const torus_keys{{"system"}};  ///< its keys

/// The records of the keys of [system] and [initial].
std::vector<Parameter> torus_parameters();

/// N, which is odd.
/// @throws SceneError
int read_torus_size(SceneFile const& file);
/// \f$\gamma\f$.
/// @throws SceneError
double read_torus_gamma(SceneFile const& file);

/// Reads what they say, and writes defaults back.
/// @param remarks  what was done to the input
/// @throws SceneError  where the start is missing, said twice or wrong
TorusStart read_torus_start(SceneFile const& file, std::vector<std::string>& remarks);

/// A function that is given by its values, on so many points that what it has beyond the last wave number is
/// seen; without its mean.
template <class Function>
torus::TorusHarmonics harmonics_of_function(int n, Function const& f) {
  int const points = 2 * n;
  torus::GridValues values(points, points);
  for (int j = 0; j < points; ++j)
    for (int k = 0; k < points; ++k) values(k, j) = f(2 * M_PI * j / points, 2 * M_PI * k / points);
  torus::TorusHarmonics out = torus::harmonics_from_grid(values, n);
  out.set(0, 0, 0);
  return out;
}

/// The coefficients as a table with the heading m,n,re,im: n > 0, and n = 0 with m > 0.
std::string table_of_torus_harmonics(torus::TorusHarmonics const& f);
/// Rows of one out of a text.
/// @param path  of its file, for complaints
/// @throws SceneError  with the line: of what is no such row, one that is there twice or beyond (N - 1)/2
torus::TorusHarmonics read_torus_harmonics(std::string const& text, std::string const& path, int n);
/// The same out of a file.
/// @throws FileError   where it cannot be read
torus::TorusHarmonics read_torus_harmonics_file(std::string const& path, int n);

}  // namespace actio::scene
