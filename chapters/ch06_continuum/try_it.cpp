// The lines to try of chapter 6: jets, momenta, the Cartan form, the sign of (6.8), Newton's law, Piola's
// identity and stresses.
//
// All but the last two are about the gas of gas_ellipse.hpp, `thrown_gas()`, a turning ellipse that spreads.
#include "book/try_it.hpp"
#include "actio/continuum/continuum_equations.hpp"
#include "actio/continuum/stresses.hpp"
#include "actio/continuum/two_point_divergence.hpp"
#include "actio/jets/cartan.hpp"
#include "actio/jets/field_equations.hpp"
#include "actio/jets/first_variation.hpp"
#include "actio/jets/prolongation.hpp"
#include "actio/numbers/print.hpp"
#include "gas_ellipse.hpp"

using namespace actio;

TRY_IT(jet) {
  auto const phi = linear_motion<2>(EllipticGas{0.2, 1.4}, thrown_gas());  // A(t) x
  auto const from_a_train = [&](auto const& x) {  // with the velocity 3 along the first axis
    auto y = phi(x);
    y[0] -= 3.0 * x[0];
    return y;
  };
  Event<double, 2> const x(0.1, 0.6, 0.3);  // the time, then the particle
  auto const j = first_jet(phi, x);
  print("velocity", j.velocity());
  print("deformation gradient F", j.gradient());
  print("the same jet from the train", first_jet(from_a_train, x).v);
  Matrix<double, 2, 2> const F = j.gradient();
  print("Jacobian", jacobian(Kronecker<2>{}, Kronecker<2>{}, F));
}

TRY_IT(legendre) {
  EllipticGas const gas{0.2, 1.4};
  auto const medium = gas.medium();
  auto const phi = linear_motion<2>(gas, thrown_gas());
  auto const j = first_jet(phi, Event<double, 2>(0.1, 0.6, 0.3));
  auto const z = legendre(medium, j);  // a point of the dual jet bundle: x, y, Pi, p
  print("momenta p, a column for each mu", z.p);
  print("Pi", z.Pi);
  auto other = j;  // another jet at the same point
  other.v(0, 0) += 0.1;
  print("L and the affine map, on its own jet", Vector<double, 2>(medium(j), pairing(z, j)));
  print("the same on the other jet", Vector<double, 2>(medium(other), pairing(z, other)));
}

TRY_IT(roots) {
  ConstantMetric<double, 2> const G{Matrix<double, 2, 2>{{4, 0}, {0, 1}}};  // the root of det G is 2
  EllipticGas const gas{0.2, 1.4};
  Continuum const medium{G, Euclidean<2>{}, Homogeneous<double>{}, gas.medium().W};
  auto const phi = linear_motion<2>(gas, thrown_gas());
  auto const j = first_jet(phi, Event<double, 2>(0.1, 0.6, 0.3));
  auto const z = legendre(medium, j);
  double const e = energy_density(medium, j);
  double const work = z.p.rightCols<2>().cwiseProduct(j.gradient()).sum();  // p_a^j v^a_j
  print("Pi + p_a^j v^a_j + e", z.Pi + work + e);
  print("as printed, with e times the root of det G", z.Pi + work + 2 * e);
}

TRY_IT(holonomic) {
  EllipticGas const gas{0.2, 1.4};
  auto const medium = gas.medium();
  auto const phi = linear_motion<2>(gas, thrown_gas());
  // Sections of the jet bundle over the same places; the second velocity is scaled.
  auto const section = [&](double scale) {
    return [&, scale](auto const& x) {
      auto j = first_jet(phi, x);
      j.v(1, 0) *= scale;
      return coordinates(j);
    };
  };
  Event<double, 2> const x(0.1, 0.6, 0.3);
  Tangents<double, 3, 3> const sides = Tangents<double, 3, 3>::Identity();
  auto const Theta = cartan_form<2, 2>(medium);
  auto const miss = [&](auto const& z) {  // z* Theta_L - L(z)
    return pull_back(z, Theta)(x, sides) - medium(jet_at<2, 2>(z(x)));
  };
  print("the jet of phi", miss(section(1.0)));
  print("one velocity put to zero", miss(section(0.0)));
  print("one velocity doubled", miss(section(2.0)));
}

