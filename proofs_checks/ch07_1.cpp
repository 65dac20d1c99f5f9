// Section 7.1: the theorem of Lagrange multipliers, with the hypothesis that it needs.
#include "statement.hpp"

#include "actio/constraints/multiplier_theorem.hpp"
#include "fields.hpp"

namespace {

using namespace actio;
using namespace actio::checks;

template <class S, int m>
using Numbers = Matrix<S, m, 1>;

/// Zeros that are a graph: \f$\Psi(u, w) = A(u)\,(w - F(u))\f$ on R^2 x R^2, with A invertible near the
/// origin.
template <class S>
struct GraphConstraint {
  std::array<Cubic<S, 2>, 2> F;
  AnyMetric<S, 2> A;

  /// The point of the graph over u.
  template <class T>
  Numbers<T, 4> over(Numbers<T, 2> const& u) const { return {u[0], u[1], F[0](u), F[1](u)}; }
  template <class T>
  Numbers<T, 2> operator()(Numbers<T, 4> const& q) const {
    Numbers<T, 2> const u = q.template head<2>();
    Numbers<T, 2> const gap(q[2] - F[0](u), q[3] - F[1](u));
    return A.frame(u) * gap;
  }
};

/// An inner product of the fibres that depends on the point.
template <class S>
struct FibreMetric {
  AnyMetric<S, 2> g;
  template <class T>
  auto operator()(Numbers<T, 4> const& q) const { return g(Numbers<T, 2>(q[0], q[3])); }
};

/// A cubic with a linear function added, so that its differential at one point is what it should be.
template <class S, int m>
struct Tilted {
  Cubic<S, m> c;
  Numbers<S, m> slope;
  template <class T>
  T operator()(Numbers<T, m> const& q) const {
    T sum = c(q);
    for (int i = 0; i < m; ++i) sum += q[i] * T(slope[i]);
    return sum;
  }
};

/// The derivative of a function on R^2.
template <class S, class F>
Numbers<S, 2> plane_derivative(F const& f, Numbers<S, 2> const& u) { return derivative(f, u).gradient(); }

/// A graph, an inner product of the fibres, and a function h with \f$d\bar h = 0\f$ in q at a given point and
/// for a given multiplier.
template <class S>
struct GraphModel {
  GraphConstraint<S> Psi;
  FibreMetric<S> fibre;
  Cubic<S, 4> c;

  explicit GraphModel(Draw& draw)
      : Psi{{draw_cubic<S, 2>(draw), draw_cubic<S, 2>(draw)}, draw_metric<S, 2>(draw)},
        fibre{draw_metric<S, 2>(draw)},
        c(draw_cubic<S, 4>(draw)) {}

