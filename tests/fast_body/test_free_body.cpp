// The free body: bodies, motions, units and input that break codes.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "../rigid_body/random_bodies.hpp"
#include "actio/fast_body/space/free_steps.hpp"
#include "actio/rigid_body/moser_veselov.hpp"
#include "hard_bodies.hpp"
#include "refused.hpp"

using namespace actio;
using namespace actio::bodies;
using Eigen::Vector3d;

namespace {
constexpr double eps = std::numeric_limits<double>::epsilon();

FreeBody body_of(Vector3d const& moments, Vector3d const& momentum,
                 Eigen::Vector4d const& attitude = {1, 0, 0, 0}) {
  return FreeBody(inertia_from_moments<double>(moments), {SO<3>{}, momentum}, {SU2{}, attitude});
}
Vector3d momentum_of(FreeState const& s) { return s.body_momentum.components; }
double differ(FreeState const& a, FreeState const& b) {
  double const size = std::max(momentum_of(a).norm(), 1e-300);
  double const q =
      std::min((a.attitude.value - b.attitude.value).norm(), (a.attitude.value + b.attitude.value).norm());
  return std::max((momentum_of(a) - momentum_of(b)).norm() / size, q);
}

// What holds of every free motion, wherever it is: momentum in space, amount, energy, unit attitude.
// Roundings of one step; the energy has 1/I in it.
void keeps_what_is_kept(FreeBody const& body, FreeState const& s, double steps = 1) {
  auto const start = body.at(0);
  double const size = body.magnitude() > 0 ? body.magnitude() : 1;
  BOOST_TEST(is_finite(momentum_of(s)));
  BOOST_TEST(is_finite(s.attitude.value));
  BOOST_TEST(std::abs(s.attitude.value.norm() - 1) <= 4 * eps);
  BOOST_TEST(std::abs(momentum_of(s).stableNorm() / size - (body.magnitude() > 0 ? 1 : 0)) <=
             16 * eps * steps);
  BOOST_TEST((s.spatial_momentum().components / size - start.spatial_momentum().components / size).norm() <=
             32 * eps * steps);
}
}  // namespace

BOOST_AUTO_TEST_SUITE(free_body)

BOOST_AUTO_TEST_CASE(a_sphere_and_symmetric_bodies_have_their_closed_forms) {
  for (double const other : {0.5, 1.0, 1.7, 2.0})
    for (int axis = 0; axis < 3; ++axis) {
      Vector3d I(1, 1, 1), M(0.3, -0.7, 0.45);
      I[axis] = other;
      auto const body = body_of(I, M);
      for (double const t : {1e-9, 0.01, 1.0, -17.0, 1234.5}) {
        // A turn about the momentum by t|M|, then one about the axis of symmetry by t M_a (1/I_a - 1).
        Vector3d const beyond = t * M[axis] * (1 / other - 1) * Vector3d::Unit(axis);
        Element<SU2, double> const q{SU2{},
                                     SU2::compose<double>(SU2::exp<double>(t * M), SU2::exp<double>(beyond))};
        Eigen::Vector4d const turned = SU2::exp<double>(-beyond);
        FreeState const expected{{SO<3>{}, SU2::Ad<double>(turned, M)}, q};
        BOOST_TEST(differ(body.at(t), expected) <= 16 * eps * (1 + std::abs(t) * M.norm() * 2));
      }
    }
}

BOOST_AUTO_TEST_CASE(the_momentum_alone_is_that_of_the_whole_state_to_the_last_bit) {
  FreeSteps steps(body_of({1, 2, 2.8}, {0.3, -0.7, 0.45}), 0.01);
  long differ = 0;
  for (int k = 0; k < 2000; ++k) {
    steps.advance();
    differ += momentum_of(steps.state()) != steps.body_momentum().components;
  }
  BOOST_TEST(differ == 0);
}

