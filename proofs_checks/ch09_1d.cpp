// Scalars: rational (long: double)
// Section 9.1: Noether's theorem, on and off the solutions.
#include "fields.hpp"

#include "actio/noether/isometries.hpp"
#include "actio/noether/time_translation.hpp"
#include "statement.hpp"
#include "symmetries.hpp"

namespace {

using namespace actio;
using namespace actio::checks;

}  // namespace

STATEMENT(thm_9_1_1, "covariant Noether theorem") {
  claim.holds("Off shell, for any density and any field: $d(j^1\\phi)^*J=\\bigl(r-E_a(\\xi^a-v^a{}_\\mu\\xi^\\mu)\\bigr)\\,d^{n+1}x$ with the rate r of equivariance.");
  claim.degree(80);
  over_points(std::tuple<Dimensions<1, 3>, Dimensions<2, 1>>{}, [&]<class D>(D, std::string const& model) {
    auto const L = draw_density<S, D::n, D::N>(draw);
    auto const xi = draw_field<S, D::n, D::N>(draw);
    auto const j = draw_second_jet<S, D::n, D::N>(draw);
    S const divergence = current_divergence(L, xi, j);
    claim.equal("any density, any field, any section", model, divergence, S(equivariance_rate(L, xi, first(j)) + noether_identity(L, xi, j)), 10);
    claim.differs("without the rate of equivariance", model, divergence, noether_identity(L, xi, j));
  });
  over_points(PlaneAndSpace{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const fluid = draw_homogeneous_fluid<S, n>(draw);
    auto const field = relabelling_field<n>(draw_relabelling<S, n>(fluid.G, draw));
    auto const off = draw_second_jet<S, n, n>(draw);
    auto const on = of_a_solution(fluid, off);
    S const scale = noether_identity(fluid, field, off);
    // The acceleration comes out of an elimination.
    claim.zero("relabelling current along solutions", model, current_divergence(fluid, field, on), scale, 100);
    claim.zero("current of time translation along solutions", model, current_divergence(fluid, TimeTranslation{}, on), scale, 100);
    claim.refutes("along a section that solves nothing", model, current_divergence(fluid, field, off), scale);
    auto const varying = with_varying_mass(fluid, draw);
    claim.refutes("mass that varies", model, current_divergence(varying, field, of_a_solution(varying, off)), scale);
  });
}

STATEMENT(eq_9_5, "exterior derivative of the Noether current on solutions") {
  claim.holds("For relabelling it is $\\xi^kF^a{}_kE_a\\,d^{n+1}x$ off shell, for time translation $\\dot\\phi^aE_a$, for an isometry $k$ of space $-k^aE_a$.");
  claim.degree(80);
  over_points(PlaneAndSpace{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const fluid = draw_homogeneous_fluid<S, n>(draw);
    auto const xi = draw_relabelling<S, n>(fluid.G, draw);
    auto const field = relabelling_field<n>(xi);
    auto const j = draw_second_jet<S, n, n>(draw);
    Eigen::Matrix<S, n, 1> const along_field = j.gradient() * xi(j.particle());
    S const expected = along_field.dot(euler_lagrange(fluid, j));
    claim.equal("off shell", model, current_divergence(fluid, field, j), expected, 10);
    claim.zero("on solutions", model, current_divergence(fluid, field, of_a_solution(fluid, j)), expected, 100);
    claim.differs("the other sign", model, current_divergence(fluid, field, j), S(-expected));
    auto const squeezing = relabelling_field<n>(draw_compression<S, n>(draw));
    claim.refutes("a field with divergence, on solutions", model, current_divergence(fluid, squeezing, of_a_solution(fluid, j)), expected);

    auto const power = j.velocity().dot(euler_lagrange(fluid, j));
    claim.equal("time translation, off shell", model, current_divergence(fluid, TimeTranslation{}, j), power, 10);
    auto const shift = motion_of_space<n>(FirstShift<n>{});
    auto symmetric = fluid;
    symmetric.g = draw_shiftable_metric<S, n>(draw);
    claim.equal("isometry of space, off shell", model, current_divergence(symmetric, shift, j), S(-euler_lagrange(symmetric, j)[0]), 10);
    claim.differs("the same shift where the metric depends on the coordinate", model, current_divergence(fluid, shift, j), S(-euler_lagrange(fluid, j)[0]));
  });
}
