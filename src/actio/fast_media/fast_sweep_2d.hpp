// Steps of a medium in the plane, fused: one pass over the rows of nodes makes several steps in place.
//
// A row of cells adds to the forces on the row of nodes below it, which is then complete, and begins those of
// the row above. So forces are held for one row alone, and the row below moves at once: no cell that comes
// needs its old place. The next step follows one row behind, with a row of forces of its own, and so on: a
// pass over memory makes as many steps as there are levels.
//
// Where a band of rows ends and another one begins, it has copies of as many rows of its neighbour as there
// are levels, and steps them too; what is missing from their forces travels one row a step, and does not
// reach the band. Each row is computed by the same instructions in the same order in every band, so that the
// numbers of threads and of levels make no difference to any bit.
#pragma once

#include "actio/fast_media/fast_box_2d.hpp"

namespace actio::media::detail {

/// A row of nodes.
struct NodeRow2d {
  Plane<Quad>* x;      ///< places
  Plane<Quad>* v;      ///< velocities half a step back
  Plane<double> kick;  ///< time step times response of its nodes, of those at its ends apart
  bool seam = false;   ///< whether a period begins here: as an upper row it is a period further
};

/// A pass of some levels over a band of rows.
template <class Cell>
struct Sweep2d {
  Cell cell;                       ///< the law of the cells
  Strips const& strips;            ///< of each row
  Edges<double> rest;              ///< edges of a cell as good as any, for cells that are not there
  Plane<double> shift;             ///< how far node number `cells` is from node 0 where they are one
  double dt;                       ///< time step
  NodeRow2d const* rows;           ///< the rows from below, copies of the neighbours' included
  int count;                       ///< how many
  int levels;                      ///< steps in this pass
  bool lower_end;                  ///< whether the lowest row is the end of the box
  bool upper_end;                  ///< whether the highest row is
  Plane<Quad>* forces;             ///< room for levels times strips.packs
  Plane<double> lift;              ///< the period across the rows
  Plane<Quad>* lifted;             ///< room for the places of a row
  alignas(32) Quad::Bits signs{};  ///< on return the sign bit is set where a Jacobian was negative

  [[gnu::always_inline]] void operator()() {
    Quad::Bits seen{};
    Cell const law = cell;
    for (int k = 0; k < levels * strips.packs; ++k) forces[k] = {Quad(0), Quad(0)};
    for (int tick = 0; tick < count + levels; ++tick)
      for (int level = 0; level < levels; ++level) {
        int const c = tick - level, from = lower_end ? 0 : level, to = upper_end ? count : count - 1 - level;
        if (c < from || c >= to) continue;
        Plane<Quad>* const force = forces + level * strips.packs;
        if (c < count - 1)
          cell_row(law, rows[c], upper(rows[c + 1]), force, seen);
        else
          last_row(rows[c], force);
      }
    signs |= seen;
  }

