// Section 3.1, second part: where a discrete Lagrangian is regular, and the flow that it then has.

#include "actio/variational/legendre.hpp"

#include "models/enclosures.hpp"
#include "models/pairs.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

/// \f$L(g_0, g_1) = \mathrm{tr}(g_0g_1^{-1})\f$, which on SO(3) depends on the angle between the two
/// configurations alone.
inline constexpr auto trace_lagrangian = [](auto const& g0, auto const& g1) {
  return (g0 * inverse(g1)).value.trace();
};
/// \f$-\tfrac12|g_1 - g_0|^2\f$, entry by entry.
inline constexpr auto squared_distance = [](auto const& g0, auto const& g1) {
  auto const d = (g1.value - g0.value).eval();
  typename std::decay_t<decltype(g0)>::Scalar sum(0);
  for (Index i = 0; i < d.rows(); ++i)
    for (Index j = 0; j < d.cols(); ++j) sum -= d(i, j) * d(i, j) / 2;
  return sum;
};
template <class S>
S determinant(Matrix<S> const& m) {
  // Expand along the first row: for the few small matrices here.
  if (m.rows() == 1) return m(0, 0);
  S sum(0);
  for (Index j = 0; j < m.cols(); ++j) {
    Matrix<S> minor(m.rows() - 1, m.cols() - 1);
    for (Index i = 1; i < m.rows(); ++i)
      for (Index k = 0, c = 0; k < m.cols(); ++k)
        if (k != j) minor(i - 1, c++) = m(i, k);
    S const term = m(0, j) * determinant(minor);
    if (j % 2 == 0)
      sum += term;
    else
      sum -= term;
  }
  return sum;
}

}  // namespace

namespace {

/// How far from 1, in the row norm, 1 - M Y stays, with Y near the inverse of the middle of M: where it does,
/// every matrix in M has an inverse.
/// @throws Undecided  where it is not seen
Number room_for_inverse(Matrix<Number> const& m) {
  Index const n = m.rows();
  Matrix<double> middle(n, n);
  for (Index i = 0; i < m.size(); ++i) middle(i) = to_double(middle_of(m(i)));
  Matrix<Number> slack = Matrix<Number>::Identity(n, n);
  try {
    slack -= m * inverse_matrix(middle).unaryExpr([](double y) { return Number(y); });
  } catch (Singular const&) {
    throw Undecided("whether a matrix has an inverse");
  }
  Number room(1);
  for (Index i = 0; i < n; ++i) {
    Number sum(0);
    for (Index j = 0; j < n; ++j) sum += magnitude(slack(i, j));
    if (Number const left = (Number(1) - sum).lower(); left < room) room = left;
  }
  if (!(room > Number(0))) throw Undecided("whether a matrix has an inverse");
  return room;
}
/// A Lagrangian on TG seen from the configuration g: \f$L(kg, \xi)\f$ as a function of k. On pairs the
/// discretization at the configuration moves along.
StatePolynomial<Number> seen_from(StatePolynomial<Number> lagrangian, GroupElement<Number> const& g) {
  Matrix<Number> const back = g.value.transpose();
  lagrangian.u = lagrangian.u * back, lagrangian.w = lagrangian.w * back;
  return lagrangian;
}
/// What is left out of a Lagrangian on TG: its dependence on the configuration, or the regularity.
enum class Kind { general, right_invariant, not_regular };
StatePolynomial<Number> draw_kind(Draw draw, SpannedGroup const& group, Kind kind) {
  auto lagrangian = draw_state_polynomial<Number>(draw, group);
  lagrangian.kinetic.kappa /= 16;
  if (kind == Kind::right_invariant) lagrangian.u.setZero(), lagrangian.w.setZero();
  // Energy of one velocity is left, and a multiple of its cube.
  if (kind == Kind::not_regular) lagrangian.kinetic.a.row(0).setZero(), lagrangian.kinetic.a.col(0).setZero();
  return lagrangian;
}
/// A box of n numbers within `size` of zero.
Vector<Number> cube(int n, Number const& size) {
  return Vector<Number>::Constant(n, Number::between(-size, size));
}
GroupElement<Number> retracted(SpannedGroup const& group, Vector<Number> const& v) {
  return retract(velocity(group, v));
}
/// The step of the enclosures.
Number short_step() { return ratio<Number>(1, 64); }

/// Whether D2 D1 L has an inverse at every pair (g, retract(h xi) g), g = retract(u), |u| within `places` and
/// |xi| within 1.
Enclosure regular_near_diagonal(StatePolynomial<Number> const& lagrangian, SpannedGroup const& group,
                                Number const& places, int most = 64) {
  int const d = group.dimension();
  Vector<Number> box(2 * d);
  box << cube(d, places), cube(d, Number(1));
  return positive_on(
      [&](Vector<Number> const& x) {
        auto const L =
            discretize_at_the_configuration(seen_from(lagrangian, retracted(group, x.head(d))), short_step());
        auto const m = mixed_derivative(L, identity<Number>(group),
                                        retracted(group, Vector<Number>(x.tail(d) * short_step())));
        return room_for_inverse(Matrix<Number>(m * short_step()));
      },
      box, most);
}
/// Whether D2 D1 L, of a Lagrangian of the relative motion alone, has an inverse at every pair whose relative
/// motion is the retraction of an element of the box.
template <class Lagrangian>
Enclosure regular_at_relative_motions(Lagrangian const& L, SpannedGroup const& group,
                                      Vector<Number> const& box, int most = 64) {
  return positive_on(
      [&](Vector<Number> const& x) {
        return room_for_inverse(mixed_derivative(L, identity<Number>(group), retracted(group, x)));
      },
      box, most);
}

}  // namespace

