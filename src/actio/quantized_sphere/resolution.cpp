#include <Eigen/Core>

#include "actio/quantized_sphere/resolution.hpp"

namespace actio::sphere {

Resolution resolution_of(SphereHarmonics const& vorticity) {
  int const n = vorticity.degrees();
  Eigen::VectorXd const energy = energy_by_degree(vorticity);
  double all = 0, of_energy = 0, square = 0, of_enstrophy = 0;
  for (int l = 2; l < n; ++l) {
    all += energy[l], of_energy += l * energy[l];
    square += vorticity.power(l), of_enstrophy += l * vorticity.power(l);
  }
  Resolution told{};
  told.size = n;
  told.energy_degree = all > 0 ? of_energy / all : 0,
  told.enstrophy_degree = square > 0 ? of_enstrophy / square : 0;
  told.error = bracket_error(n, told.energy_degree, told.energy_degree);
  told.error_of_straining = bracket_error(n, told.energy_degree, told.enstrophy_degree);
  told.trusted_degree = degree_of_bracket_error(n, 0.01), told.lost_degree = degree_of_bracket_error(n, 1);
  told.cut_off = symbol_cut_off(n);
  return told;
}

}  // namespace actio::sphere
