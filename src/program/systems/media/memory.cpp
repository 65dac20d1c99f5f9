#include "program/systems/media/memory.hpp"

#if __has_include(<malloc.h>)
#include <malloc.h>
#endif

#include <algorithm>
#include <cmath>

#include "program/medium_output/fields.hpp"

namespace actio::scene {
namespace {

/// Lists of that size have pages of their own, which are given back with them; bytes.
constexpr int least_list_apart = 1 << 20;

/// What is counted, for a mesh and a request.
struct Counted {
  double d, nodes, cells;
  double corners;   ///< of a cell
  double points;    ///< of a cell
  bool around;      ///< whether a direction is periodic
  double vector;    ///< bytes of a vector at each node
  double observed;  ///< vectors that quantities keep from row to row

  Counted(MediumMesh const& mesh, Request const& request)
      : d(mesh.dimension), nodes(mesh.node_count()), cells(mesh.cell_count()), vector(8 * d * nodes) {
    bool const simplices = mesh.read && media::is_simplex(mesh.read->shape);
    corners = simplices ? d + 1 : std::exp2(d), points = simplices || d == 1 ? 1 : corners;
    around = std::find(mesh.periodic.begin(), mesh.periodic.end(), true) != mesh.periodic.end();
    auto const asked = [&](char const* name) {
      return std::find(request.quantities.begin(), request.quantities.end(), name) !=
             request.quantities.end();
    };
    bool const both =
        asked("momentum") || asked("angular_momentum") || asked("circulation") || asked("noether_balance");
    observed = both ? 2 : asked("min_jacobian") ? 1 : 0;
  }
};

/// Besides a list: a chunk of it as HDF5 has it (frames.cpp), and compressed.
double bytes_of_chunk(double list) { return list > 0 ? 2 * list / std::ceil(list / 2097152) : 0; }

/// What a snapshot takes while it is written, places, velocities and fields, or while its table is read and
/// written in another format; files are written in parts.
double bytes_of_snapshot(Counted const& body, SnapshotRequest const& snapshots) {
  double columns = 0, of_widest = 0;
  auto const count = [&]<int d>(MediumFields<d> const& fields) {
    columns = static_cast<double>(field_size(fields));
    for (auto const& field : fields) of_widest = std::max(of_widest, static_cast<double>(field.width()));
  };
  if (body.d == 1) count(fields_named<1>(snapshots.columns));
  if (body.d == 2) count(fields_named<2>(snapshots.columns));
  if (body.d == 3) count(fields_named<3>(snapshots.columns));
  double const widest = 8 * body.nodes * of_widest;
  // While fields are summed there are the volumes that they are weighed by.
  double most = 8 * (columns + 1) * body.nodes;
  if (snapshots.in("hdf5"))
    most = std::max(most, 8 * columns * body.nodes + bytes_of_chunk(std::max(widest, body.vector)));
  // Places and velocities are there twice when they have been read. The blocks of a grid are compressed where
  // the library of frames has left room.
  if (snapshots.in("vtu"))
    most = std::max({most, 2 * body.vector,
                     8 * (columns + 1) * body.cells +
                         (snapshots.in("hdf5") ? 0 : 1.5e6 + std::min(80 * body.cells, 1.2e6))});
  return 2 * body.vector + most;
}

/// What is the same in all frames of a file, one list at a time.
double bytes_of_constants(Counted const& body, SnapshotRequest const& snapshots) {
  if (!snapshots.in("hdf5")) return 0;
  double const list = std::max(body.vector, 8 * body.corners * body.cells * (body.around ? body.d : 1));
  return list + bytes_of_chunk(list);
}

/// Fused steps: places and velocities in registers of four, their copy.
double bytes_on_fast_way(Counted const& body, MediumMesh const& mesh, double snapshot, double constants) {
  // Velocities half a step later take the forces and the places besides. Lists that are not kept apart leave
  // gaps behind, into which larger ones do not fit.
  double const gap = body.vector < least_list_apart ? body.vector : 0;
  // Places and velocities of the start are there until the first row, and what quantities keep from then on.
  double const kept = std::max(body.observed, 2.0);
  double const besides = std::max(
      {3 * body.vector + 2.5 * gap, snapshot + 2.5 * gap, constants - kept * body.vector + 2.5 * gap});
  return bytes_of_fused_steps(mesh) + kept * body.vector + besides;
}

/// Nodes and cells of a mesh.
double bytes_of_mesh(Counted const& body) {
  return 24 * body.nodes + (32 + (body.around ? 8 : 0)) * body.cells;
}

/// What plain steps keep: the mesh, the points of its cells with their inverse edges, states, forces, copies.
double bytes_kept(Counted const& body, MediumMesh const& mesh, Request const& request) {
  bool const viscous = request.file.section("method").has("viscosity"),
             walls = !medium_keys.obstacle.table(request.file).keys().empty();
  double held = 0;
  for (auto const& [name, does] : mesh.sides)
    held += (does != media::Side::free ? 1 : 0) / std::max(1.0, static_cast<double>(mesh.sides.size()));
  // A body has so many nodes on its sides.
  double const surface = 2 * body.d * std::pow(body.nodes, 1 - 1 / body.d);
  double const cell =
      4 * body.corners + (body.around ? body.corners : 0) + 8 * body.points * (body.d * body.d + 2) +
      (viscous ? 8 : 0) +
      (body.corners == 8 && mesh.shape != "box" ? sizeof(media::CornerCorrection<double, 3>) : 0);
  return bytes_of_mesh(body) + cell * body.cells + 8 * body.nodes +
         (24 + held * (32 + 8 * (body.d + body.d * body.d))) * surface +
         (13 + (viscous ? 2 : 0)) * body.vector + (walls ? (body.vector + 8 * (1 + body.d) * body.nodes) : 0);
}

/// Plain steps.
double bytes_on_plain_way(Counted const& body, MediumMesh const& mesh, Request const& request,
                          double snapshot, double constants) {
  SceneTable const method = request.file.section("method");
  bool const implicit =
      method.has("conserve") && method.is_text("conserve") && method.text("conserve") == "energy";
  // A step that is solved by conjugate gradients, a checkpoint, a snapshot.
  // The lists of frames are written before there are copies and quantities.
  double const besides =
      std::max({(implicit ? 10 : 4) * body.vector, snapshot, constants - (5 + body.observed) * body.vector});
  return bytes_kept(body, mesh, request) + body.observed * body.vector + besides;
}

}  // namespace

void keep_large_lists_apart() {
#ifdef M_MMAP_THRESHOLD
  ::mallopt(M_MMAP_THRESHOLD, least_list_apart);
#endif
}

double bytes_of_fused_steps(MediumMesh const& mesh) {
  double const row = mesh.cells[0] + !mesh.periodic[0], packs = (mesh.cells[0] + 4) / 4,
               padded = (8 * packs + (std::fmod(packs, 8) == 0 ? 4 : 0)) / (2 * row);
  return 4 * padded * 8 * mesh.dimension * static_cast<double>(mesh.node_count());
}

double bytes_of_plain_steps(MediumMesh const& mesh, Request const& request) {
  return bytes_kept(Counted(mesh, request), mesh, request);
}

double bytes_to_begin(MediumMesh const& mesh, Request const& request) {
  Counted const body(mesh, request);
  // Besides, of each node its rank and whether it is here.
  return bytes_of_mesh(body) + 12 * body.nodes;
}

double bytes_for_medium(MediumMesh const& mesh, bool fast, Request const& request) {
  Counted const body(mesh, request);
  double const snapshot = request.snapshots ? bytes_of_snapshot(body, *request.snapshots) : 0,
               constants = request.snapshots ? bytes_of_constants(body, *request.snapshots) : 0;
  bool const frames = request.snapshots && request.snapshots->in("hdf5");
  constexpr double library = 11.0e6;
  return bytes_of_program + (frames ? library : 0) +
         (fast ? bytes_on_fast_way(body, mesh, snapshot, constants)
               : bytes_on_plain_way(body, mesh, request, snapshot, constants));
}

}  // namespace actio::scene
