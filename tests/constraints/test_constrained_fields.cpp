// Constraints on first jets and the extended bundle: two routes to the equations, and jets that are refused.
#include <boost/test/unit_test.hpp>

#include "actio/constraints/constrained_equations.hpp"
#include "actio/constraints/directors.hpp"
#include "actio/constraints/inextensible.hpp"

using namespace actio;

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
  try {
    require_regular(constraint, jet_with_slope(0, 0));
    BOOST_FAIL("a jet without a slope is singular");
  } catch (NotRegular const& e) {
    BOOST_TEST(e.point.size() == 8u);
    BOOST_TEST(e.measured == 0);
  }
}

BOOST_AUTO_TEST_CASE(a_director_of_length_zero_is_not_regular) {
  Jet<double, 2, 6> j;
  j.x.setZero(), j.y.setZero(), j.v.setZero();
  BOOST_CHECK_THROW(require_regular(UnitDirector{}, j), NotRegular);
  BOOST_CHECK_THROW(require_regular(NormalDirector<2>{}, j), NotRegular);
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
  BOOST_CHECK_THROW(require_regular(length, jet_with_slope(0, 0)), NoDerivative);
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
  BOOST_CHECK_THROW(euler_lagrange(density, ExtendedSection{at_height(-1), lambda}, x), OutsideDomain);
  BOOST_CHECK_THROW(constrained_field_equations(AboveGround{}, Inextensible{Euclidean<2>{}},
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
