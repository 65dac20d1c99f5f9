// Scalars: rational (long: double)
// Section 6.2: the density of a continuous medium, its Legendre transformation, its energy and its Cartan form.
#include "medium_at_a_jet.hpp"

#include "statement.hpp"
#include "variations.hpp"

namespace {

using namespace actio;
using namespace actio::checks;

using Media = std::tuple<Dimensions<2, 2>, Dimensions<3, 3>, Dimensions<1, 3>>;

}  // namespace

STATEMENT(eq_6_3, "Lagrangian density of a continuous medium") {
  claim.corrected("d^{m+1}x", "d^{n+1}x", "The rest is the definition. It is a density, the same form in all charts of the body, where the stored energy is a scalar.");
  claim.maybe_scan();
  // A stored energy of third degree in metrics of degree 26.
  claim.degree(200);
  over_points<S>(Media{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = D::N;
    MediumAtAJet<S, n, N> const m(draw);
    S const K = m.root * m.mass * m.kinetic(), P = m.root * m.mass * m.energy();
    claim.equal("K - P", model, m.L(m.j), S(K - P));
    claim.differs("K + P", model, m.L(m.j), S(K + P));
    // The same medium in another chart of the body, with the derivatives A of the old coordinates by the new.
    using M = Eigen::Matrix<S, n, n>;
    M A = M::Identity();
    for (int i = 0; i < n; ++i) A.col(i) += draw.vector<S, Eigen::Matrix<S, n, 1>>(n) * ratio<S>(1, 4);
    auto other = m.j;
    other.v.template rightCols<n>() = m.j.gradient() * A;
    auto const solid = draw_solid<S>(draw);
    auto const density = [&](M const& G, Jet<S, n, N> const& j) {
      return Continuum{ConstantMetric<S, n>{G}, ConstantMetric<S, N>{m.g}, Homogeneous<S>{m.mass}, solid}(j);
    };
    M const G = pulled_back(m.G, A);
    S const here = density(m.G, m.j), there = density(G, other);
    // One inverse, that of G in the energy.
    claim.equal("in another chart of the body", model, there, S(here * determinant(A)), 10);
    claim.differs("without the root of det G", model, S(there / volume<S>(G)), S(here / m.root * determinant(A)));
    // The printed exponent names no dimension that there is; as N it gives a form of another degree.
    if (n != N) claim.differs("printed: with m read as the dimension of the space", model, S(n + 1), S(N + 1));
  });
}

STATEMENT(eq_6_4, "conjugate momenta of the continuum Lagrangian") {
  claim.holds();
  claim.degree(200);
  over_points<S>(Media{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = D::N;
    MediumAtAJet<S, n, N> const m(draw);
    auto const p = momenta(m.L, m.j);
    auto const printed = m.printed_momenta();
    using F = Eigen::Matrix<S, N, n>;
    using V = Eigen::Matrix<S, N, 1>;
    claim.equal("p^0", model, V(p.col(0)), V(printed.col(0)));
    claim.equal("p^j", model, F(p.template rightCols<n>()), F(printed.template rightCols<n>()));
    claim.differs("p^0 with the half of the kinetic energy", model, V(p.col(0)), V(printed.col(0) / S(2)));
    claim.differs("p^j with the other sign", model, F(p.template rightCols<n>()), F(-printed.template rightCols<n>()));
    claim.differs("without the mass density", model, p, Eigen::Matrix<S, N, n + 1>(printed / m.mass));
    S contracted(0);
    for (int mu = 0; mu <= n; ++mu) contracted += printed.col(mu).dot(m.j.v.col(mu));
    claim.equal("Pi = L - p v", model, legendre(m.L, m.j).Pi, S(m.L(m.j) - contracted));
  });
}

STATEMENT(claim_6_2_affine_momentum, "affine component of the continuum Legendre transformation") {
  claim.holds();
  claim.degree(200);
  over_points<S>(Media{}, [&]<class D>(D, std::string const& model) {
    MediumAtAJet<S, D::n, D::N> const m(draw);
    S const Pi = legendre(m.L, m.j).Pi, gradient = m.energy_gradient().cwiseProduct(m.j.gradient()).sum(), weight = m.mass * m.root;
    // Three terms cancel in Pi: their sizes are within ten times its own.
    claim.zero("in terms of W", model, S(Pi - (-m.kinetic() - m.energy() + gradient) * weight), S(magnitude(m.kinetic()) + magnitude(m.energy()) + magnitude(gradient)) * weight);
    claim.differs("kinetic energy with the other sign", model, Pi, S((m.kinetic() - m.energy() + gradient) * weight));
  });
}

