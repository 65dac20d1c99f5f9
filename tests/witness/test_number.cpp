// Number against the numbers it stands for: double bit by bit, Boost's rationals and its 50 and 100 digits,
// the laws of a field, balls that hold what they should, and refusals.
#include <boost/test/unit_test.hpp>

#include <bit>
#include <cmath>
#include <initializer_list>
#include <string>
#include <vector>

#include "actio/forms/metric.hpp"
#include "actio/linear_algebra/linear.hpp"
#include "actio/numbers/multiprecision.hpp"
#include "actio/numbers/second_order.hpp"
#include "actio/numbers/square_root.hpp"
#include "refused.hpp"
#include "witness/draw.hpp"
#include "witness/number.hpp"
#include "witness/number_counts.hpp"

namespace {

using namespace actio;

/// A formula with all four operations, over any scalar: continued fractions and products of the numbers
/// before.
template <class S>
std::vector<S> formula(std::vector<S> x, int rounds) {
  for (int k = 0; k < rounds; ++k) {
    std::size_t const n = x.size();
    S const a = x[n - 1], b = x[n - 2], c = x[n - 3];
    S next = (a * b - c / (b * b + S(2))) / (S(3) + a * a) - S(k % 5) / S(7);
    next += c;
    next *= S(3);
    next /= S(4);
    next -= a / S(2);
    add_product(next, a, c);
    x.push_back(-next / (1 + next * next) + 1 - ratio<S>(k % 7, 9));
  }
  return x;
}
template <class S>
std::vector<S> starts() { return {ratio<S>(1, 3), ratio<S>(-5, 7), ratio<S>(11, 64)}; }

}  // namespace

BOOST_AUTO_TEST_CASE(hardware_numbers_round_as_double_does) {
  auto const mine = formula(starts<Number>(), 200);
  auto const plain = formula(starts<double>(), 200);
  for (std::size_t k = 0; k < plain.size(); ++k)
    BOOST_TEST(std::bit_cast<std::uint64_t>(to_double(mine[k])) == std::bit_cast<std::uint64_t>(plain[k]));
  for (double const x : {0.3, 0.7, 0.99}) {
    Number const y(x);
    BOOST_TEST(to_double(sqrt(y)) == std::sqrt(x));
    BOOST_TEST(to_double(exp(y)) == std::exp(x));
    BOOST_TEST(to_double(log(y)) == std::log(x));
    BOOST_TEST(to_double(sin(y)) == std::sin(x));
    BOOST_TEST(to_double(cos(y)) == std::cos(x));
    BOOST_TEST(to_double(acos(y)) == std::acos(x));
    BOOST_TEST(to_double(atan2(y, Number(2))) == std::atan2(x, 2.0));
    BOOST_TEST(to_double(pow(y, Number(1.5))) == std::pow(x, 1.5));
  }
  BOOST_TEST(to_double(epsilon<Number>()) == std::numeric_limits<double>::epsilon());
  BOOST_TEST(!is_finite(Number(1) / Number(0)));
  BOOST_TEST(std::signbit(to_double(-Number(0))));
}

BOOST_AUTO_TEST_CASE(rational_numbers_are_those_of_gmp) {
  WithArithmetic const over(Arithmetic::rationals());
  // Far beyond 64 bits: the numbers grow fivefold at each round.
  auto const mine = formula(starts<Number>(), 4);
  auto const plain = formula(starts<rational>(), 4);
  for (std::size_t k = 0; k < plain.size(); ++k) {
    BOOST_TEST(to_double(mine[k]) == to_double(plain[k]));
    // Equal as fractions: the same formula gives 0 with numerator and denominator read from Boost.
    auto const read = [](boost::multiprecision::mpz_int z) {
      bool const negative = z < 0;
      if (negative) z = -z;
      std::string const digits = z.str();
      Number x(0);
      for (char const c : digits) x = x * 10 + int(c - '0');
      return negative ? -x : x;
    };
    BOOST_TEST((mine[k] == read(numerator(plain[k])) / read(denominator(plain[k]))));
  }
  BOOST_TEST((mine[3] < mine[4]) == (plain[3] < plain[4]));
  BOOST_TEST((magnitude(mine.back()) > Number(1)) == (magnitude(plain.back()) > rational(1)));
  // At the edge of 64 bits, there and back.
  Number const large(INT64_MAX), least(INT64_MIN);
  BOOST_TEST((large + 1 == -least));
  BOOST_TEST((large + 1 - 1 == large));
  BOOST_TEST((large * large / large == large));
  BOOST_TEST((least / least == Number(1)));
  BOOST_TEST((Number(0.1) * Number(std::ldexp(1.0, 60)) == Number(0.1 * std::ldexp(1.0, 60))));
  BOOST_TEST((sqrt(ratio<Number>(49, 64)) == ratio<Number>(7, 8)));
}

