// The discrete multisymplectic form formula and the discrete Noether theorem where nothing is rounded, and in
// fifty digits.
#include <boost/test/unit_test.hpp>

#include "media.hpp"
#include "witness/draw.hpp"
#include "witness/number.hpp"

using namespace actio;
using namespace actio::media;
using namespace actio::testing;

namespace {

/// A solution on a small bent mesh, with two first variations.
template <class S>
struct Solution {
  SpaceTimeMesh<S, 2> mesh;
  DiscreteSection<S, 2, 2> section, V, W;

  template <class L>
  Solution(L const& density, std::vector<S> times, Sides<2> const& sides, std::uint64_t seed)
      : mesh(std::move(times), {2, 2}, sides, bent_cube<S, 2>()) {
    FineDraw draw(seed);
    section = disturbed_identity(mesh, draw);
    run(density, mesh, section);
    V = first_variation(density, mesh, section, drawn_start<S, 2>(mesh, draw));
    W = first_variation(density, mesh, section, drawn_start<S, 2>(mesh, draw));
  }
};

}  // namespace

BOOST_AUTO_TEST_CASE(over_the_rationals_what_is_left_over_a_box_is_zero_and_not_small) {
  WithArithmetic const exactly(Arithmetic::rationals());
  using Q = Number;
  auto const medium = solid<Q, 2>();
  Solution<Q> const s(medium, {Q(0), ratio<Q>(1, 20), ratio<Q>(1, 8), ratio<Q>(1, 6)},
                      all_sides<2>(Side::free), 1);
  Draw draw(2);
  for (int k = 0; k < 8; ++k) {
    auto const box = drawn_box(s.mesh, draw);
    BOOST_TEST((multisymplectic_balance(medium, s.mesh, s.section, s.V, s.W, box).sum == 0));
    for (int a = 0; a < 2; ++a)
      BOOST_TEST((noether_balance(medium, shifting<Q, 2>(a), s.mesh, s.section, box).sum == 0));
    BOOST_TEST((noether_balance(medium, turning<Q, 2>(), s.mesh, s.section, box).sum == 0));
    BOOST_TEST((noether_balance(medium, growing<Q, 2>(), s.mesh, s.section, box).sum != 0));
  }
  // The momenta of the whole free body are the same after every slab.
  auto const angular = [&](int slab) {
    return momentum_of_level(medium, turning<Q, 2>(), s.mesh, s.section, slab).sum;
  };
  BOOST_TEST((angular(1) == angular(0)));
  BOOST_TEST((angular(2) == angular(0)));
  BOOST_TEST((angular(0) != 0));
  // The formula needs both hypotheses: a variation of no solution, and a section that is none.
  CellBox<2> const whole{0, 3, {}, {{2, 2}}};
  auto no_variation = s.V;
  no_variation(1, 4)[0] += ratio<Q>(1, 7);
  BOOST_TEST((multisymplectic_balance(medium, s.mesh, s.section, no_variation, s.W, whole).sum != 0));
  // The section enters the form through its gradients alone, and those at a side of the box inside the body.
  auto no_solution = s.section;
  no_solution(1, 4)[0] += ratio<Q>(1, 70);
  CellBox<2> const half{0, 3, {}, {{1, 2}}};
  BOOST_TEST((multisymplectic_balance(medium, s.mesh, s.section, s.V, s.W, half).sum == 0));
  BOOST_TEST((multisymplectic_balance(medium, s.mesh, no_solution, s.V, s.W, half).sum != 0));
  BOOST_TEST((noether_balance(medium, shifting<Q, 2>(0), s.mesh, no_solution, whole).sum != 0));
}

BOOST_AUTO_TEST_CASE(in_fifty_digits_it_is_rounding_and_nothing_else) {
  WithArithmetic const digits(Arithmetic::decimal(50));
  using R = Number;
  auto const medium = gas<R, 2>();
  Solution<R> const s(medium, equal_steps<R>(R(0), ratio<R>(1, 20), 4),
                      {{{Side::free, Side::fixed}, {Side::periodic, Side::periodic}}}, 3);
  Draw draw(4);
  double form = 0, noether = 0;
  for (int k = 0; k < 10; ++k) {
    auto const box = drawn_box(s.mesh, draw);
    auto const a = multisymplectic_balance(medium, s.mesh, s.section, s.V, s.W, box);
    auto const b = noether_balance(medium, shifting<R, 2>(1), s.mesh, s.section, box);
    form = std::max(form, to_double(R(magnitude(a.sum) / a.terms)));
    noether = std::max(noether, to_double(R(magnitude(b.sum) / b.terms)));
  }
  BOOST_TEST_MESSAGE("in fifty digits: form " << form << ", Noether " << noether);
  // As in double, with this unit of rounding: a few for the form; for momenta one over the step as well.
  double const unit = to_double(epsilon<R>());
  BOOST_TEST(form < 5 * unit);
  BOOST_TEST(noether < 45 * unit);
}
