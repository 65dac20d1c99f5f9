// Section 7.2: pointwise constraints, the augmented action, the constrained field equations and the extended
// bundle.
//
// In a unit of its own, which is as large as a unit may be.
#include "actio/constraints/augmented.hpp"
#include "actio/jets/action.hpp"
#include "fields/constrained_models.hpp"
#include "fields/incompressible_models.hpp"
#include "statement.hpp"

namespace {

using namespace actio;
using namespace actio::checks;

/// Two constraints that depend on everything they may: cubics in all coordinates of the jet bundle.
template <class S, int n, int N>
struct AnyConstraint {
  static constexpr int components = 2;
  std::array<Cubic<S, Jet<S, n, N>::dimension>, 2> c;
  template <class T>
  Matrix<T, 2, 1> operator()(Jet<T, n, N> const& j) const {
    auto const at = coordinates(j);
    return {c[0](at), c[1](at)};
  }
};
template <class S, int n, int N>
AnyConstraint<S, n, N> draw_constraint(Draw& draw) {
  auto const cubic = [&] { return draw_cubic<S, Jet<S, n, N>::dimension>(draw, ratio<S>(1, 2)); };
  auto const first = cubic();
  return {{first, cubic()}};
}

/// A column of k cubics over space-time, as a field of multipliers.
template <class S, int n, int k>
struct AnyMultiplier {
  std::array<Cubic<S, n + 1>, k> c;
  template <class V>
  auto operator()(V const& x) const {
    Matrix<ScalarOf<V>, k, 1> lambda;
    for (int i = 0; i < k; ++i) lambda[i] = c[i](x);
    return lambda;
  }
};
template <class S, int n, int k>
AnyMultiplier<S, n, k> draw_multiplier(Draw& draw) {
  AnyMultiplier<S, n, k> lambda;
  for (auto& c : lambda.c) c = draw_cubic<S, n + 1>(draw);
  return lambda;
}

/// The opposite of a field.
template <class S, class A>
SumOfFields<A, A, S> opposite(A const& field) { return {field, field, S(-2)}; }
/// The augmented density, and a section with its multiplier.
template <class L, class Phi>
AugmentedDensity<L, Phi> augmented(L const& density, Phi const& constraint) { return {density, constraint}; }
template <class A, class B>
ExtendedSection<A, B> extended(A const& phi, B const& lambda) { return {phi, lambda}; }

/// A polynomial that vanishes on the sides of the unit box, times a vector.
template <class S, int N>
struct Bump {
  Matrix<S, N, 1> size;
  template <class V>
  auto operator()(V const& x) const {
    using T = ScalarOf<V>;
    T b(1);
    for (int mu = 0; mu < x.size(); ++mu) b *= x[mu] * (T(1) - x[mu]);
    Matrix<T, N, 1> w;
    for (int a = 0; a < N; ++a) w[a] = b * T(size[a]);
    return w;
  }
};

/// The derivative of L - <lambda, Phi> when the multiplier moves.
template <class S, int rows, class L, class Phi, class A, class B, class C>
S rate_in_multiplier(L const& density, Phi const& constraint, A const& phi, B const& lambda, C const& added,
                     Matrix<S, rows, 1> const& x) {
  Dual<S> step(0);
  step.part[0] = S(1);
  Matrix<Dual<S>, rows, 1> const at = x.template cast<Dual<S>>();
  auto const jet = first_jet(phi, at);
  return S((density(jet) - sum_of(lambda, added, step)(at)[0] * constraint(jet)[0]).part[0]);
}

/// A density of the second degree in everything, and a constraint of the second degree, for integrals over a
/// box.
template <class S, int n, int N>
struct Quadratic {
  Matrix<S, Jet<S, n, N>::dimension, 1> a, b;
  S constant;
  template <class T>
  T operator()(Jet<T, n, N> const& j) const {
    auto const c = coordinates(j);
    T first(0), second(0);
    for (int i = 0; i < c.size(); ++i) first += c[i] * T(a[i]), second += c[i] * T(b[i]);
    return first * second + first + T(constant);
  }
};
template <class S, int n, int N>
Quadratic<S, n, N> draw_quadratic(Draw& draw) {
  using V = Matrix<S, Jet<S, n, N>::dimension, 1>;
  V const a = draw.vector<S, V>(V::RowsAtCompileTime);
  V const b = draw.vector<S, V>(V::RowsAtCompileTime);
  return {a, b, draw.number<S>()};
}

/// The same as a constraint.
template <class S, int n, int N>
struct QuadraticConstraint {
  static constexpr int components = 1;
  Quadratic<S, n, N> c;
  template <class T>
  Matrix<T, 1, 1> operator()(Jet<T, n, N> const& j) const { return Matrix<T, 1, 1>(c(j)); }
};

template <class S, int n>
Box<S, n> unit_box() { return {Event<S, n>::Zero(), Event<S, n>::Ones()}; }

/// Bodies as large as their space, and smaller ones.
using ConstrainedDimensions =
    std::tuple<Dimensions<2, 2>, Dimensions<3, 3>, Dimensions<1, 3>, Dimensions<2, 3>>;

/// L - <lambda, Phi> as a density that knows the multiplier as a function of x.
template <class L, class Phi, class Lambda>
auto less_paired(L const& density, Phi const& constraint, Lambda const& lambda) {
  return [=]<class T, int n, int N>(Jet<T, n, N> const& j) {
    return T(density(j) - lambda(j.x).dot(constraint(j)));
  };
}

}  // namespace

