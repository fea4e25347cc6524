// SPDX-License-Identifier: MIT
#include "programs/devices/recording.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sys/stat.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

namespace batuta::host {
namespace {

using testing::HasSubstr;

const std::string kStick =
    "# EVEMU 1.3\nN: a stick\nI: 0003 0001 0002 0003\nP: 00 00 00 00 00 00 00 00\n"
    "B: 00 0b 00 00 00 00 00 00 00\nB: 03 03 00 00 00 00 00 00 00\n"
    "A: 00 -100 100 0 0 0\nA: 01 -100 100 0 20 0\n";

LoadedRecording parse(const std::string& text, const std::string& description = {}) {
  return parse_recording(text, "test", description);
}

Recording good(const std::string& text, const std::string& description = {}) {
  LoadedRecording loaded = parse(text, description);
  EXPECT_EQ(loaded.error, "");
  return loaded.recording;
}

TEST(Recording, Relative_SumsFromTheCentre_UpIsANegativeCount) {
  const Recording recording = good(
      "E: 100.000000 0002 0000 40\nE: 100.000000 0000 0000 0\n"
      "E: 100.010000 0002 0000 40\nE: 100.010000 0002 0001 -100\nE: 100.010000 0000 0000 0\n");
  ASSERT_EQ(recording.samples.size(), 2U);
  EXPECT_EQ(recording.samples[0].time, 0U) << "rebased";
  EXPECT_FLOAT_EQ(recording.samples[0].x, 0.1F);
  EXPECT_EQ(recording.samples[1].time, 10000U);
  EXPECT_FLOAT_EQ(recording.samples[1].x, 0.2F);
  EXPECT_FLOAT_EQ(recording.samples[1].y, 0.25F);
  EXPECT_DOUBLE_EQ(recording.duration, 0.01);
  EXPECT_EQ(recording.note, "");
}

TEST(Recording, RelativeWithFineGrid_HalfTheWidestStrokeReachesTheRim) {
  const Recording recording = good(
      "E: 0.000000 0002 0000 3000\nE: 0.000000 0000 0000 0\n"
      "E: 0.100000 0002 0000 3000\nE: 0.100000 0000 0000 0\n"
      "E: 9.000000 0002 0000 -10\nE: 9.000000 0000 0000 0\n");
  EXPECT_EQ(recording.samples[0].x, 1.0F);
  EXPECT_FLOAT_EQ(recording.samples[2].x, 1.0F - 10.0F / 3000.0F);
}

TEST(Recording, RelativeLongDrift_IsNoStroke) {
  std::string text;
  for (int second = 0; second < 100; ++second) {
    text += "E: " + std::to_string(2 * second) +
            ".000000 0002 0000 100\nE: " + std::to_string(2 * second) + ".000000 0000 0000 0\n";
  }
  EXPECT_FLOAT_EQ(good(text).samples[0].x, 0.25F);
}

const std::string kStickEvents =
    "E: 5.000000 0003 0000 0050\nE: 5.000000 0003 0001 -060\nE: 5.000000 0000 0000 0000\n";

void expect_stick(const Recording& recording) {
  ASSERT_EQ(recording.samples.size(), 1U);
  EXPECT_FLOAT_EQ(recording.samples[0].x, 0.5F);
  EXPECT_FLOAT_EQ(recording.samples[0].y, 0.5F) << "beside the dead zone of 20";
  EXPECT_EQ(recording.device, "a stick");
  EXPECT_EQ(recording.note, "");
}

TEST(Recording, Absolute_CalibratedByTheDescription_InlineOrBeside) {
  expect_stick(good(kStick + "# waiting\n" + kStickEvents));
  expect_stick(good(kStickEvents, kStick));
}

/// A pad with two sticks and a hat: axes 0, 1, 3, 4, 16, 17.
const std::string kTwoSticks =
    "# EVEMU 1.3\nN: a pad\nI: 0003 0001 0002 0003\nP: 00 00 00 00 00 00 00 00\n"
    "B: 00 0b 00 00 00 00 00 00 00\nB: 03 1b 00 03 00 00 00 00 00\n"
    "A: 00 -100 100 0 0 0\nA: 01 -100 100 0 0 0\nA: 03 -10 10 0 0 0\nA: 04 -10 10 0 0 0\n"
    "A: 10 -1 1 0 0 0\nA: 11 -1 1 0 0 0\n";

TEST(Recording, SecondStick_IsForTheFeet) {
  const Recording recording =
      good(kTwoSticks + kStickEvents +
           "E: 5.100000 0003 0003 0002\nE: 5.100000 0003 0004 -005\nE: 5.100000 0003 0011 0001\n"
           "E: 5.100000 0000 0000 0000\n");
  ASSERT_EQ(recording.samples.size(), 2U);
  EXPECT_EQ(recording.samples[0].feet_y, 0.0F);
  EXPECT_FLOAT_EQ(recording.samples[1].x, 0.5F);
  EXPECT_FLOAT_EQ(recording.samples[1].feet_x, 0.2F);
  EXPECT_FLOAT_EQ(recording.samples[1].feet_y, 0.5F) << "and not the hat; fewer counts are up";
}

TEST(Recording, WhereOnlyTheHatMoves_ItIsForTheFeet) {
  const Recording recording =
      good(kTwoSticks + kStickEvents + "E: 5.100000 0003 0011 0001\nE: 5.100000 0000 0000 0000\n");
  ASSERT_EQ(recording.samples.size(), 2U);
  EXPECT_EQ(recording.samples[1].feet_y, -1.0F);
}

TEST(Recording, SecondStickOfUnknownRange_OrOfAMouse_IsNone) {
  const std::string moves = "E: 5.100000 0003 0004 -005\nE: 5.100000 0000 0000 0000\n";
  EXPECT_EQ(good(kStickEvents + moves).samples[1].feet_y, 0.0F);
  EXPECT_EQ(good(kTwoSticks + "E: 5.000000 0002 0000 1\nE: 5.000000 0000 0000 0\n" + moves)
                .samples[1]
                .feet_y,
            0.0F);
}

TEST(Recording, AVersionWithoutADescription_IsNotOne) {
  expect_stick(good("# EVEMU 1.3\n" + kStickEvents, kStick));
}

TEST(Recording, CarriageReturns_MakeNoDifference) {
  std::string text;
  for (const char c : kStick + kStickEvents) text += c == '\n' ? "\r\n" : std::string(1, c);
  const Recording recording = good(text);
  ASSERT_EQ(recording.samples.size(), 1U);
  EXPECT_FLOAT_EQ(recording.samples[0].x, 0.5F);
}

TEST(Recording, NoLineFeedAtTheEnd) {
  std::string text = kStick + kStickEvents;
  text.pop_back();
  expect_stick(good(text));
}

TEST(Recording, AbsoluteWithoutDescription_TakesTheObservedRange_AndSaysSo) {
  const Recording recording = good(
      "E: 0.000000 0003 0000 100\nE: 0.000000 0000 0000 0\n"
      "E: 0.100000 0003 0000 300\nE: 0.100000 0003 0001 7\nE: 0.100000 0000 0000 0\n"
      "E: 0.200000 0003 0000 250\nE: 0.200000 0000 0000 0\n");
  EXPECT_EQ(recording.samples[0].x, -1.0F);
  EXPECT_EQ(recording.samples[1].x, 1.0F);
  EXPECT_EQ(recording.samples[2].x, 0.5F);
  EXPECT_EQ(recording.samples[1].y, 0.0F) << "an axis that never moved is centred";
  EXPECT_THAT(recording.note, HasSubstr("taken from the counts"));
}

TEST(Recording, RelativeWins_WhereAMouseHasFingersToo) {
  const Recording recording = good(
      "E: 0.000000 0003 0035 900\nE: 0.000000 0003 0036 900\nE: 0.000000 0002 0000 100\n"
      "E: 0.000000 0000 0000 0\n");
  EXPECT_FLOAT_EQ(recording.samples[0].x, 0.25F);
}

const std::string kPad =
    "# EVEMU 1.3\nN: a pad\nI: 0003 0001 0002 0003\nP: 00 00 00 00 00 00 00 00\n"
    "B: 03 00 00 00 00 00 80 60 02\n"
    "A: 2f 0 9 0 0 0\nA: 35 0 1000 0 0 0\nA: 36 0 1000 0 0 0\nA: 39 0 65535 0 0 0\n";

TEST(Recording, Fingers_TheFirstOneLeads_UntilItIsLifted) {
  const Recording recording =
      good(kPad +
           "E: 0.000000 0003 002f 0009\nE: 0.000000 0003 0039 0040\nE: 0.000000 0003 0035 0750\n"
           "E: 0.000000 0003 0036 0500\nE: 0.000000 0000 0000 0000\n"
           "E: 0.100000 0003 002f 0001\nE: 0.100000 0003 0039 0041\nE: 0.100000 0003 0035 0000\n"
           "E: 0.100000 0000 0000 0000\n"
           "E: 0.200000 0003 002f 0009\nE: 0.200000 0003 0039 -001\nE: 0.200000 0003 002f 0001\n"
           "E: 0.200000 0003 0035 0250\nE: 0.200000 0000 0000 0000\n");
  ASSERT_EQ(recording.samples.size(), 3U);
  EXPECT_FLOAT_EQ(recording.samples[0].x, 0.5F);
  EXPECT_FLOAT_EQ(recording.samples[1].x, 0.5F);
  EXPECT_FLOAT_EQ(recording.samples[2].x, -0.5F);
}

TEST(Recording, FingersInTurn_TheFirstOfEachFrameLeads) {
  const Recording recording =
      good(kPad +
           "E: 0.000000 0003 0035 0750\nE: 0.000000 0000 0002 0\nE: 0.000000 0003 0035 0100\n"
           "E: 0.000000 0000 0002 0\nE: 0.000000 0000 0000 0\n"
           "E: 0.100000 0003 0035 0250\nE: 0.100000 0000 0002 0\nE: 0.100000 0003 0035 0900\n"
           "E: 0.100000 0000 0002 0\nE: 0.100000 0000 0000 0\n");
  ASSERT_EQ(recording.samples.size(), 2U);
  EXPECT_FLOAT_EQ(recording.samples[0].x, 0.5F);
  EXPECT_FLOAT_EQ(recording.samples[1].x, -0.5F);
}

TEST(Recording, Buttons_ComeAsBits_KeysDoNot) {
  const Recording recording = good(
      "E: 0.000000 0002 0000 1\nE: 0.000000 0001 0110 1\nE: 0.000000 0001 001e 1\n"
      "E: 0.000000 0000 0000 0\nE: 0.100000 0001 0111 1\nE: 0.100000 0001 0110 0\n"
      "E: 0.100000 0000 0000 0\n");
  EXPECT_EQ(recording.samples[0].buttons, 1U);
  EXPECT_EQ(recording.samples[1].buttons, 2U);
}

TEST(Recording, DroppedEvents_CostOneSample_AndAreCounted) {
  const Recording recording = good(
      "E: 0.000000 0002 0000 100\nE: 0.000000 0000 0000 0\n"
      "E: 0.100000 0002 0000 100\nE: 0.100000 0000 0003 0\nE: 0.110000 0002 0000 100\n"
      "E: 0.110000 0000 0000 0\nE: 0.200000 0002 0000 100\nE: 0.200000 0000 0000 0\n");
  ASSERT_EQ(recording.samples.size(), 2U);
  EXPECT_FLOAT_EQ(recording.samples[1].x, 0.5F);
  EXPECT_EQ(recording.losses, 1U);
}

TEST(Recording, BackwardTime_IsKept_TheDurationIsThatOfTheLatest) {
  const Recording recording = good(
      "E: 10.000000 0002 0000 1\nE: 10.000000 0000 0000 0\nE: 12.000000 0000 0000 0\n"
      "E: 9.000000 0000 0000 0\n");
  ASSERT_EQ(recording.samples.size(), 3U);
  EXPECT_EQ(elapsed_us(0, recording.samples[2].time), -1000000);
  EXPECT_DOUBLE_EQ(recording.duration, 2.0);
}

TEST(Recording, MalformedLine_IsReportedWithItsNumber) {
  EXPECT_THAT(parse("# one\n\nE: 1.000000 0002 0000 x\n").error, HasSubstr("test:3: "));
  EXPECT_THAT(parse("garbage").error, HasSubstr("test:1: "));
  EXPECT_THAT(parse("E: 1.000000 0002 0000 1\nE: 1.000000 0000 0000 0\nE: 1.0").error,
              HasSubstr("test:3: "));
}

TEST(Recording, Messages_AreOneShortLine_WithoutControlCharacters) {
  const std::string error = parse("\x1b[31m" + std::string(100000, 'x') + "\x07\r").error;
  EXPECT_LT(error.size(), 200U);
  for (const char c : error) EXPECT_GE(c, ' ');
}

TEST(Recording, TimeLeaps_AreRefused) {
  const std::string start = "E: 1.000000 0002 0000 1\nE: 1.000000 0000 0000 0\n";
  EXPECT_EQ(parse(start + "E: 1800.000000 0000 0000 0\n").error, "");
  EXPECT_THAT(parse(start + "E: 1900.000000 0000 0000 0\n").error, HasSubstr("test:3: "));
  EXPECT_THAT(parse("E: 9999.000000 0002 0000 1\nE: 0.000000 0000 0000 0\n").error,
              HasSubstr("leaps"));
}

TEST(Recording, NothingToPlay_IsAnError) {
  EXPECT_THAT(parse("").error, HasSubstr("no events"));
  EXPECT_THAT(parse("# only a comment\n").error, HasSubstr("no events"));
  EXPECT_THAT(parse(kStick).error, HasSubstr("no events"));
  EXPECT_THAT(parse("E: 0.000000 0001 001e 1\nE: 0.000000 0000 0000 0\n").error,
              HasSubstr("no motion"));
  EXPECT_THAT(parse("E: 0.000000 0002 0000 1\n").error, HasSubstr("no sync mark"));
}

TEST(Recording, BrokenDescription_IsAnError) {
  EXPECT_THAT(parse("N: x\nI: y\n" + kStickEvents).error, HasSubstr("description"));
}

TEST(LoadRecording, DescriptionBesideTheFile_IsFound) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / "batuta_recording_test";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "stick.circle.events") << kStickEvents;
  std::ofstream(folder / "stick.desc") << kStick;
  const LoadedRecording loaded = load_recording((folder / "stick.circle.events").string());
  EXPECT_EQ(loaded.error, "");
  expect_stick(loaded.recording);
  EXPECT_THAT(load_recording((folder / "none.events").string()).error, HasSubstr("no such file"));
  EXPECT_THAT(load_recording(folder.string()).error, HasSubstr("cannot be read"));
  std::filesystem::remove_all(folder);
}

