// Section 3.3, fourth part: invariance and reduction of chart-based discrete Lagrangians, the chart centred at an end. Compiled once per scalar.
#include "chart_models.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

/// A Lagrangian that shows the place at which it is evaluated.
template <class S>
struct PlaceFunction {
  Matrix<S> w;
  template <class T>
  T operator()(State<SpannedGroup, T> const& state) const {
    return contract(w, state.place.value);
  }
};
/// The first term by which \f$h\,\mathrm{iex}(\mathrm{ad}_\eta)\zeta\f$ differs from \f$\log(g_2g_1^{-1})\f$: \f$[d,[d,[x_1,x_2]]]/96\f$ with \f$x_i = \psi_g(g_i)\f$, \f$d = x_2-x_1\f$.
template <class S>
Algebra<S> base_point_term(Place<S> const& g, Place<S> const& g1, Place<S> const& g2) {
  auto const x1 = natural_chart_right(g, g1), x2 = natural_chart_right(g, g2), d = x2 - x1;
  return bracket(d, bracket(d, bracket(x1, x2))) / S(96);
}

}  // namespace

STATEMENT(lem_3_3_1, "invariance of the chart-based discrete Lagrangian under the diagonal action") {
  claim.convention("The base point of the chart moves along with the places, as the proof has it; with a base point that stays, the invariance is lost. Charts of either side serve either invariance.");
  claim.degree(chart_degree);
  over_groups(chart_groups<S>(), claim, [&](auto const& group, auto const& model) {
    auto const l = draw_algebra_polynomial<S>(draw, group.dimension());
    auto const g1 = draw.template element<S>(group), g2 = draw_near(draw, g1), k = draw.template element<S>(group), c = draw_small<S>(draw, group);
    S const h = step_length<S>();

    auto const base = beside_right(c);
    auto const right = discretize_right(right_invariant(l), h, base);
    auto const right_scale = size_of_terms(l, fibre_element_right(chart_midpoint_right(base(g1, g2), g1, g2, h)));
    claim.zero("right: L(g1 k, g2 k) = L(g1, g2)", model, S(right(g1 * k, g2 * k) - right(g1, g2)), right_scale);

    auto const left_base = beside_left(c);
    auto const left = discretize_left(left_invariant(l), h, left_base);
    auto const left_scale = size_of_terms(l, fibre_element_left(chart_midpoint_left(left_base(g1, g2), g1, g2, h)));
    claim.zero("left: L(k g1, k g2) = L(g1, g2)", model, S(left(k * g1, k * g2) - left(g1, g2)), left_scale);
    claim.zero("the same by right charts: L(k g1, k g2) = L(g1, g2)", model, S(discretize_right(left_invariant(l), h, left_base)(k * g1, k * g2) - left(g1, g2)), left_scale);

    // Controls: a Lagrangian with no invariance, the wrong side, and a base point that stays.
    auto const any = draw_state_polynomial<S>(draw, group);
    claim.refutes("Lagrangian without the invariance", model, S(discretize_right(any, h, base)(g1 * k, g2 * k) - discretize_right(any, h, base)(g1, g2)), size_of_terms(any.kinetic, Algebra<S>(log(g1 * inverse(g2)) / h)));
    auto const seen = [&](Place<S> const& g, Place<S> const& a, Place<S> const& b) { return fibre_element_right(chart_midpoint_right(g, a, b, h)); };
    claim.differs("moved on the wrong side: the velocity that a right-invariant L sees", model, seen(k * base(g1, g2), k * g1, k * g2), seen(base(g1, g2), g1, g2));
    auto const fixed = Place<S>(c * g2);
    auto const lost = base_point_term(fixed, g1, g2);
    if (size_of(lost) > ratio<Base<S>>(1, 1000000))
      claim.refutes("base point that stays: change of the velocity that L sees, beside the first term that this adds", model, seen(fixed, g1 * k, g2 * k) - seen(fixed, g1, g2), size_of(lost / h));
  });
}

