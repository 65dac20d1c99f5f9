// Section 6.2: where the first jet bundle with the form of a density is a multisymplectic manifold.
#include "actio/continuum/stresses.hpp"
#include "actio/linear_algebra/determinant.hpp"
#include "actio/linear_algebra/rank.hpp"

#include "fields/off_shell.hpp"
#include "fields/variations.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

/// Bodies and spaces for which all contractions are computed.
using Few = std::tuple<Dimensions<1, 1>, Dimensions<1, 2>, Dimensions<2, 1>, Dimensions<2, 2>>;

/// Calls `visit` with each set of k of the first D numbers, in increasing order.
template <class Visit>
void over_sets(int D, int k, Visit const& visit) {
  std::vector<int> set(k);
  for (int i = 0; i < k; ++i) set[i] = i;
  while (true) {
    visit(set);
    int i = k - 1;
    while (i >= 0 && set[i] == D - k + i) --i;
    if (i < 0) return;
    ++set[i];
    for (int l = i + 1; l < k; ++l) set[l] = set[l - 1] + 1;
  }
}
/// The map \f$V\mapsto V\lrcorner\,\Omega\f$ of a form of degree k at a point with D coordinates: a row for
/// each set of k - 1 basis vectors.
template <int k, class S, int D, class Form>
Matrix<S> contractions(Form const& omega, Matrix<S, D, 1> const& at) {
  std::map<std::vector<int>, Vector<S>> rows;
  over_sets(D, k - 1, [&](auto const& set) { rows[set] = Vector<S>::Zero(D); });
  over_sets(D, k, [&](auto const& set) {
    Tangents<S, D, k> V = Tangents<S, D, k>::Zero();
    for (int i = 0; i < k; ++i) V(set[i], i) = S(1);
    S const value = omega(at, V);
    // The i-th of the basis vectors goes into the first slot.
    for (int i = 0; i < k; ++i) {
      auto others = set;
      others.erase(others.begin() + i);
      rows[others][set[i]] = i % 2 == 0 ? value : S(-value);
    }
  });
  Matrix<S> all(static_cast<Index>(rows.size()), D);
  Index row = 0;
  for (auto const& [set, values] : rows) all.row(row++) = values.transpose();
  return all;
}
/// Of the form of a density at a jet.
template <class S, int n, int N, class L>
Matrix<S> contractions_of(L const& density, Jet<S, n, N> const& j) {
  return contractions<n + 2>(multisymplectic_form<n, N>(density), coordinates(j));
}
/// The second derivatives of a density in the derivatives \f$v^a{}_\mu\f$, or in those of the places alone.
template <class S, int n, int N, class L>
Matrix<S> second_derivatives(L const& density, Jet<S, n, N> const& j, bool with_velocity = true) {
  int const first = with_velocity ? 0 : 1, size = N * (n + 1 - first);
  Matrix<S> out(size, size);
  for (int mu = first; mu <= n; ++mu)
    for (int a = 0; a < N; ++a) {
      Jet<Dual<S>, n, N> moved = j.template cast<Dual<S>>();
      moved.v(a, mu).part[0] = S(1);
      Matrix<S, N, n + 1> const rate = rate_of(momenta(density, moved));
      for (int nu = first; nu <= n; ++nu)
        for (int b = 0; b < N; ++b) out(N * (nu - first) + b, N * (mu - first) + a) = rate(b, nu);
    }
  return out;
}
/// A vector along the derivatives alone, among the coordinates of a jet.
template <class S, int n, int N>
Matrix<S, Jet<S, n, N>::dimension, 1> along_derivatives(Matrix<S, N, n + 1> const& direction) {
  Matrix<S, Jet<S, n, N>::dimension, 1> V = Matrix<S, Jet<S, n, N>::dimension, 1>::Zero();
  for (int mu = 0; mu <= n; ++mu)
    for (int a = 0; a < N; ++a) V[place_of_derivative<n, N>(a, mu)] = direction(a, mu);
  return V;
}
/// \f$V\lrcorner\,\Omega\f$ on some tangent vectors.
template <class S, int n, int N, class L>
S contracted(L const& density, Jet<S, n, N> const& j, Matrix<S, Jet<S, n, N>::dimension, 1> const& V,
             Tangents<S, Jet<S, n, N>::dimension, n + 1> const& X) {
  Tangents<S, Jet<S, n, N>::dimension, n + 2> all;
  all << V, X;
  return multisymplectic_form<n, N>(density)(coordinates(j), all);
}

