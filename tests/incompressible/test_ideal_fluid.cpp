// The ideal fluid seen from space: accelerations, divergences, the source and the walls of the equation of
// the pressure, curvature.
#include <boost/test/unit_test.hpp>

#include "actio/incompressible/bracket_of_fields.hpp"
#include "actio/incompressible/ideal_fluid.hpp"
#include "actio/incompressible/incompressible_equations.hpp"
#include "refused.hpp"
#include "witness/draw.hpp"

using namespace actio;

namespace {

double const eps = epsilon<double>();

/// The round sphere in polar coordinates.
struct Sphere {
  template <class V>
  auto operator()(V const& y) const {
    using std::sin;
    using T = typename V::Scalar;
    Matrix<T, 2, 2> g = Matrix<T, 2, 2>::Identity();
    g(1, 1) = sin(y[0]) * sin(y[0]);
    return g;
  }
};
/// Rigid rotation of the sphere, and of the plane.
struct Meridians {
  template <class V>
  auto operator()(V const&) const {
    using T = typename V::Scalar;
    return Matrix<T, 2, 1>(T(0.0), T(1.0));
  }
};
auto const rotation = [](auto const& at) {
  using T = typename std::remove_cvref_t<decltype(at)>::Scalar;
  return Matrix<T, 2, 1>(T(-at[2]), T(at[1]));
};

}  // namespace

BOOST_AUTO_TEST_CASE(the_plane_rotates_with_the_pressure_of_a_paraboloid) {
  Vector<double, 3> const at(0.4, 0.8, -0.3);
  BOOST_TEST((eulerian_acceleration(Euclidean<2>{}, rotation, at) + at.tail<2>()).norm() == 0);
  BOOST_TEST(divergence(Euclidean<2>{}, rotation, at) == 0);
  // p = |y|^2/2 has Laplacian 2.
  BOOST_TEST(pressure_source(Euclidean<2>{}, rotation, at) == 2);
  auto const p = [](auto const& y) { return (y[1] * y[1] + y[2] * y[2]) / 2.0; };
  BOOST_TEST(laplacian(Euclidean<2>{}, p, at) == 2);
  // Through the circle f = |y|^2 - r^2 it rises by grad p . grad f = 2 |y|^2.
  auto const wall = [](auto const& y) { return y[0] * y[0] + y[1] * y[1]; };
  BOOST_TEST(std::abs(pressure_slope_at_wall(Euclidean<2>{}, rotation, wall, at) -
                      2 * at.tail<2>().squaredNorm()) < 8 * eps);
}

BOOST_AUTO_TEST_CASE(the_sphere_rotates_with_a_pressure_that_feels_its_curvature) {
  double const theta = 0.7;
  Vector<double, 3> const at(0, theta, 1.1);
  // Down the meridian the particles turn with -sin cos; p = sin^2/2.
  Vector<double, 2> const acceleration = eulerian_acceleration(Sphere{}, Meridians{}, at);
  BOOST_TEST(std::abs(acceleration[0] + std::sin(theta) * std::cos(theta)) < 8 * eps);
  auto const p = [](auto const& y) {
    using std::sin;
    return sin(y[1]) * sin(y[1]) / 2.0;
  };
  BOOST_TEST((acceleration + gradient(Sphere{}, p, at)).norm() < 8 * eps);
  BOOST_TEST(std::abs(pressure_source(Sphere{}, Meridians{}, at) - laplacian(Sphere{}, p, at)) < 64 * eps);
  // Ricci's tensor of the unit sphere is its metric.
  BOOST_TEST((ricci_tensor(Sphere{}, Vector<double, 2>(theta, 1.1)) - Sphere{}(Vector<double, 2>(theta, 1.1)))
                 .cwiseAbs()
                 .maxCoeff() < 64 * eps);
}

BOOST_AUTO_TEST_CASE(at_the_pole_polar_coordinates_have_no_inverse_metric) {
  CHECK_REFUSED(eulerian_acceleration(Sphere{}, Meridians{}, Vector<double, 3>(0, 0, 0)), Singular);
}

BOOST_AUTO_TEST_CASE(the_bracket_of_translation_and_rotation_is_a_translation) {
  auto const turn = [](auto const& y) {
    return (Matrix<typename std::remove_cvref_t<decltype(y)>::Scalar, 2, 1>() << -y[1], y[0]).finished();
  };
  auto const shift = [](auto const& y) {
    using T = typename std::remove_cvref_t<decltype(y)>::Scalar;
    return Matrix<T, 2, 1>(T(1.0), T(0.0));
  };
  Vector<double, 2> const bracket = diffeomorphism_bracket(turn, shift)(Vector<double, 2>(0.3, 0.4));
  BOOST_TEST(bracket[0] == 0);
  BOOST_TEST(bracket[1] == 1);
}

BOOST_AUTO_TEST_CASE(the_motion_alone_tells_the_slope_of_the_pressure) {
  // A drop that is drawn out: y = (a x1, x2/a) with a = 1 + t, at t = 1.
  auto const stretch = [](auto const& x) {
    using T = typename std::remove_cvref_t<decltype(x)>::Scalar;
    T const a = x[0] + 1.0;
    return Matrix<T, 2, 1>(T(x[1] * a), T(x[2] / a));
  };
  auto const fluid =
      incompressible(Continuum{Euclidean<2>{}, Euclidean<2>{}, Homogeneous<double>{1}, NoStoredEnergy{}});
  auto const slope = required_pressure_gradient(fluid, second_jet(stretch, Vector<double, 3>(1, 0.5, 0.8)));
  // a'' = 0 and (1/a)'' = 2/a^3 = 1/4: the force on x2 alone, -x2/4 through F = 1/2.
  BOOST_TEST(std::abs(slope[0]) < 8 * eps);
  BOOST_TEST(std::abs(slope[1] + 0.1) < 8 * eps);
  // Off the constraint: y = (2 x1, (3 + t^2) x2) at t = 0 has F = diag(2, 3) and J = 6, so that the force of
  // 2 x2 asks for dP/dx2 = -3 * 2 x2 / 6 = -x2.
  auto const swollen = [](auto const& x) {
    using T = typename std::remove_cvref_t<decltype(x)>::Scalar;
    return Matrix<T, 2, 1>(T(x[1] * 2.0), T(x[2] * (x[0] * x[0] + 3.0)));
  };
  auto const off = required_pressure_gradient(fluid, second_jet(swollen, Vector<double, 3>(0, 0.5, 0.8)));
  BOOST_TEST(std::abs(off[0]) < 8 * eps);
  BOOST_TEST(std::abs(off[1] + 0.8) < 8 * eps);
  auto const flat = [](auto const& x) {
    using T = typename std::remove_cvref_t<decltype(x)>::Scalar;
    return Matrix<T, 2, 1>(T(x[1]), T(x[1] * 2.0));
  };
  CHECK_REFUSED(required_pressure_gradient(fluid, second_jet(flat, Vector<double, 3>(1, 0.5, 0.8))),
                NotOrientationPreserving);
}