TRY_IT(sign) {
  EllipticGas const gas{0.2, 1.4};
  auto const medium = gas.medium();
  auto const motion = linear_motion<2>(gas, thrown_gas());
  auto const phi = [&](auto const& x) {  // solves nothing
    return (motion(x) * (x[1] * x[1] + 1.0)).eval();
  };
  auto const V = [](auto at) {  // (V^mu, V^a): moves space-time and places
    at << 1.0, 0.5, 0.0, 0.3, 1.0;
    return at;
  };
  Event<double, 2> const x(0.1, 0.6, 0.3);
  auto const j = second_jet(phi, x);
  auto const E = euler_lagrange(medium, j);
  auto const q = vertical_part<double, 2, 2>(j, V(Variation<double, 2, 2>()));
  auto const Omega = multisymplectic_form<2, 2>(medium);
  Tangents<double, 3, 3> const sides = Tangents<double, 3, 3>::Identity();
  // [eq_6_8]
  double const left = E.dot(q);
  auto const contracted = contract(prolonged<2, 2>(V), Omega);
  double const right = -pull_back(jet_extension(phi), contracted)(x, sides);
  // [eq_6_8]
  print("left and right side of (6.8)", Vector<double, 2>(left, right));
  print("with the printed sign they differ by", left + right);
}

TRY_IT(newton) {
  EllipticGas const gas{0.2, 1.4};
  auto const medium = gas.medium();
  auto const phi = linear_motion<2>(gas, thrown_gas());
  auto const j = second_jet(phi, Event<double, 2>(0.1, 0.6, 0.3));
  double const rho = medium.rho(j.particle());
  auto const stress = [&](auto const& jet) {  // rho dW/dv, a matrix; it gets its name in (6.19)
    return first_piola_kirchhoff_stress(medium, jet);
  };
  // [eq_6_15]
  Vector<double, 2> const left = rho * j.acceleration();
  Vector<double, 2> const right = total_divergence(stress, j);
  // [eq_6_15]
  print("mass times acceleration", left);
  print("divergence of the stress", right);
}

TRY_IT(pressure) {
  EllipticGas const gas{0.2, 1.4};
  auto const medium = gas.medium();
  auto const phi = linear_motion<2>(gas, thrown_gas());
  auto const j = second_jet(phi, Event<double, 2>(0.1, 0.6, 0.3));
  Jet<double, 2, 2> const first = j;
  double const J = determinant(first.gradient()), rho = medium.rho(j.particle());
  print("material pressure", material_pressure(medium, first));
  print("K (rho/J)^gamma", gas.K * std::pow(rho / J, gas.gamma));
  print("Cauchy stress", cauchy_stress(medium, first));
  print("residual of (6.18)", fluid_equation(medium, j));
}

TRY_IT(cofactors) {
  auto const bend = [](auto const& x) {  // a deformation of the plane at the time x[0]
    auto y = x.template tail<2>().eval();
    y[0] += x[1] * x[2] * 0.3, y[1] += x[1] * x[1] * 0.2 * x[0];
    return y;
  };
  auto j = second_jet(bend, Event<double, 2>(0.5, 0.4, -0.2));
  auto const det = [](auto const& jet) { return determinant(jet.gradient()); };
  auto const inverse = [](auto const& jet) {  // a row for each a, a column for each k
    return inverse_matrix(jet.gradient()).transpose().eval();
  };
  Vector<double, 2> const slopes(total_derivative(1, det, j), total_derivative(2, det, j));
  print("(I)", Vector<double, 2>(inverse(j) * slopes));
  print("(II)", Vector<double, 2>(total_divergence(inverse, j) * det(j)));
  Euclidean<2> const flat;
  print("their sum", piola_identity(flat, flat, j));
  j.w[1](0, 2) += 0.1;  // a second derivative: d_1 F^1_2 is no longer d_2 F^1_1, F is no gradient
  print("their sum, no gradient", piola_identity(flat, flat, j));
}

TRY_IT(stresses) {
  Continuum const rubber{Euclidean<3>{}, Euclidean<3>{}, Homogeneous<double>{},
                         OfGreenTensor{NeoHookean{1.0, LogarithmicVolume<double>{2.0}}}};
  Jet<double, 3, 3> j;
  j.x.setZero(), j.y.setZero();
  j.v << 0, 1.4, 0.2, 0, 0, -0.1, 0.8, 0.1, 0, 0, 0, 0.9;  // stretched, sheared
  Matrix<double, 3, 3> const F = j.gradient();
  Matrix<double, 3, 3> const P = first_piola_kirchhoff_stress(rubber, j);
  Matrix<double, 3, 3> const sigma = cauchy_stress(rubber, j);
  print("first Piola-Kirchhoff stress", P);
  print("Cauchy stress", sigma);
  Kronecker<3> const flat;
  Matrix<double, 3, 3> const carried = piola_transformation(flat, flat, F, sigma);
  print("difference from Piola's transformation of sigma", (P - carried).norm());
}

TRY_IT_MAIN("the lines to try of chapter 6")
