// SPDX-License-Identifier: MIT
#pragma once
// What a fencer's eye sees, and how late. Frame V, the viewer's: that of the salle for the left
// fencer, and the same turned by half a turn about z for the right one: x towards the rival, y to
// the viewer's left, z up. Lengths in m. No stick, no plan, no grip: who decides by a Observation
// decides by what anybody in the salle can see.

#include <array>

#include "batuta/fencing/duel.hpp"

namespace batuta::fencing {

/// One fencer, as seen. Frame V.
struct FencerSeen {
  Vec3<float> guard_V = Vec3<float>::Zero();  ///< where the blade begins; the hand is behind it
  Vec3<float> point_V = Vec3<float>::Zero();  ///< where the blade ends
  Vec3<float> torso_V = Vec3<float>::Zero();  ///< the middle of the trunk
};

/// Both fencers at one instant, as one of them sees them.
struct Observation {
  FencerSeen own;       ///< oneself
  FencerSeen rival;     ///< the other
  bool halted = false;  ///< the referee has called halt: heard at once
};

namespace detail {

/// One fencer of a duel from W to the frame V of `viewer`. @pre the scene has targets
template <class DuelT>
FencerSeen fencer_seen(const DuelT& duel, Side side, Side viewer) {
  const float turn = viewer == Side::kLeft ? 1.0F : -1.0F;
  const auto to_V = [turn](const auto& p_W) {
    return Vec3<float>(turn * static_cast<float>(p_W.x()), turn * static_cast<float>(p_W.y()),
                       static_cast<float>(p_W.z()));
  };
  const auto blade_W = duel.blade_W(side);
  const auto& torso_W = duel.body_W(side)[static_cast<std::size_t>(BodyPart::kTorso)].axis;
  FencerSeen seen;
  seen.guard_V = to_V(blade_W.axis.a);
  seen.point_V = to_V(blade_W.axis.b);
  seen.torso_V = 0.5F * (to_V(torso_W.a) + to_V(torso_W.b));
  return seen;
}

}  // namespace detail

/// What `viewer` would see without delay. @pre duel configured; its scene has targets
template <class DuelT>
Observation observation_of(const DuelT& duel, Side viewer) {
  return {detail::fencer_seen(duel, viewer, viewer),
          detail::fencer_seen(duel, other(viewer), viewer), duel.bout().state == BoutState::kHalt};
}

/// Sights on their way from the eye to the decision: what comes out is kDelayUs old or older.
/// Allocates: never. RAM: 872 B.
class DelayedObservation {
 public:
  /// A look is taken so often, us; in a duel with longer steps, once a step.
  static constexpr std::int32_t kLookUs = 15000;
  /// Looks between the eye and the decision.
  static constexpr int kDelayLooks = 10;
  /// No decision knows what is younger, us.
  static constexpr std::int32_t kDelayUs = kLookUs * kDelayLooks;

  /// Nothing has been seen.
  void clear() { *this = {}; }

  /// Once a step. @param step_us  its length, us @returns a look was taken: seen() is another one
  /// @pre step_us > 0
  bool look(const Observation& now, std::int32_t step_us);

  /// There are two looks old enough to be known.
  bool sees() const { return looks_ >= kDelayLooks + 2; }
  /// What is known: kDelayUs old when it is found out, and older until the next look. @pre sees()
  const Observation& seen() const { return ago(kDelayLooks); }
  /// The look before it. @pre sees()
  const Observation& before() const { return ago(kDelayLooks + 1); }
  /// From one look to the next, s: kLookUs in steps that divide it, else the next whole number of
  /// steps. @pre sees(), all steps of one length
  float seconds_per_look() const { return kSecondsPerUs<float> * static_cast<float>(apart_us_); }

 private:
  static constexpr int kKept = kDelayLooks + 2;

  const Observation& ago(int looks) const {
    return kept_[static_cast<std::size_t>((latest_ + kKept - looks) % kKept)];
  }

  std::array<Observation, kKept> kept_{};
  std::int32_t since_us_ = kLookUs;  ///< since the last look; the first step looks at once
  std::int32_t apart_us_ = kLookUs;  ///< the last look from the one before it
  std::int16_t looks_ = 0;           ///< taken; grows no further than kKept
  std::int16_t latest_ = 0;          ///< where the last one is kept
};

}  // namespace batuta::fencing
