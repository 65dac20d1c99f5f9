// The solver for pressures by multigrid, on a box of quadrilaterals.
#pragma once

#include "actio/incompressible_media/mesh_share.hpp"
#include "actio/incompressible_media/pressure_solver.hpp"
#include "actio/incompressible_media/two_colour_multigrid.hpp"

namespace actio::media {

/// A V-cycle of \ref TwoColourMultigrid for the matrix of the volumes of a box in the plane.
class MultigridPressure final : public PressureSolver {
 public:
  /// Whether there is one for a mesh.
  static bool suits(BodyMesh const& mesh) {
    return mesh.dimension == 2 && mesh.grid[0] >= 2 && mesh.grid[1] >= 2 &&
           TwoColourMultigrid::can_be_coarsened({mesh.grid[0], mesh.grid[1]}, closes(mesh));
  }
  /// @param mesh     which it suits
  /// @param volumes  of the mesh
  /// @param masses   of the nodes
  /// @param share    among ranks
  MultigridPressure(BodyMesh const& mesh, MeshVolumes<PlaneCell> const& volumes,
                    std::vector<double> const& masses, MeshShare const& share)
      : matrix_({mesh.grid[0], mesh.grid[1]}, closes(mesh)),
        shared_(!share.alone() &&
                TwoColourMultigrid::can_be_shared(mesh.grid[1], share.cell_rows.ranks()->size())),
        built_(shared_ ? share.cell_rows.with(3, 3, 1) : Ranges{{0, mesh.grid[1]}}),
        cycle_(best_registers(), shared_ ? share.cell_rows : RowShare()) {
    for (std::size_t cell = 0; cell < volumes.cells(); ++cell)
      for (int b = 0; b < 4; ++b) inverse_masses_.push_back(1 / masses[volumes.node(cell, b)]);
  }

  void build(std::vector<double> const& slopes) override {
    // What two cells have at a node that is corner a of the one and b of the other.
    auto const shared = [&](std::size_t one, int a, std::size_t other, int b) {
      double const *u = slopes.data() + 8 * one + 2 * a, *v = slopes.data() + 8 * other + 2 * b;
      return (u[0] * v[0] + u[1] * v[1]) * inverse_masses_[4 * one + a];
    };
    for_each(built_, [&](std::size_t row) {
      int const j = static_cast<int>(row);
      for (int i = 0; i < matrix_.cells[0]; ++i) {
        std::size_t const k = matrix_.at(i, j);
        double self = 0;
        for (int b = 0; b < 4; ++b) self += shared(k, b, k, b);
        matrix_.self[k] = self;
        bool const right = matrix_.holds(i + 1, j), up = matrix_.holds(i, j + 1),
                   left = matrix_.holds(i - 1, j);
        if (right) {
          std::size_t const east = matrix_.at(i + 1, j);
          matrix_.east[k] = shared(k, 1, east, 0) + shared(k, 3, east, 2);
        }
        if (!up) continue;
        std::size_t const north = matrix_.at(i, j + 1);
        matrix_.north[k] = shared(k, 2, north, 0) + shared(k, 3, north, 1);
        if (right) matrix_.north_east[k] = shared(k, 3, matrix_.at(i + 1, j + 1), 0);
        if (left) matrix_.north_west[k] = shared(k, 2, matrix_.at(i - 1, j + 1), 1);
      }
    });
    cycle_.build(matrix_);
  }
  void apply(std::vector<double> const& r, std::vector<double>& P) override {
    P.resize(r.size());
    cycle_.apply(r.data(), P.data());
  }
  bool is_iterative() const override { return true; }
  bool is_shared() const override { return shared_; }
  std::size_t bytes() const override {
    return 5 * matrix_.size() * sizeof(double) + 4 * matrix_.size() * sizeof(double) +
           30 * matrix_.size() * sizeof(float);
  }

 private:
  NinePointMatrix matrix_;
  bool shared_;
  Ranges built_;  // rows of the matrix
  TwoColourMultigrid cycle_;
  std::vector<double> inverse_masses_;  // at the corners of the first cell, of the second, ...

  static std::array<bool, 2> closes(BodyMesh const& mesh) {
    return {mesh.periods[0] > 0, mesh.periods[1] > 0};
  }
};

}  // namespace actio::media
