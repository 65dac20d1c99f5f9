#include <Eigen/Core>

#include "actio/any_group/momentum_across.hpp"

namespace actio::systems {

std::vector<double> momentum_across(MatrixAlgebra const& algebra, Side side, Eigen::MatrixXd const& g,
                                    Eigen::MatrixXd const& back, std::vector<double> const& p) {
  std::vector<double> out(p.size());
  for (std::size_t a = 0; a < p.size(); ++a) {
    auto const& e = algebra.basis[a];
    auto const moved = algebra.vee(Matrix<double>(side == Side::left ? back * e * g : g * e * back));
    for (std::size_t c = 0; c < p.size(); ++c) out[a] += p[c] * moved[static_cast<Index>(c)];
  }
  return out;
}

}  // namespace actio::systems
