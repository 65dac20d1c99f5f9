// What a sweep says of itself on standard error: how far it is, and which members failed.
#pragma once

#include <chrono>
#include <map>
#include <string>

namespace actio::scene {

/// How many members are done: one line on a terminal, a line every tenth in a pipe. Nothing is said in the
/// first half second.
class SweepProgress {
 public:
  /// @param quiet  whether nothing is said at all
  explicit SweepProgress(bool quiet);
  /// Clears the line.
  ~SweepProgress();
  SweepProgress(SweepProgress const&) = delete;
  SweepProgress& operator=(SweepProgress const&) = delete;

  /// Something new begins, and its time is counted from now.
  /// @param what  is counted: "members"
  /// @param all   how many there are
  /// @param done  how many of them were done before
  void begin(std::string what, long all, long done = 0);
  /// One is done.
  void one_more(bool failed);
  /// Says how far the sweep is, where it is time to.
  void show();
  /// Takes the line away.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;
  bool quiet_, terminal_, shown_ = false, said_ = false;
  std::string what_;
  long all_ = 0, before_ = 0, done_ = 0, failed_ = 0, tenth_ = 0;
  Clock::time_point began_ = Clock::now(), last_ = began_;
};

/// The complaints of members: the first few, and how many more there are.
class SweepComplaints {
 public:
  /// @param quiet  whether nothing is said at all
  explicit SweepComplaints(bool quiet) : quiet_(quiet) {}
  /// Says it, unless the same was said of some members already, or much was.
  /// @param who  `000012 (method.step=0.1)`
  void say(std::string const& who, std::string const& message);
  /// Says how many more there were, and which file has them all.
  void close(std::string const& table);

 private:
  bool quiet_;
  long said_ = 0, kept_back_ = 0;
  std::map<std::string, int> alike_;
};

}  // namespace actio::scene
