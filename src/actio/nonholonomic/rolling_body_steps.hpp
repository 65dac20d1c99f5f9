// The steps of a body that rolls: what rolling_body.hpp declares.
#pragma once

#include <tuple>

#include "actio/linear_algebra/linear.hpp"
#include "actio/nonholonomic/rolling_body.hpp"

namespace actio {

namespace detail {

/// The coefficients of a step that turns by \f$\theta\f$, as functions of \f$s = \theta^2 < 1\f$.
template <class S>
struct TurnCoefficients {
  S sine,      ///< \f$\sin(\theta/2)/(\theta/2)\f$
      cosine,  ///< \f$(1 - \cos(\theta/2))/(\theta/2)^2\f$
      third,   ///< \f$(1 - \mathrm{sine})/(\theta/2)^2\f$
      chi,     ///< of \f$\hat x^2\f$ in \f$\chi(\hat x)\f$
      slope;   ///< twice its derivative by s

  explicit TurnCoefficients(S const& s) {
    S const q = s / S(-4);
    sine = S(sines_.back()), cosine = S(cosines_.back());
    for (std::size_t k = sines_.size() - 1; k-- > 0;) {
      third = sine;
      sine = sine * q + S(sines_[k]), cosine = cosine * q + S(cosines_[k]);
    }
    // Terms fall by s/(4 pi^2).
    auto const& beta = systems::detail::coefficients_of_chi();
    std::size_t k = base_value(s) < 1.0 / 64 ? 5 : 12;
    chi = S(std::abs(beta[k])), slope = S(0);
    while (--k > 0) slope = slope * s + chi, chi = chi * s + S(std::abs(beta[k]));
    slope = S(2) * slope;
  }

  /// A vector of space, seen from the body, half a step later: \f$e^{-\hat x/2}u\f$.
  /// @param half  \f$x/2\f$
  Triad<S> turned(Triad<S> const& half, Triad<S> const& u) const {
    Triad<S> const once = cross(half, u);
    return u - sine * once + cosine * cross(half, once);
  }
  /// \f$\int_0^1e^{\tau\hat x}d\tau\,y\f$: how far a body goes, seen from it at the start.
  Triad<S> moved(Triad<S> const& half, Triad<S> const& y) const {
    Triad<S> const once = cross(half, y), first = y + cosine * once + third * cross(half, once);
    return S(0.5) * (first + turned(S(-1) * half, first));
  }

