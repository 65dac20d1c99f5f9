#include "actio/quantized_torus/torus_invariants.hpp"

namespace actio::torus {

double flow_energy(TorusStream const& stream, sphere::SkewHermitian<> const& w) {
  return -0.5 * QuantizedTorus(stream.size()).area_element() * sphere::inner_product(stream.solve(w), w);
}

double flow_enstrophy(sphere::SkewHermitian<> const& w) {
  double const size = sphere::norm(w);
  return 0.5 * QuantizedTorus(static_cast<int>(w.size())).area_element() * size * size;
}

Eigen::VectorXd energy_by_ring(TorusHarmonics const& vorticity, double gamma) {
  QuantizedTorus const torus(vorticity.size());
  int const most = torus.largest();
  Eigen::VectorXd energy = Eigen::VectorXd::Zero(std::lround(std::hypot(most, most)) + 1);
  for (int m = -most; m <= most; ++m)
    for (int n = 0; n <= most; ++n)
      if (m != 0 || n != 0)
        energy[std::lround(std::hypot(m, n))] += (n == 0 ? 1 : 2) * 2 * M_PI * M_PI *
                                                 std::norm(vorticity(m, n)) /
                                                 (gamma - torus.eigenvalue(m, n));
  return energy;
}

TorusHarmonics stream_function(TorusHarmonics const& vorticity, double gamma) {
  QuantizedTorus const torus(vorticity.size());
  return scaled(vorticity,
                [&](int m, int n) { return m == 0 && n == 0 ? 0 : 1 / (torus.eigenvalue(m, n) - gamma); });
}

FlowFields flow_on_grid(TorusHarmonics const& vorticity, double gamma, int points) {
  TorusHarmonics const psi = stream_function(vorticity, gamma);
  std::complex<double> const i(0, 1);
  return {values_on_grid(vorticity, points), values_on_grid(psi, points),
          values_on_grid(scaled(psi, [&](int, int n) { return -i * static_cast<double>(n); }), points),
          values_on_grid(scaled(psi, [&](int m, int) { return i * static_cast<double>(m); }), points)};
}

}  // namespace actio::torus
