// The free body at length: a hundred million steps, ten thousand nasty bodies against 50 digits, and the
// bodies that break codes beside other methods.
//
// Nothing is taken on trust from the code under test: power series in the time judge it, and the exact flow
// in 50 digits only after these series have judged that. What an answer may be off by is said by the
// question: the same truth is computed again with each number of the question moved by one unit in its last
// place.
#include <chrono>

#include "../fast_body/hard_bodies.hpp"
#include "actio/numbers/multiprecision.hpp"
#include "book/measure.hpp"
#include "book/program.hpp"

using namespace actio;
using namespace actio::bodies;
using testing::FreePath, testing::FreeProblem, testing::ConservationErrors, testing::conservation_errors;

namespace {
constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr std::uint64_t seed = 1971;
/// Roundings of the answer, and units in the last place of each number of the question.
constexpr double units = 8;

std::string both(testing::Apart const& a) {
  return book::number(a.momentum, 2) + " / " + book::number(a.attitude, 2);
}

/// 1e8 steps of one length: plain, compensated, and compensated with the place set back.
void drift(book::Program& program) {
  struct Case {
    char const* name;
    Three<double> moments;
    Vector<double, 3> momentum;
    double h;
    long steps;
  };
  std::vector<book::Program::Row> rows;
  double casimir = 0, energy = 0, spatial = 0, alone_casimir = 0, alone_spatial = 0;
  for (Case const& c : {Case{"asymmetric, h = 0.1", {0.6, 0.8, 1}, {1.8, 0.4, -0.9}, 0.1, 100'000'000},
                        {"asymmetric, h = 0.0731", {0.6, 0.8, 1}, {1.8, 0.4, -0.9}, 0.0731, 100'000'000},
                        {"asymmetric, h = 1", {0.6, 0.8, 1}, {1.8, 0.4, -0.9}, 1, 100'000'000},
                        {"round axis 3, h = 0.1", {0.6, 0.8, 1}, {0.3, -0.4, 0.9}, 0.1, 100'000'000},
                        {"planar, h = 0.1", {0.6, 0.8, 1.4}, {0.7, 0.4, -0.6}, 0.1, 100'000'000}}) {
    FreeBody const body(inertia_from_moments(c.moments[0], c.moments[1], c.moments[2]),
                        {SO<3>{}, c.momentum});
    auto const add = [&](char const* method, ConservationErrors const& k, double seconds) {
      rows.push_back({c.name, method, book::number(k.casimir, 2), book::number(k.energy, 2),
                      book::number(k.spatial, 2),
                      book::number(1e9 * seconds / static_cast<double>(c.steps), 2)});
      program.say(c.name, ", ", method, ": Casimir ", k.casimir, ", energy ", k.energy,
                  ", momentum in space ", k.spatial);
    };
    auto const timed = [&](auto const& run) {
      auto const start = std::chrono::steady_clock::now();
      run();
      return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    auto const parameters = body.step_parameters(c.h);
    CompensatedState<double> plain{body.start(), {{}, {}}}, summed = plain;
    HalfTurn<double> const turn(parameters);
    double seconds = timed([&] {
      for (long k = 0; k < c.steps; ++k) turn.step(plain.state);
    });
    add("plain", conservation_errors(c.moments, plain, body.start()), seconds);
    CompensatedHalfTurn<double> const compensated(parameters);
    seconds = timed([&] {
      for (long k = 0; k < c.steps; ++k) compensated.step(summed);
    });
    ConservationErrors const alone = conservation_errors(c.moments, summed, body.start());
    add("compensated", alone, seconds);
    FreeSteps motion(body, c.h);
    seconds = timed([&] { motion.advance(c.steps); });
    ConservationErrors const back = conservation_errors(motion, c.moments);
    add("compensated, set back", back, seconds);
    casimir = std::max(casimir, back.casimir), energy = std::max(energy, back.energy),
    spatial = std::max(spatial, back.spatial);
    alone_casimir = std::max({alone_casimir, alone.casimir, alone.energy}),
    alone_spatial = std::max(alone_spatial, alone.spatial);
  }
  program.table("drift", {"motion", "steps are", "Casimir", "energy", "momentum in space", "ns a step"}, rows,
                "Relative changes after 1e8 steps, measured in 34 digits.");
  program.figure("casimir", casimir, "largest change of the Casimir over 1e8 steps");
  program.figure("energy", energy, "of the energy");
  program.figure("spatial", spatial, "of the momentum in space");
  program.figure("casimir_alone", alone_casimir, "of Casimir and energy without the setting back");
  program.figure("spatial_alone", alone_spatial, "of the momentum in space without it");
  program.claim(casimir <= 2e-14 && energy <= 2e-14, "1e8 steps conserve Casimir and energy within 2e-14");
  program.claim(spatial <= 5e-13, "1e8 steps conserve the momentum in space within 5e-13");
  program.headline("1e8 steps: Casimir conserved to " + book::number(casimir, 2) + ", momentum in space to " +
                       book::number(spatial, 2),
                   std::max(casimir, spatial));
}

/// at(t) of nasty bodies, judged by power series.
void against_series(book::Program& program) {
  testing::HardProblems problems(seed);
  double worst = 0, sharp = 0, angle = 0;
  int skipped = 0;
  for (int count = 0; count < 10000;) {
    FreeProblem const p = problems.next(100);
    testing::FreeBodyWitness<long double> witness(p.moments, 20);
    auto const answer = witness.after(testing::start_of<long double>(p), p.time);
    if (witness.expansions() > 3000) {
      ++skipped;
      continue;
    }
    ++count, angle = std::max(angle, std::abs(p.time) * p.rate());
    worst = std::max(worst, testing::units_off(p, answer, units));
  }
  program.figure("series_units", worst,
                 "10000 nasty bodies, series in 19 digits, and in 45 where those do not suffice: largest "
                 "error over (eps + what one unit in the last place of each number of the question does)");
  program.say("angles up to ", angle, "; ", skipped, " left out whose fastest component starts near zero");
  program.claim(
      worst <= units,
      "at(t) is right to eight units in the last place of the question, for ten thousand nasty bodies");
  // The same in 50 digits, of the exact flow in 50 digits: this makes that flow a witness for what follows.
  double const last = to_double(epsilon<dec50>());
  for (int count = 0; count < 150;) {
    FreeProblem const p = problems.next(10);
    testing::FreeBodyWitness<long double> probe(p.moments, 20);
    auto const rough = probe.after(testing::start_of<long double>(p), p.time);
    if (probe.expansions() > 120) continue;
    ++count;
    auto const truth = testing::witness_of<dec50>(p, 53);
    sharp = std::max(sharp, testing::apart(truth, testing::exact_path<dec50>(p), p.magnitude()).larger() /
                                (last * (1 + testing::condition(p, rough) / eps)));
  }
  program.figure("sharp_units", sharp,
                 "150 nasty bodies, exact flow in 50 digits against series in 50 digits, in the same units");
  program.claim(sharp <= 2 * units, "the exact flow in 50 digits is right to its last places");
}

/// at(t) and steps over long times, judged by the exact flow in 50 digits.
void against_fifty_digits(book::Program& program) {
  auto const truth_of = [](FreeProblem const& p) { return testing::exact_path<dec50>(p); };
  testing::HardProblems problems(seed + 1);
  std::vector<double> once, many, leaps;
  for (int count = 0; count < 10000; ++count) {
    FreeProblem p = problems.next(1e6);
    // Every fourth also by steps: a power of two of them, so that their sum is the time.
    bool const steps = count % 4 == 0;
    auto const truth = truth_of(p);
    double const open = testing::condition(p, truth, truth_of);
    // Where the question leaves everything open there is nothing to judge.
    if (open > 1e-2) continue;
    once.push_back(testing::apart(truth, testing::path_of(p.body().at(p.time)), p.magnitude()).larger() /
                   (eps + open));
    if (!steps) continue;
    long const number = 1 << 12;
    double const h = p.time / static_cast<double>(number);
    FreeSteps motion(p.body(), h);
    motion.advance(number);
    // A single step over several periods would round where it lands, and next to the separatrix that would
    // grow until it has passed: these are evaluated from the start.
    (std::abs(h) * p.body().pace() <= 4 || !p.body().near_separatrix() ? many : leaps)
        .push_back(testing::apart(truth, testing::path_of(motion.state()), p.magnitude()).larger() /
                   (eps + open));
  }
  auto const add = [&](char const* name, std::vector<double>& x) {
    std::sort(x.begin(), x.end());
    std::size_t const n = x.size();
    return book::Program::Row{name, std::to_string(n), book::number(x[n / 2], 2),
                              book::number(x[n - 1 - n / 100], 2), book::number(x[n - 1], 2)};
  };
  std::vector<book::Program::Row> const rows = {add("at(t)", once), add("4096 steps", many),
                                                add("4096 long steps past the separatrix", leaps)};
  program.table("fifty", {"", "bodies", "half of them within", "99 of 100", "all"}, rows,
                "Errors over (eps + what one unit in the last place of each number of the question does), "
                "angles up to 1e6; truth: the exact flow in 50 digits.");
  program.figure("once_units", once.back(), "at(t), largest");
  program.figure("steps_units", many.back(), "4096 steps, largest");
  program.claim(
      once.back() <= units,
      "at(t) is right to eight units in the last place of the question, for angles up to a million");
  program.claim(many.back() <= units && leaps.back() <= units, "so are 4096 steps of any length");
}

/// Bodies that break codes: errors of momentum and attitude, beside other methods with the same steps.
void hard_bodies(book::Program& program) {
  struct Case {
    std::string name;
    std::array<double, 3> moments, momentum;
    double time;
    long steps;
    bool judged;
  };
  std::array<double, 3> const A = {0.6, 0.8, 1};
  std::vector<book::Program::Row> rows;
  double worst = 0;
  for (Case const& c : {Case{"asymmetric", A, {1.8, 0.4, -0.9}, 1000, 10000, true},
                        {"I2 - I1 = 1e-9", {1, 1 + 1e-9, 1.5}, {0.3, 0.7, 0.6}, 1000, 10000, true},
                        {"I2 - I1 = 1e-12", {1, 1 + 1e-12, 1.5}, {0.3, 0.7, 0.6}, 1000, 10000, true},
                        {"rod, I3 - I2 = 1e-12", {0.5, 1, 1 + 1e-12}, {0.3, 0.7, 0.4}, 1000, 10000, true},
                        {"planar", {0.6, 0.8, 1.4}, {0.4, 0.3, 0.4}, 1000, 10000, true},
                        {"ratio 1e6", {1e-6, 1, 1 + 1e-6}, {7e-7, 0.3, 0.4}, 1000, 10000, true},
                        {"the same at 1e3 rad/s", {1e-6, 1, 1 + 1e-6}, {1e-3, 0.3, 0.4}, 1, 1000, true},
                        {"sphere up to 1e-10", {1, 1 + 1e-10, 1 + 2e-10}, {0.3, 0.7, 0.4}, 1000, 10000, true},
                        {"M = (1e-3, 1, 1e-3)", A, {1e-3, 1, 1e-3}, 1000, 10000, false},
                        {"M = (1e-8, 1, 1e-8)", A, {1e-8, 1, 1e-8}, 100, 1000, false},
                        {"k'^2 about 1e-16", {0.5, 2.0 / 3, 1}, {1, 1, 1}, 100, 1000, false}}) {
    FreeProblem const p{c.moments, c.momentum, c.time};
    double const L = p.magnitude(), h = c.time / static_cast<double>(c.steps);
    auto const truth = testing::witness_of<dec50>(p, c.judged ? 26 : 46);
    auto const body = p.body();
    auto const after = [&](auto& motion) {
      motion.advance(c.steps);
      return testing::apart(truth, testing::path_of(motion.state()), L);
    };
    FreeSteps ours(body, h);
    auto const stepped = after(ours), once = testing::apart(truth, testing::path_of(body.at(c.time)), L);
    FrameState<double> state = body.start();
    HalfTurn<double> const plain(body.step_parameters(h));
    for (long k = 0; k < c.steps; ++k) plain.step(state);
    auto const scheme = [&](int order) -> std::string {
      try {
        FreeSteps motion(body, h, body.moser_veselov_parameters(h, order));
        return both(after(motion));
      } catch (StepTooLong const&) {
        return "none";
      }
    };
    double const open = testing::condition(
        p, testing::exact_path<dec50>(p), [](FreeProblem const& q) { return testing::exact_path<dec50>(q); });
    rows.push_back({c.name, book::number(c.time), book::number(open, 2), both(stepped), both(once),
                    both(testing::apart(truth, testing::path_of(body.state(state)), L)), scheme(2),
                    scheme(10)});
    program.say(c.name, ": steps ", both(stepped), ", at(t) ", both(once));
    if (c.judged) worst = std::max({worst, stepped.larger(), once.larger()});
    program.claim(once.larger() <= units * (eps + open), c.name + ": at(t) is as good as the question");
  }
  program.table("hard",
                {"body", "t", "open", "exact steps", "at(t)", "plain steps", "Moser-Veselov", "its order 10"},
                rows,
                "Errors of momentum / attitude, steps of time/10000 or time/1000; `open` is what one unit "
                "in the last place of each number of the question does.");
  program.figure("hard", worst, "largest error of the bodies that are not next to the separatrix");
  program.claim(worst <= 1e-12,
                "bodies of ratio 1e6, nearly symmetric, nearly spherical and flat ones: "
                "1e-12 in momentum and attitude");
}
}  // namespace

int main(int argc, char** argv) {
  book::Program program(argc, argv,
                        "a free body over 1e8 steps, and ten thousand nasty bodies against 50 digits");
  program.say("random bodies from seed ", seed);
  hard_bodies(program);
  against_series(program);
  against_fifty_digits(program);
  drift(program);
  return program.finish();
}
