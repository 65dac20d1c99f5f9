// The schemes of chapter 5 as algorithms: which equation has which roots, what the motions approach, what
// they keep down to rounding, and over many steps.

#include "actio/linear_algebra/determinant.hpp"
#include "actio/reduction/discrete_euler_lagrange.hpp"
#include "actio/rigid_body/casimirs.hpp"
#include "actio/variational/lie_poisson.hpp"

#include "models/bodies.hpp"
#include "models/chart_update.hpp"
#include "models/enclosures.hpp"
#include "models/moser_veselov_runs.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

/// \f$f^T\Lambda-\Lambda f = P\f$ without f: \f$X = f^T\Lambda = E + P/2\f$ with E symmetric solves it where
/// \f$X^TX = \Lambda^2\f$, and then \f$f^T = X\Lambda^{-1}\f$ is orthogonal. E stands as its entries i <= j.
template <class S>
struct RootEquation {
  Vector<S> lambda;
  Matrix<S> p;

  template <class T>
  static Matrix<T> symmetric(Vector<T> const& entries, Index n) {
    Matrix<T> e(n, n);
    for (Index i = 0, k = 0; i < n; ++i)
      for (Index j = i; j < n; ++j, ++k) e(i, j) = e(j, i) = entries[k];
    return e;
  }
  template <class M>
  static auto entries_of(M const& e) {
    Index const n = e.rows();
    Vector<typename M::Scalar> entries(n * (n + 1) / 2);
    for (Index i = 0, k = 0; i < n; ++i)
      for (Index j = i; j < n; ++j, ++k) entries[k] = e(i, j);
    return entries;
  }
  /// The entries of \f$X^TX-\Lambda^2\f$.
  template <class T>
  Vector<T> operator()(Vector<T> const& entries) const {
    Matrix<T> const e = symmetric(entries, lambda.size()), half = p.template cast<T>() / T(2);
    Matrix<T> defect = (e - half) * (e + half);
    for (Index i = 0; i < lambda.size(); ++i) defect(i, i) -= T(S(lambda[i] * lambda[i]));
    return entries_of(defect);
  }
};
using Balls = Vector<Number>;
/// The middles of balls.
Balls middles(Balls const& x) {
  return x.unaryExpr([](Number const& ball) { return middle_of(ball); });
}
/// \f$E = \Lambda\f$ with signs: the roots at P = 0.
Balls diagonal_root(Balls const& lambda, std::vector<int> const& signs) {
  Matrix<Number> e = Matrix<Number>::Zero(lambda.size(), lambda.size());
  for (Index i = 0; i < lambda.size(); ++i) e(i, i) = lambda[i] * Number(signs[static_cast<std::size_t>(i)]);
  return RootEquation<Number>::entries_of(e);
}
/// Newton's method for a root near `e`, in the middles of the balls: where it ends, `one_zero_near` decides.
Balls root_near(RootEquation<Number> equation, Balls e) {
  equation.p = equation.p.unaryExpr([](Number const& ball) { return middle_of(ball); });
  for (int k = 0; k < 6; ++k) {
    auto const at = derivative(equation, e);
    Matrix<double> slope(e.size(), e.size());
    for (Index i = 0; i < e.size(); ++i)
      for (Index j = 0; j < e.size(); ++j) slope(i, j) = to_double(middle_of(at.matrix(i, j)));
    Matrix<Number> const back = inverse_matrix(slope).unaryExpr([](double y) { return Number(y); });
    e = middles(Balls(e - back * middles(at.value)));
  }
  return e;
}
/// The body of the enclosures: \f$\Lambda\f$ in n dimensions.
Balls lambda_of_balls(int n) {
  Balls lambda(n);
  for (int i = 0; i < n; ++i) lambda[i] = Number(1 << i);
  return lambda;
}
/// Exactly one root near that with `signs` for every P whose angles \f$P_{ij}/(\Lambda_i+\Lambda_j)\f$ are at
/// most `angle`: the box is divided into cells.
Enclosure one_root_for_all_data(std::vector<int> const& signs, Number const& angle, Number const& radius) {
  int const cells = 4;
  Balls const lambda = lambda_of_balls(3);
  Enclosure all{.shown = true, .margin = HUGE_VAL};
  for (int cell = 0; cell < cells * cells * cells && all.shown; ++cell) {
    Balls p(3);
    over_planes(3, [&](int a, int i, int j) {
      int const place = (a == 0 ? cell : a == 1 ? cell / cells : cell / cells / cells) % cells;
      Number const unit = (lambda[i] + lambda[j]) * angle,
                   low = Number(2 * place) / Number(cells) - Number(1);
      p[a] = Number::between(middle_of(unit * low), middle_of(unit * (low + Number(2) / Number(cells))));
    });
    RootEquation<Number> const equation{lambda, Turns{3}.hat(p)};
    auto const one = one_zero_near(equation, root_near(equation, diagonal_root(lambda, signs)), radius);
    all.shown = all.shown && one.shown, all.margin = std::min(all.margin, one.margin), all.boxes += one.boxes;
  }
  return all;
}
/// Whether balls about the root where two parts of the way join, within those of both, hold exactly one.
bool one_zero_at_joint(Balls const& lambda, Matrix<Number> const& goal, Balls const& root,
                       Number const& reach, Number const& reach_before) {
  RootEquation<Number> const at_joint{lambda, goal};
  return one_zero_near(at_joint, root, middle_of((reach < reach_before ? reach : reach_before) / Number(2)))
      .shown;
}
/// Exactly one root near the one that grows out of the identity, for every part t of a momentum, 0 <= t <= 1:
/// the way is divided until balls decide. Where two parts join, balls about the root that lie within those of
/// both hold exactly one root, too: it is the same one.
Enclosure one_root_along_the_step(Balls const& lambda, Matrix<Number> const& goal) {
  Enclosure all{.shown = true, .margin = HUGE_VAL};
  Balls root = diagonal_root(lambda, std::vector<int>(static_cast<std::size_t>(lambda.size()), 1));
  double from = 0, length = 0.25;
  Number reach_before(0);
  while (from < 1) {
    double const to = std::min(1.0, from + length);
    RootEquation<Number> const at_end{lambda, goal * Number(to)};
    RootEquation<Number> const between{lambda, goal * Number::between(Number(from), Number(to))};
    Balls const end = root_near(at_end, root), middle = middles(Balls((root + end) / Number(2)));
    Number const reach = magnitude(Balls(end - root)) * Number(3);
    Enclosure one;
    try {
      Enclosure const here = one_zero_near(between, middle, middle_of(reach));
      if (!(from > 0) || one_zero_at_joint(lambda, goal * Number(from), root, reach, reach_before))
        one = here;
    } catch (Undecided const&) {
    }
    ++all.boxes;
    if (one.shown) {
      all.margin = std::min(all.margin, one.margin);
      root = end, from = to, reach_before = reach, length *= 1.5;
    } else if ((length /= 2) < 1.0 / 512) {
      return {.shown = false, .margin = from, .boxes = all.boxes};
    }
  }
  return all;
}
/// \f$\det(\sigma+\Lambda^2+i\sqrt\sigma\,P) > 0\f$ for all \f$\sigma\ge0\f$, n = 3, at \f$\sigma =
/// w/(1-w)\f$: \f$D_1D_2D_3-\sigma\sum D_ip_i^2\f$ with \f$D_i = \sigma+\Lambda_i^2\f$.
Enclosure definite_for_all(Balls const& lambda, Balls const& p) {
  auto const determinant = [&](Number const& w) {
    Number const rest = Number(1) - w;
    Number product(1), sum(0);
    for (int i = 0; i < 3; ++i) {
      Number const d = w + lambda[i] * lambda[i] * rest;
      product *= d, sum += d * p[i] * p[i];
    }
    return Number(product - w * rest * sum);
  };
  return positive_along(determinant, Number(0), Number(1), 2048);
}

