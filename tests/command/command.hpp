// The built command, driven as a person would: arguments in, status and text out, files to look at.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace command {

/// How a command ended.
struct Outcome {
  int status;       ///< of exit; 128 + signal where one ended it
  std::string out;  ///< standard output
  std::string err;  ///< standard error
};

/// Runs `actio` with these arguments.
/// @param before  what the shell does first, for example "ulimit -f 10;" or "NO_COLOR=1"
Outcome actio(std::vector<std::string> const& arguments, std::string const& before = "");

/// Runs a line of the shell; `$ACTIO` is the command.
Outcome shell(std::string const& line);

/// A folder of its own, gone afterwards.
class Folder {
 public:
  Folder();
  ~Folder();
  Folder(Folder const&) = delete;
  Folder& operator=(Folder const&) = delete;
  /// A path in it.
  std::string operator/(std::string const& name) const { return (path_ / name).string(); }
  /// Writes a file in it; returns its path.
  std::string write(std::string const& name, std::string const& text) const;

 private:
  std::filesystem::path path_;
};

/// The whole of a file; empty where there is none.
std::string contents(std::string const& path);

/// A table that was written by a run.
struct Table {
  std::vector<std::string> columns;
  std::vector<std::vector<double>> rows;
  /// One column.
  std::vector<double> operator[](std::string const& name) const;
};
/// Reads it strictly: every row whole, every number a number.
Table read_csv(std::string const& path);

/// A scene of Apophis that is in order; each replacement changes a line `key = ...` (or takes it away where
/// the text is empty).
std::string apophis(std::map<std::string, std::string> const& changes = {});

}  // namespace command
