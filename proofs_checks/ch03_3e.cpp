// Section 3.3, fifth part: the reduced discrete Lagrangian through the logarithm, the algorithm on the algebra. Compiled once per scalar.
#include "chart_models.hpp"
#include "actio/variational/euler_poincare.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

/// The discrete Lagrangian printed in (3.25), without the minus: in units of action.
template <class Reduced, class S>
auto printed_chart_lagrangian(Reduced l, S h) {
  return [=](auto const& f) {
    using T = typename std::decay_t<decltype(f)>::Scalar;
    return l(log(f) / T(h)) * T(h);
  };
}
/// A covector times a matrix: \f$\mu\cdot M\f$.
template <class S>
Momentum<SpannedGroup, S> times(Momentum<SpannedGroup, S> const& mu, Matrix<S> const& m) {
  return {mu.group, Vector<S>(m.transpose() * mu.components)};
}

/// \f$\xi(t)\f$ of the right-invariant Euler-Poincare equations by the classical Runge-Kutta method: 400 steps leave an error near \f$10^{-11}\f$.
template <class F>
Algebra<double> velocity_at(F const& l, Algebra<double> xi, double t) {
  int const steps = 400;
  double const h = t / steps;
  auto const rate = [&](Algebra<double> const& x) { return euler_poincare_acceleration_right(l, x); };
  for (int i = 0; i < steps; ++i) {
    auto const a = rate(xi), b = rate(xi + (h / 2) * a), c = rate(xi + (h / 2) * b), d = rate(xi + h * c);
    xi = xi + (h / 6) * (a + 2.0 * b + 2.0 * c + d);
  }
  return xi;
}
/// How far the velocity of the last of n steps over unit time is from the true one half-way through that step. The first step is the true one, up to its own third order.
template <class F, class Discretize>
double error_after_unit_time(F const& l, Discretize const& discretize, Algebra<double> const& xi0, int n) {
  double const h = 1.0 / n;
  auto f = exp(-h * velocity_at(l, xi0, h / 2));
  auto const discrete = discretize(l, h);
  for (int k = 1; k < n; ++k) f = step_euler_poincare_right(discrete, f).value;
  return size_of(-log(f) / h - velocity_at(l, xi0, 1 - h / 2));
}

}  // namespace

STATEMENT(eq_3_25, "reduced discrete Lagrangian through the logarithm") {
  claim.corrected(R"(\ell(f_{kk+1}) = l(\log(f_{kk+1})/\Delta t))", R"(\ell(f_{kk+1}) = l(-\log(f_{kk+1})/\Delta t))",
                  "$f_{kk+1} = g_kg_{k+1}^{-1}$ looks back. The printed form is right where $l$ is even; elsewhere its motions are those of $l(-\\xi)$. The library's carries the factor $h$.");
  claim.degree(chart_degree);
  over_groups(chart_groups<S>(), claim, [&](auto const& group, auto const& model) {
    auto const l = draw_algebra_polynomial<S>(draw, group.dimension());
    auto const g1 = draw.template element<S>(group), g2 = draw_near(draw, g1);
    S const h = step_length<S>();
    auto const f = relative_motion_right(g1, g2);
    auto const scale = size_of_terms(l, Algebra<S>(log(f) / h));
    S const full = discretize_right(right_invariant(l), h, at_second)(g1, g2);
    claim.zero("L(g_k, g_k+1) = h l(-log(f)/h)", model, S(natural_chart_lagrangian_right(l, h)(f) - full), scale);
    claim.zero("left: L(g_k, g_k+1) = h l(-log(f)/h), f = g_k+1^-1 g_k", model,
               S(natural_chart_lagrangian_left(l, h)(relative_motion_left(g1, g2)) - discretize_left(left_invariant(l), h, at_second)(g1, g2)), scale);
    claim.refutes("h l(log(f)/h), as printed", model, S(printed_chart_lagrangian(l, h)(f) - full), scale);
    // An even Lagrangian does not see the sign.
    auto even = l;
    even.b.setZero(), even.kappa = S(0);
    claim.zero("l even: as printed", model, S(printed_chart_lagrangian(even, h)(f) - discretize_right(right_invariant(even), h, at_second)(g1, g2)), scale);
  });
  if constexpr (std::same_as<S, double>)
    for (auto const& group : order_groups()) {
      auto l = draw_algebra_polynomial<S>(draw, group.dimension());
      l.kappa /= 4;
      auto const xi0 = draw.velocity<S>(group, 1.0);
      std::vector<double> steps, errors, printed;
      for (int n : {8, 16, 32, 64, 128, 256}) {
        steps.push_back(1.0 / n);
        errors.push_back(error_after_unit_time(l, [](auto const& k, double h) { return natural_chart_lagrangian_right(k, h); }, xi0, n));
        printed.push_back(error_after_unit_time(l, [](auto const& k, double h) { return printed_chart_lagrangian(k, h); }, xi0, n));
      }
      claim.order("velocities of the discrete motion to those of the Euler-Poincare equations", group.name(), steps, errors, 2);
      claim.refutes_order("with the printed sign", group.name(), steps, printed, 2);
    }
}

