#include "actio/rods/rod.hpp"

#include <algorithm>
#include <cmath>

#include "actio/numbers/team.hpp"
#include "actio/rods/rod_sweeps.hpp"
#include "actio/rods/step_limit.hpp"

namespace actio::rods {
namespace {

using bodies::plus;

Three<double> minus(Three<double> const& a, Three<double> const& b) { return plus_times(a, -1.0, b); }

Range all(std::size_t count) { return {0, (count + most_lanes - 1) / most_lanes * most_lanes}; }

bool all_finite(RodState const& state) {
  for (auto const* const rows : {&state.x, &state.v, &state.M})
    for (auto const& row : *rows)
      for (std::size_t k = 0; k < state.sections; ++k)
        if (!std::isfinite(row[k])) return false;
  return true;
}

RodConstants constants_of(RodSection const& section, RodShape const& rest, RodLoads const& loads) {
  section.examine();
  RodConstants out;
  out.section = section, out.elements = rest.elements(), out.acceleration = loads.gravity;
  std::size_t const size = row_size(rest.sections());
  out.share.assign(size, 0), out.inverse_share.assign(size, 0), out.inverse_length.assign(size, 1);
  out.Gamma = zero_rows<3>(size), out.kappa = zero_rows<3>(size);
  auto const elements = elements_at_rest(rest);
  for (std::size_t k = 0; k < elements.size(); ++k) {
    out.inverse_length[k] = elements[k].inverse_length;
    put_vector(out.Gamma, k, elements[k].Gamma), put_vector(out.kappa, k, elements[k].kappa);
    double const half = 1 / elements[k].inverse_length / 2;
    out.share[k] += half, out.share[rest.after(k)] += half;
  }
  for (std::size_t k = 0; k < rest.sections(); ++k) out.inverse_share[k] = 1 / out.share[k];
  // What a clamped section feels does not turn it.
  if (loads.start.held == RodEnd::Held::clamped) out.inverse_share.front() = 0;
  if (loads.end.held == RodEnd::Held::clamped) out.inverse_share[rest.sections() - 1] = 0;
  return out;
}

void require_vectors(std::vector<Three<double>> const& vectors, std::size_t sections, char const* what) {
  if (!vectors.empty() && vectors.size() != sections)
    throw OutsideDomain("rod", std::string(what) + " of each section is needed; given",
                        static_cast<double>(vectors.size()), static_cast<double>(sections));
}

RodState state_of(RodConstants const& constants, RodStart const& start) {
  RodState out;
  out.sections = start.shape.sections(), out.closed = start.shape.closed;
  require_vectors(start.velocity, out.sections, "a velocity");
  require_vectors(start.angular_velocity, out.sections, "an angular velocity");
  std::size_t const size = row_size(out.sections);
  out.x = out.v = out.M = out.N = zero_rows<3>(size), out.q = zero_rows<4>(size);
  for (std::size_t k = 0; k < out.sections; ++k) {
    put_vector(out.x, k, start.shape.places[k]), put_vector(out.q, k, start.shape.attitudes[k]);
    if (!start.velocity.empty()) put_vector(out.v, k, start.velocity[k]);
    if (!start.angular_velocity.empty())
      put_vector(out.M, k,
                 times(constants.share[k], times(constants.section.inertia, start.angular_velocity[k])));
  }
  out.extend();
  if (!all_finite(out)) throw NotFinite("rod: places and velocities at the start");
  return out;
}

}  // namespace

Rod::Rod(RodSection const& section, RodShape const& rest, RodStart const& start, RodLoads const& loads,
         RodOptions const& options)
    : constants_(constants_of(section, rest, loads)), loads_(loads), options_(options) {
  if (rest.sections() != start.shape.sections() || rest.closed != start.shape.closed)
    throw OutsideDomain("rod", "at the start there are as many sections as at rest; given",
                        static_cast<double>(start.shape.sections()), static_cast<double>(rest.sections()));
  loads_.examine(rest.closed);
  if (options.unshearable && rest.closed)
    throw OutsideDomain("rod", "a ring without stretch and shear is not built; rings", 1, 0);
  if (!(options.step > 0 && std::isfinite(options.step)))
    throw OutsideDomain("rod", "the step must be a positive number; it", options.step, 0);
  require_stable_step(constants_, options.step, options.unshearable);
  state_ = state_of(constants_, start);
  auto const size = row_size(state_.sections) + first_element;
  forces_ = {zero_rows<3>(size), zero_rows<3>(size), zero_rows<3>(size)};
  trial_ = state_;
  for (std::size_t k = 0; k < elements(); ++k) {
    if (double const turn = bodies::dot(start.shape.element(k).w, start.shape.element(k).w); !(turn <= 4))
      throw OutsideDomain("rod",
                          "at the start an element must turn by no more than a right angle; element " +
                              std::to_string(k) + " turns by",
                          2 * std::atan(std::sqrt(turn) / 2), M_PI / 2);
  }
  if (options.unshearable) {
    Rows<3> excess = zero_rows<3>(size);
    double const worst = sweep_stretches(options.registers, constants_, state_, excess, all(elements()));
    double const bound = 1e-10 / *std::ranges::max_element(constants_.inverse_length);
    if (!(worst <= bound))
      throw OutsideDomain("rod",
                          "at the start a rod that neither stretches nor shears is stretched by (length)",
                          worst, bound);
  }
}

void Rod::add_loads(RodState const& state, double time, RodForces& forces) const {
  auto const put = [&](RodEnd const& end, std::size_t section, std::size_t at, double sign,
                       Rows<3>& moments) {
    Three<double> force{}, moment{};
    auto const q = vector_at(state.q, section);
    if (end.force) force = end.force_in_body ? turned(q, end.force(time)) : end.force(time);
    if (end.moment) moment = end.moment_in_body ? end.moment(time) : bodies::turned_back(q, end.moment(time));
    put_vector(forces.f, at, times(sign, force)), put_vector(moments, at, times(sign, moment));
  };
  if (state.closed) {
    put_vector(forces.f, first_element - 1, vector_at(forces.f, first_element + constants_.elements - 1));
    put_vector(forces.second, first_element - 1,
               vector_at(forces.second, first_element + constants_.elements - 1));
    return;
  }
  put(loads_.start, 0, first_element - 1, -1, forces.second);
  put(loads_.end, constants_.elements, first_element + constants_.elements, 1, forces.first);
}

void Rod::hold(RodEnd const& end, bool last, RodState const& from, RodForces const& forces, double kick,
               double step, double time, RodState& to) const {
  if (end.held == RodEnd::Held::free) return;
  std::size_t const k = last ? constants_.elements : 0, at = first_element + k;
  double const share = constants_.share[k], mass = share * constants_.section.mass;
  auto const x = vector_at(from.x, k);
  auto const q = vector_at(from.q, k);
  Placement const next = end.motion ? end.motion(time + step) : Placement{x, q};
  Three<double> const v = times(1 / step, minus(next.place, x));
  Three<double> const pull = minus(vector_at(forces.f, at), vector_at(forces.f, at - 1));
  Three<double> reaction = times(mass, minus(v, vector_at(from.v, k)));
  reaction = minus(reaction, times(kick, plus(pull, times(mass, constants_.acceleration))));
  to.impulse.add(x, reaction);
  put_vector(to.x, k, next.place), put_vector(to.v, k, v);
  if (end.held == RodEnd::Held::pinned) return;
  // The momenta of the scheme of Moser and Veselov, before and after the turn e.
  Four<double> e = bodies::compose(inverse_turn(q), next.attitude);
  if (e[0] < 0) e = {-e[0], -e[1], -e[2], -e[3]};
  Three<double> const axis{e[1], e[2], e[3]},
      y = times(2 * share / step, times(constants_.section.inertia, axis)), straight = times(e[0], y),
      across = cross(axis, y);
  Three<double> const moment = minus(vector_at(forces.first, at), vector_at(forces.second, at - 1));
  Three<double> const turn = minus(minus(plus(straight, across), vector_at(from.M, k)), times(kick, moment));
  to.impulse.angular = plus(to.impulse.angular, turned(q, turn));
  put_vector(to.M, k, minus(straight, across)), put_vector(to.q, k, next.attitude);
}

void Rod::account(RodState const& from, double kick, double time, RodState& to) const {
  bool const falls = std::ranges::any_of(constants_.acceleration, [](double g) { return g != 0; });
  if (falls)
    for (std::size_t k = 0; k < from.sections; ++k)
      to.impulse.add(vector_at(from.x, k),
                     times(kick * constants_.share[k] * constants_.section.mass, constants_.acceleration));
  auto const load = [&](RodEnd const& end, std::size_t k) {
    auto const q = vector_at(from.q, k);
    if (end.force) {
      auto const F = end.force(time);
      to.impulse.add(vector_at(from.x, k), times(kick, end.force_in_body ? turned(q, F) : F));
    }
    if (end.moment) {
      auto const m = end.moment(time);
      to.impulse.angular = plus(to.impulse.angular, times(kick, end.moment_in_body ? turned(q, m) : m));
    }
  };
  load(loads_.start, 0), load(loads_.end, constants_.elements);
}

bool Rod::advance(RodState& state, double step, double time) {
  double const kick = (state.step_before + step) / 2;
  if (options_.unshearable) return advance_unshearable(state, kick, step, time);
  if (!sweep_elements(options_.registers, constants_, state, forces_, all(elements()))) return false;
  add_loads(state, time, forces_);
  account(state, kick, time, state);
  RodState const& from = state;
  // Ends that are held need what they were.
  auto& before = trial_;
  auto const keep = [&](std::size_t k) {
    put_vector(before.x, k, vector_at(from.x, k)), put_vector(before.v, k, vector_at(from.v, k));
    put_vector(before.M, k, vector_at(from.M, k)), put_vector(before.q, k, vector_at(from.q, k));
  };
  keep(0), keep(state.sections - 1);
  if (!sweep_sections(options_.registers, constants_, forces_, kick, step, state, state, all(state.sections)))
    return false;
  hold(loads_.start, false, before, forces_, kick, step, time, state);
  hold(loads_.end, true, before, forces_, kick, step, time, state);
  state.extend(), state.step_before = step;
  return true;
}

bool Rod::advance_unshearable(RodState& state, double kick, double step, double time) {
  auto const registers = options_.registers;
  auto const is = [](RodEnd const& end, RodEnd::Held how) { return end.held == how; };
  auto const clamped = RodEnd::Held::clamped;
  std::array<bool, 2> const attitudes{is(loads_.start, clamped), is(loads_.end, clamped)},
      places{!is(loads_.start, RodEnd::Held::free), !is(loads_.end, RodEnd::Held::free)};
  if (!stretches_.factor(constants_, state, kick * step, places, attitudes)) return false;
  Rows<3>& N = trial_.N;
  N = state.N;
  Rows<3> excess = zero_rows<3>(row_size(state.sections));
  double farthest = 0;
  for (auto const& row : state.x)
    for (double const x : row) farthest = std::max(farthest, std::abs(x));
  double const length = 1 / constants_.inverse_length[0], tolerance = 4e-16 * std::max(farthest, length);
  double last = HUGE_VAL;
  for (int round = 0; round < 40; ++round) {
    if (!sweep_elements_with(registers, constants_, state, N, forces_, all(elements()))) return false;
    add_loads(state, time, forces_);
    trial_.impulse = state.impulse;
    account(state, kick, time, trial_);
    if (!sweep_sections(registers, constants_, forces_, kick, step, state, trial_, all(state.sections)))
      return false;
    hold(loads_.start, false, state, forces_, kick, step, time, trial_);
    hold(loads_.end, true, state, forces_, kick, step, time, trial_);
    trial_.extend();
    double const worst = sweep_stretches(registers, constants_, trial_, excess, all(elements()));
    if (!std::isfinite(worst)) return false;
    if (worst <= tolerance || (worst <= 64 * tolerance && worst > last / 2)) {
      trial_.step_before = step;
      std::swap(state, trial_);
      return true;
    }
    last = worst;
    stretches_.correct(excess, N);
  }
  return false;
}

void Rod::step(long count) {
  if (count < 0)
    throw OutsideDomain("rod", "the number of steps must not be negative", static_cast<double>(count), 0);
  ahead_.reset();
  constexpr long between_copies = 64;
  while (count > 0) {
    RodState const kept = state_;
    long const some = std::min(count, between_copies), before = steps_;
    bool sound = true;
    for (; sound && steps_ < before + some; ++steps_) sound = advance(state_, options_.step, time());
    if (sound && all_finite(state_)) {
      count -= some;
      continue;
    }
    state_ = kept, steps_ = before;
    for (;;) {
      RodState const good = state_;
      if (advance(state_, options_.step, time()) && all_finite(state_)) {
        ++steps_;
        continue;
      }
      state_ = good;
      tell_failure(state_, options_.step, time());
    }
  }
}

void Rod::tell_failure(RodState const& state, double step, double time) const {
  (void)state;
  throw RodStepFails("rod: no step of " + std::to_string(step) + " from t = " + std::to_string(time));
}

void Rod::look_ahead(double time) {
  ahead_.reset();
  ahead_time_ = 0;
  if (time == 0) return;
  RodState ahead = state_;
  if (!advance(ahead, time, this->time())) tell_failure(state_, time, this->time());
  ahead_ = std::move(ahead), ahead_time_ = time;
}

void Rod::change_step(double first, double step, long made) {
  ahead_.reset();
  double const from = time();
  if (first > 0 && !advance(state_, first, from)) tell_failure(state_, first, from);
  options_.step = step, steps_ = made;
}

RodFrame Rod::frame() {
  RodState const& state = now();
  std::size_t const sections = state.sections;
  RodState next = state;
  // Where there is no next step, momenta are those of the last one.
  bool const goes_on = advance(next, options_.step, time() + ahead_time_);
  double const part = goes_on ? state.step_before / (state.step_before + options_.step) : 0;
  RodFrame out;
  for (std::size_t k = 0; k < sections; ++k) {
    auto const q = vector_at(state.q, k);
    auto const v = vector_at(state.v, k), M = vector_at(state.M, k);
    out.places.push_back(vector_at(state.x, k)), out.attitudes.push_back(q);
    out.velocities.push_back(plus_times(v, part, minus(vector_at(next.v, k), v)));
    auto const leaving = bodies::turned_back(q, turned(vector_at(next.q, k), vector_at(next.M, k)));
    out.body_momenta.push_back(plus_times(M, part, minus(leaving, M)));
  }
  for (std::size_t k = 0; k < elements(); ++k) {
    std::size_t const after = k + 1 == sections ? 0 : k + 1;
    auto const dx = minus(out.places[after], out.places[k]);
    ElementAtRest<double> const rest{constants_.inverse_length[k], vector_at(constants_.Gamma, k),
                                     vector_at(constants_.kappa, k)};
    out.strains.push_back(
        element_strain(RelativePlacement<double>::of(out.attitudes[k], out.attitudes[after], dx), rest));
    auto const f = vector_at(forces_.f, first_element + k);
    out.contact_force.push_back(f);
    out.contact_moment.push_back(minus(turned(out.attitudes[k], vector_at(forces_.first, first_element + k)),
                                       cross(times(0.5, dx), f)));
  }
  return out;
}

RodEnergies Rod::energies(RodFrame const& frame) const {
  RodEnergies out{0, 0, 0};
  auto const& section = constants_.section;
  for (std::size_t k = 0; k < frame.places.size(); ++k) {
    double const share = constants_.share[k], mass = share * section.mass;
    out.kinetic += mass * bodies::dot(frame.velocities[k], frame.velocities[k]) / 2;
    for (std::size_t i = 0; i < 3; ++i)
      out.kinetic += frame.body_momenta[k][i] * frame.body_momenta[k][i] / section.inertia[i] / share / 2;
    out.gravity -= mass * bodies::dot(constants_.acceleration, frame.places[k]);
  }
  for (std::size_t k = 0; k < frame.strains.size(); ++k) {
    auto const& [Gamma, kappa] = frame.strains[k];
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      if (!options_.unshearable) sum += section.stretching[i] * Gamma[i] * Gamma[i];
      sum += section.bending[i] * kappa[i] * kappa[i];
    }
    out.strain += sum / constants_.inverse_length[k] / 2;
  }
  return out;
}

