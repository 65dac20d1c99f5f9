// Files of Gmsh: both versions, in digits and in bytes; what is refused, and where; files that are damaged.
#include <boost/test/unit_test.hpp>

#include "actio/multisymplectic/gmsh_mesh.hpp"
#include "refused.hpp"
#include "witness/draw.hpp"

using namespace actio;

namespace {

/// A part of a mesh as a file of Gmsh has it: elements of one type, of a group (0: none).
struct Part {
  int dimension, type, group;
  std::vector<std::vector<int>> elements;
};
struct Sample {
  std::vector<std::array<double, 3>> nodes;  // node k has the tag 10 (k + 1)
  std::vector<Part> parts;
  std::string names;
};

/// Writes a sample in one of the four forms.
class Writer {
 public:
  Writer(bool new_version, bool binary) : new_(new_version), binary_(binary) {}
  std::string write(Sample const& sample) {
    out_ = std::string("$MeshFormat\n") + (new_ ? "4.1" : "2.2") + (binary_ ? " 1 8\n" : " 0 8\n");
    if (binary_) number(1), out_ += '\n';
    out_ += "$EndMeshFormat\n" + sample.names + (new_ ? "$Entities\n" : "$Nodes\n");
    if (new_)
      blocks(sample);
    else
      lists(sample);
    out_ += "$EndElements\n";
    return out_;
  }

