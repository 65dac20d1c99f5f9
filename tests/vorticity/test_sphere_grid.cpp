// Functions on the sphere as numbers on a grid: against many digits, back again, and the velocity of a flow.
//
// In a unit of its own, which is as large as a unit may be.
#include <Eigen/Core>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/test/unit_test.hpp>
#include <random>

#include "actio/numbers/gauss_quadrature.hpp"
#include "actio/sphere_fields/sphere_flow.hpp"
#include "caught.hpp"

using namespace actio;
using namespace actio::sphere;
using testing::caught;

namespace {

/// Coefficients of the same size in every degree from `least` on.
SphereHarmonics random_function(int degrees, int least = 0, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  SphereHarmonics f(degrees);
  for (int l = least; l < degrees; ++l)
    for (int m = 0; m <= l; ++m) {
      double const real = normal(random), imaginary = normal(random);
      f(l, m) = {real, m > 0 ? imaginary : 0};
    }
  return f;
}

/// P_lm, l = m .. degrees - 1, by the recurrence in cos(theta), with 50 digits and any exponent.
std::vector<double> legendre_in_digits(double colatitude, int m, int degrees) {
  using R = boost::multiprecision::cpp_bin_float_50;
  R const x = cos(R(colatitude)), s = sin(R(colatitude));
  R now = 1 / sqrt(4 * boost::math::constants::pi<R>()), before = 0, a = 0;
  for (int k = 1; k <= m; ++k) now *= -s * sqrt(R(2 * k + 1) / R(2 * k));
  std::vector<double> out;
  for (int l = m; l < degrees; ++l) {
    out.push_back(static_cast<double>(now));
    double const up = l + 1;
    R const next = sqrt(R(up * up - double(m) * m) / R(4 * up * up - 1));
    R const after = (x * now - a * before) / next;
    before = now, now = after, a = next;
  }
  return out;
}

}  // namespace

// Of degree l the functions have derivatives up to l times their size, and angles are known to half an
// epsilon: l epsilon = 5e-13 is the bound of any evaluation that takes the angle.
BOOST_AUTO_TEST_CASE(legendre_functions_are_right_up_to_degree_2048_and_next_to_the_pole) {
  int const degrees = 2049;
  Eigen::ArrayXd const places{{0.0007, 0.0012, 0.003, 0.01, 0.05, 0.2, 0.5, 1.0, 1.3, 1.5, M_PI / 2}};
  LegendreFunctions functions(places, degrees);
  LegendreFunctions::Block u;
  double worst = 0, by_cosine = 0;
  for (int const m : {0, 1, 2, 10, 100, 600, 1300, 2000, 2048}) {
    while (functions.m() < m) functions.next();
    int const from = functions.block(0, u);
    for (Eigen::Index j = 0; j < places.size(); ++j) {
      auto const exact = legendre_in_digits(places[j], m, degrees);
      double const size = *std::max_element(exact.begin(), exact.end(),
                                            [](double a, double b) { return std::abs(a) < std::abs(b); });
      for (int r = 0; r < degrees - m; ++r) {
        double const found = r < from ? 0 : u(r, j), right = exact[static_cast<std::size_t>(r)];
        worst = std::max(worst, std::abs(found - right) / std::max(1.0, std::abs(size)));
      }
      // The control: the recurrence in cos(theta), which loses the digits next to the pole.
      if (m > 0) continue;
      double const x = std::cos(places[j]);
      double before = 0, now = std::sqrt(1 / (4 * M_PI)), a = 0;
      for (int l = 0; l < degrees; ++l) {
        by_cosine = std::max(by_cosine, std::abs(now - exact[static_cast<std::size_t>(l)]));
        double const up = l + 1, next = up / std::sqrt(4 * up * up - 1),
                     after = (x * now - a * before) / next;
        before = now, now = after, a = next;
      }
    }
  }
  BOOST_TEST_MESSAGE("Legendre functions of degrees to 2048: " << worst << "; by cos(theta): " << by_cosine);
  BOOST_TEST(worst <= 5e-13);
  BOOST_TEST(by_cosine > 1e-11);
}

