// SPDX-License-Identifier: MIT
// Who decides by what an eye sees: late, by sights alone, and no faster than a hand.
#include "batuta/fencing/opponent.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <memory>

#include "draws.hpp"

namespace batuta {
using namespace fencing;
namespace {

constexpr std::int32_t kStepUs = 1000;
constexpr std::array<Skill, 3> kSkills = {Skill::kNovice, Skill::kClub, Skill::kMaster};

Vec3<float> around(test::Draws& draws, double x, double y, double z) {
  const Vec3<double> p = Vec3<double>(x, y, z) + draws.in_ball(0.4);
  return p.cast<float>();
}

/// A rival who comes, goes and threatens at random, every 40 ms somewhere else.
Observation wild_sight(std::uint64_t seed, int step) {
  test::Draws draws(seed, 1, static_cast<std::uint64_t>(step / 40));
  Observation sight;
  sight.own.torso_V = around(draws, -1.1, 0, 1.1);
  sight.own.guard_V = around(draws, -0.6, 0, 1.1);
  sight.own.point_V = around(draws, 0.2, 0, 1.1);
  sight.rival.torso_V = around(draws, 1.1, 0, 1.1);
  sight.rival.guard_V = around(draws, 0.4, 0, 1.1);
  sight.rival.point_V = around(draws, -0.5, 0, 1.1);
  return sight;
}

Opponent opponent(Skill skill, std::uint32_t seed) {
  Opponent one;
  EXPECT_EQ(one.configure(skill, seed), Status::kOk);
  return one;
}

bool same_place(const StickPlace& a, const StickPlace& b) {
  return a.blade == b.blade && a.feet == b.feet;
}

TEST(Opponent, SameSights_SameDecisions) {
  for (const Skill skill : kSkills) {
    Opponent one = opponent(skill, 5);
    Opponent two = opponent(skill, 5);
    for (int step = 0; step < 60000; ++step) {
      const Observation seen = wild_sight(9, step);
      ASSERT_TRUE(same_place(one.step(seen, kStepUs), two.step(seen, kStepUs))) << step;
    }
  }
}

TEST(Opponent, AnotherSeed_AnotherFencer) {
  Opponent one = opponent(Skill::kClub, 5);
  Opponent two = opponent(Skill::kClub, 6);
  int apart = 0;
  for (int step = 0; step < 20000; ++step) {
    const Observation seen = wild_sight(9, step);
    if (!same_place(one.step(seen, kStepUs), two.step(seen, kStepUs))) ++apart;
  }
  EXPECT_GT(apart, 2000);
}

/// What happens from an instant on is not known for 0.15 s, whatever it is.
TEST(Opponent, WhatIsYoungerThanTheDelay_ChangesNothing) {
  int known = 0;
  for (int turn = 1000; turn < 1400; turn += 7) {
    Opponent one = opponent(Skill::kMaster, static_cast<std::uint32_t>(turn));
    Opponent two = opponent(Skill::kMaster, static_cast<std::uint32_t>(turn));
    for (int step = 0; step < turn + 2000; ++step) {
      const bool told = same_place(one.step(wild_sight(9, step), kStepUs),
                                   two.step(wild_sight(step < turn ? 9 : 10, step), kStepUs));
      if (step < turn + 150) {
        ASSERT_TRUE(told) << turn << " " << step;
      } else if (!told) {
        ++known;
        break;
      }
    }
  }
  EXPECT_GT(known, 40);  // and afterwards it is
}

TEST(Opponent, HandIsNoFasterThanAHand_AndStaysInItsSquare) {
  for (const Skill skill : kSkills) {
    Opponent one = opponent(skill, 77);
    StickPlace before = one.place();
    float fastest = 0;
    float fastest_feet = 0;
    for (int step = 0; step < 200000; ++step) {
      const StickPlace& now = one.step(wild_sight(3, step), kStepUs);
      fastest = std::max(fastest, (now.blade - before.blade).norm() / 1e-3F);
      fastest_feet = std::max(fastest_feet, std::abs(now.feet - before.feet) / 1e-3F);
      ASSERT_LE(now.blade.cwiseAbs().maxCoeff(), 1.0F);
      ASSERT_LE(std::abs(now.feet), 1.0F);
      before = now;
    }
    EXPECT_LE(fastest, Opponent::kHandSpeed * 1.001F);
    EXPECT_GT(fastest, 0.5F * Opponent::kHandSpeed);
    EXPECT_LE(fastest_feet, Opponent::kHandSpeed * 1.001F);
    EXPECT_GT(fastest_feet, 0.5F * Opponent::kHandSpeed);
  }
}

TEST(Opponent, BadInput_IsToldOrNotLookedAt) {
  Opponent one = opponent(Skill::kClub, 1);
  EXPECT_EQ(one.configure(static_cast<Skill>(3), 1), Status::kInvalidArgument);
  Observation blind = wild_sight(9, 0);
  blind.rival.guard_V.x() = std::numeric_limits<float>::quiet_NaN();
  for (int step = 0; step < 5000; ++step) {
    const StickPlace& now = one.step(blind, kStepUs);
    ASSERT_TRUE(same_place(now, StickPlace()));  // who sees nothing waits on guard
  }
}

/// From the first instant on, and until they are asked to stand again.
TEST(Opponent, FeetOfWhoRetreats_GoBack) {
  for (const Skill skill : kSkills) {
    Opponent one = opponent(skill, 13);
    int retreats = 0;
    float before = 0;
    float least = 0;
    Intent last = Intent::kWait;
    for (int step = 0; step < 200000; ++step) {
      const float feet = one.step(wild_sight(4, step), kStepUs).feet;
      if (one.intent() == Intent::kRetreat) {
        if (last != Intent::kRetreat) {
          ++retreats;
          least = before;
        }
        // Standing, at most, as long as it hesitates; then back, and to a stand.
        ASSERT_TRUE(feet <= before || feet <= 0) << step;
        least = std::min(least, feet);
      } else if (last == Intent::kRetreat) {
        ASSERT_EQ(least, -1.0F) << step;
      }
      last = one.intent();
      before = feet;
    }
    EXPECT_GT(retreats, 5);
  }
}

bool is_own_attack(Intent intent) {
  return intent == Intent::kAttack || intent == Intent::kBeat;
}

/// Two on guard within a lunge, of whom the rival goes back, followed, while his opponent attacks,
/// or while he does not. Counts how the feet of the latter are asked at the ends of its attacks.
struct Ends {
  int standing = 0;
  int back = 0;
};
Ends ends_of_attacks(bool goes_back_at_attacks) {
  Opponent one = opponent(Skill::kMaster, 21);
  Ends ends;
  int attacks = 0;
  float place = 0;
  float feet = 0;
  Intent last = Intent::kWait;
  for (int step = 0; step < 120000; ++step) {
    const bool goes = is_own_attack(last) == goes_back_at_attacks;
    place += goes ? 1.2e-3F : 0.0F;
    Observation sight;
    sight.own.torso_V = {place - 1.3F, 0, 1.1F};
    sight.own.guard_V = {place - 0.8F, 0, 1.1F};
    sight.own.point_V = {place + 0.1F, 0, 1.1F};
    sight.rival.torso_V = {place + 1.3F, 0, 1.1F};
    sight.rival.guard_V = {place + 0.8F, 0, 1.1F};
    sight.rival.point_V = {place - 0.1F, 0, 1.1F};
    const float now = one.step(sight, kStepUs).feet;
    const bool over = is_own_attack(last) && !is_own_attack(one.intent());
    if (over && ++attacks > 5) {  // by then it has seen what he does
      ends.standing += feet == 0 ? 1 : 0;
      ends.back += feet < -0.5F ? 1 : 0;
    }
    last = one.intent();
    feet = now;
  }
  return ends;
}

TEST(Opponent, WhoGivesGroundAtItsAttacks_GetsNoneBack) {
  const Ends ends = ends_of_attacks(true);
  EXPECT_GT(ends.standing, 20);
  EXPECT_EQ(ends.back, 0);
}

TEST(Opponent, WhoStandsAtItsAttacks_IsLeftTheGround) {
  const Ends ends = ends_of_attacks(false);
  EXPECT_GT(ends.back, 20);
  EXPECT_EQ(ends.standing, 0);
}

/// The right fencer's frame is the left one's turned by half a turn about z.
TEST(Observation, IsTheSalleAsItsViewerSeesIt) {
  const auto duel = std::make_unique<Duel<>>();
  ASSERT_EQ(duel->configure(duel_settings(), first_fencer<float>(), second_fencer<float>()),
            Status::kOk);
  const Observation left = observation_of(*duel, Side::kLeft);
  const Observation right = observation_of(*duel, Side::kRight);
  const Vec3<float> turned(-1, -1, 1);
  EXPECT_EQ(left.own.point_V.cwiseProduct(turned), right.rival.point_V);
  EXPECT_EQ(left.rival.torso_V.cwiseProduct(turned), right.own.torso_V);
  EXPECT_EQ(left.own.guard_V, duel->blade_W(Side::kLeft).axis.a);
  EXPECT_GT(left.rival.torso_V.x(), left.own.torso_V.x());
  EXPECT_GT(right.rival.torso_V.x(), right.own.torso_V.x());
}

/// opponent.md: ten looks of 15 ms.
TEST(DelayedObservation, DelaysByThreeTwentiethsOfASecond) {
  EXPECT_EQ(DelayedObservation::kDelayUs, 150000);
}

/// The first step looks, and then one in each 15 ms, whatever a step is.
TEST(DelayedObservation, LooksAtOnceAndThenEach15Milliseconds) {
  for (const std::int32_t step_us : {1000, 5000, 7500, 15000}) {
    DelayedObservation eye;
    for (std::int32_t step = 0; step < 100; ++step) {
      EXPECT_EQ(eye.look({}, step_us), step * step_us % 15000 == 0) << step_us << ' ' << step;
    }
  }
}

/// A look is kept for kDelayLooks looks, in duels of any step.
TEST(DelayedObservation, IsAsOldAsItSays) {
  for (const std::int32_t step_us : {100, 1000, 7000, 15000, 20000}) {
    DelayedObservation eye;
    for (int step = 0; step < 500; ++step) {
      Observation now;
      now.own.point_V.x() = static_cast<float>(step);
      if (!eye.look(now, step_us) || !eye.sees()) continue;
      const float age_us =
          static_cast<float>(step_us) * (now.own.point_V - eye.seen().own.point_V).x();
      ASSERT_GE(age_us, static_cast<float>(DelayedObservation::kDelayUs));
      ASSERT_LE(age_us, static_cast<float>(DelayedObservation::kDelayLooks *
                                           (DelayedObservation::kLookUs + step_us)));
      ASSERT_LT(eye.before().own.point_V.x(), eye.seen().own.point_V.x());
    }
  }
}

/// What moves at 1 m/s is seen to: a speed is a way over the time between two looks.
TEST(DelayedObservation, TellsHowFarLooksAreApart) {
  for (const std::int32_t step_us : {100, 1000, 7000, 14000, 15000, 16000, 20000}) {
    DelayedObservation eye;
    int seen = 0;
    for (int step = 0; step < 500; ++step) {
      Observation now;
      now.rival.torso_V.x() = 1e-6F * static_cast<float>(step * step_us);
      if (!eye.look(now, step_us) || !eye.sees()) continue;
      const float way = (eye.seen().rival.torso_V - eye.before().rival.torso_V).x();
      ASSERT_NEAR(way / eye.seconds_per_look(), 1.0F, 1e-3F) << step_us;
      ++seen;
    }
    EXPECT_GT(seen, step_us < 1000 ? -1 : 10) << step_us;
  }
}

}  // namespace
}  // namespace batuta
