// What the command says to a line that it cannot take: status 2, one line, and what would be right. And its
// help.
#include <boost/test/unit_test.hpp>


#include "command.hpp"

namespace {

using command::actio;

bool has(std::string const& text, std::string const& part) { return text.find(part) != std::string::npos; }

struct Wrong {
  std::vector<std::string> arguments;
  std::string said;
};

}  // namespace

BOOST_AUTO_TEST_SUITE(usage)

BOOST_AUTO_TEST_CASE(a_line_that_cannot_be_taken_is_answered_in_one_line_with_what_would_be_right) {
  for (auto const& [arguments, said] : std::vector<Wrong>{
           {{"rnu"}, "actio: unknown command 'rnu'; did you mean 'run'? (actio --help)\n"},
           {{"apophis.toml"},
            "actio: unknown command 'apophis.toml'; did you mean 'actio run apophis.toml'? (actio --help)\n"},
           {{"help"}, "actio: unknown command 'help'; did you mean '--help'? (actio --help)\n"},
           {{"--verison"}, "actio: unknown option '--verison'; did you mean '--version'? (actio --help)\n"},
           {{"--quiet", "run", "a.toml"},
            "actio: '--quiet' belongs after the command: actio run ... --quiet (actio --help)\n"},
           {{"run"}, "actio run: which scene? For example: actio run apophis.toml (actio run --help)\n"},
           {{"run", ""}, "actio run: SCENE: a name is expected, found '' (actio run --help)\n"},
           {{"run", "--dry", "a.toml"},
            "actio run: unknown option '--dry'; did you mean '--dry-run'? (actio run --help)\n"},
           {{"run", "--outt", "d", "a.toml"},
            "actio run: unknown option '--outt'; did you mean '--out'? (actio run --help)\n"},
           {{"run", "a.toml", "--jobs", "2"},
            "actio run: unknown option '--jobs'; actio resume has it (actio run --help)\n"},
           {{"run", "a.toml", "b.toml"},
            "actio run: 'b.toml' is one too many; usage: actio run SCENE [OPTIONS] (actio run --help)\n"},
           {{"run", "--", "a.toml", "--out", "d"},
            "actio run: '--out' is one too many behind '--', where there are "
            "no options (actio run --help)\n"},
           {{"run", "a.toml", "--out"}, "actio run: --out DIR: DIR is missing (actio run --help)\n"},
           {{"run", "a.toml", "--out", "d", "--out", "e"},
            "actio run: --out is there twice (actio run --help)\n"},
           {{"run", "a.toml", "--quiet=yes"}, "actio run: --quiet takes no value (actio run --help)\n"},
           {{"resume"},
            "actio resume: which folder? One that a run left, for example: actio resume "
            "apophis (actio resume --help)\n"},
           {{"sweep", "a.toml"}, "actio sweep: --over KEY=VALUES is needed (actio sweep --help)\n"},
           {{"sweep", "a.toml", "--over", "method.step=1,2", "--jobs", "0"},
            "actio sweep: --jobs: a whole number from 1 on is expected, found '0' (actio sweep --help)\n"},
           {{"sweep", "a.toml", "--over", "method.step=1,2", "--jobs", "-1"},
            "actio sweep: --jobs: a whole number from 1 on is expected, found '-1' (actio sweep --help)\n"},
           {{"sweep", "a.toml", "--over", "method.step=1,2", "--jobs", "many"},
            "actio sweep: --jobs: a whole number from 1 on is expected, found 'many' (actio sweep --help)\n"},
           {{"show"},
            "actio show: which name? For example: actio show energy; actio list has "
            "the names (actio show --help)\n"},
           {{"check", "--lst"},
            "actio check: unknown option '--lst'; did you mean '--list'? (actio check --help)\n"},
       }) {
    auto const outcome = actio(arguments);
    BOOST_TEST(outcome.status == 2, said);
    BOOST_TEST(outcome.err == said);
    BOOST_TEST(outcome.out == "");
  }
}

