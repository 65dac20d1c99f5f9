// Scalars: rational, double
// Section 6.2: the Euler-Lagrange equations of a general density.
#include "fields.hpp"

#include "actio/jets/cartan.hpp"
#include "actio/jets/field_equations.hpp"
#include "statement.hpp"

namespace {

using namespace actio;
using namespace actio::checks;

/// The total derivative of the momenta with the chain rule written out: second derivatives of L, each by duals in duals.
template <class S, int n, int N, class L>
Eigen::Matrix<S, N, 1> expanded_divergence(L const& density, SecondJet<S, n, N> const& j, bool with_places = true) {
  using First = Dual<S>;
  using Second = Dual<First>;
  Eigen::Matrix<S, N, 1> sum = Eigen::Matrix<S, N, 1>::Zero();
  // d2 L / (d of) (d v^a_mu), where `of` names a coordinate of the jet bundle.
  auto const mixed = [&](int of, int a, int mu) {
    auto c = coordinates(static_cast<Jet<S, n, N> const&>(j)).template cast<Second>().eval();
    c[of].value.part[0] += S(1);
    c[n + 1 + N + N * mu + a].part[0] += First(S(1));
    return S(density(jet_at<n, N>(c)).part[0].part[0]);
  };
  for (int a = 0; a < N; ++a)
    for (int mu = 0; mu <= n; ++mu) {
      sum[a] += mixed(mu, a, mu);
      for (int b = 0; b < N; ++b) {
        if (with_places) sum[a] += mixed(n + 1 + b, a, mu) * j.v(b, mu);
        for (int nu = 0; nu <= n; ++nu) sum[a] += mixed(n + 1 + N + N * nu + b, a, mu) * j.w[mu](b, nu);
      }
    }
  return sum;
}

}  // namespace

STATEMENT(claim_6_2_el_forms_equivalent, "the field equations with total derivatives and written out") {
  claim.holds();
  // A density of degree 4 and a section of degree 3, twice differentiated.
  claim.degree(16);
  over_dimensions(AllDimensions{}, [&]<class D>(D, std::string const& model) {
    auto const L = draw_density<S, D::n, D::N>(draw);
    auto const phi = draw_section<S, D::n, D::N>(draw);
    auto const j = second_jet(phi, draw_event<S, D::n>(draw));
    claim.equal("(6.12) equals (6.9)", model, momentum_divergence(L, j), expanded_divergence(L, j));
    claim.differs("without the derivative in y", model, momentum_divergence(L, j), expanded_divergence(L, j, false));
  });
}
