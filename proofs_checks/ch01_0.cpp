// Chapter 1: the Moser-Veselov scheme is completely integrable.
//
// A step turns the body momentum M0 before it into M1 after it, and the next step starts with M1: what is the
// same at both for every relative motion is conserved by the scheme. So no motion has to be solved for, and
// all of it is exact over the rationals.
#include "actio/rigid_body/casimirs.hpp"
#include "actio/rigid_body/isospectral.hpp"
#include "actio/rigid_body/moser_veselov.hpp"
#include "actio/variational/lie_poisson.hpp"
#include "models/generalized_bodies.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

/// Half the dimension of a generic coadjoint orbit of so(n).
inline int half_leaf(int n) { return (n * (n - 1) / 2 - n / 2) / 2; }
/// The integrals of one determinant in one variable, \f$\det(1-\lambda M-\lambda^2\Lambda^2)\f$: sums of
/// those that share a power of \f$\lambda\f$.
template <class S>
Matrix<S> summed_by_power(Matrix<S> const& rows, int n) {
  auto const degrees = isospectral_degrees(n);
  Matrix<S> sums = Matrix<S>::Zero(2 * n + 1, rows.cols());
  for (std::size_t a = 0; a < degrees.size(); ++a)
    sums.row(degrees[a].momentum + 2 * degrees[a].inertia) += rows.row(a);
  return sums;
}
template <class S>
Matrix<S> tensor_at(Matrix<S> const& m) { return lie_poisson_tensor_plus(as_momentum(m)); }
/// \f$\det(1-\lambda M-\lambda^2\Lambda^2)\f$ by elimination: not through the library's recursion.
template <class S>
S determinant(Matrix<S> a) {
  S product(1);
  for (Index k = 0; k < a.rows(); ++k) {
    product *= a(k, k);
    for (Index i = k + 1; i < a.rows(); ++i) {
      S const factor = a(i, k) / a(k, k);
      for (Index j = k; j < a.cols(); ++j) a(i, j) -= factor * a(k, j);
    }
  }
  return product;
}

}  // namespace

