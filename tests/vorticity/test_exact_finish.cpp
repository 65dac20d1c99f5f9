// The step in mixed precision beside the plain one: the same motion to its tolerance, the same invariants to
// rounding.
//
// In a unit of its own, which is as large as a unit may be.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>
#include <random>

#include "actio/quantized_sphere/sphere_invariants.hpp"
#include "actio/vorticity/fast_vorticity_step.hpp"
#include "refused.hpp"

using namespace actio;
using namespace actio::sphere;

namespace {

SkewHermitian<> random_state(int n, int most) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  SphereHarmonics f(n);
  for (int l = 1; l <= most; ++l)
    for (int m = 0; m <= l; ++m) {
      double const real = normal(random), imaginary = normal(random);
      f(l, m) = {real, m > 0 ? imaginary : 0};
    }
  return matrix_of(f);
}

/// \f$|W|^2\f$, summed to more digits than are asked for.
double square_of(SkewHermitian<> const& w) {
  long double sum = 0;
  for (auto const* part : {&w.real, &w.imaginary})
    for (double const x : part->reshaped()) sum += static_cast<long double>(x) * x;
  return static_cast<double>(sum);
}

/// Counts whole products in single precision, and all in double.
struct CountedProducts : ProductsBy<CountedProducts> {
  mutable int in_single = 0, in_double = 0;
  template <class Part>
  void whole(Part const& a, Part const& b, Part& out) const {
    (std::is_same_v<Part, Single> ? in_single : in_double) += 1;
    EigenProducts().whole(a, b, out);
  }
  template <class Part>
  void lower(Part const& a, Part const& b, Part& out) const {
    if (std::is_same_v<Part, Double>) ++in_double;
    EigenProducts().lower(a, b, out);
  }
};

}  // namespace

BOOST_AUTO_TEST_CASE(single_cayley_is_the_transform) {
  int const n = 24;
  SkewHermitian<> const w = random_state(n, 20);
  SkewHermitian<> a = SphereLaplacian(n).solve(w);
  double const radius = FastVorticityStep<>::spectral_radius(a);
  BOOST_TEST(std::abs(radius - vorticity_values(a).cwiseAbs().maxCoeff()) <= 0.02 * radius);
  for (double size : {0.01, 0.1, 0.4, 0.8}) {
    SkewHermitian<> scaled = a;
    scaled *= size / radius;
    SingleCayley cayley;
    cayley.factor(scaled, 1.02 * size);
    SkewHermitian<float> f, e;
    cayley.conjugate(w.cast<float>(), f, e);
    SkewHermitian<> found = (2.F * f + 4.F * e).cast<double>();
    mirror_lower(found);
    ComplexMatrix<> const one = ComplexMatrix<>::Identity(n, n),
                          u = (one - scaled.complex()).inverse() * (one + scaled.complex());
    // Some ten products of single precision, each with n roundings at the most.
    BOOST_TEST((u * w.complex() * u.adjoint() - w.complex() - found.complex()).norm() <=
               10 * n * std::numeric_limits<float>::epsilon() * size * norm(w));
  }
}

BOOST_AUTO_TEST_CASE(the_finish_is_exact_for_an_unconverged_middle) {
  // W_0 - r + 2C + U r U^* = U W_0 U^* for any middle.
  int const n = 12;
  SkewHermitian<> const w = random_state(n, 8), off = random_state(n, 11);
  SkewHermitian<> a = SphereLaplacian(n).solve(w);
  a *= 0.2 / FastVorticityStep<>::spectral_radius(a);
  ComplexMatrix<> const one = ComplexMatrix<>::Identity(n, n), x = a.complex(),
                        middle = (w + 0.1 * off).complex(), c = x * middle - middle * x,
                        r = w.complex() + c + x * middle * x - middle, u = (one - x).inverse() * (one + x);
  BOOST_TEST(r.norm() > 1e-3 * norm(w));
  BOOST_TEST((w.complex() - r + 2 * c + u * r * u.adjoint() - u * w.complex() * u.adjoint()).norm() <=
             1e-14 * n * norm(w));
}

