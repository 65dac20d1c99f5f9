// Decimal numbers as constants of a tape, exactly.
#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string>
#include <string_view>

#include "actio/formula/tape_builder.hpp"

namespace actio {

/// \f$d\,10^k\f$ with the digits d, exactly: a ratio where it fits into 64-bit integers, else products of
/// such.
/// @param digits   decimal digits, at least one
/// @param k        \f$|k| < 10^5\f$
/// @param nearest  the double nearest to it
TapeBuilder::Entry decimal_constant(TapeBuilder& b, std::string_view digits, long k, double nearest);

/// A number as it is written, exactly: digits, perhaps a point among them, perhaps an exponent.
/// @param nearest  the double nearest to it
TapeBuilder::Entry decimal_constant(TapeBuilder& b, std::string_view text, double nearest);

/// The shortest decimal number that reads as x: 0.1 is 1/10.
/// @throws NotFinite
TapeBuilder::Entry decimal_constant(TapeBuilder& b, double x);

}  // namespace actio
