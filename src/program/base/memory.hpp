// How much memory there is for a run.
#pragma once

#include <functional>
#include <string>

#include "program/base/error.hpp"

namespace actio::scene {

/// What the program has without a run, bytes; measured.
inline constexpr double bytes_of_program = 12.3e6;

/// What this process may have: what is free of the machine, of the group that it runs in, and of its own
/// limit, in bytes.
double bytes_of_machine();

/// `3.1 GB`
std::string bytes_in_words(double bytes);

/// Refuses a run that needs more memory than there is, before anything of that size is touched.
/// @param needed    bytes
/// @param place     of the key that says how large it is
/// @param what      takes them, behind that key: "cells: 100 cells"
/// @param would_do  what the bytes that are there are enough for, in words
/// @throws SceneError
void require_memory(double needed, Place const& place, std::string const& what,
                    std::function<std::string(double there)> const& would_do);

}  // namespace actio::scene
