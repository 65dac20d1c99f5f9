#include "program/sweep/crew.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "program/sweep/worker.hpp"

namespace actio::scene {
namespace {

using worker::Line, worker::Notice, worker::Order;

MemberResult ended_without_result(long member, int status) {
  MemberResult out;
  out.member = member;
  if (WIFSIGNALED(status)) {
    out.status = 128 + WTERMSIG(status);
    out.message = fmt::format("signal {} ended it: {}", WTERMSIG(status), ::strsignal(WTERMSIG(status)));
  } else {
    out.status = static_cast<int>(Ending::numerics_failed);
    out.message = fmt::format("its process ended with status {} and without a result",
                              WIFEXITED(status) ? WEXITSTATUS(status) : status);
  }
  return out;
}

void close_line(int& line) {
  if (line >= 0) ::close(std::exchange(line, -1));
}

/// What a worker had sent before it ended, if it is whole.
std::optional<MemberResult> last_words(int line) {
  if (line < 0) return {};
  auto const text = worker::receive_text(line);
  return text ? std::optional(MemberResult::unpacked(*text)) : std::nullopt;
}

}  // namespace

SweepCrew::SweepCrew(Work const& work, int size) {
  std::fflush(nullptr);  // or the children would write it again
  for (int k = 0; k < size; ++k) {
    Line control;
    pid_t const process = control.made() ? ::fork() : -1;
    if (process < 0) throw FileError(std::string("no process for the sweep: ") + std::strerror(errno));
    if (process == 0) {
      for (auto const& other : places_) ::close(other.control);
      ::close(control.here);
      // The members share the processors already.
      if (size > 1) ::setenv("ACTIO_THREADS", "1", 0);
      worker::be_foreman(work, control.there);
    }
    ::close(control.there);
    places_.push_back({process, control.here});
  }
  // Each tells of its first worker.
  for (auto& place : places_)
    if (auto const notice = worker::receive_notice(place.control))
      place.line = notice->line;
    else
      throw FileError("no process for the sweep: the system makes no more");
}

SweepCrew::~SweepCrew() {
  for (auto& place : places_) close_line(place.line), ::close(place.control);
  for (auto const& place : places_) worker::wait_for_end(place.foreman);
}

bool SweepCrew::idle() const {
  return std::any_of(places_.begin(), places_.end(),
                     [](Place const& p) { return p.member < 0 && p.line >= 0; });
}
bool SweepCrew::busy() const {
  return std::any_of(places_.begin(), places_.end(), [](Place const& p) { return p.member >= 0; });
}

void SweepCrew::start(MemberTask task, long member) {
  auto const place = std::find_if(places_.begin(), places_.end(),
                                  [](Place const& p) { return p.member < 0 && p.line >= 0; });
  place->member = member;
  worker::send_order(place->line, {task, member});  // one who has gone is told of by its foreman
}

std::optional<MemberResult> SweepCrew::from_worker(Place& place) {
  auto const text = worker::receive_text(place.line);
  if (!text) {  // it has gone, and its foreman will say how
    close_line(place.line);
    return {};
  }
  place.member = -1;
  auto result = MemberResult::unpacked(*text);
  if (worker::retires_after(result)) close_line(place.line);
  return result;
}

std::optional<MemberResult> SweepCrew::from_foreman(Place& place) {
  auto const notice = worker::receive_notice(place.control);
  // Where the foreman has gone, how it ended stands for how its worker will.
  int const status = notice ? notice->status : worker::wait_for_end(place.foreman);
  std::optional<MemberResult> result;
  if (long const member = std::exchange(place.member, -1); member >= 0) {
    result = notice ? last_words(place.line) : std::nullopt;
    if (!result) result = ended_without_result(member, status);
  }
  close_line(place.line);
  if (notice)
    place.line = notice->line;
  else
    close_line(place.control);
  return result;
}

std::vector<MemberResult> SweepCrew::finished(int milliseconds) {
  std::vector<pollfd> waiting;
  for (auto const& place : places_)
    waiting.push_back({place.line, POLLIN, 0}), waiting.push_back({place.control, POLLIN, 0});
  std::vector<MemberResult> out;
  if (::poll(waiting.data(), waiting.size(), milliseconds) <= 0) return out;
  for (std::size_t k = 0; k < places_.size(); ++k) {
    auto const add = [&](std::optional<MemberResult> result) {
      if (result) out.push_back(std::move(*result));
    };
    if (waiting[2 * k].revents != 0) add(from_worker(places_[k]));
    if (waiting[2 * k + 1].revents != 0) add(from_foreman(places_[k]));
  }
  std::erase_if(places_, [](Place const& p) { return p.control < 0; });
  return out;
}

void SweepCrew::stop() {
  for (auto const& place : places_)
    if (place.member >= 0) worker::ask_to_stop(place.control);
}

bool SweepCrew::told_to_stop() { return worker::told_to_stop(); }

}  // namespace actio::scene
