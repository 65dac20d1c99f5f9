// Section 4.2, second part: the Lie-Poisson Hamilton-Jacobi equation and the Poisson map that its solution generates. Compiled once per scalar.
//
// The witness is the power series in the time of a free motion on a group, with coefficients in the scalar of the unit: equations between such series are checked power by
// power, over the rationals exactly. Their coefficients up to the sixth power are polynomials of degree 7 in the initial momentum and 6 in the inverse of the inertia, whose
// entries have degree 12 over a determinant of degree 12; the initial momentum may be the differential of a cubic in a place, of degree 20 over one of 20. With their inverses
// and products that stays below 1000. Where places are drawn, degrees are those of ch03_2d.cpp. The bounds say so.
#include "actio/foundations/taylor.hpp"
#include "actio/groupoid/generating_function.hpp"
#include "actio/variational/lie_poisson.hpp"
#include "sequences.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

constexpr int known_powers = 6;

/// One of each kind: compact, with translations, without an invariant volume, all matrices.
std::vector<SpannedGroup> const& series_groups() {
  static std::vector<SpannedGroup> const groups = {spanned("SO(3)", SO<3>{}), spanned("SO(4)", SO<4>{}), spanned("SE(3)", SE<3>{}), spanned("Aff(1)", Aff1{}),
                                                   spanned("GL(2)", GL<2>{})};
  return groups;
}
template <class S>
using Free = QuadraticLagrangian<SpannedGroup, S>;
/// Inertia without symmetry, and a linear term, so that time has a direction.
template <class S>
Free<S> draw_free(Draw& draw, SpannedGroup const& group) {
  auto const kinetic = draw_algebra_polynomial<S>(draw, group.dimension());
  return {group, kinetic.a, kinetic.b};
}

/// A family of motions with their generating function, as power series in the time: S, the relative motion f and the momentum, and how they vary.
template <class S>
struct Family {
  using Series = Taylor<S>;
  Matrix<Series> f, varied_f;
  Vector<Series> pi;
  Series s, varied_s;
  Momentum<SpannedGroup, S> pi0;

