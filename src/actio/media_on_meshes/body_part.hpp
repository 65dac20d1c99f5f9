// A body whose steps several ranks make, commanded by rank 0, which has the whole of it (\ref share_media).
//
// Each rank steps the nodes that it has and the copies that it needs, by the forces that their ranks have
// found: one exchange a step. Nothing is added across ranks but what viscosity takes, on rank 0 and in the
// order of the nodes, so that no bit depends on how many there are.
#pragma once

#include "actio/fast_media/nodes_on_ranks.hpp"
#include "actio/media_on_meshes/body_motion.hpp"

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

/// The part of a body on one rank.
template <int d>
class BodyPart final : public MediumPart, BodyMotion<d> {
 public:
  /// Made on all ranks at once, with the same arguments as \ref MediumOnMesh.
  BodyPart(Ranks& ranks, BodyMesh const& mesh, std::shared_ptr<StoredEnergy<d> const> law,
           std::function<double(std::array<double, d> const&)> const& density, BodyStepping const& stepping,
           BodySides<d> const& sides, BodyLoads<d> const& loads)
      : BodyPart(std::make_unique<SharedNodes>(ranks, mesh.nodes, mesh.cells, corner_count(mesh.shape)), mesh,
                 std::move(law), density, stepping, loads) {
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

  /// Steps that are to be made by all ranks.
  struct Order {
    long steps;    ///< that were made before
    long count;    ///< how many
    double step;   ///< their length
    bool is_told;  ///< whether the state is the one that rank 0 has
  };
  /// Makes them, up to one that fails on a rank, without it.
  /// @param whole, forces  on rank 0: state and forces of the whole body
  /// @return how many were made
  long make(Order const& order, BodyState& whole, std::vector<double>& forces) {
    if (!order.is_told)
      each_list(whole, forces, [&](auto const& all, auto& here) { shared_->scatter(all, here); });
    state_.dissipated = whole.dissipated;
    long made = 0;
    for (; made < order.count; ++made) {
      long const before = order.steps + made;
      try {
        in_parts(order.step, static_cast<double>(before) * order.step,
                 static_cast<double>(before + 1) * order.step);
      } catch (FailsOnARank const&) {
        put_back();
        break;
      } catch (ViscosityNeedsShorterSteps const&) {
        put_back();
        break;
      }
    }
    each_list(whole, forces, [&](auto& all, auto const& here) { shared_->gather(here, all); });
    whole.dissipated = state_.dissipated;
    return made;
  }
  void answer(detail::NodesCall const&) override {
    Order order{};
    shared_->ranks().broadcast(std::as_writable_bytes(std::span(&order, 1)));
    BodyState none;
    std::vector<double> no_forces;
    make(order, none, no_forces);
  }
  Ranks& ranks() const { return shared_->ranks(); }  ///< that have the parts

 private:
  using BodyMotion<d>::steps_of_, BodyMotion<d>::state_, BodyMotion<d>::forces_;
  using BodyMotion<d>::in_parts, BodyMotion<d>::put_back;
  std::unique_ptr<SharedNodes> shared_;

  BodyPart(std::unique_ptr<SharedNodes> shared, BodyMesh const& mesh,
           std::shared_ptr<StoredEnergy<d> const> law,
           std::function<double(std::array<double, d> const&)> const& density, BodyStepping const& stepping,
           BodyLoads<d> const& loads)
      : BodyMotion<d>({part_of_mesh(mesh, *shared), std::move(law), density, {}, loads}, stepping),
        shared_(std::move(shared)) {}

  /// Calls f(of all nodes, of those here) for the lists of a state.
  template <class F>
  void each_list(BodyState& whole, std::vector<double>& forces, F const& f) {
    f(whole.x, state_.x), f(whole.v, state_.v), f(whole.x_rest, state_.x_rest);
    f(whole.v_rest, state_.v_rest), f(forces, forces_);
    if (steps_of_.viscosity) f(whole.viscous, state_.viscous);
  }
};

/// The parts of a body on all ranks, seen from rank 0.
template <int d>
class BodyOnRanks {
 public:
  /// @param told  of the medium, to the other ranks
  /// @param arguments  of \ref BodyPart
  template <class... Arguments>
  BodyOnRanks(Ranks& ranks, std::string told, Arguments const&... arguments) : ranks_(ranks) {
    say(detail::NodesCall::make);
    detail::agree(ranks, told);
    part_ = std::make_unique<BodyPart<d>>(ranks, arguments...);
  }
  BodyOnRanks(BodyOnRanks const&) = delete;
  ~BodyOnRanks() { detail::say_last(ranks_, {detail::NodesCall::drop, which_, 0, 0}); }
  /// \copydoc BodyPart::make
  long make(typename BodyPart<d>::Order order, BodyState& whole, std::vector<double>& forces) {
    say(detail::NodesCall::advance);
    ranks_.broadcast(std::as_writable_bytes(std::span(&order, 1)));
    return part_->make(order, whole, forces);
  }

 private:
  Ranks& ranks_;
  int which_ = detail::next_medium();
  std::unique_ptr<BodyPart<d>> part_;

  void say(detail::NodesCall::Kind kind) {
    detail::NodesCall call{kind, which_, 0, 0};
    detail::agree(ranks_, call);
  }
};

}  // namespace actio::media
