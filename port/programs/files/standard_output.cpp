// SPDX-License-Identifier: MIT

#include "programs/files/standard_output.hpp"

#include <csignal>
#include <cstdio>
#include <initializer_list>

#ifndef _WIN32
#include <fcntl.h>
#include <unistd.h>
#endif

namespace batuta::host {
namespace {

/// A stream that the caller has closed is held by one that takes and gives nothing: the next file
/// that is opened would get its number, and what is printed.
void hold_closed_streams() {
#ifndef _WIN32
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {  // Bound: 3
    if (fcntl(stream, F_GETFD) < 0)
      (void)open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
  }
#endif
}

}  // namespace

void begin_output() {
#ifndef _WIN32
  (void)std::signal(SIGPIPE, SIG_IGN);
  (void)std::signal(SIGXFSZ, SIG_IGN);
#endif
  hold_closed_streams();
}

// What goes to std::cout goes through stdout as well, as long as nobody parts the two.
bool is_output_lost() {
  return std::ferror(stdout) != 0;
}

int finish_output(const char* program, int exit_code) {
  const bool flushed = std::fflush(stdout) == 0;
  if (flushed && !is_output_lost()) return exit_code;
  std::fprintf(stderr, "%s: the output cannot be written\n", program);
  return kExitOutputLost;
}

}  // namespace batuta::host
