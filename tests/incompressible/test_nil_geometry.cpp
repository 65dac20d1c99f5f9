// Fluids in a space whose metric is neither diagonal nor flat, exactly over the rationals: the group of
// Heisenberg with the metric dx^2 + dy^2 + (dz - x dy)^2, on which everything is known from its frame e_1 =
// d/dx, e_2 = d/dy + x d/dz, e_3 = d/dz with [e_1, e_2] = e_3.
#include <boost/test/unit_test.hpp>

#include "actio/incompressible/bracket_of_fields.hpp"
#include "actio/incompressible/ideal_fluid.hpp"
#include "actio/incompressible/volume_constraint.hpp"
#include "witness/number.hpp"

using namespace actio;

namespace {

using Q = Number;
template <class T>
using Column = Matrix<T, 3, 1>;
template <class V>
using ScalarOf = typename std::remove_cvref_t<V>::Scalar;

struct Nil {
  template <class V>
  auto operator()(V const& y) const {
    using T = typename V::Scalar;
    Matrix<T, 3, 3> g;
    g << T(1), T(0), T(0), T(0), T(1) + y[0] * y[0], -y[0], T(0), -y[0], T(1);
    return g;
  }
};
/// a e_1 + b e_2 + c e_3 at a place, or at a time and a place.
template <class T, class V>
Column<T> in_frame(V const& at, T const& a, T const& b, T const& c) {
  T const x = at.template tail<3>()[0];
  return {a, b, T(c + x * b)};
}

}  // namespace

/// What is calculated over the rationals: a place, and a time with it.
struct OverTheRationals {
  WithArithmetic const exactly{Arithmetic::rationals()};
  Column<Q> const y{Q(3) / 2, Q(-2) / 3, Q(5) / 7};
  Matrix<Q, 4, 1> const at{Q(1) / 3, y[0], y[1], y[2]};
};

BOOST_FIXTURE_TEST_SUITE(nil_geometry, OverTheRationals)

BOOST_AUTO_TEST_CASE(its_frame_is_orthonormal_and_its_volume_is_one) {
  auto const g = Nil{}(y);
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) {
      auto const e = [&](int n) { return in_frame<Q>(y, Q(n == 0), Q(n == 1), Q(n == 2)); };
      BOOST_TEST((inner(g, e(i), e(k)) == Q(i == k)));
      BOOST_TEST((inner(g, e(i), Column<Q>(raised(g, Column<Q>(Q(1), Q(2), Q(3))))) ==
                  e(i).dot(Column<Q>(Q(1), Q(2), Q(3)))));
    }
  BOOST_TEST((volume(g) == Q(1)));
}

BOOST_AUTO_TEST_CASE(its_frame_has_the_known_brackets_and_derivatives) {
  auto const e = [](int n) {
    return
        [n]<class T>(Column<T> const& z) { return in_frame<T>(z, T(Q(n == 0)), T(Q(n == 1)), T(Q(n == 2))); };
  };
  BOOST_TEST((jacobi_lie_bracket(e(0), e(1))(y) == e(2)(y)));
  BOOST_TEST((diffeomorphism_bracket(e(1), e(0))(y) == e(2)(y)));
  BOOST_TEST((jacobi_lie_bracket(e(0), e(2))(y) == Column<Q>::Zero()));
  // Koszul: the derivatives of e_1 along e_2 and of e_2 along e_1 are -e_3/2 and e_3/2; of e_3 along e_1, and
  // of e_1 along e_3, -e_2/2; of e_3 along e_2, and of e_2 along e_3, e_1/2.
  auto const along = [&](int i, int k) {
    Column<Q> const u = e(i)(y), w = e(k)(y);
    return Column<Q>(derivative_along(e(k), y, u).rate + connection(Nil{}, y, u, w));
  };
  Q const half = Q(1) / 2;
  BOOST_TEST((along(0, 1) == Column<Q>(e(2)(y) * half)));
  BOOST_TEST((along(1, 0) == Column<Q>(e(2)(y) * Q(-half))));
  BOOST_TEST((along(0, 2) == Column<Q>(e(1)(y) * Q(-half))));
  BOOST_TEST((along(2, 0) == Column<Q>(e(1)(y) * Q(-half))));
  BOOST_TEST((along(1, 2) == Column<Q>(e(0)(y) * half)));
  BOOST_TEST((along(2, 1) == Column<Q>(e(0)(y) * half)));
  for (int i = 0; i < 3; ++i) BOOST_TEST((along(i, i) == Column<Q>::Zero()));
}

BOOST_AUTO_TEST_CASE(its_curvature_is_the_known_one) {
  // Ricci's tensor is -1/2 on e_1 and e_2, and 1/2 on e_3.
  auto const ricci = ricci_tensor(Nil{}, y);
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) {
      auto const e = [&](int n) { return in_frame<Q>(y, Q(n == 0), Q(n == 1), Q(n == 2)); };
      Q const known = i != k ? Q(0) : i == 2 ? Q(1) / 2 : Q(-1) / 2;
      BOOST_TEST((inner(ricci, e(i), e(k)) == known), i << ", " << k);
    }
}

