// Scalars: rational (long: double)
// Section 6.2: the expansion of the left side of the barotropic equation, step by step.
#include "fields.hpp"

#include "media.hpp"
#include "statement.hpp"

namespace {

using namespace actio;
using namespace actio::checks;

/// The three lines of (6.17) and their pieces, without the inertia that all of them begin with.
template <class S, int n>
struct Expansion {
  using Column = Eigen::Matrix<S, n, 1>;
  Column first;     ///< the weighted divergence
  Column pressure;  ///< slopes of P, carried to space
  Column volume;    ///< slopes of the volume of space along the section
  Column printed;   ///< slopes of det g in its place
  Column metric;    ///< half of P J g^bc dg_bc/dy^a

  template <class Fluid>
  Expansion(Fluid const& fluid, SecondJet<S, n, n> const& j) {
    auto const at = point_of_medium(fluid, static_cast<Jet<S, n, n> const&>(j));
    S const P = material_pressure(fluid, static_cast<Jet<S, n, n> const&>(j));
    Eigen::Matrix<S, n, n> const areas = area_transformation(at.G, at.g, at.F);
    auto const momentum = [&]<class T>(Jet<T, n, n> const& jet) {
      auto const here = fluid.G(jet.particle());
      T const factor = -detail::pressure(fluid, jet) * actio::volume<T>(here);
      return (area_transformation(here, fluid.g(jet.y), jet.gradient()) * factor).eval();
    };
    first = detail::two_point_rates(momentum, j).divergence / -body_volume(fluid, j);
    pressure = areas * pressure_slopes(fluid, j);
    Column of_root, of_square;
    for (int k = 0; k < n; ++k) {
      Dual<S> const square = determinant(fluid.g(along(j, k + 1).y));
      of_root[k] = square_root(square).part[0], of_square[k] = square.part[0];
    }
    Eigen::Matrix<S, n, n> const bare = at.inverse.transpose() * S(P * determinant(at.F) / body_volume(fluid, j));
    volume = bare * of_root;
    printed = bare * of_square;
    auto const rates = metric_derivatives(fluid.g, j.y);
    Eigen::Matrix<S, n, n> const up = inverse_matrix(at.g);
    for (int a = 0; a < n; ++a) metric[a] = P * at.J * up.cwiseProduct(rates[a]).sum() / S(2);
  }
};

}  // namespace

STATEMENT(eq_6_17, "the left side for a barotropic fluid, in three lines") {
  claim.corrected(R"(\frac{P\det\bigl(\frac{\partial\phi}{\partial x}\bigr)}{\sqrt{\det[G]}}\Bigl(\bigl(\tfrac{\partial\phi}{\partial x}\bigr)^{-1}\Bigr)^k_a\frac{\partial\det[g]}{\partial x^k})",
                  R"(\frac{P\det\bigl(\frac{\partial\phi}{\partial x}\bigr)}{\sqrt{\det[G]}}\Bigl(\bigl(\tfrac{\partial\phi}{\partial x}\bigr)^{-1}\Bigr)^k_a\frac{\partial\sqrt{\det[g]}}{\partial x^k})",
                  "The last term of the middle line lacks the root over $\\det g$. The first and the last line are right.");
  claim.maybe_scan();
  claim.degree(160);
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    auto const fluid = draw_medium<S, D::n>(draw, Kind::fluid);
    auto const j = draw_second_jet<S, D::n>(draw);
    Expansion<S, D::n> const lines(fluid, j);
    claim.equal("first and middle line", model, lines.first, (lines.pressure + lines.volume).eval());
    claim.equal("middle and last line", model, lines.volume, lines.metric);
    claim.differs("the middle line as printed", model, lines.first, (lines.pressure + lines.printed).eval());
  });
}

STATEMENT(claim_6_2_barotropic_expansion_end, "the first and the last expression of the expansion") {
  claim.holds();
  claim.degree(160);
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    auto const fluid = draw_medium<S, D::n>(draw, Kind::fluid);
    auto const j = draw_second_jet<S, D::n>(draw);
    Expansion<S, D::n> const lines(fluid, j);
    auto const first = (inertia(fluid, j) + lines.first).eval();
    auto const last = [&](S const& factor) { return (inertia(fluid, j) + lines.pressure + lines.metric * factor).eval(); };
    claim.equal("left side of (6.13)", model, first, last(S(1)));
    claim.equal("and with the right side", model, Eigen::Matrix<S, D::n, 1>(first - metric_force(fluid, j)), medium_equation(fluid, j));
    claim.differs("without the half", model, first, last(S(2)));
    claim.differs("without the metric", model, first, last(S(0)));
  });
}
