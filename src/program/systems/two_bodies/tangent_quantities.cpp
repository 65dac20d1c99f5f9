// How a motion of two bodies depends on its start: by the tangent map.
#include <Eigen/Core>

#include "program/systems/two_bodies/quantities.hpp"

namespace actio::scene {
namespace {

using Map = Eigen::Matrix<double, 18, 18, Eigen::RowMajor>;

/// The gradient of the separation by the start: a row of the tangent map, by velocities instead of momenta.
void define_sensitivity(QuantityGraph& graph, PairMotion const& motion) {
  std::vector<std::string> ends;
  for (char const* part :
       {"_position", "_velocity", "_turn_1", "_angular_velocity_1", "_turn_2", "_angular_velocity_2"})
    for (auto const& end : column_ends(Quantity::Kind::vector)) ends.push_back(part + end);
  auto const inertia = [](bodies::ExtendedBody const& body) {
    return Eigen::Matrix3d(body.axes * Eigen::Vector3d(body.inertia.data()).asDiagonal() *
                           body.axes.transpose());
  };
  auto const& pair = motion.pair();
  graph.define("sensitivity", ends,
               [&motion, m = pair.reduced_mass(), I1 = inertia(pair.first()), I2 = inertia(pair.second())](
                   auto needs, double* out) {
                 Eigen::Map<Eigen::Matrix<double, 18, 1>> by(out);
                 by = motion.tangent().map.topRows<3>().transpose() *
                      Eigen::Map<Eigen::Vector3d const>(needs[0]).normalized();
                 by.segment<3>(3) *= m;
                 by.segment<3>(9) = (I1 * by.segment<3>(9)).eval();
                 by.segment<3>(15) = (I2 * by.segment<3>(15)).eval();
               });
}

}  // namespace

std::vector<Quantity> tangent_quantities() {
  using Kind = Quantity::Kind;
  return {
      {"tangent_map", Kind::matrix,
       "How the state changes with that at the start: position, momentum, and of each body a turn and its "
       "momentum, both in its frame. Without tides.",
       "\\partial z(t)/\\partial z(0)", "mixed"},
      Quantity{
          "sensitivity", Kind::list,
          "How the separation changes with the start: with position and velocity, and of each body with a "
          "small turn and with the angular velocity, both in its frame. Without tides.",
          "\\partial|X(t)|/\\partial(X, \\dot X, \\theta_1, \\omega_1, \\theta_2, \\omega_2)(0)",
          "1, time, length, length x time, length, length x time"}
          .from({"position"}),
      {"lyapunov", Kind::scalar,
       "The rate at which a tangent vector has grown since the start, its parts in units of the orbit: it "
       "falls as log(t)/t where the motion is regular, and tends to the largest Lyapunov exponent where it "
       "is chaotic. Zero at the start. Without tides.",
       "\\tfrac1t\\log|\\delta z(t)|/|\\delta z(0)|", "1/time"},
  };
}

void define_tangent(QuantityGraph& graph, PairMotion const& motion) {
  graph.define("tangent_map", column_ends(Quantity::Kind::matrix, 18),
               [&motion](auto, double* out) { Eigen::Map<Map>{out} = motion.tangent().map; });
  define_sensitivity(graph, motion);
  graph.define("lyapunov", {""}, [&motion](auto, double* out) {
    double const time = motion.pair().time();
    *out = time == 0 ? 0 : motion.tangent().growth / time;
  });
}

}  // namespace actio::scene
