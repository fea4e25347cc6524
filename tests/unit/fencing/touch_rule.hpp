// SPDX-License-Identifier: MIT
#pragma once
// A left hand that thrusts at a right fencer whose blade is aside, along keys of its own, so that
// speeds and places are known.

#include <algorithm>
#include <cmath>

#include "configured_duel.hpp"

namespace batuta::test {

using Keys = std::array<fencing::MapKey<float>, 4>;
using V = std::array<float, 3>;

/// A hand that goes from `back` to `front` with y, a blade that points straight forward.
inline Keys way_of(const V& back, const V& front) {
  const fencing::MapKey<float> first{back, {0, 0, 0}, 0};
  const fencing::MapKey<float> last{front, {0, 0, 0}, 0};
  return {first, first, last, last};
}

// The trunk of who stands is upright at x = 2.25 in F of the other, with a radius of 0.13; a blade
// reaches 1 m from its hand, and its end is round by 4.5 mm.
inline constexpr double kTrunkX = 2.25;
inline constexpr double kFront =
    kTrunkX - 0.13 - 1 - 0.0045;         ///< of a hand whose point is at its front
inline constexpr float kMiddle = 0.42F;  ///< where a hand that goes straight forward starts, m
inline constexpr float kReach = 1.2F;    ///< and how far, m

/// The left hand goes as a test has it; the right one is aside, its blade points away from the left
/// one while its stick is at the centre, and crosses the middle from y = 0.7 on.
class TouchRule : public ConfiguredDuel<fencing::Duel<>> {
 protected:
  Keys left_keys = way_of({kMiddle - kReach, 0, 1.15F}, {kMiddle + kReach, 0, 1.15F});
  Keys right_keys = way_of({0.3F, -0.45F, 1.15F}, {0.3F, -0.45F, 1.15F});
  fencing::Fencer<float> left = fencing::first_fencer<float>();
  Vec2<float> at = Vec2<float>::Zero();        ///< where the left stick is
  Vec2<float> other_at = Vec2<float>::Zero();  ///< and the right one
  float other_feet = 0;

  void SetUp() override {
    for (std::size_t i = 0; i < 4; ++i) right_keys[i].turn_F = {0, 0, i < 2 ? -0.8F : 0.8F};
    settings.target = fencing::mask_of(fencing::BodyPart::kTorso);
  }
  void begin() {
    fencing::Fencer<float> right = fencing::first_fencer<float>();
    left.map = {left_keys.data(), 2, 2};
    right.map = {right_keys.data(), 2, 2};
    ASSERT_EQ(duel->configure(settings, left, right), Status::kOk);
    at = other_at = Vec2<float>::Zero();
  }
  void step() {
    InputSample l;
    l.time = 1000 * duel->steps();
    l.sequence = duel->steps();
    InputSample r = l;
    l.x = at.x();
    l.y = at.y();
    r.x = other_at.x();
    r.y = other_at.y();
    r.feet_y = other_feet;
    if (duel->bout().is_over()) return;
    ASSERT_EQ(duel->step(&l, &r), Status::kOk);
  }
  void wait(int steps) {
    for (int k = 0; k < steps; ++k) step();
  }
  /// The stick to y at `rate` per second, and one step more: a stick is one sample late.
  void go(Vec2<float>& stick, float y, float rate) {
    const int steps = static_cast<int>(std::ceil(1000 * std::abs(y - stick.y()) / rate));
    const float start = stick.y();
    for (int k = 1; k <= steps; ++k) {
      stick.y() = start + (y - start) * static_cast<float>(k) / static_cast<float>(steps);
      step();
    }
    step();
  }
  /// The hand straight forward or back to x in F, at `speed`, m/s.
  void thrust(double x, float speed) {
    go(at, (static_cast<float>(x) - kMiddle) / kReach, speed / kReach);
  }
  int touches() const { return duel->bout().touches.size(); }
  const fencing::Touch<float>& touch() const { return duel->bout().touches[0]; }
};

}  // namespace batuta::test
