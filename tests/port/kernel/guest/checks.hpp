// SPDX-License-Identifier: MIT
#pragma once
// One line for each check, which the program outside counts group by group: "ok" or "WRONG", group,
// what was looked at, what it has to be, what it is.

#include <string>

#include "link.hpp"

namespace guest {

/// Levels come in steps of 1 / 10000, of which two may add up; angles are cut off to 1 / 18000 of a
/// turn, which is 3.5e-4 of the force.
constexpr double kStep = 6e-4;

class Checks {
 public:
  Checks(Line& its_line, Stick& its_stick) : line(its_line), stick(its_stick) {}

  void begin(const char* group) { group_ = group; }
  void force(const std::string& what, const Force& wanted, const Force& is) const;
  void number(const std::string& what, long wanted, long is) const;

  /// An effect in the device that plays from its beginning, at which no time has passed.
  void start(ff_effect& effect, int times = 1);
  /// Out of the device again: looks whether its force has gone.
  void end(const ff_effect& effect);
  /// Lets time pass with the stick in the middle, and looks at the force.
  void later(const std::string& what, int milliseconds, const Force& wanted);

  Line& line;
  Stick& stick;

 private:
  const char* group_ = "";
};

void capabilities(Checks& checks);
void position(Checks& checks);
void directions(Checks& checks);
void ramp(Checks& checks);
void waves(Checks& checks);
void envelope(Checks& checks);
void times(Checks& checks);
void changes(Checks& checks);
void spring(Checks& checks);
void motion(Checks& checks);
void gain(Checks& checks);
void rumble(Checks& checks);
void together(Checks& checks);
void pool(Checks& checks);
void leaving(Checks& checks);
void unplugging(Checks& checks);

}  // namespace guest
