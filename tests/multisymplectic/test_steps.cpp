// Steps of the discrete field equations: against stencils written by hand, exactly; and what is refused.
#include <boost/test/unit_test.hpp>

#include <numbers>

#include "media.hpp"
#include "refused.hpp"
#include "witness/draw.hpp"
#include "witness/number.hpp"

using namespace actio;
using namespace actio::media;
using namespace actio::testing;

namespace {

using Q = Number;

/// Linear waves with speed c: \f$L = \tfrac12(v_0^2 - c^2v_1^2)\f$.
template <class S>
struct LinearWave {
  S c;
  template <class T, int n, int N>
  T operator()(Jet<T, n, N> const& j) const {
    T sum(0);
    for (int a = 0; a < N; ++a) {
      sum += j.v(a, 0) * j.v(a, 0);
      for (int i = 1; i <= n; ++i) sum -= j.v(a, i) * j.v(a, i) * Base<T>(S(c * c));
    }
    return sum / Base<T>(2);
  }
};

/// A density in which the velocity meets the gradient: a wave on a stream with speed u.
template <class S>
struct DraggedWave {
  S c, u;
  template <class T>
  T operator()(Jet<T, 1, 1> const& j) const {
    T const rate = j.v(0, 0) + j.v(0, 1) * Base<T>(u);
    return (rate * rate - j.v(0, 1) * j.v(0, 1) * Base<T>(S(c * c))) / Base<T>(2);
  }
};

template <class S>
SpaceTimeMesh<S, 1> line(int cells, Side side, S const& h, int steps) {
  return {equal_steps(S(0), h, steps),
          {cells},
          all_sides<1>(side),
          StraightBox<S, 1>{Matrix<S, 1, 1>(S(0)), Matrix<S, 1, 1>(S(1))}};
}

/// Any values on two levels, over the rationals.
DiscreteSection<Q, 1, 1> any_start(SpaceTimeMesh<Q, 1> const& mesh) {
  FineDraw draw(7);
  return drawn_start<Q, 1>(mesh, draw);
}

}  // namespace

BOOST_AUTO_TEST_CASE(steps_of_the_linear_wave_are_those_of_the_five_point_stencil) {
  WithArithmetic const exactly(Arithmetic::rationals());
  Q const h = ratio<Q>(1, 7), c = ratio<Q>(3, 2), width = ratio<Q>(1, 5);
  Q const r = (c * h / width) * (c * h / width);
  for (Side const side : {Side::periodic, Side::fixed, Side::free}) {
    auto const mesh = line(5, side, h, 6);
    auto section = any_start(mesh);
    run(LinearWave<Q>{c}, mesh, section);
    int const count = static_cast<int>(mesh.node_count());
    auto const at = [&](int k, int i) -> Q { return section(k, (i + count) % count)[0]; };
    for (int k = 1; k < 6; ++k)
      for (int i = 0; i < count; ++i) {
        bool const left_end = side != Side::periodic && i == 0,
                   right_end = side != Side::periodic && i + 1 == count;
        Q const left = left_end ? Q(0) : Q(at(k, i - 1) - at(k, i));
        Q const right = right_end ? Q(0) : Q(at(k, i + 1) - at(k, i));
        // A node at the end of a free line has half the mass.
        Q const mass = left_end || right_end ? ratio<Q>(1, 2) : Q(1);
        Q const acceleration =
            side == Side::fixed && (left_end || right_end) ? Q(0) : Q(r * (left + right) / mass);
        BOOST_TEST((at(k + 1, i) - 2 * at(k, i) + at(k - 1, i) ==
                    (mesh.fixed(i) ? Q(-at(k, i) + at(k - 1, i)) : acceleration)));
      }
  }
}

BOOST_AUTO_TEST_CASE(
    steps_of_the_generic_implementation_satisfy_the_field_equations_exactly_over_the_rationals) {
  WithArithmetic const exactly(Arithmetic::rationals());
  FineDraw draw(9);
  SpaceTimeMesh<Q, 2> const mesh({Q(0), ratio<Q>(1, 20), ratio<Q>(1, 8), ratio<Q>(1, 6)}, {2, 2},
                                 all_sides<2>(Side::free), bent_cube<Q, 2>());
  auto section = disturbed_identity(mesh, draw);
  run(solid<Q, 2>(), mesh, section);
  for (int level : {1, 2})
    for (Index i = 0; i < mesh.node_count(); ++i) {
      auto const E = discrete_euler_lagrange(solid<Q, 2>(), mesh, section, level, i);
      BOOST_TEST((E.sum == Matrix<Q, 2, 1>::Zero()));
      BOOST_TEST((E.terms > 0));
      BOOST_TEST((momentum_at_end(solid<Q, 2>(), mesh, section, level - 1, i) ==
                  momentum_at_start(solid<Q, 2>(), mesh, section, level, i)));
    }
}

