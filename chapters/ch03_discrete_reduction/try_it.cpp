// Lines to try of chapter 3: relative motions, the momenta at the two ends of a step, a reduced step and its
// reconstruction, the inverse in (3.18), the sign of iex, and the step in the algebra.
#include "book/try_it.hpp"
#include "actio/numbers/print.hpp"
#include "actio/reduction/algebra_euler_poincare.hpp"
#include "actio/reduction/discrete_lie_poisson.hpp"
#include "actio/reduction/discrete_momentum.hpp"
#include "actio/reduction/natural_chart.hpp"
#include "running_examples.hpp"

using namespace actio;

TRY_IT(relative_motion) {
  auto const turn = [](double x, double y, double z) {
    return exp(velocity(SO<3>{}, Vector<double, 3>(x, y, z)));
  };
  auto const g0 = turn(0.1, 0.2, 0.3), g1 = turn(0.4, 0.1, 0.2), bar = turn(0, 1, 1);
  print("log f01", log(relative_motion_right(g0, g1)));
  print("ball turned beforehand", log(relative_motion_right(g0 * bar, g1 * bar)));
  print("room turned", log(relative_motion_right(bar * g0, bar * g1)));
}

TRY_IT(momenta_of_a_step) {
  auto const l = natural_chart_lagrangian_right(ball_in_field(), 0.1);  // (3.25)
  auto const L = lift_right(l);                                         // on pairs
  auto const g0 = identity<double>(SO<3>{});
  auto const g1 = exp(velocity(SO<3>{}, Vector<double, 3>(0.3, 0, 0.1)));
  auto const f = relative_motion_right(g0, g1);
  print("start, -D1 L", legendre_source(L, g0, g1));
  print("start, -R* l'", momentum_before_right(l, f));
  print("end, D2 L", legendre_target(L, g0, g1));
  print("end, Ad*_f of the start", lie_poisson_update_right(f, momentum_before_right(l, f)));
}

TRY_IT(a_reduced_step) {
  auto const l = natural_chart_lagrangian_right(ball_in_field(), 0.1);
  auto const g0 = exp(velocity(SO<3>{}, Vector<double, 3>(1, 2, 0)));  // any attitude
  auto const f01 = exp(velocity(SO<3>{}, Vector<double, 3>(-0.3, 0, -0.1)));
  auto const f12 = step_euler_poincare_right(l, f01).value;                     // solves (3.10)
  auto const g1 = reconstruct_right(g0, f01), g2 = reconstruct_right(g1, f12);  // (3.14)
  print("log f12", log(f12));
  print("(3.10)", euler_poincare_right(l, f01, f12));
  print("(3.2)", discrete_euler_lagrange(lift_right(l), g0, g1, g2));
}

TRY_IT(the_inverse_in_3_18) {
  auto const l = natural_chart_lagrangian_left(thrown_book(), 0.1);
  auto const f10 = exp(velocity(SO<3>{}, Vector<double, 3>(-0.1, -0.8, -0.3)));
  auto const f21 = step_euler_poincare_left(l, f10).value;  // solves (3.11)
  auto const Pi0 = momentum_before_left(l, f10);
  print("momentum of the next step", momentum_before_left(l, f21));
  print("(3.18)", lie_poisson_update_left(f10, Pi0));
  print("(3.18) as printed", Ad_star(f10, Pi0));
}

TRY_IT(the_sign_of_iex) {
  auto const eta = velocity(SO<3>{}, Vector<double, 3>(0.9, 0, 0)),
             zeta = velocity(SO<3>{}, Vector<double, 3>(0, 1, 0));
  double const e = 1e-6;
  print("moved exponential", log(exp(eta + e * zeta) * exp(-eta)) / e);  // on the right
  print("iex(ad)", (iex(ad_matrix(eta)) * zeta.coordinates).eval());
  print("iex(-ad)", (iex(ad_matrix(-eta)) * zeta.coordinates).eval());
}

TRY_IT(a_step_in_the_algebra) {
  double const h = 0.1;
  auto const xi01 = velocity(SO<3>{}, Vector<double, 3>(-0.3, 0, -0.1));
  auto const xi12 = step_algebra_euler_poincare_right(ball_in_field(), h, xi01).value;
  auto const l = natural_chart_lagrangian_right(ball_in_field(), h);
  print("by (3.26)", xi12);
  print("by (3.10)", log(step_euler_poincare_right(l, exp(xi01)).value));
  auto const slope01 = gradient(ball_in_field(), -xi01 / h);
  auto const slope12 = gradient(ball_in_field(), -xi12 / h);
  auto const exp01 = matrix_exponential(ad_matrix(xi01));
  print("residual, chi as printed",
        composed(slope12, chi(ad_matrix(-xi12))) - composed(slope01, chi(ad_matrix(-xi01)) * exp01));
  print("residual, right chi",
        composed(slope12, chi(ad_matrix(xi12))) - composed(slope01, chi(ad_matrix(xi01)) * exp01));
}

TRY_IT_MAIN("the lines to try of chapter 3")
