// A medium of a scene in motion, whichever implementation steps it, and its cells.
#pragma once

#include <memory>
#include <optional>

#include "actio/fast_media/fast_strains.hpp"
#include "actio/media_on_meshes/medium_on_mesh.hpp"
#include "program/registry/simulation.hpp"

namespace actio::scene {

/// The cells of a body, as they are looked at: with no memory of their own where they are those of a box.
template <int d>
class MediumCells {
 public:
  using Place = std::array<double, d>;  ///< a point, or a vector
  /// The nodes at the corners of a cell, and how many periods beyond each corner lies: bit k along k.
  struct Cell {
    std::array<int, 8> nodes{};            ///< at the corners
    std::array<unsigned char, 8> wraps{};  ///< of the corners
  };
  virtual ~MediumCells() = default;
  virtual media::BodyMesh::Shape shape() const = 0;        ///< of every cell
  virtual std::size_t nodes() const = 0;                   ///< how many there are
  virtual std::size_t cells() const = 0;                   ///< how many there are
  virtual Place reference(std::size_t node) const = 0;     ///< X of a node, length
  virtual Cell cell(std::size_t number) const = 0;         ///< the corners of one
  virtual double period(int k) const = 0;                  ///< along k, length; 0: none
  virtual std::string name(std::size_t number) const = 0;  ///< of a cell, for messages

  /// Where the corners of a cell are, given the places of all nodes.
  void gather(Cell const& cell, std::vector<Place> const& x, Place (&at)[8]) const {
    for (int b = 0; b < media::corner_count(shape()); ++b) {
      at[b] = x[static_cast<std::size_t>(cell.nodes[static_cast<std::size_t>(b)])];
      beyond(cell, b, at[b]);
    }
  }
  /// Where the corners of a cell are in the reference space.
  void gather_reference(Cell const& cell, Place (&at)[8]) const {
    for (int b = 0; b < media::corner_count(shape()); ++b) {
      at[b] = reference(static_cast<std::size_t>(cell.nodes[static_cast<std::size_t>(b)]));
      beyond(cell, b, at[b]);
    }
  }
  /// How far the corners of a cell are from there, without loss where that is little.
  void gather_displacement(Cell const& cell, std::vector<Place> const& x, Place (&moved)[8]) const {
    for (int b = 0; b < media::corner_count(shape()); ++b) {
      auto const node = static_cast<std::size_t>(cell.nodes[static_cast<std::size_t>(b)]);
      Place const X = reference(node);
      for (int k = 0; k < d; ++k) moved[b][k] = x[node][k] - X[k];
    }
  }
  /// Of a cell: two where those in space are of the unit sphere.
  int dimension() const { return d == 3 && shape() == media::BodyMesh::Shape::quadrilateral ? 2 : d; }
  /// How many deformation gradients a cell has: at each corner of a box-like one, otherwise one.
  int points() const { return media::is_simplex(shape()) || d == 1 ? 1 : media::corner_count(shape()); }
  /// The corners at both ends of edge k of a point of a cell.
  std::array<int, 2> ends(int point, int k) const {
    if (points() == 1) return {0, k + 1};
    return {point & ~(1 << k), point | (1 << k)};
  }
  /// The edges that meet at a point of a cell, as columns; of a cell of the unit sphere the third is the
  /// normal, which is the place.
  Matrix<double, d, d> edges(Place const (&at)[8], int point) const {
    Matrix<double, d, d> out;
    for (int k = 0, flat = dimension(); k < d; ++k) {
      bool const normal = k == flat;
      auto const [low, up] = normal ? std::array{point, point} : ends(point, k);
      for (int i = 0; i < d; ++i) out(i, k) = at[up][i] - (normal ? 0 : at[low][i]);
    }
    return out;
  }
  /// What corners of a cell need besides their edges.
  media::CornerCorrection<double, d> correction(Place const (&from)[8]) const {
    if constexpr (d == 3)
      if (shape() == media::BodyMesh::Shape::hexahedron) {
        Matrix<double, 3, 8> places;
        for (int b = 0; b < 8; ++b)
          for (int a = 0; a < 3; ++a) places(a, b) = from[b][a];
        return media::corner_correction<double, 3>(places);
      }
    return {};
  }
  /// What places or velocities of corners add by it to the deformation gradients at all points of a cell.
  static Matrix<double, d, d> common(media::CornerCorrection<double, d> const& of, Place const (&at)[8]) {
    return of.template common<double, d>([&](int b, int a) { return at[b][a]; });
  }
  /// The part of a cell that a point stands for, over the determinant of its edges, without a correction.
  double share() const {
    if (points() > 1) return 1.0 / points();
    return d == 1 ? 1 : d == 2 ? 0.5 : 1.0 / 6;
  }

