// SPDX-License-Identifier: MIT
// What a port may get wrong: axes and kinds that there are not, counts at the ends of 32 bits,
// buffers without room, devices that lie about what they did; and a bout of garbage, recorded and
// played again.
#include <gtest/gtest.h>

#include <cstring>
#include <memory>
#include <vector>

#include "batuta/port/sample_builder.hpp"
#include "batuta/record/duel.hpp"
#include "batuta/record/memory_stream.hpp"
#include "batuta/record/player.hpp"
#include "batuta/record/recorder.hpp"
#include "draws.hpp"
#include "hostile_numbers.hpp"

namespace batuta {
using namespace fencing;
namespace {

constexpr std::int32_t kLow = test::kLowest<std::int32_t>[0];
constexpr std::int32_t kHigh = test::kHighest<std::int32_t>[0];

TEST(HostilePort, CalibrationThatMakesNoSense_IsRefusedAndTheOldStays) {
  SampleBuilder builder;
  const AxisCalibration good{AxisKind::kAbsolute, false, -100, 100, 0};
  ASSERT_EQ(builder.configure(good, good), Status::kOk);
  builder.axis(Axis::kX, 50);
  std::vector<AxisCalibration> bad(7, good);
  bad[0].kind = static_cast<AxisKind>(2);
  bad[1].kind = static_cast<AxisKind>(255);
  bad[2].min = 100;
  bad[3].min = kHigh;
  bad[4].flat = -1;
  bad[5].flat = 100;
  bad[6].flat = kHigh;
  for (const AxisCalibration& axis : bad) {
    EXPECT_EQ(builder.configure(axis, good), Status::kInvalidArgument);
    EXPECT_EQ(builder.configure(good, axis), Status::kInvalidArgument);
    EXPECT_EQ(builder.configure_feet(axis, good), Status::kInvalidArgument);
    EXPECT_EQ(builder.configure_feet(good, axis), Status::kInvalidArgument);
  }
  builder.axis(Axis::kFeetX, 50);
  const InputSample sample = builder.sync(0).value;
  EXPECT_EQ(sample.x, 0.5F);
  EXPECT_EQ(sample.feet_x, 0.0F) << "a second pair that was refused is none";
}

TEST(HostilePort, AxisOrButtonThatThereIsNot_ChangesNothing) {
  SampleBuilder builder;
  ASSERT_EQ(builder.configure({}, {}), Status::kOk);
  builder.axis(static_cast<Axis>(2), 30000);
  builder.axis(static_cast<Axis>(3), 30000);
  ASSERT_EQ(builder.configure_feet({}, {}), Status::kOk);
  builder.axis(static_cast<Axis>(4), 30000);
  builder.axis(static_cast<Axis>(255), -30000);
  for (const int index :
       {-1, SampleBuilder::kMaxButtons, static_cast<int>(kLow), static_cast<int>(kHigh)}) {
    EXPECT_EQ(builder.button(index, true), Status::kInvalidArgument);
  }
  const auto sample = builder.sync(0).value;
  EXPECT_EQ(sample.x, 0.0F);
  EXPECT_EQ(sample.y, 0.0F);
  EXPECT_EQ(sample.feet_x, 0.0F);
  EXPECT_EQ(sample.feet_y, 0.0F);
  EXPECT_EQ(sample.buttons, 0U);
}

TEST(HostilePort, CountsAtTheEndsOf32Bits_StayInTheSquare) {
  for (const AxisKind kind : {AxisKind::kAbsolute, AxisKind::kRelative}) {
    for (const std::int32_t flat : {0, 1, kHigh - 1}) {
      const AxisCalibration whole{kind, true, kLow, kHigh, flat};
      SampleBuilder builder;
      ASSERT_EQ(builder.configure(whole, whole), Status::kOk);
      for (const std::int32_t counts : {kLow, kHigh, kLow, kLow, -1, 0, 1, kHigh, kHigh}) {
        builder.axis(Axis::kX, counts);
        const auto sample = builder.sync(0).value;
        EXPECT_LE(std::abs(sample.x), 1.0F) << counts;
      }
      EXPECT_EQ(builder.sync(0).value.x, -1.0F);
    }
  }
}

TEST(HostilePort, StampsOfAnyKind_AreOnlyDifferences) {
  static_assert(elapsed_us(0xFFFFFFFFU, 0U) == 1);
  static_assert(elapsed_us(0U, 0x80000000U) == kLow);
  static_assert(!is_later(0U, 0x80000000U) || !is_later(0x80000000U, 0U));
  InputSample sample;
  for (const Microseconds start : {0U, 1U, 0x7FFFFFFFU, 0x80000000U, 0xFFFFFF00U}) {
    sample.time = start;
    EXPECT_FALSE(is_stale(sample, start + 1000U, 1000));
    EXPECT_TRUE(is_stale(sample, start + 1001U, 1000));
    EXPECT_FALSE(is_stale(sample, start - 1000U, 1000));
    EXPECT_TRUE(is_stale(sample, start - 1001U, 1000));
    EXPECT_TRUE(is_stale(sample, start + 0x80000000U, kHigh));
    EXPECT_FALSE(is_stale(sample, start + 0x7FFFFFFFU, kHigh));
  }
}

/// Says whatever it is told to say.
class LyingDevice final : public InputDevice {
 public:
  InputSample sample;
  Status status = Status::kOk;

