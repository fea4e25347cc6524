// SPDX-License-Identifier: MIT

#include "programs/files/unfinished_files.hpp"

#include <csignal>

#ifndef _WIN32
#include <unistd.h>

#include <array>
#include <atomic>
#include <cstring>
#endif

namespace batuta::host {

#ifdef _WIN32

void remove_when_ended(const std::string& /*path*/) {}
void keep_when_ended(const std::string& /*path*/) {}

extern "C" void batuta_remove_and_end(int signal) {
  (void)std::signal(signal, SIG_DFL);
  (void)raise(signal);
}

#else

namespace {

constexpr std::size_t kLongest = 4096;  // characters of a path, its end among them

struct Unfinished {
  std::array<char, kLongest> path{};
  std::atomic<bool> used{false};  // what a handler reads while the program is anywhere
};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler must not wait");

std::array<Unfinished, kMostUnfinished> files;

/// What ends a program, but for SIGKILL and the signals that have a number alone.
constexpr int kEnding[] = {
    SIGHUP,    SIGINT, SIGQUIT, SIGTERM, SIGALRM, SIGUSR1, SIGUSR2, SIGVTALRM, SIGPROF,
    SIGXCPU,   SIGSYS, SIGTRAP, SIGABRT, SIGBUS,  SIGFPE,  SIGILL,  SIGSEGV,
#ifdef SIGPOLL
    SIGPOLL,
#endif
#ifdef SIGPWR
    SIGPWR,
#endif
#ifdef SIGSTKFLT
    SIGSTKFLT,
#endif
};

/// Only where nobody has said what is to become of it.
void watch(int signal) {
  struct sigaction now = {};
  if (sigaction(signal, nullptr, &now) != 0 || now.sa_handler != SIG_DFL) return;
  (void)std::signal(signal, batuta_remove_and_end);
}

}  // namespace

extern "C" void batuta_remove_and_end(int signal) {
  for (const Unfinished& file : files) {  // Bound: kMostUnfinished
    if (file.used) (void)unlink(file.path.data());
  }
  (void)std::signal(signal, SIG_DFL);
  (void)raise(signal);
}

void remove_when_ended(const std::string& path) {
  if (path.size() >= kLongest) return;
  for (Unfinished& file : files) {  // Bound: kMostUnfinished
    if (file.used) continue;
    std::memcpy(file.path.data(), path.c_str(), path.size() + 1);
    file.used = true;
    break;
  }
  for (const int signal : kEnding) watch(signal);  // Bound: their number
}

void keep_when_ended(const std::string& path) {
  for (Unfinished& file : files) {  // Bound: kMostUnfinished
    if (file.used && path == file.path.data()) file.used = false;
  }
}

#endif

}  // namespace batuta::host
