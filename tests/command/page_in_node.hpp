// The script of the page of a run, on a stand-in for a browser.
#pragma once

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <cstdlib>

#include "command.hpp"

namespace command {

/// What the script of a page says of itself on a stand-in for a browser.
inline Outcome page_in_node(std::string const& page) {
  Folder const folder;
  std::string const line = "node '" ACTIO_DATA "/../tests/command/viewer_check.mjs' '" + page + "' >'" +
                           folder / "out" + "' 2>'" + folder / "err" + "'";
  int const status = std::system(line.c_str());
  return {WEXITSTATUS(status), contents(folder / "out"), contents(folder / "err")};
}
/// Whether the script of a page can be run; said where it cannot.
inline bool there_is_node() {
  bool const there = std::system("node --version >/dev/null 2>&1") == 0;
  if (!there) BOOST_TEST_MESSAGE("no node here: the script of the page is not run");
  return there;
}

/// The number after `"key":` in a JSON text.
inline double number_after(std::string const& text, std::string const& key, std::size_t from = 0) {
  auto const at = text.find("\"" + key + "\":", from);
  return at == std::string::npos ? std::nan("") : std::strtod(text.c_str() + at + key.size() + 3, nullptr);
}

}  // namespace command
