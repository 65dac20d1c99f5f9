// Section 9.1: the relabelling action, its prolongations and equivariance.

#include "actio/continuum/stresses.hpp"
#include "actio/jets/action.hpp"
#include "actio/noether/isometries.hpp"
#include "actio/noether/time_translation.hpp"

#include "fields.hpp"
#include "statement.hpp"
#include "symmetries.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

/// Any automorphism with an inverse: time and body are stretched and mixed, points of space go by a
/// polynomial of everything.
template <class S, int n, int N>
struct AnyAutomorphism {
  Stretch<S, n> stretch;
  Matrix<S, n, 1> drift;
  std::array<Cubic<S, n + 1 + N>, N> places;
  template <class V>
  auto base(V const& x) const {
    V to;
    to[0] = x[0] * 2;
    to.template tail<n>() = stretch(Matrix<ScalarOf<V>, n, 1>(x.template tail<n>()));
    for (int i = 0; i < n; ++i) to[1 + i] += x[0] * ScalarOf<V>(drift[i]);
    return to;
  }
  template <class V>
  auto back(V const& to) const {
    V x;
    x[0] = to[0] / 2;
    Matrix<ScalarOf<V>, n, 1> body = to.template tail<n>();
    for (int i = 0; i < n; ++i) body[i] -= x[0] * ScalarOf<V>(drift[i]);
    x.template tail<n>() = stretch.back(body);
    return x;
  }
  template <class V>
  auto fibre(V const& point) const {
    Matrix<ScalarOf<V>, N, 1> y = point.template tail<N>();
    for (int a = 0; a < N; ++a) y[a] += places[a](point);
    return y;
  }
};
template <class S, int n, int N>
AnyAutomorphism<S, n, N> draw_automorphism(Draw& draw) {
  AnyAutomorphism<S, n, N> eta{{ratio<S>(3, 2), ratio<S>(4, 5)}, draw.vector<S, Matrix<S, n, 1>>(n), {}};
  for (auto& c : eta.places) c = draw_cubic<S, n + 1 + N>(draw, ratio<S>(1, 5));
  return eta;
}

/// Any field on the body.
template <class S, int n>
struct BodyField {
  std::array<Cubic<S, n>, n> components;
  template <class V>
  auto operator()(V const& x) const {
    Matrix<ScalarOf<V>, n, 1> rate;
    for (int i = 0; i < n; ++i) rate[i] = components[i](x);
    return rate;
  }
};
template <class S, int n>
BodyField<S, n> draw_body_field(Draw& draw) {
  BodyField<S, n> xi;
  for (auto& c : xi.components) c = draw_cubic<S, n>(draw);
  return xi;
}
/// Its flow, to first order in an infinitesimal.
template <class S, int n>
auto flow_of(BodyField<S, n> const& xi) {
  return [xi](auto const& x) {
    Dual<S> epsilon(S(0));
    epsilon.part[0] = S(1);
    auto moved = x.eval();
    auto const rate = xi(x);
    for (int i = 0; i < n; ++i) moved[i] += rate[i] * ScalarOf<decltype(x)>(epsilon);
    return moved;
  };
}

template <class S, int n, int N>
Matrix<S, n, n> tangent_of(Stretch<S, n> const& eta, Jet<S, n, N> const& j) {
  return tangent<n, N>(relabelling<N>(eta), j.x, j.y).base.template bottomRightCorner<n, n>();
}

}  // namespace

STATEMENT(eq_9_1, "action of relabelling on base, fibres and multiplier") {
  claim.convention(
      "Leaving $\\lambda$ as it is suits only coordinates in which $\\det G$ is constant: there a "
      "volume-preserving map has determinant 1. In others $\\lambda=\\sqrt{\\det G}\\,P$ transforms as a "
      "density, and $P$ is unchanged.");
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = n + 1;
    auto fluid = draw_homogeneous_fluid<S, n>(draw);
    auto const j = draw_jet<S, n, N>(draw);
    Stretch<S, n> const even{ratio<S>(9, 4), ratio<S>(4, 9)}, uneven{ratio<S>(9, 4), ratio<S>(16, 81)};
    draw_positive(S(j.particle()[0] + S(1)));  // the root of det G
    auto const to = tangent<n, N>(relabelling<N>(uneven), j.x, j.y);
    claim.equal("places and multiplier stay", model, to.y, j.y);
    claim.equal("time stays", model, to.x[0], j.x[0]);
    fluid.G = draw_stretchable_metric<S, n>(draw, true);
    claim.zero("constant det G: the multiplier fixed", model,
               equivariance_defect(ideal(fluid), relabelling<N>(even), j), S(1));
    fluid.G = draw_stretchable_metric<S, n>(draw);
    auto const density = [&](auto const& point) {
      auto const volume_after = ScalarOf<decltype(point)>(1) + (point[1] + 1) * ratio<S>(9, 4) - 1;
      Matrix<ScalarOf<decltype(point)>, N, 1> y = point.template tail<N>();
      y[n] = y[n] * volume_after / (point[1] + 1);
      return y;
    };
    auto const carried = Automorphism{relabelling<N>(uneven).base, density};
    claim.zero("det G varies: the multiplier carried as a density", model,
               equivariance_defect(ideal(fluid), carried, j), S(1));
    claim.refutes("det G varies: the multiplier fixed", model,
                  equivariance_defect(ideal(fluid), relabelling<N>(uneven), j), S(1));
  });
}

