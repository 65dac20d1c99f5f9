#include "program/output/memory_series.hpp"

#include <fmt/format.h>

#include <new>

#include "program/base/progress.hpp"

namespace actio::scene {
namespace {

class MemorySeries : public Series {
 public:
  explicit MemorySeries(std::vector<double>& table) : table_(table) {}
  void add(std::span<double const> row) override { table_.insert(table_.end(), row.begin(), row.end()); }
  void flush() override {}
  void sync() override {}
  void remember(CheckpointStream& stream) override { stream(table_); }

 private:
  std::vector<double>& table_;
};

}  // namespace

TooLarge::TooLarge(std::size_t rows, std::size_t columns)
    : Error(fmt::format("the memory does not suffice: {} rows x {} columns x 8 bytes are {}; fewer rows "
                        "(run.every) or quantities take less, and the command writes them to a file",
                        rows, columns,
                        size_text(8.0 * static_cast<double>(rows) * static_cast<double>(columns)))) {}

std::unique_ptr<Series> memory_series(std::vector<double>& table, std::size_t rows, std::size_t columns) {
  try {
    if (rows > table.max_size() / columns) throw TooLarge(rows, columns);
    table.reserve(rows * columns);
  } catch (std::bad_alloc const&) {
    throw TooLarge(rows, columns);
  }
  return std::make_unique<MemorySeries>(table);
}

}  // namespace actio::scene
