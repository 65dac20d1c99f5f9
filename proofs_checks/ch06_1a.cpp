// Scalars: rational (long: double)
// Section 6.1: the jet bundle, the dual jet bundle and their forms.
#include "fields.hpp"

#include "statement.hpp"
#include "variations.hpp"

namespace {

using namespace actio;
using namespace actio::checks;

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
    return [this, phi]<class T>(Eigen::Matrix<T, n + 1, 1> const& x) {
      Event<T, n> const there = before(x);
      Eigen::Matrix<T, n + 1 + N, 1> point;
      point << there, phi(there);
      Eigen::Matrix<T, N, 1> y;
      for (int a = 0; a < N; ++a) y[a] = place[a](point);
      return y;
    };
  }
  /// The derivatives \f$(\psi_{,x} + \psi_{,y}v)\,\partial x/\partial x'\f$ in the new charts; the factors that are not asked for are left out.
  Eigen::Matrix<S, N, n + 1> transformed(Jet<S, n, N> const& j, Event<S, n> const& x, bool with_base = true, bool with_shift = true) const {
    Eigen::Matrix<S, n + 1 + N, n + 1> lifted;
    lifted << Eigen::Matrix<S, n + 1, n + 1>::Identity(), j.v;
    if (!with_shift) lifted.template topRows<n + 1>().setZero();
    auto const psi = [this]<class T>(Eigen::Matrix<T, n + 1 + N, 1> const& point) {
      Eigen::Matrix<T, n + 1 + N, 1> y = Eigen::Matrix<T, n + 1 + N, 1>::Zero();
      for (int a = 0; a < N; ++a) y[a] = place[a](point);
      return y;
    };
    Eigen::Matrix<S, N, n + 1> const v = pushed(psi, point_of(j), lifted).template topRows<N>();
    auto const base = [this]<class T>(Event<T, n> const& u) { return before(u); };
    Eigen::Matrix<S, n + 1, n + 1> const square = Eigen::Matrix<S, n + 1, n + 1>::Identity();
    if (!with_base) return v;
    return v * pushed(base, x, square);
  }
};

/// \f$\partial_\mu\lrcorner\,d^{n+1}x\f$ as a form.
template <class S, int n>
auto contracted_volume(int mu) {
  Event<S, n> const unit = Event<S, n>::Unit(mu);
  return contract(ConstantField<S, n + 1>{unit}, []<class T, int k>(Eigen::Matrix<T, n + 1, 1> const&, Tangents<T, n + 1, k> const& V) -> T {
    static_assert(k == n + 1);
    return determinant(V);
  });
}

/// \f$d^nx_\mu\f$ on a bundle over space-time: coordinates of space-time come first.
template <int n>
auto contracted_volume_above(int mu) {
  return [mu]<class T, int D>(Eigen::Matrix<T, D, 1> const&, Tangents<T, D, n> const& V) -> T {
    Event<T, n> const x = Event<T, n>::Zero();
    Tangents<T, n + 1, n> const below = V.template topRows<n + 1>();
    return contracted_volume<Base<T>, n>(mu)(x, below);
  };
}

}  // namespace

STATEMENT(claim_6_1_jet_bundle, "coordinates of the configuration bundle and its first jets") {
  claim.corrected("y^a,\\ i = 1,\\dots,N", "y^a,\\ a = 1,\\dots,N",
                  "The index that is named is not the one that is used. Changes of charts act on the fibres of the jet bundle affinely, not linearly, wherever they mix space-time into the places.");
  claim.maybe_scan();
  // Jets of degree 6 in polynomials of second degree.
  claim.degree(40);
  over_points<S>(SmallDimensions{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = D::N;
    BundleCharts<S, n, N> const charts(draw);
    Event<S, n> const x = draw_event<S, n>(draw), at = charts.before(x);
    auto const phi = draw_section<S, n, N>(draw), psi = draw_section<S, n, N>(draw);
    auto j = first_jet(phi, at);
    Eigen::Matrix<S, N, n + 1> const v = first_jet(charts.section(phi), x).v;
    claim.equal("jet in other charts", model, v, charts.transformed(j, x));
    claim.differs("without the change of space-time", model, v, charts.transformed(j, x, false));
    claim.differs("as if places did not depend on space-time", model, v, charts.transformed(j, x, true, false));
    // Two jets over one place and a point on the line through them.
    Eigen::Matrix<S, N, n + 1> const w = first_jet(psi, at).v;
    S const s = draw.number<S>();
    auto const moved = [&](Eigen::Matrix<S, N, n + 1> const& slope) {
      j.v = slope;
      return charts.transformed(j, x);
    };
    auto const from = moved(v), to = moved(w);
    claim.equal("transition maps are affine in v", model, moved(v * (S(1) - s) + w * s), Eigen::Matrix<S, N, n + 1>(from * (S(1) - s) + to * s));
    claim.differs("transition maps are linear in v", model, moved(v + w), Eigen::Matrix<S, N, n + 1>(from + to));
    claim.fact("dimension n + 1 + N + N(n + 1)", model, coordinates(j).size() == n + 1 + N + N * (n + 1));
    if (n != N) claim.differs("as many places as the index i has values", model, S(coordinates(j).size()), S(n + 1 + n + n * (n + 1)));
  });
}

