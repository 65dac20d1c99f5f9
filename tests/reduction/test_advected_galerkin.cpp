// Galerkin steps with an advected vector: their order against the explicit step of order 8, Casimirs, the
// bracket, and the step without a vector.
#include <boost/test/unit_test.hpp>

#include "actio/groups/rotations.hpp"
#include "actio/reduction/advected_galerkin.hpp"
#include "refused.hpp"

using namespace actio;

namespace {

/// A top whose kinetic energy depends on the vector as well.
auto const bent_top = [](auto const& xi, auto const& a) {
  auto const& v = xi.coordinates;
  return (v[0] * v[0] * 0.6 + v[1] * v[1] * 0.8 + v[2] * v[2]) / 2 +
         (v[0] * a[0] + v[1] * a[1] + v[2] * a[2]) * (a[0] * 0.3 + a[1] * a[2]) / 4 - a[0] * 0.8 - a[2] * 0.3;
};
auto start_of(auto const& l) {
  return advected_momentum_state(l, velocity(SO<3>{}, Vector<double, 3>(1.8, -1, 0.7)),
                                 Matrix<double, 3, 1>(0.6, 0, 0.8));
}
auto after(auto const& step, double time, int steps) {
  auto state = start_of(bent_top);
  for (int k = 0; k < steps; ++k) state = step(state, time / steps).state;
  return state;
}
double apart(auto const& x, auto const& y) {
  return magnitude((x.momentum - y.momentum).components) + magnitude(Vector<double, 3>(x.vector - y.vector));
}

template <int side>
auto galerkin(int s) {
  if constexpr (side > 0)
    return advected_galerkin_step_right<double>(bent_top, s);
  else
    return advected_galerkin_step_left<double>(bent_top, s);
}
template <int side>
auto level() {
  if constexpr (side > 0)
    return advected_momentum_level_step_right<double>(bent_top);
  else
    return advected_momentum_level_step_left<double>(bent_top);
}

template <int side>
void has_order_of_twice_the_degree() {
  auto const truth = after(level<side>(), 2, 400);
  for (int s : {1, 2, 3}) {
    double const coarse = apart(after(galerkin<side>(s), 2, 20), truth),
                 fine = apart(after(galerkin<side>(s), 2, 40), truth);
    BOOST_TEST_CONTEXT("side " << side << ", degree " << s)
    BOOST_TEST(std::abs(std::log2(coarse / fine) - 2 * s) < 0.2);
  }
}

}  // namespace

BOOST_AUTO_TEST_SUITE(advected_galerkin)

BOOST_AUTO_TEST_CASE(the_order_is_twice_the_degree_on_either_side) {
  has_order_of_twice_the_degree<-1>(), has_order_of_twice_the_degree<1>();
}

BOOST_AUTO_TEST_CASE(casimirs_are_conserved_however_long_the_step) {
  auto const start = start_of(bent_top), end = after(galerkin<-1>(2), 6, 20);
  double const bound = 20 * 64 * std::numeric_limits<double>::epsilon();
  BOOST_TEST(std::abs(end.vector.dot(end.vector) - 1) < bound);
  BOOST_TEST(std::abs(end.vector.dot(end.momentum.components) - start.vector.dot(start.momentum.components)) <
             bound * magnitude(start.momentum.components));
}

BOOST_AUTO_TEST_CASE(a_motion_whose_lagrangian_does_not_see_the_vector_is_that_without_it) {
  auto const body = [](auto const& xi) {
    auto const& v = xi.coordinates;
    return (v[0] * v[0] * 0.6 + v[1] * v[1] * 0.8 + v[2] * v[2]) / 2;
  };
  auto const with = start_of([&](auto const& xi, auto const&) { return body(xi); });
  auto const step =
      advected_galerkin_step_left<double>([&](auto const& xi, auto const&) { return body(xi); }, 3);
  auto const plain = galerkin_step_left<double>(body, 3);
  auto const one = step(with, 0.3).state.momentum,
             two = plain(MomentumState<SO<3>, double>{with.momentum, with.velocity}, 0.3).state.momentum;
  BOOST_TEST(magnitude((one - two).components) < 64 * std::numeric_limits<double>::epsilon());
}

BOOST_AUTO_TEST_CASE(what_makes_no_sense_is_refused) {
  auto start = start_of(bent_top);
  CHECK_REFUSED(galerkin<-1>(2)(start, 0), OutsideDomain);
  start.vector[0] = std::numeric_limits<double>::infinity();
  CHECK_REFUSED(galerkin<-1>(2)(start, 0.1), NotFinite);
}

BOOST_AUTO_TEST_SUITE_END()
