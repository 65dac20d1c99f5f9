// Section 9.1: invariance of the action, Noether's theorem, and the relabelling currents of the two fluids.
//
// In a unit of its own, which is as large as a unit may be.

#include "actio/jets/first_variation.hpp"
#include "actio/linear_algebra/rank.hpp"
#include "actio/noether/isometries.hpp"
#include "actio/noether/time_translation.hpp"

#include "fields/symmetries.hpp"
#include "fields/variations.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

/// A section of second degree.
template <class S, int n>
AnySection<S, n, n> draw_quadratic_section(Draw& draw) { return draw_section_of_degree<S, n, n>(draw, 2); }
/// The box of the integrals.
template <class S>
Box<S, 2> the_box() { return {{S(0), S(0), ratio<S>(-1, 3)}, {S(1), ratio<S>(1, 2), ratio<S>(1, 3)}}; }

/// A finite isometry of a flat space, by the angle of the triangle 3, 4, 5 in the frame of the metric, with a
/// shift; and a shift of time.
template <class S, int n>
auto isometry_and_time(AnyMetric<S, n> const& flat, Draw& draw) {
  Matrix<S, n, n> turn = Matrix<S, n, n>::Identity();
  turn(0, 0) = turn(1, 1) = ratio<S>(3, 5);
  turn(1, 0) = ratio<S>(4, 5), turn(0, 1) = ratio<S>(-4, 5);
  Matrix<S, n, n> const R = inverse_matrix(flat.constant) * turn * flat.constant;
  auto const shift = draw.vector<S, Matrix<S, n, 1>>(n);
  S const later = draw.number<S>();
  return Automorphism{[later](auto const& x) {
                        auto moved = x.eval();
                        moved[0] += ScalarOf<decltype(moved)>(later);
                        return moved;
                      },
                      [R, shift](auto const& point) {
                        using T = ScalarOf<decltype(point)>;
                        Matrix<T, n, 1> const y = point.template tail<n>();
                        return Matrix<T, n, 1>(R.template cast<T>() * y + shift.template cast<T>());
                      }};
}
/// The field of isometries of a flat space: a rotation in the frame of its metric, with a shift.
template <class S, int n>
auto draw_flat_isometry(AnyMetric<S, n> const& flat, Draw& draw) {
  Matrix<S, n, n> skew = Matrix<S, n, n>::Zero();
  skew(0, 1) = draw.number<S>(), skew(1, 0) = -skew(0, 1);
  Matrix<S, n, n> const turn = inverse_matrix(flat.constant) * skew * flat.constant;
  return motion_of_space<n>(RigidMotion<S, n>{turn, draw.vector<S, Matrix<S, n, 1>>(n)});
}

/// The vertical part of a field on Y along a section, as a variation of it.
template <class Xi, class Phi>
auto vertical_along(Xi const& xi, Phi const& phi) {
  return [xi, phi]<class T, int rows>(Matrix<T, rows, 1> const& x) {
    auto const j = first_jet(phi, x);
    return vertical_part(j, xi(point_of(j)));
  };
}

}  // namespace

STATEMENT(eq_9_6, "invariance of the action under a group") {
  claim.convention("The region of integration moves with the map, and the equation holds for every region.");
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    // In four dimensions the exact rules have many nodes, and rationals grow.
    if (n == 3 && numbers_grow()) return;
    auto fluid = draw_polynomial_fluid<S, n>(draw);
    if (n == 3) fluid.W.w.b = S(0);
    auto const phi = draw_quadratic_section<S, n>(draw);
    Box<S, n> box{Event<S, n>::Constant(ratio<S>(-1, 3)), Event<S, n>::Constant(S(1))};
    // The determinant of the gradient is of degree n in each coordinate, the fluid's energy of degree 4.
    S const value = action(fluid, phi, box, 4);
    auto const moved = [&](auto const& eta) { return tilted_action(fluid, moved_map(eta, phi), box, 4); };
    Stretch<S, n> const even{S(2), ratio<S>(1, 2)};
    claim.equal("a relabelling that is not linear, over the moved region", model, moved(relabelling<n>(even)),
                value, 100);
    claim.equal("isometry and shift of time", model, moved(isometry_and_time(fluid.g, draw)), value, 100);
    claim.differs("a map that does not preserve the volume", model,
                  moved(relabelling<n>(Stretch<S, n>{S(2), S(1)})), value);
    if constexpr (n == 2) {
      auto const back = [even](auto const& x) {
        auto from = x.eval();
        from.template tail<n>() = even.back(Matrix<ScalarOf<decltype(x)>, n, 1>(x.template tail<n>()));
        return from;
      };
      claim.differs("over the same region", model,
                    action(fluid, moved_section(relabelling<n>(even), back, phi), box, 4), value);
    }
  });
}

