#include "actio/any_group/rigid_motions.hpp"

namespace actio::systems {

bool is_of_rigid_motions(MatrixAlgebra const& algebra) {
  auto const n = algebra.size - 1;
  for (auto const& e : algebra.basis)
    if (e.row(n).any() || e.topLeftCorner(n, n) != -e.topLeftCorner(n, n).transpose()) return false;
  return true;
}

bool keeps_length_of_momenta(MatrixAlgebra const& algebra) {
  auto const constant = [&](int a, int b, int c) {
    for (auto const& other : algebra.constants)
      if (other.a == a && other.b == b && other.c == c) return other.value;
    return 0.0;
  };
  for (auto const& c : algebra.constants)
    if (constant(c.a, c.c, c.b) != -c.value) return false;
  return !algebra.constants.empty();
}

}  // namespace actio::systems
