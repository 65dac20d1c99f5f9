// How far conserved quantities have drifted: the largest |Q(t) - Q(0)| over the rows, divided by |Q(0)|, or by the largest |Q| seen where Q(0) = 0.
#pragma once

#include "actio/scene/quantity.hpp"
#include "actio/scene/memory.hpp"

namespace actio::scene {

/// The drift of the conserved quantities in a row.
class Drift {
 public:
  explicit Drift(std::vector<QuantityGraph::Conserved> quantities) : quantities_(std::move(quantities)), seen_(quantities_.size()) {}

  /// One row more, without its time.
  void see(std::span<double const> row);
  struct Entry {
    std::string name;
    double relative;
  };
  std::vector<Entry> entries() const;
  /// The largest of all; zero where nothing is conserved.
  double worst() const;
  void remember(Memory& memory);

 private:
  struct Seen {
    double difference = 0, modulus = 0, at_start = 0;
    double relative() const;
  };
  std::vector<QuantityGraph::Conserved> quantities_;
  std::vector<Seen> seen_;
  std::vector<double> first_;
};

}  // namespace actio::scene