STATEMENT(claim_9_1_symmetries_of_solutions, "symmetries take solutions to solutions") {
  claim.holds(
      "For any density and any automorphism the field equations of $\\mathcal L$ along the moved "
      "section are those of $\\eta^*\\mathcal L$ along the section, times an invertible matrix; so "
      "solutions go to solutions where $\\eta^*\\mathcal L=\\mathcal L$. Exact motions are moved, and "
      "the generator is a first variation of them. The converse is not claimed: Galileo's boost takes "
      "solutions to solutions as well.");
  over_dimensions(SmallDimensions{}, [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
    auto const L = draw_density<S, n, N>(draw);
    auto const any = draw_automorphism<S, n, N>(draw);
    auto const eta = as_automorphism(any);
    auto const back = [any](auto const& x) { return any.back(x); };
    auto const phi = draw_section<S, n, N>(draw);
    Event<S, n> const x = draw_event<S, n>(draw);
    auto const d = tangent<n, N>(eta, x, phi(x).eval());
    auto const E = euler_lagrange(L, second_jet(moved_section(eta, back, phi), Event<S, n>(any.base(x))));
    Matrix<S, N, 1> const brought_back = d.fibre.transpose() * E * determinant(d.base);
    claim.equal("field equations along the moved section, any density, any automorphism", model, brought_back,
                euler_lagrange(PulledBackDensity{L, eta}, second_jet(phi, x)), 100);
    claim.differs("those of the density that was not pulled back", model, brought_back,
                  euler_lagrange(L, second_jet(phi, x)));
  });
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    constexpr int N = n + 1;
    auto fluid = draw_homogeneous_fluid<S, n>(draw);
    fluid.G = draw_stretchable_metric<S, n>(draw);
    fluid.g = flattened(fluid.g);
    Event<S, n> const x = draw_event<S, n>(draw);
    draw_positive(S(x[1] + S(1)));  // the root of det G
    Stretch<S, n> const stretch{ratio<S>(9, 4), ratio<S>(16, 81)};
    auto const back = [stretch](auto const& at) {
      auto from = at.eval();
      from.template tail<n>() = stretch.back(Matrix<ScalarOf<decltype(at)>, n, 1>(at.template tail<n>()));
      return from;
    };
    auto const eta = relabelling<n>(stretch);
    auto const there = Event<S, n>(eta.base(x));
    auto const off = draw_section<S, n, N>(draw);
    auto const lift = density_relabelling<N>(stretch);
    auto const d = tangent<n, N>(lift, x, off(x).eval());
    auto const E = euler_lagrange(ideal(fluid), second_jet(off, x));
    claim.equal(
        "incompressible fluid, any section: field equations before and after", model,
        Matrix<S, N, 1>(d.fibre.transpose() *
                        euler_lagrange(ideal(fluid), second_jet(moved_section(lift, back, off), there)) *
                        determinant(d.base)),
        E, 100);
    // An exact motion.
    auto const phi = draw_free_motion<S, n>(draw, 1);
    S const scale = size_of(momenta(fluid, first_jet(phi, x)));
    auto const left = [&](auto const& section, Event<S, n> const& at) {
      return euler_lagrange(fluid, second_jet(section, at));
    };
    claim.zero("an exact motion", model, left(phi, x), scale, 100);
    claim.zero("an exact motion, relabelled", model, left(moved_section(eta, back, phi), there), scale, 100);
    auto const rigid = isometry_and_time(fluid.g, draw);
    auto const sooner = [at = Event<S, n>(rigid.base(Event<S, n>(Event<S, n>::Zero())))](auto const& y) {
      auto from = y.eval();
      from[0] -= ScalarOf<decltype(from)>(at[0]);
      return from;
    };
    claim.zero("an exact motion under an isometry and a shift of time", model,
               left(moved_section(rigid, sooner, phi), Event<S, n>(rigid.base(x))), scale, 100);
    auto const still = [](auto const& at) { return at.eval(); };
    auto const b = draw.vector<S, Matrix<S, n, 1>>(n);
    claim.zero("an exact motion under a boost", model,
               left(moved_section(galilean_boost<n>(b), still, phi), x), scale, 100);
    auto const squeezing = draw_map_at<S, n>(Matrix<S, n, 1>(x.template tail<n>()), draw);
    auto unsqueezing = squeezing;
    unsqueezing.from = squeezing.to, unsqueezing.to = squeezing.from;
    unsqueezing.slope = inverse_matrix(squeezing.slope);
    auto const squeezed = relabelling<n>(squeezing);
    claim.refutes(
        "an exact motion under a map that does not preserve the volume", model,
        left(moved_section(squeezed, relabelling<n>(unsqueezing).base, phi), Event<S, n>(squeezed.base(x))),
        scale);
    // The infinitesimal generator on the space of solutions.
    auto const j = second_jet(phi, x);
    auto const linearised = [&](auto const& xi) {
      return linearised_euler_lagrange(fluid, j,
                                       second_jet(vertical_along(relabelling_field<n>(xi), phi), x));
    };
    claim.zero("the generator is a first variation of the exact motion", model,
               linearised(draw_relabelling<S, n>(fluid.G, draw)), scale, 1000);
    claim.refutes("the generator of a map that does not preserve the volume", model,
                  linearised(draw_compression<S, n>(draw)), scale);
  });
}

