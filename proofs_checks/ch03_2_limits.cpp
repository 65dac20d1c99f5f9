// Section 3.2, fourth part: what the algorithms tend to as the step goes to zero, and the integrator on the
// dual that they make.
//
// Orders are fitted against power series of equations written out by hand (top_in_any_group.hpp).

#include "actio/reduction/discrete_lie_poisson.hpp"
#include "actio/variational/action.hpp"
#include "actio/variational/lie_poisson.hpp"

#include "models/chart_models.hpp"
#include "models/limits.hpp"
#include "models/sequences.hpp"
#include "models/top_in_any_group.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

/// \f$h\,L\f$ at the configuration half-way and with the velocity c/h,
/// \f$\mathrm{retract}(c) = g_1g_0^{-1}\f$: a scheme without exponential or logarithm.
template <class Lagrangian, class H>
auto discretize_by_cayley(Lagrangian L, H h) {
  return [=](auto const& g0, auto const& g1) {
    using T = typename std::decay_t<decltype(g0)>::Scalar;
    T const step = T(Base<T>(h));
    Velocity<SpannedGroup, T> const c{g0.group, g0.group.vee(inverse_cayley((g1 * inverse(g0)).value))};
    return L(State<SpannedGroup, T>{retract(c / T(2)) * g0, c / step}) * step;
  };
}
/// The same for an invariant Lagrangian: a function of the relative motion.
template <class Reduced, class H>
auto cayley_lagrangian(Reduced l, H h) {
  return [=](auto const& f) {
    using T = typename std::decay_t<decltype(f)>::Scalar;
    T const step = T(Base<T>(h));
    return l(Velocity<SpannedGroup, T>{f.group, f.group.vee(inverse_cayley(f.value))} / T(-step)) * step;
  };
}
/// A quarter of a unit of time in 8, 16, ..., 256 steps: in digits, where rounding is far away.
inline Refinement const in_digits{0.25, {8, 16, 32, 64, 128, 256}};
/// In double, with less to do than \ref by_halves where there is a second fit in digits.
inline Refinement const in_double{0.5, {8, 16, 32, 64, 128, 256}};
/// For controls that do not tend to anything near.
inline Refinement const coarse{0.25, {4, 8, 16, 32}};

/// The momentum of the top, in space.
template <class S>
Momentum<SpannedGroup, S> momentum_of(TopInAnyGroup<S> const& top, State<SpannedGroup, S> const& at) {
  return momentum(top.group, Vector<S>(top.a * at.velocity.coordinates + top.b));
}
template <class S>
State<SpannedGroup, S> draw_state(Draw& draw, SpannedGroup const& group) {
  auto const g = draw.template element<S>(group);
  return {g, draw.template velocity<S>(group)};
}

}  // namespace

