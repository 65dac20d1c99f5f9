// Section 4.1, first part: groupoids, their algebroids and the Poisson structures on the duals of these.

#include "actio/groupoid/algebroid.hpp"
#include "actio/groupoid/lagrange_equations.hpp"
#include "actio/groupoid/poisson_on_group.hpp"
#include "actio/reduction/discrete_euler_lagrange.hpp"
#include "actio/reduction/discrete_euler_poincare.hpp"
#include "actio/variational/lie_poisson.hpp"

#include "models/groupoids.hpp"
#include "models/sequences.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

/// The matrix of the commutator with the a-th basis vector, column b: [e_a, e_b], written out with matrices.
template <class S>
Matrix<S> commutators_with(SpannedGroup const& group, int a) {
  int const d = group.dimension();
  Matrix<S> c(d, d);
  Matrix<S> const x = group.hat(Vector<S>(Vector<S>::Unit(d, a)));
  for (int b = 0; b < d; ++b) {
    Matrix<S> const y = group.hat(Vector<S>(Vector<S>::Unit(d, b)));
    c.col(b) = group.vee(Matrix<S>(x * y - y * x));
  }
  return c;
}
/// What bracket and anchor are known to be: those of right-invariant vector fields on G, where the bracket is
/// minus the commutator; of the algebra; of the algebra with its action on vectors; of both. Of
/// copies it is the bracket of the algebra for each of them.
template <class S>
Matrix<S> known_bracket(Pairs const& gamma, int a) { return -commutators_with<S>(gamma.group, a); }
template <class S>
Matrix<S> known_bracket(Alone const& gamma, int a) { return commutators_with<S>(gamma.group, a); }
template <class S>
Matrix<S> known_bracket(Opposite<Alone> const& gamma, int a) {
  return -commutators_with<S>(gamma.of.group, a);
}
template <class S>
Matrix<S> known_bracket(Carrying const& gamma, int a) { return commutators_with<S>(gamma.group, a); }
template <class S>
Matrix<S> known_bracket(Gauge const& gamma, int a) {
  Matrix<S> c = Matrix<S>::Zero(gamma.dimension(), gamma.dimension());
  int const k = gamma.group.dimension();
  if (a >= gamma.base) c.bottomRightCorner(k, k) = commutators_with<S>(gamma.group, a - gamma.base);
  return c;
}
template <class S>
Matrix<S> known_bracket(TwoCopies const& gamma, int a) {
  int const d = gamma.group.dimension(), first = a < d ? 0 : d;
  Matrix<S> c = Matrix<S>::Zero(2 * d, 2 * d);
  c.block(first, first, d, d) = commutators_with<S>(gamma.group, a - first);
  return c;
}
template <class S, class A>
Matrix<S> known_anchor(Pairs const& gamma, A const&) {
  return Matrix<S>::Identity(gamma.dimension(), gamma.dimension());
}
template <class S, class Gamma, class A>
  requires std::same_as<Point<Gamma, S>, SinglePoint<S>>
Matrix<S> known_anchor(Gamma const& gamma, A const&) { return Matrix<S>(0, gamma.dimension()); }
template <class S, class A>
Matrix<S> known_anchor(Carrying const& gamma, A const& g) {
  Matrix<S> rho(gamma.base_dimension(), gamma.dimension());
  for (int a = 0; a < gamma.dimension(); ++a)
    rho.col(a) = -(gamma.group.hat(Vector<S>(Vector<S>::Unit(gamma.dimension(), a))) * gamma.target(g).value);
  return rho;
}
template <class S, class A>
Matrix<S> known_anchor(Gauge const& gamma, A const&) {
  return Matrix<S>::Identity(gamma.base, gamma.dimension());
}
/// The second copy as seen from the first, \f$x = g_1^{-1}g_2\f$, moves by \f$-v_1 + xv_2x^{-1}\f$.
template <class S, class A>
Matrix<S> known_anchor(TwoCopies const& gamma, A const& g) {
  int const d = gamma.group.dimension();
  Matrix<S> const x = g.to[0].value, back = inverse_matrix(x);
  Matrix<S> rho(d, 2 * d);
  for (int a = 0; a < d; ++a) {
    rho.col(a) = -Vector<S>(Vector<S>::Unit(d, a));
    Matrix<S> const e = gamma.group.hat(Vector<S>(Vector<S>::Unit(d, a)));
    rho.col(d + a) = gamma.group.vee(Matrix<S>(x * (e * back)));
  }
  return rho;
}

}  // namespace