BOOST_AUTO_TEST_CASE(standing_waves_have_the_discrete_dispersion_relation_to_rounding) {
  // sin(w h/2)/h = c sin(k a/2)/a with the width a of a cell: cos(kx) cos(wt) solves the discrete equations,
  // so that a run stays on it; each step adds a rounding or two, and what they add grows linearly in the
  // number of steps at most as fast as the slowest wave lets it.
  int const cells = 12, steps = 200;
  double const h = 0.05, c = 1.25, a = 1.0 / cells;
  auto const mesh = line(cells, Side::periodic, h, steps);
  for (int mode : {1, 2, 5}) {
    double const k = 2 * std::numbers::pi * mode;
    double const w = 2 / h * std::asin(h / a * c * std::sin(k * a / 2));
    auto const wave = [&](Matrix<double, 2, 1> const& x) {
      return Matrix<double, 1, 1>(std::cos(k * x[1]) * std::cos(w * x[0]));
    };
    auto section = restricted(mesh, wave, 2);
    run(LinearWave<double>{c}, mesh, section);
    double worst = 0, with_exact_frequency = 0;
    for (int level = 0; level <= steps; ++level)
      for (Index i = 0; i < mesh.node_count(); ++i) {
        double const y = section(level, i)[0], x = mesh.place(i)[0], t = mesh.time(level);
        worst = std::max(worst, std::abs(y - wave(mesh.event(level, i))[0]));
        with_exact_frequency =
            std::max(with_exact_frequency, std::abs(y - std::cos(k * x) * std::cos(c * k * t)));
      }
    BOOST_TEST_MESSAGE("mode " << mode << ": off the discrete wave by " << worst
                               << ", off the continuous one by " << with_exact_frequency);
    // A rounding in step s drifts as (steps - s)/(w h) roundings at most: their sum, were they all alike.
    BOOST_TEST(worst < steps * steps / 2 / (w * h) * epsilon<double>());
    BOOST_TEST(with_exact_frequency > 1e-3);
  }
}

BOOST_AUTO_TEST_CASE(a_density_that_couples_neighbours_is_solved_by_going_through_the_nodes_again) {
  auto const mesh = line(6, Side::periodic, 0.05, 8);
  auto const wave = [](Matrix<double, 2, 1> const& x) {
    return Matrix<double, 1, 1>(std::sin(2 * std::numbers::pi * (x[1] - x[0])));
  };
  auto section = restricted(mesh, wave, 2);
  DraggedWave<double> const dragged{1, 0.3};
  auto const report = step(dragged, mesh, section);
  BOOST_TEST(report.sweeps > 2);
  BOOST_TEST(report.residual < 1e-13);
  for (Index i = 0; i < mesh.node_count(); ++i) {
    auto const E = discrete_euler_lagrange(dragged, mesh, section, 1, i);
    BOOST_TEST(std::abs(E.sum[0]) < 1e-13 * E.terms);
  }
  // A medium is explicit: solved in one sweep, and the second sees that it is.
  auto explicit_section = restricted(mesh, wave, 2);
  BOOST_TEST(step(LinearWave<double>{1}, mesh, explicit_section).sweeps == 2);
}

BOOST_AUTO_TEST_CASE(steps_of_unequal_length_begin_where_the_last_velocities_lead) {
  // Where everything moves uniformly that is the solution: the first sweep finds nothing to correct, and the
  // second sees that. From another place this density takes more of them.
  SpaceTimeMesh<double, 1> const mesh(
      {0, 0.125, 0.5, 1}, {6}, all_sides<1>(Side::periodic),
      StraightBox<double, 1>{Matrix<double, 1, 1>(0.0), Matrix<double, 1, 1>(1.0)});
  auto section = restricted(
      mesh, [](Matrix<double, 2, 1> const& x) { return Matrix<double, 1, 1>(2 * x[0] + 1); }, 2);
  while (section.last() + 1 < mesh.levels())
    BOOST_TEST(step(DraggedWave<double>{1, 0.3}, mesh, section).sweeps == 2);
}

BOOST_AUTO_TEST_CASE(a_first_step_starts_with_the_momentum_of_the_density) {
  WithArithmetic const exactly(Arithmetic::rationals());
  FineDraw draw(11);
  SpaceTimeMesh<Q, 2> const mesh({Q(0), ratio<Q>(1, 20)}, {2, 2}, all_sides<2>(Side::free),
                                 bent_cube<Q, 2>());
  auto section = disturbed_identity(mesh, draw);
  section.levels.resize(1);
  Level<Q, 2> velocities;
  for (Index i = 0; i < mesh.node_count(); ++i) velocities.push_back(draw.vector<Q, Matrix<Q, 2, 1>>(2));
  auto const medium = solid<Q, 2>();
  first_step(medium, mesh, section, velocities);
  // By hand: y_1 = y_0 + h v + h^2/2 f/m with the force f = -dE/dy at level 0.
  Q const h = ratio<Q>(1, 20);
  for (Index i = 0; i < mesh.node_count(); ++i) {
    Q mass(0);
    Matrix<Q, 2, 1> force = Matrix<Q, 2, 1>::Zero();
    mesh.for_cells_at(i, [&](GridIndex<2> const& cell, int b) {
      auto const here = cell_of(mesh, section, 0, cell);
      mass += medium.rho.value * here.geometry->volume[b];
      auto const stored = [&]<class T>(Matrix<T, 2, 1> const& y) -> T {
        auto moved = here.cast<T>();
        moved.y.col(b) = y;
        T E(0);
        for (int corner = 0; corner < 4; ++corner)
          E += medium.W.w(green_tensor(Kronecker<2>{}, discrete_jet(moved, corner).gradient())) *
               Q(medium.rho.value * here.geometry->volume[corner]);
        return E;
      };
      force -= derivative(stored, Matrix<Q, 2, 1>(here.y.col(b))).gradient();
    });
    Matrix<Q, 2, 1> const expected = section(0, i) + velocities[i] * h + force * Q(h * h / 2 / mass);
    BOOST_TEST((section(1, i) == expected));
  }
}

