#include "program/systems/media/loops.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "actio/numbers/nearest_name.hpp"

namespace actio::scene {
namespace {

/// Rows of nodes of a box.
template <int d>
class BoxRows {
 public:
  using Index = std::array<long, d>;
  explicit BoxRows(MediumMesh const& mesh) : mesh_(mesh) {}

  /// The index of the node nearest to a coordinate.
  long nearest(std::size_t a, double X) const {
    return std::lround((X - mesh_.lower[a]) / (mesh_.upper[a] - mesh_.lower[a]) * mesh_.cells[a]);
  }
  /// Goes on to a node, in unit steps along one direction.
  void to(MaterialLoop<d>& loop, Index& at, std::size_t a, long end) const {
    while (at[a] != end) at[a] += end > at[a] ? 1 : -1, loop.stops.push_back(stop(at));
  }
  typename MaterialLoop<d>::Stop stop(Index const& at) const {
    typename MaterialLoop<d>::Stop out{0, {}};
    for (std::size_t a = d; a-- > 0;) {
      long const n = mesh_.cells[a] + !mesh_.periodic[a], turns = at[a] / n;
      out.node = out.node * static_cast<std::size_t>(n) + static_cast<std::size_t>(at[a] % n);
      if (turns > 0) out.beyond[a] = static_cast<double>(turns) * (mesh_.upper[a] - mesh_.lower[a]);
    }
    return out;
  }
  /// The row that goes once around the box along direction a, from a node on.
  MaterialLoop<d> around(std::size_t a, Index at) const {
    at[a] = 0;
    MaterialLoop<d> loop{{}, {stop(at)}};
    to(loop, at, a, mesh_.cells[a]);
    return loop;
  }

