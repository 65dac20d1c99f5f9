// Friction that keeps a structure: damping against GSL and over many steps, along the free motion and not,
// and friction on the coadjoint orbit against the law of a symmetric body.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "actio/any_group/level_integrator.hpp"
#include "actio/reduction/composition.hpp"
#include "forced_reference.hpp"
#include "refused.hpp"

using namespace actio;
using namespace actio::systems;
using namespace actio::testing;

namespace {

System with_dissipation(System const& of, Dissipation friction) {
  auto out = std::make_shared<ReducedSystem>(*of);
  out->dissipation = std::move(friction);
  return out;
}
System damped_by_a_force(System const& of, double rate) {
  std::vector<std::string> drag;
  for (auto const& v : of->algebra.components) drag.push_back("-" + std::to_string(rate) + "*p_" + v);
  return with_force(of, drag);
}
List after(System const& system, List const& fractions, int steps, double time, List const& v,
           List const& a) {
  ChartIntegrator run(system, time / steps, fractions, point_at(*system, v, a), v);
  for (int k = 0; k < steps; ++k) run.step();
  List end = run.point().momentum;
  end.insert(end.end(), run.point().vectors.begin(), run.point().vectors.end());
  return end;
}

/// A body with two equal moments, and friction on its orbit.
double const I1 = 1, I3 = 1.6, friction = 0.05;
System symmetric_body() {
  return with_dissipation(own_system("SO(3)", Side::left, "(w1^2 + w2^2 + 1.6*w3^2)/2"),
                          {Dissipation::Kind::orbit, friction, Square::Identity(3, 3)});
}
double tangent_of_nutation(List const& p) { return std::hypot(p[0], p[1]) / p[2]; }

}  // namespace

BOOST_AUTO_TEST_SUITE(dissipation)

BOOST_AUTO_TEST_CASE(which_motions_are_damped_along_their_free_motion) {
  BOOST_TEST(damps_along_free_motion(*free_system("SE(3)", Side::left)));
  BOOST_TEST(!damps_along_free_motion(*own_system("SO(3)", Side::left, "(w1^2 + w2^2 + w3^2)/2 + w1")));
  BOOST_TEST(!damps_along_free_motion(*own_system("SO(3)", Side::left, "(w1^2 + w2^2 + w3^2)/2 + w1^4")));
  BOOST_TEST(!damps_along_free_motion(*own_system("SO(3)", Side::left, "(w1^2 + w2^2 + w3^2)/2 - a3", true)));
}

