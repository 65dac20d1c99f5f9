// Chapter 10: the vortex blob method, and what it has to do with the averaged equations of Euler.
//
// In the plane, with velocity u = (psi_y, -psi_x) and vorticity curl u. Kernels are given without the factor
// 1/(2 pi), which goes into the strengths.

#include "fields/box_fields.hpp"
#include "statement.hpp"

namespace {

using namespace actio;
using namespace actio::checks;

/// Blobs of one shape: the stream function of one of them is minus a kernel, a polynomial in the squared
/// distance.
template <class S>
struct Blobs {
  static constexpr int count = 4;
  Matrix<S, count, 1> strength;
  std::array<S, 4> kernel;  ///< its coefficients

  template <class T>
  T kernel_at(T const& s) const {
    return ((s * T(kernel[3]) + T(kernel[2])) * s + T(kernel[1])) * s + T(kernel[0]);
  }
  /// Twice the derivative of the kernel by the squared distance, the velocity over the distance.
  template <class T>
  T speed(T const& s) const {
    return ((s * T(kernel[3] * S(3)) + T(kernel[2] * S(2))) * s + T(kernel[1])) * T(2);
  }
  template <class T>
  T energy(Matrix<T, 2 * count, 1> const& z) const {
    T sum(0);
    for (int i = 0; i < count; ++i)
      for (int j = 0; j < count; ++j) {
        T const x = z[2 * i] - z[2 * j], y = z[2 * i + 1] - z[2 * j + 1];
        sum -= kernel_at(T(x * x + y * y)) * T(strength[i] * strength[j] / S(2));
      }
    return sum;
  }
  /// Each blob moves with the velocity that all of them have at its centre. `widths`: how much wider the
  /// shape of each is, the same for all where the method is meant.
  Matrix<S, 2 * count, 1> velocities(Matrix<S, 2 * count, 1> const& z,
                                     Matrix<S, count, 1> const& widths = Matrix<S, count, 1>::Ones()) const {
    Matrix<S, 2 * count, 1> v = Matrix<S, 2 * count, 1>::Zero();
    for (int i = 0; i < count; ++i)
      for (int j = 0; j < count; ++j) {
        S const x = z[2 * i] - z[2 * j], y = z[2 * i + 1] - z[2 * j + 1],
                k = strength[j] * widths[j] * speed(S((x * x + y * y) * widths[j]));
        v[2 * i] -= k * y;
        v[2 * i + 1] += k * x;
      }
    return v;
  }
  /// The bracket of functions of the centres, by their gradients; `weighted` by the strengths as it should
  /// be.
  S bracket(Matrix<S, 2 * count, 1> const& f, Matrix<S, 2 * count, 1> const& h, bool weighted = true) const {
    S sum(0);
    for (int i = 0; i < count; ++i)
      sum += (f[2 * i] * h[2 * i + 1] - f[2 * i + 1] * h[2 * i]) / (weighted ? strength[i] : S(1));
    return sum;
  }
};
template <class S>
Blobs<S> draw_blobs(Draw& draw) {
  Blobs<S> blobs;
  for (int i = 0; i < blobs.count; ++i) blobs.strength[i] = draw.number<S>() + S(2 * (i % 2) - 1) * S(2);
  for (S& c : blobs.kernel) c = draw.number<S>();
  return blobs;
}

/// A quadratic functional \f$\tfrac12\iint k(x, x')\,\omega\,\omega'\f$ of the vorticity, with a symmetric
/// kernel, as a function of the centres of blobs; and its differential, a stream function.
template <class S>
struct OfVorticity {
  Cubic<S, 4> c;
  Blobs<S> blobs;
  template <class T>
  T kernel(Matrix<T, 2, 1> const& x, Matrix<T, 2, 1> const& y) const {
    Matrix<T, 4, 1> forth, back;
    forth << x, y;
    back << y, x;
    return c(forth) + c(back);
  }
  template <class T>
  T operator()(Matrix<T, 2 * Blobs<S>::count, 1> const& z) const {
    T sum(0);
    for (int i = 0; i < blobs.count; ++i)
      for (int j = 0; j < blobs.count; ++j)
        sum += kernel(Matrix<T, 2, 1>(z.template segment<2>(2 * i)),
                      Matrix<T, 2, 1>(z.template segment<2>(2 * j))) *
               T(blobs.strength[i] * blobs.strength[j] / S(2));
    return sum;
  }
  /// The gradient at a point of its differential, where the vorticity is that of the blobs' centres.
  Matrix<S, 2, 1> differential(Matrix<S, 2 * Blobs<S>::count, 1> const& z, int at) const {
    auto const stream = [&]<class T>(Matrix<T, 2, 1> const& x) {
      T sum(0);
      for (int j = 0; j < blobs.count; ++j)
        sum += kernel(x, Matrix<T, 2, 1>(z.template segment<2>(2 * j).template cast<T>())) *
               T(blobs.strength[j]);
      return sum;
    };
    return derivative(stream, Matrix<S, 2, 1>(z.template segment<2>(2 * at))).gradient();
  }
};

/// A function of the squared distance s, as its powers of s - s_0, at a point of the plane: a polynomial in
/// what is added to the point.
template <class S>
BoxPolynomial<S, 2> around(Matrix<S, 2, 1> const& at, std::vector<S> const& powers) {
  using P = BoxPolynomial<S, 2>;
  P added;
  for (int i = 0; i < 2; ++i) {
    auto const h = P::variable(i);
    added += h * S(at[i] * S(2)) + h * h;
  }
  // Horner's scheme.
  P sum;
  for (auto c = powers.rbegin(); c != powers.rend(); ++c) sum = sum * added + P::constant(*c);
  return sum;
}
/// Half the logarithm of s, with any value at s_0: of first degree.
template <class S>
std::vector<S> half_logarithm(S const& s0, S const& value, int degree) {
  std::vector<S> c = {value};
  S power = S(1) / s0;
  for (int m = 1; m <= degree; ++m, power = -power / s0) c.push_back(power / S(2 * m));
  return c;
}
/// A solution k of \f$k'' + k'/r = \pm k/\alpha^2\f$ in s = r^2, with any value and slope at s_0.
template <class S>
std::vector<S> screened(S const& s0, S const& value, S const& slope, S const& alpha_squared, int degree) {
  std::vector<S> c = {value, slope};
  for (int m = 0; m + 2 <= degree; ++m)
    c.push_back((c[m] / (alpha_squared * S(4)) - c[m + 1] * S((m + 1) * (m + 1))) /
                (s0 * S((m + 2) * (m + 1))));
  return c;
}
template <class S>
BoxPolynomial<S, 2> laplacian_of(BoxPolynomial<S, 2> const& f) {
  return f.slope(0).slope(0) + f.slope(1).slope(1);
}
template <class S>
S at_zero(BoxPolynomial<S, 2> const& f) { return f(Matrix<S, 2, 1>(Matrix<S, 2, 1>::Zero())); }
/// \f$f - \alpha^2\Delta f\f$.
template <class S>
BoxPolynomial<S, 2> filtered(BoxPolynomial<S, 2> const& f, S const& alpha_squared) {
  return f - laplacian_of(f) * alpha_squared;
}

/// The fields of averaged flow in a box, over time and place: \f$v = u - \alpha^2\Delta u\f$.
template <class S>
FieldsInTime<S, 2> momentum_of(FieldsInTime<S, 2> const& u, S const& alpha_squared) {
  FieldsInTime<S, 2> v;
  for (int a = 0; a < 2; ++a) v[a] = u[a] - (u[a].slope(1).slope(1) + u[a].slope(2).slope(2)) * alpha_squared;
  return v;
}
/// \f$\partial_tv + u\cdot\nabla v + (\nabla u)^Tv\f$, or without its last term.
template <class S>
FieldsInTime<S, 2> averaged_force(FieldsInTime<S, 2> const& u, FieldsInTime<S, 2> const& v,
                                  bool last = true) {
  FieldsInTime<S, 2> force;
  for (int a = 0; a < 2; ++a) {
    force[a] = v[a].slope(0);
    for (int b = 0; b < 2; ++b) {
      force[a] += u[b] * v[a].slope(b + 1);
      if (last) force[a] += u[b].slope(a + 1) * v[b];
    }
  }
  return force;
}
template <class S>
BoxPolynomial<S, 3> curl_of(FieldsInTime<S, 2> const& u) { return u[1].slope(1) - u[0].slope(2); }

/// \f$\int_0^\infty e^{-x\cosh t}\cosh^m t\,dt\f$, the functions of Bessel that decay, for m = 0, 1, 2: the
/// trapezoidal rule, whose error is \f$e^{-\pi^2/h}\f$.
template <class S>
std::array<S, 3> decaying(S const& x) {
  using std::exp;
  int const digits = std::max(16, decimal_digits<S>());
  S const h = S(4) / S(digits + 8), first = exp(h);
  std::array<S, 3> sum = {exp(-x) / S(2), exp(-x) / S(2), exp(-x) / S(2)};
  S grown(1);
  while (true) {
    grown *= first;
    S const cosh = (grown + S(1) / grown) / S(2);
    if (x * cosh > S(3 * digits + 20)) break;
    S term = exp(-x * cosh);
    for (S& s : sum) s += term, term *= cosh;
  }
  for (S& s : sum) s *= h;
  return sum;
}

}  // namespace