STATEMENT(claim_4_1_groupoids,
          "pairs and groups are groupoids, with $TG$ and the algebra as their algebroids") {
  claim.holds(
      "The bracket of the algebroid of pairs is that of vector fields on $G$, which on right-invariant "
      "fields is minus the commutator.");
  over_groupoids(claim, [&](auto const& gamma, auto const& model) {
    auto const g = draw_arrows<S>(draw, gamma, 3);
    auto const same = [&](auto const& what, auto const& a, auto const& b) {
      claim.equal(what, model, gamma.entries(a), gamma.entries(b));
    };
    auto const gh = gamma.compose(g[0], g[1]), hk = gamma.compose(g[1], g[2]);
    same("(gh)k = g(hk)", gamma.compose(gh, g[2]), gamma.compose(g[0], hk));
    same("the source of gh is that of g", gamma.unit(gamma.source(gh)), gamma.unit(gamma.source(g[0])));
    same("the target of gh is that of h", gamma.unit(gamma.target(gh)), gamma.unit(gamma.target(g[1])));
    same("units do nothing, left", gamma.compose(gamma.unit(gamma.source(g[0])), g[0]), g[0]);
    same("units do nothing, right", gamma.compose(g[0], gamma.unit(gamma.target(g[0]))), g[0]);
    same("g and its inverse", gamma.compose(g[0], gamma.inverse(g[0])), gamma.unit(gamma.source(g[0])));
    same("the inverse of g and g", gamma.compose(gamma.inverse(g[0]), g[0]), gamma.unit(gamma.target(g[0])));
    // Control: the other order.
    claim.differs("hg for gh", model, gamma.entries(gh), gamma.entries(gamma.compose(g[1], g[0])));

    auto const bracket = algebroid_bracket(gamma, g[0]);
    Matrix<S> all(gamma.dimension(), gamma.dimension() * gamma.dimension()), known = all;
    for (int a = 0; a < gamma.dimension(); ++a) {
      all.middleCols(a * gamma.dimension(), gamma.dimension()) = bracket[a];
      known.middleCols(a * gamma.dimension(), gamma.dimension()) = known_bracket<S>(gamma, a);
    }
    // Condition: Gram's matrix of the entries is inverted, once for each pair of directions; the entries of a
    // configuration are of order 1, and its condition is below 30.
    S const scale = magnitude(known) + S(1);
    claim.zero("bracket of the algebroid", model, Matrix<S>(all - known), scale, 30);
    if (magnitude(known) > Base<S>(0))
      claim.refutes("the bracket with the other sign", model, Matrix<S>(all + known), scale);
    if (gamma.base_dimension() > 0)
      claim.equal("anchor", model, Matrix<S>(anchor(gamma, g[0])), known_anchor<S>(gamma, g[0]), 10);
  });
}

STATEMENT(claim_4_1_dual_poisson,
          "the duals of the algebroids are Poisson manifolds: $T^*G$ with the canonical bracket, the dual "
          "of the algebra with the Lie-Poisson bracket") {
  claim.convention(
      "Weinstein's bracket, in which momenta $p(X)$, $p(Y)$ of vector fields have the bracket $p([X, "
      "Y])$, is on $T^*G$ minus the canonical one with $\\{q, p\\} = 1$, and on the dual of the "
      "algebra the plus Lie-Poisson bracket.");
  over_groupoids(claim, [&](auto const& gamma, auto const& model) {
    auto const g = draw_arrows<S>(draw, gamma, 1)[0];
    int const m = gamma.base_dimension(), n = gamma.dimension();
    Vector<S> const p = draw_vector<S>(draw, n);
    Matrix<S> const pi = dual_bivector(gamma, g, p);
    S const scale = magnitude(pi) + S(1);
    // By the definition, with bracket and anchor written out. Condition: as in claim_4_1_groupoids.
    Matrix<S> known = Matrix<S>::Zero(m + n, m + n);
    if (m > 0)
      known.topRightCorner(m, n) = -known_anchor<S>(gamma, g),
                              known.bottomLeftCorner(n, m) = -known.topRightCorner(m, n).transpose();
    for (int a = 0; a < n; ++a) known.block(m + a, m, 1, n) = p.transpose() * known_bracket<S>(gamma, a);
    claim.zero("the bracket on the dual of the algebroid", model, Matrix<S>(pi - known), scale, 30);
    claim.refutes("with the other sign", model, Matrix<S>(pi + known), scale);
  });
  over_groups(few_groups(), claim, [&](auto const& group, auto const& model) {
    int const d = group.dimension();
    auto const mu = draw.template momentum<S>(group);
    auto const x = draw.template element<S>(group);
    // T*G: {F, H} = <dF, H_mu> - <dH, F_mu> + <mu, [F_mu, H_mu]> is the canonical bracket, momenta translated
    // to the identity on the right (claim_2_2_lie_poisson_equivalence).
    Matrix<S> canonical = Matrix<S>::Zero(2 * d, 2 * d);
    canonical.topRightCorner(d, d).setIdentity();
    canonical.bottomLeftCorner(d, d) = -Matrix<S>::Identity(d, d);
    canonical.bottomRightCorner(d, d) = lie_poisson_tensor_plus(mu);
    Matrix<S> const pairs = dual_bivector(Pairs{group}, Arrow<Pairs, S>{x, x}, Vector<S>(mu.components));
    claim.zero("T*G: minus the canonical bracket", model, Matrix<S>(pairs + canonical),
               S(magnitude(canonical)), 30);
    claim.refutes("T*G: the canonical bracket itself", model, Matrix<S>(pairs - canonical),
                  S(magnitude(canonical)));
    Matrix<S> const alone = dual_bivector(Alone{group}, x, Vector<S>(mu.components));
    claim.zero("the dual of the algebra: the plus bracket", model,
               Matrix<S>(alone - lie_poisson_tensor_plus(mu)), S(size_of(mu) + S(1)), 30);
    claim.refutes("the dual of the algebra: the minus bracket", model,
                  Matrix<S>(alone + lie_poisson_tensor_plus(mu)), S(size_of(mu) + S(1)));
  });
}