 private:
  void beyond(Cell const& cell, int b, Place& at) const {
    for (int k = 0; k < d; ++k)
      if (cell.wraps[static_cast<std::size_t>(b)] >> k & 1) at[k] += period(k);
  }
};

/// The least Jacobian of a placement, and the cell that has it; a NaN is the least.
template <int d>
std::pair<double, std::size_t> least_jacobian(MediumCells<d> const& cells,
                                              std::vector<typename MediumCells<d>::Place> const& x) {
  std::pair<double, std::size_t> least{HUGE_VAL, 0};
  std::array<double, d> at[8], from[8];
  for (std::size_t c = 0; c < cells.cells(); ++c) {
    auto const cell = cells.cell(c);
    cells.gather(cell, x, at), cells.gather_reference(cell, from);
    auto const correction = cells.correction(from);
    for (int p = 0; p < cells.points(); ++p) {
      Matrix<double, d, d> const A = cells.edges(from, p);
      Matrix<double, d, d> a = cells.edges(at, p);
      if (correction.any) a += cells.common(correction, at) * A;
      double const J = media::small_determinant(a) / media::small_determinant(A);
      if (!(J >= least.first)) least = {J, c};
      if (!(J == J)) return least;
    }
  }
  return least;
}

/// Room in a checkpoint for what a run remembers besides places and velocities: the list of numbers would be
/// copied for them.
inline constexpr std::size_t bytes_of_others = 1 << 16;

/// The motion of a medium.
template <int d>
class MediumMotion : public Motion {
 public:
  using Place = std::array<double, d>;     ///< a point, or a vector
  virtual long steps() const = 0;          ///< that were made
  double ahead() const { return ahead_; }  ///< of the last step, time
  /// Until the next step the state is that so long after the last one, which one shorter step reaches.
  void look_ahead(double time) final { show_after(time), ahead_ = time; }
  virtual MediumCells<d> const& cells() const = 0;    ///< of the body
  virtual std::vector<Place> places() const = 0;      ///< of the nodes, length
  virtual std::vector<Place> velocities() const = 0;  ///< of the nodes, length/time
  virtual double mass(std::size_t node) const = 0;    ///< of a node
  virtual media::BodyEnergies energies() const = 0;   ///< now
  virtual double dissipated() const { return 0; }     ///< by viscosity, energy
  /// The largest strains of its cells at the last step, where steps find them faster than from their nodes.
  virtual std::optional<media::Strains> strains() const { return {}; }
  /// The pressure of each cell beyond that of the stored energy, the multiplier of its volume; none where
  /// volumes are not kept.
  virtual std::vector<double> multipliers() const { return {}; }
  virtual bool has_multipliers() const { return false; }  ///< whether there are any

 private:
  virtual void show_after(double time) = 0;  // since the last step; 0: the last step itself
  double ahead_ = 0;
};

/// A step that would turn a cell inside out, or is not found, ends the run: it is told with the time, and of
/// a fluid why that is to be expected.
[[noreturn]] inline void end_inside_out(Error const& error, double time, bool fluid) {
  throw Error(std::string(error.what()) + "; the state is that at t = " + show(time) +
              (fluid ? ": a fluid resists no shear, and cells that are sheared for long tangle" : ""));
}

/// That steps from a state can have this length: near the bound waves grow by what is not linear in them.
/// @param longest  the longest stable step there
/// @throws Error  with both, and the time of the state
inline void require_stable(double step, double longest, double time) {
  if (!(step <= 0.9 * longest))
    throw Error("medium: the longest stable step at t = " + show(time) + " is " + show(longest) +
                ", of which nine tenths are safe, and " + show(step) + " is longer");
}

/// The cells of a mesh.
template <int d>
class MeshCells final : public MediumCells<d> {
 public:
  /// @param mesh  outlives it
  explicit MeshCells(media::BodyMesh const& mesh) : mesh_(mesh) {}
  media::BodyMesh::Shape shape() const override { return mesh_.shape; }
  std::size_t nodes() const override { return mesh_.nodes.size(); }
  std::size_t cells() const override { return mesh_.cells.size(); }
  std::array<double, d> reference(std::size_t node) const override {
    std::array<double, d> X;
    for (int k = 0; k < d; ++k) X[k] = mesh_.nodes[node][k];
    return X;
  }
  typename MediumCells<d>::Cell cell(std::size_t number) const override {
    typename MediumCells<d>::Cell out{mesh_.cells[number], {}};
    if (!mesh_.wraps.empty()) out.wraps = mesh_.wraps[number];
    return out;
  }
  double period(int k) const override { return mesh_.periods[static_cast<std::size_t>(k)]; }
  std::string name(std::size_t number) const override { return mesh_.cell_name(static_cast<int>(number)); }

 private:
  media::BodyMesh const& mesh_;
};

}  // namespace actio::scene
