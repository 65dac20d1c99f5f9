#include "program/run/checkpoint.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "program/base/error.hpp"
#include "program/base/whole_file.hpp"
#include "program/document/input_files.hpp"
#include "program/run/run.hpp"

namespace actio::scene {
namespace {

// Another version may make other digits of the same scene.
constexpr std::string_view heading = "actio checkpoint 4, " ACTIO_VERSION "\n";
/// What to do where a checkpoint is of no use.
constexpr char const* way_out = "; without it the run starts anew: remove it, then actio resume does so";

std::string as_bytes(std::uint64_t x) { return {reinterpret_cast<char const*>(&x), sizeof x}; }

}  // namespace

void write_whole_file(std::string const& path, std::string_view content, bool durable) {
  WholeFile file(path);
  file.write(content).name(durable);
}

std::string what_determines(SceneFile const& scene) {
  SceneFile const copy = SceneFile::parse(scene.written(), scene.name());
  copy.section("scene").set("title", "");
  copy.section("output").set("plots", false);
  if (SceneTable run = copy.section("run"); !run.has("at")) run.set("until", 0.0);
  return copy.written();
}

void write_checkpoint(std::string const& path, std::string const& scene, std::string const& state,
                      bool durable) {
  // The state may be large: it is not copied behind its head.
  WholeFile file(path);
  file.write(heading)
      .write(as_bytes(fingerprint_of(scene)))
      .write(as_bytes(fingerprint_of(state)))
      .write(state)
      .name(durable);
}

std::string read_checkpoint(std::string const& path, std::optional<std::string> const& scene) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw FileError(path + ": cannot be read");
  std::string bytes{std::istreambuf_iterator<char>(in), {}};
  std::size_t const start = heading.size() + 16;
  if (!bytes.starts_with(heading.substr(0, heading.find("4,"))))
    throw FileError(path + ": is damaged, or no checkpoint" + way_out);
  if (!bytes.starts_with(heading))
    throw FileError(path + ": was written by another version of actio; this is " ACTIO_VERSION + way_out);
  if (bytes.size() < start) throw FileError(path + ": is damaged: it ends too early" + way_out);
  if (scene && bytes.substr(heading.size(), 8) != as_bytes(fingerprint_of(*scene)))
    throw FileError(
        path +
        ": belongs to another scene; scene.toml beside it was changed since, or the checkpoint is damaged" +
        way_out);
  std::string const sum = bytes.substr(heading.size() + 8, 8);
  bytes.erase(0, start);
  if (sum != as_bytes(fingerprint_of(bytes))) throw FileError(path + ": is damaged" + way_out);
  return bytes;
}

void refuse_changed_inputs(std::string const& folder) {
  std::string const path = folder + "/checkpoint";
  CheckpointStream stream(read_checkpoint(path, {}));
  InputFiles files;
  try {
    remember(stream, files);
  } catch (Error const& error) {
    throw FileError(path + ": is damaged: " + error.what());
  }
  refuse_changed(files);
}

double checkpoint_interval() {
  char const* const text = std::getenv("ACTIO_CHECKPOINT_SECONDS");
  if (!text) return RunOptions{}.checkpoint_interval;
  char* end = nullptr;
  double const seconds = std::strtod(text, &end);
  if (end == text || *end || !(seconds >= 0))
    throw SceneError({"ACTIO_CHECKPOINT_SECONDS"},
                     fmt::format("a number of seconds is expected, found '{}'", text));
  return seconds;
}

}  // namespace actio::scene
