// Section 9.1: the relabelling action, its prolongations, and which densities are equivariant.

#include "fields/fields.hpp"
#include "fields/symmetries.hpp"
#include "statement.hpp"

#include "actio/jets/tilted_section.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

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

/// The automorphism theta after eta.
template <class Theta, class Eta>
auto composed(Theta const& theta, Eta const& eta) {
  return Automorphism{[theta, eta](auto const& x) { return theta.base(eta.base(x)); },
                      [theta, eta]<class T, int rows>(Matrix<T, rows, 1> const& point) {
                        auto const y = eta.fibre(point);
                        constexpr int N = std::remove_cvref_t<decltype(y)>::RowsAtCompileTime;
                        Matrix<T, rows, 1> moved;
                        moved << eta.base(Matrix<T, rows - N, 1>(point.template head<rows - N>())), y;
                        return theta.fibre(moved);
                      }};
}
/// The bracket \f$[X, Y] = DY\cdot X - DX\cdot Y\f$ of two fields on the same coordinates.
template <class X, class Y>
auto bracket(X const& x, Y const& y) {
  return [x, y]<class T, int rows>(Matrix<T, rows, 1> const& at) {
    Matrix<T, rows, 1> const along_x = x(at), along_y = y(at);
    return Matrix<T, rows, 1>(derivative_along(y, at, along_x).rate - derivative_along(x, at, along_y).rate);
  };
}

}  // namespace

STATEMENT(eq_9_1, "action of relabelling on base, fibres and multiplier") {
  claim.corrected(
      "\\eta_E=(y^a,\\lambda)", "\\eta_E=\\bigl(y^a,\\lambda/\\det\\partial\\eta\\bigr)",
      "By (8.2) $\\lambda=\\sqrt{\\det G}\\,P$ is a density, and the lift must take it along as one: then "
      "$P$ stays, and the incompressible fluid is symmetric. The printed lift, which leaves $\\lambda$ as "
      "it is, agrees with it only in coordinates in which $\\det G$ is constant.");
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    constexpr int N = n + 1;
    auto const fluid = draw_homogeneous_fluid<S, n>(draw);
    auto const j = draw_pressed_jet<S, n>(draw);
    auto const eta = draw_relabelling_at<S, n>(fluid.G, j.particle(), draw);
    auto const to = tangent<n, N>(density_relabelling<N>(eta), j.x, j.y);
    Matrix<S, n, 1> const place = to.y.template head<n>(), before = j.y.template head<n>();
    claim.equal("places stay", model, place, before);
    claim.equal("time stays", model, to.x[0], j.x[0]);
    claim.equal("particles go over by the map", model, Matrix<S, n, 1>(to.x.template tail<n>()), eta.to);
    S const P = j.y[n] / volume<S>(fluid.G(j.particle()));
    claim.equal("(8.2): the pressure stays", model, S(to.y[n] / volume<S>(fluid.G(eta.to))), P, 10);
    claim.differs("printed: with the multiplier left as it is, the pressure", model,
                  S(j.y[n] / volume<S>(fluid.G(eta.to))), P);
    claim.zero("the incompressible fluid is equivariant", model,
               equivariance_defect(ideal(fluid), density_relabelling<N>(eta), j), fluid(deformation(j)), 10);
    claim.refutes("printed: the multiplier left as it is, in the incompressible fluid", model,
                  equivariance_defect(ideal(fluid), relabelling<N>(eta), j), fluid(deformation(j)));
  });
}

