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
  double const longest = fastest > 0 ? turn / fastest : HUGE_VAL, step = schedule.default_step(longest);
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
