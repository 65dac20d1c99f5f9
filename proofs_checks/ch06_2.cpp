// Section 6.2: the density of a continuous medium, its Legendre transformation, its energy and its Cartan form.

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
  claim.corrected("d^{m+1}x", "d^{n+1}x", "The rest is the definition. It is a density, the same form in all charts of the body, where the stored energy is a scalar.");
  claim.maybe_scan();
  // A stored energy of third degree in metrics of degree 26.
  over_points<S>(Media{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = D::N;
    MediumAtAJet<S, n, N> const m(draw);
    S const K = m.root * m.mass * m.kinetic(), P = m.root * m.mass * m.energy();
    claim.equal("K - P", model, m.L(m.j), S(K - P));
    claim.differs("K + P", model, m.L(m.j), S(K + P));
    // The same medium in another chart of the body, with the derivatives A of the old coordinates by the new.
    using M = actio::Matrix<S, n, n>;
    M A = M::Identity();
    for (int i = 0; i < n; ++i) A.col(i) += draw.vector<S, actio::Matrix<S, n, 1>>(n) * ratio<S>(1, 4);
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
    claim.differs("without the root of det G", model, S(there / volume<S>(G)), S(here / m.root * determinant(A)));
    // The printed exponent names no dimension that there is; as N it gives a form of another degree.
    if (n != N) claim.differs("printed: with m read as the dimension of the space", model, S(n + 1), S(N + 1));
  });
}

STATEMENT(eq_6_4, "conjugate momenta of the continuum Lagrangian") {
  claim.holds();
  over_points<S>(Media{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = D::N;
    MediumAtAJet<S, n, N> const m(draw);
    auto const p = momenta(m.L, m.j);
    auto const printed = m.printed_momenta();
    using F = actio::Matrix<S, N, n>;
    using V = actio::Matrix<S, N, 1>;
    claim.equal("p^0", model, V(p.col(0)), V(printed.col(0)));
    claim.equal("p^j", model, F(p.template rightCols<n>()), F(printed.template rightCols<n>()));
    claim.differs("p^0 with the half of the kinetic energy", model, V(p.col(0)), V(printed.col(0) / S(2)));
    claim.differs("p^j with the other sign", model, F(p.template rightCols<n>()), F(-printed.template rightCols<n>()));
    claim.differs("without the mass density", model, p, actio::Matrix<S, N, n + 1>(printed / m.mass));
    S contracted(0);
    for (int mu = 0; mu <= n; ++mu) contracted += printed.col(mu).dot(m.j.v.col(mu));
    claim.equal("Pi = L - p v", model, legendre(m.L, m.j).Pi, S(m.L(m.j) - contracted));
  });
}

