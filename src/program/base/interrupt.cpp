#include "program/base/interrupt.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <csignal>
#include <ctime>

namespace actio::scene {
namespace {

volatile std::sig_atomic_t came = 0;
struct timespec first_came;

/// One request may come twice within a moment: `timeout` sends it to the process and to its group. Only what
/// comes later means that somebody is impatient.
void remember_signal(int signal) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  if (came == 0) {
    first_came = now;
    came = 1;
    return;
  }
  double const seconds = static_cast<double>(now.tv_sec - first_came.tv_sec) +
                         1e-9 * static_cast<double>(now.tv_nsec - first_came.tv_nsec);
  if (seconds < 0.25) return;
  std::signal(signal, SIG_DFL);
  ::raise(signal);
}

}  // namespace

void listen_for_interrupts() {
  struct sigaction action = {};
  action.sa_handler = remember_signal;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  // A run under nohup outlives its terminal.
  struct sigaction before = {};
  if (sigaction(SIGHUP, nullptr, &before) == 0 && before.sa_handler != SIG_IGN)
    sigaction(SIGHUP, &action, nullptr);
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}
bool interrupted() { return came != 0; }

void open_standard_streams() {
  for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; ++stream)
    if (::fcntl(stream, F_GETFD) < 0) {
      // The lowest number that is free: this one.
      [[maybe_unused]] int const opened = ::open("/dev/null", O_RDWR);
    }
}

}  // namespace actio::scene
