// Section 7.0: constraints without derivatives in time, and which principle gives the equations.
#include "statement.hpp"

#include "actio/constraints/multiplier_theorem.hpp"
#include "fields/velocity_constraints.hpp"

namespace {

using namespace actio;
using namespace actio::checks;

/// A field times a function of the time alone, that of `cut`.
template <class Field, class Cut>
auto cut_off(Field const& field, Cut const& cut) {
  return [=]<class T, int rows>(Matrix<T, rows, 1> const& x) {
    auto const w = field(x);
    return std::remove_cvref_t<decltype(w)>(w * T(cut(Matrix<T, 1, 1>(x[0]))));
  };
}

/// The three principles with one field a function of the other, at a point.
template <class S, int n>
void compare_on_graph(Claim<S>& claim, Draw& draw) {
  // Cubics of cubics, differentiated up to three times: terms grow to some tens and cancel in part.
  double const condition = 100;
  auto const L = draw_density<S, n, 2>(draw);
  auto const graph = draw_field_graph<S, n>(draw);
  CubicField<S, n> const u{draw_cubic<S, n + 1>(draw)}, eta{draw_cubic<S, n + 1>(draw)};
  auto const x = draw_event<S, n>(draw);
  auto const cut = draw_cubic<S, 1>(draw);
  auto const cut_variation = [&](FieldGraph<S, n> const& Phi) {
    auto const phi = on_graph(Phi, u);
    return rate_of_constraint(Phi, phi, cut_off(virtual_displacement(Phi, phi, eta), cut), x);
  };
  for (bool const timed : {false, true}) {
    auto const Phi = timed ? graph : graph.without(0);
    std::string const name =
        "w = F(x, u, " + std::string(timed ? "all of du" : "du in space") + "), n = " + std::to_string(n);
    auto const p = principles_on_graph(L, Phi, u, eta, x);
    claim.equal("Hamilton's principle on the constrained sections, and equations with multiplier", name,
                p.restricted, p.multiplier, condition);
    S const turned = cut_variation(Phi);
    if (timed) {
      claim.differs("Hamilton's principle on the constrained sections, and virtual work", name, p.restricted,
                    p.virtual_work);
      claim.refutes("possible displacements, cut off in time, keep the constraint", name, turned, eta(x)[0]);
    } else {
      claim.equal("Hamilton's principle on the constrained sections, and virtual work", name, p.restricted,
                  p.virtual_work, condition);
      claim.zero("possible displacements, cut off in time, keep the constraint", name, turned, eta(x)[0],
                 condition);
    }
  }
}

/// The same for curves that sweep area at a given rate.
template <class S>
void compare_on_curves(Claim<S>& claim, Draw& draw) {
  std::string const name = "[r, r_s] = rho(t, s)";
  double const condition = 100;
  auto const L = draw_density<S, 1, 2>(draw);
  auto const Phi = draw_areal_rate<S, 1>(draw);
  auto const b = draw_cubic<S, 2>(draw);
  auto const cut = draw_cubic<S, 1>(draw);
  auto const x = draw_event<S, 1>(draw);
  auto const p = principles_of_areal_rate(L, Phi, b, x);
  claim.zero("the curve satisfies the constraint", name, induced_constraint(Phi, Phi.r)(x), S(1));
  claim.zero("and so do its variations, cut off in time", name,
             rate_of_constraint(Phi, Phi.r, cut_off(Phi.variation(b), cut), x), S(1), 10);
  claim.equal("Hamilton's principle on the constrained sections, and equations with multiplier", name,
              p.restricted, p.multiplier, condition);
  claim.equal("Hamilton's principle on the constrained sections, and virtual work", name, p.restricted,
              p.virtual_work, condition);
  // There are no other variations: along f r + h r_s the constraint changes by 2 f rho + (h rho)_s.
  auto const f = draw_cubic<S, 2>(draw), h = draw_cubic<S, 2>(draw);
  auto const any = [&]<class T, int rows>(Matrix<T, rows, 1> const& at) {
    return Matrix<T, 2, 1>(Phi.r(at) * f(at) + Phi.r.slope(at) * h(at));
  };
  S const rate = Phi.rho(x), rate_s = area(Phi.r(x), Phi.r.bend(x));
  claim.equal("change of the constraint along any variation", name, rate_of_constraint(Phi, Phi.r, any, x),
              S(f(x) * rate * S(2) + slope_of(h, x, 1) * rate + h(x) * rate_s), 10);
  claim.differs("variations with half of the part along r", name, rate_of_constraint(Phi, Phi.r, any, x),
                S(f(x) * rate + slope_of(h, x, 1) * rate + h(x) * rate_s));
}

// ---- One constraint on velocities, both principles.

/// The free particle under dz = y dx, written out by hand. Rates of (x', y', z', lambda): z'' = y'x' + y x''
/// keeps the constraint in both.
template <class T>
Matrix<T, 4, 1> rates_by_virtual_work(T const& y, Matrix<T, 2, 1> const& velocity) {
  // The reaction is mu (-y, 0, 1).
  T const mu = velocity[0] * velocity[1] / (T(1) + y * y);
  return {-y * mu, T(0), mu, T(0)};
}
template <class T>
Matrix<T, 4, 1> rates_by_restriction(T const& y, Matrix<T, 2, 1> const& velocity, T const& lambda) {
  // x'' = -(lambda y)', y'' = lambda x', z'' = lambda'.
  T const rate = velocity[1] * (velocity[0] - lambda * y) / (T(1) + y * y);
  return {-rate * y - lambda * velocity[1], lambda * velocity[0], rate, rate};
}
/// Jerks from accelerations that move.
template <class S>
Matrix<S, 3, 1> rates_of(Matrix<Dual<S>, 4, 1> const& rates) { return rate_of(rates).template head<3>(); }
/// dz = y dx and the free particle, for the library.
struct Contact {
  static constexpr int components = 1;
  template <class T>
  Matrix<T, 1, 1> operator()(Jet<T, 0, 3> const& j) const {
    return Matrix<T, 1, 1>(j.v(2, 0) - j.y[1] * j.v(0, 0));
  }
};
struct FreeParticle {
  template <class T>
  T operator()(Jet<T, 0, 3> const& j) const {
    return (j.v(0, 0) * j.v(0, 0) + j.v(1, 0) * j.v(1, 0) + j.v(2, 0) * j.v(2, 0)) / T(2);
  }
};

template <class S>
void compare_particles(Claim<S>& claim, Draw& draw) {
  std::string const name = "free particle under dz = y dx";
  using V = Matrix<S, 3, 1>;
  S const y = draw.number<S>() + S(2), lambda = draw.number<S>() + S(2), t(0);
  Matrix<S, 2, 1> const v = draw.vector<S, Matrix<S, 2, 1>>(2) + Matrix<S, 2, 1>(S(2), S(2));
  V const q(draw.number<S>(), y, draw.number<S>()), velocity(v[0], v[1], y * v[0]);
  auto const work = rates_by_virtual_work(y, v), restricted = rates_by_restriction(y, v, lambda);
  auto const equations = [&](Matrix<S, 4, 1> const& rates, S const& multiplier, S const& rate) {
    auto const j = jet_of_motion(t, q, velocity, V(rates.template head<3>()));
    return constrained_field_equations(
        FreeParticle{}, Contact{}, j,
        jet_of_multiplier(t, Matrix<S, 1, 1>(multiplier), Matrix<S, 1, 1>(rate)));
  };
  auto const kept = [&](Matrix<S, 4, 1> const& rates) { return S(rates[2] - v[1] * v[0] - y * rates[0]); };
  // Products of three numbers of size two.
  claim.zero("both motions keep the constraint", name, Matrix<S, 2, 1>(kept(work), kept(restricted)), S(1),
             10);
  claim.zero("(7.2) with a multiplier, along the motion of the restricted principle", name,
             equations(restricted, lambda, restricted[3]), S(1), 10);
  // The free equations along the motion by virtual work are a multiple of (-y, 0, 1).
  claim.equal("reaction by virtual work", name, equations(work, S(0), S(0)), V(V(-y, S(0), S(1)) * work[2]),
              10);
  // Along this motion the second of the equations (7.2), y'' = lambda x', leaves lambda = 0 at all times; the
  // third is then z'' = 0.
  claim.equal("what (7.2) leaves along the motion by virtual work", name, equations(work, lambda, S(0))[1],
              S(-lambda * v[0]), 10);
  claim.refutes("the motion by virtual work solves (7.2), with the only multiplier there may be", name,
                equations(work, S(0), S(0)), S(1));
  claim.differs("accelerations of the two motions from one position and velocity", name, restricted[1],
                work[1]);
  // With lambda = 0 at the start the accelerations agree there, and their rates do not: y''' = lambda' x'.
  auto const start = rates_by_restriction(y, v, S(0));
  claim.zero("without multiplier at the start the accelerations agree there", name,
             V((start - work).template head<3>()), S(1), 10);
  auto const v_later = moved_along(v, Matrix<S, 2, 1>(start.template head<2>()));
  Dual<S> y_later(y), lambda_later(S(0));
  y_later.part[0] = v[1], lambda_later.part[0] = start[3];
  claim.differs("and so do their rates", name, rates_of(rates_by_restriction(y_later, v_later, lambda_later)),
                rates_of(rates_by_virtual_work(y_later, v_later)));
}

/// A linear constraint \f$g\,df\f$, which is one on the configuration, with a quadratic f and a linear g.
template <class S>
VelocityConstraint<S, 3, 1> draw_integrable(Draw& draw) {
  using V = Matrix<S, 3, 1>;
  V const slope = draw.vector<S, V>(3), factor = draw.vector<S, V>(3) / S(4), none = V::Zero();
  Matrix<S, 3, 3> bend;
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b <= a; ++b) bend(a, b) = bend(b, a) = draw.number<S>() / S(4);
  VelocityConstraint<S, 3, 1> Phi;
  Phi.beta[0] = {S(0), none, none, none, none};
  for (int a = 0; a < 3; ++a) {
    V const row = bend.col(a);
    S const first = slope[a] + S(a == 2 ? 2 : 0);
    Phi.omega[0][a] = {first, V(factor * first + row), factor, row, none};
  }
  return Phi;
}
template <class S>
Matrix<S, 3, 1> cross(Matrix<S, 3, 1> const& a, Matrix<S, 3, 1> const& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template <class S>
void compare_any_linear(Claim<S>& claim, Draw& draw, bool integrable) {
  using V = Matrix<S, 3, 1>;
  std::string const name = integrable ? "g df = 0 in R^3" : "any linear constraint in R^3";
  // A system of four equations whose determinant is of size one.
  double const condition = 100;
  auto const L = draw_mechanics<S, 3>(draw);
  auto const Phi = integrable ? draw_integrable<S>(draw) : draw_velocity_constraint<S, 3, 1>(draw, false);
  S const t = draw.number<S>();
  V const q = draw.vector<S, V>(3) / S(2),
          v = allowed_velocity(Phi, q, V(draw.vector<S, V>(3) + V(S(1), S(1), S(0))));
  Matrix<S, 1, 1> const lambda(draw.number<S>() + S(2)), none(S(0)), rate(draw.number<S>());
  V const omega = Phi.rows(q).transpose(), a = draw.vector<S, V>(3);
  auto const j = jet_of_motion(t, q, v, a);
  V const R = reaction(Phi, j, jet_of_multiplier(t, lambda, rate));

  // The multiplier adds lambda d omega(v) to what virtual work allows, and that is no multiple of omega where
  // omega . curl omega is not zero. The velocity itself does not depend on it.
  V const turned = Phi.turned(q, v).transpose();
  claim.equal("reaction = lambda d omega(v) - lambda' omega", name, R,
              V(turned * lambda[0] - omega * rate[0]), condition);
  V curl;
  for (int i = 0; i < 3; ++i)
    curl[i] = slope_of(Phi.omega[0][(i + 2) % 3], q, (i + 1) % 3) -
              slope_of(Phi.omega[0][(i + 1) % 3], q, (i + 2) % 3);
  V const sideways = cross(omega, v);
  claim.zero("its work on the velocity", name, R.dot(v), size_of(R), condition);
  claim.zero("its part across, a displacement that is possible as well", name,
             S(R.dot(sideways) + lambda[0] * v.dot(v) * omega.dot(curl)), S(size_of(R) * size_of(sideways)),
             condition);
  auto const work = acceleration_under(L, Phi, t, q, v, none),
             restricted = acceleration_under(L, Phi, t, q, v, lambda);
  V const by_work = work.template head<3>(), by_restriction = restricted.template head<3>();
  claim.zero("(7.2) along the motion of the restricted principle", name,
             constrained_field_equations(
                 L, Phi, jet_of_motion(t, q, v, by_restriction),
                 jet_of_multiplier(t, lambda, Matrix<S, 1, 1>(restricted.template tail<1>()))),
             S(1), condition);
  if (integrable)
    claim.equal("accelerations by restriction and by virtual work", name, by_restriction, by_work, condition);
  else
    claim.differs("accelerations by restriction and by virtual work", name, by_restriction, by_work);
}

}  // namespace

