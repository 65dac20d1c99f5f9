#include "actio/meshes/gmsh_mesh.hpp"

namespace actio::media {

namespace detail {

BodyMesh GmshBody::mesh() {
  choose_cells();
  number_nodes();
  for (auto const* element : cells_) mesh_.cells.push_back(corners(*element));
  for (auto const* element : cells_) mesh_.element_tags.push_back(element->tag);
  keep_corners();
  for (int cell = 0; cell < int(mesh_.cells.size()); ++cell) orient(cell);
  try {
    require_body_mesh(mesh_);
  } catch (NotABodyMesh const& e) {
    if (e.cell < 0) throw;
    fail_at(*cells_[e.cell], e.what());
  }
  add_sides();
  return std::move(mesh_);
}

void GmshBody::choose_cells() {
  using enum BodyMesh::Shape;
  int dimension = 0;
  for (auto const& element : in_.elements) dimension = std::max(dimension, element.shape->dimension);
  if (dimension == 0) sections_.file().fail_at(sections_.file().at(), "the file has no cells");
  for (auto const& element : in_.elements) {
    if (element.shape->dimension != dimension) continue;
    cells_.push_back(&element);
    if (element.shape != cells_[0]->shape)
      fail_at(element, std::string("cells are of one kind; ") + cells_[0]->shape->name + " and " +
                           element.shape->name + " are found");
  }
  leave_repeated();
  mesh_.dimension = dimension;
  mesh_.shape = dimension == 1   ? segment
                : dimension == 2 ? (cells_[0]->shape->corners == 3 ? triangle : quadrilateral)
                                 : (cells_[0]->shape->corners == 4 ? tetrahedron : hexahedron);
  mesh_.cells.reserve(cells_.size());
}

void GmshBody::leave_repeated() {
  std::vector<std::pair<std::array<int, 8>, int>> nodes;
  for (auto const* element : cells_) {
    nodes.emplace_back(element->nodes, int(nodes.size()));
    std::sort(nodes.back().first.begin(), nodes.back().first.end());
  }
  std::sort(nodes.begin(), nodes.end());
  for (std::size_t k = 1; k < nodes.size(); ++k)
    if (nodes[k].first == nodes[k - 1].first) cells_[nodes[k].second] = nullptr;
  std::erase(cells_, nullptr);
}

void GmshBody::orient(int cell) {
  double volume = 0;
  auto& at = mesh_.cells[cell];
  bool const simplex = is_simplex(mesh_.shape);
  for (int b = 0; b < (simplex ? 1 : corner_count(mesh_.shape)); ++b)
    volume += corner_jacobian(mesh_, cell, b).volume;
  if (!(volume < 0)) return;
  std::swap(mesh_.dimension == 1 ? at[0] : at[2], at[1]);
  if (mesh_.shape == BodyMesh::Shape::hexahedron) std::swap(at[5], at[6]);
}

void GmshBody::number_nodes() {
  by_tag_.resize(in_.nodes.size());
  std::iota(by_tag_.begin(), by_tag_.end(), 0);
  std::sort(by_tag_.begin(), by_tag_.end(),
            [&](int a, int b) { return std::pair(in_.nodes[a].tag, a) < std::pair(in_.nodes[b].tag, b); });
  for (std::size_t k = 1; k < by_tag_.size(); ++k) {
    auto const& again = in_.nodes[by_tag_[k]];
    if (again.tag == in_.nodes[by_tag_[k - 1]].tag)
      sections_.file().fail_at(again.byte, "node " + std::to_string(again.tag) + " comes twice");
  }
}

int GmshBody::node_with(int tag, GmshElement const& element) const {
  auto const found = std::lower_bound(by_tag_.begin(), by_tag_.end(), tag,
                                      [&](int node, int sought) { return in_.nodes[node].tag < sought; });
  if (found == by_tag_.end() || in_.nodes[*found].tag != tag)
    fail_at(element, std::string("a ") + element.shape->name + " has node " + std::to_string(tag) +
                         ", which the file does not have");
  return *found;
}

std::array<int, 8> GmshBody::corners(GmshElement const& element) const {
  static constexpr std::array<int, 8> around = {0, 1, 3, 2, 4, 5, 7, 6};
  bool const simplex = is_simplex(mesh_.shape);
  std::array<int, 8> out{};
  for (int b = 0; b < element.shape->corners; ++b)
    out[b] = node_with(element.nodes[simplex ? b : around[b]], element);
  return out;
}

void GmshBody::keep_corners() {
  number_.assign(in_.nodes.size(), -1);
  int const count = corner_count(mesh_.shape);
  for (auto const& cell : mesh_.cells)
    for (int b = 0; b < count; ++b) number_[cell[b]] = 0;
  double size = 0;
  std::array<double, 3> first{};
  for (std::size_t k = number_.size(); k-- > 0;)
    if (number_[k] == 0) {
      first = in_.nodes[k].place;
      for (double x : first) size = std::max(size, std::abs(x));
    }
  for (std::size_t k = 0; k < number_.size(); ++k) {
    if (number_[k] < 0) continue;
    number_[k] = int(mesh_.nodes.size());
    auto place = in_.nodes[k].place;
    for (int i = mesh_.dimension; i < 3; ++i) {
      // A plane across Z may lie anywhere, up to what the geometry's own arithmetic leaves.
      if (std::abs(place[i] - first[i]) > 64 * epsilon<double>() * size)
        sections_.file().fail_at(
            in_.nodes[k].byte, "node " + std::to_string(in_.nodes[k].tag) + " at " + place_name(place) +
                                   " is not in the " + (mesh_.dimension == 1 ? "line" : "plane") + " along " +
                                   (mesh_.dimension == 1 ? "X" : "X and Y") + " through " +
                                   place_name(first) + ", and the cells are " + cells_[0]->shape->name + "s");
      place[i] = 0;
    }
    mesh_.nodes.push_back(place), mesh_.node_tags.push_back(in_.nodes[k].tag);
  }
  for (auto& cell : mesh_.cells)
    for (int b = 0; b < count; ++b) cell[b] = number_[cell[b]];
}

std::vector<GmshBody::Facet> GmshBody::facets_in_groups() const {
  std::vector<Facet> facets;
  for (auto const& element : in_.elements) {
    if (element.shape->dimension != mesh_.dimension - 1 || element.groups < 0) continue;
    if (in_.groups[element.groups].empty()) continue;
    Facet facet{{-1, -1, -1, -1}, &element};
    for (int b = 0; b < element.shape->corners; ++b)
      facet.nodes[b] = number_[node_with(element.nodes[b], element)];
    facet.turned = is_turned(facet.nodes, 1);
    std::sort(facet.nodes.begin(), facet.nodes.end());
    facets.push_back(facet);
  }
  return facets;
}

void GmshBody::add_sides() {
  auto facets = facets_in_groups();
  auto const before = [](Facet const& a, Facet const& b) { return a.nodes < b.nodes; };
  std::stable_sort(facets.begin(), facets.end(), before);
  for (int cell = 0; cell < int(mesh_.cells.size()); ++cell)
    for (int k = 0; k < facet_count(mesh_.shape); ++k) {
      Facet sought{facet_nodes(mesh_, {cell, k}), nullptr};
      bool const turned = is_turned(sought.nodes, k);
      std::sort(sought.nodes.begin(), sought.nodes.end());
      auto const [first, last] = std::equal_range(facets.begin(), facets.end(), sought, before);
      for (auto facet = first; facet != last; ++facet)
        if (++facet->cells == 1 || facet->turned == turned) facet->at = {cell, k};
    }
  for (auto const& facet : facets)
    for (int group : in_.groups[facet.element->groups]) add_to(name_of_group(group), facet);
  for (auto const& [name, why] : mesh_.no_sides) mesh_.sides.erase(name), mesh_.inside.erase(name);
  // A side of which a part lies inside lies there as a whole.
  for (auto& [name, inside] : mesh_.inside)
    if (auto const side = mesh_.sides.find(name); side != mesh_.sides.end()) {
      inside.insert(inside.end(), side->second.begin(), side->second.end());
      mesh_.sides.erase(side);
    }
}

void GmshBody::add_to(std::string const& name, Facet const& facet) {
  if (facet.cells == 0) {
    auto const& element = *facet.element;
    mesh_.no_sides.try_emplace(name, std::string("the ") + element.shape->name + " " +
                                         std::to_string(element.tag) + " of it belongs to no cell");
    return;
  }
  auto& side = (facet.cells == 1 ? mesh_.sides : mesh_.inside)[name];
  auto const nodes = facet_nodes(mesh_, facet.at);
  if (side.empty() || side.back() != nodes) side.push_back(nodes);
}

}  // namespace detail

BodyMesh gmsh_mesh(std::string const& path) {
  std::error_code error;
  auto const size = std::filesystem::file_size(path, error);
  std::ifstream file(path, std::ios::binary);
  if (error || !file) throw Error(path + ": there is no such file that can be read");
  std::string text(size, '\0');
  if (!file.read(text.data(), std::streamsize(size)))
    throw Error(path + ": the file cannot be read to its end");
  return gmsh_mesh_of(text, path);
}

}  // namespace actio::media
