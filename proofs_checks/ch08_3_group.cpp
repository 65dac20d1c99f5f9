// Section 8.3: the group of volume preserving diffeomorphisms, its algebra, its metric and its geodesics.

#include "actio/incompressible/bracket_of_fields.hpp"

#include "fields/box_fields.hpp"
#include "fields/incompressible_models.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

/// A wall f = c of any form, through a given point, as a function of time and place.
template <class S, int n>
struct Wall {
  Cubic<S, n> f;
  S level;
  template <class V>
  auto operator()(V const& at) const {
    using T = ScalarOf<V>;
    return T(f(Matrix<T, n, 1>(at.template tail<n>())) - T(level));
  }
};
template <class S, int n>
Wall<S, n> draw_wall(Draw& draw, Matrix<S, n, 1> const& y) {
  auto const f = draw_cubic<S, n>(draw);
  return {f, f(y)};
}
/// A cubic that vanishes at a wall: as the stream function of a field, it keeps the field along the wall.
template <class S, int n>
struct StreamAtWall {
  Wall<S, n> wall;
  Cubic<S, n + 1> cubic;
  template <class V>
  auto operator()(V const& at) const { return ScalarOf<V>(wall(at) * cubic(at)); }
};
template <class S, int n>
using FieldAlongWall = SolenoidalField<S, n, MetricOfVolume<S, n>, StreamAtWall<S, n>>;
template <class S, int n>
FieldAlongWall<S, n> draw_along_wall(Draw& draw, MetricOfVolume<S, n> const& g, Wall<S, n> const& wall) {
  FieldAlongWall<S, n> u{g, {}};
  for (auto& psi : u.psi) psi = {wall, draw_cubic<S, n + 1>(draw)};
  return u;
}
/// Any field along a wall, with a divergence: turned slopes of the wall, and a field that vanishes there.
template <class S, int n>
struct AnyAlongWall {
  Wall<S, n> wall;
  std::array<Cubic<S, n>, n*(n - 1) / 2> turn;
  std::array<Cubic<S, n>, n> inside;
  template <class V>
  auto operator()(V const& y) const {
    using T = ScalarOf<V>;
    Matrix<T, n, 1> const at = y, slope = derivative(wall, at).gradient();
    Matrix<T, n, 1> u;
    for (int a = 0; a < n; ++a) u[a] = inside[a](at) * wall(at);
    for (int a = 0, k = 0; a < n; ++a)
      for (int b = 0; b < a; ++b, ++k) {
        T const c = turn[k](at);
        u[a] += c * slope[b];
        u[b] -= c * slope[a];
      }
    return u;
  }
};
template <class S, int n>
AnyAlongWall<S, n> draw_any_along(Draw& draw, Wall<S, n> const& wall) {
  AnyAlongWall<S, n> u{wall, {}, {}};
  for (auto& c : u.turn) c = draw_cubic<S, n>(draw);
  for (auto& c : u.inside) c = draw_cubic<S, n>(draw);
  return u;
}
/// A field with its places added: without divergence before, with one after.
template <class Field>
struct Swollen {
  Field u;
  template <class V>
  auto operator()(V const& y) const { return (u(y) + y * (y[0] * y[1])).eval(); }
};
template <class Field>
Swollen(Field) -> Swollen<Field>;

/// A field of the body carried along by a motion: \f$T\phi_t\,Y\circ\phi_t^{-1}\f$, on time and space.
template <class Phi, class Field>
struct PushedForward {
  Phi phi;
  Field Y;
  template <class V>
  auto operator()(V const& at) const {
    using T = ScalarOf<V>;
    constexpr int n = V::RowsAtCompileTime - 1;
    Matrix<T, n + 1, 1> const from = phi.particle(at);
    Tangents<T, n + 1, 1> direction;
    direction << T(0), Y(Matrix<T, n, 1>(from.template tail<n>()));
    return Matrix<T, n, 1>(pushed(phi, from, direction));
  }
};
template <class Phi, class Field>
PushedForward(Phi, Field) -> PushedForward<Phi, Field>;

