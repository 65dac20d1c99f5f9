// Scalars: rational (long: double)
// Section 6.2: the variational principle and the multisymplectic form formula. Variations move space-time as well; integrals over boxes are exact.
#include "variations.hpp"

#include "statement.hpp"

namespace {

using namespace actio;
using namespace actio::checks;

/// \f$E_a\,(V^a - \phi^a{}_{,\mu}V^\mu)\f$, or \f$E_aV^a\f$ if variations are taken for vertical ones.
template <class S, int n, int N, class L>
S bulk(L const& density, SecondJet<S, n, N> const& j, Variation<S, n, N> const& V, bool horizontal = true) {
  Eigen::Matrix<S, N, 1> const E = euler_lagrange(density, j);
  return E.dot(horizontal ? vertical_part(static_cast<Jet<S, n, N> const&>(j), V) : Eigen::Matrix<S, N, 1>(V.template tail<N>()));
}

/// The boundary current of a variation along a section; without the last term of the Cartan form only vertical variations have it right.
template <class L, class Phi, class Field>
auto current_along(L const& density, Phi const& phi, Field const& V, bool complete = true) {
  return [&density, &phi, &V, complete]<class T, int rows>(Eigen::Matrix<T, rows, 1> const& x) {
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
  return [B]<class T, int rows>(Eigen::Matrix<T, rows, 1> const& x, Tangents<T, rows, rows - 1> const& V) -> T {
    Eigen::Matrix<T, rows, rows> all;
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
  return []<class T, int D>(Eigen::Matrix<T, D, 1> const& at, Tangents<T, D, 2> const& V) -> T {
    auto const j = jet_at<1, 2>(at);
    Eigen::Matrix<T, 2, 2> const theta = V.template middleRows<2>(2) - j.v * V.template topRows<2>();
    return determinant(theta);
  };
}

/// The variation along a section of first degree, with derivatives v, that has a given vertical part and moves space-time by any field: \f$(V^\mu, Q^a + v^a{}_\mu V^\mu)\f$.
template <class S, int n, int N>
struct WithVerticalPart {
  Accelerated<S, n, N> vertical;
  AnyVariation<S, n, N> along;
  Eigen::Matrix<S, N, n + 1> v;
  template <class X>
  auto operator()(X const& point) const {
    using T = ScalarOf<X>;
    Variation<T, n, N> rate = along(point);
    Eigen::Matrix<T, N, 1> const y = vertical(Event<T, n>(point.template head<n + 1>()));
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
  claim.degree(80);
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
  claim.degree(120);
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
  claim.degree(160);
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
  claim.degree(80);
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
  claim.degree(80);
  over_points<S>(std::tuple<Dimensions<1, 2>>{}, [&](auto, std::string const& model) {
    auto const L = draw_density<S, 1, 2>(draw);
    auto const phi = draw_section<S, 1, 2>(draw);
    auto const x = draw_event<S, 1>(draw);
    auto const kappa = contact_product();
    auto const theta = cartan_form<1, 2>(L);
    auto const sum = [&]<class T, int D>(Eigen::Matrix<T, D, 1> const& at, Tangents<T, D, 2> const& V) -> T { return theta(at, V) + kappa(at, V); };
    auto const seen = [&](auto const& field, auto const& form) { return components_of(pull_back(jet_extension(phi), contract(field, form)), x); };
    // Any vectors on the jet bundle, prolonged or not.
    ConstantField<S, 8> const W{draw.vector<S, Eigen::Matrix<S, 8, 1>>(8)};
    claim.equal("boundary terms of Theta and of Theta + kappa", model, seen(W, theta), seen(W, sum));
    auto const at = coordinates(first_jet(phi, x));
    auto const U = draw_tangents<S, 8, 2>(draw);
    claim.differs("Theta and Theta + kappa are one form", model, theta(at, U), sum(at, U));
    // Within the class: a variation that sees nothing of a form means that the form is zero. Its coefficients are read off coordinate fields.
    auto z = legendre(L, first_jet(phi, x));
    auto const j = first_jet(phi, x);
    auto const other = draw.vector<S, Eigen::Matrix<S, 5, 1>>(5);
    z.Pi = other[4];
    for (int a = 0; a < 2; ++a)
      for (int mu = 0; mu < 2; ++mu) z.p(a, mu) = other[2 * a + mu];
    auto const in_class = [&z]<class T, int D>(Eigen::Matrix<T, D, 1> const&, Tangents<T, D, 2> const& V) -> T {
      return actio::detail::affine_form<1, 2>(z.p.template cast<T>().eval(), T(z.Pi), V);
    };
    auto const along = [&](int i) { return seen(ConstantField<S, 8>{Eigen::Matrix<S, 8, 1>::Unit(i)}, in_class); };
    Eigen::Matrix<S, 2, 2> read;
    for (int a = 0; a < 2; ++a) read.row(a) = along(2 + a).transpose();
    claim.equal("coefficients of dy^a ^ d^nx_mu, from vertical fields", model, read, z.p);
    S const b = along(0)[0] + z.p.col(0).dot(j.v.col(0)) - (pairing(z, j) - z.Pi);
    claim.zero("coefficient of d^{n+1}x, from a horizontal field", model, S(b - z.Pi), S(4));
    z.Pi = S(0);
    Eigen::Matrix<S, 2, 2> again;
    for (int a = 0; a < 2; ++a) again.row(a) = along(2 + a).transpose();
    claim.equal("vertical fields do not see that coefficient", model, again, read);
    claim.refutes("vertical fields fix it", model, b, S(1));
  });
}

STATEMENT(claim_6_2_cartan_form_two_routes, "variational and Legendre routes to the Cartan form compared") {
  claim.holds("The boundary term is the part of the action's variation that depends on the derivatives of a factor of $V$; no Cartan form is needed to find it.");
  claim.degree(80);
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
  claim.degree(160);
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
  claim.degree(300);
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
