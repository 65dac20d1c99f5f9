// Chapter 9, introduction: relabelling of inhomogeneous fluids and isometries of space.
#include "fields.hpp"

#include "actio/noether/isometries.hpp"
#include "statement.hpp"
#include "symmetries.hpp"

namespace {

using namespace actio;
using namespace actio::checks;

/// A fluid whose energy is \f$w(J) + s(x)\,J^2\f$, with the entropy s in it.
template <class S, int n>
struct Isentropic {
  AnyFluidLaw<S> law;
  Cubic<S, n> entropy;
  template <class BodyMetric, class SpaceMetric, class T>
  T operator()(Matrix<T, n, 1> const& x, BodyMetric const& G, SpaceMetric const& g,
               Matrix<T, n, n> const& F) const {
    T const J = jacobian(G, g, F);
    return law(J) + entropy(x) * J * J;
  }
};

/// An energy that depends on the first axis of space, and so more than the Green tensor: \f$(F^1{}_1)^2\f$.
struct Fibred {
  template <class X, class BodyMetric, class SpaceMetric, class M>
  auto operator()(X const&, BodyMetric const&, SpaceMetric const&, M const& F) const {
    return ScalarOf<M>(F(0, 0) * F(0, 0));
  }
};

/// A linear function on the body, and the potential whose field is tangent to its level sets and to those of
/// `mass`.
template <class S, int n>
Cubic<S, n> draw_linear(Draw& draw) {
  auto c = constant_cubic<S, n>(S(0));
  c.a = draw.vector<S, Matrix<S, n, 1>>(n);
  return c;
}
template <class S, int n>
AnyPotential<S, n> along_levels(Cubic<S, n> const& mass, Cubic<S, n> const& entropy) {
  AnyPotential<S, n> potential{mass, {}};
  // curl(mass grad entropy) = grad mass x grad entropy; in the plane a function of the mass alone will do.
  for (int i = 0; i < AnyPotential<S, n>::components; ++i)
    potential.A[i] = constant_cubic<S, n>(n == 2 ? S(1) : entropy.a[i]);
  return potential;
}

/// The plane rotation by the angle of the triangle 3, 4, 5, in the first two coordinates.
struct Turn {
  template <class V>
  auto operator()(V const& y) const {
    using T = ScalarOf<V>;
    auto z = Matrix<T, V::RowsAtCompileTime, 1>(y);
    z[0] = (y[0] * 3 - y[1] * 4) / 5;
    z[1] = (y[0] * 4 + y[1] * 3) / 5;
    return z;
  }
};
/// The inversion \f$y/|y|^2\f$, an isometry of the sphere in stereographic coordinates.
struct Inversion {
  template <class V>
  auto operator()(V const& y) const {
    using T = ScalarOf<V>;
    T square(0);
    for (int a = 0; a < y.size(); ++a) square += y[a] * y[a];
    return Matrix<T, V::RowsAtCompileTime, 1>(y / square);
  }
};
/// Space-time is fixed, space is mapped.
template <int N, class Map>
auto of_space(Map const& map) {
  return Automorphism{[](auto const& x) { return x; },
                      [map](auto const& point) {
    using T = ScalarOf<decltype(point)>;
    return map(Matrix<T, N, 1>(point.template tail<N>()));
                      }};
}

}  // namespace

