// Section 4.2, first part: invariant generating functions, the classical equation, and the system on the dual
// algebra that a discrete Lagrangian makes.

#include "actio/groupoid/generating_function.hpp"
#include "actio/groupoid/generating_series.hpp"
#include "actio/groupoid/hamilton_jacobi.hpp"
#include "actio/numbers/taylor.hpp"
#include "actio/reduction/natural_chart.hpp"
#include "actio/variational/lie_poisson.hpp"

#include "models/exact_motions.hpp"
#include "models/limits.hpp"
#include "models/sequences.hpp"
#include "models/top_in_any_group.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

/// An invariant generating function that was not made from a function on the group: the later configuration
/// comes first. The step of a left-invariant Lagrangian on TG through Cayley's chart.
template <class S>
struct InvariantFunction {
  AlgebraPolynomial<S> l;

  template <class T>
  T operator()(GroupElement<T> const& g, GroupElement<T> const& g0) const {
    Velocity<SpannedGroup, T> const c{g.group, g.group.vee(inverse_cayley((g * inverse(g0)).value))};
    return l(Ad(inverse(retract(c / T(2)) * g0), c));
  }
};
/// The action of a uniform field: with the mass matrix A and the force c,
/// \f$H = \tfrac12\langle p, A^{-1}p\rangle - \langle c, q\rangle\f$.
template <class S>
struct UniformField {
  Matrix<S> a, inverse_a;
  Vector<S> c;

  template <class T>
  T operator()(Vector<T> const& q, Vector<T> const& q0, T const& t) const {
    Vector<T> const way = q - q0, force = c.template cast<T>(), fall = inverse_a.template cast<T>() * force;
    return way.dot(a.template cast<T>() * way) / (t * 2) + (q + q0).dot(force) * t / 2 -
           force.dot(fall) * t * t * t / 24;
  }
  S energy(Vector<S> const& q, Vector<S> const& p) const { return p.dot(inverse_a * p) / S(2) - c.dot(q); }
};
/// The action of an oscillator, \f$H = (p^2/m + m\omega^2q^2)/2\f$.
template <class S>
struct Oscillator {
  S m, omega;

  template <class T>
  T operator()(Vector<T> const& q, Vector<T> const& q0, T const& t) const {
    using std::cos, std::sin;
    T const angle = t * T(omega);
    return ((q[0] * q[0] + q0[0] * q0[0]) * cos(angle) - q[0] * q0[0] * 2) * T(m * omega) / (sin(angle) * 2);
  }
};
/// The action along the polynomial motions of exact_motions.hpp, in entries: a Lagrangian that is not
/// quadratic, in bent coordinates.
template <class S>
struct ActionInEntries {
  ExactMotions<S> motions;
  Quadrature<S> rule{polynomial_degree};

  template <class T>
  Vector<T> start(Vector<T> const& q, Vector<T> const& q0, T const& t) const {
    return (motions.straight(q) - motions.straight(q0)) / t - motions.fall.template cast<T>() * (t / 2);
  }
  template <class T>
  T operator()(Vector<T> const& q, Vector<T> const& q0, T const& t) const {
    Vector<T> const u = motions.straight(q0), v = start(q, q0, t), f = motions.fall.template cast<T>();
    return rule(
        [&](T const& s) {
          return motions.in_straight(Vector<T>(u + v * s + f * (s * s / 2)), Vector<T>(v + f * s));
        },
        T(0), t);
  }
};

}  // namespace

STATEMENT(claim_4_2_invariant_generating_function,
          "an invariant generating function is one function of the relative motion") {
  claim.holds(
      "$S_L(f) = S(e, f)$: there is no other, since every $f$ is the relative motion of $(e, f)$. The "
      "canonical transformation is then equivariant.");
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    InvariantFunction<S> const generating{draw_algebra_polynomial<S>(draw, group.dimension())};
    auto const g = draw_configurations<S>(draw, group, 3);
    auto const e = identity<S>(group);
    auto const reduced = [&](GroupElement<S> const& f) { return generating(e, f); };
    auto const f = relative_motion_left(g[1], g[0]);  // g0^-1 g1: g[0] is the later configuration
    // Condition: configurations are inverted and turned into velocities by Cayley's transform.
    claim.equal("S is invariant", model, generating(g[2] * g[0], g[2] * g[1]), generating(g[0], g[1]), 10);
    claim.equal("S(g, g0) = S_L(g^-1 g0)", model, generating(g[0], g[1]), reduced(f), 10);
    claim.equal("any other pair over the same relative motion", model, generating(inverse(f) * e, e),
                reduced(f), 10);
    claim.equal("the transformation of momenta is equivariant", model,
                D1(generating, g[2] * g[0], g[2] * g[1]),
                coadjoint(inverse(g[2]), D1(generating, g[0], g[1])), 100);
    claim.equal("and of the momenta at the start", model, D2(generating, g[2] * g[0], g[2] * g[1]),
                coadjoint(inverse(g[2]), D2(generating, g[0], g[1])), 100);
    // Controls: a function that is not invariant; the relative motion that points forwards; the quotient by
    // the other side.
    auto const any = draw_pair_polynomial<S>(draw, group);
    claim.differs("no invariance", model, any(g[0], g[1]), any(e, f));
    claim.differs("S_L(g0^-1 g)", model, reduced(inverse(f)), reduced(f));
    claim.refutes("S_L(g0 g^-1)", model, several([&] {
                    auto const x = draw.template element<S>(group), y = draw.template element<S>(group);
                    return S(reduced(y * inverse(x)) - generating(x, y));
                  }),
                  size_of(reduced(f)));
  });
}

