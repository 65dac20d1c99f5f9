#include "program/systems/bodies/rigid_body_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "program/registry/companion.hpp"
#include "program/systems/bodies/free_motion.hpp"
#include "program/systems/bodies/free_motion_n.hpp"

namespace actio::scene {
namespace {

std::map<std::string, RigidBodyScene::Scheme> const schemes{
    {"moser_veselov", RigidBodyScene::Scheme::moser_veselov},
    {"natural_chart", RigidBodyScene::Scheme::natural_chart},
    {"variational", RigidBodyScene::Scheme::variational}};

/// A torque leaves one method.
MethodChoice read_choice(SceneTable const& method, std::vector<Method> const& methods, bool torqued) {
  if (!torqued) return read_method(method, methods);
  auto const own = std::ranges::find(methods, "variational", &Method::name);
  if (method.is_text("name"))
    for (auto const& other : methods)
      if (other.name != own->name && other.name == method.text("name"))
        method.fail("name", fmt::format("name: {} steps free bodies; under a torque the method is {}",
                                        other.name, own->name));
  return read_method(method, {*own});
}

/// @throws SceneError  where it is beyond all numbers
double pace(RigidBodyScene& scene, double until) {
  double const fastest =
      scene.torque ? scene.torque->pace(scene.start, until, scene.remarks)
                   : fastest_turn(scene.inertia, kinetic_energy(scene.inertia, scene.start.body_momentum));
  if (scene.torque && !is_finite(fastest))
    throw SceneError(scene.initial.place(), "the numbers are too large: the energy is beyond 1e308");
  return fastest;
}

std::unique_ptr<TurningBody> free_motion(RigidBodyScene const& scene) {
  int const order = scene.choice.number();
  PrincipalInertia const& inertia = scene.inertia;
  if (order == 0) return exact_motion(scene.free);
  if (scene.scheme == RigidBodyScene::Scheme::natural_chart) {
    auto const fractions = fractions_of(order);
    auto const steps = [=](bodies::FreeState const& start, double h) {
      return bodies::NaturalChartSteps(inertia, start.body_momentum, start.attitude, h, fractions);
    };
    return stepped_motion(StepsFrom<bodies::NaturalChartSteps>(steps), scene.start, scene.step);
  }
  bool const exact_flow = scene.has_exact_flow();
  auto const steps = [=](bodies::FreeState const& start, double h) {
    bodies::FreeBody const body(inertia, start.body_momentum, start.attitude);
    return exact_flow ? bodies::FreeSteps(body, h)
                      : bodies::FreeSteps(body, h, body.moser_veselov_parameters(h, order));
  };
  return stepped_motion(StepsFrom<bodies::FreeSteps>(steps), scene.start, scene.step);
}

std::unique_ptr<TorquedMotion> torqued(RigidBodyScene const& scene, double step) {
  return torqued_motion(scene.inertia, scene.start, scene.torque->torque(), step, scene.choice.order);
}

/// Either motion.
/// @throws NumericsError  where the step is too long
RigidBodyMotion able_motion(RigidBodyScene& scene, Schedule const& schedule) {
  try {
    if (!scene.torque) return {free_motion(scene), nullptr, ""};
    check_turn_of_step(scene.method, schedule, scene.step, scene.fastest, "body or torque may turn",
                       scene.remarks);
    auto motion = torqued(scene, scene.step);
    auto const* const view = motion.get();
    return {std::move(motion), view, ""};
  } catch (StepTooLong const& error) {
    fail_for_long_step(scene.method, schedule, error);
  } catch (NumericsError const&) {
    throw;
  } catch (Error const& error) {
    throw NumericsError(scene.method.place("step").text() + ": " + error.what());
  }
}

}  // namespace

RigidBodyScene::RigidBodyScene(Request const& request, std::vector<Method> const& methods)
    : system(request.file.section("system")),
      initial(request.file.section("initial")),
      method(request.file.section("method")),
      inertia(read_body_or_inertia(system)),
      torque(read_torque(system, inertia)),
      start(read_start(initial, inertia, remarks)),
      free(inertia, start.body_momentum, start.attitude),
      choice(read_choice(method, methods, torque.has_value())),
      scheme(schemes.at(choice.name)),
      fastest(pace(*this, request.schedule.until())),
      step(read_step(method, request.schedule, fastest)) {}

double RigidBodyScene::work() const {
  if (torque) return work_of_step(choice.order);
  return scheme == Scheme::natural_chart ? static_cast<double>(fractions_of(choice.number()).size()) : 1;
}

RigidBodyMotion motion_of(RigidBodyScene& scene, Schedule const& schedule) {
  try {
    return able_motion(scene, schedule);
  } catch (NumericsError const& error) {
    return {exact_motion(scene.free), nullptr, error.what()};
  }
}

Companion companion_of(RigidBodyScene const& scene, std::optional<bool> wanted, bool attitude) {
  if (scene.is_exact() || scene.has_exact_flow())
    return no_error("exact: no error but that of rounding", attitude);
  if (!wanted.value_or(true)) return {nullptr, 0, 0, attitude, "left out by output.error_estimate"};
  if (scene.torque)
    return companions(
        [&](long multiple) { return torqued(scene, static_cast<double>(multiple) * scene.step); }, {3},
        scene.choice.number(), true);
  auto exact = exact_motion(scene.free);
  if (!attitude) exact->leave_attitude_out();
  return {std::move(exact), 0, scene.choice.number(), attitude, "compared with the exact motion"};
}

}  // namespace actio::scene
