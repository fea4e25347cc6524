// SPDX-License-Identifier: MIT
// Random scenes of bodies that do not turn, of both engines: see random_checks.hpp.
#include "random_checks.hpp"

namespace batuta::test {
namespace {

template <class S, const RandomKind& kKind>
using Of = RandomLaws<S, kKind>;
using Straight =
    ::testing::Types<Of<float, kStraight>, Of<double, kStraight>, Of<float, kSmallBalls>,
                     Of<double, kSmallBalls>, Of<float, kSmallCramped>, Of<double, kSmallCramped>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Straight, RandomScenes, Straight);

// What lay on something, and was struck upwards in the same step, rose as if it weighed nothing;
// and what lay on a light ball went with it when that was struck down.
TEST(RandomFound, WhatIsStruckWhileItLies_WinsNoEnergy) {
  expect_no_gain<Of<float, kStraight>>({264, 352});
  expect_no_gain<Of<double, kStraight>>({264, 352});
  expect_no_gain<Of<float, kSmallBalls>>({69, 70, 550, 590});
  expect_no_gain<Of<double, kSmallBalls>>({69, 70, 550});
}

}  // namespace
}  // namespace batuta::test