STATEMENT(eq_9_2, "prolongation of bundle automorphisms to jets") {
  claim.holds();
  // A cubic of a cubic, of the inverse of a map of second degree.
  over_points(std::tuple<Dimensions<2, 2>, Dimensions<3, 1>>{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = D::N;
    auto const any = draw_automorphism<S, n, N>(draw);
    auto const eta = Automorphism{[any](auto const& x) { return any.base(x); },
                                  [any](auto const& point) { return any.fibre(point); }};
    auto const back = [any](auto const& x) { return any.back(x); };
    auto const phi = draw_section<S, n, N>(draw);
    Event<S, n> const x = draw_event<S, n>(draw);
    auto const j = prolongation(eta, first_jet(phi, x));
    auto const moved = first_jet(moved_section(eta, back, phi), Event<S, n>(any.base(x)));
    // The inverse map and the elimination divide by determinants near one.
    claim.equal("the jet of the moved section", model, j.v, moved.v, 10);
    claim.equal("and its place", model, j.y, moved.y);
    auto const d = tangent<n, N>(eta, x, phi(x).eval());
    claim.differs("the tangent map of the base in place of its inverse", model,
                  ((d.along + d.fibre * first_jet(phi, x).v) * d.base).eval(), moved.v);
  });
}

STATEMENT(claim_9_1_prolongation_coordinates, "finite prolongation in coordinates") {
  claim.holds(
      "For the lift (9.1); with a multiplier that transforms as a density, its rates have one term more.");
  over_points(PlaneAndSpace{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = n + 1;
    Stretch<S, n> const eta{ratio<S>(3, 2), ratio<S>(4, 9)};
    auto const j = draw_jet<S, n, N>(draw);
    auto const lifted = prolongation(relabelling<N>(eta), j);
    auto const slope = tangent_of(eta, j);
    Matrix<S, N, n> const formula = j.gradient() * inverse_matrix(slope);
    claim.equal("gradients: v and beta times the inverse", model, lifted.gradient(), formula, 10);
    claim.equal("rates in time stay", model, lifted.velocity(), j.velocity());
    claim.differs("without the inverse", model, lifted.gradient(), (j.gradient() * slope).eval());
    claim.differs("transposed", model, lifted.gradient(),
                  (j.gradient() * inverse_matrix(slope).transpose()).eval());
  });
}

STATEMENT(eq_9_3, "infinitesimal prolongation in coordinates") {
  claim.holds(
      "The field is divergence-free with respect to $\\sqrt{\\det G}$; the formula holds for any field on "
      "the body.");
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = n + 1;
    auto const xi = draw_body_field<S, n>(draw);
    auto const j = draw_jet<S, n, N>(draw);
    auto const lift = jet_at<n, N>(prolonged<n, N>(relabelling_field<N>(xi))(coordinates(j)));
    // The flow to first order in an infinitesimal.
    using T = Dual<S>;
    auto const moved = prolongation(relabelling<N>(flow_of(xi)), j.template cast<T>());
    Matrix<S, N, n + 1> rate;
    for (int a = 0; a < N; ++a)
      for (int mu = 0; mu <= n; ++mu) rate(a, mu) = moved.v(a, mu).part[0];
    claim.equal("the flow of the prolongations", model, lift.v, rate);
    auto const slope =
        tangent<n, N>(relabelling<N>(xi), j.x, j.y).base.template bottomRightCorner<n, n>().eval();
    Matrix<S, N, n> const formula = -j.gradient() * slope;
    claim.equal("minus the gradient times the slope of the field", model, lift.gradient(), formula);
    claim.zero("the components in time, of place and multiplier", model,
               S(lift.x[0] + lift.y.squaredNorm() + lift.velocity().squaredNorm()), S(1));
    claim.differs("the other sign", model, lift.gradient(), (j.gradient() * slope).eval());
    claim.differs("the other index", model, lift.gradient(), (-j.gradient() * slope.transpose()).eval());
  });
}

STATEMENT(claim_9_1_prolonged_velocities, "velocity components of the infinitesimal prolongation") {
  claim.holds("A relabelling that changes in time would add $-v^a{}_m\\,\\partial_t\\xi^m$.");
  over_points(PlaneAndSpace{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = n + 1;
    auto const j = draw_jet<S, n, N>(draw);
    auto const any = draw_field<S, n, N>(draw);
    // The field of the model at its time, and at a time that stands still.
    auto const field = [&](bool still) {
      return [&any, still](auto const& point) {
        using T = ScalarOf<decltype(point)>;
        Matrix<T, n + 1 + N, 1> at = point;
        if (still) at[0] = T(0);
        Matrix<T, n + 1 + N, 1> rate = any(at);
        rate[0] = T(0);
        rate.template tail<N>().setZero();
        return rate;
      };
    };
    auto const still = jet_at<n, N>(prolonged<n, N>(field(true))(coordinates(j)));
    claim.zero("no rate of the velocities", model, still.velocity(), S(1));
    auto const running = jet_at<n, N>(prolonged<n, N>(field(false))(coordinates(j)));
    claim.refutes("a field that depends on time", model, running.velocity(), S(1));
  });
}

