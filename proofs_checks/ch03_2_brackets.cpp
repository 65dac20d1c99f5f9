// Section 3.2, second part: Poisson structures on pairs and on the group.

#include "actio/reduction/discrete_forms.hpp"
#include "actio/reduction/discrete_lie_poisson.hpp"
#include "actio/reduction/discrete_poisson.hpp"
#include "actio/variational/lie_poisson.hpp"

#include "models/enclosures.hpp"
#include "models/sequences.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

/// The differential of a function of pairs, (theta0, theta1).
template <class F, class S>
Vector<S> differential(F const& f, GroupElement<S> const& g0, GroupElement<S> const& g1) {
  return stacked<S>({D1(f, g0, g1), D2(f, g0, g1)});
}
/// {a, b} of two functions of pairs, as a function of pairs.
template <class L, class A, class B>
auto bracket_of_pairs(L const& lagrangian, A const& a, B const& b) {
  return [=](auto const& g0, auto const& g1) {
    return differential(a, g0, g1).dot(discrete_bivector(lagrangian, g0, g1) * differential(b, g0, g1));
  };
}
/// {a, b} of two functions on the group, as a function on the group.
template <class L, class A, class B>
auto reduced_bracket(L const& l, A const& a, B const& b) {
  return [=](auto const& f) {
    return right_differential(a, f).components.dot(reduced_bivector_right(l, f) *
                                                   right_differential(b, f).components);
  };
}
/// A function on the group as a function of pairs, by the projection on the first configuration.
template <class F>
struct OnFirst {
  F f;
  template <class T>
  T operator()(GroupElement<T> const& g0, GroupElement<T> const&) const { return f(g0); }
};
/// SO(3) and Aff(1): for third derivatives.
std::vector<SpannedGroup> const& small_groups() {
  static std::vector<SpannedGroup> const groups = {few_groups()[0], few_groups()[2]};
  return groups;
}

}  // namespace