  /// \f$-\langle\mu, \delta f f^{-1}\rangle\f$ and \f$-\langle\mu, f^{-1}\delta f\rangle\f$: what dS does where \f$\mu\f$ is \f$-R_f^*dS\f$, \f$-L_f^*dS\f$.
  Series from_left(Vector<Series> const& mu) const { return -mu.dot(pi0.group.vee(Matrix<Series>(varied_f * inverse_matrix(f)))); }
  Series from_right(Vector<Series> const& mu) const { return -mu.dot(pi0.group.vee(Matrix<Series>(inverse_matrix(f) * varied_f))); }
  Vector<Series> start() const { return pi0.components.template cast<Series>(); }
  /// \f$\partial S/\partial t\f$ with f held: the rate along the motion, less what comes from f, by \f$-R_f^*dS = \Pi\f$.
  Series time_rate() const {
    Matrix<Series> rate(f.rows(), f.cols());
    for (Eigen::Index i = 0; i < f.size(); ++i) rate(i) = derivative(f(i));
    return derivative(s) + pi.dot(pi0.group.vee(Matrix<Series>(rate * inverse_matrix(f))));
  }
};
/// The motions that begin with a relative motion and a momentum that depend on a parameter, S being `start` before.
template <class S>
Family<S> family(Free<S> const& l, Element<SpannedGroup, Dual<S>> const& before, Momentum<SpannedGroup, Dual<S>> const& pi0, Dual<S> const& start) {
  using D = Dual<S>;
  FreeMotionSeries<SpannedGroup, D> motion(l, pi0);
  for (int k = 0; k < known_powers; ++k) motion.extend(l);
  auto const series = [&](auto const& coefficient) {
    std::vector<S> value, rate;
    for (int k = 0; k <= known_powers; ++k) value.push_back(coefficient(k).value), rate.push_back(coefficient(k).part[0]);
    return std::pair(Taylor<S>::series(value), Taylor<S>::series(rate));
  };
  int const n = l.group.matrix_size(), d = l.group.dimension();
  Family<S> made{Matrix<Taylor<S>>(n, n), Matrix<Taylor<S>>(n, n), Vector<Taylor<S>>(d), {}, {}, {l.group, Vector<S>(d)}};
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) std::tie(made.f(i, j), made.varied_f(i, j)) = series([&](int k) { return D(motion.f[k].row(i).dot(before.value.col(j))); });
  for (int a = 0; a < d; ++a) made.pi[a] = series([&](int k) { return motion.pi[k][a]; }).first, made.pi0.components[a] = pi0.components[a].value;
  std::tie(made.s, made.varied_s) = series([&](int k) { return k == 0 ? start : motion.action[k]; });
  return made;
}
/// The action: motions from the identity with any momentum.
template <class S>
Family<S> action_family(Free<S> const& l, Draw& draw) {
  auto const pi0 = draw.template momentum<S>(l.group), change = draw.template momentum<S>(l.group);
  auto moving = over<Dual<S>>(pi0);
  for (int a = 0; a < l.group.dimension(); ++a) moving.components[a].part[0] = change.components[a];
  return family(l, identity<Dual<S>>(l.group), moving, Dual<S>(S(0)));
}
/// Any other solution: a function k of the relative motion at time 0 generates a map to the momentum with which the motion begins; S is k and the action together.
/// `pi0` of it is the momentum before that map.
template <class S, class K>
Family<S> other_family(Free<S> const& l, K const& k, Draw& draw) {
  auto const at = draw.template element<S>(l.group);
  auto const before = varied(at, from_left(draw.template velocity<S>(l.group), at));
  auto made = family(l, before, -right_differential(k, before), k(before));
  made.pi0 = -left_differential(k, at);
  return made;
}
template <class S>
auto size_of_terms(Family<S> const& m) {
  return magnitude(m.pi) * (magnitude(m.varied_f) + magnitude(m.f)) * magnitude(m.f) + magnitude(m.varied_s) + magnitude(m.s) + Base<S>(1);
}
/// h of a series, and h of minus it.
template <class S>
Taylor<S> energy_of(Free<S> const& l, Vector<Taylor<S>> const& pi) {
  return l(momentum(l.group, pi));
}

}  // namespace

