// The keys of [system], [initial] and [method] of an incompressible medium. Mesh, material, sides and loads
// are those of other media.
#pragma once

#include "actio/incompressible_media/volume_steps.hpp"
#include "program/systems/media/keys.hpp"

namespace actio::scene {

/// [system] of an incompressible medium: records, of what the keys of media read.
struct IncompressibleKeys : KeyTable {
  /// @param fluid  whether they are those of a fluid
  explicit IncompressibleKeys(bool fluid) : KeyTable(records(fluid)) {}

 private:
  static std::vector<Parameter> records(bool fluid) {
    std::vector<Parameter> out;
    MediumKeys const all{{"system"}, fluid};
    for (auto const& record : all.records())
      if (record.key != "system.metric" && record.key != "system.obstacle" &&
          !(fluid && record.key == "system.material"))
        out.push_back(record);
    return out;
  }
};

/// [initial] of an incompressible medium, beside that of other media.
struct IncompressibleStartKeys : KeyTable {
  Key<bool> project =
      key("project", truth, false,
          "Whether what changes the volume of a cell is taken from placement and velocity. By default such a "
          "start is refused, with how much it changes.",
          "true");
};
inline IncompressibleStartKeys const incompressible_start_keys{{"initial"}};  ///< its keys

/// [method] of an incompressible medium.
struct IncompressibleMethodKeys : KeyTable {
  Key<double> step =
      key("step", positive.in("time"),
          LeftOut{"a tenth of the time in which the fastest node passes an edge, and four tenths "
                  "of the longest stable step at most"},
          "The time that a step takes.", "0.01");
  Key<std::string> solver =
      key("solver", one_of("solver", {"multigrid", "cholesky"}),
          LeftOut{"multigrid on boxes of 1000 cells in the plane and more"},
          "What the pressures are found by: cycles of multigrid, on boxes in the plane whose counts of cells "
          "are multiples of four along periodic directions, or sparse factors. In space it is conjugate "
          "gradients, and the key is left out.",
          "\"cholesky\"");
  Key<double> tolerance =
      key("tolerance", positive.called("a number from 1e-14 to 1e-6").in("1"), 2e-13,
          "How far the volume of a cell may be off, over that volume, at every step.", "1e-12");
};
inline IncompressibleMethodKeys const incompressible_method_keys{{"method"}};  ///< its keys

/// How the volumes of a step are solved for, as [method] has it.
/// @throws SceneError  where the tolerance is none
inline media::VolumeSolving read_volume_solving(SceneFile const& file) {
  media::VolumeSolving out;
  out.tolerance = incompressible_method_keys.tolerance.read(file);
  if (!(out.tolerance >= 1e-14 && out.tolerance <= 1e-6))
    incompressible_method_keys.tolerance.fail(
        file, fmt::format("a number from 1e-14 to 1e-6 is expected, found {}", out.tolerance));
  return out;
}

}  // namespace actio::scene
