// Scenes: what they cost beside the bare loop of steps, how soon they start, how fast rows reach the disk;
// and that what is not asked for costs nothing.
//
// For the counts the program starts itself under valgrind, as `instructions` does, with the words
// `--steps KIND N EVERY`. Everything is written to a folder of its own among the temporary files and removed
// at the end: a table of ten million rows takes half a gigabyte there.
#include <Eigen/Core>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>

#include "actio/fast_body/space/free_steps.hpp"
#include "benchmark.hpp"
#include "callgrind.hpp"
#include "program/run/run.hpp"
#include "timing.hpp"

using namespace actio;
using namespace actio::bodies;
using namespace benchmark;

// So that no compiler leaves out what is computed.
double volatile sink;

FreeBody body() {
  return FreeBody(inertia_from_moments(0.6, 0.8, 1), {SO<3>{}, Eigen::Vector3d(1.8, 0.4, -0.9)});
}

/// n eighths of a unit of time: a step takes one.
std::string eighths(long n) {
  return std::to_string(n / 8) + "." + std::to_string(1000 + n % 8 * 125).substr(1);
}

/// A scene of that body in steps of the scheme of Moser and Veselov, with a row every so many steps.
std::string scene_of(long steps, long every, std::string const& quantities,
                     std::string const& format = "csv") {
  return "[system]\nkind = \"rigid_body\"\ninertia = [0.6, 0.8, 1]\n[initial]\nangular_momentum = [1.8, 0.4, "
         "-0.9]\n[method]\nname = \"moser_veselov\"\norder = 2\nstep = 0.125\n[run]\nuntil = " +
         eighths(steps) + "\nevery = " + eighths(every) + "\n[output]\nquantities = [" + quantities +
         "]\nformats = [\"" + format + "\"]\n";
}

/// A folder among the temporary files, gone at the end.
class Folder {
 public:
  Folder() {
    if (!::mkdtemp(path_.data())) throw std::runtime_error("no folder among the temporary files");
  }
  ~Folder() { clear(), std::filesystem::remove(path_); }
  std::string const& path() const { return path_; }
  /// An empty folder in it.
  std::string empty() const {
    clear();
    std::filesystem::create_directory(path_ + "/run");
    return path_ + "/run";
  }
  std::string write(std::string const& text) const {
    std::ofstream(path_ + "/scene.toml") << text;
    return path_ + "/scene.toml";
  }
  void clear() const {
    for (auto const& entry : std::filesystem::directory_iterator(path_)) std::filesystem::remove_all(entry);
  }

 private:
  std::string path_ = (std::filesystem::temp_directory_path() / "actio_bench_XXXXXX").string();
};

void run(std::string const& text, std::string const& folder) {
  scene::Scene read = scene::Scene::read(scene::SceneFile::parse(text, "scene.toml"));
  auto const report = scene::run_scene(read, folder, false, {true});
  if (report.ending != scene::Ending::done) throw std::runtime_error(report.message);
}

double seconds_of(clockid_t clock) {
  timespec now;
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// ---- Beside the bare loop

/// Of the thread that steps, of the whole process, and by the clock on the wall.
constexpr std::array<clockid_t, 3> clocks{CLOCK_THREAD_CPUTIME_ID, CLOCK_PROCESS_CPUTIME_ID, CLOCK_MONOTONIC};
using Times = std::array<double, 3>;

template <class Work>
Times times_of(Work const& work) {
  Times times;
  for (std::size_t i = 0; i < 3; ++i) times[i] = -seconds_of(clocks[i]);
  work();
  for (std::size_t i = 0; i < 3; ++i) times[i] += seconds_of(clocks[i]);
  return times;
}

void overhead(Benchmark& program, Folder const& folder) {
  constexpr long every = 1000;
  long const steps = program.length(80000000L, 8000000L);
  int const rounds = program.length(11, 7);
  std::string const text = scene_of(steps, every, "\"body_momentum\"");
  std::array<std::vector<double>, 3> plain, complete, more;
  for (int round = -1; round < rounds; ++round) {
    Times const bare = times_of([&] {
      FreeSteps motion(body(), 0.125, body().moser_veselov_parameters(0.125, 2));
      motion.advance_momentum(steps);
      sink = motion.body_momentum().components[0];
    });
    std::string const empty = folder.empty();
    Times const whole = times_of([&] { run(text, empty); });
    if (round < 0) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      plain[i].push_back(bare[i]), complete[i].push_back(whole[i]);
      more[i].push_back(100 * (whole[i] / bare[i] - 1));
    }
  }
  auto const per_cent = [&](std::size_t clock) {
    return 100 * (ratio_of_best(complete[clock], plain[clock]) - 1);
  };
  double const percent = per_cent(0);
  program.figure("bare_ns", 1e9 * best_tenth(plain[0]) / static_cast<double>(steps),
                 "step of the bare loop, momentum alone, ns");
  program.figure("overhead", percent, book::number(percent, 2),
                 "what a scene adds, momentum alone and a row every 1000 steps, per cent of "
                 "the time of the thread that steps");
  program.figure("overhead_low", quantile(more[0], 0.1), book::number(quantile(more[0], 0.1), 2),
                 "the same round by round, a tenth of the rounds below");
  program.figure("overhead_high", quantile(more[0], 0.9), book::number(quantile(more[0], 0.9), 2),
                 "the same round by round, a tenth of the rounds above");
  program.figure("overhead_process", per_cent(1), book::number(per_cent(1), 2),
                 "the same with the thread that writes, per cent of processor time");
  program.figure("overhead_elapsed", per_cent(2), book::number(per_cent(2), 2),
                 "the same by the clock on the wall, per cent");
  program.claim_of_time(
      percent <= 2, "a scene adds at most 2 % to the bare loop; measured " + book::number(percent, 2) + " %");
  program.headline("a scene adds " + book::number(percent, 2) + " % to the bare loop of steps", percent);
}

