// Truncated polynomials against gradients and Hessians that are written out in full.
#include <boost/test/unit_test.hpp>

#include <random>

#include "actio/numbers/second_order.hpp"
#include "actio/numbers/square_root.hpp"
#include "witness/number.hpp"

using namespace actio;

namespace {

std::mt19937_64 source(7);
/// k/7 with k from 1 to 13.
template <class S>
S drawn() { return ratio<S>(1 + static_cast<long>(source() % 13), 7); }
template <class S, int m>
SecondOrder<S, m> drawn_polynomial() {
  SecondOrder<S, m> x(drawn<S>());
  for (S& f : x.first) f = drawn<S>();
  for (S& s : x.second) s = drawn<S>() - S(1);
  return x;
}

/// Value, gradient and Hessian with all its entries.
template <class S, int m>
struct Full {
  S value;
  Matrix<S, m, 1> g;
  Matrix<S, m, m> H;
};
template <class S, int m>
Full<S, m> full(SecondOrder<S, m> const& x) {
  Full<S, m> y{x.value, {}, {}};
  for (int i = 0, k = 0; i < m; ++i) {
    y.g[i] = x.first[i];
    for (int j = 0; j <= i; ++j, ++k) y.H(i, j) = y.H(j, i) = x.second[k];
  }
  return y;
}
template <class S, int m>
Full<S, m> product(Full<S, m> const& x, Full<S, m> const& y) {
  return {x.value * y.value, x.g * y.value + y.g * x.value,
          x.H * y.value + y.H * x.value + x.g * y.g.transpose() + y.g * x.g.transpose()};
}
/// A function with derivatives d and e where its value is f.
template <class S, int m>
Full<S, m> applied(Full<S, m> const& x, S const& f, S const& d, S const& e) {
  return {f, x.g * d, x.H * d + x.g * x.g.transpose() * e};
}
/// By how much two differ.
template <class S, int m>
S apart(SecondOrder<S, m> const& x, Full<S, m> const& y) {
  auto const z = full(x);
  return std::max({magnitude(S(z.value - y.value)), magnitude(Matrix<S, m, 1>(z.g - y.g)),
                   magnitude(Matrix<S, m, m>(z.H - y.H))});
}

}  // namespace

BOOST_AUTO_TEST_SUITE(truncated_polynomials)

BOOST_AUTO_TEST_CASE(a_product_of_truncated_polynomials_is_the_rule_of_leibniz) {
  WithArithmetic const exactly(Arithmetic::rationals());
  using Q = Number;
  for (int k = 0; k < 3; ++k) {
    auto const x = drawn_polynomial<Q, 3>(), y = drawn_polynomial<Q, 3>();
    auto const p = full(x), q = full(y);
    Q const c = ratio<Q>(3, 5);
    BOOST_TEST((apart(x + y, Full<Q, 3>{p.value + q.value, p.g + q.g, p.H + q.H}) == 0));
    BOOST_TEST((apart(x - y, Full<Q, 3>{p.value - q.value, p.g - q.g, p.H - q.H}) == 0));
    BOOST_TEST((apart(-x, Full<Q, 3>{-p.value, -p.g, -p.H}) == 0));
    BOOST_TEST((apart(x * y, product(p, q)) == 0));
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) BOOST_TEST((x.second[x.at(i, j)] == p.H(i, j)));
    // A quotient is what the divisor makes the dividend of.
    BOOST_TEST((product(full(x / y), q).value == p.value));
    BOOST_TEST((apart(x, product(full(x / y), q)) == 0));
    for (auto const& z : {x + c, c + x}) BOOST_TEST((apart(z, Full<Q, 3>{p.value + c, p.g, p.H}) == 0));
    BOOST_TEST((apart(x - c, Full<Q, 3>{p.value - c, p.g, p.H}) == 0));
    BOOST_TEST((apart(c - x, Full<Q, 3>{c - p.value, -p.g, -p.H}) == 0));
    for (auto const& z : {x * c, c * x}) BOOST_TEST((apart(z, applied(p, Q(c * p.value), c, Q(0))) == 0));
    BOOST_TEST((apart(x / c, applied(p, Q(p.value / c), Q(1 / c), Q(0))) == 0));
    BOOST_TEST((apart(c / x, applied(p, Q(c / p.value), Q(-c / (p.value * p.value)),
                                     Q(2 * c / (p.value * p.value * p.value)))) == 0));
    BOOST_TEST((apart(square_root(SecondOrder<Q, 3>(x * x)), p) == 0));
    auto const variable = SecondOrder<Q, 3>::variable(c, 1);
    BOOST_TEST(
        (apart(variable, Full<Q, 3>{c, Matrix<Q, 3, 1>(Q(0), Q(1), Q(0)), Matrix<Q, 3, 3>::Zero()}) == 0));
  }
}

BOOST_AUTO_TEST_CASE(functions_of_truncated_polynomials_have_their_second_derivatives) {
  auto const x = drawn_polynomial<double, 3>();
  auto const p = full(x);
  double const v = x.value, e = std::exp(v), s = std::sin(v), c = std::cos(v), r = std::sqrt(v), w = 1.7;
  double const allowed = 64 * epsilon<double>() * 14 * 14 * e * 49;
  BOOST_TEST(apart(sqrt(x), applied(p, r, 1 / (2 * r), -1 / (4 * r * v))) <= allowed);
  BOOST_TEST(apart(square_root(x), applied(p, r, 1 / (2 * r), -1 / (4 * r * v))) <= allowed);
  BOOST_TEST(apart(exp(x), applied(p, e, e, e)) <= allowed);
  BOOST_TEST(apart(log(x), applied(p, std::log(v), 1 / v, -1 / (v * v))) <= allowed);
  BOOST_TEST(apart(sin(x), applied(p, s, c, -s)) <= allowed);
  BOOST_TEST(apart(cos(x), applied(p, c, -s, -c)) <= allowed);
  BOOST_TEST(apart(pow(x, w), applied(p, std::pow(v, w), w * std::pow(v, w - 1),
                                      w * (w - 1) * std::pow(v, w - 2))) <= allowed);
}

BOOST_AUTO_TEST_SUITE_END()
