// actio check: runs the programs with the theorem checks that stand beside it. Here these are scripts that
// answer as such programs do.
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <sstream>

#include "command.hpp"

namespace {

namespace fs = std::filesystem;
using command::Folder;
using command::Outcome;

bool has(std::string const& text, std::string const& part) { return text.find(part) != std::string::npos; }
long lines_in(std::string const& text) { return std::count(text.begin(), text.end(), '\n'); }

/// A folder with the command in it, and with programs that say that they have checks.
class Beside {
 public:
  Beside() { fs::copy_file(ACTIO_COMMAND, folder_ / "actio"); }
  Outcome check(std::string const& arguments) const {
    return command::shell("'" + (folder_ / "actio") + "' check " + arguments);
  }
  std::string operator/(std::string const& name) const { return folder_ / name; }

  /// A program with these checks, over one scalar; those in `failing` fail.
  void program(std::string const& name, std::vector<std::string> const& ids,
               std::vector<std::string> const& failing = {}) const {
    std::ostringstream script;
    script << "#!/bin/sh\nif [ \"$1\" = --list ]; then\n";
    for (auto const& id : ids) script << "  echo '{\"id\":\"" << id << "\"},'\n";
    script << "  exit 0\nfi\necho \"$@\" >>\"$0.log\"\nfor last; do :; done\nstatus=0 comma=\n"
              "{ printf '['\n";
    for (auto const& id : ids) {
      bool const fails = std::count(failing.begin(), failing.end(), id) > 0;
      script << "case \" $* \" in *' " << id << " '*)\n  printf '%s{\"id\":\"" << id
             << "\",\"title\":\"title of " << id
             << "\",\"verdict\":\"holds\",\"scalar\":\"double\",\"failures\":["
             << (fails ? "\"measured 3, allowed 2\"" : "") << "]}' \"$comma\"; comma=,\n";
      if (fails) script << "  status=201\n";
      script << "esac\n";
    }
    script << "printf ']'; } >\"$last/ch03_double.json\"\nexit $status\n";
    write(name, script.str());
  }
  void write(std::string const& name, std::string const& text) const {
    folder_.write(name, text);
    fs::permissions(folder_ / name, fs::perms::owner_all);
  }

 private:
  Folder folder_;
};

}  // namespace

BOOST_AUTO_TEST_SUITE(check)

BOOST_AUTO_TEST_CASE(checks_that_pass_have_a_line_each_and_status_0) {
  Beside const beside;
  beside.program("checks_ch03", {"eq_3_1", "thm_3_2_1", "eq_3_2"});
  auto const outcome = beside.check("thm_3_2_1 eq_3_1");
  BOOST_TEST(outcome.status == 0, outcome.err);
  BOOST_TEST(outcome.out ==
             "thm_3_2_1  holds       title of thm_3_2_1\neq_3_1     holds       title of eq_3_1\n");
  BOOST_TEST(has(outcome.err, "2 passed, 0 failed, over double"));
}

BOOST_AUTO_TEST_CASE(statements_are_named_as_in_the_thesis_too) {
  Beside const beside;
  beside.program("checks_ch03", {"eq_3_10", "thm_3_2_1"});
  auto const outcome = beside.check("'(3.10)' 'Theorem 3.2.1' eq_3_10");
  BOOST_TEST(outcome.status == 0, outcome.err);
  BOOST_TEST(outcome.out ==
             "eq_3_10    holds       title of eq_3_10\nthm_3_2_1  holds       title of thm_3_2_1\n");
}

BOOST_AUTO_TEST_CASE(what_was_corrected_is_told_where_the_statement_is_named) {
  Beside const beside;
  beside.write(
      "checks_ch03",
      "#!/bin/sh\n[ \"$1\" = --list ] && { echo '{\"id\":\"eq_3_1\"}'; exit 0; }\nfor last; do :; done\n"
      "cat >\"$last/a.json\" <<'END'\n[{\"id\":\"eq_3_1\",\"title\":\"the "
      "sum\",\"verdict\":\"corrected\",\"scalar\":\"double\",\"failures\":[],"
      "\"printed\":\"\\\\sum_{k=1}^N\",\"corrected\":\"\\\\sum_{k=0}^{N-1}\",\"note\":\"The first is left "
      "out.\"}]\nEND\n");
  BOOST_TEST(beside.check("eq_3_1").out ==
             "eq_3_1  corrected   the sum\n  printed       sum_(k=1)^N\n  corrected     sum_(k=0)^(N-1)\n"
             "  note          The first is left out.\n");
}

BOOST_AUTO_TEST_CASE(a_check_that_fails_is_status_1_and_says_why) {
  Beside const beside;
  beside.program("checks_ch03", {"eq_3_1", "thm_3_2_1"}, {"eq_3_1"});
  auto const outcome = beside.check("thm_3_2_1 eq_3_1");
  BOOST_TEST(outcome.status == 1);
  BOOST_TEST(has(outcome.out, "thm_3_2_1  holds"));
  BOOST_TEST(has(outcome.out, "eq_3_1     FAILED"));
  BOOST_TEST(has(outcome.err, "eq_3_1: double: measured 3, allowed 2"));
}

BOOST_AUTO_TEST_CASE(a_statement_named_twice_is_checked_once) {
  Beside const beside;
  beside.program("checks_ch03", {"eq_3_1"});
  BOOST_TEST(lines_in(beside.check("eq_3_1 eq_3_1").out) == 1);
}

