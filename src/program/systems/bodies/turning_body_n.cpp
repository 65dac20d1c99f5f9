#include <Eigen/Core>

#include "program/systems/bodies/turning_body_n.hpp"

#include "actio/fast_body/any_dimension/skew_spectrum.hpp"
#include "program/systems/bodies/body_n_input.hpp"

namespace actio::scene {
namespace {

double energy_of(Eigen::VectorXd const& lambda, double const* momentum) {
  double sum = 0;
  for (Eigen::Index i = 0; i < lambda.size(); ++i)
    for (Eigen::Index j = i + 1; j < lambda.size(); ++j, ++momentum)
      sum += *momentum / (lambda[i] + lambda[j]) * *momentum;
  return sum / 2;
}

}  // namespace

StateDistance TurningBodyN::distance(Motion const& other) const {
  auto const& body = static_cast<TurningBodyN const&>(other);
  Eigen::MatrixXd const M = body_momentum();
  return {(body.attitude() - attitude()).norm() / std::sqrt(2.0), (body.body_momentum() - M).stableNorm(),
          M.stableNorm()};
}

std::vector<Quantity> turning_body_n_quantities() {
  using Kind = Quantity::Kind;
  return {
      {"attitude", Kind::matrix, "The rotation, n by n, that takes the body to space.", "g", "1",
       "claim_5_2_reconstruction"},
      {"momentum", Kind::skew,
       "The angular momentum in the frame of the body: a skew matrix, for n = 3 with M_12 = "
       "-M_z, M_13 = M_y, M_23 = -M_x.",
       "M = \\Lambda\\xi + \\xi\\Lambda", "energy x time", "eq_5_8", Quantity::Shown::by_planes},
      Quantity{"energy", Kind::scalar, "The kinetic energy.",
               "H = \\tfrac12\\sum_{i<j}(\\Lambda_i+\\Lambda_j)\\,\\xi_{ij}^2", "energy", "eq_5_1"}
          .from({"momentum"}),
      Quantity{"spectrum", Kind::list,
               "The moduli of the n eigenvalues of the momentum in ascending order; those that rounding "
               "cannot tell from zero are zero.",
               "\\sigma_k = |z_k|,\\quad \\det(M-z_k) = 0", "energy x time",
               "claim_5_2_update_by_conjugation"}
          .from({"momentum"}),
      Quantity{"casimir", Kind::list,
               "The traces of the even powers of the momentum, which name the coadjoint "
               "orbit; summed over the spectrum.",
               "C_{2k} = (-1)^k\\,\\mathrm{tr}\\,M^{2k},\\quad k = 1,\\dots,\\lfloor n/2\\rfloor",
               "(energy x time)^2k", "claim_5_3_dual_casimir"}
          .from({"spectrum"}),
  };
}

void define_turning_body_n(QuantityGraph& graph, TurningBodyN const& motion,
                           Inertia<Eigen::Dynamic> const& inertia) {
  using Kind = Quantity::Kind;
  int const n = inertia.group.n;
  graph.define("attitude", column_ends(Kind::matrix, n), [&motion, n](auto, double* g) {
    Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(g, n, n) =
        motion.attitude();
  });
  graph.define("momentum", column_ends(Kind::skew, n), [&motion](auto, double* momentum) {
    auto const upper = upper_triangle(motion.body_momentum());
    std::copy(upper.begin(), upper.end(), momentum);
  });
  graph.define("energy", {""}, [lambda = inertia.lambda](auto needs, double* energy) {
    *energy = energy_of(lambda, needs[0]);
  });
  graph.define(
      "spectrum", numbered(1, n),
      [n](auto needs, double* moduli) {
        Eigen::Map<Eigen::VectorXd>(moduli, n) = bodies::skew_spectrum(skew_matrix(needs[0], n));
      },
      [n](auto, double const* moduli, std::size_t) { return moduli[n - 1]; });
  graph.define("casimir", numbered(2, n, 2), [n](auto needs, double* casimirs) {
    Eigen::Map<Eigen::VectorXd const> const moduli(needs[0], n);
    for (int k = 1; k <= n / 2; ++k)
      casimirs[k - 1] = moduli.unaryExpr([k](double x) { return std::pow(x, 2 * k); }).sum();
  });
}

double largest_modulus_for_casimirs(int n) { return std::pow(1e300, 1.0 / (n / 2 * 2)) / n; }

}  // namespace actio::scene
