// The incompressible fluid on the sphere by cells that move with it (thesis, chapter 8, with a curved
// target).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "program/base/memory.hpp"
#include "program/medium_output/snapshots.hpp"
#include "program/registry/conservation.hpp"
#include "program/systems/incompressible/keys.hpp"
#include "program/systems/incompressible/quantities.hpp"
#include "program/systems/incompressible/sphere_start.hpp"
#include "program/systems/incompressible/system.hpp"
#include "program/systems/media/memory.hpp"
#include "program/systems/media/points.hpp"
#include "program/systems/method_input.hpp"

namespace actio::scene {
namespace {

using Fluid = media::IncompressibleSphere;
using Point = std::array<double, 3>;

struct SphereKeys : KeyTable {
  AnyKey mesh =
      key("mesh", "a table", LeftOut{"{ cells = 16 }"},
          "The cells: those of the faces of a cube, brought to the unit sphere and smoothed. cells: how "
          "many there are along each edge of the cube, 2 to 128; six times its square in all.",
          "{ cells = 8 }");
} const sphere_keys{{"system"}};

/// How many cells there are along an edge; written back where it is left out.
int read_cells(SceneFile const& file) {
  SceneTable mesh = sphere_keys.mesh.table(file);
  mesh.allow({"cells"});
  if (!mesh.has("cells")) mesh.set("cells", 16L);
  return static_cast<int>(mesh.integer("cells", 2, 128));
}

/// The edge of the last face of the cube, around which cells lie to the left.
MaterialLoop<3> edge_of_upper_face(media::BodyMesh const& mesh, int n) {
  MaterialLoop<3> out;
  std::size_t const first = mesh.cells.size() - static_cast<std::size_t>(n * n);
  auto const add = [&](int i, int j, std::size_t corner) {
    auto const cell = first + static_cast<std::size_t>(j * n + i);
    out.stops.push_back({static_cast<std::size_t>(mesh.cells[cell][corner])});
  };
  for (int i = 0; i < n; ++i) add(i, 0, 0);
  for (int j = 0; j < n; ++j) add(n - 1, j, 1);
  for (int i = n; i-- > 0;) add(i, n - 1, 3);
  for (int j = n; j-- > 0;) add(0, j, 2);
  out.stops.push_back(out.stops.front());
  return out;
}

double shortest_edge(media::BodyMesh const& mesh) {
  double least = HUGE_VAL;
  for (auto const& cell : mesh.cells)
    for (std::size_t b = 0; b < 4; ++b)
      for (std::size_t const other : {b ^ 1, b ^ 2})
        least = std::min(least, distance(mesh.nodes[static_cast<std::size_t>(cell[b])],
                                         mesh.nodes[static_cast<std::size_t>(cell[other])]));
  return least;
}

/// The memory that a run takes at most: the program, the mesh and the states, the matrix for pressures with
/// its factors, and a snapshot while it is written or read.
double bytes_on_sphere(int n, Request const& request) {
  double const cells = 6.0 * n * n;
  bool const hdf5 = request.snapshots && request.snapshots->in("hdf5");
  return bytes_of_program + (hdf5 ? 11e6 : 0) +
         cells * (1250 + 50 * std::log2(cells) + (request.snapshots ? 150 : 0));
}

/// The memory that it takes, refused before anything of that size is touched.
double checked_memory(SceneFile const& file, int n, Request const& request) {
  auto const bytes = [&](int along) { return bytes_on_sphere(along, request); };
  double const needed = bytes(n);
  require_memory(needed, file.section("system.mesh").place("cells"),
                 fmt::format("cells: {} along an edge", n), [&](double there) {
                   int const would = static_cast<int>(0.95 * n * std::sqrt(there / needed));
                   return fmt::format("cells = {} takes {}", would, bytes_in_words(bytes(would)));
                 });
  return needed;
}

/// Its velocities at the nodes, and what is wrong with them.
double fastest_of(SceneTable const& initial, SphereStart const& start, media::BodyMesh const& mesh,
                  std::vector<std::string>& remarks) {
  double fastest = 0, outwards = 0;
  for (auto const& x : mesh.nodes) {
    Point const v = start(x);
    fastest = std::max(fastest, std::hypot(v[0], v[1], v[2]));
    outwards = std::max(outwards, std::abs(x[0] * v[0] + x[1] * v[1] + x[2] * v[2]));
  }
  constexpr double least = 1e-90, most = 1e90;
  if (fastest != 0 && !(fastest >= least && fastest <= most))
    initial.fail(
        start.key(),
        fmt::format("{}: the largest velocity is {:.3g}; from {} to {} squares are numbers of 64 bits, "
                    "and another unit of time makes it moderate",
                    start.key(), fastest, least, most));
  if (outwards > 1e-12 * fastest)
    remarks.push_back(
        fmt::format("initial.{}: velocities pointed out of the sphere by up to {:.3g}, which was taken away",
                    start.key(), outwards));
  return fastest;
}

Simulation prepare(Request const& request) {
  SceneFile const& file = request.file;
  read_method(file.section("method"), incompressible_methods());
  int const n = read_cells(file);
  auto const solving = read_volume_solving(file);
  SphereStart const start(file);
  Simulation simulation(quantities_on_sphere());
  simulation.bytes = checked_memory(file, n, request);
  auto mesh = media::sphere_mesh(n);
  double const fastest = fastest_of(file.section("initial"), start, mesh, simulation.remarks);
  // A tenth of an edge in a step: turns of 0.8 radians.
  simulation.step =
      read_step(file.section("method"), request.schedule, 8 * fastest / shortest_edge(mesh), 0.8);
  auto motion = std::make_unique<IncompressibleSteps<Fluid>>(
      std::make_unique<Fluid>(std::move(mesh), start, simulation.step, solving));
  Fluid& fluid = motion->medium();
  if (fluid.projected() > 1e-6 * fastest)
    simulation.remarks.push_back(fmt::format(
        "initial.{}: what changes areas of cells was taken away, up to {:.3g} at a node of {:.3g}",
        start.key(), fluid.projected(), fastest));
  try {
    fluid.pressures();
  } catch (Error const& error) {
    simulation.failure = file.section("method").place("step").text() + ": step: " + error.what();
  }
  // At rest there is nothing that a drift could be compared with.
  simulation.quantities.conserve(
      [fastest](std::string const& name) { return fastest > 0 && is_conserved("fluid_on_sphere", name); });
  MediumView<3> const view{motion.get(), media::no_stored_energy<3>(), [](Point const&) { return 1.0; }};
  define_incompressible(simulation.quantities, view, *motion, {edge_of_upper_face(fluid.mesh(), n)});
  simulation.quantities.ask(request.quantities);
  simulation.snapshots = write_medium(request, view);
  simulation.steps_at_once = 1;
  simulation.companion = {nullptr, 0, 0, false,
                          "not estimated: a run with half the step and twice the cells shows it"};
  simulation.motion = std::move(motion);
  return simulation;
}

/// Pressures are found from factors.
std::vector<Parameter> method_records() {
  auto out = incompressible_method_keys.records();
  std::erase_if(out, [](auto const& one) { return one.key == "method.solver"; });
  return out;
}

/// Density and stored energy say nothing here.
SnapshotKind snapshots_on_sphere() {
  SnapshotKind out = medium_snapshots(true, true);
  std::erase_if(out.columns,
                [](auto const& one) { return one.name != "jacobian" && one.name != "pressure"; });
  return out;
}

}  // namespace

/// The incompressible fluid on the sphere by cells.
System fluid_on_sphere_system() {
  return {"fluid_on_sphere",
          "Fluid on the sphere, by cells",
          "An ideal fluid of density 1 on the unit sphere, on cells that move with it and keep their areas: "
          "the air of a planet, particle by particle. Its three angular momenta are kept to rounding.",
          "chapter 8",
          records_of({sphere_keys, sphere_start_records(), method_records()}),
          incompressible_methods(),
          quantities_on_sphere(),
          prepare,
          R"scene([system]
kind = "fluid_on_sphere"
mesh = { cells = 8 }
[initial]
stream = "-0.5*z + 0.2*x*y"
[run]
until = 2
every = 0.01
[output]
quantities = ["energy", "angular_momentum", "volume_defect", "min_jacobian"]
)scene",
          nullptr,
          {},
          nullptr,
          snapshots_on_sphere()};
}

}  // namespace actio::scene
