// The catalogue of bodies: data/bodies.toml, read and checked.
//
// A body gives its inertia as principal moments, as a tensor, as point masses or as solid cylinders, from which it is computed.
#pragma once

#include <toml++/toml.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "actio/rigid_body/inertia.hpp"

namespace actio {

/// An entry of a catalogue that cannot be used: says which file, body and key.
struct CatalogueError : Error {
  /// @param what  what is wrong; `body` and `key` may be empty
  CatalogueError(std::string const& file, std::string const& body, std::string const& key, std::string const& what)
      : Error(file + (body.empty() ? "" : ": [" + body + "]") + (key.empty() ? "" : " " + key) + ": " + what) {}
};

/// A body of the catalogue.
struct Body {
  std::string name;                 ///< its key in the catalogue
  std::string title;                ///< for people
  std::string source;               ///< where the figures are from
  std::string derived;              ///< what was computed from them, and how; may be empty
  std::string time;                 ///< unit of time of `spin`
  bool ratio = false;               ///< only ratios of the moments are known; otherwise they are in kg m^2
  Inertia<3> inertia;               ///< along the principal axes
  Eigen::Matrix3d axes;             ///< principal axes in the frame of the catalogue, as columns
  Velocity<SO<3>, double> spin;     ///< body velocity at the start, along the principal axes; rad per unit of time
};

/// A point mass; kg, m.
struct PointMass {
  double mass;         ///< kg
  Eigen::Vector3d at;  ///< place, m
};
/// A solid cylinder of uniform density with its centre at `at`; kg, m.
struct Cylinder {
  double mass;            ///< kg
  double radius;          ///< m
  double length;          ///< m
  Eigen::Vector3d at;     ///< its centre, m
  Eigen::Vector3d along;  ///< direction of its axis, of any length
};

/// The tensor of inertia of point masses about the origin.
inline Eigen::Matrix3d inertia_tensor(PointMass const& p) {
  return p.mass * (p.at.squaredNorm() * Eigen::Matrix3d::Identity() - p.at * p.at.transpose());
}
/// The tensor of inertia of a cylinder about the origin: \f$\tfrac12mr^2\f$ about its axis, \f$\tfrac1{12}m(3r^2+l^2)\f$ across, and its centre as a point mass.
inline Eigen::Matrix3d inertia_tensor(Cylinder const& c) {
  Eigen::Vector3d const axis = c.along.stableNormalized();
  double const about = c.mass * c.radius * c.radius / 2, across = c.mass * (3 * c.radius * c.radius + c.length * c.length) / 12;
  return across * Eigen::Matrix3d::Identity() + (about - across) * axis * axis.transpose() + inertia_tensor(PointMass{c.mass, c.at});
}
/// The tensor of inertia of several parts about their common centre of mass.
template <class Part>
Eigen::Matrix3d inertia_about_centre(std::vector<Part> parts) {
  double mass = 0;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  for (auto const& part : parts) mass += part.mass, centre += part.mass * part.at;
  centre /= mass;
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (auto& part : parts) {
    part.at -= centre;
    sum += inertia_tensor(part);
  }
  return (sum + sum.transpose()) / 2;
}

namespace detail {

/// Reads one body, with complaints that say where.
class BodyReader {
 public:
  BodyReader(std::string file, std::string name, toml::table const& table) : file_(std::move(file)), name_(std::move(name)), table_(table) {}

  Body read() const {
    static std::map<std::string, double> const units{{"kg m^2", 1.0}, {"slug ft^2", 4.4482216152605 * 0.3048}, {"ratio", 1.0}};
    allow_only(table_, {"title", "unit", "moments", "tensor", "points", "cylinders", "time", "spin", "source", "derived"});
    auto const unit = units.find(text(table_, "unit"));
    if (unit == units.end()) fail("unit", "one of 'kg m^2', 'slug ft^2', 'ratio' is expected");

    Body body{name_, text(table_, "title"), text(table_, "source"), text(table_, "derived"), text(table_, "time"), unit->first == "ratio", {}, {}, {}};
    int given = 0;
    std::string key;
    for (char const* k : {"moments", "tensor", "points", "cylinders"})
      if (table_.contains(k)) key = k, ++given;
    if (given != 1) fail("moments", "exactly one of moments, tensor, points, cylinders gives the inertia; found " + std::to_string(given));
    try {
      auto const principal = inertia(key, unit->second);
      body.inertia = principal.inertia;
      body.axes = principal.axes;
    } catch (CatalogueError const&) {
      throw;
    } catch (Error const& error) {
      fail(key, error.what());
    }
    body.spin = velocity(SO<3>{}, (body.axes.transpose() * vector(table_, "spin")).eval());
    return body;
  }

