// Section 5.0: the generalised rigid body, its inertia, its Lagrangian.
//
// The reference solution is a body of point masses, described without Lambda.
#include "actio/rigid_body/inertia.hpp"
#include "models/bodies.hpp"
#include "statement.hpp"

using namespace actio;
using namespace actio::checks;

namespace {

template <class S>
Vector<S> diagonal_of(Matrix<S> const& m) { return m.diagonal(); }
/// The energy by planes: \f$\tfrac12\sum_{i<j}(\Lambda_i+\Lambda_j)\,\xi_{ij}^2\f$.
template <class S>
S energy_by_planes(Matrix<S> const& lambda, Matrix<S> const& xi) {
  S sum(0);
  each_plane(static_cast<int>(xi.rows()),
             [&](int i, int j) { sum += (lambda(i, i) + lambda(j, j)) * xi(i, j) * xi(i, j) / 2; });
  return sum;
}
/// The moment of inertia of the plane (i, j): \f$\sum m\,(x_i^2+x_j^2)\f$.
template <class S>
S moment(PointMasses<S> const& body, int i, int j) {
  return body.second_moment(i, i) + body.second_moment(j, j);
}

}  // namespace

STATEMENT(claim_5_0_inertia_operator, "symmetry and positivity of the generalised inertia operator") {
  claim.holds(
      "Positive exactly where all sums $\\Lambda_i + \\Lambda_j$, $i \\ne j$, are: one "
      "$\\Lambda_i$ may be negative itself.");
  over_groups(rotation_groups(), claim, [&](auto const& group, auto const& model) {
    int const n = group.matrix_size();
    auto const lambda = draw_second_moments<S>(draw, n);
    auto const xi = draw_skew<S>(draw, group), eta = draw_skew<S>(draw, group);
    auto const j_xi = inertia_operator(lambda, xi), j_eta = inertia_operator(lambda, eta);
    claim.equal("J xi is skew", model, j_xi, Matrix<S>(-j_xi.transpose()));
    claim.zero("J is symmetric", model, S(contract(eta, j_xi) - contract(xi, j_eta)),
               S(size_of(eta) * size_of(j_xi)));
    claim.equal("(xi, xi) is the sum over planes of (Lambda_i + Lambda_j) xi_ij^2 / 2", model,
                quarter_trace(lambda, xi), energy_by_planes(lambda, xi));
    if (ordered_arithmetic<S>())
      claim.fact("positive, one Lambda_i negative", model,
                 lambda(0, 0) < S(0) && quarter_trace(lambda, xi) > S(0));
    // The metric: left translation carries the form, and does not change it.
    auto const k = draw_rotation<S>(draw, group), g = draw_rotation<S>(draw, group);
    auto const metric = [&](Matrix<S> const& configuration, Matrix<S> const& rate) {
      return quarter_trace(lambda, Matrix<S>(configuration.transpose() * rate));
    };
    claim.equal("the metric is left-invariant", model, metric(k * g, k * g * xi), quarter_trace(lambda, xi));
    // Controls: Lambda not symmetric; one sum negative; translation on the right.
    auto const bent = draw_matrix<S>(draw, n, n), j_bent = inertia_operator(bent, xi);
    claim.differs("Lambda not symmetric: J xi skew", model, j_bent, Matrix<S>(-j_bent.transpose()));
    Matrix<S> negative = lambda;
    negative(0, 0) = -lambda(1, 1) * 2;
    S const energy = quarter_trace(negative, turning<S>(n, 0, 1));
    claim.differs("Lambda_1 + Lambda_2 < 0: energy of turning in that plane, and its modulus", model, energy,
                  S(magnitude(energy)));
    claim.differs("the metric under right translation", model, metric(g * k, g * xi * k),
                  quarter_trace(lambda, xi));
    if (!exact_arithmetic<S>()) {
      // The library's operator, in coordinates: those of the skew matrix.
      auto const body = inertia_from_lambda<Dynamic, S>(diagonal_of(lambda));
      SO<Dynamic> const& so = body.group;
      claim.equal("the library's J, in coordinates", model,
                  Vector<S>(body_momentum(body, velocity(so, so.vee(xi))).components),
                  Vector<S>(so.vee(j_xi)));
      claim.equal("and its inverse", model,
                  Vector<S>(body_velocity(body, momentum(so, so.vee(j_xi))).coordinates),
                  Vector<S>(so.vee(xi)));
      claim.template refuses<UnphysicalInertia>(
          "Lambda_1 + Lambda_2 < 0", model, [&] { inertia_from_lambda<Dynamic, S>(diagonal_of(negative)); });
    }
  });
}

