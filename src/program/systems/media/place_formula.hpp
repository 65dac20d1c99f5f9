// Formulas of a place, a velocity or a density in X, Y, Z: their values alone are taken, so that they may
// have kinks and jumps.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "actio/formula/tape.hpp"
#include "program/document/file.hpp"

namespace actio::scene {

/// X, Y, Z: what formulas call the coordinates of the reference space.
std::vector<std::string> const& axes();

/// Formulas at a point of the reference space. Any number of threads may evaluate them.
class PlaceFormula {
 public:
  /// The list of texts at a key, or these where it is not there; these are written back then.
  /// @throws SceneError  where they are not as many as there are dimensions, or no formulas, pointing into
  ///                     the text; where one has more than 2000 characters or more than 50 brackets in
  ///                     brackets
  PlaceFormula(SceneTable table, std::string const& key, std::vector<std::string> const& otherwise);
  /// Of one text.
  PlaceFormula(std::string const& text, int dimension, TextPlace const& place);

  /// Writes the values at X, as many as there are formulas; coordinates beyond the dimension are not looked
  /// at.
  /// @throws SceneError  where one is a NaN or infinite there, with the point
  template <std::size_t d>
  void operator()(std::array<double, d> const& X, double* out) const {
    evaluate(std::span<double const>(X), out);
  }
  /// Whether no coordinate occurs in them.
  bool is_constant() const { return constant_; }
  /// Where the first one stands.
  TextPlace const& place() const { return written_.front().place; }
  /// The first one.
  std::string const& text() const { return written_.front().text; }

 private:
  /// A formula as it stands in the scene.
  struct Written {
    std::string text;
    TextPlace place;
  };
  void read();
  void evaluate(std::span<double const> X, double* out) const;
  [[noreturn]] void fail(Written const& formula, std::span<double const> X, double value) const;

  std::vector<std::string> variables_;
  std::vector<Written> written_;
  Tape values_;
  bool constant_ = true;
};

}  // namespace actio::scene
