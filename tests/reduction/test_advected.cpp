// Systems with an advected vector: the equations against the unreduced ones, exactly and through the solvers,
// what is conserved, and refusals.
#include <boost/test/unit_test.hpp>

#include "actio/groups/affine_line.hpp"
#include "actio/groups/motions.hpp"
#include "actio/groups/spanned_group.hpp"
#include "actio/groups/unit_quaternions.hpp"
#include "actio/reduction/advected.hpp"
#include "actio/reduction/discrete_euler_lagrange.hpp"
#include "group_from_basis.hpp"
#include "refused.hpp"
#include "witness/draw.hpp"
#include "witness/number.hpp"
#include "witness/reference_solution.hpp"

using namespace actio;
using Vector3d = actio::Vector<double, 3>;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
template <class S>
using Column = Matrix<S, Dynamic, 1>;

using testing::from_basis;
std::vector<SpannedGroup> groups() {
  return {from_basis("SO(3)", SO<3>{}), from_basis("SE(3)", SE<3>{}), from_basis("Aff(1)", Aff1{})};
}

/// A polynomial of third degree in the entries of f and a, with no symmetry and no parity.
struct CubicLagrangian {
  Matrix<Number, Dynamic, Dynamic> u, v;
  Column<Number> w;
  CubicLagrangian(FineDraw& draw, int n) : u(n, n), v(n, n), w(draw.vector<Number>(n)) {
    for (int i = 0; i < n; ++i) u.col(i) = draw.vector<Number>(n), v.col(i) = draw.vector<Number>(n);
  }
  template <class E, class T>
  T operator()(E const& f, Column<T> const& a) const {
    T x(0), y(0), z(0);
    for (Index i = 0; i < a.size(); ++i) {
      z += a[i] * T(w[i]);
      for (Index j = 0; j < a.size(); ++j)
        x += f.value(i, j) * T(u(i, j)), y += f.value(i, j) * T(v(i, j)) * a[j];
    }
    return x * x + x * y + x * z + y + z * z * T(3);
  }
};

/// The contragredient action, on rows: what covectors do.
constexpr auto on_rows = [](auto const& g, auto const& a) {
  using A = std::decay_t<decltype(a)>;
  return A(inverse(g).value.transpose() * a);
};

/// Kinetic energy of a body without any symmetry of its own, through the natural chart, and a potential that
/// depends on the vector, by the trapezoidal rule.
struct BodyInField {
  Matrix<double> inertia;
  Vector<double> slope;
  double stiffness, h;

  template <class T>
  T potential(Column<T> const& a) const {
    T height(0);
    for (Index i = 0; i < a.size(); ++i) height += a[i] * slope[i];
    return height + height * height * (stiffness / 2);
  }
  template <class G, class T>
  T operator()(Element<G, T> const& f, Column<T> const& a) const {
    auto const w = log(f).coordinates;
    T kinetic(0);
    for (Index i = 0; i < w.size(); ++i)
      for (Index j = 0; j < w.size(); ++j) kinetic += w[i] * w[j] * inertia(i, j);
    return kinetic / (2 * h) - (potential(a) + potential(Column<T>(f.value * a))) * (h / 2);
  }
};

BodyInField random_body(Draw& draw, SpannedGroup const& group, double h) {
  int const n = group.dimension();
  BodyInField body{Matrix<double>::Identity(n, n) * (n + 1),
                   draw.vector<double, Vector<double>>(group.matrix_size()), 0.5, h};
  for (int i = 0; i < n; ++i)
    for (int j = 0; j <= i; ++j)
      body.inertia(i, j) = body.inertia(j, i) = body.inertia(i, j) + draw.number<double>();
  return body;
}

