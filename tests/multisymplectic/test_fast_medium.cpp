// The fused steps of media in the plane, held to a plain loop over cells in matrices of Eigen, and to
// themselves: for any number of threads and levels every bit is the same.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>
#include <cstring>
#include <random>

#include "../../benchmarks/peers/gathered_medium.hpp"
#include "actio/fast_media/fast_medium_2d.hpp"

using namespace actio;
using namespace actio::media;

namespace {
constexpr double eps = std::numeric_limits<double>::epsilon();
using Place = std::array<double, 2>;
using enum Side;

/// A smooth motion, rough enough that no two cells are alike; periodic where the box is.
struct Start {
  FastBox2d box;
  Place place(Place const& X) const {
    double const a = 2 * M_PI * X[0] / (box.cells[0] * box.spacing[0]),
                 b = 2 * M_PI * X[1] / (box.cells[1] * box.spacing[1]);
    auto const one = box.shift(0), two = box.shift(1);
    double const u = X[0] / (box.cells[0] * box.spacing[0]), w = X[1] / (box.cells[1] * box.spacing[1]);
    double const size = 0.03 * std::min(box.spacing[0], box.spacing[1]);
    return {u * one.x + w * two.x + size * (std::sin(a + 2 * b) + std::cos(3 * a)),
            u * one.y + w * two.y + size * (std::cos(2 * a - b) - std::sin(2 * b))};
  }
  Place velocity(Place const& X) const {
    double const a = 2 * M_PI * X[0] / (box.cells[0] * box.spacing[0]),
                 b = 2 * M_PI * X[1] / (box.cells[1] * box.spacing[1]);
    return {0.02 * std::sin(b) + 0.05, 0.02 * std::cos(a - b) - 0.02};
  }
};
template <class Medium>
FastMedium2d<Medium> let_go(Medium const& medium, FastBox2d const& box, double dt,
                            FastOptions const& options = {}) {
  Start const start{box};
  return {medium,
          box,
          dt,
          2.5,
          [&](Place const& X) { return start.place(X); },
          [&](Place const& X) { return start.velocity(X); },
          options};
}

/// Boxes of all kinds of sides, with rows that fill registers and that do not, and the smallest ones.
std::vector<FastBox2d> boxes() {
  std::vector<FastBox2d> out;
  Side const pairs[][2] = {
      {periodic, periodic}, {free, free}, {fixed, free}, {sliding, sliding}, {free, fixed}};
  int const sizes[][2] = {{1, 1},  {2, 1},  {1, 3},  {3, 2},  {4, 4},  {7, 5},
                          {11, 3}, {12, 6}, {13, 9}, {14, 2}, {23, 10}};
  int k = 0;
  for (auto const& size : sizes)
    for (auto const& across : pairs) {
      auto const& up = pairs[k++ % 5];
      out.push_back({{size[0], size[1]}, {0.1, 0.13}, {across[0], across[1]}, {up[0], up[1]}, {0.4, -0.3}});
    }
  // Rows of more registers than the sixteen of which slopes are found ahead, once and twice.
  out.push_back({{70, 2}, {0.1, 0.13}, {periodic, periodic}, {free, free}});
  out.push_back({{141, 2}, {0.1, 0.13}, {free, fixed}, {periodic, periodic}});
  // A row of sixteen registers, whose places in memory are further apart than others'.
  out.push_back({{61, 3}, {0.1, 0.13}, {sliding, fixed}, {free, sliding}});
  // A block that is sheared and stretched, and periodic as such.
  out.push_back(
      {{9, 8}, {0.1, 0.08}, {periodic, periodic}, {periodic, periodic}, {0, 0}, {{{0.99, 0.1}, {0.2, 0.7}}}});
  return out;
}

/// The most that rounding makes of the difference of two ways to compute so many steps. A force is a sum of
/// terms of the size of a stress times h; there are at most 80 roundings among them, and what edges have lost
/// by the subtraction of places: 2 eps |x|/h of F, times the modulus. The linearised scheme is stable, so
/// that errors of velocities add up, and those of places are their sum.
double room(FastBox2d const& box, double dt, int steps, double modulus, double farthest) {
  double const h = std::min(box.spacing[0], box.spacing[1]), t = dt * steps;
  double const rate = 4 / h * modulus * eps * (80 + 2 * farthest / h);
  return 2 * t * t * rate + steps * eps * farthest;
}
double farthest(std::vector<Place> const& x) {
  double most = 0;
  for (auto const& p : x) most = std::max(most, std::hypot(p[0], p[1]));
  return most;
}

template <class Medium, class Stress>
void agrees_with_plain_loop(Medium const& medium, Stress const& stress, double modulus) {
  for (auto const& box : boxes())
    for (Registers const registers : usable_registers()) {
      double const dt = 0.01;
      int const steps = 40;
      auto fast = let_go(medium, box, dt, {1, 3, registers});
      auto plain = peers::gathered(stress, box, dt, fast.places(), fast.velocities());
      fast.step(steps - 1);
      fast.step();
      for (int k = 0; k < steps; ++k) plain.step();
      auto const x = fast.places(), v = fast.velocities_half_a_step_ago();
      double worst = 0, worst_v = 0;
      for (std::size_t k = 0; k < x.size(); ++k) {
        worst = std::max(worst, (plain.x[k] - Eigen::Vector2d(x[k][0], x[k][1])).norm());
        worst_v = std::max(worst_v, (plain.v[k] - Eigen::Vector2d(v[k][0], v[k][1])).norm());
      }
      double const bound = room(box, dt, steps, modulus, farthest(x));
      BOOST_TEST_INFO(box.cells[0] << " x " << box.cells[1] << " cells, " << name_of(registers));
      BOOST_TEST(worst <= bound);
      BOOST_TEST_INFO(box.cells[0] << " x " << box.cells[1] << " cells, " << name_of(registers));
      BOOST_TEST(worst_v <= bound / dt);
    }
}
}  // namespace