BOOST_AUTO_TEST_CASE(the_finish_finds_the_middle_that_belongs_to_the_displacement) {
  int const n = 16;
  SkewHermitian<> const w = random_state(n, 9), off = random_state(n, 15);
  SkewHermitian<> a = SphereLaplacian(n).solve(w), end;
  a *= 0.2 / FastVorticityStep<>::spectral_radius(a);
  for (bool better : {false, true}) {
    IsospectralFinish<> finish(eigen_products());
    finish.transform().factor(a, 0.21);
    SkewHermitian<> middle, average;
    finish.find_middle(w, w.cast<float>(), false, middle, average);
    middle += 1e-4 * off;
    double const before = finish.evaluate(w, a, middle);
    BOOST_TEST(before > 1e-5 * norm(w));
    if (better) finish.better_middle(a, 1, middle);
    finish.find_end(w, middle, end);
    mirror_lower(middle);
    // What single precision makes of r: some ten products, each with n roundings at the most.
    BOOST_TEST(finish.evaluate(w, a, middle) <= 10 * n * std::numeric_limits<float>::epsilon() * before);
    // Of the step with that middle, the end is that of the step without an iteration.
    SkewHermitian<> const apart = end - w - 2.0 * commutator(a, middle);
    BOOST_TEST(norm(apart) <= 10 * n * std::numeric_limits<float>::epsilon() * before);
  }
}

BOOST_AUTO_TEST_CASE(the_fast_step_is_the_plain_one_to_its_tolerance_and_conserves_to_rounding) {
  int const n = 16, steps = 60;
  QuantizedSphere const sphere(n);
  SphereLaplacian const laplacian(n);
  SkewHermitian<> const start = random_state(n, 9);
  double const energy = vorticity_energy(laplacian, start);
  Eigen::Vector3d const momentum = sphere_momentum(start);
  Eigen::VectorXd const values = vorticity_values(start);
  TurningFrame const calm = calmest_frame(sphere, laplacian, start);
  for (auto const conserved : {Conserved::lie_poisson, Conserved::energy_casimir, Conserved::all_invariants})
    for (TurningFrame const& frame : {TurningFrame{}, calm}) {
      SkewHermitian<> w = start, exact = start;
      FastVorticityStep<> fast(laplacian, conserved, 0.01, frame);
      VorticityStep<> plain(laplacian, conserved, 0.01, frame);
      int rounds = 0;
      for (int k = 0; k < steps; ++k) {
        int const some = fast.advance(w).iterations;
        plain.advance(exact);
        if (k >= 10) rounds += some;
      }
      // Four rounds would be a plain step in disguise.
      BOOST_TEST(rounds <= 4 * (steps - 10));
      // A relative error of 1e-8 of A in each step, |A||W| at the most 0.1 |W|, and the flow does not double
      // errors in this time.
      BOOST_TEST(norm(w - exact) <= 2 * steps * 1e-9 * norm(w));
      BOOST_TEST(norm(w - exact) > 0);
      // A random walk of roundings over sixty steps, and sums of n^2 terms.
      BOOST_TEST((vorticity_values(w) - values).cwiseAbs().maxCoeff() <=
                 1e-13 * values.cwiseAbs().maxCoeff());
      double const by_energy = std::abs(vorticity_energy(laplacian, w) / energy - 1);
      double const by_momentum = (sphere_momentum(w) - momentum).norm() / momentum.norm();
      BOOST_TEST((conserved == Conserved::lie_poisson ? by_energy > 1e-9 : by_energy <= 1e-13));
      BOOST_TEST((conserved == Conserved::energy_casimir ? by_momentum > 1e-9 : by_momentum <= 1e-13));
    }
}

BOOST_AUTO_TEST_CASE(the_first_step_needs_no_history) {
  int const n = 16;
  SphereLaplacian const laplacian(n);
  SkewHermitian<> const start = random_state(n, 9);
  TurningFrame const calm = calmest_frame(QuantizedSphere(n), laplacian, start);
  // Squares of the second state are no numbers of single precision.
  for (double unit : {1.0, 1e-30})
    for (auto const conserved :
         {Conserved::lie_poisson, Conserved::energy_casimir, Conserved::all_invariants}) {
      TurningFrame const frame{calm.axis, unit * calm.rate};
      SkewHermitian<> const from = unit * start;
      SkewHermitian<> w = from, exact = from;
      FastVorticityStep<>(laplacian, conserved, 0.01 / unit, frame).advance(w);
      VorticityStep<>(laplacian, conserved, 0.01 / unit, frame).advance(exact);
      // A to 1e-8 of |A|, which is at most 0.1.
      BOOST_TEST(norm(w - exact) <= 2e-9 * norm(exact));
      // A step in double precision in disguise would be that very one.
      BOOST_TEST((norm(w - exact) > 0) == (unit == 1));
      // Sums of n^2 terms, and products of n.
      double const rounding = 1e-14;
      if (conserved != Conserved::lie_poisson)
        BOOST_TEST(std::abs(vorticity_energy(laplacian, w) / vorticity_energy(laplacian, from) - 1) <=
                   rounding);
      if (conserved != Conserved::energy_casimir)
        BOOST_TEST((sphere_momentum(w) - sphere_momentum(from)).norm() <=
                   rounding * sphere_momentum(from).norm());
      BOOST_TEST((vorticity_values(w) - vorticity_values(from)).cwiseAbs().maxCoeff() <=
                 rounding * norm(from));
    }
}

