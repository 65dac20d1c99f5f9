// A million steps on SO(8) by squares: traces that are conserved, momentum in space, attitude, and how their
// changes grow.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "../rigid_body/random_bodies.hpp"
#include "actio/fast_body/any_dimension/moser_veselov_n.hpp"

using namespace actio;
using namespace actio::bodies;

namespace {

constexpr int n_ = Eigen::Dynamic;
using Long = long double;
using Matrix = std::vector<Long>;

/// h times a momentum and its remainder, as a matrix of 64-bit mantissas.
Matrix whole(RotatingBody const& body) {
  int const n = body.size();
  Matrix m(static_cast<std::size_t>(n * n), 0);
  auto const high = body.momentum(), low = body.momentum_remainder();
  over_planes(n, [&](int a, int i, int j) {
    Long const x = static_cast<Long>(high.components[a]) + low.components[a];
    m[static_cast<std::size_t>(i * n + j)] = x, m[static_cast<std::size_t>(j * n + i)] = -x;
  });
  return m;
}
Matrix times(Matrix const& a, Matrix const& b, int n) {
  Matrix c(a.size(), 0);
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k)
      for (int j = 0; j < n; ++j)
        c[static_cast<std::size_t>(i * n + j)] +=
            a[static_cast<std::size_t>(i * n + k)] * b[static_cast<std::size_t>(k * n + j)];
  return c;
}
/// \f$\mathrm{Tr}M^2\f$, \f$\mathrm{Tr}M^4\f$, \f$\mathrm{Tr}M^2\Lambda^2\f$ and the energy: a function of
/// the last two kinds for all n.
std::array<Long, 4> conserved_traces(RotatingBody const& body, Inertia<n_> const& inertia) {
  int const n = body.size();
  Matrix const m = whole(body), m2 = times(m, m, n), m4 = times(m2, m2, n);
  std::array<Long, 4> sums{};
  for (int i = 0; i < n; ++i) {
    auto const at = static_cast<std::size_t>(i * n + i);
    Long const l = inertia.lambda[i];
    sums[0] += m2[at], sums[1] += m4[at], sums[2] += m2[at] * l * l;
    for (int j = 0; j < n; ++j) {
      Long const x = m[static_cast<std::size_t>(i * n + j)];
      sums[3] += x * x / (l + inertia.lambda[j]);
    }
  }
  return sums;
}

struct Drift {
  double trace, worst, spatial, orthogonality, growth, squares;
};
Drift drift_of(Sweeps sweeps, unsigned seed, double angle, long count) {
  std::mt19937 random(seed);
  auto const [inertia, spin] = testing::random_body<n_>(random, 8);
  Eigen::MatrixXd const xi = inertia.group.hat(spin.coordinates);
  FastMoserVeselov const scheme(inertia, angle / std::sqrt(largest_eigenvalue(xi.transpose() * xi)), sweeps);
  auto body = scheme.release(body_momentum(inertia, spin));
  auto const start = conserved_traces(body, inertia);
  auto const spatial = body.spatial_momentum();
  std::vector<double> steps, changes;
  double worst = 0, largest = 0, squares = 0;
  for (long k = 1, next = 1000; k <= count; ++k) {
    scheme.step_with_attitude(body);
    squares += body.squares();
    if (k % 1000 && k != next) continue;
    auto const now = conserved_traces(body, inertia);
    for (std::size_t a = 0; a < now.size(); ++a)
      worst = std::max(worst, static_cast<double>(std::abs(now[a] / start[a] - 1)));
    largest = std::max(largest, static_cast<double>(std::abs(now[0] / start[0] - 1)));
    if (k == next)
      steps.push_back(static_cast<double>(k)), changes.push_back(std::max(largest, 1e-19)),
          next = next * 3 / 2;
  }
  auto const g = body.attitude().value;
  return {largest,
          worst,
          (body.spatial_momentum() - spatial).components.norm() / spatial.components.norm(),
          (g.transpose() * g - Eigen::MatrixXd::Identity(8, 8)).norm(),
          testing::fit_order(steps, changes).slope,
          squares / static_cast<double>(count)};
}

}  // namespace

BOOST_AUTO_TEST_SUITE(long_run)

BOOST_AUTO_TEST_CASE(isospectral_integrals_stay_over_a_million_steps) {
  constexpr double eps = std::numeric_limits<double>::epsilon(), angle = 0.1;
  constexpr long count = 1000000;
  for (unsigned seed : {1u, 2u, 3u}) {
    Drift const fast = drift_of(Sweeps::to_rounding, seed, angle, count),
                slow = drift_of(Sweeps::beyond_rounding, seed, angle, count);
    BOOST_TEST_MESSAGE("SO(8), 0.1 rad a step, 1e6 steps, beyond rounding: trace of M^2 "
                       << slow.trace << " (growth exponent " << slow.growth << "), worst integral "
                       << slow.worst << ", momentum in space " << slow.spatial << ", attitude "
                       << slow.orthogonality << ", squares a step " << slow.squares << "; to rounding: trace "
                       << fast.trace << " (" << fast.growth << "), squares " << fast.squares);
    // A rounding of e changes M by angle x eps; over 28 planes and as a random walk that is the first bound,
    // with 4 for integrals of the fourth degree.
    double const walk = angle * eps * std::sqrt(count / 28.0);
    BOOST_TEST(slow.trace <= walk);
    BOOST_TEST(slow.worst <= 4 * walk);
    // The attitude takes 8 x 8 such walks, and the momentum in space is as good as the attitude.
    BOOST_TEST(slow.orthogonality <= 2 * angle * eps * std::sqrt(64.0 * count));
    BOOST_TEST(slow.spatial <= 2 * angle * eps * std::sqrt(64.0 * count));
    BOOST_TEST(slow.growth < 0.8);
    // Stopped at rounding, half of eps in f of each step may pull the same way.
    BOOST_TEST(fast.trace <= angle * eps * count);
    BOOST_TEST(fast.trace > slow.trace);
  }
}

BOOST_AUTO_TEST_SUITE_END()
