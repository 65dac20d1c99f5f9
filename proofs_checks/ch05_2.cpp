// Section 5.2, first part: the trace Lagrangian and its discretisation.

#include "actio/reduction/discrete_euler_lagrange.hpp"
#include "actio/reduction/discrete_euler_poincare.hpp"
#include "actio/reduction/discrete_forms.hpp"
#include "actio/reduction/relative_motion.hpp"
#include "actio/rigid_body/moser_veselov.hpp"
#include "actio/rigid_body/multiplier.hpp"

#include "bodies.hpp"
#include "charts.hpp"
#include "generalized_bodies.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

/// A step that is no power of 2: a factor of it that is lost shows.
template <class S>
S step() { return ratio<S>(3, 7); }
/// \f$g_1^T(g_1 - g_0)/h\f$, (5.5).
template <class S>
Matrix<S> difference_at_end(Matrix<S> const& g0, Matrix<S> const& g1, S const& h) {
  return g1.transpose() * (g1 - g0) / h;
}
/// \f$g_0^T(g_1 - g_0)/h\f$.
template <class S>
Matrix<S> difference_at_start(Matrix<S> const& g0, Matrix<S> const& g1, S const& h) {
  return g0.transpose() * (g1 - g0) / h;
}
/// \f$\tfrac12\mathrm{Tr}(D^T\Lambda D)\f$: the Lagrangian with D in place of the velocity.
template <class S>
S half_trace(Matrix<S> const& lambda, Matrix<S> const& d) {
  return trace_of(d, Matrix<S>(lambda * d)) / S(2);
}
/// \f$\mathrm{Tr}(X\Lambda Y^T)\f$, the Lagrangian of Moser and Veselov for X, Y in this order.
template <class S>
S moser_veselov(Matrix<S> const& lambda, Matrix<S> const& x, Matrix<S> const& y) {
  return trace_of(Matrix<S>(x * lambda), y);
}
/// The twin on the other side, \f$\mathrm{Tr}(X^T\Lambda Y)\f$.
template <class S>
S other_side(Matrix<S> const& lambda, Matrix<S> const& x, Matrix<S> const& y) {
  return trace_of(x, Matrix<S>(lambda * y));
}
/// The curve's configuration and its body velocity at t.
template <class Curve, class S>
std::pair<Matrix<S>, Matrix<S>> place_and_body_velocity(Curve const& curve, S const& t) {
  Dual<S> time(t);
  time.part[0] = S(1);
  auto const moving_element = curve(time);
  Matrix<S> const g = matrix_values(moving_element.value);
  return {g, g.transpose() * matrix_rates(moving_element.value)};
}

}  // namespace

STATEMENT(claim_5_2_trace_lagrangian, "rigid body Lagrangian as a single trace") {
  claim.holds("For skew $\\xi$, where the two halves of the trace are the same.");
  over_groups(rotation_groups(), claim, [&](auto const& group, auto const& model) {
    int const n = group.matrix_size();
    auto const body = draw_point_masses<S>(draw, n);
    auto const xi = draw_skew<S>(draw, group), g = draw_rotation<S>(draw, group);
    Matrix<S> const lambda = body.second_moments();
    claim.equal("Tr(xi^T J xi)/4 = Tr(xi^T Lambda xi)/2", model, quarter_trace(lambda, xi),
                half_trace(lambda, xi));
    claim.equal("and the kinetic energy of the masses", model, half_trace(lambda, xi),
                body.kinetic_energy(Matrix<S>(g * xi)));
    // Controls: the factor; a matrix that is not skew.
    claim.differs("Tr(xi^T Lambda xi)/4", model, quarter_trace(lambda, xi), S(half_trace(lambda, xi) / 2));
    auto const any = draw_matrix<S>(draw, n, n);
    claim.differs("a matrix that is not skew", model, quarter_trace(lambda, any), half_trace(lambda, any));
  });
}

