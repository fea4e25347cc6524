// SPDX-License-Identifier: MIT
#pragma once
// What a picture of a bout remembers of the way to now: where the tips of the blades went, where
// blade met blade, where somebody was touched. Bounded, however long the bout is.

#include <array>

#include "programs/duel/duel_runner.hpp"
#include "programs/duel/trace.hpp"

namespace batuta::host {

/// Blade met blade with a blow.
struct Beat {
  double time = 0;    ///< s since the start of the bout
  float impulse = 0;  ///< N s
  Vec3<float> point_W = Vec3<float>::Zero();
};

/// A touch.
struct TouchMark {
  std::uint32_t exchange = 1;               ///< its number; two at once have the same
  double time = 0;                          ///< s since the start of the bout
  fencing::Side by = fencing::Side::kLeft;  ///< whose blade
  fencing::BodyPart part = fencing::BodyPart::kPelvis;
  Vec3<float> point_W = Vec3<float>::Zero();
};

/// Allocates nothing.
class BoutStory {
 public:
  static constexpr int kMaxBeats = 400;
  static constexpr int kMaxTouches = 2 * fencing::kMostTouches;

  void clear() { *this = BoutStory(); }
  void add_tip(fencing::Side side, const TracePoint& point) { tips_[index_of(side)].add(point); }
  /// Of more than kMaxBeats the hardest stay.
  void add_beat(const Beat& beat);
  /// Of more than kMaxTouches the first stay.
  void add_touch(const TouchMark& touch) { (void)touches_.push(touch); }
  /// All that the last step of a duel brought but its touches.
  void add_step(const DuelRunner::DuelType& duel);

  const Trace& tips(fencing::Side side) const { return tips_[index_of(side)]; }
  const FixedList<Beat, kMaxBeats>& beats() const { return beats_; }
  std::uint32_t beats_left_out() const { return beats_left_out_; }
  const FixedList<TouchMark, kMaxTouches>& touches() const { return touches_; }

 private:
  std::array<Trace, 2> tips_;
  FixedList<Beat, kMaxBeats> beats_;
  FixedList<TouchMark, kMaxTouches> touches_;
  std::uint32_t beats_left_out_ = 0;
};

}  // namespace batuta::host
