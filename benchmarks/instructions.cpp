// What is not asked for is not computed: instructions a step, counted by valgrind.
//
// The program counts itself: it starts itself anew under `valgrind --tool=callgrind`, with the word
// `--count`, and takes two numbers of steps of each kind; the difference holds no set-up. A count does not
// depend on what else the machine is doing. Where valgrind is missing the program says so and writes no
// report.
#include <Eigen/Core>

#include <cstdlib>
#include <cstring>

#include "actio/fast_body/space/free_steps.hpp"
#include "benchmark.hpp"
#include "callgrind.hpp"

using namespace actio;
using namespace actio::bodies;

struct Kind {
  char const* key;
  char const* name;
  void (*run)(FreeBody const&, long);
};

// So that no compiler leaves out what is computed.
double volatile sink;

double energy(InverseMoments<double> const& body, Three<double> const& u) {
  return body.J[0] * u[0] * u[0] + body.J[1] * u[1] * u[1] + body.J[2] * u[2] * u[2];
}

void momentum(FreeBody const& body, long steps) {
  HalfTurn<double> const turn(body.step_parameters(0.1));
  auto u = body.start().direction;
  for (; steps > 0; --steps) turn.step(u);
  sink = u[0];
}
void attitude(FreeBody const& body, long steps) {
  HalfTurn<double> const turn(body.step_parameters(0.1));
  auto state = body.start();
  for (; steps > 0; --steps) turn.step(state);
  sink = state.attitude[0] + state.direction[0];
}
void with_energy(FreeBody const& body, long steps) {
  HalfTurn<double> const turn(body.step_parameters(0.1));
  auto state = body.start();
  for (; steps > 0; --steps) {
    turn.step(state);
    sink = energy(body.inverse_moments(), state.direction);
  }
  sink = state.attitude[0];
}
void compensated_momentum(FreeBody const& body, long steps) {
  FreeSteps motion(body, 0.1);
  motion.advance_momentum(steps);
  sink = motion.body_momentum().components[0];
}
void compensated(FreeBody const& body, long steps) {
  FreeSteps motion(body, 0.1);
  motion.advance(steps);
  sink = motion.state().attitude.value[0];
}

Kind const kinds[] = {{"momentum", "momentum alone", momentum},
                      {"attitude", "momentum and attitude", attitude},
                      {"energy", "momentum, attitude, and the energy after each step", with_energy},
                      {"compensated_momentum", "compensated, momentum alone", compensated_momentum},
                      {"compensated", "compensated, momentum and attitude", compensated}};

// Whole blocks of the compensated motion, between which it sets itself back on its orbit.
constexpr long few = 10240, many = 4 * few;

int count_all() {
  FreeBody const body(inertia_from_moments(0.6, 0.8, 1), {SO<3>{}, Eigen::Vector3d(1.8, 0.4, -0.9)});
  for (Kind const& kind : kinds) {
    benchmark::counted((kind.key + std::string(" few")).c_str(), [&] { kind.run(body, few); });
    benchmark::counted((kind.key + std::string(" many")).c_str(), [&] { kind.run(body, many); });
  }
  return 0;
}

int main(int argc, char** argv) {
  if (argc == 2 && !std::strcmp(argv[1], "--count")) return count_all();
  benchmark::Benchmark program(argc, argv, "instructions a step: what is not asked for is not computed");
  if (!benchmark::pieces_can_be_counted()) {
    program.say(
        "valgrind is not there, or was not when this program was compiled, so nothing was counted. On "
        "Debian: apt-get install valgrind");
    return 0;
  }

  std::string const self = std::filesystem::canonical("/proc/self/exe").string();
  auto const counted = benchmark::counted_pieces("'" + self + "' --count");
  auto const count_of = [&](std::string const& name) {
    return counted.contains(name) ? counted.at(name) : -1;
  };
  std::vector<book::Program::Row> rows;
  double counts[std::size(kinds)];
  for (std::size_t i = 0; i < std::size(kinds); ++i) {
    double const a = count_of(kinds[i].key + std::string(" few")),
                 b = count_of(kinds[i].key + std::string(" many"));
    program.claim(a > 0 && b > a, std::string("valgrind counts the steps of: ") + kinds[i].name);
    counts[i] = (b - a) / (many - few);
    rows.push_back({kinds[i].name, book::number(counts[i], 4)});
    program.figure(kinds[i].key, counts[i], book::number(counts[i], 4),
                   std::string(kinds[i].name) + ", instructions a step");
  }
  program.table(
      "instructions", {"a step with", "instructions"}, rows,
      "Instructions a step, counted by valgrind; set-up cancels in the difference of two numbers of steps.");
  program.claim(counts[0] < counts[1], "a step without attitude takes fewer instructions than one with it");
  program.claim(counts[1] < counts[2],
                "a step after which no energy is asked for takes fewer instructions than one with it");
  program.claim(counts[3] < counts[4], "the same holds of the compensated step");
  program.headline("momentum alone " + book::number(counts[0], 4) + " instructions, with attitude " +
                       book::number(counts[1], 4) + ", with energy " + book::number(counts[2], 4),
                   counts[0]);
  return program.finish();
}
