// Two theorems on boxes of space-time: the discrete form formula and the discrete Noether theorem.
//
// What is shown. A quarter of a ring of gas, free on all sides, moves by the discrete field equations of its
// density; two first variations are the same run over dual numbers. On boxes of cells drawn at random the
// multisymplectic form, and the momenta of shifts and turns of space, sum up to zero over the boundary, to
// rounding. A variation of no solution, and a growth of space, which is no symmetry, leave a remainder. Read
// first. Sections 10B.4 and 10B.5.
//
// Compiled at -O2: it takes many steps.
#include <numbers>

#include "actio/continuum/materials.hpp"
#include "actio/multisymplectic/discrete_multisymplectic_form.hpp"
#include "actio/multisymplectic/discrete_noether.hpp"
#include "actio/multisymplectic/step_field_equations.hpp"
#include "book/plot.hpp"
#include "book/program.hpp"
#include "witness/draw.hpp"

using namespace actio;
using namespace actio::media;
using Point = Matrix<double, 2, 1>;
using Mesh = SpaceTimeMesh<double, 2>;
using Section = DiscreteSection<double, 2, 2>;

constexpr int around = 6, across = 4, slabs = 10, boxes = 60;
constexpr std::uint64_t seed = 10;

// 1. The density: a gas whose pressure is that of (rho/J)^2, with a mass that grows to one side.
auto const gas = Continuum{Euclidean<2>{}, Euclidean<2>{}, LinearDensity<double, 2>{2, Point(0.3, 0.2)},
                           Barotropic{WholePolytropic<double, 1>{0.75}}};

// 2. The mesh: a quarter of a ring, and steps of time that differ.
Mesh quarter_of_a_ring() {
  std::vector<double> times{0};
  for (int k = 0; k < slabs; ++k) times.push_back(times.back() + 0.03 + 0.01 * (k % 3));
  auto const ring = [](Point const& u) {
    double const r = 1 + u[1], angle = std::numbers::pi / 2 * (1 - u[0]);
    return Point(r * std::cos(angle), r * std::sin(angle));
  };
  return {times, {around, across}, all_sides<2>(Side::free), ring};
}

// 3. A solution, and first variations of it: the derivative of the run along a change of its start.
Section solution_on(Mesh const& mesh) {
  auto section = restricted(
      mesh,
      [](Matrix<double, 3, 1> const& x) {
        double const t = x[0], turn = 0.4 * t;
        Point const at(x[1] + 0.03 * std::sin(3 * x[2]), x[2] + 0.02 * std::cos(4 * x[1]));
        return Point(at[0] - turn * at[1] + 0.5 * t, at[1] + turn * at[0] - 0.2 * t);
      },
      2);
  while (section.last() < slabs) step(gas, mesh, section);
  return section;
}
Section first_variation(Mesh const& mesh, Section solution, Draw& draw) {
  solution.levels.resize(2);
  auto change = solution;
  for (auto& level : change.levels)
    for (auto& V : level) V = draw.vector<double, Point>(2);
  auto moved = varied(solution, change);
  while (moved.last() < slabs) step(gas, mesh, moved);
  return rate_of(moved);
}

// 4. A box of cells somewhere in the mesh, at least two cells and slabs wide.
CellBox<2> drawn_box(Draw& draw) {
  auto const part = [&](int all, int& first, int& count) {
    count = 2 + static_cast<int>(draw.below(static_cast<std::uint64_t>(all - 1)));
    first = static_cast<int>(draw.below(static_cast<std::uint64_t>(all - count + 1)));
  };
  CellBox<2> box{};
  part(slabs, box.first_slab, box.slabs);
  part(around, box.first_cell[0], box.cells[0]);
  part(across, box.first_cell[1], box.cells[1]);
  return box;
}

// 5. A sum over the boundary of a box, over the magnitudes of its terms: the largest, and the least of a
//    control.
struct Balance {
  std::string what;
  double largest = 0, least = HUGE_VAL;
  void add(SumOfTerms<double, double> const& sum) {
    double const part = std::abs(sum.sum) / sum.terms;
    largest = std::max(largest, part), least = std::min(least, part);
  }
};

int main(int argc, char** argv) {
  book::Program program(argc, argv, "what sums up to zero over the boundary of any box of space-time");
  program.say("boxes and variations from seed ", seed);
  Draw draw(seed);
  Mesh const mesh = quarter_of_a_ring();
  Section const solution = solution_on(mesh);
  auto const V = first_variation(mesh, solution, draw), W = first_variation(mesh, solution, draw);
  auto mixed = V;  // a variation of no solution: every other level is that of another one
  for (std::size_t k = 1; k < mixed.levels.size(); k += 2) mixed.levels[k] = W.levels[k];
  RigidMotion<double, 2> const still{Matrix<double, 2, 2>::Zero(), Point::Zero()};
  auto right = still, up = still, turn = still;
  right.shift = Point(1, 0), up.shift = Point(0, 1);
  turn.turn(0, 1) = -1, turn.turn(1, 0) = 1;
  auto const growth = motion_of_space<2>([](auto const& y) { return std::remove_cvref_t<decltype(y)>(y); });

  Balance form{"form, two first variations"}, mixture{"form, a variation of no solution"},
      shifts{"momenta of shifts"}, turns{"momentum of turns"}, grows{"momentum of a growth"};
  for (int k = 0; k < boxes; ++k) {
    auto const box = drawn_box(draw);
    form.add(multisymplectic_balance(gas, mesh, solution, V, W, box));
    mixture.add(multisymplectic_balance(gas, mesh, solution, mixed, W, box));
    shifts.add(noether_balance(gas, motion_of_space<2>(right), mesh, solution, box));
    shifts.add(noether_balance(gas, motion_of_space<2>(up), mesh, solution, box));
    turns.add(noether_balance(gas, motion_of_space<2>(turn), mesh, solution, box));
    grows.add(noether_balance(gas, growth, mesh, solution, box));
  }
  std::vector<book::Program::Row> rows;
  for (auto const* b : {&form, &shifts, &turns, &mixture, &grows})
    rows.push_back({b->what, book::number(b->largest, 2), book::number(b->least, 2)});
  program.table("balances", {"", "largest", "least"}, rows,
                "Sums over the boundary of boxes drawn at random, over the sums of "
                "the magnitudes of their terms.");
  double const noether = std::max(shifts.largest, turns.largest);
  program.figure("form", form.largest, "form formula, largest of all boxes");
  program.figure("noether", noether, "Noether balance, largest of all boxes");
  program.figure("boxes", boxes, std::to_string(boxes), "boxes");
  program.figure("mixture", mixture.least, "the form on a variation of no solution, least of all boxes");
  program.figure("growth", grows.least, "the momentum of a growth, least of all boxes");
  // The form's terms have a rounding each, and these are independent. A momentum is told to the rounding of
  // places of the size of one, over the way of a thirtieth or so that a node goes in a step.
  program.claim(book::measured(form.largest) < 1e-15, "the discrete multisymplectic form formula holds");
  program.claim(book::measured(noether) < 1e-14, "the discrete Noether theorem holds");
  program.claim(book::measured(mixture.least) > 1e-4 && book::measured(grows.least) > 1e-4,
                "without a hypothesis there is a remainder");
  program.headline("form to " + book::number(form.largest, 2) + ", Noether to " + book::number(noether, 2) +
                       " on " + std::to_string(boxes) + " boxes",
                   noether);
  return program.finish();
}
