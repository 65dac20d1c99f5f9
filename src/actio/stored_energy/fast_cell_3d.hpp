// A hexahedral cell of a medium in space: what its twelve edges store, and the slope of that in each of them.
//
// As in the plane (fast_cell_2d.hpp) the stored energy is that at the corners, here eight, where three edges
// meet; over the lengths of the cell they are the columns of F. Per mass density a cell has
//
//     E = (h1 h2 h3/8) sum over the corners of W(F).
//
// Corner k has bit 0 where it is right, bit 1 where it is behind, bit 2 where it is above: the upper end
// along directions 1, 2 and 3. The four edges of a direction are counted by the bits of the other two, lower
// first.
#pragma once

#include "actio/stored_energy/fast_cell_2d.hpp"

namespace actio::media {

namespace detail {

/// A vector in space.
template <class T>
struct Space {
  T x, y, z;
  [[gnu::always_inline]] friend Space operator+(Space const& a, Space const& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  [[gnu::always_inline]] friend Space operator-(Space const& a, Space const& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
};
/// s a.
template <class T>
Space<T> scaled_by(double s, Space<T> const& a) { return {s * a.x, s * a.y, s * a.z}; }
template <class T>
[[gnu::always_inline]] inline Space<T> cross(Space<T> const& a, Space<T> const& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class T>
[[gnu::always_inline]] inline T dot(Space<T> const& a, Space<T> const& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
/// \f$u + s\,a\f$, in place.
template <class T, class S>
[[gnu::always_inline]] inline void add_multiple(Space<T>& u, S const& s, Space<T> const& a) {
  u = {u.x + s * a.x, u.y + s * a.y, u.z + s * a.z};
}
/// \f$u + a\times b\f$, in place.
template <class T>
[[gnu::always_inline]] inline void add_cross(Space<T>& u, Space<T> const& a, Space<T> const& b) {
  u = {(u.x + a.y * b.z) - a.z * b.y, (u.y + a.z * b.x) - a.x * b.z, (u.z + a.x * b.y) - a.y * b.x};
}

/// One vector for each edge of a cell.
template <class T>
struct Edges3d {
  Space<T> first[4], second[4], third[4];
};
/// The edge of a direction that ends at corner k.
template <int k, class T>
[[gnu::always_inline]] inline T& first_at(T (&edges)[4]) { return edges[k >> 1]; }
template <int k, class T>
[[gnu::always_inline]] inline T& second_at(T (&edges)[4]) { return edges[(k & 1) + 2 * (k >> 2)]; }
template <int k, class T>
[[gnu::always_inline]] inline T& third_at(T (&edges)[4]) { return edges[k & 3]; }

/// The edges between eight corners.
template <class T>
[[gnu::always_inline]] inline Edges3d<T> edges_between(Space<T> const (&x)[8]) {
  return {{x[1] - x[0], x[3] - x[2], x[5] - x[4], x[7] - x[6]},
          {x[2] - x[0], x[3] - x[1], x[6] - x[4], x[7] - x[5]},
          {x[4] - x[0], x[5] - x[1], x[6] - x[2], x[7] - x[3]}};
}

/// The corners of a cell: \f$e_2\times e_3\f$, and \f$e_1\cdot(e_2\times e_3) = h_1h_2h_3J\f$.
template <class T>
struct Volumes3d {
  Space<T> face[8];
  T volume[8];
};
template <int k, class T>
[[gnu::always_inline]] inline void put_face(Edges3d<T> const& e, Volumes3d<T>& c) {
  c.face[k] = cross(second_at<k>(e.second), third_at<k>(e.third));
}
template <class T>
[[gnu::always_inline]] inline void put_right_faces(Edges3d<T> const& e, Volumes3d<T>& c) {
  put_face<1>(e, c), put_face<3>(e, c), put_face<5>(e, c), put_face<7>(e, c);
}
template <class T>
[[gnu::always_inline]] inline void put_left_faces(Edges3d<T> const& e, Volumes3d<T>& c) {
  put_face<0>(e, c), put_face<2>(e, c), put_face<4>(e, c), put_face<6>(e, c);
}
/// The volumes, from faces that are there.
template <class T>
[[gnu::always_inline]] inline void put_volumes(Edges3d<T> const& e, Volumes3d<T>& c) {
  c.volume[0] = dot(e.first[0], c.face[0]), c.volume[1] = dot(e.first[0], c.face[1]);
  c.volume[2] = dot(e.first[1], c.face[2]), c.volume[3] = dot(e.first[1], c.face[3]);
  c.volume[4] = dot(e.first[2], c.face[4]), c.volume[5] = dot(e.first[2], c.face[5]);
  c.volume[6] = dot(e.first[3], c.face[6]), c.volume[7] = dot(e.first[3], c.face[7]);
}
/// All of it.
template <class T>
[[gnu::always_inline]] inline Volumes3d<T> volumes_of(Edges3d<T> const& e) {
  Volumes3d<T> c;
  put_left_faces(e, c), put_right_faces(e, c), put_volumes(e, c);
  return c;
}

/// Adds \f$q\,\partial(e_1\cdot e_2\times e_3)\f$ of corner k to the slopes.
template <int k, class T>
[[gnu::always_inline]] inline void add_volume_slope(Edges3d<T> const& e, Volumes3d<T> const& c, T const& q,
                                                    Edges3d<T>& out) {
  Space<T> const& one = first_at<k>(e.first);
  Space<T> const weighted{q * one.x, q * one.y, q * one.z};
  add_multiple(first_at<k>(out.first), q, c.face[k]);
  add_cross(second_at<k>(out.second), third_at<k>(e.third), weighted);
  add_cross(third_at<k>(out.third), weighted, second_at<k>(e.second));
}
/// Those of all corners, each with its own slope of the law.
template <class Law, class T>
[[gnu::always_inline]] inline void add_volume_slopes(Law const& law, Edges3d<T> const& e,
                                                     Volumes3d<T> const& c, Edges3d<T>& out) {
  T const left[4] = {c.volume[0], c.volume[2], c.volume[4], c.volume[6]},
          right[4] = {c.volume[1], c.volume[3], c.volume[5], c.volume[7]};
  T q[4], r[4];
  law.slopes(left, q);
  add_volume_slope<0>(e, c, q[0], out), add_volume_slope<2>(e, c, q[1], out);
  add_volume_slope<4>(e, c, q[2], out), add_volume_slope<6>(e, c, q[3], out);
  law.slopes(right, r);
  add_volume_slope<1>(e, c, r[0], out), add_volume_slope<3>(e, c, r[1], out);
  add_volume_slope<5>(e, c, r[2], out), add_volume_slope<7>(e, c, r[3], out);
}

/// Cells of a fluid of one size.
template <class Scaled>
struct FluidCell3d {
  Scaled volume;  ///< the law at \f$h_1h_2h_3J\f$, with the slope \f$U'/8\f$
  /// Adds the slopes of the energy in the edges.
  template <class T>
  [[gnu::always_inline]] void add_slopes(Edges3d<T> const& e, Volumes3d<T> const& c, Edges3d<T>& out) const {
    add_volume_slopes(volume, e, c, out);
  }
};
/// Cells of a neo-Hookean solid of one size: a fluid whose edges are springs as well.
template <class Scaled>
struct NeoHookeanCell3d {
  Scaled volume;
  double spring[3];  ///< \f$\tfrac\mu4h_1h_2h_3/h_i^2\f$
  /// \copydoc FluidCell3d::add_slopes
  template <class T>
  [[gnu::always_inline]] void add_slopes(Edges3d<T> const& e, Volumes3d<T> const& c, Edges3d<T>& out) const {
    add_springs(spring[0], e.first, out.first);
    add_springs(spring[1], e.second, out.second);
    add_springs(spring[2], e.third, out.third);
    add_volume_slopes(volume, e, c, out);
  }

 private:
  template <class T>
  [[gnu::always_inline]] static void add_springs(double s, Space<T> const (&e)[4], Space<T> (&out)[4]) {
    add_multiple(out[0], T(s), e[0]), add_multiple(out[1], T(s), e[1]);
    add_multiple(out[2], T(s), e[2]), add_multiple(out[3], T(s), e[3]);
  }
};
/// Cells of St Venant and Kirchhoff's solid of one size. The slope in an edge of direction i is
/// \f$(A_i|e_i|^2+\sum_jB_{ij}(|e_j|^2+|e_j'|^2)+C_i)\,e_i+\sum_jD_{ij}((e_i.e_j)\,e_j+(e_i.e_j')\,e_j')\f$
/// with the edges of the other directions j at its two ends.
struct StVenantKirchhoffCell3d {
  double own[3], other[3][3], constant[3];  ///< A, B, C
  double mixed[3];                          ///< D of the pairs (2, 3), (1, 3), (1, 2)
  StVenantKirchhoffCell3d(double lambda, double mu, std::array<double, 3> const& h) {
    double const eighth = h[0] * h[1] * h[2] / 8;
    for (int i = 0; i < 3; ++i) {
      double const weight = eighth / (h[i] * h[i]), a = h[(i + 1) % 3], b = h[(i + 2) % 3];
      own[i] = weight * (lambda + 2 * mu) / (h[i] * h[i]);
      for (int j = 0; j < 3; ++j) other[i][j] = weight * lambda / (2 * h[j] * h[j]);
      constant[i] = -weight * (3 * lambda + 2 * mu);
      mixed[i] = eighth * mu / (a * a * b * b);
    }
  }
  /// \copydoc FluidCell3d::add_slopes
  template <class T>
  [[gnu::always_inline]] void add_slopes(Edges3d<T> const& e, Volumes3d<T> const&, Edges3d<T>& out) const {
    T const a[4] = {square(e.first[0]), square(e.first[1]), square(e.first[2]), square(e.first[3])},
            b[4] = {square(e.second[0]), square(e.second[1]), square(e.second[2]), square(e.second[3])},
            c[4] = {square(e.third[0]), square(e.third[1]), square(e.third[2]), square(e.third[3])};
    // The edges of a direction lie by the bits of the other two: pairs at the ends of an edge, lower first.
    add_own<0>(a, sum(b[0], b[1]), sum(b[2], b[3]), other[0][1], sum(c[0], c[1]), sum(c[2], c[3]),
               other[0][2], e.first, out.first);
    add_own<1>(b, sum(a[0], a[1]), sum(a[2], a[3]), other[1][0], sum(c[0], c[2]), sum(c[1], c[3]),
               other[1][2], e.second, out.second);
    add_own<2>(c, sum(a[0], a[2]), sum(a[1], a[3]), other[2][0], sum(b[0], b[2]), sum(b[1], b[3]),
               other[2][1], e.third, out.third);
    add_mixed<0>(e, out), add_mixed<1>(e, out), add_mixed<2>(e, out), add_mixed<3>(e, out);
    add_mixed<4>(e, out), add_mixed<5>(e, out), add_mixed<6>(e, out), add_mixed<7>(e, out);
  }

 private:
  template <class T>
  [[gnu::always_inline]] static T square(Space<T> const& a) { return dot(a, a); }
  template <class T>
  [[gnu::always_inline]] static T sum(T const& a, T const& b) { return a + b; }
  /// The part along the edges of direction i. In the order of these edges the sums u of one other direction
  /// belong to the bit that i shares with it, and so do the sums v of the other.
  template <int i, class T>
  [[gnu::always_inline]] void add_own(T const (&squares)[4], T const& u0, T const& u1, double of_u,
                                      T const& v0, T const& v1, double of_v, Space<T> const (&e)[4],
                                      Space<T> (&out)[4]) const {
    // Edges 0 to 3 have the bits (0, 0), (1, 0), (0, 1), (1, 1) of the other directions in their order; a sum
    // over an edge of direction j is at the bit of the third one.
    T const p = of_u * u0 + constant[i], q = of_u * u1 + constant[i], r = of_v * v0, s = of_v * v1;
    add_multiple(out[0], T(own[i] * squares[0] + (p + r)), e[0]);
    add_multiple(out[1], T(own[i] * squares[1] + (p + s)), e[1]);
    add_multiple(out[2], T(own[i] * squares[2] + (q + r)), e[2]);
    add_multiple(out[3], T(own[i] * squares[3] + (q + s)), e[3]);
  }
  template <int k, class T>
  [[gnu::always_inline]] void add_mixed(Edges3d<T> const& e, Edges3d<T>& out) const {
    Space<T> const &a = first_at<k>(e.first), &b = second_at<k>(e.second), &c = third_at<k>(e.third);
    T const bc = mixed[0] * dot(b, c), ac = mixed[1] * dot(a, c), ab = mixed[2] * dot(a, b);
    add_multiple(first_at<k>(out.first), ab, b), add_multiple(first_at<k>(out.first), ac, c);
    add_multiple(second_at<k>(out.second), ab, a), add_multiple(second_at<k>(out.second), bc, c);
    add_multiple(third_at<k>(out.third), ac, a), add_multiple(third_at<k>(out.third), bc, b);
  }
};

/// What steps a cell of these lengths.
template <class Volume>
auto cell_on(FastFluid<Volume> const& medium, std::array<double, 3> const& h) {
  auto const law = scaled(medium.volume, h[0] * h[1] * h[2], 0.125);
  return FluidCell3d<std::remove_const_t<decltype(law)>>{law};
}
template <class Volume>
auto cell_on(FastNeoHookean<Volume> const& medium, std::array<double, 3> const& h) {
  double const all = h[0] * h[1] * h[2], quarter = medium.mu / 4 * all;
  auto const law = scaled(medium.volume, all, 0.125);
  return NeoHookeanCell3d<std::remove_const_t<decltype(law)>>{
      law, {quarter / (h[0] * h[0]), quarter / (h[1] * h[1]), quarter / (h[2] * h[2])}};
}
inline StVenantKirchhoffCell3d cell_on(FastStVenantKirchhoff const& medium, std::array<double, 3> const& h) {
  return {medium.lambda, medium.mu, h};
}

/// \f$h_1h_2h_3J\f$ at the corners.
template <class T>
std::array<T, 8> corner_volumes(Edges3d<T> const& e) {
  Volumes3d<T> const c = volumes_of(e);
  return std::to_array(c.volume);
}
/// The forces of a cell on its corners per mass density.
template <class Cell, class T>
std::array<Space<T>, 8> corner_forces(Cell const& cell, Edges3d<T> const& e) {
  Edges3d<T> s{};
  cell.add_slopes(e, volumes_of(e), s);
  std::array<Space<T>, 8> out;
  for (int k = 0; k < 8; ++k) {
    auto const signed_one = [](bool lower, Space<T> const& a) { return lower ? a : Space<T>{} - a; };
    out[static_cast<std::size_t>(k)] = signed_one(!(k & 1), s.first[k >> 1]) +
                                       signed_one(!(k & 2), s.second[(k & 1) + 2 * (k >> 2)]) +
                                       signed_one(!(k & 4), s.third[k & 3]);
  }
  return out;
}
}  // namespace detail
}  // namespace actio::media