// ----
// Section 4.1, second part: the Lagrange equations on a groupoid and the sequences that solve them.

namespace {

/// How `f(x)` changes for x near the unit of a point, along v.
template <class S, class Gamma, class X, class F>
S rate_along(Gamma const& gamma, X const& point, Vector<S> const& v, F const& f) {
  Fibre<Gamma, Dual<S>> wide(v.size());
  for (Index a = 0; a < v.size(); ++a) wide[a] = Dual<S>(S(0)), wide[a].part[0] = v[a];
  return f(gamma.near_unit(point, wide)).part[0];
}
/// The target of an arrow, as a constant of dual numbers.
template <class S, class Gamma, class A>
auto constant_target(Gamma const& gamma, A const& g) { return gamma.target(gamma.template over<Dual<S>>(g)); }

}  // namespace

STATEMENT(
    def_4_1_1,
    "critical points of $\\mathcal L(g) + \\mathcal L(h)$ among composable pairs with a fixed product") {
  claim.holds(
      "On pairs these are the discrete Euler-Lagrange equations (3.2). On a group they are (3.10), on its "
      "opposite (3.11), both with all signs changed: a relative motion looks back.");
  over_groupoids(claim, [&](auto const& gamma, auto const& model) {
    auto const g = draw_arrows<S>(draw, gamma, 2);
    auto const l = on_arrows(gamma, draw_arrow_polynomial<S>(draw, gamma, g[0]));
    Vector<S> const v = draw_vector<S>(draw, gamma.dimension());
    auto const wide = [&](auto const& arrow) { return gamma.template over<Dual<S>>(arrow); };
    S const residual = Vector<S>(lagrange_equations(gamma, l, g[0], g[1])).dot(v);
    // The definition: move g at its end, and let h be what makes up for it, the inverse of the moved g times
    // gh.
    auto const product = gamma.compose(wide(g[0]), wide(g[1]));
    S const definition = rate_along<S>(gamma, constant_target<S>(gamma, g[0]), v, [&](auto const& x) {
      auto const moved = gamma.compose(wide(g[0]), x);
      return Dual<S>(l(moved) + l(gamma.compose(gamma.inverse(moved), product)));
    });
    auto const scale = magnitude(legendre_at_target(gamma, l, g[0]).components) +
                       magnitude(legendre_at_source(gamma, l, g[1]).components);
    claim.zero("the derivative along a fibre of the multiplication", model, S(residual - definition),
               S(scale), 10);
    // Control: h held, and not the product.
    auto const held = several([&] {
      Vector<S> const w = draw_vector<S>(draw, gamma.dimension());
      S const first = rate_along<S>(gamma, constant_target<S>(gamma, g[0]), w,
                                    [&](auto const& x) { return Dual<S>(l(gamma.compose(wide(g[0]), x))); });
      return S(first - Vector<S>(lagrange_equations(gamma, l, g[0], g[1])).dot(w));
    });
    claim.refutes("h held fixed in place of the product", model, held, S(scale));
  });
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const L = draw_pair_polynomial<S>(draw, group);
    auto const l = draw_group_polynomial<S>(draw, group);
    auto const g0 = draw.template element<S>(group), g1 = draw.template element<S>(group),
               g2 = draw.template element<S>(group);
    auto const on_pairs = [&](auto const& g) { return L(g.first, g.second); };
    Vector<S> const pairs =
        lagrange_equations(Pairs{group}, on_pairs, Arrow<Pairs, S>{g0, g1}, Arrow<Pairs, S>{g1, g2});
    claim.equal("on pairs: (3.2)", model, pairs,
                Vector<S>(discrete_euler_lagrange(L, g0, g1, g2).components));
    Vector<S> const alone = lagrange_equations(Alone{group}, l, g0, g1),
                    printed = euler_poincare_right(l, g0, g1).components;
    claim.equal("on a group: minus (3.10)", model, alone, Vector<S>(-printed));
    claim.differs("on a group: (3.10) with its own sign", model, alone, printed);
    Vector<S> const opposite = lagrange_equations(Opposite<Alone>{{group}}, l, g0, g1),
                    printed_left = euler_poincare_left(l, g0, g1).components;
    claim.equal("on the opposite group: minus (3.11)", model, opposite, Vector<S>(-printed_left));
    if (model != "Heisenberg") claim.differs("on a group: (3.11)", model, alone, Vector<S>(-printed_left));
  });
}

