// Section 5.2, first part: the trace Lagrangian and its discretisation.

#include "actio/rigid_body/moser_veselov.hpp"

#include "models/bodies.hpp"
#include "models/charts.hpp"
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
      "To first order in the step. The difference $D$ is not in the algebra: $D + D^T = h\\,D^TD$ exactly. "
      "Its skew part is right to second order, half-way through the step.");
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
      auto const curve = draw_retracted_curve<S>(draw, group);
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
      "The constant left out is $\\mathrm{Tr}\\,\\Lambda/h^2$. The library's has "
      "the factor $h$ and the constant.");
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
      "least into greatest and leaves the stationary sequences as they are.");
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
      "Of the scaled Lagrangian $\\mathrm{Tr}(g_k\\Lambda g_{k+1}^T)$; the one printed before it "
      "has $-1/h^2$ as well. The trace is the same for $f$ and $f^{-1}$: this Lagrangian does not "
      "depend on the direction of time.");
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
