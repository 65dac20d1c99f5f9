// A formula that a scene writes as a text: "X + 0.1*sin(2*pi*X)/(2*pi)".
//
// Numbers, the variables that it is given, pi; + - * / ^ (to the right, before a sign: -2^2 = -4), brackets,
// comparisons, && ||, and `a ? b : c`; sin cos tan asin acos atan atan2 sinh cosh tanh asinh acosh atanh exp
// log log2 log10 sqrt cbrt hypot abs sign floor ceil round min max. `log` is the natural one, angles are in
// radians.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "program/document/file.hpp"

namespace actio::scene {

/// A formula in some variables. One thread at a time evaluates it; a copy is another one.
class Expression {
 public:
  /// @param variables  their names, in the order in which points give them
  /// @param place      where the text stands
  /// @throws SceneError  where it is no formula, pointing into the text; where it has more than 2000
  ///                     characters or more than 50 brackets in brackets
  Expression(std::string text, std::vector<std::string> variables, TextPlace place);
  Expression(Expression const& other);         ///< a copy, read anew
  Expression(Expression&&) noexcept;           ///< takes over the other one
  Expression& operator=(Expression) noexcept;  ///< by exchange with a copy
  ~Expression();

  /// The value at a point.
  /// @throws SceneError  where it is a NaN or infinite there, with the point
  double operator()(std::span<double const> point);
  /// Whether a variable occurs in it.
  bool uses(std::string const& variable) const;
  /// The formula, as it is written.
  std::string const& text() const { return text_; }

 private:
  struct Parser;
  std::string text_;
  std::vector<std::string> variables_;
  TextPlace place_;
  std::unique_ptr<Parser> parser_;
};

}  // namespace actio::scene
