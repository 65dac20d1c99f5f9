#include "program/sweep/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <optional>
#include <utility>

#include "program/base/progress.hpp"
#include "program/sweep/folder.hpp"
#include "program/sweep/outlook.hpp"
#include "program/sweep/progress.hpp"
#include "program/sweep/table.hpp"

namespace actio::scene {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int not_run = static_cast<int>(Ending::interrupted);

/// Whether there is nothing more to do for a member: another try would end alike.
bool is_final(MemberResult const& result) {
  return result.status == 0 || result.status == static_cast<int>(Ending::numerics_failed) ||
         (result.status == static_cast<int>(Ending::scene_wrong) && !result.input_changed);
}

/// `3 failed (status 2: 1, status 3: 2)`
std::string failures_text(std::vector<MemberResult> const& results) {
  std::map<int, long> count;
  for (auto const& result : results)
    if (result.status != 0 && result.status != not_run) ++count[result.status];
  if (count.empty()) return "";
  long all = 0;
  std::string kinds;
  for (auto const& [status, members] : count)
    all += members, kinds += (kinds.empty() ? "" : ", ") + fmt::format("{} with status {}", members, status);
  return fmt::format(", {} failed ({})", all,
                     count.size() == 1 ? fmt::format("status {}", count.begin()->first) : kinds);
}

/// The sweep, as one of its processes sees it.
class SweepRun {
 public:
  SweepRun(SweepPlan const& plan, SweepCrew& crew, SweepSharing& sharing, SweepOptions const& options)
      : plan_(plan),
        crew_(crew),
        sharing_(sharing),
        options_(options),
        progress_(options.quiet),
        complaints_(options.quiet) {
    for (long member = 0; sharing.speaks() && member < plan.size(); ++member)
      results_.emplace_back().member = member, results_.back().status = not_run;
  }

  int go() {
    // '1' for each member that is still to be looked at; empty where the sweep ends here.
    std::string const open = agreed([&] { return begin(); });
    if (open.empty()) return status();
    progress_.begin("scenes are read", count_of(open));
    round(MemberTask::check, open);
    if (options_.dry_run) return tell_outlook();
    std::string const able = agreed([&] { return choose_able(open); });
    if (!able.empty()) round(MemberTask::run, able);
    return sharing_.speaks() ? finish(!able.empty()) : 0;
  }

 private:
  static long count_of(std::string const& members) { return std::count(members.begin(), members.end(), '1'); }

  /// What the one who speaks finds, for all; where it throws, the others are told that there is nothing to
  /// do.
  template <class Find>
  std::string agreed(Find const& find) {
    std::string said;
    std::exception_ptr refusal;
    if (sharing_.speaks()) try {
        said = find();
      } catch (Error const&) {
        refusal = std::current_exception();
      }
    said = sharing_.agree(said);
    if (refusal) std::rethrow_exception(refusal);
    return said;
  }

