// Where the constraint and the reactions of a step are taken: what the order and the momentum about the
// contact need, and what breaks them.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "actio/groupoid/action_groupoid.hpp"
#include "actio/groupoid/lagrange_equations.hpp"
#include "actio/groups/motions.hpp"
#include "actio/reduction/composition.hpp"
#include "rolling_systems.hpp"

using namespace actio;
using namespace actio::systems;
using namespace actio::testing;

namespace {

using D = Moved<double>;

/// A step P_0(v) = mu + A(a_x)^T lambda, c(v, a_y) = 0, with x and y anywhere in the step, by Newton's
/// iteration from scratch.
struct Variant {
  Constrained const& of;
  double h, constraint_at, reactions_at;
  List v, lambda;

  Variant(Constrained const& system, double step, double constraint, double reactions, List const& velocity)
      : of(system),
        h(step),
        constraint_at(constraint),
        reactions_at(reactions),
        v(velocity),
        lambda(static_cast<std::size_t>(system.constraints->count), 0) {}

  template <class S>
  std::vector<S> vectors_at(double part, std::vector<S> const& velocity, List const& a) const {
    std::vector<S> start(a.begin(), a.end());
    if (part == 0) return start;
    ChartStep<S> moved(*of.system);
    moved(S(part * h), velocity, start);
    return moved.vectors;
  }
  template <class S>
  std::vector<S> residual(ReducedPoint const& at, std::vector<S> const& x,
                          ReducedPointOver<S>* end = nullptr) const {
    auto const d = v.size();
    std::vector<S> const velocity(x.begin(), x.begin() + of.constraints->dimension);
    ChartStep<S> step(*of.system);
    step(S(h), velocity, {at.vectors.begin(), at.vectors.end()});
    ConstraintValues<S> middle(*of.constraints), reactions(*of.constraints);
    middle.set_values(velocity, vectors_at(constraint_at, velocity, at.vectors), S(0));
    reactions.set_rows(vectors_at(reactions_at, velocity, at.vectors), S(0));
    std::vector<S> out;
    for (std::size_t i = 0; i < d; ++i) {
      out.push_back(step.before[i] - S(at.momentum[i]));
      for (std::size_t k = 0; k < lambda.size(); ++k) out[i] -= reactions.rows[k * d + i] * x[d + k];
    }
    out.insert(out.end(), middle.values.begin(), middle.values.end());
    if (end) *end = {step.after, step.vectors};
    return out;
  }
  void advance(ReducedPoint& at) {
    List x = v;
    x.insert(x.end(), lambda.begin(), lambda.end());
    auto const n = static_cast<Index>(x.size());
    for (int iteration = 0; iteration < 6; ++iteration) {
      Eigen::MatrixXd slope(n, n);
      Eigen::VectorXd value(n);
      for (Index j = 0; j < n; ++j) {
        std::vector<D> moved(x.begin(), x.end());
        moved[static_cast<std::size_t>(j)].part[0] = 1;
        auto const r = residual(at, moved);
        for (Index i = 0; i < n; ++i)
          slope(i, j) = r[static_cast<std::size_t>(i)].part[0],
                   value[i] = r[static_cast<std::size_t>(i)].value;
      }
      Eigen::VectorXd const update = solve_linear(slope, value, "variant");
      for (Index i = 0; i < n; ++i) x[static_cast<std::size_t>(i)] -= update[i];
    }
    ReducedPointOver<double> end;
    residual(at, x, &end);
    at = {end.momentum, end.vectors};
    std::copy_n(x.begin(), v.size(), v.begin());
    std::copy(x.begin() + of.constraints->dimension, x.end(), lambda.begin());
  }
  /// The velocity at the end of so many steps.
  List end(ReducedPoint at, int count) {
    for (int k = 0; k < count; ++k) advance(at);
    List w = v, projected(lambda.size(), 0);
    ConstrainedVelocity(*of.system, *of.constraints).solve(at.momentum, at.vectors, 0, w, projected);
    return w;
  }
};

/// A ball with its centre of mass off its centre, so that no momentum is conserved.
struct Lopsided {
  Chart chart = Chart::exponential;
  Constrained system{"SE(3)",     "(w1^2 + 2*w2^2 + 2.5*w3^2 + v1^2 + v2^2 + v3^2)/2 - 0.9*up1",
                     point_rests, {"up"},
                     {},          "r1 = 0.3 - up1; r2 = -up2; r3 = -up3;",
                     chart};
  Triple up{0.36, 0.48, 0.8}, w{0.9, -0.4, 1.2};
  ConstrainedState start = system.state(rolling_velocity(w, Triple(0.3, 0, 0) - up), direction(up));
};

/// The discrete Lagrangian of the lopsided ball on the action groupoid, in Cayley's chart:
/// h/2 (l(v, a_0) + l(v, a_1)) of an arrow (cay(hv), a_0).
struct OnArrows {
  double h;