/// A density that one combination k of the derivatives does not enter: of the others, with c . k = 1.
template <class S, int n, int N>
struct WithoutDirection {
  AnyDensity<S, n, N> L;
  Matrix<S, N, n + 1> k, c;
  template <class T>
  T operator()(Jet<T, n, N> const& j) const {
    T along(0);
    for (int mu = 0; mu <= n; ++mu)
      for (int a = 0; a < N; ++a) along += j.v(a, mu) * T(c(a, mu));
    auto projected = j;
    for (int mu = 0; mu <= n; ++mu)
      for (int a = 0; a < N; ++a) projected.v(a, mu) -= along * T(k(a, mu));
    return L(projected);
  }
};

/// The energy of strains \f$E = C - C_0\f$, \f$\sum E_{ij}^2 + (m\cdot E)^2\f$: it has no other state without
/// stress, and is the same however the body is turned.
template <class S, int n>
struct StrainsFrom {
  Matrix<S, n, n> natural, m;
  template <class BodyMetric, class SpaceMetric, class T, int N>
  T operator()(Matrix<T, n, 1> const&, BodyMetric const&, SpaceMetric const& g,
               Matrix<T, N, n> const& F) const {
    Matrix<T, n, n> const C = green_tensor(g, F);
    T squares(0), along(0);
    for (int i = 0; i < n; ++i)
      for (int k = 0; k < n; ++k) {
        T const E = C(i, k) - T(natural(i, k));
        squares += E * E, along += E * T(m(i, k));
      }
    return squares + along * along;
  }
};

/// The determinant of the second derivatives of \f$w(J)\f$ in F, in closed form.
template <class S>
S determinant_for_fluid(int n, S const& det_F, S const& slope, S const& bend) {
  S product((n * (n - 1) / 2 + n - 1) % 2 == 0 ? 1 : -1);
  for (int i = 0; i < n * (n - 2); ++i) product *= det_F;
  for (int i = 0; i < n * n - 1; ++i) product *= slope;
  return product * (slope * S(n - 1) + bend * det_F * S(n));
}
/// \f$a\,D + b\,D^2\f$ of \f$D = \det F\f$.
template <class S>
struct OfDeterminant {
  S a, b;
  template <class T, int n>
  T operator()(Jet<T, n, n> const& j) const {
    T const D = determinant(Matrix<T, n, n>(j.gradient())), speed = j.velocity().dot(j.velocity());
    return speed / T(2) - T(a) * D - T(b) * D * D;
  }
};

}  // namespace

