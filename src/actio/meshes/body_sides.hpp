// What the sides of a body do: free, held, sliding along a plane, or moved as prescribed.
#pragma once

#include <algorithm>
#include <functional>

#include "actio/meshes/body_mesh.hpp"
#include "actio/meshes/side.hpp"
#include "actio/numbers/derivative.hpp"
#include "actio/numbers/nearest_name.hpp"

namespace actio::media {

/// A name that no side of the mesh has; the message lists those that it has.
struct UnknownSide : Error {
  using Error::Error;
};

/// A motion \f$x = \chi(X,t)\f$ that is prescribed, with its velocity.
template <int d>
struct PrescribedMotion {
  using Place = std::array<double, d>;                  ///< a point
  std::function<Place(Place const&, double)> place;     ///< \f$\chi(X,t)\f$, length
  std::function<Place(Place const&, double)> velocity;  ///< \f$\partial\chi/\partial t\f$, length/time
};
/// A prescribed motion from its places.
/// @param chi  a callable (X, t) on an array of coordinates and any scalar t, with values
///   `std::array<T, d>`
template <int d, class Chi>
PrescribedMotion<d> prescribed_motion(Chi const& chi) {
  using Place = std::array<double, d>;
  return {[chi](Place const& X, double t) -> Place { return chi(X, t); },
          [chi](Place const& X, double t) {
            auto const moved = chi(X, variable(t));
            Place rate;
            for (int a = 0; a < d; ++a) rate[a] = rate_of(moved[a]);
            return rate;
          }};
}

/// What a side does.
template <int d>
struct BodySide {
  Side kind = Side::free;      ///< what it does; one that slides is plane, and none is periodic
  PrescribedMotion<d> motion;  ///< where it is moved
};
/// What the sides do, by their names; others are free. A node of two sides that are held obeys both, and the
/// motion of one of them before all.
///
/// A map, written in braces: `{{"left", {Side::fixed, {}}}}`, or with a motion
/// `{{"right", {Side::moved, prescribed_motion<2>(chi)}}}`. Names are those of the sides of the
/// \ref BodyMesh; a medium throws \ref UnknownSide for another one.
template <int d>
using BodySides = std::map<std::string, BodySide<d>>;

/// Refuses a name that is not one of a side.
/// @throws UnknownSide  with the names that there are
void require_side(BodyMesh const& mesh, std::string const& name);

/// A side along which a body shall slide bends in the reference space.
struct BentSide : NotABodyMesh {
  std::string side;  ///< its name
  /// @param bend  of a plane one 1e-9 at most
  BentSide(std::string const& name, double bend)
      : NotABodyMesh("side '" + name + "'",
                     "a side along which a body slides is plane in the reference space; its bend", bend,
                     1e-9),
        side(name) {}
};

/// The unit vector across a side that is plane in the reference space.
/// @throws BentSide  where it is not
template <int d>
std::array<double, d> plane_normal(BodyMesh const& mesh, std::string const& name) {
  using Place = std::array<double, d>;
  Place normal{}, first{};
  bool begun = false;
  // Across a seam a facet has its places from its cell.
  for (auto const& facet : facets_of_side(mesh, name)) {
    std::array<double, 3> p[3]{};
    for (int k = 0; k < d; ++k)
      p[k] = corner_place(mesh, facet.cell, facet_corners(mesh.shape, facet.facet)[k]);
    Place here{};
    if constexpr (d == 1)
      here[0] = 1;
    else if constexpr (d == 2)
      here = {p[1][1] - p[0][1], p[0][0] - p[1][0]};
    else
      for (int a = 0; a < 3; ++a) {
        int const b = (a + 1) % 3, c = (a + 2) % 3;
        here[a] = (p[1][b] - p[0][b]) * (p[2][c] - p[0][c]) - (p[1][c] - p[0][c]) * (p[2][b] - p[0][b]);
      }
    double size = 0, along = 0, away = 0, length = 0;
    for (int a = 0; a < d; ++a) size += here[a] * here[a];
    for (int a = 0; a < d; ++a) here[a] /= std::sqrt(size);
    if (!begun)
      for (int a = 0; a < d; ++a) normal[a] = here[a], first[a] = p[0][a];
    begun = true;
    for (int a = 0; a < d; ++a) {
      along += here[a] * normal[a], away += normal[a] * (p[0][a] - first[a]);
      length = std::max(length, std::abs(p[0][a]));
    }
    double const bend = std::max(1 - along, std::abs(away) / std::max(length, 1e-300));
    if (bend > 1e-9) throw BentSide(name, bend);
  }
  return normal;
}

/// The nodes that are not free, and which of their accelerations are left to them.
template <int d>
class HeldNodes {
 public:
  using Place = std::array<double, d>;  ///< a point, a velocity or a force

