// The heavy top: the scheme against the generic implementation and against the equations of Euler and
// Poisson, what it conserves, and refusals.
#include <boost/test/unit_test.hpp>

#include <complex>
#include <functional>

#include "actio/forms/forms.hpp"
#include "actio/reduction/natural_chart.hpp"
#include "actio/rigid_body/body_in_motion.hpp"
#include "caught.hpp"
#include "euler_poisson.hpp"
#include "random_bodies.hpp"
#include "refused.hpp"
#include "witness/draw.hpp"
#include "witness/reference_solution.hpp"

using namespace actio;
using testing::caught;
using Vector3d = actio::Vector<double, 3>;
using testing::EulerPoisson, testing::together;
using Vector6d = Matrix<double, 6, 1>;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
SO<3> const turns;

/// A top without any symmetry, not principal in space either, and how it is let go.
HeavyTop<double> const crooked = heavy_top<double>(1.5, inertia_from_moments(0.7, 0.9, 1.2),
                                                   Vector3d(0.1, -0.15, 0.2), Vector3d(1, 2, -9));
HeavyTopState<double> const crooked_start =
    release(crooked, exp(velocity(turns, Vector3d(0.5, 0.2, -0.4))), velocity(turns, Vector3d(1.5, -1, 2)));
/// A symmetric top with its centre of mass on its axis.
HeavyTop<double> const lagrange =
    heavy_top<double>(1, inertia_from_moments(0.6, 0.6, 1.0), Vector3d(0, 0, 0.3), Vector3d(0, 0, -9.81));
HeavyTopState<double> const lagrange_start =
    release(lagrange, exp(velocity(turns, Vector3d(0.5, 0, 0))), velocity(turns, Vector3d(0.3, 0.4, 6)));

/// The element of SE(3) by whose coadjoint action a step of second order moves momentum and vertical: the
/// relative motion f between two shifts by \f$-\tfrac h2p\f$, since the impulse of gravity is a shift of the
/// semidirect product.
Element<SE<3>, double> step_as_motion(HeavyTop<double> const& top, double h,
                                      Element<SO<3>, double> const& f) {
  auto shift = identity<double>(SE<3>{}), turn = shift;
  shift.value.topRightCorner<3, 1>() = top.lever() * (-h / 2);
  turn.value.topLeftCorner<3, 3>() = f.value;
  return shift * turn * shift;
}

Vector6d flow(HeavyTop<double> const& top, HeavyTopState<double> const& start, double duration) {
  EulerPoisson<double> const equations{top.inertia.moments, top.lever()};
  return reference_solution([&](double, Vector6d const& y) { return equations(y); }, together(start), 0,
                            duration);
}

/// Either discrete Lagrangian, as one type: the generic implementation is compiled once.
struct Action {
  HeavyTop<double> top;
  double h;
  bool arcs = false;

  template <class T>
  T operator()(Element<SO<3>, T> const& f, Matrix<T, 3, 1> const& gamma) const {
    return arcs ? natural_chart_lagrangian(top, h)(f, gamma) : trace_lagrangian(top, h)(f, gamma);
  }
};
/// The relative motion of the step that starts with the momentum of a state, by the generic implementation.
Element<SO<3>, double> relative_motion(Action const& l, HeavyTopState<double> const& s) {
  return advected_relative_motion_left(l, s.momentum, s.vector,
                                       exp(-l.h * body_velocity(l.top.inertia, s.momentum)))
      .value;
}
/// A step of the generic implementation: relative motion from momentum, momentum at the end, vertical
/// transported.
HeavyTopState<double> step_by_duals(Action const& l, HeavyTopState<double> const& s) {
  auto const f = relative_motion(l, s);
  return {advected_momentum_after_left(l, f, s.vector), advect_left(f, s.vector)};
}

