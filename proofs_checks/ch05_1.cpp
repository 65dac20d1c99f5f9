// Section 5.1: the rigid body discretised by natural charts.
//
// Over the rationals the groups are unipotent, jets of rotations among them, so exp, log, iex and chi are
// polynomials (chart_models.hpp). A body there is a quadratic form on the algebra: what the statements of
// this section say of J asks for no more. Over the other scalars it is a body, on the rotations of three,
// four and five dimensions.
#include "actio/reduction/algebra_euler_poincare.hpp"
#include "actio/rigid_body/natural_chart_scheme.hpp"
#include "models/bodies.hpp"
#include "models/chart_update.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

/// Rotations; over exact fields third-order jets of curves in SO(3), and triangular matrices. SE(3) and
/// Aff(1) tell sides and stars that rotations do not.
template <class S>
std::vector<SpannedGroup> const& body_groups() {
  static std::vector<SpannedGroup> const unipotent = {third_jets(spanned("SO(3)", SO<3>{})), unitriangular(4),
                                                      unitriangular(5)};
  static std::vector<SpannedGroup> const usual = [] {
    std::vector<SpannedGroup> all = rotation_groups();
    all.push_back(spanned("SE(3)", SE<3>{})), all.push_back(spanned("Aff(1)", Aff1{}));
    return all;
  }();
  return exact_arithmetic<S>() ? unipotent : usual;
}
/// A body: J as a symmetric matrix in coordinates, positive definite. On the rotations that of a body,
/// \f$\Lambda_i+\Lambda_j\f$ for each plane.
template <class S>
Matrix<S> draw_inertia(Draw& draw, SpannedGroup const& group) {
  int const d = group.dimension(), n = group.matrix_size();
  if (group.name().rfind("SO(", 0) != 0) {
    Matrix<S> const m = draw_matrix<S>(draw, d, d) / S(4);
    return identity_matrix<S>(d) + m * m.transpose();
  }
  Matrix<S> const lambda = draw_second_moments<S>(draw, n);
  Matrix<S> j(d, d);
  for (int a = 0; a < d; ++a)
    j.col(a) =
        group.vee(inertia_operator(lambda, Matrix<S>(group.hat(basis_velocity<S>(group, a).coordinates))));
  return j;
}
/// \f$\tfrac12\langle J\xi, \xi\rangle\f$ by the pairing of coordinates, the kinetic energy: \f$\tfrac14\f$
/// of it by the pairing of matrices in (5.1), which is twice that.
template <class S>
struct KineticEnergy {
  Matrix<S> j;
  template <class T>
  T operator()(Velocity<SpannedGroup, T> const& xi) const {
    Vector<T> const image = j.template cast<T>() * xi.coordinates;
    return xi.coordinates.dot(image) / 2;
  }
};
/// The pairing of (5.1).
template <class S>
S matrix_pairing(Algebra<S> const& xi, Matrix<S> const& j, Algebra<S> const& eta) {
  return 2 * xi.coordinates.dot(j * eta.coordinates);
}
/// A Lagrangian that shows the configuration at which it is evaluated.
template <class S>
struct ConfigurationFunction {
  Matrix<S> w;
  template <class T>
  T operator()(State<SpannedGroup, T> const& state) const { return contract(w, state.configuration.value); }
};

}  // namespace

