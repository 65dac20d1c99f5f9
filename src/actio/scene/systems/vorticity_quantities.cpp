#include "actio/scene/systems/vorticity_quantities.hpp"

#include <cmath>

#include "actio/vorticity/sphere_invariants.hpp"

namespace actio::scene {
namespace {

constexpr int last_casimir = 8;

/// `use(l)` for each degree, from 1 on.
template <class Use>
void by_degree(VorticityMotion const& motion, double* out, Use const& use) {
  SphereHarmonics const f = harmonics_of(motion.vorticity_but_for_rotation());
  for (int l = 1; l < f.degrees(); ++l) out[l - 1] = use(l, f.power(l));
}

}  // namespace

std::vector<Quantity> vorticity_quantities() {
  using Kind = Quantity::Kind;
  return {
      {"energy",
       Kind::scalar,
       "The kinetic energy of the flow relative to the sphere, of unit radius and unit density.",
       "H = -\\tfrac12\\int\\psi\\,\\zeta = -\\tfrac12\\tfrac{4\\pi}N\\langle P, W\\rangle",
       "1/time^2",
       "",
       {},
       true},
      {"enstrophy",
       Kind::scalar,
       "Half of the integral of the square of the vorticity relative to the sphere; half of casimirs_2, that "
       "of the "
       "absolute vorticity, where the sphere does not turn.",
       "Z = \\tfrac12\\int\\zeta^2",
       "1/time^2",
       "",
       {},
       true},
      {"angular_momentum",
       Kind::vector,
       "The angular momentum of the absolute motion, the rotation of the sphere included, along axes that do "
       "not turn "
       "with the sphere: those of the sphere at t = 0, the third the pole. So it is constant; along axes of "
       "the sphere "
       "x and y would go round with the angular velocity -rotation. The flow relative to the sphere has z "
       "less by 8 pi "
       "rotation/3.",
       "L_j = \\int x_j\\,(\\zeta + 2\\Omega\\cos\\theta) = \\tfrac{4\\pi}N\\hbar\\,\\mathrm{Tr}(S_j(-iW))",
       "1/time",
       "",
       {},
       true},
      {"casimirs",
       Kind::list,
       "The integrals of the powers 2 to 8 of the absolute vorticity, as traces of the powers of the matrix: "
       "they name "
       "the coadjoint orbit.",
       "C_k = \\int(\\zeta + 2\\Omega\\cos\\theta)^k = \\tfrac{4\\pi}N\\mathrm{Tr}((-iW)^k),\\quad k = "
       "2,\\dots,8",
       "1/time^k",
       "eq_3_17",
       {},
       true},
      {"extrema",
       Kind::list,
       "The least and the greatest absolute vorticity: of the eigenvalues of the matrix, each of which is "
       "the value on "
       "1/N of the sphere.",
       "\\min,\\,\\max\\ \\sigma(-iW)",
       "1/time",
       "eq_3_17",
       {},
       true},
      {"spectrum",
       Kind::list,
       "The energy of the flow relative to the sphere in each degree l = 1, ..., N - 1; their sum is the "
       "energy.",
       "H_l = \\tfrac12\\sum_m\\frac{|\\zeta_{lm}|^2}{l(l+1)}",
       "1/time^2",
       "",
       {},
       false},
      {"enstrophy_spectrum",
       Kind::list,
       "The enstrophy of the flow relative to the sphere in each degree l = 1, ..., N - 1; their sum is the "
       "enstrophy.",
       "Z_l = \\tfrac12\\sum_m|\\zeta_{lm}|^2",
       "1/time^2",
       "",
       {},
       false},
  };
}

void define_vorticity(QuantityGraph& graph, VorticityMotion const& motion,
                      std::shared_ptr<SphereFlow const> flow) {
  int const n = flow->sphere.n;
  graph.define("energy", {""}, [&motion, flow](auto, double* energy) {
    *energy = vorticity_energy(flow->laplacian, motion.vorticity_but_for_rotation());
  });
  graph.define("enstrophy", {""},
               [&motion](auto, double* out) { *out = enstrophy(motion.vorticity_but_for_rotation()); });
  // The root of the integral of the square of a coordinate, times that of the vorticity: no flow has more.
  graph.define(
      "angular_momentum", column_ends(Quantity::Kind::vector),
      [&motion](auto, double* momentum) {
    Eigen::Map<Eigen::Vector3d>(momentum, 3) = motion.angular_momentum();
      },
      [&motion](auto, double const*, std::size_t) {
    return std::sqrt(4 * M_PI / 3 * 2 * enstrophy(motion.absolute_vorticity()));
  });
  graph.define(
      "casimirs", numbered(2, last_casimir),
      [&motion](auto, double* casimirs) {
    Eigen::Map<Eigen::VectorXd>(casimirs, last_casimir - 1) =
        vorticity_casimirs(motion.absolute_vorticity(), last_casimir);
      },
      // Odd powers may cancel: theirs is at least that of a vorticity which is everywhere the root of the
      // mean square.
      [](auto, double const* casimirs, std::size_t k) {
    double const area = 4 * M_PI;
    double const least = area * std::pow(casimirs[0] / area, 0.5 * (static_cast<double>(k) + 2));
    return k % 2 == 0 ? 0 : std::max(least, std::abs(casimirs[k]));
  });
  graph.define(
      "extrema", {"_min", "_max"},
      [&motion](auto, double* extrema) {
    Eigen::VectorXd const values = vorticity_values(motion.absolute_vorticity());
    extrema[0] = values[0], extrema[1] = values[values.size() - 1];
      },
      [](auto, double const* extrema, std::size_t) {
    return std::max(std::abs(extrema[0]), std::abs(extrema[1]));
  });
  graph.define("spectrum", numbered(1, n - 1), [&motion](auto, double* out) {
    by_degree(motion, out, [](int l, double power) { return 0.5 * power / (l * (l + 1.0)); });
  });
  graph.define("enstrophy_spectrum", numbered(1, n - 1), [&motion](auto, double* out) {
    by_degree(motion, out, [](int, double power) { return 0.5 * power; });
  });
}

}  // namespace actio::scene
