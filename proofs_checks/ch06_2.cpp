// Section 6.2: the density of a continuous medium, its Legendre transformation, its energy and its Cartan
// form.

#include "fields/fields.hpp"
#include "fields/medium_at_a_jet.hpp"
#include "fields/off_shell.hpp"
#include "fields/variations.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

using Media = std::tuple<Dimensions<2, 2>, Dimensions<3, 3>, Dimensions<1, 3>>;

}  // namespace

STATEMENT(eq_6_3, "Lagrangian density of a continuous medium") {
  claim.corrected("d^{m+1}x", "d^{n+1}x",
                  "The rest is the definition. It is a density, the same form in all charts of the body, "
                  "where the stored energy is a scalar.");
  claim.maybe_scan();
  // A stored energy of third degree in metrics of degree 26.
  over_dimensions(Media{}, [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
    MediumAtAJet<S, n, N> const m(draw);
    S const K = m.root * m.mass * m.kinetic(), P = m.root * m.mass * m.energy();
    claim.equal("K - P", model, m.L(m.j), S(K - P));
    claim.differs("K + P", model, m.L(m.j), S(K + P));
    // The same medium in another chart of the body, with the derivatives A of the old coordinates by the new.
    using M = Matrix<S, n, n>;
    M A = M::Identity();
    for (int i = 0; i < n; ++i) A.col(i) += draw.vector<S, Matrix<S, n, 1>>(n) * ratio<S>(1, 4);
    auto other = m.j;
    other.v.template rightCols<n>() = m.j.gradient() * A;
    auto const solid = draw_solid<S>(draw);
    auto const density = [&](M const& G, Jet<S, n, N> const& j) {
      return Continuum{ConstantMetric<S, n>{G}, ConstantMetric<S, N>{m.g}, Homogeneous<S>{m.mass}, solid}(j);
    };
    draw_positive(S(determinant(A)));
    M const G = pulled_back(m.G, A);
    S const here = density(m.G, m.j), there = density(G, other);
    // One inverse, that of G in the energy.
    claim.equal("in another chart of the body", model, there, S(here * determinant(A)), 10);
    claim.differs("without the root of det G", model, S(there / volume<S>(G)),
                  S(here / m.root * determinant(A)));
    // And in another chart of space, with the derivatives B of the old coordinates by the new.
    using Square = Matrix<S, N, N>;
    Square B = Square::Identity();
    for (int i = 0; i < N; ++i) B.col(i) += draw.vector<S, Matrix<S, N, 1>>(N) * ratio<S>(1, 4);
    auto placed = m.j;
    placed.v = inverse_matrix(B) * m.j.v;
    auto const in_space = [&](Square const& g) {
      return Continuum{ConstantMetric<S, n>{m.G}, ConstantMetric<S, N>{g}, Homogeneous<S>{m.mass},
                       solid}(placed);
    };
    claim.equal("in another chart of space", model, in_space(pulled_back(m.g, B)), here, 10);
    claim.differs("the metric of space left as it is", model, in_space(m.g), here);
    // The printed exponent names no dimension that there is. As N it makes a form of degree N + 1: on a body
    // of fewer dimensions a differential stands in it twice.
    if constexpr (n < N) {
      auto const sides = draw_tangents<S, n + 1, n + 1>(draw);
      Matrix<S, N + 1, N + 1> all = Matrix<S, N + 1, N + 1>::Identity();
      for (int i = 0; i <= N; ++i)
        for (int k = 0; k <= N; ++k) all(i, k) = sides(i % (n + 1), k % (n + 1));
      claim.differs("printed: with m read as the dimension of the space", model,
                    S(m.L(m.j) * determinant(all)), S(m.L(m.j) * determinant(sides)));
    }
  });
}

STATEMENT(eq_6_4, "conjugate momenta of the continuum Lagrangian") {
  claim.holds();
  over_dimensions(Media{}, [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
    MediumAtAJet<S, n, N> const m(draw);
    auto const p = momenta(m.L, m.j);
    auto const printed = m.printed_momenta();
    using F = Matrix<S, N, n>;
    using V = Matrix<S, N, 1>;
    claim.equal("p^0", model, V(p.col(0)), V(printed.col(0)));
    claim.equal("p^j", model, F(p.template rightCols<n>()), F(printed.template rightCols<n>()));
    claim.differs("p^0 with the half of the kinetic energy", model, V(p.col(0)), V(printed.col(0) / S(2)));
    claim.differs("p^j with the other sign", model, F(p.template rightCols<n>()),
                  F(-printed.template rightCols<n>()));
    claim.differs("without the mass density", model, p, Matrix<S, N, n + 1>(printed / m.mass));
    S contracted(0);
    for (int mu = 0; mu <= n; ++mu) contracted += printed.col(mu).dot(m.j.v.col(mu));
    claim.equal("Pi = L - p v", model, legendre(m.L, m.j).Pi, S(m.L(m.j) - contracted));
  });
}

