// Lines to try of chapter 8: a gas and rubber, a drop and its pressure, the bracket of fields.
#include <cmath>

#include "actio/continuum/materials.hpp"
#include "actio/incompressible/bracket_of_fields.hpp"
#include "actio/incompressible/ideal_fluid.hpp"
#include "actio/incompressible/incompressible_equations.hpp"
#include "actio/incompressible/two_pressures.hpp"
#include "actio/jets/field_equations.hpp"
#include "actio/numbers/print.hpp"
#include "book/try_it.hpp"
using namespace actio;

TRY_IT(gas_and_rubber) {
  // A gas and rubber under the constraint, along a motion that solves nothing, with some pressure.
  auto const motion = []<class T>(Matrix<T, 3, 1> const& x) {
    return Matrix<T, 2, 1>(T(x[1] + x[0] * x[2] * x[2]), T(x[2] + x[1] * x[1]));
  };
  auto const P = []<class T>(Matrix<T, 3, 1> const& x) { return T(x[1] * x[2]); };
  Euclidean<2> const flat;
  Homogeneous<double> const mass;
  auto const gas = incompressible(Continuum{flat, flat, mass, Barotropic{Polytropic<double>{1, 1.4}}});
  OfGreenTensor const neo_hookean{NeoHookean{1.0, LogarithmicVolume<double>{2.0}}};
  auto const rubber = incompressible(Continuum{flat, flat, mass, neo_hookean});
  auto const j = second_jet(with_pressure(motion, P, flat), Event<double, 2>(0.2, 0.3, 0.4));
  print("gas, left side of (8.7) minus right", motion_residual(gas, j));
  print("gas, Euler-Lagrange derivative in y and lambda", euler_lagrange(gas, j));
  print("rubber, left side of (8.7) minus right", motion_residual(rubber, j));
  print("rubber, Euler-Lagrange derivative in y and lambda", euler_lagrange(rubber, j));
}

TRY_IT(drawn_out) {
  // A drop that is drawn out, (tau x1, x2/tau) with tau = 1 + t, and its pressure.
  auto const motion = []<class T>(Matrix<T, 3, 1> const& x) {
    return Matrix<T, 2, 1>(T(x[1] * (x[0] + 1.0)), T(x[2] / (x[0] + 1.0)));
  };
  auto const P = []<class T>(Matrix<T, 3, 1> const& x) {
    T const y2 = x[2] / ((x[0] + 1.0) * (x[0] + 1.0));
    return T(-(y2 * y2));
  };
  Euclidean<2> const flat;
  Continuum const water{flat, flat, Homogeneous<double>{}, NoStoredEnergy{}};
  auto const fluid = incompressible(water);
  auto const j = second_jet(with_pressure(motion, P, flat), Event<double, 2>(1, 0.3, 0.4));
  print("J - 1", fluid.constraint(deformation(j))[0]);
  print("residual of (8.9)", ideal_fluid_residual(flat, flat, j));
  print("dP/dx that the motion requires", required_pressure_gradient(fluid, deformation(j)));
  print("dP/dx of the given pressure", pressure_gradient(flat, j));
}

TRY_IT(in_space) {
  // The same motion seen from space: u = (y1, -y2)/tau, and p = -(y2/tau)^2.
  auto const u = []<class T>(Matrix<T, 3, 1> const& at) {
    return Matrix<T, 2, 1>(T(at[1] / (at[0] + 1.0)), T(-at[2] / (at[0] + 1.0)));
  };
  auto const p = []<class T>(Matrix<T, 3, 1> const& at) {
    T const y = at[2] / (at[0] + 1.0);
    return T(-(y * y));
  };
  Euclidean<2> const flat;
  Vector<double, 3> const at(1, 0.6, 0.2);
  print("du/dt + u.grad u", eulerian_acceleration(flat, u, at));
  print("-grad p", (-gradient(flat, p, at)).eval());
  print("laplacian of p", laplacian(flat, p, at));
  print("source of (8.14)", pressure_source(flat, u, at));
}

TRY_IT(stiff_drop) {
  // A'' = -2 kappa (J - 1) J A^-T beside A'' = m A^-T, for one unit of time.
  using Matrix2 = Matrix<double, 2, 2>;
  auto const after_one = [](auto const& f) {
    double const h = 1e-3;
    Matrix2 A = Matrix2::Identity(), V;
    V << 0.5, 1, 0.3, -0.5;
    for (int i = 0; i < 1000; ++i) {
      Matrix2 const a = f(A, V), b = f(A + h / 2 * V, V + h / 2 * a),
                    c = f(A + h / 2 * V + h * h / 4 * a, V + h / 2 * b),
                    d = f(A + h * V + h * h / 2 * b, V + h * c);
      A += h * V + h * h / 6 * (a + b + c);
      V += h / 6 * (a + 2 * b + 2 * c + d);
    }
    return A;
  };
  Matrix2 const drop = after_one([](Matrix2 const& A, Matrix2 const& V) {
    Matrix2 const inverse = inverse_matrix(A), rate = V * inverse;
    double const m = (rate * rate).trace() / inverse.squaredNorm();
    return Matrix2(m * inverse.transpose());
  });
  print("J - 1 of the drop", determinant(drop) - 1);
  for (double const kappa : {1e2, 1e3, 1e4}) {
    Matrix2 const gas = after_one([kappa](Matrix2 const& A, Matrix2 const&) {
      double const J = determinant(A);
      return Matrix2(-2 * kappa * (J - 1) * J * inverse_matrix(A).transpose());
    });
    print("kappa", kappa);
    print("  distance of the gas from the drop", (gas - drop).norm());
  }
}

TRY_IT(bracket) {
  // Two shears of the plane, and the bracket of the Lie algebra of diffeomorphisms.
  auto const X = []<class T>(Matrix<T, 2, 1> const& y) {
    T const square = y[1] * y[1];
    return Matrix<T, 2, 1>(square, T(0.0));
  };
  auto const Y = []<class T>(Matrix<T, 2, 1> const& y) {
    T const first = y[0];
    return Matrix<T, 2, 1>(T(0.0), first);
  };
  Vector<double, 2> const at(0.3, 0.5);
  auto const Z = diffeomorphism_bracket(X, Y);
  print("[X, Y]", Z(at));
  print("its divergence", derivative(Z, at).matrix.trace());
}

TRY_IT(stiff_rubber) {
  // A block of the neo-Hookean solid, stretched by 1.5 with free sides; kappa resists the change of volume.
  double const stretch = 1.5, exact = 1 / stretch - 1;  // pressure over rho mu if J = 1
  for (double const kappa : {1e1, 1e3, 1e5}) {
    double side = 1 / std::sqrt(stretch);  // no stress on the sides: side^2 - 1 + kappa (J - 1) J = 0
    for (int i = 0; i < 30; ++i) {
      double const J = stretch * side * side;
      double const slope = 2 * side * (1 + kappa * stretch * (2 * J - 1));
      side -= (side * side - 1 + kappa * (J - 1) * J) / slope;
    }
    double const J = stretch * side * side;
    print("kappa", kappa);
    print("  J - 1", J - 1);
    print("  -kappa (J - 1), less the pressure of the constraint", -kappa * (J - 1) - exact);
  }
}

TRY_IT_MAIN("the lines to try of chapter 8")
