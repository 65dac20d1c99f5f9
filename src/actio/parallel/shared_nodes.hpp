// Nodes that several ranks share: each has some of them, and copies of those that lie around them.
//
//     SharedNodes const shared(ranks, mesh.nodes, mesh.cells, 4);
//     ... forces on shared.nodes() by shared.cells() ...
//     shared.complete(forces);  // of the copies, from the ranks that have them
//
// A rank has all cells that touch a node of its own, in increasing order, so that a sum over the cells of
// this node has the same terms in the same order as on one rank. Of other nodes it has what their ranks say.
#pragma once

#include <array>
#include <vector>

#include "actio/numbers/errors.hpp"
#include "actio/parallel/ranks.hpp"

namespace actio {

/// Which rank has each node: about equally many, by halves across the longest direction. The same everywhere.
std::vector<int> owners_of_nodes(std::vector<std::array<double, 3>> const& places, int ranks);

/// The nodes that this rank has and copies, with those of the others that copy from it or to it.
class SharedNodes {
 public:
  using Cells = std::vector<std::array<int, 8>>;  ///< the nodes at the corners of each

  /// The part of a mesh on this rank.
  /// @param ranks    outlive it
  /// @param places   of all nodes
  /// @param cells    all of them
  /// @param corners  of a cell
  SharedNodes(Ranks& ranks, std::vector<std::array<double, 3>> const& places, Cells const& cells,
              int corners);

  Ranks& ranks() const { return ranks_; }                   ///< that share them
  std::vector<int> const& nodes() const { return nodes_; }  ///< numbers of those that are here, increasing
  std::vector<int> const& cells() const { return cells_; }  ///< numbers of the cells here, increasing
  bool own(std::size_t here) const { return own_[here]; }   ///< whether one of those is no copy

  /// @throws Error  on all ranks, where they have not been given the same places and cells
  void require_same() const;
  /// Copies of values get those that their ranks have.
  /// @param values  of the nodes here, equally many of each
  void complete(std::vector<double>& values) const;
  /// The values of all nodes, on rank 0.
  /// @param here  of the nodes here
  /// @param all   as they are on rank 0; empty elsewhere
  void gather(std::vector<double> const& here, std::vector<double>& all) const;
  /// The other way round, with copies.
  void scatter(std::vector<double> const& all, std::vector<double>& here) const;

 private:
  Ranks& ranks_;
  double fingerprint_;  // of places and cells
  std::vector<int> nodes_, cells_;
  std::vector<bool> own_;
  std::vector<std::vector<int>> sent_, received_;  // nodes here, by the rank to which or from which
  std::vector<int> own_nodes_;                     // here
  std::vector<int> order_;                         // on rank 0: all nodes, by their ranks

  template <class T>
  static std::size_t width(std::vector<double> const& values, std::vector<T> const& nodes) {
    return nodes.empty() ? 0 : values.size() / nodes.size();
  }
  /// The values of some nodes one after the other.
  static std::vector<double> taken(std::vector<double> const& from, std::vector<int> const& nodes,
                                   std::size_t width);
  static void put(std::vector<double> const& values, std::vector<int> const& nodes, std::size_t width,
                  std::vector<double>& to);
};

}  // namespace actio
