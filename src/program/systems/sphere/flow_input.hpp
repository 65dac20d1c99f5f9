// What scenes say alike of flows on the sphere and on the torus: how one begins, by coefficients, a file of
// them or a named state.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "program/document/key.hpp"

namespace actio::scene {

/// Which key of [initial] says how a flow begins.
struct FlowSource {
  std::string key;    ///< "file", "state", the name of a state whose parameters are there, or another one
  std::string state;  ///< the name of the state; empty for the others
};
/// The one that a scene has.
/// @param other     the key beside `file` and `state`
/// @param in_words  what it and `file` hold: "'harmonics', rows l, m, re, im; or ..."
/// @param names     of the states
/// @param state     names one of them
/// @throws SceneError  where there is none, or where there are two
FlowSource read_flow_source(SceneTable& initial, std::string const& other, std::string const& in_words,
                            std::vector<std::string> const& names, Key<std::string> const& state);

/// A flow out of the file that a scene names.
/// @param what     the file is, for who names no such file
/// @param make     reads a text, with the path of its file
/// @param remarks  what a user might want to know of it
template <class Make>
auto read_flow_file(SceneTable& initial, AnyKey const& key, std::string const& what,
                    std::vector<std::string>& remarks, Make const& make) {
  auto const [path, text] = initial.read_file("file", what);
  remarks.emplace_back(
      "file: the copy of the scene names it by its whole path; who repeats or resumes the run needs it "
      "there, as it is now");
  try {
    return make(text, path);
  } catch (SceneError const& error) {
    key.fail(initial, error.what());
  }
}

/// The rows of a table of coefficients.
/// @param path     of its file, for complaints
/// @param heading  "l,m,re,im": of four columns
/// @param take     told of each row and its line; it returns what is wrong with it, empty where nothing is
/// @return how many lines it has
/// @throws SceneError  with the line that is no such row, or that is refused
int read_coefficients(std::string const& text, std::string const& path, std::string const& heading,
                      std::function<std::string(double const (&row)[4], int line)> const& take);
/// What is in a file.
/// @throws FileError  where it cannot be read
std::string text_of_file(std::string const& path);

}  // namespace actio::scene
