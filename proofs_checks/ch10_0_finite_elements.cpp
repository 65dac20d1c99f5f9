// Chapter 10: the multisymplectic form formula in elasticity, and finite elements in space and time.
#include "actio/continuum/continuum_equations.hpp"
#include "actio/jets/first_variation.hpp"
#include "fields/stored_energies.hpp"
#include "statement.hpp"

namespace {

using namespace actio;
using namespace actio::checks;

/// One random point in each of the dimensions; in space but once where each point is rounded anew.
template <class S, class Dims, class Visit>
void over_models(Claim<S> const& claim, Dims const& dimensions, Visit const& visit) {
  over_points(claim, dimensions, [&]<class D>(D d, std::string const& model) {
    if (D::n < 3 || claim.first() || exact_arithmetic<S>()) visit(d, model);
  });
}

// ---- Reciprocity: increments of second degree of a state of uniform strain.

/// A medium that is the same everywhere, its metrics and its energy included.
template <class S, int n, int N>
AnyContinuum<S, n, N> draw_homogeneous_solid(Draw& draw) {
  auto medium = flattened<S, n, N>(draw_medium<S, n, N>(draw, Kind::solid));
  auto const forget = [](auto& cubic) {
    for (auto* c : {&cubic.a, &cubic.b, &cubic.d, &cubic.e}) c->template head<n>().setZero();
  };
  forget(medium.rho.added), forget(medium.W.solid.w);
  return medium;
}
/// An increment at rest, of degree 2 at most in the place: a cubic section without its cubes and its time,
/// and \f$\tfrac12k\,(x^1)^2\f$.
template <class S, int n, int N>
struct Increment {
  AnySection<S, n, N> u;
  Matrix<S, N, 1> k;
  template <class V>
  auto operator()(V const& x) const {
    using T = ScalarOf<V>;
    auto moved = u(x);
    for (int a = 0; a < N; ++a) moved[a] += x[1] * x[1] * T(S(k[a] / S(2)));
    return moved;
  }
};
template <class S, int n, int N>
Increment<S, n, N> draw_increment(Draw& draw, bool strained = true) {
  Increment<S, n, N> increment{draw_section<S, n, N>(draw, S(strained ? 1 : 0)), Matrix<S, N, 1>::Zero()};
  for (auto& c : increment.u.added) {
    c.e.setZero();
    c.a[0] = c.b[0] = c.d[0] = S(0);
  }
  return increment;
}
/// The forces \f$-D_i\,\delta\mathcal P^i\f$ on the body, per unit of coordinates, under which an increment
/// is one of equilibria; the same at all places.
template <class Medium, class S, int n, int N>
Matrix<S, N, 1> forces_of(Medium const& medium, SecondJet<S, n, N> const& j, Increment<S, n, N> const& u) {
  return -linearised_euler_lagrange(medium, j, second_jet(u, j.x));
}
/// The increment with the k that needs no forces.
template <class Medium, class S, int n, int N>
Increment<S, n, N> balanced(Medium const& medium, SecondJet<S, n, N> const& j, Increment<S, n, N> u) {
  Matrix<S, N, N> columns;
  Matrix<S, N, 1> const without = forces_of(medium, j, u);
  for (int a = 0; a < N; ++a) {
    auto moved = u;
    moved.k[a] += S(1);
    columns.col(a) = forces_of(medium, j, moved) - without;
  }
  u.k -= solve_linear(columns, without, "balanced");
  return u;
}

/// The integral of a polynomial of degree 3 at most in each coordinate over a box of the body, or over a face
/// of it, where a coordinate is held: Simpson's rule.
template <class S, int n, class F>
S simpson(Matrix<S, n, 1> const& low, Matrix<S, n, 1> const& high, F const& f, int held = -1,
          bool upper = false) {
  S sum(0);
  int count = 1;
  for (int i = 0; i < n; ++i)
    if (i != held) count *= 3;
  for (int node = 0; node < count; ++node) {
    Event<S, n> at = Event<S, n>::Zero();
    S weight(1);
    for (int i = 0, rest = node; i < n; ++i) {
      if (i == held) {
        at[i + 1] = upper ? high[i] : low[i];
        continue;
      }
      int const third = rest % 3;
      rest /= 3;
      at[i + 1] = (low[i] * S(2 - third) + high[i] * S(third)) / S(2);
      weight = weight * (high[i] - low[i]) * ratio<S>(third == 1 ? 4 : 1, 6);
    }
    sum += f(at) * weight;
  }
  return sum;
}
/// The work of the tractions of one stress in one displacement over all faces.
/// @param stress  a callable from places to stresses, a column for each direction of the body
template <class S, int n, class Stress, class Displacement>
S work_on_faces(Matrix<S, n, 1> const& low, Matrix<S, n, 1> const& high, Stress const& stress,
                Displacement const& u) {
  S sum(0);
  for (int i = 0; i < n; ++i)
    for (bool const upper : {false, true}) {
      auto const density = [&](Event<S, n> const& x) { return S(stress(x).col(i).dot(u(x))); };
      S const work = simpson(low, high, density, i, upper);
      sum += upper ? work : S(-work);
    }
  return sum;
}

// ---- Finite elements: a patch of simplices around two nodes within.

/// Simplices with linear shape functions and one point each where the medium is evaluated: a simplex divided
/// about a point within it, and one of the parts divided again.
template <class S, int n>
struct Patch {
  static constexpr int outer = n + 1, nodes = n + 3, size = n * nodes;
  using Element = std::array<int, n + 1>;
  template <class T>
  using Nodal = Matrix<T, n, nodes>;  ///< a vector for each node, the outer ones first
  template <class T>
  using Corners = Matrix<T, n, n + 1>;  ///< those of one element

