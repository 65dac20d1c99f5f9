// Scalars: rational (long: double)
// Section 9.1: the relabelling currents of the two fluids, their differentials and what these say.
#include "fields.hpp"

#include "actio/jets/stresses.hpp"
#include "statement.hpp"
#include "symmetries.hpp"

namespace {

using namespace actio;
using namespace actio::checks;

/// A homogeneous fluid, a field that preserves the volume of its body, and the second jet of a section with multiplier that solves nothing.
template <class S, int n>
struct FlowingFluid {
  AnyFluid<S, n> fluid;
  PotentialField<S, n> xi;
  SecondJet<S, n, n + 1> extended;
  SecondJet<S, n, n> j;
  Eigen::Matrix<S, n, 1> field;  ///< value of xi at the particle
  S rho, root;                   ///< density, volume of the body's metric

  explicit FlowingFluid(Draw& draw)
      : fluid(draw_homogeneous_fluid<S, n>(draw)),
        xi(draw_relabelling<S, n>(fluid.G, draw)),
        extended(draw_second_jet<S, n, n + 1>(draw)),
        j(deformation(extended)),
        field(xi(j.particle())),
        rho(fluid.rho(j.particle())),
        root(volume<S>(fluid.G(j.particle()))) {}

  Event<S, n> current() const { return noether_current(fluid, relabelling_field<n>(xi), first(j)); }
  Event<S, n> incompressible_current() const { return noether_current(ideal(fluid), density_relabelling_field<n + 1>(xi), first(extended)); }
  S divergence() const { return current_divergence(fluid, relabelling_field<n>(xi), j); }
  S incompressible_divergence() const { return current_divergence(ideal(fluid), density_relabelling_field<n + 1>(xi), extended); }

  /// The inertia \f$g_{ab}(D_g\dot\phi/Dt)^b\,\phi^a{}_{,k}\f$.
  Eigen::Matrix<S, n, 1> inertia() const { return j.gradient().transpose() * lowered(fluid.g(j.y), material_acceleration(fluid.g, j)); }
  /// The derivatives of the pressure of the barotropic fluid in the coordinates of the body.
  Eigen::Matrix<S, n, 1> pressure_slope() const {
    Eigen::Matrix<S, n, 1> slope;
    for (int k = 0; k < n; ++k) slope[k] = detail::pressure(fluid, along(j, k + 1)).part[0];
    return slope;
  }
  S J() const { return jacobian(fluid.G(j.particle()), fluid.g(j.y), j.gradient()); }
  /// \f$-\sqrt{\det G}\,\xi^kf_k\f$.
  S against(Eigen::Matrix<S, n, 1> const& force) const { return -root * field.dot(force); }
};

}  // namespace

STATEMENT(eq_9_8, "relabelling current of a barotropic fluid") {
  claim.holds();
  claim.degree(80);
  over_points(PlaneAndSpace{}, [&]<class D>(D, std::string const& model) {
    FlowingFluid<S, D::n> const flow(draw);
    auto const printed = barotropic_relabelling_current(flow.fluid, flow.field, first(flow.j));
    claim.equal("(9.8) is the current of (9.7), by its components", model, printed, flow.current(), 10);
    auto turned = printed, light = printed;
    turned[0] = -turned[0], light[0] = light[0] / flow.rho;
    claim.differs("mass left out of the time component", model, light, flow.current());
    claim.differs("the other sign of the time component", model, turned, flow.current());
  });
}

STATEMENT(claim_9_1_barotropic_current_space, "spatial components of the barotropic relabelling current") {
  claim.holds();
  claim.degree(80);
  over_points(PlaneAndSpace{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    FlowingFluid<S, n> const flow(draw);
    S const kinetic = flow.rho * inner(flow.fluid.g(flow.j.y), flow.j.velocity(), flow.j.velocity()) / S(2);
    S const energy = flow.rho * flow.fluid.W.w(flow.J()), push = detail::pressure(flow.fluid, first(flow.j)) * flow.J();
    Eigen::Matrix<S, n, 1> const space = flow.current().template tail<n>();
    claim.equal("kinetic less stored energy less PJ", model, space, (flow.field * S((kinetic - energy - push) * flow.root)).eval(), 10);
    claim.differs("PJ left out", model, space, (flow.field * S((kinetic - energy) * flow.root)).eval());
    claim.differs("PJ added", model, space, (flow.field * S((kinetic - energy + push) * flow.root)).eval());
  });
}

STATEMENT(claim_9_1_barotropic_current_time, "time component of the barotropic relabelling current") {
  claim.holds();
  claim.degree(80);
  over_points(PlaneAndSpace{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    FlowingFluid<S, n> const flow(draw);
    Eigen::Matrix<S, n, 1> const pushed_field = flow.j.gradient() * flow.field;
    S const momentum = inner(flow.fluid.g(flow.j.y), flow.j.velocity(), pushed_field) * flow.root;
    claim.equal("minus the momentum along the field", model, flow.current()[0], S(-flow.rho * momentum), 10);
    claim.differs("without the density", model, flow.current()[0], S(-momentum));
    claim.differs("without the volume of the body", model, flow.current()[0], S(-flow.rho * momentum / flow.root));
  });
}

