// Scalars: rational (long: double)
// Section 8.3: the group of volume preserving diffeomorphisms, its geodesics and their pressure.
#include "incompressible_models.hpp"

#include "actio/incompressible/bracket_of_fields.hpp"
#include "statement.hpp"

namespace {

using namespace actio;
using namespace actio::checks;

/// A field on space at one time.
template <class S, class Field>
struct Frozen {
  S time;
  Field u;
  template <class V>
  auto operator()(V const& y) const {
    Eigen::Matrix<ScalarOf<V>, V::RowsAtCompileTime + 1, 1> at;
    at << ScalarOf<V>(time), y;
    return u(at);
  }
};
/// A field on space as one on time and space.
template <class Field>
struct Steady {
  Field u;
  template <class V>
  auto operator()(V const& at) const {
    return u(Eigen::Matrix<ScalarOf<V>, V::RowsAtCompileTime - 1, 1>(at.template tail<V::RowsAtCompileTime - 1>()));
  }
};
/// A shear along the first axis: its flow is y + s u(y).
template <class S, int n>
struct ShearField {
  Cubic<S, n + 1> speed;
  template <class V>
  auto operator()(V const& at) const {
    Eigen::Matrix<ScalarOf<V>, n, 1> u = Eigen::Matrix<ScalarOf<V>, n, 1>::Zero();
    u[0] = speed(at);
    return u;
  }
};
/// The flow y + s X(y) of a shear, at one time.
template <class Shear, class T>
struct FlowOfShear {
  Shear shear;
  T time;
  template <class V>
  auto operator()(V const& y) const {
    return (y + shear(y) * ScalarOf<V>(time)).eval();
  }
};
/// A field carried along by the flow: \f$T\eta\,Y\circ\eta^{-1}\f$ at y.
template <class Shear, class Field, class S, int n, class T>
Tangents<T, n, 1> carried(Shear const& shear, Field const& Y, Eigen::Matrix<S, n, 1> const& y, T const& time) {
  Eigen::Matrix<T, n, 1> const place = y.template cast<T>(), from = place - shear(place) * time;
  Tangents<T, n, 1> const value = Y(from);
  return pushed(FlowOfShear<Shear, T>{shear, time}, from, value);
}
/// \f$(y^1)^k\f$ in all directions of a vector that is not constant: a field with divergence.
template <int k>
struct Swelling {
  template <class V>
  auto operator()(V const& y) const {
    auto u = y.eval();
    for (int i = 0; i < k; ++i) u *= y[0];
    u[0] += y[1] * y[1];
    return u;
  }
};
/// The point (t, y) at which a jet is.
template <class S, int n>
Event<S, n> event_in_space(Jet<S, n, n> const& j) {
  Event<S, n> at;
  at << j.x[0], j.y;
  return at;
}

}  // namespace

STATEMENT(claim_8_3_lie_algebra_bracket, "the bracket of fields that keep the volume") {
  claim.holds("It is the bracket of left-invariant fields on the group; with right-invariant ones, which hydrodynamics uses otherwise, it would be the bracket of Jacobi and Lie itself.");
  claim.degree(degree_of_fields);
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const g = draw_metric<S, n>(draw);
    S const t = draw.number<S>();
    using Field = Frozen<S, SolenoidalField<S, n, AnyMetric<S, n>>>;
    Field const X{t, draw_solenoidal<S, n>(draw, g)}, Y{t, draw_solenoidal<S, n>(draw, g)};
    Event<S, n> const at = draw_event<S, n>(draw);
    Eigen::Matrix<S, n, 1> const y = at.template tail<n>();
    claim.zero("divergence of the bracket", model, divergence(g, Steady{diffeomorphism_bracket(X, Y)}, at), size_of(diffeomorphism_bracket(X, Y)(y)) + S(1));
    claim.refutes("of two fields with divergence", model, divergence(g, Steady{diffeomorphism_bracket(Swelling<1>{}, Swelling<2>{})}, at), S(1));

    // The adjoint action of the flow of X, differentiated along the flow: Ad of minus the bracket. A shear has a polynomial flow, y + s X(y).
    Cubic<S, n + 1> speed = draw_cubic<S, n + 1>(draw);
    for (auto* v : {&speed.a, &speed.b, &speed.d, &speed.e}) (*v)[1] = S(0);
    Frozen<S, ShearField<S, n>> const shear{t, {speed}};
    S const s = draw.number<S>();
    Dual<S> moved(s);
    moved.part[0] = S(1);
    auto const rate = carried(shear, Y, y, moved);
    Eigen::Matrix<S, n, 1> left;
    for (int a = 0; a < n; ++a) left[a] = rate(a, 0).part[0];
    Eigen::Matrix<S, n, 1> const right = carried(shear, diffeomorphism_bracket(shear, Y), y, s);
    claim.equal("rate of the adjoint action", model, left, right);
    claim.differs("with the bracket of Jacobi and Lie", model, left, (-right).eval());
  });
}