STATEMENT(claim_5_0_principal_moments, "diagonal entries of Lambda and the principal moments of inertia") {
  claim.corrected(R"(\Lambda_i \text{ correspond to the sums of certain principal moments of inertia})",
                  R"(\Lambda_i + \Lambda_j = I_{ij}, \qquad \Lambda_i = \tfrac12(I_{ij} + I_{ik} - I_{jk}))",
                  "The moments are sums of the $\\Lambda_i$, not the other way round: $\\Lambda_i = \\int "
                  "x_i^2\\,dm$, and $I_{ij}$ is the moment of inertia for turning in the plane $(i, j)$, "
                  "in space $I_1 = \\Lambda_2 + \\Lambda_3$.");
  over_groups(rotation_groups(), claim, [&](auto const& group, auto const& model) {
    int const n = group.matrix_size();
    auto const body = draw_point_masses<S>(draw, n);
    auto const lambda = body.second_moments();
    auto const xi = draw_skew<S>(draw, group);
    // J is the tensor of inertia: it gives the angular momentum of the masses.
    claim.equal("J xi is the angular momentum", model, inertia_operator(lambda, xi),
                body.angular_momentum(xi));
    S sum(0);
    for (int j = 1; j < n; ++j) sum += moment(body, 0, j);
    each_plane(n, [&](int i, int j) {
      claim.equal(
          "Lambda_i + Lambda_j is the moment of the plane: twice the energy of turning there at unit rate",
          model, S(lambda(i, i) + lambda(j, j)), S(2 * body.kinetic_energy(turning<S>(n, i, j))));
      int const k = i != 0 ? 0 : j != 1 ? 1 : 2;
      claim.equal("Lambda_i from three moments", model, lambda(i, i),
                  S((moment(body, i, j) + moment(body, i, k) - moment(body, j, k)) / 2),
                  10);  // the difference cancels
    });
    // Controls: sums of moments, as printed: of two of them, of all whose plane contains the axis.
    claim.differs("Lambda_1 as the sum of the moments I_12, I_13", model, lambda(0, 0),
                  S(moment(body, 0, 1) + moment(body, 0, 2)));
    claim.differs("Lambda_1 as the sum of the moments of all planes that contain its axis", model,
                  lambda(0, 0), sum);
    claim.differs("half of it", model, lambda(0, 0), S(sum / 2));
    if (n == 3) {
      // In space: the usual tensor, about axes.
      Vector<S> axis_moments(3);
      for (int a = 0; a < 3; ++a) axis_moments[a] = moment(body, (a + 1) % 3, (a + 2) % 3);
      for (int a = 0; a < 3; ++a) {
        int const b = (a + 1) % 3, c = (a + 2) % 3;
        claim.equal("I_1 = Lambda_2 + Lambda_3", model, axis_moments[a], S(lambda(b, b) + lambda(c, c)));
      }
      claim.differs("Lambda_1 = I_2 + I_3", model, lambda(0, 0), S(axis_moments[1] + axis_moments[2]));
      if (!exact_arithmetic<S>()) {
        auto const made = inertia_from_moments<S>(axis_moments);
        for (int a = 0; a < 3; ++a)
          claim.equal("the library's Lambda from the principal moments", model, S(made.lambda[a]),
                      lambda(a, a), 10);
      }
    }
  });
}

