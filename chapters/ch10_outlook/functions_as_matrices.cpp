// Functions on the sphere as matrices, the smallest ones written out in full.
//
// What is shown. The coordinates and the harmonics as matrices of two and of three rows; one flow as a
// matrix, with its stream function, its rate and what it conserves; which part of a function stands on which
// diagonal; and how the bracket of matrices of a few rows differs from that of functions. Read first. Section
// 10A.1.
//
//   S_j  spin matrices        T_lm  matrix of the harmonic Y_lm        W, P  vorticity and stream function
#include <Eigen/Core>

#include "actio/quantized_sphere/laplacian.hpp"
#include "actio/quantized_sphere/sphere_invariants.hpp"
#include "actio/sphere_fields/sphere_transform.hpp"
#include "book/program.hpp"
#include "sphere_disc.hpp"

using namespace actio;
using namespace actio::sphere;
using book::measured, book::number;
using Number = std::complex<double>;

// 1. Numbers of small matrices as they are written: a root of a fraction, where it is one.
std::string root(double x) {
  if (std::abs(x) < 1e-14) return "0";
  std::string const sign = x < 0 ? "-" : "";
  for (long q = 1; q <= 64; ++q) {
    double const p = x * x * static_cast<double>(q);
    long const whole = std::lround(p);
    if (std::abs(p - static_cast<double>(whole)) > 1e-12 * p) continue;
    auto const plain = [](long n) {
      auto const r = std::lround(std::sqrt(static_cast<double>(n)));
      return r * r == n ? std::to_string(r) : "\\sqrt{" + std::to_string(n) + "}";
    };
    if (q == 1) return sign + plain(whole);
    return sign + "\\tfrac{" + plain(whole) + "}{" + plain(q) + "}";
  }
  return number(x, 4);
}
std::string entry(Number z) {
  if (std::abs(z.imag()) < 1e-14) return root(z.real());
  std::string const size = root(std::abs(z.imag()));
  std::string const imaginary = (z.imag() < 0 ? "-" : "") + (size == "1" ? "" : size) + "i";
  if (std::abs(z.real()) < 1e-14) return imaginary;
  return root(z.real()) + (z.imag() < 0 ? "" : "+") + imaginary;
}
// A matrix, as the formula between dollars that a page sets.
std::string written(ComplexMatrix<> const& a) {
  std::string out = "\\begin{pmatrix}";
  for (Eigen::Index i = 0; i < a.rows(); ++i)
    for (Eigen::Index j = 0; j < a.cols(); ++j)
      out += entry(a(i, j)) + (j + 1 < a.cols() ? "&" : i + 1 < a.rows() ? "\\\\" : "");
  return out + "\\end{pmatrix}";
}
std::string formula(std::string const& text) { return "$" + text + "$"; }

// 2. The matrix of a harmonic, T_lm for m >= 0: half of what the real function Re Y_lm and half of what
//    Im Y_lm become, put together.
ComplexMatrix<> harmonic(int n, int l, int m) {
  SphereHarmonics f(n);
  f(l, m) = 1;  // the function Y_lm + its conjugate, or Y_l0
  ComplexMatrix<> const even = matrix_of(f).hermitian();
  if (m == 0) return even;
  f(l, m) = Number(0, 1);
  ComplexMatrix<> const odd = matrix_of(f).hermitian();
  return (even - Number(0, 1) * odd) / 2.0;
}
double normalised(int n) { return std::sqrt(QuantizedSphere(n).area_element()); }

// 3. The coordinates and the harmonics for N = 2 and N = 3.
void show_small(book::Program& program) {
  std::vector<book::Program::Row> coordinates, harmonics;
  for (int axis : {0, 1, 2}) {
    book::Program::Row row{formula("x_" + std::to_string(axis + 1))};
    for (int n : {2, 3})
      row.push_back(formula(written(QuantizedSphere(n).hbar() * QuantizedSphere(n).spin(axis))));
    coordinates.push_back(row);
  }
  program.table("coordinates", {"function", "$N=2$", "$N=3$"}, coordinates,
                "The coordinates of the sphere as matrices of two and of three rows.");
  for (int l : {1, 2})
    for (int m = 0; m <= l; ++m) {
      book::Program::Row row{formula("Y_{" + std::to_string(l) + std::to_string(m) + "}")};
      for (int n : {2, 3})
        row.push_back(l < n ? formula(written(normalised(n) * harmonic(n, l, m))) : "none");
      harmonics.push_back(row);
    }
  program.table("harmonics", {"function", "$N=2$", "$N=3$"}, harmonics,
                "Spherical harmonics as matrices, $\\sqrt{4\\pi/N}\\;T_{lm}$: each has the norm 1, as the "
                "harmonic has. Those of $-m$ are the adjoints, times $(-1)^m$.");
}