 private:
  bool new_, binary_;
  std::string out_;
  int elements_ = 0;
  // Those of elements: 1, 11, 21, ...
  int next_tag() { return 10 * elements_++ + 1; }
  template <class T>
  void number(T value) {
    if (binary_)
      out_.append(reinterpret_cast<char const*>(&value), sizeof value);
    else
      out_ += show(double(value)) + ' ';
  }
  void head(char const* end_of_one, char const* start_of_next) {
    out_ += std::string(binary_ ? "" : "\n") + end_of_one + "\n" + start_of_next + "\n";
  }
  void blocks(Sample const& s) {
    // One entity for each part, with the number of the part; those of a dimension together.
    for (int d = 0; d < 4; ++d)
      number(std::size_t(
          std::count_if(s.parts.begin(), s.parts.end(), [&](Part const& p) { return p.dimension == d; })));
    for (int d = 0; d < 4; ++d)
      for (std::size_t k = 0; k < s.parts.size(); ++k) {
        if (s.parts[k].dimension != d) continue;
        number(int(k + 1));
        for (int i = 0; i < (d ? 6 : 3); ++i) number(0.5 * i);
        number(std::size_t(s.parts[k].group != 0));
        if (s.parts[k].group) number(s.parts[k].group);
        if (d) number(std::size_t(1)), number(-7);
      }
    head("$EndEntities", "$Nodes");
    // Two blocks, the second with a parameter of its nodes.
    std::size_t const n = s.nodes.size();
    for (std::size_t value : {std::size_t(2), n, std::size_t(10), 10 * n}) number(value);
    for (int block = 0; block < 2; ++block) {
      std::size_t const first = block ? 1 : 0, last = block ? n : 1;
      number(1), number(1), number(block), number(last - first);
      for (std::size_t k = first; k < last; ++k) number(10 * (k + 1));
      for (std::size_t k = first; k < last; ++k) {
        for (double x : s.nodes[k]) number(x);
        if (block) number(0.125);
      }
    }
    head("$EndNodes", "$Elements");
    std::size_t all = 0;
    for (auto const& part : s.parts) all += part.elements.size();
    for (std::size_t value : {s.parts.size(), all, std::size_t(1), all}) number(value);
    for (std::size_t k = 0; k < s.parts.size(); ++k) {
      auto const& part = s.parts[k];
      number(part.dimension), number(int(k + 1)), number(part.type), number(part.elements.size());
      for (auto const& nodes : part.elements) {
        if (!binary_) out_ += '\n';
        number(std::size_t(next_tag()));
        for (int node : nodes) number(std::size_t(10 * (node + 1)));
      }
    }
    if (!binary_) out_ += '\n';
  }
  void lists(Sample const& s) {
    out_ += std::to_string(s.nodes.size()) + "\n";
    for (std::size_t k = 0; k < s.nodes.size(); ++k) {
      number(int(10 * (k + 1)));
      for (double x : s.nodes[k]) number(x);
      if (!binary_) out_ += '\n';
    }
    out_ += "$EndNodes\n$Elements\n";
    std::size_t all = 0;
    for (auto const& part : s.parts) all += part.elements.size();
    out_ += std::to_string(all) + "\n";
    for (auto const& part : s.parts) {
      if (binary_) number(part.type), number(int(part.elements.size())), number(2);
      for (auto const& nodes : part.elements) {
        number(next_tag());
        if (!binary_) number(part.type), number(2);
        number(part.group), number(1);
        for (int node : nodes) number(10 * (node + 1));
        if (!binary_) out_ += '\n';
      }
    }
  }
};

/// Two triangles on the unit square, with the centre of an arc that is no corner.
Sample triangles() {
  return {{{5, 5, 0}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
          {{0, 15, 0, {{1}}},
           {1, 1, 3, {{1, 2}}},
           {1, 1, 4, {{4, 3}, {1, 4}}},
           {2, 2, 9, {{1, 2, 3}, {1, 3, 4}}}},
          "$PhysicalNames\n2\n1 3 \"bottom\"\n2 9 \"the body\"\n$EndPhysicalNames\n"};
}
Sample quadrangles() {
  return {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {0, 1, 0}},
          {{2, 3, 0, {{0, 1, 4, 5}, {1, 2, 3, 4}}}, {1, 1, 1, {{0, 5}}}},
          ""};
}
Sample tetrahedra() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}},
          {{2, 2, 2, {{2, 1, 0}}}, {3, 4, 1, {{0, 1, 2, 3}, {1, 2, 3, 4}}}},
          "$PhysicalNames\n1\n2 2 \"floor\"\n$EndPhysicalNames\n"};
}
Sample hexahedron() {
  return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 2}, {1, 0, 2}, {1, 1, 2}, {0, 1, 2}},
          {{3, 5, 1, {{0, 1, 2, 3, 4, 5, 6, 7}}}, {2, 3, 8, {{4, 5, 6, 7}}}},
          ""};
}
Sample segments() {
  return {{{0, 0, 0}, {1, 0, 0}, {3, 0, 0}}, {{0, 15, 5, {{2}}}, {1, 1, 0, {{0, 1}, {1, 2}}}}, ""};
}

double volume_of(BodyMesh const& mesh) {
  static constexpr double parts[] = {1, 2, 1, 6, 1};
  double sum = 0;
  for (int cell = 0; cell < int(mesh.cells.size()); ++cell)
    sum += corner_jacobian(mesh, cell, 0).volume / parts[int(mesh.shape)];
  return sum;
}

/// A text that must be refused with these words.
void refused(std::string const& text, std::string const& words) {
  try {
    gmsh_mesh_of(text, "sample");
    BOOST_ERROR("not refused: " << words);
  } catch (NotAGmshFile const& e) {
    BOOST_TEST(std::string(e.what()).find(words) != std::string::npos, e.what());
  }
}
std::string replaced(std::string text, std::string const& what, std::string const& by) {
  auto const at = text.find(what);
  BOOST_REQUIRE(at != text.npos);
  return text.replace(at, what.size(), by);
}

}  // namespace

