// The multiplier theorem: multipliers of known problems, and points where the hypothesis fails.
#include <boost/test/unit_test.hpp>

#include <cmath>
#include <limits>

#include "actio/constraints/multiplier_theorem.hpp"
#include "caught.hpp"
#include "refused.hpp"
#include "witness/number.hpp"

using namespace actio;
using testing::caught;

namespace {

template <class S, int m>
using Column = Matrix<S, m, 1>;

auto const sphere = []<class T>(Column<T, 3> const& q) {
  return Column<T, 1>(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] - T(1));
};
auto const height = []<class T>(Column<T, 3> const& q) { return T(q[0] * T(3) + q[1] * T(4)); };

}  // namespace

BOOST_AUTO_TEST_CASE(a_linear_function_on_the_sphere_has_its_multiplier_where_it_is_critical) {
  WithArithmetic const exactly(Arithmetic::rationals());
  auto const f = constrained<1>(height, sphere);
  Column<Number, 3> const q(ratio<Number>(3, 5), ratio<Number>(4, 5), 0);
  BOOST_TEST((f.restricted_differential(q)).isZero());
  auto const lambda = f.multiplier(q);
  BOOST_TEST((lambda[0] == ratio<Number>(5, 2)));
  BOOST_TEST((f.augmented_differential(q, lambda)).isZero());
  Column<Number, 3> const elsewhere(0, 0, 1);
  BOOST_TEST(!f.restricted_differential(elsewhere).isZero());
}

BOOST_AUTO_TEST_CASE(an_inner_product_of_the_fibres_scales_the_multiplier) {
  WithArithmetic const exactly(Arithmetic::rationals());
  Matrix<Number, 1, 1> const two(Number(2));
  auto const f = constrained<1>(height, sphere, ConstantMetric<Number, 1>{two});
  BOOST_TEST((f.multiplier(Column<Number, 3>(ratio<Number>(3, 5), ratio<Number>(4, 5), 0))[0] ==
              ratio<Number>(5, 4)));
}

BOOST_AUTO_TEST_CASE(a_point_where_the_constraint_is_not_regular_is_refused_with_the_pivot) {
  auto const f = constrained<1>(height, sphere);
  auto const e = caught<NotRegular>([&] { f.multiplier(Column<double, 3>(0, 0, 0)); });
  BOOST_TEST(e.point == std::vector<double>(3, 0.0), boost::test_tools::per_element());
  BOOST_TEST(e.measured == 0);
  BOOST_TEST(e.bound > 0);
  BOOST_TEST(std::string(e.what()).find("(0, 0, 0)") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(dependent_constraints_are_refused_whatever_their_units) {
  // The same constraint twice, in units that differ by thirty orders of magnitude.
  auto const twice = []<class T>(Column<T, 3> const& q) {
    return Column<T, 2>(sphere(q)[0] * T(1e-15), sphere(q)[0] * T(1e15));
  };
  auto const f = constrained<2>(height, twice);
  CHECK_REFUSED(f.multiplier(Column<double, 3>(0.6, 0.7, 0.3)), NotRegular);
  // And two that are independent, in such units.
  auto const both = []<class T>(Column<T, 3> const& q) {
    return Column<T, 2>(sphere(q)[0] * T(1e-15), q[2] * T(1e15));
  };
  BOOST_CHECK_NO_THROW(constrained<2>(height, both).require_regular(Column<double, 3>(0.6, 0.8, 0)));
}

BOOST_AUTO_TEST_CASE(more_constraints_than_dimensions_are_refused) {
  auto const four = []<class T>(Column<T, 3> const& q) {
    return Column<T, 4>(q[0], q[1], q[2], T(q[0] + q[1]));
  };
  CHECK_REFUSED(constrained<4>(height, four).multiplier(Column<double, 3>(1, 2, 3)), NotRegular);
}

BOOST_AUTO_TEST_CASE(what_is_no_number_is_refused) {
  auto const f = constrained<1>(height, sphere);
  double const nan = std::numeric_limits<double>::quiet_NaN(),
               infinity = std::numeric_limits<double>::infinity();
  CHECK_REFUSED(f.multiplier(Column<double, 3>(nan, 0, 0)), NotFinite);
  CHECK_REFUSED(f.multiplier(Column<double, 3>(0, infinity, 0)), NotFinite);
}

BOOST_AUTO_TEST_CASE(the_kernel_is_sent_to_zero_and_has_the_right_dimension) {
  WithArithmetic const exactly(Arithmetic::rationals());
  Matrix<Number, 2, 4> A;
  A << 1, 2, 3, 4, 2, 4, 6, 9;
  auto const e = echelon(A);
  BOOST_TEST(e.rank == 2);
  BOOST_TEST(e.onto());
  BOOST_TEST(e.kernel().cols() == 2);
  BOOST_TEST(((A * e.kernel())).isZero());
  A.row(1) = A.row(0) * Number(2);
  BOOST_TEST(echelon(A).rank == 1);
  BOOST_TEST(echelon(A).kernel().cols() == 3);
  BOOST_TEST(((A * echelon(A).kernel())).isZero());
}

BOOST_AUTO_TEST_CASE(rows_are_independent_however_small_the_column_that_tells_them_apart) {
  // One less the other is 2e-20 of what stands beside it: no rounding of its own terms.
  Matrix<double, 2, 2> A;
  A << 1, 1e-20, 1, 3e-20;
  auto const e = echelon(A);
  BOOST_TEST(e.rank == 2);
  BOOST_TEST(e.onto());
  BOOST_TEST(std::abs(e.pivot - 2.0 / 3) <= 1e-15);
  // What is rounding of these terms is none.
  A(1, 1) = 1e-20 * (1 + std::numeric_limits<double>::epsilon());
  BOOST_TEST(echelon(A).rank == 1);
}
