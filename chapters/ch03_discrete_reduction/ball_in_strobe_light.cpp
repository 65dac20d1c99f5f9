// A ball in strobe light: the discrete Euler-Poincare equations (3.10) from the discrete Euler-Lagrange
// equations (3.2), number by number.
//
// What is shown. A charged ball spins in a magnetic field and is photographed every tenth of a second. The
// four conditions of Theorem 3.2.1 are evaluated by four separate pieces of code: along a motion all of them
// vanish, on any other sequence all of them are one and the same covector. A magnet in the ball, on which the
// field acts, breaks the invariance, and the last two fail. Then the reduced motion is compared with the
// precession that theory predicts, and with what the sign of (3.25) in print makes of it.
// Read first. Sections 3.1 and 3.2 of chapter 3, up to Theorem 3.2.1.
//
//   g     attitude in SO(3)                        L    discrete Lagrangian on pairs of attitudes, J s
//   f     relative motion g0 g1^-1                 l    reduced discrete Lagrangian, J s
//   mu    spatial momentum, J s                    h    time between two pictures, s
//
// Compiled at -O2: it takes many steps.
#include "actio/reduction/discrete_lie_poisson.hpp"
#include "actio/reduction/natural_chart.hpp"
#include "book/measure.hpp"
#include "book/sphere.hpp"
#include "four_conditions.hpp"
#include "running_examples.hpp"

using namespace actio;
using book::measured, book::number;
using Conditions = std::array<Covector, 4>;
SO<3> const turns;

// 1. The ball. Its Lagrangian on TG depends on the spatial velocity alone; the natural chart makes a discrete
//    Lagrangian of it, and a reduced one.
double const h = 0.1;
auto const on_TG = [](auto const& v) { return ball_in_field()(v.velocity); };
auto const L = discretize_right(on_TG, h, at_second);               // (3.24)
auto const l = natural_chart_lagrangian_right(ball_in_field(), h);  // (3.25)

// 2. The first two pictures: the step starts with the momentum of a ball that spins about a tilted axis.
Vector<double, 3> const spin(3, 0, 1);  // 1/s
Covector const mu0 = momentum(turns, ball_inertia* spin + ball_field);
auto const guess = exp(-h * velocity(turns, spin));
auto const f01 = relative_motion_from_momentum_right(l, mu0, guess).value;
Attitude const g0 = exp(velocity(turns, Vector<double, 3>(0.4, -0.2, 0.7)));

// 3. Three sequences: a motion; the same with the picture in the middle turned a little; a motion of a ball
//    that is not invariant, because the field acts on a magnet in it.
struct Trial {
  std::string name;
  Conditions conditions;
};
std::vector<Trial> try_the_theorem() {
  auto const g1 = reconstruct_right(g0, f01);
  auto const g2 = step_euler_lagrange(L, g0, g1).value;
  auto const nudge = exp(velocity(turns, Vector<double, 3>(0.05, 0.02, -0.03)));
  auto const L_magnet = [](auto const& a, auto const& b) {
    return L(a, b) + (a.value(2, 2) + b.value(2, 2)) * (h * ball_inertia);
  };
  auto const l_magnet = [](auto const& f) {  // restricted to pairs (f, 1)
    return l(f) + (f.value(2, 2) + 1.0) * (h * ball_inertia);
  };
  auto const p2 = step_euler_lagrange(L_magnet, g0, g1).value;
  return {{"a motion", four_conditions(L, l, {g0, g1, g2})},
          {"middle picture turned", four_conditions(L, l, {g0, nudge * g1, g2})},
          {"a motion, ball with magnet", four_conditions(L_magnet, l_magnet, {g0, g1, p2})}};
}
double size(Covector const& mu) { return mu.components.norm() / mu0.components.norm(); }

// 4. What theory says: mu precesses about the field at the rate |b| / I (Larmor), and g follows.
Vector<double, 3> larmor(double t) { return ball_turned(ball_field, -t).value * mu0.components; }
Attitude at_time(double t) { return ball_turned(ball_field, -t) * ball_turned(mu0.components, t) * g0; }

