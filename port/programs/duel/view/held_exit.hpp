// SPDX-License-Identifier: MIT
#pragma once
// A library that loses its display may end the whole program: Xlib calls exit(). Called by a thread
// that has nothing to finish, exit() waits, and the others finish what they write.

#include <functional>

namespace batuta::host {

class HeldExit {
 public:
  /// As long as this lives, an exit() of this thread calls `told`, and never returns nor ends the
  /// program. @param told  called once, and returns; what it uses may then go, and this with it
  explicit HeldExit(std::function<void()> told);
  HeldExit(const HeldExit&) = delete;
  HeldExit& operator=(const HeldExit&) = delete;
  ~HeldExit();

  /// To be called in place of exit(): where one is held, another one might wait for it for ever.
  /// What was written to standard output is there.
  [[noreturn]] static void end_program(int exit_code);

 private:
  std::function<void()> told_;
};

}  // namespace batuta::host
