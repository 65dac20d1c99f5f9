// Time against accuracy as a picture: one line for each method, the least time in which it reached so many
// digits, with its name beside the end of the line.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "book/plot.hpp"

namespace benchmark {

/// Lines of methods over the number of correct digits; ours are bold. A line of others is broken where its
/// colour comes again.
class DigitsPlot {
 public:
  /// @param digits  what the digits are of
  explicit DigitsPlot(std::string digits) : plot_(std::move(digits), "processor time, microseconds") {
    plot_.log_y().size(760, 460);
  }

  /// The line of a method.
  /// @param runs  each with `error` and `seconds`, in any order
  template <class Runs>
  DigitsPlot& line(Runs const& runs, std::string label, bool ours) {
    std::vector<std::pair<double, double>> found;
    for (auto const& run : runs)
      if (run.error > 0 && run.error < 0.1) found.push_back({-std::log10(run.error), 1e6 * run.seconds});
    // From the most digits to the fewest: a run counts where no more accurate one was faster.
    std::sort(found.begin(), found.end(), [](auto const& a, auto const& b) { return a.first > b.first; });
    std::vector<double> x, y;
    for (auto const& [digits, time] : found)
      if (y.empty() || time < y.back()) x.push_back(digits), y.push_back(time);
    if (x.empty()) return *this;
    // Fewer digits take no longer.
    if (x.back() > 2) x.push_back(2), y.push_back(y.back());
    std::reverse(x.begin(), x.end()), std::reverse(y.begin(), y.end());
    bool const again = !ours && others_ >= 4;
    int const colour = ours ? ours_++ % 2 + 1 : others_++ % 4 + 3;
    plot_.curve(x, y, std::move(label),
                {.colour = colour, .width = ours ? 3.2 : 1.4, .dashed = again, .named = true});
    return *this;
  }

  std::string svg() const { return plot_.svg(); }

 private:
  book::Plot plot_;
  int ours_ = 0, others_ = 0;
};

}  // namespace benchmark
