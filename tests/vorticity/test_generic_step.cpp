// The step of the fluid is chapter 3 on SU(N): held to the discrete Euler-Poincare equations of any group.
//
// Here the group and the discrete Lagrangian are all that is given. The fluid is right-invariant, with
// xi = P/hbar and the Lagrangian -1/2 <P, Delta P>, in multiples of 4 pi/N; its momentum is -hbar W. Cayley's
// transform of a traceless matrix is unitary, and for N > 2 its determinant is not 1: rotations of the phase,
// with which all commutes, are no motion of the fluid, and the group is U(N) up to them. An element of SU(N)
// stands for its class.
#include <boost/test/unit_test.hpp>

#include "actio/groups/unitary_groups.hpp"
#include "actio/reduction/discrete_lie_poisson.hpp"
#include "actio/vorticity/vorticity_step.hpp"
#include "flows.hpp"

using namespace actio;
using namespace actio::sphere;

namespace {

/// How an element becomes a velocity.
enum class Chart {
  up_to_phase,   ///< of the multiple whose Cayley velocity has no trace
  trace_dropped  ///< of the element itself; what it has of a trace is left out: another scheme from N = 3 on
};

/// The trace of i times the complex matrix that a real one of twice the size is, with the other sign.
template <class M>
typename M::Scalar imaginary_trace(M const& a) {
  Index const n = a.rows() / 2;
  typename M::Scalar sum(0);
  for (Index k = 0; k < n; ++k) sum += a(n + k, k);
  return sum;
}

/// \f$\ell_h(f) = h\,L(\xi)\f$ with \f$f = \lambda\,\mathrm{cay}(-h\xi)\f$ and
/// \f$L = -\tfrac12\hbar^2\langle\xi, \Delta\xi\rangle\f$.
struct FluidLagrangian {
  int n;
  double h;
  Chart chart = Chart::up_to_phase;

  template <Scalar S>
  S operator()(Element<SU<>, S> const& f) const {
    using Matrix = Storage<SU<>, S>;
    Matrix velocity = inverse_cayley(f.value);
    // Newton's iteration for the phase, with which the trace falls by 1 - xi^2/4; it doubles its digits, and
    // derivatives follow one round later.
    for (int round = 0; round < 7 && chart == Chart::up_to_phase; ++round) {
      Matrix const slope = Matrix::Identity(2 * n, 2 * n) - velocity * velocity / S(4);
      S trace(0);
      for (Index k = 0; k < n; ++k) trace += slope(k, k);
      S const angle = imaginary_trace(velocity) / trace;
      // cay of (a turned by the phase), from cay^-1 itself: tangents add up.
      Matrix by = velocity / S(2), one = Matrix::Identity(2 * n, 2 * n);
      S const t = angle / S(2);
      Matrix imaginary = Matrix::Zero(2 * n, 2 * n);
      for (Index k = 0; k < n; ++k) imaginary(n + k, k) = t, imaginary(k, n + k) = -t;
      // tan(a - b) = (tan a - tan b)/(1 + tan a tan b), with the matrix i tan a.
      velocity = S(2) * solve_linear((one - by * imaginary).eval(), (by - imaginary).eval(), "phase");
    }
    return energy(velocity / S(-h)) * S(h);
  }

