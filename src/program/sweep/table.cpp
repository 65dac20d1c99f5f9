#include "program/sweep/table.hpp"

#include <charconv>
#include <unordered_map>

namespace actio::scene {
namespace {

/// A cell, between quotes where it holds a comma, a quote or an end of line.
std::string cell(std::string const& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string out = "\"";
  for (char const c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + '"';
}
std::string cell(double x) {
  char digits[32];
  return {digits, std::to_chars(digits, digits + sizeof digits, x, std::chars_format::general, 17).ptr};
}

/// Names in the order in which they first come.
class Names {
 public:
  void add(std::string const& name) {
    if (at_.emplace(name, all_.size()).second) all_.push_back(name);
  }
  std::vector<std::string> const& all() const { return all_; }
  std::size_t at(std::string const& name) const { return at_.at(name); }

 private:
  std::vector<std::string> all_;
  std::unordered_map<std::string, std::size_t> at_;
};

/// What the members have to tell.
struct Columns {
  Names drift, error, last;
  explicit Columns(std::vector<MemberResult> const& results) {
    for (auto const& result : results) {
      if (result.status != 0) continue;
      for (auto const& entry : result.drift) drift.add(entry.name);
      for (auto const& entry : result.error) error.add(entry.name);
      for (auto const& name : result.columns) last.add(name);
    }
  }
};

std::string heading(SweepPlan const& plan, Columns const& columns) {
  std::string out = "member";
  for (auto const& key : plan.keys()) out += "," + cell(key.key);
  out += ",status,steps,wall_seconds";
  for (auto const& name : columns.drift.all()) out += ",drift_" + name;
  for (auto const& name : columns.error.all()) out += ",error_" + name;
  for (auto const& name : columns.last.all()) out += ",last_" + name;
  return out + ",message\n";
}

std::string row(SweepPlan const& plan, Columns const& columns, MemberResult const& result) {
  std::size_t const errors = 2 + columns.drift.all().size(), last = errors + columns.error.all().size();
  std::vector<std::string> cells(last + columns.last.all().size());
  if (result.status == 0) {
    cells[0] = std::to_string(result.steps), cells[1] = cell(result.seconds);
    for (auto const& entry : result.drift) cells[2 + columns.drift.at(entry.name)] = cell(entry.relative);
    for (auto const& entry : result.error)
      if (entry.told()) cells[errors + columns.error.at(entry.name)] = cell(entry.error);
    for (std::size_t i = 0; i < result.last_row.size(); ++i)
      cells[last + columns.last.at(result.columns[i])] = cell(result.last_row[i]);
  }
  std::string out = std::to_string(result.member);
  for (auto const& value : plan.values(result.member)) out += "," + cell(value);
  out += "," + std::to_string(result.status);
  for (auto const& text : cells) out += "," + text;
  return out + "," + cell(result.message) + "\n";
}

}  // namespace

std::string sweep_table(SweepPlan const& plan, std::vector<MemberResult> const& results) {
  Columns const columns(results);
  std::string out = heading(plan, columns);
  for (auto const& result : results) out += row(plan, columns, result);
  return out;
}

}  // namespace actio::scene
