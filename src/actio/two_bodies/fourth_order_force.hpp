// The mutual potential of order 4 as a kick, straight-line code: the formulas of mutual_potential.hpp modulo
// |s|^2, with less arithmetic where both bodies are symmetric about three planes, as ellipsoids are.
#pragma once

#include "actio/two_bodies/any_order_force.hpp"
#include "actio/two_bodies/harmonic_series.hpp"

namespace actio::bodies {

/// The interaction of order 4.
/// @tparam symmetric  whether both bodies have three planes of symmetry, so that moments with an odd exponent
///                    vanish
/// @tparam C          double, or a pack of pairs of bodies
template <bool symmetric, class C = double>
class FourthOrderForce {
 public:
  FourthOrderForce() = default;  // whose numbers are set lane by lane
  /// @param first,second  with moments of order 4 at least
  /// @param G             constant of gravitation
  FourthOrderForce(ExtendedBody const& first, ExtendedBody const& second, double G)
      : mass_1_(first.mass()), mass_2_(G * second.mass()) {
    take(first.moments.series.reflected(), 1, first_2_, first_3_, first_4_);
    take(second.moments.series, G, second_2_, second_3_, second_4_);
  }

  /// @param X      from the first centre of mass to the second, in space
  /// @param q1,q2  unit quaternions, bodies to space
  template <class T>
  [[gnu::always_inline]] Kick<T> operator()(Three<T> const& X, Four<T> const& q1, Four<T> const& q2) const {
    using namespace detail;
    using std::sqrt;
    T const rho = 1.0 / sqrt(dot(X, X)), rho2 = rho * rho, rho4 = rho2 * rho2;
    Three<T> const n = seen_by(q1, Three<T>{X[0] * rho, X[1] * rho, X[2] * rho});
    Four<T> const q = relative_attitude(q1, q2);
    auto const R = rotation_rows(q);
    InverseDistance<5, T> const D(n);
    auto const D2 = D.template of<2>();
    auto const D3 = D.template of<3>();
    auto const D4 = D.template of<4>();
    auto const D5 = D.template of<5>();

    // The series of the second body in the axes of the first, A and B by powers of 1/r.
    auto const A2 = over<T>(first_2_, rho2), B2 = turned(over<T>(second_2_, rho2), R);
    auto const A4 = over<T>(first_4_, rho4), B4 = turned(over<T>(second_4_, rho4), R);
    Harmonic<3, T> A3, B3;
    if constexpr (!symmetric) {
      T const rho3 = rho2 * rho;
      A3 = over<T>(first_3_, rho3), B3 = turned(over<T>(second_3_, rho3), R);
    }

    // The difference body.
    Harmonic<2, T> T2;
    add_multiple(T2, T{} + mass_1_, B2), add_multiple(T2, T{} + mass_2_, A2);
    Harmonic<4, T> T4 = times(A2, B2);
    add_multiple(T4, T{} + mass_1_, B4), add_multiple(T4, T{} + mass_2_, A4);
    Three<T> slope = plus(gradient_on(T2, D3), gradient_on(T4, D5));
    T value = D2.on(T2) + D4.on(T4);

    // The derivatives of V by the coefficients of B, and the torque on the second body.
    Derivatives<2, T> E2;
    Derivatives<4, T> E4;
    add_multiple(E2, T{} + mass_1_, D2), add_contraction(E2, A2, D4), add_multiple(E4, T{} + mass_1_, D4);
    auto const L2 = rotation_rates(B2);
    auto const L4 = rotation_rates(B4);
    Three<T> torque;
    for (int i = 0; i < 3; ++i) torque[i] = E2.on(L2[i]) + E4.on(L4[i]);
    if constexpr (!symmetric) {
      Harmonic<3, T> T3;
      Derivatives<3, T> E3;
      add_multiple(T3, T{} + mass_1_, B3), add_multiple(T3, T{} + mass_2_, A3);
      slope = plus(slope, gradient_on(T3, D4)), value += D3.on(T3);
      add_multiple(E3, T{} + mass_1_, D3);
      auto const L3 = rotation_rates(B3);
      for (int i = 0; i < 3; ++i) torque[i] += E3.on(L3[i]);
    }

    Three<T> force, torque_1, torque_2;
    T const square = rho * rho;
    for (int i = 0; i < 3; ++i) force[i] = square * slope[i], torque_2[i] = -rho * torque[i];
    Three<T> const turning = cross_product(n, slope);
    for (int i = 0; i < 3; ++i) torque_1[i] = -(rho * turning[i] + torque_2[i]);
    Three<T> in_second;
    for (int i = 0; i < 3; ++i)
      in_second[i] = R[0][i] * torque_2[0] + R[1][i] * torque_2[1] + R[2][i] * torque_2[2];
    return {-rho * value, rho, turned_by(q1, force), torque_1, in_second};
  }

