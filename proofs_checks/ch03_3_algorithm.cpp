// Section 3.3, last part: the reduced discrete Lagrangian through the logarithm, the algorithm on the
// algebra, and its neighbour by Channell and Scovel.

#include "actio/groupoid/generating_function.hpp"
#include "actio/reduction/algebra_euler_poincare.hpp"
#include "actio/variational/euler_poincare.hpp"

#include "models/chart_models.hpp"
#include "models/enclosures.hpp"
#include "models/limits.hpp"
#include "models/top_in_any_group.hpp"
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

/// \f$\xi(t)\f$ of the right-invariant Euler-Poincare equations by the classical Runge-Kutta method: 400
/// steps for a unit of time leave an error near \f$10^{-11}\f$.
template <class F>
Algebra<Number> velocity_at(F const& l, Algebra<Number> xi, Number const& t) {
  int const steps = 20 + static_cast<int>(380 * to_double(t));
  Number const h = t / steps;
  auto const rate = [&](Algebra<Number> const& x) { return euler_poincare_acceleration_right(l, x); };
  for (int i = 0; i < steps; ++i) {
    auto const a = rate(xi), b = rate(xi + (h / 2) * a), c = rate(xi + (h / 2) * b), d = rate(xi + h * c);
    xi = xi + (h / 6) * (a + Number(2) * b + Number(2) * c + d);
  }
  return xi;
}
/// A ball about each number that a formula gives, value and derivatives: holds what the series of exp and iex
/// leave off in balls of 20 digits and more.
template <class T>
T blurred(T x) {
  if constexpr (is_dual<T>) {
    x.value = blurred(x.value);
    for (auto& p : x.part) p = blurred(p);
    return x;
  } else {
    return x + Number::between(Number(-1e-12), Number(1e-12));
  }
}
/// Exactly one solution of a step of (3.26) among the velocities within 1/4 of the last one, for the step h.
/// @param size  of the last velocity
inline Enclosure one_solution(SpannedGroup const& group, Number const& h, Number const& size) {
  int const d = group.dimension();
  AlgebraPolynomial<Number> l{Matrix<Number>::Identity(d, d), Vector<Number>::Constant(d, Number(1) / 4),
                              Vector<Number>::Constant(d, Number(1) / 2), Number(1) / 8};
  for (int a = 0; a < d; ++a) l.a(a, a) += Number(a) / 2;
  Vector<Number> xi(d);
  for (int a = 0; a < d; ++a) xi[a] = h * size / (a + 2);
  Algebra<Number> const last{group, xi};
  return one_zero_near(
      [&]<class T>(Vector<T> const& next) {
        auto const residual = algebra_euler_poincare_right(l, h, over<T>(last), Algebra<T>{group, next});
        Vector<T> sum = residual.components;
        for (Index a = 0; a < sum.size(); ++a) sum[a] = blurred(T(sum[a]));
        return sum;
      },
      xi, Number(h / 4));
}
/// How far the velocity of the last of n steps over unit time is from the true one half-way through that
/// step. The first step is the true one, up to its own third order.
template <class F, class Discretize>
double error_after_unit_time(F const& l, Discretize const& discretize, Algebra<Number> const& xi0, int n) {
  Number const h = Number(1) / n;
  auto f = exp(-h * velocity_at(l, xi0, h / 2));
  auto const discrete = discretize(l, h);
  for (int k = 1; k < n; ++k) f = step_euler_poincare_right(discrete, f).value;
  return to_double(size_of(-log(f) / h - velocity_at(l, xi0, 1 - h / 2)));
}

}  // namespace

