// A density of a reader's own: a string with a weight that hangs in gravity and bends, in twenty lines.
#include <boost/test/unit_test.hpp>

#include "media.hpp"

using namespace actio;
using namespace actio::media;

namespace {

// [own_density]
/// A heavy elastic string in the plane, n = 1 and N = 2: \f$L = \tfrac\rho2|\dot\phi|^2 -
/// \tfrac k4(|\phi'|^2 - 1)^2 - \rho g\,\phi^2\f$.
struct HeavyString {
  double rho, k, g;
  template <class T>
  T operator()(Jet<T, 1, 2> const& j) const {
    T const strain = j.gradient().squaredNorm() - T(1);
    return j.velocity().squaredNorm() * (rho / 2) - strain * strain * (k / 4) - j.y[1] * (rho * g);
  }
};

/// Lets it fall from a level line, held at its ends: returns where its middle is after each step.
std::vector<double> falling_string(int cells, int steps, double h) {
  HeavyString const string{1, 4, 1};
  SpaceTimeMesh<double, 1> const mesh(
      equal_steps(0.0, h, steps), {cells}, all_sides<1>(Side::fixed),
      StraightBox<double, 1>{Matrix<double, 1, 1>(0.0), Matrix<double, 1, 1>(1.0)});
  auto const level = [](Matrix<double, 2, 1> const& x) { return Matrix<double, 2, 1>(x[1] * 1.2, 0.0); };
  auto section = restricted(mesh, level, 1);
  first_step(string, mesh, section, Level<double, 2>(mesh.node_count(), Matrix<double, 2, 1>(0.0, 0.0)));
  while (section.last() < steps) step(string, mesh, section);
  std::vector<double> middle;
  for (int k = 0; k <= steps; ++k) middle.push_back(section(k, cells / 2)[1]);
  return middle;
}
// [own_density]

}  // namespace

BOOST_AUTO_TEST_CASE(a_density_of_a_readers_own_runs_with_all_that_belongs_to_it) {
  // Early on the middle falls freely, -g t^2/2; later the string swings between its ends.
  auto const middle = falling_string(16, 400, 0.01);
  for (int k = 1; k < 8; ++k) BOOST_TEST(std::abs(middle[k] + 0.01 * 0.01 * k * k / 2) < 1e-12);
  auto const lowest = std::min_element(middle.begin(), middle.end());
  BOOST_TEST(*lowest < -0.1);
  BOOST_TEST(*std::max_element(lowest, middle.end()) > -0.03);
}

BOOST_AUTO_TEST_CASE(gravity_takes_the_vertical_momentum_of_a_string_and_leaves_the_horizontal_one) {
  HeavyString const string{1, 4, 1};
  SpaceTimeMesh<double, 1> const mesh(
      equal_steps(0.0, 0.02, 20), {6}, all_sides<1>(Side::free),
      StraightBox<double, 1>{Matrix<double, 1, 1>(0.0), Matrix<double, 1, 1>(1.0)});
  auto const start = [](Matrix<double, 2, 1> const& x) {
    return Matrix<double, 2, 1>(x[1] * 1.2 + 0.3 * x[0], x[1] * x[1] * (1 - x[1]) + x[0] * x[1]);
  };
  auto section = restricted(mesh, start, 2);
  testing::run(string, mesh, section);
  CellBox<1> const whole{2, 15, {{0}}, {{6}}};
  auto const across = noether_balance(string, testing::shifting<double, 2>(0), mesh, section, whole);
  auto const down = noether_balance(string, testing::shifting<double, 2>(1), mesh, section, whole);
  BOOST_TEST(std::abs(across.sum) < 1e-14 * across.terms);
  // From the end of one slab to the end of the next the weight rho g of a unit length acts for one step.
  auto const momentum = [&](int slab) {
    return momentum_of_level(string, testing::shifting<double, 2>(1), mesh, section, slab).sum;
  };
  BOOST_TEST(std::abs(momentum(16) - momentum(2) + 14 * 0.02) < 1e-13);
  BOOST_TEST(std::abs(down.sum) > 0.1);
}
