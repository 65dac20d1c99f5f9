// Bodies and motions that break codes, and how far apart two of their motions are.
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <cstdint>
#include <random>

#include "actio/fast_body/space/free_steps.hpp"
#include "actio/numbers/multiprecision.hpp"
#include "free_body_reference.hpp"

namespace actio::testing {

/// A body, a momentum, a time.
struct FreeProblem {
  std::array<double, 3> moments, momentum;
  double time;

  bodies::FreeBody body() const {
    return bodies::FreeBody(inertia_from_moments(moments[0], moments[1], moments[2]),
                            {SO<3>{}, Eigen::Vector3d(momentum[0], momentum[1], momentum[2])});
  }
  double magnitude() const { return std::hypot(momentum[0], momentum[1], momentum[2]); }
  /// The largest component of the angular velocity at the start.
  double rate() const {
    return std::max({std::abs(momentum[0] / moments[0]), std::abs(momentum[1] / moments[1]),
                     std::abs(momentum[2] / moments[2])});
  }
};

template <class S>
FreePath<S> start_of(FreeProblem const& p) {
  return {{S(p.momentum[0]), S(p.momentum[1]), S(p.momentum[2])}, {S(1), S(0), S(0), S(0)}};
}
/// The reference solution' answer.
template <class S>
FreePath<S> witness_of(FreeProblem const& p, int digits) {
  return FreeBodyWitness<S>(p.moments, digits).after(start_of<S>(p), S(p.time));
}

struct Apart {
  double momentum;  ///< largest difference of a component, relative to the amount
  double attitude;  ///< largest difference of a component of the quaternion, up to its sign
  double larger() const { return std::max(momentum, attitude); }
};
template <class S, class T>
Apart apart(FreePath<S> const& a, FreePath<T> const& b, double amount) {
  Apart d{0, 0};
  double other = 0;
  for (int i = 0; i < 3; ++i)
    d.momentum =
        std::max(d.momentum, std::abs(static_cast<double>(a.momentum[i] - S(b.momentum[i]))) / amount);
  for (int i = 0; i < 4; ++i) {
    d.attitude = std::max(d.attitude, std::abs(static_cast<double>(a.attitude[i] - S(b.attitude[i]))));
    other = std::max(other, std::abs(static_cast<double>(a.attitude[i] + S(b.attitude[i]))));
  }
  // A NaN is far from everything.
  d.attitude = d.attitude < other ? d.attitude : other;
  for (double* x : {&d.momentum, &d.attitude})
    if (!(*x == *x)) *x = 1e300;
  return d;
}
inline FreePath<double> path_of(bodies::FreeState const& s) {
  auto const& m = s.body_momentum.components;
  auto const& q = s.attitude.value;
  return {{m[0], m[1], m[2]}, {q[0], q[1], q[2], q[3]}};
}

/// The library's exact flow in the numbers of S, from a start that is the same real numbers in all of them.
template <class S>
FreePath<S> exact_path(FreeProblem const& p) {
  using std::sqrt;
  int first = 0;
  while ((p.moments[(first + 1) % 3] - p.moments[first % 3]) *
             (p.moments[(first + 2) % 3] - p.moments[(first + 1) % 3]) <
         0)
    ++first;
  bodies::Three<S> I, u;
  S square(0);
  for (int i = 0; i < 3; ++i)
    I[i] = S(p.moments[(i + first) % 3]), u[i] = S(p.momentum[(i + first) % 3]), square += u[i] * u[i];
  S const amount = sqrt(square);
  for (S& x : u) x /= amount;
  bodies::FrameState<S> state{u, {S(1), S(0), S(0), S(0)}};
  bodies::HalfTurn<S>(bodies::exact_flow<S>(bodies::InverseMoments<S>(I), u, S(p.time) / S(2) * amount))
      .leap(state);
  FreePath<S> path;
  path.attitude[0] = state.attitude[0];
  for (int i = 0; i < 3; ++i)
    path.momentum[(i + first) % 3] = amount * state.direction[i],
                                path.attitude[1 + (i + first) % 3] = state.attitude[1 + i];
  return path;
}

/// How far the answer moves, in all, when each of the seven numbers of the question moves by one unit in its
/// last place. No code can be asked to know more.
/// @param answer_to  gives the answer to a question, in more digits than double has
template <class S, class Answers>
double condition(FreeProblem const& p, FreePath<S> const& answer, Answers const& answer_to) {
  double sum = 0;
  auto const ask = [&](auto const& change) {
    FreeProblem moved = p;
    change(moved);
    sum += apart(answer_to(moved), answer, p.magnitude()).larger();
  };
  auto const up = [](double& x) { x = std::nextafter(x, 2 * x); };
  for (int i = 0; i < 3; ++i)
    ask([&](FreeProblem& m) { up(m.moments[i]); }), ask([&](FreeProblem& m) { up(m.momentum[i]); });
  ask([&](FreeProblem& m) { up(m.time); });
  return sum;
}
inline double condition(FreeProblem const& p, FreePath<long double> const& answer) {
  return condition(p, answer, [](FreeProblem const& moved) { return witness_of<long double>(moved, 20); });
}

/// The error of at(t) over (epsilon + what one unit in the last place of each number of the question does).
///
/// The series in 19 digits are quick, but next to the middle axis they too miss a component that starts below
/// 1e-19: where they find more than `enough`, 45 digits decide.
inline double units_off(FreeProblem const& p, FreePath<long double> const& answer, double enough) {
  constexpr double eps = std::numeric_limits<double>::epsilon();
  auto const found = path_of(p.body().at(p.time));
  double const quick = apart(answer, found, p.magnitude()).larger() / (eps + condition(p, answer));
  if (quick <= enough) return quick;
  auto const slow = [](FreeProblem const& question) { return witness_of<dec50>(question, 45); };
  auto const truth = slow(p);
  return apart(truth, found, p.magnitude()).larger() / (eps + condition(p, truth, slow));
}

/// What a motion should conserve: relative changes of |M|^2, of the energy, of the momentum in space, and of
/// the length of the quaternion; in 34 digits, which the compiler has.
struct ConservationErrors {
  double casimir, energy, spatial, length;
};
inline ConservationErrors conservation_errors(bodies::Three<double> const& moments,
                                              bodies::CompensatedState<double> const& now,
                                              bodies::FrameState<double> const& start) {
  using Quad = __float128;
  bodies::Three<Quad> u, from;
  bodies::Four<Quad> q;
  for (int i = 0; i < 3; ++i)
    u[i] = Quad(now.state.direction[i]) + now.compensation.direction[i], from[i] = start.direction[i];
  for (int i = 0; i < 4; ++i) q[i] = Quad(now.state.attitude[i]) + now.compensation.attitude[i];
  Quad energy = 0, before = 0, length = 0;
  for (int i = 0; i < 3; ++i) energy += u[i] * u[i] / moments[i], before += from[i] * from[i] / moments[i];
  for (int i = 0; i < 4; ++i) length += q[i] * q[i];
  bodies::Four<Quad> const in_space =
      bodies::compose(bodies::compose(q, bodies::Four<Quad>{0, u[0], u[1], u[2]}),
                      bodies::Four<Quad>{q[0], -q[1], -q[2], -q[3]});
  double spatial = 0;
  for (int i = 0; i < 3; ++i)
    spatial = std::max(spatial, std::abs(static_cast<double>(in_space[1 + i] / length - from[i])));
  return {std::abs(static_cast<double>(bodies::dot(u, u) / bodies::dot(from, from) - 1)),
          std::abs(static_cast<double>(energy / before - 1)), spatial,
          std::abs(static_cast<double>(length - 1))};
}
/// The same of what a motion gives away, from the attitude 1.
inline ConservationErrors conservation_errors(bodies::FreeSteps const& motion,
                                              bodies::Three<double> const& moments) {
  auto const now = path_of(motion.state()), start = path_of(motion.body().at(0));
  double const L = motion.body().magnitude();
  return conservation_errors(
      moments, {{{now.momentum[0] / L, now.momentum[1] / L, now.momentum[2] / L}, now.attitude}, {{}, {}}},
      {{start.momentum[0] / L, start.momentum[1] / L, start.momentum[2] / L}, start.attitude});
}

/// Problems at random, most of them nasty.
class HardProblems {
 public:
  explicit HardProblems(std::uint64_t seed) : random_(seed) {}

