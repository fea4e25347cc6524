// SPDX-License-Identifier: MIT

#include "programs/duel/interrupt.hpp"

#include <atomic>
#include <csignal>

#include "programs/files/unfinished_files.hpp"

namespace batuta::host {
namespace {

/// The threads of the devices may be the ones that are interrupted: no sig_atomic_t.
std::atomic<bool> interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler must not wait");

extern "C" void note_interrupt(int signal) {
  interrupted = true;
  (void)std::signal(signal, batuta_remove_and_end);
}

/// What a shell has had ignored, for a job in the background, stays so.
void watch(int signal) {
  if (std::signal(signal, note_interrupt) == SIG_IGN) (void)std::signal(signal, SIG_IGN);
}

}  // namespace

void watch_interrupts() {
  watch(SIGHUP);
  watch(SIGINT);
  watch(SIGTERM);
}

bool is_interrupted() {
  return interrupted;
}

}  // namespace batuta::host
