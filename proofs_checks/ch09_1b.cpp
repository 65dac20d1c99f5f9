// Scalars: rational (long: double)
// Section 9.1: the covariant momentum map as a form, lifted actions, and the action itself.
#include "fields.hpp"

#include "actio/jets/action.hpp"
#include "statement.hpp"
#include "symmetries.hpp"

namespace {

using namespace actio;
using namespace actio::checks;

/// A homogeneous fluid of the plane whose action is the integral of a polynomial: flat space, \f$w = J + J^2\f$, and a body with curved metric and \f$\sqrt{\det G} = 1\f$.
template <class S>
AnyFluid<S, 2> draw_polynomial_fluid(Draw& draw) {
  auto fluid = draw_homogeneous_fluid<S, 2>(draw);
  fluid.G = draw_stretchable_metric<S, 2>(draw, true);
  fluid.g.bend.setZero();
  for (auto& slope : fluid.g.slope) slope.setZero();
  fluid.W.w.K = S(0);
  return fluid;
}
/// A section of second degree.
template <class S>
AnySection<S, 2, 2> draw_quadratic_section(Draw& draw) {
  auto phi = draw_section<S, 2, 2>(draw);
  for (auto& c : phi.added) c.e.setZero();
  return phi;
}
/// The field (x^1, -x^2) of stretches of the plane.
struct Stretching {
  template <class V>
  auto operator()(V const& x) const {
    return V(x[0], -x[1]);
  }
};

}  // namespace

STATEMENT(eq_9_4, "covariant momentum map and the multisymplectic form") {
  claim.holds("With $\\Omega=-d\\Theta$; the momentum map is defined up to a closed form.");
  // Momenta of a fluid, differentiated: some 60 with denominators, times a potential and four vectors.
  claim.degree(120);
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    auto const fluid = draw_homogeneous_fluid<S, 2>(draw);
    auto const field = relabelling_field<2>(draw_relabelling<S, 2>(fluid.G, draw));
    auto const at = coordinates(draw_jet<S, 2, 2>(draw));
    auto const V = draw_tangents<S, 11, 3>(draw);
    auto const both = [&](AnyFluid<S, 2> const& L) {
      S const left = contract(prolonged<2, 2>(field), multisymplectic_form<2, 2>(L))(at, V);
      return std::pair(left, S(exterior_derivative(covariant_momentum_map<2, 2>(L, field))(at, V)));
    };
    auto const [left, right] = both(fluid);
    claim.equal("dJ is the contraction of Omega", model, left, right, 10);
    claim.differs("with the other sign of Omega", model, S(-left), right);
    auto const [varying_left, varying_right] = both(with_varying_mass(fluid, draw));
    claim.differs("mass that varies", model, varying_left, varying_right);
  });
}

STATEMENT(eq_9_6, "invariance of the action under a group") {
  claim.convention("The region of integration moves with the map, and the equation holds for every region.");
  // The integrand is of degree 8 in each coordinate; coefficients enter to the fourth power.
  claim.degree(30);
  for (int point = 0; point < 3; ++point) {
    auto const fluid = draw_polynomial_fluid<S>(draw);
    auto const phi = draw_quadratic_section<S>(draw);
    std::string const model = "homogeneous fluid of the plane, a box of space-time";
    auto const stretched = [](S const& s, S const& c) { return [s, c](auto const& x) { return std::remove_cvref_t<decltype(x)>(x[0], x[1] * s, x[2] * c); }; };
    auto const moved = [&](S const& s, S const& c) {
      auto const eta = Automorphism{stretched(s, c), FixedFibre<2>{}};
      return moved_section(eta, stretched(S(1) / s, S(1) / c), phi);
    };
    Box<S, 2> const box{{S(0), S(0), ratio<S>(-1, 3)}, {S(1), ratio<S>(1, 2), ratio<S>(1, 3)}};
    Box<S, 2> const moved_box{{S(0), S(0), ratio<S>(-1, 6)}, {S(1), S(1), ratio<S>(1, 6)}};
    S const value = action(fluid, phi, box, 8);
    claim.equal("over the moved region", model, action(fluid, moved(S(2), ratio<S>(1, 2)), moved_box, 8), value, 10);
    claim.differs("over the same region", model, action(fluid, moved(S(2), ratio<S>(1, 2)), box, 8), value);
    Box<S, 2> const stretched_box{{S(0), S(0), ratio<S>(-1, 3)}, {S(1), S(1), ratio<S>(1, 3)}};
    claim.differs("a map that does not preserve the volume", model, action(fluid, moved(S(2), S(1)), stretched_box, 8), value);
  }
}

