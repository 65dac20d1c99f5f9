// Scalars: rational (long: double)
// Section 8.3: the ideal incompressible fluid on the body, and its two pressures.
#include "incompressible_models.hpp"

#include "statement.hpp"

namespace {

using namespace actio;
using namespace actio::checks;

/// The metric of the half plane, \f$g = 1/(y^2)^2\f$.
struct HalfPlane {
  template <class V>
  auto operator()(V const& y) const {
    using T = ScalarOf<V>;
    Eigen::Matrix<T, 2, 2> g = Eigen::Matrix<T, 2, 2>::Zero();
    g(0, 0) = g(1, 1) = T(1) / (y[1] * y[1]);
    return g;
  }
};
/// \f$(2x^1 + c(t, x^2),\ 2x^2)\f$, which keeps the volume of the half plane and stretches coordinates.
template <class S>
struct StretchAndShear {
  Cubic<S, 2> added;
  template <class V>
  auto operator()(V const& x) const {
    using T = ScalarOf<V>;
    Eigen::Matrix<T, 2, 1> const at(x[0], x[2]);
    return Eigen::Matrix<T, 2, 1>(T(x[1] * 2 + added(at)), T(x[2] * 2));
  }
};

/// A law with c J added: it presses by \f$-\rho c\f$ more.
template <class S>
AnyFluidLaw<S> pressed_more(AnyFluidLaw<S> law, S const& c) {
  law.a += c;
  return law;
}

}  // namespace

STATEMENT(claim_8_3_inhomogeneous_density, "mass that varies, and the pressure") {
  claim.corrected("g_{ab}\\Bigl(\\frac{D_g\\dot\\phi}{Dt}\\Bigr)^b = -\\frac{\\partial P}{\\partial x^k}\\,J(F^{-1})^k{}_a",
                  "\\rho(x)\\,g_{ab}\\Bigl(\\frac{D_g\\dot\\phi}{Dt}\\Bigr)^b = -\\frac{\\partial P}{\\partial x^k}\\,J(F^{-1})^k{}_a",
                  "No other pressure takes the density in: $dP/\\rho$ is closed only where $d\\rho\\wedge dP = 0$.");
  claim.degree(degree_of_fields);
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const G = draw_metric<S, n>(draw), g = draw_metric<S, n>(draw);
    auto const rho = draw_mass<S, n>(draw);
    auto const density = incompressible(Medium<S, n>{G, g, rho, constant_energy<S, n>(S(0))});
    auto const P = draw_cubic<S, n + 1>(draw);
    Event<S, n> const x = draw_event<S, n>(draw);
    auto const j = second_jet(with_pressure(draw_section<S, n, n>(draw), P, G), x);
    S const mass = rho(j.particle());
    auto const inertia = lowered_acceleration(g, deformation(j));
    auto const forces = per_volume(density, j);
    claim.equal("with the density beside the acceleration", model, (mass * inertia + pressure_term(G, g, j)).eval(), forces);
    claim.differs("without it, as (8.9) has it", model, ideal_fluid_residual(G, g, j), forces);
    // d(dP / rho): the pressure that would have to be the gradient's.
    auto const quotient = [&](auto const& event) {
      using T = ScalarOf<decltype(event)>;
      auto const slope = P(detail::in_all_directions(Eigen::Matrix<T, n + 1, 1>(event)));
      Eigen::Matrix<T, n, 1> const particle = event.template tail<n>();
      Eigen::Matrix<T, n, 1> covector;
      for (int k = 0; k < n; ++k) covector[k] = slope.part[k + 1] / rho(particle);
      return covector;
    };
    auto const slope = first_jet(quotient, x).gradient();
    auto const mass_rate = rho(detail::in_all_directions(j.particle()));
    auto const dP = pressure_gradient(G, j);
    claim.equal("curl of dP / rho", model, S((slope(0, 1) - slope(1, 0)) * mass * mass), S(dP[1] * mass_rate.part[0] - dP[0] * mass_rate.part[1]));
    claim.refutes("that it vanishes", model, S(slope(0, 1) - slope(1, 0)), S(size_of(dP)));
  });
}

