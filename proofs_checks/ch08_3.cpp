// Section 8.3: the ideal incompressible fluid on the body, and its two pressures.

#include "fields/incompressible_models.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

/// A law with c J added: it presses by \f$-\rho c\f$ more.
template <class S>
AnyFluidLaw<S> pressed_more(AnyFluidLaw<S> law, S const& c) {
  law.a += c;
  return law;
}

}  // namespace

STATEMENT(claim_8_3_inhomogeneous_density, "mass that varies, and the pressure") {
  claim.corrected(
      "g_{ab}\\Bigl(\\frac{D_g\\dot\\phi}{Dt}\\Bigr)^b = -\\frac{\\partial "
      "P}{\\partial x^k}\\,J(F^{-1})^k{}_a",
      "\\rho(x)\\,g_{ab}\\Bigl(\\frac{D_g\\dot\\phi}{Dt}\\Bigr)^b = -\\frac{\\partial "
      "P}{\\partial x^k}\\,J(F^{-1})^k{}_a",
      "No other pressure takes the density in: $d(dP/\\rho) = dP\\wedge d\\rho/\\rho^2$ "
      "vanishes only where $d\\rho\\wedge dP = 0$. Where $P$ is a function of $\\rho$ (and of "
      "time) another pressure does it.");
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    auto const G = draw_any_metric<S, n>(draw), g = draw_any_metric<S, n>(draw);
    auto const rho = draw_mass<S, n>(draw);
    auto const density = incompressible(Medium<S, n>{G, g, rho, constant_energy<S, n>(S(0))});
    auto const P = draw_cubic<S, n + 1>(draw);
    Event<S, n> const x = draw_event<S, n>(draw);
    auto const j = second_jet(with_pressure(draw_section<S, n, n>(draw), P, G), x);
    S const mass = rho(j.particle());
    auto const inertia = lowered_acceleration(g, deformation(j));
    auto const forces = per_volume(density, j);
    claim.equal("with the density beside the acceleration", model,
                (mass * inertia + pressure_term(G, g, j)).eval(), forces);
    claim.differs("without it, as (8.9) has it", model, ideal_fluid_residual(G, g, j), forces);
    // d(dP / rho): the pressure that would have to be the gradient's. Components i < k of the curl.
    auto const slopes_of = [&](auto const& pressure) {
      auto const quotient = [&](auto const& event) {
        using T = ScalarOf<decltype(event)>;
        auto const slope = derivative(pressure, Matrix<T, n + 1, 1>(event)).gradient();
        Matrix<T, n, 1> const particle = event.template tail<n>();
        return Matrix<T, n, 1>(slope.template tail<n>() / rho(particle));
      };
      return Matrix<S, n, n>(first_jet(quotient, x).gradient());
    };
    auto const curl_of = [](Matrix<S, n, n> const& slope) {
      return Matrix<S, n, n>(slope - slope.transpose());
    };
    auto const mass_rate = derivative(rho, j.particle()).gradient();
    auto const dP = pressure_gradient(G, j);
    Matrix<S, n, n> const wedge = mass_rate * dP.transpose() - dP * mass_rate.transpose(),
                          slopes = slopes_of(P), curl = curl_of(slopes);
    claim.zero("all curls of dP / rho", model, (curl * S(mass * mass) - wedge).eval(),
               S(size_of(slopes) * size_of(S(mass * mass)) + size_of(wedge)));
    claim.refutes("that they vanish", model, curl, size_of(dP));
    // P = a(t) rho + b rho^2.
    S const b = draw.number<S>() + S(2);
    auto const of_mass = [&](auto const& event) {
      using T = ScalarOf<decltype(event)>;
      T const r = rho(Matrix<T, n, 1>(event.template tail<n>()));
      return T(r * event[0] + r * r * T(b));
    };
    Matrix<S, n, n> const of_function = slopes_of(of_mass);
    claim.zero("curls where the pressure is a function of the density", model, curl_of(of_function),
               S(size_of(of_function) + S(1)));
  });
}

