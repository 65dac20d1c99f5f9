// The ledger: merges what the checks reported into one record a statement, and says whether the suite keeps
// its promise. A slip is counted where it occurs first.
//
//   ledger merge  REPORT            REPORT/checks/*.json -> REPORT/statements.json; prints the counts
//   ledger verify REPORT [--scalars double,rational]     of these columns alone, which must have been run
//       fails (status 1) on an owed statement without record, a record without control (but `scope`), scalars
//       that disagree on the verdict, a check that failed, evidence outside its bound, a control under its
//       floor, a slip that has another verdict where it occurs first, an id that is not in the registry
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace {

using nlohmann::ordered_json;
namespace fs = std::filesystem;

struct Statement {
  std::string id, kind, chapter, section, subject;
  bool owed = false;
};

std::vector<Statement> read_registry(std::string const& path) {
  std::ifstream in(path);
  if (!in) throw std::runtime_error("cannot read the registry " + path);
  std::vector<Statement> all;
  std::string line;
  std::getline(in, line);
  for (int number = 2; std::getline(in, line); ++number) {
    std::vector<std::string> cells;
    std::istringstream row(line);
    for (std::string cell; std::getline(row, cell, '\t');) cells.push_back(cell);
    if (cells.size() < 6)
      throw std::runtime_error(path + ":" + std::to_string(number) + ": six columns are needed, there are " +
                               std::to_string(cells.size()));
    all.push_back({cells[0], cells[1], cells[2], cells[3], cells[4], cells[5] == "yes"});
  }
  return all;
}

/// All records, by id; of these scalars, where some are named.
std::map<std::string, std::vector<ordered_json>> read_records(fs::path const& report,
                                                              std::set<std::string> const& scalars = {}) {
  std::map<std::string, std::vector<ordered_json>> records;
  if (!fs::is_directory(report / "checks")) return records;
  std::vector<fs::path> files;
  for (auto const& entry : fs::directory_iterator(report / "checks"))
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (auto const& file : files) {
    std::ifstream in(file);
    ordered_json const all = ordered_json::parse(in, nullptr, false);
    if (all.is_discarded() || !all.is_array())
      throw std::runtime_error(file.string() + ": not a report; run the checks again");
    for (auto const& record : all)
      if (scalars.empty() || scalars.contains(record.at("scalar").get<std::string>()))
        records[record.at("id")].push_back(record);
  }
  return records;
}

/// One record from those of several scalars: the strongest kind first.
ordered_json merged(std::vector<ordered_json> parts) {
  std::map<std::string, int> const rank = {{"rational", 0}, {"prime", 1},  {"double", 2},
                                           {"dec50", 3},    {"dec100", 4}, {"ball", 5}};
  auto const place = [&](ordered_json const& part) {
    return rank.contains(part.at("scalar")) ? rank.at(part.at("scalar")) : 9;
  };
  std::stable_sort(parts.begin(), parts.end(),
                   [&](auto const& a, auto const& b) { return place(a) < place(b); });
  ordered_json one = parts.front();
  one.erase("scalar");
  one["scalars"] = ordered_json::array();
  for (std::string const key : {"evidence", "control", "failures"}) one[key] = ordered_json::array();
  // One column may say what it leaves, and another not run what would say so.
  for (auto const& part : parts)
    if (part.value("left", "") != "") one["left"] = part["left"];
  double seconds = 0;
  for (auto const& part : parts) {
    one["scalars"].push_back(part["scalar"]);
    seconds += part["seconds"].get<double>();
    for (std::string const key : {"evidence", "control", "failures"})
      for (auto const& item : part[key]) one[key].push_back(item);
    if (part["verdict"] != one["verdict"]) one["failures"].push_back("the scalars disagree on the verdict");
  }
  one["seconds"] = seconds;
  return one;
}

void write(fs::path const& path, std::string const& text) {
  fs::path const unfinished = path.string() + ".part";
  std::ofstream out(unfinished);
  out << text;
  out.close();
  if (!out) throw std::runtime_error("cannot write " + unfinished.string());
  fs::rename(unfinished, path);
}

int merge(fs::path const& report) {
  auto const registry = read_registry(ACTIO_REGISTRY);
  auto const records = read_records(report);
  ordered_json all = ordered_json::array();
  std::map<std::string, int> counts;
  int partial = 0;
  int owed = 0, kept = 0, slips = 0, perhaps_the_scan = 0;
  for (auto const& statement : registry) {
    ordered_json one;
    if (auto const found = records.find(statement.id); found != records.end())
      one = merged(found->second);
    else
      one = {{"id", statement.id}, {"title", statement.subject}, {"verdict", "pending"}};
    one["kind"] = statement.kind, one["chapter"] = statement.chapter, one["section"] = statement.section;
    one["subject"] = statement.subject, one["owed"] = statement.owed;
    std::string const verdict = one["verdict"];
    partial += one.value("left", "") != "";
    ++counts[verdict.empty() ? "failed" : verdict];
    bool const slip = verdict == "corrected" && one.value("first", "") == "";
    slips += slip, perhaps_the_scan += slip && one.value("scan", false);
    owed += statement.owed, kept += statement.owed && verdict != "pending" && !verdict.empty();
    all.push_back(one);
  }
  write(report / "statements.json", all.dump(1) + "\n");
  std::cout << registry.size() << " statements: ";
  for (auto const* verdict : {"holds", "convention", "corrected", "scope", "failed", "pending"})
    if (counts[verdict]) std::cout << counts[verdict] << ' ' << verdict << "  ";
  std::cout << "(" << kept << " of " << owed << " owed, " << partial << " say what they leave)\n"
            << slips << " distinct slips, " << perhaps_the_scan << " of them perhaps the scan's\n";
  return 0;
}

int verify(fs::path const& report, std::set<std::string> const& scalars) {
  auto const registry = read_registry(ACTIO_REGISTRY);
  auto const records = read_records(report, scalars);
  std::set<std::string> known;
  std::vector<std::string> complaints;
  auto const complain = [&](std::string const& id, std::string const& what) {
    complaints.push_back(id + ": " + what);
  };

  for (auto const& statement : registry) {
    known.insert(statement.id);
    auto const found = records.find(statement.id);
    if (found == records.end()) {
      if (statement.owed) complain(statement.id, "owed, and no check has reported a record");
      continue;
    }
    auto const one = merged(found->second);
    std::string const verdict = one["verdict"];
    if (!std::set<std::string>{"holds", "convention", "corrected", "scope"}.contains(verdict))
      complain(statement.id, "verdict '" + verdict + "' is none");
    if (verdict != "scope") {
      if (one["evidence"].empty()) complain(statement.id, "no evidence");
      if (one["control"].empty()) complain(statement.id, "no control: nothing shows that the check can fail");
    }
    if ((verdict == "convention" || verdict == "scope" || verdict == "corrected") && one["note"] == "")
      complain(statement.id, "the verdict needs a note");
    if (verdict == "corrected" && (one["printed"] == "" || one["corrected"] == ""))
      complain(statement.id, "corrected, without printed and corrected form");
    // A slip has one verdict wherever it returns; a statement that only rests on what was put right elsewhere
    // is judged with that.
    if (std::string const first = one.value("first", ""); first != "") {
      auto const origin = records.find(first);
      if (origin == records.end())
        complain(statement.id, "its slip occurs first in '" + first + "', which has no record");
      else if (std::string const there = origin->second.front()["verdict"];
               there != verdict && !(there == "corrected" && verdict == "convention"))
        complain(statement.id,
                 "its slip is '" + there + "' in " + first + ", and here it is '" + verdict + "'");
      else if (origin->second.front().value("first", "") != "")
        complain(statement.id, "its slip occurs in " + first + ", and there it is not the first");
    }
    for (auto const& failure : one["failures"]) complain(statement.id, failure.get<std::string>());
    for (auto const& e : one["evidence"])
      if (e["measured"].is_null() || e["measured"].get<double>() > e["bound"].get<double>())
        complain(statement.id, "evidence outside its bound: " + e["what"].get<std::string>());
    for (auto const& c : one["control"])
      if (c["measured"].is_null() || c["measured"].get<double>() <= c["floor"].get<double>())
        complain(statement.id, "control under its floor: " + c["what"].get<std::string>());
    std::set<std::string> ran;
    for (auto const& scalar : one["scalars"]) ran.insert(scalar.get<std::string>());
    for (auto const& scalar : scalars)
      if (!ran.contains(scalar)) complain(statement.id, "not run over " + scalar);
  }
  for (auto const& [id, unused] : records)
    if (!known.contains(id)) complain(id, "not in the registry");

  for (auto const& complaint : complaints) std::cerr << complaint << '\n';
  std::cout << (complaints.empty() ? "the ledger is complete\n"
                                   : std::to_string(complaints.size()) + " complaints\n");
  return complaints.empty() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> const arguments(argv + 1, argv + argc);
  try {
    if (arguments.size() == 2 && arguments[0] == "merge") return merge(arguments[1]);
    if (arguments.size() >= 2 && arguments[0] == "verify") {
      std::set<std::string> scalars;
      if (arguments.size() == 4 && arguments[2] == "--scalars") {
        std::istringstream list(arguments[3]);
        for (std::string scalar; std::getline(list, scalar, ',');) scalars.insert(scalar);
      } else if (arguments.size() != 2) {
        std::cerr << "usage: ledger merge REPORT | ledger verify REPORT [--scalars A,B]\n";
        return 2;
      }
      return verify(arguments[1], scalars);
    }
  } catch (std::exception const& error) {
    std::cerr << "ledger: " << error.what() << '\n';
    return 4;
  }
  std::cerr << "usage: ledger merge REPORT | ledger verify REPORT [--scalars A,B]\n";
  return 2;
}
