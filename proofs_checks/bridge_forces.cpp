// Forces in discrete mechanics: the discrete Lagrange-d'Alembert equations, reduced and not, what a force
// adds to the momentum of the symmetry, and damping in proportion to the momentum.
#include "actio/reduction/discrete_force.hpp"
#include "actio/reduction/discrete_lie_poisson.hpp"
#include "actio/variational/lie_poisson.hpp"
#include "models/sequences.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

/// A covector that is a function of relative motions: a random function for each component.
template <class S>
struct RandomCovector {
  SpannedGroup group;
  std::vector<decltype(draw_reduced_lagrangian<S>(std::declval<Draw&>(), std::declval<SpannedGroup>()))>
      parts;

  RandomCovector(Draw& draw, SpannedGroup const& of) : group(of) {
    for (int a = 0; a < group.dimension(); ++a) parts.push_back(draw_reduced_lagrangian<S>(draw, group));
  }
  template <class T>
  Momentum<SpannedGroup, T> operator()(GroupElement<T> const& f) const {
    Vector<T> out(group.dimension());
    for (int a = 0; a < group.dimension(); ++a) out[a] = parts[a](f);
    return momentum(group, out);
  }
};

}  // namespace

STATEMENT(bridge_forced_reduction, "discrete equations with a force, on pairs and reduced") {
  claim.holds(
      "For any invariant discrete Lagrangian, any equivariant force at both ends of a step, and any "
      "configurations: the residuals are equal, so the one equation holds exactly if the other does, and "
      "configurations are found again from relative motions. The momentum of the symmetry changes by the "
      "force at the configuration in between, less the residual.");
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const l = draw_reduced_lagrangian<S>(draw, group);
    RandomCovector<S> const start(draw, group), end(draw, group);
    auto const g = draw_configurations<S>(draw, group, 4);

    // Right-invariant: covectors in space.
    auto const f01 = relative_motion_right(g[0], g[1]), f12 = relative_motion_right(g[1], g[2]);
    DiscreteForce const reduced{start, end};
    auto const on_pairs = [&](auto const& of) {
      return [&of](auto const& a, auto const& b) { return of(relative_motion_right(a, b)); };
    };
    DiscreteForce const force{on_pairs(start), on_pairs(end)};
    auto const residual = forced_euler_lagrange(lifted(l), force, g[0], g[1], g[2]);
    auto const scale = S(magnitude(D2(lifted(l), g[0], g[1]).components) + magnitude(start(f12).components) +
                         magnitude(end(f01).components));
    claim.zero("right-invariant: the residuals on pairs and reduced", model,
               Vector<S>((residual - forced_euler_poincare_right(l, reduced, f01, f12)).components), scale,
               10);
    claim.zero(
        "the same at configurations that are translated", model,
        Vector<S>((residual - forced_euler_lagrange(lifted(l), force, g[0] * g[3], g[1] * g[3], g[2] * g[3]))
                      .components),
        scale, 100);
    // Control: a force that is constant in the body is not equivariant here.
    auto const in_the_body = [&](auto const& of) {
      return [&of](auto const& a, auto const& b) {
        return Ad_star(inverse(a), of(relative_motion_right(a, b)));
      };
    };
    DiscreteForce const body_force{in_the_body(start), in_the_body(end)};
    claim.refutes("a force that is fixed in the body", model,
                  Vector<S>((forced_euler_lagrange(lifted(l), body_force, g[0], g[1], g[2]) -
                             forced_euler_poincare_right(l, reduced, f01, f12))
                                .components),
                  scale);

    // What the force adds to the momentum of translations on the right. The momentum is a rate of the
    // Lagrangian on pairs; neither its differentials nor the equations take part.
    auto const zeta = draw.template velocity<S>(group);
    auto const nudge = [&](auto const& at) { return varied(at, from_right(at, zeta)); };
    auto const constant = [](auto const& at) { return over<Dual<S>>(at); };
    auto const momentum_at_end = [&](auto const& a, auto const& b) {
      return S(lifted(l)(constant(a), nudge(b)).part[0]);
    };
    auto const momentum_at_start = [&](auto const& a, auto const& b) {
      return S(-lifted(l)(nudge(a), constant(b)).part[0]);
    };
    S const size = S(magnitude(Ad(g[1], zeta).coordinates) * scale + S(1));
    claim.zero("the momentum is one along a step", model,
               S(momentum_at_end(g[0], g[1]) - momentum_at_start(g[0], g[1])), size, 100);
    S const changed = S(momentum_at_end(g[1], g[2]) - momentum_at_end(g[0], g[1]));
    auto const added = [&](auto const& what) { return S(pair(what, Ad(g[1], zeta))); };
    claim.zero("from step to step it changes by both forces at the configuration in between", model,
               S(changed - added(end(f01) + start(f12) - residual)), size, 100);
    claim.refutes("by the force of the step after alone", model, S(changed - added(start(f12) - residual)),
                  size);

    // Left-invariant: covectors in the body.
    auto const left = lift_left(l);
    auto const f10 = relative_motion_left(g[0], g[1]), f21 = relative_motion_left(g[1], g[2]);
    auto const in_space = [&](auto const& of, auto const& at) { return Ad_star(inverse(at), of); };
    DiscreteForce const left_force{
        [&](auto const& a, auto const& b) { return in_space(start(relative_motion_left(a, b)), a); },
        [&](auto const& a, auto const& b) { return in_space(end(relative_motion_left(a, b)), b); }};
    auto const left_residual = Ad_star(g[1], forced_euler_lagrange(left, left_force, g[0], g[1], g[2]));
    claim.zero("left-invariant: the residuals on pairs and reduced", model,
               Vector<S>((left_residual - forced_euler_poincare_left(l, reduced, f10, f21)).components),
               scale, 100);
    claim.refutes(
        "the forces of the two ends exchanged", model,
        Vector<S>(
            (left_residual - forced_euler_poincare_left(l, DiscreteForce{end, start}, f10, f21)).components),
        scale);
  });
}