/// A motion followed by another one, for epsilon times the time: a variation that stays in the group.
template <class S, int n, class Epsilon>
struct Varied {
  Shears<S, n> motion, change;
  Epsilon epsilon;
  template <class V>
  V moved(V const& at, bool forth) const {
    V slow = at;
    slow[0] = at[0] * ScalarOf<V>(epsilon);
    if (forth)
      slow.template tail<n>() = change(slow);
    else
      slow = change.particle(slow);
    slow[0] = at[0];
    return slow;
  }
  template <class V>
  auto operator()(V const& x) const {
    auto at = x.eval();
    at.template tail<n>() = motion(x);
    return moved(at, true).template tail<n>().eval();
  }
  template <class V>
  auto particle(V const& y) const { return motion.particle(moved(y.eval(), false)); }
};
template <class S, int n, class Epsilon>
Varied(Shears<S, n>, Shears<S, n>, Epsilon) -> Varied<S, n, Epsilon>;

}  // namespace

STATEMENT(claim_8_3_lie_algebra_bracket, "the bracket of fields that keep the volume") {
  claim.holds(
      "Such fields along a wall of any form have such a bracket, and differentiating the adjoint action of "
      "any motion of the group gives minus the bracket of Jacobi and Lie. The volume grows along the flow "
      "of a field by its divergence, and so the flow stays in the group where there is none.");
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    auto const g = draw_metric_of_volume<S, n>(draw);
    S const t = draw.number<S>() * ratio<S>(1, 2);
    Event<S, n> at = draw_event<S, n>(draw);
    at[0] = t;
    Matrix<S, n, 1> const y = at.template tail<n>();
    auto const wall = draw_wall<S, n>(draw, y);
    AtTime const X{t, draw_along_wall(draw, g, wall)}, Y{t, draw_along_wall(draw, g, wall)};
    auto const bracket = diffeomorphism_bracket(X, Y);
    auto const slope = derivative(wall, y).gradient();
    S const size = size_of(bracket(y)) + S(1);
    claim.zero("divergence of the bracket", model, divergence(g, bracket, y), size);
    claim.refutes("where one of two fields has divergence", model,
                  divergence(g, diffeomorphism_bracket(X, Swollen{Y}), y), size);
    claim.zero("the bracket across the wall", model, slope.dot(bracket(y)), size);
    AtTime const Z{t, draw_solenoidal<S, n>(draw, g)};
    auto const crossing = diffeomorphism_bracket(X, Z)(y);
    claim.refutes("where one of two fields crosses it", model, slope.dot(crossing),
                  S(size_of(crossing) + S(1)));

    // The adjoint action of a motion on Y, differentiated in time, and the bracket with its velocity.
    auto const phi = draw_shears<S, n>(draw, g.chart, g.chart);
    PushedForward const carried{phi, Y};
    auto const rate = first_jet(carried, at).velocity();
    auto const right = diffeomorphism_bracket(AtTime{t, VelocityInSpace{phi}}, AtTime{t, carried})(y);
    claim.equal("rate of the adjoint action", model, rate, right);
    claim.differs("with the bracket of Jacobi and Lie", model, rate, (-right).eval());
    claim.differs("with Y not carried along", model, rate,
                  diffeomorphism_bracket(AtTime{t, VelocityInSpace{phi}}, Y)(y));

    // The velocities of the group, and the fields whose flow is in it: an infinitesimal is the time.
    AtTime const velocity{t, VelocityInSpace{phi}};
    claim.zero("divergence of the velocity of a motion of the group", model, divergence(g, velocity, y),
               S(size_of(first_jet(VelocityInSpace{phi}, at).gradient()) + S(1)));
    using T = Dual<S>;
    T epsilon(S(0));
    epsilon.part[0] = S(1);
    auto const any = draw_any_along(draw, wall);
    auto const flow = [&](auto const& z) { return (z + any(z) * ScalarOf<decltype(z)>(epsilon)).eval(); };
    Matrix<T, n, 1> const from = y.template cast<T>(), to = flow(from);
    Matrix<T, n, n> const F = pushed(flow, from, Tangents<T, n, n>(Tangents<T, n, n>::Identity()));
    S const growth = (volume<T>(g(to)) * determinant(F)).part[0], volume_here = volume<S>(g(y));
    // Ten more roundings: a determinant and the root of another, both differentiated.
    claim.equal("the volume along the flow of any field grows by its divergence", model, growth,
                S(divergence(g, any, y) * volume_here), 10);
    claim.differs("by its divergence in coordinates", model, growth, S(divergence(any, y) * volume_here));
    claim.zero("and the flow stays in the wall", model, wall(to).part[0], S(size_of(any(y)) + S(1)));
  });
}

