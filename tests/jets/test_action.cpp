// Integrals over boxes of space-time and over their boundaries, and the variation of the action.
#include <boost/test/unit_test.hpp>

#include "actio/jets/prolongation.hpp"
#include "actio/jets/tilted_section.hpp"
#include "polynomial_models.hpp"
#include "witness/number.hpp"

using namespace actio;
using namespace actio::testing;

namespace {

using Q = Number;

template <class S>
Box<S, 1> box() { return {{ratio<S>(-1, 2), ratio<S>(1, 3)}, {ratio<S>(3, 2), S(2)}}; }

template <class S>
S power(S const& x, int k) {
  S p(1);
  for (int i = 0; i < k; ++i) p *= x;
  return p;
}

/// The integral of t^k x^k over the box, by hand.
template <class S>
S by_hand(int k) {
  auto const b = box<S>();
  S product(1);
  for (int mu = 0; mu < 2; ++mu) product *= (power(b.high[mu], k + 1) - power(b.low[mu], k + 1)) / S(k + 1);
  return product;
}
template <class S>
S by_rule(int k, int degree) {
  auto const b = box<S>();
  return integral([k](Matrix<S, 2, 1> const& x) { return S(power(x[0], k) * power(x[1], k)); }, b.low, b.high,
                  degree);
}

/// A section over one space dimension.
struct Line {
  template <class V>
  auto operator()(V const& x) const {
    return Matrix<ScalarOf<V>, 2, 1>(x[0] * x[1] + x[0], x[1] * x[1] - x[0] * 2);
  }
};

/// A variation that moves space-time and places.
struct Tilt {
  template <class V>
  auto operator()(V const& p) const {
    using T = ScalarOf<V>;
    Matrix<T, 4, 1> rate;
    rate << p[0] * p[1], p[0] - p[1] * 2, p[2] * p[1] + p[3], p[0] * p[0] - p[2];
    return rate;
  }
};

/// The section moved by a finite amount.
template <class S>
auto tilted(S const& amount) {
  return [amount]<class V>(V const& x) {
    using T = ScalarOf<V>;
    Matrix<T, 4, 1> point;
    point << x, Line{}(x);
    Matrix<T, 4, 1> const rate = Tilt{}(point);
    for (int i = 0; i < 4; ++i) point[i] += rate[i] * T(amount);
    return point;
  };
}

}  // namespace

BOOST_AUTO_TEST_CASE(quadrature_is_exact_to_its_degree_and_not_one_beyond) {
  WithArithmetic const exactly(Arithmetic::rationals());
  for (int degree = 1; degree <= 6; ++degree) {
    BOOST_TEST((by_rule<Q>(degree, degree) == by_hand<Q>(degree)));
    // An odd number of equally spaced nodes gives one degree for nothing.
    int const beyond = degree % 2 == 0 ? degree + 2 : degree + 1;
    BOOST_TEST((by_rule<Q>(beyond, degree) != by_hand<Q>(beyond)));
    BOOST_TEST(std::abs(by_rule<double>(degree, degree) / by_hand<double>(degree) - 1) <
               100 * epsilon<double>());
    // Gauss's rule with s nodes: 2s - 1 and no more.
    int const most = 2 * (degree / 2 + 1) - 1;
    BOOST_TEST(std::abs(by_rule<double>(most, degree) / by_hand<double>(most) - 1) < 100 * epsilon<double>());
    BOOST_TEST(std::abs(by_rule<double>(most + 1, degree) / by_hand<double>(most + 1) - 1) > 1e-6);
  }
}

BOOST_AUTO_TEST_CASE(boundary_integrals_obey_stokes) {
  WithArithmetic const exactly(Arithmetic::rationals());
  // On boxes of two and of three dimensions, with coefficients of second degree.
  auto const line = []<class S>(Matrix<S, 2, 1> const& x, Tangents<S, 2, 1> const& V) {
    return S(x[0] * x[1] * V(0, 0) + (x[0] * x[0] - x[1]) * V(1, 0));
  };
  auto const d_line = [&](Matrix<Q, 2, 1> const& x) {
    return exterior_derivative(line)(x, Tangents<Q, 2, 2>(Tangents<Q, 2, 2>::Identity()));
  };
  auto const b = box<Q>();
  Q const through = boundary_integral(line, b, 2);
  BOOST_TEST((through == integral(d_line, b.low, b.high, 2)));
  BOOST_TEST((through != 0));
  auto const surface = []<class S>(Matrix<S, 3, 1> const& x, Tangents<S, 3, 2> const& V) {
    Matrix<S, 3, 3> m;
    m << Matrix<S, 3, 1>(x[0] * x[1], x[1] * x[1] + x[2], x[2] * x[0] + x[1]), V;
    return determinant(m);
  };
  auto const d_surface = [&](Matrix<Q, 3, 1> const& x) {
    return exterior_derivative(surface)(x, Tangents<Q, 3, 3>(Tangents<Q, 3, 3>::Identity()));
  };
  Box<Q, 2> const cube{{Q(0), ratio<Q>(-1, 3), ratio<Q>(1, 5)}, {Q(1), Q(2), Q(3)}};
  BOOST_TEST((boundary_integral(surface, cube, 2) == integral(d_surface, cube.low, cube.high, 2)));
}

