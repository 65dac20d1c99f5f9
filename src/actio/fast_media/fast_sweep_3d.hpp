// A step of a medium in space, fused: one pass over the planes of nodes moves them in place.
//
// A layer of cells between two planes of nodes goes row by row. After a row of cells the row of nodes in
// front and below is complete: it has the forces of the layer below, which one rolling plane holds, of the
// row of cells in front, and of this one. It moves at once, since no cell that comes needs its old place.
// Where the rows are periodic, the first one waits for the last row of cells.
//
// A band of planes that one thread steps begins with the layer of cells below it, for the forces of that, and
// moves nothing there. Each layer is computed by the same instructions in the same order in every band, so
// that the number of threads makes no difference to any bit.
#pragma once

#include "actio/fast_media/fast_row_3d.hpp"

namespace actio::media::detail {

/// A layer of cells, and the plane of nodes below it.
struct Layer3d {
  Space<Quad>* low;         ///< places in the first row of the plane below, in front of their velocities
  Space<Quad> const* high;  ///< places in the first row of the plane above; null where there are no cells
  std::size_t low_stride;   ///< from row to row
  std::size_t high_stride;  ///< the same above
  bool moves;               ///< whether the plane below moves
  Space<double> kick;       ///< time step times response of its nodes, of those at its borders apart
};
/// Rows of registers that a pass needs.
struct Room3d {
  /// forces, a row for each row of nodes
  Space<Quad>* plane;
  Space<Quad>*whole, *first, *behind, *above_behind, *lifted, *lifted_above;  ///< a row each
};

/// A step of a band of planes.
template <class Cell>
struct Sweep3d {
  Cell cell;                        ///< the law of the cells
  Strips const& strips;             ///< of each row
  double dt;                        ///< time step
  Layer3d const* layers;            ///< from below
  int count;                        ///< how many
  int rows;                         ///< of nodes in a plane
  bool round;                       ///< whether the rows are periodic
  Space<double> const* row_shares;  ///< response of the rows over that of the plane
  Space<double> shift[2];           ///< the periods along the rows and across
  Room3d room;
  alignas(32) Quad::Bits signs{};  ///< on return the sign bit is set where a Jacobian was negative

  using Vector = Space<Quad>;

  [[gnu::always_inline]] void operator()() {
    Quad::Bits seen{};
    Cell const law = cell;
    CellRow3d<Cell> const cells{{law}, strips};
    clear(room.plane, rows * strips.packs);
    for (int k = 0; k < count; ++k) {
      if (layers[k].high)
        layer(cells, layers[k], seen);
      else
        for (int j = 0; j < rows; ++j) move(layers[k], j, force_row(j));
    }
    signs |= seen;
  }

 private:
  [[gnu::always_inline]] static void clear(Vector* row, int count) {
    for (int s = 0; s < count; ++s) row[s] = {Quad(0), Quad(0), Quad(0)};
  }
  [[gnu::always_inline]] Vector* force_row(int j) const {
    return room.plane + static_cast<std::size_t>(j) * static_cast<std::size_t>(strips.packs);
  }
  /// A row, a period further.
  [[gnu::always_inline]] Vector const* lifted(Vector const* row, Vector* out) const {
    Vector const by{Quad(shift[1].x), Quad(shift[1].y), Quad(shift[1].z)};
    for (int s = 0; s < strips.packs; ++s) out[s] = row[s] + by;
    return out;
  }
  [[gnu::always_inline]] void layer(CellRow3d<Cell> const& cells, Layer3d const& at, Quad::Bits& seen) const {
    clear(room.behind, strips.packs), clear(room.above_behind, strips.packs);
    int const cell_rows = round ? rows : rows - 1;
    for (int j = 0; j < cell_rows; ++j) {
      Vector const *front = at.low + static_cast<std::size_t>(j) * at.low_stride,
                   *above = at.high + static_cast<std::size_t>(j) * at.high_stride,
                   *back = front + at.low_stride, *above_back = above + at.high_stride;
      if (j + 1 == rows) back = lifted(at.low, room.lifted), above_back = lifted(at.high, room.lifted_above);
      bool const waits = round && j == 0;
      Vector* const whole = waits ? room.first : room.whole;
      cells({{front, back, above, above_back}}, {whole, force_row(j), room.behind, room.above_behind}, seen);
      if (!waits) move(at, j, whole);
    }
    // The last row of nodes, or the first one once more.
    int const last = round ? 0 : rows - 1;
    Vector *const force = force_row(last), *const begun = round ? room.first : force;
    for (int s = 0; s < strips.packs; ++s) {
      room.whole[s] = begun[s] + room.behind[s];
      force[s] = round ? force[s] + room.above_behind[s] : room.above_behind[s];
    }
    move(at, last, room.whole);
  }