  AnyContinuum<S, n> medium;
  Nodal<S> X;  ///< places of the nodes in the body
  std::vector<Element> elements;

  Patch(Draw& draw, AnyContinuum<S, n> const& of) : medium(of) {
    X = draw_tangents<S, n, nodes>(draw) * ratio<S>(1, 10);
    Element whole;
    for (int i = 0; i <= n; ++i) {
      whole[i] = i;
      if (i > 0) X(i - 1, i) += S(1);
    }
    elements = {whole};
    divide(n + 1), divide(n + 2);
  }
  /// Puts a node near the middle of the first element.
  void divide(int node) {
    Element const first = elements.front();
    elements.erase(elements.begin());
    for (int i = 0; i <= n; ++i) {
      X.col(node) = (i == 0 ? Matrix<S, n, 1>(X.col(node) / S(10 * n)) : Matrix<S, n, 1>(X.col(node))) +
                    X.col(first[i]) / S(n + 1);
      Element part = first;
      part[i] = node;
      elements.push_back(part);
    }
  }

  template <class T>
  Corners<T> corners(Nodal<T> const& q, Element const& e) const {
    Corners<T> Y;
    for (int i = 0; i <= n; ++i) Y.col(i) = q.col(e[i]);
    return Y;
  }
  /// The slopes of the shape functions, one after the other; and the volume of an element.
  std::pair<Corners<S>, S> shape(Element const& e) const {
    auto const at = corners(X, e);
    Matrix<S, n, n> edges;
    for (int i = 0; i < n; ++i) edges.col(i) = at.col(i + 1) - at.col(0);
    Matrix<S, n, n> const inverse = inverse_matrix(edges);
    Corners<S> slopes;
    slopes.col(0).setZero();
    for (int i = 0; i < n; ++i) {
      slopes.col(i + 1) = inverse.row(i).transpose();
      slopes.col(0) -= slopes.col(i + 1);
    }
    return {slopes, determinant(edges) / S(n == 2 ? 2 : 6)};
  }
  /// The jet, at rest, at the middle of an element.
  template <class T>
  Jet<T, n, n> jet(Element const& e, Corners<S> const& slopes, Corners<T> const& Y) const {
    Jet<T, n, n> j;
    j.x.setZero(), j.y.setZero(), j.v.setZero();
    for (int i = 0; i <= n; ++i)
      for (int a = 0; a < n; ++a) {
        j.x[a + 1] += T(S(X(a, e[i]) / S(n + 1)));
        j.y[a] += Y(a, i) * T(ratio<S>(1, n + 1));
        for (int k = 0; k < n; ++k) j.v(a, k + 1) += Y(a, i) * T(slopes(k, i));
      }
    return j;
  }
  /// The slopes \f$\partial L_e/\partial y_i\f$ of one element's action at rest, by differentiation.
  template <class T>
  Corners<T> element_slopes(Element const& e, Corners<T> const& Y) const {
    auto const [slopes, extent] = shape(e);
    auto const action = [&, &slopes = slopes, &extent = extent]<class R>(Corners<R> const& moved) {
      return R(medium(jet<R>(e, slopes, moved)) * R(extent));
    };
    return derivative(action, Y).gradient();
  }
  /// The same of all elements together, a force for each node.
  /// @param weight  what an element's force on a corner is multiplied with
  template <class T, class Weight>
  Nodal<T> forces(Nodal<T> const& q, Weight const& weight) const {
    Nodal<T> sum = Nodal<T>::Zero();
    for (auto const& e : elements) {
      auto const part = element_slopes<T>(e, corners<T>(q, e));
      for (int i = 0; i <= n; ++i) sum.col(e[i]) += part.col(i) * T(weight(e, i));
    }
    return sum;
  }
  template <class T>
  Nodal<T> forces(Nodal<T> const& q) const { return forces<T>(q, [](Element const&, int) { return S(1); }); }
  /// The action at rest.
  template <class T>
  T action(Nodal<T> const& q) const {
    T sum(0);
    for (auto const& e : elements) {
      auto const [slopes, extent] = shape(e);
      sum += medium(jet<T>(e, slopes, corners<T>(q, e))) * T(extent);
    }
    return sum;
  }
  /// How the forces change with q, as a matrix.
  template <class Weight>
  Matrix<S, size, size> stiffness(Nodal<S> const& q, Weight const& weight) const {
    auto const at = [&]<class T>(Nodal<T> const& moved) { return forces<T>(moved, weight); };
    return derivative(at, q).matrix;
  }
  Matrix<S, size, size> stiffness(Nodal<S> const& q) const {
    return stiffness(q, [](Element const&, int) { return S(1); });
  }
  /// Masses between nodes: each element's shared by its corners, or those of its shape functions; times the
  /// metric of space, which must be the same everywhere.
  Matrix<S, size, size> masses(bool lumped) const {
    Matrix<S, size, size> M = Matrix<S, size, size>::Zero();
    for (auto const& e : elements) {
      auto const [slopes, extent] = shape(e);
      auto const j = jet<S>(e, slopes, corners<S>(X, e));
      Matrix<S, n, n> const g =
          medium.g(j.y) * S(extent * medium.rho(j.particle()) * volume<S>(medium.G(j.particle())));
      for (int i = 0; i <= n; ++i)
        for (int k = 0; k <= n; ++k)
          if (!lumped || i == k)
            M.template block<n, n>(n * e[i], n * e[k]) +=
                g / S(lumped ? n + 1 : (n + 1) * (n + 2) / (i == k ? 2 : 1));
    }
    return M;
  }
  /// A state near that of rest.
  Nodal<S> draw_state(Draw& draw) const { return X + draw_tangents<S, n, nodes>(draw) * ratio<S>(1, 20); }
};

/// The nodal forces as books on finite elements have them: the stress against the slopes of the shape
/// functions, and the force of the metric shared by the corners.
/// @param stress  a callable from a jet to what stands for the Piola-Kirchhoff stress
template <class S, int n, class Stress>
Matrix<S, n, n + 3> assembled_forces(Patch<S, n> const& patch, Matrix<S, n, n + 3> const& q,
                                     Stress const& stress) {
  Matrix<S, n, n + 3> sum = Matrix<S, n, n + 3>::Zero();
  for (auto const& e : patch.elements) {
    auto const [slopes, extent] = patch.shape(e);
    auto const j = patch.template jet<S>(e, slopes, patch.template corners<S>(q, e));
    S const weight = extent * volume<S>(patch.medium.G(j.particle()));
    Matrix<S, n, n> const P = stress(j);
    Matrix<S, n, 1> const shared = metric_force(patch.medium, j) / S(n + 1);
    for (int i = 0; i <= n; ++i) sum.col(e[i]) += (shared - P * slopes.col(i)) * weight;
  }
  return sum;
}

/// The nodal vectors with drawn values outside and those within that leave no force on the nodes within.
template <class S, int n>
Matrix<S, n, n + 3> first_variation_of(Draw& draw, Matrix<S, n*(n + 3), n*(n + 3)> const& K) {
  constexpr int edge = n * (n + 1), inside = 2 * n;
  Matrix<S, n*(n + 3), 1> V = draw.vector<S, Matrix<S, n*(n + 3), 1>>(n * (n + 3));
  Matrix<S, inside, 1> const load = K.template bottomLeftCorner<inside, edge>() * V.template head<edge>();
  Matrix<S, inside, inside> const within = K.template bottomRightCorner<inside, inside>();
  V.template tail<inside>() = -solve_linear(within, load, "first_variation_of");
  return V.reshaped(n, n + 3);
}
/// \f$\sum_i V_i\cdot\delta_Wf_i - W_i\cdot\delta_Vf_i\f$ over the outer nodes, and the size of its terms.
template <class S, int n>
std::pair<S, S> sum_of_forms(Matrix<S, n*(n + 3), n*(n + 3)> const& K, Matrix<S, n, n + 3> const& V,
                             Matrix<S, n, n + 3> const& W) {
  Matrix<S, n*(n + 3), 1> const v = V.reshaped(), w = W.reshaped(), of_v = K * v, of_w = K * w;
  S sum(0), size(0);
  for (int i = 0; i < n * (n + 1); ++i) {
    S const one = v[i] * of_w[i], two = w[i] * of_v[i];
    sum += one - two, size += magnitude(one) + magnitude(two);
  }
  return {sum, size};
}

// ---- Newmark's steps of such a patch.

/// The equation \f$Ma = f(q) + F\f$ in steps of Newmark's family.
template <class S, int n>
struct Newmark {
  static constexpr int size = n * (n + 3);
  using Column = Matrix<S, size, 1>;
  using Square = Matrix<S, size, size>;
  Patch<S, n> const& patch;
  Square M, inverse;
  S h, beta, gamma;