STATEMENT(claim_3_2_action_sum_limit, "the discrete action sum tends to the action") {
  claim.corrected(R"(\sum_k\mathbb L(g_k,g_{k+1})\to\int L\,dt,\quad \mathbb L(g_k,g_{k+1})=L(\kappa,\chi))",
                  R"(\sum_k\Delta t\,\mathbb L(g_k,g_{k+1})\to\int L\,dt)",
                  "The step is missing: a discrete Lagrangian that is $L$ at an approximate state, as "
                  "defined in section 3.1 and (3.20), has the sum of $N$ values of $L$ for its action, which "
                  "grows with the number of steps. Times the step it is an energy times time and the sum "
                  "converges, for steps of any lengths.");
  over_groups(chart_groups<S>(), claim, [&](auto const& group, auto const& model) {
    auto const l = draw_algebra_polynomial<S>(draw, group.dimension());
    auto const xi = draw.template velocity<S>(group, ratio<S>(1, 2));
    auto const g = draw_small<S>(draw, group);
    auto const later = [&](S const& t) { return exp(t * xi) * g; };
    std::vector<S> const times = {S(0), ratio<S>(1, 7), ratio<S>(1, 2), ratio<S>(6, 5)};
    S sum(0), averages(0);
    for (std::size_t k = 0; k + 1 < times.size(); ++k) {
      S const h = times[k + 1] - times[k];
      S const term = discretize_right([&](auto const& v) { return l(v.velocity); }, h, at_first)(
          later(times[k]), later(times[k + 1]));
      sum += term, averages += term / h;
    }
    claim.equal("unequal steps along a one-parameter group", model, sum, S(l(xi) * times.back()));
    claim.differs("the step left out, as printed", model, averages, S(l(xi) * times.back()));
  });
  if (claim.fits_orders())
    for (auto const& group : limit_groups()) {
      auto const lagrangian = draw_top<S>(draw, group);
      auto const curve = draw_curve<S>(draw, group);
      Quadrature<S> const rule(20);
      S exact(0);
      for (int k = 0; k < 8; ++k)
        exact += action(lagrangian, curve, S(by_halves.duration * k / 8), S(by_halves.duration * (k + 1) / 8),
                        rule);
      auto const sum = [&](int n, double h, auto const& term) {
        S total(0);
        for (int k = 0; k < n; ++k) total += term(curve(S(h * k)), curve(S(h * (k + 1))));
        return magnitude(S(total - exact));
      };
      claim.order("the sum along any curve", group.name(), by_halves.step_lengths(),
                  by_halves.errors_of(
                      [&](int n, double h) { return sum(n, h, discretize_right(lagrangian, h, at_first)); }),
                  2);
      claim.refutes_order("the velocity from the later configuration to the earlier", group.name(),
                          by_halves.step_lengths(), by_halves.errors_of([&](int n, double h) {
                            return sum(n, h, [&](auto const& g0, auto const& g1) {
                              return discretize_right(lagrangian, h, at_first)(g1, g0);
                            });
                          }),
                          2);
      claim.refutes_order("the step left out, as printed", group.name(), by_halves.step_lengths(),
                          by_halves.errors_of([&](int n, double h) {
                            return sum(n, h, [&](auto const& g0, auto const& g1) {
                              return discretize_right(lagrangian, h, at_first)(g0, g1) / S(h);
                            });
                          }),
                          2);
      // Steps of two lengths in turn, and a scheme in another chart.
      auto const unequal = [&](int n, double h) {
        S total(0);
        for (int k = 0; k < n; k += 2) {
          S const from(h * k), between(h * (k + 0.5)), to(h * (k + 2));
          total += discretize_by_cayley(lagrangian, h / 2)(curve(from), curve(between)) +
                   discretize_by_cayley(lagrangian, 3 * h / 2)(curve(between), curve(to));
        }
        return magnitude(S(total - exact));
      };
      claim.order("the sum along any curve, unequal steps, Cayley's chart", group.name(),
                  by_halves.step_lengths(), by_halves.errors_of(unequal), 2);
    }
}

namespace {

/// Errors of configuration and momentum, one of each for each number of steps.
struct EndErrors {
  std::vector<double> configurations, momenta;
};
/// Of the discrete Euler-Lagrange algorithm, from two configurations of the flow to the end.
template <class S, class Scheme>
EndErrors errors_of_flow(TopInAnyGroup<S> const& top, State<SpannedGroup, S> const& v, Refinement const& fine,
                         Scheme const& scheme) {
  auto const exact = top.flow(v, S(fine.duration)).first;
  EndErrors errors;
  for (int n : fine.counts) {
    double const h = fine.duration / n;
    auto const L = scheme(h);
    auto before = v.configuration, now = top.flow(v, S(h)).first.configuration;
    for (int k = 1; k < n; ++k) {
      auto const next = step_euler_lagrange(L, before, now).value;
      before = now, now = next;
    }
    errors.configurations.push_back(to_double(size_of(now - exact.configuration)));
    errors.momenta.push_back(to_double(size_of(D2(L, before, now) - momentum_of(top, exact))));
  }
  return errors;
}
/// Of the discrete Euler-Poincare algorithm, reconstructed; the momentum at the start of the next step.
template <class S, class Scheme>
EndErrors errors_of_reduced_flow(TopInAnyGroup<S> const& top, State<SpannedGroup, S> const& v,
                                 Refinement const& fine, Scheme const& scheme) {
  auto const exact = top.flow(v, S(fine.duration)).first;
  EndErrors errors;
  for (int n : fine.counts) {
    double const h = fine.duration / n;
    auto const l = scheme(h);
    auto g = v.configuration;
    auto f = relative_motion_right(g, top.flow(v, S(h)).first.configuration);
    for (int k = 0; k < n; ++k) {
      g = reconstruct_right(g, f);
      f = step_euler_poincare_right(l, f).value;
    }
    errors.configurations.push_back(to_double(size_of(g - exact.configuration)));
    errors.momenta.push_back(to_double(size_of(momentum_before_right(l, f) - momentum_of(top, exact))));
  }
  return errors;
}

}  // namespace

