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

/// A number as a library has it, in a cell of its own where it is no cell.
/// @tparam Cell  has `value`, what the library calls a number, and `put`, which takes one that is no cell
template <class Cell>
struct InCell {
  explicit InCell(Number const& x) : own(NumberParts::in_cell(x) ? nullptr : free_cells<Cell>().take()) {
    if (own) own->put(x);
    at = (own ? own : static_cast<Cell*>(NumberParts::cell(x)))->value;
  }
  ~InCell() {
    if (own) free_cells<Cell>().give(own);
  }
  InCell(InCell const&) = delete;
  InCell& operator=(InCell const&) = delete;
  Cell* own;
  std::decay_t<decltype(Cell::value)> at;
};

}  // namespace actio::detail