  /// \f$M^{-1}f(q)\f$.
  template <class T>
  Matrix<T, size, 1> acceleration(Matrix<T, n, n + 3> const& q) const {
    Matrix<T, size, 1> const f = patch.template forces<T>(q).reshaped();
    return over(inverse, f);
  }
  template <class T>
  static Matrix<T, size, 1> over(Square const& A, Matrix<T, size, 1> const& f) {
    Matrix<T, size, 1> sum = Matrix<T, size, 1>::Zero();
    for (int i = 0; i < size; ++i)
      for (int k = 0; k < size; ++k) sum[i] += f[k] * T(A(i, k));
    return sum;
  }
  /// The place that moves as a particle does under the force at q: \f$z = q - \beta h^2a\f$.
  template <class T>
  Matrix<T, size, 1> shifted(Matrix<T, n, n + 3> const& q, S const& sign = S(1)) const {
    Matrix<T, size, 1> z = q.reshaped();
    return z - acceleration<T>(q) * T(S(sign * beta * h * h));
  }
  /// \f$\frac1{2h}|z_1-z_0|^2_M - \frac h2\bigl(\tilde U(q_0)+\tilde U(q_1)\bigr)\f$ with
  /// \f$\tilde U = U + \tfrac12\beta h^2|a|^2_M\f$.
  template <class T>
  T action_of_step(Matrix<T, n, n + 3> const& q0, Matrix<T, n, n + 3> const& q1, S const& sign) const {
    Matrix<T, size, 1> const step = shifted<T>(q1, sign) - shifted<T>(q0, sign);
    T sum = step.dot(over<T>(M, step)) / T(S(S(2) * h));
    for (auto const* q : {&q0, &q1}) {
      auto const a = acceleration<T>(*q);
      sum += patch.template action<T>(*q) * T(S(h / S(2)));
      sum -= a.dot(over<T>(M, a)) * T(S(sign * beta * h * h * h / S(4)));
    }
    return sum;
  }
  /// What is missing at the third of three positions: \f$q_2\f$ less Newmark's, the velocity taken from the
  /// first two.
  Column missing(Matrix<S, n, n + 3> const& q0, Matrix<S, n, n + 3> const& q1,
                 Matrix<S, n, n + 3> const& q2) const {
    Column const a0 = acceleration<S>(q0), a1 = acceleration<S>(q1), a2 = acceleration<S>(q2);
    Column const x0 = q0.reshaped(), x1 = q1.reshaped(), x2 = q2.reshaped();
    auto const bend = [&](Column const& from, Column const& to) {
      return Column((from * S(S(1) - S(2) * beta) + to * S(S(2) * beta)) * S(h * h / S(2)));
    };
    Column const v0 = (x1 - x0 - bend(a0, a1)) / h, v1 = v0 + (a0 * S(S(1) - gamma) + a1 * gamma) * h;
    return x2 - x1 - v1 * h - bend(a1, a2);
  }