  /// The members that are not done, all of them where the sweep is new.
  std::string begin() {
    std::string open(results_.size(), '1');
    if (options_.resume) {
      folder_.emplace(SweepFolder::open(plan_.folder()));
      refuse_changed(SweepFolder::inputs(plan_.folder()));
      for (auto& result : folder_->kept())
        if (std::size_t const at = static_cast<std::size_t>(result.member);
            at < open.size() && is_final(result))
          open[at] = '0', results_[at] = std::move(result);
      if (count_of(open) == 0) {
        folder_->write_table(sweep_table(plan_, results_));
        if (!options_.quiet)
          say(stdout, fmt::format("{}: the sweep is finished, with {} members; nothing is left to do\n",
                                  plan_.folder(), plan_.size()));
        return "";
      }
    } else if (!options_.dry_run) {
      SweepFolder::refuse_unless_free(plan_.folder(), options_.force);
    }
    return open;
  }

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
      if (more || crew_.busy() || !left)
        for (auto const& result : crew_.finished(crew_.busy() ? sharing_.patience() : 2))
          sharing_.speaks() ? take(task, result) : sharing_.deliver(result);
      for (auto const& result : sharing_.delivered()) take(task, result);
      if (sharing_.speaks()) progress_.show();
      if (sharing_.speaks() && task == MemberTask::run) write_table_from_time_to_time();
      if (!more && !crew_.busy() && !std::exchange(left, true)) sharing_.leave();
    }
  }
  /// @return false where there is no next
  bool start_next(MemberTask task, std::string const& wanted) {
    long member = sharing_.next();
    while (member < plan_.size() && wanted[static_cast<std::size_t>(member)] != '1') member = sharing_.next();
    if (member >= plan_.size()) return false;
    crew_.start(task, member);
    return true;
  }

  void take(MemberTask task, MemberResult const& result) {
    bool const failed = result.status != 0 && result.status != not_run;
    results_[static_cast<std::size_t>(result.member)] = result;
    if (task == MemberTask::run) {
      if (is_final(result)) keep(result);
      if (failed) complain(result);
    }
    if (task == MemberTask::check || result.status != not_run) progress_.one_more(failed);
  }
  void complain(MemberResult const& result) {
    progress_.clear();
    complaints_.say(plan_.described(result.member), result.message);
  }
  /// Without a disk that takes it the sweep goes on all the same, as long as its members do.
  void keep(MemberResult const& result) {
    try {
      if (failure_.empty()) folder_->keep(result);
    } catch (FileError const& error) {
      failure_ = error.what();
    }
  }
  void write_table() {
    try {
      folder_->write_table(sweep_table(plan_, results_));
    } catch (FileError const& error) {
      if (failure_.empty()) failure_ = error.what();
    }
  }
  /// So that a sweep that is killed leaves one; never for more than a small part of the time.
  void write_table_from_time_to_time() {
    auto const now = Clock::now();
    if (now < next_table_) return;
    write_table();
    next_table_ =
        Clock::now() + std::max<Clock::duration>(std::chrono::seconds(5), 50 * (Clock::now() - now));
  }

  /// After all scenes were read: those in order. Where there is none, nothing is written.
  std::string choose_able(std::string const& open) {
    std::string able = open;
    for (auto const& result : results_)
      if (result.status != 0) able[static_cast<std::size_t>(result.member)] = '0';
    if (interrupted()) return "";
    if (!options_.resume) {
      if (count_of(able) == 0) {
        tell_that_none_is_able();
        return "";
      }
      folder_.emplace(SweepFolder::create(plan_, options_.force));
    }
    keep_inputs();
    for (std::size_t k = 0; k < able.size(); ++k)
      if (MemberResult& result = results_[k]; able[k] == '1')
        result = {}, result.member = static_cast<long>(k), result.status = not_run;  // until it has run
      else if (open[k] == '1')
        keep(result), complain(result);
    progress_.begin("members", plan_.size(), plan_.size() - count_of(able));
    return able;
  }
  /// The files of all members that were read, one after the other and each but once.
  void keep_inputs() {
    std::map<std::string, InputFile> all;
    for (auto const& file : SweepFolder::inputs(plan_.folder())) all.emplace(file.path, file);
    std::size_t const before = all.size();
    for (auto const& result : results_)
      for (auto const& file : result.inputs) all.emplace(file.path, file);
    if (all.size() == before) return;
    InputFiles inputs;
    for (auto& [path, file] : all) inputs.push_back(std::move(file));
    folder_->keep_inputs(inputs);
  }
  void tell_that_none_is_able() {
    progress_.clear();
    MemberResult const& first = results_.front();
    bool const all_alike = std::all_of(results_.begin(), results_.end(),
                                       [&](MemberResult const& r) { return r.message == first.message; });
    if (all_alike)
      say(stderr, first.message + "\n");
    else
      say(stderr, fmt::format("{}: {}\nNone of the {} members can run.\n", plan_.described(0), first.message,
                              results_.size()));
  }

  int tell_outlook() {
    if (!sharing_.speaks()) return 0;
    progress_.clear();
    if (!interrupted()) say(stdout, sweep_outlook(plan_, results_));
    return status();
  }

  /// The table, and what is said at the end.
  int finish(bool ran) {
    progress_.clear();
    if (ran) write_table(), folder_->sync();
    if (ran) complaints_.close(plan_.folder() + "/sweep.csv");
    long const done =
        std::count_if(results_.begin(), results_.end(), [](MemberResult const& r) { return r.status == 0; });
    if (interrupted() && !folder_)
      say(stderr, "interrupted while the scenes were read; nothing was written\n");
    else if (interrupted())
      say(stderr, fmt::format("interrupted: {} of {} members are done; actio resume {} goes on\n", done,
                              results_.size(), in_shell(plan_.folder())));
    else if (ran && !options_.quiet)
      say(stdout, fmt::format("{}: {} members, {} done{}, in {:.3g} s; table {}/sweep.csv\n", plan_.folder(),
                              results_.size(), done, failures_text(results_),
                              std::chrono::duration<double>(Clock::now() - began_).count(), plan_.folder()));
    if (!failure_.empty()) say(stderr, failure_ + "\n");
    return status();
  }

  int status() const {
    if (interrupted()) return not_run;
    int worst = failure_.empty() ? 0 : static_cast<int>(Ending::file_failed);
    for (auto const& result : results_) worst = std::max(worst, result.status);
    return worst;
  }

  SweepPlan const& plan_;
  SweepCrew& crew_;
  SweepSharing& sharing_;
  SweepOptions options_;
  SweepProgress progress_;
  SweepComplaints complaints_;
  std::optional<SweepFolder> folder_;  // where this process speaks
  std::vector<MemberResult> results_;  // of all members, where this process speaks
  std::string failure_;                // of a file of the sweep itself
  Clock::time_point began_ = Clock::now(), next_table_ = began_ + std::chrono::seconds(5);
};

}  // namespace

int run_sweep(SweepPlan const& plan, SweepCrew& crew, SweepSharing& sharing, SweepOptions const& options) {
  return SweepRun(plan, crew, sharing, options).go();
}

}  // namespace actio::scene
