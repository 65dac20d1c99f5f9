#include "actio/meshes/gmsh_file.hpp"

namespace actio::media {

namespace detail {

GmshContents GmshSections::read() {
  read_format();
  bool nodes = false, elements = false;
  while (!file_.done()) {
    std::string const section(file_.word("a section"));
    if (section[0] != '$') file_.fail("a section begins with $");
    if (file_.binary) file_.line();
    if (section == "$Nodes" || section == "$ParametricNodes") {
      blocks_ ? read_nodes_in_blocks() : read_nodes(section != "$Nodes"), nodes = true;
    } else if (section == "$Elements") {
      blocks_ ? read_elements_in_blocks() : read_elements(), elements = true;
    } else if (section == "$PhysicalNames") {
      read_names();
    } else if (section == "$Entities" && blocks_) {
      read_entities();
    } else if (section == "$PartitionedEntities") {
      file_.fail(section + ": only meshes in one part are read; save without partitions");
    } else {
      // Which nodes a periodic side shares is left as well: the sides are those of the body all the same.
      pass_section(section);
      continue;
    }
    file_.expect("$End" + section.substr(1));
  }
  if (!nodes) file_.fail_at(file_.at(), "the file has no section $Nodes");
  if (!elements) file_.fail_at(file_.at(), "the file has no section $Elements");
  return std::move(contents_);
}

void GmshSections::read_format() {
  auto first = file_.word("$MeshFormat");
  for (; first == "$Comments"; first = file_.word("$MeshFormat")) pass_section("$Comments");
  if (first == "$NOD") file_.fail("version 1 of the format is not read; save as 4.1 or 2.2");
  file_.require(first, "$MeshFormat");
  version_ = file_.in_digits<double>("the version");
  old_blocks_ = version_ == 4, blocks_ = old_blocks_ || version_ == 4.1;
  if (!blocks_ && version_ != 2 && version_ != 2.1 && version_ != 2.2)
    file_.fail("version " + show(version_) + " of the format is not read; save as 4.1 or 2.2");
  int const kind = file_.in_digits<int>("0 for text or 1 for bytes");
  if (kind != 0 && kind != 1) file_.fail("text is 0 and bytes are 1, not " + std::to_string(kind));
  int const size = file_.in_digits<int>("the size of numbers");
  if (kind == 1 && size != 8) file_.fail("numbers of 8 bytes are read, not of " + std::to_string(size));
  if (kind == 1) {
    file_.line();
    file_.binary = true;
    if (file_.number<int>("the number one") != 1)
      file_.fail("the number one does not read as one: the bytes of numbers are in another order");
  }
  file_.expect("$EndMeshFormat");
}

void GmshSections::read_names() {
  for (int left = file_.in_digits<int>("how many names there are"); left > 0; --left) {
    int const first = file_.in_digits<int>(version_ == 2 ? "the tag of a group" : "the dimension of a group");
    if (version_ == 2 && file_.at_quote()) {
      auto const name = file_.quoted();
      for (int dimension = 0; dimension < 4; ++dimension)
        contents_.names.try_emplace({dimension, first}, name);
      continue;
    }
    int const tag = file_.in_digits<int>("the tag of a group");
    contents_.names[{first, tag}] = file_.quoted();
    // What a program notes of a group besides its name.
    file_.line();
  }
}

void GmshSections::read_nodes(bool parametric) {
  auto const all = file_.in_digits<std::size_t>("how many nodes there are");
  if (file_.binary) file_.line();
  contents_.nodes.reserve(file_.checked(all, 4, 28, "nodes"));
  for (std::size_t k = 0; k < all; ++k) {
    read_tag_of_node<int>();
    read_place(contents_.nodes.back(), 0);
    if (!parametric) continue;
    int const dimension = file_.number<int>("the dimension of an entity");
    file_.number<int>("the tag of an entity");
    for (int i = 0; i < (dimension == 1 || dimension == 2 ? dimension : 0); ++i)
      file_.number<double>("a parameter of a node");
  }
}

void GmshSections::read_elements() {
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

int GmshSections::list_of(int dimension, int group) {
  if (group == 0) return -1;
  auto const [at, is_new] = groups_.try_emplace({dimension, group}, 0);
  if (is_new) at->second = new_list({group});
  return at->second;
}

}  // namespace detail

}  // namespace actio::media