STATEMENT(claim_9_1_invariance_integrals, "boundary and volume integrals from invariance of the action") {
  claim.holds("With $\\Omega=-d\\Theta$; for an equivariant density both integrals are equal along every section, and zero along solutions.");
  claim.degree(40);
  for (int point = 0; point < 3; ++point) {
    auto const fluid = draw_polynomial_fluid<S>(draw);
    auto const phi = draw_quadratic_section<S>(draw);
    std::string const model = "homogeneous fluid of the plane, a box of space-time";
    auto const field = relabelling_field<2>(Stretching{});
    Box<S, 2> const box{{S(0), S(0), ratio<S>(-1, 3)}, {S(1), ratio<S>(1, 2), ratio<S>(1, 3)}};
    auto const current = flux_form([&](auto const& x) { return noether_current(fluid, field, first_jet(phi, x)); });
    S const boundary = boundary_integral(current, box, 10);
    auto const density = [&](Event<S, 2> const& x) {
      auto const pulled = pull_back(jet_extension(phi), contract(prolonged<2, 2>(field), multisymplectic_form<2, 2>(fluid)));
      Tangents<S, 3, 3> const unit = Tangents<S, 3, 3>::Identity();
      return S(pulled(x, unit));
    };
    // Of tenth degree in each coordinate.
    S const inside = integral(density, box.low, box.high, 10);
    claim.equal("boundary and inside", model, boundary, inside, 100);
    claim.differs("with the other sign of Omega", model, boundary, S(-inside));
    Event<S, 2> const x = draw_event<S, 2>(draw);
    auto const on = of_a_solution(fluid, second_jet(phi, x));
    claim.zero("divergence of the current along solutions", model, current_divergence(fluid, field, on), boundary, 100);
  }
}

STATEMENT(claim_9_1_lifted_actions, "lifted actions and canonical transformations of the jet bundle") {
  claim.corrected("\\eta_{J^1Y}^*\\Theta_{\\mathcal L}=\\Theta_{\\mathcal L}\\ \\text{for every lifted}\\ \\eta_{J^1Y}", "\\eta_{J^1Y}^*\\Theta_{\\mathcal L}=\\Theta_{\\eta^*\\mathcal L}",
                  "Every lift to the dual jet bundle preserves the canonical $\\Theta$. A prolongation to $J^1Y$ takes $\\Theta_{\\mathcal L}$ to the Cartan form of the pulled-back density: it is preserved where $\\mathcal L$ is equivariant, and only there.");
  claim.degree(120);
  for (int point = 0; point < 3; ++point) {
    std::string const model = "homogeneous fluid, n = 2, N = 2";
    auto fluid = draw_homogeneous_fluid<S, 2>(draw);
    fluid.G = draw_stretchable_metric<S, 2>(draw);
    auto const at = coordinates(draw_jet<S, 2, 2>(draw));
    auto const V = draw_tangents<S, 11, 3>(draw);
    auto const pulled = [&](auto const& eta, auto const& form) {
      return S(pull_back([&eta](auto const& c) { return coordinates(prolongation(eta, jet_at<2, 2>(c))); }, form)(at, V));
    };
    auto const eta = relabelling<2>(Stretch<S, 2>{ratio<S>(3, 2), ratio<S>(4, 9)});
    auto const theta = cartan_form<2, 2>(fluid);
    claim.equal("equivariant density: the Cartan form is preserved", model, pulled(eta, theta), S(theta(at, V)), 10);
    auto const varying = with_varying_mass(fluid, draw);
    auto const theta_varying = cartan_form<2, 2>(varying);
    claim.equal("any density: the Cartan form of the pulled-back density", model, pulled(eta, theta_varying), S(cartan_form<2, 2>(PulledBackDensity{varying, eta})(at, V)), 10);
    claim.differs("printed: preserved by every lift", model, pulled(eta, theta_varying), S(theta_varying(at, V)));

    DualJet<S, 2, 2> z{draw_event<S, 2>(draw), draw.vector<S, Eigen::Matrix<S, 2, 1>>(2), draw.number<S>(), {}};
    for (int mu = 0; mu <= 2; ++mu) z.p.col(mu) = draw.vector<S, Eigen::Matrix<S, 2, 1>>(2);
    auto const U = draw_tangents<S, 12, 3>(draw);
    auto const lift = [&](auto const& c) { return coordinates(dual_prolongation(eta, dual_jet_at<2, 2>(c))); };
    claim.equal("the canonical form of the dual bundle is preserved", "n = 2, N = 2", S(pull_back(lift, canonical_form<2, 2>())(coordinates(z), U)), S(canonical_form<2, 2>()(coordinates(z), U)), 10);
  }
}

STATEMENT(eq_9_7, "momentum map from the Cartan form") {
  claim.convention("The density must be equivariant; for others the form is there, and its differential is not $j^1\\xi\\lrcorner\\,\\Omega_{\\mathcal L}$.");
  claim.degree(60);
  over_points(std::tuple<Dimensions<1, 3>>{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = D::N;
    auto const L = draw_density<S, n, N>(draw);
    auto const xi = draw_field<S, n, N>(draw);
    auto const phi = draw_section<S, n, N>(draw);
    Event<S, n> const x = draw_event<S, n>(draw);
    auto const V = draw_tangents<S, n + 1, n>(draw);
    S const by_forms = pull_back(jet_extension(phi), covariant_momentum_map<n, N>(L, xi))(x, V);
    auto const j = first_jet(phi, x);
    claim.equal("pulled back by a section: the Noether current", model, by_forms, S(flux_form([&](auto const&) { return noether_current(L, xi, j); })(x, V)), 10);
    // Vertical variations alone give p dy ^ d^n x_mu less p v d^{n+1}x.
    Event<S, n> short_current = noether_current(L, xi, j);
    short_current -= xi(point_of(j)).template head<n + 1>() * L(j);
    claim.differs("from the Cartan form of vertical variations", model, by_forms, S(flux_form([&](auto const&) { return short_current; })(x, V)));
  });
}
