#include "actio/scene/systems/body_input.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>

#include "actio/foundations/groups/unit_quaternions.hpp"
#include "actio/scene/bodies.hpp"
#include "actio/scene/nearest_name.hpp"

namespace actio::scene {

GivenInertia read_inertia(SceneTable const& system) {
  try {
    if (!system.is_matrix("inertia")) return {inertia_from_moments<double>(system.vector("inertia"))};
    auto const [inertia, axes] = principal_inertia(system.matrix("inertia", 3));
    return {inertia, axes, !axes.isIdentity(0)};
  } catch (SceneError const&) {
    throw;
  } catch (Error const& error) {
    system.fail("inertia", error.what());
  }
}

GivenInertia read_body_or_inertia(SceneTable const& system) {
  if (system.has("body") && system.has("inertia")) system.fail("inertia", "body and inertia exclude each other: a body of the library has its inertia with it");
  if (!system.has("body")) return read_inertia(system);
  std::vector<std::string> known;
  for (auto const& body : library_bodies()) known.push_back(body.name);
  LibraryBody const& body = *find_body(system.choice("body", "body", known, "actio list bodies"));
  return {body.inertia, body.axes, !body.axes.isIdentity(0)};
}

Eigen::Vector4d read_attitude(SceneTable initial, std::vector<std::string>& remarks) {
  if (!initial.has("attitude")) initial.set("attitude", std::vector<double>{1, 0, 0, 0});
  auto const given = initial.numbers("attitude", 4);
  Eigen::Vector4d const q(given.data()), unit = q.stableNormalized();
  double const off = std::abs(q.stableNorm() - 1);
  std::string const normalised = fmt::format("[{}, {}, {}, {}]", unit[0], unit[1], unit[2], unit[3]);
  if (!(off <= 1e-9))
    initial.fail("attitude", fmt::format("attitude: a unit quaternion is expected; its length is {}, off by {:.2g} where 1e-9 is taken{}", q.stableNorm(), off,
                                         q.stableNorm() > 0 ? "; normalised it is " + normalised : ""));
  if (off > 4 * std::numeric_limits<double>::epsilon()) remarks.push_back(fmt::format("attitude: off unit length by {:.2g}, normalised to {}", off, normalised));
  return unit;
}

Eigen::Vector3d read_momentum(SceneTable const& initial, GivenInertia const& inertia) {
  bool const velocity = initial.has("angular_velocity"), momentum = initial.has("angular_momentum");
  if (velocity == momentum)
    throw SceneError(momentum ? initial.place("angular_momentum") : initial.place(),
                     velocity ? "angular_velocity and angular_momentum exclude each other" : "[initial] needs 'angular_velocity' or 'angular_momentum'");
  Eigen::Vector3d const m = velocity ? inertia.momentum(initial.vector("angular_velocity")) : initial.vector("angular_momentum");
  std::string const key = velocity ? "angular_velocity" : "angular_momentum";
  if (!m.allFinite() || !is_finite(m.squaredNorm()) || !is_finite(inertia.velocity(m).squaredNorm()))
    initial.fail(key, key + ": the numbers are too large: energy and |M|^2 are beyond 1e308");
  Eigen::Vector3d const given = initial.vector(key);
  double const least = std::numeric_limits<double>::min();
  if (magnitude(given) > 0 && (magnitude(m) < least || magnitude(inertia.velocity(m)) < least))
    initial.fail(key, fmt::format("{}: the numbers are too small: momentum or angular velocity is below {:.3g}, where digits are lost", key, least));
  return m;
}

Eigen::Matrix3d rotation(Eigen::Vector4d const& q) { return Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix(); }
Eigen::Vector4d quaternion(Eigen::Matrix3d const& rotation) {
  Eigen::Quaterniond const q(rotation);
  Eigen::Vector4d const out(q.w(), q.x(), q.y(), q.z());
  return out[0] < 0 ? Eigen::Vector4d(-out) : out;
}
Eigen::Vector4d compose(Eigen::Vector4d const& p, Eigen::Vector4d const& q) { return SU2::compose<double>(p, q); }

}  // namespace actio::scene