STATEMENT(eq_7_1, "induced constraint function on sections") {
  claim.holds(
      "The number of components of $\\Phi$ is the rank of $\\mathcal V$, which the thesis calls $n$; it "
      "need not be the dimension of the body.");
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& name) {
    VolumeConstraint<AnyMetric<S, n>, AnyMetric<S, n>> const Phi{draw_metric<S, n>(draw),
                                                                 draw_metric<S, n>(draw)};
    auto const phi = draw_section<S, n, n>(draw);
    auto const x = draw_event<S, n>(draw);
    // J by the definition of a volume: that of the image of the coordinate vectors, which are pushed
    // forward.
    Tangents<S, n + 1, n> sides = Tangents<S, n + 1, n>::Zero();
    for (int i = 0; i < n; ++i) sides(i + 1, i) = S(1);
    auto const image = pushed(phi, x, sides);
    Matrix<S, n, n> const pulled = image.transpose() * Phi.g(phi(x)) * image;
    Matrix<S, n, 1> const body = x.template tail<n>();
    draw_positive(S(determinant(first_jet(phi, x).gradient())));
    S const J = square_root(determinant(pulled)) / square_root(determinant(Phi.G(body)));
    claim.equal("J - 1 along a section, and from the pulled-back volume", name,
                S(induced_constraint(Phi, phi)(x)[0] + S(1)), J);
    // A jet that is that of no section: the velocities of another one.
    auto j = first_jet(phi, x);
    j.v = first_jet(draw_section<S, n, n>(draw), x).v;
    claim.differs("at a jet that is not the section's", name, S(Phi(j)[0] + S(1)), J);
  });
}

STATEMENT(claim_7_2_augmented_action, "augmented action and its variation in the multiplier") {
  claim.holds(
      "The three forms of the action are equal, and the variation in the multiplier is minus the pairing "
      "with $\\Psi$. In components of an orthonormal frame of $\\mathcal V$.");
  // Integrands: a quadratic density on quadratic sections times a multiplier of degree 3, in 2 coordinates;
  // coefficients enter with degree 5.
  {
    constexpr int n = 1, N = 2;
    std::string const name = "n = 1, N = 2, on a box";
    auto const L = draw_quadratic<S, n, N>(draw);
    QuadraticConstraint<S, n, N> const Phi{draw_quadratic<S, n, N>(draw)};
    auto const phi = draw_section<S, n, N>(draw);
    auto const lambda = draw_multiplier<S, n, 1>(draw);
    auto const box = unit_box<S, n>();
    auto const Psi = induced_constraint(Phi, phi);
    int const degree = 9;
    S const split = action(L, phi, box, degree) -
                    integral([&](Event<S, n> const& x) { return S(lambda(x)[0] * Psi(x)[0]); }, box.low,
                             box.high, degree);
    // The extended density has the other sign of the multiplier.
    auto const minus = opposite<S>(lambda);
    S const whole = action(augmented(L, Phi), extended(phi, minus), box, degree);
    claim.equal("two integrals, and one over the extended bundle", name, split, whole, 10);
    claim.differs("with the multiplier's sign changed", name,
                  action(augmented(L, Phi), extended(phi, lambda), box, degree), split);

    // The variation in the multiplier, taken on dual numbers, is minus the pairing with Psi.
    Bump<S, 1> const delta{Matrix<S, 1, 1>(draw.number<S>() + S(2))};
    auto const varied = [&](auto const& added) {
      return integral([&](Event<S, n> const& x) { return rate_in_multiplier(L, Phi, phi, lambda, added, x); },
                      box.low, box.high, 16);
    };
    S const paired =
        integral([&](Event<S, n> const& x) { return S(delta(x)[0] * Psi(x)[0]); }, box.low, box.high, 16);
    claim.equal("derivative of the augmented action in the multiplier", name, varied(delta), S(-paired), 10);
    // With Psi times a bump as variation it is minus the integral of a square: zero only where Psi is.
    auto const own = [&](auto const& x) { return (delta(x) * Phi(first_jet(phi, x))[0]).eval(); };
    // Over the integral of the bump, 1/36 times its size.
    claim.refutes("variation along the constraint itself, where it does not vanish", name, varied(own),
                  S(delta.size[0] / S(36)));
  }
  // In other dimensions at a point, with two multipliers: the integrands are equal, and their derivatives.
  over_dimensions(ConstrainedDimensions{}, [&]<int n, int N>(Dimensions<n, N>, std::string const& name) {
    auto const L = draw_density<S, n, N>(draw);
    auto const Phi = draw_constraint<S, n, N>(draw);
    auto const phi = draw_section<S, n, N>(draw);
    auto const lambda = draw_multiplier<S, n, 2>(draw), delta = draw_multiplier<S, n, 2>(draw);
    auto const x = draw_event<S, n>(draw);
    auto const j = first_jet(phi, x);
    S const split = L(j) - lambda(x).dot(induced_constraint(Phi, phi)(x));
    auto const whole = [&](auto const& multiplier) {
      return S(augmented(L, Phi)(first_jet(extended(phi, multiplier), x)));
    };
    claim.equal("integrands of the split action and over the extended bundle", name, split,
                whole(opposite<S>(lambda)));
    claim.differs("integrand with the multiplier's sign changed", name, whole(lambda), split);
    S const rate = rate_of_density(augmented(L, Phi), extended(phi, opposite<S>(lambda)),
                                   extended(sum_of(phi, phi, S(-1)), opposite<S>(delta)), x);
    claim.equal("its derivative in the multipliers", name, rate,
                S(-delta(x).dot(induced_constraint(Phi, phi)(x))));
  });
}

