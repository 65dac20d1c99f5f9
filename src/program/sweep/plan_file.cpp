// The plan of a sweep, in its folder: the text of the scene, what is set and what is swept.
#include <fmt/format.h>

#include <fstream>
#include <iterator>

#include "program/document/document.hpp"
#include "program/sweep/sweep.hpp"

namespace actio::scene {
namespace {

std::string quoted(std::string const& text) {
  std::string out = "\"";
  for (unsigned char const c : text) {
    if (c == '"' || c == '\\')
      out += '\\', out += static_cast<char>(c);
    else if (c < 0x20 || c == 0x7f)
      out += fmt::format("\\u{:04x}", c);
    else
      out += static_cast<char>(c);
  }
  return out + '"';
}
std::string quoted(std::vector<std::string> const& texts) {
  std::string out;
  for (auto const& text : texts) out += (out.empty() ? "" : ", ") + quoted(text);
  return "[" + out + "]";
}
/// A text of many lines, as it is where TOML can hold it so.
std::string as_it_is(std::string const& text) {
  bool plain = text.find("'''") == std::string::npos && !text.ends_with('\'');
  for (unsigned char const c : text) plain = plain && (c >= 0x20 || c == '\n' || c == '\t') && c != 0x7f;
  return plain ? "'''\n" + text + "'''" : quoted(text);
}

std::vector<std::string> texts_of(toml::node_view<toml::node> node, std::string const& path) {
  std::vector<std::string> out;
  auto* const list = node.as_array();
  if (!list) throw SceneError({path}, "is no plan of a sweep: a list of texts is missing");
  for (auto&& item : *list) {
    auto* const text = item.as_string();
    if (!text) throw SceneError({path}, "is no plan of a sweep: a list holds something else than texts");
    out.push_back(text->get());
  }
  return out;
}
std::string text_of(toml::node_view<toml::node> node, std::string const& path, char const* key) {
  if (auto* const text = node.as_string()) return text->get();
  throw SceneError({path}, fmt::format("is no plan of a sweep: the text '{}' is missing", key));
}

}  // namespace

std::string SweepPlan::written() const {
  std::string out =
      "# The plan of a sweep: `actio resume` of this folder goes on with it.\nactio = \"" ACTIO_VERSION
      "\"\n";
  out += "scene = " + quoted(scene_) + "\nset = " + quoted(set_) +
         "\ntext = " + as_it_is(text_.value_or("")) + "\n";
  for (auto const& key : keys_)
    out += "\n[[over]]\nkey = " + quoted(key.key) + "\nvalues = " + quoted(key.values) + "\n";
  return out;
}

SweepPlan SweepPlan::resumed(std::string const& folder) {
  std::string const path = folder + "/sweep.toml";
  std::ifstream in(path, std::ios::binary);
  if (!in) throw FileError(path + ": cannot be read");
  std::string const all{std::istreambuf_iterator<char>(in), {}};
  SweepPlan plan;
  try {
    toml::table root = toml::parse(all, path);
    if (text_of(root["actio"], path, "actio") != ACTIO_VERSION)
      throw FileError(path + ": was written by another version of actio; this is " ACTIO_VERSION);
    plan.scene_ = text_of(root["scene"], path, "scene"), plan.text_ = text_of(root["text"], path, "text"),
    plan.set_ = texts_of(root["set"], path);
    plan.folder_ = folder;
    while (plan.folder_.size() > 1 && plan.folder_.ends_with('/')) plan.folder_.pop_back();
    auto* const over = root["over"].as_array();
    for (std::size_t k = 0; over && k < over->size(); ++k) {
      SweptKey key{
          text_of((*over)[k].as_table() ? (*(*over)[k].as_table())["key"] : toml::node_view<toml::node>(),
                  path, "key"),
          texts_of((*(*over)[k].as_table())["values"], path)};
      if (key.values.empty())
        throw SceneError({path}, "is no plan of a sweep: '" + key.key + "' has no values");
      plan.add(std::move(key), {path});
    }
  } catch (toml::parse_error const& error) {
    throw SceneError(detail::place_of(error.source(), path), shown(error.description(), 300));
  }
  return plan;
}

}  // namespace actio::scene
