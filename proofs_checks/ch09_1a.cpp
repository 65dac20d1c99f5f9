// Scalars: rational (long: double)
// Section 9.1: the relabelling action, its prolongations and equivariance.
#include "fields.hpp"

#include "statement.hpp"
#include "symmetries.hpp"

namespace {

using namespace actio;
using namespace actio::checks;

/// Any automorphism with an inverse: time and body are stretched and mixed, places go by a polynomial of everything.
template <class S, int n, int N>
struct AnyAutomorphism {
  Stretch<S, n> stretch;
  Eigen::Matrix<S, n, 1> drift;
  std::array<Cubic<S, n + 1 + N>, N> places;
  template <class V>
  auto base(V const& x) const {
    V to;
    to[0] = x[0] * 2;
    to.template tail<n>() = stretch(Eigen::Matrix<ScalarOf<V>, n, 1>(x.template tail<n>()));
    for (int i = 0; i < n; ++i) to[1 + i] += x[0] * ScalarOf<V>(drift[i]);
    return to;
  }
  template <class V>
  auto back(V const& to) const {
    V x;
    x[0] = to[0] / 2;
    Eigen::Matrix<ScalarOf<V>, n, 1> body = to.template tail<n>();
    for (int i = 0; i < n; ++i) body[i] -= x[0] * ScalarOf<V>(drift[i]);
    x.template tail<n>() = stretch.back(body);
    return x;
  }
  template <class V>
  auto fibre(V const& point) const {
    Eigen::Matrix<ScalarOf<V>, N, 1> y = point.template tail<N>();
    for (int a = 0; a < N; ++a) y[a] += places[a](point);
    return y;
  }
};
template <class S, int n, int N>
AnyAutomorphism<S, n, N> draw_automorphism(Draw& draw) {
  AnyAutomorphism<S, n, N> eta{{ratio<S>(3, 2), ratio<S>(4, 5)}, draw.vector<S, Eigen::Matrix<S, n, 1>>(n), {}};
  for (auto& c : eta.places) c = draw_cubic<S, n + 1 + N>(draw, ratio<S>(1, 5));
  return eta;
}


/// Any field on the body.
template <class S, int n>
struct BodyField {
  std::array<Cubic<S, n>, n> components;
  template <class V>
  auto operator()(V const& x) const {
    Eigen::Matrix<ScalarOf<V>, n, 1> rate;
    for (int i = 0; i < n; ++i) rate[i] = components[i](x);
    return rate;
  }
};
template <class S, int n>
BodyField<S, n> draw_body_field(Draw& draw) {
  BodyField<S, n> xi;
  for (auto& c : xi.components) c = draw_cubic<S, n>(draw);
  return xi;
}
/// Its flow, to first order in an infinitesimal.
template <class S, int n>
auto flow_of(BodyField<S, n> const& xi) {
  return [xi](auto const& x) {
    Dual<S> epsilon(S(0));
    epsilon.part[0] = S(1);
    auto moved = x.eval();
    auto const rate = xi(x);
    for (int i = 0; i < n; ++i) moved[i] += rate[i] * ScalarOf<decltype(x)>(epsilon);
    return moved;
  };
}

template <class S, int n, int N>
Eigen::Matrix<S, n, n> tangent_of(Stretch<S, n> const& eta, Jet<S, n, N> const& j) {
  return tangent<n, N>(relabelling<N>(eta), j.x, j.y).base.template bottomRightCorner<n, n>();
}

}  // namespace