  /// A first variation along a motion: the change of positions, of \f$h^2\f$ times accelerations and of loads
  /// at each time, and of z.
  struct Variation {
    std::vector<Column> q, z, F;
  };
  /// @param K     how the forces change with q, at each time
  /// @param free  how many nodes come with no change of their loads; the others' are drawn
  Variation variation(Draw& draw, std::vector<Square> const& K, int free) const {
    auto const any = [&] { return draw.vector<S, Column>(size); };
    Variation out;
    Column q = any(), v = any(), a;
    for (int k = 0; k < int(K.size()); ++k) {
      Column F = any();
      F.tail(n * free).setZero();
      if (k > 0) {
        Column const from = q + v * h + a * S(h * h * (ratio<S>(1, 2) - beta));
        Column const right = M * from + F * S(beta * h * h);
        Square const left = M - K[k] * S(beta * h * h);
        q = solve_linear(left, right, "Newmark's step");
      }
      Column const now = inverse * Column(K[k] * q + F);
      if (k > 0) v += (a * S(S(1) - gamma) + now * gamma) * h;
      a = now;
      out.q.push_back(q), out.F.push_back(F), out.z.push_back(q - a * S(beta * h * h));
    }
    return out;
  }
};
/// The action of two steps, as a function of the position between them.
template <class S, int n>
struct TwoSteps {
  Newmark<S, n> const& by;
  Matrix<S, n, n + 3> const &from, &to;
  S sign;
  template <class T>
  T operator()(Matrix<T, n, n + 3> const& q) const {
    Matrix<T, n, n + 3> const first = from.template cast<T>(), last = to.template cast<T>();
    return by.template action_of_step<T>(first, q, sign) + by.template action_of_step<T>(q, last, sign);
  }
};
/// The form formula over a motion: what the loads bring through the outer nodes, and the form
/// \f$\delta z_k\wedge M\,\delta z_{k+1}\f$ at the first pair of times and the last.
template <class S>
struct FormFormula {
  S brought, first, last;
  S residual() const { return brought - (last - first); }
  S scale() const { return magnitude(brought) + magnitude(first) + magnitude(last); }
};
template <class S, int size, class Variation>
FormFormula<S> form_formula(Matrix<S, size, size> const& M, S const& h, Variation const& A,
                            Variation const& B, int outer,
                            std::vector<Matrix<S, size, 1>> Variation::*place) {
  int const last = int(A.q.size()) - 1;
  auto const form = [&](int k) {
    auto const &a = A.*place, &b = B.*place;
    return S(a[k].dot(M * b[k + 1]) - b[k].dot(M * a[k + 1]));
  };
  S brought(0);
  for (int k = 1; k < last; ++k)
    brought +=
        (A.q[k].head(outer).dot(B.F[k].head(outer)) - B.q[k].head(outer).dot(A.F[k].head(outer))) * h * h;
  return {brought, form(0), form(last - 1)};
}

}  // namespace