STATEMENT(eq_3_25, "reduced discrete Lagrangian through the logarithm") {
  claim.corrected(R"(\ell(f_{kk+1}) = l(\log(f_{kk+1})/\Delta t))",
                  R"(\ell(f_{kk+1}) = l(-\log(f_{kk+1})/)"
                  R"(\Delta t))",
                  "$f_{kk+1} = g_kg_{k+1}^{-1}$ looks back. The printed form is right where $l$ is even; "
                  "elsewhere its motions are those of $l(-\\xi)$. The library's carries the factor $h$.");
  claim.same_slip_as("eq_3_24");
  over_groups(series_groups<S>(), claim, [&](auto const& group, auto const& model) {
    auto const l = draw_algebra_polynomial<S>(draw, group.dimension());
    auto const g1 = draw.template element<S>(group), g2 = draw_near(draw, g1);
    S const h = step_length<S>();
    auto const f = relative_motion_right(g1, g2);
    auto const scale = size_of_terms(l, Algebra<S>(log(f) / h));
    S const full = discretize_right(right_invariant(l), h, at_second)(g1, g2);
    claim.zero("L(g_k, g_k+1) = h l(-log(f)/h)", model, S(natural_chart_lagrangian_right(l, h)(f) - full),
               scale);
    claim.zero("left: L(g_k, g_k+1) = h l(-log(f)/h), f = g_k+1^-1 g_k", model,
               S(natural_chart_lagrangian_left(l, h)(relative_motion_left(g1, g2)) -
                 discretize_left(left_invariant(l), h, at_second)(g1, g2)),
               scale);
    claim.refutes("h l(log(f)/h), as printed", model, S(printed_chart_lagrangian(l, h)(f) - full), scale);
    // An even Lagrangian does not depend on the sign.
    auto even = l;
    even.b.setZero(), even.kappa = S(0);
    claim.zero("l even: as printed", model,
               S(printed_chart_lagrangian(even, h)(f) -
                 discretize_right(right_invariant(even), h, at_second)(g1, g2)),
               scale);
  });
  if (claim.fits_orders())
    for (auto const& group : order_groups()) {
      auto l = draw_algebra_polynomial<S>(draw, group.dimension());
      l.kappa /= 4;
      auto const xi0 = draw.velocity<S>(group, S(1));
      std::vector<double> steps, errors, printed;
      for (int n : {32, 40, 48, 64, 80, 96}) {
        steps.push_back(1.0 / n);
        errors.push_back(error_after_unit_time(
            l, [](auto const& k, S const& h) { return natural_chart_lagrangian_right(k, h); }, xi0, n));
        printed.push_back(error_after_unit_time(
            l, [](auto const& k, S const& h) { return printed_chart_lagrangian(k, h); }, xi0, n));
      }
      claim.order("velocities of the discrete motion to those of the Euler-Poincare equations", group.name(),
                  steps, errors, 2);
      claim.refutes_order("with the printed sign", group.name(), steps, printed, 2);
    }
}

