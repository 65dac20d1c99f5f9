// What the scheme of Moser and Veselov conserves: Casimirs of every size, the isospectral integrals along its
// steps, and input that has no answer.
#include <boost/test/unit_test.hpp>

#include "actio/rigid_body/algebra_poisson.hpp"
#include "actio/rigid_body/casimirs.hpp"
#include "actio/rigid_body/isospectral.hpp"
#include "actio/rigid_body/moser_veselov.hpp"
#include "actio/rigid_body/multiplier.hpp"
#include "random_bodies.hpp"
#include "refused.hpp"
#include "witness/draw.hpp"
#include "witness/number.hpp"

using namespace actio;
using Vector3d = actio::Vector<double, 3>;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

// Casimirs of the momentum and integrals of h times it, before a step and a hundred steps later. Each step
// carries the momentum with a rounding error or two; coefficients of a characteristic polynomial of five rows
// are sums of products of up to five entries.
template <int n>
void kept_along_the_scheme() {
  std::mt19937 random(testing::seed);
  auto const [inertia, spin] = testing::random_body<n>(random);
  MoserVeselov<n> const scheme(inertia, 0.3);
  Storage<SO<n>, double> const lambda = inertia.lambda.asDiagonal();
  auto pi = body_momentum(inertia, spin);
  Vector<double> const c = casimirs(pi), i = isospectral_integrals(lambda, 0.3 * pi);
  int const steps = 100;
  for (int k = 0; k < steps; ++k) pi = scheme.step_lie_poisson(pi);
  BOOST_TEST((casimirs(pi) - c).norm() <= 16 * steps * eps * c.norm());
  BOOST_TEST((isospectral_integrals(lambda, 0.3 * pi) - i).norm() <= 16 * steps * eps * i.norm());
  // Control: with another inertia in the matrix of Lax the coefficients are no integrals.
  Storage<SO<n>, double> const other = (lambda * lambda).eval();
  auto const before = isospectral_integrals(other, body_momentum(inertia, spin));
  BOOST_TEST((isospectral_integrals(other, pi) - before).norm() > 1e-4 * before.norm());
}

}  // namespace

BOOST_AUTO_TEST_SUITE(casimirs_and_integrals)

BOOST_AUTO_TEST_CASE(as_many_as_the_rank_of_the_group_asks_for) {
  WithArithmetic const exactly(Arithmetic::rationals());
  FineDraw draw(1);
  for (int n = 2; n <= 7; ++n) {
    SO<Dynamic> group;
    group.n = n;
    auto const mu = draw.momentum<Number>(group);
    auto const c = casimirs(mu);
    BOOST_TEST(c.size() == n / 2);
    Matrix<Number, Dynamic, Dynamic> const m = group.hat(mu.components),
                                           one = Matrix<Number, Dynamic, Dynamic>::Identity(n, n);
    if (n % 2 == 0) {
      // The square of the Pfaffian is the determinant, exactly.
      Number const square = c[n / 2 - 1] * c[n / 2 - 1], determinant = characteristic_coefficients(m)[n - 1];
      BOOST_TEST((square == determinant));
    }
    // Casimirs, and half the dimension of a generic orbit.
    int const orbit = n * (n - 1) / 2 - n / 2;
    BOOST_TEST(isospectral_integrals(one, mu).size() == n / 2 + orbit / 2);
  }
}

