#include "program/document/file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "actio/numbers/nearest_name.hpp"
#include "program/document/document.hpp"
#include "program/document/scenes.hpp"

namespace actio::scene {
namespace {

namespace fs = std::filesystem;

/// Whether a path is a name alone, as those of the scenes that the program carries.
bool is_plain_name(fs::path const& path) {
  return !path.empty() && !path.has_parent_path() && !path.has_extension();
}

/// The text of the scene that the program carries under that name, where no file has it.
std::string_view const* carried_text(std::string const& path) {
  std::error_code none;
  NamedScene const* const carried = is_plain_name(path) ? find_scene(path) : nullptr;
  return carried && !fs::is_regular_file(path, none) ? &carried->text : nullptr;
}

/// Scenes that stand where one is looked for, and where it is a name alone, those that the program carries.
std::vector<std::string> scenes_in(fs::path const& folder, bool carried) {
  std::vector<std::string> names;
  if (carried)
    for (auto const& scene : carried_scenes()) names.push_back(scene.name);
  std::error_code error;
  for (fs::directory_iterator it(folder.empty() ? fs::path(".") : folder, error), end; !error && it != end;
       it.increment(error))
    if (it->path().extension() == ".toml") names.push_back(it->path().filename().string());
  return names;
}

/// What could be run instead of a file that is not there.
std::string scene_instead(fs::path const& path) {
  std::string const near =
      did_you_mean(path.filename().string(), scenes_in(path.parent_path(), is_plain_name(path)));
  std::string const name = path.stem().string();
  if (path.extension() != ".toml" || !find_scene(name))
    return near.empty() && is_plain_name(path) ? " (scenes that come with actio: actio list scenes)" : near;
  return fmt::format(
      "; a scene of that name comes with actio: 'actio run {0}' runs it, 'actio new {0} --out {1}' writes it",
      name, path.string());
}

}  // namespace

std::string SceneFile::text_of(std::string const& path) {
  if (auto const* const text = carried_text(path)) return std::string(*text);
  std::error_code error;
  fs::file_status const status = fs::status(path, error);
  if (!fs::exists(status))
    throw SceneError({path.empty() ? "''" : path}, "there is no such file" + scene_instead(path));
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

SceneFile SceneFile::read(std::string const& path, std::vector<std::string> const& overrides) {
  return parse(text_of(path), path, overrides);
}

SceneFile SceneFile::parse(std::string_view text, std::string const& name,
                           std::vector<std::string> const& overrides) {
  auto document = std::make_shared<detail::SceneDocument>();
  document->name = name;
  document->root = detail::parse_toml(text, name);
  auto const breaks = std::count(text.begin(), text.end(), '\n');
  document->last_line = static_cast<unsigned>(breaks) + (text.empty() || text.back() != '\n');
  for (auto const& argument : overrides) detail::apply_override(document->root, argument);
  return SceneFile(std::move(document));
}

SceneFile SceneFile::copy() const { return SceneFile(std::make_shared<detail::SceneDocument>(*document_)); }

SceneTable SceneFile::section(std::string const& name) const {
  std::vector<std::string> path{name.substr(0, name.find('.'))};
  for (std::size_t dot = name.find('.'); dot != std::string::npos;) {
    std::size_t const next = name.find('.', dot + 1);
    path.push_back(name.substr(dot + 1, next - dot - 1));
    dot = next;
  }
  toml::node const* const node = document_->root.get(path.front());
  if (node && !node->is_table())
    throw SceneError(
        detail::place_of(node->source(), document_->name),
        fmt::format("{0}: a section [{0}] is expected, found {1}", path.front(), detail::described(*node)));
  return {document_, path};
}
void SceneFile::allow(std::vector<std::string> const& sections) const {
  SceneTable(document_, {}).allow(sections);
}
std::string const& SceneFile::name() const { return document_->name; }
InputFiles const& SceneFile::inputs() const { return document_->inputs; }

std::pair<std::string, std::string> SceneTable::read_file(std::string const& key, std::string const& what) {
  std::string const given = text(key);
  std::error_code error;
  fs::path const beside = fs::path(document_->name).parent_path() / given,
                 whole = fs::absolute(beside, error);
  std::string const path =
      fs::path(given).is_absolute() ? given : (error ? beside : whole.lexically_normal()).string();
  if (!fs::exists(path, error)) fail(key, fmt::format("{}: {}: there is no such file", key, path));
  if (!fs::is_regular_file(path, error))
    fail(key, fmt::format("{}: {} is expected, {} is {}", key, what, path,
                          fs::is_directory(path, error) ? "a folder" : "no ordinary file"));
  std::ifstream in(path, std::ios::binary);
  std::string content{std::istreambuf_iterator<char>(in), {}};
  if (!in || in.bad()) fail(key, fmt::format("{}: {}: the file cannot be read", key, path));
  auto& inputs = document_->inputs;
  std::erase_if(inputs, [&](InputFile const& before) { return before.path == path; });
  inputs.push_back({path, content.size(), fingerprint_of(content)});
  if (path != given) set(key, path);
  return {path, std::move(content)};
}

}  // namespace actio::scene
