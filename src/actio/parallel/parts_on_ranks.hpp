// Objects that several ranks share, commanded by rank 0: it runs one program, and what this asks of such an
// object it asks of all ranks. The others have parts of it and do nothing else.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>

#include "actio/numbers/errors.hpp"
#include "actio/parallel/ranks.hpp"

namespace actio {

/// What rank 0 asks for.
struct PartCall {
  int what = 0;                ///< of what the object can do; or one of those below
  int which = 0;               ///< of the objects that there are
  long count = 0;              ///< of steps, or whatever is counted
  double numbers[2] = {0, 0};  ///< what else there is to say

  static constexpr int make = -1;   ///< a part of a new object
  static constexpr int drop = -2;   ///< it is gone
  static constexpr int leave = -3;  ///< there is nothing more to do

  /// Says it to all others, or hears it.
  static void agree(Ranks& ranks, PartCall& call) {
    ranks.broadcast(std::as_writable_bytes(std::span(&call, 1)));
  }
  /// The same of a text.
  static void agree(Ranks& ranks, std::string& text) {
    std::size_t size = text.size();
    ranks.broadcast(std::as_writable_bytes(std::span(&size, 1)));
    text.resize(size);
    ranks.broadcast(std::as_writable_bytes(std::span(text)));
  }
};

/// What a rank other than the first has of an object.
class RankPart {
 public:
  virtual ~RankPart() = default;
  /// Does what rank 0 asks of it. An \ref Error that it throws, rank 0 has thrown too.
  virtual void answer(PartCall const& call) = 0;
};

/// A part that is an object like that of rank 0, and can answer.
template <class Object>
class LikePart final : public RankPart {
 public:
  explicit LikePart(std::unique_ptr<Object> object) : object_(std::move(object)) {}  ///< Holds it.
  void answer(PartCall const& call) override { object_->answer(call); }

 private:
  std::unique_ptr<Object> object_;
};

/// The parts of an object, a member of it: made with it and gone with it. Rank 0 asks them; on other ranks,
/// and where there are none, it does nothing.
class PartsOnRanks {
 public:
  /// @param ranks  null: this process is alone
  /// @param told   of the object
  /// @param number what else is told
  PartsOnRanks(Ranks* ranks, std::string told, double number = 0)
      : ranks_(ranks && ranks->size() > 1 && ranks->rank() == 0 ? ranks : nullptr),
        mine_(!ranks || ranks->rank() == 0) {
    if (!ranks_) return;
    static int made = 0;
    which_ = ++made;
    say({.what = PartCall::make, .numbers = {number, 0}});
    PartCall::agree(*ranks_, told);
  }
  PartsOnRanks(PartsOnRanks const&) = delete;             ///< One object has them.
  PartsOnRanks& operator=(PartsOnRanks const&) = delete;  ///< \copydoc PartsOnRanks(PartsOnRanks const&)
  ~PartsOnRanks() {
    // A rank that is gone need not hear it.
    try {
      if (ranks_) say({.what = PartCall::drop});
    } catch (std::exception const&) {
    }
  }
  /// Whether the object is that of rank 0, or of a process alone.
  bool here() const { return mine_; }
  /// While it lives, what is called is part of what has been asked.
  class Asked {
   public:
    explicit Asked(int& depth) : depth_(depth) { ++depth_; }  ///< Counts it.
    Asked(Asked const&) = delete;                             ///< Asked once.
    Asked& operator=(Asked const&) = delete;                  ///< \copydoc Asked(Asked const&)
    ~Asked() { --depth_; }                                    ///< What follows is asked again.

   private:
    int& depth_;
  };
  /// Asks all parts to do what this rank is about to do; nothing within what has been asked.
  /// @param numbers  are told too; the other ranks know how many
  [[nodiscard]] Asked ask(PartCall const& call, std::vector<double> const& numbers = {}) const {
    if (ranks_ && depth_ == 0) {
      say(call);
      auto told = numbers;
      if (!told.empty()) ranks_->broadcast(bytes_of(told));
    }
    return Asked(depth_);
  }

 private:
  Ranks* ranks_;
  bool mine_;
  int which_ = 0;
  mutable int depth_ = 0;

  void say(PartCall call) const {
    call.which = which_;
    PartCall::agree(*ranks_, call);
  }
};

/// One program on all ranks: rank 0 does `work`, and the others do with their parts of its objects what it
/// asks, until `work` has returned or thrown.
/// @param part  of an object, of what rank 0 tells of it, a text and a number
/// @throws what `work` throws, on rank 0
inline void share_parts(Ranks& ranks,
                        std::function<std::unique_ptr<RankPart>(std::string const&, double)> const& part,
                        std::function<void()> const& work) {
  if (ranks.rank() == 0) {
    /// Lets the other ranks go.
    struct Leave {
      Ranks& ranks;
      ~Leave() {
        try {
          PartCall last{.what = PartCall::leave};
          PartCall::agree(ranks, last);
        } catch (std::exception const&) {
        }
      }
    } const leave{ranks};
    return work();
  }
  std::map<int, std::unique_ptr<RankPart>> parts;
  for (;;) {
    PartCall call{};
    PartCall::agree(ranks, call);
    if (call.what == PartCall::leave) return;
    try {
      if (call.what == PartCall::make) {
        std::string told;
        PartCall::agree(ranks, told);
        parts[call.which] = part(told, call.numbers[0]);
      } else if (call.what == PartCall::drop) {
        parts.erase(call.which);
      } else {
        parts.at(call.which)->answer(call);
      }
    } catch (Error const&) {
    }
  }
}

}  // namespace actio
