// The reader of scenes, fed with anything: it answers with a scene or with one line that points at the place,
// and takes no time over it.
//
// The bytes are a scene; lines at the end that begin with `--set ` are overrides. Where they begin with `=`,
// the rest is a formula. A sanitiser watches, and what is checked here besides holds for every input.
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "program/base/printable.hpp"
#include "program/registry/scene.hpp"
#include "program/systems/media/place_formula.hpp"

namespace {

using namespace actio::scene;

void require(bool holds, char const* law, std::string const& about) {
  if (holds) return;
  std::fprintf(stderr, "scene_reader: %s\n%s\n", law, about.c_str());
  std::abort();
}

struct Input {
  std::string text;
  std::vector<std::string> overrides;
};

Input input_of(std::string_view bytes) {
  constexpr std::string_view mark = "--set ";
  Input input;
  for (;;) {
    std::size_t const line = bytes.rfind('\n');
    std::string_view const last = bytes.substr(line == std::string_view::npos ? 0 : line + 1);
    if (!last.starts_with(mark)) break;
    input.overrides.emplace(input.overrides.begin(), last.substr(mark.size()));
    bytes = bytes.substr(0, line == std::string_view::npos ? 0 : line);
  }
  input.text = std::string(bytes);
  return input;
}

/// What is written is read again as the same, and so is what is written of that.
void reads_back(SceneFile const& file) {
  std::string const once = file.written();
  std::string again;
  try {
    again = SceneFile::parse(once, file.name()).written();
  } catch (SceneError const& error) {
    again = error.what();
  }
  require(again == once, "what was written is not what is read from it", once + "\n-- and then --\n" + again);
}

void is_in_order(SceneError const& error) {
  std::string const what = error.what();
  require(what == printable(what), "a complaint is no line for a terminal", what);
  require(what.starts_with("scene.toml") || what.starts_with("--set "),
          "a complaint names no file and no argument", what);
  require(what.size() < 2000, "a complaint is very long", what);
}

void read_formula(std::string const& text) {
  try {
    PlaceFormula const formula(text, 3, {{"scene.toml", 1, 1}, true});
    for (double const x : {0.0, -1.5, 1e300}) {
      double value;
      formula(std::array{x, 1.0, -x}, &value);
      require(std::isfinite(value), "the value of a formula is no number", text);
    }
  } catch (SceneError const& error) {
    is_in_order(error);
  }
}

/// A scene whose size alone makes reading it as much work as its steps: products of matrices of that size, or
/// formulas at the nodes of so many cells.
bool is_work(SceneFile const& file) {
  try {
    SceneTable const system = file.section("system");
    long const n = system.has("N") ? system.integer("N", 0, 1L << 20) : 0;
    if (n > 48 && n < 100000) return true;  // what is larger is refused by the memory that it takes
    SceneTable const mesh = file.section("system.mesh");
    double cells = mesh.has("cells") ? 1 : 0;
    if (mesh.has("cells"))
      for (double const along : mesh.numbers("cells")) cells *= along;
    return cells > 2000;
  } catch (SceneError const&) {
    return false;
  }
}

void read(Input const& input) {
  try {
    SceneFile const file = SceneFile::parse(input.text, "scene.toml", input.overrides);
    reads_back(file);
    if (is_work(file)) return;
    Scene const scene = Scene::read(file);
    reads_back(scene.file);
    // The copy of a scene is a scene that is in order, and complete.
    Scene const copy = Scene::read(SceneFile::parse(scene.file.written(), "scene.toml"));
    require(copy.file.written() == scene.file.written(), "the copy of a scene is another scene",
            scene.file.written());
  } catch (SceneError const& error) {
    is_in_order(error);
  } catch (NumericsError const& error) {
    require(std::string(error.what()) == printable(error.what()), "a complaint is no line for a terminal",
            error.what());
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  std::string_view const bytes(reinterpret_cast<char const*>(data), size);
  if (bytes.starts_with('='))
    read_formula(std::string(bytes.substr(1)));
  else
    read(input_of(bytes));
  return 0;
}
