// Section 7.2: incompressibility as a constraint of the multiplier theorem, with the space that its
// derivative reaches.
#include <map>

#include "fields/constrained_models.hpp"
#include "fields/incompressible_models.hpp"
#include "statement.hpp"

namespace {

using namespace actio;
using namespace actio::checks;

/// The exponents of a monomial.
template <int n>
struct Exponents {
  std::array<int, n> e{};
  int& operator[](int i) { return e[i]; }
  int operator[](int i) const { return e[i]; }
  auto operator<=>(Exponents const&) const = default;
};
/// A polynomial in n variables.
template <class S, int n>
using Polynomial = std::map<Exponents<n>, S>;

/// All exponents of degree at most d.
template <int n>
std::vector<Exponents<n>> exponents_up_to(int d) {
  std::vector<Exponents<n>> all;
  Exponents<n> at{};
  auto const descend = [&](auto const& self, int k, int left) -> void {
    if (k == n) return all.push_back(at);
    for (at[k] = 0; at[k] <= left; ++at[k]) self(self, k + 1, left - at[k]);
    at[k] = 0;
  };
  descend(descend, 0, d);
  return all;
}
template <class S, int n>
Polynomial<S, n> product(Polynomial<S, n> const& p, Polynomial<S, n> const& q) {
  Polynomial<S, n> all;
  for (auto const& [a, x] : p)
    for (auto const& [b, y] : q) {
      Exponents<n> sum = a;
      for (int i = 0; i < n; ++i) sum[i] += b[i];
      all[sum] += x * y;
    }
  return all;
}
template <class S, int n>
Polynomial<S, n> partial(Polynomial<S, n> const& p, int i) {
  Polynomial<S, n> all;
  for (auto const& [a, x] : p)
    if (a[i] > 0) {
      Exponents<n> less = a;
      --less[i];
      all[less] += x * S(a[i]);
    }
  return all;
}
/// The mean over the unit ball: that of \f$x^{2a}\f$ is \f$\prod(2a_i-1)!!\,/\,((n+2)(n+4)\cdots(n+2|a|))\f$.
template <class S, int n>
S mean_over_ball(Polynomial<S, n> const& p) {
  S mean(0);
  for (auto const& [a, x] : p) {
    S part = x;
    int degree = 0;
    for (int const e : a.e) {
      if (e % 2) part = S(0);
      for (int odd = 1; odd < e; odd += 2) degree += 2, part *= ratio<S>(odd, n + degree);
    }
    mean += part;
  }
  return mean;
}
/// A monomial at a point.
template <int n, class V>
auto monomial_at(Exponents<n> const& e, V const& x) {
  ScalarOf<V> product(1);
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < e[i]; ++k) product *= x[i];
  return product;
}
/// \f$1 - |x|^2\f$, which vanishes on the sphere.
template <class S, int n>
Polynomial<S, n> inside_of_ball() {
  Polynomial<S, n> b{{Exponents<n>{}, S(1)}};
  for (int i = 0; i < n; ++i) {
    Exponents<n> square{};
    square[i] = 2;
    b[square] = S(-1);
  }
  return b;
}

/// The divergence as a matrix on polynomials: from \f$(1-|x|^2)\,p\f$, p with components of degree d - 1, to
/// polynomials of degree d.
template <class S, int n>
struct BallPolynomials {
  std::vector<Exponents<n>> below, all;  // of degree d - 1, and d
  Matrix<S> divergence, gradient;        // from p, and from polynomials of degree d to p
  Matrix<S, 1, Dynamic> mean;
  Matrix<S> weight;  // mean of (1 - |x|^2) p.q

  explicit BallPolynomials(int d) : below(exponents_up_to<n>(d - 1)), all(exponents_up_to<n>(d)) {
    auto const b = inside_of_ball<S, n>();
    auto const m = static_cast<int>(below.size()), M = static_cast<int>(all.size());
    divergence.setZero(M, n * m), gradient.setZero(n * m, M), mean.setZero(1, M),
        weight.setZero(n * m, n * m);
    for (int r = 0; r < M; ++r) {
      Polynomial<S, n> const p{{all[r], S(1)}};
      mean(0, r) = mean_over_ball(p);
      for (int i = 0; i < n; ++i)
        for (auto const& [e, x] : partial(p, i)) gradient(place(below, e) + m * i, r) = x;
    }
    for (int k = 0; k < m; ++k)
      for (int i = 0; i < n; ++i) {
        auto const bp = product(b, Polynomial<S, n>{{below[k], S(1)}});
        for (auto const& [e, x] : partial(bp, i)) divergence(place(all, e), k + m * i) += x;
        for (int l = 0; l < m; ++l)
          weight(k + m * i, l + m * i) = mean_over_ball(product(bp, Polynomial<S, n>{{below[l], S(1)}}));
      }
  }
  static int place(std::vector<Exponents<n>> const& list, Exponents<n> const& e) {
    for (std::size_t k = 0; k < list.size(); ++k)
      if (list[k] == e) return static_cast<int>(k);
    throw Error("a polynomial of higher degree than was counted on");
  }
};

