#include "app/estimate.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdint>

namespace actio::app {

using namespace scene;

namespace {

using Clock = std::chrono::steady_clock;

// Of the snapshots of a run, as they are written.
constexpr double seconds_per_byte = 1.5e-8;

double since(Clock::time_point began) { return std::chrono::duration<double>(Clock::now() - began).count(); }

// When the program began, so that what it takes to read a scene is known.
Clock::time_point const program_began = Clock::now();

/// The first steps of a scene and some of its rows.
class Sample {
 public:
  explicit Sample(Scene& scene) : scene_(scene), values_(scene.simulation.quantities.row_size()) {}

  /// Seconds of so many steps, made in such pieces as the run makes. What a run does once at its start, and
  /// then rarely, may take as long as hundreds of steps: the first piece is counted once, and others are made
  /// until they have taken several times as long.
  double steps(long all) {
    Motion& motion = *scene_.simulation.motion;
    Companion& companion = scene_.simulation.companion;
    double first = 0, rest = 0;
    long made = 0, of_first = 0, pieces = 0;
    for (long piece = 1; made < all && !(pieces > 4 && first + rest > enough(first)); ++pieces) {
      piece = std::min(piece, all - made);
      auto const began = Clock::now();
      motion.advance(piece);
      long const before = made;
      made += piece;
      if (companion.motion && companion.steps > 0)
        companion.motion->advance(made / companion.steps - before / companion.steps);
      (before == 0 ? first : rest) += since(began);
      if (before == 0) of_first = piece;
      piece = std::min(2 * piece, scene_.simulation.steps_at_once);
    }
    left_ = all - made;
    step_ = made > of_first ? rest / static_cast<double>(made - of_first) : first;
    return first + rest + static_cast<double>(left_) * step_;
  }
  /// Seconds of a row, without the steps to it but for a shorter one where it is between two. Of an exact
  /// method the rows are spread over the whole time.
  double row() {
    long const rows = scene_.schedule.rows();
    Motion& motion = *scene_.simulation.motion;
    double const beside = scene_.simulation.exact ? 0 : share_of_rows_between_steps();
    auto const began = Clock::now();
    double place = 0, seconds = 0, ahead = 0;
    long made = 0;
    do {
      place = std::fmod(place + 0.6180339887498949, 1);
      if (!scene_.simulation.exact && left_ > 0) motion.advance(1), --left_;
      auto const before = Clock::now();
      if (scene_.simulation.exact)
        motion.go_to(scene_.schedule.time(static_cast<long>(place * static_cast<double>(rows))));
      if (beside > 0) motion.look_ahead(0.5 * scene_.simulation.step), ahead += since(before);
      auto const there = Clock::now();
      scene_.simulation.quantities.evaluate(values_);
      for (double const x : values_) characters_ += written(x);
      seconds += since(scene_.simulation.exact ? before : there);
      ++made;
    } while (made < rows && since(began) < budget);
    if (beside > 0) motion.look_ahead(0);
    rows_ = static_cast<double>(made);
    return (seconds + beside * ahead) / rows_;
  }
  /// Characters of a row in comma-separated values, the time among them.
  double characters() const {
    return characters_ / rows_ +
           static_cast<double>(written(scene_.schedule.time(scene_.schedule.rows() / 2)));
  }

 private:
  static constexpr double budget = 0.08, most = 2;  // seconds

  static double enough(double first) { return std::min(most, std::max(budget, 8 * first)); }
  double share_of_rows_between_steps() const {
    StepsToRows const steps(scene_.schedule, scene_.simulation.step, scene_.file.section("method"));
    long const rows = scene_.schedule.rows(), some = std::min(rows, 1000L);
    long beside = 0;
    for (long k = 0; k < some; ++k) beside += steps.beyond(rows - 1 - k) > 0;
    return static_cast<double>(beside) / static_cast<double>(some);
  }
  static std::size_t written(double x) {
    char text[32];
    return static_cast<std::size_t>(
               std::to_chars(text, text + sizeof text, x, std::chars_format::general, 17).ptr - text) +
           1;
  }

  Scene& scene_;
  std::vector<double> values_;
  double step_ = 0;  // seconds
  long left_ = 0;    // steps that may still be made
  double rows_ = 1;
  std::size_t characters_ = 0;
};

}  // namespace

Estimate estimate(Scene& scene) {
  Estimate out;
  double const reading = since(program_began), rows = static_cast<double>(scene.schedule.rows()),
               columns = 1 + static_cast<double>(scene.simulation.quantities.row_size());
  // Numbers in whole chunks, and what the file tells of itself.
  double const chunk = static_cast<double>(
      std::min(std::uint64_t{1024}, std::bit_ceil(static_cast<std::uint64_t>(scene.schedule.rows()))));
  out.hdf5 = 8 * columns * std::ceil(rows / chunk) * chunk + 10000;
  out.csv = 21 * columns * rows;
  if (scene.snapshots && scene.simulation.snapshots)
    out.snapshots = static_cast<double>(scene.snapshots->rows()) * scene.simulation.snapshots->bytes_of_one();
  try {
    Sample sample(scene);
    long const steps = scene.simulation.exact
                           ? 0
                           : StepsToRows(scene.schedule, scene.simulation.step,
                                         scene.file.section("method"))(scene.schedule.rows() - 1);
    out.seconds = reading + (steps > 0 ? sample.steps(steps) : 0) + out.snapshots * seconds_per_byte;
    out.seconds += rows * sample.row();
    out.csv = sample.characters() * rows;
  } catch (Error const&) {  // the run will tell why
  }
  return out;
}

}  // namespace actio::app
