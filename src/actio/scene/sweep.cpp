#include "actio/scene/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace actio::scene {
namespace {

constexpr long most_members = 1000000;  // names have six digits

std::string trimmed(std::string const& text) {
  auto const first = text.find_first_not_of(" \t"), last = text.find_last_not_of(" \t");
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

SweptKey read_swept_key(std::string const& argument) {
  Place const place{"--over " + argument, 1, 1};
  std::size_t const equals = argument.find('=');
  SweptKey out{trimmed(argument.substr(0, equals)), {}};
  if (equals == std::string::npos || out.key.empty()) throw SceneError(place, "KEY=a,b,c is expected, for example method.step=0.1,0.2");
  for (auto const& value : split_values(argument.substr(equals + 1))) {
    out.values.push_back(trimmed(value));
    if (out.values.back().empty()) throw SceneError(place, fmt::format("value {} of '{}' is empty", out.values.size(), out.key));
  }
  return out;
}

}  // namespace

SweepPlan::SweepPlan(std::string scene, std::vector<std::string> const& over, std::vector<std::string> set, std::string folder)
    : scene_(std::move(scene)), folder_(std::move(folder)), set_(std::move(set)) {
  for (auto const& argument : over) {
    SweptKey key = read_swept_key(argument);
    Place const place{"--over " + argument, 1, 1};
    if (std::any_of(keys_.begin(), keys_.end(), [&](SweptKey const& other) { return other.key == key.key; })) throw SceneError(place, fmt::format("'{}' is swept twice", key.key));
    long const values = static_cast<long>(key.values.size());
    if (size_ > most_members / values) throw SceneError(place, fmt::format("a sweep has at most {} members, this one {} times {} or more", most_members, size_, values));
    size_ *= values;
    keys_.push_back(std::move(key));
  }
}

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

Scene SweepPlan::read(long member) const {
  std::vector<std::string> overrides = set_;
  auto const its = values(member);
  for (std::size_t k = 0; k < keys_.size(); ++k) overrides.push_back(keys_[k].key + "=" + its[k]);
  return Scene::read(SceneFile::read(scene_, overrides));
}

}  // namespace actio::scene
