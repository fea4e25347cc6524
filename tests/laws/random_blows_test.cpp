// SPDX-License-Identifier: MIT
// Random scenes in which contacts are separated, or answered blow by blow: see random_checks.hpp.
#include "random_checks.hpp"
#include "random_scenes.hpp"

namespace batuta::test {
namespace {

template <class S, const RandomKind& kKind>
using Of = RandomLaws<S, kKind>;
using Separated =
    ::testing::Types<Of<float, kPaper>, Of<double, kPaper>, Of<float, kPaperLed>,
                     Of<double, kPaperLed>, Of<float, kPaperCramped>, Of<double, kPaperCramped>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Separated, RandomScenes, Separated);

using Struck =
    ::testing::Types<Of<float, kBlows>, Of<double, kBlows>, Of<float, kBlowsCramped>,
                     Of<double, kBlowsCramped>, Of<float, kBlowsLed>, Of<double, kBlowsLed>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Struck, RandomScenes, Struck);

// As RandomFound of bodies that do not turn (random_straight_test.cpp).
TEST(RandomFound, WhatIsStruckWhileItLiesAndTurns_WinsNoEnergy) {
  expect_no_gain<Of<float, kBlowsCramped>>({399, 551});
  expect_no_gain<Of<double, kBlowsCramped>>({399, 564});
  expect_no_gain<Of<double, kBlowsLed>>({82, 433, 594});
}

// What one step lifts by m (g T)^2 at most (law 3) the next ones take again: there is no trend.
TEST(RandomFound, WhatHopsOnTwoSupports_WinsNoMoreThanOnce) {
  RandomRun<RandomScene<float, kBlowsCramped>> run{Choices(399)};
  const Real3 g = run.gravity().cast<Real>();
  Real once = 0;
  const auto energy = [&] {
    Real sum = 0;
    once = 0;
    for (const SeenBody& body : run.seen()) {
      if (!(body.mass > 0)) continue;
      sum += body.kinetic() - body.mass * g.dot(body.x);
      once += body.mass * g.squaredNorm() * run.dt() * run.dt();
    }
    return sum;
  };
  Real before = energy();
  const Real most = before + once;
  int lifted = 0;
  for (int i = 0; i < 400; ++i) {
    ASSERT_EQ(run.step(), Status::kOk);
    const Real after = energy();
    ASSERT_LE(after, most) << i;
    lifted += after > before + once / 16;
    before = after;
  }
  EXPECT_GT(lifted, 50) << "or this scene shows nothing";
}

}  // namespace
}  // namespace batuta::test
