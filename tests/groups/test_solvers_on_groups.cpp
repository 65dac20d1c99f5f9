// What the solvers report, against residuals whose iterations are known by hand; rotations of any size and
// quaternions against closed forms.
#include <boost/test/unit_test.hpp>

#include <random>

#include "actio/groups/motions.hpp"
#include "actio/groups/predictor_corrector.hpp"
#include "actio/groups/rotations_of_any_size.hpp"
#include "actio/groups/unipotent_groups.hpp"
#include "actio/groups/unit_quaternions.hpp"
#include "refused.hpp"

using namespace actio;

namespace {

double const eps = epsilon<double>();
using Line = Translations<1>;
template <class S>
using Point = Element<Line, S>;

/// A function of a number as a residual on the line.
template <class F>
auto on_the_line(F const& f) {
  return [f](auto const& x) {
    using S = typename std::decay_t<decltype(x)>::Scalar;
    return Momentum<Line, S>{x.group, Matrix<S, 1, 1>(f(S(x.value[0])))};
  };
}
Point<double> at(double x) { return {Line{}, Vector<double, 1>(x)}; }

}  // namespace

BOOST_AUTO_TEST_SUITE(solvers_on_groups)

BOOST_AUTO_TEST_CASE(a_residual_is_measured_beside_its_row_of_the_derivative) {
  Matrix<double> const derivative{{1, -3}, {0.5, 0}, {0, 0}};
  BOOST_TEST(relative_residual(Vector<double>(2, -0.25, 0), derivative) == 0.5);
  BOOST_TEST(relative_residual(Vector<double>(-2, 1, 0), derivative) == 2);
  BOOST_TEST(relative_residual(Vector<double>(0, 0, 1e-300), derivative) == HUGE_VAL);
  BOOST_TEST(relative_residual(Vector<double>(0, 0, 0), derivative) == 0);
  // The trace of the square of ad is -2|w|^2 on SO(3) and -4|w|^2 on SE(3), whatever the shift.
  BOOST_TEST(std::abs(turning_size(velocity(SO<3>{}, Vector<double, 3>(2, -3, 6))) - 7 / std::sqrt(2)) <=
             16 * eps);
  Vector<double, 6> motion(2, -3, 6, 100, 200, -300);
  BOOST_TEST(std::abs(turning_size(velocity(SE<3>{}, motion)) - 7) <= 1e4 * eps);
  BOOST_TEST(turning_size(velocity(Heisenberg{}, Vector<double, 3>(1, 2, 3))) == 0);
}

BOOST_AUTO_TEST_CASE(newtons_iteration_tells_each_residual) {
  // x^2 = 2 from 3/2: the residuals over the derivative are (x^2 - 2)/2x.
  auto const square = on_the_line([](auto const& x) { return x * x - 2; });
  auto const found = solve_on_group(square, at(1.5));
  BOOST_TEST(std::abs(found.value.value[0] - std::sqrt(2)) <= 2 * eps);
  BOOST_TEST(found.report.tolerance == 16 * eps);
  BOOST_TEST(found.report.evaluations == static_cast<int>(found.report.residuals.size()));
  double x = 1.5;
  for (double const r : found.report.residuals) {
    BOOST_TEST(std::abs(r - std::abs(x * x - 2) / (2 * x)) <= 4 * eps);
    x -= (x * x - 2) / (2 * x);
  }
  BOOST_TEST(found.report.residuals.back() <= 16 * eps);
  BOOST_TEST(found.report.residuals.size() == 5u);
  // x^2 + 1 has no root: as many residuals as iterations.
  auto const nowhere = on_the_line([](auto const& y) { return y * y + 1; });
  try {
    solve_on_group(nowhere, at(0.3), 7);
    BOOST_ERROR("a root is found");
  } catch (NotConverged const& e) {
    BOOST_TEST((e.residuals.size() == 7 && e.tolerance == 16 * eps));
    BOOST_TEST(std::abs(e.residuals[0] - 1.09 / 0.6) <= 4 * eps);
  }
  // One more iteration than is needed does no harm, one less does.
  BOOST_CHECK_NO_THROW(solve_on_group(square, at(1.5), 5));
  CHECK_REFUSED(solve_on_group(square, at(1.5), 4), NotConverged);
  // An update on the line is taken whole, however long; one that turns is shortened to 1.
  BOOST_TEST(
      solve_on_group(on_the_line([](auto const& y) { return y * 3 - 3e6; }), at(0)).report.residuals.size() ==
      2u);
  std::vector<double> angles;
  auto const turn = [&](auto const& f) {
    using S = typename std::decay_t<decltype(f)>::Scalar;
    auto v = log(f).coordinates;
    if (angles.empty() || angles.back() != to_double(base_value(v[2])))
      angles.push_back(to_double(base_value(v[2])));
    // A slope a quarter of what it should be, so that the first step overshoots.
    v[2] = v[2] * ratio<S>(1, 4) + v[2] * v[2] * v[2] * ratio<S>(1, 4) - ratio<S>(5, 2);
    return Momentum<SO<3>, S>{f.group, v};
  };
  auto const turned = solve_on_group(turn, identity<double>(SO<3>{}));
  // The root of (v + v^3)/4 = 5/2 is 2. The turning size of v is v/sqrt 2: the first step, of 10, is cut to
  // sqrt 2.
  BOOST_TEST(std::abs(log(turned.value).coordinates[2] - 2) <= 32 * eps);
  BOOST_TEST(std::abs(angles.at(1) - std::sqrt(2)) <= 16 * eps);
}

