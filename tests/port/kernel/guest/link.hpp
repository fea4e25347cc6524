// SPDX-License-Identifier: MIT
#pragma once
// Both ends of the stick, seen from inside the machine: as the kernel shows it to programs, and by
// the second serial line as it is, with the force that its motor gets. What cannot be goes to
// give_up(), which says so and ends the program.

#include <linux/input.h>

#include <string>

namespace guest {

struct Force {
  double x = 0;  ///< right, share of the motor's range
  double y = 0;  ///< up
};

/// How the stick moves: x right, y up, 1 is the stop; 1/s, 1/s^2.
struct Movement {
  Force from;
  Force velocity;
  Force acceleration;
  unsigned buttons = 0;
};

[[noreturn]] void give_up(const char* what);

class Line {
 public:
  struct Answer {
    Force force;
    int playing = 0;       ///< effects that play
    unsigned gains = 0;    ///< gain reports that have come to the device
    unsigned refused = 0;  ///< reports that the device has refused
  };

  Line();
  Answer move(int milliseconds, const Movement& movement);
  Answer look() { return move(0, {}); }
  void plug() { ask("plug"); }
  void unplug() { ask("unplug"); }

 private:
  Answer ask(const std::string& command);

  int file_;
};

/// The stick's file in /dev/input.
class Stick {
 public:
  /// Waits until the kernel has it, with its force feedback.
  explicit Stick(Line& line);
  ~Stick() { close(); }
  Stick(const Stick&) = delete;
  Stick& operator=(const Stick&) = delete;
  Stick(Stick&&) = delete;
  Stick& operator=(Stick&&) = delete;

  int effects() const;
  std::string name() const;
  bool has(int type, int code) const;
  int axis(int code) const;
  bool pressed(int key) const;

  /// @returns 0, or the error's number; the kernel writes effect.id
  int upload(ff_effect& effect) const;
  int erase(int id) const;
  int write(int code, int value) const;
  int play(int id, int times) const { return write(id, times); }
  int stop(int id) const { return write(id, 0); }
  int gain(unsigned value);
  /// Returns when all that was asked for has come to the device. The kernel sends reports in their
  /// order, so the gain, said once more, comes behind all others.
  void settle();
  void close();

 private:
  Line& line_;
  int file_ = -1;
  unsigned gain_ = 0xFFFF;
};

}  // namespace guest
