// Scalars: rational (long: double)
// Section 6.1: two metrics, the deformation tensors and the Jacobian.
#include "fields.hpp"

#include "statement.hpp"
#include "variations.hpp"

namespace {

using namespace actio;
using namespace actio::checks;

/// A motion, frozen at a time.
template <class Phi, class S>
struct Deformation {
  Phi phi;
  S time;
  template <class T, int n>
  auto operator()(Eigen::Matrix<T, n, 1> const& x) const {
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
  Eigen::Matrix<S, n, 1> x;
  Eigen::Matrix<S, n, n> G;
  Eigen::Matrix<S, N, N> g;
  Eigen::Matrix<S, N, n> F;

  explicit TwoMetrics(Draw& draw)
      : body(draw_metric<S, n>(draw)), space(draw_metric<S, N>(draw)), phi(draw_section<S, n, N>(draw)), j(first_jet(phi, draw_event<S, n>(draw))),
        x(j.particle()), G(body(x)), g(space(j.y)), F(j.gradient()) {}

  auto deformation() const { return Deformation<AnySection<S, n, N>, S>{phi, j.x[0]}; }
};

/// A metric as a form that takes two vectors: it may be pulled back.
template <class Metric>
auto as_form(Metric const& g) {
  return [g]<class S, int D>(Eigen::Matrix<S, D, 1> const& at, Tangents<S, D, 2> const& V) -> S {
    Eigen::Matrix<S, D, 1> const u = V.col(0), w = V.col(1);
    return inner(Eigen::Matrix<S, D, D>(g(at)), u, w);
  };
}
/// All components of such a form at a point.
template <class Form, class S, int n>
Eigen::Matrix<S, n, n> matrix_of(Form const& form, Eigen::Matrix<S, n, 1> const& x) {
  Eigen::Matrix<S, n, n> m;
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
  return [g]<class S, int n>(Eigen::Matrix<S, n, 1> const& at, Tangents<S, n, n> const& V) -> S { return volume<S>(g(at).eval()) * determinant(V); };
}

/// An invertible matrix near the identity.
template <class S, int n>
Eigen::Matrix<S, n, n> draw_matrix(Draw& draw) {
  Eigen::Matrix<S, n, n> m = Eigen::Matrix<S, n, n>::Identity();
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k) m(i, k) += draw.number<S>() * ratio<S>(1, 4);
  return m;
}

}  // namespace

STATEMENT(eq_6_1, "Jacobian as a function on the first jet bundle") {
  claim.convention("$[v]$ is the square block $v^a{}_j$, $n = N$: with the velocity it is $n$ by $n + 1$ and has no determinant. The metric of space is taken at the place, that of the body at the particle.");
  // Frames of degree 13 in a section of degree 6, two determinants of them.
  claim.degree(160);
  over_points<S>(PlaneAndSpace{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    TwoMetrics<S, n, n> const m(draw);
    Tangents<S, n, n> const all = Tangents<S, n, n>::Identity();
    S const J = jacobian(m.G, m.g, m.F), pulled = pull_back(m.deformation(), volume_form(m.space))(m.x, all), here = volume_form(m.body)(m.x, all);
    claim.equal("pulled-back volume form", model, pulled, S(J * here));
    claim.differs("without the root", model, pulled, S(determinant(m.F) * determinant(m.g) / determinant(m.G) * here));
    claim.differs("both metrics at the particle", model, pulled, S(jacobian(m.G, Eigen::Matrix<S, n, n>(m.space(m.x)), m.F) * here));
  });
}

