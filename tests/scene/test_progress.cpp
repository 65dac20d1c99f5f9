#include <boost/test/unit_test.hpp>

#include <fcntl.h>
#include <pty.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <functional>

#include "program/base/interrupt.hpp"
#include "program/base/progress.hpp"

using actio::scene::Progress;

namespace {

/// What a process writes on standard error, which is a terminal that many columns wide; on a pipe where there
/// are none.
std::string written_to(int columns, std::function<void()> const& write) {
  int ours = -1, theirs = -1;
  if (columns > 0) {
    winsize size = {};
    size.ws_row = 24, size.ws_col = static_cast<unsigned short>(columns);
    BOOST_REQUIRE(::openpty(&ours, &theirs, nullptr, nullptr, &size) == 0);
  } else {
    int ends[2];
    BOOST_REQUIRE(::pipe(ends) == 0);
    ours = ends[0], theirs = ends[1];
  }
  pid_t const child = ::fork();
  if (child == 0) {
    ::dup2(theirs, STDERR_FILENO);
    write();
    ::_exit(0);
  }
  ::close(theirs);
  std::string out;
  char buffer[4096];
  for (ssize_t n; (n = ::read(ours, buffer, sizeof buffer)) > 0;)
    out.append(buffer, static_cast<std::size_t>(n));
  ::close(ours);
  ::waitpid(child, nullptr, 0);
  return out;
}

/// A run of ten seconds, looked at a hundred times a second, in no time.
void ten_seconds(bool quiet, double drift, char const* terminal = "xterm", char const* no_color = nullptr) {
  ::setenv("TERM", terminal, 1);
  if (no_color)
    ::setenv("NO_COLOR", no_color, 1);
  else
    ::unsetenv("NO_COLOR");
  Progress progress(quiet, "steps");
  progress.start(0, 0);
  auto const began = Progress::Clock::now();
  for (int k = 1; k <= 1000; ++k)
    progress.show(began + std::chrono::milliseconds(10 * k), k / 1000.0, 1000L * k, drift);
}

std::size_t count(std::string const& text, std::string const& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(progress)

BOOST_AUTO_TEST_CASE(a_terminal_has_one_line_that_is_written_at_most_five_times_a_second_and_cleared) {
  std::string const text = written_to(80, [] { ten_seconds(false, 1e-15); });
  BOOST_TEST(count(text, "\n") == 0u);
  BOOST_TEST(count(text, "steps/s") <= 50u);
  BOOST_TEST(count(text, "steps/s") >= 40u);
  BOOST_TEST(count(text, " 51.0 %   1e+05 steps/s   5 s left   worst drift 1.0e-15") == 1u, text);
  BOOST_TEST(text.ends_with(std::string(" \r")));
}

BOOST_AUTO_TEST_CASE(a_pipe_has_a_line_every_tenth) {
  for (int columns : {0, 80}) {
    // A terminal that cannot go back in a line is as good as a pipe.
    std::string const text =
        written_to(columns, [=] { ten_seconds(false, 1e-3, columns ? "dumb" : "xterm"); });
    BOOST_TEST(count(text, "\n") == 10u, text);
    BOOST_TEST(count(text, "\x1b") == 0u);
    for (char const* tenth : {" 10.0 %", " 20.0 %", " 90.0 %", "100.0 %"})
      BOOST_TEST(count(text, tenth) == 1u, text);
  }
}

BOOST_AUTO_TEST_CASE(only_a_drift_that_deserves_a_look_has_a_colour_and_none_where_colour_is_not_wanted) {
  BOOST_TEST(count(written_to(80, [] { ten_seconds(false, 1e-10); }), "\x1b") == 0u);
  BOOST_TEST(count(written_to(80, [] { ten_seconds(false, 1e-8); }), "\x1b[33mworst drift 1.0e-08\x1b[0m") >=
             40u);
  BOOST_TEST(count(written_to(80, [] { ten_seconds(false, 1e-3); }), "\x1b[31m") >= 40u);
  BOOST_TEST(count(written_to(80, [] { ten_seconds(false, 1e-3, "xterm", "1"); }), "\x1b") == 0u);
}

BOOST_AUTO_TEST_CASE(a_narrow_terminal_has_what_there_is_room_for) {
  for (int columns : {10, 20, 35, 60}) {
    std::string const text = written_to(columns, [] { ten_seconds(false, 1e-3); });
    std::size_t width = 0;
    bool in_colour = false;
    for (char const c : text) {
      if (c == '\r')
        width = 0;
      else if (c == '\x1b')
        in_colour = true;
      else if (in_colour)
        in_colour = c != 'm';
      else
        ++width;
      BOOST_REQUIRE(width < static_cast<std::size_t>(columns));
    }
    BOOST_TEST(count(text, "51.0 %") == 1u);
  }
}

BOOST_AUTO_TEST_CASE(a_quiet_run_and_a_short_one_say_nothing) {
  BOOST_TEST(written_to(80, [] { ten_seconds(true, 1e-3); }).empty());
  BOOST_TEST(written_to(80, [] {
               Progress progress(false, "rows");
               progress.start(0, 0);
               progress.show(Progress::Clock::now(), 0.5, 10, std::nullopt);
             }).empty());
}

BOOST_AUTO_TEST_CASE(a_resumed_run_counts_its_speed_from_where_it_goes_on) {
  std::string const text = written_to(0, [] {
    Progress progress(false, "rows");
    progress.start(0.5, 1000000);
    progress.show(Progress::Clock::now() + std::chrono::seconds(100), 0.75, 1001000, std::nullopt);
  });
  BOOST_TEST(text == " 75.0 %   10 rows/s   1 min 40 s left\n");
}

BOOST_AUTO_TEST_CASE(durations_are_told_in_two_units) {
  using actio::scene::duration_text;
  BOOST_TEST(duration_text(0.4) == "0 s");
  BOOST_TEST(duration_text(59.6) == "1 min 00 s");
  BOOST_TEST(duration_text(3 * 3600 + 5 * 60 + 1) == "3 h 05 min");
  BOOST_TEST(duration_text(2 * 86400 + 7 * 3600) == "2 d 7 h");
  BOOST_TEST(duration_text(1e300) == "very long");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(interrupts)

BOOST_AUTO_TEST_CASE(the_first_signal_is_remembered_and_the_second_ends_the_process) {
  for (int const first : {SIGINT, SIGTERM})
    for (int const second : {SIGINT, SIGTERM}) {
      pid_t const child = ::fork();
      if (child == 0) {
        for (int const s : {SIGINT, SIGTERM}) std::signal(s, SIG_DFL);  // the test has handlers of its own
        actio::scene::listen_for_interrupts();
        bool const before = actio::scene::interrupted();
        ::raise(first);
        if (before || !actio::scene::interrupted()) ::_exit(1);
        ::raise(second);       // within a moment: the same request once more
        ::usleep(300 * 1000);  // later: somebody is impatient
        ::raise(second);
        ::_exit(2);
      }
      int status = 0;
      ::waitpid(child, &status, 0);
      BOOST_TEST((WIFSIGNALED(status) && WTERMSIG(status) == second),
                 "signals " << first << ", " << second << ", status " << status);
    }
}

BOOST_AUTO_TEST_SUITE_END()
