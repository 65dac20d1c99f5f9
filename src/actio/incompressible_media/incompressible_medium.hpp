// An incompressible fluid or body on a mesh, in the plane or in space (chapters 7 and 8 of the thesis,
// chapter 10C of the book).
//
//     IncompressibleStart<2> cells;
//     cells.velocity = [](auto const& X) {
//       return std::array{std::sin(X[0]) * std::cos(X[1]), -std::cos(X[0]) * std::sin(X[1])};
//     };
//     cells.project = true;
//     IncompressibleMedium<2> water(box_mesh({0, 0}, {pi, pi}, {32, 32}), {}, cells, 0.01,
//                                   {{"left", {Side::sliding}}, ...});
//     water.step(100);
//     water.pressures();
//
// Places and pressures have order 2 in space and time; the volume of each cell is kept to rounding, momenta
// are where sides and loads allow it, and the multisymplectic form is. Nothing resists the shear of a fluid:
// a cell may fold while its volume is kept, and that is refused.
#pragma once

#include "actio/incompressible_media/cell_weight.hpp"
#include "actio/incompressible_media/incompressible_motion.hpp"

namespace actio::media {

/// An incompressible medium at the start.
template <int d>
struct IncompressibleStart : BodyStart<d> {
  bool project = false;  ///< whether what changes volumes is taken from placement and velocity
  /// Uniform gravity, acceleration: the weight acts on cells, where potentials among loads act on nodes.
  std::array<double, d> gravity = {};
};

namespace detail {
template <int d>
struct FlatCell;
template <>
struct FlatCell<2> {
  using Type = PlaneCell;
};
template <>
struct FlatCell<3> {
  using Type = SpaceCell;
};
}  // namespace detail

/// The energy of a fluid that stores none.
template <int d>
std::shared_ptr<StoredEnergy<d> const> no_stored_energy() {
  return stored_energy<d>([](auto const& F) { return typename std::decay_t<decltype(F)>::Scalar(0); });
}

/// An incompressible fluid or body on a mesh of quadrilaterals or hexahedra.
template <int d>
class IncompressibleMedium final : public IncompressibleMotion<typename detail::FlatCell<d>::Type> {
 public:
  using Cell = typename detail::FlatCell<d>::Type;     ///< of the mesh
  using Base = IncompressibleMotion<Cell>;             ///< steps and state
  using Place = std::array<double, d>;                 ///< a point, or a vector
  using Law = std::shared_ptr<StoredEnergy<d> const>;  ///< what a body stores

  /// @param mesh   of the body; reference volumes are those that are kept
  /// @param law    the stored energy; none: a fluid. W(J) may be in it: pressure is then the sum of both
  /// @param start  density per reference volume, placement and velocity
  /// @param step   the time step
  /// @throws NotABodyMesh, UnknownSide, NotFinite, NotADensity  where these do not fit together
  /// @throws VolumesNotIndependent  where all nodes of the rim are prescribed, or all counts around are even
  /// @throws StartChangesVolumes  where the start does and is not to be projected
  IncompressibleMedium(BodyMesh mesh, Law law, IncompressibleStart<d> const& start, double step,
                       BodySides<d> const& sides = {}, BodyLoads<d> const& loads = {},
                       VolumeSolving const& solving = {})
      : IncompressibleMedium(std::make_unique<BodyMesh>(std::move(mesh)), std::move(law), start, step, sides,
                             loads, solving) {}

  /// The mesh of the body.
  BodyMesh const& mesh() const { return *mesh_; }
  /// Kinetic and stored energy, and that of loads, now.
  BodyEnergies energies() {
    double loads = forces_.of_loads(this->y());
    double at[Cell::corners][d];
    for (std::size_t cell = 0; weight_.any() && cell < this->cells().cells(); ++cell)
      this->cells().gather(this->y(), cell, at), loads += weight_.of_cell(cell, at, nullptr);
    return {this->kinetic_energy(), stores_ ? forces_.stored(this->y()) : 0, loads};
  }
  /// An estimate of the largest frequency of small motions now, per time: of what is stored, from below
  /// within half a per cent, and of waves that weight drives along free sides, whose squares are taken as 2
  /// |g| over the shortest edge. A test holds that a tank of squares is stable in steps of nine tenths of two
  /// over it, and not in steps of three over it.
  double largest_frequency() const {
    double const elastic = stores_ ? largest_frequency_of(forces_, held_, this->y()) : 0;
    return std::sqrt(elastic * elastic + 2 * weight_.strength() / shortest_edge());
  }
  /// The shortest edge of a cell now, length.
  double shortest_edge() const {
    double shortest = HUGE_VAL, at[Cell::corners][d];
    for (std::size_t cell = 0; cell < this->cells().cells(); ++cell) {
      this->cells().gather(this->y(), cell, at);
      for (int b = 0; b < Cell::corners; ++b)
        for (int k = 0; k < d; ++k) {
          double square = 0;
          for (int a = 0; a < d; ++a) square += std::pow(at[b ^ 1 << k][a] - at[b][a], 2);
          shortest = std::min(shortest, square);
        }
    }
    return std::sqrt(shortest);
  }

 private:
  std::unique_ptr<BodyMesh> mesh_;
  HeldNodes<d> held_;
  bool stores_;
  BodyForces<d> forces_;
  CellWeight<d> weight_;
  double outside_;  // pressure, on the whole body

