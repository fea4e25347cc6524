// SPDX-License-Identifier: MIT
#pragma once
// Balls in a row along z, with the bodies, pairs and contacts of a step and without the step: what
// the tests of ContactGroups share.

#include <gtest/gtest.h>

#include <vector>

#include "batuta/world/detail/contact_groups.hpp"
#include "batuta/world/scene.hpp"

namespace batuta::test {

constexpr int kRoom = 5;
constexpr SceneOptions row_options() {
  SceneOptions scene;
  scene.max_bodies = 8;
  scene.max_pairs = 28;
  scene.max_contacts = kRoom;
  scene.resting = RestingContact::kSettling;
  scene.sleep = scene.gravity = true;
  return scene;
}
using Row = Scene<row_options, Advancement<double>>;

constexpr double kRadius = 0.1;
constexpr double kD = 1e-4;
constexpr double kNear = kD / 2;  // a gap that may not close: what touches
constexpr double kStep = 1e-3;
constexpr double kExact = 1e-12;  // some 1,000 roundings of double

/// A step's bodies, pairs and contacts. Slots are the places in the row.
struct RowRig {
  detail::Bodies<Row> bodies{1};
  detail::Pairs<Row> pairs;
  detail::ContactGroups<Row> groups;
  std::size_t count = 0;
  double restitution = 0;                ///< of a neighbour's blow
  std::vector<detail::ProxyPair> blows;  ///< that were asked for
  std::vector<std::size_t> woken;

  RowRig() { bodies.settings.gravity_W.setZero(); }

  /// A ball on top of the row. @param mass  0: fixed
  std::size_t add(double mass, double velocity, double gap = kNear) {
    const double top = count == 0 ? 0 : z(count - 1) + 2 * kRadius + gap;
    Actor<Row> ball;
    const Vec3<double> moments = Vec3<double>::Constant(0.4 * kRadius * kRadius);
    ball.body = make_body<double>({{0, 0, top}, Quat<double>::Identity()}, 1, moments).value;
    ball.body.inverse_mass = mass > 0 ? 1 / mass : 0;
    if (mass > 0) {
      ball.body.inverse_moments /= mass;
    } else {
      ball.body.inverse_moments.setZero();
    }
    ball.body.momentum.linear_W.z() = mass * velocity;
    ball.capsule_B = Capsule<double>::sphere(Vec3<double>::Zero(), kRadius);
    EXPECT_TRUE(bodies.actors.make(ball).ok());
    return count++;
  }
  Body<double>& body(std::size_t slot) { return bodies.actor(slot).body; }
  double& z(std::size_t slot) { return body(slot).X_WB.p_W.z(); }
  double& momentum(std::size_t slot) { return body(slot).momentum.linear_W.z(); }
  double velocity(std::size_t slot) { return body(slot).inverse_mass * momentum(slot); }
  double sum() {
    double all = 0;
    for (std::size_t i = 0; i < count; ++i) all += momentum(i);
    return all;
  }
  static detail::ProxyPair pair(std::size_t a) {
    return {static_cast<std::uint16_t>(a), static_cast<std::uint16_t>(a + 1)};
  }
  detail::LastingContactOf<Row>& contact(std::size_t a) {
    const int i = groups.contacts.find(pair(a));
    EXPECT_GE(i, 0) << a;
    return groups.contacts[max_of(i, 0)];
  }
  double impulse(std::size_t a) { return contact(a).points[0].normal; }

  /// The start of a step: neighbours are looked at, but where both sleep.
  void begin() {
    bodies.report = {};
    bodies.now = 0;
    bodies.dt = kStep;
    pairs.begin_step();
    for (std::size_t i = 0; i < count; ++i) (void)bodies.begin(i);
    for (std::size_t i = 0; i + 1 < count; ++i) {
      if (bodies.is_asleep(i) && bodies.is_asleep(i + 1)) continue;
      detail::CandidatePair<double> candidate;
      candidate.pair = pair(i);
      EXPECT_TRUE(pairs.candidates.push(candidate));
    }
    groups.find_near(bodies, pairs);
  }
  void solve() {
    begin();
    groups.solve(bodies);
    for (std::size_t i = 0; i < count; ++i) bodies.plan(i);
  }
  /// What a world does when asked: Newton's blow, and wakes all that sleep against each other.
  struct Passing {
    RowRig& rig;
    void blow(detail::ProxyPair pair) const {
      rig.blows.push_back(pair);
      const double soft = rig.body(pair.first).inverse_mass + rig.body(pair.second).inverse_mass;
      const double approach = rig.velocity(pair.first) - rig.velocity(pair.second);
      const double impulse = (1 + rig.restitution) * approach / soft;
      if (rig.body(pair.first).inverse_mass > 0) rig.momentum(pair.first) -= impulse;
      if (rig.body(pair.second).inverse_mass > 0) rig.momentum(pair.second) += impulse;
    }
    void wake(std::size_t slot) const {
      rig.woken.push_back(slot);
      rig.bodies.states[slot].asleep = false;
      rig.bodies.states[slot].plan.by_momentum = true;
      rig.groups.wake(slot);
      rig.groups.contacts.for_each_neighbour(slot, [this](std::size_t other) {
        if (rig.bodies.states[other].asleep) wake(other);
      });
    }
  };
  /// The lowest ball comes to the next one, whom a blow has given so much of its momentum, N s.
  void meet(double given) {
    z(0) = z(1) - 2 * kRadius - kNear;
    bodies.plan(0);
    momentum(1) += given;
    momentum(0) -= given;
  }
  /// What a blow between ball a and the next one has left in the momenta is passed on.
  void pass_on(std::size_t a) {
    detail::StruckPair<double> struck;
    struck.pair = pair(a);
    groups.pass_on(bodies, std::vector<detail::StruckPair<double>>{struck}, Passing{*this});
  }
};

}  // namespace batuta::test