STATEMENT(claim_4_1_solution_sequence,
          "a solution is a sequence of which each neighbouring pair is critical") {
  claim.holds(
      "The sum over the sequence, its product held, changes by the sum of what the pairs leave: all pairs "
      "critical is the same as the sequence stationary. The earlier arrow is the first factor; for "
      "left-invariant systems, $f_{k,k-1} = g_k^{-1}g_{k-1}$, in the opposite of the group.");
  over_groupoids(claim, [&](auto const& gamma, auto const& model) {
    auto const g = draw_arrows<S>(draw, gamma, 4);
    auto const l = on_arrows(gamma, draw_arrow_polynomial<S>(draw, gamma, g[0]));
    auto const wide = [&](auto const& arrow) { return gamma.template over<Dual<S>>(arrow); };
    std::vector<Vector<S>> v;
    for (int k = 0; k < 3; ++k) v.push_back(draw_vector<S>(draw, gamma.dimension()));
    // Move every joint at once: g_k becomes the inverse of x_{k-1}, g_k, x_k.
    Dual<S> sum(S(0)), open(S(0));
    auto product = wide(g[0]);
    for (int k = 0; k < 4; ++k) {
      auto arrow = wide(g[k]), loose = arrow;
      auto const near = [&](int joint) {
        Fibre<std::decay_t<decltype(gamma)>, Dual<S>> w(gamma.dimension());
        for (Index a = 0; a < w.size(); ++a) w[a] = Dual<S>(S(0)), w[a].part[0] = v[joint][a];
        return gamma.near_unit(constant_target<S>(gamma, g[joint]), w);
      };
      if (k < 3) arrow = gamma.compose(arrow, near(k)), loose = arrow;
      if (k > 0) arrow = gamma.compose(gamma.inverse(near(k - 1)), arrow);
      product = k == 0 ? arrow : gamma.compose(product, arrow);
      sum += l(arrow), open += l(loose);
    }
    S expected(0), reversed(0), scale(0);
    for (int k = 0; k < 3; ++k) {
      expected += Vector<S>(lagrange_equations(gamma, l, g[k], g[k + 1])).dot(v[k]);
      reversed += Vector<S>(lagrange_equations(gamma, l, g[k + 1], g[k])).dot(v[k]);
      scale += magnitude(legendre_at_target(gamma, l, g[k]).components) +
               magnitude(legendre_at_source(gamma, l, g[k + 1]).components);
    }
    claim.zero("the sum changes by what the pairs leave", model, S(sum.part[0] - expected), scale, 10);
    auto const entries = gamma.entries(product);
    S moved(0);
    for (Index i = 0; i < entries.size(); ++i) moved += magnitude(entries[i].part[0]);
    claim.zero("the product is held", model, moved, S(magnitude(gamma.entries(product)) + S(1)), 100);
    claim.refutes("joints moved at one side only", model, S(open.part[0] - expected), scale);
    claim.refutes("neighbours in the other order", model, S(sum.part[0] - reversed), scale);
  });
}

// ----
// Section 4.1, third part: the Poisson map that a function generates, and the Poisson structure that it puts
// on the group.

namespace {

/// How a point of the dual of the algebroid, a function of an arrow, moves with the arrow: base first, then
/// components. Row: what moves; column: direction of the arrow.
template <class S, class Gamma, class F>
Matrix<S> tangent_on_arrows(Gamma const& gamma, Arrow<Gamma, S> const& g, F const& legendre_map) {
  int const m = gamma.base_dimension(), n = gamma.dimension();
  Matrix<S> t(m + n, m + n);
  for (int k = 0; k < m + n; ++k) {
    Vector<Dual<S>> w = Vector<Dual<S>>::Zero(m + n);
    w[k].part[0] = S(1);
    auto const p = legendre_map(gamma.moved(gamma.template over<Dual<S>>(g), w));
    if (m > 0) t.col(k).head(m) = gamma.base_rate(p.base);
    for (int a = 0; a < n; ++a) t(m + a, k) = p.components[a].part[0];
  }
  return t;
}

}  // namespace