BOOST_AUTO_TEST_CASE(about_a_principal_axis_it_turns_steadily) {
  for (Vector3d const& I : {Vector3d(0.6, 0.8, 1), Vector3d(1, 0.6, 0.8), Vector3d(0.8, 1, 0.6),
                            Vector3d(1e-6, 1, 1 + 1e-6), Vector3d(1, 1 + 1e-12, 2)})
    for (int axis = 0; axis < 3; ++axis)
      for (double const spin : {1.0, -1.0, 1e-12, -1e6}) {
        auto const body = body_of(I, spin * I[axis] * Vector3d::Unit(axis));
        for (double const angle : {1e-10, 0.5, M_PI, -4.0, 2 * M_PI, 1000.0}) {
          auto const s = body.at(angle / spin);
          BOOST_TEST((momentum_of(s) - momentum_of(body.at(0))).norm() <= 4 * eps * body.magnitude());
          auto const expected = exp(velocity(SU2{}, Vector3d(angle * Vector3d::Unit(axis))));
          BOOST_TEST(std::min((s.attitude.value - expected.value).norm(),
                              (s.attitude.value + expected.value).norm()) <= 4 * eps * (1 + std::abs(angle)));
          keeps_what_is_kept(body, s);
        }
      }
}

BOOST_AUTO_TEST_CASE(whatever_the_body_momentum_and_energy_stay) {
  testing::HardProblems problems(testing::seed);
  int missed = 0;
  for (int repeat = 0; repeat < 10000; ++repeat) {
    auto const p = problems.next(1e6);
    auto const body = p.body();
    auto const s = body.at(p.time);
    double energy = 0, start = 0;
    for (int i = 0; i < 3; ++i) {
      energy += momentum_of(s)[i] / body.magnitude() * (momentum_of(s)[i] / p.moments[i]),
          start += p.momentum[i] / body.magnitude() * (p.momentum[i] / p.moments[i]);
    }
    double const size = body.magnitude(),
                 slack = (s.spatial_momentum().components - body.at(0).spatial_momentum().components).norm() /
                         size;
    // Of a component next to zero the rounding is one of the amount: in the energy it is multiplied by the
    // largest 1/I.
    double const stiff = 1 / std::min({p.moments[0], p.moments[1], p.moments[2]});
    if (!(slack <= 32 * eps) || !(std::abs(momentum_of(s).norm() / size - 1) <= 16 * eps) ||
        !(std::abs(energy - start) <= 64 * eps * std::sqrt(stiff * start) + 64 * eps * eps * stiff))
      ++missed, BOOST_TEST_MESSAGE("problem " << repeat << ": momentum in space " << slack << ", energy "
                                              << energy / start - 1);
  }
  BOOST_TEST(missed == 0);
}

BOOST_AUTO_TEST_CASE(two_flows_compose_to_one) {
  testing::HardProblems problems(testing::seed + 1);
  int judged = 0;
  for (int repeat = 0; repeat < 2000; ++repeat) {
    auto const p = problems.next(3);
    auto const body = p.body();
    // Half of the way, then the other half from there, as another body.
    auto const middle = body.at(p.time / 2), end = body.at(p.time);
    auto const again = FreeBody(body.inertia(), middle.body_momentum, middle.attitude).at(p.time / 2);
    auto const back = FreeBody(body.inertia(), end.body_momentum, end.attitude).at(-p.time);
    // The place in the middle is rounded, a component next to zero by the amount: in turns about the axis of
    // the least moment that is the rate at full momentum.
    double const angle =
        std::abs(p.time) * body.magnitude() / std::min({p.moments[0], p.moments[1], p.moments[2]});
    if (angle > 1e3) continue;
    ++judged;
    if (!(differ(end, again) <= 32 * eps * (1 + angle) * std::exp(std::min(angle, 3.0))))
      BOOST_ERROR("problem " << repeat << ": two halves are off by " << differ(end, again) << " at angle "
                             << angle);
    if (!(differ(back, body.at(0)) <= 32 * eps * (1 + angle) * std::exp(std::min(angle, 3.0))))
      BOOST_ERROR("problem " << repeat << ": there and back is off by " << differ(back, body.at(0))
                             << " at angle " << angle);
  }
  BOOST_TEST(judged > 1000);
}

