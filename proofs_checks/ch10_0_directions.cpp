// Chapter 10: what the multisymplectic form formula says of a variation along space-time.
#include "actio/continuum/stresses.hpp"

#include "fields/off_shell.hpp"
#include "fields/variations.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

/// Few coordinates, a plane in a plane, and a body of three dimensions.
using Bodies = std::tuple<Dimensions<1, 2>, Dimensions<2, 1>, Dimensions<2, 2>, Dimensions<3, 1>>;

/// A density that is the same along one coordinate of space-time.
template <class S, int n, int N>
AnyDensity<S, n, N> same_along(AnyDensity<S, n, N> L, int nu) {
  for (auto* c : {&L.l, &L.m})
    for (auto* vector : {&c->a, &c->b, &c->d, &c->e}) (*vector)[nu] = S(0);
  return L;
}
/// The column \f$T^\mu{}_\nu = p_a{}^\mu v^a{}_\nu - L\,\delta^\mu_\nu\f$ of stress and energy at a jet.
template <class T, int n, int N, class L>
Event<T, n> stress_energy(L const& density, Jet<T, n, N> const& j, int nu) {
  Event<T, n> column = momenta(density, j).transpose() * j.v.col(nu);
  column[nu] -= density(j);
  return column;
}
/// The field \f$\partial/\partial x^\nu\f$ on Y.
template <class S, int n, int N>
AnyVariation<S, n, N> shift(int nu) { return AnyVariation<S, n, N>::coordinate(nu, S(1)); }
/// A section's values as a vertical field on Y.
template <class W>
struct Upright {
  W values;
  template <class V>
  auto operator()(V const& point) const {
    using T = ScalarOf<V>;
    constexpr int all = V::RowsAtCompileTime;
    constexpr int rows = W::rows;
    Matrix<T, all, 1> rate = Matrix<T, all, 1>::Zero();
    rate.template tail<all - rows>() = values(Matrix<T, rows, 1>(point.template head<rows>()));
    return rate;
  }
};
/// A vertical variation with the number of coordinates of space-time.
template <class Values, int n>
struct OnSpaceTime {
  static constexpr int rows = n + 1;
  Values values;
  template <class V>
  auto operator()(V const& x) const { return values(x); }
};
/// An n-form from the components of a current.
template <int n, class Current>
auto form_of(Current const& B) {
  return [B]<class S>(Event<S, n> const& x, Tangents<S, n + 1, n> const& V) -> S {
    auto const components = B(x);
    S sum(0);
    for (int mu = 0; mu <= n; ++mu) sum += components[mu] * volume_form<n>(mu)(x, V);
    return sum;
  };
}

/// All that is compared at one density, section, variation and direction.
template <class S, int n, int N, class L, class Phi, class Vertical>
struct AlongDirection {
  L const& density;
  Phi const& phi;
  Vertical const& W;
  int nu;

  /// \f$\delta_WT^\mu{}_\nu\f$, of the column `of`.
  template <class T>
  Event<T, n> change(Event<T, n> const& x, int of) const {
    return rate_of(stress_energy(density, varied(first_jet(phi, x), first_jet(W, x)), of));
  }
  template <class T>
  Event<T, n> change(Event<T, n> const& x) const { return change(x, nu); }
  /// \f$\partial_\nu(p^\mu\cdot W) - \delta^\mu_\nu\,\partial_\kappa(p^\kappa\cdot W)\f$, or its first term.
  template <class T>
  Event<T, n> curl(Event<T, n> const& x, bool both = true) const {
    auto const slopes = derivative(
        [&]<class U>(Event<U, n> const& at) {
          return Event<U, n>(momenta(density, first_jet(phi, at)).transpose() * W(at));
        },
        x);
    Event<T, n> out = slopes.matrix.col(nu);
    if (both) out[nu] -= slopes.matrix.trace();
    return out;
  }
  /// (6.11): the form contracted with the shift and with W, along the section.
  auto contracted() const {
    return pull_back(jet_extension(phi),
                     contract(prolonged<n, N>(shift<S, n, N>(nu)),
                              contract(prolonged<n, N>(Upright<OnSpaceTime<Vertical, n>>{{W}}),
                                       multisymplectic_form<n, N>(density))));
  }
};

}  // namespace

