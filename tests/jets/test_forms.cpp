// Laws of forms, exactly over the rationals.
#include <boost/test/unit_test.hpp>

#include "actio/forms/wedge.hpp"
#include "actio/linear_algebra/determinant.hpp"
#include "polynomial_models.hpp"
#include "witness/number.hpp"

using namespace actio;
using namespace actio::testing;

namespace {

using Q = Number;

/// A map of the plane into 4-space.
struct Surface {
  template <class V>
  auto operator()(V const& u) const {
    using T = ScalarOf<V>;
    Matrix<T, 4, 1> x;
    x << u[0] * u[1], u[1] - u[0] * u[0] * 2, u[2] * u[0] + 1, u[0] + u[1] * u[2];
    return x;
  }
};

/// A vector field on 4-space.
struct Stream {
  template <class V>
  auto operator()(V const& x) const {
    using T = ScalarOf<V>;
    Matrix<T, 4, 1> w;
    w << x[1], x[0] * x[3], x[2] - 2, x[1] * x[1];
    return w;
  }
};

}  // namespace

/// What is calculated over the rationals, and a point of 4-space.
struct OverTheRationals {
  WithArithmetic const exactly{Arithmetic::rationals()};
  Matrix<Q, 4, 1> const at{ratio<Q>(1, 2), ratio<Q>(-2, 3), Q(3), ratio<Q>(5, 7)};
};

BOOST_FIXTURE_TEST_CASE(a_form_differentiated_twice_is_zero, OverTheRationals) {
  auto const once = exterior_derivative(TwoForm{});
  BOOST_TEST((once(at, tangents<Q, 4, 3>()) != 0));
  auto const coordinate = [](auto const& x, auto const&) {
    return decltype(x[0] * x[0])(x[0] * x[1] * x[2] + x[3] * x[3] * x[0]);
  };
  auto const d =
      exterior_derivative([coordinate]<class S>(Matrix<S, 4, 1> const& x, Tangents<S, 4, 1> const& V) {
        // x^1 d(f), with f the function above: not closed.
        return S(coordinate(x, V) * V(1, 0));
      });
  BOOST_TEST((d(at, tangents<Q, 4, 2>()) != 0));
  BOOST_TEST((exterior_derivative(d)(at, tangents<Q, 4, 3>()) == 0));
  BOOST_TEST((exterior_derivative(once)(at, Tangents<Q, 4, 4>(Tangents<Q, 4, 4>::Identity())) == 0));
}

BOOST_FIXTURE_TEST_CASE(pull_back_commutes_with_the_exterior_derivative, OverTheRationals) {
  Matrix<Q, 3, 1> const u(ratio<Q>(1, 3), ratio<Q>(-3, 2), Q(2));
  auto const V = tangents<Q, 3, 3>();
  Q const before = pull_back(Surface{}, exterior_derivative(TwoForm{}))(u, V),
          after = exterior_derivative(pull_back(Surface{}, TwoForm{}))(u, V);
  BOOST_TEST((before == after));
  BOOST_TEST((before != 0));
}

BOOST_FIXTURE_TEST_CASE(a_vector_contracted_twice_gives_zero_and_two_anticommute, OverTheRationals) {
  auto const other = [](auto const& x) { return Stream{}(Stream{}(x)); };
  Tangents<Q, 4, 0> const none;
  BOOST_TEST((contract(Stream{}, contract(Stream{}, TwoForm{}))(at, none) == 0));
  Q const one = contract(Stream{}, contract(other, TwoForm{}))(at, none),
          two = contract(other, contract(Stream{}, TwoForm{}))(at, none);
  BOOST_TEST((one == -two));
  BOOST_TEST((one != 0));
}

BOOST_FIXTURE_TEST_CASE(contraction_fills_the_first_slot, OverTheRationals) {
  auto const V = tangents<Q, 4, 1>();
  Tangents<Q, 4, 2> both;
  both << Stream{}(at), V;
  BOOST_TEST((contract(Stream{}, TwoForm{})(at, V) == TwoForm{}(at, both)));
}

BOOST_FIXTURE_TEST_CASE(exterior_products_are_alternating_and_obey_the_product_rule, OverTheRationals) {
  auto const dx = differential_of_coordinate(2);
  auto const product = wedge(dx, TwoForm{});
  auto const V = tangents<Q, 4, 3>();
  Tangents<Q, 4, 3> swapped = V, twice = V;
  swapped.col(0) = V.col(2), swapped.col(2) = V.col(0);
  twice.col(1) = V.col(0);
  BOOST_TEST((product(at, V) == -product(at, swapped)));
  BOOST_TEST((product(at, V) != 0));
  BOOST_TEST((product(at, twice) == 0));
  // d(dx ^ omega) = -dx ^ d omega.
  Tangents<Q, 4, 4> const W = Tangents<Q, 4, 4>::Identity();
  BOOST_TEST((wedge(dx, wedge(dx, TwoForm{}))(at, W) == 0));
  BOOST_TEST((exterior_derivative(product)(at, W) == -wedge(dx, exterior_derivative(TwoForm{}))(at, W)));
  BOOST_TEST((exterior_derivative(product)(at, W) != 0));
}

BOOST_FIXTURE_TEST_CASE(determinants_without_division_agree_with_elimination, OverTheRationals) {
  auto const m = tangents<Q, 5, 5>();
  BOOST_TEST((determinant(m) == determinant_by_elimination(m.transpose())));
  BOOST_TEST((determinant(m) != 0));
}