STATEMENT(claim_9_1_equivariance, "equivariance of a Lagrangian density under a group") {
  claim.convention(
      "Equivalent to invariance of the action over every region, which moves with $\\eta_X$; invariance up "
      "to what happens at the boundary allows a divergence, as under Galileo's boosts.");
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto fluid = draw_homogeneous_fluid<S, n>(draw);
    fluid.G = draw_stretchable_metric<S, n>(draw);
    auto const j = draw_jet<S, n, n>(draw);
    draw_positive(S(j.particle()[0] + S(1)));  // the root of det G
    auto const eta = relabelling<n>(Stretch<S, n>{ratio<S>(9, 4), ratio<S>(16, 81)});
    auto const V = draw_tangents<S, n + 1, n + 1>(draw);
    // Both sides as forms at eta(x), on vectors that come from x.
    auto const base = tangent<n, n>(eta, j.x, j.y).base;
    Matrix<S, n + 1, n + 1> const W = base * V;
    S const left = fluid(prolongation(eta, j)) * determinant(W), right = fluid(j) * determinant(V);
    claim.equal("forms at the moved point", model, left, right, 10);
    claim.differs("a map that does not preserve the volume", model,
                  S(equivariance_defect(fluid, relabelling<n>(Stretch<S, n>{S(2), S(1)}), j) + fluid(j)),
                  fluid(j));
    // The derivative of the defect along a flow is the rate.
    auto const xi = draw_body_field<S, n>(draw);
    using T = Dual<S>;
    T const along_flow = PulledBackDensity{fluid, relabelling<n>(flow_of(xi))}(j.template cast<T>());
    claim.equal("the rate is the derivative of the defect", model, along_flow.part[0],
                equivariance_rate(fluid, relabelling_field<n>(xi), j), 10);
  });
}

// ----
// Section 9.1: the covariant momentum map as a form, lifted actions, and the action itself.

namespace {

/// A homogeneous fluid of the plane whose action is the integral of a polynomial: flat space,
/// \f$w = J + J^2\f$, and a body with curved metric and \f$\sqrt{\det G} = 1\f$.
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
  auto operator()(V const& x) const { return V(x[0], -x[1]); }
};

}  // namespace

STATEMENT(eq_9_4, "covariant momentum map and the multisymplectic form") {
  claim.holds("With $\\Omega=-d\\Theta$; the momentum map is defined up to a closed form.");
  // Momenta of a fluid, differentiated: some 60 with denominators, times a potential and four vectors.
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
  {
    auto const fluid = draw_polynomial_fluid<S>(draw);
    auto const phi = draw_quadratic_section<S>(draw);
    std::string const model = "homogeneous fluid of the plane, a box of space-time";
    auto const stretched = [](S const& s, S const& c) {
      return [s, c](auto const& x) { return std::remove_cvref_t<decltype(x)>(x[0], x[1] * s, x[2] * c); };
    };
    auto const moved = [&](S const& s, S const& c) {
      auto const eta = Automorphism{stretched(s, c), FixedFibre<2>{}};
      return moved_section(eta, stretched(S(1) / s, S(1) / c), phi);
    };
    Box<S, 2> const box{{S(0), S(0), ratio<S>(-1, 3)}, {S(1), ratio<S>(1, 2), ratio<S>(1, 3)}};
    Box<S, 2> const moved_box{{S(0), S(0), ratio<S>(-1, 6)}, {S(1), S(1), ratio<S>(1, 6)}};
    S const value = action(fluid, phi, box, 8);
    claim.equal("over the moved region", model, action(fluid, moved(S(2), ratio<S>(1, 2)), moved_box, 8),
                value, 10);
    claim.differs("over the same region", model, action(fluid, moved(S(2), ratio<S>(1, 2)), box, 8), value);
    Box<S, 2> const stretched_box{{S(0), S(0), ratio<S>(-1, 3)}, {S(1), S(1), ratio<S>(1, 3)}};
    claim.differs("a map that does not preserve the volume", model,
                  action(fluid, moved(S(2), S(1)), stretched_box, 8), value);
  }
}

