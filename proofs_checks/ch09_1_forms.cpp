// Section 9.1: the covariant momentum map as a form on the jet bundle, and what prolongations do to the
// Cartan form.
//
// In a unit of its own, which is as large as a unit may be.

#include "actio/noether/isometries.hpp"
#include "actio/noether/time_translation.hpp"

#include "fields/symmetries.hpp"
#include "fields/variations.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

using Small = std::tuple<Dimensions<1, 2>, Dimensions<2, 1>>;

/// A medium of the most general kind in a space with a coordinate that its metric does not depend on: to
/// shift it is a symmetry, and so is time.
template <class S, int n>
auto draw_symmetric_medium(Draw& draw) {
  auto const G = draw_metric<S, n>(draw), g = draw_shiftable_metric<S, n>(draw);
  auto const rho = draw_mass<S, n>(draw);
  return Continuum{G, g, rho, draw_energy<S, n, n>(draw)};
}
/// The shift of that coordinate together with time, at any rates.
template <int N, class S>
struct ShiftAndTime {
  S shift, time;
  template <class V>
  auto operator()(V const& point) const {
    using T = ScalarOf<V>;
    auto rate = motion_of_space<N>(FirstShift<N>{})(point);
    for (int i = 0; i < rate.size(); ++i) rate[i] *= T(shift);
    rate[0] += T(time);
    return rate;
  }
};

/// A density without symmetry of its own, at a time that stands still, and seen through an automorphism: it
/// is equivariant under any field that the automorphism takes to that of time.
template <class S, int n, int N>
struct StraightenedSymmetry {
  AnyDensity<S, n, N> still;
  AnyAutomorphism<S, n, N> eta;
  template <class T>
  T operator()(Jet<T, n, N> const& j) const {
    auto const at_rest = [this]<class U>(Jet<U, n, N> z) -> U {
      z.x[0] = U(0);
      return still(z);
    };
    return PulledBackDensity{at_rest, as_automorphism(eta)}(j);
  }
  /// \f$(T\eta)^{-1}\,\partial_0\f$ at a point of Y.
  auto field() const {
    return [eta = eta]<class T, int rows>(Matrix<T, rows, 1> const& point) {
      auto const d = tangent<n, N>(as_automorphism(eta), Event<T, n>(point.template head<n + 1>()),
                                   Matrix<T, N, 1>(point.template tail<N>()));
      Matrix<T, rows, 1> rate;
      Event<T, n> const along = inverse_matrix(d.base).col(0);
      rate.template head<n + 1>() = along;
      rate.template tail<N>() = -solve_linear(d.fibre, Matrix<T, N, 1>(d.along * along));
      return rate;
    };
  }
};

/// \f$(j^1\xi\lrcorner\,\Omega_L, dJ_L(\xi))\f$ on n + 1 vectors at a point of the jet bundle.
template <int n, int N, class L, class Xi, class S, int D>
std::pair<S, S> both_sides(L const& density, Xi const& xi, Matrix<S, D, 1> const& at,
                           Tangents<S, D, n + 1> const& V) {
  S const left = contract(prolonged<n, N>(xi), multisymplectic_form<n, N>(density))(at, V);
  return {left, S(exterior_derivative(covariant_momentum_map<n, N>(density, xi))(at, V))};
}

/// The Lie derivative of a form along a field: the rate of its pull-back by the flow.
template <class X, class Form, class S, int D, int k>
S lie_derivative_of_form(X const& x, Form const& omega, Matrix<S, D, 1> const& at,
                         Tangents<S, D, k> const& V) {
  using T = Dual<S>;
  auto const flow = [&x](auto const& c) {
    T epsilon(S(0));
    epsilon.part[0] = S(1);
    auto moved = c.eval();
    auto const rate = x(moved);
    for (int i = 0; i < D; ++i) moved[i] += rate[i] * ScalarOf<decltype(c)>(epsilon);
    return moved;
  };
  return pull_back(flow, omega)(Matrix<T, D, 1>(at.template cast<T>()),
                                Tangents<T, D, k>(V.template cast<T>()))
      .part[0];
}