// 5. Reduced steps: move the momentum by (3.17), put the attitudes together by (3.14), solve (3.10) for the
//    next relative motion.
struct Film {
  std::vector<Vector<double, 3>> momenta;
  Attitude last;
};
template <class Reduced>
Film take_pictures(Reduced const& reduced, double step, int count) {
  auto f = relative_motion_from_momentum_right(reduced, mu0, exp(-step * velocity(turns, spin))).value;
  Film film{{mu0.components}, g0};
  Covector mu = mu0;
  for (int k = 0; k < count; ++k) {
    mu = lie_poisson_update_right(f, mu), film.momenta.push_back(mu.components);
    film.last = reconstruct_right(film.last, f);
    f = step_euler_poincare_right(reduced, f).value;
  }
  return film;
}

// 6. The theorem, on the three sequences.
double show_the_theorem(book::Program& program) {
  auto const trials = try_the_theorem();
  std::vector<book::Program::Row> rows;
  for (auto const& [name, c] : trials)
    rows.push_back(
        {name, number(size(c[0]), 2), number(size(c[1]), 2), number(size(c[2]), 2), number(size(c[3]), 2)});
  program.table(
      "conditions", {"sequence", "(1) action", "(2) DEL", "(3) reduced action", "(4) DEP"}, rows,
      "The four conditions of Theorem 3.2.1 at the middle of three pictures, relative to the momentum.");
  auto const &motion = trials[0].conditions, &nudged = trials[1].conditions, &magnet = trials[2].conditions;
  double same = 0;
  for (Covector const& condition : nudged) same = std::max(same, size(condition - nudged[0]));
  program.claim(measured(size(motion[3])) < 1e-13, "a motion of (3.2) satisfies (3.10)");
  program.claim(measured(same) < 1e-14, "on any sequence the four conditions are one covector");
  program.claim(measured(size(nudged[0])) > 0.01, "which is not zero by itself");
  program.claim(measured(size(magnet[3])) > 0.01, "without invariance (3.10) fails");
  return size(motion[3]);
}

// 7. The order of the attitude after one revolution of the momentum about the field.
double const revolution = 2 * M_PI * ball_inertia / ball_field.norm();
double order_of_the_attitude(book::Program& program) {
  std::vector<double> steps, errors;
  std::vector<book::Program::Row> rows;
  for (int n = 21; n <= 336; n *= 2) {
    double const step = revolution / n;
    Film const film = take_pictures(natural_chart_lagrangian_right(ball_in_field(), step), step, n);
    steps.push_back(step), errors.push_back((film.last.value - at_time(revolution).value).norm());
    rows.push_back({number(steps.back()), number(errors.back(), 2)});
  }
  program.table("order", {"step, s", "error of the attitude"}, rows,
                "After one revolution of the momentum about the field.");
  return book::exponent(steps, errors);
}

int main(int argc, char** argv) {
  book::Program program(argc, argv,
                        "a charged ball photographed in a magnetic field: (3.10) from (3.2), and "
                        "the precession of its momentum");
  double const rounding = show_the_theorem(program);
  double const order = order_of_the_attitude(program);

  // 8. The precession, with the sign of (3.25) as it must be and as it is printed.
  auto const l_printed = [](auto const& f) { return ball_in_field()(log(f) / h) * h; };
  auto const right = take_pictures(l, h, 16).momenta, wrong = take_pictures(l_printed, h, 16).momenta;
  std::vector<Vector<double, 3>> circle;
  for (int k = 0; k <= 200; ++k) circle.push_back(larmor(k * revolution / 200));
  auto sphere = book::Sphere(35, 30).axes({"", "", "field"});
  sphere.curve(circle, "Larmor precession", {.colour = 6, .width = 1})
      .dots(right, "(3.25) with its minus sign", {.colour = 1})
      .dots(wrong, "(3.25) as printed", {.colour = 2});
  program.picture("precession", sphere.svg(), "The direction of the momentum in the first 16 pictures.");
  double const height = std::abs(right.back()[2] / mu0.components[2] - 1);
  program.figure("order", order, number(order, 3), "order of the attitude, fitted");
  program.figure("height", height, "change of the momentum along the field, relative");
  program.claim(measured(std::abs(order - 2)) < 0.05, "the order is 2");
  program.claim(measured(height) < 1e-13, "the momentum along the field is conserved");
  auto const off = [](auto const& momenta) {
    return measured((momenta[8] - larmor(8 * h)).norm() / mu0.components.norm());
  };
  program.claim(off(right) < 0.02, "the momentum follows the Larmor precession");
  program.claim(off(wrong) > 0.5, "with the printed sign it does not");
  program.headline("(3.10) along motions of (3.2) to " + number(rounding, 2), rounding);
  return program.finish();
}
