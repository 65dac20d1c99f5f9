#include "actio/scene/sweep_run.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <utility>

#include "actio/scene/checkpoint.hpp"
#include "actio/scene/progress.hpp"
#include "actio/scene/sweep_table.hpp"

namespace actio::scene {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// How many members are done: one line on a terminal, a line every tenth in a pipe.
class SweepProgress {
 public:
  explicit SweepProgress(bool quiet) : quiet_(quiet), terminal_(::isatty(STDERR_FILENO) != 0) {}
  ~SweepProgress() { clear(); }
  void begin(long all) { all_ = all; }
  void one_more(bool failed) {
    ++done_, failed_ += failed;
    auto const now = Clock::now();
    double const seconds = std::chrono::duration<double>(now - began_).count();
    long const tenth = done_ * 10 / std::max(all_, 1L);
    if (quiet_ || seconds < 0.5 || (terminal_ ? now - last_ < std::chrono::milliseconds(200) : tenth == tenth_)) return;
    last_ = now, tenth_ = tenth, shown_ = terminal_;
    double const left = seconds * static_cast<double>(all_ - done_) / static_cast<double>(done_);
    std::string const line = fmt::format("{} of {} members   {} failed   {} left", done_, all_, failed_, duration_text(left));
    say(stderr, (terminal_ ? "\r" : "") + line + (terminal_ ? "\x1b[K" : "\n"));
  }
  void clear() {
    if (std::exchange(shown_, false)) say(stderr, "\r\x1b[K");
  }

 private:
  bool quiet_, terminal_, shown_ = false;
  long all_ = 0, done_ = 0, failed_ = 0, tenth_ = 0;
  Clock::time_point began_ = Clock::now(), last_ = began_;
};

/// Makes the folder of a sweep, or empties it of the sweep that is in it.
void make_folder(std::string const& folder, bool force) {
  std::error_code error;
  if (fs::exists(folder, error) && !fs::is_directory(folder, error)) throw SceneError({folder}, "is a file; a folder is expected");
  bool const empty = !fs::exists(folder, error) || fs::is_empty(folder, error);
  if (!empty && !force) throw SceneError({folder}, "the folder is not empty; --force replaces the sweep in it");
  fs::create_directories(folder, error);
  if (error) throw FileError(folder + ": cannot be made: " + error.message());
  if (empty) return;
  for (auto const& entry : fs::directory_iterator(folder)) {
    std::string const name = entry.path().filename().string();
    bool const member = entry.is_directory() && name.size() == 6 && name.find_first_not_of("0123456789") == std::string::npos;
    if (member || name == "sweep.csv") fs::remove_all(entry.path(), error);
    if (error) throw FileError(entry.path().string() + ": cannot be removed: " + error.message());
  }
}

/// The sweep, as one of its processes sees it.
class SweepRun {
 public:
  SweepRun(SweepPlan const& plan, SweepCrew& crew, SweepSharing& sharing, SweepOptions const& options) : plan_(plan), crew_(crew), sharing_(sharing), options_(options), progress_(options.quiet) {
    for (long member = 0; sharing.speaks() && member < plan.size(); ++member) results_.emplace_back().member = member, results_.back().status = static_cast<int>(Ending::interrupted);
  }

  int go() {
    round(MemberTask::check, std::string(static_cast<std::size_t>(plan_.size()), '1'));
    std::string able;  // '1' for each member that can run; empty where the sweep ends here
    std::exception_ptr refusal;
    if (sharing_.speaks()) try {
        able = choose_able();
      } catch (Error const&) {
        refusal = std::current_exception();
      }
    able = sharing_.agree(able);
    if (refusal) std::rethrow_exception(refusal);
    if (!able.empty()) round(MemberTask::run, able);
    if (!sharing_.speaks()) return 0;
    progress_.clear();
    if (interrupted()) tell_what_is_done();
    if (!able.empty()) write_whole_file(plan_.folder() + "/sweep.csv", sweep_table(plan_, results_));
    return status();
  }

 private:
  /// Does one task with all `wanted` members, together with the others.
  void round(MemberTask task, std::string const& wanted) {
    bool more = true, left = false, stopped = false;
    auto patience = Clock::time_point::max();
    while (!left || !(sharing_.all_left() || Clock::now() > patience)) {
      while (more && crew_.idle() && !interrupted()) more = start_next(task, wanted);
      more = more && !crew_.gone();
      if (interrupted() && !std::exchange(stopped, true)) {
        more = false, crew_.stop();
        patience = Clock::now() + std::chrono::milliseconds(500);
      }
      for (auto const& result : crew_.finished(2)) sharing_.speaks() ? take(task, result) : sharing_.deliver(result);
      for (auto const& result : sharing_.delivered()) take(task, result);
      if (!more && !crew_.busy() && !std::exchange(left, true)) sharing_.leave();
    }
  }
  /// @return false where there is no next
  bool start_next(MemberTask task, std::string const& wanted) {
    long const member = sharing_.next();
    if (member >= plan_.size()) return false;
    if (wanted[static_cast<std::size_t>(member)] == '1') crew_.start(task, member);
    return true;
  }

  void take(MemberTask task, MemberResult const& result) {
    results_[static_cast<std::size_t>(result.member)] = result;
    if (task == MemberTask::check) return;
    if (result.status == static_cast<int>(Ending::interrupted)) return;
    if (result.status != 0) name_failure(result);
    progress_.one_more(result.status != 0);
  }
  void name_failure(MemberResult const& result) {
    progress_.clear();
    say(stderr, plan_.described(result.member) + ": " + result.message + "\n");
  }

  /// After all scenes were read: those in order. Where there is none, nothing is written.
  std::string choose_able() {
    std::string able;
    for (auto const& result : results_) able += result.status == 0 ? '1' : '0';
    if (interrupted()) return "";
    if (able.find('1') == std::string::npos) {
      tell_that_none_is_able();
      return "";
    }
    make_folder(plan_.folder(), options_.force);
    for (auto& result : results_)
      if (result.status != 0) name_failure(result);
      else result.status = static_cast<int>(Ending::interrupted);  // until it has run
    progress_.begin(std::count(able.begin(), able.end(), '1'));
    return able;
  }
  void tell_that_none_is_able() {
    MemberResult const& first = results_.front();
    bool const all_alike = std::all_of(results_.begin(), results_.end(), [&](MemberResult const& r) { return r.message == first.message; });
    if (all_alike) say(stderr, first.message + "\n");
    else say(stderr, fmt::format("{}: {}\nNone of the {} members can run.\n", plan_.described(0), first.message, results_.size()));
  }

  void tell_what_is_done() const {
    auto const done = std::count_if(results_.begin(), results_.end(), [](MemberResult const& r) { return r.status == 0 && !r.columns.empty(); });
    say(stderr, fmt::format("interrupted: {} of {} members are done\n", done, results_.size()));
  }

  int status() const {
    if (interrupted()) return static_cast<int>(Ending::interrupted);
    int worst = 0;
    for (auto const& result : results_) worst = std::max(worst, result.status);
    return worst;
  }

  SweepPlan const& plan_;
  SweepCrew& crew_;
  SweepSharing& sharing_;
  SweepOptions options_;
  SweepProgress progress_;
  std::vector<MemberResult> results_;  // of all members, where this process speaks
};

}  // namespace

int run_sweep(SweepPlan const& plan, SweepCrew& crew, SweepSharing& sharing, SweepOptions const& options) { return SweepRun(plan, crew, sharing, options).go(); }

}  // namespace actio::scene
