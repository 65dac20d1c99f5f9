// Section 7.2: pointwise constraints, the augmented action, the constrained field equations and the extended
// bundle.
#include "fields.hpp"

#include "actio/constraints/augmented.hpp"
#include "actio/constraints/constrained_equations.hpp"
#include "actio/jets/action.hpp"
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

/// The constraint of an incompressible medium, J - 1.
template <class BodyMetric, class SpaceMetric>
struct VolumeConstraint {
  static constexpr int components = 1;
  BodyMetric G;
  SpaceMetric g;
  template <class S, int n>
  Matrix<S, 1, 1> operator()(Jet<S, n, n> const& j) const {
    return Matrix<S, 1, 1>(jacobian(G(j.particle()), g(j.y), j.gradient()) - S(1));
  }
};

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

/// The sum of two fields, the second one times a number or a dual number.
template <class A, class B, class T>
struct Moved {
  A field;
  B added;
  T by;
  template <class V>
  auto operator()(V const& x) const {
    using R = ScalarOf<V>;
    auto const y = field(x);
    auto const w = added(x);
    std::remove_cvref_t<decltype(y)> sum;
    for (int a = 0; a < y.size(); ++a) sum[a] = y[a] + w[a] * R(by);
    return sum;
  }
};
template <class A, class B, class T>
Moved<A, B, T> sum_of(A const& field, B const& added, T const& by) { return {field, added, by}; }
/// The opposite of a field.
template <class S, class A>
Moved<A, A, S> opposite(A const& field) { return {field, field, S(-2)}; }
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

/// The derivative of L - <lambda, Phi> at a point when the section moves along w.
template <class S, int rows, class L, class Phi, class A, class B, class C>
S rate_of_augmented(L const& density, Phi const& constraint, A const& phi, B const& lambda, C const& w,
                    Matrix<S, rows, 1> const& x) {
  Dual<S> step(0);
  step.part[0] = S(1);
  Matrix<Dual<S>, rows, 1> const at = x.template cast<Dual<S>>();
  auto const jet = first_jet(sum_of(phi, w, step), at);
  return S((density(jet) - lambda(at)[0] * constraint(jet)[0]).part[0]);
}
/// The derivative of a constraint at a point when the section moves along w.
template <class S, int rows, class Phi, class A, class C>
S rate_of_constraint(Phi const& constraint, A const& phi, C const& w, Matrix<S, rows, 1> const& x) {
  Dual<S> step(0);
  step.part[0] = S(1);
  Matrix<Dual<S>, rows, 1> const at = x.template cast<Dual<S>>();
  return induced_constraint(constraint, sum_of(phi, w, step))(at)[0].part[0];
}
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

/// A body as large as its space, and one that is smaller.
using TwoDimensions = std::tuple<Dimensions<2, 2>, Dimensions<1, 3>>;

}  // namespace

