// Constraints on first jets and the extended bundle: two routes to the equations, and jets that are refused.
#include <boost/test/unit_test.hpp>

#include "actio/constraints/constrained_equations.hpp"
#include "actio/constraints/directors.hpp"
#include "actio/constraints/inextensible.hpp"
#include "caught.hpp"
#include "refused.hpp"
#include "witness/number.hpp"

using namespace actio;
using testing::caught;

namespace {

/// A density that refuses places below the ground.
struct AboveGround {
  template <class T>
  T operator()(Jet<T, 1, 2> const& j) const { return j.v(0, 0) * j.v(0, 0) + j.y[1]; }
  template <class S>
  void examine(Jet<S, 1, 2> const& j) const {
    if (!(base_value(j.y[1]) > 0))
      throw OutsideDomain("AboveGround", "height is positive", to_double(base_value(j.y[1])), 0);
  }
};

Jet<double, 1, 2> jet_with_slope(double a, double b) {
  Jet<double, 1, 2> j{Event<double, 1>(0, 0), Vector<double, 2>(0, 1), Matrix<double, 2, 2>::Zero()};
  j.v.col(1) << a, b;
  return j;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_string_that_runs_round_a_circle_has_the_tension_of_its_speed) {
  double const rho = 0.7, v = 3;
  auto const circle = [=]<class V>(V const& x) {
    using T = typename V::Scalar;
    using std::cos, std::sin;
    T const s = x[1] - x[0] * v;
    return Matrix<T, 2, 1>(cos(s), sin(s));
  };
  auto const tension = [=]<class V>(V const&) {
    return Matrix<typename V::Scalar, 1, 1>(typename V::Scalar(rho * v * v));
  };
  HeavyString<double, 2> const string{rho, {0, 0}};
  Inextensible const constraint{Euclidean<2>{}};
  Event<double, 1> const x(0.3, 0.8);
  auto const all = euler_lagrange(AugmentedDensity{string, constraint}, ExtendedSection{circle, tension}, x);
  BOOST_TEST(all.cwiseAbs().maxCoeff() < 16 * epsilon<double>() * rho * v * v);
  // The same from (7.2), where the multiplier has the other sign.
  auto const minus = [&](auto const& at) { return (-tension(at)).eval(); };
  BOOST_TEST(constrained_field_equations(string, constraint, second_jet(circle, x), first_jet(minus, x))
                 .cwiseAbs()
                 .maxCoeff() < 16 * epsilon<double>() * rho * v * v);
}

BOOST_AUTO_TEST_CASE(a_string_that_has_shrunk_to_a_point_is_not_regular) {
  Inextensible const constraint{Euclidean<2>{}};
  BOOST_CHECK_NO_THROW(require_regular(constraint, jet_with_slope(0.6, 0.8)));
  BOOST_CHECK_NO_THROW(require_regular(constraint, jet_with_slope(0, 1e-200)));
  auto const e = caught<NotRegular>([&] { require_regular(constraint, jet_with_slope(0, 0)); });
  BOOST_TEST(e.point.size() == 8u);
  BOOST_TEST(e.measured == 0);
}

BOOST_AUTO_TEST_CASE(a_director_of_length_zero_is_not_regular) {
  Jet<double, 2, 6> j;
  j.x.setZero(), j.y.setZero(), j.v.setZero();
  CHECK_REFUSED(require_regular(UnitDirector{}, j), NotRegular);
  CHECK_REFUSED(require_regular(NormalDirector<2>{}, j), NotRegular);
  j.v(0, 1) = j.v(1, 2) = j.y[5] = 1;
  BOOST_CHECK_NO_THROW(require_regular(UnitDirector{}, j));
  BOOST_CHECK_NO_THROW(require_regular(NormalDirector<2>{}, j));
}

BOOST_AUTO_TEST_CASE(a_constraint_without_a_derivative_says_so) {
  auto const length = constraint<1>([]<class T>(Jet<T, 1, 2> const& j) {
    using std::sqrt;
    return Matrix<T, 1, 1>(T(sqrt(T(j.v(0, 1) * j.v(0, 1) + j.v(1, 1) * j.v(1, 1))) - T(1)));
  });
  BOOST_CHECK_NO_THROW(require_regular(length, jet_with_slope(0.6, 0.8)));
  CHECK_REFUSED(require_regular(length, jet_with_slope(0, 0)), NoDerivative);
}

BOOST_AUTO_TEST_CASE(the_augmented_density_refuses_what_its_parts_refuse) {
  AugmentedDensity const density{AboveGround{}, Inextensible{Euclidean<2>{}}};
  auto const lambda = []<class V>(V const&) {
    return Matrix<typename V::Scalar, 1, 1>(typename V::Scalar(1));
  };
  auto const at_height = [](double height) {
    return [height]<class V>(V const& x) { return Matrix<typename V::Scalar, 2, 1>(x[1], x[0] + height); };
  };
  Event<double, 1> const x(0, 0);
  BOOST_CHECK_NO_THROW(euler_lagrange(density, ExtendedSection{at_height(1), lambda}, x));
  CHECK_REFUSED(euler_lagrange(density, ExtendedSection{at_height(-1), lambda}, x), OutsideDomain);
  CHECK_REFUSED(constrained_field_equations(AboveGround{}, Inextensible{Euclidean<2>{}},
                                            second_jet(at_height(-1), x), first_jet(lambda, x)),
                OutsideDomain);
}

BOOST_AUTO_TEST_CASE(a_jet_of_the_extended_bundle_falls_into_its_parts) {
  Jet<double, 1, 3> j;
  j.x << 1, 2;
  j.y << 3, 4, 5;
  j.v << 6, 7, 8, 9, 10, 11;
  auto const place = configuration<2>(j);
  auto const lambda = multiplier_part<1>(j);
  BOOST_TEST((place.y == Vector<double, 2>(3, 4)));
  BOOST_TEST(place.v(1, 1) == 9);
  BOOST_TEST(lambda.y[0] == 5);
  BOOST_TEST(lambda.v(0, 1) == 11);
}

BOOST_AUTO_TEST_CASE(a_directed_body_has_the_energies_of_its_place_and_its_director) {
  WithArithmetic const exactly(Arithmetic::rationals());
  using Q = Number;
  // Every number of the jet is another one.
  Jet<Q, 2, 6> j{{Q(1), Q(2), Q(3)}, {}, {}};
  for (int a = 0; a < 6; ++a) {
    j.y[a] = Q(a * a + 2) / 3;
    for (int mu = 0; mu < 3; ++mu) j.v(a, mu) = Q(7 * a - 5 * mu + a * a * mu + 1) / 4;
  }
  // Columns: the tangents, the director, and its slopes.
  auto const frame = director_frame(j);
  for (int a = 0; a < 3; ++a) {
    BOOST_TEST((frame(a, 2) == j.y[a + 3]));
    for (int i = 0; i < 2; ++i) {
      BOOST_TEST((frame(a, i) == j.v(a, i + 1)));
      BOOST_TEST((frame(a, 3 + i) == j.v(a + 3, i + 1)));
    }
  }
  auto const strain = []<class V, class M>(V const& x, M const& products) {
    using T = typename M::Scalar;
    return T(products(0, 3) * T(Q(2)) - products(4, 1) + products(2, 2) * x[0] - x[1]);
  };
  Q kinetic(0), d_d(0), first_slope(0), second_slope(0), shear[2] = {Q(0), Q(0)};
  for (int a = 0; a < 3; ++a) {
    kinetic += j.v(a, 0) * j.v(a, 0) * Q(5) + j.v(a + 3, 0) * j.v(a + 3, 0) * Q(3);
    d_d += j.y[a + 3] * j.y[a + 3];
    first_slope += j.v(a, 1) * j.v(a + 3, 1), second_slope += j.v(a + 3, 2) * j.v(a, 2);
    for (int i = 0; i < 2; ++i) shear[i] += j.y[a + 3] * j.v(a, i + 1);
  }
  DirectedBody<Q, decltype(strain)> const body{Q(5), Q(3), strain};
  BOOST_TEST((body(j) == kinetic / 2 - (first_slope * 2 - second_slope + d_d * j.x[1] - j.x[2])));
  BOOST_TEST((UnitDirector{}(j)[0] == (d_d - 1) / 2));
  auto const normal = NormalDirector<2>{}(j);
  BOOST_TEST((normal[0] == shear[0]));
  BOOST_TEST((normal[1] == shear[1]));
  BOOST_TEST((normal[2] == (d_d - 1) / 2));
}

BOOST_AUTO_TEST_CASE(a_paired_constraint_takes_its_multiplier_along_its_jet) {
  WithArithmetic const exactly(Arithmetic::rationals());
  using Q = Number;
  // At another event than that of the multiplier's jet.
  auto const two = constraint<2>([]<class T>(Jet<T, 1, 2> const& j) {
    return Matrix<T, 2, 1>(T(j.y[0] * j.v(1, 1)), T(j.v(0, 0) - j.y[1]));
  });
  Jet<Q, 1, 2> const lambda{{Q(1), Q(2)}, {Q(3), Q(-4)}, (Matrix<Q, 2, 2>() << 5, -1, 2, 7).finished()},
      j{{Q(3), Q(5)}, {Q(2), Q(11)}, (Matrix<Q, 2, 2>() << 6, 1, 8, 9).finished()};
  PairedConstraint<Q, 1, decltype(two)> const paired{two, lambda};
  // (3 + 5 2 - 3, -4 + 2 2 + 7 3) on (2 9, 6 - 11).
  BOOST_TEST((paired(j) == 10 * 18 - 21 * 5));
}

BOOST_AUTO_TEST_CASE(a_heavy_string_has_its_speed_and_its_place_in_gravity) {
  HeavyString<double, 2> const string{0.5, {3, -8}};
  Jet<double, 1, 2> j{{0, 0}, {2, 1}, (Matrix<double, 2, 2>() << 4, 7, 6, 9).finished()};
  BOOST_TEST(string(j) == 0.5 * ((16 + 36) / 2 + 3 * 2 - 8));
  BOOST_TEST((Inextensible{Euclidean<2>{}}(j)[0] == (1 - 49 - 81) / 2.0));
}