STATEMENT(eq_5_5, "difference approximation of the body angular velocity") {
  claim.holds(
      "To first order in the step. The difference $D$ is not in the algebra: $D + D^T = h\\,D^TD$ "
      "exactly. Its skew part is right to second order, half-way through the step.");
  over_groups(rotation_groups(), claim, [&](auto const& group, auto const& model) {
    S const h = step<S>();
    auto const g0 = draw_rotation<S>(draw, group), g1 = draw_rotation<S>(draw, group),
               k = draw_rotation<S>(draw, group);
    Matrix<S> const d = difference_at_end(g0, g1, h);
    claim.equal("D + D^T = h D^T D", model, Matrix<S>(d + d.transpose()), Matrix<S>(d.transpose() * d * h));
    claim.equal("in the body frame: the same for k g_k, k g_k+1", model,
                difference_at_end(Matrix<S>(k * g0), Matrix<S>(k * g1), h), d);
    // A product of matrices that starts at 1: the derivative of D h at a step of no length is the velocity.
    auto const xi = draw_skew<S>(draw, group);
    Matrix<Dual<S>> const along = g0.template cast<Dual<S>>(), next = varying(g0, Matrix<S>(g0 * xi));
    claim.equal("h D to first order along g e^(t xi)", model,
                matrix_rates(Matrix<Dual<S>>(next.transpose() * (next - along))), xi);
    // Controls: D as an element of the algebra; the other side; the difference turned round.
    claim.differs("D skew", model, d, Matrix<S>(-d.transpose()));
    claim.differs("(g_k+1 - g_k) g_k+1^T, the same for k g_k, k g_k+1", model,
                  Matrix<S>(k * (g1 - g0) * g1.transpose() * k.transpose()),
                  Matrix<S>((g1 - g0) * g1.transpose()));
    claim.differs("(g_k - g_k+1): to first order along g e^(t xi)", model,
                  matrix_rates(Matrix<Dual<S>>(next.transpose() * (along - next))), xi);
  });
  if (claim.fits_orders())
    for (auto const& group : rotation_groups()) {
      auto const curve = draw_curve<S>(draw, group);
      std::vector<double> const steps = {1.0 / 64, 1.0 / 128, 1.0 / 256, 1.0 / 512, 1.0 / 1024, 1.0 / 2048};
      std::vector<double> at_end, at_start, skew_at_middle, whole_at_middle, from_space;
      for (double const length : steps) {
        S const h(length);
        auto const [g0, xi0] = place_and_body_velocity(curve, S(0));
        auto const [g1, xi1] = place_and_body_velocity(curve, h);
        Matrix<S> const middle = place_and_body_velocity(curve, h / 2).second,
                        d = difference_at_end(g0, g1, h), skew = (d - d.transpose()) / 2;
        at_end.push_back(to_double(magnitude(Matrix<S>(d - xi1)))),
            at_start.push_back(to_double(magnitude(Matrix<S>(d - xi0))));
        skew_at_middle.push_back(to_double(magnitude(Matrix<S>(skew - middle)))),
            whole_at_middle.push_back(to_double(magnitude(Matrix<S>(d - middle))));
        from_space.push_back(to_double(magnitude(Matrix<S>((g1 - g0) * g1.transpose() / h - xi1))));
      }
      claim.order("D against the body velocity at the end", group.name(), steps, at_end, 1);
      claim.order("D against the body velocity at the start", group.name(), steps, at_start, 1);
      claim.order("its skew part against that half-way", group.name(), steps, skew_at_middle, 2);
      claim.refutes_order("D itself against that half-way, to second order", group.name(), steps,
                          whole_at_middle, 2);
      claim.refutes_order("the difference on the other side", group.name(), steps, from_space, 1);
    }
}

STATEMENT(claim_5_2_discrete_trace_lagrangian,
          "discrete Lagrangian obtained from the difference approximation") {
  claim.holds(
      "The constant left out is $\\mathrm{Tr}\\,\\Lambda/h^2$. The library's has the factor $h$ and the "
      "constant.");
  over_groups(rotation_groups(), claim, [&](auto const& group, auto const& model) {
    int const n = group.matrix_size();
    S const h = step<S>();
    auto const lambda = draw_second_moments<S>(draw, n);
    auto const g0 = draw_rotation<S>(draw, group), g1 = draw_rotation<S>(draw, group);
    S const constant = lambda.trace() / (h * h), scale = S(magnitude(lambda)) * n / (h * h);
    Matrix<S> const d = difference_at_end(g0, g1, h);
    S const substituted = half_trace(lambda, d), printed = -moser_veselov(lambda, g0, g1) / (h * h);
    claim.zero("Tr(D^T Lambda D)/2 = -Tr(g_k Lambda g_k+1^T)/h^2 + Tr(Lambda)/h^2", model,
               S(substituted - printed - constant), scale);
    claim.zero("Tr(D^T J D)/4 gives the same, though D is not skew", model,
               S(quarter_trace(lambda, d) - printed - constant), scale);
    // Controls: sign, factor, side. The constant is known, so each is compared in full.
    claim.refutes("sign flipped", model, S(substituted + printed - constant), scale);
    claim.refutes("half of it", model, S(substituted - printed / 2 - constant), scale);
    claim.refutes("-Tr(g_k^T Lambda g_k+1)/h^2", model,
                  S(substituted + other_side(lambda, g0, g1) / (h * h) - constant), scale);
    claim.refutes("the constant forgotten, not left out", model, S(substituted - printed), scale);
    if (!exact_arithmetic<S>()) {
      // The library's: an action.
      MoserVeselov<Dynamic, S> const scheme(inertia_from_lambda<Dynamic, S>(Vector<S>(lambda.diagonal())), h);
      Element<SpannedGroup, S> const f{group, g1.transpose() * g0};
      claim.zero("the library's is h times it", model, S(scheme.lagrangian()(f) / h - substituted), scale);
    }
  });
}

STATEMENT(claim_5_2_other_difference, "discrete Lagrangian from the difference at the other end point") {
  claim.holds("The two differences are not the same, $D' = g_k^Tg_{k+1}D$; the traces are.");
  over_groups(rotation_groups(), claim, [&](auto const& group, auto const& model) {
    int const n = group.matrix_size();
    S const h = step<S>();
    auto const lambda = draw_second_moments<S>(draw, n);
    auto const g0 = draw_rotation<S>(draw, group), g1 = draw_rotation<S>(draw, group);
    S const scale = S(magnitude(lambda)) * n / (h * h), constant = lambda.trace() / (h * h);
    Matrix<S> const there = difference_at_start(g0, g1, h), here = difference_at_end(g0, g1, h);
    claim.zero("with g_k^T (g_k+1 - g_k)/h the same value", model,
               S(half_trace(lambda, there) - half_trace(lambda, here)), scale);
    claim.zero("which is -Tr(g_k Lambda g_k+1^T)/h^2 and the constant", model,
               S(half_trace(lambda, there) + moser_veselov(lambda, g0, g1) / (h * h) - constant), scale);
    claim.equal("D' = g_k^T g_k+1 D", model, there, Matrix<S>(g0.transpose() * g1 * here));
    // Controls: the differences themselves; matrices that are no rotations; a difference on the other side.
    claim.differs("D' = D", model, there, here);
    auto const a = draw_matrix<S>(draw, n, n), b = draw_matrix<S>(draw, n, n);
    claim.refutes(
        "matrices that are no rotations", model,
        S(half_trace(lambda, difference_at_start(a, b, h)) - half_trace(lambda, difference_at_end(a, b, h))),
        scale);
    claim.refutes("the difference as seen from space", model,
                  S(half_trace(lambda, Matrix<S>((g1 - g0) * g0.transpose() / h)) - half_trace(lambda, here)),
                  scale);
  });
}

