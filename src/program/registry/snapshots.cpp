#include "program/registry/snapshots.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace actio::scene {

bool SnapshotRequest::in(std::string const& format) const {
  return std::find(formats.begin(), formats.end(), format) != formats.end();
}

std::string snapshot_file(long number, std::string const& ending) {
  return fmt::format("snapshots/{:06}{}", number, ending);
}

}  // namespace actio::scene
