// SPDX-License-Identifier: MIT
#pragma once
// Random scenes as a suite of tests: one for each law that can be broken, over the same scenes.
#include <gtest/gtest.h>

#include "random_kinds.hpp"

namespace batuta::test {

inline constexpr int kRandomSeeds = 16;
inline constexpr int kRandomSteps = 20;

template <class LawsT>
class RandomScenes : public ::testing::Test {
 protected:
  /// Holds that none of the laws was broken.
  static void expect_kept(std::initializer_list<const char*> laws) {
    for (int seed = 0; seed < kRandomSeeds; ++seed) {
      const Choices choices(static_cast<std::uint64_t>(seed));
      for (const Found& found : LawsT::run(choices, kRandomSteps).found) {
        const Breach& breach = found.breach;
        const bool counts = std::find(laws.begin(), laws.end(), breach.law) != laws.end();
        if (!counts) continue;
        ADD_FAILURE() << breach.law << ", " << breach.what << ": " << static_cast<double>(breach.by)
                      << ", at most " << static_cast<double>(breach.may_be) << "; seed " << seed
                      << ", step " << found.step;
        break;  // the first of a scene
      }
    }
  }
};

/// Holds that no energy is won by the scenes of these seeds, which once did.
template <class LawsT>
void expect_no_gain(std::initializer_list<int> seeds) {
  for (const int seed : seeds) {
    const Choices choices(static_cast<std::uint64_t>(seed));
    for (const Found& found : LawsT::run(choices, kRandomSteps).found) {
      EXPECT_NE(found.breach.law.rfind("energy", 0), 0U)
          << "seed " << seed << ", step " << found.step << ": "
          << static_cast<double>(found.breach.by);
    }
  }
}

TYPED_TEST_SUITE_P(RandomScenes);

TYPED_TEST_P(RandomScenes, Momentum_IsKeptAndNumbersStayFinite) {
  this->expect_kept({"finite", "momentum", "centre", "spin"});
}
TYPED_TEST_P(RandomScenes, Energy_DoesNotGrow) {
  this->expect_kept({"energy", "energy (gaps opened)"});
}
TYPED_TEST_P(RandomScenes, Ways_AreThoseOfTheEnergyThereIs) {
  this->expect_kept({"way"});
}
TYPED_TEST_P(RandomScenes, Flight_IsFreeAndRestIsStill) {
  this->expect_kept({"flight", "rest"});
}
TYPED_TEST_P(RandomScenes, Bodies_StayOutOfEachOther) {
  this->expect_kept({"overlap", "untold overlap"});
}
TYPED_TEST_P(RandomScenes, Friction_StaysInItsCone) {
  this->expect_kept({"friction"});
}
TYPED_TEST_P(RandomScenes, Frame_ChangesNothing) {
  for (int seed = 0; seed < kRandomSeeds; ++seed) {
    const Choices choices(static_cast<std::uint64_t>(seed));
    EXPECT_LE(static_cast<double>(TypeParam::frame_breach(choices, kRandomSteps).by), 0)
        << "seed " << seed;
  }
}
REGISTER_TYPED_TEST_SUITE_P(RandomScenes, Momentum_IsKeptAndNumbersStayFinite, Energy_DoesNotGrow,
                            Ways_AreThoseOfTheEnergyThereIs, Flight_IsFreeAndRestIsStill,
                            Bodies_StayOutOfEachOther, Friction_StaysInItsCone,
                            Frame_ChangesNothing);

}  // namespace batuta::test
