// How far conserved quantities have drifted: the largest |Q(t) - Q(0)| over the rows, divided by |Q(0)|, or by the largest |Q| seen where Q(0) = 0.
#pragma once

#include "actio/scene/memory.hpp"
#include "actio/scene/quantity.hpp"

namespace actio::scene {

/// The Euclidean length of a quantity, which neither overflows nor vanishes before the length does.
double length_of(std::span<double const> quantity);

/// The drift of the conserved quantities in a row.
class Drift {
 public:
  /// @param quantities  where they are in a row
  explicit Drift(std::vector<QuantityGraph::Conserved> quantities);

  /// Whether there is nothing to look at.
  bool empty() const { return quantities_.empty(); }
  /// One row more, without its time. The first one is that of t = 0, even where it is not written.
  void see(std::span<double const> row);
  /// How far one quantity has drifted.
  struct Entry {
    std::string name;  ///< of the quantity
    double relative;   ///< the largest difference from the start, over the modulus there
  };
  /// The drift so far, quantity by quantity.
  std::vector<Entry> entries() const;
  /// The largest of all; zero where nothing is conserved.
  double worst() const;
  /// Saves, or restores, the start and what was seen since.
  void remember(Memory& memory) { memory(started_, start_, seen_); }

 private:
  struct Seen {
    double difference = 0, modulus = 0, at_start = 0;
    double relative() const;
  };
  void start(std::span<double const> row);

  std::vector<QuantityGraph::Conserved> quantities_;
  std::vector<Seen> seen_;
  std::vector<double> start_;  // of the quantities, one after the other
  bool started_ = false;
};

}  // namespace actio::scene