STATEMENT(claim_6_2_affine_momentum, "affine component of the continuum Legendre transformation") {
  claim.holds();
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

// ----
// Section 6.2: the variational principle and the multisymplectic form formula. Variations move space-time as well; integrals over boxes are exact.

namespace {

/// \f$E_a\,(V^a - \phi^a{}_{,\mu}V^\mu)\f$, or \f$E_aV^a\f$ if variations are taken for vertical ones.
template <class S, int n, int N, class L>
S bulk(L const& density, SecondJet<S, n, N> const& j, Variation<S, n, N> const& V, bool horizontal = true) {
  actio::Matrix<S, N, 1> const E = euler_lagrange(density, j);
  return E.dot(horizontal ? vertical_part(static_cast<Jet<S, n, N> const&>(j), V) : actio::Matrix<S, N, 1>(V.template tail<N>()));
}

/// The boundary current of a variation along a section; without the last term of the Cartan form only vertical variations have it right.
template <class L, class Phi, class Field>
auto current_along(L const& density, Phi const& phi, Field const& V, bool complete = true) {
  return [&density, &phi, &V, complete]<class T, int rows>(actio::Matrix<T, rows, 1> const& x) {
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
  return [B]<class T, int rows>(actio::Matrix<T, rows, 1> const& x, Tangents<T, rows, rows - 1> const& V) -> T {
    actio::Matrix<T, rows, rows> all;
    all << B(x), V;
    return determinant(all);
  };
}

/// A field on Y that vanishes on the boundary of a box: any other, times a product of the distances from its faces.
template <class S, int n, class Field>
struct Inside {
  Field V;
  Box<S, n> box;
  template <class X>
  auto operator()(X const& point) const {
    using T = ScalarOf<X>;
    T bump(1);
    for (int mu = 0; mu <= n; ++mu) bump *= (point[mu] - T(box.low[mu])) * (T(box.high[mu]) - point[mu]) * T(4);
    auto rate = V(point);
    for (int i = 0; i < rate.size(); ++i) rate[i] *= bump;
    return rate;
  }
};

/// The coefficients of the gradient of f in the variation of the density along f times the i-th coordinate field: what a boundary term is made of, without it.
template <class S, int n, int N, class L, class Phi>
Event<S, n> symbol_of_variation(L const& density, Phi const& phi, Event<S, n> const& x, int i) {
  Event<S, n> symbol;
  // With f = x^mu less its value here, the part that is proportional to f vanishes.
  for (int mu = 0; mu <= n; ++mu) symbol[mu] = density_variation(density, phi, AnyVariation<S, n, N>::coordinate(i, S(-x[mu]), S(1), mu), x);
  return symbol;
}

/// The form \f$a_a{}^\mu\,dy^a\wedge d^nx_\mu + b\,d^{n+1}x\f$ that has this symbol along a section.
template <class S, int n, int N, class L, class Phi>
DualJet<S, n, N> form_from_action(L const& density, Phi const& phi, Event<S, n> const& x) {
  auto const j = first_jet(phi, x);
  DualJet<S, n, N> z{j.x, j.y, S(0), {}};
  for (int a = 0; a < N; ++a) z.p.row(a) = symbol_of_variation<S, n, N>(density, phi, x, n + 1 + a).transpose();
  // Along time: b + a_a^mu v^a_mu - a_a^0 v^a_0.
  z.Pi = symbol_of_variation<S, n, N>(density, phi, x, 0)[0] + z.p.col(0).dot(j.v.col(0)) - pairing(z, j);
  return z;
}

/// \f$(dy^1 - v^1{}_\mu dx^\mu)\wedge(dy^2 - v^2{}_\mu dx^\mu)\f$ for n = 1, N = 2: a form on jets that no section sees.
inline auto contact_product() {
  return []<class T, int D>(actio::Matrix<T, D, 1> const& at, Tangents<T, D, 2> const& V) -> T {
    auto const j = jet_at<1, 2>(at);
    actio::Matrix<T, 2, 2> const theta = V.template middleRows<2>(2) - j.v * V.template topRows<2>();
    return determinant(theta);
  };
}

/// The variation along a section of first degree, with derivatives v, that has a given vertical part and moves space-time by any field: \f$(V^\mu, Q^a + v^a{}_\mu V^\mu)\f$.
template <class S, int n, int N>
struct WithVerticalPart {
  Accelerated<S, n, N> vertical;
  AnyVariation<S, n, N> along;
  actio::Matrix<S, N, n + 1> v;
  template <class X>
  auto operator()(X const& point) const {
    using T = ScalarOf<X>;
    Variation<T, n, N> rate = along(point);
    actio::Matrix<T, N, 1> const y = vertical(Event<T, n>(point.template head<n + 1>()));
    for (int a = 0; a < N; ++a) {
      rate[n + 1 + a] = y[a];
      for (int mu = 0; mu <= n; ++mu) rate[n + 1 + a] += rate[mu] * T(v(a, mu));
    }
    return rate;
  }
};

}  // namespace

STATEMENT(eq_6_7, "variation of the field action for arbitrary variations") {
  claim.convention("The derivative $D_{EL}\\mathcal L\\cdot V$ contracts $V$ into $dy^a\\wedge d^{n+1}x$ and pulls back: it is $E_a(V^a - \\phi^a{}_{,\\mu}V^\\mu)$, and $E_aV^a$ for vertical variations alone.");
  // A density of degree 33 in what is drawn, differentiated twice, times a field on Y of degree 21.
  over_points<S>(SmallDimensions{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = D::N;
    auto const L = draw_density<S, n, N>(draw);
    auto const phi = draw_section<S, n, N>(draw);
    auto const V = draw_variation<S, n, N>(draw, 3);
    auto const x = draw_event<S, n>(draw);
    auto const j = second_jet(phi, x);
    auto const rate = V(graph(phi, x));
    S const left = density_variation(L, phi, V, x), inside = bulk(L, j, rate), boundary = divergence(current_along(L, phi, V), x);
    S const scale = magnitude(left) + magnitude(inside) + magnitude(boundary);
    claim.zero("at each point, with the divergence of the boundary term", model, S(left - inside - boundary), scale);
    claim.refutes("E_aV^a for a variation that is not vertical", model, S(left - bulk(L, j, rate, false) - boundary), scale);
    claim.refutes("without the term d^{n+1}x of the Cartan form", model, S(left - inside - divergence(current_along(L, phi, V, false), x)), scale);
    claim.refutes("without the boundary term", model, S(left - inside), scale);
    if constexpr (n == 1) {
      auto const form = pull_back(jet_extension(phi), contract(prolonged<n, N>(V), cartan_form<n, N>(L)));
      claim.equal("the boundary term is the pull-back of j1V hook Theta", model, components_of(form, x), Event<S, n>(boundary_current(L, first_jet(phi, x), rate)));
    }
  });
}

STATEMENT(thm_6_2_1, "Euler-Lagrange derivative and Cartan form from the variational principle") {
  claim.corrected("D_{EL}\\mathcal L\\cdot\\mathcal V = (j^1)^*[j^1\\mathcal V\\lrcorner\\Omega_{\\mathcal L}]", "D_{EL}\\mathcal L\\cdot\\mathcal V = -(j^1)^*[j^1\\mathcal V\\lrcorner\\Omega_{\\mathcal L}]",
                  "(6.7), (6.9) and (6.10) hold; (6.8) has the other sign with $\\Omega = -d\\Theta$, and the form is unique among the forms $a_a{}^\\mu\\,dy^a\\wedge d^nx_\\mu + b\\,d^{n+1}x$.");
  // Integrals of polynomials of degree 6 in x over a drawn box.
  over_points<S>(SmallDimensions{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = D::N;
    // A section of second degree, a field on Y of first: the density's variation and both terms are of degree 5 at most.
    constexpr int degree = 5;
    auto const L = draw_low_density<S, n, N>(draw);
    auto const phi = draw_section_of_degree<S, n, N>(draw, 2);
    auto const V = draw_variation<S, n, N>(draw, 1);
    auto const box = draw_box<S, n>(draw);
    auto const over_box = [&](auto const& f) { return integral(f, box.low, box.high, degree); };
    S const left = action_variation(L, phi, V, box, degree);
    S const inside = over_box([&](Event<S, n> const& x) { return bulk(L, second_jet(phi, x), V(graph(phi, x))); });
    S const wrong = over_box([&](Event<S, n> const& x) { return bulk(L, second_jet(phi, x), V(graph(phi, x)), false); });
    S const boundary = boundary_integral(as_form(current_along(L, phi, V)), box, degree);
    S const incomplete = boundary_integral(as_form(current_along(L, phi, V, false)), box, degree);
    S const scale = magnitude(left) + magnitude(inside) + magnitude(boundary);
    // Sums over up to 64 nodes.
    claim.zero("derivative of the action on a box that moves", model, S(left - inside - boundary), scale, 10);
    claim.refutes("E_aV^a for a variation that is not vertical", model, S(left - wrong - boundary), scale);
    claim.refutes("without the term d^{n+1}x of the Cartan form", model, S(left - inside - incomplete), scale);
    // (6.8), with the Cartan form of (6.10).
    auto const x = draw_event<S, n>(draw);
    S const here = bulk(L, second_jet(phi, x), V(graph(phi, x)));
    S const contracted = coefficient_of(pull_back(jet_extension(phi), contract(prolonged<n, N>(V), multisymplectic_form<n, N>(L))), x);
    claim.equal("(6.8) with Omega = -dTheta", model, here, S(-contracted), 10);
    claim.differs("(6.8) as printed", model, here, contracted);
  });
}

STATEMENT(claim_6_2_critical_point, "critical points of the action and admissible variations") {
  claim.convention("Admissible variations vanish on the boundary of $U$; with all variations, natural boundary conditions are imposed as well.");
  over_points<S>(SmallDimensions{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = D::N;
    auto const L = draw_uniform_density<S, n, N>(draw);
    auto const solution = draw_section_of_degree<S, n, N>(draw, 1), other = draw_section_of_degree<S, n, N>(draw, 2);
    auto const V = draw_variation<S, n, N>(draw, 1);
    auto const box = draw_box<S, n>(draw);
    Inside<S, n, AnyVariation<S, n, N>> const admissible{V, box};
    // Along the solution: the derivatives of a product of two distances for each coordinate and a polynomial of first degree, all of degree 3 in each of them.
    S const stationary = action_variation(L, solution, admissible, box, 3), free = action_variation(L, solution, V, box, 3);
    // Along the other section the momenta are of second degree, the density of third, and the variation of fourth.
    S const elsewhere = action_variation(L, other, admissible, box, 6);
    // Sums over up to 343 nodes.
    claim.zero("dS.V at a solution, V zero on the boundary", model, stationary, magnitude(free), 10);
    claim.refutes("V not zero on the boundary", model, free, S(1));
    claim.refutes("a section that solves nothing", model, elsewhere, magnitude(free));
  });
}

STATEMENT(claim_6_2_vertical_variations, "Cartan form obtained from vertical variations only") {
  claim.holds("The missing term is the whole of $(L - p_a{}^\\mu v^a{}_\\mu)\\,d^{n+1}x$, which no vertical variation sees.");
  over_points<S>(SmallDimensions{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = D::N;
    auto const L = draw_density<S, n, N>(draw);
    auto const phi = draw_section<S, n, N>(draw);
    auto const V = draw_variation<S, n, N>(draw, 2), upright = V.upright();
    auto const x = draw_event<S, n>(draw);
    auto const with = [&](auto const& field, bool complete) { return Event<S, n>(current_along(L, phi, field, complete)(x)); };
    claim.equal("boundary term of a vertical variation", model, with(upright, true), with(upright, false));
    claim.differs("boundary term of any variation", model, with(V, true), with(V, false));
    auto const j = second_jet(phi, x);
    // Same field equations from both: a variation along time alone gives them contracted with the velocity.
    auto const along_time = AnyVariation<S, n, N>::coordinate(0, S(1));
    S const rate = density_variation(L, phi, along_time, x), boundary = divergence(current_along(L, phi, along_time), x), power = euler_lagrange(L, j).dot(j.velocity());
    S const scale = magnitude(rate) + magnitude(boundary) + magnitude(power);
    claim.zero("field equations from a horizontal variation", model, S(rate - boundary + power), scale);
    claim.refutes("with the boundary term of vertical ones", model, S(rate - divergence(current_along(L, phi, along_time, false), x) + power), scale);
  });
}

STATEMENT(claim_6_2_cartan_form_uniqueness, "uniqueness of the form fixed by the variational principle") {
  claim.convention("Unique among the forms $a_a{}^\\mu\\,dy^a\\wedge d^nx_\\mu + b\\,d^{n+1}x$, and only if variations are not all vertical; a product of contact forms may be added to $\\Theta$ otherwise.");
  over_points<S>(std::tuple<Dimensions<1, 2>>{}, [&](auto, std::string const& model) {
    auto const L = draw_density<S, 1, 2>(draw);
    auto const phi = draw_section<S, 1, 2>(draw);
    auto const x = draw_event<S, 1>(draw);
    auto const kappa = contact_product();
    auto const theta = cartan_form<1, 2>(L);
    auto const sum = [&]<class T, int D>(actio::Matrix<T, D, 1> const& at, Tangents<T, D, 2> const& V) -> T { return theta(at, V) + kappa(at, V); };
    auto const seen = [&](auto const& field, auto const& form) { return components_of(pull_back(jet_extension(phi), contract(field, form)), x); };
    // Any vectors on the jet bundle, prolonged or not.
    ConstantField<S, 8> const W{draw.vector<S, actio::Matrix<S, 8, 1>>(8)};
    claim.equal("boundary terms of Theta and of Theta + kappa", model, seen(W, theta), seen(W, sum));
    auto const at = coordinates(first_jet(phi, x));
    auto const U = draw_tangents<S, 8, 2>(draw);
    claim.differs("Theta and Theta + kappa are one form", model, theta(at, U), sum(at, U));
    // Within the class: a variation that sees nothing of a form means that the form is zero. Its coefficients are read off coordinate fields.
    auto z = legendre(L, first_jet(phi, x));
    auto const j = first_jet(phi, x);
    auto const other = draw.vector<S, actio::Matrix<S, 5, 1>>(5);
    z.Pi = other[4];
    for (int a = 0; a < 2; ++a)
      for (int mu = 0; mu < 2; ++mu) z.p(a, mu) = other[2 * a + mu];
    auto const in_class = [&z]<class T, int D>(actio::Matrix<T, D, 1> const&, Tangents<T, D, 2> const& V) -> T {
      return actio::detail::affine_form<1, 2>(z.p.template cast<T>().eval(), T(z.Pi), V);
    };
    auto const along = [&](int i) { return seen(ConstantField<S, 8>{actio::Matrix<S, 8, 1>::Unit(i)}, in_class); };
    actio::Matrix<S, 2, 2> read;
    for (int a = 0; a < 2; ++a) read.row(a) = along(2 + a).transpose();
    claim.equal("coefficients of dy^a ^ d^nx_mu, from vertical fields", model, read, z.p);
    S const b = along(0)[0] + z.p.col(0).dot(j.v.col(0)) - (pairing(z, j) - z.Pi);
    claim.zero("coefficient of d^{n+1}x, from a horizontal field", model, S(b - z.Pi), S(4));
    z.Pi = S(0);
    actio::Matrix<S, 2, 2> again;
    for (int a = 0; a < 2; ++a) again.row(a) = along(2 + a).transpose();
    claim.equal("vertical fields do not see that coefficient", model, again, read);
    claim.refutes("vertical fields fix it", model, b, S(1));
  });
}

STATEMENT(claim_6_2_cartan_form_two_routes, "variational and Legendre routes to the Cartan form compared") {
  claim.holds("The boundary term is the part of the action's variation that depends on the derivatives of a factor of $V$; no Cartan form is needed to find it.");
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
  claim.holds("Off shell the divergence of the current is $V\\cdot\\delta_WE - W\\cdot\\delta_VE$ for vertical variations, so both are to solve the linearised equations.");
  over_points<S>(SmallDimensions{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = D::N;
    // The linearised equations are to have a solution for the accelerations.
    auto const L = draw_regular_density<S, n, N>(draw);
    auto const phi = draw_section<S, n, N>(draw);
    auto const at = second_jet(phi, draw_event<S, n>(draw));
    auto const V = not_accelerated(draw_section<S, n, N>(draw)), W = not_accelerated(draw_section<S, n, N>(draw));
    auto const divergence_of = [&](auto const& v, auto const& w) {
      return divergence([&]<class T>(Event<T, n> const& x) { return multisymplectic_current(L, first_jet(phi, x), first_jet(v, x), first_jet(w, x)); }, at.x);
    };
    auto const j = second_jet(V, at.x), k = second_jet(W, at.x);
    S const left = divergence_of(V, W), first = j.y.dot(linearised_euler_lagrange(L, at, k)), second = k.y.dot(linearised_euler_lagrange(L, at, j));
    S const scale = magnitude(left) + magnitude(first) + magnitude(second);
    claim.zero("off shell: divergence V . dE[W] - W . dE[V]", model, S(left - first + second), scale);
    // First variations at this point, of the section as it is: a force of the section's own changes nothing in the linearised equations.
    auto const v = first_variation_at(L, at, V), w = first_variation_at(L, at, W);
    // Accelerations from one elimination.
    claim.zero("divergence for two first variations", model, divergence_of(v, w), scale, 10);
    claim.refutes("one of them not a first variation", model, divergence_of(v, W), scale);
    claim.refutes("none of them a first variation", model, left, scale);
  });
}

STATEMENT(eq_6_11, "boundary integral of two first variations and the multisymplectic form") {
  claim.holds("For variations that move space-time as well, the vertical parts are to solve the linearised equations.");
  // Integrals of polynomials of degree 5 over a drawn box, with accelerations from two equations.
  over_points<S>(SmallDimensions{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = D::N;
    // In a medium that is the same everywhere, uniform strain is a solution, and variations of second degree solve the linearised equations.
    auto const L = draw_uniform_density<S, n, N>(draw);
    auto const phi = draw_section_of_degree<S, n, N>(draw, 1);
    auto const box = draw_box<S, n>(draw);
    auto const j = second_jet(phi, Event<S, n>(Event<S, n>::Zero()));
    auto const draw_vertical = [&] { return not_accelerated(draw_section_of_degree<S, n, N>(draw, 2, S(1))); };
    auto const any = draw_vertical();
    auto const field_of = [&j](Accelerated<S, n, N> const& Q, AnyVariation<S, n, N> const& along) { return WithVerticalPart<S, n, N>{Q, along, j.v}; };
    auto const horizontal = [&] { return draw_variation<S, n, N>(draw, 2); };
    auto const V = field_of(first_variation_at(L, j, draw_vertical()), horizontal());
    auto const current = [&](Accelerated<S, n, N> const& W, AnyVariation<S, n, N> const& along) {
      return pull_back(jet_extension(phi), contract(prolonged<n, N>(V), contract(prolonged<n, N>(field_of(W, along)), multisymplectic_form<n, N>(L))));
    };
    auto const along = horizontal();
    auto const right = current(first_variation_at(L, j, any), along), wrong = current(any, along);
    // What flows in at one corner and out at the opposite one is the scale: most of it cancels even where the sum does not vanish.
    S const scale = magnitude(components_of(right, box.low)) + magnitude(components_of(right, box.high));
    // Sums over up to 25 nodes on each side, and accelerations from one elimination.
    claim.zero("two first variations, horizontal parts included", model, boundary_integral(right, box, 4), scale, 10);
    claim.refutes("one of them not a first variation", model, boundary_integral(wrong, box, 4), scale);
  });
}

// ----
// Section 6.2: the Cartan form of a general density and its field equations.

namespace {

/// The total derivative of the momenta with the chain rule written out: second derivatives of L, each by duals in duals.
///
/// The derivatives at a fixed place, and those by the place, may be left out.
template <class S, int n, int N, class L>
actio::Matrix<S, N, 1> expanded_divergence(L const& density, SecondJet<S, n, N> const& j, bool with_points = true, bool with_places = true) {
  using First = Dual<S>;
  using Second = Dual<First>;
  actio::Matrix<S, N, 1> sum = actio::Matrix<S, N, 1>::Zero();
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
    actio::Matrix<S, D::N, 1> const force = place_derivative(m.L, m.first());
    auto const written_out = [&](bool points, bool places) { return actio::Matrix<S, D::N, 1>(force - expanded_divergence(m.L, m.j, points, places)); };
    claim.zero("written out", model, actio::Matrix<S, D::N, 1>(m.E - written_out(true, true)), S(magnitude(force) + magnitude(m.E)));
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
    S const L = m.L(m.first()), contracted = p.cwiseProduct(m.j.v).sum(), scale = magnitude(p) * S(N * (n + 1)) + magnitude(L);
    S const theta = cartan_form<n, N>(m.L)(at, V);
    claim.zero("in coordinates", model, S(theta - by_exterior_products<n, N>(p, S(L - contracted), at, V)), scale);
    claim.refutes("with L alone in the last term", model, S(theta - by_exterior_products<n, N>(p, L, at, V)), scale);
    // As the pull-back of the canonical form by the Legendre transformation.
    auto const transformation = [&m]<class T, int rows>(actio::Matrix<T, rows, 1> const& c) { return coordinates(legendre(m.L, jet_at<n, N>(c))); };
    claim.zero("as a pull-back by the Legendre transformation", model, S(theta - pull_back(transformation, canonical_form<n, N>())(at, V)), scale);
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
    claim.zero("along jets of sections", model, S(coefficient_of(pull_back(jet_extension(m.phi), theta), m.x) - m.L(m.first())), scale);
    auto const z = not_holonomic(m.phi, psi);
    claim.refutes("along a section of the jet bundle that is no jet", model, S(coefficient_of(pull_back(z, theta), m.x) - m.L(jet_at<n, N>(z(m.x)))), scale);
  });
}

STATEMENT(claim_6_2_el_by_contraction, "field equations as contractions with arbitrary vector fields on the jet bundle") {
  claim.holds("The sections are those of $Y$: for sections of the jet bundle that are no jets, the density has to be regular.");
  over_points<S>(Two{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = D::N, all = OffShell<S, n, N>::dimension;
    using W = actio::Matrix<S, all, 1>;
    OffShell<S, n, N> const m(draw);
    // All fields on the jet bundle, whatever their part along the derivatives.
    W const any = draw.vector<S, W>(all);
    Variation<S, n, N> const below = any.template head<n + 1 + N>();
    S const scale = magnitude(m.E) * S(all) + magnitude(momenta(m.L, m.first()));
    claim.zero("the contraction is -E_a(W^a - v^a_mu W^mu)", model, S(m.contraction(any) + m.E.dot(vertical_part(m.first(), below))), scale);
    // Conversely, the coordinate fields along the fibres give all field equations.
    actio::Matrix<S, N, 1> found;
    for (int a = 0; a < N; ++a) found[a] = -m.contraction(W::Unit(n + 1 + a));
    claim.equal("the fields d/dy^a give all of them", model, found, m.E);
    // With a force that makes the section a solution at the point.
    auto const solved = with_force(m.L, actio::Matrix<S, N, 1>(-m.E));
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
  over_points<S>(Two{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = D::N;
    using Column = actio::Matrix<S, N, 1>;
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
  over_points<S>(Two{}, [&]<class D>(D, std::string const& model) {
    OffShell<S, D::n, D::N> const m(draw);
    claim.equal("(6.12) equals (6.9)", model, momentum_divergence(m.L, m.j), expanded_divergence(m.L, m.j));
    claim.differs("without the derivative in y", model, momentum_divergence(m.L, m.j), expanded_divergence(m.L, m.j, true, false));
  });
}
<<<<<<< HEAD

// ----
// Section 6.2: acceleration and Christoffel symbols, constant metrics, the covariant divergence, Piola's identity.

namespace {

/// A metric in other coordinates z with y = chart(z).
template <class Metric, class Chart>
struct MetricInChart {
  Metric g;
  Chart chart;
  template <class T, int n>
  actio::Matrix<T, n, n> operator()(actio::Matrix<T, n, 1> const& z) const {
    return pulled_back(g(chart(z).eval()), pushed(chart, z, Tangents<T, n, n>(Tangents<T, n, n>::Identity())));
  }
};

/// A chart of space near the identity.
template <class S, int n>
struct AnyChart {
  std::array<Cubic<S, n>, n> added;
  template <class V>
  auto operator()(V const& z) const {
    actio::Matrix<ScalarOf<V>, n, 1> y;
    for (int a = 0; a < n; ++a) y[a] = z[a] + added[a](z);
    return y;
  }
};

/// The acceleration with the symbols contracted as printed, for one value of the index that is left over.
template <class Medium, class S, int n>
actio::Matrix<S, n, 1> printed_acceleration(Medium const& medium, SecondJet<S, n, n> const& j, int a) {
  auto const gamma = christoffel(medium.g, j.y);
  actio::Matrix<S, n, 1> sum = j.acceleration();
  for (int b = 0; b < n; ++b)
    for (int c = 0; c < n; ++c) sum[b] += gamma[a](b, c) * j.velocity()[b] * j.velocity()[c];
  return sum;
}

}  // namespace

STATEMENT(claim_6_2_material_acceleration, "the material acceleration in coordinates") {
  claim.corrected(R"(\Bigl(\frac{D_g\dot\phi}{Dt}\Bigr)^b \equiv \frac{\partial\dot\phi^b}{\partial t} + \gamma^a_{bc}\,\dot\phi^b\dot\phi^c)",
                  R"(\Bigl(\frac{D_g\dot\phi}{Dt}\Bigr)^b \equiv \frac{\partial\dot\phi^b}{\partial t} + \gamma^b_{ac}\,\dot\phi^a\dot\phi^c)",
                  "The free index $b$ of the left side is summed on the right, where $a$ is left over: the names of $a$ and $b$ are exchanged in the last term.");
  // A metric of degree 4 and its inverse, a section of degree 3, a chart of degree 3.
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const dust = draw_medium<S, n>(draw, Kind::dust);
    auto const j = draw_second_jet<S, n>(draw);
    auto const E = (euler_lagrange(dust, j) / body_volume(dust, j)).eval();
    claim.equal("the field equations of dust", model, (-inertia(dust, j)).eval(), E);
    for (int a = 0; a < n; ++a)
      claim.differs("as printed, a given the value " + std::to_string(a + 1), model, raised(dust.g(j.y), E), (printed_acceleration(dust, j, a) * -S(dust.rho(j.particle()))).eval());
  });
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    AnyChart<S, 2> chart;
    for (auto& c : chart.added) c = draw_cubic<S, 2>(draw, ratio<S>(1, 5));
    auto const g = draw_metric<S, 2>(draw);
    auto const phi = draw_section<S, 2, 2>(draw);
    auto const x = draw_event<S, 2>(draw);
    auto const j = second_jet(phi, x), k = second_jet([&](auto const& at) { return chart(phi(at)); }, x);
    auto const carried = pushed(chart, j.y, Tangents<S, 2, 1>(material_acceleration(MetricInChart<AnyMetric<S, 2>, AnyChart<S, 2>>{g, chart}, j)));
    claim.equal("a vector: the same in other coordinates", model, carried, material_acceleration(g, k));
    claim.differs("the second derivatives alone", model, pushed(chart, j.y, Tangents<S, 2, 1>(j.acceleration())), k.acceleration());
  });
}

STATEMENT(claim_6_2_christoffel, "the Christoffel symbols of the field metric") {
  claim.holds("The symmetric symbols under which the metric is parallel; that fixes them.");
  over_points(PlaneAndSpace{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const g = draw_metric<S, n>(draw);
    actio::Matrix<S, n, 1> const y = draw.vector<S, actio::Matrix<S, n, 1>>(n) * ratio<S>(1, 2);
    auto const gamma = christoffel(g, y);
    auto const rates = metric_derivatives(g, y);
    actio::Matrix<S, n, n> const here = g(y);
    S parallel(0), flipped(0), skew(0), size(0);
    auto const grow = [](S& largest, S const& x) {
      if (magnitude(x) > largest) largest = magnitude(x);
    };
    actio::Matrix<S, n, n> const inverse = inverse_matrix(here);
    for (int c = 0; c < n; ++c)
      for (int a = 0; a < n; ++a)
        for (int b = 0; b < n; ++b) {
          S residual = rates[c](a, b), broken = rates[c](a, b);
          for (int d = 0; d < n; ++d) {
            // The sign of the last of the three derivatives, changed.
            auto const other = [&](int e, int f) {
              S sum = gamma[d](e, f);
              for (int h = 0; h < n; ++h) sum += inverse(d, h) * rates[h](e, f);
              return sum;
            };
            residual -= here(d, b) * gamma[d](a, c) + here(a, d) * gamma[d](b, c);
            broken -= here(d, b) * other(a, c) + here(a, d) * other(b, c);
          }
          grow(parallel, residual), grow(flipped, broken), grow(size, rates[c](a, b)), grow(skew, S(gamma[c](a, b) - gamma[c](b, a)));
        }
    claim.zero("the covariant derivative of g", model, parallel, size);
    claim.zero("symmetric in the lower indices", model, skew, size, n);
    claim.refutes("the last sign changed", model, flipped, size);
  });
}

STATEMENT(eq_6_15, "the equation of motion with constant metrics") {
  claim.holds("In coordinates in which $g$ and $G$ are constant; the mass density, which may vary, stays inside the derivative.");
  // An energy of degree 3 in metrics of degree 4 and a section of degree 3.
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const curved = draw_medium<S, n>(draw, Kind::any), flat = flattened(curved);
    auto const j = draw_second_jet<S, n>(draw);
    auto const left = [&](AnyContinuum<S, n> const& medium) { return (lowered(medium.g(j.y), j.acceleration()) * S(medium.rho(j.particle()))).eval(); };
    auto const right = [&](AnyContinuum<S, n> const& medium) { return detail::two_point_rates([&](auto const& jet) { return detail::piola_kirchhoff(medium, jet); }, j).divergence; };
    auto const E = [&](AnyContinuum<S, n> const& medium) { return (euler_lagrange(medium, j) / body_volume(medium, j)).eval(); };
    claim.equal("(6.15) and the field equations", model, (right(flat) - left(flat)).eval(), E(flat));
    auto const outside = detail::two_point_rates([&](auto const& jet) { return detail::strain_derivative(flat, jet); }, j).divergence;
    claim.differs("the mass density outside the derivative", model, (outside * S(flat.rho(j.particle())) - left(flat)).eval(), E(flat));
    claim.differs("metrics that are not constant", model, (right(curved) - left(curved)).eval(), E(curved));
  });
}

