// Steps that keep the volume of every cell: SHAKE with one multiplier a cell, the pressure (chapter 10C of
// the book).
//
// The discrete extended section has places y_k at the nodes and a pressure P_k in each cell at every level.
// Its field equations are, with slopes G_k = dA/dy(y_k), forces F_k = -dE/dy(y_k) and masses M,
//
//     v_{k+1/2} = v_{k-1/2} + h M^-1 (F_k + G_k^T P_k),   y_{k+1} = y_k + h v_{k+1/2},   A(y_{k+1}) = A^0.
//
// The last equation determines P_k, the pressure at the time of y_k. The step is solved by a chord iteration:
// the matrix G M^-1 G^T is that of a level some steps ago, and the pressures begin with the parabola through
// the last three.
#pragma once

#include <functional>
#include <memory>
#include <utility>

#include "actio/incompressible_media/mesh_share.hpp"
#include "actio/incompressible_media/multigrid_pressure.hpp"
#include "actio/incompressible_media/pressures_without_push.hpp"
#include "actio/media_on_meshes/body_steps.hpp"

namespace actio::media {

/// A step whose volumes were not reached.
struct VolumesUnsolved : Error {
  double residual;  ///< the largest modulus of A/A^0 - 1; no finite number where the iteration left them
  double bound;     ///< what it had to come under
  /// @param rounds  of the iteration
  VolumesUnsolved(int rounds, double off, double allowed)
      : Error("incompressible medium: after " + std::to_string(rounds) + " rounds the volume of a cell is " +
              (is_finite(off) ? "off by " + show(off) + " of it, more than " + show(allowed) : "no number") +
              "; take a shorter step"),
        residual(off),
        bound(allowed) {}
};

/// Sides all around a medium whose motion changes the volume of the whole.
struct WallsChangeVolume : OutsideDomain {
  using OutsideDomain::OutsideDomain;
};

/// By what pressures are found.
enum class PressureBy {
  best,  ///< multigrid on large boxes in the plane, factors on other meshes there, and in space iteration
  multigrid,  ///< \ref TwoColourMultigrid, on boxes in the plane
  factors     ///< \ref CholeskyPressure, in the plane and on the sphere
};

/// How the volumes of a step are solved for.
struct VolumeSolving {
  double tolerance = 2e-13;  ///< of A/A^0 - 1, the largest modulus over all cells; or rounding of the places
  /// with one matrix: then there is a new one. If so many more gain less than a digit there are its factors,
  /// in the plane, and if those do no better no more rounds
  int most_rounds = 20;
  int rebuilt_after = 10;  ///< steps with one matrix
  /// of a step, after which there is a new one, unless the first step with this one took more than two thirds
  int many_rounds = 8;
  PressureBy by = PressureBy::best;  ///< the solver
  Ranks* ranks = nullptr;            ///< that step the medium together, a box; null: this process is alone
  std::string told = {};             ///< of the medium, to the other ranks (\ref share_parts)
};

/// What a side leaves to the changes of one node: a projection.
template <int N>
struct NodeAllowance {
  int node;                   ///< which
  Matrix<double, N, N> part;  ///< symmetric, its own square
};

/// The volumes of cells at a level, and the pressures that keep them.
template <class Cell>
class VolumeSteps {
 public:
  static constexpr int N = Cell::space;  ///< components of a place
  using Allowance = NodeAllowance<N>;    ///< of a node that is held

  /// @param mesh       of the body
  /// @param reference  places at which each cell has the volume that it keeps
  /// @param density    of each cell
  /// @param held       what sides leave to their nodes
  /// @throws NotABodyMesh  where a cell has no volume or a node no mass
  /// @throws VolumesNotIndependent  where the volumes are no independent constraints but for their sum
  VolumeSteps(BodyMesh const& mesh, SharpPlaces const& reference, std::vector<double> const& density,
              std::vector<Allowance> const& held, VolumeSolving const& solving)
      : volumes(mesh),
        share(mesh, solving.ranks),
        masses(volumes.masses(reference, density)),
        solving_(solving),
        f_(N * masses.size()) {
    volumes.volumes(reference, kept, volumes.all());
    for (std::size_t k = 0; k < kept.size(); ++k)
      if (!(kept[k] > 0))
        throw NotABodyMesh(mesh.cell_name(static_cast<int>(k)), "a cell has a volume", kept[k], 0,
                           static_cast<int>(k));
    for (std::size_t k = 0; k < masses.size(); ++k)
      if (!(masses[k] > 0))
        throw NotABodyMesh("node " + mesh.node_name(static_cast<int>(k)),
                           "a node has mass: its cells are not bent inwards there; mass", masses[k], 0);
    hold(held);
    set_slopes(reference, volumes.all());
    pinned = push_of(mesh, volumes, slopes_, std::vector<double>(kept.size(), 1.0)) <= no_push;
    refuse_chessboards(mesh, volumes, slopes_);
    solver_ = solver_for(mesh);
    rebuild(reference);
  }