BOOST_AUTO_TEST_CASE(all_four_forms_give_the_same_mesh_of_every_shape) {
  struct Expected {
    Sample sample;
    char const *shape, *side;
    std::size_t nodes, facets;
    double volume;
  };
  for (auto const& expected :
       {Expected{triangles(), "triangle", "bottom", 4, 1, 1},
        Expected{quadrangles(), "quadrilateral", "1", 6, 1, 2},
        Expected{tetrahedra(), "tetrahedron", "floor", 5, 1, 0.5},
        Expected{hexahedron(), "hexahedron", "8", 8, 1, 2}, Expected{segments(), "segment", "5", 3, 1, 3}}) {
    auto const first = gmsh_mesh_of(Writer(true, false).write(expected.sample), "sample");
    BOOST_TEST(name_of(first.shape) == std::string(expected.shape));
    BOOST_TEST(first.nodes.size() == expected.nodes);
    BOOST_TEST(first.sides.at(expected.side).size() == expected.facets);
    BOOST_TEST(std::abs(volume_of(first) - expected.volume) < 1e-15);
    for (auto const& [version, binary] :
         {std::pair(true, true), std::pair(false, false), std::pair(false, true)}) {
      auto const other = gmsh_mesh_of(Writer(version, binary).write(expected.sample), "sample");
      BOOST_TEST((other.nodes == first.nodes));
      BOOST_TEST((other.cells == first.cells));
      BOOST_TEST((other.sides == first.sides));
    }
  }
  // A side takes the order of its cell, whatever that of the file: outwards.
  auto const square = gmsh_mesh_of(Writer(false, false).write(triangles()), "sample");
  BOOST_TEST((square.sides.at("4") == std::vector<std::array<int, 4>>{{3, 0, -1, -1}, {2, 3, -1, -1}}));
}

BOOST_AUTO_TEST_CASE(a_section_that_is_not_known_is_passed_whatever_it_holds) {
  for (bool const new_version : {true, false})
    for (bool const binary : {true, false}) {
      auto sample = triangles();
      sample.names += "$Comments\nall of $Nodes\n$Nodes\n$EndComments\n$Other\n$EndOther\n";
      auto const mesh = gmsh_mesh_of(Writer(new_version, binary).write(sample), "sample");
      BOOST_TEST(mesh.nodes.size() == 4u);
      BOOST_TEST(mesh.cells.size() == 2u);
    }
  refused("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Comments\n$Nodes\n", "$Comments has no end");
}

// What is left of a third coordinate is measured by the size of the mesh, whatever its unit.
BOOST_AUTO_TEST_CASE(a_plane_mesh_may_have_the_rounding_of_its_size_across_the_plane) {
  for (double const size : {1e-9, 1.0, 1e9}) {
    auto sample = triangles();
    for (auto& node : sample.nodes)
      for (double& x : node) x *= size;
    sample.nodes[3][2] = 32 * std::numeric_limits<double>::epsilon() * size;
    BOOST_TEST(gmsh_mesh_of(Writer(true, true).write(sample), "sample").nodes[2][2] == 0);
    // A thousand times as much is a place outside of the plane.
    sample.nodes[3][2] *= 1000;
    refused(Writer(true, true).write(sample), "is not in the plane");
  }
}

