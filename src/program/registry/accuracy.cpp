#include "program/registry/accuracy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace actio::scene {
namespace {

constexpr double safety = 3,  // an estimate of an error is within this factor of it
    farthest = 4,             // of the steps of the last pilot to those that are chosen
    fewest = 16,              // steps of a pilot: its control has steps eight times as long
    most = 1e10;              // steps of a pilot, which take hours

/// An order, and the longest step with which it has the accuracy.
struct Candidate {
  WrittenOrder order;
  double work;  // of a step
  Pilot pilot;
  double step;
};

/// Why an order does not do, in words.
struct Refusal : Error {
  using Error::Error;
};

class Chooser {
 public:
  /// @param first  the scene with the default step
  Chooser(System const& system, Request const& request, Simulation const& first, double accuracy,
          Stop const& stop)
      : system_(system),
        request_(request),
        accuracy_(accuracy),
        until_(request.schedule.until()),
        default_step_(first.step),
        stop_(stop) {}

  /// The cheapest of some orders, which increase.
  Candidate choose(std::vector<WrittenOrder> const& orders) const {
    std::optional<Candidate> best;
    std::string why;
    for (auto const& order : orders) try {
        Candidate const one =
            longest_step(order, best ? cost(*best) : HUGE_VAL, order.written == orders.back().written);
        if (best && cost(one) >= cost(*best)) break;
        best = one;
      } catch (Refusal const& refusal) {
        why = refusal.what();
      }
    if (best) try {
        return confirmed(*best);
      } catch (Refusal const& refusal) {
        why = refusal.what();
      }
    accuracy_keys.accuracy.fail(request_.file, why);
  }

 private:
  /// In units of the work of a step, of the run.
  double cost(Candidate const& one) const {
    return one.work * until_ / request_.schedule.default_step(one.step);
  }

  /// @param order  its power becomes that of the companions, where that is less: some forces have an order of
  ///               their own
  /// @param work   is told that of a step
  Pilot pilot_with(WrittenOrder& order, double step, double& work) const {
    SceneFile const file = request_.file.copy();
    SceneTable method = file.section("method");
    order.write(method), method.set("step", step);
    try {
      Simulation simulation = system_.prepare({file, request_.schedule, request_.quantities, true});
      work = simulation.work;
      if (simulation.companion.motion) order.power = std::min(order.power, simulation.companion.order);
      return pilot(std::move(simulation), request_.schedule, stop_);
    } catch (NumericsError const& error) {
      Pilot out;
      out.step = step, out.until = until_, out.untold = error.what();
      return out;
    }
  }

  /// By the longest steps whose error can be told.
  /// @param limit  more than this the run shall not cost
  /// @param last   whether there is no higher order, which would do with longer steps
  Candidate longest_step(WrittenOrder order, double limit, bool last) const {
    double work = 1, step = std::min(4 * default_step_, until_ / fewest);
    Pilot now = pilot_with(order, step, work);
    bool const at_once = now.whole();
    while (!now.whole()) {
      step /= 2;
      if (step < default_step_) refuse_where_it_grows_too_much(now, order);
      if (work * until_ / step > limit || until_ / step > most || (!last && 4 * step < default_step_))
        throw Refusal(untold(now, order));
      now = pilot_with(order, step, work);
    }
    auto const longer = [&](double step_then) {
      Pilot then = pilot_with(order, step_then, work);
      bool const told = then.whole();
      if (told) now = std::move(then);
      return told;
    };
    auto const wanted = [&] {
      return std::min(now.step_for(accuracy_ / safety, order.power), until_ / fewest);
    };
    while (at_once && wanted() >= 2 * now.step && longer(2 * now.step)) {
    }
    if (wanted() > 1.1 * now.step) longer(std::min(wanted(), 1.4 * now.step));
    return with_step({order, work, std::move(now), 0});
  }

  /// A pilot whose steps are near enough to those of a candidate; still nearer, down to these, as long as no
  /// error is told.
  Pilot confirming(Candidate& now) const {
    double step = std::min(farthest * now.step, now.pilot.step / 2);
    Pilot next = pilot_with(now.order, step, now.work);
    if (!next.whole()) refuse_where_it_grows_too_much(now.pilot, now.order);
    while (!next.whole() && step >= 2 * now.step) next = pilot_with(now.order, step /= 2, now.work);
    if (!next.whole()) throw Refusal(untold(next, now.order));
    return next;
  }

  /// The same by a pilot that confirms it.
  Candidate confirmed(Candidate now) const {
    for (bool sure = true; now.pilot.step > farthest * now.step || !sure;) {
      Pilot next = confirming(now);
      bool const as_expected =
          next.told.back().error <= 10 * now.pilot.error_with(next.step, now.order.power);
      if (!sure && !as_expected)
        throw Refusal(fmt::format(
            "with steps of {:.3g} the error is {}, and shorter ones of order {} do not lessen it, where {} "
            "is asked",
            next.step, in_words(next.told.back()), now.order.written, accuracy_));
      sure = as_expected, now.pilot = std::move(next);
      now = with_step(std::move(now));
    }
    return now;
  }

  Candidate with_step(Candidate one) const {
    one.step = std::min(one.pilot.step, one.pilot.step_for(accuracy_ / safety, one.order.power));
    if (one.step > 0) return one;
    double const of_method = std::max(one.pilot.told.back().error, accuracy_),
                 step = one.pilot.step * std::pow(accuracy_ / safety / of_method, 1.0 / one.order.power);
    throw Refusal(
        fmt::format("{} is asked, and rounding alone adds up to {:.1e} over the {:.3g} steps of order {}; "
                    "{:.0e} can be met",
                    accuracy_, one.pilot.rounding(step), until_ / step, one.order.written,
                    2 * safety * one.pilot.rounding(step)));
  }