  auto with(Tilted<S, 4> const& h) const { return constrained<2>(h, Psi, fibre); }
  /// h with the part of \f$d\bar h\f$ in q zero at (q, lambda).
  Tilted<S, 4> critical_at(Numbers<S, 4> const& q, Numbers<S, 2> const& lambda) const {
    Tilted<S, 4> h{c, Numbers<S, 4>::Zero()};
    h.slope = -with(h).augmented_differential(q, lambda).template head<4>();
    return h;
  }
  /// h with a restriction that is critical over u: its derivative across the graph is anything.
  Tilted<S, 4> restriction_critical_over(Numbers<S, 2> const& u) const {
    Tilted<S, 4> h{c, Numbers<S, 4>::Zero()};
    h.slope.template head<2>() = -along_graph(h, u);
    return h;
  }
  /// The derivative of \f$u\mapsto h(u, F(u))\f$: the restriction, in coordinates of the zeros.
  Numbers<S, 2> along_graph(Tilted<S, 4> const& h, Numbers<S, 2> const& u) const {
    return plane_derivative([&](auto const& at) { return h(Psi.over(at)); }, u);
  }
};

/// The cusp \f$y^2 = x^3\f$: x is smallest at its tip, where the derivative of the constraint vanishes.
auto const cusp = []<class T>(Numbers<T, 2> const& q) {
  return Numbers<T, 1>(q[1] * q[1] - q[0] * q[0] * q[0]);
};
/// \f$x^2 + y^2 = 0\f$: one point, which is critical for every function.
auto const isolated = []<class T>(Numbers<T, 2> const& q) {
  return Numbers<T, 1>(q[0] * q[0] + q[1] * q[1]);
};
/// A line and a parabola that touch: \f$y = 0,\ y = x^2\f$.
auto const touching = []<class T>(Numbers<T, 2> const& q) { return Numbers<T, 2>(q[1], q[1] - q[0] * q[0]); };
auto const first_coordinate = []<class T>(Numbers<T, 2> const& q) { return q[0]; };

/// Without regularity: the restriction is critical at the origin, and no multiplier makes the augmented
/// function so.
template <class S>
void refute_without_regularity(Claim<S>& claim, Draw& draw) {
  Numbers<S, 2> const origin = Numbers<S, 2>::Zero();
  auto const none = [&](auto const& f, std::string const& model) {
    constexpr int k = std::remove_cvref_t<decltype(f.constraint_derivative(origin))>::RowsAtCompileTime;
    Numbers<S, k> const lambda = draw.vector<S, Numbers<S, k>>(k);
    claim.refutes("differential of the augmented function, whatever the multiplier", model,
                  f.augmented_differential(origin, lambda), S(1));
    claim.template refuses<NotRegular>("no multiplier where the derivative is not onto", model,
                                       [&] { f.multiplier(origin); });
  };
  none(constrained<1>(first_coordinate, cusp), "cusp");
  none(constrained<1>(first_coordinate, isolated), "isolated point");
  none(constrained<2>(first_coordinate, touching), "touching curves");
}

}  // namespace

STATEMENT(thm_7_1_1, "Lagrange multiplier theorem for sections of an inner product bundle") {
  claim.convention(
      "An extremum is a point where the derivative vanishes, and the derivative of $\\Psi$ is onto at "
      "$\\varphi$; without the second hypothesis, which is not named, "
      "the first statement does not imply the second, as the tip of a cusp shows.");
  // The normal equations: twice the inner product (26) and the derivative of the constraint (9), squared by
  // the determinant, and as much for the right side.
  {
    GraphModel<S> const model(draw);
    std::string const name = "graph in R^4, inner product that varies";
    Numbers<S, 2> const u = draw.vector<S, Numbers<S, 2>>(2) / S(2),
                        lambda = draw.vector<S, Numbers<S, 2>>(2);
    Numbers<S, 4> const q = model.Psi.over(u);
    // Elimination of matrices of size one whose pivots are of size one tenth and more.
    double const condition = 100;

    // Second to first and back.
    auto const critical = model.with(model.critical_at(q, lambda));
    claim.zero("the restriction is critical where the augmented function is", name,
               critical.restricted_differential(q), S(1), condition);
    claim.zero("its multiplier is the one that was chosen", name,
               Numbers<S, 2>(critical.multiplier(q) - lambda), S(1), condition);
    auto const restricted = model.with(model.restriction_critical_over(u));
    claim.zero("the augmented function is critical where the restriction is", name,
               restricted.augmented_differential(q, restricted.multiplier(q)), S(1), condition);

    // Neither holds at another point.
    Tilted<S, 4> const any{model.c, draw.vector<S, Numbers<S, 4>>(4)};
    auto const f = model.with(any);
    claim.refutes("first statement for another function", name, f.restricted_differential(q), S(1));
    claim.refutes("second statement for another function", name, f.augmented_differential(q, f.multiplier(q)),
                  S(1));
  }
  refute_without_regularity(claim, draw);
}