BOOST_AUTO_TEST_CASE(a_program_that_dies_is_a_failure) {
  Beside const beside;
  beside.write("checks_ch03",
               "#!/bin/sh\n[ \"$1\" = --list ] && { echo '{\"id\":\"eq_3_1\"}'; exit 0; }\necho torn >&2\n"
               "kill -SEGV $$\n");
  auto const outcome = beside.check("eq_3_1");
  BOOST_TEST(outcome.status == 1);
  BOOST_TEST(has(outcome.out, "eq_3_1  FAILED"));
  BOOST_TEST(has(outcome.err, "status 139"));
  BOOST_TEST(has(outcome.err, "torn"));
}

BOOST_AUTO_TEST_CASE(only_the_programs_that_hold_the_statements_run) {
  Beside const beside;
  beside.program("checks_ch02", {"eq_2_1"});
  beside.program("checks_ch03", {"eq_3_1"});
  BOOST_TEST(beside.check("eq_3_1").status == 0);
  BOOST_TEST(!fs::exists(beside / "checks_ch02.log"));
}

BOOST_AUTO_TEST_CASE(reports_go_to_a_folder_that_is_gone_afterwards) {
  Beside const beside;
  beside.program("checks_ch03", {"eq_3_1"});
  BOOST_TEST(beside.check("eq_3_1").status == 0);
  std::string const words = command::contents(beside / "checks_ch03.log"),
                    folder = words.substr(words.find("--report ") + 9,
                                          words.size() - words.find("--report ") - 10);
  BOOST_TEST(!folder.empty());
  BOOST_TEST(folder.front() == '/');
  BOOST_TEST(!fs::exists(folder));
}

BOOST_AUTO_TEST_CASE(an_unknown_statement_is_status_2_with_the_nearest) {
  Beside const beside;
  auto const outcome = beside.check("thm_321");
  BOOST_TEST(outcome.status == 2);
  BOOST_TEST(outcome.err ==
             "actio check: unknown statement 'thm_321'; did you mean 'thm_3_2_1'? (actio check --list)\n");
}

BOOST_AUTO_TEST_CASE(a_statement_without_a_check_is_status_2_and_says_what_it_is_about) {
  std::string const listed = command::actio({"check", "--list"}).out;
  std::istringstream registry(command::contents(ACTIO_DATA "/../proofs_checks/registry.tsv"));
  for (std::string line; std::getline(registry, line);) {
    std::string const id = line.substr(0, line.find('\t'));
    if (id == "id" || id[0] == '#' || has("\n" + listed, "\n" + id + " ")) continue;
    auto const outcome = command::actio({"check", id});
    BOOST_TEST(outcome.status == 2);
    BOOST_TEST(outcome.err.starts_with("actio check: " + id + " is a statement of the thesis ("),
               outcome.err);
    BOOST_TEST(has(outcome.err, "but has no check yet"));
    return;
  }
}

BOOST_AUTO_TEST_CASE(checks_that_are_not_built_are_status_4_and_it_is_said_how_to_build_them) {
  Beside const beside;
  for (std::string const arguments : {"eq_3_1", ""}) {
    auto const outcome = beside.check(arguments);
    BOOST_TEST(outcome.status == 4);
    BOOST_TEST(has(outcome.err, "ninja -C build"), outcome.err);
    BOOST_TEST(has(outcome.err, "checks_ch03"), outcome.err);
  }
}

BOOST_AUTO_TEST_CASE(programs_older_than_the_sources_are_status_4) {
  Beside const beside;
  beside.program("checks_ch03", {"eq_3_1"});
  auto const outcome = beside.check("eq_3_1 eq_3_2");
  BOOST_TEST(outcome.status == 4);
  BOOST_TEST(has(outcome.out, "eq_3_1  holds"));
  BOOST_TEST(has(outcome.err, "older than the sources and have no check of eq_3_2"), outcome.err);
}

BOOST_AUTO_TEST_CASE(a_program_that_cannot_be_started_is_status_4) {
  Beside const beside;
  beside.write("checks_ch03", "no program");
  fs::permissions(beside / "checks_ch03", fs::perms::owner_read);
  BOOST_TEST(beside.check("eq_3_1").status == 4);
}

BOOST_AUTO_TEST_CASE(without_ids_everything_that_is_built_runs) {
  Beside const beside;
  std::vector<std::string> ids;
  std::istringstream listed(command::actio({"check", "--list"}).out);
  for (std::string line; std::getline(listed, line);) ids.push_back(line.substr(0, line.find(' ')));
  for (std::string const chapter :
       {"ch01", "ch02", "ch03", "ch04", "ch05", "ch06", "ch07", "ch08", "ch09", "ch10"})
    beside.program("checks_" + chapter, ids);
  auto const outcome = beside.check("");
  BOOST_TEST(outcome.status == 0, outcome.err);
  BOOST_TEST(lines_in(outcome.out) == static_cast<long>(ids.size()));
}

BOOST_AUTO_TEST_CASE(the_statements_that_are_listed_are_those_of_the_sources) {
  auto const listed = command::actio({"check", "--list"});
  BOOST_TEST(listed.status == 0);
  long sources = 0;
  for (auto const& entry : fs::directory_iterator(ACTIO_DATA "/../proofs_checks"))
    if (entry.path().extension() == ".cpp") {
      std::istringstream lines(command::contents(entry.path().string()));
      for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with("STATEMENT(")) continue;
        ++sources;
        // A long title stands on a line of its own, with the id.
        if (line.ends_with("(")) std::getline(lines >> std::ws, line), line.insert(0, "STATEMENT(");
        std::string const id = line.substr(10, line.find(',') - 10);
        BOOST_TEST(has("\n" + listed.out, "\n" + id + " "), id);
      }
    }
  BOOST_TEST(lines_in(listed.out) == sources);
}

BOOST_AUTO_TEST_SUITE_END()
