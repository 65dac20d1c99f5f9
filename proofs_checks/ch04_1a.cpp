// Section 4.1, first part: groupoids, their algebroids and the Poisson structures on the duals of these. Compiled once per scalar.
//
// Degrees: places are rational functions of degree below 8 in the numbers drawn; the Gram matrix of an algebroid is inverted, products of up to six places. The bounds say so.
#include "actio/groupoid/algebroid.hpp"
#include "actio/variational/lie_poisson.hpp"
#include "groupoids.hpp"
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
/// What bracket and anchor are known to be: those of right-invariant vector fields on G, where the bracket is minus the commutator; of the algebra; of the algebra with its action on vectors; of both.
template <class S>
Matrix<S> known_bracket(Pairs const& gamma, int a) { return -commutators_with<S>(gamma.group, a); }
template <class S>
Matrix<S> known_bracket(Alone const& gamma, int a) { return commutators_with<S>(gamma.group, a); }
template <class S>
Matrix<S> known_bracket(Opposite<Alone> const& gamma, int a) { return -commutators_with<S>(gamma.of.group, a); }
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
Matrix<S> known_anchor(Pairs const& gamma, A const&) { return Matrix<S>::Identity(gamma.dimension(), gamma.dimension()); }
template <class S, class Gamma, class A>
  requires std::same_as<Point<Gamma, S>, SinglePoint<S>>
Matrix<S> known_anchor(Gamma const& gamma, A const&) { return Matrix<S>(0, gamma.dimension()); }
template <class S, class A>
Matrix<S> known_anchor(Carrying const& gamma, A const& g) {
  Matrix<S> rho(gamma.base_dimension(), gamma.dimension());
  for (int a = 0; a < gamma.dimension(); ++a) rho.col(a) = -(gamma.group.hat(Vector<S>(Vector<S>::Unit(gamma.dimension(), a))) * gamma.target(g).value);
  return rho;
}
template <class S, class A>
Matrix<S> known_anchor(Gauge const& gamma, A const&) { return Matrix<S>::Identity(gamma.base, gamma.dimension()); }

}  // namespace

STATEMENT(claim_4_1_groupoids, "pairs and groups are groupoids, with TG and the algebra as their algebroids") {
  claim.holds("The bracket of the algebroid of pairs is that of vector fields on G, which on right-invariant fields is minus the commutator.");
  claim.degree(400);
  over_groupoids(claim, [&](auto const& gamma, auto const& model) {
    auto const g = draw_arrows<S>(draw, gamma, 3);
    auto const same = [&](auto const& what, auto const& a, auto const& b) { claim.equal(what, model, gamma.entries(a), gamma.entries(b)); };
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
    // Condition: Gram's matrix of the entries is inverted, once for each pair of directions; the entries of a place are of order 1, and its condition is below 30.
    S const scale = magnitude(known) + S(1);
    claim.zero("bracket of the algebroid", model, Matrix<S>(all - known), scale, 30);
    if (magnitude(known) > Base<S>(0)) claim.refutes("the bracket with the other sign", model, Matrix<S>(all + known), scale);
    if (gamma.base_dimension() > 0) claim.equal("anchor", model, Matrix<S>(anchor(gamma, g[0])), known_anchor<S>(gamma, g[0]), 10);
  });
}

STATEMENT(claim_4_1_dual_poisson, "the duals of the algebroids are Poisson manifolds: T*G with the canonical bracket, the dual of the algebra with the Lie-Poisson bracket") {
  claim.convention("Weinstein's bracket, in which momenta p(X), p(Y) of vector fields have the bracket p([X, Y]), is on T*G minus the canonical one with {q, p} = 1, and on the dual of the algebra the plus Lie-Poisson bracket.");
  claim.degree(400);
  over_groupoids(claim, [&](auto const& gamma, auto const& model) {
    auto const g = draw_arrows<S>(draw, gamma, 1)[0];
    int const m = gamma.base_dimension(), n = gamma.dimension();
    Vector<S> const p = draw_vector<S>(draw, n);
    Matrix<S> const pi = dual_bivector(gamma, g, p);
    S const scale = magnitude(pi) + S(1);
    // By the definition, with bracket and anchor written out. Condition: as in claim_4_1_groupoids.
    Matrix<S> known = Matrix<S>::Zero(m + n, m + n);
    if (m > 0) known.topRightCorner(m, n) = -known_anchor<S>(gamma, g), known.bottomLeftCorner(n, m) = -known.topRightCorner(m, n).transpose();
    for (int a = 0; a < n; ++a) known.block(m + a, m, 1, n) = p.transpose() * known_bracket<S>(gamma, a);
    claim.zero("the bracket on the dual of the algebroid", model, Matrix<S>(pi - known), scale, 30);
    claim.refutes("with the other sign", model, Matrix<S>(pi + known), scale);
  });
  over_groups(few_groups(), claim, [&](auto const& group, auto const& model) {
    int const d = group.dimension();
    auto const mu = draw.template momentum<S>(group);
    auto const x = draw.template element<S>(group);
    // T*G: {F, H} = <dF, H_mu> - <dH, F_mu> + <mu, [F_mu, H_mu]> is the canonical bracket, momenta carried to the identity on the right (claim_2_2_lie_poisson_equivalence).
    Matrix<S> canonical = Matrix<S>::Zero(2 * d, 2 * d);
    canonical.topRightCorner(d, d).setIdentity();
    canonical.bottomLeftCorner(d, d) = -Matrix<S>::Identity(d, d);
    canonical.bottomRightCorner(d, d) = lie_poisson_tensor_plus(mu);
    Matrix<S> const pairs = dual_bivector(Pairs{group}, Arrow<Pairs, S>{x, x}, Vector<S>(mu.components));
    claim.zero("T*G: minus the canonical bracket", model, Matrix<S>(pairs + canonical), S(magnitude(canonical)), 30);
    claim.refutes("T*G: the canonical bracket itself", model, Matrix<S>(pairs - canonical), S(magnitude(canonical)));
    Matrix<S> const alone = dual_bivector(Alone{group}, x, Vector<S>(mu.components));
    claim.zero("the dual of the algebra: the plus bracket", model, Matrix<S>(alone - lie_poisson_tensor_plus(mu)), S(size_of(mu) + S(1)), 30);
    claim.refutes("the dual of the algebra: the minus bracket", model, Matrix<S>(alone + lie_poisson_tensor_plus(mu)), S(size_of(mu) + S(1)));
  });
}
