// The tension of a string that runs, held to the field equations and found from its motion alone in two ways:
// at a single point, and along the string.
//
// The motion is phi(t, s), s the length; the equations are rho (phi_tt - g) = (T phi_s)_s and |phi_s| = 1,
// with gravity downwards along the second axis.
#pragma once

#include <algorithm>
#include <vector>

#include "actio/constraints/constrained_equations.hpp"
#include "actio/constraints/inextensible.hpp"
#include "actio/linear_algebra/linear.hpp"
#include "strings.hpp"

// The largest of what the constrained field equations leave, over the largest force that they balance: rho
// |phi_tt| and the weight.
template <class Shape>
double residual(Tension<Shape> const& tension, double low, double high) {
  actio::HeavyString<double, 2> const string{tension.phi.rho, {0, -tension.g}};
  actio::AugmentedDensity const density{string, actio::Inextensible{actio::Euclidean<2>{}}};
  actio::ExtendedSection const extended{tension.phi, tension};
  double worst = 0, scale = tension.phi.rho * tension.g;
  for (int i = 0; i <= 200; ++i) {
    actio::Event<double, 1> const x(0.03, low + (high - low) * i / 200);
    scale = std::max(scale, tension.phi.rho * actio::second_jet(tension.phi, x).acceleration().norm());
    worst = std::max(worst, euler_lagrange(density, extended, x).cwiseAbs().maxCoeff());
  }
  return worst / scale;
}

// The tension at a point from the field equations alone: rho (phi_tt - g) = T phi_ss + T_s phi_s is two
// equations for T and T_s.
template <class Shape>
double tension_from_equations(Running<Shape> const& phi, double g, actio::Event<double, 1> const& x) {
  auto const j = actio::second_jet(phi, x);
  actio::Matrix<double, 2, 2> both;
  both << j.w[1].col(1), j.v.col(1);
  return actio::solve_linear(
      both, actio::Vector<double, 2>(phi.rho * (j.acceleration() + actio::Vector<double, 2>(0, g))))[0];
}
// The largest relative error of the tension that is found so.
template <class Shape>
double apart(Tension<Shape> const& tension, double low, double high) {
  double worst = 0;
  for (int i = 0; i <= 100; ++i) {
    actio::Event<double, 1> const x(0.02, low + (high - low) * i / 100);
    worst = std::max(worst, std::abs(tension_from_equations(tension.phi, tension.g, x) / tension(x)[0] - 1));
  }
  return worst;
}

// The tension from place and velocity: differentiating the constraint twice in time leaves T'' - |phi_ss|^2
// T = -rho |phi_st|^2. Second differences on the even grid s, round a loop or between two ends, each a step
// beyond the grid, where T is known.
template <class Shape>
std::vector<double> tension_from_boundary_values(Running<Shape> const& phi, std::vector<double> const& s,
                                                 bool closed, double first = 0, double last = 0) {
  int const count = static_cast<int>(s.size());
  double const h = s[1] - s[0];
  actio::Matrix<double> A = actio::Matrix<double>::Zero(count, count);
  actio::Vector<double> b(count);
  for (int i = 0; i < count; ++i) {
    auto const j = actio::second_jet(phi, actio::Event<double, 1>(0, s[i]));
    A(i, i) = -2 / (h * h) - j.w[1].col(1).squaredNorm();
    b[i] = -phi.rho * j.w[1].col(0).squaredNorm();
    for (int side : {-1, 1})
      if (int const k = i + side; closed)
        A(i, (k + count) % count) += 1 / (h * h);
      else if (k < 0 || k == count)
        b[i] -= (k < 0 ? first : last) / (h * h);
      else
        A(i, k) = 1 / (h * h);
  }
  actio::Vector<double> const T = actio::solve_linear(A, b);
  return {T.data(), T.data() + count};
}
