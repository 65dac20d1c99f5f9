#include <Eigen/Core>

#include "actio/sphere_fields/legendre_functions.hpp"

namespace actio::sphere {

LegendreFunctions::LegendreFunctions(Eigen::ArrayXd const& colatitudes, int degrees)
    : degrees_(degrees),
      t_(colatitudes.size()),
      sine_(colatitudes.size()),
      first_(colatitudes.size()),
      exponent_(colatitudes.size(), 0) {
  for (Eigen::Index j = 0; j < colatitudes.size(); ++j) {
    auto const at = static_cast<std::size_t>(j);
    double const half = std::sin(colatitudes[j] / 2);
    t_[j] = 2 * half * half;
    sine_[at] = std::sin(static_cast<long double>(colatitudes[j]));
    first_[at] = 1 / std::sqrt(4 * std::numbers::pi_v<long double>);
  }
  set_coefficients();
}

void LegendreFunctions::next() {
  ++m_;
  for (std::size_t j = 0; j < first_.size(); ++j) {
    int by = 0;
    first_[j] = std::frexp(-first_[j] * sine_[j] * std::sqrt((2 * m_ + 1.0L) / (2.0L * m_)), &by);
    exponent_[j] += by;
  }
  set_coefficients();
}

int LegendreFunctions::block(int first, Block& u) const {
  int const size = degrees_ - m_;
  if (u.rows() < size) u.resize(size, lanes);
  Lanes t, p, small;
  for (int i = 0; i < lanes; ++i) {
    auto const at = std::min<std::size_t>(first + i, first_.size() - 1);
    int const times = exponent_[at] < 0 ? -exponent_[at] / binary : 0;
    t[i] = t_[static_cast<Eigen::Index>(at)], small[i] = times;
    p[i] = static_cast<double>(std::ldexp(first_[at], exponent_[at] + binary * times));
  }
  Lanes d = p;
  int r = 0, from = 0;
  // As long as a lane is small, only the others are written.
  for (; r < size && (small > 0).any(); ++r) {
    u.row(r) = (small > 0).select(Lanes::Zero(), p);
    if ((small > 0).all()) from = r + 1;
    advance(r, t, p, d);
    if (r % 4 == 3) lift(p, d, small);
  }
  for (; r < size; ++r) {
    u.row(r) = p;
    advance(r, t, p, d);
  }
  return from;
}

void LegendreFunctions::set_coefficients() {
  auto const size = static_cast<std::size_t>(std::max(0, degrees_ - m_));
  rho_.resize(size), alpha_.resize(size), beta_.resize(size);
  for (std::size_t r = 0; r < size; ++r) {
    double const l = m_ + static_cast<double>(r), above = static_cast<double>(r) + 1;
    rho_[r] = std::sqrt((2 * l + 3) * above / ((2 * l + 1) * (l + m_ + 1)));
    alpha_[r] = rho_[r] * (l + m_) / above, beta_[r] = rho_[r] * (2 * l + 1) / above;
  }
}

}  // namespace actio::sphere