BOOST_AUTO_TEST_CASE(the_chord_iteration_tells_what_it_did) {
  ChordIteration<Line, double> chord;
  int calls = 0;
  auto const cubic = [&](double goal) {
    return on_the_line([&calls, goal](auto const& x) {
      ++calls;
      return x + x * x * x / 10 - goal;
    });
  };
  auto const f = chord.solve(cubic(1.1), at(0.9));
  BOOST_TEST(std::abs(f.value[0] - 1) <= 32 * eps);
  BOOST_TEST(std::abs(chord.moved()[0] - 0.1) <= 32 * eps);
  BOOST_TEST((chord.derivatives() == 1 && !chord.by_newton()));
  BOOST_TEST((chord.report().tolerance == 16 * eps && chord.report().evaluations == calls));
  BOOST_TEST(chord.report().residuals.size() == std::size_t(calls));
  // The first residual over the first slope.
  BOOST_TEST(std::abs(chord.report().residuals[0] - (1.1 - 0.9 - 0.0729) / (1 + 0.243)) <= 4 * eps);
  BOOST_TEST(chord.report().residuals.back() <= 64 * 16 * eps);
  // The next equation takes the derivative that is there; after `forget` it takes a new one.
  calls = 0;
  auto const g = chord.solve(cubic(1.2), f);
  BOOST_TEST((chord.derivatives() == 1 && chord.report().evaluations == calls));
  BOOST_TEST(std::abs(g.value[0] + std::pow(g.value[0], 3) / 10 - 1.2) <= 32 * eps);
  chord.forget();
  chord.solve(cubic(1.25), g);
  BOOST_TEST(chord.derivatives() == 2);
  // Broyden's formula makes of one slope that is off the secant: superlinear.
  auto const& r = chord.report().residuals;
  for (std::size_t k = 2; k < r.size(); ++k) BOOST_TEST(r[k] <= 0.125 * r[k - 1]);
  BOOST_TEST(r.size() <= 6u);
  // A slope three times that of the stored derivative asks for a new one.
  auto const steep = on_the_line([](auto const& x) { return exp(x) * 2 - 4; });
  auto const root = chord.solve(steep, at(0.6));
  BOOST_TEST(std::abs(root.value[0] - std::log(2)) <= 32 * eps);
  BOOST_TEST((chord.derivatives() == 3 && !chord.by_newton()));
  // Where a step is longer than 1 Newton's iteration has the last word, from where it is told to.
  auto const far = chord.solve(cubic(110), at(0), at(9.5));
  BOOST_TEST(std::abs(far.value[0] - 10) <= 64 * eps);
  BOOST_TEST(chord.by_newton());
  BOOST_TEST(std::abs(chord.report().residuals[0] - (110 - 9.5 - 85.7375) / (1 + 27.075)) <= 8 * eps);
}

// Changes a + k d, a and d at a right angle: the fourth solution is the first that two changes foretell, one
// of them made of what was expected and of what was missed. To second order that is (a^2 d + a d^2)/12 off,
// without its commutator a d/2.
BOOST_AUTO_TEST_CASE(a_change_is_made_of_what_was_expected_and_missed) {
  using Turn = Element<SO<3>, double>;
  Vector<double, 3> const a(0.3, 0, 0), d(0, 0.1, 0);
  PredictorCorrector<SO<3>, double> sequence;
  Turn goal = exp(velocity(SO<3>{}, Vector<double, 3>(0.2, -0.4, 0.7)));
  std::vector<double> missed;
  auto const next = [&](Vector<double, 3> const& change, Turn const& start) {
    goal = exp(velocity(SO<3>{}, change)) * goal;
    auto const residual = [&](auto const& f) {
      auto const x = log(f * inverse(like(f, goal))).coordinates;
      return Momentum<SO<3>, typename std::decay_t<decltype(x)>::Scalar>{f.group, x};
    };
    auto const found = sequence.solve(residual, start);
    BOOST_TEST(magnitude(Matrix<double, 3, 3>(found.value - goal.value)) <= 64 * eps);
    missed.push_back(sequence.report().residuals[0]);
    return found;
  };
  Turn last = goal;
  for (int k = 0; k < 4; ++k) last = next(a + double(k) * d, last);
  // As far as the last solution, the whole change; then d; then what the second order leaves out, twice.
  BOOST_TEST((missed[0] > 0.2 && missed[1] > 0.2 && missed[2] > 0.05 && missed[2] < 0.15));
  BOOST_TEST(missed[3] <= 2 * 2 * (0.09 * 0.1 + 0.3 * 0.01) / 12);
  // Without solutions the next equation starts where it is told, with the derivative that is there.
  long const derivatives = sequence.derivatives();
  sequence.forget_solutions();
  last = next(Vector<double, 3>(0, 0, 0.01), last);
  BOOST_TEST((missed[4] < 0.02 && missed[4] > 0.005 && sequence.derivatives() == derivatives));
}

