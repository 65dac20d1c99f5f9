#include <Eigen/Core>

#include "program/systems/lagrangians/input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "actio/any_group/least_regular.hpp"
#include "actio/any_group/membership.hpp"
#include "actio/any_group/named_algebra.hpp"
#include "actio/any_group/span_of_matrices.hpp"
#include "program/systems/formula.hpp"

namespace actio::scene {
namespace {

systems::MatrixAlgebra read_algebra(SceneTable const& system) {
  bool const named = system.has("group");
  if (named == system.has("algebra"))
    throw SceneError(named ? system.place("algebra") : system.place(),
                     named ? "[system] has 'group' and 'algebra'; one of them says what the group is"
                           : "[system] needs 'group', for instance group = \"SE(2)\", or "
                             "'algebra', a basis of matrices");
  std::string const key = named ? "group" : "algebra";
  try {
    return named ? systems::named_algebra(system.text(key)) : systems::spanned_algebra(system.matrices(key));
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
      "velocity",      "body_momentum", "spatial_momentum", "energy",      "configuration",
      "casimir",       "order",         "tangent_map",      "leaf_defect", "symplectic_defect",
      "poisson_defect"};
  for (auto const& key : table.keys()) {
    for (auto const& other : taken)
      if (other == key) table.fail(key, fmt::format("the name '{}' is taken already: it is a quantity", key));
    require_formula_name(table, key, algebra.components, "a component");
    for (int i = 1; i <= algebra.size; ++i)
      if (std::ranges::find(algebra.components, key + std::to_string(i)) != algebra.components.end())
        table.fail(key, fmt::format("the name '{}' is taken already: {}{} is a component of the velocity",
                                    key, key, i));
    out.push_back({key, padded(table, key, algebra)});
  }
  if (out.size() * static_cast<std::size_t>(algebra.size) > 128)
    system.fail("advected", fmt::format("advected: at most 128 components together are expected, found {}",
                                        out.size() * static_cast<std::size_t>(algebra.size)));
  return out;
}

/// The names of the components of a carried vector.
std::vector<std::string> components_of(CarriedVector const& vector, systems::MatrixAlgebra const& algebra) {
  std::vector<std::string> out;
  for (int i = 1; i <= algebra.size; ++i) out.push_back(vector.name + std::to_string(i));
  return out;
}

/// Refuses a parameter, or a carried vector, that the Lagrangian does not use; a vector may be asked for.
void require_used(SceneFile const& file, std::map<std::string, double> const& parameters,
                  std::vector<CarriedVector> const& carried, systems::MatrixAlgebra const& algebra,
                  std::set<std::string, std::less<>> const& used) {
  SceneTable const system = file.section("system");
  require_used_constants(system, "parameters", parameters, used, "lagrangian");
  auto const asked = file.section("output").texts("quantities");
  for (auto const& vector : carried) {
    bool const occurs = std::ranges::any_of(components_of(vector, algebra),
                                            [&used](auto const& one) { return used.contains(one); });
    if (!occurs && std::ranges::find(asked, vector.name) == asked.end())
      system.inside("advected")
          .fail(vector.name,
                fmt::format("advected: {0}1 to {0}{1} do not occur in the lagrangian, and "
                            "output.quantities has no {0}{2}",
                            vector.name, algebra.size, meant_used_name(vector.name + "1", used)));
  }
}

Tape read_lagrangian(SceneFile const& file, systems::MatrixAlgebra const& algebra,
                     std::vector<CarriedVector> const& carried) {
  SceneTable const system = file.section("system");
  std::vector<std::string> names = algebra.components;
  for (auto const& vector : carried)
    for (auto& name : components_of(vector, algebra)) names.push_back(std::move(name));
  auto const parameters = formula_constants(system, "parameters", names, "a component");
  auto formula = scene_formula(system.text("lagrangian"), names, parameters, system.text_place("lagrangian"));
  require_used(file, parameters, carried, algebra, formula.used);
  return std::move(formula.value);
}

Eigen::MatrixXd read_configuration(SceneTable& initial, systems::MatrixAlgebra const& algebra,
                                   std::vector<std::string>& remarks) {
  if (!initial.has("configuration"))
    initial.set("configuration", Eigen::MatrixXd(Eigen::MatrixXd::Identity(algebra.size, algebra.size)));
  Eigen::MatrixXd const g = initial.matrix("configuration", algebra.size);
  double distance = 0;
  if (!systems::is_element(algebra, g, distance))
    initial.fail(
        "configuration",
        std::isfinite(distance)
            ? fmt::format("configuration: an element of the group is expected; this matrix is {:.3g} away "
                          "from it, and at most 1e-9 is allowed",
                          distance)
            : "configuration: an element of the group is expected; this matrix is so far from "
              "it that no distance can be told");
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
    system.fail("lagrangian",
                fmt::format("lagrangian: its second derivatives at the start are {:.3g} at most, and at "
                            "least {:.3g} is needed; a Lagrangian times a number has the same motion",
                            largest, smallest));
  systems::LeastRegular const least(hessian);
  if (least.smallest > 1e-12 * least.largest) return;
  system.fail(
      "lagrangian",
      fmt::format("lagrangian: it is not regular at the start: along {} its second derivative is {:.3g}, "
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

std::vector<std::string> carried_names(SceneFile const& file) {
  SceneTable const system = file.section("system");
  return system.has("advected") && system.is_table("advected") ? system.inside("advected").keys()
                                                               : std::vector<std::string>{};
}

ReducedScene read_reduced_scene(SceneFile const& file, std::vector<std::string>& remarks) {
  SceneTable system = file.section("system"), initial = file.section("initial");
  systems::MatrixAlgebra algebra = read_algebra(system);
  if (!system.has("side")) system.set("side", "left");
  systems::Side const side =
      system.choice("side", "side", {"left", "right"}) == "left" ? systems::Side::left : systems::Side::right;
  ReducedScene scene;
  scene.carried = read_carried(system, algebra);
  Tape l = read_lagrangian(file, algebra, scene.carried);
  scene.velocity = initial.numbers("velocity", algebra.dimension);
  scene.configuration = read_configuration(initial, algebra, remarks);
  Eigen::MatrixXd mover = scene.configuration;
  if (side == systems::Side::left) mover = inverse_matrix(scene.configuration, "configuration");
  for (auto const& vector : scene.carried) {
    Eigen::VectorXd const a = mover * vector.constant;
    scene.start.vectors.insert(scene.start.vectors.end(), a.data(), a.data() + a.size());
  }
  systems::Chart const chart = read_chart(file.section("method"), algebra);
  scene.system = std::make_shared<systems::ReducedSystem const>(
      std::move(algebra), side, static_cast<int>(scene.carried.size()), std::move(l), chart);
  try {
    scene.start.momentum =
        systems::LegendreVelocity(*scene.system).momentum(scene.velocity, scene.start.vectors);
  } catch (NotFinite const&) {
    system.fail("lagrangian",
                "lagrangian: at the start its value or one of its derivatives is no finite number");
  }
  require_regular(system, scene);
  return scene;
}

}  // namespace actio::scene