STATEMENT(eq_9_1, "action of relabelling on base, fibres and multiplier") {
  claim.convention("Leaving $\\lambda$ as it is suits only coordinates in which $\\det G$ is constant: there a volume-preserving map has determinant 1. In others $\\lambda=\\sqrt{\\det G}\\,P$ goes over as a density, and $P$ is what stays.");
  claim.degree(80);
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = n + 1;
    auto fluid = draw_homogeneous_fluid<S, n>(draw);
    auto const j = draw_jet<S, n, N>(draw);
    Stretch<S, n> const even{ratio<S>(3, 2), ratio<S>(2, 3)}, uneven{ratio<S>(3, 2), ratio<S>(4, 9)};
    auto const to = tangent<n, N>(relabelling<N>(uneven), j.x, j.y);
    claim.equal("places and multiplier stay", model, to.y, j.y);
    claim.equal("time stays", model, to.x[0], j.x[0]);
    fluid.G = draw_stretchable_metric<S, n>(draw, true);
    claim.zero("constant det G: the multiplier fixed", model, equivariance_defect(ideal(fluid), relabelling<N>(even), j), S(1));
    fluid.G = draw_stretchable_metric<S, n>(draw);
    auto const density = [&](auto const& point) {
      auto const volume_after = ScalarOf<decltype(point)>(1) + (point[1] + 1) * ratio<S>(3, 2) - 1;
      Eigen::Matrix<ScalarOf<decltype(point)>, N, 1> y = point.template tail<N>();
      y[n] = y[n] * volume_after / (point[1] + 1);
      return y;
    };
    auto const carried = Automorphism{relabelling<N>(uneven).base, density};
    claim.zero("det G varies: the multiplier carried as a density", model, equivariance_defect(ideal(fluid), carried, j), S(1));
    claim.refutes("det G varies: the multiplier fixed", model, equivariance_defect(ideal(fluid), relabelling<N>(uneven), j), S(1));
  });
}

STATEMENT(eq_9_2, "prolongation of bundle automorphisms to jets") {
  claim.holds();
  // A cubic of a cubic, of the inverse of a map of second degree.
  claim.degree(60);
  over_points(std::tuple<Dimensions<2, 2>, Dimensions<3, 1>>{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = D::N;
    auto const any = draw_automorphism<S, n, N>(draw);
    auto const eta = Automorphism{[any](auto const& x) { return any.base(x); }, [any](auto const& point) { return any.fibre(point); }};
    auto const back = [any](auto const& x) { return any.back(x); };
    auto const phi = draw_section<S, n, N>(draw);
    Event<S, n> const x = draw_event<S, n>(draw);
    auto const j = prolongation(eta, first_jet(phi, x));
    auto const moved = first_jet(moved_section(eta, back, phi), Event<S, n>(any.base(x)));
    // The inverse map and the elimination divide by determinants near one.
    claim.equal("the jet of the moved section", model, j.v, moved.v, 10);
    claim.equal("and its place", model, j.y, moved.y);
    auto const d = tangent<n, N>(eta, x, phi(x).eval());
    claim.differs("the tangent map of the base in place of its inverse", model, ((d.along + d.fibre * first_jet(phi, x).v) * d.base).eval(), moved.v);
  });
}

STATEMENT(claim_9_1_prolongation_coordinates, "finite prolongation in coordinates") {
  claim.holds("For the lift (9.1); with a multiplier that is carried as a density, its rates have a term more.");
  claim.degree(20);
  over_points(PlaneAndSpace{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = n + 1;
    Stretch<S, n> const eta{ratio<S>(3, 2), ratio<S>(4, 9)};
    auto const j = draw_jet<S, n, N>(draw);
    auto const lifted = prolongation(relabelling<N>(eta), j);
    auto const slope = tangent_of(eta, j);
    Eigen::Matrix<S, N, n> const formula = j.gradient() * inverse_matrix(slope);
    claim.equal("gradients: v and beta times the inverse", model, lifted.gradient(), formula, 10);
    claim.equal("rates in time stay", model, lifted.velocity(), j.velocity());
    claim.differs("without the inverse", model, lifted.gradient(), (j.gradient() * slope).eval());
    claim.differs("transposed", model, lifted.gradient(), (j.gradient() * inverse_matrix(slope).transpose()).eval());
  });
}

