#include "program/output/hdf5_series.hpp"

#include <algorithm>
#include <bit>

#include "program/output/array_file.hpp"
#include "program/output/series_reader.hpp"

namespace actio::scene {
namespace {

/// Rows of a chunk, the same for all data sets: about 64 kB of the widest, more where that would be few; a
/// power of two, and no more than the run has.
std::size_t rows_of_chunk(std::size_t widest, std::size_t expected) {
  constexpr std::size_t numbers = 1 << 13, most = 1 << 17, few = 64;
  std::size_t const rows = std::max(numbers / widest, std::min(few, most / widest));
  return std::min(std::bit_floor(std::max<std::size_t>(1, rows)), std::bit_ceil(expected));
}

ArraySet set_of(ColumnGroup const& group) {
  Quantity const& quantity = group.quantity;
  ArraySet out{quantity.name, {{"row", 0}}};
  for (std::size_t const n : group.shape()) out.axes.push_back({"", n});
  out.attributes = {{"meaning", {quantity.meaning}},
                    {"formula", {quantity.formula}},
                    {"unit", {quantity.unit}},
                    {"statement", {quantity.statement}},
                    {"columns", group.columns, true}};
  return out;
}
std::vector<ArraySet> sets_of(SeriesHead const& head) {
  Quantity const time{"t", Quantity::Kind::scalar, "The time.", "t", head.time_unit};
  std::vector<ArraySet> out{set_of({time, {"t"}})};
  std::size_t widest = 1;
  for (auto const& group : head.groups)
    out.push_back(set_of(group)), widest = std::max(widest, out.back().width());
  std::size_t const rows = rows_of_chunk(widest, static_cast<std::size_t>(std::max(1L, head.rows)));
  for (auto& set : out) {
    set.chunk = {rows};
    for (std::size_t k = 1; k < set.axes.size(); ++k) set.chunk.push_back(set.axes[k].length);
  }
  return out;
}

}  // namespace

void make_hdf5_series(std::string const& folder, SeriesHead const& head, bool durable,
                      std::function<void(double)> const& see) {
  auto const reader = read_series(folder, head.groups);
  auto const sets = sets_of(head);
  ArrayFile file(ArrayFile::Format::hdf5, folder + "/series.h5",
                 {{"title", {head.title}},
                  {"system", {head.system}},
                  {"actio_version", {ACTIO_VERSION}},
                  {"scene", {head.scene}}},
                 sets);
  std::vector<double> row(head.columns().size());
  std::vector<std::vector<double>> chunks(sets.size());
  std::size_t const at_once = sets.front().chunk.front();
  for (std::size_t rows = 0, more = at_once; more == at_once; rows += more) {
    for (more = 0; more < at_once && reader->next(row); ++more)
      for (std::size_t k = 0, at = 0; k < sets.size(); at += sets[k++].width())
        chunks[k].insert(chunks[k].end(), row.begin() + static_cast<long>(at),
                         row.begin() + static_cast<long>(at + sets[k].width()));
    for (std::size_t k = 0; k < sets.size() && more > 0; ++k) file.put(k, rows, chunks[k]), chunks[k].clear();
    if (see) see(reader->fraction());
  }
  file.name(durable);
}

}  // namespace actio::scene
