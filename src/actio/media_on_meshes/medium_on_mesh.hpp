// A medium on any mesh of a body, in one, two or three dimensions: the generic implementation.
//
//     auto const mesh = box_mesh({0, 0, 0}, {4, 1, 1}, {16, 4, 4});
//     BodyStart<3> start;                                       // at rest, density 1
//     start.velocity = [](auto const& X) { return std::array{0.0, 0.1 * X[0], 0.0}; };
//     MediumOnMesh<3> beam(mesh, stored_energy<3>(neo_hookean(2, 1)), start, {.step = 0.01},
//                          {{"left", {Side::fixed}}});
//     beam.step(1000);
//
// The discrete Lagrangian of a slab of cells between two times is, as in the optimised implementation,
//
//     L_d = sum over nodes of (m/2)|x1-x0|^2/dt - (dt/2)(E(x0)+E(x1)), E = sum over points of weight W(F),
//
// minus the energy of loads; its Euler-Lagrange field equations are the explicit step. `conserve = energy`
// takes a step that conserves energy in place of the multisymplectic form; both keep momenta.
//
// Accuracy: order 2 in space and time. Nothing resists the shear of a fluid: along lines where a mesh has a
// kink, as discs and balls of blocks have, its nodes are off by the first order, and by 1.5 in the mean.
#pragma once

#include "actio/media_on_meshes/body_on_rank.hpp"
#include "actio/media_on_meshes/body_start.hpp"
#include "actio/media_on_meshes/measured_body.hpp"

namespace actio::media {

/// A medium on a mesh of a body.
///
/// \snippet media.cpp medium_on_mesh
template <int d>
class MediumOnMesh : public MeasuredBody<d> {
 public:
  using Place = std::array<double, d>;                 ///< a point, or a vector
  using Law = std::shared_ptr<StoredEnergy<d> const>;  ///< a medium: \ref stored_energy

  /// @param ranks  others that make its steps with this one, where these are explicit and each
  ///   has a node; null: there are none
  /// @param told   of the medium, to them (\ref share_parts); each makes a \ref BodyOnRank of it
  /// @throws OutsideDomain, NotFinite  where the step, the density or the start is none
  /// @throws UnknownSide, NotABodyMesh  where sides and loads do not fit the mesh
  /// @throws BodyCellInverts  with step 0, where a cell is inside out at the start
  MediumOnMesh(BodyMesh mesh, Law law, BodyStart<d> const& start, BodyStepping const& stepping,
               BodySides<d> const& sides = {}, BodyLoads<d> const& loads = {}, Ranks* ranks = nullptr,
               std::string const& told = {})
      : MeasuredBody<d>((stepping.examine(), BodySteps<d>(mesh, law, start.density, sides, loads)), stepping),
        mesh_(std::move(mesh)),
        stepping_(stepping) {
    for (auto* part : {&state_.x, &state_.v}) part->reserve(d * mesh_.nodes.size());
    for (std::size_t k = 0; k < mesh_.nodes.size(); ++k) {
      Place X;
      for (int a = 0; a < d; ++a) X[a] = mesh_.nodes[k][a];
      Place const place = start.placement(X), rate = start.velocity(X);
      for (int a = 0; a < d; ++a) {
        if (!is_finite(place[a]) || !is_finite(rate[a]))
          throw NotFinite("medium: placement and velocity of node " + mesh_.node_name(static_cast<int>(k)));
        state_.x.push_back(place[a]), state_.v.push_back(rate[a]);
      }
    }
    steps_of_.held.put_places(state_.x, 0), steps_of_.held.put_velocities(state_.v, 0);
    state_.x_rest.assign(state_.x.size(), 0), state_.v_rest.assign(state_.x.size(), 0);
    if (stepping.viscosity.any()) {
      auto const& forces = steps_of_.forces;
      steps_of_.viscosity.emplace(stepping.viscosity, forces.body);
      steps_of_.viscosity->forces(forces.body, forces.law(), state_.x, state_.v, state_.viscous);
    }
    begin();
    if (ranks && ranks->size() > 1 && stepping.conserve == Conserve::form &&
        ranks->size() <= static_cast<int>(mesh_.nodes.size()))
      part_ =
          std::make_unique<BodyOnRank<d>>(*ranks, told, mesh_, law, start.density, stepping, sides, loads);
  }