STATEMENT(eq_8_9, "the equation of an ideal incompressible fluid") {
  claim.holds(
      "The fluid is homogeneous and of density 1, as the text sets it just before. The "
      "equation holds off the constraint too.");
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    auto const fluid = ideal_fluid<S, n>(draw_any_metric<S, n>(draw), draw_any_metric<S, n>(draw));
    auto const j = draw_extended_jet<S, n>(draw, draw_section<S, n, n>(draw), fluid.G);
    auto const residual = ideal_fluid_residual(fluid.G, fluid.g, j);
    claim.equal("(8.9) and the Euler-Lagrange derivative", model, residual,
                per_volume(incompressible(fluid), j));
    Medium<S, n> const heavier{fluid.G, fluid.g, draw_mass<S, n>(draw), fluid.W};
    claim.differs("mass that varies", model, residual, per_volume(incompressible(heavier), j));
    auto const without_J =
        (residual - pressure_term(fluid.G, fluid.g, j) + spatial_pressure_gradient(fluid.G, j)).eval();
    claim.differs("without J, off the constraint", model, without_J, per_volume(incompressible(fluid), j));
  });
}

STATEMENT(eq_8_10, "the constraint where body and space have one metric") {
  claim.holds();
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    auto const G = draw_any_metric<S, n>(draw), same = draw_metric_of_volume<S, n>(draw);
    VolumeConstraint const constraint{G, G}, held{same, same};
    Event<S, n> const x = draw_event<S, n>(draw);
    auto const j = first_jet(draw_section<S, n, n>(draw), x);
    S const here = modulus(S(determinant(G.frame(j.particle())))),
            there = modulus(S(determinant(G.frame(j.y)))), det = determinant(j.gradient());
    claim.equal("J with one metric at two places", model, constraint.volume_ratio(j), S(there / here * det));
    claim.differs("with the roots cancelled", model, constraint.volume_ratio(j), det);
    claim.differs("with the roots turned round", model, constraint.volume_ratio(j), S(here / there * det));
    auto const phi = draw_shears<S, n>(draw, same.chart, same.chart);
    claim.zero("motions that keep a volume that varies", model, held(first_jet(phi, x))[0], S(1));
    claim.refutes("that their determinant is 1", model, S(determinant(first_jet(phi, x).gradient()) - S(1)),
                  S(1));
    claim.refutes("motions whose determinant is 1", model, held(first_jet(of_coordinates(phi), x))[0], S(1));
  });
}

STATEMENT(claim_8_3_spatial_density,
          "the spatial density of an incompressible homogeneous fluid is constant") {
  claim.holds(
      "In space and in time; $\\rho_{\\mathrm{sp}} = \\rho/J$ has the rate "
      "$-\\rho_{\\mathrm{sp}}\\,\\mathrm{div}\\,u$ along any motion.");
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    auto const body = draw_metric_of_volume<S, n>(draw), space = draw_metric_of_volume<S, n>(draw);
    auto const any = draw_any_metric<S, n>(draw);
    auto const phi = draw_shears<S, n>(draw, body.chart, space.chart);
    S const rho = S(1) + draw.template number<S>() / S(4);
    Event<S, n> const at = event_in_space(first_jet(phi, draw_event<S, n>(draw)));
    // As a function of time and place: at the particle that is there.
    auto const density = [&](auto const& G, auto const& g) {
      return [&, held = VolumeConstraint{G, g}]<class V>(V const& y) {
        return ScalarOf<V>(ScalarOf<V>(rho) / held.volume_ratio(first_jet(phi, phi.particle(y))));
      };
    };
    auto const slopes = [&](auto const& f) {
      Matrix<S, n + 1, 1> slope;
      for (int mu = 0; mu <= n; ++mu) {
        auto moved = at.template cast<Dual<S>>().eval();
        moved[mu].part[0] = S(1);
        slope[mu] = f(moved).part[0];
      }
      return slope;
    };
    claim.zero("rates in time and space", model, slopes(density(body, space)), rho, 30);
    claim.refutes("with another volume of the body", model, slopes(density(any, space)), rho);
    auto const rho_sp = density(any, any)(at);
    auto const slope = slopes(density(any, any));
    VelocityInSpace const u{phi};
    S const carried = slope[0] + u(at).dot(slope.template tail<n>());
    claim.equal("any motion: the continuity of mass", model, carried, S(-rho_sp * divergence(any, u, at)),
                30);
    claim.differs("without the part that is carried", model, slope[0], S(-rho_sp * divergence(any, u, at)));
  });
}

