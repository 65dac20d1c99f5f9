// What --force removes: the files that the command wrote and lists in the folder, and nothing of anybody
// else.
#include <boost/test/unit_test.hpp>

#include <fstream>
#include <iterator>
#include <map>
#include <sstream>

#include "command.hpp"

BOOST_AUTO_TEST_SUITE(force)

namespace {

namespace fs = std::filesystem;
using Files = std::map<std::string, std::string>;

/// Every file below a folder, links with what they lead to by name.
Files all_of(std::string const& folder) {
  Files out;
  for (auto const& entry : fs::recursive_directory_iterator(folder)) {
    std::string const name = fs::relative(entry.path(), folder).string();
    if (entry.is_symlink())
      out[name] = "-> " + fs::read_symlink(entry.path()).string();
    else if (entry.is_regular_file())
      out[name] = command::contents(entry.path().string());
  }
  return out;
}
/// Puts a file of one's own there; its name is what is in it.
void put(std::string const& folder, std::vector<std::string> const& names) {
  for (auto const& name : names) {
    fs::create_directories(fs::path(folder + "/" + name).parent_path());
    std::ofstream(folder + "/" + name) << name;
  }
}
void check_kept(std::string const& folder, std::vector<std::string> const& names) {
  for (auto const& name : names)
    BOOST_TEST(command::contents(folder + "/" + name) == name, name << " is gone");
}

/// Names like those that a run or a sweep uses, and none of them.
std::vector<std::string> similar_names() {
  std::istringstream names(
      "plots.py series.ipynb series.csv.bak series.csv.part series.h5 summary.md summary.json~ "
      "checkpoint.old scene.toml.orig plots/fig3.pdf plots/energy.png plots/mine.svg "
      "snapshots/paper_figure.pdf snapshots/000000.csv sweep.csv.bak .actio.bak 202401/raw.csv "
      "000123/series.csv");
  return {std::istream_iterator<std::string>(names), {}};
}
std::vector<std::string> const similar = similar_names();

}  // namespace

BOOST_AUTO_TEST_CASE(files_of_every_similar_name_survive_beside_a_run) {
  command::Folder const folder;
  std::string const scene = folder.write("apophis.toml", command::apophis()), out = folder / "apophis";
  BOOST_TEST(command::actio({"run", scene, "--plots"}).status == 0);
  put(out, similar);
  for (int turn = 0; turn < 2; ++turn) {
    auto const outcome = command::actio({"run", scene, "--force", "--set", "run.until=5.0"});
    BOOST_TEST(outcome.status == 0, outcome.err);
    check_kept(out, similar);
    BOOST_TEST(!fs::exists(out + "/plots/energy.svg"));
    BOOST_TEST(!fs::exists(out + "/plots/index.html"));
    BOOST_TEST(command::read_csv(out + "/series.csv")["t"].back() == 5);
  }
  // The pictures of this run are drawn beside one's own, and not over them.
  put(out, {"plots/body_momentum.svg"});
  auto const over = command::actio({"run", scene, "--force", "--plots"});
  BOOST_TEST(over.status == 2);
  BOOST_TEST(over.err.find(out + "/plots/body_momentum.svg: is there already, and actio did not write it") !=
                 std::string::npos,
             over.err);
  check_kept(out, {"plots/body_momentum.svg"});
  check_kept(out, similar);
}

BOOST_AUTO_TEST_CASE(folders_within_go_only_where_they_are_empty) {
  command::Folder const folder;
  std::string const scene = folder.write("apophis.toml", command::apophis()), out = folder / "apophis";
  BOOST_TEST(command::actio({"run", scene, "--plots"}).status == 0);
  BOOST_TEST(command::actio({"run", scene, "--force"}).status == 0);
  BOOST_TEST(!fs::exists(out + "/plots"));
}