BOOST_AUTO_TEST_CASE(gauss_latitudes_are_those_of_the_quadrature) {
  for (int const n : {1, 2, 5, 64, 333}) {
    SphereGrid const grid = SphereGrid::gauss(n, 1);
    auto const rule = gauss_quadrature<long double>(n);
    for (int j = 0; j < n; ++j) {
      // The rule is on [0, 1], from the south; its nodes are good to epsilon n in extended precision.
      long double const x = 2 * rule.nodes[static_cast<std::size_t>(n - 1 - j)] - 1;
      BOOST_TEST(std::abs(grid.colatitude[j] - double(std::acos(x))) <= 4e-16 * M_PI);
      BOOST_TEST(std::abs(grid.weight[j] / double(2 * rule.weights[static_cast<std::size_t>(j)]) - 1) <=
                 1e-13);
    }
  }
  // A large one: x^400 is largest next to the poles.
  SphereGrid const large = SphereGrid::gauss(2048, 1);
  BOOST_TEST(std::abs(large.weight.sum() - 2) <= 1e-13);
  Eigen::ArrayXd const x = large.colatitude.cos();
  BOOST_TEST(std::abs((large.weight * x.pow(400)).sum() * 401 / 2 - 1) <= 1e-12);
}

// Sums of up to N^2 terms, each with a few epsilon: 1e-12 of the largest value, with room.
BOOST_AUTO_TEST_CASE(a_field_gives_its_coefficients_back) {
  for (auto const [degrees, rows, columns] :
       {std::array{1, 1, 1}, {2, 2, 3}, {7, 7, 13}, {16, 16, 32}, {63, 70, 130}, {130, 131, 263}}) {
    SphereHarmonics const f = random_function(degrees);
    SphereGrid const grid = SphereGrid::gauss(rows, columns);
    SphereHarmonics const back = harmonics_from(grid, values_on(grid, f), degrees);
    BOOST_TEST((back.coefficient - f.coefficient).cwiseAbs().maxCoeff() <= 1e-12);
    BOOST_TEST(std::abs(grid.integral(values_on(grid, f)) - std::sqrt(4 * M_PI) * f(0, 0).real()) <= 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(values_are_the_sum_of_harmonics_on_any_grid) {
  int const degrees = 12;
  SphereHarmonics const f = random_function(degrees);
  // Grids coarser than the function and finer, with an equator and without, odd and even.
  for (SphereGrid const& grid :
       {SphereGrid::uniform(9, 8), SphereGrid::uniform(4, 5), SphereGrid::uniform(3, 40),
        SphereGrid::gauss(20, 1), SphereGrid::gauss(7, 2), SphereGrid::uniform(40, 30)}) {
    GridField const field = values_on(grid, f);
    for (int j = 0; j < grid.latitudes(); ++j)
      for (int k = 0; k < grid.longitudes; ++k) {
        double sum = 0;
        for (int m = 0; m < degrees; ++m) {
          auto const p = legendre_in_digits(grid.colatitude[j], m, degrees);
          for (int l = m; l < degrees; ++l)
            sum += (m == 0 ? 1 : 2) * p[static_cast<std::size_t>(l - m)] *
                   (f(l, m) * std::polar(1.0, m * grid.longitude(k))).real();
        }
        BOOST_TEST(std::abs(field(j, k) - sum) <= 1e-12);
      }
  }
}

BOOST_AUTO_TEST_CASE(a_grid_that_does_not_hold_the_degrees_is_refused) {
  auto const refused = [](auto const& make, double measured, double bound) {
    auto const error = caught<OutsideDomain>([&] { make(); });
    BOOST_TEST((error.measured == measured && error.bound == bound));
  };
  auto const from = [](SphereGrid const& grid, int degrees) {
    return [&grid, degrees] {
      harmonics_from(grid, GridField::Zero(grid.latitudes(), grid.longitudes), degrees);
    };
  };
  // Of parallels that are not Gauss's none counts.
  refused(from(SphereGrid::uniform(8, 16), 4), 0, 4);
  refused(from(SphereGrid::gauss(7, 16), 8), 7, 8);
  refused(from(SphereGrid::gauss(8, 14), 8), 14, 15);
  refused([] { harmonics_from(SphereGrid::gauss(8, 16), GridField::Zero(8, 15), 8); }, 120, 128);
  refused([] { harmonics_from(SphereGrid::gauss(8, 16), GridField::Zero(9, 16), 8); }, 144, 128);
  refused([] { SphereGrid::gauss(0, 3); }, 0, 1);
  refused([] { SphereGrid::gauss(3, -1); }, -1, 1);
  refused([] { SphereGrid::uniform(1, 0); }, 0, 1);
  refused([] { SphereGrid::uniform(-2, 5); }, -2, 1);
}

// Between two circles of latitude the sphere has the area of the height between them.
BOOST_AUTO_TEST_CASE(parallels_of_equal_steps_have_the_areas_of_their_cells) {
  for (int rows : {1, 2, 9, 64}) {
    SphereGrid const grid = SphereGrid::uniform(rows, 5);
    BOOST_TEST((grid.latitudes() == rows && grid.longitudes == 5 && !grid.gaussian));
    GridField field(rows, 5);
    double sum = 0;
    for (int j = 0; j < rows; ++j) {
      double const height = std::cos(M_PI * j / rows) - std::cos(M_PI * (j + 1) / rows);
      BOOST_TEST(std::abs(grid.weight[j] - height) <= 4e-16);
      // In radians, from the north.
      BOOST_TEST(std::abs(grid.latitude(j) - M_PI / 2 * (rows - 1 - 2 * j) / rows) <= 4e-16);
      for (int k = 0; k < 5; ++k) field(j, k) = j + 10 * k, sum += height * field(j, k);
    }
    BOOST_TEST(std::abs(grid.integral(field) / (2 * M_PI / 5 * sum) - 1) <= 1e-15 * rows);
    BOOST_TEST(std::abs(grid.integral(GridField::Ones(rows, 5)) / (4 * M_PI) - 1) <= 1e-15 * rows);
    for (int k = 0; k < 5; ++k) BOOST_TEST(std::abs(grid.longitude(k) - 0.4 * M_PI * k) <= 1e-15);
  }
  BOOST_TEST(SphereGrid::gauss(3, 4).latitude(1) == 0);
  BOOST_TEST(SphereGrid::gauss(3, 4).latitude(0) > 0.8);
}

BOOST_AUTO_TEST_CASE(a_rigid_rotation_blows_from_the_west) {
  // Vorticity 2 cos(theta) is that of the angular velocity 1: u = sin(theta), psi = -cos(theta).
  SphereHarmonics f(3);
  f(1, 0) = 2 * std::sqrt(4 * M_PI / 3);
  SphereGrid const grid = SphereGrid::uniform(11, 6);
  FlowFields const flow = flow_on(grid, f);
  for (int j = 0; j < 11; ++j)
    for (int k = 0; k < 6; ++k) {
      BOOST_TEST(std::abs(flow.vorticity(j, k) - 2 * std::cos(grid.colatitude[j])) <= 4e-15);
      BOOST_TEST(std::abs(flow.streamfunction(j, k) + std::cos(grid.colatitude[j])) <= 4e-15);
      BOOST_TEST(std::abs(flow.east(j, k) - std::sin(grid.colatitude[j])) <= 2e-14);
      BOOST_TEST(std::abs(flow.north(j, k)) <= 4e-15);
    }
}

BOOST_AUTO_TEST_CASE(the_velocity_is_r_x_grad_psi_and_has_the_energy_of_the_vorticity) {
  int const degrees = 20;
  SphereHarmonics const f = random_function(degrees, 1);
  SphereGrid const grid = SphereGrid::gauss(degrees + 1, 2 * degrees + 2);
  FlowFields const flow = flow_on(grid, f);
  // The square of the velocity is a function of the degrees below 2N + 1, which this grid integrates exactly.
  double energy = 0;
  for (int l = 1; l < degrees; ++l) energy += 0.5 * f.power(l) / (l * (l + 1.0));
  double const found = 0.5 * grid.integral(flow.east.cwiseAbs2() + flow.north.cwiseAbs2());
  BOOST_TEST(std::abs(found / energy - 1) <= 1e-13);
  // Along a meridian psi rises towards the south by what blows to the east, and along a parallel towards the
  // east by what blows to the north: central differences, with an error of the square of their step.
  SphereHarmonics const psi = stream_function(f);
  double const h = 1e-4, size = flow.streamfunction.cwiseAbs().maxCoeff();
  auto const at = [&psi](double colatitude, double longitude) {
    double sum = 0;
    for (int m = 0; m < psi.degrees(); ++m) {
      auto const p = legendre_in_digits(colatitude, m, psi.degrees());
      for (int l = m; l < psi.degrees(); ++l)
        sum += (m == 0 ? 1 : 2) * p[static_cast<std::size_t>(l - m)] *
               (psi(l, m) * std::polar(1.0, m * longitude)).real();
    }
    return sum;
  };
  for (int const j : {0, 5, 10, 17})
    for (int const k : {0, 7, 30}) {
      double const theta = grid.colatitude[j], phi = grid.longitude(k);
      double const east = (at(theta + h, phi) - at(theta - h, phi)) / (2 * h);
      double const towards_north = (at(theta, phi + h) - at(theta, phi - h)) / (2 * h) / std::sin(theta);
      // degree^3 h^2/6 = 1.3e-5, near the pole divided by the sine there, a ninth.
      BOOST_TEST(std::abs(flow.east(j, k) - east) <= 1.3e-5 * size);
      BOOST_TEST(std::abs(flow.north(j, k) - towards_north) <= 1.3e-5 * 9 * size);
    }
}
