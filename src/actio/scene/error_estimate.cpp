#include "actio/scene/error_estimate.hpp"

#include <algorithm>
#include <cmath>

namespace actio::scene {
namespace {

constexpr long exact_every = 16;  // rows: the closed form takes as long as some fifty steps

/// What rounding adds over so many steps.
double rounding(long steps) {
  return std::numeric_limits<double>::epsilon() * std::sqrt(static_cast<double>(std::max(1L, steps)));
}

}  // namespace

void ErrorEstimate::follow(long steps) {
  if (!companion_.motion || lost_ || companion_.steps == 0) return;
  long const wanted = steps / companion_.steps - made_;
  if (wanted <= 0) return;
  try {
    companion_.motion->advance(wanted);
    made_ += wanted;
  } catch (Error const&) {
    lost_ = true;
  }
}

void ErrorEstimate::see(long row, double time, long steps, bool last) {
  if (!companion_.motion || lost_ || time == 0) return;
  try {
    if (companion_.steps == 0) {
      if (!last && row % exact_every != 0) return;
      companion_.motion->go_to(time);
      return compare(1, steps);
    }
    double const beyond = time - static_cast<double>(made_ * companion_.steps) * run_.step;
    bool const meets = std::abs(beyond) <= 1e-6 * run_.step;
    if (!meets && !last) return;
    double const m = static_cast<double>(made_), k = meets ? 0 : beyond / run_.step,
                 ratio = static_cast<double>(companion_.steps);
    double const p1 = companion_.order + 1;
    double const factor = (std::pow(ratio, p1) * m + std::pow(k, p1)) / (ratio * m + k) - 1;
    if (!(factor >= 1)) return;  // a single step tells nothing of its own error
    companion_.motion->look_ahead(meets ? 0 : beyond);
    compare(factor, steps);
  } catch (Error const&) {
    lost_ = true;
  }
}

void ErrorEstimate::compare(double factor, long steps) {
  StateDistance const apart = run_.motion->distance(*companion_.motion);
  if (!std::isfinite(apart.attitude) || !std::isfinite(apart.momentum)) return;
  largest_.attitude = std::max(largest_.attitude, apart.attitude / factor + rounding(steps));
  largest_.modulus = std::max(largest_.modulus, apart.modulus);
  largest_.momentum =
      std::max(largest_.momentum, apart.momentum / factor + rounding(steps) * largest_.modulus);
  seen_ = true;
}

std::vector<ErrorEstimate::Entry> ErrorEstimate::entries() const {
  if (empty()) return {};
  double const momentum = largest_.modulus > 0 ? largest_.momentum / largest_.modulus : 0;
  if (!companion_.attitude) return {{companion_.state, momentum}};
  return {{"attitude", largest_.attitude}, {companion_.state, momentum}};
}

std::string ErrorEstimate::how() const {
  if (!run_.failure.empty()) return "not estimated: the run can take no step";
  if (!companion_.motion) return companion_.how;
  if (lost_) return "not estimated: the companion run, with longer steps, could not go on";
  if (!seen_) return "not estimated: no row that the companion run meets has been reached";
  return companion_.how;
}

void ErrorEstimate::remember(CheckpointStream& stream) {
  stream(made_, largest_, seen_, lost_);
  if (companion_.motion) companion_.motion->remember(stream);
}

}  // namespace actio::scene
