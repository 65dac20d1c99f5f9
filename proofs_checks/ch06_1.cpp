// Section 6.1: the jet bundle, the dual jet bundle and their forms.

#include "fields/bundle_maps.hpp"
#include "fields/fields.hpp"
#include "fields/variations.hpp"
#include "models/enclosures.hpp"
#include "statement.hpp"

#include "actio/jets/field_equations.hpp"
#include "actio/linear_algebra/rank.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

/// A change of bundle charts: x = old(x') and y' = place(x, y), both of second degree.
template <class S, int n, int N>
struct BundleCharts {
  std::array<Cubic<S, n + 1>, n + 1> old;
  std::array<Cubic<S, n + 1 + N>, N> place;

  explicit BundleCharts(Draw& draw) {
    for (auto& c : old) c = cut(draw_cubic<S, n + 1>(draw, ratio<S>(1, 4)), 2);
    for (auto& c : place) c = cut(draw_cubic<S, n + 1 + N>(draw), 2);
  }
  template <class T>
  Event<T, n> before(Event<T, n> const& x) const {
    Event<T, n> moved;
    for (int mu = 0; mu <= n; ++mu) moved[mu] = x[mu] + old[mu](x);
    return moved;
  }
  /// A section in the new charts.
  template <class Phi>
  auto section(Phi const& phi) const {
    return [this, phi]<class T>(Matrix<T, n + 1, 1> const& x) {
      Event<T, n> const there = before(x);
      Matrix<T, n + 1 + N, 1> point;
      point << there, phi(there);
      Matrix<T, N, 1> y;
      for (int a = 0; a < N; ++a) y[a] = place[a](point);
      return y;
    };
  }
  /// The derivatives \f$(\psi_{,x} + \psi_{,y}v)\,\partial x/\partial x'\f$ in the new charts; the factors
  /// that are not asked for are left out.
  Matrix<S, N, n + 1> transformed(Jet<S, n, N> const& j, Event<S, n> const& x, bool with_base = true,
                                  bool with_shift = true) const {
    Matrix<S, n + 1 + N, n + 1> lifted;
    lifted << Matrix<S, n + 1, n + 1>::Identity(), j.v;
    if (!with_shift) lifted.template topRows<n + 1>().setZero();
    auto const psi = [this]<class T>(Matrix<T, n + 1 + N, 1> const& point) {
      Matrix<T, n + 1 + N, 1> y = Matrix<T, n + 1 + N, 1>::Zero();
      for (int a = 0; a < N; ++a) y[a] = place[a](point);
      return y;
    };
    Matrix<S, N, n + 1> const v = pushed(psi, point_of(j), lifted).template topRows<N>();
    auto const base = [this]<class T>(Event<T, n> const& u) { return before(u); };
    Matrix<S, n + 1, n + 1> const square = Matrix<S, n + 1, n + 1>::Identity();
    if (!with_base) return v;
    return v * pushed(base, x, square);
  }
};

/// Smaller and larger spaces than the body.
using JetDimensions = std::tuple<Dimensions<1, 2>, Dimensions<2, 3>, Dimensions<3, 1>>;

/// \f$\partial_\mu\lrcorner\,d^{n+1}x\f$ as a form.
template <class S, int n>
auto contracted_volume(int mu) {
  Event<S, n> const unit = Event<S, n>::Unit(mu);
  return contract(ConstantField<S, n + 1>{unit},
                  []<class T, int k>(Matrix<T, n + 1, 1> const&, Tangents<T, n + 1, k> const& V) -> T {
                    static_assert(k == n + 1);
                    return determinant(V);
                  });
}

/// \f$d^nx_\mu\f$ on a bundle over space-time: coordinates of space-time come first.
template <int n>
auto contracted_volume_above(int mu) {
  return [mu]<class T, int D>(Matrix<T, D, 1> const&, Tangents<T, D, n> const& V) -> T {
    Event<T, n> const x = Event<T, n>::Zero();
    Tangents<T, n + 1, n> const below = V.template topRows<n + 1>();
    return contracted_volume<Base<T>, n>(mu)(x, below);
  };
}

}  // namespace