BOOST_AUTO_TEST_CASE(fixed_nodes_stay_or_go_where_the_wall_goes) {
  WithArithmetic const exactly(Arithmetic::rationals());
  auto const mesh = line(3, Side::fixed, ratio<Q>(1, 7), 2);
  auto still = any_start(mesh);
  auto moved = still;
  step(LinearWave<Q>{Q(1)}, mesh, still);
  BOOST_TEST((still(2, 0) == still(1, 0)));
  step(LinearWave<Q>{Q(1)}, mesh, moved,
       [](Matrix<Q, 2, 1> const& x) { return Matrix<Q, 1, 1>(Q(x[0] * x[0] + x[1])); });
  BOOST_TEST((moved(2, 0)[0] == ratio<Q>(4, 49)));
  BOOST_TEST((moved(2, 3)[0] == ratio<Q>(53, 49)));
  BOOST_TEST((moved(2, 1) == still(2, 1)));
}

BOOST_AUTO_TEST_CASE(a_step_that_turns_a_cell_inside_out_is_refused_and_leaves_the_section_as_it_was) {
  SpaceTimeMesh<double, 2> const mesh(equal_steps(0.0, 0.5, 3), {2, 2}, all_sides<2>(Side::free),
                                      bent_cube<double, 2>());
  // The right side runs into the left one, too fast for a gas as thin as this to hold it up.
  auto const thin = Continuum{Euclidean<2>{}, Euclidean<2>{}, Homogeneous<double>{1.0},
                              Barotropic{WholePolytropic<double, 1>{1e-3}}};
  auto const squeeze = [](Matrix<double, 3, 1> const& x) {
    return Matrix<double, 2, 1>(x[1] * (1 - 1.2 * x[0]), x[2]);
  };
  auto section = restricted(mesh, squeeze, 2);
  auto const before = section;
  BOOST_CHECK_EXCEPTION(step(thin, mesh, section), NotOrientationPreserving, [](auto const& e) {
    return e.measured <= 0 && std::string(e.what()).find("at x = (") != std::string::npos;
  });
  BOOST_TEST(section.last() == 1);
  BOOST_TEST((section(1, 4) == before(1, 4)));
}

BOOST_AUTO_TEST_CASE(steps_that_cannot_be_taken_are_refused) {
  auto const mesh = line(3, Side::periodic, 0.1, 2);
  auto const wave = [](Matrix<double, 2, 1> const& x) { return Matrix<double, 1, 1>(x[1] * (1 - x[1])); };
  LinearWave<double> const medium{1};
  auto one = restricted(mesh, wave, 1), all = restricted(mesh, wave, 3);
  CHECK_REFUSED(step(medium, mesh, one), NotAMesh);
  CHECK_REFUSED(step(medium, mesh, all), NotAMesh);
  CHECK_REFUSED(first_step(medium, mesh, all, all.levels[0]), NotAMesh);
  CHECK_REFUSED(first_step(medium, mesh, one, {}), NotAMesh);
  // Without kinetic energy no velocity belongs to a momentum.
  auto two = restricted(mesh, wave, 2);
  auto const massless = []<class T>(Jet<T, 1, 1> const& j) -> T { return j.v(0, 1) * j.v(0, 1); };
  CHECK_REFUSED(step(massless, mesh, two), Singular);
  BOOST_TEST(two.last() == 1);
  auto const no_number = []<class T>(Jet<T, 1, 1> const& j) -> T { return j.v(0, 0) * std::nan(""); };
  CHECK_REFUSED(step(no_number, mesh, two), NotFinite);
  auto short_of_a_node = two;
  short_of_a_node.levels[1].pop_back();
  CHECK_REFUSED(step(medium, mesh, short_of_a_node), NotAMesh);
  CHECK_REFUSED(discrete_euler_lagrange(medium, mesh, two, 1, 0), NotAMesh);
  CHECK_REFUSED(momentum_at_end(medium, mesh, two, -1, 0), NotAMesh);
  CellBox<1> const beyond{0, 2, {{0}}, {{1}}}, too_wide{0, 1, {{0}}, {{4}}};
  CHECK_REFUSED((noether_balance(medium, shifting<double, 1>(0), mesh, two, beyond)), NotAMesh);
  CHECK_REFUSED((noether_balance(medium, shifting<double, 1>(0), mesh, two, too_wide)), NotAMesh);
}