/// The prolongation of an automorphism between coordinates of jets.
template <int n, int N, class Eta>
auto on_coordinates(Eta const& eta) {
  return [eta](auto const& c) { return coordinates(prolongation(eta, jet_at<n, N>(c))); };
}

}  // namespace

STATEMENT(eq_9_4, "covariant momentum map and the multisymplectic form") {
  claim.holds(
      "With $\\Omega=-d\\Theta$; the momentum map is linear in $\\xi$. There is one for relabelling of the "
      "barotropic and of the incompressible fluid, and for isometries and time of a medium of any energy.");
  // Momenta of a fluid, differentiated: some 60 with denominators, times a potential and four vectors.
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    constexpr int jets = Jet<S, n, n>::dimension;
    if (n == 3 && numbers_grow()) return;
    auto const fluid = draw_homogeneous_fluid<S, n>(draw);
    auto const xi = draw_relabelling<S, n>(fluid.G, draw);
    auto const field = relabelling_field<n>(xi);
    auto const at = coordinates(draw_jet<S, n, n>(draw));
    auto const V = draw_tangents<S, jets, n + 1>(draw);
    auto const [left, right] = both_sides<n, n>(fluid, field, at, V);
    claim.equal("relabelling: dJ is the contraction of Omega", model, left, right, 10);
    claim.differs("with the other sign of Omega", model, S(-left), right);
    auto const [varying_left, varying_right] = both_sides<n, n>(with_varying_mass(fluid, draw), field, at, V);
    claim.differs("mass that varies", model, varying_left, varying_right);

    auto const medium = draw_symmetric_medium<S, n>(draw);
    ShiftAndTime<n, S> const shift{draw.number<S>(), draw.number<S>()};
    auto const [of_shift, J_of_shift] = both_sides<n, n>(medium, shift, at, V);
    claim.equal("isometry and time: dJ is the contraction of Omega", model, of_shift, J_of_shift, 10);
    auto const U = draw_tangents<S, jets, n>(draw);
    auto const J = [&](S const& along_space, S const& along_time) {
      return S(covariant_momentum_map<n, n>(medium, ShiftAndTime<n, S>{along_space, along_time})(at, U));
    };
    S const both = J(shift.shift, shift.time);
    claim.equal("linear in the field", model, both,
                S(J(S(1), S(0)) * shift.shift + J(S(0), S(1)) * shift.time), 10);
    claim.differs("the shift alone", model, both, S(J(S(1), S(0)) * shift.shift));
    auto const [of_medium, J_of_medium] = both_sides<n, n>(medium, field, at, V);
    claim.differs("relabelling of a medium with any energy", model, of_medium, J_of_medium);

    constexpr int extended = Jet<S, n, n + 1>::dimension;
    auto const water = coordinates(draw_pressed_jet<S, n>(draw));
    auto const W = draw_tangents<S, extended, n + 1>(draw);
    auto const [of_water, J_of_water] =
        both_sides<n, n + 1>(ideal(fluid), density_relabelling_field<n + 1>(xi), water, W);
    claim.equal("relabelling of the incompressible fluid: dJ is the contraction of Omega", model, of_water,
                J_of_water, 10);
    auto const [of_fixed, J_of_fixed] =
        both_sides<n, n + 1>(ideal(fluid), relabelling_field<n + 1>(xi), water, W);
    claim.differs("the incompressible fluid, the multiplier left as it is", model, of_fixed, J_of_fixed);
  });
}

