// Section 8.3: the ideal incompressible fluid on the body, and its two pressures.

#include "actio/incompressible/bracket_of_fields.hpp"

#include "incompressible_models.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

/// The metric of the half plane, \f$g = 1/(y^2)^2\f$.
struct HalfPlane {
  template <class V>
  auto operator()(V const& y) const {
    using T = ScalarOf<V>;
    Matrix<T, 2, 2> g = Matrix<T, 2, 2>::Zero();
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
    Matrix<T, 2, 1> const at(x[0], x[2]);
    return Matrix<T, 2, 1>(T(x[1] * 2 + added(at)), T(x[2] * 2));
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
  claim.corrected(
      "g_{ab}\\Bigl(\\frac{D_g\\dot\\phi}{Dt}\\Bigr)^b = -\\frac{\\partial P}{\\partial "
      "x^k}\\,J(F^{-1})^k{}_a",
      "\\rho(x)\\,g_{ab}\\Bigl(\\frac{D_g\\dot\\phi}{Dt}\\Bigr)^b = -\\frac{\\partial P}{\\partial "
      "x^k}\\,J(F^{-1})^k{}_a",
      "No other pressure takes the density in: $dP/\\rho$ is closed only where $d\\rho\\wedge dP = 0$.");
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
    claim.equal("with the density beside the acceleration", model,
                (mass * inertia + pressure_term(G, g, j)).eval(), forces);
    claim.differs("without it, as (8.9) has it", model, ideal_fluid_residual(G, g, j), forces);
    // d(dP / rho): the pressure that would have to be the gradient's.
    auto const quotient = [&](auto const& event) {
      using T = ScalarOf<decltype(event)>;
      auto const slope = derivative(P, Matrix<T, n + 1, 1>(event)).gradient();
      Matrix<T, n, 1> const particle = event.template tail<n>();
      Matrix<T, n, 1> covector;
      for (int k = 0; k < n; ++k) covector[k] = slope[k + 1] / rho(particle);
      return covector;
    };
    auto const slope = first_jet(quotient, x).gradient();
    auto const mass_rate = derivative(rho, j.particle()).gradient();
    auto const dP = pressure_gradient(G, j);
    claim.equal("curl of dP / rho", model, S((slope(0, 1) - slope(1, 0)) * mass * mass),
                S(dP[1] * mass_rate[0] - dP[0] * mass_rate[1]));
    claim.refutes("that it vanishes", model, S(slope(0, 1) - slope(1, 0)), S(size_of(dP)));
  });
}

STATEMENT(eq_8_9, "the equation of an ideal incompressible fluid") {
  claim.convention(
      "For a homogeneous fluid of density 1, which the text sets just before. It holds off the constraint "
      "too.");
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const fluid = ideal_fluid<S, n>(draw_metric<S, n>(draw), draw_metric<S, n>(draw));
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
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const G = draw_metric<S, n>(draw);
    VolumeConstraint const constraint{G, G};
    auto const j = first_jet(draw_section<S, n, n>(draw), draw_event<S, n>(draw));
    S const here = modulus(S(determinant(G.frame(j.particle())))),
            there = modulus(S(determinant(G.frame(j.y)))), det = determinant(j.gradient());
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
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const fluid =
        ideal_fluid<S, n>(draw_unimodular_metric<S, n>(draw), draw_unimodular_metric<S, n>(draw));
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
    auto const [held, vector, covector] = compare(draw_shears<S, n>(draw), x);
    claim.equal("gradient of p at the place", model, spatial_pressure_residual(fluid.G, fluid.g, held),
                vector);
    claim.equal("(8.11) and the Euler-Lagrange derivative", model, covector,
                per_volume(incompressible(fluid), held));
    auto const [free, unused, off_constraint] = compare(draw_section<S, n, n>(draw), x);
    claim.differs("a motion that does not keep the volume", model, off_constraint,
                  per_volume(incompressible(fluid), free));
  });
}

