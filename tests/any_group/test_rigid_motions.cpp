// Which groups turn or move Euclidean space, and which keep the length of momenta.
#include <boost/test/unit_test.hpp>

#include "actio/any_group/named_algebra.hpp"
#include "actio/any_group/rigid_motions.hpp"

using namespace actio;
using namespace actio::systems;

namespace {

struct Known {
  std::string group;
  bool rotations, motions, length;
};

/// The matrices of so(3) with the last of them longer: the sphere becomes an ellipsoid.
MatrixAlgebra stretched_rotations() {
  auto basis = named_algebra("SO(3)").basis;
  basis[2] *= 2;
  return spanned_algebra(basis);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(rigid_motions)

BOOST_AUTO_TEST_CASE(groups_of_rotations_and_of_motions_are_known_from_their_matrices) {
  for (auto const& [group, rotations, motions, length] : {Known{"SO(2)", true, false, false},
                                                          {"SO(3)", true, false, true},
                                                          {"SO(4)", true, false, true},
                                                          {"SE(2)", false, true, false},
                                                          {"SE(3)", false, true, false},
                                                          {"SO(3) |x R^3", false, true, false},
                                                          {"R^3", false, true, false},
                                                          {"SU(2)", true, false, true},
                                                          {"SL(2)", false, false, false},
                                                          {"GL(2)", false, false, false},
                                                          {"Aff(1)", false, false, false},
                                                          {"Heisenberg", false, false, false}}) {
    MatrixAlgebra const algebra = named_algebra(group);
    BOOST_TEST(is_of_rotations(algebra) == rotations, group);
    BOOST_TEST(is_of_rigid_motions(algebra) == motions, group);
    BOOST_TEST(keeps_length_of_momenta(algebra) == length, group);
  }
}

BOOST_AUTO_TEST_CASE(the_length_of_momenta_depends_on_the_basis) {
  BOOST_TEST(is_of_rotations(stretched_rotations()));
  BOOST_TEST(!keeps_length_of_momenta(stretched_rotations()));
}

BOOST_AUTO_TEST_SUITE_END()
