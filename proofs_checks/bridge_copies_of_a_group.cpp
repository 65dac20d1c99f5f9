// Between mechanics on pairs and mechanics on a quotient of them: M = K^n, several copies of a group, modulo
// the motions K of all copies together, with the groupoid (M x M)/K of diagonal_quotient.hpp.
//
// The Lagrangian on pairs is the random function of arrows, pulled back. Derivatives on pairs are taken by
// moving one configuration at a time; the groupoid takes no part in them.
#include "actio/groupoid/lagrange_equations.hpp"
#include "models/groupoids.hpp"
#include "models/sequences.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

template <class S, int n>
using Copies = std::array<GroupElement<S>, n>;

template <class S, std::size_t n>
std::array<GroupElement<Dual<S>>, n> constant(std::array<GroupElement<S>, n> const& g) {
  return [&]<std::size_t... i>(std::index_sequence<i...>) {
    return std::array<GroupElement<Dual<S>>, n>{over<Dual<S>>(g[i])...};
  }(std::make_index_sequence<n>());
}
template <class S, int n>
Copies<S, n> draw_copies(Draw& draw, SpannedGroup const& group) {
  return [&]<std::size_t... i>(std::index_sequence<i...>) {
    return Copies<S, n>{((void)i, draw.template element<S>(group))...};
  }(std::make_index_sequence<n>());
}
/// All copies multiplied by k, from the left or from the right.
template <class S, std::size_t n>
std::array<GroupElement<S>, n> moved_together(std::array<GroupElement<S>, n> g, GroupElement<S> const& k,
                                              bool from_the_left) {
  for (auto& copy : g) copy = from_the_left ? k * copy : copy * k;
  return g;
}
/// The rate of `f(g)` when the i-th copy moves along its a-th direction, as it sees it itself.
template <class S, std::size_t n, class F>
S own_rate(std::array<GroupElement<S>, n> const& g, int i, int a, F const& f) {
  auto moving = constant(g);
  Vector<Dual<S>> v = Vector<Dual<S>>::Zero(g[0].group.dimension());
  v[a].part[0] = S(1);
  moving[i] = moving[i] * GroupElement<Dual<S>>{g[0].group, primitive::near_identity(g[0].group, v)};
  return f(moving).part[0];
}
/// The rate when all copies move together along zeta, seen from outside.
template <class S, std::size_t n, class F>
S common_rate(std::array<GroupElement<S>, n> const& g, Vector<S> const& zeta, F const& f) {
  Vector<Dual<S>> v(zeta.size());
  for (Index a = 0; a < zeta.size(); ++a) v[a] = Dual<S>(S(0)), v[a].part[0] = zeta[a];
  GroupElement<Dual<S>> const k{g[0].group, primitive::near_identity(g[0].group, v)};
  return f(moved_together(constant(g), k, true)).part[0];
}

}  // namespace

