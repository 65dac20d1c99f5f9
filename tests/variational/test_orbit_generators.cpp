// Generators of tangent vectors of coadjoint orbits on groups of several kinds, exactly; and refusals with
// what was measured.
#include <boost/test/unit_test.hpp>

#include "actio/groups/linear_groups.hpp"
#include "actio/groups/motions.hpp"
#include "actio/groups/special_linear.hpp"
#include "actio/variational/action.hpp"
#include "actio/variational/coadjoint_orbit.hpp"
#include "caught.hpp"
#include "witness/draw.hpp"
#include "witness/number.hpp"

using namespace actio;
using testing::caught;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

/// The form of Kirillov and Kostant by its definition: two tangent vectors whose generators are known.
template <class G>
void is_exact_on(G const& group) {
  FineDraw draw(17);
  for (int sample = 0; sample < 3; ++sample) {
    auto const mu = draw.momentum<Number>(group);
    auto const one = draw.velocity<Number>(group), two = draw.velocity<Number>(group);
    auto const v = ad_star(one, mu), w = ad_star(two, mu);
    // The generator found may be another one; what it does to the momentum is the same.
    BOOST_TEST((ad_star(orbit_generator(mu, v), mu).components == v.components));
    Number const known = pair(mu, bracket(one, two));
    BOOST_TEST((kirillov_kostant_plus(mu, v, w) == known));
    BOOST_TEST((kirillov_kostant_minus(mu, v, w) == -known));
    BOOST_TEST((known != 0));
  }
}

}  // namespace

BOOST_AUTO_TEST_SUITE(orbit_generators)

BOOST_AUTO_TEST_CASE(generators_and_the_form_on_orbits_are_exact_over_the_rationals) {
  WithArithmetic const exactly(Arithmetic::rationals());
  is_exact_on(SO<3>{});
  is_exact_on(SE<2>{});
  is_exact_on(SE<3>{});
  is_exact_on(GL<2>{});
  is_exact_on(SL<3>{});
}

BOOST_AUTO_TEST_CASE(a_vector_outside_is_refused_with_what_elimination_leaves_of_it) {
  // The orbit of (2, 3, 6) is a sphere. The entries with 6 are eliminated first, and of w there is left
  // <mu, w>/6.
  auto const mu = momentum(SO<3>{}, Vector<double, 3>(2, 3, 6)),
             w = momentum(SO<3>{}, Vector<double, 3>(1, 1, -2));
  auto const e = caught<OutsideDomain>([&] { orbit_generator(mu, w); });
  BOOST_TEST(std::abs(e.measured - 7.0 / 6) < 8 * eps);
  BOOST_TEST(e.bound == 16 * 256 * 3 * eps * 2);
  // At rest nothing moves, and nothing is needed for that.
  auto const none = momentum(SO<3>{}, Vector<double, 3>(0, 0, 0));
  BOOST_TEST((orbit_generator(none, none).coordinates == none.components));
}

BOOST_AUTO_TEST_CASE(a_quadrature_of_a_negative_degree_is_refused) {
  auto const e = caught<OutsideDomain>([&] { Quadrature<double> const rule(-1); });
  BOOST_TEST(e.measured == -1);
  BOOST_TEST(e.bound == 0);
  BOOST_TEST(Quadrature<double>(0).nodes.size() == 1u);
}

BOOST_AUTO_TEST_SUITE_END()
