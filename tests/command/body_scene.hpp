// Scenes of bodies, put together section by section, and run.
#pragma once

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>

#include "command.hpp"

namespace command {

/// The sections of a scene, without their heads.
struct BodyScene {
  std::string system, initial, method, run, quantities;

  std::string text() const {
    return "[system]\n" + system + "\n[initial]\n" + initial + "\n[method]\n" + method + "\n[run]\n" + run +
           "\n[output]\nquantities = [" + quantities + "]\n";
  }
};

/// What a run left.
struct Left {
  Outcome outcome;
  Table table;                 ///< empty where there is no series
  std::string scene, summary;  ///< scene.toml and summary.json
};
inline Left run(BodyScene const& scene) {
  Folder const folder;
  Left left{actio({"run", "--quiet", "--out", folder / "out", folder.write("scene.toml", scene.text())}),
            {},
            "",
            ""};
  // The folder's name is another each time.
  for (std::string const name = folder / "scene.toml"; left.outcome.err.find(name) != std::string::npos;)
    left.outcome.err.replace(left.outcome.err.find(name), name.size(), "scene.toml");
  if (std::filesystem::exists(folder / "out/series.csv")) left.table = read_csv(folder / "out/series.csv");
  left.scene = contents(folder / "out/scene.toml"), left.summary = contents(folder / "out/summary.json");
  return left;
}

/// The last row, without its time.
inline std::vector<double> last(Left const& left) {
  if (left.table.rows.empty()) return {};
  auto const& row = left.table.rows.back();
  return {row.begin() + 1, row.end()};
}
/// The largest difference; infinite where the lengths differ or there is nothing to compare.
inline double apart(std::vector<double> const& a, std::vector<double> const& b) {
  if (a.size() != b.size() || a.empty()) return INFINITY;
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    most = std::max(most, std::isfinite(a[i] - b[i]) ? std::abs(a[i] - b[i]) : INFINITY);
  return most;
}
inline bool contains(std::string const& text, std::string const& part) {
  return text.find(part) != std::string::npos;
}

/// The order that errors at steps h, h/2, h/4, ... show: of the last pair.
inline double order_of(std::vector<double> const& errors) {
  return std::log2(errors[errors.size() - 2] / errors.back());
}

/// Checks orders two and four of the scene's method, by angular velocity and attitude at time 2.
/// @param step  of the truth, which has order four
/// @param name  for the report
inline void check_orders(BodyScene scene, std::string const& step, std::string const& name) {
  scene.run = "until = 2", scene.quantities = "'angular_velocity', 'attitude'";
  scene.method = "order = 4\nstep = " + step;
  auto const truth = last(run(scene));
  for (auto const& [order, h] : {std::pair(2, 0.0625), std::pair(4, 0.125)}) {
    std::vector<double> errors;
    for (int k = 0; k < 3; ++k) {
      scene.method = "order = " + std::to_string(order) + "\nstep = " + std::to_string(std::ldexp(h, -k));
      errors.push_back(apart(last(run(scene)), truth));
    }
    BOOST_TEST_MESSAGE(name << ", order " << order << ": measured " << order_of(errors));
    BOOST_TEST(std::abs(order_of(errors) - order) < 0.3);
  }
}

}  // namespace command