STATEMENT(claim_8_3_tangent_bracket, "the bracket of fields along a boundary") {
  claim.holds(
      "For any two fields along a boundary of any form, with or without divergence. The derivative of one "
      "along the other alone leaves a boundary that is bent.");
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    Matrix<S, n, 1> const y = draw.vector<S, Matrix<S, n, 1>>(n);
    auto const wall = draw_wall<S, n>(draw, y);
    auto const X = draw_any_along(draw, wall), Y = draw_any_along(draw, wall);
    auto const slope = derivative(wall, y).gradient();
    auto const bracket = jacobi_lie_bracket(X, Y)(y);
    S const size = size_of(slope) * size_of(bracket) + S(1);
    claim.zero("the fields across the boundary", model, slope.dot(X(y)), S(size_of(X(y)) * size_of(slope)));
    claim.zero("their bracket across the boundary", model, slope.dot(bracket), size);
    Matrix<S, n, 1> const one_sided = derivative_along(Y, y, X(y)).rate;
    claim.refutes("the derivative of one along the other", model, slope.dot(one_sided), size);
    auto const other = draw_any_along(draw, draw_wall<S, n>(draw, y));
    claim.refutes("with a field along another boundary through the point", model,
                  slope.dot(jacobi_lie_bracket(X, other)(y)), size);
  });
}

STATEMENT(claim_8_3_right_invariant_metric, "the metric on volume preserving maps and its right invariance") {
  claim.holds(
      "Extended by right invariance the inner product of fields is $\\int g(\\eta(x))(\\dot\\eta, "
      "\\dot\\eta)\\,\\mu$, twice the kinetic energy of the particles, because $\\eta$ preserves $\\mu$; "
      "translated from the left it is another metric. Integrands are compared for finite maps, integrals "
      "in a box for fields along its walls.");
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    auto const g = draw_metric_of_volume<S, n>(draw);
    auto const eta = draw_shears<S, n>(draw, g.chart, g.chart);
    Event<S, n> const x = draw_event<S, n>(draw);
    Matrix<S, n, 1> const particle = x.template tail<n>();
    // The integrand at the identity for velocities in space, pulled back, and that of the particles.
    auto const integrands = [&](Shears<S, n> const& map) {
      auto const j = first_jet(map, x);
      Event<S, n> const at = event_in_space(j);
      auto const u = VelocityInSpace{map}(at), v = draw_solenoidal<S, n>(draw, g)(at);
      S const at_identity =
                  inner(g(j.y), u, v) * volume<S>(g(j.y)) * determinant(Matrix<S, n, n>(j.gradient())),
              of_particles = inner(g(j.y), j.velocity(), v) * volume<S>(g(particle));
      return std::pair(at_identity, of_particles);
    };
    auto const [at_identity, of_particles] = integrands(eta);
    claim.equal("the metric at the identity and the kinetic energy of particles", model, at_identity,
                of_particles);
    auto const [elsewhere, free] = integrands(of_coordinates(eta));
    claim.differs("for a map that keeps the volume of coordinates", model, elsewhere, free);
    // Translated on the right by kappa, the integrand is the same at the particle that kappa sends there.
    auto const kappa = draw_shears<S, n>(draw, g.chart, g.chart);
    auto const X = draw_solenoidal<S, n>(draw, g), Y = draw_solenoidal<S, n>(draw, g);
    auto const at_particle = [&](Shears<S, n> const& map) {
      auto const j = first_jet(map, x);
      Event<S, n> const from = event_in_space(j);
      Matrix<S, n, 1> const place = eta(from);
      S const product = inner(g(place), X(from), Y(from));
      return std::pair(S(product * volume<S>(g(particle))),
                       S(product * volume<S>(g(j.y)) * determinant(Matrix<S, n, n>(j.gradient()))));
    };
    auto const [translated, before] = at_particle(kappa);
    claim.equal("translated on the right", model, translated, before);
    auto const [stretched, unequal] = at_particle(of_coordinates(kappa));
    claim.differs("by a map that keeps the volume of coordinates", model, stretched, unequal);
    Tangents<S, n, n> const one = Tangents<S, n, n>::Identity();
    Matrix<S, n, n> const F = pushed(AtTime{x[0], kappa}, particle, one);
    Matrix<S, n, 1> const left_X = F * X(x), left_Y = F * Y(x);
    claim.differs("translated on the left", model, inner(g(kappa(x)), left_X, left_Y),
                  inner(g(particle), X(x), Y(x)));

    // To first order, and as integrals: a field along the walls without divergence changes no integral.
    auto const box = draw_box_metric<S, n>(draw);
    auto const u = draw_along_walls<S, n, n>(draw), v = draw_along_walls<S, n, n>(draw);
    BoxField<S, n, n> slope;
    {
      BoxPolynomial<S, n> product;
      for (int a = 0; a < n; ++a)
        for (int b = 0; b < n; ++b) product += box.entries[a][b] * (u[a] * v[b]);
      for (int a = 0; a < n; ++a) slope[a] = product.slope(a);
    }
    // What each component of a field changes; the sum is the rate.
    struct Change {
      S rate{0}, size{0};
      Base<S> moduli{0};
    };
    auto const change = [&](BoxField<S, n, n> const& w) {
      Change all;
      for (int a = 0; a < n; ++a) {
        auto const part = integral(slope[a], w[a]);
        all.rate += part.value, all.size += size_of(part.value), all.moduli += part.size;
      }
      return all;
    };
    auto const along = draw_along_walls<S, n, n>(draw), open = draw_along_walls<S, n, n>(draw, true);
    auto const held = change(along), through = change(open);
    claim.zero("rate of the inner product in a box", model, held.rate, held.size,
               magnification<S>(held.moduli, held.size));
    auto swelling = along;
    swelling[0] += wall<S, n>(0) * draw_linear<S, n>(draw);
    auto const swollen = change(swelling);
    claim.refutes("along a field with a divergence", model, swollen.rate, swollen.size);
    claim.refutes("along a field through a wall", model, through.rate, through.size);
  });
}

