// The mesh of a body from a file of Gmsh: version 2 or 4, in digits or in bytes.
//
// The elements of the highest dimension are the cells: segments, triangles, quadrilaterals, tetrahedra or
// hexahedra, of one kind. One that is listed for each of its groups is one cell, and one that is numbered
// against the orientation of the body is turned. Elements of one dimension less that are in a physical group
// are facets of a side with the name of the group, or with its number where it has no name. All other
// elements, and nodes that are no corner of a cell (centres of arcs), are left.
#pragma once

#include <filesystem>
#include <fstream>
#include <numeric>

#include "actio/meshes/body_mesh_check.hpp"
#include "actio/meshes/gmsh_file.hpp"

namespace actio::media {

namespace detail {

/// Makes a mesh of the contents of a file.
class GmshBody {
 public:
  GmshBody(std::string_view text, std::string const& name) : sections_(text, name), in_(sections_.read()) {}

  BodyMesh mesh();

 private:
  GmshSections sections_;
  GmshContents in_;
  BodyMesh mesh_;
  std::vector<GmshElement const*> cells_;
  std::vector<int> by_tag_;  // numbers of the nodes of the file, by increasing tag
  std::vector<int> number_;  // of each node of the file in the mesh, or -1

  [[noreturn]] void fail_at(GmshElement const& element, std::string const& what) const {
    sections_.file().fail_at(element.byte, what);
  }

  void choose_cells();

  // Of elements with the same nodes the first one stays.
  void leave_repeated();
  // Exchanges two directions of a cell whose corners have a negative volume in all: the order of corners says
  // nothing of a body.
  void orient(int cell);

  void number_nodes();
  // The number in the file of the node with a tag.
  int node_with(int tag, GmshElement const& element) const;
  // Corners go around in the file and by bits here.
  std::array<int, 8> corners(GmshElement const& element) const;
  // Leaves the nodes that are no corners, and numbers the others in the order of the file.
  void keep_corners();

  // A facet of a file: its nodes in increasing order, the element, and the cells that have it.
  struct Facet {
    std::array<int, 4> nodes;
    GmshElement const* element;
    bool turned = false;  // as is_turned says
    int cells = 0;
    CellFacet at{};
  };
  std::vector<Facet> facets_in_groups() const;
  void add_sides();
  std::string name_of_group(int group) const {
    auto const named = in_.names.find({mesh_.dimension - 1, std::abs(group)});
    return named == in_.names.end() ? std::to_string(std::abs(group)) : named->second;
  }
  void add_to(std::string const& name, Facet const& facet);
};

}  // namespace detail

/// The mesh of a body from the text of a Gmsh file.
///
/// \snippet media.cpp gmsh_mesh_of
/// @param text  all of it
/// @param name  of the file, for messages
/// @throws NotAGmshFile  where the text is no mesh: with the line, or in a binary file the byte; where cells
///         are degenerate, folded over each other or unconnected; where nodes are missing or come twice;
///         where kinds of elements are unknown or mixed
/// Memory: bounded by a multiple of the size of the text, whatever counts it announces.
inline BodyMesh gmsh_mesh_of(std::string_view text, std::string const& name) {
  return detail::GmshBody(text, name).mesh();
}

/// The mesh of a body from a Gmsh file.
/// @throws Error  where the file cannot be read; and as \ref gmsh_mesh_of
BodyMesh gmsh_mesh(std::string const& path);

}  // namespace actio::media
