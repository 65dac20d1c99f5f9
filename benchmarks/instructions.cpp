// What is not asked for is not computed: instructions a step, counted by valgrind.
//
// The program counts itself: it starts itself anew under `valgrind --tool=callgrind`, with the words `--steps KIND N`, for two
// numbers of steps; the difference holds no set-up. A count does not depend on what else the machine is doing. Where valgrind
// is missing the program says so and writes no report.
#include <sys/wait.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "actio/free_body/free_steps.hpp"
#include "book/machine.hpp"
#include "callgrind.hpp"

using namespace actio;

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
  HalfTurn<double> const turn(body.flight(0.1));
  auto u = body.start().direction;
  for (; steps > 0; --steps) turn.step(u);
  sink = u[0];
}
void attitude(FreeBody const& body, long steps) {
  HalfTurn<double> const turn(body.flight(0.1));
  auto place = body.start();
  for (; steps > 0; --steps) turn.step(place);
  sink = place.attitude[0] + place.direction[0];
}
void with_energy(FreeBody const& body, long steps) {
  HalfTurn<double> const turn(body.flight(0.1));
  auto place = body.start();
  for (; steps > 0; --steps) {
    turn.step(place);
    sink = energy(body.inverse_moments(), place.direction);
  }
  sink = place.attitude[0];
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

// Instructions of a whole run; negative where valgrind did not give a count.
double instructions(std::string const& self, char const* kind, long steps) {
  return benchmark::instructions_of("'" + self + "' --steps " + kind + " " + std::to_string(steps));
}

int count_steps(char const* key, long steps) {
  for (Kind const& kind : kinds)
    if (!std::strcmp(kind.key, key))
      return kind.run(FreeBody(inertia_from_moments(0.6, 0.8, 1), {SO<3>{}, Eigen::Vector3d(1.8, 0.4, -0.9)}), steps), 0;
  return 2;
}

int main(int argc, char** argv) {
  if (argc == 4 && !std::strcmp(argv[1], "--steps")) return count_steps(argv[2], std::atol(argv[3]));
  book::Program program(argc, argv, "instructions a step: what is not asked for is not computed");
  if (std::system("valgrind --version >/dev/null 2>&1") != 0) {
    program.say("valgrind is not there, so nothing was counted. On Debian: apt-get install valgrind");
    return 0;
  }
  book::report_machine(program);

  std::string const self = std::filesystem::canonical("/proc/self/exe").string();
  // Whole blocks of the compensated motion, between which it sets itself back on its orbit.
  constexpr long few = 10240, many = 4 * few;
  std::vector<book::Program::Row> rows;
  double counts[std::size(kinds)];
  for (std::size_t i = 0; i < std::size(kinds); ++i) {
    double const a = instructions(self, kinds[i].key, few), b = instructions(self, kinds[i].key, many);
    program.claim(a > 0 && b > a, std::string("valgrind counts the steps of: ") + kinds[i].name);
    counts[i] = (b - a) / (many - few);
    rows.push_back({kinds[i].name, book::number(counts[i], 4)});
    program.figure(kinds[i].key, counts[i], book::number(counts[i], 4), std::string(kinds[i].name) + ", instructions a step");
  }
  program.table("instructions", {"a step with", "instructions"}, rows,
                "Instructions a step, counted by valgrind; set-up cancels in the difference of two runs.");
  program.claim(counts[0] < counts[1], "a step without attitude takes fewer instructions than one with it");
  program.claim(counts[1] < counts[2], "a step after which no energy is asked for takes fewer instructions than one with it");
  program.claim(counts[3] < counts[4], "the same holds of the compensated step");
  program.headline("momentum alone " + book::number(counts[0], 4) + " instructions, with attitude " + book::number(counts[1], 4) + ", with energy " +
                       book::number(counts[2], 4),
                   counts[0]);
  return program.finish();
}
