#include "actio/fast_body/any_dimension/natural_chart_equation.hpp"

namespace actio::bodies {

namespace detail {

NaturalChartEquation::NaturalChartEquation(Inertia<Eigen::Dynamic> const& inertia, double unit,
                                           MatrixAlgebra const& algebra)
    : algebra_(algebra),
      subgroup_(algebra),
      moments_(algebra.size()),
      inverse_(algebra.size()),
      error_(algebra.size()),
      room_(algebra.size()),
      change_(algebra.size()) {
  over_planes(algebra.shape().n, [&](int a, int i, int j) {
    double const moment = inertia.moments[a] / unit;
    least_ = std::min(least_, moment);
    for (auto const at : {full_entry(algebra.shape(), i, j), full_entry(algebra.shape(), j, i)})
      moments_.data()[at] = moment, inverse_.data()[at] = 1 / moment;
  });
}

bool NaturalChartEquation::by_sweeps(double const* p, double* z, double contraction, double slowest) {
  double before = HUGE_VAL;
  contraction_ = contraction;
  // What the rounding of the mean makes of a change.
  double const noise = 64 * rounding * algebra_.norm(p) / least_;
  for (sweeps_ = 1; sweeps_ <= most_sweeps; ++sweeps_) {
    if (!(algebra_.norm(z) < too_large)) return false;
    algebra_.add(1, change(p, z), z);
    double const change = algebra_.norm(change_.data()), size = algebra_.norm(z);
    bool const seen = before < HUGE_VAL;
    if (seen && change > noise) contraction_ = change / before;
    // From one step to the next contraction changes, but not by a factor of 4.
    double const factor = seen ? std::min(1.0, change / before) : std::min(1.0, 4 * contraction);
    if (factor * change <= rounding / 4 * size) return true;
    if (change > slowest * before) return change <= noise;
    before = change;
  }
  return false;
}

double const* NaturalChartEquation::change(double const* p, double const* z) {
  double* const change = change_.data();
  subgroup_.mean(z, p, error_.data());
  std::copy(z, z + algebra_.size(), room_.data());
  algebra_.multiply_entries(moments_.data(), room_.data());
  algebra_.add(-1, room_.data(), error_.data());
  std::copy(error_.data(), error_.data() + algebra_.size(), change);
  for (double const factor : {1.0 / 2, 1.0 / 6}) {
    // R, [Z,R]/2, [Z,[Z,R]]/12.
    algebra_.times_transposed(z, error_.data(), room_.data());
    algebra_.subtract_transposed(room_.data());
    algebra_.scale(-factor, room_.data());
    algebra_.add(1, room_.data(), change);
    std::swap(error_, room_);
  }
  algebra_.multiply_entries(inverse_.data(), change);
  return change;
}

bool NaturalChartEquation::in_chart(double const* z) {
  if (algebra_.norm(z) / std::numbers::sqrt2 < std::numbers::pi ||
      subgroup_.angle_bound(z) < std::numbers::pi)
    return true;
  int const n = algebra_.shape().n;
  Eigen::MatrixXd matrix(n, n);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) matrix(i, j) = z[full_entry(algebra_.shape(), i, j)];
  return skew_spectrum(matrix).maxCoeff() < std::numbers::pi;
}

}  // namespace detail

}  // namespace actio::bodies
