#include "program/systems/method_input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "program/registry/common_keys.hpp"
#include "program/systems/step_hint.hpp"

namespace actio::scene {
namespace {

bool is_number(std::string const& order) { return order_as_written(order) == order; }

/// `2, 4 or "exact"`, numbers first.
std::string alternatives(std::vector<std::string> orders) {
  std::stable_sort(orders.begin(), orders.end(), [](auto const& a, auto const& b) {
    return is_number(a) && (!is_number(b) || std::stoi(a) < std::stoi(b));
  });
  std::string out = order_as_written(orders.front());
  for (std::size_t i = 1; i < orders.size(); ++i)
    out += (i + 1 < orders.size() ? ", " : " or ") + order_as_written(orders[i]);
  return out;
}

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

/// The longest step that divides all times and is at most so long. Where that makes more than four times as
/// many steps as one would that divides the time between two rows, or the whole time, and goes to the other
/// rows by shorter steps, the latter.
double default_step(Schedule const& schedule, double longest) {
  double const until = schedule.until(), divisor = schedule.common_divisor(),
               meets = divisor > 0 ? divisor / parts(divisor, longest) : 0;
  double const between = schedule.rows() > 2 ? schedule.time(2) - schedule.time(1) : until;
  bool const regular =
      schedule.rows() > 2 && schedule.time(0) == 0 && std::abs(between - schedule.time(1)) <= 1e-9 * between;
  double const whole = regular ? between : until, free = whole / parts(whole, longest);
  return until > 4 * meets * (until / free + times_beside(schedule, free)) ? free : meets;
}

}  // namespace

MethodChoice read_method(SceneTable method, std::vector<Method> const& known) {
  MethodKeys const keys{{"method"}, known};
  std::string const name = keys.name.read(method);
  auto const& orders = std::ranges::find(known, name, &Method::name)->orders;

  if (!method.has("order")) {
    if (is_number(orders.front()))
      method.set("order", std::stol(orders.front()));
    else
      method.set("order", orders.front());
  }
  bool const word = method.is_text("order");
  std::string const order = word ? method.text("order")
                                 : std::to_string(method.integer("order", std::numeric_limits<long>::min(),
                                                                 std::numeric_limits<long>::max()));
  if (std::find(orders.begin(), orders.end(), order) == orders.end() || word == is_number(order))
    keys.order.fail(method, fmt::format("{} takes {}, found {}", name, alternatives(orders),
                                        word ? as_written(order) : order));
  return {name, order};
}

double read_step(SceneTable method, Schedule const& schedule, double fastest, double turn) {
  if (auto const given = step_keys.step.find(method)) return *given;
  double const longest = fastest > 0 ? turn / fastest : HUGE_VAL, step = default_step(schedule, longest);
  return step_keys.step.read_or(method, step > 0 && std::isfinite(step) ? step : longest);
}

void fail_for_long_step(SceneTable const& method, Schedule const& schedule, StepTooLong const& error,
                        std::string what) {
  what = what.empty()
             ? error.what()
             : fmt::format("{}; the longest that would do is {}", what, error.largest_step * (1 - 1e-9));
  what += step_that_meets(schedule, error.largest_step * (1 - 1e-9));
  throw NumericsError(method.place("step").text() + ": step: " + what);
}

std::string step_that_meets(Schedule const& schedule, double longest) {
  double const meets = schedule.step_up_to(longest);
  return meets > longest / 4 ? fmt::format("; the largest that meets the rows is {}", meets)
                             : "; run.between_steps = true has rows between steps";
}

}  // namespace actio::scene
