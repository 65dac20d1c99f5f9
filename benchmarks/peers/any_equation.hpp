// GSL, Boost.odeint and the classical Runge-Kutta method on any system of ordinary differential equations,
// given by its rate.
#pragma once

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <array>
#include <memory>
#include <stdexcept>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wuninitialized"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#include <boost/numeric/odeint/algebra/array_algebra.hpp>
#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_runge_kutta_fehlberg78.hpp>
#include <boost/numeric/odeint/stepper/generation/make_controlled.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#pragma GCC diagnostic pop

namespace peers {

template <class S, std::size_t n>
using Numbers = std::array<S, n>;
template <class S, std::size_t n>
using FehlbergOf = boost::numeric::odeint::runge_kutta_fehlberg78<Numbers<S, n>, S, Numbers<S, n>, S,
                                                                  boost::numeric::odeint::array_algebra>;

/// A way from the start over stretches of time, all of the same length: calls `visit(k, y)` at the end of the
/// k-th.
/// @param rate  (y, out), at double and long double
template <std::size_t n, class Rate, class Visit>
void gsl_controlled(Rate const& rate, Numbers<double, n> y, double stretch, int stretches, double tolerance,
                    Visit const& visit) {
  auto const call = [](double, double const in[], double out[], void* self) {
    (*static_cast<Rate const*>(self))(in, out);
    return int(GSL_SUCCESS);
  };
  gsl_odeiv2_system system{call, nullptr, n, const_cast<Rate*>(&rate)};
  std::unique_ptr<gsl_odeiv2_driver, void (*)(gsl_odeiv2_driver*)> const driver(
      gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, 0.1, tolerance, tolerance),
      gsl_odeiv2_driver_free);
  double t = 0;
  for (int k = 1; k <= stretches; ++k) {
    if (gsl_odeiv2_driver_apply(driver.get(), &t, stretch * k, y.data()) != GSL_SUCCESS)
      throw std::runtime_error("gsl: a step failed");
    visit(k, y);
  }
}
/// Boost.odeint's Fehlberg 7(8) with step control.
template <std::size_t n, class Rate, class Visit>
void odeint_controlled(Rate const& rate, Numbers<double, n> y, double stretch, int stretches,
                       double tolerance, Visit const& visit) {
  namespace odeint = boost::numeric::odeint;
  auto scheme = odeint::make_controlled<FehlbergOf<double, n>>(tolerance, tolerance);
  auto const system = [&](auto const& at, auto& out, double) { rate(at, out); };
  for (int k = 1; k <= stretches; ++k) {
    odeint::integrate_adaptive(scheme, system, y, 0.0, stretch, 0.1);
    visit(k, y);
  }
}
/// Boost.odeint's Fehlberg 7(8) with so many steps a stretch.
template <class S, std::size_t n, class Rate, class Visit>
void odeint_steps(Rate const& rate, Numbers<S, n> y, S stretch, int stretches, long steps,
                  Visit const& visit) {
  FehlbergOf<S, n> scheme;
  auto const system = [&](auto const& at, auto& out, S) { rate(at, out); };
  for (int k = 1; k <= stretches; ++k) {
    for (long i = 0; i < steps; ++i) scheme.do_step(system, y, S(0), stretch / S(steps));
    visit(k, y);
  }
}
/// The classical Runge-Kutta method with so many steps a stretch.
template <std::size_t n, class Rate, class Visit>
void runge_kutta_steps(Rate const& rate, Numbers<double, n> y, double stretch, int stretches, long steps,
                       Visit const& visit) {
  double const h = stretch / static_cast<double>(steps);
  Numbers<double, n> a, b, c, d, at;
  auto const beside = [&](Numbers<double, n> const& slope, double by) {
    for (std::size_t i = 0; i < n; ++i) at[i] = y[i] + by * slope[i];
  };
  for (int k = 1; k <= stretches; ++k) {
    for (long s = 0; s < steps; ++s) {
      rate(y, a), beside(a, h / 2), rate(at, b), beside(b, h / 2), rate(at, c), beside(c, h), rate(at, d);
      for (std::size_t i = 0; i < n; ++i) y[i] += h / 6 * (a[i] + 2 * (b[i] + c[i]) + d[i]);
    }
    visit(k, y);
  }
}

}  // namespace peers
