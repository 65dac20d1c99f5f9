// Derivatives of densities, and the Euler-Lagrange derivative, are those of closed forms.
#include <boost/test/unit_test.hpp>

#include "actio/jets/field_equations.hpp"
#include "witness/number.hpp"

using namespace actio;

namespace {

/// A second jet of no section in particular, of whole numbers over 7.
template <class S, int n, int N>
SecondJet<S, n, N> any_second_jet() {
  int k = 1;
  auto const next = [&k] { return ratio<S>((k = (5 * k + 3) % 23) - 11, 7); };
  SecondJet<S, n, N> j;
  for (int mu = 0; mu <= n; ++mu) j.x[mu] = next();
  for (int a = 0; a < N; ++a) {
    j.y[a] = next();
    for (int mu = 0; mu <= n; ++mu) {
      j.v(a, mu) = next();
      for (int nu = 0; nu <= mu; ++nu) j.w[mu](a, nu) = j.w[nu](a, mu) = next();
    }
  }
  return j;
}

/// The density \f$\tfrac12\dot\phi^2 - \tfrac12c\,\phi_x^2 - \tfrac14x\,\phi^4\f$ of a wave equation with a
/// term of third degree.
struct Wave {
  template <class T>
  T operator()(Jet<T, 1, 1> const& j) const {
    T const square = j.y[0] * j.y[0];
    return j.v(0, 0) * j.v(0, 0) / T(2) - j.v(0, 1) * j.v(0, 1) * T(3) / T(2) -
           j.x[1] * square * square / T(4);
  }
};

}  // namespace

BOOST_AUTO_TEST_CASE(the_field_equation_of_a_wave_is_the_wave_equation) {
  WithArithmetic const exactly(Arithmetic::rationals());
  auto const j = any_second_jet<Number, 1, 1>();
  Number const y = j.y[0], expected = -j.x[1] * y * y * y - j.w[0](0, 0) + 3 * j.w[1](0, 1);
  BOOST_TEST((euler_lagrange(Wave{}, j)[0] == expected));
  BOOST_TEST((momentum_divergence(Wave{}, j)[0] == j.w[0](0, 0) - 3 * j.w[1](0, 1)));
}

BOOST_AUTO_TEST_CASE(partial_and_total_derivatives_are_those_of_closed_forms) {
  WithArithmetic const exactly(Arithmetic::rationals());
  auto const j = any_second_jet<Number, 1, 1>();
  Jet<Number, 1, 1> const& first = j;
  Number const y = j.y[0];
  BOOST_TEST((partial_y(Wave{}, first)[0] == -j.x[1] * y * y * y));
  BOOST_TEST((partial_v(Wave{}, first) == Matrix<Number, 1, 2>(j.v(0, 0), Number(-3) * j.v(0, 1))));
  BOOST_TEST((partial_v(Wave{}, first, 1) == partial_v(Wave{}, first).col(1)));
  // The partial derivative by the place of the body leaves y and v alone, the total one takes them along.
  Number const quarter = y * y * y * y / 4;
  BOOST_TEST((partial_x(Wave{}, first) == Event<Number, 1>(Number(0), -quarter)));
  Number const along_body =
      -quarter - j.x[1] * y * y * y * j.v(0, 1) + j.v(0, 0) * j.w[0](0, 1) - 3 * j.v(0, 1) * j.w[1](0, 1);
  BOOST_TEST((total_derivative(1, Wave{}, j) == along_body));
  // Of a matrix, entry by entry.
  auto const gradient = total_derivative(
      0, [](auto const& z) { return z.v; }, j);
  BOOST_TEST((gradient == j.w[0]));
}
