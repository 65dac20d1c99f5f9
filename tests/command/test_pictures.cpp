#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <regex>
#include <set>

#include "page_in_node.hpp"
#include "process.hpp"

using command::number_after, command::page_in_node, command::there_is_node;

namespace {

/// What is wrong with an XML text, as far as elements, attributes and entities go; empty where nothing is.
std::string xml_fault(std::string const& text) {
  static std::regex const tag(R"(^<(/?)([A-Za-z][\w:-]*)((?:\s+[A-Za-z_][\w:-]*="[^"<]*")*)\s*(/?)>)"),
      entity("^&(amp|lt|gt|quot|apos|#[0-9]+);");
  std::vector<std::string> open;
  std::smatch match;
  for (auto at = text.begin(); at != text.end();) {
    if (*at == '<') {
      if (!std::regex_search(at, text.end(), match, tag))
        return "no tag: " + std::string(at, std::min(text.end(), at + 60));
      if (match.length(1) == 0 && match.length(4) == 0) open.push_back(match[2]);
      if (match.length(1) > 0) {
        if (open.empty() || open.back() != match[2]) return "</" + match[2].str() + "> ends nothing";
        open.pop_back();
      }
      at += match.length(0);
      continue;
    }
    if (*at == '&' && !std::regex_search(at, text.end(), match, entity))
      return "a bare &: " + std::string(at, std::min(text.end(), at + 60));
    if (open.empty() && !std::isspace(static_cast<unsigned char>(*at))) return "text outside of the element";
    ++at;
  }
  return open.empty() ? "" : "<" + open.back() + "> does not end";
}

std::set<std::string> names_in(std::string const& folder) {
  std::set<std::string> out;
  for (auto const& entry : std::filesystem::directory_iterator(folder))
    out.insert(entry.path().filename().string());
  return out;
}