STATEMENT(rem_3_1_2,
          "near the diagonal a regular Lagrangian gives a nondegenerate form, far from it perhaps not") {
  claim.convention(
      "Where the Lagrangian is regular near the diagonal, as one that comes from a regular Lagrangian on "
      "$TG$ with a short step is: in balls, at every pair $(g, \\mathrm{retract}(h\\xi)g)$ with $g$ in a "
      "neighbourhood of 1, $|\\xi|\\le 1$ and $h = 1/64$. The form itself is defined everywhere. "
      "$\\mathrm{tr}(g_0g_1^{-1})$ on $\\SO(3)$ is nondegenerate in a whole neighbourhood of the diagonal "
      "and degenerate at quarter turns; the squared distance on the Heisenberg group is degenerate nowhere.");
  claim.leaves(
      "Every regular Lagrangian: in balls one is drawn for each group, at one step and one "
      "retraction. For the others the page has the expansion in the step, whose coefficients are "
      "compared on the diagonal alone.");
  over_groups(all_groups(), claim, [&](auto const& group, auto const& model) {
    // On the diagonal h D2 D1 L is minus the fibre Hessian, plus h times a remainder that is affine in h: the
    // potential's second derivative comes with h.
    auto const lagrangian = draw_state_polynomial<S>(draw, group);
    auto const g = draw.template element<S>(group);
    State<SpannedGroup, S> const at_rest{g, rest<S>(group)};
    Matrix<S> const hessian = fibre_hessian(lagrangian, at_rest);
    auto const remainder = [&](S const& h) {
      return Matrix<S>(
          (h * mixed_derivative(discretize_at_the_configuration(lagrangian, h), g, g) + hessian) / h);
    };
    claim.equal("on the diagonal h D2 D1 L tends to minus the fibre Hessian", model,
                Matrix<S>(remainder(ratio<S>(1, 2)) + remainder(ratio<S>(1, 6))),
                Matrix<S>(remainder(ratio<S>(1, 3)) * S(2)));
    // So for a short step it has an inverse, as the Hessian (positive definite here) has.
    Matrix<S> const m = mixed_derivative(discretize_at_the_configuration(lagrangian, ratio<S>(1, 1000)), g,
                                         g),
                    one = Matrix<S>::Identity(m.rows(), m.cols());
    claim.equal("nondegenerate on the diagonal for a short step", model, Matrix<S>(m * inverse_matrix(m)),
                one);
    // Controls: the Hessian with the other sign; a Lagrangian that couples its configurations in no way.
    claim.differs("on the diagonal h D2 D1 L tends to the fibre Hessian", model, Matrix<S>(m / S(1000)),
                  hessian);
    auto const apart = [](auto const& g0, auto const& g1) {
      return g0.value(0, 0) + g1.value(0, 1) * g1.value(0, 0);
    };
    claim.template refuses<Singular>("a Lagrangian that is not regular", model, [&] {
      inverse_matrix(Matrix<S>(mixed_derivative(apart, g, g)), "D2 D1 L");
    });
  });
  // A whole neighbourhood of the diagonal, in balls.
  for (auto const& group : few_groups()) {
    claim.encloses("nondegenerate at every pair near the diagonal", group.name(), [&] {
      return regular_near_diagonal(draw_kind(draw, group, Kind::general), group, ratio<Number>(1, 4));
    });
    claim.refutes_enclosure("a Lagrangian on TG that is not regular", group.name(), [&] {
      return regular_near_diagonal(draw_kind(draw, group, Kind::not_regular), group, Number(0), 4);
    });
  }

  // All relative motions near the identity, and some around a quarter turn, which is the retraction of a
  // vector of length 2.
  claim.encloses("the trace, near the diagonal", "SO(3)", [&] {
    return regular_at_relative_motions(trace_lagrangian, all_groups()[0], cube(3, ratio<Number>(1, 8)));
  });
  claim.refutes_enclosure("the trace, around a quarter turn", "SO(3)", [&] {
    Vector<Number> box = cube(3, ratio<Number>(1, 8));
    box[2] += Number(2);
    return regular_at_relative_motions(trace_lagrangian, all_groups()[0], box);
  });
  // Away from the diagonal on SO(3): the determinant is 4 cos(phi) (1 + cos(phi)), zero at a quarter turn.
  SpannedGroup const so3 = all_groups()[0];
  {
    auto const g0 = draw.template element<S>(so3, S(1)), g1 = draw.template element<S>(so3, S(1));
    S const cosine = (trace_lagrangian(g0, g1) - S(1)) / S(2);
    S const det = determinant<S>(mixed_derivative(trace_lagrangian, g0, g1)),
            expected = S(4) * cosine * (S(1) + cosine);
    // The form's determinant is the square of this one: build it from the two-form on the basis.
    Matrix<S> form(6, 6);
    auto const basis = [&](int a) {
      return Change<S>{a < 3 ? basis_velocity<S>(so3, a) : rest<S>(so3),
                       a < 3 ? rest<S>(so3) : basis_velocity<S>(so3, a - 3)};
    };
    for (int a = 0; a < 6; ++a)
      for (int b = 0; b < 6; ++b)
        form(a, b) = discrete_two_form(trace_lagrangian, g0, g1, basis(a), basis(b));
    claim.zero("determinant of D2 D1 L against the angle", "SO(3)", S(det - expected), S(8));
    claim.zero("determinant of the form is its square", "SO(3)", S(determinant(form) - det * det), S(64));

    // At a quarter turn the axis is a null direction of the form, and the flow is refused.
    Matrix<S> quarter(3, 3);
    quarter << S(0), S(-1), S(0), S(1), S(0), S(0), S(0), S(0), S(1);
    GroupElement<S> const turned = GroupElement<S>{so3, quarter} * g0;
    auto const axis = basis_velocity<S>(so3, 2);
    auto const any = draw_changes<S>(draw, so3)[0];
    claim.zero("a null vector at a quarter turn", "SO(3)",
               discrete_two_form(trace_lagrangian, g0, turned, {axis, axis}, any), S(2));
    claim.refutes("the same vector at a random pair", "SO(3)",
                  discrete_two_form(trace_lagrangian, g0, g1, {axis, axis}, any), S(2));
    auto const here = identity<S>(so3);
    claim.template refuses<Singular>("the flow into a quarter turn", "SO(3)", [&] {
      discrete_flow_tangent(trace_lagrangian, here, here, GroupElement<S>{so3, quarter}, any);
    });
  }
  // Nowhere degenerate: the squared distance on the Heisenberg group, at configurations far apart.
  SpannedGroup const heisenberg = all_groups().back();
  {
    auto const g0 = draw.template element<S>(heisenberg, S(50)),
               g1 = draw.template element<S>(heisenberg, S(50));
    // Terms reach the fourth power of the distance.
    claim.equal("determinant 1 at configurations far apart", "Heisenberg",
                determinant<S>(mixed_derivative(squared_distance, g0, g1)), S(1), 1e7);
  }
}

