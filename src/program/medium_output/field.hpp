// Fields of a medium, an object each: Jacobian, pressure, density, stored energy and stress at a point.
#pragma once

#include <functional>

#include "program/medium_output/motion.hpp"

namespace actio::scene {

/// A medium as its fields are computed.
template <int d>
struct MediumView {
  using Place = std::array<double, d>;                ///< a point, or a vector
  MediumMotion<d> const* motion = nullptr;            ///< what moves
  std::shared_ptr<media::StoredEnergy<d> const> law;  ///< of the material
  std::function<double(Place const&)> density;        ///< mass per reference volume at X
};

/// One deformation gradient of a cell.
template <int d>
struct PointOfCell {
  std::size_t cell;                                      ///< which cell
  int point;                                             ///< of the cell
  double volume;                                         ///< the reference volume that it stands for
  double density;                                        ///< mass per reference volume
  double weight;                                         ///< of W, per reference volume
  Matrix<double, d, d> F;                                ///< the deformation gradient
  Matrix<double, d, d> H;                                ///< that of the displacement, F - 1
  Matrix<double, d, d> inverse;                          ///< of the reference edges
  double jacobian;                                       ///< det F
  media::CornerCorrection<double, d> const* correction;  ///< of the corners of the cell
  double multiplier = 0;                                 ///< the pressure that keeps the volume of the cell
};

/// What a field is computed from at a point.
template <int d>
struct PointOfMedium {
  media::StoredEnergy<d> const& law;  ///< of the material
  PointOfCell<d> const& point;        ///< where
  Matrix<double, d, d> stress;        ///< Cauchy's, where a field that is asked for needs it
};

/// A field that snapshots can hold.
template <int d>
struct MediumField {
  std::string name;                                     ///< as scenes and files have it
  std::string meaning;                                  ///< in a few words
  std::string unit;                                     ///< as \ref Units reads it
  bool needs_stress;                                    ///< it is computed from Cauchy's stress
  void (*write)(PointOfMedium<d> const&, double* out);  ///< its numbers at a point
  std::vector<std::string> components = {};             ///< names of its numbers, where it has several
  bool of_solids = false;                               ///< fluids do not have it

  /// How many numbers it has.
  std::size_t width() const { return components.empty() ? 1 : components.size(); }
};
/// Several of them.
template <int d>
using MediumFields = std::vector<MediumField<d>>;

/// All that there are, in their order.
/// @param dimension  of the cells, for units
template <int d>
MediumFields<d> medium_fields(int dimension = d);
/// Those of these names, which are known, in the order of the names.
/// \copydetails medium_fields
template <int d>
MediumFields<d> fields_named(std::vector<std::string> const& names, int dimension = d);
/// How many numbers they have together.
template <int d>
std::size_t field_size(MediumFields<d> const& fields) {
  std::size_t size = 0;
  for (auto const& field : fields) size += field.width();
  return size;
}

}  // namespace actio::scene