// ---- The built command

struct Process {
  double seconds, megabytes;
};
/// `actio run` of a scene: elapsed time and peak memory.
Process command(Folder const& folder, std::string const& text) {
  folder.clear();
  std::string const scene = folder.write(text);
  double const began = seconds_of(CLOCK_MONOTONIC);
  pid_t const child = ::fork();
  if (child == 0) {
    ::execl(ACTIO_COMMAND, ACTIO_COMMAND, "run", scene.c_str(), "--quiet", static_cast<char*>(nullptr));
    ::_exit(127);
  }
  int status = 1;
  rusage usage{};
  ::wait4(child, &status, 0, &usage);
  double const seconds = seconds_of(CLOCK_MONOTONIC) - began;
  if (status != 0) throw std::runtime_error("actio run failed");
  return {seconds, static_cast<double>(usage.ru_maxrss) / 1024};
}

void start(Benchmark& program, Folder const& folder) {
  std::vector<double> seconds;
  for (int i = 0; i < program.length(20, 11); ++i)
    seconds.push_back(command(folder, scene_of(1, 1, "\"body_momentum\"")).seconds);
  double const ms = 1e3 * best_tenth(seconds);
  program.figure(
      "start_ms", ms,
      "a scene of one step, start of the command to its end, a tenth of the runs were faster, milliseconds");
  program.claim_of_time(ms <= 20, "a scene of one step takes at most 20 ms; measured " + book::number(ms));
}

void rows(Benchmark& program, Folder const& folder) {
  long const rows = program.length(10000000L, 1000000L);
  std::string const many = program.is_short() ? "a million" : "ten million";
  std::vector<book::Program::Row> lines;
  for (std::string const format : {"csv", "hdf5"}) {
    double const few = command(folder, scene_of(rows / 100, 1, "\"energy\", \"casimir\"", format)).megabytes;
    Process const process = command(folder, scene_of(rows, 1, "\"energy\", \"casimir\"", format));
    double const rate = static_cast<double>(rows) / process.seconds;
    double const megabytes =
        static_cast<double>(std::filesystem::file_size(
            folder.path() + (format == "csv" ? "/scene/series.csv" : "/scene/series.h5"))) /
        1e6;
    lines.push_back({format, book::number(rate / 1e6), book::number(megabytes),
                     book::number(process.megabytes), book::number(few)});
    program.figure(format + "_rows", rate / 1e6,
                   many + " rows of three columns, " + format + ", million rows a second");
    program.figure(format + "_memory", process.megabytes, "its peak memory, MB");
    program.claim_of_time(rate >= 1.5e6, format + ": at least 1.5 million rows a second; measured " +
                                             book::number(rate / 1e6) + " million");
    program.claim(process.megabytes <= few + 4,
                  format + ": " + many +
                      " rows take no more memory than a hundredth of them, but for 4 MB; measured " +
                      book::number(process.megabytes) + " against " + book::number(few) + " MB");
  }
  program.table(
      "rows",
      {"format", "million rows a second", "size, MB", "peak memory, MB", "for a hundredth of the rows, MB"},
      lines,
      std::string(program.is_short() ? "A" : "Ten") +
          " million rows of time, energy and Casimir, a row after each step; elapsed "
          "time of the command, start to end.");
}

