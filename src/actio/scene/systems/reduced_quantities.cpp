#include "actio/scene/systems/reduced_quantities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "actio/any_group/invariants.hpp"
#include "actio/any_group/semidirect_algebra.hpp"
#include "actio/scene/systems/reduced_shown.hpp"

namespace actio::scene {

std::vector<Quantity> reduced_quantities() {
  using Kind = Quantity::Kind;
  return {
      {"velocity",
       Kind::list,
       "The velocity: of the body on the left, in space on the right; that which has the momentum.",
       "v = g^{-1}\\dot g,\\ \\dot g g^{-1}",
       "of the component over time",
       "eq_2_16",
       {},
       false},
      {"body_momentum",
       Kind::list,
       "The momentum of the body, dl/dv on the left.",
       "\\Pi = \\partial l/\\partial v = \\mathrm{Ad}^*_g\\,\\mu",
       "energy x time",
       "eq_2_16",
       {},
       false},
      {"spatial_momentum",
       Kind::list,
       "The momentum in space, dl/dv on the right.",
       "\\mu = \\mathrm{Ad}^*_{g^{-1}}\\,\\Pi",
       "energy x time",
       "eq_3_8",
       {},
       false},
      {"energy",
       Kind::scalar,
       "The energy.",
       "\\langle\\partial l/\\partial v, v\\rangle - l",
       "energy",
       "",
       {},
       true},
      {"configuration",
       Kind::matrix,
       "The configuration, an element of the group, as a matrix.",
       "g",
       "1",
       "",
       {},
       false},
      {"casimir",
       Kind::list,
       "The functions of degree one and two that every motion on the dual of the algebra keeps, as far as "
       "there "
       "are any, with the carried vectors where there are some: `actio run SCENE --dry-run` writes them out.",
       "C(\\Pi, a)",
       "of the momentum, or its square",
       "",
       {},
       true},
      {"poisson_defect",
       Kind::scalar,
       "How far the next step is from keeping the Lie-Poisson bracket: 0 to rounding where it does, 1 where "
       "nothing cancels.",
       "|A B A^T - B|/(|A B A^T| + |B|)",
       "1",
       "thm_3_2_1",
       {},
       false},
      {"symplectic_defect",
       Kind::scalar,
       "How far the next step is from keeping the canonical two-form of configurations and momenta.",
       "|A^T\\Omega A - \\Omega|/(|A^T\\Omega A| + |\\Omega|)",
       "1",
       "eq_3_5",
       {},
       false},
      {"leaf_defect",
       Kind::scalar,
       "How far the next step leads away from the coadjoint orbit, relative to the momentum.",
       "\\min_g|\\Pi_1 - \\mathrm{Ad}^*_g\\Pi_0|/|\\Pi_0|",
       "1",
       "thm_3_2_1",
       {},
       false},
      {"order",
       Kind::scalar,
       "The order that the method shows here: from one step, two of half its length and four of a quarter; "
       "of a "
       "longer step where its error is lost in rounding.",
       "\\log_2(|\\Phi_h - \\Phi_{h/2}^2|/|\\Phi_{h/2}^2 - \\Phi_{h/4}^4|)",
       "1",
       "",
       {},
       false},
      {"tangent_map",
       Kind::matrix,
       "How momentum and carried vectors now change with those at the start: the product of the exact "
       "derivatives of all steps.",
       "\\partial(\\Pi, a)(t)/\\partial(\\Pi, a)(0)",
       "1",
       "",
       {},
       false},
  };
}

std::vector<Quantity> named_quantities(SceneFile const& file) {
  std::vector<Quantity> out;
  for (auto const& name : carried_names(file))
    out.push_back({name,
                   Quantity::Kind::list,
                   "The carried vector of that name.",
                   "g^{-1}c,\\ g\\,c",
                   "1",
                   "",
                   {},
                   false});
  return out;
}

/// Those of the scene: what the symmetry keeps depends on the side, and on whether a vector breaks it.
std::vector<Quantity> quantities_of(SceneFile const& file, ReducedScene const& scene) {
  auto all = reduced_quantities();
  bool const left = scene.system->side == Side::left;
  for (auto& quantity : all)
    if (quantity.name == (left ? "spatial_momentum" : "body_momentum"))
      quantity.conserved = scene.carried.empty();
  for (auto& own : named_quantities(file)) all.push_back(std::move(own));
  show_reduced(all, scene);
  return all;
}

namespace {

std::vector<std::string> ends_of(std::vector<std::string> const& components) {
  std::vector<std::string> out;
  for (auto const& name : components) out.push_back("_" + name);
  return out;
}
std::vector<std::string> numbered_to(int n) {
  std::vector<int> all;
  for (int i = 1; i <= n; ++i) all.push_back(i);
  return numbered(all);
}

/// What is computed of a state, with the work space for it.
class Reader {
 public:
  Reader(std::shared_ptr<ReducedSystem const> system, ReducedMotion const& motion)
      : system_(std::move(system)), motion_(motion), legendre_(*system_), velocity_(motion.velocity()) {}