namespace {

/// The equation for the velocity x of the next step: D2 L(g0, g1) + D1 L(g1, g2) with g0 = retract(-h xi) g1
/// and g2 = retract(h x) g1, everything seen from g1.
struct NextVelocity {
  StatePolynomial<Number> lagrangian;
  SpannedGroup group;
  Vector<Number> xi;

  template <class T>
  Vector<T> operator()(Vector<T> const& x) const {
    auto const L = discretize_at_the_configuration(lagrangian, short_step());
    auto const at = [&](Vector<T> const& v) {
      return retract(velocity(group, Vector<T>(v * T(short_step()))));
    };
    return discrete_euler_lagrange(L, at(Vector<T>(-xi.template cast<T>())), identity<T>(group), at(x))
        .components;
  }
};
/// Whether (3.2) has exactly one solution g2 = retract(h x) g1 with x within 1/2 of some vector, for every
/// pair (g0, g1) near the diagonal: g1 = retract(u) with |u| within `places`, g0 = retract(-h xi) g1 with
/// |xi| within `speeds`.
Enclosure one_next_configuration(StatePolynomial<Number> const& lagrangian, SpannedGroup const& group,
                                 Number const& places, Number const& speeds, int most = 64) {
  int const d = group.dimension();
  Vector<Number> box(2 * d);
  box << cube(d, places), cube(d, speeds);
  return positive_on(
      [&](Vector<Number> const& p) {
        NextVelocity const equation{seen_from(lagrangian, retracted(group, p.head(d))), group, p.tail(d)};
        Number room(0);
        try {
          // Near the velocity before, which one Newton step improves.
          Vector<Number> centre = p.tail(d).unaryExpr([](Number const& x) { return middle_of(x); });
          auto const there = derivative(equation, centre);
          centre -= solve_linear(there.matrix, there.value);
          auto const found = one_zero_near(equation, centre, ratio<Number>(1, 2));
          room = Number(found.margin);
        } catch (Singular const&) {
        }
        if (!(room > Number(0))) throw Undecided("whether there is one next configuration");
        return room;
      },
      box, most);
}

}  // namespace

