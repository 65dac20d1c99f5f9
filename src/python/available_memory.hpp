// How much memory a table may take.
#pragma once

#include <cstddef>

namespace actio::python {

/// Bytes that a process may still take without pushing others out: what the system says, or less where the
/// group of the process has a limit. Infinite where nothing is known.
double available_memory();

/// @throws Error  where a table of so many rows and columns, at 8 bytes a number, takes more than is
///                available
void check_that_it_fits(double rows, std::size_t columns);

}  // namespace actio::python