STATEMENT(claim_5_2_moser_veselov_multiple, "discrete Lagrangian compared with that of Moser and Veselov") {
  claim.holds(
      "Theirs is $\\mathrm{Tr}(X_kJX_{k+1}^T)$, with $J$ in place of $\\Lambda$. A negative factor turns "
      "least into greatest and leaves the "
      "stationary sequences as they are.");
  over_groups(rotation_groups(), claim, [&](auto const& group, auto const& model) {
    int const n = group.matrix_size();
    S const h = step<S>(), multiple = -S(1) / (h * h);
    auto const lambda = draw_second_moments<S>(draw, n);
    auto const g = [&] { return draw_rotation<S>(draw, group); };
    auto const x = g(), y = g(), a = g(), b = g();
    // Theirs, entry by entry: the sum of J_j X_ij Y_ij. Differences between two pairs: a constant drops out.
    auto const theirs = [&](Matrix<S> const& p, Matrix<S> const& q) {
      S sum(0);
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) sum += lambda(j, j) * p(i, j) * q(i, j);
      return sum;
    };
    auto const ours = [&](Matrix<S> const& p, Matrix<S> const& q) {
      return half_trace(lambda, difference_at_end(p, q, h));
    };
    S const change = ours(x, y) - ours(a, b), scale = S(magnitude(lambda)) * n / (h * h);
    claim.zero("-1/h^2 times theirs, up to a constant", model,
               S(change - multiple * (theirs(x, y) - theirs(a, b))), scale);
    // Their equation X_k+1 J + X_k-1 J = lambda X_k: the slope of the sum at the middle one of three, along
    // any matrix.
    auto const by = draw_matrix<S>(draw, n, n);
    Matrix<Dual<S>> const moving_x = varying(x, by);
    auto const fixed = [](Matrix<S> const& m) { return Matrix<Dual<S>>(m.template cast<Dual<S>>()); };
    Matrix<Dual<S>> const l = fixed(lambda);
    S const slope = (moser_veselov(l, fixed(a), moving_x) + moser_veselov(l, moving_x, fixed(b))).part[0];
    claim.zero("the slope of their sum is that of X_k+1 J + X_k-1 J", model,
               S(slope - trace_of(by, Matrix<S>((a + b) * lambda))), S(magnitude(lambda)) * n);
    // Controls: the sign, the factor, the other side.
    claim.refutes("1/h^2 times theirs", model, S(change + multiple * (theirs(x, y) - theirs(a, b))), scale);
    claim.refutes("-1/(2 h^2) times theirs", model, S(change - multiple * (theirs(x, y) - theirs(a, b)) / 2),
                  scale);
    claim.refutes("theirs with the transpose in the first factor", model,
                  S(change - multiple * (other_side(lambda, x, y) - other_side(lambda, a, b))), scale);
  });
}

STATEMENT(claim_5_2_reduced_trace_lagrangian, "reduced discrete Lagrangian as a trace") {
  claim.convention(
      "Of the scaled Lagrangian $\\mathrm{Tr}(g_k\\Lambda g_{k+1}^T)$; the one printed before it has "
      "$-1/h^2$ as well. The trace is the same for $f$ and $f^{-1}$: this Lagrangian does not depend on "
      "the direction of time.");
  over_groups(rotation_groups(), claim, [&](auto const& group, auto const& model) {
    int const n = group.matrix_size();
    auto const lambda = draw_second_moments<S>(draw, n);
    auto const g0 = draw_rotation<S>(draw, group), g1 = draw_rotation<S>(draw, group),
               k = draw_rotation<S>(draw, group);
    S const value = moser_veselov(lambda, g0, g1), scale = S(magnitude(lambda)) * n;
    // f from g1 f = g0, by elimination.
    Matrix<S> const f = solve_linear(g1, g0, "g1 f = g0");
    auto const reduced = [&](Matrix<S> const& m) { return S(Matrix<S>(m * lambda).trace()); };
    claim.zero("left-invariant", model,
               S(moser_veselov(lambda, Matrix<S>(k * g0), Matrix<S>(k * g1)) - value), scale);
    claim.zero("L(g_k, g_k+1) = Tr(f Lambda)", model, S(reduced(f) - value), scale);
    claim.zero("the same for f^-1", model, S(reduced(f.transpose()) - value), scale);
    // Controls: multiplication on the right; the other quotient; matrices that are no rotations; a Lambda
    // that is not symmetric knows f from its inverse.
    claim.refutes("right-invariant", model,
                  S(moser_veselov(lambda, Matrix<S>(g0 * k), Matrix<S>(g1 * k)) - value), scale);
    claim.refutes("f = g_k g_k+1^-1", model, S(reduced(g0 * g1.transpose()) - value), scale);
    auto const a = draw_matrix<S>(draw, n, n);
    claim.refutes("carried on the left by a matrix that is no rotation", model,
                  S(moser_veselov(lambda, Matrix<S>(a * g0), Matrix<S>(a * g1)) - value), scale);
    auto const bent = draw_matrix<S>(draw, n, n);
    claim.refutes("Lambda not symmetric: f and f^-1", model,
                  S(Matrix<S>(f * bent).trace() - Matrix<S>(f.transpose() * bent).trace()), scale);
    claim.refutes("with the factor -1/h^2", model, S(value + reduced(f) / (step<S>() * step<S>())), scale);
  });
}

