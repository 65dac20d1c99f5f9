#include "actio/scene/interrupt.hpp"

#include <csignal>

namespace actio::scene {
namespace {
volatile std::sig_atomic_t came = 0;
void remember_signal(int) { came = 1; }
}  // namespace

void listen_for_interrupts() {
  struct sigaction action = {};
  action.sa_handler = remember_signal;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  // A file that reaches the largest size allowed is an error of writing, like a full disk, and not the end of the process.
  action.sa_handler = SIG_IGN;
  sigaction(SIGXFSZ, &action, nullptr);
}
bool interrupted() { return came != 0; }

}  // namespace actio::scene