STATEMENT(eq_7_2, "constrained Euler-Lagrange equations") {
  claim.holds(
      "They are those of $L - \\langle\\lambda, \\Phi\\rangle$, in components of an orthonormal frame of "
      "$\\mathcal V$; the derivative of the augmented action in $\\phi$ is minus their pairing with the "
      "variation, up to the divergence of a field that vanishes with it.");
  over_dimensions(ConstrainedDimensions{}, [&]<int n, int N>(Dimensions<n, N>, std::string const& name) {
    auto const L = draw_density<S, n, N>(draw);
    auto const Phi = draw_constraint<S, n, N>(draw);
    auto const phi = draw_section<S, n, N>(draw), w = draw_section<S, n, N>(draw, S(1));
    auto const lambda = draw_multiplier<S, n, 2>(draw);
    auto const x = draw_event<S, n>(draw);
    auto const minus = less_paired(L, Phi, lambda);
    auto const printed = constrained_field_equations(L, Phi, second_jet(phi, x), first_jet(lambda, x));
    claim.equal("(7.2), and the field equations of the density", name, printed,
                (-euler_lagrange(minus, phi, x)).eval());
    // The variation itself: cubics of cubics, whose terms cancel in part.
    claim.equal("derivative of the augmented action, and the pairing with (7.2)", name,
                S(rate_of_density(minus, phi, w, x) - divergence_of(boundary_part(minus, phi, w), x)),
                S(-printed.dot(w(x))), 100);
    auto const other = opposite<S>(lambda);
    claim.differs("with the multiplier's sign changed", name,
                  constrained_field_equations(L, Phi, second_jet(phi, x), first_jet(other, x)), printed);
    auto outside = first_jet(lambda, x);
    outside.v.setZero();
    claim.differs("with the multiplier outside of the derivative", name,
                  constrained_field_equations(L, Phi, second_jet(phi, x), outside), printed);
  });
}

STATEMENT(claim_7_2_augmented_lagrangian, "Lagrangian on the extended bundle and its field equations") {
  claim.corrected("L_\\Phi = L + \\langle\\lambda, \\Phi\\rangle",
                  "L_\\Phi = L - \\langle\\lambda, \\Phi\\rangle",
                  "The equations of the printed density are (7.2) with $-\\lambda$ for $\\lambda$; chapter "
                  "8 keeps the printed density, whose multiplier is the pressure, positive in compression.");
  claim.maybe_scan();
  over_dimensions(ConstrainedDimensions{}, [&]<int n, int N>(Dimensions<n, N>, std::string const& name) {
    auto const L = draw_density<S, n, N>(draw);
    auto const Phi = draw_constraint<S, n, N>(draw);
    auto const phi = draw_section<S, n, N>(draw);
    auto const lambda = draw_multiplier<S, n, 2>(draw);
    auto const x = draw_event<S, n>(draw);
    auto const equations = constrained_field_equations(L, Phi, second_jet(phi, x), first_jet(lambda, x));
    auto const plus = augmented(L, Phi);
    auto const minus = opposite<S>(lambda);
    // In the fibre coordinates, the multipliers among them.
    Matrix<S, N + 2, 1> const right = -euler_lagrange(plus, extended(phi, minus), x);
    Matrix<S, N + 2, 1> const printed = -euler_lagrange(plus, extended(phi, lambda), x);
    claim.equal("(7.2), and the field equations of the density with a minus", name, equations,
                Matrix<S, N, 1>(right.template head<N>()));
    claim.equal("the field equations in the multipliers, and the constraint", name,
                Matrix<S, 2, 1>(-right.template tail<2>()), induced_constraint(Phi, phi)(x));
    claim.differs("the field equations of the printed density", name, equations,
                  Matrix<S, N, 1>(printed.template head<N>()));
  });
}