STATEMENT(eq_8_11, "the equation with the pressure in space") {
  claim.holds(
      "It uses $J = 1$, not that determinants are 1: off the constraint the "
      "gradient has the factor $J$ of (8.9).");
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    auto const fluid =
        ideal_fluid<S, n>(draw_metric_of_volume<S, n>(draw), draw_metric_of_volume<S, n>(draw));
    auto const p = draw_cubic<S, n + 1>(draw, ratio<S>(1, 2));
    auto const compare = [&](auto const& phi, Event<S, n> const& x) {
      auto const j = second_jet(with_pressure(phi, CarriedBy{p, phi}, fluid.G), x);
      Event<S, n> at;
      at << x[0], deformation(j).y;
      Matrix<S, n, 1> const vector =
          material_acceleration(fluid.g, deformation(j)) + gradient(fluid.g, p, at);
      return std::tuple(j, vector, lowered(fluid.g(deformation(j).y), vector));
    };
    Event<S, n> const x = draw_event<S, n>(draw);
    auto const phi = draw_shears<S, n>(draw, fluid.G.chart, fluid.g.chart);
    auto const [held, vector, covector] = compare(phi, x);
    claim.equal("gradient of p at the place", model, spatial_pressure_residual(fluid.G, fluid.g, held),
                vector);
    auto const forces = per_volume(incompressible(fluid), held);
    claim.equal("(8.11) and the Euler-Lagrange derivative", model, covector, forces);
    Event<S, n> at;
    at << x[0], deformation(held).y;
    claim.differs("the gradient with the other sign", model,
                  (covector - S(2) * lowered(fluid.g(deformation(held).y), gradient(fluid.g, p, at))).eval(),
                  forces);
    claim.differs("the gradient at the particle", model,
                  Matrix<S, n, 1>(lowered_acceleration(fluid.g, deformation(held)) +
                                  derivative(p, x).gradient().template tail<n>()),
                  forces);
    auto const [free, unused, off_constraint] = compare(of_coordinates(phi), x);
    claim.differs("a motion that keeps the volume of coordinates", model, off_constraint,
                  per_volume(incompressible(fluid), free));
  });
}