BOOST_AUTO_TEST_CASE(the_names_of_the_axes_do_not_matter) {
  Vector3d const I(0.6, 0.8, 1), M(0.9, 0.3, -0.5);
  Eigen::Vector4d const q = Eigen::Vector4d(0.7, -0.1, 0.3, 0.6).normalized();
  int const orders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {1, 0, 2}, {0, 2, 1}, {2, 1, 0}};
  for (double const t : {0.05, 3.0, 500.0}) {
    auto const usual = body_of(I, M, q).at(t);
    for (auto const& o : orders) {
      // An odd exchange is a reflection: momentum and the vector of the quaternion are axial and change their
      // sign.
      bool const odd = (o[1] - o[0] + 3) % 3 != 1;
      double const sign = odd ? -1 : 1;
      Vector3d Io, Mo;
      Eigen::Vector4d qo(q[0], 0, 0, 0);
      for (int i = 0; i < 3; ++i) Io[i] = I[o[i]], Mo[i] = sign * M[o[i]], qo[1 + i] = sign * q[1 + o[i]];
      auto const other = body_of(Io, Mo, qo).at(t);
      FreeState named = usual;
      for (int i = 0; i < 3; ++i)
        named.body_momentum.components[i] = sign * momentum_of(usual)[o[i]],
        named.attitude.value[1 + i] = sign * usual.attitude.value[1 + o[i]];
      // The magnitude of the momentum is summed in another order.
      BOOST_TEST(differ(named, other) <= 8 * eps * (1 + t));
    }
  }
}

BOOST_AUTO_TEST_CASE(bodies_of_every_size_give_the_same_digits) {
  Vector3d const I(0.6, 0.8, 1), spin(0.7, -0.4, 0.5);
  auto const motion = [&](double mass, double pace) {
    auto const body = body_of(I * mass, (spin.cwiseProduct(I) * mass * pace).eval());
    FreeSteps steps(body, 0.25 / pace);
    steps.advance(1000);
    return std::array<FreeState, 2>{body.at(7 / pace), steps.state()};
  };
  auto const usual = motion(1, 1);
  for (int const k : {-156, -40, 30, 156}) {
    auto const other = motion(std::ldexp(1.0, k), std::ldexp(1.0, -k / 4));
    for (int i = 0; i < 2; ++i) BOOST_TEST((other[i].attitude.value == usual[i].attitude.value));
  }
  for (double const mass : {1e-47, 1e47})
    for (double const pace : {1e-12, 1e6, 1e12}) {
      auto const other = motion(mass, pace);
      BOOST_TEST((other[0].attitude.value - usual[0].attitude.value).norm() <= 64 * eps * 7);
      BOOST_TEST((other[1].attitude.value - usual[1].attitude.value).norm() <= 64 * eps * 250);
      BOOST_TEST((momentum_of(other[0]) / (mass * pace) - momentum_of(usual[0])).norm() <= 64 * eps * 7);
    }
}

BOOST_AUTO_TEST_CASE(a_quaternion_and_its_negative_move_alike) {
  Vector3d const I(0.6, 0.8, 1), M(0.9, 0.3, -0.5);
  Eigen::Vector4d const q = Eigen::Vector4d(0.7, -0.1, 0.3, 0.6).normalized();
  for (double const t : {0.1, 10.0, 1e4}) {
    auto const a = body_of(I, M, q).at(t), b = body_of(I, M, -q).at(t);
    BOOST_TEST((a.attitude.value == -b.attitude.value));
    BOOST_TEST((momentum_of(a) == momentum_of(b)));
    // The attitude at the start goes in on the left, and nowhere else.
    auto const unturned = body_of(I, M).at(t);
    BOOST_TEST((a.attitude.value - SU2::compose<double>(q, unturned.attitude.value)).norm() <= 8 * eps);
  }
}