STATEMENT(claim_6_1_jet_bundle, "coordinates of the configuration bundle and its first jets") {
  claim.corrected(
      "y^a,\\ i = 1,\\dots,N", "y^a,\\ a = 1,\\dots,N",
      "The index that is named is not the one that is used. Changes of charts act on the fibres of the jet "
      "bundle affinely, not linearly, wherever the chart of space depends on space-time.");
  claim.maybe_scan();
  // Jets of degree 6 in polynomials of second degree. Linear maps through polynomials and their inverses: an
  // allowance of ten times that of plain evaluation.
  over_dimensions(JetDimensions{}, [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
    BundleCharts<S, n, N> const charts(draw);
    Event<S, n> const x = draw_event<S, n>(draw), at = charts.before(x);
    auto const phi = draw_section<S, n, N>(draw), psi = draw_section<S, n, N>(draw);
    auto j = first_jet(phi, at);
    Matrix<S, N, n + 1> const v = first_jet(charts.section(phi), x).v;
    claim.equal("jet in other charts", model, v, charts.transformed(j, x));
    claim.differs("without the change of space-time", model, v, charts.transformed(j, x, false));
    claim.differs("as if places did not depend on space-time", model, v,
                  charts.transformed(j, x, true, false));
    // Two jets over one point of Y and a point on the line through them.
    Matrix<S, N, n + 1> const w = first_jet(psi, at).v;
    S const s = draw.number<S>();
    auto const moved = [&](Matrix<S, N, n + 1> const& slope) {
      j.v = slope;
      return charts.transformed(j, x);
    };
    auto const from = moved(v), to = moved(w);
    claim.equal("transition maps are affine in v", model, moved(v * (S(1) - s) + w * s),
                Matrix<S, N, n + 1>(from * (S(1) - s) + to * s));
    claim.differs("transition maps are linear in v", model, moved(v + w), Matrix<S, N, n + 1>(from + to));
    // As a linear map into Y, in charts that are changed both ways by polynomials.
    BundleMap<S, n, N> change(draw);
    Matrix<S, n + 1, n + 1> const identity = Matrix<S, n + 1, n + 1>::Identity();
    j = first_jet(phi, at);
    Matrix<S, n + 1 + N, n + 1> gamma;
    gamma << identity, j.v;
    auto const back = pushed([&](auto const& u) { return change.on_base_inverse(u); },
                             Event<S, n>(change.on_base(at)), identity);
    auto const in_other_charts = [&] {
      return Matrix<S, n + 1 + N, n + 1>(pushed(change, point_of(j), gamma) * back);
    };
    claim.equal("T pi gamma is the identity in any charts of the bundle", model,
                Matrix<S, n + 1, n + 1>(in_other_charts().template topRows<n + 1>()), identity, 10);
    claim.equal("such a map is the tangent of the section in those charts", model,
                Matrix<S, N, n + 1>(in_other_charts().template bottomRows<N>()),
                first_jet(change.moved(phi), Event<S, n>(change.on_base(at))).v, 10);
    change.tilt = S(1);
    claim.differs("in coordinates of Y whose time depends on places", model,
                  Matrix<S, n + 1, n + 1>(in_other_charts().template topRows<n + 1>()), identity);
    // Read as printed, i = 1, ..., n: places and derivatives beyond the n-th are not among the coordinates.
    if constexpr (n < N) {
      j.y.template tail<N - n>().setZero(), j.v.template bottomRows<N - n>().setZero();
      claim.differs("printed: as many places as the index i has values", model, v, charts.transformed(j, x));
    }
  });
}

STATEMENT(claim_6_1_contracted_volume, "n-forms obtained from the volume form on space-time") {
  claim.corrected("d^nx_\\mu = \\partial_\\mu\\,d^{n+1}x", "d^nx_\\mu = \\partial_\\mu\\lrcorner\\,d^{n+1}x",
                  "The hook between the two is not printed. Without it the line reads as a derivative of "
                  "the volume form along $x^\\mu$, which is an $(n+1)$-form and zero; the forms of "
                  "sections 6.1 and 6.2 need the contraction, into the first slot.");
  claim.maybe_scan();
  // Determinants of up to four drawn columns.
  over_dimensions(
      std::tuple<Dimensions<1, 1>, Dimensions<2, 2>, Dimensions<3, 3>>{},
      [&]<int n>(Dimensions<n, n>, std::string const&) {
        std::string const model = "n = " + std::to_string(n);
        auto const x = draw_event<S, n>(draw);
        auto const V = draw_tangents<S, n + 1, n + 1>(draw);
        auto const sides = draw_tangents<S, n + 1, n>(draw);
        for (int mu = 0; mu <= n; ++mu) {
          auto const below = contracted_volume<S, n>(mu);
          S const scale = determinant(V);
          for (int nu = 0; nu <= n; ++nu)
            claim.zero("dx^nu ^ d^nx_mu", model,
                       S(wedge(differential_of_coordinate(nu), below)(x, V) - (mu == nu ? scale : S(0))),
                       scale);
          // The determinant of the other rows, in their order, with the sign of the row that is left out.
          Matrix<S, n, n> rows;
          for (int r = 0, to = 0; r <= n; ++r)
            if (r != mu) rows.row(to++) = sides.row(r);
          S const product = determinant(rows);
          claim.equal("(-1)^mu times the product of the other differentials", model, below(x, sides),
                      mu % 2 == 0 ? product : S(-product));
          if (mu % 2 == 1) claim.differs("without the sign", model, below(x, sides), product);
          Matrix<S, n + 1, n + 1> last;
          last << sides, Event<S, n>(Event<S, n>::Unit(mu));
          if (n % 2 == 1)
            claim.differs("contracted into the last slot", model, below(x, sides), determinant(last));
          // By Cartan's formula the derivative of the volume form along x^mu is the differential of d^nx_mu.
          S const derivative = exterior_derivative(below)(x, V);
          claim.zero("the derivative of the volume form along x^mu", model, derivative, scale);
          claim.refutes("printed: that derivative in place of dx^mu ^ d^nx_mu", model, S(derivative - scale),
                        scale);
        }
      });
}

namespace {

/// The sets of k numbers among 0, ..., D - 1, in increasing order.
template <int k>
std::vector<std::array<int, k>> increasing(int D) {
  std::vector<std::array<int, k>> sets;
  for (int mask = 0; mask < 1 << D; ++mask) {
    std::array<int, k> set{};
    int count = 0;
    for (int i = 0; i < D; ++i)
      if (mask >> i & 1 && count++ < k) set[count - 1] = i;
    if (count == k) sets.push_back(set);
  }
  return sets;
}

/// How many coefficients an (n+1)-form on Y has, and how many of its differentials are vertical.
constexpr int binomial(int m, int k) { return k == 0 ? 1 : binomial(m - 1, k - 1) * m / k; }
template <int n, int N>
inline constexpr int coefficients = binomial(n + 1 + N, n + 1);
template <int n, std::size_t k>
int vertical_in(std::array<int, k> const& set) {
  int count = 0;
  for (int i : set) count += i > n;
  return count;
}

/// \f$\Theta_\Lambda\f$: an (n+1)-form z on Y, by all of its coefficients, of the vectors below. Coordinates
/// are those of Y and the coefficients.
template <int n, int N>
auto form_of_all() {
  return []<class T, int P, int E>(Matrix<T, P, 1> const& at, Tangents<T, E, n + 1> const& V) -> T {
    T sum(0);
    int k = n + 1 + N;
    for (auto const& rows : increasing<n + 1>(n + 1 + N)) {
      Matrix<T, n + 1, n + 1> minor;
      for (int r = 0; r <= n; ++r) minor.row(r) = V.row(rows[r]);
      sum += at[k++] * determinant(minor);
    }
    return sum;
  };
}

/// The inclusion of Z: coefficients of \f$\Pi\,d^{n+1}x + p_a{}^\mu\,dy^a\wedge d^nx_\mu\f$ among all.
/// @param signs  whether \f$d^nx_\mu\f$ has its sign
template <int n, int N>
auto inclusion(bool signs = true) {
  return [signs]<class T, int E>(Matrix<T, E, 1> const& c) {
    auto const z = dual_jet_at<n, N>(c);
    Matrix<T, n + 1 + N + coefficients<n, N>, 1> all;
    all << z.x, z.y, Matrix<T, coefficients<n, N>, 1>::Zero();
    int k = n + 1 + N;
    for (auto const& set : increasing<n + 1>(n + 1 + N)) {
      if (vertical_in<n>(set) == 0) all[k] = z.Pi;
      if (vertical_in<n>(set) == 1) {
        int mu = 0;
        while (mu < n && set[mu] == mu) ++mu;
        bool const odd = signs && (mu + n) % 2 == 1;
        T const p = z.p(set[n] - n - 1, mu);
        all[k] = odd ? T(-p) : p;
      }
      ++k;
    }
    return all;
  };
}

}  // namespace

