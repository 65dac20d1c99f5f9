// The planes of nodes of a medium in space, as the fused steps have them: registers in memory, bands of
// planes for threads, copies where bands meet.
#pragma once

#include <algorithm>
#include <vector>

#include "actio/fast_media/fast_options.hpp"
#include "actio/fast_media/fast_strains.hpp"
#include "actio/fast_media/fast_sweep_3d.hpp"
#include "actio/fast_media/nodes_in_registers.hpp"
#include "actio/parallel/team.hpp"

namespace actio::media::detail {

/// Places and velocities of all nodes, and their steps.
template <class Cell>
class FusedPlanes3d : public NodesInRegisters<FastBox3d, Space> {
 public:
  FusedPlanes3d(FastBox3d const& box, Cell const& cell, double dt, FastOptions const& options)
      : NodesInRegisters(box, options.ranks, 1),
        cell_(cell),
        dt_(dt),
        registers_(options.registers),
        planes_(box.nodes(2)),
        packs_(static_cast<std::size_t>(strips_.packs)) {
    prepare(options);
  }

  /// How many steps a pass makes.
  int levels() const { return 1; }
  /// Memory, bytes.
  std::size_t bytes() const {
    std::size_t sum = state_.capacity() + kept_.capacity() + seam_.capacity();
    for (auto const& band : bands_)
      sum += band.below.capacity() + band.above.capacity() + band.room.capacity();
    return sum * sizeof(Register);
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
        Register const* const row = slice(k == planes_ ? 0 : k) + row_offset(j == rows_ ? 0 : j);
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
    cut(bands_, options.threads);
    for (Band& band : bands_) {
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
        layer.high = slice(k + 1);
      double const kick = dt_ / (box_.share(2, std::max(k, 0)) * box_.measure());
      if (moves)
        layer.kick = {box_.moves(2, k, 0) ? kick : 0, box_.moves(2, k, 1) ? kick : 0,
                      box_.moves(2, k, 2) ? kick : 0};
      band.layers.push_back(layer);
    };
    if (!band.below.empty()) add(band.from - 1, band.below.data(), packs_, false);
    for (int k = band.from; k < band.to; ++k) add(k, slice(k), stride_, true);
  }
  /// The places of a plane, row by row without gaps.
  void copy_places(int k, std::vector<Register>& out) {
    for (int j = 0; j < rows_; ++j)
      std::copy_n(slice(k) + row_offset(j), packs_, out.data() + static_cast<std::size_t>(j) * packs_);
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

  Cell cell_;
  double dt_;
  Registers registers_;
  int planes_;                  // of nodes
  std::size_t packs_;           // registers of a row
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
