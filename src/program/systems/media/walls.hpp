// Whether nodes have passed in one step through what they could not have climbed: a wall that is thinner than
// the way of a step is seen by no step of any kind.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>

#include "program/systems/media/loads.hpp"

namespace actio::scene {

/// Samples potentials along the ways of the nodes of a body, step by step. Where a potential on a way differs
/// from the cubic that its values and slopes at both ends have by more than the kinetic energy of the way, it
/// was not seen.
template <int d>
class WallWatch {
 public:
  using Place = std::array<double, d>;  ///< a point, or a vector

  /// @param loads  with potentials; those that are quadratic are seen by any step
  /// @param body   nodes of its moved sides are where their motion has them, and pass through anything
  WallWatch(MediumLoads<d> const& loads, media::BodyMesh const& body, std::vector<Place> const& places) {
    for (auto const& potential : loads.loads.potentials)
      if (!is_quadratic(potential, places)) potentials_.push_back(potential);
    free_.assign(body.nodes.size(), true);
    for (auto const& [name, side] : loads.sides)
      if (side.kind == media::Side::moved)
        for (auto const& facet : body.sides.at(name))
          for (int const node : facet)
            if (node >= 0) free_[static_cast<std::size_t>(node)] = false;
    Place low = places[0], high = places[0];
    for (auto const& x : places)
      for (int a = 0; a < d; ++a) low[a] = std::min(low[a], x[a]), high[a] = std::max(high[a], x[a]);
    double volume = 1;
    for (int a = 0; a < d; ++a) volume *= high[a] - low[a];
    cell_ = std::pow(volume / static_cast<double>(body.cells.size()), 1.0 / d);
    begin(places);
  }

  /// Whether there is anything to look at.
  bool any() const { return !potentials_.empty(); }
  /// The nodes are here.
  void begin(std::vector<Place> const& places) {
    known_.clear();
    if (!any()) return;
    from_ = places;
    for (auto const& x : places)
      for (auto const& potential : potentials_) known_.push_back(at(potential, x));
  }
  /// The nodes have come here by a step.
  /// @throws Error  with the node, its way, and what it has passed
  void look(std::vector<Place> places, double step, double time) {
    for (std::size_t k = 0; k < places.size(); ++k)
      for (std::size_t p = 0; p < potentials_.size() && free_[k]; ++p) {
        Known& known = known_[k * potentials_.size() + p];
        Known const next = at(potentials_[p], places[k]);
        examine(potentials_[p], k, from_[k], known, places[k], next, step, time);
        known = next;
      }
    from_ = std::move(places);
  }

 private:
  /// A potential at a place.
  struct Known {
    double value;
    Place gradient;
  };
  static Known at(media::SpacePotential<d> const& potential, Place const& x) {
    return {potential.value(x), potential.gradient(x)};
  }

  std::vector<Known> known_;  // of each node, by potentials
  std::vector<media::SpacePotential<d>> potentials_;
  std::vector<bool> free_;
  std::vector<Place> from_;
  double cell_ = 1;

  /// Whether the curvature is the same everywhere around the body.
  static bool is_quadratic(media::SpacePotential<d> const& potential, std::vector<Place> const& places) {
    std::minstd_rand random(1);
    Place first{};
    for (int k = 0; k < 20; ++k) {
      Place x = places[random() % places.size()], u{};
      for (double& one : x) one += 4.0 * static_cast<double>(random()) / std::minstd_rand::max() - 2;
      for (double& one : u) one = 1;
      Place const bend = potential.curvature(x, u);
      if (k == 0) first = bend;
      for (int a = 0; a < d; ++a)
        if (!(std::abs(bend[a] - first[a]) <= 1e-12 * std::abs(first[a]))) return false;
    }
    return true;
  }

  void examine(media::SpacePotential<d> const& potential, std::size_t node, Place const& x0,
               Known const& first, Place const& x1, Known const& last, double step, double time) const {
    auto const along = [&](Place const& g) {
      double sum = 0;
      for (int a = 0; a < d; ++a) sum += g[a] * (x1[a] - x0[a]);
      return sum;
    };
    auto const between = [&](double s) {
      Place x;
      for (int a = 0; a < d; ++a) x[a] = x0[a] + s * (x1[a] - x0[a]);
      return x;
    };
    double way = 0;
    for (int a = 0; a < d; ++a) way += (x1[a] - x0[a]) * (x1[a] - x0[a]);
    double const V0 = first.value, V1 = last.value, g0 = along(first.gradient), g1 = along(last.gradient),
                 kinetic = 0.5 * way / (step * step);
    auto const unseen = [&](double s) {
      double const t = 1 - s;
      double const cubic =
          V0 * t * t * (1 + 2 * s) + g0 * s * t * t + V1 * s * s * (1 + 2 * t) - g1 * s * s * t;
      double const V = potential.value(between(s));
      return std::isfinite(V) ? std::abs(V - cubic) : HUGE_VAL;
    };
    double worst = 0;
    int const samples = 1 + static_cast<int>(std::min(15.0, 32 * std::sqrt(way) / cell_));
    for (int k = 0; k < samples; ++k) worst = std::max(worst, unseen((k + 0.5) / samples));
    if (g0 > 0 && g1 < 0) {
      // Up and down again: to the top, which may be a pole.
      double low = 0, high = 1;
      for (int k = 0; k < 50; ++k) {
        double const middle = 0.5 * (low + high);
        (along(potential.gradient(between(middle))) > 0 ? low : high) = middle;
      }
      worst = std::max({worst, unseen(low), unseen(high)});
    }
    // A node that hardly moves differs by roundings of the potential alone.
    double const rounding = 1e-14 * (std::abs(V0) + std::abs(V1) + std::abs(g0) + std::abs(g1));
    if (!(worst > kinetic + rounding)) return;
    throw Error("medium: node " + std::to_string(node) +
                " has passed through a potential in the step of length " + show(step) +
                " to t = " + show(time) + ", from x = " + in_words(x0) + " to " + in_words(x1) +
                ": on that way the potential rises by " + show(worst) +
                " beyond what both ends tell, and the motion has " + show(kinetic) +
                " per mass; a step must be shorter than the node takes to cross what stands there");
  }
  static std::string in_words(Place const& x) {
    std::string out;
    for (double const one : x) out += (out.empty() ? "(" : ", ") + show(one);
    return out + ")";
  }
};

}  // namespace actio::scene
