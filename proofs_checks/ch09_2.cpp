// Section 9.2: translations of time and the continuity of energy.
#include "fields.hpp"

#include "actio/continuum/stresses.hpp"
#include "actio/noether/time_translation.hpp"
#include "statement.hpp"
#include "symmetries.hpp"

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

/// A medium with the stored energy of the most general form.
template <class S>
auto draw_medium(Draw& draw) {
  return Continuum{draw_metric<S, 2>(draw), draw_metric<S, 2>(draw), draw_mass<S, 2>(draw),
                   draw_energy<S, 2, 2>(draw)};
}

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

}  // namespace

STATEMENT(claim_9_2_time_invariance, "time translation and the two Lagrangian densities") {
  claim.holds("Mass, metrics and energy are those of the body and do not depend on time.");
  over_points(PlaneAndSpace{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const fluid = with_varying_mass(draw_homogeneous_fluid<S, n>(draw), draw);
    auto const j = draw_jet<S, n, n + 1>(draw);
    auto const below = deformation(j);
    claim.zero("barotropic fluid", model, equivariance_rate(fluid, TimeTranslation{}, below), fluid(below));
    claim.zero("incompressible fluid", model, equivariance_rate(incompressible(fluid), TimeTranslation{}, j),
               fluid(below));
    claim.refutes("a medium that ages", model,
                  equivariance_rate(Ageing<AnyFluid<S, n>>{fluid}, TimeTranslation{}, below), fluid(below));
  });
}

STATEMENT(claim_9_2_time_current, "Noether current of time translation") {
  claim.holds("With the energy density of (6.5), which has $\\sqrt{\\det G}$ in it already.");
  over_points(PlaneAndSpace{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const fluid = with_varying_mass(draw_homogeneous_fluid<S, n>(draw), draw);
    auto const j = draw_jet<S, n, n>(draw);
    auto const current = noether_current(fluid, TimeTranslation{}, j);
    Event<S, n> energy = energy_current(fluid, j);
    claim.equal("minus the current of energy", model, current, (-energy).eval(), 10);
    energy[0] *= volume<S>(fluid.G(j.particle()));
    claim.differs("with the volume of the body once more", model, current, (-energy).eval());
    energy = -energy_current(fluid, j);
    energy[0] = -energy[0];
    claim.differs("the other sign of the energy density", model, current, energy);
  });
}

STATEMENT(claim_9_2_fluid_energy, "energy continuity of a barotropic fluid") {
  claim.holds(
      "Along solutions; off shell the two sides differ by $\\dot\\phi^aE_a$. DIV is $\\frac1{\\sqrt{\\det "
      "G}}\\partial_j(\\sqrt{\\det G}\\;\\cdot^{\\,j})$.");
  over_points(PlaneAndSpace{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const fluid = with_varying_mass(draw_homogeneous_fluid<S, n>(draw), draw);
    auto const off = draw_second_jet<S, n, n>(draw);
    auto const on = of_a_solution(fluid, off);
    // sqrt(det G) DIV(P J F^-1 phidot), by its components.
    auto const outflow = [&](SecondJet<S, n, n> const& j) {
      S sum(0);
      for (int k = 1; k <= n; ++k) {
        auto const moved = along(j, k);
        auto const here = fluid.G(moved.particle());
        auto const there = fluid.g(moved.y);
        Matrix<Dual<S>, n, 1> const pulled = solve_linear(moved.gradient(), moved.velocity());
        sum += (volume<Dual<S>>(here) * material_pressure(fluid, moved) *
                jacobian(here, there, moved.gradient()) * pulled[k - 1])
                   .part[0];
      }
      return sum;
    };
    claim.equal("along solutions", model, energy_rate(fluid, on), S(-outflow(on)), 100);
    claim.equal("off shell", model, S(energy_rate(fluid, off) + outflow(off)),
                S(-off.velocity().dot(euler_lagrange(fluid, off))), 100);
    claim.differs("the other sign", model, energy_rate(fluid, on), outflow(on));
  });
}

STATEMENT(claim_9_2_elastic_energy, "energy continuity of standard elasticity") {
  claim.holds("For any stored energy $W(x, G, g, F)$, along solutions.");
  {
    std::string const model = "n = 2, N = 2";
    auto const medium = draw_medium<S>(draw);
    auto const off = draw_second_jet<S, 2, 2>(draw);
    auto const on = of_a_solution(medium, off);
    auto const outflow = [&](SecondJet<S, 2, 2> const& j) {
      S sum(0);
      for (int k = 1; k <= 2; ++k) {
        auto const moved = along(j, k);
        sum += (volume<Dual<S>>(medium.G(moved.particle())) *
                first_piola_kirchhoff_stress(medium, moved).col(k - 1).dot(moved.velocity()))
                   .part[0];
      }
      return sum;
    };
    claim.equal("along solutions", model, energy_rate(medium, on), outflow(on), 100);
    claim.equal("off shell", model, S(energy_rate(medium, off) - outflow(off)),
                S(-off.velocity().dot(euler_lagrange(medium, off))), 100);
    claim.differs("the other sign", model, energy_rate(medium, on), S(-outflow(on)));
  }
}

STATEMENT(claim_9_2_energy_converse, "consequence of requiring a closed time-translation current") {
  claim.holds(
      "It is the one equation $\\dot\\phi^aE_a=0$, the energy continuity: it does not give back the field "
      "equations.");
  {
    std::string const model = "n = 2, N = 2";
    auto const medium = draw_medium<S>(draw);
    auto j = draw_second_jet<S, 2, 2>(draw);
    Matrix<S, 2, 1> const E = euler_lagrange(medium, j);
    claim.equal("differential of the current, off shell", model,
                current_divergence(medium, TimeTranslation{}, j), S(j.velocity().dot(E)), 100);
    // Add to a solution an acceleration across the velocity: the current stays closed, and nothing is solved.
    auto const solved = of_a_solution(medium, j);
    Matrix<S, 2, 1> const covector = lowered(medium.g(j.y), j.velocity());
    j.w[0].col(0) = solved.w[0].col(0) + Matrix<S, 2, 1>(-covector[1], covector[0]);
    claim.zero("closed, with a force across the velocity", model,
               current_divergence(medium, TimeTranslation{}, j), S(j.velocity().dot(E)), 100);
    claim.refutes("closed, therefore a solution", model, euler_lagrange(medium, j), magnitude(E));
  }
}
