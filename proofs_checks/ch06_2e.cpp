// Scalars: rational (long: double)
// Section 6.2: the first Piola-Kirchhoff stress, and elasticity.
#include "fields.hpp"

#include "media.hpp"
#include "statement.hpp"

namespace {

using namespace actio;
using namespace actio::checks;

}  // namespace

STATEMENT(eq_6_19, "the first Piola-Kirchhoff stress from the stored energy") {
  claim.holds();
  // An energy of degree 3 in metrics of degree 4 and a section of degree 3.
  claim.degree(60);
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    using T = Dual<S, n>;
    auto const medium = draw_medium<S, n>(draw, Kind::any);
    Jet<S, n, n> const j = draw_jet<S, n, n>(draw);
    auto const H = draw_tangents<S, n, n>(draw);
    // The energy per volume of the body on the way from F along H.
    auto moved = j.template cast<T>();
    for (int a = 0; a < n; ++a)
      for (int i = 0; i < n; ++i) moved.v(a, i + 1).part[0] = H(a, i);
    Eigen::Matrix<T, n, 1> const x = moved.particle();
    S const rate = medium.W(x, medium.G(x), medium.g(moved.y), moved.gradient()).part[0];
    S const power = first_piola_kirchhoff_stress(medium, j).cwiseProduct(H).sum();
    claim.equal("the power of the stress", model, power, S(rate * medium.rho(j.particle())));
    claim.differs("without the mass density", model, power, rate);
  });
}

STATEMENT(claim_6_2_piola_momenta, "the stress and the spatial momenta") {
  claim.holds();
  claim.degree(60);
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const medium = draw_medium<S, n>(draw, Kind::any);
    Jet<S, n, n> const j = draw_jet<S, n, n>(draw);
    Eigen::Matrix<S, n, n> const p = momenta(medium, j).template rightCols<n>(), stress = first_piola_kirchhoff_stress(medium, j);
    claim.equal("minus the momenta over the volume", model, stress, (p / -body_volume(medium, j)).eval());
    claim.differs("the other sign", model, stress, (p / body_volume(medium, j)).eval());
    claim.differs("without the volume", model, stress, (-p).eval());
  });
}

STATEMENT(claim_6_2_piola_transform, "Piola's transformation") {
  claim.convention("$W$ depends on $F$ and $g$ through the Green tensor alone (on $x$ and $G$ as it likes); the index is lowered with $g$, and $F$ has an inverse.");
  claim.degree(120);
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const solid = draw_medium<S, n>(draw, Kind::solid);
    Jet<S, n, n> const j = draw_jet<S, n, n>(draw);
    auto const at = point_of_medium(solid, j);
    auto const sigma = cauchy_stress(solid, j), stress = first_piola_kirchhoff_stress(solid, j);
    auto const transformed = piola_transformation(at.G, at.g, at.F, sigma);
    claim.equal("P and J sigma / F", model, stress, transformed);
    claim.differs("the inverse of F transposed", model, stress, (at.g * sigma * at.inverse * at.J).eval());
    claim.differs("without J", model, stress, (transformed / at.J).eval());
    auto const any = draw_medium<S, n>(draw, Kind::any);
    auto const there = point_of_medium(any, j);
    claim.differs("W not of the Green tensor", model, first_piola_kirchhoff_stress(any, j), piola_transformation(there.G, there.g, there.F, cauchy_stress(any, j)));
  });
}

STATEMENT(claim_6_2_stress_symmetry, "the Cauchy stress is symmetric") {
  claim.convention("With the symmetric derivative in $g$ it is so by definition. The balance of moment of momentum, that the Piola-Kirchhoff stress times $F$ is symmetric, "
                   "needs a $W$ of the Green tensor.");
  claim.degree(120);
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    using T = Dual<S, n>;
    Jet<S, n, n> const j = draw_jet<S, n, n>(draw);
    auto const any = draw_medium<S, n>(draw, Kind::any);
    auto const solid = draw_medium<S, n>(draw, Kind::solid);
    auto const sigma = cauchy_stress(any, j);
    claim.equal("for any W", model, sigma, sigma.transpose().eval());
    // P_a^i F^b_i with its first index raised.
    auto const moment = [&](auto const& medium) { return raised(medium.g(j.y), Eigen::Matrix<S, n, n>(first_piola_kirchhoff_stress(medium, j) * j.gradient().transpose())); };
    claim.equal("P times F, a W of the Green tensor", model, moment(solid), moment(solid).transpose().eval());
    claim.differs("P times F, any W", model, moment(any), moment(any).transpose().eval());
    // Entries of g changed one at a time: what W makes of a matrix that is not symmetric.
    Eigen::Matrix<S, n, n> alone;
    for (int a = 0; a < n; ++a) {
      Eigen::Matrix<T, n, n> g = any.g(j.y).template cast<T>();
      for (int b = 0; b < n; ++b) g(a, b).part[b] = S(1);
      auto const moved = j.template cast<T>();
      T const energy = any.W(moved.particle(), any.G(moved.particle()), g, moved.gradient());
      for (int b = 0; b < n; ++b) alone(a, b) = energy.part[b];
    }
    claim.differs("entries of g one at a time", model, alone, alone.transpose().eval());
  });
}

STATEMENT(eq_6_21, "the covariant equation of motion of elasticity") {
  claim.convention("The left side is a vector and the right a covector: one index is raised with $g$. $W$ is a function of the Green tensor.");
  claim.degree(160);
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const j = draw_second_jet<S, n>(draw);
    auto const E = [&](auto const& medium) { return raised(medium.g(j.y), Eigen::Matrix<S, n, 1>(euler_lagrange(medium, j) / body_volume(medium, j))); };
    auto const solid = draw_medium<S, n>(draw, Kind::solid);
    claim.equal("(6.21) and the field equations", model, (-solid_equation(solid, j)).eval(), E(solid));
    auto const any = draw_medium<S, n>(draw, Kind::any);
    claim.differs("W not of the Green tensor", model, (-solid_equation(any, j)).eval(), E(any));
    Eigen::Matrix<S, n, 1> const unraised = material_acceleration(solid.g, j) * S(solid.rho(j.particle())) - stress_divergence(solid, j);
    claim.differs("a vector and a covector", model, (-unraised).eval(), E(solid));
  });
}

STATEMENT(claim_6_2_euclidean_elasticity, "elasticity in a Euclidean space") {
  claim.holds("In coordinates in which $g$ and $G$ are constant; the first index of the stress is raised with $g$.");
  claim.degree(60);
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const j = draw_second_jet<S, n>(draw);
    // Both sides of the equation, their difference, and what it should be.
    auto const residual = [&](auto const& medium) {
      auto const raised_stress = [&]<class T>(Jet<T, n, n> const& jet) { return raised(medium.g(jet.y), Eigen::Matrix<T, n, n>(detail::piola_kirchhoff(medium, jet))); };
      return (detail::two_point_rates(raised_stress, j).divergence - j.acceleration() * S(medium.rho(j.particle()))).eval();
    };
    auto const E = [&](auto const& medium) { return raised(medium.g(j.y), Eigen::Matrix<S, n, 1>(euler_lagrange(medium, j) / body_volume(medium, j))); };
    auto const curved = draw_medium<S, n>(draw, Kind::solid), flat = flattened(curved);
    claim.equal("with constant metrics", model, residual(flat), E(flat));
    claim.differs("with others", model, residual(curved), E(curved));
  });
}
