// Section 8.2: the density of an incompressible medium, its momenta and what its Legendre transformation
// loses.

#include "actio/linear_algebra/rank.hpp"

#include "fields/incompressible_models.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

/// How the momenta \f$p_a{}^\mu, \pi^\mu\f$ change with \f$v^a{}_\mu, \beta_\mu\f$: column by column, mu
/// slowest.
template <class S, int n, int M, class L>
Matrix<S, M*(n + 1), M*(n + 1)> momentum_slopes(L const& density, Jet<S, n, M> const& j) {
  Matrix<S, M*(n + 1), M*(n + 1)> slopes;
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
Matrix<S, (M - 1) * (n + 1), (M - 1) * (n + 1)> of_the_motion(Matrix<S, M*(n + 1), M*(n + 1)> const& slopes) {
  constexpr int N = M - 1;
  Matrix<S, N*(n + 1), N*(n + 1)> block;
  for (int nu = 0; nu <= n; ++nu)
    for (int mu = 0; mu <= n; ++mu)
      block.template block<N, N>(N * nu, N * mu) = slopes.template block<N, N>(M * nu, M * mu);
  return block;
}

/// A density in which the multiplier has a velocity.
template <class L>
struct WithMovingMultiplier {
  L density;
  template <class S, int n, int M>
  S operator()(Jet<S, n, M> const& j) const { return density(j) + j.v(M - 1, 1) * j.v(M - 1, 1) / S(2); }
};

}  // namespace

STATEMENT(eq_8_3, "the density with the constraint added") {
  claim.convention(
      "The multiplier adds to the density, where chapter 7 subtracts: with (8.2) this makes $P$ the "
      "pressure. $\\mathbb K$ and $\\mathbb P$ are forms, as in (6.3), and contain their $d^{n+1}x$.");
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    auto const medium = draw_medium<S, n>(draw);
    auto const density = incompressible(medium);
    auto const phi = draw_section<S, n, n>(draw);
    Jet<S, n, n + 1> const j = draw_extended_jet<S, n>(draw, phi, medium.G);
    Matrix<S, n, 1> const x = j.particle(), y = j.y.template head<n>(), v = j.velocity().template head<n>();
    Matrix<S, n, n> const G = medium.G(x), g = medium.g(y), F = j.gradient().template topRows<n>();
    // K, P and Phi from metrics as frames have them: roots of determinants are determinants of frames.
    S const root_G = modulus(S(determinant(medium.G.frame(x)))),
            root_g = modulus(S(determinant(medium.g.frame(y)))), rho = medium.rho(x);
    S const kinetic = root_G * rho * (v.transpose() * (g * v).eval())(0, 0) / S(2),
            potential = root_G * rho * medium.W(x, G, g, F);
    S const Phi = determinant(F) * root_g / root_G - S(1);
    claim.equal("kinetic minus potential plus multiplier times constraint", model, density(j),
                S(kinetic - potential + j.y[n] * Phi));
    claim.differs("the multiplier subtracted", model, density(j), S(kinetic - potential - j.y[n] * Phi));
    claim.refutes("the pressure in the multiplier's place", model,
                  S(density(j) - (kinetic - potential + j.y[n] / root_G * Phi)), size_of(S(j.y[n] * Phi)));
  });
}

STATEMENT(claim_8_2_multiplier_momentum, "the momentum of the multiplier") {
  claim.holds();
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    auto const medium = draw_medium<S, n>(draw);
    auto const density = incompressible(medium);
    Jet<S, n, n + 1> const j = draw_extended_jet<S, n>(draw, draw_section<S, n, n>(draw), medium.G);
    auto const p = momenta(density, j);
    claim.zero("momentum of the multiplier", model, p.row(n).eval(), size_of(p));
    claim.refutes("a density with a velocity of the multiplier", model,
                  momenta(WithMovingMultiplier<decltype(density)>{density}, j).row(n).eval(), S(1));
  });
}

