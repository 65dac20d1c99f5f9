// The solutions of the last steps, and what they say of the next one.
#pragma once

#include <array>
#include <vector>

namespace actio::systems {

/// Extrapolates solutions of equal steps by the polynomial that would have been best for the last one.
class SolutionHistory {
 public:
  bool empty() const { return past_ == 0; }                        ///< whether there is no step yet
  std::vector<double> const& last() const { return history_[0]; }  ///< the last solution
  void clear() { past_ = 0; }                                      ///< forgets them all
  /// Sets a list to what is expected of the next step.
  void predict(std::vector<double>& next) const { extrapolate(points_, 0, next); }
  /// Takes the solution of a step.
  void remember(std::vector<double> const& solution);

  /// Saves, or restores, what the next steps depend on, of solutions as long as the list.
  template <class Stream>
  void store(Stream& stream, std::size_t length) {
    stream(past_, points_, steps_);
    for (auto& old : history_) {
      old.resize(length);
      stream(old);
    }
  }

 private:
  static constexpr int longest_ = 8;

  /// What the polynomial through so many solutions, the first of them `from` steps ago, says of the next
  /// one.
  void extrapolate(int points, int from, std::vector<double>& out) const;
  /// The number of points that would have been best for the last solution.
  void choose_points();

  std::array<std::vector<double>, longest_> history_;
  int past_ = 0, points_ = 1;
  long steps_ = 0;
};

}  // namespace actio::systems