STATEMENT(eq_8_13, "geodesics of the group of volume preserving diffeomorphisms") {
  claim.convention("One metric on body and space, mass 1, and variations along the walls: then fields without divergence are orthogonal to gradients; that nothing else is orthogonal to all of them is the decomposition of Helmholtz and Hodge.");
  claim.degree(degree_of_fields);
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const g = draw_metric<S, n>(draw);
    auto const w = draw_solenoidal<S, n>(draw, g);
    auto const eta = draw_section<S, n, n>(draw);
    Event<S, n> const x = draw_event<S, n>(draw);
    auto const j = second_jet(eta, x);
    // Kinetic energy varied along w o eta.
    auto const change = first_jet(CarriedBy{w, eta}, x);
    using T = Dual<S>;
    Eigen::Matrix<T, n, 1> place = j.y.template cast<T>(), velocity = j.velocity().template cast<T>();
    for (int a = 0; a < n; ++a) place[a].part[0] = change.y[a], velocity[a].part[0] = change.v(a, 0);
    S const varied = (inner(g(place), velocity, velocity) / T(2)).part[0];
    // d/dt <eta', w o eta>, and <D eta'/Dt, w o eta>.
    auto const moved = along(j, 0);
    Eigen::Matrix<T, n, 1> w_moved = change.y.template cast<T>();
    for (int a = 0; a < n; ++a) w_moved[a].part[0] = change.v(a, 0);
    S const carried = inner(g(moved.y), moved.velocity(), w_moved).part[0], work = inner(g(j.y), material_acceleration(g, j), change.y);
    S const scale = size_of(varied) + size_of(carried) + size_of(work);
    claim.zero("the variation of kinetic energy", model, S(varied - carried + work), scale);
    claim.refutes("with the acceleration of coordinates", model, S(varied - carried + inner(g(j.y), j.acceleration(), change.y)), scale);
    // A gradient is orthogonal to fields without divergence, but for a divergence.
    auto const p = draw_cubic<S, n + 1>(draw);
    auto const along_pressure = [&](auto const& field_in_space) {
      Event<S, n> const at = event_in_space(j);
      S const product = inner(g(j.y), gradient(g, p, at), Eigen::Matrix<S, n, 1>(field_in_space(at)));
      return std::pair(product, S(product - divergence(g, [&](auto const& y) { return (field_in_space(y) * p(y)).eval(); }, at)));
    };
    auto const [product, rest] = along_pressure(w);
    claim.zero("work of a pressure is a divergence", model, rest, size_of(product) + S(1));
    auto const [unused, left] = along_pressure([](auto const& y) { return y.template tail<n>().eval(); });
    claim.refutes("along a field with a divergence", model, left, S(1));
  });
}

STATEMENT(eq_8_14, "the equation of the pressure") {
  claim.convention("It needs $\\mathrm{div}\\,u = 0$ at all times, and the slope of p at the walls to have one solution. On a curved space the right side is $-(u^i{}_{;j}u^j{}_{;i} + \\mathrm{Ric}(u,u))$.");
  claim.degree(2 * degree_of_fields);
  over_points(TwoAndThree{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const g = draw_metric<S, n>(draw);
    auto const u = draw_solenoidal<S, n>(draw, g);
    Event<S, n> const at = draw_event<S, n>(draw);
    Eigen::Matrix<S, n, 1> const y = at.template tail<n>();
    auto const rate = velocity_gradient(g, u, at);
    S const source = pressure_source(g, u, at);
    S const gradients = (rate.slope * rate.slope).trace(), curvature = inner(ricci_tensor(g, y), rate.value, rate.value);
    S const scale = size_of(gradients) + size_of(curvature) + S(1);
    claim.zero("what acceleration has for its divergence", model, S(divergence(g, [&](auto const& p) { return eulerian_acceleration(g, u, p); }, at) + source), scale);
    claim.zero("by velocity gradients and Ricci's tensor", model, S(source + gradients + curvature), scale);
    claim.refutes("without curvature", model, S(source + gradients), scale);
    auto const compressed = [&](auto const& p) { return (u(p) + p.template tail<n>() * p[0] * p[1]).eval(); };
    claim.refutes("a velocity with divergence", model, S(divergence(g, [&](auto const& p) { return eulerian_acceleration(g, compressed, p); }, at) + pressure_source(g, compressed, at)), scale);
    // The Laplacian is the trace of second covariant derivatives.
    auto const p = draw_cubic<S, n + 1>(draw);
    auto const slopes = first_jet([&](auto const& e) { return gradient(Euclidean<n>{}, p, e); }, at);
    Eigen::Matrix<S, n, n> hessian = slopes.gradient();
    auto const gamma = christoffel(g, y);
    for (int c = 0; c < n; ++c) hessian -= gamma[c] * slopes.y[c];
    claim.zero("the Laplacian as a trace", model, S(laplacian(g, p, at) - raised(g(y), hessian).trace()), size_of(hessian) + S(1));
    claim.differs("the Laplacian of coordinates", model, laplacian(g, p, at), S(slopes.gradient().trace()));
  });
}
