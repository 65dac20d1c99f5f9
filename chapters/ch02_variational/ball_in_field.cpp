// A charged ball in a magnetic field: the right-invariant example, with its motion in closed form.
//
// What is shown. The Lagrangian of the ball depends on the spatial angular velocity alone. So the body
// momentum is constant, the spatial momentum precesses about the field on its coadjoint orbit, and the
// attitude is the product of two uniform turns. Read first. Section 2.2.
//
//   g    attitude in SO(3), body to space             l        Lagrangian on the algebra, J
//   xi   spatial velocity g' g^-1, 1/s                gamma B  the field, as a momentum, J s
//   mu   spatial momentum I xi + gamma B, J s         I        moment of inertia of the ball, kg m^2
//   dt   step of the Runge-Kutta method, s
#include "actio/variational/euler_lagrange.hpp"
#include "book/sphere.hpp"
#include "running_examples.hpp"

using namespace actio;
using Ball = State<SO<3>, double>;
using Vector3d = actio::Vector<double, 3>;

double const I = ball_inertia, dt = 1e-3, duration = 8;

// 1. The equations of motion on TG, which use no symmetry, and one step of Runge-Kutta along them.
Ball step(Ball const& v) {
  static auto const L = right_invariant(ball_in_field());
  Ball sum = v, stage = v;
  for (int i = 0; i < 4; ++i) {
    auto const turning = (SO<3>::hat(stage.velocity.coordinates) * stage.configuration.value).eval();
    auto const rate = lagrange_acceleration(L, stage);
    double const share = dt * (i == 0 || i == 3 ? 1 : 2) / 6, next = i == 2 ? dt : dt / 2;
    sum.configuration.value += share * turning, sum.velocity = sum.velocity + share * rate;
    stage.configuration.value = v.configuration.value + next * turning;
    stage.velocity = v.velocity + next * rate;
  }
  return sum;
}

// 2. The same in closed form: a turn about the first momentum, then a turn back about the field.
auto attitude(double t, Vector3d const& mu) { return ball_turned(ball_field, -t) * ball_turned(mu, t); }

int main(int argc, char** argv) {
  book::Program program(argc, argv,
                        "a charged ball in a magnetic field: its momentum precesses, its motion is known");

  // 3. Five starts with the same amount of momentum and different angles to the field.
  auto sphere = book::Sphere(30, 24).axes({"", "", "field"});
  double const amount = 4 * ball_field.norm();
  double apart = 0, body = 0, along_field = 0, around = 0;
  for (double const angle : {0.4, 0.8, 1.2, 1.7, 2.3}) {
    Vector3d const start(amount * std::sin(angle), 0, amount * std::cos(angle));
    Ball v{ball_turned(start, 0), velocity(SO<3>{}, Vector3d((start - ball_field) / I))};
    std::vector<Vector3d> path{start};
    for (int k = 1; k * dt < duration + dt / 2; ++k) {
      v = step(v);
      Vector3d const mu = I * v.velocity.coordinates + ball_field;
      if (k % 20 == 0) path.push_back(mu);
      apart = std::max(apart, (v.configuration.value - attitude(k * dt, start).value).norm());
      body = std::max(body, (v.configuration.value.transpose() * mu - start).norm() / amount);
      along_field = std::max(along_field, std::abs(mu[2] - start[2]) / amount);
      around = std::max(around, (mu - start).norm() / amount);
    }
    sphere.curve(path, angle < 0.5 ? "spatial momentum" : "", {.colour = 1});
  }
  program.picture("precession", sphere.svg(),
                  "The momentum of the charged ball in the spatial frame, for five starts with the same "
                  "amount of momentum: each goes round the field on a circle, a level line of the "
                  "energy on the coadjoint orbit.");
  program.figure("apart", apart, "attitude against its closed form, largest distance");
  program.figure("body", body, "largest change of the body momentum, relative");
  program.figure("around", around, "largest change of the spatial momentum, relative");

  // 4. What must be so. A step has an error of about (dt xi)^5/120, and all of them may add up.
  double const allowed = duration / dt * std::pow(dt * 2 * amount / I, 5) / 120;
  program.claim(book::measured(apart) < allowed, "the attitude is the product of two uniform turns");
  program.claim(book::measured(body) < allowed, "the body momentum is constant");
  program.claim(book::measured(along_field) < allowed,
                "so is the component of the spatial momentum along the field");
  program.claim(book::measured(around) > 0.5, "the spatial momentum itself is not");
  program.headline("attitude of the ball in closed form, to " + book::number(apart, 2), apart);
  return program.finish();
}