STATEMENT(claim_9_1_cartan_form_invariant, "invariance of the Cartan form under the prolonged symmetry") {
  claim.holds(
      "For any density and any field the Lie derivative is the Cartan form of the rate of equivariance, "
      "$\\mathfrak L_{j^1\\xi}\\Theta_L=\\Theta_r$: it vanishes for symmetries, and for them alone.");
  over_dimensions(Small{}, [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
    constexpr int jets = Jet<S, n, N>::dimension;
    auto const L = draw_density<S, n, N>(draw);
    auto const xi = draw_field<S, n, N>(draw);
    auto const at = coordinates(draw_jet<S, n, N>(draw));
    auto const V = draw_tangents<S, jets, n + 1>(draw);
    auto const theta = cartan_form<n, N>(L);
    S const by_flow = lie_derivative_of_form(prolonged<n, N>(xi), theta, at, V);
    auto const rate = [&]<class T>(Jet<T, n, N> const& j) -> T { return equivariance_rate(L, xi, j); };
    claim.equal("any density, any field: the Cartan form of the rate", model, by_flow,
                S(cartan_form<n, N>(rate)(at, V)), 10);
    auto const [contracted, dJ] = both_sides<n, N>(L, xi, at, V);
    claim.equal("and dJ less the contraction of Omega", model, by_flow, S(dJ - contracted), 10);
    claim.refutes("invariant under every field", model, by_flow, theta(at, V));
  });
  over_dimensions(PlaneAndSpace{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    constexpr int jets = Jet<S, n, n>::dimension;
    auto const fluid = draw_homogeneous_fluid<S, n>(draw);
    auto const at = coordinates(draw_jet<S, n, n>(draw));
    auto const V = draw_tangents<S, jets, n + 1>(draw);
    auto const of = [&](auto const& density, auto const& xi) {
      return lie_derivative_of_form(prolonged<n, n>(xi), cartan_form<n, n>(density), at, V);
    };
    S const scale = cartan_form<n, n>(fluid)(at, V);
    claim.zero("relabelling", model, of(fluid, relabelling_field<n>(draw_relabelling<S, n>(fluid.G, draw))),
               scale, 100);
    claim.refutes("a field that does not preserve the volume", model,
                  of(fluid, relabelling_field<n>(draw_compression<S, n>(draw))), scale);
    auto const medium = draw_symmetric_medium<S, n>(draw);
    claim.zero("isometry and time, any energy", model,
               of(medium, ShiftAndTime<n, S>{draw.number<S>(), draw.number<S>()}),
               S(cartan_form<n, n>(medium)(at, V)), 100);
  });
}

