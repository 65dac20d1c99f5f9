#include "actio/scene/scene_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "actio/scene/nearest_name.hpp"
#include "actio/scene/scene_document.hpp"

namespace actio::scene {
namespace {

namespace fs = std::filesystem;

/// Scenes that stand where one is looked for.
std::vector<std::string> scenes_in(fs::path const& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator it(folder.empty() ? fs::path(".") : folder, error), end; !error && it != end; it.increment(error))
    if (it->path().extension() == ".toml") names.push_back(it->path().filename().string());
  return names;
}

}  // namespace

std::string SceneFile::text_of(std::string const& path) {
  std::error_code error;
  fs::file_status const status = fs::status(path, error);
  if (!fs::exists(status)) throw SceneError({path.empty() ? "''" : path}, "there is no such file" + did_you_mean(fs::path(path).filename().string(), scenes_in(fs::path(path).parent_path())));
  if (fs::is_directory(status)) throw SceneError({path}, "a scene is expected, this is a folder");
  if (!fs::is_regular_file(status)) throw SceneError({path}, "a scene is expected, this is no ordinary file");
  std::ifstream in(path, std::ios::binary);
  if (!in) throw FileError(path + ": cannot be read");
  std::string text(detail::largest_text + 1, '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (in.bad()) throw FileError(path + ": cannot be read");
  text.resize(static_cast<std::size_t>(in.gcount()));
  return text;
}

SceneFile SceneFile::read(std::string const& path, std::vector<std::string> const& overrides) { return parse(text_of(path), path, overrides); }

SceneFile SceneFile::parse(std::string_view text, std::string const& name, std::vector<std::string> const& overrides) {
  auto document = std::make_shared<detail::SceneDocument>();
  document->name = name;
  document->root = detail::parse_toml(text, name);
  auto const breaks = std::count(text.begin(), text.end(), '\n');
  document->last_line = static_cast<unsigned>(breaks) + (text.empty() || text.back() != '\n');
  for (auto const& argument : overrides) detail::apply_override(document->root, argument);
  return SceneFile(std::move(document));
}

SceneTable SceneFile::section(std::string const& name) const {
  toml::node const* const node = document_->root.get(name);
  if (node && !node->is_table()) throw SceneError(detail::place_of(node->source(), document_->name), fmt::format("{}: a section [{}] is expected, found {}", name, name, detail::described(*node)));
  return {document_, {name}};
}
void SceneFile::allow(std::vector<std::string> const& sections) const { SceneTable(document_, {}).allow(sections); }
std::string const& SceneFile::name() const { return document_->name; }

}  // namespace actio::scene