/// The momentum before a step with relative motion f, or after it, in coordinates.
template <class S, class T>
Vector<T> momenta_of(Matrix<S> const& lambda, Turn<T> const& f, bool after_it) {
  Matrix<T> const l = lambda.template cast<T>(),
                  p = after_it ? Matrix<T>(f.value * l) : Matrix<T>(l * f.value);
  return f.group.vee(Matrix<T>(p.transpose() - p));
}
/// \f$f^T\Pi f\f$ with the momentum before the step: on the orbit, but carried the wrong way.
template <class S, class T>
Vector<T> momenta_turned_back(Matrix<S> const& lambda, Turn<T> const& f) {
  Matrix<T> const m = f.group.hat(momenta_of(lambda, f, false));
  return f.group.vee(Matrix<T>(f.value.transpose() * m * f.value));
}
/// \f$[M, J^{-1}M]\f$ in coordinates.
template <class S>
Vector<S> momentum_rate(MovingBody<S> const& body, Vector<S> const& mu) {
  Turns const& group = body.group();
  Matrix<S> const m = group.hat(mu), xi = group.hat(Vector<S>(mu.cwiseQuotient(body.inertia.moments)));
  return group.vee(Matrix<S>(m * xi - xi * m));
}
/// A step of the explicit midpoint rule: of second order too, but not variational.
template <class S>
Vector<S> midpoint_step(MovingBody<S> const& body, Vector<S> const& mu, S const& h) {
  return mu + h * momentum_rate(body, Vector<S>(mu + momentum_rate(body, mu) * (h / S(2))));
}

}  // namespace