STATEMENT(claim_9_1_invariance_integrals, "boundary and volume integrals from invariance of the action") {
  claim.holds(
      "With $\\Omega=-d\\Theta$; for an equivariant density both integrals are equal along every section, "
      "and zero along solutions.");
  {
    auto const fluid = draw_polynomial_fluid<S>(draw);
    auto const phi = draw_quadratic_section<S>(draw);
    std::string const model = "homogeneous fluid of the plane, a box of space-time";
    auto const field = relabelling_field<2>(Stretching{});
    Box<S, 2> const box{{S(0), S(0), ratio<S>(-1, 3)}, {S(1), ratio<S>(1, 2), ratio<S>(1, 3)}};
    auto const current =
        flux_form([&](auto const& x) { return noether_current(fluid, field, first_jet(phi, x)); });
    S const boundary = boundary_integral(current, box, 10);
    auto const density = [&](Event<S, 2> const& x) {
      auto const pulled =
          pull_back(jet_extension(phi), contract(prolonged<2, 2>(field), multisymplectic_form<2, 2>(fluid)));
      Tangents<S, 3, 3> const unit = Tangents<S, 3, 3>::Identity();
      return S(pulled(x, unit));
    };
    // Of tenth degree in each coordinate.
    S const inside = integral(density, box.low, box.high, 10);
    claim.equal("boundary and inside", model, boundary, inside, 100);
    claim.differs("with the other sign of Omega", model, boundary, S(-inside));
    Event<S, 2> const x = draw_event<S, 2>(draw);
    auto const on = of_a_solution(fluid, second_jet(phi, x));
    claim.zero("divergence of the current along solutions", model, current_divergence(fluid, field, on),
               boundary, 100);
  }
}

STATEMENT(claim_9_1_lifted_actions, "lifted actions and canonical transformations of the jet bundle") {
  claim.corrected(
      "\\eta_{J^1Y}^*\\Theta_{\\mathcal L}=\\Theta_{\\mathcal L}\\ \\text{for every lifted}\\ \\eta_{J^1Y}",
      "\\eta_{J^1Y}^*\\Theta_{\\mathcal L}=\\Theta_{\\eta^*\\mathcal L}",
      "Every lift to the dual jet bundle preserves the canonical $\\Theta$. A prolongation to $J^1Y$ takes "
      "$\\Theta_{\\mathcal L}$ to the Cartan form of the pulled-back density: it is preserved where "
      "$\\mathcal L$ is equivariant, and only there.");
  {
    std::string const model = "homogeneous fluid, n = 2, N = 2";
    auto fluid = draw_homogeneous_fluid<S, 2>(draw);
    fluid.G = draw_stretchable_metric<S, 2>(draw);
    auto const jet = draw_jet<S, 2, 2>(draw);
    draw_positive(S(jet.particle()[0] + S(1)));  // the root of det G
    auto const at = coordinates(jet);
    auto const V = draw_tangents<S, 11, 3>(draw);
    auto const pulled = [&](auto const& eta, auto const& form) {
      return S(pull_back([&eta](auto const& c) { return coordinates(prolongation(eta, jet_at<2, 2>(c))); },
                         form)(at, V));
    };
    auto const eta = relabelling<2>(Stretch<S, 2>{ratio<S>(9, 4), ratio<S>(16, 81)});
    auto const theta = cartan_form<2, 2>(fluid);
    claim.equal("equivariant density: the Cartan form is preserved", model, pulled(eta, theta),
                S(theta(at, V)), 10);
    auto const varying = with_varying_mass(fluid, draw);
    auto const theta_varying = cartan_form<2, 2>(varying);
    claim.equal("any density: the Cartan form of the pulled-back density", model, pulled(eta, theta_varying),
                S(cartan_form<2, 2>(PulledBackDensity{varying, eta})(at, V)), 10);
    claim.differs("printed: preserved by every lift", model, pulled(eta, theta_varying),
                  S(theta_varying(at, V)));

    DualJet<S, 2, 2> z{draw_event<S, 2>(draw), draw.vector<S, Matrix<S, 2, 1>>(2), draw.number<S>(), {}};
    for (int mu = 0; mu <= 2; ++mu) z.p.col(mu) = draw.vector<S, Matrix<S, 2, 1>>(2);
    auto const U = draw_tangents<S, 12, 3>(draw);
    auto const lift = [&](auto const& c) {
      return coordinates(dual_prolongation(eta, dual_jet_at<2, 2>(c)));
    };
    claim.equal("the canonical form of the dual bundle is preserved", "n = 2, N = 2",
                S(pull_back(lift, canonical_form<2, 2>())(coordinates(z), U)),
                S(canonical_form<2, 2>()(coordinates(z), U)), 10);
  }
}

STATEMENT(eq_9_7, "momentum map from the Cartan form") {
  claim.convention(
      "The density must be equivariant; for others the form is there, and its differential is not "
      "$j^1\\xi\\lrcorner\\,\\Omega_{\\mathcal L}$.");
  over_points(std::tuple<Dimensions<1, 3>>{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = D::N;
    auto const L = draw_density<S, n, N>(draw);
    auto const xi = draw_field<S, n, N>(draw);
    auto const phi = draw_section<S, n, N>(draw);
    Event<S, n> const x = draw_event<S, n>(draw);
    auto const V = draw_tangents<S, n + 1, n>(draw);
    S const by_forms = pull_back(jet_extension(phi), covariant_momentum_map<n, N>(L, xi))(x, V);
    auto const j = first_jet(phi, x);
    claim.equal("pulled back by a section: the Noether current", model, by_forms,
                S(flux_form([&](auto const&) { return noether_current(L, xi, j); })(x, V)), 10);
    // Vertical variations alone give p dy ^ d^n x_mu less p v d^{n+1}x.
    Event<S, n> short_current = noether_current(L, xi, j);
    short_current -= xi(point_of(j)).template head<n + 1>() * L(j);
    claim.differs("from the Cartan form of vertical variations", model, by_forms,
                  S(flux_form([&](auto const&) { return short_current; })(x, V)));
  });
}