  VolumeSteps(VolumeSteps const&) = delete;             ///< The solver refers to the volumes.
  VolumeSteps& operator=(VolumeSteps const&) = delete;  ///< \copydoc VolumeSteps(VolumeSteps const&)

  MeshVolumes<Cell> volumes;   ///< of the mesh
  MeshShare share;             ///< what of it this rank steps
  std::vector<double> masses;  ///< of the nodes
  std::vector<double> kept;    ///< the volume of each cell
  bool pinned = false;         ///< whether the sum of all volumes cannot change: pressures up to a constant
  int rounds = 0;              ///< of the last solution
  bool fell_back = false;      ///< whether cycles did not do, and pressures are found from factors
  SharpPlaces built;           ///< the places of the matrix: with them alone a state goes on bit for bit

  /// The slopes are those at these places, for what follows.
  void set_slopes(SharpPlaces const& y) { set_slopes(y, share.wide); }
  /// The matrix, and the slopes, are those at these places.
  void rebuild(SharpPlaces const& y) {
    set_slopes(y);
    rebuild_at(y);
  }
  /// From now on pressures are found from factors, by a matrix that is to be built.
  void fall_back() {
    if constexpr (Cell::body == 2)
      solver_ = std::make_unique<CholeskyPressure<Cell>>(volumes, masses, pinned);
    fell_back = true;
  }
  /// v += scale M^-1 G^T P.
  void push(std::vector<double> const& pressure, double scale, std::vector<double>& v) {
    for_each(share.moved, [&](std::size_t k) { std::fill_n(f_.data() + N * k, N, 0.0); });
    volumes.push(slopes_, pressure, scale, f_, share.near);
    for_each(share.moved, [&](std::size_t node) {
      for (std::size_t k = N * node; k < N * (node + 1); ++k) v[k] += f_[k] / masses[node];
    });
  }
  /// Pressures P for which the velocities v + scale M^-1 G^T P lead to places with the volumes that are kept.
  /// @param place  the places, given velocities: a callable (v, y)
  /// @param h      how much places change with velocities, about
  /// @param from   the places of the slopes
  /// @param P      a guess, and then the solution
  /// @param v      velocities without the pressure, and then with it
  /// @param y      the places
  /// @return the largest modulus of A/A^0 - 1: within the tolerance, or within the rounding of places
  /// @throws VolumesUnsolved  where the iteration does not come there
  template <class Place>
  double solve(Place const& place, double scale, double h, SharpPlaces const& from, std::vector<double>& P,
               std::vector<double>& v, SharpPlaces& y) {
    without_.resize(v.size());
    copy_moved(v, without_);
    bool fresh = false;
    double last = HUGE_VAL, before = HUGE_VAL;  // the defect of the last round, and `most_rounds` ago
    for (rounds = 1;; ++rounds) {
      push(P, scale, v);
      place(v, y);
      double const off = defects(y, r_);
      if (off <= solving_.tolerance || (off >= 0.5 * last && off <= rounding())) return off;
      bool const lost = !is_finite(off);
      if (lost || rounds % solving_.most_rounds == 0) {
        // A matrix of these places; if rounds gain less than a digit with it, its factors; and no more.
        bool const slow = !(off <= 0.1 * std::exchange(before, off));
        if (lost || (fresh && slow && !can_fall_back()))
          throw VolumesUnsolved(rounds, off, solving_.tolerance);
        if (fresh && slow) fall_back();
        if (!fresh || slow) rebuild_at(from), fresh = true;
      }
      last = off;
      if (pinned) share_out(r_, solving_.tolerance);
      apply();
      for_each(share.near, [&](std::size_t k) { P[k] -= more_[k] / (scale * h); });
      copy_moved(without_, v);
    }
  }
  /// Takes from velocities at the places of the slopes what changes volumes: v -= M^-1 G^T Q with G v = 0.
  /// @param whole  slopes without the projection of held nodes
  void project(std::vector<double> const& whole, std::vector<double>& v) {
    double last = HUGE_VAL;
    for (int round = 0; round < 100; ++round) {
      volumes.rates(whole, v, r_, share.cells);
      double size = 0;
      for_each(share.cells, [&](std::size_t k) { size = std::max(size, std::abs(r_[k]) / kept[k]); });
      size = share.cell_rows.most(size);
      if (size == 0 || !(size < 0.5 * last)) return;
      last = size;
      if (pinned) share_out(r_, HUGE_VAL);
      apply();
      push(more_, -1, v);
    }
  }
  /// A - A^0 of cells.
  /// @return the largest modulus of A/A^0 - 1 of all ranks; no finite number where a place is none
  double defects(SharpPlaces const& y, std::vector<double>& r) const {
    volumes.volumes(y, r, share.cells);
    double most = 0;
    for_each(share.cells, [&](std::size_t k) {
      r[k] -= kept[k];
      double const off = std::abs(r[k]) / kept[k];
      if (!(off <= most)) most = is_finite(off) ? off : HUGE_VAL;
    });
    return share.cell_rows.most(most);
  }
  /// Memory, bytes.
  std::size_t bytes() const {
    return volumes.bytes() + solver_->bytes() +
           (masses.size() + kept.size() + slopes_.size()) * sizeof(double);
  }

