// How much memory there is for a run.
#pragma once

#include <string>

namespace actio::scene {

/// What this process may have: what is free of the machine, of the group that it runs in, and of its own
/// limit, in bytes.
double bytes_of_machine();

/// `3.1 GB`
std::string bytes_in_words(double bytes);

}  // namespace actio::scene
