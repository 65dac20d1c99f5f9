// The functions of formulas, and the same in C++.
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace actio::testing {

/// A function of one variable, and where it is finite.
struct NamedFunction {
  std::string name;
  std::function<double(double)> function;
  double least, most;
};

/// The smooth ones: the formula of a Lagrangian may have them, and those of a scene.
inline std::vector<NamedFunction> functions_of_cpp() {
  return {
      {"sin", [](double x) { return std::sin(x); }, -9, 9},
      {"cos", [](double x) { return std::cos(x); }, -9, 9},
      {"tan", [](double x) { return std::tan(x); }, -1.5, 1.5},
      {"asin", [](double x) { return std::asin(x); }, -1, 1},
      {"acos", [](double x) { return std::acos(x); }, -1, 1},
      {"atan", [](double x) { return std::atan(x); }, -9, 9},
      {"sinh", [](double x) { return std::sinh(x); }, -9, 9},
      {"cosh", [](double x) { return std::cosh(x); }, -9, 9},
      {"tanh", [](double x) { return std::tanh(x); }, -9, 9},
      {"asinh", [](double x) { return std::asinh(x); }, -9, 9},
      {"acosh", [](double x) { return std::acosh(x); }, 1, 9},
      {"atanh", [](double x) { return std::atanh(x); }, -0.9, 0.9},
      {"exp", [](double x) { return std::exp(x); }, -9, 9},
      {"log", [](double x) { return std::log(x); }, 0.1, 9},
      {"log2", [](double x) { return std::log2(x); }, 0.1, 9},
      {"log10", [](double x) { return std::log10(x); }, 0.1, 9},
      {"sqrt", [](double x) { return std::sqrt(x); }, 0, 9},
      {"cbrt", [](double x) { return std::cbrt(x); }, -9, 9},
  };
}

}  // namespace actio::testing
