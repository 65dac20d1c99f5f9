// Section 6.2: the multisymplectic form formula and its case of mechanics, and the maps that bundle
// automorphisms act on. Variations move space-time as well; integrals over boxes are exact.
//
// In a unit of its own, which is as large as a unit may be.

#include "fields/bundle_maps.hpp"
#include "fields/fields.hpp"
#include "fields/off_shell.hpp"
#include "fields/variations.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

/// Few coordinates in all, for what differentiates many times; a plane in a plane, and a body of three
/// dimensions.
using Varied = std::tuple<Dimensions<1, 2>, Dimensions<2, 1>, Dimensions<2, 2>, Dimensions<3, 1>>;

/// The variation along a section that has a given vertical part and moves space-time by any field:
/// \f$(V^\mu, Q^a + \phi^a{}_{,\mu}V^\mu)\f$.
template <class S, int n, int N, class Q, class Phi>
struct WithVerticalPart {
  Q vertical;
  AnyVariation<S, n, N> along;
  Phi phi;
  template <class X>
  auto operator()(X const& point) const {
    using T = ScalarOf<X>;
    Event<T, n> const x = point.template head<n + 1>();
    Variation<T, n, N> rate = along(point);
    rate.template tail<N>() = vertical(x) + first_jet(phi, x).v * rate.template head<n + 1>();
    return rate;
  }
};
/// The vertical part of a field on Y along a section, as a section is written.
template <class V, class Phi>
auto vertical_part_along(V const& field, Phi const& phi) {
  return [field, phi]<class T, int rows>(Matrix<T, rows, 1> const& x) {
    auto const j = first_jet(phi, x);
    return vertical_part(j, field(point_of(j)));
  };
}

}  // namespace

STATEMENT(thm_6_2_2, "multisymplectic form formula") {
  claim.holds(
      "Off shell the divergence of the current is $V\\cdot\\delta_WE - W\\cdot\\delta_VE$ for "
      "vertical variations, so both are to solve the linearised equations. Variations that move "
      "space-time add $E\\cdot V\\,W^\\mu - E\\cdot W\\,V^\\mu$ to the current of their vertical "
      "parts, which is nothing on a solution.");
  over_dimensions(Varied{}, [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
    // The linearised equations are to have a solution for the accelerations.
    auto const L = draw_regular_density<S, n, N>(draw);
    auto const phi = draw_section<S, n, N>(draw);
    auto const at = second_jet(phi, draw_event<S, n>(draw));
    auto const V = not_accelerated(draw_section<S, n, N>(draw)),
               W = not_accelerated(draw_section<S, n, N>(draw));
    auto const divergence_of = [&](auto const& v, auto const& w) {
      return divergence(
          [&]<class T>(Event<T, n> const& x) {
            return multisymplectic_current(L, first_jet(phi, x), first_jet(v, x), first_jet(w, x));
          },
          at.x);
    };
    auto const j = second_jet(V, at.x), k = second_jet(W, at.x);
    S const left = divergence_of(V, W), first = j.y.dot(linearised_euler_lagrange(L, at, k)),
            second = k.y.dot(linearised_euler_lagrange(L, at, j));
    S const scale = magnitude(left) + magnitude(first) + magnitude(second);
    claim.zero("off shell: divergence V . dE[W] - W . dE[V]", model, S(left - first + second), scale);
    // First variations at this point, of the section as it is: a force of the section's own changes nothing
    // in the linearised equations.
    auto const v = first_variation_at(L, at, V), w = first_variation_at(L, at, W);
    // Accelerations from one elimination.
    claim.zero("divergence for two first variations", model, divergence_of(v, w), scale, 10);
    claim.refutes("one of them not a first variation", model, divergence_of(v, W), scale);
    claim.refutes("none of them a first variation", model, left, scale);
    // Variations that move space-time as well: the form contracted with both, off shell.
    auto const X = draw_variation<S, n, N>(draw, 2), Y = draw_variation<S, n, N>(draw, 2);
    auto const contracted = components_of(
        pull_back(jet_extension(phi),
                  contract(prolonged<n, N>(X), contract(prolonged<n, N>(Y), multisymplectic_form<n, N>(L)))),
        at.x);
    Jet<S, n, N> const& here = at;
    auto const x = X(point_of(here)), y = Y(point_of(here));
    auto const E = euler_lagrange(L, at);
    Event<S, n> const upright = multisymplectic_current(L, here, first_jet(vertical_part_along(X, phi), at.x),
                                                        first_jet(vertical_part_along(Y, phi), at.x)),
                      forces = y.template head<n + 1>() * E.dot(vertical_part(here, x)) -
                               x.template head<n + 1>() * E.dot(vertical_part(here, y));
    S const sizes = magnitude(upright) + magnitude(forces);
    // Terms that cancel on the way: an allowance of ten times that of plain evaluation.
    claim.zero("off shell: two variations that move space-time", model,
               Event<S, n>(contracted - upright - forces), sizes, 10);
    claim.refutes("the current of their vertical parts alone, off shell", model,
                  Event<S, n>(contracted - upright), sizes);
  });
}

