// actio check: runs the theorem checks, which are programs beside this one, and tells how each statement
// fared.
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "actio/numbers/nearest_name.hpp"
#include "app/child.hpp"
#include "app/commands.hpp"
#include "app/ledger.hpp"
#include "program/base/error.hpp"
#include "program/base/printable.hpp"
#include "program/catalogue/statements.hpp"

namespace actio::app {

using namespace scene;

namespace {

namespace fs = std::filesystem;

/// What the checks of one statement said, over all scalars.
struct Result {
  std::string title, verdict, printed, corrected, note;
  std::set<std::string> scalars;
  std::vector<std::string> failures;
};
using Results = std::map<std::string, Result>;

/// Statements whose checks are wanted, in the order asked for; all that have one where none is named.
std::vector<Statement const*> wanted(std::vector<std::string> const& ids) {
  std::vector<Statement const*> out;
  if (ids.empty())
    for (auto const& statement : statements())
      if (statement.checked) out.push_back(&statement);
  std::vector<std::string> known;
  for (auto const& statement : statements()) known.push_back(statement.id);
  for (auto const& id : ids) {
    auto const meant = find_statements(id);
    if (meant.empty())
      throw SceneError({"actio check"}, fmt::format("unknown statement '{}'{} (actio check --list)",
                                                    shown(id), did_you_mean(id, known)));
    for (auto const* const statement : meant) {
      if (!statement->checked)
        throw SceneError({"actio check"},
                         fmt::format("{} is a statement of the thesis ({}), but has no check yet",
                                     statement->id, statement->subject));
      if (std::find(out.begin(), out.end(), statement) == out.end()) out.push_back(statement);
    }
  }
  return out;
}

/// The program that checks each chapter.
std::map<std::string, fs::path> programs_beside() {
  static std::regex const name("checks_ch0*([0-9]+)");
  std::map<std::string, fs::path> out;
  std::error_code none;
  for (fs::directory_iterator it(folder_of_this_program(), none), end; !none && it != end;
       it.increment(none)) {
    std::smatch match;
    std::string const file = it->path().filename().string();
    if (!std::regex_match(file, match, name)) continue;
    out[match[1]] = it->path();
  }
  return out;
}

std::string how_to_build(std::vector<std::string> const& chapters) {
  std::string targets, places;
  for (auto const& chapter : chapters) {
    targets += fmt::format(" checks_ch{:0>2}", chapter);
    places += (places.empty() ? "" : ", ") + chapter;
  }
  return fmt::format(
      "actio check: the checks of chapter {} are not beside this command, in {}; in the folder of the "
      "sources, `ninja -C build{}` builds them",
      places, folder_of_this_program().string(), targets);
}

/// The statements that a program has checks of.
std::set<std::string> held_by(fs::path const& program) {
  std::set<std::string> ids;
  // A line for each statement: {"id":"eq_3_1",...
  std::istringstream lines(run_child({program.string(), "--list"}).output);
  static std::string const before = "\"id\":\"";
  for (std::string line; std::getline(lines, line);)
    if (std::size_t const at = line.find(before); at != std::string::npos) {
      std::size_t const first = at + before.size();
      ids.insert(line.substr(first, line.find('"', first) - first));
    }
  return ids;
}

/// Adds what a program reported of its statements.
void read_reports(fs::path const& folder, Results& results) {
  for (auto const& entry : fs::directory_iterator(folder)) {
    std::ifstream in(entry.path());
    for (auto const& record : nlohmann::json::parse(in)) {
      Result& result = results[record.at("id").get<std::string>()];
      result.title = record.at("title").get<std::string>();
      result.verdict = record.at("verdict").get<std::string>();
      result.printed = record.value("printed", "");
      result.corrected = record.value("corrected", "");
      result.note = record.value("note", "");
      std::string const scalar = record.at("scalar").get<std::string>();
      result.scalars.insert(scalar);
      for (auto const& failure : record.at("failures"))
        result.failures.push_back(scalar + ": " + failure.get<std::string>());
    }
  }
}

/// Runs the checks of these statements in a program; all that it has where none is named.
/// @return 130 where it was interrupted, otherwise 0
int run_checks(fs::path const& program, std::vector<std::string> const& ids, Results& results) {
  PassingFolder const reports;  // those of the build stay as they are
  std::vector<std::string> words{program.string()};
  words.insert(words.end(), ids.begin(), ids.end());
  for (char const* const word : {"--brief", "--columns", "all", "--report"}) words.emplace_back(word);
  words.push_back(reports.path().string());
  ChildOutcome const outcome = run_child(words);
  if (outcome.status == 130) return 130;
  Results here;
  try {
    read_reports(reports.path(), here);
  } catch (nlohmann::json::exception const& error) {
    throw FileError(program.string() + ": its report cannot be read: " + error.what());
  }
  bool const explained =
      std::any_of(here.begin(), here.end(), [](auto const& entry) { return !entry.second.failures.empty(); });
  for (auto const& id : ids)
    if (!here.count(id))
      here[id].failures.push_back(fmt::format("{} ended with status {} and reported nothing of it",
                                              program.filename().string(), outcome.status));
  if (outcome.status != 0 && !explained)
    fmt::print(stderr, "{} ended with status {}:\n{}", program.filename().string(), outcome.status,
               outcome.output);
  results.merge(here);
  return 0;
}

/// A line for the statement.
/// @param why  whether what was corrected, and the note, are told below it
/// @return whether it is well
bool tell(Statement const& statement, Result const& result, std::size_t width, bool why) {
  bool const well = result.failures.empty();
  fmt::print("{:<{}}  {:<10}  {}\n", statement.id, width, well ? result.verdict : "FAILED",
             result.title.empty() ? statement.subject : result.title);
  if (well && why && result.verdict != "holds")
    fmt::print("{}", verdict_in_words(result.printed, result.corrected, result.note));
  std::fflush(stdout);
  for (auto const& failure : result.failures) fmt::print(stderr, "  {}: {}\n", statement.id, failure);
  return well;
}

}  // namespace

int check(std::vector<std::string> const& ids) {
  auto const programs = programs_beside();
  std::map<std::string, std::vector<Statement const*>> by_chapter;
  std::vector<std::string> chapters, missing, stale;
  std::size_t width = 0;
  for (auto const* const statement : wanted(ids)) {
    auto& chapter = by_chapter[statement->chapter];
    if (chapter.empty())
      (programs.count(statement->chapter) ? chapters : missing).push_back(statement->chapter);
    chapter.push_back(statement);
    width = std::max(width, statement->id.size());
  }
  if (chapters.empty() || (!ids.empty() && !missing.empty())) throw FileError(how_to_build(missing));

  std::size_t well = 0, failed = 0;
  std::set<std::string> scalars;
  for (auto const& chapter : chapters) {
    auto const held = held_by(programs.at(chapter));
    std::vector<std::string> here;
    for (auto const* const statement : by_chapter[chapter])
      (held.count(statement->id) ? here : stale).push_back(statement->id);
    Results results;
    if (!here.empty() && run_checks(programs.at(chapter), here, results) == 130) return 130;
    for (auto const& id : here) {
      ++(tell(*find_statement(id), results[id], width, !ids.empty()) ? well : failed);
      scalars.insert(results[id].scalars.begin(), results[id].scalars.end());
    }
  }
  fmt::print(stderr, "{} passed, {} failed{}\n", well, failed,
             scalars.empty() ? "" : ", over " + listed({scalars.begin(), scalars.end()}));
  if (failed) return 1;
  if (!missing.empty()) throw FileError(how_to_build(missing));
  if (!stale.empty())
    throw FileError(
        fmt::format("actio check: the programs in {} are older than the sources and have "
                    "no check of {}; build them again",
                    folder_of_this_program().string(), listed(stale)));
  return 0;
}

int list_statements() {
  for (auto const& statement : statements())
    if (statement.checked) fmt::print("{:<40}  {}\n", statement.id, statement.subject);
  return 0;
}

}  // namespace actio::app
