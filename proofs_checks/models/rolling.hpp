// The discrete principle of Lagrange and d'Alembert: configurations whose action is critical under the
// displacements that constraints allow, on a group and reduced by it; and a ball that rolls.
#pragma once

#include "actio/groupoid/action_groupoid.hpp"
#include "actio/groupoid/lagrange_equations.hpp"
#include "actio/reduction/advected.hpp"

#include "models.hpp"

namespace actio::checks {

/// A reduced discrete Lagrangian with an advected vector: a group polynomial, \f$\langle Ca, fa\rangle\f$ and
/// \f$(b\cdot a)^2\f$.
template <class S>
struct CarriedPolynomial {
  GroupPolynomial<S> free;
  Matrix<S> c;
  Vector<S> b;

  template <class T>
  T operator()(Element<SpannedGroup, T> const& f, Vector<T> const& a) const {
    Vector<T> const moved = f.value * a;
    T sum = free(f), along(0);
    for (Index i = 0; i < a.size(); ++i) along += a[i] * T(b[i]);
    for (Index i = 0; i < a.size(); ++i)
      for (Index j = 0; j < a.size(); ++j) sum += moved[i] * T(c(i, j)) * a[j];
    return sum + along * along;
  }
};

/// Constraints \f$A(a)\,\xi = 0\f$ on body velocities, with rows affine in the vector.
template <class S>
struct CarriedRows {
  std::vector<Matrix<S>> linear;
  Matrix<S> constant;
  Matrix<S> complement;  ///< columns that no row annihilates

  Matrix<S> at(Vector<S> const& a) const {
    Matrix<S> rows = constant;
    for (std::size_t k = 0; k < linear.size(); ++k)
      rows.row(static_cast<Index>(k)) += (linear[k] * a).transpose();
    return rows;
  }
  /// The velocity that is allowed at a, and differs from another one along the complement.
  Vector<S> allowed(Vector<S> const& a, Vector<S> const& any) const {
    Matrix<S> const rows = at(a);
    Vector<S> const along = rows * any;
    return any - complement * solve_linear(Matrix<S>(rows * complement), along, "allowed velocity");
  }
};
template <class S>
CarriedRows<S> draw_carried_rows(Draw& draw, SpannedGroup const& group, int count) {
  int const d = group.dimension();
  CarriedRows<S> rows{{}, draw_matrix<S>(draw, count, d), draw_matrix<S>(draw, d, count)};
  for (int k = 0; k < count; ++k) rows.linear.push_back(draw_matrix<S>(draw, d, group.matrix_size()));
  return rows;
}

/// Three configurations with a vector fixed in space, under random constraints.
template <class S>
void move_under_constraints(Claim<S>& claim, Draw& draw, SpannedGroup const& group) {
  std::string const name = group.name();
  int const n = group.matrix_size(), count = group.dimension() > 3 ? 2 : 1;
  auto const g0 = draw.template element<S>(group), g1 = draw.template element<S>(group),
             g2 = draw.template element<S>(group);
  Vector<S> const c = draw_vector<S>(draw, n), a0 = inverse(g0).value * c, a1 = inverse(g1).value * c;
  auto const f10 = relative_motion_left(g0, g1), f21 = relative_motion_left(g1, g2);
  auto const rows = draw_carried_rows<S>(draw, group, count);
  Vector<S> const lambda = draw_vector<S>(draw, count);
  CarriedPolynomial<S> l{draw_group_polynomial<S>(draw, group), draw_matrix<S>(draw, n, n) / S(4),
                         draw_vector<S>(draw, n)};
  auto const jump = [&](auto const& k) {
    return advected_momentum_before_left(k, f21, a1) - advected_momentum_after_left(k, f10, a0);
  };
  // The reaction of this motion is A^T lambda.
  Momentum<SpannedGroup, S> const reaction{group, Vector<S>(rows.at(a1).transpose() * lambda)};
  l.free = detail::corrected(l.free, group, draw, [&](auto const& k) {
    return jump(CarriedPolynomial<S>{k, l.c, l.b}) - reaction;
  });
  // Sums of products of some ten factors, and a linear system.
  double const condition = 1000;

  auto const lifted = lift_advected_left(l, c);
  auto const unreduced = discrete_euler_lagrange(lifted, g0, g1, g2);
  auto const displaced = [&](auto const& g, Vector<S> const& body) {
    return Ad(g, Velocity<SpannedGroup, S>{group, body});
  };
  Vector<S> const any = draw_vector<S>(draw, group.dimension()),
                  other = draw_vector<S>(draw, group.dimension()), at_start = rows.allowed(a0, any),
                  at_end = rows.allowed(a1, other);
  claim.zero("work of (3.2) on an allowed displacement", name, pair(unreduced, displaced(g1, at_end)), S(1),
             condition);
  claim.refutes("work of (3.2) on a displacement that is not allowed", name,
                pair(unreduced, displaced(g1, other)), S(1));

  // On the action groupoid an arrow has the element g0^-1 g1 and the vector at its source. Reactions are
  // combinations of the rows at the point where two arrows meet.
  ActionGroupoid<SpannedGroup> const gamma{group};
  auto const on_arrows = [&](auto const& arrow) { return l(inverse(arrow.element), arrow.vector); };
  ActionArrow<SpannedGroup, S> const first{inverse(f10), a0}, second{inverse(f21), a1};
  Vector<S> const on_groupoid = lagrange_equations(gamma, on_arrows, first, second);
  claim.equal("residual on the action groupoid = momenta of the steps", name, on_groupoid,
              Vector<S>(-jump(l).components), condition);
  claim.zero("the same with the reaction at the point where the arrows meet", name,
             Vector<S>(on_groupoid + reaction.components), S(1), condition);
  claim.refutes("with rows at the source of the first arrow", name,
                Vector<S>(on_groupoid + rows.at(a0).transpose() * lambda), S(1));
  claim.differs("residual of the arrows in the other order", name,
                Vector<S>(lagrange_equations(gamma, on_arrows, second, first)), on_groupoid);

  // The nonholonomic momentum equation: along allowed sections reactions drop out.
  S const before =
              pair(advected_momentum_before_left(l, f10, a0), Velocity<SpannedGroup, S>{group, at_start}),
          after = pair(advected_momentum_after_left(l, f10, a0), Velocity<SpannedGroup, S>{group, at_end}),
          next = pair(advected_momentum_before_left(l, f21, a1), Velocity<SpannedGroup, S>{group, at_end});
  S const derivative =
      pair(D1(lifted, g0, g1), displaced(g0, at_start)) + pair(D2(lifted, g0, g1), displaced(g1, at_end));
  claim.equal("change of the momentum along a section = derivative of the Lagrangian along it", name,
              S(next - before), derivative, condition);
  claim.differs(
      "the same along a section that is not allowed", name,
      S(pair(advected_momentum_before_left(l, f21, a1), Velocity<SpannedGroup, S>{group, other}) - before),
      S(pair(D1(lifted, g0, g1), displaced(g0, at_start)) + pair(D2(lifted, g0, g1), displaced(g1, other))));
  claim.equal("and of the momentum of one step", name, S(after - before), derivative, condition);
}

/// The action of a free rigid body over a step, by Cayley's transform.
template <class S>
struct FreeBodyStep {
  Matrix<S> inertia;
  S mass, h;

