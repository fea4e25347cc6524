// SPDX-License-Identifier: MIT
#include "../input.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <memory>
#include <string>
#include <vector>

namespace batuta::digest {
namespace {

using WordList = std::vector<std::uint32_t>;

/// A file of words, and a reader of it.
class DigestInput : public testing::Test {
 protected:
  bool open(const WordList& words, std::size_t cut_bytes = 0) {
    const std::string path = testing::TempDir() + "digest_input_test.bin";
    std::ofstream file(path, std::ios::binary);
    for (const std::uint32_t word : words) {
      for (unsigned shift = 0; shift < 32; shift += 8)
        file.put(static_cast<char>(word >> shift & 255U));
    }
    file.close();
    if (cut_bytes > 0) cut(path, words.size() * 4 - cut_bytes);
    return input_->open(path.c_str());
  }
  void TearDown() override { input_->close(); }

  Input& input() { return *input_; }

 private:
  static void cut(const std::string& path, std::size_t length) {
    std::ifstream in(path, std::ios::binary);
    std::string content(length, '\0');
    in.read(content.data(), static_cast<std::streamsize>(length));
    std::ofstream(path, std::ios::binary | std::ios::trunc) << content;
  }

  std::unique_ptr<Input> input_ = std::make_unique<Input>();
};

const WordList kTwoChunks = {kMagic, 2, 3, 2, 0, 10, 11, 20, 21, 30, 31, 4, 1, 1, 77, 0x3f800000};

TEST_F(DigestInput, Chunks_AreReadRecordByRecord) {
  ASSERT_TRUE(open(kTwoChunks));
  ChunkHead head;
  Record record;
  ASSERT_TRUE(input().next(head));
  EXPECT_EQ(head.chunk, 2U);
  for (const std::uint32_t first : {10U, 20U, 30U}) {
    ASSERT_TRUE(input().next(record));
    EXPECT_EQ(record.word(), first);
    EXPECT_EQ(record.word(), first + 1);
  }
  EXPECT_FALSE(input().next(record));
  ASSERT_TRUE(input().next(head));
  EXPECT_EQ(head.parameter, 77U);
  ASSERT_TRUE(input().next(record));
  EXPECT_EQ(record.number(), 1.0F);
  EXPECT_FALSE(input().next(head));
  EXPECT_TRUE(input().ok());
}

TEST_F(DigestInput, WhatIsLeftOfAChunk_IsPassedOver) {
  ASSERT_TRUE(open(kTwoChunks));
  ChunkHead head;
  Record record;
  ASSERT_TRUE(input().next(head));
  ASSERT_TRUE(input().next(record));
  ASSERT_TRUE(input().next(head));
  EXPECT_EQ(head.chunk, 4U);
}

TEST_F(DigestInput, AFileCutOff_IsNotOk) {
  for (const std::size_t cut : {1U, 4U, 5U, 16U, 30U}) {
    ASSERT_TRUE(open(kTwoChunks, cut));
    ChunkHead head;
    while (input().next(head)) continue;
    EXPECT_FALSE(input().ok()) << cut;
    TearDown();
  }
}

TEST_F(DigestInput, RecordsTooLong_AreRefused) {
  ASSERT_TRUE(open({kMagic, 1, 1, kMostWords + 1, 0}));
  ChunkHead head;
  EXPECT_FALSE(input().next(head));
  EXPECT_FALSE(input().ok());
}

TEST_F(DigestInput, AnotherFile_IsRefused) {
  EXPECT_FALSE(open({0x12345678}));
  EXPECT_FALSE(open({}));
}

TEST_F(DigestInput, NoFile_IsRefused) {
  EXPECT_FALSE(input().open("/there/is/no/such/file"));
}

}  // namespace
}  // namespace batuta::digest
