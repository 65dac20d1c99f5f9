// Reference solutions of ordinary differential equations, by somebody else's code.
//
// The Prince-Dormand pair of orders 8 and 9 of the GNU Scientific Library with its step control, near
// rounding. Our own schemes are measured against it; nothing of them is in it.
#pragma once

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <cmath>
#include <memory>
#include <string>

#include "actio/numbers/errors.hpp"
#include "actio/numbers/scalar.hpp"

namespace actio {

/// y(t1) of \f$\dot y = f(t, y)\f$, \f$y(t_0) = y_0\f$.
///
/// @param f         (double t, vector y) -> vector; any column vector, fixed or not
/// @param y0        the state at t0
/// @param relative  local error allowed per step, relative to the largest component of y0 (and of y as it
///                  goes)
/// @throws NotFinite     where t0, t1, y0 or the solution is no number
/// @throws NotConverged  where the step control gives up
/// @throws OutsideDomain where `relative` is not positive
/// Accuracy: a few hundred times `relative` over tens of periods; compare two values of `relative` to know.
template <class F, MatrixLike Derived>
typename Derived::PlainObject reference_solution(F const& f, Derived const& y0, double t0, double t1,
                                                 double relative = 1e-15) {
  using Vector = typename Derived::PlainObject;
  Vector y = y0;
  if (!is_finite(y) || !std::isfinite(t0) || !std::isfinite(t1))
    throw NotFinite("reference_solution: initial state or times");
  if (!(relative > 0) || !std::isfinite(relative))
    throw OutsideDomain("reference_solution", "a positive local error is needed", relative, 0);
  double const scale = magnitude(y);
  if (t0 == t1 || y.size() == 0) return y;

  struct Problem {
    F const& f;
    Index size;
  } problem{f, y.size()};
  gsl_odeiv2_system system{[](double t, double const* state, double* rate, void* data) -> int {
                             auto const& p = *static_cast<Problem*>(data);
                             Vector place(p.size);
                             for (Index i = 0; i < p.size; ++i) place[i] = state[i];
                             Vector const value = p.f(t, place);
                             for (Index i = 0; i < p.size; ++i) rate[i] = value[i];
                             return is_finite(value) ? GSL_SUCCESS : GSL_EBADFUNC;
                           },
                           nullptr, static_cast<std::size_t>(y.size()), &problem};

  // GSL would end the program; put its handler back whatever happens, also when f throws.
  struct Quiet {
    gsl_error_handler_t* previous = gsl_set_error_handler_off();
    ~Quiet() { gsl_set_error_handler(previous); }
  } const quiet;
  // Where everything starts at zero, the rates say what is small.
  double const span = std::abs(t1 - t0), size = scale > 0 ? scale : magnitude(Vector(f(t0, y))) * span;
  double const first = (t1 - t0) * 1e-4;
  std::unique_ptr<gsl_odeiv2_driver, decltype(&gsl_odeiv2_driver_free)> const driver(
      gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, first,
                                    relative * (size > 0 && std::isfinite(size) ? size : 1.0), relative),
      &gsl_odeiv2_driver_free);
  double t = t0;
  int const status = gsl_odeiv2_driver_apply(driver.get(), &t, t1, y.data());
  if (!is_finite(y) || status == GSL_EBADFUNC)
    throw NotFinite("reference_solution: the solution at t = " + show(t));
  if (status != GSL_SUCCESS)
    throw NotConverged("reference_solution: " + std::string(gsl_strerror(status)) + " at t = " + show(t), {},
                       relative);
  return y;
}

}  // namespace actio
