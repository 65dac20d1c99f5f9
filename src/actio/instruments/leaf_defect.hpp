// How far a map leads away from the symplectic leaf it starts on: on the dual of an algebra, from the
// coadjoint orbit.
//
// Three ways to ask. A family of maps with a step h is judged by the direction in which the image moves with
// h: it must be tangent to the leaf (leaf_defect). A single map on the dual of an algebra is judged by the
// distance of its image from the orbit (orbit_defect). Where Casimir functions are known, by their change
// (casimir_defect).
#pragma once

#include "actio/groups/solve.hpp"
#include "actio/instruments/tangent_of_map.hpp"

namespace actio {

namespace detail {

/// A vector by its part in the span of the columns of a matrix and the rest; `combination` makes the part
/// from the columns.
template <class S>
struct Split {
  AnyVector<S> inside, outside, combination;
};
/// Orthogonal projection by Gram and Schmidt with the longest column first; columns that are rounding of the
/// longest are none.
template <class S>
Split<S> split_by_columns(AnyMatrix<S> q, AnyVector<S> const& w) {
  int const n = static_cast<int>(w.size()), m = static_cast<int>(q.cols());
  AnyMatrix<S> made = AnyMatrix<S>::Identity(m, m);  // each column of q as it stands from those it came from
  Split<S> split{AnyVector<S>::Zero(n), w, AnyVector<S>::Zero(m)};
  auto const dot = [&](auto const& a, auto const& b) {
    S sum(0);
    for (int i = 0; i < n; ++i) sum += a[i] * b[i];
    return sum;
  };
  S longest(0);
  for (int k = 0; k < m; ++k) {
    int pivot = k;
    S best(-1);
    for (int c = k; c < m; ++c)
      if (S const length = length_of(AnyVector<S>(q.col(c))); length > best) best = length, pivot = c;
    if (k == 0) longest = best;
    if (!(best > S(64 * m) * epsilon<S>() * longest)) break;
    q.col(k).swap(q.col(pivot)), made.col(k).swap(made.col(pivot));
    q.col(k) /= best, made.col(k) /= best;
    // Twice is enough: what rounding leaves the first time goes the second.
    for (int twice = 0; twice < 2; ++twice)
      for (int c = k + 1; c < m; ++c) {
        S const along = dot(q.col(k), q.col(c));
        q.col(c) -= along * q.col(k), made.col(c) -= along * made.col(k);
      }
    for (int twice = 0; twice < 2; ++twice) {
      S const along = dot(q.col(k), split.outside);
      split.outside -= along * q.col(k), split.inside += along * q.col(k),
          split.combination += along * made.col(k);
    }
  }
  return split;
}

}  // namespace detail

/// The leaf defect of a family of maps: the part of \f$\frac{d}{dh}\Phi_h(x)\f$ outside the tangent space of
/// the leaf at \f$\Phi_h(x)\f$, over the whole of it.
///
/// The derivative is taken with a dual number for h; the tangent space is the range of the bivector: on the
/// dual of an algebra all \f$\mathrm{ad}^*_\eta\mu\f$. From 0 to 1. No Casimir function is needed, and none
/// is missed. A family that starts with the identity, along which the rank of the bracket is constant,
/// preserves the leaf of x exactly if the defect vanishes at all steps up to h.
///
/// \snippet reduction.cpp leaf_defect
/// @param space   any space of spaces.hpp
/// @param family  (h, point) -> point, at every scalar, both at the same
/// @param h       step, time; not zero
/// @throws NotFinite, OutsideDomain where the step, the point, its image or the derivative is no number, or
///         has the wrong size; where the step is zero Accuracy: a family that preserves leaves gets a few
///         epsilon times the ratio of the largest singular value of the bivector to the smallest that is not
///         zero; 0 where at the rate found the image would move, in the time h, by no more than rounding (64
///         epsilon of itself).
template <class Point, SpaceOf<Point> Space, class Family>
typename Point::Scalar leaf_defect(Space const& space, Family const& family, typename Point::Scalar const& h,
                                   Point const& x) {
  using S = typename Point::Scalar;
  static_assert(Real<S>, "lengths need roots");
  if (!is_finite(h)) throw NotFinite("leaf defect: step");
  if (h == S(0)) throw OutsideDomain("leaf defect", "the step must differ from zero", 0, 0);
  require_point(x, "leaf defect: point");
  Moved<S> time(h);
  time.part[0] = S(1);
  auto const image = family(time, over<Moved<S>>(x));
  require_image(space, x, image, "leaf defect: image or derivative");
  auto const sizes = space.sizes(x);
  detail::AnyVector<Moved<S>> const change = space.change(image);
  detail::AnyVector<S> rate(change.size());
  for (Index i = 0; i < rate.size(); ++i) rate[i] = change[i].part[0] / sizes[i];
  S const whole = detail::length_of(rate);
  // In a time h an image that stands still seems to move by its rounding.
  if (!(whole * magnitude(h) > S(64) * epsilon<S>())) return S(0);
  auto const bivector = detail::over_sizes<S>(space.bivector(value_of(image)), sizes);
  // [leaf_defect]
  auto const split = detail::split_by_columns<S>(bivector, rate);
  return detail::length_of(split.outside) / whole;
  // [leaf_defect]
}

/// The distance of \f$\Phi(\mu)\f$ from the coadjoint orbit of \f$\mu\f$, relative to \f$\mu\f$: for a single
/// map, without Casimir functions.
///
/// \f[ \min_{g\in G}\;|\Phi(\mu) - \mathrm{Ad}^*_g\mu| \f]
/// in components divided by the sizes of \f$\mu\f$ in their units. Found along the orbit from \f$\mu\f$ by
/// the method of Gauss and Newton, and from momenta a turn away where that ends far off.
/// @param map  Momentum -> Momentum, at plain numbers
/// @throws NotFinite, OutsideDomain  where the momentum or its image is no number, or has the wrong size
/// @throws NotConverged              where the iteration does not settle
/// Accuracy: a few epsilon times the condition of \f$\eta\mapsto\mathrm{ad}^*_\eta\mu\f$. Above 1/8 it is an
/// upper bound: the nearest of several points.
template <class Map, ExponentialGroup G, Plain S>
S orbit_defect(Map const& map, Momentum<G, S> const& mu) {
  static_assert(Real<S>, "lengths need roots");
  require_point(mu, "orbit defect: momentum");
  Momentum<G, S> const image = map(mu);
  require_image(LiePoissonPlus{}, mu, image, "orbit defect: image");
  int const n = mu.group.dimension();
  auto const sizes = sizes_by_unit(mu);
  auto const from = [&](Momentum<G, S> nu) {
    std::vector<double> parts;
    double const tolerance = 16 * n * to_double(epsilon<S>());
    for (int iteration = 0; iteration < 200; ++iteration) {
      detail::AnyVector<S> away(n);
      detail::AnyMatrix<S> along(n, n);
      for (int i = 0; i < n; ++i) away[i] = (image.components[i] - nu.components[i]) / sizes[i];
      for (int a = 0; a < n; ++a) {
        auto const column = ad_star(basis_velocity<S>(mu.group, a), nu).components;
        for (int i = 0; i < n; ++i) along(i, a) = column[i] / sizes[i];
      }
      auto const split = detail::split_by_columns<S>(along, away);
      parts.push_back(to_double(detail::length_of(split.inside)));
      double const part = parts.back(), before = parts.size() > 1 ? parts[parts.size() - 2] : HUGE_VAL;
      if (part <= tolerance || (part <= 64 * tolerance && part > before / 2))
        return detail::length_of(split.outside);
      Velocity<G, S> eta{mu.group, split.combination};
      if (double const turn = turning_size(eta); turn > 1) eta = eta / S(turn);
      nu = Ad_star(exp(eta), nu);
    }
    throw NotConverged("orbit defect", parts, tolerance);
  };
  S nearest = from(mu);
  // On the far side of a compact orbit the way from mu may end at a ridge.
  for (int a = 0; a < n && nearest > ratio<S>(1, 8); ++a) {
    S const other = from(Ad_star(exp(basis_velocity<S>(mu.group, a)), mu));
    if (other < nearest) nearest = other;
  }
  return nearest;
}

/// The largest change of some Casimir functions, each relative to how much it changes when the point moves by
/// its own size.
///
/// \f[ \max_k \frac{|C_k(\Phi(x)) - C_k(x)|}{|dC_k(x)|} \f]
/// with the differential in coordinates divided by the sizes of the space: for \f$|\mu|^2\f$ the relative
/// change of \f$|\mu|\f$, to first order.
/// @param map       point -> point, at plain numbers
/// @param casimirs  each point -> scalar, at every scalar
/// @throws NotFinite, OutsideDomain where the point, its image or a Casimir function is no number, or a size
/// is wrong Accuracy: a map that conserves them gets a few epsilon. Where a differential vanishes, relative
/// to the function itself.
template <class Point, SpaceOf<Point> Space, class Map, class... Casimirs>
typename Point::Scalar casimir_defect(Space const& space, Map const& map, Point const& x,
                                      Casimirs const&... casimirs) {
  using S = typename Point::Scalar;
  require_point(x, "Casimir defect: point");
  Point const image = map(x);
  require_image(space, x, image, "Casimir defect: image");
  auto const sizes = space.sizes(x);
  S worst(0);
  auto const judge = [&](auto const& casimir) {
    detail::AnyVector<S> slope(space.dimension(x));
    over_batches(space.dimension(x), [&](int first) {
      Moved<S> const moved = casimir(space.moved(x, sizes, first));
      require_number<S>(moved, "Casimir defect");
      for (int a = 0; a < batch && first + a < slope.size(); ++a) slope[first + a] = moved.part[a];
    });
    S const before = casimir(x), after = casimir(image), change = magnitude(S(after - before));
    if (!is_finite(change)) throw NotFinite("Casimir defect");
    S scale = detail::length_of(slope);
    if (!(scale > S(0))) scale = magnitude(before) > magnitude(after) ? magnitude(before) : magnitude(after);
    if (change > S(0) && S(change / scale) > worst) worst = change / scale;
  };
  (judge(casimirs), ...);
  return worst;
}

}  // namespace actio
