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

double since(Clock::time_point began) { return std::chrono::duration<double>(Clock::now() - began).count(); }

/// The first steps of a scene and some of its rows.
class Sample {
 public:
  explicit Sample(Scene& scene) : scene_(scene), values_(scene.simulation.quantities.row_size()) {}

  /// Seconds of a step.
  double step(long steps) {
    double seconds = 0;
    auto const began = Clock::now();
    for (long made = 0, at_once = 1; made < steps && since(began) < budget;) {
      at_once = std::min(at_once, steps - made);
      auto const before = Clock::now();
      scene_.simulation.motion->advance(at_once);
      seconds = since(before) / static_cast<double>(at_once);  // the last ones, when all is warm
      made += at_once, left_ = steps - made, at_once = std::min(2 * at_once, scene_.simulation.steps_at_once);
    }
    return seconds;
  }
  /// Seconds of a row and those of the step before it. Of an exact method the rows are spread over the whole
  /// time.
  double row() {
    long const rows = scene_.schedule.rows();
    auto const began = Clock::now();
    long made = 0;
    double place = 0;
    do {
      place = std::fmod(place + 0.6180339887498949, 1);
      if (scene_.simulation.exact)
        scene_.simulation.motion->go_to(
            scene_.schedule.time(static_cast<long>(place * static_cast<double>(rows))));
      else if (left_ > 0)
        scene_.simulation.motion->advance(1), --left_;
      scene_.simulation.quantities.evaluate(values_);
      for (double const x : values_) characters_ += written(x);
      ++made;
    } while (made < rows && since(began) < budget);
    rows_ = static_cast<double>(made);
    return since(began) / rows_;
  }
  /// Characters of a row in comma-separated values, the time among them.
  double characters() const {
    return characters_ / rows_ +
           static_cast<double>(written(scene_.schedule.time(scene_.schedule.rows() / 2)));
  }

 private:
  static constexpr double budget = 0.08;  // seconds

  static std::size_t written(double x) {
    char text[32];
    return static_cast<std::size_t>(
               std::to_chars(text, text + sizeof text, x, std::chars_format::general, 17).ptr - text) +
           1;
  }

  Scene& scene_;
  std::vector<double> values_;
  long left_ = 0;  // steps that may still be made
  double rows_ = 1;
  std::size_t characters_ = 0;
};

}  // namespace

Estimate estimate(Scene& scene) {
  Estimate out;
  double const rows = static_cast<double>(scene.schedule.rows()),
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
    double const step = steps > 0 ? sample.step(steps) : 0, row = sample.row();
    out.seconds = step * static_cast<double>(steps) + rows * std::max(0.0, row - step);
    out.csv = sample.characters() * rows;
  } catch (Error const&) {  // the run will tell why
  }
  return out;
}

}  // namespace actio::app
