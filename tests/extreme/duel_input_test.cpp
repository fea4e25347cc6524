// SPDX-License-Identifier: MIT
// A duel whose devices go wrong: stamps that repeat, go back, are irregular, lost, late by seconds
// or wrap; sticks that are stuck, noisy, or jump the whole range in one sample. The duel goes on,
// every blade is somewhere, blades stay apart, no stick is faster than it may be, and the report
// counts what came.
#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <vector>

#include "batuta/record/duel.hpp"
#include "draws.hpp"

namespace batuta {
using namespace fencing;
namespace {

/// What comes at step k, one step a millisecond; nothing where there is no sample.
using Stream = std::optional<InputSample> (*)(std::uint32_t k);

constexpr std::uint32_t kPeriod = 8;  ///< steps between the samples of a healthy device

InputSample at(std::uint32_t k, float x, float y) {
  InputSample sample;
  sample.time = k * 1000U;
  sample.sequence = k / kPeriod;
  sample.x = x;
  sample.y = y;
  return sample;
}
InputSample sway(std::uint32_t k) {
  const double t = 1e-3 * k;
  return at(k, static_cast<float>(0.7 * std::sin(5 * t)),
            static_cast<float>(-0.3 + 0.3 * std::sin(3 * t)));
}
test::Draws draws(std::uint32_t k, std::uint64_t stream) {
  return test::Draws(6, stream, k);
}

std::optional<InputSample> healthy(std::uint32_t k) {
  return k % kPeriod == 0 ? std::optional(sway(k)) : std::nullopt;
}
std::optional<InputSample> repeated(std::uint32_t k) {
  return sway(k - k % kPeriod);  // again and again
}
std::optional<InputSample> irregular(std::uint32_t k) {
  InputSample sample = sway(k);
  sample.time += static_cast<Microseconds>(draws(k, 1).unit() * 900);
  return draws(k, 2).chance(0.1) ? std::optional(sample) : std::nullopt;
}
std::optional<InputSample> silent_for_seconds(std::uint32_t k) {
  return k % 4000 < 1000 ? healthy(k) : std::nullopt;
}
std::optional<InputSample> late_by_seconds(std::uint32_t k) {
  return k < 3000 ? std::nullopt : healthy(k - 3000);
}
std::optional<InputSample> stuck(std::uint32_t k) {
  return k % kPeriod == 0 ? std::optional(at(k, 0.25F, -0.25F)) : std::nullopt;
}
std::optional<InputSample> noisy(std::uint32_t k) {
  test::Draws draw = draws(k, 3);
  InputSample sample = sway(k);
  sample.x += static_cast<float>(0.2 * draw.signed_unit());
  sample.y += static_cast<float>(0.2 * draw.signed_unit());
  return sample;
}
std::optional<InputSample> jumping(std::uint32_t k) {
  if (k % 50 != 0) return std::nullopt;
  const bool there = k / 50 % 2 == 0;
  return at(k, there ? 1.0F : -1.0F, there ? -1.0F : 0.0F);
}
std::optional<InputSample> jumping_each_step(std::uint32_t k) {
  return at(k, k % 2 == 0 ? 1.0F : -1.0F, k % 4 < 2 ? -1.0F : 0.0F);
}
/// Any bits at all.
std::optional<InputSample> garbage(std::uint32_t k) {
  test::Draws draw = draws(k, 4);
  InputSample sample;
  const std::uint64_t bits = draw.bits();
  std::memcpy(&sample.x, &bits, sizeof(sample.x));
  const std::uint64_t more = draw.bits();
  std::memcpy(&sample.y, &more, sizeof(sample.y));
  const std::uint64_t feet = draw.bits();
  std::memcpy(&sample.feet_y, &feet, sizeof(sample.feet_y));
  if (draw.chance(0.5)) sample.y = -1.0F;  // mostly out of reach, so that the bout goes on
  sample.time = static_cast<Microseconds>(draw.bits());
  sample.buttons = static_cast<std::uint32_t>(draw.bits());
  sample.sequence = static_cast<std::uint32_t>(draw.bits());
  return draw.chance(0.7) ? std::optional(sample) : std::nullopt;
}

template <class S>
class DuelInputs : public testing::Test {
 protected:
  using DuelType = Duel<DuelScene<two_fencers, Advancement<S>>>;