STATEMENT(eq_9_2, "prolongation of bundle automorphisms to jets") {
  claim.holds();
  // A cubic of a cubic, of the inverse of a map of second degree.
  over_dimensions(std::tuple<Dimensions<2, 2>, Dimensions<3, 1>>{},
                  [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
                    auto const any = draw_automorphism<S, n, N>(draw);
                    auto const eta = as_automorphism(any);
                    auto const back = [any](auto const& x) { return any.back(x); };
                    auto const phi = draw_section<S, n, N>(draw);
                    Event<S, n> const x = draw_event<S, n>(draw);
                    auto const j = prolongation(eta, first_jet(phi, x));
                    auto const moved = first_jet(moved_section(eta, back, phi), Event<S, n>(any.base(x)));
                    // The inverse map and the elimination divide by determinants near one.
                    claim.equal("the jet of the moved section", model, j.v, moved.v, 10);
                    claim.equal("and its place", model, j.y, moved.y);
                    claim.equal("over the image of the point", model, j.x, any.base(x));
                    claim.differs("over the point itself", model, x, any.base(x));
                    auto const d = tangent<n, N>(eta, x, phi(x).eval());
                    claim.differs("the tangent map of the base in place of its inverse", model,
                                  ((d.along + d.fibre * first_jet(phi, x).v) * d.base).eval(), moved.v);
                  });
}

STATEMENT(claim_9_1_prolongation_functorial, "prolongation of a composition") {
  claim.holds(
      "Prolongation takes compositions to compositions, the identity to itself and inverses to "
      "inverses, and brackets of fields to brackets; where space-time is time alone and stays, it is "
      "the tangent map on velocities.");
  over_dimensions(std::tuple<Dimensions<1, 2>, Dimensions<3, 1>, Dimensions<2, 2>>{},
                  [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
                    auto const eta = as_automorphism(draw_automorphism<S, n, N>(draw)),
                               theta = as_automorphism(draw_automorphism<S, n, N>(draw));
                    auto const j = draw_jet<S, n, N>(draw);
                    auto const one_after_the_other = prolongation(theta, prolongation(eta, j));
                    // Two inverses, of tangent maps with determinants near one.
                    claim.equal("theta after eta", model, prolongation(composed(theta, eta), j).v,
                                one_after_the_other.v, 10);
                    claim.differs("in the other order", model, prolongation(composed(eta, theta), j).v,
                                  one_after_the_other.v);
                    Automorphism const identity{[](auto const& x) { return x; }, FixedFibre<N>{}};
                    claim.equal("the identity", model, prolongation(identity, j).v, j.v);
                    auto const map = draw_map_at<S, n>(j.particle(), draw);
                    auto back = map;
                    back.from = map.to, back.to = map.from, back.slope = inverse_matrix(map.slope);
                    claim.equal("the inverse", model,
                                prolongation(relabelling<N>(back), prolongation(relabelling<N>(map), j)).v,
                                j.v, 10);
                  });
  over_dimensions(
      std::tuple<Dimensions<1, 1>, Dimensions<1, 2>>{},
      [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
        auto const xi = draw_field<S, n, N>(draw), zeta = draw_field<S, n, N>(draw);
        auto const at = coordinates(draw_jet<S, n, N>(draw));
        auto const left = prolonged<n, N>(bracket(xi, zeta))(at);
        claim.equal("brackets of fields", model, left,
                    bracket(prolonged<n, N>(xi), prolonged<n, N>(zeta))(at), 10);
        claim.differs("brackets in the other order", model, left,
                      bracket(prolonged<n, N>(zeta), prolonged<n, N>(xi))(at));
        // Maps of space that do not see space-time, where time is all there is of it.
        Jet<S, 0, N> const motion{Event<S, 0>(draw.number<S>()), draw.vector<S, Matrix<S, N, 1>>(N),
                                  draw.vector<S, Matrix<S, N, 1>>(N)};
        auto const places = draw_section<S, N - 1, N>(draw);
        Automorphism const of_space{
            [](auto const& x) { return x; },
            [places](auto const& point) {
              return places(Matrix<ScalarOf<decltype(point)>, N, 1>(point.template tail<N>()));
            }};
        auto const [place, pushed_velocity] = derivative_along(places, motion.y, Matrix<S, N, 1>(motion.v));
        claim.equal("mechanics: the tangent map", "n = 0, N = " + std::to_string(N),
                    Matrix<S, N, 1>(prolongation(of_space, motion).v), pushed_velocity);
      });
}