STATEMENT(claim_4_2_classical_hamilton_jacobi,
          "the classical Hamilton-Jacobi equation and the transformation that its solution generates") {
  claim.holds(
      "The action generates the flow itself. Another solution generates the flow after a "
      "fixed canonical transformation.");
  {
    int const n = 3;
    auto const kinetic = draw_algebra_polynomial<S>(draw, n);
    UniformField<S> const field{kinetic.a, inverse_matrix(kinetic.a), kinetic.c},
        free{kinetic.a, field.inverse_a, Vector<S>::Zero(n)};
    Vector<S> const q0 = draw_vector<S>(draw, n), p0 = draw_vector<S>(draw, n);
    S const t = S(1) + draw.template number<S>() / S(2);
    for (auto const* s : {&field, &free}) {
      std::string const model = s == &free ? "free particle" : "uniform field";
      Vector<S> const q = q0 + s->inverse_a * (p0 * t + s->c * (t * t / S(2))), p = p0 + s->c * t;
      auto const energy = [s](Vector<S> const& x, Vector<S> const& y) { return s->energy(x, y); };
      auto const scale = size_of(s->energy(q, p)) + size_of(q0) + size_of(p);
      // Condition: the configuration at the end is rounded, and divided by the mass.
      claim.zero("dS/dt + H(q, dS/dq)", model, hamilton_jacobi(*s, energy, q, q0, t), scale, 10);
      auto const momenta = generated_momenta(*s, q, q0, t);
      claim.equal("p0 = -dS/dq0", model, momenta.initial, p0, 10);
      claim.equal("p = dS/dq", model, momenta.final, p, 10);
      // Controls: the other sign of H; the other sign of a momentum.
      auto const opposite = [s](Vector<S> const& x, Vector<S> const& y) { return S(-s->energy(x, y)); };
      claim.refutes("dS/dt - H", model, hamilton_jacobi(*s, opposite, q, q0, t), scale);
      claim.differs("p0 = dS/dq0", model, Vector<S>(-momenta.initial), p0);
    }
    // Another solution: the field's action after the transformation that the free action over unit time
    // generates. Its p0 is that of the transformation, not that of the flow.
    Vector<S> const middle = q0 + field.inverse_a * p0,
                    q = middle + field.inverse_a * (p0 * t + field.c * (t * t / S(2)));
    auto const composed = [&](auto const& x, auto const& y, auto const& time) {
      using T = std::decay_t<decltype(time)>;
      // Stationary in the configuration between: a (m - y) = a (x - m)/t - c t/2.
      Vector<T> const fall = field.inverse_a.template cast<T>() * field.c.template cast<T>();
      Vector<T> const m = (y * time + x - fall * (time * time / 2)) / (time + T(1));
      return T(free(m, y, T(1)) + field(x, m, time));
    };
    auto const energy = [&](Vector<S> const& x, Vector<S> const& y) { return field.energy(x, y); };
    claim.zero("another solution", "uniform field", hamilton_jacobi(composed, energy, q, q0, t),
               size_of(field.energy(q, p0)) + size_of(q) + S(1), 10);
    claim.equal("another solution: p0 of its own transformation", "uniform field",
                generated_momenta(composed, q, q0, t).initial, p0, 10);
    claim.equal("another solution: p by the flow from there", "uniform field",
                generated_momenta(composed, q, q0, t).final, Vector<S>(p0 + field.c * t), 10);
    Vector<S> const by_the_flow = field.a * (q - q0) / t - field.c * (t / S(2));
    claim.differs("another solution: p0 of the flow", "uniform field",
                  generated_momenta(composed, q, q0, t).initial, by_the_flow);
  }
  // A Lagrangian that is not quadratic, in bent coordinates: H is the energy.
  over_groups(entry_groups(), claim, [&](auto const& group, auto const& model) {
    ActionInEntries<S> const s{draw_exact_motions<S>(draw, group)};
    Vector<S> const q0 = s.motions.read(draw.template element<S>(group, ratio<S>(1, 4)).value),
                    q = s.motions.read(draw.template element<S>(group, ratio<S>(1, 4)).value);
    S const t = ratio<S>(1, 2) + draw.template number<S>() / S(4);
    auto const lagrangian = [&](auto const& x, auto const& v) { return s.motions.in_entries(x, v); };
    // Velocities at both ends, of the entries.
    Vector<S> const u_rate = s.start(q, q0, t), later_rate = u_rate + s.motions.fall * t;
    Vector<S> const v0 = rates(s.motions.bent(moving(s.motions.straight(q0), u_rate))),
                    v = rates(s.motions.bent(moving(s.motions.straight(q), later_rate)));
    Vector<S> const p0 = momenta(lagrangian, q0, v0), p = momenta(lagrangian, q, v);
    auto const energy = [&](Vector<S> const& x, Vector<S> const& y) {
      return S(y.dot(v) - lagrangian(x, v));
    };
    auto const scale = size_of(p) * size_of(v) * S(Base<S>(4)) + size_of(lagrangian(q, v)) + S(1);
    auto const generated = generated_momenta(s, q, q0, t);
    // Condition: a difference of configurations over the time, cubed; integrals by a rule of fifteen nodes.
    claim.zero("dS/dt + H(q, dS/dq)", model, hamilton_jacobi(s, energy, q, q0, t), scale, 100);
    claim.zero("p0 = -dS/dq0", model, Vector<S>(generated.initial - p0), S(size_of(p0) + size_of(p)), 100);
    claim.zero("p = dS/dq", model, Vector<S>(generated.final - p), S(size_of(p0) + size_of(p)), 100);
    // Controls: the momenta exchanged; a Lagrangian with another force, whose S this is not.
    claim.differs("p and p0 exchanged", model, generated.initial, p);
    auto const heavier = [&](Vector<S> const& x, Vector<S> const& y) {
      return S(energy(x, y) + s.motions.c.dot(s.motions.straight(x)) * S(2));
    };
    claim.refutes("another force", model, hamilton_jacobi(s, heavier, q, q0, t), scale);
  });
  if (!exact_arithmetic<S>()) {
    using std::cos, std::sin;
    Oscillator<S> const s{ratio<S>(7, 5), ratio<S>(9, 4)};
    {
      Vector<S> const q0 = draw_vector<S>(draw, 1), p0 = draw_vector<S>(draw, 1);
      S const t = ratio<S>(1, 3), angle = s.omega * t;
      Vector<S> const q = q0 * S(cos(angle)) + p0 * S(sin(angle) / (s.m * s.omega)),
                      p = p0 * S(cos(angle)) - q0 * S(sin(angle) * s.m * s.omega);
      auto const energy = [&](Vector<S> const& x, Vector<S> const& y) {
        return S((y[0] * y[0] / s.m + s.m * s.omega * s.omega * x[0] * x[0]) / 2);
      };
      claim.zero("dS/dt + H(q, dS/dq)", "oscillator", hamilton_jacobi(s, energy, q, q0, t), energy(q, p), 10);
      claim.zero("p0 = -dS/dq0", "oscillator", Vector<S>(generated_momenta(s, q, q0, t).initial - p0),
                 S(s.m * s.omega), 10);
      claim.zero("p = dS/dq", "oscillator", Vector<S>(generated_momenta(s, q, q0, t).final - p),
                 S(s.m * s.omega), 10);
      claim.differs("the flow backwards", "oscillator", generated_momenta(s, q0, q, t).final, p);
    }
  }
}

STATEMENT(claim_4_2_left_legendre_map, "the Legendre map L*_g o dl, left-invariant case") {
  claim.convention(
      "As the Legendre map of a function on the group, which defines $\\Pi_{k-1}$ here. With $\\ell$ an "
      "action it is minus the body momentum, for which (3.18) has the same letter, with which the step "
      "from $g_{k-1}$ begins; (4.2) has the minus.");
  claim.same_slip_as("claim_3_2_legendre_limit");
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const l = draw_reduced_lagrangian<S>(draw, group);
    auto const g = draw_configurations<S>(draw, group, 2);
    auto const f = relative_motion_left(g[0], g[1]);
    auto const value = momentum_system_left(l, f).first;
    // The body momentum at the start of the step from g[0] to g[1]: minus the differential of the discrete
    // Lagrangian in its first argument, along g e_a.
    Vector<S> start_momentum(group.dimension()), by_definition = start_momentum;
    for (int a = 0; a < group.dimension(); ++a) {
      auto const e = basis_velocity<S>(group, a);
      start_momentum[a] = -lifted_left(l)(varied(g[0], from_right(g[0], e)), over<Dual<S>>(g[1])).part[0];
      by_definition[a] = slope(l, f, from_right(f, e));
    }
    claim.equal("L*_f l'(f) on matrices", model, column(value), by_definition);
    // Condition: a configuration is inverted.
    claim.equal("-L*_f l'(f) is the body momentum at the start", model, Vector<S>(-column(value)),
                start_momentum, 10);
    // Controls: taken for the body momentum; R* in place of L*; the relative motion that points forwards; the
    // momentum at the other end.
    claim.differs("L*_f l'(f) taken for the body momentum", model, column(value), start_momentum);
    claim.differs("R* in place of L*", model, column(-right_differential(l, f)), start_momentum);
    claim.differs("f_{k-1,k} in place of f_{k,k-1}", model, column(-left_differential(l, inverse(f))),
                  start_momentum);
    claim.differs("at g_k", model, column(coadjoint(g[1], D2(lifted_left(l), g[0], g[1]))), start_momentum);
  });
}

STATEMENT(eq_4_4, "a step of the dual algebra by two lines") {
  claim.convention(
      "With the $\\Pi$ that the page has just defined, $F\\ell(f)$, $f = f_{k+1,k}$: along a motion "
      "the second line is the first of the next step. For the body momenta of (3.18), $\\ell$ an "
      "action, both lines have the minus of (4.2); without it an even $\\ell$ runs backwards in time, "
      "any other in neither direction.");
  claim.same_slip_as("claim_3_2_legendre_limit");
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const f = draw_configurations<S>(draw, group, 3);
    auto const l = with_motions_left(draw_reduced_lagrangian<S>(draw, group), f);
    auto const g = configurations_left(draw.template element<S>(group), f);
    auto const scale = momenta_of(l, f);
    // Condition: configurations after three steps.
    auto const body = [&](int i) { return coadjoint(g[i], legendre_source(lifted_left(l), g[i], g[i + 1])); };
    Matrix<S> exchanged(group.dimension(), 2), next(group.dimension(), 2), momenta_as_printed = next,
                                                                           momenta_of_step = next;
    for (int k = 0; k < 2; ++k) {
      auto const step = momentum_system_left(l, f[k]);
      claim.zero("the first line with its minus: the body momentum at g_k", model, step.first + body(k),
                 scale, 10);
      claim.zero("the second line with its minus: the body momentum at g_{k+1}", model,
                 step.second + body(k + 1), scale, 10);
      momenta_as_printed.col(k) = column(step.second), momenta_of_step.col(k) = column(body(k + 1));
      claim.zero("the second line is the first line of the next step", model,
                 step.second - momentum_system_left(l, f[k + 1]).first, scale, 10);
      exchanged.col(k) = column(momentum_system_left(l, f[k + 1]).second), next.col(k) = column(step.first);
    }
    // Controls: the lines taken for body momenta; the translations exchanged; off a motion.
    claim.differs("the second line without its minus taken for the body momentum", model, momenta_as_printed,
                  momenta_of_step);
    claim.differs("L and R exchanged", model, exchanged, next);
    auto const off = several([&] {
      return column(momentum_system_left(l, f[0]).second -
                    momentum_system_left(l, draw.template element<S>(group)).first);
    });
    claim.refutes("off a motion", model, off, scale);
  });
}

