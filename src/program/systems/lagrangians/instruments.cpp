#include <Eigen/Core>

#include "program/systems/lagrangians/instruments.hpp"

#include "actio/any_group/semidirect_algebra.hpp"
#include "actio/any_group/tape_lagrangian.hpp"
#include "actio/instruments/leaf_defect.hpp"
#include "actio/instruments/poisson_defect.hpp"
#include "actio/instruments/symplectic_defect.hpp"
#include "actio/reduction/advected_galerkin.hpp"

namespace actio::scene {
namespace {

using G = systems::SpanOfMatrices;

/// What one step has done: where it leads, and how the group moved, E in g E (left) or E g (right).
template <class S>
struct StepDone {
  systems::ReducedPointOver<S> point;
  Element<G, S> motion;
};

/// One step of the method as a map, at plain numbers and over infinitesimals.
class StepMap {
 public:
  StepMap(ReducedScheme scheme, std::vector<double> velocity)
      : scheme_(std::move(scheme)), group_(scheme_.system->algebra), velocity_(std::move(velocity)) {}

  template <class S>
  StepDone<S> operator()(double h, systems::ReducedPointOver<S> const& from) const {
    if (scheme_.stages > 0) return by_galerkin(h, from);
    return scheme_.fractions.empty() ? by_level(h, from) : by_chart(h, from);
  }
  systems::ReducedSystem const& system() const { return *scheme_.system; }
  G const& group() const { return group_; }

 private:
  template <class S>
  StepDone<S> by_chart(double h, systems::ReducedPointOver<S> const& from) const {
    StepDone<S> done{{}, identity<S>(group_)};
    systems::ChartMap const map(*scheme_.system, scheme_.fractions, velocity_);
    done.point = map(S(h), from, [&](S const& length, std::vector<S> const& v) {
      Matrix<S> const a = systems::hat_of_step(scheme_.system->algebra, length, v);
      Element<G, S> const moved{
          group_, scheme_.system->chart == systems::Chart::cayley ? cayley(a) : matrix_exponential(a)};
      done.motion = scheme_.system->side == systems::Side::left ? done.motion * moved : moved * done.motion;
    });
    return done;
  }
  template <class S>
  StepDone<S> by_galerkin(double h, systems::ReducedPointOver<S> const& from) const {
    systems::TapeLagrangian const l(scheme_.system);
    bool const left = scheme_.system->side == systems::Side::left;
    if (scheme_.system->force) {
      systems::TapeForce const force(scheme_.system, base_value(from.time), h);
      return left
                 ? with_vectors(forced_galerkin_step_left<double>(l, scheme_.stages, each_, force), h, from)
                 : with_vectors(forced_galerkin_step_right<double>(l, scheme_.stages, each_, force), h, from);
    }
    if (scheme_.system->vectors > 0)
      return left ? with_vectors(advected_galerkin_step_left<double>(l, scheme_.stages, each_), h, from)
                  : with_vectors(advected_galerkin_step_right<double>(l, scheme_.stages, each_), h, from);
    MomentumState<G, S> const state{{group_, column<S>(from.momentum)}, {group_, column<S>(velocity_)}};
    auto const done = left ? galerkin_step_left<double>(l, scheme_.stages)(state, h)
                           : galerkin_step_right<double>(l, scheme_.stages)(state, h);
    auto const& p = done.state.momentum.components;
    return {{{p.data(), p.data() + p.size()}, {}}, inverse(done.relative_motion)};
  }
  template <class S>
  StepDone<S> by_level(double h, systems::ReducedPointOver<S> const& from) const {
    systems::TapeLagrangian const l(scheme_.system);
    return scheme_.system->side == systems::Side::left
               ? with_vectors(advected_momentum_level_step_left<double>(l, each_), h, from)
               : with_vectors(advected_momentum_level_step_right<double>(l, each_), h, from);
  }
  template <class Step, class S>
  StepDone<S> with_vectors(Step const& step, double h, systems::ReducedPointOver<S> const& from) const {
    auto const done = step(
        AdvectedMomentumState<G, S, Dynamic>{
            {group_, column<S>(from.momentum)}, column<S>(from.vectors), {group_, column<S>(velocity_)}},
        h);
    auto const &p = done.state.momentum.components, &a = done.state.vector;
    return {{{p.data(), p.data() + p.size()}, {a.data(), a.data() + a.size()}, from.time + S(h)},
            inverse(done.relative_motion)};
  }
  template <class S, class List>
  static Matrix<S, Dynamic, 1> column(List const& list) {
    Matrix<S, Dynamic, 1> x(static_cast<Index>(list.size()));
    for (std::size_t i = 0; i < list.size(); ++i) x[static_cast<Index>(i)] = S(list[i]);
    return x;
  }