BOOST_AUTO_TEST_CASE(on_the_separatrix_it_ends_on_the_middle_axis) {
  // 1/2, 2/3 and 1: J = 2, 3/2, 1, so that M1 = M3 is on the separatrix without a rounding in the moments'
  // differences.
  Vector3d const I(0.5, 2.0 / 3, 1);
  for (Vector3d const& M : {Vector3d(1, 0, 1), Vector3d(1, 1, 1), Vector3d(-1, 1e-3, 1),
                            Vector3d(1e-8, 1, 1e-8), Vector3d(1e-3, -1, 1e-3)})
    for (double const t : {0.1, 3.0, 30.0, -30.0, 200.0})
      keeps_what_is_kept(body_of(I, M), body_of(I, M).at(t));
  // M2 = sqrt(2) tanh(t/sqrt(2)) from (1, 0, 1).
  auto const body = body_of(I, Vector3d(1, 0, 1));
  for (double const t : {0.1, 1.0, 4.0, 10.0, -2.0}) {
    double const rate = 0.5, L = std::sqrt(2.0), expected = L * std::tanh(rate * L * t);
    // M2' = (J1 - J3) M1 M3 = M1 M3: positive at the start. A rounding in I2 takes it off the separatrix by
    // as much, times exp(rate L t).
    BOOST_TEST(std::abs(momentum_of(body.at(t))[1] - expected) <=
               64 * eps * std::exp(2 * rate * L * std::abs(t)));
  }
  // On the middle axis it stays, for ever; next to it, it leaves when it must.
  auto const still = body_of(I, Vector3d(0, 1, 0));
  for (double const t : {1.0, 1e3, 1e6}) BOOST_TEST((momentum_of(still.at(t)) == Vector3d(0, 1, 0)));
  auto const kicked = body_of(I, Vector3d(1e-16, 1, 0));
  BOOST_TEST(momentum_of(kicked.at(10))[1] > 1 - 1e-12);
  double least = 1;
  for (double t = 0; t < 200; t += 0.5) {
    auto const s = kicked.at(t);
    least = std::min(least, momentum_of(s)[1]);
    keeps_what_is_kept(kicked, s);
  }
  BOOST_TEST(least < -0.99);
}

BOOST_AUTO_TEST_CASE(half_turns_half_periods_and_very_long_times) {
  Vector3d const I(0.6, 0.8, 1);
  for (Vector3d const& M : {Vector3d(0.2, 0.3, 1), Vector3d(1, 0.3, 0.2), Vector3d(1e-9, 1, 1e-9)}) {
    auto const body = body_of(I, M);
    // The quarter period, from the moments and the momentum.
    Vector3d const J = I.cwiseInverse(), u = M.normalized();
    double const H = J[0] * u[0] * u[0] + J[1] * u[1] * u[1] + J[2] * u[2] * u[2], a = J[0] - H, b = H - J[2],
                 beside = (J[0] - J[1]) * u[0] * u[0] - (J[1] - J[2]) * u[2] * u[2];
    bool const third = beside < 0;
    double const square = third ? (J[1] - J[2]) * a : (J[0] - J[1]) * b,
                 complement = (J[0] - J[2]) * std::abs(beside) / square;
    double const quarter =
        JacobiFunctions<double>(complement).quarter_period() / std::sqrt(square) / M.norm();
    for (int const quarters : {1, 2, 3, 4, 8, 400}) {
      auto const s = body.at(quarters * quarter);
      keeps_what_is_kept(body, s);
      if (quarters % 2) continue;
      // Two components change their signs in half a period: M2, and the one whose axis the orbit does not
      // enclose.
      Vector3d expected = quarters % 4 == 0 ? M
                          : third           ? Vector3d(-M[0], -M[1], M[2])
                                            : Vector3d(M[0], -M[1], -M[2]);
      BOOST_TEST((momentum_of(s) - expected).norm() <=
                 64 * eps * quarters * quarter * M.norm() * std::max(1.0, 1 / std::sqrt(complement)));
      // Steps of that length: to and fro.
      FreeSteps motion(body, quarters * quarter);
      motion.advance(1000);
      keeps_what_is_kept(body, motion.state(), 4);
    }
    for (double const t : {1e15, -1e15, 1e100, 1e300}) keeps_what_is_kept(body, body.at(t));
  }
}

