// The field equations written out for homogeneous media in Euclidean spaces are those of the general road,
// and numbers that carry a divergence are dual numbers of dual numbers.
#include <boost/test/unit_test.hpp>

#include "actio/continuum/elastic_equation.hpp"
#include "refused.hpp"
#include "witness/draw.hpp"
#include "witness/number.hpp"

using namespace actio;

namespace {

/// A second jet near that of the body at rest, of no section.
template <class S, int n>
SecondJet<S, n, n> second_jet_near_rest(FineDraw& draw) {
  SecondJet<S, n, n> j;
  j.x = draw.vector<S, Event<S, n>>(n + 1);
  j.y = draw.vector<S, Matrix<S, n, 1>>(n);
  for (int mu = 0; mu <= n; ++mu) {
    j.v.col(mu) = draw.vector<S, Matrix<S, n, 1>>(n) * ratio<S>(1, 5);
    if (mu > 0) j.v(mu - 1, mu) += S(1);
    for (int nu = 0; nu <= mu; ++nu)
      j.w[mu].col(nu) = draw.vector<S, Matrix<S, n, 1>>(n), j.w[nu].col(mu) = j.w[mu].col(nu);
  }
  return j;
}

/// A law that the library has no derivatives of, and that is not isotropic: fibres along the first axis.
struct Fibres {
  template <class T, int n>
  T operator()(Matrix<T, n, n> const& C) const {
    T const stretch = C(0, 0) - Base<T>(1);
    return stretch * stretch * stretch / Base<T>(7) + C.trace() * C(0, n - 1) + C(0, 0) / C(n - 1, n - 1) +
           C(n - 1, 0) * C(n - 1, 0);
  }
};

template <class S, int n, class Energy>
void agree(Energy const& energy, char const* name) {
  FineDraw draw(20 + n);
  Continuum const medium{Euclidean<n>{}, Euclidean<n>{}, Homogeneous<S>{ratio<S>(13, 10)}, energy};
  for (int sample = 0; sample < 5; ++sample) {
    auto const j = second_jet_near_rest<S, n>(draw);
    auto const fast = elastic_equation(medium, j);
    auto const general = euler_lagrange(medium, j), by_terms = euler_lagrange_by_terms(medium, j);
    // Both sum some hundred products of moderate numbers, of which logarithms and inverse powers of J, not
    // far from 1, are the largest.
    S const gap = magnitude(Matrix<S, n, 1>(fast - general)),
            bound = S(500) * epsilon<S>() * (S(1) + magnitude(general));
    BOOST_TEST((gap <= bound),
               name << ", n = " << n << ": " << to_double(gap) << " over " << to_double(bound));
    S const between = magnitude(Matrix<S, n, 1>(general - by_terms));
    BOOST_TEST((between <= bound), name << ", n = " << n << ", one evaluation and term by term: "
                                        << to_double(between) << " over " << to_double(bound));
    BOOST_TEST((magnitude(general) > ratio<S>(1, 100)),
               name << ", n = " << n << ": the equation says something");
  }
}

template <class S, int n>
void all_agree() {
  S const lambda = ratio<S>(7, 5), mu = ratio<S>(4, 5);
  agree<S, n>(OfGreenTensor{StVenantKirchhoff<S>{lambda, mu}}, "St Venant-Kirchhoff");
  agree<S, n>(OfGreenTensor{NeoHookean{mu, PowerVolume<2>{}}}, "neo-Hookean, power");
  agree<S, n>(OfGreenTensor{MooneyRivlin{mu, lambda, PowerVolume<1>{}}}, "Mooney-Rivlin, power");
  agree<S, n>(OfGreenTensor{Fibres{}}, "a law of one's own");
  agree<S, n>(Barotropic{WholePolytropic<S, 2>{lambda}}, "polytropic gas, whole exponent");
  if constexpr (Real<S>) {
    agree<S, n>(OfGreenTensor{NeoHookean{mu, LogarithmicVolume<S>{lambda}}}, "neo-Hookean");
    agree<S, n>(OfGreenTensor{MooneyRivlin{mu, lambda, LogarithmicVolume<S>{lambda}}}, "Mooney-Rivlin");
    agree<S, n>(Barotropic{Tait<S>{lambda, S(7)}}, "Tait's liquid");
  }
}

/// Everything that numbers of any kind can do, once.
template <class T>
T medley(T const& a, T const& b, T const& c) {
  using std::abs, std::atan2, std::cos, std::exp, std::log, std::pow, std::sin, std::sqrt;
  T x = a * b / c - 2 * a + b / 3 - (1 - c) + 5 / b + sqrt(c) + square_root(b) + exp(a) * log(b) + sin(c) -
        cos(a) + pow(b, 2.5);
  x += atan2(a, b) + atan2(-b, a) * atan2(c, -a);
  x -= abs(-c) * abs(a);
  x *= a + 1;
  x /= b;
  x /= 2;
  return -x;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(fast_equations)

BOOST_AUTO_TEST_CASE(equations_written_out_are_those_of_the_general_road) {
  all_agree<double, 2>();
  all_agree<double, 3>();
  agree<double, 1>(OfGreenTensor{StVenantKirchhoff<double>{1.4, 0.8}}, "a bar");
}

BOOST_AUTO_TEST_CASE(they_are_in_fifty_digits) {
  WithArithmetic const digits(Arithmetic::decimal(50));
  agree<Number, 3>(OfGreenTensor{MooneyRivlin{ratio<Number>(4, 5), ratio<Number>(7, 5),
                                              LogarithmicVolume<Number>{ratio<Number>(7, 5)}}},
                   "Mooney-Rivlin");
}

BOOST_AUTO_TEST_CASE(they_are_exactly_over_the_rationals) {
  WithArithmetic const exactly(Arithmetic::rationals());
  agree<Number, 2>(OfGreenTensor{StVenantKirchhoff<Number>{ratio<Number>(7, 5), ratio<Number>(4, 5)}},
                   "St Venant-Kirchhoff");
  agree<Number, 2>(OfGreenTensor{Fibres{}}, "a law of one's own");
}

BOOST_AUTO_TEST_CASE(a_body_turned_inside_out_is_refused) {
  FineDraw draw(3);
  auto j = second_jet_near_rest<double, 3>(draw);
  Continuum const solid{Euclidean<3>{}, Euclidean<3>{}, Homogeneous<double>{},
                        OfGreenTensor{NeoHookean{1.0, LogarithmicVolume<double>{2.0}}}};
  j.v.col(1) *= -1;
  CHECK_REFUSED(elastic_equation(solid, j), NotOrientationPreserving);
  j.v.col(1) *= -1;
  j.w[1](0, 1) = std::nan("");
  CHECK_REFUSED(elastic_equation(solid, j), NoDerivative);
}

BOOST_AUTO_TEST_CASE(numbers_that_carry_a_divergence_are_dual_numbers_of_dual_numbers) {
  using T = DivergenceNumber<double, 3, 2>;
  using D = Dual<Dual<double>>;
  Draw draw(4);
  // Three numbers, and how each changes: along delta_mu, and along epsilon_a^mu.
  std::array<double, 3> const at{0.7, 1.3, 0.4};
  std::array<T, 3> moved;
  for (int i = 0; i < 3; ++i) {
    moved[i] = T(at[i]);
    for (int mu = 0; mu < 3; ++mu) {
      moved[i].set_rate(mu, draw.number<double>());
      for (int a = 0; a < 2; ++a) moved[i].set_slope(mu, a, draw.number<double>());
    }
    for (int a = 0; a < 2; ++a) moved[i].set_sum(a, draw.number<double>());
  }
  T const value = medley(moved[0], moved[1], moved[2]);
  for (int a = 0; a < 2; ++a) {
    double sum = 0, scale = 0;
    for (int mu = 0; mu < 3; ++mu) {
      std::array<D, 3> d;
      for (int i = 0; i < 3; ++i) {
        d[i] = D(Dual<double>(at[i]));
        d[i].value.part[0] = moved[i].rate(mu);
        d[i].part[0].value = moved[i].slope(mu, a);
        if (mu == 0) d[i].part[0].part[0] = moved[i].sum(a);
      }
      D const expected = medley(d[0], d[1], d[2]);
      double const bound = 200 * epsilon<double>() * (1 + magnitude(expected));
      BOOST_TEST(std::abs(value.value() - expected.value.value) <= bound);
      BOOST_TEST(std::abs(value.rate(mu) - expected.value.part[0]) <= bound);
      BOOST_TEST(std::abs(value.slope(mu, a) - expected.part[0].value) <= bound);
      sum += expected.part[0].part[0], scale += magnitude(expected);
    }
    BOOST_TEST(std::abs(value.sum(a) - sum) <= 200 * epsilon<double>() * (1 + scale));
  }
}

BOOST_AUTO_TEST_SUITE_END()
