// Forces, energies and stiffness of a body on a mesh, by a plain loop over its cells.
#pragma once

#include "actio/media_on_meshes/body_loads.hpp"
#include "actio/media_on_meshes/discrete_stress.hpp"

namespace actio::media {

/// The least Jacobian of a body, and the cell that has it.
struct LeastJacobian {
  double jacobian = HUGE_VAL;  ///< det F at the worst point of the cell; NaN where a place is none
  int cell = -1;               ///< which cell
};

/// Some cells of a body and the nodes at their corners, at least; all where there are none.
struct BodyPart {
  Ranges cells = {};  ///< numbers of the cells
  Ranges nodes = {};  ///< numbers of the nodes
};

/// What acts inside of a body and on it.
template <int d>
class BodyForces {
 public:
  using Gradient = Matrix<double, d, d>;               ///< a deformation gradient, or a stress
  using Law = std::shared_ptr<StoredEnergy<d> const>;  ///< the medium
  using Density = std::function<double(std::array<double, d> const&)>;  ///< of mass, at X

  /// @throws  what \ref BodyQuadrature and \ref LoadsOnBody refuse
  BodyForces(BodyMesh const& mesh, Law law, Density const& density, BodyLoads<d> const& loads)
      : body(mesh, *law, density), loads(mesh, loads), law_(std::move(law)) {
    reference_.reserve(d * mesh.nodes.size());
    for (auto const& X : mesh.nodes) reference_.insert(reference_.end(), X.begin(), X.begin() + d);
  }

  BodyQuadrature<d> body;  ///< cells and masses
  LoadsOnBody<d> loads;    ///< from outside

