// The integers modulo a prime below 2^62, by their representatives 0, ..., p - 1.
#pragma once

#include <cstdint>

#include "witness/arithmetic.hpp"

namespace actio::prime_field {

/// \f$ab \bmod p\f$. Modulo \f$2^{61}-1\f$ the two halves of the product are added, elsewhere it is divided.
inline std::uint64_t product(std::uint64_t a, std::uint64_t b, std::uint64_t p) {
  unsigned __int128 const whole = static_cast<unsigned __int128>(a) * b;
  if (p != Arithmetic::mersenne) return static_cast<std::uint64_t>(whole % p);
  std::uint64_t const folded =
      (static_cast<std::uint64_t>(whole) & p) + static_cast<std::uint64_t>(whole >> 61);
  return folded >= p ? folded - p : folded;
}
/// a + b modulo p.
inline std::uint64_t sum(std::uint64_t a, std::uint64_t b, std::uint64_t p) {
  std::uint64_t const s = a + b;
  return s >= p ? s - p : s;
}
/// a - b modulo p.
inline std::uint64_t difference(std::uint64_t a, std::uint64_t b, std::uint64_t p) {
  return a >= b ? a - b : a + p - b;
}

/// \f$a^e\f$ modulo p.
std::uint64_t power(std::uint64_t a, std::uint64_t e, std::uint64_t p);
/// \f$1/a\f$ modulo p, by Euclid's algorithm; a is not 0.
std::uint64_t inverse(std::uint64_t a, std::uint64_t p);
/// \f$a^{(p+1)/4}\f$ with p = 3 mod 4: where a is a square, the root of a that is a square itself.
std::uint64_t root(std::uint64_t a, std::uint64_t p);

}  // namespace actio::prime_field
