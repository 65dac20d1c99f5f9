#include "program/systems/media/frames.hpp"

#include "program/systems/media/grid.hpp"

namespace actio::scene {
namespace {

char const* shape_name(media::BodyMesh::Shape shape) {
  static constexpr char const* names[] = {"line", "triangle", "quadrilateral", "tetrahedron", "hexahedron"};
  return names[static_cast<int>(shape)];
}

template <std::size_t d>
std::span<double const> in_a_row(std::vector<std::array<double, d>> const& all) {
  static_assert(sizeof(std::array<double, d>) == d * sizeof(double));
  return {all.empty() ? nullptr : all.front().data(), d * all.size()};
}

/// `visit(cell, corner)` for the corners of all cells, counted as VTK counts them.
template <int d, class Visit>
void for_corners(MediumCells<d> const& cells, Visit const& visit) {
  auto const corners = static_cast<std::size_t>(media::corner_count(cells.shape()));
  for (std::size_t c = 0; c < cells.cells(); ++c) {
    auto const cell = cells.cell(c);
    for (std::size_t k = 0; k < corners; ++k) visit(cell, vtk_corner(cells.shape(), k));
  }
}

}  // namespace

template <int d>
Hdf5Frames MediumFrames<d>::in(std::string const& folder, MediumCells<d> const& cells,
                               MediumFields<d> const& asked, Units const& units) {
  std::size_t const nodes = cells.nodes();
  std::vector<Hdf5Frames::Field> fields{
      {"place", "of the nodes", {nodes, d}, {}, units.in("length")},
      {"velocity", "of the nodes", {nodes, d}, {}, units.in("length/time")}};
  for (auto const& [name, meaning, unit, stressed, write, components, of_solids] : asked) {
    fields.push_back({name, "means around the nodes: " + meaning, {nodes}, components, units.in(unit)});
    if (!components.empty()) fields.back().shape.push_back(components.size());
  }
  return {folder + "/" + frames_file, std::move(fields)};
}

template <int d>
std::vector<Hdf5Frames::Constant> MediumFrames<d>::constants(MediumCells<d> const& cells) {
  auto const corners = static_cast<std::size_t>(media::corner_count(cells.shape()));
  std::vector<double> periods;
  for (int a = 0; a < d; ++a) periods.push_back(cells.period(a));
  std::vector<Hdf5Frames::Constant> out;
  out.push_back(
      {{"reference", "the places X of the nodes in the reference space", {cells.nodes(), d}}, [&cells] {
         std::vector<double> reference;
         reference.reserve(d * cells.nodes());
         for (std::size_t k = 0; k < cells.nodes(); ++k)
           for (double const X : cells.reference(k)) reference.push_back(X);
         return reference;
       }});
  out.push_back({{"cells", "the nodes at the corners, counted as VTK counts them", {cells.cells(), corners}},
                 [&cells, corners] {
                   std::vector<std::int64_t> nodes;
                   nodes.reserve(corners * cells.cells());
                   for_corners(cells,
                               [&](auto const& cell, std::size_t b) { nodes.push_back(cell.nodes[b]); });
                   return nodes;
                 },
                 {{"shape", shape_name(cells.shape())}}});
  if (periods == std::vector<double>(d, 0.0)) return out;
  out.push_back({{"periods", "of the box, zero where it has none", {d}}, [periods] { return periods; }});
  out.push_back({{"beyond",
                  "by how many periods a corner lies beyond the place of its node",
                  {cells.cells(), corners, d}},
                 [&cells, corners] {
                   std::vector<std::int64_t> beyond;
                   beyond.reserve(d * corners * cells.cells());
                   for_corners(cells, [&](auto const& cell, std::size_t b) {
                     for (int a = 0; a < d; ++a) beyond.push_back(cell.wraps[b] >> a & 1);
                   });
                   return beyond;
                 }});
  return out;
}

template <int d>
std::function<std::span<double const>(std::size_t)> MediumFrames<d>::one(std::vector<Place> const& x,
                                                                         std::vector<Place> const& v,
                                                                         MediumFields<d> const& asked,
                                                                         std::vector<double> const& fields) {
  std::size_t const size = field_size(asked);
  return [&x, &v, &asked, &fields, size,
          one = std::vector<double>()](std::size_t field) mutable -> std::span<double const> {
    if (field < 2) return in_a_row(field == 0 ? x : v);
    std::size_t first = 0, wide = 0;
    for (std::size_t k = 0; k + 2 <= field; ++k) first += wide, wide = asked[k].width();
    if (wide == size) return fields;
    one.clear();
    one.reserve(x.size() * wide);
    for (std::size_t k = 0; k < x.size(); ++k)
      for (std::size_t i = 0; i < wide; ++i) one.push_back(fields[k * size + first + i]);
    return one;
  };
}

/// Along a line.
template struct MediumFrames<1>;
/// In the plane.
template struct MediumFrames<2>;
/// In space.
template struct MediumFrames<3>;

}  // namespace actio::scene