STATEMENT(claim_6_1_canonical_forms, "canonical forms on the dual jet bundle in coordinates") {
  claim.holds();
  // Products of at most five drawn columns and a coordinate.
  using Dims = std::tuple<Dimensions<2, 2>, Dimensions<1, 2>, Dimensions<3, 1>>;
  over_dimensions(Dims{}, [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
    constexpr int all = DualJet<S, n, N>::dimension;
    Matrix<S, all, 1> const at = draw.vector<S, Matrix<S, all, 1>>(all);
    auto const z = dual_jet_at<n, N>(at);
    auto const V = draw_tangents<S, all, n + 1>(draw);
    auto const W = draw_tangents<S, all, n + 2>(draw);
    auto const volume_form = []<class T, int E>(Matrix<T, E, 1> const&, Tangents<T, E, n + 1> const& U) -> T {
      return determinant(Matrix<T, n + 1, n + 1>(U.template topRows<n + 1>()));
    };
    auto const dy = [](int a) { return differential_of_coordinate(n + 1 + a); };
    auto const dp = [](int a, int mu) { return differential_of_coordinate(n + 2 + N + N * mu + a); };
    S theta = z.Pi * volume_form(at, V), omega(0), swapped(0);
    S const last = wedge(differential_of_coordinate(n + 1 + N), volume_form)(at, W);
    for (int mu = 0; mu <= n; ++mu)
      for (int a = 0; a < N; ++a) {
        auto const below = contracted_volume_above<n>(mu);
        theta += z.p(a, mu) * wedge(dy(a), below)(at, V);
        omega += wedge(dy(a), wedge(dp(a, mu), below))(at, W);
        swapped += wedge(dp(a, mu), wedge(dy(a), below))(at, W);
      }
    auto const measured = canonical_two_form<n, N>()(at, W);
    claim.equal("Theta in coordinates", model, canonical_form<n, N>()(at, V), theta);
    claim.equal("Omega = -dTheta in coordinates", model, measured, S(omega - last));
    // Pulled back from the bundle of all (n+1)-forms on Y, where Theta_Lambda is z of the vectors below.
    auto const from_all = [&](bool signs) {
      return pull_back(inclusion<n, N>(signs), form_of_all<n, N>())(at, V);
    };
    claim.equal("Theta from Theta_Lambda", model, from_all(true), theta);
    claim.differs("dx^0 ^ ... with x^mu left out, without its sign", model, from_all(false), theta);
    claim.equal("Omega from Omega_Lambda", model,
                S(-pull_back(inclusion<n, N>(), exterior_derivative(form_of_all<n, N>()))(at, W)), measured);
    claim.differs("with + dPi ^ d^{n+1}x", model, measured, S(omega + last));
    claim.differs("dp ^ dy in place of dy ^ dp", model, measured, S(swapped - last));
    // As an affine map on jets: pull z back by the linear map that a jet is.
    auto j = draw_jet<S, n, N>(draw);
    j.x = z.x, j.y = z.y;
    Matrix<S, all, n + 1> lifted = Matrix<S, all, n + 1>::Zero();
    lifted.template topRows<n + 1>().setIdentity();
    lifted.template middleRows<N>(n + 1) = j.v;
    claim.equal("value on a jet", model, canonical_form<n, N>()(at, lifted), pairing(z, j));
    // Two vertical vectors of Y in its slots.
    auto U = V;
    U.template leftCols<2>().template topRows<n + 1>().setZero();
    claim.zero("two vertical vectors", model, canonical_form<n, N>()(at, U), theta);
    // With one coordinate of space there is no such form.
    if constexpr (N > 1) {
      auto const rest = []<class T, int E>(Matrix<T, E, 1> const&,
                                           [[maybe_unused]] Tangents<T, E, n - 1> const& X) -> T {
        if constexpr (n == 1)
          return T(1);
        else
          return determinant(Matrix<T, n - 1, n - 1>(X.template topRows<n - 1>()));
      };
      claim.refutes("two vertical vectors in a form with dy ^ dy", model,
                    wedge(dy(0), wedge(dy(N - 1), rest))(at, U), theta);
    }
  });
}

