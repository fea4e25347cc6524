// SPDX-License-Identifier: MIT
#pragma once
// The way from a demanded force to the actuator of one stick, and the only one: ForceDevice lets
// nobody else write. In this order, each a header of its own:
//   shares of the range, clipped with its direction kept  ->  soft end stop  ->  speed limiter  ->
//   slew limit  ->  ramps: no fresh sample, no fresh command, not enabled  ->  emergency stop.
// Whatever goes in, what comes out is finite and in [-1, 1]. Why this order, and what each step
// promises: src/haptics/output_stage.md.

#include <array>
#include <atomic>

#include "batuta/haptics/end_stop.hpp"
#include "batuta/haptics/force_ramp.hpp"
#include "batuta/haptics/force_share.hpp"
#include "batuta/haptics/slew_limiter.hpp"
#include "batuta/haptics/speed_limiter.hpp"
#include "batuta/port/force.hpp"

namespace batuta::haptics {

/// How the stage shapes the force.
struct StageSettings {
  float dt = 0.001F;  ///< length of a step, s, > 0, finite
  /// Share of the actuator's range for each N m for each unit of the stick, by axis, > 0, finite.
  Vec2<float> gain = {0.01F, 0.01F};
  EndStopSettings end_stop;        ///< at the rim
  SpeedLimitSettings speed_limit;  ///< of each axis
  float slew_rate = 250;           ///< fastest change of a share, 1/s, > 0, finite
  RampSettings samples;            ///< the watchdog over the stick
  RampSettings commands;           ///< the watchdog over whoever demands
  std::int32_t fade = 500;  ///< steps from enable() to the full force, as RampSettings::length
};

/// @returns kOk | kInvalidArgument: out of range
Status validate(const StageSettings& settings);

/// What a step of the stage is made from.
struct StageInput {
  Microseconds time = 0;                       ///< of the step, handed on to the device
  Vec2<float> demanded = Vec2<float>::Zero();  ///< N m for each unit of the stick
  Vec2<float> position = Vec2<float>::Zero();  ///< of the stick, units
  Vec2<float> velocity = Vec2<float>::Zero();  ///< of the stick, 1/s
  /// What made the demand had to cut it already, as HandForce does and passive_force(): counted
  /// with what is cut here.
  bool clipped = false;
  float excess = 0;            ///< >= 0: by how much of the range, at least
  float allowed = 1;           ///< share that a ramp of the demander's own leaves, 0 ... 1
  bool fresh_sample = false;   ///< the stick has said something new
  bool fresh_command = false;  ///< `demanded` was made for this step
};

/// What held the force of a step back.
struct StageLimits {
  bool clipped = false;   ///< the demand did not fit the range, here or where it was made
  bool end_stop = false;  ///< the end stop pushed
  bool speed = false;     ///< the speed limiter took some
  bool slew = false;      ///< the force is still on its way to what it should be
  bool ramped = false;    ///< a ramp has less than the full share
};

/// Counts since configure(); they wrap (at 1 kHz after 49 days: look before, and configure() anew).
struct StageReport {
  std::uint32_t steps = 0;             ///< made
  std::uint32_t clipped = 0;           ///< steps whose demand did not fit, here or where made
  float worst_excess = 0;              ///< the largest demand beyond the range, in ranges
  std::uint32_t invalid = 0;           ///< steps whose input could not be computed with: no demand
  std::uint32_t refused = 0;           ///< commands that the device did not take
  std::uint32_t stops = 0;             ///< steps made while the emergency stop was on
  std::uint32_t sample_silences = 0;   ///< that began, as ForceRamp::silences()
  std::uint32_t command_silences = 0;  ///< of whoever demands, counted in the same way

  /// Steps that were clipped, 0 ... 1: the indicator for a gain that is too high.
  float clipped_share() const {
    return steps == 0 ? 0.0F : static_cast<float>(clipped) / static_cast<float>(steps);
  }
};

/// One for each stick. It starts disabled: configure(), enable(), then step() at a fixed rate.
/// Allocates: never. From one context, but for stop().
class OutputStage final {
 public:
  /// @param device  outlives the stage; no other stage writes to it
  explicit OutputStage(ForceDevice& device) : device_(device) {}
  OutputStage(const OutputStage&) = delete;
  OutputStage& operator=(const OutputStage&) = delete;

  /// Starts anew: disabled, the device told zero. An emergency stop stays on.
  /// @returns kOk | kInvalidArgument (nothing changed)
  Status configure(const StageSettings& settings);

  /// From now on the force comes in, over StageSettings::fade steps.
  /// @returns kOk | kInvalidArgument: not configured | kUnavailable: stopped, reset() comes first
  Status enable();
  /// The force goes, over as many steps.
  void disable() { enabled_ = false; }
  /// Whether enable() was the last word: configure(), disable(), reset() and the first step() after
  /// a stop() end it.
  bool is_enabled() const { return enabled_; }

  /// Emergency stop: zero now, and until reset(). May interrupt a step() where the device's
  /// do_write() may interrupt itself; the step then ends with zero. @param time  now
  void stop(Microseconds time);
  /// Ends an emergency stop; the stage is disabled then, and fades in after enable().
  void reset();
  /// Whether an emergency stop is on.
  bool is_stopped() const { return stopped_.load(); }

  /// A step: the demand through all limits, to the device.
  /// @returns kOk | kInvalidArgument: not configured (nothing is told), or a number is not finite
  /// or out of range:
  ///   the step is made as one without demand, at rest, nothing fresh, as much allowed as before |
  ///   kUnavailable: stopped, or the device is gone; the force fades in when it is back
  /// Bound: no loop but over the two axes.
  Status step(const StageInput& input);

  /// What the last step or configure() told the device; zero by a stop() since then is not in it.
  const ForceCommand& last_command() const { return last_command_; }
  /// What held the last step's force back.
  const StageLimits& limits() const { return limits_; }
  /// Counts since configure().
  const StageReport& report() const { return report_; }

 private:
  struct Axis {
    SpeedLimiter speed;
    SlewLimiter slew;
  };

  Vec2<float> shaped(const StageInput& input);
  float limited(Axis& axis, float share, float position, float velocity);
  float ramped(const StageInput& input);
  Status hand_over(const ForceCommand& command);
  Status cut(Microseconds time);
  void drop_force();

  ForceDevice& device_;
  Vec2<float> gain_ = Vec2<float>::Zero();  ///< of the settings, what steps need
  EndStopSettings end_stop_;
  std::array<Axis, 2> axes_;
  ForceRamp samples_;
  ForceRamp commands_;
  ForceRamp fade_;
  ForceCommand last_command_;
  StageLimits limits_;
  StageReport report_;
  float allowed_ = 1;  ///< StageInput::allowed of the last step that could be computed with
  std::atomic<bool> stopped_{false};
  bool enabled_ = false;
  bool configured_ = false;
};

}  // namespace batuta::haptics