 private:
  PrincipalInertia inertia(std::string const& key, double unit) const {
    if (key == "moments") return {inertia_from_moments<double>(vector(table_, key) * unit), Eigen::Matrix3d::Identity()};
    if (key == "tensor") {
      auto const* rows = table_[key].as_array();
      if (!rows || rows->size() != 3) fail(key, "three rows are expected");
      Eigen::Matrix3d tensor;
      for (int i = 0; i < 3; ++i) tensor.row(i) = vector(*rows->get(i), key).transpose();
      return principal_inertia(tensor * unit);
    }
    if (key == "points") {
      std::vector<PointMass> parts;
      each(key, {"mass", "at"}, [&](toml::table const& t) { parts.push_back({positive(t, "mass"), vector(t, "at")}); });
      return principal_inertia(inertia_about_centre(parts) * unit);
    }
    std::vector<Cylinder> parts;
    each(key, {"mass", "radius", "length", "at", "along"}, [&](toml::table const& t) {
      parts.push_back({positive(t, "mass"), positive(t, "radius"), positive(t, "length"), vector(t, "at"), vector(t, "along")});
      if (parts.back().along.stableNorm() == 0) fail("along", "a direction is expected");
    });
    return principal_inertia(inertia_about_centre(parts) * unit);
  }

  void allow_only(toml::table const& table, std::initializer_list<char const*> keys) const {
    for (auto const& entry : table)
      if (std::none_of(keys.begin(), keys.end(), [&](auto key) { return entry.first.str() == key; })) fail(std::string(entry.first.str()), "unknown key");
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
  [[noreturn]] void fail(std::string const& key, std::string const& what) const { throw CatalogueError(file_, name_, key, what); }

  std::string file_, name_;
  toml::table const& table_;
};

}  // namespace detail

/// All bodies of a catalogue that is in a text, in the order of their names.
/// @param file  what it is called in complaints
/// @throws CatalogueError  where the text is no TOML or holds no body, or an entry is missing, unknown, no number, or no inertia of a body
inline std::vector<Body> parse_bodies(std::string_view text, std::string const& file) {
  toml::table table;
  try {
    table = toml::parse(text, file);
  } catch (toml::parse_error const& error) {
    throw CatalogueError(file, "", "", "line " + std::to_string(error.source().begin.line) + ": " + std::string(error.description()));
  }
  std::vector<Body> bodies;
  for (auto const& entry : table) {
    std::string const name(entry.first.str());
    if (!entry.second.is_table()) throw CatalogueError(file, "", name, "a table is expected: [" + name + "]");
    bodies.push_back(detail::BodyReader(file, name, *entry.second.as_table()).read());
  }
  if (bodies.empty()) throw CatalogueError(file, "", "", "there is no body in it");
  return bodies;
}
/// The same from a file.
/// @throws CatalogueError  where it cannot be read, too
inline std::vector<Body> read_bodies(std::string const& file) {
  std::ifstream in(file, std::ios::binary);
  if (!std::filesystem::is_regular_file(file) || !in) throw CatalogueError(file, "", "", "there is no such file");
  return parse_bodies(std::string(std::istreambuf_iterator<char>(in), {}), file);
}

/// The body with that name.
/// @throws CatalogueError  where there is none, with the names there are
inline Body read_body(std::string const& file, std::string const& name) {
  std::string names;
  for (auto const& body : read_bodies(file)) {
    if (body.name == name) return body;
    names += " " + body.name;
  }
  throw CatalogueError(file, name, "", "there is no such body; there are:" + names);
}

}  // namespace actio
