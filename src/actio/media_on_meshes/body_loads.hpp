// Loads on a body: potentials in space, tractions that keep their direction, pressures that follow.
//
//     BodyLoads<2> loads;
//     loads.potentials.push_back(space_potential<2>([](auto const& x) { return x[1] * 9.81; }));
//     loads.tractions["right"] = {0, 1};
//     loads.outside_pressure = 0.1;
#pragma once

#include "actio/media_on_meshes/body_quadrature.hpp"
#include "actio/meshes/body_sides.hpp"
#include "actio/parallel/row_share.hpp"

namespace actio::media {

/// A potential in space, per mass: gravity, or a hill that stands for an obstacle.
template <int d>
struct SpacePotential {
  using Place = std::array<double, d>;          ///< a point of space
  std::function<double(Place const&)> value;    ///< \f$V(x)\f$, speed squared
  std::function<Place(Place const&)> gradient;  ///< \f$\nabla V\f$, acceleration
  /// \f$\nabla^2V\,u\f$; may be empty, and then the longest step and Newton's iteration know nothing of it.
  std::function<Place(Place const&, Place const&)> curvature;
};
/// A potential from its value, with derivatives by dual numbers.
/// @param value  a callable on `Matrix<T, d, 1>`, over any scalar T
template <int d, class Value>
SpacePotential<d> space_potential(Value const& value) {
  using Place = std::array<double, d>;
  auto const vector = [](Place const& x) {
    Matrix<double, d, 1> out;
    for (int a = 0; a < d; ++a) out[a] = x[a];
    return out;
  };
  auto const place = [](Matrix<double, d, 1> const& x) {
    Place out;
    for (int a = 0; a < d; ++a) out[a] = x[a];
    return out;
  };
  auto const slope = [value]<class T>(Matrix<T, d, 1> const& x) -> Matrix<T, d, 1> {
    return derivative(value, x).gradient();
  };
  return {[=](Place const& x) -> double { return value(vector(x)); },
          [=](Place const& x) { return place(slope(vector(x))); },
          [=](Place const& x, Place const& u) {
            return place(derivative_along(slope, vector(x), vector(u)).rate);
          }};
}

/// What acts on a body from outside.
template <int d>
struct BodyLoads {
  std::vector<SpacePotential<d>> potentials;  ///< per mass
  /// On the whole body from outside: energy \f$p_0\int J\f$, force per area. It acts on free sides; on others
  /// the wall answers.
  double outside_pressure = 0;
  /// By sides: force per reference area, the same for all times (a dead load).
  std::map<std::string, std::array<double, d>> tractions;
  /// By sides: force per area of space against the side, a function of time (a follower load). It has a
  /// potential only where the side with what is held is closed; energy is not conserved otherwise.
  std::map<std::string, std::function<double(double)>> pressures;
};

/// The loads of a body, node by node.
template <int d>
class LoadsOnBody {
 public:
  using Place = std::array<double, d>;  ///< a point or a force

  /// @throws UnknownSide  where a load names a side that is none
  /// @throws NotFinite    where a load is none
  LoadsOnBody(BodyMesh const& mesh, BodyLoads<d> const& loads) : shape_(mesh.shape), loads_(loads) {
    if (!is_finite(loads.outside_pressure)) throw NotFinite("loads: outside pressure");
    for (auto const& [name, traction] : loads.tractions) {
      require_side(mesh, name);
      if (dead_.empty()) dead_.assign(mesh.nodes.size(), Place{});
      for (double const t : traction)
        if (!is_finite(t)) throw NotFinite("loads: traction on side '" + name + "'");
      for (auto const& facet : facets_of_side(mesh, name)) add_traction(mesh, facet, traction);
    }
    for (auto const& [name, pressure] : loads.pressures) {
      require_side(mesh, name);
      for (auto const& facet : facets_of_side(mesh, name)) pressed_.push_back({facet, pressure, name});
    }
  }

  /// The outside pressure.
  double outside_pressure() const { return loads_.outside_pressure; }