STATEMENT(claim_3_2_del_limit, "the discrete Euler-Lagrange algorithm tends to the Euler-Lagrange flow") {
  claim.holds(
      "With the order of the discrete Lagrangian, here 2, forward in time: for a natural chart at the "
      "configuration and at a fixed base point, in double, and for Cayley's, in fifty digits.");
  for (auto const& group : limit_groups()) {
    auto const judge = [&](std::string const& chart, Refinement const& fine, EndErrors const& errors) {
      claim.order("the configuration, " + chart, group.name(), fine.step_lengths(), errors.configurations, 2);
      claim.order("the momentum, " + chart, group.name(), fine.step_lengths(), errors.momenta, 2);
    };
    auto const refute = [&](auto const& top, auto const& v, auto const& scheme) {
      auto const reversed = [&](double h) {
        return [L = scheme(h)](auto const& g0, auto const& g1) { return L(g1, g0); };
      };
      claim.refutes_order("the velocity from the later configuration to the earlier", group.name(),
                          coarse.step_lengths(), errors_of_flow(top, v, coarse, reversed).configurations, 2);
    };
    if (claim.fits_orders()) {
      auto const top = draw_top<S>(draw, group);
      auto const v = draw_state<S>(draw, group);
      judge("chart at the first configuration", in_double,
            errors_of_flow(top, v, in_double, [&](double h) { return discretize_right(top, h, at_first); }));
      judge("chart at a fixed base point", in_double, errors_of_flow(top, v, in_double, [&](double h) {
              return discretize_right(top, h, staying_at(v.configuration));
            }));
      refute(top, v, [&](double h) { return discretize_right(top, h, at_first); });
    }
    if (claim.fits_orders_in_digits()) {
      auto const top = draw_top<S>(draw, group);
      auto const v = draw_state<S>(draw, group);
      judge("Cayley's chart", in_digits,
            errors_of_flow(top, v, in_digits, [&](double h) { return discretize_by_cayley(top, h); }));
      refute(top, v, [&](double h) { return discretize_by_cayley(top, h); });
    }
  }
}

STATEMENT(
    claim_3_2_dep_limit,
    "the discrete Euler-Poincare algorithm, reconstructed, tends to the Euler-Poincare flow, reconstructed") {
  claim.holds(
      "Read by means of reconstruction, or of the momentum: to second order, in two charts. The velocity "
      "of a relative motion, taken for that at its earlier end, is right to first order only.");
  for (auto const& group : limit_groups()) {
    auto const judge = [&](std::string const& chart, Refinement const& fine, EndErrors const& errors) {
      claim.order("the configuration, " + chart, group.name(), fine.step_lengths(), errors.configurations, 2);
      claim.order("the momentum, " + chart, group.name(), fine.step_lengths(), errors.momenta, 2);
    };
    auto const top = draw_top_without_weight<S>(draw, group);
    auto const v = draw_state<S>(draw, group);
    if (claim.fits_orders()) {
      judge("natural chart", in_double, errors_of_reduced_flow(top, v, in_double, [&](double h) {
              return natural_chart_lagrangian_right(reduced(top), h);
            }));
      // Control: the relative motion itself, as a velocity. Along the flow, so that the algorithm has no part
      // in it.
      claim.refutes_order("the velocity of the relative motion", group.name(), in_double.step_lengths(),
                          in_double.errors_of([&](int, double h) {
                            auto const next = top.flow(v, S(h)).first.configuration;
                            auto const f = relative_motion_right(v.configuration, next);
                            return size_of(-log(f) / S(h) - v.velocity);
                          }),
                          2);
    }
    if (claim.fits_orders_in_digits()) {
      judge("Cayley's chart", in_digits, errors_of_reduced_flow(top, v, in_digits, [&](double h) {
              return cayley_lagrangian(reduced(top), h);
            }));
      // Control: the relative motion of the other side, reconstructed as if it were this one.
      claim.refutes_order("lifted by f instead of its inverse", group.name(), coarse.step_lengths(),
                          coarse.errors_of([&](int n, double h) {
                            auto const l = cayley_lagrangian(reduced(top), h);
                            auto g = v.configuration;
                            auto f = relative_motion_right(g, top.flow(v, S(h)).first.configuration);
                            for (int k = 0; k < n; ++k) g = f * g, f = step_euler_poincare_right(l, f).value;
                            return size_of(g - top.flow(v, S(coarse.duration)).first.configuration);
                          }),
                          2);
    }
  }
}

