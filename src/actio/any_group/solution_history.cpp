#include "actio/any_group/solution_history.hpp"

#include <algorithm>
#include <cmath>

namespace actio::systems {

void SolutionHistory::extrapolate(int points, int from, std::vector<double>& out) const {
  std::fill(out.begin(), out.end(), 0.0);
  double weight = points;  // binomial coefficients with changing signs
  for (int k = 0; k < points; ++k) {
    auto const& old = history_[static_cast<std::size_t>(from + k)];
    for (std::size_t i = 0; i < out.size(); ++i) out[i] += weight * old[i];
    weight *= -static_cast<double>(points - k - 1) / (k + 2);
  }
}

void SolutionHistory::remember(std::vector<double> const& solution) {
  std::rotate(history_.begin(), history_.end() - 1, history_.end());
  history_[0] = solution;
  bool const growing = past_ < longest_;
  past_ = std::min(past_ + 1, longest_);
  if (growing || ++steps_ % 64 == 0) choose_points();
}

void SolutionHistory::choose_points() {
  std::vector<double> guess(history_[0].size());
  double best = HUGE_VAL;
  for (int points = 1; points < past_; ++points) {
    extrapolate(points, 1, guess);
    double missed = 0;
    for (std::size_t i = 0; i < guess.size(); ++i)
      missed = std::max(missed, std::abs(guess[i] - history_[0][i]));
    if (missed < best) best = missed, points_ = points;
  }
  points_ = std::clamp(points_, 1, past_);
}

}  // namespace actio::systems