 private:
  template <int n>
  using Series = detail::Harmonic<n, C>;

  /// The degrees 2, 3 and 4 of a series modulo \f$|s|^2\f$, times a unit.
  static void take(Polynomial<double> series, double unit, Series<2>& two, Series<3>& three,
                   Series<4>& four) {
    for (int n = 2; n <= 4; ++n)
      for (int l = n; l >= 2; --l)
        for (int j = 0; j <= n - l; ++j) {
          int const i = n - l - j;
          series(i + 2, j, l - 2) -= series(i, j, l), series(i, j + 2, l - 2) -= series(i, j, l);
        }
    auto const fill = [&]<int n>(Series<n>& to) {
      for (int j = 0; j <= n; ++j) to.plain[j] = unit * series(n - j, j, 0);
      for (int j = 0; j < n; ++j) to.with_z[j] = unit * series(n - 1 - j, j, 1);
    };
    fill(two), fill(three), fill(four);
  }
  /// A series of degree n times a power of 1/r. Of symmetric bodies only even exponents are there.
  template <class T, int n>
  [[gnu::always_inline]] static detail::Harmonic<n, T> over(Series<n> const& series, T const& factor) {
    using namespace detail;
    Harmonic<n, T> p;
    unrolled<n + 1>(ACTIO_UNROLLED(j) {
      if constexpr (!symmetric || j % 2 == 0) p.plain[j] = factor * series.plain[j];
    });
    if constexpr (!symmetric) unrolled<n>(ACTIO_UNROLLED(j) { p.with_z[j] = factor * series.with_z[j]; });
    return p;
  }
  /// \f$p(R^Ts)\f$.
  template <int n, class T>
  [[gnu::always_inline]] static detail::Harmonic<n, T> turned(detail::Harmonic<n, T> const& p,
                                                              std::array<Three<T>, 3> const& R) {
    using namespace detail;
    auto const form = [&](int k) __attribute__((always_inline)) {
      return Harmonic<1, T>{{R[0][k], R[1][k]}, {R[2][k]}};
    };
    Harmonic<n, T> result;
    auto const x = form(0), y = form(1);
    auto const xx = times(x, x), yy = times(y, y);
    if constexpr (n == 2) {
      add_multiple(result, p.plain[0], xx), add_multiple(result, p.plain[2], yy);
      if constexpr (!symmetric) {
        auto const z = form(2);
        Harmonic<1, T> rest, across;
        add_multiple(rest, p.with_z[0], x), add_multiple(rest, p.with_z[1], y),
            add_multiple(across, p.plain[1], y);
        add_multiple(result, T{} + 1.0, times(rest, z)), add_multiple(result, T{} + 1.0, times(across, x));
      }
    } else if constexpr (n == 3) {
      // x (p0 xx + p1 xy + p2 yy) + p3 y yy + z (q0 xx + q1 xy + q2 yy)
      auto const z = form(2);
      auto const xy = times(x, y);
      auto const quadratic = [&](T const& a, T const& b, T const& c) __attribute__((always_inline)) {
        Harmonic<2, T> q;
        add_multiple(q, a, xx), add_multiple(q, b, xy), add_multiple(q, c, yy);
        return q;
      };
      result = times(quadratic(p.plain[0], p.plain[1], p.plain[2]), x);
      Harmonic<1, T> last;
      add_multiple(last, p.plain[3], y);
      add_multiple(result, T{} + 1.0, times(yy, last));
      add_multiple(result, T{} + 1.0, times(quadratic(p.with_z[0], p.with_z[1], p.with_z[2]), z));
    } else {
      Harmonic<2, T> a, b;  // xx a + yy b
      add_multiple(a, p.plain[0], xx), add_multiple(a, p.plain[2], yy), add_multiple(b, p.plain[4], yy);
      if constexpr (!symmetric) {
        auto const z = form(2);
        auto const xy = times(x, y);
        Harmonic<2, T> c;  // xz (q0 xx + q1 xy + q2 yy) + yz q3 yy
        add_multiple(a, p.plain[1], xy), add_multiple(b, p.plain[3], xy);
        add_multiple(c, p.with_z[0], xx), add_multiple(c, p.with_z[1], xy), add_multiple(c, p.with_z[2], yy);
        add_multiple(result, T{} + 1.0, times(times(x, z), c));
        add_multiple(b, p.with_z[3], times(y, z));
      }
      add_multiple(result, T{} + 1.0, times(xx, a)), add_multiple(result, T{} + 1.0, times(yy, b));
    }
    return result;
  }

  C mass_1_, mass_2_;  ///< the second times G, as the whole series of the second body
  Series<2> first_2_, second_2_;
  Series<3> first_3_, second_3_;
  Series<4> first_4_, second_4_;
};

}  // namespace actio::bodies
