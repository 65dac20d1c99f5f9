#include "actio/scene/systems/medium_mesh_road.hpp"

#include "actio/scene/systems/medium_walls.hpp"
#include "actio/scene/systems/medium_watch.hpp"

namespace actio::scene {
namespace {

template <int d>
BodyStart<d> start_of(std::shared_ptr<MediumStart> const& start) {
  using Place = std::array<double, d>;
  return {[start](Place const& X) {
    double rho = 0;
    start->density(X, &rho);
    return rho;
          },
          [start](Place const& X) {
    Place out;
    start->placement(X, out.data());
    return out;
  },
      [start](Place const& X) {
    Place out;
    start->velocity(X, out.data());
    return out;
      }};
}

/// A medium on a mesh.
template <int d>
class MeshMotion final : public MediumMotion<d> {
 public:
  using typename MediumMotion<d>::Place;

  MeshMotion(MeshRoad<d> const& road, double step)
      : medium_(road.mesh, stored_energy_of<d>(road.material), start_of<d>(road.start),
                {step, road.order, road.conserve, road.viscosity}, road.loads.sides, road.loads.loads),
        cells_(medium_.mesh()),
        fluid_(road.material.record->fluid),
        watch_(step, 32, fluid_, road.conserve == Conserve::form),
        walls_(road.loads, road.mesh, medium_.places()) {}

  void advance(long count) override {
    while (count > 0) {
      long const some = std::min(count, walls_.any() ? 1 : watch_.next());
      try {
        medium_.step(some);
      } catch (BodyCellInverts const& error) {
        end_inside_out(error, medium_.time(), fluid_);
      }
      count -= some;
      if (walls_.any()) walls_.look(medium_.places(), medium_.time_step(), medium_.time());
      watch_.made(some, *this, medium_.time(), [this] { return medium_.largest_step(); });
    }
  }
  void remember(CheckpointStream& stream) override {
    auto state = medium_.remember();
    stream(state);
    if (!stream.reading()) return;
    medium_.restore(state), walls_.begin(medium_.places()), watch_.begin_anew();
  }
  long steps() const override { return medium_.steps(); }
  MediumCells<d> const& cells() const override { return cells_; }
  std::vector<Place> places() const override { return medium_.places(); }
  std::vector<Place> velocities() const override { return medium_.velocities(); }
  double mass(std::size_t node) const override { return medium_.masses()[node]; }
  BodyEnergies energies() const override { return medium_.energies(); }
  double dissipated() const override { return medium_.dissipated(); }
  double longest_step() const { return medium_.largest_step(); }

 private:
  MediumOnMesh<d> medium_;
  MeshCells<d> cells_;
  bool fluid_;
  StepWatch<d> watch_;
  WallWatch<d> walls_;
};

}  // namespace

template <int d>
double MeshRoad<d>::longest_step() const {
  return MeshMotion<d>(*this, 1).longest_step();
}
template <int d>
std::unique_ptr<MediumMotion<d>> MeshRoad<d>::motion(double step) const {
  return std::make_unique<MeshMotion<d>>(*this, step);
}

/// Along a line.
template struct MeshRoad<1>;
/// In the plane.
template struct MeshRoad<2>;
/// In space.
template struct MeshRoad<3>;

}  // namespace actio::scene
