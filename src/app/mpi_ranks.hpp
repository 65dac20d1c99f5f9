// Ranks of MPI.
#pragma once

#include <mpi.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "actio/parallel/ranks.hpp"

namespace actio::app {

/// All processes that mpirun has started. Between `MPI_Init` and `MPI_Finalize`.
///
/// Nothing waits without giving the core away: several ranks may share one, and ranks wait for long while
/// rank 0 writes files.
class MpiRanks final : public Ranks {
 public:
  MpiRanks() { MPI_Comm_rank(MPI_COMM_WORLD, &rank_), MPI_Comm_size(MPI_COMM_WORLD, &size_); }
  int rank() const override { return rank_; }
  int size() const override { return size_; }

  void broadcast(std::span<std::byte> data) override {
    in_parts(data.size(), [&](std::size_t from, int count) {
      MPI_Request request;
      MPI_Ibcast(data.data() + from, count, MPI_BYTE, 0, MPI_COMM_WORLD, &request);
      wait(request);
    });
  }
  void exchange(int to, std::span<std::byte const> mine, int from, std::span<std::byte> theirs) override {
    std::vector<MPI_Request> requests;
    if (from >= 0) receive(from, theirs, requests);
    if (to >= 0) send(to, mine, requests);
    for (auto& request : requests) wait(request);
  }
  void gather(std::span<std::byte const> mine, std::span<std::byte> all) override {
    std::vector<std::size_t> const sizes = sizes_of(mine.size());
    std::vector<MPI_Request> requests;
    if (rank_ > 0) {
      send(0, mine, requests);
    } else {
      std::copy(mine.begin(), mine.end(), all.begin());
      std::size_t at = mine.size();
      for (int k = 1; k < size_; ++k) {
        auto const size = sizes[static_cast<std::size_t>(k)];
        receive(k, all.subspan(at, size), requests), at += size;
      }
    }
    for (auto& request : requests) wait(request);
  }
  void scatter(std::span<std::byte const> all, std::span<std::byte> mine) override {
    std::vector<std::size_t> const sizes = sizes_of(mine.size());
    std::vector<MPI_Request> requests;
    if (rank_ > 0) {
      receive(0, mine, requests);
    } else {
      std::copy_n(all.begin(), mine.size(), mine.begin());
      std::size_t at = mine.size();
      for (int k = 1; k < size_; ++k) {
        auto const size = sizes[static_cast<std::size_t>(k)];
        send(k, all.subspan(at, size), requests), at += size;
      }
    }
    for (auto& request : requests) wait(request);
  }
  bool any(bool here) override {
    int const mine = here;
    int found = 0;
    MPI_Request request;
    MPI_Iallreduce(&mine, &found, 1, MPI_INT, MPI_LOR, MPI_COMM_WORLD, &request);
    wait(request);
    return found != 0;
  }
  double most(double here) override {
    double found = here;
    MPI_Request request;
    MPI_Iallreduce(&here, &found, 1, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD, &request);
    wait(request);
    return found;
  }

 private:
  /// Messages are of less than 2^31 bytes.
  template <class Visit>
  static void in_parts(std::size_t size, Visit const& visit) {
    constexpr std::size_t most = std::size_t{1} << 30;
    for (std::size_t from = 0; from < size; from += most)
      visit(from, static_cast<int>(std::min(most, size - from)));
  }
  void send(int to, std::span<std::byte const> data, std::vector<MPI_Request>& requests) {
    in_parts(data.size(), [&](std::size_t from, int count) {
      MPI_Isend(data.data() + from, count, MPI_BYTE, to, 0, MPI_COMM_WORLD, &requests.emplace_back());
    });
  }
  void receive(int from, std::span<std::byte> data, std::vector<MPI_Request>& requests) {
    in_parts(data.size(), [&](std::size_t at, int count) {
      MPI_Irecv(data.data() + at, count, MPI_BYTE, from, 0, MPI_COMM_WORLD, &requests.emplace_back());
    });
  }
  std::vector<std::size_t> sizes_of(std::size_t mine) {
    std::vector<std::size_t> out(static_cast<std::size_t>(size_));
    MPI_Request request;
    MPI_Iallgather(&mine, sizeof mine, MPI_BYTE, out.data(), sizeof mine, MPI_BYTE, MPI_COMM_WORLD, &request);
    wait(request);
    return out;
  }
  /// At first at once, as a neighbour is about to answer; then with longer and longer pauses.
  static void wait(MPI_Request& request) {
    using namespace std::chrono;
    int done = 0;
    for (int round = 0; MPI_Test(&request, &done, MPI_STATUS_IGNORE), !done; ++round) {
      if (round < 20000)
        std::this_thread::yield();
      else
        std::this_thread::sleep_for(round < 30000 ? microseconds(50) : microseconds(1000));
    }
  }

  int rank_ = 0, size_ = 1;
};

}  // namespace actio::app
