// Jets of sections, densities on them, and what they refuse.
#include <boost/test/unit_test.hpp>

#include "actio/continuum/materials.hpp"
#include "actio/jets/field_equations.hpp"
#include "actio/jets/prolongation.hpp"
#include "actio/numbers/multiprecision.hpp"
#include "polynomial_models.hpp"
#include "refused.hpp"
#include "witness/number.hpp"

using namespace actio;
using namespace actio::testing;

namespace {

/// A section that is no polynomial.
struct Wave {
  template <class V>
  auto operator()(V const& x) const {
    using std::cos, std::exp, std::sin;
    using T = ScalarOf<V>;
    Matrix<T, 2, 1> y;
    y << sin(x[1] + x[0] * 2) * x[2], exp(x[2] * x[1]) + cos(x[0]) / (x[1] * x[1] + 1);
    return y;
  }
};

/// Second derivatives by dual numbers of dual numbers.
template <class S>
SecondJet<S, 2, 2> by_nested_duals(Matrix<S, 3, 1> const& x) {
  SecondJet<S, 2, 2> jet;
  static_cast<Jet<S, 2, 2>&>(jet) = first_jet(Wave{}, x);
  for (int mu = 0; mu < 3; ++mu) {
    auto moved = x.template cast<Dual<S>>().eval();
    moved[mu].part[0] = S(1);
    auto const j = first_jet(Wave{}, moved);
    for (int a = 0; a < 2; ++a)
      for (int nu = 0; nu < 3; ++nu) jet.w[mu](a, nu) = j.v(a, nu).part[0];
  }
  return jet;
}

template <class S>
void second_jets_agree() {
  auto const x = event<S>();
  auto const j = second_jet(Wave{}, x), nested = by_nested_duals(x);
  // A few dozen operations on numbers of order 1, each rounded.
  S const bound = S(100) * epsilon<S>();
  BOOST_TEST((magnitude((j.y - nested.y).eval()) <= bound));
  BOOST_TEST((magnitude((j.v - nested.v).eval()) <= bound));
  for (int mu = 0; mu < 3; ++mu) {
    BOOST_TEST((magnitude((j.w[mu] - nested.w[mu]).eval()) <= bound));
    for (int nu = 0; nu < 3; ++nu) BOOST_TEST((j.w[mu].col(nu) == j.w[nu].col(mu)));
  }
}

/// A density with a root of the strain, which has no derivative where the strain vanishes.
struct RootOfStrain {
  template <class T>
  T operator()(Jet<T, 1, 1> const& j) const {
    using std::sqrt;
    return T(j.v(0, 0) * j.v(0, 0) - sqrt(T(j.v(0, 1) * j.v(0, 1))));
  }
};

bool names(std::exception const& e, char const* text) {
  return std::string(e.what()).find(text) != std::string::npos;
}

}  // namespace

BOOST_AUTO_TEST_CASE(second_jets_equal_nested_dual_numbers) {
  second_jets_agree<double>();
  WithArithmetic const digits(Arithmetic::decimal(50));
  second_jets_agree<Number>();
}

BOOST_AUTO_TEST_CASE(coordinates_of_jets_and_dual_jets_go_there_and_back) {
  auto const c = tangents<double, 11, 1>();
  BOOST_TEST((coordinates(jet_at<2, 2>(c)) == c));
  auto const d = tangents<double, 12, 1>();
  BOOST_TEST((coordinates(dual_jet_at<2, 2>(d)) == d));
}

BOOST_AUTO_TEST_CASE(the_field_equations_of_a_string_are_its_wave_equation) {
  WithArithmetic const exactly(Arithmetic::rationals());
  auto const string = []<class T>(Jet<T, 1, 1> const& j) {
    return T((j.v(0, 0) * j.v(0, 0) - j.v(0, 1) * j.v(0, 1) * 9) / 2);
  };
  auto const shape = [](auto const& x) {
    return Matrix<ScalarOf<decltype(x)>, 1, 1>(x[0] * x[0] * x[1] + x[1] * x[1] * x[1]);
  };
  Matrix<Number, 2, 1> const x(ratio<Number>(1, 2), ratio<Number>(1, 3));
  // -phi_tt + 9 phi_xx = -2 x + 54 x.
  BOOST_TEST((euler_lagrange(string, shape, x)[0] == Number(52) / 3));
}

BOOST_AUTO_TEST_CASE(the_value_of_a_dual_jet_on_its_own_jet_is_the_density) {
  WithArithmetic const exactly(Arithmetic::rationals());
  auto const j = first_jet(Motion{}, event<Number>());
  BOOST_TEST((pairing(legendre(Density{}, j), j) == Density{}(j)));
}

