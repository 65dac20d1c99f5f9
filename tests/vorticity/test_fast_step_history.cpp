// Steps in mixed precision: their unit, what they keep and when they try it, and the ways on where single
// precision or an estimate is not good enough.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "actio/vorticity/fast_vorticity_step.hpp"
#include "flows.hpp"

using namespace actio;
using namespace actio::sphere;
using testing::random_state;

namespace {

constexpr Conserved forms[] = {Conserved::lie_poisson, Conserved::energy_casimir, Conserved::all_invariants};

/// Counts whole products in single precision.
struct CountedProducts : ProductsBy<CountedProducts> {
  mutable int in_single = 0;
  template <class Part>
  void whole(Part const& a, Part const& b, Part& out) const {
    if (std::is_same_v<Part, Single>) ++in_single;
    EigenProducts().whole(a, b, out);
  }
  template <class Part>
  void lower(Part const& a, Part const& b, Part& out) const { EigenProducts().lower(a, b, out); }
};

bool same(SkewHermitian<> const& a, SkewHermitian<> const& b) {
  return a.real == b.real && a.imaginary == b.imaginary;
}
SkewHermitian<> put(LowerHalf const& half, Eigen::Index n) {
  SkewHermitian<> m;
  half.put(n, m);
  return m;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(fast_step_history)

// Powers of two of all that is measured in a unit are exact, in both precisions, and so are their sums. The
// second flow is so smooth that its middles are extrapolated.
BOOST_AUTO_TEST_CASE(a_power_of_two_changes_no_digit_of_a_step_in_mixed_precision) {
  int const n = 12;
  SphereLaplacian const laplacian(n);
  for (auto const& [most, h] : {std::pair(9, 0.02), {3, 0.002}})
    for (auto const conserved : forms) {
      SkewHermitian<> const start = random_state(n, 1, most);
      TurningFrame const calm = calmest_frame(QuantizedSphere(n), laplacian, start);
      for (double unit : {0x1p-16, 0x1p16}) {
        SkewHermitian<> w = start, scaled = unit * start;
        FastVorticityStep<> step(laplacian, conserved, h, calm),
            other(laplacian, conserved, h / unit, {calm.axis, unit * calm.rate});
        bool all = true;
        for (int k = 0; k < 14 && all; ++k) {
          VorticityReport const one = step.advance(w), two = other.advance(scaled);
          all = same(unit * w, scaled) && one.iterations == two.iterations && one.residual == two.residual;
        }
        BOOST_TEST(all);
      }
    }
}

// A rigid rotation and its wave stand still in their frame: what was found is the guess from the seventh step
// on, when the sixth has seen that five steps foretell it; and again after all was forgotten.
BOOST_AUTO_TEST_CASE(a_guess_is_the_solution_as_soon_as_five_steps_have_foretold_one) {
  int const n = 12;
  SphereLaplacian const laplacian(n);
  SkewHermitian<> const start = testing::RossbyHaurwitz{}.state(n);
  TurningFrame const calm = calmest_frame(QuantizedSphere(n), laplacian, start);
  for (auto const conserved : {Conserved::energy_casimir, Conserved::all_invariants}) {
    auto const counted = std::make_shared<CountedProducts>();
    FastVorticityStep<> step(laplacian, conserved, 0.05, calm, counted);
    SkewHermitian<> w = start;
    for (int round = 0; round < 2; ++round) {
      std::vector<int> products;
      for (int k = 1; k <= 9; ++k) {
        counted->in_single = 0;
        step.advance(w);
        products.push_back(counted->in_single);
        BOOST_TEST(step.past().size() == static_cast<std::size_t>(std::min(k, 5)));
        BOOST_TEST(step.past().front().wait == 0);
      }
      // A round conjugates W by three whole products.
      for (std::size_t k = 0; k < 9; ++k) BOOST_TEST(products[k] == products[8] + (k < 6 ? 3 : 0));
      step.forget();
      BOOST_TEST(step.past().empty());
    }
  }
}

// Squares of the state are no numbers of single precision: the step is the plain one bit for bit, and what it
// keeps is what that one has found.
BOOST_AUTO_TEST_CASE(a_step_that_single_precision_cannot_make_is_the_plain_one) {
  int const n = 12;
  SphereLaplacian const laplacian(n);
  SkewHermitian<> const start = random_state(n, 1, 9);
  TurningFrame const calm = calmest_frame(QuantizedSphere(n), laplacian, start);
  for (double unit : {0x1p-60, 0x1p50})
    for (auto const conserved : forms) {
      double const h = 0.02 / unit;
      TurningFrame const frame{calm.axis, unit * calm.rate};
      SkewHermitian<> w = unit * start, exact = w;
      SkewHermitian<> const before = w;
      FastVorticityStep<> fast(laplacian, conserved, h, frame);
      VorticityStep<> plain(laplacian, conserved, h, frame);
      VorticityReport const report = fast.advance(w), of_plain = plain.advance(exact);
      BOOST_TEST(same(w, exact));
      BOOST_TEST((report.iterations == of_plain.iterations && report.residual == of_plain.residual));
      auto const& kept = fast.past().front();
      BOOST_TEST(same(put(kept.displacement, n), plain.displacement()));
      BOOST_TEST((kept.factors == plain.past().front().factors));
      // A difference of two of its size.
      BOOST_TEST(norm(put(kept.increment, n) - plain.past().front().increment) <=
                 2 * std::numeric_limits<double>::epsilon() * norm(before));
      BOOST_TEST(norm(plain.past().front().increment) > 1e-4 * norm(before));
      BOOST_TEST(kept.guess_error == 1);
    }
}

// What is known of the largest eigenvalue of A may be too little: the polynomial of the transform is then
// good on too short an interval. Somewhat too little is made up for, and remembered; far too little leads to
// the plain step.
BOOST_AUTO_TEST_CASE(an_estimate_that_was_too_low_is_raised) {
  int const n = 12;
  SphereLaplacian const laplacian(n);
  SkewHermitian<> w = random_state(n, 1, 9);
  double const h = 0.3 * QuantizedSphere(n).hbar() /
                   vorticity_values(laplacian.solve(w)).cwiseAbs().maxCoeff();  // |A| about 0.15
  Conserved const conserved = Conserved::all_invariants;
  FastVorticityStep<> first(laplacian, conserved, h);
  for (int k = 0; k < 6; ++k) first.advance(w);
  double const known = first.past().front().radius;
  for (double part : {1.0, 0.6, 0.3, 0.02}) {
    auto past = first.past();
    past.front().radius = part * known;
    SkewHermitian<> here = w, exact = w;
    FastVorticityStep<> step(laplacian, conserved, h);
    step.go_on_from(past);
    step.advance(here);
    VorticityStep<>(laplacian, conserved, h).advance(exact);
    double const raised = step.past().front().radius / (part * known),
                 apart = norm(here - exact) / norm(exact);
    BOOST_TEST_MESSAGE("the radius taken for " << part << " of it: raised by " << raised << ", " << apart
                                               << " off the plain step");
    // A to 1e-8 of |A|, which is about a seventh.
    BOOST_TEST(apart <= 1e-8);
    // A step in double precision in disguise would be that very one.
    BOOST_TEST((apart > 0) == (part > 0.1));
    // By a fifth, up to four times.
    double const times = std::log(raised) / std::log(1.2);
    BOOST_TEST(std::abs(times - std::round(times)) <= 1e-12);
    BOOST_TEST(std::round(times) == (part > 0.5 ? 0 : part > 0.1 ? 2 : 4));
  }
}

BOOST_AUTO_TEST_SUITE_END()