STATEMENT(claim_9_1_prolongation_coordinates, "finite prolongation in coordinates") {
  claim.convention(
      "For the lift (9.1) as it stands, and any map of the body, whether it preserves volume "
      "or not. With (9.1) put right it holds in coordinates in which $\\det G$ is constant, "
      "for maps that preserve volume.");
  claim.same_slip_as("eq_9_1");
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    constexpr int N = n + 1;
    auto const j = draw_jet<S, n, N>(draw);
    auto const eta = draw_map_at<S, n>(j.particle(), draw);
    auto const lifted = prolongation(relabelling<N>(eta), j);
    claim.equal("the particle goes over by the map", model, Matrix<S, n, 1>(lifted.particle()), eta.to);
    claim.equal("time stays", model, lifted.x[0], j.x[0]);
    claim.differs("the particle left where it was", model, Matrix<S, n, 1>(j.particle()), eta.to);
    Matrix<S, N, n> const formula = j.gradient() * inverse_matrix(eta.slope);
    claim.equal("gradients: v and beta times the inverse", model, lifted.gradient(), formula, 10);
    claim.equal("rates in time stay", model, lifted.velocity(), j.velocity());
    claim.equal("places and multiplier stay", model, lifted.y, j.y);
    claim.differs("without the inverse", model, lifted.gradient(), (j.gradient() * eta.slope).eval());
    claim.differs("transposed", model, lifted.gradient(),
                  (j.gradient() * inverse_matrix(eta.slope).transpose()).eval());
  });
}

STATEMENT(eq_9_3, "infinitesimal prolongation in coordinates") {
  claim.convention(
      "For the lift (9.1) as it stands; divergence-free means $\\partial_k(\\sqrt{\\det G}\\,\\xi^k)=0$, the "
      "rate at which the flow changes the volume. The formula holds for any field on the body. With (9.1) "
      "put "
      "right, a multiplier that is a density, $-D_\\mu(\\lambda\\,\\partial_k\\xi^k)$ is added along "
      "$\\beta_\\mu$, which vanishes for fields of the group where $\\det G$ is constant.");
  claim.same_slip_as("eq_9_1");
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    constexpr int N = n + 1;
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
    // The multiplier as a density: beside the lift as printed, -D_mu(lambda d_k xi^k).
    auto const density = jet_at<n, N>(prolonged<n, N>(density_relabelling_field<N>(xi))(coordinates(j)));
    auto const expansion = [&]<class T>(Matrix<T, n, 1> const& x) { return divergence(xi, x); };
    auto const [rate_of_volume, its_slope] = derivative(expansion, Matrix<S, n, 1>(j.particle()));
    Matrix<S, 1, n + 1> expected = lift.v.row(n) - j.v.row(n) * rate_of_volume;
    expected.template tail<n>() -= its_slope * j.y[n];
    claim.equal("the multiplier as a density", model, Matrix<S, 1, n + 1>(density.v.row(n)), expected, 10);
    claim.differs("the multiplier as a density, with the lift as printed", model,
                  Matrix<S, 1, n + 1>(density.v.row(n)), Matrix<S, 1, n + 1>(lift.v.row(n)));
    // A field of the group: the determinant of its flow makes up for the change of the volume.
    auto const G = draw_metric<S, n>(draw);
    Matrix<S, n, 1> const x = j.particle();
    auto const along_flow = tangent<n, N>(relabelling<N>(flow_of(xi)), Event<T, n>(j.x.template cast<T>()),
                                          Matrix<T, N, 1>(j.y.template cast<T>()));
    S const growth = (volume<T>(G(Matrix<T, n, 1>(moved.particle()))) * determinant(along_flow.base)).part[0],
            volume_here = volume<S>(G(x));
    // Ten more roundings: a determinant and the root of another, both differentiated.
    claim.equal("the volume along the flow of any field grows by its divergence", model, growth,
                S(divergence(G, xi, x) * volume_here), 10);
    claim.differs("by its divergence in coordinates", model, growth, S(divergence(xi, x) * volume_here));
    claim.zero("fields of the group are divergence-free", model,
               divergence(G, draw_relabelling<S, n>(G, draw), x), S(1), 10);
    claim.refutes("fields of another body's group", model, divergence(G, draw_compression<S, n>(draw), x),
                  S(1));
  });
}

