// Section 4.3, third part: motions along the square: reconstruction, leaves that are kept, and steps of different lengths. Compiled once per scalar.
//
// Degrees: as in ch03_2d.cpp. Orders are fitted in double, against power series of equations written out by hand (top_in_any_group.hpp).
#include "chart_models.hpp"
// The exact exponentials must come first.
#include "actio/groupoid/poisson_on_group.hpp"
#include "actio/reduction/discrete_lie_poisson.hpp"
#include "actio/reduction/discrete_poisson.hpp"
#include "actio/reduction/relative_motion.hpp"
#include "limits.hpp"
#include "sequences.hpp"
#include "statement.hpp"
#include "top_in_any_group.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

/// Three relative motions, places that have them, and a reduced Lagrangian of which they are a motion.
template <class S>
struct Motion {
  Places<S> f, g;
  MotionPolynomial<S> l;
};
template <class S>
Motion<S> draw_motion(Draw& draw, SpannedGroup const& group) {
  auto const f = draw_places<S>(draw, group, 3);
  return {f, places_right(draw.template element<S>(group), f), with_motions_right(draw_reduced_lagrangian<S>(draw, group), f)};
}
/// The Casimirs of the dual that are known in closed form: |mu|^2 for rotations; |p|^2 and <turn, p> for motions of space; for GL(2) traces of powers of the matrix of mu.
template <class S>
Vector<S> casimirs(Momentum<SpannedGroup, S> const& mu) {
  auto const& c = mu.components;
  if (mu.group.name() == "SO(3)") return Vector<S>::Constant(1, c.dot(c));
  if (mu.group.name() == "SE(3)") return (Vector<S>(2) << c.tail(3).dot(c.tail(3)), c.head(3).dot(c.tail(3))).finished();
  if (mu.group.name() == "GL(2)") return (Vector<S>(2) << c[0] + c[3], c[0] * c[3] - c[1] * c[2]).finished();
  return Vector<S>(0);
}
/// Momentum with the sign of a Lagrangian on the algebra, at a state of a top.
template <class S>
Momentum<SpannedGroup, S> momentum_of(TopInAnyGroup<S> const& top, State<SpannedGroup, S> const& at) {
  return momentum(top.group, Vector<S>(top.a * at.velocity.coordinates + top.b));
}

}  // namespace

STATEMENT(cor_4_3_1, "the discrete Lie-Poisson motion, reconstructed, is the image of the discrete Euler-Lagrange motion and approximates the Hamiltonian flow") {
  claim.holds("With (3.14) for the places: the momenta alone do not tell them. The order is that of the discrete Lagrangian, here 2.");
  claim.degree(2000);
  over_groups(few_groups(), claim, [&](auto const& group, auto const& model) {
    auto const m = draw_motion<S>(draw, group);
    for (int k = 0; k < 2; ++k)
      claim.zero("the places are a discrete Euler-Lagrange motion", model, discrete_euler_lagrange(lifted(m.l), m.g[k], m.g[k + 1], m.g[k + 2]), momenta_of(m.l, m.f), 10);
    // Carry the first momentum along, and compare it with the Legendre map of the places.
    auto mu = momentum_before_right(m.l, m.f[0]);
    for (int k = 0; k < 3; ++k) {
      // Condition: the momentum has been carried k times.
      claim.equal("momenta", model, mu, -D1(lifted(m.l), m.g[k], m.g[k + 1]), 30);
      mu = coadjoint(m.f[k], mu);
    }
    auto other = momentum_before_right(m.l, m.f[0]);
    claim.differs("the momentum carried the other way", model, coadjoint(inverse(m.f[0]), other), -D1(lifted(m.l), m.g[1], m.g[2]));
  });
  if constexpr (fits_orders<S>)
    for (auto const& group : limit_groups()) {
      auto const top = draw_top_without_weight<S>(draw, group);
      State<SpannedGroup, S> const v{draw.template element<S>(group), draw.template velocity<S>(group)};
      auto const exact = top.flow(v, S(by_halves.duration)).first;
      auto const run = [&](int n, double h, bool forwards) {
        auto const l = natural_chart_lagrangian_right(reduced(top), h);
        auto place = v.place;
        auto mu = momentum_of(top, v);
        auto f = exp(S(-h) * v.velocity);
        for (int k = 0; k < n; ++k) {
          f = relative_motion_from_momentum_right(l, mu, f).value;
          mu = lie_poisson_update_right(f, mu);
          place = reconstruct_right(place, forwards ? f : inverse(f));
        }
        return std::max(magnitude((place.value - exact.place.value).eval()), size_of(mu - momentum_of(top, exact)));
      };
      claim.order("place and momentum against the Hamiltonian flow", group.name(), by_halves.step_lengths(), by_halves.errors_of([&](int n, double h) { return run(n, h, true); }), 2);
      claim.refutes_order("reconstructed with f in place of its inverse", group.name(), by_halves.step_lengths(), by_halves.errors_of([&](int n, double h) { return run(n, h, false); }), 2);
    }
}