STATEMENT(cor_3_3_1, "reduced discrete Lagrangian in terms of the continuous reduced one") {
  claim.corrected(R"(\ell(g_1g_2^{-1}) = l(\mathrm{iex}(-\mathrm{ad}_\eta)\zeta))", R"(\ell(g_1g_2^{-1}) = l(\mathrm{iex}(\mathrm{ad}_\eta)\zeta))",
                  "The reduction holds where the base point moves along; the sign is that of (3.22). The library's carries the factor $h$.");
  claim.degree(chart_degree);
  over_groups(chart_groups<S>(), claim, [&](auto const& group, auto const& model) {
    // l from L by translation to the identity.
    auto const lagrangian = right_invariant(draw_algebra_polynomial<S>(draw, group.dimension()));
    auto const terms = draw_algebra_polynomial<S>(draw, group.dimension());
    auto const l = [&](auto const& xi) { return lagrangian(State{identity<typename std::decay_t<decltype(xi)>::Scalar>(xi.group), xi}); };
    auto const g1 = draw.template element<S>(group), g2 = draw_near(draw, g1), c = draw_small<S>(draw, group);
    S const h = step_length<S>();
    for (auto const& [name, base] : {std::pair{std::string("base point c g2"), beside_right(c)}, {"base point g2", beside_right(identity<S>(group))}}) {
      auto const full = discretize_right(lagrangian, h, base);
      auto const scale = size_of_terms(terms, fibre_element_right(chart_midpoint_right(base(g1, g2), g1, g2, h)));
      claim.zero("l(g1 g2^-1) = L(g1, g2), " + name, model, S(lift_right(natural_chart_lagrangian_right(l, h, base))(g1, g2) - full(g1, g2)), scale);
    }
    // Controls: the printed sign, and a base point that stays.
    auto const base = beside_right(c);
    auto const m = chart_midpoint_right(base(g1, g2), g1, g2, h);
    claim.differs("iex(-ad) zeta, as printed: the velocity that l is given", model, Vector<S>(iex(ad_matrix(-m.eta)) * m.zeta.coordinates), fibre_element_right(m).coordinates);
    auto const lost = base_point_term(c, g1, g2);
    if (size_of(lost) > ratio<Base<S>>(1, 1000000))
      claim.refutes("base point that stays: change of the velocity, beside the first term that this adds", model, fibre_element_right(chart_midpoint_right(c, g1, g2, h)) - fibre_element_right(m), size_of(lost / h));
  });
}

STATEMENT(eq_3_23, "reduced discrete Lagrangian through iex") {
  claim.corrected(R"(\ell(g_1g_2^{-1}) = l(\mathrm{iex}(-\mathrm{ad}_\eta)\zeta))", R"(\ell(g_1g_2^{-1}) = l(\mathrm{iex}(\mathrm{ad}_\eta)\zeta))",
                  "The minus sign goes with charts by left translation, where $l$ is a function of $g^{-1}\\dot g$. The library's carries the factor $h$.");
  claim.degree(chart_degree);
  auto groups = chart_groups<S>();
  if constexpr (Real<S>) groups.push_back(unitriangular(5));
  over_groups(groups, claim, [&](auto const& group, auto const& model) {
    auto const l = draw_algebra_polynomial<S>(draw, group.dimension());
    auto const g1 = draw.template element<S>(group), g2 = draw_near(draw, g1), c = draw_small<S>(draw, group);
    S const h = step_length<S>();
    auto const g = Place<S>(c * g2);
    auto const m = chart_midpoint_right(g, g1, g2, h);
    // The velocity by dual numbers; the library's function of the relative motion alone.
    auto const state = push_forward(g, m.eta, m.zeta);
    auto const scale = size_of_terms(l, state.velocity);
    S const reduced = natural_chart_lagrangian_right(l, h, beside_right(c))(g1 * inverse(g2));
    claim.zero("h l(velocity at the average) = l(g1 g2^-1)", model, S(h * l(state.velocity) - reduced), scale);
    claim.zero("h l(iex(ad) zeta) = l(g1 g2^-1)", model, S(h * l(Algebra<S>{group, Vector<S>(iex(ad_matrix(m.eta)) * m.zeta.coordinates)}) - reduced), scale);
    claim.differs("iex(-ad) zeta, as printed: the velocity that l is given", model, Vector<S>(iex(ad_matrix(-m.eta)) * m.zeta.coordinates), state.velocity.coordinates);

    // What a base point beside the way changes: nothing up to third order, and at fourth a term that the logarithm has not.
    if (model == "UT(5)") {
      auto const at_end = -log(g1 * inverse(g2)) / h;
      claim.zero("all that the base point changes on UT(5): [d,[d,[x1,x2]]]/96", model, state.velocity - at_end - base_point_term(g, g1, g2) / h, size_of(state.velocity));
      claim.refutes("as if it changed nothing", model, state.velocity - at_end, size_of(base_point_term(g, g1, g2) / h));
    }
    // Left charts.
    auto const n = chart_midpoint_left(g2 * c, g1, g2, h);
    auto const q = (g2 * c) * exp(n.eta);
    auto const body = body_velocity(state_of(over<Dual<S>>(g2 * c) * exp(moving(n.eta, n.zeta))));
    claim.zero("left: h l(body velocity at the average) = l(g2^-1 g1)", model, S(h * l(body) - natural_chart_lagrangian_left(l, h, beside_left(c))(inverse(g2) * g1)), size_of_terms(l, body));
  });
}

