#include "program/document/schedule.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace actio::scene {
namespace {

constexpr double most_whole = 9007199254740992;  // 2^53: whole numbers beyond it are not all doubles
// of the contract: how far t/h may be from a whole number, relative to it where it is large
constexpr double near = 1e-9;

bool is_multiple(double ratio) { return std::abs(ratio - std::round(ratio)) <= near * std::max(1.0, ratio); }

}  // namespace

Schedule::Schedule(SceneTable run) {
  between_steps_ = run_keys.between_steps.find(run).value_or(false);
  if (run_keys.at.given(run)) {
    if (run_keys.every.given(run))
      run.fail("at",
               "at and every exclude each other: rows at the times listed, or at the multiples of every");
    auto const until = run_keys.until.find(run);
    until_ = until.value_or(0);
    read_times(run, run_keys.at, until.has_value());
    if (!(until_ > 0))
      run_keys.at.fail(run, "where 0 is the only time, [run] needs 'until', for example until = 1");
    if (!until) run_keys.until.write(run, until_);
    return;
  }
  until_ = run_keys.until.read(run);
  if (run_keys.every.given(run))
    read_interval(run, run_keys.every);
  else
    at_ = {0, until_}, rows_ = 2;
}

Schedule::Schedule(SceneTable const& output, Schedule const& rows)
    : until_(rows.until_), between_steps_(rows.between_steps_) {
  auto const& keys = snapshot_times_keys;
  bool const listed = keys.at.given(output), regular = keys.every.given(output);
  if (listed && regular)
    output.fail("snapshot_at",
                "snapshot_at and snapshot_every exclude each other: snapshots at the times listed, or at "
                "the multiples of snapshot_every");
  if (listed)
    read_times(output, keys.at, true);
  else if (regular)
    read_interval(output, keys.every);
  else
    at_ = {0, until_}, rows_ = 2;
}

void Schedule::read_times(SceneTable const& table, Key<std::vector<double>> const& key, bool bounded) {
  at_ = key.read(table);
  if (at_.empty()) key.fail(table, "at least one time is expected");
  if (!bounded) until_ = at_.back();
  for (std::size_t i = 0; i < at_.size(); ++i) {
    if (at_[i] < 0 || (bounded && at_[i] > until_))
      key.fail_at(table, i,
                  fmt::format("times from 0 {} are expected, found {}",
                              bounded ? fmt::format("to until = {}", until_) : "on", at_[i]));
    if (i > 0 && !(at_[i] > at_[i - 1]))
      key.fail_at(
          table, i,
          fmt::format("each time is later than the one before; found {} after {}", at_[i], at_[i - 1]));
  }
  rows_ = static_cast<long>(at_.size());
}

void Schedule::read_interval(SceneTable const& table, Key<double> const& key) {
  every_ = key.read(table);
  double const ratio = until_ / every_;
  if (!(ratio < most_whole))
    key.fail(table, fmt::format("at most 2^53 rows are possible; until/{} is {}", key.name(), ratio));
  // A quarter: the last multiple of a short interval is not mistaken for another one.
  last_beside_ = std::round(ratio) < 1 ||
                 !(std::abs(ratio - std::round(ratio)) <= std::min(0.25, near * std::max(1.0, ratio)));
  rows_ = static_cast<long>(last_beside_ ? std::floor(ratio) + 2 : std::round(ratio) + 1);
}

double Schedule::time(long row) const {
  if (every_ == 0) return at_[static_cast<std::size_t>(row)];
  return last_beside_ && row == rows_ - 1 ? until_ : static_cast<double>(row) * every_;
}

std::vector<double> Schedule::landmarks() const {
  std::vector<double> out = at_;
  if (every_ != 0 && (every_ < until_ || !last_beside_)) out.push_back(every_);
  if (every_ != 0 && last_beside_) out.push_back(until_);
  out.insert(out.end(), besides_.begin(), besides_.end());
  return out;
}

void Schedule::meet(Schedule const& other) { besides_ = other.landmarks(); }

double Schedule::common_divisor() const {
  double divisor = 0;
  for (double const t : landmarks()) {
    // Euclid, with remainders below rounding taken for zero.
    double a = std::max(divisor, t), b = std::min(divisor, t);
    double const nothing = near * a;
    while (b > nothing && b > 0) {
      double rest = a - b * std::floor(a / b);
      if (rest > b - nothing) rest = 0;
      a = b, b = rest;
    }
    divisor = a;
  }
  auto const all = landmarks();
  double const longest = *std::max_element(all.begin(), all.end());
  if (!(divisor * most_whole > longest && divisor > 1e-7 * longest)) return 0;
  return longest / std::round(longest / divisor);  // the rounding of the remainders is gone
}