BOOST_AUTO_TEST_CASE(the_pfaffian_of_blocks_is_their_product) {
  WithArithmetic const exactly(Arithmetic::rationals());
  // Its sign is that of Pf ((0, 1), (-1, 0)) = 1, in every size.
  for (int const n : {2, 4, 6, 8}) {
    Matrix<Number, Dynamic, Dynamic> m = Matrix<Number, Dynamic, Dynamic>::Zero(n, n);
    Number product(1);
    for (int k = 0; k < n; k += 2) {
      Number const entry(k + 2);
      m(k, k + 1) = entry, m(k + 1, k) = -entry, product = product * entry;
    }
    BOOST_TEST_CONTEXT("size " << n) { BOOST_TEST((pfaffian(m) == product)); }
    // The exchange of two rows, and of the columns with them, turns the sign.
    m.row(0).swap(m.row(1)), m.col(0).swap(m.col(1));
    BOOST_TEST_CONTEXT("size " << n) { BOOST_TEST((pfaffian(m) == -product)); }
  }
  // Pf = a12 a34 - a13 a24 + a14 a23.
  Matrix<Number, Dynamic, Dynamic> m = Matrix<Number, Dynamic, Dynamic>::Zero(4, 4);
  int entry = 0;
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j) m(i, j) = Number(++entry), m(j, i) = -m(i, j);
  BOOST_TEST((pfaffian(m) == Number(1 * 6 - 2 * 5 + 3 * 4)));
}

BOOST_AUTO_TEST_CASE(kept_by_the_scheme) {
  kept_along_the_scheme<3>();
  kept_along_the_scheme<4>();
  kept_along_the_scheme<5>();
}

BOOST_AUTO_TEST_CASE(what_has_no_answer_is_refused) {
  Momentum<SO<4>, double> const mu{{}, Matrix<double, 6, 1>::Ones()};
  auto bad = mu;
  bad.components[2] = std::nan("");
  Matrix<double, 4, 4> const lambda = Vector<double, 4>(1, 2, 3, 4).asDiagonal();
  auto const spin = velocity(SO<3>{}, Vector3d(1, 1, 1));
  CHECK_REFUSED(pfaffian(Matrix<double, 3, 3>(Matrix<double, 3, 3>::Zero())), OutsideDomain);
  CHECK_REFUSED(characteristic_coefficients(Matrix<double>(Matrix<double>::Zero(2, 3))), OutsideDomain);
  CHECK_REFUSED(casimirs(bad), NotFinite);
  CHECK_REFUSED(isospectral_integrals(lambda, bad), NotFinite);
  CHECK_REFUSED(isospectral_integrals(Matrix<double, 3, 3>(Matrix<double, 3, 3>::Identity()), mu),
                OutsideDomain);
  BOOST_CHECK_EXCEPTION(algebra_casimir(Coordinates<SO<3>, double>(1, -2, 3), spin), UnphysicalInertia,
                        [](UnphysicalInertia const& error) { return error.measured == -2; });
  CHECK_REFUSED(algebra_casimir(Coordinates<SO<3>, double>(1, std::nan(""), 3), spin), Error);
  Matrix<double, 3, 3> const body = Vector3d(1, 2, 3).asDiagonal(), one = Matrix<double, 3, 3>::Identity();
  Matrix<double, 3, 3> skew = one, broken = one;
  skew(0, 1) = 1, broken(2, 2) = std::nan("");
  CHECK_REFUSED(euler_poincare_with_multiplier(skew, one, one, one), OutsideDomain);
  CHECK_REFUSED(euler_poincare_without_multiplier(body, broken, one), NotFinite);
  CHECK_REFUSED(constrained_stationarity(body, one, one, one, skew), OutsideDomain);
  // Matrices of other sizes, in their rows, their columns or both.
  using Any = Matrix<double>;
  Any const square = Any::Identity(3, 3), wide = Any::Zero(3, 4), tall = Any::Zero(4, 3), none(0, 0);
  BOOST_CHECK_NO_THROW(euler_poincare_without_multiplier(square, square, square));
  for (Any const& other : {wide, tall, Any(Any::Identity(4, 4)), none})
    CHECK_REFUSED(euler_poincare_without_multiplier(square, square, other), OutsideDomain);
  CHECK_REFUSED(euler_poincare_without_multiplier(none, none, none), OutsideDomain);
}

BOOST_AUTO_TEST_SUITE_END()
