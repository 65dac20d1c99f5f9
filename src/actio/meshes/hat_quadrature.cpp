#include "actio/meshes/hat_quadrature.hpp"

namespace actio::media {

namespace detail {

HatQuadrature::HatQuadrature(BodyMesh::Shape shape, int d) {
  // Gauss and Legendre's three points, on the unit interval; on simplices in collapsed coordinates.
  double const off = std::sqrt(0.15);
  double const at[3] = {0.5 - off, 0.5, 0.5 + off}, of[3] = {5.0 / 18, 8.0 / 18, 5.0 / 18};
  int const count = d == 1 ? 3 : d == 2 ? 9 : 27;
  for (int k = 0; k < count; ++k) {
    int const index[3] = {k % 3, k / 3 % 3, k / 9};
    Sample s{{}, 1};
    double left = 1;  // of the simplex, beyond the coordinates taken
    for (int i = 0; i < d; ++i) s.weight *= of[index[i]];
    if (is_simplex(shape)) {
      for (int i = 0; i < d; ++i) {
        for (int power = i + 1; power < d; ++power) s.weight *= 1 - at[index[i]];
        s.hat[i + 1] = left * at[index[i]], left -= s.hat[i + 1];
      }
      s.hat[0] = left;
    } else {
      for (int b = 0; b < 1 << d; ++b) {
        s.hat[b] = 1;
        for (int i = 0; i < d; ++i) s.hat[b] *= b >> i & 1 ? at[index[i]] : 1 - at[index[i]];
        for (int i = 0; i < d; ++i)
          s.slope[b][i] = b >> i & 1 ? s.hat[b] / at[index[i]] : -s.hat[b] / (1 - at[index[i]]);
      }
    }
    for (int b = 0; b < 8; ++b) total[b] += s.weight * s.hat[b];
    all += s.weight;
    samples.push_back(s);
  }
}

}  // namespace detail

}  // namespace actio::media
