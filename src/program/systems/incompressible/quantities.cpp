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
    all.push_back({name, Kind::scalar, meaning, formula, unit});
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

std::vector<Quantity> quantities_on_sphere() {
  auto all = incompressible_quantities(true);
  std::erase_if(
      all, [](auto const& one) { return one.name == "momentum" || one.name == "pressure_checkerboard"; });
  auto const tell = [&all](char const* name, char const* meaning, char const* formula) {
    auto& one = *std::ranges::find(all, name, &Quantity::name);
    one.meaning = meaning, one.formula = formula;
  };
  tell("energy", "The kinetic energy. The steps keep it to the square of the step.",
       "E = \\sum\\tfrac m2|v|^2");
  tell(
      "angular_momentum",
      "The angular momentum about the centre of the sphere. The steps keep all three components to rounding.",
      "\\int\\rho\\,\\phi\\times\\dot\\phi");
  tell("circulation",
       "The circulation of the velocity along the nodes at the edge of the upper face of the cube that the "
       "mesh is made from, counterclockwise as seen from outside. Kelvin's theorem holds to the order of the "
       "scheme.",
       "\\oint\\dot\\phi\\cdot d\\phi");
  tell("volume_defect",
       "How far the area of a cell is from what it was, the largest over all cells, over it.",
       "\\max_K|A_K/A_K^0 - 1|");
  return all;
}

template <class Medium>
void define_incompressible(QuantityGraph& graph, MediumView<Medium::N> const& view,
                           IncompressibleSteps<Medium> const& motion,
                           std::vector<MaterialLoop<Medium::N>> const& loops) {
  define_sums<Medium::N>(graph, view, loops);
  auto& medium = motion.medium();
  graph.define("volume_defect", {""}, [&medium](auto, double* out) { *out = medium.volume_defect(); });
  graph.define("min_jacobian", {""},
               [&medium](auto, double* out) { *out = std::ranges::min(medium.jacobians()); });
  if constexpr (requires { checkerboard(medium); })
    graph.define("pressure_checkerboard", {""},
                 [&medium](auto, double* out) { *out = checkerboard(medium); });
  graph.define("iterations", {""}, [&medium](auto, double* out) { *out = medium.rounds(); });
}
/// In the plane.
template void define_incompressible(QuantityGraph&, MediumView<2> const&,
                                    IncompressibleSteps<media::IncompressibleMedium<2>> const&,
                                    std::vector<MaterialLoop<2>> const&);
/// In space.
template void define_incompressible(QuantityGraph&, MediumView<3> const&,
                                    IncompressibleSteps<media::IncompressibleMedium<3>> const&,
                                    std::vector<MaterialLoop<3>> const&);
/// On the sphere.
template void define_incompressible(QuantityGraph&, MediumView<3> const&,
                                    IncompressibleSteps<media::IncompressibleSphere> const&,
                                    std::vector<MaterialLoop<3>> const&);

}  // namespace actio::scene