 private:
  static constexpr std::array<double, 8> sines_{
      1, 1.0 / 6, 1.0 / 120, 1.0 / 5040, 1.0 / 362880, 1.0 / 39916800, 1.0 / 6227020800, 1.0 / 1307674368000},
      cosines_{1.0 / 2,       1.0 / 24,        1.0 / 720,         1.0 / 40320,
               1.0 / 3628800, 1.0 / 479001600, 1.0 / 87178291200, 1.0 / 20922789888000};
};

/// The solution of three equations.
inline Triad<double> solve_three(std::array<Triad<double>, 3> const& columns, Triad<double> const& right,
                                 char const* where) {
  auto const& [c0, c1, c2] = columns;
  Triad<double> const n = cross(c1, c2);
  if (double const sum = dot(c0, n) + dot(right, right); !(sum - sum == 0))
    throw NotFinite(std::string(where) + ": point of contact");
  double const determinant = dot(c0, n), size = std::sqrt(dot(c0, c0) * dot(c1, c1) * dot(c2, c2));
  if (!(std::abs(determinant) > 0x1p-40 * size))
    throw Singular(where,
                   "an inertia about each axis through the contact is needed; determinant over lengths",
                   size > 0 ? std::abs(determinant) / size : 0, 0x1p-40);
  return {dot(right, n) / determinant, dot(c0, cross(right, c2)) / determinant,
          dot(c0, cross(c1, right)) / determinant};
}

}  // namespace detail

template <class Shape>
Triad<double> RollingBody<Shape>::velocity(Triad<double> const& k, Triad<double> const& u) const {
  return detail::solve_three({momentum({1, 0, 0}, u), momentum({0, 1, 0}, u), momentum({0, 0, 1}, u)}, k,
                             "rolling body");
}

template <class Shape>
void RollingSteps<Shape>::Substep::predict() {
  if (known == 0) return;
  Triad<double> sum;
  double weight = known;  // binomial coefficients with changing signs
  for (int k = 0; k < known; ++k) {
    sum = sum + weight * past[static_cast<std::size_t>(k)];
    weight *= -static_cast<double>(known - k - 1) / (k + 2);
  }
  w = sum;
}

template <class Shape>
void RollingSteps<Shape>::Substep::remember() {
  for (std::size_t k = longest_ - 1; k > 0; --k) past[k] = past[k - 1];
  past[0] = w;
  known = std::min(known + 1, longest_);
}

template <class Shape>
template <class S>
auto RollingSteps<Shape>::ends(double h, Triad<S> const& w) const -> Ends<S> {
  Triad<S> const u0{S(normal_.x), S(normal_.y), S(normal_.z)}, x = S(h) * w, half = S(h / 2) * w;
  detail::TurnCoefficients<S> const c(dot(x, x));
  auto const turned = [&](Triad<S> const& u) { return c.turned(half, u); };
  Triad<S> const middle = turned(u0), u1 = turned(middle), r0 = body_.shape(u0), r1 = body_.shape(u1);
  Triad<S> const v = cross(body_.shape(middle), w), y = S(h) * v, linear = S(body_.mass) * v,
                 spin = body_.spin_momentum(w);
  // Momenta at the ends: even parts, and half of the odd ones to either side.
  Triad<S> const once = cross(x, linear), twice = cross(x, once), spin_once = cross(x, spin);
  Triad<S> const force = linear + c.chi * twice, odd_force = S(0.5) * once;
  Triad<S> const torque =
                     spin + c.chi * (cross(x, spin_once) + cross(y, once)) + (c.slope * dot(x, y)) * twice,
                 odd_torque = S(0.5) * spin_once;
  S const weight = S(body_.mass * body_.gravity * h / 2);
  Triad<S> const start = torque + odd_torque + weight * cross(u0, r0) - cross(r0, force + odd_force),
                 end = torque - odd_torque - weight * cross(u1, r1) - cross(r1, force - odd_force);
  return {start, end, u1, v};
}

template <class Shape>
auto RollingSteps<Shape>::slope(double h, Triad<double> const& w) const -> std::array<Triad<double>, 3> {
  using D = Moved<double>;
  Triad<D> moved{D(w.x), D(w.y), D(w.z)};
  moved.x.part[0] = moved.y.part[1] = moved.z.part[2] = 1;
  auto const k = ends(h, moved).momentum_at_start;
  return {{{k.x.part[0], k.y.part[0], k.z.part[0]},
           {k.x.part[1], k.y.part[1], k.z.part[1]},
           {k.x.part[2], k.y.part[2], k.z.part[2]}}};
}

template <class Shape>
bool RollingSteps<Shape>::solve(Substep& substep, bool anew, std::vector<double>* sizes) {
  auto& w = substep.w;
  std::array<Triad<double>, 3> columns;
  double before = HUGE_VAL, fraction = 1;
  Triad<double> from, update;
  for (int iteration = 0; iteration < 60; ++iteration) {
    auto const at = ends(substep.h, w);
    Triad<double> const rest = at.momentum_at_start - momentum_;
    double const missed = dot(rest, rest);
    if (anew && iteration > 0 && !(missed < before) && fraction > 1e-6) {
      fraction /= 2, w = from - fraction * update;
      continue;
    }
    // The derivative is found anew where the last one is of no more use.
    if (anew || iteration == 0 || missed > before / 256) columns = slope(substep.h, w);
    update = detail::solve_three(columns, rest, "rolling body");
    double const size = dot(update, update) / dot(w, w);
    if (sizes) sizes->push_back(std::sqrt(size));
    if (size <= tolerance_ || missed == 0) {
      substep.end = at;
      // What the last residual leaves of the momentum turns with the plane.
      substep.end.momentum = at.momentum - rest + substep.h * cross(w, rest);
      return true;
    }
    from = w, before = missed, fraction = 1;
    w = w - update;
    if (!(substep.h * substep.h * dot(w, w) < 1) || (!anew && iteration > 12)) return false;
  }
  return false;
}

template <class Shape>
void RollingSteps<Shape>::advance(Substep& substep) {
  substep.predict();
  if (substep.known == 0 || !solve(substep, false)) {
    substep.w = velocity();
    std::vector<double> sizes;
    if (!solve(substep, true, &sizes)) throw NotConverged("rolling body", sizes, std::sqrt(tolerance_));
  }
  if (place_) move(substep.h, substep.w, substep.end.velocity);
  momentum_ = substep.end.momentum, normal_ = substep.end.normal;
  substep.remember();
}

template <class Shape>
void RollingSteps<Shape>::move(double h, Triad<double> const& w, Triad<double> const& v) {
  auto const half = (h / 2) * w;
  detail::TurnCoefficients<double> const c(4 * dot(half, half));
  auto const way = c.moved(half, h * v);
  auto& [axes, centre] = *place_;
  centre = centre + Triad<double>{dot(axes[0], way), dot(axes[1], way), dot(axes[2], way)};
  for (auto& axis : axes) axis = c.turned(half, c.turned(half, axis));
}

template <class Shape>
void RollingSteps<Shape>::step() {
  auto const before = std::tuple(momentum_, normal_, place_);
  try {
    for (auto& substep : substeps_) advance(substep);
  } catch (...) {
    std::tie(momentum_, normal_, place_) = before;
    throw;
  }
}

}  // namespace actio