  /// @throws UnknownSide  where a name is not that of a side
  /// @throws BentSide     where a side that shall slide is not plane in the reference space: a wall that
  ///   bends would not hold a node by one direction
  HeldNodes(BodyMesh const& mesh, BodySides<d> const& sides) {
    std::map<int, Node> held;
    for (auto const& [name, side] : sides) {
      require_side(mesh, name);
      if (side.kind == Side::periodic)
        throw NotABodyMesh("side '" + name + "'", "a side of a body is not periodic; periodic", 1, 0);
      if (side.kind == Side::free) continue;
      Place const normal = side.kind == Side::sliding ? plane_normal<d>(mesh, name) : Place{};
      if (side.kind == Side::moved) motions_.push_back(side.motion);
      for (auto const& facet : mesh.sides.at(name))
        for (int const at : facet) {
          if (at < 0) continue;
          auto [entry, is_new] = held.try_emplace(at, Node{at, -1, Matrix<double, d, d>::Identity(), {}});
          Node& node = entry->second;
          for (int a = 0; a < d; ++a) node.reference[a] = mesh.nodes[at][a];
          if (side.kind == Side::moved) node.motion = static_cast<int>(motions_.size()) - 1;
          if (side.kind == Side::sliding)
            node.without(normal);
          else
            node.allowed.setZero();
        }
    }
    for (auto const& [at, node] : held) nodes_.push_back(node);
  }

  /// Those of a part of the body, by their numbers there.
  /// @param part  the nodes of the part, in increasing order
  HeldNodes among(std::vector<int> const& part) const {
    HeldNodes out = *this;
    out.nodes_.clear();
    for (Node node : nodes_) {
      auto const found = std::lower_bound(part.begin(), part.end(), node.at);
      if (found == part.end() || *found != node.at) continue;
      node.at = static_cast<int>(found - part.begin());
      out.nodes_.push_back(node);
    }
    return out;
  }

  /// Takes from accelerations, or from any change of places, what is not allowed.
  void restrict_to_allowed(std::vector<double>& u) const {
    for (auto const& node : nodes_) {
      double* at = u.data() + std::size_t(d) * node.at;
      Place const given = copied(at);
      for (int a = 0; a < d; ++a) {
        at[a] = 0;
        for (int b = 0; b < d; ++b) at[a] += node.allowed(a, b) * given[b];
      }
    }
  }
  /// Puts the nodes of moved sides where they are at time t.
  /// @throws NotFinite  where a motion has no place for a node
  void put_places(std::vector<double>& x, double t) const { put(x, t, false); }
  /// Gives them the velocities that they have at time t.
  void put_velocities(std::vector<double>& v, double t) const { put(v, t, true); }
  /// Whether a side is moved.
  bool any_moved() const { return !motions_.empty(); }
  /// Calls f(node) for the nodes of moved sides.
  template <class F>
  void for_moved(F const& f) const {
    for (auto const& node : nodes_)
      if (node.motion >= 0) f(node.at);
  }
  /// Calls f(node, projection) for the nodes that are held, with what is left to their changes.
  template <class F>
  void for_held(F const& f) const {
    for (auto const& node : nodes_) f(node.at, node.allowed);
  }
  /// Memory, bytes.
  std::size_t bytes() const { return nodes_.capacity() * sizeof(Node); }

 private:
  struct Node {
    int at, motion;
    Matrix<double, d, d> allowed;  // a projection
    Place reference;
    /// Takes a direction away from those that are allowed.
    void without(Place const& normal) {
      Place left{};
      double square = 0;
      for (int a = 0; a < d; ++a) {
        for (int b = 0; b < d; ++b) left[a] += allowed(a, b) * normal[b];
        square += left[a] * left[a];
      }
      if (square < 1e-16) return;  // it is not allowed already
      for (int a = 0; a < d; ++a)
        for (int b = 0; b < d; ++b) allowed(a, b) -= left[a] * left[b] / square;
    }
  };
  std::vector<Node> nodes_;
  std::vector<PrescribedMotion<d>> motions_;

  static Place copied(double const* from) {
    Place out;
    for (int a = 0; a < d; ++a) out[a] = from[a];
    return out;
  }
  void put(std::vector<double>& to, double t, bool rate) const {
    for (auto const& node : nodes_) {
      if (node.motion < 0) continue;
      auto const& motion = motions_[node.motion];
      Place const place = rate ? motion.velocity(node.reference, t) : motion.place(node.reference, t);
      for (int a = 0; a < d; ++a) {
        if (!is_finite(place[a]))
          throw NotFinite("prescribed motion of node " + std::to_string(node.at) + " at t = " + show(t));
        to[std::size_t(d) * node.at + a] = place[a];
      }
    }
  }
};

}  // namespace actio::media
