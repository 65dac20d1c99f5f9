// The nodes of a medium on several ranks, commanded by rank 0.
#pragma once

#include "actio/parallel/parts_on_ranks.hpp"

namespace actio::media::detail {

/// What can be asked of nodes.
struct NodesCall {
  /// Each of it.
  enum Kind : int { put, places, velocities, advance, examine, strains, keep, restore };
};

/// Nodes of this process, or those of all ranks, seen from rank 0.
/// @tparam Nodes  `FusedRows2d` or `FusedPlanes3d`
template <class Nodes>
class NodesOnRanks {
 public:
  /// The steps of a medium.
  template <class Box, class Cell, class Options>
  NodesOnRanks(Box const& box, Cell const& cell, double dt, Options const& options)
      : nodes_(std::make_unique<Nodes>(box, cell, dt, options)),
        parts_(std::make_unique<PartsOnRanks>(options.ranks, options.told, dt)) {}

  void put(auto const& x, auto const& v) {
    auto const asked = parts_->ask({.what = NodesCall::put});
    nodes_->put(x, v);
  }
  auto read(bool velocity) const {
    auto const asked = parts_->ask({.what = velocity ? NodesCall::velocities : NodesCall::places});
    return nodes_->read(velocity);
  }
  bool advance(long count) {
    auto const asked = parts_->ask({.what = NodesCall::advance, .count = count});
    return nodes_->advance(count);
  }
  bool examine() {
    auto const asked = parts_->ask({.what = NodesCall::examine});
    return nodes_->examine();
  }
  auto strains() const {
    auto const asked = parts_->ask({.what = NodesCall::strains});
    return nodes_->strains();
  }
  void keep() {
    auto const asked = parts_->ask({.what = NodesCall::keep});
    nodes_->keep();
  }
  void restore() {
    auto const asked = parts_->ask({.what = NodesCall::restore});
    nodes_->restore();
  }
  int levels() const { return nodes_->levels(); }
  std::size_t bytes() const { return nodes_->bytes(); }

 private:
  std::unique_ptr<Nodes> nodes_;
  std::unique_ptr<PartsOnRanks> parts_;
};

/// Those of another rank.
template <class Nodes>
class PartOf final : public RankPart {
 public:
  explicit PartOf(auto const&... arguments) : nodes_(arguments...) {}
  void answer(PartCall const& call) override {
    switch (call.what) {
      case NodesCall::put:
        nodes_.put({}, {});
        break;
      case NodesCall::places:
        nodes_.read(false);
        break;
      case NodesCall::velocities:
        nodes_.read(true);
        break;
      case NodesCall::advance:
        nodes_.advance(call.count);
        break;
      case NodesCall::examine:
        nodes_.examine();
        break;
      case NodesCall::strains:
        nodes_.strains();
        break;
      case NodesCall::keep:
        nodes_.keep();
        break;
      case NodesCall::restore:
        nodes_.restore();
        break;
      default:
        break;
    }
  }

 private:
  Nodes nodes_;
};

}  // namespace actio::media::detail
