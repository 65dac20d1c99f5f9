// The nodes of a box that a rank has, in registers in memory, where the fused steps move them: how they lie
// there, and how they come and go.
#pragma once

#include <algorithm>
#include <vector>

#include "actio/fast_media/fast_box_3d.hpp"
#include "actio/parallel/ranks.hpp"

namespace actio::media::detail {

/// Sets one lane.
inline void set_lane(Plane<Quad>& to, int lane, Plane<double> const& a) {
  to.x.lane[lane] = a.x, to.y.lane[lane] = a.y;
}
/// \copydoc set_lane
inline void set_lane(Space<Quad>& to, int lane, Space<double> const& a) {
  to.x.lane[lane] = a.x, to.y.lane[lane] = a.y, to.z.lane[lane] = a.z;
}
/// One lane.
inline Plane<double> lane_of(Plane<Quad> const& a, int lane) { return {a.x.lane[lane], a.y.lane[lane]}; }
/// \copydoc lane_of
inline Space<double> lane_of(Space<Quad> const& a, int lane) {
  return {a.x.lane[lane], a.y.lane[lane], a.z.lane[lane]};
}

/// Places and velocities of the nodes of this rank, and of copies of its neighbours' ones. A slice, which is
/// of one rank, is a plane of nodes of a box in space, or a row in the plane.
/// @tparam Vector  `Plane` or `Space`
template <class Box, template <class> class Vector>
class NodesInRegisters {
 public:
  using Register = Vector<Quad>;
  using Vectors = std::vector<Vector<double>>;

  /// Keeps a copy of the state.
  void keep() { kept_ = state_; }
  /// Back to the copy.
  void restore() { state_ = kept_; }
  /// Sets places, and velocities half a step back, of the nodes row by row; given on rank 0.
  void put(Vectors const& x, Vectors const& v) {
    if (halo_.alone()) return put_own(x, v);
    Vectors mine(own_nodes()), rates(mine.size());
    halo_.ranks().scatter(bytes_of(x), bytes_of(mine));
    halo_.ranks().scatter(bytes_of(v), bytes_of(rates));
    put_own(mine, rates);
    halo_.exchange(state_);
  }
  /// Places of the nodes row by row, or their velocities; on rank 0.
  Vectors read(bool velocity) const {
    auto const mine = read_own(velocity);
    if (halo_.alone()) return mine;
    Vectors all(halo_.ranks().rank() == 0 ? static_cast<std::size_t>(box_.count()) : 0);
    halo_.ranks().gather(bytes_of(mine), bytes_of(all));
    return all;
  }

 protected:
  /// @param width  how many slices of each neighbour are copied
  NodesInRegisters(Box const& box, Ranks* ranks, int width)
      : box_(box),
        strips_(box),
        rows_(sliced == 2 ? box.nodes(1) : 1),
        // Rows that are a multiple of a page apart would be in each other's way.
        stride_(2 * static_cast<std::size_t>(strips_.packs) + gap(strips_.packs)),
        halo_(ranks, box.nodes(sliced), box.periodic(sliced), width),
        state_(stride_ * static_cast<std::size_t>(rows_) * static_cast<std::size_t>(halo_.stored()),
               Register{}) {}

  /// The first row of a slice: the places of its nodes, and then their velocities.
  Register* slice(int k) { return state_.data() + halo_.local(k) * row_offset(rows_); }
  /// \copydoc slice
  Register const* slice(int k) const { return state_.data() + halo_.local(k) * row_offset(rows_); }
  /// From the first row of a slice to another one, registers.
  std::size_t row_offset(int j) const { return static_cast<std::size_t>(j) * stride_; }
  /// Cuts the slices of this rank into equal parts, one for each thread.
  template <class Band>
  void cut(std::vector<Band>& bands, int threads) const {
    auto const own = halo_.own();
    int const count = std::clamp(threads, 1, own.count());
    for (int b = 0; b < count; ++b) {
      auto const part = RowRange::of(own.count(), b, count);
      Band& band = bands.emplace_back();
      band.from = own.from + part.from, band.to = own.from + part.to;
    }
  }

  Box box_;                      ///< of cells
  Strips strips_;                ///< of a row
  int rows_;                     ///< of a slice
  std::size_t stride_;           ///< from row to row
  HaloRows halo_;                ///< slices of this rank, and of its neighbours
  std::vector<Register> state_;  ///< slice by slice
  std::vector<Register> kept_;   ///< its copy

 private:
  static constexpr int sliced = Box::dimension - 1;  // the direction across slices

  static std::size_t gap(int packs) {
    return sliced == 2 ? (packs % 8 == 0 ? 1 : 0) : (packs % 16 == 0 ? 2 : 0);
  }
  std::size_t own_nodes() const {
    return static_cast<std::size_t>(halo_.own().count()) * static_cast<std::size_t>(rows_) *
           static_cast<std::size_t>(box_.nodes(0));
  }
  /// Of the slices of this rank alone.
  void put_own(Vectors const& x, Vectors const& v) {
    auto first = static_cast<std::size_t>(0);
    for (int k = halo_.own().from; k < halo_.own().to; ++k)
      for (int j = 0; j < rows_; ++j, first += static_cast<std::size_t>(box_.nodes(0)))
        for (int i = 0; i <= box_.cells[0]; ++i) {
          bool const round = i == box_.nodes(0);
          std::size_t const at = first + static_cast<std::size_t>(round ? 0 : i);
          Register* const place = slice(k) + row_offset(j) + strips_.pack(i);
          set_lane(place[0], strips_.lane(i), x[at] + (round ? box_.shift(0) : Vector<double>{}));
          set_lane(place[strips_.packs], strips_.lane(i), v[at]);
        }
  }
  Vectors read_own(bool velocity) const {
    Vectors out;
    out.reserve(own_nodes());
    for (int k = halo_.own().from; k < halo_.own().to; ++k)
      for (int j = 0; j < rows_; ++j)
        for (int i = 0; i < box_.nodes(0); ++i) {
          Register const* const place = slice(k) + row_offset(j) + strips_.pack(i);
          out.push_back(lane_of(place[velocity ? strips_.packs : 0], strips_.lane(i)));
        }
    return out;
  }
};

}  // namespace actio::media::detail