BOOST_AUTO_TEST_CASE(damping_along_the_free_motion_meets_gsl_by_each_method) {
  for (Side const side : {Side::left, Side::right}) {
    System const free = free_system("SE(3)", side),
                 damped = with_dissipation(free, {Dissipation::Kind::conformal, 0.3});
    List const v = uneven(6, 0.6), truth = by_gsl(damped_by_a_force(free, 0.3), point_at(*free, v), 2);
    for (int const order : {2, 4, 6}) {
      List const fractions = order == 2 ? List{1} : order == 4 ? suzuki<double>() : kahan_li<double>();
      List errors;
      for (int const steps : {10, 20})
        errors.push_back(largest(minus(after(damped, fractions, steps, 2, v, {}), truth)));
      BOOST_TEST_CONTEXT("order " << order << ": " << errors[0] << " " << errors[1])
      BOOST_TEST(std::abs(slope(errors) - order) < 0.25);
    }
    LevelIntegrator level(damped, 0.02, point_at(*damped, v), v);
    for (int k = 0; k < 100; ++k) level.step();
    BOOST_TEST(largest(minus(level.point().momentum, truth)) < 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(a_damped_top_has_the_order_of_the_free_one) {
  char const* const top = "(w1^2 + 1.5*w2^2 + 0.5*w3^2)/2 - 2*a3 - a1";
  List const v{0.5, 0.2, 3}, a{0.1, -0.3, -1};
  for (Side const side : {Side::left, Side::right}) {
    System const free = own_system("SO(3)", side, top, true),
                 damped = with_dissipation(free, {Dissipation::Kind::conformal, 0.2});
    List const truth = by_gsl(damped_by_a_force(free, 0.2), point_at(*free, v, a), 1);
    for (int const order : {2, 4}) {
      List errors;
      for (int const steps : {80, 160})
        errors.push_back(
            largest(minus(after(damped, order == 2 ? List{1} : suzuki<double>(), steps, 1, v, a), truth)));
      BOOST_TEST_CONTEXT("order " << order << ": " << errors[0] << " " << errors[1])
      BOOST_TEST(std::abs(slope(errors) - order) < 0.1);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_length_of_a_damped_momentum_decays_as_the_exponential) {
  int const steps = 20000;
  double const rate = 1e-4, h = 0.05;
  System const damped =
      with_dissipation(free_system("SO(3)", Side::left), {Dissipation::Kind::conformal, rate});
  List const v = uneven(3, 0.6);
  ChartIntegrator run(damped, h, {1}, point_at(*damped, v), v);
  auto const length = [&] { return Eigen::Map<Eigen::Vector3d const>(run.point().momentum.data()).norm(); };
  double const before = length();
  for (int k = 0; k < steps; ++k) run.step();
  // Each step rounds its decay, and twice the momentum.
  BOOST_TEST(std::abs(length() / (before * std::exp(-rate * h * steps)) - 1) < 4 * eps * steps);
}

BOOST_AUTO_TEST_CASE(friction_on_the_orbit_of_a_symmetric_body_follows_its_law) {
  System const body = symmetric_body();
  List const v{0.6, 0.2, 0.5};
  auto const start = point_at(*body, v);
  double const L = Eigen::Map<Eigen::Vector3d const>(start.momentum.data()).norm(), time = 20;
  double const truth =
      tangent_of_nutation(start.momentum) * std::exp(-friction * (1 / I1 - 1 / I3) * L * L * time);
  List errors;
  for (int const steps : {20, 40, 80}) {
    ChartIntegrator run(body, time / steps, {1}, start, v);
    for (int k = 0; k < steps; ++k) run.step();
    errors.push_back(std::abs(tangent_of_nutation(run.point().momentum) - truth));
  }
  BOOST_TEST_CONTEXT(errors[0] << " " << errors[1] << " " << errors[2])
  BOOST_TEST(std::abs(slope(errors) - 2) < 0.1);
}

BOOST_AUTO_TEST_CASE(friction_on_the_orbit_conserves_casimirs_and_takes_energy) {
  // Symmetric bodies have steps of the natural chart that conserve the energy, so that friction alone changes
  // it.
  System const body = symmetric_body();
  List const v{0.6, 0.2, 0.5};
  int const steps = 20000;
  ChartIntegrator run(body, 0.02, {1}, point_at(*body, v), v);
  auto const squared = [&] {
    return Eigen::Map<Eigen::Vector3d const>(run.point().momentum.data()).squaredNorm();
  };
  LegendreVelocity legendre(*body);
  List velocity = v;
  double const before = squared();
  double last = legendre.energy(v, {}), rise = 0;
  for (int k = 0; k < steps; ++k) {
    run.step();
    legendre.solve(run.point().momentum, {}, velocity);
    double const energy = legendre.energy(velocity, {});
    rise = std::max(rise, energy - last), last = energy;
  }
  BOOST_TEST(std::abs(squared() / before - 1) < 16 * eps * steps);
  BOOST_TEST(rise < 16 * eps);
  BOOST_TEST(std::abs(last - before / (2 * I3)) < 1e-6);
}

BOOST_AUTO_TEST_CASE(steps_on_a_level_take_no_force_and_no_other_friction) {
  System const free = free_system("SO(3)", Side::left);
  List const v{0.6, 0.2, 0.5};
  auto const level = [&](System const& system) { LevelIntegrator(system, 0.1, point_at(*system, v), v); };
  BOOST_CHECK_NO_THROW(level(free));
  BOOST_CHECK_THROW(level(with_force(free, {"w1", "0", "0"})), OutsideDomain);
  BOOST_CHECK_THROW(level(symmetric_body()), OutsideDomain);
}

BOOST_AUTO_TEST_CASE(friction_that_turns_too_far_in_a_step_is_refused) {
  System const body = with_dissipation(own_system("SO(3)", Side::left, "(w1^2 + w2^2 + 1.6*w3^2)/2"),
                                       {Dissipation::Kind::orbit, 1e4, Square::Identity(3, 3)});
  List const v{0.6, 0.2, 0.5};
  ChartIntegrator run(body, 0.5, {1}, point_at(*body, v), v);
  BOOST_CHECK_THROW(run.step(), Error);
}

BOOST_AUTO_TEST_SUITE_END()
