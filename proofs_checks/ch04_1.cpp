// Section 4.1, first part: groupoids, their algebroids and the Poisson structures on the duals of these.

#include "actio/groupoid/algebroid.hpp"
#include "actio/groupoid/lagrange_equations.hpp"
#include "actio/groupoid/poisson_on_group.hpp"
#include "actio/reduction/discrete_euler_lagrange.hpp"
#include "actio/reduction/discrete_euler_poincare.hpp"
#include "actio/variational/lie_poisson.hpp"

#include "groupoids.hpp"
#include "sequences.hpp"
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
/// minus the commutator; of the algebra; of the algebra with its action on vectors; of both.
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
      "Y])$, is on $T^*G$ minus the canonical one with $\\{q, p\\} = 1$, and on the dual of the algebra "
      "the plus Lie-Poisson bracket.");
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

STATEMENT(def_4_1_1,
          "critical points of $\\mathcal L(g) + \\mathcal L(h)$ among composable pairs "
          "with a fixed product") {
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
      "critical is the same as the sequence stationary.");
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
    S expected(0), scale(0);
    for (int k = 0; k < 3; ++k) {
      expected += Vector<S>(lagrange_equations(gamma, l, g[k], g[k + 1])).dot(v[k]);
      scale += magnitude(legendre_at_target(gamma, l, g[k]).components) +
               magnitude(legendre_at_source(gamma, l, g[k + 1]).components);
    }
    claim.zero("the sum changes by what the pairs leave", model, S(sum.part[0] - expected), scale, 10);
    auto const entries = gamma.entries(product);
    S moved(0);
    for (Index i = 0; i < entries.size(); ++i) moved += magnitude(entries[i].part[0]);
    claim.zero("the product is held", model, moved, S(magnitude(gamma.entries(product)) + S(1)), 100);
    claim.refutes("joints moved at one side only", model, S(open.part[0] - expected), scale, 1e-4);
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
      "Where the function is regular. The map takes the covector at the start of an arrow to the one at "
      "its end.");
  over_groupoids(claim, [&](auto const& gamma, auto const& model) {
    auto const g = draw_arrows<S>(draw, gamma, 1)[0];
    auto const l = on_arrows(gamma, draw_arrow_polynomial<S>(draw, gamma, g)),
               other = on_arrows(gamma, draw_arrow_polynomial<S>(draw, gamma, g));
    auto const leaves = [&](auto const& f) {
      return [&gamma, f](auto const& x) { return legendre_at_source(gamma, f, x); };
    };
    auto const arrives = [&](auto const& f) {
      return [&gamma, f](auto const& x) { return legendre_at_target(gamma, f, x); };
    };
    Matrix<S> const before = tangent_on_arrows<S>(gamma, g, leaves(l)),
                    after = tangent_on_arrows<S>(gamma, g, arrives(l));
    Matrix<S> const back = inverse_matrix(before);
    // Points over the source and the target of g; the bracket does not depend on the arrow that leads there.
    Matrix<S> const at_source = dual_bivector(gamma, gamma.unit(gamma.source(g)),
                                              Vector<S>(legendre_at_source(gamma, l, g).components));
    Matrix<S> const at_target =
        dual_bivector(gamma, g, Vector<S>(legendre_at_target(gamma, l, g).components));
    auto const defect = [&](Matrix<S> const& end, Matrix<S> const& bivector) {
      Matrix<S> const t = end * back;
      return Matrix<S>(t * at_source * t.transpose() - bivector);
    };
    Matrix<S> const t = after * back;
    S const scale = magnitude(t) * magnitude(at_source) * magnitude(t) + magnitude(at_target);
    // Condition: the tangent of the Legendre map at the source is inverted.
    claim.zero("the bracket is preserved", model, defect(after, at_target), scale,
               to_double(row_norm(before) * row_norm(back)));
    // Control: leave with the covector of one function, arrive with that of another: no function generates
    // that.
    Matrix<S> const foreign = tangent_on_arrows<S>(gamma, g, arrives(other));
    Matrix<S> const foreign_bivector =
        dual_bivector(gamma, g, Vector<S>(legendre_at_target(gamma, other, g).components));
    Matrix<S> const mixed = foreign * back;
    // On a two-dimensional algebra alone every map of the plane that scales the bracket right is Poisson, so
    // one control suffices for the larger ones.
    claim.refutes("covectors of two functions", model, defect(foreign, foreign_bivector),
                  S(magnitude(mixed) * magnitude(at_source) * magnitude(mixed) + magnitude(foreign_bivector)),
                  1e-4);
    // Control: a function that is not regular generates nothing.
    auto const constant = [&](auto const& x) { return decltype(l(x))(S(1)); };
    claim.template refuses<Singular>("a function that is constant", model, [&] {
      inverse_matrix(tangent_on_arrows<S>(gamma, g, leaves(constant)));
    });
  });
}

STATEMENT(claim_4_1_poisson_on_group,
          "a regular function on a group puts a Poisson structure on part of it, by pull-back along a "
          "Legendre map") {
  claim.holds(
      "Locally: where the second derivative has an inverse. Both Legendre maps pull back the same "
      "structure.");
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
    // Local: where the second derivative has no inverse there is no structure.
    auto const flat = [&](auto const& x) {
      return contract(Matrix<S>(Matrix<S>::Identity(group.matrix_size(), group.matrix_size())), x.value) * 0;
    };
    claim.template refuses<Singular>("where the second derivative has no inverse", model,
                                     [&] { legendre_bivector_right(flat, f); });
    claim.fact("its rank is that of the Lie-Poisson bracket", model,
               matrix_rank(right) == matrix_rank(Matrix<S>(lie_poisson_tensor_plus(momentum_at))));
  });
}
