// Fields with values in a group as a reader steps them: two roads that agree, exact solutions, ends,
// refusals.
#include <boost/test/unit_test.hpp>

#include "actio/covariant_reduction/balances.hpp"
#include "actio/groups/motions.hpp"
#include "actio/groups/unit_quaternions.hpp"
#include "refused.hpp"
#include "witness/draw.hpp"

using namespace actio;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon(), h = 0.1, D = 0.12;

auto const squared = [](double w) { return [w](auto const& f) { return (1.0 - f.value[0]) * (4 * w); }; };
auto const chiral = time_and_space(squared(D / h), squared(-h / D));

GroupField<SU2, double> moving(int nodes, std::array<End, 2> ends, int steps) {
  Draw draw(5);
  GroupField<SU2, double> g{{{}}, ends};
  std::vector<Momentum<SU2, double>> momenta;
  for (int a = 0; a < nodes; ++a) {
    double const s = 2 * 3.14159 * a / nodes;
    g.levels[0].push_back(
        exp(velocity(SU2{}, Vector<double, 3>(0.7 * std::sin(s), 0.5 * std::cos(s), 0.2 * std::sin(2 * s)))));
    momenta.push_back(draw.momentum<double>(SU2{}, 0.5 * D));
  }
  step_in_time(chiral, g, momenta);
  for (int k = 1; k < steps; ++k) step_in_time(chiral, g);
  return g;
}
double distance(Element<SU2, double> const& a, Element<SU2, double> const& b) {
  return (a.value - b.value).norm();
}
std::array<End, 2> const open_line{End::free, End::free}, held{End::held, End::held},
    ring{End::joined, End::joined};

}  // namespace

BOOST_AUTO_TEST_CASE(the_reduced_field_steps_as_the_field_does) {
  for (auto const& ends : {open_line, held, ring}) {
    auto const g = moving(9, ends, 40);
    auto reduced = relative_motions(g);
    reduced.time.resize(1), reduced.space.resize(2);
    while (reduced.space.size() < g.levels.size()) step_in_time(chiral, reduced);
    auto const back = reconstruct(reduced, g(0, 0));
    double worst = 0;
    for (Index k = 0; k <= 40; ++k)
      for (Index a = 0; a < 9; ++a) worst = std::max(worst, distance(back(a, k), g(a, k)));
    // 40 steps of a solver that stops at 16 roundings, whose errors grow linearly.
    BOOST_TEST(worst < 40 * 16 * eps);
    for (Index k = 1; k < 40; ++k)
      for (Index a = 0; a < 9; ++a)
        if (!g.grid().held(a)) BOOST_TEST(magnitude(field_equation(chiral, g, a, k).components) < 64 * eps);
  }
}

BOOST_AUTO_TEST_CASE(a_held_end_stays_and_a_ring_goes_on_past_its_last_node) {
  auto const line = moving(9, held, 20);
  BOOST_TEST(distance(line(0, 20), line(0, 0)) == 0);
  BOOST_TEST(distance(line(4, 20), line(4, 0)) > 0.01);
  auto const circle = moving(9, ring, 20);
  BOOST_TEST(distance(circle(-1, 7), circle(8, 7)) == 0);
  auto const balance =
      noether_balance(chiral, circle, {.first_node = 6, .nodes = 5, .first_level = 3, .levels = 12});
  BOOST_TEST(magnitude(balance.sum.components) < 64 * eps * balance.terms);
  // All nodes of a ring, or of a line with free ends: nothing leaves but in time.
  for (auto const& field : {circle, moving(9, open_line, 20)}) {
    int edges = 0;
    over_boundary(field.grid(), {0, 9, 1, 18}, [&](GridEdge const& e, bool) {
      ++edges;
      BOOST_TEST((e.direction == Direction::time));
    });
    BOOST_TEST(edges == 18);
  }
}

BOOST_AUTO_TEST_CASE(steps_in_space_find_the_field_that_steps_in_time_made) {
  // With equal steps both directions are at the limit of their stability, and errors grow linearly.
  auto const l = time_and_space(squared(1), squared(-1));
  auto g = moving(12, open_line, 1);
  g.levels.resize(2);
  for (int k = 1; k < 24; ++k) step_in_time(l, g);
  auto const whole = transposed(g, held);
  auto across = whole;
  across.levels.resize(2);
  double worst = 0;
  for (std::size_t a = 2; a < 12; ++a) {
    step_in_time(transposed_lagrangian(l), across);
    across.levels[a].front() = whole.levels[a].front(), across.levels[a].back() = whole.levels[a].back();
    for (Index k = 0; k <= 24; ++k)
      worst = std::max(worst, distance(across(k, static_cast<Index>(a)), whole(k, static_cast<Index>(a))));
  }
  BOOST_TEST(worst < 1000 * eps);
}

BOOST_AUTO_TEST_CASE(a_chiral_field_moves_as_its_closed_form_says) {
  // g = A^k B^a: the ends move, and are written into each new level.
  auto const A = exp(velocity(SU2{}, Vector<double, 3>(0.1, -0.2, 0.05))),
             B = exp(velocity(SU2{}, Vector<double, 3>(0.3, 0.1, -0.2)));
  auto const power = [](auto const& x, Index n) { return exp(double(n) * log(x)); };
  GroupField<SU2, double> g{{{}, {}}, held};
  for (Index k = 0; k < 2; ++k)
    for (Index a = 0; a < 7; ++a) g.levels[k].push_back(power(A, k) * power(B, a));
  for (Index k = 2; k < 20; ++k) {
    step_in_time(chiral, g);
    for (Index a : {0, 6}) g.levels[k][a] = power(A, k) * power(B, a);
  }
  for (Index a = 0; a < 7; ++a) BOOST_TEST(distance(g(a, 19), power(A, 19) * power(B, a)) < 1e-12);
}

