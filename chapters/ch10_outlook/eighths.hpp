// A number through a long run, in eighths of the run: mean and standard deviation in each, and whether the
// means have a trend.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "book/program.hpp"

// The first eighth is left out of what is said of the whole, since the run settles there.
struct Eighths {
  std::array<double, 8> mean{}, deviation{};
  double oscillation = 0;  // the mean of the deviations
  double trend = 0;        // of the means, for an eighth: the slope of the line of least squares
  double uncertainty = 0;  // its standard error, from the distances of the means from the line

  // From samples at equal times.
  explicit Eighths(std::vector<double> const& samples) {
    std::size_t const count = samples.size() / 8;
    for (std::size_t k = 0; k < 8; ++k) {
      for (std::size_t i = k * count; i < (k + 1) * count; ++i)
        mean[k] += samples[i] / static_cast<double>(count);
      for (std::size_t i = k * count; i < (k + 1) * count; ++i)
        deviation[k] += std::pow(samples[i] - mean[k], 2) / static_cast<double>(count);
      deviation[k] = std::sqrt(deviation[k]);
    }
    double centre = 0, squares = 0, rest = 0;
    for (std::size_t k = 1; k < 8; ++k) oscillation += deviation[k] / 7, centre += mean[k] / 7;
    auto const from_middle = [](std::size_t k) { return static_cast<double>(k) - 4; };
    for (std::size_t k = 1; k < 8; ++k)
      squares += std::pow(from_middle(k), 2), trend += from_middle(k) * (mean[k] - centre);
    trend /= squares;
    for (std::size_t k = 1; k < 8; ++k) rest += std::pow(mean[k] - centre - trend * from_middle(k), 2);
    uncertainty = std::sqrt(rest / 5 / squares);
  }
  // By how many deviations the mean moves from the second eighth to the last, along the line.
  double drift() const { return 6 * trend / oscillation; }
  double drift_uncertainty() const { return 6 * uncertainty / oscillation; }
};

// The table of two runs over equal times, with a step and with half of it; the last line has the trends.
inline void show_eighths(book::Program& program, Eighths const& whole, Eighths const& half, double step) {
  std::vector<book::Program::Row> rows;
  auto const two = [](double x) { return book::number(x, 2); };
  for (std::size_t k = 0; k < 8; ++k)
    rows.push_back({"eighth " + std::to_string(k + 1), two(whole.mean[k]), two(whole.deviation[k]),
                    two(half.mean[k]), two(half.deviation[k])});
  rows.push_back({"trend per eighth, with its standard error", two(whole.trend), two(whole.uncertainty),
                  two(half.trend), two(half.uncertainty)});
  program.table(
      "eighths",
      {"part of the run", "mean, step " + book::number(step), "deviation",
       "mean, step " + book::number(step / 2), "deviation"},
      rows,
      "The relative change of the energy, for two runs over the same time: mean and standard "
      "deviation in each eighth; in the last line the trend of the means from the second eighth on.");
  auto const figure = [&](char const* name, double value, char const* meaning) {
    program.figure(name, value, two(value), meaning);
  };
  figure("drift", whole.drift(), "deviations by which the mean moves from the second eighth to the last");
  figure("drift_error", whole.drift_uncertainty(), "its standard error");
  figure("half_drift", half.drift(), "the same with half the step");
  figure("half_drift_error", half.drift_uncertainty(), "its standard error");
  program.figure("ratio", whole.oscillation / half.oscillation,
                 "oscillation of the energy over that with half the step");
  program.figure("widening", whole.deviation[7] / whole.deviation[1],
                 "oscillation in the last eighth over that in the second");
  program.figure("half_widening", half.deviation[7] / half.deviation[1], "the same with half the step");
}
