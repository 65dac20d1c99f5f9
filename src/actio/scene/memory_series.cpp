#include "actio/scene/memory_series.hpp"

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

std::unique_ptr<Series> memory_series(std::vector<double>& table) {
  return std::make_unique<MemorySeries>(table);
}

}  // namespace actio::scene
