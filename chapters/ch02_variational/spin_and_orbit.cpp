// A spinning book: reduction seen from inside the book and from outside.
//
// What is shown. The Lagrangian of a free body is left-invariant, so its motion closes in the algebra
// (Euler-Poincaré, 2.2.1). In the body frame the momentum moves along the curve in which its coadjoint orbit,
// a sphere, meets its level of the energy. In the spatial frame it is constant. Read first. Section 2.2.
//
//   R      attitude in SO(3), body to space            L     Lagrangian on TG, J
//   Omega  body velocity R^-1 R', 1/s                  l     the same on the algebra, a function of Omega
//   Pi     body momentum dl/dOmega, J s                mu    spatial momentum, Pi = Ad*_R mu
//   dt     step of the Runge-Kutta method, s           I     moments of inertia, kg m^2
#include "actio/groups/rotations.hpp"
#include "actio/variational/euler_lagrange.hpp"
#include "actio/variational/euler_poincare.hpp"
#include "book/sphere.hpp"
#include "running_examples.hpp"

using namespace actio;
using Matrix3d = actio::Matrix<double, 3, 3>;
using Vector3d = actio::Vector<double, 3>;

// 1. The book and its Lagrangian: a function of the body velocity, at every
//    scalar; the same one on TG. Axis 1 runs along the height of the book, 2
//    across, 3 through the pages. It is thrown with the momentum of 12 radians
//    a second about the middle axis.
auto const l = thrown_book();
auto const L = left_invariant(l);
auto const& I = book_inertia;
double const amount = 12 * I[1], dt = 1.25e-4, duration = 4;

// 2. A state, attitude and body velocity, and its two momenta, in the frame of
//    the book and in that of space.
struct Motion {
  Matrix3d R;
  Vector3d Omega;
  Motion operator+(Motion const& b) const { return {R + b.R, Omega + b.Omega}; }
};
Motion operator*(double s, Motion const& a) { return {s * a.R, s * a.Omega}; }

Element<SO<3>, double> attitude(Motion const& m) { return {{}, m.R}; }
auto body(Vector3d const& w) { return velocity(SO<3>{}, w); }
auto Pi_of(Motion const& m) { return gradient(l, body(m.Omega)); }
auto mu_of(Motion const& m) { return Ad_star(inverse(attitude(m)), Pi_of(m)); }

// 3. Three equations of motion: Euler-Poincaré in the algebra, with R
//    reconstructed; the same with the sign of right-invariant systems, as a
//    control; and Euler-Lagrange on TG, which uses no symmetry.
Motion reduced(Motion const& m) {
  auto const rate = euler_poincare_acceleration_left(l, body(m.Omega));
  return {m.R * SO<3>::hat(m.Omega), rate.coordinates};
}
Motion wrong_side(Motion const& m) {
  auto const rate = euler_poincare_acceleration_right(l, body(m.Omega));
  return {m.R * SO<3>::hat(m.Omega), rate.coordinates};
}
Motion unreduced(Motion const& m) {
  // On TG the velocity is the spatial one, xi = Ad_R Omega. Turned back, its
  // rate is that of Omega: R itself turns about xi.
  auto const R = attitude(m);
  State<SO<3>, double> const state{R, Ad(R, body(m.Omega))};
  auto const rate = Ad(inverse(R), lagrange_acceleration(L, state));
  return {m.R * SO<3>::hat(m.Omega), rate.coordinates};
}

// 4. One throw: follow it along one of the equations by the classical
//    Runge-Kutta method, and measure what should be constant.
template <class Equation>
Motion step(Equation const& rate, Motion const& m) {
  Motion const k1 = rate(m), k2 = rate(m + dt / 2 * k1);
  Motion const k3 = rate(m + dt / 2 * k2), k4 = rate(m + dt * k3);
  return m + dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
}
struct Throw {
  std::vector<Motion> path;
  double orbit = 0, energy = 0, space = 0;  // largest relative changes
};
template <class Equation>
Throw follow(Equation const& rate, Vector3d const& direction) {
  Vector3d const start = amount * direction.normalized();
  Throw thrown{{{Matrix3d::Identity(), start.cwiseQuotient(I)}}};
  double const energy = l(body(thrown.path[0].Omega));
  auto const keep = [](double& largest, double x) { largest = std::max(largest, x); };
  for (int k = 0; k * dt < duration; ++k) {
    Motion const m = step(rate, thrown.path.back());
    thrown.path.push_back(m);
    keep(thrown.orbit, std::abs(Pi_of(m).components.norm() / amount - 1));
    keep(thrown.energy, std::abs(l(body(m.Omega)) / energy - 1));
    keep(thrown.space, (mu_of(m).components - start).norm() / amount);
  }
  return thrown;
}

