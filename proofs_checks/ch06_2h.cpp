// Section 6.2: the field equations of a medium and the Cauchy stress; exact with any stored energy, and in floating point on the sphere, with real powers.
#include "fields.hpp"

#include "media.hpp"
#include "statement.hpp"

namespace {

using namespace actio;
using namespace actio::checks;

/// The unit sphere in angles: \f$d\theta^2 + \sin^2\theta\,d\varphi^2\f$.
struct Sphere {
  template <class T>
  Eigen::Matrix<T, 2, 2> operator()(Eigen::Matrix<T, 2, 1> const& y) const {
    using std::sin;
    T const s = sin(y[0]);
    Eigen::Matrix<T, 2, 2> g;
    g << T(1), T(0), T(0), s * s;
    return g;
  }
};

/// A stored energy with a real power that sees F and g other than through the Green tensor: \f$(2 + g_{11}(F^1{}_1)^2 + g_{12}F^1{}_1 + 3g_{22}F^1{}_2)^{7/5}\f$.
struct PowerOfStrain {
  template <class BodyMetric, class T>
  T operator()(Eigen::Matrix<T, 2, 1> const&, BodyMetric const&, Eigen::Matrix<T, 2, 2> const& g, Eigen::Matrix<T, 2, 2> const& F) const {
    using std::pow;
    return pow(T(g(0, 0) * F(0, 0) * F(0, 0) + g(0, 1) * F(0, 0) + g(1, 1) * F(0, 1) * Base<T>(3) + Base<T>(2)), Base<T>(Base<T>(7) / Base<T>(5)));
  }
};

/// A section on the sphere, away from its poles: theta about 1 on body and space.
template <class S>
SecondJet<S, 2, 2> draw_jet_on_sphere(Draw& draw) {
  auto const phi = draw_section<S, 2, 2>(draw, ratio<S>(1, 10));
  auto x = draw_event<S, 2>(draw);
  auto const south = [&](auto const& at) {
    auto from = at;
    from[1] -= 1;
    auto y = phi(from);
    y[0] += 1;
    return y;
  };
  x[1] += 1;
  return second_jet(south, x);
}

/// Over the rationals any medium in space, elsewhere one on the sphere.
/// @param visit  called with a medium with a general W, a fluid, a second jet, and the name of the model
template <class S, class Visit>
void over_media(Draw& draw, Visit const& visit) {
  if constexpr (is_exact<S>) {
    over_points(std::tuple<Dimensions<3, 3>>{}, [&]<class D>(D, std::string const& model) {
      auto const any = draw_medium<S, D::n>(draw, Kind::any);
      auto const fluid = draw_medium<S, D::n>(draw, Kind::fluid);
      visit(any, fluid, draw_second_jet<S, D::n>(draw), model);
    });
  } else {
    auto const rho = draw_mass<S, 2>(draw);
    visit(Continuum{Sphere{}, Sphere{}, rho, PowerOfStrain{}}, Continuum{Sphere{}, Sphere{}, rho, Barotropic{Polytropic<S>{S(2), ratio<S>(7, 5)}}},
          draw_jet_on_sphere<S>(draw), "sphere, exponent 7/5");
  }
}

/// The field equations per volume of the body, with the sign that the thesis writes them with.
template <class Medium, class S, int n>
Eigen::Matrix<S, n, 1> field_equations(Medium const& medium, SecondJet<S, n, n> const& j) {
  return euler_lagrange(medium, j) / -body_volume(medium, j);
}

}  // namespace

STATEMENT(eq_6_13, "the Euler-Lagrange equation of a continuous medium") {
  claim.holds("The derivative in $x$ is the total one and acts on the mass density too; that in $g$ is the symmetric one, summed over both indices.");
  // An energy of degree 3 in metrics of degree 4 and a section of degree 3, and inverses of metrics.
  claim.degree(160);
  over_media<S>(draw, [&]<class Medium, class Fluid, int n>(Medium const& medium, Fluid const&, SecondJet<S, n, n> const& j, std::string const& model) {
    using Column = Eigen::Matrix<S, n, 1>;
    Jet<S, n, n> const& first = j;
    Column const E = field_equations(medium, j), force = metric_force(medium, first);
    claim.equal("(6.13) and (6.12)", model, medium_equation(medium, j), E);
    claim.differs("the force with the other sign", model, (medium_equation(medium, j) + force * S(2)).eval(), E);
    auto const outside = [&](auto const& weight) {
      auto const stress = [&](auto const& jet) { return (detail::strain_derivative(medium, jet) * weight(jet)).eval(); };
      return Column(inertia(medium, j) - detail::two_point_rates(stress, j).divergence / weight(first) * S(medium.rho(j.particle())) - force);
    };
    claim.differs("the mass density outside the derivative", model, outside([&]<class T>(Jet<T, n, n> const& at) { return volume<T>(medium.G(at.particle())); }), E);
    claim.differs("without the volume of the body", model, outside([&]<class T>(Jet<T, n, n> const& at) { return T(medium.rho(at.particle())); }), E);
  });
}