STATEMENT(claim_8_3_combined_pressure_equation, "the equation of motion with two pressures") {
  claim.convention(
      "The density is 1; otherwise $\\rho(x)$ stands before the acceleration. The second $b$ in "
      "$(D_g\\dot\\phi^b/Dt)^b$ is a misprint.");
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
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
      "The momenta and the field equations of the motion know the sum alone; the affine momentum, an energy, "
      "tells the two apart.");
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
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
  claim.convention(
      "For a homogeneous fluid: $P_W = -\\rho\\,W'(1)$ varies with $\\rho(x)$, and with the particle "
      "where $W$ depends on it. The multiplier takes it in all the same.");
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const law = draw_fluid<S>(draw);
    auto const G = draw_unimodular_metric<S, n>(draw), g = draw_unimodular_metric<S, n>(draw);
    Fluid<S, n> const homogeneous{G, g, unit_mass<S, n>(), law}, varying{G, g, draw_mass<S, n>(draw), law};
    Event<S, n> const x = draw_event<S, n>(draw);
    auto const slope_of = [&](Fluid<S, n> const& fluid, SecondJet<S, n, n> const& j) {
      Matrix<S, n, 1> slope;
      for (int k = 0; k < n; ++k) slope[k] = material_pressure(fluid, along(j, k + 1)).part[0];
      return slope;
    };
    auto const held = second_jet(draw_shears<S, n>(draw), x),
               free = second_jet(draw_section<S, n, n>(draw), x);
    S const pressure = material_pressure(homogeneous, static_cast<Jet<S, n, n> const&>(held)),
            by_law = law.w.K - law.w.a - S(2) * law.w.b;
    claim.equal("P_W = -W'(1)", model, pressure, by_law);
    claim.zero("its derivatives on the body", model, slope_of(homogeneous, held), size_of(by_law) + S(1));
    claim.refutes("where mass varies", model, slope_of(varying, held), size_of(by_law) + S(1));
    claim.refutes("where the volume is not held", model, slope_of(homogeneous, free), size_of(by_law) + S(1));
  });
}

// ----
// Section 8.3: the group of volume preserving diffeomorphisms, its geodesics and their pressure.

namespace {

/// A field on space at one time.
template <class S, class Field>
struct Frozen {
  S time;
  Field u;
  template <class V>
  auto operator()(V const& y) const {
    Matrix<ScalarOf<V>, V::RowsAtCompileTime + 1, 1> at;
    at << ScalarOf<V>(time), y;
    return u(at);
  }
};
/// A field on space as one on time and space.
template <class Field>
struct Steady {
  Field u;
  template <class V>
  auto operator()(V const& at) const {
    return u(Matrix<ScalarOf<V>, V::RowsAtCompileTime - 1, 1>(at.template tail<V::RowsAtCompileTime - 1>()));
  }
};
/// A shear along the first axis: its flow is y + s u(y).
template <class S, int n>
struct ShearField {
  Cubic<S, n + 1> speed;
  template <class V>
  auto operator()(V const& at) const {
    Matrix<ScalarOf<V>, n, 1> u = Matrix<ScalarOf<V>, n, 1>::Zero();
    u[0] = speed(at);
    return u;
  }
};
/// The flow y + s X(y) of a shear, at one time.
template <class Shear, class T>
struct FlowOfShear {
  Shear shear;
  T time;
  template <class V>
  auto operator()(V const& y) const { return (y + shear(y) * ScalarOf<V>(time)).eval(); }
};
/// A field carried along by the flow: \f$T\eta\,Y\circ\eta^{-1}\f$ at y.
template <class Shear, class Field, class S, int n, class T>
Tangents<T, n, 1> carried(Shear const& shear, Field const& Y, Matrix<S, n, 1> const& y, T const& time) {
  Matrix<T, n, 1> const place = y.template cast<T>(), from = place - shear(place) * time;
  Tangents<T, n, 1> const value = Y(from);
  return pushed(FlowOfShear<Shear, T>{shear, time}, from, value);
}
/// \f$(y^1)^k\f$ in all directions of a vector that is not constant: a field with divergence.
template <int k>
struct Swelling {
  template <class V>
  auto operator()(V const& y) const {
    auto u = y.eval();
    for (int i = 0; i < k; ++i) u *= y[0];
    u[0] += y[1] * y[1];
    return u;
  }
};
/// The point (t, y) at which a jet is.
template <class S, int n>
Event<S, n> event_in_space(Jet<S, n, n> const& j) {
  Event<S, n> at;
  at << j.x[0], j.y;
  return at;
}

}  // namespace