STATEMENT(eq_8_9, "the equation of an ideal incompressible fluid") {
  claim.convention("For a homogeneous fluid of density 1, which the text sets just before. It holds off the constraint too.");
  claim.degree(degree_of_fields);
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const fluid = ideal_fluid<S, n>(draw_metric<S, n>(draw), draw_metric<S, n>(draw));
    auto const j = draw_extended_jet<S, n>(draw, draw_section<S, n, n>(draw), fluid.G);
    auto const residual = ideal_fluid_residual(fluid.G, fluid.g, j);
    claim.equal("(8.9) and the Euler-Lagrange derivative", model, residual, per_volume(incompressible(fluid), j));
    Medium<S, n> const heavier{fluid.G, fluid.g, draw_mass<S, n>(draw), fluid.W};
    claim.differs("mass that varies", model, residual, per_volume(incompressible(heavier), j));
    auto const without_J = (residual - pressure_term(fluid.G, fluid.g, j) + spatial_pressure_gradient(fluid.G, j)).eval();
    claim.differs("without J, off the constraint", model, without_J, per_volume(incompressible(fluid), j));
  });
}

STATEMENT(eq_8_10, "the constraint where body and space have one metric") {
  claim.holds();
  claim.degree(degree_of_fields);
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const G = draw_metric<S, n>(draw);
    VolumeConstraint const constraint{G, G};
    auto const j = first_jet(draw_section<S, n, n>(draw), draw_event<S, n>(draw));
    S const here = determinant(G.frame(j.particle())), there = determinant(G.frame(j.y)), det = determinant(j.gradient());
    claim.equal("J with one metric at two places", model, constraint.volume_ratio(j), S(there / here * det));
    claim.differs("with the roots cancelled", model, constraint.volume_ratio(j), det);
  });
  Event<S, 2> x = draw_event<S, 2>(draw);
  x[2] += S(2);
  auto const j = first_jet(StretchAndShear<S>{draw_cubic<S, 2>(draw)}, x);
  VolumeConstraint const constraint{HalfPlane{}, HalfPlane{}};
  claim.zero("a motion of the half plane that doubles coordinates", "half plane", constraint(j)[0], S(1));
  claim.refutes("its determinant is 1", "half plane", S(determinant(j.gradient()) - S(1)), S(1));
}

STATEMENT(eq_8_11, "the equation with the pressure in space") {
  claim.holds("It uses $J = 1$: off the constraint the gradient has the factor $J$ of (8.9).");
  claim.degree(degree_of_fields);
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const fluid = ideal_fluid<S, n>(draw_unimodular_metric<S, n>(draw), draw_unimodular_metric<S, n>(draw));
    auto const p = draw_cubic<S, n + 1>(draw, ratio<S>(1, 2));
    auto const compare = [&](auto const& phi, Event<S, n> const& x) {
      auto const j = second_jet(with_pressure(phi, CarriedBy{p, phi}, fluid.G), x);
      Event<S, n> at;
      at << x[0], deformation(j).y;
      Eigen::Matrix<S, n, 1> const vector = material_acceleration(fluid.g, deformation(j)) + gradient(fluid.g, p, at);
      return std::tuple(j, vector, lowered(fluid.g(deformation(j).y), vector));
    };
    Event<S, n> const x = draw_event<S, n>(draw);
    auto const [held, vector, covector] = compare(draw_shears<S, n>(draw), x);
    claim.equal("gradient of p at the place", model, spatial_pressure_residual(fluid.G, fluid.g, held), vector);
    claim.equal("(8.11) and the Euler-Lagrange derivative", model, covector, per_volume(incompressible(fluid), held));
    auto const [free, unused, off_constraint] = compare(draw_section<S, n, n>(draw), x);
    claim.differs("a motion that does not keep the volume", model, off_constraint, per_volume(incompressible(fluid), free));
  });
}

STATEMENT(claim_8_3_combined_pressure_equation, "the equation of motion with two pressures") {
  claim.convention("The density is 1; otherwise $\\rho(x)$ stands before the acceleration. The second b in $(D_g\\dot\\phi^b/Dt)^b$ is a slip of the pen.");
  claim.degree(degree_of_fields);
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto fluid = draw_barotropic<S, n>(draw);
    auto const varying = fluid.rho;
    fluid.rho = unit_mass<S, n>();
    auto const j = draw_extended_jet<S, n>(draw, draw_section<S, n, n>(draw), fluid.G);
    auto const forces = per_volume(incompressible(fluid), j);
    claim.equal("the sum of the pressures pushes", model, two_pressures_residual(fluid, j), forces);
    auto const multiplier = pressure_term(fluid.G, fluid.g, j);
    claim.differs("their difference", model, (two_pressures_residual(fluid, j) - S(2) * multiplier).eval(), forces);
    auto const inertia = lowered_acceleration(fluid.g, deformation(j));
    fluid.rho = varying;
    S const rho = varying(j.particle());
    auto const with_mass = per_volume(incompressible(fluid), j);
    claim.equal("with mass that varies, beside the acceleration", model, two_pressures_residual(fluid, j), with_mass);
    claim.differs("and without it there", model, (two_pressures_residual(fluid, j) - (rho - S(1)) * inertia).eval(), with_mass);
  });
}