STATEMENT(eq_3_12, "the bracket on pairs") {
  claim.holds("With the momentum $-D_1\\mathbb L$ it is the canonical bracket of $T^*G$, $\\{q, p\\} = +1$.");
  over_groups(few_groups(), claim, [&](auto const& group, auto const& model) {
    int const d = group.dimension();
    auto const lagrangian = draw_pair_polynomial<S>(draw, group);
    auto const a = draw_pair_polynomial<S>(draw, group), b = draw_pair_polynomial<S>(draw, group);
    auto const g0 = draw.template element<S>(group), g1 = draw.template element<S>(group);

    // d theta^- on right-invariant fields, X theta(Y) - Y theta(X) - theta[X, Y], whose commutator is minus
    // the one of the algebra.
    auto const theta = D1(lagrangian, g0, g1);
    Matrix<S> omega = Matrix<S>::Zero(2 * d, 2 * d), configuration(d, d);
    for (int i = 0; i < d; ++i) {
      auto const e = basis_velocity<S>(group, i);
      configuration.col(i) = rate(D1(lagrangian, varied(g0, from_left(e, g0)), over<Dual<S>>(g1)));
      omega.col(d + i).head(d) = -rate(D1(lagrangian, over<Dual<S>>(g0), varied(g1, from_left(e, g1))));
    }
    for (int i = 0; i < d; ++i)
      for (int j = 0; j < d; ++j) {
        omega(i, j) = configuration(j, i) - configuration(i, j) +
                      pair(theta, bracket(basis_velocity<S>(group, i), basis_velocity<S>(group, j)));
        omega(d + j, i) = -omega(i, d + j);
      }
    // Solve X_F from omega(X_F, .) = dF, and pair.
    auto const field = [&](auto const& f) {
      return Vector<S>(solve_linear(omega.transpose().eval(), differential(f, g0, g1)));
    };
    S const value = field(a).dot(omega * field(b));
    Matrix<S> const pi = discrete_bivector(lagrangian, g0, g1);
    auto const scale =
        magnitude(differential(a, g0, g1)) * magnitude(pi) * magnitude(differential(b, g0, g1));
    claim.zero("omega(X_F, X_H) by the definitions", model,
               S(bracket_of_pairs(lagrangian, a, b)(g0, g1) - value), scale);
    claim.zero("dF(X_H) is the same", model, S(differential(a, g0, g1).dot(field(b)) - value), scale);
    // Controls: the other order, the other sign of X_H on one side.
    Matrix<S> const explicit_pi = inverse_matrix(Matrix<S>(omega.transpose()));
    claim.differs("omega(X_H, X_F)", model, Matrix<S>(pi.transpose()), explicit_pi);

    // It is the canonical bracket: the momenta mu = -D1 L have the plus bracket, and {F(g0), mu_a} = dF e_a.
    Matrix<S> momenta(2 * d, d);
    momenta.topRows(d) = -configuration.transpose();
    for (int i = 0; i < d; ++i) momenta.row(d + i) = omega.col(d + i).head(d).transpose();
    auto const size = magnitude(momenta) * magnitude(pi) * magnitude(momenta);
    claim.zero("brackets of momenta", model,
               Matrix<S>(momenta.transpose() * pi * momenta - lie_poisson_tensor_plus(-theta)), size);
    Matrix<S> const positions = (pi * momenta).topRows(d);
    claim.zero("brackets of configurations and momenta", model,
               Matrix<S>(positions - Matrix<S>::Identity(d, d)), magnitude(pi) * magnitude(momenta));
  });
  over_groups(small_groups(), claim, [&](auto const& group, auto const& model) {
    // Jacobi's identity: three functions, third derivatives of L.
    auto const lagrangian = draw_pair_polynomial<S>(draw, group);
    auto const a = draw_pair_polynomial<S>(draw, group), b = draw_pair_polynomial<S>(draw, group),
               c = draw_pair_polynomial<S>(draw, group);
    auto const g0 = draw.template element<S>(group), g1 = draw.template element<S>(group);
    auto const form = [&](auto const& f, auto const& h) { return bracket_of_pairs(lagrangian, f, h); };
    S const first = form(a, form(b, c))(g0, g1), second = form(b, form(c, a))(g0, g1),
            third = form(c, form(a, b))(g0, g1);
    auto const sizes = magnitude(first) + magnitude(second) + magnitude(third);
    // Condition: omega is inverted twice, and differentiated.
    claim.zero("Jacobi's identity", model, S(first + second + third), sizes, 100);
    // Control: the bracket times a function phi, the inverse of a form that is not closed. By Leibniz' rule
    // the cyclic sum is phi ({a, phi}{b, c} + ...).
    auto const bent = several([&] {
      auto const phi = draw_pair_polynomial<S>(draw, group);
      auto const at = [&](auto const& f, auto const& h) { return form(f, h)(g0, g1); };
      return S((at(a, phi) * at(b, c) + at(b, phi) * at(c, a) + at(c, phi) * at(a, b)) * phi(g0, g1));
    });
    claim.refutes("a form that is not closed", model, bent, sizes, 1e-4);
    // Control: no bracket where L is not regular.
    claim.template refuses<Singular>("a Lagrangian that is not regular", model, [&] {
      discrete_bivector([&](auto const& x, auto const& y) { return a(x, x) + b(y, y); }, g0, g1);
    });
  });
}