using Step = std::function<void(HeavyTopState<double>&)>;
void has_order(int order, HeavyTop<double> const& top, HeavyTopState<double> const& start,
               std::vector<int> const& counts, std::function<Step(double)> const& step_of, double tolerance,
               std::string const& name) {
  double const duration = 2;
  Vector6d const truth = flow(top, start, duration);
  std::vector<double> steps, errors;
  for (int const count : counts) {
    auto state = start;
    auto const step = step_of(duration / count);
    for (int k = 0; k < count; ++k) step(state);
    steps.push_back(duration / count), errors.push_back((together(state) - truth).norm());
  }
  auto const fit = testing::fit_order(steps, errors);
  BOOST_TEST_MESSAGE(name << ": order " << fit.slope << ", spread " << fit.spread << ", errors "
                          << errors.front() << " to " << errors.back());
  BOOST_TEST(std::abs(fit.slope - order) < tolerance);
  BOOST_TEST(errors.back() > 1e-11);  // above rounding and above the reference
}

auto const by_scheme = [](HeavyTop<double> const& top, int order) {
  return [&top, order](double h) -> Step {
    return [scheme = HeavyTopScheme<>(top, h, order)](HeavyTopState<double>& s) { scheme.advance(s); };
  };
};

}  // namespace

BOOST_AUTO_TEST_SUITE(heavy_tops)

