// Points of bodies and of space, in words, and how far they are from each other.
#pragma once

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>

namespace actio::scene {

/// A point of a body, of space, or a vector.
template <int d>
using PointOfBody = std::array<double, d>;

/// `(0.5, -1)`.
template <std::size_t d>
std::string in_words(std::array<double, d> const& x) {
  std::string out;
  for (double const one : x)
    out += fmt::format("{}{:.9g}", out.empty() ? "(" : ", ", std::isnan(one) ? std::abs(one) : one);
  return out + ")";
}
/// How far two points are from each other, length.
template <std::size_t d>
double distance(std::array<double, d> const& a, std::array<double, d> const& b) {
  double square = 0;
  for (std::size_t k = 0; k < d; ++k) square += (a[k] - b[k]) * (a[k] - b[k]);
  return std::sqrt(square);
}
/// The length of a vector.
template <std::size_t d>
double size_of(std::array<double, d> const& a) { return distance(a, {}); }

}  // namespace actio::scene
