// Scalars: rational (long: double)
// Section 8.3: the ideal incompressible fluid as space sees it, and as the body does.
#include "incompressible_models.hpp"

#include "statement.hpp"

namespace {

using namespace actio;
using namespace actio::checks;

/// The material acceleration of a motion, a field along it.
template <class Metric, class Phi>
struct AccelerationOf {
  Metric g;
  Phi phi;
  template <class V>
  auto operator()(V const& x) const {
    return material_acceleration(g, second_jet(phi, x));
  }
};
template <class Metric, class Phi>
AccelerationOf(Metric, Phi) -> AccelerationOf<Metric, Phi>;

/// The point (t, y) at which a jet is.
template <class S, int n>
Event<S, n> event_in_space(Jet<S, n, n> const& j) {
  Event<S, n> at;
  at << j.x[0], j.y;
  return at;
}

}  // namespace

STATEMENT(claim_8_3_euler_equations, "the fluid as space sees it") {
  claim.holds("$(u\\cdot\\nabla)u$ is covariant, and so is the divergence.");
  claim.degree(5 * degree_of_fields);
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const phi = draw_shears<S, n>(draw);
    VelocityInSpace<S, n> const u{phi};
    auto const any = draw_metric<S, n>(draw), unimodular = draw_unimodular_metric<S, n>(draw);
    auto const j = second_jet(phi, draw_event<S, n>(draw));
    Event<S, n> const at = event_in_space(j);
    auto const rate = velocity_gradient(any, u, at);
    claim.equal("the acceleration of the particle", model, eulerian_acceleration(any, u, at), material_acceleration(any, j));
    auto const flat = first_jet(u, at);
    claim.differs("with derivatives that are not covariant", model, (flat.velocity() + flat.gradient() * flat.y).eval(), material_acceleration(any, j));
    VolumeConstraint const held{unimodular, unimodular}, free{any, any};
    claim.zero("divergence where the volume is held", model, divergence(unimodular, u, at), size_of(rate.slope));
    S const J = free.volume_ratio(static_cast<Jet<S, n, n> const&>(j)), J_rate = free.volume_ratio(along(j, 0)).part[0];
    claim.equal("the rate of the volume", model, J_rate, S(J * divergence(any, u, at)));
    claim.refutes("divergence where it is not", model, divergence(any, u, at), size_of(rate.slope));
    claim.zero("and the volume there", model, held(static_cast<Jet<S, n, n> const&>(j))[0], S(1));
  });
}

STATEMENT(claim_8_3_two_descriptions_agree, "one fluid, seen from the body and as a curve of diffeomorphisms") {
  claim.convention("Body and space are one Riemannian manifold, mass is 1, and the motion begins at the identity: then $J = 1$ says that it stays in $\\mathcal D_\\mu$.");
  claim.degree(5 * degree_of_fields);
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
    Eigen::Matrix<S, n, 1> const y = at.template tail<n>();
    auto const in_space = lowered(g(y), Eigen::Matrix<S, n, 1>(eulerian_acceleration(g, VelocityInSpace<S, n>{phi}, at) + gradient(g, p, at)));
    claim.equal("field equations on the body, and Euler's in space", model, residual_on_body(g, x), in_space);
    claim.differs("a body with another volume", model, residual_on_body(draw_metric<S, n>(draw), x), in_space);
  });
}

STATEMENT(claim_8_3_material_divergence, "from the equation of motion on the body to that of the pressure") {
  claim.corrected("\\mathrm{div}\\text{ of both sides of (8.11)}", "(F^{-1})^k{}_a\\,\\nabla_k\\Bigl(\\frac{D_g\\dot\\phi}{Dt}\\Bigr)^a = -(\\Delta p)\\circ\\phi",
                  "(8.11) is an equation between vectors of space at points of the body: compose with $\\phi_t^{-1}$ first. Differentiated in x without $F^{-1}$ it gives another number.");
  claim.degree(5 * degree_of_fields);
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
    Eigen::Matrix<S, n, n> slope = rate.gradient();
    auto const gamma = christoffel(g, j.y);
    for (int a = 0; a < n; ++a) slope.row(a) += (j.gradient().transpose() * (gamma[a] * rate.y)).transpose();
    S const spatial = (inverse_matrix(j.gradient()) * slope).trace(), source = pressure_source(g, u, event_in_space(j));
    claim.zero("with the inverse deformation gradient", model, S(spatial + source), size_of(slope) + S(1));
    // Indices of body and space identified, and the metric taken at the particle.
    S const material = divergence(g, acceleration, x);
    claim.refutes("the divergence on the body", model, S(material + source), size_of(slope) + S(1));
  });
}
