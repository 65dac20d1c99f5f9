// The groups that the checks run over.
#include "models/models.hpp"

#include <utility>

namespace actio::checks {

SpannedGroup spanned_su2() {
  static constexpr int units[3][16] = {{0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0},
                                       {0, 0, -1, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, -1, 0, 0},
                                       {0, 0, 0, -1, 0, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0, 0}};
  std::vector<SpannedGroup::WholeMatrix> basis(3, SpannedGroup::WholeMatrix::Zero(4, 4));
  for (int a = 0; a < 3; ++a)
    for (int i = 0; i < 16; ++i) basis[a](i / 4, i % 4) = units[a][i];
  return SpannedGroup("SU(2)", std::move(basis));
}

std::vector<SpannedGroup> const& all_groups() {
  static std::vector<SpannedGroup> const groups = {
      spanned("SO(3)", SO<3>{}),          spanned("SO(4)", SO<4>{}),
      spanned("SE(2)", SE<2>{}),          spanned("SE(3)", SE<3>{}),
      spanned("Aff(1)", Aff1{}),          spanned("SL(2)", SL2{}),
      spanned("GL(2)", GL<2>{}),          spanned_su2(),
      spanned("Heisenberg", Heisenberg{})};
  return groups;
}

std::vector<SpannedGroup> const& few_groups() {
  static std::vector<SpannedGroup> const groups = {spanned("SO(3)", SO<3>{}), spanned("SE(3)", SE<3>{}),
                                                   spanned("Aff(1)", Aff1{}), spanned("GL(2)", GL<2>{})};
  return groups;
}

}  // namespace actio::checks
