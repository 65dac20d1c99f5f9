// Scalars: rational (long: double)
// Section 6.2: momenta, pressure, stress and metric force of a barotropic fluid.
#include "fields.hpp"

#include "media.hpp"
#include "statement.hpp"

namespace {

using namespace actio;
using namespace actio::checks;

/// \f$g^{bc}\,\partial g_{bc}/\partial y^a\f$.
template <class Metric, class S, int n>
Eigen::Matrix<S, n, 1> logarithmic_slopes(Metric const& g, Eigen::Matrix<S, n, 1> const& y) {
  auto const rates = metric_derivatives(g, y);
  Eigen::Matrix<S, n, n> const inverse = inverse_matrix(as_matrix<S>(g(y)));
  Eigen::Matrix<S, n, 1> slope;
  for (int a = 0; a < n; ++a) slope[a] = inverse.cwiseProduct(rates[a]).sum();
  return slope;
}

}  // namespace

STATEMENT(claim_6_2_barotropic_momenta, "the spatial momenta of a barotropic fluid") {
  claim.holds();
  // A law of degree 3 in a Jacobian of degree 8 over another.
  claim.degree(80);
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const fluid = draw_medium<S, n>(draw, Kind::fluid);
    Jet<S, n, n> const j = draw_jet<S, n, n>(draw);
    auto const at = point_of_medium(fluid, j);
    Eigen::Matrix<S, n, n> const p = momenta(fluid, j).template rightCols<n>();
    Dual<S> J = at.J;
    J.part[0] = S(1);
    S const factor = -at.rho * fluid.W.w(J).part[0] * at.J * body_volume(fluid, j);
    claim.equal("by the chain rule", model, p, (at.inverse.transpose() * factor).eval());
    claim.differs("the inverse transposed", model, p, (at.inverse * factor).eval());
    claim.differs("the other sign", model, p, (at.inverse.transpose() * -factor).eval());
  });
}

STATEMENT(eq_6_16, "the material pressure from the stored energy") {
  claim.holds("With the density of space $\\rho/J$ it is the pressure of thermodynamics, the square of that density times the derivative of $W$ in it.");
  claim.degree(60);
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const fluid = draw_medium<S, n>(draw, Kind::fluid);
    Jet<S, n, n> const j = draw_jet<S, n, n>(draw);
    auto const at = point_of_medium(fluid, j);
    Dual<S> density = at.rho / at.J;
    density.part[0] = S(1);
    S const slope = fluid.W.w(Dual<S>(at.rho) / density).part[0], P = material_pressure(fluid, j);
    claim.equal("the pressure of thermodynamics", model, P, S(density.value * density.value * slope));
    claim.differs("with the density of the body", model, P, S(at.rho * at.rho * slope));
    claim.differs("the other sign", model, P, S(-density.value * density.value * slope));
  });
}

STATEMENT(claim_6_2_barotropic_stress, "the Cauchy stress of a barotropic fluid") {
  claim.holds("With the symmetric derivative in $g$, of which $J$ has half of $J$ times the inverse of $g$.");
  claim.degree(100);
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const fluid = draw_medium<S, n>(draw, Kind::fluid);
    Jet<S, n, n> const j = draw_jet<S, n, n>(draw);
    auto const at = point_of_medium(fluid, j);
    S const P = material_pressure(fluid, j);
    auto const sigma = cauchy_stress(fluid, j);
    Eigen::Matrix<S, n, n> const up = inverse_matrix(at.g) * P;
    claim.equal("minus the pressure times the metric", model, sigma, (-up).eval());
    claim.differs("plus the pressure", model, sigma, up);
    claim.differs("a factor J left over", model, sigma, (up * -at.J).eval());
    claim.differs("lower indices", model, sigma, (at.g * -P).eval());
  });
}

STATEMENT(claim_6_2_metric_force, "the force of the metric on a barotropic fluid") {
  claim.holds();
  claim.degree(100);
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const fluid = draw_medium<S, n>(draw, Kind::fluid);
    Jet<S, n, n> const j = draw_jet<S, n, n>(draw);
    auto const at = point_of_medium(fluid, j);
    auto const force = metric_force(fluid, j);
    Eigen::Matrix<S, n, 1> const right = logarithmic_slopes(fluid.g, j.y) * S(material_pressure(fluid, j) * at.J / S(2));
    claim.equal("by the pressure", model, force, right);
    claim.differs("the other sign", model, force, (-right).eval());
    claim.differs("without the half", model, force, (right * S(2)).eval());
    auto other = fluid;
    other.g = draw_metric<S, n>(draw);
    claim.differs("with the symbols of another metric", model, force, metric_force(other, j));
  });
}

STATEMENT(claim_6_2_barotropic_spatial_form, "the barotropic equation with spatial density and spatial pressure") {
  claim.holds("Motions of a fluid have an inverse; the spatial density is $\\rho/J$ carried to the particle, and the gradient is that of $g$.");
  claim.degree(200);
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    using T = Dual<S, n>;
    using Column = Eigen::Matrix<S, n, 1>;
    auto const fluid = draw_medium<S, n>(draw, Kind::fluid);
    auto const phi = draw_section<S, n, n>(draw);
    auto const x = draw_event<S, n>(draw);
    auto const j = second_jet(phi, x);
    auto const at = point_of_medium(fluid, j);
    // The particles at the places y + e_a, to first order, at the same time; and the pressure of them, as a function on space.
    Event<T, n> particles = x.template cast<T>();
    for (int i = 0; i < n; ++i)
      for (int a = 0; a < n; ++a) particles[i + 1].part[a] = at.inverse(i, a);
    auto const jets = first_jet(phi, particles);
    Eigen::Matrix<S, n, n> moved;
    for (int b = 0; b < n; ++b)
      for (int a = 0; a < n; ++a) moved(b, a) = jets.y[b].part[a];
    claim.equal("those are the particles there", model, moved, Eigen::Matrix<S, n, n>(Eigen::Matrix<S, n, n>::Identity()), n);
    T const p = detail::pressure(fluid, jets);
    Column slope;
    for (int a = 0; a < n; ++a) slope[a] = p.part[a];

    Column const gradient = raised(at.g, slope), wrong = raised(at.G, slope);
    Column const A = material_acceleration(fluid.g, j), E = raised(at.g, Column(euler_lagrange(fluid, j) / body_volume(fluid, j)));
    S const density = at.rho / at.J;
    claim.equal("the field equations over rho", model, (E / -at.rho).eval(), (A + gradient / density).eval());
    claim.differs("the density of the body", model, (E / -at.rho).eval(), (A + gradient / at.rho).eval());
    claim.differs("the gradient of the other metric", model, (E / -at.rho).eval(), (A + wrong / density).eval());
  });
}