STATEMENT(claim_9_1_prolonged_velocities, "velocity components of the infinitesimal prolongation") {
  claim.holds("A relabelling that changes in time would add $-v^a{}_m\\,\\partial_t\\xi^m$.");
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    constexpr int N = n + 1;
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
    Matrix<S, n, 1> const rate =
        derivative_along(field(false), point_of(j), Variation<S, n, N>(Variation<S, n, N>::Unit(0)))
            .rate.template segment<n>(1);
    claim.equal("a field that depends on time", model, running.velocity(), (-j.gradient() * rate).eval());
    claim.refutes("no rate of the velocities for a field that depends on time", model, running.velocity(),
                  S(1));
  });
}

// ----
// Equivariance of densities and invariance of the action.

namespace {

/// The difference of the actions of a moved section and of the section, over the boxes from the origin to a
/// corner, as a function of the corner: for n = 1.
template <class S, class Eta, class Phi>
auto action_gained(AnyDensity<S, 1, 2> const& L, Eta const& eta, Phi const& phi, int degree) {
  return [=]<class T>(Event<T, 1> const& corner) {
    Event<S, 1> const low = Event<S, 1>::Zero(), high = Event<S, 1>::Constant(S(1));
    auto const gained = [&](Event<S, 1> const& s) -> T {
      Event<T, 1> const x(corner[0] * T(s[0]), corner[1] * T(s[1]));
      auto const tilted = tilted_jet(moved_map(eta, phi), x);
      return T((L(tilted.jet) * tilted.stretch - L(first_jet(phi, x))) * corner[0] * corner[1]);
    };
    return integral(gained, low, high, degree);
  };
}

}  // namespace

