// Section 4.2, third part: a discrete Lagrangian in the role of a generating function. Compiled once per scalar.
//
// Orders are fitted in double, against power series of equations written out by hand (top_in_any_group.hpp). Degrees: as in ch04_2a.cpp; those of the power series as in ch04_2b.cpp,
// put into polynomials of degree 6: below 6000.
#include "actio/groupoid/generating_series.hpp"
#include "sequences.hpp"
#include "limits.hpp"
#include "statement.hpp"
#include "top_in_any_group.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

/// Groups of the exact motions; of the fits, which are in double, one more.
template <class S>
std::vector<SpannedGroup> const& motion_groups() {
  static std::vector<SpannedGroup> const groups =
      fits_orders<S> ? std::vector{spanned("SO(3)", SO<3>{}), spanned("Aff(1)", Aff1{}), spanned("SE(2)", SE<2>{})} : std::vector{spanned("SO(3)", SO<3>{}), spanned("Aff(1)", Aff1{})};
  return groups;
}

/// Groups for polynomials in all coordinates.
std::vector<SpannedGroup> const& polynomial_groups() {
  static std::vector<SpannedGroup> const groups = {spanned("SO(3)", SO<3>{}), spanned("SE(2)", SE<2>{}), spanned("Aff(1)", Aff1{}), spanned("GL(2)", GL<2>{})};
  return groups;
}
/// The mean velocity w = -log(f)/t and the action over the time of a free motion, as power series in the time up to \f$t^5\f$.
template <class S>
std::pair<Velocity<SpannedGroup, Taylor<S>>, Taylor<S>> mean_motion(QuadraticLagrangian<SpannedGroup, S> const& l, Momentum<SpannedGroup, S> const& pi0) {
  constexpr int known = 6;
  FreeMotionSeries<SpannedGroup, S> motion(l, pi0);
  for (int k = 0; k < known; ++k) motion.extend(l);
  // f = 1 + t x, and log(f)/t = x - t x^2/2 + t^2 x^3/3 - ...
  auto const over_time = [&](auto const& coefficient) {
    std::vector<S> c;
    for (int k = 1; k <= known; ++k) c.push_back(coefficient(k));
    return Taylor<S>::series(c);
  };
  int const n = l.group.matrix_size();
  Matrix<Taylor<S>> x(n, n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) x(i, j) = over_time([&](int k) { return motion.f[k](i, j); });
  auto const time = Taylor<S>::series({S(0), S(1), S(0), S(0), S(0), S(0)});
  Matrix<Taylor<S>> power = x, log = x;
  for (int k = 2; k <= known; ++k) {
    power = Matrix<Taylor<S>>(power * x) * time;
    log += power * Taylor<S>(ratio<S>(k % 2 ? 1 : -1, k));
  }
  return {-velocity(l.group, l.group.vee(log)), over_time([&](int k) { return motion.action[k]; })};
}

/// l(f) + l(1/f): does not know the direction of time.
template <class L>
struct EvenPart {
  L l;
  template <class T>
  T operator()(Place<T> const& f) const {
    return l(f) + l(inverse(f));
  }
};

/// A free left-invariant motion from the witness: the inverse of the place moves by the right-invariant system with the opposite linear term.
template <class S>
struct Witness {
  TopInAnyGroup<S> mirror;

  QuadraticLagrangian<SpannedGroup, S> lagrangian() const { return {mirror.group, mirror.a, Vector<S>(-mirror.b)}; }
  FreeMotion<SpannedGroup, S> motion(Momentum<SpannedGroup, S> const& pi0, S const& t) const {
    auto const xi = lagrangian().velocity_of(pi0);
    auto const [end, action] = mirror.flow(State<SpannedGroup, S>{identity<S>(mirror.group), -xi}, t);
    return {end.place, momentum(mirror.group, Vector<S>(-(mirror.a * end.velocity.coordinates + mirror.b))), action};
  }
};

/// For orders up to 6: many more steps would end in rounding, many fewer would show the next term.
Refinement const moderate{1.5, {16, 18, 20, 24, 28, 32}};

}  // namespace

