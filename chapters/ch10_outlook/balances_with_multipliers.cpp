// The form formula and Noether's theorem with multipliers, on boxes of space-time drawn at random.
//
// What is shown. A quarter of a ring of incompressible rubber, free on all sides, moves by the discrete field
// equations with a multiplier for each cell and level; two first variations are the same run over dual
// numbers. On boxes of cells the multisymplectic form, and the momenta of shifts and turns of space, sum up
// to zero over the boundary, to rounding. With the multipliers of another level, without them, on a variation
// of no solution and for a growth of space there is a remainder. Read first. Section 10C.2.
//
// Compiled at -O2: it takes many steps.
#include <numbers>

#include "actio/constraints_on_meshes/extended_balances.hpp"
#include "actio/constraints_on_meshes/step_with_multipliers.hpp"
#include "actio/continuum/materials.hpp"
#include "actio/incompressible/incompressible_density.hpp"
#include "book/plot.hpp"
#include "book/program.hpp"
#include "witness/draw.hpp"

using namespace actio;
using namespace actio::media;
using Point = Matrix<double, 2, 1>;
using Mesh = SpaceTimeMesh<double, 2>;
using Section = DiscreteExtendedSection<double, 2, 2, 1>;

constexpr int around = 5, across = 4, slabs = 10, boxes = 200;
constexpr std::uint64_t seed = 10;

// 1. The density: rubber whose mass grows to one side, with the constraint of its volume.
auto const rubber =
    incompressible(Continuum{Euclidean<2>{}, Euclidean<2>{}, LinearDensity<double, 2>{2, Point(0.3, 0.2)},
                             OfGreenTensor{NeoHookean{0.5, LogarithmicVolume<double>{0}}}});

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

// 3. A run from places and velocities over any scalar: the first step, then the others.
template <class S>
DiscreteExtendedSection<S, 2, 2, 1> run(Mesh const& mesh, Level<S, 2> const& places,
                                        Level<S, 2> const& velocities) {
  auto y = without_reactions<1>(mesh, DiscreteSection<S, 2, 2>{{places}});
  first_step(rubber, mesh, y, velocities);
  while (y.last() < slabs) step(rubber, mesh, y);
  return y;
}
struct Start {
  Level<double, 2> places, velocities;
};
Start start_on(Mesh const& mesh) {
  Start start;
  for (Index i = 0; i < mesh.node_count(); ++i) {
    Point const X = mesh.place(i);
    start.places.push_back(X);
    start.velocities.push_back(
        Point(0.5 - 0.4 * X[1] + 0.3 * X[0] + 0.2 * std::sin(2 * X[1]), 0.4 * X[0] - 0.3 * X[1] - 0.2));
  }
  return start;
}
//    Its derivative along a change of the start. The change of the places need not keep the areas: those of
//    all later levels are kept, and boxes begin after the first slab.
Section first_variation(Mesh const& mesh, Start const& start, Draw& draw) {
  Level<Dual<double>, 2> places, velocities;
  for (std::size_t i = 0; i < start.places.size(); ++i) {
    places.push_back(moved_along(start.places[i], Point(draw.vector<double, Point>(2) * 0.1)));
    velocities.push_back(moved_along(start.velocities[i], draw.vector<double, Point>(2)));
  }
  return rate_of(run<Dual<double>>(mesh, places, velocities));
}

