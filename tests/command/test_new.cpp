// actio new, and the scenes that come with actio.
#include <boost/test/unit_test.hpp>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "command.hpp"

namespace {

namespace fs = std::filesystem;
using command::actio;

bool has(std::string const& text, std::string const& part) { return text.find(part) != std::string::npos; }

std::vector<std::string> names_in(std::string const& list) {
  std::vector<std::string> out;
  std::istringstream in(actio({"list", list}).out);
  for (std::string line; std::getline(in, line);) out.push_back(line.substr(0, line.find(' ')));
  return out;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(new_scenes)

BOOST_AUTO_TEST_CASE(every_system_has_a_scene_with_all_its_keys_that_runs_as_it_is) {
  for (auto const& system : nlohmann::json::parse(actio({"list", "systems", "--json"}).out)) {
    command::Folder const folder;
    std::string const name = system["name"], path = folder / "mine.toml";
    BOOST_TEST(actio({"new", name, "--out", path}).status == 0);
    std::string const text = command::contents(path);
    BOOST_TEST(text == actio({"new", name}).out);
    for (auto const& key : system["parameters"]) {
      std::string const whole = key["key"], last = whole.substr(whole.find('.') + 1);
      if (last.find('.') == std::string::npos)
        BOOST_TEST((has(text, "\n" + last + " = ") || has(text, "\n# " + last + " = ")), whole);
    }
    auto const outcome = actio({"run", path});
    BOOST_TEST(outcome.status == 0, name << ": " << outcome.err);
    BOOST_TEST(command::read_csv(folder / "mine/series.csv").rows.size() > 100u);
  }
}

BOOST_AUTO_TEST_CASE(no_line_of_a_new_scene_is_longer_than_a_terminal) {
  std::istringstream lines(actio({"new", "heavy_top"}).out);
  for (std::string line; std::getline(lines, line);) BOOST_TEST(line.size() <= 110u, line);
}

BOOST_AUTO_TEST_CASE(every_body_can_be_let_go) {
  for (auto const& body : names_in("bodies")) {
    command::Folder const folder;
    std::string const path = folder.write("mine.toml", actio({"new", "rigid_body", "--body", body}).out);
    auto const outcome = actio({"run", path, "--set", "output.quantities=[\"energy\"]"});
    BOOST_TEST(outcome.status == 0, body << ": " << outcome.err);
    auto const rows = command::read_csv(folder / "mine/series.csv").rows.size();
    BOOST_TEST(rows > 200u);
    BOOST_TEST(rows < 2000u);
  }
}

BOOST_AUTO_TEST_CASE(a_file_that_is_there_is_not_replaced) {
  command::Folder const folder;
  std::string const path = folder.write("mine.toml", "mine");
  auto const outcome = actio({"new", "rigid_body", "--out", path});
  BOOST_TEST(outcome.status == 2);
  BOOST_TEST(has(outcome.err, path + ": there is such a file already"), outcome.err);
  BOOST_TEST(command::contents(path) == "mine");
  // Nor through a link that leads nowhere.
  fs::create_symlink(folder / "elsewhere", folder / "link.toml");
  BOOST_TEST(actio({"new", "rigid_body", "--out", folder / "link.toml"}).status == 2);
  BOOST_TEST(!fs::exists(folder / "elsewhere"));
  BOOST_TEST(actio({"new", "rigid_body", "--out", folder / "none/mine.toml"}).status == 4);
}

BOOST_AUTO_TEST_CASE(a_scene_that_is_not_known_is_refused_with_the_nearest) {
  BOOST_TEST(actio({"new", "rigid_boddy"}).err ==
             "actio new: unknown name 'rigid_boddy'; did you mean 'rigid_body'? "
             "(actio list systems|scenes|bodies)\n");
  BOOST_TEST(has(actio({"new", "rigid_body", "--body", "apofis"}).err,
                 "unknown body 'apofis'; did you mean 'apophis'?"));
  BOOST_TEST(
      has(actio({"new", "heavy_top", "--body", "apophis"}).err, "heavy_top takes no body of the library"));
  BOOST_TEST(has(actio({"new", "apophis", "--body", "apophis"}).err, "--body belongs to a system"));
  BOOST_TEST(has(actio({"new"}).err, "actio list systems"));
}

BOOST_AUTO_TEST_CASE(the_scenes_that_come_with_actio_are_those_of_the_sources) {
  auto const names = names_in("scenes");
  std::size_t files = 0;
  for (auto const& entry : fs::directory_iterator(ACTIO_DATA "/scenes"))
    files += entry.path().extension() == ".toml";
  BOOST_TEST(names.size() == files);
  for (auto const& name : names)
    BOOST_TEST(actio({"new", name}).out == command::contents(ACTIO_DATA "/scenes/" + name + ".toml"), name);
}

BOOST_AUTO_TEST_CASE(a_scene_that_comes_with_actio_runs_by_its_name_into_the_current_folder) {
  command::Folder const folder;
  BOOST_TEST(command::shell("cd '" + (folder / "") + "' && $ACTIO run apophis --quiet").status == 0);
  BOOST_TEST(actio({"run", ACTIO_DATA "/scenes/apophis.toml", "--out", folder / "file"}).status == 0);
  BOOST_TEST(command::contents(folder / "apophis/series.csv") ==
             command::contents(folder / "file/series.csv"));
  BOOST_TEST(command::contents(folder / "apophis/scene.toml") ==
             command::contents(folder / "file/scene.toml"));
  // The folder that is now there does not hide the scene, and is not replaced.
  auto const again = command::shell("cd '" + (folder / "") + "' && $ACTIO run apophis --quiet");
  BOOST_TEST(again.status == 2);
  BOOST_TEST(again.err.starts_with("apophis: the folder is not empty"), again.err);
}

BOOST_AUTO_TEST_CASE(a_file_of_that_name_comes_first) {
  command::Folder const folder;
  folder.write("apophis", command::apophis({{"title", "\"My own\""}}));
  BOOST_TEST(has(command::shell("cd '" + (folder / "") + "' && $ACTIO run apophis --dry-run").out, "My own"));
}

BOOST_AUTO_TEST_CASE(a_scene_that_is_not_there_is_answered_with_the_way_to_it) {
  command::Folder const folder;
  auto const said = [&folder](std::string const& name) {
    return command::shell("cd '" + (folder / "") + "' && $ACTIO run " + name);
  };
  BOOST_TEST(said("apophis.toml").err ==
             "apophis.toml: there is no such file; a scene of that name comes with actio: 'actio run "
             "apophis' runs it, 'actio new apophis --out apophis.toml' writes it\n");
  BOOST_TEST(said("apophis.toml").status == 2);
  BOOST_TEST(said("apofis").err == "apofis: there is no such file; did you mean 'apophis'?\n");
  BOOST_TEST(said("zzz").err ==
             "zzz: there is no such file (scenes that come with actio: actio list scenes)\n");
  BOOST_TEST(said("nowhere/apophis").err == "nowhere/apophis: there is no such file\n");
}

BOOST_AUTO_TEST_SUITE_END()
