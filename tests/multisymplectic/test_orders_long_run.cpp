// Order two in space and time together, against simple waves that run obliquely to the mesh.
//
// A simple wave of a gas or an isotropic solid: the stretch lambda along n is constant on characteristics
// s = s_0 + c(lambda_0) t of s = n.X, the velocity is v = -\int c d lambda, and the placement
// phi = X + n (phi_1(s, t) - s) has phi_1 = phi_1(s_0, 0) + (lambda c + v) t there. It is exact until
// characteristics cross.
#include <boost/test/unit_test.hpp>

#include <numbers>

#include "media.hpp"

using namespace actio;
using namespace actio::media;
using namespace actio::testing;

namespace {

/// A gas with p = K/J^2 per unit of mass: c = sqrt(2 K / lambda^3).
struct GasWave {
  double K = 0.5;
  auto medium() const {
    return Continuum{Euclidean<2>{}, Euclidean<2>{}, Homogeneous<double>{1.5},
                     Barotropic{WholePolytropic<double, 1>{K}}};
  }
  double speed(double stretch) const { return std::sqrt(2 * K / (stretch * stretch * stretch)); }
  double slope(double stretch) const { return -1.5 * speed(stretch) / stretch; }
  double velocity(double stretch) const { return 2 * std::sqrt(2 * K / stretch); }
};
/// St Venant and Kirchhoff's solid, stretched along one axis: w = M (lambda^2 - 1)^2/8 with M = l + 2 m.
struct SolidWave {
  double l = 0.5, m = 0.25;
  double M() const { return l + 2 * m; }
  auto medium() const {
    return Continuum{Euclidean<2>{}, Euclidean<2>{}, Homogeneous<double>{1.5},
                     OfGreenTensor{StVenantKirchhoff<double>{l, m}}};
  }
  double speed(double stretch) const { return std::sqrt(M() / 2 * (3 * stretch * stretch - 1)); }
  double slope(double stretch) const { return 1.5 * M() * stretch / speed(stretch); }
  double velocity(double stretch) const {
    double const root = std::sqrt(3 * stretch * stretch - 1), q = std::sqrt(3.0);
    return -std::sqrt(M() / 2) * (stretch * root / 2 - std::log(q * stretch + root) / (2 * q));
  }
};

/// A simple wave with lambda_0(s) = 1 + a sin(2 pi s), of wave length one along n.
template <class Law>
struct SimpleWave {
  Law law;
  double a;
  Matrix<double, 2, 1> n;

  double stretch(double s) const { return 1 + a * std::sin(2 * std::numbers::pi * s); }
  double stretch_slope(double s) const {
    return 2 * std::numbers::pi * a * std::cos(2 * std::numbers::pi * s);
  }
  /// When the first characteristics cross.
  double breaking() const {
    double steepest = 0;
    for (int k = 0; k < 1000; ++k)
      steepest = std::max(steepest, -law.slope(stretch(k / 1000.0)) * stretch_slope(k / 1000.0));
    return 1 / steepest;
  }
  Matrix<double, 2, 1> operator()(Matrix<double, 3, 1> const& x) const {
    double const t = x[0], s = n[0] * x[1] + n[1] * x[2];
    // Newton from where the wave comes without steepening; before breaking the function is monotone.
    double start = s - law.speed(1) * t;
    for (int k = 0; k < 60; ++k) {
      double const at = stretch(start);
      double const change = (start + law.speed(at) * t - s) / (1 + law.slope(at) * stretch_slope(start) * t);
      start -= change;
      if (std::abs(change) < 1e-15) break;
    }
    double const at = stretch(start), angle = 2 * std::numbers::pi * start;
    double const phi = start - a / (2 * std::numbers::pi) * std::cos(angle) +
                       (at * law.speed(at) + law.velocity(at) - law.velocity(1)) * t;
    return {x[1] + n[0] * (phi - s), x[2] + n[1] * (phi - s)};
  }
};

/// The largest error at the end of a run, on a mesh of sheared cells: one edge runs along the front of the
/// wave, the other obliquely through it, and the box is a few cells wide along the front.
template <class Wave>
double error_at_end(Wave const& wave, int cells, double end) {
  int const across = 2, steps = cells;
  Matrix<double, 2, 1> const along(-wave.n[1], wave.n[0]);
  auto const sheared = [&](Matrix<double, 2, 1> const& u) {
    return Matrix<double, 2, 1>((wave.n + along * 0.6) * u[0] + along * (u[1] * across / cells));
  };
  SpaceTimeMesh<double, 2> const mesh(equal_steps(0.0, end / steps, steps), {cells, across},
                                      all_sides<2>(Side::periodic), sheared);
  auto section = restricted(mesh, wave, 2);
  run(wave.law.medium(), mesh, section);
  double worst = 0;
  for (Index i = 0; i < mesh.node_count(); ++i)
    worst = std::max(worst, magnitude(section(steps, i) - wave(mesh.event(steps, i))));
  return worst;
}

template <class Law>
void has_order_two(char const* what, Law const& law) {
  SimpleWave<Law> const wave{law, 0.05, {0.8, 0.6}};
  double const end = 0.4;
  // Characteristics are far from crossing.
  BOOST_TEST(end < 0.6 * wave.breaking());
  double last = error_at_end(wave, 16, end);
  for (int cells : {32, 64, 128}) {
    double const error = error_at_end(wave, cells, end), order = std::log2(last / error);
    BOOST_TEST_MESSAGE(what << ", " << cells << " cells: error " << error << ", order " << order);
    BOOST_TEST(std::abs(order - 2) < 0.05);
    last = error;
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(oblique_simple_waves_of_a_gas_converge_with_order_two) {
  has_order_two("gas", GasWave{});
}

BOOST_AUTO_TEST_CASE(oblique_simple_waves_of_a_solid_converge_with_order_two) {
  has_order_two("solid", SolidWave{});
}

BOOST_AUTO_TEST_CASE(a_simple_wave_solves_the_field_equations_of_its_medium) {
  // The exact solution by another way: differences of it in the momentum balance, of order two.
  SimpleWave<GasWave> const wave{{}, 0.05, {0.8, 0.6}};
  Matrix<double, 3, 1> const x(0.2, 0.3, 0.1);
  auto const acceleration_defect = [&](double h) {
    auto const at = [&](double s, double t) { return wave({t, wave.n[0] * s, wave.n[1] * s}).dot(wave.n); };
    double const s = wave.n[0] * x[1] + wave.n[1] * x[2], t = x[0];
    double const acceleration = (at(s, t + h) - 2 * at(s, t) + at(s, t - h)) / (h * h);
    auto const pressure = [&](double from) {
      double const stretch = (at(from + h / 2, t) - at(from - h / 2, t)) / h;
      return wave.law.K / (stretch * stretch);
    };
    return acceleration + (pressure(s + h / 2) - pressure(s - h / 2)) / h;
  };
  double const coarse = std::abs(acceleration_defect(0.02)), fine = std::abs(acceleration_defect(0.01));
  BOOST_TEST(std::abs(std::log2(coarse / fine) - 2) < 0.1);
}