namespace {

/// A body that differs from particle to particle, with the density \f$\tfrac12A_{ab}v^a{}_0v^b{}_0 -
/// \tfrac12B^{ij}_{ab}v^a{}_iv^b{}_j\f$. B is drawn of first degree in the particle, s of second, and
/// \f$2A_{ab} =
/// \partial_i(B^{ij}_{ab}\,\partial_js)\f$: then \f$c\,(t^2 + s) + dt + e\f$ solves the field equations.
template <class S, int n, int N>
struct Inhomogeneous {
  std::array<Cubic<S, n>, n * n * N * N> B;
  Matrix<S, n, n> bend;
  Matrix<S, n, 1> slope;

  explicit Inhomogeneous(Draw& draw) {
    for (int i = 0; i < n; ++i)
      for (int k = 0; k <= i; ++k)
        for (int a = 0; a < N; ++a)
          for (int b = 0; b <= a; ++b) {
            auto const c = cut(draw_cubic<S, n>(draw), 1);
            B[at(i, k, a, b)] = B[at(k, i, a, b)] = B[at(i, k, b, a)] = B[at(k, i, b, a)] = c;
          }
    Matrix<S, n, n> const m = draw_tangents<S, n, n>(draw);
    bend = m + m.transpose();
    slope = draw.vector<S, Matrix<S, n, 1>>(n);
  }
  static int at(int i, int k, int a, int b) { return ((i * n + k) * N + a) * N + b; }

