#include "actio/rods/rod.hpp"

#include <algorithm>
#include <cmath>

#include "actio/rods/step_limit.hpp"

namespace actio::rods {
namespace {

using bodies::plus;

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

/// The state at the start, or what is wrong with it.
RodState examined_start(RodConstants const& constants, RodShape const& rest, RodStart const& start,
                        RodLoads const& loads, RodOptions const& options) {
  if (rest.sections() != start.shape.sections() || rest.closed != start.shape.closed)
    throw OutsideDomain("rod", "at the start there are as many sections as at rest; given",
                        static_cast<double>(start.shape.sections()), static_cast<double>(rest.sections()));
  loads.examine(rest.closed);
  if (options.unshearable && rest.closed)
    throw OutsideDomain("rod", "a ring without stretch and shear is not built; rings", 1, 0);
  if (!(options.step > 0 && std::isfinite(options.step)))
    throw OutsideDomain("rod", "the step must be a positive number; it", options.step, 0);
  require_stable_step(constants, options.step, options.unshearable);
  for (std::size_t k = 0; k < constants.elements; ++k) {
    auto const w = start.shape.element(k).w;
    if (double const turn = std::sqrt(bodies::dot(w, w)); !(turn <= largest_turn))
      throw OutsideDomain("rod",
                          "at the start an element must turn by no more than a right angle; element " +
                              std::to_string(k) + " turns by",
                          2 * std::atan(turn / 2), 2 * std::atan(largest_turn / 2));
  }
  return state_of(constants, start);
}

}  // namespace

Rod::Rod(RodSection const& section, RodShape const& rest, RodStart const& start, RodLoads const& loads,
         RodOptions const& options)
    : state_(examined_start(constants_of(section, rest, loads), rest, start, loads, options)),
      steps_of_(constants_of(section, rest, loads), loads, options, state_),
      step_(options.step) {
  constexpr double bound = 1e-10;
  if (double const stretched = steps_of_.stretched(state_); options.unshearable && !(stretched <= bound))
    throw OutsideDomain("rod",
                        "a rod that neither stretches nor shears begins unstretched; the largest strain",
                        stretched, bound);
}

void Rod::step(long count) {
  if (count < 0)
    throw OutsideDomain("rod", "the number of steps must not be negative", static_cast<double>(count), 0);
  ahead_.reset();
  constexpr long between_copies = 64;
  while (count > 0) {
    RodState const kept = state_;
    long const some = std::min(count, between_copies);
    bool sound = false;
    try {
      sound = steps_of_.advance(state_, step_, some, time()) && all_finite(state_);
    } catch (...) {
      // A load or a support has refused a time: the single steps come to it.
    }
    if (sound) {
      steps_ += some, count -= some;
      continue;
    }
    for (state_ = kept;; ++steps_) advance(state_, step_, time());
  }
}

void Rod::advance(RodState& state, double step, double time) {
  RodState next = state;
  if (!steps_of_.advance(next, step, 1, time) || !all_finite(next))
    throw RodStepFails(steps_of_.failure(state, step, time));
  state = std::move(next);
}

void Rod::look_ahead(double time) {
  ahead_.reset();
  ahead_time_ = 0;
  if (time == 0) return;
  RodState ahead = state_;
  advance(ahead, time, this->time());
  ahead_ = std::move(ahead), ahead_time_ = time;
}

void Rod::change_step(double first, double step, long made) {
  ahead_.reset();
  require_stable_step(constants(), step, steps_of_.options().unshearable);
  if (first > 0) advance(state_, first, time());
  step_ = step, steps_ = made;
}

RodFrame Rod::frame() {
  RodState const& state = now();
  std::size_t const sections = state.sections;
  RodState next = state;
  // Where there is no next step, momenta are those of the last one.
  bool const goes_on = steps_of_.advance(next, step_, 1, time_now());
  double const part = goes_on ? state.step_before / (state.step_before + step_) : 0;
  RodFrame out;
  for (std::size_t k = 0; k < sections; ++k) {
    auto const q = vector_at(state.q, k);
    auto const v = vector_at(state.v, k), M = vector_at(state.M, k);
    out.places.push_back(vector_at(state.x, k)), out.attitudes.push_back(q);
    out.velocities.push_back(plus_times(v, part, difference(vector_at(next.v, k), v)));
    auto const leaving = bodies::turned_back(q, turned(vector_at(next.q, k), vector_at(next.M, k)));
    out.body_momenta.push_back(plus_times(M, part, difference(leaving, M)));
  }
  for (std::size_t k = 0; k < elements(); ++k) {
    std::size_t const after = k + 1 == sections ? 0 : k + 1;
    auto const dx = difference(out.places[after], out.places[k]);
    ElementAtRest<double> const rest{constants().inverse_length[k], vector_at(constants().Gamma, k),
                                     vector_at(constants().kappa, k)};
    out.strains.push_back(
        element_strain(RelativePlacement<double>::of(out.attitudes[k], out.attitudes[after], dx), rest));
    auto const f = vector_at(steps_of_.forces().f, first_element + k);
    out.contact_force.push_back(f);
    out.contact_moment.push_back(
        difference(turned(out.attitudes[k], vector_at(steps_of_.forces().first, first_element + k)),
                   cross(times(0.5, dx), f)));
  }
  return out;
}

RodEnergies Rod::energies(RodFrame const& frame) const {
  RodEnergies out{0, 0, 0};
  auto const& section = constants().section;
  for (std::size_t k = 0; k < frame.places.size(); ++k) {
    double const share = constants().share[k], mass = share * section.mass;
    out.kinetic += mass * bodies::dot(frame.velocities[k], frame.velocities[k]) / 2;
    for (std::size_t i = 0; i < 3; ++i)
      out.kinetic += frame.body_momenta[k][i] * frame.body_momenta[k][i] / section.inertia[i] / share / 2;
    out.gravity -= mass * bodies::dot(constants().acceleration, frame.places[k]);
  }
  for (std::size_t k = 0; k < frame.strains.size(); ++k) {
    auto const& [Gamma, kappa] = frame.strains[k];
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      if (!steps_of_.options().unshearable) sum += section.stretching[i] * Gamma[i] * Gamma[i];
      sum += section.bending[i] * kappa[i] * kappa[i];
    }
    out.strain += sum / constants().inverse_length[k] / 2;
  }
  return out;
}

double Rod::constraint_residual() {
  if (!steps_of_.options().unshearable) return 0;
  return steps_of_.stretched(now());
}

Impulse Rod::momentum() const {
  RodState const& state = now();
  Impulse out;
  for (std::size_t k = 0; k < state.sections; ++k) {
    out.add(vector_at(state.x, k),
            times(constants().share[k] * constants().section.mass, vector_at(state.v, k)));
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
  std::vector<double> out{step_, static_cast<double>(steps_)};
  over_numbers(state_, steps_of_.options().unshearable, [&](double const& x) { out.push_back(x); });
  return out;
}

void Rod::restore(std::vector<double> const& state) {
  std::size_t at = 2, count = 2;
  over_numbers(state_, steps_of_.options().unshearable, [&](double&) { ++count; });
  if (state.size() != count)
    throw OutsideDomain("rod", "what a run remembers is of another rod; numbers",
                        static_cast<double>(state.size()), static_cast<double>(count));
  step_ = state[0], steps_ = std::lround(state[1]);
  over_numbers(state_, steps_of_.options().unshearable, [&](double& x) { x = state[at++]; });
  state_.extend(), ahead_.reset(), ahead_time_ = 0;
}

}  // namespace actio::rods
