// The motion of a medium in the optimised implementation, for one kind of medium.
#pragma once

#include <span>
#include <thread>

#include "actio/fast_media/fast_medium.hpp"
#include "program/base/ranks.hpp"
#include "program/systems/media/laws.hpp"
#include "program/systems/media/optimised_medium.hpp"
#include "program/systems/media/watch.hpp"

namespace actio::scene {

/// The law of a fluid; solids have none.
template <class Medium>
struct FluidLaw {};
/// \copydoc FluidLaw
template <class Volume>
struct FluidLaw<media::FastFluid<Volume>> {
  using type = Volume;  ///< of its Jacobian
};

/// The longest step for which small motions about these places are stable, from above within a per cent.
template <class Medium, class Box>
double longest_step_of(Medium const& medium, Box const& box,
                       std::vector<std::array<double, Box::dimension>> const& x) {
  std::vector<actio::media::detail::VectorOf<Box, double>> places;
  places.reserve(x.size());
  for (auto const& p : x) places.push_back(actio::media::detail::as_vector(p));
  auto const cell = actio::media::detail::cell_on(medium, box.spacing);
  // Of a large box the window around its stiffest part, which is three per cent above at most.
  if (box.count() > (Box::dimension == 2 ? 20000 : 5000))
    return 0.98 * actio::media::detail::bound_of_stable_steps(box, cell, places);
  return 2 / actio::media::detail::largest_frequency(box, cell, places);
}

/// How a medium on a box is computed. Whatever the number of threads and ranks, bits are the same: a large
/// body takes those that there are.
/// @param scene  as a text, for the other ranks
template <class Box>
media::FastOptions fast_options(Box const& box, std::string const& scene) {
  media::FastOptions out;
  int const ranks = on_several_ranks() ? shared_ranks()->size() : 1;
  if (box.count() > (Box::dimension == 2 ? 100000 : 30000))
    out.threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()) / ranks);
  out.ranks = shared_ranks(), out.told = scene;
  return out;
}

/// A medium on a box in the plane or in space.
template <class Medium, class Box>
class FastMotion final : public MediumMotion<Box::dimension> {
 public:
  static constexpr int d = Box::dimension;  ///< of the body, and of space
  using typename MediumMotion<d>::Place;    ///< a point, or a vector

  /// From the start.
  /// @param longest  the longest stable step there
  /// @param scene    as a text, for the other ranks
  FastMotion(Medium const& medium, Box const& box, double density, double step, double longest,
             MediumStart const& start, std::string const& scene)
      : cells_(box),
        scene_(scene),
        density_(density),
        law_(medium),
        watch_(
            step, 128, requires { typename FluidLaw<Medium>::type; }),
        medium_(medium, box, step, density, at(start.placement), at(start.velocity),
                fast_options(box, scene)) {
    watch_.begin(step, *this, longest);
  }

  void advance(long count) override {
    while (count > 0) {
      long const some = std::min(count, watch_.next());
      sound([&] { medium_.step(some); });
      count -= some;
      watch_.made(some, *this, medium_.time(),
                  [this] { return longest_step_of(law_, cells_.box(), medium_.places()); });
    }
  }
  void change_step(double first, double step, long made) override {
    require_stable(step, longest_step_of(law_, cells_.box(), medium_.places()), medium_.time());
    if (first > 0) {
      medium_ = from_here(first);
      medium_.step(1);
    }
    auto last = from_here(step);
    last.go_on_from({last.places(), last.velocities_half_a_step_ago(), made});
    medium_ = std::move(last);
  }
  void remember(CheckpointStream& stream) override {
    if (!stream.reading()) return save(stream);
    auto state = medium_.state();
    std::span<Place> places(state.places), velocities(state.velocities);
    stream(state.steps, places, velocities);
    medium_.go_on_from(state), watch_.begin_anew();
  }
  long steps() const override { return medium_.steps(); }
  MediumCells<d> const& cells() const override { return cells_; }
  std::vector<Place> places() const override { return medium_.places(); }
  std::vector<Place> velocities() const override { return medium_.velocities(); }
  double mass(std::size_t node) const override {
    auto const index = cells_.node_at(node);
    double mass = density_ * cells_.box().measure();
    for (int a = 0; a < d; ++a) mass *= cells_.box().share(a, index[static_cast<std::size_t>(a)]);
    return mass;
  }
  media::BodyEnergies energies() const override {
    auto const [kinetic, stored] = medium_.energies();
    return {kinetic, stored, 0};
  }

 private:
  void show_after(double time) override {
    sound([&] { medium_.look_ahead(time); });
  }
  /// What turns a cell inside out is told with the time.
  template <class Steps>
  void sound(Steps const& steps) {
    try {
      steps();
    } catch (media::CellInverts const& error) {
      end_inside_out(
          error, medium_.time(), requires { typename FluidLaw<Medium>::type; });
    }
  }
  /// One list after the other, so that both are not there at once besides the stream.
  void save(CheckpointStream& stream) const {
    long steps = medium_.steps();
    stream.expect(2 * cells_.nodes() * sizeof(Place) + bytes_of_others);
    stream(steps);
    for (bool const velocity : {false, true}) {
      auto list = velocity ? medium_.velocities_half_a_step_ago() : medium_.places_of_last_step();
      std::span<Place> all(list);
      stream(all);
    }
  }
  /// The medium as it is, with steps of this length.
  media::FastMedium<Medium, Box> from_here(double step) const {
    auto const x = medium_.places(), v = medium_.velocities();
    auto const in_order = [](std::vector<Place> const& all) {
      return [&all, k = std::size_t{0}](Place const&) mutable { return all[k++]; };
    };
    auto place = in_order(x), velocity = in_order(v);
    auto const next = [](auto& of) { return [&of](Place const& X) { return of(X); }; };
    return {
        law_, cells_.box(), step, density_, next(place), next(velocity), fast_options(cells_.box(), scene_)};
  }
  static auto at(PlaceFormula const& formula) {
    return [&formula](Place const& X) {
      Place out;
      formula(X, out.data());
      return out;
    };
  }

  BoxCells<Box> cells_;
  std::string scene_;
  double density_;
  Medium law_;
  StepWatch<d> watch_;
  media::FastMedium<Medium, Box> medium_;
};

/// A medium of the optimised implementation with its box.
template <class Medium, class Box>
class OptimisedMediumOf final : public OptimisedMedium<Box::dimension> {
 public:
  static constexpr int d = Box::dimension;  ///< of the body, and of space

  /// Of this density.
  OptimisedMediumOf(Medium const& medium, Box const& box, double density)
      : medium_(medium), box_(box), density_(density) {}
  double longest_step(std::vector<std::array<double, d>> const& x) const override {
    return longest_step_of(medium_, box_, x);
  }
  std::unique_ptr<MediumMotion<d>> motion(double step, double longest, std::shared_ptr<MediumStart> start,
                                          std::string const& scene) const override {
    return std::make_unique<FastMotion<Medium, Box>>(medium_, box_, density_, step, longest, *start, scene);
  }
  std::unique_ptr<RankPart> part(double step) const override {
    return media::medium_part(medium_, box_, step, fast_options(box_, ""));
  }

 private:
  Medium medium_;
  Box box_;
  double density_;
};
/// Deduces the medium.
template <class Medium, class Box>
std::unique_ptr<OptimisedMedium<Box::dimension>> optimised_medium_of(Medium const& medium, Box const& box,
                                                                     double density) {
  return std::make_unique<OptimisedMediumOf<Medium, Box>>(medium, box, density);
}

}  // namespace actio::scene
