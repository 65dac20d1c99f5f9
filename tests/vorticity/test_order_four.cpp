// Steps of order 4: diagonally implicit Runge-Kutta methods are compositions, every form is of order 4 when
// composed, and the projection along the orbit leaves it so.
//
// In a unit of its own, which is as large as a unit may be.
#include <Eigen/Core>

#include <boost/test/unit_test.hpp>

#include "actio/vorticity/diagonal_runge_kutta.hpp"
#include "actio/vorticity/orbit_projection.hpp"
#include "caught.hpp"
#include "flows.hpp"
#include "refused.hpp"

using namespace actio;
using namespace actio::sphere;
using testing::random_state, testing::RossbyHaurwitz, testing::Invariants;

namespace {

constexpr double unit = 0x1p-53;  // the unit round-off
constexpr Conserved forms[] = {Conserved::lie_poisson, Conserved::energy_casimir, Conserved::all_invariants};
char const* const names[] = {"lie_poisson", "energy_casimir", "all_invariants"};

/// A Runge-Kutta method as it is printed: any tableau, all stages at once.
struct Tableau {
  Eigen::MatrixXd a;
  std::vector<double> b;
};

/// One step of it for dg/dt = (P/hbar) g from g = 1, P being that of g W g^*. Its equations are iterated.
ComplexMatrix<> lifted_step(SphereLaplacian const& laplacian, Tableau const& method, double h,
                            SkewHermitian<> const& w) {
  int const n = laplacian.size();
  auto const stages = method.b.size();
  ComplexMatrix<> const one = ComplexMatrix<>::Identity(n, n), start = w.complex();
  auto const slope = [&](ComplexMatrix<> const& g) -> ComplexMatrix<> {
    SkewHermitian<> const here(ComplexMatrix<>(g * start * g.adjoint()));
    return laplacian.solve(here).complex() * g / QuantizedSphere(n).hbar();
  };
  std::vector<ComplexMatrix<>> k(stages, slope(one));
  double moved = 1;
  for (int round = 0; round < 200 && moved > unit; ++round) {
    moved = 0;
    for (std::size_t i = 0; i < stages; ++i) {
      ComplexMatrix<> g = one;
      for (std::size_t j = 0; j < stages; ++j)
        g += h * method.a(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) * k[j];
      ComplexMatrix<> const next = slope(g);
      moved = std::max(moved, h * (next - k[i]).norm());
      k[i] = next;
    }
  }
  BOOST_TEST(moved <= 8 * unit);
  ComplexMatrix<> g = one;
  for (std::size_t i = 0; i < stages; ++i) g += h * method.b[i] * k[i];
  return g;
}

/// Its W, and how far it is from unitary.
struct Lifted {
  SkewHermitian<> w;
  double not_unitary;
};
Lifted lifted(SphereLaplacian const& laplacian, Tableau const& method, double h, SkewHermitian<> const& w) {
  ComplexMatrix<> const g = lifted_step(laplacian, method, h, w);
  return {SkewHermitian<>(ComplexMatrix<>(g * w.complex() * g.adjoint())),
          (g * g.adjoint() - ComplexMatrix<>::Identity(g.rows(), g.cols())).norm()};
}

/// A run of a composition, with the projection after each step or without, turned back at the end.
SkewHermitian<> run(SphereLaplacian const& laplacian, Conserved form, std::vector<double> const& weights,
                    double time, int steps, TurningFrame const& frame, SkewHermitian<> w, bool projected) {
  ComposedVorticityStep<> step(laplacian, form, time / steps, weights, frame);
  OrbitProjection<> projection(laplacian);
  EnergyMomentum const levels = energy_momentum(laplacian, w);
  for (int k = 0; k < steps; ++k) {
    step.advance(w);
    if (projected) projection.project(levels, w);
  }
  return frame.rate == 0 ? w : Turning(QuantizedSphere(laplacian.size()), frame.axis)(frame.rate * time, w);
}

/// The end of a flow, by order 6, which has errors of other kinds, in `steps` steps.
SkewHermitian<> end_of_flow(SphereLaplacian const& laplacian, double time, int steps,
                            TurningFrame const& frame, SkewHermitian<> const& start) {
  return run(laplacian, Conserved::lie_poisson, kahan_li<double>(), time, steps, frame, start, false);
}

struct Measured {
  testing::Line order;
  std::vector<double> errors;
  SkewHermitian<> end;  ///< of the run with the most steps
};
/// The order against a known end, with steps that are halved from the coarsest on.
Measured measured_order(SkewHermitian<> const& truth, SphereLaplacian const& laplacian, Conserved form,
                        std::vector<double> const& weights, double time, std::vector<int> const& counts,
                        TurningFrame const& frame, SkewHermitian<> const& start, bool projected) {
  Measured out;
  std::vector<double> lengths;
  for (int const count : counts) {
    lengths.push_back(time / count);
    out.end = run(laplacian, form, weights, time, count, frame, start, projected);
    out.errors.push_back(norm(out.end - truth) / norm(truth));
  }
  out.order = testing::order_of(lengths, out.errors);
  return out;
}

/// What a form conserves, the projected ones all of it, to the figure that is promised.
void conserves(Conserved form, bool projected, testing::Changes const& changes) {
  BOOST_TEST(changes.spectrum <= 1e-12);
  if (projected || form != Conserved::lie_poisson) BOOST_TEST(changes.energy <= 1e-12);
  if (projected || form != Conserved::energy_casimir) BOOST_TEST(changes.momentum <= 1e-12);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(order_four)

BOOST_AUTO_TEST_CASE(a_symplectic_triangular_tableau_is_made_of_its_weights) {
  for (auto const& b : {triple_jump<double>(), suzuki<double>(), mclachlan(), std::vector{0.7, -0.4, 0.7}}) {
    Eigen::MatrixXd const a = diagonal_tableau(b);
    for (int i = 0; i < a.rows(); ++i)
      for (int j = 0; j < a.cols(); ++j) {
        BOOST_TEST(b[i] * a(i, j) + b[j] * a(j, i) - b[i] * b[j] == 0);
        if (j > i) BOOST_TEST(a(i, j) == 0);
      }
  }
}

// As Carvalho da Silva and Lessig have them: solved as a Runge-Kutta method on the group, by another code.
BOOST_AUTO_TEST_CASE(symplectic_diagonal_methods_are_compositions_of_lie_poisson_steps) {
  for (int n : {3, 6}) {
    SphereLaplacian const laplacian(n);
    SkewHermitian<> const start = random_state(n, 1, n - 1, 4);
    double const h = 0.3;
    for (auto const& b :
         {triple_jump<double>(), suzuki<double>(), mclachlan(), std::vector{0.2, 0.5, -0.1, 0.4}}) {
      Tableau method{diagonal_tableau(b), b};
      Lifted const by_stages = lifted(laplacian, method, h, start);
      SkewHermitian<> composed = start;
      ComposedVorticityStep<>(laplacian, Conserved::lie_poisson, h, b).advance(composed);
      // Some ten roundings of sums of N terms in each stage, on both ways.
      double const bound = 20 * unit * n * static_cast<double>(b.size());
      BOOST_TEST(norm(by_stages.w - start) > 1e-2 * norm(start));
      BOOST_TEST(norm(by_stages.w - composed) <= bound * norm(start));
      BOOST_TEST(by_stages.not_unitary <= bound);
      // Another tableau with these weights is neither symplectic nor a composition.
      method.a(1, 0) *= 1.01;
      Lifted const other = lifted(laplacian, method, h, start);
      BOOST_TEST(norm(other.w - composed) > 1e-6 * norm(start));
      BOOST_TEST(other.not_unitary > 1e-6);
    }
  }
}

BOOST_AUTO_TEST_CASE(palindromes_of_five_stages_are_of_order_four) {
  double const suzukis = suzuki<double>()[0];
  for (double first : {-0.5, 0.1, 0.28, suzukis, 0.7, 1.3}) {
    auto const b = five_stages(first);
    auto const conditions = composition_conditions(b);
    double cubes = 0;
    for (double const x : b) cubes += std::abs(x * x * x);
    BOOST_TEST(std::abs(conditions[0]) <= 16 * unit * (1 + std::abs(b[1])));
    BOOST_TEST(std::abs(conditions[1]) <= 64 * unit * cubes);
    BOOST_TEST((b[0] == b[4] && b[1] == b[3]));
  }
  for (int k = 0; k < 5; ++k)
    BOOST_TEST(std::abs(five_stages(suzukis)[k] - suzuki<double>()[k]) <= 16 * unit);
  // As McLachlan prints it.
  BOOST_TEST(std::abs(mclachlan()[1] - 0.62546642846767004501) <= 4 * unit);
  // Of all of them Suzuki's has the least error in A_5.
  double const least = std::abs(composition_error(suzuki<double>()).fifth);
  for (double first = -1; first < 1.35; first += 0.01)
    BOOST_TEST(std::abs(composition_error(five_stages(first)).fifth) >= (1 - 1e-12) * least);
  double const jump = triple_jump<double>()[0], nan = std::numeric_limits<double>::quiet_NaN();
  for (double bad : {jump, 2.0}) CHECK_REFUSED(five_stages(bad), OutsideDomain);
  CHECK_REFUSED(five_stages(nan), NotFinite);
}

// Two compositions determine the fields A_5 and [A_1, [A_1, A_3]]; the error of a third is then known, up to
// the square of the step.
BOOST_AUTO_TEST_CASE(the_error_of_a_step_is_made_of_two_constants) {
  int const n = 6;
  SphereLaplacian const laplacian(n);
  SkewHermitian<> const start = random_state(n, 1, n - 1, 4);
  auto const deviation = [&](double h, double of_nested) {
    SkewHermitian<> const truth = end_of_flow(laplacian, h, 16, {}, start);
    auto const error = [&](std::vector<double> const& b) {
      return run(laplacian, Conserved::lie_poisson, b, h, 1, {}, start, false) - truth;
    };
    // The three differ much in the second constant.
    auto const one = five_stages(0.5), two = mclachlan(), third = suzuki<double>();
    auto const [p5, p113] = composition_error(one);
    auto const [q5, q113] = composition_error(two);
    auto const [r5, r113] = composition_error(third);
    SkewHermitian<> const p = error(one), q = error(two), r = error(third);
    double const d = p5 * q113 - q5 * p113;
    SkewHermitian<> const fifth = (1 / d) * (q113 * p - p113 * q), nested = (1 / d) * (p5 * q - q5 * p);
    BOOST_TEST_MESSAGE("h = " << h << ": A_5 " << norm(fifth) << ", nested " << norm(nested));
    return norm(r5 * fifth + (of_nested * r113) * nested - r) / norm(r);
  };
  double const coarse = deviation(0.1, 1), fine = deviation(0.05, 1);
  BOOST_TEST_MESSAGE("two constants: " << coarse << ", " << fine);
  BOOST_TEST(fine <= 0.05);
  BOOST_TEST(std::abs(coarse / fine - 4) <= 1);
  // With the wrong sign of one of them it is not known.
  BOOST_TEST(deviation(0.05, -1) > 4 * fine);
}

BOOST_AUTO_TEST_CASE(every_form_is_of_order_four) {
  int const n = 10;
  QuantizedSphere const sphere(n);
  SphereLaplacian const laplacian(n);
  SkewHermitian<> const start = random_state(n, 1, n - 1, 2);
  double const time = 1;
  TurningFrame const calm = calmest_frame(sphere, laplacian, start);
  SkewHermitian<> const truth = end_of_flow(laplacian, time, 100, {}, start);
  BOOST_TEST(norm(truth - start) > 0.1 * norm(start));
  for (TurningFrame const& frame : {TurningFrame{}, calm})
    for (int f = 0; f < 3; ++f)
      for (auto const& b : {triple_jump<double>(), suzuki<double>(), mclachlan()})
        for (bool projected : {false, true}) {
          if (projected && forms[f] == Conserved::all_invariants) continue;
          std::vector<int> const counts =
              b.size() == 3 ? std::vector{24, 36, 54, 81} : std::vector{12, 18, 27, 40};
          auto const [order, errors, end] =
              measured_order(truth, laplacian, forms[f], b, time, counts, frame, start, projected);
          BOOST_TEST_MESSAGE(names[f] << (projected ? ", projected, " : ", ") << b.size() << " stages: order "
                                      << order.slope << " +- " << order.error << ", errors " << errors.front()
                                      << " to " << errors.back());
          BOOST_TEST(std::abs(order.slope - 4) <= 0.1);
          // The last error is the scheme's: 200 substeps round by some 1e-15 together.
          BOOST_TEST(errors.back() > 5e-13);
        }
}

// In the frame of the wave its neighbours hardly move; the error is that of the perturbation.
BOOST_AUTO_TEST_CASE(near_equilibria_every_form_is_of_order_four) {
  int const n = 10;
  QuantizedSphere const sphere(n);
  SphereLaplacian const laplacian(n);
  double const time = 24;
  for (double perturbation : {1e-6, 1e-4, 1e-2, 1e-1}) {
    SkewHermitian<> const start = RossbyHaurwitz{}.state(n) + perturbation * random_state(n, 1, n - 1, 9);
    TurningFrame const frame = calmest_frame(sphere, laplacian, start);
    // Of a form that has the wave itself without an error.
    SkewHermitian<> const truth =
        run(laplacian, Conserved::energy_casimir, kahan_li<double>(), time, 60, frame, start, false);
    for (int f = 0; f < 3; ++f)
      for (bool projected : {false, true}) {
        if (projected && forms[f] == Conserved::all_invariants) continue;
        // The Lie-Poisson form moves the wave itself, and has shorter steps to show its order.
        std::vector<int> const counts = f == 0 ? std::vector{24, 36, 54, 81} : std::vector{16, 24, 36, 54};
        auto const [order, errors, end] = measured_order(truth, laplacian, forms[f], suzuki<double>(), time,
                                                         counts, frame, start, projected);
        testing::Changes const changes = Invariants(laplacian, end) - Invariants(laplacian, start);
        BOOST_TEST_MESSAGE("wave + " << perturbation << ", " << names[f] << (projected ? ", projected" : "")
                                     << ": order " << order.slope << " +- " << order.error << ", errors "
                                     << errors.front() << " to " << errors.back() << "; energy "
                                     << changes.energy << ", momentum " << changes.momentum << ", spectrum "
                                     << changes.spectrum);
        BOOST_TEST(std::abs(order.slope - 4) <= 0.1);
        conserves(forms[f], projected, changes);
      }
  }
}

BOOST_AUTO_TEST_CASE(a_composition_that_cannot_be_made_leaves_the_state) {
  int const n = 12;
  SphereLaplacian const laplacian(n);
  SkewHermitian<> const start = random_state(n, 1, 9);
  SkewHermitian<> w = start;
  // The first substep can be made, the second cannot.
  double const longer = 1e3;
  std::vector<double> const uneven{1e-4, 1 - 1e-4};
  ComposedVorticityStep<> step(laplacian, Conserved::all_invariants, longer, uneven);
  auto const error = testing::caught<NotContracting>([&] { step.advance(w); });
  double const named = error.largest;
  BOOST_TEST(error.step == longer);
  BOOST_TEST(norm(w - start) == 0);
  BOOST_TEST((named > 0 && named < longer));
  BOOST_CHECK_NO_THROW(
      ComposedVorticityStep<>(laplacian, Conserved::all_invariants, named / 2, uneven).advance(w));
  using Composed = ComposedVorticityStep<>;
  auto const made = [&](std::vector<double> b) { Composed(laplacian, forms[0], 0.1, std::move(b)); };
  CHECK_REFUSED(made({}), OutsideDomain);
  CHECK_REFUSED(made({0.5, 0.6}), OutsideDomain);
  CHECK_REFUSED(made({0.5, 0, 0.5}), OutsideDomain);
  CHECK_REFUSED(made({0.5, std::numeric_limits<double>::infinity()}), NotFinite);
}

BOOST_AUTO_TEST_SUITE_END()
