// How strongly the cells of a box are deformed, and how fast, at their worst.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "actio/fast_media/fast_box_2d.hpp"
#include "actio/fast_media/fast_box_3d.hpp"
#include "actio/parallel/ranks.hpp"

namespace actio::media {

/// The largest of all corners of all cells. No digit depends on the order in which they are looked at.
struct Strains {
  double squeeze = 0;  ///< \f$|F^{-1}|^2\f$, sum of squares
  double stretch = 0;  ///< \f$|F|^2\f$
  double rate = 0;  ///< \f$|D|^2\f$, D the symmetric part of \f$\dot FF^{-1}\f$; of first corners; 1/time^2

  /// Those of both together.
  Strains with(Strains const& other) const {
    return {std::max(squeeze, other.squeeze), std::max(stretch, other.stretch), std::max(rate, other.rate)};
  }
};

namespace detail {

/// Rows of nodes, in layers in space, with the cells between them.
/// @tparam Vector  `Plane<Quad>` or `Space<Quad>`
template <class Vector>
struct RowsOfCells {
  Vector const* const* x;  ///< places of the rows
  Vector const* const* v;  ///< their velocities
  int across;              ///< rows of a layer of nodes, all of them in the plane
  int layers;              ///< of cells; 1 in the plane
};
/// Their strains.
Strains strains_of(RowsOfCells<Plane<Quad>> const& rows, Strips const& strips,
                   std::array<double, 2> const& spacing, Registers registers);
/// \copydoc strains_of
Strains strains_of(RowsOfCells<Space<Quad>> const& rows, Strips const& strips,
                   std::array<double, 3> const& spacing, Registers registers);

/// The largest that all bands of all ranks have seen.
template <class Band>
Strains largest_strains(std::vector<Band> const& bands, HaloRows const& halo) {
  Strains most;
  for (Band const& band : bands) most = most.with(band.strains);
  if (!halo.alone())
    for (Strains const& one : all_of(halo.ranks(), most)) most = most.with(one);
  return most;
}
/// Whether none of them has set a sign.
template <class Band>
bool all_sound(std::vector<Band> const& bands, HaloRows const& halo) {
  bool bad = false;
  for (Band const& band : bands) bad = bad || any_sign(band.signs);
  return !(halo.alone() ? bad : halo.ranks().any(bad));
}

}  // namespace detail
}  // namespace actio::media
