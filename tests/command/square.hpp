// Square matrices as rows of numbers: enough of them to hold a table to its equations.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "command.hpp"

namespace command {

using Numbers = std::vector<double>;
/// Row by row.
using Square = std::vector<Numbers>;

inline std::string index(int i, int j) {
  return "_" + std::to_string(i) + (std::max(i, j) > 9 ? "_" : "") + std::to_string(j);
}
/// One row of a skew quantity, in full.
inline Square skew(Table const& table, std::string const& name, int n, std::size_t row) {
  Square m(n, Numbers(n, 0));
  for (int i = 1; i <= n; ++i)
    for (int j = i + 1; j <= n; ++j)
      m[i - 1][j - 1] = table[name + index(i, j)][row], m[j - 1][i - 1] = -m[i - 1][j - 1];
  return m;
}
inline Square matrix(Table const& table, std::string const& name, int n, std::size_t row) {
  Square m(n, Numbers(n, 0));
  for (int i = 1; i <= n; ++i)
    for (int j = 1; j <= n; ++j) m[i - 1][j - 1] = table[name + index(i, j)][row];
  return m;
}

inline Square times(Square const& a, Square const& b) {
  Square c(a.size(), Numbers(a.size(), 0));
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t k = 0; k < a.size(); ++k)
      for (std::size_t j = 0; j < a.size(); ++j) c[i][j] += a[i][k] * b[k][j];
  return c;
}
inline Square transposed(Square a) {
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) std::swap(a[i][j], a[j][i]);
  return a;
}
inline double trace(Square const& a) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i][i];
  return sum;
}
inline double norm(Square const& a) { return std::sqrt(trace(times(a, transposed(a)))); }
inline Square plus(Square a, double factor, Square const& b) {
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < a.size(); ++j) a[i][j] += factor * b[i][j];
  return a;
}
inline double difference(Square const& a, Square const& b) { return norm(plus(a, -1, b)); }
inline Square unit(int n) {
  Square one(n, Numbers(n, 0));
  for (int i = 0; i < n; ++i) one[i][i] = 1;
  return one;
}

}  // namespace command
