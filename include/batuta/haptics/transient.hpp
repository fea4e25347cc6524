// SPDX-License-Identifier: MIT
#pragma once
// What a blow feels like: a short push whose area is the impulse. A loop of a thousand steps a
// second cannot make a contact hard by a spring, and what fingers notice of a blow is its start; so
// the blow's impulse is played to the hand as such, open loop, and the coupling may stay as soft as
// is stable. Stick coordinates: N m for each unit of the stick. Mathematics:
// src/haptics/transient.md.

#include "batuta/core/status.hpp"
#include "batuta/core/types.hpp"

namespace batuta::haptics {

/// No push is felt as a blow that lasts longer, s.
template <class Scalar>
inline constexpr Scalar kLongestPulse = 1;

/// How blows are played.
template <class Scalar>
struct TransientSettings {
  Scalar gain = 1;                   ///< share of a blow's impulse that is played, >= 0
  Scalar duration = Scalar(0.004F);  ///< of a pulse that fits the actuator, s, > 0
  Scalar longest = Scalar(0.03F);    ///< s, duration ... kLongestPulse: what is left then is let go
  Scalar max_force = 40;             ///< along each coordinate, N m for each unit, > 0
};

/// @returns kOk | kInvalidArgument: out of range or not finite
template <class Scalar>
Status validate(const TransientSettings<Scalar>& settings);

/// Pulses of one stick. A blow adds its impulse to what is still to be played, all of which is then
/// played evenly in `duration`, or, at the actuator's limit, for as long as it takes, up to
/// `longest` after the last blow. Allocates: never.
template <class Scalar>
class ImpactTransient {
 public:
  /// Starts anew, silent. @returns kOk | kInvalidArgument (nothing changed)
  Status configure(const TransientSettings<Scalar>& settings);

  /// A blow. @param impulse  N m s for each unit of the stick; not finite: refused
  /// @returns kOk | kInvalidArgument (nothing changed)
  Status strike(const Vec2<Scalar>& impulse);

  /// The mean force over the coming step, and on to its end: the sum of answers times dt is the
  /// impulse that was played. Within max_force. @pre dt > 0, s
  Vec2<Scalar> advance(Scalar dt);

  /// TransientSettings::max_force, of each coordinate.
  Scalar max_force() const { return settings_.max_force; }
  /// Whether the last step's level was held back by max_force: it plays on for longer.
  bool is_clipped() const { return excess_ > Scalar(0); }
  /// Where it was: how far the pulse, as its last blow left it to be played evenly over
  /// TransientSettings::duration, is beyond max_force, in max_force; else 0. May be infinite.
  Scalar excess() const { return excess_; }
  /// Still to be played, N m s for each unit.
  const Vec2<Scalar>& left() const { return left_; }
  /// Let go since the start, because the actuator was not strong enough for long enough: sum of
  /// absolute values along both coordinates, N m s for each unit. 0 in a healthy device.
  Scalar lost() const { return lost_; }

 private:
  TransientSettings<Scalar> settings_;
  Vec2<Scalar> left_ = Vec2<Scalar>::Zero();
  Scalar age_ = 0;  ///< since the last blow, s
  Scalar lost_ = 0;
  Scalar excess_ = 0;  ///< of the pulse, while it is held back
};

/// The blow first, of the rest as much as fits: blow + s rest with the largest s in [0, 1] that
/// stays within `limit` along both coordinates. The direction of either is kept.
/// @pre finite; limit > 0; |blow| <= limit along each coordinate
template <class Scalar>
Vec2<Scalar> mixed(const Vec2<Scalar>& blow, const Vec2<Scalar>& rest, Scalar limit);

}  // namespace batuta::haptics
