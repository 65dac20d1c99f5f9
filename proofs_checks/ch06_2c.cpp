// Scalars: rational (long: double)
// Section 6.2: the Cartan form of a general density and its field equations.
#include "off_shell.hpp"

#include "statement.hpp"

namespace {

using namespace actio;
using namespace actio::checks;

/// The total derivative of the momenta with the chain rule written out: second derivatives of L, each by duals in duals.
///
/// The derivatives at a fixed place, and those by the place, may be left out.
template <class S, int n, int N, class L>
Eigen::Matrix<S, N, 1> expanded_divergence(L const& density, SecondJet<S, n, N> const& j, bool with_points = true, bool with_places = true) {
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
      if (with_points) sum[a] += mixed(mu, a, mu);
      for (int b = 0; b < N; ++b) {
        if (with_places) sum[a] += mixed(n + 1 + b, a, mu) * j.v(b, mu);
        for (int nu = 0; nu <= n; ++nu) sum[a] += mixed(n + 1 + N + N * nu + b, a, mu) * j.w[mu](b, nu);
      }
    }
  return sum;
}

using Two = std::tuple<Dimensions<2, 2>, Dimensions<1, 3>>;

}  // namespace

STATEMENT(eq_6_8, "Euler-Lagrange derivative through the multisymplectic form") {
  claim.corrected("D_{EL}\\mathcal L\\cdot\\mathcal V = (j^1)^*[j^1\\mathcal V\\lrcorner\\Omega_{\\mathcal L}]", "D_{EL}\\mathcal L\\cdot\\mathcal V = -(j^1)^*[j^1\\mathcal V\\lrcorner\\Omega_{\\mathcal L}]",
                  "With $\\Omega = -d\\Theta$, as it is set after (6.6), the sign is the other one.");
  // A density of degree 33 in what is drawn, differentiated twice, times a field of degree 21.
  claim.degree(80);
  over_points<S>(Two{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = D::N;
    OffShell<S, n, N> const m(draw);
    auto const V = draw_variation<S, n, N>(draw, 3);
    auto const lifted = prolonged<n, N>(V)(coordinates(m.first()));
    S const left = m.E.dot(vertical_part(m.first(), V(point_of(m.first())))), right = m.contraction(lifted);
    S const scale = magnitude(m.E) * magnitude(lifted);
    claim.zero("E(V) and the contraction of Omega", model, S(left + right), scale);
    claim.refutes("with the printed sign", model, S(left - right), scale);
  });
}

STATEMENT(eq_6_9, "Euler-Lagrange derivative in coordinates") {
  claim.holds("The wedge with $d^{n+1}x$ is contracted with the variation and pulled back.");
  claim.degree(60);
  over_points<S>(Two{}, [&]<class D>(D, std::string const& model) {
    OffShell<S, D::n, D::N> const m(draw);
    Eigen::Matrix<S, D::N, 1> const force = place_derivative(m.L, m.first());
    auto const written_out = [&](bool points, bool places) { return Eigen::Matrix<S, D::N, 1>(force - expanded_divergence(m.L, m.j, points, places)); };
    claim.zero("written out", model, Eigen::Matrix<S, D::N, 1>(m.E - written_out(true, true)), S(magnitude(force) + magnitude(m.E)));
    claim.differs("without the mixed derivative in x", model, m.E, written_out(false, true));
    claim.differs("without the mixed derivative in y", model, m.E, written_out(true, false));
  });
}

STATEMENT(eq_6_10, "Cartan form in coordinates for a general Lagrangian") {
  claim.holds();
  claim.degree(50);
  over_points<S>(Two{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = D::N;
    OffShell<S, n, N> const m(draw);
    auto const at = coordinates(m.first());
    auto const V = draw_tangents<S, OffShell<S, n, N>::dimension, n + 1>(draw);
    auto const p = momenta(m.L, m.first());
    S const L = m.L(m.first()), contracted = p.cwiseProduct(m.j.v).sum(), scale = magnitude(p) * S(N * (n + 1)) + magnitude(L);
    S const theta = cartan_form<n, N>(m.L)(at, V);
    claim.zero("in coordinates", model, S(theta - by_exterior_products<n, N>(p, S(L - contracted), at, V)), scale);
    claim.refutes("with L alone in the last term", model, S(theta - by_exterior_products<n, N>(p, L, at, V)), scale);
    // As the pull-back of the canonical form by the Legendre transformation.
    auto const transformation = [&m]<class T, int rows>(Eigen::Matrix<T, rows, 1> const& c) { return coordinates(legendre(m.L, jet_at<n, N>(c))); };
    claim.zero("as a pull-back by the Legendre transformation", model, S(theta - pull_back(transformation, canonical_form<n, N>())(at, V)), scale);
  });
}

