// Another program, run to its end.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace actio::app {

/// How another program ended.
struct ChildOutcome {
  int status;          ///< of exit; 128 + signal where one ended it
  std::string output;  ///< all that it wrote, standard error included
};

/// Runs a program, the first of the words, with the others as its arguments. While it runs, Ctrl-C is for it
/// alone.
/// @throws scene::FileError  where it cannot be started
ChildOutcome run_child(std::vector<std::string> const& words);

/// A folder for a while: it is gone with its owner.
class PassingFolder {
 public:
  /// @throws scene::FileError
  PassingFolder();
  ~PassingFolder();
  PassingFolder(PassingFolder const&) = delete;
  PassingFolder& operator=(PassingFolder const&) = delete;
  std::filesystem::path const& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// The folder of the program that is running.
std::filesystem::path folder_of_this_program();

}  // namespace actio::app
