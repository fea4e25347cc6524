// SPDX-License-Identifier: MIT
#pragma once
// Ctrl-C ends a bout as a touch would: the force is taken away, the summary is told, the recording
// is whole. A second one ends the program as ever.

namespace batuta::host {

/// From now on SIGINT and SIGTERM are noted, once.
void watch_interrupts();
/// Whether there was one.
bool is_interrupted();

}  // namespace batuta::host
