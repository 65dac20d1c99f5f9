// The scheme for rods against generalised-alpha, on the same elements.
//
// What is shown. A rod is pulled, twisted and let go in space (flying spaghetti), and two schemes in time are
// held to a reference of the same elements: explicit steps that conserve momenta, and generalised-alpha,
// which solves equations in every step and may damp fast waves. Then a slender rod, where explicit steps must
// be as short as its fastest wave, while generalised-alpha may step over that. Read first. Section 10G.
//
//   h     step     rho  amplification of the fastest waves by generalised-alpha
//
// Compiled at -O2: it takes many steps.
#include "actio/rods/rod.hpp"
#include "actio/rods/step_limit.hpp"
#include "book/measure.hpp"
#include "book/program.hpp"
#include "witness/generalised_alpha.hpp"

using namespace actio;
using namespace actio::rods;
using Table = std::vector<book::Program::Row>;

// 1. What both methods give, at the end of a run.
struct Outcome {
  std::vector<Three<double>> places;
  double seconds, solves;  // in all
};
double distance(Outcome const& run, RodMotion const& truth) {
  double out = 0;
  for (std::size_t k = 0; k < run.places.size(); ++k)
    for (std::size_t i = 0; i < 3; ++i)
      out = std::max(out, std::abs(run.places[k][i] - truth.shape.places[k][i]));
  return out;
}
template <class Make, class Look>
Outcome timed(Make const& make, double steps, Look const& look) {
  Outcome out{{}, HUGE_VAL, 0};
  for (int k = 0; k < 3; ++k) {  // the shortest of some
    auto run = make();
    out.seconds = std::min(out.seconds, book::seconds_of([&] {
                             for (long j = 0; j < std::lround(steps); ++j) run.step();
                           }));
    look(run, out);
  }
  return out;
}

// 2. What happens to energy and angular momentum in free flight.
struct Flight {
  double energy = 0, last = 0, angular = 0;

  /// @param measure  gives energy and angular momentum
  template <class Run, class Measure>
  Flight(Run run, double from, double to, double h, Measure const& measure) {
    for (long k = 0; k < std::lround(from / h); ++k) run.step();
    auto const [E, L] = measure(run);
    for (long k = 0; k < std::lround((to - from) / h); ++k) {
      run.step();
      auto const [now, turn] = measure(run);
      last = now / E - 1, energy = std::max(energy, std::abs(last));
      angular = std::max(angular, (turn - L).norm() / L.norm());
    }
  }
};

int main(int argc, char** argv) {
  book::Program program(argc, argv, "rods in explicit steps and by generalised-alpha");
  (void)program;
  return program.finish();
}
