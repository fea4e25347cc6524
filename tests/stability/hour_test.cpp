// SPDX-License-Identifier: MIT
// R01: a rod that lies on two posts, for an hour at 1 kHz. By default less of it;
// BATUTA_REST_SECONDS=3600 in the environment runs all.
#include <gtest/gtest.h>

#include <cstdlib>

#include "resting.hpp"

namespace batuta {
namespace {

using test::Pile;

#ifndef BATUTA_REST_SECONDS
#define BATUTA_REST_SECONDS 300
#endif

int steps_to_run() {
  const char* seconds = std::getenv("BATUTA_REST_SECONDS");
  const double wanted = seconds != nullptr ? std::atof(seconds) : BATUTA_REST_SECONDS;
  return static_cast<int>(wanted / test::kTick);
}

/// D: what a body falls in two steps. A larger one is a step that the rod rocks on.
constexpr double kFineD = 2e-5;
constexpr double kMostDrift = 1e-4 * test::kRodLength;

struct Seen {
  double drift = 0;      ///< the furthest that an end moved sideways, m
  double least_gap = 1;  ///< m
  double height = 0;     ///< the highest that an end rose from where it was dropped, m
  int separations = 0;   ///< the most of a pair in a step
  int incomplete = 0;    ///< steps
  int overlaps = 0;      ///< that the world found
  int frozen = 0;
  int awake = 0;  ///< steps
};

template <class SceneT>
Seen lie(Pile pile, double D, int steps) {
  using S = typename SceneT::Scalar;
  World<SceneT> world;
  WorldSettings<SceneT> settings;
  settings.separation = static_cast<S>(D);
  EXPECT_EQ(world.configure(settings), Status::kOk);
  test::pile_up(world, pile, D);
  const World<SceneT>& shown = world;
  const Capsule<double> start = test::seen(test::body_in(shown, 0));
  Seen seen;
  for (int i = 0; i < steps; ++i) {
    EXPECT_EQ(world.step(static_cast<S>(test::kTick)), Status::kOk);
    const Capsule<double> now = test::seen(test::body_in(shown, 0));
    for (const Vec3<double>& moved :
         {Vec3<double>(now.axis.a - start.axis.a), Vec3<double>(now.axis.b - start.axis.b)}) {
      seen.drift = std::max(seen.drift, moved.head<2>().norm());
      seen.height = std::max(seen.height, moved.z());
    }
    seen.least_gap = std::min(seen.least_gap, test::least_gap(shown));
    seen.separations = std::max(seen.separations, test::most_separations(shown));
    seen.incomplete += world.report().complete() ? 0 : 1;
    seen.overlaps += static_cast<int>(world.report().overlaps_at_start);
    seen.frozen += static_cast<int>(world.report().frozen);
    seen.awake += world.report().asleep == 0 ? 1 : 0;
  }
  return seen;
}

void expect_sound(const Seen& seen) {
  EXPECT_GT(seen.least_gap, 0);
  EXPECT_LE(seen.separations, 4);
  EXPECT_EQ(seen.incomplete, 0);
  EXPECT_EQ(seen.overlaps, 0);
  std::printf(
      "  drift %.2g m, least gap %.2g m, rise %.2g m, %d separations, "
      "%d frozen, awake %d steps\n",
      seen.drift, seen.least_gap, seen.height, seen.separations, seen.frozen, seen.awake);
}

template <class S>
class AnHourAtRest : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(AnHourAtRest, Scalars);

TYPED_TEST(AnHourAtRest, RodAcrossPosts_RubsAndStays) {
  // In float a finer D is less than rounding can tell, and the rod creeps by 0.26 mm in the hour.
  const double D = std::is_same_v<TypeParam, float> ? 1e-4 : kFineD;
  const Seen seen = lie<test::RubbingScene<TypeParam>>(Pile::kAcross, D, steps_to_run());
  expect_sound(seen);
  EXPECT_LT(seen.drift, kMostDrift);
}

TYPED_TEST(AnHourAtRest, RodInAGroove_RubsAndStays) {
  const Seen seen = lie<test::RubbingScene<TypeParam>>(Pile::kGroove, kFineD, steps_to_run());
  expect_sound(seen);
  EXPECT_LT(seen.drift, kMostDrift);
}

// Nothing holds it along the groove but that nothing pushes it either.
TYPED_TEST(AnHourAtRest, SmoothRodInAGroove_Stays) {
  const Seen seen = lie<test::RestScene<TypeParam>>(Pile::kGroove, kFineD, steps_to_run());
  expect_sound(seen);
  EXPECT_LT(seen.drift, kMostDrift);
}

// With the default D, and with and without friction: asleep before it can creep.
TYPED_TEST(AnHourAtRest, RodThatMaySleep_Stays) {
  const double D = 1e-4;
  for (const Pile pile : {Pile::kAcross, Pile::kGroove}) {
    for (const Seen& seen : {lie<test::SleepyScene<TypeParam>>(pile, D, steps_to_run()),
                             lie<test::SmoothSleepyScene<TypeParam>>(pile, D, steps_to_run())}) {
      expect_sound(seen);
      EXPECT_LT(seen.drift, kMostDrift);
      EXPECT_LT(seen.awake * test::kTick, 2 * static_cast<double>(SceneOptions{}.sleep_time));
    }
  }
}

// Smooth, and across: a rod may tilt by the gaps at its posts, and slides down that. No faster.
TYPED_TEST(AnHourAtRest, SmoothRodAcrossPosts_SlidesNoFasterThanItsGapsTilt) {
  constexpr double kTime = 20;
  constexpr double kSpan = 0.7;  // between the posts
  const auto steps = static_cast<int>(kTime / test::kTick);
  for (const double D : {2e-5, 1e-4}) {
    const Seen seen = lie<test::RestScene<TypeParam>>(Pile::kAcross, D, steps);
    expect_sound(seen);
    constexpr double kMargin = 4e-5;  // to which a lesser D is raised in float, at most
    const double tilt = std::max(D, kMargin) / kSpan;
    EXPECT_LT(seen.drift, 9.81 * tilt * kTime * kTime / 2);
  }
}

}  // namespace
}  // namespace batuta
