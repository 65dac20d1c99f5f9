// A matrix whose entries are linear functions of a column, of which most are zero.
#pragma once

#include <vector>

#include "actio/matrices/matrix.hpp"

namespace actio::detail {

/// The entries other than zero, as linear functions of a column.
template <class B>
class LinearEntries {
 public:
  /// Adds value times a coordinate to an entry.
  /// @param at  of the entry: its row, and its column times the rows that there are
  void add(Index at, Index coordinate, B const& value) {
    auto const which = static_cast<std::size_t>(at);
    if (which >= there_.size()) there_.resize(which + 1);
    (there_[which] ? other_ : first_).push_back({at, coordinate, value});
    there_[which] = true;
  }
  /// Writes them into a matrix, whose other entries are zero already.
  template <class V, class M>
  void write(V const& column, M& out) const {
    auto* const entries = out.data();
    for (auto const& e : first_) entries[e.at] = column[e.coordinate] * e.value;
    for (auto const& e : other_) entries[e.at] += column[e.coordinate] * e.value;
  }

 private:
  struct Part {
    Index at, coordinate;
    B value;
  };
  std::vector<Part> first_, other_;  // of each entry; of those that have several
  std::vector<bool> there_;          // whether an entry has a part
};

}  // namespace actio::detail
