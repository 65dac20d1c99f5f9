// Coefficients of a flow on the torus in a file.
#include <Eigen/Core>

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>

#include "program/base/byte_order_mark.hpp"
#include "program/base/number_table.hpp"
#include "program/systems/torus/input.hpp"

namespace actio::scene {
namespace {

/// Four numbers with commas between them.
bool parse_coefficient(std::string_view line, double (&row)[4]) {
  for (int k = 0; k < 4; ++k) {
    auto const [end, error] = std::from_chars(line.data(), line.data() + line.size(), row[k]);
    if (error != std::errc() || !std::isfinite(row[k])) return false;
    line.remove_prefix(static_cast<std::size_t>(end - line.data()));
    if (k == 3) return line.empty();
    if (line.empty() || line.front() != ',') return false;
    line.remove_prefix(1);
  }
  return false;
}

}  // namespace

std::string table_of_torus_harmonics(torus::TorusHarmonics const& f) {
  NumberTable table("m,n,re,im");
  for (int n = 0; n <= f.largest(); ++n)
    for (int m = n == 0 ? 1 : -f.largest(); m <= f.largest(); ++m) {
      table.add(m), table.add(n), table.add(f(m, n).real()), table.add(f(m, n).imag());
      table.end_row();
    }
  return table.text();
}

torus::TorusHarmonics read_torus_harmonics(std::string const& text, std::string const& path, int n) {
  std::istringstream in(text);
  skip_byte_order_mark(in);
  torus::TorusHarmonics f(n);
  Eigen::MatrixXi lines = Eigen::MatrixXi::Zero(f.largest() + 1, n);
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    if (!line.empty() && line.back() == '\r') line.pop_back();
    Place const here{path, static_cast<unsigned>(number), 1};
    if (number == 1) {
      if (line != "m,n,re,im")
        throw SceneError(here, fmt::format("the heading m,n,re,im is expected, found '{}'", shown(line, 40)));
      continue;
    }
    if (line.empty() && in.peek() == std::istringstream::traits_type::eof()) break;
    double row[4];
    if (!parse_coefficient(line, row))
      throw SceneError(here, fmt::format("four numbers m,n,re,im are expected, found '{}'", shown(line, 60)));
    if (row[0] != std::round(row[0]) || row[1] != std::round(row[1]))
      throw SceneError(here, fmt::format("wave numbers are whole, found m = {}, n = {}", row[0], row[1]));
    if (!(std::abs(row[0]) <= f.largest() && std::abs(row[1]) <= f.largest()))
      throw SceneError(here,
                       fmt::format("the wave numbers m = {}, n = {} are outside of what matrices of this "
                                   "size hold: with N = {} they go from {} to {}",
                                   row[0], row[1], n, -f.largest(), f.largest()));
    int const m = static_cast<int>(row[0]), k = static_cast<int>(row[1]);
    if (k < 0 || (k == 0 && m <= 0))
      throw SceneError(here,
                       fmt::format("rows have n > 0, or n = 0 and m > 0, since a real field has at -m, -n "
                                   "the conjugate of the coefficient at m, n, and its mean is zero; "
                                   "found m = {}, n = {}",
                                   m, k));
    int& seen = lines(k, m + f.largest());
    if (seen != 0)
      throw SceneError(here,
                       fmt::format("the row of m = {}, n = {} is there twice, first as line {}", m, k, seen));
    seen = number;
    f.set(m, k, {row[2], row[3]});
  }
  if (number == 0) throw SceneError({path}, "the heading m,n,re,im is expected, the file is empty");
  return f;
}

torus::TorusHarmonics read_torus_harmonics_file(std::string const& path, int n) {
  std::ifstream in(path, std::ios::binary);
  std::string const text{std::istreambuf_iterator<char>(in), {}};
  if (!in.is_open() || in.bad()) throw FileError(path + ": cannot be read");
  return read_torus_harmonics(text, path, n);
}

}  // namespace actio::scene