STATEMENT(claim_5_2_solvability, "solvability of the discrete Euler-Poincare equation for the next motion") {
  claim.convention(
      "For steps up to $h_{\\max}$, $1/h_{\\max} = \\max_{s>0} "
      "s\\,\\rho((s^2+\\Lambda^2)^{-1/2}\\,iM\\,(s^2+\\Lambda^2)^{-1/2})$ with $M$ the body "
      "momentum, where no $\\Lambda_i$ is negative: with $X = f^T\\Lambda$ any rotation $f$ that "
      "solves makes $s^2+\\Lambda^2+ishM$ a square $A^*A$ for all $s$, so beyond there is none. "
      "Below there are several, at least four on $\\SO(3)$ for short steps, and the one meant is "
      "that near $f_{kk-1}$, at a distance of second order in the step. For the body with $\\Lambda "
      "= 1, 2, 4$ (and 8) exactly one root is there, for every momentum in a box on $\\SO(3)$, and "
      "along growing steps up to $0.9\\,h_{\\max}$ on $\\SO(3)$ and $\\SO(4)$; the value of "
      "$h_{\\max}$, to a thousandth, on $\\SO(3)$.");
  claim.leaves(
      "That the equation has exactly one solution near the last relative motion is enclosed for one body, "
      "with entries 1, 2, 4 (and 8) of $\\Lambda$: on $\\SO(3)$ for all momenta in a box, and along one "
      "drawn direction of momentum up to nine tenths of the largest step; between there and the largest "
      "step, for other bodies and for $n > 4$ it is not shown.");
  over_bodies(claim, [&](int n, auto const& model) {
    // Why there is a bound: an identity for every rotation, motion or not.
    auto const lambda = draw_inertia<S>(draw, n);
    auto const f = draw_turn<S>(draw, n);
    S const t = S(2) + draw.template number<S>();
    Matrix<S> const one = identity_matrix<S>(n), x = f.value.transpose() * lambda, p = before(lambda, f),
                    pencil = one - t * p - t * t * lambda * lambda;
    claim.equal("(1 + t X^T)(1 - t X) = 1 - t P - t^2 Lambda^2, X = f^T Lambda", model,
                Matrix<S>((one + t * x.transpose()) * (one - t * x)), pencil);
    claim.differs("(1 - t X)(1 + t X^T)", model, Matrix<S>((one - t * x) * (one + t * x.transpose())),
                  pencil);
    // What the balls decide: every rotation is a root of the equation without f.
    RootEquation<S> const equation{lambda.diagonal(), p}, other{lambda.diagonal(), Matrix<S>(-p)};
    Vector<S> const root = equation.entries_of(Matrix<S>((x + x.transpose()) / S(2)));
    claim.zero("the symmetric part of X is a root of (E + P/2)^T (E + P/2) = Lambda^2", model, equation(root),
               magnitude(Matrix<S>(lambda * lambda)));
    claim.refutes("with -P in place of P", model, other(root), magnitude(Matrix<S>(lambda * lambda)));
    // At t = i/s it is (s^2 + Lambda^2 - i s P)/s^2 = A* A, A = 1 - i X/s: as real matrices, twice as large.
    Matrix<S> whole(2 * n, 2 * n), factor(2 * n, 2 * n);
    Matrix<S> const hermitian = t * t * one + lambda * lambda;
    whole << hermitian, t * p, -t * p, hermitian;
    factor << t * one, x, -x, t * one;
    claim.equal("s^2 + Lambda^2 - i s P = A* A", model, Matrix<S>(factor.transpose() * factor), whole);
    factor << t * one, x.transpose(), -x.transpose(), t * one;
    claim.differs("with f in place of f^T", model, Matrix<S>(factor.transpose() * factor), whole);
  });
  if (claim.fits_orders())
    over_bodies(claim, [&](int n, auto const& model) {
      // From two attitudes of the body: how far the next relative motion is from the last, and from another
      // rotation that solves the equation.
      auto const body = draw_moving_body<S>(draw, n);
      MoserVeselovEquation<Dynamic, S> const equation(body.group(), body.inertia.lambda,
                                                      body.inertia.moments);
      Turn<S> half_turn = identity<S>(body.group());
      half_turn.value(0, 0) = half_turn.value(1, 1) = S(-1);
      Turn<S> const g1{body.group(), body.start.attitude};
      std::vector<double> near, far;
      auto const steps = in_half_a_unit.step_lengths();
      for (double const h : steps) {
        auto const f10 = relative_motion_left(body.exact(S(-h)), g1);
        auto const goal = as_momentum(after(body.lambda, f10)).components;
        Solved<Turn<S>> other{half_turn, {}};
        claim.fact("Newton's method finds another root near a half turn", model,
                   equation.newton(goal, other));
        near.push_back(to_double(size_of(body.scheme(S(h)).step_euler_poincare(f10).value - f10)));
        far.push_back(to_double(size_of(other.value - f10)));
        claim.zero("another root", model,
                   Matrix<S>(before(body.lambda, other.value) - after(body.lambda, f10)), S(1),
                   10);  // of Newton's method, which leaves some roundings
      }
      claim.order("distance of f21 from f10", model, steps, near, 2);
      claim.refutes_order("distance of another root from f10", model, steps, far, 2);
    });
  claim.encloses("exactly one root near f10, all momenta in a box", "SO(3)", [] {
    return one_root_for_all_data({1, 1, 1}, Number(1) / Number(16), Number(1) / Number(6));
  });
  for (std::vector<int> const& signs : {std::vector<int>{1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}})
    claim.encloses("exactly one root near each half turn, all momenta in a box", "SO(3)", [&] {
      return one_root_for_all_data(signs, Number(1) / Number(64), Number(1) / Number(12));
    });
  if (!claim.takes_enclosures()) return;
  for (int n : {3, 4}) {
    // The direction of the momentum is drawn; its largest step comes from the library.
    auto const direction = draw_turning<S>(draw, n).coordinates;
    Vector<S> lambda(n);
    for (int i = 0; i < n; ++i) lambda[i] = S(1 << i);
    auto const inertia = inertia_from_lambda<Dynamic, S>(lambda);
    double const longest = Scheme<S>(inertia, S(1)).longest_step({Turns{n}, direction});
    std::vector<double> limit;
    for (Index a = 0; a < direction.size(); ++a) limit.push_back(longest * to_double(S(direction[a])));
    auto const part = [&](double share) {
      Balls p(static_cast<Index>(limit.size()));
      for (Index a = 0; a < p.size(); ++a) p[a] = Number(limit[static_cast<std::size_t>(a)]) * Number(share);
      return p;
    };
    claim.encloses("exactly one root near the last, steps growing to 0.9 h_max", name_of(n),
                   [&] { return one_root_along_the_step(lambda_of_balls(n), Turns{n}.hat(part(0.9))); });
    claim.refutes_enclosure("steps growing to 1.1 h_max", name_of(n), [&] {
      return one_root_along_the_step(lambda_of_balls(n), Turns{n}.hat(part(1.1)));
    });
    if (n > 3) continue;
    claim.encloses("s^2 + Lambda^2 + i s h M is definite for all s, h = 0.999 h_max", name_of(n),
                   [&] { return definite_for_all(lambda_of_balls(n), part(0.999)); });
    claim.refutes_enclosure("h = 1.001 h_max", name_of(n),
                            [&] { return definite_for_all(lambda_of_balls(n), part(1.001)); });
  }
}

