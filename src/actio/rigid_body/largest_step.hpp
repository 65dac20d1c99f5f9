// The largest step for which the Moser-Veselov equation has a solution.
#pragma once

#include <cmath>
#include <limits>

#include "actio/rigid_body/inertia.hpp"

namespace actio {
namespace detail {

/// \f$s\,\rho\big((s^2+\Lambda^2)^{-1/2}\,iM\,(s^2+\Lambda^2)^{-1/2}\big)\f$ at \f$s = e^{t}\f$.
double spin_against_inertia(Vector<double> const& lambda, Matrix<double> const& m, double t);

/// The largest value of f between a and b, where it has one hump, by golden section.
template <class F>
double top_of_hump(F const& f, double a, double b) {
  double const ratio = (std::sqrt(5.0) - 1) / 2;
  double u = b - ratio * (b - a), v = a + ratio * (b - a), fu = f(u), fv = f(v);
  // The top is flat: half the digits in the argument give all digits in the value.
  while (b - a > 1e-8) {
    if (fu > fv)
      b = v, v = u, fv = fu, u = b - ratio * (b - a), fu = f(u);
    else
      a = u, u = v, fu = fv, v = a + ratio * (b - a), fv = f(v);
  }
  return std::max(fu, fv);
}

}  // namespace detail

/// The largest h for which \f$f^T\Lambda - \Lambda f = hM\f$ has a solution that grows out of the identity.
///
/// \f[ \frac1{h_{max}} = \max_{s>0}\; s\,\rho\big((s^2+\Lambda^2)^{-1/2}\,iM\,(s^2+\Lambda^2)^{-1/2}\big) \f]
///
/// A solution X = f^T Lambda factors \f$1 - \lambda hM - \lambda^2\Lambda^2 = (1+\lambda X^T)(1-\lambda
/// X)\f$. The spectrum can leave the right half plane through the imaginary axis alone, and there the left
/// side is, up to a factor, the Hermitian matrix \f$s^2+\Lambda^2+ishM\f$: as long as that is positive for
/// every s there is a factor with its spectrum to the right, and once it is not there is none. With the body
/// velocity \f$\xi=J^{-1}M\f$ in coordinates \f$h_{max}|\xi|\ge1\f$: a step of less than one radian has a
/// solution for every body; about a principal axis a longer one has none.
///
/// @param pi  body momentum; energy x time
/// @return    time, positive; infinite for a body at rest
/// @throws OutsideDomain  where a \f$\Lambda_i\f$ is negative: only its square enters here
/// Accuracy: relative 1e-12 or so.
template <int n, Real S>
double largest_step(Inertia<n, S> const& inertia, Momentum<SO<n>, S> const& pi) {
  if (!is_finite(pi.components)) throw NotFinite("largest_step: body momentum");
  S const size = magnitude(pi.components);
  if (size == S(0)) return std::numeric_limits<double>::infinity();
  S const unit = magnitude(inertia.lambda);
  auto const plain = [](S const& x) { return to_double(x); };
  Vector<double> const lambda = (inertia.lambda / unit).unaryExpr(plain);
  if (lambda.minCoeff() < 0)
    throw OutsideDomain("largest_step",
                        "the closed form asks for Lambda_i >= 0; smallest, in units of the largest",
                        lambda.minCoeff(), 0);
  Matrix<double> const m = inertia.group.hat((pi.components / size).eval()).unaryExpr(plain);
  auto const f = [&](double t) { return detail::spin_against_inertia(lambda, m, t); };

  // The humps lie where s is among the Lambda_i, or, for a planar body, anywhere below. Scan, then climb the
  // best of them.
  double smallest = 1;
  for (double const l : lambda)
    if (l > 0) smallest = std::min(smallest, l);
  double const low = std::log(smallest) - 12, high = std::log(4.0);
  int const count = 40 + static_cast<int>(4 * (high - low));
  double const gap = (high - low) / count;
  Vector<double> value(count + 1);
  for (int i = 0; i <= count; ++i) value[i] = f(low + i * gap);
  double best = value.maxCoeff();
  for (int i = 0; i <= count; ++i)
    if (value[i] > 0.9 * best)
      best = std::max(best, detail::top_of_hump(f, low + (i - 1) * gap, low + (i + 1) * gap));
  return to_double(S(unit / size)) / best;
}

}  // namespace actio