STATEMENT(claim_9_1_barotropic_current_differential, "exterior derivative of the barotropic relabelling current") {
  claim.corrected("g_{ab}\\left(\\frac{D_g\\dot\\phi}{Dt}\\right)^b=-\\frac{\\partial P}{\\partial x^k}\\,J\\left(\\left(\\frac{\\partial\\phi}{\\partial x}\\right)^{-1}\\right)_a^k",
                  "\\rho\\,g_{ab}\\left(\\frac{D_g\\dot\\phi}{Dt}\\right)^b=-\\frac{\\partial P}{\\partial x^k}\\,J\\left(\\left(\\frac{\\partial\\phi}{\\partial x}\\right)^{-1}\\right)_a^k",
                  "The density is missing: print holds for $\\rho=1$. The differential is $-\\sqrt{\\det G}\\,\\xi^k\\bigl(\\rho\\,g_{ab}(D_g\\dot\\phi/Dt)^b\\phi^a{}_{,k}+J\\,\\partial_kP\\bigr)d^{n+1}x$; closed at a point for all divergence-free fields it gives back the field equations there, since F is invertible.");
  claim.degree(120);
  over_points(PlaneAndSpace{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    FlowingFluid<S, n> const flow(draw);
    Eigen::Matrix<S, n, 1> const push = flow.pressure_slope() * flow.J(), inertia = flow.inertia();
    // Second derivatives of W and of two metrics.
    claim.equal("differential of (9.8), off shell", model, flow.divergence(), flow.against(inertia * flow.rho + push), 100);
    claim.differs("printed: the density left out", model, flow.divergence(), flow.against(inertia + push));
    // Several fields recover the Euler-Lagrange derivative.
    Eigen::Matrix<S, n, n> fields;
    Eigen::Matrix<S, n, 1> differentials;
    for (int i = 0; i < n; ++i) {
      auto const xi = draw_relabelling<S, n>(flow.fluid.G, draw);
      fields.row(i) = xi(flow.j.particle()).transpose();
      differentials[i] = current_divergence(flow.fluid, relabelling_field<n>(xi), flow.j);
    }
    Eigen::Matrix<S, n, 1> const recovered = solve_linear((fields * flow.j.gradient().transpose()).eval(), differentials);
    claim.equal("n fields give the field equations back", model, recovered, euler_lagrange(flow.fluid, flow.j), 1000);
    auto const varying = with_varying_mass(flow.fluid, draw);
    claim.differs("mass that varies", model, current_divergence(varying, relabelling_field<n>(flow.xi), flow.j),
                  S(flow.field.dot((flow.j.gradient().transpose() * euler_lagrange(varying, flow.j)).eval())));
  });
}

STATEMENT(eq_9_9, "relabelling current of an incompressible fluid") {
  claim.convention("The constant stored energy is put to zero; another one would add a closed form. It holds off shell too: $\\lambda(J-1)-\\lambda J=-\\lambda$.");
  claim.degree(80);
  over_points(PlaneAndSpace{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    FlowingFluid<S, n> const flow(draw);
    S const P = flow.extended.y[n] / flow.root;
    auto const body = flow.fluid.G(flow.j.particle());
    auto const space = flow.fluid.g(flow.j.y);
    auto const printed = [&](S const& pressure) { return incompressible_relabelling_current(body, space, flow.rho, pressure, flow.field, first(flow.j)); };
    claim.equal("(9.9) is the current of (9.7), by its components", model, printed(P), flow.incompressible_current(), 10);
    claim.differs("PJ in place of P", model, printed(S(P * flow.J())), flow.incompressible_current());
  });
}

STATEMENT(claim_9_1_incompressible_current_differential, "exterior derivative of the incompressible relabelling current") {
  claim.corrected("g_{ab}\\left(\\frac{D_g\\dot\\phi}{Dt}\\right)^b=-\\frac{\\partial P}{\\partial x^k}\\left(\\left(\\frac{\\partial\\phi}{\\partial x}\\right)^{-1}\\right)_a^k",
                  "\\rho\\,g_{ab}\\left(\\frac{D_g\\dot\\phi}{Dt}\\right)^b=-\\frac{\\partial P}{\\partial x^k}\\left(\\left(\\frac{\\partial\\phi}{\\partial x}\\right)^{-1}\\right)_a^k",
                  "The density is missing: print holds for $\\rho=1$. That there is no J is right, constraint or not.");
  claim.degree(120);
  over_points(PlaneAndSpace{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    FlowingFluid<S, n> const flow(draw);
    auto const push = pressure_gradient(flow.fluid.G, flow.extended);
    auto const inertia = flow.inertia();
    claim.equal("differential of (9.9), off shell", model, flow.incompressible_divergence(), flow.against(inertia * flow.rho + push), 100);
    claim.differs("printed: the density left out", model, flow.incompressible_divergence(), flow.against(inertia + push));
    claim.differs("a factor J with the pressure", model, flow.incompressible_divergence(), flow.against(inertia * flow.rho + push * flow.J()));
  });
}

STATEMENT(claim_9_1_constraint_from_current, "constraint and the vanishing of the current differential") {
  claim.holds("A motion whose volumes change has closed currents for all fields once its acceleration fits the pressure.");
  claim.degree(120);
  over_points(PlaneAndSpace{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    FlowingFluid<S, n> flow(draw);
    // Let the acceleration be what makes every current closed; the volumes do what they do.
    Eigen::Matrix<S, n, 1> const excess = flow.inertia() * flow.rho + pressure_gradient(flow.fluid.G, flow.extended);
    Eigen::Matrix<S, n, n> const inertia = flow.j.gradient().transpose() * as_matrix<S>(flow.fluid.g(flow.j.y)) * flow.rho;
    S const before = flow.incompressible_divergence();
    flow.extended.w[0].template topRows<n>().col(0) -= solve_linear(inertia, excess);
    claim.zero("the current is closed", model, flow.incompressible_divergence(), before, 1000);
    claim.refutes("closed, therefore J = 1", model, S(flow.J() - S(1)), S(1));
  });
}
