// The linear equations for the pressures of an incompressible medium, S P = r with S = G M^-1 G^T (chapter
// 10C of the book): their matrix, and the solver by a sparse Cholesky factorization.
//
// Two cells have an entry where they share a node. S is the matrix of minus a Laplacian: of equal squares it
// has entries between diagonal neighbours alone, so that it falls apart into two Laplacians, one on the red
// and one on the black cells of a chessboard.
#pragma once

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCholesky>

#include "actio/incompressible_media/mesh_volumes.hpp"
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
  /// Whether it may be slow where cells are far from squares.
  virtual bool is_iterative() const { return false; }
  /// Whether ranks share its work: then each gives slopes in its rows of cells, three below and four above, r
  /// in its rows and one around, and has P there. If not, each gives all, and finds all.
  virtual bool is_shared() const { return false; }
  /// Memory, bytes.
  virtual std::size_t bytes() const = 0;
};

/// The matrix S on any mesh: its lower half, and where each pair of corners adds to it.
template <class Cell>
class PressureMatrix {
 public:
  /// @param volumes  of the mesh
  /// @param masses   of the nodes
  /// @param pinned   whether the volumes of all cells together cannot change: then the pressure of cell 0 is
  ///   zero, by a second time its entry of the diagonal
  PressureMatrix(MeshVolumes<Cell> const& volumes, std::vector<double> const& masses, bool pinned)
      : pinned_(pinned) {
    constexpr int corners = Cell::corners;
    std::vector<std::vector<int>> at(masses.size());  // corners of cells that are this node
    for (std::size_t cell = 0; cell < volumes.cells(); ++cell)
      for (int b = 0; b < corners; ++b)
        at[volumes.node(cell, b)].push_back(static_cast<int>(cell) * corners + b);
    std::vector<Eigen::Triplet<double>> pattern;
    for (std::size_t node = 0; node < at.size(); ++node)
      for (int const one : at[node])
        for (int const other : at[node])
          if (one / corners >= other / corners) {
            pattern.emplace_back(one / corners, other / corners, 0.0);
            pairs_.push_back({one, other, 0, 1 / masses[node]});
          }
    auto const n = static_cast<long>(volumes.cells());
    values.resize(n, n);
    values.setFromTriplets(pattern.begin(), pattern.end());
    for (auto& pair : pairs_)
      pair.entry =
          static_cast<int>(&values.coeffRef(pair.one / corners, pair.other / corners) - values.valuePtr());
  }
  /// The matrix of these slopes.
  void fill(std::vector<double> const& slopes) {
    constexpr int N = Cell::space;
    std::fill_n(values.valuePtr(), values.nonZeros(), 0.0);
    for (auto const& pair : pairs_) {
      double product = 0;
      for (int a = 0; a < N; ++a)
        product += slopes[std::size_t(pair.one) * N + a] * slopes[std::size_t(pair.other) * N + a];
      values.valuePtr()[pair.entry] += product * pair.inverse_mass;
    }
    if (pinned_) values.coeffRef(0, 0) *= 2;
  }
  /// Memory, bytes.
  std::size_t bytes() const {
    return pairs_.capacity() * sizeof(pairs_[0]) +
           std::size_t(values.nonZeros()) * (sizeof(double) + sizeof(int));
  }

  Eigen::SparseMatrix<double> values;  ///< the lower half

 private:
  struct Pair {
    int one, other, entry;  // corners of two cells that are the same node, and the entry to which they add
    double inverse_mass;
  };
  bool pinned_;
  std::vector<Pair> pairs_;
};

/// The solver by a sparse Cholesky factorization with Eigen's ordering by least degree: for the plane, where
/// factors have few entries.
template <class Cell>
class CholeskyPressure final : public PressureSolver {
 public:
  /// @param volumes, masses, pinned  as for \ref PressureMatrix
  CholeskyPressure(MeshVolumes<Cell> const& volumes, std::vector<double> const& masses, bool pinned)
      : matrix_(volumes, masses, pinned) {
    factors_.analyzePattern(matrix_.values);
  }
  void build(std::vector<double> const& slopes) override {
    matrix_.fill(slopes);
    factors_.factorize(matrix_.values);
    double least = HUGE_VAL, most = 0;
    for (long k = 0; k < matrix_.values.rows(); ++k) {
      double const pivot = factors_.vectorD()[k];
      least = std::min(least, pivot), most = std::max(most, pivot);
    }
    double const bound = 1e-11;
    if (!(least > bound * most))
      throw VolumesNotIndependent("incompressible medium",
                                  "volumes of cells are independent of each other; least over largest pivot",
                                  least / most, bound);
  }
  void apply(std::vector<double> const& r, std::vector<double>& P) override {
    auto const n = static_cast<long>(r.size());
    P.resize(r.size());
    Eigen::Map<Eigen::VectorXd>(P.data(), n) = factors_.solve(Eigen::Map<Eigen::VectorXd const>(r.data(), n));
  }
  std::size_t bytes() const override {
    return matrix_.bytes() +
           std::size_t(factors_.matrixL().nestedExpression().nonZeros()) * (sizeof(double) + sizeof(int));
  }

 private:
  PressureMatrix<Cell> matrix_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors_;
};

/// The solver by conjugate gradients with an incomplete Cholesky factorization, to a hundredth of the right
/// side: for space, where complete factors fill up.
template <class Cell>
class ConjugatePressure final : public PressureSolver {
 public:
  /// @param volumes, masses, pinned  as for \ref PressureMatrix
  ConjugatePressure(MeshVolumes<Cell> const& volumes, std::vector<double> const& masses, bool pinned)
      : matrix_(volumes, masses, pinned) {
    iteration_.setTolerance(0.01);
    iteration_.setMaxIterations(500);
  }
  void build(std::vector<double> const& slopes) override {
    matrix_.fill(slopes);
    iteration_.compute(matrix_.values);
  }
  void apply(std::vector<double> const& r, std::vector<double>& P) override {
    auto const n = static_cast<long>(r.size());
    P.resize(r.size());
    Eigen::Map<Eigen::VectorXd>(P.data(), n) =
        iteration_.solve(Eigen::Map<Eigen::VectorXd const>(r.data(), n));
  }
  std::size_t bytes() const override { return 2 * matrix_.bytes(); }

 private:
  PressureMatrix<Cell> matrix_;
  Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::IncompleteCholesky<double>>
      iteration_;
};

}  // namespace actio::media