// Near the middle axis a body is near the separatrix, whatever its moments; on other orbits it is not, also
// where the moments hardly differ, so that the separatrix is near in absolute numbers.
BOOST_AUTO_TEST_CASE(near_the_separatrix_is_told_relative_to_the_orbit) {
  for (Vector3d const& I : {Vector3d(0.6, 0.8, 1), Vector3d(0.1, 0.95, 1), Vector3d(0.999, 1, 1.001)}) {
    BOOST_TEST(body_of(I, Vector3d(1e-3, 1, 1e-3)).near_separatrix());
    BOOST_TEST(!body_of(I, Vector3d(1, 0.1, 0.1)).near_separatrix());
    BOOST_TEST(!body_of(I, Vector3d(0.1, 0.1, 1)).near_separatrix());
  }
}

// With the parameters of the scheme the steps are those of the scheme by the generic implementation, which at
// this length departs from the exact motion by a thousandth.
BOOST_AUTO_TEST_CASE(steps_with_the_parameters_of_a_scheme_are_its_steps) {
  Vector3d const I(0.6, 0.8, 1), M(0.3, -0.7, 0.45);
  auto const body = body_of(I, M);
  double const h = 0.25;
  int const steps = 40;
  FreeSteps motion(body, h, body.moser_veselov_parameters(h, 2));
  motion.advance(steps);
  MoserVeselov<3> const scheme(inertia_from_moments<double>(I), h);
  Momentum<SO<3>, double> momentum{SO<3>{}, M};
  for (int k = 0; k < steps; ++k) momentum = scheme.step_lie_poisson(momentum);
  BOOST_TEST((motion.body_momentum().components - momentum.components).norm() <= 64 * eps * steps);
  BOOST_TEST((momentum_of(body.at(steps * h)) - momentum.components).norm() > 1e-4);
}

BOOST_AUTO_TEST_CASE(rest_and_next_to_rest) {
  Vector3d const I(0.6, 0.8, 1);
  Eigen::Vector4d const q = Eigen::Vector4d(0.7, -0.1, 0.3, 0.6).normalized();
  auto const rest = body_of(I, Vector3d::Zero(), q);
  for (double const t : {0.0, 1.0, -1e300}) {
    BOOST_TEST((rest.at(t).attitude.value - q).norm() <= 2 * eps);
    BOOST_TEST(momentum_of(rest.at(t)).norm() == 0);
  }
  FreeSteps motion(rest, 0.1);
  motion.advance(5000);
  BOOST_TEST((motion.state().attitude.value - q).norm() <= 2 * eps);
  BOOST_CHECK_NO_THROW(rest.moser_veselov_parameters(1e6, 2));
  // Denormal momenta: with few digits, but a direction; and at the other end of the numbers.
  for (double const tiny : {5e-324, 1e-320, 1e-310, 1e-300}) {
    auto const body = body_of(I, Vector3d(tiny, -tiny, tiny));
    keeps_what_is_kept(body, body.at(0), 4 / eps * std::min(1.0, 5e-324 / tiny) + 1);
    auto const s = body.at(1 / tiny < 1e308 ? 1 / tiny : 1e308);
    BOOST_TEST(std::abs(s.attitude.value.norm() - 1) <= 4 * eps);
    BOOST_TEST(is_finite(momentum_of(s)));
  }
  auto const huge = body_of(I * 1e300, Vector3d(3e300, -2e300, 1e300));
  keeps_what_is_kept(huge, huge.at(3));
  BOOST_TEST((body_of(I, Vector3d(1, 2, 3)).at(0).attitude.value == Eigen::Vector4d(1, 0, 0, 0)));
}

