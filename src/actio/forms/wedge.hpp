// The exterior product of a one-form with a form.
#pragma once

#include "actio/forms/forms.hpp"

namespace actio {

/// The differential \f$dx^i\f$ of one coordinate.
inline auto differential_of_coordinate(int i) {
  return [i]<class S, int D>(Matrix<S, D, 1> const&, Tangents<S, D, 1> const& V) -> S { return V(i, 0); };
}

/// The exterior product \f$(\alpha\wedge\omega)(V_0,\dots,V_k) =
/// \sum_i(-1)^i\,\alpha(V_i)\,\omega(V_0,\dots,\widehat{V_i},\dots,V_k)\f$.
/// @param alpha  one-form
/// @param omega  k-form, k = 0 included
template <class Alpha, class Omega>
auto wedge(Alpha const& alpha, Omega const& omega) {
  return [alpha, omega]<class S, int D, int k>(Matrix<S, D, 1> const& at, Tangents<S, D, k> const& V) -> S {
    S sum(0);
    for (int i = 0; i < k; ++i) {
      Tangents<S, D, k - 1> others;
      if constexpr (k > 1)
        for (int c = 0, to = 0; c < k; ++c)
          if (c != i) others.col(to++) = V.col(c);
      S const term = alpha(at, Tangents<S, D, 1>(V.col(i))) * omega(at, others);
      if (i % 2 == 0)
        sum += term;
      else
        sum -= term;
    }
    return sum;
  };
}

}  // namespace actio
