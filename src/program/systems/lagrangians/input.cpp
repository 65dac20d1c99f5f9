#include <Eigen/Core>

#include "program/systems/lagrangians/input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "actio/any_group/least_regular.hpp"
#include "actio/any_group/membership.hpp"
#include "actio/any_group/momentum_across.hpp"
#include "actio/any_group/named_algebra.hpp"
#include "actio/any_group/span_of_matrices.hpp"
#include "program/systems/lagrangians/constrained_input.hpp"
#include "program/systems/lagrangians/dissipation_input.hpp"
#include "program/systems/lagrangians/force_input.hpp"
#include "program/systems/lagrangians/shape_input.hpp"

namespace actio::scene {
namespace {

struct ReducedKeys : KeyTable {
  Key<std::string> group = key(
      "group", text, LeftOut{"or system.algebra"},
      "The group: any of `actio list groups` with its numbers, \"SO(4)\", and products of them, \"SO(3) x "
      "R^2\", \"SL(2) |x R^2\". `actio show \"SE(2)\"` shows the order of the components.",
      "\"SE(2)\"");
  AnyKey algebra =
      key("algebra", "a list of square matrices, each a list of rows", LeftOut{"or system.group"},
          "A basis of the algebra of a group of one's own: linearly independent, and closed under "
          "commutators. The components of the velocity are then x1, x2, ...",
          "[[[0, 1], [0, 0]]]");
  Key<std::string> side = key(
      "side", one_of("side", {"left", "right"}), "left",
      "Which translations leave the Lagrangian as it is: \"left\" has velocities and momenta of the body, "
      "g^-1 g', and \"right\" has those in space, g' g^-1.",
      "\"left\"");
  Key<std::string> lagrangian =
      key("lagrangian", text.called("a formula"), needed,
          "The Lagrangian, a formula in the components of the velocity, the parameters and the components "
          "of the carried vectors; definitions may come first: \"m = w^2/2; m + v1^2\". It is smooth: "
          "there is no abs, min or comparison.",
          "\"(w^2 + v1^2 + 6*v2^2)/2\"");
  AnyKey parameters = key("parameters", "a table by names of one's own", LeftOut{"none"},
                          "Numbers by whose names the Lagrangian uses them; each is used.", "{ c = 6 }");
  AnyKey definitions = key(
      "definitions", "a table of formulas by names of one's own", LeftOut{"none"},
      "Formulas by whose names the Lagrangian, the force, the constraints and each other use them, in the "
      "names that these have; each is used.",
      "{ side = \"c*v2^2\" }");
  AnyKey advected =
      key("advected", "a table of vectors by names of one's own", LeftOut{"none"},
          "Vectors that the motion carries, each as long as the matrices of the group have rows: fixed in "
          "space on the left, a = g^-1 c, and fixed in the body on the right, a = g c. gravity = [0, 0, -1] "
          "has the components gravity1, gravity2, gravity3 in the Lagrangian and is a quantity of that name. "
          "On SE(2) and SE(3) a list of 2 or 3 numbers is a direction.",
          "{ gravity = [0, 0, -1] }");
} const reduced_keys{{"system"}};

struct ReducedStartKeys : KeyTable {
  Key<std::vector<double>> velocity =
      key("velocity", numbers("a list of as many numbers as the group has dimensions").in("1/time"), needed,
          "The velocity at the start, in the order of the components.", "[0.7, 1.0, 0.2]");
  AnyKey configuration =
      key("configuration", "a square matrix, an element of the group", LeftOut{"the identity"},
          "The configuration at the start, as a matrix.", "[[1, 0, 0], [0, 1, 0], [0, 0, 1]]");
} const reduced_start_keys{{"initial"}};

systems::MatrixAlgebra read_algebra(SceneTable const& system, ShapeVariables const& shape) {
  bool const named = reduced_keys.group.given(system);
  if (named == reduced_keys.algebra.given(system))
    throw SceneError(named ? system.place("algebra") : system.place(),
                     named ? "[system] has 'group' and 'algebra'; one of them says what the group is"
                           : "[system] needs 'group', for instance group = \"SE(2)\", or "
                             "'algebra', a basis of matrices");
  std::string const key = named ? "group" : "algebra";
  try {
    if (!named) return systems::spanned_algebra(system.matrices(key));
    std::string const group = reduced_keys.group.read(system);
    return shape.names.empty() ? systems::named_algebra(group) : shape.beside(group);
  } catch (SceneError const&) {
    throw;
  } catch (Error const& error) {
    system.fail(key, (named ? "" : "algebra: ") + std::string(error.what()));
  }
}

/// A vector as long as the matrices have rows; on a group of rigid motions one without its last component is
/// a direction, which the motion only turns.
Eigen::VectorXd padded(SceneTable const& table, std::string const& key,
                       systems::MatrixAlgebra const& algebra) {
  auto numbers = table.numbers(key);
  auto const rows = static_cast<std::size_t>(algebra.size);
  bool const motions = algebra.name == "SE(2)" || algebra.name == "SE(3)";
  if (motions && numbers.size() + 1 == rows) numbers.push_back(0);
  if (numbers.size() != rows)
    table.fail(
        key, fmt::format("{}: {}{} numbers are expected, as many as the matrices "
                         "of the group have rows, found {}",
                         key, rows,
                         motions ? fmt::format(" (a point has 1 last) or, of a direction, {}", rows - 1) : "",
                         numbers.size()));
  return Eigen::Map<Eigen::VectorXd const>(numbers.data(), algebra.size);
}

std::vector<CarriedVector> read_carried(SceneTable const& system, systems::MatrixAlgebra const& algebra) {
  std::vector<CarriedVector> out;
  if (!system.has("advected")) return out;
  SceneTable const table = system.inside("advected");
  std::vector<std::string> taken{
      "velocity",       "body_momentum", "spatial_momentum", "energy",      "configuration",
      "casimir",        "order",         "tangent_map",      "leaf_defect", "symplectic_defect",
      "poisson_defect", "reaction",      "constraint",       "contact",     "force",
      "work",           "impulse",       "momentum_balance", "shape"};
  for (auto const& key : table.keys()) {
    for (auto const& other : taken)
      if (other == key) table.fail(key, fmt::format("the name '{}' is taken already: it is a quantity", key));
    require_formula_name(table, key, algebra.components, "a component");
    for (int i = 1; i <= algebra.size; ++i)
      if (std::ranges::find(algebra.components, key + std::to_string(i)) != algebra.components.end())
        table.fail(key, fmt::format("the name '{}' is taken already: {}{} is a component of the velocity",
                                    key, key, i));
    out.push_back({key, padded(table, key, algebra), {}, 0});
  }
  if (out.size() * static_cast<std::size_t>(algebra.size) > 128)
    reduced_keys.advected.fail(system, fmt::format("at most 128 components together are expected, found {}",
                                                   out.size() * static_cast<std::size_t>(algebra.size)));
  return out;
}

/// The names of the components of a carried vector.
std::vector<std::string> components_of(CarriedVector const& vector, systems::MatrixAlgebra const& algebra) {
  if (!vector.components.empty()) return vector.components;
  std::vector<std::string> out;
  for (int i = 1; i <= algebra.size; ++i) out.push_back(vector.name + std::to_string(i));
  return out;
}

/// Refuses a parameter, a definition, or a carried vector, that neither the Lagrangian nor the force uses; a
/// vector may be asked for.
void require_used(SceneFile const& file, SharedNames const& shared, std::vector<CarriedVector> const& carried,
                  systems::MatrixAlgebra const& algebra) {
  SceneTable const system = file.section("system");
  std::string formulas = "lagrangian";
  if (force_keys.force.given(system) || force_keys.force_in_space.given(system)) formulas += " or the force";
  if (system.has("constraints")) formulas += " or the constraints";
  shared.require_used(formulas);
  auto const& used = shared.used();
  auto const asked = file.section("output").texts("quantities");
  for (auto const& vector : carried) {
    for (std::size_t k = 0; k < vector.shown; ++k)
      if (!used.contains(vector.components[k]) && std::ranges::find(asked, vector.name) == asked.end())
        system.inside("shape").fail(
            vector.components[k],
            fmt::format("shape: '{0}' does not occur in the {1}, and output.quantities has no shape{2}",
                        vector.components[k], formulas, meant_used_name(vector.components[k], used)));
    if (vector.shown > 0) continue;
    bool const occurs = std::ranges::any_of(components_of(vector, algebra),
                                            [&used](auto const& one) { return used.contains(one); });
    if (!occurs && std::ranges::find(asked, vector.name) == asked.end())
      system.inside("advected")
          .fail(vector.name,
                fmt::format("advected: {0}1 to {0}{1} do not occur in the {3}, and "
                            "output.quantities has no {0}{2}",
                            vector.name, algebra.size, meant_used_name(vector.name + "1", used), formulas));
  }
}

/// What a scene gives by formulas.
struct Formulas {
  Tape lagrangian;
  std::optional<systems::GeneralizedForce> force;
  std::vector<Tape> constraints, contact;
};
Formulas read_formulas(SceneFile const& file, systems::MatrixAlgebra const& algebra,
                       std::vector<CarriedVector> const& carried) {
  SceneTable const system = file.section("system");
  std::vector<std::string> names = algebra.components, vectors;
  for (auto const& vector : carried)
    for (auto& name : components_of(vector, algebra)) vectors.push_back(std::move(name));
  names.insert(names.end(), vectors.begin(), vectors.end());
  SharedNames shared(system, names, names_of_force(algebra));
  auto l = shared.read(reduced_keys.lagrangian.read(system), names, system.text_place("lagrangian")).value;
  auto force = read_force(file, algebra, vectors, shared);
  auto constraints = read_constraints(system, names, shared);
  auto contact = read_contact(system, algebra, vectors, shared);
  require_used(file, shared, carried, algebra);
  return {std::move(l), std::move(force), std::move(constraints), std::move(contact)};
}

Eigen::MatrixXd read_configuration(SceneTable& initial, systems::MatrixAlgebra const& algebra,
                                   std::vector<std::string>& remarks) {
  if (!initial.has("configuration"))
    initial.set("configuration", Eigen::MatrixXd(Eigen::MatrixXd::Identity(algebra.size, algebra.size)));
  Eigen::MatrixXd const g = initial.matrix("configuration", algebra.size);
  double distance = 0;
  if (!systems::is_element(algebra, g, distance))
    reduced_start_keys.configuration.fail(
        initial,
        std::isfinite(distance)
            ? fmt::format("an element of the group is expected; this matrix is {:.3g} away "
                          "from it, and at most 1e-9 is allowed",
                          distance)
            : "an element of the group is expected; this matrix is so far from it that no distance can "
              "be told");
  if (double const rounding = 1e-14 * static_cast<double>(algebra.size) * g.norm(); distance > rounding)
    remarks.push_back(
        fmt::format("configuration: it is taken as it is, {:.2g} away from the group", distance));
  return g;
}

/// `0.71 v1 - 0.71 v2`
std::string combination(Eigen::VectorXd const& direction, std::vector<std::string> const& names) {
  std::string out;
  double const largest = direction.cwiseAbs().maxCoeff();
  for (Eigen::Index i = 0; i < direction.size(); ++i) {
    double const x = direction[i];
    if (!(std::abs(x) > 1e-9 * largest)) continue;
    std::string const name = names[static_cast<std::size_t>(i)];
    out += out.empty() ? (x < 0 ? "-" : "") : (x < 0 ? " - " : " + ");
    out += std::abs(x) == 1 ? name : fmt::format("{:.3g} {}", std::abs(x), name);
  }
  return out;
}

void require_regular(SceneTable const& system, ReducedScene const& scene) {
  systems::LegendreVelocity legendre(*scene.system);
  Eigen::MatrixXd const hessian = legendre.hessian(scene.velocity, scene.start.vectors);
  // Far below them, a quotient of one by them is beyond the numbers.
  constexpr double smallest = 1e-280;
  if (double const largest = hessian.cwiseAbs().maxCoeff(); largest > 0 && largest < smallest)
    reduced_keys.lagrangian.fail(
        system, fmt::format("its second derivatives at the start are {:.3g} at most, and at "
                            "least {:.3g} is needed; a Lagrangian times a number has the same motion",
                            largest, smallest));
  systems::LeastRegular const least(hessian);
  if (least.smallest > 1e-12 * least.largest) return;
  reduced_keys.lagrangian.fail(
      system, fmt::format("it is not regular at the start: along {} its second derivative is {:.3g}, "
                          "where the largest is {:.3g}, so that the momentum does not determine the velocity",
                          combination(least.direction, scene.system->algebra.components), least.smallest,
                          least.largest));
}

systems::Chart read_chart(SceneTable const& method, systems::MatrixAlgebra const& algebra) {
  if (!method.is_text("name") || method.text("name") != "cayley_chart") return systems::Chart::exponential;
  if (!systems::SpanOfMatrices(algebra).cayley_stays())
    method.fail("name",
                "cayley_chart: Cayley's transform does not map the algebra into this group, as it does for "
                "SO(n), SE(2), SE(3), U(n), Sp(2n) and GL(n); natural_chart serves every group");
  return systems::Chart::cayley;
}

}  // namespace

std::vector<Parameter> reduced_parameters() {
  return records_of({reduced_keys, shape_keys, force_keys, dissipation_keys, constraint_keys(),
                     reduced_start_keys, constrained_start_keys()});
}

std::vector<std::string> carried_names(SceneFile const& file) {
  SceneTable const system = file.section("system");
  return system.has("advected") && system.is_table("advected") ? system.inside("advected").keys()
                                                               : std::vector<std::string>{};
}

ReducedScene read_reduced_scene(SceneFile const& file, std::vector<std::string>& remarks) {
  SceneTable system = file.section("system"), initial = file.section("initial");
  ShapeVariables const shape = read_shape(system);
  systems::MatrixAlgebra algebra = read_algebra(system, shape);
  systems::Side const side =
      reduced_keys.side.read(system) == "left" ? systems::Side::left : systems::Side::right;
  ReducedScene scene;
  scene.carried = read_carried(system, algebra);
  if (!shape.names.empty())
    scene.carried.push_back(
        {"shape", shape.carried(algebra, side), shape.components(algebra), shape.names.size()});
  auto [l, force, constraints, contact] = read_formulas(file, algebra, scene.carried);
  scene.velocity = reduced_start_keys.velocity.read(initial, Patterns::numbers("", algebra.dimension));
  scene.configuration = read_configuration(initial, algebra, remarks);
  require_force_in_space(system, side);
  Eigen::MatrixXd mover = scene.configuration;
  if (side == systems::Side::left) mover = inverse_matrix(scene.configuration, "configuration");
  for (auto const& vector : scene.carried) {
    Eigen::VectorXd const a = mover * vector.constant;
    scene.start.vectors.insert(scene.start.vectors.end(), a.data(), a.data() + a.size());
  }
  if (force && force->across)
    scene.start.frame = systems::frame_at(algebra, side, scene.configuration,
                                          inverse_matrix(scene.configuration, "configuration"));
  systems::Chart const chart = read_chart(file.section("method"), algebra);
  auto const built = std::make_shared<systems::ReducedSystem>(
      std::move(algebra), side, static_cast<int>(scene.carried.size()), std::move(l), chart);
  built->force = std::move(force);
  built->dissipation = read_dissipation(file, *built, remarks);
  scene.system = built, scene.contact = std::move(contact);
  try {
    scene.start.momentum =
        systems::LegendreVelocity(*scene.system).momentum(scene.velocity, scene.start.vectors);
  } catch (NotFinite const&) {
    reduced_keys.lagrangian.fail(system,
                                 "at the start its value or one of its derivatives is no finite number");
  }
  require_regular(system, scene);
  require_force(system, scene);
  if (!constraints.empty()) constrain(file, constraints, scene, remarks);
  return scene;
}

}  // namespace actio::scene