 private:
  /// The Laplacian by double commutators: nothing of what the step uses.
  template <class Matrix>
  typename Matrix::Scalar energy(Matrix xi) const {
    using S = typename Matrix::Scalar;
    // Without its trace, which matters for the other chart alone.
    S const mean = imaginary_trace(xi) / S(n);
    for (Index k = 0; k < n; ++k) xi(n + k, k) -= mean, xi(k, n + k) += mean;
    QuantizedSphere const sphere(n);
    S sum(0);
    for (int axis = 0; axis < 3; ++axis) {
      Matrix spin = Matrix::Zero(2 * n, 2 * n);  // of i S_j
      ComplexMatrix<> const s = std::complex<double>(0, 1) * sphere.spin(axis);
      for (int r = 0; r < n; ++r)
        for (int c = 0; c < n; ++c) {
          spin(r, c) = spin(n + r, n + c) = S(s(r, c).real());
          spin(n + r, c) = S(s(r, c).imag()), spin(r, n + c) = S(-s(r, c).imag());
        }
      // -<xi, Delta xi> is the sum of the squares of [i S_j, xi]; real matrices count twice.
      Matrix const c = spin * xi - xi * spin;
      for (Index k = 0; k < c.cols(); ++k)
        for (Index j = 0; j < c.rows(); ++j) sum += c(j, k) * c(j, k);
    }
    return sum * S(sphere.hbar() * sphere.hbar() / 4);
  }
};

/// A skew-Hermitian matrix in the real form of the group.
actio::Matrix<double, Dynamic, Dynamic> in_real_form(SkewHermitian<> const& w) {
  Index const n = w.size();
  actio::Matrix<double, Dynamic, Dynamic> a(2 * n, 2 * n);
  a << w.real, -w.imaginary, w.imaginary, w.real;
  return a;
}
/// \f$\langle M, e_a\rangle\f$ for the basis of the algebra.
Momentum<SU<>, double> as_momentum(SkewHermitian<> const& m) {
  SU<> const group(static_cast<int>(m.size()));
  Momentum<SU<>, double> mu{group, Coordinates<SU<>, double>(group.dimension())};
  for (int a = 0; a < group.dimension(); ++a)
    mu.components[a] =
        in_real_form(m).cwiseProduct(group.hat(basis_velocity<double>(group, a).coordinates)).sum() / 2;
  return mu;
}

struct Distances {
  double momentum = 0, motion = 0, size = 0;
};

/// Steps by both ways from one state, and how far they get from one another.
///
/// The equations begin with the first motion of the step, whose momentum must be that of the state; from
/// there on they find their motions by themselves. With `direction` -1 they are those of time reversed.
Distances both_ways(int n, double h, int steps, Chart chart = Chart::up_to_phase, double direction = 1) {
  QuantizedSphere const sphere(n);
  SphereLaplacian const laplacian(n);
  SU<> const group(n);
  SkewHermitian<> w = testing::random_state(n, 1, n - 1, 7);
  FluidLagrangian const l{n, direction * h, chart};
  auto const mu_of = [&](SkewHermitian<> const& x) { return as_momentum(-sphere.hbar() * x); };
  VorticityStep<> step(laplacian, Conserved::lie_poisson, h);
  Element<SU<>, double> f{group, {}};
  auto mu = mu_of(w);
  Distances far;
  far.size = mu.components.norm();
  for (int k = 0; k < steps; ++k) {
    step.advance(w);
    // The motion is cay(2 A)^-1, up to a phase.
    SkewHermitian<> const back = -2.0 * step.displacement();
    auto const motion = cayley(in_real_form(back));
    f = k == 0 ? restore(Element<SU<>, double>{group, motion}) : step_euler_poincare_right(l, f).value;
    auto const between = (f.value.transpose() * motion).eval();
    double const cosine = between.topLeftCorner(n, n).trace() / n,
                 sine = between.bottomLeftCorner(n, n).trace() / n;
    far.motion = std::max(far.motion, std::abs(1 - std::hypot(cosine, sine)));
    // Twice the same: the momentum that the equations carry, and the one that the next motion begins with.
    far.momentum = std::max(far.momentum, (momentum_before_right(l, f) - mu).components.norm());
    mu = lie_poisson_update_right(f, mu);
    far.momentum = std::max(far.momentum, (mu - mu_of(w)).components.norm());
  }
  return far;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(generic_implementation)

// Newton's iteration leaves 16 epsilon of the derivative's rows; each step adds that, in N^2 components.
BOOST_AUTO_TEST_CASE(the_step_is_the_discrete_euler_poincare_algorithm) {
  for (int n : {2, 3, 4, 5}) {
    Distances const far = both_ways(n, 0.3, n < 5 ? 5 : 3);
    BOOST_TEST_MESSAGE("N = " << n << ": momenta of both ways differ by " << far.momentum / far.size
                              << ", motions by " << far.motion);
    BOOST_TEST(far.momentum <= 1e-13 * n * n * far.size);
    BOOST_TEST(far.motion <= 1e-13);
  }
}

BOOST_AUTO_TEST_CASE(other_schemes_are_told_apart) {
  // With the trace left out of the velocity another scheme results, which agrees for N = 2 alone.
  BOOST_TEST(both_ways(2, 1, 2, Chart::trace_dropped).momentum <= 1e-12);
  Distances const dropped = both_ways(3, 1, 2, Chart::trace_dropped),
                  reversed = both_ways(3, 1, 2, Chart::up_to_phase, -1);
  BOOST_TEST_MESSAGE("N = 3: with the trace left out " << dropped.momentum / dropped.size
                                                       << ", with time reversed "
                                                       << reversed.momentum / reversed.size);
  BOOST_TEST(dropped.momentum > 1e-7 * dropped.size);
  BOOST_TEST(reversed.momentum > 1e-3 * reversed.size);
}

// N = 2 knows rotations alone: a rigid body whose moments are equal.
BOOST_AUTO_TEST_CASE(nothing_happens_at_size_two) {
  SphereLaplacian const laplacian(2);
  SkewHermitian<> const start = testing::random_state(2, 1, 1);
  for (auto const conserved :
       {Conserved::lie_poisson, Conserved::energy_casimir, Conserved::all_invariants}) {
    SkewHermitian<> w = start;
    VorticityStep<> step(laplacian, conserved, 0.2);
    for (int k = 0; k < 20; ++k) step.advance(w);
    BOOST_TEST(norm(w - start) <= 20 * 1e-15 * norm(start));
  }
}

BOOST_AUTO_TEST_CASE(something_happens_at_size_three) {
  SphereLaplacian const laplacian(3);
  SkewHermitian<> const start = testing::random_state(3, 1, 2);
  SkewHermitian<> w = start;
  VorticityStep<> step(laplacian, Conserved::lie_poisson, 0.2);
  for (int k = 0; k < 20; ++k) step.advance(w);
  BOOST_TEST(norm(w - start) > 0.1 * norm(start));
  testing::Changes const changes = testing::Invariants(laplacian, w) - testing::Invariants(laplacian, start);
  BOOST_TEST(changes.spectrum <= 1e-13);
  BOOST_TEST(changes.momentum <= 1e-13);
}

BOOST_AUTO_TEST_SUITE_END()
