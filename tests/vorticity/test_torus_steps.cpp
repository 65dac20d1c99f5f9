// Steps of a flow on the torus: what they keep, flows that stand still, the limit of large N.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "actio/quantized_torus/torus_invariants.hpp"
#include "actio/skew_matrices/dense_matrices.hpp"
#include "actio/vorticity/torus_steps.hpp"
#include "refused.hpp"
#include "torus_flows.hpp"

using namespace actio;
using namespace actio::torus;
using sphere::Conserved, sphere::SkewHermitian, sphere::norm;
using testing::random_torus_harmonics, testing::random_torus_state;

namespace {

constexpr Conserved forms[] = {Conserved::lie_poisson, Conserved::energy_casimir};

template <class Step>
SkewHermitian<> after(TorusStream const& stream, Conserved form, SkewHermitian<> w, double time, int steps) {
  Step step(stream, form, time / steps);
  for (int k = 0; k < steps; ++k) step.advance(w);
  return w;
}
Eigen::VectorXd spectrum(SkewHermitian<> const& w) { return sphere::hermitian_values(w.hermitian()); }

/// Euler's equation for the coefficients up to `most`, the others left out: omega' = -{psi, omega}, summed as
/// it stands, with the Laplacian of the torus itself. Knows nothing of matrices.
struct Galerkin {
  int most;
  double gamma;
  using State = Eigen::MatrixXcd;  ///< (m + most, n + most)

  State rate(State const& w) const {
    State out = State::Zero(w.rows(), w.cols());
    for (int a = -most; a <= most; ++a)
      for (int b = -most; b <= most; ++b) {
        if (a == 0 && b == 0) continue;
        std::complex<double> const psi = -w(a + most, b + most) / (a * a + b * b + gamma);
        for (int c = std::max(-most, -most - a); c <= std::min(most, most - a); ++c)
          for (int d = std::max(-most, -most - b); d <= std::min(most, most - b); ++d)
            out(a + c + most, b + d + most) -= double(b * c - a * d) * psi * w(c + most, d + most);
      }
    return out;
  }
  State after(State w, double time, int steps) const {
    double const h = time / steps;
    for (int k = 0; k < steps; ++k) {
      State const k1 = rate(w), k2 = rate(w + h / 2 * k1), k3 = rate(w + h / 2 * k2), k4 = rate(w + h * k3);
      w += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    }
    return w;
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(torus_steps)

BOOST_AUTO_TEST_CASE(spectrum_and_energy_stay_and_steps_go_back) {
  int const n = 21, steps = 60;
  for (double gamma : {0.0, 4.0}) {
    TorusStream const stream(n, gamma);
    SkewHermitian<> const start = random_torus_state(n, 6);
    double const energy = flow_energy(stream, start);
    Eigen::VectorXd const values = spectrum(start);
    for (auto const form : forms) {
      SkewHermitian<> const w = after<TorusStep>(stream, form, start, 1, steps),
                            fast = after<FastTorusStep>(stream, form, start, 1, steps);
      BOOST_TEST(norm(w - start) > 0.1 * norm(start));
      BOOST_TEST(norm(fast - w) <= 1e-6 * norm(w));
      for (auto const* one : {&w, &fast}) {
        double const change = std::abs(flow_energy(stream, *one) / energy - 1);
        BOOST_TEST((spectrum(*one) - values).cwiseAbs().maxCoeff() <= 1e-14 * values.cwiseAbs().maxCoeff());
        BOOST_TEST((form == Conserved::lie_poisson ? change > 1e-7 : change <= 1e-14));
      }
      BOOST_TEST(norm(after<TorusStep>(stream, form, w, -1, steps) - start) <= 1e-12 * norm(start));
    }
  }
}

// There is nothing to turn about: the form that keeps the angular momentum, too, is the same one.
BOOST_AUTO_TEST_CASE(there_is_no_momentum_and_no_frame) {
  TorusStream const stream(11);
  SkewHermitian<> const start = random_torus_state(11, 4);
  BOOST_TEST(norm(after<TorusStep>(stream, Conserved::all_invariants, start, 0.2, 5) -
                  after<TorusStep>(stream, Conserved::energy_casimir, start, 0.2, 5)) == 0);
  sphere::TurningFrame const turns{Eigen::Vector3d::UnitZ(), 0.1};
  CHECK_REFUSED(TorusStep(stream, Conserved::energy_casimir, 0.1, turns), OutsideDomain);
}

// Not for long, since rounding grows: these flows are unstable.
BOOST_AUTO_TEST_CASE(flows_of_one_eigenvalue_stand_still) {
  int const n = 25;
  TorusHarmonics taylor_green(n), other(n);
  taylor_green.set(1, 1, 0.5), taylor_green.set(1, -1, 0.5);  // 2 cos x cos y
  std::complex<double> const i(0, 1);
  other.set(3, 1, 0.3 + 0.2 * i), other.set(3, -1, 0.1 * i), other.set(1, 3, -0.4), other.set(-1, 3, 0.2 - i);
  for (auto const& f : {taylor_green, other})
    for (double gamma : {0.0, 2.5}) {
      TorusStream const stream(n, gamma);
      SkewHermitian<> const start = matrix_of(f);
      BOOST_TEST(norm(after<TorusStep>(stream, Conserved::energy_casimir, start, 2, 10) - start) <=
                 1e-14 * norm(start));
    }
}

BOOST_AUTO_TEST_CASE(steps_are_of_the_second_order) {
  int const n = 17;
  TorusStream const stream(n);
  SkewHermitian<> const start = random_torus_state(n, 3);
  for (auto const form : forms) {
    SkewHermitian<> const fine = after<TorusStep>(stream, form, start, 1, 3200);
    double const long_steps = norm(after<TorusStep>(stream, form, start, 1, 100) - fine),
                 short_steps = norm(after<TorusStep>(stream, form, start, 1, 200) - fine);
    BOOST_TEST(std::abs(std::log2(long_steps / short_steps) - 2) <= 0.02);
  }
}

// The flow itself is a Galerkin solution in the limit, at the rate N^-2.
BOOST_AUTO_TEST_CASE(the_flow_tends_to_that_of_the_fluid) {
  int const most = 9;
  for (double gamma : {0.0, 3.0}) {
    double before = 0;
    for (int n : {41, 83}) {
      TorusHarmonics const f = random_torus_harmonics(n, 2, 4);
      Galerkin const fluid{most, gamma};
      Galerkin::State w(2 * most + 1, 2 * most + 1);
      for (int m = -most; m <= most; ++m)
        for (int k = -most; k <= most; ++k) w(m + most, k + most) = f(m, k);
      double const time = 0.1;
      w = fluid.after(w, time, 40);
      TorusHarmonics const found = torus::harmonics_of(
          after<TorusStep>(TorusStream(n, gamma), Conserved::energy_casimir, matrix_of(f), time, 60));
      double error = 0, moved = 0;
      for (int m = -most; m <= most; ++m)
        for (int k = -most; k <= most; ++k)
          error += std::norm(found(m, k) - w(m + most, k + most)),
              moved += std::norm(f(m, k) - w(m + most, k + most));
      error = std::sqrt(error / moved);
      BOOST_TEST_MESSAGE("gamma " << gamma << ", N = " << n << ": off by " << error << " of the motion");
      BOOST_TEST(error <= 0.1);
      if (n == 83) BOOST_TEST(std::abs(before / error - 4.1) <= 0.4);
      before = error;
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