STATEMENT(eq_3_26, "implicit algorithm on the Lie algebra through the function chi") {
  claim.corrected(R"(l'(\xi_{kk+1}/\Delta t)\cdot\chi(\mathrm{ad}_{\xi_{kk+1}}) = l'(\xi_{k-1k}/\Delta t)\cdot\chi(\mathrm{ad}_{\xi_{k-1k}})\cdot\exp(\mathrm{ad}_{\xi_{k-1k}}),\quad \chi(\mathrm{ad}_\xi)\cdot\mathrm{iex}(-\mathrm{ad}_\xi) = \mathrm{Id})",
                  R"(l'(-\xi_{kk+1}/\Delta t)\cdot\chi(\mathrm{ad}_{\xi_{kk+1}}) = l'(-\xi_{k-1k}/\Delta t)\cdot\chi(\mathrm{ad}_{\xi_{k-1k}})\cdot\exp(\mathrm{ad}_{\xi_{k-1k}}),\quad \chi(\mathrm{ad}_\xi)\cdot\mathrm{iex}(\mathrm{ad}_\xi) = \mathrm{Id})",
                  "Two slips: the sign of the velocity (3.25) and the sign in $\\chi$. No choice of bracket saves the second, for $\\exp(\\mathrm{ad}_\\xi) = \\mathrm{Ad}_{\\exp\\xi}$ needs the commutator and the printed $\\chi$ its opposite.");
  claim.degree(chart_degree);
  over_groups(chart_groups<S>(), claim, [&](auto const& group, auto const& model) {
    auto const l = draw_algebra_polynomial<S>(draw, group.dimension());
    S const h = step_length<S>();
    auto const xi01 = draw.template velocity<S>(group, ratio<S>(1, 3)), xi12 = draw.template velocity<S>(group, ratio<S>(1, 3));
    auto const f01 = exp(xi01), f12 = exp(xi12);
    auto const full = euler_poincare_right(natural_chart_lagrangian_right(l, h), f01, f12);
    auto const scale = size_of(gradient(l, -xi12 / h)) + size_of(gradient(l, -xi01 / h));
    auto const& at = [&](auto const& sign, Algebra<S> const& xi, Algebra<S> const& along) { return times(gradient(l, S(sign) * xi / h), Matrix<S>(inverse_matrix(Matrix<S>(iex(ad_matrix(along)))))); };
    // Off shell: minus (3.10), whatever the two relative motions; by the library and written out, exp(ad) as Ad.
    claim.zero("(3.26) equals minus (3.10)", model, algebra_euler_poincare_right(l, h, xi01, xi12) + full, scale);
    claim.zero("(3.26) written out, exp(ad) as Ad", model, at(-1, xi12, xi12) - times(at(-1, xi01, xi01), Matrix<S>(Ad_matrix(f01))) + full, scale);
    claim.zero("left: minus (3.11)", model, algebra_euler_poincare_left(l, h, xi01, xi12) + euler_poincare_left(natural_chart_lagrangian_left(l, h), f01, f12), scale);
    // Controls: the printed chi, with the printed exp and with its inverse as the other bracket would have it; the printed velocity; the side of exp.
    claim.refutes("chi as printed", model, at(-1, xi12, -xi12) - times(at(-1, xi01, -xi01), Matrix<S>(Ad_matrix(f01))) + full, scale);
    claim.refutes("the other bracket throughout", model, at(-1, xi12, xi12) - times(at(-1, xi01, xi01), Matrix<S>(Ad_matrix(inverse(f01)))) + full, scale);
    claim.refutes("l'(xi/h), as printed", model, at(1, xi12, xi12) - times(at(1, xi01, xi01), Matrix<S>(Ad_matrix(f01))) + full, scale);
    claim.refutes("exp at the other step", model, times(at(-1, xi12, xi12), Matrix<S>(Ad_matrix(f12))) - at(-1, xi01, xi01) + full, scale);
  });
  if constexpr (Real<S>)
    // Three steps on the algebra and three on the group.
    for (auto const& group : {spanned("SO(3)", SO<3>{}), spanned("Aff(1)", Aff1{})}) {
      auto l = draw_algebra_polynomial<S>(draw, group.dimension());
      l.kappa /= S(4);
      S const h = ratio<S>(1, 8);
      auto xi = draw.template velocity<S>(group, ratio<S>(1, 8));
      auto f = exp(xi);
      for (int k = 0; k < 3; ++k) {
        xi = step_algebra_euler_poincare_right(l, h, xi).value;
        f = step_euler_poincare_right(natural_chart_lagrangian_right(l, h), f).value;
        claim.equal("three steps on the algebra are those on the group", group.name(), exp(xi), f);
      }
    }
}