STATEMENT(claim_5_2_convergence_to_the_flow,
          "convergence of the schemes for the rigid body, with the direction of time") {
  claim.holds(
      "To second order, forwards in time: (5.4), and the discrete Euler-Lagrange equations of Moser and "
      "Veselov for pairs of attitudes. That of Moser and Veselov with the step $-h$ undoes that with $h$.");
  if (!exact_arithmetic<S>() && claim.first())
    over_bodies(claim, [&](int n, auto const& model) {
      auto const body = draw_moving_body<S>(draw, n);
      S const h = ratio<S>(1, 8);
      auto const onwards = body.scheme(h), back = body.scheme(S(-h));
      auto m = body.first_momentum();
      for (int k = 0; k < 3; ++k) m = onwards.step_lie_poisson(m);
      auto twice = onwards.step_lie_poisson(m), returned = back.step_lie_poisson(m);
      for (int k = 1; k < 3; ++k)
        twice = onwards.step_lie_poisson(twice), returned = back.step_lie_poisson(returned);
      // Condition: six steps, each of which leaves 16 epsilon of the largest angle.
      claim.equal("three steps and three with -h", model, returned, body.first_momentum(), 16);
      claim.differs("three steps and three more", model, twice, body.first_momentum());
    });
  if (!claim.fits_orders()) return;
  Refinement const longer{2, {32, 64, 128, 256, 512, 1024}};
  over_bodies(claim, [&](int n, auto const& model) {
    auto const body = draw_moving_body<S>(draw, n);
    auto const steps = longer.step_lengths();
    Turn<S> const start{body.group(), body.start.attitude};
    BodyState<S> const end = body.flow(body.start, S(longer.duration), 32);
    auto const run = [&](auto const& next) {
      return errors_against(end, longer, [&](int count, S const& h) {
        auto const scheme = body.scheme(h);
        Turn<S> earlier = body.exact(S(-h)), at = start;
        for (int k = 0; k < count; ++k) {
          Turn<S> const later = next(scheme, earlier, at);
          earlier = at, at = later;
        }
        return BodyState<S>{scheme.momentum_after(relative_motion_left(earlier, at)).components, at.value};
      });
    };
    auto const onwards = run([](auto const& scheme, auto const& g0, auto const& g1) {
      return scheme.step_euler_lagrange(g0, g1);
    });
    claim.order("Moser-Veselov: attitude", model, steps, onwards.attitude, 2);
    claim.order("Moser-Veselov: momentum", model, steps, onwards.momentum, 2);
    // Reversed: g0 is looked for where g1, g2 are given.
    auto const reversed = run([](auto const& scheme, auto const& g0, auto const& g1) {
      return g1 * scheme.step_euler_poincare(inverse(relative_motion_left(g0, g1))).value;
    });
    claim.refutes_order("Moser-Veselov, solved for the attitude before: attitude", model, steps,
                        reversed.attitude, 2);
  });
  auto const steps = in_half_a_unit.step_lengths();
  for (auto const& group : rotation_groups()) {
    int const n = group.matrix_size();
    Vector<S> const moments = moments_of(draw_inertia<S>(draw, n));
    Matrix<S> const j = moments.asDiagonal();
    BodyFlow<S> const flow(group, j);
    Vector<S> const momentum = moments.cwiseProduct(draw_turning<S>(draw, n, ratio<S>(1, 2)).coordinates);
    BodyState<S> const start{momentum, draw_turn<S>(draw, n).value};
    ChartUpdate<S> const printed{group, j, inverse_matrix(j), S(0)};
    auto const errors = errors_of_chart_update(flow, start, printed);
    claim.order("natural charts, (5.4): attitude", group.name(), steps, errors.attitude, 2);
    claim.order("natural charts, (5.4): momentum", group.name(), steps, errors.momentum, 2);
  }
}

