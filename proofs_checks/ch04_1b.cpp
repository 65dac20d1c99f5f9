// Section 4.1, second part: the Lagrange equations on a groupoid and the sequences that solve them. Compiled once per scalar.
//
// Degrees: a function of arrows is cubic in entries of degree below 16, arrows are multiplied twice. The bounds say so.
#include "actio/groupoid/lagrange_equations.hpp"
#include "actio/reduction/discrete_euler_lagrange.hpp"
#include "actio/reduction/discrete_euler_poincare.hpp"
#include "groupoids.hpp"
#include "sequences.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

/// How `f(x)` changes for x near the unit of a point, along v.
template <class S, class Gamma, class X, class F>
S rate_along(Gamma const& gamma, X const& point, Vector<S> const& v, F const& f) {
  Fibre<Gamma, Dual<S>> wide(v.size());
  for (Eigen::Index a = 0; a < v.size(); ++a) wide[a] = Dual<S>(S(0)), wide[a].part[0] = v[a];
  return f(gamma.near_unit(point, wide)).part[0];
}
/// The target of an arrow, as a constant of dual numbers.
template <class S, class Gamma, class A>
auto constant_target(Gamma const& gamma, A const& g) {
  return gamma.target(gamma.template over<Dual<S>>(g));
}

}  // namespace

STATEMENT(def_4_1_1, "critical points of L(g) + L(h) among composable pairs with a fixed product") {
  claim.holds("On pairs these are the discrete Euler-Lagrange equations (3.2). On a group they are (3.10), on its opposite (3.11), both with all signs changed: a relative motion looks back.");
  claim.degree(400);
  over_groupoids(claim, [&](auto const& gamma, auto const& model) {
    auto const g = draw_arrows<S>(draw, gamma, 2);
    auto const l = on_arrows(gamma, draw_arrow_polynomial<S>(draw, gamma, g[0]));
    Vector<S> const v = draw_vector<S>(draw, gamma.dimension());
    auto const wide = [&](auto const& arrow) { return gamma.template over<Dual<S>>(arrow); };
    S const residual = Vector<S>(lagrange_equations(gamma, l, g[0], g[1])).dot(v);
    // The definition: move g at its end, and let h be what makes up for it, the inverse of the moved g times gh.
    auto const product = gamma.compose(wide(g[0]), wide(g[1]));
    S const definition = rate_along<S>(gamma, constant_target<S>(gamma, g[0]), v, [&](auto const& x) {
      auto const moved = gamma.compose(wide(g[0]), x);
      return Dual<S>(l(moved) + l(gamma.compose(gamma.inverse(moved), product)));
    });
    auto const scale = magnitude(legendre_at_target(gamma, l, g[0]).components) + magnitude(legendre_at_source(gamma, l, g[1]).components);
    claim.zero("the derivative along a fibre of the multiplication", model, S(residual - definition), S(scale), 10);
    // Control: h held, and not the product.
    auto const held = several([&] {
      Vector<S> const w = draw_vector<S>(draw, gamma.dimension());
      S const first = rate_along<S>(gamma, constant_target<S>(gamma, g[0]), w, [&](auto const& x) { return Dual<S>(l(gamma.compose(wide(g[0]), x))); });
      return S(first - Vector<S>(lagrange_equations(gamma, l, g[0], g[1])).dot(w));
    });
    claim.refutes("h held fixed in place of the product", model, held, S(scale));
  });
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const L = draw_pair_polynomial<S>(draw, group);
    auto const l = draw_group_polynomial<S>(draw, group);
    auto const g0 = draw.template element<S>(group), g1 = draw.template element<S>(group), g2 = draw.template element<S>(group);
    auto const on_pairs = [&](auto const& g) { return L(g.first, g.second); };
    Vector<S> const pairs = lagrange_equations(Pairs{group}, on_pairs, Arrow<Pairs, S>{g0, g1}, Arrow<Pairs, S>{g1, g2});
    claim.equal("on pairs: (3.2)", model, pairs, Vector<S>(discrete_euler_lagrange(L, g0, g1, g2).components));
    Vector<S> const alone = lagrange_equations(Alone{group}, l, g0, g1), printed = euler_poincare_right(l, g0, g1).components;
    claim.equal("on a group: minus (3.10)", model, alone, Vector<S>(-printed));
    claim.differs("on a group: (3.10) with its own sign", model, alone, printed);
    Vector<S> const opposite = lagrange_equations(Opposite<Alone>{{group}}, l, g0, g1), printed_left = euler_poincare_left(l, g0, g1).components;
    claim.equal("on the opposite group: minus (3.11)", model, opposite, Vector<S>(-printed_left));
    if (model != "Heisenberg") claim.differs("on a group: (3.11)", model, alone, Vector<S>(-printed_left));
  });
}

STATEMENT(claim_4_1_solution_sequence, "a solution is a sequence of which each neighbouring pair is critical") {
  claim.holds("The sum over the sequence, its product held, changes by the sum of what the pairs leave: all pairs critical is the same as the sequence stationary.");
  claim.degree(800);
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
        for (Eigen::Index a = 0; a < w.size(); ++a) w[a] = Dual<S>(S(0)), w[a].part[0] = v[joint][a];
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
      scale += magnitude(legendre_at_target(gamma, l, g[k]).components) + magnitude(legendre_at_source(gamma, l, g[k + 1]).components);
    }
    claim.zero("the sum changes by what the pairs leave", model, S(sum.part[0] - expected), scale, 10);
    auto const entries = gamma.entries(product);
    S moved(0);
    for (Eigen::Index i = 0; i < entries.size(); ++i) moved += magnitude(entries[i].part[0]);
    claim.zero("the product is held", model, moved, S(magnitude(gamma.entries(product)) + S(1)), 100);
    claim.refutes("joints moved at one side only", model, S(open.part[0] - expected), scale, 1e-4);
  });
}
