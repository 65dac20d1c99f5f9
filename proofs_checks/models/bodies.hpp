// Models of generalised rigid bodies, over every scalar: rotations of three, four and five dimensions,
// distributions of mass, motions of the Moser-Veselov scheme by design.
#pragma once

#include <utility>
#include <vector>

#include "models/models.hpp"

namespace actio::checks {

/// SO(3), SO(4), SO(5). In SO(3) an index of a plane is one of an axis, and mistakes pass; in the others they
/// do not.
inline std::vector<SpannedGroup> const& rotation_groups() {
  static std::vector<SpannedGroup> const groups = {spanned("SO(3)", SO<3>{}), spanned("SO(4)", SO<4>{}),
                                                   spanned("SO(5)", SO<5>{})};
  return groups;
}
/// The matrix of a velocity, drawn.
template <class S>
Matrix<S> draw_skew(Draw& draw, SpannedGroup const& group) {
  return group.hat(draw.velocity<S>(group).coordinates);
}
template <class S>
Matrix<S> draw_symmetric(Draw& draw, int n) {
  Matrix<S> const m = draw_matrix<S>(draw, n, n);
  return m + m.transpose();
}
/// A rotation, drawn, as a matrix.
template <class S>
Matrix<S> draw_rotation(Draw& draw, SpannedGroup const& group) { return draw.element<S>(group, S(1)).value; }
template <class S>
Matrix<S> identity_matrix(int n) { return Matrix<S>::Identity(n, n); }

/// \f$\Lambda\f$ of a generalised body: diagonal, all sums of two positive, the first entry itself negative.
template <class S>
Matrix<S> draw_second_moments(Draw& draw, int n) {
  Matrix<S> lambda = Matrix<S>::Zero(n, n);
  for (int i = 0; i < n; ++i)
    lambda(i, i) = i == 0 ? S(draw.number<S>() / 8 - ratio<S>(1, 4)) : S(S(1) + draw.number<S>() / 4);
  return lambda;
}
/// \f$\Lambda\xi + \xi\Lambda\f$.
template <class S, class T>
Matrix<T> inertia_operator(Matrix<S> const& lambda, Matrix<T> const& xi) {
  Matrix<T> const l = lambda.template cast<T>();
  return l * xi + xi * l;
}
/// \f$\tfrac14\mathrm{Tr}(\xi^TJ\xi)\f$.
template <class S>
S quarter_trace(Matrix<S> const& lambda, Matrix<S> const& xi) {
  return contract(xi, inertia_operator(lambda, xi)) / S(4);
}
/// Calls `visit(i, j)` for the planes i < j.
template <class Visit>
void each_plane(int n, Visit const& visit) {
  for (int i = 0; i < n; ++i)
    for (int j = i + 1; j < n; ++j) visit(i, j);
}
/// Turning at unit rate in the plane (i, j).
template <class S>
Matrix<S> turning(int n, int i, int j) {
  Matrix<S> xi = Matrix<S>::Zero(n, n);
  xi(i, j) = S(1), xi(j, i) = S(-1);
  return xi;
}

/// A body made of points that have mass. It is described without \f$\Lambda\f$, J, or moments of inertia.
template <class S>
struct PointMasses {
  std::vector<S> mass;
  std::vector<Vector<S>> at;  // in the body

  /// \f$\tfrac12\sum m|\dot gx|^2\f$.
  S kinetic_energy(Matrix<S> const& rate) const {
    S sum(0);
    for (std::size_t p = 0; p < mass.size(); ++p) {
      Vector<S> const v = rate * at[p];
      sum += mass[p] * v.dot(v) / 2;
    }
    return sum;
  }
  /// \f$\sum m\,x_ix_j\f$.
  S second_moment(int i, int j) const {
    S sum(0);
    for (std::size_t p = 0; p < mass.size(); ++p) sum += mass[p] * at[p][i] * at[p][j];
    return sum;
  }
  Matrix<S> second_moments() const {
    int const n = static_cast<int>(at.front().size());
    Matrix<S> m(n, n);
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) m(i, j) = second_moment(i, j);
    return m;
  }
  /// Angular momentum in the body at velocity xi: \f$\sum m\,(v x^T - x v^T)\f$ with \f$v = \xi x\f$.
  Matrix<S> angular_momentum(Matrix<S> const& xi) const {
    Matrix<S> sum = Matrix<S>::Zero(xi.rows(), xi.cols());
    for (std::size_t p = 0; p < mass.size(); ++p) {
      Vector<S> const v = xi * at[p];
      sum += (v * at[p].transpose() - at[p] * v.transpose()) * mass[p];
    }
    return sum;
  }
};
/// Points at random, each with its mirror images in all axes: these are principal.
template <class S>
PointMasses<S> draw_point_masses(Draw& draw, int n) {
  PointMasses<S> body;
  for (int p = 0; p < 2; ++p) {
    S const mass = S(1) + draw.number<S>() / 2;
    Vector<S> const x = draw_vector<S>(draw, n);
    for (int signs = 0; signs < 1 << n; ++signs) {
      Vector<S> image = x;
      for (int i = 0; i < n; ++i)
        if (signs >> i & 1) image[i] = -image[i];
      body.mass.push_back(mass / (1 << n)), body.at.push_back(image);
    }
  }
  return body;
}

