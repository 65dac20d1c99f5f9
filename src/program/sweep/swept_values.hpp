// The values that a key of a sweep goes through, as they are written on the command line.
//
//     method.step=0.1,0.2,0.5                     these
//     method.step=0.1:0.5:0.1                     from 0.1 to 0.5 in steps of 0.1, the end included
//     run.until=linspace(1, 2, 11)                eleven numbers at equal distances, both ends included;
// geomspace: with equal ratios; logspace: of powers of ten
//     initial.angular_velocity[0]=1,2,3           one number of a list
//     method.step=@steps.txt                      those in a file, one a line
#pragma once

#include <string>
#include <vector>

#include "program/base/error.hpp"

namespace actio::scene {

/// A key of the scene and the values it goes through, as they were written.
struct SweptKey {
  std::string key;                  ///< `method.step`
  std::vector<std::string> values;  ///< at least one
};

/// The most members that a sweep has, and so the most values of a key: names have six digits.
inline constexpr long most_members = 1000000;

/// Reads KEY=VALUES.
/// @param place  for complaints
/// @throws SceneError  where there is no key or no value, or a range that never ends
/// @throws FileError   where the file of the values cannot be read
SweptKey read_swept_key(std::string const& argument, Place const& place);

/// A key without spaces and quotes, so that two that mean the same are equal.
std::string plain_key(std::string const& key);
/// Whether one of two keys, of KEY or KEY[n], is the other or a part of it.
bool overlap(std::string const& a, std::string const& b);

}  // namespace actio::scene
