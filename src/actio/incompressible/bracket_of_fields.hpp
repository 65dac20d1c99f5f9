// The Lie algebra of the volume preserving diffeomorphisms (section 8.3 of the thesis).
#pragma once

#include "actio/numbers/derivative.hpp"

namespace actio {

/// The bracket of Jacobi and Lie, \f$[X, Y]^a = X^b\,\partial_bY^a - Y^b\,\partial_bX^a\f$, of two vector
/// fields: again a field, a callable over any scalar.
///
/// The Lie algebra of a group of diffeomorphisms, with composition as product, has minus this bracket.
template <class X, class Y>
auto jacobi_lie_bracket(X const& x, Y const& y) {
  return [x, y]<class S, int n>(Matrix<S, n, 1> const& at) {
    return Matrix<S, n, 1>(derivative_along(y, at, x(at)).rate - derivative_along(x, at, y(at)).rate);
  };
}

/// The bracket of the Lie algebra of a group of diffeomorphisms: \f$-[X, Y]\f$.
///
/// \implements{claim_8_3_lie_algebra_bracket}
template <class X, class Y>
auto diffeomorphism_bracket(X const& x, Y const& y) {
  // [claim_8_3_lie_algebra_bracket]
  return jacobi_lie_bracket(y, x);
  // [claim_8_3_lie_algebra_bracket]
}

}  // namespace actio
