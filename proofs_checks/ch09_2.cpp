// Section 9.2: translations of time and the continuity of energy.
#include "fields/fields.hpp"

#include "actio/continuum/stresses.hpp"
#include "actio/noether/time_translation.hpp"
#include "fields/stored_energies.hpp"
#include "fields/symmetries.hpp"
#include "statement.hpp"

namespace {

using namespace actio;
using namespace actio::checks;

/// A medium that grows heavier with time.
template <class L>
struct Ageing {
  L density;
  template <class S, int n, int N>
  S operator()(Jet<S, n, N> const& j) const { return density(j) * (j.x[0] + 1); }
};

/// The rate \f$\dot e\f$ of the energy density along a section.
template <class S, int n, int N, class Medium>
S energy_rate(Medium const& medium, SecondJet<S, n, N> const& j) {
  auto const moved = along(j, 0);
  auto const x = moved.particle();
  auto const here = medium.G(x);
  auto const there = medium.g(moved.y);
  return (volume<Dual<S>>(here) * medium.rho(x) *
          (inner(there, moved.velocity(), moved.velocity()) / S(2) +
           medium.W(x, here, there, moved.gradient())))
      .part[0];
}

/// \f$\sqrt{\det G}\,\mathrm{DIV}\f$ of a vector field on the body along a section: a callable on first jets.
template <class Metric, class S, int n, int N, class Field>
S weighted_divergence(Metric const& G, SecondJet<S, n, N> const& j, Field const& field) {
  S sum(0);
  for (int k = 1; k <= n; ++k) {
    auto const moved = along(j, k);
    sum += (volume<Dual<S>>(G(moved.particle())) * field(moved)[k - 1]).part[0];
  }
  return sum;
}
/// \f$\mathcal P_a{}^j\dot\phi^a\f$, the power that the stress brings.
template <class Medium>
auto power_of_stress(Medium const& medium) {
  return [&medium]<class T, int n, int N>(Jet<T, n, N> const& j) {
    return Matrix<T, n, 1>(first_piola_kirchhoff_stress(medium, j).transpose() * j.velocity());
  };
}
/// \f$J\,(F^{-1})^j{}_a\dot\phi^a\f$, what a pressure is multiplied with.
template <class Medium, class T, int n>
Matrix<T, n, 1> carried_velocity(Medium const& medium, Jet<T, n, n> const& j) {
  auto const J = jacobian(medium.G(j.particle()), medium.g(j.y), j.gradient());
  return solve_linear(j.gradient(), j.velocity()) * J;
}

/// The power that stress and pressure of an incompressible medium bring, or one of them.
template <class Medium>
struct PowerOfBoth {
  Medium const& medium;
  bool stress, pressure;
  template <class T, int n, int M>
  Matrix<T, n, 1> operator()(Jet<T, n, M> const& jet) const {
    auto const below = deformation(jet);
    Matrix<T, n, 1> sum = Matrix<T, n, 1>::Zero();
    if (stress) sum += power_of_stress(medium)(below);
    if (pressure) sum -= carried_velocity(medium, below) * multiplier_pressure(medium.G, jet);
    return sum;
  }
};

/// The second jet of an extended section with J = 1 there and no rate of J, by stretching the first axis of
/// the body and its velocity.
template <class Medium, class S, int n>
SecondJet<S, n, n + 1> volume_held(Medium const& medium, SecondJet<S, n, n + 1> j) {
  auto const volume_of = [&](auto const& jet) {
    auto const below = deformation(jet);
    return jacobian(medium.G(below.particle()), medium.g(below.y), below.gradient());
  };
  S const J = volume_of(static_cast<Jet<S, n, n + 1> const&>(j));
  for (int a = 0; a < n; ++a) j.v(a, 1) = j.v(a, 1) / J;
  S const rate = volume_of(along(j, 0)).part[0];
  for (int a = 0; a < n; ++a) {
    j.w[0](a, 1) -= j.v(a, 1) * rate;
    j.w[1](a, 0) = j.w[0](a, 1);
  }
  return j;
}

}  // namespace