STATEMENT(claim_8_2_restricted_legendre, "the Legendre transformation with its target restricted") {
  claim.corrected(
      "\\text{restricted to }\\{\\pi^\\mu = 0\\}\\text{ it is non-degenerate}",
      "\\ker T\\mathbb{F}\\mathcal L_\\Phi \\supseteq \\mathrm{span}(\\partial/\\partial\\beta_\\mu)",
      "Restricting the target, all momenta $p$ nearby are reached where $\\partial^2L_\\Phi/\\partial "
      "v\\partial v$ is invertible, and $\\Pi$ is determined by them, but derivatives of $\\lambda$ stay "
      "in its kernel. The matrix is not always invertible: without stored energy it needs $P \\ne 0$.");
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    auto const medium = draw_medium<S, n>(draw);
    auto const density = incompressible(medium);
    Jet<S, n, n + 1> j = draw_extended_jet<S, n>(draw, draw_section<S, n, n>(draw), medium.G);
    auto const slopes = momentum_slopes(density, j);
    for (int mu = 0; mu <= n; ++mu)
      claim.zero("derivatives of the multiplier move no momentum", model, slopes.col((n + 1) * mu + n).eval(),
                 size_of(slopes));
    claim.fact("the momenta of the motion reach everything", model,
               matrix_rank(of_the_motion<S, n, n + 1>(slopes)) == n * (n + 1));

    auto const fluid = incompressible(ideal_fluid<S, n>(medium.G, medium.g));
    claim.fact("so they do without stored energy under pressure", model,
               matrix_rank(of_the_motion<S, n, n + 1>(momentum_slopes(fluid, j))) == n * (n + 1));
    j.y[n] = S(0);
    auto const at_rest = of_the_motion<S, n, n + 1>(momentum_slopes(fluid, j));
    claim.fact("without energy and pressure only velocities count", model, matrix_rank(at_rest) == n);
    auto const moving = momentum_slopes(WithMovingMultiplier<decltype(density)>{density}, j);
    claim.refutes("the same with a velocity of the multiplier", model, moving.col(n + 1 + n).eval(), S(1));
  });
}

STATEMENT(eq_8_4, "the momenta of an incompressible medium") {
  claim.holds();
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    auto const medium = draw_medium<S, n>(draw);
    auto const density = incompressible(medium);
    Jet<S, n, n + 1> const j = draw_extended_jet<S, n>(draw, draw_section<S, n, n>(draw), medium.G);
    auto const z = incompressible_momenta(density, j);
    auto const p = momenta(density, j);
    claim.equal("momenta", model, p, z.p);
    // The pressure's part of the space momenta, transposed or with the other sign.
    auto const below = deformation(j);
    S const factor = j.y[n] * density.constraint.volume_ratio(below);
    Matrix<S, n, n> const inverse = inverse_matrix(below.gradient());
    Matrix<S, n, n> const space = p.template topRows<n>().template rightCols<n>();
    claim.differs("the inverse not transposed", model, space,
                  (space + factor * (inverse - inverse.transpose())).eval());
    claim.differs("the pressure with the other sign", model, space,
                  (space - S(2) * factor * inverse.transpose()).eval());
  });
}

STATEMENT(claim_8_2_affine_momentum, "the affine momentum of an incompressible medium") {
  claim.holds();
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    auto const medium = draw_medium<S, n>(draw);
    auto const density = incompressible(medium);
    Jet<S, n, n + 1> const j = draw_extended_jet<S, n>(draw, draw_section<S, n, n>(draw), medium.G);
    S const Pi = legendre(density, j).Pi, closed = incompressible_momenta(density, j).Pi,
            J = density.constraint.volume_ratio(deformation(j));
    // Pi is the difference of the density and a sum of n^2 products of momenta and velocities.
    S const terms = size_of(momenta(density, j)) * size_of(j.v) * S(n * n);
    claim.zero("Pi with the pressure P(J(n-1) + 1)", model, S(Pi - closed), terms);
    claim.refutes("with P(Jn + 1)", model, S(Pi - (closed - j.y[n] * J)), terms);
    claim.refutes("with Pn, as if J were 1", model, S(Pi - (closed + j.y[n] * (J * S(n - 1) + S(1) - S(n)))),
                  terms);
  });
}

// ----
// Section 8.2: the field equations of an incompressible medium.