STATEMENT(def_4_1_2, "the map of the dual of the algebroid generated by a function is a Poisson map") {
  claim.holds(
      "Where the function is regular. The image of its differential is Lagrangian, and the map takes the "
      "covector at the start of an arrow to the one at its end. A one-form that is not closed generates no "
      "Poisson map, and at an arrow where the function is not regular it generates none at all.");
  over_groupoids(claim, [&](auto const& gamma, auto const& model) {
    using Gamma = std::decay_t<decltype(gamma)>;
    auto const g = draw_arrows<S>(draw, gamma, 1)[0];
    auto const polynomial = draw_arrow_polynomial<S>(draw, gamma, g),
               second = draw_arrow_polynomial<S>(draw, gamma, g);
    int const m = gamma.base_dimension(), n = gamma.dimension();
    // The one-form dL + weight L dL'. weight 0: the differential of a function.
    auto const one_form = [&](auto const& maps, S const& weight, auto const& x) {
      auto const l = on_arrows(gamma, polynomial);
      auto p = maps(l, x);
      if (weight == S(0)) return p;
      using T = typename std::decay_t<decltype(x)>::Scalar;
      p.components += maps(on_arrows(gamma, second), x).components * T(T(weight) * l(x));
      return p;
    };
    auto const leaves = [&](S const& weight) {
      return [&, weight](auto const& x) {
        return one_form([&](auto const& f, auto const& y) { return legendre_at_source(gamma, f, y); }, weight,
                        x);
      };
    };
    auto const arrives = [&](S const& weight) {
      return [&, weight](auto const& x) {
        return one_form([&](auto const& f, auto const& y) { return legendre_at_target(gamma, f, y); }, weight,
                        x);
      };
    };
    // The canonical form, pulled back by the one-form, on two tangent vectors: with the gradient in the
    // entries written out.
    Matrix<S> const frame = frame_at<S>(gamma, g);
    Vector<S> const X = frame * draw_vector<S>(draw, m + n), Y = frame * draw_vector<S>(draw, m + n),
                    at = gamma.entries(g);
    auto const pulled_back = [&](S const& weight) {
      auto const rate_of_covector = [&](Vector<S> const& along) {
        Vector<Dual<S>> x(at.size());
        for (Index i = 0; i < at.size(); ++i) x[i] = Dual<S>(at[i]), x[i].part[0] = along[i];
        Vector<Dual<S>> p = polynomial.gradient(x);
        if (weight != S(0)) p += second.gradient(x) * Dual<S>(polynomial.at(x) * Dual<S>(weight));
        Vector<S> rates(at.size());
        for (Index i = 0; i < at.size(); ++i) rates[i] = p[i].part[0];
        return rates;
      };
      return S(rate_of_covector(X).dot(Y) - rate_of_covector(Y).dot(X));
    };
    S const terms = magnitude(polynomial.squares) * magnitude(polynomial.squares) * magnitude(X) *
                    magnitude(Y) * S(Base<S>(at.size() * at.size()));
    claim.zero("dL is Lagrangian", model, pulled_back(S(0)), terms);
    // Condition: two configurations are multiplied.
    claim.equal("the covector at the end is dL on g x", model,
                Vector<S>(legendre_at_target(gamma, on_arrows(gamma, polynomial), g).components),
                Vector<S>(rates_at_target<S>(gamma, g).transpose() * polynomial.gradient(at)), 10);

    // Points over the source and the target of g; the bracket does not depend on the arrow that leads there.
    struct Tangents {
      Matrix<S> before, after, carried, at_target;
      S scale;
      double condition;
    };
    auto const tangents = [&](S const& weight) {
      Matrix<S> const before = tangent_on_arrows<S>(gamma, g, leaves(weight)),
                      after = tangent_on_arrows<S>(gamma, g, arrives(weight)), back = inverse_matrix(before),
                      t = after * back;
      Matrix<S> const at_source = dual_bivector(gamma, gamma.unit(gamma.source(g)),
                                                Fibre<Gamma, S>(leaves(weight)(g).components)),
                      at_target = dual_bivector(gamma, g, Fibre<Gamma, S>(arrives(weight)(g).components));
      return Tangents{before,
                      after,
                      t * at_source * t.transpose(),
                      at_target,
                      S(magnitude(t) * magnitude(at_source) * magnitude(t) + magnitude(at_target)),
                      to_double(row_norm(before) * row_norm(back))};
    };
    auto const of_function = tangents(S(0));
    // Condition: the tangent of the Legendre map at the source is inverted.
    claim.zero("the bracket is preserved", model, Matrix<S>(of_function.carried - of_function.at_target),
               of_function.scale, of_function.condition);
    // Control: a one-form that is not closed.
    auto const of_form = tangents(S(1));
    claim.refutes("a one-form that is not closed: Lagrangian", model, pulled_back(S(1)), terms);
    claim.differs("a one-form that is not closed: the bracket", model, of_form.carried, of_form.at_target);

    // The same function with a square that takes its second derivative at this arrow one rank down: the
    // covector at the start stands still along k.
    auto degenerate = polynomial;
    degenerate.phi = draw_vector<S>(draw, static_cast<int>(at.size())), degenerate.centre = at;
    degenerate.lambda = S(1);
    auto const change = [&](auto const& map, Matrix<S> const& before) {
      return Matrix<S>(tangent_on_arrows<S>(gamma, g, map) - before);
    };
    auto const l = on_arrows(gamma, degenerate);
    Matrix<S> const rank_one =
        change([&](auto const& x) { return legendre_at_source(gamma, l, x); }, of_function.before);
    Matrix<S> const back = inverse_matrix(of_function.before), pulled = back * rank_one;
    S const lambda = S(-1) / pulled.trace();
    Vector<S> const k = pulled * draw_vector<S>(draw, m + n);
    S const size = magnitude(of_function.before) * magnitude(k);
    claim.zero("not regular at this arrow: the covector at the start stands still", model,
               Vector<S>(of_function.before * k + rank_one * k * lambda), size, of_function.condition);
    claim.refutes(
        "not regular at this arrow: the covector at the end as well", model,
        Vector<S>(of_function.after * k +
                  change([&](auto const& x) { return legendre_at_target(gamma, l, x); }, of_function.after) *
                      k * lambda),
        size);
  });
}