STATEMENT(claim_5_1_base_point, "base point of the chart discretisation, left-invariant case") {
  claim.holds(
      "The principal root: the configuration half-way. Left translation has it right where (3.24) has not.");
  over_groups(body_groups<S>(), claim, [&](auto const& group, auto const& model) {
    auto const g1 = draw.template element<S>(group), g0 = draw_near(draw, g1),
               k = draw.template element<S>(group);
    S const h = step_length<S>();
    auto const base_point = [](GroupElement<S> const& x, GroupElement<S> const& y) {
      return y * exp(log(inverse(y) * x) / S(2));
    };
    auto const q = base_point(g0, g1);
    claim.equal("(g_k+1^-1 q)^2 = g_k+1^-1 g_k", model, inverse(g1) * q * inverse(g1) * q, inverse(g1) * g0);
    claim.equal("chart by left translation at g_k+1, half of the chart of g_k", model,
                natural_chart_left(g1, q), natural_chart_left(g1, g0) / S(2));
    claim.equal("as far from g_k as from g_k+1", model, natural_chart_left(g0, q),
                -natural_chart_left(g1, q));
    claim.equal("the same with the two configurations exchanged", model, base_point(g1, g0), q);
    claim.equal("equivariant under left translations", model, base_point(k * g0, k * g1), k * q);
    ConfigurationFunction<S> const configuration{
        draw_matrix<S>(draw, group.matrix_size(), group.matrix_size())};
    claim.zero(
        "the configuration at which the library evaluates L", model,
        S(discretize_left(configuration, h, at_second)(g0, g1) - h * contract(configuration.w, q.value)),
        size_of(q));
    if (!exact_arithmetic<S>()) {
      Matrix<S> const quotient = (inverse(g1) * g0).value;
      claim.equal("g_k+1 times the principal square root", model,
                  Matrix<S>(g1.value * matrix_square_root(quotient)), q.value);
    }
    // Controls: the root on the other side; the root of the product, as (3.24) prints it.
    auto const root = exp(log(inverse(g1) * g0) / S(2));
    claim.differs("(g_k+1^-1 g_k)^(1/2) g_k+1", model, root * g1, q);
    claim.differs("(g_k g_k+1)^(1/2), as in (3.24)", model, g0 * g1, q * q);
  });
}

STATEMENT(claim_5_1_velocity_element, "discrete velocity of the chart discretisation, left-invariant case") {
  claim.corrected(R"(\zeta_{k+1k} = \frac1h\log(g_{k+1}^{-1}g_k))",
                  R"(\zeta_{k+1k} = -\frac1h)"
                  R"(\log(g_{k+1}^{-1}g_k) = \frac1h\log(g_k^{-1}g_{k+1}))",
                  "The printed one leads from the later configuration to the earlier. The kinetic energy "
                  "is even and does not depend on it; (5.4) goes with the printed sign.");
  over_groups(body_groups<S>(), claim, [&](auto const& group, auto const& model) {
    auto const g0 = draw.template element<S>(group), g1 = draw_near(draw, g0),
               k = draw.template element<S>(group);
    S const h = step_length<S>();
    auto const zeta = -log(inverse(g1) * g0) / h;
    claim.equal("the difference in the chart at g_k+1", model, chart_midpoint_left(g1, g0, g1, h).zeta, zeta);
    claim.equal("zeta for the time h takes g_k to g_k+1", model, g0 * exp(h * zeta), g1);
    claim.equal("log(g_k^-1 g_k+1)/h", model, log(inverse(g0) * g1) / h, zeta);
    claim.equal("left-invariant", model, -log(inverse(k * g1) * (k * g0)) / h, zeta);
    // Controls: the printed sign; the velocity as seen from space.
    claim.differs("as printed, for the time h it takes g_k elsewhere", model, g0 * exp(-h * zeta), g1);
    claim.differs("log(g_k+1 g_k^-1)/h", model, log(g1 * inverse(g0)) / h, zeta);
  });
  if (claim.fits_orders())
    for (auto const& group : rotation_groups()) {
      auto const curve = draw_curve<S>(draw, group);
      std::vector<double> errors, printed;
      for (double const length : halving_steps()) {
        S const h(length);
        auto const exact = body_velocity(state_of(curve(moving(S(h / 2)))));
        auto const back = log(inverse(curve(h)) * curve(S(0))) / h;
        errors.push_back(to_double(size_of(-back - exact))),
            printed.push_back(to_double(size_of(back - exact)));
      }
      claim.order("zeta against the body velocity half-way", group.name(), halving_steps(), errors, 2);
      claim.refutes_order("zeta as printed", group.name(), halving_steps(), printed, 2);
    }
}

