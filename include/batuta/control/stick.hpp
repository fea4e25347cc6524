// SPDX-License-Identifier: MIT
#pragma once
// From time-stamped samples of a device, as irregular as they come, to the stick's position and
// velocity at every step of the simulation: "the velocities are estimated using the elapsed time"
// [Kavan §5], one sample late and without the spikes that a difference over one step would have.
// Stick coordinates: the square [-1, 1]^2. Times: src/control/stick.md.

#include "batuta/core/types.hpp"
#include "batuta/port/input.hpp"

namespace batuta {

/// A float counts microseconds one by one up to here: what is summed up to a longer time in steps
/// of a microsecond would come to a stop (src/control/stick.md).
inline constexpr std::int32_t kLongestSilenceUs = std::int32_t{1} << 24;

/// How a stick's samples become a motion.
struct StickSettings {
  /// Shortest time in which the stick goes to a new sample, us, > 0
  std::int32_t min_interval_us = 1000;
  std::int32_t max_interval_us = 40000;  ///< longest, us, >= min_interval_us
  std::int32_t stale_after_us = 250000;  ///< silence after which the stick counts as stale, us, >=
                                         ///< max_interval_us and at most kLongestSilenceUs
  /// Fastest movement along each axis, 1/s, > 0. Whatever the device claims: it bounds the blade's
  /// speed.
  float max_speed = 16;
};

/// Whether settings are in range.
/// @returns kOk | kInvalidArgument: out of range, or a full movement at max_speed would last beyond
/// stale_after_us
Status validate(const StickSettings& settings);

/// Where the stick goes in a step.
enum class StickFollow : std::uint8_t {
  kAll,   ///< to where the samples say
  kBack,  ///< no further than it draws back: x stays, y goes down as fast as it may, and not up
};

/// What became of a sample.
enum class SampleUse : std::uint8_t {
  kUsed,      ///< the stick is on its way to it
  kRestart,   ///< the same, but its time says nothing: it is the first one, or the first after a
              ///< silence
  kRepeated,  ///< the time stamp of the last one: goal and buttons are corrected, the timing stays;
              ///< refused while the stick is stale: an old stamp is no sign of life
  kBackward,  ///< refused: older than the last one
  kInvalid,   ///< refused: a coordinate is not finite
};

/// What became of the samples since configure().
struct StickReport {
  std::uint32_t used = 0;      ///< with those of kRestart
  std::uint32_t restarts = 0;  ///< samples judged kRestart
  std::uint32_t repeated = 0;  ///< samples judged kRepeated
  std::uint32_t backward = 0;  ///< samples judged kBackward
  std::uint32_t invalid = 0;   ///< samples judged kInvalid
  std::uint32_t lost = 0;      ///< gaps of the sequence numbers
  std::uint32_t clamped = 0;   ///< used, but a coordinate was outside [-1, 1]
  std::uint32_t slowed = 0;    ///< used, but faster than max_speed
  /// Steps without any sign of life for stale_after_us, or before the first sample
  std::uint32_t stale_steps = 0;
};

/// After a sample the stick goes from where it is to where the sample says, at constant velocity,
/// in the time between the last two samples. Allocates: never. ISR-safe: from one context at a
/// time.
template <class Scalar>
class StickTracker {
 public:
  /// Starts anew: at the centre, still, stale. @returns kOk | kInvalidArgument (nothing changed)
  Status configure(const StickSettings& settings);

  /// A sample of the device. A refused one changes nothing but a count, and counts as arrived: its
  /// sequence number is not taken for lost.
  SampleUse accept(const InputSample& sample);

  /// Moves on by one step. @pre dt > 0 and finite, s
  void advance(Scalar dt, StickFollow follow = StickFollow::kAll);

  /// Puts the stick to the centre, still; from there it goes to where the last sample says it is,
  /// as fast as max_speed. A stick that is stale stays at the centre.
  void start_from_centre();

  /// Where the stick is, in [-1, 1]^2.
  const Vec2<Scalar>& position() const { return position_; }
  /// Mean velocity over the last step, 1/s; zero after the stick has arrived and while it is stale:
  /// a stick that becomes stale stops where it is.
  const Vec2<Scalar>& velocity() const { return velocity_; }
  /// No sign of life for StickSettings::stale_after_us, or none at all yet.
  bool is_stale() const { return stale_; }
  /// The second pair of axes, in [-1, 1]^2, as the last sample has it that was used or repeated;
  /// zero while the stick is stale.
  Vec2<Scalar> feet() const {
    if (stale_) return Vec2<Scalar>::Zero();
    return {static_cast<Scalar>(last_.feet_x), static_cast<Scalar>(last_.feet_y)};
  }
  /// The buttons of the last sample that was used or repeated, a bit each.
  std::uint32_t buttons() const { return last_.buttons; }
  /// The number of the next sample, where none is missing; 0: none has come.
  std::uint32_t next_sequence() const { return started_ ? last_.sequence + 1 : 0; }
  /// What became of the samples since configure().
  const StickReport& report() const { return report_; }

  /// Its state, for record/archive.hpp. What is read must have settings that configure() takes, and
  /// be within the square; else it starts anew, at the centre.
  template <class ArchiveT>
  void archive(ArchiveT& ar) {
    auto& [settings, report, last, position, goal, velocity, remaining, silence, stale, started] =
        *this;
    ar(settings, report, last, position, goal, velocity, remaining, silence, stale, started);
    if (!ar.reading() || is_sound()) return;
    ar.require(false);
    *this = StickTracker();
  }

 private:
  bool is_sound() const;
  SampleUse judge(const InputSample& sample) const;
  void follow(const InputSample& sample);
  void keep(const InputSample& sample);
  void aim(const InputSample& sample, Scalar duration);
  Scalar shortest_way() const;

  StickSettings settings_;
  StickReport report_;
  InputSample last_;  ///< the last one used; its sequence number: the last one that came
  Vec2<Scalar> position_ = Vec2<Scalar>::Zero();
  Vec2<Scalar> goal_ = Vec2<Scalar>::Zero();
  Vec2<Scalar> velocity_ = Vec2<Scalar>::Zero();
  Scalar remaining_ = 0;  ///< time to the goal, s
  Scalar silence_ = 0;    ///< since the last used sample, s; grows no further than the limit
  bool stale_ = true;
  bool started_ = false;  ///< there is a last one
};

}  // namespace batuta