BOOST_AUTO_TEST_SUITE(fast_medium)

BOOST_AUTO_TEST_CASE(a_gas_moves_as_by_the_plain_loop) {
  agrees_with_plain_loop(FastFluid{PolytropicByRoots<1, 2>{0.7}}, peers::GasStress{0.7, 2}, 0.7 * 4);
  agrees_with_plain_loop(FastFluid{PolytropicByRoots<3, 5>{0.7}}, peers::GasStress{0.7, 5. / 3}, 0.7 * 4);
  agrees_with_plain_loop(FastFluid{PolytropicByRoots<5, 7>{0.7}}, peers::GasStress{0.7, 1.4}, 0.7 * 4);
  agrees_with_plain_loop(FastFluid{PolytropicGas{0.7, 1.27}}, peers::GasStress{0.7, 1.27}, 0.7 * 4);
}
BOOST_AUTO_TEST_CASE(solids_move_as_by_the_plain_loop) {
  agrees_with_plain_loop(FastStVenantKirchhoff{0.9, 0.6}, peers::StVenantKirchhoffStress{0.9, 0.6}, 5);
  agrees_with_plain_loop(neo_hookean(0.9, 0.6), peers::NeoHookeanStress{0.9, 0.6}, 5);
  agrees_with_plain_loop(blatz_ko<1>(0.6), peers::BlatzKoStress{0.6}, 5);
}

namespace {
/// A gas of one's own: nothing but its energy and the slope of that, for any scalar.
struct Own {
  double K;
  template <class T>
  T energy(T const& J) const { return K / J; }
  template <class T>
  T slope(T const& J) const { return -K / (J * J); }
};
}  // namespace

BOOST_AUTO_TEST_CASE(a_law_of_the_readers_own_moves_as_the_same_law_of_the_library) {
  agrees_with_plain_loop(FastFluid{Own{0.7}}, peers::GasOfTwoStress{0.7}, 0.7 * 4);
}

BOOST_AUTO_TEST_CASE(threads_levels_and_calls_change_no_bit) {
  for (auto const& box : boxes())
    for (Registers const registers : usable_registers()) {
      auto alone = let_go(FastFluid{PolytropicByRoots<1, 2>{0.7}}, box, 0.01, {1, 1, registers});
      alone.step(29);
      auto const x = alone.places(), v = alone.velocities_half_a_step_ago();
      for (auto const& [threads, levels] : {std::pair{1, 5}, {2, 1}, {2, 3}, {3, 8}, {7, 2}}) {
        auto other = let_go(FastFluid{PolytropicByRoots<1, 2>{0.7}}, box, 0.01, {threads, levels, registers});
        other.step(3), other.step(), other.step(25);
        auto const y = other.places(), w = other.velocities_half_a_step_ago();
        bool const same = !std::memcmp(x.data(), y.data(), x.size() * sizeof(Place)) &&
                          !std::memcmp(v.data(), w.data(), v.size() * sizeof(Place));
        BOOST_TEST_INFO(box.cells[0] << " x " << box.cells[1] << " cells, " << threads << " threads, "
                                     << levels << " levels, " << name_of(registers));
        BOOST_TEST(same);
      }
    }
}

// The slopes are the derivative of the energy: by dual numbers through the energy of a cell.
template <class Medium>
void slopes_are_the_derivative(Medium const& medium) {
  using T = Dual<double>;
  double const h1 = 0.3, h2 = 0.2;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> some(-0.06, 0.06);
  for (int draw = 0; draw < 50; ++draw) {
    double edge[8] = {h1, 0.05, h1, -0.02, 0.03, h2, -0.04, h2};
    for (double& x : edge) x += some(random);
    auto const cell = medium.on(h1, h2);
    media::detail::Edges<double> const e{
        {edge[0], edge[1]}, {edge[2], edge[3]}, {edge[4], edge[5]}, {edge[6], edge[7]}};
    double d[4];
    media::detail::areas(e, d);
    auto const f = cell.slopes(e, d);
    double const slopes[8] = {f.below.x, f.below.y, f.above.x, f.above.y,
                              f.left.x,  f.left.y,  f.right.x, f.right.y};
    for (int k = 0; k < 8; ++k) {
      T y[8];
      for (int l = 0; l < 8; ++l) y[l] = T(edge[l]), y[l].part[0] = k == l;
      T const energy = media::detail::cell_energy(
          medium, std::array{h1, h2},
          media::detail::Edges<T>{{y[0], y[1]}, {y[2], y[3]}, {y[4], y[5]}, {y[6], y[7]}});
      // Some forty operations on each side, on terms that are below 30 where J is not small.
      BOOST_TEST(std::abs(energy.part[0] - slopes[k]) <= 80 * eps * 30);
    }
  }
}
BOOST_AUTO_TEST_CASE(slopes_of_a_cell_are_the_derivative_of_its_energy) {
  slopes_are_the_derivative(FastFluid{PolytropicByRoots<1, 2>{0.7}});
  slopes_are_the_derivative(FastFluid{PolytropicByRoots<3, 4>{0.7}});
  slopes_are_the_derivative(FastFluid{PolytropicGas{0.7, 1.27}});
  slopes_are_the_derivative(FastStVenantKirchhoff{0.9, 0.6});
  slopes_are_the_derivative(neo_hookean(0.9, 0.6));
  slopes_are_the_derivative(blatz_ko<2>(0.6));
}

BOOST_AUTO_TEST_SUITE_END()
