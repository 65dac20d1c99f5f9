// What is measured where a matrix is no metric, a mass no mass, or a volume no number, on bodies of three
// dimensions and in any units.
#include <boost/test/unit_test.hpp>

#include "actio/continuum/continuum_equations.hpp"
#include "caught.hpp"
#include "refused.hpp"
#include "witness/number.hpp"

using namespace actio;
using testing::caught;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
using Square = Matrix<double, 3, 3>;
Vector<double, 3> const place(0.5, -2, 3);

Square symmetric(double a, double b, double c, double d, double e, double f) {
  Square g;
  g << a, b, c, b, d, e, c, e, f;
  return g;
}
void is_refused(Square const& g, double measured, double bound, char const* words) {
  auto const e = caught<NotAMetric>([&] { require_metric(g, place, "metric"); });
  BOOST_TEST(std::abs(e.measured - measured) <= 8 * eps * std::abs(measured), e.what());
  BOOST_TEST(e.bound == bound, e.what());
  BOOST_TEST(std::string(e.what()).find(words) != std::string::npos, e.what());
  BOOST_TEST(std::string(e.what()).find("metric at (0.5, -2, 3)") != std::string::npos, e.what());
}

}  // namespace

BOOST_AUTO_TEST_SUITE(metric_refusals)

BOOST_AUTO_TEST_CASE(a_gap_across_the_diagonal_is_measured_by_the_largest_entry) {
  Square const good = symmetric(4, 1, -1, 8, 2, 5);
  BOOST_CHECK_NO_THROW(require_metric(good, place, "metric"));
  for (auto const& [i, j] : {std::pair(0, 1), {2, 0}, {1, 2}}) {
    for (double const unit : {1.0, 0x1p-60, 0x1p60}) {
      Square g = good;
      g(i, j) += 0.5;
      is_refused(unit * g, 0.5 / 8, 64 * eps, "symmetric");
    }
    // Rounding counts for nothing.
    Square g = good;
    g(i, j) += 60 * eps * 8;
    BOOST_CHECK_NO_THROW(require_metric(g, place, "metric"));
    g(i, j) += 8 * eps * 8;
    CHECK_REFUSED(require_metric(g, place, "metric"), NotAMetric);
  }
}

BOOST_AUTO_TEST_CASE(a_matrix_that_is_not_positive_is_refused_with_the_first_pivot_that_is_none) {
  char const* const words = "positive definite";
  is_refused(symmetric(-4, 1, 0, 8, 2, 5), -4, 64 * eps * 8, words);
  is_refused(symmetric(0, 1, 0, 8, 2, 5), 0, 64 * eps * 8, words);
  // 3 - 4^2/4 = -1.
  is_refused(symmetric(4, 4, 2, 3, 2, 5), -1, 64 * eps * 5, words);
  // 4 - 6^2/12 = 1 and 2 - 6 6/12 = -1, then 3 - 6^2/12 - 1 = -1.
  is_refused(symmetric(12, 6, 6, 4, 2, 3), -1, 64 * eps * 12, words);
  // A pivot is rounding up to 64 units in the last place of the largest entry.
  CHECK_REFUSED(require_metric(symmetric(1, 0, 0, 4, 0, 63 * 4 * eps), place, "metric"), NotAMetric);
  BOOST_CHECK_NO_THROW(require_metric(symmetric(1, 0, 0, 4, 0, 65 * 4 * eps), place, "metric"));
}

BOOST_AUTO_TEST_CASE(an_irrational_volume_is_refused_with_its_square) {
  WithArithmetic const exactly(Arithmetic::rationals());
  Matrix<Number, 2, 2> g;
  g << 3, 1, 1, 2;
  Matrix<Number, 2, 1> const y(Number(1), Number(2));
  auto const e = caught<NotASquare>([&] { require_volume(g, y, "body"); });
  BOOST_TEST(e.measured == 5);
  BOOST_TEST(e.bound == 0);
  g(0, 0) = 5;
  BOOST_CHECK_NO_THROW(require_volume(g, y, "body"));
  BOOST_TEST((volume(g) == 3));
}

BOOST_AUTO_TEST_CASE(masses_and_jacobians_are_refused_with_their_values) {
  // The Jacobian is det F and the ratio of the volumes, here 3 over 2 of -4.
  Matrix<double, 2, 2> G, g, F;
  G << 4, 0, 0, 1;
  g << 9, 0, 0, 1;
  F << 1, 2, 3, 2;
  Continuum const fluid{ConstantMetric<double, 2>{G}, ConstantMetric<double, 2>{g}, Homogeneous<double>{2},
                        Barotropic{WholePolytropic<double, 2>{1}}};
  Jet<double, 2, 2> j{{0, 0.3, -0.4}, {0.5, 0.25}, Matrix<double, 2, 3>::Zero()};
  j.v.rightCols<2>() = F;
  auto const e = caught<NotOrientationPreserving>([&] { examine(fluid, j); });
  BOOST_TEST(e.measured == -6);
  BOOST_TEST(e.bound == 0);
  // In a space of three dimensions a surface is examined by the determinant of its tensor, here of two
  // tangents that are the same.
  Continuum const shell{Euclidean<2>{}, Euclidean<3>{}, Homogeneous<double>{2},
                        OfGreenTensor{NeoHookean{1.0, LogarithmicVolume<double>{1.0}}}};
  Jet<double, 2, 3> flat{{0, 0.3, -0.4}, {0.5, 0.25, 1}, Matrix<double, 3, 3>::Ones()};
  BOOST_TEST(caught<NotOrientationPreserving>([&] { examine(shell, flat); }).measured == 0);
  flat.v(2, 2) = 0;
  BOOST_CHECK_NO_THROW(examine(shell, flat));
  // rho_0 (1 + s x) = 2 (1 + 5 3/10 - 4 2/5 4) = -7.8.
  LinearDensity<double, 2> const rho{2.0, {5.0, 16.0}};
  Continuum const body{Euclidean<2>{}, Euclidean<2>{}, rho, OfGreenTensor{StVenantKirchhoff<double>{1, 1}}};
  auto const none = caught<NotAMassDensity>([&] { examine(body, j); });
  BOOST_TEST(std::abs(none.measured - 2 * (1 + 1.5 - 6.4)) < 8 * eps * 8);
  BOOST_TEST(none.bound == 0);
}

BOOST_AUTO_TEST_SUITE_END()