STATEMENT(claim_9_1_equivariance, "equivariance of a Lagrangian density under a group") {
  claim.convention(
      "Equivalent to invariance of the action over every region, which moves with $\\eta_X$: the "
      "action gained over a box has the defect of equivariance at its corner as its mixed derivative "
      "by the corner. Invariance up to what happens at the boundary would allow a divergence: a "
      "Galilean boost adds one to the density of a medium in flat space, which is not equivariant, and "
      "its action over a box changes.");
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    auto const fluid = draw_homogeneous_fluid<S, n>(draw);
    auto const j = draw_jet<S, n, n>(draw);
    auto const at_particle = draw_relabelling_at<S, n>(fluid.G, j.particle(), draw);
    auto const eta = relabelling<n>(at_particle);
    auto const V = draw_tangents<S, n + 1, n + 1>(draw);
    // Both sides as forms at eta(x), on vectors that come from x.
    Matrix<S, n + 1, n + 1> const W = tangent<n, n>(eta, j.x, j.y).base * V;
    S const left = fluid(prolongation(eta, j)) * determinant(W), right = fluid(j) * determinant(V);
    claim.equal("forms at the moved point", model, left, right, 10);
    auto const squeezing = relabelling<n>(draw_map_at<S, n>(j.particle(), draw));
    claim.refutes("a map that does not preserve the volume", model, equivariance_defect(fluid, squeezing, j),
                  fluid(j));
    // The derivative of the defect along a flow is the rate.
    auto const xi = draw_body_field<S, n>(draw);
    using T = Dual<S>;
    T const along_flow = PulledBackDensity{fluid, relabelling<n>(flow_of(xi))}(j.template cast<T>());
    claim.equal("the rate is the derivative of the defect", model, along_flow.part[0],
                equivariance_rate(fluid, relabelling_field<n>(xi), j), 10);
  });
  {
    // Sections of first degree have all the jets there are.
    std::string const model = "any density, n = 1, N = 2";
    auto L = draw_density<S, 1, 2>(draw);
    L.l.e.setZero(), L.m.e.setZero(), L.m.d.setZero();
    auto any = draw_automorphism<S, 1, 2>(draw);
    for (auto& c : any.places) c.e.setZero();
    auto phi = draw_section<S, 1, 2>(draw);
    for (auto& c : phi.added) c.e.setZero(), c.d.setZero();
    auto const eta = as_automorphism(any);
    // Values of second degree and derivatives of first, in products of two and three.
    auto const gained = action_gained(L, eta, phi, 6);
    Event<S, 1> corner = draw_event<S, 1>(draw);
    corner[1] += S(1), corner[0] += S(1);
    auto const by_time = [&]<class T>(T const& x) {
      return derivative([&]<class U>(U const& t) { return gained(Event<U, 1>(t, U(x))); }, T(corner[0])).rate;
    };
    S const mixed = derivative(by_time, corner[1]).rate;
    S const defect = equivariance_defect(L, eta, first_jet(phi, corner));
    claim.equal("the action gained, differentiated by the corner", model, mixed, defect, 100);
    claim.refutes("the action of a density that is not equivariant", model, gained(corner),
                  action(L, phi, Box<S, 1>{Event<S, 1>::Zero(), corner}, 6));
  }
  // Galileo's boost of a medium in flat space: the density gains a divergence.
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    auto fluid = draw_polynomial_fluid<S, n>(draw);
    auto const g = fluid.g(Matrix<S, n, 1>(Matrix<S, n, 1>::Zero()));
    auto const b = draw.vector<S, Matrix<S, n, 1>>(n);
    S const mass = fluid.rho(b);
    // rho (phi + t b/2).g b, of which the boost adds the rate in time.
    auto const K = [&]<class T>(Jet<T, n, n> const& j) -> T {
      Matrix<T, n, 1> const middle = j.y + b.template cast<T>() * T(j.x[0] / T(2));
      return inner(Matrix<T, n, n>(g.template cast<T>()), middle, Matrix<T, n, 1>(b.template cast<T>())) *
             T(mass);
    };
    auto const j = draw_second_jet<S, n, n>(draw);
    S const defect = equivariance_defect(fluid, galilean_boost<n>(b), first(j));
    claim.equal("boost: the density gains a divergence", model, defect, total_derivative(0, K, j), 10);
    claim.refutes("boost: the density is equivariant", model, defect, fluid(first(j)));
    if constexpr (n == 2) {
      auto phi = draw_section<S, n, n>(draw);
      for (auto& c : phi.added) c.e.setZero();
      Box<S, n> const box{{S(0), S(0), ratio<S>(-1, 3)}, {S(1), ratio<S>(1, 2), ratio<S>(1, 3)}};
      auto const flux = flux_form([&](auto const& x) {
        Event<ScalarOf<decltype(x)>, n> current = x;
        current.setZero();
        current[0] = K(first_jet(phi, x));
        return current;
      });
      S const before = action(fluid, phi, box, 4),
              after = tilted_action(fluid, moved_map(galilean_boost<n>(b), phi), box, 4);
      claim.equal("boost: what the action over a box gains is at its boundary", model, S(after - before),
                  boundary_integral(flux, box, 4), 100);
      claim.differs("boost: the action over a box stays", model, after, before);
    }
  });
}

// ----
// Equivariance of the two fluid Lagrangians under relabelling.