  /// Kick and drift of register s.
  [[gnu::always_inline]] void move(Vector* x, int s, Vector const& force, Vector const& kick) const {
    Vector* const v = x + strips.packs;
    Quad const step(dt);
    Vector const rate{v[s].x + kick.x * force.x, v[s].y + kick.y * force.y, v[s].z + kick.z * force.z};
    v[s] = rate;
    x[s] = {x[s].x + step * rate.x, x[s].y + step * rate.y, x[s].z + step * rate.z};
  }
  /// Kick and drift of a row, with the forces on it.
  [[gnu::always_inline]] void move(Layer3d const& at, int j, Vector* force) const {
    if (!at.moves) return;
    Vector* const x = at.low + static_cast<std::size_t>(j) * at.low_stride;
    Space<double> const& share = row_shares[j];
    Vector const kick{Quad(at.kick.x * share.x), Quad(at.kick.y * share.y), Quad(at.kick.z * share.z)};
    int const ghost = strips.pack(strips.cells), lane = strips.lane(strips.cells);
    if (strips.periodic) {
      // What acts on node number `cells` acts on node 0.
      force[0].x.lane[0] += force[ghost].x.lane[lane];
      force[0].y.lane[0] += force[ghost].y.lane[lane];
      force[0].z.lane[0] += force[ghost].z.lane[lane];
    }
    for (int s = 1; s < strips.full; ++s) move(x, s, force[s], kick);
    for (int t = strips.full > 0 ? 0 : 1; t <= strips.rest(); ++t) {
      int const s = t == 0 ? 0 : strips.full + t - 1;
      auto const& ends = strips.share[t];
      move(x, s, force[s], {kick.x * ends[0], kick.y * ends[1], kick.z * ends[2]});
    }
    if (strips.periodic) close(x, ghost, lane);
  }
  /// Node number `cells` is node 0 again.
  [[gnu::always_inline]] void close(Vector* x, int ghost, int lane) const {
    x[ghost].x.lane[lane] = x[0].x.lane[0] + shift[0].x;
    x[ghost].y.lane[lane] = x[0].y.lane[0] + shift[0].y;
    x[ghost].z.lane[lane] = x[0].z.lane[0] + shift[0].z;
    Vector* const v = x + strips.packs;
    v[ghost].x.lane[lane] = v[0].x.lane[0];
    v[ghost].y.lane[lane] = v[0].y.lane[0];
    v[ghost].z.lane[lane] = v[0].z.lane[0];
  }
};

/// Looks for cells whose Jacobian is not a positive number, in layers from below.
struct Examination3d {
  Strips const& strips;
  Space<Quad> const* const* rows;  ///< places, plane by plane, each with its rows
  int across;                      ///< rows of a plane
  int planes;                      ///< how many
  alignas(32) Quad::Bits bad{};    ///< on return true in a lane that has found one

  [[gnu::always_inline]] void operator()() {
    Quad::Bits found{};
    for (int k = 0; k + 1 < planes; ++k)
      for (int j = 0; j + 1 < across; ++j) {
        Space<Quad> const *const *low = rows + k * across + j, *const *high = low + across;
        cell_row({{low[0], low[1], high[0], high[1]}}, found);
      }
    bad |= found;
  }

 private:
  [[gnu::always_inline]] void cell_row(FourRows const& x, Quad::Bits& found) const {
    FourNodes nodes, next;
    Column3d left, right;
    put_nodes(x, 0, nodes), put_column(nodes, left);
    for (int s = 0; s < strips.packs; ++s) {
      if (s + 1 < strips.packs)
        put_nodes(x, s + 1, next);
      else
        put_turned(x, next);
      put_column(next, right);
      FourNodes const first{next[0] - nodes[0], next[1] - nodes[1], next[2] - nodes[2], next[3] - nodes[3]};
      Quad::Bits wrong{};
      note(first, left, wrong), note(first, right, wrong);
      found |= s < strips.full ? wrong : wrong & strips.there[s - strips.full];
      for (int r = 0; r < 4; ++r) nodes[r] = next[r];
      left = right;
    }
  }
  [[gnu::always_inline]] static void note(FourNodes const& first, Column3d const& side, Quad::Bits& wrong) {
    for (int r = 0; r < 4; ++r) {
      Quad const d = dot(first[r], side.face[r]);
      // An infinite one is none either.
      wrong |= ~((d.lane > Quad(0).lane) & (d.lane < Quad(1e300).lane));
    }
  }
};

}  // namespace actio::media::detail
