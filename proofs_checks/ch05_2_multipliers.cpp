// Section 5.2, second part: attitudes held on the group by multipliers, the equation of motion with them and
// without.
//
// Off the motions every equation here is an identity between its residual and that of another; motions are
// constructed (bodies.hpp). How (5.7) approaches the flow of the body is seen against its Taylor series
// (body_flow.hpp).

#include "actio/reduction/discrete_euler_lagrange.hpp"
#include "actio/reduction/discrete_euler_poincare.hpp"
#include "actio/rigid_body/moser_veselov.hpp"
#include "actio/rigid_body/multiplier.hpp"

#include "models/bodies.hpp"
#include "models/moser_veselov_runs.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

template <class S>
Matrix<S> symmetric_half(Matrix<S> const& m) { return (m + m.transpose()) / S(2); }
template <class S>
Matrix<S> skew_half(Matrix<S> const& m) { return (m - m.transpose()) / S(2); }
template <class S>
Matrix<Dual<S>> fixed(Matrix<S> const& m) { return m.template cast<Dual<S>>(); }
/// How the constrained action of three configurations changes with the middle one: dual numbers on (5.6), the
/// definition.
template <class S>
S slope_of_action(Matrix<S> const& lambda, Matrix<S> const& before, Matrix<S> const& at,
                  Matrix<S> const& after, Matrix<S> const& multiplier, Matrix<S> const& change) {
  auto const l = fixed(lambda), m = fixed(multiplier);
  return constrained_action(l, {fixed(before), varying(at, change), fixed(after)}, {m, m, m}).part[0];
}
/// The components of a matrix in the basis of the algebra: \f$\mathrm{Tr}(e_a^TM)\f$.
template <class S>
Vector<S> components(SpannedGroup const& group, Matrix<S> const& m) {
  Vector<S> v(group.dimension());
  for (int a = 0; a < v.size(); ++a)
    v[a] = contract(Matrix<S>(group.hat(basis_velocity<S>(group, a).coordinates)), m);
  return v;
}
/// \f$\ell'(f)\cdot v = \mathrm{Tr}(v\Lambda)\f$, for any matrix v.
template <class S>
S slope_of_trace(Matrix<S> const& lambda, Matrix<S> const& v) { return Matrix<S>(v * lambda).trace(); }
/// Size of the terms of the equations at a configuration.
template <class S>
S pull_of(Matrix<S> const& lambda) { return S(magnitude(lambda)) * static_cast<int>(lambda.rows()); }

}  // namespace

STATEMENT(claim_5_2_skew_multiplier, "skew part of the matrix multiplier") {
  claim.holds(
      "It contributes nothing anywhere, on the group or off it, and no equation determines "
      "it: it may be taken to be zero.");
  over_groups(rotation_groups(), claim, [&](auto const& group, auto const& model) {
    int const n = group.matrix_size();
    auto const lambda = draw_second_moments<S>(draw, n);
    auto const any = [&] { return draw_matrix<S>(draw, n, n); };
    std::vector<Matrix<S>> const g = {any(), any(), any()}, multipliers = {any(), any(), any()};
    std::vector<Matrix<S>> halves;
    for (auto const& m : multipliers) halves.push_back(symmetric_half(m));
    S const action = constrained_action(lambda, g, multipliers), scale = pull_of(lambda) * n;
    claim.zero("the constraint is symmetric", model,
               Matrix<S>(orthogonality(g[0]) - orthogonality(g[0]).transpose()), S(1));
    claim.zero("the action with lambda and with its symmetric part", model,
               S(action - constrained_action(lambda, g, halves)), scale);
    auto const change = any();
    S const slope = slope_of_action(lambda, g[0], g[1], g[2], multipliers[1], change);
    claim.zero("and its slope", model,
               S(slope - slope_of_action(lambda, g[0], g[1], g[2], halves[1], change)), scale);
    claim.zero("the equation has the symmetric part", model,
               S(slope - contract(change, constrained_stationarity(lambda, g[0], g[1], g[2], halves[1]))),
               scale);
    // Controls: a constraint that is not symmetric, g M g^T - 1; the symmetric part itself; the equation
    // written with the whole of lambda.
    auto const m = any();
    Matrix<S> bent = g[0] * m * g[0].transpose();
    bent.diagonal().array() -= S(1);
    // One number may be small by chance: a lower floor.
    claim.refutes("a constraint that is not symmetric", model, trace_of(skew_half(multipliers[0]), bent),
                  magnitude(bent), 1e-5);
    claim.differs("the symmetric part left out", model, action,
                  constrained_action(lambda, g, std::vector<Matrix<S>>(3, Matrix<S>(Matrix<S>::Zero(n, n)))),
                  1e-5);
    claim.refutes("lambda g with its skew part", model, Matrix<S>(skew_half(multipliers[1]) * g[1]),
                  magnitude(Matrix<S>(multipliers[1] * g[1])));
  });
}

