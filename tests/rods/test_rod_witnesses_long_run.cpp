// Rods against motions that are known exactly and against other methods: a helix, waves, a ring, a bent
// cantilever, generalised-alpha and a reference by step control.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "book/measure.hpp"
#include "witness/generalised_alpha.hpp"
#include "witness/rod_solutions.hpp"

using namespace actio;
using namespace actio::rods;

namespace {

using List = std::vector<double>;

RodSection const thick{{60, 25, 25}, {0.5, 0.8, 0.8}, 1, {0.06, 0.03, 0.03}},
    other{{80, 30, 20}, {0.7, 1.1, 0.6}, 1.3, {0.05, 0.02, 0.04}};

/// Residuals of the balance of forces and moments of a section of a discrete helix, by the functions of the
/// library in space and the momenta of Moser and Veselov in time.
Six residuals(RodSection const& section, RotatingHelix const& helix, double D, double h) {
  auto const element = [&](double s) {
    auto const a = helix.at(s, 0), b = helix.at(s + D, 0);
    auto const dx = plus_times(b.place, -1.0, a.place);
    auto const e = RelativePlacement<double>::of(a.attitude, b.attitude, dx);
    auto const strain = element_strain(e, ElementAtRest<double>{1 / D, {1, 0, 0}, {}});
    auto out =
        element_force(e, times(section.stretching, strain.Gamma), times(section.bending, strain.kappa));
    out.n = turned(a.attitude, out.n);
    return out;
  };
  auto const after = element(0), before = element(-D);
  auto const last = helix.at(0, -h), now = helix.at(0, 0), next = helix.at(0, h);
  // The momentum that leaves with a turn e is (2/h)(e0 I v + v x I v), the one that arrives has the minus.
  auto const momentum = [&](Placement const& from, Placement const& to, double sign) {
    auto const e = bodies::compose(inverse_turn(from.attitude), to.attitude);
    Three<double> const v{e[1], e[2], e[3]}, y = times(section.inertia, v);
    return times(2 * D / h, plus_times(times(e[0], y), sign, cross(v, y)));
  };
  auto const leaving = momentum(now, next, 1), arriving = momentum(last, now, -1);
  Six out;
  for (std::size_t i = 0; i < 3; ++i) {
    double const change = section.mass * D * (next.place[i] - 2 * now.place[i] + last.place[i]) / h;
    out[static_cast<Index>(i)] = change - h * (after.n[i] - before.n[i]);
    out[static_cast<Index>(i) + 3] = leaving[i] - arriving[i] - h * (after.first[i] - before.second[i]);
  }
  return out;
}
RodShape straight(double length, int elements) {
  return RodShape::of_strains(length, elements, {}, {1, 0, 0, 0});
}
double largest(RodFrame const& frame, RodShape const& shape) {
  double out = 0;
  for (std::size_t k = 0; k < frame.places.size(); ++k)
    for (std::size_t i = 0; i < 3; ++i)
      out = std::max(out, std::abs(frame.places[k][i] - shape.places[k][i]));
  return out;
}
RodFrame frame_of(RodMotion const& motion) {
  RodFrame out;
  out.places = motion.shape.places;
  return out;
}
/// An eighth of a circle of radius 100.
RodShape eighth(int elements) {
  RodShape out;
  for (int k = 0; k <= elements; ++k) {
    double const angle = M_PI / 4 * k / elements;
    out.places.push_back({100 * std::sin(angle), 100 - 100 * std::cos(angle), 0});
    out.attitudes.push_back({std::cos(angle / 2), 0, 0, std::sin(angle / 2)});
  }
  return out;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(rod_witnesses)

BOOST_AUTO_TEST_CASE(the_helix_in_closed_form_is_balanced) {
  // By Newton's method for the same two conditions, in other programs.
  auto const smooth = RotatingHelix::of(thick, 0.9, 0.5, 0.6);
  BOOST_TEST(std::abs(smooth.radius - 0.983717969220) <= 1e-12);
  BOOST_TEST(std::abs(smooth.pitch - 0.478755049804) <= 1e-12);
  for (auto const& section : {thick, other})
    for (double const D : {0.4, 0.1}) {
      auto const helix = RotatingHelix::in_steps(section, 0.9, 0.5, 0.6, D, 0.1);
      double const worst = residuals(section, helix, D, 0.1).cwiseAbs().maxCoeff();
      BOOST_TEST_MESSAGE("residual of the balance of a discrete helix: " << worst);
      BOOST_TEST(worst <= 1e-14);
      // Control: the helix of the continuum is not balanced in steps.
      BOOST_TEST(residuals(section, RotatingHelix::of(section, 0.9, 0.5, 0.6), D, 0.1).norm() >= 1e-6);
    }
}

BOOST_AUTO_TEST_CASE(ten_thousand_steps_stay_on_the_helix) {
  for (auto const& section : {thick, other}) {
    double const D = 0.2, h = 0.016;
    auto const helix = RotatingHelix::in_steps(section, 0.8, 0.4, 0.7, D, h);
    Rod rod(section, straight(4, 20), helix.start(21, D, h), helix.moved_ends(4), {.step = h});
    double off = 0;
    for (int k = 0; k < 100; ++k)
      rod.step(100), off = std::max(off, helix.distance(rod.frame(), D, rod.time()));
    BOOST_TEST_MESSAGE("helix: off by " << off << " in 10000 steps");
    BOOST_TEST(off <= 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(radius_and_pitch_of_the_helix_have_order_two) {
  auto const smooth = RotatingHelix::of(other, 0.8, 0.4, 0.7);
  List D, radii, pitches;
  for (double const length : {0.2, 0.1, 0.05, 0.025}) {
    auto const helix = RotatingHelix::in_steps(other, 0.8, 0.4, 0.7, length, length / 12);
    D.push_back(length), radii.push_back(std::abs(helix.radius - smooth.radius));
    pitches.push_back(std::abs(helix.pitch - smooth.pitch));
  }
  BOOST_TEST(std::abs(book::exponent(D, radii) - 2) < 0.03);
  BOOST_TEST(std::abs(book::exponent(D, pitches) - 2) < 0.03);
}

BOOST_AUTO_TEST_CASE(waves_are_those_of_the_closed_form) {
  double worst = 0;
  for (int const mode : {1, 5})
    for (bool const upper : {false, true}) {
      List lengths, errors;
      for (int const elements : {15 * mode, 30 * mode, 60 * mode}) {
        PinnedWave const wave{other, 3, elements, mode, upper};
        double const h = wave.element() / 15, A = 1e-7;
        Rod rod(other, straight(3, elements), wave.start(A), PinnedWave::ends(), {.step = h});
        for (int k = 0; k < 200; ++k)
          rod.step(), worst = std::max(worst, wave.distance(rod.frame(), A, wave.frequency(h) * rod.time()));
        lengths.push_back(h), errors.push_back(std::abs(wave.frequency(h) / wave.of_beam() - 1));
      }
      BOOST_TEST(std::abs(book::exponent(lengths, errors) - 2) < 0.03);
    }
  BOOST_TEST_MESSAGE("waves: off by " << worst << " of their amplitudes");
  BOOST_TEST(worst <= 1e-9);
}

BOOST_AUTO_TEST_CASE(a_spinning_ring_has_the_stretch_of_the_continuum) {
  for (int const elements : {5, 20}) {
    double const r0 = 0.8, a = 1.7, h = 0.004, D = 2 * r0 * std::tan(M_PI / elements);
    double const turn = 2 * M_PI / elements / D;
    RotatingHelix const rest{turn, 0, 0, r0, 0};
    RotatingHelix const ring{turn, 0, a, spinning_radius(other, r0, 2 / h * std::sin(a * h / 2)), 0};
    Rod rod(other, rest.start(elements, D, h, true).shape, ring.start(elements, D, h, true), {}, {.step = h});
    double off = 0;
    for (int k = 0; k < 20; ++k)
      rod.step(100), off = std::max(off, ring.distance(rod.frame(), D, rod.time()));
    BOOST_TEST_MESSAGE("ring of " << elements << " elements: off by " << off << " in 2000 steps");
    BOOST_TEST(off <= 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(tangents_are_differentials_of_forces) {
  auto shape = eighth(4);
  SemiDiscreteRod rod(other, shape);
  rod.load = [](double) { return EndLoad{{0, 0, 600}, {3, 40, -70}}; };
  std::vector<Six> move(5);
  for (std::size_t k = 0; k < 5; ++k)
    for (int i = 0; i < 6; ++i) move[k][i] = 0.2 * std::sin(7 * static_cast<double>(k) + 3 * i + 1);
  SemiDiscreteRod::move(shape, move);
  BlockTridiagonal matrix(5);
  rod.forces(shape, 1, &matrix);
  double worst = 0, size = 0;
  for (std::size_t k = 0; k < 5; ++k)
    for (int i = 0; i < 6; ++i) {
      std::vector<Six> sides[2];
      for (int side = 0; side < 2; ++side) {
        std::vector<Six> by(5, Six::Zero());
        by[k][i] = side == 0 ? 1e-5 : -1e-5;
        auto moved = shape;
        SemiDiscreteRod::move(moved, by);
        sides[side] = rod.forces(moved, 1);
      }
      for (std::size_t l = k > 0 ? k - 1 : 0; l <= std::min<std::size_t>(k + 1, 4); ++l) {
        auto const& block = l == k ? matrix.diagonal[k] : l < k ? matrix.above[l] : matrix.below[k];
        Six const expected = (sides[1][l] - sides[0][l]) / 2e-5;
        worst = std::max(worst, (block.col(i) - expected).cwiseAbs().maxCoeff());
        size = std::max(size, expected.cwiseAbs().maxCoeff());
      }
    }
  BOOST_TEST_MESSAGE("tangents: " << worst << " of " << size);
  BOOST_TEST(worst <= 1e-8 * size);  // of a difference: 1e-10 by its length, and rounding over 1e-5
}

// A curved cantilever (Bathe and Bolourchi 1979), in equilibrium by Newton's method, stays where it is.
BOOST_AUTO_TEST_CASE(a_bent_cantilever_is_at_rest_in_steps) {
  double const GA = 5e6 * 5 / 6;
  RodSection const square{{1e7, GA, GA}, {1e7 / 12, 1e7 / 12, 1e7 / 12}, 1, {1, 1, 1}};
  List lengths, changes;
  Three<double> last{}, limit{};
  for (int const elements : {16, 32, 64, 128}) {
    auto const arc = eighth(elements);
    SemiDiscreteRod rod(square, arc);
    rod.clamped = true;
    rod.load = [](double part) { return EndLoad{{0, 0, 600 * part}, {}}; };
    auto const bent = rod.equilibrium(arc, 20);
    auto const tip = plus_times(bent.places.back(), -1.0, arc.places.back());
    auto const change = plus_times(tip, -1.0, last);
    if (elements > 16)
      lengths.push_back(1.0 / elements), changes.push_back(std::sqrt(bodies::dot(change, change)));
    limit = plus_times(tip, 1.0 / 3, change), last = tip;
    if (elements != 16) continue;
    RodLoads loads;
    loads.start.held = RodEnd::Held::clamped;
    loads.end.force = [](double) { return Three<double>{0, 0, 600}; };
    Rod steps(square, arc, {bent, {}, {}}, loads, {.step = 2e-4});
    steps.step(1000);
    double const off = largest(steps.frame(), bent);
    BOOST_TEST_MESSAGE("bent cantilever: off by " << off << " in 1000 steps");
    BOOST_TEST(off <= 1e-8);  // of places of 100, rounded against a stiffness of 1e7 with a load of 600
  }
  BOOST_TEST(std::abs(book::exponent(lengths, changes) - 2) < 0.03);
  // By another program of the same elements.
  BOOST_TEST(std::abs(limit[1] + 13.605) < 1e-3);
  BOOST_TEST(std::abs(limit[2] - 53.476) < 1e-3);
  BOOST_TEST(std::abs(limit[0] + 23.561) < 1e-3);
}

// Three methods in time for the same elements: they meet, each with order 2 against the reference.
BOOST_AUTO_TEST_CASE(explicit_steps_and_generalised_alpha_meet_the_reference) {
  auto const rest = straight(3, 8);
  SemiDiscreteRod elements(other, rest);
  // A load that grows slowly, so that fast waves do not decide on the errors.
  elements.load = [](double t) {
    return EndLoad{{0.3 * t * t, 0.1 * t * t, 0}, {0, 0.2 * t * t, -0.3 * t * t}};
  };
  RodLoads loads;
  loads.end.force = [&](double t) { return elements.load(t).force; };
  loads.end.moment = [&](double t) { return elements.load(t).moment; };
  auto const begin = RodMotion::at_rest(rest), truth = begin.later(elements, 0, 2, 1e-13);
  List steps, errors;
  for (double const h : {0.02, 0.01, 0.005, 0.0025}) {
    Rod rod(other, rest, {rest, {}, {}}, loads, {.step = h});
    rod.step(std::lround(2 / h));
    steps.push_back(h), errors.push_back(largest(rod.frame(), truth.shape));
  }
  BOOST_TEST_MESSAGE("explicit steps: order " << book::exponent(steps, errors));
  BOOST_TEST(std::abs(book::exponent(steps, errors) - 2) < 0.03);
  for (double const rho : {1.0, 0.8, 0.5}) {
    errors.clear();
    for (double const h : steps) {
      GeneralisedAlpha run(elements, begin, rho, h);
      for (int k = 0; k < std::lround(2 / h); ++k) run.step();
      errors.push_back(largest(frame_of(run.now()), truth.shape));
    }
    BOOST_TEST_MESSAGE("generalised-alpha, rho = " << rho << ": order " << book::exponent(steps, errors));
    BOOST_TEST(std::abs(book::exponent(steps, errors) - 2) < 0.03);
  }
}

BOOST_AUTO_TEST_SUITE_END()