STATEMENT(claim_5_2_momentum_limit, "limit of the discrete body momentum") {
  claim.convention(
      "$M_k$ is $h$ times the physical momentum: $M_k/h \\to \\mathcal J\\xi$ at the start of the step, to "
      "first order along any curve and to second along motions of the body. Half-way through the step the "
      "mean of the momenta at its two ends is right to second order along any curve.");
  if (!claim.fits_orders()) {
    // With no limit: J xi is the derivative of M_k along g e^(t xi) at a step of no length.
    over_groups(rotation_groups(), claim, [&](auto const& group, auto const& model) {
      auto const lambda = draw_second_moments<S>(draw, group.matrix_size());
      auto const g = draw_rotation<S>(draw, group), xi = draw_skew<S>(draw, group);
      Matrix<Dual<S>> const big = lambda.template cast<Dual<S>>(), next = varying(g, Matrix<S>(g * xi)),
                            omega = next.transpose() * g.template cast<Dual<S>>();
      Matrix<S> const rate = rate_of(Matrix<Dual<S>>(omega.transpose() * big - big * omega)),
                      physical = inertia_operator(lambda, xi);
      claim.equal("M_k to first order along g e^(t xi)", model, rate, physical);
      claim.differs("J xi/2, by the pairing of (5.1)", model, rate, Matrix<S>(physical / S(2)));
      claim.differs("omega turned round", model,
                    rate_of(Matrix<Dual<S>>(omega * big - big * omega.transpose())), physical);
    });
    return;
  }
  auto const& steps = halving_steps();
  auto const missed = [](Matrix<S> const& a, Matrix<S> const& b) {
    return to_double(magnitude(Matrix<S>(a - b)));
  };
  for (auto const& group : rotation_groups()) {
    int const n = group.matrix_size();
    auto const lambda = draw_second_moments<S>(draw, n);
    auto const curve = draw_curve<S>(draw, group);
    auto const physical = [&](S const& t) {
      return inertia_operator(lambda,
                              Matrix<S>(group.hat(body_velocity(state_of(curve(moving(t)))).coordinates)));
    };
    auto const body = draw_moving_body<S>(draw, n);
    Turn<S> const at{body.group(), body.start.attitude};
    std::vector<double> start, middle, mean, half, motion, turned_round;
    for (double const length : steps) {
      S const h(length);
      Turn<S> const omega{Turns{n}, curve(h).value.transpose() * curve(S(0)).value};
      Matrix<S> const m = before(lambda, omega) / h, m_end = after(lambda, omega) / h;
      start.push_back(missed(m, physical(S(0)))), middle.push_back(missed(m, physical(h / S(2))));
      mean.push_back(missed((m + m_end) / S(2), physical(h / S(2))));
      half.push_back(missed(m, Matrix<S>(physical(S(0)) / S(2))));
      turned_round.push_back(missed(Matrix<S>(before(lambda, inverse(omega)) / h), physical(S(0))));
      auto const real = relative_motion_left(at, body.exact(h));
      motion.push_back(missed(Matrix<S>(before(body.lambda, real) / h), as_matrix(body.first_momentum())));
    }
    claim.order("M_k/h against J xi at the start, any curve", group.name(), steps, start, 1);
    claim.order("the mean of the two momenta against J xi half-way, any curve", group.name(), steps, mean, 2);
    claim.order("M_k/h against the momentum at the start, a motion of the body", group.name(), steps, motion,
                2);
    claim.refutes_order("M_k/h against J xi half-way, to second order", group.name(), steps, middle, 2);
    claim.refutes_order("M_k/h against J xi/2", group.name(), steps, half, 1);
    claim.refutes_order("omega turned round", group.name(), steps, turned_round, 1);
  }
}

