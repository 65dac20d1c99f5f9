// What an incompressible medium refuses: starts that change volumes, and cells that fold.
#pragma once

#include <algorithm>

#include "actio/incompressible_media/volume_steps.hpp"

namespace actio::media {

/// A cell of an incompressible medium that would fold: its volume is kept, and a corner of it turns inside
/// out. The state is that before the step.
struct CellFolds : OutsideDomain {
  int cell;     ///< which
  int corner;   ///< of it
  double time;  ///< when it would, on the straight way of the step
  /// @param name  of the cell, for messages
  CellFolds(int which, int at, std::string const& name, double when, double jacobian)
      : OutsideDomain(
            "incompressible medium: corner " + std::to_string(at) + " of " + name + ", t = " + show(when),
            "a cell is not sheared so far that it folds, although its volume is kept; Jacobian at the "
            "corner after the step",
            jacobian, 0),
        cell(which),
        corner(at),
        time(when) {}
};

/// An incompressible medium whose start changes volumes.
struct StartChangesVolumes : OutsideDomain {
  bool placement;  ///< whether its placement does; if not its velocity
  /// As \ref OutsideDomain.
  StartChangesVolumes(bool by_placement, std::string const& where, std::string const& required, double was,
                      double allowed)
      : OutsideDomain(where, required, was, allowed), placement(by_placement) {}
};

/// Refuses a placement, with the cell that is off most.
/// @param r      what volumes are off by
/// @param bound  of A/A^0 - 1
template <class Cell>
[[noreturn]] void refuse_placement(BodyMesh const& mesh, VolumeSteps<Cell> const& of,
                                   std::vector<double> const& r, double bound) {
  std::size_t worst = 0;
  auto const off = [&](std::size_t k) { return std::abs(r[k]) / of.kept[k]; };
  for (std::size_t k = 0; k < r.size(); ++k)
    if (!(off(k) <= off(worst))) worst = k;
  throw StartChangesVolumes(
      true, "incompressible medium: " + mesh.cell_name(static_cast<int>(worst)),
      "the placement keeps the volume of each cell; A/A0 - 1 (project = true takes that "
      "from it)",
      off(worst), bound);
}

/// Refuses velocities that change a volume: the largest |G v| over what the fastest of them could do to the
/// cell.
/// @param whole  slopes without the projection of held nodes
/// @throws StartChangesVolumes
template <class Cell>
void require_volumes_kept(VolumeSteps<Cell> const& of, std::vector<double> const& whole,
                          std::vector<double> const& v, double bound) {
  constexpr std::size_t N = Cell::space, numbers = Cell::corners * N;
  std::vector<double> rates;
  of.volumes.rates(whole, v, rates, of.volumes.all());
  double speed = 0, most = 0;
  for (std::size_t k = 0; k < v.size(); k += N) {
    double square = 0;
    for (std::size_t a = 0; a < N; ++a) square += v[k + a] * v[k + a];
    speed = std::max(speed, std::sqrt(square));
  }
  if (speed == 0) return;
  for (std::size_t cell = 0; cell < rates.size(); ++cell) {
    double sum = 0;
    for (std::size_t k = 0; k < numbers; ++k) sum += std::abs(whole[cell * numbers + k]);
    most = std::max(most, std::abs(rates[cell]) / (sum * speed));
  }
  if (!(most <= bound))
    throw StartChangesVolumes(
        false, "incompressible medium",
        "a velocity changes no volume at the start, or what does is to be taken from it "
        "(project = true); the rate of a volume over what that speed could do",
        most, bound);
}

/// The way of a step.
struct StraightWay {
  std::vector<double> const& from;  ///< places at its start
  std::vector<double> const& to;    ///< and at its end
  double start;                     ///< when it begins
  double length;                    ///< how long it takes
};
/// Refuses the end of a way where a corner is inside out, with the time at which it turned. The way is that
/// of the whole mesh.
/// @param reference  the Jacobians at all corners in the reference
/// @throws CellFolds
template <class Cell>
void refuse_folds(BodyMesh const& mesh, MeshVolumes<Cell> const& volumes,
                  std::vector<double> const& reference, StraightWay const& way) {
  auto const J = volumes.corner_jacobians(way.to);
  auto const worst = static_cast<std::size_t>(std::min_element(J.begin(), J.end()) - J.begin());
  if (J[worst] > 0) return;
  double low = 0, high = 1;
  std::vector<double> y = way.to;
  for (int k = 0; k < 40; ++k) {
    double const middle = 0.5 * (low + high);
    for (std::size_t i = 0; i < y.size(); ++i) y[i] = way.from[i] + middle * (way.to[i] - way.from[i]);
    (volumes.corner_jacobians(y)[worst] > 0 ? low : high) = middle;
  }
  int const cell = static_cast<int>(worst) / Cell::corners;
  throw CellFolds(cell, static_cast<int>(worst) % Cell::corners, mesh.cell_name(cell),
                  way.start + high * way.length, J[worst] / reference[worst]);
}

}  // namespace actio::media