STATEMENT(claim_6_2_covariant_divergence, "the covariant divergence of a two-point tensor") {
  claim.corrected(R"(\frac{\partial\mathcal P_a{}^i}{\partial x^i} + \mathcal P_a{}^j\,\Gamma^k_{jk} - \mathcal P_b{}^i\,\gamma^b_{ac}\,F_j{}^c)",
                  R"(\frac{\partial\mathcal P_a{}^i}{\partial x^i} + \mathcal P_a{}^j\,\Gamma^k_{jk} - \mathcal P_b{}^j\,\gamma^b_{ac}\,F^c{}_j)",
                  "In the last term $i$ and $j$ are left over; they are one index, summed. The divergence is fixed by Leibniz' rule with vector fields of space.");
  claim.maybe_scan();
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    using Column = actio::Matrix<S, n, 1>;
    auto const medium = draw_medium<S, n>(draw, Kind::any);
    auto const j = draw_second_jet<S, n>(draw);
    auto const T = [&](auto const& jet) { return detail::piola_kirchhoff(medium, jet); };
    AnyChart<S, n> field;
    for (auto& c : field.added) c = draw_cubic<S, n>(draw);
    auto const [value, derivative] = detail::two_point_rates(T, j);
    Column const DIV = two_point_divergence(medium.G, medium.g, j, T);

    // The vector T w of the body, whose divergence is that of its metric.
    auto const weighted = [&]<class R>(Jet<R, n, n> const& jet) {
      return actio::Matrix<R, 1, n>((field(jet.y).transpose() * T(jet)) * volume<R>(medium.G(jet.particle())));
    };
    S left(0);
    for (int i = 0; i < n; ++i) left += weighted(along(j, i + 1))(0, i).part[0];
    left /= body_volume(medium, j);
    auto const Gamma = christoffel(medium.G, j.particle()), gamma = christoffel(medium.g, j.y);
    Column const w = field(j.y);
    S turned(0);  // T_a^i times the covariant derivative of w along F_i
    actio::Matrix<S, n, n> const rate = pushed(field, j.y, Tangents<S, n, n>(j.gradient()));
    for (int i = 0; i < n; ++i) turned += value.col(i).dot(Column(rate.col(i) + connection(medium.g, j.y, w, Column(j.gradient().col(i)))));
    claim.equal("Leibniz' rule", model, left, S(DIV.dot(w) + turned));

    Column on_space = Column::Zero(), free = Column::Zero(), on_body = Column::Zero();
    Column const sums = value * Column::Ones(), velocities = j.gradient() * Column::Ones();
    for (int a = 0; a < n; ++a)
      for (int b = 0; b < n; ++b)
        for (int c = 0; c < n; ++c) {
          on_space[a] += gamma[b](a, c) * value.row(b).dot(j.gradient().row(c));
          free[a] += gamma[b](a, c) * sums[b] * velocities[c];
          on_body[a] += value(a, b) * Gamma[c](b, c);
        }
    claim.equal("term by term", model, DIV, Column(derivative + on_body - on_space));
    claim.differs("as printed, i and j summed one by one", model, left, S((derivative + on_body - free).dot(w) + turned));
    claim.differs("the last sign changed", model, left, S((derivative + on_body + on_space).dot(w) + turned));
    claim.differs("without the symbols of the body", model, left, S((derivative - on_space).dot(w) + turned));
  });
}

