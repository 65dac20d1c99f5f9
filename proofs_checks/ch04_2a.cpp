// Section 4.2, first part: invariant generating functions, the classical equation, and the system on the dual algebra that a discrete Lagrangian makes.
// Compiled once per scalar.
//
// Degrees, as polynomials in what was drawn after clearing denominators: places are Cayley transforms, of degree 4 over a determinant of degree 4; a generating function
// is cubic in a place and its quotient, below 40; with the motions by design of sequences.hpp below 300. Cayley's transform of a quotient, and a cubic Lagrangian of that,
// stay below 300 as well. The bounds say more.
#include "actio/groupoid/hamilton_jacobi.hpp"
#include "exact_motions.hpp"
#include "sequences.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

/// An invariant generating function that was not made from a function on the group: the later place comes first. The step of a left-invariant Lagrangian on TG through Cayley's chart.
template <class S>
struct InvariantFunction {
  AlgebraPolynomial<S> l;

  template <class T>
  T operator()(Place<T> const& g, Place<T> const& g0) const {
    Velocity<SpannedGroup, T> const c{g.group, g.group.vee(inverse_cayley((g * inverse(g0)).value))};
    return l(Ad(inverse(retract(c / T(2)) * g0), c));
  }
};
/// S(g, g0) from a function of pairs with the earlier place first.
template <class L>
auto later_first(L lagrangian) {
  return [lagrangian](auto const& g, auto const& g0) { return lagrangian(g0, g); };
}
/// The action of a uniform field: with the mass matrix A and the force c, \f$H = \tfrac12\langle p, A^{-1}p\rangle - \langle c, q\rangle\f$.
template <class S>
struct UniformField {
  Matrix<S> a, inverse_a;
  Vector<S> c;

  template <class T>
  T operator()(Vector<T> const& q, Vector<T> const& q0, T const& t) const {
    Vector<T> const way = q - q0, force = c.template cast<T>(), fall = inverse_a.template cast<T>() * force;
    return way.dot(a.template cast<T>() * way) / (t * 2) + (q + q0).dot(force) * t / 2 - force.dot(fall) * t * t * t / 24;
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
/// The action along the polynomial motions of exact_motions.hpp, in entries: a Lagrangian that is not quadratic, in bent coordinates.
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
    return rule([&](T const& s) { return motions.in_straight(Vector<T>(u + v * s + f * (s * s / 2)), Vector<T>(v + f * s)); }, T(0), t);
  }
};

}  // namespace

STATEMENT(claim_4_2_invariant_generating_function, "an invariant generating function is one function of the relative motion") {
  claim.holds("S_L(f) = S(e, f): there is no other, since every f is the relative motion of (e, f). The canonical transformation is then equivariant.");
  claim.degree(2000);
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    InvariantFunction<S> const generating{draw_algebra_polynomial<S>(draw, group.dimension())};
    auto const g = draw_places<S>(draw, group, 3);
    auto const e = identity<S>(group);
    auto const reduced = [&](Place<S> const& f) { return generating(e, f); };
    auto const f = relative_motion_left(g[1], g[0]);  // g0^-1 g1: g[0] is the later place
    // Condition: places are inverted and turned into velocities by Cayley's transform.
    claim.equal("S is invariant", model, generating(g[2] * g[0], g[2] * g[1]), generating(g[0], g[1]), 10);
    claim.equal("S(g, g0) = S_L(g^-1 g0)", model, generating(g[0], g[1]), reduced(f), 10);
    claim.equal("any other pair over the same relative motion", model, generating(inverse(f) * e, e), reduced(f), 10);
    claim.equal("momenta move along: the transformation is equivariant", model, D1(generating, g[2] * g[0], g[2] * g[1]), coadjoint(inverse(g[2]), D1(generating, g[0], g[1])), 100);
    // Controls: a function that is not invariant; the relative motion that looks ahead; the quotient by the other side.
    auto const any = draw_pair_polynomial<S>(draw, group);
    claim.differs("no invariance", model, any(g[0], g[1]), any(e, f), 1e-4);
    claim.differs("S_L(g0^-1 g)", model, reduced(inverse(f)), reduced(f), 1e-4);
    claim.refutes("S_L(g0 g^-1)", model, several([&] {
                    auto const x = draw.template element<S>(group), y = draw.template element<S>(group);
                    return S(reduced(y * inverse(x)) - generating(x, y));
                  }), size_of(reduced(f)), 1e-4);
  });
}