STATEMENT(claim_9_2_time_invariance, "time translation and the two Lagrangian densities") {
  claim.holds("Mass, metrics and energy are those of the body and do not depend on time.");
  over_points(claim, PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    auto const j = draw_jet<S, n, n + 1>(draw);
    auto const below = deformation(j);
    auto const tau = draw.number<S>();
    auto const later = [&](auto const& x) {
      auto moved = x;
      moved[0] += ScalarOf<decltype(x)>(tau);
      return moved;
    };
    for (Kind const kind : {Kind::any, Kind::isentropic, Kind::solid}) {
      auto const medium = draw_medium<S, n>(draw, kind);
      auto const held = incompressible(medium);
      claim.zero("(6.3)", model, equivariance_rate(medium, TimeTranslation{}, below), medium(below));
      claim.zero("(8.3)", model, equivariance_rate(held, TimeTranslation{}, j), held(j));
      claim.zero("(6.3), a finite time", model,
                 equivariance_defect(medium, Automorphism{later, FixedFibre<n>{}}, below), medium(below));
      claim.zero("(8.3), a finite time", model,
                 equivariance_defect(held, Automorphism{later, FixedFibre<n + 1>{}}, j), held(j));
      claim.refutes("a medium that ages", model,
                    equivariance_rate(Ageing<AnyContinuum<S, n>>{medium}, TimeTranslation{}, below),
                    medium(below));
    }
  });
}

STATEMENT(claim_9_2_time_current, "Noether current of time translation") {
  claim.holds("With the energy density of (6.5), which has $\\sqrt{\\det G}$ in it already. For any medium.");
  over_points(claim, BodiesInSpace{}, [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
    auto const medium = draw_medium<S, n, N>(draw, Kind::any);
    auto const j = draw_jet<S, n, N>(draw);
    auto const current = noether_current(medium, TimeTranslation{}, j);
    Event<S, n> energy = energy_current(medium, j);
    // Ten more roundings: kinetic and stored energy, summed in different orders.
    claim.equal("minus the current of energy", model, current, (-energy).eval(), 10);
    energy[0] *= volume<S>(medium.G(j.particle()));
    claim.differs("with the volume of the body once more", model, current, (-energy).eval());
    energy = -energy_current(medium, j);
    energy[0] = -energy[0];
    claim.differs("the other sign of the energy density", model, current, energy);
  });
}

STATEMENT(claim_9_2_fluid_energy, "energy continuity of a barotropic fluid") {
  claim.holds(
      "Along solutions; off shell the two sides differ by $\\dot\\phi^aE_a$. DIV is $\\frac1{\\sqrt{\\det "
      "G}}\\partial_j(\\sqrt{\\det G}\\;\\cdot^{\\,j})$.");
  over_points(claim, PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    auto const fluid = draw_medium<S, n>(draw, Kind::fluid);
    auto const off = draw_second_jet<S, n, n>(draw);
    auto const on = of_a_solution(fluid, off);
    // sqrt(det G) DIV(P J F^-1 phidot), by its components.
    auto const flux = [&](auto const& jet) {
      return (carried_velocity(fluid, jet) * material_pressure(fluid, jet)).eval();
    };
    auto const transposed = [&]<class T>(Jet<T, n, n> const& jet) {
      T const J = jacobian(fluid.G(jet.particle()), fluid.g(jet.y), jet.gradient());
      Matrix<T, n, n> const turned = jet.gradient().transpose();
      return (solve_linear(turned, jet.velocity()) * T(J * material_pressure(fluid, jet))).eval();
    };
    S const rate = energy_rate(fluid, on), outflow = weighted_divergence(fluid.G, on, flux);
    // A hundred more roundings: the acceleration is solved for, and both sides differentiate roots and
    // inverses.
    claim.equal("along solutions", model, rate, S(-outflow), 100);
    claim.equal("off shell", model, S(energy_rate(fluid, off) + weighted_divergence(fluid.G, off, flux)),
                S(-off.velocity().dot(euler_lagrange(fluid, off))), 100);
    claim.differs("the other sign", model, rate, outflow);
    claim.differs("the inverse transposed", model, rate, S(-weighted_divergence(fluid.G, on, transposed)));
    claim.differs("without the volume of the body", model, rate,
                  S(-outflow / volume<S>(fluid.G(on.particle()))));
  });
}

STATEMENT(claim_9_2_elastic_energy, "energy continuity of standard elasticity") {
  claim.holds("For any stored energy $W(x, G, g, F)$, along solutions; rods, shells and bodies in space.");
  over_points(claim, BodiesInSpace{}, [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
    auto const off = draw_second_jet<S, n, N>(draw);
    for (Kind const kind : {Kind::any, Kind::solid}) {
      auto const medium = draw_medium<S, n, N>(draw, kind);
      auto const on = of_a_solution(medium, off);
      auto const flux = power_of_stress(medium);
      S const rate = energy_rate(medium, on), inflow = weighted_divergence(medium.G, on, flux);
      // A hundred more roundings: the acceleration is solved for from second derivatives of the energy.
      claim.equal("along solutions", model, rate, inflow, 100);
      claim.equal("off shell", model, S(energy_rate(medium, off) - weighted_divergence(medium.G, off, flux)),
                  S(-off.velocity().dot(euler_lagrange(medium, off))), 100);
      claim.differs("the other sign", model, rate, S(-inflow));
      claim.differs("without the volume of the body", model, rate,
                    S(inflow / volume<S>(medium.G(on.particle()))));
    }
  });
}