STATEMENT(claim_6_2_cancelling_terms, "the terms from the determinant and from the inverse gradient cancel") {
  claim.holds("Piola's identity. Each of the two terms alone is not zero; the section must be one: mixed derivatives commute.");
  // Determinant and inverse of a gradient of degree 2 in the body, n = 3.
  over_points(PlaneAndSpace{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    using Column = actio::Matrix<S, n, 1>;
    auto const G = draw_metric<S, n>(draw), g = draw_metric<S, n>(draw);
    auto const j = draw_second_jet<S, n>(draw);
    // Up to the common factor P sqrt(det g) / sqrt(det G).
    auto const terms = [&](SecondJet<S, n, n> const& at) {
      Column one = Column::Zero(), two = Column::Zero();
      for (int k = 0; k < n; ++k) {
        actio::Matrix<Dual<S>, n, n> const F = along(at, k + 1).gradient(), inverse = inverse_matrix(F);
        Dual<S> const det = determinant(F);
        for (int a = 0; a < n; ++a) {
          one[a] += det.part[0] * inverse(k, a).value;
          two[a] += det.value * inverse(k, a).part[0];
        }
      }
      return std::pair{one, two};
    };
    auto const [one, two] = terms(j);
    claim.equal("(I) and (II)", model, one, (-two).eval());
    claim.refutes("(I) alone", model, one, S(1));
    claim.zero("the covariant divergence of J / F", model, piola_identity(G, g, j), S(1));
    auto broken = j;
    broken.w[1](0, 2) += S(1);
    auto const [first, second] = terms(broken);
    claim.differs("gradients that are of no section", model, first, (-second).eval());
  });
}

