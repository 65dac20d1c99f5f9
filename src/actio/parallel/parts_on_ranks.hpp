// Objects that several ranks share, commanded by rank 0: it runs one program, and what this asks of such an
// object it asks of all ranks. The others have parts of it and do nothing else.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <tuple>

#include "actio/numbers/errors.hpp"
#include "actio/parallel/ranks.hpp"

namespace actio {

/// What rank 0 asks for.
struct PartCall {
  int what = 0;                        ///< of what the object can do; or one of those below
  int which = 0;                       ///< of the objects that there are
  std::array<double, 4> numbers = {};  ///< what else there is to say

  static constexpr int make = -1;   ///< a part of a new object
  static constexpr int drop = -2;   ///< it is gone
  static constexpr int leave = -3;  ///< there is nothing more to do

  /// Says it to all others, or hears it.
  static void agree(Ranks& ranks, PartCall& call) {
    ranks.broadcast(std::as_writable_bytes(std::span(&call, 1)));
  }
  /// The same of a text, or of numbers.
  template <class List>
  static void agree(Ranks& ranks, List& list) {
    std::size_t size = list.size();
    ranks.broadcast(std::as_writable_bytes(std::span(&size, 1)));
    list.resize(size);
    ranks.broadcast(std::as_writable_bytes(std::span(list)));
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
    say({.what = PartCall::make, .numbers = {number}});
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
  [[nodiscard]] Asked ask(PartCall const& call) const {
    if (ranks_ && depth_ == 0) say(call);
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

/// Functions of an object that all ranks do together, told by their places in this list.
///
/// Numbers among their arguments are told too. Whatever else they take rank 0 has alone: on the others it is
/// empty, and the functions bring what they need of it.
template <auto... functions>
struct PartCalls {
  /// Does one of them on all ranks.
  template <auto function, class Object>
  static auto ask(PartsOnRanks const& parts, Object& object, auto&&... arguments) {
    static_assert((is_same<functions, function> || ...), "a function of the list");
    PartCall call;
    ((is_same<functions, function> || (++call.what, false)) || ...);
    each_number(
        call, [](double& told, auto number) { told = static_cast<double>(number); }, arguments...);
    auto const asked = parts.ask(call);
    return std::invoke(function, object, arguments...);
  }
  /// Does on another rank what has been asked.
  template <class Object>
  static void answer(Object& object, PartCall const& call) {
    int place = 0;
    ((place++ == call.what && (answer_by(object, functions, call), true)) || ...);
  }

 private:
  template <auto one, auto other>
  static constexpr bool is_same = std::is_same_v<std::integral_constant<decltype(one), one>,
                                                 std::integral_constant<decltype(other), other>>;
  /// Calls f(what is told, number) for the numbers among the arguments.
  static void each_number(auto& call, auto const& f, auto&... arguments) {
    static_assert((0 + ... + std::is_arithmetic_v<std::remove_cvref_t<decltype(arguments)>>) <=
                  std::tuple_size_v<decltype(PartCall::numbers)>);
    [[maybe_unused]] auto told = call.numbers.begin();
    [[maybe_unused]] auto const visit = [&]<class T>(T& argument) {
      if constexpr (std::is_arithmetic_v<T>) f(*told++, argument);
    };
    (visit(arguments), ...);
  }
  template <class... Arguments>
  static void call_with(PartCall const& call, auto const& function) {
    std::tuple<std::decay_t<Arguments>...> all;
    auto const hear = []<class T>(double told, T& number) { number = static_cast<T>(told); };
    std::apply([&](auto&... one) { each_number(call, hear, one...), function(one...); }, all);
  }
  template <class Class, class Result, class... Arguments>
  static void answer_by(auto& object, Result (Class::*function)(Arguments...), PartCall const& call) {
    call_with<Arguments...>(call, [&](auto&... one) { (object.*function)(one...); });
  }
  template <class Class, class Result, class... Arguments>
  static void answer_by(auto& object, Result (Class::*function)(Arguments...) const, PartCall const& call) {
    call_with<Arguments...>(call, [&](auto&... one) { (object.*function)(one...); });
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
