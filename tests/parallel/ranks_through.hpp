// Ranks that do what others do: for controls, which change one thing of it.
#pragma once

#include "actio/parallel/ranks.hpp"

namespace actio::testing {

/// Ranks that ask others for everything.
class RanksThrough : public Ranks {
 public:
  explicit RanksThrough(Ranks& others) : others_(others) {}  ///< Asks these.
  int rank() const override { return others_.rank(); }
  int size() const override { return others_.size(); }
  void broadcast(std::span<std::byte> data) override { others_.broadcast(data); }
  void exchange(int to, std::span<std::byte const> mine, int from, std::span<std::byte> theirs) override {
    others_.exchange(to, mine, from, theirs);
  }
  void gather(std::span<std::byte const> mine, std::span<std::byte> all) override {
    others_.gather(mine, all);
  }
  void scatter(std::span<std::byte const> all, std::span<std::byte> mine) override {
    others_.scatter(all, mine);
  }
  bool any(bool here) override { return others_.any(here); }
  double most(double here) override { return others_.most(here); }

 private:
  Ranks& others_;
};

}  // namespace actio::testing
