// Roots, logarithm and powers of two in lanes, against those of the standard library in long double.
#include <boost/test/unit_test.hpp>
#include <random>

#include "actio/stored_energy/fast_volume_laws.hpp"

using namespace actio;
using namespace actio::media;
using media::detail::Quad;

namespace {
enum class Function { reciprocal, root_of_two, root_of_three, root_of_five, logarithm, power_of_two };
template <Function f>
struct Evaluation {
  media::detail::Fourfold x, y{};
  [[gnu::always_inline]] void operator()() {
    if constexpr (f == Function::reciprocal) y = media::detail::inverse_root<1>(x);
    if constexpr (f == Function::root_of_two) y = media::detail::inverse_root<2>(x);
    if constexpr (f == Function::root_of_three) y = media::detail::inverse_root<3>(x);
    if constexpr (f == Function::root_of_five) y = media::detail::inverse_root<5>(x);
    if constexpr (f == Function::logarithm) y = media::detail::log2(x);
    if constexpr (f == Function::power_of_two) y = media::detail::exp2(x);
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
/// The slopes of a law at the corners of a register of cells.
template <class Law>
struct Slopes {
  Law law;
  Quad J[4]{}, q[4]{};
  [[gnu::always_inline]] void operator()() { law.slopes(J, q); }
};
/// The same in two halves, each for several registers of cells before the other.
template <class Law>
struct SlopesInHalves {
  static constexpr int count = 3;
  Law law;
  Quad q[count][4]{};
  [[gnu::always_inline]] void operator()() { media::detail::slopes_in_place<count>(law, q, count); }
};
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
    media::detail::run_with(registers, evaluation);
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
  for (Registers const registers : usable_registers()) {
    BOOST_TEST(largest_error<Function::reciprocal>(registers) <= 1);
    BOOST_TEST(largest_error<Function::root_of_two>(registers) <= 1);
    BOOST_TEST(largest_error<Function::root_of_three>(registers) <= 1);
    BOOST_TEST(largest_error<Function::root_of_five>(registers) <= 1);
    BOOST_TEST(largest_error<Function::logarithm>(registers) <= 4);
    BOOST_TEST(largest_error<Function::power_of_two>(registers) <= 1);
  }
}

BOOST_AUTO_TEST_CASE(slopes_of_laws_in_lanes_are_as_accurate_as_they_say) {
  auto const worst_of = [](auto const& law, auto const& slope, auto const& scale, Registers registers) {
    std::mt19937_64 random(1997);
    std::uniform_real_distribution<double> one(-3, 3);
    double worst = 0;
    for (int draw = 0; draw < 5000; ++draw) {
      Slopes<std::remove_cvref_t<decltype(law)>> evaluation{law};
      for (int i = 0; i < 16; ++i) evaluation.J[i / 4].lane[i % 4] = std::exp(one(random));
      media::detail::run_with(registers, evaluation);
      for (int i = 0; i < 16; ++i) {
        long double const J = evaluation.J[i / 4].lane[i % 4];
        long double const off = evaluation.q[i / 4].lane[i % 4] - slope(J);
        worst = std::max(worst, static_cast<double>(std::abs(off) / scale(J)) / 0x1p-52);
      }
    }
    return worst;
  };
  auto const power = [&](auto const& law, int root, int power, Registers registers) {
    auto const exact = [&](long double J) {
      return -0.7L * std::pow(J, -static_cast<long double>(power) / root);
    };
    // The factor is 0.7 in double precision.
    double const factor = 1;
    return worst_of(
               law, exact, [&](long double J) { return std::abs(exact(J)); }, registers) -
           factor;
  };
  for (Registers const registers : usable_registers()) {
    BOOST_TEST(power(PolytropicByRoots<1, 2>{0.7}, 1, 2, registers) <= 4);
    BOOST_TEST(power(PolytropicByRoots<2, 3>{0.7}, 2, 3, registers) <= 5);
    BOOST_TEST(power(PolytropicByRoots<3, 4>{0.7}, 3, 4, registers) <= 6);
    BOOST_TEST(power(PolytropicByRoots<3, 5>{0.7}, 3, 5, registers) <= 7);
    BOOST_TEST(power(PolytropicByRoots<5, 7>{0.7}, 5, 7, registers) <= 9);
    // Numbers that double precision has.
    BOOST_TEST(worst_of(
                   ReciprocalLaw{0.75, 1.5, 1.25}, [](long double J) { return 1.5L * J - 0.75L / J - 1.25L; },
                   [](long double J) { return 1.5L * J + 0.75L / J + 1.25L; }, registers) <= 4);
  }
}

// The moduli and exponents are numbers that double precision has.
BOOST_AUTO_TEST_CASE(slopes_in_halves_are_as_accurate_as_the_laws_say) {
  auto const worst_of = [](auto const& law, auto const& slope, auto const& allowed, Registers registers) {
    using Evaluation = SlopesInHalves<std::remove_cvref_t<decltype(law)>>;
    std::mt19937_64 random(1998);
    std::uniform_real_distribution<double> one(-3, 3);
    double worst = 0;
    for (int draw = 0; draw < 200; ++draw) {
      Evaluation evaluation{law};
      for (int i = 0; i < 16 * Evaluation::count; ++i)
        evaluation.q[i / 16][i / 4 % 4].lane[i % 4] = std::exp(one(random));
      Evaluation const before = evaluation;
      media::detail::run_with(registers, evaluation);
      for (int i = 0; i < 16 * Evaluation::count; ++i) {
        long double const J = before.q[i / 16][i / 4 % 4].lane[i % 4];
        long double const off = evaluation.q[i / 16][i / 4 % 4].lane[i % 4] - slope(J);
        worst = std::max(worst, static_cast<double>(std::abs(off) / allowed(J)) / 0x1p-52);
      }
    }
    return worst;
  };
  auto const power = [&]<int root, int power>(PolytropicByRoots<root, power> const& law,
                                              Registers registers) {
    auto const exact = [](long double J) {
      return -0.75L * std::pow(J, -static_cast<long double>(power) / root);
    };
    BOOST_TEST_INFO("exponent " << power << "/" << root);
    BOOST_TEST(worst_of(
                   law, exact, [&](long double J) { return -exact(J) * (power + 2); }, registers) <= 1);
  };
  for (Registers const registers : usable_registers()) {
    power(PolytropicByRoots<2, 3>{0.75}, registers);
    power(PolytropicByRoots<3, 5>{0.75}, registers);
    // Three terms of the series do not suffice any more.
    power(PolytropicByRoots<3, 20>{0.75}, registers);
    // No polynomial is fitted to the first guess.
    power(PolytropicByRoots<4, 5>{0.75}, registers);
    power(PolytropicByRoots<5, 7>{0.75}, registers);
    BOOST_TEST(worst_of(
                   PolytropicGas{0.75, 1.25}, [](long double J) { return -0.75L * std::pow(J, -1.25L); },
                   [](long double J) {
                     return 0.75L * std::pow(J, -1.25L) * (4 + 5 * 1.25L * std::abs(std::log(J)));
                   },
                   registers) <= 1);
    BOOST_TEST(
        worst_of(
            LogarithmicLaw{0.75, 0.625}, [](long double J) { return (0.75L * std::log(J) - 0.625L) / J; },
            [](long double J) { return 8 * (0.625L + 0.75L * std::abs(std::log(J))) / J; }, registers) <= 1);
  }
}

BOOST_AUTO_TEST_CASE(powers_of_two_stay_where_they_are_for_arguments_beyond_a_thousand) {
  for (double const x : {-1e300, -1001.0, -1000.0, 1000.0, 1001.0, 1e300}) {
    Evaluation<Function::power_of_two> evaluation{{Quad(x), Quad(x), Quad(x), Quad(x)}};
    media::detail::run_with(best_registers(), evaluation);
    for (Quad const& y : evaluation.y.quad)
      for (int lane = 0; lane < 4; ++lane) BOOST_TEST(y.lane[lane] == std::ldexp(1.0, x < 0 ? -1000 : 1000));
  }
}

BOOST_AUTO_TEST_SUITE_END()
