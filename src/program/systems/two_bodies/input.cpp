#include <Eigen/Core>

#include "program/systems/two_bodies/input.hpp"

#include <fmt/format.h>

#include <numbers>

#include "program/registry/accuracy.hpp"
#include "program/registry/common_keys.hpp"
#include "program/systems/bodies/angle_input.hpp"
#include "program/systems/bodies/body_input.hpp"
#include "program/systems/refused_at.hpp"
#include "program/systems/two_bodies/mass_input.hpp"

namespace actio::scene {
namespace {

struct PairKeys : KeyTable {
  Key<int> order =
      key("order", whole("a whole number from 2 to 8", 2, 8), 4,
          "The order of the mutual potential: its terms up to this power of size over distance.", "4");
  Key<double> G =
      key("G", positive.in("length^3/(mass time^2)"), 6.67430e-11,
          "The constant of gravitation; by default that of SI units, CODATA 2018.", "6.67430e-11");
} const pair_keys{{"system"}};

/// Elements of an orbit.
struct OrbitKeys : KeyTable {
  Key<double> a = key("a", number.in("length"), needed, "The half axis; negative on a hyperbola.", "1190");
  Key<double> e = key("e", number.in("1"), 0, "The eccentricity, not 1.", "0.02");
  Key<double> i = key("i", number.in("radians"), 0, "The inclination.", "0.1");
  Key<double> node = key("node", number.in("radians"), 0, "The longitude of the ascending node.", "1");
  Key<double> pericentre =
      key("pericentre", number.in("radians"), 0, "The argument of the pericentre, from the node.", "2");
  Key<double> time = key("time", number.in("time"), 0, "When the pericentre is passed.", "-3600");
  Key<bool> degrees = key("degrees", truth, false, "Whether the three angles are in degrees.", "true");

  bodies::OrbitElements read(SceneTable const& orbit) const {
    double const unit = degrees.read(orbit) ? std::numbers::pi / 180 : 1;
    return {a.read(orbit),
            e.read(orbit),
            unit * i.read(orbit),
            unit * node.read(orbit),
            unit * pericentre.read(orbit),
            time.read(orbit)};
  }
};
OrbitKeys const orbit_keys{{"initial.orbit", LeftOut{"or initial.position or initial.velocity"},
                            "The orbit of the second body about the first: of two points, at the time 0.",
                            "{ a = 1190, e = 0.02 }"}};
struct ThirdKeys : KeyTable {
  Key<double> mass = key("mass", positive.in("mass"), needed, "Its mass.", "1.989e30");
} const third_keys{
    {"system.third_body", LeftOut{"none"},
     "A third body, a point that moves about the barycentre of the two on an orbit of its own.",
     "{ mass = 1.989e30, orbit = { a = 2.46e11, e = 0.38 } }"}};
OrbitKeys const third_orbit_keys{
    {"system.third_body.orbit", LeftOut{"needed with system.third_body"}, "Its orbit.", "{ a = 2.46e11 }"}};

struct TideKeys : KeyTable {
  Key<std::vector<double>> love =
      key("love", numbers("two numbers", 2).in("1"), needed,
          "Love's numbers k2 of the first and of the second body.", "[1e-5, 1e-5]");
  Key<std::vector<double>> lag = key("lag", numbers("two numbers", 2).in("radians"), needed,
                                     "The angles by which their bulges are ahead.", "[0.01, 0.01]");
  Key<std::vector<double>> reference = key("reference", numbers("two numbers > 0", 2).in("length"),
                                           LeftOut{"the radii"}, "Their reference radii.", "[390, 80]");
  Key<std::vector<double>> density =
      key("density", numbers("two numbers > 0", 2).in("mass/length^3"),
          LeftOut{"those of the bodies, where they have one"}, "Their densities.", "[2400, 2400]");
} const tide_keys{{"system.tides", LeftOut{"none"}, "Tides with a constant lag.",
                   "{ love = [1e-5, 1e-5], lag = [0.01, 0.01] }"}};

struct StartKeys : KeyTable {
  Key<Eigen::Vector3d> position =
      key("position", vector.in("length"), LeftOut{"or initial.orbit"},
          "From the centre of mass of the first body to that of the second, in space.", "[1189, 0, 0]");
  Key<Eigen::Vector3d> velocity =
      key("velocity", vector.in("length/time"), LeftOut{"or initial.orbit"},
          "The velocity of the second body relative to the first, in space.", "[0, 0.17, 0]");
} const start_keys{{"initial"}};

/// Attitude and angular velocity of one body: as of a single one, in a table of its own.
struct SpinKeys {
  KeyTable table;
  AttitudeKeys attitude;
  AngleKeys angular_velocity;