STATEMENT(claim_4_1_cotangent_groupoid,
          "$T^*\\Gamma$ is a groupoid over the dual of the algebroid, with "
          "Lagrangian submanifolds for Poisson maps") {
  claim.holds(
      "The product of two covectors is the one that adds them on composable tangent vectors; it "
      "exists exactly where the target of the one is the source of the other. Lagrangian "
      "submanifolds: graphs of differentials in Definition 4.1.2, here the fibres over the elements "
      "of a group, which are no graphs.");
  claim.leaves(
      "That every Lagrangian submanifold of $T^*\\Gamma$ gives a Poisson map is tried on graphs of "
      "differentials and, for groups, on the fibres of $T^*G$, not on one of any other kind such as a "
      "conormal bundle; that the graph of the product of covectors is itself Lagrangian is not tested.");
  over_groupoids(claim, [&](auto const& gamma, auto const& model) {
    using Gamma = std::decay_t<decltype(gamma)>;
    CotangentGroupoid<S, Gamma> const cotangent{gamma};
    auto const g = draw_arrows<S>(draw, gamma, 3);
    int const all = gamma.base_dimension() + gamma.dimension();
    auto const any = [&] { return draw_vector<S>(draw, all); };
    ArrowCovector<S, Gamma> const a{g[0], any()};
    Vector<S> const q = any();
    auto const b = cotangent.with_source(g[1], q, cotangent.target(a)),
               c = cotangent.with_source(g[2], any(), cotangent.target(b));
    auto const ab = cotangent.product(a, b), bc = cotangent.product(b, c);
    S const size = magnitude(a.p) + magnitude(b.p) + magnitude(c.p) + S(1);
    // Condition: of the systems that are solved for the products.
    double const condition = 10 * (ab.condition + bc.condition);
    claim.zero("the product is well defined", model, ab.mismatch, size, condition);
    claim.zero("its source is that of the first", model,
               Vector<S>(cotangent.source(ab.value) - cotangent.source(a)), size, condition);
    claim.zero("its target is that of the second", model,
               Vector<S>(cotangent.target(ab.value) - cotangent.target(b)), size, condition);
    auto const left = cotangent.product(ab.value, c), right = cotangent.product(a, bc.value);
    claim.zero("(ab)c = a(bc)", model, Vector<S>(left.value.p - right.value.p), size,
               10 * (left.condition + right.condition) + condition);
    auto const e = cotangent.unit_over_source(g[0], cotangent.source(a));
    auto const ea = cotangent.product(e, a), back = cotangent.product(a, cotangent.inverse(a));
    claim.zero("units do nothing, on the left", model, Vector<S>(ea.value.p - a.p), size, 10 * ea.condition);
    auto const ae = cotangent.product(a, cotangent.unit_over_source(g[1], cotangent.target(a)));
    claim.zero("and on the right", model, Vector<S>(ae.value.p - a.p), size, 10 * ae.condition);
    claim.zero("a covector and its inverse", model, Vector<S>(back.value.p - e.p), size,
               10 * (back.condition + ea.condition));
    // Controls: covectors whose ends do not meet; the source without its minus; the other order.
    claim.refutes("covectors whose ends do not meet", model,
                  cotangent.product(a, ArrowCovector<S, Gamma>{g[1], q}).mismatch, size);
    claim.refutes(
        "the source without its minus", model,
        cotangent.product(a, cotangent.with_source(g[1], q, Vector<S>(-cotangent.target(a)))).mismatch, size);
    if (gamma.base_dimension() > 0) return;
    // The fibre over g: covectors at g, from their source to their target.
    Matrix<S> const leaving = cotangent.leaving(g[0]).transpose(), solved = inverse_matrix(leaving),
                    t = cotangent.arriving(g[0]).transpose() * solved;
    auto const defect = [&](Matrix<S> const& map) {
      Vector<S> const mu = cotangent.source(a);
      return Matrix<S>(map * dual_bivector(gamma, g[0], Fibre<Gamma, S>(mu)) * map.transpose() -
                       dual_bivector(gamma, g[0], Fibre<Gamma, S>(map * mu)));
    };
    S const scale = magnitude(t) * magnitude(cotangent.source(a)) * magnitude(t) * S(Base<S>(all)) + S(1);
    claim.zero("the fibre over an element of a group generates a Poisson map", model, defect(t), scale,
               10 * to_double(row_norm(leaving) * row_norm(solved)));
    claim.refutes("the same map without its star", model, defect(Matrix<S>(t.transpose())), scale);
  });
}

