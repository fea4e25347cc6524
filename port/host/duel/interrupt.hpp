// SPDX-License-Identifier: MIT
#pragma once
// Ctrl-C ends a bout with live devices as a touch would: the force is taken away and the summary is
// told. A second one ends the program as ever.

namespace batuta::host {

/// From now on SIGINT and SIGTERM are noted, once.
void watch_interrupts();
/// Whether there was one.
bool is_interrupted();

}  // namespace batuta::host