  /// The forces on all nodes at places x and time t: minus the derivative of the energy, and pressures.
  /// @param rest  what is to be added to x, which is rounded; may be empty
  /// @param part  by whose cells forces are made
  /// @return the least Jacobian; where it is not positive the forces are not complete
  LeastJacobian forces(std::vector<double> const& x, double t, std::vector<double>& f,
                       std::vector<double> const& rest = {}, BodyPart const& part = {}) const {
    Ranges const cells = part.cells.empty() ? Ranges{{0, body.cells()}} : part.cells,
                 nodes = part.cells.empty() ? Ranges{{0, static_cast<int>(body.masses.size())}} : part.nodes;
    f.resize(x.size());
    for_each(nodes, [&](std::size_t k) { std::fill_n(f.data() + d * k, d, 0.0); });
    Displacements const moved = displaced(x, rest, nodes);
    LeastJacobian const least =
        body.with_kind([&](auto kind) { return forces_inside(kind, moved, f, cells); });
    if (least.jacobian > 0) loads.add_forces(body, x, t, f, nodes);
    return least;
  }
  /// The forces along a way from places x whose work is the decrease of the energy, and which conserve
  /// momenta.
  ///
  /// Where a body is does not matter for their rounding: they are made of differences of neighbours' places
  /// and of their ways.
  /// @param x, rest  places, rounded, and what is to be added to them
  /// @param way      how far the nodes go
  /// @return the least Jacobian at the end; where it is not positive the forces are not complete
  LeastJacobian discrete_forces(std::vector<double> const& x, std::vector<double> const& rest,
                                std::vector<double> const& way, double t, std::vector<double>& f) const {
    f.assign(x.size(), 0);
    Displacements const moved = displaced(x, rest);
    LeastJacobian const least =
        body.with_kind([&](auto kind) { return discrete_forces_inside(kind, moved, way, f); });
    if (!(least.jacobian > 0)) return least;
    std::vector<double> end = x;
    for (std::size_t k = 0; k < end.size(); ++k) end[k] += way[k];
    loads.add_discrete_forces(body, x, end, t, f);
    return least;
  }
  /// The rate at which forces fall along a change u of places x: the second derivative of the energy.
  void stiffness(std::vector<double> const& x, std::vector<double> const& u, std::vector<double>& out) const {
    out.assign(x.size(), 0);
    CellCorners<d> at, along;
    for (int cell = 0; cell < body.cells(); ++cell) {
      body.gather(x, cell, at), body.gather(u, cell, along, false);
      CellCorners<d> on;
      for (int p = 0; p < body.points_per_cell; ++p) {
        auto const& point = body.at(cell, p);
        Gradient const F = body.gradient(at, p, point), change = body.gradient(along, p, point);
        Gradient rate = law_->stress_rate(F, change) * (-point.weight);
        if (loads.outside_pressure() != 0) rate -= cofactor_rate(F, change) * pressure_on(point);
        body.add_forces(rate, p, point, on);
      }
      body.scatter(on, cell, out);
    }
    loads.add_stiffness(body, x, u, out);
  }
  /// What the body has stored at places x, to which rest is to be added where it is not empty.
  double stored(std::vector<double> const& x, std::vector<double> const& rest = {}) const {
    double sum = 0;
    each_displacement(x, rest, [&](int, int, CellPoint<d> const& point, Gradient const& H) {
      sum += point.weight * law_->energy_beyond(H);
    });
    return sum;
  }
  /// The energy of the loads that have one: potentials, dead loads, outside pressure times volume.
  double of_loads(std::vector<double> const& x) const {
    double sum = loads.energy(body, x);
    if (loads.outside_pressure() != 0)
      each_point(x, [&](int, int, CellPoint<d> const& point, Gradient const& F) {
        sum += pressure_on(point) * small_determinant(F);
      });
    return sum;
  }
  /// The least Jacobian at places x.
  LeastJacobian least_jacobian(std::vector<double> const& x) const {
    LeastJacobian least;
    CellCorners<d> at;
    for (int cell = 0; cell < body.cells(); ++cell) {
      body.gather(x, cell, at);
      for (int p = 0; p < body.points_per_cell; ++p)
        if (!note(body.gradient(at, p, body.at(cell, p)), cell, least) && least.jacobian != least.jacobian)
          return least;
    }
    return least;
  }
  /// Calls f(cell, point number, point, F) for all points of all cells.
  template <class Visit>
  void each_point(std::vector<double> const& x, Visit const& visit) const {
    CellCorners<d> at;
    for (int cell = 0; cell < body.cells(); ++cell) {
      body.gather(x, cell, at);
      for (int p = 0; p < body.points_per_cell; ++p)
        visit(cell, p, body.at(cell, p), body.gradient(at, p, body.at(cell, p)));
    }
  }
  /// The same with \f$H = F-1\f$, at places x to which rest is to be added where it is not empty: without
  /// loss, however small H is.
  template <class Visit>
  void each_displacement(std::vector<double> const& x, std::vector<double> const& rest,
                         Visit const& visit) const {
    Displacements const moved = displaced(x, rest);
    body.with_kind([&](auto kind) {
      for (int cell = 0; cell < body.cells(); ++cell) {
        OfCell const here(body, kind, moved, cell);
        for (int p = 0; p < kind.points; ++p)
          visit(cell, p, body.at(cell, p), here.gradient(kind, p, body.at(cell, p)));
      }
      return 0;
    });
  }
  /// The stored energy of the medium.
  StoredEnergy<d> const& law() const { return *law_; }

 private:
  Law law_;
  std::vector<double> reference_;  // X of the nodes

  /// The displacements of all nodes, as sums of two numbers: differences of neighbours are theirs, wherever
  /// the body is.
  struct Displacements {
    std::vector<double> u, rest;
  };
  Displacements displaced(std::vector<double> const& x, std::vector<double> const& rest) const {
    return displaced(x, rest, {{0, static_cast<int>(x.size()) / d}});
  }
  Displacements displaced(std::vector<double> const& x, std::vector<double> const& rest,
                          Ranges const& nodes) const {
    Displacements out{std::vector<double>(x.size()), std::vector<double>(x.size())};
    auto const put = [&](std::size_t k) {
      double const X = reference_[k], u = x[k] - X, taken = u - x[k];
      out.u[k] = u;
      // What rounding took from u (Knuth).
      out.rest[k] = (x[k] - (u - taken)) - (X + taken) + (rest.empty() ? 0 : rest[k]);
    };
    for_each(nodes, [&](std::size_t node) {
      for (std::size_t k = d * node; k < d * (node + 1); ++k) put(k);
    });
    return out;
  }
  /// Those of the corners of a cell.
  struct OfCell {
    CellCorners<d> u, rest;
    template <class Kind>
    OfCell(BodyQuadrature<d> const& body, Kind kind, Displacements const& moved, int cell) {
      // What goes around a periodic body goes with its reference.
      body.gather(kind, moved.u, cell, u, false), body.gather(kind, moved.rest, cell, rest, false);
    }
    /// H at a point.
    template <class Kind>
    Gradient gradient(Kind kind, int p, CellPoint<d> const& point) const {
      return BodyQuadrature<d>::gradient(kind, u, p, point) +
             BodyQuadrature<d>::gradient(kind, rest, p, point);
    }
  };