BOOST_AUTO_TEST_CASE(nothing_is_written_or_removed_through_a_link) {
  command::Folder const folder;
  std::string const scene = folder.write("apophis.toml", command::apophis()), out = folder / "apophis",
                    mine = folder.write("precious.txt", "precious");
  for (std::string const name : {"series.csv", "summary.json", "checkpoint", "scene.toml"}) {
    fs::remove_all(out);
    BOOST_TEST(command::actio({"run", scene}).status == 0);
    fs::remove(out + "/" + name);
    fs::create_symlink("../precious.txt", out + "/" + name);
    auto const before = all_of(out);
    auto const outcome = command::actio({"run", scene, "--force"});
    BOOST_TEST(outcome.status == 2);
    BOOST_TEST(outcome.err ==
               out + "/" + name +
                   ": is a link, and no file that actio wrote; move it away, or name another folder\n");
    BOOST_TEST((all_of(out) == before));
    BOOST_TEST(command::contents(mine) == "precious");
  }
  // A link to nothing, where the next run would write a file that the one before did not have.
  fs::remove_all(out);
  BOOST_TEST(command::actio({"run", scene}).status == 0);
  fs::create_symlink("../unborn.h5", out + "/series.h5");
  BOOST_TEST(command::actio({"run", scene, "--force", "--set", "output.formats=[\"hdf5\"]"}).status == 2);
  BOOST_TEST(!fs::exists(folder / "unborn.h5"));
  // A folder of pictures that is a link.
  fs::remove_all(out), fs::create_directory(folder / "elsewhere");
  put(folder / "elsewhere", {"energy.svg"});
  BOOST_TEST(command::actio({"run", scene}).status == 0);
  fs::create_directory_symlink("../elsewhere", out + "/plots");
  BOOST_TEST(command::actio({"run", scene, "--force", "--plots"}).status == 2);
  BOOST_TEST(command::actio({"run", scene, "--force"}).status == 0);
  BOOST_TEST((all_of(folder / "elsewhere") == Files{{"energy.svg", "energy.svg"}}));
  BOOST_TEST(fs::is_symlink(out + "/plots"));
}

BOOST_AUTO_TEST_CASE(a_folder_without_a_run_is_refused_and_left_as_it_is) {
  command::Folder const folder;
  std::string const scene = folder.write("apophis.toml", command::apophis()), out = folder / "mine";
  put(out, similar);
  put(out, {"series.csv", "checkpoint", "summary.json", "sweep.csv", "plots/energy.svg"});
  auto const before = all_of(out);
  for (auto const& arguments : std::vector<std::vector<std::string>>{
           {"run", scene, "--out", out, "--force"},
           {"sweep", scene, "--over", "scene.seed=1,2", "--out", out, "--force"}}) {
    auto const outcome = command::actio(arguments);
    BOOST_TEST(outcome.status == 2);
    BOOST_TEST(outcome.err.starts_with(out + ": --force replaces a "), outcome.err);
    BOOST_TEST((all_of(out) == before));
  }
}

BOOST_AUTO_TEST_CASE(a_list_that_names_files_elsewhere_removes_nothing) {
  command::Folder const folder;
  std::string const scene = folder.write("apophis.toml", command::apophis()), out = folder / "apophis",
                    mine = folder.write("precious.txt", "precious");
  for (std::string const name :
       {"../precious.txt", mine.c_str(), "plots/../../precious.txt", "a/b", "..", ""}) {
    fs::remove_all(out);
    BOOST_TEST(command::actio({"run", scene}).status == 0);
    std::ofstream(out + "/.actio", std::ios::app) << name << "\n";
    auto const before = all_of(out);
    BOOST_TEST(command::actio({"run", scene, "--force"}).status == 2);
    BOOST_TEST((all_of(out) == before));
    BOOST_TEST(command::contents(mine) == "precious");
  }
}

BOOST_AUTO_TEST_CASE(a_run_of_the_version_before_is_known_by_its_checkpoint) {
  command::Folder const folder;
  std::string const scene = folder.write("apophis.toml", command::apophis()), out = folder / "apophis";
  BOOST_TEST(command::actio({"run", scene, "--plots"}).status == 0);
  fs::remove(out + "/.actio");
  std::vector<std::string> const mine{"plots.py", "notes.md", "plots/mine.svg", "snapshots/paper_figure.pdf"};
  put(out, mine);
  BOOST_TEST(command::actio({"run", scene, "--force"}).status == 0);
  check_kept(out, mine);
  BOOST_TEST(!fs::exists(out + "/plots/index.html"));
  // A folder that merely has such names is none.
  fs::remove(out + "/.actio");
  std::ofstream(out + "/checkpoint") << "of my own";
  BOOST_TEST(command::actio({"run", scene, "--force"}).status == 2);
  BOOST_TEST(command::contents(out + "/checkpoint") == "of my own");
}

