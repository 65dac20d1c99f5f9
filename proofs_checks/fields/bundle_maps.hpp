// Automorphisms of Y that cover diffeomorphisms of X, with their inverses written out: changes of bundle
// charts, and what acts on sections.
#pragma once

#include "fields/variations.hpp"

namespace actio::checks {

/// Each coordinate of Y goes to a multiple of itself and a polynomial of second degree in those before it,
/// space-time first: polynomial both ways. With `tilt` the time depends on the first place as well, and the
/// map covers none of space-time.
template <class S, int n, int N>
struct BundleMap {
  static constexpr int all = n + 1 + N;
  Matrix<S, all, 1> scale;
  std::array<Cubic<S, all>, all> added;
  S tilt{0};

  explicit BundleMap(Draw& draw) {
    for (int i = 0; i < all; ++i) scale[i] = S(1) + draw.number<S>() * ratio<S>(1, 4);
    for (auto& c : added) c = cut(draw_cubic<S, all>(draw, ratio<S>(1, 3)), 2);
  }
  template <class V>
  auto operator()(V const& point) const {
    using T = ScalarOf<V>;
    Matrix<T, all, 1> image, before = Matrix<T, all, 1>::Zero();
    for (int i = 0; i < all; ++i) {
      image[i] = point[i] * T(scale[i]) + added[i](before);
      before[i] = point[i];
    }
    image[0] += point[n + 1] * T(tilt);
    return image;
  }
  /// The inverse of the map without tilt.
  template <class V>
  auto inverse(V const& image) const {
    using T = ScalarOf<V>;
    Matrix<T, all, 1> point = Matrix<T, all, 1>::Zero();
    for (int i = 0; i < all; ++i) point[i] = (image[i] - added[i](point)) / T(scale[i]);
    return point;
  }
  /// The diffeomorphism of space-time that is covered, and its inverse.
  template <class T>
  Event<T, n> on_base(Event<T, n> const& x) const { return (*this)(over(x)).template head<n + 1>(); }
  template <class T>
  Event<T, n> on_base_inverse(Event<T, n> const& x) const { return inverse(over(x)).template head<n + 1>(); }
  /// The section \f$\eta_Y\circ\phi\circ\eta_X^{-1}\f$, as a map into Y.
  template <class Phi>
  auto graph_of_moved(Phi const& phi) const {
    return [this, phi]<class T>(Event<T, n> const& x) {
      Event<T, n> const there = on_base_inverse(x);
      Matrix<T, all, 1> point;
      point << there, phi(there);
      return Matrix<T, all, 1>((*this)(point));
    };
  }
  /// The same section by its places.
  template <class Phi>
  auto moved(Phi const& phi) const {
    return [graph = graph_of_moved(phi)]<class T>(Event<T, n> const& x) {
      return Matrix<T, N, 1>(graph(x).template tail<N>());
    };
  }

 private:
  template <class T>
  static Matrix<T, all, 1> over(Event<T, n> const& x) {
    Matrix<T, all, 1> point = Matrix<T, all, 1>::Zero();
    point.template head<n + 1>() = x;
    return point;
  }
};

}  // namespace actio::checks