STATEMENT(claim_8_3_combined_pressure_equation, "the equation of motion with two pressures") {
  claim.corrected(
      "g_{ab}\\Bigl(\\frac{D_g\\dot\\phi^b}{Dt}\\Bigr)^b = -\\frac{\\partial(P_W + "
      "P_\\lambda)}{\\partial x^k}\\,J(F^{-1})^k{}_a",
      "g_{ab}\\Bigl(\\frac{D_g\\dot\\phi}{Dt}\\Bigr)^b = -\\frac{\\partial(P_W + "
      "P_\\lambda)}{\\partial x^k}\\,J(F^{-1})^k{}_a",
      "A slip of an index: $\\dot\\phi$ is a vector, and its components differentiated as functions would "
      "lose the connection. The density is 1; otherwise $\\rho(x)$ stands before the acceleration.");
  claim.maybe_scan();
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    auto fluid = draw_barotropic<S, n>(draw);
    auto const varying = fluid.rho;
    fluid.rho = unit_mass<S, n>();
    auto const j = draw_extended_jet<S, n>(draw, draw_section<S, n, n>(draw), fluid.G);
    auto const forces = per_volume(incompressible(fluid), j);
    claim.equal("the sum of the pressures pushes", model, two_pressures_residual(fluid, j), forces);
    auto const multiplier = pressure_term(fluid.G, fluid.g, j);
    claim.differs("their difference", model, (two_pressures_residual(fluid, j) - S(2) * multiplier).eval(),
                  forces);
    auto const inertia = lowered_acceleration(fluid.g, deformation(j));
    claim.differs("printed: the components differentiated as functions", model,
                  (two_pressures_residual(fluid, j) - inertia +
                   lowered(fluid.g(deformation(j).y), deformation(j).acceleration()))
                      .eval(),
                  forces);
    fluid.rho = varying;
    S const rho = varying(j.particle());
    auto const with_mass = per_volume(incompressible(fluid), j);
    claim.equal("with mass that varies, beside the acceleration", model, two_pressures_residual(fluid, j),
                with_mass);
    claim.differs("and without it there", model,
                  (two_pressures_residual(fluid, j) - (rho - S(1)) * inertia).eval(), with_mass);
  });
}

STATEMENT(eq_8_12, "only the sum of the two pressures moves the fluid") {
  claim.holds(
      "The momenta and the field equations of the motion know the sum alone; the affine momentum, "
      "an energy, tells the two apart.");
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    auto const fluid = draw_barotropic<S, n>(draw);
    S const c = draw.number<S>() + S(2);
    Fluid<S, n> const pressed{fluid.G, fluid.g, fluid.rho, {pressed_more(fluid.W.w, c)}};
    auto const P = draw_cubic<S, n + 1>(draw);
    auto const phi = draw_section<S, n, n>(draw);
    // What the law subtracts the multiplier adds.
    auto const relieved = [&](auto const& x) {
      Matrix<ScalarOf<decltype(x)>, n, 1> const particle = x.template tail<n>();
      using T = ScalarOf<decltype(x)>;
      return T(P(x) + fluid.rho(particle) * T(c));
    };
    Event<S, n> const x = draw_event<S, n>(draw);
    auto const one = second_jet(with_pressure(phi, P, fluid.G), x),
               other = second_jet(with_pressure(phi, relieved, fluid.G), x);
    auto const here = incompressible(fluid), there = incompressible(pressed);
    claim.equal("the total pressure", model, pressures(fluid, one).total(),
                pressures(pressed, other).total());
    claim.equal("the same forces", model, per_volume(there, other), per_volume(here, one));
    claim.equal("the same momenta", model, momenta(there, static_cast<Jet<S, n, n + 1> const&>(other)),
                momenta(here, static_cast<Jet<S, n, n + 1> const&>(one)));
    claim.differs("the law alone changed", model, per_volume(there, one), per_volume(here, one));
    claim.differs("the affine momentum", model,
                  legendre(there, static_cast<Jet<S, n, n + 1> const&>(other)).Pi,
                  legendre(here, static_cast<Jet<S, n, n + 1> const&>(one)).Pi);
  });
}

