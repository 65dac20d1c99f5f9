// The media of scenes that the optimised implementation steps: of each material the optimised form that it
// has.
#pragma once

#include <cmath>

#include "program/systems/media/fast_motion.hpp"

namespace actio::scene {

/// A box of cells of one density, as materials are asked for their optimised forms on it.
template <class Box>
struct OptimisedForms {
  using Form = std::unique_ptr<OptimisedMedium<Box::dimension>>;  ///< of a medium on the box
  Box const& box;                                                 ///< the cells
  double density;                                                 ///< mass per reference volume

  /// Of this medium.
  template <class Medium>
  Form operator()(Medium const& medium) const { return optimised_medium_of(medium, box, density); }
  /// Of a material that has no such form with its numbers.
  Form none() const { return nullptr; }
  /// Whether a power gamma of the volume of a cell is far from the ends of double precision, whatever the
  /// cell is compressed or stretched to by a factor of sixteen.
  bool has_power(double gamma) const { return gamma * (std::abs(std::log2(box.measure())) + 4) < 900; }
};

/// Of a material; null where it has no optimised form.
template <class Box>
typename OptimisedForms<Box>::Form optimised_medium_on(Material const& material, Box const& box,
                                                       double density) {
  OptimisedForms<Box> const forms{box, density};
  return std::visit(
      [&](auto const& own) -> typename OptimisedForms<Box>::Form {
        if constexpr (requires { own.fast(forms); })
          return own.fast(forms);
        else
          return nullptr;
      },
      material);
}

}  // namespace actio::scene
