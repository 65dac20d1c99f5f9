#include <Eigen/Core>

#include "actio/vorticity/diagonal_runge_kutta.hpp"

namespace actio::sphere {

Eigen::MatrixXd diagonal_tableau(std::vector<double> const& weights) {
  auto const stages = static_cast<Eigen::Index>(weights.size());
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(stages, stages);
  for (Eigen::Index j = 0; j < stages; ++j) {
    double const b = weights[static_cast<std::size_t>(j)];
    a(j, j) = b / 2;
    a.col(j).tail(stages - j - 1).setConstant(b);
  }
  return a;
}

std::vector<double> five_stages(double first) {
  if (!std::isfinite(first)) throw NotFinite("five stages: the first weight");
  double const s = 1 - 2 * first, cubes = (s * s * s + 2 * first * first * first) / 6;
  double const bound = triple_jump<double>()[0];
  if (!(first < bound && cubes > 0))
    throw OutsideDomain("five stages", "the first weight must be less than that of the triple jump", first,
                        bound);
  // Newton's iteration for a convex function, from above.
  double second = std::max(s, 0.0) + std::cbrt(cubes);
  for (int k = 0; k < 100; ++k) {
    double const to_s = second - s;
    double const next = second - (second * to_s * to_s - cubes) / (to_s * (to_s + 2 * second));
    if (!(next < second)) break;
    second = next;
  }
  return {first, second, 1 - 2 * (first + second), second, first};
}

}  // namespace actio::sphere
