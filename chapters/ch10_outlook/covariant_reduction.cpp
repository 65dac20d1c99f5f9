// Fields with values in a group, reduced: a chiral field and a chain of spins, in time and in space.
//
// What is shown. A field of unit quaternions on a string and a ring of rotors, whose axes turn each other,
// move by the discrete Euler-Poincare equations, once in time and once in space. The reduced field makes the
// same motion, along any path through the grid. On boxes of nodes drawn at random momentum and
// multisymplectic form sum up to zero over the boundary, to rounding, and off solutions they do not. Steps in
// space find the field again where the steps of time are not short. Read first. Sections 10F.1 to 10F.3.
//
//   h, D   step, distance of nodes     f, e   relative motions in time and in space
//
// Compiled at -O2: it takes many steps.
#include <Eigen/Core>

#include <algorithm>
#include <numbers>

#include "actio/covariant_reduction/balances.hpp"
#include "actio/groups/rotations.hpp"
#include "actio/groups/unit_quaternions.hpp"
#include "book/measure.hpp"
#include "book/plot.hpp"
#include "witness/draw.hpp"

using namespace actio;
using List = std::vector<double>;
using Triple = Matrix<double, 3, 1>;
constexpr double D = 0.1;
constexpr int nodes = 24, steps = 120, boxes = 200;
constexpr std::uint64_t seed = 6;

// 1. Two Lagrangians. The chiral field: four times 1 - f_0 is half of the square of the angle of f, to second
//    order. The chain: rotors of Moser and Veselov, and the cosine of the angle between two axes.
auto chiral(double h) {
  auto const square = [](double w) { return [w](auto const& f) { return (1.0 - f.value[0]) * (4 * w); }; };
  return time_and_space(square(D / h), square(-h / D));
}
auto chain(double h) {
  return time_and_space(
      [h](auto const& f) {
        return ((1.0 - f.value(0, 0)) * 0.5 + (1.0 - f.value(1, 1)) * 0.6 + (1.0 - f.value(2, 2)) * 0.3) / h;
      },
      [h](auto const& e) { return e.value(2, 2) * (2 * h); });
}

// 2. A run: a row of values and their momenta, the first step, and the others.
template <class G, class L>
GroupField<G, double> run(L const& l, G const& group, std::array<End, 2> ends, double mass) {
  GroupField<G, double> field{{{}}, ends};
  std::vector<Momentum<G, double>> momenta;
  for (int a = 0; a < nodes; ++a) {
    double const s = 2 * std::numbers::pi * a / nodes;
    field.levels[0].push_back(
        exp(velocity(group, Triple(0.8 * std::sin(s), 0.6 * std::cos(s), 0.4 * std::sin(2 * s)))));
    momenta.push_back(momentum(group, Triple(mass * Triple(std::cos(s), 0.6, -0.4 * std::sin(2 * s)))));
  }
  step_in_time(l, field, momenta);
  while (field.grid().levels <= steps) step_in_time(l, field);
  return field;
}

// 3. Sums over the boundaries of drawn boxes, relative to their terms: of the momentum and of the form of two
//    first variations; and controls, with each value moved by 0.01 and with a variation that solves nothing.
struct Sums {
  List nodes_of_box, momentum, form, momentum_off, form_off;
};
NodeBox drawn_box(Draw& draw, SpaceTimeGrid const& grid) {
  auto const below = [&](Index n) { return static_cast<Index>(draw.below(static_cast<std::uint64_t>(n))); };
  NodeBox box{0, 1 + below(grid.nodes), 0, 1 + below(grid.levels - 2)};
  box.first_node = below(grid.ring() ? grid.nodes : grid.nodes - box.nodes + 1);
  box.first_level = 1 + below(grid.levels - 1 - box.levels);
  return box;
}
template <class L, class G>
Sums sums_over_boxes(L const& l, GroupField<G, double> const& field) {
  Draw draw(seed);
  std::array<FieldVariation<G, double>, 3> V;
  for (auto& U : V)
    for (auto const& row : field.levels)
      for (auto& zeta : U.emplace_back(row.size(), velocity(row[0].group, Triple(0, 0, 0))))
        zeta = draw.velocity<double>(row[0].group);
  for (int i = 0; i < 2; ++i)
    for (V[i].resize(2); V[i].size() < field.levels.size();) step_variation(l, field, V[i]);
  auto off = field;
  for (auto& row : off.levels)
    for (auto& g : row) g = g * draw.element<double>(g.group, 0.01);
  Sums all;
  auto const add = [](List& list, auto const& balance, auto const& sum) {
    list.push_back(magnitude(sum) / balance.terms);
  };
  for (int i = 0; i < boxes; ++i) {
    auto const box = drawn_box(draw, field.grid());
    auto const J = noether_balance(l, field, box), J_off = noether_balance(l, off, box);
    auto const omega = form_balance(l, field, V[0], V[1], box),
               omega_off = form_balance(l, field, V[0], V[2], box);
    all.nodes_of_box.push_back(static_cast<double>(box.nodes * box.levels));
    add(all.momentum, J, J.sum.components), add(all.momentum_off, J_off, J_off.sum.components);
    add(all.form, omega, omega.sum), add(all.form_off, omega_off, omega_off.sum);
  }
  return all;
}

