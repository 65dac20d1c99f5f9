// What a group refuses, with the figure that was measured, known by hand; and what it restores.
#include <boost/test/unit_test.hpp>


#include "actio/groups/affine_line.hpp"
#include "actio/groups/direct_product.hpp"
#include "actio/groups/motions.hpp"
#include "actio/groups/rotations_of_any_size.hpp"
#include "actio/groups/semidirect_product.hpp"
#include "actio/groups/spanned_group.hpp"
#include "actio/groups/special_linear.hpp"
#include "actio/groups/symplectic_groups.hpp"
#include "actio/groups/unipotent_groups.hpp"
#include "actio/groups/unit_quaternions.hpp"
#include "actio/groups/unitary_groups.hpp"
#include "refused.hpp"

using namespace actio;

namespace {

double const eps = epsilon<double>();
using Square = actio::Matrix<double>;
using Column = actio::Vector<double>;
using WholeMatrix = SpannedGroup::WholeMatrix;

/// What f refuses: a figure and a bound, to rounding.
template <class F>
void refuses(char const* what, F const& f, double measured, double bound) {
  try {
    f();
    BOOST_ERROR(what << " is not refused");
  } catch (OutsideDomain const& e) {
    BOOST_TEST(std::abs(e.measured - measured) <= 64 * eps * (1 + std::abs(measured)),
               what << ": " << e.measured << " instead of " << measured);
    BOOST_TEST(e.bound == bound, what << ": bound " << e.bound);
  }
}
template <class G>
void restores_not(char const* what, G const& group, Storage<G, double> const& a, double measured,
                  double bound = 0.1) {
  refuses(
      what, [&] { primitive::restore(group, a); }, measured, bound);
}
template <class G>
void has_no_log(char const* what, G const& group, Storage<G, double> const& a, double measured,
                double bound) {
  refuses(
      what, [&] { primitive::log_of<G, double>(group, a); }, measured, bound);
}
Square with(Square a, Index i, Index j, double x) {
  a(i, j) = x;
  return a;
}
Square one(int n) { return Square::Identity(n, n); }

}  // namespace

BOOST_AUTO_TEST_SUITE(refusals_of_groups)

BOOST_AUTO_TEST_CASE(a_matrix_that_is_not_near_is_refused_with_its_distance) {
  // R^T R - 1 of diag(1, 1.06, 1) is 0.1236; with 1.04 it is 0.0816, which is near.
  restores_not("SO(3)", SO<3>{}, with(one(3), 1, 1, 1.06), 0.1236);
  restores_not("SO(n)", SO<Dynamic>{3}, with(one(3), 1, 1, 1.06), 0.1236);
  BOOST_CHECK_NO_THROW(SO<3>::restore(Matrix<double, 3, 3>(with(one(3), 1, 1, 1.04))));
  restores_not("SU(2)", SU2{}, actio::Vector<double, 4>(1, 0, 0, 0.5), 0.25);
  restores_not("SL(2)", SL2{}, with(one(2), 0, 0, 1.25), 0.25);
  restores_not("SL(2), below", SL2{}, with(one(2), 1, 1, 0.75), 0.25);
  restores_not("SL(3)", SL<>(3), with(with(one(3), 1, 1, 0.75), 0, 2, 9), 0.25);
  // The entry of -J A^T J A - 1 in the second row is 3/2, in the first 1/2 beside 0.
  restores_not("Sp(2)", Sp<>(2), with(one(2), 0, 0, 1.5), 0.5);
  restores_not("Sp(4)", Sp<>(4), with(one(4), 0, 1, 0.25), 0.25);
  restores_not("U(1)", U<>(1), Square(one(2) * 1.5), 1.25);
  // Half of what is not complex linear: ((1, 0), (0, 1 + 2d)) is 1 + d beside ((-d, 0), (0, d)).
  restores_not("U(1), real linear", U<>(1), with(one(2), 1, 1, 0.5), 1 - 0.75 * 0.75);
  restores_not("U(1), conjugate", U<>(1), with(with(one(2), 1, 1, -1), 1, 0, 0), 1);
  // A turn of both phases by the angle with sine 3/5: the determinant is (4 + 3i)^2/25 = (7 + 24i)/25.
  Square phases = one(4) * 0.8;
  for (int k = 0; k < 2; ++k) phases(2 + k, k) = 0.6, phases(k, 2 + k) = -0.6;
  restores_not("SU(2) as matrices", SU<>(2), phases, 0.96);
  phases = one(4) * -1;
  phases(0, 0) = phases(2, 2) = 1;
  restores_not("SU(2), determinant -1", SU<>(2), phases, 2);

  // Blocks: rows of the parts outside are added.
  DirectProduct<SO<3>, Aff1> const product;
  restores_not("product", product, with(with(one(5), 1, 3, 0.25), 1, 4, -0.5), 0.75);
  restores_not("product, below", product, with(one(5), 4, 0, -0.25), 0.25);
  has_no_log("product", product, with(one(5), 4, 0, 1e-6), 1e-6, 1e-8);
  Storage<DirectProduct<SO<3>, Aff1>, double> const nearly = with(one(5), 4, 0, 1e-9);
  BOOST_CHECK_NO_THROW(product.log(nearly));
  SemidirectProduct<SL<2>> const motions;
  restores_not("last row", motions, with(with(with(one(3), 2, 0, 0.25), 2, 1, -0.5), 2, 2, 0.875), 0.875);
  has_no_log("last row", motions, with(one(3), 2, 1, 1e-6), 1e-6, 1e-8);

  // Through Cayley's transform: the projection of ((a, 0), (0, b)) on Aff(1) has its stretching.
  struct ByCayley : Matrices<2, 1> {
    static Matrix<double, 2, 2> hat(Matrix<double, 1, 1> const& v) { return {{v[0], 0}, {0, 0}}; }
    static Matrix<double, 1, 1> vee(Matrix<double, 2, 2> const& a) { return Matrix<double, 1, 1>(a(0, 0)); }
  };
  restores_not("by way of the algebra", ByCayley{}, with(with(one(2), 0, 0, 2), 1, 1, 1.5), 0.25);
  Matrix<double, 2, 2> const back = primitive::restore(ByCayley{}, Matrix<double, 2, 2>{{2, 0}, {0, 1.125}});
  BOOST_TEST(magnitude(Square(back - Square{{2, 0}, {0, 1}})) <= 16 * eps);
}

