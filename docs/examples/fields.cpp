// Examples of the modules jets, continuum, constraints, incompressible and noether.
#include "actio/constraints/inextensible.hpp"
#include "actio/constraints/multiplier_theorem.hpp"
#include "actio/continuum/continuum_equations.hpp"
#include "actio/continuum/materials.hpp"
#include "actio/continuum/stresses.hpp"
#include "actio/incompressible/ideal_fluid.hpp"
#include "actio/incompressible/incompressible_equations.hpp"
#include "actio/incompressible/two_pressures.hpp"
#include "actio/jets/action.hpp"
#include "actio/jets/field_equations.hpp"
#include "actio/noether/circulation.hpp"
#include "actio/noether/current_divergence.hpp"
#include "actio/noether/isometries.hpp"
#include "actio/noether/time_translation.hpp"

#include "example.hpp"

BOOST_AUTO_TEST_SUITE(examples_of_fields)
using namespace actio;

namespace {
// A motion of the plane that solves nothing: a callable from x = (t, X1, X2) to the place, over any scalar.
auto const sheared = []<class T>(Matrix<T, 3, 1> const& x) {
  return Vector<T, 2>(x[1] + x[0] * x[2] * 0.5, x[2] + x[1] * x[1] * 0.1);
};
}  // namespace

// ---- jets

BOOST_AUTO_TEST_CASE(jets_of_a_motion) {
  // [first_jet]
  auto const j = first_jet(sheared, Event<double, 2>(0.4, 1, 2));
  assert(j.velocity()[0] == 1.0);  // 2 * 0.5
  Matrix<double, 2, 2> const F = j.gradient();
  assert(F(0, 0) == 1 && F(0, 1) == 0.2 && F(1, 0) == 0.2 && F(1, 1) == 1);
  // [first_jet]
}

BOOST_AUTO_TEST_CASE(field_equations_of_a_density) {
  // [euler_lagrange_of_a_field]
  // The wave equation on a line, L = (y_t^2 - y_x^2)/2: its Euler-Lagrange derivative is y_xx - y_tt.
  auto const density = []<class T>(Jet<T, 1, 1> const& j) {
    return T((j.v(0, 0) * j.v(0, 0) - j.v(0, 1) * j.v(0, 1)) / 2.0);
  };
  auto const wave = []<class T>(Matrix<T, 2, 1> const& x) {
    using std::sin;
    return Matrix<T, 1, 1>(T(sin(T(x[1] - x[0]))));
  };
  auto const parabola = []<class T>(Matrix<T, 2, 1> const& x) { return Matrix<T, 1, 1>(T(x[1] * x[1])); };
  Event<double, 1> const at(0.3, 0.7);
  assert(std::abs(euler_lagrange(density, second_jet(wave, at))[0]) < 1e-15);
  assert(std::abs(euler_lagrange(density, second_jet(parabola, at))[0] - 2) < 1e-15);
  // [euler_lagrange_of_a_field]
  // [action]
  Box<double, 1> const square{{0, 0}, {1, 1}};
  assert(std::abs(action(density, parabola, square, 2) + 2.0 / 3) < 1e-15);  // -(2 x)^2/2 over the square
  // [action]
}

// ---- continuum

BOOST_AUTO_TEST_CASE(rubber_and_its_stresses) {
  // [continuum]
  // Rubber: metrics of body and space, mass density, and a stored energy per unit mass.
  Continuum const rubber{Euclidean<2>{}, Euclidean<2>{}, Homogeneous<double>{1000},
                         OfGreenTensor{NeoHookean{1.0, LogarithmicVolume<double>{2.0}}}};
  auto const at_rest = []<class T>(Matrix<T, 3, 1> const& x) { return Vector<T, 2>(x[1], x[2]); };
  assert(cauchy_stress(rubber, first_jet(at_rest, Event<double, 2>(0, 1, 2))).norm() < 1e-12);
  // [continuum]
  // [cauchy_stress]
  Event<double, 2> const x(0.4, 1, 2);
  Matrix<double, 2, 2> const stress = cauchy_stress(rubber, first_jet(sheared, x));
  assert(std::abs(stress(0, 1) - stress(1, 0)) < 1e-12);  // symmetric, in units of a pressure
  // [cauchy_stress]
  // [solid_equation]
  auto const j = second_jet(sheared, x);
  Vector<double, 2> const rest = euler_lagrange(rubber, j);   // (6.12): by the derivatives of the density
  Vector<double, 2> const same = solid_equation(rubber, j);   // (6.21): by the stress
  assert((rest + same).norm() < 1e-12 * rest.norm());         // one is minus the other
  // [solid_equation]
}