  ReducedScheme scheme_;
  G group_;
  std::vector<double> velocity_;
  systems::EachVector each_;
};

/// Momentum and vectors as one element of the dual of the algebra in which they move.
class PointsAsMomenta {
 public:
  /// @param time  when the points are
  PointsAsMomenta(systems::ReducedSystem const& system, double time)
      : group_(system.vectors ? systems::semidirect_algebra(system.algebra, system.vectors, system.length())
                              : system.algebra),
        dimension_(static_cast<std::size_t>(system.dimension())),
        time_(time) {}

  template <class S>
  Momentum<G, S> operator()(systems::ReducedPointOver<S> const& point) const {
    Momentum<G, S> mu{group_, Coordinates<G, S>(group_.dimension())};
    Index at = 0;
    for (S const& x : point.momentum) mu.components[at++] = x;
    for (S const& x : point.vectors) mu.components[at++] = x;
    return mu;
  }
  template <class S>
  systems::ReducedPointOver<S> back(Momentum<G, S> const& mu) const {
    S const* const first = mu.components.data();
    return {{first, first + dimension_}, {first + dimension_, first + mu.components.size()}, S(time_)};
  }

 private:
  G group_;
  std::size_t dimension_;
  double time_;
};

/// The point now, over plain numbers.
systems::ReducedPointOver<double> point_of(ReducedMotion const& motion) {
  return {motion.point().momentum, motion.point().vectors, motion.point().time};
}

double poisson_defect_now(ReducedScheme const& scheme, double h, ReducedMotion const& motion) {
  StepMap const step(scheme, motion.velocity());
  PointsAsMomenta const momenta(*scheme.system, motion.point().time);
  return poisson_defect(
      LiePoissonMinus{}, [&](auto const& mu) { return momenta(step(h, momenta.back(mu)).point); },
      momenta(point_of(motion)));
}

double leaf_defect_now(ReducedScheme const& scheme, double h, ReducedMotion const& motion) {
  StepMap const step(scheme, motion.velocity());
  PointsAsMomenta const momenta(*scheme.system, motion.point().time);
  return orbit_defect([&](auto const& mu) { return momenta(step(h, momenta.back(mu)).point); },
                      momenta(point_of(motion)));
}

/// The step on the cotangent bundle, in configurations and spatial momenta.
class StepOnCotangentBundle {
 public:
  /// @param time  when the step begins
  StepOnCotangentBundle(StepMap const& step, double time, double h, std::vector<CarriedVector> const& carried)
      : step_(step), time_(time), h_(h), carried_(carried) {}

  template <class S>
  Costate<G, S> operator()(Costate<G, S> const& at) const {
    bool const left = step_.system().side == systems::Side::left;
    auto const& g = at.configuration;
    auto const p = left ? Ad_star(g, at.momentum) : at.momentum;
    systems::ReducedPointOver<S> from{
        {p.components.data(), p.components.data() + p.components.size()}, {}, S(time_)};
    auto const mover = left ? inverse(g) : g;
    for (auto const& vector : carried_)
      for (Index i = 0; i < vector.constant.size(); ++i) {
        S sum(0);
        for (Index j = 0; j < vector.constant.size(); ++j) sum += mover.value(i, j) * S(vector.constant[j]);
        from.vectors.push_back(sum);
      }
    auto const done = step_(h_, from);
    Element<G, S> const moved = left ? g * done.motion : done.motion * g;
    Momentum<G, S> after = at.momentum;
    for (std::size_t i = 0; i < from.momentum.size(); ++i)
      after.components[static_cast<Index>(i)] = done.point.momentum[i];
    return {moved, left ? Ad_star(inverse(moved), after) : after};
  }

