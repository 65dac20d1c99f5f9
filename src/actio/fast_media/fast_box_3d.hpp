// A box of hexahedral cells and its sides. A row of its nodes lies in four strips, as in the plane
// (fast_box_2d.hpp).
#pragma once

#include "actio/fast_media/fast_box_2d.hpp"
#include "actio/stored_energy/fast_energies.hpp"

namespace actio::media {

/// A box of cells with corners \f$X = origin+(i\,h_1,j\,h_2,k\,h_3)\f$. Made by its members in braces,
/// `FastBox3d{{64, 64, 64}, {0.01, 0.01, 0.01}}`: what is left out is as below. A medium examines its box
/// (\ref examine).
struct FastBox3d {
  /// The directions of the body, and of space.
  static constexpr int dimension = 3;
  /// The sides at the two ends of a direction, lower first.
  using Ends = std::array<Side, 2>;

  std::array<int, 3> cells;       ///< how many along each direction
  std::array<double, 3> spacing;  ///< \f$h_1\f$, \f$h_2\f$, \f$h_3\f$, length
  /// Sides at the ends of each direction.
  std::array<Ends, 3> sides{Ends{Side::free, Side::free}, Ends{Side::free, Side::free},
                            Ends{Side::free, Side::free}};
  std::array<double, 3> origin{0, 0, 0};  ///< X of the first node
  /// How far the placement of a periodic direction goes in one period: \f$\phi(X+Le_i)-\phi(X)\f$, length; 0
  /// stands for \f$Le_i\f$.
  std::array<std::array<double, 3>, 3> period{};

  /// The sides at the ends of direction d.
  Ends const& ends(int d) const { return sides[d]; }
  /// \copydoc ends
  Ends& ends(int d) { return sides[d]; }
  /// Whether direction d is periodic.
  bool periodic(int d) const { return sides[d][0] == Side::periodic; }
  /// How many nodes there are along direction d; of two nodes that are one, one.
  int nodes(int d) const { return cells[d] + !periodic(d); }
  /// All nodes.
  long count() const { return static_cast<long>(nodes(0)) * nodes(1) * nodes(2); }
  /// X of a node.
  std::array<double, 3> at(std::array<int, 3> const& node) const {
    return {origin[0] + node[0] * spacing[0], origin[1] + node[1] * spacing[1],
            origin[2] + node[2] * spacing[2]};
  }
  /// The reference volume of a cell.
  double measure() const { return spacing[0] * spacing[1] * spacing[2]; }
  /// The period of a direction.
  detail::Space<double> shift(int d) const;
  /// The share that node k of direction d has of the mass of an inner node: a half at ends.
  double share(int d, int k) const { return detail::share_of_node(*this, d, k); }
  /// Whether forces change component c of the velocity at node k of direction d.
  bool moves(int d, int k, int c) const { return detail::node_moves(*this, d, k, c); }
  /// What force per mass density becomes acceleration with: one over the reference volume that a node has,
  /// or 0.
  double response(std::array<int, 3> const& node, int c) const;

  /// @throws OutsideDomain  where there are no cells, lengths are not positive, or a direction is periodic at
  ///   one end alone
  /// @throws NotFinite  where a length is no number
  void examine() const { detail::examine_box(*this); }
};

}  // namespace actio::media