STATEMENT(claim_4_2_system_and_dep, "the two lines and the discrete Euler-Poincare equation") {
  claim.convention(
      "One equation (3.11) joins two of these systems: the second line of one step and the first line of "
      "the next, with $\\Pi_k$ eliminated.");
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const f = draw_configurations<S>(draw, group, 2);
    auto const any = draw_reduced_lagrangian<S>(draw, group);
    auto const between = [&](auto const& k) {
      return column(momentum_system_left(k, f[1]).first - momentum_system_left(k, f[0]).second);
    };
    auto const scale = momenta_of(any, f);
    // Whatever the relative motions: the residual of (3.11), on matrices and from configurations, is what
    // Pi_k disagrees by.
    auto const g = configurations_left(draw.template element<S>(group), f);
    claim.zero("(3.11) on matrices", model,
               Vector<S>(reduced_residual_left(any, GroupElements<S>{f[0], f[1]}) - between(any)), scale);
    // Condition: configurations after two steps.
    claim.zero(
        "(3.2) in the body frame", model,
        column(coadjoint(g[1], discrete_euler_lagrange(lifted_left(any), g[0], g[1], g[2]))) - between(any),
        scale, 10);
    auto const l = with_motions_left(any, f);
    claim.zero("along a motion", model, between(l), momenta_of(l, f));
    // Controls: off a motion; the two relative motions exchanged; the right-invariant system.
    claim.refutes("off a motion", model, between(any), scale);
    claim.refutes("the relative motions exchanged", model,
                  column(momentum_system_left(l, f[0]).first - momentum_system_left(l, f[1]).second),
                  momenta_of(l, f));
    claim.refutes("L and R exchanged", model,
                  column(momentum_system_left(l, f[1]).second - momentum_system_left(l, f[0]).first),
                  momenta_of(l, f));
  });
}

STATEMENT(claim_4_2_dlp_consequence, "the momentum update that follows from the two lines") {
  claim.corrected(R"(\Pi_{k+1} = \mathrm{Ad}^*_{f_{k+1k}}\cdot\Pi_k)",
                  R"(\Pi_{k+1} = \mathrm{Ad}^*_{f_{k+1k}^{-1}}\cdot\Pi_k)",
                  "The inverse is missing, as in (3.18); (4.3) has it. Either sign of $\\Pi$ will do.");
  claim.same_slip_as("eq_3_18");
  claim.maybe_scan();
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const f = draw_configurations<S>(draw, group, 3);
    auto const l = with_motions_left(draw_reduced_lagrangian<S>(draw, group), f);
    auto const scale = momenta_of(l, f);
    Matrix<S> printed(group.dimension(), 3), star_lost(group.dimension(), 3), next(group.dimension(), 3);
    for (int k = 0; k < 3; ++k) {
      auto const step = momentum_system_left(l, f[k]);
      claim.zero("Ad*_{f^-1} takes the first line to the second", model,
                 coadjoint(inverse(f[k]), step.first) - step.second, scale, 10);
      claim.zero("(4.3) is the same update", model, final_momentum_left(f[k], step.first) - step.second,
                 scale, 10);
      printed.col(k) = column(Ad_star(f[k], step.first)),
      star_lost.col(k) = Ad_matrix(inverse(f[k])) * column(step.first), next.col(k) = column(step.second);
    }
    // Condition: three updates one after the other.
    auto carried = momentum_system_left(l, f[0]).first;
    for (auto const& step : f) carried = lie_poisson_update_left(step, carried);
    claim.zero("over three steps", model, carried - momentum_system_left(l, f[2]).second, scale, 100);
    claim.differs("as printed", model, printed, next);
    if (!has_invariant_metric(model)) claim.differs("the star lost", model, star_lost, next);
  });
}

// ----
// Section 4.2, second part: the Lie-Poisson Hamilton-Jacobi equation and the Poisson map that its solution
// generates.
//
// The reference solution is the power series in the time of a motion on a group, for a Hamiltonian with a
// cubic term and with coefficients in the scalar of the unit: equations between such series are checked power
// by power, over the rationals exactly.

namespace {

constexpr int known_powers = 6;

/// One of each kind: compact, with translations, without an invariant volume, all matrices.
std::vector<SpannedGroup> const& series_groups() {
  static std::vector<SpannedGroup> const groups = {spanned("SO(3)", SO<3>{}), spanned("SO(4)", SO<4>{}),
                                                   spanned("SE(3)", SE<3>{}), spanned("Aff(1)", Aff1{}),
                                                   spanned("GL(2)", GL<2>{})};
  return groups;
}
/// The coefficients of a left-invariant motion as power series in the time: of the relative motion, of the
/// body momentum and of the action.
template <class T>
struct MotionSeries {
  std::vector<Matrix<T>> f;
  std::vector<Vector<T>> pi;
  std::vector<T> action;
};
/// That of a Hamiltonian h = Pi.A Pi/2 + b.Pi + kappa (c.Pi)^3/3 up to \ref known_powers, its equations
/// written out: xi = dh(Pi), Pi' = ad*_xi Pi, f' = -xi f, S' = <Pi, xi> - h.
template <class T, class S>
MotionSeries<T> motion_series(AlgebraPolynomial<S> const& h, Momentum<SpannedGroup, T> const& pi0) {
  auto const& group = pi0.group;
  int const n = group.matrix_size(), d = group.dimension();
  MotionSeries<T> m{{Matrix<T>::Identity(n, n)}, {pi0.components}, {T(0)}};
  Matrix<T> const a = h.a.template cast<T>();
  Vector<T> const b = h.b.template cast<T>(), c = h.c.template cast<T>();
  std::vector<T> along;
  std::vector<Vector<T>> xi;
  std::vector<Matrix<T>> ad_star_of_xi;
  for (int k = 0; k < known_powers; ++k) {
    along.push_back(c.dot(m.pi[k]));
    T square(0);
    for (int i = 0; i <= k; ++i) square += along[i] * along[k - i];
    xi.push_back(a * m.pi[k] + c * T(square * T(h.kappa)));
    if (k == 0) xi[0] += b;
    ad_star_of_xi.push_back(ad_matrix(velocity(group, xi[k])).transpose());
    Vector<T> next = Vector<T>::Zero(d);
    Matrix<T> motion = Matrix<T>::Zero(n, n);
    T power = k == 0 ? T(-h(pi0)) : T(0);
    for (int i = 0; i <= k; ++i) {
      next += ad_star_of_xi[i] * m.pi[k - i];
      motion -= group.hat(xi[i]) * m.f[k - i];
      power += xi[i].dot(m.pi[k - i]);
    }
    T const by(k + 1);
    m.pi.push_back(next / by), m.f.push_back(motion / by), m.action.push_back(power / by);
  }
  return m;
}

/// A family of motions with their generating function, as power series in the time: S, the relative motion f
/// and the momentum, and how they vary.
template <class S>
struct Family {
  using Series = Taylor<S>;
  Matrix<Series> f, varied_f;
  Vector<Series> pi;
  Series s, varied_s;
  Momentum<SpannedGroup, S> pi0;

