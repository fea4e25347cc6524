// SPDX-License-Identifier: MIT
// What turns about an axle and goes nowhere carries what lies on it, and shares its spin with it.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "law_worlds.hpp"

namespace batuta {
namespace {

constexpr double kGravity = 9.81;  // m/s^2
constexpr double kMu = 0.5;

/// D of these bodies, m.
double gap_of_rest(double dt) {
  return max_of(1e-4, kGravity * dt * dt / 4);
}

/// A solid roller along x that turns about its own axis and cannot be moved elsewhere.
template <class SceneT>
Actor<SceneT> roller(double length, double radius, double y, double spin) {
  using S = typename SceneT::Scalar;
  auto actor = test::solid_rod<SceneT>(length, radius, {0, y, 0}, test::along_x());
  const S inverse_moment = actor.body.inverse_moments.z();  // about its axis
  actor.body.inverse_mass = 0;
  actor.body.inverse_moments = Vec3<S>(0, 0, inverse_moment);
  actor.body.momentum.angular_W = Vec3<S>(static_cast<S>(spin) / inverse_moment, 0, 0);
  actor.friction = static_cast<S>(kMu);
  return actor;
}

/// Two rollers of radius R that spin, and a rod of radius r in the groove between them.
template <class SceneT>
struct Groove {
  using S = typename SceneT::Scalar;

  Groove(double R, double r, double spin, double dt_s) : dt(dt_s) {
    auto settings = world.settings();
    settings.gravity_W = Vec3<S>(0, 0, static_cast<S>(-kGravity));
    EXPECT_EQ(world.configure(settings), Status::kOk);
    const double aside = 0.7 * (R + r);
    for (std::size_t i = 0; i < 2; ++i) {
      const double y = i == 0 ? -aside : aside;
      rollers[i] = world.add(roller<SceneT>(8 * r, R, y, spin)).value;
    }
    const double apart = R + r + gap_of_rest(dt) / 2;
    auto resting = test::solid_rod<SceneT>(
        6 * r, r, {0, 0, std::sqrt(apart * apart - aside * aside)}, test::along_x());
    resting.friction = static_cast<S>(kMu);
    rod = world.add(resting).value;
  }
  void step() {
    ASSERT_EQ(world.step(static_cast<S>(dt)), Status::kOk);
    ASSERT_TRUE(world.report().complete());
  }
  const Body<S>& body(typename World<SceneT>::BodyId id) const { return world.get(id)->body; }
  double spin_of(typename World<SceneT>::BodyId id) const {
    return static_cast<double>(twist_of(body(id)).w_W.x());
  }

  double dt;
  World<SceneT> world;
  std::array<typename World<SceneT>::BodyId, 2> rollers;
  typename World<SceneT>::BodyId rod;
};

template <class S>
class Axles : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Axles, Scalars);

// Nothing turns, and nothing has the velocity of a fall that does not happen.
TYPED_TEST(Axles, WhatRestsOnThem_Rests) {
  constexpr double kRadius = 0.03;
  for (const double r : {0.03, 0.1}) {
    for (const double dt : {1e-3, 1.0 / 60, 1.0 / 30}) {
      Groove<test::Settling<TypeParam, test::kFalling>> groove(kRadius, r, 0, dt);
      double fastest = 0;
      for (int i = 0; i < std::lround(2 / dt); ++i) {
        groove.step();
        if (i < std::lround(1 / dt)) continue;  // it settles into its gaps
        const auto& rod = groove.body(groove.rod);
        fastest = std::max(fastest, static_cast<double>(twist_of(rod).v_W.norm()));
        for (const auto& id : groove.rollers) {
          fastest = std::max(fastest, std::abs(groove.spin_of(id)) * kRadius);
        }
      }
      // Sweeps end where no visit changes a velocity by more than D / 64 in the step.
      EXPECT_LT(fastest, gap_of_rest(dt) / 64 / dt) << r << ' ' << dt;
    }
  }
}

TYPED_TEST(Axles, WhatRestsOnThem_Sleeps) {
  for (const double r : {0.03, 0.1}) {
    for (const double dt : {1e-3, 1.0 / 60, 1.0 / 30}) {
      Groove<test::Settling<TypeParam, test::kSleeping>> groove(0.03, r, 0, dt);
      for (int i = 0; i < std::lround(1.5 / dt); ++i) groove.step();
      EXPECT_EQ(groove.world.report().asleep, 3U) << r << ' ' << dt;
    }
  }
}

// Friction turns the rod and slows the rollers until surface runs on surface. Each roller has then
// lost I (w0 - w) = J R, and the rod has won 2 J r = I_rod W, with w R = W r.
TYPED_TEST(Axles, SpinningRollers_ShareTheirSpinWithARod) {
  for (const double R : {0.03, 0.06}) {
    for (const double dt : {1e-3, 1e-2}) {
      const double r = 0.03;
      const double w0 = 5;  // rad/s
      Groove<test::Settling<TypeParam, test::kFalling>> groove(R, r, w0, dt);
      const double I_roller =
          1 / static_cast<double>(groove.body(groove.rollers[0]).inverse_moments.z());
      const double I_rod = 1 / static_cast<double>(groove.body(groove.rod).inverse_moments.z());
      for (int i = 0; i < std::lround(2 / dt); ++i) groove.step();
      const double w = w0 / (1 + I_rod * R * R / (2 * I_roller * r * r));
      for (const auto& id : groove.rollers) {
        EXPECT_NEAR(groove.spin_of(id) / w, 1, 0.01) << R << ' ' << dt;
      }
      EXPECT_NEAR(-groove.spin_of(groove.rod) * r / (w * R), 1, 0.01) << R << ' ' << dt;
    }
  }
}

}  // namespace
}  // namespace batuta
