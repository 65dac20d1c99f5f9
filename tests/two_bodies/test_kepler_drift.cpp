// Kepler's motion by the universal variable against orbits that are known by their eccentric anomaly.
#include <boost/test/unit_test.hpp>

#include "actio/numbers/derivative.hpp"
#include "actio/numbers/multiprecision.hpp"
#include "actio/two_bodies/kepler_drift.hpp"
#include "refused.hpp"

using namespace actio;
using namespace actio::bodies;

namespace {
/// A point of the orbit with half axis 1 and mu = 1, at an eccentric anomaly; the other branch for e > 1.
struct Orbiting {
  Three<dec50> x, v;
  dec50 time;
  Orbiting(dec50 const& e, dec50 const& E) {
    bool const closed = e < 1;
    dec50 const c = closed ? dec50(cos(E)) : dec50(cosh(E)), s = closed ? dec50(sin(E)) : dec50(sinh(E)),
                b = closed ? dec50(sqrt(1 - e * e)) : dec50(sqrt(e * e - 1)),
                r = closed ? dec50(1 - e * c) : dec50(e * c - 1);
    x = {closed ? dec50(c - e) : dec50(e - c), b * s, 0};
    v = {-s / r, b * c / r, 0};
    time = closed ? dec50(E - e * s) : dec50(e * s - E);
  }
};
}  // namespace

BOOST_AUTO_TEST_SUITE(kepler_drift_of_points)

BOOST_AUTO_TEST_CASE(ellipses_and_hyperbolas_are_met_in_double_and_in_fifty_digits) {
  double const eps = std::numeric_limits<double>::epsilon();
  double worst = 0, worst_of_many = 0;
  for (double const e : {0.01, 0.3, 0.9, 0.999, 1.001, 1.5, 4.0})
    for (double const from : {0.0, -1.0, 2.5})
      for (double const by : {1e-4, 0.1, 1.0, 3.0, -0.4, 40.0}) {
        if (e > 1 && std::abs(by) > 3) continue;
        Orbiting const a(e, from), b(e, dec50(from) + by);
        dec50 const t = b.time - a.time;
        auto const many = kepler_drift<dec50>(a.x, a.v, dec50(1), t);
        Three<double> x, v;
        for (int i = 0; i < 3; ++i) x[i] = static_cast<double>(a.x[i]), v[i] = static_cast<double>(a.v[i]);
        auto const few = kepler_drift<double>(x, v, 1, static_cast<double>(t));
        // Rounding of the start is magnified by the motion: by the angle, and by the speed at the pericentre.
        double size = 0, off = 0, off_of_many = 0;
        for (int i = 0; i < 3; ++i) {
          size += static_cast<double>(abs(b.x[i] - a.x[i]) + abs(b.v[i] - a.v[i]));
          off += std::abs(static_cast<double>(b.x[i] - a.x[i]) - few.position[i]) +
                 std::abs(static_cast<double>(b.v[i] - a.v[i]) - few.velocity[i]);
          off_of_many += static_cast<double>(abs(b.x[i] - a.x[i] - many.position[i]) +
                                             abs(b.v[i] - a.v[i] - many.velocity[i]));
        }
        double const near = 1 / std::abs(1 - e);
        double const room = 100 * near * near * (1 + std::abs(by)) * (1 + std::exp(e > 1 ? std::abs(by) : 0));
        worst = std::max(worst, off / room / eps),
        worst_of_many = std::max(worst_of_many, off_of_many / room / 1e-50);
        BOOST_TEST(off <= room * eps * (size + eps));
        BOOST_TEST(off_of_many <= room * 1e-47 * (size + 1e-40));
      }
  BOOST_TEST_MESSAGE("Kepler drift: off by " << worst << " of the allowed in double, " << worst_of_many / 1000
                                             << " in 50 digits");
}

BOOST_AUTO_TEST_CASE(dual_numbers_give_the_derivative_of_the_motion) {
  // By the time: the velocity; by mu, over which all lengths scale: x(t; mu) with t = mu^(-1/2) t1 at fixed
  // shape.
  using D = Dual<double>;
  Three<double> const x{1, 0.2, -0.1}, v{0.1, 0.9, 0.3};
  for (double const t : {0.3, -2.0, 9.0}) {
    auto const lifted = [](Three<double> const& y) { return Three<D>{D(y[0]), D(y[1]), D(y[2])}; };
    auto const at = kepler_drift<D>(lifted(x), lifted(v), D(1), variable(t));
    for (int i = 0; i < 3; ++i)
      BOOST_TEST(std::abs(at.position[i].part[0] - (v[i] + at.velocity[i].value)) <= 1e-13);
    // x(t; s^2 mu, s v) = x(s t; mu, v): the derivative by s at 1 is t times the velocity.
    D const s = variable(1.0);
    auto const scaled = kepler_drift<D>(lifted(x), {s * v[0], s * v[1], s * v[2]}, s * s, D(t));
    for (int i = 0; i < 3; ++i)
      BOOST_TEST(std::abs(scaled.position[i].part[0] - t * (v[i] + at.velocity[i].value)) <= 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(a_fall_into_the_centre_that_is_met_is_no_number) {
  auto const fall = kepler_drift<double>({1, 0, 0}, {0, 0, 0}, 1, 0.5);  // before the centre, at 1.11
  BOOST_TEST(std::abs(fall.position[0]) < 0.2);
  CHECK_REFUSED(kepler_drift<double>({1, 0, 0}, {0, std::nan(""), 0}, 1, 0.5), NotConverged);
}

BOOST_AUTO_TEST_SUITE_END()