STATEMENT(claim_9_1_lifted_actions, "lifted actions and canonical transformations of the jet bundle") {
  claim.corrected(
      "\\eta_{J^1Y}^*\\Theta_{\\mathcal L}=\\Theta_{\\mathcal L}\\ \\text{for every lifted}\\ \\eta_{J^1Y}",
      "\\eta_{J^1Y}^*\\Theta_{\\mathcal L}=\\Theta_{\\eta^*\\mathcal L}",
      "Every lift to the dual jet bundle preserves the canonical $\\Theta$. A prolongation to $J^1Y$ "
      "takes $\\Theta_{\\mathcal L}$ to the Cartan form of the pulled-back density: it is preserved "
      "where $\\mathcal L$ is equivariant, and only there. Galileo's boost of a medium in flat space "
      "preserves $\\Omega$ and not $\\Theta$.");
  over_dimensions(
      std::tuple<Dimensions<1, 2>, Dimensions<2, 1>, Dimensions<3, 1>>{},
      [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
        constexpr int jets = Jet<S, n, N>::dimension, duals = DualJet<S, n, N>::dimension;
        auto const L = draw_density<S, n, N>(draw);
        auto const eta = as_automorphism(draw_automorphism<S, n, N>(draw));
        auto const j = draw_jet<S, n, N>(draw);
        auto const at = coordinates(j);
        auto const V = draw_tangents<S, jets, n + 1>(draw);
        auto const theta = cartan_form<n, N>(L);
        S const pulled = pull_back(on_coordinates<n, N>(eta), theta)(at, V);
        claim.equal("any density, any automorphism: the Cartan form of the pulled-back density", model,
                    pulled, S(cartan_form<n, N>(PulledBackDensity{L, eta})(at, V)), 10);
        claim.differs("printed: preserved by every lift", model, pulled, S(theta(at, V)));
        // On vectors that a section has: the forms differ there by the defect, so only equivariance preserves
        // them.
        Tangents<S, jets, n + 1> of_section = draw_tangents<S, jets, n + 1>(draw);
        of_section.template topRows<n + 1>().setIdentity();
        of_section.template middleRows<N>(n + 1) = j.v;
        claim.equal("what changes on vectors of a section: the defect of equivariance", model,
                    S(pull_back(on_coordinates<n, N>(eta), theta)(at, of_section) - theta(at, of_section)),
                    equivariance_defect(L, eta, j), 100);

        DualJet<S, n, N> z{draw_event<S, n>(draw), draw.vector<S, Matrix<S, N, 1>>(N), draw.number<S>(), {}};
        for (int mu = 0; mu <= n; ++mu) z.p.col(mu) = draw.vector<S, Matrix<S, N, 1>>(N);
        auto const U = draw_tangents<S, duals, n + 1>(draw);
        auto const lift = [&](auto const& c) {
          return coordinates(dual_prolongation(eta, dual_jet_at<n, N>(c)));
        };
        claim.equal("any automorphism: the canonical form of the dual bundle is preserved", model,
                    S(pull_back(lift, canonical_form<n, N>())(coordinates(z), U)),
                    S(canonical_form<n, N>()(coordinates(z), U)), 10);
        // The proof: the Legendre transformations before and after.
        claim.equal("the lift of the momenta of the pulled-back density", model,
                    coordinates(dual_prolongation(eta, legendre(PulledBackDensity{L, eta}, j))),
                    coordinates(legendre(L, prolongation(eta, j))), 10);
      });
  over_dimensions(Plane{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    constexpr int jets = Jet<S, n, n>::dimension;
    auto fluid = draw_homogeneous_fluid<S, n>(draw);
    auto const j = draw_jet<S, n, n>(draw);
    auto const at = coordinates(j);
    auto const V = draw_tangents<S, jets, n + 1>(draw);
    auto const W = draw_tangents<S, jets, n + 2>(draw);
    fluid.G = draw_stretchable_metric<S, n>(draw);
    draw_positive(S(j.particle()[0] + S(1)));  // the root of det G
    auto const eta = on_coordinates<n, n>(relabelling<n>(Stretch<S, n>{ratio<S>(9, 4), ratio<S>(16, 81)}));
    auto const theta = cartan_form<n, n>(fluid);
    claim.equal("equivariant density: the Cartan form is preserved", model, S(pull_back(eta, theta)(at, V)),
                S(theta(at, V)), 10);
    fluid.g = flattened(fluid.g);
    auto const boosted = on_coordinates<n, n>(galilean_boost<n>(draw.vector<S, Matrix<S, n, 1>>(n)));
    auto const omega = multisymplectic_form<n, n>(fluid);
    claim.equal("boost in flat space: Omega is preserved", model, S(pull_back(boosted, omega)(at, W)),
                S(omega(at, W)), 10);
    claim.differs("boost in flat space: Theta is preserved", model,
                  S(pull_back(boosted, cartan_form<n, n>(fluid))(at, V)), S(cartan_form<n, n>(fluid)(at, V)));
  });
}