BOOST_AUTO_TEST_CASE(input_that_has_no_answer_is_refused) {
  Vector3d const I(0.6, 0.8, 1), M(0.9, 0.3, -0.5);
  double const nan = std::nan(""), inf = INFINITY;
  for (double const bad : {nan, inf, -inf}) {
    CHECK_REFUSED(body_of(I, Vector3d(1, bad, 0)), NotFinite);
    CHECK_REFUSED(body_of(Vector3d(1, bad, 1), M), NotFinite);
    CHECK_REFUSED(body_of(I, M, {1, 0, bad, 0}), Error);
    auto const body = body_of(I, M);
    CHECK_REFUSED(body.at(bad), NotFinite);
    CHECK_REFUSED(body.step_parameters(bad), NotFinite);
    CHECK_REFUSED(body.moser_veselov_parameters(bad, 2), NotFinite);
    CHECK_REFUSED(FreeSteps(body, bad), NotFinite);
  }
  CHECK_REFUSED(body_of(I, Vector3d(1e308, 1e308, 1.7e308)), NotFinite);
  CHECK_REFUSED(body_of(I * 1e-200, Vector3d(1e200, 0, 0)), NotFinite);
  CHECK_REFUSED(body_of(I, Vector3d(1e300, 0, 0)).at(1e300), NotFinite);
  CHECK_REFUSED(FreeSteps(body_of(I, M), 0.0), OutsideDomain);
  CHECK_REFUSED(body_of(I, M, {1, 1, 0, 0}), OutsideDomain);
  CHECK_REFUSED(body_of(I, M, {0, 0, 0, 0}), OutsideDomain);
  for (int const order : {0, 1, 3, -2, 42})
    CHECK_REFUSED(body_of(I, M).moser_veselov_parameters(0.1, order), OutsideDomain);
  // Water from its rotational constants: more inertia about one axis than about the other two together. The
  // defect is named.
  try {
    body_of(Vector3d(0.604715, 1.161634, 1.815577), M);
    BOOST_ERROR("accepted moments that no body has");
  } catch (UnphysicalInertia const& error) {
    BOOST_TEST(std::abs(error.measured - (1.815577 - 1.161634 - 0.604715) / 1.815577) <= 1e-12);
    BOOST_TEST(std::string(error.what()).find("I_3") != std::string::npos);
  }
  // Its moments as a generalized body of chapter 5 are another matter: Lambda_i + Lambda_j > 0 is all that J
  // asks for.
  auto const water = inertia_from_lambda<3, double>(Vector3d(1.186248, 0.629329, -0.024614));
  FreeBody const body(water, {SO<3>{}, M});
  keeps_what_is_kept(body, body.at(12));
  BOOST_CHECK_NO_THROW(body.moser_veselov_parameters(0.01, 2));
  try {
    body.moser_veselov_parameters(100, 2);
    BOOST_ERROR("accepted a step beyond the longest");
  } catch (StepTooLong const& error) {
    BOOST_CHECK_NO_THROW(body.moser_veselov_parameters(0.999999 * error.largest_step, 2));
    CHECK_REFUSED(body.moser_veselov_parameters(1.000001 * error.largest_step, 2), StepTooLong);
  }
  // An inertia that was not checked must not make it hang.
  CHECK_REFUSED(FreeBody(Inertia<3>{{}, Vector3d(1, 1, 1), Vector3d(nan, 1, 1)}, {SO<3>{}, M}), NotFinite);
}

BOOST_AUTO_TEST_CASE(schemes_of_every_order_refuse_steps_that_have_no_solution) {
  auto const body = body_of(Vector3d(0.6, 0.8, 1), Vector3d(0.9, 0.3, -0.5));
  for (int const order : {2, 4, 6, 8, 10}) {
    double h = 0.05;
    while (h < 100) {
      try {
        auto const parameters = body.moser_veselov_parameters(h, order);
        BOOST_TEST(is_finite(parameters.cos_twist));
        BOOST_TEST(std::abs(parameters.cos_twist * parameters.cos_twist +
                            parameters.sin_twist * parameters.sin_twist - 1) <= 8 * eps);
        h *= 1.5;
      } catch (StepTooLong const& error) {
        // What it offers does.
        BOOST_TEST(error.largest_step < h);
        BOOST_TEST(error.largest_step > 0);
        BOOST_CHECK_NO_THROW(body.moser_veselov_parameters(0.9999999 * error.largest_step, order));
        break;
      }
    }
  }
}