STATEMENT(eq_5_6, "constrained discrete action with matrix multipliers") {
  claim.holds(
      "For the scaled Lagrangian, without the factor $-1/h^2$. Its stationary sequences, the "
      "configurations varied over all matrices, are those of the unconstrained sum varied over the "
      "group; each has one symmetric multiplier at each configuration, $\\lambda_k = "
      "(g_{k+1}+g_{k-1})\\Lambda g_k^T$.");
  over_groups(rotation_groups(), claim, [&](auto const& group, auto const& model) {
    int const n = group.matrix_size();
    // Off the group: the gradient, in all entries, of a sum over four configurations.
    auto const lambda = draw_second_moments<S>(draw, n);
    auto const any = [&] { return draw_matrix<S>(draw, n, n); };
    std::vector<Matrix<S>> const g = {any(), any(), any(), any()};
    std::vector<Matrix<S>> multipliers;
    for (int k = 0; k < 4; ++k) multipliers.push_back(draw_symmetric<S>(draw, n));
    std::vector<Matrix<Dual<S>>> moving, held;
    std::vector<Matrix<S>> change;
    for (int k = 0; k < 4; ++k) {
      change.push_back(k == 0 || k == 3 ? Matrix<S>(Matrix<S>::Zero(n, n)) : any());
      moving.push_back(varying(g[k], change[k])), held.push_back(fixed(multipliers[k]));
    }
    S const slope = constrained_action(fixed(lambda), moving, held).part[0];
    auto const terms = [&](std::vector<Matrix<S>> const& lambdas) {
      S sum(0);
      for (int k = 1; k < 3; ++k)
        sum += contract(change[k], constrained_stationarity(lambda, g[k - 1], g[k], g[k + 1], lambdas[k]));
      return sum;
    };
    S const scale = pull_of(lambda) * n * n;
    claim.zero("slope of the action: g_k+1 Lambda + g_k-1 Lambda - lambda_k g_k", model,
               S(slope - terms(multipliers)), scale);
    auto doubled = multipliers, shifted = multipliers;
    for (auto& m : doubled) m *= S(2);
    std::swap(shifted[1], shifted[2]);
    claim.refutes("the constraint without its factor 1/2", model, S(slope - terms(doubled)), scale, 1e-5);
    claim.refutes("multipliers of the wrong configurations", model, S(slope - terms(shifted)), scale, 1e-5);

    // On the group: the residual of the equations of the unconstrained sum is the skew half of the would-be
    // multiplier.
    auto const configuration = [&] { return draw.template element<S>(group); };
    auto const g0 = configuration(), g1 = configuration(), g2 = configuration();
    Matrix<S> const pull = (g2.value + g0.value) * lambda * g1.value.transpose();
    claim.zero("on the group: the discrete Euler-Lagrange equations", model,
               Vector<S>(discrete_euler_lagrange(ScaledTrace<S>{lambda}, g0, g1, g2).components -
                         components(group, pull)),
               pull_of(lambda));
    Matrix<S> const best = spatial_multiplier(lambda, g0.value, g1.value, g2.value);
    claim.equal("the multiplier that comes nearest leaves the skew half", model,
                constrained_stationarity(lambda, g0.value, g1.value, g2.value, best),
                Matrix<S>(skew_half(pull) * g1.value));
    claim.refutes("off a motion: no symmetric multiplier", model,
                  constrained_stationarity(lambda, g0.value, g1.value, g2.value, best), pull_of(lambda));

    // Along a motion.
    auto const m = draw_body_motion<S>(draw, group);
    Matrix<S> const multiplier = spatial_multiplier(m.lambda, m.before, m.at, m.after);
    // Condition: Lambda comes from normal equations, refined until the residual is rounding of their terms.
    claim.zero("along a motion: stationary among all matrices", model,
               constrained_stationarity(m.lambda, m.before, m.at, m.after, multiplier), pull_of(m.lambda),
               10);
    claim.zero("and on the constraint", model, orthogonality(m.at), S(1));
    claim.refutes("the multiplier with the other sign", model,
                  constrained_stationarity(m.lambda, m.before, m.at, m.after, Matrix<S>(-multiplier)),
                  pull_of(m.lambda));
    Matrix<S> const exchanged = spatial_multiplier(m.lambda, m.at, m.before, m.after);
    claim.refutes("two configurations exchanged", model,
                  constrained_stationarity(m.lambda, m.at, m.before, m.after, exchanged), pull_of(m.lambda));
    claim.template refuses<OutsideDomain>("Lambda not symmetric", model,
                                          [&] { constrained_action(any(), g, multipliers); });
  });
}