STATEMENT(eq_8_13, "geodesics of the group of volume preserving diffeomorphisms") {
  claim.convention(
      "One metric on body and space, mass 1, variations along the walls that vanish at both ends. "
      "The action varies by minus the work of the acceleration; a gradient does no work on such "
      "variations, and a covector field that does none on any of them has no curl: along "
      "$\\partial_b(\\beta\\,\\omega^{ab})$, with $\\omega$ its curl and $\\beta$ zero at the "
      "walls, it does the work $\\int\\beta|\\omega|^2$, and where the body closes to a strip, "
      "fields around it find its period.");
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    auto const g = draw_any_metric<S, n>(draw);
    auto const w = draw_solenoidal<S, n>(draw, g);
    auto const eta = draw_section<S, n, n>(draw);
    Event<S, n> const x = draw_event<S, n>(draw);
    auto const j = second_jet(eta, x);
    // Kinetic energy varied along w o eta.
    auto const change = first_jet(CarriedBy{w, eta}, x);
    using T = Dual<S>;
    Matrix<T, n, 1> place = j.y.template cast<T>(), velocity = j.velocity().template cast<T>();
    for (int a = 0; a < n; ++a) place[a].part[0] = change.y[a], velocity[a].part[0] = change.v(a, 0);
    S const varied = (inner(g(place), velocity, velocity) / T(2)).part[0];
    // d/dt <eta', w o eta>, and <D eta'/Dt, w o eta>.
    auto const moved = along(j, 0);
    Matrix<T, n, 1> w_moved = change.y.template cast<T>();
    for (int a = 0; a < n; ++a) w_moved[a].part[0] = change.v(a, 0);
    S const carried = inner(g(moved.y), moved.velocity(), w_moved).part[0],
            work = inner(g(j.y), material_acceleration(g, j), change.y);
    S const scale = size_of(varied) + size_of(carried) + size_of(work);
    claim.zero("the variation of kinetic energy", model, S(varied - carried + work), scale);
    claim.refutes("with the acceleration of coordinates", model,
                  S(varied - carried + inner(g(j.y), j.acceleration(), change.y)), scale);
    claim.refutes("with the work of the other sign", model, S(varied - carried - work), scale);

    // A variation that stays in the group changes the velocity in space by w' + [u, w].
    if (n == 2 || !numbers_grow()) {
      auto const space = draw_metric_of_volume<S, n>(draw);
      auto const motion = draw_shears<S, n>(draw, g.chart, space.chart),
                 after = draw_shears<S, n>(draw, space.chart, space.chart);
      Varied const family{motion, after, variable(S(0))};
      auto const rate = rate_of(VelocityInSpace{family}(x.template cast<T>().eval()));
      AtTime const u{x[0], VelocityInSpace{motion}}, X{S(0), VelocityInSpace{after}};
      Matrix<S, n, 1> const y = x.template tail<n>(), bracket = jacobi_lie_bracket(u, X)(y) * x[0];
      claim.equal("the velocity in space, varied in the group", model, Matrix<S, n, 1>(rate),
                  Matrix<S, n, 1>(X(y) + bracket));
      claim.differs("with the bracket turned round", model, Matrix<S, n, 1>(rate),
                    Matrix<S, n, 1>(X(y) - bracket));
    }
  });
  // The same as integrals over time and a box with walls and a curved metric of volume 1.
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& dimensions) {
    std::string const model = "box, " + dimensions;
    auto const g = draw_box_metric<S, n>(draw);
    auto const u = draw_along_walls<S, n, n + 1>(draw);
    auto w = draw_along_walls<S, n, n + 1>(draw), leaving = draw_along_walls<S, n, n + 1>(draw, true);
    for (auto* field : {&w, &leaving})
      for (auto& component : field->component) component = component * wall<S, n + 1>(0);
    auto const momentum = lowered_in_box(g, u), force = acceleration_in_box(g, u);
    auto const action = integral(momentum, varied_velocity(u, w)), work = integral(force, w);
    S const scale = size_of(action.value) + size_of(work.value);
    claim.zero("the action varies by minus the work of the acceleration", model, S(action.value + work.value),
               scale, magnification<S>(action.size + work.size, scale));
    auto const turned = integral(momentum, varied_velocity(u, w, -1));
    claim.refutes("with the bracket turned round", model, S(turned.value + work.value), scale);
    auto const out = integral(momentum, varied_velocity(u, leaving)), work_out = integral(force, leaving);
    claim.refutes("varied through a wall", model, S(out.value + work_out.value),
                  S(size_of(out.value) + size_of(work_out.value)));
    Event<S, n> const at = draw_event<S, n>(draw);
    Matrix<S, n, 1> const y = at.template tail<n>();
    claim.equal("the acceleration in the box", model, force(at),
                lowered(g(y), eulerian_acceleration(g, u, at)));

    // At one time: gradients and fields along the walls; the work along the curl.
    BoxField<S, n, n> gradient_of_p, alpha;
    auto const p = draw_linear<S, n>(draw) * draw_linear<S, n>(draw) * draw_linear<S, n>(draw);
    for (int a = 0; a < n; ++a) {
      gradient_of_p[a] = p.slope(a);
      alpha[a] = draw_linear<S, n>(draw) * draw_linear<S, n>(draw);
    }
    auto const still = draw_along_walls<S, n, n>(draw), open = draw_along_walls<S, n, n>(draw, true);
    auto const none = integral(gradient_of_p, still), some = integral(gradient_of_p, open);
    claim.zero("a gradient does no work along the walls", model, none.value, S(none.size));
    claim.refutes("a gradient through a wall", model, some.value, S(some.size));
    CurlField<S, n> const curl(alpha);
    auto const done = integral(alpha, curl.w);
    claim.zero("work along the curl is that of its square", model, S(done.value - curl.work.value),
               S(done.size));
    claim.refutes("a covector field with a curl", model, done.value, S(done.size));
    // The box closed to a strip around its first coordinate: what has one value and slope at both ends is
    // smooth enough there.
    auto const round = p * wall<S, n>(0) * wall<S, n>(0);
    BoxField<S, n, n> around, closed;
    around[0] = BoxPolynomial<S, n>::constant(draw.number<S>() + S(2)) +
                BoxPolynomial<S, n>::variable(1) * draw.number<S>();
    for (int a = 0; a < n; ++a) closed[a] = round.slope(a);
    auto const strip = integral(closed, around);
    claim.zero("a gradient does no work around a strip", model, strip.value, S(strip.size));
    closed[0] += BoxPolynomial<S, n>::constant(draw.number<S>());
    auto const period = integral(closed, around);
    claim.refutes("a covector field without a curl and with a period", model, period.value, S(period.size));
  });
}