// ----
// Section 5.2, second part: attitudes held on the group by multipliers, the equation of motion with them and
// without.
//
// Off the motions every equation here is an identity between its residual and that of another; motions are
// constructed (bodies.hpp).

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
      "It contributes nothing anywhere, on the group or off it, and no equation determines it: it may be "
      "taken to be zero.");
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
      "For the scaled Lagrangian, without the factor $-1/h^2$. Its stationary sequences, the configurations "
      "varied over all matrices, are those of the "
      "unconstrained sum varied over the group; each has one symmetric multiplier at each configuration, "
      "$\\lambda_k = (g_{k+1}+g_{k-1})\\Lambda g_k^T$.");
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
  claim.corrected(R"(\bar\lambda_k = g^T\lambda_k g \text{ for all } g \in G)",
                  R"(\bar\lambda_k = g_k^T)"
                  R"(\lambda_k g_k)",
                  "With one element, the configuration itself: the multiplier in the body frame. All "
                  "conjugates of $\\lambda_k$ are symmetric, but only this one "
                  "is in the reduced equation, and they are all the same only where $\\lambda_k$ is a "
                  "multiple of the identity. "
                  "Left multiplication takes the constraint to its conjugate and $\\lambda_k$ with it; "
                  "$\\bar\\lambda_k$ stays.");
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
  claim.corrected(R"(-\ell'(f_{kk-1})TR_{f_{kk-1}} + \ell'(f_{k+1k})\mathrm{Ad}_{f_{k+1k}}TR_{f_{k+1k}} = )"
                  R"(\bar\lambda_k)",
                  R"(\ell'(f_{kk-1})TR_{f_{kk-1}}\vartheta_k^T + \ell'(f_{k+1k})TR_{f_{k+1k}})"
                  R"(\mathrm{Ad}_{f_{k+1k}}\vartheta_k = \mathrm{Tr}(\bar\lambda_k\vartheta_k))",
                  "For skew $\\vartheta_k$ the two are the same, both multipliers drop out, and (3.11) "
                  "remains. But a multiplier is there so that $\\vartheta_k = g_k^T\\delta g_k$ may be "
                  "any matrix, and then (5.6), where $f_{kk-1} = g_k^Tg_{k-1}$, has $\\vartheta_k^T$ in "
                  "place of $-\\vartheta_k$; only so does the next equation follow. With inverses in "
                  "place of transposes the printed operators stand, but for another multiplier, $\\Lambda "
                  "f_{k+1k} - f_{kk-1}\\Lambda$. $\\Ad$ comes before $TR$, which leaves the algebra; as "
                  "products of matrices either order gives $f\\vartheta$.");
  over_groups(rotation_groups(), claim, [&](auto const& group, auto const& model) {
    int const n = group.matrix_size();
    auto const corrected =
        [&](Matrix<S> const& lambda, Matrix<S> const& f10, Matrix<S> const& f21, Matrix<S> const& theta) {
      return S(slope_of_trace(lambda, Matrix<S>(theta.transpose() * f10)) +
               slope_of_trace(lambda, Matrix<S>(f21 * theta * f21.transpose() * f21)));
    };
    auto const printed =
        [&](Matrix<S> const& lambda, Matrix<S> const& f10, Matrix<S> const& f21, Matrix<S> const& theta) {
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
  claim.holds("It is (3.11) for $\\ell(f) = \\mathrm{Tr}(f\\Lambda)$.");
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
}

// ----
// Section 5.2, third part: the momentum update, reconstruction, the equations of Moser and Veselov, and the
// spaces on which the formulations run.
//
// Momenta are those of the scaled Lagrangian Tr(f Lambda): h times the physical ones. Motions by design,
// exact over the rationals (generalized_bodies.hpp).

namespace {

/// \f$\mathrm{Ad}_f\f$ on the algebra, whose elements are matrices as those of the dual are:
/// \f$f\Pi f^{-1}\f$.
template <class S>
Matrix<S> adjoint(Turn<S> const& f, Matrix<S> const& m) {
  return f.group.hat(Ad(f, BodyVelocity<S>{f.group, f.group.vee(m)}).coordinates);
}
constexpr char first_line[] = R"(M_{k+1} = \omega_{k-1}M_k\omega_{k-1}^{-1})";
constexpr char first_line_right[] = R"(M_{k+1} = \omega_kM_k\omega_k^{-1})";
/// \f$g_k\Lambda g_{k-1}^T - g_{k-1}\Lambda g_k^T\f$.
template <class S>
Matrix<S> spatial(Matrix<S> const& lambda, Turn<S> const& earlier, Turn<S> const& later) {
  Matrix<S> const p = later.value * lambda * earlier.value.transpose();
  return p - p.transpose();
}
/// A turn about the last principal axis of a body in three dimensions, or in two planes of a larger one, with
/// cosine c and sine s.
template <class S>
Turn<S> about_principal_axes(int n, S const& c, S const& s, S const& c_other) {
  Turn<S> f{Turns{n}, Matrix<S>::Identity(n, n)};
  f.value(0, 0) = f.value(1, 1) = c, f.value(0, 1) = -s, f.value(1, 0) = s;
  if (n > 3) f.value(2, 2) = f.value(3, 3) = c_other, f.value(2, 3) = -s, f.value(3, 2) = s;
  return f;
}

}  // namespace

STATEMENT(eq_5_8, "explicit momentum update on the dual of the rotation algebra") {
  claim.corrected(R"(\Pi_{k+1} = \mathrm{Ad}_{f_{k+1k}^{-1}}\Pi_k = f_{k+1k}\Pi_kf_{k+1k}^T)",
                  R"(\Pi_{k+1} = \mathrm{Ad}^*_{f_{k+1k}^{-1}}\Pi_k = f_{k+1k}\Pi_kf_{k+1k}^T)",
                  "A star is missing: without it the adjoint operator turns by the inverse. The product of "
                  "matrices beside it is right.");
  claim.maybe_scan();
  over_bodies(claim, [&](int n, auto const& model) {
    auto const motion = draw_motion<S>(draw, n);
    TraceLagrangian<S> const l{motion.lambda};
    for (int k = 0; k + 1 < motion.last(); ++k) {
      // Momenta of two consecutive steps, each from its own relative motion by differentiation.
      auto const pi = left_differential(l, motion.f[k]), next = left_differential(l, motion.f[k + 1]);
      claim.zero("the middle expression, with its star", model, gap(Ad_star(inverse(motion.f[k]), pi), next),
                 S(1), designed);
      claim.zero("the right expression, as printed", model,
                 gap(turned(motion.f[k], as_matrix(pi)), as_matrix(next)), S(1), designed);
      claim.zero("the library's update", model, gap(lie_poisson_update_left(motion.f[k], pi), next), S(1),
                 designed);
      // Controls: as printed; the relative motion of the step to come.
      claim.differs("Ad without star, as printed", model, adjoint(inverse(motion.f[k]), as_matrix(pi)),
                    as_matrix(next));
      claim.differs("transported by the next relative motion", model, turned(motion.f[k + 1], as_matrix(pi)),
                    as_matrix(next));
    }
  });
}

STATEMENT(claim_5_2_update_by_adjoint, "momentum update written with an adjoint operator") {
  claim.corrected(R"(\Pi_{k+1} = \mathrm{Ad}_{f_{k+1k}^{-1}}\Pi_k)",
                  R"(\Pi_{k+1} = \mathrm{Ad}^*_{f_{k+1k}^{-1}}\Pi_k)",
                  "On $\\so(n)$ the right form is the adjoint operator of $f$; the printed one, without a "
                  "star, that of its inverse.");
  claim.maybe_scan();
  over_bodies(claim, [&](int n, auto const& model) {
    auto const f = draw_turn<S>(draw, n);
    auto const pi = draw.template momentum<S>(Turns{n});
    // As operators on any momentum, with no motion in view.
    auto const right = Ad_star(inverse(f), pi);
    claim.equal("Ad* of the inverse is f Pi f^T", model, as_matrix(right), turned(f, as_matrix(pi)));
    claim.equal("on so(n) it is Ad of f", model, adjoint(f, as_matrix(pi)), as_matrix(right));
    claim.differs("Ad of the inverse, as printed", model, adjoint(inverse(f), as_matrix(pi)),
                  as_matrix(right));
    claim.differs("Ad* without the inverse", model, Ad_star(f, pi), right);
    // On a motion.
    auto const motion = draw_motion<S>(draw, n);
    TraceLagrangian<S> const l{motion.lambda};
    auto const start = left_differential(l, motion.f[0]);
    auto const end = Ad_star(inverse(motion.f[1]), Ad_star(inverse(motion.f[0]), start));
    claim.zero("two updates along a motion", model, gap(end, left_differential(l, motion.f[2])), S(1),
               designed);
  });
}

STATEMENT(claim_5_2_update_by_conjugation, "momentum update written as matrix conjugation") {
  claim.holds();
  over_bodies(claim, [&](int n, auto const& model) {
    auto const motion = draw_motion<S>(draw, n);
    auto const& f = motion.f;
    // (5.7) as it stands, then the update.
    claim.zero("two steps satisfy (5.7)", model,
               Matrix<S>(before(motion.lambda, f[1]) - after(motion.lambda, f[0])), S(1), designed);
    claim.zero("and the next two", model, Matrix<S>(before(motion.lambda, f[2]) - after(motion.lambda, f[1])),
               S(1), designed);
    for (int k = 0; k < 2; ++k) {
      claim.zero("f Pi f^T", model,
                 gap(turned(f[k], before(motion.lambda, f[k])), before(motion.lambda, f[k + 1])), S(1),
                 designed);
      claim.differs("f^T Pi f", model, turned(inverse(f[k]), before(motion.lambda, f[k])),
                    before(motion.lambda, f[k + 1]));
    }
    // Without (5.7) the update carries the momentum to the end of the step, and no further.
    auto const lambda = draw_inertia<S>(draw, n);
    auto const step = draw_turn<S>(draw, n), other = draw_turn<S>(draw, n);
    claim.equal("within one step, any relative motion", model, turned(step, before(lambda, step)),
                after(lambda, step));
    claim.differs("no motion", model, turned(step, before(lambda, step)), before(lambda, other));
  });
}

STATEMENT(claim_5_2_reconstruction, "reconstruction of the unreduced rigid body algorithm") {
  claim.holds();
  over_bodies(claim, [&](int n, auto const& model) {
    auto const motion = draw_motion<S>(draw, n);
    auto const& g = motion.g;
    auto const L = lift_left(TraceLagrangian<S>{motion.lambda});
    auto const at = [&](int k) -> Matrix<S> const& { return g[k].value; };
    for (int k = 1; k <= 2; ++k) {
      auto const next = reconstruct_left(g[k], motion.f[k]);
      claim.equal("g_k f^-1 has the relative motion f", model, relative_motion_left(g[k], next), motion.f[k]);
      claim.zero("the discrete Euler-Lagrange equations", model,
                 discrete_euler_lagrange(L, g[k - 1], g[k], next), S(1), designed);
      // With multipliers, as (5.6) has it: g_{k-1} Lambda + g_{k+1} Lambda = lambda_k g_k with a symmetric
      // lambda_k.
      auto const multiplier = [&](Turn<S> const& last) {
        return Matrix<S>((at(k - 1) + last.value) * motion.lambda * at(k).transpose());
      };
      auto const skew = [&](Matrix<S> const& m) { return Matrix<S>(m - m.transpose()); };
      claim.zero("the multiplier of (5.6) is symmetric", model, skew(multiplier(next)), S(1), designed);
      // Controls: the inverse lost; the other side.
      claim.refutes("g_k f", model, skew(multiplier(g[k] * motion.f[k])), S(1));
      claim.refutes("f^-1 g_k", model, skew(multiplier(inverse(motion.f[k]) * g[k])), S(1));
    }
  });
}

STATEMENT(eq_5_9, "Moser-Veselov equations") {
  claim.corrected(std::string(first_line) + R"(,\quad M_k = \omega_k^T\Lambda - \Lambda\omega_k)",
                  std::string(first_line_right) + R"(,\quad M_k = \omega_k^T\Lambda - \Lambda\omega_k)",
                  "The index of $\\omega$ in the first line is one too low: the step that carries $M_k$ to "
                  "$M_{k+1}$ turns by $\\omega_k$. The second line is right.");
  over_bodies(claim, [&](int n, auto const& model) {
    auto const motion = draw_motion<S>(draw, n);
    // The attitudes alone: omega_k and the momentum in space by their definitions.
    auto const omega = [&](int k) {
      return Turn<S>{Turns{n}, motion.g[k].value.transpose() * motion.g[k - 1].value};
    };
    auto const spatial = [&](int k) {
      return Matrix<S>(motion.g[k].value * motion.lambda * motion.g[k - 1].value.transpose() -
                       motion.g[k - 1].value * motion.lambda * motion.g[k].value.transpose());
    };
    auto const body = [&](int k) { return turned(inverse(motion.g[k - 1]), spatial(k)); };
    for (int k = 1; k <= 3; ++k)
      claim.zero("second line", model, gap(body(k), before(motion.lambda, omega(k))), S(1), designed);
    for (int k = 1; k <= 2; ++k)
      claim.zero("first line, with omega_k", model, gap(turned(omega(k), body(k)), body(k + 1)), S(1),
                 designed);
    claim.differs("first line, with omega_{k-1} as printed", model, turned(omega(1), body(2)), body(3));
    claim.differs("first line, with omega_{k+1}", model, turned(omega(2), body(1)), body(2));
    claim.differs("second line, sides exchanged", model, body(2), after(motion.lambda, omega(2)));
  });
}

STATEMENT(thm_5_2_1, "reduced algorithms compared with the Moser-Veselov equations") {
  claim.corrected(first_line, first_line_right,
                  "Equivalent to (5.9) with $\\omega_k$ in its first line, at any two relative motions and "
                  "in any dimension. To (5.9) as printed it is not: that has other motions.");
  over_bodies(claim, [&](int n, auto const& model) {
    // Off motions too: the residual of the first line, with the second put in, is that of (5.7). So one holds
    // exactly where the other does.
    auto const lambda = draw_inertia<S>(draw, n);
    auto const omega = draw_turn<S>(draw, n), next = draw_turn<S>(draw, n), previous = draw_turn<S>(draw, n);
    Matrix<S> const dep = before(lambda, next) - after(lambda, omega);
    auto const left = [&](Turn<S> const& by) {
      return Matrix<S>(before(lambda, next) - turned(by, before(lambda, omega)));
    };
    claim.equal("(5.9) and (5.7) leave the same, any relative motions", model, left(omega), dep);
    claim.differs("(5.9) as printed and (5.7)", model, left(previous), dep);
    // The three forms along one motion.
    auto const motion = draw_motion<S>(draw, n);
    TraceLagrangian<S> const l{motion.lambda};
    for (int k = 1; k <= 2; ++k) {
      claim.zero("DEP, by differentiation", model,
                 euler_poincare_left(l, motion.omega(k), motion.omega(k + 1)), S(1), designed);
      claim.zero("DLP", model,
                 gap(as_matrix(lie_poisson_update_left(motion.omega(k), as_momentum(motion.body(k)))),
                     motion.body(k + 1)),
                 S(1), designed);
      claim.zero("Moser-Veselov, first line with omega_k", model,
                 gap(turned(motion.omega(k), motion.body(k)), motion.body(k + 1)), S(1), designed);
    }
    claim.differs("Moser-Veselov, first line as printed", model, turned(motion.omega(1), motion.body(2)),
                  motion.body(3));
  });
}

STATEMENT(claim_5_2_mv_first_line, "first Moser-Veselov equation, momentum update") {
  claim.corrected(R"(M_{k+1} = \omega_{k-1}M_k\omega_{k-1}^{-1})", R"(M_{k+1} = \omega_kM_k\omega_k^{-1})",
                  "The index of $\\omega$ is one too low.");
  over_bodies(claim, [&](int n, auto const& model) {
    auto const motion = draw_motion<S>(draw, n);
    for (int k = 1; k <= 2; ++k) {
      claim.zero("with omega_k", model, gap(turned(motion.omega(k), motion.body(k)), motion.body(k + 1)),
                 S(1), designed);
      claim.differs("with the inverse of omega_k", model, turned(inverse(motion.omega(k)), motion.body(k)),
                    motion.body(k + 1));
    }
    claim.differs("with omega_{k-1}, as printed", model, turned(motion.omega(1), motion.body(2)),
                  motion.body(3));
    // As a discretisation of the left Lie-Poisson equation: a fixed momentum in space, seen from attitude
    // after attitude. It asks for no motion.
    auto const m = draw.template momentum<S>(Turns{n});
    auto const g0 = draw_turn<S>(draw, n), g1 = draw_turn<S>(draw, n);
    auto const seen = [&](Turn<S> const& g) { return turned(inverse(g), as_matrix(m)); };
    claim.equal("a constant momentum in space obeys it, whatever the attitudes", model,
                turned(relative_motion_left(g0, g1), seen(g0)), seen(g1));
  });
}

STATEMENT(claim_5_2_mv_second_line, "second Moser-Veselov equation, momentum and angular velocity") {
  claim.holds("It is $h$ times the physical body momentum at the beginning of the step, at $g_{k-1}$.");
  over_bodies(claim, [&](int n, auto const& model) {
    auto const lambda = draw_inertia<S>(draw, n);
    auto const g0 = draw_turn<S>(draw, n), g1 = draw_turn<S>(draw, n);
    auto const omega = relative_motion_left(g0, g1);
    Matrix<S> const line = omega.value.transpose() * lambda - lambda * omega.value;
    claim.zero("it lies in so(n)", model, Matrix<S>(line + line.transpose()), S(1));
    // The momentum of the discrete Lagrangian, translated by the attitude, through the differential with
    // respect to g_{k-1} alone.
    auto const L = lift_left(TraceLagrangian<S>{lambda, S(-1)});
    claim.equal("the body momentum at the beginning of the step", model,
                as_matrix(Ad_star(g0, legendre_source(L, g0, g1))), line);
    claim.equal("as printed, g_{k-1}^T m_k g_{k-1}", model, turned(inverse(g0), spatial(lambda, g0, g1)),
                line);
    // Controls: the end of the step; the factors exchanged.
    claim.differs("the body momentum at the end of the step", model,
                  as_matrix(Ad_star(g1, legendre_target(L, g0, g1))), line);
    claim.differs("Lambda and omega exchanged", model,
                  Matrix<S>(lambda * omega.value.transpose() - omega.value * lambda), line);
  });
}

STATEMENT(claim_5_2_mv_identifications, "identification of variables between the two formulations") {
  claim.convention(
      "With the momenta of the scaled Lagrangian $\\mathrm{Tr}(f\\Lambda)$, $h$ times the physical ones. "
      "$\\pi_0$ is the constant momentum in space, which is $\\Pi_0$ only where $g_0 = 1$.");
  over_bodies(claim, [&](int n, auto const& model) {
    auto const motion = draw_motion<S>(draw, n);
    auto const& g = motion.g;
    TraceLagrangian<S> const l{motion.lambda};
    // Pi_k belongs to g_k: the momentum at the start of the step with f_{k+1,k}. M_k is the second line of
    // (5.9).
    auto const pi = [&](int k) { return left_differential(l, relative_motion_left(g[k], g[k + 1])); };
    auto const m0 = spatial(motion.lambda, g[0], g[1]);
    auto const pi0 = Ad_star(inverse(g[0]), pi(0));
    claim.zero("pi_0 = m_0", model, gap(as_matrix(pi0), m0), S(1), designed);
    for (int k = 1; k <= 3; ++k) {
      claim.equal("omega_k = f_{k,k-1}", model, relative_motion_left(g[k - 1], g[k]),
                  Turn<S>{Turns{n}, g[k].value.transpose() * g[k - 1].value});
      claim.zero("Pi_{k-1} = M_k", model, gap(as_matrix(pi(k - 1)), motion.body(k)), S(1), designed);
      claim.zero("Pi_{k-1} = Ad*_{g_{k-1}} pi_0", model, gap(pi(k - 1), Ad_star(g[k - 1], pi0)), S(1),
                 designed);
      claim.zero("M_k = g_{k-1}^T m_0 g_{k-1}", model, gap(turned(inverse(g[k - 1]), m0), motion.body(k)),
                 S(1), designed);
    }
    claim.differs("Pi_k = M_k", model, as_matrix(pi(1)), motion.body(1));
    claim.differs("Ad* of the inverse", model, Ad_star(inverse(g[1]), pi0), pi(1));
    claim.differs("Pi_0 for pi_0", model, Ad_star(g[1], pi(0)), pi(1));
    claim.differs("the physical momentum, step 1/2, for M_k", model, as_matrix(S(2) * pi(1)), motion.body(2));
  });
}

STATEMENT(claim_5_2_spatial_momentum, "discrete spatial angular momentum along the scheme") {
  claim.holds("$h$ times the physical one, $m_k = g_k\\Lambda g_{k-1}^T - g_{k-1}\\Lambda g_k^T$.");
  over_bodies(claim, [&](int n, auto const& model) {
    auto const motion = draw_motion<S>(draw, n);
    auto const& g = motion.g;
    auto const L = lift_left(TraceLagrangian<S>{motion.lambda, S(-1)});
    auto const m = [&](int k) { return turned(g[k - 1], motion.body(k)); };
    for (int k = 1; k <= 3; ++k) {
      claim.zero("constant along a motion", model, gap(m(k), m(1)), S(1), designed);
      claim.zero("by attitudes", model, gap(spatial(motion.lambda, g[k - 1], g[k]), m(k)), S(1), designed);
      claim.zero("the momentum at the start of the step, by differentiation", model,
                 gap(as_matrix(legendre_source(L, g[k - 1], g[k])), m(k)), S(1), designed);
      claim.zero("and the one at its end", model, gap(as_matrix(legendre_target(L, g[k - 1], g[k])), m(k)),
                 S(1), designed);
    }
    claim.differs("the body momentum is not constant", model, motion.body(2), motion.body(1));
    claim.differs("no motion", model, spatial(motion.lambda, g[2], draw_turn<S>(draw, n)), m(1));
  });
}

STATEMENT(claim_5_2_momentum_by_substitution,
          "discrete momentum relation from the continuous one by substitution") {
  claim.corrected(
      R"(M = J(\xi) = \Lambda\xi + \xi\Lambda)", R"(M = J(\xi) = \Lambda\xi - \xi^T\Lambda)",
      "The two are the same for skew $\\xi$, but the difference (5.5) is not skew: only the second form "
      "makes of it the second line of (5.9), over $h$. The first makes of it no element of "
      "$\\so(n)$; the skew part of that is the mean of the momenta at the two ends of the step.");
  over_bodies(claim, [&](int n, auto const& model) {
    auto const lambda = draw_inertia<S>(draw, n);
    auto const g0 = draw_turn<S>(draw, n), g1 = draw_turn<S>(draw, n);
    S const h = ratio<S>(1, 8) + draw.template number<S>() * ratio<S>(1, 16);
    auto const f = relative_motion_left(g0, g1);
    Matrix<S> const start = before(lambda, f) / h, end = after(lambda, f) / h;
    Matrix<S> const later = g1.value.transpose() * (g1.value - g0.value) / h,
                    earlier = g0.value.transpose() * (g1.value - g0.value) / h;
    auto const right = [&](Matrix<S> const& xi) { return Matrix<S>(lambda * xi - xi.transpose() * lambda); };
    auto const printed = [&](Matrix<S> const& xi) { return Matrix<S>(lambda * xi + xi * lambda); };
    claim.zero("(5.5) in Lambda xi - xi^T Lambda: the momentum before the step", model,
               Matrix<S>(right(later) - start), S(S(1) / h));
    claim.zero("the difference at the other end: the momentum after it", model,
               Matrix<S>(right(earlier) - end), S(S(1) / h));
    Matrix<S> const as_printed = printed(later);
    claim.zero("skew part of Lambda xi + xi Lambda: the mean of the two", model,
               Matrix<S>(as_printed - as_printed.transpose() - start - end), S(S(1) / h));
    auto const xi = as_matrix(draw.template momentum<S>(Turns{n}));
    claim.equal("both forms of J on skew matrices", model, right(xi), printed(xi));
    // Controls.
    claim.differs("(5.5) in Lambda xi + xi Lambda, as printed", model, as_printed, start);
    claim.differs("which is not skew", model, as_printed, Matrix<S>(-as_printed.transpose()));
    claim.differs("nor is its skew part the momentum before the step", model,
                  Matrix<S>((as_printed - as_printed.transpose()) / S(2)), start);
  });
}

STATEMENT(claim_5_2_dep_on_group, "spaces on which the two formulations evolve") {
  claim.convention(
      "$M_k$ determines $\\omega_k$ only together with a branch: the one that grows out of the identity with "
      "the step. A momentum has other relative motions as well.");
  over_bodies(claim, [&](int n, auto const& model) {
    // On the group alone: the relative motion carries all of the state, and the momentum is a function of it.
    auto const motion = draw_motion<S>(draw, n);
    claim.zero("omega_k alone gives M_{k+1}", model,
               gap(after(motion.lambda, motion.omega(1)), motion.body(2)), S(1), designed);
    claim.zero("and again", model, gap(after(motion.lambda, motion.omega(2)), motion.body(3)), S(1),
               designed);
    // Two relative motions, and more for larger n, with one momentum: an angle about a principal axis and its
    // supplement have the same sine.
    S const t = ratio<S>(1, 3) + draw.template number<S>() * ratio<S>(1, 8),
            c = (S(1) - t * t) / (S(1) + t * t), s = S(2) * t / (S(1) + t * t);
    auto const lambda = draw_inertia<S>(draw, n);
    auto const near = about_principal_axes(n, c, s, c), far = about_principal_axes(n, S(-c), s, c),
               both = about_principal_axes(n, S(-c), s, S(-c));
    claim.equal("one momentum of two relative motions", model, before(lambda, far), before(lambda, near));
    claim.equal("one momentum, another relative motion", model, before(lambda, both), before(lambda, near));
    claim.differs("M_k alone gives omega_k", model, far, near);
    if (n > 3) claim.differs("M_k alone gives omega_k, second plane", model, both, far);
  });
  if (!exact_arithmetic<S>())
    over_bodies(claim, [&](int n, auto const& model) {
      // A body in its principal frame, four steps: the chain g* -> G -> g* -> G, and the algorithm on G,
      // which never asks for a momentum.
      auto const lambda = draw_inertia<S>(draw, n);
      S const h = ratio<S>(1, 8);
      MoserVeselov<Dynamic, S> const scheme(inertia_from_lambda<Dynamic, S>(lambda.diagonal()), h);
      auto pi = draw.template momentum<S>(Turns{n});
      auto f = scheme.relative_motion(pi).value;
      // The solver leaves 16 epsilon of the largest angle, a part of the step, which is divided by h in the
      // momentum; four steps add up.
      double const solved = 16;
      for (int k = 0; k < 4; ++k) {
        claim.zero("M_k to omega_k: second line", model, Matrix<S>(before(lambda, f) - h * as_matrix(pi)),
                   S(1), solved);
        auto const next_f = scheme.step_euler_poincare(f).value;
        claim.zero("on the group: (5.7)", model, Matrix<S>(before(lambda, next_f) - after(lambda, f)), S(1),
                   solved);
        pi = as_momentum(Matrix<S>(turned(f, before(lambda, f)) / h));
        f = scheme.relative_motion(pi).value;
        claim.equal("both on the same relative motions", model, f, next_f, solved);
      }
    });
}