STATEMENT(claim_9_1_invariance_integrals, "boundary and volume integrals from invariance of the action") {
  claim.holds(
      "With $\\Omega=-d\\Theta$; for an equivariant density both integrals are equal along every section, "
      "and zero along solutions: an exact motion of a fluid, with relabellings, time and isometries.");
  {
    auto const fluid = draw_polynomial_fluid<S, 2>(draw);
    auto const phi = draw_quadratic_section<S, 2>(draw);
    std::string const model = "homogeneous fluid of the plane, a box of space-time";
    auto potential = draw_relabelling<S, 2>(fluid.G, draw);
    auto const field = relabelling_field<2>(potential);
    auto const box = the_box<S>();
    auto const flux = [&](auto const& xi, auto const& section, int degree) {
      auto const current =
          flux_form([&](auto const& x) { return noether_current(fluid, xi, first_jet(section, x)); });
      return boundary_integral(current, box, degree);
    };
    auto const density = [&](Event<S, 2> const& x) {
      return coefficient_of(
          pull_back(jet_extension(phi), contract(prolonged<2, 2>(field), multisymplectic_form<2, 2>(fluid))),
          x);
    };
    // The density of degree 4 and the field of degree 2 in each coordinate; rationals would grow.
    if (!numbers_grow()) {
      S const boundary = flux(field, phi, 6), inside = integral(density, box.low, box.high, 6);
      claim.equal("boundary and inside, any section", model, boundary, inside, 100);
      claim.differs("with the other sign of Omega", model, boundary, S(-inside));
    }
    // Of degree 4 in the places, which are of degree 2, and of degree 2 in the field.
    auto const motion = draw_free_motion<S, 2>(draw, 0);
    auto const boundary_of = [&](char const* what, auto const& xi) {
      claim.zero(what, model, flux(xi, motion, 8),
                 size_of(noether_current(fluid, xi, first_jet(motion, box.high))), 100);
    };
    boundary_of("relabelling: the boundary of an exact motion", field);
    boundary_of("time: the boundary of an exact motion", TimeTranslation{});
    boundary_of("isometry: the boundary of an exact motion", draw_flat_isometry(fluid.g, draw));
    auto const squeezing = relabelling_field<2>(
        [](auto const& x) { return std::remove_cvref_t<decltype(x)>(x[0] + x[1], x[0] * x[1]); });
    claim.refutes("a field with divergence: the boundary of an exact motion", model,
                  flux(squeezing, motion, 8),
                  size_of(noether_current(fluid, squeezing, first_jet(motion, box.high))));
  }
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    auto const fluid = draw_polynomial_fluid<S, n>(draw);
    auto const field = relabelling_field<n>(draw_relabelling<S, n>(fluid.G, draw));
    Event<S, n> const x = draw_event<S, n>(draw);
    auto const inside = [&](auto const& phi) {
      return coefficient_of(
          pull_back(jet_extension(phi), contract(prolonged<n, n>(field), multisymplectic_form<n, n>(fluid))),
          x);
    };
    auto const motion = draw_free_motion<S, n>(draw, 0);
    S const scale = size_of(noether_current(fluid, field, first_jet(motion, x)));
    claim.zero("inside an exact motion, at each point", model, inside(motion), scale, 100);
    claim.refutes("inside a section that solves nothing", model, inside(draw_quadratic_section<S, n>(draw)),
                  scale);
  });
}