namespace {
/// The four operations and the root are rounded to the nearest number by both, so they agree to the last bit.
template <class S>
void agrees_with_boost(int digits) {
  WithArithmetic const over(Arithmetic::decimal(digits));
  auto const mine = formula(starts<Number>(), 200);
  auto const plain = formula(starts<S>(), 200);
  BOOST_TEST(to_double(epsilon<Number>()) == to_double(epsilon<S>()));
  for (std::size_t k = 0; k < plain.size(); ++k) {
    // The difference as digits: all of them are sent over in pieces of 50 bits.
    S rest = plain[k];
    Number sum(0);
    for (int piece = 0; piece < 8; ++piece) {
      double const part = static_cast<double>(rest);
      rest -= S(part);
      sum += Number(part);
    }
    BOOST_TEST((rest == 0));
    BOOST_TEST((sum == mine[k]));
  }
  Number const x = ratio<Number>(2, 3);
  S const y = ratio<S>(2, 3);
  auto const near = [&](Number const& a, S const& b) {
    S rest = b;
    Number sum(0);
    for (int piece = 0; piece < 8; ++piece) {
      double const part = static_cast<double>(rest);
      rest -= S(part);
      sum += Number(part);
    }
    BOOST_TEST((magnitude(a - sum) <= 4 * epsilon<Number>() * magnitude(a)));
  };
  near(sqrt(x), sqrt(y));
  near(exp(x), exp(y));
  near(log(x), log(y));
  near(sin(x), sin(y));
  near(cos(x), cos(y));
  near(acos(x), acos(y));
  near(atan2(x, Number(-3)), atan2(y, S(-3)));
  near(pow(x, ratio<Number>(5, 2)), pow(y, ratio<S>(5, 2)));
}
}  // namespace

BOOST_AUTO_TEST_CASE(fifty_and_a_hundred_digits_are_those_of_boost) {
  agrees_with_boost<dec50>(50);
  agrees_with_boost<dec100>(100);
}

BOOST_AUTO_TEST_CASE(a_prime_field_has_the_laws_of_one) {
  for (std::uint64_t const p : {Arithmetic::mersenne, Arithmetic::mersenne - 44}) {
    if (!is_prime(p)) continue;
    WithArithmetic const over(Arithmetic::prime_field(p));
    Draw draw(7);
    for (int k = 0; k < 300; ++k) {
      Number const a = draw.number<Number>(), b = draw.number<Number>(), c = draw.number<Number>();
      BOOST_TEST(((a + b) + c == a + (b + c)));
      BOOST_TEST(((a * b) * c == a * (b * c)));
      BOOST_TEST((a * (b + c) == a * b + a * c));
      BOOST_TEST((a - a == Number(0)));
      BOOST_TEST((a / a == Number(1)));
      BOOST_TEST((a / b * b == a));
      // Fermat: a^(p-1) = 1.
      Number power(1), square = a;
      for (std::uint64_t e = p - 1; e != 0; e >>= 1, square *= square)
        if (e & 1) power *= square;
      BOOST_TEST((power == Number(1)));
      if (p % 4 == 3) {
        // Of the two roots the one that is a square, so that roots of products are products of roots.
        Number const root = sqrt(a * a), other = sqrt(b * b);
        BOOST_TEST((root * root == a * a));
        BOOST_TEST((sqrt(a * a * b * b) == root * other));
        BOOST_TEST((sqrt(root) * sqrt(root) == root));
        CHECK_REFUSED(sqrt(-(a * a)), NotASquare);
      }
    }
    BOOST_TEST((Number(-1) + 1 == Number(0)));
    BOOST_TEST((Number(0.375) * 8 == Number(3)));
    BOOST_TEST((Number(std::ldexp(1.0, 70)) == Number(1 << 10) * Number(std::int64_t(1) << 60)));
  }
}

BOOST_AUTO_TEST_CASE(primes_are_told_from_other_numbers) {
  for (std::uint64_t const p : {2ull, 3ull, 65537ull, 2305843009213693951ull, 2147483647ull})
    BOOST_TEST(is_prime(p));
  // A product of two primes near 2^31, the square of one, Carmichael's numbers, and strong pseudoprimes to
  // the first bases.
  for (std::uint64_t const n : {2147483647ull * 2147483629ull, 2147483647ull * 2147483647ull, 561ull, 1105ull,
                                3215031751ull, 3825123056546413051ull, 2305843009213693953ull, 1ull, 0ull})
    BOOST_TEST(!is_prime(n));
}