/// A generator that fixes the vector c, written out for each group.
Velocity<SpannedGroup, Number> stabiliser(SpannedGroup const& group, Column<Number> const& c) {
  auto zeta = velocity(group, Column<Number>(Column<Number>::Zero(group.dimension())));
  if (group.name() == "SO(3)") zeta.coordinates = c;
  if (group.name() == "SE(3)")  // about c as a point: turning about an axis w through c / c_4
    zeta.coordinates.head(3) = Column<Number>{{c[1], c[2], c[3]}},
    zeta.coordinates.tail(3) = -cross(zeta.coordinates.head(3).eval(), (c.head(3) / c[3]).eval());
  if (group.name() == "Aff(1)") zeta.coordinates << c[1], -c[0];
  return zeta;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(advected)

BOOST_AUTO_TEST_CASE(the_reduced_equations_are_the_unreduced_ones_exactly) {
  WithArithmetic const exactly(Arithmetic::rationals());
  FineDraw draw(11);
  for (auto const& group : groups()) {
    CubicLagrangian const l(draw, group.matrix_size());
    auto const g0 = draw.element<Number>(group), g1 = draw.element<Number>(group),
               g2 = draw.element<Number>(group);
    Column<Number> const c = draw.vector<Number>(group.matrix_size());
    auto const compare = [&](auto const& act, char const* name) {
      BOOST_TEST_CONTEXT(group.name() << ", " << name) {
        {
          auto const L = lift_advected_left(l, c, act);
          auto const f10 = relative_motion_left(g0, g1), f21 = relative_motion_left(g1, g2);
          Column<Number> const a0 = act(inverse(g0), c), a1 = advect_left(f10, a0, act);
          BOOST_TEST((a1 - act(inverse(g1), c)).isZero(0));
          auto const reduced = advected_euler_poincare_left(l, f10, a0, f21, act).components;
          BOOST_TEST((reduced - Ad_star(g1, discrete_euler_lagrange(L, g0, g1, g2)).components).isZero(0));
          auto const before = advected_momentum_before_left(l, f10, a0, act),
                     after = advected_momentum_after_left(l, f10, a0);
          BOOST_TEST((before + Ad_star(g0, D1(L, g0, g1))).components.isZero(0));
          BOOST_TEST((after - Ad_star(g1, D2(L, g0, g1))).components.isZero(0));
          BOOST_TEST(
              (after - advected_lie_poisson_update_left(l, f10, a0, before, act)).components.isZero(0));
          // Controls: a vector that is not advected, and a momentum without the term of the vector.
          BOOST_TEST(!(reduced - (advected_momentum_after_left(l, f10, a0) -
                                  advected_momentum_before_left(l, f21, a0, act))
                                     .components)
                          .isZero(0));
          BOOST_TEST(!(after - Ad_star(inverse(f10), before)).components.isZero(0));
        }
        {
          auto const L = lift_advected_right(l, c, act);
          auto const f01 = relative_motion_right(g0, g1), f12 = relative_motion_right(g1, g2);
          Column<Number> const a0 = act(g0, c), a1 = advect_right(f01, a0, act);
          BOOST_TEST((a1 - act(g1, c)).isZero(0));
          auto const reduced = advected_euler_poincare_right(l, f01, a0, f12, act);
          BOOST_TEST((reduced - discrete_euler_lagrange(L, g0, g1, g2)).components.isZero(0));
          auto const before = advected_momentum_before_right(l, f01, a0, act),
                     after = advected_momentum_after_right(l, f01, a0);
          BOOST_TEST((before + D1(L, g0, g1)).components.isZero(0));
          BOOST_TEST((after - D2(L, g0, g1)).components.isZero(0));
          BOOST_TEST(
              (after - advected_lie_poisson_update_right(l, f01, a0, before, act)).components.isZero(0));
          BOOST_TEST(
              !(reduced - (after - advected_momentum_before_right(l, f12, a0, act))).components.isZero(0));
        }
      }
    };
    compare(MatrixAction{}, "columns");
    compare(on_rows, "rows");
  }
}

BOOST_AUTO_TEST_CASE(what_fixes_the_vector_has_the_same_momentum_at_both_ends_of_a_step_exactly) {
  WithArithmetic const exactly(Arithmetic::rationals());
  FineDraw draw(12);
  for (auto const& group : groups()) BOOST_TEST_CONTEXT(group.name()) {
      CubicLagrangian const l(draw, group.matrix_size());
      auto const f = draw.element<Number>(group);
      Column<Number> const a0 = draw.vector<Number>(group.matrix_size()), a1 = advect_left(f, a0);
      auto const zeta = stabiliser(group, a0);
      BOOST_TEST(Column<Number>(group.hat(zeta.coordinates) * a0).isZero(0));
      BOOST_TEST(!zeta.coordinates.isZero(0));
      BOOST_TEST(Column<Number>(group.hat(Ad(f, zeta).coordinates) * a1).isZero(0));
      auto const left = pair(advected_momentum_before_left(l, f, a0), zeta);
      BOOST_TEST((left == pair(advected_momentum_after_left(l, f, a0), Ad(f, zeta))));
      auto const right = pair(advected_momentum_before_right(l, f, a0), zeta);
      BOOST_TEST((right == pair(advected_momentum_after_right(l, f, a0), Ad(inverse(f), zeta))));
      // Controls: transported by the inverse, and a generator that moves the vector.
      BOOST_TEST((left != pair(advected_momentum_after_left(l, f, a0), Ad(inverse(f), zeta))));
      auto const other = draw.velocity<Number>(group);
      BOOST_TEST((pair(advected_momentum_before_left(l, f, a0), other) !=
                  pair(advected_momentum_after_left(l, f, a0), Ad(f, other))));
    }
}

BOOST_AUTO_TEST_CASE(a_step_is_a_coadjoint_action_of_the_semidirect_product_exactly) {
  WithArithmetic const exactly(Arithmetic::rationals());
  // G with shifts by covectors, as matrices ((g^-T, v), (0, 1)): a step is the action of k = f (1, dl/da).
  FineDraw draw(16);
  for (auto const& group : groups()) BOOST_TEST_CONTEXT(group.name()) {
      int const n = group.matrix_size(), d = group.dimension();
      std::vector<SpannedGroup::WholeMatrix> basis(d + n, SpannedGroup::WholeMatrix::Zero(n + 1, n + 1));
      for (int a = 0; a < d; ++a)
        basis[a].topLeftCorner(n, n) =
            -group.hat(Vector<double>(Vector<double>::Unit(d, a))).cast<int>().transpose();
      for (int i = 0; i < n; ++i) basis[d + i](i, n) = 1;
      SpannedGroup const product("semidirect product", basis);

      CubicLagrangian const l(draw, n);
      auto const f = draw.element<Number>(group);
      Column<Number> const a0 = draw.vector<Number>(n);
      auto k = identity<Number>(product);
      k.value.topLeftCorner(n, n) = inverse(f).value.transpose();
      Column<Number> slope(n);
      for (int i = 0; i < n; ++i) {
        Column<Moved<Number>> moved = a0.cast<Moved<Number>>();
        moved[i].part[0] = 1;
        slope[i] = l(over<Moved<Number>>(f), moved).part[0];
      }
      k.value.topRightCorner(n, 1) = k.value.topLeftCorner(n, n) * slope;

      Column<Number> before(d + n), after(d + n);
      before << advected_momentum_before_left(l, f, a0).components, a0;
      after << advected_momentum_after_left(l, f, a0).components, advect_left(f, a0);
      BOOST_TEST((Ad_star(inverse(k), momentum(product, before)).components - after).isZero(0));
      // Control: shifted the other way.
      k.value.topRightCorner(n, 1) *= Number(-1);
      BOOST_TEST(!(Ad_star(inverse(k), momentum(product, before)).components - after).isZero(0));
    }
}

BOOST_AUTO_TEST_CASE(both_ways_lead_to_the_same_configurations) {
  Draw draw(13);
  double const h = 0.05;
  int const steps = 20;
  for (auto const& group : groups()) BOOST_TEST_CONTEXT(group.name()) {
      auto const l = random_body(draw, group, h);
      Column<double> const c = draw.vector<double>(group.matrix_size());
      auto const L = lift_advected_left(l, c);
      auto before = draw.element<double>(group),
           configuration = before * exp(h * draw.velocity<double>(group)), reduced = configuration;
      auto f = relative_motion_left(before, configuration);
      Column<double> a = inverse(before).value * c;
      for (int k = 0; k < steps; ++k) {
        auto const full = step_euler_lagrange(L, before, configuration);
        auto const half = step_advected_euler_poincare_left(l, f, a);
        BOOST_TEST(half.report.evaluations <= 4);
        before = configuration, configuration = full.value;
        a = advect_left(f, a), f = half.value, reduced = reconstruct_left(reduced, f);
      }
      // A relative motion is found to 16 eps, so its velocity, and the momentum, to 16 eps/h; Ad of a
      // configuration of this size magnifies that a few times.
      double const bound = 4 * 16 * eps / h * steps;
      BOOST_TEST(magnitude((configuration.value - reduced.value).eval()) <=
                 bound * magnitude(configuration.value));
      BOOST_TEST(magnitude((inverse(before).value * c - a).eval()) <= bound * magnitude(a));
    }
}

BOOST_AUTO_TEST_CASE(both_ways_lead_to_the_same_configurations_from_the_right) {
  Draw draw(14);
  double const h = 0.05;
  int const steps = 10;
  for (auto const& group : groups()) BOOST_TEST_CONTEXT(group.name()) {
      auto const l = random_body(draw, group, h);
      Column<double> const c = draw.vector<double>(group.matrix_size());
      auto const L = lift_advected_right(l, c);
      auto before = draw.element<double>(group),
           configuration = exp(h * draw.velocity<double>(group)) * before, reduced = configuration;
      auto f = relative_motion_right(before, configuration);
      Column<double> a = before.value * c;
      for (int k = 0; k < steps; ++k) {
        auto const next = step_euler_lagrange(L, before, configuration).value;
        auto const half = step_advected_euler_poincare_right(l, f, a).value;
        before = configuration, configuration = next;
        a = advect_right(f, a), f = half, reduced = reconstruct_right(reduced, f);
      }
      double const bound = 4 * 16 * eps / h * steps;
      BOOST_TEST(magnitude((configuration.value - reduced.value).eval()) <=
                 bound * magnitude(configuration.value));
    }
}

BOOST_AUTO_TEST_CASE(a_ship_under_water_rights_itself_as_its_equations_say) {
  // As heavy as the water it displaces, its weight below the middle: Kirchhoff's equations with a righting
  // torque. The vertical is the vector, with a zero for its fourth component.
  auto const group = from_basis("SE(3)", SE<3>{});
  Matrix<double, 6, 1> inertia, moving;
  inertia << 2, 3, 4, 5, 7, 9;
  moving << 0.4, -0.3, 0.5, 0.6, 0.2, -0.1;
  Vector3d const down(0.2, 0.1, -0.8), vertical(0.6, 0, 0.8);
  using State = Matrix<double, 9, 1>;
  State start;
  start << inertia.cwiseProduct(moving), vertical;
  auto const rate = [&](double, State const& y) {
    Vector3d const M = y.head<3>(), P = y.segment<3>(3), up = y.tail<3>(),
                   W = M.cwiseQuotient(inertia.head<3>()), V = P.cwiseQuotient(inertia.tail<3>());
    State d;
    d << cross(M, W) + cross(P, V) + cross(up, down), cross(P, W), cross(up, W);
    return d;
  };
  double const duration = 1;
  State const truth = reference_solution(rate, start, 0, duration);
  std::vector<double> errors;
  for (int const count : {10, 20, 40, 80, 160}) {
    double const h = duration / count;
    BodyInField const l{inertia.asDiagonal(), Vector<double, 4>(down[0], down[1], down[2], 0), 0, h};
    auto pi = momentum(group, Column<double>(start.head<6>()));
    Column<double> a(4);
    a << vertical, 0;
    auto f = exp(velocity(group, Column<double>(-h * moving)));
    double const casimir = pi.components.tail<3>().dot(a.head<3>());
    for (int k = 0; k < count; ++k) {
      f = advected_relative_motion_left(l, pi, a, f).value;
      pi = advected_momentum_after_left(l, f, a), a = advect_left(f, a);
    }
    State end;
    end << pi.components, a.head<3>();
    errors.push_back((end - truth).norm());
    // All translations fix the vertical, so the momentum of gliding along it stays: one step of the solver
    // after the other leaves 16 eps/h.
    BOOST_TEST(std::abs(pi.components.tail<3>().dot(a.head<3>()) - casimir) <=
               16 * eps / h * count * inertia.maxCoeff());
  }
  // The order between the two finest steps. The error has even powers of h only, so the slope is off by a few
  // h^2.
  double const order = std::log2(errors[3] / errors[4]);
  BOOST_TEST_MESSAGE("ship under water: errors " << errors[0] << " ... " << errors[4] << ", order " << order);
  BOOST_TEST(std::abs(order - 2) < 0.05);
}

BOOST_AUTO_TEST_CASE(quaternions_carry_a_vector_as_matrices_do) {
  // No matrices to multiply by: the action is the adjoint one.
  double const h = 0.1;
  auto const turned = [](auto const& g, auto const& a) { return Ad(g, velocity(g.group, a)).coordinates; };
  auto const l = [&](auto const& q, auto const& a) {
    auto const w = log(q).coordinates, moved = turned(q, a);
    return (w[0] * w[0] + w[1] * w[1] * 2 + w[2] * w[2] * 3) / (2 * h) -
           (a[0] + a[2] * 2 + moved[0] + moved[2] * 2) * (h / 2);
  };
  BodyInField const by_matrices{Vector<double, 3>(1, 2, 3).asDiagonal(), Vector3d(1, 0, 2), 0, h};
  Vector3d const turn(-0.03, 0.05, -0.1), vertical(0.6, 0, 0.8);
  auto f = exp(velocity(from_basis("SO(3)", SO<3>{}), Column<double>(turn)));
  auto q = exp(velocity(SU2{}, turn));
  Column<double> a = vertical;
  Vector3d b = vertical;
  int const steps = 20;
  for (int k = 0; k < steps; ++k) {
    auto const next_f = step_advected_euler_poincare_left(by_matrices, f, a).value;
    auto const next_q = step_advected_euler_poincare_left(l, q, b, turned).value;
    a = advect_left(f, a), b = advect_left(q, b, turned), f = next_f, q = next_q;
  }
  BOOST_TEST((a - b).norm() <= 4 * 16 * eps / h * steps);
  BOOST_TEST((log(f).coordinates - log(q).coordinates).norm() <= 4 * 16 * eps * steps);
}

BOOST_AUTO_TEST_CASE(what_makes_no_sense_is_refused) {
  Draw draw(15);
  auto const group = from_basis("SO(3)", SO<3>{});
  auto const l = random_body(draw, group, 0.1);
  auto const f = exp(draw.velocity<double>(group, 0.1));
  Column<double> const a = draw.vector<double>(3), longer = draw.vector<double>(4);
  for (double const bad : {std::nan(""), HUGE_VAL}) {
    Column<double> broken = a;
    broken[1] = bad;
    CHECK_REFUSED(step_advected_euler_poincare_left(l, f, broken), NotFinite);
    CHECK_REFUSED(step_advected_euler_poincare_right(l, f, broken), NotFinite);
    CHECK_REFUSED(advected_relative_motion_left(l, momentum(group, broken), a, f), NotFinite);
    CHECK_REFUSED(advected_relative_motion_right(l, momentum(group, broken), a, f), NotFinite);
  }
  BOOST_CHECK_EXCEPTION(advect_left(f, longer), OutsideDomain,
                        [](OutsideDomain const& e) { return e.measured == 4 && e.bound == 3; });
  // No inertia about one axis: nothing says how fast it turns there.
  auto flat = l;
  flat.inertia = Vector<double, 3>(1, 2, 0).asDiagonal();
  flat.slope.setZero();
  CHECK_REFUSED(advected_relative_motion_left(flat, momentum(group, Column<double>(Vector3d(0, 0, 1))), a,
                                              identity<double>(group)),
                Singular);
}

BOOST_AUTO_TEST_SUITE_END()