namespace {

/// The rate at which the density changes along a section that moves as V, and the rate
/// \f$D_\mu(p_a{}^\mu V^a)\f$ at which the momenta carry the change away.
template <class S>
struct Variation {
  S of_density, carried_away;
};
template <class L, class Phi, class V, class S, int rows>
Variation<S> variation(L const& density, Phi const& phi, V const& field, Matrix<S, rows, 1> const& x) {
  auto const j = first_jet(phi, x);
  auto const change = first_jet(field, x);
  auto moved = j.template cast<Dual<S>>();
  for (int a = 0; a < j.y.size(); ++a) {
    moved.y[a].part[0] = change.y[a];
    for (int mu = 0; mu < rows; ++mu) moved.v(a, mu).part[0] = change.v(a, mu);
  }
  Variation<S> out{density(moved).part[0], S(0)};
  auto const jet = second_jet(phi, x);
  for (int mu = 0; mu < rows; ++mu) {
    auto const p = partial_v(density, along(jet, mu), mu);
    for (int a = 0; a < j.y.size(); ++a)
      out.carried_away += p[a].part[0] * change.y[a] + p[a].value * change.v(a, mu);
  }
  return out;
}

/// A density in which the multiplier is squared.
template <class L>
struct WithSquaredMultiplier {
  L density;
  template <class S, int n, int M>
  S operator()(Jet<S, n, M> const& j) const { return density(j) + j.y[M - 1] * j.y[M - 1] / S(2); }
};

}  // namespace

STATEMENT(eq_8_5, "the field equations of the motion in the extended bundle") {
  claim.holds();
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    auto const density = incompressible(draw_medium<S, n>(draw));
    auto const phi =
        with_pressure(draw_section<S, n, n>(draw), draw_cubic<S, n + 1>(draw), density.constraint.G);
    // Places are varied, the multiplier is not.
    auto const change = draw_section<S, n, n + 1>(draw);
    auto const of_places = [&](auto const& x) {
      auto V = change(x);
      V[n] = ScalarOf<decltype(x)>(0);
      return V;
    };
    Event<S, n> const x = draw_event<S, n>(draw);
    auto const E = euler_lagrange(density, phi, x);
    auto const rates = variation(density, phi, of_places, x);
    S const left = E.dot(of_places(x)), scale = size_of(rates.of_density) + size_of(rates.carried_away);
    claim.zero("variation of the action, but for a divergence", model,
               S(rates.of_density - rates.carried_away - left), scale);
    claim.refutes("the divergence with the other sign", model,
                  S(rates.of_density + rates.carried_away - left), scale);
  });
}

STATEMENT(eq_8_6, "the field equation of the multiplier") {
  claim.corrected(
      "\\frac{\\partial L_\\Phi}{\\partial\\lambda} - \\frac{\\partial}{\\partial x^\\mu}\\frac{\\partial "
      "L_\\Phi}{\\partial\\beta_\\mu} = \\Phi\\,d^{n+1}x",
      "\\frac{\\partial L_\\Phi}{\\partial\\lambda} - \\frac{\\partial}{\\partial x^\\mu}\\frac{\\partial "
      "L_\\Phi}{\\partial\\beta_\\mu} = \\Phi = J - 1",
      "A slip of the pen: the left side is a number, the same in every chart of the body, because the "
      "multiplier is a density; the coefficient of a form $d^{n+1}x$ would change with the chart. The "
      "equation of $\\lambda$ is $\\Phi(j^1\\phi) = 0$ either way.");
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    auto const medium = draw_medium<S, n>(draw);
    auto const density = incompressible(medium);
    auto const phi = draw_section<S, n, n>(draw);
    auto const P = draw_cubic<S, n + 1>(draw);
    ChartOfSpaceTime<S, n> const chi{draw_chart<S, n>(draw)};
    Event<S, n> const x = draw_event<S, n>(draw);
    auto const j = second_jet(with_pressure(phi, P, medium.G), chi(x));
    S const Phi = density.constraint(deformation(static_cast<Jet<S, n, n + 1> const&>(j)))[0],
            E = euler_lagrange(density, j)[n];
    claim.equal("the last Euler-Lagrange derivative is J - 1", model, E, Phi);
    claim.differs("with a square of the multiplier", model,
                  euler_lagrange(WithSquaredMultiplier<decltype(density)>{density}, j)[n], Phi);
    // The same body in the chart x = chi(x').
    using InChart = PulledBack<MetricOfVolume<S, n>, Chart<S, n>>;
    AugmentedDensity const there{
        Continuum{InChart{medium.G, chi.chi}, medium.g, Homogeneous<S>{S(1)}, NoStoredEnergy{}},
        VolumeConstraint{InChart{medium.G, chi.chi}, medium.g}};
    auto const in_chart =
        second_jet(with_pressure([&](auto const& at) { return phi(chi(at)); },
                                 [&](auto const& at) { return P(chi(at)); }, there.constraint.G),
                   x);
    S const root = chi.chi.root(Matrix<S, n, 1>(x.template tail<n>()));
    claim.equal("in another chart of the body", model, euler_lagrange(there, in_chart)[n], E);
    claim.differs("printed: as the coefficient of a form", model, euler_lagrange(there, in_chart)[n],
                  S(E * root * root));
    auto const ideal = incompressible(
        ideal_fluid<S, n>(draw_metric_of_volume<S, n>(draw), draw_metric_of_volume<S, n>(draw)));
    auto const held = draw_shears<S, n>(draw, ideal.constraint.G.chart, ideal.constraint.g.chart);
    claim.zero("for motions that keep the volume", model,
               euler_lagrange(ideal, draw_extended_jet<S, n>(draw, held, ideal.constraint.G))[n], S(1));
    claim.refutes(
        "for those that keep the volume of coordinates", model,
        euler_lagrange(ideal, draw_extended_jet<S, n>(draw, of_coordinates(held), ideal.constraint.G))[n],
        S(1));
  });
}

