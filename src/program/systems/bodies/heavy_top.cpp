// The heavy top: a rigid body held at a point under gravity.
#include <Eigen/Core>

#include <fmt/format.h>

#include "actio/rigid_body/heavy_top_body.hpp"
#include "program/catalogue/body_shape.hpp"
#include "program/registry/accuracy.hpp"
#include "program/registry/companion.hpp"
#include "program/registry/conservation.hpp"
#include "program/systems/bodies/free_motion.hpp"
#include "program/systems/bodies/torqued_motion.hpp"
#include "program/systems/method_input.hpp"

namespace actio::scene {
namespace {

using ConstVector = Eigen::Map<Eigen::Vector3d const>;

struct TopKeys : KeyTable {
  Key<double> mass = key("mass", positive.in("mass"), needed, "The mass.", "1");
  AnyKey inertia =
      key("inertia", "three numbers, or a symmetric 3 by 3 matrix", needed,
          "The moments of inertia about the centre of mass, along the axes of the body frame, or the tensor "
          "in that frame. They are moved to the fixed point.",
          "[1, 1, 0.5]", "mass x length^2");
  Key<Eigen::Vector3d> centre_of_mass = key("centre_of_mass", vector.in("length"), needed,
                                            "From the fixed point, in the frame of the body.", "[0, 0, 1]");
  Key<Eigen::Vector3d> gravity =
      key("gravity", vector.in("length/time^2"), needed,
          "The acceleration, in space. Zero for a free body held at a point.", "[0, 0, -9.81]");
} const top_keys{{"system"}};
MomentumKeys const momentum_keys{
    {"initial"}, "The angular momentum at the start, about the fixed point, in the frame of the body."};

std::vector<Method> methods() { return {variational_method("gravity")}; }

std::vector<Quantity> quantities() {
  using Kind = Quantity::Kind;
  auto all = turning_body_quantities(false);
  all.push_back(
      Quantity{"direction_of_gravity", Kind::vector,
               "The unit vector along gravity, in the frame of the body; of the third axis of space "
               "downwards where there is no gravity.",
               "\\Gamma = R(q)^T g/|g|", "1"}
          .from({"attitude"}));
  all.push_back(Quantity{"vertical_momentum", Kind::scalar,
                         "The angular momentum about the vertical through the fixed point, against gravity.",
                         "-\\langle\\pi, g/|g|\\rangle", "energy x time"}
                    .from({"spatial_momentum"}));
  all.push_back(Quantity{"energy", Kind::scalar,
                         "Kinetic and potential energy; the potential is zero with the centre of "
                         "mass as high as the fixed point.",
                         "H = \\tfrac12\\langle M, I^{-1}M\\rangle - m|g|\\langle\\chi, \\Gamma\\rangle",
                         "energy"}
                    .from({"body_momentum", "angular_velocity", "direction_of_gravity"}));
  all.push_back(Quantity{"casimir", Kind::list,
                         "The Casimirs of the dual of se(3), where momentum and direction of "
                         "gravity move: |Gamma|^2 and M.Gamma.",
                         "|\\Gamma|^2, \\langle M, \\Gamma\\rangle", "1, and energy x time"}
                    .from({"body_momentum", "direction_of_gravity"}));
  return all;
}

/// [system] of a heavy top, in the frame in which the scene gives it.
struct GivenTop {
  PrincipalInertia inertia;  ///< about the fixed point
  Eigen::Vector3d lever,     ///< weight times centre of mass; energy
      down;                  ///< unit vector along gravity, in space

