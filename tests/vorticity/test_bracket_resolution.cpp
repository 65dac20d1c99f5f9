// Commutators of matrices against Poisson brackets of functions: order 2 in 1/N, and how large they differ.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "actio/numbers/gauss_quadrature.hpp"
#include "actio/quantized_sphere/resolution.hpp"
#include "flows.hpp"

using namespace actio;
using namespace actio::sphere;

namespace {

/// Normalised associated Legendre functions with the phase of Condon and Shortley, and their derivatives in
/// theta.
struct Meridian {
  Eigen::MatrixXd value, slope;  // (l, m), m >= 0

  Meridian(int most, double z) : value(Eigen::MatrixXd::Zero(most + 1, most + 1)), slope(value) {
    double const s = std::sqrt((1 - z) * (1 + z));
    for (int m = 0; m <= most; ++m) {
      value(m, m) =
          m == 0 ? std::sqrt(1 / (4 * M_PI)) : -std::sqrt((2 * m + 1.0) / (2 * m)) * s * value(m - 1, m - 1);
      for (int l = m + 1; l <= most; ++l)
        value(l, m) =
            factor(l, m) * (z * value(l - 1, m) - (l - 1 > m ? value(l - 2, m) / factor(l - 1, m) : 0));
      // sin(theta) dP/dtheta = l z P_l - (2l + 1)/factor ... P_{l-1}, in normalised functions.
      for (int l = m; l <= most; ++l)
        slope(l, m) = (l * z * value(l, m) - (l > m ? (2 * l + 1) / factor(l, m) * value(l - 1, m) : 0)) / s;
    }
  }
  static double factor(double l, double m) { return std::sqrt((4 * l * l - 1) / (l * l - m * m)); }
};

/// The coefficients of \f$\{f, g\} = x\cdot(\nabla f\times\nabla g)\f$, up to the degree that products of
/// such reach, by Gauss's rule in cos(theta) and sums over a grid in the azimuth: exact for what is a
/// polynomial.
SphereHarmonics bracket_on_the_sphere(SphereHarmonics const& f, SphereHarmonics const& g, int most) {
  int const rows = 2 * most + 2, columns = 4 * most + 4;
  GaussRule<double> const rule = gauss_quadrature<double>(rows);
  SphereHarmonics out(most + 1);
  for (int i = 0; i < rows; ++i) {
    double const z = 2 * rule.nodes[static_cast<std::size_t>(i)] - 1, s = std::sqrt((1 - z) * (1 + z));
    Meridian const at(most, z);
    for (int j = 0; j < columns; ++j) {
      double const azimuth = 2 * M_PI * j / columns;
      auto const gradient = [&](SphereHarmonics const& h) {
        Eigen::Vector2d along = Eigen::Vector2d::Zero();
        for (int l = 0; l < h.degrees(); ++l)
          for (int m = 0; m <= l; ++m) {
            std::complex<double> const c = (m > 0 ? 2.0 : 1.0) * h(l, m) * std::polar(1.0, m * azimuth);
            along[0] += c.real() * at.slope(l, m), along[1] -= m * c.imag() * at.value(l, m) / s;
          }
        return along;
      };
      Eigen::Vector2d const df = gradient(f), dg = gradient(g);
      double const here =
          (df[0] * dg[1] - df[1] * dg[0]) * 4 * M_PI * rule.weights[static_cast<std::size_t>(i)] / columns;
      for (int m = 0; m <= most; ++m)
        for (int l = m; l <= most; ++l) out(l, m) += here * at.value(l, m) * std::polar(1.0, -m * azimuth);
    }
  }
  return out;
}

/// The same in matrices of size N: \f$[F, G]/(i\hbar)\f$.
SphereHarmonics bracket_of_matrices(SphereHarmonics const& f, SphereHarmonics const& g, int n, int most) {
  auto const larger = [&](SphereHarmonics const& h) {
    SphereHarmonics out(n);
    out.coefficient.topLeftCorner(h.degrees(), h.degrees()) = h.coefficient;
    return matrix_of(out);
  };
  // W = i F, and [F, G]/(i hbar) = -i [iF, iG] (-1)/hbar: in matrices that are i times functions, -[.,
  // .]/hbar.
  SphereHarmonics const all =
      harmonics_of((-1 / QuantizedSphere(n).hbar()) * commutator(larger(f), larger(g)));
  SphereHarmonics out(most + 1);
  out.coefficient = all.coefficient.topLeftCorner(most + 1, most + 1);
  return out;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(bracket_resolution)

// {x, y} = z and its turns: what fixes the sign.
BOOST_AUTO_TEST_CASE(coordinates_turn_one_another) {
  SphereHarmonics x(3), y(3), z(3);
  double const third = std::sqrt(4 * M_PI / 3);
  x(1, 1) = -third / std::sqrt(2.0), y(1, 1) = {0, third / std::sqrt(2.0)}, z(1, 0) = third;
  BOOST_TEST((bracket_on_the_sphere(x, y, 2).coefficient - z.coefficient).norm() <= 1e-14);
  BOOST_TEST((bracket_on_the_sphere(y, z, 2).coefficient - x.coefficient).norm() <= 1e-14);
  for (int n : {3, 10})
    BOOST_TEST((bracket_of_matrices(x, y, n, 2).coefficient - z.coefficient).norm() <= 1e-14);
}

BOOST_AUTO_TEST_CASE(commutators_are_brackets_to_order_two_in_one_over_n) {
  for (auto const& [l, other] : {std::pair(2, 3), {4, 4}, {3, 6}}) {
    int const most = l + other;
    SphereHarmonics const f = testing::random_harmonics(most + 1, l, l, 1),
                          g = testing::random_harmonics(most + 1, other, other, 2);
    Eigen::MatrixXcd const truth = bracket_on_the_sphere(f, g, most).coefficient;
    std::vector<double> steps, errors;
    for (int n = 32; n <= 256; n *= 2) {
      steps.push_back(1.0 / n);
      errors.push_back((bracket_of_matrices(f, g, n, most).coefficient - truth).norm() / truth.norm());
    }
    auto const line = testing::order_of(steps, errors);
    BOOST_TEST_MESSAGE("degrees " << l << " and " << other << ": order " << line.slope << " +- " << line.error
                                  << " in 1/N, error at 256 " << errors.back() << ", foretold "
                                  << bracket_error(256, l, other));
    BOOST_TEST(std::abs(line.slope - 2) <= 0.05);
    BOOST_TEST(errors.back() > 1e-9);
    // With the other sign nothing converges.
    BOOST_TEST((bracket_of_matrices(g, f, 256, most).coefficient - truth).norm() > truth.norm());
  }
}

// Random functions of one degree, at some sizes: the estimate is good to a third where it is small, and says
// that all is lost where it is.
BOOST_AUTO_TEST_CASE(the_error_foretold_is_the_error_met) {
  for (auto const& [n, l, other] : {std::tuple(48, 4, 4), {64, 4, 4}, {96, 8, 8}, {64, 4, 8}, {96, 4, 16}}) {
    int const most = l + other;
    SphereHarmonics const f = testing::random_harmonics(most + 1, l, l, 3),
                          g = testing::random_harmonics(most + 1, other, other, 4);
    Eigen::MatrixXcd const truth = bracket_on_the_sphere(f, g, most).coefficient;
    double const met = (bracket_of_matrices(f, g, n, most).coefficient - truth).norm() / truth.norm();
    double const foretold = bracket_error(n, l, other);
    BOOST_TEST_MESSAGE("N = " << n << ", degrees " << l << " and " << other << ": error " << met
                              << ", foretold " << foretold);
    BOOST_TEST(met <= 1.5 * foretold);
    BOOST_TEST(met >= 0.6 * foretold);
  }
  int const n = 48, l = static_cast<int>(std::ceil(degree_of_bracket_error(n, 1)));
  SphereHarmonics const f = testing::random_harmonics(2 * l + 1, l, l, 3),
                        g = testing::random_harmonics(2 * l + 1, l, l, 4);
  Eigen::MatrixXcd const truth = bracket_on_the_sphere(f, g, 2 * l).coefficient;
  double const met = (bracket_of_matrices(f, g, n, 2 * l).coefficient - truth).norm() / truth.norm();
  BOOST_TEST_MESSAGE("N = 48, degree " << l << ", where nothing should be right: error " << met);
  BOOST_TEST(met > 0.4);
}

BOOST_AUTO_TEST_CASE(the_report_of_a_state_adds_up) {
  int const n = 400;
  SphereHarmonics f(n);
  f(3, 1) = 2, f(10, 0) = 1;
  // The rotation as a whole is not counted.
  f(1, 0) = 7;
  // Energy 2 * 4/(3 * 4) and 1/(10 * 11), enstrophy 8 and 1: halves that cancel.
  Resolution const told = resolution_of(f);
  double const at3 = 8.0 / 12, at10 = 1.0 / 110;
  BOOST_TEST(std::abs(told.energy_degree - (3 * at3 + 10 * at10) / (at3 + at10)) <= 1e-14);
  BOOST_TEST(std::abs(told.enstrophy_degree - 34.0 / 9) <= 1e-14);
  BOOST_TEST(std::abs(bracket_error(n, told.lost_degree, told.lost_degree) - 1) <= 1e-14);
  BOOST_TEST(std::abs(bracket_error(n, told.trusted_degree, told.trusted_degree) - 0.01) <= 1e-15);
  BOOST_TEST(std::abs(told.error - std::pow(told.energy_degree, 4) / (6.0 * n * n)) <= 1e-15);
  BOOST_TEST(bracket_error(n, 300, 300) == 1);
  // Nothing moves where there is no vorticity.
  Resolution const none = resolution_of(SphereHarmonics(5));
  BOOST_TEST(none.energy_degree == 0);
  BOOST_TEST(none.enstrophy_degree == 0);
  BOOST_TEST((none.error == 0 && none.error_of_straining == 0));
  BOOST_TEST((told.size == n && none.size == 5));
  BOOST_TEST(std::abs(told.error_of_straining - std::pow(told.energy_degree * 34.0 / 9, 2) / (6.0 * n * n)) <=
             1e-15);
  // Berezin's factor at the degree where it is said to be a half, from its product.
  double factor = 1;
  for (int l = 1; l <= std::lround(told.cut_off); ++l)
    factor *= std::sqrt((n - l) / (n + static_cast<double>(l)));
  BOOST_TEST(std::abs(factor - 0.5) <= 0.03);
}

BOOST_AUTO_TEST_SUITE_END()
