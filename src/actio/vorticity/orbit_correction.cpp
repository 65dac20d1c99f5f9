#include <Eigen/Core>

#include "actio/vorticity/orbit_correction.hpp"

namespace actio::sphere {
namespace detail {
namespace {

/// Leaves out of the change of the energy what is rounding, and of the Gram matrix what is no direction. The
/// momentum about the axis is held as well as it is known: b times its change is one of the enstrophy.
/// @param turn  a of the background
/// @return      the lengths of the X
Eigen::VectorXd leave_rounding(StepRound const& round, double turn, Eigen::VectorXd const& scale,
                               Eigen::MatrixXd& gram, Eigen::VectorXd& change) {
  constexpr double rounding = 16 * std::numeric_limits<double>::epsilon(), small = 1e-3, smallest = 1e-5;
  // What C is the sum of; the last of the X is that of the third axis.
  double const n = static_cast<double>(round.a.size()),
               most = norm(round.a) * norm(round.middle) / std::sqrt(n) +
                      std::abs(turn) * norm(round.turned.back()),
               part = norm(round.commutator) / most;
  if (part < small && !(std::abs(change[0]) > rounding * most * scale[0])) change[0] = 0;
  if (!(part > smallest)) gram.row(0).setZero(), gram.col(0).setZero();
  Eigen::VectorXd const lengths = gram.diagonal().cwiseSqrt();
  return (lengths.array() > 0).select(lengths, 1);
}

}  // namespace
}  // namespace detail

double correct_factors(QuantizedSphere const& sphere, StepRound const& round, std::optional<double> turn,
                       Eigen::Vector4d& factors) {
  if (round.directions.empty()) return 0;
  auto const count = static_cast<Eigen::Index>(round.turned.size()) + 1;
  Eigen::VectorXd change(count), scale(count);
  // [vorticity_changes]
  change[0] = round.eps * inner_product(round.p, round.commutator);
  scale[0] = std::abs(round.eps) * norm(round.p);
  // [vorticity_changes]
  auto const direction = [&](Eigen::Index j) { return round.directions[static_cast<std::size_t>(j) - 1]; };
  for (Eigen::Index j = 1; j < count; ++j)
    change[j] = direction(j).dot(spin_components(sphere, round.commutator)),
    scale[j] = std::sqrt(sphere.n / 3.0) / sphere.hbar();
  auto const x = [&](Eigen::Index j) -> SkewHermitian<> const& {
    return j == 0 ? round.commutator : round.turned[static_cast<std::size_t>(j) - 1];
  };
  Eigen::MatrixXd gram(count, count);
  for (Eigen::Index i = 0; i < count; ++i)
    for (Eigen::Index j = 0; j <= i; ++j) gram(i, j) = gram(j, i) = inner_product(x(i), x(j));
  Eigen::VectorXd unit = scale, sought = change;
  if (turn) {
    unit = detail::leave_rounding(round, *turn, scale, gram, change);
    if (gram(0, 0) == 0) factors[0] = 0;
    // The part of P that belongs to the background, by the change of the angular momentum about its axis.
    sought = change;
    for (Eigen::Index j = 1; j < count; ++j) sought[0] += *turn * direction(j)[2] * change[j];
  }
  gram = gram.cwiseQuotient(unit * unit.transpose());
  factors.head(count) += regular_solution(gram, sought.cwiseQuotient(unit), 1e-8).cwiseQuotient(unit);
  return change.cwiseQuotient(scale).norm();
}

}  // namespace actio::sphere