  SpinKeys(std::string const& name, std::string const& which)
      : table(name, LeftOut{"at rest along the axes of space"},
              "Attitude and angular velocity of the " + which + ".", "{ angular_velocity = [0, 0, 7.7e-4] }"),
        attitude{
            {name + ".attitude", LeftOut{"[1, 0, 0, 0]"},
             "The rotation that takes the " + which + " to space, as initial.attitude of rigid_body.",
             "[1, 0, 0, 0]",
             "a unit quaternion, a 3 by 3 rotation matrix, or a table with axis and degrees or radians"}},
        angular_velocity{{name + ".angular_velocity", LeftOut{"[0, 0, 0]"},
                          "The angular velocity of the " + which + ", in its frame; a list is in radians.",
                          "[0, 0, 7.7e-4]", "three numbers; or a table with degrees", "1/time"},
                         "three numbers",
                         "[0, 0, 0.04]"} {}
};
SpinKeys const first_spin{"initial.primary", "first body"}, second_spin{"initial.secondary", "second body"};

StepKeys const pair_step{
    "from the pace of orbit and rotations",
    "The time that a step takes. By default the longest that divides the times of the rows and in which, in "
    "the pericentre, the orbit turns by at most 0.15 rad and no body by more than an eighth of a revolution; "
    "with splitting of order 4 by 0.05 rad and a sixteenth; of order 2, and with moser_veselov, by 0.01 rad "
    "and a sixty-fourth.",
    "600"};

/// Position and velocity at the time 0.
std::pair<Eigen::Vector3d, Eigen::Vector3d> read_orbit(SceneFile const& file, double mu) {
  SceneTable const initial = file.section("initial");
  if (!initial.has("orbit")) return {start_keys.position.read(initial), start_keys.velocity.read(initial)};
  if (start_keys.position.given(initial) || start_keys.velocity.given(initial))
    initial.fail("orbit", "orbit excludes position and velocity");
  return refused_at(initial, "orbit", [&]() -> std::pair<Eigen::Vector3d, Eigen::Vector3d> {
    auto const elements = orbit_keys.read(initial.inside("orbit"));
    auto const from = bodies::at_pericentre(elements, mu);
    auto const by = bodies::kepler_drift<double>(from.position, from.velocity, mu, -elements.time);
    Eigen::Vector3d const x(from.position.data()), v(from.velocity.data());
    return {x + Eigen::Vector3d(by.position.data()), v + Eigen::Vector3d(by.velocity.data())};
  });
}

struct Spin {
  Element<SU2, double> attitude;
  Eigen::Vector3d rate;
};
Spin read_spin(SpinKeys const& keys, SceneFile const& file, std::vector<std::string>& remarks) {
  SceneTable table = file.section(keys.table.name());
  if (!table.has("angular_velocity")) table.set("angular_velocity", std::vector<double>{0, 0, 0});
  Element<SU2, double> const attitude{{}, read_attitude(table, remarks)};
  return {attitude, Eigen::Vector3d(keys.angular_velocity.read(table, 3).data())};
}

std::array<bodies::Tide, 2> read_tides(PairScene const& scene, SceneTable const& table) {
  auto const love = tide_keys.love.read(table), lag = tide_keys.lag.read(table),
             reference = tide_keys.reference.read_or(table, {scene.primary.radius, scene.secondary.radius}),
             density = tide_keys.density.read_or(table, {scene.densities[0], scene.densities[1]});
  auto const tide = [&](std::size_t k) { return bodies::Tide{love[k], lag[k], reference[k], density[k]}; };
  return refused_at(table, "density", [&] {
    for (double const rho : density)
      if (!(rho > 0)) tide_keys.density.fail(table, fmt::format("two numbers > 0 are needed, found {}", rho));
    return std::array{tide(0), tide(1)};
  });
}

/// The angular velocity in the pericentre of an orbit of two points: h/q^2 with q = p/(1 + e).
double rate_in_pericentre(Eigen::Vector3d const& position, Eigen::Vector3d const& velocity, double mu) {
  double const r = position.norm(), slowest = std::sqrt(mu / r) / r;
  Eigen::Vector3d const h = position.cross(velocity), e = velocity.cross(h) / mu - position / r;
  double const p = h.squaredNorm() / mu;
  return p > 0 ? std::max(slowest, h.norm() * std::pow((1 + e.norm()) / p, 2)) : slowest;
}

/// The longest parts of a revolution in a default step: of the orbit, radians, and how many steps a body
/// takes to turn once.
struct Pace {
  double orbit, turns;
};
Pace pace_of(MethodChoice const& choice) {
  if (choice.name == "kepler_splitting") return {0.15, 8};
  return choice.order == "4" ? Pace{0.05, 16} : Pace{0.01, 64};
}

}  // namespace

std::vector<Parameter> pair_parameters() {
  return records_of({pair_keys, mass_parameters("system.primary", "first body"),
                     mass_parameters("system.secondary", "second body"), third_keys, third_orbit_keys,
                     tide_keys, start_keys, orbit_keys, first_spin.table, first_spin.attitude,
                     first_spin.angular_velocity, second_spin.table, second_spin.attitude,
                     second_spin.angular_velocity, pair_step, accuracy_keys});
}

PairScene::PairScene(Request const& request, std::vector<Method> const& methods) {
  read_bodies(request.file);
  read_surroundings(request.file);
  read_start(request.file);
  require_apart(request.file.section("initial"));
  read_steps(request, methods);
}

void PairScene::read_bodies(SceneFile const& file) {
  SceneTable const one = file.section("system.primary"), two = file.section("system.secondary");
  int& order = options.order;
  order = pair_keys.order.read(file), options.G = pair_keys.G.read(file);
  for (auto const* const table : {&one, &two})
    if (order > 2 && is_of_order_two(*table)) {
      remarks.push_back(
          fmt::format("system.order: of a body of the library moments of order 2 are known; the potential is "
                      "taken to order 2, not {}",
                      order));
      order = 2;
    }
  auto first = read_mass(one, order, remarks), second = read_mass(two, order, remarks);
  primary = std::move(first.body), secondary = std::move(second.body);
  densities = {first.density, second.density};
  if (order % 2 == 0 || !has_planes_of_symmetry(primary) || !has_planes_of_symmetry(secondary)) return;
  remarks.push_back(
      fmt::format("system.order: bodies with three planes of symmetry have no terms of odd order; {} is the "
                  "same as {}",
                  order, order - 1));
  --order;
}

void PairScene::read_surroundings(SceneFile const& file) {
  SceneTable const system = file.section("system");
  if (system.has("third_body")) {
    SceneTable const third = system.inside("third_body");
    auto const elements = third_orbit_keys.read(third.inside("orbit"));
    options.third = refused_at(third, "orbit", [&] {
      return bodies::third_body(third_keys.mass.read(third), elements, mass(), options.G);
    });
  }
  if (system.has("tides")) options.tides = read_tides(*this, system.inside("tides"));
}

void PairScene::read_start(SceneFile const& file) {
  double const mu = options.G * mass();
  auto const [position, velocity] = read_orbit(file, mu);
  Spin const one = read_spin(first_spin, file, remarks), two = read_spin(second_spin, file, remarks);
  start = bodies::state_of_velocities(primary, secondary, position, velocity, one.attitude, one.rate,
                                      two.attitude, two.rate);
  fastest_orbit = rate_in_pericentre(position, velocity, mu);
  fastest_turn = std::max(one.rate.norm(), two.rate.norm());
}

void PairScene::require_apart(SceneTable const& initial) {
  double const r = start.position.norm(), near = (primary.radius + secondary.radius) / r;
  std::string const key = initial.has("orbit") ? "orbit" : "position";
  if (!(near < 1))
    initial.fail(
        key,
        fmt::format("{}: the bodies are too near for the series of their potential: the radii of the spheres "
                    "about them, {:.6g} and {:.6g}, are {:.4g} of the distance {:.6g} together, and less "
                    "than 1 is needed",
                    key, primary.radius, secondary.radius, near, r));
  if (near > 0.6)
    remarks.push_back(
        fmt::format("{}: the radii of the spheres about the bodies are {:.2g} of the distance together; the "
                    "terms of the potential beyond order {} are about the power {} of that",
                    key, near, options.order, options.order + 1));
}

void PairScene::read_steps(Request const& request, std::vector<Method> const& methods) {
  SceneTable const method = request.file.section("method");
  choice = read_method(method, methods);
  options.method = choice.name == "kepler_splitting" ? bodies::kepler_splitting()
                   : choice.name == "splitting"      ? bodies::pair_splitting(choice.number())
                                                     : bodies::moser_veselov_pair();
  constexpr double full = 2 * std::numbers::pi;
  Pace const pace = pace_of(choice);
  options.step = read_step(method, request.schedule,
                           std::max(fastest_orbit / pace.orbit, fastest_turn * pace.turns / full), 1);
  // Of steps that an accuracy has chosen the error is known.
  if (accuracy_keys.accuracy.given(request.file)) return;
  if (double const turns = fastest_turn * options.step / full; turns > 1 / 6.)
    remarks.push_back(
        fmt::format("step: the faster body turns by {:.2g} of a revolution in a step of {}; up to a sixth, a "
                    "step of {:.3g}, the method is accurate",
                    turns, options.step, full / 6 / fastest_turn));
}

}  // namespace actio::scene