STATEMENT(claim_10_0_betti_reciprocity, "multisymplectic form formula and reciprocity in elasticity") {
  claim.holds(
      "Of increments at rest of a strained hyperelastic body, without symmetry: the time's "
      "component of the form vanishes, and through the faces flows the work of the one tractions "
      "in the other displacements less the converse. With forces on the body their work is added "
      "on both sides. Increments of second degree of a state of uniform strain in a homogeneous "
      "body, on boxes; shells as well.");
  over_models(
      claim, std::tuple<Dimensions<2, 2>, Dimensions<3, 3>, Dimensions<2, 3>>{},
      [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
        using Place = Matrix<S, n, 1>;
        auto const medium = draw_homogeneous_solid<S, n, N>(draw);
        auto strained = draw_section<S, n, N>(draw);
        for (auto& c : strained.added) c.b.setZero(), c.d.setZero(), c.e.setZero(), c.a[0] = S(0);
        Event<S, n> const origin = Event<S, n>::Zero();
        auto const j = second_jet(strained, origin);
        Place const low = draw.vector<S, Place>(n) * ratio<S>(1, 5), high = low + Place::Ones();
        S const root = volume<S>(medium.G(j.particle()));
        auto const stress_of = [&](auto const& u) {
          return [&](Event<S, n> const& x) {
            Jet<S, n, N> const here = first_jet(strained, x);
            return Matrix<S, N, n>(
                rate_of(first_piola_kirchhoff_stress(medium, varied(here, Jet<S, n, N>(first_jet(u, x))))) *
                root);
          };
        };
        auto const work = [&](auto const& stress, auto const& u) {
          return work_on_faces(low, high, stress, u);
        };
        auto const any = draw_increment<S, n, N>(draw), other = draw_increment<S, n, N>(draw);
        auto const u = balanced(medium, j, any), w = balanced(medium, j, other);

        Event<S, n> at = origin;
        at.template tail<n>() = low;
        Event<S, n> const flow =
            multisymplectic_current(medium, Jet<S, n, N>(first_jet(strained, at)),
                                    Jet<S, n, N>(first_jet(u, at)), Jet<S, n, N>(first_jet(w, at)));
        Place const betti = stress_of(w)(at).transpose() * u(at) - stress_of(u)(at).transpose() * w(at);
        claim.equal("the form through a face", model, Place(flow.template tail<n>()), betti, 10);
        claim.zero("and through an instant", model, flow[0], magnitude(betti));
        claim.differs("the form with both works added", model, Place(flow.template tail<n>()),
                      Place(stress_of(w)(at).transpose() * u(at) + stress_of(u)(at).transpose() * w(at)));

        S const one = work(stress_of(u), w), two = work(stress_of(w), u);
        // The faces' works nearly cancel, and k comes from an elimination.
        S const scale = magnitude(one) + magnitude(two) + S(1);
        claim.zero("Betti's reciprocity", model, S(one - two), scale, 100);
        auto const load = [&](auto const& of, auto const& through) {
          Matrix<S, N, 1> const b = forces_of(medium, j, of);
          return S(simpson(low, high, [&](Event<S, n> const& x) { return S(b.dot(through(x))); }));
        };
        S const loaded = work(stress_of(any), other), converse = work(stress_of(other), any);
        claim.zero("with forces on the body", model,
                   S(loaded + load(any, other) - converse - load(other, any)), scale, 100);
        claim.refutes("without their work", model, S(loaded - converse), scale);
        claim.refutes("their work the other way", model,
                      S(loaded - load(any, other) - converse + load(other, any)), scale);
        // Moduli that no stored energy has: a stress of the first row of the strain alone, twice.
        auto const bent = [&](auto const& of) {
          return [&](Event<S, n> const& x) {
            Matrix<S, N, n> stress = stress_of(of)(x);
            stress.col(0) += stress.col(1) * ratio<S>(1, 2);
            return stress;
          };
        };
        auto const linear = draw_increment<S, n, N>(draw);
        auto straight = [](auto c) {
          for (auto& added : c.u.added) added.b.setZero(), added.d.setZero();
          c.k.setZero();
          return c;
        };
        claim.refutes(
            "moduli of no stored energy", model,
            S(work(bent(straight(linear)), straight(u)) - work(bent(straight(u)), straight(linear))), scale);
        claim.zero("the same increments, of a stored energy", model,
                   S(work(stress_of(straight(linear)), straight(w)) -
                     work(stress_of(straight(w)), straight(linear))),
                   scale, 100);
      });
}

