// A key of a scene as one object: it declares what the key may hold, reads it, writes its default back and
// documents it.
//
//     struct SphereKeys : KeyTable {
//       Key<double> rotation =
//           key("rotation", number.in("1/time"), 0, "The angular velocity about the pole.", "1.0");
//     } const sphere_keys{{"system"}};
//     ...
//     double const rotation = sphere_keys.rotation.read(file);
//
// A key is made by the table that holds it, which keeps its record: what can be read is what is listed.
#pragma once

#include <fmt/format.h>

#include <functional>
#include <limits>
#include <type_traits>

#include "program/document/file.hpp"

namespace actio::scene {

/// The record of a key of a scene. What a scene may hold is read from these (registry/keys.hpp).
struct Parameter {
  std::string key;      ///< with its section: "system.body"
  std::string expects;  ///< "three numbers, or a symmetric 3 by 3 matrix"
  /// what stands where it is left out; "needed"; "or KEY" where that other key excludes it
  std::string fallback;
  std::string meaning;                    ///< a sentence or two
  std::string unit = "";                  ///< in words: "mass x length^2"; empty where there is none
  std::string example = "";               ///< a value, as a scene writes it
  std::vector<std::string> allowed = {};  ///< the words that it may be, where these are few
};

/// What a key may hold: how that is called, and how it is read from a table.
template <class T>
struct Pattern {
  std::string expects;                                                ///< "a number > 0"
  std::function<T(SceneTable const&, std::string const& name)> read;  ///< refuses what is none
  std::vector<std::string> allowed = {};                              ///< the words, where these are few
  std::string unit = "";                                              ///< empty where there is none

  /// The same in other words, where the reader asks for more.
  Pattern called(std::string words) const { return {std::move(words), read, allowed, unit}; }
  /// The same, measured in this unit.
  Pattern in(std::string of) const { return {expects, read, allowed, std::move(of)}; }
};

/// What keys often hold: names that every table of keys knows.
struct Patterns {
  using Words = std::vector<std::string>;  ///< that are allowed

  inline static Pattern<double> const number{"a number", &SceneTable::number};                ///< finite
  inline static Pattern<double> const positive{"a number > 0", &SceneTable::positive};        ///< finite
  inline static Pattern<bool> const truth{"true or false", &SceneTable::boolean};             ///< either
  inline static Pattern<std::string> const text{"a text", &SceneTable::text};                 ///< any
  inline static Pattern<Eigen::Vector3d> const vector{"three numbers", &SceneTable::vector};  ///< finite
  /// A list of finite numbers; `size` of them, or any number where it is negative.
  static Pattern<std::vector<double>> numbers(std::string expects, long size = -1) {
    return {std::move(expects), [=](auto& table, auto& name) { return table.numbers(name, size); }};
  }
  /// Rows of finite numbers.
  static Pattern<Eigen::MatrixXd> rows(std::string expects, long size) {
    return {std::move(expects), [=](auto& table, auto& name) { return table.rows(name, size); }};
  }
  /// A whole number within [least, most].
  template <class T = int>
  static Pattern<T> whole(std::string expects, long least, long most = std::numeric_limits<T>::max()) {
    return {std::move(expects),
            [=](auto& table, auto& name) { return static_cast<T>(table.integer(name, least, most)); }};
  }
  /// One of some words: `SceneTable::choice`.
  static Pattern<std::string> one_of(std::string what, Words words, std::string see = "") {
    return {"a text", [=](auto& table, auto& name) { return table.choice(name, what, words, see); }, words};
  }
  /// Some of them, at least one: `SceneTable::choices`.
  static Pattern<Words> some_of(std::string what, Words words, std::string see = "") {
    return {"a list of texts", [=](auto& table, auto& name) { return table.choices(name, what, words, see); },
            words};
  }
};

/// What stands where a key is left out, in words: the default depends on other things, or there is none.
struct LeftOut {
  std::string words;  ///< as `Parameter` has them
};
inline LeftOut const needed{"needed"};  ///< nothing does

/// A key that its reader knows how to read: one of several forms, or a table.
class AnyKey {
 public:
  /// @param key  with its table: "system.body"
  explicit AnyKey(std::string const& key) : table_(key, 0, key.rfind('.')), name_(key, table_.size() + 1) {}

