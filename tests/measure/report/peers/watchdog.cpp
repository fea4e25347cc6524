// SPDX-License-Identifier: MIT
#include "watchdog.hpp"

#include <unistd.h>
#include <csignal>
#include <cstdio>

namespace batuta::peers {

namespace {

// Written before the alarm is set, read by its handler: the text is ready, because a handler may
// not format.
char note[256];
volatile std::sig_atomic_t note_size = 0;

extern "C" void batuta_peers_give_up(int /*signal*/) {
  const auto ignored = write(STDERR_FILENO, note, static_cast<std::size_t>(note_size));
  (void)ignored;
  _exit(kStuckExitCode);
}

}  // namespace

Watchdog::Watchdog(const char* peer, const char* family, std::uint64_t index) {
  const int size =
      std::snprintf(note, sizeof note, "peers: %s does not come back from %s query %llu\n", peer,
                    family, static_cast<unsigned long long>(index));
  note_size = size < static_cast<int>(sizeof note) ? size : static_cast<int>(sizeof note) - 1;
  std::signal(SIGALRM, batuta_peers_give_up);
  alarm(kPatience_s);
}

Watchdog::~Watchdog() {
  alarm(0);
}

}  // namespace batuta::peers
