// Between the two parts: a drop of ideal fluid whose motion stays linear is a field on the one hand, and a
// geodesic of SL(n) on the other.
//
// The motion is phi(t, X) = A(t) X with A in SL(n), the drop the unit ball. Part II knows it as a section
// with a pressure, m/2 (1 - |X|^2). Part I knows it as a motion of a group whose Lagrangian is invariant but
// for the advected vector A A^T, and discretizes it.
#include "actio/groups/special_linear.hpp"
#include "actio/incompressible/incompressible_equations.hpp"
#include "actio/jets/field_equations.hpp"
#include "actio/reduction/advected.hpp"
#include "actio/reduction/discrete_euler_lagrange.hpp"
#include "statement.hpp"
#include "witness/taylor_reference.hpp"

namespace {

using namespace actio;
using namespace actio::checks;

/// \f$|A_1 - A_0|^2/2h\f$, the action of a step.
template <class S>
struct StepOfDrop {
  S h;
  template <class A>
  auto operator()(A const& a0, A const& a1) const {
    using T = typename A::Scalar;
    T sum(0);
    for (int i = 0; i < a0.value.size(); ++i) {
      T const d = a1.value(i) - a0.value(i);
      sum += d * d;
    }
    return T(sum / T(Base<T>(h) * 2));
  }
};
/// The same reduced: \f$\mathrm{tr}\,(f^{-1}-1)\,M\,(f^{-1}-1)^T/2h\f$ with \f$f = A_0A_1^{-1}\f$ and
/// \f$M = A_0A_0^T\f$, advected.
template <class S, int n>
struct ReducedStep {
  S h;
  template <class F, class T>
  T operator()(F const& f, actio::Matrix<T, n * n, 1> const& a) const {
    actio::Matrix<T, n, n> const d = inverse(f).value - actio::Matrix<T, n, n>::Identity(),
                                 M = as_matrix<n, n>(a.data());
    return T((d * (M * d.transpose()).eval()).trace() / T(Base<T>(h) * 2));
  }
};
/// How SL(n) carries \f$M = AA^T\f$ along: \f$gMg^T\f$.
template <int n>
struct OnSquares {
  template <class G, class S>
  actio::Matrix<S, n * n, 1> operator()(Element<G, S> const& g, actio::Matrix<S, n * n, 1> const& a) const {
    actio::Matrix<S, n, n> const M = as_matrix<n, n>(a.data());
    actio::Matrix<S, n, n> const moved = g.value * (M * g.value.transpose()).eval();
    return moved.reshaped();
  }
};
template <class S, int n>
actio::Matrix<S, n * n, 1> column(actio::Matrix<S, n, n> const& m) { return m.reshaped(); }

/// \f$m = \mathrm{tr}\,(\dot AA^{-1})^2/\mathrm{tr}\,(A^{-1}A^{-T})\f$, with which \f$\ddot A = mA^{-T}\f$
/// preserves the determinant.
template <class S, int n>
S pressure_of_drop(actio::Matrix<S, n, n> const& inverse, actio::Matrix<S, n, n> const& V) {
  actio::Matrix<S, n, n> const rate = V * inverse;
  return S((rate * rate).trace() / (inverse * inverse.transpose()).trace());
}
/// The second jet of the drop's motion, and of the multiplier \f$\frac m2(1 - |X|^2)\f$, at a particle.
template <class S, int n>
SecondJet<S, n, n + 1> jet_of_drop(actio::Matrix<S, n, n> const& A, actio::Matrix<S, n, n> const& V,
                                   actio::Matrix<S, n, n> const& acceleration, S const& m,
                                   actio::Matrix<S, n, 1> const& X) {
  SecondJet<S, n, n + 1> j;
  j.x << S(0), X;
  j.y << A * X, m / S(2) * (S(1) - X.dot(X));
  j.v.setZero();
  for (auto& w : j.w) w.setZero();
  j.v.template topLeftCorner<n, 1>() = V * X;
  j.v.template topRightCorner<n, n>() = A;
  j.v.row(n).template tail<n>() = -m * X.transpose();
  j.w[0].template topLeftCorner<n, 1>() = acceleration * X;
  j.w[0].template topRightCorner<n, n>() = V;
  for (int k = 0; k < n; ++k) {
    j.w[k + 1].template topLeftCorner<n, 1>() = V.col(k);
    j.w[k + 1](n, k + 1) = -m;
  }
  return j;
}

/// The equation of the drop for power series: the columns of A, then of its velocity.
template <int n>
struct RateOfDrop {
  template <class T>
  actio::Matrix<T, 2 * n * n, 1> operator()(actio::Matrix<T, 2 * n * n, 1> const& state) const {
    actio::Matrix<T, n, n> const A = as_matrix<n, n>(state.data()), V = as_matrix<n, n>(state.data() + n * n);
    actio::Matrix<T, n, n> cofactor;
    // The determinant is 1, so the inverse is the transpose of the cofactors: no division.
    if constexpr (n == 2) {
      cofactor << A(1, 1), -A(1, 0), -A(0, 1), A(0, 0);
    } else {
      for (int k = 0; k < 3; ++k) cofactor.col(k) = cross(A.col((k + 1) % 3), A.col((k + 2) % 3));
    }
    actio::Matrix<T, n, n> const rate = V * cofactor.transpose();
    T square(0), size(0);
    for (int i = 0; i < n; ++i)
      for (int k = 0; k < n; ++k) square += rate(i, k) * rate(k, i), size += cofactor(i, k) * cofactor(i, k);
    T const m = square / size;
    actio::Matrix<T, 2 * n * n, 1> change;
    for (int i = 0; i < n * n; ++i) change[i] = state[n * n + i], change[n * n + i] = m * cofactor(i);
    return change;
  }
};

/// What steps of the reduced equations come to after one unit of time.
struct Run {
  double miss;   ///< of the last configuration, from the power series
  double drift;  ///< of the circulation \f$A_0^TA_1 - A_1^TA_0\f$, over its size
  double sides;  ///< of the configurations from those of the unreduced equations
};
template <int n>
Run run(int steps, actio::Matrix<double, n, n> const& V) {
  using Matrix = actio::Matrix<double, n, n>;
  double const h = 1.0 / steps;
  auto const one = identity<double>(SL<n>{});
  StepOfDrop<double> const L{h};
  ReducedStep<double, n> const l{h};
  // The momentum at the start of the first step is that of the velocity V at the identity.
  int const dim = SL<n>{}.dimension();
  Momentum<SL<n>, double> mu{SL<n>{}, Coordinates<SL<n>, double>(dim)};
  for (int a = 0; a < dim; ++a)
    mu.components[a] =
        (V.transpose() * SL<n>{}.hat(Coordinates<SL<n>, double>(Coordinates<SL<n>, double>::Unit(a))))
            .trace();
  auto const start = exp(velocity(SL<n>{}, SL<n>{}.vee(Matrix(h * V))));
  auto before = one;
  auto configuration =
      solve_on_group([&](auto const& g) { return D1(L, like(g, one), g) + like(g, mu); }, start).value;
  auto f = before * inverse(configuration);
  auto reduced_before = before, reduced = configuration;
  Matrix const circulation =
      before.value.transpose() * configuration.value - configuration.value.transpose() * before.value;
  Run found{0, 0, 0};
  for (int k = 1; k < steps; ++k) {
    auto const next = step_euler_lagrange(L, before, configuration).value;
    before = configuration, configuration = next;
    f = step_advected_euler_poincare_right(
            l, f, column<double, n>(reduced_before.value * reduced_before.value.transpose()), OnSquares<n>{})
            .value;
    reduced_before = reduced, reduced = restore(inverse(f) * reduced);
    Matrix const now =
        reduced_before.value.transpose() * reduced.value - reduced.value.transpose() * reduced_before.value;
    found.drift = std::max(found.drift, magnitude(Matrix(now - circulation)) / magnitude(circulation));
    found.sides = std::max(found.sides, magnitude(Matrix(reduced.value - configuration.value)));
  }
  actio::Matrix<double, 2 * n * n, 1> state;
  state << column<double, n>(Matrix::Identity()), column<double, n>(V);
  auto const exact = taylor_reference(RateOfDrop<n>{}, state, 1.0);
  found.miss = magnitude((column<double, n>(reduced.value) - exact.template head<n * n>()).eval());
  return found;
}

}  // namespace

