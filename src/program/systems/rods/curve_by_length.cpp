#include "program/systems/rods/curve_by_length.hpp"

#include <algorithm>
#include <cmath>

namespace actio::scene {

CurveByLength::CurveByLength(RodFormulas const& curve, int elements) : curve_(curve) {
  int const parts = std::max(256, 4 * elements);
  until_.push_back(0);
  for (int k = 0; k < parts; ++k)
    until_.push_back(until_.back() +
                     between(static_cast<double>(k) / parts, static_cast<double>(k + 1) / parts));
}

double CurveByLength::at(double part) const {
  double const wanted = part * length();
  auto const above = std::ranges::upper_bound(until_, wanted);
  double const parts = static_cast<double>(until_.size() - 1);
  if (above == until_.end()) return 1;
  auto const k = static_cast<std::size_t>(above - until_.begin() - 1);
  double const from = static_cast<double>(k) / parts;
  double s = from + (wanted - until_[k]) / (until_[k + 1] - until_[k]) / parts;
  for (int round = 0; round < 4; ++round) s -= (until_[k] + between(from, s) - wanted) / speed(s);
  return s;
}

double CurveByLength::speed(double s) const {
  auto const v = curve_.slope(s);
  return std::hypot(v[0], v[1], v[2]);
}

/// By the rule of Gauss with five points.
double CurveByLength::between(double a, double b) const {
  static constexpr double at[] = {0, 0.538469310105683091, 0.906179845938663993},
                          weight[] = {0.568888888888888889, 0.478628670499366468, 0.236926885056189088};
  double const middle = (a + b) / 2, half = (b - a) / 2;
  double sum = weight[0] * speed(middle);
  for (int k = 1; k < 3; ++k)
    sum += weight[k] * (speed(middle - half * at[k]) + speed(middle + half * at[k]));
  return half * sum;
}

}  // namespace actio::scene
