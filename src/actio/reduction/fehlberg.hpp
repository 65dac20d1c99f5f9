// An explicit Runge-Kutta method of order 8, in any number of digits.
#pragma once

#include <array>

#include "actio/numbers/scalar.hpp"

namespace actio::detail {

/// Fehlberg's explicit method of order 8, whose coefficients are rational (Classical fifth-, sixth-,
/// seventh-, and eighth-order Runge-Kutta formulas with stepsize control, NASA TR R-287, 1968). His stage
/// that serves the method of order 7 alone is left out: 12 remain.
///
/// The stages that have no weight at the end of the step, but for the first, are felt there in the third
/// order alone: \f$\sum_ib_ia_{ij} = \sum_ib_ic_ia_{ij} = \sum_{ik}b_ia_{ik}a_{kj} = 0\f$. So errors of the
/// fifth order in their rates leave the order of the method as it is.
template <Real S>
struct Fehlberg {
  static constexpr int stages = 12;
  static constexpr int first_with_weight = 5;  ///< of the stages, at the end of the step
  /// Whether a rate that is found by powers of the displacement needs them up to the order of the method: not
  /// where it has no weight, nor at the stage but one, which is at the start of the step again.
  static constexpr bool needs_all_powers(int stage) {
    return stage >= first_with_weight && stage != stages - 2;
  }
  /// What a stage takes of the rates of those before it; zeros are left out.
  struct Row {
    int count = 0;
    std::array<int, stages> of{};
    std::array<S, stages> weight{};
  };
  std::array<Row, stages + 1> rows{};  ///< of the stages, and of the end of the step

  Fehlberg() {
    // The rate of a stage by whole/by.
    auto const take = [&](int row, int stage, int whole, int by) {
      Row& of = rows[row];
      of.of[of.count] = stage, of.weight[of.count++] = S(whole) / S(by);
    };
    take(1, 0, 2, 27);
    take(2, 0, 1, 36), take(2, 1, 1, 12);
    take(3, 0, 1, 24), take(3, 2, 1, 8);
    take(4, 0, 5, 12), take(4, 2, -25, 16), take(4, 3, 25, 16);
    take(5, 0, 1, 20), take(5, 3, 1, 4), take(5, 4, 1, 5);
    take(6, 0, -25, 108), take(6, 3, 125, 108), take(6, 4, -65, 27), take(6, 5, 125, 54);
    take(7, 0, 31, 300), take(7, 4, 61, 225), take(7, 5, -2, 9), take(7, 6, 13, 900);
    take(8, 0, 2, 1), take(8, 3, -53, 6), take(8, 4, 704, 45), take(8, 5, -107, 9), take(8, 6, 67, 90);
    take(8, 7, 3, 1);
    take(9, 0, -91, 108), take(9, 3, 23, 108), take(9, 4, -976, 135), take(9, 5, 311, 54);
    take(9, 6, -19, 60), take(9, 7, 17, 6), take(9, 8, -1, 12);
    take(10, 0, 3, 205), take(10, 5, -6, 41), take(10, 6, -3, 205), take(10, 7, -3, 41);
    take(10, 8, 3, 41), take(10, 9, 6, 41);
    take(11, 0, -1777, 4100), take(11, 3, -341, 164), take(11, 4, 4496, 1025), take(11, 5, -289, 82);
    take(11, 6, 2193, 4100), take(11, 7, 51, 82), take(11, 8, 33, 164), take(11, 9, 12, 41);
    take(11, 10, 1, 1);
    take(12, 5, 34, 105), take(12, 6, 9, 35), take(12, 7, 9, 35), take(12, 8, 9, 280), take(12, 9, 9, 280);
    take(12, 10, 41, 840), take(12, 11, 41, 840);
  }
};

}  // namespace actio::detail
