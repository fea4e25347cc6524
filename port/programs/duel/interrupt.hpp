// SPDX-License-Identifier: MIT
#pragma once
// Ctrl-C ends a bout as a touch would: the force is taken away, the summary is told, the recording
// is whole. A second one ends the program at once, and leaves no file that is not whole.

namespace batuta::host {

/// From now on SIGHUP, SIGINT and SIGTERM are noted, once each.
void watch_interrupts();
/// Whether there was one.
bool is_interrupted();

}  // namespace batuta::host