STATEMENT(claim_9_0_inhomogeneous_subgroup, "relabelling subgroup for inhomogeneous fluids") {
  claim.convention(
      "A relabelling must take each level set of the density, and of the entropy, to itself: one that "
      "exchanges level sets is no symmetry. The stored energy depends on the point of the body through "
      "these alone.");
  // The energy is of degree 24 in the coordinates after clearing denominators, the field of degree 12.
  over_points(PlaneAndSpace{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const fluid = with_varying_mass(draw_homogeneous_fluid<S, n>(draw), draw);
    auto const entropy = draw_linear<S, n>(draw);
    auto const j = draw_jet<S, n, n>(draw);
    auto const field = [&](AnyPotential<S, n> const& A) {
      return relabelling_field<n>(PotentialField<S, n>{fluid.G, A});
    };
    auto const levels = along_levels<S, n>(fluid.rho.added, entropy);
    claim.zero("along level sets of the density: rate of equivariance", model,
               equivariance_rate(fluid, field(levels), j), fluid(j));
    claim.refutes("divergence-free, across level sets", model,
                  equivariance_rate(fluid, field(draw_potential<S, n>(draw)), j), fluid(j));

    // With entropy: in the plane both functions must have the same level sets, or nothing is left of the
    // group.
    auto isentropic = Continuum{fluid.G, fluid.g, fluid.rho,
                                Isentropic<S, n>{fluid.W.w, n == 2 ? fluid.rho.added : entropy}};
    claim.zero("along level sets of density and entropy", model,
               equivariance_rate(isentropic, field(levels), j), fluid(j));
    isentropic.W.entropy = draw_cubic<S, n>(draw);
    claim.refutes("across level sets of the entropy", model, equivariance_rate(isentropic, field(levels), j),
                  fluid(j));
  });
  // Finite maps of a flat body with the density 2 + x^1.
  auto flat = draw_homogeneous_fluid<S, 2>(draw);
  flat.G = {Matrix<S, 2, 2>::Identity(), {}, Matrix<S, 2, 2>::Zero()};
  for (auto& slope : flat.G.slope) slope.setZero();
  flat.rho.added = constant_cubic<S, 2>(S(0));
  flat.rho.added.a[0] = S(1);
  auto const j = draw_jet<S, 2, 2>(draw);
  auto const shear = [](auto const& x) { return std::remove_cvref_t<decltype(x)>(x[0], x[1] + x[0] * x[0]); };
  auto const half_turn = [](auto const& x) { return std::remove_cvref_t<decltype(x)>(-x[0], -x[1]); };
  claim.zero("a shear along level sets", "flat body, density 2 + x1",
             equivariance_defect(flat, relabelling<2>(shear), j), flat(j));
  claim.refutes("a half turn, which exchanges level sets", "flat body, density 2 + x1",
                equivariance_defect(flat, relabelling<2>(half_turn), j), flat(j));
}

STATEMENT(claim_9_0_isometries, "isometries of the spatial metric as symmetries") {
  claim.convention(
      "The stored energy must depend on the metric of space and on the deformation through the Green "
      "tensor alone (or be equivariant under isometries in another way), and the isometry must respect "
      "the boundary conditions.");
  // A cubic of the Green tensor, which is of degree 12 with the denominators of the sphere and the body.
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    StereographicSphere<S, n> const sphere{ratio<S>(1, 2)};
    auto const G = draw_metric<S, n>(draw);
    auto const mass = draw_mass<S, n>(draw);
    auto const solid = Continuum{G, sphere, mass, draw_solid<S>(draw)};
    auto const j = draw_jet<S, n, n>(draw);
    SphereRotation<S, n> turning{Matrix<S, n, n>::Zero(), draw.vector<S, Matrix<S, n, 1>>(n)};
    turning.turn(0, 1) = draw.number<S>();
    turning.turn(1, 0) = -turning.turn(0, 1);
    claim.zero("the field is Killing", model, lie_derivative(sphere, turning, j.y), S(1));
    // The terms of the rate: L once differentiated; L may be small beside them.
    S const scale = solid(j) + inner(sphere(j.y), j.velocity(), j.velocity()) + S(1);
    claim.zero("solid on a sphere: rate of equivariance", model,
               equivariance_rate(solid, motion_of_space<n>(turning), j), scale);
    auto const dilation = [](auto const& y) { return y; };
    claim.refutes("dilation, which is not Killing", model,
                  equivariance_rate(solid, motion_of_space<n>(dilation), j), scale);
    claim.zero("finite rotation", model, equivariance_defect(solid, of_space<n>(Turn{}), j), scale);
    claim.zero("finite inversion", model, equivariance_defect(solid, of_space<n>(Inversion{}), j), scale);

    auto const other = Continuum{G, sphere, mass, Fibred{}};
    claim.refutes("an energy that sees more than the Green tensor", model,
                  equivariance_rate(other, motion_of_space<n>(turning), j), scale);
  });
}
