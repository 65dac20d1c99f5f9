// A sweep: one scene for each of many values, every combination a run of its own.
//
//     SweepPlan plan("apophis.toml", {"method.step=0.1,0.2", "method.order=2,4"}, {}, "apophis");
//     plan.size();                 // 4
//     plan.values(1);              // 0.1, 4: the last key is the fastest
#pragma once

#include <optional>

#include "program/registry/scene.hpp"
#include "program/sweep/swept_values.hpp"

namespace actio::scene {

/// What is to be run: which scene, with which values, and where each member goes.
class SweepPlan {
 public:
  /// @param over    KEY=VALUES for each swept key, the last one the fastest; values as `swept_key` reads them
  /// @param set     KEY=VALUE for all members
  /// @param folder  of the sweep
  /// @throws SceneError  where one of `over` has no key, no value or a key that another has, or one that is
  ///         set; where there are more than 10^6 members
  SweepPlan(std::string scene, std::vector<std::string> const& over, std::vector<std::string> set,
            std::string folder);
  /// The plan of the sweep in a folder, as it was written there.
  /// @throws SceneError  where what is written there is no plan
  /// @throws FileError   where it cannot be read
  static SweepPlan resumed(std::string const& folder);

  /// Reads the text of the scene; whatever becomes of the file, the members are of this text.
  /// @throws SceneError, FileError
  void read_scene();
  /// All that is needed to go on with the sweep, in TOML.
  std::string written() const;

  /// The number of members.
  long size() const { return size_; }
  /// In the order in which they were given.
  std::vector<SweptKey> const& keys() const { return keys_; }
  /// That of the sweep, with the table and the folders of the members in it.
  std::string const& folder() const { return folder_; }

  /// `000012`: the name of a member, and of its folder.
  static std::string name(long member);
  /// That of a member.
  std::string folder(long member) const { return folder_ + "/" + name(member); }
  /// One value for each key.
  std::vector<std::string> values(long member) const;
  /// `000012 (method.step=0.1, method.order=2)`
  std::string described(long member) const;
  /// The scene of a member.
  /// @param pilots  by which steps are chosen, where it asks for an accuracy
  /// @throws SceneError, NumericsError, FileError, Stopped
  Scene read(long member, Pilots const& pilots) const;

 private:
  SweepPlan() = default;
  void add(SweptKey key, Place const& place);

  std::string scene_, folder_;
  std::optional<std::string> text_;  // of the scene
  std::vector<std::string> set_;
  std::vector<SweptKey> keys_;
  long size_ = 1;
};

}  // namespace actio::scene