/// A metric of the body for which a motion with unit determinant keeps the volume of g at one instant:
/// \f$(U A_g\circ\phi)^T(U A_g\circ\phi)\f$ with a triangular U. Its volume varies as that of g along the
/// motion.
template <class S, int n>
struct KeptVolume {
  AnyMetric<S, n> g, turn;
  Shears<S, n> phi;
  S t;
  template <class V>
  auto frame(V const& body) const {
    using T = ScalarOf<V>;
    Matrix<T, n + 1, 1> at;
    at << T(t), body;
    return Matrix<T, n, n>(turn.frame(body) * g.frame(phi(at)));
  }
  template <class V>
  auto operator()(V const& body) const {
    auto const A = frame(body);
    return (A.transpose() * A).eval();
  }
  /// The root of its determinant, without a root.
  template <class V>
  auto root(V const& body) const { return ScalarOf<V>(determinant(frame(body))); }
};
/// The body of a point of space-time.
template <class V>
auto body_of(V const& x) {
  constexpr int n = V::RowsAtCompileTime - 1;
  return Matrix<ScalarOf<V>, n, 1>(x.template tail<n>());
}

/// The displacement \f$F\,(b\,m\,e_i)/\sqrt{\det G}\f$ of a motion, with a monomial m; b vanishes on the
/// sphere, or is 1.
template <class S, int n>
struct BallDisplacement {
  KeptVolume<S, n> G;
  Exponents<n> m;
  int i;
  bool fixed = true;
  template <class V>
  auto operator()(V const& x) const {
    using T = ScalarOf<V>;
    auto const body = body_of(x);
    T const b = fixed ? T(T(1) - body.dot(body)) : T(1);
    Matrix<T, n, 1> const column = first_jet(G.phi, x).v.col(i + 1);
    return Matrix<T, n, 1>(column * T(b * monomial_at<n>(m, body) / G.root(body)));
  }
};

/// A force that is the gradient of a pressure gives it back, by its work on gradients; a constant is lost.
template <class S, int n>
void recover_pressure(Claim<S>& claim, Draw& draw, BallPolynomials<S, n> const& ball, Matrix<S> const& work,
                      std::string const& name) {
  auto const m = static_cast<int>(ball.below.size()), M = static_cast<int>(ball.all.size());
  Matrix<S> const pressure = draw.template vector<S>(M), force = ball.gradient * pressure,
                  slopes = ball.gradient.rightCols(M - 1);
  Matrix<S> const gram = slopes.transpose() * ball.weight * slopes;
  // Mean products of monomials: the condition of such a matrix of degree 3 is some thousands.
  double const condition = 1e4;
  claim.equal("pressure from the work of its force", name,
              solve_linear(gram, Matrix<S>(slopes.transpose() * ball.weight * force), "pressure"),
              Matrix<S>(pressure.bottomRows(M - 1)), condition);
  // A force that turns about an axis: (-y, x) in the first two components.
  Matrix<S> turning = force;
  Exponents<n> first{}, second{};
  first[0] = 1, second[1] = 1;
  turning(ball.place(ball.below, second), 0) -= S(1);
  turning(ball.place(ball.below, first) + m, 0) += S(1);
  claim.refutes("work of a force that turns, on displacements that keep the volume", name,
                Matrix<S>(work * turning), size_of(turning));
}

