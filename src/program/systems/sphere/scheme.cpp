#include "program/systems/sphere/scheme.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "program/registry/companion.hpp"
#include "program/systems/method_input.hpp"

namespace actio::scene {
namespace {

/// The longest step, up to this one, of which the first eight can be made; zero where none was found.
double longest_step(MakeStepped const& make, double step) {
  double h = step;
  for (int k = 0; k < 40; ++k) try {
      make(h)->advance(8);
      return h;
    } catch (sphere::NotContracting const& error) {
      h = error.largest > 0 ? std::min(0.8 * h, error.largest) : 0.5 * h;
    }
  return 0;
}

}  // namespace

double SphereScheme::longest() const {
  double longest = 0;
  for (double const fraction : fractions) longest = std::max(longest, std::abs(fraction));
  return longest;
}

double step_of_scheme(SceneTable const& method, Schedule const& schedule, double fastest,
                      SphereScheme const& scheme, MakeStepped const& make) {
  double const step = read_step(method, schedule, fastest, 0.2);
  // Up to here the iteration is known to contract from its first guess.
  if (fastest * step * scheme.longest() <= 0.3) return step;
  try {
    make(step)->advance(4);
  } catch (sphere::NotContracting const& error) {
    std::string const what = fmt::format("the iteration of a step of length {} does not contract", step);
    double const longest =
        longest_step(make, error.largest > 0 ? std::min(0.8 * step, error.largest) : 0.8 * step);
    if (longest == 0) throw NumericsError(method.place("step").text() + ": step: " + what);
    fail_for_long_step(method, schedule, StepTooLong("vorticity", step, longest), what);
  }
  return step;
}

Companion companion_of_scheme(MakeStepped const& make, int order, double step, std::optional<bool> wanted) {
  if (!wanted.value_or(false))
    return {nullptr, 0, 0, false,
            "not estimated: it costs more than a third of the run; output.error_estimate = true asks for it"};
  Companion out = companions(
      [&](long multiple) {
        double const longer = static_cast<double>(multiple) * step;
        make(longer)->advance(2);  // so long a step may be beyond the iteration
        return make(longer);
      },
      {4, 3, 2}, order, false);
  out.momentum = "vorticity";
  return out;
}

long steps_in_5_ms(int n, std::size_t substeps) {
  double const cube = std::pow(n, 3), square = std::pow(n, 2);
  double const seconds = static_cast<double>(substeps) * (3e-8 * cube + 4e-7 * square + 1e-5);
  return std::max(1L, static_cast<long>(5e-3 / seconds));
}

}  // namespace actio::scene