STATEMENT(eq_3_13, "the bracket on the group") {
  claim.corrected(R"(\{f,h\}_G\circ\pi_d = \{f\circ\pi,\,h\circ\pi\}_{G\times G})",
                  R"(\{f,h\}_G\circ\pi_d = \{f\circ\pi_d,\,h\circ\pi_d\}_{G\times G})",
                  "The functions are lifted by the quotient map itself; lifted by the projection on a "
                  "configuration they would commute.");
  claim.maybe_scan();
  over_groups(few_groups(), claim, [&](auto const& group, auto const& model) {
    auto const l = draw_reduced_lagrangian<S>(draw, group);
    auto const a = draw_reduced_lagrangian<S>(draw, group), b = draw_reduced_lagrangian<S>(draw, group);
    auto const g = draw_configurations<S>(draw, group, 3);
    auto const f = relative_motion_right(g[0], g[1]);
    S const below = reduced_bracket(l, a, b)(f);
    Matrix<S> const tensor = reduced_bivector_right(l, f);
    auto const scale = magnitude(column(right_differential(a, f))) * magnitude(tensor) *
                       magnitude(column(right_differential(b, f)));
    // Well defined: the same at every pair over f. Condition: the configurations magnify, and a matrix is
    // inverted at each of them.
    for (auto const& carry : {g[2], inverse(g[2])})
      claim.zero("lifted by the quotient map", model,
                 S(bracket_of_pairs(lifted(l), lifted(a), lifted(b))(g[0] * carry, g[1] * carry) - below),
                 scale, 10);
    // What it is: the momentum mu = -R* l' carries it to the plus Lie-Poisson bracket.
    Matrix<S> const second = right_second_differential(l, f);
    claim.zero("the momentum is a Poisson map to the plus bracket", model,
               Matrix<S>(second * tensor * second.transpose() -
                         lie_poisson_tensor_plus(momentum_before_right(l, f))),
               magnitude(second) * magnitude(tensor) * magnitude(second));
    claim.refutes("to the minus bracket", model,
                  Matrix<S>(second * tensor * second.transpose() +
                            lie_poisson_tensor_plus(momentum_before_right(l, f))),
                  magnitude(second) * magnitude(tensor) * magnitude(second));
    // Left-invariant: the body momentum, the minus bracket.
    Matrix<S> const other = reduced_bivector_left(l, f), slope_of = left_second_differential(l, f);
    claim.zero("left-invariant: to the minus bracket", model,
               Matrix<S>(slope_of * other * slope_of.transpose() +
                         lie_poisson_tensor_plus(momentum_before_left(l, f))),
               magnitude(slope_of) * magnitude(other) * magnitude(slope_of));

    // Control, as printed with the projection on the first configuration: such functions commute.
    auto const gap = several([&] {
      auto const other_b = draw_reduced_lagrangian<S>(draw, group);
      return S(bracket_of_pairs(lifted(l), OnFirst{a}, OnFirst{other_b})(g[0], g[1]) -
               reduced_bracket(l, a, other_b)(f));
    });
    claim.refutes("lifted by the projection on a configuration", model, gap, scale);
    // Control: no invariance, no bracket below.
    auto const any = draw_pair_polynomial<S>(draw, group);
    auto const two = [&](auto const& x, auto const& y) {
      return several([&] {
        return bracket_of_pairs(any, lifted(a), lifted(draw_reduced_lagrangian<S>(draw, group)))(x, y);
      });
    };
    Draw const again = draw;
    auto const here = two(g[0], g[1]);
    draw = again;
    claim.differs("no invariance", model, two(g[0] * g[2], g[1] * g[2]), here);
  });
}