STATEMENT(claim_7_2_constrained_hamilton,
          "critical points of the constrained action and of the action with multiplier") {
  claim.convention(
      "An extremum is a critical point, and the constraint is regular as in Theorem 7.1.1. Shown off "
      "shell, for any density and any variation: from the multiplier to the constrained sections for every "
      "constraint with two components; the other way where one field is a function of the other and of its "
      "derivatives, on strings, membranes and solids, and where none is, on curves that sweep area at a "
      "given rate; for $J = 1$ see claim_7_2_incompressibility_fits.");
  // Cubics of cubics, differentiated up to three times: terms grow to some tens and cancel in part.
  double const condition = 100;
  over_dimensions(ConstrainedDimensions{}, [&]<int n, int N>(Dimensions<n, N>, std::string const& name) {
    auto const L = draw_density<S, n, N>(draw);
    auto const Phi = draw_constraint<S, n, N>(draw);
    auto const phi = draw_section<S, n, N>(draw), w = draw_section<S, n, N>(draw, S(1));
    auto const lambda = draw_multiplier<S, n, 2>(draw);
    auto const x = draw_event<S, n>(draw);
    // Along w the action changes by what (7.2) leaves and by the pairing of the multiplier with the change of
    // the constraint: where the first vanishes, the action is critical for the w that keep the constraint.
    auto const at_boundary = boundary_part(less_paired(L, Phi, lambda), phi, w);
    Matrix<S, 2, 1> const turned = rates_of_constraint(Phi, phi, w, x);
    S const changed = rate_of_density(L, phi, w, x) - divergence_of(at_boundary, x);
    Matrix<S, N, 1> const left =
        -constrained_field_equations(L, Phi, second_jet(phi, x), first_jet(lambda, x));
    claim.equal("change of the action, and (7.2) with the change of the constraint", name, changed,
                S(left.dot(w(x)) + lambda(x).dot(turned)), condition);
    claim.differs("the multiplier with the other sign", name, changed,
                  S(left.dot(w(x)) - lambda(x).dot(turned)));
  });
  auto const both = [&](std::string const& name, Principles<S> const& p, S const& free) {
    claim.equal("change of the action on constrained sections, and (7.2) with its multiplier", name,
                p.restricted, p.multiplier, condition);
    claim.differs("the equations without constraint", name, p.restricted, free);
  };
  auto const on_graphs = [&]<int n>(std::integral_constant<int, n>) {
    auto const L = draw_density<S, n, 2>(draw);
    auto const graph = draw_field_graph<S, n>(draw);
    CubicField<S, n> const u{draw_cubic<S, n + 1>(draw)}, eta{draw_cubic<S, n + 1>(draw)};
    auto const x = draw_event<S, n>(draw);
    auto const phi = on_graph(graph, u);
    both("w = F(x, u, du), n = " + std::to_string(n), principles_on_graph(L, graph, u, eta, x),
         S(euler_lagrange(L, phi, x)[0] * eta(x)[0]));
  };
  on_graphs(std::integral_constant<int, 1>{});
  on_graphs(std::integral_constant<int, 2>{});
  on_graphs(std::integral_constant<int, 3>{});
  auto const L = draw_density<S, 1, 2>(draw);
  auto const Phi = draw_areal_rate<S, 1>(draw);
  auto const b = draw_cubic<S, 2>(draw);
  auto const x = draw_event<S, 1>(draw);
  std::string const name = "[r, r_s] = rho(t, s)";
  Matrix<S, 2, 1> const E = euler_lagrange(L, Phi.r, x);
  both(name, principles_of_areal_rate(L, Phi, b, x), S(E.dot(Phi.variation(b)(x))));
  // All of (7.2) follows: along r it holds by the choice of the multiplier, which leaves no other.
  auto const rest = [&](S const& factor) {
    auto const lambda = sum_of(Phi.multiplier(L), Phi.multiplier(L), factor);
    return S(Phi.r(x).dot(E - reaction(Phi, second_jet(Phi.r, x), first_jet(lambda, x))));
  };
  claim.zero("(7.2) along r, where no variation reaches", name, rest(S(0)), E.dot(Phi.r(x)), condition);
  claim.refutes("with another multiplier", name, rest(S(1)), E.dot(Phi.r(x)));
}
