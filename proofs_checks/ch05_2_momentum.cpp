// Section 5.2, third part: the momentum update, reconstruction, the equations of Moser and Veselov, and the
// spaces on which the formulations run.
//
// Momenta are those of the scaled Lagrangian Tr(f Lambda): h times the physical ones. Motions by design,
// exact over the rationals (generalized_bodies.hpp).

#include "actio/reduction/discrete_euler_lagrange.hpp"
#include "actio/reduction/discrete_euler_poincare.hpp"
#include "actio/reduction/discrete_forms.hpp"
#include "actio/reduction/relative_motion.hpp"
#include "actio/rigid_body/moser_veselov.hpp"

#include "models/bodies.hpp"
#include "models/charts.hpp"
#include "models/moser_veselov_runs.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

/// \f$\mathrm{Ad}_f\f$ on the algebra, whose elements are matrices as those of the dual are:
/// \f$f\Pi f^{-1}\f$.
template <class S>
Matrix<S> adjoint(Turn<S> const& f, Matrix<S> const& m) {
  return f.group.hat(Ad(f, BodyVelocity<S>{f.group, f.group.vee(m)}).coordinates);
}
std::vector<double> const difference_steps = {1.0 / 64,  1.0 / 128,  1.0 / 256,
                                              1.0 / 512, 1.0 / 1024, 1.0 / 2048};
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
                  "matrices beside it is right: with the $f$ that each momentum asks for it approaches the "
                  "Lie-Poisson flow, forwards and to second order.");
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
  if (claim.fits_orders())
    over_bodies(claim, [&](int n, auto const& model) {
      auto const body = draw_moving_body<S>(draw, n);
      auto const steps = in_half_a_unit.step_lengths();
      auto const by = [&](auto const& carry) {
        return errors_of_momenta(body, [&](S const&, auto const& pi, auto const& f) {
          return as_momentum(carry(f, as_matrix(pi)));
        });
      };
      auto const right = by([](auto const& f, auto const& m) { return turned(f, m); }),
                 printed = by([](auto const& f, auto const& m) { return adjoint(inverse(f), m); });
      claim.order("momentum against the flow of the body", model, steps, right.momentum, 2);
      claim.refutes_order("momentum, Ad without star as printed: it runs back", model, steps,
                          printed.momentum, 2);
    });
}

STATEMENT(claim_5_2_update_by_adjoint, "momentum update written with an adjoint operator") {
  claim.same_slip_as("eq_5_8");
  claim.corrected(R"(\Pi_{k+1} = \mathrm{Ad}_{f_{k+1k}^{-1}}\Pi_k)",
                  R"(\Pi_{k+1} = \mathrm{Ad}^*_{f_{k+1k}^{-1}}\Pi_k)",
                  "On $\\so(n)$ the right form is the adjoint operator of $f$; the printed one, "
                  "without a star, that of its inverse.");
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
                  "The index of $\\omega$ in the first line is one too low: the step that "
                  "carries $M_k$ to $M_{k+1}$ turns by $\\omega_k$. The second line is right. "
                  "$M_k/h$ and the attitudes then approach the flow of the body to second order; "
                  "as printed, by the step before, to first.");
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
  if (claim.fits_orders())
    over_bodies(claim, [&](int n, auto const& model) {
      auto const body = draw_moving_body<S>(draw, n);
      auto const steps = in_half_a_unit.step_lengths();
      auto const right = errors_of_momenta(body, [](S const&, auto const& m, auto const& omega) {
        return as_momentum(turned(omega, as_matrix(m)));
      });
      claim.order("M_k/h against the flow of the body", model, steps, right.momentum, 2);
      claim.order("attitudes against the flow of the body", model, steps, right.attitude, 2);
      // As printed: by the step before, which for the first is that of the body itself.
      Turn<S> const first{body.group(), body.start.attitude};
      S of(0);
      Turn<S> earlier = first;
      auto const printed = errors_of_momenta(body, [&](S const& h, auto const& m, auto const& omega) {
        if (h != of) earlier = relative_motion_left(body.exact(S(-h)), first), of = h;
        auto const next = as_momentum(turned(earlier, as_matrix(m)));
        earlier = omega;
        return next;
      });
      claim.order("M_k/h, first line as printed: to first order", model, steps, printed.momentum, 1);
      claim.refutes_order("M_k/h, first line as printed", model, steps, printed.momentum, 2);
      auto const back = errors_of_momenta(body, [](S const&, auto const& m, auto const& omega) {
        return as_momentum(turned(inverse(omega), as_matrix(m)));
      });
      claim.refutes_order("M_k/h, by the inverse of omega_k", model, steps, back.momentum, 2);
    });
}

