// From a water molecule to the space station, and to bodies that turn in four, five and eight dimensions:
// what the Moser-Veselov scheme conserves.
//
// What is shown. Moments of inertia from 1e-47 to 1e8 kg m^2, a planar body whose Lambda has a zero on its
// diagonal, and bodies on SO(n): over many steps the Casimir |M|^2 and the momentum in space change by
// rounding alone, and like a random walk. For each body the longest step is computed in closed form; a little
// beyond it the scheme refuses. Read first. Section 5B.1,
// middle_axis_flip.
//
//   M   body momentum             longest   the largest step that has a solution, as the angle |omega| h
//   m   momentum in space         growth    exponent a in: change ~ steps^a (1/2 is a random walk)
//
// Compiled at -O2: it takes many steps.
#include <random>

#include "actio/bodies/body_catalogue.hpp"
#include "actio/rigid_body/body_in_motion.hpp"
#include "book/measure.hpp"
#include "book/plot.hpp"

using namespace actio;

struct Drift {
  double casimir = 0, spatial = 0, energy = 0, growth = 0, longest = 0;
  bool refused = false;
  std::vector<double> steps, drift;
};

// 1. A run of `count` steps of a tenth of a radian gives the largest changes, and how they grow.
template <int n>
Drift drift_of(Inertia<n> const& inertia, Velocity<SO<n>, double> const& xi, long count) {
  Drift found;
  double const h = 0.1 / xi.coordinates.norm();
  MoserVeselov<n> const scheme(inertia, h);
  auto body = release(inertia, identity<double>(inertia.group), xi);
  double const longest = scheme.longest_step(body.body_momentum);
  found.longest = longest * xi.coordinates.norm();
  try {
    MoserVeselov<n>(inertia, 1.001 * longest).relative_motion(body.body_momentum);
  } catch (StepTooLong const& refusal) {
    found.refused = std::abs(refusal.largest_step / longest - 1) < 1e-9;
  }
  // throws where there is none
  MoserVeselov<n>(inertia, 0.999 * longest).relative_motion(body.body_momentum);

  // Momenta in units of their size, so that all squares are near 1.
  auto const start = body.spatial_momentum();
  double const size = start.components.norm(), energy = kinetic_energy(inertia, body.body_momentum);
  double walked = 0;
  for (long k = 1, next = 100; k <= count; ++k) {
    advance(scheme, body);
    if (k % 100 && k != next) continue;
    found.casimir =
        std::max(found.casimir, std::abs((body.body_momentum.components / size).squaredNorm() - 1));
    walked = std::max(walked, (body.spatial_momentum() - start).components.norm() / size);
    found.energy = std::max(found.energy, std::abs(kinetic_energy(inertia, body.body_momentum) / energy - 1));
    if (k == next) found.steps.push_back(k), found.drift.push_back(walked), next = next * 5 / 4;
  }
  found.spatial = walked;

  for (double& d : found.drift) d = std::max(d, 1e-17);
  found.growth = book::exponent(found.steps, found.drift);
  return found;
}

// 2. What the bodies conserved is gathered: a line of the table for each, the worst values, and the curves.
struct Kept {
  std::vector<book::Program::Row> rows;
  double casimir = 0, spatial = 0, least = INFINITY;
  double smallest = INFINITY, largest = 0;  // moments, kg m^2
  bool refused = true;
  book::Plot plot =
      book::Plot("steps", "change of the momentum in space, relative").log_x().log_y().size(660, 340);

  void add(std::string const& name, std::string const& moments, long count, Drift const& found, bool drawn) {
    rows.push_back({name, moments, book::number(static_cast<double>(count), 1),
                    book::number(found.casimir, 2), book::number(found.spatial, 2),
                    book::number(found.energy, 2), book::number(found.growth, 2),
                    book::number(found.longest, 6)});
    casimir = std::max(casimir, found.casimir), spatial = std::max(spatial, found.spatial),
    refused = refused && found.refused, least = std::min(least, found.longest);
    if (drawn) plot.curve(found.steps, found.drift, name);
  }
};

