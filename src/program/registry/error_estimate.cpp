#include "program/registry/error_estimate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace actio::scene {
namespace {

// In steps between two rows: the closed form takes as long as some fifty, a look ahead as two or three, which
// is no time at the beginning.
constexpr long at_first = 2048, between_at_first = 8, between_exact = 128, between_looks = 64;

/// What rounding adds over so many steps.
double rounding(long steps) {
  return std::numeric_limits<double>::epsilon() * std::sqrt(static_cast<double>(std::max(1L, steps)));
}

}  // namespace

bool ErrorEstimate::follow(Follower follower, long& made, long steps) const {
  if (!follower.motion || follower.ratio == 0) return true;
  long const wanted = steps / follower.ratio - made;
  if (wanted <= 0) return true;
  try {
    follower.motion->advance(wanted);
  } catch (Error const&) {
    return false;
  }
  made += wanted;
  return true;
}
void ErrorEstimate::follow(long steps) {
  lost_ = lost_ || !follow(companion(), made_, steps) || !follow(control(), control_made_, steps);
}

/// How long after its last step a time is; zero where it is that of the step.
double ErrorEstimate::Follower::time_beyond(double time, double step) const {
  double const beyond = time - static_cast<double>(made * ratio) * step;
  return std::abs(beyond) <= 1e-6 * step ? 0 : beyond;
}
/// By how many errors of the run the two are apart.
/// @param beyond  its last step, in steps of the run
double ErrorEstimate::Follower::factor(double beyond, int order) const {
  double const m = static_cast<double>(made), r = static_cast<double>(ratio), p1 = order + 1;
  return (std::pow(r, p1) * m + std::pow(beyond, p1)) / (r * m + beyond) - 1;
}

void ErrorEstimate::see(long row, double time, long steps, bool last) {
  if (!companion_.motion || lost_ || time == 0) return;
  try {
    bool const exact = companion_.steps == 0;
    long const between = steps <= at_first ? between_at_first : exact ? between_exact : between_looks;
    bool const due = last || row % (1 + between * row / std::max(1L, steps)) == 0;
    if (exact) {
      if (!due) return;
      companion_.motion->go_to(time);
      return compare(1, 1, steps, time);
    }
    double factors[2] = {0, 0};
    for (int k = 0; k < (companion_.control ? 2 : 1); ++k) {
      Follower const one = k == 0 ? companion() : control();
      double const beyond = one.time_beyond(time, run_.step);
      // Where they have no step, a shorter one goes to the row.
      if (beyond != 0 && !due) return;
      factors[k] = one.factor(beyond / run_.step, companion_.order);
      if (!(factors[k] >= 1)) return;  // a single step tells nothing of its own error
      one.motion->look_ahead(beyond);
    }
    compare(factors[0], factors[1], steps, time);
  } catch (Error const&) {
    lost_ = true;
  }
}

void ErrorEstimate::compare(double factor, double control_factor, long steps, double time) {
  StateDistance const d = run_.motion->distance(*companion_.motion),
                      c = companion_.control ? run_.motion->distance(*companion_.control) : d;
  std::array<std::array<double, 3>, 3> const all{{{d.attitude, c.attitude, 1},
                                                  {d.momentum, c.momentum, d.modulus},
                                                  {d.vectors, c.vectors, d.vectors_modulus}}};
  for (auto const& [apart, control_apart, modulus] : all)
    if (!std::isfinite(apart) || !std::isfinite(control_apart) || !std::isfinite(modulus)) return;
  if (!companion_.control) control_factor = factor;
  for (std::size_t k = 0; k < all.size(); ++k) {
    auto const& [apart, control_apart, modulus] = all[k];
    Seen& seen = largest_[k];
    seen.modulus = std::max(seen.modulus, modulus);
    double const rounded = rounding(steps) * seen.modulus;
    seen.apart = std::max(seen.apart, apart);
    // Without a control nothing tells an error of the method from rounding.
    seen.control_apart = companion_.control ? std::max(seen.control_apart, control_apart) : HUGE_VAL;
    seen.error = std::max(seen.error, apart / factor + rounded);
    seen.whole = std::max(seen.whole, control_apart / control_factor + rounded);
    if (!companion_.control || seen.near(seen.control_apart))
      seen.compared = seen.error, seen.control = seen.whole;
  }
  for (Seen& seen : largest_)
    if (holds(seen)) seen.until = time, seen.then = seen.value();
  seen_ = true;
}

/// How far the companion may be for its distance to tell an error.
double ErrorEstimate::limit() const {
  return std::ranges::all_of(largest_, [](Seen const& seen) { return seen.linear(); }) ? 0.1 : 0.01;
}
/// Whether a number may be told. What is compared with the true motion needs no more.
bool ErrorEstimate::holds(Seen const& seen) const {
  return companion_.steps == 0 || (seen.near(seen.apart, limit()) && (seen.agree() || seen.as_rounding()));
}

ErrorEstimate::Entry ErrorEstimate::entry(std::string const& name, std::string const& unit,
                                          Seen const& seen) const {
  Entry out{name};
  out.unit = unit;
  if (!lost_ && holds(seen)) {
    out.error = seen.value();
    return out;
  }
  out.said = "no number";
  if (seen.until >= 0) {
    out.until = seen.until, out.then = seen.then;
    out.said += fmt::format(" after t = {:.6g}, when it was {:.1e}{}", seen.until, seen.then, unit);
  }
  if (lost_)
    out.said += ": the companion run, with longer steps, could not go on";
  else if (!seen.near(seen.apart, limit()))
    out.said += fmt::format(
        ": the companion run came to be {:.2g}{} away, and up to {} tells an "
        "error; shorter steps tell longer",
        seen.apart / seen.modulus, unit, limit());
  else
    out.said += fmt::format(
        ": runs with steps {} and {} times as long tell errors of {:.1e} and "
        "{:.1e}; shorter steps tell better",
        companion_.steps, companion_.control_steps, seen.compared / seen.modulus,
        seen.control / seen.modulus);
  return out;
}

std::vector<ErrorEstimate::Entry> ErrorEstimate::entries() const {
  std::vector<Entry> out;
  if (!estimates()) return out;
  if (companion_.attitude) out.push_back(entry(companion_.turn, companion_.unit, largest_[0]));
  out.push_back(entry(companion_.momentum, "", largest_[1]));
  if (companion_.vectors) out.push_back(entry("vectors", "", largest_[2]));
  for (auto const& name : companion_.without) {
    out.push_back({name});
    out.back().said = "none is estimated";
  }
  return out;
}

std::optional<ErrorEstimate::Entry> ErrorEstimate::worst() const {
  std::optional<Entry> out;
  for (auto const& one : entries()) {
    if (std::ranges::find(companion_.without, one.name) != companion_.without.end()) continue;
    if (!one.told()) return one;
    if (!out || one.error > out->error) out = one;
  }
  return out;
}

std::string ErrorEstimate::how() const {
  if (!run_.failure.empty()) return "not estimated: the run can take no step";
  if (!companion_.motion) return companion_.how;
  if (!seen_ && !lost_) return "not estimated: no row that the companion run meets has been reached";
  return companion_.how;
}

void ErrorEstimate::remember(CheckpointStream& stream) {
  stream(made_, control_made_, largest_, seen_, lost_);
  for (Motion* motion : {companion_.motion.get(), companion_.control.get()})
    if (motion) motion->remember(stream);
}

}  // namespace actio::scene
