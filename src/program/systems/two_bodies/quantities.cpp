#include <Eigen/Core>

#include "program/systems/two_bodies/quantities.hpp"

#include <Eigen/Geometry>

#include <cmath>

#include "program/systems/bodies/body_input.hpp"

namespace actio::scene {
namespace {

using ConstVector = Eigen::Map<Eigen::Vector3d const>;
using Vector = Eigen::Map<Eigen::Vector3d>;

/// The axis of the least or the largest moment of inertia, in the frame of the body: the middle one is
/// between them.
Eigen::Vector3d axis(bodies::ExtendedBody const& body, bool least) {
  return body.axes.col((body.inertia[0] <= body.inertia[2]) == least ? 0 : 2);
}

double between_zero_and_full(double angle) {
  constexpr double full = 2 * std::numbers::pi;
  return angle < 0 ? angle + full : angle;
}

/// Half axis, eccentricity, inclination, node, argument of the pericentre, mean anomaly. Where the plane is
/// that of the first two axes the node is at 0, on a circle the pericentre is at the node.
void elements_of(Eigen::Vector3d const& x, Eigen::Vector3d const& v, double mu, double* out) {
  double const r = x.norm();
  Eigen::Vector3d const h = x.cross(v), towards = v.cross(h) / mu - x / r;
  double const e = towards.norm(), a = 1 / (2 / r - v.squaredNorm() / mu);
  double const flat = std::hypot(h[0], h[1]);
  Eigen::Vector3d const node =
      flat > 1e-14 * h.norm() ? Eigen::Vector3d(-h[1] / flat, h[0] / flat, 0) : Eigen::Vector3d(1, 0, 0);
  Eigen::Vector3d const across = h.normalized().cross(node);
  double const pericentre = e > 1e-14 ? std::atan2(towards.dot(across), towards.dot(node)) : 0;
  // e sin E = x.v/sqrt(mu a), e cos E = 1 - r/a; the same with hyperbolic functions where a < 0.
  double const rising = x.dot(v) / std::sqrt(mu * std::abs(a));
  double anomaly;
  if (a > 0) {
    double const E = e > 1e-14 ? std::atan2(rising, 1 - r / a) : std::atan2(x.dot(across), x.dot(node));
    anomaly = between_zero_and_full(E - rising);
  } else {
    anomaly = rising - std::asinh(rising / e);
  }
  double const all[] = {a,
                        e,
                        std::atan2(flat, h[2]),
                        between_zero_and_full(std::atan2(node[1], node[0])),
                        between_zero_and_full(pericentre),
                        anomaly};
  std::ranges::copy(all, out);
}

std::vector<Quantity> of_the_state() {
  using Kind = Quantity::Kind;
  using Shown = Quantity::Shown;
  return {
      {"position", Kind::vector, "From the centre of mass of the first body to that of the second, in space.",
       "X", "length", "", Shown::as_direction},
      {"velocity", Kind::vector, "The rate of the position.", "\\dot X = P/m", "length/time"},
      {"attitude_1", Kind::quaternion,
       "The unit quaternion, scalar first, that takes the first body to space; its sign is continuous.",
       "q_1", "1", "", Shown::as_direction},
      {"attitude_2", Kind::quaternion,
       "The unit quaternion, scalar first, that takes the second body to space; its sign is continuous.",
       "q_2", "1", "", Shown::as_direction},
      {"angular_velocity_1", Kind::vector, "The angular velocity of the first body, in its frame.",
       "\\omega_1", "1/time"},
      {"angular_velocity_2", Kind::vector, "The angular velocity of the second body, in its frame.",
       "\\omega_2", "1/time"},
      {"potential", Kind::scalar, "The mutual potential, to the order of the scene.", "V", "energy"},
      {"momentum", Kind::vector, "The angular momentum of both about their barycentre, in space.",
       "X\\times P + R_1M_1 + R_2M_2", "energy x time"},
      Quantity{"separation", Kind::scalar, "The distance of the centres of mass.", "|X|", "length"}.from(
          {"position"}),
      Quantity{"relative_position", Kind::vector, "The position in the frame of the first body.", "R_1^TX",
               "length"}
          .from({"position", "attitude_1"}),
      Quantity{"energy", Kind::scalar,
               "Kinetic and potential energy of both; that of a third body is not in it.",
               "|P|^2/2m + \\tfrac12\\sum_i\\langle M_i, I_i^{-1}M_i\\rangle + V", "energy"}
          .from({"potential"}),
  };
}

std::vector<Quantity> of_the_orbit() {
  using Kind = Quantity::Kind;
  return {
      Quantity{"elements", Kind::list,
               "The osculating elements of the orbit of two points: half axis, eccentricity, inclination, "
               "longitude of the node, argument of the pericentre and mean anomaly; angles in radians.",
               "a, e, i, \\Omega, \\omega, M", "length, 1, 1, 1, 1, 1"}
          .from({"position", "velocity"}),
      Quantity{
          "libration", Kind::scalar,
          "The angle, in the plane of the orbit, from the line between the bodies to the axis of the least "
          "moment of inertia of the second, from -pi/2 to pi/2.",
          "\\theta", "1"}
          .from({"position", "velocity", "attitude_2"}),
      Quantity{
          "nutation", Kind::list,
          "The angles between the normal of the orbit and the axes of the largest moments of inertia of both "
          "bodies, from 0 to pi/2.",
          "\\epsilon_1, \\epsilon_2", "1"}
          .from({"position", "velocity", "attitude_1", "attitude_2"}),
      {"mean_period", Kind::scalar,
       "The time over the revolutions since the start, about the normal of the first orbit.",
       "2\\pi t/\\varphi(t)", "time"},
      {"precession", Kind::scalar,
       "The rate at which the pericentre turns: the slope of the line through the longitudes of all "
       "pericentres so far, by least squares. Zero before the second of them.",
       "\\dot\\varpi", "1/time"},
  };
}

void define_state(QuantityGraph& graph, PairMotion const& motion) {
  using Kind = Quantity::Kind;
  auto const ends = column_ends(Kind::vector);
  auto const& body_1 = motion.pair().first();
  auto const& body_2 = motion.pair().second();
  graph.define("position", ends, [&motion](auto, double* x) { Vector{x} = motion.pair().state().position; });
  graph.define("velocity", ends, [&motion](auto, double* v) {
    Vector{v} = motion.pair().state().momentum / motion.pair().reduced_mass();
  });
  for (bool const second : {false, true}) {
    std::string const which = second ? "_2" : "_1";
    bodies::ExtendedBody const& body = second ? body_2 : body_1;
    auto const part = [&motion, second] {
      auto const state = motion.pair().state();
      return second ? state.second : state.first;
    };
    graph.define("attitude" + which, column_ends(Kind::quaternion), [part](auto, double* q) {
      Eigen::Map<Eigen::Vector4d>{q} = Eigen::Vector4d(part().attitude.value);
    });
    Eigen::Matrix3d const inverse =
        body.axes * ConstVector(body.inertia.data()).cwiseInverse().asDiagonal() * body.axes.transpose();
    graph.define("angular_velocity" + which, ends, [part, inverse](auto, double* w) {
      Vector{w} = inverse * Eigen::Vector3d(part().body_momentum.components);
    });
  }
  graph.define("potential", {""}, [&motion](auto, double* V) { *V = motion.pair().potential(); });
  graph.define("momentum", ends,
               [&motion](auto, double* J) { Vector{J} = motion.pair().angular_momentum(); });
  graph.define("separation", {""}, [](auto needs, double* r) { *r = ConstVector(needs[0]).norm(); });
  graph.define("relative_position", ends, [](auto needs, double* x) {
    Vector{x} = rotation(Eigen::Map<Eigen::Vector4d const>(needs[1])).transpose() * ConstVector(needs[0]);
  });
  graph.define(
      "energy", {""}, [&motion](auto, double* E) { *E = motion.pair().energy(); },
      [](auto needs, double const* E, std::size_t) {
        return std::abs(*E - needs[0][0]) + std::abs(needs[0][0]);
      });
}

void define_orbit(QuantityGraph& graph, PairMotion const& motion) {
  auto const& pair = motion.pair();
  double const mu = pair.options().G * (pair.first().mass() + pair.second().mass());
  auto const normal = [](auto needs) {
    return Eigen::Vector3d(ConstVector(needs[0]).cross(ConstVector(needs[1])).normalized());
  };
  auto const turned = [](double const* q, Eigen::Vector3d const& v) {
    return Eigen::Vector3d(rotation(Eigen::Map<Eigen::Vector4d const>(q)) * v);
  };
  graph.define(
      "elements", {"_a", "_e", "_i", "_node", "_pericentre", "_anomaly"},
      [mu](auto needs, double* out) { elements_of(ConstVector(needs[0]), ConstVector(needs[1]), mu, out); });
  graph.define("libration", {""}, [=, long_axis = axis(pair.second(), true)](auto needs, double* angle) {
    Eigen::Vector3d const u = turned(needs[2], long_axis), x = ConstVector(needs[0]).normalized();
    *angle = std::remainder(std::atan2(normal(needs).cross(x).dot(u), x.dot(u)), std::numbers::pi);
  });
  graph.define(
      "nutation", {"_1", "_2"},
      [=, one = axis(pair.first(), false), two = axis(pair.second(), false)](auto needs, double* angle) {
        Eigen::Vector3d const n = normal(needs);
        for (int k = 0; k < 2; ++k) {
          Eigen::Vector3d const u = turned(needs[2 + k], k == 0 ? one : two);
          angle[k] = std::atan2(n.cross(u).norm(), std::abs(n.dot(u)));
        }
      });
  graph.define("mean_period", {""}, [&motion](auto, double* out) { *out = motion.way().mean_period(); });
  graph.define("precession", {""}, [&motion](auto, double* out) { *out = motion.way().precession(); });
}

}  // namespace

std::vector<Quantity> pair_quantities() {
  auto all = of_the_state();
  for (auto& quantity : of_the_orbit()) all.push_back(std::move(quantity));
  for (auto& quantity : tangent_quantities()) all.push_back(std::move(quantity));
  return all;
}

void define_pair(QuantityGraph& graph, PairMotion const& motion) {
  define_state(graph, motion);
  define_orbit(graph, motion);
  define_tangent(graph, motion);
}

}  // namespace actio::scene