// ----
// Section 9.1: equivariance of the two fluid Lagrangians under relabelling.

namespace {}  // namespace

STATEMENT(prop_9_1_1, "equivariance of the two fluid Lagrangians under relabelling") {
  claim.convention(
      "With the same density everywhere, an energy that depends on the body through $J$ alone, fields "
      "that are divergence-free with respect to $\\sqrt{\\det G}$, and, where $\\det G$ varies, a "
      "multiplier that transforms as a density.");
  // Each density is of degree some 24 with its denominators, a field 12.
  over_points(PlaneAndSpace{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const fluid = draw_homogeneous_fluid<S, n>(draw);
    auto const xi = draw_relabelling<S, n>(fluid.G, draw);
    auto const squeezing = draw_compression<S, n>(draw);
    auto const j = draw_jet<S, n, n + 1>(draw);
    auto const below = deformation(j);
    // The rate is a sum of terms of the size of L.
    claim.zero("barotropic", model, equivariance_rate(fluid, relabelling_field<n>(xi), below), fluid(below),
               10);
    claim.zero("incompressible", model,
               equivariance_rate(ideal(fluid), density_relabelling_field<n + 1>(xi), j), fluid(below), 10);
    claim.refutes("barotropic, mass that varies", model,
                  equivariance_rate(with_varying_mass(fluid, draw), relabelling_field<n>(xi), below),
                  fluid(below));
    claim.refutes("barotropic, a field with divergence", model,
                  equivariance_rate(fluid, relabelling_field<n>(squeezing), below), fluid(below));
    claim.refutes("incompressible, a field with divergence", model,
                  equivariance_rate(ideal(fluid), density_relabelling_field<n + 1>(squeezing), j),
                  fluid(below));
  });
}

STATEMENT(claim_9_1_barotropic_equivariance, "equivariance of the barotropic Lagrangian under relabelling") {
  claim.holds(
      "For every metric of the body, where volume-preserving means $\\sqrt{\\det "
      "G(\\eta(x))}\\,\\det\\partial\\eta=\\sqrt{\\det G(x)}$.");
  over_points(PlaneAndSpace{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto fluid = draw_homogeneous_fluid<S, n>(draw);
    fluid.G = draw_stretchable_metric<S, n>(draw);
    auto const j = draw_jet<S, n, n>(draw);
    draw_positive(S(j.particle()[0] + S(1)));  // the root of det G
    auto const eta = relabelling<n>(Stretch<S, n>{ratio<S>(9, 4), ratio<S>(16, 81)});
    claim.zero("finite map, det G varies", model, equivariance_defect(fluid, eta, j), fluid(j), 10);
    claim.refutes("mass that varies", model, equivariance_defect(with_varying_mass(fluid, draw), eta, j),
                  fluid(j));
    claim.refutes(
        "determinant 1, where det G varies", model,
        equivariance_defect(fluid, relabelling<n>(Stretch<S, n>{ratio<S>(9, 4), ratio<S>(4, 9)}), j),
        fluid(j));
  });
}

STATEMENT(claim_9_1_incompressible_equivariance,
          "equivariance of the incompressible Lagrangian under relabelling") {
  claim.convention(
      "With the multiplier fixed, as (9.1) has it, only in coordinates with constant $\\det G$; otherwise "
      "with $\\lambda=\\sqrt{\\det G}\\,P$ transformed as a density, $P$ fixed.");
  over_points(PlaneAndSpace{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = n + 1;
    auto fluid = draw_homogeneous_fluid<S, n>(draw);
    auto const j = draw_jet<S, n, N>(draw);
    S const scale = fluid(deformation(j));
    auto const xi = draw_relabelling<S, n>(fluid.G, draw);
    claim.zero("det G varies: the multiplier carried as a density", model,
               equivariance_rate(ideal(fluid), density_relabelling_field<N>(xi), j), scale, 10);
    claim.refutes("det G varies: the multiplier fixed", model,
                  equivariance_rate(ideal(fluid), relabelling_field<N>(xi), j), scale);
    fluid.G = draw_stretchable_metric<S, n>(draw, true);
    claim.zero(
        "constant det G: the multiplier fixed", model,
        equivariance_rate(ideal(fluid), relabelling_field<N>(draw_relabelling<S, n>(fluid.G, draw)), j),
        scale, 10);
  });
}