STATEMENT(claim_4_3_reconstruction_image, "momenta lifted along the quotient map against the image of the unreduced motion") {
  claim.convention("The preimage of a momentum under the quotient map is a whole orbit of the symmetry. The lift is the image of the unreduced motion when the places come by (3.14), and then all momenta of the symmetry are kept.");
  claim.degree(2000);
  over_groups(few_groups(), claim, [&](auto const& group, auto const& model) {
    auto const m = draw_motion<S>(draw, group);
    auto const body = [&](Place<S> const& g, Momentum<SpannedGroup, S> const& mu) { return coadjoint(g, mu); };
    auto g = m.g[0];
    auto const first = body(g, momentum_before_right(m.l, m.f[0]));
    for (int k = 0; k < 3; ++k) {
      auto const mu = momentum_before_right(m.l, m.f[k]);
      claim.equal("places", model, g, m.g[k], 30);
      claim.equal("momentum of the symmetry along the lift", model, body(g, mu), first, 30);
      g = reconstruct_right(g, m.f[k]);
    }
    // Controls: another place over the same momentum is on no motion with the first; the other side.
    auto const elsewhere = m.g[1] * draw.template element<S>(group);
    auto const mu1 = momentum_before_right(m.l, m.f[1]);
    claim.differs("another place over the same momentum", model, body(elsewhere, mu1), first);
    claim.differs("reconstructed with f in place of its inverse", model, body(m.f[0] * m.g[0], mu1), first);
  });
}

STATEMENT(claim_4_3_invariant_leaves, "the reduced motion stays on the symplectic leaves of the group, which correspond to coadjoint orbits") {
  claim.holds("Locally, as the structure is. A leaf is a component of what the Legendre map sends into one orbit.");
  claim.degree(4000);
  over_groups(few_groups(), claim, [&](auto const& group, auto const& model) {
    auto const m = draw_motion<S>(draw, group);
    auto const other = draw_reduced_lagrangian<S>(draw, group);
    for (int k = 0; k < 2; ++k) {
      auto const mu = momentum_before_right(m.l, m.f[k]), next = momentum_before_right(m.l, m.f[k + 1]);
      claim.equal("the Legendre map takes the motion into one orbit", model, next, coadjoint(m.f[k], mu), 10);
      if (casimirs(mu).size() > 0) {
        auto const size = magnitude(casimirs(mu)) + size_of(mu) * size_of(mu);
        claim.zero("Casimirs, pulled back to the group", model, Vector<S>(casimirs(next) - casimirs(mu)), S(size), 100);
        claim.refutes("Casimirs, pulled back along the Legendre map of another function", model,
                      Vector<S>(casimirs(momentum_before_right(other, m.f[k + 1])) - casimirs(momentum_before_right(other, m.f[k]))), S(size));
      }
      // The tangent of a step takes vectors of the leaf to vectors of the leaf: the generator moves with the later place. Condition: l'' is inverted.
      auto const eta = draw.template velocity<S>(group);
      auto const u = leaf_vector(m.l, m.f[k], eta);
      auto const carried = Ad(inverse(m.f[k]), eta - u);
      Matrix<S> const t = euler_poincare_tangent_right(m.l, m.f[k], m.f[k + 1]), a = right_second_differential(m.l, m.f[k + 1]);
      auto const after = leaf_vector(m.l, m.f[k + 1], carried);
      double const condition = to_double(row_norm(a) * row_norm(inverse_matrix(a)));
      claim.zero("the tangent of a step keeps the leaves", model, Vector<S>(t * u.coordinates - after.coordinates), S(magnitude(t) * size_of(u) + size_of(after)), condition);
      claim.refutes("with the generator left as it was", model, Vector<S>(t * u.coordinates - leaf_vector(m.l, m.f[k + 1], eta).coordinates), S(size_of(after)), 1e-4);
    }
    // The leaf's tangent space is the image of the bracket: A P = Pi_+ A^-T.
    Matrix<S> const a = right_second_differential(m.l, m.f[0]), p = legendre_bivector_right(m.l, m.f[0]), pi = lie_poisson_tensor_plus(right_differential(m.l, m.f[0]));
    claim.fact("the image of the bracket is mapped onto the tangent space of the orbit", model, [&] {
      Matrix<S> both(a.rows(), 2 * a.cols());
      both << Matrix<S>(a * p), pi;
      return matrix_rank(both) == matrix_rank(pi) && matrix_rank(p) == matrix_rank(pi);
    }());
  });
}

