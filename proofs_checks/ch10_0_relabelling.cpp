// Chapter 10: reduction of fluids by relabellings, from motions of a body to fields in space.
#include "actio/continuum/continuum_equations.hpp"
#include "actio/incompressible/bracket_of_fields.hpp"

#include "fields/box_fields.hpp"
#include "fields/incompressible_models.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

/// A motion that keeps the volumes of two charts; in space and over a field of finite size one with fewer
/// terms, whose compositions have a degree that is far below that size.
template <class S, int n>
Shears<S, n> draw_motion(Draw& draw, Chart<S, n> const& body, Chart<S, n> const& space) {
  auto phi = draw_shears<S, n>(draw, body, space);
  if (n > 2 && exact_arithmetic<S>())
    for (auto& added : phi.added) added.b.setZero();
  return phi;
}

/// A motion before which the particles are relabelled: \f$\phi_t\circ\eta\f$, by the relabelling that a
/// motion makes at one moment; or at all times by what it makes then, where it is no relabelling.
template <class Phi, class Eta, class S>
struct Relabelled {
  Phi phi;
  Eta eta;
  S moment;
  bool running = false;
  /// The particle that was given this label.
  template <class V>
  auto label(V const& x) const {
    auto at = x.eval();
    if (!running) at[0] = ScalarOf<V>(moment);
    at.template tail<V::RowsAtCompileTime - 1>() = eta(at);
    at[0] = x[0];
    return at;
  }
  template <class V>
  auto operator()(V const& x) const { return phi(label(x)); }
  template <class V>
  auto particle(V const& y) const {
    auto at = phi.particle(y).eval();
    if (!running) at[0] = ScalarOf<V>(moment);
    at = eta.particle(at);
    at[0] = y[0];
    return at;
  }
};
template <class Phi, class Eta, class S>
Relabelled(Phi, Eta, S) -> Relabelled<Phi, Eta, S>;
template <class Phi, class Eta, class S>
Relabelled(Phi, Eta, S, bool) -> Relabelled<Phi, Eta, S>;

/// A motion after which the places are moved, \f$\eta\circ\phi_t\f$: no relabelling.
template <class Phi, class Eta, class S>
struct Displaced {
  Phi phi;
  Eta eta;
  S moment;
  template <class V>
  auto operator()(V const& x) const {
    auto at = x.eval();
    at.template tail<V::RowsAtCompileTime - 1>() = phi(x);
    at[0] = ScalarOf<V>(moment);
    return eta(at);
  }
  template <class V>
  auto particle(V const& y) const {
    auto at = y.eval();
    at[0] = ScalarOf<V>(moment);
    at = eta.particle(at);
    at[0] = y[0];
    return phi.particle(at);
  }
};
template <class Phi, class Eta, class S>
Displaced(Phi, Eta, S) -> Displaced<Phi, Eta, S>;

/// A motion varied in space, \f$\phi + \epsilon\,w\circ\phi\f$, with an infinitesimal \f$\epsilon\f$.
template <class Phi, class Field, class Epsilon>
struct VariedInSpace {
  Phi phi;
  Field w;
  Epsilon epsilon;
  template <class V>
  V displaced(V at, int sign) const {
    using T = ScalarOf<V>;
    constexpr int n = V::RowsAtCompileTime - 1;
    at.template tail<n>() += w(at) * (T(epsilon) * T(sign));
    return at;
  }
  template <class V>
  auto operator()(V const& x) const {
    auto at = x.eval();
    at.template tail<V::RowsAtCompileTime - 1>() = phi(x);
    return displaced(at, 1).template tail<V::RowsAtCompileTime - 1>().eval();
  }
  template <class V>
  auto particle(V const& y) const { return phi.particle(displaced(y.eval(), -1)); }
};
template <class Phi, class Field, class Epsilon>
VariedInSpace(Phi, Field, Epsilon) -> VariedInSpace<Phi, Field, Epsilon>;

/// How what a motion makes in space, at a point there, changes where the motion is varied.
/// @param make  from a motion to a callable on points (t, y)
template <class Phi, class Field, class V, class Make>
auto change_in_space(Phi const& phi, Field const& w, V const& at, Make const& make) {
  return derivative(
             [&]<class T>(T const& e) {
               return make(VariedInSpace{phi, w, e})(at.template cast<T>().eval());
             },
             ScalarOf<V>(0))
      .rate;
}

/// \f$\partial_tw + [u, w]\f$ with the bracket of Jacobi and Lie, or with that turned round.
template <class U, class W, class S, int rows>
Matrix<S, rows - 1, 1> constrained_change(U const& u, W const& w, Matrix<S, rows, 1> const& at,
                                          int sign = 1) {
  auto const ju = first_jet(u, at), jw = first_jet(w, at);
  return jw.velocity() + (jw.gradient() * ju.y - ju.gradient() * jw.y) * S(sign);
}