STATEMENT(claim_8_3_potential_pressure, "the pressure of the stored energy where the volume is held") {
  claim.holds(
      "The fluid is homogeneous, as the text sets it. With mass that varies $P_W = "
      "-\\rho\\,W'(1)$ varies with the particle.");
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    auto const law = draw_fluid<S>(draw);
    auto const G = draw_metric_of_volume<S, n>(draw), g = draw_metric_of_volume<S, n>(draw);
    Fluid<S, n> const homogeneous{G, g, unit_mass<S, n>(), law}, varying{G, g, draw_mass<S, n>(draw), law};
    Event<S, n> const x = draw_event<S, n>(draw);
    auto const slope_of = [&](Fluid<S, n> const& fluid, SecondJet<S, n, n> const& j) {
      Matrix<S, n, 1> slope;
      for (int k = 0; k < n; ++k) slope[k] = material_pressure(fluid, along(j, k + 1)).part[0];
      return slope;
    };
    auto const phi = draw_shears<S, n>(draw, G.chart, g.chart);
    auto const held = second_jet(phi, x), free = second_jet(of_coordinates(phi), x);
    S const pressure = material_pressure(homogeneous, static_cast<Jet<S, n, n> const&>(held)),
            by_law = law.w.K - law.w.a - S(2) * law.w.b;
    claim.equal("P_W = -W'(1)", model, pressure, by_law);
    claim.zero("its derivatives on the body", model, slope_of(homogeneous, held), size_of(by_law) + S(1));
    claim.refutes("where mass varies", model, slope_of(varying, held), size_of(by_law) + S(1));
    claim.refutes("where the volume is not held", model, slope_of(homogeneous, free), size_of(by_law) + S(1));
    // The equation of motion of the law, and (8.9) with the pressure of the multiplier alone.
    auto const compare = [&](std::string const& what, auto const& section, bool claimed) {
      auto const j = draw_extended_jet<S, n>(draw, section, G);
      auto const of_law = per_volume(incompressible(homogeneous), j);
      if (claimed)
        claim.equal(what, model, of_law, ideal_fluid_residual(G, g, j));
      else
        claim.differs(what, model, of_law, ideal_fluid_residual(G, g, j));
    };
    compare("the equation of motion is (8.9)", phi, true);
    compare("(8.9) where the volume is not held", of_coordinates(phi), false);
  });
}

// ----
// Section 8.3: the ideal incompressible fluid in the spatial description, its pressure, and the material
// description.

namespace {

/// The material acceleration of a motion, a field along it.
template <class Metric, class Phi>
struct AccelerationOf {
  Metric g;
  Phi phi;
  template <class V>
  auto operator()(V const& x) const { return material_acceleration(g, second_jet(phi, x)); }
};
template <class Metric, class Phi>
AccelerationOf(Metric, Phi) -> AccelerationOf<Metric, Phi>;

}  // namespace

STATEMENT(eq_8_14, "the equation of the pressure") {
  claim.holds(
      "With $\\mathrm{div}\\,u = 0$ at all times, as the line before has it, and covariant derivatives. On "
      "a curved space the right side is $-(u^i{}_{;j}u^j{}_{;i} + \\mathrm{Ric}(u,u))$.");
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    auto const g = draw_any_metric<S, n>(draw);
    auto const u = draw_solenoidal<S, n>(draw, g);
    Event<S, n> const at = draw_event<S, n>(draw);
    Matrix<S, n, 1> const y = at.template tail<n>();
    auto const rate = velocity_gradient(g, u, at);
    S const source = pressure_source(g, u, at);
    S const gradients = (rate.slope * rate.slope).trace(),
            curvature = inner(ricci_tensor(g, y), rate.value, rate.value);
    S const scale = size_of(gradients) + size_of(curvature) + S(1);
    claim.zero("what acceleration has for its divergence", model,
               S(divergence(
                     g, [&](auto const& p) { return eulerian_acceleration(g, u, p); }, at) +
                 source),
               scale);
    claim.zero("by velocity gradients and Ricci's tensor", model, S(source + gradients + curvature), scale);
    claim.refutes("without curvature", model, S(source + gradients), scale);
    auto const compressed = [&](auto const& p) { return (u(p) + p.template tail<n>() * p[0] * p[1]).eval(); };
    claim.refutes("a velocity with divergence", model,
                  S(divergence(
                        g, [&](auto const& p) { return eulerian_acceleration(g, compressed, p); }, at) +
                    pressure_source(g, compressed, at)),
                  scale);
    // The Laplacian is the trace of second covariant derivatives.
    auto const p = draw_cubic<S, n + 1>(draw);
    auto const slopes = first_jet([&](auto const& e) { return gradient(Euclidean<n>{}, p, e); }, at);
    Matrix<S, n, n> hessian = slopes.gradient();
    auto const gamma = christoffel(g, y);
    for (int c = 0; c < n; ++c) hessian -= gamma[c] * slopes.y[c];
    claim.zero("the Laplacian as a trace", model, S(laplacian(g, p, at) - raised(g(y), hessian).trace()),
               size_of(hessian) + S(1));
    claim.differs("the Laplacian of coordinates", model, laplacian(g, p, at), S(slopes.gradient().trace()));
  });
}

