// SPDX-License-Identifier: MIT
#pragma once
// An effect block: what the host has said of it, and the force it makes of the stick's state and
// its own time.

#include <array>

#include "batuta/core/types.hpp"
#include "shared/hid_pid/condition.hpp"
#include "shared/hid_pid/playback.hpp"
#include "shared/hid_pid/reports.hpp"
#include "shared/hid_pid/waveform.hpp"

namespace batuta::pid {

/// What conditions look at, as shares of the full scale, each -1 ... 1; x right, y up.
struct Metrics {
  Vec2<float> position{0.0F, 0.0F};
  Vec2<float> velocity{0.0F, 0.0F};
  Vec2<float> acceleration{0.0F, 0.0F};
  float friction_knee = 1;  ///< velocity at which friction has its full size
};

/// Numbers stay as the reports have them, in 16 bits, until they are used.
class Effect {
 public:
  Effect() = default;
  /// As CreateNewEffect makes it: silent until a SetEffect report is taken, which says how long and
  /// from where.
  explicit Effect(EffectType type) : type_(type), live_(true) {}

  bool live() const { return live_; }
  EffectType type() const { return type_; }
  bool playing() const { return playback_.playing(); }

  /// Takes a report's parameters; what plays goes on with them.
  /// @returns true | false: they are those of another type of effect; nothing was changed
  bool set(const SetEffect& report);
  bool set(const SetEnvelope& report);
  bool set(const SetCondition& report);
  bool set(const SetPeriodic& report);
  bool set(const SetConstant& report);
  bool set(const SetRamp& report);

  /// Plays it from its beginning. @param loops  as in the report EffectOperation
  void start(std::uint8_t loops);
  void stop() { playback_.stop(); }
  /// Lets time go by. @param step_us  < 2^31
  void advance(std::uint32_t step_us);
  /// The force, x right and y up, with the effect's gain; 0 unless it sounds. Each component within
  /// [-2, 2]: an offset may come on top of a magnitude.
  /// Bound: no loop; one sine.
  Vec2<float> force(const Metrics& metrics) const;

 private:
  bool per_axis() const { return blocks_ == kBothBlocks || !has_direction_; }
  /// The force that comes from the direction; its size has a sign.
  float wind() const;
  float steady() const;
  float held(const Condition& condition, float metric, float knee) const;
  Vec2<float> along_direction(float size) const;
  Vec2<float> condition_force(const Metrics& metrics) const;

  static constexpr std::uint8_t kSecondBlock = 2;
  static constexpr std::uint8_t kBothBlocks = 3;

  EffectType type_ = EffectType::kConstant;
  bool live_ = false;
  std::uint8_t gain_ = kFullGain;
  bool axis_x_ = false;
  bool axis_y_ = false;
  bool has_direction_ = true;
  bool set_ = false;         ///< a SetEffect report was taken
  std::uint8_t blocks_ = 0;  ///< bit i: parameter block i has come
  std::uint16_t duration_ms_ = 0;
  std::uint16_t delay_ms_ = 0;
  std::int16_t first_ = 0;   ///< magnitude, or the ramp's start
  std::int16_t second_ = 0;  ///< offset, or the ramp's end
  std::uint16_t phase_ = 0;
  std::uint16_t period_ms_ = 0;
  Envelope envelope_;
  Vec2<float> direction_{0.0F, 1.0F};
  std::array<Condition, 2> conditions_{};
  Playback playback_;
};

}  // namespace batuta::pid