/// Of a field in space the field on the body that the motion carries to it: \f$T\phi_t^{-1}\,w\circ\phi_t\f$.
template <class Phi, class Field>
struct SeenFromBody {
  Phi phi;
  Field w;
  template <class V>
  auto operator()(V const& x) const {
    using T = ScalarOf<V>;
    constexpr int n = V::RowsAtCompileTime - 1;
    auto const j = first_jet(phi, x.eval());
    Matrix<T, n + 1, 1> at;
    at << x[0], j.y;
    return Matrix<T, n, 1>(inverse_matrix(Matrix<T, n, n>(j.gradient())) * w(at));
  }
};
template <class Phi, class Field>
SeenFromBody(Phi, Field) -> SeenFromBody<Phi, Field>;
/// And of a field on the body that does not change in time the field in space.
template <class Phi, class Field>
struct CarriedToSpace {
  Phi phi;
  Field xi;  ///< on points of the body
  template <class V>
  auto operator()(V const& y) const {
    using T = ScalarOf<V>;
    constexpr int n = V::RowsAtCompileTime - 1;
    auto const from = phi.particle(y.eval()).eval();
    auto const j = first_jet(phi, from);
    return Matrix<T, n, 1>(j.gradient() * xi(Matrix<T, n, 1>(from.template tail<n>())));
  }
};
template <class Phi, class Field>
CarriedToSpace(Phi, Field) -> CarriedToSpace<Phi, Field>;

/// Any field in time and space, each component a cubic.
template <class S, int n>
struct AnyField {
  std::array<Cubic<S, n + 1>, n> c;
  explicit AnyField(Draw& draw) {
    for (auto& one : c) one = draw_cubic<S, n + 1>(draw);
  }
  template <class V>
  auto operator()(V const& at) const {
    Matrix<ScalarOf<V>, n, 1> w;
    for (int a = 0; a < n; ++a) w[a] = c[a](at);
    return w;
  }
};

}  // namespace

STATEMENT(claim_10_0_material_to_eulerian, "reduction by relabelling and the spatial velocity") {
  claim.holds(
      "Motions $\\phi$ and $\\phi\\circ\\eta$ have one velocity in space, for each $\\eta$ that keeps "
      "the volume and does not change in time. Conversely $\\frac{d}{dt}(\\phi^{-1}\\circ\\psi) = "
      "T\\phi^{-1}(v-u)\\circ\\psi$ for two motions with velocities $u$ and $v$, so that two with one "
      "velocity differ by a relabelling; and a variation $w$ leaves $u$ alone if and only if the "
      "motion carries it along. The kinetic energy is a function of $u$. What the field equations "
      "become is claim_8_3_euler_equations.");
  claim.leaves(
      "That each field without divergence is the velocity of some motion is the existence "
      "theorem of ordinary differential equations. The set of motions modulo relabellings "
      "is not shown to be a manifold.");
  over_points(claim, PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    using V = Matrix<S, n, 1>;
    auto const g = draw_metric_of_volume<S, n>(draw);
    auto const phi = draw_motion<S, n>(draw, g.chart, g.chart),
               psi = draw_motion<S, n>(draw, g.chart, g.chart),
               eta = draw_motion<S, n>(draw, g.chart, g.chart);
    Event<S, n> const x = draw_event<S, n>(draw), y = draw_event<S, n>(draw);
    S const moment = (S(2) + draw.number<S>()) / S(6);
    VelocityInSpace const u{phi}, v{psi};
    // Compositions of up to three motions and their inverses, differentiated: ten times plain evaluation.
    constexpr double condition = 10;
    Relabelled const relabelled{phi, eta, moment};
    claim.equal("velocity in space after a relabelling", model, V(VelocityInSpace{relabelled}(y)), V(u(y)),
                condition);
    claim.differs("velocity of the particle of a label", model, V(first_jet(relabelled, x).velocity()),
                  V(first_jet(phi, x).velocity()));
    claim.differs("after a relabelling that changes in time", model,
                  V(VelocityInSpace{Relabelled{phi, eta, moment, true}}(y)), V(u(y)));
    claim.differs("after a change of places in place of labels", model,
                  V(VelocityInSpace{Displaced{phi, eta, moment}}(y)), V(u(y)));

    // Two motions: where psi has brought a label, and the label that phi brings there.
    auto const between = [&]<class T>(Event<T, n> const& at) {
      Event<T, n> there = at;
      there.template tail<n>() = psi(at);
      return Matrix<T, n, 1>(phi.particle(there).template tail<n>());
    };
    auto const j = first_jet(between, x);
    Event<S, n> there = x, label = x;
    there.template tail<n>() = psi(x), label.template tail<n>() = j.y;
    V const rate = first_jet(phi, label).gradient() * j.velocity(), difference = v(there) - u(there);
    claim.equal("rate of the relabelling between two motions", model, rate, difference, condition);
    claim.differs("rate by the velocities of one label", model, rate,
                  V(first_jet(psi, x).velocity() - first_jet(phi, x).velocity()));
    auto const ratio_of = [&](auto const& map) {
      auto const k = first_jet(map, x);
      return S(jacobian(g(V(x.template tail<n>())), g(k.y), Matrix<S, n, n>(k.gradient())));
    };
    claim.zero("and it keeps the volume", model, S(ratio_of(between) - S(1)), S(1), condition);
    claim.refutes("a motion that keeps the volume of coordinates", model,
                  S(ratio_of(of_coordinates(psi)) - S(1)), S(1));

    // Variations: those that leave the velocity in space are infinitesimal relabellings, and no others.
    AnyField<S, n> const w(draw);
    auto const velocity_of = [](auto const& motion) { return VelocityInSpace{motion}; };
    V const change = change_in_space(phi, w, y, velocity_of), bracket = constrained_change(u, w, y);
    claim.equal("change of the velocity in space", model, change, bracket, condition);
    claim.differs("with the bracket turned round", model, change, constrained_change(u, w, y, -1));
    Event<S, n> const at = phi.particle(y);
    claim.equal("rate of the variation as it is seen from the body", model,
                V(first_jet(phi, at).gradient() * first_jet(SeenFromBody{phi, w}, at).velocity()), bracket,
                condition);
    auto const xi = draw_solenoidal<S, n>(draw, g);
    auto const at_rest = AtTime{moment, xi};
    CarriedToSpace const carried{phi, at_rest};
    auto const jet = first_jet(carried, y);
    S const size = size_of(jet.v) * (S(1) + size_of(u(y))) + size_of(first_jet(u, y).v) * size_of(jet.y);
    claim.zero("change of the velocity along an infinitesimal relabelling", model,
               V(change_in_space(phi, carried, y, velocity_of)), size, condition);
    auto const not_carried = [&](auto const& event) { return xi(event); };
    claim.refutes("along a field that is not carried", model,
                  V(change_in_space(phi, not_carried, y, velocity_of)), size);

    // The kinetic energy: per volume of the body, and of space.
    auto const energies = [&](Shears<S, n> const& motion) {
      auto const k = first_jet(motion, x);
      V const particle = x.template tail<n>(), speed = VelocityInSpace{motion}(event_in_space(k));
      S const on_body = inner(g(k.y), k.velocity(), k.velocity()) * volume<S>(g(particle)),
              in_space = inner(g(k.y), speed, speed) * volume<S>(g(k.y));
      return std::array{on_body, S(in_space * determinant(Matrix<S, n, n>(k.gradient()))), in_space};
    };
    auto const same = energies(phi), other = energies(of_coordinates(phi));
    claim.equal("kinetic energy on the body and in space", model, same[0], same[1], condition);
    claim.differs("of a motion that keeps another volume", model, other[0], other[1]);
  });
}

