// Boost.odeint: the Fehlberg pair of orders 7 and 8 and the Dormand-Prince pair of orders 4 and 5, in steps
// of one length and with step control.
#pragma once

// The compiler warns of copies of steppers whose memory is not yet initialized, which is as it should be.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wuninitialized"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#include <boost/numeric/odeint/algebra/array_algebra.hpp>
#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_runge_kutta_fehlberg78.hpp>
#include <boost/numeric/odeint/stepper/generation/make_controlled.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#pragma GCC diagnostic pop

#include "peers/euler_equations.hpp"

namespace peers {

namespace odeint = boost::numeric::odeint;
using Fehlberg = odeint::runge_kutta_fehlberg78<Seven, double, Seven, double, odeint::array_algebra>;
using DormandPrince = odeint::runge_kutta_dopri5<Seven, double, Seven, double, odeint::array_algebra>;

/// A step of one of its schemes.
template <class Scheme>
struct OdeintStep {
  double h;
  EulerEquations equations;
  Scheme scheme{};

  [[gnu::always_inline]] void operator()(Seven& y) {
    scheme.do_step([&](Seven const& at, Seven& rate, double) { equations.rate(at, rate); }, y, 0.0, h);
  }
};
template <class Scheme>
std::unique_ptr<Stepper> odeint_stepper(Task const& task, double h) {
  return stepper(task.start(), OdeintStep<Scheme>{h, EulerEquations(task)});
}

inline Method odeint_fehlberg() { return {"odeint, Fehlberg 7(8)", odeint_stepper<Fehlberg>}; }
inline Method odeint_dormand_prince() {
  return {"odeint, Dormand-Prince 5(4)", odeint_stepper<DormandPrince>};
}

/// With step control: the states at so many times on the way to the last.
/// @param tolerance  of a step, absolute and relative
template <std::size_t count>
std::array<Seven, count> odeint_adaptive(Task const& task, double time, double tolerance) {
  std::array<Seven, count> states;
  Seven y = task.start();
  EulerEquations const equations(task);
  auto scheme = odeint::make_controlled<Fehlberg>(tolerance, tolerance);
  for (Seven& s : states) {
    odeint::integrate_adaptive(
        scheme, [&](Seven const& at, Seven& rate, double) { equations.rate(at, rate); }, y, 0.0, time / count,
        0.1);
    s = y;
  }
  return states;
}

}  // namespace peers
