// A scene as it is written: a TOML file, with overrides from the command line, read key by key with
// complaints that point at the place.
//
//     SceneFile file = SceneFile::read("apophis.toml", {"method.step=0.5"});
//     SceneTable run = file.section("run");
//     run.allow({"until", "every", "at"});
//     double const until = run.positive("until");
//
// The reader of a key says what it may hold; an unknown key is refused with the nearest known name. Defaults
// are written back, so that the scene can be repeated from its copy.
#pragma once

#include <Eigen/Core>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "program/base/error.hpp"
#include "program/document/input_files.hpp"

namespace actio::scene {

namespace detail {
struct SceneDocument;
}

/// One table of a scene.
class SceneTable {
 public:
  /// @param path  names of the tables that lead to it, from the top
  SceneTable(std::shared_ptr<detail::SceneDocument> document, std::vector<std::string> path)
      : document_(std::move(document)), path_(std::move(path)) {}

  /// Refuses every key but these.
  /// @param more  what there is to say of a key that is refused, for instance where it is known; where it
  ///              says nothing the nearest of the keys is told, and all of them
  /// @throws SceneError  at the first other key, with the nearest of these
  void allow(std::vector<std::string> const& keys,
             std::function<std::string(std::string const& key)> const& more = {}) const;
  /// Whether the key is there.
  bool has(std::string const& key) const;
  /// Its keys, in the order of the file.
  std::vector<std::string> keys() const;
  /// `system.mesh`
  std::string name() const;

  /// A finite number, whole or not.
  /// @throws SceneError  where it is missing, no number, NaN or infinite. So do all that follow, each for its
  ///                     kind.
  double number(std::string const& key) const;
  /// A number > 0.
  double positive(std::string const& key) const;
  /// A whole number within [least, most].
  long integer(std::string const& key, long least, long most) const;
  bool boolean(std::string const& key) const;      ///< true or false
  std::string text(std::string const& key) const;  ///< a text
  /// A text that is one of `allowed`; `what` it is called in the complaint, `see` where they are listed.
  std::string choice(std::string const& key, std::string const& what, std::vector<std::string> const& allowed,
                     std::string const& see = "") const;
  /// A list of texts, each one of `allowed`, none twice, at least one.
  std::vector<std::string> choices(std::string const& key, std::string const& what,
                                   std::vector<std::string> const& allowed,
                                   std::string const& see = "") const;
  /// A list of texts.
  std::vector<std::string> texts(std::string const& key) const;
  /// A list of formulas: texts, or finite numbers, which are theirs to the last digit.
  std::vector<std::string> formulas(std::string const& key) const;
  /// A formula: a text, or a finite number.
  std::string formula(std::string const& key) const;
  /// A list of finite numbers; `size` of them, or any number where it is negative.
  std::vector<double> numbers(std::string const& key, long size = -1) const;
  /// A list of `size` times true or false.
  std::vector<bool> booleans(std::string const& key, long size) const;
  /// A list of three finite numbers.
  Eigen::Vector3d vector(std::string const& key) const;
  /// A list of rows, n by n.
  Eigen::MatrixXd matrix(std::string const& key, long n) const;
  /// A list of rows of `size` finite numbers each; any number of rows, none as well. `place(key, row)` is
  /// that of a row.
  Eigen::MatrixXd rows(std::string const& key, long size) const;
  /// A list of square matrices of one size, each a list of rows; at least one.
  std::vector<Eigen::MatrixXd> matrices(std::string const& key) const;
  /// Whether the value is a list whose first item is a list.
  bool is_matrix(std::string const& key) const;
  /// Whether the value is a text.
  bool is_text(std::string const& key) const;
  /// Whether the value is a table.
  bool is_table(std::string const& key) const;
  /// What a value is, for complaints: `'fast' (a text)`, `a list of 2`.
  std::string found(std::string const& key) const;
  /// The table that the value is. Where it is something else, what is read from it is refused at its place.
  SceneTable inside(std::string const& key) const;