  template <class T>
  T operator()(Jet<T, n, N> const& j) const {
    Matrix<T, n, 1> const x = j.particle(), ds = bend.template cast<T>() * x + slope.template cast<T>();
    T twice(0);
    for (int a = 0; a < N; ++a)
      for (int b = 0; b < N; ++b) {
        T mass(0), stiffness(0);
        for (int i = 0; i < n; ++i)
          for (int k = 0; k < n; ++k) {
            auto const& c = B[at(i, k, a, b)];
            T const value = c(x);
            mass += ds[k] * T(c.a[i]) + value * T(bend(i, k));
            stiffness += value * j.v(a, 1 + i) * j.v(b, 1 + k);
          }
        twice += mass * j.v(a, 0) * j.v(b, 0) / T(2) - stiffness;
      }
    return twice / T(2);
  }
};
/// Its solutions.
template <class S, int n, int N>
struct Swinging {
  Inhomogeneous<S, n, N> body;
  Matrix<S, N, 1> c, d, e;
  Swinging(Inhomogeneous<S, n, N> const& b, Draw& draw) : body(b) {
    for (auto* v : {&c, &d, &e}) *v = draw.vector<S, Matrix<S, N, 1>>(N);
  }
  template <class X>
  auto operator()(X const& x) const {
    using T = ScalarOf<X>;
    T s = x[0] * x[0];
    for (int i = 0; i < n; ++i) {
      s += x[1 + i] * T(body.slope[i]);
      for (int k = 0; k < n; ++k) s += x[1 + i] * x[1 + k] * T(S(body.bend(i, k) / S(2)));
    }
    Matrix<T, N, 1> y;
    for (int a = 0; a < N; ++a) y[a] = s * T(c[a]) + x[0] * T(d[a]) + T(e[a]);
    return y;
  }
};

/// (6.11) along a solution that is not uniform, in a body that is not either.
template <class S, int n, int N>
void inhomogeneous_body(Claim<S>& claim, Draw& draw, std::string const& model) {
  using Solution = Swinging<S, n, N>;
  Inhomogeneous<S, n, N> const L(draw);
  Solution const phi(L, draw), Q(L, draw), R(L, draw);
  auto const other = draw_section_of_degree<S, n, N>(draw, 2, S(1));
  auto const box = draw_box<S, n>(draw);
  auto const j = second_jet(phi, box.low);
  claim.zero("the section solves the field equations", model, euler_lagrange(L, j), magnitude(momenta(L, j)),
             10);
  auto const along = draw_variation<S, n, N>(draw, 1), aside = draw_variation<S, n, N>(draw, 1);
  WithVerticalPart<S, n, N, Solution, Solution> const V{Q, along, phi};
  auto const current = [&](auto const& vertical) {
    WithVerticalPart<S, n, N, std::remove_cvref_t<decltype(vertical)>, Solution> const W{vertical, aside,
                                                                                         phi};
    return pull_back(
        jet_extension(phi),
        contract(prolonged<n, N>(V), contract(prolonged<n, N>(W), multisymplectic_form<n, N>(L))));
  };
  auto const right = current(R);
  auto const wrong = current(other);
  S const scale = magnitude(components_of(right, box.low)) + magnitude(components_of(right, box.high));
  // On a solution the current is that of the vertical parts: of fourth degree in each coordinate at most.
  claim.zero("along a solution of second degree in a body that varies", model,
             boundary_integral(right, box, 4), scale, 10);
  claim.refutes("one of them not a first variation of it", model, boundary_integral(wrong, box, 4), scale);
}

}  // namespace

STATEMENT(eq_6_11, "boundary integral of two first variations and the multisymplectic form") {
  claim.holds(
      "For variations that move space-time as well, the vertical parts are to solve the linearised "
      "equations. On boxes, along uniform strain in a uniform body of any density, and along other "
      "solutions in a body with a quadratic density that varies.");
  claim.leaves(
      "Bodies of dimension three are not tried: integrals over boxes of four dimensions cost much, and no "
      "coefficient here depends on the dimension.");
  // Integrals of polynomials of degree 5 over a drawn box, with accelerations from two equations.
  over_dimensions(SmallDimensions{}, [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
    // In a medium that is the same everywhere, uniform strain is a solution, and variations of second degree
    // solve the linearised equations.
    auto const L = draw_uniform_density<S, n, N>(draw);
    auto const phi = draw_section_of_degree<S, n, N>(draw, 1);
    auto const box = draw_box<S, n>(draw);
    auto const j = second_jet(phi, Event<S, n>(Event<S, n>::Zero()));
    auto const draw_vertical = [&] {
      return not_accelerated(draw_section_of_degree<S, n, N>(draw, 2, S(1)));
    };
    auto const any = draw_vertical();
    auto const field_of = [&phi](Accelerated<S, n, N> const& Q, AnyVariation<S, n, N> const& along) {
      return WithVerticalPart<S, n, N, Accelerated<S, n, N>, AnySection<S, n, N>>{Q, along, phi};
    };
    auto const horizontal = [&] { return draw_variation<S, n, N>(draw, 2); };
    auto const V = field_of(first_variation_at(L, j, draw_vertical()), horizontal());
    auto const current = [&](Accelerated<S, n, N> const& W, AnyVariation<S, n, N> const& along) {
      return pull_back(jet_extension(phi),
                       contract(prolonged<n, N>(V), contract(prolonged<n, N>(field_of(W, along)),
                                                             multisymplectic_form<n, N>(L))));
    };
    auto const along = horizontal();
    auto const right = current(first_variation_at(L, j, any), along), wrong = current(any, along);
    // What flows in at one corner and out at the opposite one is the scale: most of it cancels even where the
    // sum does not vanish.
    S const scale = magnitude(components_of(right, box.low)) + magnitude(components_of(right, box.high));
    // Sums over up to 25 nodes on each side, and accelerations from one elimination.
    claim.zero("two first variations, horizontal parts included", model, boundary_integral(right, box, 4),
               scale, 10);
    claim.refutes("one of them not a first variation", model, boundary_integral(wrong, box, 4), scale);
    inhomogeneous_body<S, n, N>(claim, draw, model);
  });
}