STATEMENT(eq_6_2, "Green and Finger deformation tensors in coordinates") {
  claim.holds("$g$ is taken at the place, $G$ at the particle; $C$ is defined whether or not the deformation is regular, $c$ where $n = N$ and $F$ has an inverse.");
  claim.degree(160);
  over_points<S>(std::tuple<Dimensions<2, 2>, Dimensions<3, 3>, Dimensions<1, 3>>{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = D::N;
    TwoMetrics<S, n, N> const m(draw);
    Eigen::Matrix<S, n, n> sum = Eigen::Matrix<S, n, n>::Zero(), elsewhere = sum;
    auto const there = m.space(Eigen::Matrix<S, N, 1>(Eigen::Matrix<S, N, 1>::Zero()));
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
      Eigen::Matrix<S, n, n> const inverse = inverse_matrix(m.F);
      claim.differs("indices of the inverse exchanged", model, c, pulled_back(m.G, Eigen::Matrix<S, n, n>(inverse.transpose())));
      auto flat = m.F;
      flat.col(n - 1) = flat.col(0);
      claim.zero("C of a flat deformation has no inverse", model, determinant(green_tensor(m.g, flat)), determinant(m.g));
      claim.template refuses<Singular>("c of a flat deformation", model, [&] { inverse_finger_tensor(m.G, flat); });
    }
  });
}

STATEMENT(claim_6_1_green_tensor, "Green tensor as a pulled-back metric") {
  claim.holds();
  claim.degree(80);
  over_points<S>(std::tuple<Dimensions<2, 2>, Dimensions<3, 3>, Dimensions<1, 3>>{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = D::N;
    TwoMetrics<S, n, N> const m(draw);
    auto const pulled = matrix_of(pull_back(m.deformation(), as_form(m.space)), m.x);
    claim.equal("C equals the pull-back of g", model, green_tensor(m.g, m.F), pulled);
    if constexpr (n == N) claim.differs("F g F^T", model, Eigen::Matrix<S, n, n>(m.F * m.g * m.F.transpose()), pulled);
    // A measurement of lengths by the body's own metric is another tensor.
    claim.differs("G in place of C", model, m.G, pulled);
  });
}

STATEMENT(claim_6_1_finger_tensor, "inverse Finger tensor as a pushed-forward metric") {
  claim.holds("The inverse is that of mixed tensors, or of $c_{ab}$ and $b^{ab}$; lowering both indices of $b$ with $g$ does not invert the matrix of $c$.");
  claim.degree(300);
  over_points<S>(PlaneAndSpace{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    // Draw the inverse of a deformation, which takes places to particles: the push-forward by the one is the pull-back by the other.
    TwoMetrics<S, n, n> const m(draw);
    Eigen::Matrix<S, n, 1> const y = m.x, x = m.j.y;
    auto const pushed_forward = matrix_of(pull_back(m.deformation(), as_form(m.space)), y);
    Eigen::Matrix<S, n, n> const F = inverse_matrix(m.F), G = m.space(x), g = m.body(y);
    auto const c = inverse_finger_tensor(G, F);
    // Two inverses: the allowance is ten times that of plain evaluation.
    claim.equal("c equals the push-forward of G", model, c, pushed_forward, 10);
    Eigen::Matrix<S, n, n> const b = F * inverse_matrix(G) * F.transpose(), unit = Eigen::Matrix<S, n, n>::Identity();
    claim.equal("b^{ab}c_{bd} is the identity", model, Eigen::Matrix<S, n, n>(b * c), unit, 10);
    claim.equal("as mixed tensors", model, Eigen::Matrix<S, n, n>(b * g * (inverse_matrix(g) * c)), unit, 10);
    claim.differs("with both indices of b lowered by g", model, Eigen::Matrix<S, n, n>(g * b * g * c), unit);
    claim.template refuses<Singular>("a deformation without an inverse", model, [&] { inverse_finger_tensor(G, Eigen::Matrix<S, n, n>(F * S(0))); });
  });
}

STATEMENT(claim_6_1_sharp_of_pullback, "index raising and pull-back of the spatial metric compared") {
  claim.convention("They differ for a general deformation; they agree exactly where the deformation is an isometry, $C = G$.");
  claim.degree(300);
  over_points<S>(PlaneAndSpace{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    using M = Eigen::Matrix<S, n, n>;
    TwoMetrics<S, n, n> const m(draw);
    M const C = green_tensor(m.g, m.F), Finv = inverse_matrix(m.F), pulled = Finv * inverse_matrix(m.g) * Finv.transpose();
    auto const sharp = [&](M const& G) { return M(inverse_matrix(G) * C * inverse_matrix(G)); };
    // Inverses of three matrices near the identity.
    claim.equal("the pull-back of g^# is the inverse of C", model, M(pulled * C), M(M::Identity()), 10);
    M const mixed = inverse_matrix(m.G) * C;
    claim.equal("their difference is that of (G^{-1}C)^2 and 1", model, M((sharp(m.G) - pulled) * C), M(mixed * mixed - M::Identity()), 10);
    claim.equal("they agree for an isometry", model, sharp(C), pulled, 10);
    claim.differs("they agree for any deformation", model, sharp(m.G), pulled);
  });
}

