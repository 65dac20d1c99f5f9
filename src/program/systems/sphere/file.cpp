// Coefficients from a file.
#include <Eigen/Core>

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>

#include "program/base/byte_order_mark.hpp"
#include "program/systems/sphere/input.hpp"

namespace actio::scene {
namespace {

/// Four numbers with commas between them.
bool parse_row(std::string_view line, double (&row)[4]) {
  for (int k = 0; k < 4; ++k) {
    while (!line.empty() && line.front() == ' ') line.remove_prefix(1);
    auto const [end, error] = std::from_chars(line.data(), line.data() + line.size(), row[k]);
    if (error != std::errc() || !std::isfinite(row[k])) return false;
    line.remove_prefix(static_cast<std::size_t>(end - line.data()));
    while (!line.empty() && line.front() == ' ') line.remove_prefix(1);
    if (k == 3) return line.empty();
    if (line.empty() || line.front() != ',') return false;
    line.remove_prefix(1);
  }
  return false;
}

}  // namespace

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
  std::ifstream in(path, std::ios::binary);
  std::string const text{std::istreambuf_iterator<char>(in), {}};
  if (!in.is_open() || in.bad()) throw FileError(path + ": cannot be read");
  return read_harmonics(text, path, n);
}

sphere::SphereHarmonics read_harmonics(std::string const& text, std::string const& path, int n) {
  std::istringstream in(text);
  skip_byte_order_mark(in);
  sphere::SphereHarmonics f(n);
  Eigen::MatrixXi lines = Eigen::MatrixXi::Zero(n, n);
  int number = 0, last = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    if (!line.empty() && line.back() == '\r') line.pop_back();
    Place const here{path, static_cast<unsigned>(number), 1};
    if (number == 1) {
      if (line != "l,m,re,im")
        throw SceneError(here, fmt::format("the heading l,m,re,im is expected, found '{}'", shown(line, 40)));
      continue;
    }
    if (line.empty() && in.peek() == std::istringstream::traits_type::eof()) break;
    double row[4];
    if (!parse_row(line, row))
      throw SceneError(here, fmt::format("four numbers l,m,re,im are expected, found '{}'", shown(line, 60)));
    // What a snapshot holds of the mean is zero.
    if (row[0] == 0 && row[1] == 0 && row[2] == 0 && row[3] == 0) continue;
    std::string const wrong = put_coefficient(f, lines, number, row[0], row[1], row[2], row[3]);
    if (!wrong.empty()) throw SceneError(here, wrong);
    last = std::max(last, static_cast<int>(row[0]));
  }
  if (number == 0) throw SceneError({path}, "the heading l,m,re,im is expected, the file is empty");
  for (int l = 1; l <= last; ++l)
    for (int m = 0; m <= l; ++m)
      if (lines(l, m) == 0)
        throw SceneError(
            {path, static_cast<unsigned>(number), 1},
            fmt::format("the row of l = {}, m = {} is missing; the file goes to the degree {}, and holds "
                        "every order of every degree up to it",
                        l, m, last));
  return f;
}

}  // namespace actio::scene
