// Chapter 9, introduction: relabelling of inhomogeneous fluids, isometries of space, translation of time.
#include "fields/fields.hpp"

#include "actio/groups/rotations.hpp"
#include "actio/linear_algebra/rank.hpp"
#include "actio/noether/isometries.hpp"
#include "actio/noether/time_translation.hpp"
#include "fields/stored_energies.hpp"
#include "fields/symmetries.hpp"
#include "statement.hpp"

namespace {

using namespace actio;
using namespace actio::checks;

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
/// The inversion \f$y/|y|^2\f$, an isometry of the sphere in stereographic coordinates. It turns inside out;
/// with the first coordinate reflected as well it does not.
struct Inversion {
  bool reflected = false;
  template <class V>
  auto operator()(V const& y) const {
    using T = ScalarOf<V>;
    T square(0);
    for (int a = 0; a < y.size(); ++a) square += y[a] * y[a];
    auto z = Matrix<T, V::RowsAtCompileTime, 1>(y / square);
    if (reflected) z[0] = -z[0];
    return z;
  }
};
/// The motion \f$y\mapsto Ry + b\f$ of flat space.
template <class S, int N>
struct FlatMotion {
  Matrix<S, N, N> R;
  Matrix<S, N, 1> b;
  template <class V>
  auto operator()(V const& y) const {
    using T = ScalarOf<V>;
    Matrix<T, N, 1> z;
    for (int a = 0; a < N; ++a) {
      z[a] = T(b[a]);
      for (int c = 0; c < N; ++c) z[a] += y[c] * T(R(a, c));
    }
    return z;
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
/// A field on space, and no change of the pressure that comes after its coordinates.
template <int N, class Field>
struct BesidePressure {
  Field k;
  template <class V>
  auto operator()(V const& y) const {
    using T = ScalarOf<V>;
    Matrix<T, N + 1, 1> rate;
    rate << k(Matrix<T, N, 1>(y.template head<N>())), T(0);
    return rate;
  }
};
template <class S, int N>
Matrix<S, N, N> draw_skew(Draw& draw) {
  Matrix<S, N, N> const any = draw_tangents<S, N, N>(draw);
  return any - any.transpose();
}
/// What the stored energy adds to the Lagrangian.
template <class Medium, class S, int n, int N>
S energy_of(Medium const& medium, Jet<S, n, N> const& j) {
  auto const x = j.particle();
  auto const G = medium.G(x);
  return -volume<S>(G) * medium.rho(x) * medium.W(x, G, medium.g(j.y), j.gradient());
}
/// Whether a body of this kind may have these dimensions.
template <int n, int N>
std::vector<Kind> kinds() {
  if (n == N) return {Kind::solid, Kind::fluid, Kind::isentropic};
  return {Kind::solid};
}

/// A field on Y with affine components, \f$\xi^\mu\f$ of space-time alone: what a field is at a point to
/// first order. Its coefficients, one after the other.
template <class S, int n, int N>
struct AffineField {
  static constexpr int base = (n + 1) * (n + 2), size = base + N * (n + 2 + N);
  Matrix<S, size, 1> c;
  Matrix<S, n + 1 + N, 1> origin;
  template <class V>
  auto operator()(V const& point) const {
    using T = ScalarOf<V>;
    Matrix<T, n + 1 + N, 1> rate;
    int k = 0;
    for (int i = 0; i < n + 1 + N; ++i) {
      rate[i] = T(c[k++]);
      for (int m = 0; m < (i <= n ? n + 1 : n + 1 + N); ++m) rate[i] += (point[m] - T(origin[m])) * T(c[k++]);
    }
    return rate;
  }
};
/// How many fields are, to first order at one point of Y, symmetries of all media: those that `draw_density`
/// makes, at jets over that point.
template <class S, int n, int N, class DrawDensity>
int shared_symmetries(Draw& draw, DrawDensity const& draw_density) {
  using Field = AffineField<S, n, N>;
  auto const over = draw_jet<S, n, N>(draw);
  Matrix<S, Field::size + 2, Field::size> rates;
  for (int row = 0; row < rates.rows(); ++row) {
    auto const density = draw_density();
    auto j = over;
    j.v += draw_tangents<S, N, n + 1>(draw);
    for (int k = 0; k < Field::size; ++k) {
      Matrix<S, Field::size, 1> const unit = Matrix<S, Field::size, 1>::Unit(k);
      rates(row, k) = equivariance_rate(density, Field{unit, point_of(over)}, j);
    }
  }
  return Field::size - matrix_rank(rates);
}
/// A medium that ages: its density grows with time.
template <class L>
struct Ageing {
  L density;
  template <class S, int n, int N>
  S operator()(Jet<S, n, N> const& j) const { return density(j) * (j.x[0] + 2); }
};
/// Time runs on at a rate that grows.
struct GrowingTime {
  template <class V>
  auto operator()(V const& point) const {
    auto rate = TimeTranslation{}(point);
    rate[0] = point[0];
    return rate;
  }
};
/// Body, or space, is shifted along its first axis.
template <int place>
struct Shift {
  template <class V>
  auto operator()(V const& point) const {
    auto rate = TimeTranslation{}(point);
    std::swap(rate[0], rate[place]);
    return rate;
  }
};
template <class S, int N>
auto shifted_time(S const& tau) {
  return Automorphism{[tau](auto const& x) {
                        using T = ScalarOf<decltype(x)>;
                        auto moved = x;
                        moved[0] += T(tau);
                        return moved;
                      },
                      FixedFibre<N>{}};
}

}  // namespace

STATEMENT(claim_9_0_inhomogeneous_subgroup, "relabelling subgroup for inhomogeneous fluids") {
  claim.convention(
      "A relabelling must take each level set of the density, and of the entropy, to itself: one "
      "that exchanges level sets is no symmetry. The stored energy depends on the point of the body "
      "through these alone. Among the fields that preserve the volume those along the level sets "
      "are all symmetries there are: the rate of the Lagrangian is that of the density or the "
      "entropy, times what is not zero.");
  // The energy is of degree 24 in the coordinates after clearing denominators, the field of degree 12.
  over_points(claim, PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    auto fluid = draw_medium<S, n>(draw, Kind::isentropic);
    auto const j = draw_jet<S, n, n>(draw);
    auto const x = j.particle();
    auto const field_of = [&](AnyPotential<S, n> const& A) { return PotentialField<S, n>{fluid.G, A}; };
    auto const rate = [&](auto const& field) {
      return equivariance_rate(fluid, relabelling_field<n>(field), j);
    };
    auto const linear = draw_linear<S, n>(draw);
    auto const levels = field_of(along_levels<S, n>(fluid.rho.added, linear)),
               across = field_of(draw_potential<S, n>(draw));
    Cubic<S, n> const entropy = fluid.W.entropy;

    fluid.W.kind = Kind::fluid, fluid.W.entropy = constant_cubic<S, n>(S(0));
    S const L = fluid(j), rho = fluid.rho(x);
    claim.zero("along level sets of the density: rate of equivariance", model, rate(levels), L);
    claim.refutes("divergence-free, across level sets", model, rate(across), L);
    // Ten more roundings: the rate differentiates roots of determinants, the other side has none.
    S const slope = derivative(fluid.rho, x).gradient().dot(across(x));
    claim.equal("the rate is that of the density", model, rate(across), S(L * slope / rho), 10);
    claim.differs("of the kinetic energy alone", model, rate(across),
                  S((L - energy_of(fluid, j)) * slope / rho));

    // With entropy: in the plane both functions must have the same level sets, or nothing is left of the
    // group.
    fluid.W.kind = Kind::isentropic, fluid.W.entropy = n == 2 ? fluid.rho.added : linear;
    claim.zero("along level sets of density and entropy", model, rate(levels), L);
    fluid.W.entropy = entropy;
    claim.refutes("across level sets of the entropy", model, rate(levels), L);
    // Of the energy s J^2 alone the entropy knows.
    S const J = jacobian(fluid.G(x), fluid.g(j.y), j.gradient());
    S const grown = derivative(entropy, x).gradient().dot(levels(x));
    claim.equal("the rate is that of the entropy", model, rate(levels),
                S(-volume<S>(fluid.G(x)) * rho * J * J * grown), 10);
  });
  // Finite maps of a flat body with the density 2 + x^1 and, in space, the entropy x^2.
  over_points(claim, PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    auto flat = draw_medium<S, n>(draw, Kind::isentropic);
    flat.G = flattened(flat.G), flat.G.constant = Matrix<S, n, n>::Identity();
    flat.rho.added = constant_cubic<S, n>(S(0)), flat.rho.added.a[0] = S(1);
    flat.W.entropy = constant_cubic<S, n>(S(0)), flat.W.entropy.a[n - 2] = S(1);
    auto const j = draw_jet<S, n, n>(draw);
    auto const shear = [](auto x) { return x[n - 1] += x[0] * x[0] + x[0] * x[n - 2], x; };
    auto const half_turn = [](auto x) { return x[0] = -x[0], x[1] = -x[1], x; };
    std::string const what = model + ", flat body, density 2 + x1";
    claim.zero("a shear along level sets", what, equivariance_defect(flat, relabelling<n>(shear), j),
               flat(j));
    claim.refutes("a half turn, which exchanges level sets", what,
                  equivariance_defect(flat, relabelling<n>(half_turn), j), flat(j));
  });
}