STATEMENT(claim_6_1_jacobian_scalar, "Jacobian of a section under coordinate changes") {
  claim.convention("Charts of body and space are to keep the orientation: a reflection changes the sign of $\\det F$ and not of the roots.");
  claim.degree(300);
  over_points<S>(PlaneAndSpace{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    using M = Eigen::Matrix<S, n, n>;
    TwoMetrics<S, n, n> const m(draw);
    // Derivatives of the old coordinates by the new ones, on the body and in space.
    M const body = draw_matrix<S, n>(draw), space = draw_matrix<S, n>(draw);
    auto const in_charts = [&](M const& K, M const& A) { return jacobian(M(pulled_back(m.G, K)), M(pulled_back(m.g, A)), M(inverse_matrix(A) * m.F * K)); };
    S const J = jacobian(m.G, m.g, m.F);
    M reflected = space;
    reflected.col(0) = -space.col(0);
    // Two inverses.
    claim.equal("same number in other charts", model, in_charts(body, space), J, 10);
    claim.equal("opposite in a reflected chart", model, in_charts(body, reflected), S(-J), 10);
    claim.differs("same in a reflected chart", model, in_charts(body, reflected), J);
    claim.differs("det F alone", model, determinant(M(inverse_matrix(space) * m.F * body)), determinant(m.F));
    // In orthonormal frames, \f$G = A^TA\f$, it is the determinant of the linear map alone.
    M const frames = m.space.frame(m.j.y) * m.F * inverse_matrix(m.body.frame(m.x));
    claim.equal("determinant in orthonormal frames", model, determinant(frames), J, 10);
  });
}

STATEMENT(claim_6_1_initial_jacobian, "Jacobian of a regular motion at and after the identity configuration") {
  claim.corrected("J(x,0) = 1", "J(x,0) = \\sqrt{\\det g(x)/\\det G(x)}",
                  "It is 1 where the two metrics have the same volume, as for a fluid in its container. That J stays positive for a regular motion is right in either case.");
  claim.degree(160);
  over_points<S>(PlaneAndSpace{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    TwoMetrics<S, n, n> const m(draw);
    auto const motion = [&m]<class T>(Event<T, n> const& x) {
      auto const later = m.phi(x);
      Eigen::Matrix<T, n, 1> y;
      for (int a = 0; a < n; ++a) y[a] = x[a + 1] + x[0] * (later[a] - x[a + 1]);
      return y;
    };
    auto const J = [&](auto const& body, auto const& phi, S const& t) {
      Event<S, n> event;
      event << t, m.x;
      auto const j = first_jet(phi, event);
      return jacobian(Eigen::Matrix<S, n, n>(body(m.x)), Eigen::Matrix<S, n, n>(m.space(j.y)), Eigen::Matrix<S, n, n>(j.gradient()));
    };
    S const start = J(m.body, motion, S(0)), ratio_of_volumes = determinant(m.space.frame(m.x)) / determinant(m.body.frame(m.x));
    claim.equal("square root of the ratio of determinants", model, start, ratio_of_volumes);
    claim.differs("printed: 1", model, start, S(1));
    claim.equal("1 where the metrics are the same", model, J(m.space, motion, S(0)), S(1));
    claim.fact("positive later, for a regular motion", model, J(m.body, motion, ratio<S>(1, 2)) > S(0));
    // A motion that is flat at t = 1/2 and comes out reflected.
    auto const through = []<class T>(Event<T, n> const& x) {
      Eigen::Matrix<T, n, 1> y = x.template tail<n>();
      y[0] *= T(1) - x[0] * T(2);
      return y;
    };
    S const end = J(m.body, through, S(1));
    claim.differs("positive for a motion that passes det F = 0", model, end, magnitude(end));
  });
}