STATEMENT(eq_5_2, "discrete rigid body Lagrangian from the chart") {
  claim.corrected(
      R"(L(g_k,g_{k+1}) = \tfrac12\langle\zeta_{k+1k},\zeta_{k+1k}\rangle = \tfrac12\langle)"
      R"(\zeta_{k+1k},\mathcal J(\zeta_{k+1k})\rangle)",
      R"(L(g_k,g_{k+1}) = (\zeta_{k+1k},\zeta_{k+1k}) = \tfrac14\langle\zeta_{k+1k},\mathcal J()"
      R"(\zeta_{k+1k})\rangle)",
      "By the pairing of (5.1), for which the kinetic energy has $\\tfrac14$ and the metric "
      "$(\\cdot,\\cdot)$ has it too. The factor drops out of the equations. By the pairing of coordinates, "
      "half of that, $\\tfrac12$ is right here and the $\\tfrac14$ of (5.1) is not.");
  over_groups(body_groups<S>(), claim, [&](auto const& group, auto const& model) {
    auto const g1 = draw.template element<S>(group), g0 = draw_near(draw, g1),
               k = draw.template element<S>(group);
    S const h = step_length<S>();
    auto const j = draw_inertia<S>(draw, group);
    auto const zeta = log(inverse(g1) * g0) / h;
    S const full = discretize_left(left_invariant(KineticEnergy<S>{j}), h, at_second)(g0, g1) / h,
            printed = matrix_pairing(zeta, j, zeta) / 2;
    claim.equal("L(q, T_e L_q zeta) = <zeta, J zeta>/4", model, full, S(printed / 2));
    claim.equal("<zeta, J zeta>/4, either sign of zeta", model, full, KineticEnergy<S>{j}(-zeta));
    claim.equal("left-invariant", model,
                S(discretize_left(left_invariant(KineticEnergy<S>{j}), h, at_second)(k * g0, k * g1) / h),
                full);
    // Controls: the printed factor; half the metric of section 5.0; the velocity on the other side.
    claim.differs("<zeta, J zeta>/2, as printed", model, full, printed);
    claim.differs("(zeta, zeta)/2 with the metric of section 5.0", model, full, S(printed / 4));
    claim.refutes("T_e R_q in place of T_e L_q: the velocity that l is given", model,
                  zeta - Ad(inverse(g1), zeta), size_of(zeta));
  });
  // The masses of a body themselves, at q and moving with q zeta: everything but the logarithm is rational.
  over_groups(rotation_groups(), claim, [&](auto const& group, auto const& model) {
    auto const body = draw_point_masses<S>(draw, group.matrix_size());
    auto const q = draw_rotation<S>(draw, group), zeta = draw_skew<S>(draw, group);
    S const energy = body.kinetic_energy(Matrix<S>(q * zeta)),
            pairing = contract(zeta, inertia_operator(body.second_moments(), zeta));
    claim.equal("the kinetic energy of masses with the velocity zeta in the body is <zeta, J zeta>/4",
                model + " with masses", energy, S(pairing / 4));
    claim.differs("<zeta, J zeta>/2 for masses", model + " with masses", energy, S(pairing / 2));
  });
}

