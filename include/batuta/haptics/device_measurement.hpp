// SPDX-License-Identifier: MIT
#pragma once
// Measures one axis of a stick with a motor, by short motions that the motor makes while nobody
// holds it: damping, friction, mass, delay and encoder step, each with what it may be off by, for
// the gain advisor. It asks for a force and decides nothing about the motor: what it asks goes
// through an output stage like every demand. Mathematics: src/haptics/device_measurement.md.
// Units as in gain_advisor.hpp.

#include "batuta/core/status.hpp"
#include "batuta/haptics/detail/encoder_grid.hpp"
#include "batuta/haptics/detail/momentum_fit.hpp"
#include "batuta/haptics/gain_advisor.hpp"
#include "batuta/port/clock.hpp"

namespace batuta::haptics {

/// What is known of a device, and how far it may go.
struct MeasurementSettings {
  float period = 0.001F;     ///< T, s, > 0
  float force_limit = 0;     ///< J/u, > 0: what a share of 1 makes; all forces are measured by it
  float travel = 1;          ///< u, > 0: from the centre to the rim
  float most_share = 0.5F;   ///< the most that is asked for, in (0, 1]
  float excursion = 0.25F;   ///< u, > 0: how far to either side of where it starts
  float safe_window = 0.6F;  ///< u, > excursion, <= travel: from the centre; beyond, it is given up
  /// J/u^2, >= 0: of a centring spring that the stick has; more is taken for a hand that holds it.
  float most_stiffness = 0;
};

/// @returns kOk | kInvalidArgument: out of range or not finite
Status validate(const MeasurementSettings& settings);

/// What a step of the measurement is made from.
struct MeasurementInput {
  Microseconds time = 0;  ///< of the sample; of no meaning where it is not fresh
  float position = 0;     ///< of the axis, u
  /// Share that the device was told last (OutputStage::last_command()): what was asked for, as far
  /// as it was let through.
  float applied = 0;
  bool fresh = false;  ///< there is a new sample
};

/// How far it is, or why it was given up. Of the last five, what is found first.
enum class MeasurementState : std::uint8_t {
  kIdle,          ///< not configured
  kRunning,       ///< goes on: step() again
  kMeasured,      ///< done: estimates()
  kNotStill,      ///< the stick moves without a force, or is not near the centre
  kNoMotion,      ///< most_share does not move it, or did and does no more
  kLeftWindow,    ///< beyond safe_window
  kNoSamples,     ///< too many samples in a row, or in all, did not come
  kWrongPeriod,   ///< samples are not as far apart as `period` says, or not in the mean: to 0.25 %
  kHeldBack,      ///< the device was told far less than what was asked for, or more
  kNotANumber,    ///< an input was not finite
  kTooFew,        ///< too few pieces of motion could be used: too fast, or too coarse an encoder
  kDelayTooLong,  ///< 16 periods or longer
  /// It does not move as mass, damping, friction, spring and offset do, or not always as the same.
  kDoesNotFit,
  kHeld,  ///< something pulls it back to where it was: a hand, or a spring not stated
  /// It fits, but what was seen does not tell these apart; or no step divides most ways of the
  /// encoder.
  kCannotTell,
};

/// A number, and what it may be off by.
struct Estimate {
  float value = 0;  ///< in the unit that is stated where it stands
  float sigma = 0;  ///< standard error, with the share of the encoder
};

/// What was measured.
struct DeviceEstimates {
  Estimate damping;       ///< b, J s/u^2
  Estimate friction;      ///< f_c, J/u
  Estimate mass;          ///< J s^2/u^2
  Estimate stiffness;     ///< J/u^2, of a spring in the device, or of a hand that holds it
  Estimate offset;        ///< J/u, that holds it where it starts: of a weight that is not balanced
  Estimate delay;         ///< periods from a sample until its force is held; in parts, too
  Estimate encoder_step;  ///< u; a value of 0: finer than sigma, which is then the most it can be
  float misfit = 0;       ///< what the fit leaves, as a share of the force; of a good device < 0.02
};

/// One axis. Fixed storage, a bounded number of steps. Allocates: never.
class DeviceMeasurement {
 public:
  /// Steps until it ends at the latest.
  static constexpr int kMostSteps = 60'000;

  /// Starts anew. @returns kOk | kInvalidArgument (nothing changed)
  Status configure(const MeasurementSettings& settings);

  /// One period. Call it once for each, whether a sample has come or not.
  /// @returns the share to ask for, within most_share; 0 where state() is not kRunning.
  /// Bound: that of MomentumFit::take(), and after each of four sweeps of its solve().
  float step(const MeasurementInput& input);

  /// How far it is, or how it ended.
  MeasurementState state() const { return state_; }
  /// Of meaning where state() is kMeasured; else as far as it came.
  const DeviceEstimates& estimates() const { return estimates_; }
  /// Periods so far.
  int steps() const { return steps_; }

 private:
  enum class Phase : std::uint8_t { kSettling, kRamping, kSweeping };

  MeasurementState watch(const MeasurementInput& input);
  bool is_timed(Microseconds time);
  MeasurementState move();
  MeasurementState settle();
  MeasurementState ramp();
  MeasurementState sweep();
  MeasurementState turn();
  MeasurementState conclude();
  void push(float share) { asked_ = share; }

  MeasurementSettings settings_;
  detail::EncoderGrid grid_;
  detail::MomentumFit fit_;
  std::array<detail::MomentumResult, 3> early_;  ///< what the first one, two, three sweeps say
  DeviceEstimates estimates_;
  std::array<float, 2> learnt_{};  ///< by direction: u to brake later by than a free mass would
  float brake_at_ = 0;             ///< u beyond the start, where the push of the stroke ends
  float position_ = 0;             ///< latest
  float start_ = 0;                ///< where it stood
  float extreme_ = 0;              ///< of the stroke
  float share_ = 0;                ///< with which strokes are made
  float least_share_ = 0;          ///< it has stood still with less
  float asked_ = 0;
  float late_ = 0;   ///< s, of the latest sample as the first one says
  float drift_ = 0;  ///< s by which the latest sample is later than the first of its stretch says
  float direction_ = 1;  ///< of the stroke
  int steps_ = 0;
  int in_phase_ = 0;  ///< steps in the phase, or of the stroke
  int strokes_ = 0;   ///< of the sweep
  int sweep_ = 0;
  int missing_ = 0;    ///< samples in a row
  int lost_ = 0;       ///< samples in all
  int held_back_ = 0;  ///< steps that were told less than half of what was asked
  int silent_ = 0;     ///< periods since time_
  int stretch_ = 0;    ///< periods over which the mean period is looked at
  Microseconds time_ = 0;
  Phase phase_ = Phase::kSettling;
  MeasurementState state_ = MeasurementState::kIdle;
  bool has_time_ = false;
  bool brakes_ = false;
};

/// What the advisor is given: damping and friction less `margin` standard errors and no less than
/// 0, the encoder step more by as many, the delay more by as many and rounded up to whole periods.
/// A delay that is then less than a tenth beyond a whole number is that number, and the damping is
/// made less by what the rest takes: src/haptics/gain_advisor.md, "Delays in parts".
/// @param margin  standard errors, >= 0; 3 holds for all but one device in some hundreds
/// @returns kOk | kInvalidArgument: settings or margin out of range, a number of the estimates is
///   not finite, whether the profile has it or not, or a standard error is negative
Result<DeviceProfile<float>> measured_profile(const MeasurementSettings& settings,
                                              const DeviceEstimates& estimates, float margin);

}  // namespace batuta::haptics
