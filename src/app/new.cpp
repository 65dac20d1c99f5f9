// actio new: a scene to begin with, on standard output or in a new file.
#include <fmt/format.h>

#include <fcntl.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <cstring>

#include "actio/numbers/nearest_name.hpp"
#include "app/catalogue.hpp"
#include "app/commands.hpp"
#include "program/base/printable.hpp"
#include "program/catalogue/bodies.hpp"
#include "program/document/scenes.hpp"
#include "program/registry/scene_template.hpp"

namespace actio::app {

using namespace scene;

namespace {

Body const& body_named(std::string const& name) {
  Body const* const body = find_body(name);
  if (!body)
    throw SceneError({"actio new"}, fmt::format("unknown body '{}'{} (actio list bodies)", shown(name),
                                                did_you_mean(name, names_of_bodies())));
  return *body;
}

/// The first system with that key.
System const& system_that_takes(std::string const& key) {
  return *std::ranges::find_if(systems(), [&](System const& system) {
    return std::ranges::find(system.parameters, key, &Parameter::key) != system.parameters.end();
  });
}

/// The scene that a name and a body stand for: a system, otherwise a scene that the program carries,
/// otherwise a body of the library.
std::string scene_of(std::string const& name, std::string const& body) {
  if (System const* const system = find_system(name))
    return scene_template(*system, body.empty() ? nullptr : &body_named(body));
  if (!body.empty())
    throw SceneError({"actio new"},
                     "--body belongs to a system, as in actio new rigid_body --body " + shown(body));
  if (NamedScene const* const carried = find_scene(name)) return std::string(carried->text);
  if (Body const* const of = find_body(name)) return scene_template(system_that_takes("system.body"), of);
  std::vector<std::string> known;
  for (auto const* const list : {"systems", "scenes", "bodies"})
    for (auto const& one : names_in(list)) known.push_back(one);
  throw SceneError({"actio new"}, fmt::format("unknown name '{}'{} (actio list systems|scenes|bodies)",
                                              shown(name), did_you_mean(name, known)));
}

/// Writes a file that was not there.
void write_new(std::string const& path, std::string const& text) {
  int const file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (file < 0 && errno == EEXIST)
    throw SceneError({path}, "there is such a file already, and it is not replaced; --out names another");
  std::size_t at = 0;
  bool well = file >= 0;
  while (well && at < text.size()) {
    ssize_t const written = ::write(file, text.data() + at, text.size() - at);
    if (written < 0 && errno == EINTR) continue;
    well = written > 0;
    if (well) at += static_cast<std::size_t>(written);
  }
  int const error = errno;
  if (file >= 0) well = ::close(file) == 0 && well;
  if (!well) throw FileError(path + ": cannot be written: " + std::strerror(error));
}

}  // namespace

int make_new(NewArguments const& arguments) {
  std::string const text = scene_of(arguments.name, arguments.body);
  if (arguments.out.empty() || arguments.out == "-")
    fmt::print("{}", text);
  else
    write_new(arguments.out, text);
  return 0;
}

}  // namespace actio::app
