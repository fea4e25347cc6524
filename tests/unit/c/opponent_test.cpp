// SPDX-License-Identifier: MIT
// The opponents for C against the library's own, step by step.

#include "batuta/fencing/opponent.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "batuta/c/duel.h"
#include "batuta/fencing/duel.hpp"
#include "batuta/record/duel.hpp"

namespace batuta {
using namespace fencing;
namespace {

constexpr std::int32_t kStepUs = 1000;

std::uint64_t hash_of_c(const batuta_duel& duel) {
  std::uint64_t told = 0;
  EXPECT_EQ(batuta_duel_hash(&duel, &told), BATUTA_OK);
  return told;
}

/// The library's bout, its samples made as docs/c.md says: taken at the beginning of the step.
class OwnBout {
 public:
  OwnBout(Skill left, Skill right) {
    auto settings = duel_settings<>();
    settings.step_us = kStepUs;
    settings.touches = 1;
    settings.salle.distance = Opponent::kOnGuard;
    EXPECT_EQ(duel.configure(settings, first_fencer<float>(), second_fencer<float>()), Status::kOk);
    EXPECT_EQ(fencers[0].configure(left, 11), Status::kOk);
    EXPECT_EQ(fencers[1].configure(right, 12), Status::kOk);
  }
  void step() {
    const InputSample left = sample(Side::kLeft);
    const InputSample right = sample(Side::kRight);
    ASSERT_EQ(duel.step(&left, &right), Status::kOk);
  }

  Duel<> duel;

 private:
  InputSample sample(Side side) {
    const StickPlace& place = fencers[index_of(side)].step(observation_of(duel, side), kStepUs);
    InputSample made;
    made.time = duel.steps() * Microseconds{kStepUs};
    made.x = place.blade.x();
    made.y = place.blade.y();
    made.feet_y = place.feet;
    made.sequence = duel.steps();
    return made;
  }
  std::array<Opponent, 2> fencers;
};

TEST(OpponentForC, ABoutToATouch_HasTheBitsOfTheLibrarys) {
  const auto own = std::make_unique<OwnBout>(Skill::kClub, Skill::kMaster);
  const auto duel = std::make_unique<batuta_duel>();
  std::array<batuta_opponent, 2> fencers;
  ASSERT_EQ(batuta_duel_init(duel.get(), sizeof *duel, kStepUs, 1), BATUTA_OK);
  ASSERT_EQ(batuta_duel_set_distance(duel.get(), 4), BATUTA_OK);
  ASSERT_EQ(batuta_opponent_init(&fencers[0], sizeof fencers[0], BATUTA_CLUB, 11), BATUTA_OK);
  ASSERT_EQ(batuta_opponent_init(&fencers[1], sizeof fencers[1], BATUTA_MASTER, 12), BATUTA_OK);
  constexpr int kTwoMinutes = 120000;
  int steps = 0;
  while (!own->duel.bout().is_over() && steps < kTwoMinutes) {
    std::array<batuta_stick, 2> sticks;
    for (const std::int32_t side : {BATUTA_LEFT, BATUTA_RIGHT}) {
      const auto i = static_cast<std::size_t>(side);
      ASSERT_EQ(batuta_opponent_look(&fencers[i], duel.get(), side, &sticks[i]), BATUTA_OK);
    }
    ASSERT_EQ(batuta_duel_step(duel.get(), &sticks[0], &sticks[1]), BATUTA_OK);
    ASSERT_NO_FATAL_FAILURE(own->step());
    ++steps;
    ASSERT_EQ(hash_of_c(*duel), hash_of(own->duel)) << "step " << steps;
  }
  EXPECT_TRUE(own->duel.bout().is_over()) << "no touch in two minutes";
}

TEST(OpponentForC, AnotherSeed_IsAnotherFencer) {
  const auto duel = std::make_unique<batuta_duel>();
  ASSERT_EQ(batuta_duel_init(duel.get(), sizeof *duel, kStepUs, 1), BATUTA_OK);
  std::array<batuta_opponent, 2> fencers;
  std::array<batuta_stick, 2> sticks;
  for (std::size_t i = 0; i < 2; ++i) {
    ASSERT_EQ(batuta_opponent_init(&fencers[i], sizeof fencers[i], BATUTA_CLUB,
                                   static_cast<std::uint32_t>(i)),
              BATUTA_OK);
  }
  bool differ = false;
  for (int step = 0; step < 3000 && !differ; ++step) {
    for (std::size_t i = 0; i < 2; ++i) {
      ASSERT_EQ(batuta_opponent_look(&fencers[i], duel.get(), BATUTA_LEFT, &sticks[i]), BATUTA_OK);
    }
    differ = sticks[0].x != sticks[1].x || sticks[0].feet_y != sticks[1].feet_y;
  }
  EXPECT_TRUE(differ);
}

TEST(OpponentForC, BadInput_IsRefused) {
  const auto duel = std::make_unique<batuta_duel>();
  batuta_opponent fencer{};
  batuta_stick stick = {7, 7, 7, 7};
  EXPECT_EQ(batuta_opponent_look(&fencer, duel.get(), BATUTA_LEFT, &stick), BATUTA_INVALID_ARGUMENT)
      << "neither was made";
  ASSERT_EQ(batuta_duel_init(duel.get(), sizeof *duel, kStepUs, 1), BATUTA_OK);
  EXPECT_EQ(batuta_opponent_look(&fencer, duel.get(), BATUTA_LEFT, &stick),
            BATUTA_INVALID_ARGUMENT);
  for (const std::int32_t skill : {-1, BATUTA_MASTER + 1}) {
    EXPECT_EQ(batuta_opponent_init(&fencer, sizeof fencer, skill, 1), BATUTA_INVALID_ARGUMENT);
  }
  EXPECT_EQ(batuta_opponent_init(nullptr, sizeof fencer, BATUTA_CLUB, 1), BATUTA_INVALID_ARGUMENT);
  EXPECT_EQ(batuta_opponent_init(&fencer, batuta_opponent_size() - 1, BATUTA_CLUB, 1),
            BATUTA_INVALID_ARGUMENT);
  ASSERT_EQ(batuta_opponent_init(&fencer, batuta_opponent_size(), BATUTA_CLUB, 1), BATUTA_OK);
  for (const std::int32_t side : {-1, 2}) {
    EXPECT_EQ(batuta_opponent_look(&fencer, duel.get(), side, &stick), BATUTA_INVALID_ARGUMENT);
  }
  EXPECT_EQ(batuta_opponent_look(&fencer, nullptr, BATUTA_LEFT, &stick), BATUTA_INVALID_ARGUMENT);
  EXPECT_EQ(batuta_opponent_look(&fencer, duel.get(), BATUTA_LEFT, nullptr),
            BATUTA_INVALID_ARGUMENT);
  EXPECT_EQ(stick.x, 7);
  EXPECT_EQ(alignof(batuta_opponent) % batuta_opponent_align(), 0U);
}

}  // namespace
}  // namespace batuta
