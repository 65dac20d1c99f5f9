// Small meshes as files of Gmsh have them, and a writer of all forms of these files.
#pragma once

#include <boost/test/unit_test.hpp>

#include "actio/meshes/gmsh_mesh.hpp"
#include "caught.hpp"

namespace actio::testing::gmsh {

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

/// Writes a sample in one of the forms: version 2.2, 4.1 or 4.0, in digits or in bytes.
class Writer {
 public:
  Writer(bool new_version, bool binary, bool old_blocks = false)
      : new_(new_version), binary_(binary), old_(old_blocks) {}
  std::string write(Sample const& sample) {
    out_ = std::string("$MeshFormat\n") +
           (old_   ? "4"
            : new_ ? "4.1"
                   : "2.2") +
           (binary_ ? " 1 8\n" : " 0 8\n");
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
  bool new_, binary_, old_;
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
  // A tag of a node or an element; and an entity of a dimension.
  void tag(std::size_t value) { old_ ? number(int(value)) : number(value); }
  void entity(int dimension, int tag) { number(old_ ? tag : dimension), number(old_ ? dimension : tag); }
  void blocks(Sample const& s) {
    // One entity for each part, with the number of the part; those of a dimension together.
    for (int d = 0; d < 4; ++d)
      number(std::size_t(
          std::count_if(s.parts.begin(), s.parts.end(), [&](Part const& p) { return p.dimension == d; })));
    for (int d = 0; d < 4; ++d)
      for (std::size_t k = 0; k < s.parts.size(); ++k) {
        if (s.parts[k].dimension != d) continue;
        number(int(k + 1));
        for (int i = 0; i < (d || old_ ? 6 : 3); ++i) number(0.5 * i);
        number(std::size_t(s.parts[k].group != 0));
        if (s.parts[k].group) number(s.parts[k].group);
        if (d) number(std::size_t(1)), number(-7);
      }
    head("$EndEntities", "$Nodes");
    // Two blocks, the second with a parameter of its nodes.
    std::size_t const n = s.nodes.size();
    number(std::size_t(2)), number(n);
    if (!old_) number(std::size_t(10)), number(10 * n);
    for (int block = 0; block < 2; ++block) {
      std::size_t const first = block ? 1 : 0, last = block ? n : 1;
      entity(1, 9), number(block), number(last - first);
      for (std::size_t k = first; k < last && !old_; ++k) tag(10 * (k + 1));
      for (std::size_t k = first; k < last; ++k) {
        if (old_) tag(10 * (k + 1));
        for (double x : s.nodes[k]) number(x);
        if (block) number(0.125);
      }
    }
    head("$EndNodes", "$Elements");
    std::size_t all = 0;
    for (auto const& part : s.parts) all += part.elements.size();
    number(s.parts.size()), number(all);
    if (!old_) number(std::size_t(1)), number(all);
    for (std::size_t k = 0; k < s.parts.size(); ++k) {
      auto const& part = s.parts[k];
      entity(part.dimension, int(k + 1)), number(part.type), number(part.elements.size());
      for (auto const& nodes : part.elements) {
        if (!binary_) out_ += '\n';
        tag(std::size_t(next_tag()));
        for (int node : nodes) tag(std::size_t(10 * (node + 1)));
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
inline Sample triangles() {
  return {{{5, 5, 0}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
          {{0, 15, 0, {{1}}},
           {1, 1, 3, {{1, 2}}},
           {1, 1, 4, {{4, 3}, {1, 4}}},
           {2, 2, 9, {{1, 2, 3}, {1, 3, 4}}}},
          "$PhysicalNames\n2\n1 3 \"bottom\"\n2 9 \"the body\"\n$EndPhysicalNames\n"};
}
inline Sample quadrangles() {
  return {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {0, 1, 0}},
          {{2, 3, 0, {{0, 1, 4, 5}, {1, 2, 3, 4}}}, {1, 1, 1, {{0, 5}}}},
          ""};
}
inline Sample tetrahedra() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}},
          {{2, 2, 2, {{2, 1, 0}}}, {3, 4, 1, {{0, 1, 2, 3}, {1, 2, 3, 4}}}},
          "$PhysicalNames\n1\n2 2 \"floor\"\n$EndPhysicalNames\n"};
}
inline Sample hexahedron() {
  return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 2}, {1, 0, 2}, {1, 1, 2}, {0, 1, 2}},
          {{3, 5, 1, {{0, 1, 2, 3, 4, 5, 6, 7}}}, {2, 3, 8, {{4, 5, 6, 7}}}},
          ""};
}
inline Sample segments() {
  return {{{0, 0, 0}, {1, 0, 0}, {3, 0, 0}}, {{0, 15, 5, {{2}}}, {1, 1, 0, {{0, 1}, {1, 2}}}}, ""};
}

inline double volume_of(media::BodyMesh const& mesh) {
  static constexpr double parts[] = {1, 2, 1, 6, 1};
  double sum = 0;
  for (int cell = 0; cell < int(mesh.cells.size()); ++cell)
    sum += media::corner_jacobian(mesh, cell, 0).volume / parts[int(mesh.shape)];
  return sum;
}

/// A text that must be refused with these words.
inline void not_read(std::string const& text, std::string const& words) {
  auto const e = caught<media::NotAGmshFile>([&] { media::gmsh_mesh_of(text, "sample"); });
  BOOST_TEST(std::string(e.what()).find(words) != std::string::npos, e.what());
}
inline std::string replaced(std::string text, std::string const& what, std::string const& by) {
  auto const at = text.find(what);
  BOOST_REQUIRE(at != text.npos);
  return text.replace(at, what.size(), by);
}

}  // namespace actio::testing::gmsh