  void refuse_where_it_grows_too_much(Pilot const& pilot, WrittenOrder const& order) const {
    double const met = pilot.met_until(accuracy_ / safety);
    if (met < until_)
      throw Refusal(fmt::format(
          "errors grow so much that no step of order {} meets {} until t = {}: with steps of {:.3g} the "
          "error is {} already; it would be met until about t = {:.3g}",
          order.written, accuracy_, until_, pilot.step, in_words(pilot.told.back()), met));
  }
  std::string untold(Pilot const& pilot, WrittenOrder const& order) const {
    return fmt::format("with steps of {:.3g} of order {} no error is told at t = {}: {}", pilot.step,
                       order.written, until_, pilot.untold);
  }
  static std::string in_words(Pilot::Point const& at) {
    return fmt::format("{:.1e}{} of the {} at t = {:.6g}", at.error, at.unit, at.of, at.time);
  }

  System const& system_;
  Request const& request_;
  double accuracy_, until_, default_step_;
  Stop const& stop_;
};

/// The orders to choose from: that of the scene, or all of its method, in increasing order.
std::vector<WrittenOrder> orders_of(System const& system, SceneTable const& method, bool given) {
  if (given) return {WrittenOrder::of(method)};
  std::vector<WrittenOrder> out;
  for (auto const& order : std::ranges::find(system.methods, method.text("name"), &Method::name)->orders)
    if (order != "exact") out.emplace_back(order);
  std::ranges::sort(out, {}, &WrittenOrder::power);
  return out;
}

/// Whether the scene is a copy, in which order and step were chosen.
bool is_chosen(SceneFile const& file, double accuracy) {
  SceneTable const run = file.section("run"), method = file.section("method");
  if (!method.has("step")) return false;
  auto const before = accuracy_keys.chosen_for.find(run);
  if (!before)
    accuracy_keys.accuracy.fail(
        run, fmt::format("it chooses the step, and method.step = {} is given; one of the two is expected",
                         method.found("step")));
  if (*before != accuracy)
    accuracy_keys.accuracy.fail(
        run, fmt::format("method.step = {} was chosen for an accuracy of {}, and {} is asked; "
                         "--unset method.step has another one chosen",
                         method.found("step"), *before, accuracy));
  return true;
}

}  // namespace

WrittenOrder::WrittenOrder(std::string text)
    : written(std::move(text)), power(std::stoi(written.substr(written.rfind(',') + 1))) {}
WrittenOrder WrittenOrder::of(SceneTable const& method) {
  return WrittenOrder(method.is_text("order") ? method.text("order")
                                              : std::to_string(method.integer("order", 1, 1000)));
}
void WrittenOrder::write(SceneTable& method) const {
  if (written == std::to_string(power))
    method.set("order", long{power});
  else
    method.set("order", written);
}

Pattern<double> AccuracyKeys::small_positive() {
  std::string const expects = "a number > 0, and 0.1 at most";
  return {expects,
          [expects](SceneTable const& table, std::string const& name) {
            double const value = table.number(name);
            if (!(value > 0 && value <= 0.1))
              table.fail(name, fmt::format("{}: {} is expected, found {}", name, expects, value));
            return value;
          },
          {},
          "radians, or relative"};
}

std::string ChosenSteps::in_words(Simulation const& simulation) const {
  if (simulation.exact || simulation.companion.exact)
    return fmt::format("accuracy {}: the method is exact, and has no error but that of rounding", accuracy);
  std::string const steps = fmt::format("accuracy {}: {} of order {} with steps of {}", accuracy, method,
                                        order->written, simulation.step);
  if (!pilot) return steps + ", as they were chosen for it";
  auto const& end = pilot->told.back();
  auto const largest =
      std::ranges::find_if(pilot->told, [&](auto const& at) { return at.error >= 0.99 * end.error; });
  return fmt::format("{}, estimated error {:.1e}{} of the {} at t = {:.6g}", steps,
                     pilot->error_with(simulation.step, order->power), end.unit, end.of, largest->time);
}

std::optional<ChosenSteps> choose_steps(System const& system, Request const& request, Pilots const& pilots) {
  SceneTable run = request.file.section("run"), method = request.file.section("method");
  auto const has_key = [&](Parameter const& key) { return key.key == "run.accuracy"; };
  if (std::ranges::none_of(system.parameters, has_key)) return {};
  auto const accuracy = accuracy_keys.accuracy.find(run);
  if (!accuracy) {
    if (accuracy_keys.chosen_for.given(run))
      accuracy_keys.chosen_for.fail(run, "it goes with run.accuracy, which is missing");
    return {};
  }
  bool const chosen = is_chosen(request.file, *accuracy), order_given = method.has("order");
  if (!method.has("name") && !order_given && system.method_for_accuracy)
    method.set("name", system.method_for_accuracy(request.file));
  Simulation const first = system.prepare(request);
  ChosenSteps out{*accuracy, method.text("name"), {}};
  if (first.exact || first.companion.exact) return out;
  if (!pilots.made && !chosen) return {};
  if (chosen) return out.order = WrittenOrder::of(method), out;
  Candidate const best =
      Chooser(system, request, first, *accuracy, pilots.stop).choose(orders_of(system, method, order_given));
  best.order.write(method), method.set("step", request.schedule.default_step(best.step));
  accuracy_keys.chosen_for.write(run, *accuracy);
  out.order = best.order, out.pilot = best.pilot;
  return out;
}

}  // namespace actio::scene
