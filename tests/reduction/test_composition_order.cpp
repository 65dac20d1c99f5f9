// Compositions: their coefficients in every precision, and their orders in 50 digits, where rounding does not
// end the slope, against power series.
#include <boost/test/unit_test.hpp>

#include "actio/reduction/composition.hpp"
#include "uneven_lagrangian.hpp"
#include "witness/number.hpp"

using namespace actio;
using namespace actio::testing;

namespace {

/// The first `count` conditions on the fractions, at worst, in units of the round-off.
template <class S>
double conditions(std::vector<S> const& fractions, int count) {
  return to_double(magnitude(composition_conditions(fractions).head(count).eval())) / to_double(epsilon<S>());
}
template <class S>
void fractions_are_right() {
  // Sums of up to nine terms of size one, each with a few roundings.
  double const room = 64;
  BOOST_TEST(conditions(triple_jump<S>(), 2) < room);
  BOOST_TEST(conditions(suzuki<S>(), 2) < room);
  BOOST_TEST(conditions(kahan_li<S>(), 4) < room);
  BOOST_TEST((magnitude(composition_conditions(triple_jump<S>())[2]) > S(1)));
  BOOST_TEST((magnitude(composition_conditions(suzuki<S>())[3]) > S(1) / S(1000)));
}

template <int side>
auto composed(UnevenLagrangian<Number> const& l, std::vector<Number> const& fractions) {
  if constexpr (side > 0)
    return ComposedRight(natural_chart_step_right(l), fractions);
  else
    return ComposedLeft(natural_chart_step_left(l), fractions);
}

template <int side>
void orders_in_fifty_digits(SpannedGroup const& group) {
  Draw draw(11);
  UnevenLagrangian<Number> const l(draw, group);
  auto const xi = draw.velocity<Number>(group);
  Number const time = ratio<Number>(1, 8);
  auto const truth = FlowByHand<Number, side>{l}.after(xi.coordinates, time);
  std::vector<int> const counts{2, 3, 4, 6, 8};
  auto const has_order = [&](std::string const& name, std::vector<Number> const& fractions, int order) {
    auto const measured = measured_order<side>(composed<side>(l, fractions), l, xi, time, counts, truth);
    BOOST_TEST_MESSAGE(group.name() << (side > 0 ? " right " : " left ") << name << ": order "
                                    << measured.slope << ", spread " << measured.spread);
    BOOST_TEST_CONTEXT(group.name() << " " << name) BOOST_TEST(std::abs(measured.slope - order) < 0.05);
  };
  has_order("natural chart", {Number(1)}, 2);
  has_order("triple jump", triple_jump<Number>(), 4);
  has_order("Suzuki", suzuki<Number>(), 4);
  has_order("Kahan-Li", kahan_li<Number>(), 6);
  // Nine stages alone do not make an order.
  if (group.dimension() == 2)
    has_order("nine equal stages", std::vector<Number>(9, Number(1) / Number(9)), 2);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(composition_order)

BOOST_AUTO_TEST_CASE(the_fractions_satisfy_the_order_conditions_in_every_precision) {
  fractions_are_right<double>();
  {
    WithArithmetic const digits(Arithmetic::decimal(100));
    fractions_are_right<Number>();
  }
  WithArithmetic const digits(Arithmetic::decimal(50));
  fractions_are_right<Number>();
  // As Kahan and Li print them, 13 decimals and 13 more; the first is taken from them.
  auto const decimals = [](long first, long more) {
    Number const unit = ratio<Number>(1, 10000000000000);
    return (Number(first) + Number(more) * unit) * unit;
  };
  std::vector<Number> const printed{
      decimals(3921614440073, 1413927925056), decimals(3325991367893, 5943859974864),
      -decimals(7062461725576, 3935980996482), decimals(822135962935, 5080023149045),
      decimals(7985439909348, 2996339895035)};
  auto const solved = kahan_li<Number>();
  for (int k = 0; k < 5; ++k) BOOST_TEST((magnitude(solved[k] - printed[k]) < 10 * decimals(0, 1)));
}

BOOST_AUTO_TEST_CASE(orders_four_and_six_on_three_groups) {
  WithArithmetic const digits(Arithmetic::decimal(50));
  orders_in_fifty_digits<-1>(four_groups()[0]);
  orders_in_fifty_digits<1>(four_groups()[1]);
  orders_in_fifty_digits<1>(four_groups()[2]);
}

BOOST_AUTO_TEST_SUITE_END()