// ----
// Section 6.2: the first Piola-Kirchhoff stress, and elasticity.

namespace {

}  // namespace

STATEMENT(eq_6_19, "the first Piola-Kirchhoff stress from the stored energy") {
  claim.holds();
  // An energy of degree 3 in metrics of degree 4 and a section of degree 3.
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    using T = Dual<S, n>;
    auto const medium = draw_medium<S, n>(draw, Kind::any);
    Jet<S, n, n> const j = draw_jet<S, n, n>(draw);
    auto const H = draw_tangents<S, n, n>(draw);
    // The energy per volume of the body on the way from F along H.
    auto moved = j.template cast<T>();
    for (int a = 0; a < n; ++a)
      for (int i = 0; i < n; ++i) moved.v(a, i + 1).part[0] = H(a, i);
    actio::Matrix<T, n, 1> const x = moved.particle();
    S const rate = medium.W(x, medium.G(x), medium.g(moved.y), moved.gradient()).part[0];
    S const power = first_piola_kirchhoff_stress(medium, j).cwiseProduct(H).sum();
    claim.equal("the power of the stress", model, power, S(rate * medium.rho(j.particle())));
    claim.differs("without the mass density", model, power, rate);
  });
}

STATEMENT(claim_6_2_piola_momenta, "the stress and the spatial momenta") {
  claim.holds();
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const medium = draw_medium<S, n>(draw, Kind::any);
    Jet<S, n, n> const j = draw_jet<S, n, n>(draw);
    actio::Matrix<S, n, n> const p = momenta(medium, j).template rightCols<n>(), stress = first_piola_kirchhoff_stress(medium, j);
    claim.equal("minus the momenta over the volume", model, stress, (p / -body_volume(medium, j)).eval());
    claim.differs("the other sign", model, stress, (p / body_volume(medium, j)).eval());
    claim.differs("without the volume", model, stress, (-p).eval());
  });
}