  IncompressibleMedium(std::unique_ptr<BodyMesh> mesh, Law law, IncompressibleStart<d> const& start,
                       double step, BodySides<d> const& sides, BodyLoads<d> const& loads,
                       VolumeSolving const& solving)
      : Base(*mesh, reference_of(*mesh), densities(*mesh, start), allowances(HeldNodes<d>(*mesh, sides)),
             step, solving),
        mesh_(std::move(mesh)),
        held_(*mesh_, sides),
        stores_(law != nullptr),
        forces_(*mesh_, law ? std::move(law) : no_stored_energy<d>(), start.density, without_outside(loads)),
        weight_(*mesh_, start.gravity, densities(*mesh_, start)),
        outside_(loads.outside_pressure) {
    forces_.body.masses = this->masses();
    std::vector<double> y, v;
    for (std::size_t k = 0; k < mesh_->nodes.size(); ++k) {
      Place X;
      std::copy_n(mesh_->nodes[k].begin(), d, X.begin());
      Place const place = start.placement(X), rate = start.velocity(X);
      for (int a = 0; a < d; ++a) {
        if (!is_finite(place[a]) || !is_finite(rate[a]))
          throw NotFinite("medium: placement and velocity of node " + mesh_->node_name(static_cast<int>(k)));
        y.push_back(place[a]), v.push_back(rate[a]);
      }
    }
    held_.put_places(y, 0);
    this->start(std::move(y), std::move(v), start.project);
  }

  bool forces(std::vector<double> const& y, double t, std::vector<double>& f) const override {
    MeshShare const& share = this->share();
    bool failed = false;
    try {
      if (stores_) {
        failed = !(forces_.forces(y, t, f, {}, {share.near, share.around}).jacobian > 0);
      } else {
        f.resize(y.size());
        for_each(share.around, [&](std::size_t k) { std::fill_n(f.data() + d * k, d, 0.0); });
        forces_.loads.add_forces(forces_.body, y, t, f, share.around);
      }
    } catch (std::exception const&) {
      if (share.alone()) throw;
      failed = true;
    }
    if (share.cell_rows.any(failed)) refuse_forces(y, t, f);
    double at[Cell::corners][d], on[Cell::corners][d];
    if (weight_.any())
      for_each(share.near, [&](std::size_t cell) {
        this->cells().gather(y, cell, at);
        std::fill_n(&on[0][0], Cell::corners * d, 0.0);
        weight_.of_cell(cell, at, on);
        for (int b = 0; b < Cell::corners; ++b)
          for (int a = 0; a < d; ++a) f[std::size_t(d) * this->cells().node(cell, b) + a] += on[b][a];
      });
    held_.restrict_to_allowed(f);
    return true;
  }
  /// Throws on all ranks what forces on the whole body throw.
  void refuse_forces(std::vector<double> y, double t, std::vector<double>& f) const {
    this->share().node_rows.whole(std::span(y));
    if (stores_)
      if (LeastJacobian const least = forces_.forces(y, t, f); !(least.jacobian > 0))
        throw BodyCellInverts(least.cell, mesh_->cell_name(least.cell), least.jacobian, {});
    f.assign(y.size(), 0);
    forces_.loads.add_forces(forces_.body, y, t, f);
  }
  void take_weight(std::vector<double>& pressure) const override {
    double at[Cell::corners][d];
    for (std::size_t cell = 0; weight_.any() && cell < pressure.size(); ++cell) {
      this->cells().gather(this->y(), cell, at);
      pressure[cell] -= weight_.of_cell(cell, at, nullptr) / Cell::volume(at);
    }
    // From outside it does no work on a body of fixed volume.
    for (double& one : pressure) one += outside_;
  }
  void move(SharpPlaces const& from, double h, double t, std::vector<double>& v,
            SharpPlaces& to) const override {
    to.y.resize(v.size()), to.rest.resize(v.size());
    for_each(this->share().moved, [&](std::size_t node) {
      for (std::size_t k = d * node; k < d * (node + 1); ++k) {
        to.y[k] = from.y[k], to.rest[k] = from.rest[k];
        detail::add_with_rest(to.y[k], to.rest[k], h * v[k]);
      }
    });
    if (!held_.any_moved()) return;
    held_.put_places(to.y, t);
    held_.for_moved([&](int node) {
      for (int a = 0; a < d; ++a) {
        std::size_t const k = std::size_t(d) * node + a;
        v[k] = (to.y[k] - from.y[k]) / h, to.rest[k] = 0;
      }
    });
  }
  void tangent(std::vector<double> const&, double t, std::vector<double>& v) const override {
    if (held_.any_moved()) held_.put_velocities(v, t);
  }

  static BodyLoads<d> without_outside(BodyLoads<d> loads) {
    loads.outside_pressure = 0;
    return loads;
  }
  static SharpPlaces reference_of(BodyMesh const& mesh) {
    SharpPlaces out;
    for (auto const& X : mesh.nodes) out.y.insert(out.y.end(), X.begin(), X.begin() + d);
    return out;
  }
  static std::vector<double> densities(BodyMesh const& mesh, BodyStart<d> const& start) {
    std::vector<double> out;
    for (int cell = 0; cell < static_cast<int>(mesh.cells.size()); ++cell) {
      Place centre{};
      for (int b = 0; b < corner_count(mesh.shape); ++b)
        for (int a = 0; a < d; ++a) centre[a] += corner_place(mesh, cell, b)[a] / corner_count(mesh.shape);
      double const rho = start.density(centre);
      if (!is_finite(rho)) throw NotFinite("density in " + mesh.cell_name(cell));
      if (!(rho > 0)) throw NotADensity(mesh.cell_name(cell), "an incompressible medium has mass", rho);
      out.push_back(rho);
    }
    return out;
  }
  static std::vector<NodeAllowance<d>> allowances(HeldNodes<d> const& held) {
    std::vector<NodeAllowance<d>> out;
    held.for_held([&](int node, Matrix<double, d, d> const& part) { out.push_back({node, part}); });
    return out;
  }
};

}  // namespace actio::media