  std::unique_ptr<DuelType> fresh() {
    auto duel = std::make_unique<DuelType>();
    EXPECT_EQ(duel->configure(duel_settings<DuelScene<two_fencers, Advancement<S>>>(),
                              first_fencer<S>(), second_fencer<S>()),
              Status::kOk);
    return duel;
  }
  void step(DuelType& duel, const std::optional<InputSample>& left,
            const std::optional<InputSample>& right) {
    if (duel.bout().is_over()) {
      ASSERT_EQ(duel.configure(duel_settings<DuelScene<two_fencers, Advancement<S>>>(),
                               first_fencer<S>(), second_fencer<S>()),
                Status::kOk);
    }
    ASSERT_EQ(duel.step(left ? &*left : nullptr, right ? &*right : nullptr), Status::kOk);
    judge(duel);
  }
  void judge(const DuelType& duel) {
    const S fastest = static_cast<S>(StickSettings{}.max_speed) * (1 + 64 * kRoundOff<S>);
    for (const Side side : {Side::kLeft, Side::kRight}) {
      const auto& stick = duel.stick(side);
      ASSERT_LE(stick.position().cwiseAbs().maxCoeff(), S(1));
      // A difference of places over a step of 1 ms: their rounding shows a thousandfold.
      ASSERT_LE(stick.velocity().cwiseAbs().maxCoeff(), fastest + 4000 * kRoundOff<S>);
      ASSERT_LE(std::abs(duel.X_WF(side).p_W.x()), S(7 - 0.4 + 1e-5)) << "on the strip";
      ASSERT_TRUE(is_valid(duel.blade_W(side)));
      ASSERT_TRUE(is_finite(duel.hand(side).X_WH.p_W) && is_finite(duel.hand(side).jacobian));
    }
    ASSERT_GT(capsule_gap(duel.blade_W(Side::kLeft), duel.blade_W(Side::kRight)).gap, S(0));
    ASSERT_EQ(duel.report().searches_invalid, 0U);
  }
  void run(Stream left, Stream right, std::uint32_t steps) {
    const auto duel = fresh();
    for (std::uint32_t k = 0; k < steps; ++k) {
      SCOPED_TRACE(k);
      step(*duel, left(k), right(k));
      if (this->HasFatalFailure()) return;
    }
  }
};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(DuelInputs, Scalars);

TYPED_TEST(DuelInputs, AnyTwoOfThem_TheDuelGoesOn) {
  const std::vector<Stream> streams = {healthy, repeated, irregular,         silent_for_seconds,
                                       stuck,   noisy,    late_by_seconds,   jumping,
                                       garbage, healthy,  jumping_each_step, irregular};
  for (std::size_t i = 0; i + 1 < streams.size(); ++i) {
    SCOPED_TRACE(testing::Message() << "streams " << i << " and the next");
    this->run(streams[i], streams[i + 1], 5000);
    this->run(streams[streams.size() - 1 - i], streams[i], 1000);
  }
}

/// Both duels side by side, every step with the same bits.
template <class DuelT>
void expect_same_blades(const DuelT& a, const DuelT& b) {
  for (const Side side : {Side::kLeft, Side::kRight}) {
    ASSERT_EQ(a.blade_W(side).axis.a, b.blade_W(side).axis.a);
    ASSERT_EQ(a.blade_W(side).axis.b, b.blade_W(side).axis.b);
    ASSERT_EQ(a.stick(side).position(), b.stick(side).position());
  }
}

// Only differences of stamps have a meaning: a duel across the wrap is the duel at zero.
TYPED_TEST(DuelInputs, StampsAcrossTheWrap_ChangeNoBit) {
  const auto plain = this->fresh();
  const auto wrapping = this->fresh();
  for (std::uint32_t k = 0; k < 4000; ++k) {
    auto sample = healthy(k);
    this->step(*plain, sample, sample);
    if (sample) {
      sample->time += 0U - 2000000U;  // 2 s before the wrap
      sample->sequence += 0U - 100U;
    }
    this->step(*wrapping, sample, sample);
    expect_same_blades(*plain, *wrapping);
    if (this->HasFatalFailure()) return;
  }
  EXPECT_EQ(wrapping->stick(Side::kLeft).report().backward, 0U);
  EXPECT_EQ(wrapping->stick(Side::kLeft).report().lost, 0U);
}

// What is refused leaves no trace but its count, whatever else it says.
TYPED_TEST(DuelInputs, RefusedSamplesBetweenGoodOnes_ChangeNoBit) {
  const auto plain = this->fresh();
  const auto troubled = this->fresh();
  std::uint32_t backward = 0;
  std::uint32_t invalid = 0;
  for (std::uint32_t k = 0; k < 4000; ++k) {
    const auto good = healthy(k);
    this->step(*plain, good, good);
    auto bad = good;
    if (!good && k > kPeriod) {
      bad = sway(k);
      if (k % 3 == 0) {
        bad->x = std::numeric_limits<float>::quiet_NaN();
        ++invalid;
      } else {  // older than the last one used, by up to nearly half of all stamps
        bad->time = (k - k % kPeriod) * 1000U - 1U - (k % 7 == 0 ? 2000000000U : k % 1000U);
        bad->sequence = 0;
        ++backward;
      }
    }
    this->step(*troubled, bad, good);
    expect_same_blades(*plain, *troubled);
    if (this->HasFatalFailure()) return;
  }
  const StickReport& report = troubled->stick(Side::kLeft).report();
  EXPECT_EQ(report.invalid, invalid);
  EXPECT_EQ(report.backward, backward);
  EXPECT_EQ(report.used, plain->stick(Side::kLeft).report().used);
}

TYPED_TEST(DuelInputs, LostSamples_AreCountedOneByOne) {
  const auto duel = this->fresh();
  std::uint32_t lost = 0;
  std::uint32_t since = 0;  // the last one that came
  for (std::uint32_t k = 0; k < 4000; ++k) {
    auto sample = healthy(k);
    const bool is_lost = sample && k > 0 && draws(k, 5).chance(0.5);
    if (is_lost) sample.reset();
    if (sample) {
      lost += since;
      since = 0;
    }
    since += is_lost ? 1 : 0;
    this->step(*duel, sample, healthy(k));
    if (this->HasFatalFailure()) return;
  }
  EXPECT_GT(lost, 100U);
  EXPECT_EQ(duel->stick(Side::kLeft).report().lost, lost);
  EXPECT_EQ(duel->stick(Side::kRight).report().lost, 0U);
}

TYPED_TEST(DuelInputs, SilenceOfSeconds_StandsStillAndComesBackNoFasterThanItMay) {
  using S = TypeParam;
  const auto duel = this->fresh();
  const InputSample corner = at(0, -1.0F, -1.0F);
  this->step(*duel, corner, corner);
  for (int k = 0; k < 5000; ++k) this->step(*duel, std::nullopt, std::nullopt);
  EXPECT_TRUE(duel->stick(Side::kLeft).is_stale());
  EXPECT_EQ(duel->stick(Side::kLeft).velocity(), Vec2<S>::Zero());
  EXPECT_GT(duel->stick(Side::kLeft).report().stale_steps, 4000U);
  // Where a blow has left it: a hand that is beaten follows nothing to the side.
  const S start = duel->stick(Side::kLeft).position().x();
  ASSERT_LT(start, S(0));
  const InputSample other = at(5000, 1.0F, -1.0F);
  this->step(*duel, other, corner);
  int steps = 1;
  while (duel->stick(Side::kLeft).position().x() < S(1) && steps < 1000) {
    this->step(*duel, std::nullopt, std::nullopt);
    ++steps;
  }
  const double way = 1 - static_cast<double>(start);
  EXPECT_GE(steps, static_cast<int>(1000 * way / StickSettings{}.max_speed));
  EXPECT_LT(steps, 1000);
  EXPECT_EQ(duel->stick(Side::kLeft).report().restarts, 2U);
}

TYPED_TEST(DuelInputs, StuckStick_HoldsTheBladeForAMinute) {
  const auto duel = this->fresh();
  const std::uint32_t steps = 60000;
  Capsule<TypeParam> blade;
  for (std::uint32_t k = 0; k < steps; ++k) {
    this->step(*duel, stuck(k), stuck(k));
    if (k == 1000) blade = duel->blade_W(Side::kLeft);
    if (this->HasFatalFailure()) return;
  }
  // What a pose is rounded by, a hundredfold: recover_time over the step (src/fencing/grip.md).
  const TypeParam wander = 100 * kRoundOff<TypeParam> * blade.axis.b.norm();
  EXPECT_LE((duel->blade_W(Side::kLeft).axis.b - blade.axis.b).norm(), wander);
  EXPECT_EQ(duel->report().blows, 0U);
  EXPECT_EQ(duel->report().incomplete_steps, 0U);
  EXPECT_EQ(duel->stick(Side::kLeft).report().stale_steps, 0U);
}

}  // namespace
}  // namespace batuta