STATEMENT(claim_10_0_form_formula_directions,
          "relations from the form formula in other directions of space-time") {
  claim.holds(
      "Put as an identity: where $L$ is the same along $x^\\nu$, the form contracted with "
      "$\\partial/\\partial x^\\nu$ and a vertical $W$ is $\\delta_WT^\\mu{}_\\nu\\,d^nx_\\mu$ less the "
      "current $\\partial_\\nu(p^\\mu W) - \\delta^\\mu_\\nu\\partial_\\kappa(p^\\kappa W)$, which flows "
      "out of no region. So (6.11) with the first variation along $x^\\nu$ is the balance of column "
      "$\\nu$ of stress and energy, $T^\\mu{}_\\nu = p^\\mu v_\\nu - L\\delta^\\mu_\\nu$, linearised: of "
      "the energy along time, of the tensor of Eshelby along the body. The relation depends on the "
      "direction in that a medium which varies along $x^\\nu$ has it not. Off the solutions, for any "
      "density; on boxes about uniform strain.");
  claim.leaves(
      "Other fields than shifts along one coordinate are not tried. Whether the formula has relations for "
      "them that were not known is a question that no computation answers.");
  over_dimensions(Bodies{}, [&]<int n, int N>(Dimensions<n, N>, std::string const& dimensions) {
    auto const any = draw_density<S, n, N>(draw);
    auto const phi = draw_section<S, n, N>(draw), W = draw_section<S, n, N>(draw, S(1));
    auto const x = draw_event<S, n>(draw);
    for (int const nu : {0, n}) {
      std::string const model = (nu == 0 ? "time, " : "body, ") + dimensions;
      auto const L = same_along(any, nu);
      using Here = AlongDirection<S, n, N, AnyDensity<S, n, N>, AnySection<S, n, N>, AnySection<S, n, N>>;
      Here const here{L, phi, W, nu}, varying{any, phi, W, nu};
      Event<S, n> const contracted = components_of(here.contracted(), x), change = here.change(x),
                        curl = here.curl(x);
      S const scale = magnitude(contracted) + magnitude(change) + magnitude(curl);
      // Third derivatives of cubics of cubics: an allowance of ten times that of plain evaluation.
      claim.zero("the form with a shift and W, by the change of stress and energy", model,
                 Event<S, n>(contracted - change + curl), scale, 10);
      claim.refutes("in a medium that varies along the shift", model,
                    Event<S, n>(components_of(varying.contracted(), x) - varying.change(x) + varying.curl(x)),
                    scale);
      claim.refutes("the column of another direction", model,
                    Event<S, n>(contracted - here.change(x, n - nu) + curl), scale);
      claim.refutes("without the current that flows out of no region", model,
                    Event<S, n>(contracted - change), scale);
      // That current has no divergence.
      auto const out_of = [&](bool both) {
        return divergence([&]<class T>(Event<T, n> const& at) { return here.curl(at, both); }, x);
      };
      S const whole = out_of(true), part = out_of(false);
      auto const each = derivative([&]<class T>(Event<T, n> const& at) { return here.curl(at, false); }, x);
      S terms_of_it(0);
      for (int mu = 0; mu <= n; ++mu) terms_of_it += size_of(S(each.matrix(mu, mu)));
      claim.zero("divergence of that current", model, whole, terms_of_it, 10);
      claim.refutes("divergence of its first term", model, part, S(magnitude(curl) + magnitude(part)));
      // The balance, off the solutions.
      auto const j = second_jet(phi, x);
      auto const w = second_jet(W, x);
      auto const E = euler_lagrange(L, j), delta_E = linearised_euler_lagrange(L, j, w);
      auto const gained = divergence([&]<class T>(Event<T, n> const& at) { return here.change(at); }, x);
      S const by_forces = delta_E.dot(j.v.col(nu)) + E.dot(w.v.col(nu)),
              terms = magnitude(gained) + size_of(delta_E) * size_of(j.v) + size_of(E) * size_of(w.v);
      claim.zero("what the change of stress and energy loses to the forces", model, S(gained + by_forces),
                 terms, 10);
      claim.refutes("without the force of the section itself", model, S(gained + delta_E.dot(j.v.col(nu))),
                    terms);
      auto const varying_gain =
          divergence([&]<class T>(Event<T, n> const& at) { return varying.change(at); }, x);
      claim.refutes("in a medium that varies along the direction", model,
                    S(varying_gain + linearised_euler_lagrange(any, j, w).dot(j.v.col(nu)) +
                      euler_lagrange(any, j).dot(w.v.col(nu))),
                    terms);
    }
  });
  // As (6.11), on boxes: uniform strain of a uniform body, and first variations of second degree.
  over_dimensions(SmallDimensions{}, [&]<int n, int N>(Dimensions<n, N>, std::string const& dimensions) {
    auto const L = draw_uniform_density<S, n, N>(draw);
    auto const phi = draw_section_of_degree<S, n, N>(draw, 1);
    auto const box = draw_box<S, n>(draw);
    auto const j = second_jet(phi, Event<S, n>(Event<S, n>::Zero()));
    auto const any = not_accelerated(draw_section_of_degree<S, n, N>(draw, 2, S(1)));
    auto const W = first_variation_at(L, j, any);
    for (int const nu : {0, n}) {
      std::string const model = (nu == 0 ? "time, box, " : "body, box, ") + dimensions;
      using Here = AlongDirection<S, n, N, AnyDensity<S, n, N>, AnySection<S, n, N>, Accelerated<S, n, N>>;
      Here const solved{L, phi, W, nu}, other{L, phi, any, nu};
      auto const balance = [&](Here const& here) {
        return boundary_integral(form_of<n>([&](auto const& at) { return here.change(at); }), box, 4);
      };
      S const scale = magnitude(solved.change(box.low)) + magnitude(solved.change(box.high)) +
                      magnitude(components_of(solved.contracted(), box.low));
      // Sums over nodes, and accelerations from one elimination.
      claim.zero("(6.11) with a shift and a first variation", model,
                 boundary_integral(solved.contracted(), box, 4), scale, 10);
      claim.zero("the change of stress and energy through the boundary", model, balance(solved), scale, 10);
      claim.refutes("with W not a first variation", model, balance(other), scale);
      claim.zero("both agree where W is none", model,
                 S(boundary_integral(other.contracted(), box, 4) - balance(other)), scale, 10);
    }
  });
  // What the columns are for a medium.
  over_dimensions(
      std::tuple<Dimensions<2, 2>, Dimensions<1, 3>, Dimensions<3, 3>>{},
      [&]<int n, int N>(Dimensions<n, N>, std::string const& model) {
        if (n > 2 && numbers_grow()) return;
        Continuum const medium{draw_metric<S, n>(draw), draw_metric<S, N>(draw), draw_mass<S, n>(draw),
                               draw_solid<S, n>(draw)};
        auto const j = draw_jet<S, n, N>(draw);
        Matrix<S, n, 1> const X = j.particle();
        auto const g = medium.g(j.y);
        S const root = volume<S>(medium.G(X)), rho = medium.rho(X),
                kinetic = rho * inner(g, j.velocity(), j.velocity()) / S(2),
                stored = rho * medium.W(X, medium.G(X), g, j.gradient());
        Matrix<S, N, n> const P = first_piola_kirchhoff_stress(medium, j);
        Event<S, n> energy, wrong;
        energy << kinetic + stored, -(P.transpose() * j.velocity());
        wrong << kinetic - stored, -(P.transpose() * j.velocity());
        S const size = root * (magnitude(kinetic) + magnitude(stored) + magnitude(P) * magnitude(j.v));
        claim.zero("along time: energy, and power of the tractions", model,
                   Event<S, n>(stress_energy(medium, j, 0) - energy * root), size, 10);
        claim.refutes("the Lagrangian for the energy", model,
                      Event<S, n>(stress_energy(medium, j, 0) - wrong * root), size);
        Matrix<S, n, n> const work = P.transpose() * j.gradient(),
                              eshelby = Matrix<S, n, n>::Identity() * (stored - kinetic) - work;
        Matrix<S, n, n> columns;
        Matrix<S, n, 1> pseudomomentum;
        for (int k = 0; k < n; ++k) {
          auto const column = stress_energy(medium, j, k + 1);
          columns.col(k) = column.template tail<n>(), pseudomomentum[k] = column[0];
        }
        claim.zero("along the body: the tensor of Eshelby", model, Matrix<S, n, n>(columns - eshelby * root),
                   size, 10);
        claim.refutes("the tensor of Eshelby with the work added", model,
                      Matrix<S, n, n>(columns - (eshelby + work * S(2)) * root), size);
        claim.equal("and the momentum of the particles per length of the body", model, pseudomomentum,
                    Matrix<S, n, 1>(j.gradient().transpose() * lowered(g, j.velocity()) * S(rho * root)), 10);
      });
}
