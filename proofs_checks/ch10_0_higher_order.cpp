// Chapter 10: field theories of second order, and the averaged Euler equations as one of them.
//
// In a unit of its own, which is as large as a unit may be.
#include "fields/bundle_maps.hpp"
#include "fields/fields.hpp"
#include "fields/second_order_theory.hpp"
#include "statement.hpp"

namespace {

using namespace actio;
using namespace actio::checks;

/// A density of second degree in all coordinates of the second jets, and a product that makes it cubic.
template <class S, int n, int N>
struct AnySecondOrderDensity {
  static constexpr int all = Jet<S, n, N>::dimension + N * (n + 1) * (n + 2) / 2;
  Cubic<S, all> l;
  explicit AnySecondOrderDensity(Draw& draw) : l(cut(draw_cubic<S, all>(draw, ratio<S>(1, 2)), 2)) {}
  template <class T>
  T operator()(SecondJet<T, n, N> const& j) const {
    Matrix<T, all, 1> c;
    c.template head<Jet<S, n, N>::dimension>() = coordinates(static_cast<Jet<T, n, N> const&>(j));
    int k = Jet<S, n, N>::dimension;
    for (int mu = 0; mu <= n; ++mu)
      for (int nu = 0; nu <= mu; ++nu)
        for (int a = 0; a < N; ++a) c[k++] = j.w[mu](a, nu);
    return l(c) + j.w[0](0, n) * j.w[n](N - 1, n) * (j.y[0] + j.v(N - 1, 0));
  }
};

/// The path of bundle maps from the identity along \f$\eta - 1\f$, to first order.
template <class S, int n, int N>
BundleMap<Dual<S>, n, N> path_to(BundleMap<S, n, N> const& eta, Draw& draw) {
  BundleMap<Dual<S>, n, N> path(draw);
  Dual<S> epsilon(S(0));
  epsilon.part[0] = S(1);
  for (int i = 0; i < n + 1 + N; ++i) {
    auto& to = path.added[i];
    auto const& from = eta.added[i];
    path.scale[i] = Dual<S>(1) + epsilon * (eta.scale[i] - S(1));
    to.constant = epsilon * from.constant;
    for (int k = 0; k < n + 1 + N; ++k)
      to.a[k] = epsilon * from.a[k], to.b[k] = epsilon * from.b[k], to.d[k] = Dual<S>(from.d[k]),
      to.e[k] = Dual<S>(0);
  }
  return path;
}

/// The variational principle, the Cartan form and the form formula of a theory of second order.
template <class S, int n, int N>
void general_theory(Claim<S>& claim, Draw& draw, std::string const& model) {
  using Column = Matrix<S, N, 1>;
  AnySecondOrderDensity<S, n, N> const L(draw);
  auto const phi = draw_section<S, n, N>(draw);
  auto const theory = second_order_theory<n, N>(L, phi);
  auto const x = draw_event<S, n>(draw);
  auto const j = second_jet(phi, x);
  Column const E = theory.field_equations(x);
  S const value = theory.value(x);

  // The rate of the density under a path of bundle maps, which move space-time as well.
  BundleMap<S, n, N> const eta(draw);
  auto const path = path_to(eta, draw);
  using Epsilon = Dual<S>;
  auto const base = [&]<class T>(Event<T, n> const& u) { return path.on_base(u); };
  Event<Epsilon, n> const u = x.template cast<Epsilon>();
  Matrix<Epsilon, n + 1, n + 1> const stretch = derivative(base, u).matrix;
  Epsilon const moved =
      L(second_jet(path.moved(phi), Event<Epsilon, n>(path.on_base(u)))) * determinant(stretch);
  S const rate = rate_of(moved);
  auto const field = [&](auto const& point) { return (eta(point) - point).eval(); };
  auto const vertical = [&]<class T>(Event<T, n> const& v) {
    auto const here = first_jet(phi, v);
    return Matrix<T, N, 1>(vertical_part(here, Variation<T, n, N>(field(point_of(here)))));
  };
  auto const flux = [&]<class T>(Event<T, n> const& v) {
    auto const V = field(point_of(first_jet(phi, v)));
    return Event<T, n>(theory.current(vertical, v) + V.template head<n + 1>() * theory.value(v));
  };
  S const inside = E.dot(vertical(x)), boundary = divergence(flux, x);
  S const scale = magnitude(rate) + magnitude(inside) + magnitude(boundary);
  // Fourth derivatives of a product of five polynomials: an allowance of ten times that of plain evaluation.
  claim.zero("variation of the density: field equations and boundary term", model,
             S(rate - inside - boundary), scale, 10);
  claim.refutes("with the field equations of first order", model,
                S(rate - theory.of_first_order(x).dot(vertical(x)) - boundary), scale);
  Column const other_sign = theory.of_first_order(x) * S(2) - E;
  claim.refutes("with second derivatives of the momenta subtracted", model,
                S(rate - other_sign.dot(vertical(x)) - boundary), scale);

  // The Cartan form.
  auto const theta = second_order_cartan_form<n, N>(L);
  auto const jets = third_jet_extension<n, N>(phi);
  claim.equal("the Cartan form along third jets is the density", model,
              coefficient_of(pull_back(jets, theta), x), value, 10);
  constexpr int all = third_jet_dimension<n, N>;
  auto const lifted = [&]<class T, int D>(Matrix<T, D, 1> const& at) {
    Matrix<T, all, 1> W = Matrix<T, all, 1>::Zero();
    Matrix<T, Jet<S, n, N>::dimension, 1> const first = at.template head<Jet<S, n, N>::dimension>();
    W.template head<Jet<S, n, N>::dimension>() = prolonged<n, N>(field)(first);
    return W;
  };
  claim.equal("contracted with the variation it is the boundary term", model,
              components_of(pull_back(jets, contract(lifted, theta)), x), flux(x), 10);
  auto const any = draw.vector<S, Matrix<S, all, 1>>(all);
  Variation<S, n, N> const below = any.template head<n + 1 + N>();
  auto const contracted = [&](bool complete) {
    auto const d_theta = exterior_derivative(second_order_cartan_form<n, N>(L, complete));
    return coefficient_of(pull_back(jets, contract(ConstantField<S, all>{any}, d_theta)), x);
  };
  S const force = E.dot(vertical_part(static_cast<Jet<S, n, N> const&>(j), below));
  S const size = magnitude(E) * S(all) + magnitude(theory.momenta(x));
  claim.zero("contracted with any field on third jets its differential is the field equations", model,
             S(contracted(true) - force), size, 10);
  claim.refutes("the Cartan form of first order", model, S(contracted(false) - force), size);
}

/// Off shell: the divergence of the current of two variations.
template <class S, int n, int N>
void form_formula(Claim<S>& claim, Draw& draw, std::string const& model) {
  AnySecondOrderDensity<S, n, N> const L(draw);
  auto const phi = draw_section<S, n, N>(draw), Q = draw_section<S, n, N>(draw, S(1)),
             R = draw_section<S, n, N>(draw, S(1));
  auto const x = draw_event<S, n>(draw);
  auto const along = [&](auto const& q) { return second_order_theory<n, N>(L, varied_section<S>(phi, q)); };
  auto const along_Q = along(Q), along_R = along(R);
  auto const moved = [](auto const& v) {
    using T = ScalarOf<std::remove_cvref_t<decltype(v)>>;
    return Event<Dual<T>, n>(v.template cast<Dual<T>>());
  };
  auto const q_E = rate_of(along_Q.field_equations(moved(x))),
             r_E = rate_of(along_R.field_equations(moved(x)));
  // The derivatives of the currents by x first, then by the parameter of the variation.
  auto const divergence_of = [&](auto const& theory, auto const& vertical) {
    auto const flux = [&]<class T>(Event<T, n> const& v) { return theory.current(vertical, v); };
    return S(rate_of(divergence(flux, moved(x))));
  };
  S const left = divergence_of(along_Q, R) - divergence_of(along_R, Q), first = Q(x).dot(r_E),
          second = R(x).dot(q_E);
  S const scale = magnitude(left) + magnitude(first) + magnitude(second);
  claim.zero("off shell: divergence of the multisymplectic current", model, S(left - first + second), scale,
             10);
  claim.refutes("with both terms added", model, S(left - first - second), scale);
}

/// The Lagrangian of averaged fluids in terms of particles: \f$\tfrac12\int|u|^2 + c\,|\mathrm{Def}\,u|^2\f$
/// over space, \f$\nabla u = \dot F F^{-1}\f$, and a multiple of J - 1 that depends on the particle.
template <class S, int n>
struct AveragedFluid {
  S c;
  Cubic<S, n + 1> pressure;
  bool constrained;
  template <class T>
  T operator()(SecondJet<T, n, n> const& j) const {
    using Square = Matrix<T, n, n>;
    Square const F = j.gradient(), rate = j.w[0].template rightCols<n>();
    Square const slope = rate * inverse_matrix(F), D = (slope + slope.transpose()) / T(2);
    T const J = determinant(F), energy = j.v.col(0).squaredNorm() + D.squaredNorm() * T(c);
    T const constraint = constrained ? T(pressure(j.x) * (J - T(1))) : T(0);
    return J * energy / T(2) + constraint;
  }
};

/// The same fluid in the spatial description, along the motion; no Lagrangian enters here.
template <class S, int n, class Phi>
struct InSpace {
  S c;
  Phi phi;
  /// \f$\nabla u\f$ at the place of a particle.
  template <class T>
  Matrix<T, n, n> slope(Event<T, n> const& x) const {
    auto const j = second_jet(phi, x);
    return j.w[0].template rightCols<n>() * inverse_matrix(Matrix<T, n, n>(j.gradient()));
  }
  /// \f$\partial_bf\f$ in space from the derivatives by particles.
  template <class F, class T>
  auto in_space(F const& f, Event<T, n> const& x, int b) const {
    auto const rates = derivative(f, x);
    Matrix<T, n, n> const inverse = inverse_matrix(Matrix<T, n, n>(first_jet(phi, x).gradient()));
    auto sum = rates.partial(1);
    sum *= inverse(0, b);
    for (int i = 1; i < n; ++i) sum += rates.partial(1 + i) * inverse(i, b);
    return sum;
  }
  /// \f$m = u - c\,\mathrm{div}\,\mathrm{Def}\,u\f$, or with \f$\tfrac c2\Delta u\f$ in place of the last.
  template <class T>
  Matrix<T, n, 1> momentum(Event<T, n> const& x, bool laplacian = false) const {
    Matrix<T, n, 1> m = first_jet(phi, x).velocity();
    for (int b = 0; b < n; ++b) {
      Matrix<T, n, n> const rate = in_space([this](auto const& u) { return slope(u); }, x, b);
      m -= Matrix<T, n, 1>(rate.col(b) * T(S(c / S(2))));
      if (!laplacian) m -= Matrix<T, n, 1>(rate.row(b).transpose() * T(S(c / S(2))));
    }
    return m;
  }
  /// \f$\partial_tm + (u\cdot\nabla)m + (\nabla u)^Tm + m\,\mathrm{div}\,u\f$: the first two are the rate at
  /// the particle.
  Matrix<S, n, 1> balance(Event<S, n> const& x, bool laplacian = false) const {
    Matrix<S, n, n> const du = slope(x);
    Matrix<S, n, 1> const m = momentum(x, laplacian);
    auto const rates = derivative([&](auto const& u) { return momentum(u, laplacian); }, x);
    return rates.partial(0) + du.transpose() * m + m * du.trace();
  }
};

/// A motion that keeps volumes: each place is moved by those before it, and the first then by the last.
template <class S, int n>
struct Sheared {
  std::array<Cubic<S, n + 1>, n + 1> added;
  template <class X>
  auto operator()(X const& x) const {
    using T = ScalarOf<X>;
    Matrix<T, n + 1, 1> before = Matrix<T, n + 1, 1>::Zero();
    Matrix<T, n, 1> y;
    before[0] = x[0];
    for (int a = 0; a < n; ++a) y[a] = x[a + 1] + added[a](before), before[a + 1] = x[a + 1];
    before.template tail<n>().setConstant(y[n - 1]);
    y[0] += added[n](before);
    return y;
  }
};

/// Averaged fluids, n = 1 with the equation of Camassa and Holm.
template <class S, int n>
void averaged_fluids(Claim<S>& claim, Draw& draw, std::string const& model) {
  using Column = Matrix<S, n, 1>;
  AveragedFluid<S, n> L{draw.number<S>() + S(2), draw_cubic<S, n + 1>(draw), false};
  auto const phi = draw_section<S, n, n>(draw);
  auto const x = draw_event<S, n>(draw);
  Matrix<S, n, n> const F = first_jet(phi, x).gradient();
  S const J = determinant(F);
  InSpace<S, n, AnySection<S, n, n>> const fluid{L.c, phi};
  Column const E = second_order_theory<n, n>(L, phi).field_equations(x), balance = fluid.balance(x) * J;
  S const scale = magnitude(E) + magnitude(fluid.momentum(x));
  // Inverses of F, differentiated three times.
  claim.zero("field equations, and m_t + u.grad m + (grad u)^T m + m div u", model, Column(E + balance),
             scale, 100);
  claim.refutes("without the second derivatives of the momenta", model,
                Column(second_order_theory<n, n>(L, phi).of_first_order(x) + balance), scale);
  // With the constraint, whose multiplier is the pressure.
  L.constrained = true;
  auto const pressure = derivative(L.pressure, x).gradient();
  Column const push = inverse_matrix(F).transpose() * Column(pressure.template tail<n>()) * J;
  claim.zero("with the constraint J = 1: the gradient of the pressure as well", model,
             Column(second_order_theory<n, n>(L, phi).field_equations(x) + balance + push),
             S(scale + magnitude(push)), 100);
  if constexpr (n > 1) {
    Sheared<S, n> sheared;
    for (auto& c : sheared.added) c = draw_cubic<S, n + 1>(draw, ratio<S>(1, 2));
    InSpace<S, n, Sheared<S, n>> const ideal{L.c, sheared};
    Column const of_averaged_euler = ideal.balance(x, true);
    claim.zero("averaged Euler equations of a motion that keeps volumes, m = u - alpha^2 Laplacian u", model,
               Column(ideal.balance(x) - of_averaged_euler), S(magnitude(of_averaged_euler) + magnitude(L.c)),
               100);
    claim.differs("with that m for a motion that does not", model, fluid.balance(x, true), fluid.balance(x));
  }
}

/// The equation of Camassa and Holm, written out in space.
template <class S>
void camassa_holm(Claim<S>& claim, Draw& draw) {
  std::string const model = "n = 1, N = 1";
  AveragedFluid<S, 1> const L{draw.number<S>() + S(2), no_polynomial<S, 2>(), false};
  auto const phi = draw_section<S, 1, 1>(draw, ratio<S>(1, 2));
  auto const x = draw_event<S, 1>(draw);
  auto const rate = [](auto const& f, auto const& u, int mu) { return derivative(f, u).partial(mu)[0]; };
  auto const u = [&](auto const& v) {
    return Matrix<ScalarOf<std::remove_cvref_t<decltype(v)>>, 1, 1>(first_jet(phi, v).v.col(0));
  };
  // Derivatives in space, one after the other.
  auto const in_space = [&](auto const& f) {
    return [&phi, &rate, f](auto const& v) {
      using T = ScalarOf<std::remove_cvref_t<decltype(v)>>;
      return Matrix<T, 1, 1>(Matrix<T, 1, 1>::Constant(T(rate(f, v, 1) / first_jet(phi, v).v(0, 1))));
    };
  };
  auto const u_y = in_space(u);
  auto const u_yy = in_space(u_y);
  S const speed = u(x)[0], first = u_y(x)[0], second = u_yy(x)[0], third = in_space(u_yy)(x)[0];
  S const u_t = rate(u, x, 0) - speed * first, u_yyt = rate(u_yy, x, 0) - speed * third;
  S const stretch = first_jet(phi, x).v(0, 1);
  auto const equation = [&](S const& factor) {
    return S((u_t - L.c * u_yyt + S(3) * speed * first - L.c * (factor * first * second + speed * third)) *
             stretch);
  };
  S const E = second_order_theory<1, 1>(L, phi).field_equations(x)[0];
  S const scale =
      magnitude(E) + magnitude(u_t) + magnitude(S(L.c * u_yyt)) + magnitude(S(L.c * speed * third));
  claim.zero("u_t - c u_xxt + 3 u u_x = c (2 u_x u_xx + u u_xxx)", model, S(E + equation(S(2))), scale, 100);
  claim.refutes("with u_x u_xx once", model, S(E + equation(S(1))), scale);
}

}  // namespace