/// A folder with a recording, and with what stands beside it.
class Beside : public testing::Test {
 protected:
  Beside() {
    std::string name = testing::TempDir() + "batuta_beside_XXXXXX";
    folder_ = ::mkdtemp(name.data());
    recording_ = folder_ / "stick.events";
    description_ = folder_ / "stick.desc";
    std::ofstream(recording_) << kStickEvents;
  }
  ~Beside() override { std::filesystem::remove_all(folder_); }

  /// The message names the file, and says `why`.
  void expect_refused(const std::filesystem::path& file, const std::string& why) const {
    EXPECT_EQ(load_recording(recording_.string()).error,
              file.string() + ": cannot be read: " + why);
  }

  std::filesystem::path folder_;
  std::filesystem::path recording_;
  std::filesystem::path description_;
};

TEST_F(Beside, ADescriptionThatIsNoPlainFile_IsToldAndNotWaitedFor) {
  ASSERT_EQ(::mkfifo(description_.c_str(), 0600), 0);
  expect_refused(description_, "no plain file");
  std::filesystem::remove(description_);
  std::filesystem::create_symlink("/dev/zero", description_);
  expect_refused(description_, "no plain file");
  std::filesystem::remove(description_);
  std::filesystem::create_directory(description_);
  expect_refused(description_, "no plain file");
}