STATEMENT(eq_6_5, "energy density of the continuum Lagrangian") {
  claim.holds("The factor $\\sqrt{\\det G}$ is part of $e$, which is a density: (6.5) makes $e\\,d^{n+1}x$ the sum of $\\mathbb K$ and $\\mathbb P$.");
  claim.degree(200);
  over_points<S>(Media{}, [&]<class D>(D, std::string const& model) {
    MediumAtAJet<S, D::n, D::N> const m(draw);
    S const e = energy_density(m.L, m.j), K = m.root * m.mass * m.kinetic(), P = m.root * m.mass * m.energy();
    claim.zero("p^0 v_0 - L is K + P", model, S(e - K - P), S(magnitude(K) + magnitude(P)));
    claim.differs("without the root of det G", model, e, S((K + P) / m.root));
    claim.differs("the density itself", model, e, m.L(m.j));
  });
}

STATEMENT(claim_6_2_energy_two_expressions, "the two expressions of the energy density compared") {
  claim.holds("They agree because $\\mathbb K$ is quadratic in the velocity and $\\mathbb P$ does not depend on it.");
  claim.degree(200);
  over_points<S>(Media{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = D::N;
    MediumAtAJet<S, n, N> const m(draw);
    S const K = m.root * m.mass * m.kinetic(), P = m.root * m.mass * m.energy();
    auto const p = momenta(m.L, m.j);
    claim.equal("p^0 v_0 is 2K", model, p.col(0).dot(m.j.velocity()), S(K + K));
    claim.zero("their difference", model, S(energy_density(m.L, m.j) - K - P), S(magnitude(K) + magnitude(P)));
    // A kinetic energy of fourth degree in the velocity.
    auto const quartic = [&m]<class T>(Jet<T, n, N> const& j) {
      T const square = inner(m.L.g(j.y), j.velocity(), j.velocity());
      return T(square * square * T(20) + m.L(j));
    };
    S const square = m.kinetic() * S(2);
    claim.differs("with a kinetic energy of fourth degree", model, energy_density(quartic, m.j), S(square * square * S(20) + K + P));
  });
}

STATEMENT(claim_6_2_affine_momentum_energy, "affine momentum component in terms of the energy density") {
  claim.corrected("\\Pi = -p_a{}^jv^a{}_j - \\sqrt{\\det G}\\,e", "\\Pi = -p_a{}^jv^a{}_j - e",
                  "The energy density of (6.5) already carries $\\sqrt{\\det G}$; the printed form is right where $\\det G = 1$.");
  claim.degree(200);
  over_points<S>(Media{}, [&]<class D>(D, std::string const& model) {
    MediumAtAJet<S, D::n, D::N> const m(draw);
    S const Pi = legendre(m.L, m.j).Pi, e = energy_density(m.L, m.j), sum = m.sum_of_spatial_momenta();
    S const scale = magnitude(sum) + magnitude(m.mass * m.root) * (magnitude(m.kinetic()) + magnitude(m.energy()));
    claim.zero("Pi + p^j v_j + e", model, S(Pi + sum + e), scale);
    claim.refutes("printed: e times the root of det G", model, S(Pi + sum + m.root * e), scale);
  });
}

STATEMENT(eq_6_6, "Cartan form of the continuum Lagrangian") {
  claim.holds();
  claim.degree(220);
  over_points<S>(std::tuple<Dimensions<2, 2>, Dimensions<1, 3>>{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = D::N, all = Jet<S, n, N>::dimension;
    MediumAtAJet<S, n, N> const m(draw);
    auto p = m.printed_momenta();
    S const Pi = (-m.kinetic() - m.energy() + m.energy_gradient().cwiseProduct(m.j.gradient()).sum()) * m.mass * m.root;
    auto const at = coordinates(m.j);
    auto const V = draw_tangents<S, all, n + 1>(draw);
    S const theta = cartan_form<n, N>(m.L)(at, V), terms = by_exterior_products<n, N>(p, Pi, at, V);
    S const scale = magnitude(p) * S(N * (n + 1)) + magnitude(Pi);
    claim.zero("in coordinates", model, S(theta - terms), scale);
    p.template rightCols<n>() = -p.template rightCols<n>();
    claim.refutes("spatial momenta with the other sign", model, S(theta - by_exterior_products<n, N>(p, Pi, at, V)), scale);
  });
}
