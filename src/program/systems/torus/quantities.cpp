#include "program/systems/torus/quantities.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <optional>

#include "actio/quantized_torus/torus_invariants.hpp"
#include "program/systems/sphere/powers.hpp"

namespace actio::scene {

std::vector<Quantity> torus_quantities() {
  using Kind = Quantity::Kind;
  return {
      {"energy", Kind::scalar,
       "The energy of the flow, with unit density: the kinetic one, and with a radius of deformation the "
       "potential one with it.",
       "H = -\\tfrac12\\int\\psi\\,\\omega = -\\tfrac12\\tfrac{4\\pi^2}N\\langle P, W\\rangle",
       "lengths^4/time^2"},
      {"enstrophy", Kind::scalar, "Half of the integral of the square of the vorticity; half of casimirs_2.",
       "Z = \\tfrac12\\int\\omega^2", "lengths^2/time^2"},
      {"casimirs", Kind::list,
       "The integrals of the powers 2 to 8 of the vorticity, as traces of the powers of the matrix: "
       "they name the coadjoint orbit. A row takes less than a step.",
       "C_k = \\int\\omega^k = \\tfrac{4\\pi^2}N\\mathrm{Tr}((-iW)^k),\\quad k = 2,\\dots,8",
       "lengths^2/time^k", "eq_3_17"},
      {"eigenvalues", Kind::list,
       "All values of the vorticity in ascending order, each on 1/N of the torus: the eigenvalues of the "
       "matrix. They are constant. A row takes less than a step.",
       "\\sigma(-iW)", "1/time", "eq_3_17"},
      Quantity{"eigenvalue_drift", Kind::scalar,
               "The largest change of an eigenvalue since the first row, relative to the largest of their "
               "moduli: rounding.",
               "\\max_k|\\lambda_k(t)-\\lambda_k(0)|/\\max_k|\\lambda_k(0)|", "1", "eq_3_17"}
          .from({"eigenvalues"}),
      Quantity{"extrema", Kind::list,
               "The least and the greatest vorticity: of the eigenvalues of the matrix, each of which is the "
               "value on 1/N of the torus.",
               "\\min,\\,\\max\\ \\sigma(-iW)", "1/time", "eq_3_17"}
          .from({"eigenvalues"}),
      {"spectrum", Kind::list,
       "The energy in rings of wave vectors: the k-th is that of those whose length rounds to k, from "
       "1 to N/sqrt(2); their sum is the energy. Gamma is zero but with a radius of deformation.",
       "H_k = 2\\pi^2\\sum_{\\mathrm{round}|(m,n)|=k}\\frac{|\\omega_{mn}|^2}{\\gamma-\\lambda_{mn}}",
       "lengths^4/time^2"},
  };
}

void define_torus(QuantityGraph& graph, TorusMotion const& motion,
                  std::shared_ptr<TorusFlow const> const& flow) {
  int const n = flow->stream.size();
  double const element = torus::QuantizedTorus(n).area_element();
  graph.define("energy", {""}, [&motion, flow](auto, double* energy) {
    *energy = torus::flow_energy(flow->stream, motion.vorticity());
  });
  graph.define("enstrophy", {""},
               [&motion](auto, double* out) { *out = torus::flow_enstrophy(motion.vorticity()); });
  constexpr int last = 8;
  graph.define(
      "casimirs", numbered(2, last),
      [&motion, flow, element](auto, double* casimirs) {
        Eigen::Map<Eigen::VectorXd>(casimirs, last - 1) =
            vorticity_casimirs(flow->products, motion.vorticity(), element);
      },
      // Odd powers may cancel: theirs is at least that of a vorticity which is everywhere the root of the
      // mean square.
      [](auto, double const* casimirs, std::size_t k) {
        double const area = 4 * M_PI * M_PI;
        double const least = area * std::pow(casimirs[0] / area, 0.5 * (static_cast<double>(k) + 2));
        return k % 2 == 0 ? 0 : std::max(least, std::abs(casimirs[k]));
      });
  graph.define("eigenvalues", numbered(1, n), [&motion, n](auto, double* values) {
    Eigen::Map<Eigen::VectorXd>(values, n) = vorticity_eigenvalues(motion.vorticity());
  });
  graph.define(
      "eigenvalue_drift", {""},
      [flow, n, start = std::optional<Eigen::VectorXd>()](auto needs, double* out) mutable {
        if (!start) start = vorticity_eigenvalues(flow->start);
        double const size = start->cwiseAbs().maxCoeff();
        *out = size > 0
                   ? (Eigen::Map<Eigen::VectorXd const>(needs[0], n) - *start).cwiseAbs().maxCoeff() / size
                   : 0;
      });
  graph.define(
      "extrema", {"_min", "_max"},
      [n](auto needs, double* extrema) { extrema[0] = needs[0][0], extrema[1] = needs[0][n - 1]; },
      [](auto, double const* extrema, std::size_t) {
        return std::max(std::abs(extrema[0]), std::abs(extrema[1]));
      });
  int const rings = static_cast<int>(std::lround(std::hypot((n - 1) / 2, (n - 1) / 2)));
  graph.define("spectrum", numbered(1, rings), [&motion, flow, rings](auto, double* out) {
    Eigen::Map<Eigen::VectorXd>(out, rings) =
        torus::energy_by_ring(torus::harmonics_of(motion.vorticity()), flow->stream.gamma()).tail(rings);
  });
}

}  // namespace actio::scene