namespace {

/// A mechanical system whose motions are polynomials: a fall with the mass M and the force f, in coordinates
/// y of second degree in those of the fall that move with time.
template <class S, int N>
struct BentFall {
  Matrix<S, N, N> M;
  Matrix<S, N, 1> f;
  BundleMap<S, 0, N> bend;

  explicit BentFall(Draw& draw)
      : M(draw_metric<S, N>(draw)(Matrix<S, N, 1>(Matrix<S, N, 1>::Zero()))),
        f(draw.vector<S, Matrix<S, N, 1>>(N)),
        bend(draw) {
    bend.scale[0] = S(1), bend.added[0] = no_polynomial<S, 1 + N>();
  }
  template <class T>
  T operator()(Jet<T, 0, N> const& j) const {
    Matrix<T, 1 + N, 1> along;
    along << T(1), j.v;
    auto const [q, rate] =
        derivative_along([&](auto const& y) { return bend.inverse(y); }, point_of(j), along);
    Matrix<T, N, 1> const speed = rate.template tail<N>(), place = q.template tail<N>();
    return inner(Matrix<T, N, N>(M.template cast<T>()), speed, speed) / T(2) +
           place.dot(f.template cast<T>());
  }
};
/// A motion of it, or with the rates of its beginning the variation that they make.
template <class S, int N>
struct BentMotion {
  BentFall<S, N> system;
  Matrix<S, N, 1> place, speed, place_rate, speed_rate, acceleration;
  bool varied = false;
  BentMotion(BentFall<S, N> const& s, Draw& draw) : system(s) {
    for (auto* v : {&place, &speed, &place_rate, &speed_rate}) *v = draw.vector<S, Matrix<S, N, 1>>(N);
    acceleration = solve_linear(system.M, system.f, "BentMotion");
  }
  /// A first variation of it, from the beginning that the draw gives; pushed by a force, none.
  BentMotion variation(Draw& draw, S const& pushed = S(0)) const {
    auto V = *this;
    V.place_rate = draw.vector<S, Matrix<S, N, 1>>(N), V.speed_rate = draw.vector<S, Matrix<S, N, 1>>(N);
    V.push = pushed, V.varied = true;
    return V;
  }
  template <class X>
  auto operator()(X const& x) const {
    using T = ScalarOf<X>;
    T const t = x[0], square = t * t / T(2);
    Matrix<T, 1 + N, 1> at, rate;
    at[0] = t, rate[0] = T(0);
    for (int a = 0; a < N; ++a) {
      at[1 + a] = T(place[a]) + t * T(speed[a]) + square * T(acceleration[a]);
      rate[1 + a] = T(place_rate[a]) + t * T(speed_rate[a]) + square * T(push);
    }
    if (!varied) return Matrix<T, N, 1>(system.bend(at).template tail<N>());
    return Matrix<T, N, 1>(derivative_along(system.bend, at, rate).rate.template tail<N>());
  }
  S push{0};
};

}  // namespace