namespace {

/// The coefficients \f$\Pi\f$ and \f$p_a{}^\mu\f$ of an (n+1)-form on Y at a point, read off coordinate
/// vectors: \f$z(\partial_0,\dots,\partial_n)\f$, and with \f$\partial/\partial y^a\f$ in place of
/// \f$\partial_\mu\f$.
template <int n, int N, class S, class Form>
DualJet<S, n, N> read_off(Form const& z, Matrix<S, n + 1 + N, 1> const& point) {
  Tangents<S, n + 1 + N, n + 1> V = Tangents<S, n + 1 + N, n + 1>::Zero();
  V.template topRows<n + 1>().setIdentity();
  DualJet<S, n, N> read{point.template head<n + 1>(), point.template tail<N>(), z(point, V), {}};
  for (int mu = 0; mu <= n; ++mu)
    for (int a = 0; a < N; ++a) {
      auto U = V;
      U.col(mu) = Matrix<S, n + 1 + N, 1>::Unit(n + 1 + a);
      read.p(a, mu) = z(point, U);
    }
  return read;
}

/// The coefficient of \f$\gamma^*z\f$ for a jet \f$\gamma\f$ over the point.
template <class S, int n, int N, class Form>
S value_on(Form const& z, Jet<S, n, N> const& j) {
  Tangents<S, n + 1 + N, n + 1> gamma;
  gamma << Matrix<S, n + 1, n + 1>::Identity(), j.v;
  return z(point_of(j), gamma);
}

}  // namespace

STATEMENT(claim_6_1_dual_jet_bundle_unique, "forms of the dual jet bundle are written uniquely") {
  claim.holds(
      "Every $(n+1)$-form that two vertical vectors annihilate has one pair $\\Pi$, $p_a{}^\\mu$, and is "
      "known by its values on jets; equal coordinates in one chart are equal coordinates in all.");
  // Products of at most four drawn columns and a coefficient. An elimination in nine unknowns at most.
  over_dimensions(
      std::tuple<Dimensions<1, 2>, Dimensions<2, 2>, Dimensions<3, 1>>{},
      [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
        constexpr int Y = n + 1 + N, all = coefficients<n, N>, affine = 1 + N * (n + 1);
        using Point = Matrix<S, Y, 1>;
        // Any (n+1)-form at a point of Y, by its coefficients; and the sets of its differentials.
        auto const c = draw.vector<S, Matrix<S, all, 1>>(all);
        auto const form = [](Matrix<S, all, 1> const& z) {
          return [z]<class T, int E>(Matrix<T, E, 1> const& y, Tangents<T, E, n + 1> const& V) -> T {
            Matrix<T, Y + all, 1> at;
            at << y, z.template cast<T>();
            return form_of_all<n, N>()(at, V);
          };
        };
        auto j = draw_jet<S, n, N>(draw);
        Point const point = point_of(j);
        auto const sets = increasing<n + 1>(Y);
        // v hook w hook z for all pairs of vertical coordinate vectors, as a linear map of z.
        auto in_Z = c;
        Matrix<S, Dynamic, Dynamic> conditions(all, all);
        conditions.setZero();
        for (int k = 0; k < all; ++k) {
          Tangents<S, Y, n + 1> V = Tangents<S, Y, n + 1>::Zero();
          for (int r = 0; r <= n; ++r) V(sets[k][n - r], r) = S(1);  // the vertical ones first
          if (vertical_in<n>(sets[k]) < 2) continue;
          in_Z[k] = S(0);
          for (int z = 0; z < all; ++z) conditions(k, z) = form(Matrix<S, all, 1>::Unit(z))(point, V);
        }
        claim.fact("dimension 1 + N(n + 1) of what they annihilate", model,
                   all - matrix_rank(conditions) == affine);
        claim.zero("the forms without two vertical differentials are those", model,
                   Matrix<S, Dynamic, 1>(conditions * in_Z), magnitude(c));
        // Existence and uniqueness of the coordinates.
        auto const V = draw_tangents<S, Y, n + 1>(draw);
        auto const written = read_off<n, N, S>(form(in_Z), point), of_any = read_off<n, N, S>(form(c), point);
        S const value = form(in_Z)(point, V);
        claim.equal("z is Pi d^{n+1}x + p dy ^ d^nx", model, value,
                    affine_form<n, N>(written.p, written.Pi, point, V));
        auto const q = draw.vector<S, Matrix<S, DualJet<S, n, N>::dimension, 1>>(DualJet<S, n, N>::dimension);
        auto const other = dual_jet_at<n, N>(q);
        auto const again = read_off<n, N, S>(
            [&](Point const& y, Tangents<S, Y, n + 1> const& U) {
              return affine_form<n, N>(other.p, other.Pi, y, U);
            },
            point);
        claim.equal("the coordinates of such a sum are those it is made of", model, again.p, other.p);
        claim.equal("and its Pi", model, again.Pi, other.Pi);
        // From the values on as many jets as there are coordinates.
        Matrix<S, affine, affine> jets;
        Matrix<S, affine, 2> values;
        for (int k = 0; k < affine; ++k) {
          j.v = draw_tangents<S, N, n + 1>(draw);
          jets(k, 0) = S(1);
          for (int i = 0; i < N * (n + 1); ++i) jets(k, 1 + i) = j.v(i % N, i / N);
          values(k, 0) = value_on(form(in_Z), j), values(k, 1) = value_on(form(c), j);
        }
        auto const solved = solve_linear(jets, values, "claim_6_1_dual_jet_bundle_unique");
        Matrix<S, affine, 1> coordinates_of_z;
        coordinates_of_z[0] = written.Pi;
        for (int i = 0; i < N * (n + 1); ++i) coordinates_of_z[1 + i] = written.p(i % N, i / N);
        // The condition of an elimination with drawn coefficients.
        claim.equal("the affine map on jets has the same coordinates", model,
                    Matrix<S, affine, 1>(solved.col(0)), coordinates_of_z, 1000);
        if constexpr (N > 1) {
          claim.differs("a form with two vertical differentials as such a sum", model, form(c)(point, V),
                        affine_form<n, N>(of_any.p, of_any.Pi, point, V));
          claim.differs("a form with two vertical differentials is affine on jets", model,
                        Matrix<S, affine, 1>(solved.col(1)), coordinates_of_z);
        }
        // In other charts: the form moved, the jet moved, and the volume of space-time between them.
        BundleMap<S, n, N> change(draw);
        auto const moved_form = pull_back([&](auto const& y) { return change.inverse(y); }, form(in_Z));
        Point const there = change(point);
        auto const in_charts = read_off<n, N, S>(moved_form, there);
        claim.equal("such a sum in other charts as well", model, moved_form(there, V),
                    affine_form<n, N>(in_charts.p, in_charts.Pi, there, V), 10);
        Tangents<S, Y, n + 1> gamma;
        gamma << Matrix<S, n + 1, n + 1>::Identity(), j.v;
        Tangents<S, Y, n + 1> const pushed_forward = pushed(change, point, gamma);
        Matrix<S, n + 1, n + 1> const base = pushed_forward.template topRows<n + 1>();
        auto moved_jet = j;
        moved_jet.v = pushed_forward.template bottomRows<N>() * inverse_matrix(base);
        S const there_value = pairing(in_charts, moved_jet), here_value = value_on(form(in_Z), j);
        claim.equal("value on a jet in other charts", model, S(there_value * determinant(base)), here_value,
                    10);
        claim.differs("without the volume of the new coordinates", model, there_value, here_value);
      });
}