// 5. The body momenta of a throw, for the picture of the sphere.
std::vector<Vector3d> polhode(Throw const& thrown) {
  std::vector<Vector3d> momenta;
  for (std::size_t k = 0; k < thrown.path.size(); k += 16)
    momenta.push_back(Pi_of(thrown.path[k]).components);
  return momenta;
}

// 6. Throws about all axes, and one nearly about the middle axis: the largest changes of all of them.
Throw throw_about_all_axes(book::Program& program) {
  auto sphere = book::Sphere(38, 24).axes({"1 height", "2 width", "3 pages"});
  Throw worst;
  auto const draw = [&](Vector3d const& direction, std::string const& label, int colour) {
    Throw const thrown = follow(reduced, direction);
    sphere.curve(polhode(thrown), label, {.colour = colour});
    worst.orbit = std::max(worst.orbit, thrown.orbit), worst.energy = std::max(worst.energy, thrown.energy);
    worst.space = std::max(worst.space, thrown.space);
  };
  for (double const tilt : {0.3, 1.0}) {
    draw({1, tilt, 0}, tilt < 1 ? "round the axis of the smallest moment" : "", 2);
    draw({0, tilt, 1}, tilt < 1 ? "round the axis of the largest moment" : "", 1);
  }
  draw({0.01, 1, 0.01}, "thrown about the middle axis", 4);
  program.picture("orbit", sphere.svg(),
                  "The momentum of a thrown book in the body frame: five throws with the same amount of "
                  "momentum, so all on one sphere, the coadjoint orbit. Each follows a level of the "
                  "energy. About the middle axis nothing stays near: that book turns over.");
  return worst;
}

// 7. The same throw along the three equations.
struct Compared {
  Throw right, whole, wrong;
  double apart = 0;   // attitudes of the first two
  double lowest = 1;  // the momentum about the middle axis, over its magnitude
};
Compared throw_about_the_middle(book::Program& program) {
  Vector3d const middle(0.01, 1, 0.01);
  Compared all{follow(reduced, middle), follow(unreduced, middle), follow(wrong_side, middle)};
  auto const& [right, whole, wrong, apart, lowest] = all;
  for (std::size_t k = 0; k < right.path.size(); ++k) {
    all.apart = std::max(apart, (right.path[k].R - whole.path[k].R).norm());
    all.lowest = std::min(lowest, Pi_of(right.path[k]).components[1] / amount);
  }
  program.table("three", {"equation", "|Pi| changes by", "energy changes by", "mu changes by"},
                {{"Euler-Poincaré, left", book::number(right.orbit), book::number(right.energy),
                  book::number(right.space)},
                 {"Euler-Lagrange on TG", book::number(whole.orbit), book::number(whole.energy),
                  book::number(whole.space)},
                 {"Euler-Poincaré, right: the wrong side", book::number(wrong.orbit),
                  book::number(wrong.energy), book::number(wrong.space)}},
                "One throw about the middle axis: largest relative changes");
  return all;
}

int main(int argc, char** argv) {
  book::Program program(argc, argv,
                        "a spinning book: its momentum runs round a sphere as seen from the book, and "
                        "stands still as seen from space");
  program.say("moments of inertia, kg m^2: ", I[0], ", ", I[1], ", ", I[2]);
  Throw const worst = throw_about_all_axes(program);
  auto const [right, whole, wrong, apart, lowest] = throw_about_the_middle(program);
  program.figure("space", worst.space, "largest change of the spatial momentum, relative");
  program.figure("apart", apart, "reduced and unreduced motion, largest distance of the attitudes");
  program.figure("wrong_side", wrong.space, "change of the spatial momentum with the sign of the other side");

  // 8. What must be so. A step has an error of about (dt Omega)^5/120, and all of them may add up; a
  // hundredth off the unstable axis a motion is a hundred times as sensitive.
  double const allowed = duration / dt * std::pow(dt * amount / I[0], 5) / 120;
  program.claim(book::measured(worst.orbit) < allowed && book::measured(worst.energy) < allowed,
                "the body momentum stays on its sphere and on its level of the energy");
  program.claim(book::measured(worst.space) < allowed, "the spatial momentum is constant");
  program.claim(book::measured(apart) < 100 * allowed,
                "Euler-Poincaré with reconstruction gives the motion of Euler-Lagrange");
  program.claim(book::measured(wrong.orbit) < 100 * allowed && book::measured(wrong.space) > 0.5,
                "with the sign of the other side the sphere is kept and the spatial momentum is not");
  program.claim(book::measured(lowest) < -0.9, "thrown about the middle axis the book turns over");
  program.headline("spatial momentum conserved to " + book::number(worst.space, 2) +
                       ", not with the sign of the other side",
                   worst.space);
  return program.finish();
}
