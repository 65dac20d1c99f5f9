// A free body on its way under the Moser-Veselov scheme: attitude and body momentum, step by step.
#pragma once

#include "actio/rigid_body/moser_veselov.hpp"

namespace actio {

/// A free body on its way: attitude, body momentum, and the relative motion of the last step, which is where
/// the solver looks first.
template <int n, Real S = double>
struct BodyInMotion {
  Element<SO<n>, S> attitude;        ///< body to space
  Momentum<SO<n>, S> body_momentum;  ///< energy x time
  Element<SO<n>, S> last;            ///< the relative motion of the last step

  /// The momentum in space: \f$\mathrm{Ad}^*_{g^{-1}}\,\Pi\f$, as the matrix \f$gMg^T\f$ in coordinates.
  /// Constant along the motion.
  Momentum<SO<n>, S> spatial_momentum() const {
    return {attitude.group,
            attitude.group.vee(
                (attitude.value * attitude.group.hat(body_momentum.components) * attitude.value.transpose())
                    .eval())};
  }
};

/// One step: relative motion from momentum, momentum transported, attitude reconstructed.
template <int n, Real S>
void advance(MoserVeselov<n, S> const& scheme, BodyInMotion<n, S>& body) {
  body.last = scheme.relative_motion(body.body_momentum, body.last).value;
  body.body_momentum = scheme.transport_by_increment(body.last, body.body_momentum);
  body.attitude = scheme.reconstruct(body.attitude, body.last);
}

/// A body that starts with attitude g and body velocity xi.
template <int n, Real S>
BodyInMotion<n, S> release(Inertia<n, S> const& inertia, Element<SO<n>, S> const& g,
                           Velocity<SO<n>, S> const& xi) {
  return {g, body_momentum(inertia, xi), identity<S>(inertia.group)};
}

}  // namespace actio
