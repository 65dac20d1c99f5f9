// Work and precision of the generic implementation on one system: steps for a Lagrangian given as a callable,
// beside GSL, odeint, Runge-Kutta and Munthe-Kaas' methods on the same equations.
//
// The others get the right side of the differential equation, written by hand, and Munthe-Kaas' methods the
// group as well; the generic implementation gets the Lagrangian. The reference solution is Fehlberg's method
// in long double.
#pragma once

#include <gsl/gsl_errno.h>

#include "benchmark.hpp"
#include "digits_plot.hpp"
#include "error_against_time.hpp"
#include "peers/any_equation.hpp"
#include "peers/munthe_kaas.hpp"

namespace benchmark {

/// Of a system whose equations are not written as an action of a group.
struct NoMotion {};

/// A system of n numbers, compared in the m numbers that `show` makes of them.
template <std::size_t n, std::size_t m, class Rate, class Show, class Motion = NoMotion>
struct System {
  Rate rate;      ///< (y, out)
  Show show;      ///< what is compared, from the n numbers
  Motion motion;  ///< the same equations as an action of a group (\ref peers::munthe_kaas_steps)
  peers::Numbers<double, n> start;
  double stretch = 4;  ///< time from one comparison to the next
  static constexpr int looks = 5;
  std::vector<peers::Numbers<double, m>> exact = {};