STATEMENT(claim_8_3_lie_algebra_bracket, "the bracket of fields that keep the volume") {
  claim.holds(
      "It is the bracket of left-invariant fields on the group; with right-invariant ones, which "
      "hydrodynamics uses otherwise, it would be the bracket of Jacobi and Lie itself.");
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const g = draw_metric<S, n>(draw);
    S const t = draw.number<S>();
    using Field = Frozen<S, SolenoidalField<S, n, AnyMetric<S, n>>>;
    Field const X{t, draw_solenoidal<S, n>(draw, g)}, Y{t, draw_solenoidal<S, n>(draw, g)};
    Event<S, n> const at = draw_event<S, n>(draw);
    Matrix<S, n, 1> const y = at.template tail<n>();
    claim.zero("divergence of the bracket", model, divergence(g, Steady{diffeomorphism_bracket(X, Y)}, at),
               size_of(diffeomorphism_bracket(X, Y)(y)) + S(1));
    claim.refutes("of two fields with divergence", model,
                  divergence(g, Steady{diffeomorphism_bracket(Swelling<1>{}, Swelling<2>{})}, at), S(1));

    // The adjoint action of the flow of X, differentiated along the flow: Ad of minus the bracket. A shear
    // has a polynomial flow, y + s X(y).
    Cubic<S, n + 1> speed = draw_cubic<S, n + 1>(draw);
    for (auto* v : {&speed.a, &speed.b, &speed.d, &speed.e}) (*v)[1] = S(0);
    Frozen<S, ShearField<S, n>> const shear{t, {speed}};
    S const s = draw.number<S>();
    Dual<S> moved(s);
    moved.part[0] = S(1);
    auto const rate = carried(shear, Y, y, moved);
    Matrix<S, n, 1> left;
    for (int a = 0; a < n; ++a) left[a] = rate(a, 0).part[0];
    Matrix<S, n, 1> const right = carried(shear, diffeomorphism_bracket(shear, Y), y, s);
    claim.equal("rate of the adjoint action", model, left, right);
    claim.differs("with the bracket of Jacobi and Lie", model, left, (-right).eval());
  });
}

STATEMENT(eq_8_13, "geodesics of the group of volume preserving diffeomorphisms") {
  claim.convention(
      "One metric on body and space, mass 1, and variations along the walls: then fields without divergence "
      "are orthogonal to gradients; that nothing else is orthogonal to all of them is the decomposition of "
      "Helmholtz and Hodge.");
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const g = draw_metric<S, n>(draw);
    auto const w = draw_solenoidal<S, n>(draw, g);
    auto const eta = draw_section<S, n, n>(draw);
    Event<S, n> const x = draw_event<S, n>(draw);
    auto const j = second_jet(eta, x);
    // Kinetic energy varied along w o eta.
    auto const change = first_jet(CarriedBy{w, eta}, x);
    using T = Dual<S>;
    Matrix<T, n, 1> place = j.y.template cast<T>(), velocity = j.velocity().template cast<T>();
    for (int a = 0; a < n; ++a) place[a].part[0] = change.y[a], velocity[a].part[0] = change.v(a, 0);
    S const varied = (inner(g(place), velocity, velocity) / T(2)).part[0];
    // d/dt <eta', w o eta>, and <D eta'/Dt, w o eta>.
    auto const moved = along(j, 0);
    Matrix<T, n, 1> w_moved = change.y.template cast<T>();
    for (int a = 0; a < n; ++a) w_moved[a].part[0] = change.v(a, 0);
    S const carried = inner(g(moved.y), moved.velocity(), w_moved).part[0],
            work = inner(g(j.y), material_acceleration(g, j), change.y);
    S const scale = size_of(varied) + size_of(carried) + size_of(work);
    claim.zero("the variation of kinetic energy", model, S(varied - carried + work), scale);
    claim.refutes("with the acceleration of coordinates", model,
                  S(varied - carried + inner(g(j.y), j.acceleration(), change.y)), scale);
    // A gradient is orthogonal to fields without divergence, but for a divergence.
    auto const p = draw_cubic<S, n + 1>(draw);
    auto const along_pressure = [&](auto const& field_in_space) {
      Event<S, n> const at = event_in_space(j);
      S const product = inner(g(j.y), gradient(g, p, at), Matrix<S, n, 1>(field_in_space(at)));
      return std::pair(
          product, S(product - divergence(
                                   g, [&](auto const& y) { return (field_in_space(y) * p(y)).eval(); }, at)));
    };
    auto const [product, rest] = along_pressure(w);
    claim.zero("work of a pressure is a divergence", model, rest, size_of(product) + S(1));
    auto const [unused, left] = along_pressure([](auto const& y) { return y.template tail<n>().eval(); });
    claim.refutes("along a field with a divergence", model, left, S(1));
  });
}

