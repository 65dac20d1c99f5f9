#include "program/registry/pilot.hpp"

#include <algorithm>
#include <cmath>

namespace actio::scene {
namespace {

/// Of the rows after the start.
double first_of(Schedule const& rows) { return rows.time(0) > 0 ? rows.time(0) : rows.time(1); }

/// Times at which the error is looked at: 64 at equal distances, and before the first of them its halves.
/// @param first  none is before this one
std::vector<double> times_to(double until, double first) {
  constexpr int equal = 64, halves = 20;
  std::vector<double> out;
  for (int k = halves; k > 0; --k) out.push_back(until / equal * std::exp2(-k));
  for (int k = 1; k < equal; ++k) out.push_back(until * k / equal);
  std::erase_if(out, [first](double time) { return time < first; });
  out.push_back(until);
  return out;
}

/// The motion up to a time, and its companions.
class Flight {
 public:
  Flight(Simulation& simulation, Stop const& stop)
      : simulation_(simulation), stop_(stop), estimate_(simulation) {}

  void go_to(double time, bool last) {
    double const ratio = time / simulation_.step, whole = std::round(ratio);
    bool const meets = std::abs(ratio - whole) <= 1e-9 * std::max(1.0, ratio);
    advance_to(static_cast<long>(meets ? whole : std::floor(ratio)));
    simulation_.motion->look_ahead(meets ? 0 : time - static_cast<double>(made_) * simulation_.step);
    estimate_.see(0, time, made_, last);
  }
  ErrorEstimate const& estimate() const { return estimate_; }

 private:
  void advance_to(long target) {
    while (made_ < target) {
      long const piece = std::min(target - made_, simulation_.steps_at_once);
      if (stop_ && stop_()) throw Stopped();
      simulation_.motion->advance(piece);
      estimate_.follow(made_ += piece);
    }
  }

  Simulation& simulation_;
  Stop const& stop_;
  ErrorEstimate estimate_;
  long made_ = 0;
};

}  // namespace

double rounding_over(double steps) {
  return std::numeric_limits<double>::epsilon() * std::sqrt(std::max(1.0, steps));
}

double Pilot::error_with(double length, int order) const {
  double const of_method = std::max(0.0, told.back().error - rounding(step));
  return of_method * std::pow(length / step, order) + rounding(length);
}

double Pilot::step_for(double error, int order) const {
  double const of_method = std::max(told.back().error - rounding(step), 1e-3 * rounding(step));
  double length = step;
  // Rounding depends on the step by its root, and converges at once.
  for (int k = 0; k < 8; ++k) {
    double const left = error - rounding(length);
    if (!(left > 0)) return 0;
    length = step * std::pow(left / of_method, 1.0 / order);
  }
  return length;
}

double Pilot::met_until(double error) const {
  auto const above_rounding = [this](Point const& p) { return p.error > 30 * rounding_over(p.time / step); };
  auto const first = std::ranges::find_if(told, above_rounding);
  for (auto at = first; at != told.end(); ++at) {
    double const growth = at->error / first->error * first->time / at->time;
    if (rounding_over(at->time / step) * std::max(1.0, growth) > error)
      return at == told.begin() ? 0 : (at - 1)->time;
  }
  return until;
}

Pilot pilot(Simulation simulation, Schedule const& rows, Stop const& stop) {
  Pilot out;
  double const until = rows.until();
  out.step = simulation.step, out.until = until;
  if (!simulation.failure.empty() || !simulation.companion.motion) {
    out.untold = simulation.failure.empty() ? simulation.companion.how : simulation.failure;
    return out;
  }
  Flight flight(simulation, stop);
  try {
    for (double const time : times_to(until, std::min(first_of(rows), 16 * out.step))) {
      flight.go_to(time, time == until);
      auto const worst = flight.estimate().worst();
      out.untold = worst ? worst->said : flight.estimate().how();
      if (worst && worst->told()) out.told.push_back({time, worst->error, worst->name, worst->unit});
    }
  } catch (Stopped const&) {
    throw;
  } catch (Error const& error) {
    out.untold = error.what();
  }
  return out;
}

}  // namespace actio::scene