/// value + epsilon rate.
template <class S>
Matrix<Dual<S>> varying(Matrix<S> const& value, Matrix<S> const& rate) {
  Matrix<Dual<S>> m = value.template cast<Dual<S>>();
  for (Index i = 0; i < m.size(); ++i) m(i).part[0] = rate(i);
  return m;
}

/// Tr(A^T B) of matrices over one scalar.
template <class T>
T trace_of(Matrix<T> const& a, Matrix<T> const& b) {
  T sum(0);
  for (Index i = 0; i < a.size(); ++i) sum += a(i) * b(i);
  return sum;
}

/// Three attitudes that are a motion of a body for the sum of \f$\mathrm{Tr}(g_k\Lambda g_{k+1}^T)\f$, and
/// its relative motions.
template <class S>
struct BodyMotion {
  Matrix<S> lambda, before, at, after, f10, f21;
};
/// The sum of the two terms in which the middle one of three configurations occurs, as it changes with that
/// configuration.
template <class S>
S slope_of_sum(Matrix<S> const& lambda, Matrix<S> const& before, Matrix<S> const& after,
               Matrix<S> const& change) {
  return contract(change, Matrix<S>(after * lambda)) + contract(Matrix<S>(before * lambda), change);
}
/// Three attitudes at random, and a symmetric \f$\Lambda\f$ of which they are a motion.
///
/// \f$\Lambda\f$ has more entries than there are equations, and these are linear in it: the smallest change
/// of a drawn one that satisfies them. They say that the sum does not change as the middle configuration
/// turns, with nothing carried out. A diagonal \f$\Lambda\f$ has too few entries for that; a frame of the
/// body in which it is diagonal would take roots.
template <class S>
BodyMotion<S> draw_body_motion(Draw& draw, SpannedGroup const& group) {
  int const n = group.matrix_size(), d = group.dimension();
  BodyMotion<S> motion;
  motion.f10 = draw_rotation<S>(draw, group), motion.f21 = draw_rotation<S>(draw, group),
  motion.at = draw_rotation<S>(draw, group);
  motion.before = motion.at * motion.f10, motion.after = motion.at * motion.f21.transpose();
  motion.lambda = draw_second_moments<S>(draw, n);
  auto const slopes = [&](Matrix<S> const& lambda) {
    Vector<S> v(d);
    for (int a = 0; a < d; ++a) {
      Matrix<S> const change = motion.at * group.hat(basis_velocity<S>(group, a).coordinates);
      v[a] = slope_of_sum(lambda, motion.before, motion.after, change);
    }
    return v;
  };
  std::vector<Matrix<S>> directions;
  for (int i = 0; i < n; ++i)
    for (int j = i; j < n; ++j) {
      directions.push_back(Matrix<S>::Zero(n, n));
      directions.back()(i, j) = directions.back()(j, i) = S(1);
    }
  Matrix<S> columns(d, static_cast<int>(directions.size()));
  for (std::size_t k = 0; k < directions.size(); ++k)
    columns.col(static_cast<int>(k)) = slopes(directions[k]);
  Matrix<S> const transposed = columns.transpose(), square = columns * transposed;
  // The normal equations square the condition: solve again for the residual.
  for (int pass = 0; pass < (exact_arithmetic<S>() ? 1 : 3); ++pass) {
    Vector<S> const change = transposed * solve_linear(square, slopes(motion.lambda), "draw_body_motion");
    for (std::size_t k = 0; k < directions.size(); ++k)
      motion.lambda -= directions[k] * S(change[static_cast<int>(k)]);
  }
  return motion;
}

/// A Lagrangian on the rotations: \f$\mathrm{Tr}(f\Lambda)\f$, of pairs \f$\mathrm{Tr}(g_0\Lambda g_1^T)\f$.
template <class S>
struct ScaledTrace {
  Matrix<S> lambda;
  template <class T>
  T operator()(Element<SpannedGroup, T> const& f) const {
    return contract(Matrix<S>(lambda.transpose()), f.value);
  }
  template <class T>
  T operator()(Element<SpannedGroup, T> const& g0, Element<SpannedGroup, T> const& g1) const {
    Matrix<T> const turned = g0.value * lambda.template cast<T>();
    T sum(0);
    for (Index i = 0; i < turned.size(); ++i) sum += turned(i) * g1.value(i);
    return sum;
  }
};

}  // namespace actio::checks
