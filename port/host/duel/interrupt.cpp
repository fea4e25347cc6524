// SPDX-License-Identifier: MIT

#include "host/duel/interrupt.hpp"

#include <csignal>

namespace batuta::host {
namespace {

volatile std::sig_atomic_t interrupted = 0;

extern "C" void note_interrupt(int signal) {
  interrupted = 1;
  (void)std::signal(signal, SIG_DFL);
}

}  // namespace

void watch_interrupts() {
  (void)std::signal(SIGINT, note_interrupt);
  (void)std::signal(SIGTERM, note_interrupt);
}

bool is_interrupted() {
  return interrupted != 0;
}

}  // namespace batuta::host
