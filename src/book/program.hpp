// What a program of a chapter says to its reader.
//
// A program prints sentences and tables, and the same figures, tables and pictures go into a report, from which the book is
// made: no number on a page is copied by hand. What the program claims it checks: where a claim fails, so does the program.
//
//   book::Program program(argc, argv, "a box thrown about its middle axis turns over, again and again");
//   program.say("The box turns over every ", period, " seconds.");
//   program.figure("energy", drift, "relative drift of the energy");
//   program.picture("flip", plot.svg(), "The component along the middle axis.");
//   program.claim(drift < 1e-12, "the energy stays within 1e-12");
//   program.headline("energy kept to " + book::number(drift), drift);
//   return program.finish();
//
// The report is NAME.json in the folder given by `--report DIR`; without it, in ../report/programs beside the program.
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

/// A program of a chapter, as its reader meets it: what it says, shows, measures and claims.
class Program {
 public:
  /// The cells of a line of a table.
  using Row = std::vector<std::string>;

  /// @param shows  one line: what the reader sees here
  Program(int argc, char** argv, std::string shows)
      : name_(std::filesystem::path(argv[0]).stem().string()),
        folder_(std::filesystem::path(argv[0]).parent_path() / ".." / "report" / "programs"),
        shows_(std::move(shows)) {
    for (int i = 1; i < argc; ++i) {
      if (std::string_view(argv[i]) == "--report" && i + 1 < argc) {
        folder_ = argv[++i];
      } else {
        std::cerr << name_ << ": unknown argument '" << argv[i] << "'\nusage: " << name_ << " [--report DIR]\n";
        std::exit(2);
      }
    }
    // A report of an earlier run must not outlive a run that fails.
    std::error_code ignored;
    std::filesystem::remove(report("json"), ignored);
    std::cout << shows_ << "\n\n";
  }

  /// A line of text: words and numbers.
  template <class... Parts>
  void say(Parts const&... parts) {
    std::cout << text(parts...) << '\n';
  }

  /// A measured number that the chapter may quote by name. A number that is not finite fails the program.
  void figure(std::string const& name, double value, std::string const& meaning = "") { figure(name, value, number(value), meaning); }
  /// The same, with its wording: `shown` may carry a unit or more digits.
  void figure(std::string const& name, double value, std::string const& shown, std::string const& meaning) {
    if (!std::isfinite(value)) claim(false, "the figure '" + name + "' is a finite number");
    std::cout << "  " << (meaning.empty() ? name : meaning) << ": " << shown << '\n';
    figures_.push_back("{\"name\": " + json::quote(name) + ", \"value\": " + json::number(value) + ", \"text\": " + json::quote(shown) +
                       ", \"meaning\": " + json::quote(meaning) + "}");
  }

  /// A table, printed and reported.
  void table(std::string const& name, Row const& header, std::vector<Row> const& rows, std::string const& caption = "") {
    std::vector<std::size_t> widths(header.size());
    auto const fit = [&](Row const& row) {
      for (std::size_t i = 0; i < row.size() && i < widths.size(); ++i) widths[i] = std::max(widths[i], width(row[i]));
    };
    auto const print = [&](Row const& row) {
      for (std::size_t i = 0; i < row.size() && i < widths.size(); ++i)
        std::cout << "  " << row[i] << std::string(i + 1 < row.size() ? widths[i] - width(row[i]) : 0, ' ');
      std::cout << '\n';
    };
    fit(header);
    for (auto const& row : rows) fit(row);
    std::cout << '\n';
    print(header);
    std::vector<std::string> lines;
    for (auto const& row : rows) {
      print(row);
      lines.push_back(json::strings(row));
    }
    std::cout << '\n';
    tables_.push_back("{\"name\": " + json::quote(name) + ", \"caption\": " + json::quote(caption) +
                      ", \"header\": " + json::strings(header) + ", \"rows\": " + json::array(lines) + "}");
  }

  /// A picture (SVG text, from plot.hpp or sphere.hpp), written beside the report.
  void picture(std::string const& name, std::string const& svg, std::string const& caption) {
    auto const file = report(name + ".svg");
    json::write_file(file, svg);
    pictures_.push_back("{\"name\": " + json::quote(name) + ", \"file\": " + json::quote(file.filename().string()) +
                        ", \"caption\": " + json::quote(caption) + "}");
  }

  /// What the program asserts, in words: "the energy stays within 1e-12". Where it is not so, the program fails.
  void claim(bool holds, std::string const& what) {
    judge(holds, what);
    failed_ += !holds;
  }

  /// The one measured figure that stands for the program in the table of all programs.
  void headline(std::string const& text, double value) {
    if (!std::isfinite(value)) claim(false, "the headline '" + text + "' is a finite number");
    headline_ = "{\"text\": " + json::quote(text) + ", \"value\": " + json::number(value) + "}";
    std::cout << "\n" << text << '\n';
  }

  /// Writes the report. The result is what `main` returns: 0, or 1 where a claim failed or nothing stands for the program.
  int finish() {
    if (headline_.empty()) claim(false, "the program has a headline");
    std::chrono::duration<double> const seconds = std::chrono::steady_clock::now() - start_;
    json::write_file(report("json"), "{\"chapter\": " + json::quote(name_.substr(0, name_.find('_'))) +
                                         ",\n \"program\": " + json::quote(name_) + ",\n \"shows\": " + json::quote(shows_) +
                                         ",\n \"headline\": " + (headline_.empty() ? "null" : headline_) +
                                         ",\n \"figures\": " + json::array(figures_) + ",\n \"tables\": " + json::array(tables_) +
                                         ",\n \"pictures\": " + json::array(pictures_) + ",\n \"claims\": " + json::array(claims_) +
                                         properties_ + ",\n \"seconds\": " + json::number(std::round(seconds.count() * 1e3) / 1e3) + "}\n");
    return failed_ == 0 ? 0 : 1;
  }

 protected:
  /// A claim that is shown and reported, whether it holds or not, and does not make the program fail.
  void judge(bool holds, std::string const& what) {
    if (!holds) std::cerr << name_ << ": a claim does not hold: " << what << '\n';
    claims_.push_back("{\"holds\": " + std::string(holds ? "true" : "false") + ", \"text\": " + json::quote(what) + "}");
  }
  /// A further member of the report; `value` is JSON.
  void property(std::string const& name, std::string const& value) { properties_ += ",\n " + json::quote(name) + ": " + value; }

 private:
  std::filesystem::path report(std::string const& ending) const { return folder_ / (name_ + "." + ending); }

  std::string name_;
  std::filesystem::path folder_;
  std::string shows_;
  std::string headline_, properties_;
  std::vector<std::string> figures_, tables_, pictures_, claims_;
  int failed_ = 0;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace book