  template <class T>
  T operator()(ActionArrow<SE<3>, T> const& arrow) const {
    auto const v = SE<3>{}.vee(inverse_cayley(arrow.element.value));
    T kinetic = v[0] * v[0] + T(2) * v[1] * v[1] + T(2.5) * v[2] * v[2];
    for (Index i = 3; i < 6; ++i) kinetic += v[i] * v[i];
    T const height = arrow.vector[0] + ActionGroupoid<SE<3>>::target(arrow).value[0];
    return kinetic / T(2 * h) - T(0.9 * h / 2) * height;
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(where_constraints_and_reactions_are)

BOOST_AUTO_TEST_CASE(the_step_of_the_library_is_that_of_the_definition) {
  Lopsided const ball;
  for (double const h : {0.02, 0.2}) {
    auto run = ball.system.run(h, {1}, ball.start);
    Variant variant(ball.system, h, 0.5, 0, ball.start.velocity);
    ReducedPoint at = ball.start.point;
    for (int k = 0; k < 10; ++k) {
      run.step(), variant.advance(at);
      // Velocities and multipliers of size 2, from momenta with some thirty roundings, over ten steps.
      BOOST_TEST(apart(run.velocity_of_substep(), variant.v) < 1e-13);
      BOOST_TEST(apart(run.point().vectors, at.vectors) < 1e-13);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_reactions_are_the_residual_on_the_action_groupoid) {
  double const h = 0.1;
  Lopsided const ball{Chart::cayley};
  auto run = ball.system.run(h, {1}, ball.start);
  run.follow_configuration(Eigen::MatrixXd::Identity(4, 4));
  using Arrow = ActionArrow<SE<3>, double>;
  ConstraintValues<double> rows(*ball.system.constraints);
  Arrow last;
  for (int k = 0; k < 10; ++k) {
    Eigen::MatrixXd const before = run.configuration();
    Arrow arrow{{SE<3>{}, before.inverse() * Eigen::MatrixXd(before)}, Vector<double>(4)};
    std::copy_n(run.point().vectors.begin(), 4, arrow.vector.data());
    run.step();
    arrow.element.value = before.inverse() * run.configuration();
    if (k > 0) {
      auto const residual = lagrange_equations(ActionGroupoid<SE<3>>{}, OnArrows{h}, last, arrow);
      auto const at = [&](Arrow const& of) {
        rows.set_rows({of.vector.data(), of.vector.data() + 4}, 0);
        double largest = 0;
        for (Index i = 0; i < 6; ++i) {
          double sum = residual[i];
          for (std::size_t j = 0; j < 3; ++j)
            sum += rows.rows[j * 6 + static_cast<std::size_t>(i)] * run.impulse()[j];
          largest = std::max(largest, std::abs(sum));
        }
        return largest;
      };
      // Momenta of size 4, from matrices of quotients by h.
      BOOST_TEST(at(arrow) < 64 * 0x1p-52 * 4 / h);
      BOOST_TEST(at(last) > 1e-4);
    }
    last = arrow;
  }
}

BOOST_AUTO_TEST_CASE(the_order_falls_to_one_with_the_constraint_at_an_end_of_the_step) {
  Lopsided const ball;
  double const time = 2;
  List const truth = [&] {
    auto run = ball.system.run(time / 400, symmetric_composition<double>(4), ball.start);
    for (int k = 0; k < 400; ++k) run.step();
    return run.state().velocity;
  }();
  auto const order = [&](double constraint, double reactions) {
    List errors;
    for (int const count : {50, 100, 200})
      errors.push_back(apart(Variant(ball.system, time / count, constraint, reactions, ball.start.velocity)
                                 .end(ball.start.point, count),
                             truth));
    BOOST_TEST_MESSAGE("constraint at " << constraint << ", reactions at " << reactions << ": errors "
                                        << errors[0] << " " << errors[1] << " " << errors[2]);
    return order_of(errors);
  };
  BOOST_TEST(std::abs(order(0.5, 0) - 2) < 0.05);
  BOOST_TEST(std::abs(order(0, 0) - 1) < 0.1);
  BOOST_TEST(std::abs(order(1, 0) - 1) < 0.1);
}

BOOST_AUTO_TEST_CASE(the_momentum_about_the_contact_needs_reactions_at_the_nodes) {
  ChaplyginBall const ball;
  auto const system = ball.system();
  auto const start = system.state(ball.velocity(), direction(ball.up));
  Triple const k = ball.about_contact(start.point);
  auto const change = [&](double constraint, double reactions, double h) {
    Variant variant(system, h, constraint, reactions, start.velocity);
    ReducedPoint at = start.point;
    double largest = 0;
    for (int step = 0; step < 20; ++step) {
      variant.advance(at);
      Triple const now = ball.about_contact(at), up = triple(at.vectors, 0);
      largest = std::max({largest, std::abs(now.squaredNorm() / k.squaredNorm() - 1),
                          std::abs(now.dot(up) / k.dot(ball.up) - 1)});
    }
    return largest;
  };
  // Twenty steps with some thirty roundings each; wherever the constraint on the velocity is taken.
  double const room = 20 * 32 * 0x1p-52;
  for (double const constraint : {0.0, 0.5, 1.0}) BOOST_TEST(change(constraint, 0, 0.1) < room);
  // In the middle of the step they have a moment about the contact at its ends, of the order of the step.
  BOOST_TEST(change(0.5, 0.5, 0.1) > 1e-4);
  BOOST_TEST(change(0.5, 1, 0.1) > 1e-4);
}

BOOST_AUTO_TEST_SUITE_END()
