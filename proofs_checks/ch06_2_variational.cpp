// Section 6.2: the variational principle and the Cartan form that comes out of it. Variations move space-time
// as well; integrals over boxes are exact.
//
// In a unit of its own, which is as large as a unit may be.

#include "fields/fields.hpp"
#include "fields/off_shell.hpp"
#include "fields/variations.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

/// Few coordinates in all, for what differentiates many times; a plane in a plane, and a body of three
/// dimensions.
using Varied = std::tuple<Dimensions<1, 2>, Dimensions<2, 1>, Dimensions<2, 2>, Dimensions<3, 1>>;

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

}  // namespace

STATEMENT(eq_6_7, "variation of the field action for arbitrary variations") {
  claim.convention(
      "The derivative $D_{EL}\\mathcal L\\cdot V$ contracts $V$ into $dy^a\\wedge d^{n+1}x$ and pulls "
      "back: it is $E_a(V^a - \\phi^a{}_{,\\mu}V^\\mu)$, and $E_aV^a$ for vertical variations alone.");
  // A density of degree 33 in what is drawn, differentiated twice, times a field on Y of degree 21.
  over_dimensions(Varied{}, [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
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
    auto const form = pull_back(jet_extension(phi), contract(prolonged<n, N>(V), cartan_form<n, N>(L)));
    claim.equal("the boundary term is the pull-back of j1V hook Theta", model, components_of(form, x),
                Event<S, n>(boundary_current(L, first_jet(phi, x), rate)));
  });
}

namespace {

/// What (6.7) determines along a section at a point: the coefficients of D_EL on \f$V^\mu\f$ and \f$V^a\f$,
/// and those of the boundary term, \f$B^\mu = B_i{}^\mu V^i\f$.
template <class S, int n, int N>
struct Determined {
  static constexpr int all = n + 1 + N, unknowns = all * (n + 2);
  Matrix<S, all, 1> D;
  Matrix<S, all, n + 1> B;

  /// \f$D_iV^i + \partial_\mu(B_i{}^\mu V^i)\f$ needs the rates of B as well: \f$K_i = D_i +
  /// \partial_\mu B_i{}^\mu\f$.
  Matrix<S, all, 1> K;