STATEMENT(eq_6_14, "the Cauchy stress from the stored energy") {
  claim.convention("$W$ is per unit mass, $\\rho$ the mass per volume of the body, and the derivative in $g$ the symmetric one. $J$ stays; it disappears where $\\rho/J$, the "
                   "spatial density, is written.");
  claim.degree(120);
  over_media<S>(draw, [&]<class Medium, class Fluid, int n>(Medium const& medium, Fluid const& fluid, SecondJet<S, n, n> const& j, std::string const& model) {
    using T = Dual<S, n>;
    using Matrix = Eigen::Matrix<S, n, n>;
    Jet<S, n, n> const& first = j;
    auto const at = point_of_medium(medium, first);
    Matrix const any = draw_tangents<S, n, n>(draw), h = any + any.transpose();
    // The energy on the way from g along h.
    auto const moved = first.template cast<T>();
    Eigen::Matrix<T, n, n> g = at.g.template cast<T>();
    for (int a = 0; a < n; ++a)
      for (int b = 0; b < n; ++b) g(a, b).part[0] = h(a, b);
    S const rate = medium.W(moved.particle(), medium.G(moved.particle()), g, moved.gradient()).part[0];
    Matrix const sigma = cauchy_stress(medium, first);
    S const power = sigma.cwiseProduct(h).sum();
    claim.equal("power of the stress along a metric", model, power, S(rate * S(2) * at.rho / at.J));
    claim.differs("without J", model, power, S(rate * S(2) * at.rho));
    claim.differs("without the 2", model, power, S(rate * at.rho / at.J));
    S upper(0);
    for (int a = 0; a < n; ++a)
      for (int b = a; b < n; ++b) upper += sigma(a, b) * h(a, b);
    // Off the diagonal the derivative along one pair is twice as large.
    claim.refutes("each pair of indices once", model, S(upper - power), magnitude(sigma));
    Matrix const pressure = inverse_matrix(Matrix(fluid.g(j.y))) * S(-material_pressure(fluid, first));
    claim.equal("of a fluid, the pressure", model, cauchy_stress(fluid, first), pressure);
  });
}

STATEMENT(eq_6_18, "the Euler-Lagrange equation of a barotropic fluid") {
  claim.corrected(R"(\rho\,g_{ab}\Bigl(\frac{D_g\dot\phi}{Dt}\Bigr)^b = -\frac{\partial P}{\partial x^k}\,J\Bigl(\bigl(\tfrac{\partial\phi}{\partial x}\bigr)^{-1}\Bigr)^k)",
                  R"(\rho\,g_{ab}\Bigl(\frac{D_g\dot\phi}{Dt}\Bigr)^b = -\frac{\partial P}{\partial x^k}\,J\Bigl(\bigl(\tfrac{\partial\phi}{\partial x}\bigr)^{-1}\Bigr)^k_a)",
                  "The inverse gradient lacks its lower index $a$. Otherwise right, with a mass density that varies.");
  claim.maybe_scan();
  claim.degree(160);
  over_media<S>(draw, [&]<class Medium, class Fluid, int n>(Medium const&, Fluid const& fluid, SecondJet<S, n, n> const& j, std::string const& model) {
    using Column = Eigen::Matrix<S, n, 1>;
    Jet<S, n, n> const& first = j;
    auto const at = point_of_medium(fluid, first);
    Column const E = field_equations(fluid, j), slope = pressure_slopes(fluid, j), mass = inertia(fluid, j);
    claim.equal("(6.18) and (6.12)", model, fluid_equation(fluid, j), E);
    claim.differs("as printed, with the only index contracted", model, (mass + Column::Constant((at.inverse * slope).sum() * at.J)).eval(), E);
    claim.differs("the inverse transposed", model, (mass + at.inverse * slope * at.J).eval(), E);
    claim.differs("without J", model, (mass + at.inverse.transpose() * slope).eval(), E);
    // The pressure of a fluid of constant mass density, that at the particle.
    Fluid even = fluid;
    even.rho.added.constant = at.rho - S(2);
    for (auto* c : {&even.rho.added.a, &even.rho.added.b, &even.rho.added.d, &even.rho.added.e}) c->setZero();
    Column const level = pressure_slopes(even, j);
    claim.differs("the mass density outside the derivative", model, (mass + at.inverse.transpose() * level * at.J).eval(), E);
  });
}

STATEMENT(eq_6_20, "the equation of motion with stresses, general stored energy") {
  claim.holds("With the covariant divergence as corrected there.");
  claim.degree(160);
  over_media<S>(draw, [&]<class Medium, class Fluid, int n>(Medium const& medium, Fluid const&, SecondJet<S, n, n> const& j, std::string const& model) {
    using Column = Eigen::Matrix<S, n, 1>;
    Jet<S, n, n> const& first = j;
    auto const at = point_of_medium(medium, first);
    Column const E = field_equations(medium, j), balance = inertia(medium, j) - stress_divergence(medium, j);
    claim.equal("(6.20) and (6.12)", model, stress_equation(medium, j), E);
    claim.differs("without the symbols of space", model, balance, E);
    auto const gamma = christoffel(medium.g, j.y);
    Eigen::Matrix<S, n, n> const plus = first_piola_kirchhoff_stress(medium, first) * at.F.transpose() + at.g * cauchy_stress(medium, first) * at.J;
    Column added = balance;
    for (int a = 0; a < n; ++a)
      for (int b = 0; b < n; ++b)
        for (int c = 0; c < n; ++c) added[a] -= gamma[b](a, c) * plus(b, c);
    claim.differs("the Cauchy stress with the other sign", model, added, E);
  });
}