STATEMENT(claim_4_1_legendre_intertwines,
          "the Legendre maps take the mapping on the groupoid to the mapping on the dual") {
  claim.holds(
      "Both of them, on pairs, groups, their opposites, a group with a vector, gauge groupoids and copies of "
      "a group: $F\\circ\\Sigma = \\Lambda\\circ F$, and both pull the same Poisson structure back.");
  over_groupoids(claim, [&](auto const& gamma, auto const& model) {
    using Gamma = std::decay_t<decltype(gamma)>;
    auto const g = draw_arrows<S>(draw, gamma, 2);
    int const n = gamma.dimension();
    // A function for which the pair is critical, by Definition 4.1.1: L(g x) + L(x^-1 h) is stationary, x
    // along each direction. It is affine in the linear term.
    auto polynomial = draw_arrow_polynomial<S>(draw, gamma, g[0]);
    Matrix<S> const joint = rates_at_target<S>(gamma, g[0]), other = rates_at_source<S>(gamma, g[1]);
    Vector<S> const first = gamma.entries(g[0]), then = gamma.entries(g[1]);
    auto const moved_sum = [&](ArrowPolynomial<S> const& l) {
      return Vector<S>(joint.transpose() * l.gradient(first) + other.transpose() * l.gradient(then));
    };
    // The smallest change of the linear term: a large one would drown the others.
    Matrix<S> const directions = joint + other, columns = Matrix<S>(directions.transpose()) * directions;
    polynomial.linear -= directions * solve_linear(columns, moved_sum(polynomial), "critical pair");
    auto const l = on_arrows(gamma, polynomial);
    auto const at_source = [&](auto const& x) { return legendre_at_source(gamma, l, x); };
    auto const at_target = [&](auto const& x) { return legendre_at_target(gamma, l, x); };
    Vector<S> const p1 = at_target(g[0]).components, p1_again = at_source(g[1]).components,
                    p0 = at_source(g[0]).components, p2 = at_target(g[1]).components;
    S const scale = magnitude(p1) + magnitude(p1_again) + magnitude(p0) + magnitude(p2);
    // Condition: a linear system is solved for the function.
    double const condition = 10 * to_double(row_norm(columns) * row_norm(inverse_matrix(columns)));
    claim.zero("the source of the later arrow is the target of the earlier one", model,
               Vector<S>(p1 - p1_again), scale, condition);
    claim.refutes("the source of the later arrow is minus the target", model, Vector<S>(p1 + p1_again),
                  scale);
    claim.refutes("the pair in the other order", model, Vector<S>(p2 - p0), scale);
    if (!exact_arithmetic<S>()) {
      // The mapping on the dual, solved from elsewhere: takes F(g) to F(h), for both Legendre maps.
      auto const beside = [&](auto const& x) {
        Fibre<Gamma, S> const v = draw_vector<S>(draw, n) * ratio<S>(1, 1024);
        return gamma.compose(x, gamma.leave(gamma.target(x), v));
      };
      auto const from_source = generated_map(gamma, l, at_source(g[0]), beside(g[0])),
                 from_target = generated_map(gamma, l, at_target(g[0]), beside(g[1]));
      // Condition: a solver stops at 16 roundings of its unknown.
      claim.zero("Lambda takes the source covector of g to that of h", model,
                 Vector<S>(Vector<S>(from_source.components) - p1_again), scale, 10 * condition);
      claim.zero("Lambda takes the target covector of g to that of h", model,
                 Vector<S>(Vector<S>(from_target.components) - p2), scale, 10 * condition);
      claim.refutes("Lambda as the identity", model, Vector<S>(p1_again - p0), scale);
    }
    // The structures that the two maps pull back. Condition: both tangents are inverted.
    Matrix<S> const before = inverse_matrix(tangent_on_arrows<S>(gamma, g[0], at_source)),
                    after = inverse_matrix(tangent_on_arrows<S>(gamma, g[0], at_target));
    Matrix<S> const by_source = before *
                                dual_bivector(gamma, gamma.unit(gamma.source(g[0])), Fibre<Gamma, S>(p0)) *
                                before.transpose();
    Matrix<S> const by_target = after * dual_bivector(gamma, g[0], Fibre<Gamma, S>(p1)) * after.transpose();
    S const size =
        magnitude(before) * magnitude(p0) * magnitude(before) + magnitude(by_source) + magnitude(by_target);
    claim.zero("both pull the same structure back to the groupoid", model, Matrix<S>(by_source - by_target),
               size,
               10 * to_double(row_norm(before) * row_norm(tangent_on_arrows<S>(gamma, g[0], at_source)) +
                              row_norm(after) * row_norm(tangent_on_arrows<S>(gamma, g[0], at_target))));
    claim.differs("with opposite signs", model, by_source, Matrix<S>(-by_target));
  });
}

