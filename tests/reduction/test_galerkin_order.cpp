// The orders of Galerkin steps, twice the degree, in 50 digits against power series.
#include <boost/test/unit_test.hpp>

#include "actio/reduction/galerkin.hpp"
#include "refused.hpp"
#include "uneven_lagrangian.hpp"
#include "witness/number.hpp"

using namespace actio;
using namespace actio::testing;

namespace {

template <int side>
void has_order_twice_its_degree(SpannedGroup const& group, int largest_degree) {
  Draw draw(11);
  UnevenLagrangian<Number> const l(draw, group);
  auto const xi = draw.velocity<Number>(group);
  Number const time = ratio<Number>(1, 8);
  auto const truth = FlowByHand<Number, side>{l}.after(xi.coordinates, time);
  for (int s = 1; s <= largest_degree; ++s) {
    auto const step = [&] {
      if constexpr (side > 0)
        return galerkin_step_right<Number>(l, s);
      else
        return galerkin_step_left<Number>(l, s);
    }();
    auto const measured = measured_order<side>(step, l, xi, time, {2, 3, 4, 6, 8}, truth);
    BOOST_TEST_MESSAGE(group.name() << (side > 0 ? " right" : " left") << " s = " << s << ": order "
                                    << measured.slope << ", spread " << measured.spread);
    BOOST_TEST_CONTEXT(group.name() << " s = " << s) BOOST_TEST(std::abs(measured.slope - 2 * s) < 0.05);
  }
}

}  // namespace

BOOST_AUTO_TEST_SUITE(galerkin_order)

BOOST_AUTO_TEST_CASE(gauss_rules_are_exact_below_twice_the_number_of_nodes_and_no_further) {
  WithArithmetic const digits(Arithmetic::decimal(50));
  for (int s = 1; s <= 8; ++s) {
    auto const rule = gauss_quadrature<Number>(s);
    for (int degree = 0; degree <= 2 * s; ++degree) {
      Number sum(0);
      for (int i = 0; i < s; ++i) sum += rule.weights[i] * pow(rule.nodes[i], degree);
      Number const wrong = magnitude(sum - Number(1) / Number(degree + 1));
      if (degree < 2 * s)
        BOOST_TEST((wrong < 64 * epsilon<Number>()));
      else
        BOOST_TEST((wrong > ratio<Number>(1, 1000000000000)));
    }
  }
  auto const many = gauss_quadrature<double>(200);
  BOOST_TEST(std::is_sorted(many.nodes.begin(), many.nodes.end()));
  CHECK_REFUSED(gauss_quadrature<double>(0), OutsideDomain);
  CHECK_REFUSED(gauss_quadrature<double>(-3), OutsideDomain);
  CHECK_REFUSED(PolynomialPath<double>(0), OutsideDomain);
  CHECK_REFUSED(PolynomialPath<double>(9), OutsideDomain);
}

BOOST_AUTO_TEST_CASE(the_order_is_twice_the_degree) {
  WithArithmetic const digits(Arithmetic::decimal(50));
  has_order_twice_its_degree<-1>(four_groups()[0], 3);
  has_order_twice_its_degree<1>(four_groups()[1], 3);
  has_order_twice_its_degree<1>(four_groups()[2], 4);
  has_order_twice_its_degree<-1>(four_groups()[3], 2);
}

BOOST_AUTO_TEST_SUITE_END()