STATEMENT(prop_9_1_1, "equivariance of the two fluid Lagrangians under relabelling") {
  claim.corrected(
      "\\mathcal L(\\eta_{J^1E}(\\bar\\gamma))=(\\eta_X^{-1})^*\\mathcal L(\\bar\\gamma)\\ "
      "\\text{for}\\ \\eta_E=(y^a,\\lambda)",
      "\\mathcal L(\\eta_{J^1E}(\\bar\\gamma))=(\\eta_X^{-1})^*\\mathcal L(\\bar\\gamma)\\ \\text{for}\\ "
      "\\eta_E=\\bigl(y^a,\\lambda/\\det\\partial\\eta\\bigr)",
      "The barotropic fluid is equivariant as printed, for every metric of the body; the incompressible "
      "one is with a multiplier that goes over as a density, and with the printed lift only where "
      "$\\det G$ is constant. A finite relabelling enters at a jet through its image and its tangent "
      "map alone, and all of them are drawn.");
  claim.same_slip_as("eq_9_1");
  // Each density is of degree some 24 with its denominators, a field 12.
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    constexpr int N = n + 1;
    auto const fluid = draw_homogeneous_fluid<S, n>(draw);
    auto const j = draw_pressed_jet<S, n>(draw);
    auto const below = deformation(j);
    // Defects and rates are sums of terms of the size of L.
    S const scale = fluid(below);
    auto const eta = draw_relabelling_at<S, n>(fluid.G, j.particle(), draw);
    claim.zero("barotropic, any finite relabelling", model,
               equivariance_defect(fluid, relabelling<n>(eta), below), scale, 10);
    claim.zero("incompressible, any finite relabelling", model,
               equivariance_defect(incompressible(fluid), density_relabelling<N>(eta), j), scale, 10);
    claim.refutes("printed: incompressible, the multiplier left as it is", model,
                  equivariance_defect(incompressible(fluid), relabelling<N>(eta), j), scale);
    claim.refutes("barotropic, mass that varies", model,
                  equivariance_defect(with_varying_mass(fluid, draw), relabelling<n>(eta), below), scale);
    auto const squeezing = draw_map_at<S, n>(j.particle(), draw);
    claim.refutes("barotropic, a map that does not preserve the volume", model,
                  equivariance_defect(fluid, relabelling<n>(squeezing), below), scale);
    claim.refutes("incompressible, a map that does not preserve the volume", model,
                  equivariance_defect(incompressible(fluid), density_relabelling<N>(squeezing), j), scale);

    auto const xi = draw_relabelling<S, n>(fluid.G, draw);
    claim.zero("barotropic, any divergence-free field", model,
               equivariance_rate(fluid, relabelling_field<n>(xi), below), scale, 10);
    claim.zero("incompressible, any divergence-free field", model,
               equivariance_rate(incompressible(fluid), density_relabelling_field<N>(xi), j), scale, 10);
    claim.refutes("printed: incompressible, a field that leaves the multiplier as it is", model,
                  equivariance_rate(incompressible(fluid), relabelling_field<N>(xi), j), scale);
  });
}

STATEMENT(claim_9_1_barotropic_equivariance, "equivariance of the barotropic Lagrangian under relabelling") {
  claim.holds(
      "For every metric of the body, where volume-preserving means $\\sqrt{\\det "
      "G(\\eta(x))}\\,\\det\\partial\\eta=\\sqrt{\\det G(x)}$.");
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    auto const fluid = draw_homogeneous_fluid<S, n>(draw);
    auto const j = draw_jet<S, n, n>(draw);
    auto const at_particle = draw_relabelling_at<S, n>(fluid.G, j.particle(), draw);
    auto const eta = relabelling<n>(at_particle);
    claim.zero("any finite relabelling", model, equivariance_defect(fluid, eta, j), fluid(j), 10);
    claim.refutes("mass that varies", model, equivariance_defect(with_varying_mass(fluid, draw), eta, j),
                  fluid(j));
    claim.refutes("determinant 1, where det G varies", model,
                  equivariance_defect(fluid, relabelling<n>(at_particle.with_determinant(S(1))), j),
                  fluid(j));
  });
}