STATEMENT(claim_9_2_energy_incompressible, "energy continuity of incompressible fluids and solids") {
  claim.convention(
      "The text says that the expressions are similar. They are: the stress brings the power $\\mathcal "
      "P_a{}^j\\dot\\phi^a$, the pressure of the multiplier takes $P\\,((\\partial\\phi/\\partial "
      "x)^{-1})^j_a\\,\\dot\\phi^a$, and the energy is that of the medium without the constraint. Along "
      "solutions with $J=1$, in metrics whose volume varies along the motion.");
  over_points(claim, PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    for (Kind const kind : {Kind::dust, Kind::solid}) {
      std::string const what = model + (kind == Kind::dust ? ", ideal fluid" : ", solid");
      auto const medium = draw_medium<S, n>(draw, kind);
      auto const density = incompressible(medium);
      auto const held = volume_held(medium, draw_second_jet<S, n, n + 1>(draw));
      auto const flux = [&](SecondJet<S, n, n + 1> const& j, bool stress, bool pressure) {
        return weighted_divergence(medium.G, j, PowerOfBoth<AnyContinuum<S, n>>{medium, stress, pressure});
      };
      // On shell: the acceleration that the equations of motion want.
      auto on = held;
      Matrix<S, n, n> const inertia = medium.g(deformation(held).y) *
                                      S(volume<S>(medium.G(held.particle())) * medium.rho(held.particle()));
      Matrix<S, n + 1, 1> const forces = euler_lagrange(density, held);
      on.w[0].col(0).template head<n>() += solve_linear(inertia, Matrix<S, n, 1>(forces.template head<n>()));
      S const rate = energy_rate(medium, deformation(on)), inflow = flux(on, true, true);
      // A hundred more roundings: the acceleration is solved for, and the pressure's term has inverses.
      S const scale = inflow + flux(on, true, false) + flux(on, false, true) + S(1);
      claim.zero("along solutions", what, S(rate - inflow), scale, 100);
      claim.refutes("the pressure with the other sign", what,
                    S(rate - flux(on, true, false) + flux(on, false, true)), scale);
      claim.refutes("without the pressure", what, S(rate - flux(on, true, false)), scale);
      if (kind == Kind::solid)
        claim.refutes("without the stress", what, S(rate - flux(on, false, true)), scale);
      claim.refutes("where nothing is solved", what,
                    S(energy_rate(medium, deformation(held)) - flux(held, true, true)), scale);
    }
  });
}

STATEMENT(claim_9_2_energy_converse, "consequence of requiring a closed time-translation current") {
  claim.holds(
      "It is the one equation $\\dot\\phi^aE_a=0$, the energy continuity: it does not "
      "give back the field equations.");
  over_points(claim, std::tuple<Dimensions<2, 2>, Dimensions<3, 3>, Dimensions<1, 3>>{},
              [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
                auto const medium = draw_medium<S, n, N>(draw, Kind::any);
                auto j = draw_second_jet<S, n, N>(draw);
                Matrix<S, N, 1> const E = euler_lagrange(medium, j), v = j.velocity();
                S const divergence = current_divergence(medium, TimeTranslation{}, j);
                // A hundred more roundings: second derivatives of the energy, summed in different orders.
                claim.equal("differential of the current, off shell", model, divergence, S(v.dot(E)), 100);
                S const inflow = weighted_divergence(medium.G, j, power_of_stress(medium));
                claim.equal("it is the energy continuity", model, divergence,
                            S(inflow - energy_rate(medium, j)), 100);
                // Add to a solution an acceleration across the velocity: the current stays closed, and
                // nothing is solved.
                auto const solved = of_a_solution(medium, j);
                Matrix<S, N, 1> across = draw.vector<S, Matrix<S, N, 1>>(N);
                auto const g = medium.g(j.y);
                across -= v * S(inner(g, across, v) / inner(g, v, v));
                j.w[0].col(0) = solved.w[0].col(0) + across;
                claim.zero("closed, with a force across the velocity", model,
                           current_divergence(medium, TimeTranslation{}, j), S(v.dot(E)), 100);
                claim.refutes("closed, therefore a solution", model, euler_lagrange(medium, j), magnitude(E));
                j.w[0].col(0) = solved.w[0].col(0) + v;
                claim.refutes("with a force along the velocity", model,
                              current_divergence(medium, TimeTranslation{}, j), S(v.dot(E)));
              });
}
