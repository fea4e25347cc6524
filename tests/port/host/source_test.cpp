// SPDX-License-Identifier: MIT
#include "programs/devices/source.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace batuta::host {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(OpenSource, Default_IsTheEmbeddedRecording_AndSaysThatItIsSynthetic) {
  const OpenedSource opened = open_source("default");
  ASSERT_TRUE(opened.source) << opened.error;
  EXPECT_EQ(opened.note, "");
  EXPECT_THAT(opened.source->description(), HasSubstr("synthetic"));
  EXPECT_GE(opened.source->duration(), 10.0);
  EXPECT_LE(opened.source->duration(), 20.0);
}

TEST(OpenSource, Scripts) {
  for (const char* words : {"script:guard", "script:parry", "script:attack", "script:novice",
                            "script:club", "script:master", "script:club@4294967295"}) {
    EXPECT_TRUE(open_source(words).source) << words;
  }
}

TEST(OpenSource, Refusals_AreOneLineThatNamesTheSource) {
  for (const char* words : {"script:",
                            "script:riposte",
                            "script:club@",
                            "script:club@-1",
                            "script:club@4294967296",
                            "script:guard@1",
                            "banana",
                            "none.events",
                            "device:/none",
                            "device:",
                            "serial:",
                            "serial:,script:guard",
                            "serial:/dev/a,serial:/dev/b",
                            "serial:@3000000",
                            "serial:/dev/a@",
                            "serial:/dev/a@fast",
                            "serial:/dev/a@0",
                            "serial:/dev/a@-9600",
                            "serial:/dev/a@+9600",
                            "serial:/dev/a@9600 ",
                            "serial:/dev/a@1e6",
                            "serial:/dev/a@99999999999,script:guard",
                            "",
                            "/",
                            "carrier:pigeon"}) {
    const OpenedSource opened = open_source(words);
    EXPECT_FALSE(opened.source) << words;
    EXPECT_THAT(opened.error, HasSubstr(words));
    EXPECT_THAT(opened.error, Not(HasSubstr("\n")));
    EXPECT_FALSE(opened.error.empty());
  }
  EXPECT_THAT(open_source("banana").error, HasSubstr("unknown source"));
  EXPECT_THAT(open_source("none.events").error, HasSubstr("no such file"));
  EXPECT_THAT(open_source("device:/none").error, HasSubstr("no such device; found: "));
}

TEST(OpenSource, ASerialLine_IsNamed_AndTheDevicesOwnStickStandsForTheSource) {
  const OpenedSource opened = open_source("serial:/dev/ttyUSB0");
  ASSERT_TRUE(opened.source) << opened.error;
  EXPECT_EQ(opened.line, "/dev/ttyUSB0");
  EXPECT_TRUE(opened.own_stick);
  EXPECT_THAT(opened.source->description(), HasSubstr("/dev/ttyUSB0"));
  InputSample sample;
  EXPECT_EQ(opened.source->read(0, sample), Status::kUnavailable) << "nobody has told it anything";
}

TEST(OpenSource, ASerialLineWithASource_IsThatSource) {
  const OpenedSource opened = open_source("serial:/dev/ttyUSB0,script:attack");
  ASSERT_TRUE(opened.source) << opened.error;
  EXPECT_EQ(opened.line, "/dev/ttyUSB0");
  EXPECT_FALSE(opened.own_stick);
  EXPECT_EQ(opened.source->description(), open_source("script:attack").source->description());
  EXPECT_THAT(open_source("serial:/dev/ttyUSB0,banana").error, HasSubstr("unknown source"));
  EXPECT_TRUE(open_source("script:attack").line.empty());
}

TEST(OpenSource, ASerialLine_HasTheRateOfItsWords_OrTheBoards) {
  EXPECT_EQ(open_source("serial:/dev/ttyUSB0").baud, 3000000);
  EXPECT_EQ(open_source("serial:/dev/ttyUSB0,script:attack").baud, 3000000);
  for (const char* words : {"serial:/dev/by@id@115200", "serial:/dev/by@id@115200,script:attack"}) {
    const OpenedSource opened = open_source(words);
    ASSERT_TRUE(opened.source) << opened.error;
    EXPECT_EQ(opened.line, "/dev/by@id");
    EXPECT_EQ(opened.baud, 115200);
  }
  EXPECT_THAT(open_source("serial:/dev/a@fast").error, HasSubstr("BAUD is a number"));
}

/// In the system's words: it is not known whether the file is there.
TEST(OpenSource, WhatMayNotBeLookedAt_IsNotToldToBeMissing) {
  const std::filesystem::path folder = testing::TempDir() + "batuta_closed_folder";
  std::filesystem::create_directories(folder);
  const std::filesystem::path round = folder / "round.events";
  std::filesystem::remove(round);
  std::filesystem::create_symlink(round.filename(), round);
  EXPECT_EQ(open_source(round.string()).error,
            round.string() + ": cannot be read: Too many levels of symbolic links");
  std::filesystem::permissions(folder, std::filesystem::perms::none);
  const std::string closed = (folder / "stick.events").string();
  const bool may_look = ::geteuid() == 0;
  EXPECT_EQ(open_source(closed).error,
            closed + (may_look ? ": no such file" : ": cannot be read: Permission denied"));
  std::filesystem::permissions(folder, std::filesystem::perms::owner_all);
  std::filesystem::remove_all(folder);
}

TEST(OpenSource, GuessedCalibration_IsNoted) {
  const auto path = std::filesystem::temp_directory_path() / "batuta_source_test.evemu";
  std::ofstream(path) << "E: 0.000000 0003 0000 1\nE: 0.000000 0000 0000 0\n"
                         "E: 0.100000 0003 0000 9\nE: 0.100000 0000 0000 0\n";
  const OpenedSource opened = open_source(path.string());
  ASSERT_TRUE(opened.source) << opened.error;
  EXPECT_THAT(opened.note, HasSubstr("batuta_source_test.evemu: "));
  EXPECT_EQ(opened.source->losses(), 0U);
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace batuta::host