namespace {

/// Fields on Y with affine components: horizontal ones affine in (t, x), vertical ones in (t, x, y).
template <class S>
struct AffineFields {
  static constexpr int n = 2, N = 2, horizontal = 3 * 4, vertical = 2 * 6;
  using Field = AnyField<S, n, N>;
  /// The i-th of them: those along space-time first.
  static Field at(int i) {
    Field xi;
    for (auto& c : xi.base) c = constant_cubic<S, 3>(S(0));
    for (auto& c : xi.fibre) c = constant_cubic<S, 5>(S(0));
    auto const put = [](auto& c, int k) { (k == 0 ? c.constant : c.a[k - 1]) = S(1); };
    if (i < horizontal)
      put(xi.base[i / 4], i % 4);
    else
      put(xi.fibre[(i - horizontal) / 6], (i - horizontal) % 6);
    return xi;
  }
  /// Their rates of equivariance at some jets: a row for each jet.
  template <class L>
  static Matrix<S, Dynamic, Dynamic> rates(L const& density, Draw& draw) {
    int const all = horizontal + vertical, jets = all + 6;
    Matrix<S, Dynamic, Dynamic> rate(jets, all);
    for (int k = 0; k < jets; ++k) {
      auto const j = draw_jet<S, n, N>(draw);
      for (int i = 0; i < all; ++i) rate(k, i) = equivariance_rate(density, at(i), j);
    }
    return rate;
  }
};

}  // namespace

STATEMENT(claim_9_1_vertical_variations, "vertical variations and spatial symmetries") {
  claim.holds(
      "Of all affine fields on Y that are symmetries of a fluid of the plane, flat in body and space, three "
      "are vertical, the isometries of space; arbitrary ones are nine, with time and the five relabellings. "
      "A vertical field with the same vertical part along a section as a relabelling is no symmetry: its "
      "rate is $-D_\\mu(L\\,\\xi^\\mu)$.");
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    auto const fluid = draw_homogeneous_fluid<S, n>(draw);
    auto const field = relabelling_field<n>(draw_relabelling<S, n>(fluid.G, draw));
    auto const phi = draw_section<S, n, n>(draw);
    Event<S, n> const x = draw_event<S, n>(draw);
    auto const j = second_jet(phi, x);
    // The vertical field on Y that is the vertical part along phi, whatever y.
    auto const vertical =
        [along = vertical_along(field, phi)]<class T, int rows>(Matrix<T, rows, 1> const& point) {
          Matrix<T, rows, 1> rate = Matrix<T, rows, 1>::Zero();
          rate.template tail<n>() = along(Event<T, n>(point.template head<n + 1>()));
          return rate;
        };
    S const rate = equivariance_rate(fluid, vertical, first(j));
    S carried(0);
    for (int mu = 1; mu <= n; ++mu)
      carried += total_derivative(
          mu, [&](auto const& z) { return fluid(z) * field(point_of(z))[mu]; }, j);
    claim.equal("the vertical part of a relabelling: the rate is a divergence", model, rate, S(-carried),
                100);
    claim.refutes("vertical variations alone make a relabelling a symmetry", model, rate, fluid(first(j)));
    claim.zero("relabelling with its part along the body is a symmetry", model,
               equivariance_rate(fluid, field, first(j)), fluid(first(j)), 10);
  });
  // Equations for all coefficients at once.
  if (claim.first() && !numbers_grow()) {
    std::string const model = "fluid of the plane, flat, affine fields";
    auto fluid = draw_homogeneous_fluid<S, 2>(draw);
    fluid.G = flattened(fluid.G), fluid.g = flattened(fluid.g);
    using All = AffineFields<S>;
    auto const rates = All::rates(fluid, draw);
    claim.fact("of twelve vertical fields three are symmetries", model,
               All::vertical - matrix_rank(Matrix<S, Dynamic, Dynamic>(rates.rightCols(All::vertical))) == 3);
    claim.fact("of all twenty-four fields nine are", model,
               All::horizontal + All::vertical - matrix_rank(rates) == 9);
  }
}

// ----
// Noether's theorem, on and off the solutions.

