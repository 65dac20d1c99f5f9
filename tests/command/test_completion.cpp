// Completion for bash, and the man page: that they know what the command knows.
#include <boost/test/unit_test.hpp>

#include <set>
#include <sstream>

#include "command.hpp"

namespace {

std::string const script = ACTIO_DATA "/../src/app/completion.bash", page = ACTIO_DATA "/../src/app/actio.1";
std::vector<std::string> const parts{"run", "resume", "plot", "export", "sweep",
                                     "new", "list",   "show", "check"};

std::set<std::string> lines_of(std::string const& text) {
  std::set<std::string> out;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) out.insert(line);
  return out;
}

/// What bash offers where the last of the words is being typed; `folder` is where it stands.
std::set<std::string> offered(std::vector<std::string> const& words, std::string const& folder = "/") {
  std::string line =
      "cd '" + folder + "'; bash -c 'source \"" + script + "\"; COMP_WORDS=(\"" + ACTIO_COMMAND + "\"";
  for (auto const& word : words) line += " \"" + word + "\"";
  line +=
      "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _actio; for reply in "
      "\"${COMPREPLY[@]}\"; do echo \"$reply\"; done'";
  auto const outcome = command::shell(line);
  BOOST_TEST(outcome.err == "");
  return lines_of(outcome.out);
}

/// The options in a help text.
std::set<std::string> options_in(std::string const& help) {
  std::set<std::string> out;
  for (std::size_t at = help.find("--"); at != std::string::npos; at = help.find("--", at + 2)) {
    std::size_t const end = help.find_first_not_of("abcdefghijklmnopqrstuvwxyz-", at);
    out.insert(help.substr(at, end - at));
  }
  return out;
}

using Names = std::set<std::string>;

}  // namespace

BOOST_AUTO_TEST_SUITE(completion)

BOOST_AUTO_TEST_CASE(parts_are_completed) {
  BOOST_TEST(offered({""}) == Names(parts.begin(), parts.end()), boost::test_tools::per_element());
  BOOST_TEST(offered({"s"}) == (Names{"sweep", "show"}), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(the_options_of_a_part_are_those_of_its_help) {
  for (auto const& part : parts) {
    std::string const help = command::actio({part, "--help"}).out;
    // Those of the example belong to it as well.
    BOOST_TEST(offered({part, "--"}) == options_in(help), boost::test_tools::per_element());
  }
  BOOST_TEST(offered({"--"}) == (Names{"--help", "--version"}), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(lists_and_names_are_completed) {
  BOOST_TEST(offered({"list", "b"}) == Names{"bodies"}, boost::test_tools::per_element());
  BOOST_TEST(offered({"show", "apop"}) == (Names{"apophis", "apophis_damped"}),
             boost::test_tools::per_element());
  BOOST_TEST(offered({"show", "run.e"}) == Names{"run.every"}, boost::test_tools::per_element());
  BOOST_TEST(offered({"new", "heavy"}) == Names{"heavy_top"}, boost::test_tools::per_element());
  BOOST_TEST(offered({"new", "rigid_body", "--body", "to"}) == Names{"toutatis"},
             boost::test_tools::per_element());
  BOOST_TEST(offered({"run", "nodd"}) == (Names{"nodding_top", "nodding_top_lagrangian"}),
             boost::test_tools::per_element());
  BOOST_TEST(offered({"show", "SO"}) == Names{"SO\\(n\\)"}, boost::test_tools::per_element());
  BOOST_TEST(offered({"check", "thm_3_2_"}).count("thm_3_2_1") == 1u);
}

BOOST_AUTO_TEST_CASE(scenes_and_folders_are_completed) {
  command::Folder const folder;
  folder.write("apophis.toml", "");
  folder.write("notes.txt", "");
  std::filesystem::create_directory(folder / "old run");
  BOOST_TEST(offered({"run", ""}, folder / "") == (Names{"apophis.toml", "old run"}),
             boost::test_tools::per_element());
  BOOST_TEST(offered({"resume", ""}, folder / "") == Names{"old run"}, boost::test_tools::per_element());
  BOOST_TEST(offered({"run", "apophis.toml", "--out", ""}, folder / "") == Names{"old run"},
             boost::test_tools::per_element());
  BOOST_TEST(offered({"run", "--out", "=", "o"}, folder / "") == Names{"old run"},
             boost::test_tools::per_element());
  BOOST_TEST(offered({"run", "--out", "="}, folder / "") == Names{"old run"},
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(man_page)

BOOST_AUTO_TEST_CASE(the_page_is_sound) {
  if (command::shell("command -v groff").status != 0) return;
  auto const outcome = command::shell("groff -man -ww -Tutf8 '" + page + "'");
  BOOST_TEST(outcome.status == 0);
  BOOST_TEST(outcome.err == "");
}

BOOST_AUTO_TEST_CASE(every_option_of_the_help_and_every_exit_status_is_in_the_page) {
  std::string text = command::contents(page);
  for (std::size_t at; (at = text.find("\\-")) != std::string::npos;) text.replace(at, 2, "-");
  for (auto const& part : parts) {
    BOOST_TEST(text.find("\n.B " + part + "\n") != std::string::npos, part);
    for (auto const& option : options_in(command::actio({part, "--help"}).out))
      BOOST_TEST(text.find(option) != std::string::npos, option);
  }
  for (auto const& option : options_in(command::actio({"--help"}).out))
    BOOST_TEST(text.find(option) != std::string::npos, option);
  for (auto const& status : {"0", "1", "2", "3", "4", "130"})
    BOOST_TEST(text.find(std::string("\n.TP\n.B ") + status + "\n") != std::string::npos, status);
}

BOOST_AUTO_TEST_SUITE_END()