BOOST_AUTO_TEST_CASE(the_action_of_a_straight_motion_is_that_of_its_speed) {
  WithArithmetic const exactly(Arithmetic::rationals());
  auto const kinetic = []<class T>(Jet<T, 1, 1> const& j) { return T(j.v(0, 0) * j.v(0, 0) / 2); };
  auto const uniform = [](auto const& x) { return Matrix<ScalarOf<decltype(x)>, 1, 1>(x[0] * 3 + x[1]); };
  // 9/2 times the area 2 x 5/3.
  BOOST_TEST((action(kinetic, uniform, box<Q>(), 0) == Q(15)));
}

BOOST_AUTO_TEST_CASE(a_section_that_is_not_tilted_has_its_own_jets_and_action) {
  WithArithmetic const exactly(Arithmetic::rationals());
  Matrix<Q, 2, 1> const x(ratio<Q>(1, 3), ratio<Q>(1, 2));
  auto const at_rest = tilted_jet(tilted(Q(0)), x);
  auto const j = first_jet(Line{}, x);
  BOOST_TEST((at_rest.jet.v == j.v));
  BOOST_TEST((at_rest.stretch == 1));
  BOOST_TEST((tilted_action(Density{}, tilted(Q(0)), box<Q>(), 8) == action(Density{}, Line{}, box<Q>(), 8)));
}

BOOST_AUTO_TEST_CASE(a_tilted_section_has_the_jets_of_the_section_it_makes) {
  WithArithmetic const exactly(Arithmetic::rationals());
  // t and x exchanged for u: x = (2u + w, w - u), and the section y = (t x, t + x^2) written on it.
  auto const straight = [](auto const& x) {
    return Matrix<ScalarOf<decltype(x)>, 2, 1>(x[0] * x[1], x[0] + x[1] * x[1]);
  };
  auto const map = [&]<class V>(V const& u) {
    using T = ScalarOf<V>;
    Matrix<T, 2, 1> const x(u[0] * 2 + u[1], u[1] - u[0]);
    Matrix<T, 4, 1> point;
    point << x, straight(x);
    return point;
  };
  Matrix<Q, 2, 1> const u(ratio<Q>(1, 3), ratio<Q>(1, 2));
  auto const tilted = tilted_jet(map, u);
  BOOST_TEST((tilted.jet.v == first_jet(straight, tilted.jet.x).v));
  BOOST_TEST((tilted.stretch == 3));
}

BOOST_AUTO_TEST_CASE(the_variation_of_the_action_is_the_limit_of_its_differences) {
  // Differences about zero have an error of second order in the step: four times less for half of it.
  auto const rate = action_variation(Density{}, Line{}, Tilt{}, box<double>(), 12);
  auto const error = [&](double h) {
    return std::abs((tilted_action(Density{}, tilted(h), box<double>(), 24) -
                     tilted_action(Density{}, tilted(-h), box<double>(), 24)) /
                        (2 * h) -
                    rate);
  };
  double const coarse = error(2e-3), fine = error(1e-3);
  BOOST_TEST(coarse / fine > 3.9);
  BOOST_TEST(coarse / fine < 4.1);
  BOOST_TEST(fine < 1e-3 * std::abs(rate));
}

BOOST_AUTO_TEST_CASE(the_variation_of_the_action_is_exact_over_the_rationals) {
  WithArithmetic const exactly(Arithmetic::rationals());
  // The derivative of a polynomial that a second computation finds term by term: the bulk and the boundary.
  auto const b = box<Q>();
  auto const bulk = [](Matrix<Q, 2, 1> const& x) {
    auto const j = second_jet(Line{}, x);
    return Q(euler_lagrange(Density{}, j).dot(vertical_part<Q, 1, 2>(j, Tilt{}(point_of<Q, 1, 2>(j)))));
  };
  auto const current = []<class S>(Matrix<S, 2, 1> const& x, Tangents<S, 2, 1> const& V) {
    auto const j = first_jet(Line{}, x);
    auto const B = boundary_current(Density{}, j, Tilt{}(point_of(j)));
    return S(B[0] * V(1, 0) - B[1] * V(0, 0));
  };
  BOOST_TEST((action_variation(Density{}, Line{}, Tilt{}, b, 12) ==
              integral(bulk, b.low, b.high, 12) + boundary_integral(current, b, 12)));
}

BOOST_AUTO_TEST_CASE(a_map_that_covers_no_embedding_is_refused) {
  Matrix<double, 2, 1> const x(0.25, 0.5);
  auto const reflected = []<class V>(V const& u) {
    Matrix<ScalarOf<V>, 4, 1> point;
    point << -u[0], u[1], u[0], u[1];
    return point;
  };
  BOOST_CHECK_EXCEPTION(tilted_jet(reflected, x), NotAnEmbedding, [](NotAnEmbedding const& e) {
    return e.measured == -1 && e.bound == 0 && std::string(e.what()).find("(0.25, 0.5)") != std::string::npos;
  });
}