  std::vector<double> const& velocity() {
    velocity_ = motion_.velocity();  // not that of the row before, which a resumed run has not seen
    legendre_.solve(motion_.point().momentum, motion_.point().vectors, velocity_);
    return velocity_;
  }
  double energy() { return legendre_.energy(velocity(), motion_.point().vectors); }
  /// The momentum on the other side: \f$\mathrm{Ad}^*_{g^{-1}}\Pi\f$ from that of the body,
  /// \f$\mathrm{Ad}^*_g\mu\f$ from that in space.
  void momentum_across(double* out) const {
    Eigen::MatrixXd const& g = motion_.configuration();
    Eigen::MatrixXd const back = inverse_matrix(g, "configuration");
    bool const left = system_->side == Side::left;
    auto const& p = motion_.point().momentum;
    // What rounding leaves of it, far out on a group that is not compact.
    double const lost = 0x1p-52 * g.norm() * back.norm();
    if (!(lost < 1e-3))
      throw NumericsError(
          fmt::format("{}: the configuration has entries up to {:.3g}, and what it makes of the "
                      "other momentum is lost in rounding; leave this quantity out",
                      left ? "spatial_momentum" : "body_momentum", g.cwiseAbs().maxCoeff()));
    for (std::size_t a = 0; a < p.size(); ++a) {
      auto const& e = system_->algebra.basis[a];
      auto const moved = system_->algebra.vee(Matrix<double>(left ? back * e * g : g * e * back));
      out[a] = 0;
      for (std::size_t c = 0; c < p.size(); ++c) out[a] += p[c] * moved[static_cast<Index>(c)];
    }
  }