STATEMENT(claim_4_2_classical_hamilton_jacobi, "the classical Hamilton-Jacobi equation and the transformation that its solution generates") {
  claim.holds("The action generates the flow itself. Another solution generates the flow after a fixed canonical transformation.");
  claim.degree(1000);
  // A uniform field, in any frame: motions are parabolas.
  for (int point = 0; point < exact_points; ++point) {
    int const n = 3;
    auto const kinetic = draw_algebra_polynomial<S>(draw, n);
    UniformField<S> const field{kinetic.a, inverse_matrix(kinetic.a), kinetic.c}, free{kinetic.a, field.inverse_a, Vector<S>::Zero(n)};
    Vector<S> const q0 = draw_vector<S>(draw, n), p0 = draw_vector<S>(draw, n);
    S const t = S(1) + draw.template number<S>() / S(2);
    for (auto const* s : {&field, &free}) {
      std::string const model = s == &free ? "free particle" : "uniform field";
      Vector<S> const q = q0 + s->inverse_a * (p0 * t + s->c * (t * t / S(2))), p = p0 + s->c * t;
      auto const energy = [s](Vector<S> const& x, Vector<S> const& y) { return s->energy(x, y); };
      auto const scale = size_of(s->energy(q, p)) + size_of(q0) + size_of(p);
      // Condition: the place at the end is rounded, and divided by the mass.
      claim.zero("dS/dt + H(q, dS/dq)", model, hamilton_jacobi(*s, energy, q, q0, t), scale, 10);
      auto const momenta = generated_momenta(*s, q, q0, t);
      claim.equal("p0 = -dS/dq0", model, momenta.initial, p0, 10);
      claim.equal("p = dS/dq", model, momenta.final, p, 10);
      // Controls: the other sign of H; the other sign of a momentum.
      auto const opposite = [s](Vector<S> const& x, Vector<S> const& y) { return S(-s->energy(x, y)); };
      claim.refutes("dS/dt - H", model, hamilton_jacobi(*s, opposite, q, q0, t), scale);
      claim.differs("p0 = dS/dq0", model, Vector<S>(-momenta.initial), p0);
    }
    // Another solution: the field's action after the transformation that the free action over unit time generates. Its p0 is that of the transformation, not that of the flow.
    Vector<S> const middle = q0 + field.inverse_a * p0, q = middle + field.inverse_a * (p0 * t + field.c * (t * t / S(2)));
    auto const composed = [&](auto const& x, auto const& y, auto const& time) {
      using T = std::decay_t<decltype(time)>;
      // Stationary in the place between: a (m - y) = a (x - m)/t - c t/2.
      Vector<T> const fall = field.inverse_a.template cast<T>() * field.c.template cast<T>();
      Vector<T> const m = (y * time + x - fall * (time * time / 2)) / (time + T(1));
      return T(free(m, y, T(1)) + field(x, m, time));
    };
    auto const energy = [&](Vector<S> const& x, Vector<S> const& y) { return field.energy(x, y); };
    claim.zero("another solution", "uniform field", hamilton_jacobi(composed, energy, q, q0, t), size_of(field.energy(q, p0)) + size_of(q) + S(1), 10);
    claim.equal("another solution: p0 of its own transformation", "uniform field", generated_momenta(composed, q, q0, t).initial, p0, 10);
    Vector<S> const by_the_flow = field.a * (q - q0) / t - field.c * (t / S(2));
    claim.differs("another solution: p0 of the flow", "uniform field", generated_momenta(composed, q, q0, t).initial, by_the_flow);
  }
  // A Lagrangian that is not quadratic, in bent coordinates: H is the energy.
  over_groups(entry_groups(), claim, [&](auto const& group, auto const& model) {
    ActionInEntries<S> const s{draw_exact_motions<S>(draw, group)};
    Vector<S> const q0 = s.motions.read(draw.template element<S>(group, ratio<S>(1, 4)).value), q = s.motions.read(draw.template element<S>(group, ratio<S>(1, 4)).value);
    S const t = ratio<S>(1, 2) + draw.template number<S>() / S(4);
    auto const lagrangian = [&](auto const& x, auto const& v) { return s.motions.in_entries(x, v); };
    // Velocities at both ends, of the entries.
    Vector<S> const u_rate = s.start(q, q0, t), later_rate = u_rate + s.motions.fall * t;
    Vector<S> const v0 = rates(s.motions.bent(moving(s.motions.straight(q0), u_rate))), v = rates(s.motions.bent(moving(s.motions.straight(q), later_rate)));
    Vector<S> const p0 = momenta(lagrangian, q0, v0), p = momenta(lagrangian, q, v);
    auto const energy = [&](Vector<S> const& x, Vector<S> const& y) { return S(y.dot(v) - lagrangian(x, v)); };
    auto const scale = size_of(p) * size_of(v) * S(Base<S>(4)) + size_of(lagrangian(q, v)) + S(1);
    auto const generated = generated_momenta(s, q, q0, t);
    // Condition: a difference of places over the time, cubed; integrals by a rule of fifteen nodes.
    claim.zero("dS/dt + H(q, dS/dq)", model, hamilton_jacobi(s, energy, q, q0, t), scale, 100);
    claim.zero("p0 = -dS/dq0", model, Vector<S>(generated.initial - p0), S(size_of(p0) + size_of(p)), 100);
    claim.zero("p = dS/dq", model, Vector<S>(generated.final - p), S(size_of(p0) + size_of(p)), 100);
    // Controls: the momenta exchanged; a Lagrangian with another force, whose S this is not.
    claim.differs("p and p0 exchanged", model, generated.initial, p);
    auto const heavier = [&](Vector<S> const& x, Vector<S> const& y) { return S(energy(x, y) + s.motions.c.dot(s.motions.straight(x)) * S(2)); };
    claim.refutes("another force", model, hamilton_jacobi(s, heavier, q, q0, t), scale);
  });
  if constexpr (Real<S>) {
    using std::cos, std::sin;
    Oscillator<S> const s{ratio<S>(7, 5), ratio<S>(9, 4)};
    for (int point = 0; point < 2; ++point) {
      Vector<S> const q0 = draw_vector<S>(draw, 1), p0 = draw_vector<S>(draw, 1);
      S const t = ratio<S>(1, 3), angle = s.omega * t;
      Vector<S> const q = q0 * S(cos(angle)) + p0 * S(sin(angle) / (s.m * s.omega)), p = p0 * S(cos(angle)) - q0 * S(sin(angle) * s.m * s.omega);
      auto const energy = [&](Vector<S> const& x, Vector<S> const& y) { return S((y[0] * y[0] / s.m + s.m * s.omega * s.omega * x[0] * x[0]) / 2); };
      claim.zero("dS/dt + H(q, dS/dq)", "oscillator", hamilton_jacobi(s, energy, q, q0, t), energy(q, p), 10);
      claim.zero("p0 = -dS/dq0", "oscillator", Vector<S>(generated_momenta(s, q, q0, t).initial - p0), S(s.m * s.omega), 10);
      claim.zero("p = dS/dq", "oscillator", Vector<S>(generated_momenta(s, q, q0, t).final - p), S(s.m * s.omega), 10);
      claim.differs("the flow backwards", "oscillator", generated_momenta(s, q0, q, t).final, p);
    }
  }
}

