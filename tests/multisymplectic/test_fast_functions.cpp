// Roots, logarithm and powers of two in lanes, against those of the standard library in long double.
#include <boost/test/unit_test.hpp>
#include <random>

#include "actio/multisymplectic/fast_functions.hpp"

using namespace actio;
using detail::Quad;

namespace {
enum class Function { reciprocal, root_of_two, root_of_three, root_of_five, logarithm, power_of_two };
template <Function f>
struct Evaluation {
  detail::Fourfold x, y{};
  [[gnu::always_inline]] void operator()() {
    if constexpr (f == Function::reciprocal) y = detail::inverse_root<1>(x);
    if constexpr (f == Function::root_of_two) y = detail::inverse_root<2>(x);
    if constexpr (f == Function::root_of_three) y = detail::inverse_root<3>(x);
    if constexpr (f == Function::root_of_five) y = detail::inverse_root<5>(x);
    if constexpr (f == Function::logarithm) y = detail::log2(x);
    if constexpr (f == Function::power_of_two) y = detail::exp2(x);
  }
};
template <Function f>
long double exact(long double x) {
  if constexpr (f == Function::logarithm) return std::log2(x);
  if constexpr (f == Function::power_of_two) return std::exp2(x);
  long double const n = f == Function::reciprocal      ? 1
                        : f == Function::root_of_two   ? 2
                        : f == Function::root_of_three ? 3
                                                       : 5;
  return std::pow(x, -1 / n);
}
/// The largest relative error, in units of the last place, over arguments of all sizes and next to 1.
template <Function f>
double largest_error(Registers registers) {
  std::mt19937_64 random(1997);
  std::uniform_real_distribution<double> one(-1, 1);
  double worst = 0;
  for (int draw = 0; draw < 15000; ++draw) {
    Evaluation<f> evaluation;
    double const width = f == Function::power_of_two ? (draw % 2 ? 990 : 2)
                         : draw % 3 == 0             ? 300
                         : draw % 3 == 1             ? 1
                                                     : 1e-3;
    for (int i = 0; i < 16; ++i) {
      double const u = width * one(random);
      evaluation.x.quad[i / 4].lane[i % 4] = f == Function::power_of_two ? u : std::exp(u);
    }
    detail::run_with(registers, evaluation);
    for (int i = 0; i < 16; ++i) {
      long double const y = exact<f>(evaluation.x.quad[i / 4].lane[i % 4]);
      worst = std::max(
          worst, static_cast<double>(std::abs((evaluation.y.quad[i / 4].lane[i % 4] - y) / y)) / 0x1p-52);
    }
  }
  return worst;
}
}  // namespace

BOOST_AUTO_TEST_SUITE(fast_functions)

BOOST_AUTO_TEST_CASE(roots_logarithms_and_powers_in_lanes_are_right_to_some_units_in_the_last_place) {
  for (Registers const registers : {Registers::plain, best_registers()}) {
    BOOST_TEST(largest_error<Function::reciprocal>(registers) <= 1);
    BOOST_TEST(largest_error<Function::root_of_two>(registers) <= 1);
    BOOST_TEST(largest_error<Function::root_of_three>(registers) <= 1);
    BOOST_TEST(largest_error<Function::root_of_five>(registers) <= 1);
    BOOST_TEST(largest_error<Function::logarithm>(registers) <= 4);
    BOOST_TEST(largest_error<Function::power_of_two>(registers) <= 1);
  }
}

BOOST_AUTO_TEST_CASE(powers_of_two_stay_finite_and_positive_for_any_argument) {
  for (double const x : {-1e300, -1001.0, 1001.0, 1e300}) {
    Evaluation<Function::power_of_two> evaluation{{Quad(x), Quad(x), Quad(x), Quad(x)}};
    detail::run_with(best_registers(), evaluation);
    BOOST_TEST(std::isfinite(evaluation.y.quad[3].lane[0]));
    BOOST_TEST(evaluation.y.quad[3].lane[0] > 0);
  }
}

BOOST_AUTO_TEST_SUITE_END()