 private:
  std::shared_ptr<ReducedSystem const> system_;
  ReducedMotion const& motion_;
  LegendreVelocity legendre_;
  std::vector<double> velocity_;
};

QuantityGraph::NaturalUnit modulus_of(ReducedMotion const& motion) {
  return [&motion](auto, double const*, std::size_t) {
    double sum = 0;
    for (double const p : motion.point().momentum) sum += p * p;
    return std::sqrt(sum);
  };
}

/// Of momentum and vectors, those that the motion leaves at zero: the last component of a direction on a
/// group of rigid motions.
std::vector<int> components_that_stay_zero(ReducedScene const& scene) {
  auto const& algebra = scene.system->algebra;
  std::vector<int> out;
  if (algebra.name != "SE(2)" && algebra.name != "SE(3)") return out;
  for (std::size_t k = 0; k < scene.carried.size(); ++k)
    if (scene.carried[k].constant[algebra.size - 1] == 0)
      out.push_back(algebra.dimension + static_cast<int>(k + 1) * algebra.size - 1);
  return out;
}
/// The structure of an algebra by an ideal that is spanned by one vector of the basis: on its dual that
/// component is zero.
MatrixAlgebra without(MatrixAlgebra algebra, int component) {
  std::erase_if(algebra.constants,
                [&](auto const& c) { return c.a == component || c.b == component || c.c == component; });
  for (auto& c : algebra.constants) c.a -= c.a > component, c.b -= c.b > component, c.c -= c.c > component;
  algebra.components.erase(algebra.components.begin() + component);
  --algebra.dimension;
  return algebra;
}

/// The Casimirs, on momentum and vectors.
std::vector<Casimir> casimirs_of(ReducedScene const& scene) {
  auto const& algebra = scene.system->algebra;
  if (scene.carried.empty()) return casimirs(algebra);
  std::vector<std::string> names;
  for (auto const& vector : scene.carried) names.push_back(vector.name);
  auto whole = semidirect_algebra(algebra, static_cast<int>(names.size()), algebra.size, names);
  auto const zero = components_that_stay_zero(scene);
  for (std::size_t k = zero.size(); k-- > 0;) whole = without(std::move(whole), zero[k]);
  return casimirs(whole);
}

}  // namespace

void define_state(QuantityGraph& graph, ReducedScene const& scene, ReducedMotion const& motion) {
  auto const& algebra = scene.system->algebra;
  auto const ends = ends_of(algebra.components);
  auto const reader = std::make_shared<Reader>(scene.system, motion);
  bool const left = scene.system->side == Side::left;
  graph.define("velocity", ends, [reader](auto, double* out) { std::ranges::copy(reader->velocity(), out); });
  graph.define(left ? "body_momentum" : "spatial_momentum", ends,
               [&motion](auto, double* out) { std::ranges::copy(motion.point().momentum, out); });
  graph.define(
      left ? "spatial_momentum" : "body_momentum", ends,
      [reader](auto, double* out) { reader->momentum_across(out); }, modulus_of(motion));
  graph.define("energy", {""}, [reader](auto, double* out) { *out = reader->energy(); });
  graph.define("configuration", column_ends(Quantity::Kind::matrix, algebra.size),
               [&motion](auto, double* out) {
    Eigen::Map<Eigen::Matrix<double, -1, -1, Eigen::RowMajor>>(
        out, motion.configuration().rows(), motion.configuration().cols()) = motion.configuration();
  });
  for (std::size_t k = 0; k < scene.carried.size(); ++k) {
    auto const n = static_cast<std::size_t>(algebra.size);
    graph.define(scene.carried[k].name, numbered_to(algebra.size), [&motion, k, n](auto, double* out) {
      std::copy_n(motion.point().vectors.begin() + static_cast<std::ptrdiff_t>(k * n), n, out);
    });
  }
}

void define_casimirs(Simulation& simulation, Request const& request, ReducedScene const& scene,
                     ReducedMotion const& motion) {
  if (std::ranges::find(request.quantities, "casimir") == request.quantities.end()) return;
  auto const all = std::make_shared<std::vector<Casimir> const>(casimirs_of(scene));
  if (all->empty())
    request.file.section("output").fail(
        "quantities", "casimir: the dual of this algebra has no Casimir of degree one or two");
  for (std::size_t k = 0; k < all->size(); ++k)
    simulation.remarks.push_back(fmt::format("casimir_{} is {}", k + 1, (*all)[k].text()));
  auto const now = [&motion, constant = components_that_stay_zero(scene)] {
    std::vector<double> x = motion.point().momentum;
    x.insert(x.end(), motion.point().vectors.begin(), motion.point().vectors.end());
    for (std::size_t k = constant.size(); k-- > 0;) x.erase(x.begin() + constant[k]);
    return Vector<double>(Eigen::Map<Eigen::VectorXd const>(x.data(), static_cast<Index>(x.size())));
  };
  simulation.quantities.define(
      "casimir", numbered_to(static_cast<int>(all->size())),
      [all, now](auto, double* out) {
    Vector<double> const x = now();
    for (auto const& casimir : *all) *out++ = casimir.evaluate(x);
      },
      // Its terms may cancel: their moduli added up.
      [all, now](auto, double const*, std::size_t k) {
    Vector<double> const x = now();
    double sum = 0;
    for (auto const& t : (*all)[k].terms) sum += std::abs(t.coefficient * x[t.i] * (t.j < 0 ? 1 : x[t.j]));
    return sum;
  });
}

}  // namespace actio::scene