 private:
  VolumeSolving solving_;
  std::vector<Allowance> parts_;
  std::vector<std::pair<std::size_t, Matrix<double, N, N> const*>> held_;  // corners of cells at held nodes
  std::vector<double> slopes_;
  std::unique_ptr<PressureSolver> solver_;
  std::vector<double> f_, without_, r_, more_;  // room

  void set_slopes(SharpPlaces const& y, Ranges const& of) {
    volumes.slopes(y, slopes_, of);
    for (auto const& [corner, part] : held_) {
      double* slope = slopes_.data() + corner * N;
      double const given[] = {slope[0], slope[1], slope[N - 1]};
      for (int a = 0; a < N; ++a) {
        slope[a] = 0;
        for (int b = 0; b < N; ++b) slope[a] += (*part)(a, b) * given[b];
      }
    }
  }
  /// The matrix is that of the slopes, which are those of these places.
  void rebuild_at(SharpPlaces const& y) {
    if (!solver_->is_shared()) share.cell_rows.whole(std::span(slopes_));
    solver_->build(slopes_), built = y;
  }
  /// more_: pressures for the defects r_, in the rows of this rank and one around.
  void apply() {
    if (solver_->is_shared())
      share.cell_rows.exchange(std::span(r_), 1);
    else
      share.cell_rows.whole(std::span(r_));
    solver_->apply(r_, more_);
  }
  void copy_moved(std::vector<double> const& from, std::vector<double>& to) const {
    for (RowRange const& range : share.moved)
      std::copy_n(from.data() + N * range.from, N * range.count(), to.data() + N * range.from);
  }

  bool can_fall_back() const { return Cell::body == 2 && solver_->is_iterative() && !fell_back; }
  std::unique_ptr<PressureSolver> solver_for(BodyMesh const& mesh) const {
    constexpr std::size_t many = 1000;  // cells from which on cycles cost less than factors
    if constexpr (std::is_same_v<Cell, PlaneCell>) {
      bool const suits = MultigridPressure::suits(mesh);
      if (solving_.by == PressureBy::multigrid && !suits)
        throw NotABodyMesh(
            "multigrid for pressures",
            "a mesh is a box of two cells at least along each direction, a multiple of four along "
            "a periodic one; cells along the first",
            mesh.grid[0], 2);
      if (suits &&
          (solving_.by == PressureBy::multigrid || (solving_.by == PressureBy::best && kept.size() >= many)))
        return std::make_unique<MultigridPressure>(mesh, volumes, masses, share);
    }
    if constexpr (Cell::body == 2)
      return std::make_unique<CholeskyPressure<Cell>>(volumes, masses, pinned);
    else
      return std::make_unique<ConjugatePressure<Cell>>(volumes, masses, pinned);
  }
  void hold(std::vector<Allowance> const& held) {
    std::vector<int> at(masses.size(), -1);
    parts_ = held;
    for (std::size_t k = 0; k < held.size(); ++k) at[held[k].node] = static_cast<int>(k);
    for (std::size_t cell = 0; cell < volumes.cells(); ++cell)
      for (int b = 0; b < Cell::corners; ++b)
        if (int const part = at[volumes.node(cell, b)]; part >= 0)
          held_.push_back({cell * Cell::corners + b, &parts_[part].part});
  }
  /// Takes from defects of all volumes the part of each in their sum, which no pressure can mend: rounding,
  /// or what walls do.
  /// @param bound  of that part over the volume
  /// @throws WallsChangeVolume  where it is more
  void share_out(std::vector<double>& r, double bound) const {
    double const part =
        share.sum([&](std::size_t k) { return r[k]; }) / share.sum([&](std::size_t k) { return kept[k]; });
    if (!(std::abs(part) <= bound))
      throw WallsChangeVolume("incompressible medium",
                              "sides that are held or moved on all sides keep the volume of the whole; they "
                              "change it by",
                              part, bound);
    for_each(share.cells, [&](std::size_t k) { r[k] -= part * kept[k]; });
  }
  /// By how much rounding may change A/A^0: of places on a curved target, of the volume itself on a flat one.
  double rounding() const {
    double most = 0;
    for_each(share.cells, [&](std::size_t cell) {
      double sum = 0;
      for (int k = 0; k < Cell::corners * N; ++k) sum += std::abs(slopes_[cell * Cell::corners * N + k]);
      double const size = Cell::flat ? std::pow(kept[cell], 1.0 / Cell::body) : 1;
      most = std::max(most, sum * size / kept[cell]);
    });
    most = share.cell_rows.most(most);
    return 8 * std::numeric_limits<double>::epsilon() * most;
  }
};

}  // namespace actio::media
