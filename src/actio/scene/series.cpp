#include "actio/scene/series.hpp"

namespace actio::scene {
namespace {

std::vector<std::string> columns(SeriesHead const& head) {
  std::vector<std::string> out{"t"};
  for (auto const& group : head.groups) out.insert(out.end(), group.columns.begin(), group.columns.end());
  return out;
}

}  // namespace

std::unique_ptr<Series> open_series(std::string const& folder, std::string const& format, SeriesHead const& head, bool resume) {
  return in_background(format == "hdf5" ? hdf5_series(folder + "/series.h5", head, resume) : csv_series(folder + "/series.csv", columns(head), resume));
}

}  // namespace actio::scene
