// What is no point, and what is no map, is refused.
#include <boost/test/unit_test.hpp>

#include "actio/groups/rotations.hpp"
#include "actio/groups/spanned_group.hpp"
#include "actio/instruments/leaf_defect.hpp"
#include "actio/instruments/momentum_defect.hpp"
#include "actio/instruments/poisson_defect.hpp"
#include "actio/instruments/reversibility_defect.hpp"
#include "actio/instruments/symplectic_defect.hpp"
#include "actio/variational/momentum_map.hpp"
#include "refused.hpp"

using namespace actio;
using Vector3d = actio::Vector<double, 3>;

namespace {

LiePoissonPlus const momenta;
double const no_number = std::nan("");
auto const fine = momentum(SO<3>{}, Vector3d(0.75, -1.25, 0.5));
Costate<SO<3>, double> const costate{identity<double>(SO<3>{}), fine};
auto const stay = [](auto const& x) { return x; };
auto const wait = [](auto const&, auto const& x) { return x; };
auto const square = [](auto const& mu) { return mu.components.squaredNorm(); };

SpannedGroup plane_turns() {
  SpannedGroup::WholeMatrix turn(2, 2);
  turn << 0, -1, 1, 0;
  return SpannedGroup("SO(2)", {turn});
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_point_that_is_no_number_is_refused) {
  for (double const bad : {no_number, HUGE_VAL, -HUGE_VAL}) {
    auto const broken = momentum(SO<3>{}, Vector3d(0.75, bad, 0.5));
    CHECK_REFUSED(poisson_defect(momenta, stay, broken), NotFinite);
    CHECK_REFUSED(orbit_defect(stay, broken), NotFinite);
    CHECK_REFUSED(casimir_defect(momenta, stay, broken, square), NotFinite);
    CHECK_REFUSED(leaf_defect(momenta, wait, 0.1, broken), NotFinite);
    CHECK_REFUSED(leaf_defect(momenta, wait, bad, fine), NotFinite);
    CHECK_REFUSED(self_adjointness_defect(momenta, wait, 0.1, broken), NotFinite);
    CHECK_REFUSED(self_adjointness_defect(momenta, wait, bad, fine), NotFinite);
    CHECK_REFUSED(reversibility_defect(momenta, stay, broken, stay), NotFinite);
    CHECK_REFUSED(
        symplectic_defect(CotangentBundle{}, stay, Costate<SO<3>, double>{costate.configuration, broken}),
        NotFinite);
    auto twisted = costate;
    twisted.configuration.value(1, 2) = bad;
    CHECK_REFUSED(symplectic_defect(CotangentBundle{}, stay, twisted), NotFinite);
    CHECK_REFUSED(momentum_defect(CotangentBundle{}, stay, twisted,
                                  left_translation(basis_velocity<double>(SO<3>{}, 0))),
                  NotFinite);
    CHECK_REFUSED(momentum_defect(CotangentBundle{}, stay, costate,
                                  left_translation(velocity(SO<3>{}, Vector3d(0, bad, 0)))),
                  NotFinite);
  }
}

BOOST_AUTO_TEST_CASE(a_map_to_no_number_is_refused) {
  auto const lost = [](auto const& x) {
    auto y = x;
    y.components[1] = y.components[1] * no_number;
    return y;
  };
  CHECK_REFUSED(poisson_defect(momenta, lost, fine), NotFinite);
  CHECK_REFUSED(orbit_defect(lost, fine), NotFinite);
  CHECK_REFUSED(casimir_defect(momenta, lost, fine, square), NotFinite);
  CHECK_REFUSED(leaf_defect(
                    momenta, [&](auto const&, auto const& x) { return lost(x); }, 0.1, fine),
                NotFinite);
  CHECK_REFUSED(self_adjointness_defect(
                    momenta, [&](auto const&, auto const& x) { return lost(x); }, 0.1, fine),
                NotFinite);
  CHECK_REFUSED(
      casimir_defect(momenta, stay, fine, [](auto const& mu) { return mu.components[0] * no_number; }),
      NotFinite);
  // A map with a value and no derivative: the root of zero.
  auto const pointed = [](auto const& x) {
    using std::sqrt;
    auto y = x;
    y.components[0] += sqrt(x.components[1] - x.components[1]);
    return y;
  };
  auto const root = [](auto const& x) {
    using std::sqrt;
    auto y = x;
    y.components[0] = sqrt(x.components[2]);
    return y;
  };
  CHECK_REFUSED(poisson_defect(momenta, pointed, fine), NotFinite);
  CHECK_REFUSED(poisson_defect(momenta, root, momentum(SO<3>{}, Vector3d(1, 1, 0))), NotFinite);
}

BOOST_AUTO_TEST_CASE(a_momentum_of_the_wrong_length_is_refused) {
  auto const group = plane_turns();
  Momentum<SpannedGroup, double> const short_of_one{group, Vector<double>::Zero(0)},
      one_too_many{group, Vector<double>::Ones(2)}, right{group, Vector<double>::Ones(1)};
  BOOST_TEST(poisson_defect(momenta, stay, right) == 0);
  CHECK_REFUSED(poisson_defect(momenta, stay, short_of_one), OutsideDomain);
  BOOST_CHECK_EXCEPTION(poisson_defect(momenta, stay, one_too_many), OutsideDomain,
                        [](OutsideDomain const& e) { return e.measured == 2 && e.bound == 1; });
  auto const longer = [](auto const& x) {
    auto y = x;
    y.components.resize(2);
    y.components[0] = y.components[1] = x.components[0];
    return y;
  };
  CHECK_REFUSED(poisson_defect(momenta, longer, right), OutsideDomain);
  CHECK_REFUSED(orbit_defect(longer, right), OutsideDomain);
}

BOOST_AUTO_TEST_CASE(a_step_of_zero_and_a_reversal_that_is_none_are_refused) {
  CHECK_REFUSED(self_adjointness_defect(momenta, wait, 0.0, fine), OutsideDomain);
  CHECK_REFUSED(leaf_defect(momenta, wait, 0.0, fine), OutsideDomain);
  auto const third_of_a_turn = [](auto const& x) {
    return std::decay_t<decltype(x)>{x.group, {x.components[1], x.components[2], x.components[0]}};
  };
  CHECK_REFUSED(reversibility_defect(momenta, stay, fine, third_of_a_turn), OutsideDomain);
}