STATEMENT(eq_8_12, "only the sum of the two pressures moves the fluid") {
  claim.holds("The momenta and the field equations of the motion know the sum alone; the affine momentum, an energy, tells the two apart.");
  claim.degree(degree_of_fields);
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const fluid = draw_barotropic<S, n>(draw);
    S const c = draw.number<S>() + S(2);
    Fluid<S, n> const pressed{fluid.G, fluid.g, fluid.rho, {pressed_more(fluid.W.w, c)}};
    auto const P = draw_cubic<S, n + 1>(draw);
    auto const phi = draw_section<S, n, n>(draw);
    // What the law gives away the multiplier takes up.
    auto const relieved = [&](auto const& x) {
      Eigen::Matrix<ScalarOf<decltype(x)>, n, 1> const particle = x.template tail<n>();
      using T = ScalarOf<decltype(x)>;
      return T(P(x) + fluid.rho(particle) * T(c));
    };
    Event<S, n> const x = draw_event<S, n>(draw);
    auto const one = second_jet(with_pressure(phi, P, fluid.G), x), other = second_jet(with_pressure(phi, relieved, fluid.G), x);
    auto const here = incompressible(fluid), there = incompressible(pressed);
    claim.equal("the total pressure", model, pressures(fluid, one).total(), pressures(pressed, other).total());
    claim.equal("the same forces", model, per_volume(there, other), per_volume(here, one));
    claim.equal("the same momenta", model, momenta(there, static_cast<Jet<S, n, n + 1> const&>(other)), momenta(here, static_cast<Jet<S, n, n + 1> const&>(one)));
    claim.differs("the law alone changed", model, per_volume(there, one), per_volume(here, one));
    claim.differs("the affine momentum", model, legendre(there, static_cast<Jet<S, n, n + 1> const&>(other)).Pi, legendre(here, static_cast<Jet<S, n, n + 1> const&>(one)).Pi);
  });
}

STATEMENT(claim_8_3_potential_pressure, "the pressure of the stored energy where the volume is held") {
  claim.convention("For a homogeneous fluid: $P_W = -\\rho\\,W'(1)$ varies with $\\rho(x)$, and with the point where W sees it. The multiplier takes it in all the same.");
  claim.degree(degree_of_fields);
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const law = draw_fluid<S>(draw);
    auto const G = draw_unimodular_metric<S, n>(draw), g = draw_unimodular_metric<S, n>(draw);
    Fluid<S, n> const homogeneous{G, g, unit_mass<S, n>(), law}, varying{G, g, draw_mass<S, n>(draw), law};
    Event<S, n> const x = draw_event<S, n>(draw);
    auto const slope_of = [&](Fluid<S, n> const& fluid, SecondJet<S, n, n> const& j) {
      Eigen::Matrix<S, n, 1> slope;
      for (int k = 0; k < n; ++k) slope[k] = material_pressure(fluid, along(j, k + 1)).part[0];
      return slope;
    };
    auto const held = second_jet(draw_shears<S, n>(draw), x), free = second_jet(draw_section<S, n, n>(draw), x);
    S const pressure = material_pressure(homogeneous, static_cast<Jet<S, n, n> const&>(held)), by_law = law.w.K - law.w.a - S(2) * law.w.b;
    claim.equal("P_W = -W'(1)", model, pressure, by_law);
    claim.zero("its derivatives on the body", model, slope_of(homogeneous, held), size_of(by_law) + S(1));
    claim.refutes("where mass varies", model, slope_of(varying, held), size_of(by_law) + S(1));
    claim.refutes("where the volume is not held", model, slope_of(homogeneous, free), size_of(by_law) + S(1));
  });
}
