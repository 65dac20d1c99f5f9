// Roots, exponential and logarithm in lanes, against those of the standard library in long double.
#include <boost/test/unit_test.hpp>
#include <random>

#include "actio/multisymplectic/fast_functions.hpp"

using namespace actio;
using detail::Quad;

namespace {
enum class Function { reciprocal, root_of_two, root_of_three, root_of_five, logarithm, exponential };
template <Function f>
struct Evaluation {
  Quad x, y{};
  [[gnu::always_inline]] void operator()() {
    if constexpr (f == Function::reciprocal) y = detail::inverse_root<1>(x);
    if constexpr (f == Function::root_of_two) y = detail::inverse_root<2>(x);
    if constexpr (f == Function::root_of_three) y = detail::inverse_root<3>(x);
    if constexpr (f == Function::root_of_five) y = detail::inverse_root<5>(x);
    if constexpr (f == Function::logarithm) y = detail::log(x);
    if constexpr (f == Function::exponential) y = detail::exp(x);
  }
};
template <Function f>
long double exact(long double x) {
  if constexpr (f == Function::logarithm) return std::log(x);
  if constexpr (f == Function::exponential) return std::exp(x);
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
  for (int draw = 0; draw < 60000; ++draw) {
    Evaluation<f> evaluation;
    double const width = f == Function::exponential ? (draw % 2 ? 690 : 2)
                         : draw % 3 == 0            ? 300
                         : draw % 3 == 1            ? 1
                                                    : 1e-3;
    for (int i = 0; i < 4; ++i) {
      double const u = width * one(random);
      evaluation.x.lane[i] = f == Function::exponential ? u : std::exp(u);
    }
    detail::run_with(registers, evaluation);
    for (int i = 0; i < 4; ++i) {
      long double const y = exact<f>(evaluation.x.lane[i]);
      worst = std::max(worst, static_cast<double>(std::abs((evaluation.y.lane[i] - y) / y)) / 0x1p-52);
    }
  }
  return worst;
}
}  // namespace

BOOST_AUTO_TEST_SUITE(fast_functions)

BOOST_AUTO_TEST_CASE(roots_and_elementary_functions_in_lanes_are_right_to_two_units_in_the_last_place) {
  for (Registers const registers : {Registers::plain, best_registers()}) {
    BOOST_TEST(largest_error<Function::reciprocal>(registers) <= 1);
    BOOST_TEST(largest_error<Function::root_of_two>(registers) <= 1);
    BOOST_TEST(largest_error<Function::root_of_three>(registers) <= 1);
    BOOST_TEST(largest_error<Function::root_of_five>(registers) <= 1);
    BOOST_TEST(largest_error<Function::logarithm>(registers) <= 2);
    BOOST_TEST(largest_error<Function::exponential>(registers) <= 2);
  }
}

BOOST_AUTO_TEST_CASE(the_exponential_stays_finite_and_positive_for_any_argument) {
  for (double const x : {-1e300, -800.0, 800.0, 1e300}) {
    Evaluation<Function::exponential> evaluation{Quad(x)};
    detail::run_with(best_registers(), evaluation);
    BOOST_TEST(std::isfinite(evaluation.y.lane[0]));
    BOOST_TEST(evaluation.y.lane[0] > 0);
  }
}

BOOST_AUTO_TEST_SUITE_END()