STATEMENT(claim_3_3_fibre_element_commutes, "chart centred at one of the two points: bracket of average and difference elements") {
  claim.holds("The same at every point of the curve $e^{t\\xi}g_k$ from one place to the other.");
  claim.degree(chart_degree);
  over_groups(chart_groups<S>(), claim, [&](auto const& group, auto const& model) {
    auto const g1 = draw.template element<S>(group), g2 = draw_near(draw, g1);
    S const h = step_length<S>();
    auto const try_at = [&](std::string const& name, Place<S> const& g) {
      auto const m = chart_midpoint_right(g, g1, g2, h);
      claim.zero("[zeta, eta] = 0, " + name, model, bracket(m.zeta, m.eta), size_of(m.zeta) * size_of(natural_chart_right(g1, g2)));
      claim.equal("iex(-ad) zeta = zeta, " + name, model, Vector<S>(iex(ad_matrix(-m.eta)) * m.zeta.coordinates), m.zeta.coordinates);
    };
    try_at("base point g_k", at_first(g1, g2));
    try_at("base point g_k+1", at_second(g1, g2));
    try_at("base point a third of the way", at_fraction(ratio<S>(1, 3))(g1, g2));
    // Control: a base point beside the way.
    auto const m = chart_midpoint_right(Place<S>(draw.template element<S>(group) * g2), g1, g2, h);
    claim.refutes("[zeta, eta], base point beside the way", model, bracket(m.zeta, m.eta), size_of(m.zeta) * size_of(m.eta));
  });
}

STATEMENT(eq_3_24, "discrete Lagrangian for the chart centred at the second point") {
  claim.convention("With $q = e^\\eta g_{k+1}$ and $\\zeta$ of the opposite sign, as corrected where they are defined. The chart at $g_k$ gives the same; the library's carries the factor $h$.");
  claim.degree(chart_degree);
  over_groups(chart_groups<S>(), claim, [&](auto const& group, auto const& model) {
    auto const lagrangian = draw_state_polynomial<S>(draw, group);
    auto const g1 = draw.template element<S>(group), g2 = draw_near(draw, g1);
    S const h = step_length<S>();
    auto const logarithm = log(g1 * inverse(g2));
    auto const zeta = -logarithm / h;
    auto const q = exp(logarithm / S(2)) * g2;
    S const value = h * lagrangian(State<SpannedGroup, S>{q, zeta});
    auto const scale = size_of_terms(lagrangian.kinetic, zeta);
    claim.zero("chart at g_k+1: L(q, zeta)", model, S(discretize_right(lagrangian, h, at_second)(g1, g2) - value), scale);
    claim.zero("chart at g_k: the same", model, S(discretize_right(lagrangian, h, at_first)(g1, g2) - value), scale);
    claim.zero("chart a third of the way: the same", model, S(discretize_right(lagrangian, h, at_fraction(ratio<S>(1, 3)))(g1, g2) - value), scale);
    // Controls: q and zeta as printed, one at a time.
    claim.refutes("zeta as printed", model, S(h * lagrangian(State<SpannedGroup, S>{q, -zeta}) - value), scale);
    claim.refutes("q as printed", model, S(h * lagrangian(State<SpannedGroup, S>{exp(log(g1 * g2) / S(2)), zeta}) - value), scale, 1e-5);  // one number, small by chance
  });
}

