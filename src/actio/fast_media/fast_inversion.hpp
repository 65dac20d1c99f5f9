// A cell that the fused steps of a medium would turn inside out.
#pragma once

#include <algorithm>
#include <array>

#include "actio/numbers/errors.hpp"

namespace actio::media {

/// A cell of a medium that would turn inside out: the state is that before the step which would do it.
struct CellInverts : OutsideDomain {
  std::array<int, 3> cell;  ///< which, along the directions; 0 beyond the last one
  long step;                ///< the number of the step that would do it, from 1; 0 at the start
  double time_step;         ///< its length
  double largest_step;      ///< the longest step for which small motions about the state before are stable
  /// @param which, jacobian, step_number, dt, largest  as above; J at the worst of its corners
  /// @param before  the same before the step
  template <std::size_t n>
  CellInverts(std::array<int, n> const& which, double jacobian, long step_number = 0, double dt = 0,
              double before = 0, double largest = 0)
      : OutsideDomain(where(which, step_number, dt, before, largest),
                      "the Jacobian at its corners must be positive", jacobian, 0),
        cell{},
        step(step_number),
        time_step(dt),
        largest_step(largest) {
    std::copy(which.begin(), which.end(), cell.begin());
  }

 private:
  template <std::size_t n>
  static std::string where(std::array<int, n> const& which, long step_number, double dt, double before,
                           double largest) {
    std::string cell;
    for (int const i : which) cell += (cell.empty() ? "cell (" : ", ") + std::to_string(i);
    cell += ")";
    if (step_number == 0) return "medium: " + cell + " is inside out at the start";
    return "medium: step " + std::to_string(step_number) + " of length " + show(dt) + " would turn " + cell +
           " inside out, whose Jacobian is " + show(before) +
           " before it (the longest stable step before it is " + show(largest) + ")";
  }
};

}  // namespace actio::media
