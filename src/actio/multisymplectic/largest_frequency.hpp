// The largest frequency of small motions of a body, by Lanczos' method: what bounds its explicit steps.
//
// In the inner product of the masses \f$M^{-1}K\f$ is symmetric. Lanczos' vectors make it tridiagonal, and
// the largest eigenvalue of that matrix comes near the one that is looked for long before the powers of
// \f$M^{-1}K\f$ do: after twenty or thirty rounds, whatever the number of nodes. The vectors need not stay
// orthogonal for that, so that three of them suffice.
#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include "actio/numbers/errors.hpp"

namespace actio::media::detail {

/// The largest eigenvalue of a symmetric tridiagonal matrix, and the modulus of the last component of its
/// unit eigenvector.
/// @param a  the diagonal
/// @param b  beside the diagonal, positive; one fewer are used than there are in a
std::pair<double, double> top_of_lanczos_matrix(std::vector<double> const& a, std::vector<double> const& b);

/// The largest frequency, per time: the root of the largest eigenvalue of \f$M^{-1}K\f$, 0 where none is
/// positive.
/// @param mass   a callable (k): the mass of component k, 0 where it is held
/// @param u      a motion to begin with, zero where it is held; what is orthogonal to it is not found
/// @param apply  a callable (u, out): \f$M^{-1}K\,u\f$, zero where it is held
/// @param rounds  at most
/// Accuracy: from below; the iteration ends where an eigenvalue is within a per cent of what is returned
/// squared, and of all eigenvalues the largest is then not above that: half a per cent of the frequency.
/// Cost: twenty to forty times `apply`.
template <class Mass, class Apply>
double largest_frequency(Mass const& mass, std::vector<double> u, Apply const& apply, int rounds = 200) {
  std::vector<double> before(u.size(), 0), next, a, b;
  auto const product = [&](std::vector<double> const& x, std::vector<double> const& y) {
    double sum = 0;
    for (std::size_t k = 0; k < x.size(); ++k) sum += mass(k) * x[k] * y[k];
    return sum;
  };
  double size = std::sqrt(product(u, u)), largest = 0;
  for (int round = 0; round < rounds && size > 0 && is_finite(size); ++round) {
    for (double& one : u) one /= size;
    apply(u, next);
    double const back = b.empty() ? 0 : b.back();
    for (std::size_t k = 0; k < u.size(); ++k) next[k] -= back * before[k];
    a.push_back(product(u, next));
    for (std::size_t k = 0; k < u.size(); ++k) next[k] -= a.back() * u[k];
    size = std::sqrt(product(next, next));
    auto const [value, last] = top_of_lanczos_matrix(a, b);
    largest = value;
    if (!(size * last > 0.01 * value)) break;
    b.push_back(size);
    before.swap(u), u.swap(next);
  }
  return largest > 0 ? std::sqrt(largest) : 0;
}

}  // namespace actio::media::detail
