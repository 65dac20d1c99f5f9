// The shape of a rod: where its sections are, and what its elements are at rest.
#pragma once

#include <functional>
#include <vector>

#include "actio/rods/rod_element.hpp"

namespace actio::rods {

/// The sections of a rod at equal distances, from its start to its end.
struct RodShape {
  std::vector<Three<double>> places;    ///< of the centres of mass, length
  std::vector<Four<double>> attitudes;  ///< from the axes of the sections to space, unit quaternions
  bool closed = false;                  ///< whether the last section is followed by the first one

  /// What a rod is bent and stretched by, at a distance s from its start along the rod.
  using Strain = std::function<Three<double>(double s)>;

  /// How many sections there are.
  std::size_t sections() const { return places.size(); }
  /// How many elements: as many in a ring, otherwise one less.
  std::size_t elements() const { return places.size() - (closed ? 0 : 1); }
  /// The section after an element.
  std::size_t after(std::size_t element) const { return element + 1 == places.size() ? 0 : element + 1; }
  /// The relative placement of the sections at the ends of an element.
  RelativePlacement<double> element(std::size_t k) const;

  /// The shape with these strains in the middle of its elements, put together from its start on.
  ///
  /// \snippet bodies.cpp rod_shape
  /// @param length    of the rod
  /// @param elements  how many, two or more
  /// @param place     of the first section
  /// @param attitude  of the first section; its first axis points along the rod
  /// @param kappa     twist and bends, 1/length; null: none
  /// @param Gamma     stretch and shears; null: (1, 0, 0)
  /// @throws OutsideDomain  where there are too few elements, or one would turn by more than a right angle
  static RodShape of_strains(double length, int elements, Three<double> const& place,
                             Four<double> const& attitude, Strain const& kappa = nullptr,
                             Strain const& Gamma = nullptr);
  /// Sections along a curve, whose axes turn about the curve no more than they must.
  /// @param at       place and tangent for a parameter from 0 to 1, by equal parts of it
  /// @param across   a direction that the second axis of the first section is near; not along the tangent
  /// @param closed   whether the curve is; the axes at its end are turned back to those at its start, by
  ///                 equal parts on the way
  /// @throws OutsideDomain  where there are too few elements, or a tangent vanishes or turns too much
  static RodShape along(std::function<std::pair<Three<double>, Three<double>>(double)> const& at,
                        int elements, Three<double> const& across, bool closed);
};

/// What the elements of a shape are at rest where the shape is: \f$\Gamma_0\f$ and \f$\kappa_0\f$ by the same
/// formulas as later strains, and the length with which \f$|\Gamma_0|=1\f$.
std::vector<ElementAtRest<double>> elements_at_rest(RodShape const& shape);

/// The largest twice tangent of half an angle by which an element may turn: a right angle.
inline constexpr double largest_turn = 2;

}  // namespace actio::rods
