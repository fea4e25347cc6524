// SPDX-License-Identifier: MIT
#include "batuta/record/recorder.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "batuta/record/memory_stream.hpp"
#include "batuta/record/player.hpp"

namespace batuta {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// What a step is given: 0, 1 or 2 numbers.
struct Numbers {
  std::array<std::uint16_t, 2> values{};
  std::uint8_t used = 0;

  void archive(Archive& ar) {
    used = static_cast<std::uint8_t>(ar.count(used, 2));
    const int shown = ar.shaping() ? 2 : used;
    for (int i = 0; i < shown; ++i) ar(values[static_cast<std::size_t>(i)]);
  }
};

/// A run that anything changes: each step folds its input into a sum.
struct Sum {
  std::uint32_t sum = 1;
  std::uint32_t steps = 0;
  float last = 0;

  void step(const Numbers& input) {
    sum = sum * 1664525U + 1013904223U + input.used;
    for (int i = 0; i < input.used; ++i) sum ^= input.values[static_cast<std::size_t>(i)];
    last = static_cast<float>(sum % 1000U);
    ++steps;
  }
  void archive(Archive& ar) {
    auto& [a, b, c] = *this;
    ar(a, b, c);
  }
};

Numbers input_of(std::uint32_t step) {
  Numbers input;
  input.used = static_cast<std::uint8_t>(step % 3);
  input.values = {static_cast<std::uint16_t>(step * 7919U), static_cast<std::uint16_t>(step)};
  return input;
}

constexpr std::uint32_t kSteps = 25;
constexpr std::uint32_t kHashEvery = 4;

/// Takes at most so many bytes a call, and in all.
class NarrowSink final : public ByteSink {
 public:
  explicit NarrowSink(int at_once, int in_all = 1 << 20) : at_once_(at_once), left_(in_all) {}
  Bytes bytes;
  void open(int more) { left_ += more; }

 private:
  int do_write(const std::uint8_t* data, int count) override {
    const int taken = min_of(min_of(count, at_once_), left_);
    bytes.insert(bytes.end(), data, data + taken);
    left_ -= taken;
    return taken;
  }
  int at_once_;
  int left_;
};

/// Gives one byte a call, and every second time none.
class SlowSource final : public ByteSource {
 public:
  explicit SlowSource(const Bytes& bytes) : bytes_(bytes) {}

