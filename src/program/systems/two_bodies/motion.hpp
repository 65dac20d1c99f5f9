// How two bodies that attract each other move, as scenes step them, and what is followed on the way.
#pragma once

#include "program/registry/simulation.hpp"
#include "program/systems/two_bodies/input.hpp"

namespace actio::scene {

/// The way of the second body around the first, in the plane of the orbit at the start: its angle, and where
/// it passed its pericentres.
class OrbitWay {
 public:
  OrbitWay() = default;
  /// From this state on.
  OrbitWay(bodies::TwoBodyState const& start, double reduced_mass);
  /// The next state, less than half a revolution later.
  void see(bodies::TwoBodyState const& state, double time);
  /// \f$2\pi t/\varphi(t)\f$, at the start \f$2\pi/\dot\varphi\f$; time.
  double mean_period() const;
  /// The slope of the line through the longitudes of the pericentres over their times, by least squares;
  /// 1/time. Zero before the second of them.
  double precession() const { return spread_ > 0 ? product_ / spread_ : 0; }

 private:
  struct Point {
    double time, square, rising, angle, rate;  // r^2 and x.v, and the angle in the plane
  };
  Point seen_from(bodies::TwoBodyState const& state, double time) const;

  std::array<double, 3> along_{}, across_{};  // axes of the plane
  double reduced_mass_ = 1;
  Point last_{};
  // Of the pericentres: how many, mean time and longitude, sums of squares and products about these.
  double passed_ = 0, mean_time_ = 0, mean_longitude_ = 0, spread_ = 0, product_ = 0;
};

/// How the state changes with that at the start.
struct TangentSoFar {
  /// \f$\partial z(t)/\partial z(0)\f$, as TwoBodies has it
  Eigen::Matrix<double, 18, 18> map = Eigen::Matrix<double, 18, 18>::Identity();
  Eigen::Matrix<double, 18, 1> unit,  ///< of the parts of a tangent vector
      along;                          ///< a tangent vector in these, of length 1
  double growth = 0;                  ///< the logarithm of what it has grown by

  /// Goes on by the derivative of some steps.
  void follow(Eigen::Matrix<double, 18, 18> const& by);
};

/// Two bodies in steps.
class PairMotion : public Motion {
 public:
  /// What is followed from step to step.
  struct Follows {
    bool way,     ///< the pericentres
        tangent;  ///< how the state changes with that at the start
  };
  /// The scene with steps of this length, from its start.
  /// @throws Error  where it cannot start
  PairMotion(PairScene const& scene, double step, Follows follows);
  void advance(long count) override;
  void look_ahead(double time) override;
  void change_step(double first, double step, long made) override;
  void remember(CheckpointStream& stream) override;
  /// The larger one of the angles between both attitudes, and the distance of the positions.
  StateDistance distance(Motion const& other) const override;

  bodies::TwoBodies const& pair() const { return now().pair; }   ///< that quantities are those of
  OrbitWay const& way() const { return now().way; }              ///< where it is followed
  TangentSoFar const& tangent() const { return now().tangent; }  ///< where it is followed

 private:
  struct State {
    bodies::TwoBodies pair;
    OrbitWay way;
    TangentSoFar tangent;
  };
  State const& now() const { return ahead_ ? *ahead_ : state_; }
  void move(State& state, long count) const;
  /// The same state with steps of another length.
  static bodies::TwoBodies with_step(bodies::TwoBodies const& pair, double step);

  Follows follows_;
  State state_;
  std::optional<State> ahead_;
};

}  // namespace actio::scene
