// What scenes are refused with, for tests.
#pragma once

#include <boost/test/unit_test.hpp>

#include <string>

#include "program/registry/scene.hpp"

namespace actio::scene {

/// What a scene is refused with, where it is read or before its first step; empty where it is taken.
/// @param name  of the file that it would be in
inline std::string refusal(std::string const& text, std::string const& name) {
  try {
    return Scene::read(SceneFile::parse(text, name)).simulation.failure;
  } catch (Error const& error) {
    return error.what();
  }
}
/// A text with one line for another.
inline std::string changed(std::string text, std::string const& line, std::string const& instead) {
  if (line.empty()) return text;
  auto const at = text.find(line);
  BOOST_REQUIRE_MESSAGE(at != std::string::npos, "no '" << line << "' in " << text);
  return text.replace(at, line.size(), instead);
}
/// Checks that what was said has these words.
inline void check_said(std::string const& said, std::string const& words) {
  BOOST_TEST(said.find(words) != std::string::npos, "expected '" << words << "', found '" << said << "'");
}

}  // namespace actio::scene