STATEMENT(eq_8_7, "the equation of motion with stored energy and pressure") {
  claim.holds(
      "It holds off the constraint too: the Euler-Lagrange derivative is "
      "$-\\sqrt{\\det G}$ times it for every $J$.");
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    auto const density = incompressible(draw_medium<S, n>(draw));
    auto const j = draw_extended_jet<S, n>(draw, draw_section<S, n, n>(draw), density.constraint.G);
    auto const forces = per_volume(density, j);
    auto const pressure = pressure_term(density.density.G, density.density.g, j);
    claim.equal("(8.7) and the Euler-Lagrange derivative", model, motion_residual(density, j), forces);
    claim.differs("the pressure with the other sign", model,
                  (motion_residual(density, j) - S(2) * pressure).eval(), forces);
    claim.differs(
        "without J", model,
        (motion_residual(density, j) - pressure + spatial_pressure_gradient(density.density.G, j)).eval(),
        forces);
  });
}

STATEMENT(claim_8_2_metric_terms_cancel, "the terms in which the metric of space is differentiated") {
  claim.holds();
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    auto const density = incompressible(draw_medium<S, n>(draw));
    auto const& constraint = density.constraint;
    Jet<S, n, n + 1> const j = draw_extended_jet<S, n>(draw, draw_section<S, n, n>(draw), constraint.G);
    auto const below = deformation(j);
    S const lambda = j.y[n];
    // From the momenta: the point of space moves as the motion does along x^j, and the deformation gradient
    // is held.
    Matrix<S, n, 1> from_momenta = Matrix<S, n, 1>::Zero(), from_constraint, printed;
    for (int k = 0; k < n; ++k) {
      auto moved = below.template cast<Dual<S>>();
      for (int b = 0; b < n; ++b) moved.y[b].part[0] = below.v(b, k + 1);
      auto const slope =
          area_transformation(constraint.G(moved.particle()), constraint.g(moved.y), moved.gradient());
      for (int a = 0; a < n; ++a) from_momenta[a] += lambda * slope(a, k).part[0];
    }
    Matrix<S, n, n> const inverse = inverse_matrix(Matrix<S, n, n>(constraint.g(below.y)));
    auto const rates = metric_derivatives(constraint.g, below.y);
    auto const places = partial_y([&](auto const& jet) { return constraint(jet)[0]; }, below);
    S const J = constraint.volume_ratio(below);
    for (int a = 0; a < n; ++a) {
      from_constraint[a] = lambda * places[a];
      printed[a] = lambda * J / S(2) * (inverse * rates[a]).trace();
    }
    claim.equal("derivative of the momenta's part and of the constraint", model, from_momenta,
                from_constraint);
    claim.equal("the printed form of both", model, from_constraint, printed);
    claim.refutes("one without the other", model, from_constraint, size_of(lambda * J));
    claim.differs("without the half", model, from_constraint, (S(2) * printed).eval());
    if (n > 2)
      claim.differs("with 1/n for the half", model, from_constraint, (printed * ratio<S>(2, n)).eval());
    claim.differs("with the other sign, so that both add", model, from_constraint, (-from_momenta).eval());
  });
}