  /// \f$-\langle\mu, \delta f f^{-1}\rangle\f$ and \f$-\langle\mu, f^{-1}\delta f\rangle\f$: what dS does
  /// where \f$\mu\f$ is \f$-R_f^*dS\f$, \f$-L_f^*dS\f$.
  Series from_left(Vector<Series> const& mu) const {
    return -mu.dot(pi0.group.vee(Matrix<Series>(varied_f * inverse_matrix(f))));
  }
  Series from_right(Vector<Series> const& mu) const {
    return -mu.dot(pi0.group.vee(Matrix<Series>(inverse_matrix(f) * varied_f)));
  }
  Vector<Series> start() const { return pi0.components.template cast<Series>(); }
  /// \f$\partial S/\partial t\f$ with f held: the rate along the motion, less what comes from f, by
  /// \f$-R_f^*dS = \Pi\f$.
  Series time_rate() const {
    Matrix<Series> rate(f.rows(), f.cols());
    for (Index i = 0; i < f.size(); ++i) rate(i) = derivative(f(i));
    return derivative(s) + pi.dot(pi0.group.vee(Matrix<Series>(rate * inverse_matrix(f))));
  }
};
/// The motions that begin with a relative motion and a momentum that depend on a parameter, S being `start`
/// before.
template <class S>
Family<S> family(AlgebraPolynomial<S> const& h, Element<SpannedGroup, Dual<S>> const& before,
                 Momentum<SpannedGroup, Dual<S>> const& pi0, Dual<S> const& start) {
  using D = Dual<S>;
  auto const& group = pi0.group;
  auto const motion = motion_series(h, pi0);
  auto const series = [&](auto const& coefficient) {
    std::vector<S> value, rate;
    for (int k = 0; k <= known_powers; ++k)
      value.push_back(coefficient(k).value), rate.push_back(coefficient(k).part[0]);
    return std::pair(Taylor<S>::series(value), Taylor<S>::series(rate));
  };
  int const n = group.matrix_size(), d = group.dimension();
  Family<S> made{Matrix<Taylor<S>>(n, n), Matrix<Taylor<S>>(n, n), Vector<Taylor<S>>(d), {}, {},
                 {group, Vector<S>(d)}};
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      std::tie(made.f(i, j), made.varied_f(i, j)) =
          series([&](int k) { return D(motion.f[k].row(i).dot(before.value.col(j))); });
  for (int a = 0; a < d; ++a)
    made.pi[a] = series([&](int k) { return motion.pi[k][a]; }).first,
    made.pi0.components[a] = pi0.components[a].value;
  std::tie(made.s, made.varied_s) = series([&](int k) { return k == 0 ? start : motion.action[k]; });
  return made;
}
/// The action: motions from the identity with any momentum.
template <class S>
Family<S> action_family(SpannedGroup const& group, AlgebraPolynomial<S> const& h, Draw& draw) {
  auto const pi0 = draw.template momentum<S>(group), change = draw.template momentum<S>(group);
  auto moving = over<Dual<S>>(pi0);
  for (int a = 0; a < group.dimension(); ++a) moving.components[a].part[0] = change.components[a];
  return family(h, identity<Dual<S>>(group), moving, Dual<S>(S(0)));
}
/// Any other solution: a function k of the relative motion at time 0 generates a map to the momentum with
/// which the motion begins; S is k and the action together. `pi0` of it is the momentum before that map.
template <class S, class K>
Family<S> other_family(SpannedGroup const& group, AlgebraPolynomial<S> const& h, K const& k, Draw& draw) {
  auto const at = draw.template element<S>(group);
  auto const before = varied(at, from_left(draw.template velocity<S>(group), at));
  auto made = family(h, before, -right_differential(k, before), k(before));
  made.pi0 = -left_differential(k, at);
  return made;
}
template <class S>
auto size_of_terms(Family<S> const& m) {
  return magnitude(m.pi) * (magnitude(m.varied_f) + magnitude(m.f)) * magnitude(m.f) + magnitude(m.varied_s) +
         magnitude(m.s) + Base<S>(1);
}
/// h of a series.
template <class S>
Taylor<S> energy_of(Family<S> const& m, AlgebraPolynomial<S> const& h, Vector<Taylor<S>> const& pi) {
  return h(momentum(m.pi0.group, pi));
}

}  // namespace

STATEMENT(eq_4_1, "the Lie-Poisson Hamilton-Jacobi equation") {
  claim.convention(
      "The flow itself is generated by the action, the solution that begins at the identity. Checked "
      "for Hamiltonians with linear and cubic terms. For the action the left translation will do as "
      "well, since energy is conserved. A general solution needs the right translation, and generates "
      "the flow after a fixed Poisson map.");
  over_groups(series_groups(), claim, [&](auto const& group, auto const& model) {
    auto const h = draw_algebra_polynomial<S>(draw, group.dimension());
    auto const action = action_family(group, h, draw);
    auto const other = other_family(group, h, draw_group_polynomial<S>(draw, group), draw);
    for (auto const* m : {&action, &other}) {
      std::string const which = m == &action ? "the action: " : "another solution: ";
      auto const scale = size_of_terms(*m);
      auto const rate = m->time_rate();
      // Condition: f is inverted; coefficients of several factors add up.
      claim.zero(which + "-R* dS is the momentum at time t", model,
                 Taylor<S>(m->varied_s - m->from_left(m->pi)), scale, 10);
      claim.zero(which + "dS/dt + h(-R* dS)", model, Taylor<S>(rate + energy_of(*m, h, m->pi)), scale, 10);
      // Controls: the other sign of the momentum; the left translation, where it tells; the other sign of h.
      claim.refutes(which + "h(R* dS)", model, Taylor<S>(rate + energy_of(*m, h, Vector<Taylor<S>>(-m->pi))),
                    magnitude(rate));
      claim.refutes(which + "dS/dt - h", model, Taylor<S>(rate - energy_of(*m, h, m->pi)), magnitude(rate));
    }
    claim.zero("the action: dS/dt + h(-L* dS)", model,
               Taylor<S>(action.time_rate() + energy_of(action, h, action.start())), size_of_terms(action),
               10);
    claim.zero("another solution: -L* dS is its own momentum at the start", model,
               Taylor<S>(other.varied_s - other.from_right(other.start())), size_of_terms(other), 10);
    claim.refutes("another solution: dS/dt + h(-L* dS)", model,
                  Taylor<S>(other.time_rate() + energy_of(other, h, other.start())),
                  magnitude(other.time_rate()));
    claim.refutes("the action: -R* dS as the momentum at the start", model,
                  Taylor<S>(action.varied_s - action.from_left(action.start())), size_of_terms(action));
  });
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    // Right-invariant: inverses of left-invariant motions are right-invariant ones, with the opposite
    // momentum. So S(g^-1, t) with h(-mu) has the residual of S(g, t) with h, whether S is a solution or not.
    auto const p = draw_group_polynomial<S>(draw, group);
    Matrix<S> const a = draw_matrix<S>(draw, group.dimension(), group.dimension());
    Vector<S> const b = draw_vector<S>(draw, group.dimension());
    auto const energy = [&](S const& sign) {
      return [&, sign](auto const& mu) {
        return S(mu.components.dot(a * mu.components) + sign * b.dot(mu.components));
      };
    };
    auto const s = [&](auto const& g, auto const& time) {
      using T = std::decay_t<decltype(time)>;
      return T(T(p(g)) * (time * time + time));
    };
    auto const mirrored = [&](auto const& g, auto const& time) { return s(inverse(g), time); };
    auto const g = draw.template element<S>(group);
    S const t = ratio<S>(3, 4), left = hamilton_jacobi_left(s, energy(S(1)), g, t);
    // Condition: g is inverted, and its inverse differentiated.
    claim.equal("right-invariant, through the inverse", model,
                hamilton_jacobi_right(mirrored, energy(S(-1)), inverse(g), t), left, 30);
    claim.differs("right-invariant, with the translation of the left-invariant equation", model,
                  hamilton_jacobi_left(mirrored, energy(S(-1)), inverse(g), t), left);
    claim.differs("right-invariant, with the momentum not reversed", model,
                  hamilton_jacobi_right(mirrored, energy(S(1)), inverse(g), t), left);
  });
  if (!exact_arithmetic<S>()) {
    // As functions of g and t. Where l is invariant under Ad, S = t l(-log(g)/t).
    S const inertia = ratio<S>(7, 5), t = ratio<S>(3, 4);
    for (auto const& group : {spanned("SO(3)", SO<3>{}), spanned_su2(), spanned("SO(4)", SO<4>{})}) {
      auto const energy = [&](auto const& pi) {
        using T = typename std::decay_t<decltype(pi)>::Scalar;
        return T(pi.components.dot(pi.components) / T(inertia) / T(2));
      };
      auto const s = [&](auto const& g, auto const& time) {
        using T = std::decay_t<decltype(time)>;
        auto const x = log(g).coordinates;
        return T(x.dot(x) * T(inertia) / (time * 2));
      };
      auto const g = draw.template element<S>(group);
      auto const pi = -right_differential(at_time(s, t), g);
      // Condition: the logarithm is differentiated.
      claim.zero("S = |log g|^2/2t", group.name(), hamilton_jacobi_left(s, energy, g, t), energy(pi), 10);
      claim.refutes("S = |log g|^2/2t, at twice the time", group.name(),
                    S(time_derivative(s, g, S(t + t)) + energy(pi)), energy(pi));
    }
  }
}

