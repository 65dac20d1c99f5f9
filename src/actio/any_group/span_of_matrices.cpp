#include "actio/any_group/span_of_matrices.hpp"

namespace actio::systems {

bool SpanOfMatrices::cubes_stay() const {
  Vector<double> v(dimension());
  double coordinate = 0.5;
  for (int a = 0; a < dimension(); ++a) {
    coordinate = std::fmod(coordinate * 997 + std::sqrt(2.0), 1.0);
    v[a] = (coordinate - 0.5) / row_norm(algebra_->basis[static_cast<std::size_t>(a)]);
  }
  Matrix<double> const e = hat(v), cube = e * e * e;
  return row_norm(Matrix<double>(hat(vee(cube)) - cube)) <= 1e-10 * row_norm(e) * row_norm(e) * row_norm(e);
}

}  // namespace actio::systems
