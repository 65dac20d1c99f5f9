// GSL: the Prince-Dormand pair of orders 8 and 9, in steps of one length and with step control.
#pragma once

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <limits>
#include <stdexcept>

#include "peers/euler_equations.hpp"

namespace peers {

inline int gsl_rate(double, double const y[], double rate[], void* equations) {
  static_cast<EulerEquations const*>(equations)->rate(y, rate);
  return GSL_SUCCESS;
}

/// Steps of one length. GSL's method works in memory of its own.
class GslStepper final : public Stepper {
 public:
  GslStepper(Task const& task, double h)
      : equations_(task),
        y_(task.start()),
        h_(h),
        step_(gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, 7), gsl_odeiv2_step_free) {}
  void advance(long steps) override {
    gsl_odeiv2_system const system{gsl_rate, nullptr, 7, &equations_};
    Seven error;
    for (; steps > 0; --steps)
      if (gsl_odeiv2_step_apply(step_.get(), 0, h_, y_.data(), error.data(), nullptr, nullptr, &system) !=
          GSL_SUCCESS)
        throw std::runtime_error("gsl: a step failed");
  }
  Seven state() const override { return y_; }

 private:
  EulerEquations equations_;
  Seven y_;
  double h_;
  std::unique_ptr<gsl_odeiv2_step, void (*)(gsl_odeiv2_step*)> step_;
};

inline Method gsl_prince_dormand() {
  return {"GSL, Prince-Dormand 8(9)",
          [](Task const& task, double h) { return std::make_unique<GslStepper>(task, h); }};
}

/// With step control: the states at so many times on the way to the last; not a number where GSL gives up.
/// @param tolerance  of a step, absolute and relative
template <std::size_t count>
std::array<Seven, count> gsl_adaptive(Task const& task, double time, double tolerance) {
  EulerEquations equations(task);
  gsl_odeiv2_system system{gsl_rate, nullptr, 7, &equations};
  std::unique_ptr<gsl_odeiv2_driver, void (*)(gsl_odeiv2_driver*)> const driver(
      gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, 0.1, tolerance, tolerance),
      gsl_odeiv2_driver_free);
  std::array<Seven, count> states;
  Seven y = task.start();
  double t = 0;
  for (std::size_t k = 0; k < count; ++k) {
    if (gsl_odeiv2_driver_apply(driver.get(), &t, time * double(k + 1) / count, y.data()) != GSL_SUCCESS)
      y.fill(std::numeric_limits<double>::quiet_NaN());
    states[k] = y;
  }
  return states;
}

}  // namespace peers