STATEMENT(claim_9_1_jacobian_functions, "functions of the Jacobian and the determinant of a relabelling") {
  claim.convention(
      "That the determinant is 1, and the displayed equality without $\\sqrt{\\det G}$, need coordinates "
      "in which $\\det G$ is constant. In any, $J$ is the same before and after, and $f(J)\\sqrt{\\det "
      "G}\\,d^{n+1}x$ is equivariant.");
  over_points(PlaneAndSpace{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const fluid = draw_homogeneous_fluid<S, n>(draw);
    auto const G = draw_stretchable_metric<S, n>(draw), g = fluid.g;
    auto const j = draw_jet<S, n, n>(draw);
    draw_positive(S(j.particle()[0] + S(1)));  // the root of det G
    auto const eta = relabelling<n>(Stretch<S, n>{ratio<S>(9, 4), ratio<S>(16, 81)});
    auto const to = prolongation(eta, j);
    S const det = determinant(tangent<n, n>(eta, j.x, j.y).base);
    S const before = jacobian(G(j.particle()), g(j.y), j.gradient()),
            after = jacobian(G(to.particle()), g(to.y), to.gradient());
    S const root_before = volume<S>(G(j.particle())), root_after = volume<S>(G(to.particle()));
    claim.equal("the volume is preserved", model, S(root_after * det), root_before);
    claim.equal("J is the same", model, after, before, 10);
    claim.equal("f(J) times the volume of the body", model, S(fluid.W.w(after) * root_after * det),
                S(fluid.W.w(before) * root_before), 10);
    claim.differs("determinant 1", model, det, S(1));
    claim.differs("f(J) alone", model, S(fluid.W.w(after) * det), fluid.W.w(before));
  });
}

// ----
// Section 9.1: Noether's theorem, on and off the solutions.

namespace {}  // namespace

STATEMENT(thm_9_1_1, "covariant Noether theorem") {
  claim.holds(
      "Off shell, for any density and any field: "
      "$d(j^1\\phi)^*J=\\bigl(r-E_a(\\xi^a-v^a{}_\\mu\\xi^\\mu)\\bigr)\\,d^{n+1}x$ with the rate $r$ of "
      "equivariance.");
  over_points(std::tuple<Dimensions<1, 3>, Dimensions<2, 1>>{}, [&]<class D>(D, std::string const& model) {
    auto const L = draw_density<S, D::n, D::N>(draw);
    auto const xi = draw_field<S, D::n, D::N>(draw);
    auto const j = draw_second_jet<S, D::n, D::N>(draw);
    S const divergence = current_divergence(L, xi, j);
    claim.equal("any density, any field, any section", model, divergence,
                S(equivariance_rate(L, xi, first(j)) + noether_identity(L, xi, j)), 10);
    claim.differs("without the rate of equivariance", model, divergence, noether_identity(L, xi, j));
  });
  over_points(PlaneAndSpace{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const fluid = draw_homogeneous_fluid<S, n>(draw);
    auto const field = relabelling_field<n>(draw_relabelling<S, n>(fluid.G, draw));
    auto const off = draw_second_jet<S, n, n>(draw);
    auto const on = of_a_solution(fluid, off);
    S const scale = noether_identity(fluid, field, off);
    // The acceleration comes out of an elimination.
    claim.zero("relabelling current along solutions", model, current_divergence(fluid, field, on), scale,
               100);
    claim.zero("current of time translation along solutions", model,
               current_divergence(fluid, TimeTranslation{}, on), scale, 100);
    claim.refutes("along a section that solves nothing", model, current_divergence(fluid, field, off), scale);
    auto const varying = with_varying_mass(fluid, draw);
    claim.refutes("mass that varies", model, current_divergence(varying, field, of_a_solution(varying, off)),
                  scale);
  });
}

STATEMENT(eq_9_5, "exterior derivative of the Noether current on solutions") {
  claim.holds(
      "For relabelling it is $\\xi^kF^a{}_kE_a\\,d^{n+1}x$ off shell, for time translation "
      "$\\dot\\phi^aE_a$, for an isometry $k$ of space $-k^aE_a$.");
  over_points(PlaneAndSpace{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const fluid = draw_homogeneous_fluid<S, n>(draw);
    auto const xi = draw_relabelling<S, n>(fluid.G, draw);
    auto const field = relabelling_field<n>(xi);
    auto const j = draw_second_jet<S, n, n>(draw);
    Matrix<S, n, 1> const along_field = j.gradient() * xi(j.particle());
    S const expected = along_field.dot(euler_lagrange(fluid, j));
    claim.equal("off shell", model, current_divergence(fluid, field, j), expected, 10);
    claim.zero("on solutions", model, current_divergence(fluid, field, of_a_solution(fluid, j)), expected,
               100);
    claim.differs("the other sign", model, current_divergence(fluid, field, j), S(-expected));
    auto const squeezing = relabelling_field<n>(draw_compression<S, n>(draw));
    claim.refutes("a field with divergence, on solutions", model,
                  current_divergence(fluid, squeezing, of_a_solution(fluid, j)), expected);

    auto const power = j.velocity().dot(euler_lagrange(fluid, j));
    claim.equal("time translation, off shell", model, current_divergence(fluid, TimeTranslation{}, j), power,
                10);
    auto const shift = motion_of_space<n>(FirstShift<n>{});
    auto symmetric = fluid;
    symmetric.g = draw_shiftable_metric<S, n>(draw);
    claim.equal("isometry of space, off shell", model, current_divergence(symmetric, shift, j),
                S(-euler_lagrange(symmetric, j)[0]), 10);
    claim.differs("the same shift where the metric depends on the coordinate", model,
                  current_divergence(fluid, shift, j), S(-euler_lagrange(fluid, j)[0]));
  });
}