STATEMENT(claim_6_2_time_slice_symplectic,
          "symplecticity in time as a case of the multisymplectic form formula") {
  claim.holds(
      "For a body of no dimensions (6.11) on an interval says that the map from the state at one end "
      "to that at the other preserves $dy^a\\wedge dp_a$: for a Lagrangian that depends on time and is "
      "not quadratic in its coordinates.");
  over_dimensions(
      std::tuple<Dimensions<0, 2>, Dimensions<0, 3>>{},
      [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
        using Curve = BentMotion<S, N>;
        BentFall<S, N> const L(draw);
        Curve const motion(L, draw), V = motion.variation(draw), W = motion.variation(draw),
                                     pushed = motion.variation(draw, S(3));
        auto const box = draw_box<S, 0>(draw);
        claim.zero("the curve is a motion", model, euler_lagrange(L, second_jet(motion, box.low)),
                   S(magnitude(momenta(L, first_jet(motion, box.low))) + magnitude(L.f)), 10);
        // The pairing of two tangent vectors of the space of states, at either end.
        auto const pairing_at = [&](Event<S, 0> const& t, auto const& w) {
          return S(multisymplectic_current(L, first_jet(motion, t), first_jet(V, t), first_jet(w, t))[0]);
        };
        auto const speeds_at = [&](Event<S, 0> const& t) {
          auto const v = first_jet(V, t), w = first_jet(W, t);
          return S(v.velocity().dot(w.y) - w.velocity().dot(v.y));
        };
        claim.equal("dy ^ dp of two tangent vectors, at both ends", model, pairing_at(box.low, W),
                    pairing_at(box.high, W), 10);
        claim.differs("with a vector that the flow does not carry", model, pairing_at(box.low, pushed),
                      pairing_at(box.high, pushed));
        claim.differs("dy ^ dv in place of dy ^ dp", model, speeds_at(box.low), speeds_at(box.high));
        // As (6.11), with variations that move time as well.
        auto const boundary = [&](auto const& w) {
          auto const field = [&](Curve const& Q) {
            return WithVerticalPart<S, 0, N, Curve, Curve>{Q, draw_variation<S, 0, N>(draw, 2), motion};
          };
          auto const v = field(V), u = field(w);
          auto const form = pull_back(
              jet_extension(motion),
              contract(prolonged<0, N>(v), contract(prolonged<0, N>(u), multisymplectic_form<0, N>(L))));
          return boundary_integral(form, box, 0);
        };
        S const scale = magnitude(pairing_at(box.low, W)) + magnitude(pairing_at(box.high, W));
        claim.zero("(6.11) on an interval", model, boundary(W), scale, 10);
        claim.refutes("(6.11) with a variation that is none of motions", model, boundary(pushed), scale);
      });
}

namespace {

/// A map of U into Y that covers a diffeomorphism of space-time.
template <class S, int n, int N>
struct AnyTilted {
  BundleMap<S, n, N> base;
  AnySection<S, n, N> values;
  explicit AnyTilted(Draw& draw) : base(draw), values(draw_section<S, n, N>(draw)) {}
  template <class T>
  auto operator()(Event<T, n> const& u) const {
    Matrix<T, n + 1 + N, 1> point;
    point << base.on_base(u), values(u);
    return point;
  }
  /// \f$\varphi\circ\varphi_X^{-1}\f$, by its places.
  auto section() const {
    return [this]<class T>(Event<T, n> const& x) { return values(base.on_base_inverse(x)); };
  }
};

}  // namespace

