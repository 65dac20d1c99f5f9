// Section 3.2, fourth part: what the algorithms tend to as the step goes to zero, and the integrator on the
// dual that they make.
//
// Orders are fitted against power series of equations written out by hand (top_in_any_group.hpp).

#include "actio/reduction/discrete_lie_poisson.hpp"
#include "actio/variational/action.hpp"
#include "actio/variational/lie_poisson.hpp"

#include "chart_models.hpp"
#include "limits.hpp"
#include "sequences.hpp"
#include "statement.hpp"
#include "top_in_any_group.hpp"

using namespace actio;
using namespace actio::checks;

STATEMENT(claim_3_2_action_sum_limit, "the discrete action sum tends to the action") {
  claim.convention(
      "For a discrete Lagrangian that is an action, energy times time. A sum of the averages that (3.20) "
      "prints has no step in it and grows with the number of steps.");
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
    }
}

STATEMENT(claim_3_2_del_limit, "the discrete Euler-Lagrange algorithm tends to the Euler-Lagrange flow") {
  claim.holds("With the order of the discrete Lagrangian, here 2.");
  if (claim.fits_orders())
    for (auto const& group : limit_groups()) {
      auto const top = draw_top<S>(draw, group);
      State<SpannedGroup, S> const v{draw.template element<S>(group), draw.template velocity<S>(group)};
      auto const exact = top.flow(v, S(by_halves.duration)).first;
      auto const momentum_at_end = momentum(group, Vector<S>(top.a * exact.velocity.coordinates + top.b));
      // The errors at the end: of the configuration, and of the momentum at the end of the last step.
      auto const run = [&](int n, double h, auto const& L) {
        auto before = v.configuration, configuration = top.flow(v, S(h)).first.configuration;
        for (int k = 1; k < n; ++k) {
          auto const next = step_euler_lagrange(L, before, configuration).value;
          before = configuration, configuration = next;
        }
        return std::pair(magnitude((configuration.value - exact.configuration.value).eval()),
                         size_of(D2(L, before, configuration) - momentum_at_end));
      };
      std::vector<double> momenta;
      auto const configurations = by_halves.errors_of([&](int n, double h) {
        auto const [of_place, of_momentum] = run(n, h, discretize_right(top, h, at_first));
        momenta.push_back(to_double(of_momentum));
        return of_place;
      });
      claim.order("the configuration", group.name(), by_halves.step_lengths(), configurations, 2);
      claim.order("the momentum", group.name(), by_halves.step_lengths(), momenta, 2);
      claim.refutes_order("the velocity from the later configuration to the earlier", group.name(),
                          by_halves.step_lengths(), by_halves.errors_of([&](int n, double h) {
                            return run(
                                       n, h,
                                       [&](auto const& g0, auto const& g1) {
          return discretize_right(top, h, at_first)(g1, g0);
                                       })
                                .first;
                          }),
                          2);
    }
}

STATEMENT(
    claim_3_2_dep_limit,
    "the discrete Euler-Poincare algorithm, reconstructed, tends to the Euler-Poincare flow, reconstructed") {
  claim.holds(
      "Read by means of reconstruction, or of the momentum: to second order. The velocity of a relative "
      "motion, taken for that at its earlier end, is right to first order only.");
  if (claim.fits_orders())
    for (auto const& group : limit_groups()) {
      auto const top = draw_top_without_weight<S>(draw, group);
      State<SpannedGroup, S> const v{draw.template element<S>(group), draw.template velocity<S>(group)};
      auto const exact = top.flow(v, S(by_halves.duration)).first;
      auto const momentum_at_end = momentum(group, Vector<S>(top.a * exact.velocity.coordinates + top.b));
      struct Error {
        S configuration, momentum, velocity;
      };
      auto const run = [&](int n, double h) -> Error {
        auto const l = natural_chart_lagrangian_right(reduced(top), h);
        auto configuration = v.configuration;
        auto f = relative_motion_right(configuration, top.flow(v, S(h)).first.configuration);
        for (int k = 0; k < n; ++k) {
          configuration = reconstruct_right(configuration, f);
          f = step_euler_poincare_right(l, f).value;
        }
        return {magnitude((configuration.value - exact.configuration.value).eval()),
                size_of(momentum_before_right(l, f) - momentum_at_end),
                size_of(-log(f) / S(h) - exact.velocity)};
      };
      std::vector<double> momenta, velocities;
      auto const configurations = by_halves.errors_of([&](int n, double h) {
        Error const error = run(n, h);
        momenta.push_back(to_double(error.momentum)), velocities.push_back(to_double(error.velocity));
        return error.configuration;
      });
      claim.order("the configuration", group.name(), by_halves.step_lengths(), configurations, 2);
      claim.order("the momentum", group.name(), by_halves.step_lengths(), momenta, 2);
      claim.refutes_order("the velocity of the relative motion", group.name(), by_halves.step_lengths(),
                          velocities, 2);
    }
}

STATEMENT(claim_3_2_lie_poisson_integrator,
          "solving the discrete Euler-Poincare equations and carrying the momentum makes a Lie-Poisson "
          "integrator") {
  claim.holds(
      "It preserves the bracket because its relative motion solves those equations; that it preserves the "
      "orbits is not enough.");
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
      State<SpannedGroup, S> const v{draw.template element<S>(group), draw.template velocity<S>(group)};
      auto const momentum_of = [&](State<SpannedGroup, S> const& at) {
        return momentum(group, Vector<S>(top.a * at.velocity.coordinates + top.b));
      };
      auto const exact = momentum_of(top.flow(v, S(by_halves.duration)).first);
      auto const run = [&](int n, double h, auto const& carry) {
        auto const l = natural_chart_lagrangian_right(reduced(top), h);
        auto mu = momentum_of(v);
        auto f = exp(S(-h) * v.velocity);
        for (int k = 0; k < n; ++k) {
          f = relative_motion_from_momentum_right(l, mu, f).value;
          mu = carry(f, mu);
        }
        return size_of(mu - exact);
      };
      claim.order("against the Lie-Poisson flow", group.name(), by_halves.step_lengths(),
                  by_halves.errors_of([&](int n, double h) {
                    return run(n, h,
                               [](auto const& f, auto const& mu) { return lie_poisson_update_right(f, mu); });
                  }),
                  2);
      claim.refutes_order("the flow, carried by Ad* of the inverse", group.name(), by_halves.step_lengths(),
                          by_halves.errors_of([&](int n, double h) {
                            return run(n, h,
                                       [](auto const& f, auto const& mu) { return Ad_star(inverse(f), mu); });
                          }),
                          2);
    }
}