 private:
  /// What goes along a row of cells: the edge between the last cell and the next, and the forces of the last
  /// cell on its right ends, above with a minus.
  struct Carry {
    Plane<Quad> low, high, left, below, above;
  };
  /// Forces on the nodes of a register: below and above the cells.
  struct Pair {
    Plane<Quad> below, above;
  };
  /// From a cell with these edges and slopes to the next one. @return the forces on its left ends
  [[gnu::always_inline]] static Pair hand_on(Carry& c, Plane<Quad> const& low, Plane<Quad> const& high,
                                             Edges<Quad> const& e, Edges<Quad> const& f) {
    Pair const out{c.below + (f.below + f.left), (f.above - f.left) - c.above};
    c = {low, high, e.right, f.right - f.below, f.above + f.right};
    return out;
  }
  /// Registers of cells for which the slopes of a law of the area are found ahead: cells do not wait for one
  /// another, and a processor finds more to do at a time than in one cell after the other. Half as many where
  /// the law has two halves, between which they are kept.
  static constexpr int ahead = [] {
    if constexpr (WithVolume<Cell>) return InHalves<decltype(Cell::volume)> ? 8 : 16;
    return 16;
  }();
  /// The slopes of the law at the corners of `count` registers of cells, between nodes from these on.
  [[gnu::always_inline]] static void look_ahead(Cell const& law, Plane<Quad> const* low,
                                                Plane<Quad> const* high, int count, Quad (*q)[4],
                                                Quad::Bits& seen) {
    using Law = std::remove_cvref_t<decltype(law.volume)>;
    Plane<Quad> l = low[0], h = high[0], left = h - l;
    for (int k = 0; k < count; ++k) {
      Plane<Quad> const next_l = low[k + 1], next_h = high[k + 1], right = next_h - next_l;
      Quad d[4];
      areas({next_l - l, next_h - h, left, right}, d);
      note_signs(seen, d);
      if constexpr (InHalves<Law>)
        q[k][0] = d[0], q[k][1] = d[1], q[k][2] = d[2], q[k][3] = d[3];
      else
        law.volume.slopes(d, q[k]);
      l = next_l, h = next_h, left = right;
    }
    if constexpr (InHalves<Law>) slopes_in_place<ahead>(law.volume, q, count);
  }
  /// Passes a cell, with its right ends and the slopes at its corners as given.
  /// @return the forces on its left ends
  [[gnu::always_inline]] static Pair pass_with(Cell const& law, Carry& c, Plane<Quad> const& low,
                                               Plane<Quad> const& high, Quad const (&q)[4]) {
    Edges<Quad> const e{low - c.low, high - c.high, c.left, high - low};
    return hand_on(c, low, high, e, law.slopes_from(e, q));
  }
  /// Passes a cell, with its right ends as given. @return the forces on its left ends
  [[gnu::always_inline]] static Pair pass(Cell const& law, Carry& c, Plane<Quad> const& low,
                                          Plane<Quad> const& high, Quad::Bits& seen) {
    Edges<Quad> const e{low - c.low, high - c.high, c.left, high - low};
    Quad d[4];
    areas(e, d);
    note_signs(seen, d);
    return hand_on(c, low, high, e, law.slopes(e, d));
  }
  [[gnu::always_inline]] static Plane<Quad> chosen(Quad::Bits const& there, Plane<Quad> const& a,
                                                   Plane<double> const& b) {
    return {detail::chosen(there, a.x, b.x), detail::chosen(there, a.y, b.y)};
  }
  [[gnu::always_inline]] static Edges<Quad> chosen(Quad::Bits const& there, Edges<Quad> const& e,
                                                   Edges<double> const& other) {
    return {chosen(there, e.below, other.below), chosen(there, e.above, other.above),
            chosen(there, e.left, other.left), chosen(there, e.right, other.right)};
  }
  /// The same where some of the cells are not there.
  [[gnu::always_inline]] static Pair pass_some(Cell const& law, Quad::Bits const& there,
                                               Edges<double> const& rest, Carry& c, Plane<Quad> const& low,
                                               Plane<Quad> const& high, Quad::Bits& seen) {
    Edges<Quad> const whole{low - c.low, high - c.high, c.left, high - low}, e = chosen(there, whole, rest);
    Quad d[4];
    areas(e, d);
    note_signs(seen, d);
    Edges<Quad> const f = chosen(there, law.slopes(e, d), Edges<double>{});
    Pair const out{c.below + (f.below + f.left), (f.above - f.left) - c.above};
    c = {low, high, whole.right, f.right - f.below, f.above + f.right};
    return out;
  }
  [[gnu::always_inline]] static Plane<Quad> turned_down(Plane<Quad> const& a) {
    return {detail::turned_down(a.x), detail::turned_down(a.y)};
  }
  [[gnu::always_inline]] static Plane<Quad> turned_up(Plane<Quad> const& a) {
    return {detail::turned_up(a.x), detail::turned_up(a.y)};
  }
  /// Kick and drift of register s, at x before.
  [[gnu::always_inline]] static void move(NodeRow2d const& row, int s, Plane<Quad> const& x,
                                          Plane<Quad> const& force, Quad const& kick_x, Quad const& kick_y,
                                          Quad const& step) {
    Plane<Quad> const v{row.v[s].x + kick_x * force.x, row.v[s].y + kick_y * force.y};
    row.v[s] = v;
    row.x[s] = {x.x + step * v.x, x.y + step * v.y};
  }
  /// The same where the ends of the row are among the nodes: t = 0 for register 0, else 1 + s - full.
  [[gnu::always_inline]] void move_end(NodeRow2d const& row, int t, Plane<Quad> const& force) const {
    int const s = t == 0 ? 0 : strips.full + t - 1;
    Plane<Quad> const x = row.x[s];
    move(row, s, x, force, row.kick.x * strips.share[t][0], row.kick.y * strips.share[t][1], dt);
  }
  /// Node number `cells` is node 0 again.
  [[gnu::always_inline]] void close(NodeRow2d const& row) const {
    if (!strips.periodic) return;
    int const s = strips.pack(strips.cells), lane = strips.lane(strips.cells);
    row.x[s].x.lane[lane] = row.x[0].x.lane[0] + shift.x;
    row.x[s].y.lane[lane] = row.x[0].y.lane[0] + shift.y;
    row.v[s].x.lane[lane] = row.v[0].x.lane[0];
    row.v[s].y.lane[lane] = row.v[0].y.lane[0];
  }
  /// Adds in lane 0 of the first register what acts on node number `cells` where this is node 0.
  [[gnu::always_inline]] void fold(Pair& first, Pair const (&tail)[4]) const {
    if (!strips.periodic) return;
    int const s = strips.pack(strips.cells), lane = strips.lane(strips.cells);
    Pair const& ghost = s == 0 ? first : tail[s - strips.full];
    double const of[4] = {ghost.below.x.lane[lane], ghost.below.y.lane[lane], ghost.above.x.lane[lane],
                          ghost.above.y.lane[lane]};
    first.below.x.lane[0] += of[0], first.below.y.lane[0] += of[1];
    first.above.x.lane[0] += of[2], first.above.y.lane[0] += of[3];
  }