BOOST_AUTO_TEST_CASE(a_gas) {
  // [barotropic]
  // Air as a polytropic gas, P = rho K J^-gamma: with rho K = 101325 Pa at rest, squeezed to half its volume.
  double const rho = 1.2;
  Continuum const air{Euclidean<2>{}, Euclidean<2>{}, Homogeneous<double>{rho},
                      Barotropic{Polytropic<double>{101325 / rho, 1.4}}};
  auto const squeezed = []<class T>(Matrix<T, 3, 1> const& x) { return Vector<T, 2>(x[1] / 2.0, x[2]); };
  auto const j = first_jet(squeezed, Event<double, 2>(0, 1, 2));
  assert(std::abs(material_pressure(air, j) / (101325 * std::pow(2, 1.4)) - 1) < 1e-14);
  // [barotropic]
}

// ---- constraints

BOOST_AUTO_TEST_CASE(a_multiplier) {
  // [constrained]
  auto const height = [](auto const& q) { return q[0] * 3.0 + q[1] * 4.0; };
  auto const sphere = []<class T>(Vector<T, 3> const& q) { return Matrix<T, 1, 1>(T(q.dot(q) - 1.0)); };
  auto const hill = constrained<1>(height, sphere);
  Vector<double, 3> const top(0.6, 0.8, 0);
  assert(hill.restricted_differential(top).norm() < 1e-15);        // no slope along the sphere
  assert(std::abs(hill.multiplier(top)[0] - 2.5) < 1e-15);   // dh = 2.5 d(q.q)
  // [constrained]
}

BOOST_AUTO_TEST_CASE(an_inextensible_string) {
  // [augmented_density]
  // A string that runs round a circle at the speed v, under the tension rho v^2.
  double const rho = 0.05, v = 6;
  auto const hoop = []<class T>(Matrix<T, 2, 1> const& x) {
    using std::cos, std::sin;
    T const s = x[1] - x[0] * 6.0;
    return Vector<T, 2>(T(cos(s)), T(sin(s)));
  };
  auto const tension = [&]<class T>(Matrix<T, 2, 1> const&) { return Matrix<T, 1, 1>(T(rho * v * v)); };
  AugmentedDensity const string{HeavyString<double, 2>{rho, {0, 0}}, Inextensible{Euclidean<2>{}}};
  auto const residual = euler_lagrange(string, ExtendedSection{hoop, tension}, Event<double, 1>(0.1, 0.2));
  assert(residual.norm() < 1e-14);
  // [augmented_density]
}

// ---- incompressible

BOOST_AUTO_TEST_CASE(water) {
  // [incompressible]
  // A drop that is drawn out, (tau X1, X2/tau) with tau = 1 + t, and its pressure.
  auto const drop = []<class T>(Matrix<T, 3, 1> const& x) {
    return Vector<T, 2>(T(x[1] * (x[0] + 1.0)), T(x[2] / (x[0] + 1.0)));
  };
  auto const P = []<class T>(Matrix<T, 3, 1> const& x) {
    T const y = x[2] / ((x[0] + 1.0) * (x[0] + 1.0));
    return T(-(y * y));
  };
  Euclidean<2> const flat;
  auto const water = incompressible(Continuum{flat, flat, Homogeneous<double>{}, NoStoredEnergy{}});
  auto const j = second_jet(with_pressure(drop, P, flat), Event<double, 2>(1, 0.3, 0.4));
  assert(std::abs(water.constraint(deformation(j))[0]) < 1e-15);  // J = 1
  assert(motion_residual(water, j).norm() < 1e-14);               // (8.7)
  // [incompressible]
}

// ---- noether

BOOST_AUTO_TEST_CASE(currents) {
  // [current_divergence]
  // The energy current of a medium: its divergence vanishes along solutions.
  Euclidean<2> const flat;
  Continuum const gas{flat, flat, Homogeneous<double>{}, Barotropic{Polytropic<double>{1, 2}}};
  auto const drifting = []<class T>(Matrix<T, 3, 1> const& x) { return Vector<T, 2>(x[1] + x[0], x[2]); };
  auto const leak = [&](auto const& phi) {
    return current_divergence(gas, TimeTranslation{}, second_jet(phi, Event<double, 2>(0.4, 0.2, 0.3)));
  };
  assert(std::abs(leak(drifting)) < 1e-15);
  assert(std::abs(leak(sheared)) > 1e-3);  // which solves nothing
  // [current_divergence]
  // [circulation]
  // A solid turn at the rate 3: the circulation round the unit circle of particles is 2 pi 3.
  auto const turning = []<class T>(Matrix<T, 3, 1> const& x) {
    using std::cos, std::sin;
    T const c = cos(T(x[0] * 3.0)), s = sin(T(x[0] * 3.0));
    return Vector<T, 2>(T(c * x[1] - s * x[2]), T(s * x[1] + c * x[2]));
  };
  auto const circle = []<class T>(T const& a) {
    using std::cos, std::sin;
    return Vector<T, 2>(T(cos(a)), T(sin(a)));
  };
  assert(std::abs(circulation(turning, Euclidean<2>{}, circle, 0.7) - 6 * std::numbers::pi) < 1e-13);
  // [circulation]
}

BOOST_AUTO_TEST_SUITE_END()