STATEMENT(claim_6_2_affine_momentum, "affine component of the continuum Legendre transformation") {
  claim.holds();
  over_dimensions(Media{}, [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
    MediumAtAJet<S, n, N> const m(draw);
    S const Pi = legendre(m.L, m.j).Pi, gradient = m.energy_gradient().cwiseProduct(m.j.gradient()).sum(),
            weight = m.mass * m.root;
    // Three terms cancel in Pi: their sizes are within ten times its own.
    claim.zero("in terms of W", model, S(Pi - (-m.kinetic() - m.energy() + gradient) * weight),
               S(magnitude(m.kinetic()) + magnitude(m.energy()) + magnitude(gradient)) * weight);
    claim.differs("kinetic energy with the other sign", model, Pi,
                  S((m.kinetic() - m.energy() + gradient) * weight));
  });
}

STATEMENT(eq_6_5, "energy density of the continuum Lagrangian") {
  claim.holds(
      "The factor $\\sqrt{\\det G}$ is part of $e$, which is a density: (6.5) makes $e\\,d^{n+1}x$ the sum "
      "of $\\mathbb K$ and $\\mathbb P$.");
  over_dimensions(Media{}, [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
    MediumAtAJet<S, n, N> const m(draw);
    S const e = energy_density(m.L, m.j), K = m.root * m.mass * m.kinetic(), P = m.root * m.mass * m.energy();
    claim.zero("p^0 v_0 - L is K + P", model, S(e - K - P), S(magnitude(K) + magnitude(P)));
    claim.differs("without the root of det G", model, e, S((K + P) / m.root));
    claim.differs("the density itself", model, e, m.L(m.j));
  });
}

STATEMENT(claim_6_2_energy_two_expressions, "the two expressions of the energy density compared") {
  claim.holds(
      "They agree because $\\mathbb K$ is quadratic in the velocity and $\\mathbb P$ does not depend on it.");
  over_dimensions(Media{}, [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
    MediumAtAJet<S, n, N> const m(draw);
    S const K = m.root * m.mass * m.kinetic(), P = m.root * m.mass * m.energy();
    auto const p = momenta(m.L, m.j);
    claim.equal("p^0 v_0 is 2K", model, p.col(0).dot(m.j.velocity()), S(K + K));
    claim.zero("their difference", model, S(energy_density(m.L, m.j) - K - P),
               S(magnitude(K) + magnitude(P)));
    // A kinetic energy of fourth degree in the velocity.
    auto const quartic = [&m]<class T>(Jet<T, n, N> const& j) {
      T const square = inner(m.L.g(j.y), j.velocity(), j.velocity());
      return T(square * square * T(20) + m.L(j));
    };
    S const square = m.kinetic() * S(2);
    claim.differs("with a kinetic energy of fourth degree", model, energy_density(quartic, m.j),
                  S(square * square * S(20) + K + P));
  });
}

STATEMENT(claim_6_2_affine_momentum_energy, "affine momentum component in terms of the energy density") {
  claim.corrected("\\Pi = -p_a{}^jv^a{}_j - \\sqrt{\\det G}\\,e", "\\Pi = -p_a{}^jv^a{}_j - e",
                  "The energy density of (6.5) already carries $\\sqrt{\\det G}$; the printed "
                  "form is right where $\\det G = 1$.");
  over_dimensions(Media{}, [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
    MediumAtAJet<S, n, N> const m(draw);
    S const Pi = legendre(m.L, m.j).Pi, e = energy_density(m.L, m.j), sum = m.sum_of_spatial_momenta();
    S const scale =
        magnitude(sum) + magnitude(m.mass * m.root) * (magnitude(m.kinetic()) + magnitude(m.energy()));
    claim.zero("Pi + p^j v_j + e", model, S(Pi + sum + e), scale);
    claim.refutes("printed: e times the root of det G", model, S(Pi + sum + m.root * e), scale);
  });
}