  template <class Kind>
  LeastJacobian forces_inside(Kind kind, Displacements const& moved, std::vector<double>& f,
                              Ranges const& cells) const {
    LeastJacobian least;
    for (RowRange const& range : cells)
      for (int cell = range.from; cell < range.to; ++cell) {
        OfCell const here(body, kind, moved, cell);
        CellCorners<d> on;
        for (int p = 0; p < Kind::points; ++p) {
          auto const& point = body.at(cell, p);
          Gradient const H = here.gradient(kind, p, point);
          if (!note(beyond_identity<d>(H), cell, least)) return least;
          body.add_forces(kind, weighed_stress(H, point), p, point, on);
        }
        body.scatter(kind, on, cell, f);
      }
    return least;
  }
  template <class Kind>
  LeastJacobian discrete_forces_inside(Kind kind, Displacements const& moved, std::vector<double> const& way,
                                       std::vector<double>& f) const {
    LeastJacobian least;
    CellCorners<d> along;
    for (int cell = 0; cell < body.cells(); ++cell) {
      OfCell const here(body, kind, moved, cell);
      body.gather(kind, way, cell, along, false);
      CellCorners<d> on;
      for (int p = 0; p < Kind::points; ++p) {
        auto const& point = body.at(cell, p);
        Gradient const change = body.gradient(kind, along, p, point), H0 = here.gradient(kind, p, point);
        if (!note(beyond_identity<d>(H0 + change), cell, least)) return least;
        auto const energy = [&](Gradient const& H) { return weighed_energy(H, point); };
        auto const stress = [&](Gradient const& E) { return weighed_green_stress(E, point); };
        body.add_forces(kind, discrete_stress<d>(energy, stress, H0, change), p, point, on);
      }
      body.scatter(kind, on, cell, f);
    }
    return least;
  }

  /// Remembers the Jacobian where it is the least; whether it is positive.
  static bool note(Gradient const& F, int cell, LeastJacobian& least) {
    double const J = small_determinant(F);
    if (!(J >= least.jacobian)) least = {J, cell};
    return J > 0;
  }
  double pressure_on(CellPoint<d> const& point) const { return loads.outside_pressure() * point.volume; }
  double weighed_energy(Gradient const& H, CellPoint<d> const& point) const {
    double const stored = point.weight * law_->energy_beyond(H);
    if (loads.outside_pressure() == 0) return stored;
    return stored + pressure_on(point) * small_determinant(beyond_identity(H));
  }
  Gradient weighed_stress(Gradient const& H, CellPoint<d> const& point) const {
    Gradient P = law_->stress_beyond(H) * point.weight;
    if (loads.outside_pressure() != 0) P += cofactors(beyond_identity(H)) * pressure_on(point);
    return P;
  }
  Gradient weighed_green_stress(Gradient const& E, CellPoint<d> const& point) const {
    Gradient S = law_->green_stress_beyond(E) * point.weight;
    if (loads.outside_pressure() == 0) return S;
    Gradient const C = beyond_identity<d>(E * 2);
    return S + cofactors(C) * (pressure_on(point) / std::sqrt(small_determinant(C)));
  }
  static Gradient cofactor_rate(Gradient const& F, Gradient const& change) {
    return derivative_along([](auto const& moved) { return cofactors(moved); }, F, change).rate;
  }
};

}  // namespace actio::media
