// Broyden's formula: what one step of an iteration tells of the derivative.
#pragma once

#include <vector>

namespace actio::systems {

/// Improves the inverse B of a derivative by Broyden's ("good") formula, and the next step with it.
///
/// A step s = -B r from the residual r led to the residual r', from which the old inverse steps by u = -B r'.
/// The new inverse is the one with \f$B'(r'-r) = s\f$ that differs from B by the matrix
/// \f$u\,w^TB/(w\cdot s-w\cdot u)\f$ with \f$w = Ds\f$.
/// @param inverse  B, d x d, row by row; B' afterwards
/// @param step     s, the last step
/// @param weights  D, the positive weights of the components, which make them comparable
/// @param update   u = -B r'; -B' r' afterwards
/// @return whether anything was changed: not where the two steps are nearly the same, which tells nothing
bool broyden_update(std::vector<double>& inverse, std::vector<double> const& step,
                    std::vector<double> const& weights, std::vector<double>& update);

}  // namespace actio::systems
