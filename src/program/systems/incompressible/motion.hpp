// The motion of an incompressible medium of a scene.
#pragma once

#include "actio/incompressible_media/incompressible_medium.hpp"
#include "actio/incompressible_media/incompressible_sphere.hpp"
#include "program/medium_output/motion.hpp"

namespace actio::scene {

/// An incompressible medium on a mesh.
/// @tparam Medium  `IncompressibleMedium`, or `IncompressibleSphere`
template <class Medium>
class IncompressibleSteps final : public MediumMotion<Medium::N> {
 public:
  static constexpr int d = Medium::N;     ///< components of a place
  using typename MediumMotion<d>::Place;  ///< a point, or a vector

  /// @param medium  ready to be stepped
  explicit IncompressibleSteps(std::unique_ptr<Medium> medium)
      : medium_(std::move(medium)), cells_(medium_->mesh()) {}

  /// The medium, which its quantities look at.
  Medium& medium() const { return *medium_; }

  void advance(long count) override {
    sound([&] { medium_->step(count); });
  }
  void change_step(double first, double step, long made) override {
    sound([&] { medium_->change_step(first, step, made); });
  }
  void remember(CheckpointStream& stream) override {
    auto state = stream.reading() ? std::vector<double>{} : medium_->remember();
    stream(state);
    if (stream.reading()) medium_->restore(state);
  }
  long steps() const override { return medium_->steps(); }
  MediumCells<d> const& cells() const override { return cells_; }
  std::vector<Place> places() const override { return medium_->places(); }
  std::vector<Place> velocities() const override { return medium_->velocities(); }
  double mass(std::size_t node) const override { return medium_->masses()[node]; }
  media::BodyEnergies energies() const override {
    if constexpr (requires(Medium& one) { one.energies(); })
      return medium_->energies();
    else
      return {medium_->kinetic_energy(), 0, 0};
  }
  bool has_multipliers() const override { return true; }
  std::vector<double> multipliers() const override {
    std::vector<double> out;
    sound([&] { out = medium_->pressures(); });
    return out;
  }

 private:
  std::unique_ptr<Medium> medium_;
  MeshCells<d> cells_;

  void show_after(double time) override {
    sound([&] { medium_->look_ahead(time); });
  }
  /// What cannot go on is told with the time.
  template <class Steps>
  void sound(Steps const& steps) const {
    try {
      steps();
    } catch (media::CellFolds const& error) {
      throw Error(std::string(error.what()) + "; the state is that at t = " + show(medium_->time()));
    } catch (media::VolumesUnsolved const& error) {
      throw Error(std::string(error.what()) + "; the state is that at t = " + show(medium_->time()));
    } catch (media::BodyCellInverts const& error) {
      throw Error(std::string(error.what()) + "; the state is that at t = " + show(medium_->time()));
    }
  }
};

}  // namespace actio::scene
