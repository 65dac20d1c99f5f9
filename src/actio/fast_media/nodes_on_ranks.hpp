// The nodes of a medium on several ranks, commanded by rank 0.
#pragma once

#include "actio/parallel/parts_on_ranks.hpp"

namespace actio::media::detail {

/// Nodes of this process, or those of all ranks, seen from rank 0.
/// @tparam Nodes  `FusedRows2d` or `FusedPlanes3d`
template <class Nodes>
class NodesOnRanks {
 public:
  /// What can be asked of nodes.
  using Calls = PartCalls<&Nodes::put, &Nodes::read, &Nodes::advance, &Nodes::examine, &Nodes::strains,
                          &Nodes::keep, &Nodes::restore>;

  /// The steps of a medium.
  template <class Box, class Cell, class Options>
  NodesOnRanks(Box const& box, Cell const& cell, double dt, Options const& options)
      : nodes_(std::make_unique<Nodes>(box, cell, dt, options)),
        parts_(std::make_unique<PartsOnRanks>(options.ranks, options.told, dt)) {}

  void put(auto const& x, auto const& v) { ask<&Nodes::put>(x, v); }
  auto read(bool velocity) const { return ask<&Nodes::read>(velocity); }
  bool advance(long count) { return ask<&Nodes::advance>(count); }
  bool examine() { return ask<&Nodes::examine>(); }
  auto strains() const { return ask<&Nodes::strains>(); }
  void keep() { ask<&Nodes::keep>(); }
  void restore() { ask<&Nodes::restore>(); }
  int levels() const { return nodes_->levels(); }
  std::size_t bytes() const { return nodes_->bytes(); }

 private:
  std::unique_ptr<Nodes> nodes_;
  std::unique_ptr<PartsOnRanks> parts_;

  template <auto function>
  auto ask(auto const&... arguments) const {
    return Calls::template ask<function>(*parts_, *nodes_, arguments...);
  }
};

/// Those of another rank.
template <class Nodes>
class PartOf final : public RankPart {
 public:
  explicit PartOf(auto const&... arguments) : nodes_(arguments...) {}
  void answer(PartCall const& call) override { NodesOnRanks<Nodes>::Calls::answer(nodes_, call); }

 private:
  Nodes nodes_;
};

}  // namespace actio::media::detail
