// The folder of a sweep: made or found, and locked, so that no two sweeps mix in it.
//
//     sweep.toml      the plan: the text of the scene, what is set and what is swept
//     sweep.csv       the table, written anew from time to time
//     .results        what each member told when it ended, as bytes: a sweep that goes on has them from there
//     .inputs         the files that its scenes were read with
//     .actio          the list of these files, and how many members there are
//     000000/ ...     the members, each with a list of its own
#pragma once

#include <string>
#include <vector>

#include "program/base/folder_lock.hpp"
#include "program/sweep/member.hpp"

namespace actio::scene {

/// A folder that this process runs a sweep in. The lock goes with the process, however it ends.
class SweepFolder {
 public:
  /// Whether there is a sweep in the folder that could go on.
  static bool is_one(std::string const& path);
  /// Refuses a folder that a new sweep could not have, and changes nothing.
  /// @param replace  whether the sweep that is in it would go
  /// @throws SceneError  where it is no folder, or not empty and `replace` is not said; where there is no
  ///         sweep that could be replaced
  /// @throws FileError   where another process runs in it
  static void refuse_unless_free(std::string const& path, bool replace);

  /// For a new sweep: made where there is none, empty, or beside files of other people after the sweep that
  /// was in it. A member goes by the list in its own folder;
  /// the folder goes where it is empty then.
  /// @throws SceneError, FileError  as `refuse_unless_free`, and where it cannot be made or emptied
  static SweepFolder create(SweepPlan const& plan, bool replace);
  /// That of a sweep that goes on.
  /// @throws SceneError  where there is no sweep in it
  /// @throws FileError   where another process runs in it
  static SweepFolder open(std::string const& path);

  /// Takes over the lock.
  SweepFolder(SweepFolder&& other) noexcept;
  SweepFolder(SweepFolder const&) = delete;
  SweepFolder& operator=(SweepFolder const&) = delete;
  ~SweepFolder();

  /// Keeps the files that the scenes were read with, so that members that run later have the same.
  /// @throws FileError
  void keep_inputs(InputFiles const& inputs) const;
  /// Those of the sweep in a folder; none where nothing was kept.
  /// @throws FileError
  static InputFiles inputs(std::string const& path);
  /// What was kept; the latest of each member.
  /// @throws FileError
  std::vector<MemberResult> kept() const;
  /// Keeps a result, for a sweep that goes on.
  /// @throws FileError
  void keep(MemberResult const& result);
  /// Writes the table, whole or not at all.
  /// @throws FileError
  void write_table(std::string const& table) const;
  /// All that was written by whomever, on the disk.
  void sync() const;

 private:
  SweepFolder(std::string path, FolderLock lock);

  std::string path_;
  FolderLock lock_;
  int results_ = -1;
};

}  // namespace actio::scene
