// SPDX-License-Identifier: MIT
#pragma once
// What an opponent makes of two late looks; opponent.md says where the numbers come from.

#include "batuta/fencing/opponent.hpp"

namespace batuta::fencing::detail {

/// What two late looks come to.
struct Situation {
  float distance = 0;  ///< between the trunks, m
  float soon = 0;      ///< the distance kForesight later, if both go on
  float pace = 0;      ///< of it, the rival's
  float reach = 0;     ///< of the rival's arm: guard before trunk, m
  float thrust = 0;    ///< its speed, m/s
  float ahead = 0;     ///< from one's own trunk to the rival's point, m
  float upright = 0;   ///< the distance if both stood upright, m
  float gait = 0;      ///< the speed at which the rival's feet come, m/s
  float closing = 0;   ///< the same of both fencers' feet together, m/s
  int line = 0;        ///< in which the rival's blade comes, or would come
};

inline constexpr float kForesight = 0.2F;    ///< s for which two who walk are thought on
inline constexpr float kGuardReach = 0.52F;  ///< m before its trunk: an arm on guard
/// m that a trunk leans for each m of reach beyond that
inline constexpr float kLeanPerReach = 1.55F;

/// The line in which a blade lies, seen from one's own trunk: bounds between what the library's map
/// brings there (map.md).
inline int line_seen(const Observation& sight) {
  constexpr float kOutside = -0.10F;  // m to the viewer's left
  constexpr float kLow = -0.01F;      // m above the trunk's middle
  const Vec3<float> offset = sight.rival.guard_V - sight.own.torso_V;
  const bool inside = offset.y() > kOutside;
  const bool high = offset.z() > kLow;
  if (inside) return high ? 0 : 1;
  return high ? 3 : 2;
}

inline float distance_of(const Observation& sight) {
  return sight.rival.torso_V.x() - sight.own.torso_V.x();
}

inline float reach_of(const Observation& sight) {
  return sight.rival.torso_V.x() - sight.rival.guard_V.x();
}

inline float own_reach_of(const Observation& sight) {
  return sight.own.guard_V.x() - sight.own.torso_V.x();
}

/// How far a trunk has leant forward for a lunge, m: it goes with the arm. A parry draws the guard
/// back, and no trunk.
inline float lean_of(float reach) {
  return reach > kGuardReach ? kLeanPerReach * (reach - kGuardReach) : 0.0F;
}

inline Situation situation_of(const DelayedObservation& eye) {
  const Observation& now = eye.seen();
  const Observation& before = eye.before();
  const float apart = eye.seconds_per_look();
  Situation situation;
  situation.distance = distance_of(now);
  const float nearing = (distance_of(before) - situation.distance) / apart;
  situation.soon = situation.distance - kForesight * nearing;
  situation.pace = (before.rival.torso_V.x() - now.rival.torso_V.x()) / apart;
  situation.reach = reach_of(now);
  situation.thrust = (situation.reach - reach_of(before)) / apart;
  situation.ahead = now.rival.point_V.x() - now.own.torso_V.x();
  situation.line = line_seen(now);
  const float lean = lean_of(situation.reach);
  const float own_lean = lean_of(own_reach_of(now));
  const float leaning = (lean - lean_of(reach_of(before))) / apart;
  const float own_leaning = (own_lean - lean_of(own_reach_of(before))) / apart;
  situation.upright = situation.distance + lean + own_lean;
  situation.gait = situation.pace - leaning;
  situation.closing = nearing - leaning - own_leaning;
  return situation;
}

}  // namespace batuta::fencing::detail
