// Coefficients of a flow on the torus in a file.
#include <Eigen/Core>

#include <fmt/format.h>

#include <cmath>

#include "program/base/number_table.hpp"
#include "program/systems/sphere/flow_input.hpp"
#include "program/systems/torus/input.hpp"

namespace actio::scene {
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
  torus::TorusHarmonics f(n);
  Eigen::MatrixXi lines = Eigen::MatrixXi::Zero(f.largest() + 1, n);
  read_coefficients(text, path, "m,n,re,im", [&](auto const& row, int line) -> std::string {
    if (row[0] != std::round(row[0]) || row[1] != std::round(row[1]))
      return fmt::format("wave numbers are whole, found m = {}, n = {}", row[0], row[1]);
    if (!(std::abs(row[0]) <= f.largest() && std::abs(row[1]) <= f.largest()))
      return fmt::format(
          "the wave numbers m = {}, n = {} are outside of what matrices of this size hold: with N = {} they "
          "go from {} to {}",
          row[0], row[1], n, -f.largest(), f.largest());
    int const m = static_cast<int>(row[0]), k = static_cast<int>(row[1]);
    if (k < 0 || (k == 0 && m <= 0))
      return fmt::format(
          "rows have n > 0, or n = 0 and m > 0, since a real field has at -m, -n the conjugate of the "
          "coefficient at m, n, and its mean is zero; found m = {}, n = {}",
          m, k);
    int& seen = lines(k, m + f.largest());
    if (seen != 0)
      return fmt::format("the row of m = {}, n = {} is there twice, first as line {}", m, k, seen);
    seen = line;
    f.set(m, k, {row[2], row[3]});
    return "";
  });
  return f;
}

torus::TorusHarmonics read_torus_harmonics_file(std::string const& path, int n) {
  return read_torus_harmonics(text_of_file(path), path, n);
}

}  // namespace actio::scene