BOOST_AUTO_TEST_CASE(a_scene_may_come_from_a_pipe_and_behind_two_dashes) {
  command::Folder const folder;
  std::string const scene = folder.write("a.toml", command::apophis());
  auto const in_bash = [&](std::string const& line) {
    return command::shell("export ACTIO; cd '" + (folder / "") + "' && bash -c '" + line + "'");
  };
  auto const piped = in_bash("\"$ACTIO\" run <(cat a.toml) --out piped --quiet");
  BOOST_TEST(piped.status == 0, piped.err);
  BOOST_TEST(in_bash("\"$ACTIO\" run --out dashed --quiet -- a.toml").status == 0);
  BOOST_TEST(command::contents(folder / "piped/series.csv") ==
             command::contents(folder / "dashed/series.csv"));
  auto const nameless = in_bash("\"$ACTIO\" run <(cat a.toml)");
  BOOST_TEST(nameless.status == 2);
  BOOST_TEST(
      nameless.err.find("a scene from a pipe has no name; --out names the folder") != std::string::npos,
      nameless.err);
}

BOOST_AUTO_TEST_CASE(what_was_typed_cannot_command_the_terminal) {
  for (auto const& arguments : {std::vector<std::string>{"\x1b[31m"},
                                {"show", "\x1b[31m"},
                                {"list", "\x1b[31m"},
                                {"check", "\x1b[31m"},
                                {"run", "a", "\x1b[31m"},
                                {"run", "--\x1b[31m"}}) {
    auto const outcome = actio(arguments);
    BOOST_TEST(outcome.status == 2);
    BOOST_TEST(!has(outcome.err, "\x1b"));
    BOOST_TEST(has(outcome.err, "\\u001b[31m"), outcome.err);
  }
}

BOOST_AUTO_TEST_CASE(options_stand_before_and_after_the_scene) {
  command::Folder const folder;
  std::string const scene = folder.write("a.toml", command::apophis());
  for (auto const& arguments : {std::vector<std::string>{"run", "--dry-run", scene},
                                {"run", scene, "--dry-run"},
                                {"run", "--out=" + (folder / "b"), scene, "--dry-run"},
                                {"run", "--dry-run", "--", scene}})
    BOOST_TEST(actio(arguments).status == 0);
}

BOOST_AUTO_TEST_CASE(the_command_alone_gives_its_help_and_status_2) {
  auto const alone = actio({}), help = actio({"--help"});
  BOOST_TEST(alone.status == 2);
  BOOST_TEST(help.status == 0);
  BOOST_TEST(alone.err == help.out);
}

BOOST_AUTO_TEST_CASE(help_tells_the_parts_an_example_and_the_exit_statuses) {
  std::string const help = actio({"-h"}).out;
  for (auto const& part : {"run", "resume", "sweep", "new", "list", "show", "check", "Example: actio run",
                           "0 done", "1 ", "2 the scene", "3 the numerics", "4 the disk", "130 interrupted"})
    BOOST_TEST(has(help, part), part);
}

BOOST_AUTO_TEST_CASE(every_part_has_a_help_with_an_example) {
  for (std::string const part : {"run", "resume", "sweep", "new", "list", "show", "check"}) {
    auto const outcome = actio({part, "--help"});
    BOOST_TEST(outcome.status == 0);
    BOOST_TEST(outcome.out.starts_with("usage: actio " + part + " "), outcome.out);
    BOOST_TEST(has(outcome.out, "Example: actio " + part), part);
    BOOST_TEST(outcome.err == "");
  }
}

BOOST_AUTO_TEST_CASE(the_version_is_that_of_the_project) {
  auto const outcome = actio({"--version"});
  BOOST_TEST(outcome.status == 0);
  BOOST_TEST(has(command::contents(ACTIO_DATA "/../CMakeLists.txt"),
                 "project(actio VERSION " + outcome.out.substr(6, outcome.out.size() - 7) + " "));
}

BOOST_AUTO_TEST_CASE(an_override_without_a_value_is_pointed_at) {
  command::Folder const folder;
  std::string const scene = folder.write("a.toml", command::apophis());
  for (std::string const argument : {"method.step", "=3", ""}) {
    auto const outcome = actio({"run", scene, "--set", argument});
    BOOST_TEST(outcome.status == 2);
    BOOST_TEST(outcome.err ==
               "--set " + argument + ":1:1: KEY=VALUE is expected, for example method.step=0.1\n");
  }
}

BOOST_AUTO_TEST_SUITE_END()
