// Scalars: rational (long: double)
// Section 8.2: the density of an incompressible medium, its momenta and what its Legendre transformation loses.
#include "incompressible_models.hpp"

#include "actio/foundations/rank.hpp"
#include "statement.hpp"

namespace {

using namespace actio;
using namespace actio::checks;

/// How the momenta \f$p_a{}^\mu, \pi^\mu\f$ change with \f$v^a{}_\mu, \beta_\mu\f$: column by column, mu slowest.
template <class S, int n, int M, class L>
Eigen::Matrix<S, M*(n + 1), M*(n + 1)> momentum_slopes(L const& density, Jet<S, n, M> const& j) {
  Eigen::Matrix<S, M*(n + 1), M*(n + 1)> slopes;
  for (int mu = 0; mu <= n; ++mu)
    for (int a = 0; a < M; ++a) {
      auto moved = j.template cast<Dual<S>>();
      moved.v(a, mu).part[0] = S(1);
      auto const p = momenta(density, moved);
      for (int nu = 0; nu <= n; ++nu)
        for (int b = 0; b < M; ++b) slopes(M * nu + b, M * mu + a) = p(b, nu).part[0];
    }
  return slopes;
}
/// The same without the derivatives of the multiplier and its momenta.
template <class S, int n, int M>
Eigen::Matrix<S, (M - 1)*(n + 1), (M - 1)*(n + 1)> of_the_motion(Eigen::Matrix<S, M*(n + 1), M*(n + 1)> const& slopes) {
  constexpr int N = M - 1;
  Eigen::Matrix<S, N*(n + 1), N*(n + 1)> block;
  for (int nu = 0; nu <= n; ++nu)
    for (int mu = 0; mu <= n; ++mu) block.template block<N, N>(N * nu, N * mu) = slopes.template block<N, N>(M * nu, M * mu);
  return block;
}

/// A density in which the multiplier has a velocity.
template <class L>
struct WithMovingMultiplier {
  L density;
  template <class S, int n, int M>
  S operator()(Jet<S, n, M> const& j) const {
    return density(j) + j.v(M - 1, 1) * j.v(M - 1, 1) / S(2);
  }
};

}  // namespace

STATEMENT(eq_8_3, "the density with the constraint added") {
  claim.convention("The multiplier adds to the density, where chapter 7 subtracts: with (8.2) this makes $P$ the pressure. $d^{n+1}x$ belongs to all three terms.");
  claim.degree(degree_of_fields);
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const medium = draw_medium<S, n>(draw);
    auto const density = incompressible(medium);
    auto const phi = draw_section<S, n, n>(draw);
    Jet<S, n, n + 1> const j = draw_extended_jet<S, n>(draw, phi, medium.G);
    Eigen::Matrix<S, n, 1> const x = j.particle(), y = j.y.template head<n>(), v = j.velocity().template head<n>();
    Eigen::Matrix<S, n, n> const G = medium.G(x), g = medium.g(y), F = j.gradient().template topRows<n>();
    // K, P and Phi from metrics as frames have them: roots of determinants are determinants of frames.
    S const root_G = determinant(medium.G.frame(x)), root_g = determinant(medium.g.frame(y)), rho = medium.rho(x);
    S const kinetic = root_G * rho * (v.transpose() * (g * v).eval())(0, 0) / S(2), potential = root_G * rho * medium.W(x, G, g, F);
    S const Phi = determinant(F) * root_g / root_G - S(1);
    claim.equal("kinetic minus potential plus multiplier times constraint", model, density(j), S(kinetic - potential + j.y[n] * Phi));
    claim.differs("the multiplier subtracted", model, density(j), S(kinetic - potential - j.y[n] * Phi));
  });
}

STATEMENT(claim_8_2_multiplier_momentum, "the momentum of the multiplier") {
  claim.holds();
  claim.degree(degree_of_fields);
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const medium = draw_medium<S, n>(draw);
    auto const density = incompressible(medium);
    Jet<S, n, n + 1> const j = draw_extended_jet<S, n>(draw, draw_section<S, n, n>(draw), medium.G);
    auto const p = momenta(density, j);
    claim.zero("momentum of the multiplier", model, p.row(n).eval(), size_of(p));
    claim.refutes("a density with a velocity of the multiplier", model, momenta(WithMovingMultiplier<decltype(density)>{density}, j).row(n).eval(), S(1));
  });
}

