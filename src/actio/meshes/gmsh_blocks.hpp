// Sections of a Gmsh file of version 4: nodes and elements in blocks, each on an entity of the geometry, and
// entities that know their physical groups.
//
// Version 4.1 has the dimension of an entity before its tag, the tags of a block's nodes before their places,
// and 8 bytes for tags of nodes and elements. Version 4.0 has it the other way round, and 4 bytes.
#pragma once

#include "actio/meshes/gmsh_contents.hpp"

namespace actio::media::detail {

/// Reads them.
class GmshBlocks : public GmshReader {
 public:
  using GmshReader::GmshReader;

 protected:
  bool old_blocks_ = false;  // version 4.0

  // Physical tags of the entities of each dimension.
  void read_entities();
  void read_nodes_in_blocks();
  void read_elements_in_blocks();

 private:
  template <class T>
  void read_numbered(GmshShape const& shape, int groups) {
    auto const number = std::size_t(file_.number<T>("the tag of an element"));
    read_element<T>(shape, number, groups);
  }
  // How many blocks there are, and how many things in all of them.
  std::pair<std::size_t, std::size_t> read_counts(std::string const& what);
  // The dimension and the tag of an entity.
  std::pair<int, int> read_entity();
};

}  // namespace actio::media::detail
