// The rows of nodes of a medium in the plane, as the fused steps have them: registers in memory, bands of
// rows for threads, copies where bands meet.
#pragma once

#include <algorithm>
#include <vector>

#include "actio/fast_media/fast_options.hpp"
#include "actio/fast_media/fast_strains.hpp"
#include "actio/fast_media/fast_sweep_2d.hpp"
#include "actio/parallel/team.hpp"

namespace actio::media {

namespace detail {

/// Places and velocities of all nodes, and their steps.
template <class Cell>
class FusedRows2d {
 public:
  using Register = Plane<Quad>;

  FusedRows2d(FastBox2d const& box, Cell const& cell, double dt, FastOptions const& options)
      : box_(box),
        cell_(cell),
        dt_(dt),
        registers_(options.registers),
        strips_(box),
        // Rows that are a multiple of a page apart would be in each other's way.
        stride_(2 * static_cast<std::size_t>(strips_.packs) + (strips_.packs % 16 == 0 ? 2 : 0)),
        levels_(levels_of(box, strips_, options)),
        halo_(options.ranks, box.nodes(1), box.periodic(1), levels_),
        state_(stride_ * static_cast<std::size_t>(halo_.stored()), {Quad(0), Quad(0)}) {
    prepare(options);
  }

  /// Keeps a copy of the state.
  void keep() { kept_ = state_; }
  /// Back to the copy.
  void restore() { state_ = kept_; }
  /// How many steps a pass makes.
  int levels() const { return levels_; }
  /// Memory, bytes.
  std::size_t bytes() const {
    std::size_t sum = state_.capacity() + kept_.capacity();
    for (auto const& band : bands_) sum += band.copies.capacity() + band.forces.capacity();
    return sum * sizeof(Register);
  }

  /// Sets places, and velocities half a step back, of the nodes row by row; given on rank 0.
  void put(std::vector<Plane<double>> const& x, std::vector<Plane<double>> const& v) {
    if (halo_.alone()) return put_own(x, v);
    std::vector<Plane<double>> mine(own_nodes()), rates(mine.size());
    halo_.ranks().scatter(bytes_of(x), bytes_of(mine));
    halo_.ranks().scatter(bytes_of(v), bytes_of(rates));
    put_own(mine, rates);
    halo_.exchange(state_);
  }
  /// Places of the nodes row by row, or their velocities; on rank 0.
  std::vector<Plane<double>> read(bool velocity) const {
    auto const mine = read_own(velocity);
    if (halo_.alone()) return mine;
    std::vector<Plane<double>> all(halo_.ranks().rank() == 0 ? static_cast<std::size_t>(box_.count()) : 0);
    halo_.ranks().gather(bytes_of(mine), bytes_of(all));
    return all;
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

  Register* row(int j) { return state_.data() + halo_.local(j) * stride_; }
  Register const* row(int j) const { return state_.data() + halo_.local(j) * stride_; }
  std::size_t own_nodes() const {
    return static_cast<std::size_t>(halo_.own().count()) * static_cast<std::size_t>(box_.nodes(0));
  }

  /// Of the rows of this rank alone.
  void put_own(std::vector<Plane<double>> const& x, std::vector<Plane<double>> const& v) {
    int const n = box_.nodes(0), first = halo_.own().from;
    for (int j = first; j < halo_.own().to; ++j)
      for (int i = 0; i <= box_.cells[0]; ++i) {
        bool const round = i == n;
        auto const k = static_cast<std::size_t>(j - first) * static_cast<std::size_t>(n) +
                       static_cast<std::size_t>(round ? 0 : i);
        int const s = strips_.pack(i), lane = strips_.lane(i);
        Register &place = row(j)[s], &rate = row(j)[strips_.packs + s];
        place.x.lane[lane] = x[k].x + (round ? box_.shift(0).x : 0);
        place.y.lane[lane] = x[k].y + (round ? box_.shift(0).y : 0);
        rate.x.lane[lane] = v[k].x, rate.y.lane[lane] = v[k].y;
      }
  }
  std::vector<Plane<double>> read_own(bool velocity) const {
    std::vector<Plane<double>> out;
    out.reserve(own_nodes());
    for (int j = halo_.own().from; j < halo_.own().to; ++j)
      for (int i = 0; i < box_.nodes(0); ++i) {
        Register const& r = row(j)[strips_.pack(i) + (velocity ? strips_.packs : 0)];
        out.push_back({r.x.lane[strips_.lane(i)], r.y.lane[strips_.lane(i)]});
      }
    return out;
  }

  /// How many steps a pass makes: the rows of all levels together fit into half of a second cache of a
  /// megabyte; and copies are of rows of the next rank alone.
  static int levels_of(FastBox2d const& box, Strips const& strips, FastOptions const& options) {
    double const row_bytes = 192.0 * strips.packs;
    int const wanted = options.levels > 0 ? std::min(options.levels, 64)
                                          : std::clamp(static_cast<int>(500000 / row_bytes), 1, 8);
    return std::min(wanted, std::max(1, HaloRows::widest(options.ranks, box.nodes(1))));
  }
  /// Bands and room for them.
  void prepare(FastOptions const& options) {
    auto const own = halo_.own();
    int const bands = std::clamp(options.threads, 1, own.count());
    bands_.resize(static_cast<std::size_t>(bands));
    for (int b = 0; b < bands; ++b) {
      Band& band = bands_[static_cast<std::size_t>(b)];
      auto const part = RowRange::of(own.count(), b, bands);
      band.from = own.from + part.from, band.to = own.from + part.to;
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
      Register* at = row(k);
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
    for (int j = own.from; j < own.to; ++j) x.push_back(row(j)), v.push_back(row(j) + strips_.packs);
    std::vector<Register> above;
    if (own.to < box_.nodes(1)) {
      x.push_back(row(own.to)), v.push_back(row(own.to) + strips_.packs);
    } else if (box_.periodic(1)) {
      Quad const by_x(box_.shift(1).x), by_y(box_.shift(1).y);
      for (int s = 0; s < strips_.packs; ++s) above.push_back({row(0)[s].x + by_x, row(0)[s].y + by_y});
      x.push_back(above.data()), v.push_back(row(0) + strips_.packs);
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

  FastBox2d box_;
  Cell cell_;
  double dt_;
  Registers registers_;
  Strips strips_;
  std::size_t stride_;
  int levels_;
  HaloRows halo_;
  std::vector<Register> state_, kept_;
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
