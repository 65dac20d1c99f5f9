// Which cells and nodes of a box one rank computes, where several step an incompressible medium together
// (chapter 10C of the book).
//
// A rank moves the nodes of its rows and of the first row above: so it finds the volumes of its own cells
// without asking. From its neighbours it copies pressures of a row of cells on both sides with each round of
// a step, and places of some rows of nodes after it. Every rank has room for the whole medium.
#pragma once

#include "actio/meshes/body_mesh.hpp"
#include "actio/numbers/errors.hpp"
#include "actio/parallel/row_share.hpp"

namespace actio::media {

/// A mesh that ranks share by the rows of cells of its last direction, or that one process has alone.
struct MeshShare {
  RowShare cell_rows;    ///< rows of cells
  RowShare node_rows;    ///< rows of nodes: those below each row of cells, and the last one
  int cells_in_row = 1;  ///< numbers of cells in a row
  int nodes_in_row = 1;  ///< of nodes
  Ranges cells;          ///< of this rank
  Ranges near;           ///< cells at nodes that this rank moves
  Ranges wide;           ///< cells whose slopes the rows of its matrix take
  Ranges nodes;          ///< of this rank
  Ranges moved;          ///< that it moves: its own, and the first row above
  Ranges around;         ///< of the cells in `near`

  /// Rows of nodes that are copied on both sides after a step: all of those that `wide` has.
  static constexpr int copied = 5;
  /// Rows of cells that a rank has at least.
  static constexpr int fewest = 8;

  /// @param ranks  null: this process is alone
  /// @throws OutsideDomain  where there are ranks, and the mesh is no box or has too few rows
  MeshShare(BodyMesh const& mesh, Ranks* ranks) {
    int const cell_count = static_cast<int>(mesh.cells.size()),
              node_count = static_cast<int>(mesh.nodes.size());
    auto const last = static_cast<std::size_t>(mesh.dimension - 1);
    bool const box = mesh.grid[0] > 0, round = box && mesh.periods[last] > 0;
    int const rows = box ? mesh.grid[last] : cell_count;
    if (int const several = ranks ? ranks->size() : 1; several > 1 && (!box || rows < fewest * several))
      throw OutsideDomain("incompressible medium",
                          "ranks share boxes, with eight rows of cells or more for each rank along the last "
                          "direction; rows",
                          box ? rows : 0, fewest * several);
    cell_rows = RowShare(ranks, rows, round);
    auto cuts = cell_rows.cuts();
    cuts.back() = box ? rows + !round : node_count;
    node_rows = RowShare(ranks, cuts, round);
    cells_in_row = cell_count / rows, nodes_in_row = node_count / node_rows.rows();
    cells = cell_rows.with(0, 0, cells_in_row), near = cell_rows.with(1, 1, cells_in_row);
    wide = cell_rows.with(3, 4, cells_in_row);
    nodes = node_rows.with(0, 0, nodes_in_row), moved = node_rows.with(0, 1, nodes_in_row);
    around = node_rows.with(1, 2, nodes_in_row);
  }

  bool alone() const { return cell_rows.alone(); }  ///< whether there are no other ranks
  /// The sum over all cells of f(cell), row by row.
  template <class F>
  double sum(F const& f) const {
    return cell_rows.sum([&](int j) {
      double sum = 0;
      for (int i = 0; i < cells_in_row; ++i) sum += f(static_cast<std::size_t>(j) * cells_in_row + i);
      return sum;
    });
  }
};

}  // namespace actio::media
