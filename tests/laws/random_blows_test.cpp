// SPDX-License-Identifier: MIT
// Random scenes in which contacts are separated, or answered blow by blow: see random_checks.hpp.
#include "random_checks.hpp"

namespace batuta::test {
namespace {

template <class S, const RandomKind& kKind>
using Of = RandomScene<S, kKind>;
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

}  // namespace
}  // namespace batuta::test
