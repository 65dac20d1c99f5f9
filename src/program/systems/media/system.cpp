#include "program/systems/media/system.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "program/base/memory.hpp"
#include "program/base/ranks.hpp"
#include "program/medium_output/snapshots.hpp"
#include "program/systems/media/conservation.hpp"
#include "program/systems/media/crossing.hpp"
#include "program/systems/media/examination.hpp"
#include "program/systems/media/generic_medium.hpp"
#include "program/systems/media/memory.hpp"
#include "program/systems/media/method.hpp"
#include "program/systems/media/optimised_medium.hpp"
#include "program/systems/media/quantities.hpp"

namespace actio::scene {
namespace {

/// The memory that it takes, refused before anything of that size is touched.
double checked_memory(SceneFile const& file, MediumMesh const& mesh, bool fast, Request const& request) {
  double const cells = mesh.cell_count(), needed = bytes_for_medium(mesh, fast, request);
  require_memory(needed, medium_keys.mesh.table(file).place("cells"),
                 fmt::format("cells: {:.0f} cells", cells), [&](double there) {
                   return fmt::format("about {:.0f} would do", std::floor(0.9 * cells * there / needed));
                 });
  return needed;
}

/// What acts on a medium, and what of that ends the conservation of something.
template <int d>
struct Acting {
  MediumLoads<d> const& loads;
  std::set<Feature> features;
};

template <int d>
void finish(Simulation& simulation, Request const& request, std::unique_ptr<MediumMotion<d>> motion,
            MediumView<d> view, MediumMesh const& mesh, double cells, Acting<d> acting) {
  view.motion = motion.get();
  require_finite_energies(request.file, motion->energies());
  bool const circulates = std::ranges::find(request.quantities, "circulation") != request.quantities.end();
  require_used_loops(request.file, circulates);
  std::vector<MaterialLoop<d>> loops;
  if (circulates) {
    loops = read_loops<d>(request.file, motion->cells(), mesh);
    acting.features.merge(features_of_loops<d>(mesh, motion->cells(), acting.loads, loops, motion->places()));
  }
  simulation.quantities.conserve([&](std::string const& name) {
    return is_conserved(request.file.section("system").text("kind"), name, acting.features);
  });
  define_medium(simulation.quantities, view, loops, simulation.step);
  simulation.quantities.ask(request.quantities);
  simulation.snapshots = write_medium(request, view);
  simulation.steps_at_once = std::max(1L, static_cast<long>(5e-3 / (cells * 1e-8)));
  simulation.companion = {nullptr, 0, 0, false,
                          "not estimated: a run with half the step and twice the "
                          "cells along each direction shows it"};
  simulation.motion = std::move(motion);
}

/// The density at a point of the body.
template <int d>
std::function<double(std::array<double, d> const&)> density_of(std::shared_ptr<MediumStart> const& start) {
  return [start](std::array<double, d> const& X) {
    double rho = 0;
    start->density(X, &rho);
    return rho;
  };
}

/// When characteristics cross, of a plane wave, where that is before the end.
template <int d>
void tell_crossing(Simulation& simulation, Request const& request, MediumMesh const& mesh,
                   Material const& material, MediumStart const& start) {
  auto const crossing = crossing_of_characteristics<d>(mesh, start, *stored_energy_of<d>(material));
  if (!crossing || crossing->time > request.schedule.until()) return;
  bool const spread = request.file.section("method").has("viscosity");
  simulation.remarks.push_back(
      fmt::format("characteristics {} t = {:.6g}{}: a shock {}, which {}",
                  crossing->exact ? "cross at" : "may cross from", crossing->time,
                  crossing->exact ? "" : " on", crossing->exact || spread ? "follows" : "would follow",
                  spread ? "method.viscosity spreads over a few cells"
                         : "this scheme does not resolve (method.viscosity spreads one over a few cells)"));
}

/// Sides that are held to a velocity, which do work.
template <int d>
void tell_driven_sides(Simulation& simulation, std::set<Feature>& features, MediumMesh const& mesh,
                       MediumCells<d> const& cells, ExaminedStart<d> const& start) {
  for (auto const& [side, speed] : driven_sides<d>(mesh, cells, start)) {
    features.insert(Feature::driven_side);
    simulation.remarks.push_back(
        mesh.sides.at(side) == media::Side::fixed
            ? fmt::format("side {} is fixed to the velocity that it has at the start, up to {:.6g}", side,
                          speed)
            : fmt::format("side {} slides, and keeps the velocity across it that it has at the start, {:.6g}",
                          side, speed));
  }
}

/// The medium of fused steps on a box; null where there are none for it.
template <class Box>
std::unique_ptr<OptimisedMedium<Box::dimension>> optimised_of(MediumMesh const& mesh,
                                                              Material const& material,
                                                              MediumStart const& start) {
  auto const box = fast_box<Box>(mesh);
  if (!box) return nullptr;
  double rho = 0;
  start.density(std::array<double, Box::dimension>{}, &rho);
  return optimised_medium(material, *box, rho);
}

/// That each rank has two rows, or planes, at least.
template <class Box>
void require_rows(SceneFile const& file, Box const& box) {
  constexpr int last = Box::dimension - 1;
  if (on_several_ranks() && shared_ranks()->size() > box.nodes(last) / 2)
    medium_keys.mesh.table(file).fail(
        "cells",
        fmt::format("cells: {} {} of nodes are shared among {} ranks, and each has two at least; at most "
                    "{} ranks are of use",
                    box.nodes(last), last == 1 ? "rows" : "planes", shared_ranks()->size(),
                    box.nodes(last) / 2));
}

/// Whether a scene asks for nothing but what fused steps have.
bool has_plain_steps(SceneFile const& file, MediumMethod const& method, MediumStart const& start) {
  return method.plain() && start.uniform && !has_loads(file);
}

/// By fused steps, where the scene is one for them.
/// @return whether it is
template <class Box>
bool prepare_fast(Simulation& simulation, Request const& request, MediumMesh const& mesh,
                  Material const& material, std::shared_ptr<MediumStart> const& start) {
  constexpr int d = Box::dimension;
  auto const optimised = optimised_of<Box>(mesh, material, *start);
  if (!optimised) return false;
  simulation.on_ranks = true, simulation.shared_bytes = bytes_of_fused_steps(mesh);
  simulation.shared_rows = fast_box<Box>(mesh)->nodes(d - 1);
  simulation.bytes = checked_memory(request.file, mesh, true, request);
  keep_large_lists_apart();
  BoxCells<Box> const cells(*fast_box<Box>(mesh));
  require_rows<Box>(request.file, *fast_box<Box>(mesh));
  // Places of the start are let go of before there is a motion.
  auto begin = examined_start<d>(request.file, *start, cells, mesh);
  MediumLoads<d> const loads = read_medium_loads<d>(request.file, mesh);
  auto features = features_of<d>(request.file, mesh, loads, material, start->uniform);
  tell_driven_sides<d>(simulation, features, mesh, cells, begin);
  begin.velocities = {};
  double const longest = optimised->longest_step(begin.places);
  begin.places = {};
  require_reachable_end(request.file, longest, request.schedule.until());
  simulation.step = medium_step(request, longest, 0, simulation.remarks);
  tell_crossing<d>(simulation, request, mesh, material, *start);
  simulation.shortcuts.emplace_back(
      fmt::format("a box of equal cells of one density in {} without loads: fused steps",
                  d == 2 ? "the plane" : "space"));
  finish<d>(simulation, request, optimised->motion(simulation.step, longest, start, request.file.written()),
            {nullptr, stored_energy_of<d>(material), density_of<d>(start)}, mesh,
            (d == 2 ? 1 : 5) * mesh.cell_count(), {loads, std::move(features)});
  // A pass over the nodes makes several steps, and an examination follows each piece: of sixteen steps, but
  // of a second at most.
  double const second = 1e8 / ((d == 2 ? 1 : 5) * mesh.cell_count());
  simulation.steps_at_once = std::max(simulation.steps_at_once, std::min(16L, static_cast<long>(second)));
  return true;
}

/// Where and how strongly gravity pulls, since a potential tells it by its slope alone.
template <int d>
void tell_gravity(Simulation& simulation, MediumLoads<d> const& loads,
                  std::vector<std::array<double, d>> const& x) {
  std::array<double, d> centre{};
  double steepest = 0;
  for (auto const& place : x) {
    steepest = std::max(steepest, loads.slope_of_gravity(place));
    for (std::size_t a = 0; a < d; ++a) centre[a] += place[a] / static_cast<double>(x.size());
  }
  std::string told = loads.pull_of_gravity(centre, steepest);
  if (!told.empty()) simulation.remarks.push_back(std::move(told));
}

/// What is wrong with a side or with the mass of a cell is told at its key.
template <int d>
std::unique_ptr<MotionOnMesh<d>> motion_of(SceneFile const& file, GenericMedium<d>& generic) {
  try {
    return generic.motion();
  } catch (media::BentSide const& error) {
    medium_keys.boundary.table(file).fail(error.side, std::string("boundary: ") + error.what());
  } catch (media::NotADensity const& error) {
    medium_keys.density.in(file).fail("density", error.what());
  }
}

template <int d>
GenericMedium<d> generic_medium(SceneFile const& file, MediumMesh const& mesh, Material const& material,
                                MediumMethod const& method, std::shared_ptr<MediumStart> const& start) {
  return {mesh.make(),  material,        start,           read_medium_loads<d>(file, mesh),
          method.order, method.conserve, method.viscosity};
}

template <int d>
void prepare_on_mesh(Simulation& simulation, Request const& request, MediumMesh const& mesh,
                     Material const& material, MediumMethod const& method,
                     std::shared_ptr<MediumStart> const& start) {
  simulation.on_ranks = method.conserve == media::Conserve::form;
  simulation.part_bytes = bytes_of_plain_steps(mesh, request);
  simulation.whole_bytes = bytes_to_begin(mesh, request);
  auto generic = generic_medium<d>(request.file, mesh, material, method, start);
  generic.scene = request.file.written();
  if (on_several_ranks() && shared_ranks()->size() > static_cast<int>(generic.mesh.nodes.size()))
    medium_keys.mesh.table(request.file)
        .fail("shape", fmt::format("mesh: {} nodes are shared among {} ranks, and each has one at least",
                                   generic.mesh.nodes.size(), shared_ranks()->size()));
  auto features = features_of<d>(request.file, mesh, generic.loads, material, start->uniform);
  {
    MeshCells<d> const cells(generic.mesh);
    auto const begin = examined_start<d>(request.file, *start, cells, mesh);
    tell_driven_sides<d>(simulation, features, mesh, cells, begin);
    for (auto& told :
         examined_loads<d>(request.file, mesh, generic.mesh, generic.loads, begin, request.schedule.until()))
      simulation.remarks.push_back(std::move(told));
    tell_gravity<d>(simulation, generic.loads, begin.places);
  }
  // Before the motion, which takes the mesh.
  double const frequency =
      frequency_of(generic.loads.in_time, generic.mesh.nodes, request.schedule.until(), simulation.remarks);
  auto motion = motion_of(request.file, generic);
  double const longest = motion->longest_step();
  require_reachable_end(request.file, longest, request.schedule.until());
  simulation.step = medium_step(request, longest, frequency, simulation.remarks,
                                motion->longest_in_one_part(), method.conserve == media::Conserve::form);
  motion->begin(simulation.step, longest);
  if (!has_loads(request.file)) tell_crossing<d>(simulation, request, mesh, material, *start);
  finish<d>(simulation, request, std::move(motion),
            {nullptr, stored_energy_of<d>(material), density_of<d>(start)}, mesh, 20 * mesh.cell_count(),
            {generic.loads, std::move(features)});
}

/// The quantities of a scene: a circulation for each of its loops.
std::vector<Quantity> quantities_of(bool fluid, SceneFile const& file) {
  auto all = medium_quantities(fluid);
  if (!loop_names(file).empty())
    std::ranges::find(all, "circulation", &Quantity::name)->kind = Quantity::Kind::list;
  return all;
}

/// The motion that a scene asks for.
/// @throws SceneError  where a key is refused: at its place, with the value and the bound
template <bool fluid>
Simulation prepare_medium(Request const& request) {
  MediumMethod const method = read_medium_method(request.file);
  medium_keys.metric.read(request.file);
  MediumMesh const mesh = read_medium_mesh(request.file);
  Material const material = read_material(request.file.section("system"), fluid, mesh.dimension);
  auto const start = std::make_shared<MediumStart>(read_medium_start(request.file, mesh.dimension));

  int const d = mesh.dimension;
  auto const& asked = request.quantities;
  if (auto const turns = std::find(asked.begin(), asked.end(), "angular_momentum");
      d == 1 && turns != asked.end())
    throw SceneError(
        request.file.section("output").place("quantities", static_cast<std::size_t>(turns - asked.begin())),
        "quantities: angular_momentum is that of bodies in the plane or in space");
  Simulation simulation(quantities_of(fluid, request.file));
  simulation.remarks = remarks_on(material, d);
  if (has_plain_steps(request.file, method, *start) &&
      (prepare_fast<media::FastBox2d>(simulation, request, mesh, material, start) ||
       prepare_fast<media::FastBox3d>(simulation, request, mesh, material, start)))
    return simulation;
  simulation.bytes = checked_memory(request.file, mesh, false, request);
  if (d == 1)
    prepare_on_mesh<1>(simulation, request, mesh, material, method, start);
  else if (d == 2)
    prepare_on_mesh<2>(simulation, request, mesh, material, method, start);
  else
    prepare_on_mesh<3>(simulation, request, mesh, material, method, start);
  return simulation;
}

/// The part of a medium of d dimensions.
template <int d>
std::unique_ptr<RankPart> part_of(SceneFile const& file, MediumMesh const& mesh, bool fluid, double step) {
  Material const material = read_material(file.section("system"), fluid, d);
  auto const start = std::make_shared<MediumStart>(read_medium_start(file, d));
  MediumMethod const method = read_medium_method(file);
  if constexpr (d > 1)
    if (has_plain_steps(file, method, *start))
      if (auto const fast = optimised_of<std::conditional_t<d == 2, media::FastBox2d, media::FastBox3d>>(
              mesh, material, *start))
        return fast->part(step);
  return generic_medium<d>(file, mesh, material, method, start).part();
}

std::unique_ptr<RankPart> part_of_medium(SceneFile const& file, double step) {
  try {
    bool const fluid = file.section("system").text("kind") == "barotropic_fluid";
    MediumMesh const mesh = read_medium_mesh(file);
    if (mesh.dimension == 1) return part_of<1>(file, mesh, fluid, step);
    if (mesh.dimension == 2) return part_of<2>(file, mesh, fluid, step);
    return part_of<3>(file, mesh, fluid, step);
  } catch (std::exception const& error) {
    // Rank 0 has made the same: it is a matter of this machine, and ends all ranks.
    throw std::runtime_error(error.what());
  }
}

}  // namespace

System medium_system(bool fluid, std::string name, std::string title, std::string meaning,
                     std::string example) {
  return {std::move(name),
          std::move(title),
          std::move(meaning),
          "chapter 10",
          records_of({MediumKeys{{"system"}, fluid}, medium_start_keys, medium_method_parameters()}),
          medium_methods(),
          medium_quantities(fluid),
          fluid ? &prepare_medium<true> : &prepare_medium<false>,
          std::move(example),
          nullptr,
          {},
          nullptr,
          medium_snapshots(fluid),
          {},
          nullptr,
          nullptr,
          &part_of_medium};
}

}  // namespace actio::scene
