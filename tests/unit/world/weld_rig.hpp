// SPDX-License-Identifier: MIT
#pragma once
// Bodies as a step has them, without the step: what the tests of bodies and of welds share. What is
// compared with is computed in long double, from poses and momenta alone.

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "batuta/world/detail/bodies.hpp"
#include "batuta/world/scene.hpp"

namespace batuta::test {

using Exact = long double;
using ExactVec = Eigen::Matrix<Exact, 3, 1>;
using ExactMat = Eigen::Matrix<Exact, 3, 3>;
using ExactQuat = Eigen::Quaternion<Exact>;

template <class S>
ExactVec exact(const Vec3<S>& x) {
  return x.template cast<Exact>();
}
template <class S>
ExactMat rotation_of(const Quat<S>& q) {
  return q.template cast<Exact>().normalized().toRotationMatrix();
}

/// Several bodies as one: about their common centre, all in W.
struct Whole {
  Exact mass = 0;
  ExactVec center = ExactVec::Zero();
  ExactVec momentum = ExactVec::Zero();
  ExactVec spin = ExactVec::Zero();  ///< about the centre
  ExactMat inertia = ExactMat::Zero();
  Exact energy = 0;
  Exact size = 0;  ///< summed |p| |x| + |b|: what rounding is relative to

  ExactVec about_origin() const { return center.cross(momentum) + spin; }
};

template <class S>
Whole whole_of(const std::vector<Body<S>>& bodies) {
  Whole whole;
  for (const auto& body : bodies) {
    if (!(body.inverse_mass > S(0))) continue;
    const Exact mass = 1 / Exact(body.inverse_mass);
    whole.mass += mass;
    whole.center += mass * exact(body.X_WB.p_W);
    whole.momentum += exact(body.momentum.linear_W);
  }
  whole.center /= whole.mass;
  for (const auto& body : bodies) {
    if (!(body.inverse_mass > S(0))) continue;
    const Exact mass = 1 / Exact(body.inverse_mass);
    const ExactVec r = exact(body.X_WB.p_W) - whole.center;
    const ExactVec p = exact(body.momentum.linear_W), b = exact(body.momentum.angular_W);
    const ExactMat R = rotation_of(body.X_WB.q_WB);
    const ExactVec inverse = exact(body.inverse_moments);
    const ExactMat own = R * inverse.cwiseInverse().asDiagonal() * R.transpose();
    whole.spin += b + r.cross(ExactVec(p - mass * whole.momentum / whole.mass));
    whole.inertia += own + mass * (r.squaredNorm() * ExactMat::Identity() - r * r.transpose());
    const ExactVec b_B = R.transpose() * b;
    whole.energy += (p.squaredNorm() / mass + b_B.dot(inverse.cwiseProduct(b_B))) / 2;
    whole.size += p.norm() * exact(body.X_WB.p_W).norm() + b.norm();
  }
  return whole;
}

/// w with I w = L, by Cramer's rule.
inline ExactVec solve(const ExactMat& I, const ExactVec& L) {
  const ExactVec a = I.col(0), b = I.col(1), c = I.col(2);
  const Exact volume = a.dot(b.cross(c));
  return ExactVec(L.dot(b.cross(c)), a.dot(L.cross(c)), a.dot(b.cross(L))) / volume;
}

/// The turn of a rigid body that nobody holds, by the fourth-order method in small steps.
inline ExactMat free_turn(const Whole& whole, Exact time) {
  constexpr int kSteps = 400;
  const auto rate = [&whole](const ExactMat& R) {
    const ExactVec w = R * solve(whole.inertia, ExactVec(R.transpose() * whole.spin));
    ExactMat cross;
    cross << 0, -w.z(), w.y(), w.z(), 0, -w.x(), -w.y(), w.x(), 0;
    return ExactMat(cross * R);
  };
  ExactMat R = ExactMat::Identity();
  const Exact h = time / kSteps;
  for (int i = 0; i < kSteps; ++i) {
    const ExactMat k1 = rate(R), k2 = rate(R + h / 2 * k1), k3 = rate(R + h / 2 * k2);
    R += h / 6 * (k1 + 2 * k2 + 2 * k3 + rate(R + h * k3));
  }
  return R;
}

template <class S>
Body<S> random_body(std::mt19937_64& random, double mass, double speed, double spin) {
  std::uniform_real_distribution<double> within(-1, 1);
  const auto vector = [&](double size) {
    return Vec3<S>(S(size * within(random)), S(size * within(random)), S(size * within(random)));
  };
  Quat<S> q(S(within(random)), S(within(random)), S(within(random)), S(within(random)));
  const Vec3<S> moments = S(mass * 0.01) * (Vec3<S>(S(1), S(2), S(2.5)) + vector(0.3));
  auto body = make_body<S>({vector(1), renewed(q)}, S(mass), moments).value;
  body.momentum = momentum_of(body, Twist<S>{vector(speed), vector(spin)});
  return body;
}

/// The bodies of a world at the start of a step.
template <class SceneT>
struct WeldRig {
  using S = typename SceneT::Scalar;
  detail::Bodies<SceneT> bodies{1};
  std::size_t count = 0;

  std::size_t add(const Body<S>& body, const typename SceneT::Controller& controller = {}) {
    Actor<SceneT> actor;
    actor.body = body;
    actor.controller = controller;
    actor.capsule_B = {{Vec3<S>(0, 0, S(-0.05)), Vec3<S>(0, 0, S(0.05))}, S(0.01)};
    EXPECT_TRUE(bodies.actors.make(actor).ok());
    return count++;
  }
  void begin(double dt) {
    bodies.report = {};
    bodies.now = 0;
    bodies.dt = static_cast<S>(dt);
    for (std::size_t slot = 0; slot < count; ++slot) {
      bodies.begin(slot);
      bodies.plan(slot);
    }
  }
  void finish() {
    bodies.now = bodies.dt;
    for (std::size_t slot = 0; slot < count; ++slot) bodies.finish(slot);
  }
  Body<S>& body(std::size_t slot) { return bodies.actor(slot).body; }
  std::vector<Body<S>> all() {
    std::vector<Body<S>> list;
    for (std::size_t slot = 0; slot < count; ++slot) list.push_back(body(slot));
    return list;
  }
};

}  // namespace batuta::test
