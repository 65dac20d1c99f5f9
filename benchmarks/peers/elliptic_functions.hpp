// The free body in closed form, as textbooks have it: the momentum in Jacobi's elliptic functions, the angle
// of the precession in an elliptic integral of the third kind, both by GSL.
//
// With I1 < I2 < I3 and 2 E I2 < L^2 the momentum goes round the third axis,
//   M1 = a cn u, M2 = s b sn u, M3 = s c dn u,   u = rate (t - t0),
//   and the body turns about the momentum by L t / I3 + (1/I1 - 1/I3) L / rate (Pi(am u; nu, k) - Pi(am u0;
//   nu, k)). Where L^2 < 2 E I2 the first and the third axis change their parts.
#pragma once

#include <gsl/gsl_sf_ellint.h>
#include <gsl/gsl_sf_elljac.h>

#include <array>
#include <memory>
#include <stdexcept>

#include "peers/quaternion.hpp"

namespace peers {

/// What the closed form needs of a body and its start, found once.
class EllipticBody {
 public:
  /// @throws std::runtime_error  where the moments are not in ascending order or the motion is on the
  ///                         separatrix
  explicit EllipticBody(Task const& task) {
    double const energy2 =
        square(task.M[0]) / task.I[0] + square(task.M[1]) / task.I[1] + square(task.M[2]) / task.I[2];
    double const L2 = square(task.M[0]) + square(task.M[1]) + square(task.M[2]);
    // In the reversed order of the axes one of them changes its direction, so that the frame stays
    // right-handed.
    reversed_ = L2 < energy2 * task.I[1];
    auto const I = reversed_ ? std::array{task.I[2], task.I[1], task.I[0]} : task.I;
    auto const M = own(task.M);
    L_ = std::sqrt(L2);
    double const first = energy2 * I[2] - L2, third = L2 - energy2 * I[0];
    a_ = std::sqrt(I[0] * first / (I[2] - I[0]));
    b_ = std::sqrt(I[1] * first / (I[2] - I[1]));
    c_ = std::sqrt(I[2] * third / (I[2] - I[0]));
    // In the reversed order both differences of moments are negative, and so are `first` and `third`.
    rate_ = std::sqrt((I[2] - I[1]) * third / (I[0] * I[1] * I[2]));
    m_ = (I[1] - I[0]) * first / ((I[2] - I[1]) * third);
    if (!(rate_ > 0) || !(m_ >= 0 && m_ < 1))
      throw std::runtime_error("elliptic functions: a separatrix or axes out of order");
    k_ = std::sqrt(m_);
    nu_ = I[2] * (I[1] - I[0]) / (I[0] * (I[2] - I[1]));
    sign_ = std::copysign(1.0, M[2]);
    // In which sense M2 goes round follows from the sense of the axes.
    sense_ = sign_ * (I[2] > I[0] ? 1 : -1);
    quarter_ = gsl_sf_ellint_Kcomp(k_, GSL_PREC_DOUBLE);
    whole_ = gsl_sf_ellint_Pcomp(k_, nu_, GSL_PREC_DOUBLE);
    phase_ = gsl_sf_ellint_F(std::atan2(sense_ * M[1] / b_, M[0] / a_), k_, GSL_PREC_DOUBLE);
    uniform_ = L_ / I[2];
    periodic_ = L_ * (1 / I[0] - 1 / I[2]) / rate_;
    start_ = third_kind(phase_);
    frame_ = towards_momentum(M);
  }

  /// Momentum and attitude at a time, the attitude at the start being the identity.
  Seven at(double t) const {
    double const u = phase_ + rate_ * t;
    double sn, cn, dn;
    gsl_sf_elljac_e(u, m_, &sn, &cn, &dn);
    std::array<double, 3> const M{a_ * cn, sense_ * b_ * sn, sign_ * c_ * dn};
    double const half = (uniform_ * t + periodic_ * (third_kind(u, sn, cn) - start_)) / 2;
    // The turn from the momentum of the start to the space, the turn about the momentum, and the turn to the
    // body.
    Seven y{0, 0, 0, frame_[0], -frame_[1], -frame_[2], -frame_[3]};
    turn_attitude(y, std::cos(half), 0, 0, std::sin(half));
    auto const to = towards_momentum(M);
    turn_attitude(y, to[0], to[1], to[2], to[3]);
    auto const shown = own(M), axis = own({y[4], y[5], y[6]});
    return {shown[0], shown[1], shown[2], y[3], axis[0], axis[1], axis[2]};
  }

 private:
  static double square(double x) { return x * x; }
  /// Components in the order of axes of the closed form; the same map leads back.
  std::array<double, 3> own(std::array<double, 3> const& v) const {
    return reversed_ ? std::array{v[2], -v[1], v[0]} : v;
  }
  /// A quaternion that takes the direction of the momentum to the third axis: a turn about the third axis,
  /// then one about the first.
  std::array<double, 4> towards_momentum(std::array<double, 3> const& M) const {
    double const psi = std::atan2(M[0], M[1]) / 2, theta = std::atan2(std::hypot(M[0], M[1]), M[2]) / 2;
    double const c = std::cos(theta), s = std::sin(theta), cp = std::cos(psi), sp = std::sin(psi);
    return {c * cp, s * cp, -s * sp, c * sp};
  }
  double third_kind(double u) const {
    double sn, cn, dn;
    gsl_sf_elljac_e(u, m_, &sn, &cn, &dn);
    return third_kind(u, sn, cn);
  }
  /// Pi(am u): that of the part of the amplitude between -pi/2 and pi/2, and half periods.
  double third_kind(double u, double sn, double cn) const {
    double const halves = std::round(u / (2 * quarter_));
    double const rest = std::atan2(cn < 0 ? -sn : sn, std::abs(cn));
    return 2 * halves * whole_ + gsl_sf_ellint_P(rest, k_, nu_, GSL_PREC_DOUBLE);
  }

  bool reversed_ = false;
  double L_, a_, b_, c_, rate_, m_, k_, nu_, sign_, sense_, quarter_, whole_, phase_, uniform_, periodic_,
      start_;
  std::array<double, 4> frame_;
};

/// Each step evaluates the closed form at its time.
inline Method elliptic_functions() {
  return {"closed form, elliptic functions of GSL",
          [](Task const& task, double h) -> std::unique_ptr<Stepper> {
            class Made final : public Stepper {
             public:
              Made(Task const& task, double h) : body_(task), h_(h), y_(task.start()) {}
              void advance(long steps) override {
                for (; steps > 0; --steps) y_ = body_.at(h_ * static_cast<double>(++done_));
              }
              Seven state() const override { return y_; }

             private:
              EllipticBody body_;
              double h_;
              long done_ = 0;
              Seven y_;
            };
            return std::make_unique<Made>(task, h);
          }};
}

}  // namespace peers
