// A rectangle of cells, its sides, and the order in which the optimised implementation holds the nodes of a
// row.
//
// A row of nodes is cut into four strips of equal length, and the four lanes of a register walk along one
// strip each. So the right neighbours of four nodes are the next register, without a shift of lanes; at the
// end of the row, where a strip meets the next one, the register turns by one lane, once. Lanes
// beyond the last cell belong to none: the last registers have a mask.
#pragma once

#include <array>
#include <string>

#include "actio/meshes/side.hpp"
#include "actio/numbers/errors.hpp"
#include "actio/stored_energy/fast_cell_2d.hpp"

namespace actio::media {

namespace detail {
/// The share that node k of direction d of a box has of the mass of an inner node.
template <class Box>
double share_of_node(Box const& box, int d, int k) {
  return !box.periodic(d) && (k == 0 || k == box.cells[d]) ? 0.5 : 1;
}
/// Whether forces change component c of the velocity at node k of direction d of a box.
template <class Box>
bool node_moves(Box const& box, int d, int k, int c) {
  if (box.periodic(d) || (k != 0 && k != box.cells[d])) return true;
  Side const side = box.ends(d)[k == 0 ? 0 : 1];
  return side == Side::free || (side == Side::sliding && c != d);
}
/// Refuses a box that is none.
template <class Box>
void examine_box(Box const& box) {
  for (int d = 0; d < Box::dimension; ++d) {
    std::string const direction = "box of cells, direction " + std::to_string(d + 1);
    if (box.cells[d] < 1) throw OutsideDomain(direction, "at least one cell is needed", box.cells[d], 1);
    bool finite = is_finite(box.spacing[d]) && is_finite(box.origin[d]);
    for (double const x : box.period[d]) finite = finite && is_finite(x);
    if (!finite) throw NotFinite(direction);
    if (!(box.spacing[d] > 0))
      throw OutsideDomain(direction, "the length of a cell must be positive", box.spacing[d], 0);
    auto const ends = box.ends(d);
    if ((ends[0] == Side::periodic) != (ends[1] == Side::periodic))
      throw OutsideDomain(direction, "both ends or none are periodic; periodic ends", 1, 2);
    if (ends[0] == Side::moved || ends[1] == Side::moved)
      throw OutsideDomain(direction, "no end of a box is moved; moved ends", 1, 0);
  }
}
}  // namespace detail

/// A rectangle of cells with corners \f$X = origin+(i\,h_1,j\,h_2)\f$. Made by its members in braces,
/// `FastBox2d{{12, 8}, {0.1, 0.1}}`: what is left out is as below. A medium examines its box (\ref examine).
///
/// \snippet media.cpp fast_box_2d
struct FastBox2d {
  std::array<int, 2> cells;                                 ///< how many along each direction
  std::array<double, 2> spacing;                            ///< \f$h_1\f$, \f$h_2\f$, length
  std::array<Side, 2> left_right{Side::free, Side::free};   ///< sides at the ends of direction 1
  std::array<Side, 2> below_above{Side::free, Side::free};  ///< sides at the ends of direction 2
  std::array<double, 2> origin{0, 0};                       ///< X of the first node
  /// How far the placement of a periodic direction goes in one period: \f$\phi(X+Le_i)-\phi(X)\f$, length; 0
  /// stands for \f$Le_i\f$.
  std::array<std::array<double, 2>, 2> period{};

  /// The directions of the body, and of space.
  static constexpr int dimension = 2;
  /// The sides at the ends of direction d.
  std::array<Side, 2> const& ends(int d) const { return d == 0 ? left_right : below_above; }
  /// \copydoc ends
  std::array<Side, 2>& ends(int d) { return d == 0 ? left_right : below_above; }
  /// Whether direction d is periodic.
  bool periodic(int d) const { return ends(d)[0] == Side::periodic; }
  /// How many nodes there are along direction d; of two nodes that are one, one.
  int nodes(int d) const { return cells[d] + !periodic(d); }
  /// All nodes.
  long count() const { return static_cast<long>(nodes(0)) * nodes(1); }
  /// X of a node.
  std::array<double, 2> at(int i, int j) const {
    return {origin[0] + i * spacing[0], origin[1] + j * spacing[1]};
  }
  /// \copydoc at
  std::array<double, 2> at(std::array<int, 2> const& node) const { return at(node[0], node[1]); }
  /// The reference area of a cell.
  double measure() const { return spacing[0] * spacing[1]; }
  /// The period of a direction.
  detail::Plane<double> shift(int d) const {
    if (period[d][0] != 0 || period[d][1] != 0) return {period[d][0], period[d][1]};
    double const length = cells[d] * spacing[d];
    return d == 0 ? detail::Plane<double>{length, 0} : detail::Plane<double>{0, length};
  }
  /// The share that node k of direction d has of the mass of an inner node: a half at ends.
  double share(int d, int k) const { return detail::share_of_node(*this, d, k); }
  /// Whether forces change component c of the velocity at node k of direction d.
  bool moves(int d, int k, int c) const { return detail::node_moves(*this, d, k, c); }
  /// What force per mass density becomes acceleration with: one over the reference area that a node has, or
  /// 0.
  double response(int i, int j, int c) const {
    if (!moves(0, i, c) || !moves(1, j, c)) return 0;
    return 1 / (share(0, i) * share(1, j) * spacing[0] * spacing[1]);
  }
  /// \copydoc response
  double response(std::array<int, 2> const& node, int c) const { return response(node[0], node[1], c); }

  /// @throws OutsideDomain  where there are no cells, lengths are not positive, or a direction is periodic at
  ///   one end alone
  /// @throws NotFinite  where a length is no number
  void examine() const { detail::examine_box(*this); }
};

namespace detail {

/// How a row of nodes lies in four strips.
struct Strips {
  int cells;                        ///< in the row
  int packs;                        ///< registers of one component, the length of a strip
  int full;                         ///< registers from the first on whose four cells are all there
  bool periodic;                    ///< whether node number `cells` is node 0
  alignas(32) Quad::Bits there[4];  ///< for the others, `full` first: which of the four cells are there
  /// Response of the nodes over that of the row, by components, for register 0 and for `full` to the last.
  Quad share[5][3];

  template <class Box>
  explicit Strips(Box const& box)
      : cells(box.cells[0]),
        packs((cells + 4) / 4),
        full(cells > 3 * packs ? cells - 3 * packs : 0),
        periodic(box.periodic(0)) {
    for (int t = 0; t <= 4; ++t) {
      int const s = t == 0 ? 0 : full + t - 1;
      for (int lane = 0; lane < 4; ++lane) {
        int const i = lane * packs + s;
        bool const node = s < packs && i <= cells;
        if (t > 0) there[t - 1][lane] = s < packs && i < cells ? -1 : 0;
        for (int c = 0; c < 3; ++c)
          share[t][c].lane[lane] = node && box.moves(0, i, c) ? 1 / box.share(0, i) : 0;
      }
    }
  }
  /// Registers with a mask.
  int rest() const { return packs - full; }
  /// The register of node i.
  int pack(int i) const { return i % packs; }
  /// Its lane.
  int lane(int i) const { return i / packs; }
};

}  // namespace detail
}  // namespace actio::media
