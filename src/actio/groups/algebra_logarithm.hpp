// The principal logarithm of a matrix of a group, refused where it is not in the algebra of the group.
//
// The projection `vee` would turn any matrix into coordinates. A matrix that is not in the group must not get
// any; nor must an element of SU(3) whose angles add up to a whole turn, for then the principal logarithm has
// a trace.
#pragma once

#include "actio/groups/matrix_group.hpp"

namespace actio {

/// v with \f$e^{\hat v} = a\f$, \f$\hat v\f$ being the principal logarithm of a.
///
/// @param a  a matrix of the group, up to rounding that has piled up to half the digits of double
/// @throws OutsideDomain  where a has an eigenvalue on the negative axis or next to it, and where its
///                        logarithm leaves the algebra: the distance, by the largest row, relative to that of
///                        the logarithm or to 1
template <class G, Real S>
Coordinates<G, S> logarithm_in_algebra(G const& group, Storage<G, S> const& a) {
  if constexpr (is_dual<S>) {
    return primitive::lifted_log(group, a);
  } else {
    Storage<G, S> const m = matrix_logarithm(a);
    Coordinates<G, S> const v = group.vee(m);
    double const outside = row_norm(Storage<G, S>(group.hat(v) - m)) / (1 + row_norm(m)), bound = 1e-8;
    if (!(outside <= bound))
      throw OutsideDomain("log",
                          "the principal logarithm must lie in the algebra of the group (3.19); distance",
                          outside, bound);
    return v;
  }
}

}  // namespace actio