STATEMENT(thm_3_2_2, "the discrete Euler-Poincare algorithm is a Poisson map") {
  claim.corrected(
      R"(\{f,h\}_G\circ\pi_d = \{f\circ\pi,\,h\circ\pi\}_{G\times G})",
      R"(\{f,h\}_G\circ\pi_d = \{f\circ\pi_d,\,h\circ\pi_d\}_{G\times G})",
      "The algorithm preserves the bracket that the quotient map $\\pi_d$ induces; by (3.13) as printed, "
      "with the projection on a configuration, all functions would commute. $\\mathbb L$ is "
      "right-invariant and, for the bracket, regular; the hypothesis on the action is always true.");
  claim.maybe_scan();
  claim.same_slip_as("eq_3_13");
  over_groups(few_groups(), claim, [&](auto const& group, auto const& model) {
    auto const f = draw_configurations<S>(draw, group, 2);
    auto const any = draw_reduced_lagrangian<S>(draw, group);
    auto const l = with_motions_right(any, f);
    claim.zero("the motion", model, euler_poincare_right(l, f[0], f[1]), momenta_of(l, f));
    auto const defect = [&](auto const& k, auto const& form) {
      Matrix<S> const t = euler_poincare_tangent_right(k, f[0], f[1]);
      return Matrix<S>(t * reduced_bivector_right(form, f[0]) * t.transpose() -
                       reduced_bivector_right(form, f[1]));
    };
    auto const size = [&](auto const& k, auto const& form) {
      Matrix<S> const t = euler_poincare_tangent_right(k, f[0], f[1]);
      return magnitude(t) * magnitude(reduced_bivector_right(form, f[0])) * magnitude(t) +
             magnitude(reduced_bivector_right(form, f[1]));
    };
    // Condition: second derivatives are inverted on both sides.
    claim.zero("Poisson defect of one step", model, defect(l, l), size(l, l), 100);
    // Controls: two relative motions that (3.10) does not join; the bracket of another Lagrangian.
    claim.refutes("off a motion", model, defect(any, any), size(any, any));
    claim.refutes("the bracket of another Lagrangian", model, defect(l, any), size(l, any));

    // The bracket is the induced one at both ends of the step of the full algorithm; by the printed lift it
    // is another.
    auto const g = configurations_right(draw.template element<S>(group), f);
    auto const a = draw_reduced_lagrangian<S>(draw, group), b = draw_reduced_lagrangian<S>(draw, group);
    Vector<S> induced(2), printed(2), below(2);
    S sizes(0);
    for (int k = 0; k < 2; ++k) {
      induced[k] = bracket_of_pairs(lifted(l), lifted(a), lifted(b))(g[k], g[k + 1]);
      printed[k] = bracket_of_pairs(lifted(l), OnFirst{a}, OnFirst{b})(g[k], g[k + 1]);
      below[k] = reduced_bracket(l, a, b)(f[k]);
      sizes += S(magnitude(column(right_differential(a, f[k]))) * magnitude(reduced_bivector_right(l, f[k])) *
                 magnitude(column(right_differential(b, f[k]))));
    }
    claim.zero("{f, h}_G is the bracket of f and h lifted by the quotient map", model,
               Vector<S>(induced - below), sizes, 10);
    claim.refutes("lifted by the projection on a configuration, as printed", model,
                  Vector<S>(printed - below), sizes);

    // The step goes down to the quotient: what translates a pair does not move the relative motion after it.
    auto const after = [&](auto const& lagrangian) {
      auto const zeta = draw.template velocity<S>(group);
      auto const moved = discrete_flow_tangent(lagrangian, g[0], g[1], g[2],
                                               PairChange<SpannedGroup, S>{Ad(g[0], zeta), Ad(g[1], zeta)});
      return column(relative_variation_right(f[1], moved.first, moved.second));
    };
    // Condition: the tangent solves with a matrix of second derivatives.
    claim.zero("the step takes translated pairs to translated pairs", model, after(lifted(l)), S(1), 100);
    auto const not_invariant = with_motion(draw_pair_polynomial<S>(draw, group), g[0], g[1], g[2]);
    claim.refutes("no invariance: translated pairs", model, after(not_invariant), S(1));
  });
}