BOOST_AUTO_TEST_CASE(a_field_number_knows_its_degree) {
  WithArithmetic const over(Arithmetic::prime_field());
  Draw draw(3);
  auto const drawn = [&] { return draw.number<Number>(); };
  Number const x = drawn(), y = drawn(), z = drawn();
  auto const is = [](Number const& a, float numerator, float denominator) {
    BOOST_TEST(a.degree().numerator == numerator);
    BOOST_TEST(a.degree().denominator == denominator);
  };
  is(Number(5), 0, 0);
  is(x, 1, 0);
  is(x * y * z + 3 * x - 7, 3, 0);
  is(x / y, 1, 1);
  is(x / y + z, 2, 1);
  is(x / y + y / x, 2, 2);
  is(Number(0) * (x / y), 0, 0);
  is(x - x, 1, 0);
  is((x - x) * y, 2, 0);
  is(sqrt(x * x), 2, 0);
  // Degrees that a float does not hold are rounded up, never down.
  Number power = x;
  double degree = 1;
  for (int k = 0; k < 60; ++k) power *= power * x, degree = 2 * degree + 1;
  BOOST_TEST(power.degree().numerator >= degree);
  BOOST_TEST(power.degree().numerator <= degree * 1.001);
}

BOOST_AUTO_TEST_CASE(balls_hold_the_true_value) {
  // The same formula in 400 digits is the truth.
  std::vector<double> low, high;
  std::vector<std::string> narrow;
  {
    WithArithmetic const over(Arithmetic::balls(30));
    for (auto const& x : formula(starts<Number>(), 60)) {
      BOOST_TEST(is_finite(x));
      BOOST_TEST((x.lower() <= x.upper()));
      low.push_back(to_double(x.lower())), high.push_back(to_double(x.upper()));
    }
    Number const third = Number(1) / 3;
    BOOST_TEST((third * 3 - 1).holds_zero());
    BOOST_TEST(!third.holds_zero());
    BOOST_TEST((third < Number(1) && Number(0) < third));
    CHECK_REFUSED((third * 3 < Number(1)), Undecided);
    CHECK_REFUSED(Number(1) / (third * 3 - 1), Undecided);
    Number const e = exp(Number(1));
    BOOST_TEST((log(e) - 1).holds_zero());
    BOOST_TEST((magnitude(log(e) - 1) < ratio<Number>(1, 1000000) / 1000000));
    BOOST_TEST((sin(third) * sin(third) + cos(third) * cos(third) - 1).holds_zero());
    // All numbers between two.
    Number const segment = Number::between(third, Number(2));
    BOOST_TEST((segment.lower() <= third.lower() && Number(2) <= segment.upper()));
    CHECK_REFUSED((segment < Number(1)), Undecided);
    BOOST_TEST((Number(0) < segment && segment < Number(3)));
    BOOST_TEST((exp(segment) - exp(Number(1))).holds_zero());
  }
  CHECK_REFUSED(Number::between(Number(0), Number(1)), Error);
  WithArithmetic const over(Arithmetic::decimal(400));
  auto const truth = formula(starts<Number>(), 60);
  for (std::size_t k = 0; k < truth.size(); ++k) {
    BOOST_TEST(std::nextafter(low[k], -HUGE_VAL) <= to_double(truth[k]));
    BOOST_TEST(to_double(truth[k]) <= std::nextafter(high[k], HUGE_VAL));
  }
}

BOOST_AUTO_TEST_CASE(what_an_arithmetic_lacks_it_refuses) {
  for (Arithmetic const& exact : {Arithmetic::rationals(), Arithmetic::prime_field()}) {
    WithArithmetic const over(exact);
    Number const x = ratio<Number>(2, 3);
    for (auto f : std::initializer_list<Number (*)(Number const&)>{exp, log, sin, cos, tan, asin, acos, atan,
                                                                   sinh, cosh, tanh})
      CHECK_REFUSED(f(x), NotInThisField);
    CHECK_REFUSED(pow(x, ratio<Number>(1, 2)), NotInThisField);
    CHECK_REFUSED(atan2(x, x), NotInThisField);
    CHECK_REFUSED(x / Number(0), DivisionByZero);
    CHECK_REFUSED(Number(std::nan("")), NotFinite);
    BOOST_TEST((pow(x, Number(3)) == x * x * x));
    BOOST_TEST((pow(x, Number(-2)) == 1 / (x * x)));
    BOOST_TEST((epsilon<Number>() == Number(0)));
  }
  {
    WithArithmetic const over(Arithmetic::prime_field());
    Number const x = ratio<Number>(2, 3);
    CHECK_REFUSED((x < Number(1)), NoOrder);
    CHECK_REFUSED((x >= x), NoOrder);
    BOOST_TEST((Number(0) < Number(1)));
    BOOST_TEST((magnitude(x) == Number(1)));
    BOOST_TEST(std::isnan(to_double(x)));
    BOOST_TEST(is_finite(x));
  }
  {
    // Modulo a prime that is 1 mod 4 roots are not taken.
    std::uint64_t p = (std::uint64_t(1) << 50) + 1;
    while (!is_prime(p) || p % 4 != 1) p += 2;
    WithArithmetic const over(Arithmetic::prime_field(p));
    CHECK_REFUSED(sqrt(Number(4)), NotInThisField);
  }
  {
    WithArithmetic const over(Arithmetic::rationals());
    CHECK_REFUSED(sqrt(Number(2)), NotASquare);
    CHECK_REFUSED(sqrt(Number(-4)), NotASquare);
  }
  CHECK_REFUSED(Arithmetic::decimal(15), OutsideDomain);
  CHECK_REFUSED(Arithmetic::decimal(1'000'000), OutsideDomain);
  CHECK_REFUSED(Arithmetic::balls(0), OutsideDomain);
  CHECK_REFUSED(Arithmetic::prime_field(1000003), OutsideDomain);
  CHECK_REFUSED(Arithmetic::prime_field((std::uint64_t(1) << 61) + 1), OutsideDomain);
  CHECK_REFUSED(Arithmetic::prime_field(0), OutsideDomain);
}

