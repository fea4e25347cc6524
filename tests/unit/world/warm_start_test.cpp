// SPDX-License-Identifier: MIT
// What the impulses of the last step are worth in this one (world.md, "Warm start"): a ball on
// another one that is fixed, that turns about an axle and goes nowhere, or that falls with it.
#include <algorithm>

#include "row_rig.hpp"

namespace batuta {
namespace {

using namespace test;

constexpr double kG = 10;
constexpr double kMass = 2;
constexpr double kFall = kG * kStep;  // what gravity gives in the step, m/s

/// What lies below. kFree weighs as much as the ball.
enum class Below { kFixed, kAxle, kFree };

/// One contact with an impulse of the last step, before the sweeps of this one.
struct Started {
  /// @param rises  how fast the ball rises, of kFall, before gravity
  /// @param kept  the impulse, of the ball's weight
  Started(Below below, double rises, double kept) {
    rig.bodies.settings.gravity_W = {0, 0, -kG};
    rig.add(below == Below::kFree ? kMass : 0, 0);
    if (below == Below::kAxle) rig.body(0).inverse_moments = {0, 1, 0};
    rig.add(kMass, 0);
    rig.solve();
    rig.groups.end_step();
    rig.contact(0).points[0].normal = kept * kMass * kFall;
    rig.momentum(0) = 0;
    rig.momentum(1) = kMass * rises * kFall;
    rig.begin();
    for (const std::size_t slot : {0U, 1U}) rig.groups.load(rig.bodies, slot);
    choose(rig.bodies, rig.groups);
    put_in_order(rig.bodies, rig.groups);
    EXPECT_EQ(rig.groups.solved_count, 1);
    energy = warm_up(rig.bodies, rig.groups, {0, 1});
  }
  /// Of the ball, of kFall.
  double rises() const { return rig.groups.solved[1].v_W.z() / kFall; }
  /// Of the ball's weight.
  double given() { return rig.impulse(0) / (kMass * kFall); }

  RowRig rig;
  double energy = 0;  ///< J
};

/// Along s times the impulses the energy is a s + b s^2 / 2. All of them, where a + b / 2 and what
/// half of the fall makes of them is less than a sixteenth of that; else up to the least energy.
/// @param a, b  over the impulse, of kFall  @param lift  the same of half of the fall
double share_of(double a, double b, double lift) {
  if (a + b / 2 + lift < lift / 16) return 1;
  return std::min(1.0, std::max(0.0, -a / b));
}

constexpr double kRises[] = {-1.5, -0.5, -1.0 / 64, 0, 1.0 / 64, 1.0 / 16, 0.25, 0.5, 1.5};
constexpr double kKept[] = {0.5, 1, 2};

// In units of the fall: a = rises - 1, b = kept, and half of the fall is 1 / 2.
TEST(WarmStart, WhatCarries_StartsWhole_UnlessItThrowsUp) {
  int whole = 0, part = 0, none = 0;
  for (const Below below : {Below::kFixed, Below::kAxle}) {
    for (const double rises : kRises) {
      for (const double kept : kKept) {
        Started start(below, rises, kept);
        const double a = rises - 1;
        const double share = share_of(a, kept, 0.5);
        const double joules = kept * kMass * kFall * kFall;
        EXPECT_NEAR(start.given(), share * kept, 1e-9) << rises << ' ' << kept;
        EXPECT_NEAR(start.rises(), a + share * kept, 1e-9) << rises << ' ' << kept;
        const double energy = std::min(0.0, share * a + share * share * kept / 2);
        EXPECT_NEAR(start.energy, energy * joules, 1e-9 * joules) << rises << ' ' << kept;
        whole += share == 1 && -a < kept ? 1 : 0;  // more than takes the least energy
        part += share > 0 && share < 1 ? 1 : 0;
        none += share == 0 ? 1 : 0;
      }
    }
  }
  EXPECT_GE(min_of(whole, min_of(part, none)), 2);
}

// Gravity makes nothing of an impulse between two that fall: a = rises, b = kept (1 + 1).
TEST(WarmStart, BetweenTwoThatFall_AsFarAsItTakesEnergy) {
  for (const double rises : kRises) {
    for (const double kept : kKept) {
      Started start(Below::kFree, rises, kept);
      const double share = share_of(rises, 2 * kept, 0);
      EXPECT_NEAR(start.given(), share * kept, 1e-9) << rises << ' ' << kept;
      EXPECT_NEAR(start.rises(), rises - 1 + share * kept, 1e-9) << rises << ' ' << kept;
    }
  }
}

}  // namespace
}  // namespace batuta
