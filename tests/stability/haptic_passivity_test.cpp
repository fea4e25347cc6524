// SPDX-License-Identifier: MIT
// Observer and controller against the plant's own book: the energy of stick and hand, which is
// exact and knows nothing of the observer. With the controller on, the hand gets no more than the
// debt that it may run up, however stiff the spring, or the controller says that it cannot.
#include <gtest/gtest.h>

#include "passive_loop.hpp"
#include "worst_hand.hpp"

namespace batuta {
using namespace haptics;
namespace {

using test::Way;

constexpr double kPeriod = 1e-3;
constexpr double kDamping = 0.2;  // of the device
constexpr double kDebt = test::PassiveLoop<double>::kDebt;
constexpr int kSteps = 20'000;
constexpr double kMuch = 1000;  // times the energy at first: seen enough

/// Who holds the stick.
struct Hand {
  double mass;
  double stiffness;
};
constexpr Hand kHands[] = {{0, 0}, {0.5, 0}, {0, 500}, {0.5, 500}, {0.5, 5e4}};

/// A spring `share` times as stiff as the advisor allows, on a stick that comes with a speed.
test::LoopSettings loop_with(double share, const Hand& hand, int delay) {
  test::LoopSettings loop;
  loop.axis.period = kPeriod;
  loop.axis.mass = 0.05;
  loop.axis.damping = kDamping;
  loop.axis.hand_mass = hand.mass;
  loop.axis.hand_stiffness = hand.stiffness;
  loop.gains.stiffness =
      share * test::stiffness_bound(test::plain_device(kPeriod, kDamping, delay), 0);
  return loop;
}

/// All energies over the first one.
struct Book {
  double most = 0;                ///< of stick and hand
  double most_before_cannot = 0;  ///< up to the last sample before the first kCannot
  int damped = 0;                 ///< periods in which something was owed
  bool cannot = false;
};

template <class S>
Book run(const test::LoopSettings& settings, const Way& way) {
  test::PassiveLoop<S> loop(settings, way);
  Book book;
  for (int i = 0; i < kSteps && book.most < kMuch; ++i) {
    loop.look();
    const Passivity state = loop.observer().state();
    book.damped += state == Passivity::kPassive ? 0 : 1;
    book.cannot = book.cannot || state == Passivity::kCannot;
    if (!book.cannot) book.most_before_cannot = book.most;
    loop.pass();
    book.most = std::max(book.most, loop.energy());
  }
  return book;
}

template <class S>
class HapticPassivity : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(HapticPassivity, Scalars);

/// What float's rounding of 20 000 products may add up to.
constexpr double kSlack = 1e-3;

TYPED_TEST(HapticPassivity, WithinTheBound_TheControllerIsSilent) {
  for (const Hand& hand : kHands) {
    const Book book = run<TypeParam>(loop_with(0.98, hand, 0), {});
    EXPECT_EQ(book.damped, 0) << hand.mass << ' ' << hand.stiffness;
    EXPECT_LE(book.most, 1);
  }
}

TYPED_TEST(HapticPassivity, UpToTwiceTheBound_NothingIsInjected) {
  for (const Hand& hand : kHands) {
    for (const double share : {1.2, 1.5}) {
      const auto loop = loop_with(share, hand, 0);
      const Book on = run<TypeParam>(loop, {});
      EXPECT_FALSE(on.cannot) << share << ' ' << hand.mass << ' ' << hand.stiffness;
      EXPECT_LE(on.most, 1 + kDebt);
      EXPECT_GT(run<TypeParam>(loop, {false}).most, 3);  // without it, the hand is shaken
    }
  }
}

TYPED_TEST(HapticPassivity, BeyondTwiceTheBound_ItSaysSoBeforeTheHandFeelsIt) {
  for (const Hand& hand : kHands) {
    for (const double share : {2.5, 4.0, 20.0}) {
      const Book book = run<TypeParam>(loop_with(share, hand, 0), {});
      EXPECT_TRUE(book.cannot) << share << ' ' << hand.mass << ' ' << hand.stiffness;
      EXPECT_LE(book.most_before_cannot, 1 + kDebt + kSlack);
    }
  }
}

// Whether it is told what is stored, or its forces come late: the promise is the same, though it
// acts later and gives up sooner.
TYPED_TEST(HapticPassivity, UntoldOrLate_NothingIsInjectedOrItSaysSo) {
  int kept = 0;
  int gave_up = 0;
  for (const Hand& hand : kHands) {
    for (const double share : {1.1, 1.5, 3.0}) {
      for (const Way& way : {Way{true, false, 0}, Way{true, true, 1}, Way{true, true, 3}}) {
        const Book book = run<TypeParam>(loop_with(share, hand, way.delay), way);
        EXPECT_LE(book.most_before_cannot, 1 + kDebt + kSlack)
            << share << ' ' << hand.mass << ' ' << hand.stiffness << ' ' << way.delay;
        ++(book.cannot ? gave_up : kept);
      }
    }
  }
  EXPECT_GT(kept, 5);
  EXPECT_GT(gave_up, 5);
}

}  // namespace
}  // namespace batuta