BOOST_AUTO_TEST_CASE(a_logarithm_outside_of_the_algebra_is_refused_with_its_distance) {
  // log diag(2, 2) = log 2, of which nothing is traceless.
  double const l = std::log(2);
  has_no_log("SL(2) of its family", SL<>(2), one(2) * 2, l / (1 + l), 1e-8);
  has_no_log("SL(3)", SL<>(3), with(one(3), 0, 0, 2), l / 3 / (1 + l), 1e-8);
  has_no_log("Sp(2)", Sp<>(2), with(one(2), 0, 0, 2), l / 2 / (1 + l), 1e-8);
  has_no_log("U(1)", U<>(1), one(2) * 2, l / (1 + l), 1e-8);
  has_no_log("half a turn", SO<2>{}, one(2) * -1, M_PI, M_PI);
  has_no_log("half a turn", SO<3>{}, with(with(one(3), 0, 0, -1), 2, 2, -1), M_PI, M_PI);
  has_no_log("a whole turn", SU2{}, actio::Vector<double, 4>(-1, 0, 0, 0), 2 * M_PI, 2 * M_PI);
  Matrix<double, 5, 5> const five = with(with(one(5), 0, 0, -1), 3, 3, -1);
  has_no_log("half a turn", SO<5>{}, five, M_PI, M_PI);
}

BOOST_AUTO_TEST_CASE(orders_have_two_ends) {
  refuses(
      "U(0)", [] { U<>(0); }, 0, 1);
  refuses(
      "SL(1)", [] { SL<>(1); }, 1, 2);
  refuses(
      "SL(1001)", [] { SL<>(1001); }, 1001, 1000);
  refuses(
      "Sp(3)", [] { Sp<>(3); }, 3, 4);
  refuses(
      "Sp(0)", [] { Sp<>(0); }, 0, 2);
  BOOST_TEST((SL<>(2).dimension() == 3 && SL<>(1000).matrix_size() == 1000 && U<>(1).dimension() == 1));
  BOOST_TEST((Sp<>(1000).dimension() == 500500 && SU<>(3).dimension() == 8 && SU<>(3).matrix_size() == 6));
  BOOST_TEST((follows_from<Dynamic>(7) == Dynamic && follows_from<3>(7) == 7));
  refuses(
      "a stretching by zero",
      [] {
        Aff1::inverse(Matrix<double, 2, 2>{{0, 3}, {0, 1}});
      },
      0, 0);
}