STATEMENT(claim_7_0_spatial_constraints,
          "constraints with spatial derivatives only, and restriction of the principle") {
  claim.convention(
      "Where the constrained sections are a submanifold, the boundary conditions included. Then Hamilton's "
      "principle on them, the multiplier and virtual work leave the same equations, off shell and for "
      "every variation; with derivatives in time the first two still agree, and virtual work does not. "
      "Shown where one field is a function of the other and of its derivatives, on a string and on a "
      "membrane, and where no field is, on plane curves that sweep area at a given rate.");
  compare_on_graph<S, 1>(claim, draw);
  compare_on_graph<S, 2>(claim, draw);
  compare_on_curves(claim, draw);

  // Zeros that are no submanifold: q^2 = 0 has the zeros of q = 0 and no reaction.
  auto const square = constrained<1>([]<class T>(Matrix<T, 1, 1> const& q) { return q[0]; },
                                     []<class T>(Matrix<T, 1, 1> const& q) { return (q * q[0]).eval(); });
  Matrix<S, 1, 1> const origin = Matrix<S, 1, 1>::Zero();
  claim.template refuses<NotRegular>("a multiplier for the constraint q^2 = 0", "line",
                                     [&] { square.multiplier(origin); });
}

STATEMENT(claim_7_0_vakonomic_differs,
          "equations of the restricted principle and of Lagrange and d'Alembert") {
  claim.convention(
      "The constraint is one on velocities that does not integrate to one on configurations: for a "
      "holonomic one, $g\\,df = 0$, both principles give the same motions, as the text says before. "
      "Hamilton's principle on the curves that satisfy $\\omega\\cdot\\dot q = 0$ has the equations (7.2). "
      "Its reaction has the part $-\\lambda\\,|\\dot q|^2\\,\\omega\\cdot\\mathrm{curl}\\,\\omega$ along "
      "the displacement $\\omega\\times\\dot q$, which virtual work leaves free. Which of the two nature "
      "follows is a question for experiments.");
  restrict_to_allowed_curves<S, 3, 1>(claim, draw, false, "any linear constraint in R^3");
  compare_any_linear(claim, draw, false);
  compare_any_linear(claim, draw, true);
  compare_particles(claim, draw);
}