STATEMENT(claim_6_1_contracted_volume, "n-forms obtained from the volume form on space-time") {
  claim.convention("$d^nx_\\mu$ is the contraction of $d^{n+1}x$ with the coordinate field along $x^\\mu$: the hook between the two is not printed.");
  claim.maybe_scan();
  // Determinants of up to four drawn columns.
  claim.degree(8);
  over_points<S>(std::tuple<Dimensions<1, 1>, Dimensions<2, 2>, Dimensions<3, 3>>{}, [&]<class D>(D, std::string const&) {
    constexpr int n = D::n;
    std::string const model = "n = " + std::to_string(n);
    auto const x = draw_event<S, n>(draw);
    auto const V = draw_tangents<S, n + 1, n + 1>(draw);
    auto const sides = draw_tangents<S, n + 1, n>(draw);
    for (int mu = 0; mu <= n; ++mu) {
      auto const below = contracted_volume<S, n>(mu);
      for (int nu = 0; nu <= n; ++nu)
        claim.zero("dx^nu ^ d^nx_mu", model, S(wedge(differential_of_coordinate(nu), below)(x, V) - (mu == nu ? determinant(V) : S(0))), determinant(V));
      // The determinant of the other rows, in their order, with the sign of the place that is left out.
      Eigen::Matrix<S, n, n> rows;
      for (int r = 0, to = 0; r <= n; ++r)
        if (r != mu) rows.row(to++) = sides.row(r);
      S const product = determinant(rows);
      claim.equal("(-1)^mu times the product of the other differentials", model, below(x, sides), mu % 2 == 0 ? product : S(-product));
      if (mu % 2 == 1) claim.differs("without the sign", model, below(x, sides), product);
      // Read as a derivative along x^mu of the volume form, it is nothing: the coefficient is constant.
      claim.differs("as a derivative of the volume form", model, below(x, sides), S(0));
    }
  });
}

STATEMENT(claim_6_1_canonical_forms, "canonical forms on the dual jet bundle in coordinates") {
  claim.holds();
  // Products of at most five drawn columns and a coordinate.
  claim.degree(16);
  over_points<S>(std::tuple<Dimensions<2, 2>, Dimensions<1, 2>>{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = D::N, all = DualJet<S, n, N>::dimension;
    Eigen::Matrix<S, all, 1> const at = draw.vector<S, Eigen::Matrix<S, all, 1>>(all);
    auto const z = dual_jet_at<n, N>(at);
    auto const V = draw_tangents<S, all, n + 1>(draw);
    auto const W = draw_tangents<S, all, n + 2>(draw);
    auto const volume_form = []<class T, int E>(Eigen::Matrix<T, E, 1> const&, Tangents<T, E, n + 1> const& U) -> T {
      return determinant(Eigen::Matrix<T, n + 1, n + 1>(U.template topRows<n + 1>()));
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
    claim.differs("with + dPi ^ d^{n+1}x", model, measured, S(omega + last));
    claim.differs("dp ^ dy in place of dy ^ dp", model, measured, S(swapped - last));
    // As an affine map on jets: pull z back by the linear map that a jet is.
    auto j = draw_jet<S, n, N>(draw);
    j.x = z.x, j.y = z.y;
    Eigen::Matrix<S, all, n + 1> lifted = Eigen::Matrix<S, all, n + 1>::Zero();
    lifted.template topRows<n + 1>().setIdentity();
    lifted.template middleRows<N>(n + 1) = j.v;
    claim.equal("value on a jet", model, canonical_form<n, N>()(at, lifted), pairing(z, j));
    // Two vertical vectors of Y in its slots.
    auto U = V;
    U.template leftCols<2>().template topRows<n + 1>().setZero();
    claim.zero("two vertical vectors", model, canonical_form<n, N>()(at, U), theta);
    auto const rest = []<class T, int E>(Eigen::Matrix<T, E, 1> const&, [[maybe_unused]] Tangents<T, E, n - 1> const& X) -> T {
      if constexpr (n == 1)
        return T(1);
      else
        return determinant(Eigen::Matrix<T, n - 1, n - 1>(X.template topRows<n - 1>()));
    };
    claim.refutes("two vertical vectors in a form with dy ^ dy", model, wedge(dy(0), wedge(dy(N - 1), rest))(at, U), theta);
  });
}
