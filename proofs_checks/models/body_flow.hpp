// The motion of a free body by Taylor's series, and how near the discrete motions come to it as the step goes
// to zero: the reference solution of the orders in chapter 5.
//
// Nothing of the schemes and nothing of the library's \f$\mathrm{ad}^*\f$ is in it: \f$\dot\mu =
// \mathrm{ad}^*_\xi\mu\f$, \f$\dot g = g\xi\f$, \f$\xi = J^{-1}\mu\f$ by the structure constants, which
// products of the matrices of the algebra give.
#pragma once

#include <vector>

#include "models/limits.hpp"

namespace actio::checks {

/// Body momentum, in coordinates, and attitude.
template <class S>
struct BodyState {
  Vector<S> momentum;
  Matrix<S> attitude;
};

/// The flow of one body, J any symmetric matrix in coordinates. On the rotations, and on every other group
/// whose elements are matrices.
template <class S>
class BodyFlow {
 public:
  /// @param group  with `hat`, `vee`, `dimension`
  template <class G>
  BodyFlow(G const& group, Matrix<S> const& j) : dimension_(group.dimension()) {
    for (int a = 0; a < dimension_; ++a)
      basis_.push_back(group.hat(Vector<S>(Vector<S>::Unit(dimension_, a))));
    for (int a = 0; a < dimension_; ++a)
      for (int b = 0; b < dimension_; ++b) {
        Vector<S> const bracket = group.vee(Matrix<S>(basis_[a] * basis_[b] - basis_[b] * basis_[a]));
        for (int c = 0; c < dimension_; ++c)
          if (magnitude(S(bracket[c])) > S(0)) constants_.push_back({a, b, c, bracket[c]});
      }
    inverse_ = inverse_matrix(j);
  }

  Vector<S> velocity(Vector<S> const& momentum) const { return inverse_ * momentum; }
  Matrix<S> matrix_of(Vector<S> const& xi) const {
    Matrix<S> sum = basis_[0] * S(xi[0]);
    for (int a = 1; a < dimension_; ++a) sum += basis_[a] * S(xi[a]);
    return sum;
  }

  /// After `duration`, which may be negative, in so many pieces: each is to turn the body by a quarter of a
  /// radian or less. An attitude without entries is left out.
  BodyState<S> operator()(BodyState<S> state, S const& duration, int pieces) const {
    for (int k = 0; k < pieces; ++k) state = piece(state, S(duration / S(pieces)));
    return state;
  }

 private:
  struct Constant {
    int a, b, c;
    S value;
  };

  /// Terms of the series: the digits there are, where each term gains a digit, and some more.
  static int terms() { return decimal_digits<S>() + 8; }

  BodyState<S> piece(BodyState<S> const& start, S const& t) const {
    std::vector<Vector<S>> mu = {start.momentum}, xi = {velocity(start.momentum)};
    bool const turns = start.attitude.size() > 0;
    std::vector<Matrix<S>> g = {start.attitude}, x = {matrix_of(xi[0])};
    BodyState<S> end = start;
    S power(1);
    for (int k = 0; k < terms(); ++k) {
      Vector<S> rate = Vector<S>::Zero(dimension_);
      Matrix<S> turning = Matrix<S>::Zero(start.attitude.rows(), start.attitude.cols());
      for (int i = 0; i <= k; ++i) {
        // \f$\langle\mathrm{ad}^*_\xi\mu, e_b\rangle = \langle\mu, [\xi, e_b]\rangle\f$.
        for (Constant const& c : constants_) rate[c.b] += c.value * xi[i][c.a] * mu[k - i][c.c];
        if (turns) turning += g[i] * x[k - i];
      }
      mu.push_back(rate / S(k + 1)), xi.push_back(velocity(mu.back()));
      power *= t;
      end.momentum += mu.back() * power;
      if (!turns) continue;
      g.push_back(turning / S(k + 1)), x.push_back(matrix_of(xi.back()));
      end.attitude += g.back() * power;
    }
    return end;
  }

  int dimension_;
  std::vector<Matrix<S>> basis_;
  std::vector<Constant> constants_;
  Matrix<S> inverse_;
};

/// Half a unit of time in 16, 32, ..., 512 steps.
inline Refinement const in_half_a_unit{0.5, {16, 32, 64, 128, 256, 512}};

/// Errors after a duration, for each number of steps.
struct BodyErrors {
  std::vector<double> momentum, attitude;
};
/// @param run  (steps, h) -> BodyState at the end
template <class S, class Run>
BodyErrors errors_against(BodyState<S> const& end, Refinement const& ladder, Run const& run) {
  BodyErrors errors;
  for (int const count : ladder.counts) {
    BodyState<S> const found = run(count, S(S(ladder.duration) / S(count)));
    errors.momentum.push_back(to_double(magnitude(Vector<S>(found.momentum - end.momentum))));
    errors.attitude.push_back(to_double(magnitude(Matrix<S>(found.attitude - end.attitude))));
  }
  return errors;
}

}  // namespace actio::checks