STATEMENT(claim_5_2_manifest_preservation,
          "explicit step and preservation of the structure down to rounding") {
  claim.holds(
      "The update (5.8) is explicit once $f$ is known, and keeps all Casimirs and the momentum in space "
      "whatever rotation $f$ is; with the $f$ of (5.7) the whole step is a Poisson map. Only rounding "
      "remains, a few units in a step, in any number of digits.");
  for (int n = 3; n <= (numbers_grow() ? 4 : 5); ++n) {
    auto const model = name_of(n);
    auto const lambda = draw_inertia<S>(draw, n);
    auto const f = draw_turn<S>(draw, n), g = draw_turn<S>(draw, n);
    auto const pi = draw.template momentum<S>(Turns{n});
    // Whatever rotation f is.
    auto const carried = as_momentum(turned(f, as_matrix(pi)));
    claim.equal("Casimirs of f Pi f^T, any rotation", model, casimirs(carried), casimirs(pi));
    claim.equal("the momentum in space, any rotation", model, turned(g * inverse(f), as_matrix(carried)),
                turned(g, as_matrix(pi)));
    Matrix<S> const series = Matrix<S>::Identity(n, n) + as_matrix(pi) / S(4);
    claim.differs("1 + theta in place of a rotation: Casimirs", model,
                  casimirs(as_momentum(Matrix<S>(series * as_matrix(pi) * series.transpose()))),
                  casimirs(pi));
    // The step from momentum to momentum, by way of f: its derivative carries bracket to bracket.
    auto const start = [&](auto const& at) { return momenta_of(lambda, at, false); };
    auto const end = [&](auto const& at) { return momenta_of(lambda, at, true); };
    auto const wrong = [&](auto const& at) { return momenta_turned_back(lambda, at); };
    Matrix<S> const back = inverse_matrix(right_differentials(start, f));
    auto const defect = [&](auto const& momenta) {
      Matrix<S> const step = right_differentials(momenta, f) * back;
      auto const at = [&](auto const& which) {
        return lie_poisson_tensor_plus(BodyMomentum<S>{Turns{n}, which(f)});
      };
      return std::pair<Matrix<S>, Matrix<S>>{step * at(start) * step.transpose(), at(momenta)};
    };
    auto const [moved, there] = defect(end);
    // Condition: the derivative of the momentum with respect to f is inverted, which magnifies rounding by
    // the product of the largest entries.
    claim.equal("the step is a Poisson map", model, moved, there,
                10 + to_double(S(size_of(back) * magnitude(lambda))) * 4 * static_cast<double>(back.rows()));
    auto const [wrongly, elsewhere] = defect(wrong);
    claim.differs("f^T Pi f, on the same orbit: a Poisson map", model, wrongly, elsewhere);
  }
  if (!exact_arithmetic<S>() && claim.first())
    over_bodies(claim, [&](int n, auto const& model) {
      auto const body = draw_moving_body<S>(draw, n);
      S const h = ratio<S>(1, 8);
      auto const scheme = body.scheme(h);
      auto const first = body.first_momentum();
      auto m = first;
      Matrix<S> other = as_matrix(first);
      Turn<S> g{body.group(), body.start.attitude};
      for (int k = 0; k < 32; ++k) {
        auto const f = scheme.relative_motion(m).value;
        m = scheme.transport_by_increment(f, m), g = scheme.reconstruct(g, f);
        // (5.8) to first order in f - 1.
        Matrix<S> const part = scheme.relative_motion(as_momentum(other)).value.value - identity_matrix<S>(n);
        other += part * other + other * part.transpose();
      }
      // Thirty-two steps with less than ten roundings in each.
      claim.equal("Casimirs after 32 steps", model, casimirs(m), casimirs(first));
      claim.equal("momentum in space after 32 steps", model, turned(g, as_matrix(m)),
                  turned({body.group(), body.start.attitude}, as_matrix(first)));
      claim.zero("g^T g = 1 after 32 steps", model,
                 Matrix<S>(g.value.transpose() * g.value - identity_matrix<S>(n)), S(1));
      claim.differs("Casimirs after 32 steps of (5.8) to first order in f - 1", model,
                    casimirs(as_momentum(other)), casimirs(first));
    });
}

