// Steps on a level of the momentum with an advected vector: their order on four groups against equations by
// hand, the Casimirs of the semidirect product, gradients, a Lagrangian whose kinetic part depends on the
// vector, and what is refused.
#include <boost/test/unit_test.hpp>

#include "actio/reduction/advected_momentum_level.hpp"
#include "actio/rigid_body/heavy_top.hpp"
#include "refused.hpp"
#include "uneven_lagrangian.hpp"

using namespace actio;
using namespace actio::testing;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

/// An uneven Lagrangian less a potential of the vector, \f$\langle d, a\rangle + \tfrac12\langle e,
/// a\rangle^2\f$.
template <class S>
struct UnevenTop {
  UnevenLagrangian<S> free;
  Vector<S> d, e;

  UnevenTop(Draw& draw, SpannedGroup const& group)
      : free(draw, group), d(draw.vector<S>(group.matrix_size())), e(draw.vector<S>(group.matrix_size())) {}
  template <class T>
  T operator()(Velocity<SpannedGroup, T> const& xi, Matrix<T, Dynamic, 1> const& a) const {
    T one(0), two(0);
    for (Index i = 0; i < a.size(); ++i) one += a[i] * d[i], two += a[i] * e[i];
    return free(xi) - one - two * two / S(2);
  }
  template <class T>
  Vector<T> slope_by_hand(Vector<T> const& a) const {
    T two(0);
    Vector<T> out(a.size());
    for (Index i = 0; i < a.size(); ++i) two += a[i] * T(e[i]);
    for (Index i = 0; i < a.size(); ++i) out[i] = -T(d[i]) - two * T(e[i]);
    return out;
  }
};

/// The equations of motion for (xi, a): \f$p' = \pm(\mathrm{ad}^*_\xi\,p - J)\f$ with
/// \f$J_k = \langle\partial l/\partial a, e_ka\rangle\f$, and \f$a' = \mp\xi a\f$.
template <class S, int side>
struct TopByHand {
  UnevenTop<S> l;
  FlowByHand<S, side> free{l.free};

  template <class T>
  Vector<T> operator()(Vector<T> const& y) const {
    auto const& group = l.free.group;
    int const d = group.dimension(), m = group.matrix_size();
    Vector<T> const xi = y.head(d), a = y.tail(m), slope = l.slope_by_hand(a);
    Vector<T> p_rate = free.momentum_rate(xi, l.free.gradient_by_hand(xi));
    for (int k = 0; k < d; ++k) {
      Matrix<T> const e = group.hat(Vector<T>(Vector<T>::Unit(d, k)));
      T const torque = slope.dot(Vector<T>(e * a));
      p_rate[k] += side > 0 ? torque : -torque;
    }
    Vector<T> const moved = group.hat(xi) * a;
    Vector<T> rate(d + m);
    rate.head(d) = free.acceleration(xi, p_rate);
    for (int i = 0; i < m; ++i) rate[d + i] = side > 0 ? moved[i] : -moved[i];
    return rate;
  }
};

template <int side, Real S, class L>
auto level_step(L const& l) {
  if constexpr (side > 0)
    return advected_momentum_level_step_right<S>(l);
  else
    return advected_momentum_level_step_left<S>(l);
}

template <int side>
void has_order_eight(SpannedGroup const& group) {
  Draw draw(11);
  UnevenTop<Number> const l(draw, group);
  auto const xi = draw.velocity<Number>(group);
  Vector<Number> const a = draw.vector<Number>(group.matrix_size());
  Number const time = ratio<Number>(1, 32);
  int const d = group.dimension(), m = group.matrix_size();
  Vector<Number> y(d + m);
  y.head(d) = xi.coordinates, y.tail(m) = a;
  y = taylor_reference<Number>(TopByHand<Number, side>{l}, y, time);
  Vector<Number> const p = l.free.gradient_by_hand(Vector<Number>(y.head(d)));
  std::vector<int> const counts{2, 3, 4, 6, 8};
  std::vector<double> errors;
  for (int const count : counts) {
    auto state = advected_momentum_state(l, xi, Matrix<Number, Dynamic, 1>(a));
    auto const step = level_step<side, Number>(l);
    for (int k = 0; k < count; ++k) state = step(state, Number(time / count)).state;
    errors.push_back(to_double(magnitude(Vector<Number>(state.momentum.components - p)) +
                               magnitude(Vector<Number>(state.vector - y.tail(m)))));
  }
  auto const measured = order_of(counts, errors);
  BOOST_TEST_CONTEXT(group.name() << (side > 0 ? " right" : " left") << ": spread " << measured.spread)
  BOOST_TEST(std::abs(measured.slope - 8) < 0.1);
}

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

}  // namespace

