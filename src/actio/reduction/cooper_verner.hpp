// An explicit Runge-Kutta method of order 8, in any number of digits.
#pragma once

#include <array>
#include <cmath>

#include "actio/numbers/scalar.hpp"

namespace actio::detail {

/// Cooper and Verner's explicit method of order 8 in 11 stages, whose coefficients are numbers in
/// \f$Q(\sqrt{21})\f$ (Some explicit Runge-Kutta methods of high order, SIAM J. Numer. Anal. 9, 1972).
template <Real S>
struct CooperVerner {
  static constexpr int stages = 11;
  static constexpr int first_with_weight = 7;  ///< of the stages after the first, at the end of the step
  /// What a stage takes of the rates of those before it; zeros are left out.
  struct Row {
    int count = 0;
    std::array<int, stages> of{};
    std::array<S, stages> weight{};
    void add(int stage, S const& of_it) { of[count] = stage, weight[count++] = of_it; }
  };
  std::array<Row, stages + 1> rows{};  ///< of the stages, and of the end of the step

  CooperVerner() {
    using std::sqrt;
    S const r = sqrt(S(21));
    // (whole + root sqrt(21))/by of the rate of a stage.
    auto const take = [&](int row, int stage, int whole, int root, int by) {
      rows[row].add(stage, S((S(whole) + S(root) * r) / S(by)));
    };
    take(1, 0, 1, 0, 2);
    take(2, 0, 1, 0, 4), take(2, 1, 1, 0, 4);
    take(3, 0, 1, 0, 7), take(3, 1, -7, -3, 98), take(3, 2, 21, 5, 49);
    take(4, 0, 11, 1, 84), take(4, 2, 18, 4, 63), take(4, 3, 21, -1, 252);
    take(5, 0, 5, 1, 48), take(5, 2, 9, 1, 36), take(5, 3, -231, 14, 360), take(5, 4, 63, -7, 80);
    take(6, 0, 10, -1, 42), take(6, 2, -432, 92, 315), take(6, 3, 633, -145, 90);
    take(6, 4, -504, 115, 70), take(6, 5, 63, -13, 35);
    take(7, 0, 1, 0, 14), take(7, 4, 14, -3, 126), take(7, 5, 13, -3, 63), take(7, 6, 1, 0, 9);
    take(8, 0, 1, 0, 32), take(8, 4, 91, -21, 576), take(8, 5, 11, 0, 72), take(8, 6, -385, -75, 1152);
    take(8, 7, 63, 13, 128);
    take(9, 0, 1, 0, 14), take(9, 4, 1, 0, 9), take(9, 5, -733, -147, 2205), take(9, 6, 515, 111, 504);
    take(9, 7, -51, -11, 56), take(9, 8, 132, 28, 245);
    take(10, 4, -42, 7, 18), take(10, 5, -18, 28, 45), take(10, 6, -273, -53, 72);
    take(10, 7, 301, 53, 72), take(10, 8, 28, -28, 45), take(10, 9, 49, -7, 18);
    take(11, 0, 1, 0, 20), take(11, 7, 49, 0, 180), take(11, 8, 16, 0, 45), take(11, 9, 49, 0, 180);
    take(11, 10, 1, 0, 20);
  }
};

}  // namespace actio::detail