  /// \f$\sum mV(x)-\sum f\cdot x\f$ with dead loads f; the outside pressure is not in it.
  double energy(BodyQuadrature<d> const& body, std::vector<double> const& x) const {
    double sum = 0;
    for (std::size_t k = 0; k < body.masses.size(); ++k) {
      Place const at = place(x, k);
      for (auto const& potential : loads_.potentials) sum += body.masses[k] * value(potential, at, k);
      if (!dead_.empty())
        for (int a = 0; a < d; ++a) sum -= dead_[k][a] * at[a];
    }
    return sum;
  }
  /// Adds the forces at places x and time t.
  /// @param nodes  on which potentials and dead loads are added; none: on all
  /// @throws NotFinite  where a potential has no gradient at a node, or a pressure is none
  void add_forces(BodyQuadrature<d> const& body, std::vector<double> const& x, double t,
                  std::vector<double>& f, Ranges const& nodes = {}) const {
    auto const slope = [&](SpacePotential<d> const& potential, Place const& at, std::size_t k) {
      return gradient(potential, at, k);
    };
    add(body, x, f, slope, nodes);
    add_pressures(body, x, t, f);
  }
  /// Adds the forces between places x0 and x1 which do the work that the potentials lose: discrete gradients,
  /// \f$\bar g\cdot(x_1-x_0) = V(x_1)-V(x_0)\f$. Pressures act where the middle is, at time t.
  void add_discrete_forces(BodyQuadrature<d> const& body, std::vector<double> const& x0,
                           std::vector<double> const& x1, double t, std::vector<double>& f) const {
    add(body, x0, f, [&](SpacePotential<d> const& potential, Place const& from, std::size_t k) {
      return discrete_gradient(potential, from, place(x1, k), k);
    });
    if (pressed_.empty()) return;
    std::vector<double> middle(x0.size());
    for (std::size_t k = 0; k < x0.size(); ++k) middle[k] = 0.5 * (x0[k] + x1[k]);
    add_pressures(body, middle, t, f);
  }
  /// Adds the rate at which the potentials' forces fall along u: curvature times mass.
  void add_stiffness(BodyQuadrature<d> const& body, std::vector<double> const& x,
                     std::vector<double> const& u, std::vector<double>& out) const {
    for (auto const& potential : loads_.potentials) {
      if (!potential.curvature) continue;
      for (std::size_t k = 0; k < body.masses.size(); ++k) {
        Place const rate = potential.curvature(place(x, k), place(u, k));
        for (int a = 0; a < d; ++a) out[k * d + a] += body.masses[k] * rate[a];
      }
    }
  }

 private:
  struct Pressed {
    CellFacet facet;
    std::function<double(double)> pressure;
    std::string name;
  };
  BodyMesh::Shape shape_;
  BodyLoads<d> loads_;
  std::vector<Place> dead_;
  std::vector<Pressed> pressed_;

  static Place place(std::vector<double> const& x, std::size_t k) {
    Place out;
    for (int a = 0; a < d; ++a) out[a] = x[k * d + a];
    return out;
  }
  static std::string at_node(std::size_t k, Place const& x) {
    std::string name = "potential at node " + std::to_string(k) + ", x = (";
    for (int a = 0; a < d; ++a) name += (a ? ", " : "") + show(x[a]);
    return name + ")";
  }
  static double value(SpacePotential<d> const& potential, Place const& x, std::size_t k) {
    double const V = potential.value(x);
    if (!is_finite(V)) throw NotFinite(at_node(k, x));
    return V;
  }
  static Place gradient(SpacePotential<d> const& potential, Place const& x, std::size_t k) {
    Place const g = potential.gradient(x);
    for (double const one : g)
      if (!is_finite(one)) throw NotFinite("gradient of the " + at_node(k, x));
    return g;
  }
  /// The mean of the gradient at Gauss' two points, and along the way what is missing to the difference of
  /// values, where that is more than their rounding.
  static Place discrete_gradient(SpacePotential<d> const& potential, Place const& from, Place const& to,
                                 std::size_t k) {
    double const off = std::sqrt(3.0) / 6;
    Place g{};
    for (double const s : {0.5 - off, 0.5 + off}) {
      Place at;
      for (int a = 0; a < d; ++a) at[a] = from[a] + s * (to[a] - from[a]);
      Place const here = gradient(potential, at, k);
      for (int a = 0; a < d; ++a) g[a] += 0.5 * here[a];
    }
    double const before = value(potential, from, k), after = value(potential, to, k);
    double missing = after - before, square = 0;
    for (int a = 0; a < d; ++a)
      missing -= g[a] * (to[a] - from[a]), square += (to[a] - from[a]) * (to[a] - from[a]);
    double const rounding = 4 * std::numeric_limits<double>::epsilon() * (std::abs(before) + std::abs(after));
    if (std::abs(missing) > rounding)
      for (int a = 0; a < d; ++a) g[a] += missing / square * (to[a] - from[a]);
    return g;
  }
  template <class Slope>
  void add(BodyQuadrature<d> const& body, std::vector<double> const& x, std::vector<double>& f,
           Slope const& slope, Ranges const& nodes = {}) const {
    Ranges const of = nodes.empty() ? Ranges{{0, static_cast<int>(body.masses.size())}} : nodes;
    for (auto const& potential : loads_.potentials)
      for_each(of, [&](std::size_t k) {
        Place const g = slope(potential, place(x, k), k);
        for (int a = 0; a < d; ++a) f[k * d + a] -= body.masses[k] * g[a];
      });
    if (dead_.empty()) return;
    for_each(of, [&](std::size_t k) {
      for (int a = 0; a < d; ++a) f[k * d + a] += dead_[k][a];
    });
  }

