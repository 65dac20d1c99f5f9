// What a row of hexahedral cells shares across it, and the slopes of its cells by that.
//
// Between a cell and the next one of its row there are four nodes, with two edges that go back and two that
// go up: a column. Both cells have these edges, and the slopes in them factorise: of a law of the volume, for
// instance, the slope in an edge that goes up is a sum over the corners of
//
//     (q e1) x e2 + (q' e1') x e2 = (q e1 + q' e1') x e2,
//
// with the edges e1, e1' of the two cells. So what waits for the next cell is q e1 at its right corners, and
// half of the products are spared. Corners of a column are counted by bit 0: behind, bit 1: above.
#pragma once

#include "actio/fast_media/fast_box_3d.hpp"

namespace actio::media::detail {

/// Four nodes across a row.
using FourNodes = Space<Quad>[4];

/// The edges across a row of cells, and \f$e_2\times e_3\f$ at their four corners.
struct Column3d {
  Space<Quad> second[2];  ///< that go back: below, above
  Space<Quad> third[2];   ///< that go up: in front, behind
  Space<Quad> face[4];
};
[[gnu::always_inline]] inline void put_column(FourNodes const& x, Column3d& c) {
  c.second[0] = x[1] - x[0], c.second[1] = x[3] - x[2];
  c.third[0] = x[2] - x[0], c.third[1] = x[3] - x[1];
  c.face[0] = cross(c.second[0], c.third[0]), c.face[1] = cross(c.second[0], c.third[1]);
  c.face[2] = cross(c.second[1], c.third[0]), c.face[3] = cross(c.second[1], c.third[1]);
}
/// The slopes of the cells of a register: in their edges along the row, and in those of the column at their
/// left ends, where they are complete with what the cells on the other side have left.
struct Slopes3d {
  FourNodes first;
  Space<Quad> second[2], third[2];
};
/// x where a cell is there, else zero, whatever x is.
[[gnu::always_inline]] inline Quad where(Quad::Bits const& there, Quad const& x) {
  return Quad(Quad::Bits(reinterpret_cast<Quad::Bits>(x.lane) & there));
}
/// \f$e_1\cdot(e_2\times e_3)\f$ at the corners of one side of the cells.
[[gnu::always_inline]] inline void put_volumes(FourNodes const& first, Column3d const& side,
                                               Quad::Bits const& there, Quad::Bits& seen, Quad (&d)[4]) {
  d[0] = dot(first[0], side.face[0]), d[1] = dot(first[1], side.face[1]);
  d[2] = dot(first[2], side.face[2]), d[3] = dot(first[3], side.face[3]);
  Quad::Bits signs{};
  note_signs(signs, d);
  seen |= signs & there;
}
/// q e.
[[gnu::always_inline]] inline Space<Quad> weighted(Quad const& q, Space<Quad> const& e) {
  return {q * e.x, q * e.y, q * e.z};
}
/// Adds the slopes in the edges of a column of \f$\sum g\cdot(e_2\times e_3)\f$ over its corners.
[[gnu::always_inline]] inline void add_column_slopes(FourNodes const& g, Column3d const& c,
                                                     Space<Quad> (&second)[2], Space<Quad> (&third)[2]) {
  add_cross(second[0], c.third[0], g[0]), add_cross(second[0], c.third[1], g[1]);
  add_cross(second[1], c.third[0], g[2]), add_cross(second[1], c.third[1], g[3]);
  add_cross(third[0], g[0], c.second[0]), add_cross(third[0], g[2], c.second[1]);
  add_cross(third[1], g[1], c.second[0]), add_cross(third[1], g[3], c.second[1]);
}
[[gnu::always_inline]] inline void clear(Space<Quad>& a) { a = {Quad(0), Quad(0), Quad(0)}; }
[[gnu::always_inline]] inline void clear(Space<Quad> (&a)[2]) { clear(a[0]), clear(a[1]); }
[[gnu::always_inline]] inline void clear(FourNodes& a) { clear(a[0]), clear(a[1]), clear(a[2]), clear(a[3]); }

/// How cells of a kind are passed along a row.
///
/// `Column` is what it keeps of a column, `Carry` what a cell leaves for the next one. `pass` adds to cleared
/// slopes those of cells between two columns, `finish` those that the last cell has in the last column.
template <class Cell>
struct AlongRow3d;

/// The part of a law of the volume.
template <class Law>
struct VolumeAlongRow3d {
  Law const& law;

