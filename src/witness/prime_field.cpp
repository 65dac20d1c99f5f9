#include "witness/prime_field.hpp"

#include <utility>

namespace actio {

namespace prime_field {

std::uint64_t power(std::uint64_t a, std::uint64_t e, std::uint64_t p) {
  std::uint64_t result = 1;
  for (a %= p; e != 0; e >>= 1) {
    if (e & 1) result = product(result, a, p);
    a = product(a, a, p);
  }
  return result;
}

std::uint64_t inverse(std::uint64_t a, std::uint64_t p) {
  // Of x a + y p = r only x is stored, with r falling to the greatest common divisor 1.
  std::int64_t r = static_cast<std::int64_t>(p), next = static_cast<std::int64_t>(a), x = 0, next_x = 1;
  while (next != 0) {
    std::int64_t const q = r / next;
    r = std::exchange(next, r - q * next);
    x = std::exchange(next_x, x - q * next_x);
  }
  return static_cast<std::uint64_t>(x < 0 ? x + static_cast<std::int64_t>(p) : x);
}

std::uint64_t root(std::uint64_t a, std::uint64_t p) { return power(a, (p + 1) / 4, p); }

}  // namespace prime_field

bool is_prime(std::uint64_t p) {
  // With these bases Miller's test decides every number of 64 bits.
  static constexpr std::uint64_t bases[] = {2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37};
  if (p < 2) return false;
  for (std::uint64_t const b : bases)
    if (p % b == 0) return p == b;
  auto const times = [p](std::uint64_t a, std::uint64_t b) {
    return static_cast<std::uint64_t>(static_cast<unsigned __int128>(a) * b % p);
  };
  std::uint64_t odd = p - 1;
  int twos = 0;
  for (; odd % 2 == 0; odd /= 2) ++twos;
  for (std::uint64_t const b : bases) {
    std::uint64_t x = 1, square = b;
    for (std::uint64_t e = odd; e != 0; e >>= 1, square = times(square, square))
      if (e & 1) x = times(x, square);
    bool passes = x == 1 || x == p - 1;
    for (int k = 1; k < twos && !passes; ++k) x = times(x, x), passes = x == p - 1;
    if (!passes) return false;
  }
  return true;
}

}  // namespace actio
