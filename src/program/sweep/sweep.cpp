#include "program/sweep/sweep.hpp"

#include <fmt/format.h>


namespace actio::scene {
namespace {

std::string key_of(std::string const& override_text) {
  return override_text.starts_with('!') ? plain_key(override_text.substr(1))
                                        : plain_key(override_text.substr(0, override_text.find('=')));
}

}  // namespace

SweepPlan::SweepPlan(std::string scene, std::vector<std::string> const& over, std::vector<std::string> set,
                     std::string folder)
    : scene_(std::move(scene)), folder_(std::move(folder)), set_(std::move(set)) {
  while (folder_.size() > 1 && folder_.ends_with('/')) folder_.pop_back();
  for (auto const& argument : over) {
    Place const place{"--over " + shown(argument, 100), 1, 1};
    add(read_swept_key(argument, place), place);
  }
}

void SweepPlan::add(SweptKey key, Place const& place) {
  for (auto const& other : keys_)
    if (overlap(other.key, key.key)) throw SceneError(place, fmt::format("'{}' is swept twice", key.key));
  std::string const plain = plain_key(key.key);
  for (auto const& one : set_)
    if (!one.starts_with('!') && (key_of(one) == plain || key_of(one).starts_with(plain + "[")))
      throw SceneError(
          {"--set " + shown(one, 100)},
          fmt::format("'{}' is swept, so that to set it would be without effect; take one of the two away",
                      key.key));
  long const values = static_cast<long>(key.values.size());
  if (size_ > most_members / values)
    throw SceneError(place, fmt::format("a sweep has at most {} members, this one {} times {} or more",
                                        most_members, size_, values));
  size_ *= values;
  keys_.push_back(std::move(key));
}

void SweepPlan::read_scene() { text_ = SceneFile::text_of(scene_); }

std::string SweepPlan::name(long member) { return fmt::format("{:06}", member); }

std::vector<std::string> SweepPlan::values(long member) const {
  std::vector<std::string> out(keys_.size());
  for (std::size_t k = keys_.size(); k-- > 0;) {
    long const count = static_cast<long>(keys_[k].values.size());
    out[k] = keys_[k].values[static_cast<std::size_t>(member % count)];
    member /= count;
  }
  return out;
}

std::string SweepPlan::described(long member) const {
  std::string list;
  auto const its = values(member);
  for (std::size_t k = 0; k < keys_.size(); ++k) list += (k ? ", " : "") + keys_[k].key + "=" + its[k];
  return name(member) + " (" + list + ")";
}

Scene SweepPlan::read(long member, Pilots const& pilots) const {
  std::vector<std::string> overrides = set_;
  auto const its = values(member);
  for (std::size_t k = 0; k < keys_.size(); ++k) overrides.push_back(keys_[k].key + "=" + its[k]);
  return Scene::read(text_ ? SceneFile::parse(*text_, scene_, overrides) : SceneFile::read(scene_, overrides),
                     pilots);
}

}  // namespace actio::scene
