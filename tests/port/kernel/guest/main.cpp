// SPDX-License-Identifier: MIT
// A program in the emulated machine: asks the kernel for effects, and looks at the force that the
// stick's motor gets.

#include <cstdio>

#include "checks.hpp"

int main() {
  using namespace guest;
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  Line line;
  Stick stick(line);
  Checks checks(line, stick);
  line.move(100, {});  // the stage's ramps open
  for (void (*const group)(Checks&) :
       {capabilities, position, directions, ramp, waves, envelope, times, changes, spring, motion,
        gain, rumble, together, pool, leaving, unplugging}) {
    group(checks);
  }
  checks.begin("reports");
  checks.number("refused", 0, static_cast<long>(line.look().refused));
  std::puts("the end");
  return 0;
}
