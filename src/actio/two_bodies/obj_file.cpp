#include "actio/two_bodies/obj_file.hpp"

#include <fstream>
#include <sstream>

namespace actio::bodies {
namespace {

[[noreturn]] void refuse(int line, std::string const& why) {
  throw ShapeError("shape, line " + std::to_string(line) + ": " + why);
}

/// The index of a face's corner `a`, `a/b`, `a//c`: from 1, or from the last vertex with a minus.
int corner(std::string const& word, int vertices, int line) {
  std::size_t used = 0;
  long index = 0;
  try {
    index = std::stol(word, &used);
  } catch (std::exception const&) {
    used = 0;
  }
  if (used == 0 || (used < word.size() && word[used] != '/'))
    refuse(line, "'" + word + "' is no vertex of a face");
  long const vertex = index < 0 ? vertices + index : index - 1;
  if (index == 0 || vertex < 0 || vertex >= vertices)
    refuse(line, "vertex " + std::to_string(index) + " is named, and there are " + std::to_string(vertices) +
                     " so far");
  return static_cast<int>(vertex);
}

}  // namespace

Polyhedron<double> parse_obj(std::string_view text, double length_unit) {
  if (!(length_unit > 0) || !is_finite(length_unit))
    throw OutsideDomain("shape", "the unit of length must be positive", length_unit, 0);
  Polyhedron<double> body;
  std::istringstream lines{std::string(text)};
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "v") {
      Matrix<double, 3, 1> x;
      for (int i = 0; i < 3; ++i)
        if (!(words >> x[i]) || !is_finite(x[i])) refuse(number, "a vertex has three coordinates");
      body.vertices.push_back(x * length_unit);
    } else if (word == "f") {
      std::vector<int> corners;
      while (words >> word) corners.push_back(corner(word, static_cast<int>(body.vertices.size()), number));
      if (corners.size() < 3) refuse(number, "a face has at least three vertices");
      for (std::size_t k = 2; k < corners.size(); ++k)
        body.faces.push_back({corners[0], corners[k - 1], corners[k]});
    }
  }
  if (body.faces.empty()) throw ShapeError("shape: there is no face");
  return body;
}

Polyhedron<double> read_obj(std::string const& path, double length_unit) {
  std::ifstream file(path);
  if (!file) throw ShapeError("shape: " + path + " cannot be read");
  std::stringstream text;
  text << file.rdbuf();
  return parse_obj(text.str(), length_unit);
}

}  // namespace actio::bodies