// ----
// Section 6.1: two metrics, the deformation tensors and the Jacobian.

namespace {

/// A motion, frozen at a time.
template <class Phi, class S>
struct Deformation {
  Phi phi;
  S time;
  template <class T, int n>
  auto operator()(Matrix<T, n, 1> const& x) const {
    Event<T, n> event;
    event << T(time), x;
    return phi(event);
  }
};

/// Two metrics, a motion that solves nothing, and what they are at a point.
template <class S, int n, int N>
struct TwoMetrics {
  AnyMetric<S, n> body;
  AnyMetric<S, N> space;
  AnySection<S, n, N> phi;
  Jet<S, n, N> j;
  Matrix<S, n, 1> x;
  Matrix<S, n, n> G;
  Matrix<S, N, N> g;
  Matrix<S, N, n> F;

  explicit TwoMetrics(Draw& draw)
      : body(draw_metric<S, n>(draw)),
        space(draw_metric<S, N>(draw)),
        phi(draw_section<S, n, N>(draw)),
        j(first_jet(phi, draw_event<S, n>(draw))),
        x(j.particle()),
        G(body(x)),
        g(space(j.y)),
        F(j.gradient()) {}

  auto deformation() const { return Deformation<AnySection<S, n, N>, S>{phi, j.x[0]}; }
};

/// A metric as a form that takes two vectors: it may be pulled back.
template <class Metric>
auto as_form(Metric const& g) {
  return [g]<class S, int D>(Matrix<S, D, 1> const& at, Tangents<S, D, 2> const& V) -> S {
    Matrix<S, D, 1> const u = V.col(0), w = V.col(1);
    return inner(Matrix<S, D, D>(g(at)), u, w);
  };
}
/// All components of such a form at a point.
template <class Form, class S, int n>
Matrix<S, n, n> matrix_of(Form const& form, Matrix<S, n, 1> const& x) {
  Matrix<S, n, n> m;
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k) {
      Tangents<S, n, 2> V = Tangents<S, n, 2>::Zero();
      V(i, 0) = S(1), V(k, 1) = S(1);
      m(i, k) = form(x, V);
    }
  return m;
}

/// The volume form of a metric.
template <class Metric>
auto volume_form(Metric const& g) {
  return [g]<class S, int n>(Matrix<S, n, 1> const& at, Tangents<S, n, n> const& V) -> S {
    return volume<S>(g(at).eval()) * determinant(V);
  };
}

/// An invertible matrix near the identity.
template <class S, int n>
Matrix<S, n, n> draw_matrix(Draw& draw) {
  Matrix<S, n, n> m = Matrix<S, n, n>::Identity();
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k) m(i, k) += draw.number<S>() * ratio<S>(1, 4);
  return m;
}

}  // namespace

STATEMENT(eq_6_1, "Jacobian as a function on the first jet bundle") {
  claim.convention(
      "$[v]$ is the square block $v^a{}_j$, $n = N$: with the velocity it is $n$ by $n + 1$ and has no "
      "determinant. The metric of space is taken at the point of space, that of the body at the particle.");
  // Frames of degree 13 in a section of degree 6, two determinants of them.
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    TwoMetrics<S, n, n> const m(draw);
    Tangents<S, n, n> const all = Tangents<S, n, n>::Identity();
    S const J = jacobian(m.G, m.g, m.F), pulled = pull_back(m.deformation(), volume_form(m.space))(m.x, all),
            here = volume_form(m.body)(m.x, all);
    claim.equal("pulled-back volume form", model, pulled, S(J * here));
    claim.differs("without the root", model, pulled,
                  S(determinant(m.F) * determinant(m.g) / determinant(m.G) * here));
    claim.differs("both metrics at the particle", model, pulled,
                  S(jacobian(m.G, Matrix<S, n, n>(m.space(m.x)), m.F) * here));
  });
}

