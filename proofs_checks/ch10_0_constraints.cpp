// Chapter 10: the restricted principle of Hamilton where constraints contain velocities.
#include "statement.hpp"

#include "fields/velocity_constraints.hpp"
#include "models/rolling.hpp"

namespace {

using namespace actio;
using namespace actio::checks;

/// (7.2) for k constraints on m coordinates, against virtual work: reactions, and accelerations from one
/// position and velocity.
template <class S, int m, int k>
void compare_accelerations(Claim<S>& claim, Draw& draw, bool affine, std::string const& name) {
  using V = Matrix<S, m, 1>;
  using Multipliers = Matrix<S, k, 1>;
  auto const L = draw_mechanics<S, m>(draw);
  auto const Phi = draw_velocity_constraint<S, m, k>(draw, affine);
  S const t = draw.number<S>();
  V const q = draw.vector<S, V>(m) / S(2), v = allowed_velocity(Phi, q, draw.vector<S, V>(m)),
          any = draw.vector<S, V>(m);
  Multipliers const lambda = draw.vector<S, Multipliers>(k), rate = draw.vector<S, Multipliers>(k),
                    none = Multipliers::Zero();
  // Products of some ten factors of size one; systems whose determinants are of size one.
  double const condition = 100;
  claim.equal("reaction in (7.2) = lambda d omega(v) - lambda' omega", name,
              reaction(Phi, jet_of_motion(t, q, v, any), jet_of_multiplier(t, lambda, rate)),
              V(Phi.turned(q, v).transpose() * lambda - Phi.rows(q).transpose() * rate), condition);

  // Virtual work has one motion from q and v; (7.2) has one for each multiplier at the start.
  auto const with = [&](Multipliers const& start) { return acceleration_under(L, Phi, t, q, v, start); };
  auto const work = with(none), restricted = with(lambda);
  V const by_work = work.template head<m>(), by_restriction = restricted.template head<m>();
  auto const left = [&](V const& a, Multipliers const& multiplier, Multipliers const& its_rate) {
    return V(constrained_field_equations(L, Phi, jet_of_motion(t, q, v, a),
                                         jet_of_multiplier(t, multiplier, its_rate)));
  };
  claim.zero("(7.2) along the motion of the restricted principle", name,
             left(by_restriction, lambda, restricted.template tail<k>()), S(1), condition);
  Matrix<S, m, k> const forms = Phi.rows(q).transpose();
  claim.equal("free equations along the motion by virtual work: a combination of the forms", name,
              left(by_work, none, none), V(forms * work.template tail<k>()), condition);
  claim.differs("accelerations by restriction and by virtual work", name, by_restriction, by_work);
  claim.differs("accelerations by restriction with two multipliers at the start", name,
                V(with(Multipliers(lambda + rate)).template head<m>()), by_restriction);
}

/// A particle under dz = y dx that weight g pulls along x. Written out by hand.
struct Weighed {
  template <class T>
  T operator()(Jet<T, 0, 3> const& j) const {
    return (j.v(0, 0) * j.v(0, 0) + j.v(1, 0) * j.v(1, 0) + j.v(2, 0) * j.v(2, 0)) / T(2) + j.y[0] * T(3);
  }
};
struct Contact {
  static constexpr int components = 1;
  template <class T>
  Matrix<T, 1, 1> operator()(Jet<T, 0, 3> const& j) const {
    return Matrix<T, 1, 1>(j.v(2, 0) - j.y[1] * j.v(0, 0));
  }
};
/// No multiplier makes the motion by virtual work a motion of the restricted principle.
template <class S>
void weigh_a_particle(Claim<S>& claim, Draw& draw) {
  using V = Matrix<S, 3, 1>;
  std::string const name = "particle with weight under dz = y dx";
  S const t(0), y = draw.number<S>() + S(2), x_rate = draw.number<S>() + S(2),
                y_rate = draw.number<S>() + S(2), lambda = draw.number<S>(), rate = draw.number<S>();
  V const q(draw.number<S>(), y, draw.number<S>()), v(x_rate, y_rate, y * x_rate);
  // x'' = 3 - mu y, y'' = 0, z'' = mu, with z'' = y'x' + y x''.
  S const mu = (y_rate * x_rate + y * S(3)) / (S(1) + y * y);
  V const by_work(S(3) - mu * y, S(0), mu);
  auto const left = [&](S const& multiplier, S const& its_rate) {
    return V(constrained_field_equations(
        Weighed{}, Contact{}, jet_of_motion(t, q, v, by_work),
        jet_of_multiplier(t, Matrix<S, 1, 1>(multiplier), Matrix<S, 1, 1>(its_rate))));
  };
  claim.equal("free equations along the motion by virtual work", name, left(S(0), S(0)), V(-y * mu, S(0), mu),
              10);
  // The second equation of (7.2) is y'' = lambda x': no multiplier but zero, at this time and at all others.
  // Then its rate is zero as well, and the third leaves z''.
  claim.equal("the second equation of (7.2) along it", name, left(lambda, rate)[1], S(-lambda * x_rate), 10);
  claim.equal("the residual without multiplier is the reaction", name, left(S(0), S(0))[2], mu, 10);
  claim.refutes("the motion by virtual work solves (7.2)", name, left(S(0), S(0)), S(1));
}

}  // namespace