STATEMENT(claim_6_2_induced_section, "action of bundle automorphisms on sections") {
  claim.holds(
      "Composition acts on maps of $U$ into $Y$; on the sections that they make "
      "it is an action from the left.");
  over_dimensions(Varied{}, [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
    using Base = Matrix<S, n + 1, n + 1>;
    BundleMap<S, n, N> const eta(draw), zeta(draw);
    AnyTilted<S, n, N> const phi(draw);
    auto const section = phi.section();
    auto const u = draw_event<S, n>(draw);
    Event<S, n> const x = eta.on_base(phi.base.on_base(u));
    auto const moved = [&](auto const& v) { return eta(phi(v)); };
    // Inverses of polynomials, one after another: an allowance of ten times that of plain evaluation.
    auto const base_of = [](auto const& point) { return Event<S, n>(point.template head<n + 1>()); };
    claim.equal("eta_Y phi eta_X^{-1} is a section", model, base_of(eta.graph_of_moved(section)(x)), x, 10);
    claim.differs("eta_Y phi without eta_X^{-1} is a section", model, base_of(eta(graph(section, x))), x);
    claim.differs("eta_Y phi eta_X is a section", model,
                  base_of(eta(graph(section, Event<S, n>(eta.on_base(x))))), x);
    // The map eta_Y phi covers eta_X phi_X, and makes that section, jets included.
    claim.equal("the map covers eta_X phi_X", model, base_of(moved(u)), x, 10);
    auto const tangent = pushed(moved, u, Base(Base::Identity()));
    Matrix<S, N, n + 1> const v =
        tangent.template bottomRows<N>() * inverse_matrix(Base(tangent.template topRows<n + 1>()));
    claim.equal("its jet is that of the induced section", model, v, first_jet(eta.moved(section), x).v, 10);
    claim.differs("with phi_X left out", model, v, first_jet(eta.moved(phi.values), x).v);
    // Two automorphisms, one after the other.
    auto const both = [&](auto const& first, auto const& second) {
      Event<S, n> const there = first.on_base_inverse(second.on_base_inverse(x));
      return Matrix<S, N, 1>(second(first(graph(section, there))).template tail<N>());
    };
    Matrix<S, N, 1> const twice = zeta.moved(eta.moved(section))(x);
    claim.equal("an action from the left", model, twice, both(eta, zeta), 10);
    claim.differs("an action from the right", model, twice, both(zeta, eta));
  });
}

STATEMENT(claim_6_2_tangent_of_tilted_sections, "tangent vectors of the manifold of maps into Y") {
  claim.corrected(
      "\\mathcal V \\in C^\\infty(X, TY),\\ T\\pi_{XY}\\circ\\mathcal V = \\mathcal V_X",
      "\\mathcal V \\in C^\\infty(U, TY),\\ T\\pi_{XY}\\circ\\mathcal V = \\mathcal V_X\\circ\\varphi_X",
      "$\\varphi$ is a map of $U$, and so is a vector along it; what it covers is a vector "
      "field on $U_X$ at the point $\\varphi_X(u)$. As printed it is right for sections, "
      "where $\\varphi_X$ is the identity.");
  over_dimensions(Varied{}, [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
    constexpr int all = n + 1 + N;
    BundleMap<S, n, N> const eta(draw);
    AnyTilted<S, n, N> const phi(draw);
    auto const section = draw_section<S, n, N>(draw);
    auto const u = draw_event<S, n>(draw);
    // A path of automorphisms from the identity: each is triangular as eta is.
    auto const path = [&]<class T>(T const& epsilon, Matrix<T, all, 1> const& point) {
      return Matrix<T, all, 1>(point + (eta(point) - point) * epsilon);
    };
    auto const along = [&](Matrix<S, all, 1> const& start) {
      return derivative(
          [&]<class T>(T const& e) { return path(e, Matrix<T, all, 1>(start.template cast<T>())); }, S(0));
    };
    auto const field_below = [&](Event<S, n> const& x) { return Event<S, n>(eta.on_base(x) - x); };
    auto const V = along(phi(u));
    Event<S, n> const below = V.rate.template head<n + 1>(), image = phi.base.on_base(u);
    claim.equal("the vector is one at phi(u)", model, V.value, phi(u));
    claim.equal("it covers a field on U_X at phi_X(u)", model, below, field_below(image), 10);
    claim.differs("printed: it covers a field on X at the same point", model, below, field_below(u));
    claim.equal("as printed for a section", model,
                Event<S, n>(along(graph(section, u)).rate.template head<n + 1>()), field_below(u), 10);
  });
}
