// An axis of a plot: its range, its ticks, and where on it a value lies.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "book/program.hpp"

namespace book {

/// One axis: its range, and where in it a value lies, from 0 to 1.
struct Axis {
  std::string label;                                       ///< what it measures, with its unit
  double low = std::numeric_limits<double>::infinity();    ///< where it begins
  double high = -std::numeric_limits<double>::infinity();  ///< where it ends
  bool log = false;                                        ///< whether it is logarithmic
  bool fixed = false;                                      ///< whether its range was given

  /// Whether a value has a place on it.
  bool takes(double value) const { return std::isfinite(value) && (!log || value > 0); }
  /// Widens the range, unless it was given, to hold a value.
  void include(double value) {
    if (!fixed) low = std::min(low, value), high = std::max(high, value);
  }
  /// Leaves room at the ends, and gives a single value, or none, a range around it.
  void close() {
    if (!(low <= high)) low = high = log ? 1 : 0;
    if (fixed) return;
    double const from = scaled(low), to = scaled(high);
    double const smallest = log ? 0.02 : 1e-12 * std::max(std::abs(low), std::abs(high));
    double const room = to - from > smallest ? 0.03 * (to - from)
                        : log                ? 0.5
                                             : std::max(std::abs(low), 1.0) / 2;
    low = unscaled(from - room), high = unscaled(to + room);
  }
  /// A value as its length along the axis is counted, and back.
  double scaled(double value) const { return log ? std::log10(value) : value; }
  /// The inverse of `scaled`.
  double unscaled(double value) const { return log ? std::pow(10.0, value) : value; }
  /// From 0 at the beginning to 1 at the end; not a number where the value has no place.
  double position(double value) const {
    return takes(value) ? (scaled(value) - scaled(low)) / (scaled(high) - scaled(low))
                        : std::numeric_limits<double>::quiet_NaN();
  }

  /// Distance between ticks: 1, 2 or 5 times a power of ten, whole decades on a logarithmic axis; about six
  /// in all.
  double spacing() const {
    double const raw = (scaled(high) - scaled(low)) / 6;
    double const power = std::pow(10.0, std::floor(std::log10(raw)));
    double const nice = raw / power < 1.5 ? 1 : raw / power < 3.5 ? 2 : raw / power < 7.5 ? 5 : 10;
    return log ? std::max(1.0, std::round(raw)) : nice * power;
  }
  /// The values that are marked.
  std::vector<double> ticks() const {
    std::vector<double> out;
    double const step = spacing(), from = scaled(low), to = scaled(high);
    bool const narrow = log && to - from < 1.6;
    if (narrow) {
      for (int decade = static_cast<int>(std::floor(from)); decade <= to; ++decade)
        for (int digit = 1; digit < 10; ++digit) {
          double const value = digit * std::pow(10.0, decade);
          bool const shown = to - from < 0.8 || digit == 1 || digit == 2 || digit == 5;
          if (shown && value >= low && value <= high) out.push_back(value);
        }
      return out;
    }
    for (double k = std::ceil(from / step - 1e-9); k * step <= to + 1e-9 * step; ++k)
      out.push_back(unscaled(k * step));
    return out;
  }
  /// A tick for a reader: 0.25, −3, 10⁻¹², 2·10⁻⁸.
  std::string tick_label(double value) const {
    if (!log && std::abs(value) < 1e-9 * spacing()) return "0";
    int const exponent = static_cast<int>(std::floor(std::log10(std::abs(value)) + 1e-9));
    bool const decades = log && scaled(high) - scaled(low) > 4;
    double const largest = std::max(std::abs(low), std::abs(high));
    bool const plain = decades ? std::abs(exponent) < 2
                       : log   ? std::abs(exponent) < 4
                               : largest >= 1e-3 && largest < 1e5;
    std::string const shown = number(plain ? value : value / std::pow(10.0, exponent), 6);
    std::string out = shown[0] == '-' ? "−" + shown.substr(1) : shown;
    return plain ? out : (out == "1" ? "" : out == "−1" ? "−" : out + "·") + power_of_ten(exponent);
  }
  /// 10⁻¹².
  static std::string power_of_ten(int exponent) {
    static constexpr char const* raised[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string out = exponent < 0 ? "10⁻" : "10";
    for (char const digit : std::to_string(std::abs(exponent))) out += raised[digit - '0'];
    return out;
  }
};

}  // namespace book
