// Section 3.2: the discrete Euler-Poincare and Lie-Poisson algorithms. Compiled once per scalar.
#include "actio/reduction/discrete_lie_poisson.hpp"
#include "actio/reduction/discrete_poisson.hpp"
#include "models.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

STATEMENT(eq_3_10, "discrete Euler-Poincare equations, right-invariant case") {
  claim.holds();
  claim.degree(400);
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const l = draw_group_polynomial<S>(draw, group);
    auto const g0 = draw.template element<S>(group, S(1)), g1 = draw.template element<S>(group, S(1)), g2 = draw.template element<S>(group, S(1));
    auto const f01 = relative_motion_right(g0, g1), f12 = relative_motion_right(g1, g2);

    // Off shell: whatever the places, (3.10) is (3.2) of the lifted Lagrangian.
    auto const full = discrete_euler_lagrange(lift_right(l), g0, g1, g2);
    claim.equal("(3.10) equals (3.2) of the invariant Lagrangian", model, euler_poincare_right(l, f01, f12), full);
    // Control: the two translations exchanged.
    claim.differs("left and right translation exchanged", model, left_differential(l, f12) - right_differential(l, f01), full);
  });
}

STATEMENT(thm_3_2_3, "a lifted motion of the reduced equations is a motion of the full ones") {
  claim.holds();
  claim.degree(600);
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const f01 = draw.template element<S>(group, ratio<S>(1, 2)), f12 = draw.template element<S>(group, ratio<S>(1, 2));
    auto const l = with_motion_right(draw_group_polynomial<S>(draw, group), f01, f12, draw);
    auto const scale = size_of(left_differential(l, f01));
    claim.zero("(3.10) along the reduced motion", model, euler_poincare_right(l, f01, f12), scale);

    // Lift: each place follows from the one before and the relative motion.
    auto const g0 = draw.template element<S>(group, S(1));
    auto const g1 = reconstruct_right(g0, f01), g2 = reconstruct_right(g1, f12);
    claim.zero("(3.2) along the lifted motion", model, discrete_euler_lagrange(lift_right(l), g0, g1, g2), scale);
    // Control: the last place lifted by f instead of its inverse.
    claim.refutes("lift by f instead of its inverse", model, discrete_euler_lagrange(lift_right(l), g0, g1, f12 * g1), scale);
  });
}