double Rod::constraint_residual() {
  if (!options_.unshearable) return 0;
  Rows<3> excess = zero_rows<3>(row_size(sections()));
  sweep_stretches(options_.registers, constants_, now(), excess, all(elements()));
  double worst = 0;
  for (auto const& row : excess)
    for (std::size_t k = 0; k < elements(); ++k)
      worst = std::max(worst, std::abs(row[k]) * constants_.inverse_length[k]);
  return worst;
}

Impulse Rod::momentum() const {
  RodState const& state = now();
  Impulse out;
  for (std::size_t k = 0; k < state.sections; ++k) {
    out.add(vector_at(state.x, k),
            times(constants_.share[k] * constants_.section.mass, vector_at(state.v, k)));
    out.angular = plus(out.angular, turned(vector_at(state.q, k), vector_at(state.M, k)));
  }
  return out;
}

namespace {
/// Calls `visit` for each number that a step depends on.
template <class State, class Visit>
void over_numbers(State& state, bool multipliers, Visit const& visit) {
  auto const over = [&](auto& rows) {
    for (auto& row : rows)
      for (std::size_t k = 0; k < state.sections; ++k) visit(row[k]);
  };
  over(state.x), over(state.q), over(state.v), over(state.M);
  if (multipliers) over(state.N);
  visit(state.step_before);
  for (auto* const vector : {&state.impulse.linear, &state.impulse.angular})
    for (auto& one : *vector) visit(one);
}
}  // namespace

std::vector<double> Rod::remember() const {
  std::vector<double> out{options_.step, static_cast<double>(steps_)};
  over_numbers(state_, options_.unshearable, [&](double const& x) { out.push_back(x); });
  return out;
}

void Rod::restore(std::vector<double> const& state) {
  std::size_t at = 2, count = 2;
  over_numbers(state_, options_.unshearable, [&](double&) { ++count; });
  if (state.size() != count)
    throw OutsideDomain("rod", "what a run remembers is of another rod; numbers",
                        static_cast<double>(state.size()), static_cast<double>(count));
  options_.step = state[0], steps_ = std::lround(state[1]);
  over_numbers(state_, options_.unshearable, [&](double& x) { x = state[at++]; });
  state_.extend(), ahead_.reset(), ahead_time_ = 0;
}

}  // namespace actio::rods