  template <class T>
  T operator()(Element<SpannedGroup, T> const& f) const {
    Vector<T> const v = f.group.vee(inverse_cayley(f.value));
    T sum(0);
    for (Index i = 0; i < 3; ++i) {
      for (Index j = 0; j < 3; ++j) sum += v[i] * T(inertia(i, j)) * v[j];
      sum += T(mass) * v[3 + i] * v[3 + i];
    }
    return sum / T(S(2) * h);
  }
};

template <class S>
Vector<S> cross_product(Vector<S> const& a, Vector<S> const& b) {
  Vector<S> c(3);
  for (Index i = 0; i < 3; ++i) {
    Index const j = (i + 1) % 3, k = (i + 2) % 3;
    c[i] = a[j] * b[k] - a[k] * b[j];
  }
  return c;
}

/// Chaplygin's ball: over a step of a ball that rolls the momentum about its contact turns with the plane.
template <class S>
void roll_a_ball(Claim<S>& claim, Draw& draw, SpannedGroup const& motions) {
  std::string const name = "ball on a plane";
  Matrix<S> const m = draw_matrix<S>(draw, 3, 3);
  FreeBodyStep<S> const l{Matrix<S>::Identity(3, 3) + m * m.transpose() / S(4), draw.number<S>() + S(2),
                          S(2)};
  Vector<S> const w = draw_vector<S>(draw, 3), u0 = draw_vector<S>(draw, 3), slip = draw_vector<S>(draw, 3),
                  lambda = draw_vector<S>(draw, 3);
  auto const hat = [](Vector<S> const& x) {
    Matrix<S> h(3, 3);
    for (Index i = 0; i < 3; ++i) h.col(i) = cross_product<S>(x, Vector<S>(Vector<S>::Unit(3, i)));
    return h;
  };
  Matrix<S> const forth = Matrix<S>::Identity(3, 3) + hat(w) * (l.h / S(2));
  Vector<S> const middle = solve_linear(forth, u0, "cayley"), u1 = middle * S(2) - u0;
  // The contact is at -u from the centre.
  Vector<S> const rolling = cross_product<S>(w, middle);
  auto const about_contact = [](Vector<S> const& p, Vector<S> const& u) {
    return Vector<S>(p.head(3) + cross_product<S>(u, Vector<S>(p.tail(3))));
  };
  auto const both_ends = [&](Vector<S> const& v) {
    Vector<S> x(6);
    x << w, v;
    Element<SpannedGroup, S> const f{motions, cayley(Matrix<S>(motions.hat(Vector<S>(x * -l.h))))};
    Matrix<S> const turn = f.value.topLeftCorner(3, 3);
    return std::pair(Vector<S>(turn * about_contact(Vector<S>(-left_differential(l, f).components), u0)),
                     about_contact(Vector<S>(-right_differential(l, f).components), u1));
  };
  double const condition = 1000;
  auto const [turned, after] = both_ends(rolling);
  claim.equal("momentum about the contact over a step that rolls", name, after, turned, condition);
  auto const [turned_slipping, after_slipping] = both_ends(Vector<S>(rolling + slip));
  claim.differs("momentum about the contact over a step that slips", name, after_slipping, turned_slipping);
  auto const reaction = [&](Vector<S> const& u) {
    Vector<S> p(6);
    p << cross_product<S>(lambda, u), lambda;  // r x lambda with r = -u
    return p;
  };
  claim.zero("moment about the contact of a reaction at the node", name, about_contact(reaction(u0), u0),
             S(1), condition);
  claim.refutes("moment about the contact of a reaction in the middle of the step", name,
                about_contact(reaction(middle), u0), S(1));
}

}  // namespace actio::checks
