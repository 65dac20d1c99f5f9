// Scalars: rational (long: double)
// Section 9.1: equivariance of the two fluid Lagrangians under relabelling.
#include "fields.hpp"

#include "statement.hpp"
#include "symmetries.hpp"

namespace {

using namespace actio;
using namespace actio::checks;

}  // namespace

STATEMENT(prop_9_1_1, "equivariance of the two fluid Lagrangians under relabelling") {
  claim.convention("With the same density everywhere, an energy that sees the body through J alone, fields that are divergence-free with respect to $\\sqrt{\\det G}$, and, where $\\det G$ varies, a multiplier that goes over as a density.");
  // Each density is of degree some 24 with its denominators, a field 12.
  claim.degree(80);
  over_points(PlaneAndSpace{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const fluid = draw_homogeneous_fluid<S, n>(draw);
    auto const xi = draw_relabelling<S, n>(fluid.G, draw);
    auto const squeezing = draw_compression<S, n>(draw);
    auto const j = draw_jet<S, n, n + 1>(draw);
    auto const below = deformation(j);
    // The rate is a sum of terms of the size of L.
    claim.zero("barotropic", model, equivariance_rate(fluid, relabelling_field<n>(xi), below), fluid(below), 10);
    claim.zero("incompressible", model, equivariance_rate(ideal(fluid), density_relabelling_field<n + 1>(xi), j), fluid(below), 10);
    claim.refutes("barotropic, mass that varies", model, equivariance_rate(with_varying_mass(fluid, draw), relabelling_field<n>(xi), below), fluid(below));
    claim.refutes("barotropic, a field with divergence", model, equivariance_rate(fluid, relabelling_field<n>(squeezing), below), fluid(below));
    claim.refutes("incompressible, a field with divergence", model, equivariance_rate(ideal(fluid), density_relabelling_field<n + 1>(squeezing), j), fluid(below));
  });
}

STATEMENT(claim_9_1_barotropic_equivariance, "equivariance of the barotropic Lagrangian under relabelling") {
  claim.holds("For every metric of the body, where volume-preserving means $\\sqrt{\\det G(\\eta(x))}\\,\\det\\partial\\eta=\\sqrt{\\det G(x)}$.");
  claim.degree(80);
  over_points(PlaneAndSpace{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto fluid = draw_homogeneous_fluid<S, n>(draw);
    fluid.G = draw_stretchable_metric<S, n>(draw);
    auto const j = draw_jet<S, n, n>(draw);
    auto const eta = relabelling<n>(Stretch<S, n>{ratio<S>(3, 2), ratio<S>(4, 9)});
    claim.zero("finite map, det G varies", model, equivariance_defect(fluid, eta, j), fluid(j), 10);
    claim.refutes("mass that varies", model, equivariance_defect(with_varying_mass(fluid, draw), eta, j), fluid(j));
    claim.refutes("determinant 1, where det G varies", model, equivariance_defect(fluid, relabelling<n>(Stretch<S, n>{ratio<S>(3, 2), ratio<S>(2, 3)}), j), fluid(j));
  });
}

STATEMENT(claim_9_1_incompressible_equivariance, "equivariance of the incompressible Lagrangian under relabelling") {
  claim.convention("With the multiplier fixed, as (9.1) has it, only in coordinates with constant $\\det G$; otherwise with $\\lambda=\\sqrt{\\det G}\\,P$ carried as a density, P fixed.");
  claim.degree(80);
  over_points(PlaneAndSpace{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n, N = n + 1;
    auto fluid = draw_homogeneous_fluid<S, n>(draw);
    auto const j = draw_jet<S, n, N>(draw);
    S const scale = fluid(deformation(j));
    auto const xi = draw_relabelling<S, n>(fluid.G, draw);
    claim.zero("det G varies: the multiplier carried as a density", model, equivariance_rate(ideal(fluid), density_relabelling_field<N>(xi), j), scale, 10);
    claim.refutes("det G varies: the multiplier fixed", model, equivariance_rate(ideal(fluid), relabelling_field<N>(xi), j), scale);
    fluid.G = draw_stretchable_metric<S, n>(draw, true);
    claim.zero("constant det G: the multiplier fixed", model, equivariance_rate(ideal(fluid), relabelling_field<N>(draw_relabelling<S, n>(fluid.G, draw)), j), scale, 10);
  });
}

STATEMENT(claim_9_1_jacobian_functions, "functions of the Jacobian and the determinant of a relabelling") {
  claim.convention("That the determinant is 1, and the displayed equality without $\\sqrt{\\det G}$, need coordinates in which $\\det G$ is constant. In any, J is the same before and after, and $f(J)\\sqrt{\\det G}\\,d^{n+1}x$ is equivariant.");
  claim.degree(60);
  over_points(PlaneAndSpace{}, [&]<class D>(D, std::string const& model) {
    constexpr int n = D::n;
    auto const fluid = draw_homogeneous_fluid<S, n>(draw);
    auto const G = draw_stretchable_metric<S, n>(draw), g = fluid.g;
    auto const j = draw_jet<S, n, n>(draw);
    auto const eta = relabelling<n>(Stretch<S, n>{ratio<S>(3, 2), ratio<S>(4, 9)});
    auto const to = prolongation(eta, j);
    S const det = determinant(tangent<n, n>(eta, j.x, j.y).base);
    S const before = jacobian(G(j.particle()), g(j.y), j.gradient()), after = jacobian(G(to.particle()), g(to.y), to.gradient());
    S const root_before = volume<S>(G(j.particle())), root_after = volume<S>(G(to.particle()));
    claim.equal("the volume is preserved", model, S(root_after * det), root_before);
    claim.equal("J is the same", model, after, before, 10);
    claim.equal("f(J) times the volume of the body", model, S(fluid.W.w(after) * root_after * det), S(fluid.W.w(before) * root_before), 10);
    claim.differs("determinant 1", model, det, S(1));
    claim.differs("f(J) alone", model, S(fluid.W.w(after) * det), fluid.W.w(before));
  });
}