  /// @param centre  of mass, from the fixed point
  GivenTop(TurnedHeavyTop const& turned, Eigen::Vector3d const& centre)
      : inertia(turned.top.inertia, turned.axes),
        lever(centre * (turned.top.mass * turned.top.pull())),
        down(-turned.top.vertical()) {}
};
GivenTop read_top(SceneTable const& system) {
  double const mass = top_keys.mass.read(system);
  PrincipalInertia const about_centre = read_inertia(system);
  Eigen::Vector3d const centre = top_keys.centre_of_mass.read(system),
                        gravity = top_keys.gravity.read(system);
  try {
    // On a principal axis through the centre of mass the axes at the fixed point are the same.
    bool const on_axis = (centre.array() != 0).count() <= 1;
    if (!about_centre.is_turned() && on_axis)
      return {
          {held_at_a_point<double>(mass, about_centre.inertia, centre, gravity), Eigen::Matrix3d::Identity()},
          centre};
    return {held_anywhere(mass, about_centre.tensor(), centre, gravity), centre};
  } catch (UnphysicalInertia const& error) {
    system.fail("inertia", std::string("about the fixed point: ") + error.what());
  } catch (Error const& error) {
    system.fail("centre_of_mass", error.what());
  }
}

/// What a scene says of a heavy top.
struct TopScene {
  SceneTable initial, method;
  std::vector<std::string> remarks;
  GivenTop top;
  bodies::FreeState start;  ///< momentum about the fixed point, and attitude
  MethodChoice choice;
  double fastest,  ///< a bound of the angular velocity and of the frequency of swings, 1/time
      step;

  explicit TopScene(Request const& request)
      : initial(request.file.section("initial")),
        method(request.file.section("method")),
        top(read_top(request.file.section("system"))),
        start(read_start(initial, top.inertia, remarks)),
        choice(read_method(method, methods())),
        fastest(fastest_of_fall()),
        step(read_step(method, request.schedule, fastest)) {}

  bool is_free() const { return !(magnitude(top.lever) > 0); }

