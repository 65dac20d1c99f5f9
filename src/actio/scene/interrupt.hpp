// Ctrl-C, and a polite request to end: the run stops between two steps, with everything written.
#pragma once

namespace actio::scene {

/// From now on SIGINT and SIGTERM are remembered; a second one ends the process as it would have. A file that grows beyond the limit of its size is an error of
/// writing, no longer a signal.
void listen_for_interrupts();
/// Whether one has come.
bool interrupted();

}  // namespace actio::scene