STATEMENT(claim_8_3_euler_equations, "the fluid in the spatial description") {
  claim.holds("$(u\\cdot\\nabla)u$ is covariant, and so is the divergence.");
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    auto const any = draw_any_metric<S, n>(draw), metric = draw_metric_of_volume<S, n>(draw),
               body = draw_metric_of_volume<S, n>(draw);
    auto const phi = draw_shears<S, n>(draw, body.chart, metric.chart);
    VelocityInSpace const u{phi};
    auto const j = second_jet(phi, draw_event<S, n>(draw));
    Event<S, n> const at = event_in_space(j);
    auto const rate = velocity_gradient(any, u, at);
    claim.equal("the acceleration of the particle", model, eulerian_acceleration(any, u, at),
                material_acceleration(any, j));
    auto const flat = first_jet(u, at);
    claim.differs("with derivatives that are not covariant", model,
                  (flat.velocity() + flat.gradient() * flat.y).eval(), material_acceleration(any, j));
    VolumeConstraint const held{body, metric}, free{any, any};
    claim.zero("divergence where the volume is held", model, divergence(metric, u, at), size_of(rate.slope));
    claim.refutes("as if the determinant of the metric were constant", model, S(flat.gradient().trace()),
                  size_of(rate.slope));
    S const J = free.volume_ratio(static_cast<Jet<S, n, n> const&>(j)),
            J_rate = free.volume_ratio(along(j, 0)).part[0];
    claim.equal("the rate of the volume", model, J_rate, S(J * divergence(any, u, at)));
    claim.refutes("divergence where it is not", model, divergence(any, u, at), size_of(rate.slope));
    claim.zero("and the volume there", model, held(static_cast<Jet<S, n, n> const&>(j))[0], S(1));
    // Composed with the inverse motion, (8.13) is Euler's equation with the same pressure.
    auto const p = draw_cubic<S, n + 1>(draw, ratio<S>(1, 2));
    Matrix<S, n, 1> const along_motion = material_acceleration(metric, j) + gradient(metric, p, at);
    claim.equal("(8.13) at the particle, and Euler's equation at its place", model,
                Matrix<S, n, 1>(eulerian_acceleration(metric, u, at) + gradient(metric, p, at)),
                along_motion);
    claim.differs("with the rate alone, without advection", model,
                  Matrix<S, n, 1>(velocity_gradient(metric, u, at).rate + gradient(metric, p, at)),
                  along_motion);
  });
}

