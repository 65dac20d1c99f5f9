// Packs of pairs, and the kernels that move them.
// In a unit of its own
#include "actio/two_bodies/side_by_side.hpp"

#include "actio/numbers/dual_pack.hpp"
#include "actio/numbers/registers.hpp"

namespace actio::bodies {
namespace detail {
namespace {

/// The interaction at any time, without a third body.
template <class Force>
struct AtAnyTime {
  Force force;
  template <class T>
  [[gnu::always_inline]] Kick<T> operator()(Three<T> const& X, Four<T> const& q1, Four<T> const& q2,
                                            double) const {
    return force(X, q1, q2);
  }
};

/// Whether a motion goes on in numbers.
template <class S>
bool has_numbers(PairState<S> const& s) {
  double sum = 0;
  for (auto const* const x : {&s.position, &s.momentum, &s.body_1, &s.body_2})
    sum += base_value(dot(x->value, x->value));
  return is_finite(sum);
}

}  // namespace

/// What may see the inside of TwoBodies.
struct SideBySide {
  /// Pairs of one pack.
  using Pairs = std::span<TwoBodies const>;

  /// How many pairs from the first on share a pack.
  static std::size_t together(Pairs pairs) {
    auto const& a = pairs[0];
    auto const& of_a = a.options_.method;
    if (best_registers() == Registers::plain || a.force_.index() > 1 || of_a.rotor != Rotor::exact ||
        a.third_ || a.tides_)
      return 1;
    std::size_t const lanes = best_registers() == Registers::avx512 ? 8 : 4;
    std::size_t size = 1;
    for (; size < std::min(lanes, pairs.size()); ++size) {
      auto const& b = pairs[size];
      auto const& of_b = b.options_.method;
      if (b.force_.index() != a.force_.index() || of_b.rotor != Rotor::exact || b.third_ || b.tides_ ||
          b.options_.step != a.options_.step || b.steps_ != a.steps_ || of_b.kepler != of_a.kepler ||
          of_b.splitting.drifts != of_a.splitting.drifts || of_b.splitting.kicks != of_a.splitting.kicks)
        break;
    }
    return size;
  }

  /// Pairs in the lanes of a pack; the last one fills the lanes that are left.
  /// @tparam T  a pack, or dual numbers over one
  template <int order, class T>
  struct Group {
    using C = Base<T>;                                                 ///< the pack
    using One = std::conditional_t<is_dual<T>, Dual<double>, double>;  ///< what a lane holds
    template <class S>
    using ForceOf = std::conditional_t<order == 2, SecondOrderForce<S>, FourthOrderForce<true, S>>;

    TwoBodies const& model;
    std::size_t size;
    PairSetting<C> setting;
    std::vector<PairStage<C>> stages;
    AtAnyTime<ForceOf<C>> force;
    PairState<T> state;
    std::array<bool, C::lanes> lost{};
    int terms_1, terms_2;

    explicit Group(Pairs pairs)
        : model(pairs[0]),
          size(pairs.size()),
          stages(model.stages_.size()),
          terms_1(model.terms_1_),
          terms_2(model.terms_2_) {
      for (std::size_t i = 0; i < stages.size(); ++i)
        stages[i].time = model.stages_[i].time, stages[i].kick = model.stages_[i].kick;
      for (int k = 0; k < C::lanes; ++k) {
        TwoBodies const& pair = pairs[std::min<std::size_t>(static_cast<std::size_t>(k), size - 1)];
        set_lane(setting, k, pair.setting_), set_lane(force.force, k, std::get<ForceOf<double>>(pair.force_));
        for (std::size_t i = 0; i < stages.size(); ++i) {
          set_lane(stages[i].body_1, k, pair.stages_[i].body_1);
          set_lane(stages[i].body_2, k, pair.stages_[i].body_2);
        }
        if constexpr (is_dual<T>)
          set_lane(state, k, without_rates(pair.state_));
        else
          set_lane(state, k, pair.state_);
      }
    }
    PairState<One> lane(int k) const { return in_lane<PairState<One>>(state, k); }
    /// Steps. A lane that loses its numbers goes on with those of a sound one, for its neighbours to be fast.
    /// @return  whether there is a sound one
    bool step(long from, long count) {
      auto const& method = model.options_.method;
      double const h = model.options_.step;
      PairSteps<T, AtAnyTime<ForceOf<C>>> kernel{setting,
                                                 method.kepler,
                                                 false,
                                                 stages,
                                                 method.splitting.kicks.front() * h,
                                                 method.splitting.kicks.back() * h,
                                                 force,
                                                 h,
                                                 0,
                                                 from,
                                                 count,
                                                 state,
                                                 terms_1,
                                                 terms_2};
      if constexpr (C::lanes == 8)
        actio::detail::run_with_avx512(kernel);
      else
        actio::detail::run_with_avx2(kernel);
      state = kernel.state, terms_1 = kernel.terms_1, terms_2 = kernel.terms_2;
      int sound = -1;
      for (int k = 0; k < C::lanes; ++k) {
        double const radii = in_lane<double>(setting.radii, k);
        bool const near = in_lane<double>(kernel.nearest_square, k) <= radii * radii;
        if (lost[k] |= near || !has_numbers(lane(k)); !lost[k]) sound = k;
      }
      for (int k = 0; sound >= 0 && k < C::lanes; ++k)
        if (lost[k]) set_lane(state, k, lane(sound));
      return sound >= 0;
    }
  };
  /// Calls a function with the group of some pairs.
  template <bool tangent, class Do>
  static auto with_group(Pairs pairs, Do const& act) {
    auto const of_order = [&]<class B>(B) {
      using T = std::conditional_t<tangent, Dual<B>, B>;
      return pairs[0].force_.index() == 0 ? act(Group<2, T>(pairs)) : act(Group<4, T>(pairs));
    };
    return best_registers() == Registers::avx512 ? of_order(Pack<8>()) : of_order(Pack<4>());
  }