STATEMENT(claim_3_2_legendre_limit, "the discrete Legendre transformation tends to the continuous one") {
  claim.corrected(
      R"(F\mathbb L=(g_k,\,D_1\mathbb L)\to FL)", R"((g_k,\,-\Delta t\,D_1\mathbb L)\to FL)",
      "With the sign and the step that the printed one lacks: $D_1\\mathbb L$ of a discrete Lagrangian "
      "that approximates $L$ is minus the momentum over the step. Along any curve to first order, along "
      "motions to second; $D_2\\mathbb L$ at the later configuration likewise.");
  if (!claim.fits_orders() && !claim.fits_orders_in_digits()) return;
  for (auto const& group : limit_groups()) {
    auto const top = draw_top<S>(draw, group);
    auto const curve = draw_curve<S>(draw, group);
    auto const v = draw_state<S>(draw, group);
    auto const on_curve = [&](S const& t) { return state_of(curve(moving(t))); };
    auto const on_motion = [&](S const& t) { return top.flow(v, t).first; };
    std::vector<double> steps;
    for (int k = 5; k <= 10; ++k) steps.push_back(std::ldexp(1.0, -k));
    // |momentum(L_h, g(0), g(h)) - FL| for each step, FL at the earlier end or at the later one.
    auto const errors = [&](auto const& scheme, auto const& state_at, bool later, auto const& momentum) {
      std::vector<double> all;
      for (double h : steps) {
        auto const start = state_at(S(0)), end = state_at(S(h));
        all.push_back(to_double(size_of(momentum(scheme(h), start.configuration, end.configuration) -
                                        momentum_of(top, later ? end : start))));
      }
      return all;
    };
    auto const source = [](auto const& L, auto const& g0, auto const& g1) { return -D1(L, g0, g1); };
    auto const target = [](auto const& L, auto const& g0, auto const& g1) { return D2(L, g0, g1); };
    auto const printed = [](auto const& L, auto const& g0, auto const& g1) { return D1(L, g0, g1); };
    auto const natural = [&](double h) { return discretize_right(top, h, at_first); };
    auto const cayley = [&](double h) { return discretize_by_cayley(top, h); };
    auto const without_step = [&](double h) {
      return [L = discretize_by_cayley(top, h), h](auto const& g0, auto const& g1) {
        return L(g0, g1) / typename std::decay_t<decltype(g0)>::Scalar(h);
      };
    };
    auto const name = group.name();
    claim.order("along any curve, natural chart", name, steps, errors(natural, on_curve, false, source), 1);
    claim.order("along any curve, Cayley's chart", name, steps, errors(cayley, on_curve, false, source), 1);
    claim.order("at the later end of any curve", name, steps, errors(cayley, on_curve, true, target), 1);
    claim.order("along a motion, natural chart", name, steps, errors(natural, on_motion, false, source), 2);
    claim.order("along a motion, Cayley's chart", name, steps, errors(cayley, on_motion, false, source), 2);
    claim.order("at the later end of a motion", name, steps, errors(cayley, on_motion, true, target), 2);
    claim.refutes_order("D_1 L without the minus sign, as printed", name, steps,
                        errors(cayley, on_curve, false, printed), 1);
    claim.refutes_order("the step left out, as printed", name, steps,
                        errors(without_step, on_curve, false, source), 1);
  }
}

