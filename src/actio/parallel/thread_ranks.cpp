#include "actio/parallel/thread_ranks.hpp"

#include <algorithm>
#include <condition_variable>
#include <cstring>
#include <exception>
#include <mutex>
#include <thread>

namespace actio {
namespace {

/// What all of them see of each other, and where they wait for each other.
class Table {
 public:
  explicit Table(int count) : shown(static_cast<std::size_t>(count)) {}
  std::vector<std::span<std::byte const>> shown;

  /// Returns when all are here.
  /// @throws RankLost  where one has ended
  void wait() {
    std::unique_lock lock(mutex_);
    long const round = round_;
    if (!lost_ && ++here_ == shown.size()) here_ = 0, ++round_, change_.notify_all();
    change_.wait(lock, [&] { return round_ != round || lost_; });
    if (round_ == round) throw RankLost("another rank has ended with an error");
  }
  /// Tells those who wait, or will, that a rank has ended.
  void lose() {
    std::scoped_lock const lock(mutex_);
    lost_ = true, change_.notify_all();
  }

 private:
  std::mutex mutex_;
  std::condition_variable change_;
  std::size_t here_ = 0;
  long round_ = 0;
  bool lost_ = false;
};

class ThreadRanks final : public Ranks {
 public:
  ThreadRanks(Table& table, int rank) : table_(table), rank_(rank) {}
  int rank() const override { return rank_; }
  int size() const override { return static_cast<int>(table_.shown.size()); }

  void broadcast(std::span<std::byte> data) override {
    show(data, [&] {
      if (rank_ != 0) copy(table_.shown[0], data);
    });
  }
  void exchange(int to, std::span<std::byte const> mine, int from, std::span<std::byte> theirs) override {
    (void)to;
    show(mine, [&] {
      if (from >= 0) copy(table_.shown[static_cast<std::size_t>(from)], theirs);
    });
  }
  void gather(std::span<std::byte const> mine, std::span<std::byte> all) override {
    show(mine, [&] {
      if (rank_ != 0) return;
      for (auto const& one : table_.shown) copy(one, all.first(one.size())), all = all.subspan(one.size());
    });
  }
  void scatter(std::span<std::byte const> all, std::span<std::byte> mine) override {
    // Lengths first, then what rank 0 has for each.
    show(mine, [&] {
      offset_ = 0;
      for (int k = 0; k < rank_; ++k) offset_ += table_.shown[static_cast<std::size_t>(k)].size();
    });
    show(all, [&] { copy(table_.shown[0].subspan(offset_, mine.size()), mine); });
  }
  bool any(bool here) override {
    bool found = false;
    auto const one = static_cast<std::byte>(here);
    show({&one, 1}, [&] {
      for (auto const& theirs : table_.shown) found = found || theirs[0] != std::byte{0};
    });
    return found;
  }
  double most(double here) override {
    double found = here;
    show(std::as_bytes(std::span(&here, 1)), [&] {
      for (auto const& theirs : table_.shown) {
        double one = 0;
        std::memcpy(&one, theirs.data(), sizeof one);
        found = std::max(found, one);
      }
    });
    return found;
  }

 private:
  template <class Read>
  void show(std::span<std::byte const> data, Read const& read) {
    table_.shown[static_cast<std::size_t>(rank_)] = data;
    table_.wait();
    read();
    table_.wait();
  }
  static void copy(std::span<std::byte const> from, std::span<std::byte> to) {
    if (!from.empty()) std::memcpy(to.data(), from.data(), from.size());
  }

  Table& table_;
  int rank_;
  std::size_t offset_ = 0;
};

}  // namespace

void on_thread_ranks(int count, std::function<void(Ranks&)> const& work) {
  Table table(count);
  std::vector<std::exception_ptr> thrown(static_cast<std::size_t>(count));
  {
    std::vector<std::jthread> threads;
    for (int k = 0; k < count; ++k)
      threads.emplace_back([&, k] {
        ThreadRanks ranks(table, k);
        try {
          work(ranks);
        } catch (RankLost const&) {
        } catch (...) {
          thrown[static_cast<std::size_t>(k)] = std::current_exception();
          table.lose();
        }
      });
  }
  for (auto const& one : thrown)
    if (one) std::rethrow_exception(one);
}

}  // namespace actio
