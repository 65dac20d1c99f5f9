// Section 6.1: the jet bundle, the dual jet bundle and their forms.

#include "fields.hpp"
#include "statement.hpp"
#include "variations.hpp"

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
  claim.corrected("y^a,\\ i = 1,\\dots,N", "y^a,\\ a = 1,\\dots,N",
                  "The index that is named is not the one that is used. Changes of charts act on the "
                  "fibres of the jet bundle affinely, not linearly, wherever the chart of space depends "
                  "on space-time.");
  claim.maybe_scan();
  // Jets of degree 6 in polynomials of second degree.
  over_points<S>(SmallDimensions{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = D::N;
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
    claim.fact("dimension n + 1 + N + N(n + 1)", model, coordinates(j).size() == n + 1 + N + N * (n + 1));
    if (n != N)
      claim.differs("as many places as the index i has values", model, S(coordinates(j).size()),
                    S(n + 1 + n + n * (n + 1)));
  });
}

STATEMENT(claim_6_1_contracted_volume, "n-forms obtained from the volume form on space-time") {
  claim.convention(
      "$d^nx_\\mu$ is the contraction of $d^{n+1}x$ with the coordinate field along $x^\\mu$: the hook "
      "between the two is not printed.");
  claim.maybe_scan();
  // Determinants of up to four drawn columns.
  over_points<S>(std::tuple<Dimensions<1, 1>, Dimensions<2, 2>, Dimensions<3, 3>>{},
                 [&]<class D>(D, std::string const&) {
    constexpr int n = D::n;
    std::string const model = "n = " + std::to_string(n);
    auto const x = draw_event<S, n>(draw);
    auto const V = draw_tangents<S, n + 1, n + 1>(draw);
    auto const sides = draw_tangents<S, n + 1, n>(draw);
    for (int mu = 0; mu <= n; ++mu) {
      auto const below = contracted_volume<S, n>(mu);
      for (int nu = 0; nu <= n; ++nu)
        claim.zero("dx^nu ^ d^nx_mu", model,
                   S(wedge(differential_of_coordinate(nu), below)(x, V) - (mu == nu ? determinant(V) : S(0))),
                   determinant(V));
      // The determinant of the other rows, in their order, with the sign of the row that is left out.
      Matrix<S, n, n> rows;
      for (int r = 0, to = 0; r <= n; ++r)
        if (r != mu) rows.row(to++) = sides.row(r);
      S const product = determinant(rows);
      claim.equal("(-1)^mu times the product of the other differentials", model, below(x, sides),
                  mu % 2 == 0 ? product : S(-product));
      if (mu % 2 == 1) claim.differs("without the sign", model, below(x, sides), product);
      // Read as a derivative along x^mu of the volume form, it is nothing: the coefficient is constant.
      claim.differs("as a derivative of the volume form", model, below(x, sides), S(0));
    }
  });
}

STATEMENT(claim_6_1_canonical_forms, "canonical forms on the dual jet bundle in coordinates") {
  claim.holds();
  // Products of at most five drawn columns and a coordinate.
  over_points<S>(std::tuple<Dimensions<2, 2>, Dimensions<1, 2>>{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = D::N, all = DualJet<S, n, N>::dimension;
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
    auto const rest = []<class T, int E>(Matrix<T, E, 1> const&,
                                         [[maybe_unused]] Tangents<T, E, n - 1> const& X) -> T {
      if constexpr (n == 1)
        return T(1);
      else
        return determinant(Matrix<T, n - 1, n - 1>(X.template topRows<n - 1>()));
    };
    claim.refutes("two vertical vectors in a form with dy ^ dy", model,
                  wedge(dy(0), wedge(dy(N - 1), rest))(at, U), theta);
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
  over_points<S>(PlaneAndSpace{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
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
  over_points<S>(std::tuple<Dimensions<2, 2>, Dimensions<3, 3>, Dimensions<1, 3>>{},
                 [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = D::N;
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
    claim.differs("C with the metric of another place", model, green_tensor(m.g, m.F), elsewhere);
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
      claim.zero("C of a flat deformation has no inverse", model, determinant(green_tensor(m.g, flat)),
                 determinant(m.g));
      claim.template refuses<Singular>("c of a flat deformation", model,
                                       [&] { inverse_finger_tensor(m.G, flat); });
    }
  });
}

STATEMENT(claim_6_1_green_tensor, "Green tensor as a pulled-back metric") {
  claim.holds();
  over_points<S>(std::tuple<Dimensions<2, 2>, Dimensions<3, 3>, Dimensions<1, 3>>{},
                 [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = D::N;
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
      "The inverse is that of mixed tensors, or of $c_{ab}$ and $b^{ab}$; lowering both indices of $b$ with "
      "$g$ does not invert the matrix of $c$.");
  over_points<S>(PlaneAndSpace{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
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
      "They differ for a general deformation; they agree exactly where the deformation is an isometry, $C = "
      "G$.");
  over_points<S>(PlaneAndSpace{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
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
    claim.equal("they agree for an isometry", model, sharp(C), pulled, 10);
    claim.differs("they agree for any deformation", model, sharp(m.G), pulled);
  });
}

STATEMENT(claim_6_1_jacobian_scalar, "Jacobian of a section under coordinate changes") {
  claim.convention(
      "Charts of body and space are to keep the orientation: a reflection changes the sign of $\\det F$ and "
      "not of the roots.");
  over_points<S>(PlaneAndSpace{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
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

STATEMENT(claim_6_1_initial_jacobian,
          "Jacobian of a regular motion at and after the identity configuration") {
  claim.corrected("J(x,0) = 1", "J(x,0) = \\sqrt{\\det g(x)/\\det G(x)}",
                  "It is 1 where the two metrics have the same volume, as for a fluid in its container. "
                  "That $J$ stays positive for a regular motion is right in either case.");
  over_points<S>(PlaneAndSpace{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
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
    if (ordered_arithmetic<S>())
      claim.fact("positive later, for a regular motion", model, J(m.body, motion, ratio<S>(1, 2)) > S(0));
    // A motion that is flat at t = 1/2 and comes out reflected.
    auto const through = []<class T>(Event<T, n> const& x) {
      Matrix<T, n, 1> y = x.template tail<n>();
      y[0] *= T(1) - x[0] * T(2);
      return y;
    };
    S const end = J(m.body, through, S(1));
    if (ordered_arithmetic<S>())
      claim.differs("positive for a motion that passes det F = 0", model, end, magnitude(end));
  });
}
