#include "program/systems/sphere/memory.hpp"

#include <algorithm>

#include "program/base/memory.hpp"

namespace actio::scene {

double bytes_for_vorticity(int n, std::size_t substeps, sphere::Conserved conserved, bool to_rounding,
                           std::vector<std::string> const& quantities) {
  bool const poisson = conserved == sphere::Conserved::lie_poisson;
  // The state and a copy for a row between steps, the Laplacian, the start, and what a step has on the way.
  double count = 4 + 2 + 2 + 10;
  // Each substep: products, unknowns and what they are made of, directions, and steps to guess from, five, or
  // eight halves of two matrices; matrices of single precision count for half.
  bool const all = conserved == sphere::Conserved::all_invariants;
  double const before = to_rounding ? 5 * (poisson ? 2 : 4) : (poisson ? 8 : 5) * 2;
  double const plain = 5 + 14 + (all ? 6 : 0);
  count += static_cast<double>(substeps) * ((to_rounding ? plain : 18 + 5 + 16) + before);
  // A step that cannot be found in single precision is made by another one.
  if (!to_rounding) count += plain + 2;
  // A checkpoint holds half of each skew matrix, and is there twice while it is written.
  count += 2 * (1 + static_cast<double>(substeps) * (to_rounding ? before / 2 : before));
  // One quantity is evaluated after the other.
  double most = 2;
  for (auto const& [name, matrices] : {std::pair("casimirs", 14),
                                       {"eigenvalues", 6},
                                       {"extrema", 6},
                                       {"histogram", 6},
                                       {"spectrum", 4},
                                       {"velocity_spectrum", 4},
                                       {"splitting", 24}})
    if (std::find(quantities.begin(), quantities.end(), name) != quantities.end())
      most = std::max<double>(most, matrices);
  count += most;
  double const blas = 30e6;  // OpenBLAS and its buffers: 20 MB as measured, others on other processors
  return bytes_of_program + blas + count * sizeof(double) * n * n;
}

}  // namespace actio::scene