STATEMENT(claim_3_3_midpoint_eta, "average algebra element eta for the chart at the second point") {
  claim.holds();
  claim.degree(chart_degree);
  over_groups(chart_groups<S>(), claim, [&](auto const& group, auto const& model) {
    auto const g1 = draw.template element<S>(group, S(1)), g2 = draw_near(draw, g1);
    auto const eta = chart_midpoint_right(at_second(g1, g2), g1, g2, step_length<S>()).eta;
    claim.equal("eta = log(g_k g_k+1^-1)/2", model, eta, log(g1 * inverse(g2)) / S(2));
    claim.equal("exp(eta)^2 g_k+1 = g_k", model, exp(eta) * exp(eta) * g2, g1);
    claim.differs("log(g_k+1^-1 g_k)/2", model, eta, log(inverse(g2) * g1) / S(2));
  });
}

STATEMENT(claim_3_3_midpoint_q, "base point q for the chart at the second point") {
  claim.corrected(R"(q = \psi_{g_{k+1}}(\eta) = (g_kg_{k+1})^{1/2})", R"(q = \psi_{g_{k+1}}^{-1}(\eta) = (g_kg_{k+1}^{-1})^{1/2}g_{k+1})",
                  "The inverse of the chart takes $\\eta$ to the place half-way along $e^{t\\xi}g_k$. The printed root of the product is that place only where the two places commute, and does not move along with them.");
  claim.maybe_scan();
  claim.degree(chart_degree);
  over_groups(chart_groups<S>(), claim, [&](auto const& group, auto const& model) {
    auto const g1 = draw.template element<S>(group), g2 = draw_near(draw, g1);
    auto const q = exp(log(g1 * inverse(g2)) / S(2)) * g2;
    S const h = step_length<S>();
    claim.equal("psi_{g_k+1}(q) = eta", model, natural_chart_right(g2, q), chart_midpoint_right(g2, g1, g2, h).eta);
    claim.equal("(q g_k+1^-1)^2 = g_k g_k+1^-1", model, q * inverse(g2) * q * inverse(g2), g1 * inverse(g2));
    claim.equal("as far from g_k as from g_k+1", model, natural_chart_right(g1, q), -natural_chart_right(g2, q));
    // The place that the library's discrete Lagrangian sees.
    PlaceFunction<S> const place{draw_matrix<S>(draw, group.matrix_size(), group.matrix_size())};
    claim.zero("the place at which (3.24) evaluates L", model, S(discretize_right(place, h, at_second)(g1, g2) - h * contract(place.w, q.value)), size_of(q));
    // Control: the printed root of the product.
    auto const printed = exp(log(g1 * g2) / S(2));
    claim.differs("(g_k g_k+1)^(1/2), as printed", model, printed, q);
  });
}

STATEMENT(claim_3_3_midpoint_zeta, "difference element zeta for the chart at the second point") {
  claim.corrected(R"(\zeta = \frac1{\Delta t}\log(g_kg_{k+1}^{-1}))", R"(\zeta = -\frac1{\Delta t}\log(g_kg_{k+1}^{-1}) = \frac1{\Delta t}\log(g_{k+1}g_k^{-1}))",
                  "In the chart at $g_{k+1}$ the later place is the origin, so the difference is minus the chart of the earlier one. A Lagrangian that is even in the velocity does not see it.");
  claim.maybe_scan();
  claim.degree(chart_degree);
  over_groups(chart_groups<S>(), claim, [&](auto const& group, auto const& model) {
    auto const g1 = draw.template element<S>(group, S(1)), g2 = draw_near(draw, g1);
    S const h = step_length<S>();
    auto const zeta = chart_midpoint_right(at_second(g1, g2), g1, g2, h).zeta;
    claim.equal("zeta = -log(g_k g_k+1^-1)/h", model, zeta, -log(g1 * inverse(g2)) / h);
    claim.equal("zeta for the time h takes g_k to g_k+1", model, exp(h * zeta) * g1, g2);
    claim.differs("+log(g_k g_k+1^-1)/h, as printed, takes it elsewhere", model, exp(log(g1 * inverse(g2))) * g1, g2);
  });
}
