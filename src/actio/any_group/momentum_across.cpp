#include <Eigen/Core>

#include "actio/any_group/momentum_across.hpp"

namespace actio::systems {

std::vector<double> momentum_across(MatrixAlgebra const& algebra, Side side, Eigen::MatrixXd const& g,
                                    Eigen::MatrixXd const& back, std::vector<double> const& p) {
  std::vector<double> out(p.size());
  Matrix<double> const moved =
      side == Side::left ? algebra.coadjoint<double>(back, g) : algebra.coadjoint<double>(g, back);
  for (std::size_t a = 0; a < p.size(); ++a)
    for (std::size_t c = 0; c < p.size(); ++c)
      out[a] += p[c] * moved(static_cast<Index>(a), static_cast<Index>(c));
  return out;
}

std::vector<double> frame_at(MatrixAlgebra const& algebra, Side side, Eigen::MatrixXd const& g,
                             Eigen::MatrixXd const& back) {
  Matrix<double> const moved =
      side == Side::left ? algebra.coadjoint<double>(g, back) : algebra.coadjoint<double>(back, g);
  return {moved.data(), moved.data() + moved.size()};
}

}  // namespace actio::systems