STATEMENT(claim_4_2_left_legendre_map, "the Legendre map L*_g o dl, left-invariant case") {
  claim.convention("With l an action, its value at f_{k,k-1} is minus the body momentum with which the step leaves g_{k-1}.");
  claim.degree(2000);
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const l = draw_reduced_lagrangian<S>(draw, group);
    auto const g = draw_places<S>(draw, group, 2);
    auto const f = relative_motion_left(g[0], g[1]);
    auto const value = momentum_system_left(l, f).first;
    // What the step from g[0] to g[1] takes up, as the body at g[0] feels it: the differential of the discrete Lagrangian in its first place.
    auto const left_behind = coadjoint(g[0], D1(lifted_left(l), g[0], g[1]));
    // Condition: a place is inverted.
    claim.equal("L*_f l'(f) = Ad*_{g_{k-1}} D_1 L", model, value, left_behind, 10);
    // Component by component, the tangent vector f e_a as a matrix.
    Vector<S> by_definition(group.dimension());
    for (int a = 0; a < group.dimension(); ++a) by_definition[a] = slope(l, f, from_right(f, basis_velocity<S>(group, a)));
    claim.equal("on matrices", model, column(value), by_definition);
    claim.equal("minus the momentum of the step", model, -value, momentum_before_left(l, f));
    // Controls: R* in place of L*; the relative motion that looks ahead; the momentum at the other end.
    claim.differs("R* in place of L*", model, right_differential(l, f), left_behind);
    claim.differs("f_{k-1,k} in place of f_{k,k-1}", model, left_differential(l, inverse(f)), left_behind);
    claim.differs("at g_k", model, -coadjoint(g[1], D2(lifted_left(l), g[0], g[1])), value);
    claim.differs("as the momentum itself", model, value, momentum_before_left(l, f));
  });
}