  [[gnu::always_inline]] void pass(FourNodes const& e, Column3d const& left, Column3d const& right,
                                   Quad::Bits const& there, FourNodes& g, Slopes3d& out,
                                   Quad::Bits& seen) const {
    Quad q[4];
    put_slopes(e, left, there, seen, q);
    add_multiple(out.first[0], q[0], left.face[0]), add_multiple(out.first[1], q[1], left.face[1]);
    add_multiple(out.first[2], q[2], left.face[2]), add_multiple(out.first[3], q[3], left.face[3]);
    add_multiple(g[0], q[0], e[0]), add_multiple(g[1], q[1], e[1]);
    add_multiple(g[2], q[2], e[2]), add_multiple(g[3], q[3], e[3]);
    add_column_slopes(g, left, out.second, out.third);
    put_slopes(e, right, there, seen, q);
    add_multiple(out.first[0], q[0], right.face[0]), add_multiple(out.first[1], q[1], right.face[1]);
    add_multiple(out.first[2], q[2], right.face[2]), add_multiple(out.first[3], q[3], right.face[3]);
    g[0] = weighted(q[0], e[0]), g[1] = weighted(q[1], e[1]);
    g[2] = weighted(q[2], e[2]), g[3] = weighted(q[3], e[3]);
  }

 private:
  [[gnu::always_inline]] void put_slopes(FourNodes const& e, Column3d const& side, Quad::Bits const& there,
                                         Quad::Bits& seen, Quad (&q)[4]) const {
    Quad d[4];
    put_volumes(e, side, there, seen, d);
    law.slopes(d, q);
    q[0] = where(there, q[0]), q[1] = where(there, q[1]), q[2] = where(there, q[2]),
    q[3] = where(there, q[3]);
  }
};

/// Fluids.
template <class Scaled>
struct AlongRow3d<FluidCell3d<Scaled>> {
  using Column = Column3d;
  /// \f$q\,e_1\f$ at the right corners of the last cell.
  struct Carry {
    FourNodes weighted;
  };
  FluidCell3d<Scaled> const& cell;

  [[gnu::always_inline]] static void begin(Carry& carry) { clear(carry.weighted); }
  [[gnu::always_inline]] static void prepare(Column&) {}
  [[gnu::always_inline]] void pass(FourNodes const& e, Column const& left, Column const& right,
                                   Quad::Bits const& there, Carry& carry, Slopes3d& out,
                                   Quad::Bits& seen) const {
    VolumeAlongRow3d<Scaled> const volume{cell.volume};
    volume.pass(e, left, right, there, carry.weighted, out, seen);
  }
  [[gnu::always_inline]] static void finish(Column const& last, Carry const& carry, Slopes3d& out) {
    add_column_slopes(carry.weighted, last, out.second, out.third);
  }
};

/// Neo-Hookean solids.
template <class Scaled>
struct AlongRow3d<NeoHookeanCell3d<Scaled>> {
  using Column = Column3d;
  /// The same, and whether the last cell was there: 1 or 0.
  struct Carry {
    FourNodes weighted;
    Quad there;
  };
  NeoHookeanCell3d<Scaled> const& cell;

  [[gnu::always_inline]] static void begin(Carry& carry) { clear(carry.weighted), carry.there = Quad(0); }
  [[gnu::always_inline]] static void prepare(Column&) {}
  [[gnu::always_inline]] void pass(FourNodes const& e, Column const& left, Column const& right,
                                   Quad::Bits const& there, Carry& carry, Slopes3d& out,
                                   Quad::Bits& seen) const {
    Quad const one = where(there, Quad(1)), along = where(there, Quad(cell.spring[0]));
    add_multiple(out.first[0], along, e[0]), add_multiple(out.first[1], along, e[1]);
    add_multiple(out.first[2], along, e[2]), add_multiple(out.first[3], along, e[3]);
    add_springs(carry.there + one, left, out);
    carry.there = one;
    VolumeAlongRow3d<Scaled> const volume{cell.volume};
    volume.pass(e, left, right, there, carry.weighted, out, seen);
  }
  [[gnu::always_inline]] void finish(Column const& last, Carry const& carry, Slopes3d& out) const {
    add_springs(carry.there, last, out);
    add_column_slopes(carry.weighted, last, out.second, out.third);
  }