STATEMENT(thm_9_1_1, "covariant Noether theorem") {
  claim.holds(
      "Off shell, for any density and any field: "
      "$d(j^1\\phi)^*J=\\bigl(r-E_a(\\xi^a-v^a{}_\\mu\\xi^\\mu)\\bigr)\\,d^{n+1}x$ with the rate $r$ of "
      "equivariance.");
  over_dimensions(std::tuple<Dimensions<1, 3>, Dimensions<2, 1>>{},
                  [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
                    auto const L = draw_density<S, n, N>(draw);
                    auto const xi = draw_field<S, n, N>(draw);
                    auto const j = draw_second_jet<S, n, N>(draw);
                    S const divergence = current_divergence(L, xi, j);
                    claim.equal("any density, any field, any section", model, divergence,
                                S(equivariance_rate(L, xi, first(j)) + noether_identity(L, xi, j)), 10);
                    claim.differs("without the rate of equivariance", model, divergence,
                                  noether_identity(L, xi, j));
                  });
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    auto const fluid = draw_homogeneous_fluid<S, n>(draw);
    auto const field = relabelling_field<n>(draw_relabelling<S, n>(fluid.G, draw));
    auto const off = draw_second_jet<S, n, n>(draw);
    auto const on = of_a_solution(fluid, off);
    S const scale = size_of(noether_current(fluid, field, first(off)));
    // The acceleration comes out of an elimination.
    claim.zero("relabelling current along solutions", model, current_divergence(fluid, field, on), scale,
               100);
    claim.zero("current of time translation along solutions", model,
               current_divergence(fluid, TimeTranslation{}, on), scale, 100);
    claim.refutes("along a section that solves nothing", model, current_divergence(fluid, field, off), scale);
    auto const varying = with_varying_mass(fluid, draw);
    claim.refutes("mass that varies", model, current_divergence(varying, field, of_a_solution(varying, off)),
                  scale);
    // The incompressible fluid along an exact motion; its pressure depends on time alone.
    auto water = fluid;
    water.G = draw_stretchable_metric<S, n>(draw), water.g = flattened(fluid.g);
    Event<S, n> const x = draw_event<S, n>(draw);
    draw_positive(S(x[1] + S(1)));  // the root of det G
    auto const motion = draw_shearing_motion<S, n>(water.g, draw, 1);
    auto P = constant_cubic<S, n + 1>(S(2));
    P.a[0] = draw.number<S>(), P.e[0] = draw.number<S>();
    auto const relabelled = density_relabelling_field<n + 1>(draw_relabelling<S, n>(water.G, draw));
    auto const j = second_jet(with_pressure(motion, P, water.G), x);
    S const size = size_of(noether_current(ideal(water), relabelled, first(j)));
    claim.zero("incompressible: the exact motion solves", model, euler_lagrange(ideal(water), j), size, 100);
    claim.zero("incompressible: relabelling current along it", model,
               current_divergence(ideal(water), relabelled, j), size, 100);
    P.a[1] = S(1);
    claim.refutes(
        "incompressible: with a pressure that no motion balances", model,
        current_divergence(ideal(water), relabelled, second_jet(with_pressure(motion, P, water.G), x)), size);
  });
}

STATEMENT(eq_9_5, "exterior derivative of the Noether current on solutions") {
  claim.holds(
      "For relabelling it is $\\xi^kF^a{}_kE_a\\,d^{n+1}x$ off shell, for time translation "
      "$\\dot\\phi^aE_a$, for an isometry $k$ of space $-k^aE_a$.");
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    auto const fluid = draw_homogeneous_fluid<S, n>(draw);
    auto const xi = draw_relabelling<S, n>(fluid.G, draw);
    auto const field = relabelling_field<n>(xi);
    auto const j = draw_second_jet<S, n, n>(draw);
    Matrix<S, n, 1> const along_field = j.gradient() * xi(j.particle());
    S const expected = along_field.dot(euler_lagrange(fluid, j)),
            scale = size_of(noether_current(fluid, field, first(j)));
    claim.equal("off shell", model, current_divergence(fluid, field, j), expected, 10);
    claim.zero("on solutions", model, current_divergence(fluid, field, of_a_solution(fluid, j)), scale, 100);
    claim.differs("the other sign", model, current_divergence(fluid, field, j), S(-expected));
    auto const squeezing = relabelling_field<n>(draw_compression<S, n>(draw));
    claim.refutes("a field with divergence, on solutions", model,
                  current_divergence(fluid, squeezing, of_a_solution(fluid, j)), scale);

    auto const power = j.velocity().dot(euler_lagrange(fluid, j));
    claim.equal("time translation, off shell", model, current_divergence(fluid, TimeTranslation{}, j), power,
                10);
    auto const shift = motion_of_space<n>(FirstShift<n>{});
    auto symmetric = fluid;
    symmetric.g = draw_shiftable_metric<S, n>(draw);
    claim.equal("isometry of space, off shell", model, current_divergence(symmetric, shift, j),
                S(-euler_lagrange(symmetric, j)[0]), 10);
    claim.differs("the same shift where the metric depends on the coordinate", model,
                  current_divergence(fluid, shift, j), S(-euler_lagrange(fluid, j)[0]));
  });
}

// ----
// The relabelling currents of the two fluids, their differentials and what these say.

