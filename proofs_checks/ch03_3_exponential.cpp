// Section 3.3: the exponential map is a chart near the identity, and where there are infinitely many
// dimensions it need not be.
#include "actio/linear_algebra/determinant.hpp"

#include "models/chart_models.hpp"
#include "models/enclosures.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

/// \f$\sum_{m\ge1}(-1)^{m+1}x^m/m\f$: to the power from which on nothing is left, or is less than rounding
/// where the norm of x is at most 3/4.
template <class S>
Matrix<S> logarithm_series(Matrix<S> const& x) {
  int const terms = exact_arithmetic<S>() ? static_cast<int>(x.rows()) : 8 * decimal_digits<S>() + 16;
  Matrix<S> power = x, sum = x;
  for (int m = 2; m <= terms; ++m) {
    power = (power * x).eval();
    sum += power * (S(m % 2 == 0 ? -1 : 1) / S(m));
  }
  return sum;
}
/// \f$\sum_{m\ge0}w^m/m!\f$, of a matrix whose norm is at most one or two.
template <class S>
Matrix<S> exponential_series(Matrix<S> const& w) {
  int const terms = exact_arithmetic<S>() ? static_cast<int>(w.rows()) : decimal_digits<S>() + 32;
  Matrix<S> term = Matrix<S>::Identity(w.rows(), w.cols()), sum = term;
  for (int m = 1; m <= terms; ++m) {
    term = (term * w / S(m)).eval();
    sum += term;
  }
  return sum;
}

/// On a box of velocities, a lower bound of 1 less the row norm of \f$P\circ T\exp - 1\f$, with the
/// projection P of matrices on the algebra. Where it is positive on a convex set, exp is one to one there and
/// its differential has an inverse.
///
/// The series is taken to 40 terms, and the others are bounded: with \f$|w|\le r\f$ they are at most
/// \f$|e|\,\frac{r^K}{K!}\bigl(1-\frac r{K+1}\bigr)^{-1}\f$ in the direction e.
Number room_of_exponential(SpannedGroup const& group, Vector<Number> const& box) {
  constexpr int K = 40;
  int const d = group.dimension();
  Matrix<Number> const w = group.hat(box);
  auto const norm = [](Matrix<Number> const& m) {
    Number largest(0);
    for (Index i = 0; i < m.rows(); ++i) {
      Number sum(0);
      for (Index k = 0; k < m.cols(); ++k) sum += magnitude(m(i, k)).upper();
      if (sum.upper() > largest.upper()) largest = sum.upper();
    }
    return largest;
  };
  Number const r = norm(w);
  if (!(r < Number(K / 2))) throw Undecided("the series of the exponential");
  Number rest = Number(1) / (Number(1) - r / (K + 1));
  for (int m = 1; m <= K; ++m) rest *= r / m;
  Vector<Number> sums = Vector<Number>::Zero(d);
  for (int a = 0; a < d; ++a) {
    Vector<Number> unit = Vector<Number>::Zero(d);
    unit[a] = Number(1);
    Matrix<Number> const e = group.hat(unit);
    Matrix<Number> power = Matrix<Number>::Identity(w.rows(), w.cols()), rate = e, sum = e;
    for (int m = 2; m <= K; ++m) {
      power = (power * w / Number(m - 1)).eval();
      rate = ((w * rate + e * power) / Number(m)).eval();
      sum += rate;
    }
    Number const bound = (norm(e) * rest).upper();
    for (Index i = 0; i < sum.size(); ++i) sum(i) += Number::between(Number(-bound), bound);
    Vector<Number> const column = group.vee(sum);
    for (int i = 0; i < d; ++i) sums[i] += magnitude(Number(column[i] - Number(i == a ? 1 : 0)));
  }
  Number room = Number(1) - sums[0];
  for (int i = 1; i < d; ++i)
    if (Number const other = Number(1) - sums[i]; other.lower() < room.lower()) room = other;
  return room;
}
Vector<Number> cube(int dimension, Number const& radius) {
  Vector<Number> box(dimension);
  for (int k = 0; k < dimension; ++k) box[k] = Number::between(Number(-radius), radius);
  return box;
}

/// A matrix near 1 that is in none of these groups: over a field without exp the difference from 1 is
/// strictly triangular, so that its logarithm is a polynomial.
template <class S>
Matrix<S> draw_outside(Draw& draw, Matrix<S> m) {
  for (Index i = 0; i < m.rows(); ++i)
    for (Index k = 0; k < m.cols(); ++k)
      if (!exact_arithmetic<S>() || k > i) m(i, k) += draw.number<S>() / S(8);
  return m;
}

