// How the quantities of a flow on the sphere come from its motion.
#include <Eigen/Core>

#include <algorithm>
#include <cmath>

#include "actio/quantized_sphere/sphere_invariants.hpp"
#include "actio/vorticity/canonical_splitting.hpp"
#include "program/systems/sphere/powers.hpp"
#include "program/systems/sphere/quantities.hpp"

namespace actio::scene {
namespace {

using Flow = std::shared_ptr<SphereFlow const>;

void define_quadratic_invariants(QuantityGraph& graph, VorticityMotion const& motion, Flow const& flow) {
  graph.define("energy", {""}, [&motion, flow](auto, double* energy) {
    *energy = sphere::vorticity_energy(flow->stream, motion.vorticity_but_for_rotation());
  });
  graph.define("enstrophy", {""}, [&motion](auto, double* out) {
    *out = sphere::enstrophy(motion.vorticity_but_for_rotation());
  });
  // The root of the integral of the square of a coordinate, times that of the vorticity: no flow has more. It
  // is that of the flow, beside which the momentum of the sphere's own rotation may be large; but not so
  // small that the rounding of that is all there is to see.
  graph.define(
      "angular_momentum", column_ends(Quantity::Kind::vector),
      [&motion](auto, double* momentum) {
        Eigen::Map<Eigen::Vector3d>(momentum, 3) = motion.angular_momentum();
      },
      [&motion](auto, double const*, std::size_t) {
        return std::sqrt(4 * M_PI / 3 * 2 *
                         std::max(sphere::enstrophy(motion.vorticity_but_for_rotation()),
                                  1e-20 * sphere::enstrophy(motion.absolute_vorticity())));
      });
}

void define_casimirs(QuantityGraph& graph, VorticityMotion const& motion, Flow const& flow) {
  constexpr int last = 8;
  graph.define(
      "casimirs", numbered(2, last),
      [&motion, flow](auto, double* casimirs) {
        Eigen::Map<Eigen::VectorXd>(casimirs, last - 1) =
            vorticity_casimirs(flow->products, motion.absolute_vorticity(), flow->sphere.area_element());
      },
      // Odd powers may cancel: theirs is at least that of a vorticity which is everywhere the root of the
      // mean square.
      [](auto, double const* casimirs, std::size_t k) {
        double const area = 4 * M_PI;
        double const least = area * std::pow(casimirs[0] / area, 0.5 * (static_cast<double>(k) + 2));
        return k % 2 == 0 ? 0 : std::max(least, std::abs(casimirs[k]));
      });
}

void define_values(QuantityGraph& graph, VorticityMotion const& motion, Flow const& flow) {
  int const n = flow->sphere.n;
  graph.define("eigenvalues", numbered(1, n), [&motion, n](auto, double* values) {
    Eigen::Map<Eigen::VectorXd>(values, n) = vorticity_eigenvalues(motion.absolute_vorticity());
  });
  graph.define(
      "extrema", {"_min", "_max"},
      [n](auto needs, double* extrema) { extrema[0] = needs[0][0], extrema[1] = needs[0][n - 1]; },
      [](auto, double const* extrema, std::size_t) {
        return std::max(std::abs(extrema[0]), std::abs(extrema[1]));
      });
  // The bins are found when the first row asks for them.
  graph.define("histogram", numbered(1, HistogramBins::count),
               [flow, n, bins = std::optional<HistogramBins>()](auto needs, double* shares) mutable {
                 if (!bins) bins = histogram_bins(*flow);
                 Eigen::Map<Eigen::VectorXd>(shares, HistogramBins::count) =
                     bins->shares(Eigen::Map<Eigen::VectorXd const>(needs[0], n));
               });
}

/// `use(l, power)` for each degree, from 1 on.
template <class Use>
void by_degree(VorticityMotion const& motion, double* out, Use const& use) {
  sphere::SphereHarmonics const f = sphere::harmonics_of(motion.vorticity_but_for_rotation());
  for (int l = 1; l < f.degrees(); ++l) out[l - 1] = use(l, f.power(l));
}

void define_spectra(QuantityGraph& graph, VorticityMotion const& motion, Flow const& flow) {
  auto const degrees = numbered(1, flow->sphere.n - 1);
  graph.define("spectrum", degrees, [&motion, flow](auto, double* out) {
    by_degree(motion, out, [&](int l, double power) { return 0.5 * power / flow->hamiltonian.divisor(l); });
  });
  graph.define("velocity_spectrum", degrees, [&motion, flow](auto, double* out) {
    by_degree(motion, out, [&](int l, double power) {
      return 0.5 * power * (l * (l + 1.0)) / std::pow(flow->hamiltonian.divisor(l), 2);
    });
  });
  graph.define("enstrophy_spectrum", degrees, [&motion](auto, double* out) {
    by_degree(motion, out, [](int, double power) { return 0.5 * power; });
  });
}

void define_splitting(QuantityGraph& graph, VorticityMotion const& motion, Flow const& flow) {
  graph.define("splitting", {"_steady_energy", "_steady_enstrophy", "_rest_energy", "_rest_enstrophy"},
               [&motion, flow](auto, double* out) {
                 auto const [steady, rest] =
                     sphere::canonical_splitting(flow->stream, motion.vorticity_but_for_rotation());
                 out[0] = sphere::vorticity_energy(flow->stream, steady), out[1] = sphere::enstrophy(steady);
                 out[2] = sphere::vorticity_energy(flow->stream, rest), out[3] = sphere::enstrophy(rest);
               });
}

}  // namespace

HistogramBins histogram_bins(SphereFlow const& flow) {
  return HistogramBins(vorticity_eigenvalues(flow.start));
}

void define_vorticity(QuantityGraph& graph, VorticityMotion const& motion,
                      std::shared_ptr<SphereFlow const> flow) {
  define_quadratic_invariants(graph, motion, flow);
  define_casimirs(graph, motion, flow);
  define_values(graph, motion, flow);
  define_spectra(graph, motion, flow);
  define_splitting(graph, motion, flow);
}

}  // namespace actio::scene
