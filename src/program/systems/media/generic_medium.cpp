#include "program/systems/media/generic_medium.hpp"

#include "program/base/ranks.hpp"
#include "program/systems/media/walls.hpp"
#include "program/systems/media/watch.hpp"

namespace actio::scene {
namespace {

/// A medium on a mesh.
template <int d>
class MeshMotion final : public MotionOnMesh<d> {
 public:
  using typename MediumMotion<d>::Place;

  explicit MeshMotion(GenericMedium<d>& medium)
      : medium_(std::move(medium.mesh), stored_energy_of<d>(medium.material), start_of<d>(medium.start),
                medium.stepping(), medium.loads.sides, medium.loads.loads, shared_ranks(), medium.scene),
        cells_(medium_.mesh()),
        fluid_(is_fluid(medium.material) && d > 1),
        conserves_form_(medium.conserve == media::Conserve::form),
        watch_(1, 32, fluid_, conserves_form_),
        walls_(medium.loads, medium_.mesh(), medium_.places()) {}

  void begin(double step, double longest) override {
    medium_.set_time_step(step);
    watch_.begin(step, *this, longest);
  }

  void advance(long count) override {
    while (count > 0) {
      long const some = std::min(count, walls_.any() ? 1 : watch_.next());
      sound([&] { medium_.step(some); });
      count -= some;
      if (walls_.any()) walls_.look(medium_.places(), medium_.time_step(), medium_.time());
      watch_.made(some, *this, medium_.time(), [this] { return medium_.largest_step_of_waves(); });
    }
  }
  void change_step(double first, double step, long made) override {
    if (conserves_form_) require_stable(step, medium_.largest_step(), medium_.time());
    medium_.change_step(first, step, made);
  }
  void remember(CheckpointStream& stream) override {
    if (!stream.reading()) return save(stream);
    std::vector<double> state(medium_.numbers_of_state());
    stream(state);
    medium_.restore(state), walls_.begin(medium_.places()), watch_.begin_anew();
  }
  long steps() const override { return medium_.steps(); }
  MediumCells<d> const& cells() const override { return cells_; }
  std::vector<Place> places() const override { return medium_.places(); }
  std::vector<Place> velocities() const override { return medium_.velocities(); }
  double mass(std::size_t node) const override { return medium_.masses()[node]; }
  media::BodyEnergies energies() const override { return medium_.energies(); }
  double dissipated() const override { return medium_.dissipated(); }
  double longest_step() const override { return medium_.largest_step_of_waves(); }
  double longest_in_one_part() const override { return medium_.largest_step_of_viscosity(); }

 private:
  void show_after(double time) override {
    sound([&] { medium_.look_ahead(time); });
  }
  /// What turns a cell inside out, or is not solved, is told with the time.
  template <class Steps>
  void sound(Steps const& steps) {
    try {
      steps();
    } catch (media::BodyCellInverts const& error) {
      end_inside_out(error, medium_.time(), fluid_);
    } catch (media::BodyStepUnsolved const& error) {
      end_inside_out(error, medium_.time(), fluid_);
    }
  }
  /// As a list, but a part of it at a time.
  void save(CheckpointStream& stream) const {
    std::size_t size = medium_.numbers_of_state();
    stream.expect(size * sizeof(double) + bytes_of_others);
    stream(size);
    medium_.for_remembered([&](double const* from, std::size_t count) {
      for (std::size_t k = 0; k < count; ++k) {
        double one = from[k];
        stream(one);
      }
    });
  }

  media::MediumOnMesh<d> medium_;
  MeshCells<d> cells_;
  bool fluid_;  // nothing resists shear
  bool conserves_form_;
  StepWatch<d> watch_;
  WallWatch<d> walls_;
};

}  // namespace

template <int d>
std::unique_ptr<MotionOnMesh<d>> GenericMedium<d>::motion() { return std::make_unique<MeshMotion<d>>(*this); }

template <int d>
std::unique_ptr<RankPart> GenericMedium<d>::part() const {
  return std::make_unique<media::BodyOnRank<d>>(*shared_ranks(), scene, mesh, stored_energy_of<d>(material),
                                                start_of<d>(start).density, stepping(), loads.sides,
                                                loads.loads);
}

/// Along a line.
template struct GenericMedium<1>;
/// In the plane.
template struct GenericMedium<2>;
/// In space.
template struct GenericMedium<3>;

}  // namespace actio::scene
