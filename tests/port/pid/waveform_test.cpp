// SPDX-License-Identifier: MIT
// Shapes and envelopes against values worked out by hand.

#include "shared/hid_pid/waveform.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "host.hpp"

namespace batuta::pid {
namespace {

TEST(PidWaveform, Shapes_AreThoseOfTheDrawings) {
  const struct {
    EffectType type;
    float at_0, at_1, at_2, at_3;  // quarters
  } shapes[] = {
      {EffectType::kSquare, 1, 1, -1, -1},
      {EffectType::kSine, 0, 1, 0, -1},
      {EffectType::kTriangle, -1, 0, 1, 0},
      {EffectType::kSawtoothUp, -1, -0.5F, 0, 0.5F},
      {EffectType::kSawtoothDown, 1, 0.5F, 0, -0.5F},
      {EffectType::kConstant, 0, 0, 0, 0},
  };
  for (const auto& s : shapes) {
    EXPECT_NEAR(waveform(s.type, 0.0F), s.at_0, 1e-6F);
    EXPECT_NEAR(waveform(s.type, 0.25F), s.at_1, 1e-6F);
    EXPECT_NEAR(waveform(s.type, 0.5F), s.at_2, 1e-6F);
    EXPECT_NEAR(waveform(s.type, 0.75F), s.at_3, 1e-6F);
  }
}

TEST(PidWaveform, Shapes_StayWithinOneAndHaveNoMean) {
  constexpr int kParts = 4096;
  for (int type = 3; type <= 7; ++type) {
    double sum = 0;
    for (int i = 0; i < kParts; ++i) {
      const float turn = (static_cast<float>(i) + 0.5F) / kParts;
      const float value = waveform(static_cast<EffectType>(type), turn);
      ASSERT_LE(std::abs(value), 1.0F + 0x1p-23F);
      sum += static_cast<double>(value);
    }
    EXPECT_NEAR(sum / kParts, 0.0, 1e-6) << type;
  }
}

TEST(PidWaveform, Sine_IsTheSine) {
  for (int i = 0; i <= 1000; ++i) {
    const float turn = static_cast<float>(i) / 1000;
    const double angle = 2 * 3.14159265358979323846 * static_cast<double>(turn);
    ASSERT_NEAR(waveform(EffectType::kSine, turn), std::sin(angle), 1e-6);
  }
}

TEST(PidEnvelope, AttackAndFade_AreStraightLines) {
  const Envelope e = {2000, 5000, 100, 200};
  const auto at = [&](std::uint32_t ms) { return e.level(0.8F, ms * 1000, 1000); };
  EXPECT_FLOAT_EQ(at(0), 0.2F);
  EXPECT_FLOAT_EQ(at(50), 0.5F);
  EXPECT_FLOAT_EQ(at(100), 0.8F);
  EXPECT_FLOAT_EQ(at(500), 0.8F);
  EXPECT_FLOAT_EQ(at(800), 0.8F);
  EXPECT_FLOAT_EQ(at(900), 0.65F);
  EXPECT_FLOAT_EQ(at(1000), 0.5F);
}

TEST(PidEnvelope, WithoutEnd_DoesNotFade) {
  const Envelope e = {2000, 0, 100, 200};
  EXPECT_FLOAT_EQ(e.level(0.8F, 0, 0), 0.2F);
  EXPECT_FLOAT_EQ(e.level(0.8F, 0x80000000U, 0), 0.8F);
}

TEST(PidEnvelope, None_ChangesNothing) {
  EXPECT_EQ(Envelope{}.level(0.8F, 0, 1000), 0.8F);
  EXPECT_EQ(Envelope{}.level(0.8F, 1000000, 1000), 0.8F);
}

// A step of a microsecond changes the level by no more than the two slopes together.
TEST(PidEnvelope, Overlapping_HasNoJump) {
  const Envelope e = {0, 10000, 80, 60};
  float last = e.level(0.5F, 0, 100);
  for (std::uint32_t us = 100; us <= 100000; us += 100) {
    const float level = e.level(0.5F, us, 100);
    ASSERT_LE(std::abs(level - last), 0.5F / 800 + 1.0F / 600) << us;
    last = level;
  }
}

}  // namespace

namespace test {
namespace {

/// A periodic effect of 100 ms from the south, so that a positive force points up.
class Periodic : public Session {
 public:
  std::int64_t block;
  explicit Periodic(EffectType type, const Values& wave = {}, const Values& effect = {})
      : block(made(type)) {
    Values all = {{pid_usage(0x22), block}, {pid_usage(0x70), 5000}, {pid_usage(0x72), 100}};
    for (const auto& [usage, value] : wave) all[usage] = value;
    EXPECT_EQ(send(pid_usage(0x6E), all), Status::kOk);
    Values shape = {{0x0A0001, degrees(180)}};
    for (const auto& [usage, value] : effect) shape[usage] = value;
    EXPECT_EQ(set_effect(block, shape), Status::kOk);
    EXPECT_EQ(start(block), Status::kOk);
  }
  float at(std::uint32_t step_ms) { return force({}, step_ms * 1000).y(); }
};

TEST(PidPeriodic, Sine_RunsThroughItsPeriods) {
  Periodic effect(EffectType::kSine);
  for (int i = 0; i < 1000; ++i) {
    const double angle = 2 * 3.14159265358979323846 * i / 20;
    ASSERT_NEAR(effect.at(i == 0 ? 0 : 5), 0.5 * std::sin(angle), 1e-5) << i;
  }
}

TEST(PidPeriodic, PhaseAndOffset_ShiftTheWave) {
  Periodic sine(EffectType::kSine, {{pid_usage(0x71), degrees(90)}, {pid_usage(0x6F), 2500}});
  EXPECT_NEAR(sine.at(0), 0.75F, 1e-6F);
  EXPECT_NEAR(sine.at(25), 0.25F, 1e-6F);
  EXPECT_NEAR(sine.at(25), -0.25F, 1e-6F);
  Periodic square(EffectType::kSquare, {{pid_usage(0x71), degrees(180)}});
  EXPECT_EQ(square.at(0), -0.5F);
  EXPECT_EQ(square.at(50), 0.5F);
  Periodic whole(EffectType::kSawtoothUp, {{pid_usage(0x71), degrees(360)}});
  EXPECT_EQ(whole.at(0), -0.5F) << "a full turn is none";
}

TEST(PidPeriodic, StartedAgain_BeginsAtItsPhase) {
  Periodic effect(EffectType::kSine);
  effect.at(0);
  EXPECT_NEAR(effect.at(25), 0.5F, 1e-6F);
  EXPECT_EQ(effect.start(effect.block), Status::kOk);
  EXPECT_EQ(effect.at(13), 0.0F);
  EXPECT_NEAR(effect.at(25), 0.5F, 1e-6F);
}

TEST(PidPeriodic, PeriodOfOneMillisecond_IsOne) {
  Periodic effect(EffectType::kSquare, {{pid_usage(0x72), 1}});
  EXPECT_EQ(effect.at(0), 0.5F);
  EXPECT_EQ(effect.force({}, 500).y(), -0.5F);
  EXPECT_EQ(effect.force({}, 500).y(), 0.5F);
}

TEST(PidPeriodic, PeriodOfZero_StandsStill) {
  Periodic effect(EffectType::kTriangle, {{pid_usage(0x72), 0}, {pid_usage(0x71), degrees(180)}});
  EXPECT_EQ(effect.at(0), 0.5F);
  EXPECT_EQ(effect.at(17), 0.5F);
}

// The envelope is the wave's; the offset stays.
TEST(PidPeriodic, Envelope_ShapesTheWaveAndNotItsOffset) {
  Periodic effect(EffectType::kSquare, {{pid_usage(0x6F), 1000}, {pid_usage(0x72), 0}},
                  {{pid_usage(0x50), 1000}});
  EXPECT_EQ(effect.send(pid_usage(0x5A), {{pid_usage(0x22), effect.block},
                                          {pid_usage(0x5C), 100},
                                          {pid_usage(0x5E), 200},
                                          {pid_usage(0x5D), 1000}}),
            Status::kOk);
  EXPECT_FLOAT_EQ(effect.at(0), 0.1F);
  EXPECT_FLOAT_EQ(effect.at(50), 0.35F);
  EXPECT_FLOAT_EQ(effect.at(50), 0.6F);
  EXPECT_FLOAT_EQ(effect.at(800), 0.4F);
}

TEST(PidRamp, Force_GoesFromStartToEnd) {
  Session session;
  const std::int64_t block = session.made(EffectType::kRamp);
  EXPECT_EQ(
      session.send(pid_usage(0x74),
                   {{pid_usage(0x22), block}, {pid_usage(0x75), 8000}, {pid_usage(0x76), -2000}}),
      Status::kOk);
  const Values timed = {{pid_usage(0x50), 1000}, {0x0A0001, degrees(270)}};
  EXPECT_EQ(session.set_effect(block, timed), Status::kOk);
  EXPECT_EQ(session.start(block), Status::kOk);
  EXPECT_FLOAT_EQ(session.force().x(), 0.8F);
  EXPECT_FLOAT_EQ(session.force({}, 500000).x(), 0.3F);
  EXPECT_NEAR(session.force({}, 300000).x(), 0.0F, 1e-6F);
  EXPECT_NEAR(session.force({}, 199999).x(), -0.2F, 1e-5F);
  EXPECT_EQ(session.force({}, 1).x(), 0.0F) << "over";
  EXPECT_EQ(session.device.playing(), 0);
}

// The envelope's levels have no sign; a force keeps its own.
TEST(PidConstant, NegativeWithEnvelope_StaysNegative) {
  Session session;
  const std::int64_t block = session.made(EffectType::kConstant);
  EXPECT_EQ(session.send(pid_usage(0x73), {{pid_usage(0x22), block}, {pid_usage(0x70), -6000}}),
            Status::kOk);
  EXPECT_EQ(
      session.send(pid_usage(0x5A),
                   {{pid_usage(0x22), block}, {pid_usage(0x5B), 10000}, {pid_usage(0x5C), 100}}),
      Status::kOk);
  EXPECT_EQ(session.set_effect(block, {{0x0A0001, degrees(180)}}), Status::kOk);
  EXPECT_EQ(session.start(block), Status::kOk);
  EXPECT_FLOAT_EQ(session.force().y(), -1.0F);
  EXPECT_FLOAT_EQ(session.force({}, 50000).y(), -0.8F);
  EXPECT_FLOAT_EQ(session.force({}, 50000).y(), -0.6F);
}

}  // namespace
}  // namespace test
}  // namespace batuta::pid
