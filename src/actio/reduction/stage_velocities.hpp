// The velocities at the stages of an explicit step, from momenta.
#pragma once

#include <any>
#include <utility>

#include "actio/reduction/legendre_chord.hpp"
#include "actio/reduction/level_flow.hpp"

namespace actio::detail {

/// Velocities of momenta at the stages of a step: by a line where they are found to be on one, which is
/// checked in the middle and at the end. Where a check has failed once, no line is taken any more.
template <Group G, Real S>
class StageVelocities {
 public:
  explicit StageVelocities(Velocity<G, S> const& near) : xi_(near) {}
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
    bool const linear = lines_ && legendre_.linear();
    if (linear) legendre_.by_line(mu, xi_);
    if (linear && !check) return true;
    legendre_.solve(l, mu, xi_);
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
  bool lines_ = true;  // no check has failed
};

/// The slopes of a Lagrangian in an advected vector at the stages of an explicit step: the one at the start
/// where they are found to be the same all along, which is checked in the middle and at the end. Where a
/// check has failed once, each is computed.
template <class Column>
class StageSlopes {
 public:
  /// @param first, check  whether it is the first stage, and one at which a constant slope is checked
  /// @param slope         () -> the slope there
  /// @return              false where slopes were taken for the same, and are not
  template <class Slope>
  bool find(bool first, bool check, Slope const& slope) {
    if (constant_ && !first && !check) return true;
    Column const now = slope();
    ++evaluations_;
    constant_ = constant_ && (first || now == slope_);
    bool const goes_on = constant_ || learned_;
    learned_ = !constant_, slope_ = now;
    return goes_on;
  }
  /// The last one.
  Column const& slope() const { return slope_; }
  /// How many were computed since the last call.
  int take_evaluations() { return std::exchange(evaluations_, 0); }

 private:
  Column slope_ = {};
  bool constant_ = true, learned_ = false;  // no check has failed; one has failed before
  int evaluations_ = 0;
};

/// What a step on a level of the momentum leaves to the next one of the same group.
/// @tparam V  a column of coordinates of the algebra
/// @tparam U  a column like the advected vector
template <Group G, Real S, int side, class B, class V, class U = Matrix<S, 0, 1>>
struct LevelMemory {
  using Flow = LevelFlow<side, B, V, U>;  ///< of momenta and vectors
  G group;                                ///< whose commutators these are
  StageVelocities<G, S> velocities;       ///< found at the stages
  StageSlopes<U> slopes;                  ///< likewise
  Flow flow;                              ///< of the group

  /// The memory of the last call, where it was of this group and of vectors of this length; a new one
  /// otherwise.
  /// @param action  () -> that of the group on vectors
  template <class Make>
  static LevelMemory& of(std::any& last, Velocity<G, S> const& near, U const& nothing, Make const& action) {
    auto* const kept = std::any_cast<LevelMemory>(&last);
    if (kept && known_to_be_same(kept->group, near.group) && kept->flow.length() == nothing.size())
      return *kept;
    V const zero = V::Zero(near.group.dimension());
    return last.emplace<LevelMemory>(LevelMemory{near.group,
                                                 StageVelocities<G, S>(near),
                                                 {},
                                                 Flow(Commutators<B>(near.group), action(), zero, nothing)});
  }
};

}  // namespace actio::detail
