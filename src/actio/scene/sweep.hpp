// A sweep: one scene for each of many values, every combination a run of its own.
//
//     SweepPlan plan("apophis.toml", {"method.step=0.1,0.2", "method.order=2,4"}, {}, "apophis");
//     plan.size();                 // 4
//     plan.values(1);              // 0.1, 4: the last key is the fastest
#pragma once

#include "actio/scene/scene.hpp"

namespace actio::scene {

/// A key of the scene and the values it goes through, as they were written.
struct SweptKey {
  std::string key;                  ///< `method.step`
  std::vector<std::string> values;  ///< at least one
};

/// What is to be run: which scene, with which values, and where each member goes.
class SweepPlan {
 public:
  /// @param over    KEY=a,b,c for each swept key, the last one the fastest
  /// @param set     KEY=VALUE for all members
  /// @param folder  of the sweep
  /// @throws SceneError  where one of `over` has no key, no value or a key that another has; where there are more than 10^6 members
  SweepPlan(std::string scene, std::vector<std::string> const& over, std::vector<std::string> set, std::string folder);

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
  /// @throws SceneError, NumericsError, FileError
  Scene read(long member) const;

 private:
  std::string scene_, folder_;
  std::vector<std::string> set_;
  std::vector<SweptKey> keys_;
  long size_ = 1;
};

}  // namespace actio::scene
