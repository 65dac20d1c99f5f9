// Something other than a medium that rank 0 has on all ranks, and commands.
#pragma once

#include "actio/fast_media/nodes_on_ranks.hpp"

namespace actio::media {

/// Held by rank 0: the others have what \ref share_media makes of its name, as long as this is there.
class PartOnRanks {
 public:
  /// @param name  from which the others make their parts
  PartOnRanks(Ranks& ranks, std::string name) : ranks_(ranks) {
    static int made = 0;
    which_ = --made;  // media have the numbers above zero
    tell(detail::NodesCall::make);
    detail::agree(ranks_, name);
  }
  PartOnRanks(PartOnRanks const&) = delete;
  PartOnRanks& operator=(PartOnRanks const&) = delete;
  ~PartOnRanks() { detail::say_last(ranks_, {detail::NodesCall::drop, which_, 0, 0}); }

  /// Lets all parts answer, each with the same.
  void wake() { tell(detail::NodesCall::advance); }

 private:
  void tell(detail::NodesCall::Kind kind) {
    detail::NodesCall call{kind, which_, 0, 0};
    detail::agree(ranks_, call);
  }
  Ranks& ranks_;
  int which_ = 0;
};

}  // namespace actio::media
