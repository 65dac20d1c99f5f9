#include "actio/rods/rod_steps.hpp"

#include <algorithm>
#include <cmath>
#include <exception>

#include "actio/numbers/errors.hpp"
#include "actio/parallel/team.hpp"
#include "actio/rods/rod_shape.hpp"
#include "actio/rods/rod_sweeps.hpp"

namespace actio::rods {
namespace {

using bodies::plus;

Impulse sum(Impulse const& a, Impulse const& b) {
  return {plus(a.linear, b.linear), plus(a.angular, b.angular)};
}

/// Rounded up to what sweeps go over.
std::size_t whole_packs(std::size_t count) { return (count + most_lanes - 1) / most_lanes * most_lanes; }

/// Equal parts of the sections, in whole packs. Few sections are left to one thread: a part takes longer than
/// the threads need to meet.
std::vector<Range> parts_of(std::size_t sections, int threads) {
  constexpr std::size_t least = 512;
  std::size_t const all = whole_packs(sections),
                    parts = std::max<std::size_t>(
                        1, std::min(static_cast<std::size_t>(std::max(1, threads)), all / least));
  std::vector<Range> out;
  for (std::size_t k = 0, begin = 0; k < parts; ++k) {
    std::size_t const end = k + 1 == parts ? all : all * (k + 1) / parts / most_lanes * most_lanes;
    out.push_back({begin, end}), begin = end;
  }
  return out;
}

}  // namespace

RodSteps::RodSteps(RodConstants constants, RodLoads loads, RodOptions const& options, RodState const& state)
    : constants_(std::move(constants)), loads_(std::move(loads)), options_(options), trial_(state) {
  auto const size = row_size(state.sections) + first_element;
  forces_ = {zero_rows<3>(size), zero_rows<3>(size), zero_rows<3>(size)};
  excess_ = zero_rows<3>(size);
  if (options.unshearable)
    stretches_ = {constants_,
                  {loads_.start.held != RodEnd::Held::free, loads_.end.held != RodEnd::Held::free}};
}

void RodSteps::add_load(RodState const& state, bool last, double time) {
  RodEnd const& end = last ? loads_.end : loads_.start;
  std::size_t const at = last ? first_element + constants_.elements : first_element - 1;
  double const sign = last ? 1 : -1;
  Three<double> force{}, moment{};
  auto const q = vector_at(state.q, last ? constants_.elements : 0);
  if (end.force) force = end.force_in_body ? turned(q, end.force(time)) : end.force(time);
  if (end.moment) moment = end.moment_in_body ? end.moment(time) : bodies::turned_back(q, end.moment(time));
  put_vector(forces_.f, at, times(sign, force));
  put_vector(last ? forces_.first : forces_.second, at, times(sign, moment));
}

void RodSteps::close() {
  std::size_t const last = first_element + constants_.elements - 1;
  put_vector(forces_.f, first_element - 1, vector_at(forces_.f, last));
  put_vector(forces_.second, first_element - 1, vector_at(forces_.second, last));
}

Impulse RodSteps::impulse_of_loads(RodState const& state, double kick, double time) const {
  Impulse out;
  if (std::ranges::any_of(constants_.acceleration, [](double g) { return g != 0; }))
    for (std::size_t k = 0; k < state.sections; ++k)
      out.add(vector_at(state.x, k),
              times(kick * constants_.share[k] * constants_.section.mass, constants_.acceleration));
  for (RodEnd const* const end : {&loads_.start, &loads_.end}) {
    std::size_t const k = end == &loads_.start ? 0 : constants_.elements;
    auto const q = vector_at(state.q, k);
    if (end->force) {
      auto const F = end->force(time);
      out.add(vector_at(state.x, k), times(kick, end->force_in_body ? turned(q, F) : F));
    }
    if (end->moment) {
      auto const m = end->moment(time);
      out.angular = plus(out.angular, times(kick, end->moment_in_body ? turned(q, m) : m));
    }
  }
  return out;
}

Impulse RodSteps::hold(bool last, RodState const& from, double kick, double step, double time,
                       RodState& to) const {
  RodEnd const& end = last ? loads_.end : loads_.start;
  Impulse out;
  if (end.held == RodEnd::Held::free) return out;
  std::size_t const k = last ? constants_.elements : 0, at = first_element + k;
  double const share = constants_.share[k], mass = share * constants_.section.mass;
  auto const x = vector_at(from.x, k);
  auto const q = vector_at(from.q, k);
  Placement const next = end.motion ? end.motion(time + step) : Placement{x, q};
  Three<double> const v = times(1 / step, difference(next.place, x));
  Three<double> const pull = difference(vector_at(forces_.f, at), vector_at(forces_.f, at - 1));
  Three<double> reaction = times(mass, difference(v, vector_at(from.v, k)));
  reaction = difference(reaction, times(kick, plus(pull, times(mass, constants_.acceleration))));
  out.add(x, reaction);
  put_vector(to.x, k, next.place), put_vector(to.v, k, v);
  if (end.held == RodEnd::Held::pinned) return out;
  // The momenta of the scheme of Moser and Veselov, before and after the turn e.
  Four<double> e = bodies::compose(inverse_turn(q), next.attitude);
  if (e[0] < 0) e = {-e[0], -e[1], -e[2], -e[3]};
  Three<double> const axis{e[1], e[2], e[3]},
      y = times(2 * share / step, times(constants_.section.inertia, axis)), straight = times(e[0], y),
      across = cross(axis, y);
  Three<double> const moment = difference(vector_at(forces_.first, at), vector_at(forces_.second, at - 1));
  Three<double> const turn =
      difference(difference(plus(straight, across), vector_at(from.M, k)), times(kick, moment));
  out.angular = plus(out.angular, turned(q, turn));
  put_vector(to.M, k, difference(straight, across)), put_vector(to.q, k, next.attitude);
  return out;
}

bool RodSteps::advance(RodState& state, double step, long count, double time) {
  if (!options_.unshearable) return advance_free(state, step, count, time);
  for (long k = 0; k < count; ++k)
    if (!advance_unshearable(state, step, time + static_cast<double>(k) * step)) return false;
  return true;
}

bool RodSteps::advance_free(RodState& state, double step, long count, double time) {
  auto const parts = parts_of(state.sections, options_.threads);
  int const last = static_cast<int>(parts.size()) - 1;
  // Of the step before and of this one: a part that is ahead does not write what another one still reads.
  std::vector<char> failed(2 * parts.size(), 0);
  Impulse at_start, at_end;
  // Loads and supports are given from outside, and may throw; then all members leave together.
  std::array<std::exception_ptr, 2> thrown;
  double const before = state.step_before;
  as_team(last + 1, [&](int part, Meeting& meeting) {
    Range const range = parts[static_cast<std::size_t>(part)];
    auto const given = [&](bool at_the_end, auto const& work) {
      auto& error = thrown[at_the_end ? 1 : 0];
      try {
        if (!error) work();
      } catch (...) {
        error = std::current_exception();
      }
    };
    auto const keep = [&](std::size_t k) {
      put_vector(trial_.x, k, vector_at(state.x, k)), put_vector(trial_.v, k, vector_at(state.v, k));
      put_vector(trial_.M, k, vector_at(state.M, k)), put_vector(trial_.q, k, vector_at(state.q, k));
    };
    for (long k = 0; k < count; ++k) {
      double const now = time + static_cast<double>(k) * step, kick = ((k == 0 ? before : step) + step) / 2;
      char* const failures = failed.data() + static_cast<std::size_t>(k % 2) * parts.size();
      bool sound = sweep_elements(options_.registers, constants_, state, forces_, range);
      if (part == 0) {
        state.impulse = sum(state.impulse, sum(at_start, at_end));
        given(false, [&] { state.impulse = sum(state.impulse, impulse_of_loads(state, kick, now)); });
        keep(0);
      }
      if (part == last) keep(state.sections - 1);
      if (part == last && !state.closed) given(true, [&] { add_load(state, true, now); });
      meeting.wait();
      if (part == 0 && state.closed) close();
      if (part == 0 && !state.closed) given(false, [&] { add_load(state, false, now); });
      sound =
          sweep_sections(options_.registers, constants_, forces_, kick, step, state, state, range) && sound;
      if (part == 0) given(false, [&] { at_start = hold(false, trial_, kick, step, now, state); });
      if (part == last) given(true, [&] { at_end = hold(true, trial_, kick, step, now, state); });
      failures[part] = !sound || (part == 0 && thrown[0]) || (part == last && thrown[1]);
      meeting.wait();
      if (std::ranges::any_of(failures, failures + parts.size(), [](char one) { return one != 0; })) return;
      if (part == last) state.extend();
    }
  });
  for (auto const& error : thrown)
    if (error) std::rethrow_exception(error);
  if (std::ranges::any_of(failed, [](char one) { return one != 0; })) return false;
  state.impulse = sum(state.impulse, sum(at_start, at_end));
  state.step_before = step;
  return true;
}

bool RodSteps::advance_unshearable(RodState& state, double step, double time) {
  double const kick = (state.step_before + step) / 2;
  auto const registers = options_.registers;
  Range const all_elements{0, whole_packs(constants_.elements)}, all_sections{0, whole_packs(state.sections)};
  if (!stretches_.factor(registers, constants_, state, kick * step)) return false;
  Rows<3>& N = trial_.N;
  N = state.N;
  double farthest = 0;
  for (auto const& row : state.x)
    for (double const x : row) farthest = std::max(farthest, std::abs(x));
  double const length = 1 / constants_.inverse_length[0], tolerance = 4e-16 * std::max(farthest, length);
  double last = HUGE_VAL;
  for (int round = 0; round < 40; ++round) {
    if (!sweep_elements_with(registers, constants_, state, N, forces_, all_elements)) return false;
    add_load(state, false, time), add_load(state, true, time);
    if (!sweep_sections(registers, constants_, forces_, kick, step, state, trial_, all_sections))
      return false;
    Impulse const at_start = hold(false, state, kick, step, time, trial_),
                  at_end = hold(true, state, kick, step, time, trial_);
    trial_.extend();
    double const worst = sweep_stretches(registers, constants_, trial_, excess_, all_elements);
    if (!std::isfinite(worst)) return false;
    if (worst <= tolerance || (worst <= 64 * tolerance && worst > last / 2)) {
      trial_.step_before = step;
      trial_.impulse = sum(sum(state.impulse, impulse_of_loads(state, kick, time)), sum(at_start, at_end));
      std::swap(state, trial_);
      return true;
    }
    last = worst;
    stretches_.correct(excess_, N);
  }
  return false;
}

double RodSteps::stretched(RodState const& state) const {
  Rows<3> excess = excess_;
  sweep_stretches(options_.registers, constants_, state, excess, {0, whole_packs(constants_.elements)});
  double worst = 0;
  for (auto const& row : excess)
    for (std::size_t k = 0; k < constants_.elements; ++k) {
      double const one = std::abs(row[k]) * constants_.inverse_length[k];
      if (!(one <= worst)) worst = one;
    }
  return worst;
}

std::string RodSteps::failure(RodState const& state, double step, double time) {
  std::string const at = "; the state is that at t = " + show(time);
  for (std::size_t k = 0; k < constants_.elements; ++k) {
    std::size_t const after = k + 1 == state.sections ? 0 : k + 1;
    auto const e =
        RelativePlacement<double>::of(vector_at(state.q, k), vector_at(state.q, after),
                                      difference(vector_at(state.x, after), vector_at(state.x, k)));
    if (double const turn = std::sqrt(bodies::dot(e.w, e.w)); !(turn <= largest_turn))
      return "rod: element " + std::to_string(k) + " turns by " + show(2 * std::atan(turn / 2)) +
             " radians, bound " + show(2 * std::atan(largest_turn / 2)) +
             ": more elements are needed where a rod is bent that much" + at;
  }
  double const kick = (state.step_before + step) / 2;
  if (!options_.unshearable)
    for (std::size_t k = 0; k < state.sections; ++k) {
      auto M = vector_at(state.M, k);
      auto const first = vector_at(forces_.first, first_element + k),
                 second = vector_at(forces_.second, first_element + k - 1);
      double turn = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        M[i] += kick * (first[i] - second[i]);
        turn = std::max(turn,
                        std::abs(M[i]) * constants_.inverse_share[k] / constants_.section.inertia[i] * step);
      }
      if (!(turn <= 1))
        return "rod: section " + std::to_string(k) + " would turn by " + show(turn) +
               " radians in a step of " + show(step) + ", bound 1; a step of " + show(0.5 * step / turn) +
               " would do" + at;
    }
  return std::string("rod: ") +
         (options_.unshearable ? "no contact forces that keep stretch and shear are found"
                               : "places and momenta are finite no more") +
         " after a step of " + show(step) + at;
}

}  // namespace actio::rods