STATEMENT(claim_7_1_first_to_second, "from a constrained extremum to an extremum with multiplier") {
  claim.convention(
      "The derivative of $\\Psi$ is onto at the point, and the second extremum is a point where the "
      "derivative vanishes: $\\bar h$ is affine in the multiplier and rises and falls near "
      "every point, so it has no minimum or maximum there even where $h|_{\\mathcal N}$ has one.");
  {
    GraphModel<S> const model(draw);
    std::string const name = "graph in R^4, inner product that varies";
    Numbers<S, 2> const u = draw.vector<S, Numbers<S, 2>>(2) / S(2);
    Numbers<S, 4> const q = model.Psi.over(u);
    auto const h = model.restriction_critical_over(u);
    claim.zero("derivative along the graph", name, model.along_graph(h, u), S(1), 30);
    auto const f = model.with(h);
    // The normal equations square the condition of the derivative.
    Numbers<S, 2> const lambda = f.multiplier(q);
    claim.zero("derivative of the augmented function in point and multiplier", name,
               f.augmented_differential(q, lambda), S(1), 100);
    claim.refutes("with another multiplier", name,
                  f.augmented_differential(q, Numbers<S, 2>(lambda[0] + S(1), lambda[1])), S(1));

    // Along (p, s DPsi p) the second derivative is p.A.p - 2 s |DPsi p|^2: of either sign.
    Numbers<S, 4> const p = f.constraint_derivative(q).row(0).transpose();
    Numbers<S, 2> const mu = f.constraint_derivative(q) * p;
    auto const second = [&](S const& s) {
      using D = SecondOrder<S, 1>;
      D const t = D::variable(S(0), 0);
      Numbers<D, 4> moved;
      Numbers<D, 2> multiplier;
      for (int i = 0; i < 4; ++i) moved[i] = D(q[i]) + t * D(p[i]);
      for (int i = 0; i < 2; ++i) multiplier[i] = D(lambda[i]) + t * D(S(s * mu[i]));
      return f.augmented(moved, multiplier).second[0];
    };
    if (ordered_arithmetic<S>())
      claim.fact("the augmented function rises and falls near its critical point", name,
                 second(S(1000)) * second(S(-1000)) < S(0));
  }
  refute_without_regularity(claim, draw);
}

STATEMENT(claim_7_1_second_to_first, "from an extremum with multiplier to a constrained extremum") {
  claim.holds("No regularity is needed in this direction.");
  {
    GraphModel<S> const model(draw);
    std::string const name = "graph in R^4, inner product that varies";
    Numbers<S, 2> const u = draw.vector<S, Numbers<S, 2>>(2) / S(2),
                        lambda = draw.vector<S, Numbers<S, 2>>(2);
    Numbers<S, 4> const q = model.Psi.over(u);
    auto const h = model.critical_at(q, lambda);
    claim.zero("derivative in point and multiplier", name, model.with(h).augmented_differential(q, lambda),
               S(1), 30);
    claim.zero("derivative along the graph", name, model.along_graph(h, u), S(1), 30);

    // y = 0 and x y = 0 are dependent at the origin; the second multiplier is any number.
    auto const f =
        constrained<2>([]<class T>(Numbers<T, 2> const& p) { return T(p[0] * p[0] + p[1] * T(3)); },
                       []<class T>(Numbers<T, 2> const& p) { return Numbers<T, 2>(p[1], p[0] * p[1]); });
    Numbers<S, 2> const origin = Numbers<S, 2>::Zero(), multipliers(S(3), draw.number<S>());
    claim.zero("dependent constraints: derivative in point and multiplier", "R^2",
               f.augmented_differential(origin, multipliers), S(1));
    claim.zero("dependent constraints: derivative along their zeros, the first axis", "R^2",
               f.differential(origin)[0], S(1));
    claim.template refuses<NotRegular>("the way back, where the constraints are dependent", "R^2",
                                       [&] { f.multiplier(origin); });

    // Without the derivative in the multiplier the point need not satisfy the constraint, and over it the
    // restriction is not critical.
    Numbers<S, 4> const beside = q + Numbers<S, 4>(S(0), S(0), S(1), ratio<S>(1, 2));
    auto const off = model.critical_at(beside, lambda);
    claim.refutes("derivative along the graph for a critical point beside it", name,
                  model.along_graph(off, u), S(1));
  }
}