STATEMENT(eq_9_3, "infinitesimal prolongation in coordinates") {
  claim.holds("The field is divergence-free with respect to $\\sqrt{\\det G}$; the formula holds for any field on the body.");
  claim.degree(20);
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = n + 1;
    auto const xi = draw_body_field<S, n>(draw);
    auto const j = draw_jet<S, n, N>(draw);
    auto const lift = jet_at<n, N>(prolonged<n, N>(relabelling_field<N>(xi))(coordinates(j)));
    // The flow to first order in an infinitesimal.
    using T = Dual<S>;
    auto const moved = prolongation(relabelling<N>(flow_of(xi)), j.template cast<T>());
    Eigen::Matrix<S, N, n + 1> rate;
    for (int a = 0; a < N; ++a)
      for (int mu = 0; mu <= n; ++mu) rate(a, mu) = moved.v(a, mu).part[0];
    claim.equal("the flow of the prolongations", model, lift.v, rate);
    auto const slope = tangent<n, N>(relabelling<N>(xi), j.x, j.y).base.template bottomRightCorner<n, n>().eval();
    Eigen::Matrix<S, N, n> const formula = -j.gradient() * slope;
    claim.equal("minus the gradient times the slope of the field", model, lift.gradient(), formula);
    claim.zero("the components in time, of place and multiplier", model, S(lift.x[0] + lift.y.squaredNorm() + lift.velocity().squaredNorm()), S(1));
    claim.differs("the other sign", model, lift.gradient(), (j.gradient() * slope).eval());
    claim.differs("the other index", model, lift.gradient(), (-j.gradient() * slope.transpose()).eval());
  });
}

STATEMENT(claim_9_1_prolonged_velocities, "velocity components of the infinitesimal prolongation") {
  claim.holds("A relabelling that changes in time would add $-v^a{}_m\\,\\partial_t\\xi^m$.");
  claim.degree(20);
  over_points(PlaneAndSpace{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = n + 1;
    auto const j = draw_jet<S, n, N>(draw);
    auto const any = draw_field<S, n, N>(draw);
    // The field of the model at its time, and at a time that stands still.
    auto const field = [&](bool still) {
      return [&any, still](auto const& point) {
        using T = ScalarOf<decltype(point)>;
        Eigen::Matrix<T, n + 1 + N, 1> at = point;
        if (still) at[0] = T(0);
        Eigen::Matrix<T, n + 1 + N, 1> rate = any(at);
        rate[0] = T(0);
        rate.template tail<N>().setZero();
        return rate;
      };
    };
    auto const still = jet_at<n, N>(prolonged<n, N>(field(true))(coordinates(j)));
    claim.zero("no rate of the velocities", model, still.velocity(), S(1));
    auto const running = jet_at<n, N>(prolonged<n, N>(field(false))(coordinates(j)));
    claim.refutes("a field that depends on time", model, running.velocity(), S(1));
  });
}

STATEMENT(claim_9_1_equivariance, "equivariance of a Lagrangian density under a group") {
  claim.convention("Equivalent to invariance of the action over every region, which moves with $\\eta_X$; invariance up to what happens at the boundary allows a divergence, as under Galileo's boosts.");
  claim.degree(80);
  over_points(Plane{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto fluid = draw_homogeneous_fluid<S, n>(draw);
    fluid.G = draw_stretchable_metric<S, n>(draw);
    auto const j = draw_jet<S, n, n>(draw);
    auto const eta = relabelling<n>(Stretch<S, n>{ratio<S>(3, 2), ratio<S>(4, 9)});
    auto const V = draw_tangents<S, n + 1, n + 1>(draw);
    // Both sides as forms at eta(x), on vectors that come from x.
    auto const base = tangent<n, n>(eta, j.x, j.y).base;
    Eigen::Matrix<S, n + 1, n + 1> const W = base * V;
    S const left = fluid(prolongation(eta, j)) * determinant(W), right = fluid(j) * determinant(V);
    claim.equal("forms at the moved point", model, left, right, 10);
    claim.differs("a map that does not preserve the volume", model, S(equivariance_defect(fluid, relabelling<n>(Stretch<S, n>{S(2), S(1)}), j) + fluid(j)), fluid(j));
    // The derivative of the defect along a flow is the rate.
    auto const xi = draw_body_field<S, n>(draw);
    using T = Dual<S>;
    T const along_flow = PulledBackDensity{fluid, relabelling<n>(flow_of(xi))}(j.template cast<T>());
    claim.equal("the rate is the derivative of the defect", model, along_flow.part[0], equivariance_rate(fluid, relabelling_field<n>(xi), j), 10);
  });
}