STATEMENT(claim_1_0_moser_veselov_integrable,
          "complete integrability of the Moser-Veselov rigid body scheme") {
  claim.holds(
      "Counted on $\\SO(3)$, $\\SO(4)$, $\\SO(5)$: besides the Casimirs there are 1, 2 and 4 "
      "further integrals, half the dimension of a generic orbit, independent and in involution; "
      "the step is a Poisson map. The true energy is among them. The spectrum of the Lax matrix "
      "gives all; its determinant alone, a polynomial in one variable, gives $n-1$ with the "
      "Casimirs, too few from $n = 4$ on.");
  over_bodies(claim, [&](int n, auto const& model) {
    auto const lambda = draw_inertia<S>(draw, n);
    auto const f = draw_turn<S>(draw, n);
    Matrix<S> const m0 = before(lambda, f), m1 = after(lambda, f);
    auto const integrals = [&](auto const& mu) { return isospectral_integrals(lambda, mu); };
    auto const mu0 = as_momentum(m0), mu1 = as_momentum(m1);

    // A Lax pair: two factors, and the same two exchanged.
    S const at = ratio<S>(1, 4) + draw.template number<S>() * ratio<S>(1, 8);
    claim.equal("1 - lambda M0 - lambda^2 Lambda^2 in two factors", model, lax_matrix_before(lambda, f, at),
                lax_matrix(lambda, m0, at));
    claim.equal("the factors exchanged: M1", model, lax_matrix_after(lambda, f, at),
                lax_matrix(lambda, m1, at));
    claim.equal("its determinant", model, determinant<S>(lax_matrix(lambda, m1, at)),
                determinant<S>(lax_matrix(lambda, m0, at)));
    S sum(1);
    for (int i = 0; i < n; ++i) sum *= S(1) - at * at * lambda(i, i) * lambda(i, i);
    auto const degrees = isospectral_degrees(n);
    auto const values = integrals(mu0);
    for (std::size_t a = 0; a < degrees.size(); ++a) {
      S term = values[a];
      for (int power = 0; power < degrees[a].momentum + 2 * degrees[a].inertia; ++power) term *= at;
      sum += term;
    }
    claim.equal("the determinant is made of the integrals", model, sum,
                determinant<S>(lax_matrix(lambda, m0, at)));

    // Kept, and with them the energy.
    // Products of up to five matrices, each entry a sum of five: rounding adds up over some ten of them.
    double const products = 10;
    claim.equal("integrals before and after a step", model, integrals(mu1), values, products);
    Vector<S> const moments = moments_of(lambda);
    auto const energy = [&](auto const& mu) {
      using T = typename std::decay_t<decltype(mu)>::Scalar;
      Vector<T> sum = Vector<T>::Zero(1);
      for (Index a = 0; a < moments.size(); ++a)
        sum[0] += mu.components[a] * mu.components[a] * T(S(S(1) / (S(2) * moments[a])));
      return sum;
    };
    claim.equal("the true energy before and after a step", model, energy(mu1), energy(mu0), products);

    // In involution.
    auto const mu = momentum(Turns{n}, draw_turning<S>(draw, n).coordinates);
    Matrix<S> const tensor = lie_poisson_tensor_plus(mu), slopes = differentials(integrals, mu),
                    energy_slope = differentials(energy, mu);
    Base<S> const scale = size_of(slopes) * size_of(slopes);
    claim.zero("brackets of the integrals with each other", model,
               Matrix<S>(slopes * tensor * slopes.transpose()), S(scale), products);
    claim.zero("brackets of the integrals with the energy", model,
               Matrix<S>(slopes * tensor * energy_slope.transpose()), S(scale), products);
    for (std::size_t a = 0; a < degrees.size(); ++a)
      if (degrees[a].inertia == 0)
        claim.zero("those without Lambda^2 are Casimirs", model, Matrix<S>(slopes.row(a) * tensor), S(scale),
                   products);

    // Enough of them, and independent.
    claim.fact("how many: floor(n/2) Casimirs and half a generic orbit", model,
               static_cast<int>(degrees.size()) == n / 2 + half_leaf(n));
    if (exact_arithmetic<S>()) {
      claim.fact("independent", model, exact_rank(slopes) == n / 2 + half_leaf(n));
      claim.fact(
          "the energy depends on them", model,
          exact_rank((Matrix<S>(slopes.rows() + 1, slopes.cols()) << slopes, energy_slope).finished()) ==
              n / 2 + half_leaf(n));
      claim.fact("one determinant in one variable gives n - 1", model,
                 exact_rank(summed_by_power(slopes, n)) == n - 1);
    }

    // The step is a Poisson map: both momenta as functions of f.
    TraceLagrangian<S> const l{lambda};
    Matrix<S> const in = left_second_differential(l, f), out = right_second_differential(l, f);
    Matrix<S> const step =
        solve_linear(Matrix<S>(in.transpose()), Matrix<S>(out.transpose()), "a step as a map of momenta")
            .transpose();
    // The solve magnifies by the inverse of the derivative: measured by the size of the map.
    Base<S> const size = size_of(step);
    claim.zero("the step carries the Lie-Poisson bracket along", model,
               Matrix<S>(step * tensor_at(m0) * step.transpose() - tensor_at(m1)), S(size * size),
               products * n);

    // Controls: the integrals of another body; another discretisation of the same body, a Poisson map with
    // the same Casimirs. Lambda + 1 has the square Lambda^2 + 2 Lambda + 1, no function of the first degree
    // of Lambda^2.
    Matrix<S> const other = lambda + Matrix<S>::Identity(n, n);
    claim.differs("the integrals of another body", model, isospectral_integrals(other, mu1),
                  isospectral_integrals(other, mu0), 1e-5);
    claim.refutes(
        "in involution with those of another body", model,
        Matrix<S>(
            slopes * tensor *
            differentials([&](auto const& nu) { return isospectral_integrals(other, nu); }, mu).transpose()),
        S(scale), 1e-5);
    ChartLagrangian<S> const chart{Matrix<S>(moments.asDiagonal())};
    claim.differs("a step in Cayley's chart", model, integrals(right_differential(chart, f)),
                  integrals(left_differential(chart, f)), 1e-5);
  });
  // On the branch that grows out of the identity: the factors are told apart by their spectra, so the
  // spectrum of each is conserved, and with it the trace of f Lambda.
  if (!exact_arithmetic<S>())
    over_bodies(claim, [&](int n, auto const& model) {
      auto const lambda = draw_inertia<S>(draw, n);
      MoserVeselov<Dynamic, S> const scheme(inertia_from_lambda<Dynamic, S>(lambda.diagonal()),
                                            ratio<S>(1, 8));
      auto const f = scheme.relative_motion(momentum(Turns{n}, draw_turning<S>(draw, n).coordinates)).value,
                 next = scheme.step_euler_poincare(f).value;
      auto const spectrum = [&](Turn<S> const& at) {
        return characteristic_coefficients(Matrix<S>(at.value.transpose() * lambda));
      };
      claim.equal("on the branch of the identity: the spectrum of f^T Lambda", model, spectrum(next),
                  spectrum(f), 16);
      // The angle changes by a part of itself of the order of the step.
      claim.differs("the angle of f: Tr(1 - f)", model, S(S(n) - next.value.trace()),
                    S(S(n) - f.value.trace()), 1e-5);
    });
}
