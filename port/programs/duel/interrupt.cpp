// SPDX-License-Identifier: MIT

#include "programs/duel/interrupt.hpp"

#include <atomic>
#include <csignal>
#include <initializer_list>

#include "programs/files/unfinished_files.hpp"

namespace batuta::host {
namespace {

/// The threads of the devices may be the ones that are interrupted: no sig_atomic_t.
std::atomic<bool> interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler must not wait");

/// What a shell has had ignored, for a job in the background, stays so.
void handle(int signal, void (*handler)(int)) {
  if (std::signal(signal, handler) == SIG_IGN) (void)std::signal(signal, SIG_IGN);
}

/// A second one ends the program, whichever of them it is.
extern "C" void note_interrupt(int /*signal*/) {
  interrupted = true;
  for (const int other : {SIGHUP, SIGINT, SIGTERM}) handle(other, batuta_remove_and_end);
}

}  // namespace

void watch_interrupts() {
  if (interrupted) return;  // a bout more changes nothing of that
  for (const int signal : {SIGHUP, SIGINT, SIGTERM}) handle(signal, note_interrupt);  // Bound: 3
}

bool is_interrupted() {
  return interrupted;
}

}  // namespace batuta::host