  /// All unknowns at once, from as many variations: the rate of the density under V is \f$K_iV^i +
  /// B_i{}^\mu\partial_\mu V^i\f$ at every point of the section.
  template <class L, class Phi>
  Determined(L const& density, Phi const& phi, std::vector<AnyVariation<S, n, N>> const& variations,
             Event<S, n> const& at) {
    auto const solved = [&]<class T>(Event<T, n> const& x) {
      Matrix<T, Dynamic, Dynamic> rows(unknowns, unknowns), rates(unknowns, 1);
      for (int k = 0; k < unknowns; ++k) {
        auto const& V = variations[k];
        auto const [value, slope] = derivative([&](auto const& u) { return V(graph(phi, u)); }, x);
        for (int i = 0; i < all; ++i) {
          rows(k, i) = value[i];
          for (int mu = 0; mu <= n; ++mu) rows(k, all * (mu + 1) + i) = slope(i, mu);
        }
        rates(k, 0) = density_variation(density, phi, V, x);
      }
      Matrix<T, unknowns, 1> const found = solve_linear(rows, rates, "Determined");
      return found;
    };
    auto const [value, slope] = derivative(solved, at);
    for (int i = 0; i < all; ++i) {
      K[i] = D[i] = value[i];
      for (int mu = 0; mu <= n; ++mu)
        B(i, mu) = value[all * (mu + 1) + i], D[i] -= slope(all * (mu + 1) + i, mu);
    }
  }
};
template <class S, int n, int N>
std::vector<AnyVariation<S, n, N>> draw_variations(Draw& draw) {
  std::vector<AnyVariation<S, n, N>> V;
  for (int k = 0; k < Determined<S, n, N>::unknowns; ++k) V.push_back(draw_variation<S, n, N>(draw, 3));
  return V;
}
/// Whether numbers are machine words, with which large systems cost little.
bool numbers_are_words() {
  auto const kind = current_arithmetic().kind();
  return kind == ArithmeticKind::hardware || kind == ArithmeticKind::prime;
}
/// An elimination in up to 25 unknowns with drawn coefficients has condition numbers of thousands.
constexpr double of_elimination = 1e4;

/// Both parts of (6.7) solved for, and compared with (6.9) and (6.10).
template <class S, int n, int N>
void determined_from_variations(Claim<S>& claim, Draw& draw, Dimensions<n, N>, std::string const& model) {
  using Column = Matrix<S, n + 1 + N, 1>;
  using Flux = Matrix<S, n + 1 + N, n + 1>;
  auto const L = draw_low_density<S, n, N>(draw);
  auto const phi = draw_section_of_degree<S, n, N>(draw, 2);
  auto const x = draw_event<S, n>(draw);
  auto variations = draw_variations<S, n, N>(draw);
  Determined<S, n, N> const found(L, phi, variations, x);
  // One more variation, which was not used.
  auto const V = draw_variation<S, n, N>(draw, 3);
  auto const [value, slope] = derivative([&](auto const& u) { return V(graph(phi, u)); }, x);
  S const rate = density_variation(L, phi, V, x);
  claim.zero("they exist: the same coefficients serve another variation", model,
             S(rate - found.K.dot(value) - found.B.cwiseProduct(slope).sum()),
             magnitude(found.K) + magnitude(found.B) * magnitude(slope), of_elimination);
  auto const j = second_jet(phi, x);
  Matrix<S, N, 1> const E = euler_lagrange(L, j);
  Column D_EL;
  D_EL << -(j.v.transpose() * E), E;
  claim.equal("D_EL is E_a (dy^a - v^a_mu dx^mu), and nothing else", model, found.D, D_EL, of_elimination);
  auto const z = legendre(L, static_cast<Jet<S, n, N> const&>(j));
  Flux theta, without = Flux::Zero();
  S const value_of_L = L(static_cast<Jet<S, n, N> const&>(j));
  theta << -(j.v.transpose() * z.p) + Matrix<S, n + 1, n + 1>::Identity() * value_of_L, z.p;
  without.template bottomRows<N>() = z.p;
  claim.equal("the boundary term is that of (6.10), and no other", model, found.B, theta, of_elimination);
  claim.differs("that of dy^a ^ d^nx_mu alone", model, found.B, without);
  Column upright = D_EL;
  upright.template head<n + 1>().setZero();
  claim.differs("D_EL is E_a dy^a", model, found.D, upright);
  for (auto& W : variations) W = W.upright();
  claim.template refuses<Singular>("vertical variations determine them", model,
                                   [&] { Determined<S, n, N>(L, phi, variations, x); });
}

}  // namespace

