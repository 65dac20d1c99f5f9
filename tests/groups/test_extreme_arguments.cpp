// Where series and squares go wrong if one is not careful: strong contractions, large angles, matrices of any
// size of entries.
#include <boost/test/unit_test.hpp>

#include "actio/groups/affine_line.hpp"
#include "actio/groups/group.hpp"
#include "actio/groups/linear_groups.hpp"
#include "actio/groups/rotations.hpp"
#include "actio/linear_algebra/eigenvalues.hpp"
#include "refused.hpp"
#include "witness/reference_solution.hpp"

using namespace actio;

namespace {
double const eps = epsilon<double>();
}

BOOST_AUTO_TEST_CASE(exp_of_a_contraction_keeps_its_digits) {
  for (double const a : {-1.0, -10.0, -30.0, -100.0, -600.0}) {
    auto const g = exp(velocity(Aff1{}, Vector<double, 2>(a, 1)));
    // Squaring magnifies rounding by the size of the argument.
    BOOST_TEST(std::abs(g.value(0, 0) / std::exp(a) - 1) < 8 * eps * (1 - a));
    auto const s = exp(velocity(SL2{}, Vector<double, 3>(a / 2, 0, 0)));
    BOOST_TEST(std::abs(s.value(0, 0) * s.value(1, 1) - 1) < 16 * eps * (1 - a));
  }
}

BOOST_AUTO_TEST_CASE(a_large_angle_stays_on_the_group_or_is_refused) {
  for (double const angle : {10.0, 1e5, 1e10, 1e16, 1e155, 1e308}) {
    Coordinates<SO<4>, double> v = Coordinates<SO<4>, double>::Zero();
    v[0] = angle;
    try {
      Matrix<double, 4, 4> const r = exp(velocity(SO<4>{}, v)).value;
      // The angle itself is known to a rounding of its size; what restore leaves is the square of that.
      BOOST_TEST(magnitude((r.transpose() * r - Matrix<double, 4, 4>::Identity()).eval()) <
                 16 * eps + 16 * std::pow(angle * eps, 2));
    } catch (Error const&) {
      BOOST_TEST(angle * eps > 1e-3);
    }
  }
}

BOOST_AUTO_TEST_CASE(eigenvalues_of_any_size_and_no_others) {
  for (double const unit : {1.0, 1e-300, 1e200, 1e300}) {
    Matrix<double, 3, 3> a;
    a << 0, 3, 0, -3, 0, 0, 0, 0, 2;  // 2 and +-3i
    Vector<double> const real = real_parts_of_eigenvalues(a * unit);
    BOOST_TEST(std::abs(real[0]) <= 8 * eps * unit);
    BOOST_TEST(std::abs(real[2] / unit - 2) <= 8 * eps);
    BOOST_TEST(std::abs(largest_eigenvalue(a.transpose() * a * unit) / unit - 9) <= 32 * eps);
  }
  CHECK_REFUSED(symmetric_eigen(Matrix<double>(0, 0)), OutsideDomain);
  CHECK_REFUSED(largest_eigenvalue(Matrix<double>::Zero(2, 3)), OutsideDomain);
  CHECK_REFUSED(real_parts_of_eigenvalues(Matrix<double>::Constant(2, 2, std::nan(""))), NotFinite);
}

BOOST_AUTO_TEST_CASE(a_reference_starts_from_zero_and_refuses_no_tolerance) {
  auto const f = [](double t, Matrix<double, 1, 1> const&) {
    return Matrix<double, 1, 1>(1e-47 * std::cos(t));
  };
  Matrix<double, 1, 1> const zero(0.0);
  BOOST_TEST(std::abs(reference_solution(f, zero, 0, 30)[0] / (1e-47 * std::sin(30)) - 1) < 1e-11);
  CHECK_REFUSED(reference_solution(f, zero, 0, 1, std::nan("")), OutsideDomain);
  CHECK_REFUSED(reference_solution(f, zero, 0, 1, -1), OutsideDomain);
}