// 4. A flow on three rows: a rotation about the pole, and an oval of degree 2 that it turns.
SphereHarmonics flow_on_three() {
  SphereHarmonics f(3);
  double const unit = std::sqrt(4 * M_PI / 3);  // so that the matrices have small entries
  f(1, 0) = 2 * unit / std::sqrt(2.0), f(2, 2) = unit;
  return f;
}
double show_flow(book::Program& program) {
  QuantizedSphere const sphere(3);
  SphereLaplacian const laplacian(3);
  SkewHermitian<> const w = matrix_of(flow_on_three()), p = laplacian.solve(w);
  SkewHermitian<> const moves = commutator(p, w);
  std::vector<book::Program::Row> rows;
  auto const line = [&](std::string const& name, std::string const& value) {
    rows.push_back({formula(name), formula(value)});
  };
  line("-iW", written(w.hermitian()));
  line("-iP", written(p.hermitian()));
  line("[P,W]", written(moves.complex()));
  auto const values = vorticity_values(w);
  line("\\text{spectrum of }-iW", root(values[0]) + ",\\;" + root(values[1]) + ",\\;" + root(values[2]));
  program.table(
      "flow", {"matrix", "its entries"}, rows,
      "One flow on the smallest sphere on which anything moves: vorticity, stream function, $\\hbar$ "
      "times the rate of change of the vorticity, and the three values of the vorticity.");
  // The part of degree 1 is a.x; the rest turns about a at the rate |a|/3.
  double const a = std::sqrt(3 / (4 * M_PI)) * flow_on_three()(1, 0).real();
  SphereHarmonics rest = flow_on_three();
  rest(1, 0) = 0;
  SkewHermitian<> const v = matrix_of(rest);
  TurningFrame const pole{};
  SkewHermitian<> const turned = (-a / 3 * sphere.hbar()) * pole.turn(sphere, v);
  return norm(moves - turned) / norm(moves);
}

// 5. The bracket {x_1 x_3, x_2 x_3} = x_3/5 + 4/5 P_3(x_3): its two parts, as the matrices have them.
struct Parts {
  double first, third;
};
Parts bracket_of(int n) {
  SphereHarmonics f(n), g(n);
  // x_1 x_3 and x_2 x_3, of degree 2 and order 1.
  double const size = std::sqrt(2 * M_PI / 15);
  f(2, 1) = -size, g(2, 1) = Number(0, size);
  auto const c = harmonics_of((1 / QuantizedSphere(n).hbar()) * commutator(matrix_of(f), matrix_of(g)));
  // [iF, iG] = i(iF G - G iF), and the bracket of functions is that of matrices over i hbar.
  return {-c(1, 0).real() / std::sqrt(4 * M_PI / 3), n > 3 ? -c(3, 0).real() / std::sqrt(4 * M_PI / 7) : 0};
}
Parts show_bracket(book::Program& program) {
  std::vector<book::Program::Row> rows;
  Parts last{};
  for (int n : {3, 4, 6, 12, 24, 48}) {
    last = bracket_of(n);
    rows.push_back({std::to_string(n), number(last.first, 5), n > 3 ? number(last.third, 5) : "none",
                    n > 3 ? number(n * n * (0.8 - last.third), 4) : ""});
  }
  program.table("bracket", {"N", "factor of $x_3$", "factor of $\\mathsf P_3(x_3)$", "$N^2$ times its error"},
                rows,
                "The bracket of the two functions on matrices. On the sphere the factors are 0.2 and 0.8.");
  return last;
}

// 6. Pictures. A matrix as coloured cells, with numbers where there is room.
std::string cells(book::svg::Point corner, double side, ComplexMatrix<> const& a, double largest,
                  bool numbers) {
  std::string out;
  double const cell = side / static_cast<double>(a.rows());
  for (Eigen::Index i = 0; i < a.rows(); ++i)
    for (Eigen::Index j = 0; j < a.cols(); ++j) {
      double const value = a(i, j).real(), x = corner.x + cell * static_cast<double>(j),
                   y = corner.y + cell * static_cast<double>(i);
      out += "<rect class=\"grid\" x=\"" + book::svg::pixel(x) + "\" y=\"" + book::svg::pixel(y) +
             "\" width=\"" + book::svg::pixel(cell) + "\" height=\"" + book::svg::pixel(cell) +
             "\" style=\"fill:" + book::colour_of(value, largest) + "\"/>\n";
      if (numbers)
        out += book::svg::label({x + cell / 2, y + cell / 2 + 4},
                                std::abs(value) < 1e-14 ? "0" : number(value, 2), "middle",
                                std::abs(value) > 0.6 * largest ? " style=\"fill:#ffffff;font-size:11px\""
                                                                : " style=\"fill:#22272d;font-size:11px\"");
    }
  return out;
}
GridField field_of(SphereGrid const& grid, SphereHarmonics const& f) { return values_on(grid, f); }