STATEMENT(claim_8_2_restricted_legendre, "what is left of the Legendre transformation") {
  claim.corrected("\\text{restricted to }\\{\\pi^\\mu = 0\\}\\text{ it is non-degenerate}", "\\ker T\\mathbb{F}\\mathcal L_\\Phi \\supseteq \\mathrm{span}(\\partial/\\partial\\beta_\\mu)",
                  "Restricting the target, all momenta $p$ nearby are reached where $\\partial^2L_\\Phi/\\partial v\\partial v$ is invertible, and $\\Pi$ is determined by them, but derivatives of $\\lambda$ stay in its kernel. "
                  "The matrix is not always invertible: without stored energy it needs $P \\ne 0$.");
  claim.degree(degree_of_fields);
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const medium = draw_medium<S, n>(draw);
    auto const density = incompressible(medium);
    Jet<S, n, n + 1> j = draw_extended_jet<S, n>(draw, draw_section<S, n, n>(draw), medium.G);
    auto const slopes = momentum_slopes(density, j);
    for (int mu = 0; mu <= n; ++mu) claim.zero("derivatives of the multiplier move no momentum", model, slopes.col((n + 1) * mu + n).eval(), size_of(slopes));
    claim.fact("the momenta of the motion reach everything", model, matrix_rank(of_the_motion<S, n, n + 1>(slopes)) == n * (n + 1));

    auto const fluid = incompressible(ideal_fluid<S, n>(medium.G, medium.g));
    claim.fact("so they do without stored energy under pressure", model, matrix_rank(of_the_motion<S, n, n + 1>(momentum_slopes(fluid, j))) == n * (n + 1));
    j.y[n] = S(0);
    auto const at_rest = of_the_motion<S, n, n + 1>(momentum_slopes(fluid, j));
    claim.fact("without energy and pressure only velocities count", model, matrix_rank(at_rest) == n);
    claim.refutes("rank of the whole map, over that of a non-degenerate one", model, S(S(matrix_rank(slopes)) / S((n + 1) * (n + 1)) - S(1)), S(1));
  });
}

STATEMENT(eq_8_4, "the momenta of an incompressible medium") {
  claim.holds();
  claim.degree(degree_of_fields);
  over_points(TwoAndThree{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const medium = draw_medium<S, n>(draw);
    auto const density = incompressible(medium);
    Jet<S, n, n + 1> const j = draw_extended_jet<S, n>(draw, draw_section<S, n, n>(draw), medium.G);
    auto const z = incompressible_momenta(density, j);
    auto const p = momenta(density, j);
    claim.equal("momenta", model, p, z.p);
    // The pressure's part of the space momenta, transposed or with the other sign.
    auto const below = deformation(j);
    S const factor = j.y[n] * density.constraint.volume_ratio(below);
    Eigen::Matrix<S, n, n> const inverse = inverse_matrix(below.gradient());
    Eigen::Matrix<S, n, n> const space = p.template topRows<n>().template rightCols<n>();
    claim.differs("the inverse not transposed", model, space, (space + factor * (inverse - inverse.transpose())).eval());
    claim.differs("the pressure with the other sign", model, space, (space - S(2) * factor * inverse.transpose()).eval());
  });
}

STATEMENT(claim_8_2_affine_momentum, "the affine momentum of an incompressible medium") {
  claim.holds();
  claim.degree(degree_of_fields);
  over_points(TwoAndThree{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const medium = draw_medium<S, n>(draw);
    auto const density = incompressible(medium);
    Jet<S, n, n + 1> const j = draw_extended_jet<S, n>(draw, draw_section<S, n, n>(draw), medium.G);
    S const Pi = legendre(density, j).Pi, closed = incompressible_momenta(density, j).Pi, J = density.constraint.volume_ratio(deformation(j));
    // Pi is the difference of the density and a sum of n^2 products of momenta and velocities.
    S const terms = size_of(momenta(density, j)) * size_of(j.v) * S(n * n);
    claim.zero("Pi with the pressure P(J(n-1) + 1)", model, S(Pi - closed), terms);
    claim.refutes("with P(Jn + 1)", model, S(Pi - (closed - j.y[n] * J)), terms);
    claim.refutes("with Pn, as if J were 1", model, S(Pi - (closed + j.y[n] * (J * S(n - 1) + S(1) - S(n)))), terms);
  });
}