BOOST_AUTO_TEST_CASE(small_numbers_allocate_nothing) {
  auto const runs = [](Arithmetic const& arithmetic, auto const& body) {
    WithArithmetic const over(arithmetic);
    std::uint64_t const before = cells_allocated();
    body();
    return cells_allocated() - before;
  };
  auto const many = [] { formula(starts<Number>(), 50); };
  auto const few = [] { formula(starts<Number>(), 2); };
  auto const whole = [] {
    Number sum(0);
    for (int k = 0; k < 100; ++k) sum += Number(k) * Number(k) - 1;
    BOOST_TEST((sum == Number(328250)));
  };
  BOOST_TEST(runs(Arithmetic::hardware(), many) == 0);
  BOOST_TEST(runs(Arithmetic::prime_field(), many) == 0);
  BOOST_TEST(runs(Arithmetic::rationals(), few) == 0);
  BOOST_TEST(runs(Arithmetic::decimal(50), whole) == 0);
  BOOST_TEST(runs(Arithmetic::balls(50), whole) == 0);
  // What is given back is used again: a second time nothing is allocated.
  runs(Arithmetic::decimal(50), many);
  BOOST_TEST(runs(Arithmetic::decimal(50), many) == 0);
}

BOOST_AUTO_TEST_CASE(an_arithmetic_returns_and_numbers_of_another_are_freed) {
  Number kept(0.5);
  {
    WithArithmetic const over(Arithmetic::decimal(100));
    BOOST_TEST(current_arithmetic().name() == "dec100");
    Number const third = Number(1) / 3;
    {
      WithArithmetic const inner(Arithmetic::rationals());
      BOOST_TEST(current_arithmetic().name() == "rational");
    }
    BOOST_TEST((third * 3 - 1 < 2 * epsilon<Number>()));
    kept = third;
  }
  BOOST_TEST(current_arithmetic().name() == "double");
  kept = Number(2);
  BOOST_TEST(to_double(kept) == 2.0);
}

BOOST_AUTO_TEST_CASE(the_library_computes_with_them) {
  for (Arithmetic const& arithmetic :
       {Arithmetic::hardware(), Arithmetic::rationals(), Arithmetic::prime_field(), Arithmetic::decimal(40),
        Arithmetic::balls(60)}) {
    WithArithmetic const over(arithmetic);
    Draw draw(5);
    using M = Matrix<Number, 4, 4>;
    M a = M::Identity();
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) a(i, j) += draw.number<Number>() / 8;
    M const one = M(a * inverse_matrix(a)) - M(M::Identity());
    if (exact_arithmetic<Number>())
      BOOST_TEST((magnitude(one) == Number(0)), arithmetic.name());
    else
      BOOST_TEST((magnitude(one) < 1000 * epsilon<Number>()), arithmetic.name());
    // d/dx of x^3/(1 + x^2), by duals and by hand.
    Number const x = ratio<Number>(3, 5);
    Dual<Number> moved(x);
    moved.part[0] = Number(1);
    auto const f = moved * moved * moved / (1 + moved * moved);
    Number const by_hand = (3 * x * x * (1 + x * x) - 2 * x * x * x * x) / ((1 + x * x) * (1 + x * x));
    Number const gap = f.part[0] - by_hand;
    BOOST_TEST((exact_arithmetic<Number>() ? gap == Number(0) : magnitude(gap) < 100 * epsilon<Number>()),
               arithmetic.name());
  }
}