 private:
  Status do_read(Microseconds /*now*/, InputSample& out) override {
    out = sample;
    return status;
  }
};

TEST(HostilePort, DeviceThatLies_LeavesTheSampleAsItWas) {
  LyingDevice device;
  InputSample seen;
  seen.x = 0.25F;
  const InputSample before = seen;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const float bad : {nan, 1.0001F, -2.0F, std::numeric_limits<float>::infinity(), 1e30F}) {
    for (const bool is_x : {true, false}) {
      device.sample = {};
      (is_x ? device.sample.x : device.sample.y) = bad;
      EXPECT_EQ(device.read(0, seen), Status::kInvalidArgument) << bad;
      EXPECT_EQ(std::memcmp(&seen, &before, sizeof(seen)), 0);
    }
  }
  device.sample = {};
  device.status = Status::kUnavailable;
  EXPECT_EQ(device.read(0, seen), Status::kUnavailable);
  EXPECT_EQ(std::memcmp(&seen, &before, sizeof(seen)), 0);
}

/// Claims to have moved more bytes than it was asked for, or fewer than none.
class LyingStream final : public ByteSink, public ByteSource {
 public:
  int claim = 0;

 private:
  int do_write(const std::uint8_t* /*bytes*/, int /*count*/) override { return claim; }
  int do_read(std::uint8_t* /*bytes*/, int /*capacity*/) override { return claim; }
};

TEST(HostilePort, StreamThatLies_IsNotBelieved) {
  LyingStream stream;
  std::uint8_t bytes[4] = {};
  for (const int claim : {5, -1, -5, kHigh, static_cast<int>(kLow)}) {
    stream.claim = claim;
    EXPECT_EQ(stream.write(&bytes[0], 4), 0);
    EXPECT_EQ(stream.read(&bytes[0], 4), -1);
  }
  stream.claim = 2;
  EXPECT_EQ(stream.write(nullptr, 4), 0);
  EXPECT_EQ(stream.read(nullptr, 4), 0);
  for (const int count : {0, -1, static_cast<int>(kLow)}) {
    EXPECT_EQ(stream.write(&bytes[0], count), 0);
    EXPECT_EQ(stream.read(&bytes[0], count), 0);
  }
}

TEST(HostilePort, MemoryWithoutRoom_GivesAndTakesNothing) {
  std::uint8_t bytes[4] = {1, 2, 3, 4};
  for (const int size : {0, -1, static_cast<int>(kLow)}) {
    MemorySource source(&bytes[0], size);
    MemorySink sink(&bytes[0], size);
    std::uint8_t out[4] = {};
    EXPECT_EQ(source.read(&out[0], 4), -1) << size;
    EXPECT_EQ(sink.write(&out[0], 4), 0) << size;
    EXPECT_EQ(sink.size(), 0);
  }
}

using DuelType = Duel<>;

std::unique_ptr<DuelType> ready_duel() {
  auto duel = std::make_unique<DuelType>();
  EXPECT_EQ(duel->configure(duel_settings(), first_fencer<float>(), second_fencer<float>()),
            Status::kOk);
  return duel;
}

TEST(HostilePort, BuffersWithoutRoom_AreRefusedAndNothingIsWritten) {
  const auto duel = ready_duel();
  std::vector<std::uint8_t> bytes(Recorder::kRoom<DuelType>, std::uint8_t{0xA5});
  const auto untouched = bytes;
  LyingStream sink;  // takes nothing
  for (const int capacity : {static_cast<int>(kLow), -1, 0, 1, batuta::detail::kSnapshotHead - 1}) {
    EXPECT_EQ(save(*duel, bytes.data(), capacity).status, Status::kPoolFull) << capacity;
    Recorder recorder(sink, bytes.data(), capacity);
    EXPECT_EQ(recorder.begin<DuelInput>(*duel, 10), Status::kPoolFull);
    recorder.step(DuelInput{}, *duel);
    EXPECT_EQ(recorder.end(*duel), Status::kUnavailable);
    EXPECT_EQ(bytes, untouched);
    MemorySource source(untouched.data(), static_cast<int>(untouched.size()));
    Player player(source, bytes.data(), capacity);
    EXPECT_EQ(player.begin<DuelInput>(*duel), Playback::kTooLarge);
    EXPECT_EQ(bytes, untouched);
    const auto before = hash_of(*duel);
    EXPECT_NE(restore(*duel, bytes.data(), capacity), Restored::kOk);
    EXPECT_EQ(hash_of(*duel), before);
  }
}

/// Any bits, in the square or not.
DuelInput garbage_of(std::uint32_t step) {
  test::Draws draw(66, 0, step);
  DuelInput input;
  for (const Side side : {Side::kLeft, Side::kRight}) {
    InputSample sample;
    const std::uint64_t bits = draw.bits();
    std::memcpy(&sample.x, &bits, sizeof(sample.x));
    sample.y = draw.chance(0.1) ? std::numeric_limits<float>::quiet_NaN() : -1.0F;
    sample.time = static_cast<Microseconds>(draw.bits());
    sample.sequence = static_cast<std::uint32_t>(draw.bits());
    input.set(side, draw.chance(0.8) ? &sample : nullptr);
  }
  return input;
}

TEST(HostilePort, BoutOfGarbage_IsRecordedAndPlayedToTheSameBits) {
  constexpr std::uint32_t kSteps = 500;
  std::vector<std::uint8_t> file(1 << 20);
  std::vector<std::uint8_t> buffer(Recorder::kRoom<DuelType>);
  MemorySink sink(file.data(), static_cast<int>(file.size()));
  const auto duel = ready_duel();
  Recorder recorder(sink, buffer.data(), static_cast<int>(buffer.size()));
  ASSERT_EQ(recorder.begin<DuelInput>(*duel, 50), Status::kOk);
  for (std::uint32_t step = 0; step < kSteps; ++step) {
    const DuelInput input = garbage_of(step);
    ASSERT_EQ(duel->step(input.at(Side::kLeft), input.at(Side::kRight)), Status::kOk);
    recorder.step(input, *duel);
  }
  ASSERT_EQ(recorder.end(*duel), Status::kOk);
  ASSERT_TRUE(recorder.flush());
  ASSERT_EQ(recorder.lost(), 0U);

  MemorySource source(file.data(), sink.size());
  Player player(source, buffer.data(), static_cast<int>(buffer.size()));
  const auto again = std::make_unique<DuelType>();
  ASSERT_EQ(player.begin<DuelInput>(*again), Playback::kReady);
  DuelInput input;
  Playback answer = player.next(input, *again);
  while (answer == Playback::kStep) {
    ASSERT_EQ(again->step(input.at(Side::kLeft), input.at(Side::kRight)), Status::kOk);
    answer = player.next(input, *again);
  }
  EXPECT_EQ(answer, Playback::kEnd);
  EXPECT_EQ(player.steps(), kSteps);
  EXPECT_EQ(player.agreed(), kSteps / 50 + 1);
}

}  // namespace
}  // namespace batuta
