// The planes of nodes of a medium in space, as the fused steps have them: registers in memory, bands of
// planes for threads, copies where bands meet.
#pragma once

#include <algorithm>
#include <vector>

#include "actio/fast_media/fast_options.hpp"
#include "actio/fast_media/fast_strains.hpp"
#include "actio/fast_media/fast_sweep_3d.hpp"
#include "actio/parallel/team.hpp"

namespace actio::media::detail {

/// Places and velocities of all nodes, and their steps.
template <class Cell>
class FusedPlanes3d {
 public:
  using Register = Space<Quad>;

  FusedPlanes3d(FastBox3d const& box, Cell const& cell, double dt, FastOptions const& options)
      : box_(box),
        cell_(cell),
        dt_(dt),
        registers_(options.registers),
        strips_(box),
        rows_(box.nodes(1)),
        planes_(box.nodes(2)),
        halo_(options.ranks, planes_, box.periodic(2), 1),
        packs_(static_cast<std::size_t>(strips_.packs)),
        // Rows that are a multiple of a page apart would be in each other's way.
        stride_(2 * packs_ + (strips_.packs % 8 == 0 ? 1 : 0)),
        state_(stride_ * static_cast<std::size_t>(rows_) * static_cast<std::size_t>(halo_.stored()), zero()) {
    prepare(options);
  }

  /// Keeps a copy of the state.
  void keep() { kept_ = state_; }
  /// Back to the copy.
  void restore() { state_ = kept_; }
  /// How many steps a pass makes.
  int levels() const { return 1; }
  /// Memory, bytes.
  std::size_t bytes() const {
    std::size_t sum = state_.capacity() + kept_.capacity() + seam_.capacity();
    for (auto const& band : bands_)
      sum += band.below.capacity() + band.above.capacity() + band.room.capacity();
    return sum * sizeof(Register);
  }

