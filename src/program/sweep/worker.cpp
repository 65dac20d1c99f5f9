#include "program/sweep/worker.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <utility>

namespace actio::scene::worker {
namespace {

using Work = std::function<MemberResult(MemberTask, long)>;

std::atomic<bool> told = false;
void remember_to_stop(int) { told = true; }
constexpr int stop_signal = SIGUSR1;

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
/// Its size and its bytes at once, so that the process that waits for them wakes once.
bool send_text(int to, std::string const& text) {
  std::size_t const size = text.size();
  std::string const all = std::string(reinterpret_cast<char const*>(&size), sizeof size) + text;
  return write_all(to, all.data(), all.size());
}

/// Room for one file in a message.
union Enclosure {
  cmsghdr head;
  char bytes[CMSG_SPACE(sizeof(int))];
};

bool send_notice(int control, int status, int line) {
  Enclosure enclosure = {};
  iovec text{&status, sizeof status};
  msghdr message = {};
  message.msg_iov = &text, message.msg_iovlen = 1, message.msg_control = enclosure.bytes,
  message.msg_controllen = sizeof enclosure.bytes;
  cmsghdr* const head = CMSG_FIRSTHDR(&message);
  head->cmsg_level = SOL_SOCKET, head->cmsg_type = SCM_RIGHTS, head->cmsg_len = CMSG_LEN(sizeof line);
  std::memcpy(CMSG_DATA(head), &line, sizeof line);
  ssize_t sent;
  while ((sent = ::sendmsg(control, &message, MSG_NOSIGNAL)) < 0 && errno == EINTR) {
  }
  return sent == sizeof status;
}

/// Takes orders until the sweep closes its side, or until a result that it retires after.
[[noreturn]] void be_worker(Work const& work, int line) {
  for (Order order; read_all(line, &order, sizeof order);) {
    MemberResult const result = work(order.task, order.member);
    if (!send_text(line, result.packed()) || retires_after(result)) break;
  }
  ::_exit(0);
}

/// A worker, as its foreman sees it.
struct Hired {
  pid_t process = -1;
  int alive = -1;  // the end of a pipe that is closed with the worker
};

/// @return no process where the system makes none
Hired hire(Work const& work, int control, int status_before) {
  pid_t const foreman = ::getpid();
  int pipe_ends[2];
  Line line;
  if (!line.made()) return {};
  if (::pipe2(pipe_ends, O_CLOEXEC) != 0) {
    ::close(line.here), ::close(line.there);
    return {};
  }
  pid_t const process = ::fork();
  if (process == 0) {
    ::close(control), ::close(line.here), ::close(pipe_ends[0]);
    ::prctl(PR_SET_PDEATHSIG, stop_signal);
    if (::getppid() != foreman) ::_exit(1);
    be_worker(work, line.there);
  }
  ::close(line.there), ::close(pipe_ends[1]);
  if (process < 0 || !send_notice(control, status_before, line.here)) {
    ::close(line.here), ::close(pipe_ends[0]);
    if (process > 0) ::kill(process, SIGKILL), wait_for_end(process);
    return {};
  }
  ::close(line.here);
  return {process, pipe_ends[0]};
}

/// The sweep is no more: the worker is asked to end, and then not for long.
[[noreturn]] void dismiss(Hired const& worker) {
  for (int patience = 20; patience >= 0; --patience) {
    ::kill(worker.process, patience > 0 ? stop_signal : SIGKILL);
    pollfd waiting{worker.alive, POLLIN, 0};
    if (::poll(&waiting, 1, 100) > 0) break;
  }
  wait_for_end(worker.process);
  ::_exit(0);
}

}  // namespace

Line::Line() {
  int ends[2];
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) == 0) here = ends[0], there = ends[1];
}

bool send_order(int line, Order const& order) { return write_all(line, &order, sizeof order); }

std::optional<std::string> receive_text(int line) {
  std::size_t size = 0;
  if (!read_all(line, &size, sizeof size)) return {};
  std::string text(size, '\0');
  if (!read_all(line, text.data(), size)) return {};
  return text;
}

std::optional<Notice> receive_notice(int control) {
  Notice out;
  Enclosure enclosure;
  iovec text{&out.status, sizeof out.status};
  msghdr message = {};
  message.msg_iov = &text, message.msg_iovlen = 1, message.msg_control = enclosure.bytes,
  message.msg_controllen = sizeof enclosure.bytes;
  ssize_t got;
  while ((got = ::recvmsg(control, &message, MSG_CMSG_CLOEXEC)) < 0 && errno == EINTR) {
  }
  if (got != sizeof out.status) return {};
  if (cmsghdr const* const head = CMSG_FIRSTHDR(&message); head && head->cmsg_type == SCM_RIGHTS)
    std::memcpy(&out.line, CMSG_DATA(head), sizeof out.line);
  return out;
}

void ask_to_stop(int control) {
  char const word = 's';
  write_all(control, &word, 1);
}

int wait_for_end(int process) {
  int status = 0;
  while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

bool retires_after(MemberResult const& result) {
  return result.status == static_cast<int>(Ending::file_failed);
}
bool told_to_stop() { return told; }

void be_foreman(std::function<MemberResult(MemberTask, long)> const& work, int control) {
  for (int const interrupt : {SIGINT, SIGTERM, SIGHUP}) std::signal(interrupt, SIG_IGN);
  std::signal(stop_signal, remember_to_stop);
  Hired worker = hire(work, control, 0);
  while (worker.process > 0) {
    pollfd waiting[]{{control, POLLIN, 0}, {worker.alive, POLLIN, 0}};
    if (::poll(waiting, 2, -1) < 0) continue;
    if (waiting[1].revents) {
      int const status = wait_for_end(worker.process);
      ::close(worker.alive);
      worker = hire(work, control, status);
    } else if (waiting[0].revents) {
      char word;
      if (!read_all(control, &word, 1)) dismiss(worker);
      ::kill(worker.process, stop_signal);
    }
  }
  ::_exit(1);
}

}  // namespace actio::scene::worker
