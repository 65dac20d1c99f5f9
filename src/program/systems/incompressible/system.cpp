#include "program/systems/incompressible/system.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "program/base/memory.hpp"
#include "program/base/ranks.hpp"
#include "program/medium_output/snapshots.hpp"
#include "program/registry/common_keys.hpp"
#include "program/systems/incompressible/keys.hpp"
#include "program/systems/incompressible/quantities.hpp"
#include "program/systems/media/conservation.hpp"
#include "program/systems/media/examination.hpp"
#include "program/systems/media/generic_medium.hpp"
#include "program/systems/media/memory.hpp"
#include "program/systems/method_input.hpp"

namespace actio::scene {
namespace {

/// The memory that it takes, refused before anything of that size is touched: a medium on a mesh, and what
/// pressures are found by, measured for each.
double checked_memory(SceneFile const& file, MediumMesh const& mesh, Request const& request) {
  double const cells = mesh.cell_count();
  bool const in_space = mesh.dimension == 3,
             cycles = !in_space && mesh.shape == "box" && cells >= 1000 &&
                      incompressible_method_keys.solver.find(file).value_or("multigrid") == "multigrid";
  double const solver = in_space ? 2000 : cycles ? 620 : 400 + 56 * std::log2(std::max(2.0, cells));
  double const needed = bytes_for_medium(mesh, false, request) + cells * solver;
  require_memory(needed, medium_keys.mesh.table(file).place("cells"),
                 fmt::format("cells: {:.0f} cells", cells), [&](double there) {
                   return fmt::format("about {:.0f} would do", std::floor(0.9 * cells * there / needed));
                 });
  return needed;
}

/// Gravity as an acceleration. It leaves the loads, since it acts on cells.
/// @throws SceneError  where it is not uniform
template <int d>
std::array<double, d> taken_gravity(SceneFile const& file, MediumLoads<d>& loads,
                                    std::vector<std::array<double, d>> const& x) {
  std::array<double, d> out{};
  if (!loads.gravity) return out;
  auto const potential = loads.loads.potentials.front();
  auto const first = potential.gradient(x.front());
  double steepest = 0, change = 0;
  for (auto const& place : x) {
    auto const slope = potential.gradient(place);
    for (std::size_t a = 0; a < d; ++a) {
      steepest = std::max(steepest, std::abs(slope[a])),
      change = std::max(change, std::abs(slope[a] - first[a]));
    }
  }
  if (!(change <= 1e-9 * steepest))
    medium_keys.load.table(file).fail(
        "gravity", fmt::format("gravity: the potential of an incompressible medium is linear in x, y, z; its "
                               "gradient changes by {:.3g} of it within the body, bound 1e-9",
                               change / steepest));
  for (std::size_t a = 0; a < d; ++a) out[a] = -first[a];
  loads.loads.potentials.erase(loads.loads.potentials.begin());
  return out;
}

/// Whether ranks can share a body: a box.
bool is_shared(media::BodyMesh const& body) { return body.grid[0] > 0; }

/// The medium, or what is wrong with it at its key.
template <int d>
std::unique_ptr<media::IncompressibleMedium<d>> made(SceneFile const& file, MediumMesh const& mesh,
                                                     std::shared_ptr<media::StoredEnergy<d> const> law,
                                                     media::IncompressibleStart<d> const& start,
                                                     MediumLoads<d> const& loads) {
  auto solving = read_volume_solving(file);
  auto body = mesh.make();
  if (on_several_ranks() && is_shared(body)) {
    solving.ranks = shared_ranks(), solving.told = file.written();
    int const last = mesh.dimension - 1, rows = body.grid[static_cast<std::size_t>(last)],
              most = rows / media::MeshShare::fewest;
    if (most < shared_ranks()->size())
      medium_keys.mesh.table(file).fail(
          "cells",
          fmt::format("cells: {} {} of cells are shared among {} ranks, and each has {} at least; at "
                      "most {} ranks are of use",
                      rows, last == 1 ? "rows" : "planes", shared_ranks()->size(), media::MeshShare::fewest,
                      std::max(1, most)));
  }
  if (auto const by = incompressible_method_keys.solver.find(file)) {
    solving.by = *by == "multigrid" ? media::PressureBy::multigrid : media::PressureBy::factors;
    bool const suits = *by == "multigrid" ? media::MultigridPressure::suits(body) : d == 2;
    if (!suits)
      incompressible_method_keys.solver.fail(
          file, *by == "multigrid"
                    ? "multigrid is for boxes in the plane, with two cells at least along each "
                      "direction and a multiple of four along a periodic one"
                    : "factors fill up in space: it is left out there");
  }
  try {
    return std::make_unique<media::IncompressibleMedium<d>>(std::move(body), std::move(law), start, 1.0,
                                                            loads.sides, loads.loads, solving);
  } catch (media::StartChangesVolumes const& error) {
    auto const initial = file.section("initial");
    initial.fail(error.placement ? "placement" : "velocity", error.what());
  } catch (media::VolumesNotIndependent const& error) {
    file.section("system").fail("mesh", error.what());
  } catch (media::BentSide const& error) {
    medium_keys.boundary.table(file).fail(error.side, std::string("boundary: ") + error.what());
  } catch (media::NotADensity const& error) {
    medium_keys.density.in(file).fail("density", error.what());
  } catch (media::NotABodyMesh const& error) {
    file.section("system").fail("mesh", error.what());
  }
}

template <int d>
void prepare(Simulation& simulation, Request const& request, MediumMesh const& mesh,
             std::shared_ptr<media::StoredEnergy<d> const> law, Material const& material,
             std::shared_ptr<MediumStart> const& start) {
  SceneFile const& file = request.file;
  auto loads = read_medium_loads<d>(file, mesh);
  auto features = features_of<d>(file, mesh, loads, material, start->uniform);
  media::IncompressibleStart<d> begin{start_of<d>(start)};
  begin.project = incompressible_start_keys.project.read(file);
  double fastest = 0, loading = 0;
  {
    auto const body = mesh.make();
    MeshCells<d> const cells(body);
    auto const examined = examined_start<d>(file, *start, cells, mesh);
    for (auto& told : examined_loads<d>(file, mesh, body, loads, examined, request.schedule.until()))
      simulation.remarks.push_back(std::move(told));
    if (!driven_sides<d>(mesh, cells, examined).empty()) features.insert(Feature::driven_side);
    begin.gravity = taken_gravity<d>(file, loads, examined.places);
    for (auto const& v : examined.velocities) {
      double square = 0;
      for (double const one : v) square += one * one;
      fastest = std::max(fastest, std::sqrt(square));
    }
    // Steps follow loads: a wave as fast as they change turns by a quarter of a radian in one.
    loading =
        0.8 / 0.25 * frequency_of(loads.in_time, body.nodes, request.schedule.until(), simulation.remarks);
  }
  auto motion = std::make_unique<IncompressibleSteps<media::IncompressibleMedium<d>>>(
      made<d>(file, mesh, law, begin, loads));
  auto& medium = motion->medium();
  simulation.on_ranks = is_shared(medium.mesh());
  simulation.whole_bytes = simulation.bytes - bytes_of_program;
  double const stiffest = medium.largest_frequency(), edge = medium.shortest_edge();
  // Four tenths of the longest stable step, or a tenth of an edge: turns of 0.8 radians.
  simulation.step = read_step(file.section("method"), request.schedule,
                              std::max({stiffest, 8 * fastest / edge, loading}), 0.8);
  if (!(simulation.step * stiffest <= 2))
    throw NumericsError(fmt::format("{}: step: steps of length {} are not stable; a step of {:.6g} would do",
                                    file.section("method").place("step").text(), simulation.step,
                                    1.9 / stiffest));
  medium.change_step(0, simulation.step, 0);
  if (medium.projected() > 1e-6 * fastest)
    simulation.remarks.push_back(fmt::format(
        "initial.project: the velocity of a node was changed by up to {:.3g}", medium.projected()));
  MediumView<d> const view{motion.get(), law ? law : media::no_stored_energy<d>(), begin.density};
  require_finite_energies(file, motion->energies());
  bool const circulates = std::ranges::find(request.quantities, "circulation") != request.quantities.end();
  require_used_loops(file, circulates);
  std::vector<MaterialLoop<d>> loops;
  if (circulates) loops = read_loops<d>(file, motion->cells(), mesh);
  simulation.quantities.conserve([&](std::string const& name) {
    return is_conserved(file.section("system").text("kind"), name, features);
  });
  define_incompressible(simulation.quantities, view, *motion, loops);
  simulation.quantities.ask(request.quantities);
  simulation.snapshots = write_medium(request, view);
  simulation.steps_at_once = 1;
  simulation.companion = {nullptr, 0, 0, false,
                          "not estimated: a run with half the step and twice the "
                          "cells along each direction shows it"};
  simulation.motion = std::move(motion);
}

/// What another rank has of the medium of a scene.
template <int d>
std::unique_ptr<RankPart> part_in(SceneFile const& file, MediumMesh const& mesh,
                                  std::shared_ptr<media::StoredEnergy<d> const> law) {
  auto const start = std::make_shared<MediumStart>(read_medium_start(file, d));
  auto loads = read_medium_loads<d>(file, mesh);
  media::IncompressibleStart<d> begin{start_of<d>(start)};
  begin.project = incompressible_start_keys.project.read(file);
  auto const body = mesh.make();
  begin.gravity =
      taken_gravity<d>(file, loads, examined_start<d>(file, *start, MeshCells<d>(body), mesh).places);
  return std::make_unique<LikePart<media::IncompressibleMedium<d>>>(made<d>(file, mesh, law, begin, loads));
}

template <bool fluid>
std::unique_ptr<RankPart> part_of_incompressible(SceneFile const& file, double) {
  MediumMesh const mesh = read_medium_mesh(file);
  auto const in = [&]<int d>() {
    std::shared_ptr<media::StoredEnergy<d> const> law;
    if (!fluid) law = stored_energy_of<d>(read_material(file.section("system"), false, d));
    return part_in<d>(file, mesh, law);
  };
  return mesh.dimension == 2 ? in.template operator()<2>() : in.template operator()<3>();
}

/// The quantities of a scene: a circulation for each of its loops.
std::vector<Quantity> quantities_of(bool fluid, SceneFile const& file) {
  auto all = incompressible_quantities(fluid);
  if (!loop_names(file).empty())
    std::ranges::find(all, "circulation", &Quantity::name)->kind = Quantity::Kind::list;
  return all;
}

template <bool fluid>
Simulation prepare_incompressible(Request const& request) {
  read_method(request.file.section("method"), incompressible_methods());
  MediumMesh const mesh = read_medium_mesh(request.file);
  if (mesh.dimension == 1)
    medium_keys.mesh.table(request.file)
        .fail("lower",
              "lower: an incompressible medium has two or three dimensions; on a line nothing moves");
  Material material;
  if (!fluid) material = read_material(request.file.section("system"), false, mesh.dimension);
  auto const start = std::make_shared<MediumStart>(read_medium_start(request.file, mesh.dimension));
  Simulation simulation(quantities_of(fluid, request.file));
  simulation.bytes = checked_memory(request.file, mesh, request);
  auto const prepare_in = [&]<int d>() {
    std::shared_ptr<media::StoredEnergy<d> const> law;
    if (!fluid) law = stored_energy_of<d>(material);
    prepare<d>(simulation, request, mesh, law, material, start);
  };
  if (mesh.dimension == 2)
    prepare_in.template operator()<2>();
  else
    prepare_in.template operator()<3>();
  return simulation;
}

}  // namespace

std::vector<Method> incompressible_methods() {
  return {
      {"multisymplectic",
       {"2"},
       "The discrete Hamilton principle on space-time with a multiplier in each cell: explicit but for the "
       "pressures, which are solved for. It keeps the volume of each cell, linear and angular momentum to "
       "rounding; the energy oscillates with the square of the step.",
       "claim_10_0_variational_discretisation"}};
}

System incompressible_system(bool fluid, std::string name, std::string title, std::string meaning,
                             std::string example) {
  return {std::move(name),
          std::move(title),
          std::move(meaning),
          "chapter 8",
          records_of({IncompressibleKeys(fluid), medium_start_keys, incompressible_start_keys,
                      incompressible_method_keys}),
          incompressible_methods(),
          incompressible_quantities(fluid),
          fluid ? &prepare_incompressible<true> : &prepare_incompressible<false>,
          std::move(example),
          nullptr,
          {},
          nullptr,
          medium_snapshots(fluid, true),
          {},
          nullptr,
          nullptr,
          fluid ? &part_of_incompressible<true> : &part_of_incompressible<false>};
}

}  // namespace actio::scene
