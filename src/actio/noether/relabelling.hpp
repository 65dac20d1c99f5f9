// Relabelling of the points of a fluid: divergence-free fields on the body and the currents they carry
// (section 9.1 of the thesis).
//
// The flow of a field xi on the body preserves its volume sqrt(det G) d^n x where d_k(sqrt(det G) xi^k) = 0.
// Coordinates with det G constant are nowhere assumed: the determinant of a volume-preserving map is sqrt(det
// G(x))/sqrt(det G(eta(x))) there, and it is 1 only in such coordinates.
#pragma once

#include "actio/continuum/materials.hpp"
#include "actio/noether/covariant_momentum_map.hpp"

namespace actio {

/// A field on the body that does not preserve its volume.
struct NotDivergenceFree : OutsideDomain {
  using OutsideDomain::OutsideDomain;
};

/// The field of a potential A on the body, divergence-free with respect to \f$\sqrt{\det G}\f$: for n = 2 a
/// stream function, \f$\xi = (\partial_2A, -\partial_1A)/\sqrt{\det G}\f$; for n = 3 a vector potential,
/// \f$\xi^i = \epsilon^{ijk}\partial_jA_k/\sqrt{\det G}\f$.
/// @tparam Metric     G, a callable on points of the body
/// @tparam Potential  a callable on points of the body, over any scalar: a column with 1 component for n = 2
///                    and 3 for n = 3
template <class Metric, class Potential>
struct RelabellingField {
  Metric G;     ///< metric of the body
  Potential A;  ///< stream function or vector potential

  /// The field at a point of the body.
  template <class S, int n>
  Matrix<S, n, 1> operator()(Matrix<S, n, 1> const& x) const {
    static_assert(n == 2 || n == 3, "potentials are written out for bodies of two and three dimensions");
    auto const dA = derivative(A, x).matrix;
    Matrix<S, n, 1> xi;
    if constexpr (n == 2)
      xi << dA(0, 1), -dA(0, 0);
    else
      for (int i = 0; i < 3; ++i) xi[i] = dA((i + 2) % 3, (i + 1) % 3) - dA((i + 1) % 3, (i + 2) % 3);
    return xi / volume<S>(G(x));
  }
};
/// The field of a potential on a body with this metric.
template <class Metric, class Potential>
RelabellingField(Metric, Potential) -> RelabellingField<Metric, Potential>;

/// Refuses a field whose divergence at a point is more than rounding.
/// @param rate  what the divergence is compared with: the size of the derivatives of the field, 1/time
/// @throws NotDivergenceFree  with the divergence over `rate`
template <class Metric, class Xi, class S, int n>
void require_divergence_free(Metric const& G, Xi const& xi, Matrix<S, n, 1> const& x, Base<S> const& rate) {
  Base<S> const found = magnitude(divergence(G, xi, x));
  // Derivatives of a potential, of a volume and of their quotient: some tens of roundings for each of n
  // terms.
  Base<S> const bound = Base<S>(256 * n) * epsilon<S>();
  if (!is_finite(found)) throw NotFinite("relabelling field at x = " + show(x));
  if (found > bound * rate)
    throw NotDivergenceFree(
        "relabelling field at x = " + show(x),
        "a relabelling preserves the volume of the body; divergence over the rates of the field",
        rate > Base<S>(0) ? to_double(Base<S>(found / rate)) : to_double(found), to_double(bound));
}

/// The field \f$(0, \xi(x), 0)\f$ on Y that relabels the body and leaves space fixed: the generator of
/// (9.1), whose prolongation is (9.3).
///
/// \implements{eq_9_1}
template <int N, class Xi>
struct Relabelling {
  Xi xi;  ///< field on the body