namespace {

/// A compressible fluid: energy per mass e(D, s) of the density in space and the entropy, which the body has
/// as a function of its points.
template <class S, int n, class Mass, class Entropy>
struct EntropyFluid {
  MetricOfVolume<S, n> G, g;
  Mass rho;
  Entropy s;
  Cubic<S, 2> e;

  template <class T>
  T energy(T const& D, T const& entropy) const {
    Matrix<T, 2, 1> both;
    both << D, entropy;
    return e(both);
  }
  /// \f$\partial e/\partial D\f$ and \f$\partial e/\partial s\f$.
  template <class T>
  Matrix<T, 2, 1> slopes(T const& D, T const& entropy) const {
    Matrix<T, 2, 1> both;
    both << D, entropy;
    return derivative(e, both).gradient();
  }
  /// The Lagrangian density of a jet, for a particle with this mass and entropy.
  template <class T>
  T density(Jet<T, n, n> const& j, T const& mass, T const& entropy) const {
    Matrix<T, n, 1> const x = j.particle(), v = j.velocity();
    auto const root = volume<T>(G(x));
    T const J = jacobian(G(x), g(j.y), Matrix<T, n, n>(j.gradient()));
    return root * mass * (inner(g(j.y), v, v) / T(2) - energy(T(mass / J), entropy));
  }
  template <class T>
  T operator()(Jet<T, n, n> const& j) const { return density(j, T(rho(j.particle())), T(s(j.particle()))); }
  /// The size of what is subtracted in it.
  S terms(Jet<S, n, n> const& j) const {
    S const mass = rho(j.particle()) * volume<S>(G(j.particle())), whole = (*this)(j),
            kinetic = mass * inner(g(j.y), j.velocity(), j.velocity()) / S(2);
    return size_of(kinetic) + size_of(S(kinetic - whole));
  }
};
/// The density in space \f$(\rho/J)\circ\phi_t^{-1}\f$ of a motion.
template <class Fluid, class Phi>
struct DensityInSpace {
  Fluid fluid;
  Phi phi;
  template <class V>
  auto operator()(V const& y) const {
    using T = ScalarOf<V>;
    auto const j = first_jet(phi, phi.particle(y.eval()).eval());
    auto const x = j.particle();
    return T(fluid.rho(x) / jacobian(fluid.G(x), fluid.g(j.y), j.gradient()));
  }
};
template <class Fluid, class Phi>
DensityInSpace(Fluid, Phi) -> DensityInSpace<Fluid, Phi>;
/// A function of the particles as one of time and space.
template <class Function, class Phi>
struct InSpace {
  Function f;
  Phi phi;
  template <class V>
  auto operator()(V const& y) const {
    using T = ScalarOf<V>;
    constexpr int n = V::RowsAtCompileTime - 1;
    auto const from = phi.particle(y.eval()).eval();
    return T(f(Matrix<T, n, 1>(from.template tail<n>())));
  }
};
template <class Function, class Phi>
InSpace(Function, Phi) -> InSpace<Function, Phi>;

/// A function f of the last n - 1 coordinates w of a chart, which shears of the first do not change.
template <class S, int n>
struct OfOtherCoordinates {
  Chart<S, n> chart;
  Cubic<S, n> f;
  S least;
  OfOtherCoordinates(Draw& draw, Chart<S, n> const& of, S const& constant)
      : chart(of), f(draw_cubic<S, n>(draw, ratio<S>(1, 4))), least(constant) {
    for (auto* vector : {&f.a, &f.b, &f.d, &f.e}) (*vector)[0] = S(0);
  }
  template <class V>
  auto operator()(V const& x) const { return ScalarOf<V>(f(chart(x)) + ScalarOf<V>(least)); }
};

/// \f$\partial_tf + df(u)\f$ and \f$\partial_tf + \mathrm{div}(fu)\f$ at a point.
template <class Metric, class F, class U, class S, int rows>
std::array<S, 2> advected(Metric const& g, F const& f, U const& u, Matrix<S, rows, 1> const& at) {
  auto const slope = derivative(f, at).gradient();
  auto const flux = [&](auto const& y) { return (u(y) * f(y)).eval(); };
  return {S(slope[0] + slope.template tail<rows - 1>().dot(u(at))), S(slope[0] + divergence(g, flux, at))};
}

/// The action of a fluid in a box and its variation where the motion is varied by w: the velocity as a
/// constrained variation says, a density and a function carried along.
template <class S, int n>
struct FluidInBox {
  using P = BoxPolynomial<S, n + 1>;
  BoxMetric<S, n> g;
  FieldsInTime<S, n> u, w;
  P D;