BOOST_AUTO_TEST_CASE(an_impulse_adds_to_the_momentum_of_the_whole_field) {
  auto g = moving(5, open_line, 3);
  auto const momentum_behind = [&](Index k) {
    auto sum = momentum(SU2{}, Vector<double, 3>(0, 0, 0));
    for (Index a = 0; a < 5; ++a) sum = sum + edge_momentum(chiral, g, g, {Direction::time, a, k});
    return sum;
  };
  std::vector impulses(5, momentum(SU2{}, Vector<double, 3>(0, 0, 0)));
  impulses[2].components = {0.01, -0.02, 0.03};
  step_in_time(chiral, g, impulses);
  auto const gained = momentum_behind(3) - momentum_behind(2), given = Ad_star(inverse(g(2, 3)), impulses[2]);
  BOOST_TEST(magnitude((gained - given).components) < 64 * eps);
}

BOOST_AUTO_TEST_CASE(with_short_steps_the_relative_motions_of_the_reduced_field_keep_their_digits) {
  double const step = 1e-4;
  auto const l = time_and_space(squared(D / step), squared(-step / D));
  GroupField<SU2, double> g{{moving(9, open_line, 1).levels[0]}, open_line};
  auto reduced = relative_motions(g);
  std::vector const momenta(9, momentum(SU2{}, Vector<double, 3>(0.1 * D, 0.2 * D, -0.1 * D)));
  step_in_time(l, reduced, momenta);
  while (reduced.space.size() < 30) step_in_time(l, reduced);
  auto const field = reconstruct(reduced, g(0, 0));
  NodeBox const box{2, 4, 5, 20};
  auto const kept = noether_balance(l, reduced, field, box), rounded = noether_balance(l, field, box);
  // Relative motions are about 1e-5: those of the field have lost five digits.
  BOOST_TEST(magnitude(kept.sum.components) < 16 * eps * kept.terms);
  BOOST_TEST(magnitude(rounded.sum.components) < 1e5 * 16 * eps * rounded.terms);
  BOOST_TEST(magnitude(rounded.sum.components) > 16 * eps * rounded.terms);
}

BOOST_AUTO_TEST_CASE(fields_that_are_none_are_refused) {
  auto g = moving(4, open_line, 3);
  GroupField<SU2, double> const one_node{{{g(0, 0)}}, open_line},
      half_ring{g.levels, {End::joined, End::free}};
  CHECK_REFUSED(relative_motions(one_node), OutsideDomain);
  CHECK_REFUSED(relative_motions(half_ring), OutsideDomain);
  CHECK_REFUSED(transposed(moving(4, ring, 2), held), OutsideDomain);
  auto ragged = g;
  ragged.levels[1].pop_back();
  CHECK_REFUSED(noether_balance(chiral, ragged, {1, 1, 1, 1}), OutsideDomain);
  auto reduced = relative_motions(g);
  reduced.time.pop_back();
  CHECK_REFUSED(reconstruct(reduced, g(0, 0)), OutsideDomain);
  GroupField<SU2, double> still{{g.levels[0]}, open_line};
  CHECK_REFUSED(step_in_time(chiral, still), OutsideDomain);
  CHECK_REFUSED(step_in_time(chiral, g, std::vector(3, momentum(SU2{}, Vector<double, 3>(0, 0, 0)))),
                OutsideDomain);
  CHECK_REFUSED(reconstruct_along(relative_motions(g), 0, 0, g(0, 0),
                                  {{Direction::space, true}, {Direction::time, false}}),
                OutsideDomain);
  FieldVariation<SU2, double> V(1, std::vector(4, velocity(SU2{}, Vector<double, 3>(0, 0, 0))));
  CHECK_REFUSED(step_variation(chiral, g, V), OutsideDomain);
  CHECK_REFUSED(form_balance(chiral, g, V, V, {1, 1, 1, 1}), OutsideDomain);
  V.push_back({});
  CHECK_REFUSED(step_variation(chiral, g, V), OutsideDomain);
}

BOOST_AUTO_TEST_CASE(boxes_without_a_field_equation_are_refused) {
  auto const g = moving(6, {End::held, End::free}, 5);
  auto const over = [&](NodeBox const& box) { return noether_balance(chiral, g, box); };
  CHECK_REFUSED(over({1, 0, 1, 1}), OutsideDomain);
  CHECK_REFUSED(over({1, 2, 0, 1}), OutsideDomain);
  CHECK_REFUSED(over({1, 2, 3, 3}), OutsideDomain);
  CHECK_REFUSED(over({1, 7, 1, 1}), OutsideDomain);
  CHECK_REFUSED(over({-1, 2, 1, 1}), OutsideDomain);
  CHECK_REFUSED(over({4, 3, 1, 1}), OutsideDomain);
  CHECK_REFUSED(over({0, 2, 1, 1}), OutsideDomain);
  auto const other = moving(6, held, 5);
  CHECK_REFUSED(noether_balance(chiral, other, {1, 5, 1, 1}), OutsideDomain);
}

BOOST_AUTO_TEST_CASE(a_step_that_fails_says_where) {
  auto g = moving(4, open_line, 2);
  auto const before = g.levels.size();
  // A momentum greater than any that the action has: its derivative is bounded.
  std::vector momenta(4, momentum(SU2{}, Vector<double, 3>(0, 0, 0)));
  momenta[2].components[0] = 10;
  CHECK_REFUSED(step_in_time(chiral, g, momenta), NotConverged);
  BOOST_TEST(g.levels.size() == before);
  momenta[2].components[0] = std::nan("");
  CHECK_REFUSED(step_in_time(chiral, g, momenta), NotFinite);
}