bool Schedule::met_by(double step) const {
  for (double const t : landmarks())
    if (!is_multiple(t / step) || (t > 0 && std::round(t / step) < 1)) return false;
  return true;
}

double Schedule::step_up_to(double longest) const {
  double const divisor = common_divisor(), step = divisor / std::ceil(divisor / longest);
  return divisor > 0 && met_by(step) ? step : 0;
}

double Schedule::step_from(double shortest) const {
  double const divisor = common_divisor(), parts = std::floor(divisor / shortest);
  return parts >= 1 && met_by(divisor / parts) ? divisor / parts : 0;
}

namespace {

/// Whole steps in a time: the least number of which none is longer.
double parts(double time, double longest) { return std::max(1.0, std::ceil(time / longest)); }

/// How many rows and snapshots such steps do not meet; of snapshots as many as there may be.
double times_beside(Schedule const& schedule, double step) {
  auto const missed = [step](double t) {
    return std::abs(t / step - std::round(t / step)) > 1e-9 * std::max(1.0, t / step);
  };
  double count = 0;
  // The first rows and the last one stand for all.
  long const rows = schedule.rows(), some = std::min(rows - 1, 4096L);
  for (long row = 0; row < some; ++row) count += missed(schedule.time(row));
  if (some > 0) count *= static_cast<double>(rows - 1) / static_cast<double>(some);
  count += missed(schedule.time(rows - 1));
  if (schedule.has_others())
    for (double const t : schedule.landmarks())
      if (t > 0 && missed(t)) count += schedule.until() / t;
  return count;
}

}  // namespace

double Schedule::default_step(double longest) const {
  double const divisor = common_divisor(), meets = divisor > 0 ? divisor / parts(divisor, longest) : 0;
  double const between = rows_ > 2 ? time(2) - time(1) : until_;
  bool const regular = rows_ > 2 && time(0) == 0 && std::abs(between - time(1)) <= 1e-9 * between;
  double const whole = regular ? between : until_, free = whole / parts(whole, longest);
  return until_ > 4 * meets * (until_ / free + times_beside(*this, free)) ? free : meets;
}

namespace {

/// `; the nearest step that would do is 0.25`, and where that is longer than asked also a shorter one, for
/// the method may not take it.
std::string step_that_would_do(Schedule const& schedule, double step) {
  double const below = schedule.step_up_to(step), above = schedule.step_from(step);
  if (below == 0 && above == 0) return "; the times of the rows have no divisor in common";
  if (above == 0 || (below > 0 && step - below <= above - step))
    return fmt::format("; the nearest step that would do is {}", below);
  return fmt::format("; the nearest step that would do is {}", above) +
         (below > 0 ? fmt::format(", the nearest shorter one {}", below) : "");
}

}  // namespace

StepsToRows::StepsToRows(Schedule const& schedule, double step, SceneTable const& method)
    : schedule_(schedule), step_(step) {
  for (double const t : schedule.landmarks()) {
    double const ratio = t / step;
    if (!(ratio < most_whole))
      method.fail("step",
                  fmt::format("step: at most 2^53 steps are possible; {} / {} is {}", t, step, ratio));
    if (schedule.between_steps() || (is_multiple(ratio) && (t == 0 || std::round(ratio) >= 1))) continue;
    method.fail("step",
                fmt::format("step: {} are at multiples of the step, and t = {} is {:.12g} steps of {} "
                            "(which run.between_steps = true reaches by a shorter step){}",
                            schedule.has_others() ? "rows and snapshots" : "rows", t, ratio, step,
                            step_that_would_do(schedule, step)));
  }
}

long StepsToRows::operator()(long row) const {
  double const ratio = schedule_.time(row) / step_;
  return !schedule_.between_steps() || is_multiple(ratio) ? std::lround(ratio)
                                                          : static_cast<long>(std::floor(ratio));
}
double StepsToRows::beyond(long row) const {
  double const t = schedule_.time(row);
  if (!schedule_.between_steps() || is_multiple(t / step_)) return 0;
  return t - static_cast<double>((*this)(row)) * step_;
}

}  // namespace actio::scene