  /// So many steps on.
  /// @throws BodyCellInverts  where a cell would turn inside out; then the state is that before this step, as
  ///   it is whatever else is thrown
  /// @throws NotFinite  where a load or a motion is none
  /// @throws BodyStepUnsolved  where a step that conserves energy is too long to be solved
  /// @throws OutsideDomain  where count is negative
  void step(long count = 1) {
    if (count < 0)
      throw OutsideDomain("medium", "the number of steps must not be negative", static_cast<double>(count),
                          0);
    look_ahead(0);
    if (part_ && count > 0) {
      long const made = part_->make(state_, forces_, is_known_, count, stepping_.step, steps_);
      steps_ += made, is_known_ = true;
      if (made == count) return;
      // What fails on a rank fails here again, and says why.
      go_on(stepping_.step, static_cast<double>(steps_ + 1) * stepping_.step);
      put_back();
      throw Error("medium: a step failed on another rank, and not here: the ranks do not compute alike");
    }
    for (; count > 0; --count) {
      go_on(stepping_.step, static_cast<double>(steps_ + 1) * stepping_.step);
      ++steps_;
    }
  }

  /// Until the next step the state is that so long after the last one, which one step of that length reaches;
  /// the steps go on as if it had not been. Zero: that of the last step again.
  /// @throws BodyCellInverts, NotFinite, NotConverged  where there is no such step
  void look_ahead(double time) {
    if (ahead_) put_back(), ahead_ = false;
    if (time > 0) go_on(time, this->time() + time), ahead_ = true;
  }

  /// One step of another length, and from then on steps of a third one.
  /// @param first  of the one step; zero: there is none
  /// @param step   of those that follow
  /// @param made   how many of these are counted as made: the product is the time
  /// @throws OutsideDomain, NotFinite  where there is no such step; and what \ref step throws
  void change_step(double first, double step, long made) {
    look_ahead(0);
    BodyStepping stepping = stepping_;
    stepping.step = step;
    stepping.examine();
    if (first > 0) go_on(first, static_cast<double>(made) * step);
    stepping_ = stepping, steps_ = made;
  }

  /// Steps of another length, before the first one is made: the start is the same for all.
  /// @throws OutsideDomain, NotFinite  where there is no such step, or steps have been made
  void set_time_step(double step) {
    if (steps_ > 0)
      throw OutsideDomain("medium", "the step has its length before the first one; steps made",
                          static_cast<double>(steps_), 0);
    BodyStepping stepping = stepping_;
    stepping.step = step;
    stepping.examine();
    stepping_ = stepping;
  }

  /// The time since the start.
  double time() const { return static_cast<double>(steps_) * stepping_.step; }
  /// How many steps have been made.
  long steps() const { return steps_; }
  /// The time step.
  double time_step() const { return stepping_.step; }
  /// The mesh of the body.
  BodyMesh const& mesh() const { return mesh_; }
  /// Memory for mesh, cells and states, bytes.
  std::size_t bytes() const {
    // A state, its copy, forces and their copy, an acceleration, and displacements with the places they are
    // from.
    return mesh_.bytes() + steps_of_.forces.body.bytes() + steps_of_.held.bytes() +
           14 * state_.x.size() * sizeof(double) +
           (steps_of_.viscosity ? steps_of_.viscosity->bytes() + 3 * state_.x.size() * sizeof(double) : 0);
  }