namespace {

/// A homogeneous fluid, a field that preserves the volume of its body, and the second jet of a section with
/// multiplier that solves nothing.
template <class S, int n>
struct FlowingFluid {
  AnyFluid<S, n> fluid;
  PotentialField<S, n> xi;
  SecondJet<S, n, n + 1> extended;
  SecondJet<S, n, n> j;
  Matrix<S, n, 1> field;  ///< value of xi at the particle
  S rho, root;            ///< density, volume of the body's metric

  explicit FlowingFluid(Draw& draw)
      : fluid(draw_homogeneous_fluid<S, n>(draw)),
        xi(draw_relabelling<S, n>(fluid.G, draw)),
        extended(draw_second_jet<S, n, n + 1>(draw)),
        j(deformation(extended)),
        field(xi(j.particle())),
        rho(fluid.rho(j.particle())),
        root(volume<S>(fluid.G(j.particle()))) {}

  Event<S, n> current() const { return noether_current(fluid, relabelling_field<n>(xi), first(j)); }
  Event<S, n> incompressible_current() const {
    return noether_current(ideal(fluid), density_relabelling_field<n + 1>(xi), first(extended));
  }
  S divergence() const { return current_divergence(fluid, relabelling_field<n>(xi), j); }
  S incompressible_divergence() const {
    return current_divergence(ideal(fluid), density_relabelling_field<n + 1>(xi), extended);
  }

  /// The inertia \f$g_{ab}(D_g\dot\phi/Dt)^b\,\phi^a{}_{,k}\f$.
  Matrix<S, n, 1> inertia() const {
    return j.gradient().transpose() * lowered(fluid.g(j.y), material_acceleration(fluid.g, j));
  }
  /// The derivatives of the pressure of the barotropic fluid in the coordinates of the body.
  Matrix<S, n, 1> pressure_slope() const {
    Matrix<S, n, 1> slope;
    for (int k = 0; k < n; ++k) slope[k] = material_pressure(fluid, along(j, k + 1)).part[0];
    return slope;
  }
  S J() const { return jacobian(fluid.G(j.particle()), fluid.g(j.y), j.gradient()); }
  /// \f$-\sqrt{\det G}\,\xi^kf_k\f$.
  S against(Matrix<S, n, 1> const& force) const { return -root * field.dot(force); }
};

}  // namespace

STATEMENT(eq_9_8, "relabelling current of a barotropic fluid") {
  claim.holds();
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    FlowingFluid<S, n> const flow(draw);
    auto const printed = barotropic_relabelling_current(flow.fluid, flow.field, first(flow.j));
    claim.equal("(9.8) is the current of (9.7), by its components", model, printed, flow.current(), 10);
    auto turned = printed, light = printed;
    turned[0] = -turned[0], light[0] = light[0] / flow.rho;
    claim.differs("mass left out of the time component", model, light, flow.current());
    claim.differs("the other sign of the time component", model, turned, flow.current());
  });
}

STATEMENT(claim_9_1_barotropic_current_space, "spatial components of the barotropic relabelling current") {
  claim.holds();
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    FlowingFluid<S, n> const flow(draw);
    S const kinetic = flow.rho * inner(flow.fluid.g(flow.j.y), flow.j.velocity(), flow.j.velocity()) / S(2);
    S const energy = flow.rho * flow.fluid.W.w(flow.J()),
            push = material_pressure(flow.fluid, first(flow.j)) * flow.J();
    Matrix<S, n, 1> const space = flow.current().template tail<n>();
    claim.equal("kinetic less stored energy less PJ", model, space,
                (flow.field * S((kinetic - energy - push) * flow.root)).eval(), 10);
    claim.differs("PJ left out", model, space, (flow.field * S((kinetic - energy) * flow.root)).eval());
    claim.differs("PJ added", model, space, (flow.field * S((kinetic - energy + push) * flow.root)).eval());
  });
}

STATEMENT(claim_9_1_barotropic_current_time, "time component of the barotropic relabelling current") {
  claim.holds();
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    FlowingFluid<S, n> const flow(draw);
    Matrix<S, n, 1> const pushed_field = flow.j.gradient() * flow.field;
    S const momentum = inner(flow.fluid.g(flow.j.y), flow.j.velocity(), pushed_field) * flow.root;
    claim.equal("minus the momentum along the field", model, flow.current()[0], S(-flow.rho * momentum), 10);
    claim.differs("without the density", model, flow.current()[0], S(-momentum));
    claim.differs("without the volume of the body", model, flow.current()[0],
                  S(-flow.rho * momentum / flow.root));
  });
}