STATEMENT(eq_6_6, "Cartan form of the continuum Lagrangian") {
  claim.holds();
  using Dims = std::tuple<Dimensions<2, 2>, Dimensions<1, 3>, Dimensions<3, 3>>;
  over_dimensions(Dims{}, [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
    constexpr int all = Jet<S, n, N>::dimension;
    MediumAtAJet<S, n, N> const m(draw);
    auto p = m.printed_momenta();
    S const Pi = (-m.kinetic() - m.energy() + m.energy_gradient().cwiseProduct(m.j.gradient()).sum()) *
                 m.mass * m.root;
    auto const at = coordinates(m.j);
    auto const V = draw_tangents<S, all, n + 1>(draw);
    S const theta = cartan_form<n, N>(m.L)(at, V), terms = by_exterior_products<n, N>(p, Pi, at, V);
    S const scale = magnitude(p) * S(N * (n + 1)) + magnitude(Pi);
    claim.zero("in coordinates", model, S(theta - terms), scale);
    p.template rightCols<n>() = -p.template rightCols<n>();
    claim.refutes("spatial momenta with the other sign", model,
                  S(theta - by_exterior_products<n, N>(p, Pi, at, V)), scale);
  });
}

// ----
// Section 6.2: the Cartan form of a general density and its field equations.

