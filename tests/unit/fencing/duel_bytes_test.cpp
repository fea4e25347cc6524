// SPDX-License-Identifier: MIT
// What bytes under a good check sum may put into a duel, and what becomes of one that refused them.
#include <algorithm>
#include <vector>

#include "batuta/fencing/duel_definitions.hpp"
#include "batuta/record/duel.hpp"
#include "batuta/record/memory_stream.hpp"
#include "batuta/record/recorder.hpp"
#include "batuta/record/snapshot.hpp"
#include "configured_duel.hpp"

namespace batuta {
using namespace fencing;
namespace {

using Bytes = std::vector<std::uint8_t>;
using DuelBytes = test::ConfiguredDuel<Duel<>>;

constexpr int kRoom = kSnapshotRoom<Duel<>>;

Bytes saved(const Duel<>& duel) {
  Bytes bytes(static_cast<std::size_t>(kRoom));
  const Result<int> size = save(duel, bytes.data(), kRoom);
  EXPECT_EQ(size.status, Status::kOk);
  bytes.resize(static_cast<std::size_t>(size.value));
  return bytes;
}

Restored restored(Duel<>& duel, const Bytes& bytes) {
  return restore(duel, bytes.data(), static_cast<int>(bytes.size()));
}

void seal(Bytes& bytes) {
  batuta::detail::seal(bytes.data(), static_cast<int>(bytes.size()) - batuta::detail::kCheckSum);
}

std::array<std::uint8_t, 4> bytes_of(float x) {
  std::array<std::uint8_t, 4> bytes{};
  std::memcpy(bytes.data(), &x, bytes.size());  // hosts are little-endian, as the format is
  return bytes;
}

/// Puts `forged` wherever the number `was` is. @returns where
std::vector<std::ptrdiff_t> forge(Bytes& bytes, float was, float forged) {
  const auto from = bytes_of(was);
  const auto to = bytes_of(forged);
  std::vector<std::ptrdiff_t> places;
  for (auto at = std::search(bytes.begin(), bytes.end(), from.begin(), from.end());
       at != bytes.end(); at = std::search(at, bytes.end(), from.begin(), from.end())) {
    places.push_back(at - bytes.begin());
    std::copy(to.begin(), to.end(), at);
  }
  seal(bytes);
  return places;
}

constexpr float kMark = 0.123456F;  // found nowhere else in the bytes

/// Numbers that configure() refuses in a hand are refused where they are read: a step would end in
/// an assertion.
TEST_F(DuelBytes, GripThatConfigureRefuses_IsRefused) {
  using Settings = GripSettings<float>;
  for (float Settings::*const member :
       {&Settings::torque, &Settings::force, &Settings::min_regain, &Settings::max_regain,
        &Settings::recover_time, &Settings::largest_turn, &Settings::forte, &Settings::composure,
        &Settings::settle_torque, &Settings::max_lost}) {
    Fencer<float> left = first_fencer<float>();
    left.grip.min_regain = 0.01F;
    left.grip.*member = kMark;
    ASSERT_EQ(duel->configure(settings, left, second_fencer<float>()), Status::kOk);
    for (const float bad : {-1.0F, 0.0F, -1e9F}) {
      Bytes bytes = saved(*duel);
      ASSERT_EQ(forge(bytes, kMark, bad).size(), 1U);
      Duel<> other;
      ASSERT_EQ(restored(other, bytes), Restored::kOutOfRange);
      EXPECT_EQ(other.step(nullptr, nullptr), Status::kInvalidArgument);
    }
  }
}

TEST_F(DuelBytes, StickOutsideItsSquareOrSettings_IsRefused) {
  InputSample sample;
  sample.time = 1000;
  sample.x = kMark;  // on its way there: the goal
  ASSERT_EQ(duel->step(&sample, nullptr), Status::kOk);
  Bytes bytes = saved(*duel);
  ASSERT_GE(forge(bytes, kMark, 7.0F).size(), 1U);
  Duel<> other;
  EXPECT_EQ(restored(other, bytes), Restored::kOutOfRange);

  settings.stick.max_speed = 1000 * kMark;
  ASSERT_EQ(configure(), Status::kOk);
  bytes = saved(*duel);
  ASSERT_GE(forge(bytes, settings.stick.max_speed, -1.0F).size(), 1U);
  EXPECT_EQ(restored(other, bytes), Restored::kOutOfRange);
}

/// A duel with a map of its own refuses an honest snapshot of a duel with the library's, whose
/// blades have other ids than its own: they were put on guard anew.
TEST_F(DuelBytes, ConfiguredAfterARefusal_IsADuelLikeAnother) {
  settings.touches = 5;
  settings.halt_us = 0;
  settings.strip.corps_a_corps_us = 1000;
  settings.salle.distance = 1.5F;  // body to body: a halt in each step
  ASSERT_EQ(configure(), Status::kOk);
  for (int i = 0; i < 5; ++i) ASSERT_EQ(duel->step(nullptr, nullptr), Status::kOk);
  ASSERT_GT(duel->bout().exchange, 1U);
  const Bytes foreign = saved(*duel);

  Duel<> mine;
  const auto configured = [](Duel<>& one) {
    return one.configure(duel_settings(), test::thruster(first_fencer<float>()),
                         second_fencer<float>());
  };
  ASSERT_EQ(configured(mine), Status::kOk);
  ASSERT_EQ(restored(mine, foreign), Restored::kOutOfRange);
  ASSERT_EQ(mine.step(nullptr, nullptr), Status::kInvalidArgument);
  ASSERT_EQ(configured(mine), Status::kOk);
  Duel<> fresh;
  ASSERT_EQ(configured(fresh), Status::kOk);
  for (int i = 0; i < 100; ++i) {
    ASSERT_EQ(hash_of(mine), hash_of(fresh)) << i;
    ASSERT_EQ(mine.step(nullptr, nullptr), Status::kOk);
    ASSERT_EQ(fresh.step(nullptr, nullptr), Status::kOk);
  }
}

/// Also what the world told of the last bout's last step.
TEST_F(DuelBytes, ConfiguredAnew_RemembersNothing) {
  const std::uint64_t fresh = hash_of(*duel);
  InputSample sample;
  for (int i = 0; duel->world().events().empty() && i < 2000; ++i) {
    sample.time += 1000;
    sample.y = 0.5F * static_cast<float>(i % 200) / 200.0F;
    ASSERT_EQ(duel->step(&sample, nullptr), Status::kOk);
  }
  ASSERT_FALSE(duel->world().events().empty());
  ASSERT_EQ(configure(), Status::kOk);
  EXPECT_TRUE(duel->world().events().empty());
  EXPECT_EQ(duel->world().report().pairs, 0U);
  EXPECT_EQ(hash_of(*duel), fresh);
}

/// What configure() takes is kept and read again, or nobody says that it was kept.
TEST_F(DuelBytes, WhatIsWritten_IsRead) {
  const auto mass = [](float kilograms) {
    Fencer<float> fencer = first_fencer<float>();
    fencer.weapon.mass *= kilograms;
    fencer.weapon.moments *= kilograms;
    return fencer;
  };
  int written = 0;
  int refused = 0;
  for (const float max_speed : {16.0F, 1e6F, 2e9F, 1e30F}) {
    for (const float kilograms : {1.0F, 1e3F, 1e9F, 1e10F, 1e-5F, 1e-9F}) {
      settings.stick.max_speed = max_speed;
      if (duel->configure(settings, mass(kilograms), second_fencer<float>()) != Status::kOk)
        continue;
      std::vector<std::uint8_t> bytes(static_cast<std::size_t>(kRoom));
      const Result<int> size = save(*duel, bytes.data(), kRoom);
      bytes.resize(static_cast<std::size_t>(size.value));
      Duel<> other;
      EXPECT_EQ(size.ok(), restored(other, bytes) == Restored::kOk)
          << max_speed << ' ' << kilograms;
      std::vector<std::uint8_t> room(static_cast<std::size_t>(Recorder::kRoom<Duel<>>));
      std::vector<std::uint8_t> target(2 * room.size());
      MemorySink sink(target.data(), static_cast<int>(target.size()));
      Recorder recorder(sink, room.data(), static_cast<int>(room.size()));
      EXPECT_EQ(recorder.begin<DuelInput>(*duel, 10), size.status);
      size.ok() ? ++written : ++refused;
    }
  }
  EXPECT_GT(written, 3);
  EXPECT_GT(refused, 3);
}

/// A bout from a step on: both lunge, the right one `delay` steps later, until a halt is called.
Bout<float> both_lunge(std::uint32_t from, int delay) {
  auto settings = duel_settings();
  settings.touches = 5;
  settings.salle.distance = 2.25F;
  Duel<> duel;
  EXPECT_EQ(duel.configure(settings, first_fencer<float>(), second_fencer<float>()), Status::kOk);
  Bytes bytes = saved(duel);
  const std::size_t count_at =
      bytes.size() - batuta::detail::kCheckSum - sizeof(float) - sizeof from;
  std::memcpy(bytes.data() + count_at, &from, sizeof from);
  seal(bytes);
  EXPECT_EQ(restored(duel, bytes), Restored::kOk);
  EXPECT_EQ(duel.steps(), from);
  for (int i = 0; i < 900 && duel.bout().state != BoutState::kHalt; ++i) {
    InputSample left;
    InputSample right;
    left.time = right.time = static_cast<std::uint32_t>(1000 * i);
    if (i >= 20) left.x = -(left.y = 1);
    if (i >= 20 + delay) right.x = right.y = 1;
    EXPECT_EQ(duel.step(&left, &right), Status::kOk);
  }
  return duel.bout();
}

/// Steps are counted in 32 bits: at 1 kHz they come round after 49 days. The second of two touches
/// counts where it would at the start.
TEST(DuelSteps, DoubleTouchWhereTheirCountComesRound_IsOne) {
  for (int delay = 0; delay < 60; delay += 3) {
    const Bout<float> first = both_lunge(0, delay);
    if (first.touches.size() < 2) continue;
    const std::uint32_t a = first.touches[0].when.step;
    const std::uint32_t b = first.touches[1].when.step;
    if (b - a < 2) continue;
    const Bout<float> wrapped = both_lunge(0U - (a + (b - a) / 2), delay);
    ASSERT_EQ(wrapped.touches.size(), 2) << delay;
    EXPECT_EQ(wrapped.touches[1].when.step - wrapped.touches[0].when.step, b - a);
    EXPECT_EQ(wrapped.score, first.score);
    return;
  }
  FAIL() << "no two touches in different steps";
}

}  // namespace
}  // namespace batuta
