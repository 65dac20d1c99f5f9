#include "program/systems/bodies/body_input.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>

#include "actio/groups/unit_quaternions.hpp"
#include "program/systems/bodies/angle_input.hpp"
#include "program/systems/bodies/body_n_input.hpp"

namespace actio::scene {

namespace {

AngleKeys const angular_velocity{
    {"initial.angular_velocity", LeftOut{"or initial.angular_momentum"},
     "The angular velocity at the start, in the frame of the body; a list is in radians.", "[0.1, 2, 0.1]",
     "three numbers; or a table with degrees", "1/time"},
    "three numbers",
    "[5, 90, 5]"};

}  // namespace

BodyKeys const& body_keys() {
  static BodyKeys const keys{{"system"}};
  return keys;
}

PrincipalInertia read_inertia(SceneTable const& system) {
  try {
    if (!system.is_matrix("inertia")) return {inertia_from_moments<double>(system.vector("inertia"))};
    return principal_inertia(system.matrix("inertia", 3));
  } catch (SceneError const&) {
    throw;
  } catch (Error const& error) {
    system.fail("inertia", error.what());
  }
}

PrincipalInertia read_body_or_inertia(SceneTable const& system) {
  auto const& [body, inertia] = std::tie(body_keys().body, body_keys().inertia);
  if (body.given(system) && inertia.given(system))
    system.fail("inertia",
                "body and inertia exclude each other: a body of the library has its inertia with it");
  return body.given(system) ? find_body(body.read(system))->principal : read_inertia(system);
}

Eigen::Vector4d read_attitude(SceneTable initial, std::vector<std::string>& remarks) {
  if (!initial.has("attitude")) initial.set("attitude", std::vector<double>{1, 0, 0, 0});
  if (initial.is_table("attitude")) return read_turn(initial.inside("attitude")).stableNormalized();
  if (initial.is_matrix("attitude"))
    return quaternion(read_attitude_n(initial, 3, remarks)).stableNormalized();
  auto const given = initial.numbers("attitude", 4);
  Eigen::Vector4d const q(given.data()), unit = q.stableNormalized();
  double const off = std::abs(q.stableNorm() - 1);
  std::string const normalised = fmt::format("[{}, {}, {}, {}]", unit[0], unit[1], unit[2], unit[3]);
  if (!(off <= 1e-9))
    initial.fail(
        "attitude",
        fmt::format(
            "attitude: a unit quaternion is expected; its length is {}, off by {:.2g} where 1e-9 is taken{}",
            q.stableNorm(), off, q.stableNorm() > 0 ? "; normalised it is " + normalised : ""));
  if (off > 4 * std::numeric_limits<double>::epsilon())
    remarks.push_back(fmt::format("attitude: off unit length by {:.2g}, normalised to {}", off, normalised));
  return unit;
}

Momentum<SO<3>, double> read_momentum(SceneTable const& initial, PrincipalInertia const& inertia) {
  bool const by_velocity = initial.has("angular_velocity"), by_momentum = initial.has("angular_momentum");
  if (by_velocity == by_momentum)
    throw SceneError(by_momentum ? initial.place("angular_momentum") : initial.place(),
                     by_velocity ? "angular_velocity and angular_momentum exclude each other"
                                 : "[initial] needs 'angular_velocity' or 'angular_momentum'");
  std::string const key = by_velocity ? "angular_velocity" : "angular_momentum";
  Eigen::Vector3d const given(by_velocity ? angular_velocity.read(initial, 3).data()
                                          : initial.numbers(key, 3).data());
  Momentum<SO<3>, double> const M =
      by_velocity ? body_momentum(inertia, velocity(SO<3>{}, given)) : momentum(SO<3>{}, given);
  auto const& m = M.components;
  auto const omega = body_velocity(inertia, M).coordinates;
  double const least = std::numeric_limits<double>::min(), lightest = inertia.inertia.moments.minCoeff();
  if (lightest < least)
    initial.fail(key, fmt::format("{}: a moment of inertia is {:.3g}, and below {:.3g} digits "
                                  "are lost; other units would do",
                                  key, lightest, least));
  if (!is_finite(m) || !is_finite(m.squaredNorm()) || !is_finite(omega.squaredNorm()))
    initial.fail(key, key + ": the numbers are too large: energy and |M|^2 are beyond 1e308");
  if (magnitude(given) > 0 && (magnitude(m) < least || magnitude(omega) < least))
    initial.fail(key, fmt::format("{}: the numbers are too small: momentum or angular velocity is "
                                  "below {:.3g}, where digits are lost",
                                  key, least));
  return M;
}

bodies::FreeState read_start(SceneTable const& initial, PrincipalInertia const& inertia,
                             std::vector<std::string>& remarks) {
  Element<SU2, double> const attitude{{}, read_attitude(initial, remarks)};
  return {read_momentum(initial, inertia), attitude};
}

std::vector<Parameter> initial_parameters(MomentumKeys const& momentum) {
  return records_of({attitude_keys, angular_velocity, momentum});
}

Eigen::Matrix3d rotation(Eigen::Vector4d const& q) {
  return Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix();
}
Eigen::Vector4d quaternion(Eigen::Matrix3d const& rotation) {
  Eigen::Quaterniond const q(rotation);
  Eigen::Vector4d const out(q.w(), q.x(), q.y(), q.z());
  return out[0] < 0 ? Eigen::Vector4d(-out) : out;
}
Eigen::Vector4d compose(Eigen::Vector4d const& p, Eigen::Vector4d const& q) {
  return SU2::compose<double>(p, q);
}

}  // namespace actio::scene
