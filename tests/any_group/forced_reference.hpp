// What tests of steps with forces and friction share: systems, and their equations solved by GSL.
#pragma once

#include <boost/test/unit_test.hpp>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include "own_system.hpp"

namespace actio::testing {

using namespace actio::systems;
inline constexpr double eps = std::numeric_limits<double>::epsilon();
using List = std::vector<double>;
using System = std::shared_ptr<ReducedSystem const>;
using Square = Eigen::MatrixXd;

inline Square one(System const& system) { return Square::Identity(system->length(), system->length()); }
inline double largest(List const& x) {
  double out = 0;
  for (double const c : x) out = std::max(out, std::abs(c));
  return out;
}
inline List minus(List a, List const& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] -= b[i];
  return a;
}
/// The slope of the last two errors, of steps in the ratio 2.
inline double slope(List const& errors) { return std::log2(errors[errors.size() - 2] / errors.back()); }

/// `n` coordinates of which none is simple.
inline List uneven(int n, double size) {
  List out;
  for (int i = 0; i < n; ++i) out.push_back(size * std::sin(1 + 2.3 * i));
  return out;
}
/// A kinetic energy in the velocities of an algebra, no two of whose axes are alike.
inline std::string kinetic(MatrixAlgebra const& algebra) {
  std::string out;
  for (std::size_t i = 0; i < algebra.components.size(); ++i) {
    auto const& v = algebra.components[i];
    out += (i ? " + " : "") + std::to_string(1 + 0.4 * static_cast<double>(i)) + "*" + v + "^2/2";
  }
  return out + " + " + algebra.components[0] + "*" + algebra.components[1] + "/8";
}
inline System free_system(char const* group, Side side) {
  return own_system(group, side, kinetic(named_algebra(group)).c_str());
}

/// Momentum and vectors by GSL's Prince-Dormand method of order 8, for p = M v.
inline List by_gsl(System const& system, ReducedPoint const& start, double time) {
  struct Rates {
    System system;
    Square inverse_mass;
  } rates{system, {}};
  int const d = system->dimension(), m = system->carried();
  rates.inverse_mass =
      LegendreVelocity(*system).hessian(List(static_cast<std::size_t>(d)), start.vectors).inverse();
  auto const rate = [](double t, double const* y, double* out, void* with) {
    auto const& [system, inverse_mass] = *static_cast<Rates const*>(with);
    int const d = system->dimension(), m = system->carried();
    Eigen::VectorXd const p = Eigen::Map<Eigen::VectorXd const>(y, d), v = inverse_mass * p;
    std::vector<double> work, inputs(v.data(), v.data() + d), slopes(static_cast<std::size_t>(1 + d + m)),
        force(static_cast<std::size_t>(d));
    inputs.insert(inputs.end(), y + d, y + d + m);
    system->slopes(inputs.data(), slopes.data(), work);
    inputs.insert(inputs.end(), y, y + d);
    inputs.push_back(t);
    for (auto const& held : system->force->held) inputs.push_back(held(t));
    system->force->components(inputs.data(), force.data(), work);
    double const sign = system->sign();
    Eigen::VectorXd const turned = system->algebra.ad(Vector<double>(v)).transpose() * p;
    for (int i = 0; i < d; ++i) out[i] = sign * turned[i] + force[static_cast<std::size_t>(i)];
    Eigen::MatrixXd const hat = system->algebra.hat(Vector<double>(v));
    for (int k = 0; k < m; ++k) out[d + k] = 0;
    for (int first = 0; first < m; first += system->length()) {
      Eigen::VectorXd const a = Eigen::Map<Eigen::VectorXd const>(y + d + first, system->length());
      Eigen::VectorXd const moved = -sign * hat * a;
      for (int i = 0; i < system->length(); ++i) out[d + first + i] = moved[i];
      for (int c = 0; c < d; ++c) {
        Eigen::VectorXd const turned_by = system->algebra.basis[static_cast<std::size_t>(c)] * a;
        double torque = 0;
        for (int i = 0; i < system->length(); ++i)
          torque += slopes[static_cast<std::size_t>(1 + d + first + i)] * turned_by[i];
        out[c] -= sign * torque;
      }
    }
    return int(GSL_SUCCESS);
  };
  List y = start.momentum;
  y.insert(y.end(), start.vectors.begin(), start.vectors.end());
  gsl_odeiv2_system equations{rate, nullptr, static_cast<std::size_t>(d + m), &rates};
  auto* const driver = gsl_odeiv2_driver_alloc_y_new(&equations, gsl_odeiv2_step_rk8pd, 1e-3, 1e-14, 1e-14);
  double t = start.time;
  BOOST_TEST_REQUIRE(gsl_odeiv2_driver_apply(driver, &t, t + time, y.data()) == int(GSL_SUCCESS));
  gsl_odeiv2_driver_free(driver);
  return y;
}

}  // namespace actio::testing