BOOST_AUTO_TEST_CASE(a_fluid_in_it_has_the_acceleration_of_its_frame) {
  // u = f e_1 + t e_2 + c e_3 with f = y z + x^2 and c = 2:
  // its derivative along itself is (u f + t c) e_1 - f c e_2, of which t e_2 and its rate add e_2.
  auto const f = [](auto const& p) { return ScalarOf<decltype(p)>(p[2] * p[3] + p[1] * p[1]); };
  auto const u = [&]<class T>(Matrix<T, 4, 1> const& p) { return in_frame<T>(p, f(p), p[0], T(Q(2))); };
  Q const x = at[1], t = at[0], c = 2, f_x = 2 * x, f_y = at[3], f_z = at[2],
          along = f(at) * f_x + t * (f_y + x * f_z) + c * f_z;
  Column<Q> const advected = in_frame<Q>(at, along + t * c, -f(at) * c, Q(0));
  BOOST_TEST((self_advection(Nil{}, u, at) == advected));
  BOOST_TEST(
      (eulerian_acceleration(Nil{}, u, at) == Column<Q>(advected + in_frame<Q>(at, Q(0), Q(1), Q(0)))));
  BOOST_TEST((divergence(Nil{}, u, at) == f_x));
  // Through the wall x + y z: its slope is (1, z, y).
  auto const wall = []<class T>(Column<T> const& p) { return T(p[0] + p[1] * p[2]); };
  BOOST_TEST((pressure_slope_at_wall(Nil{}, u, wall, at) ==
              -Column<Q>(Q(1), at[3], at[2]).dot(eulerian_acceleration(Nil{}, u, at))));
}

BOOST_AUTO_TEST_CASE(its_divergences_and_laplacians_are_derivatives_along_the_frame) {
  // The frame has no divergence: of a e_1 + b e_2 it is e_1 a + e_2 b, and of a gradient the sum of e_i e_i
  // p.
  auto const u = []<class T>(Matrix<T, 4, 1> const& p) {
    return in_frame<T>(p, T(p[1] * p[1] * p[3]), T(p[2] * p[3] * p[0]), T(p[3] * p[1]));
  };
  Q const t = at[0], x = y[0], z = y[2];
  BOOST_TEST((divergence(Nil{}, u, at) == 2 * x * z + t * z + x * t * y[1] + x));
  auto const p = []<class T>(Matrix<T, 4, 1> const& q) {
    return T(q[1] * q[1] * q[3] + q[2] * q[3] * q[3] * q[0]);
  };
  // p = x^2 z + t y z^2: e_1 e_1 p = 2 z, e_2 p = t z^2 + x (x^2 + 2 t y z), e_3 e_3 p = 2 t y.
  Q const e2e2 = 2 * t * x * z + x * (2 * t * z + x * 2 * t * y[1]);
  BOOST_TEST((laplacian(Nil{}, p, at) == 2 * z + e2e2 + 2 * t * y[1]));
  Q const e1 = 2 * x * z, e3 = x * x + 2 * t * y[1] * z, e2 = t * z * z + x * e3;
  BOOST_TEST((gradient(Nil{}, p, at) == in_frame<Q>(at, e1, e2, e3)));
  // Of u = f e_1 with f = x y the advection is f f_x e_1 = x y^2 e_1.
  auto const along_one = []<class T>(Matrix<T, 4, 1> const& q) {
    return in_frame<T>(q, T(q[1] * q[2]), T(Q(0)), T(Q(0)));
  };
  BOOST_TEST((pressure_source(Nil{}, along_one, at) == -y[1] * y[1]));
}

BOOST_AUTO_TEST_CASE(its_motions_preserve_it_and_a_shift_along_x_does_not) {
  auto const up = []<class T>(Column<T> const&) { return Column<T>(T(Q(0)), T(Q(0)), T(Q(1))); };
  auto const turn = []<class T>(Column<T> const& p) { return Column<T>(T(Q(1)), T(Q(0)), p[1]); };
  auto const shift = []<class T>(Column<T> const&) { return Column<T>(T(Q(1)), T(Q(0)), T(Q(0))); };
  BOOST_TEST((lie_derivative(Nil{}, up, y) == Matrix<Q, 3, 3>::Zero()));
  BOOST_TEST((lie_derivative(Nil{}, turn, y) == Matrix<Q, 3, 3>::Zero()));
  // Of (dz - x dy)^2 along x: -dy (dz - x dy) twice.
  Matrix<Q, 3, 3> known;
  known << 0, 0, 0, 0, 2 * y[0], -1, 0, -1, 0;
  BOOST_TEST((lie_derivative(Nil{}, shift, y) == known));
}

BOOST_AUTO_TEST_SUITE_END()