STATEMENT(claim_6_2_piola_transform, "Piola's transformation") {
  claim.convention("$W$ depends on $F$ and $g$ through the Green tensor alone (on $x$ and $G$ as it likes); the index is lowered with $g$, and $F$ has an inverse.");
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const solid = draw_medium<S, n>(draw, Kind::solid);
    Jet<S, n, n> const j = draw_jet<S, n, n>(draw);
    auto const at = point_of_medium(solid, j);
    auto const sigma = cauchy_stress(solid, j), stress = first_piola_kirchhoff_stress(solid, j);
    auto const transformed = piola_transformation(at.G, at.g, at.F, sigma);
    claim.equal("P and J sigma / F", model, stress, transformed);
    claim.differs("the inverse of F transposed", model, stress, (at.g * sigma * at.inverse * at.J).eval());
    claim.differs("without J", model, stress, (transformed / at.J).eval());
    auto const any = draw_medium<S, n>(draw, Kind::any);
    auto const there = point_of_medium(any, j);
    claim.differs("W not of the Green tensor", model, first_piola_kirchhoff_stress(any, j), piola_transformation(there.G, there.g, there.F, cauchy_stress(any, j)));
  });
}

STATEMENT(claim_6_2_stress_symmetry, "the Cauchy stress is symmetric") {
  claim.convention("With the symmetric derivative in $g$ it is so by definition. The balance of moment of momentum, that the Piola-Kirchhoff stress times $F$ is symmetric, "
                   "needs a $W$ of the Green tensor.");
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    using T = Dual<S, n>;
    Jet<S, n, n> const j = draw_jet<S, n, n>(draw);
    auto const any = draw_medium<S, n>(draw, Kind::any);
    auto const solid = draw_medium<S, n>(draw, Kind::solid);
    auto const sigma = cauchy_stress(any, j);
    claim.equal("for any W", model, sigma, sigma.transpose().eval());
    // P_a^i F^b_i with its first index raised.
    auto const moment = [&](auto const& medium) { return raised(medium.g(j.y), actio::Matrix<S, n, n>(first_piola_kirchhoff_stress(medium, j) * j.gradient().transpose())); };
    claim.equal("P times F, a W of the Green tensor", model, moment(solid), moment(solid).transpose().eval());
    claim.differs("P times F, any W", model, moment(any), moment(any).transpose().eval());
    // Entries of g changed one at a time: what W makes of a matrix that is not symmetric.
    actio::Matrix<S, n, n> alone;
    for (int a = 0; a < n; ++a) {
      actio::Matrix<T, n, n> g = any.g(j.y).template cast<T>();
      for (int b = 0; b < n; ++b) g(a, b).part[b] = S(1);
      auto const moved = j.template cast<T>();
      T const energy = any.W(moved.particle(), any.G(moved.particle()), g, moved.gradient());
      for (int b = 0; b < n; ++b) alone(a, b) = energy.part[b];
    }
    claim.differs("entries of g one at a time", model, alone, alone.transpose().eval());
  });
}

STATEMENT(eq_6_21, "the covariant equation of motion of elasticity") {
  claim.convention("The left side is a vector and the right a covector: one index is raised with $g$. $W$ is a function of the Green tensor.");
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const j = draw_second_jet<S, n>(draw);
    auto const E = [&](auto const& medium) { return raised(medium.g(j.y), actio::Matrix<S, n, 1>(euler_lagrange(medium, j) / body_volume(medium, j))); };
    auto const solid = draw_medium<S, n>(draw, Kind::solid);
    claim.equal("(6.21) and the field equations", model, (-solid_equation(solid, j)).eval(), E(solid));
    auto const any = draw_medium<S, n>(draw, Kind::any);
    claim.differs("W not of the Green tensor", model, (-solid_equation(any, j)).eval(), E(any));
    actio::Matrix<S, n, 1> const unraised = material_acceleration(solid.g, j) * S(solid.rho(j.particle())) - stress_divergence(solid, j);
    claim.differs("a vector and a covector", model, (-unraised).eval(), E(solid));
  });
}

STATEMENT(claim_6_2_euclidean_elasticity, "elasticity in a Euclidean space") {
  claim.holds("In coordinates in which $g$ and $G$ are constant; the first index of the stress is raised with $g$.");
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const j = draw_second_jet<S, n>(draw);
    // Both sides of the equation, their difference, and what it should be.
    auto const residual = [&](auto const& medium) {
      auto const raised_stress = [&]<class T>(Jet<T, n, n> const& jet) { return raised(medium.g(jet.y), actio::Matrix<T, n, n>(detail::piola_kirchhoff(medium, jet))); };
      return (detail::two_point_rates(raised_stress, j).divergence - j.acceleration() * S(medium.rho(j.particle()))).eval();
    };
    auto const E = [&](auto const& medium) { return raised(medium.g(j.y), actio::Matrix<S, n, 1>(euler_lagrange(medium, j) / body_volume(medium, j))); };
    auto const curved = draw_medium<S, n>(draw, Kind::solid), flat = flattened(curved);
    claim.equal("with constant metrics", model, residual(flat), E(flat));
    claim.differs("with others", model, residual(curved), E(curved));
  });
}

// ----
// Section 6.2: momenta, pressure, stress and metric force of a barotropic fluid.

namespace {

/// \f$g^{bc}\,\partial g_{bc}/\partial y^a\f$.
template <class Metric, class S, int n>
actio::Matrix<S, n, 1> logarithmic_slopes(Metric const& g, actio::Matrix<S, n, 1> const& y) {
  auto const rates = metric_derivatives(g, y);
  actio::Matrix<S, n, n> const inverse = inverse_matrix(as_matrix<S>(g(y)));
  actio::Matrix<S, n, 1> slope;
  for (int a = 0; a < n; ++a) slope[a] = inverse.cwiseProduct(rates[a]).sum();
  return slope;
}

}  // namespace

STATEMENT(claim_6_2_barotropic_momenta, "the spatial momenta of a barotropic fluid") {
  claim.holds();
  // A law of degree 3 in a Jacobian of degree 8 over another.
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const fluid = draw_medium<S, n>(draw, Kind::fluid);
    Jet<S, n, n> const j = draw_jet<S, n, n>(draw);
    auto const at = point_of_medium(fluid, j);
    actio::Matrix<S, n, n> const p = momenta(fluid, j).template rightCols<n>();
    Dual<S> J = at.J;
    J.part[0] = S(1);
    S const factor = -at.rho * fluid.W.w(J).part[0] * at.J * body_volume(fluid, j);
    claim.equal("by the chain rule", model, p, (at.inverse.transpose() * factor).eval());
    claim.differs("the inverse transposed", model, p, (at.inverse * factor).eval());
    claim.differs("the other sign", model, p, (at.inverse.transpose() * -factor).eval());
  });
}

STATEMENT(eq_6_16, "the material pressure from the stored energy") {
  claim.holds("With the density of space $\\rho/J$ it is the pressure of thermodynamics, the square of that density times the derivative of $W$ in it.");
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const fluid = draw_medium<S, n>(draw, Kind::fluid);
    Jet<S, n, n> const j = draw_jet<S, n, n>(draw);
    auto const at = point_of_medium(fluid, j);
    Dual<S> density = at.rho / at.J;
    density.part[0] = S(1);
    S const slope = fluid.W.w(Dual<S>(at.rho) / density).part[0], P = material_pressure(fluid, j);
    claim.equal("the pressure of thermodynamics", model, P, S(density.value * density.value * slope));
    claim.differs("with the density of the body", model, P, S(at.rho * at.rho * slope));
    claim.differs("the other sign", model, P, S(-density.value * density.value * slope));
  });
}

STATEMENT(claim_6_2_barotropic_stress, "the Cauchy stress of a barotropic fluid") {
  claim.holds("With the symmetric derivative in $g$, of which $J$ has half of $J$ times the inverse of $g$.");
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const fluid = draw_medium<S, n>(draw, Kind::fluid);
    Jet<S, n, n> const j = draw_jet<S, n, n>(draw);
    auto const at = point_of_medium(fluid, j);
    S const P = material_pressure(fluid, j);
    auto const sigma = cauchy_stress(fluid, j);
    actio::Matrix<S, n, n> const up = inverse_matrix(at.g) * P;
    claim.equal("minus the pressure times the metric", model, sigma, (-up).eval());
    claim.differs("plus the pressure", model, sigma, up);
    claim.differs("a factor J left over", model, sigma, (up * -at.J).eval());
    claim.differs("lower indices", model, sigma, (at.g * -P).eval());
  });
}