BOOST_AUTO_TEST_SUITE(advected_momentum_level)

BOOST_AUTO_TEST_CASE(the_order_is_eight_on_either_side_of_four_groups) {
  WithArithmetic const digits(Arithmetic::decimal(50));
  for (auto const& group : four_groups()) has_order_eight<1>(group), has_order_eight<-1>(group);
}

BOOST_AUTO_TEST_CASE(casimirs_vector_and_momentum_of_the_symmetry_are_conserved_however_long_the_step) {
  auto const step = advected_momentum_level_step_left<double>(bent_top);
  auto state = start_of(bent_top);
  auto g = identity<double>(SO<3>{});
  Vector<double, 3> const fixed = state.vector;
  double const along = fixed.dot(state.momentum.components);
  int const steps = 50;
  for (int k = 0; k < steps; ++k) {
    auto const done = step(state, 0.3);
    state = done.state, g = reconstruct_left(g, done.relative_motion);
  }
  double const size = magnitude(state.momentum.components);
  Vector<double, 3> const back = g.value * state.vector, spatial = g.value * state.momentum.components;
  // Each step rounds some twenty terms of the series of Ad*.
  double const bound = 20 * steps * eps;
  BOOST_TEST(std::abs(state.vector.dot(state.vector) - 1) < bound);
  BOOST_TEST(std::abs(state.vector.dot(state.momentum.components) - along) < bound * size);
  BOOST_TEST(magnitude(Vector<double, 3>(back - fixed)) < bound);
  BOOST_TEST(std::abs(fixed.dot(spatial) - along) < bound * size);
}

BOOST_AUTO_TEST_CASE(a_kinetic_energy_that_depends_on_the_vector_gives_the_motion_of_other_steps) {
  // Half of the steps: the error is divided by 2^8, and both meet the energy.
  auto const after = [](int steps) {
    auto const step = advected_momentum_level_step_left<double>(bent_top);
    auto state = start_of(bent_top);
    for (int k = 0; k < steps; ++k) state = step(state, 2.0 / steps).state;
    return state;
  };
  auto const fine = after(160), coarse = after(20), middle = after(40);
  auto const apart = [&](auto const& s) {
    return magnitude(Vector<double, 3>(s.momentum.components - fine.momentum.components));
  };
  BOOST_TEST(std::abs(std::log2(apart(coarse) / apart(middle)) - 8) < 0.5);
  auto const energy = [](auto const& s) {
    return s.momentum.components.dot(s.velocity.coordinates) - bent_top(s.velocity, s.vector);
  };
  // The velocity of the state is near the end of the step; that of the momentum has this energy.
  auto const start = start_of(bent_top);
  auto end = fine;
  detail::LegendreChord<SO<3>, double> legendre;
  auto const held = detail::holding(bent_top, end.vector);
  legendre.begin(held, end.velocity);
  legendre.solve(held, end.momentum.components, end.velocity);
  BOOST_TEST(std::abs(energy(end) - energy(start)) < 160 * 64 * eps);
}

BOOST_AUTO_TEST_CASE(a_linear_potential_costs_three_slopes_a_step_and_another_one_a_stage) {
  auto const known = kovalevskaya_top<double>();
  auto const gradients = [&](double bend) {
    auto const top = [&](auto const& xi, auto const& a) {
      using S = typename std::decay_t<decltype(xi)>::Scalar;
      S sum = a[0] * a[0] * bend;
      for (int i = 0; i < 3; ++i)
        sum += xi.coordinates[i] * xi.coordinates[i] * (known.top.inertia.moments[i] / 2) -
               a[i] * known.top.lever()[i];
      return sum;
    };
    auto const step = advected_momentum_level_step_left<double>(top);
    auto state = start_of(top);
    int last = 0;
    for (int k = 0; k < 10; ++k) {
      auto const done = step(state, 0.05);
      state = done.state, last = done.evaluations;
    }
    return last;
  };
  // Two gradients in the velocity, which a line checks.
  BOOST_TEST(gradients(0) == 3 + 2);
  BOOST_TEST(gradients(0.1) == detail::Fehlberg<double>::stages + 2);
}

BOOST_AUTO_TEST_CASE(what_makes_no_sense_is_refused) {
  auto const step = advected_momentum_level_step_left<double>(bent_top);
  auto const start = start_of(bent_top);
  CHECK_REFUSED(step(start, 0), OutsideDomain);
  auto broken = start;
  broken.vector[1] = std::numeric_limits<double>::quiet_NaN();
  CHECK_REFUSED(step(broken, 0.1), NotFinite);
}

BOOST_AUTO_TEST_SUITE_END()
