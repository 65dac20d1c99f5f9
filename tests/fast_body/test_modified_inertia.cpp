// Moments with which the Moser-Veselov scheme is of any order: against the polynomials of Hairer and Vilmart
// over the rationals, and by the orders that come out.
#include <boost/test/unit_test.hpp>

#include "../rigid_body/random_bodies.hpp"
#include "actio/fast_body/space/exact_flow.hpp"
#include "actio/fast_body/space/modified_inertia.hpp"
#include "actio/numbers/multiprecision.hpp"
#include "witness/draw.hpp"
#include "witness/number.hpp"

using namespace actio;
using namespace actio::bodies;

namespace {

// What Hairer and Vilmart print for 1/I_i -> (1 + h^2 s3 + h^4 s5)/I_i + h^2 d3 + h^4 d5, with C = |M|^2/2
// and H the energy.
template <class S>
struct PrintedTerms {
  S s3, d3, s5, d5;

  PrintedTerms(Three<S> const& I, S const& C, S const& H) {
    S const det = I[0] * I[1] * I[2], I1 = I[0] + I[1] + I[2], I2 = I[0] * I[0] + I[1] * I[1] + I[2] * I[2],
            J1 = S(1) / I[0] + S(1) / I[1] + S(1) / I[2],
            J2 = S(1) / (I[0] * I[0]) + S(1) / (I[1] * I[1]) + S(1) / (I[2] * I[2]), mixed = I1 * J1 - S(3);
    s3 = I1 / (S(6) * det) * C - J1 / S(3) * H;
    d3 = -C / (S(3) * det) + I1 / (S(6) * det) * H;
    s5 = (I2 / det - J1) / (S(30) * det) * C * C + (S(1) - mixed) / (S(30) * det) * C * H +
         (S(3) * I1 / det + S(2) * J2) / S(60) * H * H;
    d5 = -I1 / (S(60) * det * det) * C * C + (J1 / (S(10) * det) - I2 / (S(60) * det * det)) * C * H -
         (S(9) + mixed) / (S(60) * det) * H * H;
  }
};

Three<Number> rational_direction(FineDraw& draw) {
  Number const a = draw.number<Number>(), b = draw.number<Number>(), whole = 1 + a * a + b * b;
  return {2 * a / whole, 2 * b / whole, (1 - a * a - b * b) / whole};
}

// A body of middling shape in S, and a direction.
template <class S>
struct Model {
  InverseMoments<S> body{Three<S>{ratio<S>(6, 10), ratio<S>(8, 10), S(1)}};
  Three<S> u;
  explicit Model(bool round_third) {
    using std::sqrt;
    u = round_third ? Three<S>{ratio<S>(3, 10), ratio<S>(-4, 10), ratio<S>(9, 10)}
                    : Three<S>{ratio<S>(18, 10), ratio<S>(4, 10), ratio<S>(-9, 10)};
    S const size = sqrt(dot(u, u));
    for (S& x : u) x /= size;
  }
};
}  // namespace

BOOST_AUTO_TEST_SUITE(modified_inertia_of_a_step)

BOOST_AUTO_TEST_CASE(the_first_terms_are_those_of_hairer_and_vilmart_exactly) {
  WithArithmetic const exactly(Arithmetic::rationals());
  FineDraw draw(testing::seed);
  for (int repeat = 0; repeat < 20; ++repeat) {
    Three<Number> I;
    for (auto& x : I) x = 2 + draw.number<Number>();
    // The middle moment in the middle, from either end.
    std::sort(I.begin(), I.end());
    if (repeat % 2) std::swap(I[0], I[2]);
    InverseMoments<Number> const body(I);
    Three<Number> const u = rational_direction(draw);
    ModifiedInertiaSeries<Number> const series(body, Orbit<Number>(body, u), 3);
    // |M| = 1, so that t = h/2.
    Number const H = (body.J[0] * u[0] * u[0] + body.J[1] * u[1] * u[1] + body.J[2] * u[2] * u[2]) / 2;
    PrintedTerms<Number> const printed(I, ratio<Number>(1, 2), H),
        other(I, ratio<Number>(1, 2), H + ratio<Number>(1, 1000));
    BOOST_TEST((series.s.coefficient(0) == 1));
    BOOST_TEST((series.d.coefficient(0) == 0));
    BOOST_TEST((series.s.coefficient(1) / 4 == printed.s3));
    BOOST_TEST((series.d.coefficient(1) / 4 == printed.d3));
    BOOST_TEST((series.s.coefficient(2) / 16 == printed.s5));
    BOOST_TEST((series.d.coefficient(2) / 16 == printed.d5));
    // On another orbit the terms are others.
    BOOST_TEST((series.s.coefficient(1) / 4 != other.s3));
    BOOST_TEST((series.d.coefficient(2) / 16 != other.d5));
  }
}

BOOST_AUTO_TEST_CASE(the_series_are_those_of_what_makes_the_step_exact) {
  // s and d of an exact step from the replaced moments themselves, by differences of two of them; 24 terms at
  // t = 1/8.
  using S = dec50;
  for (bool const third : {false, true}) {
    Model<S> const model(third);
    S const t = ratio<S>(1, 8);
    auto const j = inertia_of(exact_flow<S>(model.body, model.u, t));
    S const s = (j[0] - j[2]) / (t * model.body.d13), d = j[1] - s * t * model.body.J[1];
    auto const series = modified_inertia<S>(model.body, model.u, t, 48);
    BOOST_TEST(to_double(magnitude(S(series.s - s))) <= 1e-30);
    BOOST_TEST(to_double(magnitude(S(series.d - d))) <= 1e-30);
    // The moment in the middle fits the same s and d.
    BOOST_TEST(to_double(magnitude(S(j[0] - s * t * model.body.J[0] - d))) <= 1e-48);
  }
}

BOOST_AUTO_TEST_CASE(orders_two_to_ten_come_out) {
  using S = dec50;
  for (bool const third : {false, true}) {
    Model<S> const model(third);
    FrameState<S> const start{model.u, {S(1), S(0), S(0), S(0)}};
    // Over the time 1, by 8 to 256 steps, against the exact motion in one.
    FrameState<S> exact = start;
    HalfTurn<S>(exact_flow<S>(model.body, model.u, ratio<S>(1, 2))).step(exact);
    for (int order = 2; order <= 10; order += 2) {
      std::vector<double> steps, errors;
      for (int count = 8; count <= 256; count *= 2) {
        S const t = S(1) / S(2 * count);
        auto const modified = actio::bodies::modified_inertia<S>(model.body, model.u, t, order);
        Three<S> j;
        for (int i = 0; i < 3; ++i) j[i] = modified.s * t * model.body.J[i] + modified.d;
        bool found = false;
        HalfTurn<S> const turn(moser_veselov_parameters<S>(j, model.u, found));
        BOOST_REQUIRE(found);
        FrameState<S> state = start;
        for (int k = 0; k < count; ++k) turn.step(state);
        S error(0);
        for (int i = 0; i < 3; ++i) error += magnitude(S(state.direction[i] - exact.direction[i]));
        for (int i = 0; i < 4; ++i) error += magnitude(S(state.attitude[i] - exact.attitude[i]));
        steps.push_back(1.0 / count), errors.push_back(to_double(error));
      }
      auto const fit = testing::fit_order(steps, errors);
      BOOST_TEST_MESSAGE("order " << order << (third ? ", round axis 3" : ", round axis 1") << ": observed "
                                  << fit.slope << ", least error " << errors.back());
      BOOST_TEST(std::abs(fit.slope - order) < 0.05);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
