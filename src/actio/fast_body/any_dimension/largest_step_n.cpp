#include "actio/fast_body/any_dimension/largest_step_n.hpp"

namespace actio::bodies {

namespace detail {

double largest_of_tridiagonal(std::vector<double> const& diagonal, std::vector<double> const& beside) {
  double high = 0;
  for (std::size_t k = 0; k < diagonal.size(); ++k)
    high = std::max(high, std::abs(diagonal[k]) + (k ? std::abs(beside[k - 1]) : 0.0) +
                              (k < beside.size() ? std::abs(beside[k]) : 0.0));
  double low = *std::max_element(diagonal.begin(), diagonal.end());
  auto const above_all = [&](double x) {
    double pivot = x - diagonal[0];
    for (std::size_t k = 1; k < diagonal.size() && pivot > 0; ++k)
      pivot = x - diagonal[k] - beside[k - 1] * beside[k - 1] / pivot;
    return pivot > 0;
  };
  for (int k = 0; k < 60 && low < high; ++k) {
    double const middle = (low + high) / 2;
    (above_all(middle) ? high : low) = middle;
  }
  return high;
}

SpinAgainstInertia::SpinAgainstInertia(Eigen::VectorXd lambda, Eigen::MatrixXd m)
    : lambda_(std::move(lambda)),
      m_(std::move(m)),
      start_(Eigen::VectorXd::LinSpaced(lambda_.size(), 1, 2)) {}

double SpinAgainstInertia::operator()(double s, double digits) {
  Eigen::VectorXd const w = (lambda_.array().square() + s * s).rsqrt();
  std::vector<Eigen::VectorXd> basis{start_.normalized()};
  std::vector<double> diagonal, beside;
  double found = 0;
  for (int k = 0; k < std::min<int>(static_cast<int>(lambda_.size()), 120); ++k) {
    Eigen::VectorXd v = minus_square(w, basis.back());
    diagonal.push_back(v.dot(basis.back()));
    for (int twice = 0; twice < 2; ++twice)
      for (auto const& b : basis) v -= v.dot(b) * b;
    double const before = found;
    found = largest_of_tridiagonal(diagonal, beside);
    double const left = v.norm();
    if (k > 3 && found - before <= digits * digits * found) break;
    if (!(left > 1e-14 * found)) break;
    beside.push_back(left);
    basis.push_back(v / left);
  }
  // A value to start from next time, with s nearby: one step nearer the top than before.
  start_ = minus_square(w, minus_square(w, basis.front())) + 1e-3 * found * found * basis.front();
  return s * std::sqrt(std::max(0.0, found));
}

}  // namespace detail

double largest_step_n(Inertia<Eigen::Dynamic> const& inertia,
                      Momentum<SO<Eigen::Dynamic>, double> const& pi) {
  if (!is_finite(pi.components)) throw NotFinite("largest_step: body momentum");
  double const size = magnitude(pi.components), unit = magnitude(inertia.lambda);
  if (size == 0) return std::numeric_limits<double>::infinity();
  Eigen::VectorXd const lambda = inertia.lambda / unit;
  if (lambda.minCoeff() < 0)
    throw OutsideDomain("largest_step",
                        "the closed form asks for Lambda_i >= 0; smallest, in units of the largest",
                        lambda.minCoeff(), 0);
  detail::SpinAgainstInertia spin(lambda, inertia.group.hat((pi.components / size).eval()));

  double smallest = 1;
  for (double const l : lambda)
    if (l > 0) smallest = std::min(smallest, l);
  double const low = std::log(smallest) - 12, high = std::log(4.0);
  int const count = 40 + static_cast<int>(4 * (high - low));
  double const gap = (high - low) / count;
  std::vector<double> value(static_cast<std::size_t>(count) + 1);
  for (int i = 0; i <= count; ++i) value[static_cast<std::size_t>(i)] = spin(std::exp(low + i * gap), 1e-2);
  double const highest = *std::max_element(value.begin(), value.end());
  double best = highest;
  for (int i = 0; i <= count; ++i) {
    auto const at = static_cast<std::size_t>(i);
    bool const local = (i == 0 || value[at] >= value[at - 1]) && (i == count || value[at] >= value[at + 1]);
    if (local && value[at] > 0.9 * highest) {
      auto const f = [&](double t) { return spin(std::exp(t), 1e-4); };
      best = std::max(best, actio::detail::top_of_hump(f, low + (i - 1) * gap, low + (i + 1) * gap));
    }
  }
  return unit / size / best;
}

}  // namespace actio::bodies
