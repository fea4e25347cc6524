// SPDX-License-Identifier: MIT
#pragma once
// What a fencer's stick means, as data [Kavan §5, Fig. 5]: a table of keys over the square of the
// stick, which may lie in read-only memory, and the surface through them: where the hand is, and
// what the feet are asked. Frames: F the fencer (skeleton.hpp), H the hand, x along the blade; W
// the world. Mathematics: src/fencing/map.md.

#include "batuta/control/keyframes.hpp"
#include "batuta/fencing/skeleton.hpp"

namespace batuta::fencing {

/// Fewest columns and fewest rows of a map.
inline constexpr int kFewestMapKeys = 2;
/// Most columns and most rows of a map.
inline constexpr int kMostMapKeys = 16;
/// Largest order to the feet that a key may have, of either sign: what makes the steepest ramp.
template <class Scalar>
inline constexpr Scalar kLargestFeetKey = Scalar(100);
/// An order to the feet of at most this size is none: between two keys the surface swings by some
/// hundredths of what they differ by, and feet do not follow that.
template <class Scalar>
inline constexpr Scalar kNoOrder = Scalar(0.25F);

/// Where hand and feet are for one place of the stick.
template <class Scalar>
struct MapKey {
  std::array<Scalar, 3> hand_F;  ///< where the hand is, m
  /// Rotation vector of H against the axes of F, rad. The shortest turn that brings +x onto where
  /// the blade points has an x of 0.
  std::array<Scalar, 3> turn_F;
  /// What the feet are asked: share of their speed, -1 back ... 1 forward. Beyond that it makes a
  /// steeper ramp towards the keys beside it.
  Scalar feet;
};
static_assert(sizeof(MapKey<float>) == 7 * sizeof(float), "MapKey: seven numbers, nothing else");

/// A table of keys, which it refers to: they must outlive whoever uses the map. Copied like a
/// pointer.
template <class Scalar>
struct FencerMap {
  /// columns * rows of them, evenly spaced, row by row from the back (y = -1), in a row from left
  /// (x = -1) to right.
  const MapKey<Scalar>* keys = nullptr;
  int columns = 0;  ///< kFewestMapKeys ... kMostMapKeys
  int rows = 0;     ///< kFewestMapKeys ... kMostMapKeys
};

/// @returns kOk | kInvalidArgument: no keys, too few or too many of them, a number that is not
/// finite, a hand beyond kLargestReach, a turn of more than detail::kMaxKeyTurn, or feet beyond
/// kLargestFeetKey
/// Bound: kMostMapKeys^2 keys.
template <class Scalar>
Status validate(const FencerMap<Scalar>& map);

/// What a stick means, for hand and feet; clamped at the rim. Where both are asked for, as in each
/// step of a duel, the keys are looked at once.
template <class Scalar>
struct MapPlace {
  batuta::detail::KeySurface<Scalar> surface;  ///< for hand_at()
  /// What the feet are asked, -1 back ... 1 forward; 0 up to kNoOrder, continuous from there.
  Scalar feet = 0;
};

/// @pre validate() says kOk; stick finite
/// Bound: 16 keys are looked at, whatever the size of the map.
template <class Scalar>
MapPlace<Scalar> place_on(const FencerMap<Scalar>& map, const Vec2<Scalar>& stick);

/// The hand of a place, in W, for a fencer who is somewhere. @pre X_WF finite
template <class Scalar>
KeyedPose<Scalar> hand_at(const MapPlace<Scalar>& place, const Pose<Scalar>& X_WF);

/// The hand that a stick means, in F, and how it moves with the stick, axes of F. Clamped at the
/// rim.
/// @pre validate() says kOk; stick finite
/// Bound: 16 keys are looked at, whatever the size of the map.
template <class Scalar>
KeyedPose<Scalar> hand_at(const FencerMap<Scalar>& map, const Vec2<Scalar>& stick);

/// The same in W, for a fencer who is somewhere.
/// @pre as above; X_WF finite
/// Bound: as above.
template <class Scalar>
KeyedPose<Scalar> hand_at(const FencerMap<Scalar>& map, const Vec2<Scalar>& stick,
                          const Pose<Scalar>& X_WF);

/// MapPlace::feet of a stick.
/// @pre validate() says kOk; stick finite
/// Bound: as above.
template <class Scalar>
Scalar feet_at(const FencerMap<Scalar>& map, const Vec2<Scalar>& stick);

/// Tells maps apart: the ids of two maps that differ are different, but for one pair of some 10^9.
/// The same on every machine, for one Scalar.
/// @pre validate() says kOk
/// Bound: 7 kMostMapKeys^2 numbers, some cycles for each.
template <class Scalar>
std::uint32_t map_id(const FencerMap<Scalar>& map);

/// The map of both fencers of the library: nine columns and five rows (fencer.hpp says what lies
/// where).
template <class Scalar>
const FencerMap<Scalar>& library_map();

}  // namespace batuta::fencing
