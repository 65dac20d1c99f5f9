// A body whose steps several ranks make, commanded by rank 0, which has the whole of it.
//
// Each rank steps the nodes that it has and the copies that it needs, by the forces that their ranks have
// found: one exchange a step. Nothing is added across ranks but what viscosity takes, on rank 0 and in the
// order of the nodes, so that no bit depends on how many there are.
#pragma once

#include "actio/media_on_meshes/body_motion.hpp"
#include "actio/parallel/parts_on_ranks.hpp"

namespace actio::media {

/// The part of a mesh that a rank has. What is of use on one rank alone, names and groups that are no sides,
/// is left.
inline BodyMesh part_of_mesh(BodyMesh const& mesh, SharedNodes const& shared) {
  BodyMesh part;
  part.dimension = mesh.dimension, part.shape = mesh.shape, part.periods = mesh.periods;
  std::vector<int> here(mesh.nodes.size(), -1);
  for (int const node : shared.nodes())
    here[node] = static_cast<int>(part.nodes.size()), part.nodes.push_back(mesh.nodes[node]);
  for (int const cell : shared.cells()) {
    auto& corners = part.cells.emplace_back(mesh.cells[cell]);
    for (int b = 0; b < corner_count(mesh.shape); ++b) corners[b] = here[corners[b]];
    if (!mesh.wraps.empty()) part.wraps.push_back(mesh.wraps[cell]);
  }
  for (auto const& [name, facets] : mesh.sides)
    for (auto& some = part.sides[name]; auto facet : facets) {
      // The cell of a facet is here where it touches a node that this rank has.
      bool own = false;
      for (int& node : facet) {
        if (node < 0) continue;
        node = here[node], own = own || (node >= 0 && shared.own(static_cast<std::size_t>(node)));
      }
      if (own) some.push_back(facet);
    }
  return part;
}

/// The part of a body on one rank; on rank 0 all ranks do with theirs what it does.
///
/// \snippet media.cpp body_on_ranks
template <int d>
class BodyOnRank final : public RankPart, BodyMotion<d> {
 public:
  /// Made on all ranks, with the same arguments as \ref MediumOnMesh.
  /// @throws Error  on all ranks, where they have not the same mesh
  /// @param told  of the body, from rank 0 to the others (\ref actio::share_parts "share_parts")
  BodyOnRank(Ranks& ranks, std::string const& told, BodyMesh const& mesh,
             std::shared_ptr<StoredEnergy<d> const> law,
             std::function<double(std::array<double, d> const&)> const& density, BodyStepping const& stepping,
             BodySides<d> const& sides, BodyLoads<d> const& loads)
      : BodyOnRank(std::make_unique<SharedNodes>(ranks, mesh.nodes, mesh.cells, corner_count(mesh.shape)),
                   told, mesh, std::move(law), density, stepping, loads) {
    shared_->require_same();
    // Sides that slide have one normal on all ranks.
    steps_of_.held = HeldNodes<d>(mesh, sides).among(shared_->nodes());
    auto& body = steps_of_.forces.body;
    shared_->complete(body.masses);
    if (stepping.viscosity.any()) steps_of_.viscosity.emplace(stepping.viscosity, body, shared_.get());
    steps_of_.shared = shared_.get();
    std::size_t const count = d * shared_->nodes().size();
    for (auto* list : {&state_.x, &state_.v, &state_.x_rest, &state_.v_rest, &forces_}) list->resize(count);
    if (steps_of_.viscosity) state_.viscous.resize(count);
  }

  /// On rank 0: steps that all ranks make, up to one that fails on one of them, without it.
  /// @param whole, forces  state and forces of the whole body
  /// @param is_known  whether they are those that the last steps have left
  /// @param before  how many steps were made
  /// @return how many were made
  long make(BodyState& whole, std::vector<double>& forces, bool is_known, long count, double step,
            long before) {
    return Calls::template ask<&BodyOnRank::make_here>(parts_, *this, whole, forces, is_known, count, step,
                                                       before);
  }
  void answer(PartCall const& call) override { Calls::answer(*this, call); }

 private:
  using BodyMotion<d>::steps_of_, BodyMotion<d>::state_, BodyMotion<d>::forces_;
  using BodyMotion<d>::in_parts, BodyMotion<d>::put_back;
  std::unique_ptr<SharedNodes> shared_;
  PartsOnRanks parts_;

  BodyOnRank(std::unique_ptr<SharedNodes> shared, std::string const& told, BodyMesh const& mesh,
             std::shared_ptr<StoredEnergy<d> const> law,
             std::function<double(std::array<double, d> const&)> const& density, BodyStepping const& stepping,
             BodyLoads<d> const& loads)
      : BodyMotion<d>({part_of_mesh(mesh, *shared), std::move(law), density, {}, loads}, stepping),
        shared_(std::move(shared)),
        parts_(&shared_->ranks(), told) {}

  long make_here(BodyState& whole, std::vector<double>& forces, bool is_known, long count, double step,
                 long before) {
    if (!is_known)
      each_list(whole, forces, [&](auto const& all, auto& here) { shared_->scatter(all, here); });
    state_.dissipated = whole.dissipated;
    long made = 0;
    try {
      for (; made < count; ++made) {
        double const steps = static_cast<double>(before + made);
        in_parts(step, steps * step, (steps + 1) * step);
      }
    } catch (FailsOnARank const&) {
      put_back();
    } catch (ViscosityNeedsShorterSteps const&) {
      put_back();
    }
    each_list(whole, forces, [&](auto& all, auto const& here) { shared_->gather(here, all); });
    whole.dissipated = state_.dissipated;
    return made;
  }
  using Calls = PartCalls<&BodyOnRank::make_here>;
  /// Calls f(of all nodes, of those here) for the lists of a state.
  template <class F>
  void each_list(BodyState& whole, std::vector<double>& forces, F const& f) {
    f(whole.x, state_.x), f(whole.v, state_.v), f(whole.x_rest, state_.x_rest);
    f(whole.v_rest, state_.v_rest), f(forces, forces_);
    if (steps_of_.viscosity) f(whole.viscous, state_.viscous);
  }
};

}  // namespace actio::media