STATEMENT(claim_9_0_isometries, "isometries of the spatial metric as symmetries") {
  claim.convention(
      "The stored energy must depend on the metric of space and on the deformation through the Green "
      "tensor alone (or be equivariant under isometries in another way), and the isometry must respect the "
      "boundary conditions. Of a fluid, which knows the sign of $J$, an isometry that turns space inside "
      "out is none. The solid has no symmetry of its own.");
  // A cubic of the Green tensor, which is of degree 12 with the denominators of the sphere and the body.
  over_points(
      claim, std::tuple<Dimensions<2, 2>, Dimensions<3, 3>, Dimensions<2, 3>>{},
      [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
        StereographicSphere<S, N> const sphere{ratio<S>(1, 2)};
        auto const j = draw_jet<S, n, N>(draw);
        SphereRotation<S, N> const turning{draw_skew<S, N>(draw), draw.vector<S, Matrix<S, N, 1>>(N)};
        claim.zero("the field is Killing", model, lie_derivative(sphere, turning, j.y), S(1));
        // Roots of det g at the two ends of a finite map have one sign where 1 + |y|^2 and |y|^2 are
        // positive.
        draw_positive(S(j.y.dot(j.y) + 1)), draw_positive(S(j.y.dot(j.y)));
        for (Kind const kind : kinds<n, N>()) {
          std::string const what = model + (kind == Kind::solid ? ", solid" : ", fluid");
          auto const medium = Continuum{draw_metric<S, n>(draw), sphere, draw_mass<S, n>(draw),
                                        draw_energy_of<S, n, N>(draw, kind)};
          // Ten more roundings: turned coordinates pass through the metrics. The terms of the rate: L once
          // differentiated; L may be small beside them.
          S const scale = medium(j) + inner(sphere(j.y), j.velocity(), j.velocity()) + S(1);
          claim.zero("on a sphere: rate of equivariance", what,
                     equivariance_rate(medium, motion_of_space<N>(turning), j), scale, 10);
          auto const dilation = [](auto const& y) { return y; };
          claim.refutes("dilation, which is not Killing", what,
                        equivariance_rate(medium, motion_of_space<N>(dilation), j), scale);
          claim.zero("finite rotation", what, equivariance_defect(medium, of_space<N>(Turn{}), j), scale, 10);
          claim.zero("finite inversion and reflection", what,
                     equivariance_defect(medium, of_space<N>(Inversion{true}), j), scale, 10);
          S const inside_out = equivariance_defect(medium, of_space<N>(Inversion{}), j);
          if (kind == Kind::solid)
            claim.zero("finite inversion", what, inside_out, scale, 10);
          else
            claim.refutes("inversion, which turns inside out", what, inside_out, scale);
        }
        if constexpr (n == 2) {
          auto const other = Continuum{draw_metric<S, n>(draw), sphere, draw_mass<S, n>(draw), Fibred{}};
          claim.refutes("an energy that depends on more than the Green tensor", model,
                        equivariance_rate(other, motion_of_space<N>(turning), j), other(j));
        }
      });
}