 private:
  /// A bound of the angular velocity, since no more energy is kinetic than the total above the lowest place,
  /// and of the frequency of a swing about that place, which may be as small as one likes.
  double fastest_of_fall() const {
    double const kinetic = kinetic_energy(top.inertia, start.body_momentum),
                 fall =
                     top.lever.norm() - top.lever.dot(rotation(start.attitude.value).transpose() * top.down);
    if (!is_finite(kinetic + fall))
      throw SceneError(initial.place(), "the numbers are too large: the energy is beyond 1e308");
    return std::max(fastest_turn(top.inertia, kinetic + fall), swing_of_weight(top.inertia, top.lever));
  }
};

/// In steps of the scheme of the scene.
std::unique_ptr<TurningBody> stepped(TopScene const& scene, double step) {
  PrincipalInertia const& inertia = scene.top.inertia;
  if (scene.is_free()) {
    auto const steps = [=](bodies::FreeState const& start, double h) {
      return bodies::FreeSteps(bodies::FreeBody(inertia, start.body_momentum, start.attitude), h);
    };
    return stepped_motion(StepsFrom<bodies::FreeSteps>(steps), scene.start, step);
  }
  auto const gravity = bodies::uniform_gravity(scene.top.lever, scene.top.down);
  return torqued_motion(inertia, scene.start, gravity, step, scene.choice.order);
}

/// @param failure  why it cannot take a step; then it is the start alone, that of a free body
std::unique_ptr<TurningBody> motion_of(TopScene& scene, Schedule const& schedule, std::string& failure) {
  try {
    if (!scene.is_free())
      check_turn_of_step(scene.method, schedule, scene.step, scene.fastest, "the top may turn",
                         scene.remarks);
    return stepped(scene, scene.step);
  } catch (NumericsError const& error) {
    failure = error.what();
  } catch (Error const& error) {
    failure = scene.method.place("step").text() + ": " + error.what();
  }
  return exact_motion(bodies::FreeBody(scene.top.inertia, scene.start.body_momentum, scene.start.attitude));
}

/// Steps three and six times as long cost a little less than a half of the run, since short and long drifts
/// take the same series.
Companion companion_of(TopScene const& scene, std::optional<bool> wanted) {
  if (scene.is_free()) return no_error("exact: no error but that of rounding", true);
  if (!wanted.value_or(true)) return {nullptr, 0, 0, true, "left out by output.error_estimate"};
  return companions([&](long multiple) { return stepped(scene, static_cast<double>(multiple) * scene.step); },
                    {3}, std::stoi(scene.choice.order), true);
}

void define_top(QuantityGraph& graph, TopScene const& scene) {
  auto const unit = [inertia = scene.top.inertia, pace = scene.fastest](double modulus) {
    return unit_of_momentum(modulus, inertia, pace);
  };
  graph.define("direction_of_gravity", column_ends(Quantity::Kind::vector),
               [down = scene.top.down](auto needs, double* gamma) {
                 as_matrix<3, 1>(gamma) =
                     SU2::Ad<double>(SU2::inverse<double>(as_matrix<4, 1>(needs[0])), down);
               });
  graph.define(
      "vertical_momentum", {""},
      [down = scene.top.down](auto needs, double* momentum) { *momentum = -down.dot(ConstVector(needs[0])); },
      [unit](auto needs, double const*, std::size_t) {
        return unit(magnitude(Eigen::Vector3d(ConstVector(needs[0]))));
      });
  graph.define(
      "energy", {""},
      [lever = scene.top.lever](auto needs, double* energy) {
        *energy = ConstVector(needs[0]).dot(ConstVector(needs[1])) / 2 - lever.dot(ConstVector(needs[2]));
      },
      [lever = scene.top.lever](auto needs, double const*, std::size_t) {
        return ConstVector(needs[0]).dot(ConstVector(needs[1])) / 2 +
               std::abs(lever.dot(ConstVector(needs[2])));
      });
  graph.define(
      "casimir", {"_gamma", "_cross"},
      [](auto needs, double* casimir) {
        ConstVector const M(needs[0]), gamma(needs[1]);
        casimir[0] = gamma.squaredNorm(), casimir[1] = M.dot(gamma);
      },
      [unit](auto needs, double const*, std::size_t component) {
        return component == 0 ? QuantityGraph::Unit(1)
                              : unit(magnitude(Eigen::Vector3d(ConstVector(needs[0]))));
      });
}

Simulation prepare(Request const& request) {
  TopScene scene(request);
  Simulation simulation(with_conserved("heavy_top", quantities(),
                                       scene.is_free() ? std::set<Feature>{} : std::set{Feature::gravity}));
  auto motion = motion_of(scene, request.schedule, simulation.failure);
  if (simulation.failure.empty()) simulation.companion = companion_of(scene, request.error_estimate);
  define_turning_body(simulation.quantities, *motion, scene.top.inertia);
  define_top(simulation.quantities, scene);
  simulation.quantities.ask(request.quantities);
  simulation.step = scene.step;
  simulation.work = work_of_step(scene.choice.order);
  simulation.remarks = scene.remarks;
  if (scene.is_free()) {
    simulation.shortcuts.push_back("no gravity: free motion, exact flow");
    if (!simulation.quantities.needed("attitude")) {
      motion->leave_attitude_out();
      simulation.shortcuts.push_back("momentum only: no attitude is reconstructed");
    }
  }
  simulation.motion = std::move(motion);
  return simulation;
}

BodyShape shape(SceneFile const& file) {
  return {read_inertia(file.section("system")),
          {},
          BodyShape::Top{top_keys.mass.read(file), top_keys.centre_of_mass.read(file),
                         top_keys.gravity.read(file)}};
}

}  // namespace

/// The rigid body held at a point under gravity.
System heavy_top_system() {
  return {"heavy_top",
          "Heavy top",
          "A rigid body held at a point under uniform gravity.",
          "chapter 3",
          records_of({top_keys, initial_parameters(momentum_keys), accuracy_keys}),
          methods(),
          quantities(),
          prepare,
          "[system]\nkind = \"heavy_top\"\nmass = 1\ninertia = [1, 1, 0.5]\ncentre_of_mass = [0, 0, 1]\n"
          "gravity = [0, 0, -9.81]\n[initial]\nangular_velocity = [0.5, 0, 20]\n[run]\nuntil = 5\n"
          "every = 0.01\n[output]\nquantities = [\"attitude\", \"energy\"]\n",
          shape};
}

}  // namespace actio::scene
