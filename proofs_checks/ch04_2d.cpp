// Section 4.2, fourth part: the square that joins the dynamics on the group and on the dual algebra. Compiled once per scalar.
//
// Degrees: as in ch04_2a.cpp; an inverted matrix of second derivatives, of up to 9 rows with entries of degree below 60, brings it below 4000. The bounds say so.
#include "actio/groupoid/hamilton_jacobi.hpp"
#include "actio/variational/lie_poisson.hpp"
#include "sequences.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

/// The groups of the square.
std::vector<SpannedGroup> const& square_groups() {
  static std::vector<SpannedGroup> const groups = {spanned("SO(3)", SO<3>{}), spanned("SO(4)", SO<4>{}), spanned("SE(3)", SE<3>{}),
                                                   spanned("Aff(1)", Aff1{}), spanned_su2(),             spanned("GL(3)", GL<3>{})};
  return groups;
}

}  // namespace

STATEMENT(eq_4_5, "the square of group and dual-algebra dynamics") {
  claim.convention("Sigma takes f_{k,k-1} to f_{k+1,k} by (3.11); of the two the later one is the first factor of the product that Definition 4.1.1 holds fixed. Either sign of the Legendre map will do.");
  claim.degree(4000);
  over_groups(square_groups(), claim, [&](auto const& group, auto const& model) {
    int const d = group.dimension();
    auto const f = draw_places<S>(draw, group, 2);
    auto const l = with_motions_left(draw_reduced_lagrangian<S>(draw, group), f);
    auto const down = [&](Place<S> const& x) { return momentum_system_left(l, x).first; };
    auto const pi = down(f[0]);
    auto const scale = momenta_of(l, f);
    // f[0] solves the first line for pi; Lambda carries pi by it. Condition: a place is inverted.
    claim.zero("F l o Sigma = Lambda o F l", model, down(f[1]) - coadjoint(inverse(f[0]), pi), scale, 10);

    // Tangents. Of Sigma from the equation; of Lambda by moving pi and the f that solves for it.
    Matrix<S> const down0 = left_second_differential(l, f[0]), down1 = left_second_differential(l, f[1]);
    Matrix<S> const sigma = euler_poincare_tangent_left(l, f[0], f[1]), solved = inverse_matrix(down0);
    Matrix<S> lambda = Ad_matrix(inverse(f[0])).transpose();
    for (int a = 0; a < d; ++a) {
      auto const theta = velocity(group, Vector<S>(solved.col(a)));
      lambda.col(a) += rate(Ad_star(inverse(varied(f[0], from_left(theta, f[0]))), over<Dual<S>>(pi)));
    }
    // Condition: matrices of second derivatives are inverted.
    claim.zero("tangents: T F l o T Sigma = T Lambda o T F l", model, Matrix<S>(down1 * sigma - lambda * down0), S(magnitude(down1) * magnitude(sigma) + magnitude(lambda) * magnitude(down0)), 100);
    auto const image = coadjoint(inverse(f[0]), pi);
    claim.zero("Lambda is a Poisson map", model, Matrix<S>(lambda * lie_poisson_tensor_plus(pi) * lambda.transpose() - lie_poisson_tensor_plus(image)),
               S(magnitude(lambda) * magnitude(lambda) * size_of(pi) + size_of(image)), 100);

    // Controls: the arrows of Sigma reversed; the other Legendre map; Lambda without its inverse; a relative motion that (3.11) does not give.
    claim.refutes("Sigma the other way round", model, down(f[0]) - final_momentum_left(f[1], down(f[1])), scale);
    claim.refutes("F l by R*", model, right_differential(l, f[1]) - final_momentum_left(f[0], right_differential(l, f[0])), scale);
    claim.refutes("Lambda by Ad*_f", model, down(f[1]) - Ad_star(f[0], pi), scale);
    claim.refutes("off a motion", model, several([&] { return column(down(draw.template element<S>(group)) - image); }), scale);
  });
  if constexpr (Real<S>)
    for (auto const& group : square_groups()) {
      // Both ways with solvers: a step on the group; a step on the dual, its relative motion looked for from elsewhere.
      auto const l = draw_group_polynomial<S>(draw, group);
      auto const f = draw.template element<S>(group, ratio<S>(1, 16));
      auto const pi = momentum_system_left(l, f).first;
      auto const next = step_euler_poincare_left(l, f).value;
      auto const elsewhere = f * draw.template element<S>(group, ratio<S>(1, 32));
      auto const step = hamilton_jacobi_step_left(l, -pi, elsewhere);
      // Condition: a solver stops at 16 roundings of its unknown.
      claim.equal("with solvers", group.name(), momentum_system_left(l, next).first, -step.final, 100);
      claim.differs("with solvers, no step", group.name(), momentum_system_left(l, next).first, pi, 1e-4);
    }
}
