#include "actio/scene/interrupt.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <csignal>

namespace actio::scene {
namespace {

volatile std::sig_atomic_t came = 0;

void remember_signal(int) {
  came = 1;
  std::signal(SIGINT, SIG_DFL), std::signal(SIGTERM, SIG_DFL);
}

}  // namespace

void listen_for_interrupts() {
  struct sigaction action = {};
  action.sa_handler = remember_signal;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  // A run under nohup outlives its terminal.
  struct sigaction before = {};
  if (sigaction(SIGHUP, nullptr, &before) == 0 && before.sa_handler != SIG_IGN) sigaction(SIGHUP, &action, nullptr);
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
