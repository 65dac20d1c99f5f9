// The table of what motions conserve, row by row: a drift is printed of what a scene conserves, and is small;
// what a feature of a scene ends has none, and does change.
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>

#include "program/registry/conservation.hpp"
#include "program/run/run.hpp"

using namespace actio::scene;

namespace {

using enum Feature;

/// A scene, and which of the features it has; the first one is what it was made for.
struct Featured {
  std::string system;
  std::vector<Feature> features;
  std::string text;
  bool has(Feature one) const { return std::ranges::find(features, one) != features.end(); }
};

std::string ending(std::string const& quantities, std::string const& until, std::string const& every) {
  return "[run]\nuntil = " + until + "\nevery = " + every + "\n[output]\nquantities = [" + quantities + "]\n";
}

/// A medium in the unit square, in a smooth motion. Where nothing else is said its sides are free, and a gas
/// is under its own pressure.
struct Medium {
  bool fluid;
  std::string system = "", mesh = "", material = "", load = "pressure = 1", loop = "";
  std::string velocity = "\"0.1*sin(pi*Y)\", \"0.1*cos(pi*X)\"", method = "";

  std::string text() const {
    std::string const law = !material.empty() ? material
                            : fluid           ? "name = \"polytropic_gas\", K = 1, gamma = 2"
                                              : "name = \"neo_hookean\", mu = 1, kappa = 2";
    return "[system]\nkind = \"" + std::string(fluid ? "barotropic_fluid" : "elastic_body") +
           "\"\nmesh = { lower = [0, 0], upper = [1, 1], cells = [32, 32]" + mesh + " }\nmaterial = { " +
           law + " }\n" + system + "\n" + (load.empty() ? "" : "load = { " + load + " }\n") +
           (fluid ? "loops = { ring = " +
                        (loop.empty() ? "{ lower = [0.25, 0.25], upper = [0.75, 0.75] }" : loop) + " }\n"
                  : "") +
           "[initial]\nplacement = [\"X + 0.005*sin(2*pi*X)\", \"Y\"]\nvelocity = [" + velocity +
           "]\n[method]\n" + method + "\n" +
           ending(std::string("\"energy\", \"momentum\", \"angular_momentum\"") +
                      (fluid ? ", \"circulation\"" : ""),
                  "0.5", "0.05");
  }
};

std::vector<Featured> media() {
  std::string const periodic = ", periodic = [true, true]",
                    waves = "\"0.1*sin(2*pi*Y)\", \"0.1*cos(2*pi*X)\"", none = "",
                    around = "{ along = \"X\", through = [0, 0.5] }";
  std::vector<Featured> out;
  for (bool const fluid : {true, false}) {
    std::string const kind = fluid ? "barotropic_fluid" : "elastic_body", own = fluid ? "pressure = 1" : "";
    auto const add = [&](std::vector<Feature> features, Medium scene) {
      scene.fluid = fluid;
      if (!fluid && scene.load == "pressure = 1") scene.load = "";
      out.push_back({kind, std::move(features), scene.text()});
    };
    Medium const base{fluid};
    Medium scene = base;
    add({}, scene);
    scene = base, scene.mesh = periodic, scene.velocity = waves, scene.load = none;
    add({periodic_box}, scene);
    for (std::string const does : {"fixed", "sliding"}) {
      scene = base, scene.system = "boundary = { left = \"" + does + "\" }";
      scene.velocity = "\"0.1*sin(pi*Y)*X\", \"0.1*(cos(pi*X) - 1)\"";
      add({held_side}, scene);
      scene.velocity = "\"0.3*(1 - X)\", \"0\"";
      add({driven_side, held_side}, scene);
    }
    // Whatever slides along a wall does no work there.
    scene = base, scene.system = "boundary = { left = \"sliding\", right = \"sliding\" }";
    scene.velocity = "\"0\", \"0.1*cos(pi*X)\"";
    add({held_side}, scene);
    scene = base, scene.velocity = "\"0\", \"0\"";
    scene.load = own + (fluid ? ", " : "") + "motion.left = [\"0.5*sin(t)^2\", \"Y\"]";
    add({moved_side, held_side}, scene);
    scene = base, scene.load = own + (fluid ? ", " : "") + "gravity = \"0.3*y^2\"";
    add({potential}, scene);
    scene = base, scene.load = own + (fluid ? ", " : "") +
                               (fluid ? "traction.right = [0.02, 0]" : "traction.right = [0.05, 0.1]");
    scene.method = "step = 0.0025";
    add({traction}, scene);
    scene = base,
    scene.load = fluid ? "pressure = { left = 1, right = \"1 + 0.3*sin(5*t)\", top = 1, bottom = 1 }"
                       : "pressure.right = \"0.1 + 0.1*sin(5*t)\"";
    scene.method = "step = 0.0025";
    add({pressure_on_a_side}, scene);
    scene = base, scene.mesh = periodic, scene.load = none;
    scene.velocity = "\"0.3*sin(2*pi*(X + 2*Y))\", \"0.3*sin(2*pi*(Y - X))\"";
    scene.method = "viscosity = { linear = 0.5, quadratic = 2 }";
    add({viscosity, periodic_box}, scene);
    if (!fluid) continue;
    scene = base, scene.mesh = periodic, scene.velocity = waves, scene.load = "gravity = \"0.3*x\"";
    scene.loop = around;
    add({potential_around_a_loop, potential, periodic_box}, scene);
    // One that does not grow around the box drives no circulation, and neither does one along another way.
    scene.load = "gravity = \"0.05*sin(2*pi*x)\"";
    add({potential, periodic_box}, scene);
    scene.load = "gravity = \"0.3*y\"";
    add({potential, periodic_box}, scene);
    scene = base, scene.system = "boundary = { left = \"fixed\" }";
    scene.velocity = "\"0.1*cos(pi*Y)*X\", \"0.1*(cos(pi*X) - 1)\"";
    scene.loop = "{ lower = [0, 0.25], upper = [0.5, 0.75] }";
    add({loop_at_a_side, held_side}, scene);
    scene = base, scene.load = "", scene.material = "name = \"tait\", B = 10, gamma = 2";
    scene.system = "density = \"1 + 0.8*Y\"", scene.velocity = "\"0\", \"0\"";
    scene.loop = "{ lower = [0.25, 0.25], upper = [0.5, 0.75] }", scene.method = "step = 0.000625";
    add({pressure_of_the_jacobian}, scene);
    // The pressure of a gas is a function of its density, however that varies.
    scene = base, scene.load = "", scene.mesh = periodic;
    scene.system = "density = \"1 + 0.2*sin(2*pi*Y)\"", scene.velocity = waves;
    add({periodic_box}, scene);
  }
  return out;
}

/// Incompressible media, which move in half a unit of time by some tenths of a cell.
std::vector<Featured> incompressible_media() {
  std::vector<Featured> out;
  for (bool const fluid : {true, false}) {
    std::string const kind = fluid ? "incompressible_fluid" : "incompressible_body";
    auto const add = [&](std::vector<Feature> features, std::string const& keys, std::string const& velocity,
                         std::string const& periodic = "") {
      out.push_back({kind, std::move(features),
                     "[system]\nkind = \"" + kind +
                         "\"\nmesh = { lower = [0, 0], upper = [1, 1], cells = [13, 12]" + periodic + " }\n" +
                         (fluid ? "" : "material = { name = \"neo_hookean\", mu = 1, kappa = 0 }\n") + keys +
                         "[initial]\nproject = true\nvelocity = [" + velocity +
                         "]\n[method]\nstep = 0.005\n" +
                         ending("\"energy\", \"momentum\", \"angular_momentum\"", "0.5", "0.05")});
    };
    std::string const waves = "\"0.1*sin(pi*Y)\", \"0.1*cos(pi*X)\"";
    add({}, "", waves);
    add({periodic_box}, "", "\"0.1*sin(2*pi*Y)\", \"0.1*cos(2*pi*X)\"", ", periodic = [true, true]");
    add({held_side}, "boundary = { left = \"sliding\" }\n", "\"0.1*sin(pi*Y)*X\", \"0.1*(cos(pi*X) - 1)\"");
    add({driven_side, held_side}, "boundary = { left = \"fixed\" }\n", "\"0.3*(1 - X)\", \"0.3*Y\"");
    add({moved_side, held_side}, "load = { motion.left = [\"0.5*sin(t)^2\", \"Y\"] }\n", "\"0\", \"0\"");
    add({potential}, "load = { gravity = \"0.3*y\" }\n", waves);
    // Nothing in a fluid resists a shear.
    add({traction},
        fluid ? "load = { traction.right = [0.05, 0] }\n" : "load = { traction.right = [0.05, 0.1] }\n",
        waves);
    add({pressure_on_a_side}, "load = { pressure.right = \"0.1 + 0.1*sin(5*t)\" }\n", waves);
  }
  out.push_back({"fluid_on_sphere",
                 {},
                 "[system]\nkind = \"fluid_on_sphere\"\nmesh = { cells = 6 }\n[initial]\n"
                 "stream = \"-0.3*x + 0.5*z + 0.2*x*y\"\n" +
                     ending("\"energy\", \"angular_momentum\"", "1", "0.1")});
  return out;
}

std::vector<Featured> bodies() {
  std::string const start = "[initial]\nangular_velocity = [0.3, 0.7, 0.5]\n",
                    body = "[system]\nkind = \"rigid_body\"\ninertia = [1, 2, 2.5]\n",
                    all = ending(
                        "\"energy\", \"casimir\", \"spatial_momentum\", "
                        "\"axial_momentum\", \"jacobi_integral\"",
                        "20", "0.5"),
                    top =
                        "[system]\nkind = \"heavy_top\"\nmass = 1\ninertia = [1, 1, 0.5]\n"
                        "centre_of_mass = [0, 0.1, 1]\n",
                    of_top = ending("\"energy\", \"casimir\", \"spatial_momentum\", \"vertical_momentum\"",
                                    "5", "0.5");
  auto const potential = [&](std::string const& V) {
    return body + "torque = { potential = \"" + V + "\" }\n" + start + all;
  };
  return {
      {"rigid_body", {}, body + start + all},
      {"rigid_body", {torque}, potential("0.3*r33")},
      {"rigid_body", {torque_of_time, torque, torque_depends_on_time}, potential("0.3*r33*cos(t)")},
      {"rigid_body", {torque_without_axis, torque}, potential("0.3*r33 + 0.4*r11")},
      {"rigid_body",
       {torque_depends_on_time, torque, torque_without_axis},
       body + "torque = { gravity_gradient = { rate = 0.5, direction = [1, 0, 0], normal = [0, 0, 1] } }\n" +
           start + all},
      {"rigid_body",
       {torque_without_potential, torque, torque_without_axis},
       body + "torque = { body = [\"-0.1*w1\", \"0.05*w2*w3\", \"0.1\"] }\n" + start + all},
      {"heavy_top", {}, top + "gravity = [0, 0, 0]\n" + start + of_top},
      {"heavy_top", {gravity}, top + "gravity = [0, 0, -9.81]\n" + start + of_top},
      {"rigid_body_n",
       {},
       "[system]\nkind = \"rigid_body_n\"\nlambda = [1, 2, 3, 4]\n[initial]\n"
       "angular_velocity = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6]\n" +
           ending("\"energy\", \"spectrum\", \"casimir\"", "20", "0.5")},
      {"vorticity_sphere",
       {},
       "[system]\nkind = \"vorticity_sphere\"\nN = 12\nrotation = 1\n[initial]\n"
       "harmonics = [[3, 2, 0.2, 0.1], [2, 1, 0.3, 0.1], [1, 1, 0.2, 0]]\n" +
           ending("\"energy\", \"enstrophy\", \"angular_momentum\", \"casimirs\", \"extrema\"", "5", "0.5")},
      {"vorticity_torus",
       {},
       "[system]\nkind = \"vorticity_torus\"\nN = 15\n[initial]\n"
       "vorticity = \"cos(x) + cos(2*y) + 0.5*sin(x + y)\"\n" +
           ending("\"energy\", \"enstrophy\", \"casimirs\", \"extrema\"", "5", "0.5")},
  };
}

std::vector<Featured> pairs() {
  auto const pair = [](std::vector<Feature> features, std::string const& system) {
    return Featured{
        "two_bodies", features,
        "[system]\nkind = \"two_bodies\"\nG = 1\nprimary = { ellipsoid = [0.5, 0.4, 0.3], density = 1 }\n"
        "secondary = { ellipsoid = [0.3, 0.2, 0.1], density = 1 }\n" +
            system +
            "[initial]\nposition = [2, 0, 0]\nvelocity = [0, 0.37, 0.05]\n"
            "primary.angular_velocity = [0.1, 0.2, 0.5]\n" +
            ending("\"energy\", \"momentum\"", "50", "0.5")};
  };
  return {pair({}, ""), pair({third_body}, "third_body = { mass = 5, orbit = { a = 8, e = 0.3 } }\n"),
          pair({tides}, "tides = { love = [5, 5], lag = [0.4, 0.4] }\n")};
}

std::vector<Featured> rods() {
  auto const rod = [](std::vector<Feature> features, std::string const& more, std::string const& velocity) {
    return Featured{
        "rod", std::move(features),
        "[system]\nkind = \"rod\"\nrod = { length = 1, elements = 20, section = { EA = 90, GA = 40, EI = 1, "
        "GJ = 1, rA = 1, rI = 0.01 } }\n" +
            more + "[initial]\nvelocity = [" + velocity +
            "]\nangular_velocity = [\"0.2*s^2*(1 - s)^2\", \"0\", \"0\"]\n" +
            ending("\"energy\", \"momentum\", \"angular_momentum\"", "2", "0.05")};
  };
  // At rest where an end is held.
  std::string const at_start = "\"0\", \"0.3*x^2\", \"0.2*x^3\"",
                    at_end = "\"0\", \"0.3*(1 - x)^2\", \"0.2*(1 - x)^3\"";
  return {rod({}, "", at_start),
          rod({gravity}, "load = { gravity = [0, 0, -1] }\n", at_start),
          rod({held_end}, "boundary = { start = \"clamped\" }\n", at_start),
          rod({held_end}, "boundary = { end = \"pinned\" }\n", at_end),
          rod({moved_end, held_end},
              "boundary = { start = { place = [\"0\", \"0.1*sin(t)^2\", \"0\"], axis = [0, 0, 1], "
              "angle = \"0.2*sin(t)^2\" } }\n",
              at_start),
          rod({end_load}, "load = { end_force = [\"0\", \"0.3\", \"0\"] }\n", at_start)};
}

std::vector<Featured> lagrangians() {
  std::vector<Featured> out;
  for (bool const left : {true, false}) {
    auto const add = [&](std::vector<Feature> more, std::string const& term, std::string const& keys) {
      std::vector<Feature> features{left ? left_invariance : right_invariance};
      features.insert(features.begin(), more.begin(), more.end());
      out.push_back(
          {"euler_poincare", features,
           "[system]\nkind = \"euler_poincare\"\ngroup = \"SO(3)\"\nside = \"" +
               std::string(left ? "left" : "right") + "\"\nlagrangian = \"(w1^2 + 2*w2^2 + " + "2.5*w3^2)/2" +
               term + "\"\n" + keys + "[initial]\nvelocity = [0.3, 0.7, 0.5]\n[method]\nstep = 0.025\n" +
               ending("\"energy\", \"casimir\", \"spatial_momentum\", \"body_momentum\"" +
                          std::string(keys.starts_with("advected") ? ", \"up\"" : ", \"momentum_balance\""),
                      "20", "0.5")});
    };
    add({}, "", "");
    add({carried_vector}, " - 0.3*up3", "advected = { up = [0, 0.6, 0.8] }\n");
    // One that the Lagrangian does not depend on.
    add({}, "", "advected = { up = [0, 0.6, 0.8] }\n");
    add({force}, "", "force = [\"0.1*cos(t)\", \"-0.1*w2\", \"0.1\"]\n");
    add({damping}, "", "dissipation = { kind = \"conformal\", rate = 0.05 }\n");
    add({friction_on_the_orbit}, "", "dissipation = { kind = \"orbit\", rate = 0.1 }\n");
    std::string const up = "advected = { up = [0, 0.6, 0.8] }\n";
    add({constraint_on_velocity}, "", up + "constraints = [\"w1 + w2 - 2*w3\"]\n");
    add({moving_constraint, constraint_on_velocity}, "",
        up + "constraints = [\"w1 + w2 - 2*w3 + 0.3*sin(t)\"]\n");
  }
  return out;
}

std::vector<Featured> scenes() {
  auto out = media();
  for (auto& more : {incompressible_media(), bodies(), pairs(), rods(), lagrangians()})
    out.insert(out.end(), more.begin(), more.end());
  return out;
}

/// How far a quantity got from its start, over the largest that it was.
double change_of(Scene const& scene, std::vector<double> const& table, std::string const& name) {
  std::size_t const width = 1 + scene.simulation.quantities.row_size();
  std::size_t first = 1, size = 0;
  for (auto const& group : scene.simulation.quantities.column_groups()) {
    size = group.columns.size();
    if (group.quantity.name == name) break;
    first += size;
  }
  double far = 0, largest = 0;
  for (std::size_t row = 0; row + width <= table.size(); row += width)
    for (std::size_t i = first; i < first + size; ++i) {
      far = std::max(far, std::abs(table[row + i] - table[i]));
      largest = std::max(largest, std::abs(table[row + i]));
    }
  return far / largest;
}

/// What the drift of something conserved may be: the order of the scheme, with steps and cells that resolve
/// the motion, or rounding.
double most_drift(std::string const& quantity) {
  return quantity == "circulation"                               ? 1e-2
         : quantity == "energy" || quantity == "jacobi_integral" ? 1e-3
                                                                 : 1e-9;
}

void check(Featured const& featured, std::set<std::pair<ConservationLaw const*, Feature>>& tried) {
  Scene scene = Scene::read(SceneFile::parse(featured.text, "scene.toml"));
  std::vector<double> table;
  auto const report = run_in_memory(scene, table, {.quiet = true});
  BOOST_REQUIRE_MESSAGE((report.ending == Ending::done), report.message << "\n" << featured.text);
  for (auto const& law : conservation_laws()) {
    if (law.system != featured.system || featured.text.find("\"" + law.quantity + "\"") == std::string::npos)
      continue;
    bool const conserved = std::ranges::none_of(law.unless, [&](Feature f) { return featured.has(f); });
    std::vector<Drift::Entry> entries;
    for (auto const& entry : report.drift)
      if (entry.name == law.quantity || entry.name.starts_with(law.quantity + "_")) entries.push_back(entry);
    BOOST_TEST(entries.empty() == !conserved, law.quantity << " of\n" << featured.text);
    for (auto const& entry : entries)
      BOOST_TEST(entry.relative <= most_drift(law.quantity), entry.name << " of\n" << featured.text);
    // What it was made for does end it.
    if (featured.features.empty() || std::ranges::find(law.unless, featured.features[0]) == law.unless.end())
      continue;
    double const change = change_of(scene, table, law.quantity);
    BOOST_TEST(change > 3 * most_drift(law.quantity), law.quantity << " changes by no more than " << change
                                                                   << " in\n"
                                                                   << featured.text);
    tried.emplace(&law, featured.features[0]);
  }
}

}  // namespace