STATEMENT(claim_4_2_hamilton_jacobi_identification, "a discrete Lagrangian in the role of the generating function") {
  claim.corrected(R"(\Pi_k = L_f^*\,d\ell(f),\quad \Pi_{k+1} = R_f^*\,d\ell(f))", R"(\Pi_k = -L_f^*\,d\ell(f),\quad \Pi_{k+1} = -R_f^*\,d\ell(f),\quad S_L = \ell)",
                  "(4.2) has a minus that (4.4) lacks: with the momentum of (4.2) the printed system carries an even l backwards in time. With the signs, and l an action "
                  "(h times the l of the thesis), it is (4.2) and (4.3) for every l; its g approximates the inverse of the position. The discrete Lagrangian of the natural chart is the first term of the series that solves (4.1).");
  claim.degree(6000);
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    auto const l = draw_group_polynomial<S>(draw, group);
    auto const f = draw.template element<S>(group);
    auto const system = momentum_system_left(l, f);
    auto const pi0 = initial_momentum_left(l, f), pi1 = final_momentum_left(f, pi0);
    claim.equal("(4.2) is the first line with a minus", model, -system.first, pi0);
    claim.equal("(4.3) is the second line with a minus", model, -system.second, pi1, 10);
    claim.differs("the first line as printed", model, system.first, pi0);
    claim.differs("l divided by a step of 3/7", model, ratio<S>(7, 3) * pi0, pi0);
    // An even l, as of a body: the printed system, begun with the momentum at the end, leads back to the momentum at the start. Condition: a place is inverted.
    EvenPart<GroupPolynomial<S>> const even{l};
    auto const start = initial_momentum_left(even, f), end = final_momentum_left(f, start);
    auto const printed = momentum_system_left(even, inverse(f));
    claim.equal("even l, as printed: from the end ...", model, printed.first, end, 10);
    claim.equal("even l, as printed: ... back to the start", model, printed.second, start, 10);
    claim.differs("even l, as printed: forwards", model, momentum_system_left(even, f).first, start);
  });
  over_groups(polynomial_groups(), claim, [&](auto const& group, auto const& model) {
    // The series, power by power: at the mean velocity of a free motion, itself a power series in the time, it is the action over the time.
    auto const kinetic = draw_algebra_polynomial<S>(draw, group.dimension());
    QuadraticLagrangian<SpannedGroup, S> const l(group, kinetic.a, kinetic.b);
    auto const [w, mean_action] = mean_motion(l, draw.template momentum<S>(group));
    auto const time = Taylor<S>::series({S(0), S(1), S(0), S(0), S(0), S(0)});
    auto series = generating_series(l, 4);
    auto const scale = S(magnitude(mean_action)) + S(magnitude(w.coordinates));
    // Condition: monomials of the sixth degree in coefficients that add up.
    claim.zero("the series of (4.1) is the action, up to t^6", model, Taylor<S>(series.mean_lagrangian(w, time) - mean_action), scale, 100);
    // Controls: its last term with the other sign; the first term alone.
    for (auto& [powers, c] : series.sigma[4].terms) c = -c;
    claim.refutes("the fourth-order term with the other sign", model, Taylor<S>(series.mean_lagrangian(w, time) - mean_action), scale, 1e-7);
    series.sigma.resize(1);
    claim.refutes("the natural chart alone", model, Taylor<S>(series.mean_lagrangian(w, time) - mean_action), scale, 1e-5);
  });
  if constexpr (Real<S>)
    for (auto const& group : motion_groups<S>()) {
      Witness<S> const witness{draw_top_without_weight<S>(draw, group)};
      auto const l = witness.lagrangian();
      auto const pi0 = draw.template momentum<S>(group);
      S const t = ratio<S>(1, 3);
      auto const motion = witness.motion(pi0, t);
      auto const ours = free_motion_left(l, pi0, t);
      std::string const model = group.name();
      // Condition: two power series of some dozens of terms.
      claim.equal("the relative motion of the flow", model, ours.f.value, motion.f.value, 10);
      claim.equal("the momentum of the flow", model, ours.pi, motion.pi, 10);
      claim.equal("its action", model, ours.action, motion.action, 10);
      // The action between places as a generating function, where no orders are fitted. Condition: shooting over a third of a unit of time, and differentiated.
      auto const scale = S(size_of(pi0) + size_of(motion.pi) + Base<S>(1));
      if constexpr (!fits_orders<S>) {
        ExactGeneratingFunction const exact{l};
        auto const generated = initial_momentum_left(at_time(exact, t), motion.f);
        claim.zero("S = the action: (4.2) gives the momentum at the start", model, generated - pi0, scale, 100);
        claim.zero("S = the action: (4.3) gives the momentum at the end", model, final_momentum_left(motion.f, generated) - motion.pi, scale, 100);
        claim.zero("S = the action solves (4.1)", model, S(time_derivative(exact, motion.f, t) + l(motion.pi)), S(size_of(l(motion.pi)) + Base<S>(1)), 100);
      }
      // Controls: the first term of the series alone; the place in the role of its inverse.
      auto const chart = generating_series(l, 0);
      claim.refutes("the natural chart is not exact", model, initial_momentum_left(at_time(chart, t), motion.f) - pi0, scale, 1e-6);
      claim.refutes("(4.2) at the place", model, initial_momentum_left(at_time(chart, t), inverse(motion.f)) - pi0, scale);
    }
  if constexpr (fits_orders<S>)
    for (auto const& group : motion_groups<S>()) {
      Witness<S> const witness{draw_top_without_weight<S>(draw, group)};
      auto const l = witness.lagrangian();
      // Three motions, and three mean velocities, together: the leading term of one may be small by chance.
      std::vector<Momentum<SpannedGroup, S>> starts, ends;
      std::vector<Velocity<SpannedGroup, S>> velocities;
      for (int i = 0; i < 3; ++i) {
        starts.push_back(draw.template momentum<S>(group, S(2)));
        ends.push_back(witness.motion(starts.back(), S(moderate.duration)).pi);
        velocities.push_back(draw.template velocity<S>(group, S(2)));
      }
      auto const residual = [&](auto const& s, double h) {
        S sum(0);
        for (auto const& w : velocities) sum += std::abs(hamilton_jacobi_left(s, l, exp(S(-h) * w), h));
        return sum;
      };
      auto const run = [&](auto const& s, int n, double h, bool printed) {
        S sum(0);
        for (std::size_t i = 0; i < starts.size(); ++i) {
          auto pi = starts[i];
          auto f = exp(S(-h) * l.velocity_of(pi));
          for (int k = 0; k < n; ++k) {
            auto const step = hamilton_jacobi_step_left(at_time(s, h), pi, f);
            f = step.g, pi = printed ? Ad_star(f, pi) : step.final;
          }
          sum += size_of(pi - ends[i]);
        }
        return sum;
      };
      for (int order : {0, 2, 4}) {
        auto const s = generating_series(l, order);
        std::string const terms = "terms up to t^" + std::to_string(order) + ": ";
        claim.order(terms + "residual of (4.1)", group.name(), moderate.step_lengths(), moderate.errors_of([&](int, double h) { return residual(s, h); }), order + 2);
        claim.order(terms + "the integrator", group.name(), moderate.step_lengths(), moderate.errors_of([&](int n, double h) { return run(s, n, h, false); }), order + 2);
        if (order == 0) claim.refutes_order("carried by Ad*_f", group.name(), moderate.step_lengths(), moderate.errors_of([&](int n, double h) { return run(s, n, h, true); }), 2);
        if (order == 0) continue;
        // Control: the last term with the other sign.
        auto wrong = s;
        for (auto& [powers, c] : wrong.sigma[order].terms) c = -c;
        claim.refutes_order(terms + "the last with the other sign", group.name(), moderate.step_lengths(), moderate.errors_of([&](int n, double h) { return run(wrong, n, h, false); }), order + 2);
      }
    }
}