STATEMENT(eq_4_1, "the Lie-Poisson Hamilton-Jacobi equation") {
  claim.holds("For the action the left translation will do as well, since energy is conserved; every other solution needs the right one, and generates the flow after a fixed Poisson map.");
  claim.degree(1000);
  over_groups(series_groups(), claim, [&](auto const& group, auto const& model) {
    auto const l = draw_free<S>(draw, group);
    auto const action = action_family(l, draw);
    auto const other = other_family(l, draw_group_polynomial<S>(draw, group), draw);
    for (auto const* m : {&action, &other}) {
      std::string const which = m == &action ? "the action: " : "another solution: ";
      auto const scale = size_of_terms(*m);
      auto const rate = m->time_rate();
      // Condition: f is inverted; coefficients of several factors add up.
      claim.zero(which + "-R* dS is the momentum at time t", model, Taylor<S>(m->varied_s - m->from_left(m->pi)), scale, 10);
      claim.zero(which + "dS/dt + h(-R* dS)", model, Taylor<S>(rate + energy_of(l, m->pi)), scale, 10);
      // Controls: the other sign of the momentum; the left translation, where it tells; the other sign of h.
      claim.refutes(which + "h(R* dS)", model, Taylor<S>(rate + energy_of(l, Vector<Taylor<S>>(-m->pi))), scale, 1e-4);
      claim.refutes(which + "dS/dt - h", model, Taylor<S>(rate - energy_of(l, m->pi)), scale, 1e-4);
    }
    claim.zero("the action: dS/dt + h(-L* dS)", model, Taylor<S>(action.time_rate() + energy_of(l, action.start())), size_of_terms(action), 10);
    claim.zero("another solution: -L* dS is its own momentum at the start", model, Taylor<S>(other.varied_s - other.from_right(other.start())), size_of_terms(other), 10);
    claim.refutes("another solution: dS/dt + h(-L* dS)", model, Taylor<S>(other.time_rate() + energy_of(l, other.start())), magnitude(other.time_rate()), 1e-4);
    claim.refutes("the action: -R* dS as the momentum at the start", model, Taylor<S>(action.varied_s - action.from_left(action.start())), size_of_terms(action), 1e-5);
  });
  if constexpr (Real<S>) {
    // As functions of g and t. Where l is invariant under Ad, S = t l(-log(g)/t).
    S const inertia = ratio<S>(7, 5), t = ratio<S>(3, 4);
    for (auto const& group : {spanned("SO(3)", SO<3>{}), spanned_su2(), spanned("SO(4)", SO<4>{})}) {
      auto const energy = [&](auto const& pi) {
        using T = typename std::decay_t<decltype(pi)>::Scalar;
        return T(pi.components.dot(pi.components) / T(inertia) / T(2));
      };
      auto const s = [&](auto const& g, auto const& time) {
        using T = std::decay_t<decltype(time)>;
        auto const x = log(g).coordinates;
        return T(x.dot(x) * T(inertia) / (time * 2));
      };
      auto const g = draw.template element<S>(group);
      auto const pi = -right_differential(at_time(s, t), g);
      // Condition: the logarithm is differentiated.
      claim.zero("S = |log g|^2/2t", group.name(), hamilton_jacobi_left(s, energy, g, t), energy(pi), 10);
      claim.refutes("S = |log g|^2/2t, at twice the time", group.name(), S(time_derivative(s, g, S(t + t)) + energy(pi)), energy(pi));
    }
  }
}

STATEMENT(eq_4_2, "the initial momentum from the reduced generating function") {
  claim.holds("Its g is the relative motion g(t)^{-1} g_0: for a motion that starts at the identity it is the inverse of the place, not the place.");
  claim.degree(2000);
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const l = draw_reduced_lagrangian<S>(draw, group);
    auto const g = draw_places<S>(draw, group, 2);  // the earlier place first
    auto const generating = [l = lifted_left(l)](auto const& later, auto const& earlier) { return l(earlier, later); };
    auto const f = relative_motion_left(g[0], g[1]);
    // p0 = -dS/dg0, as the body at g0 feels it.
    auto const pi0 = coadjoint(g[0], -D2(generating, g[1], g[0]));
    auto const as_printed = initial_momentum_left(l, f);
    // Condition: a place is inverted.
    claim.equal("-L*_g dS_L is -dS/dg0 in the body", model, as_printed, pi0, 10);
    // Controls: the sign; the other translation; the place in the role of its inverse.
    claim.differs("L*_g dS_L", model, -as_printed, pi0);
    claim.differs("-R*_g dS_L", model, -right_differential(l, f), pi0);
    claim.differs("at g_0^-1 g(t)", model, initial_momentum_left(l, inverse(f)), pi0);
  });
  over_groups(series_groups(), claim, [&](auto const& group, auto const& model) {
    // The physical momentum: along exact motions.
    auto const l = draw_free<S>(draw, group);
    auto const m = action_family(l, draw);
    auto const scale = size_of_terms(m);
    claim.zero("the momentum with which the motion begins", model, Taylor<S>(m.varied_s - m.from_right(m.start())), scale, 10);
    claim.refutes("-R*_g dS_L", model, Taylor<S>(m.varied_s - m.from_left(m.start())), scale, 1e-5);
    claim.refutes("L*_g dS_L", model, Taylor<S>(m.varied_s + m.from_right(m.start())), scale, 1e-4);
  });
}