STATEMENT(eq_6_2, "Green and Finger deformation tensors in coordinates") {
  claim.holds(
      "$g$ is taken at the point of space, $G$ at the particle; $C$ is defined whether or not the "
      "deformation is regular, $c$ where $n = N$ and $F$ has an inverse.");
  over_dimensions(std::tuple<Dimensions<2, 2>, Dimensions<3, 3>, Dimensions<1, 3>>{},
                  [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
                    TwoMetrics<S, n, N> const m(draw);
                    Matrix<S, n, n> sum = Matrix<S, n, n>::Zero(), elsewhere = sum;
                    auto const there = m.space(Matrix<S, N, 1>(Matrix<S, N, 1>::Zero()));
                    for (int i = 0; i < n; ++i)
                      for (int k = 0; k < n; ++k)
                        for (int a = 0; a < N; ++a)
                          for (int b = 0; b < N; ++b) {
                            sum(i, k) += m.g(a, b) * m.F(a, i) * m.F(b, k);
                            elsewhere(i, k) += there(a, b) * m.F(a, i) * m.F(b, k);
                          }
                    claim.equal("C in coordinates", model, green_tensor(m.g, m.F), sum);
                    claim.differs("C with the metric of another place", model, green_tensor(m.g, m.F),
                                  elsewhere);
                    if constexpr (n == N) {
                      // c measures moved vectors as G measures them before: it needs no inverse to say so.
                      auto const c = inverse_finger_tensor(m.G, m.F);
                      // An inverse of F: the allowance is ten times that of plain evaluation.
                      claim.equal("c of moved vectors", model, pulled_back(c, m.F), m.G, 10);
                      Matrix<S, n, n> const inverse = inverse_matrix(m.F);
                      claim.differs("indices of the inverse exchanged", model, c,
                                    pulled_back(m.G, Matrix<S, n, n>(inverse.transpose())));
                      auto flat = m.F;
                      flat.col(n - 1) = flat.col(0);
                      claim.zero("C of a flat deformation has no inverse", model,
                                 determinant(green_tensor(m.g, flat)), determinant(m.g));
                      claim.template refuses<Singular>("c of a flat deformation", model,
                                                       [&] { inverse_finger_tensor(m.G, flat); });
                    }
                  });
}

STATEMENT(claim_6_1_green_tensor, "Green tensor as a pulled-back metric") {
  claim.holds();
  over_dimensions(std::tuple<Dimensions<2, 2>, Dimensions<3, 3>, Dimensions<1, 3>>{},
                  [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
                    TwoMetrics<S, n, N> const m(draw);
                    auto const pulled = matrix_of(pull_back(m.deformation(), as_form(m.space)), m.x);
                    claim.equal("C equals the pull-back of g", model, green_tensor(m.g, m.F), pulled);
                    if constexpr (n == N)
                      claim.differs("F g F^T", model, Matrix<S, n, n>(m.F * m.g * m.F.transpose()), pulled);
                    // A measurement of lengths by the body's own metric is another tensor.
                    claim.differs("G in place of C", model, m.G, pulled);
                  });
}

STATEMENT(claim_6_1_finger_tensor, "inverse Finger tensor as a pushed-forward metric") {
  claim.holds(
      "The inverse is that of mixed tensors, or of $c_{ab}$ and $b^{ab}$; lowering both indices of $b$ "
      "with $g$ does not invert the matrix of $c$.");
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    // Draw the inverse of a deformation, which takes points of space to particles: the push-forward by the
    // one is the pull-back by the other.
    TwoMetrics<S, n, n> const m(draw);
    Matrix<S, n, 1> const y = m.x, x = m.j.y;
    auto const pushed_forward = matrix_of(pull_back(m.deformation(), as_form(m.space)), y);
    Matrix<S, n, n> const F = inverse_matrix(m.F), G = m.space(x), g = m.body(y);
    auto const c = inverse_finger_tensor(G, F);
    // Two inverses: the allowance is ten times that of plain evaluation.
    claim.equal("c equals the push-forward of G", model, c, pushed_forward, 10);
    Matrix<S, n, n> const b = F * inverse_matrix(G) * F.transpose(), unit = Matrix<S, n, n>::Identity();
    claim.equal("b^{ab}c_{bd} is the identity", model, Matrix<S, n, n>(b * c), unit, 10);
    claim.equal("as mixed tensors", model, Matrix<S, n, n>(b * g * (inverse_matrix(g) * c)), unit, 10);
    claim.differs("with both indices of b lowered by g", model, Matrix<S, n, n>(g * b * g * c), unit);
    claim.template refuses<Singular>("a deformation without an inverse", model,
                                     [&] { inverse_finger_tensor(G, Matrix<S, n, n>(F * S(0))); });
  });
}

STATEMENT(claim_6_1_sharp_of_pullback, "index raising and pull-back of the spatial metric compared") {
  claim.convention(
      "They differ for a general deformation; they agree exactly where the "
      "deformation is an isometry, $C = G$.");
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    using M = Matrix<S, n, n>;
    TwoMetrics<S, n, n> const m(draw);
    M const C = green_tensor(m.g, m.F), Finv = inverse_matrix(m.F),
            pulled = Finv * inverse_matrix(m.g) * Finv.transpose();
    auto const sharp = [&](M const& G) { return M(inverse_matrix(G) * C * inverse_matrix(G)); };
    // Inverses of three matrices near the identity.
    claim.equal("the pull-back of g^# is the inverse of C", model, M(pulled * C), M(M::Identity()), 10);
    M const mixed = inverse_matrix(m.G) * C;
    claim.equal("their difference is that of (G^{-1}C)^2 and 1", model, M((sharp(m.G) - pulled) * C),
                M(mixed * mixed - M::Identity()), 10);
    // The sum of two positive definite matrices has an inverse, so the square is 1 for C = G alone.
    M const sum = mixed + M::Identity();
    claim.equal("(G^{-1}C)^2 - 1 is a multiple of G^{-1}C - 1 with an inverse", model,
                M((mixed * mixed - M::Identity()) * inverse_matrix(sum)), M(mixed - M::Identity()), 10);
    claim.equal("they agree for an isometry", model, sharp(C), pulled, 10);
    claim.differs("they agree for any deformation", model, sharp(m.G), pulled);
  });
}

