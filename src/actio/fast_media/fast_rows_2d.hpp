// The rows of nodes of a medium in the plane, as the fused steps have them: registers in memory, bands of
// rows for threads, copies where bands meet.
#pragma once

#include <algorithm>
#include <vector>

#include "actio/fast_media/fast_options.hpp"
#include "actio/fast_media/fast_strains.hpp"
#include "actio/fast_media/fast_sweep_2d.hpp"
#include "actio/fast_media/nodes_in_registers.hpp"
#include "actio/parallel/team.hpp"

namespace actio::media {

namespace detail {

/// Places and velocities of all nodes, and their steps.
template <class Cell>
class FusedRows2d : public NodesInRegisters<FastBox2d, Plane> {
 public:
  FusedRows2d(FastBox2d const& box, Cell const& cell, double dt, FastOptions const& options)
      : NodesInRegisters(box, options.ranks, levels_of(box, options)),
        cell_(cell),
        dt_(dt),
        registers_(options.registers),
        levels_(levels_of(box, options)) {
    prepare(options);
  }

  /// How many steps a pass makes.
  int levels() const { return levels_; }
  /// Memory, bytes.
  std::size_t bytes() const {
    std::size_t sum = state_.capacity() + kept_.capacity();
    for (auto const& band : bands_) sum += band.copies.capacity() + band.forces.capacity();
    return sum * sizeof(Register);
  }

  /// So many steps on. @return whether no Jacobian was seen that is negative
  bool advance(long count);
  /// Whether all cells of the state have positive Jacobians.
  bool examine() {
    look_at_cells([&](Band& band, RowsOfCells<Register> const& rows) {
      Examination2d examination{strips_, rows.x, rows.across};
      run_with(registers_, examination);
      band.signs = examination.bad;
    });
    return all_sound(bands_, halo_);
  }
  /// The strains of the state, their rates half a step back.
  Strains strains() {
    look_at_cells([&](Band& band, RowsOfCells<Register> const& rows) {
      band.strains = strains_of(rows, strips_, box_.spacing, registers_);
    });
    return largest_strains(bands_, halo_);
  }

 private:
  /// Rows that one thread steps.
  struct Band {
    int from, to;                  ///< its own rows
    int low, high;                 ///< with those of its neighbours
    std::vector<Register> copies;  ///< of the neighbours' rows
    std::vector<Register> forces;  ///< one row a level
    std::vector<Register> lifted;  ///< the first row of a period, where the next period has it
    std::vector<NodeRow2d> rows;
    Strains strains;               ///< that were seen last
    alignas(32) Quad::Bits signs;  ///< set where a Jacobian was seen that is not positive
  };

  /// How many steps a pass makes: the rows of all levels together fit into half of a second cache of a
  /// megabyte; and copies are of rows of the next rank alone.
  static int levels_of(FastBox2d const& box, FastOptions const& options) {
    double const row_bytes = 192.0 * Strips(box).packs;
    int const wanted = options.levels > 0 ? std::min(options.levels, 64)
                                          : std::clamp(static_cast<int>(500000 / row_bytes), 1, 8);
    return std::min(wanted, std::max(1, HaloRows::widest(options.ranks, box.nodes(1))));
  }
  /// Bands and room for them.
  void prepare(FastOptions const& options) {
    cut(bands_, options.threads);
    for (Band& band : bands_) {
      band.copies.assign(2 * static_cast<std::size_t>(levels_) * stride_, {Quad(0), Quad(0)});
      band.forces.assign(static_cast<std::size_t>(levels_ * strips_.packs), {Quad(0), Quad(0)});
      band.lifted.assign(static_cast<std::size_t>(strips_.packs), {Quad(0), Quad(0)});
      band.rows.reserve(static_cast<std::size_t>(band.to - band.from + 2 * levels_));
    }
  }
  /// Where the rows of a band lie for a pass of so many levels; those of neighbours are copied.
  void take_rows(Band& band, int levels) {
    int const rows = box_.nodes(1);
    bool const round = box_.periodic(1);
    band.low = round ? band.from - levels : std::max(0, band.from - levels);
    band.high = round ? band.to + levels : std::min(rows, band.to + levels);
    band.rows.clear();
    Register* copy = band.copies.data();
    for (int j = band.low; j < band.high; ++j) {
      int const k = (j % rows + rows) % rows;
      Register* at = slice(k);
      if (j < band.from || j >= band.to) {
        std::copy_n(at, 2 * strips_.packs, copy);
        at = copy, copy += stride_;
      }
      double const kick = dt_ / (box_.share(1, k) * box_.spacing[0] * box_.spacing[1]);
      band.rows.push_back({at,
                           at + strips_.packs,
                           {box_.moves(1, k, 0) ? kick : 0, box_.moves(1, k, 1) ? kick : 0},
                           round && k == 0});
    }
  }
  /// Calls `look(band, rows)` on a thread for each band, with the rows at the cells above its own ones.
  template <class Look>
  void look_at_cells(Look const& look) {
    halo_.exchange(state_);
    auto const own = halo_.own();
    std::vector<Register const*> x, v;
    for (int j = own.from; j < own.to; ++j) x.push_back(slice(j)), v.push_back(slice(j) + strips_.packs);
    std::vector<Register> above;
    if (own.to < box_.nodes(1)) {
      x.push_back(slice(own.to)), v.push_back(slice(own.to) + strips_.packs);
    } else if (box_.periodic(1)) {
      Quad const by_x(box_.shift(1).x), by_y(box_.shift(1).y);
      for (int s = 0; s < strips_.packs; ++s) above.push_back({slice(0)[s].x + by_x, slice(0)[s].y + by_y});
      x.push_back(above.data()), v.push_back(slice(0) + strips_.packs);
    }
    as_team(static_cast<int>(bands_.size()), [&](int b, Meeting&) {
      Band& band = bands_[static_cast<std::size_t>(b)];
      int const first = band.from - own.from, left = static_cast<int>(x.size()) - first;
      look(band, {x.data() + first, v.data() + first, std::min(band.to - band.from + 1, left), 1});
    });
  }
  Edges<double> rest() const {
    double const h1 = box_.spacing[0], h2 = box_.spacing[1];
    return {{h1, 0}, {h1, 0}, {0, h2}, {0, h2}};
  }

  Cell cell_;
  double dt_;
  Registers registers_;
  int levels_;
  std::vector<Band> bands_;
};

template <class Cell>
bool FusedRows2d<Cell>::advance(long count) {
  for (auto& band : bands_) band.signs = Quad::Bits{};
  as_team(static_cast<int>(bands_.size()), [&](int b, Meeting& meeting) {
    Band& band = bands_[static_cast<std::size_t>(b)];
    for (long done = 0; done < count;) {
      int const levels = static_cast<int>(std::min<long>(levels_, count - done));
      if (!halo_.alone()) {
        if (b == 0) halo_.exchange(state_);
        meeting.wait();
      }
      take_rows(band, levels);
      meeting.wait();
      bool const round = box_.periodic(1);
      Sweep2d<Cell> sweep{cell_,
                          strips_,
                          rest(),
                          box_.shift(0),
                          dt_,
                          band.rows.data(),
                          static_cast<int>(band.rows.size()),
                          levels,
                          !round && band.low == 0 && band.from - levels <= 0,
                          !round && band.high == box_.nodes(1),
                          band.forces.data(),
                          box_.shift(1),
                          band.lifted.data()};
      run_with(registers_, sweep);
      band.signs |= sweep.signs;
      done += levels;
      meeting.wait();
    }
  });
  return all_sound(bands_, halo_);
}

}  // namespace detail
}  // namespace actio::media