  /// @param longest  as the angle that the fastest component at the start would turn the body by; times are
  ///                 log-uniform from a thousandth
  FreeProblem next(double longest) {
    FreeProblem p;
    p.moments = draw_moments();
    p.momentum = draw_momentum(p.moments);
    p.time = sign() * std::exp(between(std::log(1e-3), std::log(longest))) / p.rate();
    return p;
  }

  double between(double a, double b) { return a + (b - a) * (random_() >> 11) * 0x1p-53; }
  double decades(double a, double b) { return std::pow(10.0, between(a, b)); }
  double sign() { return random_() & 1 ? 1 : -1; }

 private:
  using Triple = std::array<double, 3>;

  /// From second moments of the mass, which may be any: round, long, nearly symmetric, nearly spherical,
  /// flat, symmetric.
  Triple draw_moments() {
    Triple l;
    switch (random_() % 6) {
      case 0:
        l = {between(0.1, 1), between(0.1, 1), between(0.1, 1)};
        break;
      case 1:
        l = {decades(-6, 0), decades(-6, 0), decades(-6, 0)};
        break;
      case 2:
        l = {1, 1 + sign() * decades(-16, -1), decades(-6, 2)};
        break;
      case 3:
        l = {1, 1 + sign() * decades(-16, -1), 1 + sign() * decades(-16, -1)};
        break;
      case 4:
        l = {0, decades(-6, 0), 1};
        break;
      default:
        l = {1, between(0.1, 1), 0}, l[2] = l[1];
    }
    for (int i = 2; i > 0; --i) std::swap(l[i], l[random_() % (i + 1)]);
    return {l[1] + l[2], l[2] + l[0], l[0] + l[1]};
  }
  /// Anywhere; anywhere in the velocity; next to an axis; next to the separatrix.
  Triple draw_momentum(Triple const& I) {
    Triple m = {between(-1, 1), between(-1, 1), between(-1, 1)};
    switch (random_() % 4) {
      case 1:
        for (int i = 0; i < 3; ++i) m[i] *= I[i];
        break;
      case 2: {
        int const axis = static_cast<int>(random_() % 3);
        double const small = decades(-17, 0);
        for (int i = 0; i < 3; ++i)
          if (i != axis) m[i] *= small;
        break;
      }
      case 3: {
        std::array<int, 3> o = {0, 1, 2};
        std::sort(o.begin(), o.end(), [&](int a, int b) { return I[a] < I[b]; });
        double const x = std::sqrt((I[o[2]] - I[o[1]]) * I[o[0]]),
                     z = std::sqrt((I[o[1]] - I[o[0]]) * I[o[2]]), n = std::hypot(x, z),
                     phase = between(0, 6.3);
        m[o[0]] = sign() * (n > 0 ? x / n : 1) * std::sin(phase) * (1 + sign() * decades(-17, -1));
        m[o[1]] = std::cos(phase);
        m[o[2]] = (n > 0 ? z / n : 0) * std::sin(phase);
        break;
      }
      default:
        break;
    }
    return m;
  }

  std::mt19937_64 random_;
};

}  // namespace actio::testing
