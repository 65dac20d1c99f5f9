// The nodes of a medium on several ranks, commanded by rank 0.
//
// Rank 0 runs whatever program it runs, with a medium whose nodes are these: what it asks of them it asks of
// all ranks. The others do nothing but what rank 0 asks, until it is done (`share_media`).
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>

#include "actio/parallel/ranks.hpp"

namespace actio::media {
namespace detail {

/// What rank 0 asks for.
struct NodesCall {
  enum Kind : int { make, put, places, velocities, advance, examine, keep, restore, drop, leave } kind;
  int which;      ///< of the nodes that there are
  long count;     ///< of steps
  double number;  ///< the length of a step
};

/// Says it to all others, or hears it.
inline void agree(Ranks& ranks, NodesCall& call) {
  ranks.broadcast(std::as_writable_bytes(std::span(&call, 1)));
}
/// A number for a medium that several ranks have.
inline int next_medium() {
  static int made = 0;
  return ++made;
}
/// The same on the way out: a rank that is gone need not hear it.
inline void say_last(Ranks& ranks, NodesCall call) noexcept {
  try {
    agree(ranks, call);
  } catch (std::exception const&) {
  }
}
/// The same of a text.
inline void agree(Ranks& ranks, std::string& text) {
  std::size_t size = text.size();
  ranks.broadcast(std::as_writable_bytes(std::span(&size, 1)));
  text.resize(size);
  ranks.broadcast(std::as_writable_bytes(std::span(text)));
}

/// Nodes of this process, or those of all ranks, seen from rank 0.
/// @tparam Nodes  `FusedRows2d` or `FusedPlanes3d`
template <class Nodes>
class NodesOnRanks {
 public:
  /// The steps of a medium.
  template <class Box, class Cell, class Options>
  NodesOnRanks(Box const& box, Cell const& cell, double dt, Options const& options)
      : nodes_(std::make_unique<Nodes>(box, cell, dt, options)) {
    if (!options.ranks || options.ranks->size() == 1) return;
    call_.reset(new Call{*options.ranks, next_medium()});
    ask(NodesCall::make, 0, dt);
    std::string told = options.told;
    agree(*options.ranks, told);
  }

  void put(auto const& x, auto const& v) { ask(NodesCall::put), nodes_->put(x, v); }
  auto read(bool velocity) const {
    ask(velocity ? NodesCall::velocities : NodesCall::places);
    return nodes_->read(velocity);
  }
  bool advance(long count) { return ask(NodesCall::advance, count), nodes_->advance(count); }
  bool examine() { return ask(NodesCall::examine), nodes_->examine(); }
  void keep() { ask(NodesCall::keep), nodes_->keep(); }
  void restore() { ask(NodesCall::restore), nodes_->restore(); }
  int levels() const { return nodes_->levels(); }
  std::size_t bytes() const { return nodes_->bytes(); }

 private:
  /// Its nodes leave all ranks with it.
  struct Call {
    Ranks& ranks;
    int which;
    ~Call() { say_last(ranks, {NodesCall::drop, which, 0, 0}); }
  };
  void ask(NodesCall::Kind kind, long count = 0, double number = 0) const {
    if (!call_) return;
    NodesCall call{kind, call_->which, count, number};
    agree(call_->ranks, call);
  }

  std::unique_ptr<Nodes> nodes_;
  std::unique_ptr<Call> call_;
};

}  // namespace detail

/// The part of a medium that is on a rank other than the first.
class MediumPart {
 public:
  virtual ~MediumPart() = default;
  virtual void answer(detail::NodesCall const& call) = 0;  ///< does what rank 0 asks of it
};

namespace detail {

/// Those of one kind of nodes.
template <class Nodes>
class PartOf final : public MediumPart {
 public:
  explicit PartOf(auto const&... arguments) : nodes_(arguments...) {}
  void answer(NodesCall const& call) override {
    switch (call.kind) {
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

}  // namespace detail

/// One program on all ranks: rank 0 does `work`, whose media (\ref FastMedium with these ranks among its
/// options) end with it; the others step their parts of them, until `work` has returned or thrown.
/// @param part  the part of a medium, of what rank 0 tells of it (`FastOptions::told`) and the length of its
///              steps: \ref medium_part
/// @throws what `work` throws, on rank 0
inline void share_media(Ranks& ranks,
                        std::function<std::unique_ptr<MediumPart>(std::string const&, double)> const& part,
                        std::function<void()> const& work) {
  if (ranks.rank() == 0) {
    /// Lets the other ranks go.
    struct Leave {
      Ranks& ranks;
      ~Leave() { detail::say_last(ranks, {detail::NodesCall::leave, 0, 0, 0}); }
    } const leave{ranks};
    return work();
  }
  std::map<int, std::unique_ptr<MediumPart>> parts;
  for (;;) {
    detail::NodesCall call{};
    detail::agree(ranks, call);
    if (call.kind == detail::NodesCall::leave) return;
    if (call.kind == detail::NodesCall::make) {
      std::string told;
      detail::agree(ranks, told);
      parts[call.which] = part(told, call.number);
    } else if (call.kind == detail::NodesCall::drop) {
      parts.erase(call.which);
    } else {
      parts.at(call.which)->answer(call);
    }
  }
}

}  // namespace actio::media
