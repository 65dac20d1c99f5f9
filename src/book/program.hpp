// What a program of a chapter says to its reader.
//
// A program prints sentences and tables, and the same figures, tables and pictures go into a report, from
// which the book is made: no number on a page is copied by hand. What the program claims it checks: where a
// claim fails, so does the program.
//
//   book::Program program(argc, argv, "a box thrown about its middle axis turns over, again and again");
//   program.say("The box turns over every ", period, " seconds.");
//   program.figure("energy", drift, "relative drift of the energy");
//   program.picture("flip", plot.svg(), "The component along the middle axis.");
//   program.claim(drift < 1e-12, "the energy stays within 1e-12");
//   program.headline("energy kept to " + book::number(drift), drift);
//   return program.finish();
//
// The report is NAME.json in the folder given by `--report DIR`; without it, in ../report/programs beside the
// program.
#pragma once

#include <chrono>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <sstream>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "book/json.hpp"

namespace book {

/// A number for a reader: 0, 0.0123, 4711, 1.2e-15; `digits` of them significant.
inline std::string number(double x, int digits = 3) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*g", digits, x);
  return text;
}

/// Words and numbers in one sentence; a floating-point number is shown as `number` shows it.
template <class... Parts>
std::string text(Parts const&... parts) {
  std::ostringstream out;
  auto const add = [&](auto const& part) {
    if constexpr (std::is_floating_point_v<std::remove_cvref_t<decltype(part)>>)
      out << number(part);
    else
      out << part;
  };
  (add(parts), ...);
  return out.str();
}

/// The width of a text in characters rather than bytes, for columns that align.
inline std::size_t width(std::string_view text) {
  std::size_t count = 0;
  for (unsigned char const c : text) count += (c & 0xC0) != 0x80;
  return count;
}

/// What a claim compared, as its reader sees it: whether it holds, and the measured value with its bound.
struct Comparison {
  bool holds;        ///< the outcome
  std::string said;  ///< "4.5e-14 < 2.2e-12"
};

/// A measured value, to be compared with its bound in a claim: `claim(measured(drift) < bound, "...")`.
struct Measured {
  double value;  ///< what was measured

  /// The comparison with an upper bound.
  friend Comparison operator<(Measured a, double bound) {
    return {a.value < bound, number(a.value) + " < " + number(bound)};
  }
  /// The comparison with a lower bound.
  friend Comparison operator>(Measured a, double bound) {
    return {a.value > bound, number(a.value) + " > " + number(bound)};
  }
};
/// Marks the value that a claim is about.
inline Measured measured(double value) { return {value}; }
/// Both comparisons.
inline Comparison operator&&(Comparison const& a, Comparison const& b) {
  return {a.holds && b.holds, a.said + ", " + b.said};
}

/// A program of a chapter, as its reader meets it: what it says, shows, measures and claims.
class Program {
 public:
  /// The cells of a line of a table.
  using Row = std::vector<std::string>;

  /// @param shows  one line: what the reader sees here
  Program(int argc, char** argv, std::string shows);

  /// A line of text: words and numbers.
  template <class... Parts>
  void say(Parts const&... parts) { std::cout << text(parts...) << '\n'; }

  /// A measured number that the chapter may quote by name. A number that is not finite fails the program.
  void figure(std::string const& name, double value, std::string const& meaning = "");
  /// The same, with its wording: `shown` may carry a unit or more digits.
  void figure(std::string const& name, double value, std::string const& shown, std::string const& meaning);

  /// A table, printed and reported.
  void table(std::string const& name, Row const& header, std::vector<Row> const& rows,
             std::string const& caption = "");

  /// A picture (SVG text, from plot.hpp or sphere.hpp), written beside the report.
  void picture(std::string const& name, std::string const& svg, std::string const& caption);

  /// What the program asserts, in words: "the energy stays within 1e-12". Where it is not so, the program
  /// fails.
  void claim(bool holds, std::string const& what) { claim(Comparison{holds, ""}, what); }
  /// The same, with the measured value and its bound.
  void claim(Comparison const& compared, std::string const& what);

  /// A motion for the book to play: moments in rows, each with a value under every name of the header.
  /// @throws std::invalid_argument  where a row has another length than the header
  void motion(std::string const& name, Row const& header, std::vector<std::vector<double>> const& rows);

  /// What a snippet printed, see try_it.hpp.
  void snippet(std::string const& name, std::string const& said);

  /// The one measured figure that stands for the program in the table of all programs.
  void headline(std::string const& text, double value);

  /// Writes the report. The result is what `main` returns: 0, or 1 where a claim failed or nothing stands for
  /// the program.
  int finish();

 protected:
  /// A claim that is shown and reported, whether it holds or not, and does not make the program fail.
  void judge(Comparison const& compared, std::string const& what);
  /// The same for a plain condition.
  void judge(bool holds, std::string const& what) { judge(Comparison{holds, ""}, what); }
  /// A further member of the report; `value` is JSON.
  void property(std::string const& name, std::string const& value);

 private:
  std::filesystem::path report(std::string const& ending) const { return folder_ / (name_ + "." + ending); }

  std::string name_;
  std::filesystem::path folder_;
  std::string shows_;
  std::string headline_, properties_;
  std::vector<std::string> figures_, tables_, pictures_, claims_, motions_, snippets_;
  int failed_ = 0;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace book
