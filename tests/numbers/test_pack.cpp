// Packs: the numbers of SIMD lanes, and dual numbers over them.
#include <boost/test/unit_test.hpp>

#include <random>

#include "actio/numbers/dual_pack.hpp"

using namespace actio;

namespace {
template <int n>
Pack<n> pack_of(std::array<double, n> const& x) {
  Pack<n> all;
  for (int k = 0; k < n; ++k) all.lane[k] = x[static_cast<std::size_t>(k)];
  return all;
}
/// A formula with all operations, of any scalar.
template <class T>
T formula(T const& x, T const& y) {
  using std::sqrt;
  return (2.0 * x - y) * x / (y + 1.5) - sqrt(x * y) + 3.0 / (x + y) - -x * 0.25;
}
}  // namespace

BOOST_AUTO_TEST_SUITE(packs)

BOOST_AUTO_TEST_CASE(roots_are_those_of_the_machine_to_a_unit_in_the_last_place) {
  std::mt19937 draw(1);
  std::uniform_real_distribution<double> exponent(-900, 900);
  for (int round = 0; round < 5000; ++round) {
    std::array<double, 8> x{};
    for (double& value : x) value = std::exp2(exponent(draw));
    auto const root = sqrt(pack_of<8>(x));
    for (std::size_t k = 0; k < 8; ++k)
      BOOST_TEST(std::abs(root.lane[k] - std::sqrt(x[k])) <= epsilon<double>() * std::sqrt(x[k]));
  }
}

BOOST_AUTO_TEST_CASE(a_comparison_holds_where_it_holds_in_all_lanes) {
  auto const x = pack_of<4>({1, 2, 3, 4}), above = pack_of<4>({2, 3, 4, 5}), mixed = pack_of<4>({2, 3, 4, 4});
  BOOST_TEST((x < above && above > x && x <= mixed));
  BOOST_TEST(!(x < mixed || mixed <= x || mixed < x || x == mixed));
  auto const none = pack_of<4>({2, 3, std::nan(""), 5});
  BOOST_TEST(!(x < none || none < x || none == none));
}

BOOST_AUTO_TEST_CASE(lanes_hold_what_a_scalar_would) {
  std::mt19937 draw(2);
  std::uniform_real_distribution<double> number(0.1, 3);
  using D = Dual<double>;
  Dual<Pack<8>> x, y;
  std::array<D, 8> xs, ys;
  for (int k = 0; k < 8; ++k) {
    auto const at = static_cast<std::size_t>(k);
    xs[at].value = number(draw), xs[at].part[0] = number(draw);
    ys[at].value = number(draw), ys[at].part[0] = number(draw);
    set_lane(x, k, xs[at]), set_lane(y, k, ys[at]);
  }
  auto const z = formula(x, y);
  auto const plain = formula(x.value, y.value);
  for (int k = 0; k < 8; ++k) {
    auto const at = static_cast<std::size_t>(k);
    D const one = formula(xs[at], ys[at]), lane = in_lane<D>(z, k);
    // A sum of seven terms up to 20.
    BOOST_TEST(std::abs(lane.value - one.value) <= 100 * epsilon<double>());
    BOOST_TEST(std::abs(lane.part[0] - one.part[0]) <= 1000 * epsilon<double>());
    BOOST_TEST(std::abs(plain.lane[k] - one.value) <= 100 * epsilon<double>());
  }
}

BOOST_AUTO_TEST_SUITE_END()