// A body that is heavier turns alike where its momentum is larger by as much, and so does each step.
BOOST_AUTO_TEST_CASE(the_longest_step_does_not_depend_on_the_unit_of_mass) {
  Vector3d const I(0.6, 0.8, 1), M(0.9, 0.3, -0.5);
  auto const longest = [&](double unit, int order) {
    try {
      body_of(unit * I, unit * M).moser_veselov_parameters(1000, order);
    } catch (StepTooLong const& error) {
      return error.largest_step;
    }
    return 0.0;
  };
  for (int const order : {4, 6, 10}) {
    double const one = longest(1, order);
    BOOST_TEST(one > 0);
    // Bisection ends at a width of 1e-12.
    for (double const unit : {1e-6, 1e-3, 1e3, 1e6})
      BOOST_TEST(std::abs(longest(unit, order) / one - 1) <= 1e-11);
  }
}

BOOST_AUTO_TEST_CASE(next_to_a_steady_turn_the_setting_back_disturbs_nothing) {
  // A turn about the axis of the largest moment that wobbles by 1e-6: the gradients of magnitude and energy
  // are nearly parallel, and what they are set back by must not be rounding.
  auto const body = body_of(Vector3d(0.36836901187385251, 0.36840266704489788, 4.0490418486419611e-05),
                            Vector3d(-4.648010031437658e-9, -1, 6.3513638317865446e-10));
  FreeSteps motion(body, -2.5 / 1024);
  for (int k = 0; k < 16; ++k) {
    motion.advance(256);
    BOOST_TEST((momentum_of(motion.state()) - momentum_of(body.at(-2.5 / 4 * (k + 1)))).norm() <= 8 * eps);
  }
}

BOOST_AUTO_TEST_CASE(long_steps_next_to_the_separatrix_are_evaluated_from_the_start) {
  auto const body = body_of({0.6, 0.8, 1}, {1e-3, 1, 2e-3});
  BOOST_TEST(body.near_separatrix());
  for (double const h : {16.0, -16.0}) {
    BOOST_TEST(std::abs(h) * body.pace() > 4);
    FreeSteps motion(body, h);
    for (int k = 1; k <= 3; ++k) {
      motion.advance(k);
      int const taken = k * (k + 1) / 2;
      BOOST_TEST((momentum_of(motion.state()) == momentum_of(body.at(taken * h))));
      BOOST_TEST((motion.state().attitude.value == body.at(taken * h).attitude.value));
    }
  }
}

BOOST_AUTO_TEST_CASE(steps_and_one_evaluation_agree) {
  for (Vector3d const& I :
       {Vector3d(0.6, 0.8, 1), Vector3d(1, 0.8, 0.6), Vector3d(0.8, 1, 0.6), Vector3d(1, 1, 1),
        Vector3d(1, 1, 1.6), Vector3d(0.3, 1, 1), Vector3d(0.6, 0.8, 1.4)})
    for (double const h : {0.01, 0.3, -2.0, 50.0}) {
      Vector3d const M = Vector3d(0.7, 0.4, -0.6).cwiseProduct(I);
      auto const body = body_of(I, M);
      FreeSteps motion(body, h), alone(body, h), one(body, h);
      motion.advance(3000), alone.advance_momentum(3000);
      for (int k = 0; k < 3000; ++k) one.advance();
      // The step is rounded: an error of the phase in proportion to the angle.
      double const room = 64 * eps * (1 + 3000 * std::abs(h) * 2);
      BOOST_TEST(differ(motion.state(), body.at(3000 * h)) <= room);
      BOOST_TEST((motion.state().attitude.value == one.state().attitude.value));
      motion.advance(0), motion.advance(-5);
      BOOST_TEST((motion.state().attitude.value == one.state().attitude.value));
      BOOST_TEST((alone.body_momentum() - motion.body_momentum()).components.norm() <= room);
      // The attitude is unknown after steps without it: asking for it is refused.
      CHECK_REFUSED(alone.state(), OutsideDomain);
      CHECK_REFUSED(alone.advance(), OutsideDomain);
    }
}

BOOST_AUTO_TEST_SUITE_END()