STATEMENT(claim_5_2_conjugate_multiplier, "multiplier conjugated by group elements") {
  claim.corrected(
      R"(\bar\lambda_k = g^T\lambda_k g \text{ for all } g \in G)",
      R"(\bar\lambda_k = g_k^T)"
      R"(\lambda_k g_k)",
      "With one element, the configuration itself: the multiplier in the body frame. All conjugates of "
      "$\\lambda_k$ are symmetric, but only this one is in the reduced equation, and they are all the same "
      "only where $\\lambda_k$ is a multiple of the identity. Left multiplication takes the constraint to "
      "its conjugate and $\\lambda_k$ with it; $\\bar\\lambda_k$ stays.");
  over_groups(rotation_groups(), claim, [&](auto const& group, auto const& model) {
    int const n = group.matrix_size();
    auto const k = draw_rotation<S>(draw, group), g = draw_rotation<S>(draw, group);
    auto const any = draw_matrix<S>(draw, n, n), multiplier = draw_symmetric<S>(draw, n);
    claim.equal("Phi(k g) = k Phi(g) k^T, on the group or off it", model, orthogonality(Matrix<S>(k * any)),
                Matrix<S>(k * orthogonality(any) * k.transpose()));
    claim.equal("any conjugate is symmetric", model, body_multiplier(k, multiplier),
                Matrix<S>(body_multiplier(k, multiplier).transpose()));
    // The constraint term along g theta, theta any matrix.
    auto const theta = draw_matrix<S>(draw, n, n);
    S const slope = trace_of(fixed(multiplier), orthogonality(varying(g, Matrix<S>(g * theta)))).part[0] / 2;
    claim.zero("Tr(lambda Phi)/2 along g theta: Tr(lambda-bar theta)", model,
               S(slope - trace_of(body_multiplier(g, multiplier), theta)), S(n * n));
    auto const m = draw_body_motion<S>(draw, group);
    Matrix<S> const lambda_k = spatial_multiplier(m.lambda, m.before, m.at, m.after),
                    body = body_multiplier(m.at, lambda_k);
    Matrix<S> const moved =
        spatial_multiplier(m.lambda, Matrix<S>(k * m.before), Matrix<S>(k * m.at), Matrix<S>(k * m.after));
    claim.zero("g_k^T lambda_k g_k is the multiplier of the reduced equation", model,
               euler_poincare_with_multiplier(m.lambda, m.f10, m.f21, body), pull_of(m.lambda), 10);
    claim.zero("all configurations multiplied by k: lambda goes to k lambda k^T", model,
               Matrix<S>(moved - k * lambda_k * k.transpose()), pull_of(m.lambda), 10);
    claim.zero("and lambda-bar stays", model, Matrix<S>(body_multiplier(Matrix<S>(k * m.at), moved) - body),
               pull_of(m.lambda), 10);
    // Controls: other elements of the group, as printed; lambda itself.
    claim.refutes("g^T lambda_k g with another g, as printed", model,
                  euler_poincare_with_multiplier(m.lambda, m.f10, m.f21, body_multiplier(g, lambda_k)),
                  pull_of(m.lambda));
    claim.refutes("with the configuration after", model,
                  euler_poincare_with_multiplier(m.lambda, m.f10, m.f21, body_multiplier(m.after, lambda_k)),
                  pull_of(m.lambda));
    claim.refutes("lambda_k as it is", model,
                  euler_poincare_with_multiplier(m.lambda, m.f10, m.f21, lambda_k), pull_of(m.lambda));
    claim.refutes(
        "g_k lambda_k g_k^T", model,
        euler_poincare_with_multiplier(m.lambda, m.f10, m.f21, Matrix<S>(m.at * lambda_k * m.at.transpose())),
        pull_of(m.lambda));
  });
}

