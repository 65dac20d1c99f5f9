// Signals: Ctrl-C and a polite request to end stop a run between two steps, with everything written; a reader
// that went away stops nothing.
#pragma once

namespace actio::scene {

/// From now on SIGINT, SIGTERM and, unless it is ignored already, SIGHUP are remembered; a second Ctrl-C ends
/// the process as the first would have. A pipe without a reader and a file beyond its limit are errors of the
/// writing, no longer the end.
void listen_for_interrupts();
/// Whether one has come.
bool interrupted();

/// Standard input, output and error are open from now on, if only to nothing: no file of a run gets their
/// numbers, and the messages meant for them.
void open_standard_streams();

}  // namespace actio::scene