STATEMENT(claim_3_1_discrete_flow_exists, "a regular discrete Lagrangian has one next configuration") {
  claim.convention(
      "Near the pair, for pairs near the diagonal: in balls, for every pair $(g_0, g_1)$ with $g_1$ in a "
      "neighbourhood of 1 and $g_0 = \\mathrm{retract}(-h\\xi)g_1$, $|\\xi|\\le 1/8$, $h = 1/64$, there is "
      "exactly one $g_2=\\mathrm{retract}(hx)g_1$ with $x$ in a box of radius $1/2$; for a right-invariant "
      "Lagrangian $g_1$ is any. Farther away there may be a second one, as for $\\mathrm{tr}(g_0g_1^{-1})$.");
  claim.leaves(
      "Every regular Lagrangian: in balls one is drawn for each group, at one step and one retraction. For "
      "the others the theorem on implicit functions gives a neighbourhood, of a size that is not told.");
  for (auto const& group : few_groups()) {
    claim.encloses("exactly one next configuration, at every pair near the diagonal", group.name(), [&] {
      return one_next_configuration(draw_kind(draw, group, Kind::general), group, ratio<Number>(1, 64),
                                    ratio<Number>(1, 8));
    });
    claim.encloses("right-invariant: the same at every place", group.name(), [&] {
      return one_next_configuration(draw_kind(draw, group, Kind::right_invariant), group, Number(0),
                                    ratio<Number>(1, 8));
    });
    claim.refutes_enclosure("a Lagrangian on TG that is not regular", group.name(), [&] {
      return one_next_configuration(draw_kind(draw, group, Kind::not_regular), group, Number(0), Number(0),
                                    1);
    });
  }
  // A second solution far away: turns by an angle and by its supplement about one axis have the same
  // antisymmetric part, and with it the same momentum.
  SpannedGroup const so3 = all_groups()[0];
  auto const axis = draw.template velocity<S>(so3), change = draw.template velocity<S>(so3);
  auto const g1 = draw.template element<S>(so3), step = retract(axis);
  GroupElements<S> const g = {step * g1, g1, inverse(step) * g1};
  Vector<S> const n = axis.coordinates;
  Matrix<S> const along = n * n.transpose() / S(n.squaredNorm()), one = Matrix<S>::Identity(3, 3);
  S const cosine = (step.value.trace() - S(1)) / S(2);
  GroupElement<S> const supplement{so3, Matrix<S>(step.value + (along - one) * S(cosine * S(2)))};
  claim.equal("the supplement is a turn", "SO(3)", Matrix<S>(supplement.value * supplement.value.transpose()),
              one,
              10);  // the square of the axis is divided by
  auto const equation = [&](GroupElement<S> const& g2) {
    return discrete_euler_lagrange(trace_lagrangian, g[0], g[1], g2);
  };
  claim.zero("the next configuration", "SO(3)", equation(g[2]), S(1));
  claim.zero("a second one, by the supplement", "SO(3)", equation(inverse(supplement) * g1), S(1), 10);
  claim.refutes("by the turn the other way", "SO(3)", equation(step * g1), S(1));
  claim.refutes("by another turn", "SO(3)", equation(inverse(retract(axis + change)) * g1), S(1));
}