STATEMENT(eq_5_3, "reduced discrete rigid body Lagrangian through the logarithm") {
  claim.same_slip_as("eq_5_2");
  claim.corrected(R"(\ell(f_{k+1k}) = \frac1{2h^2}\langle\log f_{k+1k},\mathcal J(\log f_{k+1k})\rangle)",
                  R"(\ell(f_{k+1k}) = \frac1{4h^2}\langle\log f_{k+1k},\mathcal J(\log f_{k+1k})\rangle)",
                  "The factor of (5.2) again: by the pairing of (5.1) it is $\\tfrac14$, by that of "
                  "coordinates $\\tfrac12$. The library's carries the factor $h$.");
  over_groups(body_groups<S>(), claim, [&](auto const& group, auto const& model) {
    auto const g1 = draw.template element<S>(group), g0 = draw_near(draw, g1),
               k = draw.template element<S>(group);
    S const h = step_length<S>();
    auto const j = draw_inertia<S>(draw, group);
    auto const l = [&](GroupElement<S> const& f, long factor) {
      return S(matrix_pairing<S>(log(f), j, log(f)) / (S(factor) * h * h));
    };
    // f from g1 f = g0, by elimination.
    GroupElement<S> const f{group, solve_linear(g1.value, g0.value, "g1 f = g0")},
        other{group, (g0 * inverse(g1)).value};
    S const full = discretize_left(left_invariant(KineticEnergy<S>{j}), h, at_second)(k * g0, k * g1) / h;
    claim.equal("L(k g_k, k g_k+1) = <log f, J log f>/(4 h^2)", model, full, l(f, 4));
    claim.equal("the library's is h times it", model,
                S(natural_chart_lagrangian_left(KineticEnergy<S>{j}, h)(f) / h), l(f, 4));
    claim.equal("the same for f^-1", model, l(inverse(f), 4), l(f, 4));
    // Controls: the printed factor; the other quotient.
    claim.differs("1/(2 h^2), as printed", model, full, l(f, 2));
    claim.differs("f = g_k g_k+1^-1", model, full, l(other, 4), 1e-4);
    if (!exact_arithmetic<S>())
      if (model == "SO(3)") {
        // The scheme of the library, by way of a body: moments about axes.
        auto const body =
            inertia_from_lambda<3, S>(Matrix<S, 3, 1>(draw_second_moments<S>(draw, 3).diagonal()));
        Element<SO<3>, S> const turn{{}, f.value};
        claim.equal(
            "the library's scheme is h times it", model,
            S(NaturalChartScheme<3, S>(body, h).lagrangian()(turn) / h),
            S(quarter_trace(Matrix<S>(body.lambda.asDiagonal()), Matrix<S>(group.hat(log(f).coordinates))) /
              (h * h)));
      }
  });
}