STATEMENT(claim_4_3_time_step_legendre, "with a Lagrangian divided by the step, the Legendre map must be multiplied by it") {
  claim.convention("With the sign of the physical momentum, -h D_1. For a discrete Lagrangian that is an action there is nothing to multiply, and steps may differ.");
  claim.degree(2000);
  over_groups(few_groups(), claim, [&](auto const& group, auto const& model) {
    // A constant step: the motions are the same, brackets and forms are multiplied by constants.
    auto const m = draw_motion<S>(draw, group);
    S const h = ratio<S>(1, 7);
    auto const average = [&](auto const& f) { return decltype(m.l(f))(m.l(f) / h); };
    claim.zero("the same motion", model, euler_poincare_right(average, m.f[0], m.f[1]), S(momenta_of(m.l, m.f) / Base<S>(h)), 10);
    Matrix<S> const p = reduced_bivector_right(m.l, m.f[0]), q = reduced_bivector_right(average, m.f[0]), a = right_second_differential(m.l, m.f[0]);
    double const condition = to_double(row_norm(a) * row_norm(inverse_matrix(a)));
    claim.equal("the bracket is multiplied by h", model, q, Matrix<S>(p * h), condition);
    claim.equal("h D_1 of the average is D_1 of the action", model, h * right_differential(average, m.f[0]), right_differential(m.l, m.f[0]));
    claim.differs("D_1 of the average", model, right_differential(average, m.f[0]), right_differential(m.l, m.f[0]));
    // Steps of different lengths: the momentum handed over is that of the action.
    S const longer = ratio<S>(2, 7);
    auto const handed = [&](S const& first, S const& second) { return first * left_differential(average, m.f[0]) - second * right_differential(average, m.f[1]); };
    claim.zero("steps h and h: what one leaves the next takes up", model, handed(h, h), momenta_of(m.l, m.f), 10);
    claim.refutes("steps h and 2h, the same average", model, handed(h, longer), momenta_of(m.l, m.f));
  });
  if constexpr (fits_orders<S>)
    for (auto const& group : limit_groups()) {
      auto const top = draw_top_without_weight<S>(draw, group);
      State<SpannedGroup, S> const v{draw.template element<S>(group), draw.template velocity<S>(group)};
      auto const exact = momentum_of(top, top.flow(v, S(by_halves.duration)).first);
      // Steps of 2/3 and 4/3 of the mean in turn. Averages l_h/h: with the factor h the momentum is matched, without it -R*l'/h.
      auto const run = [&](int n, double h, bool with_factor) {
        auto mu = momentum_of(top, v);
        auto f = exp(S(-h) * v.velocity);
        double before = 0;
        for (int k = 0; k < n; ++k) {
          double const step = k % 2 == 0 ? 2 * h / 3 : 4 * h / 3;
          auto const l = natural_chart_lagrangian_right(reduced(top), step);
          if (!with_factor && k > 0) mu = S(step / before) * mu;  // what D_2 of one average leaves is taken up by D_1 of the other
          f = relative_motion_from_momentum_right(l, mu, k == 0 ? exp(S(-step) * v.velocity) : f).value;
          mu = lie_poisson_update_right(f, mu);
          before = step;
        }
        return size_of(mu - exact);
      };
      claim.order("steps of two lengths in turn, with the factor", group.name(), by_halves.step_lengths(), by_halves.errors_of([&](int n, double h) { return run(n, h, true); }), 2);
      claim.refutes_order("without the factor", group.name(), by_halves.step_lengths(), by_halves.errors_of([&](int n, double h) { return run(n, h, false); }), 2);
    }
}
