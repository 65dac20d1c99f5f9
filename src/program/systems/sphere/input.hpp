// What a scene says of a flow on the sphere: the size of its matrices, its Hamiltonian, how the sphere turns,
// and how the flow begins.
#pragma once

#include <Eigen/Core>

#include "program/systems/sphere/hamiltonian.hpp"

namespace actio::scene {

/// A flow at the start.
struct VorticityStart {
  int n = 0;                         ///< N
  SphereHamiltonian hamiltonian;     ///< of the flow
  double rotation = 0;               ///< of the sphere, 1/time
  sphere::SphereHarmonics relative;  ///< the vorticity relative to the sphere
  sphere::SkewHermitian<> matrix;    ///< the same as a matrix
  std::string key;                   ///< of [initial] that says it
};

/// [system] of a flow, but for its Hamiltonian.
struct SphereKeys : KeyTable {
  Key<int> N = key("N", whole("a whole number, 2 or more", 2, 1 << 20), needed,
                   "The size of the matrices: functions have the degrees 0 to N - 1. Time grows with N^3 "
                   "and memory with N^2; interactions of waves of the degree l are those of the sphere but "
                   "for a part of about l^4/(6 N^2).",
                   "64");
  Key<double> rotation =
      key("rotation", number.in("1/time"), 0,
          "The angular velocity of the sphere about the pole. The flow is given relative to the sphere, d "
          "zeta/dt + u . grad(zeta + 2 rotation cos(theta)) = 0.",
          "1.0");
};
inline SphereKeys const sphere_keys{{"system"}};  ///< its keys

/// The records of the keys of [system] and [initial].
std::vector<Parameter> vorticity_parameters();

/// Reads what they say, and writes defaults back.
/// @param remarks  what was done to the input
/// @throws SceneError  where the start is missing, said twice or wrong
VorticityStart read_vorticity_start(SceneFile const& file, std::vector<std::string>& remarks);

/// Rows `l,m,re,im` out of a text, with a heading.
/// @param path   of its file, for complaints
/// @param n      degrees are less than N
/// @throws SceneError  with the line: of what is no such row, a row that is there twice or of a degree
///   beyond; where one is missing
sphere::SphereHarmonics read_harmonics(std::string const& text, std::string const& path, int n);
/// The same out of a file.
/// @throws FileError   where it cannot be read
sphere::SphereHarmonics read_harmonics_file(std::string const& path, int n);

/// One row of coefficients, put where it belongs.
/// @param lines  where each coefficient was read, 0: not yet; N by N
/// @return what is wrong with it; empty where nothing is
std::string put_coefficient(sphere::SphereHarmonics& f, Eigen::MatrixXi& lines, int line, double l, double m,
                            double re, double im);

}  // namespace actio::scene