STATEMENT(eq_4_2, "the initial momentum from the reduced generating function") {
  claim.holds(
      "Its $g$ is the relative motion $g(t)^{-1}g_0$: for a motion that starts at the identity it is the "
      "inverse of the configuration, not the configuration.");
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const l = draw_reduced_lagrangian<S>(draw, group);
    auto const g = draw_configurations<S>(draw, group, 2);  // the earlier configuration first
    auto const generating = [l = lifted_left(l)](auto const& later, auto const& earlier) {
      return l(earlier, later);
    };
    auto const f = relative_motion_left(g[0], g[1]);
    // p0 = -dS/dg0, in the body frame at g0.
    auto const pi0 = coadjoint(g[0], -D2(generating, g[1], g[0]));
    auto const as_printed = initial_momentum_left(l, f);
    // Condition: a configuration is inverted.
    claim.equal("-L*_g dS_L is -dS/dg0 in the body", model, as_printed, pi0, 10);
    // Controls: the sign; the other translation; the configuration in the role of its inverse.
    claim.differs("L*_g dS_L", model, -as_printed, pi0);
    claim.differs("-R*_g dS_L", model, -right_differential(l, f), pi0);
    claim.differs("at g_0^-1 g(t)", model, initial_momentum_left(l, inverse(f)), pi0);
  });
  over_groups(series_groups(), claim, [&](auto const& group, auto const& model) {
    // The physical momentum: along exact motions.
    auto const m = action_family(group, draw_algebra_polynomial<S>(draw, group.dimension()), draw);
    auto const scale = size_of_terms(m);
    claim.zero("the momentum with which the motion begins", model,
               Taylor<S>(m.varied_s - m.from_right(m.start())), scale, 10);
    claim.refutes("-R*_g dS_L", model, Taylor<S>(m.varied_s - m.from_left(m.start())), scale);
    claim.refutes("L*_g dS_L", model, Taylor<S>(m.varied_s + m.from_right(m.start())), scale);
  });
}

STATEMENT(eq_4_3, "the final momentum by the coadjoint action, and the Poisson map") {
  claim.convention(
      "With $\\Ad^*$ the dual of $\\Ad$, no inverse in the star. The map is a Lie-Poisson map for the "
      "minus bracket, and so for the plus bracket, whatever $S$ is.");
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const l = draw_reduced_lagrangian<S>(draw, group);
    auto const g = draw_configurations<S>(draw, group, 2);
    auto const generating = [l = lifted_left(l)](auto const& later, auto const& earlier) {
      return l(earlier, later);
    };
    auto const f = relative_motion_left(g[0], g[1]);
    auto const pi0 = initial_momentum_left(l, f);
    // p = dS/dg, in the body frame at g.
    auto const pi = coadjoint(g[1], D1(generating, g[1], g[0]));
    claim.equal("Ad*_{g^-1} Pi_0 is dS/dg in the body", model, final_momentum_left(f, pi0), pi, 10);
    claim.equal("and -R*_g dS_L", model, -right_differential(l, f), pi, 10);
    // Controls: no inverse, as in the last display of the section; no star.
    claim.differs("Ad*_g Pi_0", model, Ad_star(f, pi0), pi);
    if (!has_invariant_metric(model))
      claim.differs("Ad_{g^-1} Pi_0", model,
                    momentum(group, Vector<S>(Ad_matrix(inverse(f)) * pi0.components)), pi);

    // With g solved from Pi_0: d Pi_0 = -A theta and d Pi = -B theta. Condition: A is inverted.
    Matrix<S> const tangent =
        right_second_differential(l, f) * inverse_matrix(Matrix<S>([&] {
          // L* dS where f moves to e^theta f.
          Matrix<S> m(group.dimension(), group.dimension());
          over_batches(group.dimension(), [&](int first) {
            store_parts(m, left_differential(l, moved_left(f, first)).components, first);
          });
          return m;
        }()));
    auto const defect = [&](Matrix<S> const& t, Momentum<SpannedGroup, S> const& image) {
      return Matrix<S>(t * lie_poisson_tensor_plus(pi0) * t.transpose() - lie_poisson_tensor_plus(image));
    };
    claim.zero("Lie-Poisson defect of the map", model, defect(tangent, pi),
               S(magnitude(tangent) * magnitude(tangent) * size_of(pi0) + size_of(pi)), 100);
    // Controls: g another function of Pi_0; the momentum carried the wrong way.
    auto const other = several([&] {
      Matrix<S> const k =
          draw_matrix<S>(draw, group.dimension(), group.dimension()) / (S(2) * (S(1) + S(size_of(pi0))));
      auto const map = [&](auto const& at) {
        using T = std::decay_t<decltype(at.components[0])>;
        return final_momentum_left(retract(velocity(group, Vector<T>(k.template cast<T>() * at.components))),
                                   at);
      };
      Matrix<S> t(group.dimension(), group.dimension());
      over_batches(group.dimension(), [&](int first) {
        auto moved = over<Moved<S>>(pi0);
        for (int a = 0; a < batch && first + a < group.dimension(); ++a)
          moved.components[first + a].part[a] = S(1);
        store_parts(t, map(moved).components, first);
      });
      return defect(t, map(pi0));
    });
    claim.refutes("g another function of Pi_0", model, other, magnitude(lie_poisson_tensor_plus(pi0)));
  });
  over_groups(series_groups(), claim, [&](auto const& group, auto const& model) {
    auto const m = action_family(group, draw_algebra_polynomial<S>(draw, group.dimension()), draw);
    auto const scale = size_of_terms(m);
    Element<SpannedGroup, Taylor<S>> const f{group, m.f};
    auto const start = momentum(group, m.start());
    claim.zero("along the flow", model, Vector<Taylor<S>>(final_momentum_left(f, start).components - m.pi),
               scale, 10);
    claim.refutes("along the flow, Ad*_g", model, Vector<Taylor<S>>(Ad_star(f, start).components - m.pi),
                  magnitude(m.pi));
  });
}

// ----
// Section 4.2, third part: a discrete Lagrangian in the role of a generating function.
//
// Orders are fitted in double, against power series of equations written out by hand (top_in_any_group.hpp).

