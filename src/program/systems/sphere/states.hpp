// Flows on the sphere to begin with, as coefficients of their vorticity.
#pragma once

#include <functional>
#include <vector>

#include "actio/quantized_sphere/matrix_harmonics.hpp"

namespace actio::scene {

/// A rounded patch of vorticity: \f$s\,e^{-(1-\cos\gamma)/w^2}\f$ at the angle \f$\gamma\f$ from its centre.
struct Blob {
  double longitude;  ///< of the centre, radians
  double latitude;   ///< of the centre, radians
  double width;      ///< w > 0, radians
  double strength;   ///< s, the vorticity at the centre
};

/// Vorticity in one point.
struct PointVortex {
  double longitude;    ///< radians
  double latitude;     ///< radians
  double circulation;  ///< the integral of the vorticity
};

/// A jet towards the east (Galewsky, Scott and Polvani 2004): the velocity is
/// \f$u\,e^{4/(b-a)^2}e^{1/((\varphi-a)(\varphi-b))}\f$ between the latitudes a and b, and zero elsewhere.
struct ZonalJet {
  double speed;  ///< u, the largest velocity
  double south;  ///< a, radians
  double north;  ///< b > a, radians
  double
      perturbation;  ///< p, of the vorticity \f$p\cos\varphi\,e^{-(3\lambda)^2}e^{-(15(\varphi-\pi/4))^2}\f$
};

/// The coefficients of the jet up to degree N - 1.
sphere::SphereHarmonics zonal_jet(int n, ZonalJet const& jet);

/// The coefficients of the sum of the blobs up to degree N - 1, without its mean.
sphere::SphereHarmonics blobs(int n, std::vector<Blob> const& blobs);

/// Vortices as narrow as matrices have them, \f$-iW = \sum\Gamma\frac N{4\pi}|n\rangle\langle n|\f$ with the
/// coherent states of spin (N - 1)/2, without the mean.
sphere::SkewHermitian<> point_vortices(int n, std::vector<PointVortex> const& vortices);

/// Normally distributed coefficients of the degrees 1 to `last`.
/// @param weight  of each degree l: its energy is on average as large
sphere::SphereHarmonics random_flow(int n, int last, long seed, std::function<double(int l)> const& weight);

/// The coefficient of \f$Y_{54}\f$ in the vorticity \f$-30K\sin\varphi\cos^4\varphi\cos 4\lambda\f$
/// (Williamson et al. 1992, case 6).
double wave_4_coefficient(double amplitude);

/// That of \f$Y_{10}\f$ in \f$2a\sin\varphi\f$, the vorticity of a rotation with angular velocity a.
double rotation_coefficient(double rate);

}  // namespace actio::scene
