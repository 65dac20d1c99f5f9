// Section 3.3, first part: natural charts and the discrete Lagrangian they define. Compiled once per scalar.
//
// Over the rationals the groups are unipotent, so exp, log and iex are polynomials and residuals are exactly zero (chart_models.hpp).
#include "chart_models.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

/// The span of symmetric forms B with B([x,y],z) + B(y,[x,z]) = 0, from the structure constants. These are whole numbers of modulus 2 at most: an entry below 1/1000 is zero.
template <class S>
std::vector<Matrix<S>> invariant_forms(SpannedGroup const& group) {
  int const d = group.dimension(), unknowns = d * (d + 1) / 2;
  auto const index = [d](int i, int j) { return i <= j ? i * d - i * (i - 1) / 2 + j - i : j * d - j * (j - 1) / 2 + i - j; };
  std::vector<Vector<S>> rows;  // in echelon form
  std::vector<int> pivots;
  for (int x = 0; x < d; ++x)
    for (int y = 0; y < d; ++y)
      for (int z = y; z < d; ++z) {
        Vector<S> row = Vector<S>::Zero(unknowns);
        auto const e = [&](int a) { return basis_velocity<S>(group, a); };
        auto const xy = bracket(e(x), e(y)).coordinates, xz = bracket(e(x), e(z)).coordinates;
        for (int k = 0; k < d; ++k) row[index(k, z)] += xy[k], row[index(y, k)] += xz[k];
        // Eliminate what is known, then keep what is new.
        for (std::size_t r = 0; r < rows.size(); ++r) row -= rows[r] * S(row[pivots[r]]);
        int p = 0;
        while (p < unknowns && !(magnitude(row[p]) > ratio<S>(1, 1000))) ++p;
        if (p == unknowns) continue;
        row /= S(row[p]);
        for (auto& known : rows) known -= row * S(known[p]);
        rows.push_back(row), pivots.push_back(p);
      }
  std::vector<Matrix<S>> forms;
  for (int f = 0; f < unknowns; ++f) {
    if (std::find(pivots.begin(), pivots.end(), f) != pivots.end()) continue;
    Vector<S> solution = Vector<S>::Zero(unknowns);
    solution[f] = S(1);
    for (std::size_t r = 0; r < rows.size(); ++r) solution[pivots[r]] = -rows[r][f];
    Matrix<S> form(d, d);
    for (int i = 0; i < d; ++i)
      for (int j = 0; j < d; ++j) form(i, j) = solution[index(i, j)];
    forms.push_back(form);
  }
  return forms;
}
/// The determinant by elimination, 0 where no pivot is left.
template <class S>
S determinant(Matrix<S> m) {
  S product(1);
  for (Eigen::Index k = 0; k < m.rows(); ++k) {
    Eigen::Index p = k;
    for (Eigen::Index i = k; i < m.rows(); ++i)
      if (magnitude(m(i, k)) > magnitude(m(p, k))) p = i;
    if (m(p, k) == S(0)) return S(0);
    if (p != k) m.row(p).swap(m.row(k)), product = -product;
    product *= m(k, k);
    for (Eigen::Index i = k + 1; i < m.rows(); ++i) m.row(i) -= m.row(k) * S(m(i, k) / m(k, k));
  }
  return product;
}
template <class S>
S generic_determinant(Draw& draw, SpannedGroup const& group) {
  Matrix<S> sum = Matrix<S>::Zero(group.dimension(), group.dimension());
  for (auto const& form : invariant_forms<S>(group)) sum += form * S(S(1) + draw.number<S>() / S(4));
  return determinant(sum);
}

}  // namespace

STATEMENT(eq_3_19, "chart at a group element from the exponential map") {
  claim.holds();
  claim.degree(chart_degree);
  over_groups(chart_groups<S>(), claim, [&](auto const& group, auto const& model) {
    auto const g = draw.template element<S>(group), k = draw_near(draw, g), h = draw.template element<S>(group);
    auto const v = draw.template velocity<S>(group, ratio<S>(1, 4));
    // A chart and its inverse, the base point at the origin, the charts carried along by right translation.
    claim.equal("exp(psi_g(k)) g = k", model, exp(natural_chart_right(g, k)) * g, k);
    claim.equal("psi_g(exp(v) g) = v", model, natural_chart_right(g, exp(v) * g), v);
    claim.equal("psi_gh(kh) = psi_g(k)", model, natural_chart_right(g * h, k * h), natural_chart_right(g, k));
    claim.equal("left chart: g exp(phi_g(k)) = k", model, g * exp(natural_chart_left(g, k)), k);
    // Control: the chart of the other side.
    claim.differs("chart by left translation in place of it", model, exp(natural_chart_left(g, k)) * g, k);
  });
  if constexpr (Real<S>) {
    // The chart ends where exp stops being one to one: half a turn.
    SO<3> const group;
    auto const g = draw.template element<S>(group), half_turn = Element<SO<3>, S>{group, Eigen::Matrix<S, 3, 3>(Eigen::Matrix<S, 3, 1>(S(-1), S(-1), S(1)).asDiagonal())};
    claim.template refuses<OutsideDomain>("half a turn away, outside the chart", "SO(3)", [&] { natural_chart_right(g, half_turn * g); });
  }
}

