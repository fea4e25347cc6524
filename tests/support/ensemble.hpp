// SPDX-License-Identifier: MIT
#pragma once
// Seeded queries for time of contact, in families that are hard in different ways. A query is a
// function of (family, seed, index) alone: shards need no state, and every platform draws the same
// bits. About half of a family's queries are contacts; few overlap at the start.

#include <array>
#include <cstddef>
#include <cstdint>

#include "batuta/detection/moving_pair.hpp"

namespace batuta::test {

enum class Family : std::uint8_t {
  kGeneric,   ///< axes of 0.2 ... 2 m, thick and thin, turns up to pi
  kBlade,     ///< axes of 1 m, 10 mm thick radii, centre of mass near the hilt, turns up to 2 rad
  kFence60,   ///< weapons of 1 m, radius 5 mm, during 1/60 s
  kFence1ms,  ///< the same during 1 ms
  kSpin,      ///< as generic, turns up to 8 pi
  kNearParallel,  ///< axes tilted by 2^-3 ... 2^-24 rad when they meet
  kGraze,         ///< gap of +-2^-1 ... +-2^-24 radii and no normal speed when they meet
  kPendulum,      ///< clear at both ends of the step, overlap or nearly so in its middle
  kBrief,         ///< fast crossings that last a thousandth of the step
  kThin,          ///< radii of 1 um ... 1 mm
  kScaled,        ///< as generic, lengths times 2^-20 ... 2^20
  kFar,           ///< as generic, a kilometre from the origin at 300 m/s
  kTranslation,   ///< as generic, nothing turns
  kSphere,        ///< two balls, nothing turns
  kUnfolding,     ///< axes parallel to rounding at the start, turning out of it
};
inline constexpr std::size_t kFamilyCount = 15;

/// All families, in the order of their numbers.
constexpr std::array<Family, kFamilyCount> all_families() {
  std::array<Family, kFamilyCount> all{};
  for (std::size_t i = 0; i < kFamilyCount; ++i) all[i] = static_cast<Family>(i);
  return all;
}
inline constexpr std::array<Family, kFamilyCount> kFamilies = all_families();

/// Lower-case, one word: the key of a row in a report.
const char* name(Family family);
/// False where no body of the family turns.
bool turns(Family family);

/// Numbers exact in float; quaternions unit to the rounding of float; equal durations.
struct Query {
  MovingCapsule<float> A;
  MovingCapsule<float> B;
};

/// Query `index` of a family. Bound: no loop but the 32 tries for each random direction.
Query make_query(Family family, std::uint64_t seed, std::uint64_t index);

/// The same numbers in Scalar, the quaternion renewed in it.
template <class Scalar>
MovingCapsule<Scalar> cast(const MovingCapsule<float>& moving) {
  MovingCapsule<Scalar> m;
  m.capsule_B.axis.a = moving.capsule_B.axis.a.template cast<Scalar>();
  m.capsule_B.axis.b = moving.capsule_B.axis.b.template cast<Scalar>();
  m.capsule_B.radius = static_cast<Scalar>(moving.capsule_B.radius);
  m.motion.X_WB.p_W = moving.motion.X_WB.p_W.template cast<Scalar>();
  m.motion.X_WB.q_WB = renewed<Scalar>(moving.motion.X_WB.q_WB.template cast<Scalar>());
  m.motion.twist.v_W = moving.motion.twist.v_W.template cast<Scalar>();
  m.motion.twist.w_W = moving.motion.twist.w_W.template cast<Scalar>();
  m.motion.duration = static_cast<Scalar>(moving.motion.duration);
  return m;
}

}  // namespace batuta::test