STATEMENT(claim_8_2_other_cancellations,
          "what else cancels where the momenta of the pressure are differentiated") {
  claim.holds(
      "Besides the metric of space: the derivatives of $\\det v$ and of $v^{-1}$ cancel each other (the "
      "identity of Piola), and those of the root of $\\det G$ in $\\lambda$ cancel those of the root in "
      "$J$. The derivative of $P$ remains.");
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    auto const density = incompressible(draw_medium<S, n>(draw));
    auto const& [G, g] = density.constraint;
    auto const extended = draw_extended_jet<S, n>(draw, draw_section<S, n, n>(draw), G);
    auto const j = deformation(extended);
    // Parts of d/dx^k of P J v^-1 times the root of det G, each factor differentiated by itself.
    S const P = multiplier_pressure(G, extended), J = density.constraint.volume_ratio(j),
            root = volume<S>(G(j.particle())), root_g = volume<S>(g(j.y)),
            det = determinant(Matrix<S, n, n>(j.gradient()));
    Matrix<S, n, n> const inverse = inverse_matrix(Matrix<S, n, n>(j.gradient()));
    auto const dP = pressure_gradient(G, extended);
    using Column = Matrix<S, n, 1>;
    Column pressure = Column::Zero(), metric = Column::Zero(), of_det = Column::Zero(),
           of_inverse = Column::Zero(), of_body = Column::Zero(), total = Column::Zero();
    for (int k = 0; k < n; ++k) {
      auto const moved = along(extended, k + 1);
      auto const below = deformation(moved);
      Matrix<Dual<S>, n, n> const F = below.gradient();
      S const det_rate = determinant(F).part[0], root_g_rate = volume<Dual<S>>(g(below.y)).part[0],
              root_rate = volume<Dual<S>>(G(below.particle())).part[0];
      auto const inverse_rate = rate_of(inverse_matrix(F));
      // The momenta of the pressure, as the multiplier's part of the density has them.
      auto const p = partial_v([&](auto const& jet) { return density.constraint(jet)[0]; }, below, k + 1);
      for (int a = 0; a < n; ++a) {
        pressure[a] += dP[k] * J * inverse(k, a) * root;
        metric[a] += P * root_g_rate * det * inverse(k, a);
        of_det[a] += P * root_g * det_rate * inverse(k, a);
        of_inverse[a] += P * root_g * det * inverse_rate(k, a);
        of_body[a] += P * J * root_rate * inverse(k, a);
        total[a] += (moved.y[n] * p[a]).part[0];
      }
    }
    S const scale = size_of(pressure) + size_of(metric) + size_of(of_det) + size_of(of_inverse);
    claim.zero("derivatives of det v and of its inverse", model, (of_det + of_inverse).eval(), scale);
    claim.refutes("their difference", model, (of_det - of_inverse).eval(), scale);
    claim.zero("the momenta less pressure and metric terms", model, (total - pressure - metric).eval(),
               scale);
    claim.refutes("with the derivative of det v alone", model, (total - pressure - metric - of_det).eval(),
                  scale);
    claim.refutes("with the derivative of the root of det G in the multiplier", model,
                  (total - pressure - metric - of_body).eval(), scale);
  });
}

STATEMENT(eq_8_8, "the equation of motion for constant metrics") {
  claim.holds();
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    auto const residual = [&](Medium<S, n> const& medium, SecondJet<S, n, n + 1> const& extended,
                              int sign = 1, bool mass_inside = true) {
      auto const j = deformation(extended);
      S const rho = medium.rho(j.particle());
      // Neither the volume nor the metric of space is differentiated here.
      Matrix<S, n, 1> const inertia = lowered(medium.g(j.y), j.acceleration()) * rho;
      Matrix<S, n, 1> stress = Matrix<S, n, 1>::Zero();
      for (int k = 0; k < n; ++k) {
        auto const moved = along(j, k + 1);
        auto const slope = partial_F(medium, moved);
        Dual<S> const mass = mass_inside ? Dual<S>(medium.rho(moved.particle())) : Dual<S>(rho);
        for (int a = 0; a < n; ++a) stress[a] += (mass * slope(a, k)).part[0];
      }
      return (inertia - stress + pressure_term(medium.G, medium.g, extended) * S(sign)).eval();
    };
    auto const curved = draw_medium<S, n>(draw);
    Medium<S, n> const flat{constant_metric(curved.G), constant_metric(curved.g), curved.rho, curved.W};
    auto const phi = draw_section<S, n, n>(draw);
    auto const j = draw_extended_jet<S, n>(draw, phi, flat.G);
    claim.equal("(8.8) and the Euler-Lagrange derivative", model, residual(flat, j),
                per_volume(incompressible(flat), j));
    claim.differs("the pressure with the other sign", model, residual(flat, j, -1),
                  per_volume(incompressible(flat), j));
    claim.differs("the mass density outside of the derivative", model, residual(flat, j, 1, false),
                  per_volume(incompressible(flat), j));
    claim.differs("metrics that vary", model, residual(curved, j), per_volume(incompressible(curved), j));
  });
}
