// SPDX-License-Identifier: MIT
#include "../options.hpp"

#include <gtest/gtest.h>

#include <initializer_list>
#include <string>

namespace batuta::digest {
namespace {

bool read(std::initializer_list<const char*> words, Options& options) {
  Words line;
  for (const char* word : words) {
    line.word[static_cast<std::size_t>(line.count)] = word;
    ++line.count;
  }
  return read_options(line, options);
}

TEST(DigestOptions, None_MeansAll) {
  Options options;
  ASSERT_TRUE(read({}, options));
  EXPECT_EQ(options.every, 1U);
  for (std::size_t i = 0; i < kSections; ++i) EXPECT_TRUE(options.takes(static_cast<Section>(i)));
  EXPECT_FALSE(options.shown.any);
  EXPECT_FALSE(options.doctored.any);
}

TEST(DigestOptions, All_AreRead) {
  Options options;
  ASSERT_TRUE(read({"--in", "a", "--hashes", "b", "--every", "50", "--only", "flight", "--doctor",
                    "impulse", "12"},
                   options));
  EXPECT_EQ(std::string(options.in), "a");
  EXPECT_EQ(std::string(options.hashes), "b");
  EXPECT_EQ(options.every, 50U);
  EXPECT_TRUE(options.takes(Section::kFlight));
  EXPECT_FALSE(options.takes(Section::kToc));
  EXPECT_TRUE(options.doctored.is(Section::kImpulse, 12));
  EXPECT_FALSE(options.doctored.is(Section::kImpulse, 13));
  EXPECT_FALSE(options.doctored.is(Section::kToc, 12));
}

TEST(DigestOptions, Show_TakesItsSectionOnly) {
  Options options;
  ASSERT_TRUE(read({"--show", "duel", "33554777"}, options));
  EXPECT_TRUE(options.shown.is(Section::kDuel, 33554777));
  EXPECT_TRUE(options.takes(Section::kDuel));
  EXPECT_FALSE(options.takes(Section::kToc));
}

TEST(DigestOptions, Nonsense_IsRefused) {
  Options options;
  EXPECT_FALSE(read({"--in"}, options));
  EXPECT_FALSE(read({"--every", "0"}, options));
  EXPECT_FALSE(read({"--every", "-1"}, options));
  EXPECT_FALSE(read({"--every", "5x"}, options));
  EXPECT_FALSE(read({"--every", ""}, options));
  EXPECT_FALSE(read({"--every", "1234567890"}, options));
  EXPECT_FALSE(read({"--only", "everything"}, options));
  EXPECT_FALSE(read({"--show", "toc"}, options));
  EXPECT_FALSE(read({"what"}, options));
}

}  // namespace
}  // namespace batuta::digest