  /// The whole state: number of steps, places, velocities and their rests.
  std::vector<double> remember() const {
    std::vector<double> out;
    out.reserve(numbers_of_state());
    for_remembered([&](double const* from, std::size_t count) { out.insert(out.end(), from, from + count); });
    return out;
  }
  /// How many numbers \ref remember has.
  std::size_t numbers_of_state() const {
    return steps_of_.viscosity ? 2 + 5 * state_.x.size() : 1 + 4 * state_.x.size();
  }
  /// `visit(first, count)` for the parts of what \ref remember has, in their order and without a copy.
  template <class Visit>
  void for_remembered(Visit const& visit) const {
    double const steps = static_cast<double>(steps_);
    BodyState const& last = ahead_ ? kept_ : state_;
    visit(&steps, std::size_t{1});
    for (auto const* part : {&last.x, &last.v, &last.x_rest, &last.v_rest}) visit(part->data(), part->size());
    if (!steps_of_.viscosity) return;
    visit(last.viscous.data(), last.viscous.size());
    visit(&last.dissipated, std::size_t{1});
  }
  /// Goes on from a state that was remembered, bit for bit.
  /// @throws OutsideDomain  where it is of another size
  /// @throws BodyCellInverts  where a cell is inside out in it
  void restore(std::vector<double> const& remembered) {
    std::size_t const n = state_.x.size(), all = numbers_of_state();
    if (remembered.size() != all)
      throw OutsideDomain("medium",
                          "a remembered state has four numbers per component of a node and one more, "
                          "with viscosity five and two more",
                          static_cast<double>(remembered.size()), static_cast<double>(all));
    auto from = remembered.begin() + 1;
    for (auto* part : {&state_.x, &state_.v, &state_.x_rest, &state_.v_rest})
      part->assign(from, from + static_cast<long>(n)), from += static_cast<long>(n);
    if (steps_of_.viscosity) state_.viscous.assign(from, from + static_cast<long>(n));
    if (steps_of_.viscosity) state_.dissipated = remembered.back();
    steps_ = static_cast<long>(remembered[0]), ahead_ = false;
    begin();
  }

 private:
  BodyMesh mesh_;
  BodyStepping stepping_;
  using BodyMotion<d>::steps_of_, BodyMotion<d>::state_, BodyMotion<d>::kept_, BodyMotion<d>::forces_;
  using BodyMotion<d>::put_back, BodyMotion<d>::in_parts, BodyMotion<d>::attempt;
  std::unique_ptr<BodyOnRank<d>> part_;  // on this rank; null: there are no others
  bool is_known_ = false;                // whether they have this state
  long steps_ = 0;
  bool ahead_ = false;  // the state is one between two steps, and what was kept is that of the last step

  void begin() {
    is_known_ = false;
    LeastJacobian const least = steps_of_.forces.forces(state_.x, time(), forces_, state_.x_rest);
    if (!(least.jacobian > 0))
      throw BodyCellInverts(least.cell, mesh_.cell_name(least.cell), least.jacobian, {});
  }
  /// From the state now, which is kept, to another time.
  void go_on(double h, double end) {
    is_known_ = false;
    LeastJacobian least;
    try {
      least = in_parts(h, time(), end);
    } catch (NotConverged const& error) {
      refuse_unsolved(error, h);
    } catch (ViscosityNeedsShorterSteps const& error) {
      put_back();
      throw OutsideDomain("medium: viscosity of " + mesh_.cell_name(error.cell),
                          "a step is not longer than small motions take to be damped", error.measured,
                          error.bound);
    } catch (...) {
      put_back();
      throw;
    }
    if (!(least.jacobian > 0)) refuse(least, h);
  }
  /// Half of the step, a quarter, and so on: the first that would do from the state before the step, or 0.
  /// The state is that one afterwards.
  double shorter_step(double less) {
    // A step that is not solved takes as long as hundreds that are.
    int const halvings = stepping_.conserve == Conserve::form ? 30 : 10;
    bool sound = false;
    for (int halving = 0; halving < halvings && !sound; ++halving) {
      less /= 2;
      put_back();
      try {
        sound = attempt(less, time(), time() + less).jacobian > 0;
      } catch (Error const&) {
      }
    }
    put_back();
    return sound ? less : 0;
  }
  /// Puts the state before the step back, and throws.
  [[noreturn]] void refuse(LeastJacobian const& least, double step) {
    double const shorter = shorter_step(step), before = this->jacobians()[least.cell];
    throw BodyCellInverts(least.cell, mesh_.cell_name(least.cell), least.jacobian,
                          {steps_ + 1, step, before, shorter, this->largest_step()});
  }
  /// \copydoc refuse
  [[noreturn]] void refuse_unsolved(NotConverged const& error, double step) {
    double const shorter = shorter_step(step);
    LeastJacobian const least = steps_of_.forces.least_jacobian(state_.x);
    throw BodyStepUnsolved(error.residuals.size(), error.residuals.back(), error.tolerance, least.cell,
                           mesh_.cell_name(least.cell),
                           {steps_ + 1, step, least.jacobian, shorter, this->largest_step()});
  }
};

}  // namespace actio::media