  FluidInBox(Draw& draw)
      : g(draw_box_metric<S, n>(draw)),
        u(draw_along_walls<S, n, n + 1>(draw)),
        w(draw_along_walls<S, n, n + 1>(draw)),
        D(draw_linear<S, n + 1>(draw) + P::constant(S(3)) + P::variable(0) * S(2)) {
    // No variation at both ends of the time; a field with a divergence.
    w[0] += wall<S, n + 1>(1) * draw_linear<S, n + 1>(draw);
    for (auto& component : w.component) component = component * wall<S, n + 1>(0);
  }
  P along(FieldsInTime<S, n> const& field, P const& f) const {
    P sum;
    for (int a = 0; a < n; ++a) sum += field[a] * f.slope(a + 1);
    return sum;
  }
  /// The divergence of f times a field, for the volume 1.
  P flux(FieldsInTime<S, n> const& field, P const& f) const {
    P sum;
    for (int a = 0; a < n; ++a) sum += (field[a] * f).slope(a + 1);
    return sum;
  }
  P half_square() const {
    auto const below = lowered_in_box(g, u);
    P sum;
    for (int a = 0; a < n; ++a) sum += below[a] * u[a] * ratio<S>(1, 2);
    return sum;
  }
  /// \f$\int D\,g(u, \delta u)\f$ for a change of the velocity.
  Integral<S> of_velocity(FieldsInTime<S, n> const& change) const {
    auto below = lowered_in_box(g, u);
    for (auto& component : below.component) component = component * D;
    return integral(below, change);
  }
  /// \f$\int w\cdot\bigl(D\,(\partial_tu + \nabla_uu) + u\,(\partial_tD + \mathrm{div}(Du)) + dp\bigr)\f$;
  /// the middle term may be left out.
  Integral<S> work(P const& p, bool continuity = true) const {
    auto force = acceleration_in_box(g, u), below = lowered_in_box(g, u);
    P const left = D.slope(0) + flux(u, D);
    for (int a = 0; a < n; ++a) {
      force[a] = force[a] * D + p.slope(a + 1);
      if (continuity) force[a] += below[a] * left;
    }
    return integral(force, w);
  }
};
/// A sum of integrals with signs.
template <class S>
Integral<S> sum_of(std::vector<std::pair<int, Integral<S>>> const& parts) {
  Integral<S> total;
  for (auto const& [sign, part] : parts) total.value += part.value * S(sign), total.size += part.size;
  return total;
}

}  // namespace

