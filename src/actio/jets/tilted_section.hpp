// Tilted sections: maps of a region U into Y that cover an embedding of U into space-time, their action and
// its variation (section 6.2 of the thesis).
//
// Variations that move space-time as well as values turn a section into such a map. Its action is the
// integral of the density over the image of U, and is computed on U itself: the image's jets, and the
// determinant by which the embedding stretches space-time.
#pragma once

#include "actio/jets/action.hpp"
#include "actio/jets/first_variation.hpp"

namespace actio {

/// A map into Y that covers no embedding with the orientation of space-time.
struct NotAnEmbedding : OutsideDomain {
  using OutsideDomain::OutsideDomain;
};

/// The jet of the section that a tilted section makes, and how much it stretches space-time there.
template <class S, int n, int N>
struct TiltedJet {
  Jet<S, n, N> jet;  ///< of \f$\varphi\circ\varphi_X^{-1}\f$
  S stretch;         ///< \f$\det D\varphi_X\f$
};

/// The first jet of \f$\varphi\circ\varphi_X^{-1}\f$ at the image of a point u:
/// \f$v = D\varphi_Y\,(D\varphi_X)^{-1}\f$.
///
/// @param map  tilted section: a callable from points u to (x, y), one column, over any scalar
/// @throws NotAnEmbedding  where the determinant of \f$D\varphi_X\f$ is not positive; over a field without
///         order that is left out
template <class S, int rows, class Map>
auto tilted_jet(Map const& map, Matrix<S, rows, 1> const& u) {
  constexpr int n = rows - 1;
  auto const [image, D_map] = derivative(map, u);
  constexpr int N = std::remove_cvref_t<decltype(image)>::RowsAtCompileTime - rows;
  Matrix<S, rows, rows> const DX = D_map.template topRows<rows>();
  TiltedJet<S, n, N> tilted{{image.template head<rows>(), image.template tail<N>(), {}}, determinant(DX)};
  if (ordered_arithmetic<S>() && !(base_value(tilted.stretch) > Base<S>(0)))
    throw NotAnEmbedding("tilted_jet at u = " + show(u),
                         "a tilted section covers an embedding that preserves the orientation; determinant",
                         to_double(tilted.stretch), 0);
  tilted.jet.v = D_map.template bottomRows<N>() * inverse_matrix(DX, "tilted_jet");
  return tilted;
}

/// The action \f$S(\varphi) = \int_{U_X}\mathcal L(j^1(\varphi\circ\varphi_X^{-1}))\f$ of a tilted section on
/// a box U, pulled back to U.
/// @param degree  of the pulled-back density in each coordinate, with which the integral is exact
template <class S, int n, class L, class Map>
S tilted_action(L const& density, Map const& map, Box<S, n> const& box, int degree) {
  return integral(
      [&](Event<S, n> const& u) {
        auto const tilted = tilted_jet(map, u);
        return S(density(tilted.jet) * tilted.stretch);
      },
      box.low, box.high, degree);
}

/// The rate of the density under a variation of a section, pulled back:
/// \f$\frac{d}{d\epsilon}\,L(j^1\varphi^\epsilon)\,\det D\varphi^\epsilon_X\f$ at x.
///
/// @param V  variation: a callable from points (x, y) of Y, one column, to \f$(V^\mu, V^a)\f$, over any
///           scalar
/// @throws whatever the density refuses
template <class S, int rows, class L, class Phi, class Field>
S density_variation(L const& density, Phi const& phi, Field const& V, Matrix<S, rows, 1> const& x) {
  constexpr int n = rows - 1, N = detail::fibre_dimension<Phi, S, n>;
  examine(density, first_jet(phi, x));
  auto const varied = [&]<class E>(E const& epsilon) -> E {
    auto const flowed = [&]<class T>(Matrix<T, rows, 1> const& u) -> Variation<T, n, N> {
      Variation<T, n, N> point;
      point << u, phi(u);
      return point + V(point) * T(epsilon);
    };
    auto const tilted = tilted_jet(flowed, x.template cast<E>());
    return density(tilted.jet) * tilted.stretch;
  };
  return derivative(varied, S(0)).rate;
}

/// The derivative \f$dS(\phi)\cdot V\f$ of the action on a box along any variation, the horizontal ones
/// included: the box moves with it.
///
/// \implements{thm_6_2_1}
/// @param V       variation: a callable from points (x, y) of Y, one column, to \f$(V^\mu, V^a)\f$, over any
///                scalar
/// @param degree  of the varied density in each coordinate, with which the integral is exact
template <class S, int n, class L, class Phi, class Field>
S action_variation(L const& density, Phi const& phi, Field const& V, Box<S, n> const& box, int degree) {
  return integral([&](Event<S, n> const& x) { return density_variation(density, phi, V, x); }, box.low,
                  box.high, degree);
}

}  // namespace actio