STATEMENT(claim_3_2_dep_preserves_bracket, "brackets of functions before and after a step") {
  claim.holds("Jacobi's identity comes down from the bracket on pairs.");
  over_groups(few_groups(), claim, [&](auto const& group, auto const& model) {
    int const d = group.dimension();
    auto const f = draw_configurations<S>(draw, group, 2);
    auto const l = with_motions_right(draw_reduced_lagrangian<S>(draw, group), f);
    auto const a = draw_reduced_lagrangian<S>(draw, group), b = draw_reduced_lagrangian<S>(draw, group);

    // The tangent of a step, from the full algorithm: move g0 alone, and project what g2 does.
    auto const g = configurations_right(identity<S>(group), f);
    Matrix<S> tangent(d, d);
    for (int i = 0; i < d; ++i) {
      PairChange<SpannedGroup, S> const w{basis_velocity<S>(group, i),
                                          velocity(group, Vector<S>(Vector<S>::Zero(d)))};
      auto const moved = discrete_flow_tangent(lifted(l), g[0], g[1], g[2], w);
      tangent.col(i) = column(relative_variation_right(f[1], moved.first, moved.second));
    }
    Matrix<S> const reduced = euler_poincare_tangent_right(l, f[0], f[1]);
    // Condition: each tangent has inverted a matrix of second derivatives.
    claim.equal("tangent of the step, from (3.10) and from (3.2)", model, reduced, tangent, 100);

    // {a o Phi, b o Phi} before, {a, b} after.
    Matrix<S> const before = reduced_bivector_right(l, f[0]);
    auto const pulled = [&](auto const& h) {
      return Vector<S>(tangent.transpose() * column(right_differential(h, f[1])));
    };
    auto const scale = magnitude(pulled(a)) * magnitude(before) * magnitude(pulled(b)) * S(Base<S>(d * d));
    claim.zero("{a o Phi, b o Phi} = {a, b} o Phi", model,
               S(pulled(a).dot(before * pulled(b)) - reduced_bracket(l, a, b)(f[1])), scale, 100);
    // Control: brackets taken at the wrong end of the step.
    auto const wrong_end = several([&] {
      auto const c = draw_reduced_lagrangian<S>(draw, group), e = draw_reduced_lagrangian<S>(draw, group);
      return S(pulled(c).dot(before * pulled(e)) - reduced_bracket(l, c, e)(f[0]));
    });
    claim.refutes("{a, b} without the step", model, wrong_end, scale, 1e-4);

    // Left-invariant systems.
    auto const k = with_motions_left(draw_reduced_lagrangian<S>(draw, group), f);
    Matrix<S> const t = euler_poincare_tangent_left(k, f[0], f[1]), p0 = reduced_bivector_left(k, f[0]),
                    p1 = reduced_bivector_left(k, f[1]);
    claim.zero("left-invariant: Poisson defect of one step", model, Matrix<S>(t * p0 * t.transpose() - p1),
               magnitude(t) * magnitude(p0) * magnitude(t) + magnitude(p1), 100);
  });
}

namespace {

/// A lower bound of the largest modulus of some balls.
Number largest_at_least(Matrix<Number> const& values) {
  Number bound(0);
  for (Index i = 0; i < values.size(); ++i)
    for (Number const& one : {values(i).lower(), Number(-values(i).upper())})
      if (bound < one) bound = one;
  return bound;
}
/// Whether an image is larger than a quarter of the element, for every point and every element of some boxes
/// with an entry 1: so that points and images in bounded sets leave a bounded set of elements.
/// @param act  (point, element) -> image, matrices each
template <class Act>
Enclosure bounded_by_images(Act const& act, Matrix<Number> const& points, Matrix<Number> const& elements) {
  Index const n = points.size();
  Vector<Number> box(n + elements.size());
  for (Index i = 0; i < n; ++i) box[i] = points(i);
  for (Index i = 0; i < elements.size(); ++i) box[n + i] = elements(i);
  return positive_on(
      [&](Vector<Number> const& x) {
        Matrix<Number> point = points, element = elements;
        for (Index i = 0; i < n; ++i) point(i) = x[i];
        for (Index i = 0; i < element.size(); ++i) element(i) = x[n + i];
        Number const room = largest_at_least(act(point, element)) - ratio<Number>(1, 4);
        if (!(room > Number(0))) throw Undecided("the size of an image");
        return room;
      },
      box, 64);
}
/// All matrices whose largest entry is a 1 at (i, j).
Matrix<Number> face(int n, int i, int j) {
  Matrix<Number> m = Matrix<Number>::Constant(n, n, Number::between(Number(-1), Number(1)));
  m(i, j) = Number(1);
  return m;
}
/// Every matrix whose entries are within 1/(4n) of those of `middle`.
Matrix<Number> around(Matrix<Number> const& middle) {
  Number const radius = ratio<Number>(1, 4 * static_cast<int>(middle.rows()));
  return middle.unaryExpr([&](Number const& x) { return Number(x + Number::between(-radius, radius)); });
}

}  // namespace