// 3. The bodies of the catalogue come first.
void add_catalogue(Kept& kept) {
  for (Body const& body : read_bodies(ACTIO_DATA "/bodies.toml")) {
    auto const I = body.principal.inertia.moments;
    std::string const unit = body.unit == "ratio" ? "(ratio)" : "kg m²";
    if (body.unit != "ratio")
      kept.smallest = std::min(kept.smallest, I.minCoeff()),
      kept.largest = std::max(kept.largest, I.maxCoeff());
    long const count = 100000;
    kept.add(body.title, book::number(I.minCoeff()) + " to " + book::number(I.maxCoeff()) + " " + unit, count,
             drift_of(body.principal.inertia, body.principal_spin(), count),
             body.name == "water" || body.name == "iss");
  }
}

// 4. Bodies on SO(4), SO(5), SO(8) follow, with Lambda and velocity at random.
void add_random_bodies(Kept& kept, unsigned seed) {
  std::mt19937 random(seed);
  for (int const n : {4, 5, 8}) {
    std::uniform_real_distribution<double> uniform(0.5, 2.0);
    Vector<double> lambda(n), xi(n * (n - 1) / 2);
    for (auto& l : lambda) l = uniform(random);
    for (auto& x : xi) x = uniform(random) - 1.25;
    auto const inertia = inertia_from_lambda<Dynamic, double>(lambda);
    long const count = 40000;
    kept.add("body on SO(" + std::to_string(n) + ")", "0.5 to 2 (Lambda)", count,
             drift_of(inertia, velocity(inertia.group, xi), count), true);
  }
}

// 5. A table shows what they conserved, and a plot the momentum in space beside a random walk.
void show_drifts(book::Program& program, Kept& kept) {
  program.table(
      "kept",
      {"body", "moments", "steps", "Casimir", "momentum in space", "energy", "growth", "longest step, rad"},
      kept.rows,
      "Largest relative changes with steps of 0.1 rad; the exponent with which the change of the momentum "
      "in space grows; and the longest step there is a solution for.");
  std::vector<double> const walk_steps{100, 100000}, walk{1e-15, 1e-15 * std::sqrt(1000.0)};
  kept.plot.curve(walk_steps, walk, "square root of the number of steps", {.colour = 6, .dashed = true});
  program.picture("drift", kept.plot.svg(),
                  "The momentum in space changes like a random walk of rounding errors, for a "
                  "molecule as for a space station.");
  program.figure("casimir", kept.casimir, "largest change of the Casimir, all bodies");
  program.figure("spatial", kept.spatial, "largest change of the momentum in space, all bodies");
  program.figure("magnitudes", std::log10(kept.largest / kept.smallest),
                 book::number(std::log10(kept.largest / kept.smallest), 2),
                 "orders of magnitude between the smallest and the largest moment");
}

int main(int argc, char** argv) {
  book::Program program(argc, argv,
                        "bodies from 1e-47 to 1e8 kg m^2 and in up to eight dimensions: Casimir and "
                        "momentum conserved to rounding");
  unsigned const seed = 20;
  Kept kept;
  add_catalogue(kept);
  program.say("random bodies on SO(n) from seed ", seed);
  add_random_bodies(kept, seed);
  show_drifts(program, kept);

  // 6. What must be so: a random walk of 1e5 roundings is below 1e-13; a hundred times that.
  program.claim(book::measured(kept.casimir) < 1e-11 && book::measured(kept.spatial) < 1e-11,
                "Casimir and momentum in space stay within 1e-11");
  program.claim(book::measured(1 - kept.least) < 1e-9, "no longest step is shorter than one radian");
  program.claim(kept.refused, "a thousandth beyond the longest step every body is refused, with that step");
  program.headline(
      "Casimir conserved to " + book::number(kept.casimir, 2) + " from 1e-47 to 1e8 kg m² and up to SO(8)",
      kept.casimir);
  return program.finish();
}
