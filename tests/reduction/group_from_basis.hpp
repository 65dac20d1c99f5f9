// Groups of the library as groups that are known from a basis.
#pragma once

#include <string>
#include <vector>

#include "actio/groups/spanned_group.hpp"

namespace actio::testing {

/// A group of the library, known from the basis of its algebra alone: so one compiled test serves them all.
template <class G>
SpannedGroup from_basis(std::string const& name, G const& group) {
  std::vector<SpannedGroup::WholeMatrix> basis;
  for (int a = 0; a < group.dimension(); ++a) {
    Coordinates<G, double> unit = Coordinates<G, double>::Zero(group.dimension());
    unit[a] = 1;
    basis.push_back(group.hat(unit).template cast<int>());
  }
  return SpannedGroup(name, basis);
}

}  // namespace actio::testing
