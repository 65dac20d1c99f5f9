// A convex body that rolls on a plane under gravity: the steps of rattle_step.hpp on SE(3), written out.
//
// The plane has the normal u, seen from the body, and touches it at r(u) from the centre of mass. Rolling,
// v + w x r = 0, gives the velocity of the centre of mass, and momenta enter by that about the contact alone,
//
//     K = M - r x P,
//
// since reactions have no moment about it. A step maps (K, u) to (K, u); its unknown is the angular velocity
// w with K of P_0 equal to that at the start. Heights are -r.u, and du/dt = u x w.
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "actio/any_group/chart_step.hpp"
#include "actio/numbers/derivative.hpp"

namespace actio {

/// Three numbers, with what a step does with them.
template <class S>
struct Triad {
  S x{}, y{}, z{};  ///< components

  friend Triad operator+(Triad const& a, Triad const& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Triad operator-(Triad const& a, Triad const& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Triad operator*(S const& c, Triad const& a) { return {c * a.x, c * a.y, c * a.z}; }
  friend S dot(Triad const& a, Triad const& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
  friend Triad cross(Triad const& a, Triad const& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  }
};

/// An ellipsoid, seen from a centre of mass on its third axis: \f$r_i = -a_i^2u_i/S + s\,\delta_{i3}\f$ with
/// \f$S = |(a_1u_1, a_2u_2, a_3u_3)|\f$. With two equal halves and one of zero it is a disc: then no normal
/// may lie along its axis.
struct Ellipsoid {
  std::array<double, 3> half_axes;  ///< lengths
  double centre_above = 0;          ///< the centre of the ellipsoid along the third axis; a length

  /// The point of contact for a normal, which need not have length 1.
  template <class S>
  Triad<S> operator()(Triad<S> const& u) const {
    using std::sqrt;
    S const a = S(half_axes[0]) * u.x, b = S(half_axes[1]) * u.y, c = S(half_axes[2]) * u.z,
            scale = S(-1) / sqrt(a * a + b * b + c * c);
    return {S(half_axes[0]) * a * scale, S(half_axes[1]) * b * scale,
            S(half_axes[2]) * c * scale + S(centre_above)};
  }
};

/// A rigid body with a smooth convex shape.
template <class Shape>
struct RollingBody {
  Shape shape;                    ///< normal, seen from the body -> contact, from the centre of mass
  std::array<double, 6> inertia;  ///< 11, 22, 33, 23, 13, 12 about the centre of mass; mass times length^2
  double mass = 1,                ///< of the body
      gravity = 0;                ///< length/time^2

  /// \f$I\,w\f$.
  template <class S>
  Triad<S> spin_momentum(Triad<S> const& w) const {
    return {S(inertia[0]) * w.x + S(inertia[5]) * w.y + S(inertia[4]) * w.z,
            S(inertia[5]) * w.x + S(inertia[1]) * w.y + S(inertia[3]) * w.z,
            S(inertia[4]) * w.x + S(inertia[3]) * w.y + S(inertia[2]) * w.z};
  }
  /// The momentum about the contact, \f$Iw - m\,r\times(r\times w)\f$.
  Triad<double> momentum(Triad<double> const& w, Triad<double> const& u) const {
    auto const r = shape(u);
    return spin_momentum(w) - mass * cross(r, cross(r, w));
  }
  /// The angular velocity of a momentum about the contact.
  /// @throws Singular  where the body has no inertia about an axis through the contact
  Triad<double> velocity(Triad<double> const& momentum, Triad<double> const& u) const;
  /// Kinetic energy, and \f$m\,g\f$ times the height of the centre of mass.
  double energy(Triad<double> const& w, Triad<double> const& u) const {
    return dot(w, momentum(w, u)) / 2 - mass * gravity * dot(shape(u), u);
  }
};

/// Where a body is.
struct BodyPlace {
  std::array<Triad<double>, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};  ///< of space, seen from the body
  Triad<double> centre{};                                                ///< of mass, in space
};

/// Steps of one length of a body that rolls. For one thread at a time.
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
    void remember();
  };
  template <class S>
  Ends<S> ends(double h, Triad<S> const& w) const;
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

}  // namespace actio

#include "actio/nonholonomic/rolling_body_steps.hpp"