  /// The field at a point (x, y) of Y.
  template <class V>
  auto operator()(V const& point) const {
    using T = typename V::Scalar;
    constexpr int n = V::RowsAtCompileTime - 1 - N;
    Matrix<T, n + 1 + N, 1> rate = Matrix<T, n + 1 + N, 1>::Zero();
    rate.template segment<n>(1) = xi(Matrix<T, n, 1>(point.template segment<n>(1)));
    return rate;
  }
};
/// The relabelling of fibres of dimension N by a field on the body.
template <int N, class Xi>
Relabelling<N, Xi> relabelling_field(Xi const& xi) { return {xi}; }

/// The same on a bundle whose last fibre coordinate is the multiplier \f$\lambda = \sqrt{\det G}\,P\f$ of
/// incompressibility: \f$(0, \xi, 0, -\lambda\,\partial_k\xi^k)\f$. The multiplier goes over as a density, so
/// that the pressure is what goes over as it is; where det G is constant \f$\partial_k\xi^k = 0\f$, and this
/// is the field of (9.1).
/// @tparam N  dimension of the fibre with the multiplier
template <int N, class Xi>
struct DensityRelabelling {
  Xi xi;  ///< field on the body

  /// The field at a point of the extended bundle.
  template <class V>
  auto operator()(V const& point) const {
    using T = typename V::Scalar;
    constexpr int n = V::RowsAtCompileTime - 1 - N;
    auto const [field, d_xi] = derivative(xi, Matrix<T, n, 1>(point.template segment<n>(1)));
    Matrix<T, n + 1 + N, 1> rate = Matrix<T, n + 1 + N, 1>::Zero();
    rate.template segment<n>(1) = field;
    rate[n + N] = -point[n + N] * d_xi.trace();
    return rate;
  }
};
/// The relabelling of fibres of dimension N, the last coordinate of which is a density.
template <int N, class Xi>
DensityRelabelling<N, Xi> density_relabelling_field(Xi const& xi) { return {xi}; }

/// The relabelling current of a barotropic fluid, written out (9.8):
/// \f$\bigl(\tfrac12\rho\,g_{ab}\dot\phi^a\dot\phi^b - \rho W - PJ\bigr)\sqrt{\det
/// G}\,\xi^k\,d^nx_k - g_{ab}\dot\phi^b\phi^a{}_{,k}\,\rho\sqrt{\det G}\,\xi^k\,d^nx_0\f$.
///
/// \implements{eq_9_8,claim_9_1_barotropic_current_space,claim_9_1_barotropic_current_time}
/// @param xi  value of the field at the point of the body
/// @return    components of the current, time first
template <class BodyMetric, class SpaceMetric, class Mass, class Law, class S, int n>
Event<S, n> barotropic_relabelling_current(
    Continuum<BodyMetric, SpaceMetric, Mass, Barotropic<Law>> const& fluid, Matrix<S, n, 1> const& xi,
    Jet<S, n, n> const& j) {
  examine(fluid, j);
  auto const G = fluid.G(j.particle());
  auto const g = fluid.g(j.y);
  S const rho = fluid.rho(j.particle()), J = jacobian(G, g, j.gradient()), sqrt_det_G = volume<S>(G);
  auto const [W, dW_dJ] = derivative(fluid.W.w, J);
  S const P = -rho * dW_dJ;
  Matrix<S, n, 1> const v = j.velocity(), F_xi = j.gradient() * xi;
  Event<S, n> current;
  // [eq_9_8]
  current.template tail<n>() = xi * S((rho * inner(g, v, v) / S(2) - rho * W - P * J) * sqrt_det_G);
  current[0] = -inner(g, v, F_xi) * rho * sqrt_det_G;
  // [eq_9_8]
  return current;
}

/// The relabelling current of an ideal incompressible fluid, written out (9.9), with the constant stored
/// energy put to zero.
///
/// \implements{eq_9_9}
/// @param body, space  values of their metrics
/// @param rho   mass density of the body, @param P pressure
/// @param j     first jet of the placement alone, without the multiplier
template <class G, class g, class S, int n>
Event<S, n> incompressible_relabelling_current(G const& body, g const& space, S const& rho, S const& P,
                                               Matrix<S, n, 1> const& xi, Jet<S, n, n> const& j) {
  S const sqrt_det_G = volume<S>(body);
  Matrix<S, n, 1> const v = j.velocity(), F_xi = j.gradient() * xi;
  Event<S, n> current;
  // [eq_9_9]
  current.template tail<n>() = xi * S((rho * inner(space, v, v) / S(2) - P) * sqrt_det_G);
  current[0] = -inner(space, v, F_xi) * rho * sqrt_det_G;
  // [eq_9_9]
  return current;
}

}  // namespace actio