namespace {

/// Groups of the motions and of the fits.
std::vector<SpannedGroup> const& motion_groups() {
  static std::vector<SpannedGroup> const groups = {spanned("SO(3)", SO<3>{}), spanned("Aff(1)", Aff1{}),
                                                   spanned("SE(2)", SE<2>{})};
  return groups;
}

/// Groups for polynomials in all coordinates.
std::vector<SpannedGroup> const& polynomial_groups() {
  static std::vector<SpannedGroup> const groups = {spanned("SO(3)", SO<3>{}), spanned("SE(2)", SE<2>{}),
                                                   spanned("Aff(1)", Aff1{}), spanned("GL(2)", GL<2>{})};
  return groups;
}
/// The mean velocity w = -log(f)/t and the action over the time of a free motion, as power series in the time
/// up to \f$t^5\f$.
template <class S>
std::pair<Velocity<SpannedGroup, Taylor<S>>, Taylor<S>> mean_motion(
    QuadraticLagrangian<SpannedGroup, S> const& l, Momentum<SpannedGroup, S> const& pi0) {
  constexpr int known = 6;
  FreeMotionSeries<SpannedGroup, S> motion(l, pi0);
  for (int k = 0; k < known; ++k) motion.extend(l);
  // f = 1 + t x, and log(f)/t = x - t x^2/2 + t^2 x^3/3 - ...
  auto const over_time = [&](auto const& coefficient) {
    std::vector<S> c;
    for (int k = 1; k <= known; ++k) c.push_back(coefficient(k));
    return Taylor<S>::series(c);
  };
  int const n = l.group.matrix_size();
  Matrix<Taylor<S>> x(n, n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) x(i, j) = over_time([&](int k) { return motion.f[k](i, j); });
  auto const time = Taylor<S>::series({S(0), S(1), S(0), S(0), S(0), S(0)});
  Matrix<Taylor<S>> power = x, log = x;
  for (int k = 2; k <= known; ++k) {
    power = Matrix<Taylor<S>>(power * x) * time;
    log += power * Taylor<S>(ratio<S>(k % 2 ? 1 : -1, k));
  }
  return {-velocity(l.group, l.group.vee(log)), over_time([&](int k) { return motion.action[k]; })};
}

/// l(f) + l(1/f): does not know the direction of time.
template <class L>
struct EvenPart {
  L l;
  template <class T>
  T operator()(GroupElement<T> const& f) const { return l(f) + l(inverse(f)); }
};

/// A free left-invariant motion from the reference solution: the inverse of the configuration moves by the
/// right-invariant system with the opposite linear term.
template <class S>
struct Witness {
  TopInAnyGroup<S> mirror;

  QuadraticLagrangian<SpannedGroup, S> lagrangian() const {
    return {mirror.group, mirror.a, Vector<S>(-mirror.b)};
  }
  FreeMotion<SpannedGroup, S> motion(Momentum<SpannedGroup, S> const& pi0, S const& t) const {
    auto const xi = lagrangian().velocity_of(pi0);
    auto const [end, action] = mirror.flow(State<SpannedGroup, S>{identity<S>(mirror.group), -xi}, t);
    return {end.configuration,
            momentum(mirror.group, Vector<S>(-(mirror.a * end.velocity.coordinates + mirror.b))), action};
  }
};

/// For orders up to 6: many more steps would end in rounding, many fewer would show the next term.
Refinement const moderate{1.5, {16, 18, 20, 24, 28, 32}};
/// For order 2 in double.
Refinement const coarse{0.5, {16, 24, 32, 48, 64, 96}};

}  // namespace

STATEMENT(claim_4_2_hamilton_jacobi_identification,
          "a discrete Lagrangian in the role of the generating function") {
  claim.corrected(
      R"(\Pi_k = L_f^*\,d\ell(f),\quad \Pi_{k+1} = R_f^*\,d\ell(f))",
      R"(\Pi_k = -L_f^*\,d\ell(f),\quad \Pi_{k+1} = -R_f^*\,d\ell(f),\quad S_L = \ell)",
      "(4.2) has a minus that (4.4) lacks: with the momentum of (4.2) the printed system carries an even "
      "$\\ell$ backwards in time. With the signs, and $\\ell$ an action ($h$ times that of the thesis), it "
      "is (4.2) and (4.3) for every $\\ell$; its $g$ approximates the inverse of the configuration. The "
      "discrete Lagrangian of the natural chart is the first term of the series that solves (4.1).");
  claim.same_slip_as("claim_3_2_legendre_limit");
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const l = draw_group_polynomial<S>(draw, group);
    auto const f = draw.template element<S>(group);
    auto const system = momentum_system_left(l, f);
    auto const pi0 = initial_momentum_left(l, f), pi1 = final_momentum_left(f, pi0);
    claim.equal("(4.2) is the first line with a minus", model, -system.first, pi0);
    claim.equal("(4.3) is the second line with a minus", model, -system.second, pi1, 10);
    claim.differs("the first line as printed", model, system.first, pi0);
    claim.differs("l divided by a step of 3/7", model, ratio<S>(7, 3) * pi0, pi0);
    // An even l, as of a body: the printed system, begun with the momentum at the end, leads back to the
    // momentum at the start. Condition: a configuration is inverted.
    EvenPart<GroupPolynomial<S>> const even{l};
    auto const start = initial_momentum_left(even, f), end = final_momentum_left(f, start);
    auto const printed = momentum_system_left(even, inverse(f));
    claim.equal("even l, as printed: from the end ...", model, printed.first, end, 10);
    claim.equal("even l, as printed: ... back to the start", model, printed.second, start, 10);
    claim.differs("even l, as printed: forwards", model, momentum_system_left(even, f).first, start);
  });
  over_groups(polynomial_groups(), claim, [&](auto const& group, auto const& model) {
    // The series, power by power: at the mean velocity of a free motion, itself a power series in the time,
    // it is the action over the time.
    auto const kinetic = draw_algebra_polynomial<S>(draw, group.dimension());
    QuadraticLagrangian<SpannedGroup, S> const l(group, kinetic.a, kinetic.b);
    auto const [w, mean_action] = mean_motion(l, draw.template momentum<S>(group));
    auto const time = Taylor<S>::series({S(0), S(1), S(0), S(0), S(0), S(0)});
    auto series = generating_series(l, 4);
    auto const scale = S(magnitude(mean_action)) + S(magnitude(w.coordinates));
    // Condition: monomials of the sixth degree in coefficients that add up.
    claim.zero("the series of (4.1) is the action, up to t^6", model,
               Taylor<S>(series.mean_lagrangian(w, time) - mean_action), scale, 100);
    // Controls, at the power of t where each begins: the last term with the other sign; the first term alone.
    auto const off_at = [&](int power) {
      return S((series.mean_lagrangian(w, time) - mean_action).coefficient(power));
    };
    for (auto& [powers, c] : series.sigma[4].terms) c = -c;
    claim.refutes("the fourth-order term with the other sign, at t^4", model, off_at(4),
                  mean_action.coefficient(4));
    series.sigma.resize(1);
    claim.refutes("the natural chart alone, at t^2", model, off_at(2), mean_action.coefficient(2));
  });
  if (!exact_arithmetic<S>())
    for (auto const& group : motion_groups()) {
      Witness<S> const witness{draw_top_without_weight<S>(draw, group)};
      auto const l = witness.lagrangian();
      auto const pi0 = draw.template momentum<S>(group);
      S const t = ratio<S>(1, 3);
      auto const motion = witness.motion(pi0, t);
      auto const ours = free_motion_left(l, pi0, t);
      std::string const model = group.name();
      // Condition: two power series of some dozens of terms.
      claim.equal("the relative motion of the flow", model, ours.f.value, motion.f.value, 10);
      claim.equal("the momentum of the flow", model, ours.pi, motion.pi, 10);
      claim.equal("its action", model, ours.action, motion.action, 10);
      // A time that is too long for one series: twelve motions, the later factors of f first. Condition: what
      // each of them leaves is carried on by the rest.
      GroupElement<S> composed = identity<S>(group), exchanged = composed;
      auto pi = pi0;
      for (int k = 0; k < 12; ++k) {
        auto const part = witness.motion(pi, t);
        composed = part.f * composed, exchanged = exchanged * part.f, pi = part.pi;
      }
      auto const whole = free_motion_left(l, pi0, S(t * S(12)));
      claim.equal("the relative motion of a long time", model, whole.f.value, composed.value, 1000);
      claim.equal("the momentum after a long time", model, whole.pi, pi, 1000);
      claim.differs("its parts in the other order", model, whole.f.value, exchanged.value);
      // The action between configurations as a generating function, once, in fifty digits. Condition:
      // shooting over a third of a unit of time, and differentiated.
      auto const scale = S(size_of(pi0) + size_of(motion.pi) + Base<S>(1));
      if (claim.fits_orders_in_digits()) {
        ExactGeneratingFunction const exact{l};
        auto const generated = initial_momentum_left(at_time(exact, t), motion.f);
        claim.zero("S = the action: (4.2) gives the momentum at the start", model, generated - pi0, scale,
                   100);
        claim.zero("S = the action: (4.3) gives the momentum at the end", model,
                   final_momentum_left(motion.f, generated) - motion.pi, scale, 100);
        claim.zero("S = the action solves (4.1)", model,
                   S(time_derivative(exact, motion.f, t) + l(motion.pi)),
                   S(size_of(l(motion.pi)) + Base<S>(1)), 100);
      }
      // Controls: the first term of the series alone; the configuration in the role of its inverse.
      auto const chart = generating_series(l, 0);
      claim.refutes("the natural chart is not exact", model,
                    initial_momentum_left(at_time(chart, t), motion.f) - pi0, scale, 1e-4);
      claim.refutes("(4.2) at the configuration", model,
                    initial_momentum_left(at_time(chart, t), inverse(motion.f)) - pi0, scale);
    }
  if (claim.fits_orders())
    for (auto const& group : motion_groups()) {
      // The two lines of (4.4), with their minus and as printed, from the momentum of a motion.
      Witness<S> const any{draw_top_without_weight<S>(draw, group)};
      auto even = any;
      even.mirror.b.setZero();
      auto const pi0 = draw.template momentum<S>(group);
      auto const errors = [&](Witness<S> const& witness, double sign, double direction) {
        auto const l = witness.lagrangian();
        auto const end = witness.motion(pi0, S(direction * coarse.duration)).pi;
        return coarse.errors_of([&](int n, double h) {
          auto const step_of = natural_chart_lagrangian_left(l, h);
          auto pi = pi0;
          auto f = exp(S(-h) * l.velocity_of(S(sign) * pi));
          for (int k = 0; k < n; ++k) {
            auto const step = hamilton_jacobi_step_left(step_of, S(sign) * pi, f);
            f = step.g, pi = S(sign) * step.final;
          }
          return size_of(pi - end);
        });
      };
      auto const steps = coarse.step_lengths();
      claim.order("the two lines with their minus: the flow", group.name(), steps, errors(any, 1, 1), 2);
      claim.order("even l, as printed: the flow backwards in time", group.name(), steps, errors(even, -1, -1),
                  2);
      claim.refutes_order("even l, as printed: the flow", group.name(), steps, errors(even, -1, 1), 2);
      claim.refutes_order("any l, as printed: the flow", group.name(), steps, errors(any, -1, 1), 2);
      claim.refutes_order("any l, as printed: the flow backwards in time", group.name(), steps,
                          errors(any, -1, -1), 2);
    }
}

