// SPDX-License-Identifier: MIT
#include "options.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace batuta::report {
namespace {

const About kAbout{"sample", "What it does.", "2 minutes"};

Options parsed(std::vector<const char*> words) {
  words.insert(words.begin(), "program");
  return parse(static_cast<int>(words.size()), words.data(), kAbout);
}

TEST(Options, None_AreTheWholeInQuickMode) {
  const Options options = parsed({});
  EXPECT_EQ(options.mode, Mode::kQuick);
  EXPECT_EQ(options.shards, 1U);
  EXPECT_EQ(options.out, ".");
}

TEST(Options, All_AreRead) {
  const Options options = parsed({"--shard", "2/7", "--out", "folder", "--mode", "full"});
  EXPECT_EQ(options.mode, Mode::kFull);
  EXPECT_EQ(options.shard, 2U);
  EXPECT_EQ(options.shards, 7U);
  EXPECT_EQ(options.out, "folder");
}

TEST(OptionsDeathTest, BadUse_ExitsWithTwoAndASentence) {
  const auto refused = testing::ExitedWithCode(2);
  EXPECT_EXIT(parsed({"--mode", "slow"}), refused, "tiny, quick or full");
  EXPECT_EXIT(parsed({"--mode"}), refused, "lacks its value");
  EXPECT_EXIT(parsed({"--speed", "1"}), refused, "not known");
  for (const char* shard : {"0/3", "4/3", "1", "1/", "/3", "a/b", "-1/3", "1/99999999", "1/2/3"}) {
    EXPECT_EXIT(parsed({"--shard", shard}), refused, "1 <= I <= N") << shard;
  }
}

TEST(OptionsDeathTest, Help_ExitsWithZero) {
  EXPECT_EXIT(parsed({"--help"}), testing::ExitedWithCode(0), "");
}

TEST(Options, Help_NamesFilesAndOwnOptions) {
  const auto help = [](const About& about) {
    testing::internal::CaptureStdout();
    print_help(about);
    return testing::internal::GetCapturedStdout();
  };
  EXPECT_NE(help(kAbout).find("folder of sample.csv ("), std::string::npos);
  const std::string other = help({"sample", "", "", "a.csv and b.csv", "  --more\n"});
  EXPECT_NE(other.find("folder of a.csv and b.csv ("), std::string::npos);
  EXPECT_NE(other.find("\n  --more\n"), std::string::npos);
}

TEST(Share, Parts_AreTheWholeInOrder) {
  for (const std::uint64_t count : {0U, 1U, 2U, 5U, 100U, 1001U}) {
    for (const std::uint64_t shards : {1U, 2U, 3U, 7U}) {
      Options options;
      options.shards = shards;
      std::uint64_t next = 0;
      for (options.shard = 1; options.shard <= shards; ++options.shard) {
        const Range range = share_of(options, count);
        EXPECT_EQ(range.first, next);
        EXPECT_LE(range.last - range.first, count / shards + 1);
        next = range.last;
      }
      EXPECT_EQ(next, count);
    }
  }
}

}  // namespace
}  // namespace batuta::report