  /// Sets places, and velocities half a step back, of the nodes row by row; given on rank 0.
  void put(std::vector<Space<double>> const& x, std::vector<Space<double>> const& v) {
    if (halo_.alone()) return put_own(x, v);
    std::vector<Space<double>> mine(own_nodes()), rates(mine.size());
    halo_.ranks().scatter(bytes_of(x), bytes_of(mine));
    halo_.ranks().scatter(bytes_of(v), bytes_of(rates));
    put_own(mine, rates);
    halo_.exchange(state_);
  }
  /// Places of the nodes row by row, or their velocities; on rank 0.
  std::vector<Space<double>> read(bool velocity) const {
    auto const mine = read_own(velocity);
    if (halo_.alone()) return mine;
    std::vector<Space<double>> all(halo_.ranks().rank() == 0 ? static_cast<std::size_t>(box_.count()) : 0);
    halo_.ranks().gather(bytes_of(mine), bytes_of(all));
    return all;
  }
  /// So many steps on. @return whether no Jacobian was seen that is negative
  bool advance(long count) {
    for (auto& band : bands_) band.signs = Quad::Bits{};
    as_team(static_cast<int>(bands_.size()), [&](int b, Meeting& meeting) {
      Band& band = bands_[static_cast<std::size_t>(b)];
      for (long done = 0; done < count; ++done) {
        if (!halo_.alone()) {
          if (b == 0) halo_.exchange(state_);
          meeting.wait();
        }
        copy_neighbours(band);
        meeting.wait();
        sweep(band);
        meeting.wait();
      }
    });
    return all_sound(bands_, halo_);
  }
  /// Whether all cells of the state have positive Jacobians.
  bool examine() {
    look_at_cells([&](Band& band, RowsOfCells<Register> const& rows) {
      Examination3d examination{strips_, rows.x, rows.across, rows.layers + 1};
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
  /// Planes that one thread steps.
  struct Band {
    int from, to;                 ///< its own planes
    std::vector<Register> below;  ///< places in the plane below, where there is one
    std::vector<Register> above;  ///< those in the plane above
    std::vector<Register> room;   ///< forces, and rows
    std::vector<Layer3d> layers;
    Strains strains;               ///< that were seen last
    alignas(32) Quad::Bits signs;  ///< set where a Jacobian was seen that is not positive
  };

  static Register zero() { return {Quad(0), Quad(0), Quad(0)}; }
  static Register registers(Space<double> const& a) { return {Quad(a.x), Quad(a.y), Quad(a.z)}; }
  std::size_t row_offset(int j) const { return static_cast<std::size_t>(j) * stride_; }
  Register* plane(int k) { return state_.data() + halo_.local(k) * row_offset(rows_); }
  Register const* plane(int k) const { return state_.data() + halo_.local(k) * row_offset(rows_); }
  Register const* line(int number) const { return plane(number / rows_) + row_offset(number % rows_); }
  Register* line(int number) { return plane(number / rows_) + row_offset(number % rows_); }
  std::size_t own_nodes() const {
    return static_cast<std::size_t>(halo_.own().count()) * static_cast<std::size_t>(rows_) *
           static_cast<std::size_t>(box_.nodes(0));
  }

  /// Of the planes of this rank alone.
  void put_own(std::vector<Space<double>> const& x, std::vector<Space<double>> const& v) {
    int const n = box_.nodes(0);
    std::size_t k = 0;
    for (int number = rows_ * halo_.own().from; number < rows_ * halo_.own().to;
         ++number, k += static_cast<std::size_t>(n))
      for (int i = 0; i <= box_.cells[0]; ++i) {
        bool const round = i == n;
        std::size_t const at = k + static_cast<std::size_t>(round ? 0 : i);
        int const s = strips_.pack(i), lane = strips_.lane(i);
        Register* const row = line(number);
        Register &place = row[s], &rate = row[strips_.packs + s];
        auto const shift = round ? box_.shift(0) : Space<double>{0, 0, 0};
        place.x.lane[lane] = x[at].x + shift.x, rate.x.lane[lane] = v[at].x;
        place.y.lane[lane] = x[at].y + shift.y, rate.y.lane[lane] = v[at].y;
        place.z.lane[lane] = x[at].z + shift.z, rate.z.lane[lane] = v[at].z;
      }
  }
  std::vector<Space<double>> read_own(bool velocity) const {
    std::vector<Space<double>> out;
    out.reserve(own_nodes());
    for (int number = rows_ * halo_.own().from; number < rows_ * halo_.own().to; ++number)
      for (int i = 0; i < box_.nodes(0); ++i) {
        Register const& r = line(number)[strips_.pack(i) + (velocity ? strips_.packs : 0)];
        int const lane = strips_.lane(i);
        out.push_back({r.x.lane[lane], r.y.lane[lane], r.z.lane[lane]});
      }
    return out;
  }
  bool round() const { return box_.periodic(2); }
  /// Calls `look(band, rows)` on a thread for each band, with the rows at the cells above its own planes.
  template <class Look>
  void look_at_cells(Look const& look) {
    halo_.exchange(state_);
    // Rows and planes a period further are made once more.
    int const across = box_.cells[1] + 1, from = halo_.own().from,
              to = std::min(halo_.own().to + 1, box_.cells[2] + 1);
    std::vector<std::vector<Register>> further;
    std::vector<Register const*> x, v;
    for (int k = from; k < to; ++k)
      for (int j = 0; j < across; ++j) {
        Register const* const row = plane(k == planes_ ? 0 : k) + row_offset(j == rows_ ? 0 : j);
        x.push_back(row), v.push_back(row + packs_);
        if (k < planes_ && j < rows_) continue;
        Space<double> by{0, 0, 0};
        if (j == rows_) by = by + box_.shift(1);
        if (k == planes_) by = by + box_.shift(2);
        further.emplace_back(packs_, zero());
        for (std::size_t s = 0; s < packs_; ++s) further.back()[s] = row[s] + registers(by);
        x.back() = further.back().data();
      }
    as_team(static_cast<int>(bands_.size()), [&](int b, Meeting&) {
      Band& band = bands_[static_cast<std::size_t>(b)];
      int const first = across * (band.from - from);
      look(band, {x.data() + first, v.data() + first, across, std::min(band.to + 1, to) - band.from - 1});
    });
  }

  /// Bands, their layers, and room for them.
  void prepare(FastOptions const& options) {
    std::size_t const places = packs_ * static_cast<std::size_t>(rows_);
    if (round()) seam_.assign(places, zero());
    for (int j = 0; j < rows_; ++j) {
      double const share = 1 / box_.share(1, j);
      row_shares_.push_back({box_.moves(1, j, 0) ? share : 0, box_.moves(1, j, 1) ? share : 0,
                             box_.moves(1, j, 2) ? share : 0});
    }
    auto const own = halo_.own();
    int const bands = std::clamp(options.threads, 1, own.count());
    bands_.resize(static_cast<std::size_t>(bands));
    for (int b = 0; b < bands; ++b) {
      Band& band = bands_[static_cast<std::size_t>(b)];
      auto const part = RowRange::of(own.count(), b, bands);
      band.from = own.from + part.from, band.to = own.from + part.to;
      if (round() || band.from > 0) band.below.assign(places, zero());
      if (band.to < planes_) band.above.assign(places, zero());
      band.room.assign(places + 6 * packs_, zero());
      make_layers(band);
    }
  }
  void make_layers(Band& band) {
    auto const add = [&](int k, Register* low, std::size_t low_stride, bool moves) {
      Layer3d layer{low, nullptr, low_stride, stride_, moves, {0, 0, 0}};
      if (k + 1 == 0 || k + 1 == planes_)
        layer.high = round() ? seam_.data() : nullptr, layer.high_stride = packs_;
      else if (k + 1 == band.to)
        layer.high = band.above.data(), layer.high_stride = packs_;
      else
        layer.high = plane(k + 1);
      double const kick = dt_ / (box_.share(2, std::max(k, 0)) * box_.measure());
      if (moves)
        layer.kick = {box_.moves(2, k, 0) ? kick : 0, box_.moves(2, k, 1) ? kick : 0,
                      box_.moves(2, k, 2) ? kick : 0};
      band.layers.push_back(layer);
    };
    if (!band.below.empty()) add(band.from - 1, band.below.data(), packs_, false);
    for (int k = band.from; k < band.to; ++k) add(k, plane(k), stride_, true);
  }
  /// The places of a plane, row by row without gaps.
  void copy_places(int k, std::vector<Register>& out) {
    for (int j = 0; j < rows_; ++j)
      std::copy_n(plane(k) + row_offset(j), packs_, out.data() + static_cast<std::size_t>(j) * packs_);
  }
  /// What other threads move while this one needs it. A plane is moved by a period here and nowhere else, so
  /// that what rounding makes of that does not depend on who steps it.
  void copy_neighbours(Band& band) {
    if (!band.below.empty()) copy_places((band.from + planes_ - 1) % planes_, band.below);
    if (!band.above.empty()) copy_places(band.to, band.above);
    // The band with plane 0, or without that the one below it.
    bool const first = band.from == 0, last = band.to == planes_ && halo_.own().from > 0;
    if ((first || last) && round()) {
      copy_places(0, seam_);
      Register const by = registers(box_.shift(2));
      for (Register& place : seam_) place = place + by;
    }
  }
  void sweep(Band& band);

  FastBox3d box_;
  Cell cell_;
  double dt_;
  Registers registers_;
  Strips strips_;
  int rows_, planes_;  // of nodes in a plane, and planes
  HaloRows halo_;
  std::size_t packs_;   // registers of a row
  std::size_t stride_;  // from row to row
  std::vector<Register> state_, kept_;
  std::vector<Register> seam_;  // the places of the first plane, a period further
  std::vector<Space<double>> row_shares_;
  std::vector<Band> bands_;
};

template <class Cell>
void FusedPlanes3d<Cell>::sweep(Band& band) {
  Register* const rows = band.room.data() + packs_ * static_cast<std::size_t>(rows_);
  Sweep3d<Cell> sweep{cell_,
                      strips_,
                      dt_,
                      band.layers.data(),
                      static_cast<int>(band.layers.size()),
                      rows_,
                      box_.periodic(1),
                      row_shares_.data(),
                      {box_.shift(0), box_.shift(1)},
                      {band.room.data(), rows, rows + packs_, rows + 2 * packs_, rows + 3 * packs_,
                       rows + 4 * packs_, rows + 5 * packs_}};
  run_with(registers_, sweep);
  band.signs |= sweep.signs;
}

}  // namespace actio::media::detail
