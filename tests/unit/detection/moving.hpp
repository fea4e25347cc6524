// SPDX-License-Identifier: MIT
#pragma once
// Moving capsules written in one line, and random ones that are the same on every platform.

#include <random>

#include "batuta/detection/moving_pair.hpp"

namespace batuta::testing_detection {

/// A capsule by the ends of its axis about its centre of mass.
struct Capsule64 {
  Vec3<double> center, end_a, end_b;
  double radius = 0;
  Vec3<double> v = Vec3<double>::Zero();
  Vec3<double> w = Vec3<double>::Zero();
};

template <class Scalar = double>
MovingCapsule<Scalar> moving(const Capsule64& c, double duration = 1) {
  MovingCapsule<Scalar> m;
  m.capsule_B.axis = {c.end_a.cast<Scalar>(), c.end_b.cast<Scalar>()};
  m.capsule_B.radius = static_cast<Scalar>(c.radius);
  m.motion.X_WB.p_W = c.center.cast<Scalar>();
  m.motion.twist = {c.v.cast<Scalar>(), c.w.cast<Scalar>()};
  m.motion.duration = static_cast<Scalar>(duration);
  return m;
}

/// Uniform in [-1, 1], from the bits of the generator alone.
inline double signed_unit(std::mt19937& random) {
  return static_cast<double>(random()) * 0x1p-31 - 1;
}

inline Vec3<double> random_vector(std::mt19937& random, double size) {
  const double x = signed_unit(random);
  const double y = signed_unit(random);
  const double z = signed_unit(random);
  return size * Vec3<double>(x, y, z);
}

template <class Scalar>
MovingCapsule<Scalar> random_moving(std::mt19937& random, double turn, double scale = 1) {
  Capsule64 c;
  c.center = random_vector(random, 3 * scale);
  c.end_a = random_vector(random, scale);
  c.end_b = random_vector(random, scale);
  c.radius = scale * (0.05 + 0.05 * signed_unit(random));
  c.v = random_vector(random, 2 * scale);
  c.w = random_vector(random, turn);
  MovingCapsule<Scalar> m = moving<Scalar>(c, 1);
  const Vec3<double> r = random_vector(random, 3);
  m.motion.X_WB.q_WB = exp_map(r.cast<Scalar>().eval());
  return m;
}

/// The capsule in W at time t by way of the pose: independent of CapsulePath.
template <class Scalar>
Capsule<double> capsule_by_pose(const MovingCapsule<Scalar>& m, double t) {
  Motion<double> motion;
  motion.X_WB.p_W = m.motion.X_WB.p_W.template cast<double>();
  motion.X_WB.q_WB = m.motion.X_WB.q_WB.template cast<double>().normalized();
  motion.twist.v_W = m.motion.twist.v_W.template cast<double>();
  motion.twist.w_W = m.motion.twist.w_W.template cast<double>();
  motion.duration = static_cast<double>(m.motion.duration);
  const Capsule<double> capsule{
      {m.capsule_B.axis.a.template cast<double>(), m.capsule_B.axis.b.template cast<double>()},
      static_cast<double>(m.capsule_B.radius)};
  return to_world(pose_at(motion, t), capsule);
}

}  // namespace batuta::testing_detection