STATEMENT(claim_5_2_operator_equation, "operator equation from varying the constrained reduced action") {
  claim.corrected(
      R"(-\ell'(f_{kk-1})TR_{f_{kk-1}} + \ell'(f_{k+1k})\mathrm{Ad}_{f_{k+1k}}TR_{f_{k+1k}} = )"
      R"(\bar\lambda_k)",
      R"(\ell'(f_{kk-1})TR_{f_{kk-1}}\vartheta_k^T + \ell'(f_{k+1k})TR_{f_{k+1k}})"
      R"(\mathrm{Ad}_{f_{k+1k}}\vartheta_k = \mathrm{Tr}(\bar\lambda_k\vartheta_k))",
      "For skew $\\vartheta_k$ the two are the same, both multipliers drop out, and (3.11) remains. But a "
      "multiplier is there so that $\\vartheta_k = g_k^T\\delta g_k$ may be any matrix, and then (5.6), "
      "where $f_{kk-1} = g_k^Tg_{k-1}$, has $\\vartheta_k^T$ in place of $-\\vartheta_k$; only so does the "
      "next equation follow. With inverses in place of transposes the printed operators stand, but for "
      "another multiplier, $\\Lambda f_{k+1k} - f_{kk-1}\\Lambda$. $\\Ad$ comes before $TR$, which leaves "
      "the algebra; as products of matrices either order gives $f\\vartheta$.");
  over_groups(rotation_groups(), claim, [&](auto const& group, auto const& model) {
    int const n = group.matrix_size();
    auto const corrected = [&](Matrix<S> const& lambda, Matrix<S> const& f10, Matrix<S> const& f21,
                               Matrix<S> const& theta) {
      return S(slope_of_trace(lambda, Matrix<S>(theta.transpose() * f10)) +
               slope_of_trace(lambda, Matrix<S>(f21 * theta * f21.transpose() * f21)));
    };
    auto const printed = [&](Matrix<S> const& lambda, Matrix<S> const& f10, Matrix<S> const& f21,
                             Matrix<S> const& theta) {
      return S(-slope_of_trace(lambda, Matrix<S>(theta * f10)) +
               slope_of_trace(lambda, Matrix<S>(f21 * (theta * f21) * f21.transpose())));
    };
    // Off the motions: both sides are the slope of (5.6) along g theta.
    auto const lambda = draw_second_moments<S>(draw, n);
    auto const g0 = draw_rotation<S>(draw, group), g1 = draw_rotation<S>(draw, group),
               g2 = draw_rotation<S>(draw, group);
    Matrix<S> const f10 = g1.transpose() * g0, f21 = g2.transpose() * g1;
    auto const multiplier = draw_symmetric<S>(draw, n), body = body_multiplier(g1, multiplier);
    auto const theta = draw_matrix<S>(draw, n, n), skew = draw_skew<S>(draw, group);
    S const slope = slope_of_action(lambda, g0, g1, g2, multiplier, Matrix<S>(g1 * theta)),
            scale = (pull_of(lambda) + pull_of(multiplier)) * n;
    claim.zero("the constrained action along g theta, any theta: corrected", model,
               S(corrected(lambda, f10, f21, theta) - trace_of(body, theta) - slope), scale);
    S const skew_slope = slope_of_action(lambda, g0, g1, g2, multiplier, Matrix<S>(g1 * skew));
    claim.zero("skew theta: as printed", model,
               S(printed(lambda, f10, f21, skew) - trace_of(body, skew) - skew_slope), scale);
    claim.zero("skew theta: no multiplier", model, trace_of(body, skew), scale);
    // And (3.11).
    Element<SpannedGroup, S> const before{group, f10}, after{group, f21};
    auto const reduced = euler_poincare_left(ScaledTrace<S>{lambda}, before, after);
    Vector<S> on_basis(group.dimension());
    for (int a = 0; a < on_basis.size(); ++a)
      on_basis[a] = printed(lambda, f10, f21, Matrix<S>(group.hat(basis_velocity<S>(group, a).coordinates)));
    claim.zero("skew theta: (3.11)", model, Vector<S>(on_basis - reduced.components), pull_of(lambda));
    // Controls: as printed, any theta; the sides of Ad and of the first term.
    claim.refutes("any theta, as printed", model,
                  S(printed(lambda, f10, f21, theta) - trace_of(body, theta) - slope), scale, 1e-5);
    Matrix<S> other(group.dimension(), 2);
    for (int a = 0; a < other.rows(); ++a) {
      Matrix<S> const e = group.hat(basis_velocity<S>(group, a).coordinates);
      other(a, 0) = -slope_of_trace(lambda, Matrix<S>(e * f10)) + slope_of_trace(lambda, Matrix<S>(e * f21));
      other(a, 1) = -slope_of_trace(lambda, Matrix<S>(f10 * e)) + slope_of_trace(lambda, Matrix<S>(f21 * e));
    }
    claim.refutes("without Ad", model, Vector<S>(other.col(0) - reduced.components), pull_of(lambda));
    claim.refutes("with Ad in both terms", model, Vector<S>(other.col(1) - reduced.components),
                  pull_of(lambda));

    // Along a motion the equation holds for any theta; as printed, not with the multiplier that the next
    // equation has.
    auto const m = draw_body_motion<S>(draw, group);
    Matrix<S> const held = body_multiplier(m.at, spatial_multiplier(m.lambda, m.before, m.at, m.after));
    claim.zero("along a motion, any theta: corrected", model,
               S(corrected(m.lambda, m.f10, m.f21, theta) - trace_of(held, theta)), pull_of(m.lambda) * n,
               10);
    claim.zero("along a motion, skew theta: as printed", model,
               S(printed(m.lambda, m.f10, m.f21, skew) - trace_of(held, skew)), pull_of(m.lambda) * n, 10);
    Matrix<S> const other_held = m.lambda * m.f21 - m.f10 * m.lambda;
    claim.zero("along a motion, any theta, f with inverses: as printed", model,
               S(printed(m.lambda, m.f10, m.f21, theta) - trace_of(other_held, theta)), pull_of(m.lambda) * n,
               10);
    claim.zero("and that multiplier is symmetric", model, Matrix<S>(other_held - other_held.transpose()),
               pull_of(m.lambda), 10);
    claim.refutes("along a motion, any theta: as printed", model,
                  S(printed(m.lambda, m.f10, m.f21, theta) - trace_of(held, theta)), pull_of(m.lambda) * n,
                  1e-5);
  });
}