STATEMENT(claim_9_0_euclidean_isometries, "rotations and translations as symmetries in Euclidean space") {
  claim.convention(
      "The stored energy is a function of the Green tensor or of $J$, as in the standard models. "
      "Fluids with and without entropy, solids without symmetry, shells, incompressible fluids "
      "and solids. Momentum and moment of momentum are the currents, closed along solutions of "
      "the media without a constraint.");
  over_points(
      claim, std::tuple<Dimensions<2, 2>, Dimensions<3, 3>, Dimensions<2, 3>>{},
      [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
        ConstantMetric<S, N> const flat{Matrix<S, N, N>::Identity()};
        auto const off = draw_second_jet<S, n, N>(draw);
        Jet<S, n, N> const& j = off;
        RigidMotion<S, N> const motion{draw_skew<S, N>(draw), draw.vector<S, Matrix<S, N, 1>>(N)};
        RigidMotion<S, N> const shear{draw_tangents<S, N, N>(draw), motion.shift};
        FlatMotion<S, N> const finite{draw.element<S>(SO<N>{}).value, draw.vector<S, Matrix<S, N, 1>>(N)},
            stretched{finite.R * S(2), finite.b};
        for (Kind const kind : kinds<n, N>()) {
          std::string const what = model + (kind == Kind::solid   ? ", solid"
                                            : kind == Kind::fluid ? ", fluid"
                                                                  : ", fluid with entropy");
          auto const medium = Continuum{draw_metric<S, n>(draw), flat, draw_mass<S, n>(draw),
                                        draw_energy_of<S, n, N>(draw, kind)};
          S const scale = medium(j) + j.velocity().dot(j.velocity()) + S(1);
          // Ten more roundings: turned coordinates pass through the Green tensor. Along solutions a hundred:
          // the acceleration is solved for from forces with second derivatives of the energy.
          claim.zero("rates of rotation and translation", what,
                     equivariance_rate(medium, motion_of_space<N>(motion), j), scale, 10);
          claim.refutes("a rate that is not skew", what,
                        equivariance_rate(medium, motion_of_space<N>(shear), j), scale);
          claim.zero("finite rotation and translation", what,
                     equivariance_defect(medium, of_space<N>(finite), j), scale, 10);
          claim.refutes("a rotation that stretches", what,
                        equivariance_defect(medium, of_space<N>(stretched), j), scale);
          auto const closed = [&](auto const& at, auto const& field) {
            return current_divergence(medium, motion_of_space<N>(field), at);
          };
          auto const on = of_a_solution(medium, off);
          S const forces = closed(off, motion) + S(1);
          claim.zero("momentum and moment of momentum along solutions", what, closed(on, motion), forces,
                     100);
          claim.refutes("of a rate that is not skew", what, closed(on, shear), forces);
          if constexpr (n == N) {
            if (kind == Kind::isentropic) continue;
            auto const density = incompressible(medium);
            auto const extended = draw_jet<S, n, n + 1>(draw);
            S const size = density(extended) + S(1);
            auto const beside = [&](auto const& field) {
              return equivariance_rate(
                  density, motion_of_space<n + 1>(BesidePressure<n, RigidMotion<S, n>>{field}), extended);
            };
            claim.zero("incompressible: rates", what, beside(motion), size, 10);
            claim.refutes("incompressible: a rate that is not skew", what, beside(shear), size);
          }
        }
      });
}