STATEMENT(claim_10_0_static_fem,
          "finite elements for static elasticity and the discrete multisymplectic form") {
  claim.convention(
      "In the sense of Veselov's discretization: the forms of an element's action sum to zero over its "
      "corners, and for two first variations over the outer nodes of a patch. For elements whose "
      "forces come from the stored energy, here linear simplices with one point of evaluation each, an "
      "anisotropic solid in curved metrics and dead loads on the nodes. Test functions that differ "
      "from the shape functions lose it.");
  over_models(claim, PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    Patch<S, n> const patch(draw, draw_medium<S, n>(draw, Kind::solid));
    auto const q = patch.draw_state(draw);
    using Element = typename Patch<S, n>::Element;
    auto const& medium = patch.medium;
    auto const forces = patch.template forces<S>(q);
    auto const piola = [&](Jet<S, n, n> const& j) { return first_piola_kirchhoff_stress(medium, j); };
    // Spatial stress in its place, with the index lowered as for the other.
    auto const cauchy = [&](Jet<S, n, n> const& j) {
      return Matrix<S, n, n>(medium.g(j.y) * cauchy_stress(medium, j));
    };
    // Ten more roundings: two ways to differentiate the energy, summed over the elements about a node.
    claim.equal("discrete Euler-Lagrange equations and finite elements", model, forces,
                assembled_forces(patch, q, piola), 10);
    claim.differs("the stress of space in their place", model, forces, assembled_forces(patch, q, cauchy));

    auto const whole = patch.stiffness(q);
    // The density of mass at the corner in place of that of the element.
    auto const nodal = [&](Element const& e, int i) {
      return S(medium.rho(Matrix<S, n, 1>(patch.X.col(e[i]))));
    };
    auto const other = patch.stiffness(q, nodal);
    Matrix<S, n, n + 3> const any = draw_tangents<S, n, n + 3>(draw),
                              V = first_variation_of<S, n>(draw, whole),
                              W = first_variation_of<S, n>(draw, whole);
    // Ten more roundings here too: second derivatives of the energy.
    for (auto const& e : patch.elements) {
      auto const slopes = [&]<class T>(Matrix<T, n, n + 1> const& Y) {
        return patch.template element_slopes<T>(e, Y);
      };
      auto of_one = derivative(slopes, patch.template corners<S>(q, e)).matrix;
      claim.equal("in each element", model, of_one, of_one.transpose().eval(), 10);
      for (int i = 0; i <= n; ++i) of_one.template middleRows<n>(n * i) *= nodal(e, i);
      claim.differs("in each element, with other test functions", model, of_one, of_one.transpose().eval());
    }
    claim.equal("and so over all nodes", model, whole, whole.transpose().eval(), 10);
    auto const A = first_variation_of<S, n>(draw, other), B = first_variation_of<S, n>(draw, other);
    auto const [kept, of_kept] = sum_of_forms<S, n>(whole, V, W);
    auto const [lost, of_lost] = sum_of_forms<S, n>(whole, V, any);
    auto const [skewed, of_skewed] = sum_of_forms<S, n>(other, A, B);
    // A hundred more roundings: what is within comes from an elimination.
    claim.zero("two first variations, over the outer nodes", model, kept, of_kept, 100);
    claim.refutes("one of them not a first variation", model, lost, of_lost);
    claim.refutes("other test functions", model, skewed, of_skewed);
  });
}

