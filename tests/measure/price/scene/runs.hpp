// SPDX-License-Identifier: MIT
#pragma once
// The runs that are measured: where the bodies of each scene begin. Scenes by hand begin there too.

#include "batuta/mechanics/body.hpp"
#include "batuta/mechanics/straight.hpp"

namespace batuta::price {

inline constexpr float kBladeHalf = 0.45F;
inline constexpr float kBladeRadius = 0.005F;
inline constexpr float kBallRadius = 0.05F;
inline constexpr int kBalls = 8;

/// A place, an axis and a velocity, whatever kind of body is made of them.
struct Start {
  Vec3<float> p_W;
  Quat<float> q_WB;  ///< turns z to axis_W
  Vec3<float> axis_W;
  Vec3<float> v_W;
  Vec3<float> w_W;
};

/// Where the i-th blade or ball begins, until the next is asked for: in a bench that of the run
/// (bench/starts.cpp), in an image nowhere in particular, so that the run is not counted.
const Start& blade_start(int i);
const Start& ball_start(int i);

inline Body<float> turning_blade(int i, bool spins) {
  const Start& start = blade_start(i);
  Body<float> body;
  body.X_WB = {start.p_W, start.q_WB};
  body.inverse_mass = 2;
  body.inverse_moments = {30, 30, 3000};
  Twist<float> twist;
  twist.v_W = start.v_W;
  if (spins) twist.w_W = start.w_W;
  body.momentum = momentum_of(body, twist);
  return body;
}

inline StraightBody<float> straight_body(const Start& start) {
  StraightBody<float> body;
  body.p_W = start.p_W;
  body.inverse_mass = 2;
  body.momentum_W = start.v_W / body.inverse_mass;
  return body;
}

/// The bits of a vector, added to a hash (FNV-1a by words). Bound: 3.
inline std::uint32_t mixed(std::uint32_t hash, const Vec3<float>& v) {
  for (int k = 0; k < 3; ++k) {  // Bound: 3
    std::uint32_t bits = 0;
    const float number = v[k];
    __builtin_memcpy(&bits, &number, sizeof bits);
    hash = (hash ^ bits) * 16777619U;
  }
  return hash;
}
inline std::uint32_t mixed(std::uint32_t hash, const Body<float>& body) {
  const Vec3<float> turn = body.X_WB.q_WB.vec();
  return mixed(mixed(mixed(mixed(hash, body.X_WB.p_W), turn), body.momentum.linear_W),
               body.momentum.angular_W);
}
inline std::uint32_t mixed(std::uint32_t hash, const StraightBody<float>& body) {
  return mixed(mixed(hash, body.p_W), body.momentum_W);
}
inline constexpr std::uint32_t kEmptyHash = 2166136261U;

}  // namespace batuta::price
