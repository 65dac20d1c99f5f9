#include "program/systems/incompressible/quantities.hpp"

#include <algorithm>

namespace actio::scene {
namespace {

using Kind = Quantity::Kind;

/// The mean pressure of red cells of a box less that of black ones.
template <int d>
double checkerboard(media::IncompressibleMedium<d>& medium) {
  auto const P = medium.pressures();
  auto const& grid = medium.mesh().grid;
  if (grid[0] == 0) return 0;
  double sum[2] = {}, count[2] = {};
  for (int cell = 0; cell < static_cast<int>(P.size()); ++cell) {
    int const black = (cell % grid[0] + cell / grid[0] % grid[1] + cell / grid[0] / grid[1]) % 2;
    sum[black] += P[static_cast<std::size_t>(cell)], ++count[black];
  }
  return sum[0] / count[0] - (count[1] > 0 ? sum[1] / count[1] : 0);
}

}  // namespace

std::vector<Quantity> incompressible_quantities(bool fluid) {
  auto all = sums_of_body(fluid);
  std::ranges::find(all, "energy", &Quantity::name)->meaning =
      "The kinetic energy, the stored one, and that of loads. The steps keep it to the square of the step.";
  std::ranges::find(all, "circulation", &Quantity::name)->meaning +=
      " No scheme on cells that are followed keeps it to rounding.";
  auto const add = [&](char const* name, char const* meaning, char const* formula, char const* unit) {
    all.push_back({name, Kind::scalar, meaning, formula, unit, "", {}});
  };
  add("volume_defect", "How far the volume of a cell is from what it was, over it, the largest over all.",
      "\\max_K|A_K/A_K^0 - 1|", "1");
  add("min_jacobian",
      "The least Jacobian at a corner of a cell, over that of the reference: a run ends before it reaches "
      "zero. The volume of a cell may be kept while it folds.",
      "\\min J", "1");
  add("pressure_checkerboard",
      "The mean pressure of the red cells of a box less that of the black ones, of a chessboard. Of bodies "
      "that are no box it is zero.",
      "\\langle P\\rangle_{\\mathrm{red}} - \\langle P\\rangle_{\\mathrm{black}}", "energy/volume");
  add("iterations", "How many rounds it took to solve for the pressures of the last step.", "", "1");
  return all;
}

template <int d>
void define_incompressible(QuantityGraph& graph, MediumView<d> const& view,
                           IncompressibleSteps<d> const& motion, std::vector<MaterialLoop<d>> const& loops) {
  define_sums<d>(graph, view, loops);
  auto& medium = motion.medium();
  graph.define("volume_defect", {""}, [&medium](auto, double* out) { *out = medium.volume_defect(); });
  graph.define("min_jacobian", {""},
               [&medium](auto, double* out) { *out = std::ranges::min(medium.jacobians()); });
  graph.define("pressure_checkerboard", {""},
               [&medium](auto, double* out) { *out = checkerboard<d>(medium); });
  graph.define("iterations", {""}, [&medium](auto, double* out) { *out = medium.rounds(); });
}
/// In the plane.
template void define_incompressible(QuantityGraph&, MediumView<2> const&, IncompressibleSteps<2> const&,
                                    std::vector<MaterialLoop<2>> const&);
/// In space.
template void define_incompressible(QuantityGraph&, MediumView<3> const&, IncompressibleSteps<3> const&,
                                    std::vector<MaterialLoop<3>> const&);

}  // namespace actio::scene
