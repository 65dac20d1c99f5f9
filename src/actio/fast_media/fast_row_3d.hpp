// A row of hexahedral cells, between four rows of nodes: the forces of its cells on them.
//
// Register by register along the row, as in the plane (fast_sweep_2d.hpp): what a cell leaves for the next
// one goes along, and what comes round at the end of the strips is added to the first register in the end.
#pragma once

#include "actio/fast_media/fast_column_3d.hpp"

namespace actio::media::detail {

/// The places of four rows of nodes: bit 0 of the index says behind, bit 1 above.
struct FourRows {
  Space<Quad> const* row[4];
};

[[gnu::always_inline]] inline Space<Quad> turned_down(Space<Quad> const& a) {
  return {turned_down(a.x), turned_down(a.y), turned_down(a.z)};
}
[[gnu::always_inline]] inline Space<Quad> turned_up(Space<Quad> const& a) {
  return {turned_up(a.x), turned_up(a.y), turned_up(a.z)};
}
/// The nodes at register s of four rows.
[[gnu::always_inline]] inline void put_nodes(FourRows const& x, int s, FourNodes& out) {
  out[0] = x.row[0][s], out[1] = x.row[1][s], out[2] = x.row[2][s], out[3] = x.row[3][s];
}
/// Those beyond the last register: the first ones, in the next strip.
[[gnu::always_inline]] inline void put_turned(FourRows const& x, FourNodes& out) {
  out[0] = turned_down(x.row[0][0]), out[1] = turned_down(x.row[1][0]);
  out[2] = turned_down(x.row[2][0]), out[3] = turned_down(x.row[3][0]);
}

/// Rows of forces at a row of cells.
struct RowForces3d {
  Space<Quad>* whole;  ///< gets all that acts on the row in front and below
  /// has what the cells of the layer below do to that row, gets that for the layer above
  Space<Quad>* above;
  Space<Quad>* behind;  ///< has what the cells in front do to it, gets that for the row behind
  /// has what the cells in front do to the row above, gets that for the row behind
  Space<Quad>* above_behind;
};

/// A row of cells of one kind.
template <class Cell>
struct CellRow3d {
  using Along = AlongRow3d<Cell>;
  using Column = typename Along::Column;
  using Carry = typename Along::Carry;
  Along along;
  Strips const& strips;

  /// Adds the forces of the cells between four rows of nodes.
  [[gnu::always_inline]] void operator()(FourRows const& x, RowForces3d const& force,
                                         Quad::Bits& seen) const {
    int const packs = strips.packs, full = strips.full;
    // Of two columns each is left of one cell and right of the next.
    Column columns[2];
    FourNodes nodes;
    put_nodes(x, 0, nodes);
    put_column(nodes, columns[0]), along.prepare(columns[0]);
    Carry carry;
    Along::begin(carry);
    FourNodes before;  // slopes in the edges along the row that end at the present nodes
    clear(before);
    Quad::Bits const all = ~Quad::Bits{};
    for (int s = 0; s < packs; ++s) {
      if (s + 1 < packs)
        put_nodes(x, s + 1, nodes);
      else
        put_turned(x, nodes);
      Quad::Bits const& there = s < full ? all : strips.there[s - full];
      cell(x, s, nodes, columns[s & 1], columns[~s & 1], there, carry, before, force, seen);
    }
    // The last strip ends in a cell that is not there, so that lane 0 gets nothing.
    Slopes3d end;
    clear(end.first), clear(end.second), clear(end.third);
    along.finish(columns[packs & 1], carry, end);
    FourNodes f;
    put_forces(end, before, f);
    force.whole[0] = force.whole[0] + turned_up(f[0]);
    force.behind[0] = force.behind[0] + turned_up(f[1]);
    force.above[0] = force.above[0] + turned_up(f[2]);
    force.above_behind[0] = force.above_behind[0] + turned_up(f[3]);
  }

 private:
  /// Passes the cells between two columns, the right one at these nodes.
  [[gnu::always_inline]] void cell(FourRows const& x, int s, FourNodes const& nodes, Column const& left,
                                   Column& right, Quad::Bits const& there, Carry& carry, FourNodes& before,
                                   RowForces3d const& force, Quad::Bits& seen) const {
    put_column(nodes, right), along.prepare(right);
    FourNodes const first{nodes[0] - x.row[0][s], nodes[1] - x.row[1][s], nodes[2] - x.row[2][s],
                          nodes[3] - x.row[3][s]};
    Slopes3d slopes;
    clear(slopes.first), clear(slopes.second), clear(slopes.third);
    along.pass(first, left, right, there, carry, slopes, seen);
    FourNodes f;
    put_forces(slopes, before, f);
    force.whole[s] = (force.above[s] + force.behind[s]) + f[0];
    force.above[s] = force.above_behind[s] + f[2];
    force.behind[s] = f[1], force.above_behind[s] = f[3];
    before[0] = slopes.first[0], before[1] = slopes.first[1];
    before[2] = slopes.first[2], before[3] = slopes.first[3];
  }
  /// The forces on nodes across the row, from the slopes in the edges that begin there and end there.
  [[gnu::always_inline]] static void put_forces(Slopes3d const& f, FourNodes const& before, FourNodes& out) {
    out[0] = ((f.first[0] - before[0]) + f.second[0]) + f.third[0];
    out[1] = ((f.first[1] - before[1]) - f.second[0]) + f.third[1];
    out[2] = ((f.first[2] - before[2]) + f.second[1]) - f.third[0];
    out[3] = ((f.first[3] - before[3]) - f.second[1]) - f.third[1];
  }
};

}  // namespace actio::media::detail
