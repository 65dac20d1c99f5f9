// A slender rod: three methods, and when to take which.
//
// What is shown. The fastest wave along a slender rod is a turn of its sections, as short as the rod is thin,
// and explicit steps must be shorter than its period. Without stretch and shear it is gone, and steps may be
// as long as a wave of bending takes for an element. Generalised-alpha steps over all of them, for systems of
// equations in every step. Read first. Section 10G.
//
//   h   step     rho   amplification of the fastest waves by generalised-alpha
//
// Compiled at -O2: it takes many steps.
#include "actio/rods/step_limit.hpp"
#include "ch10_outlook/rod_runs.hpp"

using namespace actio;
using namespace actio::rods;
using Table = std::vector<book::Program::Row>;

int main(int argc, char** argv) {
  book::Program program(argc, argv, "a slender rod by three methods");
  // 1. A rod of length and mass 1, with a speed of sound of 1; its radius is a five-hundredth of its length.
  // It is let go, bent like a wave: this is a fourth part of its slowest oscillation.
  double const radius = 2e-3, area = M_PI * radius * radius, time = 96;
  auto const section = RodSection::circular(radius, 1 / area, 0.25, 1 / area);
  auto const rest = RodShape::of_strains(1, 10, {}, {1, 0, 0, 0});
  auto const bent = RodShape::of_strains(1, 10, {}, {1, 0, 0, 0}, [](double s) {
    return Three<double>{0, 0.3 * (1 - std::cos(2 * M_PI * s)), 0.5 * (1 - std::cos(2 * M_PI * s))};
  });
  SemiDiscreteRod const elements(section, rest);
  auto const begin = RodMotion::at_rest(bent);
  auto const truth = begin.later(elements, 0, time, 1e-9);

  // 2. Explicit steps, with and without stretch and shear.
  Table rows;
  double longest = 0, explicit_error = 0;
  for (bool const unshearable : {false, true}) {
    Rod const any(section, rest, {bent, {}, {}}, {}, {.step = 1e-4, .unshearable = unshearable});
    double const limit = longest_rod_step(any.constants(), unshearable);
    program.figure(unshearable ? "limit_unshearable" : "limit", limit, "longest explicit step");
    if (!unshearable) longest = limit;
    for (double const part : {0.75, 0.375}) {
      double const h = time / std::ceil(time / (part * limit));
      auto const run = measure(
          Rod(section, rest, {bent, {}, {}}, {}, {.step = h, .unshearable = unshearable}), h, time, 0, truth);
      rows.push_back(row_of(unshearable ? "without stretch and shear" : "explicit", run, false));
      rows.back().push_back(book::number(1e-3 * run.microseconds * time / h, 2));
      explicit_error = std::max(explicit_error, run.error);
    }
  }

  // 3. Generalised-alpha, over a thousand of those steps at a time.
  double first = 0;
  for (double const rho : {0.9, 0.6})
    for (double const h : {8.0, 4.0, 2.0, 1.0}) {
      auto const run = measure(GeneralisedAlpha(elements, begin, rho, h), h, time, 0, truth);
      rows.push_back(row_of("alpha, rho = " + book::number(rho), run, false));
      rows.back().push_back(book::number(1e-3 * run.microseconds * time / h, 2));
      if (h == 4) first = std::max(first, run.error);
    }
  program.table("slender", {"method", "h", "error", "solves", "microseconds", "milliseconds in all"}, rows,
                "A slender rod of ten elements, let go. Systems of equations and microseconds are those of a "
                "step; the error is that of places, for a rod of length 1.");
  program.claim(
      book::measured(4 / longest) > 1000 && book::measured(first) < 1e-3,
      "generalised-alpha steps over a thousand explicit steps at once, to a thousandth of the length");
  program.claim(book::measured(explicit_error) < 1e-4, "explicit steps and the reference meet");

  // 4. When to take which.
  program.table("choice", {"take", "if", "since"},
                {{"explicit steps", "waves along the rod matter, or it is not slender",
                  "no equations are solved; momenta are conserved, the energy has no drift"},
                 {"explicit steps without stretch and shear", "a slender rod bends and twists",
                  "steps are longer by about the length of an element over the radius"},
                 {"generalised-alpha", "the motion is slower than bending of one element by far",
                  "steps are as long as the motion allows; fast waves are damped, momenta change a little"}},
                "Methods for rods.");
  program.headline("generalised-alpha steps over " + book::number(4 / longest, 2) + " explicit steps at once",
                   4 / longest);
  return program.finish();
}
