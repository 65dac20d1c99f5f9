// Motions of rods that are known exactly: what the steps make of them.
//
// What is shown. A helix that turns about its axis, a ring that spins and small waves along a rod have closed
// forms in the continuum, and the scheme has closed forms of its own for the same motions, which steps follow
// to rounding. Read first. Section 10G.
//
//   D   length of an element     h   step     r, p   radius and pitch of a helix
//
// Compiled at -O2: it takes many steps.
#include "book/measure.hpp"
#include "book/program.hpp"
#include "witness/rod_solutions.hpp"

using namespace actio;
using namespace actio::rods;
using Table = std::vector<book::Program::Row>;
using List = std::vector<double>;

RodSection const thick{{60, 25, 25}, {0.5, 0.8, 0.8}, 1, {0.06, 0.03, 0.03}};

// 1. A helix that turns, between ends that are moved along. In the continuum its radius and pitch solve two
// conditions; in steps they solve the same ones with (2/D) tan(c D/2) and (2/h) sin(a h/2) for c and a.
void helix(book::Program& program) {
  double const c = 0.9, lean = 0.5, a = 0.6;
  auto const smooth = RotatingHelix::of(thick, c, lean, a);
  Table rows;
  List lengths, radii, pitches;
  double farthest = 0;
  for (int const elements : {10, 20, 40, 80}) {
    double const D = 4.0 / elements, h = D / 10;
    auto const discrete = RotatingHelix::in_steps(thick, c, lean, a, D, h);
    Rod rod(thick, RodShape::of_strains(4, elements, {}, {1, 0, 0, 0}), discrete.start(elements + 1, D, h),
            discrete.moved_ends(4), {.step = h});
    double off = 0;
    for (int k = 0; k < 100; ++k)
      rod.step(100), off = std::max(off, discrete.distance(rod.frame(), D, rod.time()));
    lengths.push_back(D), radii.push_back(std::abs(discrete.radius - smooth.radius));
    pitches.push_back(std::abs(discrete.pitch - smooth.pitch)), farthest = std::max(farthest, off);
    rows.push_back({book::number(D), book::number(h), book::number(discrete.radius, 12),
                    book::number(discrete.pitch, 12), book::number(radii.back()),
                    book::number(pitches.back()), book::number(off, 2)});
  }
  program.table("helix", {"D", "h", "r", "p", "r less that of the continuum", "the same of p", "off it"},
                rows, "A helix that turns, in closed form, and how far 10000 steps lead away from it.");
  program.figure("radius", smooth.radius, book::number(smooth.radius, 15), "r in the continuum");
  program.figure("pitch", smooth.pitch, book::number(smooth.pitch, 15), "p in the continuum");
  program.claim(book::measured(farthest) < 1e-12, "10000 steps stay on the discrete helix");
  double const order = book::exponent(lengths, radii), other = book::exponent(lengths, pitches);
  program.figure("helix_order", order, "order of the radius");
  program.claim(book::measured(order) > 1.97 && book::measured(order) < 2.03, "its radius has order 2");
  program.claim(book::measured(other) > 1.97 && book::measured(other) < 2.03, "its pitch has order 2");
  program.headline("10000 steps stay on a turning helix to " + book::number(farthest, 2), farthest);
}

// 2. Small waves between pinned ends, against the closed form in steps and against Timoshenko's beam.
void waves(book::Program& program) {
  Table rows;
  double farthest = 0;
  for (int const mode : {1, 5})
    for (bool const upper : {false, true}) {
      List lengths, errors;
      rows.push_back({std::to_string(mode), upper ? "shear" : "bending"});
      for (int const elements : {10 * mode, 20 * mode, 40 * mode}) {
        PinnedWave const wave{thick, 4, elements, mode, upper};
        double const h = wave.element() / 20, A = 1e-7;
        auto const rest = RodShape::of_strains(4, elements, {}, {1, 0, 0, 0});
        Rod rod(thick, rest, wave.start(A), PinnedWave::ends(), {.step = h});
        double off = 0;
        for (int k = 0; k < 200; ++k)
          rod.step(), off = std::max(off, wave.distance(rod.frame(), A, wave.frequency(h) * rod.time()));
        farthest = std::max(farthest, off);
        lengths.push_back(h), errors.push_back(std::abs(wave.frequency(h) / wave.of_beam() - 1));
        if (lengths.size() == 1) rows.back().push_back(book::number(wave.of_beam(), 8));
        rows.back().push_back(book::number(off, 2));
      }
      double const order = book::exponent(lengths, errors);
      rows.back().push_back(book::number(errors.back(), 2)), rows.back().push_back(book::number(order, 4));
      program.claim(book::measured(order) > 1.97 && book::measured(order) < 2.03,
                    "frequencies tend to those of Timoshenko's beam with order 2: " + rows.back()[1] + " " +
                        rows.back()[0]);
    }
  program.table(
      "waves",
      {"half waves", "branch", "frequency of the beam", "off, 10 elements a half wave", "20", "40",
       "frequency, at last", "order"},
      rows,
      "Small waves: how far 200 steps lead from the closed form, relative to the amplitude, and the "
      "frequency against that of the beam.");
  program.claim(book::measured(farthest) < 1e-9, "waves in steps are those of the closed form");
}

// 3. A ring that spins: any number of elements gives the stretch of the continuum.
void ring(book::Program& program) {
  Table rows;
  double farthest = 0;
  for (int const elements : {6, 12, 24}) {
    double const r0 = 1, a = 1.5, h = 0.005, D = 2 * r0 * std::tan(M_PI / elements);
    double const turn = 2 * M_PI / elements / D;
    RotatingHelix const rest{turn, 0, 0, r0, 0};
    RotatingHelix const spinning{turn, 0, a, spinning_radius(thick, r0, 2 / h * std::sin(a * h / 2)), 0};
    Rod rod(thick, rest.start(elements, D, h, true).shape, spinning.start(elements, D, h, true), {},
            {.step = h});
    double off = 0;
    for (int k = 0; k < 20; ++k)
      rod.step(100), off = std::max(off, spinning.distance(rod.frame(), D, rod.time()));
    farthest = std::max(farthest, off);
    rows.push_back({std::to_string(elements), book::number(spinning.radius / r0, 12),
                    book::number(spinning.radius / spinning_radius(thick, r0, a) - 1, 2),
                    book::number(off, 2)});
  }
  program.table("ring", {"elements", "stretch", "against the continuum", "off it after 2000 steps"}, rows,
                "A ring that spins.");
  program.claim(book::measured(farthest) < 1e-12, "a spinning ring keeps the radius of the closed form");
}

int main(int argc, char** argv) {
  book::Program program(argc, argv, "a helix, waves and a ring: motions of rods that are known exactly");
  helix(program), waves(program), ring(program);
  return program.finish();
}
