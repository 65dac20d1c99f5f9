// The chord iteration, extrapolated starts, and numbers in pairs.
#include <boost/test/unit_test.hpp>

#include "actio/groups/linear_groups.hpp"
#include "actio/groups/motions.hpp"
#include "actio/groups/predictor_corrector.hpp"
#include "refused.hpp"
#include "witness/draw.hpp"

using namespace actio;

namespace {
constexpr double eps = std::numeric_limits<double>::epsilon();

template <int N, class F>
Dual<double, N> applied(F const& f, double x, double y, std::array<double, 3> const& dx,
                        std::array<double, 3> const& dy, int first) {
  Dual<double, N> a(x), b(y);
  for (int i = 0; i < N; ++i) a.part[i] = dx[first + i], b.part[i] = dy[first + i];
  return f(a, b);
}
}  // namespace

BOOST_AUTO_TEST_SUITE(chord_iteration)

BOOST_AUTO_TEST_CASE(extrapolation_is_exact_on_polynomials_and_harmless_on_noise) {
  using Vector = Matrix<double, 1, 1>;
  for (int degree = 0; degree <= 4; ++degree) {
    Extrapolation<Vector> sequence;
    auto const term = [degree](int k) { return Vector(std::pow(k / 16.0 + 1, degree)); };
    for (int k = 0; k < 16; ++k) sequence.push(term(k));
    // Twelve terms with binomial coefficients up to 462, each rounded to its own size.
    BOOST_TEST(std::abs(sequence.next()[0] - term(16)[0]) < 1024 * eps * term(16)[0]);
  }
  Draw draw(3);
  Extrapolation<Vector> noise;
  for (int k = 0; k < 50; ++k) {
    noise.push(Vector(draw.number<double>()));
    BOOST_TEST(std::abs(noise.next()[0]) < 16);
  }
}

BOOST_AUTO_TEST_CASE(the_solution_is_that_of_newton_and_so_is_what_is_thrown) {
  SE<3> const group;
  Draw draw(11);
  ChordIteration<SE<3>, double> chord;
  auto start = identity<double>(group);
  for (int k = 0; k < 40; ++k) {
    // log f = a moving goal, seen through a cubic.
    Coordinates<SE<3>, double> goal;
    for (int i = 0; i < 6; ++i) goal[i] = 0.4 * std::sin(0.05 * k + i);
    auto const residual = [&](auto const& f) {
      auto x = log(f).coordinates;
      using S = typename std::decay_t<decltype(x)>::Scalar;
      for (int i = 0; i < 6; ++i)
        x[i] = x[i] + x[i] * x[(i + 1) % 6] * x[(i + 2) % 6] * ratio<S>(1, 4) - S(goal[i]);
      return Momentum<SE<3>, S>{f.group, x};
    };
    auto const found = chord.solve(residual, start), reference = solve_on_group(residual, start).value;
    // 16 eps each, the derivative being near the identity.
    BOOST_TEST(magnitude((found.value - reference.value).eval()) < 2 * 2 * 16 * eps);
    BOOST_TEST(!chord.by_newton());
    start = found;
  }
  BOOST_TEST(chord.derivatives() < 10);
  auto const flat = [](auto const& f) {
    auto x = log(f).coordinates;
    x[5] = x[4];
    return Momentum<SE<3>, typename std::decay_t<decltype(x)>::Scalar>{f.group, x};
  };
  auto const nowhere = [](auto const& f) {
    auto x = log(f).coordinates;
    x[0] = x[0] * x[0] + 1;
    return Momentum<SE<3>, typename std::decay_t<decltype(x)>::Scalar>{f.group, x};
  };
  CHECK_REFUSED(solve_on_group(flat, start), Singular);
  CHECK_REFUSED(chord.solve(flat, start), Singular);
  CHECK_REFUSED(solve_on_group(nowhere, start), Error);
  CHECK_REFUSED(chord.solve(nowhere, start), Error);
  // At the identity a root has the value zero and an infinite slope.
  auto const edge = [](auto const& f) {
    auto x = log(f).coordinates;
    using std::sqrt;
    x[2] = sqrt(x[2]);
    return Momentum<SE<3>, typename std::decay_t<decltype(x)>::Scalar>{f.group, x};
  };
  BOOST_CHECK_EXCEPTION(solve_on_group(edge, identity<double>(group)), NotFinite, [](NotFinite const& error) {
    return std::string(error.what()).find("residual or its derivative") != std::string::npos;
  });
  start.value(1, 2) = std::nan("");
  CHECK_REFUSED(chord.solve(flat, start), NotFinite);
}

BOOST_AUTO_TEST_CASE(numbers_in_pairs_are_the_same_numbers) {
  // Three rates go in pairs, two do not; the machine rounds each alike.
  Draw draw(5);
  auto const operations = [](auto const& x, auto const& y) {
    auto z = x * y - y / (x + y * y);
    add_product(z, x, sqrt(y));
    z += exp(x) * 3.0 - 2.0 * cos(y);
    z -= -x / 7.0;
    return z;
  };
  for (int k = 0; k < 200; ++k) {
    double const x = draw.number<double>(), y = 1 + std::abs(draw.number<double>());
    std::array<double, 3> dx, dy;
    for (int i = 0; i < 3; ++i) dx[i] = draw.number<double>(), dy[i] = draw.number<double>();
    auto const together = applied<3>(operations, x, y, dx, dy, 0);
    auto const two = applied<2>(operations, x, y, dx, dy, 0), last = applied<2>(operations, x, y, dx, dy, 1);
    BOOST_TEST(together.value == two.value);
    BOOST_TEST(together.part[0] == two.part[0]);
    BOOST_TEST(together.part[1] == two.part[1]);
    BOOST_TEST(together.part[2] == last.part[1]);
  }
}

BOOST_AUTO_TEST_CASE(closed_forms_are_the_series_of_matrices) {
  Draw draw(17);
  for (double const size : {1e-9, 0.3, 1.0, 2.5}) {
    auto const v = (draw.vector<double>(6) * size).eval();
    Matrix<double, 4, 4> const a = SO<4>::hat(v);
    BOOST_TEST(magnitude((SO<4>::exp(Coordinates<SO<4>, double>(v)) - matrix_exponential(a)).eval()) <
               64 * eps);
    auto const w = (draw.vector<double>(3) * size).eval();
    Matrix<double, 2, 2> const b = SL2::hat(w), e = matrix_exponential(b);
    BOOST_TEST(magnitude((SL2::exp(Coordinates<SL2, double>(w)) - e).eval()) < 64 * eps * magnitude(e));
  }
  // log of SE(3) inverts exp: the inverse of iex in closed form, on both sides of the place where its series
  // ends.
  for (double const angle : {1e-12, 0.1, 0.99, 1.01, 3.1}) {
    Matrix<double, 6, 1> v;
    v << angle * 0.6, -angle * 0.8, 0, 1, -2, 0.5;
    BOOST_TEST(magnitude((SE<3>::log(SE<3>::exp(v)) - v).eval()) < 64 * eps * magnitude(v));
  }
}

BOOST_AUTO_TEST_SUITE_END()