STATEMENT(claim_9_1_barotropic_current_differential,
          "exterior derivative of the barotropic relabelling current") {
  claim.corrected(
      "g_{ab}\\left(\\frac{D_g\\dot\\phi}{Dt}\\right)^b=-\\frac{\\partial P}{\\partial "
      "x^k}\\,J\\left(\\left(\\frac{\\partial\\phi}{\\partial x}\\right)^{-1}\\right)_a^k",
      "\\rho\\,g_{ab}\\left(\\frac{D_g\\dot\\phi}{Dt}\\right)^b=-\\frac{\\partial P}{\\partial "
      "x^k}\\,J\\left(\\left(\\frac{\\partial\\phi}{\\partial x}\\right)^{-1}\\right)_a^k",
      "The density is missing: the printed form holds for $\\rho=1$. The differential is $-\\sqrt{\\det "
      "G}\\,\\xi^k\\bigl(\\rho\\,g_{ab}(D_g\\dot\\phi/Dt)^b\\phi^a{}_{,k}+J\\,\\partial_kP\\bigr)d^{n+1}x$; "
      "closed at a point for all divergence-free fields it gives back the field equations "
      "there, since $F$ is invertible.");
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    FlowingFluid<S, n> const flow(draw);
    Matrix<S, n, 1> const push = flow.pressure_slope() * flow.J(), inertia = flow.inertia();
    // Second derivatives of W and of two metrics.
    claim.equal("differential of (9.8), off shell", model, flow.divergence(),
                flow.against(inertia * flow.rho + push), 100);
    claim.differs("printed: the density left out", model, flow.divergence(), flow.against(inertia + push));
    // Several fields recover the Euler-Lagrange derivative.
    Matrix<S, n, n> fields;
    Matrix<S, n, 1> differentials;
    for (int i = 0; i < n; ++i) {
      auto const xi = draw_relabelling<S, n>(flow.fluid.G, draw);
      fields.row(i) = xi(flow.j.particle()).transpose();
      differentials[i] = current_divergence(flow.fluid, relabelling_field<n>(xi), flow.j);
    }
    Matrix<S, n, 1> const recovered =
        solve_linear((fields * flow.j.gradient().transpose()).eval(), differentials);
    claim.equal("n fields give the field equations back", model, recovered,
                euler_lagrange(flow.fluid, flow.j), 1000);
    auto const varying = with_varying_mass(flow.fluid, draw);
    claim.differs(
        "mass that varies", model, current_divergence(varying, relabelling_field<n>(flow.xi), flow.j),
        S(flow.field.dot((flow.j.gradient().transpose() * euler_lagrange(varying, flow.j)).eval())));
  });
}

STATEMENT(eq_9_9, "relabelling current of an incompressible fluid") {
  claim.convention(
      "The constant stored energy is put to zero; another one would add a closed form. It holds off shell "
      "too: $\\lambda(J-1)-\\lambda J=-\\lambda$.");
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    FlowingFluid<S, n> const flow(draw);
    S const P = flow.extended.y[n] / flow.root;
    auto const body = flow.fluid.G(flow.j.particle());
    auto const space = flow.fluid.g(flow.j.y);
    auto const printed = [&](S const& pressure) {
      return incompressible_relabelling_current(body, space, flow.rho, pressure, flow.field, first(flow.j));
    };
    claim.equal("(9.9) is the current of (9.7), by its components", model, printed(P),
                flow.incompressible_current(), 10);
    claim.differs("PJ in place of P", model, printed(S(P * flow.J())), flow.incompressible_current());
    // What a constant stored energy brings by itself.
    S const c = draw.number<S>() + S(2);
    auto const stored = [&]<class T>(Jet<T, n, n + 1> const& z) -> T {
      return volume<T>(flow.fluid.G(z.particle())) * T(S(-c * flow.rho));
    };
    auto const divergence_for = [&](auto const& xi) {
      return S(current_divergence(stored, density_relabelling_field<n + 1>(xi), flow.extended));
    };
    S const size =
        size_of(noether_current(stored, density_relabelling_field<n + 1>(flow.xi), first(flow.extended)));
    claim.zero("a constant stored energy adds a closed form", model, divergence_for(flow.xi), size, 10);
    claim.refutes("for a field with divergence", model, divergence_for(draw_compression<S, n>(draw)), size);
  });
}