STATEMENT(claim_6_1_jacobian_scalar, "Jacobian of a section under coordinate changes") {
  claim.convention(
      "Charts of body and space are to keep the orientation: a reflection changes the sign of "
      "$\\det F$ and not of the roots.");
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    using M = Matrix<S, n, n>;
    TwoMetrics<S, n, n> const m(draw);
    // Derivatives of the old coordinates by the new ones, on the body and in space.
    M const body = draw_matrix<S, n>(draw), space = draw_matrix<S, n>(draw);
    draw_positive(S(determinant(body))), draw_positive(S(determinant(space)));
    auto const in_charts = [&](M const& K, M const& A) {
      return jacobian(M(pulled_back(m.G, K)), M(pulled_back(m.g, A)), M(inverse_matrix(A) * m.F * K));
    };
    S const J = jacobian(m.G, m.g, m.F);
    M reflected = space;
    reflected.col(0) = -space.col(0);
    // Two inverses.
    claim.equal("same number in other charts", model, in_charts(body, space), J, 10);
    claim.equal("opposite in a reflected chart", model, in_charts(body, reflected), S(-J), 10);
    claim.differs("same in a reflected chart", model, in_charts(body, reflected), J);
    claim.differs("det F alone", model, determinant(M(inverse_matrix(space) * m.F * body)), determinant(m.F));
    // In orthonormal frames, \f$G = A^TA\f$, it is the determinant of the linear map alone.
    draw_positive(S(determinant(m.space.frame(m.j.y)))), draw_positive(S(determinant(m.body.frame(m.x))));
    M const frames = m.space.frame(m.j.y) * m.F * inverse_matrix(m.body.frame(m.x));
    claim.equal("determinant in orthonormal frames", model, determinant(frames), J, 10);
  });
}

namespace {

/// A turn of the first two coordinates, by twice the angle whose tangent is s.
template <class S, int n>
Matrix<S, n, n> turn(S const& s) {
  S const norm = S(1) / (S(1) + s * s), c = (S(1) - s * s) * norm, sine = S(2) * s * norm;
  Matrix<S, n, n> R = Matrix<S, n, n>::Identity();
  R(0, 0) = R(1, 1) = c, R(1, 0) = sine, R(0, 1) = -sine;
  return R;
}

/// A motion that begins at the identity, or with the first coordinate reflected, and is regular: a strain
/// that grows, turned by up to 150 degrees.
template <class S, int n>
struct FarMotion {
  AnySection<S, n, n> later;
  S start;  ///< 1, or -1 for the reflection
  template <class X>
  auto operator()(X const& x) const {
    using T = ScalarOf<X>;
    Matrix<T, n, 1> const end = later(x);
    Matrix<T, n, 1> y = x.template tail<n>();
    for (int a = 0; a < n; ++a) y[a] += x[0] * (end[a] - y[a]);
    y[0] *= T(start);
    return Matrix<T, n, 1>(turn<T, n>(T(x[0] * T(4))) * y);
  }
};

/// A motion that is flat at t = 1/2 and comes out reflected.
struct ThroughFlat {
  template <class X>
  auto operator()(X const& x) const {
    using T = ScalarOf<X>;
    constexpr int n = X::RowsAtCompileTime - 1;
    Matrix<T, n, 1> y = x.template tail<n>();
    y[0] *= T(1) - x[0] * T(2);
    return y;
  }
};

/// J > 0 along whole motions, decided in balls: for all times from 0 to 1, and in the plane for all particles
/// of a square.
template <class S, int n>
struct PositiveJacobians {
  AnyMetric<S, n> body, space;
  FarMotion<S, n> far, reflected;
  Matrix<S, n, 1> particle;

  explicit PositiveJacobians(Draw draw)
      : body(mild(draw)),
        space(mild(draw)),
        far{draw_section<S, n, n>(draw, ratio<S>(1, 8)), S(1)},
        reflected{far.later, S(-1)},
        particle(draw.vector<S, Matrix<S, n, 1>>(n) * ratio<S>(1, 8)) {}
  /// A metric that has an inverse wherever the motion goes.
  static AnyMetric<S, n> mild(Draw& draw) {
    auto g = draw_metric<S, n>(draw);
    S const half = ratio<S>(1, 2);
    g.constant = (g.constant + Matrix<S, n, n>::Identity()) * half;
    for (auto& slope : g.slope) slope *= half;
    g.bend *= half;
    return g;
  }
  /// The determinant, by all of its products: balls are not asked whether an entry is zero.
  static S without_questions(Matrix<S, n, n> const& m) {
    S sum(0);
    for (int i = 0; i < n; ++i) {
      int const k = (i + 1) % n, l = (i + 2) % n;
      if constexpr (n == 2)
        sum += m(0, i) * m(1, k) * S(i == 0 ? 1 : -1);
      else
        sum += m(0, i) * (m(1, k) * m(2, l) - m(1, l) * m(2, k));
    }
    return sum;
  }
  /// J > 0, or of the hypothesis \f$(\det F)^2 > 0\f$, at all times.
  template <class Phi>
  Enclosure decide(Phi const& phi, bool hypothesis) const {
    auto const value = [&](Vector<S> const& box) {
      Event<S, n> event;
      for (int i = 0; i <= n; ++i) event[i] = i < box.size() ? box[i] : particle[i - 1];
      auto const j = first_jet(phi, event);
      S const det = without_questions(j.gradient());
      if (hypothesis) return S(det * det);
      return S(det * square_root(without_questions(space(j.y))) /
               square_root(without_questions(body(j.particle()))));
    };
    Vector<S> box(n == 2 ? 3 : 1);
    box[0] = S::between(S(0), S(1));
    for (Index i = 1; i < box.size(); ++i) box[i] = S::between(ratio<S>(-1, 8), ratio<S>(1, 8));
    return positive_on(value, box);
  }
};

template <class S>
void positive_jacobians(Claim<S>& claim, Draw const& draw) {
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    auto const decide = [&](auto const& which, bool hypothesis) {
      return [&draw, &which, hypothesis] {
        PositiveJacobians<S, n> const m(draw);
        return m.decide(which(m), hypothesis);
      };
    };
    auto const far = [](auto const& m) { return m.far; };
    auto const reflected = [](auto const& m) { return m.reflected; };
    auto const flat = [](auto const&) { return ThroughFlat{}; };
    claim.encloses("hypothesis: det F does not vanish along the motion", model, decide(far, true));
    claim.encloses("J > 0 along the motion", model, decide(far, false));
    claim.encloses("det F does not vanish along a motion that begins as a reflection", model,
                   decide(reflected, true));
    claim.refutes_enclosure("J > 0 along that one", model, decide(reflected, false));
    claim.refutes_enclosure("det F does not vanish along a motion that is flat once", model,
                            decide(flat, true));
    claim.refutes_enclosure("J > 0 along that one, hypothesis broken", model, decide(flat, false));
  });
}

}  // namespace