STATEMENT(claim_3_2_diagram_does_not_commute,
          "two ways from pairs to momenta and velocities, which agree in the limit alone") {
  claim.convention(
      "The diagram has no arrow from $G$ to the algebra. Read so: the momentum of a pair is not that of the "
      "state which the pair approximates, at any step, but $\\chi(-h\\,\\mathrm{ad}_\\xi)^*$ of it, for the "
      "natural chart; the two agree along $\\xi$, where brackets vanish, and in the limit to first order, "
      "with $\\tfrac h2\\mathrm{ad}^*_\\xi$ of the momentum as leading difference. And the relative motion "
      "of a pair tends to 1, whatever the velocity.");
  S const h = step_length<S>();
  auto const momenta = [](auto const& l, S const& step, Algebra<S> const& xi) {
    return std::pair(momentum_before_right(natural_chart_lagrangian_right(l, step), exp(-step * xi)),
                     gradient(l, xi));
  };
  over_groups(chart_groups<S>(), claim, [&](auto const& group, auto const& model) {
    auto const l = draw_algebra_polynomial<S>(draw, group.dimension());
    auto const xi = draw.template velocity<S>(group, exact_arithmetic<S>() ? S(1) : ratio<S>(1, 2));
    auto const [of_pair, of_state] = momenta(l, h, xi);
    auto const turned = [&](S const& by) {
      return Vector<S>(iex(Matrix<S>(ad_matrix(xi) * by)).transpose() * of_pair.components);
    };
    Vector<S> const expected = of_state.components;
    // Condition: the logarithm of an exponential, differentiated.
    claim.equal("the momentum of a pair, carried by iex*, is that of the state", model, turned(S(-h)),
                expected, 100);
    claim.zero("the two agree along xi", model, S((of_pair.components - expected).dot(xi.coordinates)),
               S(magnitude(expected) * size_of(xi)), 100);
    claim.differs("momentum of the pair and of the state at one step", model, column(of_pair), expected);
    claim.differs("carried by iex* of the opposite velocity", model, turned(h), expected);
  });
  // Where brackets vanish the two are one: translations of the plane.
  SpannedGroup::WholeMatrix first = SpannedGroup::WholeMatrix::Zero(3, 3), second = first;
  first(0, 2) = 1, second(1, 2) = 1;
  SpannedGroup const plane("translations", {first, second});
  auto const [of_pair, of_state] =
      momenta(draw_algebra_polynomial<S>(draw, 2), h, draw.template velocity<S>(plane));
  claim.equal("where brackets vanish they agree", "translations", column(of_pair),
              Vector<S>(of_state.components),
              10);  // the step is divided by and multiplied with

  if (!claim.fits_orders()) return;
  for (auto const& group : limit_groups()) {
    auto const l = draw_algebra_polynomial<S>(draw, group.dimension());
    auto const xi = draw.template velocity<S>(group);
    auto const curve = draw_curve<S>(draw, group);
    auto const start = state_of(curve(moving(S(0))));
    std::vector<double> steps, apart, corrected, wrong, to_one, to_velocity, itself;
    for (int k = 5; k <= 10; ++k) {
      S const step = ratio<S>(1, 1 << k);
      auto const [pair_s, state_s] = momenta(l, step, xi);
      auto const gap = pair_s - momentum(group, Vector<S>(state_s.components));
      auto const leading = ad_star(xi, momentum(group, Vector<S>(state_s.components * S(step / 2))));
      auto const f = relative_motion_right(start.configuration, curve(step));
      steps.push_back(to_double(step)), apart.push_back(to_double(size_of(gap)));
      corrected.push_back(to_double(size_of(gap - leading)));
      wrong.push_back(to_double(size_of(gap + leading)));
      to_one.push_back(to_double(size_of(f - identity<S>(group))));
      to_velocity.push_back(to_double(size_of(-log(f) / step - start.velocity)));
      itself.push_back(to_double(size_of(-log(f) - start.velocity)));
    }
    claim.order("the two momenta apart", group.name(), steps, apart, 1);
    claim.order("less half a step of ad*", group.name(), steps, corrected, 2);
    claim.refutes_order("plus half a step of ad*", group.name(), steps, wrong, 2);
    claim.order("the relative motion tends to 1", group.name(), steps, to_one, 1);
    claim.order("its logarithm, over minus the step, to the velocity", group.name(), steps, to_velocity, 1);
    claim.refutes_order("the quotient before the limit: it tends to the velocity", group.name(), steps,
                        itself, 1);
  }
}