STATEMENT(thm_5_2_1, "reduced algorithms compared with the Moser-Veselov equations") {
  claim.same_slip_as("eq_5_9");
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
  claim.same_slip_as("eq_5_9");
  claim.corrected(
      R"(M_{k+1} = \omega_{k-1}M_k\omega_{k-1}^{-1})", R"(M_{k+1} = \omega_kM_k\omega_k^{-1})",
      "The index of $\\omega$ is one too low. With it right, a constant momentum in space seen from the body "
      "obeys the line, and its difference quotient is $[M, \\xi]$: to first order at the ends of a step, to "
      "second half-way. With the index as printed it is so to first order only.");
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
  if (claim.fits_orders())
    for (auto const& group : rotation_groups()) {
      // M' = [M, xi] along any curve of attitudes; the line gives M at the end of a step from M at its start.
      auto const curve = draw_retracted_curve<S>(draw, group);
      auto const m = draw_skew<S>(draw, group);
      auto const attitude = [&](S const& t) { return curve(t).value; };
      auto const seen = [&](S const& t) { return Matrix<S>(attitude(t).transpose() * m * attitude(t)); };
      auto const bracket = [&](S const& t) {
        Matrix<S> const momentum = seen(t), xi = place_and_body_velocity(curve, t).second;
        return Matrix<S>(momentum * xi - xi * momentum);
      };
      std::vector<double> start, middle, inverse, printed;
      auto const missed = [](Matrix<S> const& a, Matrix<S> const& b) {
        return to_double(magnitude(Matrix<S>(a - b)));
      };
      for (double const length : difference_steps) {
        S const h(length);
        auto const rate = [&](Matrix<S> const& omega) {
          return Matrix<S>((omega * seen(S(0)) * omega.transpose() - seen(S(0))) / h);
        };
        Matrix<S> const omega = attitude(h).transpose() * attitude(S(0)),
                        earlier = attitude(S(0)).transpose() * attitude(S(-h)), there = bracket(S(h / 2));
        start.push_back(missed(rate(omega), bracket(S(0)))), middle.push_back(missed(rate(omega), there));
        inverse.push_back(missed(rate(omega.transpose()), there));
        printed.push_back(missed(rate(earlier), there));
      }
      claim.order("(M_k+1 - M_k)/h against [M, xi] at the start", group.name(), difference_steps, start, 1);
      claim.order("and half-way", group.name(), difference_steps, middle, 2);
      claim.order("with omega_{k-1}, as printed: to first order", group.name(), difference_steps, printed, 1);
      claim.refutes_order("with omega_{k-1}, as printed: half-way", group.name(), difference_steps, printed,
                          2);
      claim.refutes_order("with the inverse of omega_k", group.name(), difference_steps, inverse, 1);
    }
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
      "makes of it the second line of (5.9), over $h$. The first makes of it no element of $\\so(n)$; the "
      "skew part of that is the mean of the momenta at the two ends of the step.");
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
      "$M_k$ determines $\\omega_k$ only together with a branch: the one that grows out of the identity "
      "with the step. A momentum has other relative motions as well.");
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