BOOST_AUTO_TEST_CASE(a_flow_that_is_smooth_in_time_needs_no_round) {
  int const n = 16, steps = 40;
  SphereLaplacian const laplacian(n);
  SkewHermitian<> const start = random_state(n, 4);
  TurningFrame const calm = calmest_frame(QuantizedSphere(n), laplacian, start);
  for (auto const conserved :
       {Conserved::lie_poisson, Conserved::energy_casimir, Conserved::all_invariants}) {
    auto const counted = std::make_shared<CountedProducts>();
    SkewHermitian<> w = start, exact = start;
    FastVorticityStep<> fast(laplacian, conserved, 0.002, calm, counted);
    VorticityStep<> plain(laplacian, conserved, 0.002, calm);
    int least = 1000, in_double = 0;
    for (int k = 0; k < steps; ++k) {
      counted->in_single = counted->in_double = 0;
      fast.advance(w), plain.advance(exact);
      if (k >= 10) least = std::min(least, counted->in_single), in_double += counted->in_double;
    }
    // The equation once, six products. Three whole ones in single precision conjugate r, and as many make the
    // commutator with P, the move and its square; a round would conjugate W, and better the middle, by six
    // more.
    BOOST_TEST(in_double == 6 * (steps - 10));
    BOOST_TEST(least <= 3 + 3 * (conserved == Conserved::lie_poisson ? 2 : 3));
    BOOST_TEST(norm(w - exact) <= 2 * steps * 1e-9 * norm(w));
  }
}

