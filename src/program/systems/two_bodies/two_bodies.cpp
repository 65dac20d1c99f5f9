// Two rigid bodies of any shape under their mutual gravity (thesis, chapter 10: (M x M)/G).
#include <Eigen/Core>

#include <algorithm>
#include <cmath>

#include "program/catalogue/body_shape.hpp"
#include "program/registry/companion.hpp"
#include "program/registry/conservation.hpp"
#include "program/systems/two_bodies/mass_input.hpp"
#include "program/systems/two_bodies/quantities.hpp"

namespace actio::scene {
namespace {

std::vector<Method> methods() {
  return {
      {"kepler_splitting",
       {"8,4"},
       "Drifts along an orbit of Kepler with freely turning bodies, and kicks by the rest of the potential: "
       "where that is small the order is 8, for large parts of it 4 (Blanes and others, ABA 8,6,4).",
       ""},
      {"splitting",
       {"4", "2"},
       "Straight drifts with freely turning bodies, and kicks by the potential: order 2 (Strang) or 4 "
       "(Blanes and Moan).",
       ""},
      {"moser_veselov",
       {"2"},
       "Straight drifts with bodies that turn by the scheme of Moser and Veselov, and kicks by the "
       "potential: order 2.",
       "eq_5_9"}};
}

bool asked(Request const& request, std::initializer_list<char const*> names) {
  return std::ranges::any_of(names, [&](char const* name) {
    return std::ranges::find(request.quantities, name) != request.quantities.end();
  });
}

PairMotion::Follows follows_of(Request const& request, PairScene const& scene) {
  PairMotion::Follows const out{asked(request, {"mean_period", "precession"}),
                                asked(request, {"tangent_map", "lyapunov", "sensitivity"})};
  if (out.tangent && scene.options.tides)
    request.file.section("output").fail(
        "quantities", "tangent_map, lyapunov and sensitivity are those of a motion without system.tides");
  return out;
}

/// The order that steps of the run and twice as long show over some radians of the start. That of Kepler's
/// splitting is 8 where the rest of the potential is small beside the steps, and 4 in the limit of short
/// steps; with tides 2.
int order_shown(PairScene const& scene) try {
  if (scene.choice.name != "kepler_splitting") return scene.options.method.splitting.order;
  constexpr long steps = 24;
  auto const after = [&](double length) {  // in steps of the run
    PairMotion motion(scene, length * scene.options.step, {});
    motion.advance(std::lround(static_cast<double>(steps) / length));
    return motion;
  };
  PairMotion const truth = after(0.25);
  auto const error = [&](double length) {
    StateDistance const d = truth.distance(after(length));
    return d.attitude + d.momentum / d.modulus;
  };
  double const slope = std::log2(error(2) / error(1));
  return slope < 3 ? 2 : slope < 5 ? 4 : slope < 7 ? 6 : 8;
} catch (Error const&) {
  return scene.options.method.splitting.order;  // the bodies come too near, which the run will tell
}

/// Steps twice and four times as long: longer ones show another order than those of the run.
Companion companion_of(Request const& request, PairScene const& scene) {
  if (!request.error_estimate.value_or(true))
    return {nullptr, 0, 0, true, "left out by output.error_estimate"};
  constexpr long multiple = 2;
  Companion out = companions(
      [&](long longer) {
        return std::make_unique<PairMotion>(scene, static_cast<double>(longer) * scene.options.step,
                                            PairMotion::Follows{});
      },
      {multiple}, order_shown(scene), true);
  out.momentum = "position";
  for (char const* const name : {"precession", "mean_period", "tangent_map", "sensitivity", "lyapunov"})
    if (asked(request, {name})) out.without.emplace_back(name);
  return out;
}

Simulation prepare(Request const& request) {
  PairScene const scene(request, methods());
  std::set<Feature> here;
  if (scene.options.third) here.insert(Feature::third_body);
  if (scene.options.tides) here.insert(Feature::tides);
  Simulation simulation(with_conserved("two_bodies", pair_quantities(), here));
  simulation.remarks = scene.remarks;
  simulation.step = scene.options.step;
  simulation.work = static_cast<double>(scene.options.method.splitting.drifts.size());
  auto const follows = follows_of(request, scene);
  simulation.steps_at_once = follows.tangent ? 16 : 1 << 10;
  auto motion = std::make_unique<PairMotion>(scene, simulation.step, follows);
  try {
    PairMotion(scene, simulation.step, {}).advance(1);
    simulation.companion = companion_of(request, scene);
  } catch (Error const& error) {
    simulation.failure = request.file.section("method").place("step").text() + ": " + error.what();
  }
  if (scene.choice.name == "kepler_splitting")
    simulation.shortcuts.push_back(
        "between kicks the orbit is Kepler's and the bodies turn freely, both exactly");
  define_pair(simulation.quantities, *motion);
  simulation.quantities.ask(request.quantities);
  simulation.motion = std::move(motion);
  return simulation;
}

/// Moments up to the second order are all that their pictures need.
std::vector<OrbitingBody> bodies_of(SceneFile const& file) {
  std::vector<OrbitingBody> out;
  for (char const* const name : {"system.primary", "system.secondary"}) {
    std::vector<std::string> told_before;
    auto const body = read_mass(file.section(name), 2, told_before).body;
    Matrix<double, 3, 1> const moments(body.inertia[0], body.inertia[1], body.inertia[2]);
    out.push_back({body.mass(), body.radius, {inertia_from_moments<double>(moments), body.axes}});
  }
  return out;
}

}  // namespace

/// Two bodies that attract each other.
System two_bodies_system() {
  System out{
      "two_bodies",
      "Two bodies that attract each other",
      "Two rigid bodies of any shape under their mutual gravity, with a third body and tides where asked "
      "for: binary asteroids, planets and moons.",
      "chapter 10",
      pair_parameters(),
      methods(),
      pair_quantities(),
      prepare,
      "[system]\nkind = \"two_bodies\"\nprimary = { ellipsoid = [394, 394, 290], density = 2800 }\n"
      "secondary = { ellipsoid = [96, 74, 60], density = 2800 }\n[initial]\nposition = [1189, 0, 0]\n"
      "velocity = [0, 0.17, 0]\n[run]\nuntil = 86400\nevery = 600\n[output]\n"
      "quantities = [\"position\", \"libration\", \"energy\"]\n"};
  out.bodies = bodies_of;
  return out;
}

}  // namespace actio::scene
