// A medium of linear sound for the tests.
#pragma once

namespace actio::testing {

/// Pressure \f$-c^2(J-1)\f$: sound whose speed does not depend on its amplitude, where it moves along one
/// axis.
struct Acoustic {
  double c = 1;  ///< its speed where J = 1
  template <class T>
  T energy(T const& J) const { return (J - 1.0) * (J - 1.0) * (c * c / 2); }
  template <class T>
  T slope(T const& J) const { return (J - 1.0) * (c * c); }
};

}  // namespace actio::testing
