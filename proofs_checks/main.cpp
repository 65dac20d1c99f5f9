// Runs the checks of this program under Boost.Test: one suite per scalar, one case per statement, named after it.
//
//   checks_ch03 [Boost.Test's options] -- [--columns double,rational|all] [--report DIR] [--seed N]
//
// With --report, DIR/chNN_SCALAR.json receives the records, failed ones included; that of a scalar which no check here is compiled for any more is removed.
// The exit status is Boost.Test's.
#define BOOST_TEST_NO_MAIN
#define BOOST_TEST_ALTERNATIVE_INIT_API
#include <boost/test/unit_test.hpp>

#include <chrono>
#include <filesystem>
#include <iostream>
#include <map>
#include <set>
#include <sstream>

#include "book/json.hpp"

#define ACTIO_SCALAR double
#define ACTIO_SCALAR_NAME "double"
#include "statement.hpp"

namespace actio::checks {

std::vector<Check>& all_checks() {
  static std::vector<Check> checks;
  return checks;
}
bool add_check(Check const& check) {
  all_checks().push_back(check);
  return true;
}

}  // namespace actio::checks

namespace {

using actio::checks::Check;
using actio::checks::Record;
namespace json = book::json;

struct Options {
  std::string columns = "all", report;
  std::uint64_t seed = 20000518;
} options;

std::map<std::string, std::vector<Record>> reports;  // by chapter_scalar

std::string numbers(std::vector<double> const& xs) {
  std::vector<std::string> out;
  for (double x : xs) out.push_back(json::number(x));
  return json::array(out);
}

std::string in_json(Record const& r) {
  std::vector<std::string> evidence, control;
  for (auto const& e : r.evidence)
    evidence.push_back("{\"what\":" + json::quote(e.what) + ",\"kind\":" + json::quote(e.kind) + ",\"scalar\":" + json::quote(e.scalar) +
                       ",\"model\":" + json::quote(e.model) + ",\"measured\":" + json::number(e.measured) + ",\"bound\":" + json::number(e.bound) +
                       ",\"epsilon\":" + json::number(e.epsilon) + ",\"steps\":" + numbers(e.steps) + ",\"errors\":" + numbers(e.errors) +
                       ",\"slope\":" + json::number(e.slope) + ",\"spread\":" + json::number(e.spread) + ",\"degree\":" + std::to_string(e.degree) +
                       ",\"points\":" + std::to_string(e.points) + ",\"probability\":" + json::number(e.probability) + "}");
  for (auto const& c : r.control)
    control.push_back("{\"what\":" + json::quote(c.what) + ",\"scalar\":" + json::quote(c.scalar) + ",\"model\":" + json::quote(c.model) +
                      ",\"measured\":" + json::number(c.measured) + ",\"floor\":" + json::number(c.floor) + ",\"points\":" + std::to_string(c.points) + "}");
  return "{\"id\":" + json::quote(r.id) + ",\"title\":" + json::quote(r.title) + ",\"verdict\":" + json::quote(r.verdict) + ",\"printed\":" +
         json::quote(r.printed) + ",\"corrected\":" + json::quote(r.corrected) + ",\"note\":" + json::quote(r.note) + ",\"scan\":" +
         (r.scan ? "true" : "false") + ",\"scalar\":" + json::quote(r.scalar) + ",\n  \"evidence\":" + json::array(evidence) + ",\n  \"control\":" +
         json::array(control) + ",\n  \"failures\":" + json::strings(r.failures) + ",\"seed\":" + std::to_string(r.seed) + ",\"source\":" +
         json::quote(r.source) + ",\"seconds\":" + json::number(r.seconds) + "}";
}

/// `proofs_checks/ch03_2.cpp` from the path the compiler was given.
std::string source_in_tree(std::string const& path) { return "proofs_checks/" + std::filesystem::path(path).filename().string(); }
/// `ch03` from `ch03_2.cpp`.
std::string chapter_of(std::string const& path) {
  auto const stem = std::filesystem::path(path).stem().string();
  return stem.substr(0, stem.find('_'));
}

std::string worst(Record const& r) {
  std::ostringstream out;
  out << r.scalar << ' ' << r.id << " [" << r.verdict << "]";
  for (auto const& e : r.evidence) {
    out << "\n    " << e.what << " (" << e.model << "): ";
    if (e.kind == "order") out << "order " << e.slope << " +- " << e.spread;
    else if (e.epsilon > 0) out << e.measured / e.epsilon << " epsilon, allowed " << e.bound / e.epsilon;
    else out << e.measured << " at " << e.points << " points";
  }
  for (auto const& c : r.control) out << "\n    control: " << c.what << " (" << c.model << "): " << c.measured << ", floor " << c.floor;
  return out.str();
}

void run(Check const& check) {
  auto const start = std::chrono::steady_clock::now();
  Record record;
  try {
    record = check.run(check, options.seed);
  } catch (std::exception const& error) {
    record.id = check.id, record.title = check.title, record.scalar = check.scalar, record.seed = options.seed;
    record.failures.push_back(std::string("threw: ") + error.what());
  }
  record.source = source_in_tree(check.source);
  record.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (record.verdict.empty()) record.failures.push_back("no verdict was given");
  BOOST_TEST_MESSAGE(worst(record));
  for (auto const& failure : record.failures) BOOST_ERROR(record.scalar + " " + record.id + ": " + failure);
  BOOST_TEST(record.failures.empty());
  reports[chapter_of(check.source) + "_" + check.scalar].push_back(std::move(record));
}

bool wanted(std::string const& scalar) {
  if (options.columns == "all") return true;
  return ("," + options.columns + ",").find("," + scalar + ",") != std::string::npos;
}

/// Removes what an earlier program reported over scalars that this one was asked for and has no checks at: the ledger would still count it.
void forget_reports() {
  std::set<std::string> chapters, held;
  for (Check const& check : actio::checks::all_checks()) {
    std::string const chapter = chapter_of(check.source);
    chapters.insert(chapter);
    held.insert(chapter + "_" + check.scalar);
  }
  for (auto const& chapter : chapters)
    for (std::string const scalar : {"rational", "double", "dec50", "dec100"})
      if (wanted(scalar) && !held.contains(chapter + "_" + scalar)) std::filesystem::remove(std::filesystem::path(options.report) / (chapter + "_" + scalar + ".json"));
}

bool read_options() {
  auto const& suite = boost::unit_test::framework::master_test_suite();
  for (int i = 1; i < suite.argc; ++i) {
    std::string const key = suite.argv[i];
    if (key == "--") continue;
    if (i + 1 >= suite.argc) {
      std::cerr << "option '" << key << "' needs a value\n";
      return false;
    }
    std::string const value = suite.argv[++i];
    if (key == "--columns") options.columns = value;
    else if (key == "--report") options.report = value;
    else if (key == "--seed") options.seed = std::stoull(value);
    else {
      std::cerr << "unknown option '" << key << "'; there are --columns, --report and --seed\n";
      return false;
    }
  }
  return true;
}

bool add_suites() {
  if (!read_options()) return false;
  std::map<std::string, boost::unit_test::test_suite*> suites;
  for (Check const& check : actio::checks::all_checks()) {
    if (!wanted(check.scalar)) continue;
    auto*& suite = suites[check.scalar];
    if (!suite) {
      suite = BOOST_TEST_SUITE(check.scalar);
      boost::unit_test::framework::master_test_suite().add(suite);
    }
    suite->add(boost::unit_test::make_test_case([&check] { run(check); }, check.id, check.source, 1));
  }
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  int const status = boost::unit_test::unit_test_main(&add_suites, argc, argv);
  if (options.report.empty()) return status;
  forget_reports();
  for (auto const& [name, records] : reports) {
    std::vector<std::string> lines;
    for (auto const& r : records) lines.push_back(in_json(r));
    try {
      json::write_file(std::filesystem::path(options.report) / (name + ".json"), json::array(lines) + "\n");
    } catch (std::exception const& error) {
      std::cerr << error.what() << '\n';
      return 4;
    }
  }
  return status;
}