// ---- What is not asked for

struct Kind {
  char const* key;
  char const* name;
  char const* quantities;  // none: the bare loop
  bool attitude;
};
Kind const kinds[] = {
    {"bare_momentum", "bare loop, momentum alone", nullptr, false},
    {"momentum", "scene, momentum alone", "\"body_momentum\"", false},
    {"bare_attitude", "bare loop, momentum and attitude", nullptr, true},
    {"attitude", "scene, attitude", "\"attitude\"", true},
    {"everything", "scene, all quantities",
     "\"attitude\", \"angular_velocity\", \"body_momentum\", \"spatial_momentum\", \"energy\", \"casimir\"",
     true}};

int count_steps(char const* key, long steps, long every) {
  for (Kind const& kind : kinds) {
    if (std::strcmp(kind.key, key)) continue;
    if (kind.quantities) {
      Folder const folder;
      run(scene_of(steps, every, kind.quantities), folder.empty());
    } else {
      FreeSteps motion(body(), 0.125, body().moser_veselov_parameters(0.125, 2));
      kind.attitude ? motion.advance(steps) : motion.advance_momentum(steps);
      sink = motion.body_momentum().components[0];
    }
    return 0;
  }
  return 2;
}

/// Instructions of a whole run, all threads; negative where valgrind did not give a count.
double instructions(std::string const& self, char const* kind, long steps, long every) {
  return benchmark::instructions_of("'" + self + "' --steps " + kind + " " + std::to_string(steps) + " " +
                                    std::to_string(every));
}

/// Instructions of a step, in the difference of two runs with rows far apart, and of a row, in the difference
/// of two with rows nearer and farther.
struct Count {
  double step, row;
};
Count count_of(Benchmark& program, std::string const& self, Kind const& kind) {
  long const few = program.length(200000L, 100000L), many = 2 * few, far = 100000, near = 1000;
  double const a = instructions(self, kind.key, few, far), b = instructions(self, kind.key, many, far);
  program.claim(a > 0 && b > a, std::string("valgrind counts the steps of: ") + kind.name);
  double const row = kind.quantities ? (instructions(self, kind.key, many, near) - b) /
                                           static_cast<double>(many / near - many / far)
                                     : 0;
  return {(b - a) / static_cast<double>(many - few), row};
}

void count(Benchmark& program) {
  if (!instructions_can_be_counted()) {
    program.say("valgrind is not there, so nothing was counted. On Debian: apt-get install valgrind");
    return;
  }
  std::string const self = std::filesystem::canonical("/proc/self/exe").string();
  std::array<Count, std::size(kinds)> counts;
  std::vector<book::Program::Row> lines;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    counts[i] = count_of(program, self, kinds[i]);
    lines.push_back({kinds[i].name, book::number(counts[i].step, 4),
                     kinds[i].quantities ? book::number(counts[i].row, 4) : ""});
    program.figure(std::string("count_") + kinds[i].key, counts[i].step, book::number(counts[i].step, 4),
                   std::string(kinds[i].name) + ", instructions a step");
  }
  program.table("instructions", {"what", "a step", "a row"}, lines,
                "Instructions counted by valgrind: of a step, and of a row, with its evaluation, its "
                "formatting in 17 digits and its way to the file. Set-up cancels in differences of runs.");
  auto const as_many = [&](std::size_t scene, std::size_t other) {
    double const percent = 100 * (counts[scene].step / counts[other].step - 1);
    program.claim(std::abs(percent) <= 0.2,
                  std::string(kinds[scene].name) + ": between rows as many instructions a step as: " +
                      kinds[other].name + ", to 0.2 %; measured " + book::number(percent, 2) + " %");
  };
  as_many(1, 0);
  as_many(3, 2);
  as_many(4, 3);
  program.claim(counts[1].step < counts[3].step,
                "a scene that asks for no attitude takes fewer instructions a step than one that does");
  program.claim(counts[3].row < counts[4].row,
                "a scene that asks for the attitude alone takes fewer instructions a row "
                "than one that asks for everything");
}

int main(int argc, char** argv) {
  if (argc == 5 && !std::strcmp(argv[1], "--steps"))
    return count_steps(argv[2], std::atol(argv[3]), std::atol(argv[4]));
  Benchmark program(argc, argv,
                    "scenes: what they add to the bare loop, how soon they start, how fast rows are written");
  Folder const folder;
  start(program, folder);
  count(program);
  rows(program, folder);
  overhead(program, folder);
  return program.finish();
}