STATEMENT(bridge_reduced_copies, "Lagrange equations on $(M\\times M)/K$ and on $M\\times M$, $M = K^n$") {
  claim.holds(
      "For any function of arrows and its pull-back to pairs, at any three configurations: the residuals are "
      "equal in the frames in which each copy sees its own motion. So the one is stationary exactly if the "
      "other is, and configurations are found again from arrows. The momentum of $K$ changes by what the "
      "residuals leave of it.");
  auto const in_copies = [&]<int n>(SpannedGroup const& group) {
    using Gamma = DiagonalQuotient<SpannedGroup, n>;
    Gamma const gamma{group};
    std::string const model = (n == 2 ? "two copies of " : "three copies of ") + group.name();
    int const d = group.dimension();
    auto const a = draw_copies<S, n>(draw, group), b = draw_copies<S, n>(draw, group),
               c = draw_copies<S, n>(draw, group);
    auto const ab = Gamma::reduced(a, b), bc = Gamma::reduced(b, c);
    auto const l = on_arrows(gamma, draw_arrow_polynomial<S>(draw, gamma, ab));
    auto const on_pairs = [&](auto const& g, auto const& h) { return l(Gamma::reduced(g, h)); };

    auto const k = draw.template element<S>(group);
    auto const pushed = [&](bool left) {
      return on_pairs(moved_together(a, k, left), moved_together(b, k, left));
    };
    // Condition: configurations are inverted.
    claim.equal("the pull-back is invariant", model, pushed(true), on_pairs(a, b), 100);
    claim.differs("moved from the other side", model, pushed(false), on_pairs(a, b));

    claim.equal("pairs that follow each other have the product of their arrows", model,
                gamma.entries(gamma.compose(ab, bc)), gamma.entries(Gamma::reduced(a, c)), 10);
    claim.differs("the elements in the other order", model, gamma.entries(Gamma::reduced(a, c)),
                  gamma.entries(Arrow<Gamma, S>{ab.from, bc.to, bc.element * ab.element}));

    // The residuals. On pairs: the middle configuration moves, a copy at a time.
    auto const sum = [&](auto const& middle) {
      return Dual<S>(on_pairs(constant(a), middle) + on_pairs(middle, constant(c)));
    };
    Vector<S> const reduced = lagrange_equations(gamma, l, ab, bc);
    Vector<S> unreduced(n * d), arrival(n * d), outside(n * d);
    for (int i = 0; i < n; ++i)
      for (int e = 0; e < d; ++e) {
        unreduced[i * d + e] = own_rate(b, i, e, sum);
        arrival[i * d + e] =
            own_rate(b, i, e, [&](auto const& middle) { return Dual<S>(on_pairs(constant(a), middle)); });
        auto copies = constant(b);
        Vector<Dual<S>> v = Vector<Dual<S>>::Zero(d);
        v[e].part[0] = S(1);
        copies[i] = GroupElement<Dual<S>>{group, primitive::near_identity(group, v)} * copies[i];
        outside[i * d + e] = sum(copies).part[0];
      }
    auto const scale = S(magnitude(legendre_at_target(gamma, l, ab).components) +
                         magnitude(legendre_at_source(gamma, l, bc).components));
    claim.zero("the residuals on pairs and on arrows", model, Vector<S>(unreduced - reduced), scale, 10);
    claim.zero("the momenta at the end of a step", model,
               Vector<S>(arrival - legendre_at_target(gamma, l, ab).components), scale, 10);
    claim.refutes("variations seen from outside", model, Vector<S>(outside - reduced), scale);
    claim.refutes("arrows in the other order", model,
                  Vector<S>(unreduced - lagrange_equations(gamma, l, bc, ab)), scale);

    // Configurations from arrows: the first copy by the elements, the others from it.
    auto const first = a[0] * ab.element * bc.element;
    for (int i = 0; i < n; ++i)
      claim.equal("configurations from arrows", model, (i == 0 ? first : first * bc.to[i - 1]).value,
                  c[i].value, 10);
    claim.differs("the elements on the other side", model, (bc.element * ab.element * a[0]).value,
                  c[0].value);

    // The momentum of K, from D_2 of the first step less -D_1 of the second, is the residual along K.
    Vector<S> const zeta = draw_vector<S>(draw, d);
    auto const momentum_after = [&](auto const& from, auto const& to) {
      return common_rate(to, zeta,
                         [&](auto const& moved) { return Dual<S>(on_pairs(constant(from), moved)); });
    };
    auto const momentum_before = [&](auto const& from, auto const& to) {
      return S(-common_rate(from, zeta,
                            [&](auto const& moved) { return Dual<S>(on_pairs(moved, constant(to))); }));
    };
    S along(0);
    for (int i = 0; i < n; ++i)
      along += Vector<S>(Ad(inverse(b[i]), velocity(group, zeta)).coordinates).dot(reduced.segment(i * d, d));
    S const size = S(magnitude(zeta) * scale * S(Base<S>(n)) + S(1));
    claim.zero("the momentum of K is one along a step", model,
               S(momentum_after(a, b) - momentum_before(a, b)), size, 100);
    claim.zero("from step to step it changes by the residual along K", model,
               S(momentum_after(a, b) - momentum_after(b, c) - along), size, 100);
    claim.refutes("by the residual of the first copy alone", model, several([&] {
                    auto const other = draw_vector<S>(draw, d);
                    S const one =
                        Vector<S>(Ad(inverse(b[0]), velocity(group, other)).coordinates).dot(reduced.head(d));
                    return S(momentum_after(a, b) - momentum_after(b, c) - one);
                  }),
                  size);
  };
  static SpannedGroup const aff = spanned("Aff(1)", Aff1{}), se2 = spanned("SE(2)", SE<2>{}),
                            so3 = spanned("SO(3)", SO<3>{});
  in_copies.template operator()<2>(aff);
  in_copies.template operator()<3>(aff);
  in_copies.template operator()<2>(so3);
  in_copies.template operator()<2>(se2);
}