STATEMENT(claim_9_0_time_translation, "translation of time as the symmetry that all media share") {
  claim.holds(
      "Of media whose mass, metrics and stored energy are functions of the body and of space. "
      "Fields that are to first order at a point symmetries of all of them have there no part but a "
      "constant one along time, so that fields which are everywhere are multiples of the "
      "translation of time: it is the only one.");
  over_points(claim, BodiesInSpace{}, [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
    auto const j = draw_jet<S, n, N>(draw);
    auto const tau = draw.number<S>();
    for (Kind const kind : {Kind::any, Kind::solid, n == N ? Kind::isentropic : Kind::dust}) {
      auto const medium = draw_medium<S, n, N>(draw, kind);
      S const L = medium(j);
      claim.zero("any medium: rate", model, equivariance_rate(medium, TimeTranslation{}, j), L);
      claim.zero("any medium: finite", model, equivariance_defect(medium, shifted_time<S, N>(tau), j), L);
      claim.refutes("time at a growing rate", model, equivariance_rate(medium, GrowingTime{}, j), L);
      claim.refutes("the body shifted", model, equivariance_rate(medium, Shift<1>{}, j), L);
      claim.refutes("space shifted", model, equivariance_rate(medium, Shift<n + 1>{}, j), L);
      claim.refutes("a medium that ages", model,
                    equivariance_rate(Ageing<AnyContinuum<S, n, N>>{medium}, TimeTranslation{}, j), L);
    }
    // Ranks of exact matrices, once.
    if (!claim.first() || !exact_arithmetic<S>() || numbers_grow()) return;
    auto const any = [&] { return draw_medium<S, n, N>(draw, Kind::any); };
    auto const solid = [&] { return draw_medium<S, n, N>(draw, Kind::solid); };
    claim.fact("one symmetry is shared by all media", model, shared_symmetries<S, n, N>(draw, any) == 1);
    claim.fact("one symmetry is shared by all solids", model, shared_symmetries<S, n, N>(draw, solid) == 1);
  });
}