STATEMENT(eq_7_1, "induced constraint function on sections") {
  claim.holds(
      "The number of components of $\\Phi$ is the rank of $\\mathcal V$, which the thesis calls $n$; it need "
      "not be the dimension of the body.");
  over_dimensions(PlaneAndSpace{}, [&]<class D>(D, std::string const& name) {
    constexpr int n = D::n;
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
      "with $\\Psi$.");
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
}

STATEMENT(eq_7_2, "constrained Euler-Lagrange equations") {
  claim.holds("They are those of $L - \\langle\\lambda, \\Phi\\rangle$.");
  {
    over_dimensions(TwoDimensions{}, [&]<class D>(D, std::string const& name) {
      constexpr int n = D::n, N = D::N;
      auto const L = draw_density<S, n, N>(draw);
      auto const Phi = draw_constraint<S, n, N>(draw);
      auto const phi = draw_section<S, n, N>(draw);
      auto const lambda = draw_multiplier<S, n, 2>(draw);
      auto const x = draw_event<S, n>(draw);
      // L - <lambda, Phi> as a density that knows lambda as a function of x.
      auto const minus = [&]<class T>(Jet<T, n, N> const& j) {
        auto const l = lambda(j.x);
        auto const c = Phi(j);
        return T(L(j) - l[0] * c[0] - l[1] * c[1]);
      };
      auto const printed = constrained_field_equations(L, Phi, second_jet(phi, x), first_jet(lambda, x));
      claim.equal("(7.2), and the field equations of the density", name, printed,
                  (-euler_lagrange(minus, phi, x)).eval());
      auto const other = opposite<S>(lambda);
      claim.differs("with the multiplier's sign changed", name,
                    constrained_field_equations(L, Phi, second_jet(phi, x), first_jet(other, x)), printed);
      auto outside = first_jet(lambda, x);
      outside.v.setZero();
      claim.differs("with the multiplier outside of the derivative", name,
                    constrained_field_equations(L, Phi, second_jet(phi, x), outside), printed);
    });

    // The variation of the augmented action on a box, with fixed boundary.
    constexpr int n = 1, N = 2;
    std::string const name = "n = 1, N = 2, on a box";
    auto const L = draw_quadratic<S, n, N>(draw);
    QuadraticConstraint<S, n, N> const Phi{draw_quadratic<S, n, N>(draw)};
    auto const phi = draw_section<S, n, N>(draw);
    auto const lambda = draw_multiplier<S, n, 1>(draw);
    Bump<S, N> const w{draw.vector<S, Matrix<S, N, 1>>(N)};
    auto const box = unit_box<S, n>();
    int const degree = 13;
    S const variation =
        integral([&](Event<S, n> const& x) { return rate_of_augmented(L, Phi, phi, lambda, w, x); }, box.low,
                 box.high, degree);
    S const paired = integral(
        [&](Event<S, n> const& x) {
      return S(constrained_field_equations(L, Phi, second_jet(phi, x), first_jet(lambda, x)).dot(w(x)));
        },
        box.low, box.high, degree);
    claim.equal("derivative of the augmented action, and the pairing with (7.2)", name, variation, S(-paired),
                100);
  }
}

STATEMENT(claim_7_2_augmented_lagrangian, "Lagrangian on the extended bundle and its field equations") {
  claim.corrected("L_\\Phi = L + \\langle\\lambda, \\Phi\\rangle",
                  "L_\\Phi = L - \\langle\\lambda, \\Phi\\rangle",
                  "The equations of the printed density are (7.2) with $-\\lambda$ for $\\lambda$; chapter 8 "
                  "keeps the printed density, whose multiplier is the pressure, positive in compression.");
  claim.maybe_scan();
  over_dimensions(TwoDimensions{}, [&]<class D>(D, std::string const& name) {
    constexpr int n = D::n, N = D::N;
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

STATEMENT(claim_7_2_incompressibility_fits, "incompressibility as an instance of the multiplier theorem") {
  claim.convention(
      "With a fixed boundary the total volume is fixed: the derivative of $J - 1$ reaches the functions with "
      "zero mean against $\\sqrt{\\det G}$ and no others, at each time. With these as the fibre "
      "the theorem applies, and the multiplier is free up to $c(t)\\sqrt{\\det G}$.");
  {
    constexpr int n = 2;
    std::string const name = "n = N = 2, metrics that vary";
    auto const G = draw_metric<S, n>(draw);
    auto const g = draw_metric<S, n>(draw);
    auto const root = [](auto const& metric) {
      return [metric]<class V>(V const& at) { return volume<ScalarOf<V>>(metric(at)); };
    };

    // 1. Any motion and any displacement that vanishes on the sides of the unit square: the volume it makes
    //    adds up to nothing.
    VolumeConstraint<AnyMetric<S, n>, AnyMetric<S, n>> const Phi{G, g};
    auto const made = [&](auto const& phi, auto const& w) {
      return [&](Matrix<S, n, 1> const& body) {
        Event<S, n> const at(ratio<S>(1, 3), body[0], body[1]);
        return S(root(G)(body) * rate_of_constraint(Phi, phi, w, at));
      };
    };
    auto const phi = [c = draw_cubic<S, 3>(draw, ratio<S>(1, 5)).a,
                      d = draw_cubic<S, 3>(draw, ratio<S>(1, 5)).a]<class V>(V const& x) {
      using T = ScalarOf<V>;
      return Matrix<T, 2, 1>(x[1] + x[1] * x[2] * T(c[0]) + x[0] * T(c[1]),
                             x[2] + x[1] * x[1] * T(d[0]) + x[0] * x[2] * T(d[1]));
    };
    auto const sides = [s = draw.vector<S, Matrix<S, 2, 1>>(2)]<class V>(V const& x) {
      using T = ScalarOf<V>;
      T const b = x[1] * (T(1) - x[1]) * x[2] * (T(1) - x[2]);
      return Matrix<T, 2, 1>(b * T(s[0]), b * x[1] * T(s[1]));
    };
    auto const loose = [&]<class V>(V const& x) { return Matrix<ScalarOf<V>, 2, 1>(x[1], x[2]); };
    Matrix<S, n, 1> const low = Matrix<S, n, 1>::Zero(), high = Matrix<S, n, 1>::Ones();
    // sqrt(det g) is of degree 4 in values of degree 2, its derivative is no higher, F adds 2 and the
    // displacement 5.
    int const degree = 14;
    // Where numbers have an order: elsewhere a root has a sign at each point, and its integral is none.
    if (ordered_arithmetic<S>())
      claim.zero("total volume made with a fixed boundary", name,
                 integral(made(phi, sides), low, high, degree), S(1), 10);
    if (ordered_arithmetic<S>())
      claim.refutes("with a boundary that moves, so that a constant is reached as well", name,
                    integral(made(phi, loose), low, high, degree), S(1));

    // 2. Every function with zero mean is reached. In a body that is at rest in its own space sqrt(det G) div
    //    w = p has this solution, tangent to the sides.
    auto const c = draw.vector<S, Matrix<S, 3, 1>>(3);
    // p = c0 (x - 1/2) + c1 (x y - 1/4) + c2 (y^2 - 1/3), and the part of it that does not depend on y goes
    // sideways.
    auto const p = [&]<class V>(V const& b) {
      return S((b[0] - ratio<S>(1, 2)) * c[0] + (b[0] * b[1] - ratio<S>(1, 4)) * c[1] +
               (b[1] * b[1] - ratio<S>(1, 3)) * c[2]);
    };
    auto const solution = [&]<class V>(V const& x) {
      using T = ScalarOf<V>;
      Matrix<T, 2, 1> const b(x[1], x[2]);
      T const sideways = (b[0] * b[0] - b[0]) * T(S(c[0] / S(2) + c[1] / S(4)));
      T const upwards =
          b[0] * (b[1] * b[1] - b[1]) * T(S(c[1] / S(2))) + (b[1] * b[1] * b[1] - b[1]) * T(S(c[2] / S(3)));
      T const density = root(g)(b);
      return Matrix<T, 2, 1>(sideways / density, upwards / density);
    };
    auto const rest = []<class V>(V const& x) { return Matrix<ScalarOf<V>, 2, 1>(x[1], x[2]); };
    VolumeConstraint<AnyMetric<S, n>, AnyMetric<S, n>> const at_rest{g, g};
    Event<S, n> const x = draw_event<S, n>(draw);
    Matrix<S, n, 1> const body = x.template tail<n>();
    claim.zero("a body at rest in its own space keeps its volume", name, induced_constraint(at_rest, rest)(x),
               S(1), 10);
    // Near a zero of p its terms are still of size one tenth.
    claim.zero("a displacement that makes a given volume with zero mean", name,
               S(root(g)(body) * rate_of_constraint(at_rest, rest, solution, x) - p(body)), S(1), 10);

    // 3. The multiplier is free up to c(t) sqrt(det G), and up to nothing else.
    auto const j = second_jet(draw_section<S, n, n>(draw), x);
    auto const against = [&](auto const& factor) {
      auto const field = [&]<class V>(V const& at) {
        using T = ScalarOf<V>;
        return Matrix<T, 1, 1>(root(G)(Matrix<T, 2, 1>(at[1], at[2])) * factor(at));
      };
      return reaction(Phi, j, first_jet(field, x));
    };
    claim.zero("reaction of a pressure that depends on time alone", name,
               against([](auto const& at) { return at[0] * at[0] + at[0] + 1; }), S(1), 30);
    claim.refutes("reaction of a pressure that depends on the point of the body", name,
                  against([](auto const& at) { return at[1] * at[1] + at[0] + 1; }), S(1));
  }
}
