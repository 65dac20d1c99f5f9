#include "program/base/progress.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <string_view>

namespace actio::scene {
namespace {

std::string_view environment(char const* name) {
  char const* const value = std::getenv(name);
  return value ? value : "";
}

/// Columns of the terminal; 80 where it does not say.
std::size_t terminal_width() {
  winsize size = {};
  return ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

/// Yellow beyond 1e-9, red beyond 1e-6: rounding stays below, a scheme that conserves what it should does
/// too.
char const* colour_of(double drift) { return drift > 1e-6 ? "\x1b[31m" : drift > 1e-9 ? "\x1b[33m" : ""; }

}  // namespace

void say(std::FILE* stream, std::string const& text) {
  std::fputs(text.c_str(), stream);
  std::fflush(stream);
}

std::string duration_text(double seconds) {
  if (!(seconds < 1e9)) return "very long";
  long const s = std::lround(seconds);
  if (s < 60) return fmt::format("{} s", s);
  if (s < 3600) return fmt::format("{} min {:02} s", s / 60, s % 60);
  if (s < 86400) return fmt::format("{} h {:02} min", s / 3600, s / 60 % 60);
  return fmt::format("{} d {} h", s / 86400, s / 3600 % 24);
}

std::string size_text(double bytes) {
  if (bytes < 1000) return fmt::format("{:.0f} bytes", bytes);
  char const* const units[] = {"kB", "MB", "GB", "TB", "PB", "EB"};
  std::size_t unit = 0;
  for (bytes /= 1000; bytes >= 999.5 && unit + 1 < std::size(units); ++unit) bytes /= 1000;
  return fmt::format("{:.3g} {}", bytes, units[unit]);
}

Progress::Progress(bool quiet, std::string unit)
    : quiet_(quiet),
      terminal_(::isatty(STDERR_FILENO) != 0 && environment("TERM") != "dumb"),
      colour_(terminal_ && environment("NO_COLOR").empty()),
      unit_(std::move(unit)) {}
Progress::~Progress() {
  if (shown_) say(stderr, "\r" + std::string(shown_, ' ') + "\r");
}

void Progress::start(double fraction, long count) {
  first_fraction_ = fraction, first_count_ = count, tenth_ = static_cast<int>(fraction * 10);
  began_ = last_ = Clock::now();
}

void Progress::show(Clock::time_point now, double fraction, long count, std::optional<double> worst_drift) {
  if (quiet_ || now - began_ < std::chrono::milliseconds(500)) return;
  int const tenth = static_cast<int>(fraction * 10);
  if (terminal_ ? now - last_ < std::chrono::milliseconds(200) : tenth <= tenth_) return;
  last_ = now, tenth_ = tenth;
  double const seconds = std::chrono::duration<double>(now - began_).count(),
               done = fraction - first_fraction_;
  // As many parts as the terminal has room for.
  std::size_t const room = terminal_ ? terminal_width() - 1 : std::string::npos;
  std::string line = fmt::format("{:5.1f} %", 100 * fraction);
  std::size_t width = line.size();
  auto const part = [&](std::string const& text, char const* colour) {
    if (width + 3 + text.size() > room) return;
    width += 3 + text.size();
    line += "   " + (*colour && colour_ ? colour + text + "\x1b[0m" : text);
  };
  part(fmt::format("{:.3g} {}/s", static_cast<double>(count - first_count_) / seconds, unit_), "");
  if (done > 0) part(duration_text(seconds * (1 - fraction) / done) + " left", "");
  if (worst_drift) part(fmt::format("worst drift {:.1e}", *worst_drift), colour_of(*worst_drift));
  print(line, width);
}

void Progress::print(std::string const& line, std::size_t width) {
  if (!terminal_) return say(stderr, line + "\n");
  say(stderr, "\r" + line + std::string(shown_ > width ? shown_ - width : 0, ' '));
  shown_ = width;
}

}  // namespace actio::scene
