// The velocity of the fluid on the sphere, from its vorticity.
//
// The stream function solves Laplacian psi = vorticity, and u = r x grad psi: towards the east
// d psi/d theta, towards the north (1/sin theta) d psi/d phi. Both are computed times sin(theta), which are
// functions of finitely many harmonics, since sin(theta) dY_lm/d theta = l a_{l+1} Y_{l+1,m} - (l + 1) a_l
// Y_{l-1,m} with a_l = sqrt((l^2 - m^2)/(4 l^2 - 1)).
#pragma once

#include "actio/sphere_fields/sphere_transform.hpp"

namespace actio::sphere {

/// \f$\psi_{lm} = -f_{lm}/(l(l+1))\f$, with mean zero.
inline SphereHarmonics stream_function(SphereHarmonics f) {
  f.coefficient.row(0).setZero();
  for (int l = 1; l < f.degrees(); ++l) f.coefficient.row(l) /= -(l * (l + 1.0));
  return f;
}

/// What is seen of a flow on a grid.
struct FlowFields {
  GridField vorticity;       ///< 1/time
  GridField streamfunction;  ///< 1/time, on the unit sphere
  GridField east;            ///< the component of the velocity towards the east
  GridField north;           ///< towards the north
};

namespace detail {
/// \f$\partial_\varphi f\f$.
inline SphereHarmonics slope_eastwards(SphereHarmonics f) {
  for (int m = 0; m < f.degrees(); ++m) f.coefficient.col(m) *= std::complex<double>(0, m);
  return f;
}
/// The same with one degree more, whose coefficients are zero.
inline SphereHarmonics with_one_degree_more(SphereHarmonics const& f) {
  SphereHarmonics out(f.degrees() + 1);
  out.coefficient.topLeftCorner(f.degrees(), f.degrees()) = f.coefficient;
  return out;
}
}  // namespace detail

/// Vorticity, stream function and velocity on a grid without poles, in one pass.
/// @param vorticity  of the fluid; that of its mean does not flow
FlowFields flow_on(SphereGrid const& grid, SphereHarmonics const& vorticity);

}  // namespace actio::sphere