namespace {

/// The total derivative of the momenta with the chain rule written out: second derivatives of L, each by
/// duals in duals.
///
/// The derivatives at a fixed point of space, and those by the point, may be left out.
template <class S, int n, int N, class L>
Matrix<S, N, 1> expanded_divergence(L const& density, SecondJet<S, n, N> const& j, bool with_points = true,
                                    bool with_places = true) {
  using First = Dual<S>;
  using Second = Dual<First>;
  Matrix<S, N, 1> sum = Matrix<S, N, 1>::Zero();
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

using Three = std::tuple<Dimensions<2, 2>, Dimensions<1, 3>, Dimensions<3, 1>>;

}  // namespace

STATEMENT(eq_6_8, "Euler-Lagrange derivative through the multisymplectic form") {
  claim.corrected(
      "D_{EL}\\mathcal L\\cdot\\mathcal V = (j^1)^*[j^1\\mathcal V\\lrcorner\\Omega_{\\mathcal L}]",
      "D_{EL}\\mathcal L\\cdot\\mathcal V = -(j^1)^*[j^1\\mathcal V\\lrcorner\\Omega_{\\mathcal L}]",
      "With $\\Omega = -d\\Theta$, as it is set after (6.6), the sign is the other one.");
  // A density of degree 33 in what is drawn, differentiated twice, times a field of degree 21.
  over_dimensions(Three{}, [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
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
  over_dimensions(Three{}, [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
    OffShell<S, n, N> const m(draw);
    Matrix<S, N, 1> const force = partial_y(m.L, m.first());
    auto const written_out = [&](bool points, bool places) {
      return Matrix<S, N, 1>(force - expanded_divergence(m.L, m.j, points, places));
    };
    claim.zero("written out", model, Matrix<S, N, 1>(m.E - written_out(true, true)),
               S(magnitude(force) + magnitude(m.E)));
    claim.differs("without the mixed derivative in x", model, m.E, written_out(false, true));
    claim.differs("without the mixed derivative in y", model, m.E, written_out(true, false));
  });
}

STATEMENT(eq_6_10, "Cartan form in coordinates for a general Lagrangian") {
  claim.holds();
  over_dimensions(Three{}, [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
    OffShell<S, n, N> const m(draw);
    auto const at = coordinates(m.first());
    auto const V = draw_tangents<S, OffShell<S, n, N>::dimension, n + 1>(draw);
    auto const p = momenta(m.L, m.first());
    S const L = m.L(m.first()), contracted = p.cwiseProduct(m.j.v).sum(),
            scale = magnitude(p) * S(N * (n + 1)) + magnitude(L);
    S const theta = cartan_form<n, N>(m.L)(at, V);
    claim.zero("in coordinates", model, S(theta - by_exterior_products<n, N>(p, S(L - contracted), at, V)),
               scale);
    claim.refutes("with L alone in the last term", model, S(theta - by_exterior_products<n, N>(p, L, at, V)),
                  scale);
    // As the pull-back of the canonical form by the Legendre transformation.
    auto const transformation = [&m]<class T, int rows>(Matrix<T, rows, 1> const& c) {
      return coordinates(legendre(m.L, jet_at<n, N>(c)));
    };
    claim.zero("as a pull-back by the Legendre transformation", model,
               S(theta - pull_back(transformation, canonical_form<n, N>())(at, V)), scale);
  });
}

STATEMENT(cor_6_2_1, "Lagrangian density recovered from the Cartan form") {
  claim.holds();
  over_dimensions(Three{}, [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
    OffShell<S, n, N> const m(draw);
    auto const psi = draw_section<S, n, N>(draw);
    auto const theta = cartan_form<n, N>(m.L);
    S const scale = magnitude(m.L(m.first())) + magnitude(momenta(m.L, m.first())) * magnitude(m.j.v);
    claim.zero("along jets of sections", model,
               S(coefficient_of(pull_back(jet_extension(m.phi), theta), m.x) - m.L(m.first())), scale);
    auto const z = not_holonomic(m.phi, psi);
    claim.refutes("along a section of the jet bundle that is no jet", model,
                  S(coefficient_of(pull_back(z, theta), m.x) - m.L(jet_at<n, N>(z(m.x)))), scale);
  });
}

STATEMENT(claim_6_2_el_by_contraction,
          "field equations as contractions with arbitrary vector fields on the jet bundle") {
  claim.holds(
      "The sections are those of $Y$. Along a section of the jet bundle that is no jet, fields along the "
      "derivatives need not give zero.");
  over_dimensions(Three{}, [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
    constexpr int all = OffShell<S, n, N>::dimension;
    using W = Matrix<S, all, 1>;
    OffShell<S, n, N> const m(draw);
    // All fields on the jet bundle, whatever their part along the derivatives.
    W const any = draw.vector<S, W>(all);
    Variation<S, n, N> const below = any.template head<n + 1 + N>();
    S const scale = magnitude(m.E) * S(all) + magnitude(momenta(m.L, m.first()));
    claim.zero("the contraction is -E_a(W^a - v^a_mu W^mu)", model,
               S(m.contraction(any) + m.E.dot(vertical_part(m.first(), below))), scale);
    // Conversely, the coordinate fields along the fibres give all field equations.
    Matrix<S, N, 1> found;
    for (int a = 0; a < N; ++a) found[a] = -m.contraction(W::Unit(n + 1 + a));
    claim.equal("the fields d/dy^a give all of them", model, found, m.E);
    // With a force that makes the section a solution at the point.
    auto const solved = with_force(m.L, Matrix<S, N, 1>(-m.E));
    claim.zero("every contraction vanishes on a solution", model,
               m.contraction(any, jet_extension(m.phi), solved), scale);
    claim.refutes("every contraction vanishes on any section", model, m.contraction(any), scale);
    W upright = any;
    upright.template head<n + 1 + N>().setZero();
    claim.zero("fields along the derivatives give nothing on jets", model, m.contraction(upright), scale);
    claim.refutes("and on what is no jet", model,
                  m.contraction(upright, not_holonomic(m.phi, draw_section<S, n, N>(draw)), m.L), scale);
  });
}

STATEMENT(eq_6_12, "field Euler-Lagrange equations in total-derivative form") {
  claim.holds();
  over_dimensions(Three{}, [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
    using Column = Matrix<S, N, 1>;
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
    auto const force = partial_y(m.L, m.first());
    S const scale = magnitude(force) + magnitude(m.E);
    claim.zero("derivatives of the momenta along the section", model, Column(m.E - (force - total)), scale);
    claim.refutes("derivatives at a fixed jet", model, Column(m.E - (force - partial)), scale);
    claim.refutes("with the other sign of the divergence", model, Column(m.E - (force + total)), scale);
  });
}

STATEMENT(claim_6_2_el_forms_equivalent, "the field equations with total derivatives and written out") {
  claim.holds();
  over_dimensions(Three{}, [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
    OffShell<S, n, N> const m(draw);
    claim.equal("(6.12) equals (6.9)", model, momentum_divergence(m.L, m.j), expanded_divergence(m.L, m.j));
    claim.differs("without the derivative in x", model, momentum_divergence(m.L, m.j),
                  expanded_divergence(m.L, m.j, false, true));
    claim.differs("without the derivative in y", model, momentum_divergence(m.L, m.j),
                  expanded_divergence(m.L, m.j, true, false));
  });
}