namespace {

/// How far the map that a generating function makes of momenta, along (4.2) and (4.3), is from a Poisson map,
/// at a relative motion g: its tangent, by the changes of both momenta as g moves.
template <class S, class F, class Final>
std::pair<Matrix<S>, Matrix<S>> poisson_sides(F const& s, GroupElement<S> const& g, Final const& final_of) {
  int const d = g.group.dimension();
  Matrix<S> at_start(d, d), at_end(d, d);
  for (int a = 0; a < d; ++a) {
    auto const moved = varied(g, from_right(g, basis_velocity<S>(g.group, a)));
    auto const start = initial_momentum_left(s, moved);
    at_start.col(a) = rates(start.components), at_end.col(a) = rates(final_of(moved, start).components);
  }
  auto const start = initial_momentum_left(s, g);
  Matrix<S> const tangent = at_end * inverse_matrix(at_start);
  return {Matrix<S>(tangent * lie_poisson_tensor_plus(start) * tangent.transpose()),
          lie_poisson_tensor_plus(final_of(g, start))};
}

}  // namespace

STATEMENT(claim_4_2_generated_map_poisson, "the map generated by a function on the group is Poisson") {
  claim.convention(
      "Where (4.2) determines $g$, that is where $-L_g^*dS_L$ is a local diffeomorphism. It is Poisson for "
      "every function on the group at each time, whether it solves (4.1) or not.");
  over_groups(few_groups(), claim, [&](auto const& group, auto const& model) {
    auto const s = draw_group_polynomial<S>(draw, group);
    auto const g = draw.template element<S>(group);
    auto const sides = poisson_sides<S>(
        s, g, [](auto const& at, auto const& start) { return final_momentum_left(at, start); });
    // Condition: the changes at the start are inverted, and the tangent enters twice.
    Matrix<S> const slopes = left_second_differential(s, g);
    double const condition = std::pow(to_double(row_norm(slopes) * row_norm(inverse_matrix(slopes))), 2);
    claim.equal("the bracket at the end, and the bracket at the start carried there", model, sides.first,
                sides.second, 10 * condition);
    auto const without =
        poisson_sides<S>(s, g, [](auto const& at, auto const& start) { return Ad_star(at, start); });
    claim.differs("carried by Ad*_g", model, without.first, without.second);
  });
}

STATEMENT(claim_4_2_approximate_solution, "an integrator from an approximate solution of (4.1)") {
  claim.convention(
      "The series of a quadratic Hamiltonian with a linear term, cut off at $t^r$ for even $r$: the "
      "residual of (4.1) and the integrator have the order $r + 2$. It is a Poisson map for every cut.");
  over_groups(few_groups(), claim, [&](auto const& group, auto const& model) {
    // What is left of a solution is a function on the group, at a time that is held.
    auto const s = draw_reduced_lagrangian<S>(draw, group);
    auto const g = draw.template element<S>(group);
    auto const pi0 = initial_momentum_left(s, g);
    // Condition: a configuration is inverted.
    claim.equal("(4.2) and (4.3): the momentum of (4.1) at the end", model, final_momentum_left(g, pi0),
                -right_differential(s, g), 10);
    claim.differs("carried by Ad*_g", model, Ad_star(g, pi0), -right_differential(s, g));
  });
  // In fifty digits: in double the smallest errors would be next to rounding.
  if (claim.fits_orders_in_digits())
    for (auto const& group : motion_groups()) {
      Witness<S> const witness{draw_top_without_weight<S>(draw, group)};
      auto const l = witness.lagrangian();
      // Three motions, and three mean velocities, together: the leading term of one may be small by chance.
      std::vector<Momentum<SpannedGroup, S>> starts, ends;
      std::vector<Velocity<SpannedGroup, S>> velocities;
      for (int i = 0; i < 3; ++i) {
        starts.push_back(draw.template momentum<S>(group, S(2)));
        ends.push_back(witness.motion(starts.back(), S(moderate.duration)).pi);
        velocities.push_back(draw.template velocity<S>(group, S(2)));
      }
      auto const residual = [&](auto const& s, double h) {
        S sum(0);
        for (auto const& w : velocities)
          sum += magnitude(S(hamilton_jacobi_left(s, l, exp(S(-h) * w), S(h))));
        return sum;
      };
      auto const run = [&](auto const& s, int n, double h, std::size_t motions, bool printed = false) {
        S sum(0);
        for (std::size_t i = 0; i < motions; ++i) {
          auto pi = starts[i];
          auto f = exp(S(-h) * l.velocity_of(pi));
          for (int k = 0; k < n; ++k) {
            auto const step = hamilton_jacobi_step_left(at_time(s, h), pi, f);
            f = step.g, pi = printed ? Ad_star(f, pi) : step.final;
          }
          sum += size_of(pi - ends[i]);
        }
        return sum;
      };
      for (int order : {0, 2, 4}) {
        auto const s = generating_series(l, order);
        std::string const terms = "terms up to t^" + std::to_string(order) + ": ";
        claim.order(terms + "residual of (4.1)", group.name(), moderate.step_lengths(),
                    moderate.errors_of([&](int, double h) { return residual(s, h); }), order + 2);
        claim.order(terms + "the integrator", group.name(), moderate.step_lengths(),
                    moderate.errors_of([&](int n, double h) { return run(s, n, h, 3); }), order + 2);
        // Of the controls one motion is enough.
        if (order == 0)
          claim.refutes_order("carried by Ad*_f", group.name(), moderate.step_lengths(),
                              moderate.errors_of([&](int n, double h) { return run(s, n, h, 1, true); }), 2);
        if (order == 0) continue;
        // Control: the last term with the other sign.
        auto wrong = s;
        for (auto& [powers, c] : wrong.sigma[order].terms) c = -c;
        claim.refutes_order(terms + "the last with the other sign", group.name(), moderate.step_lengths(),
                            moderate.errors_of([&](int n, double h) { return run(wrong, n, h, 1); }),
                            order + 2);
      }
    }
}

