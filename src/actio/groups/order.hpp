// The number n in the name of a group: known when the code is compiled, or chosen when it runs.
//
// SL(2), SL(3) and so on differ by one number. A group of fixed order has matrices of fixed size and no data;
// a group of order Dynamic is told its order when it is made, and code for it is compiled once for the whole
// family.
#pragma once

#include "actio/numbers/errors.hpp"

namespace actio {

/// The order n of a group that needs n to be at least `least`.
template <int n, int least>
struct Order {
  static_assert(n >= least, "the group needs a larger order");
  /// n.
  static constexpr int order() { return n; }
};
/// An order that is known when the program runs.
template <int least>
struct Order<Dynamic, least> {
  /// @throws OutsideDomain  where n is not between `least` and 1000
  explicit Order(int n) : number(n) {
    if (n < least) throw OutsideDomain("order of a group", "too small", n, least);
    if (n > 1000) throw OutsideDomain("order of a group", "too large", n, 1000);
  }
  /// n.
  int order() const { return number; }

 private:
  int number;
};

/// A number of rows or of dimensions that follows from the order n, as Eigen wants it.
template <int n>
constexpr int follows_from(int count) { return n == Dynamic ? Dynamic : count; }

}  // namespace actio
