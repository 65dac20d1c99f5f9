// The velocities at the stages of an explicit step, from momenta.
#pragma once

#include <any>

#include "actio/reduction/legendre_chord.hpp"
#include "actio/reduction/level_flow.hpp"

namespace actio::detail {

/// Velocities of momenta at the stages of a step: by a line where they are found to be on one, which is
/// checked in the middle and at the end. Where a check has failed once, no line is taken any more.
template <Group G, Real S>
class StageVelocities {
 public:
  explicit StageVelocities(Velocity<G, S> const& near) : xi_(near), mu_{near.group, near.coordinates} {}
  /// Before a step from a velocity.
  template <class F>
  void begin(F const& l, Velocity<G, S> const& from) {
    xi_ = from;
    legendre_.begin(l, from);
  }
  /// The velocity of a momentum at a stage.
  /// @param check  whether a line is checked by a gradient
  /// @return       false where velocities were taken for a linear function of momenta, and are none
  template <class F>
  bool find(F const& l, Coordinates<G, S> const& mu, bool check) {
    mu_.components = mu;
    bool const linear = lines_ && legendre_.linear();
    if (linear) legendre_.by_line(mu_, xi_);
    if (linear && !check) return true;
    legendre_.solve(l, mu_, xi_);
    lines_ = lines_ && (!linear || legendre_.linear());
    return !linear || lines_;
  }
  /// The last one found.
  Velocity<G, S> const& velocity() const { return xi_; }
  int take_gradients() { return legendre_.take_gradients(); }
  /// Saves, or restores, what one step leaves to the next.
  template <class Stream>
  void remember(Stream& stream) {
    legendre_.remember(stream, xi_.coordinates.size());
    stream(lines_);
  }

 private:
  LegendreChord<G, S> legendre_;
  Velocity<G, S> xi_;
  Momentum<G, S> mu_;
  bool lines_ = true;  // no check has failed
};

/// What a step on a level of the momentum leaves to the next one of the same group.
/// @tparam V  a column of the coordinates that move
template <Group G, Real S, int side, class B, class V>
struct LevelMemory {
  G group;                           ///< whose commutators these are
  StageVelocities<G, S> velocities;  ///< found at the stages
  LevelFlow<side, B, V> flow;        ///< of the group, or of a semidirect product with it

  /// What is left of the last call, where it was of this group and as many coordinates; new otherwise.
  /// @param commutators  () -> those of all coordinates
  template <class Make>
  static LevelMemory& of(std::any& last, Velocity<G, S> const& near, V const& zero, Make const& commutators) {
    auto* const kept = std::any_cast<LevelMemory>(&last);
    if (kept && known_to_be_same(kept->group, near.group) && kept->flow.size() == zero.size()) return *kept;
    return last.emplace<LevelMemory>(
        LevelMemory{near.group, StageVelocities<G, S>(near), LevelFlow<side, B, V>(commutators(), zero)});
  }
};

}  // namespace actio::detail
