// What in a folder is the program's own: a list, in the folder, of the files that it writes there.
//
//     OwnFiles own("apophis");
//     own.begin(OwnFiles::Of::run, {"scene.toml", "series.csv"});   // before they are written
//     own.remove();                                                 // these two and the list, and nothing
// else
//
// The list is the file `.actio`: a heading, then a name on each line. A name is in it before its file is
// made, so that whatever kills the program, all that it wrote
// can be told from what others put beside it. Nothing that is not in the list is written over or removed,
// and no link is followed.
#pragma once

#include <set>
#include <string>
#include <vector>

namespace actio::scene {

/// The files of the program in one folder.
class OwnFiles {
 public:
  /// Of what they are.
  enum class Of {
    nothing,  ///< there is no list
    run,      ///< a run
    member,   ///< a member of a sweep
    sweep     ///< a sweep: its table, and folders of members
  };

  /// Reads the list in a folder, which has to be there. In a folder of the version before, which had no
  /// list, a run is known by the heading of its checkpoint.
  /// @throws FileError   where the folder or its list cannot be read
  /// @throws SceneError  where what is called so is no list of this program
  explicit OwnFiles(std::string const& folder);
  ~OwnFiles();
  OwnFiles(OwnFiles const&) = delete;
  OwnFiles& operator=(OwnFiles const&) = delete;

  /// `nothing` where there is no list.
  Of of() const { return of_; }
  /// Whether there is nothing in the folder but, perhaps, the list.
  bool alone() const;
  /// Whether this name is in the list.
  bool has(std::string const& name) const { return names_.contains(name); }
  /// Whether no name is in the list.
  bool empty() const { return names_.empty(); }
  /// How many members a sweep has, whose folders are `000000`, `000001`, ...; each has a list of its own.
  long members() const { return members_; }

  /// Begins a list, in place of one that is there.
  /// @throws SceneError  where one of the names is taken by a file of somebody else
  /// @throws FileError   where the list cannot be written
  void begin(Of of, std::vector<std::string> const& names, long members = 0);
  /// Adds names to the list, those that are in it aside. A name with a `/` makes its folder.
  /// @throws SceneError, FileError  as `begin`
  void claim(std::vector<std::string> const& names);

  /// Removes the files in the list that are in a folder within, for example `plots`. Their names stay in the
  /// list.
  /// @throws SceneError, FileError
  void clear(std::string const& within);
  /// Refuses what would be no file of the program's own: a link or a folder of such a name.
  /// @throws SceneError
  void check() const;
  /// Removes the files in the list, `plots` and `snapshots` where they are empty then, and the list last: a
  /// run whose removal was cut short can be resumed, or removed.
  /// @throws FileError
  void remove();

 private:
  void read_list();
  void recognise_run_without_list();
  void refuse_taken(std::string const& name) const;
  void append(std::string const& text);
  void unlink(std::string const& name) const;
  [[noreturn]] void fail(std::string const& name, std::string const& what) const;

  std::string folder_;
  int handle_ = -1;
  Of of_ = Of::nothing;
  std::set<std::string> names_;
  long members_ = 0;
};

}  // namespace actio::scene
