// How far conserved quantities have drifted: the largest |Q(t) - Q(0)| over the rows, in a unit of the
// quantity.
//
// Where a quantity may be near zero although what it is made of is not, the unit is natural to it: kinetic
// energy plus the modulus of the potential energy for the energy, the modulus of the momentum for one of its
// components; the largest that it has been over the rows. Where even that is rounding, as it is of a body at
// rest, the unit is what the quantity is in a motion at the body's own pace. Otherwise it is |Q(0)|, or the
// largest |Q| seen where Q(0) = 0.
#pragma once

#include "program/base/checkpoint_stream.hpp"
#include "program/registry/quantity.hpp"

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
  /// @param units  natural units of the quantities now, in their order; of no terms, or none at all: the
  ///               modulus of the quantity
  void see(std::span<double const> row, std::span<QuantityGraph::Unit const> units = {});
  /// How far one quantity has drifted.
  struct Entry {
    std::string name;     ///< of the quantity
    double relative = 0,  ///< the largest difference from the start, in the unit
        unit = 0;         ///< of the quantity
  };
  /// The drift so far, quantity by quantity.
  std::vector<Entry> entries() const;
  /// The largest of all; zero where nothing is conserved.
  double worst() const;
  /// Saves, or restores, the start and what was seen since.
  void remember(CheckpointStream& stream) { stream(started_, start_, seen_); }

 private:
  struct Seen {
    double difference = 0, modulus = 0, at_start = 0;
    QuantityGraph::Unit natural = {};  // the largest of each of its parts
    double unit() const {
      if (natural.at_rest > 0 && !(natural.terms > natural.rounding)) return natural.at_rest;
      return natural.terms > 0 ? natural.terms : at_start > 0 ? at_start : modulus;
    }
    double relative() const { return unit() > 0 ? difference / unit() : 0; }
  };
  void start(std::span<double const> row);

  std::vector<QuantityGraph::Conserved> quantities_;
  std::vector<Seen> seen_;
  std::vector<double> start_;  // of the quantities, one after the other
  bool started_ = false;
};

}  // namespace actio::scene