 private:
  MediumMesh const& mesh_;
};

/// A chain of edges, each with the body at its left, from a node back to it; it is taken out of them.
MaterialLoop<2> taken_chain(std::map<int, int>& next) {
  MaterialLoop<2> loop;
  int const first = next.begin()->first;
  int at = first;
  do {
    loop.stops.push_back({static_cast<std::size_t>(at), {}});
    auto const step = next.find(at);
    if (step == next.end()) return {};
    at = step->second;
    next.erase(step);
  } while (at != first);
  loop.stops.push_back({static_cast<std::size_t>(first), {}});
  return loop;
}
/// The longest chain of facets that belong to one cell each, in the order in which they look outwards.
MaterialLoop<2> boundary_loop(MediumCells<2> const& cells) {
  std::map<std::pair<int, int>, int> count;
  std::map<int, int> next;
  for (int const pass : {0, 1})
    for (std::size_t c = 0; c < cells.cells(); ++c)
      for (int f = 0; f < media::facet_count(cells.shape()); ++f) {
        auto const& corners = media::facet_corners(cells.shape(), f);
        auto const cell = cells.cell(c);
        int const a = cell.nodes[static_cast<std::size_t>(corners[0])],
                  b = cell.nodes[static_cast<std::size_t>(corners[1])];
        if (pass == 0)
          ++count[std::minmax(a, b)];
        else if (count[std::minmax(a, b)] == 1)
          next[a] = b;
      }
  MaterialLoop<2> longest;
  while (!next.empty())
    if (auto loop = taken_chain(next); loop.stops.size() > longest.stops.size()) longest = std::move(loop);
  return longest;
}

template <int d>
MaterialLoop<d> outermost_loop(MediumCells<d> const& cells, MediumMesh const& mesh) {
  for (std::size_t k = 0; k < mesh.periodic.size(); ++k)
    if (mesh.periodic[k]) return BoxRows<d>(mesh).around(k, {});
  if constexpr (d == 2)
    return boundary_loop(cells);
  else
    return {};
}

/// A side that is a closed curve.
template <int d>
MaterialLoop<d> loop_of_side(SceneTable const& table, std::string const& key, MediumMesh const& mesh) {
  std::string const side = table.text(key);
  std::vector<std::string> names;
  for (auto const& [name, does] : mesh.sides) names.push_back(name);
  if (!mesh.sides.contains(side))
    table.fail(key, fmt::format("loops: the body has no side '{}'{} (its sides: {})", side,
                                did_you_mean(side, names), names.empty() ? "none" : listed(names)));
  MaterialLoop<d> out;
  if constexpr (d == 2) {
    if (mesh.shape == "box") {
      for (std::size_t a = 0; a < 2; ++a)
        for (long const end : {0, 1}) {
          std::array<long, 2> at{};
          at[a] = end * mesh.cells[a];
          if (side == actio::media::detail::side_names[a][end] && mesh.periodic[1 - a])
            out = BoxRows<2>(mesh).around(1 - a, at);
        }
    } else {
      std::map<int, int> next;
      media::BodyMesh const body = mesh.make();
      for (auto const& facet : body.sides.at(side)) next[facet[0]] = facet[1];
      out = taken_chain(next);
      if (!next.empty()) out = {};
    }
  }
  if (out.stops.empty()) table.fail(key, fmt::format("loops: the side '{}' is no closed row of nodes", side));
  return out;
}

/// A rectangle of a box in the plane, or a row once around a periodic box.
template <int d>
MaterialLoop<d> loop_of_box(SceneTable const& loops, std::string const& key, MediumMesh const& mesh) {
  SceneTable const table = loops.inside(key);
  if (mesh.shape != "box")
    loops.fail(key, "loops: rows of nodes are those of a box; here the name of a side is expected");
  BoxRows<d> const rows(mesh);
  auto const node = [&](std::string const& corner) {
    auto const X = table.numbers(corner, d);
    std::array<long, d> at;
    for (std::size_t a = 0; a < d; ++a) {
      at[a] = rows.nearest(a, X[a]);
      if (at[a] < 0 || at[a] > mesh.cells[a])
        throw SceneError(table.place(corner, a),
                         fmt::format("loops: a point within [{}, {}] is expected, found {}", mesh.lower[a],
                                     mesh.upper[a], X[a]));
    }
    return at;
  };
  if (table.has("along")) {
    table.allow({"along", "through"});
    std::vector<std::string> axes{"X", "Y", "Z"};
    axes.resize(d);
    std::string const along = table.choice("along", "direction", axes);
    auto const a = static_cast<std::size_t>(along[0] - 'X');
    if (!mesh.periodic[a]) table.fail("along", fmt::format("loops: the box is not periodic along {}", along));
    return rows.around(a, node("through"));
  }
  table.allow({"lower", "upper"});
  if constexpr (d != 2) {
    loops.fail(key,
               "loops: along = \"X\" and through = [...] are expected; rectangles are those of the plane");
  } else {
    auto const low = node("lower"), up = node("upper");
    for (std::size_t a = 0; a < 2; ++a)
      if (low[a] >= up[a])
        throw SceneError(table.place("upper", a), "loops: no cell lies between lower and upper");
    auto at = low;
    MaterialLoop<2> loop{{}, {rows.stop(at)}};
    rows.to(loop, at, 0, up[0]), rows.to(loop, at, 1, up[1]);
    rows.to(loop, at, 0, low[0]), rows.to(loop, at, 1, low[1]);
    return loop;
  }
}

}  // namespace

std::vector<std::string> loop_names(SceneFile const& file) { return medium_keys.loops.table(file).keys(); }

void require_used_loops(SceneFile const& file, bool circulates) {
  SceneTable const table = medium_keys.loops.table(file);
  if (auto const names = table.keys(); !circulates && !names.empty())
    table.fail(names.front(), fmt::format("loops: nothing uses '{}': it is for 'circulation', which "
                                          "output.quantities does not have",
                                          shown(names.front())));
}

template <int d>
std::vector<MaterialLoop<d>> read_loops(SceneFile const& file, MediumCells<d> const& cells,
                                        MediumMesh const& mesh) {
  SceneTable const table = medium_keys.loops.table(file);
  std::vector<MaterialLoop<d>> out;
  for (auto const& name : loop_names(file)) {
    bool const word = !name.empty() && std::all_of(name.begin(), name.end(), [](unsigned char c) {
      return std::isalnum(c) || c == '_';
    });
    if (!word)
      table.fail(name, fmt::format("loops: a name has letters, digits and _, since a "
                                   "column is named by it; found '{}'",
                                   shown(name)));
    out.push_back(table.is_table(name) ? loop_of_box<d>(table, name, mesh)
                                       : loop_of_side<d>(table, name, mesh));
    out.back().name = name;
  }
  if (!out.empty()) return out;
  out.push_back(outermost_loop(cells, mesh));
  if (out.back().stops.empty())
    file.section("output").fail(
        "quantities",
        "quantities: circulation is that of bodies in the plane and of periodic boxes; this body has "
        "no outermost closed row of nodes");
  return out;
}
/// Along a line.
template std::vector<MaterialLoop<1>> read_loops(SceneFile const&, MediumCells<1> const&, MediumMesh const&);
/// In the plane.
template std::vector<MaterialLoop<2>> read_loops(SceneFile const&, MediumCells<2> const&, MediumMesh const&);
/// In space.
template std::vector<MaterialLoop<3>> read_loops(SceneFile const&, MediumCells<3> const&, MediumMesh const&);

}  // namespace actio::scene