STATEMENT(claim_6_2_metric_force, "the force of the metric on a barotropic fluid") {
  claim.holds();
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const fluid = draw_medium<S, n>(draw, Kind::fluid);
    Jet<S, n, n> const j = draw_jet<S, n, n>(draw);
    auto const at = point_of_medium(fluid, j);
    auto const force = metric_force(fluid, j);
    actio::Matrix<S, n, 1> const right = logarithmic_slopes(fluid.g, j.y) * S(material_pressure(fluid, j) * at.J / S(2));
    claim.equal("by the pressure", model, force, right);
    claim.differs("the other sign", model, force, (-right).eval());
    claim.differs("without the half", model, force, (right * S(2)).eval());
    auto other = fluid;
    other.g = draw_metric<S, n>(draw);
    claim.differs("with the symbols of another metric", model, force, metric_force(other, j));
  });
}

STATEMENT(claim_6_2_barotropic_spatial_form, "the barotropic equation with spatial density and spatial pressure") {
  claim.holds("Motions of a fluid have an inverse; the spatial density is $\\rho/J$ carried to the particle, and the gradient is that of $g$.");
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    using T = Dual<S, n>;
    using Column = actio::Matrix<S, n, 1>;
    auto const fluid = draw_medium<S, n>(draw, Kind::fluid);
    auto const phi = draw_section<S, n, n>(draw);
    auto const x = draw_event<S, n>(draw);
    auto const j = second_jet(phi, x);
    auto const at = point_of_medium(fluid, j);
    // The particles at the places y + e_a, to first order, at the same time; and the pressure of them, as a function on space.
    Event<T, n> particles = x.template cast<T>();
    for (int i = 0; i < n; ++i)
      for (int a = 0; a < n; ++a) particles[i + 1].part[a] = at.inverse(i, a);
    auto const jets = first_jet(phi, particles);
    actio::Matrix<S, n, n> moved;
    for (int b = 0; b < n; ++b)
      for (int a = 0; a < n; ++a) moved(b, a) = jets.y[b].part[a];
    claim.equal("those are the particles there", model, moved, actio::Matrix<S, n, n>(actio::Matrix<S, n, n>::Identity()), n);
    T const p = detail::pressure(fluid, jets);
    Column slope;
    for (int a = 0; a < n; ++a) slope[a] = p.part[a];

    Column const gradient = raised(at.g, slope), wrong = raised(at.G, slope);
    Column const A = material_acceleration(fluid.g, j), E = raised(at.g, Column(euler_lagrange(fluid, j) / body_volume(fluid, j)));
    S const density = at.rho / at.J;
    claim.equal("the field equations over rho", model, (E / -at.rho).eval(), (A + gradient / density).eval());
    claim.differs("the density of the body", model, (E / -at.rho).eval(), (A + gradient / at.rho).eval());
    claim.differs("the gradient of the other metric", model, (E / -at.rho).eval(), (A + wrong / density).eval());
  });
}

// ----
// Section 6.2: the expansion of the left side of the barotropic equation, step by step.

namespace {

/// The three lines of (6.17) and their pieces, without the inertia that all of them begin with.
template <class S, int n>
struct Expansion {
  using Column = actio::Matrix<S, n, 1>;
  Column first;     ///< the weighted divergence
  Column pressure;  ///< slopes of P, carried to space
  Column volume;    ///< slopes of the volume of space along the section
  Column printed;   ///< slopes of det g in its place
  Column metric;    ///< half of P J g^bc dg_bc/dy^a

  template <class Fluid>
  Expansion(Fluid const& fluid, SecondJet<S, n, n> const& j) {
    auto const at = point_of_medium(fluid, static_cast<Jet<S, n, n> const&>(j));
    S const P = material_pressure(fluid, static_cast<Jet<S, n, n> const&>(j));
    actio::Matrix<S, n, n> const areas = area_transformation(at.G, at.g, at.F);
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
    actio::Matrix<S, n, n> const bare = at.inverse.transpose() * S(P * determinant(at.F) / body_volume(fluid, j));
    volume = bare * of_root;
    printed = bare * of_square;
    auto const rates = metric_derivatives(fluid.g, j.y);
    actio::Matrix<S, n, n> const up = inverse_matrix(at.g);
    for (int a = 0; a < n; ++a) metric[a] = P * at.J * up.cwiseProduct(rates[a]).sum() / S(2);
  }
};

}  // namespace

STATEMENT(eq_6_17, "the left side for a barotropic fluid, in three lines") {
  claim.corrected(R"(\frac{P\det\bigl(\frac{\partial\phi}{\partial x}\bigr)}{\sqrt{\det[G]}}\Bigl(\bigl(\tfrac{\partial\phi}{\partial x}\bigr)^{-1}\Bigr)^k_a\frac{\partial\det[g]}{\partial x^k})",
                  R"(\frac{P\det\bigl(\frac{\partial\phi}{\partial x}\bigr)}{\sqrt{\det[G]}}\Bigl(\bigl(\tfrac{\partial\phi}{\partial x}\bigr)^{-1}\Bigr)^k_a\frac{\partial\sqrt{\det[g]}}{\partial x^k})",
                  "The last term of the middle line lacks the root over $\\det g$. The first and the last line are right.");
  claim.maybe_scan();
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
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    auto const fluid = draw_medium<S, D::n>(draw, Kind::fluid);
    auto const j = draw_second_jet<S, D::n>(draw);
    Expansion<S, D::n> const lines(fluid, j);
    auto const first = (inertia(fluid, j) + lines.first).eval();
    auto const last = [&](S const& factor) { return (inertia(fluid, j) + lines.pressure + lines.metric * factor).eval(); };
    claim.equal("left side of (6.13)", model, first, last(S(1)));
    claim.equal("and with the right side", model, actio::Matrix<S, D::n, 1>(first - metric_force(fluid, j)), medium_equation(fluid, j));
    claim.differs("without the half", model, first, last(S(2)));
    claim.differs("without the metric", model, first, last(S(0)));
  });
}

// ----
// Section 6.2: the field equations of a medium and the Cauchy stress; exact with any stored energy, and in floating point on the sphere, with real powers.

namespace {

/// The unit sphere in angles: \f$d\theta^2 + \sin^2\theta\,d\varphi^2\f$.
struct Sphere {
  template <class T>
  actio::Matrix<T, 2, 2> operator()(actio::Matrix<T, 2, 1> const& y) const {
    using std::sin;
    T const s = sin(y[0]);
    actio::Matrix<T, 2, 2> g;
    g << T(1), T(0), T(0), s * s;
    return g;
  }
};

/// A stored energy with a real power that sees F and g other than through the Green tensor: \f$(2 + g_{11}(F^1{}_1)^2 + g_{12}F^1{}_1 + 3g_{22}F^1{}_2)^{7/5}\f$.
struct PowerOfStrain {
  template <class BodyMetric, class T>
  T operator()(actio::Matrix<T, 2, 1> const&, BodyMetric const&, actio::Matrix<T, 2, 2> const& g, actio::Matrix<T, 2, 2> const& F) const {
    using std::pow;
    return pow(T(g(0, 0) * F(0, 0) * F(0, 0) + g(0, 1) * F(0, 0) + g(1, 1) * F(0, 1) * Base<T>(3) + Base<T>(2)), Base<T>(Base<T>(7) / Base<T>(5)));
  }
};

/// A section on the sphere, away from its poles: theta about 1 on body and space.
template <class S>
SecondJet<S, 2, 2> draw_jet_on_sphere(Draw& draw) {
  auto const phi = draw_section<S, 2, 2>(draw, ratio<S>(1, 10));
  auto x = draw_event<S, 2>(draw);
  auto const south = [&](auto const& at) {
    auto from = at;
    from[1] -= 1;
    auto y = phi(from);
    y[0] += 1;
    return y;
  };
  x[1] += 1;
  return second_jet(south, x);
}

/// Over the rationals any medium in space, elsewhere one on the sphere.
/// @param visit  called with a medium with a general W, a fluid, a second jet, and the name of the model
template <class S, class Visit>
void over_media(Draw& draw, Visit const& visit) {
  if (exact_arithmetic<S>()) {
    over_points(std::tuple<Dimensions<3, 3>>{}, [&]<class D>(D, std::string const& model) {
      auto const any = draw_medium<S, D::n>(draw, Kind::any);
      auto const fluid = draw_medium<S, D::n>(draw, Kind::fluid);
      visit(any, fluid, draw_second_jet<S, D::n>(draw), model);
    });
  } else {
    auto const rho = draw_mass<S, 2>(draw);
    visit(Continuum{Sphere{}, Sphere{}, rho, PowerOfStrain{}}, Continuum{Sphere{}, Sphere{}, rho, Barotropic{Polytropic<S>{S(2), ratio<S>(7, 5)}}},
          draw_jet_on_sphere<S>(draw), "sphere, exponent 7/5");
  }
}

/// The field equations per volume of the body, with the sign that the thesis writes them with.
template <class Medium, class S, int n>
actio::Matrix<S, n, 1> field_equations(Medium const& medium, SecondJet<S, n, n> const& j) {
  return euler_lagrange(medium, j) / -body_volume(medium, j);
}

}  // namespace