STATEMENT(claim_10_0_newmark, "finite elements with Newmark time stepping") {
  claim.convention(
      "For $\\gamma=\\frac12$ and any $\\beta$, with masses in the nodes or those of the shape "
      "functions, in a space of constant metric. The discrete Lagrangian and the form are those of the "
      "shifted positions $z = q - \\beta h^2a$, the positions themselves for $\\beta = 0$; other "
      "$\\gamma$ lose the form. On a patch of an anisotropic solid the form gains from time to time what "
      "the loads bring through the outer nodes.");
  over_models(claim, PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& name) {
    using Stepping = Newmark<S, n>;
    using Nodal = Matrix<S, n, n + 3>;
    Patch<S, n> const patch(draw, flattened<S, n, n>(draw_medium<S, n>(draw, Kind::solid)));
    bool const lumped = (claim.pass + n) % 2 == 0;
    std::string const model = name + (lumped ? ", masses in the nodes" : ", masses of the shape functions");
    auto const M = patch.masses(lumped);
    S const h = ratio<S>(1, 10), half = ratio<S>(1, 2), beta = ratio<S>(1, 4) + draw.number<S>() / S(10);
    Stepping const steps{patch, M, inverse_matrix(M), h, beta, half},
        damped{patch, M, steps.inverse, h, beta, S(1)},
        explicit_steps{patch, M, steps.inverse, h, S(0), half};

    // Off shell, along one drawn direction: (1 + beta h^2 H M^-1) M times what is missing, over -h.
    Nodal const q0 = patch.draw_state(draw), q1 = patch.draw_state(draw), q2 = patch.draw_state(draw),
                along = draw_tangents<S, n, n + 3>(draw);
    auto const principle = [&](Stepping const& by, S const& sign) {
      return derivative_along(TwoSteps<S, n>{by, q0, q2, sign}, q1, along).rate;
    };
    auto const newmark = [&](Stepping const& by) {
      typename Stepping::Column const moved = rate_of(by.shifted(moved_along(q1, along)));
      return S(moved.dot(M * by.missing(q0, q1, q2)) / -h);
    };
    // A thousand more roundings: accelerations come by the inverse of the masses, twice, and the steps are
    // divided by h.
    claim.equal("the discrete principle and Newmark's step", model, principle(steps, S(1)), newmark(steps),
                1000);
    claim.equal("central differences", model, principle(explicit_steps, S(1)), newmark(explicit_steps), 1000);
    claim.differs("another gamma", model, principle(damped, S(1)), newmark(damped));
    claim.differs("shifted the other way", model, principle(steps, S(-1)), newmark(steps));

    // In space the stiffness of small simplices magnifies roundings beyond measure: there exactly.
    if (numbers_grow() || (n == 3 && !exact_arithmetic<S>())) return;
    std::vector<typename Stepping::Square> K;
    for (int k = 0; k < 4; ++k) K.push_back(patch.stiffness(patch.draw_state(draw)));
    auto const formula = [&](Stepping const& by, int free, auto place) {
      auto const A = by.variation(draw, K, free), B = by.variation(draw, K, free);
      return form_formula(M, h, A, B, Patch<S, n>::outer * n, place);
    };
    using Variation = typename Stepping::Variation;
    for (auto const* by : {&steps, &explicit_steps}) {
      auto const kept = formula(*by, 2, &Variation::z);
      // A thousand more roundings: three eliminations one after the other, and the masses' inverse.
      claim.zero(by == &steps ? "the form formula" : "the form formula, central differences", model,
                 kept.residual(), kept.scale(), 1000);
    }
    auto const refute = [&](std::string const& what, FormFormula<S> const& lost) {
      claim.refutes(what, model, lost.residual(), lost.scale());
    };
    refute("the form of the positions", formula(steps, 2, &Variation::q));
    refute("another gamma, the form formula", formula(damped, 2, &Variation::z));
    refute("loads on the nodes within", formula(steps, 0, &Variation::z));
  });
}
