// Rows are written by another thread than the one that steps: to write a number with 17 digits takes as long
// as several steps.
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <thread>

#include "program/output/series.hpp"

namespace actio::scene {
namespace {

class BackgroundSeries : public Series {
 public:
  explicit BackgroundSeries(std::unique_ptr<Series> series)
      : series_(std::move(series)), writer_([this] { write(); }) {}
  ~BackgroundSeries() override {
    {
      std::unique_lock lock(mutex_);
      hand_over(lock);
      closing_ = true;
    }
    changed_.notify_all();
    writer_.join();
  }

  void add(std::span<double const> row) override {
    block_.row_size = row.size();
    block_.numbers.insert(block_.numbers.end(), row.begin(), row.end());
    if (block_.numbers.size() < enough) return;
    std::unique_lock lock(mutex_);
    hand_over(lock);
    rethrow();
  }
  void flush() override { drained().flush(); }
  void sync() override { drained().sync(); }
  void remember(CheckpointStream& stream) override { drained().remember(stream); }

 private:
  static constexpr std::size_t enough = 1 << 12;  // numbers in a block: a fraction of a millisecond to write
  static constexpr std::size_t most = 4;          // blocks that wait

  struct Block {
    std::vector<double> numbers;
    std::size_t row_size = 0;
  };

  /// Gives the block to the writer, once there is room.
  void hand_over(std::unique_lock<std::mutex>& lock) {
    changed_.wait(lock, [this] { return waiting_.size() < most; });
    if (!block_.numbers.empty()) waiting_.push_back(std::move(block_));
    block_ = {};
    if (!spare_.empty()) block_.numbers = std::move(spare_.back()), spare_.pop_back();
    changed_.notify_all();
  }
  void rethrow() {
    if (error_) std::rethrow_exception(error_);
  }
  /// The table, which the writer has finished with: it holds every row so far, and no other thread uses it
  /// until the next `add`.
  Series& drained() {
    std::unique_lock lock(mutex_);
    hand_over(lock);
    changed_.wait(lock, [this] { return waiting_.empty(); });
    rethrow();
    return *series_;
  }

  void write() {
    std::unique_lock lock(mutex_);
    for (;;) {
      changed_.wait(lock, [this] { return closing_ || !waiting_.empty(); });
      if (waiting_.empty()) return;
      // it stays in the queue while it is written, and a deque does not move it
      Block& block = waiting_.front();
      bool const failed = error_ != nullptr;
      lock.unlock();
      std::exception_ptr error = failed ? nullptr : written(block);
      lock.lock();
      if (error) error_ = error;
      block.numbers.clear();
      spare_.push_back(std::move(block.numbers));
      waiting_.pop_front();
      changed_.notify_all();
    }
  }
  std::exception_ptr written(Block const& block) {
    try {
      for (std::size_t at = 0; at < block.numbers.size(); at += block.row_size)
        series_->add(std::span(block.numbers).subspan(at, block.row_size));
    } catch (...) {
      return std::current_exception();
    }
    return nullptr;
  }

  std::unique_ptr<Series> series_;
  Block block_;  // of the thread that steps
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Block> waiting_;
  std::vector<std::vector<double>> spare_;  // room of blocks that were written
  std::exception_ptr error_;
  bool closing_ = false;
  std::thread writer_;  // last: it uses all the others
};

}  // namespace

std::unique_ptr<Series> in_background(std::unique_ptr<Series> series) {
  return std::make_unique<BackgroundSeries>(std::move(series));
}

}  // namespace actio::scene
