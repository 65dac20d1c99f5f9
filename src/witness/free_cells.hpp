// Cells that were given back, for the next number that needs one.
#pragma once

#include <vector>

#include "witness/number_parts.hpp"

namespace actio::detail {

/// A list of free cells of one kind: what GMP, MPFR or Arb allocated for them stays with them.
template <class Cell>
class FreeCells {
 public:
  ~FreeCells() {
    for (Cell* cell : free_) delete cell;
  }
  Cell* take() {
    if (free_.empty()) {
      ++cells_made;
      return new Cell;
    }
    Cell* const cell = free_.back();
    free_.pop_back();
    return cell;
  }
  void give(Cell* cell) noexcept {
    if (free_.size() == free_.capacity()) {
      try {
        free_.reserve(2 * free_.capacity() + 64);
      } catch (...) {
        delete cell;
        return;
      }
    }
    free_.push_back(cell);
  }

 private:
  std::vector<Cell*> free_;
};

/// The list of a kind of cells. It outlives every number.
template <class Cell>
FreeCells<Cell>& free_cells() {
  static FreeCells<Cell>& cells = *new FreeCells<Cell>;
  return cells;
}

}  // namespace actio::detail