BOOST_AUTO_TEST_CASE(a_density_without_a_derivative_says_so_and_where) {
  Jet<double, 1, 1> j;
  j.x << 0.25, 0.5;
  j.y << 2;
  j.v << 1, 0;
  auto const at_the_point = [](NoDerivative const& e) {
    return names(e, "x = (0.25, 0.5), y = (2)") && names(e, "no derivative");
  };
  BOOST_CHECK_EXCEPTION(momenta(RootOfStrain{}, j), NoDerivative, at_the_point);
  BOOST_CHECK_EXCEPTION(legendre(RootOfStrain{}, j), NoDerivative, at_the_point);
  auto const flat = [](auto const& x) { return Matrix<ScalarOf<decltype(x)>, 1, 1>(x[0]); };
  CHECK_REFUSED(euler_lagrange(RootOfStrain{}, flat, Vector<double, 2>(0.25, 0.5)), NoDerivative);
  // The derivative by the velocity is taken through the root as well.
  BOOST_CHECK_EXCEPTION(energy_density(RootOfStrain{}, j), NoDerivative, at_the_point);
  j.v(0, 1) = -0.5;
  BOOST_TEST(energy_density(RootOfStrain{}, j) == 1.5);
}

BOOST_AUTO_TEST_CASE(a_fluid_turned_inside_out_and_a_matrix_that_is_no_metric_are_refused) {
  auto const fluid = [](Matrix<double, 2, 2> const& G) {
    return Continuum{ConstantMetric<double, 2>{G}, Euclidean<2>{}, Homogeneous<double>{1},
                     Barotropic{WholePolytropic<double, 2>{1}}};
  };
  auto j = first_jet(Motion{}, event<double>());
  BOOST_CHECK_NO_THROW(momenta(fluid(Matrix<double, 2, 2>::Identity()), j));
  BOOST_CHECK_EXCEPTION(momenta(fluid((Matrix<double, 2, 2>() << 1, 2, 2, 1).finished()), j), NotAMetric,
                        [](NotAMetric const& e) { return e.measured < 0 && names(e, "body"); });
  CHECK_REFUSED(momenta(fluid((Matrix<double, 2, 2>() << 1, 0.5, 0, 1).finished()), j), NotAMetric);
  j.v.col(1) = -j.v.col(1);
  BOOST_CHECK_EXCEPTION(momenta(fluid(Matrix<double, 2, 2>::Identity()), j), NotOrientationPreserving,
                        [](NotOrientationPreserving const& e) { return e.measured < 0 && e.bound == 0; });
}

BOOST_AUTO_TEST_CASE(roots_over_the_rationals_are_exact_or_refused) {
  BOOST_TEST(square_root(ratio<rational>(49, 64)) == ratio<rational>(7, 8));
  CHECK_REFUSED(square_root(rational(2)), NotASquare);
  CHECK_REFUSED(square_root(rational(-4)), NotASquare);
}

BOOST_AUTO_TEST_CASE(a_prolonged_field_is_the_rate_of_the_prolonged_flow) {
  WithArithmetic const exactly(Arithmetic::rationals());
  // The field (t + 2x, 3 - t, y) generates nothing linear in eps but is enough to first order: move a section
  // by x + eps xi and look at its jets there.
  auto const xi = []<class V>(V const& p) {
    using T = ScalarOf<V>;
    Matrix<T, 4, 1> rate;
    rate << p[0] + p[1] * p[1] * 2, T(3) - p[0] * p[1], p[2] * p[3] + p[0], p[2] * p[1];
    return rate;
  };
  using Q = Number;
  using T = Dual<Q>;
  using Inner = Dual<T, 2>;
  Matrix<Q, 2, 1> const x(ratio<Q>(1, 3), ratio<Q>(2, 5));
  auto const phi = [](auto const& u) {
    return Matrix<ScalarOf<decltype(u)>, 2, 1>(u[0] * u[1] + u[0], u[1] * u[1] - u[0]);
  };
  // Tangent map of the moved graph: rows X and Y, columns u.
  Matrix<Inner, 2, 1> u;
  for (int i = 0; i < 2; ++i) u[i] = Inner(T(x[i])), u[i].part[i] = T(Q(1));
  Matrix<Inner, 4, 1> point;
  point << u, phi(u);
  T eps(Q(0));
  eps.part[0] = Q(1);
  Matrix<Inner, 4, 1> const rate = xi(point);
  Matrix<T, 2, 2> DX, DY;
  for (int i = 0; i < 4; ++i) {
    Inner const moved = point[i] + rate[i] * Inner(eps);
    for (int c = 0; c < 2; ++c) (i < 2 ? DX(i, c) : DY(i - 2, c)) = moved.part[c];
  }
  Matrix<T, 2, 2> const v = DY * inverse_matrix(DX);
  auto const lifted = jet_at<1, 2>(prolonged<1, 2>(xi)(coordinates(first_jet(phi, x))));
  for (int a = 0; a < 2; ++a)
    for (int mu = 0; mu < 2; ++mu) BOOST_TEST((lifted.v(a, mu) == v(a, mu).part[0]));
}
