// Steps of a flow apart from what turns as a whole: they are the steps of the sum, and what they conserve
// they conserve to the rounding of the flow, however fast the sphere turns.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "actio/quantized_sphere/helmholtz_stream.hpp"
#include "actio/vorticity/vorticity_step.hpp"
#include "flows.hpp"

using namespace actio;
using namespace actio::sphere;
using testing::random_state;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr Conserved forms[] = {Conserved::lie_poisson, Conserved::energy_casimir, Conserved::all_invariants};
char const* name(Conserved conserved) {
  return conserved == Conserved::lie_poisson      ? "lie_poisson"
         : conserved == Conserved::energy_casimir ? "energy_casimir"
                                                  : "all_invariants";
}

/// W + b x_3.
SkewHermitian<> with(double b, SkewHermitian<> w) {
  QuantizedSphere const sphere(static_cast<int>(w.size()));
  add_spin(sphere, sphere.hbar() * b * Eigen::Vector3d::UnitZ(), w);
  return w;
}
/// The background of a flow, and the frame that goes with it: Delta, or Delta - gamma, of x_3 is -2 - gamma
/// of it.
struct Apart {
  ZonalBackground background;
  TurningFrame frame;

  Apart(double b, double stream, double gamma = 0) : background{b, stream} {
    frame.rate = stream + b / (2 + gamma);
  }
};
/// The stream of the frame in which waves of a degree about l hardly move; the Lie-Poisson form takes none.
double stream_of(Conserved conserved, double b, int l, double gamma = 0) {
  return conserved == Conserved::lie_poisson ? 0 : -b / (l * (l + 1.0) + gamma);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(zonal_background)

BOOST_AUTO_TEST_CASE(a_step_apart_is_a_step_of_the_sum) {
  int const n = 12, steps = 6;
  auto const compare = [&](auto const& stream, double gamma) {
    using Step = VorticityStep<std::decay_t<decltype(stream)>>;
    for (auto const conserved : forms)
      for (double const b : {0.7, -6.0}) {
        // The Lie-Poisson form takes the direction of the angular momentum for the axis.
        if (conserved == Conserved::lie_poisson && b < 0) continue;
        // The energy-Casimir form keeps the angular momentum about its axis alone, which need not be all.
        SkewHermitian<> const start =
            random_state(n, conserved == Conserved::energy_casimir ? 1 : 2, n - 1, 5);
        Apart const apart(b, stream_of(conserved, b, 4, gamma), gamma);
        SkewHermitian<> v = start, w = with(b, start);
        double const h = 0.05;
        Step of_flow(stream, conserved, h, apart.frame, eigen_products(), apart.background),
            of_all(stream, conserved, h, apart.frame);
        for (int k = 0; k < steps; ++k) of_flow.advance(v), of_all.advance(w);
        double const off = norm(with(b, v) - w) / norm(w);
        BOOST_TEST_MESSAGE(name(conserved) << ", b = " << b << ", gamma = " << gamma << ": " << off);
        // Each of the two leaves a rounding of N terms in each step.
        BOOST_TEST(off <= 2 * steps * n * eps);
        BOOST_TEST(norm(v - start) > 0.01 * norm(start));
      }
  };
  compare(SphereLaplacian(n), 0);
  compare(HelmholtzStream(n, 6.25), 6.25);
}

BOOST_AUTO_TEST_CASE(what_is_conserved_is_so_relative_to_the_flow_at_every_rotation) {
  int const n = 16, steps = 60;
  SphereLaplacian const laplacian(n);
  for (auto const conserved : forms)
    for (double const b : {30.0, 1e3, 1e5, 1e8, 1e12}) {
      SkewHermitian<> const start = random_state(n, 2, n - 1, 9);
      Apart const apart(b, stream_of(conserved, b, 5));
      SkewHermitian<> v = start;
      VorticityStep<> step(laplacian, conserved, 0.4 / b, apart.frame, eigen_products(), apart.background);
      for (int k = 0; k < steps; ++k) step.advance(v);
      double const energy = std::abs(vorticity_energy(laplacian, v) / vorticity_energy(laplacian, start) - 1),
                   squares = std::abs(enstrophy(v) / enstrophy(start) - 1);
      Eigen::Vector3d const momentum =
          (sphere_momentum(v) - sphere_momentum(start)) / std::sqrt(4 * M_PI / 3 * 2 * enstrophy(start));
      BOOST_TEST_MESSAGE(name(conserved) << ", b = " << b << ": energy " << energy << ", enstrophy "
                                         << squares << ", momentum " << momentum.norm());
      double const bound = steps * n * eps;
      // By the Casimir C_2 and the angular momentum about the axis the enstrophy of the flow stays; times b,
      // so that of the momentum there must be no rounding at all.
      BOOST_TEST(squares <= bound);
      BOOST_TEST(std::abs(momentum[2]) <= bound);
      if (conserved != Conserved::energy_casimir) BOOST_TEST(momentum.norm() <= bound);
      if (conserved != Conserved::lie_poisson) BOOST_TEST(energy <= bound);
      // The flow has moved.
      BOOST_TEST(norm(v - start) > 0.1 * norm(start));
    }
}

BOOST_AUTO_TEST_CASE(waves_stay_in_their_frame_in_steps_of_any_length_that_is_solved) {
  int const n = 16;
  SphereLaplacian const laplacian(n);
  SkewHermitian<> const wave = random_state(n, 5, 5, 3);
  for (auto const conserved : {Conserved::energy_casimir, Conserved::all_invariants})
    for (double const b : {50.0, 1e6})
      for (double const h : {0.1 / b, 3 / b, 1e4 / b}) {
        Apart const apart(b, -b / 30);
        SkewHermitian<> v = wave;
        VorticityStep<> step(laplacian, conserved, h, apart.frame, eigen_products(), apart.background);
        try {
          for (int k = 0; k < 3; ++k) step.advance(v);
        } catch (NotContracting const&) {
          BOOST_TEST(h * b > 3);  // the sphere turns by more than that in the step
          continue;
        }
        // Where the middle is eliminated, rounding is that of a system of the size 2N.
        BOOST_TEST(norm(v - wave) <= 64 * n * eps * norm(wave),
                   "b = " << b << ", h b = " << h * b << ": " << norm(v - wave) / norm(wave));
      }
}

BOOST_AUTO_TEST_CASE(weak_flows_on_a_fast_sphere_are_waves_of_every_degree) {
  // Without the products of V with itself the coefficients at (l, m) turn on their own, by b/(l (l + 1)) to
  // the west, in the frame of the sphere.
  int const n = 12;
  double const b = 2, time = 3, size = 1e-9;
  SphereLaplacian const laplacian(n);
  SphereHarmonics const f = testing::random_harmonics(n, 2, n - 1, 4);
  SkewHermitian<> const start = size * matrix_of(f);
  for (auto const conserved : forms) {
    std::vector<double> steps, errors;
    for (int const count : {60, 120, 240}) {
      Apart const apart(b, stream_of(conserved, b, 4));
      SkewHermitian<> v = start;
      VorticityStep<> step(laplacian, conserved, time / count, apart.frame, eigen_products(),
                           apart.background);
      for (int k = 0; k < count; ++k) step.advance(v);
      SphereHarmonics const g = harmonics_of(v);
      double square = 0, all = 0;
      for (int l = 2; l < n; ++l)
        for (int m = 0; m <= l; ++m) {
          // The sphere turns by b/2, and the frame by its rate.
          double const angle = m * (b / 2 - b / (l * (l + 1.0)) - apart.frame.rate) * time;
          square += std::norm(g(l, m) / size - f(l, m) * std::polar(1.0, -angle)), all += std::norm(f(l, m));
        }
      steps.push_back(time / count), errors.push_back(std::sqrt(square / all));
    }
    auto const line = testing::order_of(steps, errors);
    BOOST_TEST_MESSAGE(name(conserved) << ": errors " << errors.front() << " to " << errors.back()
                                       << ", order " << line.slope);
    BOOST_TEST(std::abs(line.slope - 2) <= 0.1);
    BOOST_TEST(errors.back() <= 1e-2);
  }
}

BOOST_AUTO_TEST_CASE(where_there_is_no_flow_nothing_moves) {
  int const n = 8;
  SphereLaplacian const laplacian(n);
  for (auto const conserved : forms) {
    Apart const apart(1e6, 0);
    SkewHermitian<> v(n);
    VorticityStep<>(laplacian, conserved, 1e-3, apart.frame, eigen_products(), apart.background).advance(v);
    BOOST_TEST(norm(v) == 0);
  }
}

BOOST_AUTO_TEST_SUITE_END()