BOOST_AUTO_TEST_CASE(a_basis_that_spans_no_group_is_refused_with_what_is_wrong) {
  auto const group = [](std::vector<WholeMatrix> const& basis, Retraction choice = Retraction::automatic) {
    return [=] { SpannedGroup("", basis, choice); };
  };
  WholeMatrix const up{{0, 1}, {0, 0}}, down{{0, 0}, {1, 0}}, level{{1, 0}, {0, -1}};
  refuses("no basis", group({}), 0, 1);
  refuses("not square", group({WholeMatrix::Zero(2, 3)}), 3, 2);
  refuses("of two sizes", group({up, WholeMatrix::Identity(3, 3)}), 3, 2);
  refuses("large entries", group({up, WholeMatrix{{0, 0}, {-1001, 0}}}), 1001, 1000);
  BOOST_CHECK_NO_THROW(group({WholeMatrix{{0, -1000}, {0, 0}}})());
  // [up, down] = level, and [up, 3 down] = 3 level.
  refuses("not closed", group({up, down}), 1, 0);
  refuses("not closed", group({up, WholeMatrix(3 * down)}), 3, 0);
  CHECK_REFUSED(group({up, up})(), Singular);
  BOOST_CHECK_NO_THROW(group({up, down, level})());
  // (1000 - 1)-fold products of whole numbers: Gram's determinant is beyond 10^12.
  WholeMatrix a = WholeMatrix::Zero(4, 4), b = a, c = a;
  a(0, 3) = 997, a(0, 2) = 1, b(0, 3) = 991, b(0, 1) = 1, c(0, 3) = 983, c(1, 3) = 977;
  try {
    group({a, b, c})();
  } catch (OutsideDomain const& e) {
    BOOST_TEST((e.measured > 1e12 && e.bound == 1e12));
  }
  WholeMatrix weights = WholeMatrix::Zero(3, 3);
  weights.diagonal() << 1, 1, -2;
  refuses("a cube outside", group({WholeMatrix(weights)}), 1, 0);
  refuses("by Cayley", group({WholeMatrix(weights)}, Retraction::cayley), 1, 0);
}

BOOST_AUTO_TEST_CASE(what_is_restored_is_on_the_group_and_as_near_as_it_may_be) {
  double const d = 1e-4;
  // SU(n): an element times a phase by n angles d has the determinant e^{ind}, and is turned back.
  for (int const n : {2, 3, 4}) {
    SU<> const group(n);
    Column const v = Column::Constant(group.dimension(), 0.3) + 0.1 * Column::Unit(group.dimension(), 1);
    Square const g = group.retract(v);
    Square turn = one(2 * n) * std::cos(d);
    for (int k = 0; k < n; ++k) turn(n + k, k) = std::sin(d), turn(k, n + k) = -std::sin(d);
    // What is left is of the third power of n d.
    BOOST_TEST(magnitude(Square(group.restore(Square(turn * g)) - g)) <= std::pow(n * d, 3) + 64 * eps);
    BOOST_TEST(magnitude(Square(SL<>(n).restore(Square(one(n) * (1 + d))) - one(n))) <=
               std::pow(n * d, 3) + 64 * eps);
  }
  // U(n): what is not complex linear is taken away whole, what is Hermitian to second order.
  Square const unitary = primitive::retract(U<>(2), Column(0.1, -0.2, 0.3, 0.4));
  Square const rest{{1, 2, 3, -1}, {-2, 1, 4, 5}, {3, -1, -1, -2}, {4, 5, 2, -1}};
  BOOST_TEST(magnitude(Square(U<>(2).restore(Square(unitary + d * rest)) - unitary)) <= 64 * eps);
  BOOST_TEST(magnitude(Square(U<>(2).restore(Square(unitary * (1 + d))) - unitary)) <= 2 * d * d + 64 * eps);
  BOOST_TEST((Heisenberg::restore(Matrix<double, 3, 3>{{1.5, 2, 3}, {7, 8, 4}, {5, 6, 9}}) ==
              Matrix<double, 3, 3>{{1, 2, 3}, {0, 1, 4}, {0, 0, 1}}));
  BOOST_TEST(
      (Aff1::restore(Matrix<double, 2, 2>{{1.5, 2}, {7, 8}}) == Matrix<double, 2, 2>{{1.5, 2}, {0, 1}}));
}

BOOST_AUTO_TEST_SUITE_END()