STATEMENT(eq_6_13, "the Euler-Lagrange equation of a continuous medium") {
  claim.holds("The derivative in $x$ is the total one and acts on the mass density too; that in $g$ is the symmetric one, summed over both indices.");
  // An energy of degree 3 in metrics of degree 4 and a section of degree 3, and inverses of metrics.
  over_media<S>(draw, [&]<class Medium, class Fluid, int n>(Medium const& medium, Fluid const&, SecondJet<S, n, n> const& j, std::string const& model) {
    using Column = actio::Matrix<S, n, 1>;
    Jet<S, n, n> const& first = j;
    Column const E = field_equations(medium, j), force = metric_force(medium, first);
    claim.equal("(6.13) and (6.12)", model, medium_equation(medium, j), E);
    claim.differs("the force with the other sign", model, (medium_equation(medium, j) + force * S(2)).eval(), E);
    auto const outside = [&](auto const& weight) {
      auto const stress = [&](auto const& jet) { return (detail::strain_derivative(medium, jet) * weight(jet)).eval(); };
      return Column(inertia(medium, j) - detail::two_point_rates(stress, j).divergence / weight(first) * S(medium.rho(j.particle())) - force);
    };
    claim.differs("the mass density outside the derivative", model, outside([&]<class T>(Jet<T, n, n> const& at) { return volume<T>(medium.G(at.particle())); }), E);
    claim.differs("without the volume of the body", model, outside([&]<class T>(Jet<T, n, n> const& at) { return T(medium.rho(at.particle())); }), E);
  });
}

STATEMENT(eq_6_14, "the Cauchy stress from the stored energy") {
  claim.convention("$W$ is per unit mass, $\\rho$ the mass per volume of the body, and the derivative in $g$ the symmetric one. $J$ stays; it disappears where $\\rho/J$, the "
                   "spatial density, is written.");
  over_media<S>(draw, [&]<class Medium, class Fluid, int n>(Medium const& medium, Fluid const& fluid, SecondJet<S, n, n> const& j, std::string const& model) {
    using T = Dual<S, n>;
    using Matrix = actio::Matrix<S, n, n>;
    Jet<S, n, n> const& first = j;
    auto const at = point_of_medium(medium, first);
    Matrix const any = draw_tangents<S, n, n>(draw), h = any + any.transpose();
    // The energy on the way from g along h.
    auto const moved = first.template cast<T>();
    actio::Matrix<T, n, n> g = at.g.template cast<T>();
    for (int a = 0; a < n; ++a)
      for (int b = 0; b < n; ++b) g(a, b).part[0] = h(a, b);
    S const rate = medium.W(moved.particle(), medium.G(moved.particle()), g, moved.gradient()).part[0];
    Matrix const sigma = cauchy_stress(medium, first);
    S const power = sigma.cwiseProduct(h).sum();
    claim.equal("power of the stress along a metric", model, power, S(rate * S(2) * at.rho / at.J));
    claim.differs("without J", model, power, S(rate * S(2) * at.rho));
    claim.differs("without the 2", model, power, S(rate * at.rho / at.J));
    S upper(0);
    for (int a = 0; a < n; ++a)
      for (int b = a; b < n; ++b) upper += sigma(a, b) * h(a, b);
    // Off the diagonal the derivative along one pair is twice as large.
    claim.refutes("each pair of indices once", model, S(upper - power), magnitude(sigma));
    Matrix const pressure = inverse_matrix(Matrix(fluid.g(j.y))) * S(-material_pressure(fluid, first));
    claim.equal("of a fluid, the pressure", model, cauchy_stress(fluid, first), pressure);
  });
}

STATEMENT(eq_6_18, "the Euler-Lagrange equation of a barotropic fluid") {
  claim.corrected(R"(\rho\,g_{ab}\Bigl(\frac{D_g\dot\phi}{Dt}\Bigr)^b = -\frac{\partial P}{\partial x^k}\,J\Bigl(\bigl(\tfrac{\partial\phi}{\partial x}\bigr)^{-1}\Bigr)^k)",
                  R"(\rho\,g_{ab}\Bigl(\frac{D_g\dot\phi}{Dt}\Bigr)^b = -\frac{\partial P}{\partial x^k}\,J\Bigl(\bigl(\tfrac{\partial\phi}{\partial x}\bigr)^{-1}\Bigr)^k_a)",
                  "The inverse gradient lacks its lower index $a$. Otherwise right, with a mass density that varies.");
  claim.maybe_scan();
  over_media<S>(draw, [&]<class Medium, class Fluid, int n>(Medium const&, Fluid const& fluid, SecondJet<S, n, n> const& j, std::string const& model) {
    using Column = actio::Matrix<S, n, 1>;
    Jet<S, n, n> const& first = j;
    auto const at = point_of_medium(fluid, first);
    Column const E = field_equations(fluid, j), slope = pressure_slopes(fluid, j), mass = inertia(fluid, j);
    claim.equal("(6.18) and (6.12)", model, fluid_equation(fluid, j), E);
    claim.differs("as printed, with the only index contracted", model, (mass + Column::Constant((at.inverse * slope).sum() * at.J)).eval(), E);
    claim.differs("the inverse transposed", model, (mass + at.inverse * slope * at.J).eval(), E);
    claim.differs("without J", model, (mass + at.inverse.transpose() * slope).eval(), E);
    // The pressure of a fluid of constant mass density, that at the particle.
    Fluid even = fluid;
    even.rho.added.constant = at.rho - S(2);
    for (auto* c : {&even.rho.added.a, &even.rho.added.b, &even.rho.added.d, &even.rho.added.e}) c->setZero();
    Column const level = pressure_slopes(even, j);
    claim.differs("the mass density outside the derivative", model, (mass + at.inverse.transpose() * level * at.J).eval(), E);
  });
}

STATEMENT(eq_6_20, "the equation of motion with stresses, general stored energy") {
  claim.holds("With the covariant divergence as corrected there.");
  over_media<S>(draw, [&]<class Medium, class Fluid, int n>(Medium const& medium, Fluid const&, SecondJet<S, n, n> const& j, std::string const& model) {
    using Column = actio::Matrix<S, n, 1>;
    Jet<S, n, n> const& first = j;
    auto const at = point_of_medium(medium, first);
    Column const E = field_equations(medium, j), balance = inertia(medium, j) - stress_divergence(medium, j);
    claim.equal("(6.20) and (6.12)", model, stress_equation(medium, j), E);
    claim.differs("without the symbols of space", model, balance, E);
    auto const gamma = christoffel(medium.g, j.y);
    actio::Matrix<S, n, n> const plus = first_piola_kirchhoff_stress(medium, first) * at.F.transpose() + at.g * cauchy_stress(medium, first) * at.J;
    Column added = balance;
    for (int a = 0; a < n; ++a)
      for (int b = 0; b < n; ++b)
        for (int c = 0; c < n; ++c) added[a] -= gamma[b](a, c) * plus(b, c);
    claim.differs("the Cauchy stress with the other sign", model, added, E);
  });
}
=======
>>>>>>> number