/// At a motion with J = 1: what displacements with a fixed boundary do to the volume, and what pressures do.
template <class S, int n, int d>
void volume_changes(Claim<S>& claim, Draw& draw) {
  std::string const name =
      "ball in n = " + std::to_string(n) + ", metrics that vary, J = 1, degree " + std::to_string(d);
  using V = Matrix<S, n, 1>;
  auto const x = draw_event<S, n>(draw);
  V const body = body_of(x);
  auto const g = draw_metric<S, n>(draw);
  auto const chart = draw_chart<S, n>(draw);
  KeptVolume<S, n> const G{g, draw_triangular_metric<S, n>(draw),
                           of_coordinates(draw_shears<S, n>(draw, chart, chart)), x[0]};
  VolumeConstraint<KeptVolume<S, n>, AnyMetric<S, n>> const Phi{G, g};
  BallPolynomials<S, n> const ball(d);
  auto const m = static_cast<int>(ball.below.size()), M = static_cast<int>(ball.all.size());
  Matrix<S, 1, Dynamic> values(1, M);
  for (int r = 0; r < M; ++r) values(0, r) = monomial_at<n>(ball.all[r], body);
  // Inverses of frames near 1, and derivatives of products of some ten factors.
  double const condition = 30;

  // 1. The volume that a displacement makes. In a field a root has a sign at each point, and J with it.
  S const J = induced_constraint(Phi, G.phi)(x)[0] + S(1), root = G.root(body);
  claim.equal("the motion keeps the volume", name, S(J * J), S(1), condition);
  auto const made = [&](auto const& w) { return S(root * rate_of_constraint(Phi, G.phi, w, x) / J); };
  Matrix<S, 1, Dynamic> by_basis(1, n * m);
  for (int c = 0; c < n * m; ++c) by_basis(0, c) = made(BallDisplacement<S, n>{G, ball.below[c % m], c / m});
  claim.equal("volume made by every displacement of a basis: a divergence", name, by_basis,
              Matrix<S, 1, Dynamic>(values * ball.divergence), condition);
  claim.differs("without the density of the body", name, Matrix<S, 1, Dynamic>(by_basis / root),
                Matrix<S, 1, Dynamic>(values * ball.divergence));

  // 2. As polynomials: all of zero mean, and no others.
  auto const elimination = echelon(ball.divergence);
  claim.zero("their mean over the body", name, Matrix<S, 1, Dynamic>(ball.mean * ball.divergence), S(1), 10);
  claim.fact("they are all polynomials of the degree with zero mean", name, elimination.rank == M - 1);
  Exponents<n> linear{};
  linear[0] = 1;
  claim.equal("with a boundary that moves a constant is reached", name,
              made(BallDisplacement<S, n>{G, linear, 0, false}), S(1), condition);

  // 3. Pressures push with their gradients, and any force that does no work on displacements that keep the
  //    volume is one of these.
  auto const j = second_jet(G.phi, x);
  Matrix<S> pushed(n, M), slopes = Matrix<S>::Zero(n, M);
  Matrix<S, n, n> const back = j.gradient().transpose();
  for (int r = 0; r < M; ++r) {
    auto const multiplier = [&]<class W>(W const& at) {
      return Matrix<ScalarOf<W>, 1, 1>(G.root(body_of(at)) * monomial_at<n>(ball.all[r], body_of(at)));
    };
    pushed.col(r) = back * reaction(Phi, j, first_jet(multiplier, x)) / S(root * J);
    for (int k = 0; k < n * m; ++k)
      slopes(k / m, r) += ball.gradient(k, r) * monomial_at<n>(ball.below[k % m], body);
  }
  claim.equal("reaction of every pressure of a basis: minus its gradient", name, pushed, Matrix<S>(-slopes),
              condition);
  Matrix<S> const kept = elimination.kernel(), work = kept.transpose() * ball.weight;
  claim.zero("work of the pressures on displacements that keep the volume", name,
             Matrix<S>(work * ball.gradient), S(1), 10);
  claim.fact("forces that do no work on these: as many as pressures but for constants", name,
             n * m - echelon(work).rank == M - 1 && echelon(ball.gradient).rank == M - 1);
  recover_pressure(claim, draw, ball, work, name);
}

/// The multiplier is free up to c(t) sqrt(det G), and up to nothing else: at any motion.
template <class S, int n>
void free_pressures(Claim<S>& claim, Draw& draw, std::string const& name) {
  auto const G = draw_metric<S, n>(draw), g = draw_metric<S, n>(draw);
  VolumeConstraint<AnyMetric<S, n>, AnyMetric<S, n>> const Phi{G, g};
  auto const x = draw_event<S, n>(draw);
  auto const j = second_jet(draw_section<S, n, n>(draw), x);
  auto const against = [&](auto const& pressure) {
    auto const field = [&]<class V>(V const& at) {
      return Matrix<ScalarOf<V>, 1, 1>(volume<ScalarOf<V>>(G(body_of(at))) * pressure(at));
    };
    return reaction(Phi, j, first_jet(field, x));
  };
  // Inverses of metrics near 1, and derivatives of their roots.
  claim.zero("reaction of a pressure that depends on time alone", name + ", any motion",
             against([](auto const& at) { return at[0] * at[0] + at[0] + 1; }), S(1), 30);
  claim.refutes("reaction of a pressure that depends on the point of the body", name + ", any motion",
                against([](auto const& at) { return at[1] * at[1] + at[0] + 1; }), S(1));
}

}  // namespace

STATEMENT(claim_7_2_incompressibility_fits, "incompressibility as an instance of the multiplier theorem") {
  claim.convention(
      "With a fixed boundary the total volume is fixed: the derivative of $J - 1$ reaches functions with "
      "zero mean against $\\sqrt{\\det G}$ and no others, at each time. With these as the fibre the "
      "theorem applies, and the multiplier is free up to $c(t)\\sqrt{\\det G}$. Counted at motions with $J "
      "= 1$ of the unit ball in any metrics: displacements that vanish on the sphere, polynomials of "
      "degree $d + 1$ over $\\sqrt{\\det G}$ in the coordinates of the body, reach all polynomials of "
      "degree $d$ with zero mean ($d = 3$ in the plane, 2 in space), and what does no work on those of "
      "them that keep the volume is the gradient of one such polynomial.");
  claim.leaves(
      "Other domains than the ball, functions that are no polynomials of these degrees, and spaces of them "
      "that are complete, where the theorem on multipliers asks that the derivative is onto.");
  volume_changes<S, 2, 3>(claim, draw);
  volume_changes<S, 3, 2>(claim, draw);
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& name) {
    free_pressures<S, n>(claim, draw, name);
  });
}