/// The lowest and the highest place of the curve of a picture, and the place of its dashed line, in pixels
/// from above.
struct Heights {
  double top, bottom, dashed;
};
Heights heights(std::string const& svg) {
  Heights out{1e9, -1e9, std::nan("")};
  static std::regex const path("<path class=\"line[0-9]\"([^>]*) d=\"([^\"]*)\""),
      point("[ML]([-0-9.]+) ([-0-9.]+)");
  std::size_t const frame = svg.find("clip-path=");  // beyond it are curves, and then the legend
  std::string const curves = svg.substr(frame, svg.find("</g>", frame) - frame);
  for (std::sregex_iterator it(curves.begin(), curves.end(), path), end; it != end; ++it) {
    std::string const points = (*it)[2], look = (*it)[1];
    for (std::sregex_iterator p(points.begin(), points.end(), point); p != end; ++p) {
      double const y = std::stod((*p)[2]);
      if (look.find("dasharray") != std::string::npos)
        out.dashed = y;
      else
        out.top = std::min(out.top, y), out.bottom = std::max(out.bottom, y);
    }
  }
  return out;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(pictures)

BOOST_AUTO_TEST_CASE(there_is_a_picture_for_each_quantity_each_drift_and_the_polhode) {
  command::Folder const folder;
  auto const outcome = command::actio({"run", folder.write("apophis.toml", command::apophis()), "--plots"});
  BOOST_TEST(outcome.status == 0, outcome.err);
  BOOST_TEST(names_in(folder / "apophis/plots") ==
                 (std::set<std::string>{"body_momentum.svg", "energy.svg", "drift_energy.svg", "polhode.svg",
                                        "index.html"}),
             boost::test_tools::per_element());
  for (auto const& name : names_in(folder / "apophis/plots")) {
    if (!name.ends_with(".svg")) continue;
    std::string const svg = command::contents(folder / ("apophis/plots/" + name));
    BOOST_TEST(xml_fault(svg) == "", name);
    BOOST_TEST(svg.find("Apophis") != std::string::npos, name + " has no title");
    BOOST_TEST(svg.find("prefers-color-scheme:dark") != std::string::npos, name + " has no dark colours");
  }
}

BOOST_AUTO_TEST_CASE(the_xml_check_finds_faults) {
  for (char const* const wrong :
       {"<a>", "<a></b>", "<a>&</a>", "<a b=c/>", "<a b=\"<\"/>", "<a/>x", "<a><b></a></b>"})
    BOOST_TEST(xml_fault(wrong) != "", wrong);
  BOOST_TEST(xml_fault("<a b=\"&amp;\"><c/>x</a>\n") == "");
}

BOOST_AUTO_TEST_CASE(nothing_is_drawn_that_was_not_asked_for) {
  command::Folder const folder;
  std::string const scene = folder.write("apophis.toml", command::apophis());
  BOOST_TEST(command::actio({"run", scene}).status == 0);
  BOOST_TEST(!std::filesystem::exists(folder / "apophis/plots"));
  BOOST_TEST(command::actio({"run", scene, "--force", "--set", "output.plots=true"}).status == 0);
  BOOST_TEST(std::filesystem::exists(folder / "apophis/plots/energy.svg"));
}

BOOST_AUTO_TEST_CASE(pictures_of_the_run_before_are_gone) {
  command::Folder const folder;
  std::string const scene = folder.write("apophis.toml", command::apophis());
  BOOST_TEST(command::actio({"run", scene, "--plots"}).status == 0);
  BOOST_TEST(command::actio(
                 {"run", scene, "--plots", "--force", "--set", "output.quantities=[\"angular_velocity\"]"})
                 .status == 0);
  BOOST_TEST(
      names_in(folder / "apophis/plots") == (std::set<std::string>{"angular_velocity.svg", "index.html"}),
      boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_drift_stands_out_against_rounding) {
  command::Folder const folder;
  std::string const exact = folder.write("exact.toml", command::apophis());
  std::string const chart = folder.write(
      "chart.toml", command::apophis({{"name", "\"natural_chart\""}, {"order", "2"}, {"step", "0.25"}}));
  BOOST_TEST_REQUIRE(command::actio({"run", exact, "--plots"}).status == 0);
  auto const drifting = command::actio({"run", chart, "--plots"});
  BOOST_TEST_REQUIRE(drifting.status == 0, drifting.err);
  Heights const kept = heights(command::contents(folder / "exact/plots/drift_energy.svg")),
                lost = heights(command::contents(folder / "chart/plots/drift_energy.svg"));
  // Frames are about 240 pixels high. The natural chart loses some 1e-6 in its second order, ten decades
  // above rounding, which then lies at the foot.
  BOOST_TEST(lost.dashed - lost.top > 150);
  // Of the exact run the errors are a few roundings, within two decades; the frame is no more than those
  // high.
  BOOST_TEST(kept.top < kept.bottom);
  BOOST_TEST(kept.bottom + 60 > kept.dashed);
}

BOOST_AUTO_TEST_CASE(a_title_cannot_break_out_of_a_picture_or_of_the_page) {
  command::Folder const folder;
  std::string const title = "</script><script>alert(1)</script>\"&<!-- run --> /* script */ <b>",
                    toml = "'''" + title + "'''";
  auto const outcome =
      command::actio({"run", folder.write("apophis.toml", command::apophis({{"title", toml}})), "--plots"});
  BOOST_TEST_REQUIRE(outcome.status == 0, outcome.err);
  for (char const* const name : {"body_momentum.svg", "drift_energy.svg", "polhode.svg"})
    BOOST_TEST(xml_fault(command::contents(folder / ("apophis/plots/" + std::string(name)))) == "", name);
  std::string const page = command::contents(folder / "apophis/plots/index.html");
  std::size_t ends = 0;
  for (std::size_t at = 0; (at = page.find("</script", at)) != std::string::npos; ++at) ++ends;
  BOOST_TEST(ends == 2u);  // of the data and of the script
  BOOST_TEST(page.find("alert(1)</") == std::string::npos);
  if (!there_is_node()) return;
  auto const said = page_in_node(folder / "apophis/plots/index.html");
  BOOST_TEST(said.status == 0, said.err);
  BOOST_TEST(
      said.out.find(R"("title":"</script><script>alert(1)</script>\"&<!-- run --> /* script */ <b>")") !=
          std::string::npos,
      said.out);
}

BOOST_AUTO_TEST_CASE(characters_that_xml_does_not_have_are_written_out) {
  command::Folder const folder;
  auto const scene =
      folder.write("apophis.toml", command::apophis({{"title", R"("a\u0001b\uFFFEc\u001bd")"}}));
  BOOST_TEST_REQUIRE(command::actio({"run", scene, "--plots"}).status == 0);
  for (char const* const name : {"plots/body_momentum.svg", "plots/polhode.svg", "plots/index.html"}) {
    std::string const text = command::contents(folder / ("apophis/" + std::string(name)));
    BOOST_TEST(text.find(R"(a\u0001b\ufffec\u001bd)") != std::string::npos, name);
    BOOST_TEST(std::ranges::none_of(text, [](unsigned char c) { return c < 0x20 && c != '\n' && c != '\t'; }),
               name);
    if (std::string_view(name).ends_with("svg"))
      BOOST_TEST(text.find("\xef\xbf\xbe") == std::string::npos, name);
  }
}

BOOST_AUTO_TEST_CASE(the_page_needs_nothing_beside_itself) {
  command::Folder const folder;
  BOOST_TEST_REQUIRE(
      command::actio({"run", folder.write("apophis.toml", command::apophis()), "--plots"}).status == 0);
  std::string const page = command::contents(folder / "apophis/plots/index.html");
  for (char const* const outside : {"http:", "https:", "src=", "href=", "@import", "url("})
    BOOST_TEST(page.find(outside) == std::string::npos, outside);
}

BOOST_AUTO_TEST_CASE(the_page_plays_bodies_tops_and_momenta) {
  if (!there_is_node()) return;
  command::Folder const folder;
  struct Played {
    std::string scene, quantities;
    int stages;
  };
  for (auto const& [scene, quantities, stages] :
       {Played{"t_handle", "", 2},
        {"t_handle", "[\"attitude\"]", 1},
        {"water", "", 2},
        {"nodding_top", "", 1},
        {"so4_body", "", 1},
        {"so4_body", "[\"energy\"]", 0},
        {"apophis", "[\"energy\"]", 0},
        {"kw4", "", 1},
        {"didymos_before", "[\"position\", \"attitude_1\", \"attitude_2\"]", 1},
        {"didymos_before", "[\"energy\"]", 0}}) {
    std::vector<std::string> arguments{
        "run", ACTIO_DATA "/scenes/" + scene + ".toml", "--out", folder / scene, "--force", "--plots"};
    if (!quantities.empty()) arguments.insert(arguments.end(), {"--set", "output.quantities=" + quantities});
    auto const outcome = command::actio(arguments);
    BOOST_TEST(outcome.status == 0, outcome.err);
    auto const said = page_in_node(folder / (scene + "/plots/index.html"));
    BOOST_TEST(said.status == 0, scene + ": " + said.err);
    BOOST_TEST(number_after(said.out, "stages") == stages, scene + ": " + said.out);
  }
}

BOOST_AUTO_TEST_CASE(a_run_without_attitude_is_told_what_to_ask_for) {
  command::Folder const folder;
  std::string const scene = folder.write("apophis.toml", command::apophis());
  std::string const hint = "add \"attitude\" to output.quantities to see the body turn";
  auto const run = [&](std::string const& quantities, std::vector<std::string> more = {}) {
    std::vector<std::string> arguments{"run",     scene,   "--force",
                                       "--plots", "--set", "output.quantities=" + quantities};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return command::actio(arguments);
  };
  BOOST_TEST(run("[\"energy\"]").err.find(hint) != std::string::npos);
  BOOST_TEST(run("[\"energy\"]", {"--quiet"}).err == "");
  if (there_is_node())
    BOOST_TEST(number_after(page_in_node(folder / "apophis/plots/index.html").out, "asks") == 1);
  BOOST_TEST(run("[\"attitude\"]").err == "");
  if (there_is_node())
    BOOST_TEST(number_after(page_in_node(folder / "apophis/plots/index.html").out, "asks") == 0);
}

BOOST_AUTO_TEST_CASE(every_scene_of_a_body_in_space_asks_for_what_its_page_shows) {
  for (auto const& entry : std::filesystem::directory_iterator(ACTIO_DATA "/scenes")) {
    if (entry.path().extension() != ".toml") continue;
    std::string const text = command::contents(entry.path().string());
    bool const in_space =
        text.find("\"rigid_body\"") != std::string::npos || text.find("\"heavy_top\"") != std::string::npos;
    if (in_space) BOOST_TEST(text.find("\"attitude\"") != std::string::npos, entry.path().filename());
  }
}

BOOST_AUTO_TEST_CASE(the_page_shows_an_estimate_of_the_error_where_the_summary_has_one) {
  if (!there_is_node()) return;
  command::Folder const folder;
  BOOST_TEST_REQUIRE(
      command::actio({"run", folder.write("apophis.toml", command::apophis()), "--plots"}).status == 0);
  std::string const page = command::contents(folder / "apophis/plots/index.html"), begin = "\"summary\":{";
  auto const with = [&](std::string const& error) {
    std::string changed = page;
    // An error that the run may have told of itself is not the one of this test.
    for (std::size_t at; (at = changed.find("\"error\":{")) != std::string::npos;)
      changed.replace(at, 9, "\"other\":{");
    changed.replace(changed.find(begin), begin.size(), begin + error);
    return page_in_node(folder.write("changed.html", changed));
  };
  auto const estimated = with(R"("error":{"attitude":3.1e-3,"momentum":1.7e-3,"how":"by half the step"},)");
  BOOST_TEST(
      estimated.out.find("Error, estimated | attitude 0.0031 rad | momentum 0.0017") != std::string::npos,
      estimated.out << estimated.err);
  auto const until =
      with(R"("error":{"attitude":"no number after t = 5","momentum":1.7e-3,"how":"by half"},)");
  BOOST_TEST(until.out.find("Error, estimated | attitude no number after t = 5 | momentum 0.0017") !=
                 std::string::npos,
             until.out << until.err);
  auto const exact = with(R"("error":{"how":"exact to rounding"},)");
  BOOST_TEST(exact.out.find("Error: exact to rounding") != std::string::npos, exact.out << exact.err);
  BOOST_TEST(with("").out.find("\"error\":\"\"") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(the_page_shows_the_drift_of_the_summary) {
  if (!there_is_node()) return;
  command::Folder const folder;
  BOOST_TEST_REQUIRE(
      command::actio({"run", ACTIO_DATA "/scenes/thin_rod.toml", "--out", folder / "rod", "--plots"})
          .status == 0);
  std::string const summary = command::contents(folder / "rod/summary.json"),
                    said = page_in_node(folder / "rod/plots/index.html").out;
  double const drift = number_after(summary, "energy", summary.find("\"drift\""));
  // Six digits are on the page.
  BOOST_TEST(std::abs(number_after(said, "energy") - drift) <= 1e-5 * drift);
  BOOST_TEST(drift > 1e-12);  // or nothing would have been compared
}

BOOST_AUTO_TEST_CASE(a_million_rows_take_no_more_memory_than_a_tenth_of_them) {
  command::Folder const folder;
  std::string const scene = folder.write("apophis.toml", command::apophis());
  auto const run = [&](std::string const& every, bool plots) {
    std::vector<std::string> arguments{"run",   scene,          "--quiet", "--force",
                                       "--out", folder / "out", "--set",   "run.every=" + every};
    if (plots) arguments.push_back("--plots");
    return command::cost(arguments);
  };
  auto const few = run("2.5e-4", true), many = run("2.5e-5", true);
  BOOST_TEST_REQUIRE(few.status == 0);
  BOOST_TEST_REQUIRE(many.status == 0);
  BOOST_TEST_MESSAGE("1e6 rows and their pictures: " << many.work << " s of work and " << many.peak_megabytes
                                                     << " MB; 1e5 rows: " << few.work << " s and "
                                                     << few.peak_megabytes << " MB");
  // The 900 000 rows more are 36 MB as numbers and 90 MB as text.
  BOOST_TEST(many.peak_megabytes < few.peak_megabytes + 12);
  // Work grows like the rows, ten times; where it grew like their square it would be a hundred times.
  BOOST_TEST(many.work < 40 * few.work);
  if (!there_is_node()) return;
  auto const said = page_in_node(folder / "out/plots/index.html");
  BOOST_TEST(said.status == 0, said.err);
  BOOST_TEST(number_after(said.out, "rows") == 1000001);
  BOOST_TEST(number_after(said.out, "played") <= 3000);
  BOOST_TEST(std::filesystem::file_size(folder / "out/plots/index.html") < 1'000'000u);
}

BOOST_AUTO_TEST_SUITE_END()