TEST_F(Beside, ADescriptionThatCannotBeRead_IsTold) {
  std::filesystem::create_symlink(description_.filename(), description_);
  expect_refused(description_, "Too many levels of symbolic links");
  std::filesystem::remove(description_);
  std::filesystem::create_symlink("/proc/self/mem", description_);
  expect_refused(description_, "Input/output error");
  std::filesystem::remove(description_);
  std::ofstream(description_) << kStick;
  std::filesystem::permissions(description_, std::filesystem::perms::none);
  if (::geteuid() != 0) expect_refused(description_, "Permission denied");
}

TEST_F(Beside, ADescriptionWithoutAnEnd_IsTold) {
  std::ofstream(description_) << kStick;
  std::filesystem::resize_file(description_, std::uintmax_t{1} << 40);  // of nothing but holes
  expect_refused(description_, "too long");
}

TEST_F(Beside, WhereTheRecordingHasItsOwn_ItDoesNotMatter) {
  std::filesystem::create_directory(description_);
  std::ofstream(recording_) << kStick + kStickEvents;
  const LoadedRecording loaded = load_recording(recording_.string());
  EXPECT_EQ(loaded.error, "");
  expect_stick(loaded.recording);
}

TEST_F(Beside, ARecordingThatCannotBeRead_IsToldWithItsPath) {
  std::filesystem::remove(recording_);
  std::filesystem::create_symlink("/proc/self/mem", recording_);
  expect_refused(recording_, "Input/output error");
  std::filesystem::remove(recording_);
  std::filesystem::create_symlink(recording_.filename(), recording_);
  expect_refused(recording_, "Too many levels of symbolic links");
  std::filesystem::remove(recording_);
  std::ofstream(recording_).close();
  std::filesystem::resize_file(recording_, std::uintmax_t{1} << 40);
  expect_refused(recording_, "too long");
}

