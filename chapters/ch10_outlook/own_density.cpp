// A density of one's own by the generic implementation: a row of pendulums on a band of rubber, in twenty
// lines.
//
// What is shown. The reader writes L as a function of a jet, and that is all: discrete jets, Cartan forms,
// field equations and their solution follow. Here L is that of the sine-Gordon equation, on which Marsden,
// Patrick and Shkoller tried their first multisymplectic scheme. A kink, one full turn of the row, runs along
// it without change of shape, and the discrete one follows it with an error of second order. Read first.
// Section 10B.6.
//
// Compiled at -O2: it takes many steps.
#include <numbers>

#include "actio/multisymplectic/discrete_multisymplectic_form.hpp"
#include "actio/multisymplectic/step_field_equations.hpp"
#include "book/plot.hpp"
#include "book/program.hpp"

using namespace actio;
using namespace actio::media;
using Row = SpaceTimeMesh<double, 1>;
using Angles = DiscreteSection<double, 1, 1>;

// 1. The density, and a run from two levels of time.
struct Pendulums {  // kinetic energy, twist of the band, weight
  template <class T>
  T operator()(Jet<T, 1, 1> const& j) const {
    using std::cos;
    T const rate = j.v(0, 0), twist = j.v(0, 1);
    return (rate * rate - twist * twist) / T(2) + cos(j.y[0]) - T(1);
  }
};

Angles run(Row const& row, auto const& start) {
  auto section = restricted(row, start, 2);
  while (section.last() + 1 < row.levels()) step(Pendulums{}, row, section, start);
  return section;
}

Row row_of(int cells, double length, double time) {
  using Point = Matrix<double, 1, 1>;
  StraightBox<double, 1> const band{Point(-length / 2), Point(length / 2)};
  double const h = 0.8 * length / cells;  // at most the width of a cell
  auto const times = equal_steps(0.0, h, static_cast<int>(std::lround(time / h)));
  return {times, {cells}, all_sides<1>(Side::fixed), band};
}

// 2. The exact kink with the velocity v: the angle goes from 0 to a full turn.
struct Kink {
  double v = 0.6, start = -6;
  template <class T>
  Matrix<T, 1, 1> operator()(Matrix<T, 2, 1> const& x) const {
    using std::atan, std::exp;
    T const s = (x[1] - start - x[0] * v) / std::sqrt(1 - v * v);
    return Matrix<T, 1, 1>(T(4) * atan(exp(s)));
  }
};

double error_of(Row const& row, Angles const& section) {
  int const last = section.last();
  double worst = 0;
  for (Index i = 0; i < row.node_count(); ++i)
    worst = std::max(worst, std::abs(section(last, i)[0] - Kink{}(row.event(last, i))[0]));
  return worst;
}

// 3. The form formula on a box of space-time, on two first variations: the run repeated over dual numbers.
Angles first_variation(Row const& row, Angles const& section, double phase) {
  Angles two = section;
  two.levels.resize(2);
  Angles V = two;
  for (int k = 0; k < 2; ++k)
    for (Index i = 0; i < row.node_count(); ++i)
      V(k, i)[0] = row.fixed(i) ? 0 : std::sin(phase * static_cast<double>(i + 3 * k));
  auto moved = varied(two, V);
  while (moved.last() < section.last()) step(Pendulums{}, row, moved, Kink{});
  return rate_of(moved);
}

int main(int argc, char** argv) {
  book::Program program(argc, argv, "a density of one's own: a kink runs along a row of pendulums");
  double const length = 32, time = 16;
  std::vector<book::Program::Row> rows;
  double before = 0, order = 0, error = 0;
  for (int const cells : {80, 160, 320, 640}) {
    auto const row = row_of(cells, length, time);
    error = error_of(row, run(row, Kink{}));
    if (before > 0) order = std::log2(before / error);
    rows.push_back({std::to_string(cells), book::number(error), before > 0 ? book::number(order, 4) : ""});
    before = error;
  }
  program.table("errors", {"cells", "error", "order"}, rows,
                "Largest error of an angle when the kink has gone three tenths of the row.");
  auto const row = row_of(80, length, time);
  auto const section = run(row, Kink{});
  auto const V = first_variation(row, section, 0.7), W = first_variation(row, section, 1.9);
  CellBox<1> const box{3, 20, {{10}}, {{40}}};
  auto const form = multisymplectic_balance(Pendulums{}, row, section, V, W, box);
  double const balance = std::abs(form.sum) / form.terms;

  auto plot = book::Plot("place along the row", "angle, in turns");
  for (int k = 0; k < 3; ++k) {
    int const level = k * section.last() / 2;
    std::vector<double> x, angle;
    for (Index i = 0; i < row.node_count(); ++i)
      x.push_back(row.place(i)[0]), angle.push_back(section(level, i)[0] / (2 * std::numbers::pi));
    plot.curve(x, angle, "time " + book::number(row.time(level)));
  }
  program.picture("kink", plot.svg(), "A kink on 80 cells, at three times.");
  program.figure("error", error, "largest error of an angle on 640 cells");
  program.figure("order", order, book::number(order, 4), "order between the two finest meshes");
  program.figure("balance", balance, "form formula on a box of 20 x 40 cells, over the size of its terms");
  program.claim(book::measured(std::abs(order - 2)) < 0.05, "the error has order 2");
  // Sums of some hundred terms, each with a rounding of its own.
  program.claim(book::measured(balance) < 1e-14, "the discrete multisymplectic form formula holds");
  program.headline("a density of one's own with order " + book::number(order, 4), order);
  return program.finish();
}