STATEMENT(eq_5_4, "implicit reduced equation for the discrete angular velocity") {
  claim.convention(
      "With $\\chi$ as (3.26) prints it, $\\chi(\\ad)\\,\\iex(-\\ad) = 1$, which is the one that left "
      "translation needs, and $\\zeta$ as printed, from the later configuration to the earlier. With "
      "$\\chi$ the inverse of $\\iex$ the factor $\\Ad^*$ is one too many; with $\\zeta$ the velocity all "
      "three signs turn, and as printed the equation would run back in time. From two attitudes of the "
      "body the equation approaches its flow forwards and to second order.");
  over_groups(body_groups<S>(), claim, [&](auto const& group, auto const& model) {
    S const h = step_length<S>();
    auto const j = draw_inertia<S>(draw, group);
    KineticEnergy<S> const l{j};
    auto const z0 = draw.template velocity<S>(group), z1 = draw.template velocity<S>(group);
    Algebra<S> const x0 = h * z0, x1 = h * z1;
    auto const iex_of = [](Algebra<S> const& x) { return Matrix<S>(iex(ad_matrix(x))); };
    auto const inverse_of_iex = [&](Algebra<S> const& x) { return Matrix<S>(inverse_matrix(iex_of(x))); };
    auto const carried = [&](GroupElement<S> const& by) {
      return Vector<S>(Ad_star(by, momentum(group, Vector<S>(j * z0.coordinates))).components);
    };
    // The right side of (5.4) before J^-1, for any sign of the three arguments; chi with (3.26): the inverse
    // of iex of the opposite argument.
    auto const right_side = [&](S const& in_iex, S const& in_chi, GroupElement<S> const& by) {
      return dual_of(iex_of(in_iex * x1), dual_of(inverse_of_iex(in_chi * x0), carried(by)));
    };
    S const minus(-1), plus(1);
    auto const back = exp(minus * x0), on = exp(x0), none = identity<S>(group);
    Vector<S> const left_side = j * z1.coordinates;
    // (3.11) with the library's Lagrangian, the logarithm differentiated by dual numbers; iex takes the
    // factor of the unknown away.
    auto const residual = euler_poincare_left(natural_chart_lagrangian_left(l, h), exp(x0), exp(x1));
    Vector<S> const expected = dual_of(iex_of(minus * x1), Vector<S>(residual.components));
    S const scale = S(magnitude(j)) * (S(size_of(z0)) + S(size_of(z1)));
    claim.zero("(5.4), chi(ad) iex(-ad) = 1: its residual is that of (3.11)", model,
               Vector<S>(left_side - right_side(minus, minus, back) - expected), scale,
               10);  // iex is inverted
    claim.zero("chi iex = 1, without Ad*", model,
               Vector<S>(left_side - right_side(minus, plus, none) - expected), scale, 10);
    // Controls: chi the inverse of iex with Ad* as printed; Ad* of the other configuration; Ad* left out; iex
    // of the other sign; the same with zeta the velocity.
    claim.refutes("chi iex = 1, with Ad*", model,
                  Vector<S>(left_side - right_side(minus, plus, back) - expected), scale);
    claim.refutes("Ad* of exp(+h zeta)", model,
                  Vector<S>(left_side - right_side(minus, minus, on) - expected), scale);
    claim.refutes("Ad* left out", model, Vector<S>(left_side - right_side(minus, minus, none) - expected),
                  scale);
    claim.refutes("iex(+ad*)", model, Vector<S>(left_side - right_side(plus, minus, back) - expected), scale);
    // With z the velocity -log(f)/h: the relative motions are exp(-h z); the momenta have the other sign.
    auto const forward =
        euler_poincare_left(natural_chart_lagrangian_left(l, h), exp(minus * x0), exp(minus * x1));
    Vector<S> const wanted = dual_of(iex_of(plus * x1), Vector<S>(minus * forward.components));
    claim.zero("zeta the velocity, all signs turned", model,
               Vector<S>(left_side - right_side(plus, plus, on) - wanted), scale, 10);
    claim.refutes("zeta the velocity, signs as printed", model,
                  Vector<S>(left_side - right_side(minus, minus, back) - wanted), scale);
  });
  if (!exact_arithmetic<S>())
    // A step of the library on the algebra satisfies it: zeta from the logarithms.
    for (auto const& group : {rotation_groups()[0], rotation_groups()[1]}) {
      S const h = ratio<S>(1, 8);
      auto const j = draw_inertia<S>(draw, group);
      auto const x0 = draw.template velocity<S>(group, ratio<S>(1, 2));
      auto const x1 = step_algebra_euler_poincare_left(KineticEnergy<S>{j}, h, x0).value;
      auto const solved = [&](Algebra<S> const& at, GroupElement<S> const& by) {
        Vector<S> const mu =
            dual_of(Matrix<S>(inverse_matrix(iex(ad_matrix(-x0)))),
                    Vector<S>(Ad_star(by, momentum(group, Vector<S>(j * x0.coordinates))).components));
        return Vector<S>(solve_linear(j, dual_of(Matrix<S>(iex(ad_matrix(-at))), mu)) / h);
      };
      // Condition: J is inverted, and the solver leaves 16 epsilon of its rows.
      claim.equal("the step that solves the algorithm on the algebra", group.name(), solved(x1, exp(-x0)),
                  Vector<S>(x1.coordinates / h), 10);
      claim.differs("with Ad* left out", group.name(), solved(x1, identity<S>(group)),
                    Vector<S>(x1.coordinates / h));
    }
  if (claim.fits_orders())
    for (auto const& group :
         {spanned("SO(3)", SO<3>{}), spanned("SO(4)", SO<4>{}), spanned("Aff(1)", Aff1{})}) {
      auto const j = draw_inertia<S>(draw, group);
      BodyFlow<S> const flow(group, j);
      BodyState<S> const start{j * draw.template velocity<S>(group).coordinates,
                               draw.template element<S>(group).value};
      ChartUpdate<S> const printed{group, j, inverse_matrix(j), S(0)};
      auto twice = printed, wrong = printed;
      twice.in_chi = 1;     // chi iex = 1, and Ad* as well
      wrong.direction = 1;  // zeta the velocity, (5.4) as printed
      auto const steps = in_half_a_unit.step_lengths();
      auto const errors = errors_of_chart_update(flow, start, printed);
      claim.order("attitude against the flow of the body", group.name(), steps, errors.attitude, 2);
      claim.order("momentum against the flow of the body", group.name(), steps, errors.momentum, 2);
      claim.refutes_order("chi iex = 1 with Ad*: momentum", group.name(), steps,
                          errors_of_chart_update(flow, start, twice).momentum, 2);
      claim.refutes_order("zeta the velocity, signs as printed: it runs back", group.name(), steps,
                          errors_of_chart_update(flow, start, wrong).momentum, 2);
    }
}