  /// Finds the true states, and by how much they differ from those found in half as many steps.
  double find_reference() {
    double apart = 0;
    std::vector<peers::Numbers<double, m>> coarse;
    for (long steps : {2000, 4000}) {
      exact.clear();
      peers::Numbers<long double, n> y;
      for (std::size_t i = 0; i < n; ++i) y[i] = start[i];
      peers::odeint_steps<long double, n>(rate, y, static_cast<long double>(stretch), looks, steps,
                                          [&](int, auto const& at) {
                                            auto const shown = show(at);
                                            exact.emplace_back();
                                            for (std::size_t i = 0; i < m; ++i)
                                              exact.back()[i] = static_cast<double>(shown[i]);
                                          });
      if (!coarse.empty())
        for (int k = 0; k < looks; ++k) apart = std::max(apart, error(k + 1, coarse[k]));
      coarse = exact;
    }
    return apart;
  }
  /// The largest difference from the true state at the end of the k-th stretch.
  double error(int k, peers::Numbers<double, m> const& shown) const {
    double worst = 0;
    for (std::size_t i = 0; i < m; ++i) {
      double const off = std::abs(shown[i] - exact[k - 1][i]);
      worst = off <= worst ? worst : off;
    }
    return worst == worst ? worst : std::numeric_limits<double>::infinity();
  }
  /// The codes that one would take otherwise.
  std::vector<Way> others() const {
    auto const with = [this](auto const& run) {
      return [this, run](double setting) {
        double worst = 0;
        run(setting, [&](int k, auto const& y) { worst = std::max(worst, error(k, show(y))); });
        return worst;
      };
    };
    std::vector<Way> ways{
        {"GSL, Prince-Dormand 8(9), step control", with([this](double s, auto const& visit) {
           peers::gsl_controlled(rate, start, stretch, looks, std::pow(10.0, -s), visit);
         }),
         3, 1.06},
        {"odeint, Fehlberg 7(8), step control", with([this](double s, auto const& visit) {
           peers::odeint_controlled(rate, start, stretch, looks, std::pow(10.0, -s), visit);
         }),
         3, 1.06, "odeint, Fehlberg 7(8)"},
        {"odeint, Fehlberg 7(8)", with([this](double s, auto const& visit) {
           peers::odeint_steps<double, n>(rate, start, stretch, looks, std::lround(s), visit);
         }),
         4, 1.3},
        {"Runge-Kutta, order 4", with([this](double s, auto const& visit) {
           peers::runge_kutta_steps(rate, start, stretch, looks, std::lround(s), visit);
         }),
         16, 1.5}};
    if constexpr (!std::same_as<Motion, NoMotion>) {
      ways.push_back({"Munthe-Kaas, order 8", with([this](double s, auto const& visit) {
                        peers::munthe_kaas_steps<peers::FehlbergRows>(motion, start, stretch, looks,
                                                                      std::lround(s), visit);
                      }),
                      4, 1.3});
      ways.push_back({"Munthe-Kaas, order 4", with([this](double s, auto const& visit) {
                        peers::munthe_kaas_steps<peers::ClassicalRows>(motion, start, stretch, looks,
                                                                       std::lround(s), visit);
                      }),
                      16, 1.5});
    }
    return ways;
  }
};

/// A way of the generic implementation: `make(h)` gives a callable that takes a step of that length and
/// returns what is compared.
template <class S, class Make>
Way own_way(S const& system, std::string name, Make make, double first, double ratio) {
  return {std::move(name),
          [&system, make](double setting) {
            long const steps = std::lround(setting);
            auto step = make(system.stretch / static_cast<double>(steps));
            double worst = 0;
            for (int k = 1; k <= S::looks; ++k) {
              for (long i = 1; i < steps; ++i) step(false);
              worst = std::max(worst, system.error(k, step(true)));
            }
            return worst;
          },
          first, ratio};
}

/// Runs all, shows them, and claims what must be so.
/// @param ways  of the generic implementation; those behind the first are variational
template <class S>
int compare(Benchmark& program, S& system, std::vector<Way> ways) {
  gsl_set_error_handler_off();
  double const apart = system.find_reference();
  std::size_t const own = ways.size();
  for (Way& other : system.others()) ways.push_back(std::move(other));
  constexpr double targets[] = {1e-3, 1e-6, 1e-9, 1e-12};
  constexpr double never = std::numeric_limits<double>::infinity();
  std::vector<book::Program::Row> rows;
  std::vector<std::pair<std::string, std::vector<Timed>>> curves;
  double best_own[4] = {never, never, never, never}, best_other[4] = {never, never, never, never};
  for (std::size_t i = 0; i < ways.size(); ++i) {
    Line const line = runs_of(ways[i], program.length(0.03, 0.003));
    book::Program::Row row{line.name};
    for (int k = 0; k < 4; ++k) {
      Timed const* const best = line.cheapest(targets[k]);
      row.push_back(best ? book::number(1e6 * best->seconds) : "-");
      double& least = (i < own ? best_own : best_other)[k];
      if (best) least = std::min(least, best->seconds);
    }
    row.push_back(book::number(line.best_error(), 2));
    rows.push_back(row);
    // All but the first of ours are one curve: they preserve the bracket.
    std::string const name = ways[i].curve.empty() ? line.name : ways[i].curve,
                      curve = 0 < i && i < own ? "variational steps, the best of " + std::to_string(own - 1)
                                               : name;
    auto const known = std::ranges::find(curves, curve, &decltype(curves)::value_type::first);
    auto& runs =
        known != curves.end() ? known->second : curves.emplace_back(curve, std::vector<Timed>()).second;
    runs.insert(runs.end(), line.runs.begin(), line.runs.end());
  }
  DigitsPlot plot("correct digits");
  for (std::size_t i = 0; i < curves.size(); ++i) plot.line(curves[i].second, curves[i].first, i < 2);
  program.picture(
      "work_precision", plot.svg(),
      "Time for an accuracy; the generic implementation is bold, the others have equations written by hand.");
  program.table("work_precision", {"method", "1e-3", "1e-6", "1e-9", "1e-12", "best error"}, rows,
                "Microseconds to t = " + book::number(system.stretch * S::looks) +
                    ", set-up included, with the best step or tolerance for each error, the "
                    "largest at five times on the way.");
  program.figure("apart", apart, "the reference solution against itself in half as many steps");
  program.figure("own_us", 1e6 * best_own[2], "the best of the generic implementation to 1e-9, microseconds");
  program.figure("other_us", 1e6 * best_other[2], "the best of the others to 1e-9, microseconds");
  program.figure("times", best_own[2] / best_other[2],
                 "times as long by the generic implementation, to 1e-9");
  program.figure("times_12", best_own[3] / best_other[3], "the same to 1e-12");
  double size = 0;
  for (auto const& state : system.exact)
    for (double const x : state) size = std::max(size, std::abs(x));
  double const rounding = 4 * std::numeric_limits<double>::epsilon() * size;
  program.claim(apart <= rounding, "the reference solution is good to rounding, " + book::number(rounding) +
                                       "; measured " + book::number(apart));
  program.claim(std::isfinite(best_own[3]) && std::isfinite(best_other[3]),
                "the generic implementation and the others reach 1e-12");
  program.headline("to 1e-9 the generic implementation takes " + book::number(best_own[2] / best_other[2]) +
                       " times as long as the best of codes with equations written by hand",
                   best_own[2] / best_other[2]);
  return program.finish();
}

/// The rotation matrix of a quaternion, by rows.
template <class Q, class Out>
void write_rotation(Q const& q, Out out) {
  auto const e = q[0], a = q[1], b = q[2], c = q[3], n = e * e + a * a + b * b + c * c, s = 2 / n;
  out[0] = 1 - s * (b * b + c * c), out[1] = s * (a * b - e * c), out[2] = s * (a * c + e * b);
  out[3] = s * (a * b + e * c), out[4] = 1 - s * (a * a + c * c), out[5] = s * (b * c - e * a);
  out[6] = s * (a * c - e * b), out[7] = s * (b * c + e * a), out[8] = 1 - s * (a * a + b * b);
}
/// The rate of a quaternion that turns with twice the half velocity w.
template <class Q, class W, class Out>
void write_turning(Q const& q, W const& w, Out out) {
  out[0] = -(q[1] * w[0] + q[2] * w[1] + q[3] * w[2]);
  out[1] = q[0] * w[0] + q[2] * w[2] - q[3] * w[1];
  out[2] = q[0] * w[1] + q[3] * w[0] - q[1] * w[2];
  out[3] = q[0] * w[2] + q[1] * w[1] - q[2] * w[0];
}

}  // namespace benchmark
