// Bodies with constraints on their velocity, for tests.
#pragma once

#include <Eigen/Core>

#include <map>

#include "actio/any_group/named_algebra.hpp"
#include "actio/formula/parse_formula.hpp"
#include "actio/nonholonomic/rattle_map.hpp"

namespace actio::testing {

using List = std::vector<double>;
using Parameters = std::map<std::string, double>;
using Triple = Eigen::Vector3d;

/// A system with constraints that are told by texts.
struct Constrained {
  std::shared_ptr<systems::ReducedSystem const> system;
  std::shared_ptr<systems::VelocityConstraints const> constraints;

  /// @param definitions  before each formula
  Constrained(char const* group, std::string const& lagrangian, std::vector<std::string> const& each,
              std::vector<std::string> const& carried = {}, Parameters const& parameters = {},
              std::string const& definitions = "", systems::Chart chart = systems::Chart::exponential,
              systems::Side side = systems::Side::left) {
    systems::MatrixAlgebra algebra = systems::named_algebra(group);
    auto names = algebra.components;
    for (auto const& vector : carried)
      for (int i = 1; i <= algebra.size; ++i) names.push_back(vector + std::to_string(i));
    Tape l = parse_formula(definitions + lagrangian, names, parameters);
    system = std::make_shared<systems::ReducedSystem const>(
        std::move(algebra), side, static_cast<int>(carried.size()), std::move(l), chart);
    names.push_back("t");
    std::vector<Tape> tapes;
    for (auto const& one : each) tapes.push_back(parse_formula(definitions + one, names, parameters));
    constraints = std::make_shared<systems::VelocityConstraints const>(*system, tapes);
  }
  systems::ConstrainedState state(List const& v, List const& a = {}, double t = 0) const {
    return systems::constrained_state(*system, *constraints, v, a, t);
  }
  systems::RattleIntegrator run(double h, List const& fractions, systems::ConstrainedState const& start,
                                double t = 0) const {
    return {system, constraints, h, fractions, start, t};
  }
  double energy(systems::ConstrainedState const& at) const {
    return systems::LegendreVelocity(*system).energy(at.velocity, at.point.vectors);
  }
};

/// v + w x r = 0: the point at r does not move.
inline std::vector<std::string> const point_rests{"v1 + w2*r3 - w3*r2", "v2 + w3*r1 - w1*r3",
                                                  "v3 + w1*r2 - w2*r1"};

inline Triple cross(Triple const& a, Triple const& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
/// Three of the components of a list.
inline Triple triple(List const& x, std::size_t from) { return {x[from], x[from + 1], x[from + 2]}; }
/// Angular velocity, and the velocity that lets the point at r rest.
inline List rolling_velocity(Triple const& w, Triple const& r) {
  Triple const v = cross(r, w);
  return {w[0], w[1], w[2], v[0], v[1], v[2]};
}
inline List direction(Triple const& u) { return {u[0], u[1], u[2], 0}; }

/// Chaplygin's sleigh: a blade at the origin, the centre of mass at a distance in front of it.
struct Sleigh {
  double mass = 1.3, inertia = 0.7, ahead = 0.6, energy = 1.1, phase = -1;
  double about_blade = inertia + mass * ahead * ahead, speed = std::sqrt(2 * energy / mass),
         turn = std::sqrt(2 * energy / about_blade), rate = ahead * mass * speed / about_blade;

  Constrained system(systems::Chart chart = systems::Chart::exponential) const {
    return {"SE(2)", "m*(v1^2 + (v2 + a*w)^2)/2 + J*w^2/2",       {"v2"},
            {},      {{"m", mass}, {"J", inertia}, {"a", ahead}}, "",
            chart};
  }
  /// Angular velocity and velocity along the blade, in closed form.
  List velocity(double t) const {
    return {turn / std::cosh(rate * t + phase), speed * std::tanh(rate * t + phase), 0};
  }
  double heading(double t) const {
    auto const gudermann = [](double x) { return 2 * std::atan(std::tanh(x / 2)); };
    return turn / rate * (gudermann(rate * t + phase) - gudermann(phase));
  }
};

/// Chaplygin's ball of radius 1 and mass 1, three different moments of inertia, its centre of mass at its
/// centre, on a plane.
struct ChaplyginBall {
  Triple inertia{1, 2, 2.5}, up{0.36, 0.48, 0.8}, turn{0.9, -0.4, 1.2};

  Constrained system(systems::Chart chart = systems::Chart::exponential) const {
    return {"SE(3)",
            "(A*w1^2 + B*w2^2 + C*w3^2 + v1^2 + v2^2 + v3^2)/2",
            point_rests,
            {"up"},
            {{"A", inertia[0]}, {"B", inertia[1]}, {"C", inertia[2]}},
            "r1 = -up1; r2 = -up2; r3 = -up3;",
            chart};
  }
  List velocity() const { return rolling_velocity(turn, -up); }
  /// The momentum about the point of contact, which is fixed in space.
  static Triple about_contact(systems::ReducedPoint const& at) {
    return triple(at.momentum, 0) + cross(triple(at.vectors, 0), triple(at.momentum, 3));
  }
};

/// The rattleback of Kane and Levinson (1982); centimetres, seconds, mass 1.
struct Rattleback {
  Parameters parameters{{"A", 2}, {"B", 16}, {"C", 17}, {"D", -0.2}, {"a", 20},
                        {"b", 3}, {"c", 2},  {"s", 1},  {"g", 981}};
  Triple up;
  Rattleback() {
    double const tilt = std::sin(std::numbers::pi / 360);
    up = {tilt, tilt, std::sqrt(1 - 2 * tilt * tilt)};
  }
  Constrained system(systems::Chart chart = systems::Chart::exponential) const {
    return {"SE(3)",
            "(A*w1^2 + B*w2^2 + C*w3^2 + 2*D*w1*w2 + v1^2 + v2^2 + v3^2)/2 - g*(S - s*up3)",
            point_rests,
            {"up"},
            parameters,
            "S = sqrt((a*up1)^2 + (b*up2)^2 + (c*up3)^2); r1 = -a^2*up1/S; r2 = -b^2*up2/S;"
            "r3 = s - c^2*up3/S;",
            chart};
  }
  /// Spinning about the vertical.
  List velocity(double spin) const {
    double const size = std::sqrt(400 * up[0] * up[0] + 9 * up[1] * up[1] + 4 * up[2] * up[2]);
    return rolling_velocity(spin * up, {-400 * up[0] / size, -9 * up[1] / size, 1 - 4 * up[2] / size});
  }
  /// The angular velocity about the vertical.
  static double spin(systems::ConstrainedState const& at) {
    return triple(at.velocity, 0).dot(triple(at.point.vectors, 0));
  }
};

/// The largest difference of two lists.
inline double apart(List const& a, List const& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

/// The order that errors at n, 2 n, 4 n ... steps show: the slope between the last two.
inline double order_of(List const& errors) { return std::log2(errors[errors.size() - 2] / errors.back()); }

}  // namespace actio::testing
