// Dual numbers over double in pairs of doubles, which a register of plain x86-64 holds.
#pragma once

#include <concepts>

namespace actio {

template <class S, int N>
struct Dual;

namespace detail {
/// Whether a dual number is an even number of doubles, which the machine adds and multiplies in pairs.
template <class S, int N>
inline constexpr bool in_pairs = std::same_as<S, double> && N % 2 == 1;

/// The value and the rates of a dual number over double, in pairs that stay in registers.
template <int N>
struct Lanes {
  static_assert(N % 2 == 1 && sizeof(Dual<double, N>) == (N + 1) * sizeof(double));
  using Pair [[gnu::vector_size(16)]] = double;  ///< two doubles in one register of plain x86-64
  Pair pair[(N + 1) / 2];                        ///< value and first rate, second and third rate, and so on

  /// A dual number.
  explicit Lanes(Dual<double, N> const& x) { __builtin_memcpy(pair, &x, sizeof pair); }
  /// The value and no rates.
  explicit Lanes(double value) : pair{Pair{value, 0}} {}
  /// The dual number back.
  void store(Dual<double, N>& x) const { __builtin_memcpy(&x, pair, sizeof pair); }
  /// Another value with these rates.
  void set_value(double value) { pair[0] = __builtin_shufflevector(pair[0], Pair{value, 0}, 2, 1); }

  Lanes& operator+=(Lanes const& y) {
    for (int i = 0; i < (N + 1) / 2; ++i) pair[i] += y.pair[i];
    return *this;
  }
  Lanes& operator-=(Lanes const& y) {
    for (int i = 0; i < (N + 1) / 2; ++i) pair[i] -= y.pair[i];
    return *this;
  }
  Lanes& operator*=(double c) {
    for (Pair& p : pair) p *= c;
    return *this;
  }
  /// Adds x y. Its value comes from the first of the two sums, to which the second adds rates alone.
  [[gnu::always_inline]] void add_product(Dual<double, N> const& x, Dual<double, N> const& y) {
    Lanes rates(x), other(y);
    rates.set_value(0);
    double const a = x.value, b = y.value;
    for (int i = 0; i < (N + 1) / 2; ++i) {
      pair[i] += a * other.pair[i];
      pair[i] += b * rates.pair[i];
    }
  }
  Lanes& operator/=(double c) {
    for (Pair& p : pair) p /= c;
    return *this;
  }
};
}  // namespace detail

}  // namespace actio