STATEMENT(cor_6_2_1, "Lagrangian density recovered from the Cartan form") {
  claim.holds();
  claim.degree(50);
  over_points<S>(Two{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = D::N;
    OffShell<S, n, N> const m(draw);
    auto const psi = draw_section<S, n, N>(draw);
    auto const theta = cartan_form<n, N>(m.L);
    S const scale = magnitude(m.L(m.first())) + magnitude(momenta(m.L, m.first())) * magnitude(m.j.v);
    claim.zero("along jets of sections", model, S(coefficient_of(pull_back(jet_extension(m.phi), theta), m.x) - m.L(m.first())), scale);
    auto const z = not_holonomic(m.phi, psi);
    claim.refutes("along a section of the jet bundle that is no jet", model, S(coefficient_of(pull_back(z, theta), m.x) - m.L(jet_at<n, N>(z(m.x)))), scale);
  });
}

STATEMENT(claim_6_2_el_by_contraction, "field equations as contractions with arbitrary vector fields on the jet bundle") {
  claim.holds("The sections are those of $Y$: for sections of the jet bundle that are no jets, the density has to be regular.");
  claim.degree(80);
  over_points<S>(Two{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = D::N, all = OffShell<S, n, N>::dimension;
    using W = Eigen::Matrix<S, all, 1>;
    OffShell<S, n, N> const m(draw);
    // All fields on the jet bundle, whatever their part along the derivatives.
    W const any = draw.vector<S, W>(all);
    Variation<S, n, N> const below = any.template head<n + 1 + N>();
    S const scale = magnitude(m.E) * S(all) + magnitude(momenta(m.L, m.first()));
    claim.zero("the contraction is -E_a(W^a - v^a_mu W^mu)", model, S(m.contraction(any) + m.E.dot(vertical_part(m.first(), below))), scale);
    // Conversely, the coordinate fields along the fibres give all field equations.
    Eigen::Matrix<S, N, 1> found;
    for (int a = 0; a < N; ++a) found[a] = -m.contraction(W::Unit(n + 1 + a));
    claim.equal("the fields d/dy^a give all of them", model, found, m.E);
    // With a force that makes the section a solution at the point.
    auto const solved = with_force(m.L, Eigen::Matrix<S, N, 1>(-m.E));
    claim.zero("every contraction vanishes on a solution", model, m.contraction(any, jet_extension(m.phi), solved), scale);
    claim.refutes("every contraction vanishes on any section", model, m.contraction(any), scale);
    W upright = any;
    upright.template head<n + 1 + N>().setZero();
    claim.zero("fields along the derivatives give nothing on jets", model, m.contraction(upright), scale);
    claim.refutes("and on what is no jet", model, m.contraction(upright, not_holonomic(m.phi, draw_section<S, n, N>(draw)), m.L), scale);
  });
}

STATEMENT(eq_6_12, "field Euler-Lagrange equations in total-derivative form") {
  claim.holds();
  claim.degree(60);
  over_points<S>(Two{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = D::N;
    using Column = Eigen::Matrix<S, N, 1>;
    OffShell<S, n, N> const m(draw);
    // Momenta as functions on space-time, differentiated there; and at a fixed jet.
    Column total = Column::Zero(), partial = Column::Zero();
    for (int mu = 0; mu <= n; ++mu) {
      auto moved = m.x.template cast<Dual<S>>().eval();
      moved[mu].part[0] = S(1);
      auto fixed = m.first().template cast<Dual<S>>();
      fixed.x = moved;
      auto const p = momenta(m.L, first_jet(m.phi, moved)), q = momenta(m.L, fixed);
      for (int a = 0; a < N; ++a) total[a] += p(a, mu).part[0], partial[a] += q(a, mu).part[0];
    }
    auto const force = place_derivative(m.L, m.first());
    S const scale = magnitude(force) + magnitude(m.E);
    claim.zero("derivatives of the momenta along the section", model, Column(m.E - (force - total)), scale);
    claim.refutes("derivatives at a fixed jet", model, Column(m.E - (force - partial)), scale);
    claim.refutes("with the other sign of the divergence", model, Column(m.E - (force + total)), scale);
  });
}

STATEMENT(claim_6_2_el_forms_equivalent, "the field equations with total derivatives and written out") {
  claim.holds();
  claim.degree(60);
  over_points<S>(Two{}, [&]<class D>(D, std::string const& model) {
    OffShell<S, D::n, D::N> const m(draw);
    claim.equal("(6.12) equals (6.9)", model, momentum_divergence(m.L, m.j), expanded_divergence(m.L, m.j));
    claim.differs("without the derivative in y", model, momentum_divergence(m.L, m.j), expanded_divergence(m.L, m.j, true, false));
  });
}