STATEMENT(eq_5_1, "rigid body Lagrangian as kinetic energy") {
  claim.convention(
      "With matrices paired by $\\mathrm{Tr}(A^TB)$. The pairing of coordinates is half of that; "
      "with it the factor is $\\tfrac12$.");
  over_groups(rotation_groups(), claim, [&](auto const& group, auto const& model) {
    int const n = group.matrix_size();
    auto const body = draw_point_masses<S>(draw, n);
    auto const lambda = body.second_moments();
    auto const xi = draw_skew<S>(draw, group), g = draw_rotation<S>(draw, group),
               k = draw_rotation<S>(draw, group);
    // The masses at g x, moving at g' x.
    Matrix<S> const rate = g * xi;
    S const energy = body.kinetic_energy(rate);
    S const reduced = quarter_trace(lambda, xi);
    claim.equal("Tr(xi^T J xi)/4 is the kinetic energy of the masses", model, reduced, energy);
    claim.equal("L(k g, k g') = L(g, g')", model, body.kinetic_energy(k * rate), energy);
    // Controls: the factor that goes with the other pairing, on either side; the velocity g' g^-1;
    // multiplication on the right.
    claim.differs("factor 1/2 with the pairing Tr(A^T B)", model,
                  S(contract(xi, inertia_operator(lambda, xi)) / 2), energy);
    claim.differs("factor 1/4 with the pairing of coordinates", model,
                  S(contract(xi, inertia_operator(lambda, xi)) / 8), energy);
    claim.differs("the velocity as seen from space", model,
                  quarter_trace(lambda, Matrix<S>(rate * g.transpose())), energy);
    claim.differs("L(g k, g' k)", model, body.kinetic_energy(rate * k), energy);
    if (!exact_arithmetic<S>()) {
      auto const made = inertia_from_lambda<Dynamic, S>(diagonal_of(lambda));
      claim.equal("the library's kinetic energy", model,
                  kinetic_energy(made, velocity(made.group, made.group.vee(xi))), energy);
    }
  });
}

STATEMENT(claim_5_0_pairing, "pairing used in the rigid body Lagrangian") {
  claim.corrected(R"(\langle\cdot,\cdot\rangle \text{ is the pairing between the Lie group and its dual})",
                  R"(\langle\cdot,\cdot\rangle \text{ is the pairing between the Lie algebra and its dual})",
                  "A group has no dual. Between elements of the group the same trace is constant and does "
                  "not depend on the motion. Which pairing of skew matrices it is, the thesis does not say: "
                  "by $\\mathrm{Tr}(A^TB)$ the factor of (5.1) is right and $\\partial l/\\partial\\xi = "
                  "\\tfrac12J\\xi$; by half of that $\\partial l/\\partial\\xi = J\\xi$.");
  over_groups(rotation_groups(), claim, [&](auto const& group, auto const& model) {
    int const n = group.matrix_size(), d = group.dimension();
    auto const lambda = draw_second_moments<S>(draw, n);
    auto const xi = draw_skew<S>(draw, group), eta = draw_skew<S>(draw, group);
    auto const g = draw_rotation<S>(draw, group), h = draw_rotation<S>(draw, group);
    S const energy = energy_by_planes(lambda, xi);
    claim.equal("on the algebra <xi, J xi>/4 is the energy", model, quarter_trace(lambda, xi), energy);
    // A pairing: not degenerate, and it carries Ad to its dual g^T mu g.
    Matrix<S> gram(d, d), whole = Matrix<S>::Identity(d, d) * S(2);
    auto const basis = [&](int a) { return group.hat(basis_velocity<S>(group, a).coordinates); };
    for (int a = 0; a < d; ++a)
      for (int b = 0; b < d; ++b) gram(a, b) = contract(Matrix<S>(basis(a)), Matrix<S>(basis(b)));
    claim.equal("Tr(A^T B) is twice the pairing of coordinates", model, gram, whole);
    S const after_Ad = contract(eta, Matrix<S>(g * xi * g.transpose())),
            before_Ad = contract(Matrix<S>(g.transpose() * eta * g), xi);
    claim.zero("the dual of Ad is conjugation by the inverse", model, S(after_Ad - before_Ad),
               S(size_of(eta) * size_of(xi)));
    // dl, by definition: l(xi + epsilon eta).
    S const slope = trace_of(varying(xi, eta), inertia_operator(lambda, varying(xi, eta))).part[0] / 4;
    S const paired = contract(inertia_operator(lambda, xi), eta);
    claim.zero("dl . eta = Tr((J xi)^T eta)/2", model, S(slope - paired / 2), S(size_of(eta) * size_of(xi)));
    // Controls: the trace between elements of the group; sums of these; J xi as the differential of l by
    // Tr(A^T B).
    claim.equal("between elements of the group the trace is constant", model, quarter_trace(lambda, g),
                quarter_trace(lambda, h));
    claim.differs("Tr(g^T J g)/4 as the energy", model, quarter_trace(lambda, g), energy);
    Matrix<S> const sum = g + h;
    claim.differs("a sum of two elements of the group is none", model, Matrix<S>(sum.transpose() * sum),
                  identity_matrix<S>(n));
    claim.differs("dl = J xi by Tr(A^T B)", model, slope, paired);
  });
}
