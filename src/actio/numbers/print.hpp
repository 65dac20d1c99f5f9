// Values on the terminal, for a reader who tries a line: numbers, vectors, matrices, elements of a group,
// velocities and momenta.
#pragma once

#include <cmath>
#include <cstdio>
#include <iostream>
#include <string>
#include <type_traits>

namespace actio {

namespace detail {
/// A number in six significant digits; rounding about zero keeps its size, so that a residual can be judged.
template <class T>
std::string printed_number(T const& x) {
  char text[40];
  double const value = static_cast<double>(x);
  std::snprintf(text, sizeof text, "%.6g", value == 0 ? 0.0 : value);
  return text;
}
/// A vector in one line, a matrix in a line for each row.
template <class M>
std::string printed_matrix(M const& a) {
  bool const column = a.cols() == 1;
  std::string out;
  for (int i = 0; i < static_cast<int>(a.rows()); ++i) {
    for (int j = 0; j < static_cast<int>(a.cols()); ++j) out += (j > 0 ? "  " : "") + printed_number(a(i, j));
    if (i + 1 < static_cast<int>(a.rows())) out += column ? "  " : "\n  ";
  }
  return column || a.rows() == 1 ? out : "\n  " + out;
}
/// Anything that `print` takes.
template <class T>
std::string printed(T const& x) {
  if constexpr (std::is_same_v<T, bool>)
    return x ? "yes" : "no";
  else if constexpr (std::is_convertible_v<T const&, std::string>)
    return x;
  else if constexpr (requires { x.coordinates; })
    return printed_matrix(x.coordinates);
  else if constexpr (requires { x.components; })
    return printed_matrix(x.components);
  else if constexpr (requires {
                       x.group;
                       x.value;
                     })
    return printed_matrix(x.value);
  else if constexpr (requires {
                       x.rows();
                       x.cols();
                     })
    return printed_matrix(x);
  else
    return printed_number(x);
}
}  // namespace detail

/// Prints a value in a line: a number, a vector, a text, an \ref Element, a \ref Velocity or a \ref Momentum
/// by its coordinates; a matrix in a line for each row. Numbers are shown in six significant digits.
template <class T>
void print(T const& value) { std::cout << detail::printed(value) << '\n'; }
/// The same with what it is before it.
template <class T>
void print(char const* label, T const& value) {
  std::cout << label << ": " << detail::printed(value) << '\n';
}

}  // namespace actio
