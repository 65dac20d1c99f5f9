// A covector of an algebra of matrices on the other side: from the body to space, or back.
#pragma once

#include <Eigen/Core>

#include <vector>

#include "actio/any_group/reduced_system.hpp"

namespace actio::systems {

/// \f$\mathrm{Ad}^*_{g^{-1}}p\f$ of a covector of the body on the left, \f$\mathrm{Ad}^*_g\,p\f$ of one in
/// space on the right: in the components of the velocity on the other side.
/// @param side  on which p is
/// @param g     configuration
/// @param back  its inverse
std::vector<double> momentum_across(MatrixAlgebra const& algebra, Side side, Eigen::MatrixXd const& g,
                                    Eigen::MatrixXd const& back, std::vector<double> const& p);

/// The way back, as `ReducedPoint::frame` has it: \f$\mathrm{Ad}^*_g\f$ on the left, which makes covectors in
/// space those of the body, and \f$\mathrm{Ad}^*_{g^{-1}}\f$ on the right, one column after the other.
/// @param side  on which the covectors are then
/// @param g     configuration
/// @param back  its inverse
std::vector<double> frame_at(MatrixAlgebra const& algebra, Side side, Eigen::MatrixXd const& g,
                             Eigen::MatrixXd const& back);

}  // namespace actio::systems
