#include "actio/rods/rod_section.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "actio/numbers/errors.hpp"

namespace actio::rods {
namespace {

void require_positive(char const* what, double value) {
  if (!(value > 0 && std::isfinite(value)))
    throw OutsideDomain("rod", std::string(what) + " must be a positive number; it", value, 0);
}

}  // namespace

RodSection RodSection::circular(double radius, double young, double poisson, double density, double shear) {
  require_positive("the radius of the section", radius);
  require_positive("Young's modulus", young);
  require_positive("the density", density);
  if (!(poisson > -1 && poisson <= 0.5))
    throw OutsideDomain("rod", "Poisson's ratio lies between -1 and 1/2; it", poisson, 0.5);
  double const area = std::numbers::pi * radius * radius, second = area * radius * radius / 4,
               G = young / (2 * (1 + poisson));
  RodSection const out{{young * area, shear * G * area, shear * G * area},
                       {2 * G * second, young * second, young * second},
                       density * area,
                       {2 * density * second, density * second, density * second}};
  out.examine();
  return out;
}

void RodSection::examine() const {
  static constexpr char const* along[] = {"EA", "GA2", "GA3"};
  static constexpr char const* about[] = {"GJ", "EI2", "EI3"};
  static constexpr char const* turned[] = {"rJ", "rI2", "rI3"};
  for (std::size_t i = 0; i < 3; ++i)
    if (!(stretching[i] > 0))
      throw OutsideDomain("rod",
                          std::string(along[i]) +
                              " must be a positive number; for a rod without stretch and shear there is the "
                              "constraint. It",
                          stretching[i], 0);
  for (std::size_t i = 0; i < 3; ++i) require_positive(along[i], stretching[i]);
  for (std::size_t i = 0; i < 3; ++i) require_positive(about[i], bending[i]);
  require_positive("the mass per length", mass);
  for (std::size_t i = 0; i < 3; ++i) require_positive(turned[i], inertia[i]);
  double const largest = *std::ranges::max_element(inertia),
               excess = 2 * largest - inertia[0] - inertia[1] - inertia[2];
  if (!(excess <= 1e-14 * largest))
    throw OutsideDomain("rod",
                        "no section has a moment of inertia beyond the sum of the other two (triangle "
                        "inequality); the excess",
                        excess, 0);
}

}  // namespace actio::rods
