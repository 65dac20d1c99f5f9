// What numbers have counted while formulas ran: roots, degrees, operations, cells.
#pragma once

#include <cstdint>

namespace actio {

/// How many different numbers of the prime field had a root taken since \ref forget_roots: each doubles the
/// degree of an identity, and halves the points that count.
int roots_taken();
/// Starts the count of \ref roots_taken anew.
void forget_roots();
/// The largest degree of a numerator among the field numbers whose \ref magnitude was asked for since
/// \ref forget_degrees.
double largest_degree();
/// Starts the search for \ref largest_degree anew.
void forget_degrees();
/// How many products and quotients there were since the program began: the measure of a budget that no
/// machine changes.
std::uint64_t operations_done();
/// How many cells have ever been allocated for numbers that do not fit into 16 bytes.
std::uint64_t cells_allocated();

}  // namespace actio
