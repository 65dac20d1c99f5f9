// Ten million steps of every body of the catalogue, and a million of bodies on SO(4) to SO(8): what the
// Moser-Veselov scheme still keeps.
//
// The bounds are what rounding does if it walks at random, a few epsilon a step, with a hundredfold of room;
// a drift in proportion to the steps would be ten times beyond them. Minutes, not seconds: `./run stress`.
#include <random>

#include "actio/bodies/body_catalogue.hpp"
#include "actio/rigid_body/body_in_motion.hpp"
#include "book/measure.hpp"
#include "book/program.hpp"

using namespace actio;

struct Kept {
  double casimir = 0, spatial = 0, energy = 0, growth = 0;
};

/// The largest relative changes over `count` steps of a tenth of a radian; `growth` is the exponent of that
/// in space, fitted to the logarithms.
template <int n>
Kept keep(Inertia<n> const& inertia, Velocity<SO<n>, double> const& xi, long count) {
  Kept kept;
  MoserVeselov<n> const scheme(inertia, 0.1 / xi.coordinates.norm());
  auto body = release(inertia, identity<double>(inertia.group), xi);
  auto const start = body.spatial_momentum();
  double const size = start.components.norm(), energy = kinetic_energy(inertia, body.body_momentum);
  std::vector<double> steps, drift;
  for (long k = 1, next = 1000; k <= count; ++k) {
    advance(scheme, body);
    if (k % 1000 && k != next) continue;
    kept.casimir = std::max(kept.casimir, std::abs((body.body_momentum.components / size).squaredNorm() - 1));
    kept.spatial = std::max(kept.spatial, (body.spatial_momentum() - start).components.norm() / size);
    kept.energy = std::max(kept.energy, std::abs(kinetic_energy(inertia, body.body_momentum) / energy - 1));
    if (k != next) continue;
    steps.push_back(static_cast<double>(k)), drift.push_back(std::max(kept.spatial, 1e-17)),
        next = next * 5 / 4;
  }
  kept.growth = book::exponent(steps, drift);
  return kept;
}

int main(int argc, char** argv) {
  book::Program program(argc, argv, "ten million steps: Casimir, energy and momentum in space");
  std::vector<book::Program::Row> rows;
  double worst = 0;
  auto const add = [&](std::string const& name, long count, Kept const& kept) {
    rows.push_back({name, book::number(static_cast<double>(count), 1), book::number(kept.casimir, 2),
                    book::number(kept.spatial, 2), book::number(kept.energy, 2),
                    book::number(kept.growth, 2)});
    double const walk = 100 * std::numeric_limits<double>::epsilon() * std::sqrt(static_cast<double>(count));
    worst = std::max({worst, kept.casimir / walk, kept.spatial / walk, kept.energy / walk});
    program.say(name, ": Casimir ", book::number(kept.casimir, 2), ", momentum in space ",
                book::number(kept.spatial, 2), ", growth ", book::number(kept.growth, 2));
  };
  for (Body const& body : read_bodies(ACTIO_DATA "/bodies.toml"))
    add(body.title, 10'000'000, keep(body.principal.inertia, body.principal_spin(), 10'000'000));

  unsigned const seed = 20;
  program.say("random bodies on SO(n) from seed ", seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0.5, 2.0);
  for (int const n : {4, 5, 6, 8}) {
    Vector<double> lambda(n), xi(n * (n - 1) / 2);
    for (auto& l : lambda) l = uniform(random);
    for (auto& c : xi) c = uniform(random) - 1.25;
    auto const inertia = inertia_from_lambda<Dynamic, double>(lambda);
    add("body on SO(" + std::to_string(n) + ")", 1'000'000,
        keep(inertia, velocity(inertia.group, xi), 1'000'000));
  }
  program.table("kept", {"body", "steps", "Casimir", "momentum in space", "energy", "growth"}, rows,
                "Largest relative changes with steps of 0.1 rad.");
  program.claim(worst < 1, "all changes stay within 100 eps times the square root of the number of steps");
  program.headline("all kept within " + book::number(worst, 2) + " of 100 eps sqrt(steps)", worst);
  return program.finish();
}