BOOST_AUTO_TEST_SUITE(conservation)

BOOST_AUTO_TEST_CASE(a_drift_is_printed_of_what_a_scene_conserves_and_of_nothing_else) {
  std::set<std::pair<ConservationLaw const*, Feature>> tried;
  for (auto const& featured : scenes()) check(featured, tried);
  for (auto const& law : conservation_laws())
    for (auto const feature : law.unless)
      BOOST_TEST(tried.contains({&law, feature}), "no scene shows that " << law.quantity << " of "
                                                                         << law.system << " changes where "
                                                                         << in_words(feature));
}

BOOST_AUTO_TEST_CASE(every_law_is_of_a_quantity_that_there_is) {
  for (auto const& law : conservation_laws()) {
    auto const* const system = find_system(law.system);
    BOOST_REQUIRE(system);
    auto const found = std::ranges::find(system->quantities, law.quantity, &Quantity::name);
    BOOST_REQUIRE_MESSAGE(found != system->quantities.end(), law.system << " has no " << law.quantity);
    BOOST_TEST(found->conserved);
  }
  for (auto const& system : systems())
    for (auto const& quantity : system.quantities)
      BOOST_TEST(quantity.conserved == (find_law(system.name, quantity.name) != nullptr));
}

BOOST_AUTO_TEST_CASE(a_body_at_rest_has_drifts_of_rounding_or_none) {
  for (std::string const material :
       {"neo_hookean\", mu = 1, kappa = 2", "saint_venant_kirchhoff\", lambda = 1, mu = 1",
        "mooney_rivlin\", c1 = 0.4, c2 = 0.1, lambda = 1", "polytropic_gas\", K = 1, gamma = 1.4",
        "tait\", B = 100, gamma = 7"})
    for (std::string const sides : {"free", "sliding", "periodic"}) {
      bool const gas = material.starts_with("poly"), fluid = gas || material.starts_with("tait");
      std::string text = "[system]\nkind = \"" + std::string(fluid ? "barotropic_fluid" : "elastic_body") +
                         "\"\nmaterial = { name = \"" + material +
                         " }\nmesh = { lower = [0, 0], upper = [1, 1], cells = [7, 9]" +
                         (sides == "periodic" ? ", periodic = [true, true]" : "") + " }\n";
      if (sides == "sliding")
        for (char const* side : {"left", "right", "bottom", "top"})
          text += "boundary." + std::string(side) + " = \"sliding\"\n";
      if (gas && sides == "free") text += "load = { pressure = 1 }\n";
      Scene scene = Scene::read(
          SceneFile::parse(text + ending(std::string("\"energy\", \"momentum\", \"angular_momentum\"") +
                                             (fluid ? ", \"circulation\"" : ""),
                                         "1", "0.1"),
                           "scene.toml"));
      std::vector<double> table;
      for (auto const& entry : run_in_memory(scene, table, {.quiet = true}).drift)
        BOOST_TEST(entry.relative <= 1e-13, entry.name << " of " << material << ", " << sides);
    }
}

BOOST_AUTO_TEST_CASE(a_top_that_hangs_at_rest_has_drifts_of_rounding) {
  // The centre of mass below the fixed point, by a turn that numbers do not say to the last digit.
  Scene scene = Scene::read(SceneFile::parse(
      "[system]\nkind = \"heavy_top\"\nmass = 1\ninertia = [1, 1.3, 0.5]\ncentre_of_mass = [0.1, 0.2, -1]\n"
      "gravity = [0.3, 0.1, -9.81]\n[initial]\n"
      "attitude = [0.9950791068258068, -0.09302568859391677, 0.03402282166082563, -0.002498004527226551]\n"
      "angular_velocity = [0, 0, 0]\n[method]\nstep = 0.01\n" +
          ending("\"energy\", \"casimir\", \"vertical_momentum\"", "50", "0.5"),
      "scene.toml"));
  std::vector<double> table;
  for (auto const& entry : run_in_memory(scene, table, {.quiet = true}).drift)
    BOOST_TEST(entry.relative <= 1e-12, entry.name);
}

BOOST_AUTO_TEST_SUITE_END()