STATEMENT(bridge_damped_bracket,
          "half a decay, a free step, half a decay: the bracket contracts by the decay") {
  claim.holds(
      "With $r$ for the decay over half of a step: $r^2\\{F,H\\}$ at the end is the bracket of $F$ and $H$, "
      "carried back to the start, for any regular discrete Lagrangian. So every Casimir of degree $d$ is "
      "multiplied by $r^{2d}$.");
  over_groups(groups_for_sequences<S>(), claim, [&](auto const& group, auto const& model) {
    auto const l = draw_reduced_lagrangian<S>(draw, group);
    auto const f = draw.template element<S>(group);
    S const r = ratio<S>(3, 4);
    // The free step takes -R* l' to -L* l'; both as functions of the relative motion.
    auto const free_start = -right_differential(l, f), free_end = -left_differential(l, f);
    Matrix<S> const tangent =
        S(r * r) * Matrix<S>(Matrix<S>(left_second_differential(l, f)) *
                             inverse_matrix(Matrix<S>(right_second_differential(l, f)), "start of the step"));
    auto const damped_start = (S(1) / r) * free_start, damped_end = r * free_end;
    Matrix<S> const carried = tangent * lie_poisson_tensor_plus(damped_start) * tangent.transpose();
    S const size = S(magnitude(carried) + magnitude(lie_poisson_tensor_plus(damped_end)));
    // Condition: two inverses of the same matrix.
    claim.zero("the bracket at the end, times the decay of a step", model,
               Matrix<S>(carried - S(r * r) * lie_poisson_tensor_plus(damped_end)), size, 1000);
    claim.refutes("the bracket as it was", model, Matrix<S>(carried - lie_poisson_tensor_plus(damped_end)),
                  size);
  });
}
