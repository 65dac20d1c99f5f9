// Coefficients from a file.
#include <Eigen/Core>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "program/systems/sphere/flow_input.hpp"
#include "program/systems/sphere/input.hpp"

namespace actio::scene {
std::string put_coefficient(sphere::SphereHarmonics& f, Eigen::MatrixXi& lines, int line, double l, double m,
                            double re, double im) {
  int const n = f.degrees();
  if (l != std::round(l) || m != std::round(m))
    return fmt::format("degree and order are whole numbers, found l = {}, m = {}", l, m);
  if (l < 0 || l >= n)
    return fmt::format(
        "the degree l = {} is outside of what matrices of this size hold: with "
        "N = {} degrees go from 1 to {}",
        l, n, n - 1);
  if (m < 0)
    return fmt::format(
        "the order m = {} is negative; rows have m >= 0, since a real field has at -m the conjugate of the "
        "coefficient at m, times (-1)^m",
        m);
  if (m > l) return fmt::format("the order m = {} is greater than the degree l = {}", m, l);
  if (l == 0)
    return fmt::format("the degree 0 is the mean of the vorticity, which is zero on a sphere; found {}", re);
  if (m == 0 && im != 0)
    return fmt::format(
        "a coefficient of order 0 is real, or the field would be complex; found "
        "the imaginary part {} at l = {}",
        im, l);
  auto const i = static_cast<Eigen::Index>(l), j = static_cast<Eigen::Index>(m);
  if (lines(i, j) != 0)
    return fmt::format("the row of l = {}, m = {} is there twice, first as {} {}", l, m,
                       line < 0 ? "row" : "line", std::abs(lines(i, j)));
  lines(i, j) = line;
  f(static_cast<int>(l), static_cast<int>(m)) = {re, im};
  return "";
}

sphere::SphereHarmonics read_harmonics_file(std::string const& path, int n) {
  return read_harmonics(text_of_file(path), path, n);
}

sphere::SphereHarmonics read_harmonics(std::string const& text, std::string const& path, int n) {
  sphere::SphereHarmonics f(n);
  Eigen::MatrixXi lines = Eigen::MatrixXi::Zero(n, n);
  int last = 0;
  int const count = read_coefficients(text, path, "l,m,re,im", [&](auto const& row, int line) -> std::string {
    // What a snapshot holds of the mean is zero.
    if (row[0] == 0 && row[1] == 0 && row[2] == 0 && row[3] == 0) return "";
    std::string const wrong = put_coefficient(f, lines, line, row[0], row[1], row[2], row[3]);
    if (wrong.empty()) last = std::max(last, static_cast<int>(row[0]));
    return wrong;
  });
  for (int l = 1; l <= last; ++l)
    for (int m = 0; m <= l; ++m)
      if (lines(l, m) == 0)
        throw SceneError(
            {path, static_cast<unsigned>(count), 1},
            fmt::format("the row of l = {}, m = {} is missing; the file goes to the degree {}, and holds "
                        "every order of every degree up to it",
                        l, m, last));
  return f;
}

}  // namespace actio::scene
