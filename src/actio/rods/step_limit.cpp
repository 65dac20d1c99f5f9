#include "actio/rods/step_limit.hpp"

#include <cmath>

#include "actio/numbers/errors.hpp"

namespace actio::rods {
namespace {

double square(double x) { return x * x; }

RodWaves waves_of(RodConstants const& rod) {
  double shortest = HUGE_VAL;
  for (std::size_t k = 0; k < rod.elements; ++k) shortest = std::min(shortest, 1 / rod.inverse_length[k]);
  return {rod.section, shortest};
}

}  // namespace

std::array<double, 2> RodWaves::bending(int axis, double k) const {
  // Bending about axis 2 goes with shear along axis 3.
  auto const i = static_cast<std::size_t>(axis - 1), j = static_cast<std::size_t>(axis == 2 ? 2 : 1);
  double const GA = section.stretching[j], EI = section.bending[i], rA = section.mass,
               rI = section.inertia[i], K2 = square(2 / length * std::sin(k * length / 2)),
               c2 = square(std::cos(k * length / 2));
  // x^2 - (a + b) x + a b - d = 0 with x = Omega^2
  double const a = GA * K2 / rA, b = (EI * K2 + GA * c2) / rI, d = square(GA) * K2 * c2 / (rA * rI),
               upper = (a + b) / 2 + std::sqrt(square((a - b) / 2) + d);
  // a b - d = GA EI K^4/(rA rI), without the difference.
  return {upper > 0 ? GA * EI * square(K2) / (rA * rI) / upper : 0, upper};
}
double RodWaves::stretching(double k) const {
  return section.stretching[0] * square(2 / length * std::sin(k * length / 2)) / section.mass;
}
double RodWaves::twisting(double k) const {
  return section.bending[0] * square(2 / length * std::sin(k * length / 2)) / section.inertia[0];
}

RodWaves::Fastest RodWaves::fastest(bool unshearable) const {
  Fastest out{0, ""};
  auto const see = [&](double squared, char const* what) {
    if (std::sqrt(squared) > out.omega) out = {std::sqrt(squared), what};
  };
  double const shortest = M_PI / length;
  see(twisting(shortest), "twist, D sqrt(rJ/GJ)");
  for (int const axis : {2, 3}) {
    auto const i = static_cast<std::size_t>(axis - 1);
    if (unshearable) {
      see(4 / square(length) * section.bending[i] / section.inertia[i], "bending, D sqrt(rI/EI)");
      continue;
    }
    for (int part = 0; part <= 64; ++part) {
      double const upper = bending(axis, shortest * part / 64)[1];
      see(upper, part < 32 ? "shear that turns the sections, 2 sqrt(rI/GA)"
                           : "bending and shear, D sqrt(rI/EI) or D sqrt(rA/GA)");
    }
  }
  if (!unshearable) see(stretching(shortest), "stretch, D sqrt(rA/EA)");
  return out;
}

double longest_rod_step(RodConstants const& rod, bool unshearable) {
  return 2 / waves_of(rod).fastest(unshearable).omega;
}

void require_stable_step(RodConstants const& rod, double step, bool unshearable) {
  auto const fastest = waves_of(rod).fastest(unshearable);
  if (double const longest = 2 / fastest.omega; !(step <= longest))
    throw OutsideDomain(
        "rod", std::string("steps are not stable; the longest one is bound by ") + fastest.what + "; step",
        step, longest);
}

}  // namespace actio::rods
