#include "actio/scene/sweep_crew.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <utility>

namespace actio::scene {
namespace {

struct Order {
  MemberTask task;
  long member;
};
constexpr long stop_order = -1;  // in place of a member

/// Reads so many bytes; false where the other side has gone.
bool read_all(int from, void* to, std::size_t size) {
  for (auto* at = static_cast<char*>(to); size > 0;) {
    ssize_t const n = ::read(from, at, size);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    at += n, size -= static_cast<std::size_t>(n);
  }
  return true;
}
/// Writes them; false where the other side has gone.
bool write_all(int to, void const* from, std::size_t size) {
  for (auto const* at = static_cast<char const*>(from); size > 0;) {
    ssize_t const n = ::send(to, at, size, MSG_NOSIGNAL);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    at += n, size -= static_cast<std::size_t>(n);
  }
  return true;
}
bool send_text(int to, std::string const& text) {
  std::size_t const size = text.size();
  return write_all(to, &size, sizeof size) && write_all(to, text.data(), size);
}
std::optional<std::string> receive_text(int from) {
  std::size_t size = 0;
  if (!read_all(from, &size, sizeof size)) return {};
  std::string text(size, '\0');
  if (!read_all(from, text.data(), size)) return {};
  return text;
}

void wait_for_end(pid_t process, int& status) {
  while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
}

MemberResult ended_without_result(long member, int status) {
  MemberResult out;
  out.member = member;
  if (WIFSIGNALED(status)) {
    out.status = 128 + WTERMSIG(status);
    out.message = fmt::format("signal {} ended it: {}", WTERMSIG(status), ::strsignal(WTERMSIG(status)));
  } else {
    out.status = static_cast<int>(Ending::numerics_failed);
    out.message = fmt::format("its process ended with status {} and without a result", WIFEXITED(status) ? WEXITSTATUS(status) : status);
  }
  return out;
}

std::atomic<bool> told = false;
void remember_to_stop(int) { told = true; }
constexpr int stop_signal = SIGUSR1;

/// Waits until the member tells its result or has gone. Where the sweep asks for an end, or is no more, the member is asked as well; in the second case not for long.
void wait_for_member(int sweep, int member, pid_t process) {
  bool ending = false, orphaned = false;
  for (int patience = 20;; patience -= orphaned) {
    pollfd waiting[]{{member, POLLIN, 0}, {sweep, POLLIN, 0}};
    ::poll(waiting, orphaned ? 1 : 2, 100);
    if (waiting[0].revents) return;
    if (!orphaned && waiting[1].revents) {
      Order order;
      orphaned = !read_all(sweep, &order, sizeof order);
      ending = true;
    }
    if (ending) ::kill(process, patience > 0 ? stop_signal : SIGKILL);
  }
}

/// One member, in a process of its own.
MemberResult in_own_process(SweepCrew::Work const& work, Order const& order, int sweep) {
  int ends[2];
  pid_t const foreman = ::getpid();
  pid_t const process = ::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) == 0 ? ::fork() : -1;
  if (process < 0) {
    MemberResult out;
    out.member = order.member, out.status = static_cast<int>(Ending::file_failed), out.message = std::string("no process could be made for it: ") + std::strerror(errno);
    return out;
  }
  if (process == 0) {
    ::close(ends[0]), ::close(sweep);
    ::prctl(PR_SET_PDEATHSIG, stop_signal);
    if (::getppid() != foreman) ::_exit(1);
    ::_exit(send_text(ends[1], work(order.task, order.member).packed()) ? 0 : 1);
  }
  ::close(ends[1]);
  wait_for_member(sweep, ends[0], process);
  auto const text = receive_text(ends[0]);
  ::close(ends[0]);
  int status = 0;
  wait_for_end(process, status);
  return text ? MemberResult::unpacked(*text) : ended_without_result(order.member, status);
}

/// Takes orders until the sweep closes its side. What it does with signals its members inherit.
[[noreturn]] void be_foreman(SweepCrew::Work const& work, int sweep) {
  for (int const interrupt : {SIGINT, SIGTERM, SIGHUP}) std::signal(interrupt, SIG_IGN);
  std::signal(stop_signal, remember_to_stop);
  for (Order order; read_all(sweep, &order, sizeof order);)
    if (order.member != stop_order && !send_text(sweep, in_own_process(work, order, sweep).packed())) break;
  ::_exit(0);
}

}  // namespace

SweepCrew::SweepCrew(Work const& work, int size) {
  std::fflush(nullptr);  // or the children would write it again
  for (int k = 0; k < size; ++k) {
    int ends[2];
    pid_t const process = ::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) == 0 ? ::fork() : -1;
    if (process < 0) throw FileError(std::string("no process for the sweep: ") + std::strerror(errno));
    if (process == 0) {
      for (auto const& other : foremen_) ::close(other.socket);
      ::close(ends[0]);
      be_foreman(work, ends[1]);
    }
    ::close(ends[1]);
    foremen_.push_back({process, ends[0]});
  }
}

SweepCrew::~SweepCrew() {
  for (auto const& foreman : foremen_) ::close(foreman.socket);
  for (auto const& foreman : foremen_) {
    int status = 0;
    wait_for_end(foreman.process, status);
  }
}

bool SweepCrew::idle() const {
  return std::any_of(foremen_.begin(), foremen_.end(), [](Foreman const& f) { return f.member < 0; });
}
bool SweepCrew::busy() const {
  return std::any_of(foremen_.begin(), foremen_.end(), [](Foreman const& f) { return f.member >= 0; });
}

void SweepCrew::start(MemberTask task, long member) {
  auto const foreman = std::find_if(foremen_.begin(), foremen_.end(), [](Foreman const& f) { return f.member < 0; });
  Order const order{task, member};
  foreman->member = member;
  write_all(foreman->socket, &order, sizeof order);  // one who has gone is found when its result is read
}

std::optional<MemberResult> SweepCrew::result_of(Foreman& foreman) {
  long const member = std::exchange(foreman.member, -1);
  if (auto const text = receive_text(foreman.socket)) return MemberResult::unpacked(*text);
  // The foreman has gone.
  int status = 0;
  wait_for_end(foreman.process, status);
  ::close(foreman.socket);
  foreman.socket = -1;
  if (member < 0) return {};
  return ended_without_result(member, status);
}

std::vector<MemberResult> SweepCrew::finished(int milliseconds) {
  std::vector<pollfd> waiting;
  for (auto const& foreman : foremen_) waiting.push_back({foreman.socket, POLLIN, 0});
  std::vector<MemberResult> out;
  if (::poll(waiting.data(), waiting.size(), milliseconds) <= 0) return out;
  for (std::size_t k = 0; k < waiting.size(); ++k)
    if (waiting[k].revents != 0)
      if (auto result = result_of(foremen_[k])) out.push_back(std::move(*result));
  std::erase_if(foremen_, [](Foreman const& f) { return f.socket < 0; });
  return out;
}

bool SweepCrew::told_to_stop() { return told; }

void SweepCrew::stop() {
  Order const order{MemberTask::check, stop_order};
  for (auto const& foreman : foremen_)
    if (foreman.member >= 0) write_all(foreman.socket, &order, sizeof order);
}

}  // namespace actio::scene