STATEMENT(claim_10_0_nonholonomic_constraints,
          "restricted Hamilton principle and constraints on velocities") {
  claim.holds(
      "With time as the only coordinate of the base, (7.2) is the equation of vakonomic mechanics, and "
      "it is not that of Lagrange and d'Alembert, which the text takes to be right: position and "
      "velocity do not determine its motion, and no multiplier lets a particle with weight under $dz = "
      "y\\,dx$ follow the motion by virtual work. Shown off shell for constraints linear and affine in "
      "the velocities. For fields virtual work depends on which coordinate is held: a constraint with a "
      "derivative in that coordinate tells the two principles apart, any other does not. Whether the "
      "restriction is right for relativistic fields, where no coordinate is singled out, the text leaves "
      "open, and there is nothing to compute. Discretely, on a group with an advected vector in Lagrangian "
      "and constraints, the principle of Lagrange and d'Alembert reduces: the body momentum jumps at a node "
      "by a combination of the rows, as the Lagrange equations on the action groupoid say with a reaction at "
      "the point where two arrows meet. So the momentum along an allowed section obeys the equation of the "
      "free step, and over a step of a rolling ball the momentum about the contact turns with the plane.");
  restrict_to_allowed_curves<S, 3, 1>(claim, draw, false, "one linear constraint in R^3");
  restrict_to_allowed_curves<S, 5, 2>(claim, draw, true, "two affine constraints in R^5");
  compare_accelerations<S, 3, 1>(claim, draw, false, "one linear constraint in R^3");
  compare_accelerations<S, 5, 2>(claim, draw, true, "two affine constraints in R^5");
  weigh_a_particle(claim, draw);

  // Discretely, on groups and reduced by them.
  for (auto const& group : few_groups()) move_under_constraints(claim, draw, group);
  roll_a_ball(claim, draw, few_groups()[1]);

  // Fields (u, w) on a string: w = F without the derivative of u in one of the two coordinates.
  auto const L = draw_density<S, 1, 2>(draw);
  auto const graph = draw_field_graph<S, 1>(draw);
  CubicField<S, 1> const u{draw_cubic<S, 2>(draw)}, eta{draw_cubic<S, 2>(draw)};
  auto const x = draw_event<S, 1>(draw);
  for (int const missing : {0, 1})
    for (int const held : {0, 1}) {
      std::string const name =
          std::string("w = F(x, u, ") + (missing ? "u_t" : "u_s") + "), " + (held ? "s" : "t") + " held";
      auto const p = principles_on_graph(L, graph.without(missing), u, eta, x, held);
      // Cubics of cubics, differentiated up to three times.
      if (missing == held)
        claim.equal("Hamilton's principle on the constrained sections, and virtual work", name, p.restricted,
                    p.virtual_work, 100);
      else
        claim.differs("Hamilton's principle on the constrained sections, and virtual work", name,
                      p.restricted, p.virtual_work);
    }
}
