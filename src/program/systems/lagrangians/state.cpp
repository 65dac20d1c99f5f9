#include <Eigen/Core>

#include "program/systems/lagrangians/state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "actio/any_group/legendre_velocity.hpp"
#include "actio/any_group/momentum_across.hpp"
#include "program/run/drift.hpp"

namespace actio::scene {
namespace {

std::vector<std::string> ends_of(std::vector<std::string> const& components) {
  std::vector<std::string> out;
  for (auto const& name : components) out.push_back("_" + name);
  return out;
}

/// What is computed of a state, with the work space for it.
class Reader {
 public:
  Reader(std::shared_ptr<systems::ReducedSystem const> system, ReducedMotion const& motion)
      : system_(std::move(system)), motion_(motion), legendre_(*system_), velocity_(motion.velocity()) {}

  std::vector<double> const& velocity() {
    velocity_ = motion_.velocity();  // not that of the row before, which a resumed run has not seen
    legendre_.solve(motion_.point().momentum, motion_.point().vectors, velocity_);
    return velocity_;
  }
  double energy() {
    double const E = legendre_.energy(velocity(), motion_.point().vectors);
    kinetic_ = 0;
    for (std::size_t a = 0; a < velocity_.size(); ++a)
      kinetic_ += motion_.point().momentum[a] * velocity_[a] / 2;
    return E;
  }
  /// Half of the momentum on the velocity, which is the kinetic energy where the Lagrangian is quadratic in
  /// the velocity: of the last energy.
  double kinetic() const { return kinetic_; }
  /// The force now; zero where there is none.
  std::vector<double> force() {
    if (!system_->force) return std::vector<double>(velocity_.size());
    return systems::force_at(*system_, velocity(), motion_.point());
  }
  /// What the forces have added to the momentum of the symmetry.
  std::vector<double> impulse() const {
    auto out = motion_.ledger().impulse;
    out.resize(motion_.point().momentum.size());
    return out;
  }
  /// The momentum on the other side: \f$\mathrm{Ad}^*_{g^{-1}}\Pi\f$ from that of the body,
  /// \f$\mathrm{Ad}^*_g\mu\f$ from that in space.
  void momentum_across(double* out) const {
    Eigen::MatrixXd const& g = motion_.configuration();
    Eigen::MatrixXd const back = inverse_matrix(g, "configuration");
    bool const left = system_->side == systems::Side::left;
    auto const& p = motion_.point().momentum;
    // What rounding leaves of it, far out on a group that is not compact.
    double const lost = 0x1p-52 * g.norm() * back.norm();
    if (!(lost < 1e-3))
      throw NumericsError(
          fmt::format("{}: the configuration has entries up to {:.3g}, and what it makes of the other "
                      "momentum is lost in rounding; leave this quantity out",
                      left ? "spatial_momentum" : "body_momentum", g.cwiseAbs().maxCoeff()));
    std::ranges::copy(systems::momentum_across(system_->algebra, system_->side, g, back, p), out);
  }

 private:
  std::shared_ptr<systems::ReducedSystem const> system_;
  ReducedMotion const& motion_;
  systems::LegendreVelocity legendre_;
  std::vector<double> velocity_;
  double kinetic_ = 0;
};

QuantityGraph::NaturalUnit modulus_of(ReducedMotion const& motion) {
  return [&motion](auto, double const*, std::size_t) { return length_of(motion.point().momentum); };
}

}  // namespace

std::vector<std::size_t> conserved_directions(ReducedScene const& scene) {
  auto const& [algebra, lagrangian] = std::tie(scene.system->algebra, scene.system->lagrangian);
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < algebra.basis.size(); ++i) {
    bool changes = false;
    for (std::size_t k = 0; k < scene.carried.size(); ++k) {
      int const first = algebra.dimension + static_cast<int>(k) * algebra.size;
      bool occurs = false;
      for (int j = first; j < first + algebra.size; ++j) occurs = occurs || lagrangian.depends_on(j);
      changes =
          changes || (occurs && (algebra.basis[i] * scene.carried[k].constant).cwiseAbs().maxCoeff() > 0);
    }
    if (!changes) out.push_back(i);
  }
  return out;
}

void define_state(QuantityGraph& graph, ReducedScene const& scene, ReducedMotion const& motion) {
  auto const& algebra = scene.system->algebra;
  auto const ends = ends_of(algebra.components);
  auto const reader = std::make_shared<Reader>(scene.system, motion);
  bool const left = scene.system->side == systems::Side::left;
  graph.define("velocity", ends, [reader](auto, double* out) { std::ranges::copy(reader->velocity(), out); });
  graph.define(left ? "body_momentum" : "spatial_momentum", ends,
               [&motion](auto, double* out) { std::ranges::copy(motion.point().momentum, out); });
  graph.define(
      left ? "spatial_momentum" : "body_momentum", ends,
      [reader](auto, double* out) { reader->momentum_across(out); }, modulus_of(motion));
  graph.define("force", ends, [reader](auto, double* out) { std::ranges::copy(reader->force(), out); });
  graph.define("work", {""}, [&motion](auto, double* out) { *out = motion.ledger().work; });
  graph.define("impulse", ends, [reader](auto, double* out) { std::ranges::copy(reader->impulse(), out); });
  auto const conserved = conserved_directions(scene);
  std::vector<std::string> conserved_ends;
  for (std::size_t const i : conserved) conserved_ends.push_back(ends[i]);
  graph.define(
      "momentum_balance", conserved_ends,
      [reader, conserved](auto, double* out) {
        std::vector<double> all(reader->impulse().size());
        reader->momentum_across(all.data());
        auto const done = reader->impulse();
        for (std::size_t const i : conserved) *out++ = all[i] - done[i];
      },
      modulus_of(motion));
  graph.define(
      "energy", {""}, [reader](auto, double* out) { *out = reader->energy(); },
      [reader](auto, double const* E, std::size_t) {
        return std::abs(reader->kinetic()) + std::abs(*E - reader->kinetic());
      });
  graph.define(
      "configuration", column_ends(Quantity::Kind::matrix, algebra.size), [&motion](auto, double* out) {
        Eigen::Map<Eigen::Matrix<double, -1, -1, Eigen::RowMajor>>(
            out, motion.configuration().rows(), motion.configuration().cols()) = motion.configuration();
      });
  for (std::size_t k = 0; k < scene.carried.size(); ++k) {
    auto const& vector = scene.carried[k];
    auto const n = static_cast<std::size_t>(algebra.size), shown = vector.shown > 0 ? vector.shown : n;
    auto const names = vector.shown > 0
                           ? ends_of({vector.components.begin(),
                                      vector.components.begin() + static_cast<std::ptrdiff_t>(shown)})
                           : numbered(1, algebra.size);
    graph.define(vector.name, names, [&motion, k, n, shown](auto, double* out) {
      std::copy_n(motion.point().vectors.begin() + static_cast<std::ptrdiff_t>(k * n), shown, out);
    });
  }
}

}  // namespace actio::scene