STATEMENT(claim_3_2_proper_action, "the diagonal action is proper") {
  claim.holds(
      "Always true of right multiplication on pairs: the hypothesis asks for nothing. In balls, for every "
      "configuration near the identity, to which left translation carries any other: $|h|\\le 4|gh|$ and "
      "$|h^{-1}|\\le 4|(gh)^{-1}|$. The action is free, too.");
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const g = draw_configurations<S>(draw, group, 2);
    auto const h = draw.template element<S>(group), axis = draw.template element<S>(group);
    // Free: h is a continuous function of a pair and its image, found by elimination.
    auto const found = [&](auto const& before, auto const& after) {
      return GroupElement<S>{group, solve_linear(before.value, after.value, "g h = g'")};
    };
    claim.equal("h from one configuration and its image", model, found(g[0], g[0] * h), h);
    claim.equal("h from the other configuration and its image", model, found(g[1], g[1] * h), h);
    // Control: conjugation of both configurations. Elements that commute with them do nothing, so the pair
    // and its image do not tell h.
    auto const conjugated = [&](auto const& x, auto const& by) { return by * x * inverse(by); };
    auto const square = axis * axis;
    claim.equal("conjugation: an element fixes its powers", model, conjugated(square, axis), square);
    claim.differs("conjugation: h from a configuration and its image", model,
                  found(square, conjugated(square, axis)), axis);

    // Proper. Products are linear in h, so its size does not matter: each of its entries may be the largest.
    int const n = group.matrix_size();
    auto const on_the_right = [&](Matrix<Number> const& p, Matrix<Number> const& e) {
      return (GroupElement<Number>{group, p} * GroupElement<Number>{group, e}).value;
    };
    auto const on_the_left = [&](Matrix<Number> const& p, Matrix<Number> const& e) {
      return (GroupElement<Number>{group, e} * GroupElement<Number>{group, p}).value;
    };
    auto const everywhere = [&](auto const& act) {
      Enclosure all{.shown = true, .margin = HUGE_VAL};
      for (int k = 0; k < n * n && all.shown; ++k) {
        auto const one = bounded_by_images(act, around(identity<Number>(group).value), face(n, k % n, k / n));
        all = {one.shown, std::min(all.margin, one.margin), all.boxes + one.boxes};
      }
      return all;
    };
    claim.encloses("|h| < 4 |g h|", model, [&] { return everywhere(on_the_right); });
    claim.encloses("|k| < 4 |k g|, of inverses", model, [&] { return everywhere(on_the_left); });
  });
  // The same of two actions of numbers on the plane off the origin, at points around (1, 0): all coordinates
  // multiplied by h; one multiplied and one divided by h = 1/s, over the size s of the element. That one is
  // free and not proper: (1, 1/s) goes to (1/s, 1).
  auto const on_the_plane = [](Matrix<Number> const& p, Matrix<Number> const& e) {
    return Matrix<Number>(p.cwiseProduct(e));
  };
  auto const of_elements = [&](Number const& first) {
    Matrix<Number> point(2, 1), element(2, 1);
    point << Number(1), Number(0);
    element << first, Number(1);
    return bounded_by_images(on_the_plane, around(point), element);
  };
  claim.encloses("(x, y) to (h x, h y): |h| < 4 |h p|", "R^x on the plane", [&] { return of_elements(1); });
  for (long s : {16L, 256L, 4096L})
    claim.refutes_enclosure("(x, y) to (h x, y/h): |h| < 4 |h p|", "R^x on the plane",
                            [&] { return of_elements(ratio<Number>(1, s * s)); });
}
