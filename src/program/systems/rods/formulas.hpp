// Vectors that a scene of a rod writes as formulas.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "actio/formula/tape.hpp"
#include "program/systems/shared_names.hpp"

namespace actio::scene {

/// The formulas of one key. One thread at a time evaluates them.
class RodFormulas {
 public:
  using Vector = std::array<double, 3>;  ///< in space, or of the axes of a section

  /// @param table   that has the key
  /// @param names   what the inputs are called: "s", "t"
  /// @param count   how many formulas there are: 3, or 1, which is no list
  /// @param slopes  whether their derivatives by the first input are taken, so that they must be smooth
  /// @throws SceneError  where they are no such formulas, pointing into the text
  RodFormulas(SceneTable const& table, std::string const& key, std::vector<std::string> names,
              SharedNames& shared, std::size_t count = 3, bool slopes = false);

  /// The values; of one formula the first.
  /// @throws SceneError  where one is a NaN or infinite there, with the place
  Vector operator()(std::span<double const> at) const { return evaluate(at, 0); }
  /// The derivatives by the first input.
  Vector slope(double at) const { return evaluate({&at, 1}, 1); }
  /// Whether an input occurs.
  bool uses(std::string const& name) const { return used_.contains(name); }

 private:
  Vector evaluate(std::span<double const> at, std::size_t which) const;

  SceneTable table_;
  std::string key_;
  std::vector<std::string> names_;
  std::size_t count_;
  bool slopes_;
  SharedNames::Names used_;
  Tape tape_;
  mutable std::vector<double> work_, out_;
};

}  // namespace actio::scene