BOOST_AUTO_TEST_CASE(what_is_wrong_in_a_text_is_named_with_its_line) {
  auto const text = Writer(false, false).write(triangles());
  refused(text.substr(0, text.find("$Elements")), "the file has no section $Elements");
  refused(replaced(text, "2.2", "4"), "line 2: version 4 of the format is not read");
  refused(replaced(text, "50 0 1 0", "50 0 1"), "line 16: a coordinate of a node should be a number");
  refused(replaced(text, "50 0 1 0", "50 0 nan 0"), "line 15: a coordinate of a node is no finite number");
  refused(replaced(text, "50 0 1 0", "40 0 1 0"), "line 15: node 40 comes twice");
  refused(replaced(text, "50 0 1 0", "50 0 1 3"), "line 15: node 50 at (0, 1, 3) is not in the plane");
  refused(replaced(text, "20 40 50", "20 40 70"),
          "line 24: a triangle has node 70, which the file does not have");
  refused(replaced(text, "20 40 50", "40 20 50"), "a cell is not inverted");
  // By the tags of the file, in the versions of digits and of bytes.
  refused(replaced(text, "20 40 50", "40 20 50"), "element 51 with nodes 40 20 50");
  refused(replaced(text, "20 40 50", "20 40 20"), "a cell is not degenerate");
  refused(replaced(text, "1 2 2 9 1 20 40 50", "1 9 2 9 1 20 40 50"), "elements of type 9 (of second order");
  refused(replaced(text, "1 2 2 9 1 20 40 50", "1 3 2 9 1 20 30 40 50"), "cells are of one kind");
  refused(replaced(text, "1 1 2 3 1 20 30", "1 1 2 3 1 20 40"),
          "line 20: a line of a side belongs to two cells");
  refused(replaced(text, "1 1 2 3 1 20 30", "1 1 2 3 1 30 50"),
          "line 20: a line of a side belongs to no cell");
  refused(replaced(text, "$Nodes\n5", "$Nodes\n500000000000"), "500000000000 nodes are announced");
  refused(replaced(text, "$EndNodes", "$EndNode"), "$EndNodes is needed, and '$EndNode' is found");
  refused(replaced(text, "\"bottom\"", "bottom"), "a name in quotation marks is needed");
  refused("", "line 1: the file ends where $MeshFormat should be");
  // Two triangles that meet at a node alone.
  auto sample = triangles();
  sample.nodes[0] = {1, 2, 0}, sample.parts[3].elements[1] = {3, 0, 4};
  sample.parts.erase(sample.parts.begin() + 1, sample.parts.begin() + 3);
  for (bool const version : {false, true})
    for (bool const binary : {false, true})
      refused(Writer(version, binary).write(sample),
              "element 21 with nodes 40 10 50 is unconnected to element 11");
  auto const bytes = Writer(true, true).write(hexahedron());
  refused(replaced(bytes, std::string("\1\0\0\0", 4), std::string("\0\0\0\1", 4)), "byte 20: the number one");
  refused(bytes.substr(0, 400), "byte 278: 8 nodes are announced, and the file has room for 3");
  refused(replaced(text, "$Nodes", "$Periodic\n$EndPeriodic\n$Nodes"), "without periodic sides");
  CHECK_REFUSED(gmsh_mesh("/no/such/file.msh"), Error);
  CHECK_REFUSED(gmsh_mesh("/"), Error);
}

BOOST_AUTO_TEST_CASE(a_damaged_file_is_refused_or_is_another_mesh_of_a_body) {
  Draw draw(5);
  auto const below = [&](std::size_t n) { return std::size_t(draw.below(n)); };
  int refusals = 0, count = 0;
  for (auto const& sample : {triangles(), quadrangles(), tetrahedra(), hexahedron(), segments()})
    for (int form = 0; form < 4; ++form)
      for (int k = 0; k < 25; ++k, ++count) {
        auto text = Writer(form & 1, form & 2).write(sample);
        for (std::size_t times = 1 + below(3); times > 0 && !text.empty(); --times) switch (below(4)) {
            case 0:
              text[below(text.size())] = char(below(256));
              break;
            case 1:
              text.resize(below(text.size()));
              break;
            case 2:
              text.erase(below(text.size()), below(20));
              break;
            default:
              text.insert(below(text.size()), text.substr(below(text.size()), below(20)));
          }
        try {
          require_body_mesh(gmsh_mesh_of(text, "damaged"));
        } catch (NotAGmshFile const&) {
          ++refusals;
        } catch (NotABodyMesh const&) {
          ++refusals;
        }
      }
  BOOST_TEST(count == 500);
  // Where only a coordinate or an unused tag changes there is still a mesh.
  BOOST_TEST(refusals > 400);
  BOOST_TEST(refusals < 500);
}
