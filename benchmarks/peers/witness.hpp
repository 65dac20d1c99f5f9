// The independent reference solution: the free body by power series of the time, in 50 digits.
//
// The coefficients follow one another by the products of series in Euler's equations. Steps are such that
// what is cut off is below 1e-24.
#pragma once

#include <Eigen/Core>

#include <vector>

#include "actio/numbers/multiprecision.hpp"
#include "peers/stepper.hpp"
#include "witness/taylor_reference.hpp"

namespace peers {

using Exact = std::array<actio::dec50, 7>;

/// Momentum and attitude at so many times, equally far apart, on the way to the last.
template <std::size_t count>
std::array<Exact, count> witness(Task const& task, double time) {
  using actio::dec50;
  constexpr int terms = 30;
  std::array<dec50, 3> J;
  for (int i = 0; i < 3; ++i) J[i] = 1 / dec50(task.I[i]);
  std::array<dec50, 3> const across{J[2] - J[1], J[0] - J[2], J[1] - J[0]};
  std::array<std::vector<dec50>, 7> y;
  for (int i = 0; i < 7; ++i) y[i].assign(terms + 1, dec50(task.start()[i]));

  std::array<Exact, count> out;
  std::size_t look = 0;
  for (dec50 reached = 0; look < count;) {
    dec50 const end = dec50(time) * (look + 1) / count;
    double largest = 0;
    std::array<std::vector<dec50>, 3> w;
    for (int k = 0; k < terms; ++k) {
      for (int i = 0; i < 3; ++i) w[i].push_back(y[i][k] * J[i] / 2);
      auto const product = [k](std::vector<dec50> const& a, std::vector<dec50> const& b) {
        dec50 sum = 0;
        for (int l = 0; l <= k; ++l) sum += a[l] * b[k - l];
        return sum;
      };
      auto const& [M0, M1, M2, e, a, b, c] = y;
      Exact const rate{across[0] * product(M1, M2),
                       across[1] * product(M2, M0),
                       across[2] * product(M0, M1),
                       -(product(a, w[0]) + product(b, w[1]) + product(c, w[2])),
                       product(e, w[0]) + product(b, w[2]) - product(c, w[1]),
                       product(e, w[1]) + product(c, w[0]) - product(a, w[2]),
                       product(e, w[2]) + product(a, w[1]) - product(b, w[0])};
      for (int i = 0; i < 7; ++i) y[i][k + 1] = rate[i] / (k + 1);
    }
    for (int i = 0; i < 7; ++i)
      largest = std::max({largest, std::abs(static_cast<double>(y[i][terms])),
                          std::abs(static_cast<double>(y[i][terms - 1]))});
    dec50 h(std::pow(1e-24 / largest, 1.0 / terms));
    bool const there = !(reached + h < end);
    if (there) h = end - reached;
    for (int i = 0; i < 7; ++i) {
      dec50 sum = y[i][terms];
      for (int k = terms; k-- > 0;) sum = sum * h + y[i][k];
      y[i][0] = sum;
    }
    reached = there ? end : dec50(reached + h);
    if (there) {
      for (int i = 0; i < 7; ++i) out[look][i] = y[i][0];
      ++look;
    }
  }
  return out;
}

/// The same by `taylor_reference` of the library, which is independent of this body and slower: for short
/// times, to see that both agree.
inline Exact witness_by_library(Task const& task, double time) {
  using actio::dec50;
  Eigen::Matrix<dec50, 7, 1> y;
  std::array<dec50, 3> J;
  for (int i = 0; i < 7; ++i) y[i] = task.start()[i];
  for (int i = 0; i < 3; ++i) J[i] = 1 / dec50(task.I[i]);
  y = actio::taylor_reference<dec50, 7>(
      [J](auto const& s) {
        using T = typename std::decay_t<decltype(s)>::Scalar;
        T const a = s[0] * T(J[0]), b = s[1] * T(J[1]), c = s[2] * T(J[2]), half = T(dec50(1) / 2);
        return Eigen::Matrix<T, 7, 1>{s[1] * c - s[2] * b,
                                      s[2] * a - s[0] * c,
                                      s[0] * b - s[1] * a,
                                      -half * (s[4] * a + s[5] * b + s[6] * c),
                                      half * (s[3] * a + s[5] * c - s[6] * b),
                                      half * (s[3] * b + s[6] * a - s[4] * c),
                                      half * (s[3] * c + s[4] * b - s[5] * a)};
      },
      y, dec50(time));
  Exact out;
  for (int i = 0; i < 7; ++i) out[i] = y[i];
  return out;
}
inline double difference(Exact const& a, Exact const& b) {
  double largest = 0;
  for (int i = 0; i < 7; ++i) largest = std::max(largest, std::abs(static_cast<double>(a[i] - b[i])));
  return largest;
}

/// Largest error of a component of momentum or attitude; a quaternion and its opposite are the same attitude.
inline double error_of(Seven const& y, Exact const& exact) {
  double momentum = 0, same = 0, opposite = 0;
  for (int i = 0; i < 3; ++i) momentum = std::max(momentum, std::abs(static_cast<double>(y[i] - exact[i])));
  for (int i = 3; i < 7; ++i) {
    same = std::max(same, std::abs(static_cast<double>(y[i] - exact[i])));
    opposite = std::max(opposite, std::abs(static_cast<double>(y[i] + exact[i])));
  }
  // A state that is no number has no error that could be compared.
  for (double const v : y)
    if (!std::isfinite(v)) return std::numeric_limits<double>::infinity();
  return std::max(momentum, std::min(same, opposite));
}

}  // namespace peers