STATEMENT(claim_8_3_two_descriptions_agree,
          "one fluid, seen from the body and as a curve of diffeomorphisms") {
  claim.holds(
      "Under the identification that the section makes: body and space are one Riemannian "
      "manifold, mass is 1, and the motion begins at the identity, so that $J = 1$ says that "
      "it stays in $\\mathcal D_\\mu$.");
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    auto const g = draw_metric_of_volume<S, n>(draw);
    auto const phi = draw_shears<S, n>(draw, g.chart, g.chart);
    auto const p = draw_cubic<S, n + 1>(draw, ratio<S>(1, 2));
    CarriedBy const P{p, phi};
    auto const residual_on_body = [&](MetricOfVolume<S, n> const& G, Event<S, n> const& x) {
      auto const j = second_jet(with_pressure(phi, P, G), x);
      return per_volume(incompressible(ideal_fluid<S, n>(G, g)), j);
    };
    Event<S, n> const x = draw_event<S, n>(draw);
    Event<S, n> start = x;
    start[0] = S(0);
    claim.equal("the motion begins at the identity", model, phi(start),
                Matrix<S, n, 1>(x.template tail<n>()));
    claim.zero("and stays in the group", model, VolumeConstraint{g, g}(first_jet(phi, x))[0], S(1));
    Event<S, n> const at = event_in_space(first_jet(phi, x));
    Matrix<S, n, 1> const y = at.template tail<n>();
    auto const on_body = residual_on_body(g, x);
    auto const in_space = lowered(
        g(y), Matrix<S, n, 1>(eulerian_acceleration(g, VelocityInSpace{phi}, at) + gradient(g, p, at)));
    claim.equal("field equations on the body, and Euler's in space", model, on_body, in_space);
    claim.equal(
        "and (8.13) along the motion", model, on_body,
        lowered(g(y), Matrix<S, n, 1>(material_acceleration(g, second_jet(phi, x)) + gradient(g, p, at))));
    claim.differs("a body with another volume", model, residual_on_body(draw_any_metric<S, n>(draw), x),
                  in_space);
    claim.differs(
        "the inverse motion for the motion", model, on_body,
        lowered(g(y), Matrix<S, n, 1>(
                          material_acceleration(g, second_jet(
                                                       [&](auto const& event) {
                                                         return phi.particle(event).template tail<n>().eval();
                                                       },
                                                       at)) +
                          gradient(g, p, at))));
  });
}

STATEMENT(claim_8_3_material_divergence, "from the equation of motion on the body to that of the pressure") {
  claim.convention(
      "With the divergence in space. (8.11) is an equation between vectors of space at points of the body: "
      "composed with $\\phi_t^{-1}$, or with $(F^{-1})^k{}_a\\,\\nabla_k$ on the body, both sides give "
      "(8.14) at the place of the particle. Differentiated in $x$ without $F^{-1}$ they give other numbers.");
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    auto const g = draw_metric_of_volume<S, n>(draw);
    auto const phi = draw_shears<S, n>(draw, draw_chart<S, n>(draw), g.chart);
    VelocityInSpace const u{phi};
    Event<S, n> const x = draw_event<S, n>(draw);
    AccelerationOf const acceleration{g, phi};
    auto const rate = first_jet(acceleration, x);
    auto const j = first_jet(phi, x);
    auto const gamma = christoffel(g, j.y);
    // The covariant derivative, in directions of the body, of a field along the motion.
    auto const slope_of = [&](Jet<S, n, n> const& field) {
      Matrix<S, n, n> slope = field.gradient();
      for (int a = 0; a < n; ++a)
        slope.row(a) += (j.gradient().transpose() * (gamma[a] * field.y)).transpose();
      return slope;
    };
    Matrix<S, n, n> const slope = slope_of(rate), inverse = inverse_matrix(j.gradient());
    S const spatial = (inverse * slope).trace(), source = pressure_source(g, u, event_in_space(j));
    claim.zero("with the inverse deformation gradient", model, S(spatial + source), size_of(slope) + S(1));
    auto const p = draw_cubic<S, n + 1>(draw, ratio<S>(1, 2));
    CarriedBy const push{[g, p](auto const& at) { return gradient(g, p, at); }, phi};
    Matrix<S, n, n> const slope_of_push = slope_of(first_jet(push, x));
    S const laplacian_there = laplacian(g, p, event_in_space(j));
    // Ten more roundings: third derivatives of the motion and of the metric on the other side.
    claim.zero("the gradient of the pressure, with the inverse deformation gradient", model,
               S((inverse * slope_of_push).trace() - laplacian_there), size_of(slope_of_push) + S(1), 10);
    claim.refutes("its divergence on the body", model, S(slope_of_push.trace() - laplacian_there),
                  size_of(slope_of_push) + S(1));
    // Indices of body and space identified, and the metric taken at the particle.
    S const material = divergence(g, acceleration, x);
    claim.refutes("the divergence on the body", model, S(material + source), size_of(slope) + S(1));
  });
}
