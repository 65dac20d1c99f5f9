// Section 3.3, third part: velocities in a chart, the differential of the exponential, the discrete Lagrangian with its push-forward carried out. Compiled once per scalar.
#include "chart_models.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

/// The differential of log read on \f$e^\vartheta f\f$, by dual numbers, one direction at a time.
template <class S>
Vector<S> logarithm_rate(Place<S> const& f, Algebra<S> const& theta) {
  return rate_part<S>(log(moving_along(theta) * over<Dual<S>>(f)).coordinates);
}

}  // namespace

STATEMENT(claim_3_3_velocity_element, "group velocity approximated by the chart difference quotient") {
  claim.corrected(R"(\zeta\approx g^{-1}\dot g)", R"(\zeta\approx\dot g\,g^{-1})", "In the chart by right translation the difference quotient is the velocity carried to the identity on the right; $g^{-1}\\dot g$ belongs to the chart by left translation.");
  claim.degree(chart_degree);
  over_groups(chart_groups<S>(), claim, [&](auto const& group, auto const& model) {
    auto const xi = draw.template velocity<S>(group, ratio<S>(1, 2));
    auto const g1 = draw.template element<S>(group, S(1));
    S const h = step_length<S>();
    // Along g(t) = exp(t xi) g1 the velocity is xi throughout, and the quotient is exact.
    auto const g2 = exp(h * xi) * g1;
    auto const velocity = state_of(moving_along(xi) * over<Dual<S>>(g1));
    auto const zeta = chart_midpoint_right(g2, g1, g2, h).zeta;
    claim.equal("zeta = g' g^-1 along a one-parameter group", model, zeta, velocity.velocity);
    claim.equal("left chart: zeta = g^-1 g'", model, chart_midpoint_left(g2, g1, g2, h).zeta, body_velocity(velocity));
    claim.differs("zeta = g^-1 g', as printed", model, zeta, body_velocity(velocity));
  });
  if constexpr (std::same_as<S, double>)
    for (auto const& group : order_groups()) {
      auto const curve = draw_curve<S>(draw, group);
      std::vector<double> errors, printed;
      for (double h : halving_steps()) {
        auto const g1 = curve(S(0)), g2 = curve(h);
        auto const middle = state_of(curve(moving(S(h / 2))));
        auto const zeta = chart_midpoint_right(g2, g1, g2, h).zeta;
        errors.push_back(size_of(zeta - middle.velocity)), printed.push_back(size_of(zeta - body_velocity(middle)));
      }
      claim.order("zeta - g' g^-1 half-way along a curve", group.name(), halving_steps(), errors, 2);
      claim.refutes_order("zeta - g^-1 g'", group.name(), halving_steps(), printed, 2);
    }
}

STATEMENT(claim_3_3_derivative_of_exponential, "derivative of the exponential map in terms of iex") {
  claim.corrected(R"(T_\eta\exp = T_eR_{g'}\cdot\mathrm{iex}(-\mathrm{ad}_\eta))", R"(T_\eta\exp = T_eR_{g'}\cdot\mathrm{iex}(\mathrm{ad}_\eta) = T_eL_{g'}\cdot\mathrm{iex}(-\mathrm{ad}_\eta))",
                  "With $\\mathrm{ad}_\\eta\\zeta = \\eta\\zeta - \\zeta\\eta$, for which $\\mathrm{Ad}_{\\exp\\eta} = \\exp(\\mathrm{ad}_\\eta)$ as (3.26) has it, the minus sign goes with left translation. The printed form takes the bracket of right-invariant vector fields.");
  claim.degree(chart_degree);
  over_groups(chart_groups<S>(), claim, [&](auto const& group, auto const& model) {
    auto const eta = draw.template velocity<S>(group), zeta = draw.template velocity<S>(group);
    auto const moving_place = exp(moving(eta, zeta));
    auto const state = state_of(moving_place);
    auto const through = [&](Algebra<S> const& along) { return Algebra<S>{group, Vector<S>(iex(ad_matrix(along)) * zeta.coordinates)}; };
    claim.equal("on the right: iex(ad)", model, state.velocity, through(eta));
    claim.equal("on the left: iex(-ad)", model, body_velocity(state), through(-eta));
    // Control: the printed sign. (One part in a thousand and more: commutators are of second order.)
    claim.differs("on the right: iex(-ad), as printed", model, state.velocity, through(-eta));
    // Without any formula: to fourth order in w = ad, 1 + w/2 + w^2/6 + w^3/24, which over the rationals is all of it.
    if constexpr (is_exact<S>) {
      auto const w = ad_matrix(eta);
      Vector<S> const wz = w * zeta.coordinates, wwz = w * wz, wwwz = w * wwz;
      claim.equal("zeta + [eta,zeta]/2 + [eta,[eta,zeta]]/6 + [eta,[eta,[eta,zeta]]]/24", model, state.velocity.coordinates, Vector<S>(zeta.coordinates + wz / S(2) + wwz / S(6) + wwwz / S(24)));
    }
  });
}