// ----
// Section 9.1: the relabelling currents of the two fluids, their differentials and what these say.

namespace {

/// A homogeneous fluid, a field that preserves the volume of its body, and the second jet of a section with
/// multiplier that solves nothing.
template <class S, int n>
struct FlowingFluid {
  AnyFluid<S, n> fluid;
  PotentialField<S, n> xi;
  SecondJet<S, n, n + 1> extended;
  SecondJet<S, n, n> j;
  Matrix<S, n, 1> field;  ///< value of xi at the particle
  S rho, root;            ///< density, volume of the body's metric

  explicit FlowingFluid(Draw& draw)
      : fluid(draw_homogeneous_fluid<S, n>(draw)),
        xi(draw_relabelling<S, n>(fluid.G, draw)),
        extended(draw_second_jet<S, n, n + 1>(draw)),
        j(deformation(extended)),
        field(xi(j.particle())),
        rho(fluid.rho(j.particle())),
        root(volume<S>(fluid.G(j.particle()))) {}

  Event<S, n> current() const { return noether_current(fluid, relabelling_field<n>(xi), first(j)); }
  Event<S, n> incompressible_current() const {
    return noether_current(ideal(fluid), density_relabelling_field<n + 1>(xi), first(extended));
  }
  S divergence() const { return current_divergence(fluid, relabelling_field<n>(xi), j); }
  S incompressible_divergence() const {
    return current_divergence(ideal(fluid), density_relabelling_field<n + 1>(xi), extended);
  }

  /// The inertia \f$g_{ab}(D_g\dot\phi/Dt)^b\,\phi^a{}_{,k}\f$.
  Matrix<S, n, 1> inertia() const {
    return j.gradient().transpose() * lowered(fluid.g(j.y), material_acceleration(fluid.g, j));
  }
  /// The derivatives of the pressure of the barotropic fluid in the coordinates of the body.
  Matrix<S, n, 1> pressure_slope() const {
    Matrix<S, n, 1> slope;
    for (int k = 0; k < n; ++k) slope[k] = material_pressure(fluid, along(j, k + 1)).part[0];
    return slope;
  }
  S J() const { return jacobian(fluid.G(j.particle()), fluid.g(j.y), j.gradient()); }
  /// \f$-\sqrt{\det G}\,\xi^kf_k\f$.
  S against(Matrix<S, n, 1> const& force) const { return -root * field.dot(force); }
};

}  // namespace

STATEMENT(eq_9_8, "relabelling current of a barotropic fluid") {
  claim.holds();
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
  over_points(PlaneAndSpace{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    FlowingFluid<S, n> const flow(draw);
    S const kinetic = flow.rho * inner(flow.fluid.g(flow.j.y), flow.j.velocity(), flow.j.velocity()) / S(2);
    S const energy = flow.rho * flow.fluid.W.w(flow.J()),
            push = material_pressure(flow.fluid, first(flow.j)) * flow.J();
    Matrix<S, n, 1> const space = flow.current().template tail<n>();
    claim.equal("kinetic less stored energy less PJ", model, space,
                (flow.field * S((kinetic - energy - push) * flow.root)).eval(), 10);
    claim.differs("PJ left out", model, space, (flow.field * S((kinetic - energy) * flow.root)).eval());
    claim.differs("PJ added", model, space, (flow.field * S((kinetic - energy + push) * flow.root)).eval());
  });
}

STATEMENT(claim_9_1_barotropic_current_time, "time component of the barotropic relabelling current") {
  claim.holds();
  over_points(PlaneAndSpace{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    FlowingFluid<S, n> const flow(draw);
    Matrix<S, n, 1> const pushed_field = flow.j.gradient() * flow.field;
    S const momentum = inner(flow.fluid.g(flow.j.y), flow.j.velocity(), pushed_field) * flow.root;
    claim.equal("minus the momentum along the field", model, flow.current()[0], S(-flow.rho * momentum), 10);
    claim.differs("without the density", model, flow.current()[0], S(-momentum));
    claim.differs("without the volume of the body", model, flow.current()[0],
                  S(-flow.rho * momentum / flow.root));
  });
}

