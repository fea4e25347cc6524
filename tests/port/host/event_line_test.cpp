// SPDX-License-Identifier: MIT
#include "programs/devices/event_line.hpp"

#include <evemu.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "programs/devices/default_recording.hpp"

namespace batuta::host {
namespace {

DeviceEvent event_of(std::string_view line) {
  DeviceEvent event;
  EXPECT_EQ(read_line(line, event), LineKind::kEvent) << line;
  return event;
}

LineKind kind_of(std::string_view line) {
  DeviceEvent event;
  return read_line(line, event);
}

TEST(EventLine, OldFormat) {
  const DeviceEvent event = event_of("E: 1329846856.201613 0002 0001 -12");
  EXPECT_EQ(event.time_us, 1329846856201613);
  EXPECT_EQ(event.type, 2);
  EXPECT_EQ(event.code, 1);
  EXPECT_EQ(event.value, -12);
}

TEST(EventLine, NewFormat_LeadingZerosAreDecimal_CommentIsIgnored) {
  const DeviceEvent event = event_of("E: 0.000001 0003 002f 0010\t# EV_ABS / ABS_MT_SLOT   10");
  EXPECT_EQ(event.time_us, 1);
  EXPECT_EQ(event.type, 3);
  EXPECT_EQ(event.code, 0x2f);
  EXPECT_EQ(event.value, 10);
  EXPECT_EQ(event_of("E: 0.000001 0003 0036 -034\t# x").value, -34);
}

TEST(EventLine, CarriageReturnAndBlanksDoNotMatter) {
  EXPECT_EQ(event_of("E: 1.000000 0002 0001 5\r").value, 5);
  EXPECT_EQ(event_of("E:\t1.000000   0002 0001\t5 \r").value, 5);
  EXPECT_EQ(kind_of("\r"), LineKind::kNothing);
  EXPECT_EQ(kind_of(""), LineKind::kNothing);
  EXPECT_EQ(kind_of("  # a comment"), LineKind::kNothing);
}

TEST(EventLine, ValueUsesAll32Bits_AndNoMore) {
  EXPECT_EQ(event_of("E: 0.000000 0003 0000 2147483647").value, 2147483647);
  EXPECT_EQ(event_of("E: 0.000000 0003 0000 -2147483648").value, -2147483647 - 1);
  EXPECT_EQ(kind_of("E: 0.000000 0003 0000 2147483648"), LineKind::kMalformed);
  EXPECT_EQ(kind_of("E: 0.000000 0003 0000 -2147483649"), LineKind::kMalformed);
}

TEST(EventLine, Malformed) {
  for (const char* line : {"E:",
                           "E: ",
                           "E: x",
                           "E: 1.000000",
                           "E: 1.000000 0002",
                           "E: 1.000000 0002 0001",
                           "E: 1.000000 0002 0001 x",
                           "E: 1.000000 0002 0001 12abc",
                           "E: 1.000000 0002 0001 1 2",
                           "E: 1.5 0002 0001 1",
                           "E: 1 0002 0001 1",
                           "E: .000000 0002 0001 1",
                           "E: 1.0000000 0002 0001 1",
                           "E: -1.000000 0002 0001 1",
                           "E: 1.-00001 0002 0001 1",
                           "E: 99999999999999999999.000000 0002 0001 1",
                           "E: 1000000000001.000000 0002 0001 1",
                           "E: 1.000000 10000 0001 1",
                           "E: 1.000000 0002 00zz 1",
                           "E: 1.000000 -002 0001 1",
                           "E: 1.000000 0002 0001 1.5",
                           "E: nan 0002 0001 1",
                           "E 1.000000 0002 0001 1",
                           "hello",
                           "Z: 1",
                           "e: 1.000000 0002 0001 1",
                           "\x7f\x45\x4c\x46"}) {
    DeviceEvent event;
    event.value = 77;
    EXPECT_EQ(read_line(line, event), LineKind::kMalformed) << line;
    EXPECT_EQ(event.value, 77) << line;
  }
  EXPECT_EQ(kind_of(std::string_view("E: 1.000000 0002\0 0001 1", 24)), LineKind::kMalformed);
}

TEST(EventLine, DescriptionLines) {
  for (const char* line : {"N: a mouse", "I: 0003 0001 0001 0001", "P: 00", "B: 00 01", "A: 00 0 1",
                           "L: 00 0", "S: 00 0"}) {
    EXPECT_EQ(kind_of(line), LineKind::kDescription) << line;
  }
}

TEST(EventLine, AxisBeyond32Bits_IsMalformed) {
  EXPECT_EQ(kind_of("A: 00 -2147483648 2147483647 0 0 0"), LineKind::kDescription);
  EXPECT_EQ(kind_of("A: 00 0 255 0 15 # 99999999999"), LineKind::kDescription);
  for (const char* line : {"A: 00 0 2147483648 0 15", "A: 3f -2147483649 255 0 15",
                           "A: 00 0 255 0 15 99999999999999999999"}) {
    EXPECT_EQ(kind_of(line), LineKind::kMalformed) << line;
  }
}

/// Reads every line with libevemu as well. @returns how many events there were
int compare_all(std::istream& lines) {
  int compared = 0;
  for (std::string line; std::getline(lines, line);) {
    DeviceEvent event;
    if (read_line(line, event) != LineKind::kEvent) continue;
    std::FILE* memory = fmemopen(line.data(), line.size(), "r");
    input_event theirs{};
    EXPECT_EQ(evemu_read_event(memory, &theirs), 1) << line;
    std::fclose(memory);
    EXPECT_EQ(event.time_us, theirs.input_event_sec * 1'000'000 + theirs.input_event_usec);
    EXPECT_EQ(event.type, theirs.type);
    EXPECT_EQ(event.code, theirs.code);
    EXPECT_EQ(event.value, theirs.value);
    ++compared;
  }
  return compared;
}

TEST(EventLine, AgreesWithLibevemu_OnAllRecordings) {
  std::istringstream own{std::string(kDefaultRecording)};
  EXPECT_GT(compare_all(own), 8000);
  const std::filesystem::path folder = BATUTA_SHARED_DIR "/recordings";
  if (!std::filesystem::exists(folder)) {
    std::printf("only the default recording: there is no %s\n", folder.c_str());
    return;
  }
  int compared = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".events") continue;
    std::ifstream file(entry.path());
    compared += compare_all(file);
  }
  EXPECT_GT(compared, 1000);
}

}  // namespace
}  // namespace batuta::host
