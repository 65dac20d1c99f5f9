#include "program/output/series.hpp"

#include <filesystem>

namespace actio::scene {

/// So many numbers take as long to write as a thread takes to come into being.
static constexpr std::size_t small_table = 2000;

std::vector<std::string> SeriesHead::columns() const {
  std::vector<std::string> out{"t"};
  for (auto const& group : groups) out.insert(out.end(), group.columns.begin(), group.columns.end());
  return out;
}

std::unique_ptr<Series> open_series(std::string const& folder, SeriesHead const& head, bool resume) {
  std::string const path = folder + "/series.csv";
  std::error_code none;
  if (!resume && std::filesystem::is_symlink(path, none))
    throw FileError(path + ": is a link, and nothing is written through it");
  auto const all = head.columns();
  auto series = csv_series(path, all, resume);
  bool const small = static_cast<std::size_t>(head.rows) * all.size() <= small_table;
  return small ? std::move(series) : in_background(std::move(series));
}

}  // namespace actio::scene