 private:
  int do_read(std::uint8_t* data, int /*capacity*/) override {
    if (at_ == bytes_.size()) return -1;
    nothing_ = !nothing_;
    if (nothing_) return 0;
    *data = bytes_[at_++];
    return 1;
  }
  const Bytes& bytes_;
  std::size_t at_ = 0;
  bool nothing_ = false;
};

template <class Sink>
Recorder& record(Recorder& recorder, Sink& /*sink*/, std::uint32_t steps = kSteps) {
  Sum run;
  EXPECT_EQ(recorder.begin<Numbers>(run, kHashEvery), Status::kOk);
  for (std::uint32_t i = 0; i < steps; ++i) {
    run.step(input_of(i));
    recorder.step(input_of(i), run);
  }
  for (int i = 0; i < 1000 && recorder.end(run) == Status::kPoolFull; ++i) (void)recorder.flush();
  for (int i = 0; i < 1000 && !recorder.flush(); ++i) {
  }
  return recorder;
}

Bytes recorded(std::uint32_t steps = kSteps) {
  NarrowSink sink(1 << 20);
  Bytes buffer(256);
  Recorder recorder(sink, buffer.data(), 256);
  record(recorder, sink, steps);
  EXPECT_EQ(recorder.lost(), 0U);
  return sink.bytes;
}

struct Played {
  Playback answer = Playback::kWaiting;
  std::uint32_t steps = 0;
  std::uint32_t agreed = 0;
  std::uint32_t lost = 0;
  Sum run;
};

/// Plays to the end. @param spoil  the step after which the run goes astray
Played played(ByteSource& source, std::uint32_t spoil = ~0U, int capacity = 256) {
  Bytes buffer(static_cast<std::size_t>(capacity));
  Player player(source, buffer.data(), capacity);
  Played result;
  result.run.sum = 99;
  int calls = 0;
  const auto wait = [&calls](Playback answer) {
    return answer == Playback::kWaiting && ++calls < 10000;
  };
  do result.answer = player.begin<Numbers>(result.run);
  while (wait(result.answer));
  while (result.answer == Playback::kReady || result.answer == Playback::kStep) {
    Numbers input;
    do result.answer = player.next(input, result.run);
    while (wait(result.answer));
    if (result.answer != Playback::kStep) break;
    result.run.step(input);
    if (player.steps() == spoil) ++result.run.sum;
  }
  result.steps = player.steps();
  result.agreed = player.agreed();
  result.lost = player.lost();
  return result;
}

Played played(const Bytes& bytes, std::uint32_t spoil = ~0U) {
  MemorySource source(bytes.data(), static_cast<int>(bytes.size()));
  return played(source, spoil);
}

TEST(Recording, Played_GivesTheSameRun) {
  const Played result = played(recorded());
  EXPECT_EQ(result.answer, Playback::kEnd);
  EXPECT_EQ(result.steps, kSteps);
  EXPECT_EQ(result.agreed, kSteps / kHashEvery + 1);
  Sum run;
  for (std::uint32_t i = 0; i < kSteps; ++i) run.step(input_of(i));
  EXPECT_EQ(result.run.sum, run.sum);
}

TEST(Recording, WithoutSteps_Ends) {
  const Played result = played(recorded(0));
  EXPECT_EQ(result.answer, Playback::kEnd);
  EXPECT_EQ(result.steps, 0U);
}

/// A run that ends on a step with a hash has the hash and the end mark of one state.
TEST(Recording, EndOnAHash_Ends) {
  EXPECT_EQ(played(recorded(2 * kHashEvery)).answer, Playback::kEnd);
}

TEST(Player, RunGoesAstray_SaysAfterWhichHash) {
  const Bytes bytes = recorded();
  for (std::uint32_t spoil = 1; spoil <= kSteps; ++spoil) {
    const Played result = played(bytes, spoil);
    EXPECT_EQ(result.answer, Playback::kParted) << spoil;
    const std::uint32_t next_hash = (spoil + kHashEvery - 1) / kHashEvery * kHashEvery;
    EXPECT_EQ(result.steps, std::min(next_hash, kSteps)) << spoil;
  }
}

TEST(Recorder, SlowSink_LosesNothing) {
  NarrowSink sink(
      9);  // a step takes 14 bytes or more, its hash 19: the buffer holds what is behind
  Bytes buffer(1024);
  Recorder recorder(sink, buffer.data(), 1024);
  record(recorder, sink);
  EXPECT_EQ(sink.bytes, recorded());
}

/// As slow a sink and a small buffer: what is missing is said.
TEST(Recorder, SinkTooSlow_CountsWhatIsMissing) {
  NarrowSink sink(6);
  Bytes buffer(100);
  Recorder recorder(sink, buffer.data(), 100);
  record(recorder, sink);
  ASSERT_GT(recorder.lost(), 0U);
  EXPECT_EQ(recorder.steps() + recorder.lost(), kSteps);
  const Played result = played(sink.bytes);
  EXPECT_EQ(result.answer, Playback::kGap);
  EXPECT_EQ(result.steps, recorder.steps());
  EXPECT_EQ(result.lost, recorder.lost());
}

TEST(Recorder, LastStepAloneMissing_IsAGap) {
  NarrowSink sink(1 << 20, 0);
  Bytes buffer(128);
  Recorder recorder(sink, buffer.data(), 128);
  Sum run;
  ASSERT_EQ(recorder.begin<Numbers>(run, 0), Status::kOk);
  for (std::uint32_t i = 0; recorder.lost() == 0; ++i) {
    ASSERT_LT(i, 128U);
    run.step(input_of(i));
    recorder.step(input_of(i), run);
  }
  sink.open(1 << 20);
  ASSERT_EQ(recorder.end(run), Status::kOk);
  ASSERT_TRUE(recorder.flush());
  const Played result = played(sink.bytes);
  EXPECT_EQ(result.answer, Playback::kGap);
  EXPECT_EQ(result.lost, 1U);
  EXPECT_EQ(result.steps, recorder.steps());
}

TEST(Recorder, SinkFull_IsACutRecordingWhoseStepsAreGood) {
  const Bytes whole = recorded();
  for (int room = 0; room < static_cast<int>(whole.size()); ++room) {
    NarrowSink sink(1 << 20, room);
    Bytes buffer(128);
    Recorder recorder(sink, buffer.data(), 128);
    record(recorder, sink);
    const Played result = played(sink.bytes);
    EXPECT_EQ(result.answer, Playback::kCut) << room;
    EXPECT_LE(result.steps, kSteps);
  }
}

TEST(Recorder, SmallBuffer_RefusesToBegin) {
  NarrowSink sink(1 << 20);
  Bytes buffer(256);
  const Sum run;
  Recorder small(sink, buffer.data(), 30);
  EXPECT_EQ(small.begin<Numbers>(run, 1), Status::kPoolFull);
  Recorder enough(sink, buffer.data(), Recorder::kRoom<Sum>);
  EXPECT_EQ(enough.begin<Numbers>(run, 1), Status::kOk);
}

TEST(Recorder, NotBegun_WritesNothing) {
  NarrowSink sink(1 << 20);
  Bytes buffer(256);
  Recorder recorder(sink, buffer.data(), 256);
  recorder.step(Numbers{}, Sum{});
  EXPECT_EQ(recorder.end(Sum{}), Status::kUnavailable);
  EXPECT_TRUE(recorder.flush());
  EXPECT_TRUE(sink.bytes.empty());
}

TEST(Player, SourceByteByByte_Waits) {
  const Bytes bytes = recorded();
  SlowSource source(bytes);
  EXPECT_EQ(played(source).answer, Playback::kEnd);
}

TEST(Player, EveryBitDamaged_IsNoticed) {
  const Bytes good = recorded();
  for (std::size_t i = 0; i < 8 * good.size(); ++i) {
    Bytes bytes = good;
    bytes[i / 8] = static_cast<std::uint8_t>(bytes[i / 8] ^ (1U << (i % 8)));
    const Played result = played(bytes);
    EXPECT_NE(result.answer, Playback::kEnd) << "bit " << i;
    EXPECT_NE(result.answer, Playback::kWaiting) << "bit " << i;
    EXPECT_LE(result.steps, kSteps);
  }
}

TEST(Player, RecordsLeftOutOrRepeated_IsNoticed) {
  const Bytes good = recorded();
  const std::size_t head = 20 + 12 + 4 + 3 + 14 + 4;  // the state at the start, the run
  for (std::size_t at = head; at + 7 < good.size();) {
    const std::size_t size = 3U + good[at + 1] + 4U;
    const auto first = good.begin() + static_cast<std::ptrdiff_t>(at);
    const auto last = first + static_cast<std::ptrdiff_t>(size);
    Bytes without(good.begin(), first);
    without.insert(without.end(), last, good.end());
    Bytes twice(good.begin(), last);
    twice.insert(twice.end(), first, good.end());
    const bool is_hash = good[at] == 'H';
    const bool is_end = good[at] == 'E';
    EXPECT_EQ(played(without).answer == Playback::kEnd, is_hash) << at;  // of hashes one is enough
    const Playback after = is_end ? Playback::kEnd : Playback::kDamaged;
    EXPECT_EQ(played(twice).answer, after) << at;  // nobody reads on behind the end mark
    at += size;
  }
}

/// An input of another type is another scene.
struct Other {
  std::uint32_t value = 0;
  void archive(Archive& ar) { ar(value); }
};

TEST(Player, OfAnotherKind_SaysWhich) {
  const Bytes bytes = recorded();
  Bytes buffer(256);
  const auto begun = [&buffer](const Bytes& file, auto input, int capacity) {
    MemorySource source(file.data(), static_cast<int>(file.size()));
    Player player(source, buffer.data(), capacity);
    Sum run;
    return player.begin<decltype(input)>(run);
  };
  EXPECT_EQ(begun(bytes, Numbers{}, 256), Playback::kReady);
  EXPECT_EQ(begun(bytes, Other{}, 256), Playback::kOtherScene);
  EXPECT_EQ(begun(bytes, Numbers{}, 30), Playback::kTooLarge);
  EXPECT_EQ(begun(Bytes(100, 'x'), Numbers{}, 256), Playback::kForeign);
}

/// A state with a member that the recorded one lacks, as an earlier version's may.
struct LongerSum {
  Sum sum;
  std::uint32_t more = 0;
  void archive(Archive& ar) { ar(sum, more); }
};

/// The recording as if it were of that version, with its check sum.
Bytes of_version(std::uint8_t version) {
  Bytes bytes = recorded();
  const std::size_t run = 20 + 12 + 4;  // behind the state at the start
  bytes[run + 3] = version;
  batuta::detail::seal(bytes.data() + run, 3 + 14);
  return bytes;
}

// Also where the state of that version was of another type, and whatever the pace of the source.
TEST(Player, OfAnotherVersion_SaysWhich) {
  Bytes buffer(256);
  const auto begun = [&buffer](const Bytes& file, auto state, int capacity) {
    SlowSource source(file);
    Player player(source, buffer.data(), capacity);
    Playback answer = Playback::kWaiting;
    for (int i = 0; i < 10000 && answer == Playback::kWaiting; ++i) {
      answer = player.begin<Numbers>(state);
    }
    return std::pair{answer, player.version()};
  };
  for (const int version : {1, 7}) {
    const Bytes other = of_version(static_cast<std::uint8_t>(version));
    EXPECT_EQ(begun(other, Sum{}, 256), (std::pair{Playback::kOtherVersion, version}));
    for (const int capacity : {24, 40, 256}) {
      EXPECT_EQ(begun(other, LongerSum{}, capacity), (std::pair{Playback::kOtherVersion, version}));
    }
  }
  const Bytes today = of_version(2);
  EXPECT_EQ(begun(today, Sum{}, 256), (std::pair{Playback::kReady, 2}));
  EXPECT_EQ(begun(today, LongerSum{}, 256), (std::pair{Playback::kOtherScene, 2}));
  const Bytes torn(today.begin(), today.begin() + 40);
  EXPECT_EQ(begun(torn, LongerSum{}, 256), (std::pair{Playback::kOtherScene, 0}));
}

TEST(Player, OfAnotherVersionOfStates_SaysWhich) {
  Bytes buffer(256);
  for (const int version : {0, 0x0100, 2, 0x0201, 0xFFFF, 1}) {
    Bytes bytes = recorded();
    bytes[4] = static_cast<std::uint8_t>(version & 0xFF);
    bytes[5] = static_cast<std::uint8_t>(version >> 8);
    MemorySource source(bytes.data(), static_cast<int>(bytes.size()));
    Player player(source, buffer.data(), 256);
    Sum run;
    const bool is_other = version != 1;
    EXPECT_EQ(player.begin<Numbers>(run), is_other ? Playback::kOtherVersion : Playback::kReady);
    EXPECT_EQ(player.state_version(), version);
    EXPECT_EQ(player.version(), is_other ? 0 : 2);
  }
}

/// Python's zlib and struct over the document (src/record/recorder.md): a recording of no step.
TEST(Recording, RunRecord_BytesOfTheDocument) {
  const Bytes bytes = recorded(0);
  ASSERT_EQ(bytes.size(), 36U + 21U + 23U);
  EXPECT_EQ(Bytes(bytes.begin() + 36, bytes.begin() + 45),
            (Bytes{'R', 14, 0, 2, 0, kHashEvery, 0, 0, 0}));
  EXPECT_EQ(Bytes(bytes.begin() + 57, bytes.begin() + 64), (Bytes{'E', 16, 0, 0, 0, 0, 0}));
}

}  // namespace
}  // namespace batuta
