// The Moser-Veselov equation as a Riccati equation, solved by the two methods of the textbooks, with LAPACK.
//
// X = f^T Lambda = S + P/2, P = hM, S symmetric: X^T X = Lambda^2 is S^2 + (S P - P S)/2 - P^2/4 = Lambda^2,
// a Riccati equation with A = -P/2, G = 1, Q = Lambda^2 + P^2/4. The solution that grows out of the identity
// is the stabilising one: the spectrum of A - S = -X is to the left (Cardoso and Leite).
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <stdexcept>
#include <vector>

extern "C" {
void dgees_(char const* vectors, char const* sorted, int (*select)(double const*, double const*),
            int const* n, double* a, int const* lda, int* first, double* re, double* im, double* vs,
            int const* ldvs, double* work, int const* lwork, int* bwork, int* info);
void dtrsyl_(char const* ta, char const* tb, int const* sign, int const* m, int const* n, double const* a,
             int const* lda, double const* b, int const* ldb, double* c, int const* ldc, double* scale,
             int* info);
void dgesv_(int const* n, int const* nrhs, double* a, int const* lda, int* pivots, double* b, int const* ldb,
            int* info);
}

namespace peers {

using Eigen::MatrixXd;

/// The equation for one momentum.
struct Riccati {
  Eigen::VectorXd lambda;
  MatrixXd half;  ///< P/2

  MatrixXd q() const {
    MatrixXd m = half * half;
    m.diagonal() += lambda.cwiseAbs2();
    return m;
  }
  /// \f$f\f$ from \f$f^T\Lambda = S + P/2\f$.
  MatrixXd relative_motion(MatrixXd const& s) const {
    return lambda.cwiseInverse().asDiagonal() * (s - half);
  }
};

namespace detail {
inline int to_the_left(double const* re, double const*) { return *re < 0; }
inline void require(int info, char const* what) {
  if (info != 0) throw std::runtime_error(what);
}
/// a = Z T Z^T; a becomes T. Where `ordered`, eigenvalues to the left come first.
inline MatrixXd real_schur(MatrixXd& a, bool ordered) {
  int const n = static_cast<int>(a.rows()), room = 40 * n;
  MatrixXd z(n, n);
  std::vector<double> re(static_cast<std::size_t>(n)), im(re), work(static_cast<std::size_t>(room));
  std::vector<int> flags(static_cast<std::size_t>(n));
  int first = 0, info = 0;
  dgees_("V", ordered ? "S" : "N", &to_the_left, &n, a.data(), &n, &first, re.data(), im.data(), z.data(), &n,
         work.data(), &room, flags.data(), &info);
  require(info, "dgees");
  return z;
}
}  // namespace detail

/// By the ordered real Schur form of the Hamiltonian matrix of size 2n: its invariant subspace to the left is
/// spanned by (1, S).
inline MatrixXd by_ordered_schur(Riccati const& r) {
  int const n = static_cast<int>(r.lambda.size());
  MatrixXd hamiltonian(2 * n, 2 * n);
  hamiltonian << -r.half, -MatrixXd::Identity(n, n), -r.q(), -r.half;
  MatrixXd const z = detail::real_schur(hamiltonian, true);
  // S U1 = U2, transposed.
  MatrixXd u1 = z.topLeftCorner(n, n).transpose(), s = z.bottomLeftCorner(n, n).transpose();
  std::vector<int> pivots(static_cast<std::size_t>(n));
  int info = 0;
  dgesv_(&n, &n, u1.data(), &n, pivots.data(), s.data(), &n, &info);
  detail::require(info, "dgesv");
  return (s + s.transpose()) / 2;
}

/// By Newton's method, after Kleinman: each iterate from a Lyapunov equation, solved after Bartels and
/// Stewart. It begins with Lambda, which is stabilising.
/// @param iterations  how many it took
inline MatrixXd by_newton_kleinman(Riccati const& r, int& iterations) {
  int const n = static_cast<int>(r.lambda.size()), plus = 1;
  MatrixXd s = r.lambda.asDiagonal();
  MatrixXd const q = r.q();
  double before = HUGE_VAL;
  for (iterations = 1; iterations < 50; ++iterations) {
    MatrixXd t = -r.half - s;
    MatrixXd const z = detail::real_schur(t, false);
    MatrixXd right = -(z.transpose() * (q + s * s) * z);
    double scale = 1;
    int info = 0;
    dtrsyl_("T", "N", &plus, &n, &n, t.data(), &n, t.data(), &n, right.data(), &n, &scale, &info);
    detail::require(info, "dtrsyl");
    MatrixXd next = z * (right / scale) * z.transpose();
    next = ((next + next.transpose()) / 2).eval();
    double const change = (next - s).norm();
    s = next;
    // Quadratic: once the change is small the next iterate would be as good as exact.
    if (change < 1e-8 * s.norm() || change >= before) break;
    before = change;
  }
  return s;
}

}  // namespace peers