STATEMENT(eq_9_7, "momentum map from the Cartan form") {
  claim.convention(
      "The density must be equivariant: then "
      "$d(j^1\\xi\\lrcorner\\,\\Theta_L)=j^1\\xi\\lrcorner\\,\\Omega_L$, for any density that is equivariant "
      "under a field with a part along space-time, and for fields that leave it alone. For others the form "
      "is there, and its differential is not the contraction.");
  claim.leaves(
      "Bodies of dimension three are not tried: forms on a jet bundle over four dimensions cost much, and "
      "no coefficient here depends on the dimension.");
  // A symmetry of any kind, straightened: every field without zeros on space-time is one, seen through a map.
  over_dimensions(std::tuple<Dimensions<1, 1>, Dimensions<1, 2>>{}, [&]<int n, int N>(
                                                                        Dimensions<n, N>,
                                                                        std::string const& model) {
    constexpr int jets = Jet<S, n, N>::dimension;
    StraightenedSymmetry<S, n, N> L{draw_density<S, n, N>(draw), draw_automorphism<S, n, N>(draw)};
    // Of second degree, or the numbers grow too long.
    for (auto& c : L.eta.places) c.e.setZero();
    auto const j = draw_jet<S, n, N>(draw);
    auto const at = coordinates(j);
    auto const V = draw_tangents<S, jets, n + 1>(draw);
    auto const xi = L.field();
    claim.zero("the density is equivariant under the field", model, equivariance_rate(L, xi, j), L(j), 100);
    auto const [left, right] = both_sides<n, N>(L, xi, at, V);
    claim.equal("equivariant under any field: its differential is the contraction of Omega", model, left,
                right, 100);
    auto const [other_left, other_right] = both_sides<n, N>(L.still, xi, at, V);
    claim.differs("a density that is not equivariant", model, other_left, other_right);
    // The remark on the two derivations: the form by the Legendre transformation, from the canonical one.
    auto const U = draw_tangents<S, jets, n>(draw);
    auto const by_legendre = pull_back(
        [&L](auto const& c) { return coordinates(legendre(L, jet_at<n, N>(c))); }, canonical_form<n, N>());
    claim.equal("the same from the canonical form of the dual bundle", model,
                S(covariant_momentum_map<n, N>(L, xi)(at, U)),
                S(contract(prolonged<n, N>(xi), by_legendre)(at, U)), 10);
  });
  over_dimensions(Plane{}, [&]<int n>(Dimensions<n, n>, std::string const& model) {
    constexpr int jets = Jet<S, n, n>::dimension;
    auto const at = coordinates(draw_jet<S, n, n>(draw));
    auto const V = draw_tangents<S, jets, n + 1>(draw);
    auto const solid = Continuum{draw_metric<S, n>(draw), StereographicSphere<S, n>{S(1)},
                                 draw_mass<S, n>(draw), draw_solid<S, n>(draw)};
    SphereRotation<S, n> turning{Matrix<S, n, n>::Zero(), draw.vector<S, Matrix<S, n, 1>>(n)};
    turning.turn(0, 1) = draw.number<S>(), turning.turn(1, 0) = -turning.turn(0, 1);
    auto const [left, right] = both_sides<n, n>(solid, motion_of_space<n>(turning), at, V);
    claim.equal("rotations of a solid on a sphere: its differential is the contraction of Omega", model, left,
                right, 10);
    auto const dilation = [](auto const& y) { return y; };
    auto const [of_dilation, J_of_dilation] = both_sides<n, n>(solid, motion_of_space<n>(dilation), at, V);
    claim.differs("dilation of a solid on a sphere", model, of_dilation, J_of_dilation);
  });
  over_dimensions(
      std::tuple<Dimensions<1, 3>>{}, [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
        auto const L = draw_density<S, n, N>(draw);
        auto const xi = draw_field<S, n, N>(draw);
        auto const phi = draw_section<S, n, N>(draw);
        Event<S, n> const x = draw_event<S, n>(draw);
        auto const V = draw_tangents<S, n + 1, n>(draw);
        S const by_forms = pull_back(jet_extension(phi), covariant_momentum_map<n, N>(L, xi))(x, V);
        auto const j = first_jet(phi, x);
        claim.equal("pulled back by a section: the Noether current", model, by_forms,
                    S(flux_form([&](auto const&) { return noether_current(L, xi, j); })(x, V)), 10);
        // Vertical variations alone give p dy ^ d^n x_mu less p v d^{n+1}x.
        Event<S, n> short_current = noether_current(L, xi, j);
        short_current -= xi(point_of(j)).template head<n + 1>() * L(j);
        claim.differs("from the Cartan form of vertical variations", model, by_forms,
                      S(flux_form([&](auto const&) { return short_current; })(x, V)));
      });
}