STATEMENT(eq_4_3, "the final momentum by the coadjoint action, and the Poisson map") {
  claim.convention("With Ad* the dual of Ad, no inverse in the star. The map is a Lie-Poisson map for the minus bracket, and so for the plus bracket, whatever S is.");
  claim.degree(2000);
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const l = draw_reduced_lagrangian<S>(draw, group);
    auto const g = draw_places<S>(draw, group, 2);
    auto const generating = [l = lifted_left(l)](auto const& later, auto const& earlier) { return l(earlier, later); };
    auto const f = relative_motion_left(g[0], g[1]);
    auto const pi0 = initial_momentum_left(l, f);
    // p = dS/dg, as the body at g feels it.
    auto const pi = coadjoint(g[1], D1(generating, g[1], g[0]));
    claim.equal("Ad*_{g^-1} Pi_0 is dS/dg in the body", model, final_momentum_left(f, pi0), pi, 10);
    claim.equal("and -R*_g dS_L", model, -right_differential(l, f), pi, 10);
    // Controls: no inverse, as in the last display of the section; no star.
    claim.differs("Ad*_g Pi_0", model, Ad_star(f, pi0), pi);
    if (!has_invariant_metric(model)) claim.differs("Ad_{g^-1} Pi_0", model, momentum(group, Vector<S>(Ad_matrix(inverse(f)) * pi0.components)), pi);

    // With g solved from Pi_0: d Pi_0 = -A theta and d Pi = -B theta. Condition: A is inverted.
    Matrix<S> const tangent = right_second_differential(l, f) * inverse_matrix(Matrix<S>([&] {
      // L* dS where f moves to e^theta f.
      Matrix<S> m(group.dimension(), group.dimension());
      over_batches(group.dimension(), [&](int first) { store_parts(m, left_differential(l, moved_left(f, first)).components, first); });
      return m;
    }()));
    auto const defect = [&](Matrix<S> const& t, Momentum<SpannedGroup, S> const& image) {
      return Matrix<S>(t * lie_poisson_tensor_plus(pi0) * t.transpose() - lie_poisson_tensor_plus(image));
    };
    claim.zero("Lie-Poisson defect of the map", model, defect(tangent, pi), S(magnitude(tangent) * magnitude(tangent) * size_of(pi0) + size_of(pi)), 100);
    // Controls: g another function of Pi_0; the momentum carried the wrong way.
    auto const other = several([&] {
      Matrix<S> const k = draw_matrix<S>(draw, group.dimension(), group.dimension()) / (S(2) * (S(1) + S(size_of(pi0))));
      auto const map = [&](auto const& at) {
        using T = std::decay_t<decltype(at.components[0])>;
        return final_momentum_left(retract(velocity(group, Vector<T>(k.template cast<T>() * at.components))), at);
      };
      Matrix<S> t(group.dimension(), group.dimension());
      over_batches(group.dimension(), [&](int first) {
        auto moved = over<Moved<S>>(pi0);
        for (int a = 0; a < batch && first + a < group.dimension(); ++a) moved.components[first + a].part[a] = S(1);
        store_parts(t, map(moved).components, first);
      });
      return defect(t, map(pi0));
    });
    claim.refutes("g another function of Pi_0", model, other, magnitude(lie_poisson_tensor_plus(pi0)));
  });
  over_groups(series_groups(), claim, [&](auto const& group, auto const& model) {
    auto const l = draw_free<S>(draw, group);
    auto const m = action_family(l, draw);
    auto const scale = size_of_terms(m);
    Element<SpannedGroup, Taylor<S>> const f{group, m.f};
    auto const start = momentum(group, m.start());
    claim.zero("along the flow", model, Vector<Taylor<S>>(final_momentum_left(f, start).components - m.pi), scale, 10);
    claim.refutes("along the flow, Ad*_g", model, Vector<Taylor<S>>(Ad_star(f, start).components - m.pi), scale, 1e-4);
  });
}