STATEMENT(eq_8_14, "the equation of the pressure") {
  claim.convention(
      "It needs $\\mathrm{div}\\,u = 0$ at all times, and the slope of $p$ at the walls to have one "
      "solution. On a curved space the right side is $-(u^i{}_{;j}u^j{}_{;i} + \\mathrm{Ric}(u,u))$.");
  over_points(TwoAndThree{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const g = draw_metric<S, n>(draw);
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

// ----
// Section 8.3: the ideal incompressible fluid in the spatial and in the material description.

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

STATEMENT(claim_8_3_euler_equations, "the fluid in the spatial description") {
  claim.holds("$(u\\cdot\\nabla)u$ is covariant, and so is the divergence.");
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const phi = draw_shears<S, n>(draw);
    VelocityInSpace<S, n> const u{phi};
    auto const any = draw_metric<S, n>(draw), unimodular = draw_unimodular_metric<S, n>(draw);
    auto const j = second_jet(phi, draw_event<S, n>(draw));
    Event<S, n> const at = event_in_space(j);
    auto const rate = velocity_gradient(any, u, at);
    claim.equal("the acceleration of the particle", model, eulerian_acceleration(any, u, at),
                material_acceleration(any, j));
    auto const flat = first_jet(u, at);
    claim.differs("with derivatives that are not covariant", model,
                  (flat.velocity() + flat.gradient() * flat.y).eval(), material_acceleration(any, j));
    VolumeConstraint const held{unimodular, unimodular}, free{any, any};
    claim.zero("divergence where the volume is held", model, divergence(unimodular, u, at),
               size_of(rate.slope));
    S const J = free.volume_ratio(static_cast<Jet<S, n, n> const&>(j)),
            J_rate = free.volume_ratio(along(j, 0)).part[0];
    claim.equal("the rate of the volume", model, J_rate, S(J * divergence(any, u, at)));
    claim.refutes("divergence where it is not", model, divergence(any, u, at), size_of(rate.slope));
    claim.zero("and the volume there", model, held(static_cast<Jet<S, n, n> const&>(j))[0], S(1));
  });
}

STATEMENT(claim_8_3_two_descriptions_agree,
          "one fluid, seen from the body and as a curve of diffeomorphisms") {
  claim.convention(
      "Body and space are one Riemannian manifold, mass is 1, and the motion begins at the identity: then $J "
      "= 1$ says that it stays in $\\mathcal D_\\mu$.");
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const g = draw_unimodular_metric<S, n>(draw);
    auto const phi = draw_shears<S, n>(draw);
    auto const p = draw_cubic<S, n + 1>(draw, ratio<S>(1, 2));
    CarriedBy const P{p, phi};
    auto const residual_on_body = [&](AnyMetric<S, n> const& G, Event<S, n> const& x) {
      auto const j = second_jet(with_pressure(phi, P, G), x);
      return per_volume(incompressible(ideal_fluid<S, n>(G, g)), j);
    };
    Event<S, n> const x = draw_event<S, n>(draw);
    Event<S, n> const at = event_in_space(first_jet(phi, x));
    Matrix<S, n, 1> const y = at.template tail<n>();
    auto const in_space = lowered(
        g(y), Matrix<S, n, 1>(eulerian_acceleration(g, VelocityInSpace<S, n>{phi}, at) + gradient(g, p, at)));
    claim.equal("field equations on the body, and Euler's in space", model, residual_on_body(g, x), in_space);
    claim.differs("a body with another volume", model, residual_on_body(draw_metric<S, n>(draw), x),
                  in_space);
  });
}

STATEMENT(claim_8_3_material_divergence, "from the equation of motion on the body to that of the pressure") {
  claim.corrected(
      "\\mathrm{div}\\text{ of both sides of (8.11)}",
      "(F^{-1})^k{}_a\\,\\nabla_k\\Bigl(\\frac{D_g\\dot\\phi}{Dt}\\Bigr)^a = -(\\Delta p)\\circ\\phi",
      "(8.11) is an equation between vectors of space at points of the body: compose with $\\phi_t^{-1}$ "
      "first. Differentiated in $x$ without $F^{-1}$ it gives another number.");
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const g = draw_unimodular_metric<S, n>(draw);
    auto const phi = draw_shears<S, n>(draw);
    VelocityInSpace<S, n> const u{phi};
    Event<S, n> const x = draw_event<S, n>(draw);
    AccelerationOf const acceleration{g, phi};
    auto const rate = first_jet(acceleration, x);
    auto const j = first_jet(phi, x);
    // The covariant derivative along the motion, in directions of the body.
    Matrix<S, n, n> slope = rate.gradient();
    auto const gamma = christoffel(g, j.y);
    for (int a = 0; a < n; ++a) slope.row(a) += (j.gradient().transpose() * (gamma[a] * rate.y)).transpose();
    S const spatial = (inverse_matrix(j.gradient()) * slope).trace(),
            source = pressure_source(g, u, event_in_space(j));
    claim.zero("with the inverse deformation gradient", model, S(spatial + source), size_of(slope) + S(1));
    // Indices of body and space identified, and the metric taken at the particle.
    S const material = divergence(g, acceleration, x);
    claim.refutes("the divergence on the body", model, S(material + source), size_of(slope) + S(1));
  });
}
