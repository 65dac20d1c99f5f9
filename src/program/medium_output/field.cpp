#include "program/medium_output/field.hpp"

namespace actio::scene {
namespace {

/// "xx", "xy", "yy".
std::vector<std::string> symmetric_components(int d) {
  std::vector<std::string> out;
  for (int a = 0; a < d; ++a)
    for (int b = a; b < d; ++b) out.push_back({"xyz"[a], "xyz"[b]});
  return out;
}

}  // namespace

template <int d>
MediumFields<d> medium_fields(int dimension) {
  using At = PointOfMedium<d>;
  std::string const per_volume = dimension == 1 ? "/length" : "/length^" + std::to_string(dimension);
  return {
      {"jacobian", "J, the volume over that of the reference", "1", false,
       [](At const& at, double* out) { *out = at.point.jacobian; }},
      {"pressure", "minus a d-th of the trace of Cauchy's stress", "energy" + per_volume, true,
       [](At const& at, double* out) {
         double trace = 0;
         for (int a = 0; a < d; ++a) trace += at.stress(a, a);
         *out = -trace / d;
       }},
      {"density", "mass per volume in space", "mass" + per_volume, false,
       [](At const& at, double* out) { *out = at.point.density / at.point.jacobian; }},
      {"energy_density", "stored energy per reference volume", "energy" + per_volume, false,
       [](At const& at, double* out) { *out = at.point.weight * at.law.energy_beyond(at.point.H); }},
      {"stress", "Cauchy's, its components xx, xy, yy or xx, xy, xz, yy, yz, zz", "energy" + per_volume, true,
       [](At const& at, double* out) {
         for (int a = 0; a < d; ++a)
           for (int b = a; b < d; ++b) *out++ = at.stress(a, b);
       },
       symmetric_components(d), true},
  };
}

template <int d>
MediumFields<d> fields_named(std::vector<std::string> const& names, int dimension) {
  MediumFields<d> out;
  for (auto const& name : names)
    for (auto const& field : medium_fields<d>(dimension))
      if (field.name == name) out.push_back(field);
  return out;
}

/// Along a line.
template MediumFields<1> medium_fields<1>(int);
/// In the plane.
template MediumFields<2> medium_fields<2>(int);
/// In space.
template MediumFields<3> medium_fields<3>(int);
/// Along a line.
template MediumFields<1> fields_named<1>(std::vector<std::string> const&, int);
/// In the plane.
template MediumFields<2> fields_named<2>(std::vector<std::string> const&, int);
/// In space.
template MediumFields<3> fields_named<3>(std::vector<std::string> const&, int);

}  // namespace actio::scene