BOOST_AUTO_TEST_CASE(the_scheme_is_the_generic_implementation_with_the_trace_lagrangian) {
  for (double const h : {0.1, 0.01, -0.05}) {
    HeavyTopScheme<> const scheme(crooked, h);
    Action const l{crooked, h};
    auto fast = crooked_start;
    for (int k = 0; k < 10; ++k) {
      auto const general = step_by_duals(l, fast);
      scheme.advance(fast);
      // The solver leaves a relative motion 16 eps off, so momenta 16 eps times moments over h.
      BOOST_TEST(magnitude((general.momentum - fast.momentum).components) <=
                 16 * eps / std::abs(h) * 2 * crooked.inertia.moments.maxCoeff());
      BOOST_TEST(magnitude((general.vector - fast.vector).eval()) <= 32 * eps);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_natural_chart_lagrangian_is_that_of_chapter_three) {
  // h L at the middle of the arc, (3.20), of the Lagrangian on TSO(3), at pairs of attitudes that follow no
  // motion.
  double const h = 0.1;
  auto const on_tangents = [&](auto const& v) {
    return kinetic_energy(crooked.inertia, Ad(inverse(v.configuration), v.velocity)) -
           crooked.lever().dot(v.configuration.value.transpose() * crooked.vertical());
  };
  auto const full = discretize_left(on_tangents, h, at_second);
  auto const reduced = lift_advected_left(natural_chart_lagrangian(crooked, h), crooked.vertical());
  Draw draw(21);
  for (int i = 0; i < 5; ++i) {
    auto const g0 = draw.element<double>(turns), g1 = g0 * exp(0.3 * draw.velocity<double>(turns));
    BOOST_TEST(std::abs(full(g0, g1) - reduced(g0, g1)) <= 64 * eps * (1 + std::abs(full(g0, g1))));
  }
}

BOOST_AUTO_TEST_CASE(a_step_is_a_coadjoint_action_of_the_group_of_motions) {
  double const h = 0.05;
  auto state = crooked_start;
  HeavyTopScheme<> const scheme(crooked, h);
  for (int k = 0; k < 5; ++k) {
    auto const before = momentum(SE<3>{}, together(state));
    auto const f = relative_motion({crooked, h}, state);
    scheme.advance(state);
    auto const after = Ad_star(inverse(step_as_motion(crooked, h, f)), before).components;
    BOOST_TEST((after - together(state)).norm() <= 64 * eps * before.components.norm());
    // Control: shifted the other way.
    BOOST_TEST(
        (Ad_star(inverse(step_as_motion(crooked, -h, f)), before).components - together(state)).norm() >
        0.01);
  }
}

BOOST_AUTO_TEST_CASE(both_lagrangians_are_of_order_two) {
  std::vector<int> const counts{40, 80, 160, 320, 640};
  auto const arcs = [](double h) -> Step {
    return [l = Action{crooked, h, true}](HeavyTopState<double>& s) { s = step_by_duals(l, s); };
  };
  has_order(2, crooked, crooked_start, counts, by_scheme(crooked, 2), 0.05, "chords, top without symmetry");
  has_order(2, lagrange, lagrange_start, counts, by_scheme(lagrange, 2), 0.05, "chords, symmetric top");
  has_order(2, crooked, crooked_start, counts, arcs, 0.05, "arcs, top without symmetry");
}

BOOST_AUTO_TEST_CASE(compositions_are_of_order_four_and_six) {
  // Over a range where the next term of the error, h^2 times the first, moves the slope by less than it is
  // allowed to be off.
  has_order(4, crooked, crooked_start, {80, 160, 320, 640}, by_scheme(crooked, 4), 0.05,
            "five steps for one");
  has_order(6, crooked, crooked_start, {24, 32, 48, 64}, by_scheme(crooked, 6), 0.2,
            "twenty-five steps for one");
  for (int const order : {2, 4, 6, 8}) {
    double sum = 0;
    for (double const w : symmetric_composition<double>(order)) sum += w;
    BOOST_TEST(std::abs(sum - 1) <= 200 * eps);  // up to 125 terms
  }
}

BOOST_AUTO_TEST_CASE(casimirs_stay_at_every_step_length_and_the_rest_does_not) {
  for (int const order : {2, 4})
    for (double const h : {0.1, 0.01}) {
      auto state = crooked_start;
      HeavyTopScheme<> const scheme(crooked, h, order);
      double const size = state.momentum.components.norm(),
                   vertical = state.momentum.components.dot(state.vector), energy = crooked.energy(state);
      double other = 0, lost = 0;
      int const count = 1000;
      for (int k = 0; k < count; ++k) {
        scheme.advance(state);
        other = std::max(other, (state.momentum - crooked_start.momentum).components.norm() / size);
        lost = std::max(lost, std::abs(crooked.energy(state) / energy - 1));
      }
      // Each of count steps, of five parts, rounds a few times.
      BOOST_TEST(std::abs(state.momentum.components.dot(state.vector) - vertical) <=
                 100 * eps * std::sqrt(5.0 * count) * size);
      BOOST_TEST(std::abs(state.vector.norm() - 1) <= 100 * eps * std::sqrt(5.0 * count));
      BOOST_TEST(other > 0.5);
      BOOST_TEST(lost > 1e-9);
    }
}

BOOST_AUTO_TEST_CASE(the_axis_of_a_symmetric_top_keeps_its_momentum_and_that_of_another_does_not) {
  auto const changed = [](HeavyTop<double> const& top) {
    auto state =
        release(top, exp(velocity(turns, Vector3d(0.5, 0, 0))), velocity(turns, Vector3d(0.3, 0.4, 6)));
    double const start = state.momentum.components[2];
    HeavyTopScheme<> const scheme(top, 0.05, 4);
    double largest = 0;
    for (int k = 0; k < 1000; ++k)
      scheme.advance(state), largest = std::max(largest, std::abs(state.momentum.components[2] / start - 1));
    return largest;
  };
  BOOST_TEST(changed(lagrange) <= 100 * eps * std::sqrt(5000.0));
  // By Noether's theorem, for either Lagrangian: the momenta at the two ends of a step that is none of a
  // motion.
  Draw draw(22);
  auto const f = draw.element<double>(turns);
  Vector3d const gamma = draw.vector<double>(3);
  for (bool const arcs : {false, true}) {
    Action const l{lagrange, 0.1, arcs};
    auto const before = advected_momentum_before_left(l, f, gamma),
               after = advected_momentum_after_left(l, f, gamma);
    BOOST_TEST(std::abs((after - before).components[2]) <= 64 * eps * after.components.norm());
    BOOST_TEST((after - before).components.norm() > 0.1);
  }
  // Controls: two moments that differ by a tenth; the centre of mass beside the axis.
  BOOST_TEST(changed(heavy_top<double>(1, inertia_from_moments(0.6, 0.66, 1.0), lagrange.centre,
                                       lagrange.gravity)) > 1e-4);
  BOOST_TEST(changed(heavy_top<double>(1, lagrange.inertia, Vector3d(0.01, 0, 0.29), lagrange.gravity)) >
             1e-4);
}

BOOST_AUTO_TEST_CASE(kovalevskayas_top_has_a_fourth_integral_that_the_scheme_keeps_to_second_order) {
  auto const [top, spin] = kovalevskaya_top<double>();
  auto const start = release(top, exp(velocity(turns, Vector3d(0.7, -0.4, 0.2))), spin);
  auto const integral = [&](Vector6d const& y, double c) {
    std::complex<double> const omega(y[0] / 2, y[1] / 2), gamma(y[3], y[4]);
    return std::norm(omega * omega - c * gamma);
  };
  double const known = integral(together(start), 1);
  for (double const t : {1.0, 5.0, 20.0}) {
    Vector6d const y = flow(top, start, t);
    BOOST_TEST(std::abs(integral(y, 1) - known) <= 1e-12);
    BOOST_TEST(std::abs(integral(y, 1.1) - integral(together(start), 1.1)) > 1e-3);
  }
  std::vector<double> steps{0.08, 0.04, 0.02, 0.01}, changes;
  for (double const h : steps) {
    HeavyTopScheme<> const scheme(top, h);
    auto state = start;
    double largest = 0;
    for (int k = 0; k < std::lround(20 / h); ++k)
      scheme.advance(state), largest = std::max(largest, std::abs(integral(together(state), 1) - known));
    changes.push_back(largest);
  }
  auto const fit = testing::fit_order(steps, changes);
  BOOST_TEST_MESSAGE("fourth integral: changes by " << changes.front() << " to " << changes.back()
                                                    << ", order " << fit.slope);
  BOOST_TEST(std::abs(fit.slope - 2) < 0.05);
}

BOOST_AUTO_TEST_CASE(without_weight_it_is_the_free_body) {
  auto const inertia = inertia_from_moments(0.6, 0.8, 1.0);
  auto const spin = velocity(turns, Vector3d(0.7, -0.4, 0.5));
  MoserVeselov<3> const free(inertia, 0.1);
  for (auto const& top : {heavy_top<double>(0, inertia, Vector3d(9, 9, 9), Vector3d(0, 0, -9.81)),
                          heavy_top<double>(1, inertia, Vector3d(0, 0, 0), Vector3d(0, 0, -9.81)),
                          heavy_top<double>(1, inertia, Vector3d(0.1, 0.2, 0.3), Vector3d(0, 0, 0))}) {
    auto body = release(inertia, identity<double>(turns), spin);
    auto state = release(top, identity<double>(turns), spin);
    BOOST_TEST((state.vector - Vector3d::UnitZ()).norm() == 0);
    HeavyTopScheme<> const scheme(top, 0.1);
    for (int k = 0; k < 20; ++k)
      body.body_momentum = free.step_lie_poisson(body.body_momentum), scheme.advance(state);
    BOOST_TEST((state.momentum - body.body_momentum).components.norm() == 0);
  }
}

BOOST_AUTO_TEST_CASE(a_step_back_undoes_a_step_and_the_attitude_costs_no_digit) {
  auto g = exp(velocity(turns, Vector3d(0.5, 0.2, -0.4)));
  auto const attitude = g;
  auto there = crooked_start, alone = crooked_start;
  for (int const order : {2, 4}) {
    HeavyTopScheme<> const forth(crooked, 0.1, order), back(crooked, -0.1, order);
    for (int k = 0; k < 10; ++k) forth.advance(there, g), forth.advance(alone);
    BOOST_TEST((together(there) - together(alone)).norm() == 0);
    BOOST_TEST((g.value.transpose() * crooked.vertical() - there.vector).norm() <= 64 * eps);
    for (int k = 0; k < 10; ++k) back.advance(there, g);
    BOOST_TEST((together(there) - together(crooked_start)).norm() <=
               1000 * eps * together(crooked_start).norm());
    BOOST_TEST((g.value - attitude.value).norm() <= 1000 * eps);
    alone = there = crooked_start, g = attitude;
  }
}

BOOST_AUTO_TEST_CASE(tops_of_every_size_give_the_same_digits) {
  auto const motion = [](double mass, double length, double time) {
    auto const top = heavy_top<double>(
        1.5 * mass, inertia_from_moments<double>(Vector3d(0.7, 0.9, 1.2) * (mass * length * length)),
        Vector3d(0.1, -0.15, 0.2) * length, Vector3d(1, 2, -9) * (length / time / time));
    auto state = release(top, identity<double>(turns), velocity(turns, (Vector3d(1.5, -1, 2) / time).eval()));
    HeavyTopScheme<> const scheme(top, 0.1 * time);
    for (int k = 0; k < 50; ++k) scheme.advance(state);
    return state.vector;
  };
  Vector3d const usual = motion(1, 1, 1);
  // Powers of two: not a digit differs.
  BOOST_TEST((motion(std::ldexp(1.0, 60), std::ldexp(1.0, -30), std::ldexp(1.0, -20)) - usual).norm() == 0);
  for (double const mass : {1e-26, 1e26})
    for (double const time : {1e-9, 1e9})
      BOOST_TEST((motion(mass, 1e-10, time) - usual).norm() <= 50 * 64 * eps);
}

BOOST_AUTO_TEST_CASE(a_body_held_anywhere_is_the_same_top_in_another_frame) {
  auto const about_centre = inertia_from_moments(0.5, 0.6, 0.7);
  Vector3d const gravity(0, 0, -9.81), arm(0, 0.4, 0), spin(0.5, 1, -2);
  auto const straight = held_at_a_point<double>(2, about_centre, arm, gravity);
  BOOST_TEST((straight.inertia.moments - Vector3d(0.82, 0.6, 1.02)).norm() <= 8 * eps);
  // The same body described in a frame that is turned by Q: vectors of the body are Q times what they were.
  Matrix<double, 3, 3> const Q = exp(velocity(turns, Vector3d(0.3, -0.8, 0.5))).value;
  auto const [top, axes] = held_anywhere(
      2, Q * Matrix<double, 3, 3>(about_centre.moments.asDiagonal()) * Q.transpose(), Q * arm, gravity);
  BOOST_TEST(std::abs(determinant(actio::Matrix<double, 3, 3>(axes)) - 1) <= 16 * eps);
  auto a = release(straight, identity<double>(turns), velocity(turns, spin));
  auto b = release(top, Element<SO<3>, double>{turns, Q.transpose() * axes},
                   velocity(turns, (axes.transpose() * Q * spin).eval()));
  HeavyTopScheme<> const first(straight, 0.05), second(top, 0.05);
  for (int k = 0; k < 20; ++k) first.advance(a), second.advance(b);
  // Moments by an eigenvalue solver, 16 epsilon, over twenty steps.
  BOOST_TEST((Q.transpose() * axes * b.vector - a.vector).norm() <= 1000 * eps);
  BOOST_TEST((Q.transpose() * axes * b.momentum.components - a.momentum.components).norm() <=
             1000 * eps * a.momentum.components.norm());
}

BOOST_AUTO_TEST_CASE(a_step_without_a_solution_is_refused_with_one_that_has) {
  for (int const order : {2, 4}) {
    HeavyTopScheme<> const scheme(lagrange, 1.0, order);
    auto state = lagrange_start;
    Element<SO<3>, double> g = identity<double>(turns);
    auto const error = caught<StepTooLong>([&] { scheme.advance(state, g); });
    BOOST_TEST(error.measured == 1.0);
    BOOST_TEST((together(state) - together(lagrange_start)).norm() == 0);
    BOOST_TEST((g.value - Matrix<double, 3, 3>::Identity()).norm() == 0);
    HeavyTopScheme<>(lagrange, error.largest_step, order).advance(state);
    if (order == 2)
      CHECK_REFUSED(HeavyTopScheme<>(lagrange, 1.002 * error.largest_step).advance(state = lagrange_start),
                    StepTooLong);
  }
}

BOOST_AUTO_TEST_CASE(what_is_no_top_and_no_step_is_refused) {
  auto const inertia = inertia_from_moments(0.6, 0.6, 1.0);  // Lambda = (0.5, 0.5, 0.1)
  Vector3d const centre(0, 0, 0.3), gravity(0, 0, -9.81);
  for (double const bad : {std::nan(""), HUGE_VAL}) {
    CHECK_REFUSED(heavy_top<double>(bad, inertia, centre, gravity), NotFinite);
    CHECK_REFUSED(heavy_top<double>(1, inertia, Vector3d(bad, 0, 0), gravity), NotFinite);
    CHECK_REFUSED(heavy_top<double>(1, inertia, centre, Vector3d(0, bad, 0)), NotFinite);
    CHECK_REFUSED(held_at_a_point<double>(bad, inertia, centre, gravity), NotFinite);
    CHECK_REFUSED(held_anywhere(1, Matrix<double, 3, 3>::Identity(), Vector3d(bad, 0, 0), gravity),
                  NotFinite);
    CHECK_REFUSED(HeavyTopScheme<>(lagrange, bad), NotFinite);
    CHECK_REFUSED(natural_chart_lagrangian(lagrange, bad), NotFinite);
    CHECK_REFUSED(trace_lagrangian(lagrange, bad), NotFinite);
    auto state = lagrange_start;
    state.vector[1] = bad;
    CHECK_REFUSED(HeavyTopScheme<>(lagrange, 0.1).advance(state), NotFinite);
    state = lagrange_start, state.momentum.components[0] = bad;
    CHECK_REFUSED(HeavyTopScheme<>(lagrange, 0.1).advance(state), NotFinite);
  }
  CHECK_REFUSED(heavy_top<double>(1e300, inertia, Vector3d(0, 0, 1e-160), Vector3d(0, 0, -1e200)), NotFinite);
  CHECK_REFUSED(heavy_top<double>(-1, inertia, centre, gravity), OutsideDomain);
  CHECK_REFUSED(held_at_a_point<double>(-1, inertia, centre, gravity), OutsideDomain);
  CHECK_REFUSED(held_at_a_point<double>(1, inertia, Vector3d(0.1, 0, 0.3), gravity), OutsideDomain);
  CHECK_REFUSED(held_anywhere(-1, Matrix<double, 3, 3>::Identity(), centre, gravity), OutsideDomain);
  CHECK_REFUSED(held_anywhere(1, Matrix<double, 3, 3>(Vector3d(1, 1, 3).asDiagonal()), centre, gravity),
                UnphysicalInertia);
  CHECK_REFUSED(HeavyTopScheme<>(lagrange, 0.0), OutsideDomain);
  CHECK_REFUSED(natural_chart_lagrangian(lagrange, -0.1), OutsideDomain);
  CHECK_REFUSED(trace_lagrangian(lagrange, 0.0), OutsideDomain);
  for (int const order : {-2, 0, 1, 3, 5, 10})
    CHECK_REFUSED(HeavyTopScheme<>(lagrange, 0.1, order), OutsideDomain);
  // As much mass at the centre as there is inertia, no more: m 0.3^2 <= 0.1.
  heavy_top<double>(1 / 0.9, inertia, centre, gravity);
  BOOST_CHECK_EXCEPTION(
      heavy_top<double>(1.001 / 0.9, inertia, centre, gravity), UnphysicalInertia,
      [](UnphysicalInertia const& e) { return std::abs(e.measured - 1.001) < 1e-12 && e.bound == 1; });
  CHECK_REFUSED(heavy_top<double>(0, inertia_from_lambda<3, double>(Vector3d(-0.1, 1, 1)), centre, gravity),
                UnphysicalInertia);
}

BOOST_AUTO_TEST_SUITE_END()