STATEMENT(claim_10_0_higher_order, "averaged Euler equations as a higher-order field theory") {
  claim.holds(
      "The methods do carry over to densities on second jets: the variational principle with variations "
      "that move space-time gives field equations and a Cartan form on third jets, with symmetric "
      "$p_a{}^{\\mu\\nu}$, and the form formula holds off shell, for vertical variations tried at $n = 1$, "
      "$N = 2$ and $n = 2$, $N = 1$. Instances: the equation of Camassa and Holm, and averaged Euler "
      "equations in the plane and in space with the constraint $J = 1$.");
  over_dimensions(SmallDimensions{}, [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
    general_theory<S, n, N>(claim, draw, model);
    if (n == 1 || !numbers_grow()) form_formula<S, n, N>(claim, draw, model);
  });
  averaged_fluids<S, 1>(claim, draw, "n = 1, N = 1");
  averaged_fluids<S, 2>(claim, draw, "n = 2, N = 2");
  // Thirty second derivatives of the density, differentiated twice: once, in machine words.
  auto const kind = current_arithmetic().kind();
  if (claim.first() && (kind == ArithmeticKind::hardware || kind == ArithmeticKind::prime))
    averaged_fluids<S, 3>(claim, draw, "n = 3, N = 3");
  camassa_holm(claim, draw);
}
