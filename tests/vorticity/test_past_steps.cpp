// What the first guess of a step is made of: halves of matrices, and polynomials in time through them.
#include <boost/test/unit_test.hpp>
#include <random>

#include "actio/vorticity/past_steps.hpp"

using namespace actio;
using namespace actio::sphere;

namespace {

SkewHermitian<> random_matrix(int n, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  SkewHermitian<> m(n);
  for (int c = 0; c < n; ++c)
    for (int r = c; r < n; ++r) m.real(r, c) = r > c ? normal(random) : 0, m.imaginary(r, c) = normal(random);
  mirror_lower(m);
  return m;
}
/// A matrix whose entries are polynomials of degree 4 in time.
SkewHermitian<> at_time(double t, int n) {
  SkewHermitian<> m(n);
  double power = 1;
  for (unsigned k = 0; k <= 4; ++k, power *= t) m += power * random_matrix(n, k);
  return m;
}
std::deque<PastStep> eight_steps(int n) {
  std::deque<PastStep> past;
  for (int k = 1; k <= 8; ++k) {
    past.emplace_back();
    past.back().displacement.take(at_time(-0.1 * k, n));
  }
  return past;
}

}  // namespace

BOOST_AUTO_TEST_CASE(half_of_a_matrix_is_all_of_it) {
  for (int n : {1, 2, 7, 40}) {
    SkewHermitian<> const a = random_matrix(n, 1), b = random_matrix(n, 2);
    LowerHalf half;
    SkewHermitian<> m;
    half.take(a), half.put(n, m);
    BOOST_TEST((m.real == a.real && m.imaginary == a.imaginary));
    half.take_difference(a, b), half.put_sum(b, m);
    BOOST_TEST(norm(m - a) <= 4 * std::numeric_limits<double>::epsilon() * (norm(a) + norm(b)));
    BOOST_TEST((m.real == -m.real.transpose() && m.imaginary == m.imaginary.transpose()));
  }
}

BOOST_AUTO_TEST_CASE(a_polynomial_goes_on_through_as_many_steps_as_its_degree_and_one) {
  int const n = 50;  // more numbers than one piece of the sum
  auto const past = eight_steps(n);
  SkewHermitian<> const next = at_time(0, n);
  LowerHalf half;
  SkewHermitian<> guess;
  for (int most : {3, 4, 5, 8}) {
    extrapolate(past, &PastStep::displacement, most, half);
    half.put(n, guess);
    // Weights to 70, of numbers of the size of the matrix.
    double const rounding = 1e3 * std::numeric_limits<double>::epsilon();
    BOOST_TEST((norm(guess - next) <= rounding * norm(next)) == (most >= 5));
    // By some of the columns, which are as good as others.
    double const whole = norm(guess - next) / norm(next), some = error_of_guess(past, most, next);
    if (most < 5)
      BOOST_TEST((some > 0.5 * whole && some < 2 * whole));
    else
      BOOST_TEST(some <= rounding);
  }
}

BOOST_AUTO_TEST_CASE(the_oldest_step_makes_room) {
  auto past = eight_steps(3);
  double const oldest = past.back().displacement.imaginary[0];
  BOOST_TEST(make_room(past, 9).displacement.imaginary.size() == 0);
  BOOST_TEST(past.size() == 8u);
  BOOST_TEST(make_room(past, 8).displacement.imaginary[0] == oldest);
  BOOST_TEST(past.size() == 7u);
}