STATEMENT(claim_5_2_dep_with_multiplier, "reduced equation with the symmetric multiplier") {
  claim.holds("It is the slope of (5.6) along $g_k\\vartheta_k$ for all matrices $\\vartheta_k$.");
  over_groups(rotation_groups(), claim, [&](auto const& group, auto const& model) {
    int const n = group.matrix_size();
    auto const lambda = draw_second_moments<S>(draw, n);
    auto const g0 = draw_rotation<S>(draw, group), g1 = draw_rotation<S>(draw, group),
               g2 = draw_rotation<S>(draw, group);
    Matrix<S> const f10 = g1.transpose() * g0, f21 = g2.transpose() * g1;
    auto const multiplier = draw_symmetric<S>(draw, n);
    Matrix<S> const body = body_multiplier(g1, multiplier),
                    left = euler_poincare_with_multiplier(lambda, f10, f21, body);
    auto const gradient = [&](Matrix<S> const& held) {
      Matrix<S> slopes(n, n);
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          Matrix<S> unit = Matrix<S>::Zero(n, n);
          unit(i, j) = S(1);
          slopes(i, j) = slope_of_action(lambda, g0, g1, g2, held, Matrix<S>(g1 * unit));
        }
      return slopes;
    };
    S const scale = pull_of(lambda) + pull_of(multiplier);
    Matrix<S> const slopes = gradient(multiplier);
    claim.zero("the residual is the derivative of the action, entry by entry", model,
               Matrix<S>(slopes - left), scale);
    claim.zero("in the spatial frame: g_k+1 Lambda + g_k-1 Lambda - lambda_k g_k", model,
               Matrix<S>(g1 * left - constrained_stationarity(lambda, g0, g1, g2, multiplier)), scale);
    // Controls: sides of Lambda, signs, transposes.
    Matrix<S> const ft = f21.transpose(), f10t = f10.transpose();
    claim.refutes("Lambda f^T + f Lambda", model, Matrix<S>(slopes - (lambda * ft + f10 * lambda - body)),
                  scale);
    claim.refutes("f^T Lambda + Lambda f", model, Matrix<S>(slopes - (ft * lambda + lambda * f10 - body)),
                  scale);
    claim.refutes("f^T Lambda - f Lambda", model, Matrix<S>(slopes - (ft * lambda - f10 * lambda - body)),
                  scale);
    claim.refutes("transposes exchanged", model, Matrix<S>(slopes - (f21 * lambda + f10t * lambda - body)),
                  scale);
    auto const m = draw_body_motion<S>(draw, group);
    Matrix<S> const held = body_multiplier(m.at, spatial_multiplier(m.lambda, m.before, m.at, m.after)),
                    none = Matrix<S>::Zero(n, n);
    claim.zero("along a motion", model, euler_poincare_with_multiplier(m.lambda, m.f10, m.f21, held),
               pull_of(m.lambda), 10);
    claim.refutes("along a motion, without a multiplier", model,
                  euler_poincare_with_multiplier(m.lambda, m.f10, m.f21, none), pull_of(m.lambda));
    claim.refutes("along a motion, the two steps exchanged", model,
                  euler_poincare_with_multiplier(m.lambda, m.f21, m.f10, held), pull_of(m.lambda));
  });
}

