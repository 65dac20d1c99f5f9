// Steps of a body that rolls on a plane: rattle_step.hpp on SE(3), written out in the momentum about the
// contact.
#pragma once

#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "actio/nonholonomic/turn_coefficients.hpp"
#include "actio/numbers/derivative.hpp"

namespace actio {

/// Where a body is.
struct BodyPlace {
  std::array<Triad<double>, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};  ///< of space, seen from the body
  Triad<double> centre{};                                                ///< of mass, in space
};

/// Steps of one length of a body that rolls. For one thread at a time.
///
/// \snippet nonholonomic.cpp rolling_steps
template <class Shape>
class RollingSteps {
 public:
  /// @param h          step, time
  /// @param fractions  of the substeps (composition.hpp); {1} for order 2
  /// @param w          angular velocity, of the body, 1/time
  /// @param u          the normal of the plane, seen from the body, of length 1
  /// @throws NotFinite  where a number is none, or the normal has no point of contact
  RollingSteps(RollingBody<Shape> body, double h, std::vector<double> const& fractions,
               Triad<double> const& w, Triad<double> const& u)
      : body_(std::move(body)), momentum_(body_.momentum(w, u)), normal_(u) {
    double const sum = dot(momentum_, momentum_) + dot(u, u);
    if (!(sum - sum == 0)) throw NotFinite("rolling body: point of contact");
    for (double const fraction : fractions) substeps_.push_back({fraction * h, w, {}, {}});
  }

  /// Reconstructs places from this one on.
  void follow(BodyPlace const& place) { place_ = place; }

  /// A whole step.
  /// @throws NotConverged  where a substep has no solution near by, or turns by a radian or more
  /// @throws NotFinite     where the normal has no point of contact; all is then as it was
  void step();

  Triad<double> const& momentum() const { return momentum_; }  ///< about the contact
  Triad<double> const& normal() const { return normal_; }      ///< of the plane, seen from the body
  /// nothing where it is not followed
  std::optional<BodyPlace> const& place() const { return place_; }
  /// The angular velocity that has the momentum.
  Triad<double> velocity() const { return body_.velocity(momentum_, normal_); }

 private:
  static constexpr int longest_ = 6;
  static constexpr double tolerance_ = 0x1p-98;  // of the square of an update, relative: 8 epsilon
  /// What a step with an angular velocity makes.
  template <class S>
  struct Ends {
    Triad<S> momentum_at_start, momentum, normal, velocity;
  };
  /// Substeps of one length, and their last solutions.
  struct Substep {
    double h;
    Triad<double> w;
    Ends<double> end{};
    std::array<Triad<double>, longest_> past{};
    int known = 0;

    /// Continues the polynomial through the solutions that are known.
    void predict();
    /// Takes the angular velocity as the last solution.
    void remember();
  };
  /// Both ends of a step of length h from here.
  template <class S>
  auto ends(double h, Triad<S> const& w) const -> Ends<S>;
  /// The derivative of the momentum at the start by the angular velocity, by columns.
  std::array<Triad<double>, 3> slope(double h, Triad<double> const& w) const;
  /// Finds the angular velocity from that of the substep on.
  /// @param anew  with the derivative at each point, and updates halved until the residual falls
  /// @param sizes of updates, which are added to it
  /// @return      false where it does not get there
  bool solve(Substep& substep, bool anew, std::vector<double>* sizes = nullptr);
  void advance(Substep& substep);
  void move(double h, Triad<double> const& w, Triad<double> const& v);

  RollingBody<Shape> body_;
  Triad<double> momentum_, normal_;
  std::optional<BodyPlace> place_;
  std::vector<Substep> substeps_;
};

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
