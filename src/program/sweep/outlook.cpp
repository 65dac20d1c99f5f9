#include "program/sweep/outlook.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace actio::scene {
namespace {

std::string line(std::string const& name, std::string const& text) {
  return fmt::format("{:<12}{}\n", name, text);
}

/// `512 bytes`, `1.2 MB`
std::string bytes_text(double bytes) {
  char const* const units[] = {"bytes", "kB", "MB", "GB", "TB"};
  int unit = 0;
  while (bytes >= 1000 && unit < 4) bytes /= 1000, ++unit;
  return unit == 0 ? fmt::format("{:.0f} bytes", bytes) : fmt::format("{:.3g} {}", bytes, units[unit]);
}

/// `0.1, 0.2, ..., 0.9 (9 values)`
std::string values_text(std::vector<std::string> const& values) {
  constexpr std::size_t most = 8;
  std::string out;
  for (std::size_t k = 0; k < values.size(); ++k)
    if (values.size() <= most || k < 3 || k + 1 == values.size())
      out += (k ? ", " : "") + shown(values[k], 60);
    else if (k == 3)
      out += ", ...";
  return values.size() <= most ? out : out + fmt::format(" ({} values)", values.size());
}

std::string complaints(SweepPlan const& plan, std::vector<MemberResult const*> const& refused) {
  constexpr std::size_t most = 10;
  std::string out;
  for (std::size_t k = 0; k < std::min(most, refused.size()); ++k)
    out += "  " + plan.described(refused[k]->member) + ": " + refused[k]->message + "\n";
  if (refused.size() > most) out += fmt::format("  ... and {} more\n", refused.size() - most);
  return out;
}

}  // namespace

std::string sweep_outlook(SweepPlan const& plan, std::vector<MemberResult> const& results) {
  std::vector<MemberResult const*> able, refused;
  for (auto const& result : results) (result.status == 0 ? able : refused).push_back(&result);
  std::string out = line("members", fmt::format("{}", plan.size()));
  for (auto const& key : plan.keys())
    out += line(&key == &plan.keys().front() ? "over" : "", key.key + " = " + values_text(key.values));
  if (!able.empty()) {
    auto const [least, most] = std::ranges::minmax_element(able, {}, [](auto const* r) { return r->rows; });
    double bytes = 0;
    for (auto const* result : able) bytes += result->bytes;
    out += line("rows", (*least)->rows == (*most)->rows
                            ? fmt::format("{} in each", (*least)->rows)
                            : fmt::format("{} to {} in each", (*least)->rows, (*most)->rows));
    out +=
        line("bytes", fmt::format("about {} of rows in each, {} in all",
                                  bytes_text(bytes / static_cast<double>(able.size())), bytes_text(bytes)));
  }
  out +=
      line("refused", refused.empty() ? "none" : fmt::format("{} of {}:", refused.size(), results.size())) +
      complaints(plan, refused);
  out += line("folder", fmt::format("{}: the table sweep.csv, and a run in each of {} ... {}", plan.folder(),
                                    SweepPlan::name(0), SweepPlan::name(plan.size() - 1)));
  std::error_code none;
  if (std::filesystem::exists(plan.folder(), none) && !std::filesystem::is_empty(plan.folder(), none))
    out += line("remark", "the folder is not empty; a sweep needs --force to replace what is in it");
  return out + (refused.empty() ? "All scenes are in order; nothing was run.\n" : "Nothing was run.\n");
}

}  // namespace actio::scene