STATEMENT(claim_6_1_initial_jacobian,
          "Jacobian of a regular motion at and after the identity configuration") {
  claim.corrected("J(x,0) = 1", "J(x,0) = \\sqrt{\\det g(x)/\\det G(x)}",
                  "It is 1 where the two metrics have the same volume, as for a fluid in its container. "
                  "That $J$ stays positive for a regular motion is right in either case: decided for all "
                  "times of motions that turn by up to 150 degrees.");
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    TwoMetrics<S, n, n> const m(draw);
    auto const motion = [&m]<class T>(Event<T, n> const& x) {
      auto const later = m.phi(x);
      Matrix<T, n, 1> y;
      for (int a = 0; a < n; ++a) y[a] = x[a + 1] + x[0] * (later[a] - x[a + 1]);
      return y;
    };
    auto const J = [&](auto const& body, auto const& phi, S const& t) {
      Event<S, n> event;
      event << t, m.x;
      auto const j = first_jet(phi, event);
      return jacobian(Matrix<S, n, n>(body(m.x)), Matrix<S, n, n>(m.space(j.y)),
                      Matrix<S, n, n>(j.gradient()));
    };
    S const start = J(m.body, motion, S(0)), ratio_of_volumes = modulus(S(determinant(m.space.frame(m.x)))) /
                                                                modulus(S(determinant(m.body.frame(m.x))));
    claim.equal("square root of the ratio of determinants", model, start, ratio_of_volumes);
    claim.differs("printed: 1", model, start, S(1));
    claim.equal("1 where the metrics are the same", model, J(m.space, motion, S(0)), S(1));
  });
  positive_jacobians(claim, draw);
}

STATEMENT(claim_6_1_metrics_cancel, "where the metrics of body and space may be left out") {
  claim.convention(
      "That $g(y)$ and $G(x)$ differ unless $y = x$ or the metric is constant is meant for motions in "
      "general: where the metric does not depend on a coordinate, a motion along it has $g(y) = G(x)$ "
      "as well. With a constant metric determinants and derivatives drop; indices move trivially "
      "where its matrix is the identity.");
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    using M = Matrix<S, n, n>;
    using Column = Matrix<S, n, 1>;
    TwoMetrics<S, n, n> const m(draw);
    M const here = m.space(m.x);
    claim.equal("J for one metric, y = x", model, jacobian(here, here, m.F), determinant(m.F));
    auto const constant = draw_constant_metric<S, n>(draw);
    claim.equal("J for one constant metric", model, jacobian(constant(m.x), constant(m.j.y), m.F),
                determinant(m.F));
    claim.differs("J for one metric and any motion, with the metrics cancelled", model,
                  jacobian(here, m.g, m.F), determinant(m.F));
    claim.differs("g(y) and G(x) for any motion", model, m.g, here);
    // A metric that the first coordinate does not enter, and a motion along it.
    auto uniform = m.space;
    uniform.slope[0].setZero(), uniform.bend.row(0).setZero(), uniform.bend.col(0).setZero();
    Column along = m.x;
    along[0] += draw.number<S>() + S(2);
    claim.equal("g(y) and G(x) for a motion along a coordinate without effect", model, uniform(along),
                uniform(m.x));
    claim.differs("that metric is constant", model, uniform(m.j.y), uniform(m.x));
    // Field equations of a fluid, with metrics and with all of them dropped.
    auto const mass = draw_mass<S, n>(draw);
    auto const fluid = draw_fluid<S>(draw);
    auto const j = second_jet(m.phi, m.j.x);
    auto const equations = [&](auto const& g) {
      return Column(euler_lagrange(Continuum{g, g, mass, fluid}, j));
    };
    Column const dropped = equations(Euclidean<n>{}), inertia = j.acceleration() * mass(m.x);
    AnyMetric<S, n> cartesian = m.space;
    for (auto& slope : cartesian.slope) slope.setZero();
    cartesian.bend.setZero();
    cartesian.constant = turn<S, n>(draw.number<S>());
    // Each equation is a difference of terms of the size of the inertia and of the pressure.
    S const scale = magnitude(dropped) + magnitude(inertia);
    claim.zero("field equations in Cartesian coordinates, all dropped", model,
               Column(equations(cartesian) - dropped), scale, 10);
    // With a constant metric the force is the same; the momentum is lowered by it.
    Column const per_volume = equations(constant) / volume<S>(constant(m.x)),
                 lowered_inertia = constant(m.x) * inertia;
    claim.zero("with a constant metric, determinants and derivatives dropped", model,
               Column(per_volume + lowered_inertia - dropped - inertia),
               S(scale + magnitude(lowered_inertia)), 10);
    claim.refutes("with a constant metric, indices moved trivially", model, Column(per_volume - dropped),
                  scale);
    claim.refutes("with a metric that varies, all dropped", model, Column(equations(m.space) - dropped),
                  scale);
  });
}