// The harmonics of three rows: each function above its matrix.
std::string dictionary() {
  SphereGrid const grid = SphereGrid::uniform(60, 120);
  std::string out;
  int column = 0;
  for (auto const& [l, m] : {std::pair{1, 0}, {1, 1}, {2, 0}, {2, 1}, {2, 2}}) {
    SphereHarmonics f(3);
    f(l, m) = m == 0 ? 1.0 : std::sqrt(0.5);
    auto const field = field_of(grid, f);
    double const x = 66 + 132.0 * column++;
    out += book::sphere_disc({x, 58}, 46, grid, field, field.cwiseAbs().maxCoeff(), {-25, 25});
    out += cells({x - 54, 142}, 108, normalised(3) * matrix_of(f).hermitian(), 1, true);
    std::string const name = "Y" + std::to_string(l) + std::to_string(m);
    out += book::svg::label({x, 128}, m == 0 ? name : "Re " + name, "middle");
  }
  return book::svg::picture(660, 258, out);
}
// One function and its parts e^{im phi}, above the matrix and its diagonals.
std::string diagonals() {
  constexpr int n = 8;
  SphereGrid const grid = SphereGrid::uniform(80, 160);
  SphereHarmonics f(n);
  f(1, 0) = 0.5, f(2, 0) = -0.6, f(4, 0) = 0.5, f(3, 1) = 0.55, f(4, 1) = -0.45, f(3, 3) = -0.5,
       f(5, 3) = 0.6;
  double const strong = field_of(grid, f).cwiseAbs().maxCoeff(),
               entry = matrix_of(f).hermitian().real().cwiseAbs().maxCoeff();
  std::string out;
  int column = 0;
  for (int m : {-1, 0, 1, 3}) {
    SphereHarmonics part = f;
    for (int order = 0; order < n; ++order)
      if (m >= 0 && order != m) part.coefficient.col(order).setZero();
    double const x = 84 + 164.0 * column++;
    out += book::sphere_disc({x, 72}, 62, grid, field_of(grid, part), strong, {-25, 25});
    out += cells({x - 62, 178}, 124, matrix_of(part).hermitian(), entry, false);
    out += book::svg::label({x, 160}, m < 0 ? "function and matrix" : "m = " + std::to_string(m), "middle");
    if (m != 3) out += book::svg::label({x + 82, 77}, m < 0 ? "=" : "+", "middle");
    if (m != 3) out += book::svg::label({x + 82, 244}, m < 0 ? "=" : "+", "middle");
  }
  return book::svg::picture(660, 310, out);
}

int main(int argc, char** argv) {
  book::Program program(argc, argv, "functions on the sphere as matrices, the smallest ones in full");
  show_small(program);
  double const turning = show_flow(program);
  auto const parts = show_bracket(program);
  program.picture(
      "dictionary", dictionary(),
      "The harmonics of degree 1 and 2, real parts, and below each its matrix of three rows, scaled to the "
      "norm 1. The order $m$ says on which diagonal it stands, the degree how its entries change "
      "along the diagonal.");
  program.picture("diagonals", diagonals(),
                  "A function, its matrix of eight rows and their parts. What depends on the longitude as "
                  "$\\cos m\\varphi$ stands on the two diagonals at the distance $m$ from the main one.");

  // 7. What must be so.
  double const square = (QuantizedSphere(3).spin(0) * QuantizedSphere(3).spin(0) +
                         QuantizedSphere(3).spin(1) * QuantizedSphere(3).spin(1) +
                         QuantizedSphere(3).spin(2) * QuantizedSphere(3).spin(2))(0, 0)
                            .real() *
                        std::pow(QuantizedSphere(3).hbar(), 2);
  program.claim(measured(std::abs(square - 1)) < 1e-15, "the squares of the coordinates add up to 1");
  program.claim(measured(turning) < 1e-14,
                "the flow on three rows turns its part of degree 2 at a third of a");
  program.claim(measured(std::abs(parts.first - 0.2) + std::abs(parts.third - 0.8)) < 3e-3,
                "with 48 rows the bracket is near that of functions");
  program.figure("turning", turning, "relative difference of [P, W] from a rotation, on three rows");
  program.headline("[P, W] on three rows is a rotation, to " + number(turning, 2), turning);
  return program.finish();
}