STATEMENT(claim_9_1_incompressible_current_differential,
          "exterior derivative of the incompressible relabelling current") {
  claim.corrected(
      "g_{ab}\\left(\\frac{D_g\\dot\\phi}{Dt}\\right)^b=-\\frac{\\partial P}{\\partial "
      "x^k}\\left(\\left(\\frac{\\partial\\phi}{\\partial x}\\right)^{-1}\\right)_a^k",
      "\\rho\\,g_{ab}\\left(\\frac{D_g\\dot\\phi}{Dt}\\right)^b=-\\frac{\\partial P}{\\partial "
      "x^k}\\left(\\left(\\frac{\\partial\\phi}{\\partial x}\\right)^{-1}\\right)_a^k",
      "The density is missing: the printed form holds for $\\rho=1$. That there is no "
      "$J$ is right, constraint or not.");
  claim.same_slip_as("claim_9_1_barotropic_current_differential");
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    FlowingFluid<S, n> const flow(draw);
    auto const push = pressure_gradient(flow.fluid.G, flow.extended);
    auto const inertia = flow.inertia();
    claim.equal("differential of (9.9), off shell", model, flow.incompressible_divergence(),
                flow.against(inertia * flow.rho + push), 100);
    claim.differs("printed: the density left out", model, flow.incompressible_divergence(),
                  flow.against(inertia + push));
    claim.differs("a factor J with the pressure", model, flow.incompressible_divergence(),
                  flow.against(inertia * flow.rho + push * flow.J()));
    // Closed for n fields at a point gives the equation back there: all its components are recovered.
    Matrix<S, n, n> fields;
    Matrix<S, n, 1> differentials;
    for (int i = 0; i < n; ++i) {
      auto const xi = draw_relabelling<S, n>(flow.fluid.G, draw);
      fields.row(i) = xi(flow.j.particle()).transpose() * -flow.root;
      differentials[i] =
          current_divergence(ideal(flow.fluid), density_relabelling_field<n + 1>(xi), flow.extended);
    }
    claim.equal("n fields give the equation of motion back", model, solve_linear(fields, differentials),
                (inertia * flow.rho + push).eval(), 1000);
  });
}

STATEMENT(claim_9_1_constraint_from_current, "constraint and the vanishing of the current differential") {
  claim.holds(
      "A motion whose volumes change has closed currents for all fields once its "
      "acceleration fits the pressure.");
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    FlowingFluid<S, n> flow(draw);
    // Let the acceleration be what makes every current closed; the volumes do what they do.
    Matrix<S, n, 1> const excess = flow.inertia() * flow.rho + pressure_gradient(flow.fluid.G, flow.extended);
    Matrix<S, n, n> const inertia =
        flow.j.gradient().transpose() * as_matrix<S>(flow.fluid.g(flow.j.y)) * flow.rho;
    S const before = flow.incompressible_divergence();
    flow.extended.w[0].template topRows<n>().col(0) -= solve_linear(inertia, excess);
    claim.zero("the current is closed", model, flow.incompressible_divergence(), before, 1000);
    claim.refutes("closed, therefore J = 1", model, S(flow.J() - S(1)), S(1));
  });
}

STATEMENT(claim_9_1_currents_differ, "the difference of the barotropic and the incompressible current") {
  claim.holds(
      "With the momentum part in common they differ by $(P_\\lambda-\\rho W-P_WJ)\\sqrt{\\det "
      "G}\\,\\xi^k\\,d^nx_k$, the current of the difference of the two Lagrangians.");
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    auto const fluid = draw_homogeneous_fluid<S, n>(draw);
    auto const xi = draw_relabelling<S, n>(fluid.G, draw);
    auto const j = draw_pressed_jet<S, n>(draw);
    auto const below = deformation(j);
    Matrix<S, n, 1> const field = xi(j.particle());
    auto const G = fluid.G(j.particle());
    auto const g = fluid.g(j.y.template head<n>().eval());
    S const root = volume<S>(G), rho = fluid.rho(j.particle()), P = j.y[n] / root,
            J = jacobian(G, g, below.gradient());
    S const push = P - rho * fluid.W.w(J) - material_pressure(fluid, below) * J;
    Event<S, n> expected = Event<S, n>::Zero();
    expected.template tail<n>() = field * S(push * root);
    Event<S, n> const barotropic = barotropic_relabelling_current(fluid, field, below),
                      incompressible_one = incompressible_relabelling_current(G, g, rho, P, field, below);
    S const scale = size_of(barotropic);
    claim.zero("the difference of (9.8) and (9.9)", model,
               Event<S, n>(barotropic - incompressible_one - expected), scale, 100);
    // The current is linear in the density; the field moves the multiplier as a density.
    auto const both = [&]<class T>(Jet<T, n, n + 1> const& z) -> T {
      return fluid(deformation(z)) - ideal(fluid)(z);
    };
    claim.zero("the current of the difference of the Lagrangians", model,
               Event<S, n>(noether_current(both, density_relabelling_field<n + 1>(xi), j) - expected), scale,
               100);
    claim.refutes("the two currents are the same", model, Event<S, n>(barotropic - incompressible_one),
                  scale);
  });
}