STATEMENT(eq_3_21, "power series of the function iex") {
  claim.holds();
  claim.degree(20);  // five matrices of degree 1 in what was drawn, in products of four at most
  over_groups(is_exact<S> ? std::vector{unitriangular(5)} : std::vector{unitriangular(5), spanned("SO(3)", SO<3>{}), spanned("GL(2)", GL<2>{}), spanned("SE(3)", SE<3>{})}, claim,
              [&](auto const& group, auto const& model) {
    Matrix<S> const w = group.hat(draw.template velocity<S>(group, S(2)).coordinates), one = Matrix<S>::Identity(w.rows(), w.cols());
    // e^{sw} and the series, summed from their terms until these vanish beside rounding.
    int const terms = is_exact<S> ? 6 : 40 + static_cast<int>(std::numeric_limits<Base<S>>::digits10);
    auto const sum = [&](S const& s, int shift) {
      Matrix<S> total = Matrix<S>::Zero(w.rows(), w.cols()), term = one;
      for (int n = 0; n < terms; ++n) {
        total += term;
        term = (term * w * (s / S(n + 1 + shift))).eval();
      }
      return total;
    };
    Matrix<S> const series = sum(S(1), 1), value = iex(w);
    claim.equal("iex(w) = sum w^n/(n+1)!", model, value, series);
    claim.equal("w iex(w) = e^w - 1", model, Matrix<S>(w * value), Matrix<S>(sum(S(1), 0) - one));
    claim.equal("iex(2w) = iex(w) (e^w + 1)/2", model, Matrix<S>(iex(w) * (sum(S(1), 0) + one) / S(2)), iex(Matrix<S>(w * S(2))));
    if constexpr (is_exact<S>) {
      // The average of e^{sw} over 0 <= s <= 1, by Boole's rule: exact up to degree 5.
      Matrix<S> const average = (sum(S(0), 0) * S(7) + sum(ratio<S>(1, 4), 0) * S(32) + sum(ratio<S>(1, 2), 0) * S(12) + sum(ratio<S>(3, 4), 0) * S(32) + sum(S(1), 0) * S(7)) / S(90);
      claim.equal("iex(w) is the average of e^{sw}", model, value, average);
    }
    claim.differs("n! in place of (n+1)!", model, value, sum(S(1), 0));
    claim.differs("iex(-w)", model, iex(Matrix<S>(-w)), value);
  });
}