STATEMENT(claim_3_2_lie_poisson_integrator,
          "solving the discrete Euler-Poincare equations and carrying the momentum "
          "makes a Lie-Poisson integrator") {
  claim.holds(
      "It preserves the bracket because its relative motion solves those equations; that it "
      "preserves the orbits is not enough.");
  over_groups(few_groups(), claim, [&](auto const& group, auto const& model) {
    // One step with f solved from mu0, wherever (3.10) has a solution: draw f, and mu0 is the momentum at its
    // start.
    auto const l = draw_group_polynomial<S>(draw, group);
    auto const f = draw.template element<S>(group);
    auto const mu0 = momentum_before_right(l, f);
    auto const mu1 = lie_poisson_update_right(f, mu0);
    claim.equal("the momentum at the end of the step is that at the start of the next", model,
                -left_differential(l, f), mu1);
    // Its tangent, from the equation: d mu0 = -A theta, d mu1 = -B theta. Condition: A is inverted.
    Matrix<S> const tangent =
        left_second_differential(l, f) * inverse_matrix(right_second_differential(l, f));
    auto const defect = [&](Matrix<S> const& t, Momentum<SpannedGroup, S> const& image) {
      return Matrix<S>(t * lie_poisson_tensor_plus(mu0) * t.transpose() - lie_poisson_tensor_plus(image));
    };
    claim.zero("the bracket is preserved", model, defect(tangent, mu1),
               S(magnitude(tangent) * magnitude(tangent) * size_of(mu0) + size_of(mu1)), 100);
    // Controls: the inverse element; and an explicit Euler step of mu' = -ad* mu. (On Aff(1) any such step
    // preserves the bracket: there it is the determinant of the step times mu_2.)
    claim.differs("Ad* of the inverse", model, -left_differential(l, f), Ad_star(inverse(f), mu0));
    auto const xi = draw.template velocity<S>(group);
    Matrix<S> const euler =
        Matrix<S>::Identity(group.dimension(), group.dimension()) - ad_matrix(xi).transpose();
    if (model != "Aff(1)")
      claim.refutes("an explicit Euler step", model,
                    defect(euler, momentum(group, Vector<S>(euler * mu0.components))), size_of(mu0));
  });
  if (claim.fits_orders())
    for (auto const& group : limit_groups()) {
      auto const top = draw_top_without_weight<S>(draw, group);
      auto const v = draw_state<S>(draw, group);
      auto const exact = momentum_of(top, top.flow(v, S(in_double.duration)).first);
      auto const run = [&](int n, double h, auto const& carry) {
        auto const l = natural_chart_lagrangian_right(reduced(top), h);
        auto mu = momentum_of(top, v);
        auto f = exp(S(-h) * v.velocity);
        for (int k = 0; k < n; ++k) {
          f = relative_motion_from_momentum_right(l, mu, f).value;
          mu = carry(f, mu);
        }
        return size_of(mu - exact);
      };
      claim.order("against the Lie-Poisson flow", group.name(), in_double.step_lengths(),
                  in_double.errors_of([&](int n, double h) {
                    return run(n, h,
                               [](auto const& f, auto const& mu) { return lie_poisson_update_right(f, mu); });
                  }),
                  2);
      claim.refutes_order("the flow, carried by Ad* of the inverse", group.name(), in_double.step_lengths(),
                          in_double.errors_of([&](int n, double h) {
                            return run(n, h,
                                       [](auto const& f, auto const& mu) { return Ad_star(inverse(f), mu); });
                          }),
                          2);
    }
}