// 4. Two roads to one field: the reduced field stepped without the values, then values along drawn paths from
//    the first node of the first level to the last one of the last.
template <class L, class G>
double apart_along_paths(L const& l, GroupField<G, double> const& field) {
  auto reduced = relative_motions(field);
  reduced.time.resize(1), reduced.space.resize(2);
  while (reduced.grid().levels <= steps) step_in_time(l, reduced);
  Draw draw(seed);
  std::vector<GridMove> path(nodes - 1, {Direction::space, true});
  path.resize(nodes - 1 + steps, {Direction::time, true});
  double apart = 0;
  for (int i = 0; i < boxes; ++i) {
    for (std::size_t m = path.size(); m > 1; --m) std::swap(path[m - 1], path[draw.below(m)]);
    auto const there = reconstruct_along(reduced, 0, 0, field(0, 0), path);
    apart = std::max(apart, magnitude((there.value - field(nodes - 1, steps).value).eval()));
  }
  return apart;
}

// 5. The field again, from its first two nodes by steps in space; the first and the last level are given.
List errors_in_space(double h) {
  auto const whole = transposed(run(chiral(h), SU2{}, {End::free, End::free}, D), {End::held, End::held});
  auto field = whole;
  field.levels.resize(2);
  List errors{0, 0};
  for (int a = 2; a < nodes; ++a) {
    step_in_time(transposed_lagrangian(chiral(h)), field);
    field.levels[a].front() = whole.levels[a].front(), field.levels[a].back() = whole.levels[a].back();
    errors.push_back(0);
    for (int k = 0; k <= steps; ++k)
      errors.back() = std::max(errors.back(), magnitude((field(k, a).value - whole(k, a).value).eval()));
  }
  return errors;
}

int main(int argc, char** argv) {
  book::Program program(argc, argv, "reduced fields: a chiral field and a chain of spins");
  double const h = 0.09;
  std::array<End, 2> const line{End::free, End::free}, ring{End::joined, End::joined};
  auto const field = run(chiral(h), SU2{}, line, D);
  auto const spins = run(chain(h), SO<3>{}, ring, 1.0);
  std::array const all{sums_over_boxes(chiral(h), field), sums_over_boxes(chain(h), spins)};
  std::vector<std::vector<std::string>> rows;
  for (int i = 0; i < 2; ++i) {
    std::string const name = i == 0 ? "chiral field, SU(2)" : "chain of spins, SO(3)";
    double const J = std::ranges::max(all[i].momentum), J_off = std::ranges::min(all[i].momentum_off),
                 form = std::ranges::max(all[i].form), form_off = std::ranges::min(all[i].form_off);
    rows.push_back(
        {name, book::number(J, 2), book::number(J_off, 2), book::number(form, 2), book::number(form_off, 2)});
    program.claim(book::measured(J) < 1e-14, name + ": the momentum sums up to zero");
    program.claim(book::measured(form) < 1e-14, name + ": the form sums up to zero");
    program.claim(book::measured(std::min(J_off, form_off)) > 1e-8, name + ": the controls do not");
    if (i == 0) program.headline("momentum through 200 boxes: zero to " + book::number(J, 2), J);
  }
  program.table(
      "balances", {"field", "momentum", "off solutions", "form", "off first variations"}, rows,
      "Largest sums over the boundaries of 200 boxes, relative to their terms, and least of controls.");
  auto plot = book::Plot("nodes of the box", "sum over the boundary").log_x().log_y().size(560, 330);
  plot.dots(all[0].nodes_of_box, all[0].momentum, "the field")
      .dots(all[0].nodes_of_box, all[0].momentum_off, "values moved by 0.01");
  program.picture("boxes", plot.svg(), "Momentum through the boundary of boxes of the chiral field.");

  double const paths = std::max(apart_along_paths(chiral(h), field), apart_along_paths(chain(h), spins));
  program.figure("paths", paths, "largest difference of a value along a path and in the field");
  program.claim(book::measured(paths) < 1e-12, "reconstruction does not depend on the path");

  auto growth = book::Plot("node", "error").log_y().size(560, 330);
  std::vector<std::vector<std::string>> factors;
  List where(nodes);
  for (int a = 0; a < nodes; ++a) where[a] = a;
  for (double const courant : {1.0, 0.9, 0.8}) {
    auto const errors = errors_in_space(courant * D);
    growth.curve(where, errors, "h/D = " + book::number(courant));
    double const factor = std::pow(errors[nodes - 1] / errors[nodes - 6], 0.2),
                 expected = std::exp(2 * std::acosh(1 / courant));
    factors.push_back({book::number(courant), book::number(errors.back(), 2), book::number(factor, 3),
                       book::number(expected, 3)});
    if (courant == 1)
      program.claim(book::measured(errors.back()) < 1e-12, "with h = D steps in space find the field again");
    else
      program.claim(book::measured(std::abs(factor / expected - 1)) < 0.1,
                    "with h/D = " + book::number(courant) + " errors grow as the linear waves do");
  }
  program.table("in_space", {"h/D", "error at the last node", "its growth a node", "of linear waves"},
                factors, "The chiral field found again by steps in space.");
  program.picture("in_space", growth.svg(),
                  "The chiral field found again by steps in space: the largest error of a value.");
  return program.finish();
}
