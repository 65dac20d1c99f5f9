// Maps that solve an equation: their tangents against that of the equation, and the brackets that reduced
// discrete Lagrangians preserve.
#include <boost/test/unit_test.hpp>

#include "actio/groups/motions.hpp"
#include "actio/instruments/discrete_spaces.hpp"
#include "actio/instruments/poisson_defect.hpp"
#include "small_maps.hpp"

using namespace actio;
using namespace actio::testing;
using Vector6d = Matrix<double, 6, 1>;

namespace {

constexpr double h = 0.25;
DiagonalBody<SE<3>> const submarine{Vector6d{{2, 5, 6, 1, 3, 4}}};
// Not even in the velocity: with terms that are linear in it, and one that couples turning to gliding.
struct Twisted {
  double twist;
  auto operator()(auto const& f) const {
    using S = typename std::decay_t<decltype(f)>::Scalar;
    auto const eta = log(f).coordinates;
    S sum = (eta[0] * eta[4] / S(4) + eta[2]) * twist;
    for (int a = 0; a < 6; ++a) sum += eta[a] * eta[a] * (submarine.inertia[a] / (2 * h));
    return sum;
  }
};
constexpr Twisted l{1};
auto const f = exp(velocity(SE<3>{}, Vector6d{{0.1, -0.2, 0.15, 0.4, 0.1, 0.3}}));

// The tangent in natural coordinates.
template <class At>
Matrix<double> natural(At const& at) {
  return at.sizes.asDiagonal() * at.tangent * at.sizes.cwiseInverse().asDiagonal();
}

// The step with the solver running at dual numbers, and with one update after it.
auto const by_solver = [](auto const& x) { return step_euler_poincare_left(l, x).value; };
auto const by_update = [](auto const& x) {
  return solve_implicit(
      [](auto const& next, auto const& x) {
        return left_differential(l, next) - like(next, right_differential(l, x));
      },
      x, x);
};

}  // namespace

BOOST_AUTO_TEST_CASE(both_ways_have_the_tangent_of_the_equation) {
  auto const next = by_solver(f);
  Matrix<double> const expected = euler_poincare_tangent_left(l, f, next);
  // The equation is solved to 16 epsilon of a motion, and a second derivative is inverted whose entries
  // differ as the inertia does, sixfold.
  double const room = 16 * 6 * 6 * eps * magnitude(expected);
  RelativeMotionsLeft const space(l);
  auto const solver = tangent_of_map(space, by_solver, f), update = tangent_of_map(space, by_update, f);
  BOOST_TEST(magnitude((natural(solver) - expected).eval()) < room);
  BOOST_TEST(magnitude((natural(update) - expected).eval()) < room);
  BOOST_TEST(magnitude((solver.image.value - next.value).eval()) < 32 * eps);
  BOOST_TEST(magnitude((update.image.value - next.value).eval()) == 0);
  // What a control would notice: the right-invariant equation has another tangent.
  BOOST_TEST(magnitude((natural(update) - euler_poincare_tangent_right(l, f, next)).eval()) > 1e-2);
}

BOOST_AUTO_TEST_CASE(discrete_lagrangians_keep_their_brackets) {
  BOOST_TEST(poisson_defect(RelativeMotionsLeft(l), by_update, f) < 1000 * eps);
  // Left and right motions of one function are inverse to each other and have one bracket, up to its sign.
  // That of another function is none of their business.
  BOOST_TEST(poisson_defect(RelativeMotionsRight(l), by_update, f) < 1000 * eps);
  BOOST_TEST(poisson_defect(RelativeMotionsLeft(Twisted{0.5}), by_update, f) > 1e-3);
  auto const right = [](auto const& x) {
    return solve_implicit(
        [](auto const& next, auto const& x) {
          return right_differential(l, next) - like(next, left_differential(l, x));
        },
        x, x);
  };
  BOOST_TEST(poisson_defect(RelativeMotionsRight(l), right, f) < 1000 * eps);
}
