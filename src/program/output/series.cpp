#include "program/output/series.hpp"

#include <filesystem>

namespace actio::scene {
namespace {

std::vector<std::string> columns(SeriesHead const& head) {
  std::vector<std::string> out{"t"};
  for (auto const& group : head.groups) out.insert(out.end(), group.columns.begin(), group.columns.end());
  return out;
}

/// So many numbers take as long to write as a thread takes to come into being.
constexpr std::size_t small_table = 2000;

}  // namespace

std::unique_ptr<Series> open_series(std::string const& folder, std::string const& format,
                                    SeriesHead const& head, bool resume) {
  std::string const path = folder + (format == "hdf5" ? "/series.h5" : "/series.csv");
  std::error_code none;
  if (!resume && std::filesystem::is_symlink(path, none))
    throw FileError(path + ": is a link, and nothing is written through it");
  auto const all = columns(head);
  auto series = format == "hdf5" ? hdf5_series(path, head, resume) : csv_series(path, all, resume);
  bool const small = static_cast<std::size_t>(head.rows) * all.size() <= small_table;
  return small ? std::move(series) : in_background(std::move(series));
}

}  // namespace actio::scene