STATEMENT(claim_10_0_compressible_reduction,
          "reduction of a compressible fluid with density and entropy as fields") {
  claim.holds(
      "With $e(D, s)$, $D = \\rho/J$, the density of the Lagrangian changes along $\\xi$ by a divergence, "
      "less $(\\tfrac12|\\dot\\phi|^2 - e - De_D)\\,\\mathrm{div}(\\rho\\xi)$, plus "
      "$\\rho\\,e_s\\,\\xi\\cdot\\nabla s$: a relabelling is a symmetry where it keeps mass and entropy, "
      "and another one is none along motions where these terms do not cancel. Carried to space, $D$ and "
      "$s$ are advected; with $\\delta u = \\dot w + [u, w]$, $\\delta D = -\\mathrm{div}(Dw)$, $\\delta s "
      "= -w\\cdot\\nabla s$ the action varies by minus the work of $D(\\partial_tu + \\nabla_uu) + \\nabla "
      "p$, $p = D^2e_D$, which is what the field equations on the body say. For any metrics of body and "
      "space, off the solutions; as integrals in a box with a metric of volume 1.");
  over_points(claim, PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    using V = Matrix<S, n, 1>;
    auto const G = draw_any_metric<S, n>(draw), g = draw_any_metric<S, n>(draw);
    EntropyFluid<S, n, AnyMass<S, n>, Cubic<S, n>> const fluid{
        G, g, draw_mass<S, n>(draw), draw_cubic<S, n>(draw), draw_cubic<S, 2>(draw)};
    auto const phi = draw_motion<S, n>(draw, draw_chart<S, n>(draw), draw_chart<S, n>(draw));
    auto const j = second_jet(phi, draw_event<S, n>(draw));
    Event<S, n> const x = j.x, y = event_in_space(static_cast<Jet<S, n, n> const&>(j));
    VelocityInSpace const u{phi};
    auto const density_of = [&](auto const& motion) { return DensityInSpace{fluid, motion}; };
    auto const entropy_of = [&](auto const& motion) { return InSpace{fluid.s, motion}; };
    auto const density = density_of(phi);
    auto const entropy = entropy_of(phi);
    // Inverses of motions, and third derivatives of them: ten times plain evaluation.
    constexpr double condition = 10;

    // Advection.
    S const here = density(y);
    auto const [as_function, as_density] = advected(g, density, u, y);
    auto const [kept, spread] = advected(g, entropy, u, y);
    S const of_density =
                size_of(derivative(density, y).gradient()) + size_of(first_jet(u, y).v) * size_of(here),
            of_entropy = size_of(derivative(entropy, y).gradient()) * (S(1) + size_of(u(y)));
    claim.zero("conservation of mass in space", model, as_density, of_density, condition);
    claim.refutes("density as a function that is carried", model, as_function, of_density);
    claim.zero("entropy is carried", model, kept, of_entropy, condition);
    claim.refutes("entropy as a density", model, spread, of_entropy);

    // Field equations.
    auto const pressure = [&](auto const& at) {
      using T = ScalarOf<decltype(at)>;
      T const D_there = density(at), s_there = entropy(at);
      return T(D_there * D_there * fluid.slopes(D_there, s_there)[0]);
    };
    S const s_here = entropy(y);
    auto const at_one_entropy = [&](auto const& at) {
      using T = ScalarOf<decltype(at)>;
      T const D_there = density(at);
      return T(D_there * D_there * fluid.slopes(D_there, T(s_here))[0]);
    };
    S const J = jacobian(G(j.particle()), g(j.y), Matrix<S, n, n>(j.gradient()));
    V const on_body = -euler_lagrange(fluid, j) / volume<S>(G(j.particle())),
            inertia = lowered(g(j.y), V(eulerian_acceleration(g, u, y))) * here;
    auto const in_space = [&](auto const& p) {
      return V((inertia + derivative(p, y).gradient().template tail<n>()) * J);
    };
    claim.equal("field equations on the body and in space", model, on_body, in_space(pressure), condition);
    claim.differs("with the entropy of one particle for all", model, on_body, in_space(at_one_entropy));
    claim.differs("without J", model, on_body, V(in_space(pressure) / J));

    // Variations in space.
    AnyField<S, n> const w(draw);
    auto const w_flux = [&](auto const& at) { return (w(at) * density(at)).eval(); };
    auto const w_spread = [&](auto const& at) { return (w(at) * entropy(at)).eval(); };
    S const carried = derivative(entropy, y).gradient().template tail<n>().dot(w(y));
    claim.equal("change of the velocity in space", model,
                V(change_in_space(phi, w, y, [](auto const& motion) { return VelocityInSpace{motion}; })),
                constrained_change(u, w, y), condition);
    S const change = change_in_space(phi, w, y, density_of);
    claim.equal("change of the density", model, change, S(-divergence(g, w_flux, y)), condition);
    claim.differs("change of the density as of a function", model, change,
                  S(-derivative(density, y).gradient().template tail<n>().dot(w(y))));
    claim.equal("change of the entropy", model, S(change_in_space(phi, w, y, entropy_of)), S(-carried),
                condition);
    claim.differs("change of the entropy as of a density", model, S(change_in_space(phi, w, y, entropy_of)),
                  S(-divergence(g, w_spread, y)));

    // Relabellings: finite ones with mass and entropy carried along, and an infinitesimal one without.
    auto const chart = draw_chart<S, n>(draw);
    auto const eta = draw_motion<S, n>(draw, chart, chart);
    S const moment = ratio<S>(1, 4);
    Relabelled const relabelled{phi, eta, moment};
    auto const before = first_jet(phi, relabelled.label(x));
    auto const after = first_jet(relabelled, x);
    auto const map =
        first_jet([&](auto const& at) { return relabelled.label(at).template tail<n>().eval(); }, x);
    S const stretch = determinant(Matrix<S, n, n>(map.gradient())),
            mass = fluid.rho(map.y) * volume<S>(G(map.y)) * stretch / volume<S>(G(after.particle()));
    claim.zero("the density of the Lagrangian, with mass and entropy relabelled", model,
               S(fluid.density(after, mass, S(fluid.s(map.y))) - fluid(before) * stretch),
               S(fluid.terms(before) * size_of(stretch)), condition);
    claim.differs("with the entropy left at its place", model,
                  fluid.density(after, mass, S(fluid.s(after.particle()))), S(fluid(before) * stretch));
    claim.differs("with the mass left at its place", model,
                  fluid.density(after, S(fluid.rho(after.particle())), S(fluid.s(map.y))),
                  S(fluid(before) * stretch));
    std::array<Cubic<S, n>, n> xi;
    for (auto& c : xi) c = draw_cubic<S, n>(draw);
    auto const field = [&xi](auto const& at) {
      Matrix<ScalarOf<decltype(at)>, n, 1> out;
      for (int k = 0; k < n; ++k) out[k] = xi[k](at);
      return out;
    };
    V const particle = j.particle();
    S const rate = derivative(
                       [&]<class T>(T const& e) {
                         auto const moved = [&](auto const& at) {
                           using U = ScalarOf<decltype(at)>;
                           Event<U, n> there = at;
                           there.template tail<n>() += field(Matrix<U, n, 1>(at.template tail<n>())) * U(e);
                           return phi(there);
                         };
                         return fluid(first_jet(moved, x.template cast<T>().eval()));
                       },
                       S(0))
                       .rate;
    auto const lagrangian_flux = [&](auto const& at) {
      using T = ScalarOf<decltype(at)>;
      Event<T, n> event;
      event << T(x[0]), at;
      return (field(at) * fluid(first_jet(phi, event))).eval();
    };
    auto const slopes = fluid.slopes(here, s_here);
    auto const mass_flux = [&](auto const& at) { return (field(at) * fluid.rho(at)).eval(); };
    S const root = volume<S>(G(particle)), total = divergence(lagrangian_flux, particle),
            kinetic = inner(g(j.y), V(j.velocity()), V(j.velocity())) / S(2),
            by_mass = (kinetic - fluid.energy(here, s_here) - here * slopes[0]) *
                      divergence(G, mass_flux, particle) * root,
            by_entropy = slopes[1] * fluid.rho(particle) *
                         derivative(fluid.s, particle).gradient().dot(field(particle)) * root;
    S const terms = size_of(rate) + size_of(total) + size_of(by_mass) + size_of(by_entropy);
    claim.zero("rate along any relabelling", model, S(rate - total + by_mass - by_entropy), terms, condition);
    claim.refutes("as if the entropy were the same everywhere", model, S(rate - total + by_mass), terms);
    claim.refutes("as if all kept the mass", model, S(rate - total - by_entropy), terms);

    // Some relabellings that keep both.
    MetricOfVolume<S, n> const body{draw_triangular_metric<S, n>(draw), chart};
    using Level = OfOtherCoordinates<S, n>;
    EntropyFluid<S, n, Level, Level> const layered{body, g, Level(draw, chart, S(2)),
                                                   Level(draw, chart, S(0)), fluid.e};
    auto shear = eta;
    for (int k = 1; k < n; ++k)
      shear.added[k] = {S(0), Matrix<S, n + 1, 1>::Zero(), Matrix<S, n + 1, 1>::Zero(),
                        Matrix<S, n + 1, 1>::Zero(), Matrix<S, n + 1, 1>::Zero()};
    auto const by = [&](Shears<S, n> const& map_of_labels) {
      Relabelled const labels{phi, map_of_labels, moment};
      auto const jet =
          first_jet([&](auto const& at) { return labels.label(at).template tail<n>().eval(); }, x);
      auto const there = first_jet(phi, labels.label(x));
      S const growth = determinant(Matrix<S, n, n>(jet.gradient()));
      return std::array{S(layered(first_jet(labels, x)) - layered(there) * growth),
                        S(layered.terms(there) * size_of(growth))};
    };
    auto const held = by(shear), other = by(eta);
    claim.zero("a layered fluid, labels moved along the layers", model, held[0], held[1], condition);
    claim.refutes("labels moved across the layers, the volume kept", model, other[0], other[1]);
  });
  over_points(claim, PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& dimensions) {
    std::string const model = "box, " + dimensions;
    FluidInBox<S, n> const fluid(draw);
    auto const& rho = fluid.D;
    auto const s = draw_linear<S, n + 1>(draw);
    // Energy per volume a D^2 + b D s + c D^2 s; e is that over D, and p = D^2 e_D = a D^2 + c D^2 s.
    S const a = draw.number<S>() + S(2), b = draw.number<S>() + S(2), c = draw.number<S>() + S(2);
    auto const square = rho * rho;
    auto const by_density = rho * S(a + a) + s * b + rho * s * S(c + c), by_entropy = rho * b + square * c,
               p = square * a + square * s * c;
    auto const part = [&](auto const& bracket_sign) {
      return fluid.of_velocity(varied_velocity(fluid.u, fluid.w, bracket_sign));
    };
    auto const density = integral(by_density - fluid.half_square(), fluid.flux(fluid.w, rho)),
               entropy = integral(by_entropy, fluid.along(fluid.w, s));
    auto const total = sum_of<S>({{1, part(1)}, {1, density}, {1, entropy}, {1, fluid.work(p)}});
    S const scale = size_of(part(1).value) + size_of(density.value) + size_of(entropy.value);
    claim.zero("the action varies by minus the work", model, total.value, scale,
               magnification<S>(total.size, scale));
    claim.refutes("with the bracket turned round", model,
                  sum_of<S>({{1, part(-1)}, {1, density}, {1, entropy}, {1, fluid.work(p)}}).value, scale);
    claim.refutes("with the density left as it is", model,
                  sum_of<S>({{1, part(1)}, {1, entropy}, {1, fluid.work(p)}}).value, scale);
    claim.refutes("with the entropy left as it is", model,
                  sum_of<S>({{1, part(1)}, {1, density}, {1, fluid.work(p)}}).value, scale);
    claim.refutes("without the term of the mass that is not conserved here", model,
                  sum_of<S>({{1, part(1)}, {1, density}, {1, entropy}, {1, fluid.work(p, false)}}).value,
                  scale);
  });
}