STATEMENT(claim_6_2_multisymplectic_manifold,
          "the first jet bundle with the form of the density as a multisymplectic manifold") {
  claim.convention(
      "Where the second derivatives of $L$ in $v$ have an inverse and the body has a dimension: then the "
      "form, which is closed, has no kernel. For $V$ along the derivatives alone $V\\lrcorner\\,\\Omega = "
      "-\\frac{\\partial^2L}{\\partial v^a{}_\\mu\\partial v^b{}_\\nu}V^b{}_\\nu\\,(dy^a - v^a{}_\\kappa "
      "dx^\\kappa)\\wedge d^nx_\\mu$, so that the condition is needed. A medium (6.3) may fail it: in a "
      "body without stress whose energy does not depend on how it is turned, turns of $F$ are in the "
      "kernel; in a fluid changes of $F$ that keep the volume, where there is no pressure. For time alone "
      "the form has a kernel of one dimension, the motions. The field equations that the section derives "
      "do not need the condition: claim_6_2_el_by_contraction.");
  claim.leaves(
      "That the condition is enough is found at random jets of bodies of one and two dimensions, from all "
      "contractions of the form there.");
  // Twice differentiated cubics; and sums over sets of basis vectors.
  over_dimensions(Few{}, [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
    constexpr int all = Jet<S, n, N>::dimension;
    auto const L = draw_density<S, n, N>(draw);
    auto const j = draw_jet<S, n, N>(draw);
    auto const X = draw_tangents<S, all, n + 1>(draw);
    Matrix<S, N, n + 1> direction = Matrix<S, N, n + 1>::Zero();
    for (int mu = 0; mu <= n; ++mu) direction.col(mu) = draw.vector<S, Matrix<S, N, 1>>(N);

    // Along derivatives alone, in closed form.
    Matrix<S> const hessian = second_derivatives(L, j);
    Matrix<S, N, n + 1> change;
    for (int mu = 0; mu <= n; ++mu)
      for (int a = 0; a < N; ++a) {
        change(a, mu) = S(0);
        for (int nu = 0; nu <= n; ++nu)
          for (int b = 0; b < N; ++b) change(a, mu) += hessian(N * mu + a, N * nu + b) * direction(b, nu);
      }
    S const value = contracted(L, j, along_derivatives<S, n, N>(direction), X),
            along = change.cwiseProduct(j.v).sum(),
            scale = magnitude(change) * S(N * (n + 1)) + magnitude(along);
    auto const at = coordinates(j);
    claim.zero("contraction along the derivatives", model,
               S(value + by_exterior_products<n, N>(change, S(-along), at, X)), scale);
    claim.refutes("with dy alone for the contact form", model,
                  S(value + by_exterior_products<n, N>(change, S(0), at, X)), scale);

    // The kernel of all contractions.
    claim.fact("the second derivatives in v have an inverse", model, matrix_rank(hessian) == N * (n + 1));
    claim.fact("then no vector but zero is in the kernel", model, matrix_rank(contractions_of(L, j)) == all);
    Matrix<S, N, n + 1> dual;
    for (int mu = 0; mu <= n; ++mu) dual.col(mu) = draw.vector<S, Matrix<S, N, 1>>(N);
    dual /= S(dual.cwiseProduct(direction).sum());
    WithoutDirection<S, n, N> const degenerate{L, direction, dual};
    auto const kernel = along_derivatives<S, n, N>(direction);
    S const sizes = magnitude(momenta(degenerate, j)) * magnitude(dual) * S(N * (n + 1)) + scale;
    // The projection divides by a product of drawn vectors.
    claim.zero("a derivative that does not enter is in the kernel", model,
               contracted(degenerate, j, kernel, X), sizes, 100);
    claim.refutes("and where it enters", model, value, scale);
    claim.fact("the rank is less there", model, matrix_rank(contractions_of(degenerate, j)) < all);
  });
  // The form is closed; a function times it is not.
  over_dimensions(std::tuple<Dimensions<1, 1>, Dimensions<1, 2>, Dimensions<2, 1>>{},
                  [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
                    constexpr int all = Jet<S, n, N>::dimension;
                    auto const L = draw_density<S, n, N>(draw);
                    auto const at = coordinates(draw_jet<S, n, N>(draw));
                    auto const X = draw_tangents<S, all, n + 3>(draw);
                    auto const omega = multisymplectic_form<n, N>(L);
                    auto const f = draw_cubic<S, all>(draw);
                    auto const product = [&]<class T, int k>(Matrix<T, all, 1> const& z,
                                                             Tangents<T, all, k> const& V) -> T {
                      return f(z) * omega(z, V);
                    };
                    // Terms of the alternating sum, each of the size of second derivatives.
                    S terms(0);
                    for (int c = 0; c < n + 3; ++c) {
                      Tangents<S, all, n + 2> others;
                      for (int i = 0, to = 0; i < n + 3; ++i)
                        if (i != c) others.col(to++) = X.col(i);
                      terms += size_of(S(omega(at, others)));
                    }
                    claim.zero("d Omega", model, exterior_derivative(omega)(at, X), terms, 10);
                    claim.refutes("d of a function times Omega", model, exterior_derivative(product)(at, X),
                                  terms);
                  });
  // Time alone.
  over_dimensions(std::tuple<Dimensions<0, 2>, Dimensions<0, 3>>{}, [&]<int n, int N>(
                                                                        Dimensions<n, N>,
                                                                        std::string const& model) {
    constexpr int all = Jet<S, 0, N>::dimension;
    auto const L = draw_density<S, 0, N>(draw);
    SecondJet<S, 0, N> j = second_jet(draw_section<S, 0, N>(draw), draw_event<S, 0>(draw));
    Jet<S, 0, N> const first = j;
    claim.fact("the kernel has one dimension", model, matrix_rank(contractions_of(L, first)) == all - 1);
    // The motion through the jet: its acceleration solves the field equations.
    j.w[0].setZero();
    Matrix<S, N, 1> const excess = euler_lagrange(L, j);
    Matrix<S, N, 1> const acceleration =
        solve_linear(Matrix<S, N, N>(second_derivatives(L, first)), excess, "multisymplectic_manifold");
    auto const along = [&](Matrix<S, N, 1> const& a) {
      Matrix<S, all, 1> V;
      V << S(1), first.v, a;
      return V;
    };
    auto const X = draw_tangents<S, all, 1>(draw);
    S const scale = size_of(momenta(L, first)) * size_of(first.v) + size_of(excess) +
                    size_of(second_derivatives(L, first)) * size_of(acceleration);
    // The accelerations come out of an elimination.
    claim.zero("the motion is in it", model, contracted(L, first, along(acceleration), X), scale, 100);
    claim.refutes(
        "with another acceleration", model,
        contracted(L, first, along(Matrix<S, N, 1>(acceleration + draw.vector<S, Matrix<S, N, 1>>(N))), X),
        scale);
  });
  // A body without stress, and one with.
  over_dimensions(
      std::tuple<Dimensions<2, 2>, Dimensions<1, 3>, Dimensions<3, 3>>{},
      [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
        constexpr int all = Jet<S, n, N>::dimension;
        if (n > 2 && numbers_grow()) return;
        auto const j = draw_jet<S, n, N>(draw);
        auto const G = draw_metric<S, n>(draw);
        auto const g = draw_metric<S, N>(draw);
        auto const rho = draw_mass<S, n>(draw);
        Matrix<S, n, n> const C = green_tensor(g(j.y), j.gradient());
        Matrix<S, n, n> m, strain = draw_tangents<S, n, n>(draw);
        for (int i = 0; i < n; ++i) m.col(i) = draw.vector<S, Matrix<S, n, 1>>(n);
        auto const medium = [&](Matrix<S, n, n> const& natural) {
          return Continuum{G, g, rho, StrainsFrom<S, n>{natural, m}};
        };
        auto const unstressed = medium(C), strained = medium(C + strain + strain.transpose());
        claim.zero("no stress", model, first_piola_kirchhoff_stress(unstressed, j),
                   magnitude(first_piola_kirchhoff_stress(strained, j)));
        // A turn of F: g R is antisymmetric.
        Matrix<S, N, N> turn = Matrix<S, N, N>::Zero();
        for (int a = 0; a < N; ++a)
          for (int b = 0; b < a; ++b) turn(a, b) = draw.number<S>(), turn(b, a) = -turn(a, b);
        auto const along = [&](Matrix<S, N, N> const& R) {
          Matrix<S, N, n + 1> direction = Matrix<S, N, n + 1>::Zero();
          direction.template rightCols<n>() = R * j.gradient();
          return along_derivatives<S, n, N>(direction);
        };
        auto const rotation = along(inverse_matrix(g(j.y)) * turn);
        auto const X = draw_tangents<S, all, n + 1>(draw);
        S const scale = magnitude(second_derivatives(strained, j)) * magnitude(rotation);
        claim.zero("turns of F without stress are in the kernel", model,
                   contracted(unstressed, j, rotation, X), scale, 100);
        claim.refutes("turns of F under stress", model, contracted(strained, j, rotation, X), scale);
        claim.refutes("turns with the metric of coordinates", model,
                      contracted(unstressed, j, along(turn), X), scale);
        if constexpr (n == 2 && N == 2) {
          claim.fact("without stress that is all of the kernel", model,
                     matrix_rank(contractions_of(unstressed, j)) == all - 1);
          claim.fact("under stress there is none", model, matrix_rank(contractions_of(strained, j)) == all);
        }
      });
  // A fluid: the second derivatives in F in closed form, and where they have no inverse.
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    constexpr int all = Jet<S, n, n>::dimension;
    if (n > 2 && numbers_grow()) return;
    auto const j = draw_jet<S, n, n>(draw);
    S const det_F = determinant(Matrix<S, n, n>(j.gradient())), a = draw.number<S>() + S(2),
            b = draw.number<S>() + S(2);
    auto const root_of = [&](OfDeterminant<S> const& L) {
      return determinant_by_elimination(Matrix<S>(-second_derivatives(L, j, false)));
    };
    OfDeterminant<S> const fluid{a, b}, free{S(-b * det_F * S(2)), b},
        // (n-1) w' + n D w'' = 0 at this jet.
        special{S(-b * det_F * S(2) - b * det_F * S(2 * n) / S(n - 1)), b};
    S const slope = a + b * det_F * S(2), closed = determinant_for_fluid(n, det_F, slope, S(b + b));
    // A determinant of n^2 rows, by elimination.
    claim.equal("determinant of the second derivatives in F", model, root_of(fluid), closed, 100);
    claim.differs(
        "with n and n - 1 interchanged", model, root_of(fluid),
        S(closed / (slope * S(n - 1) + b * det_F * S(2 * n)) * (slope * S(n) + b * det_F * S(2 * (n - 1)))));
    claim.zero("it vanishes where (n-1) w' + n D w'' does", model, root_of(special),
               S(determinant_for_fluid(n, det_F, S(-b * det_F * S(2 * n) / S(n - 1)), S(b + b + b))), 100);
    // Changes of F that keep the volume, without pressure.
    Matrix<S, n, n> const F = j.gradient();
    Matrix<S, n, n> shear;
    for (int i = 0; i < n; ++i) shear.col(i) = draw.vector<S, Matrix<S, n, 1>>(n);
    Matrix<S, n, n> const kept = shear - Matrix<S, n, n>::Identity() * S(shear.trace() / S(n));
    auto const along = [&](Matrix<S, n, n> const& R) {
      Matrix<S, n, n + 1> direction = Matrix<S, n, n + 1>::Zero();
      direction.template rightCols<n>() = R * F;
      return along_derivatives<S, n, n>(direction);
    };
    auto const X = draw_tangents<S, all, n + 1>(draw);
    S const scale = magnitude(second_derivatives(fluid, j)) * magnitude(along(kept));
    claim.zero("without pressure: changes of F that keep the volume are in the kernel", model,
               contracted(free, j, along(kept), X), scale, 100);
    claim.refutes("under pressure", model, contracted(fluid, j, along(kept), X), scale);
    claim.refutes("changes of F that change the volume", model,
                  contracted(free, j, along(Matrix<S, n, n>(kept + Matrix<S, n, n>::Identity())), X), scale);
  });
}