  /// Reads the file that a text names, by a path beside the scene: every file that a scene names is read
  /// here. The scene keeps in mind what was in it (`SceneFile::inputs`), and its copy names it by its whole
  /// path.
  /// @param what  is expected, for the complaint: "a mesh of Gmsh"
  /// @return its whole path, and what is in it
  /// @throws SceneError  where there is no such file, or it is no ordinary one that can be read
  std::pair<std::string, std::string> read_file(std::string const& key, std::string const& what);

  /// Writes a default, for the copy of the scene.
  void set(std::string const& key, double value);
  void set(std::string const& key, long value);                                          ///< a whole number
  void set(std::string const& key, bool value);                                          ///< true or false
  void set(std::string const& key, std::string const& value);                            ///< a text
  void set(std::string const& key, char const* value) { set(key, std::string(value)); }  ///< a text
  /// a list of numbers
  void set(std::string const& key, std::vector<double> const& values);
  void set(std::string const& key, Eigen::MatrixXd const& values);           ///< a list of rows
  void set(std::string const& key, std::vector<std::string> const& values);  ///< a list of texts
  void set(std::string const& key, std::vector<bool> const& values);         ///< a list of true or false

  /// The place of a value, of its key, of the table where there is no such key.
  Place place(std::string const& key) const;
  /// The place of one item of a list.
  Place place(std::string const& key, std::size_t item) const;
  /// The place of a text, or of one in a list of texts, for what is to point into it.
  TextPlace text_place(std::string const& key) const;
  TextPlace text_place(std::string const& key, std::size_t item) const;  ///< of one item of a list
  /// The place of the table.
  Place place() const;
  /// @throws SceneError  with the place of the key
  [[noreturn]] void fail(std::string const& key, std::string const& what) const;

 private:
  std::shared_ptr<detail::SceneDocument> document_;
  std::vector<std::string> path_;
};

/// A whole scene.
class SceneFile {
 public:
  /// @param path       of a file; a name alone, as "apophis", where no file has it, is that of a scene that
  ///                   the program carries (scenes.hpp)
  /// @param overrides  KEY=VALUE, the value in TOML, a bare word being a text; KEY[n]=VALUE, one item of a
  ///                   list, counted from 0; or !KEY, which is taken out
  /// @throws SceneError  where the file is no TOML (with the place), too large, or not there; where an
  ///                     override is wrong (with the place in it)
  /// @throws FileError   where the file cannot be read
  static SceneFile read(std::string const& path, std::vector<std::string> const& overrides = {});
  /// The text of a scene, whole.
  /// @throws SceneError, FileError  where it is not there, no ordinary file, or cannot be read
  static std::string text_of(std::string const& path);
  /// The same from a text; `name` stands for the file in complaints.
  static SceneFile parse(std::string_view text, std::string const& name,
                         std::vector<std::string> const& overrides = {});

  /// The same for itself: what is written into one of the two the other has not. Places are those of the
  /// original alone.
  SceneFile copy() const;

  /// One of the tables at the top, or one within as `initial.attitude`; empty where it is not in the file.
  /// @throws SceneError  where one at the top is no table; where one within is none, once it is read from
  SceneTable section(std::string const& name) const;
  /// Refuses every section but these.
  void allow(std::vector<std::string> const& sections) const;
  /// The name of the file, for complaints and defaults.
  std::string const& name() const;
  /// The files that were read because the scene names them.
  InputFiles const& inputs() const;
  /// The scene with what was written back, in TOML: sections in the order of reading, keys in the order of
  /// the file, defaults after them.
  std::string written() const;

  /// One KEY=VALUE more over what the scene says.
  /// @throws SceneError  where it is wrong, with the place in it
  void change(std::string const& argument);
  /// Takes a key out, written as that of KEY=VALUE; one that is not there stays away.
  /// @throws SceneError  where it is no key
  void drop(std::string const& key);

 private:
  explicit SceneFile(std::shared_ptr<detail::SceneDocument> document) : document_(std::move(document)) {}
  std::shared_ptr<detail::SceneDocument> document_;
};

/// A text that stands for a TOML value on the command line, as KEY=VALUE for `SceneFile`: the pieces of
/// `a,b,c` at the top level, commas inside brackets and quotes left alone.
std::vector<std::string> split_values(std::string_view list);

}  // namespace actio::scene