STATEMENT(eq_3_20, "discrete Lagrangian from averages and differences in a chart") {
  claim.convention("The push-forward is taken at the averaged point $\\eta$, which print leaves open. The discrete Lagrangian of the library is $h$ times the printed one: an action.");
  claim.degree(chart_degree);
  over_groups(chart_groups<S>(), claim, [&](auto const& group, auto const& model) {
    auto const lagrangian = draw_state_polynomial<S>(draw, group);
    auto const g1 = draw.template element<S>(group), g2 = draw_near(draw, g1);
    S const h = step_length<S>();
    auto const base = beside_right(draw_small<S>(draw, group));
    auto const g = base(g1, g2);

    // Average and subtract in the chart, push forward by dual numbers.
    auto const first = natural_chart_right(g, g1), second = natural_chart_right(g, g2);
    auto const average = ratio<S>(1, 2) * (first + second), difference = (second - first) / h;
    claim.equal("the library's is h times (3.20)", model, discretize_right(lagrangian, h, base)(g1, g2), h * lagrangian(push_forward(g, average, difference)));
    // Control: pushed forward at the centre of the chart, where the differential of exp is the identity.
    claim.differs("push-forward at the centre of the chart: the velocity that L is given", model, push_forward(g, average, difference).velocity, difference);
  });
  if constexpr (std::same_as<S, double>) {
    // It approximates the Lagrangian at the middle of any smooth curve to order 2, whatever the base point.
    for (auto const& group : order_groups()) {
      auto const lagrangian = draw_state_polynomial<S>(draw, group);
      auto const curve = draw_curve<S>(draw, group);
      auto const at_end = at_second;
      auto const beside = staying_at(draw_near(draw, curve.g0));
      std::vector<double> errors_end, errors_beside, errors_unpushed;
      for (double h : halving_steps()) {
        auto const g1 = curve(S(0)), g2 = curve(h);
        S const exact = lagrangian(state_of(curve(moving(S(h / 2)))));
        errors_end.push_back(std::abs(discretize_right(lagrangian, h, at_end)(g1, g2) / h - exact));
        errors_beside.push_back(std::abs(discretize_right(lagrangian, h, beside)(g1, g2) / h - exact));
        auto const g = beside(g1, g2);
        auto const m = chart_midpoint_right(g, g1, g2, h);
        errors_unpushed.push_back(std::abs(lagrangian(State<SpannedGroup, S>{exp(m.eta) * g, m.zeta}) - exact));
      }
      claim.order("midpoint value, chart at the later place", group.name(), halving_steps(), errors_end, 2);
      claim.order("midpoint value, chart at a fixed place beside the curve", group.name(), halving_steps(), errors_beside, 2);
      claim.refutes_order("push-forward left out", group.name(), halving_steps(), errors_unpushed, 2);
    }
  }
}

STATEMENT(claim_3_3_quadratic_lie_algebra, "assumption of a regular quadratic Lie algebra") {
  claim.holds("The assumption is never used: the construction, its invariance and its reduction hold on Aff(1), SE(2), the Heisenberg group and others, whose algebras carry no invariant nondegenerate form. (That of SE(3) does.)");
  // Invariant forms are linear in the coefficients that are drawn, their determinant of degree 6 at most; the discrete Lagrangians as everywhere in this section.
  claim.degree(chart_degree);
  std::vector<SpannedGroup> without = {spanned("Heisenberg", Heisenberg{}), unitriangular(4)};
  if constexpr (Real<S>) without.push_back(spanned("Aff(1)", Aff1{})), without.push_back(spanned("SE(2)", SE<2>{}));
  over_groups(without, claim, [&](auto const& group, auto const& model) {
    claim.zero("every invariant form is degenerate: determinant of a generic one", model, generic_determinant<S>(draw, group), S(1));
    auto const l = draw_algebra_polynomial<S>(draw, group.dimension());
    auto const g1 = draw.template element<S>(group), g2 = draw_near(draw, g1), k = draw.template element<S>(group);
    auto const base = beside_right(draw_small<S>(draw, group));
    S const h = step_length<S>();
    auto const discrete = discretize_right(right_invariant(l), h, base);
    auto const scale = size_of_terms(l, fibre_element_right(chart_midpoint_right(base(g1, g2), g1, g2, h)));
    claim.zero("L(g1 k, g2 k) = L(g1, g2) all the same", model, S(discrete(g1 * k, g2 * k) - discrete(g1, g2)), scale);
    claim.zero("L(g1, g2) = l(g1 g2^-1) all the same", model, S(lift_right(natural_chart_lagrangian_right(l, h, base))(g1, g2) - discrete(g1, g2)), scale);
  });
  if constexpr (is_exact<S>)
    for (auto const& group : {spanned("Aff(1)", Aff1{}), spanned("SE(2)", SE<2>{})})
      claim.zero("every invariant form is degenerate: determinant of a generic one", group.name(), generic_determinant<S>(draw, group), S(1));
  // Control: the criterion can tell. Semisimple algebras have such a form, gl(2) too, and se(3) pairs rotations with translations.
  over_groups({spanned("SO(3)", SO<3>{}), spanned("SE(3)", SE<3>{}), spanned("SL(2)", SL2{}), spanned("GL(2)", GL<2>{})}, claim,
              [&](auto const& group, auto const& model) { claim.refutes("determinant of a generic invariant form where there is one", model, generic_determinant<S>(draw, group), S(1)); });
}
