// Multigrid for the pressures of an incompressible medium on a box of quadrilaterals.
#pragma once

#include <memory>

#include "actio/incompressible_media/nine_point_matrix.hpp"
#include "actio/numbers/registers.hpp"
#include "actio/parallel/row_share.hpp"

namespace actio::media {

/// An approximate inverse B of the pressure matrix S of a box: one V-cycle of multigrid, made for its two
/// colours.
///
/// S couples the cells of undeformed squares like the bishops of a chess board, so each colour is coarsened
/// by itself along the diagonals, with bilinear interpolation and \f$P^TSP\f$; on each lattice one sweep of
/// Gauss-Seidel goes before the coarse correction and one, in the reverse order, after it. So B is symmetric
/// and positive definite, and of use to conjugate gradients. Sites that are swept together do not act on each
/// other: the result does not depend on the order in which they are taken. The hierarchy is in single
/// precision; the residual of what is solved has to be taken in double.
///
/// A matrix all of whose rows have the sum zero, that of a box closed by walls, is singular. Then r must sum
/// to zero, up to rounding, and delta is found up to a constant. Where just one row has another sum, because
/// the pressure of its cell is pinned, the solution is that of the pinned matrix, as fast as for the singular
/// one.
///
/// \snippet media.cpp two_colour_multigrid
///
/// Accuracy: a cycle multiplies the energy norm \f$\sqrt{e^TSe}\f$ of the error by at most 0.24 to 0.35 on
/// undeformed cells with free sides, from 32 to 256 cells along a side; by 0.5 to 0.7 in a box with walls,
/// and by 0.68 to 0.8 where cells are stretched by 1.6 and sheared by a half. The first cycle reaches 0.06 to
/// 0.17. Conjugate gradients take 10, 18 and 23 cycles for ten digits. Where cells are stretched by more than
/// 3, use a direct solver.
class TwoColourMultigrid {
 public:
  /// Whether a box of these cells has a coarser lattice: along a periodic direction their number must be a
  /// multiple of four. The more often it can be halved, the better.
  static bool can_be_coarsened(std::array<int, 2> cells, std::array<bool, 2> periodic);

  /// Whether a box of so many rows of cells can be shared by so many ranks: the finest lattice is, and
  /// coarser ones down to where each rank would have a few rows.
  static bool can_be_shared(int rows, int ranks);

  /// Cycles that are compiled for these registers.
  /// @param rows  of cells, that ranks share; by default this process is alone. All ranks then make the same
  ///   calls. Of the matrix each has its own rows and three around them, of r its own and one, and delta is
  ///   found for its own and one.
  explicit TwoColourMultigrid(Registers registers = best_registers(), RowShare rows = {});
  TwoColourMultigrid(TwoColourMultigrid&&) noexcept;             ///< with its hierarchy
  TwoColourMultigrid& operator=(TwoColourMultigrid&&) noexcept;  ///< with its hierarchy
  ~TwoColourMultigrid();                                         ///< with its hierarchy

  /// Makes the hierarchy of a matrix, which is not kept.
  ///
  /// @param matrix  positive definite, or positive semidefinite with the constants as its kernel
  /// @throws OutsideDomain  where the box cannot be coarsened, or an entry of the diagonal is not positive
  /// @throws NotFinite      where an entry is no number
  /// @throws Singular       where the coarsest matrix has no factors
  void build(NinePointMatrix const& matrix);
  /// delta = B r: one V-cycle for S delta = r from zero.
  ///
  /// @param r      an entry for each cell; where one is no number, neither is delta
  /// @param delta  the same; may be r
  void apply(double const* r, double* delta);

 private:
  struct Hierarchy;
  std::unique_ptr<Hierarchy> hierarchy_;
};

}  // namespace actio::media
