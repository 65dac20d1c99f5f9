// What a Gmsh file says, version 4.1 or 2.2, in digits or in bytes: nodes, elements, and the names of groups.
//
// In version 4.1 nodes and elements come in blocks, each on an entity of the geometry, and the entity knows
// its physical groups. In version 2.2 each element names its group. Here both become one list.
#pragma once

#include <array>
#include <map>
#include <vector>

#include "actio/multisymplectic/gmsh_cursor.hpp"

namespace actio {

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
inline GmshShape const& gmsh_shape(GmshCursor const& file, int type) {
  static constexpr GmshShape known[] = {{15, 0, 1, "point"},      {1, 1, 2, "line"},
                                        {2, 2, 3, "triangle"},    {3, 2, 4, "quadrangle"},
                                        {4, 3, 4, "tetrahedron"}, {5, 3, 8, "hexahedron"}};
  for (auto const& shape : known)
    if (shape.type == type) return shape;
  std::string const what = type == 6   ? " (a prism)"
                           : type == 7 ? " (a pyramid)"
                           : type >= 8 && type <= 14
                               ? " (of second order: ask Gmsh for Mesh.ElementOrder = 1)"
                               : "";
  file.fail(
      "elements of type " + std::to_string(type) + what +
      " are unknown here; known are point (15), line (1), triangle (2), quadrangle (3), tetrahedron (4) "
      "and hexahedron (5)");
}

namespace detail {

/// Reads the sections of a file one after the other.
class GmshSections {
 public:
  GmshSections(std::string_view text, std::string const& name) : file_(text, name) {}

  GmshContents read() {
    read_format();
    bool nodes = false, elements = false;
    while (!file_.done()) {
      std::string const section(file_.word("a section"));
      if (section[0] != '$') file_.fail("a section begins with $");
      if (file_.binary) file_.line();
      if (section == "$Nodes") {
        version_ == 4.1 ? read_nodes_in_blocks() : read_nodes(), nodes = true;
      } else if (section == "$Elements") {
        version_ == 4.1 ? read_elements_in_blocks() : read_elements(), elements = true;
      } else if (section == "$PhysicalNames") {
        read_names();
      } else if (section == "$Entities") {
        read_entities();
      } else if (section == "$Periodic" || section == "$PartitionedEntities") {
        file_.fail(section + ": only meshes in one part and without periodic sides are read");
      } else if (!file_.pass("$End" + section.substr(1))) {
        file_.fail("the section " + section + " has no end");
      } else {
        continue;
      }
      file_.expect("$End" + section.substr(1));
    }
    if (!nodes) file_.fail_at(file_.at(), "the file has no section $Nodes");
    if (!elements) file_.fail_at(file_.at(), "the file has no section $Elements");
    return std::move(contents_);
  }
  /// For messages about elements when all has been read.
  GmshCursor const& file() const { return file_; }

 private:
  GmshCursor file_;
  GmshContents contents_;
  double version_ = 0;
  std::map<std::pair<int, int>, int> groups_;  // of an entity (4.1), or a group by itself (2.2)

  void read_format() {
    file_.expect("$MeshFormat");
    version_ = file_.in_digits<double>("the version");
    if (version_ != 4.1 && version_ != 2.2)
      file_.fail("version " + show(version_) + " of the format is not read; save as 4.1 or 2.2");
    int const kind = file_.in_digits<int>("0 for text or 1 for bytes");
    if (kind != 0 && kind != 1) file_.fail("text is 0 and bytes are 1, not " + std::to_string(kind));
    if (file_.in_digits<int>("the size of numbers") != 8) file_.fail("numbers have 8 bytes");
    if (kind == 1) {
      file_.line();
      file_.binary = true;
      if (file_.number<int>("the number one") != 1)
        file_.fail("the number one does not read as one: the bytes of numbers are in another order");
    }
    file_.expect("$EndMeshFormat");
  }

  void read_names() {
    for (int left = file_.in_digits<int>("how many names there are"); left > 0; --left) {
      int const dimension = file_.in_digits<int>("the dimension of a group");
      int const tag = file_.in_digits<int>("the tag of a group");
      contents_.names[{dimension, tag}] = file_.quoted();
    }
  }

  // Physical tags of the entities of each dimension.
  void read_entities() {
    std::array<std::size_t, 4> count;
    for (auto& n : count) n = file_.number<std::size_t>("how many entities there are");
    for (int dimension = 0; dimension < 4; ++dimension)
      for (std::size_t k = 0; k < count[dimension]; ++k) {
        int const tag = file_.number<int>("the tag of an entity");
        // A point has its place, others have two corners of a box around them.
        for (int i = 0; i < (dimension ? 6 : 3); ++i) file_.number<double>("a coordinate of an entity");
        auto const several = file_.number<std::size_t>("how many groups an entity is in");
        std::vector<int> tags(file_.checked(several, 1, 4, "groups of an entity"));
        for (int& group : tags) group = file_.number<int>("the tag of a group");
        groups_[{dimension, tag}] = new_list(std::move(tags));
        if (dimension == 0) continue;
        auto const bounds = file_.number<std::size_t>("how many entities bound an entity");
        for (auto left = file_.checked(bounds, 1, 4, "bounds of an entity"); left > 0; --left)
          file_.number<int>("the tag of a bound");
      }
  }
  int new_list(std::vector<int> tags) {
    contents_.groups.push_back(std::move(tags));
    return int(contents_.groups.size()) - 1;
  }

