#include "program/pictures/overview.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>

#include "program/base/progress.hpp"
#include "program/output/series_reader.hpp"
#include "program/run/drift.hpp"

namespace actio::scene {
namespace {

/// Columns of a row that a motion is played from.
struct Direction {
  std::size_t first, size;
  bool two_signs;  ///< a quaternion and its negative are one attitude
};

/// Says how much has been read, where that takes more than a second.
class ReadingProgress {
 public:
  explicit ReadingProgress(bool quiet) : quiet_(quiet), terminal_(::isatty(STDERR_FILENO) != 0) {}
  ~ReadingProgress() {
    if (shown_ && terminal_) say(stderr, "\r" + std::string(40, ' ') + "\r");
  }
  void show(double fraction) {
    auto const now = Clock::now();
    if (quiet_ || now < next_) return;
    // On a terminal five times a second, in a pipe every ten.
    next_ = now + std::chrono::milliseconds(terminal_ ? 200 : 10000);
    shown_ = true;
    say(stderr, fmt::format("{}pictures: {:3.0f} % of the rows are read{}", terminal_ ? "\r" : "",
                            100 * fraction, terminal_ ? "" : "\n"));
  }

 private:
  using Clock = std::chrono::steady_clock;
  bool quiet_, terminal_, shown_ = false;
  Clock::time_point next_ = Clock::now() + std::chrono::seconds(1);
};

/// The quantities of a scene with their columns.
std::vector<Overview::Drawn> drawn_quantities(Scene const& scene) {
  std::vector<Overview::Drawn> out;
  std::size_t at = 0;
  for (auto const& group : scene.simulation.quantities.column_groups()) {
    Overview::Drawn drawn{group.quantity, at, group.columns.size(), {}, {}};
    for (auto const& column : group.columns) drawn.ends.push_back(column.substr(group.quantity.name.size()));
    drawn.components.resize(std::min(drawn.size, Overview::most_components));
    at += drawn.size;
    out.push_back(std::move(drawn));
  }
  return out;
}

/// The columns of a quantity that are in the key frames, and its directions among them.
class Played {
 public:
  /// @param first  its first column there
  Played(Overview::Drawn const& drawn, std::size_t first) {
    using Shown = Quantity::Shown;
    Shown const shown = drawn.quantity.shown;
    if (shown == Shown::by_curves || shown == Shown::by_planes) return;
    bool const frame = shown == Shown::as_rotation || shown == Shown::as_motion;
    columns = frame ? drawn.size : std::min(drawn.size, Overview::most_components);
    if (frame)
      add_axes(first, drawn.size, shown == Shown::as_motion);
    else if (shown != Shown::beside_motion)
      directions.push_back({first, columns, drawn.quantity.kind == Quantity::Kind::quaternion});
  }
  std::size_t columns = 0;            ///< the first so many of the quantity
  std::vector<Direction> directions;  ///< what must not turn too far

 private:
  /// Rows of the rotation: each is an axis of space as the frame sees it.
  void add_axes(std::size_t first, std::size_t size, bool with_place) {
    std::size_t n = 1;
    while (n * n < size) ++n;
    std::size_t const axes = with_place ? n - 1 : n;
    for (std::size_t i = 0; i < axes; ++i) directions.push_back({first + i * n, axes, false});
  }
};

/// Two rows are near where no direction in them has turned by more than thirty degrees.
KeyFrames::Near near(std::vector<Direction> directions) {
  return [directions = std::move(directions)](std::vector<double> const& a, std::vector<double> const& b) {
    for (auto const& d : directions) {
      double dot = 0;
      for (std::size_t i = d.first; i < d.first + d.size; ++i) dot += a[i] * b[i];
      double const lengths =
          length_of(std::span(a).subspan(d.first, d.size)) * length_of(std::span(b).subspan(d.first, d.size));
      // A rotation by an angle is a quaternion by its half.
      double const most = (d.two_signs ? 15 : 30) * std::numbers::pi / 180;
      if (!((d.two_signs ? std::abs(dot) : dot) >= std::cos(most) * lengths)) return false;
    }
    return true;
  };
}

/// The unit in which the summary of a run tells the drift of a quantity; zero where it tells none.
std::map<std::string, double> drift_units(std::string const& folder) {
  std::ifstream in(folder + "/summary.json");
  auto const summary = nlohmann::json::parse(in, nullptr, false);
  std::map<std::string, double> out;
  if (!summary.is_object() || !summary.contains("drift_units") || !summary["drift_units"].is_object())
    return out;
  for (auto const& [name, unit] : summary["drift_units"].items())
    if (unit.is_number()) out[name] = unit.get<double>();
  return out;
}

}  // namespace

Overview::Drawn const* Overview::find(std::string const& name) const {
  auto const found = std::ranges::find(quantities, name, [](Drawn const& d) { return d.quantity.name; });
  return found == quantities.end() ? nullptr : &*found;
}

Overview read_overview(Scene const& scene, std::string const& folder, bool quiet) {
  auto quantities = drawn_quantities(scene);
  std::vector<Direction> directions;
  std::vector<std::string> motion, columns{"t"};
  for (auto const& name : scene.simulation.quantities.columns()) columns.push_back(name);
  std::vector<std::size_t> moving{0};  // columns that are in the key frames
  for (auto const& drawn : quantities) {
    Played const played(drawn, moving.size());
    directions.insert(directions.end(), played.directions.begin(), played.directions.end());
    for (std::size_t i = 0; i < played.columns; ++i)
      moving.push_back(1 + drawn.first + i), motion.push_back(columns[moving.back()]);
  }

  Overview out{std::move(quantities), {}, std::move(motion), KeyFrames(near(std::move(directions))), 0};
  auto const conserved = scene.simulation.quantities.conserved();
  for (auto const& c : conserved) out.drifts.push_back({c.name, {}, 0});
  auto const units = drift_units(folder);
  auto const reader = read_series(folder, scene.simulation.quantities.column_groups());
  ReadingProgress progress(quiet);
  std::vector<double> row(columns.size()), first, difference, moved(moving.size());
  for (; reader->next(row); ++out.rows) {
    double const t = row[0];
    std::span<double const> const values = std::span(row).subspan(1);
    if (first.empty()) first.assign(values.begin(), values.end());
    for (auto& drawn : out.quantities)
      for (std::size_t i = 0; i < drawn.components.size(); ++i)
        drawn.components[i].add(t, values[drawn.first + i]);
    for (std::size_t k = 0; k < conserved.size(); ++k) {
      auto const now = values.subspan(conserved[k].first, conserved[k].size);
      difference.assign(now.begin(), now.end());
      for (std::size_t i = 0; i < now.size(); ++i) difference[i] -= first[conserved[k].first + i];
      out.drifts[k].difference.add(t, length_of(difference));
      double const start =
          length_of(std::span<double const>(first).subspan(conserved[k].first, conserved[k].size));
      if (auto const told = units.find(conserved[k].name); told != units.end())
        out.drifts[k].unit = told->second;
      else
        out.drifts[k].unit = start > 0 ? start : std::max(out.drifts[k].unit, length_of(now));
    }
    for (std::size_t i = 0; i < moving.size(); ++i) moved[i] = row[moving[i]];
    if (!out.motion.empty()) out.key_frames.add(moved);
    if (out.rows % 1024 == 0) progress.show(reader->fraction());
  }
  return out;
}

}  // namespace actio::scene