  std::string const& name() const { return name_; }  ///< in its table
  /// The table of a scene that holds it; or one that is known to do so.
  SceneTable in(SceneFile const& file) const { return file.section(table_); }
  SceneTable const& in(SceneTable const& table) const { return table; }  ///< \copydoc in
  /// The table that it is.
  SceneTable table(auto const& scene) const { return in(scene).inside(name_); }
  /// Whether it is there.
  bool given(auto const& scene) const { return in(scene).has(name_); }
  /// @throws SceneError  at its place, with its name first
  [[noreturn]] void fail(auto const& scene, std::string const& what) const {
    in(scene).fail(name_, name_ + ": " + what);
  }
  /// @throws SceneError  at the place of one of its items, with its name first
  [[noreturn]] void fail_at(auto const& scene, std::size_t item, std::string const& what) const {
    throw SceneError(in(scene).place(name_, item), name_ + ": " + what);
  }

 private:
  std::string table_, name_;
};

/// A key that holds a T.
template <class T>
class Key : public AnyKey {
 public:
  /// @param otherwise  what stands where it is left out; none: what is read is there, or told by the reader
  Key(std::string const& key, Pattern<T> pattern, std::optional<T> otherwise)
      : AnyKey(key), pattern_(std::move(pattern)), otherwise_(std::move(otherwise)) {}

  /// Its value; its default, written back, where it is left out.
  /// @throws SceneError  where it is none, or where it is needed and not there; so do those that follow
  T read(auto const& scene) const { return read(scene, pattern_); }
  /// The same with a pattern that depends on other things.
  T read(auto const& scene, Pattern<T> const& pattern) const {
    if (otherwise_) return read_or(scene, *otherwise_, pattern);
    return pattern.read(in(scene), name());
  }
  /// Its value; this one, written back, where it is left out.
  T read_or(auto const& scene, T const& otherwise) const { return read_or(scene, otherwise, pattern_); }
  /// \copydoc read_or
  T read_or(auto const& scene, T const& otherwise, Pattern<T> const& pattern) const {
    if (!given(scene)) write(scene, otherwise);
    return pattern.read(in(scene), name());
  }
  /// Its value where it is given.
  std::optional<T> find(auto const& scene) const {
    return given(scene) ? std::optional<T>(pattern_.read(in(scene), name())) : std::nullopt;
  }
  /// Writes a default back.
  void write(auto const& scene, T const& value) const {
    SceneTable table = in(scene);
    if constexpr (std::is_same_v<T, int>)
      table.set(name(), long{value});
    else
      table.set(name(), value);
  }

 private:
  Pattern<T> pattern_;
  std::optional<T> otherwise_;
};

/// A default, as a scene writes it.
std::string as_written(std::string const& value);
/// \copydoc as_written
std::string as_written(std::vector<std::string> const& value);
/// \copydoc as_written
template <class Number>
std::string as_written(Number value) { return fmt::format("{}", value); }

/// The keys of a table of a scene, with their records: a struct whose members are the keys.
class KeyTable : public Patterns {
 public:
  /// A section, "run", or more keys of a table.
  KeyTable(std::string name) : name_(std::move(name)) {}
  /// Those of several tables.
  KeyTable(std::vector<Parameter> records) : records_(std::move(records)) {}
  /// A table that is a key itself.
  KeyTable(std::string name, LeftOut const& fallback, std::string const& meaning, std::string const& example,
           std::string const& expects = "a table", std::string const& unit = "")
      : name_(std::move(name)), records_{{name_, expects, fallback.words, meaning, unit, example}} {}

  /// With its section: "initial.attitude".
  std::string const& name() const { return name_; }
  /// In the order of the members.
  std::vector<Parameter> const& records() const { return records_; }

 protected:
  /// A key with a default.
  template <class T>
  Key<T> key(std::string const& name, Pattern<T> const& pattern, std::type_identity_t<T> const& otherwise,
             std::string const& meaning, std::string const& example) {
    return {
        add({name, pattern.expects, as_written(otherwise), meaning, pattern.unit, example, pattern.allowed}),
        pattern, otherwise};
  }
  /// A key whose default depends on other things, or that has none.
  template <class T>
  Key<T> key(std::string const& name, Pattern<T> const& pattern, LeftOut const& fallback,
             std::string const& meaning, std::string const& example) {
    return {add({name, pattern.expects, fallback.words, meaning, pattern.unit, example, pattern.allowed}),
            pattern,
            {}};
  }
  /// A key that its reader knows how to read.
  AnyKey key(std::string const& name, std::string const& expects, LeftOut const& fallback,
             std::string const& meaning, std::string const& example, std::string const& unit = "",
             Words const& allowed = {}) {
    return AnyKey(add({name, expects, fallback.words, meaning, unit, example, allowed}));
  }

 private:
  std::string const& add(Parameter record);  // its key, with the name of the table

  std::string name_;
  std::vector<Parameter> records_;
};

/// The records of some tables.
std::vector<Parameter> records_of(std::initializer_list<KeyTable> tables);

}  // namespace actio::scene
