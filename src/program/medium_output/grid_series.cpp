#include "program/medium_output/grid_series.hpp"

#include <filesystem>

#include "program/medium_output/vtu_file.hpp"
#include "program/registry/snapshots.hpp"
#include "program/run/checkpoint.hpp"

namespace actio::scene {

namespace {
constexpr char const* series_file = "snapshots/series.pvd";
}

std::vector<std::string> grid_series_files(long taken) {
  std::vector<std::string> out{series_file};
  for (long k = 0; k < taken; ++k) out.push_back(snapshot_file(k, ".vtu"));
  return out;
}

void write_grid_series(std::string const& folder, std::span<double const> times,
                       std::function<void(std::string const& path, long number)> const& write, bool durable) {
  namespace fs = std::filesystem;
  std::string list = pvd_beginning();
  for (std::size_t k = 0; k < times.size(); ++k) {
    auto const number = static_cast<long>(k);
    std::string const table = folder + "/" + snapshot_file(number, ".csv"),
                      grid = snapshot_file(number, ".vtu");
    std::error_code gone, none;
    auto const written = fs::last_write_time(table, gone),
               made = fs::last_write_time(folder + "/" + grid, none);
    if (gone && none) continue;  // both were removed
    if (none || (!gone && made < written)) write(folder + "/" + grid, number);
    list += pvd_entry(times[k], fs::path(grid).filename().string());
  }
  write_whole_file(folder + "/" + series_file, list + pvd_end(), durable);
}

}  // namespace actio::scene
