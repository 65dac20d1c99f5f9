// A medium as the page and the pictures of a run show it: coloured faces that move, their outline, and what
// the colours mean. In space they are the surface of the body.
//
// A mesh of more cells than can be drawn is coarsened: nodes that lie together in the reference space become
// one, the one where sides meet before those of a side, these before those inside. The coarse mesh has about
// the shape of the body, and its faces have the colours of some of the cells.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace actio::scene {

/// Faces of a medium over time.
struct PlayedMedium {
  /// A field that colours can show.
  struct Field {
    std::string name;                         ///< in words: "energy density"
    std::vector<std::vector<double>> values;  ///< of each face, at each time
    double lowest() const;                    ///< of all of them
    double highest() const;                   ///< \copydoc lowest
  };
  using Point = std::array<double, 3>;  ///< the last number is zero in the plane

  int dimension = 2;                        ///< 2: faces in the plane; 3: those of a body in space
  std::vector<double> times;                ///< of the snapshots that are shown
  std::size_t snapshots = 0;                ///< that there are
  std::size_t cells = 0;                    ///< faces that there were before they were coarsened
  std::vector<std::array<int, 4>> faces;    ///< points, counterclockwise; the last twice in a triangle
  std::vector<std::array<int, 2>> outline;  ///< points at both ends of its pieces
  std::vector<std::vector<Point>> places;   ///< of the points, at each time
  std::vector<Field> fields;                ///< none of them empty

  /// The corners of a box that holds all places.
  std::array<Point, 2> box() const;
};

/// What of a mesh is drawn.
struct DrawnMesh {
  /// A face, the number of its cell, and its points.
  struct Face {
    std::array<int, 4> points;  ///< the last twice in a triangle
    std::size_t cell;           ///< that it belongs to
  };
  int dimension = 2;                        ///< of the mesh
  std::vector<PlayedMedium::Point> points;  ///< in the reference space
  std::vector<int> nodes;                   ///< of the points: those at a seam have the same
  std::vector<Face> faces;                  ///< of the plane; or the surface
  std::vector<std::array<int, 2>> outline;  ///< without seams; of a surface its edges

  /// Of a mesh.
  /// @param dimension  2 or 3
  /// @param corners    points of all cells, each as VTK counts them
  /// @param each       how many a cell has: 3 or 4 in the plane, 4 or 8 in space
  static DrawnMesh of(int dimension, std::vector<PlayedMedium::Point> points, std::vector<int> nodes,
                      std::vector<std::int64_t> const& corners, std::size_t each);
  /// With at most so many faces.
  DrawnMesh coarsened(std::size_t most_faces) const;
};

/// The frames that are shown, of so many, and the faces: as much as a page can carry.
struct PlayedSize {
  std::size_t frames;  ///< at most
  std::size_t faces;   ///< at most
  /// Bytes of a page, before they are written as text.
  static constexpr std::size_t most_bytes = 2'000'000;
  /// There are never more faces: so many a browser paints for each picture of the screen.
  static constexpr std::size_t most_faces = 15'000;
  /// @param frames     that there are
  /// @param faces      that there are
  /// @param dimension  2 or 3
  /// @param fields     that colours can show
  static PlayedSize of(std::size_t frames, std::size_t faces, int dimension, std::size_t fields);
};

/// As the page has it: numbers as bytes in base64. `null` where there are fewer than two frames.
std::string medium_json(PlayedMedium const& medium);
/// A picture of some frames, the first and the last among them, coloured by the first field that varies.
/// @param unit  of time; empty where it is not known
std::string medium_picture(PlayedMedium const& medium, double width, std::string const& unit);
/// A picture that moves by itself, over and over, with the outline at some times left behind as a trace: an
/// SVG of at most about half a megabyte, which needs no script. Where less motion is wished for it stands
/// still. Empty where there are fewer than eight snapshots, or more faces than it could carry.
std::string medium_film(PlayedMedium const& medium, double width, std::string const& title);

}  // namespace actio::scene