STATEMENT(claim_9_1_barotropic_current_differential,
          "exterior derivative of the barotropic relabelling current") {
  claim.corrected(
      "g_{ab}\\left(\\frac{D_g\\dot\\phi}{Dt}\\right)^b=-\\frac{\\partial P}{\\partial "
      "x^k}\\,J\\left(\\left(\\frac{\\partial\\phi}{\\partial x}\\right)^{-1}\\right)_a^k",
      "\\rho\\,g_{ab}\\left(\\frac{D_g\\dot\\phi}{Dt}\\right)^b=-\\frac{\\partial P}{\\partial "
      "x^k}\\,J\\left(\\left(\\frac{\\partial\\phi}{\\partial x}\\right)^{-1}\\right)_a^k",
      "The density is missing: the printed form holds for $\\rho=1$. The differential is $-\\sqrt{\\det "
      "G}\\,\\xi^k\\bigl(\\rho\\,g_{ab}(D_g\\dot\\phi/Dt)^b\\phi^a{}_{,k}+J\\,\\partial_kP\\bigr)d^{n+1}x$; "
      "closed at a point for all divergence-free fields it gives back the field equations there, since "
      "$F$ is invertible.");
  over_points(PlaneAndSpace{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    FlowingFluid<S, n> const flow(draw);
    Matrix<S, n, 1> const push = flow.pressure_slope() * flow.J(), inertia = flow.inertia();
    // Second derivatives of W and of two metrics.
    claim.equal("differential of (9.8), off shell", model, flow.divergence(),
                flow.against(inertia * flow.rho + push), 100);
    claim.differs("printed: the density left out", model, flow.divergence(), flow.against(inertia + push));
    // Several fields recover the Euler-Lagrange derivative.
    Matrix<S, n, n> fields;
    Matrix<S, n, 1> differentials;
    for (int i = 0; i < n; ++i) {
      auto const xi = draw_relabelling<S, n>(flow.fluid.G, draw);
      fields.row(i) = xi(flow.j.particle()).transpose();
      differentials[i] = current_divergence(flow.fluid, relabelling_field<n>(xi), flow.j);
    }
    Matrix<S, n, 1> const recovered =
        solve_linear((fields * flow.j.gradient().transpose()).eval(), differentials);
    claim.equal("n fields give the field equations back", model, recovered,
                euler_lagrange(flow.fluid, flow.j), 1000);
    auto const varying = with_varying_mass(flow.fluid, draw);
    claim.differs(
        "mass that varies", model, current_divergence(varying, relabelling_field<n>(flow.xi), flow.j),
        S(flow.field.dot((flow.j.gradient().transpose() * euler_lagrange(varying, flow.j)).eval())));
  });
}

STATEMENT(eq_9_9, "relabelling current of an incompressible fluid") {
  claim.convention(
      "The constant stored energy is put to zero; another one would add a closed form. It holds off shell "
      "too: $\\lambda(J-1)-\\lambda J=-\\lambda$.");
  over_points(PlaneAndSpace{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    FlowingFluid<S, n> const flow(draw);
    S const P = flow.extended.y[n] / flow.root;
    auto const body = flow.fluid.G(flow.j.particle());
    auto const space = flow.fluid.g(flow.j.y);
    auto const printed = [&](S const& pressure) {
      return incompressible_relabelling_current(body, space, flow.rho, pressure, flow.field, first(flow.j));
    };
    claim.equal("(9.9) is the current of (9.7), by its components", model, printed(P),
                flow.incompressible_current(), 10);
    claim.differs("PJ in place of P", model, printed(S(P * flow.J())), flow.incompressible_current());
  });
}

STATEMENT(claim_9_1_incompressible_current_differential,
          "exterior derivative of the incompressible relabelling current") {
  claim.corrected(
      "g_{ab}\\left(\\frac{D_g\\dot\\phi}{Dt}\\right)^b=-\\frac{\\partial P}{\\partial "
      "x^k}\\left(\\left(\\frac{\\partial\\phi}{\\partial x}\\right)^{-1}\\right)_a^k",
      "\\rho\\,g_{ab}\\left(\\frac{D_g\\dot\\phi}{Dt}\\right)^b=-\\frac{\\partial P}{\\partial "
      "x^k}\\left(\\left(\\frac{\\partial\\phi}{\\partial x}\\right)^{-1}\\right)_a^k",
      "The density is missing: the printed form holds for $\\rho=1$. That there is no $J$ is right, "
      "constraint or not.");
  over_points(PlaneAndSpace{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    FlowingFluid<S, n> const flow(draw);
    auto const push = pressure_gradient(flow.fluid.G, flow.extended);
    auto const inertia = flow.inertia();
    claim.equal("differential of (9.9), off shell", model, flow.incompressible_divergence(),
                flow.against(inertia * flow.rho + push), 100);
    claim.differs("printed: the density left out", model, flow.incompressible_divergence(),
                  flow.against(inertia + push));
    claim.differs("a factor J with the pressure", model, flow.incompressible_divergence(),
                  flow.against(inertia * flow.rho + push * flow.J()));
  });
}

STATEMENT(claim_9_1_constraint_from_current, "constraint and the vanishing of the current differential") {
  claim.holds(
      "A motion whose volumes change has closed currents for all fields once its acceleration fits the "
      "pressure.");
  over_points(PlaneAndSpace{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    FlowingFluid<S, n> flow(draw);
    // Let the acceleration be what makes every current closed; the volumes do what they do.
    Matrix<S, n, 1> const excess = flow.inertia() * flow.rho + pressure_gradient(flow.fluid.G, flow.extended);
    Matrix<S, n, n> const inertia =
        flow.j.gradient().transpose() * as_matrix<S>(flow.fluid.g(flow.j.y)) * flow.rho;
    S const before = flow.incompressible_divergence();
    flow.extended.w[0].template topRows<n>().col(0) -= solve_linear(inertia, excess);
    claim.zero("the current is closed", model, flow.incompressible_divergence(), before, 1000);
    claim.refutes("closed, therefore J = 1", model, S(flow.J() - S(1)), S(1));
  });
}