 private:
  /// The springs across a row, of so many cells.
  [[gnu::always_inline]] void add_springs(Quad const& count, Column const& c, Slopes3d& out) const {
    Quad const back = cell.spring[1] * count, up = cell.spring[2] * count;
    add_multiple(out.second[0], back, c.second[0]), add_multiple(out.second[1], back, c.second[1]);
    add_multiple(out.third[0], up, c.third[0]), add_multiple(out.third[1], up, c.third[1]);
  }
};

/// St Venant and Kirchhoff's solids.
template <>
struct AlongRow3d<StVenantKirchhoffCell3d> {
  /// The column, and what each of its two cells makes of it alone.
  struct Column : Column3d {
    Quad along[4];                     ///< part of the factors of the edges along the row, corner by corner
    Quad second_own[2], third_own[2];  ///< part of the factors of its own edges
    Quad mixed[4];                     ///< \f$D_{23}\,e_2.e_3\f$ at the corners
  };
  /// The slopes of the last cell in the last column by its edges along the row, and the sums of their
  /// squares.
  struct Carry {
    Space<Quad> second[2], third[2];
    Quad second_squares[2], third_squares[2];
    Quad there;  ///< 1 or 0
  };
  StVenantKirchhoffCell3d const& cell;

  [[gnu::always_inline]] static void begin(Carry& carry) {
    clear(carry.second), clear(carry.third);
    carry.second_squares[0] = carry.second_squares[1] = Quad(0);
    carry.third_squares[0] = carry.third_squares[1] = carry.there = Quad(0);
  }
  [[gnu::always_inline]] void prepare(Column& c) const {
    Quad const back[2] = {dot(c.second[0], c.second[0]), dot(c.second[1], c.second[1])},
               up[2] = {dot(c.third[0], c.third[0]), dot(c.third[1], c.third[1])};
    double const half = cell.constant[0] / 2;
    Quad const p = cell.other[0][1] * back[0] + half, q = cell.other[0][1] * back[1] + half,
               r = cell.other[0][2] * up[0], s = cell.other[0][2] * up[1];
    c.along[0] = p + r, c.along[1] = p + s, c.along[2] = q + r, c.along[3] = q + s;
    Quad const ups = cell.other[1][2] * (up[0] + up[1]) + cell.constant[1],
               backs = cell.other[2][1] * (back[0] + back[1]) + cell.constant[2];
    c.second_own[0] = ups + cell.own[1] * back[0], c.second_own[1] = ups + cell.own[1] * back[1];
    c.third_own[0] = backs + cell.own[2] * up[0], c.third_own[1] = backs + cell.own[2] * up[1];
    c.mixed[0] = cell.mixed[0] * dot(c.second[0], c.third[0]);
    c.mixed[1] = cell.mixed[0] * dot(c.second[0], c.third[1]);
    c.mixed[2] = cell.mixed[0] * dot(c.second[1], c.third[0]);
    c.mixed[3] = cell.mixed[0] * dot(c.second[1], c.third[1]);
  }
  [[gnu::always_inline]] void pass(FourNodes const& e, Column const& left, Column const& right,
                                   Quad::Bits const& there, Carry& carry, Slopes3d& out,
                                   Quad::Bits& seen) const {
    Quad d[4];
    put_volumes(e, left, there, seen, d), put_volumes(e, right, there, seen, d);
    Quad const a[4] = {where(there, dot(e[0], e[0])), where(there, dot(e[1], e[1])),
                       where(there, dot(e[2], e[2])), where(there, dot(e[3], e[3]))};
    Quad const one = where(there, Quad(1));
    along<0>(a, e, left, right, there, out), along<1>(a, e, left, right, there, out);
    along<2>(a, e, left, right, there, out), along<3>(a, e, left, right, there, out);
    corner<0>(e, left, there, carry, out), corner<1>(e, left, there, carry, out);
    corner<2>(e, left, there, carry, out), corner<3>(e, left, there, carry, out);
    Quad const sums[4] = {a[0] + a[1], a[2] + a[3], a[0] + a[2], a[1] + a[3]};
    carry.second_squares[0] = carry.second_squares[0] + sums[0];
    carry.second_squares[1] = carry.second_squares[1] + sums[1];
    carry.third_squares[0] = carry.third_squares[0] + sums[2];
    carry.third_squares[1] = carry.third_squares[1] + sums[3];
    carry.there = carry.there + one;
    finish(left, carry, out);
    begin(carry);
    corner<0>(e, right, there, carry, out), corner<1>(e, right, there, carry, out);
    corner<2>(e, right, there, carry, out), corner<3>(e, right, there, carry, out);
    carry.second_squares[0] = sums[0], carry.second_squares[1] = sums[1];
    carry.third_squares[0] = sums[2], carry.third_squares[1] = sums[3], carry.there = one;
  }
  [[gnu::always_inline]] void finish(Column const& c, Carry const& carry, Slopes3d& out) const {
    double const of_second = cell.other[1][0], of_third = cell.other[2][0];
    Quad const s[2] = {carry.there * c.second_own[0] + of_second * carry.second_squares[0],
                       carry.there * c.second_own[1] + of_second * carry.second_squares[1]},
               t[2] = {carry.there * c.third_own[0] + of_third * carry.third_squares[0],
                       carry.there * c.third_own[1] + of_third * carry.third_squares[1]};
    Quad const m[4] = {carry.there * c.mixed[0], carry.there * c.mixed[1], carry.there * c.mixed[2],
                       carry.there * c.mixed[3]};
    out.second[0] = carry.second[0], out.second[1] = carry.second[1];
    out.third[0] = carry.third[0], out.third[1] = carry.third[1];
    add_multiple(out.second[0], s[0], c.second[0]), add_multiple(out.second[1], s[1], c.second[1]);
    add_multiple(out.second[0], m[0], c.third[0]), add_multiple(out.second[0], m[1], c.third[1]);
    add_multiple(out.second[1], m[2], c.third[0]), add_multiple(out.second[1], m[3], c.third[1]);
    add_multiple(out.third[0], t[0], c.third[0]), add_multiple(out.third[1], t[1], c.third[1]);
    add_multiple(out.third[0], m[0], c.second[0]), add_multiple(out.third[0], m[2], c.second[1]);
    add_multiple(out.third[1], m[1], c.second[0]), add_multiple(out.third[1], m[3], c.second[1]);
  }

 private:
  /// The part of the slope in an edge along the row that goes along it.
  template <int i>
  [[gnu::always_inline]] void along(Quad const (&a)[4], FourNodes const& e, Column const& left,
                                    Column const& right, Quad::Bits const& there, Slopes3d& out) const {
    Quad const factor = cell.own[0] * a[i] + (left.along[i] + right.along[i]);
    add_multiple(out.first[i], where(there, factor), e[i]);
  }
  /// What an edge along the row and the column at one of its ends make of each other.
  template <int i>
  [[gnu::always_inline]] void corner(FourNodes const& e, Column const& side, Quad::Bits const& there,
                                     Carry& carry, Slopes3d& out) const {
    Space<Quad> const &back = side.second[i >> 1], &up = side.third[i & 1];
    Quad const to_back = where(there, cell.mixed[2] * dot(e[i], back)),
               to_up = where(there, cell.mixed[1] * dot(e[i], up));
    add_multiple(out.first[i], to_back, back), add_multiple(out.first[i], to_up, up);
    add_multiple(carry.second[i >> 1], to_back, e[i]), add_multiple(carry.third[i & 1], to_up, e[i]);
  }
};

}  // namespace actio::media::detail