STATEMENT(claim_10_0_vortex_methods, "vortex blob method and averaged fluid equations") {
  claim.holds(
      "Blobs of one shape, whatever it is, move as a Hamiltonian system whose bracket is that of Lie "
      "and Poisson on vorticities. With the shape $K_0(r/\\alpha)/(2\\pi\\alpha^2)$ their velocity "
      "is that of point vortices of the averaged equations $\\partial_tv + u\\cdot\\nabla v + "
      "(\\nabla u)^Tv = -\\nabla p$, $v = u - \\alpha^2\\Delta u$, which are the geodesics of "
      "$\\int|u|^2 + \\alpha^2|\\nabla u|^2$.");
  {
    auto const blobs = draw_blobs<S>(draw);
    constexpr int dim = 2 * Blobs<S>::count;
    using Centres = Matrix<S, dim, 1>;
    std::string const model = "four blobs";
    auto const z = draw.vector<S, Centres>(dim);
    auto const v = blobs.velocities(z);
    Centres const dH = derivative([&](auto const& at) { return blobs.energy(at); }, z).gradient();
    Centres of_energy;
    for (int i = 0; i < blobs.count; ++i) {
      of_energy[2 * i] = dH[2 * i + 1] / blobs.strength[i];
      of_energy[2 * i + 1] = -dH[2 * i] / blobs.strength[i];
    }
    claim.equal("velocities from the energy and from the blobs", model, of_energy, v);
    claim.differs("with the time reversed", model, of_energy, (-v).eval());
    // Functionals of vorticity: their bracket, and that of functions of the centres.
    OfVorticity<S> const f{draw_cubic<S, 4>(draw), blobs}, h{draw_cubic<S, 4>(draw), blobs};
    S reduced(0), size(0);
    for (int i = 0; i < blobs.count; ++i) {
      auto const a = f.differential(z, i), b = h.differential(z, i);
      reduced += (a[0] * b[1] - a[1] * b[0]) * blobs.strength[i];
      size += size_of(a) * size_of(b);
    }
    Centres const df = derivative(f, z).gradient(), dh = derivative(h, z).gradient();
    claim.zero("the bracket of functionals of the vorticity", model, S(blobs.bracket(df, dh) - reduced),
               size);
    claim.refutes("not divided by the strengths", model, S(blobs.bracket(df, dh, false) - reduced), size);
    // What the plane's motions keep.
    auto const rates = [&](Centres const& velocity) {
      Matrix<S, 4, 1> rate;
      rate << S(0), S(0), S(0), dH.dot(velocity);
      for (int i = 0; i < blobs.count; ++i) {
        rate[0] += velocity[2 * i] * blobs.strength[i];
        rate[1] += velocity[2 * i + 1] * blobs.strength[i];
        rate[2] += (velocity[2 * i] * z[2 * i] + velocity[2 * i + 1] * z[2 * i + 1]) * blobs.strength[i];
      }
      return rate;
    };
    S const terms = size_of(v) * (size_of(dH) + S(dim));
    claim.zero("rates of impulse, moment and energy", model, rates(v), terms);
    auto widths = draw.vector<S, Matrix<S, Blobs<S>::count, 1>>(blobs.count);
    for (int i = 0; i < blobs.count; ++i) widths[i] += S(2);
    claim.refutes("for blobs of different widths", model, rates(blobs.velocities(z, widths)), terms);
  }
  // The averaged equations: vorticity is carried by the smooth velocity, and the variational principle.
  {
    std::string const model = "averaged flow in a box";
    S const alpha = draw.number<S>() + S(2), square = alpha * alpha;
    auto const stream = draw_linear<S, 3>(draw) * draw_linear<S, 3>(draw) * draw_linear<S, 3>(draw) *
                        draw_linear<S, 3>(draw) * draw_linear<S, 3>(draw);
    auto const u = rotated<S, 2, 3>({stream});
    auto const v = momentum_of(u, square);
    auto const q = curl_of<S>(v);
    auto const transport = q.slope(0) + u[0] * q.slope(1) + u[1] * q.slope(2);
    auto const at = draw_event<S, 2>(draw);
    // Four derivatives of a polynomial of fifth degree: factorials magnify its rounding.
    claim.equal("the curl of the averaged equations is the transport of vorticity", model,
                curl_of<S>(averaged_force(u, v))(at), transport(at), 10);
    claim.differs("without the transposed gradient", model, curl_of<S>(averaged_force(u, v, false))(at),
                  transport(at));
    auto const w0 = wall<S, 3>(1) * wall<S, 3>(2);
    auto const flow = rotated<S, 2, 3>({draw_linear<S, 3>(draw) * draw_linear<S, 3>(draw) * w0});
    auto const change = rotated<S, 2, 3>({draw_linear<S, 3>(draw) * w0 * w0 * w0 * wall<S, 3>(0)});
    // The walls' terms vanish where the varied velocity does.
    auto const varied = varied_velocity(flow, change);
    Integral<S> const straight = integral(flow, varied);
    Integral<S> gradients;
    for (int b = 0; b < 2; ++b)
      for (int a = 0; a < 2; ++a) gradients += integral(flow[a].slope(b + 1), varied[a].slope(b + 1));
    S const action = straight.value + gradients.value * square;
    auto const momentum = momentum_of(flow, square);
    auto const work = integral(averaged_force(flow, momentum), change),
               without = integral(averaged_force(flow, momentum, false), change);
    S const scale = size_of(straight.value) + size_of(S(gradients.value * square)) + size_of(work.value);
    claim.zero("the action of averaged flow and the force", model, S(action + work.value), scale,
               magnification<S>(straight.size + gradients.size * magnitude(square) + work.size, scale));
    claim.refutes("without the transposed gradient, as an action", model, S(action + without.value), scale);
    auto const opposite = integral(averaged_force(flow, momentum_of(flow, S(-square))), change);
    claim.refutes("with the other sign of alpha squared", model, S(action + opposite.value), scale);
  }
  // The velocity of point vortices of the averaged equations, away from their centres.
  {
    std::string const model = "one blob";
    constexpr int degree = 5;
    // Away from the centre, by whose distance derivatives are divided.
    auto at = draw.vector<S, Matrix<S, 2, 1>>(2);
    at[0] += S(2);
    S const s0 = at[0] * at[0] + at[1] * at[1],
            square = (draw.number<S>() + S(2)) * (draw.number<S>() + S(2)), value = draw.number<S>(),
            log_value = draw.number<S>(), slope = draw.number<S>();
    // Second and fourth derivatives of polynomials of fifth degree: factorials magnify their rounding.
    auto const log = around(at, half_logarithm(s0, log_value, degree));
    auto const k = around(at, screened(s0, value, slope, square, degree)),
               wrong = around(at, screened(s0, value, slope, S(-square), degree));
    auto const G = log + k;
    S const size = size_of(at_zero(k)) + size_of(at_zero(laplacian_of(k))) * square + size_of(log_value);
    claim.zero("the shape of the blob is k over alpha squared", model,
               S(at_zero(laplacian_of(G)) * square - at_zero(k)), size, 10);
    claim.zero("its filtered stream function is that of a point vortex", model,
               S(at_zero(filtered(G, square)) - log_value), size, 10);
    claim.zero("no averaged vorticity away from the centre", model,
               at_zero(laplacian_of(filtered(G, square))),
               S(size + size_of(at_zero(laplacian_of(laplacian_of(k)))) * square), 100);
    claim.refutes("with waves for the decaying shape", model,
                  S(at_zero(filtered(G - k + wrong, square)) - log_value), size);
    // Another common shape: stream function log(r^2 + alpha^2)/2.
    auto const other = around(at, half_logarithm(S(s0 + square), log_value, degree));
    claim.refutes("the shape of a softened logarithm", model, at_zero(laplacian_of(filtered(other, square))),
                  size);
  }
  if (exact_arithmetic<S>()) return;
  // The shape itself, and the velocity that it gives: r times it is 1 - x K_1(x), x = r/alpha.
  std::string const model = "the decaying shape";
  S const x = modulus(draw.number<S>()) + ratio<S>(1, 10);
  auto const [K0, K1, second] = decaying(x);
  // Sums of some hundred exponentials.
  claim.zero("its equation K'' + K'/x = K", model, S(second - K1 / x - K0), S(second + K1 / x), 10);
  claim.refutes("the equation of waves", model, S(second - K1 / x + K0), S(second + K1 / x));
  auto const circulation = [](S const& at) { return S(S(1) - at * decaying(at)[1]); };
  if (claim.fits_orders_in_digits()) {
    std::vector<double> radii, inside;
    for (int i = 0; i < 6; ++i) {
      S r(1);
      for (int m = 0; m < 24 + 2 * i; ++m) r /= S(2);
      radii.push_back(to_double(r)), inside.push_back(to_double(S(-circulation(r) / log(r))));
    }
    claim.order("circulation inside a small circle, over the logarithm of its radius", model, radii,
                {inside.begin(), inside.end()}, 2);
  }
  claim.fact("the circulation grows towards that of a point vortex", model,
             circulation(x) > S(0) && circulation(x) < circulation(S(x + S(1))) && circulation(x) < S(1));
  claim.refutes("the circulation of a point vortex inside the circle", model, S(circulation(x) - S(1)), S(1));
}
