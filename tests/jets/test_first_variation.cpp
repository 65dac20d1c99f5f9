// The linearised field equations and the current of two variations.
#include <boost/test/unit_test.hpp>

#include "actio/jets/first_variation.hpp"
#include "polynomial_models.hpp"
#include "witness/number.hpp"

using namespace actio;
using namespace actio::testing;

namespace {

using Q = Number;

/// Two vertical variations.
struct One {
  template <class V>
  auto operator()(V const& x) const {
    return Matrix<ScalarOf<V>, 2, 1>(x[0] * x[0] - x[1] * x[2], x[2] * x[2] * x[0] + x[1]);
  }
};
struct Other {
  template <class V>
  auto operator()(V const& x) const {
    return Matrix<ScalarOf<V>, 2, 1>(x[1] + x[2] * x[2], x[0] * x[1] - x[0] * x[0] * 3);
  }
};

auto current_of = []<class V, class W>(V const& v, W const& w) {
  return [v, w]<class T>(Matrix<T, 3, 1> const& x) {
    return multisymplectic_current(Density{}, first_jet(Motion{}, x), first_jet(v, x), first_jet(w, x));
  };
};

/// A density that has two derivatives and no third where the strain vanishes.
struct PowerOfStrain {
  template <class T>
  T operator()(Jet<T, 1, 1> const& j) const {
    using std::sqrt;
    T const strain = sqrt(j.v(0, 1));
    return T(j.v(0, 0) * j.v(0, 0) - strain * j.v(0, 1));
  }
};

}  // namespace

BOOST_AUTO_TEST_CASE(the_linearised_equations_are_the_limit_of_differences) {
  WithArithmetic const exactly(Arithmetic::rationals());
  auto const x = event<Q>();
  auto const moved = [&](Q const& h) {
    return euler_lagrange(
        Density{}, [h](auto const& u) { return (Motion{}(u) + One{}(u)*ScalarOf<decltype(u)>(h)).eval(); },
        x);
  };
  // A cubic in h: two pairs of differences give its linear term without an error.
  auto const slope = [&](Q const& h) { return ((moved(h) - moved(-h)) / (h + h)).eval(); };
  auto const exact = ((slope(Q(1)) * Q(4) - slope(Q(2))) / Q(3)).eval();
  auto const rate = linearised_euler_lagrange(Density{}, second_jet(Motion{}, x), second_jet(One{}, x));
  BOOST_TEST((rate == exact));
  BOOST_TEST((rate[0] != 0));
}

BOOST_AUTO_TEST_CASE(the_divergence_of_the_current_is_greens_identity) {
  WithArithmetic const exactly(Arithmetic::rationals());
  auto const x = event<Q>();
  auto const j = second_jet(Motion{}, x), v = second_jet(One{}, x), w = second_jet(Other{}, x);
  Q const right = v.y.dot(linearised_euler_lagrange(Density{}, j, w)) -
                  w.y.dot(linearised_euler_lagrange(Density{}, j, v));
  BOOST_TEST((divergence(current_of(One{}, Other{}), x) == right));
  BOOST_TEST((right != 0));
  BOOST_TEST((divergence(current_of(One{}, One{}), x) == 0));
}

BOOST_AUTO_TEST_CASE(the_current_is_the_multisymplectic_form_on_two_lifted_variations) {
  WithArithmetic const exactly(Arithmetic::rationals());
  auto const x = event<Q>();
  auto const j = first_jet(Motion{}, x), v = first_jet(One{}, x), w = first_jet(Other{}, x);
  auto const lifted = [](Jet<Q, 2, 2> jet) {
    jet.x.setZero();
    return coordinates(jet);
  };
  auto const current = multisymplectic_current(Density{}, j, v, w);
  for (int mu = 0; mu < 3; ++mu) {
    Tangents<Q, 3, 2> sides = Tangents<Q, 3, 2>::Zero();
    for (int nu = 0, k = 0; nu < 3; ++nu)
      if (nu != mu) sides(nu, k++) = Q(1);
    // V hook W hook Omega: W goes into the first slot before V does.
    Tangents<Q, 11, 4> all;
    all << lifted(w), lifted(v), pushed(jet_extension(Motion{}), x, sides);
    Q const value = multisymplectic_form<2, 2>(Density{})(coordinates(j), all);
    BOOST_TEST((current[mu] == (mu % 2 == 0 ? value : Q(-value))));
  }
}

BOOST_AUTO_TEST_CASE(the_boundary_current_of_a_vertical_variation_has_the_momenta_alone) {
  WithArithmetic const exactly(Arithmetic::rationals());
  auto const j = first_jet(Motion{}, event<Q>());
  Variation<Q, 2, 2> V = tangents<Q, 5, 1>();
  V.head<3>().setZero();
  Matrix<Q, 3, 1> const expected = momenta(Density{}, j).transpose() * V.tail<2>();
  BOOST_TEST((boundary_current(Density{}, j, V) == expected));
  // The variation that drags a section along itself is no variation of places at all.
  Variation<Q, 2, 2> drag;
  drag << Q(1), Q(-2), Q(3), (j.v * Matrix<Q, 3, 1>(Q(1), Q(-2), Q(3))).eval();
  BOOST_TEST((boundary_current(Density{}, j, drag) == (drag.head<3>() * Density{}(j)).eval()));
}

BOOST_AUTO_TEST_CASE(a_density_without_a_third_derivative_refuses_to_be_linearised_there) {
  auto const flat = [](auto const& x) { return Matrix<ScalarOf<decltype(x)>, 1, 1>(x[0] * x[0]); };
  auto const j = second_jet(flat, Vector<double, 2>(0.25, 0.5));
  BOOST_CHECK_EXCEPTION(
      linearised_euler_lagrange(PowerOfStrain{}, j, j), NoDerivative,
      [](NoDerivative const& e) { return std::string(e.what()).find("(0.25, 0.5)") != std::string::npos; });
}