  /// The places of a row above cells. A row is moved by a period here and nowhere else, so that what rounding
  /// makes of that does not depend on who steps the row.
  [[gnu::always_inline]] Plane<Quad> const* upper(NodeRow2d const& row) const {
    if (!row.seam) return row.x;
    for (int s = 0; s < strips.packs; ++s) lifted[s] = {row.x[s].x + lift.x, row.x[s].y + lift.y};
    return lifted;
  }
  /// The cells between two rows of nodes; the lower one moves.
  [[gnu::always_inline]] void cell_row(Cell const& law, NodeRow2d const& low, Plane<Quad> const* high,
                                       Plane<Quad>* const force, Quad::Bits& seen) const {
    int const packs = strips.packs, full = strips.full;
    Plane<Quad> const first_low = low.x[0], first_high = high[0];
    Plane<Quad> const none{Quad(0), Quad(0)};
    Carry carry{first_low, first_high, first_high - first_low, none, none};
    Quad const kick_x(low.kick.x), kick_y(low.kick.y), step(dt);
    // Register 0 waits for what comes round from the end of the row.
    Pair first{none, none}, tail[4];
    if (full > 0) first = pass(law, carry, low.x[1], high[1], seen);
    [[maybe_unused]] Quad q[ahead][4];
    for (int begin = 1; begin < full; begin += ahead) {
      int const count = std::min(ahead, full - begin);
      if constexpr (WithVolume<Cell>) look_ahead(law, low.x + begin, high + begin, count, q, seen);
      for (int k = 0; k < count; ++k) {
        int const s = begin + k;
        Plane<Quad> const x = carry.low;
        Pair f;
        if constexpr (WithVolume<Cell>)
          f = pass_with(law, carry, low.x[s + 1], high[s + 1], q[k]);
        else
          f = pass(law, carry, low.x[s + 1], high[s + 1], seen);
        Plane<Quad> const whole = force[s] + f.below;
        force[s] = f.above;
        move(low, s, x, whole, kick_x, kick_y, step);
      }
    }
    for (int s = full; s < packs; ++s) {
      bool const last = s + 1 == packs;
      tail[s - full] =
          pass_some(law, strips.there[s - full], rest, carry, last ? turned_down(first_low) : low.x[s + 1],
                    last ? turned_down(first_high) : high[s + 1], seen);
    }
    // The last strip ends in a cell that is not there, so that lane 0 gets nothing.
    if (full == 0) first = tail[0];
    first = {first.below + turned_up(carry.below), first.above - turned_up(carry.above)};
    fold(first, tail);
    for (int t = 0; t <= packs - full; ++t) {
      int const s = t == 0 ? 0 : full + t - 1;
      if (t == 1 && full == 0) continue;
      Pair const& f = t == 0 ? first : tail[t - 1];
      Plane<Quad> const whole = force[s] + f.below;
      force[s] = f.above;
      move_end(low, t, whole);
    }
    close(low);
  }
  /// The highest row, above which there are no cells.
  [[gnu::always_inline]] void last_row(NodeRow2d const& row, Plane<Quad> const* const force) const {
    Quad const kick_x(row.kick.x), kick_y(row.kick.y), step(dt);
    for (int s = 1; s < strips.full; ++s) {
      Plane<Quad> const x = row.x[s];
      move(row, s, x, force[s], kick_x, kick_y, step);
    }
    for (int t = 0; t <= strips.rest(); ++t)
      if (t != 1 || strips.full > 0) move_end(row, t, force[t == 0 ? 0 : strips.full + t - 1]);
    close(row);
  }
};

/// Looks for cells whose Jacobian is not a positive number, between rows from below.
struct Examination2d {
  Strips const& strips;
  Plane<Quad> const* const* rows;  ///< places
  int count;                       ///< of rows
  alignas(32) Quad::Bits bad{};    ///< on return true in a lane that has found one

  [[gnu::always_inline]] void operator()() {
    Quad::Bits found{};
    for (int j = 0; j + 1 < count; ++j) cell_row(rows[j], rows[j + 1], found);
    bad |= found;
  }

 private:
  [[gnu::always_inline]] void cell_row(Plane<Quad> const* low, Plane<Quad> const* high,
                                       Quad::Bits& found) const {
    Plane<Quad> l = low[0], h = high[0];
    for (int s = 0; s < strips.packs; ++s) {
      Plane<Quad> next_low, next_high;
      if (s + 1 < strips.packs)
        next_low = low[s + 1], next_high = high[s + 1];
      else
        next_low = {turned_down(low[0].x), turned_down(low[0].y)},
        next_high = {turned_down(high[0].x), turned_down(high[0].y)};
      Quad d[4];
      areas({next_low - l, next_high - h, h - l, next_high - next_low}, d);
      Quad::Bits wrong{};
      // An infinite one is none either.
      for (int k = 0; k < 4; ++k) wrong |= ~((d[k].lane > Quad(0).lane) & (d[k].lane < Quad(1e300).lane));
      found |= s < strips.full ? wrong : wrong & strips.there[s - strips.full];
      l = next_low, h = next_high;
    }
  }
};

}  // namespace actio::media::detail
