// A T-handle turning about its middle axis turns over, again and again, and so does a book in the air: the
// Moser-Veselov scheme against a closed form.
//
// What is shown. A free body that turns about its middle axis flips at regular intervals, and the interval
// has a closed form. The scheme reproduces it to second order in the step, and conserves momentum and energy
// to rounding meanwhile. The book of the running example is thrown about its middle axis too. Read first.
// Section 5.2.
//
//   I      principal moments, ascending, kg m^2        h     step, s
//   omega  body velocity, rad/s                        M     body momentum, J s
#include <gsl/gsl_sf_ellint.h>

#include "actio/bodies/body_catalogue.hpp"
#include "actio/rigid_body/body_in_motion.hpp"
#include "book/measure.hpp"
#include "book/plot.hpp"
#include "running_examples.hpp"

using namespace actio;
using Vector3d = actio::Vector<double, 3>;

// The time between two flips is half the period of the middle component: 2K(k)/lambda, with Jacobi's
// functions (differences of L^2 and 2 E I_i written without cancellation).
double flip_time(Vector3d I, Vector3d omega) {
  auto const excess = [&](int i) {  // L^2 - 2 E I_i
    double sum = 0;
    for (int j = 0; j < 3; ++j) sum += I[j] * (I[j] - I[i]) * omega[j] * omega[j];
    return sum;
  };
  if (excess(1) < 0) std::swap(I[0], I[2]), std::swap(omega[0], omega[2]);
  double const lambda = std::sqrt((I[2] - I[1]) * excess(0) / I.prod());
  double const k = std::sqrt((I[1] - I[0]) * -excess(2) / ((I[2] - I[1]) * excess(0)));
  return 2 * gsl_sf_ellint_Kcomp(k, GSL_PREC_DOUBLE) / lambda;
}

// 1. The body: two cylinders, its moments computed from their sizes. Returns the time between two flips.
double present_handle(book::Program& program, Body const& handle) {
  Vector3d const I = handle.principal.inertia.moments, omega = handle.principal_spin().coordinates;
  program.say("moments of inertia, kg m^2: ", I[0], ", ", I[1], ", ", I[2],
              "; turning about the middle one at ", omega[1], " rad/s");
  double const flip = flip_time(I, omega);
  program.figure("flip", flip, book::number(flip, 9) + " s",
                 "time between two flips, closed form (elliptic integral)");
  return flip;
}

// 2. The time between flips from the scheme, at finer and finer steps: ten flips, each seen where the middle
//    component changes sign. Returns the order.
double refine_steps(book::Program& program, Body const& handle, double flip) {
  std::vector<double> steps, errors;
  std::vector<book::Program::Row> rows;
  for (double h = 0.02; h > 0.0011; h /= 2) {
    MoserVeselov<3> const scheme(handle.principal.inertia, h);
    auto body = release(handle.principal.inertia, identity<double>(SO<3>{}), handle.principal_spin());
    std::vector<double> crossings;
    for (double t = 0, before = handle.principal_spin().coordinates[1]; crossings.size() < 11; t += h) {
      advance(scheme, body);
      double const after = body_velocity(handle.principal.inertia, body.body_momentum).coordinates[1];
      if (before * after < 0) crossings.push_back(t + h * before / (before - after));
      before = after;
    }
    double const measured = (crossings.back() - crossings.front()) / 10;
    steps.push_back(h), errors.push_back(std::abs(measured / flip - 1));
    rows.push_back({book::number(h), book::number(measured, 9), book::number(errors.back())});
  }
  double const order = book::exponent(steps, errors);
  program.table("flip_times", {"step, s", "time between flips, s", "relative error"}, rows,
                "Time between flips from the Moser-Veselov scheme, against the closed form.");
  program.figure("order", order, "order in the step of the time between flips");
  return order;
}

// 3. The first twenty seconds.
void draw_first_flips(book::Program& program, Body const& handle) {
  double const h = 0.02;
  MoserVeselov<3> const scheme(handle.principal.inertia, h);
  auto body = release(handle.principal.inertia, identity<double>(SO<3>{}), handle.principal_spin());
  std::vector<double> time;
  std::array<std::vector<double>, 3> component;
  for (double t = 0; t < 20; t += h) {
    time.push_back(t);
    for (int i = 0; i < 3; ++i)
      component[i].push_back(body.body_momentum.components[i] / handle.principal.inertia.moments[i]);
    advance(scheme, body);
  }
  auto flips = book::Plot("time, s", "body velocity, rad/s").size(660, 320);
  flips.curve(time, component[0], "axis of the smallest moment", {.colour = 2});
  flips.curve(time, component[1], "middle axis, the stem", {.colour = 4, .width = 2.2});
  flips.curve(time, component[2], "axis of the largest moment", {.colour = 1});
  program.picture("flip", flips.svg(),
                  "Body velocity of the T-handle. It rests, so it seems, on its middle axis, and "
                  "then turns over within a second.");
}

// 4. The book of the running example, thrown at two turns a second about its middle axis: its attitude at
//    sixty moments a second, for the animation. Returns the largest change of energy.
double throw_the_book(book::Program& program) {
  auto const book = inertia_from_moments<double>(book_inertia);
  auto const spin = velocity(SO<3>{}, Vector3d(0.3, 4 * M_PI, 0));
  double const h = 1.0 / 480, energy = kinetic_energy(book, spin);
  MoserVeselov<3> const scheme(book, h);
  auto body = release(book, identity<double>(SO<3>{}), spin);
  std::vector<std::vector<double>> attitudes;
  double change = 0;
  for (int frame = 0; frame < 480; ++frame) {
    attitudes.push_back({frame / 60.0});
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) attitudes.back().push_back(body.attitude.value(i, j));
    for (int k = 0; k < 8; ++k) advance(scheme, body);
    change = std::max(change, std::abs(kinetic_energy(book, body.body_momentum) / energy - 1));
  }
  program.motion("flip", {"t", "R00", "R01", "R02", "R10", "R11", "R12", "R20", "R21", "R22"}, attitudes);
  program.figure("a", 0.24, "length of the book along its first axis, m");
  program.figure("b", 0.16, "along its second");
  program.figure("c", 0.03, "along its third");
  program.figure("book_energy", change, "largest relative change of the energy of the book in eight seconds");
  return change;
}

int main(int argc, char** argv) {
  book::Program program(argc, argv, "a T-handle and a book turn over every few moments, for ever");
  Body const handle = read_body(ACTIO_DATA "/bodies.toml", "t_handle");
  double const flip = present_handle(program, handle);
  double const order = refine_steps(program, handle, flip);
  draw_first_flips(program, handle);
  double const change = throw_the_book(program);

  // 5. What must be so: second order, and the energy of the book to rounding.
  program.claim(book::measured(std::abs(order - 2)) < 0.05,
                "the time between flips is right to second order in the step");
  program.claim(book::measured(change) < 1e-12, "the energy of the book stays within 1e-12");
  program.headline("time between flips to order " + book::number(order, 3), order);
  return program.finish();
}
