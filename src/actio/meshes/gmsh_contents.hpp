// What a Gmsh file says: nodes, elements, and the names of groups; and how one node or element is read.
#pragma once

#include <array>
#include <map>
#include <vector>

#include "actio/meshes/gmsh_cursor.hpp"

namespace actio::media {

/// A kind of elements that is understood.
struct GmshShape {
  int type;          ///< its number in the file
  int dimension;     ///< 0 to 3
  int corners;       ///< how many nodes
  char const* name;  ///< for messages
};

/// An element of a file.
struct GmshElement {
  GmshShape const* shape;    ///< point, line, triangle, quadrangle, tetrahedron or hexahedron
  std::size_t tag;           ///< its number in the file
  std::array<int, 8> nodes;  ///< their tags, in the order of the file
  int groups;                ///< which list of groups it belongs to, or -1
  std::size_t byte;          ///< where in the file it stands
};

/// A node of a file.
struct GmshNode {
  int tag;                      ///< its number in the file, above 0
  std::array<double, 3> place;  ///< coordinates
  std::size_t byte;             ///< where in the file it stands
};

/// The contents of a file.
struct GmshContents {
  std::vector<GmshNode> nodes;                       ///< in the order of the file
  std::vector<GmshElement> elements;                 ///< in the order of the file
  std::vector<std::vector<int>> groups;              ///< lists of physical tags
  std::map<std::pair<int, int>, std::string> names;  ///< of groups, by dimension and physical tag
};

/// The shape with this number.
/// @throws NotAGmshFile  where it is not among those that are understood; the message names it
GmshShape const& gmsh_shape(GmshCursor const& file, int type);

namespace detail {

/// Reads what all versions have in common.
class GmshReader {
 public:
  GmshReader(std::string_view text, std::string const& name) : file_(text, name) {}
  /// For messages about elements when all has been read.
  GmshCursor const& file() const { return file_; }

 protected:
  GmshCursor file_;
  GmshContents contents_;
  std::map<std::pair<int, int>, int> groups_;  // of an entity (4), or a group by itself (2)

  int new_list(std::vector<int> tags) {
    contents_.groups.push_back(std::move(tags));
    return int(contents_.groups.size()) - 1;
  }
  template <class T>
  void read_element(GmshShape const& shape, std::size_t number, int groups) {
    GmshElement element{&shape, number, {}, groups, file_.at()};
    for (int k = 0; k < shape.corners; ++k) element.nodes[k] = tag<T>("node of an element");
    contents_.elements.push_back(element);
  }
  template <class T>
  void read_tag_of_node() {
    contents_.nodes.push_back({tag<T>("node"), {}, 0});
    contents_.nodes.back().byte = file_.last();
  }
  /// The place of a node, and as many parameters after it.
  void read_place(GmshNode& node, int parameters) {
    for (double& x : node.place) x = file_.number<double>("a coordinate of a node");
    for (; parameters > 0; --parameters) file_.number<double>("a parameter of a node");
  }
  template <class T>
  int tag(char const* what) {
    T const value = file_.number<T>(what);
    if (value < 1 || value > T(std::numeric_limits<int>::max())) fail_tag(what, std::to_string(value));
    return int(value);
  }

 private:
  [[noreturn]] void fail_tag(std::string const& what, std::string const& value) const {
    file_.fail("the tag of a " + what + " lies between 1 and 2^31, and is " + value);
  }
};

}  // namespace detail
}  // namespace actio::media