// 4. A box of cells somewhere in the mesh, two slabs or more, and not all of the cells in either direction:
//    it has faces inside of the body, where the multipliers of both sides push. The last slab is left out: a
//    step that is not taken would determine its multipliers.
CellBox<2> drawn_box(Draw& draw) {
  auto const part = [&](int first, int last, int& begin, int& count) {
    count = 2 + static_cast<int>(draw.below(static_cast<std::uint64_t>(last - first - 1)));
    begin = first + static_cast<int>(draw.below(static_cast<std::uint64_t>(last - first - count + 1)));
  };
  CellBox<2> box{};
  part(1, slabs - 1, box.first_slab, box.slabs);
  part(0, around - 1, box.first_cell[0], box.cells[0]);
  part(0, across - 1, box.first_cell[1], box.cells[1]);
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
  book::Program program(argc, argv, "what sums up to zero over any box of an incompressible body");
  program.say("boxes and variations from seed ", seed);
  Draw draw(seed);
  Mesh const mesh = quarter_of_a_ring();
  Start const start = start_on(mesh);
  Section const solution = run<double>(mesh, start.places, start.velocities);
  double area = 0, tension = 0;
  for (int slab = 0; slab < slabs; ++slab)
    mesh.for_cells([&](GridIndex<2> const& cell) {
      auto const here = configuration<2>(cell_of(mesh, solution, slab, cell));
      double volume = 0;
      for (double const part : here.geometry->volume) volume += part;
      area = std::max(area, std::abs(constraint_of_cell(rubber.constraint, here, 1)[0]) / volume);
      tension = std::max(tension, std::abs(solution.lambda[slab][mesh.number(cell)][0]));
    });
  auto const V = first_variation(mesh, start, draw), W = first_variation(mesh, start, draw);
  auto mixed = V;  // a variation of no solution: every other level is that of another one
  for (std::size_t k = 1; k < mixed.phi.levels.size(); k += 2)
    mixed.phi.levels[k] = W.phi.levels[k], mixed.lambda[k] = W.lambda[k];
  auto late = solution, without = solution;
  std::rotate(late.lambda.begin(), late.lambda.begin() + 1, late.lambda.end());
  for (auto& level : without.lambda)
    for (auto& lambda : level) lambda.setZero();
  RigidMotion<double, 2> const still{Matrix<double, 2, 2>::Zero(), Point::Zero()};
  auto right = still, up = still, turn = still;
  right.shift = Point(1, 0), up.shift = Point(0, 1);
  turn.turn(0, 1) = -1, turn.turn(1, 0) = 1;
  auto const growth = motion_of_space<2>([](auto const& y) { return std::remove_cvref_t<decltype(y)>(y); });

  Balance form{"form, two first variations"}, shifts{"momenta of shifts"}, turns{"momentum of turns"},
      mixture{"form, a variation of no solution"}, shifted{"form, multipliers of the next level"},
      grows{"momentum of a growth"}, none{"momentum of turns without the multipliers"};
  for (int k = 0; k < boxes; ++k) {
    auto const box = drawn_box(draw);
    form.add(multisymplectic_balance(rubber, mesh, solution, V, W, box));
    shifts.add(noether_balance(rubber, motion_of_space<2>(right), mesh, solution, box));
    shifts.add(noether_balance(rubber, motion_of_space<2>(up), mesh, solution, box));
    turns.add(noether_balance(rubber, motion_of_space<2>(turn), mesh, solution, box));
    mixture.add(multisymplectic_balance(rubber, mesh, solution, mixed, W, box));
    shifted.add(multisymplectic_balance(rubber, mesh, late, V, W, box));
    grows.add(noether_balance(rubber, growth, mesh, solution, box));
    none.add(noether_balance(rubber, motion_of_space<2>(turn), mesh, without, box));
  }
  std::vector<book::Program::Row> rows;
  for (auto const* b : {&form, &shifts, &turns, &mixture, &shifted, &grows, &none})
    rows.push_back({b->what, book::number(b->largest, 2), book::number(b->least, 2)});
  program.table("balances", {"", "largest", "least"}, rows,
                "Sums over the boundary of boxes drawn at random, over the sums of "
                "the magnitudes of their terms.");
  double const noether = std::max(shifts.largest, turns.largest);
  double const least = std::min({mixture.least, shifted.least, grows.least, none.least});
  program.figure("form", form.largest, "form formula, largest of all boxes");
  program.figure("noether", noether, "Noether balance, largest of all boxes");
  program.figure("boxes", boxes, std::to_string(boxes), "boxes");
  program.figure("area", area, "largest relative change of the area of a cell");
  program.figure("least", least, "least remainder without a hypothesis");
  // First variations come out of eliminations with the condition of the constraints, some hundreds; places of
  // the size of two have a rounding each, over the way of a thirtieth or so that a node goes in a step.
  program.claim(book::measured(form.largest) < 1e-13,
                "the form formula holds on variations that keep the areas");
  program.claim(book::measured(noether) < 1e-14, "the discrete Noether theorem holds with the multipliers");
  program.claim(book::measured(area) < 1e-13, "the area of each cell is kept");
  program.claim(book::measured(tension) > 1e-2, "the multipliers are not small");
  program.claim(book::measured(least) > 1e-10, "without a hypothesis there is a remainder");
  program.headline("form to " + book::number(form.largest, 2) + ", Noether to " + book::number(noether, 2) +
                       " on " + std::to_string(boxes) + " boxes",
                   noether);
  return program.finish();
}