BOOST_AUTO_TEST_CASE(what_single_precision_is_off_by_does_not_add_up) {
  int const n = 16, steps = 10000;
  SphereLaplacian const laplacian(n);
  SkewHermitian<> const start = random_state(n, 9);
  TurningFrame const calm = calmest_frame(QuantizedSphere(n), laplacian, start);
  // The largest eigenvalue of A is about a seventh.
  double const h =
      0.15 * 2 * QuantizedSphere(n).hbar() / FastVorticityStep<>::spectral_radius(laplacian.solve(start));
  Eigen::VectorXd const casimirs = vorticity_casimirs(start, 8), values = vorticity_values(start);
  for (auto const conserved :
       {Conserved::lie_poisson, Conserved::energy_casimir, Conserved::all_invariants}) {
    SkewHermitian<> w = start;
    FastVorticityStep<> fast(laplacian, conserved, h, calm);
    for (int k = 0; k < steps; ++k) fast.advance(w);
    // A random walk: a step rounds each entry twice, and so its mirror image, with an error below half a unit
    // that is evenly spread. Four of its standard deviations, and as much for what the products round.
    double const fourth = w.real.array().pow(4).sum() + w.imaginary.array().pow(4).sum(),
                 half_unit = std::numeric_limits<double>::epsilon() / 2,
                 walk = 2 * half_unit / std::sqrt(3.0) * std::sqrt(2 * 2.0 * steps * fourth) /
                        inner_product(w, w);
    BOOST_TEST_MESSAGE("C_2 changes by " << square_of(w) / square_of(start) - 1 << ", a random walk by "
                                         << walk);
    BOOST_TEST(std::abs(square_of(w) / square_of(start) - 1) <= 8 * walk);
    // C_k in units of the same sum of the moduli: odd ones may nearly vanish.
    Eigen::VectorXd const now = vorticity_casimirs(w, 8);
    for (Eigen::Index k = 0; k < now.size(); ++k) {
      double const unit = 4 * M_PI / n * values.cwiseAbs().array().pow(double(k) + 2).sum();
      BOOST_TEST(std::abs(now[k] - casimirs[k]) <= 1e-13 * unit);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_commutator_with_a_few_diagonals_is_the_commutator) {
  int const n = 9;
  SkewHermitian<> const x = random_state(n, 8), full = random_state(n, 7);
  for (int most : {0, 2, n - 1}) {
    SkewBand<double> band{Eigen::ArrayXXd::Zero(most + 1, n), Eigen::ArrayXXd::Zero(most + 1, n)};
    SkewHermitian<> y(n), found;
    for (int c = 0; c < n; ++c)
      for (int d = 0; d <= most && c + d < n; ++d) {
        band.real(d, c) = y.real(c + d, c) = full.real(c + d, c);
        band.imaginary(d, c) = y.imaginary(c + d, c) = full.imaginary(c + d, c);
      }
    mirror_lower(y);
    banded_commutator(band, x, found);
    mirror_lower(found);
    // Sums of 4n products.
    double const rounding = 4 * n * std::numeric_limits<double>::epsilon();
    BOOST_TEST(norm(found - commutator(y, x)) <= rounding * norm(y) * norm(x));
    BOOST_TEST(std::abs(norm(band) - norm(y)) <= rounding * norm(y));
  }
}

BOOST_AUTO_TEST_CASE(a_move_along_the_orbit_takes_momentum_back_and_keeps_the_squares) {
  int const n = 16;
  QuantizedSphere const sphere(n);
  SphereHarmonics fourfold(n);
  fourfold(1, 0) = 1, fourfold(4, 4) = {1, 0.5}, fourfold(6, 4) = {-0.7, 1};
  Eigen::Matrix3d const axes = Eigen::Matrix3d::Identity();
  // Of a flow with a fourfold axis the derivative in turns about it has nothing on a few diagonals.
  for (bool symmetric : {false, true})
    for (int axis : {0, 2}) {
      SkewHermitian<> const start = symmetric ? matrix_of(fourfold) : random_state(n, 9);
      SkewHermitian<float> const rounded = start.cast<float>();
      // By a Y of about this size.
      double const size = 1e-3;
      Eigen::Vector3d change = Eigen::Vector3d::Zero();
      change[axis] = size * norm(spin_commutator(sphere, axis, start));
      OrbitMove<> move(sphere, {axes.col(0), axes.col(1), axes.col(2)});
      SingleCayley products;
      move.find(products, nullptr, rounded, change, 1, 1);
      SkewHermitian<> w = start;
      move.move(products, rounded, w);
      BOOST_TEST(move.is_banded() == !(symmetric && axis == 2));
      BOOST_TEST(move.length() <= 10 * size);
      // The first order; of the second, what Y changes is by its size smaller.
      Eigen::Vector3d const left = spin_components(sphere, start) - spin_components(sphere, w) - change;
      BOOST_TEST(left.norm() <= 10 * move.length() * change.norm());
      // The squares have no part of second order in the move, nor of third; the bound is between the fourth
      // order and sums of single precision on the one side and the second order on the other.
      double const moved = norm(w - start) / norm(start);
      BOOST_TEST(std::abs(square_of(w) / square_of(start) - 1) <= 0.02 * moved * moved);
    }
}

BOOST_AUTO_TEST_CASE(a_step_goes_on_bit_for_bit_from_what_was_kept) {
  int const n = 12;
  SphereLaplacian const laplacian(n);
  SkewHermitian<> w = random_state(n, 7);
  FastVorticityStep<> first(laplacian, Conserved::all_invariants, 0.01),
      second(laplacian, Conserved::all_invariants, 0.01);
  for (int k = 0; k < 3; ++k) first.advance(w);
  // Among the first steps, and across the next estimate of the radius.
  for (int k = 0; k < 20; ++k) {
    SkewHermitian<> again = w;
    second.go_on_from(first.past());
    first.advance(w), second.advance(again);
    BOOST_TEST((w.real == again.real && w.imaginary == again.imaginary));
  }
}

BOOST_AUTO_TEST_CASE(a_step_that_does_not_contract_is_refused_and_leaves_the_state) {
  int const n = 12;
  SphereLaplacian const laplacian(n);
  SkewHermitian<> const start = random_state(n, 7);
  SkewHermitian<> w = start;
  FastVorticityStep<> step(laplacian, Conserved::lie_poisson, 5);
  CHECK_REFUSED(step.advance(w), NotContracting);
  BOOST_TEST(norm(w - start) == 0);
}