BOOST_AUTO_TEST_CASE(rotations_of_any_size_are_those_of_fixed_size) {
  std::mt19937_64 random(3);
  auto const agree = [&]<int n>(SO<n> const& fixed) {
    SO<Dynamic> const any{n};
    Vector<double> v(fixed.dimension());
    for (double& x : v) x = double(random() % 100) / 64;
    Matrix<double> general(n, n);
    for (double& x : general) x = double(random() % 100) / 64;
    BOOST_TEST((any.dimension() == fixed.dimension() && any.matrix_size() == n));
    BOOST_TEST((any.hat(v) == fixed.hat(Coordinates<SO<n>, double>(v))));
    BOOST_TEST((any.vee(general) == fixed.vee(general)));
    BOOST_TEST((any.vee(any.hat(v)) == v));
    BOOST_TEST((any.inverse(general) == general.transpose()));
    int planes = 0;
    over_planes(n, [&](int a, int i, int j) {
      ++planes;
      Matrix<double> const e = any.hat(Vector<double>::Unit(v.size(), a));
      BOOST_TEST((e(i, j) == 1 && e(j, i) == -1 && e.squaredNorm() == 2));
    });
    BOOST_TEST(planes == v.size());
  };
  agree(SO<2>{}), agree(SO<3>{}), agree(SO<4>{}), agree(SO<5>{});
}

// q of each half space, with each of its components the largest in turn.
BOOST_AUTO_TEST_CASE(the_quaternion_of_a_rotation_is_found_by_its_largest_component) {
  for (int big = 0; big < 4; ++big)
    for (int signs = 0; signs < 8; ++signs) {
      Vector<double, 4> q(1, 2, 3, 2.5);
      q[big] = 8;
      for (int k = 0; k < 3; ++k)
        if (signs & (1 << k)) q[k + 1] = -q[k + 1];
      q /= q.norm();
      // The rotation takes e_k to q e_k conj(q).
      Matrix<double, 3, 3> r;
      for (int k = 0; k < 3; ++k) r.col(k) = SU2::Ad(q, Vector<double, 3>(Vector<double, 3>::Unit(k)));
      BOOST_TEST((quaternion_of_rotation(r) - q).isZero(8 * eps));
      BOOST_TEST((SO<3>::log(r) - SU2::log(q)).isZero(32 * eps));
      BOOST_TEST((SO<3>::Ad(r, Vector<double, 3>(1, 2, 3)) - SU2::Ad(q, Vector<double, 3>(1, 2, 3)))
                     .isZero(64 * eps));
      double const half = std::acos(q[0]), sine = std::sin(half);
      BOOST_TEST((SU2::log(q) - q.tail<3>() * (2 * half / sine)).isZero(64 * eps));
      // The opposite quaternion turns by the rest of a whole turn.
      double const rest = M_PI - half;
      BOOST_TEST((SU2::log(Vector<double, 4>(-q)) + q.tail<3>() * (2 * rest / sine)).isZero(64 * eps));
    }
}

BOOST_AUTO_TEST_CASE(a_derivative_that_is_no_number_is_refused_by_name) {
  auto const root = [](auto const& v) {
    using std::sqrt;
    if constexpr (requires { v.coordinates; })
      return sqrt(v.coordinates[1]);
    else if constexpr (requires { v.components; })
      return sqrt(v.components[1]);
    else
      return sqrt(v.value(1, 2));
  };
  auto const names = [](char const* where, auto const& f) {
    BOOST_CHECK_EXCEPTION(f(), NotFinite, [&](NotFinite const& e) {
      return std::string(e.what()).find(std::string(where) + ": value or derivative of the function") == 0;
    });
  };
  Vector<double, 3> const zero(0, 0, 0), fine(0, 4, 0);
  names("gradient", [&] { gradient(root, velocity(SO<3>{}, zero)); });
  names("gradient", [&] { gradient(root, momentum(SO<3>{}, zero)); });
  names("right_differential", [&] { right_differential(root, identity<double>(SO<3>{})); });
  names("left_differential", [&] { left_differential(root, identity<double>(SO<3>{})); });
  BOOST_TEST((gradient(root, velocity(SO<3>{}, fine)).components == Vector<double, 3>(0, 0.25, 0)));
  BOOST_TEST((gradient(root, momentum(SO<3>{}, fine)).coordinates == Vector<double, 3>(0, 0.25, 0)));
}

BOOST_AUTO_TEST_SUITE_END()
