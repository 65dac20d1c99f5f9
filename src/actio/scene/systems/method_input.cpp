#include "actio/scene/systems/method_input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace actio::scene {
namespace {

bool is_number(std::string const& order) {
  return order.find_first_not_of("0123456789") == std::string::npos;
}
std::string as_written(std::string const& order) { return is_number(order) ? order : "\"" + order + "\""; }

/// `2, 4 or "exact"`, numbers first.
std::string alternatives(std::vector<std::string> orders) {
  std::stable_sort(orders.begin(), orders.end(), [](auto const& a, auto const& b) {
    return is_number(a) && (!is_number(b) || std::stoi(a) < std::stoi(b));
  });
  std::string out = as_written(orders.front());
  for (std::size_t i = 1; i < orders.size(); ++i)
    out += (i + 1 < orders.size() ? ", " : " or ") + as_written(orders[i]);
  return out;
}

/// Whole steps in a time: the least number of which none is longer.
double parts(double time, double longest) { return std::max(1.0, std::ceil(time / longest)); }

}  // namespace

MethodChoice read_method(SceneTable method, std::vector<Method> const& known) {
  std::vector<std::string> names;
  for (auto const& m : known) names.push_back(m.name);
  if (!method.has("name")) method.set("name", names.front());
  std::string const name = method.choice("name", "method", names, "actio list methods");
  auto const& orders =
      std::find_if(known.begin(), known.end(), [&](Method const& m) { return m.name == name; })->orders;

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
    method.fail("order", fmt::format("order: {} takes {}, found {}", name, alternatives(orders),
                                     word ? "\"" + order + "\"" : order));
  return {name, order};
}

double read_step(SceneTable method, Schedule const& schedule, double fastest, double turn) {
  if (!method.has("step")) {
    double const divisor = schedule.common_divisor(), time = divisor > 0 ? divisor : schedule.until(),
                 longest = fastest > 0 ? turn / fastest : time;
    double const step = time / parts(time, longest);
    method.set("step", step > 0 && std::isfinite(step) ? step : longest);
  }
  return method.positive("step");
}

void fail_for_long_step(SceneTable const& method, Schedule const& schedule, StepTooLong const& error,
                        std::string what) {
  what = what.empty()
             ? error.what()
             : fmt::format("{}; the longest that would do is {}", what, error.largest_step * (1 - 1e-9));
  // Rounded down, so that what is told can be pasted.
  double const divisor = schedule.common_divisor(),
               step = divisor / parts(divisor, error.largest_step * (1 - 1e-9));
  if (divisor > 0 && step > 0) what += fmt::format("; the largest that meets the rows is {}", step);
  throw NumericsError(method.place("step").text() + ": step: " + what);
}

}  // namespace actio::scene