 private:
  StepMap const& step_;
  double time_, h_;
  std::vector<CarriedVector> const& carried_;
};

/// Translations on the side of the invariance take the point to the identity, and keep the two-form: there
/// the vectors that are fixed are those that are carried now.
double symplectic_defect_now(ReducedScheme const& scheme, double h, ReducedMotion const& motion) {
  StepMap const step(scheme, motion.velocity());
  std::vector<CarriedVector> carried;
  auto const& vectors = motion.point().vectors;
  for (int k = 0; k < scheme.system->vectors; ++k)
    carried.push_back({"", Eigen::Map<Eigen::VectorXd const>(vectors.data() + k * scheme.system->length(),
                                                             scheme.system->length())});
  auto const& list = motion.point().momentum;
  Momentum<G, double> p{step.group(), Coordinates<G, double>(static_cast<Index>(list.size()))};
  for (std::size_t i = 0; i < list.size(); ++i) p.components[static_cast<Index>(i)] = list[i];
  return symplectic_defect(CotangentBundle{}, StepOnCotangentBundle(step, motion.point().time, h, carried),
                           Costate<G, double>{identity<double>(step.group()), p});
}

/// The largest difference of two points.
double apart(systems::ReducedPointOver<double> const& a, systems::ReducedPointOver<double> const& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.momentum.size(); ++i)
    largest = std::max(largest, std::abs(a.momentum[i] - b.momentum[i]));
  for (std::size_t i = 0; i < a.vectors.size(); ++i)
    largest = std::max(largest, std::abs(a.vectors[i] - b.vectors[i]));
  return largest;
}

/// The order shown by a step, its halves and its quarters. Where they differ by less than some thousands of
/// roundings a step twice as long is looked at.
double order_now(ReducedScheme const& scheme, double h, ReducedMotion const& motion) {
  StepMap const step(scheme, motion.velocity());
  auto const start = point_of(motion);
  double size = 0;
  for (double const p : start.momentum) size = std::max(size, std::abs(p));
  for (double const a : start.vectors) size = std::max(size, std::abs(a));
  auto const in_parts = [&](double whole, int parts) {
    auto at = start;
    for (int k = 0; k < parts; ++k) at = step(whole / parts, at).point;
    return at;
  };
  double found = 0;  // where rounding hides it all the way
  for (int doublings = 0; doublings < 12; ++doublings, h *= 2) try {
      auto const halves = in_parts(h, 2);
      double const coarse = apart(in_parts(h, 1), halves), fine = apart(halves, in_parts(h, 4));
      if (!(fine > 1e-12 * size)) continue;
      found = std::log2(coarse / fine);
      break;
    } catch (Error const&) {
      break;
    }
  return found;
}

/// Follows the tangent map of another motion.
class FollowingTangent : public ReducedMotion {
 public:
  FollowingTangent(std::unique_ptr<ReducedMotion> motion, ReducedScheme scheme, double step)
      : motion_(std::move(motion)), scheme_(std::move(scheme)), step_(step) {
    auto const n =
        static_cast<Eigen::Index>(motion_->point().momentum.size() + motion_->point().vectors.size());
    tangent_ = now_ = Eigen::MatrixXd::Identity(n, n);
  }
  void advance(long count) override {
    motion_->look_ahead(0);
    for (long k = 0; k < count; ++k) {
      Eigen::MatrixXd const next = tangent_over(step_) * tangent_;
      motion_->advance(1);
      tangent_ = next;
    }
    now_ = tangent_;
  }
  void look_ahead(double time) override {
    motion_->look_ahead(0);
    now_ = time == 0 ? tangent_ : tangent_over(time) * tangent_;
    motion_->look_ahead(time);
  }
  void change_step(double first, double step, long made) override {
    motion_->look_ahead(0);
    if (first > 0) tangent_ = tangent_over(first) * tangent_;
    motion_->change_step(first, step, made);
    step_ = step, now_ = tangent_;
  }
  void remember(CheckpointStream& stream) override {
    motion_->remember(stream);
    std::span<double> tangent(tangent_.data(), static_cast<std::size_t>(tangent_.size()));
    stream(tangent);
    now_ = tangent_;
  }
  systems::ReducedPoint const& point() const override { return motion_->point(); }
  Eigen::MatrixXd const& configuration() const override { return motion_->configuration(); }
  std::vector<double> const& velocity() const override { return motion_->velocity(); }
  Eigen::MatrixXd const* tangent() const override { return &now_; }

 private:
  Eigen::MatrixXd tangent_over(double h) const {
    StepMap const step(scheme_, motion_->velocity());
    return systems::tangent_of([&](auto const& x) { return step(h, x).point; }, motion_->point());
  }

  std::unique_ptr<ReducedMotion> motion_;
  ReducedScheme scheme_;
  double step_;
  Eigen::MatrixXd tangent_, now_;
};

}  // namespace

void define_instruments(QuantityGraph& graph, ReducedScheme const& scheme, double step,
                        ReducedMotion const& motion) {
  graph.define("poisson_defect", {""}, [scheme, step, &motion](auto, double* out) {
    *out = poisson_defect_now(scheme, step, motion);
  });
  graph.define("leaf_defect", {""},
               [scheme, step, &motion](auto, double* out) { *out = leaf_defect_now(scheme, step, motion); });
  graph.define("symplectic_defect", {""}, [scheme, step, &motion](auto, double* out) {
    *out = symplectic_defect_now(scheme, step, motion);
  });
  graph.define("order", {""},
               [scheme, step, &motion](auto, double* out) { *out = order_now(scheme, step, motion); });
  int const n = scheme.system->dimension() + scheme.system->carried();
  graph.define("tangent_map", column_ends(Quantity::Kind::matrix, n), [&motion, n](auto, double* out) {
    Eigen::Map<Eigen::Matrix<double, -1, -1, Eigen::RowMajor>>(out, n, n) = *motion.tangent();
  });
}

std::unique_ptr<ReducedMotion> following_tangent(std::unique_ptr<ReducedMotion> motion,
                                                 ReducedScheme const& scheme, double step) {
  return std::make_unique<FollowingTangent>(std::move(motion), scheme, step);
}

}  // namespace actio::scene
