#include "program/pictures/pictures.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>

#include "book/plot.hpp"
#include "book/sphere.hpp"
#include "program/base/own_files.hpp"
#include "program/base/printable.hpp"
#include "program/base/progress.hpp"
#include "program/output/series_reader.hpp"
#include "program/pictures/played_medium.hpp"
#include "program/registry/units.hpp"
#include "program/run/checkpoint.hpp"
#include "program/run/drift.hpp"
#include "program/run/run_files.hpp"

namespace actio::scene {
namespace {

/// A picture with its title on a sheet of its own colour, light or dark as the browser prefers; in a page, as
/// the page says.
std::string standing_alone(std::string const& title, double width, std::string const& picture) {
  std::string const opening = "height=\"";
  double const height = std::stod(picture.substr(picture.find(opening) + opening.size())) + 32;
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
      "font-family=\"sans-serif\">\n<title>{2}</title>\n"
      "<style>.run-sheet{{fill:var(--plot-background,#fffefc)}}.run-title{{fill:var(--plot-text,#22272d);"
      "font-size:14px;font-weight:600}}"
      "@media(prefers-color-scheme:dark){{.run-sheet{{fill:var(--plot-background,#16191d)}}.run-title{{fill:"
      "var(--plot-text,#d8dbde)}}}}</style>\n"
      "<rect class=\"run-sheet\" width=\"100%\" height=\"100%\"/>\n<text class=\"run-title\" x=\"16\" "
      "y=\"23\">{2}</text>\n<g transform=\"translate(0 32)\">\n{3}</g>\n</svg>\n",
      width, height, book::svg::escape(printable(title)), picture);
}

constexpr double plot_width = 760, sphere_width = 420;

std::string time_axis(Scene const& scene) {
  return "time" + (time_unit(scene).empty() ? "" : ", " + time_unit(scene));
}
std::string with_unit(std::string const& name, std::string const& unit) {
  return unit == "1" || unit == name ? name : name + ", " + unit;
}

/// How a nearly constant curve is drawn, the ticks of whose axis would all read the same.
struct NearlyConstant {
  double first, range;
  explicit NearlyConstant(Envelope const& curve)
      : first(curve.pieces()[0].first.value), range(curve.highest() - curve.lowest()) {}
  /// It is a straight line: a thousand rounding errors are nothing to look at, and the drift shows them.
  bool flat() const { return range <= 1000 * std::numeric_limits<double>::epsilon() * std::abs(first); }
  /// The first value is taken off every other.
  bool from_first() const { return !flat() && range < 1e-3 * std::abs(first); }
};

void add_curve(book::Plot& plot, std::vector<Envelope::Point> const& points, double taken_off,
               std::string const& label, book::Look const& look) {
  std::vector<double> t, values;
  for (auto const& p : points) t.push_back(p.t), values.push_back(p.value - taken_off);
  plot.curve(t, values, label, look);
}

std::string file_contents(std::string const& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// What the snapshots in a folder show of a medium; null where they show none.
std::shared_ptr<PlayedMedium const> played_medium(Scene const& scene, std::string const& folder) {
  std::error_code none;
  std::string const list = folder + "/" + times_of_snapshots;
  if (!scene.snapshots || !scene.simulation.snapshots || !std::filesystem::exists(list, none)) return nullptr;
  std::vector<double> times;
  auto const reader = read_csv_series(list, {"snapshot", "t"});
  for (std::array<double, 2> row; reader->next(row);) times.push_back(row[1]);
  return scene.simulation.snapshots->played(folder, times);
}

/// Removes pictures that were drawn before, which would pass for those of this run; pictures of other people
/// stay, and none of them is drawn over.
void make_way(std::string const& folder, std::vector<std::pair<std::string, std::string>> const& pictures) {
  std::vector<std::string> names;
  for (auto const& [name, picture] : pictures) names.push_back(name), names.push_back(name + ".part");
  OwnFiles own(folder);
  own.clear("plots");
  own.claim(names);
}

}  // namespace

std::string quantity_picture(Scene const& scene, Overview::Drawn const& drawn) {
  bool const single = drawn.components.size() == 1 && !drawn.components[0].pieces().empty();
  double const taken_off = single && NearlyConstant(drawn.components[0]).from_first()
                               ? NearlyConstant(drawn.components[0]).first
                               : 0;
  std::string label = with_unit(words(drawn.quantity.name), unit_of(scene, drawn.quantity));
  if (taken_off != 0)
    label =
        words(drawn.quantity.name) + (taken_off < 0 ? " + " : " − ") + book::number(std::abs(taken_off), 12);
  book::Plot plot(time_axis(scene), label);
  plot.size(plot_width, 420);
  if (single && NearlyConstant(drawn.components[0]).flat())
    if (double const value = NearlyConstant(drawn.components[0]).first; value != 0)
      plot.y_range(std::min(0.5 * value, 1.5 * value), std::max(0.5 * value, 1.5 * value));
  for (std::size_t i = 0; i < drawn.components.size(); ++i)
    add_curve(plot, drawn.components[i].points(), taken_off,
              drawn.ends[i].empty() ? "" : drawn.ends[i].substr(1),
              {.colour = static_cast<int>(i % 6) + 1, .dashed = i >= 6});
  std::string title = scene.title;
  if (drawn.components.size() < drawn.size)
    title += fmt::format(" (the first {} of {} components)", drawn.components.size(), drawn.size);
  return standing_alone(title, plot_width, plot.svg());
}

std::string drift_picture(Scene const& scene, Overview::Drifting const& drifting) {
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  book::Plot plot(time_axis(scene), "relative drift of the " + words(drifting.name));
  plot.size(plot_width, 340).log_y();
  // The largest of each three-hundredth of the curve: rounding errors that come and go would hatch the
  // picture otherwise.
  auto const& pieces = drifting.difference.pieces();
  std::size_t const together = pieces.size() / 300 + 1;
  std::vector<double> t, values;
  double least = epsilon, most = epsilon;
  for (std::size_t i = 0; i < pieces.size(); i += together) {
    auto const group = std::span(pieces).subspan(i, std::min(together, pieces.size() - i));
    Envelope::Point const largest =
        std::ranges::max(group, {}, [](auto const& piece) { return piece.high.value; }).high;
    if (!(largest.value > 0)) continue;  // exactly as it was, of which there is no logarithm
    t.push_back(largest.t), values.push_back(largest.value / drifting.unit);
    least = std::min(least, values.back()), most = std::max(most, values.back());
  }
  least = std::max(least, 1e-3 * epsilon);
  if (!t.empty()) plot.curve(t, values, words(drifting.name), {.colour = 1});
  double const ends[] = {pieces.empty() ? 0 : pieces.front().first.t,
                         pieces.empty() ? 1 : pieces.back().last.t},
               level[] = {epsilon, epsilon};
  plot.curve(ends, level, "rounding unit, 2.2·10⁻¹⁶", {.colour = 6, .width = 1, .dashed = true});
  plot.y_range(least / 3, 3 * most);
  return standing_alone(scene.title, plot_width, plot.svg());
}

std::string polhode_picture(Scene const& scene, Overview const& overview) {
  std::size_t const at = 1 + static_cast<std::size_t>(std::ranges::find(overview.motion, "body_momentum_x") -
                                                      overview.motion.begin());
  std::vector<std::array<double, 3>> way;
  for (auto const& row : overview.key_frames.rows())
    if (length_of(std::span(row).subspan(at, 3)) > 0) way.push_back({row[at], row[at + 1], row[at + 2]});
  auto sphere = book::Sphere(35, 22).axes({"x", "y", "z"});
  sphere.curve(way, "angular momentum in the body", {.colour = 2, .width = 2});
  if (!way.empty()) sphere.dots(std::vector{way.front()}, "where it begins", {.colour = 1, .radius = 4});
  return standing_alone(scene.title, sphere_width, sphere.svg());
}

void draw_pictures(Scene const& scene, std::string const& folder, bool quiet) {
  Overview const overview = read_overview(scene, folder, quiet);
  std::vector<std::pair<std::string, std::string>> pictures;
  for (auto const& drawn : overview.quantities)
    pictures.emplace_back("plots/" + drawn.quantity.name + ".svg", quantity_picture(scene, drawn));
  for (auto const& drifting : overview.drifts)
    pictures.emplace_back("plots/drift_" + drifting.name + ".svg", drift_picture(scene, drifting));
  for (auto const& own : scene.system->pictures)
    if (overview.find(own.quantity))
      pictures.emplace_back("plots/" + own.name + ".svg", own.draw(scene, overview));
  auto const& maps = scene.system->maps;
  if (std::string const map = maps ? maps->picture(scene, folder, plot_width) : ""; !map.empty())
    pictures.emplace_back("plots/" + maps->name + ".svg", standing_alone(scene.title, plot_width, map));
  auto const medium = played_medium(scene, folder);
  if (medium)
    pictures.emplace_back(
        "plots/medium.svg",
        standing_alone(scene.title, plot_width, medium_picture(*medium, plot_width, time_unit(scene))));
  if (std::string const film = medium ? medium_film(*medium, plot_width, printable(scene.title)) : "";
      !film.empty())
    pictures.emplace_back("plots/film.svg", film);
  pictures.emplace_back(
      "plots/index.html",
      viewer_page(scene, overview, file_contents(folder + "/summary.json"),
                  maps ? maps->json(scene, folder) : "null", medium ? medium_json(*medium) : "null"));
  make_way(folder, pictures);
  for (auto const& [name, picture] : pictures) write_whole_file(folder + "/" + name, picture);
  if (!quiet && scene.system->shape && !overview.find("attitude"))
    say(stderr, "pictures: add \"attitude\" to output.quantities to see the body turn\n");
  if (!quiet && scene.system->bodies && !overview.find("position"))
    say(stderr, "pictures: add \"position\" to output.quantities to see both bodies move\n");
  if (!quiet && scene.system->snapshots && !scene.snapshots)
    say(stderr, "pictures: add snapshots = [] and snapshot_every to [output] to see it move\n");
}

}  // namespace actio::scene