STATEMENT(claim_4_1_poisson_on_group,
          "a regular function on a group puts a Poisson structure on part of it, by "
          "pull-back along a Legendre map") {
  claim.holds(
      "Locally: where the second derivative has an inverse. A function can be regular elsewhere and not at "
      "one element, where no bracket comes back. Both Legendre maps pull back the same structure.");
  over_groups(groups_for_squares<S>(), claim, [&](auto const& group, auto const& model) {
    auto const l = draw_reduced_lagrangian<S>(draw, group);
    auto const f = draw.template element<S>(group);
    Matrix<S> const right = legendre_bivector_right(l, f), left = legendre_bivector_left(l, f);
    Matrix<S> const a = right_second_differential(l, f), b = left_second_differential(l, f);
    double const condition = to_double(row_norm(a) * row_norm(inverse_matrix(a))) +
                             to_double(row_norm(b) * row_norm(inverse_matrix(b)));
    claim.equal("along both Legendre maps", model, right, left, condition);
    // Control: the minus bracket pulled back along one of them.
    claim.differs("the minus bracket along one of them", model, right, Matrix<S>(-left));
    // What it is: functions of the momentum have the bracket of the dual.
    auto const momentum_at = right_differential(l, f);
    claim.zero("the Legendre map is a Poisson map", model,
               Matrix<S>(a * right * a.transpose() - lie_poisson_tensor_plus(momentum_at)),
               S(magnitude(a) * magnitude(right) * magnitude(a)), condition);
    // Local: the same function with a square added that takes its second derivative at f, and there alone,
    // one rank down. The covector at the source stands still along k, the one at the target does not.
    Matrix<S> const phi = draw_matrix<S>(draw, group.matrix_size(), group.matrix_size());
    auto const with_square = [&](S const& lambda) {
      auto bent = l;
      bent.l.phi = {phi}, bent.l.psi = {phi}, bent.l.correction = Vector<S>::Constant(1, lambda / S(2));
      bent.l.linear -= phi * S(lambda * contract(phi, f.value));
      return bent;
    };
    Matrix<S> const rank_one = right_second_differential(with_square(S(1)), f) - a,
                    pulled = inverse_matrix(a) * rank_one;
    S const lambda = S(-1) / pulled.trace();
    auto const flat = with_square(lambda);
    Vector<S> const k = pulled * draw_vector<S>(draw, group.dimension());
    claim.zero("not regular at one element: its Legendre map stands still along a vector", model,
               Vector<S>(right_second_differential(flat, f) * k), S(magnitude(a) * magnitude(k)), condition);
    claim.refutes("the other Legendre map stands still with it", model,
                  Vector<S>(left_second_differential(flat, f) * k), S(magnitude(b) * magnitude(k)));
    auto const elsewhere = draw.template element<S>(group);
    claim.fact("regular elsewhere", model,
               matrix_rank(Matrix<S>(right_second_differential(flat, elsewhere))) == group.dimension());
    claim.fact("its rank is that of the Lie-Poisson bracket", model,
               matrix_rank(right) == matrix_rank(Matrix<S>(lie_poisson_tensor_plus(momentum_at))));
  });
}
