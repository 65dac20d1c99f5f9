#include <Eigen/Core>

#include "program/systems/bodies/turning_body.hpp"

#include "actio/groups/unit_quaternions.hpp"
#include "program/run/drift.hpp"

namespace actio::scene {
namespace {

using Vector = Eigen::Map<Eigen::Vector3d>;
using ConstVector = Eigen::Map<Eigen::Vector3d const>;

}  // namespace

StateDistance TurningBody::distance(Motion const& other) const {
  auto const& body = static_cast<TurningBody const&>(other);
  StateDistance out;
  Eigen::Vector3d const M = body_momentum();
  out.modulus = length_of({M.data(), 3});
  Eigen::Vector3d const apart = body.body_momentum() - M;
  out.momentum = length_of({apart.data(), 3});
  if (!attitude_wanted() || !body.attitude_wanted()) return out;
  Eigen::Vector4d const turn = SU2::compose<double>(SU2::inverse<double>(attitude()), body.attitude());
  out.attitude = 2 * std::atan2(turn.tail<3>().norm(), std::abs(turn[0]));
  return out;
}

std::vector<Quantity> turning_body_quantities(bool free) {
  using Kind = Quantity::Kind;
  using Shown = Quantity::Shown;
  return {
      {"attitude", Kind::quaternion,
       "The unit quaternion, scalar first, that takes the body to space; its sign is "
       "continuous from the one given.",
       "q", "1", "", Shown::as_direction},
      {"body_momentum", Kind::vector, "The angular momentum in the frame of the body.", "M", "energy x time",
       "eq_5_1", Shown::as_direction},
      Quantity{"angular_velocity", Kind::vector, "The angular velocity in the frame of the body.",
               "\\omega = I^{-1}M", "1/time", "", Shown::as_direction}
          .from({"body_momentum"}),
      Quantity{
          "spatial_momentum", Kind::vector,
          free ? "The angular momentum in space; a torque changes it." : "The angular momentum in space.",
          "\\pi = R(q)\\,M", "energy x time", "claim_5_2_spatial_momentum", Shown::beside_motion}
          .from({"attitude", "body_momentum"}),
  };
}

void define_turning_body(QuantityGraph& graph, TurningBody const& motion, PrincipalInertia const& inertia) {
  using Kind = Quantity::Kind;
  graph.define("attitude", column_ends(Kind::quaternion),
               [&motion](auto, double* q) { Eigen::Map<Eigen::Vector4d>{q} = motion.attitude(); });
  graph.define("body_momentum", column_ends(Kind::vector),
               [&motion](auto, double* M) { Vector{M} = motion.body_momentum(); });
  graph.define("angular_velocity", column_ends(Kind::vector),
               [inverse = inertia.inverse_tensor()](auto needs, double* w) {
                 Vector{w} = inverse * ConstVector(needs[0]);
               });
  graph.define("spatial_momentum", column_ends(Kind::vector), [](auto needs, double* pi) {
    Vector{pi} = Eigen::Vector3d(SU2::Ad<double>(as_matrix<4, 1>(needs[0]), as_matrix<3, 1>(needs[1])));
  });
}

QuantityGraph::Unit unit_of_momentum(double modulus, PrincipalInertia const& inertia, double pace) {
  // Roundings of the attitude make torques, which are added up over a million steps or so.
  constexpr double rounding = 1e-10;
  double const at_rest = inertia.inertia.moments.maxCoeff() * pace;
  return {modulus, rounding * at_rest, at_rest};
}

double fastest_turn(PrincipalInertia const& inertia, double kinetic_energy) {
  return std::sqrt(2 * kinetic_energy) / std::sqrt(inertia.inertia.moments.minCoeff());
}

}  // namespace actio::scene