STATEMENT(claim_4_2_iterated_lie_poisson,
          "the discrete Lie-Poisson algorithm iterated is (4.3) with the composed relative motion") {
  claim.corrected(
      R"(g\approx g(t))", R"(g = f_N\cdots f_1 = g_N^{-1}g_0\approx g(t)^{-1}g_0)",
      "The solution $g$ of (4.2) is the composed motion, later factors first: for a motion that starts at "
      "the identity it approximates the inverse of the position $g(t)$. The rest is right: the generating "
      "function is the sum of $\\ell$ along the motion, as a function of the composed motion.");
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const f = draw_configurations<S>(draw, group, 3);
    auto const any = draw_reduced_lagrangian<S>(draw, group);
    auto const l = with_motions_left(any, f);
    auto const composed = f[2] * f[1] * f[0];
    auto const start = -momentum_system_left(l, f[0]).first, end = -momentum_system_left(l, f[2]).second;
    auto const scale = momenta_of(l, f);
    // Condition: three motions are multiplied, and inverted.
    claim.zero("(4.3): Ad* of the inverse of the composed motion takes the first momentum to the last", model,
               final_momentum_left(composed, start) - end, scale, 100);
    // Vary all three: what the sum of l does depends on the variation of their product alone, and is that of
    // (4.2) and of -R* dS.
    struct Varied {
      S sum, by_start, by_end;
    };
    auto const vary = [&](auto const& lagrangian) {
      Dual<S> sum(S(0));
      auto product = identity<Dual<S>>(group);
      for (auto const& step : f) {
        auto const moved = varied(step, from_left(draw.template velocity<S>(group), step));
        sum += lagrangian(moved), product = moved * product;
      }
      Matrix<S> const change = rate(product), back = inverse(composed).value;
      return Varied{sum.part[0], pair(start, velocity(group, group.vee(Matrix<S>(back * change)))),
                    pair(end, velocity(group, group.vee(Matrix<S>(change * back))))};
    };
    auto const v = vary(l);
    S const size = scale * S(magnitude(stacked(f)) * magnitude(stacked(f)));
    claim.zero("dS = -<Pi_0, g^-1 dg>: (4.2) for the composed motion", model, S(v.sum + v.by_start), size,
               100);
    claim.zero("dS = -<Pi_N, dg g^-1>", model, S(v.sum + v.by_end), size, 100);
    // Controls: the factors in the order of time; no inverse; off a motion, where no function of the product
    // has this differential.
    if (model != "Heisenberg")
      claim.differs("the factors in the order of time", model,
                    final_momentum_left(GroupElement<S>(f[0] * f[1] * f[2]), start), end);
    claim.differs("Ad* of the composed motion", model, Ad_star(composed, start), end);
    claim.refutes("the sum off a motion", model, several([&] {
                    auto const w = vary(any);
                    return S(w.sum + w.by_start);
                  }),
                  scale);
  });
  if (claim.fits_orders())
    for (auto const& group : motion_groups()) {
      Witness<S> const witness{draw_top_without_weight<S>(draw, group)};
      auto const l = witness.lagrangian();
      auto const pi0 = draw.template momentum<S>(group);
      auto const position = inverse(witness.motion(pi0, S(coarse.duration)).f);
      auto const composed = [&](int n, double h) {
        auto pi = pi0;
        auto f = exp(S(-h) * l.velocity_of(pi)), product = identity<S>(group);
        for (int k = 0; k < n; ++k) {
          auto const step = hamilton_jacobi_step_left(natural_chart_lagrangian_left(l, h), pi, f);
          f = step.g, pi = step.final, product = f * product;
        }
        return product;
      };
      claim.order(
          "the inverse of the composed motion is the position", group.name(), coarse.step_lengths(),
          coarse.errors_of([&](int n, double h) { return size_of(inverse(composed(n, h)) - position); }), 2);
      claim.refutes_order(
          "the composed motion is the position", group.name(), coarse.step_lengths(),
          coarse.errors_of([&](int n, double h) { return size_of(composed(n, h) - position); }), 2);
    }
}

// ----
// Section 4.2, fourth part: the square that joins the dynamics on the group and on the dual algebra.

namespace {

/// The groups of the square.
std::vector<SpannedGroup> const& square_groups() {
  static std::vector<SpannedGroup> const groups = {spanned("SO(3)", SO<3>{}),
                                                   spanned("SO(4)", SO<4>{}),
                                                   spanned("SE(3)", SE<3>{}),
                                                   spanned("Aff(1)", Aff1{}),
                                                   spanned_su2(),
                                                   spanned("GL(3)", GL<3>{})};
  return groups;
}

}  // namespace

STATEMENT(eq_4_5, "the square of group and dual-algebra dynamics") {
  claim.convention(
      "$\\Sigma$ takes $f_{k,k-1}$ to $f_{k+1,k}$ by (3.11); of the two the later one is the first factor "
      "of the product that Definition 4.1.1 holds fixed. Either sign of the Legendre map will do.");
  over_groups(square_groups(), claim, [&](auto const& group, auto const& model) {
    int const d = group.dimension();
    auto const f = draw_configurations<S>(draw, group, 2);
    auto const l = with_motions_left(draw_reduced_lagrangian<S>(draw, group), f);
    auto const down = [&](GroupElement<S> const& x) { return momentum_system_left(l, x).first; };
    auto const pi = down(f[0]);
    auto const scale = momenta_of(l, f);
    // f[0] solves the first line for pi; Lambda carries pi by it. Condition: a configuration is inverted.
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
    claim.zero("tangents: T F l o T Sigma = T Lambda o T F l", model,
               Matrix<S>(down1 * sigma - lambda * down0),
               S(magnitude(down1) * magnitude(sigma) + magnitude(lambda) * magnitude(down0)), 100);
    auto const image = coadjoint(inverse(f[0]), pi);
    claim.zero(
        "Lambda is a Poisson map", model,
        Matrix<S>(lambda * lie_poisson_tensor_plus(pi) * lambda.transpose() - lie_poisson_tensor_plus(image)),
        S(magnitude(lambda) * magnitude(lambda) * size_of(pi) + size_of(image)), 100);

    // Controls: the arrows of Sigma reversed; the other Legendre map; Lambda without its inverse; a relative
    // motion that (3.11) does not give.
    claim.refutes("Sigma the other way round", model, down(f[0]) - final_momentum_left(f[1], down(f[1])),
                  scale);
    claim.refutes("F l by R*", model,
                  right_differential(l, f[1]) - final_momentum_left(f[0], right_differential(l, f[0])),
                  scale);
    claim.refutes("Lambda by Ad*_f", model, down(f[1]) - Ad_star(f[0], pi), scale);
    claim.refutes("off a motion", model,
                  several([&] { return column(down(draw.template element<S>(group)) - image); }), scale);
  });
  if (!exact_arithmetic<S>())
    for (auto const& group : square_groups()) {
      // Both ways with solvers: a step on the group; a step on the dual, its relative motion looked for from
      // elsewhere.
      auto const l = draw_group_polynomial<S>(draw, group);
      auto const f = draw.template element<S>(group, ratio<S>(1, 16));
      auto const pi = momentum_system_left(l, f).first;
      auto const next = step_euler_poincare_left(l, f).value;
      auto const elsewhere = f * draw.template element<S>(group, ratio<S>(1, 32));
      auto const step = hamilton_jacobi_step_left(l, -pi, elsewhere);
      // Condition: a solver stops at 16 roundings of its unknown.
      claim.equal("with solvers", group.name(), momentum_system_left(l, next).first, -step.final, 100);
      claim.differs("with solvers, no step", group.name(), momentum_system_left(l, next).first, pi);
    }
}
