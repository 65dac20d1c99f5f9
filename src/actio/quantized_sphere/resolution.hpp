// What a matrix of size N resolves, said honestly.
//
// The commutator of matrices is the bracket of functions up to terms of the second order in 1/N, and how far
// it is off depends on the degrees: for two functions of the degrees l and l' by about l^2 l'^2/(6 N^2) of
// its size. All N - 1 integrals of the vorticity are kept, but the interaction of two scales with one another
// is that of the sphere only up to degrees of about the square root of N, far below N.
#pragma once

#include "actio/quantized_sphere/sphere_invariants.hpp"

namespace actio::sphere {

/// By how much the bracket of two functions of the degrees l and l' differs from that of the sphere, relative
/// to its size: about \f$l^2l'^2/(6N^2)\f$. At most 1, where nothing is right; good to a fifth up to 0.1.
inline double bracket_error(int n, double l, double other) {
  return std::min(1.0, std::pow(l * other / n, 2) / 6);
}
/// The degree whose bracket with itself has a given error: \f$(6\,\mathrm{error})^{1/4}\sqrt N\f$.
inline double degree_of_bracket_error(int n, double error) {
  return std::pow(6 * error, 0.25) * std::sqrt(n);
}
/// The degree at which Berezin's symbol has halved what the matrix has: \f$\sqrt{2N\log 2}\f$, about.
inline double symbol_cut_off(int n) { return std::sqrt(2 * std::log(2.0) * n); }

/// The resolution of one state. The degree 1, which turns as a whole and does so exactly, is left aside.
struct Resolution {
  int size;                   ///< N
  double energy_degree;       ///< the mean degree of the energy
  double enstrophy_degree;    ///< the mean degree of the enstrophy
  double error;               ///< of the bracket at the degree of the energy with itself
  double error_of_straining;  ///< of the bracket of the degree of the energy with that of the enstrophy
  double trusted_degree;      ///< the degree whose bracket with itself is good to a hundredth
  double lost_degree;         ///< the degree whose bracket with itself has nothing right
  double cut_off;             ///< the degree at which Berezin's symbol has halved
};

/// The resolution of a state by its relative vorticity.
/// @param vorticity  without that of the planet's rotation
Resolution resolution_of(SphereHarmonics const& vorticity);

}  // namespace actio::sphere
