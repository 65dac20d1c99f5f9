#include "actio/fast_body/any_dimension/anderson.hpp"

namespace actio::bodies {

void Anderson::mix(std::vector<double>& x, std::vector<double> const& residual) {
  if (!last_x_.empty()) {
    if (steps_.size() == memory_) steps_.erase(steps_.begin()), changes_.erase(changes_.begin());
    steps_.push_back(difference(x, last_x_)), changes_.push_back(difference(residual, last_residual_));
  }
  last_x_ = x, last_residual_ = residual;
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += residual[i] / 2;

  // Newest first: what it spans need not be spanned again by older ones. Steps are combined as the changes
  // are.
  std::vector<std::vector<double>> basis, moves;
  for (std::size_t k = steps_.size(); k-- > 0;) {
    auto q = changes_[k], s = steps_[k];
    for (std::size_t i = 0; i < s.size(); ++i) s[i] += q[i] / 2;
    double const before = norm(q);
    for (int twice = 0; twice < 2; ++twice)
      for (std::size_t b = 0; b < basis.size(); ++b) {
        double const part = dot(basis[b], q);
        subtract(q, part, basis[b]), subtract(s, part, moves[b]);
      }
    double const left = norm(q);
    if (!(left > 1e-10 * before)) continue;
    for (std::size_t i = 0; i < q.size(); ++i) q[i] /= left, s[i] /= left;
    subtract(x, dot(q, residual), s);
    basis.push_back(std::move(q)), moves.push_back(std::move(s));
  }
}

}  // namespace actio::bodies