  void read_nodes_in_blocks() {
    auto const blocks = file_.number<std::size_t>("how many blocks of nodes there are");
    auto const all = file_.number<std::size_t>("how many nodes there are");
    file_.number<std::size_t>("the smallest tag of a node"), file_.number<std::size_t>("the largest one");
    contents_.nodes.reserve(file_.checked(all, 4, 32, "nodes"));
    for (std::size_t block = 0; block < blocks; ++block) {
      int const dimension = file_.number<int>("the dimension of an entity");
      if (dimension < 0 || dimension > 3) file_.fail("an entity has 0 to 3 dimensions");
      file_.number<int>("the tag of an entity");
      int const coordinates = 3 + (file_.number<int>("0 or 1") != 0 ? dimension : 0);
      auto const some = file_.number<std::size_t>("how many nodes a block has");
      file_.checked(some, 4, 32, "nodes of a block");
      if (some > all - contents_.nodes.size()) file_.fail("blocks have more nodes than are announced");
      std::size_t const first = contents_.nodes.size();
      for (std::size_t k = 0; k < some; ++k) read_tag_of_node<std::size_t>();
      for (std::size_t k = first; k < first + some; ++k)
        for (int i = 0; i < coordinates; ++i) {
          double const x = file_.number<double>("a coordinate of a node");
          if (i < 3) contents_.nodes[k].place[i] = x;
        }
    }
    if (contents_.nodes.size() != all) file_.fail("blocks have fewer nodes than are announced");
  }
  void read_elements_in_blocks() {
    auto const blocks = file_.number<std::size_t>("how many blocks of elements there are");
    auto const all = file_.number<std::size_t>("how many elements there are");
    file_.number<std::size_t>("the smallest tag of an element"), file_.number<std::size_t>("the largest one");
    contents_.elements.reserve(file_.checked(all, 2, 16, "elements"));
    for (std::size_t block = 0; block < blocks; ++block) {
      int const dimension = file_.number<int>("the dimension of an entity");
      int const entity = file_.number<int>("the tag of an entity");
      auto const found = groups_.find({dimension, entity});
      int const groups = found == groups_.end() ? -1 : found->second;
      auto const& shape = gmsh_shape(file_, file_.number<int>("the type of elements"));
      if (shape.dimension != dimension)
        file_.fail(std::string(shape.name) + "s do not lie on an entity of dimension " +
                   std::to_string(dimension));
      auto const some = file_.number<std::size_t>("how many elements a block has");
      file_.checked(some, 1 + shape.corners, 8 * (1 + shape.corners), "elements of a block");
      if (some > all - contents_.elements.size()) file_.fail("blocks have more elements than are announced");
      for (std::size_t k = 0; k < some; ++k) {
        auto const number = file_.number<std::size_t>("the tag of an element");
        read_element<std::size_t>(shape, number, groups);
      }
    }
    if (contents_.elements.size() != all) file_.fail("blocks have fewer elements than are announced");
  }

  void read_nodes() {
    auto const all = file_.in_digits<std::size_t>("how many nodes there are");
    if (file_.binary) file_.line();
    contents_.nodes.reserve(file_.checked(all, 4, 28, "nodes"));
    for (std::size_t k = 0; k < all; ++k) {
      read_tag_of_node<int>();
      for (double& x : contents_.nodes.back().place) x = file_.number<double>("a coordinate of a node");
    }
  }
  void read_elements() {
    auto const all = file_.in_digits<std::size_t>("how many elements there are");
    if (file_.binary) file_.line();
    contents_.elements.reserve(file_.checked(all, 4, 8, "elements"));
    // In bytes some elements of one type share a head; in digits each has its own.
    while (contents_.elements.size() < all) {
      int number = file_.binary ? 0 : file_.number<int>("the tag of an element");
      auto const& shape = gmsh_shape(file_, file_.number<int>("the type of an element"));
      int const some = file_.binary ? file_.number<int>("how many elements follow") : 1;
      if (some < 1 || std::size_t(some) > all - contents_.elements.size())
        file_.fail("blocks of elements have as many as are announced; " + std::to_string(some) + " follow");
      int const tags = file_.number<int>("how many tags an element has");
      if (tags < 0) file_.fail("the number of tags of an element is not negative");
      for (int k = 0; k < some; ++k) {
        if (file_.binary) number = file_.number<int>("the tag of an element");
        int group = 0;
        for (int t = 0; t < tags; ++t) {
          int const value = file_.number<int>("a tag of an element");
          if (t == 0) group = value;
        }
        read_element<int>(shape, std::size_t(number), list_of(shape.dimension, group));
      }
    }
  }
  // Group 0 stands for none.
  int list_of(int dimension, int group) {
    if (group == 0) return -1;
    auto const [at, is_new] = groups_.try_emplace({dimension, group}, 0);
    if (is_new) at->second = new_list({group});
    return at->second;
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
  template <class T>
  int tag(char const* what) {
    T const value = file_.number<T>(what);
    if (value < 1 || value > T(std::numeric_limits<int>::max())) fail_tag(what, std::to_string(value));
    return int(value);
  }
  [[noreturn]] void fail_tag(std::string const& what, std::string const& value) const {
    file_.fail("the tag of a " + what + " lies between 1 and 2^31, and is " + value);
  }
};

}  // namespace detail
}  // namespace actio