  /// @return  the places of those that could not move
  static std::vector<std::size_t> step(std::span<TwoBodies> pairs, long count) {
    return with_group<false>(pairs, [&](auto group) {
      constexpr long most = 256;
      for (long done = 0, next; done < count; done += next) {
        next = std::min(most, count - done);
        if (!group.step(group.model.steps_ + done, next)) break;
      }
      std::vector<std::size_t> failed;
      for (std::size_t k = 0; k < pairs.size(); ++k) {
        auto& pair = pairs[k];
        auto const before = pair.state_;
        pair.state_ = group.lane(static_cast<int>(k));
        if (group.lost[k] || !(pair.nearness() < 1))
          pair.state_ = before, failed.push_back(k);
        else
          pair.steps_ += count, pair.terms_1_ = group.terms_1, pair.terms_2_ = group.terms_2;
      }
      return failed;
    });
  }
  static std::vector<double> exponents(Pairs pairs, long count, long every) {
    return with_group<true>(pairs, [&](auto group) {
      std::vector<Growth> growth;
      for (auto const& pair : pairs) growth.emplace_back(pair.tangent_units(), pair.setting_);
      for (long done = 0, next; done < count; done += next) {
        next = std::min(every, count - done);
        for (std::size_t k = 0; k < pairs.size(); ++k) {
          auto one = group.lane(static_cast<int>(k));
          growth[k].enter(one), set_lane(group.state, static_cast<int>(k), one);
        }
        if (!group.step(group.model.steps_ + done, next)) break;
        for (std::size_t k = 0; k < pairs.size(); ++k)
          if (!group.lost[k]) growth[k].leave(group.lane(static_cast<int>(k)));
      }
      std::vector<double> all;
      double const time = static_cast<double>(count) * std::abs(group.model.options_.step);
      for (std::size_t k = 0; k < pairs.size(); ++k)
        all.push_back(group.lost[k] ? std::numeric_limits<double>::quiet_NaN()
                                    : growth[k].logarithm() / time);
      return all;
    });
  }
};

}  // namespace detail

std::vector<std::size_t> step_side_by_side(std::span<TwoBodies> pairs, long count) {
  if (count < 0)
    throw OutsideDomain("two bodies", "the number of steps must not be negative", static_cast<double>(count),
                        0);
  std::vector<std::size_t> failed;
  for (std::size_t first = 0, size; first < pairs.size() && count > 0; first += size) {
    size = detail::SideBySide::together(pairs.subspan(first));
    if (size > 1) {
      for (auto const k : detail::SideBySide::step(pairs.subspan(first, size), count))
        failed.push_back(first + k);
    } else {
      try {
        pairs[first].step(count);
      } catch (Error const&) {
        failed.push_back(first);
      }
    }
  }
  return failed;
}

std::vector<double> lyapunov_exponents(std::span<TwoBodies const> pairs, long count, long every) {
  if (count < 1 || every < 1)
    throw OutsideDomain("Lyapunov exponent", "numbers of steps must be positive",
                        static_cast<double>(std::min(count, every)), 1);
  std::vector<double> all;
  for (std::size_t first = 0, size; first < pairs.size(); first += size) {
    size = detail::SideBySide::together(pairs.subspan(first));
    if (size > 1) {
      auto const some = detail::SideBySide::exponents(pairs.subspan(first, size), count, every);
      all.insert(all.end(), some.begin(), some.end());
    } else {
      try {
        all.push_back(pairs[first].lyapunov_exponent(count, every));
      } catch (OutsideDomain const&) {
        throw;
      } catch (Error const&) {
        all.push_back(std::numeric_limits<double>::quiet_NaN());
      }
    }
  }
  return all;
}

}  // namespace actio::bodies