STATEMENT(eq_3_22, "chart-based discrete Lagrangian with push-forward carried out") {
  claim.corrected(R"(\mathbb L(g_1,g_2) = L\bigl(q,\,T_eR_q\cdot\mathrm{iex}(-\mathrm{ad}_\eta)\zeta\bigr))", R"(\mathbb L(g_1,g_2) = L\bigl(q,\,T_eR_q\cdot\mathrm{iex}(\mathrm{ad}_\eta)\zeta\bigr) = L\bigl(q,\,T_eL_q\cdot\mathrm{iex}(-\mathrm{ad}_{\eta'})\zeta'\bigr))",
                  "The sign is that of the differential of exp; the minus goes with the charts by left translation ($\\eta', \\zeta'$), whose discrete Lagrangian is the same. The library's carries the factor $h$.");
  claim.degree(chart_degree);
  over_groups(chart_groups<S>(), claim, [&](auto const& group, auto const& model) {
    auto const lagrangian = draw_state_polynomial<S>(draw, group);
    auto const g1 = draw.template element<S>(group), g2 = draw_near(draw, g1), g = draw_near(draw, g1);
    S const h = step_length<S>();
    auto const m = chart_midpoint_right(g, g1, g2, h), left = chart_midpoint_left(g, g1, g2, h);
    auto const q = exp(m.eta) * g;
    auto const at_q = [&](Vector<S> const& velocity) { return lagrangian(State<SpannedGroup, S>{q, {group, velocity}}); };

    // (3.20) with dual numbers on one side, (3.22) written out on the other.
    S const whole = lagrangian(push_forward(g, m.eta, m.zeta));
    claim.equal("(3.20) = L(q, iex(ad) zeta)", model, at_q(iex(ad_matrix(m.eta)) * m.zeta.coordinates), whole);
    claim.equal("left charts: (3.20) = L(q', iex(-ad) zeta'), carried from the left", model,
                lagrangian(State<SpannedGroup, S>{g * exp(left.eta), Ad(g * exp(left.eta), Algebra<S>{group, iex(ad_matrix(-left.eta)) * left.zeta.coordinates})}), whole);
    claim.equal("the library's, right charts", model, discretize_right(lagrangian, h, staying_at(g))(g1, g2), h * whole);
    claim.equal("the library's, left charts", model, discretize_left(lagrangian, h, staying_at(g))(g1, g2), h * whole);
    claim.differs("iex(-ad) zeta, as printed: the velocity that L is given", model, Vector<S>(iex(ad_matrix(-m.eta)) * m.zeta.coordinates), push_forward(g, m.eta, m.zeta).velocity.coordinates);
  });
}

STATEMENT(claim_3_3_fibre_element_limit, "limit of the fibre element as the time step vanishes") {
  claim.convention("The fibre element tends to $\\dot g g^{-1}$, and to $\\dot g$ once it is carried to $q$ on the right. With $\\mathrm{iex}(\\mathrm{ad}_\\eta)$ it does so at every base point; with the printed sign only where the base point tends to the same place.");
  claim.degree(chart_degree);
  over_groups(chart_groups<S>(), claim, [&](auto const& group, auto const& model) {
    // The limit itself is a derivative: average and difference quotient tend to psi_g(c) and its rate of change.
    auto const xi = draw.template velocity<S>(group);
    auto const c = draw.template element<S>(group), g = draw.template element<S>(group) * c;
    auto const chart = natural_chart_right(over<Dual<S>>(g), moving_along(xi) * over<Dual<S>>(c));
    ChartMidpoint<SpannedGroup, S> const limit{{group, Vector<S>(value_part<S>(chart.coordinates))}, {group, Vector<S>(rate_part<S>(chart.coordinates))}};
    claim.equal("iex(ad) d/dt psi_g(c(t)) = c' c^-1", model, fibre_element_right(limit), xi);
    claim.differs("with iex(-ad), as printed, at a base point off the curve", model, iex(ad_matrix(-limit.eta)) * limit.zeta.coordinates, xi.coordinates);
  });
  if constexpr (std::same_as<S, double>)
    for (auto const& group : order_groups()) {
      auto const curve = draw_curve<S>(draw, group);
      auto const start = state_of(curve(moving(S(0))));
      auto const g = draw_near(draw, curve.g0);
      std::vector<double> at_end, beside, half_way, printed;
      for (double h : halving_steps()) {
        auto const g1 = curve(S(0)), g2 = curve(h);
        auto const m = chart_midpoint_right(g, g1, g2, h);
        at_end.push_back(size_of(fibre_element_right(chart_midpoint_right(g1, g1, g2, h)) - start.velocity));
        beside.push_back(size_of(fibre_element_right(m) - start.velocity));
        half_way.push_back(size_of(fibre_element_right(m) - state_of(curve(moving(S(h / 2)))).velocity));
        printed.push_back(size_of(Vector<S>(iex(ad_matrix(-m.eta)) * m.zeta.coordinates - start.velocity.coordinates)));
      }
      claim.order("to the velocity at the earlier place, base point there", group.name(), halving_steps(), at_end, 1);
      claim.order("the same, base point off the curve", group.name(), halving_steps(), beside, 1);
      claim.order("to the velocity half-way", group.name(), halving_steps(), half_way, 2);
      claim.refutes_order("with iex(-ad), base point off the curve", group.name(), halving_steps(), printed, 1);
    }
}