STATEMENT(eq_5_7, "reduced algorithm on the rotation group without multiplier") {
  claim.holds(
      "It is (3.11) for $\\ell(f) = \\mathrm{Tr}(f\\Lambda)$. Solved for $f_{k+1k}$ from two "
      "attitudes of the body it approaches the flow of the body, forwards in time and to second "
      "order; solved for $f_{kk-1}$ it runs back.");
  over_groups(rotation_groups(), claim, [&](auto const& group, auto const& model) {
    int const n = group.matrix_size();
    auto const lambda = draw_second_moments<S>(draw, n);
    auto const f10 = draw_rotation<S>(draw, group), f21 = draw_rotation<S>(draw, group);
    auto const sides = [&](Matrix<S> const& l, Matrix<S> const& before, Matrix<S> const& after) {
      return Matrix<S>(after.transpose() * l - l * after - (l * before.transpose() - before * l));
    };
    Element<SpannedGroup, S> const before{group, f10}, after{group, f21};
    // Components are Tr(e_a^T M)/2 of the difference of the sides: it is skew, and (3.11) has one half of it.
    Vector<S> const reduced = euler_poincare_left(ScaledTrace<S>{lambda}, before, after).components;
    auto const in_basis = [&](Matrix<S> const& m) { return Vector<S>(components(group, m) / S(2)); };
    claim.zero("the residual of (5.7) is that of (3.11)", model,
               Vector<S>(in_basis(sides(lambda, f10, f21)) - reduced), pull_of(lambda));
    claim.zero("the library's, from the equation with a multiplier", model,
               Matrix<S>(euler_poincare_without_multiplier(lambda, f10, f21) - sides(lambda, f10, f21)),
               pull_of(lambda));
    // Controls: transposes, signs, the two steps.
    Matrix<S> const a = f10.transpose(), b = f21.transpose();
    claim.refutes("f in place of f^T", model, Vector<S>(in_basis(sides(lambda, a, b)) - reduced),
                  pull_of(lambda));
    claim.refutes("one of them only", model, Vector<S>(in_basis(sides(lambda, a, f21)) - reduced),
                  pull_of(lambda));
    claim.refutes(
        "a plus sign between the sides", model,
        Vector<S>(in_basis(Matrix<S>(b * lambda - lambda * f21 + (lambda * a - f10 * lambda))) - reduced),
        pull_of(lambda));
    claim.refutes("the two steps exchanged", model, Vector<S>(in_basis(sides(lambda, f21, f10)) - reduced),
                  pull_of(lambda));
    auto const m = draw_body_motion<S>(draw, group);
    claim.zero("along a motion", model, sides(m.lambda, m.f10, m.f21), pull_of(m.lambda), 10);
    claim.refutes("along a motion, the two steps exchanged", model, sides(m.lambda, m.f21, m.f10),
                  pull_of(m.lambda));
    claim.zero("back in time: the inverse motions, exchanged", model,
               sides(m.lambda, Matrix<S>(m.f21.transpose()), Matrix<S>(m.f10.transpose())), pull_of(m.lambda),
               10);
    claim.refutes("along a motion, f in place of f^T", model,
                  sides(m.lambda, Matrix<S>(m.f10.transpose()), Matrix<S>(m.f21.transpose())),
                  pull_of(m.lambda));
    if (!exact_arithmetic<S>()) {
      // The library's scheme: an action of energy times time, in coordinates.
      S const h = ratio<S>(3, 7);
      MoserVeselov<Dynamic, S> const scheme(inertia_from_lambda<Dynamic, S>(Vector<S>(lambda.diagonal())), h);
      SO<Dynamic> const& so = scheme.inertia().group;
      Vector<S> const left = scheme.residual({so, f10}, {so, f21}).components;
      claim.zero("the residual of the scheme of the library, times h", model,
                 Matrix<S>(so.hat(left) * h - sides(lambda, f10, f21)), pull_of(lambda));
    }
  });
  if (claim.fits_orders())
    over_bodies(claim, [&](int n, auto const& model) {
      // On the group alone, from two attitudes of the body itself.
      auto const body = draw_moving_body<S>(draw, n);
      auto const steps = in_half_a_unit.step_lengths();
      auto const onwards = errors_on_the_group(
          body, [](auto const& scheme, auto const& f) { return scheme.step_euler_poincare(f).value; });
      claim.order("solved for f21: attitude against the flow of the body", model, steps, onwards.attitude, 2);
      claim.order("solved for f21: momentum against the flow of the body", model, steps, onwards.momentum, 2);
      // The same equation solved for the other relative motion: the time-reversed map.
      auto const back = errors_on_the_group(body, [](auto const& scheme, auto const& f) {
        return inverse(scheme.step_euler_poincare(inverse(f)).value);
      });
      claim.refutes_order("solved for f10: attitude", model, steps, back.attitude, 2);
      claim.refutes_order("solved for f10: momentum", model, steps, back.momentum, 2);
    });
}
