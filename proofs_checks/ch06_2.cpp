// Section 6.2: the density of a continuous medium, its Legendre transformation, its energy and its Cartan
// form.

#include "fields.hpp"
#include "medium_at_a_jet.hpp"
#include "off_shell.hpp"
#include "statement.hpp"
#include "variations.hpp"

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
  over_points<S>(Media{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = D::N;
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
    // The printed exponent names no dimension that there is; as N it gives a form of another degree.
    if (n != N)
      claim.differs("printed: with m read as the dimension of the space", model, S(n + 1), S(N + 1));
  });
}

STATEMENT(eq_6_4, "conjugate momenta of the continuum Lagrangian") {
  claim.holds();
  over_points<S>(Media{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = D::N;
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
  over_points<S>(Media{}, [&]<class D>(D, std::string const& model) {
    MediumAtAJet<S, D::n, D::N> const m(draw);
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
  over_points<S>(Media{}, [&]<class D>(D, std::string const& model) {
    MediumAtAJet<S, D::n, D::N> const m(draw);
    S const e = energy_density(m.L, m.j), K = m.root * m.mass * m.kinetic(), P = m.root * m.mass * m.energy();
    claim.zero("p^0 v_0 - L is K + P", model, S(e - K - P), S(magnitude(K) + magnitude(P)));
    claim.differs("without the root of det G", model, e, S((K + P) / m.root));
    claim.differs("the density itself", model, e, m.L(m.j));
  });
}

STATEMENT(claim_6_2_energy_two_expressions, "the two expressions of the energy density compared") {
  claim.holds(
      "They agree because $\\mathbb K$ is quadratic in the velocity and $\\mathbb P$ does not depend on it.");
  over_points<S>(Media{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = D::N;
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
                  "The energy density of (6.5) already carries $\\sqrt{\\det G}$; the printed form is right "
                  "where $\\det G = 1$.");
  over_points<S>(Media{}, [&]<class D>(D, std::string const& model) {
    MediumAtAJet<S, D::n, D::N> const m(draw);
    S const Pi = legendre(m.L, m.j).Pi, e = energy_density(m.L, m.j), sum = m.sum_of_spatial_momenta();
    S const scale =
        magnitude(sum) + magnitude(m.mass * m.root) * (magnitude(m.kinetic()) + magnitude(m.energy()));
    claim.zero("Pi + p^j v_j + e", model, S(Pi + sum + e), scale);
    claim.refutes("printed: e times the root of det G", model, S(Pi + sum + m.root * e), scale);
  });
}

STATEMENT(eq_6_6, "Cartan form of the continuum Lagrangian") {
  claim.holds();
  over_points<S>(std::tuple<Dimensions<2, 2>, Dimensions<1, 3>>{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = D::N, all = Jet<S, n, N>::dimension;
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
// Section 6.2: the variational principle and the multisymplectic form formula. Variations move space-time as
// well; integrals over boxes are exact.

namespace {

/// \f$E_a\,(V^a - \phi^a{}_{,\mu}V^\mu)\f$, or \f$E_aV^a\f$ if variations are taken for vertical ones.
template <class S, int n, int N, class L>
S bulk(L const& density, SecondJet<S, n, N> const& j, Variation<S, n, N> const& V, bool horizontal = true) {
  Matrix<S, N, 1> const E = euler_lagrange(density, j);
  return E.dot(horizontal ? vertical_part(static_cast<Jet<S, n, N> const&>(j), V)
                          : Matrix<S, N, 1>(V.template tail<N>()));
}

/// The boundary current of a variation along a section; without the last term of the Cartan form only
/// vertical variations have it right.
template <class L, class Phi, class Field>
auto current_along(L const& density, Phi const& phi, Field const& V, bool complete = true) {
  return [&density, &phi, &V, complete]<class T, int rows>(Matrix<T, rows, 1> const& x) {
    auto const j = first_jet(phi, x);
    auto const rate = V(point_of(j));
    auto B = boundary_current(density, j, rate);
    if (!complete) {
      T const Pi = legendre(density, j).Pi;
      for (int mu = 0; mu < rows; ++mu) B[mu] -= Pi * rate[mu];
    }
    return B;
  };
}

/// An n-form \f$B^\mu\,d^nx_\mu\f$ on space-time from its components.
template <class Field>
auto as_form(Field const& B) {
  return [B]<class T, int rows>(Matrix<T, rows, 1> const& x, Tangents<T, rows, rows - 1> const& V) -> T {
    Matrix<T, rows, rows> all;
    all << B(x), V;
    return determinant(all);
  };
}

/// A field on Y that vanishes on the boundary of a box: any other, times a product of the distances from its
/// faces.
template <class S, int n, class Field>
struct Inside {
  Field V;
  Box<S, n> box;
  template <class X>
  auto operator()(X const& point) const {
    using T = ScalarOf<X>;
    T bump(1);
    for (int mu = 0; mu <= n; ++mu)
      bump *= (point[mu] - T(box.low[mu])) * (T(box.high[mu]) - point[mu]) * T(4);
    auto rate = V(point);
    for (int i = 0; i < rate.size(); ++i) rate[i] *= bump;
    return rate;
  }
};

/// The coefficients of the gradient of f in the variation of the density along f times the i-th coordinate
/// field: what a boundary term is made of, without it.
template <class S, int n, int N, class L, class Phi>
Event<S, n> symbol_of_variation(L const& density, Phi const& phi, Event<S, n> const& x, int i) {
  Event<S, n> symbol;
  // With f = x^mu less its value here, the part that is proportional to f vanishes.
  for (int mu = 0; mu <= n; ++mu)
    symbol[mu] =
        density_variation(density, phi, AnyVariation<S, n, N>::coordinate(i, S(-x[mu]), S(1), mu), x);
  return symbol;
}

/// The form \f$a_a{}^\mu\,dy^a\wedge d^nx_\mu + b\,d^{n+1}x\f$ that has this symbol along a section.
template <class S, int n, int N, class L, class Phi>
DualJet<S, n, N> form_from_action(L const& density, Phi const& phi, Event<S, n> const& x) {
  auto const j = first_jet(phi, x);
  DualJet<S, n, N> z{j.x, j.y, S(0), {}};
  for (int a = 0; a < N; ++a)
    z.p.row(a) = symbol_of_variation<S, n, N>(density, phi, x, n + 1 + a).transpose();
  // Along time: b + a_a^mu v^a_mu - a_a^0 v^a_0.
  z.Pi = symbol_of_variation<S, n, N>(density, phi, x, 0)[0] + z.p.col(0).dot(j.v.col(0)) - pairing(z, j);
  return z;
}

/// \f$(dy^1 - v^1{}_\mu dx^\mu)\wedge(dy^2 - v^2{}_\mu dx^\mu)\f$ for n = 1, N = 2: a form on jets that no
/// section sees.
inline auto contact_product() {
  return []<class T, int D>(Matrix<T, D, 1> const& at, Tangents<T, D, 2> const& V) -> T {
    auto const j = jet_at<1, 2>(at);
    Matrix<T, 2, 2> const theta = V.template middleRows<2>(2) - j.v * V.template topRows<2>();
    return determinant(theta);
  };
}

/// The variation along a section of first degree, with derivatives v, that has a given vertical part and
/// moves space-time by any field: \f$(V^\mu, Q^a + v^a{}_\mu V^\mu)\f$.
template <class S, int n, int N>
struct WithVerticalPart {
  Accelerated<S, n, N> vertical;
  AnyVariation<S, n, N> along;
  Matrix<S, N, n + 1> v;
  template <class X>
  auto operator()(X const& point) const {
    using T = ScalarOf<X>;
    Variation<T, n, N> rate = along(point);
    Matrix<T, N, 1> const y = vertical(Event<T, n>(point.template head<n + 1>()));
    for (int a = 0; a < N; ++a) {
      rate[n + 1 + a] = y[a];
      for (int mu = 0; mu <= n; ++mu) rate[n + 1 + a] += rate[mu] * T(v(a, mu));
    }
    return rate;
  }
};

}  // namespace

STATEMENT(eq_6_7, "variation of the field action for arbitrary variations") {
  claim.convention(
      "The derivative $D_{EL}\\mathcal L\\cdot V$ contracts $V$ into $dy^a\\wedge d^{n+1}x$ and pulls back: "
      "it is $E_a(V^a - \\phi^a{}_{,\\mu}V^\\mu)$, and $E_aV^a$ for vertical variations alone.");
  // A density of degree 33 in what is drawn, differentiated twice, times a field on Y of degree 21.
  over_points<S>(SmallDimensions{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = D::N;
    auto const L = draw_density<S, n, N>(draw);
    auto const phi = draw_section<S, n, N>(draw);
    auto const V = draw_variation<S, n, N>(draw, 3);
    auto const x = draw_event<S, n>(draw);
    auto const j = second_jet(phi, x);
    auto const rate = V(graph(phi, x));
    S const left = density_variation(L, phi, V, x), inside = bulk(L, j, rate),
            boundary = divergence(current_along(L, phi, V), x);
    S const scale = magnitude(left) + magnitude(inside) + magnitude(boundary);
    claim.zero("at each point, with the divergence of the boundary term", model, S(left - inside - boundary),
               scale);
    claim.refutes("E_aV^a for a variation that is not vertical", model,
                  S(left - bulk(L, j, rate, false) - boundary), scale);
    claim.refutes("without the term d^{n+1}x of the Cartan form", model,
                  S(left - inside - divergence(current_along(L, phi, V, false), x)), scale);
    claim.refutes("without the boundary term", model, S(left - inside), scale);
    if constexpr (n == 1) {
      auto const form = pull_back(jet_extension(phi), contract(prolonged<n, N>(V), cartan_form<n, N>(L)));
      claim.equal("the boundary term is the pull-back of j1V hook Theta", model, components_of(form, x),
                  Event<S, n>(boundary_current(L, first_jet(phi, x), rate)));
    }
  });
}

STATEMENT(thm_6_2_1, "Euler-Lagrange derivative and Cartan form from the variational principle") {
  claim.corrected(
      "D_{EL}\\mathcal L\\cdot\\mathcal V = (j^1)^*[j^1\\mathcal V\\lrcorner\\Omega_{\\mathcal L}]",
      "D_{EL}\\mathcal L\\cdot\\mathcal V = -(j^1)^*[j^1\\mathcal V\\lrcorner\\Omega_{\\mathcal L}]",
      "(6.7), (6.9) and (6.10) hold; (6.8) has the other sign with $\\Omega = -d\\Theta$, and the form is "
      "unique among the forms $a_a{}^\\mu\\,dy^a\\wedge d^nx_\\mu + b\\,d^{n+1}x$.");
  // Integrals of polynomials of degree 6 in x over a drawn box.
  over_points<S>(SmallDimensions{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = D::N;
    // A section of second degree, a field on Y of first: the density's variation and both terms are of degree
    // 5 at most.
    constexpr int degree = 5;
    auto const L = draw_low_density<S, n, N>(draw);
    auto const phi = draw_section_of_degree<S, n, N>(draw, 2);
    auto const V = draw_variation<S, n, N>(draw, 1);
    auto const box = draw_box<S, n>(draw);
    auto const over_box = [&](auto const& f) { return integral(f, box.low, box.high, degree); };
    S const left = action_variation(L, phi, V, box, degree);
    S const inside =
        over_box([&](Event<S, n> const& x) { return bulk(L, second_jet(phi, x), V(graph(phi, x))); });
    S const wrong =
        over_box([&](Event<S, n> const& x) { return bulk(L, second_jet(phi, x), V(graph(phi, x)), false); });
    S const boundary = boundary_integral(as_form(current_along(L, phi, V)), box, degree);
    S const incomplete = boundary_integral(as_form(current_along(L, phi, V, false)), box, degree);
    S const scale = magnitude(left) + magnitude(inside) + magnitude(boundary);
    // Sums over up to 64 nodes.
    claim.zero("derivative of the action on a box that moves", model, S(left - inside - boundary), scale, 10);
    claim.refutes("E_aV^a for a variation that is not vertical", model, S(left - wrong - boundary), scale);
    claim.refutes("without the term d^{n+1}x of the Cartan form", model, S(left - inside - incomplete),
                  scale);
    // (6.8), with the Cartan form of (6.10).
    auto const x = draw_event<S, n>(draw);
    S const here = bulk(L, second_jet(phi, x), V(graph(phi, x)));
    S const contracted = coefficient_of(
        pull_back(jet_extension(phi), contract(prolonged<n, N>(V), multisymplectic_form<n, N>(L))), x);
    claim.equal("(6.8) with Omega = -dTheta", model, here, S(-contracted), 10);
    claim.differs("(6.8) as printed", model, here, contracted);
  });
}

STATEMENT(claim_6_2_critical_point, "critical points of the action and admissible variations") {
  claim.convention(
      "Admissible variations vanish on the boundary of $U$; with all variations, natural boundary conditions "
      "are imposed as well.");
  over_points<S>(SmallDimensions{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = D::N;
    auto const L = draw_uniform_density<S, n, N>(draw);
    auto const solution = draw_section_of_degree<S, n, N>(draw, 1),
               other = draw_section_of_degree<S, n, N>(draw, 2);
    auto const V = draw_variation<S, n, N>(draw, 1);
    auto const box = draw_box<S, n>(draw);
    Inside<S, n, AnyVariation<S, n, N>> const admissible{V, box};
    // Along the solution: the derivatives of a product of two distances for each coordinate and a polynomial
    // of first degree, all of degree 3 in each of them.
    S const stationary = action_variation(L, solution, admissible, box, 3),
            free = action_variation(L, solution, V, box, 3);
    // Along the other section the momenta are of second degree, the density of third, and the variation of
    // fourth.
    S const elsewhere = action_variation(L, other, admissible, box, 6);
    // Sums over up to 343 nodes.
    claim.zero("dS.V at a solution, V zero on the boundary", model, stationary, magnitude(free), 10);
    claim.refutes("V not zero on the boundary", model, free, S(1));
    claim.refutes("a section that solves nothing", model, elsewhere, magnitude(free));
  });
}

STATEMENT(claim_6_2_vertical_variations, "Cartan form obtained from vertical variations only") {
  claim.holds(
      "The missing term is the whole of $(L - p_a{}^\\mu v^a{}_\\mu)\\,d^{n+1}x$, which vertical "
      "variations do not determine.");
  over_points<S>(SmallDimensions{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = D::N;
    auto const L = draw_density<S, n, N>(draw);
    auto const phi = draw_section<S, n, N>(draw);
    auto const V = draw_variation<S, n, N>(draw, 2), upright = V.upright();
    auto const x = draw_event<S, n>(draw);
    auto const with = [&](auto const& field, bool complete) {
      return Event<S, n>(current_along(L, phi, field, complete)(x));
    };
    claim.equal("boundary term of a vertical variation", model, with(upright, true), with(upright, false));
    claim.differs("boundary term of any variation", model, with(V, true), with(V, false));
    auto const j = second_jet(phi, x);
    // Same field equations from both: a variation along time alone gives them contracted with the velocity.
    auto const along_time = AnyVariation<S, n, N>::coordinate(0, S(1));
    S const rate = density_variation(L, phi, along_time, x),
            boundary = divergence(current_along(L, phi, along_time), x),
            power = euler_lagrange(L, j).dot(j.velocity());
    S const scale = magnitude(rate) + magnitude(boundary) + magnitude(power);
    claim.zero("field equations from a horizontal variation", model, S(rate - boundary + power), scale);
    claim.refutes("with the boundary term of vertical ones", model,
                  S(rate - divergence(current_along(L, phi, along_time, false), x) + power), scale);
  });
}

STATEMENT(claim_6_2_cartan_form_uniqueness, "uniqueness of the form fixed by the variational principle") {
  claim.convention(
      "Unique among the forms $a_a{}^\\mu\\,dy^a\\wedge d^nx_\\mu + b\\,d^{n+1}x$, and only if variations "
      "are not all vertical; a product of contact forms may be added to $\\Theta$ otherwise.");
  over_points<S>(std::tuple<Dimensions<1, 2>>{}, [&](auto, std::string const& model) {
    auto const L = draw_density<S, 1, 2>(draw);
    auto const phi = draw_section<S, 1, 2>(draw);
    auto const x = draw_event<S, 1>(draw);
    auto const kappa = contact_product();
    auto const theta = cartan_form<1, 2>(L);
    auto const sum = [&]<class T, int D>(Matrix<T, D, 1> const& at, Tangents<T, D, 2> const& V) -> T {
      return theta(at, V) + kappa(at, V);
    };
    auto const seen = [&](auto const& field, auto const& form) {
      return components_of(pull_back(jet_extension(phi), contract(field, form)), x);
    };
    // Any vectors on the jet bundle, prolonged or not.
    ConstantField<S, 8> const W{draw.vector<S, Matrix<S, 8, 1>>(8)};
    claim.equal("boundary terms of Theta and of Theta + kappa", model, seen(W, theta), seen(W, sum));
    auto const at = coordinates(first_jet(phi, x));
    auto const U = draw_tangents<S, 8, 2>(draw);
    claim.differs("Theta and Theta + kappa are one form", model, theta(at, U), sum(at, U));
    // Within the class: a form that contracts to zero with every variation is zero. Its coefficients
    // are read off coordinate fields.
    auto z = legendre(L, first_jet(phi, x));
    auto const j = first_jet(phi, x);
    auto const other = draw.vector<S, Matrix<S, 5, 1>>(5);
    z.Pi = other[4];
    for (int a = 0; a < 2; ++a)
      for (int mu = 0; mu < 2; ++mu) z.p(a, mu) = other[2 * a + mu];
    auto const in_class = [&z]<class T, int D>(Matrix<T, D, 1> const& at, Tangents<T, D, 2> const& V) -> T {
      return actio::affine_form<1, 2>(z.p.template cast<T>().eval(), T(z.Pi), at, V);
    };
    auto const along = [&](int i) { return seen(ConstantField<S, 8>{Matrix<S, 8, 1>::Unit(i)}, in_class); };
    Matrix<S, 2, 2> read;
    for (int a = 0; a < 2; ++a) read.row(a) = along(2 + a).transpose();
    claim.equal("coefficients of dy^a ^ d^nx_mu, from vertical fields", model, read, z.p);
    S const b = along(0)[0] + z.p.col(0).dot(j.v.col(0)) - (pairing(z, j) - z.Pi);
    claim.zero("coefficient of d^{n+1}x, from a horizontal field", model, S(b - z.Pi), S(4));
    z.Pi = S(0);
    Matrix<S, 2, 2> again;
    for (int a = 0; a < 2; ++a) again.row(a) = along(2 + a).transpose();
    claim.equal("vertical fields do not see that coefficient", model, again, read);
    claim.refutes("vertical fields fix it", model, b, S(1));
  });
}

STATEMENT(claim_6_2_cartan_form_two_routes, "variational and Legendre routes to the Cartan form compared") {
  claim.holds(
      "The boundary term is the part of the action's variation that depends on the derivatives of a factor "
      "of $V$; no Cartan form is needed to find it.");
  over_points<S>(SmallDimensions{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = D::N;
    auto const L = draw_density<S, n, N>(draw);
    auto const phi = draw_section<S, n, N>(draw);
    auto const x = draw_event<S, n>(draw);
    auto const j = first_jet(phi, x);
    auto const from_action = form_from_action<S, n, N>(L, phi, x), from_legendre = legendre(L, j);
    claim.equal("coefficients of dy^a ^ d^nx_mu", model, from_action.p, from_legendre.p);
    S const scale = magnitude(from_legendre.p) * magnitude(j.v) * S(N * (n + 1)) + magnitude(L(j));
    claim.zero("coefficient of d^{n+1}x", model, S(from_action.Pi - from_legendre.Pi), scale);
    claim.refutes("L alone as that coefficient", model, S(from_action.Pi - L(j)), scale);
    claim.refutes("nothing there, as vertical variations would have it", model, from_action.Pi, scale);
  });
}

STATEMENT(thm_6_2_2, "multisymplectic form formula") {
  claim.holds(
      "Off shell the divergence of the current is $V\\cdot\\delta_WE - W\\cdot\\delta_VE$ for vertical "
      "variations, so both are to solve the linearised equations.");
  over_points<S>(SmallDimensions{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = D::N;
    // The linearised equations are to have a solution for the accelerations.
    auto const L = draw_regular_density<S, n, N>(draw);
    auto const phi = draw_section<S, n, N>(draw);
    auto const at = second_jet(phi, draw_event<S, n>(draw));
    auto const V = not_accelerated(draw_section<S, n, N>(draw)),
               W = not_accelerated(draw_section<S, n, N>(draw));
    auto const divergence_of = [&](auto const& v, auto const& w) {
      return divergence(
          [&]<class T>(Event<T, n> const& x) {
        return multisymplectic_current(L, first_jet(phi, x), first_jet(v, x), first_jet(w, x));
          },
          at.x);
    };
    auto const j = second_jet(V, at.x), k = second_jet(W, at.x);
    S const left = divergence_of(V, W), first = j.y.dot(linearised_euler_lagrange(L, at, k)),
            second = k.y.dot(linearised_euler_lagrange(L, at, j));
    S const scale = magnitude(left) + magnitude(first) + magnitude(second);
    claim.zero("off shell: divergence V . dE[W] - W . dE[V]", model, S(left - first + second), scale);
    // First variations at this point, of the section as it is: a force of the section's own changes nothing
    // in the linearised equations.
    auto const v = first_variation_at(L, at, V), w = first_variation_at(L, at, W);
    // Accelerations from one elimination.
    claim.zero("divergence for two first variations", model, divergence_of(v, w), scale, 10);
    claim.refutes("one of them not a first variation", model, divergence_of(v, W), scale);
    claim.refutes("none of them a first variation", model, left, scale);
  });
}

STATEMENT(eq_6_11, "boundary integral of two first variations and the multisymplectic form") {
  claim.holds(
      "For variations that move space-time as well, the vertical parts are to solve the linearised "
      "equations.");
  // Integrals of polynomials of degree 5 over a drawn box, with accelerations from two equations.
  over_points<S>(SmallDimensions{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = D::N;
    // In a medium that is the same everywhere, uniform strain is a solution, and variations of second degree
    // solve the linearised equations.
    auto const L = draw_uniform_density<S, n, N>(draw);
    auto const phi = draw_section_of_degree<S, n, N>(draw, 1);
    auto const box = draw_box<S, n>(draw);
    auto const j = second_jet(phi, Event<S, n>(Event<S, n>::Zero()));
    auto const draw_vertical = [&] {
      return not_accelerated(draw_section_of_degree<S, n, N>(draw, 2, S(1)));
    };
    auto const any = draw_vertical();
    auto const field_of = [&j](Accelerated<S, n, N> const& Q, AnyVariation<S, n, N> const& along) {
      return WithVerticalPart<S, n, N>{Q, along, j.v};
    };
    auto const horizontal = [&] { return draw_variation<S, n, N>(draw, 2); };
    auto const V = field_of(first_variation_at(L, j, draw_vertical()), horizontal());
    auto const current = [&](Accelerated<S, n, N> const& W, AnyVariation<S, n, N> const& along) {
      return pull_back(jet_extension(phi),
                       contract(prolonged<n, N>(V), contract(prolonged<n, N>(field_of(W, along)),
                                                             multisymplectic_form<n, N>(L))));
    };
    auto const along = horizontal();
    auto const right = current(first_variation_at(L, j, any), along), wrong = current(any, along);
    // What flows in at one corner and out at the opposite one is the scale: most of it cancels even where the
    // sum does not vanish.
    S const scale = magnitude(components_of(right, box.low)) + magnitude(components_of(right, box.high));
    // Sums over up to 25 nodes on each side, and accelerations from one elimination.
    claim.zero("two first variations, horizontal parts included", model, boundary_integral(right, box, 4),
               scale, 10);
    claim.refutes("one of them not a first variation", model, boundary_integral(wrong, box, 4), scale);
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

using Two = std::tuple<Dimensions<2, 2>, Dimensions<1, 3>>;

}  // namespace

STATEMENT(eq_6_8, "Euler-Lagrange derivative through the multisymplectic form") {
  claim.corrected(
      "D_{EL}\\mathcal L\\cdot\\mathcal V = (j^1)^*[j^1\\mathcal V\\lrcorner\\Omega_{\\mathcal L}]",
      "D_{EL}\\mathcal L\\cdot\\mathcal V = -(j^1)^*[j^1\\mathcal V\\lrcorner\\Omega_{\\mathcal L}]",
      "With $\\Omega = -d\\Theta$, as it is set after (6.6), the sign is the other one.");
  // A density of degree 33 in what is drawn, differentiated twice, times a field of degree 21.
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
  over_points<S>(Two{}, [&]<class D>(D, std::string const& model) {
    OffShell<S, D::n, D::N> const m(draw);
    Matrix<S, D::N, 1> const force = partial_y(m.L, m.first());
    auto const written_out = [&](bool points, bool places) {
      return Matrix<S, D::N, 1>(force - expanded_divergence(m.L, m.j, points, places));
    };
    claim.zero("written out", model, Matrix<S, D::N, 1>(m.E - written_out(true, true)),
               S(magnitude(force) + magnitude(m.E)));
    claim.differs("without the mixed derivative in x", model, m.E, written_out(false, true));
    claim.differs("without the mixed derivative in y", model, m.E, written_out(true, false));
  });
}

STATEMENT(eq_6_10, "Cartan form in coordinates for a general Lagrangian") {
  claim.holds();
  over_points<S>(Two{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = D::N;
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
  over_points<S>(Two{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = D::N;
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
      "The sections are those of $Y$: for sections of the jet bundle that are no jets, the density has to be "
      "regular.");
  over_points<S>(Two{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = D::N, all = OffShell<S, n, N>::dimension;
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
  over_points<S>(Two{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = D::N;
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
  over_points<S>(Two{}, [&]<class D>(D, std::string const& model) {
    OffShell<S, D::n, D::N> const m(draw);
    claim.equal("(6.12) equals (6.9)", model, momentum_divergence(m.L, m.j), expanded_divergence(m.L, m.j));
    claim.differs("without the derivative in y", model, momentum_divergence(m.L, m.j),
                  expanded_divergence(m.L, m.j, true, false));
  });
}
