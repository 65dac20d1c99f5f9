#include <Eigen/Core>

#include "actio/bodies/body_catalogue.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <map>

namespace actio {
namespace {

/// Reads one body, with complaints that say where.
class BodyReader {
 public:
  BodyReader(std::string file, std::string name, toml::table const& table)
      : file_(std::move(file)), name_(std::move(name)), table_(table) {}

  Body read() const {
    static std::map<std::string, double> const units{
        {"kg m^2", 1.0}, {"slug ft^2", 4.4482216152605 * 0.3048}, {"ratio", 1.0}};
    allow_only(table_, {"title", "unit", "moments", "tensor", "points", "cylinders", "time", "spin", "source",
                        "derived"});
    auto const unit = units.find(text(table_, "unit"));
    if (unit == units.end()) fail("unit", "one of 'kg m^2', 'slug ft^2', 'ratio' is expected");

    Body body{name_,
              text(table_, "title"),
              text(table_, "source"),
              text(table_, "derived"),
              text(table_, "time"),
              unit->first == "ratio" ? "ratio" : "kg m^2",
              {},
              {},
              {},
              {}};
    int given = 0;
    std::string key;
    for (char const* k : {"moments", "tensor", "points", "cylinders"})
      if (table_.contains(k)) key = k, ++given;
    if (given != 1)
      fail("moments", "exactly one of moments, tensor, points, cylinders gives the inertia; found " +
                          std::to_string(given));
    try {
      body.principal = inertia(body, key, unit->second);
    } catch (CatalogueError const&) {
      throw;
    } catch (Error const& error) {
      fail(key, error.what());
    }
    body.spin = velocity(SO<3>{}, vector(table_, "spin"));
    return body;
  }

 private:
  /// Inertia by one of the four keys; the parts, where it is by these, are kept in the body.
  PrincipalInertia inertia(Body& body, std::string const& key, double unit) const {
    if (key == "moments")
      return {inertia_from_moments<double>(vector(table_, key) * unit), Eigen::Matrix3d::Identity()};
    if (key == "tensor") {
      auto const* rows = table_[key].as_array();
      if (!rows || rows->size() != 3) fail(key, "three rows are expected");
      Eigen::Matrix3d tensor;
      for (int i = 0; i < 3; ++i) tensor.row(i) = vector(*rows->get(i), key).transpose();
      return principal_inertia(tensor * unit);
    }
    if (key == "points") {
      each(key, {"mass", "at"}, [&](toml::table const& t) {
        body.points.push_back({positive(t, "mass"), vector(t, "at")});
      });
      body.points = from_centre_of_mass(std::move(body.points));
      return principal_inertia(inertia_tensor(body.points) * unit);
    }
    each(key, {"mass", "radius", "length", "at", "along"}, [&](toml::table const& t) {
      body.cylinders.push_back({positive(t, "mass"), positive(t, "radius"), positive(t, "length"),
                                vector(t, "at"), vector(t, "along")});
      if (body.cylinders.back().along.stableNorm() == 0) fail("along", "a direction is expected");
    });
    body.cylinders = from_centre_of_mass(std::move(body.cylinders));
    return principal_inertia(inertia_tensor(body.cylinders) * unit);
  }

  void allow_only(toml::table const& table, std::initializer_list<char const*> keys) const {
    for (auto const& entry : table)
      if (std::none_of(keys.begin(), keys.end(), [&](auto key) { return entry.first.str() == key; }))
        fail(std::string(entry.first.str()), "unknown key");
  }
  template <class Visit>
  void each(std::string const& key, std::initializer_list<char const*> keys, Visit const& visit) const {
    auto const* list = table_[key].as_array();
    if (!list || list->empty()) fail(key, "a list of parts is expected");
    for (auto const& part : *list) {
      if (!part.is_table()) fail(key, "each part is a table");
      allow_only(*part.as_table(), keys);
      visit(*part.as_table());
    }
  }
  std::string text(toml::table const& table, std::string const& key) const {
    auto const value = table[key].value<std::string>();
    if (!value) fail(key, "a text is expected");
    return *value;
  }
  double positive(toml::table const& table, std::string const& key) const {
    auto const value = table[key].value<double>();
    if (!value || !std::isfinite(*value) || !(*value > 0)) fail(key, "a positive number is expected");
    return *value;
  }
  Eigen::Vector3d vector(toml::table const& table, std::string const& key) const {
    auto const* node = table.get(key);
    if (!node) fail(key, "is missing");
    return vector(*node, key);
  }
  Eigen::Vector3d vector(toml::node const& node, std::string const& key) const {
    auto const* list = node.as_array();
    if (!list || list->size() != 3) fail(key, "three numbers are expected");
    Eigen::Vector3d v;
    for (int i = 0; i < 3; ++i) {
      auto const value = list->get(i)->value<double>();
      if (!value) fail(key, "three numbers are expected");
      if (!std::isfinite(*value)) fail(key, "a NaN or an infinity where a finite number is needed");
      v[i] = *value;
    }
    return v;
  }
  [[noreturn]] void fail(std::string const& key, std::string const& what) const {
    throw CatalogueError(file_, name_, key, what);
  }

  std::string file_, name_;
  toml::table const& table_;
};

}  // namespace

std::vector<Body> parse_bodies(std::string_view text, std::string const& file) {
  toml::table table;
  try {
    table = toml::parse(text, file);
  } catch (toml::parse_error const& error) {
    throw CatalogueError(
        file, "", "",
        "line " + std::to_string(error.source().begin.line) + ": " + std::string(error.description()));
  }
  std::vector<Body> bodies;
  for (auto const& entry : table) {
    std::string const name(entry.first.str());
    if (!entry.second.is_table()) throw CatalogueError(file, "", name, "a table is expected: [" + name + "]");
    bodies.push_back(BodyReader(file, name, *entry.second.as_table()).read());
  }
  if (bodies.empty()) throw CatalogueError(file, "", "", "there is no body in it");
  return bodies;
}
std::vector<Body> read_bodies(std::string const& file) {
  std::ifstream in(file, std::ios::binary);
  if (!std::filesystem::is_regular_file(file) || !in)
    throw CatalogueError(file, "", "", "there is no such file");
  return parse_bodies(std::string(std::istreambuf_iterator<char>(in), {}), file);
}

Body read_body(std::string const& file, std::string const& name) {
  std::string names;
  for (auto const& body : read_bodies(file)) {
    if (body.name == name) return body;
    names += " " + body.name;
  }
  throw CatalogueError(file, name, "", "there is no such body; there are:" + names);
}

}  // namespace actio