STATEMENT(claim_3_3_chi_function, "function chi and the derivative of the logarithm") {
  claim.corrected(R"(\chi(\mathrm{ad}_\xi)\cdot\mathrm{iex}(-\mathrm{ad}_\xi) = \mathrm{Id})", R"(\chi(\mathrm{ad}_\xi)\cdot\mathrm{iex}(\mathrm{ad}_\xi) = \mathrm{Id})",
                  "As the derivative of log that enters (3.26), read on $e^\\vartheta f$. The printed one is the derivative read on $f e^\\vartheta$.");
  claim.degree(chart_degree);
  over_groups(chart_groups<S>(), claim, [&](auto const& group, auto const& model) {
    auto const xi = draw.template velocity<S>(group, ratio<S>(1, 2)), theta = draw.template velocity<S>(group);
    auto const w = ad_matrix(xi);
    auto const of = [&](Matrix<S> const& m) { return Algebra<S>{group, Vector<S>(chi(m) * theta.coordinates)}; };
    claim.equal("chi(ad) iex(ad) = 1", model, Matrix<S>(chi(w) * iex(w)), Matrix<S>(Matrix<S>::Identity(w.rows(), w.cols())));
    // The derivative of log undoes that of exp: exp(xi + eps chi theta) moves along theta, on the right or on the left.
    claim.equal("exp(xi + eps chi(ad) theta) = exp(eps theta) exp(xi)", model, state_of(exp(moving(xi, of(w)))).velocity, theta);
    claim.equal("exp(xi + eps chi(-ad) theta) = exp(xi) exp(eps theta)", model, body_velocity(state_of(exp(moving(xi, of(-w))))), theta);
    claim.equal("log(exp(eps theta) f) = log f + eps chi(ad) theta", model, logarithm_rate(exp(xi), theta), of(w).coordinates);
    claim.differs("chi(-ad), as printed", model, of(-w).coordinates, logarithm_rate(exp(xi), theta));
    if constexpr (is_exact<S>) {
      // The series of Bernoulli numbers, all of it: ad^4 = 0 on these groups.
      Matrix<S> const one = Matrix<S>::Identity(w.rows(), w.cols()), square = w * w;
      claim.equal("chi(w) = 1 - w/2 + w^2/12", model, Matrix<S>(chi(w)), Matrix<S>(one - w / S(2) + square / S(12)));
    }
  });
  if constexpr (Real<S>) {
    // The logarithm of a rotation in closed form, differentiated, knows nothing of iex.
    SO<3> const group;
    for (int point = 0; point < exact_points; ++point) {
      auto const xi = draw.template velocity<S>(group), theta = draw.template velocity<S>(group);
      Coordinates<SO<3>, Dual<S>> along = Coordinates<SO<3>, Dual<S>>::Zero();
      for (int a = 0; a < 3; ++a) along[a].part[0] = theta.coordinates[a];
      auto const rate = log(retract(Velocity<SO<3>, Dual<S>>{group, along}) * over<Dual<S>>(exp(xi))).coordinates;
      Coordinates<SO<3>, S> by_duals;
      for (int a = 0; a < 3; ++a) by_duals[a] = rate[a].part[0];
      claim.equal("closed form of the logarithm", "SO(3)", Vector<S>(by_duals), Vector<S>(chi(ad_matrix(xi)) * theta.coordinates));
    }
  }
}
