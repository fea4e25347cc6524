// SPDX-License-Identifier: MIT
#pragma once
// The support of a moving capsule over its motion by scanning and narrowing down, in long double:
// nothing of the closed form of swept_volume.cpp.

#include <algorithm>
#include <cmath>

#include "moving.hpp"

namespace batuta::testing_detection {

using Exact = long double;

inline Vec3<Exact> turned(const Quat<Exact>& q, const Vec3<Exact>& x) {
  const Vec3<Exact> t = 2 * q.vec().cross(x);
  return x + q.w() * t + q.vec().cross(t);
}

/// An end of the capsule, by Rodrigues' formula.
struct TrueEnd {
  Vec3<Exact> lever, axis;
  Vec3<Exact> center, v;
  Exact turn_rate = 0;

  Exact height(const Vec3<Exact>& direction, Exact t) const {
    const Exact angle = turn_rate * t;
    const Exact s = std::sin(angle);
    const Exact versed = 2 * std::sin(angle / 2) * std::sin(angle / 2);
    const Vec3<Exact> moved =
        v * t + s * axis.cross(lever) + versed * axis.cross(axis.cross(lever));
    return direction.dot(center) + (direction.dot(lever) + direction.dot(moved));
  }
};

template <class Scalar>
TrueEnd true_end(const MovingCapsule<Scalar>& m, const Vec3<Scalar>& end_B) {
  TrueEnd end;
  const Quat<Exact> q = m.motion.X_WB.q_WB.template cast<Exact>().normalized();
  const Vec3<Exact> w = m.motion.twist.w_W.template cast<Exact>();
  end.lever = turned(q, end_B.template cast<Exact>());
  end.turn_rate = w.norm();
  end.axis = end.turn_rate > 0 ? Vec3<Exact>(w / end.turn_rate) : Vec3<Exact>::Zero();
  end.center = m.motion.X_WB.p_W.template cast<Exact>();
  end.v = m.motion.twist.v_W.template cast<Exact>();
  return end;
}

/// The highest point on [low, high], where the height has one hump: golden section, to where a hump
/// is flat in long double. Bound: 46 cuts.
inline Exact narrowed(const TrueEnd& end, const Vec3<Exact>& direction, Exact low, Exact high) {
  constexpr Exact kCut = 0.38196601125010515180L;
  Exact a = low + kCut * (high - low);
  Exact b = high - kCut * (high - low);
  Exact at_a = end.height(direction, a);
  Exact at_b = end.height(direction, b);
  for (int i = 0; i < 46; ++i) {
    if (at_a < at_b) {
      low = a;
      a = b;
      at_a = at_b;
      b = high - kCut * (high - low);
      at_b = end.height(direction, b);
    } else {
      high = b;
      b = a;
      at_b = at_a;
      a = low + kCut * (high - low);
      at_a = end.height(direction, a);
    }
  }
  return std::max(at_a, at_b);
}

/// max over time of direction . end: narrowed down around every sample that is not below its
/// neighbours.
inline Exact highest(const TrueEnd& end, const Vec3<Exact>& direction, Exact duration) {
  const int samples = 48 + static_cast<int>(8 * end.turn_rate * duration);
  Exact best = std::max(end.height(direction, 0), end.height(direction, duration));
  Exact before = end.height(direction, 0);
  Exact here = before;
  for (int i = 0; i <= samples; ++i) {
    const Exact after = end.height(direction, duration * std::min(i + 1, samples) / samples);
    if (here >= before && here >= after) {
      const Exact low = duration * std::max(i - 1, 0) / samples;
      const Exact high = duration * std::min(i + 1, samples) / samples;
      best = std::max(best, narrowed(end, direction, low, high));
    }
    before = here;
    here = after;
  }
  return best;
}

template <class Scalar>
Exact true_support(const MovingCapsule<Scalar>& m, const Vec3<Scalar>& direction) {
  const Vec3<Exact> d = direction.template cast<Exact>();
  const auto duration = static_cast<Exact>(m.motion.duration);
  const Exact a = highest(true_end(m, m.capsule_B.axis.a), d, duration);
  const Exact b = highest(true_end(m, m.capsule_B.axis.b), d, duration);
  return std::max(a, b) + d.norm() * static_cast<Exact>(m.capsule_B.radius);
}

}  // namespace batuta::testing_detection
