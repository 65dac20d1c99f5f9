// Scalars: rational, double
// Section 6.2: the Cartan form of a general density, its field equations, and the multisymplectic form formula.
#include "fields.hpp"

#include "statement.hpp"
#include "variations.hpp"

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

/// A section of the jet bundle that is no jet: the places of one section and the derivatives of another.
template <class Phi, class Psi>
auto not_holonomic(Phi const& phi, Psi const& psi) {
  return [phi, psi]<class T, int rows>(Eigen::Matrix<T, rows, 1> const& x) {
    auto j = first_jet(phi, x);
    j.v = first_jet(psi, x).v;
    return coordinates(j);
  };
}

/// A density, a section and a point of space-time, with the second jet there.
template <class S, int n, int N>
struct OffShell {
  static constexpr int dimension = Jet<S, n, N>::dimension;
  AnyDensity<S, n, N> L;
  AnySection<S, n, N> phi;
  Event<S, n> x;
  SecondJet<S, n, N> j;
  Eigen::Matrix<S, N, 1> E;

  explicit OffShell(Draw& draw)
      : L(draw_density<S, n, N>(draw)), phi(draw_section<S, n, N>(draw)), x(draw_event<S, n>(draw)), j(second_jet(phi, x)), E(euler_lagrange(L, j)) {}

  /// The coefficient of \f$(j^1\phi)^*(W\lrcorner\,\Omega)\f$, or of a pull-back by another section of the jet bundle, for a constant field W on it.
  S contraction(Eigen::Matrix<S, dimension, 1> const& W) const { return contraction(W, jet_extension(phi), L); }
  template <class Map, class Density>
  S contraction(Eigen::Matrix<S, dimension, 1> const& W, Map const& map, Density const& density) const {
    return coefficient_of(pull_back(map, contract(ConstantField<S, dimension>{W}, multisymplectic_form<n, N>(density))), x);
  }
  Jet<S, n, N> const& first() const { return j; }
};

/// The variation along a section of first degree, with derivatives v, that has a given vertical part and moves space-time by any field: \f$(V^\mu, Q^a + v^a{}_\mu V^\mu)\f$.
template <class S, int n, int N, class Q>
struct WithVerticalPart {
  Q vertical;
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

using Two = std::tuple<Dimensions<2, 2>, Dimensions<1, 3>>;

}  // namespace

STATEMENT(eq_6_8, "Euler-Lagrange derivative through the multisymplectic form") {
  claim.corrected("D_{EL}\\mathcal L\\cdot\\mathcal V = (j^1)^*[j^1\\mathcal V\\lrcorner\\Omega_{\\mathcal L}]", "D_{EL}\\mathcal L\\cdot\\mathcal V = -(j^1)^*[j^1\\mathcal V\\lrcorner\\Omega_{\\mathcal L}]",
                  "With Omega = -dTheta, as it is set after (6.6), the sign is the other one.");
  // A density of degree 33 in what is drawn, differentiated twice, times a field of degree 21.
  claim.degree(80);
  over_dimensions(Two{}, [&]<class D>(D, std::string const& model) {
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
  claim.holds("The wedge with d^{n+1}x is contracted with the variation and pulled back.");
  claim.degree(60);
  over_dimensions(FewDimensions{}, [&]<class D>(D, std::string const& model) {
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
  over_dimensions(Two{}, [&]<class D>(D, std::string const& model) {
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
  over_dimensions(FewDimensions{}, [&]<class D>(D, std::string const& model) {
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
  claim.holds("The sections are those of Y: for sections of the jet bundle that are no jets, the density has to be regular.");
  claim.degree(80);
  over_dimensions(Two{}, [&]<class D>(D, std::string const& model) {
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
    Forced<AnyDensity<S, n, N>, S, N> const solved{m.L, -m.E};
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
  over_dimensions(FewDimensions{}, [&]<class D>(D, std::string const& model) {
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
  over_dimensions(FewDimensions{}, [&]<class D>(D, std::string const& model) {
    OffShell<S, D::n, D::N> const m(draw);
    claim.equal("(6.12) equals (6.9)", model, momentum_divergence(m.L, m.j), expanded_divergence(m.L, m.j));
    claim.differs("without the derivative in y", model, momentum_divergence(m.L, m.j), expanded_divergence(m.L, m.j, true, false));
  });
}

STATEMENT(thm_6_2_2, "multisymplectic form formula") {
  claim.holds("Off shell the divergence of the current is V . dE[W] - W . dE[V] for vertical variations, so both are to solve the linearised equations.");
  claim.degree(160);
  over_dimensions(FewDimensions{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = D::N;
    OffShell<S, n, N> const m(draw);
    // The linearised equations are to have a solution for the accelerations.
    Regular<AnyDensity<S, n, N>> const L{m.L};
    auto const V = draw_section<S, n, N>(draw), W = draw_section<S, n, N>(draw);
    auto const divergence_of = [&](auto const& v, auto const& w) {
      return divergence([&]<class T>(Event<T, n> const& x) { return multisymplectic_current(L, first_jet(m.phi, x), first_jet(v, x), first_jet(w, x)); }, m.x);
    };
    auto const j = second_jet(V, m.x), k = second_jet(W, m.x);
    S const left = divergence_of(V, W), first = j.y.dot(linearised_euler_lagrange(L, m.j, k)), second = k.y.dot(linearised_euler_lagrange(L, m.j, j));
    S const scale = magnitude(left) + magnitude(first) + magnitude(second);
    claim.zero("off shell: divergence V . dE[W] - W . dE[V]", model, S(left - first + second), scale);
    // First variations at this point, of the section as it is: a force of the section's own changes nothing in the linearised equations.
    auto const v = first_variation_at(L, m.j, V), w = first_variation_at(L, m.j, W);
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
  over_dimensions(std::tuple<Dimensions<1, 2>, Dimensions<2, 1>>{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = D::N;
    // In a medium that is the same everywhere, uniform strain is a solution, and variations of second degree solve the linearised equations.
    auto const L = draw_uniform_density<S, n, N>(draw);
    auto const phi = draw_section_of_degree<S, n, N>(draw, 1);
    auto const box = draw_box<S, n>(draw);
    auto const j = second_jet(phi, Event<S, n>(Event<S, n>::Zero()));
    auto const any = draw_section_of_degree<S, n, N>(draw, 2);
    auto const field_of = [&j](auto const& Q, auto const& along) { return WithVerticalPart<S, n, N, std::remove_cvref_t<decltype(Q)>>{Q, along, j.v}; };
    auto const horizontal = [&] { return draw_variation<S, n, N>(draw, 2); };
    auto const V = field_of(first_variation_at(L, j, draw_section_of_degree<S, n, N>(draw, 2)), horizontal());
    auto const through = [&](auto const& W) {
      auto const form = contract(prolonged<n, N>(V), contract(prolonged<n, N>(W), multisymplectic_form<n, N>(L)));
      return boundary_integral(pull_back(jet_extension(phi), form), box, 4);
    };
    auto const along = horizontal();
    S const scale = magnitude(through(field_of(any, along)));
    // Sums over up to 25 nodes on each side, and accelerations from one elimination.
    claim.zero("two first variations, horizontal parts included", model, through(field_of(first_variation_at(L, j, any), along)), scale, 10);
    claim.refutes("one of them not a first variation", model, scale, S(1));
  });
}
