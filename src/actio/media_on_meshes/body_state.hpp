// Where the nodes of a body are and how fast, with what rounding has taken from them.
#pragma once

#include <array>
#include <vector>

namespace actio::media {

/// Places and velocities of all nodes, component by component, with what rounding has taken from them.
///
/// A sum of many small steps forgets what lies below the last place; here that is carried along (Kahan), so
/// that momenta walk by the rounding of forces and not of places.
struct BodyState {
  std::vector<double> x;        ///< places, length
  std::vector<double> v;        ///< velocities, length/time
  std::vector<double> x_rest;   ///< what is to be added to x
  std::vector<double> v_rest;   ///< what is to be added to v
  std::vector<double> viscous;  ///< forces of viscosity; empty where there is none
  double dissipated = 0;        ///< the energy that they have taken

  /// \f$\sum mv\f$, mass x length/time.
  template <int d>
  std::array<double, d> momentum(std::vector<double> const& masses) const {
    std::array<double, d> sum{};
    for (std::size_t k = 0; k < v.size(); ++k) sum[k % d] += masses[k / d] * v[k];
    return sum;
  }
  /// \f$\sum m\,x\times v\f$, mass x area/time.
  template <int d>
  std::array<double, 3> angular_momentum(std::vector<double> const& masses) const {
    std::array<double, 3> sum{};
    for (std::size_t k = 0; k < masses.size(); ++k) {
      double place[3] = {}, rate[3] = {};
      for (int a = 0; a < d; ++a) place[a] = x[k * d + a], rate[a] = v[k * d + a];
      for (int a = 0; a < 3; ++a) {
        int const b = (a + 1) % 3, c = (a + 2) % 3;
        sum[a] += masses[k] * (place[b] * rate[c] - place[c] * rate[b]);
      }
    }
    return sum;
  }
};

namespace detail {
/// x + rest += y, x the nearest number.
inline void add_with_rest(double& x, double& rest, double y) {
  double const more = y + rest, sum = x + more, back = sum - x;
  rest = (x - (sum - back)) + (more - back);
  x = sum;
}
}  // namespace detail

}  // namespace actio::media
