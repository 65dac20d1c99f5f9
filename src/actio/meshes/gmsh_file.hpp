// What a Gmsh file says, version 2 or 4, in digits or in bytes: nodes, elements, and the names of groups.
//
// In version 2 each element names its group, and one that is in several groups is listed once for each. In
// version 4 nodes and elements come in blocks (gmsh_blocks.hpp). Here both become one list.
#pragma once

#include "actio/meshes/gmsh_blocks.hpp"

namespace actio::media::detail {

/// Reads the sections of a file one after the other.
class GmshSections : public GmshBlocks {
 public:
  using GmshBlocks::GmshBlocks;

  GmshContents read();

 private:
  double version_ = 0;
  bool blocks_ = false;  // version 4

  void pass_section(std::string const& section) {
    if (!file_.pass("$End" + section.substr(1))) file_.fail("the section " + section + " has no end");
  }
  void read_format();

  // In version 2.0 a name is that of groups of all dimensions.
  void read_names();

  /// @param parametric  whether a place is followed by the entity of the node and parameters there
  void read_nodes(bool parametric);
  void read_elements();
  // Group 0 stands for none.
  int list_of(int dimension, int group);
};

}  // namespace actio::media::detail