STATEMENT(claim_5_0_long_run_behaviour, "energy and Casimirs of the schemes over many steps") {
  claim.holds(
      "Over four thousand steps, in double: the scheme of Moser and Veselov keeps energy and Casimirs "
      "to rounding; that of natural charts, on $\\SO(3)$, keeps the Casimirs to rounding, and its "
      "energy in a band of second order in the step that does not widen. A rule of second order that "
      "is not variational loses both.");
  auto const energy = [](MovingBody<S> const& body, Vector<S> const& mu) {
    return S(mu.dot(mu.cwiseQuotient(body.inertia.moments)) / S(2));
  };
  if (!claim.fits_orders()) {
    // What the runs rest on, wherever there are no roots: one step of each, for any rotation.
    over_bodies(claim, [&](int n, auto const& model) {
      auto const lambda = draw_inertia<S>(draw, n);
      Vector<S> const moments = moments_of(lambda);
      auto const f = draw_turn<S>(draw, n);
      auto const twice_energy = [&](Vector<S> const& mu) { return S(mu.dot(mu.cwiseQuotient(moments))); };
      Vector<S> const start = momenta_of(lambda, f, false), end = momenta_of(lambda, f, true);
      claim.equal("energy after a step of Moser and Veselov", model, twice_energy(end), twice_energy(start));
      claim.equal("Casimirs after it", model, casimirs(BodyMomentum<S>{Turns{n}, end}),
                  casimirs(BodyMomentum<S>{Turns{n}, start}));
      ChartLagrangian<S> const chart{Matrix<S>(moments.asDiagonal())};
      claim.differs("energy after a step in Cayley's chart", model,
                    twice_energy(right_differential(chart, f).components),
                    twice_energy(left_differential(chart, f).components), 1e-5);
    });
    return;
  }
  int const count = 4000;
  S const h = ratio<S>(1, 4);
  for (int n : {3, 4}) {
    auto const model = name_of(n);
    auto const body = draw_moving_body<S>(draw, n);
    auto const scheme = body.scheme(h);
    auto const first = body.first_momentum();
    auto m = first;
    Vector<S> other = first.components;
    for (int k = 0; k < count; ++k) m = scheme.step_lie_poisson(m), other = midpoint_step(body, other, h);
    // Condition: at most three roundings in each step, of which none is recovered.
    claim.equal("Moser-Veselov: energy", model, energy(body, m.components), energy(body, first.components),
                count / 100.0);
    claim.equal("Moser-Veselov: Casimirs", model, casimirs(m), casimirs(first), count / 100.0);
    claim.differs("explicit midpoint rule: energy", model, energy(body, other),
                  energy(body, first.components));
    claim.differs("explicit midpoint rule: Casimirs", model, casimirs(BodyMomentum<S>{Turns{n}, other}),
                  casimirs(first));
  }
  // Natural charts.
  SpannedGroup const group = rotation_groups()[0];
  auto const body = draw_moving_body<S>(draw, 3);
  Matrix<S> const j = body.inertia.moments.asDiagonal();
  ChartUpdate<S> update{group, j, inverse_matrix(j), h};
  // Largest and least energy of the body, over a number of steps, less that at their beginning.
  auto const band = [&](Algebra<S>& zeta, int steps) {
    S low = energy(body, update.momentum_after(zeta)), high = low;
    for (int k = 0; k < steps; ++k) {
      zeta = update.next(zeta);
      S const now = energy(body, update.momentum_after(zeta));
      low = now < low ? now : low, high = now > high ? now : high;
    }
    return S(high - low);
  };
  Vector<S> const xi = body.flow.velocity(body.start.momentum);
  Algebra<S> zeta{group, Vector<S>(-xi)};
  Vector<S> const square_at_start = update.momentum_after(zeta);
  S const early = band(zeta, count / 4);
  for (int k = 0; k < count / 2; ++k) zeta = update.next(zeta);
  S const late = band(zeta, count / 4);
  claim.equal("natural charts: the Casimir", "SO(3)", S(update.momentum_after(zeta).squaredNorm()),
              S(square_at_start.squaredNorm()), count / 100.0);
  claim.fact("natural charts: the band of the energy does not widen", "SO(3)",
             late < early * ratio<S>(11, 10));
  std::vector<double> steps, widths;
  for (int per_unit = 8; per_unit <= 256; per_unit *= 2) {
    update.h = S(1) / S(per_unit);
    Algebra<S> from{group, Vector<S>(-xi)};
    steps.push_back(1.0 / per_unit), widths.push_back(to_double(band(from, 8 * per_unit)));
  }
  claim.order("natural charts: width of the band of the energy", "SO(3)", steps, widths, 2);
}
