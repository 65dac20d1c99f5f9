// Logarithms of rotations: angles from sine and cosine, rotation vectors through unit quaternions.
//
// The vector part of the quaternion has the axis to rounding at every angle, so the logarithm is as good next
// to pi as it is next to zero; rotations of 4-space are pairs of quaternions, those of larger spaces fall
// apart into turns of planes. At pi itself the rotation vector has no sign: the natural chart (3.19) ends
// there and the functions refuse.
#pragma once

#include <cmath>

#include "actio/groups/matrix_group.hpp"
#include "actio/linear_algebra/schur_form.hpp"

namespace actio {

/// How near to the edge of the chart is too near: half a turn, up to the rounding that a product of two
/// rotations brings.
template <class S>
Base<S> edge_of_chart() { return Base<S>(8) * epsilon<S>(); }

/// The angle with the given sine and cosine (up to a common positive factor), in (-pi, pi).
/// @param edge  how near to pi is too near
/// @throws OutsideDomain  at pi
template <Real S>
S angle_of_rotation(S const& sine, S const& cosine, Base<S> const& edge = edge_of_chart<S>()) {
  using std::atan2;
  if (!is_finite(base_value(sine)) || !is_finite(base_value(cosine))) throw NotFinite("log");
  Base<S> const s = magnitude(base_value(sine)), c = base_value(cosine);
  if (c < Base<S>(0) && s <= edge * -c)
    throw OutsideDomain("log", "rotation angle reaches pi; the natural chart needs less (3.19)", M_PI, M_PI);
  return atan2(sine, cosine);
}

/// A unit quaternion (scalar first) of a rotation matrix, with scalar part not negative; by its largest
/// component, so that nothing cancels.
template <Real S>
actio::Matrix<S, 4, 1> quaternion_of_rotation(actio::Matrix<S, 3, 3> const& r) {
  using std::sqrt;
  require_finite(r, "quaternion_of_rotation");
  actio::Matrix<S, 4, 1> q;
  S const trace = r(0, 0) + r(1, 1) + r(2, 2);
  int i = 0;
  if (r(1, 1) > r(i, i)) i = 1;
  if (r(2, 2) > r(i, i)) i = 2;
  if (trace > r(i, i)) {
    S const w = sqrt(S(trace + S(1)));
    S const scale = S(1) / (w + w);
    q << w / S(2), (r(2, 1) - r(1, 2)) * scale, (r(0, 2) - r(2, 0)) * scale, (r(1, 0) - r(0, 1)) * scale;
  } else {
    int const j = (i + 1) % 3, k = (i + 2) % 3;
    S const w = sqrt(S(S(1) + r(i, i) - r(j, j) - r(k, k)));
    S const scale = S(1) / (w + w);
    q[0] = (r(k, j) - r(j, k)) * scale;
    q[1 + i] = w / S(2);
    q[1 + j] = (r(j, i) + r(i, j)) * scale;
    q[1 + k] = (r(k, i) + r(i, k)) * scale;
  }
  if (q[0] < S(0)) q = -q;
  return q;
}

/// The rotation vector (axis times angle, below pi) of a unit quaternion with scalar part not negative.
/// @throws OutsideDomain  at a rotation by pi
template <Real S>
actio::Matrix<S, 3, 1> rotation_vector(actio::Matrix<S, 4, 1> const& q) {
  using std::atan2, std::sqrt;
  actio::Matrix<S, 3, 1> const v = q.template tail<3>();
  S const square = v.squaredNorm();
  if (base_value(square) < Base<S>(1) / Base<S>(4)) return v * (asinc_derivative<0>(square) * Base<S>(2));
  if (base_value(q[0]) <= edge_of_chart<S>())
    throw OutsideDomain("log", "rotation angle reaches pi; the natural chart needs less (3.19)",
                        M_PI - 2 * to_double(q[0]), M_PI);
  S const sine = sqrt(square);
  return v * (atan2(sine, q[0]) * Base<S>(2) / sine);
}

/// The rotation vector of a rotation matrix of 3-space.
/// @throws OutsideDomain  at a rotation by pi
template <Real S>
actio::Matrix<S, 3, 1> rotation_vector(actio::Matrix<S, 3, 3> const& r) {
  require_finite(r, "log");
  if (base_value(r(0, 0)) + base_value(r(1, 1)) + base_value(r(2, 2)) > Base<S>(2)) {
    // Below 30 degrees the skew part, the sine times the axis, is enough: no root, no division.
    actio::Matrix<S, 3, 1> const v{(r(2, 1) - r(1, 2)) / 2, (r(0, 2) - r(2, 0)) / 2, (r(1, 0) - r(0, 1)) / 2};
    S const square = v.squaredNorm();
    if (base_value(square) < ratio<Base<S>>(1, 4)) return v * asinc_derivative<0>(square);
  }
  return rotation_vector(quaternion_of_rotation(r));
}

/// The logarithm of a unit quaternion, of q itself and not of the rotation it covers: v with q = (cos(|v|/2),
/// sin(|v|/2) v/|v|), |v| below 2 pi.
/// @throws OutsideDomain  at q = -1
template <Real S>
actio::Matrix<S, 3, 1> quaternion_logarithm(actio::Matrix<S, 4, 1> const& q) {
  using std::atan2, std::sqrt;
  require_finite(q, "log");
  actio::Matrix<S, 3, 1> const v = q.template tail<3>();
  S const square = v.squaredNorm();
  bool const front = base_value(q[0]) > Base<S>(0);
  if (front && base_value(square) < ratio<Base<S>>(1, 4))
    return v * (asinc_derivative<0>(square) * Base<S>(2));
  S const sine = sqrt(square);
  if (!front && base_value(sine) <= edge_of_chart<S>())
    throw OutsideDomain("log",
                        "a quaternion other than -1 is needed, the natural chart ends there (3.19); angle",
                        2 * M_PI, 2 * M_PI);
  return v * (atan2(sine, q[0]) * Base<S>(2) / sine);
}

/// The sign in \f$e_a e_b = \pm e_{a\oplus b}\f$ of the quaternion units 1, i, j, k, where the sum of indices
/// is without carry.
constexpr int unit_sign(int a, int b) {
  constexpr int sign[4][4] = {{1, 1, 1, 1}, {1, -1, 1, -1}, {1, -1, -1, 1}, {1, 1, -1, -1}};
  return sign[a][b];
}

/// The exponential of a skew matrix of 4-space, at any scalar: \f$e^Ax = e^a\,x\,e^{-b}\f$ with the
/// quaternions of \f$Ax = a\,x - x\,b\f$.
template <Real S>
actio::Matrix<S, 4, 4> rotation_exponential(actio::Matrix<S, 4, 4> const& A) {
  auto const half_turn = [](S const& x, S const& y, S const& z) {
    S const square = (x * x + y * y + z * z) / 4, sine = stumpff<1>(square) / 2;
    return actio::Matrix<S, 4, 1>{stumpff<0>(square), x * sine, y * sine, z * sine};
  };
  auto const p = half_turn(A(3, 2) + A(1, 0), A(1, 3) + A(2, 0), A(2, 1) + A(3, 0));
  auto const q = half_turn(A(3, 2) - A(1, 0), A(1, 3) - A(2, 0), A(2, 1) - A(3, 0));
  // The product with p from the left, and with the conjugate of q from the right.
  actio::Matrix<S, 4, 4> left, right;
  left << p[0], -p[1], -p[2], -p[3], p[1], p[0], -p[3], p[2], p[2], p[3], p[0], -p[1], p[3], -p[2], p[1],
      p[0];
  right << q[0], q[1], q[2], q[3], -q[1], q[0], -q[3], q[2], -q[2], q[3], q[0], -q[1], -q[3], -q[2], q[1],
      q[0];
  return left * right;
}

/// The skew matrix of 4-space \f$Ax = a\,x - x\,b\f$ of two quaternions without scalar part.
template <class S>
actio::Matrix<S, 4, 4> skew_of_quaternions(actio::Matrix<S, 3, 1> const& a, actio::Matrix<S, 3, 1> const& b) {
  actio::Matrix<S, 3, 1> const outer = a - b, lower = a + b;
  actio::Matrix<S, 4, 4> A = actio::Matrix<S, 4, 4>::Zero();
  A(1, 0) = outer[0], A(2, 0) = outer[1], A(3, 0) = outer[2], A(0, 1) = -outer[0], A(0, 2) = -outer[1],
       A(0, 3) = -outer[2];
  A(3, 2) = lower[0], A(1, 3) = lower[1], A(2, 1) = lower[2], A(2, 3) = -lower[0], A(3, 1) = -lower[1],
       A(1, 2) = -lower[2];
  return A;
}

namespace detail {

/// Two unit quaternions that make the rotation \f$x\mapsto p\,x\,\bar q\f$ of 4-space, as their opposites do.
template <class S>
struct QuaternionPair {
  actio::Matrix<S, 4, 1> p, q;
};

/// Of a rotation of 4-space by less than about 60 degrees, near one and one. Its skew part is
/// \f$x\mapsto q_0\,a\,x - x\,b\,p_0\f$ with the vector parts a of p and b of q, its trace 4 p_0 q_0.
/// @param scalars  a quarter of the trace
template <Real S>
QuaternionPair<S> pair_near_identity(actio::Matrix<S, 4, 4> const& r, S const& scalars) {
  using std::sqrt;
  actio::Matrix<S, 3, 1> const lower{r(3, 2) - r(2, 3), r(1, 3) - r(3, 1), r(2, 1) - r(1, 2)},
      outer{r(1, 0) - r(0, 1), r(2, 0) - r(0, 2), r(3, 0) - r(0, 3)};
  actio::Matrix<S, 3, 1> a = (lower + outer) / S(4), b = (lower - outer) / S(4);
  S const p0 = sqrt(S(scalars * scalars + b.squaredNorm())),
          q0 = sqrt(S(scalars * scalars + a.squaredNorm()));
  a /= q0, b /= p0;
  return {{p0, a[0], a[1], a[2]}, {q0, b[0], b[1], b[2]}};
}

/// Of any rotation of 4-space, from the products p_a q_b: the parts of R along the sixteen maps x -> e_a x
/// conj(e_b), which are orthogonal. The row and the column of the largest will do.
template <Real S>
QuaternionPair<S> pair_by_products(actio::Matrix<S, 4, 4> const& r) {
  using std::sqrt;
  using T = Base<S>;
  auto const product = [&](int a, int b, auto const& entry) {
    auto sum = entry(a ^ b, 0);
    if (unit_sign(a, b) * (b == 0 ? 1 : -1) < 0) sum = -sum;
    for (int j = 1; j < 4; ++j) {
      if (unit_sign(a, j) * unit_sign(a ^ j, b) * (b == 0 ? 1 : -1) > 0)
        sum += entry(a ^ j ^ b, j);
      else
        sum -= entry(a ^ j ^ b, j);
    }
    return sum;
  };
  int row = 0, column = 0;
  T largest(-1);
  for (int a = 0; a < 4; ++a)
    for (int b = 0; b < 4; ++b) {
      T const size = magnitude(T(product(a, b, [&](int i, int j) { return base_value(r(i, j)); })));
      if (size > largest) largest = size, row = a, column = b;
    }
  actio::Matrix<S, 4, 1> p, q;
  for (int a = 0; a < 4; ++a) {
    p[a] = product(a, column, [&](int i, int j) { return r(i, j); });
    q[a] = product(row, a, [&](int i, int j) { return r(i, j); });
  }
  if (p[row] < S(0)) q = -q;
  p *= S(S(1) / S(sqrt(S(p.squaredNorm()))));
  q *= S(S(1) / S(sqrt(S(q.squaredNorm()))));
  return {p, q};
}

}  // namespace detail

/// The logarithm of a rotation of 4-space, at any scalar, through the pair of unit quaternions with
/// \f$Rx = p\,x\,\bar q\f$.
///
/// The angles of p and q are half the sum and half the difference of those of R. Of the pairs (p, q) and (-p,
/// -q) the logarithm takes the one whose angles add up to less than pi.
/// @throws OutsideDomain  where one of the angles of R is pi
template <Real S>
actio::Matrix<S, 4, 4> rotation_logarithm(actio::Matrix<S, 4, 4> const& r) {
  using std::sqrt;
  using T = Base<S>;
  require_finite(r, "log");
  // A x = a x - x b with a = log p and b = log q.
  auto const of_quaternions = [](auto const& p, auto const& q) {
    actio::Matrix<S, 3, 1> const a = quaternion_logarithm(p) / S(2), b = quaternion_logarithm(q) / S(2);
    return skew_of_quaternions<S>(a, b);
  };
  S const scalars = (r(0, 0) + r(1, 1) + r(2, 2) + r(3, 3)) / 4;
  if (base_value(scalars) > ratio<T>(3, 4)) {
    auto const [p, q] = detail::pair_near_identity(r, scalars);
    return of_quaternions(p, q);
  }
  auto [p, q] = detail::pair_by_products(r);

  // The sine of the sum of their angles tells which pair, even where both angles of R come near to pi.
  auto const vector_part = [](auto const& x) {
    return T(sqrt(T(base_value(x[1]) * base_value(x[1]) + base_value(x[2]) * base_value(x[2]) +
                    base_value(x[3]) * base_value(x[3]))));
  };
  T const vp = vector_part(p), vq = vector_part(q);
  T sine = vp * base_value(q[0]) + vq * base_value(p[0]);
  if (sine < T(0) || (sine == T(0) && base_value(p[0]) < T(0))) p = -p, q = -q, sine = -sine;
  angle_of_rotation(sine, T(base_value(p[0]) * base_value(q[0]) - vp * vq), T(2) * edge_of_chart<S>());

  return of_quaternions(p, q);
}

/// The logarithm of a rotation of n-space, n > 4, for plain scalars.
///
/// Away from the identity the rotation is split into turns of orthogonal planes by its real Schur form, which
/// is block diagonal because rotations are normal; each angle comes from its sine and cosine. Equal angles,
/// planes at rest and angles next to pi need no care of their own.
/// @throws OutsideDomain  where one of the angles is pi
/// Accuracy: the exponential of the result is r to a few tens of epsilon. Two angles within d of pi magnify
/// that by 1/d, as they do in any algorithm: the logarithm is not differentiable where both reach it.
template <Real S, int n>
  requires(n > 4)
actio::Matrix<S, n, n> rotation_logarithm(actio::Matrix<S, n, n> const& r) {
  static_assert(Plain<S>,
                "over dual numbers the derivative of the logarithm is known: primitive::lifted_log");
  // One size for the compiler: a Schur form of each fixed size would take it many seconds.
  using Matrix = actio::Matrix<S, Dynamic, Dynamic>;
  require_finite(r, "log");
  if (row_norm(Matrix(r - Matrix::Identity(r.rows(), r.cols()))) < 0.25) {
    Matrix const a = matrix_logarithm(Matrix(r));
    return (a - a.transpose()) / S(2);
  }
  // The Schur vectors of r + 4 are those of r. Its diagonal lies between 3 and 5, so that the iteration does
  // not resolve what is below rounding: it neglects what is small beside the diagonal, and the cosines of r
  // may be zero.
  auto const [u, t] = schur_form(Matrix(r + S(4) * Matrix::Identity(r.rows(), r.cols())));
  int const size = static_cast<int>(r.rows());
  // the Schur form brings its own rounding, up to about 30 epsilon
  Base<S> const edge = Base<S>(8) * edge_of_chart<S>();
  Matrix turns = Matrix::Zero(size, size);
  for (int i = 0; i < size; ++i) {
    if (i + 1 < size && t(i + 1, i) != S(0)) {
      S const angle =
          angle_of_rotation(S(t(i + 1, i) - t(i, i + 1)), S(t(i, i) + t(i + 1, i + 1) - S(8)), edge);
      turns(i + 1, i) = angle, turns(i, i + 1) = -angle;
      ++i;
    } else if (t(i, i) < S(4)) {
      throw OutsideDomain("log", "rotation angle reaches pi; the natural chart needs less (3.19)", M_PI,
                          M_PI);
    }
  }
  return u * turns * u.transpose();
}

}  // namespace actio
