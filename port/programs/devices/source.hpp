// SPDX-License-Identifier: MIT
#pragma once
// Where a fencer's motion comes from, by the words of the command line. A new kind of device is one
// more line here.

#include <memory>
#include <string>
#include <vector>

#include "batuta/port/input.hpp"

namespace batuta::fencing {
struct Observation;
}  // namespace batuta::fencing

namespace batuta::host {

class LiveForce;
struct ForceOptions;

/// An input device of this port: what a program wants to know beside the samples.
class Source : public InputDevice {
 public:
  Source() = default;
  Source(const Source&) = delete;
  Source& operator=(const Source&) = delete;
  virtual ~Source() = default;

  /// In a few words, for a log: "recording ps2_mouse.events (PS/2 Generic Mouse)".
  virtual std::string description() const = 0;
  /// How long it has something to tell, s; infinite for a device that never ends.
  virtual double duration() const = 0;
  /// Samples that could not be made because the device had lost events.
  virtual std::uint32_t losses() const { return 0; }
  /// Another bout begins: read() is called with `now` from 0 again.
  virtual void rewind() {}
  /// It happens now, and cannot be played faster.
  virtual bool is_live() const { return false; }
  /// Times that it was unplugged.
  virtual std::uint32_t unplugs() const { return 0; }
  /// It decides by what it sees: see() comes before read(), once a step.
  virtual bool sees() const { return false; }
  /// What it would see in the step to come, of length step_us.
  virtual void see(const fencing::Observation& /*sight*/, std::int32_t /*step_us*/) {}
  /// The way back into the hand, opened when it is first asked for; null: there is none.
  virtual LiveForce* force(const ForceOptions& /*options*/) { return nullptr; }
};

/// Rate of a device's line, where the words name none: the STM32 port's
/// (port/platforms/stm32f405/board.hpp).
inline constexpr int kDeviceBaud = 3000000;

struct OpenedSource {
  std::unique_ptr<Source> source;  ///< null if it could not be opened
  std::string error;               ///< why not, in one line
  std::vector<std::string> files;  ///< that were read, or looked for beside those
  std::string note;  ///< what a user should know although it was opened; one line, or empty
  /// Path of the serial line to a device that fences along; empty: none. The source is then the
  /// recording that takes the place of the device's stick, or, where `own_stick`, a ReportedStick.
  std::string line;
  int baud = kDeviceBaud;  ///< of that line; whether it can, SerialPort::open knows
  bool own_stick = false;
};

/// SOURCE: "default", "script:guard|parry|attack", "script:novice|club|master[@SEED]", the path of
/// a recording,
/// "device:/dev/input/eventN|sdl[:INDEX|NAME]", or "serial:LINE[@BAUD][,SOURCE]" with one of the
/// former. Opens recordings and devices, but no line.
OpenedSource open_source(const std::string& words);

}  // namespace batuta::host