STATEMENT(claim_9_1_incompressible_equivariance,
          "equivariance of the incompressible Lagrangian under relabelling") {
  claim.corrected(
      "\\eta_E=(y^a,\\lambda)", "\\eta_E=\\bigl(y^a,\\lambda/\\det\\partial\\eta\\bigr)",
      "With the multiplier left as it is, as (9.1) has it, only in coordinates with constant $\\det G$, "
      "and elsewhere at jets with $J=1$ alone; at all jets with $\\lambda=\\sqrt{\\det G}\\,P$ "
      "transformed as a density, $P$ fixed.");
  claim.same_slip_as("eq_9_1");
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    constexpr int N = n + 1;
    auto fluid = draw_homogeneous_fluid<S, n>(draw);
    auto const j = draw_pressed_jet<S, n>(draw);
    S const scale = fluid(deformation(j));
    auto const eta = draw_relabelling_at<S, n>(fluid.G, j.particle(), draw);
    claim.zero("det G varies: the multiplier carried as a density", model,
               equivariance_defect(ideal(fluid), density_relabelling<N>(eta), j), scale, 10);
    claim.refutes("printed: det G varies, the multiplier left as it is", model,
                  equivariance_defect(ideal(fluid), relabelling<N>(eta), j), scale);
    auto const xi = draw_relabelling<S, n>(fluid.G, draw);
    claim.zero("the same for a field", model,
               equivariance_rate(ideal(fluid), density_relabelling_field<N>(xi), j), scale, 10);
    claim.refutes("printed: the same for a field", model,
                  equivariance_rate(ideal(fluid), relabelling_field<N>(xi), j), scale);
    auto kept = j;
    kept.v.col(1).template head<n>() /=
        jacobian(fluid.G(j.particle()), fluid.g(deformation(j).y), deformation(j).gradient());
    claim.zero("where J = 1: the multiplier left as it is", model,
               equivariance_defect(ideal(fluid), relabelling<N>(eta), kept), scale, 10);
    fluid.G = draw_stretchable_metric<S, n>(draw, true);
    auto const even = draw_relabelling_at<S, n>(fluid.G, j.particle(), draw);
    claim.zero("constant det G: the multiplier left as it is", model,
               equivariance_defect(ideal(fluid), relabelling<N>(even), j), scale, 10);
  });
}

STATEMENT(claim_9_1_jacobian_functions, "functions of the Jacobian and the determinant of a relabelling") {
  claim.corrected(
      "\\det\\partial_i\\eta^j=1,\\quad f(J(\\eta_{J^1E}(\\bar\\gamma)))\\,d^{m+1}x=(\\eta_X^{-1})^*"
      "\\bigl(f(J(\\bar\\gamma))\\,d^{m+1}x\\bigr)",
      "\\det\\partial_i\\eta^j=\\sqrt{\\det G}/(\\sqrt{\\det G}\\circ\\eta),\\quad "
      "f(J(\\eta_{J^1E}(\\bar\\gamma)))\\sqrt{\\det "
      "G}\\,d^{n+1}x=(\\eta_X^{-1})^*\\bigl(f(J(\\bar\\gamma))\\sqrt{\\det G}\\,d^{n+1}x\\bigr)",
      "The printed forms need coordinates in which $\\det G$ is constant, while (6.1) and (6.3) "
      "are written for any. That $J$ is the same before and after holds in all of them. The degree "
      "is printed $m+1$, as in (6.3).");
  claim.same_slip_as("eq_9_1");
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    auto const fluid = draw_homogeneous_fluid<S, n>(draw);
    auto const &G = fluid.G, &g = fluid.g;
    auto const j = draw_jet<S, n, n>(draw);
    auto const eta = draw_relabelling_at<S, n>(G, j.particle(), draw);
    auto const to = prolongation(relabelling<n>(eta), j);
    S const det = determinant(tangent<n, n>(relabelling<n>(eta), j.x, j.y).base);
    S const before = jacobian(G(j.particle()), g(j.y), j.gradient()),
            after = jacobian(G(to.particle()), g(to.y), to.gradient());
    S const root_before = volume<S>(G(j.particle())), root_after = volume<S>(G(to.particle()));
    claim.equal("J is the same", model, after, before, 10);
    claim.equal("f(J) times the volume of the body", model, S(fluid.W.w(after) * root_after * det),
                S(fluid.W.w(before) * root_before), 10);
    claim.equal("the constraint times the volume of the body", model, S((after - S(1)) * root_after * det),
                S((before - S(1)) * root_before), 100);
    claim.differs("printed: the determinant is 1", model, det, S(1));
    claim.differs("printed: f(J) without the volume of the body", model, S(fluid.W.w(after) * det),
                  fluid.W.w(before));
    auto const other = draw_map_at<S, n>(j.particle(), draw);
    auto const squeezed = prolongation(relabelling<n>(other), j);
    claim.differs("J under a map that does not preserve the volume", model,
                  jacobian(G(squeezed.particle()), g(squeezed.y), squeezed.gradient()), before);
  });
}