STATEMENT(eq_3_26, "implicit algorithm on the Lie algebra through the function chi") {
  claim.corrected(
      R"(l'(\xi_{kk+1}/\Delta t)\cdot\chi(\mathrm{ad}_{\xi_{kk+1}}) = l'(\xi_{k-1k}/\Delta t))"
      R"(\cdot\chi(\mathrm{ad}_{\xi_{k-1k}})\cdot\exp(\mathrm{ad}_{\xi_{k-1k}}),\quad \chi(\mathrm{ad}_\xi))"
      R"(\cdot\mathrm{iex}(-\mathrm{ad}_\xi) = \mathrm{Id})",
      R"(l'(-\xi_{kk+1}/\Delta t)\cdot\chi(\mathrm{ad}_{\xi_{kk+1}}) = l'(-\xi_{k-1k}/\Delta t))"
      R"(\cdot\chi(\mathrm{ad}_{\xi_{k-1k}})\cdot\exp(\mathrm{ad}_{\xi_{k-1k}}),\quad \chi()"
      R"(\mathrm{ad}_\xi)\cdot\mathrm{iex}(\mathrm{ad}_\xi) = \mathrm{Id})",
      "Two slips: the sign of the velocity (3.25) and the sign in $\\chi$. No choice of bracket saves the "
      "second, for $\\exp(\\mathrm{ad}_\\xi) = \\mathrm{Ad}_{\\exp\\xi}$ needs the commutator and the "
      "printed $\\chi$ its opposite. The algorithm has order 2, forwards in time; that a step has exactly "
      "one solution near the last is decided in balls for one Lagrangian on each of two groups.");
  claim.same_slip_as("claim_3_3_derivative_of_exponential");
  over_groups(series_groups<S>(), claim, [&](auto const& group, auto const& model) {
    auto const l = draw_algebra_polynomial<S>(draw, group.dimension());
    S const h = step_length<S>();
    auto const xi01 = draw_exponent<S>(draw, group, ratio<S>(1, 3)),
               xi12 = draw_exponent<S>(draw, group, ratio<S>(1, 3));
    auto const f01 = exp(xi01), f12 = exp(xi12);
    auto const full = euler_poincare_right(natural_chart_lagrangian_right(l, h), f01, f12);
    auto const scale = size_of(gradient(l, -xi12 / h)) + size_of(gradient(l, -xi01 / h));
    auto const& at = [&](auto const& sign, Algebra<S> const& xi, Algebra<S> const& along) {
      return times(gradient(l, S(sign) * xi / h),
                   Matrix<S>(inverse_matrix(Matrix<S>(iex(ad_matrix(along))))));
    };
    // Off shell: minus (3.10), whatever the two relative motions; by the library and written out, exp(ad) as
    // Ad.
    claim.zero("(3.26) equals minus (3.10)", model, algebra_euler_poincare_right(l, h, xi01, xi12) + full,
               scale);
    claim.zero("(3.26) written out, exp(ad) as Ad", model,
               at(-1, xi12, xi12) - times(at(-1, xi01, xi01), Matrix<S>(Ad_matrix(f01))) + full, scale);
    claim.zero("left: minus (3.11)", model,
               algebra_euler_poincare_left(l, h, xi01, xi12) +
                   euler_poincare_left(natural_chart_lagrangian_left(l, h), f01, f12),
               scale);
    // Controls: the printed chi, with the printed exp and with its inverse as the other bracket would have
    // it; the printed velocity; the side of exp.
    claim.refutes("chi as printed", model,
                  at(-1, xi12, -xi12) - times(at(-1, xi01, -xi01), Matrix<S>(Ad_matrix(f01))) + full, scale);
    claim.refutes("the other bracket throughout", model,
                  at(-1, xi12, xi12) - times(at(-1, xi01, xi01), Matrix<S>(Ad_matrix(inverse(f01)))) + full,
                  scale);
    claim.refutes("l'(xi/h), as printed", model,
                  at(1, xi12, xi12) - times(at(1, xi01, xi01), Matrix<S>(Ad_matrix(f01))) + full, scale);
    claim.refutes("exp at the other step", model,
                  times(at(-1, xi12, xi12), Matrix<S>(Ad_matrix(f12))) - at(-1, xi01, xi01) + full, scale);
  });
  if (!exact_arithmetic<S>())
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
  if (claim.fits_orders())
    for (auto const& group : order_groups()) {
      auto l = draw_algebra_polynomial<S>(draw, group.dimension());
      l.kappa /= 4;
      auto const xi0 = draw.velocity<S>(group, S(1));
      std::vector<double> steps, errors, reversed;
      for (int n : {32, 40, 48, 64, 80, 96}) {
        S const h = S(1) / n;
        auto const start = -h * velocity_at(l, xi0, h / 2), end = -h * velocity_at(l, xi0, 1 - h / 2);
        auto forwards = start, backwards = start;
        for (int k = 1; k < n; ++k) {
          forwards = step_algebra_euler_poincare_right(l, h, forwards).value;
          // chi and exp of the two steps exchanged: the algorithm of the left-invariant system.
          backwards = step_algebra_euler_poincare_left(l, h, backwards).value;
        }
        steps.push_back(1.0 / n);
        errors.push_back(to_double(size_of((forwards - end) / h)));
        reversed.push_back(to_double(size_of((backwards - end) / h)));
      }
      claim.order("the velocities to those of the Euler-Poincare equations", group.name(), steps, errors, 2);
      claim.refutes_order("exp on the other side: backwards in time", group.name(), steps, reversed, 2);
    }
  for (auto const& group : {spanned("SO(3)", SO<3>{}), spanned("Aff(1)", Aff1{})}) {
    claim.encloses("exactly one solution among the velocities within 1/4 of the last", group.name(),
                   [&] { return one_solution(group, Number(1) / 8, Number(1)); });
    claim.refutes_enclosure("the same for a step 64 times as long", group.name(),
                            [&] { return one_solution(group, Number(8), Number(1)); });
  }
}