BOOST_AUTO_TEST_CASE(folders_of_six_digits_and_files_in_members_survive_a_sweep) {
  command::Folder const folder;
  std::string const scene = folder.write("apophis.toml", command::apophis()), out = folder / "data";
  auto const sweep = [&](std::string const& over, std::vector<std::string> more = {}) {
    more.insert(more.begin(), {"sweep", scene, "--over", over, "--out", out, "--quiet"});
    return command::actio(more);
  };
  // Beside data of one's own there is no sweep to replace.
  put(out, {"202401/raw.csv", "notes.md"});
  BOOST_TEST(sweep("scene.seed=1,2", {"--force"}).status == 2);
  BOOST_TEST((all_of(out) == Files{{"202401/raw.csv", "202401/raw.csv"}, {"notes.md", "notes.md"}}));
  fs::remove_all(out);
  BOOST_TEST(sweep("scene.seed=1:5:1").status == 0);
  // Of one's own: folders that look like members, one where the next sweep has a member, and files in
  // members.
  std::vector<std::string> const mine{"202401/raw.csv",        "000006/raw.csv",       "000000/notes.md",
                                      "000001/series.csv.bak", "000001/plots/fig.pdf", "sweep.csv.bak",
                                      "sweep.toml.orig",       ".results.old"};
  put(out, mine);
  BOOST_TEST(command::actio({"run", scene, "--out", out + "/000007", "--quiet"}).status == 0);
  auto const run_of_my_own = all_of(out + "/000007");
  BOOST_TEST(sweep("scene.seed=1:3:1", {"--force"}).status == 0);
  check_kept(out, mine);
  BOOST_TEST((all_of(out + "/000007") == run_of_my_own));
  BOOST_TEST(!fs::exists(out + "/000004"));
  // Members that would go into a folder of somebody else fail, and change nothing in it.
  auto const mixed = sweep("scene.seed=1:8:1", {"--force"});
  BOOST_TEST(mixed.status == 2);
  check_kept(out, mine);
  BOOST_TEST((all_of(out + "/000006") == Files{{"raw.csv", "000006/raw.csv"}}));
  BOOST_TEST((all_of(out + "/000007") == run_of_my_own));
  BOOST_TEST(command::contents(out + "/sweep.csv").find("what is in it is no member of this sweep") !=
             std::string::npos);
  // A run does not take the place of a sweep.
  auto const run = command::actio({"run", scene, "--out", out, "--force"});
  BOOST_TEST(run.status == 2);
  BOOST_TEST(run.err.find("there is a sweep in this folder") != std::string::npos, run.err);
}

BOOST_AUTO_TEST_CASE(links_in_the_folder_of_a_sweep_are_not_followed) {
  command::Folder const folder;
  std::string const scene = folder.write("apophis.toml", command::apophis()), out = folder / "sweep";
  std::vector<std::string> const arguments{"sweep", scene, "--over", "scene.seed=1,2",
                                           "--out", out,   "--force"};
  BOOST_TEST(command::actio(arguments).status == 0);
  // A member that was moved away, with a link in its place.
  fs::rename(out + "/000001", folder / "moved");
  fs::create_directory_symlink("../moved", out + "/000001");
  auto const before = all_of(folder / "moved");
  command::actio(arguments);
  BOOST_TEST((all_of(folder / "moved") == before));
  BOOST_TEST(fs::is_symlink(out + "/000001"));
}

BOOST_AUTO_TEST_CASE(a_sweep_of_the_version_before_is_known_by_its_table_and_its_checkpoints) {
  command::Folder const folder;
  std::string const scene = folder.write("apophis.toml", command::apophis()), out = folder / "sweep";
  std::vector<std::string> const arguments{"sweep", scene, "--over", "scene.seed=1,2",
                                           "--out", out,   "--force"};
  BOOST_TEST(command::actio(arguments).status == 0);
  for (char const* name : {"/.actio", "/.results", "/sweep.toml", "/000000/.actio", "/000001/.actio"})
    fs::remove(out + name);
  put(out, {"202401/raw.csv", "000001/notes.md"});
  auto const outcome = command::actio(arguments);
  BOOST_TEST(outcome.status == 0, outcome.err);
  check_kept(out, {"202401/raw.csv", "000001/notes.md"});
}

BOOST_AUTO_TEST_SUITE_END()