STATEMENT(bridge_affine_incompressible, "a drop of ideal fluid as a field and as a motion of $\\SL(n)$") {
  claim.holds(
      "The kinetic energy is not invariant under all of $\\SL(n)$: the square $AA^T$ of the configuration "
      "is advected. The reduced discrete equations are those of remark 3.1.3 with it.");
  // Products of some twenty entries of A, its inverse and its velocity, which are of degree 8 in what is
  // drawn.
  auto const in_dimension = [&]<int n>() {
    using Matrix = actio::Matrix<S, n, n>;
    std::string const model = "SL(" + std::to_string(n) + ")";
    auto const configuration = draw.element<S>(SL<n>{});
    Matrix const A = configuration.value, inverse = inverse_matrix(A),
                 V = SL<n>{}.hat(draw.velocity<S>(SL<n>{}).coordinates) * A;
    S const m = pressure_of_drop<S, n>(inverse, V);
    actio::Matrix<S, n, 1> const X = draw.vector<S, actio::Matrix<S, n, 1>>(n);
    auto const density =
        incompressible(Continuum{Euclidean<n>{}, Euclidean<n>{}, Homogeneous<S>{}, NoStoredEnergy{}});
    auto const force = [&](S const& factor) {
      return euler_lagrange(density, jet_of_drop<S, n>(A, V, factor * inverse.transpose(), m, X));
    };
    // Whatever the acceleration B and the factor of the pressure: zero for all X just where they fit.
    Matrix const B = draw.vector<S, actio::Matrix<S, Dynamic, 1>>(n * n).reshaped(n, n);
    S const other = draw.number<S>();
    actio::Matrix<S, n, 1> const left =
        euler_lagrange(density, jet_of_drop<S, n>(A, V, B, other, X)).template head<n>();
    claim.equal("the field equations, off shell", model, left,
                actio::Matrix<S, n, 1>((inverse.transpose() * other - B) * X));
    claim.differs("the inverse not transposed", model, left,
                  actio::Matrix<S, n, 1>((inverse * other - B) * X));
    // The acceleration of the drop is normal to SL(n), which makes its motion a geodesic; B has a part along.
    Matrix const along = SL<n>{}.hat(draw.velocity<S>(SL<n>{}).coordinates) * A;
    S const lengths = size_of(inverse) * size_of(along) + size_of(B) * size_of(along);
    claim.zero("a geodesic: the acceleration is normal to the group", model,
               S(inverse.transpose().cwiseProduct(along).sum()), lengths);
    claim.refutes("any acceleration", model, S(B.cwiseProduct(along).sum()), lengths);
    claim.refutes("that of the inverse not transposed", model, S(inverse.cwiseProduct(along).sum()), lengths);
    S const size = size_of(m) * size_of(inverse) * size_of(X) + S(1);
    claim.zero("the field equations, with the drop's pressure", model, force(m), size);
    claim.refutes("an acceleration the other way", model, force(-m), size);
    Matrix const rate = V * inverse;
    claim.zero("the volume stays, to second order", model,
               S((inverse * (m * inverse.transpose())).trace() - (rate * rate).trace()),
               size_of(rate) * size_of(rate));

    // What the discrete equations say of three configurations: the second difference is a multiple of the
    // inverse transposed, the discrete gradient of a pressure.
    auto const a0 = draw.element<S>(SL<n>{}), a1 = draw.element<S>(SL<n>{}), a2 = draw.element<S>(SL<n>{});
    S const h = ratio<S>(1, 3);
    auto const residual = discrete_euler_lagrange(StepOfDrop<S>{h}, a0, a1, a2);
    auto const circulation = [](Matrix const& from, Matrix const& to) {
      return Matrix(from.transpose() * to - to.transpose() * from);
    };
    Matrix const back = inverse_matrix(a1.value), drift = S(2) * a1.value - a0.value;
    S const products = size_of(a0.value) * size_of(a1.value) +
                       size_of(a1.value) * (size_of(drift) + size_of(back) * size_of(other));
    claim.zero(
        "the discrete motion keeps the circulation", model,
        Matrix(circulation(a0.value, a1.value) - circulation(a1.value, drift + back.transpose() * other)),
        products);
    claim.refutes("with the inverse not transposed", model,
                  Matrix(circulation(a0.value, a1.value) - circulation(a1.value, drift + back * other)),
                  products);
    Matrix const moment = (S(2) * a1.value - a0.value - a2.value) * a1.value.transpose() / h;
    actio::Matrix<S, Dynamic, 1> paired(SL<n>{}.dimension());
    for (int a = 0; a < paired.size(); ++a)
      paired[a] =
          (moment.transpose() * SL<n>{}.hat(Coordinates<SL<n>, S>(Coordinates<SL<n>, S>::Unit(a)))).trace();
    claim.equal("discrete equations and second differences, but for a pressure", model,
                residual.components.eval(), paired.eval());
    auto const reduced = advected_euler_poincare_right(ReducedStep<S, n>{h}, a0 * actio::inverse(a1),
                                                       column<S, n>(a0.value * a0.value.transpose()),
                                                       a1 * actio::inverse(a2), OnSquares<n>{});
    claim.equal("and the reduced ones with the advected square", model, reduced.components.eval(),
                residual.components.eval());
    claim.differs("the square held fixed", model,
                  advected_euler_poincare_right(ReducedStep<S, n>{h}, a0 * actio::inverse(a1),
                                                column<S, n>(Matrix::Identity()), a1 * actio::inverse(a2),
                                                OnSquares<n>{})
                      .components.eval(),
                  residual.components.eval());
    if (n == 3 && claim.fits_orders()) {
      Matrix velocity = draw.vector<S, actio::Matrix<S, Dynamic, 1>>(n * n).reshaped(n, n);
      velocity -= Matrix::Identity() * (velocity.trace() / n);
      actio::Matrix<double, n, n> start;
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) start(i, j) = to_double(velocity(i, j));
      std::vector<double> steps, errors;
      for (int const count : {8, 12, 16, 24, 32, 48}) {
        Run const found = run<n>(count, start);
        steps.push_back(1.0 / count), errors.push_back(found.miss);
        // A step solves its equation to a few roundings of a momentum that is 1/h times the configurations;
        // so many steps of them add up.
        claim.zero("circulation along the reduced motion", model, found.drift, 1.0, count);
        claim.zero("the reduced and the unreduced motion", model, found.sides, 1.0, count);
      }
      claim.order("the discrete motion and the fluid's", model, steps, errors, 2, 0.1);
    }
  };
  in_dimension.template operator()<2>();
  in_dimension.template operator()<3>();
}