STATEMENT(claim_3_3_channell_scovel, "comparison with the Lie-Poisson integrators of Channell and Scovel") {
  claim.convention(
      "Both are (4.2) and (4.3) with a function of the logarithm in the role of $S$. Channell and Scovel "
      "truncate the solution of (4.1) that begins with half of an invariant form; it generates the "
      "identity at time 0 and needs a nondegenerate form. Read here to first and to second order in the "
      "step, the truncation has order 1 and 2. (3.26) needs no form and has order 2.");
  std::vector<SpannedGroup> const quadratic = {spanned("SO(3)", SO<3>{}), spanned("SL(2)", SL2{}),
                                               spanned("SO(4)", SO<4>{})};
  // The trace form of matrices, which is invariant.
  auto const trace_form = [](SpannedGroup const& group) {
    int const d = group.dimension();
    Matrix<S> form(d, d);
    auto const e = [&](int a) { return group.hat(basis_velocity<S>(group, a).coordinates); };
    for (int a = 0; a < d; ++a)
      for (int b = 0; b < d; ++b) form(a, b) = Matrix<S>(e(a) * e(b)).trace();
    return form;
  };
  over_groups(quadratic, claim, [&](auto const& group, auto const& model) {
    Matrix<S> const form = trace_form(group);
    auto const x = draw.template velocity<S>(group);
    Momentum<SpannedGroup, S> const mu{group, Vector<S>(form * x.coordinates)};
    auto const size = S(size_of(x) * size_of(mu) * Base<S>(group.dimension()));
    claim.zero("the form is invariant: ad* of x takes the covector of x to zero", model, ad_star(x, mu),
               size);
    Matrix<S> const other = draw_algebra_polynomial<S>(draw, group.dimension()).a;
    claim.refutes("a form that is not invariant", model,
                  ad_star(x, Momentum<SpannedGroup, S>{group, Vector<S>(other * x.coordinates)}), size);
  });
  if (!exact_arithmetic<S>())
    over_groups(quadratic, claim, [&](auto const& group, auto const& model) {
      // Half of the form, of the logarithm: the covectors at both ends are the same.
      Matrix<S> const form = trace_form(group), other = draw_algebra_polynomial<S>(draw, group.dimension()).a;
      auto const half = [&](Matrix<S> const& b) {
        return [b](auto const& f) {
          using T = typename std::decay_t<decltype(f)>::Scalar;
          Vector<T> const y = log(f).coordinates;
          return T(-y.dot(b.template cast<T>() * y) / T(2));
        };
      };
      auto const f = draw_small<S>(draw, group);
      // Condition: the logarithm is differentiated.
      claim.equal("half of the form generates the identity", model, left_differential(half(form), f),
                  right_differential(half(form), f), 10);
      claim.differs("half of another form", model, left_differential(half(other), f),
                    right_differential(half(other), f));
    });
  if (claim.fits_orders())
    for (auto const& group : {quadratic[0], quadratic[1]}) {
      auto const top = draw_top_without_weight<S>(draw, group);
      QuadraticLagrangian<SpannedGroup, S> const l(group, top.a, top.b);
      Matrix<S> const form = trace_form(group), back = inverse_matrix(form);
      State<SpannedGroup, S> const v{identity<S>(group), draw.template velocity<S>(group, ratio<S>(1, 2))};
      Refinement const steps{0.5, {32, 48, 64, 96, 128, 192}};
      auto const exact = l.momentum_of(top.flow(v, S(steps.duration)).first.velocity);
      Refinement const fewer{0.5, {16, 24, 32, 48, 64, 96}};
      // S = -<x, x>/2 - sign t h(x) with the covector of x, the logarithm of the relative motion; and, by
      // (4.1) once more, t^2/2 times minus <xi, iex(ad_x)^-1 xi> with the velocity xi = dh.
      auto const truncated = [&](Refinement const& refined, double sign, double second) {
        return refined.errors_of([&](int n, double h) {
          auto const s = [&](auto const& f) {
            using T = typename std::decay_t<decltype(f)>::Scalar;
            Vector<T> const x = log(f).coordinates, covector = form.template cast<T>() * x;
            Momentum<SpannedGroup, T> const mu{group, covector};
            T const first = -x.dot(covector) / T(2) - l(mu) * T(S(sign * h));
            if (second == 0) return first;
            Vector<T> const xi = l.velocity_of(mu).coordinates, pulled = form.template cast<T>() * xi,
                            along = solve_linear(Matrix<T>(iex(ad_matrix(Algebra<T>{group, x}))), xi);
            return T(first - pulled.dot(along) * T(S(second * h * h / 2)));
          };
          auto mu = l.momentum_of(v.velocity);
          for (int k = 0; k < n; ++k)
            mu = hamilton_jacobi_step_right(s, mu, exp(Algebra<S>{group, Vector<S>(back * mu.components)}))
                     .final;
          return size_of(mu - exact);
        });
      };
      auto const natural = steps.errors_of([&](int n, double h) {
        auto mu = l.momentum_of(v.velocity);
        auto f = exp(S(-h) * v.velocity);
        for (int k = 0; k < n; ++k) {
          auto const step = hamilton_jacobi_step_right(natural_chart_lagrangian_right(l, h), mu, f);
          f = step.g, mu = step.final;
        }
        return size_of(mu - exact);
      });
      auto const lengths = steps.step_lengths();
      claim.order("Channell and Scovel, to first order: the flow", group.name(), lengths,
                  truncated(steps, 1, 0), 1);
      claim.order("Channell and Scovel, to second order: the flow", group.name(), fewer.step_lengths(),
                  truncated(fewer, 1, 1), 2);
      claim.order("(3.26): the flow", group.name(), lengths, natural, 2);
      claim.refutes_order("Channell and Scovel with the sign of h flipped", group.name(), lengths,
                          truncated(steps, -1, 0), 1);
      claim.refutes_order("with the sign of the second term flipped", group.name(), fewer.step_lengths(),
                          truncated(fewer, 1, -1), 2);
    }
}