/// As "<(zcat recording.events.gz)" of a shell.
TEST_F(Beside, ARecordingMayComeThroughAPipe) {
  std::filesystem::remove(recording_);
  ASSERT_EQ(::mkfifo(recording_.c_str(), 0600), 0);
  std::thread writer([this] { std::ofstream(recording_) << kStick + kStickEvents; });
  const LoadedRecording loaded = load_recording(recording_.string());
  writer.join();
  EXPECT_EQ(loaded.error, "");
  expect_stick(loaded.recording);
}

struct Expected {
  const char* file;
  std::size_t samples;
  double duration;
};

/// Counts and durations: those of the sync marks and time stamps in the files, by grep and head.
TEST(LoadRecording, RealDevices) {
  const std::string folder = BATUTA_SHARED_DIR "/recordings/";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no " << folder;
  for (const Expected& expected :
       {Expected{"ps2_mouse.events", 2707, 52.984}, Expected{"trackpoint.events", 964, 21.618}}) {
    const LoadedRecording loaded = load_recording(folder + expected.file);
    EXPECT_EQ(loaded.error, "");
    EXPECT_EQ(loaded.recording.samples.size(), expected.samples);
    EXPECT_NEAR(loaded.recording.duration, expected.duration, 1e-3);
    EXPECT_NE(loaded.recording.device, "");
  }
  const LoadedRecording pad = load_recording(folder + "madcatz_pad.events");
  EXPECT_EQ(pad.error, "");
  EXPECT_EQ(pad.recording.note, "");
  for (const InputSample& sample : pad.recording.samples) {
    EXPECT_LT(std::fabs(sample.x), 0.05F) << "a stick at rest";
    EXPECT_LT(std::fabs(sample.y), 0.05F);
  }
}

}  // namespace
}  // namespace batuta::host
