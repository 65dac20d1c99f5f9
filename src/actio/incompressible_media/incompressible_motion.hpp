// An incompressible medium in motion: its steps, and what can be read off it (chapter 10C of the book). Media
// in the plane and in space, and the fluid on the sphere, say what acts on them.
#pragma once

#include "actio/incompressible_media/incompressible_steps.hpp"

namespace actio::media {

/// An incompressible medium in motion.
///
/// Where ranks share it, each has such an object, made in the same way. That of rank 0 is asked, and asks the
/// others to do what they have to do with it (\ref PartsOnRanks): what cells and nodes are is known to all,
/// places and velocities of rows of others are copied when they are asked for.
template <class Cell>
class IncompressibleMotion : protected IncompressibleSteps<Cell> {
  using Steps = IncompressibleSteps<Cell>;

 public:
  static constexpr int N = Cell::space;  ///< components of a place
  using Place = std::array<double, N>;   ///< a place, or a velocity

  /// What rank 0 asks of the others.
  using Calls =
      PartCalls<&Steps::step, &Steps::look_ahead, &Steps::change_step, &Steps::bring, &Steps::velocities,
                &Steps::pressures, &Steps::volume_defect, &Steps::remember, &Steps::restore>;

  /// So many steps on.
  /// @throws CellFolds, VolumesUnsolved  where there is no such step; the state is that before it
  /// @throws OutsideDomain  where count is negative
  void step(long count = 1) { ask<&Steps::step>(count); }
  /// Until the next step the state is that so long after the last one; zero: that of the last step again.
  /// \copydetails step
  void look_ahead(double time) { ask<&Steps::look_ahead>(time); }
  /// One step of another length, and from then on steps of a third one.
  /// @param first  of the one step; zero: there is none
  /// @param step   of those that follow
  /// @param made   how many of these are counted as made: the product is the time
  void change_step(double first, double step, long made) { ask<&Steps::change_step>(first, step, made); }
  /// The time of the last step.
  double time() const { return Steps::time(); }
  /// How many steps have been made.
  long steps() const { return this->steps_; }
  /// The time step.
  double time_step() const { return this->step_; }

  /// Places of the nodes, length.
  std::vector<Place> places() const { return points(y()); }
  /// Velocities of the nodes now, length/time, which change no volume: the second multiplier of RATTLE.
  std::vector<Place> velocities() { return points(whole_velocities()); }
  /// The masses of the nodes.
  std::vector<double> const& masses() const { return volumes_.masses; }
  /// The pressure in each cell now, by the multiplier of the step that begins here; its mean by volume is
  /// zero where it is known up to a constant.
  /// \copydetails step
  std::vector<double> pressures() { return ask<&Steps::pressures>(); }
  /// \f$\tfrac12\sum m|v|^2\f$ of \ref velocities.
  double kinetic_energy() {
    double sum = 0;
    auto const v = whole_velocities();
    for (std::size_t k = 0; k < v.size(); ++k) sum += 0.5 * masses()[k / N] * v[k] * v[k];
    return sum;
  }
  /// \f$\sum mv\f$, mass x length/time: kept to rounding where nothing is held and no load acts.
  Place momentum() { return body_now().template momentum<N>(masses()); }
  /// \f$\sum m\,y\times v\f$, mass x area/time; in the plane the third component.
  std::array<double, 3> angular_momentum() { return body_now().template angular_momentum<N>(masses()); }
  /// The largest modulus of A/A^0 - 1 over all cells.
  double volume_defect() const { return ask<&Steps::volume_defect>(); }
  /// For each cell the least Jacobian at its corners, over that of the reference.
  std::vector<double> jacobians() const {
    auto const J = volumes_.volumes.corner_jacobians(y());
    std::vector<double> out(volumes_.kept.size(), HUGE_VAL);
    for (std::size_t k = 0; k < J.size(); ++k)
      out[k / Cell::corners] = std::min(out[k / Cell::corners], J[k] / this->reference_jacobians_[k]);
    return out;
  }
  /// How many rounds the last step took.
  int rounds() const { return volumes_.rounds; }
  /// Whether pressures are known up to a constant: nothing changes the volume of the whole.
  bool is_closed() const { return volumes_.pinned; }
  /// By how much the projection of the start changed the velocity of a node, at most.
  double projected() const { return this->projected_; }
  /// The whole state.
  std::vector<double> remember() { return ask<&Steps::remember>(); }
  /// Goes on from a state that was remembered, bit for bit.
  /// @throws OutsideDomain  where it is of another size
  void restore(std::vector<double> const& from) { ask<&Steps::restore>(from); }
  /// Does what rank 0 asks, on another one. What it throws is thrown on rank 0 too.
  void answer(PartCall const& call) { Calls::answer(static_cast<Steps&>(*this), call); }

 protected:
  using Steps::Steps, Steps::volumes_, Steps::state_;

  /// The volumes and the kind of the cells.
  MeshVolumes<Cell> const& cells() const { return volumes_.volumes; }
  /// Places of all nodes now.
  std::vector<double> const& y() const {
    if (!this->is_whole()) ask<&Steps::bring>();
    return state_.at.y;
  }

 private:
  template <auto function>
  auto ask(auto const&... arguments) {
    return Calls::template ask<function>(this->parts_, static_cast<Steps&>(*this), arguments...);
  }
  template <auto function>
  auto ask(auto const&... arguments) const {
    return Calls::template ask<function>(this->parts_, static_cast<Steps const&>(*this), arguments...);
  }
  std::vector<double> whole_velocities() { return ask<&Steps::velocities>(); }
  /// Places and velocities as sums over a body need them.
  BodyState body_now() {
    BodyState out;
    out.x = y(), out.v = whole_velocities();
    return out;
  }
  static std::vector<Place> points(std::vector<double> const& in) {
    std::vector<Place> out(in.size() / N);
    for (std::size_t k = 0; k < in.size(); ++k) out[k / N][k % N] = in[k];
    return out;
  }
};

}  // namespace actio::media
