// What programs measure: how long something takes, and with which power an error falls or grows.
#pragma once

#include <chrono>
#include <cmath>
#include <vector>

namespace book {

/// Seconds by the clock that `work` takes.
template <class Work>
double seconds_of(Work const& work) {
  auto const start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// The exponent a of y ~ x^a: slope of the least squares line through the logarithms. The order of a method,
/// from steps and errors.
inline double exponent(std::vector<double> const& x, std::vector<double> const& y) {
  double const n = static_cast<double>(x.size());
  double su = 0, sv = 0, suu = 0, suv = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    double const u = std::log(x[i]), v = std::log(y[i]);
    su += u, sv += v, suu += u * u, suv += u * v;
  }
  return (n * suv - su * sv) / (n * suu - su * su);
}

}  // namespace book
