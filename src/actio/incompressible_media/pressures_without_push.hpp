// Pressures that push no node of an incompressible medium: those that are the same in all cells, where
// nothing changes the volume of the whole, and those of a chessboard, with which no step can be solved.
#pragma once

#include "actio/incompressible_media/mesh_volumes.hpp"
#include "actio/incompressible_media/pressure_solver.hpp"

namespace actio::media {

/// The bound of \ref push_of below which pressures are said to push no node.
inline constexpr double no_push = 1e-9;

/// The largest force of these pressures on a node, over the largest slope.
/// @param slopes  of the volumes, as \ref MeshVolumes has them, without what held nodes may not do
template <class Cell>
double push_of(BodyMesh const& mesh, MeshVolumes<Cell> const& volumes, std::vector<double> const& slopes,
               std::vector<double> const& pressure) {
  std::vector<double> f(mesh.nodes.size() * Cell::space, 0);
  volumes.push(slopes, pressure, 1, f, volumes.all());
  double most = 0, slope = 0;
  for (double const one : f) most = std::max(most, std::abs(one));
  for (double const one : slopes) slope = std::max(slope, std::abs(one));
  return most / slope;
}

/// Refuses boxes in which nothing changes the sum of volumes on white less that on black cells, of a
/// chessboard along two or three directions.
/// @throws VolumesNotIndependent
template <class Cell>
void refuse_chessboards(BodyMesh const& mesh, MeshVolumes<Cell> const& volumes,
                        std::vector<double> const& slopes) {
  if (mesh.grid[0] == 0) return;
  for (int axes = 1; axes < 1 << mesh.dimension; ++axes) {
    if ((axes & (axes - 1)) == 0) continue;  // one direction alone
    std::vector<double> board;
    for (int cell = 0; cell < static_cast<int>(volumes.cells()); ++cell) {
      int const at[] = {cell % mesh.grid[0], cell / mesh.grid[0] % mesh.grid[1],
                        cell / mesh.grid[0] / mesh.grid[1]};
      int sum = 0;
      for (int k = 0; k < mesh.dimension; ++k) sum += axes >> k & 1 ? at[k] : 0;
      board.push_back(sum % 2 == 0 ? 1 : -1);
    }
    double const push = push_of(mesh, volumes, slopes, board);
    if (push <= no_push)
      throw VolumesNotIndependent(
          "incompressible medium",
          "pressures alternating from cell to cell push the nodes, which they do not "
          "where all nodes of the rim are prescribed, or all counts of cells are even "
          "along periodic directions: an odd count or sliding sides help; largest "
          "force over that of one cell",
          push, no_push);
  }
}

}  // namespace actio::media