  /// How many corners a facet has, and the vector of area, outwards, that corner k of it stands for: the
  /// integral of the hat function of the corner.
  int facet_corners_count() const { return shape_ == BodyMesh::Shape::hexahedron ? 4 : d; }
  Place area_at(double const (*at)[d], CellFacet const& facet, int k) const {
    auto const& corner = facet_corners(shape_, facet.facet);
    if constexpr (d == 1) {
      return {facet.facet == 0 ? -1.0 : 1.0};
    } else if constexpr (d == 2) {
      double const *a = at[corner[0]], *b = at[corner[1]];
      return {0.5 * (b[1] - a[1]), -0.5 * (b[0] - a[0])};
    } else {
      // Of a triangle each corner has a third. On a quadrilateral the vector of area is bilinear, from one
      // corner's edges to the next one's, and each corner has the integral of it with the hat function.
      int const n = facet_corners_count();
      static constexpr double of_three[] = {1.0 / 6, 0, 0},
                              of_four[] = {4.0 / 36, 2.0 / 36, 1.0 / 36, 2.0 / 36};
      Place area{};
      for (int away = 0; away < (n == 3 ? 1 : 4); ++away) {
        int const c = (k + away) % n;
        double const *o = at[corner[c]], *p = at[corner[(c + 1) % n]], *q = at[corner[(c + n - 1) % n]];
        for (int i = 0; i < 3; ++i) {
          int const u = (i + 1) % 3, w = (i + 2) % 3;
          area[i] += (n == 3 ? of_three : of_four)[away] *
                     ((p[u] - o[u]) * (q[w] - o[w]) - (p[w] - o[w]) * (q[u] - o[u]));
        }
      }
      return area;
    }
  }
  void add_traction(BodyMesh const& mesh, CellFacet const& facet, Place const& traction) {
    double X[8][d];
    for (int b = 0; b < corner_count(shape_); ++b) {
      auto const at = corner_place(mesh, facet.cell, b);
      for (int a = 0; a < d; ++a) X[b][a] = at[a];
    }
    auto const nodes = facet_nodes(mesh, facet);
    for (int k = 0; k < facet_corners_count(); ++k) {
      Place const area = area_at(X, facet, k);
      double size = 0;
      for (int a = 0; a < d; ++a) size += area[a] * area[a];
      for (int a = 0; a < d; ++a) dead_[nodes[k]][a] += std::sqrt(size) * traction[a];
    }
  }
  void add_pressures(BodyQuadrature<d> const& body, std::vector<double> const& x, double t,
                     std::vector<double>& f) const {
    for (auto const& one : pressed_) {
      double const p = one.pressure(t);
      if (!is_finite(p)) throw NotFinite("pressure on side '" + one.name + "' at t = " + show(t));
      CellCorners<d> corners;
      body.gather(x, one.facet.cell, corners);
      auto const& corner = facet_corners(shape_, one.facet.facet);
      for (int k = 0; k < facet_corners_count(); ++k) {
        Place const area = area_at(corners.at, one.facet, k);
        std::size_t const node = body.nodes[std::size_t(one.facet.cell) * body.corners + corner[k]];
        for (int a = 0; a < d; ++a) f[node * d + a] -= p * area[a];
      }
    }
  }
};

}  // namespace actio::media
