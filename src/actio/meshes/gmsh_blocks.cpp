#include "actio/meshes/gmsh_blocks.hpp"

namespace actio::media {

namespace detail {

void GmshBlocks::read_entities() {
  std::array<std::size_t, 4> count;
  for (auto& n : count) n = file_.number<std::size_t>("how many entities there are");
  for (int dimension = 0; dimension < 4; ++dimension)
    for (std::size_t k = 0; k < count[dimension]; ++k) {
      int const tag = file_.number<int>("the tag of an entity");
      // A point has its place, others, and of old points too, have two corners of a box around them.
      int const numbers = dimension > 0 || old_blocks_ ? 6 : 3;
      for (int i = 0; i < numbers; ++i) file_.number<double>("a coordinate of an entity");
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

void GmshBlocks::read_nodes_in_blocks() {
  auto const [blocks, all] = read_counts("node");
  contents_.nodes.reserve(file_.checked(all, 4, old_blocks_ ? 28 : 32, "nodes"));
  for (std::size_t block = 0; block < blocks; ++block) {
    int const dimension = read_entity().first;
    int const parameters = file_.number<int>("0 or 1") != 0 ? dimension : 0;
    auto const some = file_.number<std::size_t>("how many nodes a block has");
    file_.checked(some, 4, old_blocks_ ? 28 : 32, "nodes of a block");
    if (some > all - contents_.nodes.size()) file_.fail("blocks have more nodes than are announced");
    std::size_t const first = contents_.nodes.size();
    for (std::size_t k = 0; k < some && old_blocks_; ++k)
      read_tag_of_node<int>(), read_place(contents_.nodes.back(), parameters);
    if (old_blocks_) continue;
    for (std::size_t k = 0; k < some; ++k) read_tag_of_node<std::size_t>();
    for (std::size_t k = first; k < first + some; ++k) read_place(contents_.nodes[k], parameters);
  }
  if (contents_.nodes.size() != all) file_.fail("blocks have fewer nodes than are announced");
}

void GmshBlocks::read_elements_in_blocks() {
  auto const [blocks, all] = read_counts("element");
  contents_.elements.reserve(file_.checked(all, 2, old_blocks_ ? 8 : 16, "elements"));
  for (std::size_t block = 0; block < blocks; ++block) {
    auto const entity = read_entity();
    auto const found = groups_.find(entity);
    int const groups = found == groups_.end() ? -1 : found->second;
    auto const& shape = gmsh_shape(file_, file_.number<int>("the type of elements"));
    if (shape.dimension != entity.first)
      file_.fail(std::string(shape.name) + "s do not lie on an entity of dimension " +
                 std::to_string(entity.first));
    auto const some = file_.number<std::size_t>("how many elements a block has");
    file_.checked(some, 1 + shape.corners, (old_blocks_ ? 4 : 8) * (1 + shape.corners),
                  "elements of a block");
    if (some > all - contents_.elements.size()) file_.fail("blocks have more elements than are announced");
    for (std::size_t k = 0; k < some; ++k)
      old_blocks_ ? read_numbered<int>(shape, groups) : read_numbered<std::size_t>(shape, groups);
  }
  if (contents_.elements.size() != all) file_.fail("blocks have fewer elements than are announced");
}

std::pair<std::size_t, std::size_t> GmshBlocks::read_counts(std::string const& what) {
  auto const blocks = file_.number<std::size_t>(("how many blocks of " + what + "s there are").c_str());
  auto const all = file_.number<std::size_t>(("how many " + what + "s there are").c_str());
  if (!old_blocks_)
    for (char const* which : {"the smallest tag of a ", "the largest tag of a "})
      file_.number<std::size_t>((which + what).c_str());
  return {blocks, all};
}

std::pair<int, int> GmshBlocks::read_entity() {
  int numbers[2] = {};
  for (int k = 0; k < 2; ++k) {
    bool const is_dimension = (k == 0) != old_blocks_;
    numbers[is_dimension ? 0 : 1] =
        file_.number<int>(is_dimension ? "the dimension of an entity" : "the tag of an entity");
    if (is_dimension && (numbers[0] < 0 || numbers[0] > 3)) file_.fail("an entity has 0 to 3 dimensions");
  }
  return {numbers[0], numbers[1]};
}

}  // namespace detail

}  // namespace actio::media