STATEMENT(eq_4_4, "a step of the dual algebra by two lines") {
  claim.convention("Pi is then minus the body momentum. With the physical momentum both lines take a minus, as (4.2) does. f is f_{k+1,k}, and l an action.");
  claim.degree(2000);
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const f = draw_places<S>(draw, group, 3);
    auto const l = with_motions_left(draw_reduced_lagrangian<S>(draw, group), f);
    auto const g = places_left(draw.template element<S>(group), f);
    auto const scale = momenta_of(l, f);
    // Condition: places after three steps.
    Matrix<S> exchanged(group.dimension(), 2), next(group.dimension(), 2);
    for (int k = 0; k < 2; ++k) {
      auto const step = momentum_system_left(l, f[k]);
      auto const body = [&](int i) { return coadjoint(g[i], legendre_source(lifted_left(l), g[i], g[i + 1])); };
      claim.zero("the first line: minus the body momentum at g_k", model, step.first + body(k), scale, 10);
      claim.zero("the second line: minus the body momentum at g_{k+1}", model, step.second + body(k + 1), scale, 10);
      claim.zero("the second line is the first line of the next step", model, step.second - momentum_system_left(l, f[k + 1]).first, scale, 10);
      exchanged.col(k) = column(momentum_system_left(l, f[k + 1]).second), next.col(k) = column(step.first);
    }
    // Controls: the translations exchanged; the momentum itself in place of its negative.
    claim.differs("L and R exchanged", model, exchanged, next);
    claim.differs("the momentum itself", model, momentum_system_left(l, f[0]).first, momentum_before_left(l, f[0]));
    auto const off = several([&] { return column(momentum_system_left(l, f[0]).second - momentum_system_left(l, draw.template element<S>(group)).first); });
    claim.refutes("off a motion", model, off, scale);
  });
}

STATEMENT(claim_4_2_system_and_dep, "the two lines and the discrete Euler-Poincare equation") {
  claim.convention("One equation (3.11) joins two of these systems: the second line of one step and the first line of the next, with Pi_k eliminated.");
  claim.degree(2000);
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const f = draw_places<S>(draw, group, 2);
    auto const any = draw_reduced_lagrangian<S>(draw, group);
    auto const between = [&](auto const& k) { return column(momentum_system_left(k, f[1]).first - momentum_system_left(k, f[0]).second); };
    auto const scale = momenta_of(any, f);
    // Whatever the relative motions: the residual of (3.11), on matrices and from places, is what Pi_k disagrees by.
    auto const g = places_left(draw.template element<S>(group), f);
    claim.zero("(3.11) on matrices", model, Vector<S>(reduced_residual_left(any, Places<S>{f[0], f[1]}) - between(any)), scale);
    // Condition: places after two steps.
    claim.zero("(3.2) as the body feels it", model, column(coadjoint(g[1], discrete_euler_lagrange(lifted_left(any), g[0], g[1], g[2]))) - between(any), scale, 10);
    auto const l = with_motions_left(any, f);
    claim.zero("along a motion", model, between(l), momenta_of(l, f));
    // Controls: off a motion; the two relative motions exchanged; the right-invariant system.
    claim.refutes("off a motion", model, between(any), scale);
    claim.refutes("the relative motions exchanged", model, column(momentum_system_left(l, f[0]).first - momentum_system_left(l, f[1]).second), momenta_of(l, f));
    claim.refutes("L and R exchanged", model, column(momentum_system_left(l, f[1]).second - momentum_system_left(l, f[0]).first), momenta_of(l, f));
  });
}

STATEMENT(claim_4_2_dlp_consequence, "the momentum update that follows from the two lines") {
  claim.corrected(R"(\Pi_{k+1} = \mathrm{Ad}^*_{f_{k+1k}}\cdot\Pi_k)", R"(\Pi_{k+1} = \mathrm{Ad}^*_{f_{k+1k}^{-1}}\cdot\Pi_k)",
                  "The inverse is missing, as in (3.18); (4.3) has it. Either sign of Pi will do.");
  claim.maybe_scan();
  claim.degree(2000);
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const f = draw_places<S>(draw, group, 3);
    auto const l = with_motions_left(draw_reduced_lagrangian<S>(draw, group), f);
    auto const scale = momenta_of(l, f);
    Matrix<S> printed(group.dimension(), 3), star_lost(group.dimension(), 3), next(group.dimension(), 3);
    for (int k = 0; k < 3; ++k) {
      auto const step = momentum_system_left(l, f[k]);
      claim.zero("Ad*_{f^-1} takes the first line to the second", model, coadjoint(inverse(f[k]), step.first) - step.second, scale, 10);
      claim.zero("(4.3) is the same update", model, final_momentum_left(f[k], step.first) - step.second, scale, 10);
      printed.col(k) = column(Ad_star(f[k], step.first)), star_lost.col(k) = Ad_matrix(inverse(f[k])) * column(step.first), next.col(k) = column(step.second);
    }
    // Condition: three updates one after the other.
    auto carried = momentum_system_left(l, f[0]).first;
    for (auto const& step : f) carried = lie_poisson_update_left(step, carried);
    claim.zero("over three steps", model, carried - momentum_system_left(l, f[2]).second, scale, 100);
    claim.differs("as printed", model, printed, next);
    if (!has_invariant_metric(model)) claim.differs("the star lost", model, star_lost, next);
  });
}