STATEMENT(claim_10_0_reduced_principle,
          "constrained variational principle on the reduced bundle of an incompressible fluid") {
  claim.convention(
      "The extra field is the density $D = 1/J$ in space, and the multiplier becomes the pressure $p "
      "= P\\circ\\phi^{-1}$: the reduced density is $\\tfrac12D|u|^2 + p(1 - D)$, whose integral is "
      "that of the extended one. With $\\delta u = \\dot w + [u, w]$, $\\delta D = "
      "-\\mathrm{div}(Dw)$ and $\\delta p = q - w\\cdot\\nabla p$, which are the variations of motion "
      "and multiplier, it gives $D(\\partial_tu + \\nabla_uu) + \\nabla p = 0$ and $D = 1$, so "
      "$\\mathrm{div}\\,u = 0$: over $D$, the field equations of the extended bundle, and on the "
      "constraint (8.11). The body is of density 1. Off the solutions and off the constraint, for any "
      "metrics; as integrals in a box with a metric of volume 1.");
  claim.leaves(
      "The bundle is given by its coordinates; that it is the quotient of the extended jet bundle by the "
      "group of relabellings, which has no finite dimension, is not shown.");
  over_points(claim, PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    using V = Matrix<S, n, 1>;
    auto const G = draw_any_metric<S, n>(draw), g = draw_any_metric<S, n>(draw);
    auto const fluid = incompressible(ideal_fluid<S, n>(G, g, S(0)));
    auto const phi = draw_motion<S, n>(draw, draw_chart<S, n>(draw), draw_chart<S, n>(draw));
    auto const p = draw_cubic<S, n + 1>(draw);
    CarriedBy const P{p, phi};
    auto const extended = second_jet(with_pressure(phi, P, G), draw_event<S, n>(draw));
    auto const j = deformation(extended);
    Event<S, n> const y = event_in_space(static_cast<Jet<S, n, n> const&>(j));
    VelocityInSpace const u{phi};
    auto const density_of = [&](auto const& motion) { return DensityInSpace{fluid.density, motion}; };
    auto const density = density_of(phi);
    S const here = density(y), J = fluid.constraint.volume_ratio(static_cast<Jet<S, n, n> const&>(j));
    constexpr double condition = 10;

    // The two densities, each per volume of its space.
    V const speed = u(y);
    auto const reduced = [&](S const& pressure) {
      return S((here * inner(g(j.y), speed, speed) / S(2) + pressure * (S(1) - here)) * volume<S>(g(j.y)) *
               determinant(Matrix<S, n, n>(j.gradient())));
    };
    S const on_body = fluid(static_cast<Jet<S, n, n + 1> const&>(extended));
    claim.equal("the extended density and the reduced one", model, on_body, reduced(p(y)), condition);
    claim.differs("with the pressure of the other sign", model, on_body, reduced(S(-p(y))));

    // The equations.
    V const acceleration = lowered(g(j.y), V(eulerian_acceleration(g, u, y))),
            slope = derivative(p, y).gradient().template tail<n>(), left = per_volume(fluid, extended);
    claim.equal("field equations of the extended bundle, and D a + dp", model, left,
                V((acceleration * here + slope) * J), condition);
    claim.differs("and D (a + dp), of a pressure that is not carried", model, left,
                  V((acceleration + slope) * here * J));
    S const multiplier = euler_lagrange(fluid, extended)[n];
    claim.equal("the equation of the multiplier, and 1 - D", model, multiplier, S((S(1) - here) * J),
                condition);
    claim.differs("the equation of the multiplier without J", model, multiplier, S(S(1) - here));
    auto const [as_function, as_density] = advected(g, density, u, y);
    S const scale = size_of(derivative(density, y).gradient()) * (S(1) + size_of(speed)) +
                    size_of(first_jet(u, y).v) * size_of(here);
    claim.zero("conservation of mass in space", model, as_density, scale, condition);
    claim.refutes("density as a function that is carried", model, as_function, scale);
    S const spread = divergence(g, u, y);
    claim.refutes("no divergence where D varies", model, spread, size_of(first_jet(u, y).v));
    auto const body = draw_metric_of_volume<S, n>(draw), space = draw_metric_of_volume<S, n>(draw);
    auto const held = draw_motion<S, n>(draw, body.chart, space.chart);
    auto const solid = ideal_fluid<S, n>(body, space, S(0));
    Event<S, n> const at = event_in_space(first_jet(held, draw_event<S, n>(draw)));
    claim.zero("D = 1 on the constraint", model, S(DensityInSpace{solid, held}(at)-S(1)), S(1), condition);
    claim.zero("and no divergence", model, divergence(space, VelocityInSpace{held}, at),
               size_of(first_jet(VelocityInSpace{held}, at).v), condition);

    // The variations of motion and multiplier, in space.
    AnyField<S, n> const w(draw);
    auto const w_flux = [&](auto const& event) { return (w(event) * density(event)).eval(); };
    claim.equal("change of the velocity in space", model,
                V(change_in_space(phi, w, y, [](auto const& motion) { return VelocityInSpace{motion}; })),
                constrained_change(u, w, y), condition);
    claim.equal("change of the density", model, S(change_in_space(phi, w, y, density_of)),
                S(-divergence(g, w_flux, y)), condition);
    auto const q = draw_cubic<S, n + 1>(draw);
    S const change = derivative(
                         [&]<class T>(T const& e) {
                           VariedInSpace const motion{phi, w, e};
                           Event<T, n> const from = motion.particle(y.template cast<T>().eval());
                           return T(P(from) + CarriedBy{q, phi}(from)*e);
                         },
                         S(0))
                         .rate;
    claim.equal("change of the pressure", model, change, S(q(y) - slope.dot(w(y))), condition);
    claim.differs("change of the pressure at a particle", model, change, S(q(y)));
  });
  over_points(claim, PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& dimensions) {
    std::string const model = "box, " + dimensions;
    FluidInBox<S, n> const fluid(draw);
    auto const p = draw_linear<S, n + 1>(draw) * draw_linear<S, n + 1>(draw), q = draw_linear<S, n + 1>(draw);
    auto const one = BoxPolynomial<S, n + 1>::constant(S(1));
    auto const held = one - fluid.D;
    auto const velocity = fluid.of_velocity(varied_velocity(fluid.u, fluid.w)),
               density = integral(p - fluid.half_square(), fluid.flux(fluid.w, fluid.D)),
               pressure = integral(held, q - fluid.along(fluid.w, p)), free = integral(held, q),
               work = fluid.work(p);
    S const scale = size_of(velocity.value) + size_of(density.value) + size_of(pressure.value);
    auto const total = sum_of<S>({{1, velocity}, {1, density}, {1, pressure}, {1, work}, {-1, free}});
    claim.zero("the reduced action varies by minus the work, and by 1 - D", model, total.value, scale,
               magnification<S>(total.size, scale));
    auto const turned = fluid.of_velocity(varied_velocity(fluid.u, fluid.w, -1));
    claim.refutes("with the bracket turned round", model,
                  sum_of<S>({{1, turned}, {1, density}, {1, pressure}, {1, work}, {-1, free}}).value, scale);
    auto const unconstrained = fluid.of_velocity(fluid.w);
    claim.refutes("with any change of the velocity", model,
                  sum_of<S>({{1, unconstrained}, {1, density}, {1, pressure}, {1, work}, {-1, free}}).value,
                  scale);
    claim.refutes("with the density left as it is", model,
                  sum_of<S>({{1, velocity}, {1, pressure}, {1, work}, {-1, free}}).value, scale);
    claim.refutes("with the pressure not carried along", model,
                  sum_of<S>({{1, velocity}, {1, density}, {1, work}}).value, scale);
  });
}