/// \f$\frac{2\pi}n(1 + a\cos nx)^{\mp1}\f$ on the circle: the flow of the first for a unit of time turns it
/// by \f$2\pi/n\f$.
template <class S>
struct FieldOnCircle {
  int n;
  S a, speed;  ///< \f$2\pi/n\f$
  bool inverse = true;
  template <class T>
  T operator()(T const& x) const {
    using std::cos;
    T const wave = T(1) + T(a) * T(cos(T(x * T(S(n)))));
    return inverse ? T(T(speed) / wave) : T(T(speed) * wave);
  }
  /// The position after a unit of time, by the classical method of fourth order.
  S after_one(S x, int steps) const {
    S const h = S(1) / S(steps);
    for (int k = 0; k < steps; ++k) {
      S const k1 = (*this)(x), k2 = (*this)(S(x + h / S(2) * k1)), k3 = (*this)(S(x + h / S(2) * k2)),
              k4 = (*this)(S(x + h * k3));
      x += h / S(6) * (k1 + S(2) * k2 + S(2) * k3 + k4);
    }
    return x;
  }
};

}  // namespace

STATEMENT(claim_3_3_exponential_chart, "exponential map near the identity") {
  claim.holds(
      "The differential at 0 is the identity, and the theorem of inverse functions does the rest. In "
      "balls: on the cube of velocities with coordinates up to $1/4$ the map is one to one and its "
      "differential has an inverse, for each of the groups tried; elements near the identity have a "
      "logarithm in the algebra. It is no more than local: on $\\SO(3)$ velocities by half a turn either "
      "way have one exponential, and by a whole turn the differential has no inverse. And for the circle's "
      "diffeomorphisms not even that: the fields $\\frac{2\\pi}n(1 + a\\cos nx)^{-1}$ are as small as one "
      "likes with all of their derivatives, and the exponential of each is the turn by $2\\pi/n$.");
  claim.leaves("Of groups of infinite dimension this one is tried, by which the chart is not general there.");
  over_groups(series_groups<S>(), claim, [&](auto const& group, auto const& model) {
    auto const zeta = draw_exponent<S>(draw, group), eta = draw_exponent<S>(draw, group);
    auto const zero = S(0) * eta;
    claim.equal("differential at 0", model, state_of(exp(moving(zero, zeta))).velocity, zeta);
    claim.differs("elsewhere the differential is the identity too", model,
                  state_of(exp(moving(eta, zeta))).velocity, zeta);
    // Inverse maps, and inverse differentials.
    Algebra<S> const rate{group,
                          Vector<S>(rate_part<S>(Matrix<Dual<S>>(log(exp(moving(eta, zeta))).coordinates)))};
    // The logarithm solves for the velocity: an allowance of ten times that of plain evaluation.
    claim.equal("differential of log, after that of exp", model, rate, zeta, 10);
    // An element that no exponential made: its logarithm by the power series.
    auto const k = retract(draw_exponent<S>(draw, group, exact_arithmetic<S>() ? S(1) : ratio<S>(1, 6)));
    Matrix<S> const one = Matrix<S>::Identity(k.value.rows(), k.value.cols()),
                    series = logarithm_series(Matrix<S>(k.value - one));
    Algebra<S> const logarithm{group, group.vee(series)};
    claim.equal("the logarithm of an element lies in the algebra", model,
                Matrix<S>(group.hat(logarithm.coordinates)), series, 10);
    claim.equal("and is that of the library", model, log(k), logarithm, 10);
    claim.equal("its exponential is the element", model, exponential_series(series), k.value, 10);
    claim.equal("the library's exponential", model, exp(logarithm), k, 10);
    claim.refutes("the first two terms of the series", model, Matrix<S>(one + series - k.value),
                  magnitude(series));
    // All strictly triangular matrices are in the algebra of UT(n), and all matrices in that of GL(n).
    if (model.substr(0, 2) != "UT" && model.substr(0, 2) != "GL") {
      Matrix<S> const other = logarithm_series(Matrix<S>(draw_outside(draw, one) - one));
      claim.differs("the logarithm of a matrix outside of the group", model,
                    Matrix<S>(group.hat(Vector<S>(group.vee(other)))), other);
    }
  });

  // A whole cube of velocities.
  for (auto const& group : all_groups())
    claim.encloses("one to one, with an inverse differential, on a cube of velocities", group.name(), [&] {
      return positive_on([&](Vector<Number> const& x) { return room_of_exponential(group, x); },
                         cube(group.dimension(), ratio<Number>(1, 4)));
    });
  auto const so3 = spanned("SO(3)", SO<3>{});
  claim.refutes_enclosure("on a cube that reaches beyond half a turn", "SO(3)", [&] {
    return positive_on([&](Vector<Number> const& x) { return room_of_exponential(so3, x); },
                       cube(3, Number(4)), 512);
  });
  using std::cos;
  auto const determinant_along = [](Number const& s) { return Number(Number(2) - Number(cos(s)) * 2); };
  claim.encloses("the differential has an inverse up to 355 degrees", "SO(3)", [&] {
    return positive_along(determinant_along, ratio<Number>(1, 8), ratio<Number>(31, 5));
  });
  claim.refutes_enclosure("and up to 366", "SO(3)", [&] {
    return positive_along(determinant_along, ratio<Number>(1, 8), ratio<Number>(32, 5));
  });
  if (exact_arithmetic<S>()) return;
  using std::acos;
  S const pi = acos(S(-1)), turn = pi * S(2);
  Vector<S> axis(3);
  axis << ratio<S>(2, 3), ratio<S>(-1, 3), ratio<S>(2, 3);
  auto const by = [&](S const& angle) { return Algebra<S>{so3, Vector<S>(axis * angle)}; };
  S const angle = S(2) + draw.number<S>();
  auto const determinant_at = [&](S const& s) {
    return determinant_by_elimination(Matrix<S>(iex(ad_matrix(by(s)))));
  };
  claim.equal("determinant of the differential", "SO(3)", determinant_at(angle),
              S(S(2) * (S(1) - cos(angle)) / (angle * angle)), 10);
  claim.differs("its determinant without the square", "SO(3)", determinant_at(angle),
                S(S(2) * (S(1) - cos(angle)) / angle));
  claim.equal("half a turn either way", "SO(3)", exp(by(pi)), exp(by(S(-pi))), 10);
  claim.differs("a third of a turn either way", "SO(3)", exp(by(S(turn / S(3)))), exp(by(S(-turn / S(3)))));
  claim.zero("determinant at a whole turn", "SO(3)", determinant_at(turn), S(1), 10);

  // The circle: the vector fields d/dx, cos nx d/dx and sin nx d/dx span an algebra of three dimensions.
  for (int n = 1; n <= 4; ++n) {
    std::string const model = "circle, n = " + std::to_string(n);
    auto const determinant_of = [&](S const& speed) {
      Matrix<S> ad = Matrix<S>::Zero(3, 3);
      ad(1, 2) = speed * S(n), ad(2, 1) = -speed * S(n);
      return determinant_by_elimination(Matrix<S>(iex(ad)));
    };
    claim.zero("determinant of the differential at the turn by 1/n", model, determinant_of(S(turn / S(n))),
               S(1), 10);
    claim.refutes("at half of that", model, determinant_of(S(pi / S(n))), S(1));
    // One turn for many fields: x + (a/n) sin nx grows at the constant rate 2 pi/n along the first.
    S const a = (S(2) + draw.number<S>()) / S(n % 2 == 0 ? 6 : -6), x = draw.number<S>();
    FieldOnCircle<S> const field{n, a, S(turn / S(n))}, other{n, a, S(turn / S(n)), false};
    auto const clock = [&]<class T>(T const& at) {
      using std::sin;
      return T(at + T(S(a / S(n))) * T(sin(T(at * T(S(n))))));
    };
    claim.equal("the clock of the flow goes evenly", model, S(derivative(clock, x).rate * field(x)),
                S(turn / S(n)));
    claim.differs("along the field with the inverse factor", model, S(derivative(clock, x).rate * other(x)),
                  S(turn / S(n)));
    claim.equal("and by as much where the circle is turned", model, S(clock(S(x + turn / S(n))) - clock(x)),
                S(turn / S(n)), 10);
    if (claim.fits_orders_in_digits()) {
      std::vector<double> steps, errors, others;
      for (int count : {64, 128, 256, 512, 1024, 2048}) {
        S const end = x + turn / S(n);
        steps.push_back(1.0 / count);
        errors.push_back(to_double(magnitude(S(field.after_one(x, count) - end))));
        others.push_back(to_double(magnitude(S(other.after_one(x, count) - end))));
      }
      claim.order("the flow after a unit of time, against the turn", model, steps, errors, 4);
      claim.refutes_order("of the field with the inverse factor", model, steps, others, 4);
    }
  }
}