STATEMENT(thm_6_2_1, "Euler-Lagrange derivative and Cartan form from the variational principle") {
  claim.corrected(
      "D_{EL}\\mathcal L\\cdot\\mathcal V = (j^1)^*[j^1\\mathcal V\\lrcorner\\Omega_{\\mathcal L}]",
      "D_{EL}\\mathcal L\\cdot\\mathcal V = -(j^1)^*[j^1\\mathcal V\\lrcorner\\Omega_{\\mathcal L}]",
      "(6.7), (6.9) and (6.10) hold; (6.8) has the other sign with $\\Omega = -d\\Theta$. All coefficients "
      "of $D_{EL}\\mathcal L$ and of the boundary term are solved for from as many variations; the form is "
      "unique among the $a_a{}^\\mu\\,dy^a\\wedge d^nx_\\mu + b\\,d^{n+1}x$, whose coefficients the "
      "boundary term gives, and not among all forms: see claim_6_2_cartan_form_uniqueness.");
  claim.same_slip_as("eq_6_8");
  // Integrals of polynomials of degree 6 in x over a drawn box.
  over_dimensions(SmallDimensions{}, [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
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
  // Rates of a density of degree 20 under cubics, and an elimination.
  over_dimensions(Varied{}, [&](auto dimensions, std::string const& model) {
    if (dimensions.n + dimensions.N > 3 && !numbers_are_words()) return;
    determined_from_variations(claim, draw, dimensions, model);
  });
}

namespace {

/// A section with a multiple of \f$(e\cdot(x - x_0))^k\f$ added to its first place: the jets of order below k
/// at \f$x_0\f$ are the same.
template <class S, int n, class Phi>
struct Touching {
  Phi phi;
  Event<S, n> start, e;
  int order;
  template <class X>
  auto operator()(X const& x) const {
    using T = ScalarOf<X>;
    auto y = phi(x);
    T along(0), power(1);
    for (int mu = 0; mu <= n; ++mu) along += (x[mu] - T(start[mu])) * T(e[mu]);
    for (int k = 0; k < order; ++k) power *= along;
    y[0] += power;
    return y;
  }
};

/// \f$x_0^ix_1^k\f$ times one of the places' directions, for two coordinates of space-time.
struct Monomial {
  int i, k, direction;
  template <class X>
  auto operator()(X const& point) const {
    using T = ScalarOf<X>;
    X rate = point;
    T value(1);
    for (int c = 0; c < i; ++c) value *= point[0];
    for (int c = 0; c < k; ++c) value *= point[1];
    for (int c = 0; c < rate.size(); ++c) rate[c] = T(0);
    rate[2 + direction] = value;
    return rate;
  }
};
inline std::vector<std::pair<int, int>> second_degree() {
  return {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}};
}

/// D_EL along a section of second degree is one too: its coefficients, from the action's rates under
/// variations that vanish on the boundary of one box.
template <class S>
void determined_from_one_box(Claim<S>& claim, Draw& draw) {
  constexpr int n = 1, N = 2, degree = 7;
  std::string const model = "n = 1, N = 2, one box";
  auto const L = draw_low_density<S, n, N>(draw);
  auto const phi = draw_section_of_degree<S, n, N>(draw, 2);
  auto const box = draw_box<S, n>(draw);
  auto const powers = second_degree();
  Matrix<S, 6, 6> products;
  Matrix<S, 6, N> rates;
  for (int r = 0; r < 6; ++r) {
    auto const field = [&](int a) {
      return Inside<S, n, Monomial>{{powers[r].first, powers[r].second, a}, box};
    };
    for (int a = 0; a < N; ++a) rates(r, a) = action_variation(L, phi, field(a), box, degree);
    for (int c = 0; c < 6; ++c)
      products(r, c) = integral(
          [&](Event<S, n> const& x) {
            Matrix<S, 4, 1> point = Matrix<S, 4, 1>::Zero();
            point.template head<2>() = x;
            return S(field(0)(point)[2] * Monomial{powers[c].first, powers[c].second, 0}(point)[2]);
          },
          box.low, box.high, degree);
  }
  auto const coefficients = solve_linear(products, rates, "determined_from_one_box");
  auto const x = draw_event<S, n>(draw);
  auto const j = second_jet(phi, x);
  auto still = j;
  for (auto& w : still.w) w.setZero();
  Matrix<S, N, 1> found = Matrix<S, N, 1>::Zero();
  for (int c = 0; c < 6; ++c) {
    S value(1);
    for (int k = 0; k < powers[c].first; ++k) value *= x[0];
    for (int k = 0; k < powers[c].second; ++k) value *= x[1];
    found += Matrix<S, N, 1>(coefficients.row(c).transpose() * value);
  }
  Matrix<S, N, 1> const E = euler_lagrange(L, j);
  // Moments of polynomials of second degree: condition numbers of thousands.
  claim.zero("the one polynomial with these moments is E", model, Matrix<S, N, 1>(found - E),
             S(magnitude(E) + magnitude(partial_y(L, static_cast<Jet<S, n, N> const&>(j)))), of_elimination);
  claim.differs("E without the second derivatives", model, found, Matrix<S, N, 1>(euler_lagrange(L, still)));
}

}  // namespace

STATEMENT(claim_6_2_euler_lagrange_map_unique, "uniqueness of the Euler-Lagrange derivative") {
  claim.holds(
      "Whatever boundary term (6.7) is written with: from variations that vanish on the boundary of one "
      "box, and from all variations at a point. It is a function of second jets: sections with one second "
      "jet have one $D_{EL}\\mathcal L$.");
  claim.leaves(
      "Bodies of dimension three are not tried: integrals over boxes of four dimensions cost much, and no "
      "coefficient here depends on the dimension.");
  determined_from_one_box(claim, draw);
  over_dimensions(SmallDimensions{}, [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
    auto const L = draw_low_density<S, n, N>(draw);
    auto const phi = draw_section_of_degree<S, n, N>(draw, 2);
    auto const x = draw_event<S, n>(draw), e = draw_event<S, n>(draw);
    if (n > 1 && !numbers_are_words()) return;
    auto const variations = draw_variations<S, n, N>(draw);
    auto const solved = [&](auto const& section) { return Determined<S, n, N>(L, section, variations, x).D; };
    auto const touching = [&](int order) {
      return Touching<S, n, AnySection<S, n, N>>{phi, x, Event<S, n>(e * S(4)), order};
    };
    auto const here = solved(phi);
    claim.equal("sections with one second jet", model, solved(touching(3)), here, of_elimination);
    claim.differs("sections with one first jet", model, solved(touching(2)), here);
  });
}

namespace {

/// The field E(x) along a section, vertical.
template <int n, class L, class Phi>
struct ForceAlong {
  L density;
  Phi phi;
  template <class X>
  auto operator()(X const& point) const {
    using T = ScalarOf<X>;
    X rate = point;
    rate.template head<n + 1>().setConstant(T(0));
    rate.template tail<X::RowsAtCompileTime - n - 1>() =
        euler_lagrange(density, second_jet(phi, Event<T, n>(point.template head<n + 1>())));
    return rate;
  }
};

}  // namespace

STATEMENT(claim_6_2_critical_point, "critical points of the action and admissible variations") {
  claim.convention(
      "Admissible variations vanish on the boundary of $U$; with all variations, natural boundary "
      "conditions are imposed as well. Both directions: with $V$ a bump times $E$ the rate is the "
      "integral of the bump times $|E|^2$.");
  claim.leaves(
      "Bodies of dimension three are not tried: integrals over boxes of four dimensions cost much, and no "
      "coefficient here depends on the dimension.");
  over_dimensions(SmallDimensions{}, [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
    using Density = AnyDensity<S, n, N>;
    using Section = AnySection<S, n, N>;
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
    auto const over_box = [&](auto const& field) {
      return integral(
          [&](Event<S, n> const& x) {
            return bulk(L, second_jet(other, x), Variation<S, n, N>(field(graph(other, x))));
          },
          box.low, box.high, 6);
    };
    // Sums over up to 343 nodes.
    claim.zero("dS.V at a solution, V zero on the boundary", model, stationary, magnitude(free), 10);
    claim.refutes("V not zero on the boundary", model, free, magnitude(L(first_jet(solution, box.low))));
    claim.refutes("a section that solves nothing", model, elsewhere, magnitude(free));
    claim.equal("dS.V of any section, V zero on the boundary, is the integral of E", model, elsewhere,
                over_box(admissible), 10);
    // Only if: a variation that no section but a solution leaves without effect. The momenta are of second
    // degree, the variation of third in each coordinate.
    if (n == 1 || !numbers_grow()) {
      Inside<S, n, ForceAlong<n, Density, Section>> const pushing{{L, other}, box};
      S const work = action_variation(L, other, pushing, box, 5);
      claim.equal("V = E within the boundary: the integral of |E|^2", model, work, over_box(pushing), 10);
      if (ordered_arithmetic<S>()) claim.fact("which is positive", model, work > S(0));
    }
    // All variations: with momenta and density that vanish on the boundary.
    auto natural = L;
    auto const j = first_jet(solution, box.low);
    auto const p = momenta(L, j);
    for (int mu = 0; mu <= n; ++mu)
      for (int a = 0; a < N; ++a) natural.l.a[place_of_derivative<n, N>(a, mu)] -= p(a, mu);
    natural.l.constant -= natural(j);
    claim.zero("dS.V for every V, with natural boundary conditions", model,
               action_variation(natural, solution, V, box, 3), magnitude(free), 10);
  });
}

STATEMENT(claim_6_2_vertical_variations, "Cartan form obtained from vertical variations only") {
  claim.holds(
      "The missing term is the whole of $(L - p_a{}^\\mu v^a{}_\\mu)\\,d^{n+1}x$. Vertical variations do "
      "not determine it, and give the field equations and the other coefficients without it.");
  over_dimensions(Varied{}, [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
    auto const L = draw_density<S, n, N>(draw);
    auto const phi = draw_section<S, n, N>(draw);
    auto const V = draw_variation<S, n, N>(draw, 2), upright = V.upright();
    auto const x = draw_event<S, n>(draw);
    auto const j = second_jet(phi, x);
    // The boundary term without d^{n+1}x, in (6.7): it serves the vertical variations, and no others.
    auto const rest = [&](auto const& field) {
      S const force = bulk(L, j, field(graph(phi, x))),
              flux = divergence(current_along(L, phi, field, false), x);
      return std::pair{S(density_variation(L, phi, field, x) - force - flux),
                       S(magnitude(force) + magnitude(flux))};
    };
    auto const [of_vertical, vertical_size] = rest(upright);
    auto const [of_any, size] = rest(V);
    claim.zero("field equations from a vertical variation, without the term d^{n+1}x", model, of_vertical,
               vertical_size);
    claim.refutes("the same for any variation", model, of_any, size);
    Matrix<S, N, n + 1> found;
    for (int a = 0; a < N; ++a) found.row(a) = symbol_of_variation<S, n, N>(L, phi, x, n + 1 + a).transpose();
    claim.equal("vertical variations determine the coefficients of dy^a ^ d^nx_mu", model, found,
                legendre(L, first_jet(phi, x)).p);
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

namespace {

/// A function times \f$dy^a - v^a{}_\mu dx^\mu\f$.
template <int n, int N, class F>
auto contact_form(int a, F const& f) {
  return [a, f]<class T, int D>(Matrix<T, D, 1> const& at, Tangents<T, D, 1> const& V) -> T {
    auto const j = jet_at<n, N>(at);
    T sum = V(n + 1 + a, 0);
    for (int mu = 0; mu <= n; ++mu) sum -= j.v(a, mu) * V(mu, 0);
    return f(at) * sum;
  };
}
/// \f$d^{n-1}x_{01}\f$: the volume form contracted twice.
template <int n>
auto twice_contracted() {
  auto const d_1 = []<class T, int D>(Matrix<T, D, 1> const&) {
    return Matrix<T, D, 1>(Matrix<T, D, 1>::Unit(1));
  };
  return contract(d_1, volume_form<n>(0));
}
/// \f$c_a{}^{\mu\nu}\,dv^a{}_\mu\wedge d^nx_\nu\f$: `c[a](mu, nu)`.
template <int n, int N, class S>
auto of_derivatives(std::array<Matrix<S, n + 1, n + 1>, N> const& c) {
  return [c]<class T, int D>(Matrix<T, D, 1> const& at, Tangents<T, D, n + 1> const& V) -> T {
    T sum(0);
    for (int a = 0; a < N; ++a)
      for (int mu = 0; mu <= n; ++mu)
        for (int nu = 0; nu <= n; ++nu)
          sum += T(c[a](mu, nu)) * wedge(differential_of_coordinate(place_of_derivative<n, N>(a, mu)),
                                         volume_form<n>(nu))(at, V);
    return sum;
  };
}

/// Without a body the boundary of U is two points, and at each j1V can be any tangent vector of the jet
/// bundle: a one-form that is added to the Cartan form is known by what it adds.
template <class S>
void without_body(Claim<S>& claim, Draw& draw) {
  constexpr int N = 2, all = Jet<S, 0, N>::dimension;
  auto const phi = draw_section<S, 0, N>(draw);
  auto const x = draw_event<S, 0>(draw);
  auto const added = draw.vector<S, Matrix<S, all, 1>>(all);
  auto const one_form = [&added]<class T, int D>(Matrix<T, D, 1> const&, Tangents<T, D, 1> const& V) -> T {
    return V.col(0).dot(added.template cast<T>());
  };
  Matrix<S, all, all> fields;
  Matrix<S, all, 1> seen;
  for (int k = 0; k < all; ++k) {
    auto const V = draw_variation<S, 0, N>(draw, 3);
    fields.row(k) = prolonged<0, N>(V)(coordinates(first_jet(phi, x))).transpose();
    seen[k] = pull_back(jet_extension(phi), contract(prolonged<0, N>(V), one_form))(x, Tangents<S, 1, 0>());
  }
  auto const found = solve_linear(fields, seen, "without_body");
  claim.equal("n = 0: all coefficients of an added one-form", "n = 0, N = 2", found, added, of_elimination);
  Matrix<S, all, 1> without = added;
  without.template tail<N>().setZero();
  claim.differs("n = 0: those of the derivatives are not seen", "n = 0, N = 2", found, without);
}

}  // namespace

STATEMENT(claim_6_2_cartan_form_uniqueness, "uniqueness of the form fixed by the variational principle") {
  claim.convention(
      "Unique among the forms $a_a{}^\\mu\\,dy^a\\wedge d^nx_\\mu + b\\,d^{n+1}x$, and only if variations "
      "are not all vertical. Among all forms on the jet bundle products of contact forms and "
      "$d(f\\theta^a\\wedge d^{n-1}x_{\\mu\\nu})$ may be added; a symmetric part of the coefficients of "
      "$dv^a{}_\\mu\\wedge d^nx_\\nu$ may not. For $n = 0$ it is unique among all one-forms.");
  without_body(claim, draw);
  // Products of a polynomial of second degree on jets and derivatives of cubics.
  over_dimensions(Varied{}, [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
    constexpr int all = Jet<S, n, N>::dimension;
    auto const L = draw_density<S, n, N>(draw);
    auto const phi = draw_section<S, n, N>(draw);
    auto const x = draw_event<S, n>(draw);
    auto const V = draw_variation<S, n, N>(draw, 2);
    auto const theta = cartan_form<n, N>(L);
    auto const f = cut(draw_cubic<S, all>(draw), 2);
    auto const at = coordinates(first_jet(phi, x));
    auto const U = draw_tangents<S, all, n + 1>(draw);
    // The divergence of the boundary term that a form makes: what the action would see of it.
    auto const seen = [&](auto const& form) {
      auto const flux = [&](auto const& u) {
        return components_of(pull_back(jet_extension(phi), contract(prolonged<n, N>(V), form)), u);
      };
      // What it is made of: the rates of j1V along the section.
      auto const lifted = [&](auto const& u) { return prolonged<n, N>(V)(coordinates(first_jet(phi, u))); };
      return std::pair<S, S>(derivative(flux, x).matrix.trace(), S(magnitude(derivative(lifted, x).matrix)));
    };
    auto const unseen = [&](char const* what, auto const& form) {
      auto const [sum, size] = seen(form);
      claim.zero(what, model, sum, size);
      claim.differs(std::string("Theta with it is Theta: ") + what, model, S(theta(at, U) + form(at, U)),
                    theta(at, U));
    };
    unseen("the action is independent of d(f theta ^ d^{n-1}x)",
           exterior_derivative(wedge(contact_form<n, N>(N - 1, f), twice_contracted<n>())));
    if constexpr (N > 1) {
      auto const one = []<class T, int rows>(Matrix<T, rows, 1> const&) { return T(1); };
      unseen("the action is independent of a product of contact forms",
             wedge(contact_form<n, N>(0, one), wedge(contact_form<n, N>(1, f), twice_contracted<n>())));
    }
    std::array<Matrix<S, n + 1, n + 1>, N> skew, symmetric;
    for (int a = 0; a < N; ++a) {
      Matrix<S, n + 1, n + 1> const c = draw_tangents<S, n + 1, n + 1>(draw);
      skew[a] = c - c.transpose(), symmetric[a] = c + c.transpose();
    }
    unseen("the action is independent of skew coefficients of dv ^ d^nx", of_derivatives<n, N, S>(skew));
    auto const [sum, size] = seen(of_derivatives<n, N, S>(symmetric));
    claim.refutes("the action is independent of symmetric coefficients of dv ^ d^nx", model, sum, size);
    // Within the class: a form that contracts to zero with every variation is zero. Its coefficients are read
    // off coordinate fields.
    auto const j = first_jet(phi, x);
    auto z = legendre(L, j);
    z.p = draw_tangents<S, N, n + 1>(draw), z.Pi = draw.number<S>();
    auto const in_class = [&z]<class T, int E>(Matrix<T, E, 1> const& c,
                                               Tangents<T, E, n + 1> const& W) -> T {
      return affine_form<n, N>(z.p.template cast<T>().eval(), T(z.Pi), c, W);
    };
    auto const along = [&](int i) {
      ConstantField<S, all> const unit{Matrix<S, all, 1>::Unit(i)};
      return components_of(pull_back(jet_extension(phi), contract(unit, in_class)), x);
    };
    auto const upright = [&] {
      Matrix<S, N, n + 1> rows;
      for (int a = 0; a < N; ++a) rows.row(a) = along(n + 1 + a).transpose();
      return rows;
    };
    claim.equal("coefficients of dy^a ^ d^nx_mu, from vertical fields", model, upright(), z.p);
    auto const in_time = along(0);
    S const spatial = z.p.template rightCols<n>().cwiseProduct(j.gradient()).sum();
    claim.zero("coefficient of d^{n+1}x, from a horizontal field", model, S(in_time[0] - spatial - z.Pi),
               S(magnitude(spatial) + magnitude(z.Pi)));
    auto const before = upright();
    z.Pi += S(1);
    claim.equal("vertical fields do not see that coefficient", model, upright(), before);
    claim.differs("horizontal fields do not see that coefficient", model, along(0), in_time);
  });
}

STATEMENT(claim_6_2_cartan_form_two_routes, "variational and Legendre routes to the Cartan form compared") {
  claim.holds(
      "The boundary term is the part of the action's variation that depends on the derivatives of a factor "
      "of $V$; no Cartan form is needed to find it.");
  over_dimensions(Varied{}, [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
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
