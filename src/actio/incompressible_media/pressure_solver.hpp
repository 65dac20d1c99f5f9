// The linear equations for the pressures of an incompressible medium, S P = r with S = G M^-1 G^T (chapter
// 10C of the book): their matrix, and the solver by a sparse Cholesky factorization.
//
// Two cells have an entry where they share a node. S is the matrix of minus a Laplacian: of equal squares it
// has entries between diagonal neighbours alone, so that it falls apart into two Laplacians, one on the red
// and one on the black cells of a chessboard.
#pragma once

#include <Eigen/SparseCholesky>

#include "actio/incompressible_media/cell_volumes.hpp"
#include "actio/numbers/errors.hpp"

namespace actio::media {

/// Volumes that are no independent constraints: some combination of them is the same whatever the nodes do,
/// to first order.
struct VolumesNotIndependent : OutsideDomain {
  using OutsideDomain::OutsideDomain;
};

/// Something that solves S P = r, exactly or nearly.
class PressureSolver {
 public:
  /// Held by a medium.
  virtual ~PressureSolver() = default;
  /// From now on the matrix is that of these slopes, of which those of held nodes are projected.
  /// @throws VolumesNotIndependent  where it is singular
  virtual void build(std::vector<double> const& slopes) = 0;
  /// P with S P = r up to a part of r.
  virtual void apply(std::vector<double> const& r, std::vector<double>& P) = 0;
  /// Memory, bytes.
  virtual std::size_t bytes() const = 0;
};

/// The solver by a sparse Cholesky factorization with Eigen's ordering by least degree, on any mesh.
template <class Cell>
class CholeskyPressure final : public PressureSolver {
 public:
  /// @param volumes  of the mesh; has to outlive this
  /// @param masses   of the nodes
  /// @param pinned   whether the volumes of all cells together cannot change: then the pressure of cell 0 is
  ///   zero
  CholeskyPressure(CellVolumes<Cell> const& volumes, std::vector<double> const& masses, bool pinned)
      : volumes_(volumes), pinned_(pinned) {
    inverse_masses_.reserve(masses.size());
    for (double const m : masses) inverse_masses_.push_back(1 / m);
    std::vector<std::vector<int>> at(masses.size());  // corners of cells that are this node
    for (std::size_t cell = 0; cell < volumes.cells(); ++cell)
      for (int b = 0; b < Cell::corners; ++b)
        at[volumes.node(cell, b)].push_back(static_cast<int>(cell) * Cell::corners + b);
    std::vector<Eigen::Triplet<double>> pattern;
    for (auto const& corners : at)
      for (int const one : corners)
        for (int const other : corners)
          if (one / Cell::corners >= other / Cell::corners)
            pattern.emplace_back(one / Cell::corners, other / Cell::corners, 0.0),
                pairs_.push_back({one, other});
    auto const n = static_cast<long>(volumes.cells());
    matrix_.resize(n, n);
    matrix_.setFromTriplets(pattern.begin(), pattern.end());
    for (auto const& pair : pairs_)
      at_.push_back(static_cast<int>(&matrix_.coeffRef(pair[0] / Cell::corners, pair[1] / Cell::corners) -
                                     matrix_.valuePtr()));
    factors_.analyzePattern(matrix_);
  }

  void build(std::vector<double> const& slopes) override {
    constexpr int N = Cell::space;
    std::fill_n(matrix_.valuePtr(), matrix_.nonZeros(), 0.0);
    for (std::size_t k = 0; k < pairs_.size(); ++k) {
      auto const [one, other] = pairs_[k];
      double product = 0;
      for (int a = 0; a < N; ++a)
        product += slopes[std::size_t(one) * N + a] * slopes[std::size_t(other) * N + a];
      matrix_.valuePtr()[at_[k]] +=
          product * inverse_masses_[volumes_.node(one / Cell::corners, one % Cell::corners)];
    }
    if (pinned_) matrix_.coeffRef(0, 0) *= 2;
    factors_.factorize(matrix_);
    double least = HUGE_VAL, most = 0;
    for (long k = 0; k < matrix_.rows(); ++k) {
      double const pivot = factors_.vectorD()[k];
      least = std::min(least, pivot), most = std::max(most, pivot);
    }
    double const bound = 1e-11;
    if (!(least > bound * most))
      throw VolumesNotIndependent(
          "incompressible medium",
          "volumes of cells are independent of each other: with all nodes of the rim prescribed, or an even "
          "count of cells along each of the periodic directions, those of a chessboard are not, and an odd "
          "count or sliding sides help; least over largest pivot",
          least / most, bound);
  }
  void apply(std::vector<double> const& r, std::vector<double>& P) override {
    auto const n = static_cast<long>(r.size());
    P.resize(r.size());
    Eigen::Map<Eigen::VectorXd>(P.data(), n) = factors_.solve(Eigen::Map<Eigen::VectorXd const>(r.data(), n));
  }
  std::size_t bytes() const override {
    return pairs_.capacity() * sizeof(pairs_[0]) + at_.capacity() * sizeof(int) +
           std::size_t(matrix_.nonZeros() + factors_.matrixL().nestedExpression().nonZeros()) *
               (sizeof(double) + sizeof(int));
  }

 private:
  CellVolumes<Cell> const& volumes_;
  bool pinned_;
  std::vector<double> inverse_masses_;
  std::vector<std::array<int, 2>> pairs_;  // corners of two cells that are the same node
  std::vector<int> at_;                    // and the entry to which they add
  Eigen::SparseMatrix<double> matrix_;     // its lower half
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors_;
};

}  // namespace actio::media
