// Broyden's formula: what one step of an iteration tells of the derivative.
#pragma once

#include <vector>

namespace actio {

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
inline bool broyden_update(std::vector<double>& inverse, std::vector<double> const& step,
                           std::vector<double> const& weights, std::vector<double>& update) {
  auto const d = step.size();
  double square = 0, together = 0;
  for (std::size_t i = 0; i < d; ++i) {
    double const weighted = step[i] * weights[i];
    square += weighted * step[i], together += weighted * update[i];
  }
  double const rest = square - together;
  if (!(rest > square / 2)) return false;
  for (std::size_t j = 0; j < d; ++j) {
    double along = 0;
    for (std::size_t i = 0; i < d; ++i) along += step[i] * weights[i] * inverse[i * d + j];
    along /= rest;
    for (std::size_t i = 0; i < d; ++i) inverse[i * d + j] += update[i] * along;
  }
  for (double& u : update) u *= square / rest;
  return true;
}

}  // namespace actio
