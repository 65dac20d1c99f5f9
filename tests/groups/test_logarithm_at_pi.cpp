// At half a turn the logarithm has no value, and says so; next to it, it has one.
#include <boost/test/unit_test.hpp>

#include "actio/groups/motions.hpp"
#include "actio/groups/unit_quaternions.hpp"
#include "angles_next_to_pi.hpp"
#include "witness/number.hpp"

using namespace actio;
using namespace actio::testing;

namespace {

/// Whether log refuses, and says that it measured half a turn (or `measured`).
template <Group G, class M>
bool refuses(G const& group, M const& value, double measured = M_PI) {
  try {
    log(Element<G, typename M::Scalar>{group, value});
  } catch (OutsideDomain const& refusal) {
    return std::abs(refusal.measured - measured) < 1e-7 &&
           std::string(refusal.what()).find("(3.19)") != std::string::npos;
  }
  return false;
}
/// exp(v) with the angle rounded to double.
template <Group G>
auto half_a_turn(G const& group, Coordinates<G, Number> const& v) {
  return exp(velocity(group, Coordinates<G, double>(in_double(v)))).value;
}

}  // namespace

BOOST_AUTO_TEST_CASE(log_refuses_at_pi) {
  WithArithmetic const digits(Arithmetic::decimal(50));
  Draw draw(7);
  Number const pi = acos(Number(-1));
  int refused = 0, tried = 0;
  for (int repeat = 0; repeat < 200; ++repeat) {
    tried += 7;
    refused += refuses(SO<2>{}, half_a_turn(SO<2>{}, Coordinates<SO<2>, Number>(pi)));
    refused += refuses(SO<3>{}, half_a_turn(SO<3>{}, Coordinates<SO<3>, Number>(direction<3>(draw) * pi)));
    refused +=
        refuses(SU2{}, half_a_turn(SU2{}, Coordinates<SU2, Number>(direction<3>(draw) * pi * 2)), 2 * M_PI);
    Coordinates<SE<2>, Number> plane;
    plane << pi, direction<2>(draw);
    refused += refuses(SE<2>{}, half_a_turn(SE<2>{}, plane));
    Coordinates<SE<3>, Number> space;
    space << direction<3>(draw) * pi, direction<3>(draw);
    refused += refuses(SE<3>{}, half_a_turn(SE<3>{}, space));
    refused += refuses(SO<4>{}, half_a_turn(SO<4>{}, in_a_random_frame<4>(draw, pi, draw.number<Number>())));
    refused += refuses(SO<5>{}, half_a_turn(SO<5>{}, in_a_random_frame<5>(draw, pi, draw.number<Number>())));
  }
  BOOST_TEST(refused == tried);
  BOOST_TEST(refuses(SO<4>{}, Matrix<double, 4, 4>(-Matrix<double, 4, 4>::Identity())));
  BOOST_TEST(refuses(SO<3>{}, Matrix<double, 3, 3>(Vector<double, 3>(-1, 1, -1).asDiagonal())));
}

BOOST_AUTO_TEST_CASE(a_refusal_at_pi_is_not_a_refusal_of_everything) {
  WithArithmetic const digits(Arithmetic::decimal(50));
  // The control of the refusal: a hair inside, the logarithm is there.
  Number const before = angle_before_pi(8);
  BOOST_TEST(!refuses(SO<2>{}, half_a_turn(SO<2>{}, Coordinates<SO<2>, Number>(before))));
  BOOST_TEST(
      !refuses(SO<3>{}, half_a_turn(SO<3>{}, Coordinates<SO<3>, Number>(Number(0), before, Number(0)))));
  Draw draw(8);
  BOOST_TEST(!refuses(SO<4>{}, half_a_turn(SO<4>{}, in_a_random_frame<4>(draw, before, Number(1)))));
  BOOST_TEST(!refuses(SO<5>{}, half_a_turn(SO<5>{}, in_a_random_frame<5>(draw, before, Number(1)))));
}
