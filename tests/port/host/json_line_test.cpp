// SPDX-License-Identifier: MIT
#include "programs/duel/json_line.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "programs/duel/utf8.hpp"

namespace batuta::host {
namespace {

/// What `write` writes.
template <class Write>
std::string written(const Write& write) {
  char* text = nullptr;
  std::size_t size = 0;
  std::FILE* file = open_memstream(&text, &size);
  write(file);
  std::fclose(file);
  std::string result(text, size);
  std::free(text);
  return result;
}

std::string line_with_text(std::string_view words) {
  return written([&](std::FILE* file) { JsonLine(file, "t").text("k", words); });
}

TEST(JsonLine, MembersOfAllKinds) {
  EXPECT_EQ(written([](std::FILE* file) {
              JsonLine(file, "touch")
                  .text("by", "left")
                  .number("time", 0.25)
                  .count("n", 18446744073709551615ULL)
                  .flag("yes", true)
                  .flag("no", false)
                  .vector("p", {1, -2, 0.5F});
            }),
            "{\"type\":\"touch\",\"by\":\"left\",\"time\":0.25,\"n\":18446744073709551615,"
            "\"yes\":true,\"no\":false,\"p\":[1.0,-2.0,0.5]}\n");
}

TEST(JsonLine, TextIsEscaped) {
  EXPECT_EQ(line_with_text("a\"b\\c\n\t\x01"),
            "{\"type\":\"t\",\"k\":\"a\\\"b\\\\c\\n\\t\\u0001\"}\n");
}

TEST(JsonLine, TextIsValidUtf8_WhateverTheNameOfADeviceIs) {
  EXPECT_EQ(line_with_text("\xC3\xBC\xE2\x82\xAC\xF0\x9F\xA4\xBA"),
            "{\"type\":\"t\",\"k\":\"\xC3\xBC\xE2\x82\xAC\xF0\x9F\xA4\xBA\"}\n");
  EXPECT_EQ(line_with_text("a\xFFz\xC3"),
            "{\"type\":\"t\",\"k\":\"a\xEF\xBF\xBDz\xEF\xBF\xBD\"}\n");
}

TEST(JsonLine, NumbersHaveTheDigitsOfAFloat) {
  EXPECT_EQ(written([](std::FILE* file) {
              JsonLine(file, "t").number("k", static_cast<double>(0.1F)).number("l", 1.0 / 3);
            }),
            "{\"type\":\"t\",\"k\":0.100000001,\"l\":0.333333333}\n");
}

TEST(JsonLine, NumbersThatJsonDoesNotKnow_AreNull) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double value : {infinity, -infinity, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_EQ(written([&](std::FILE* file) { JsonLine(file, "t").number("k", value); }),
              "{\"type\":\"t\",\"k\":null}\n");
  }
}

TEST(Utf8, OnlyTheShortestFormOfARealCodePoint) {
  EXPECT_EQ(utf8_length("a"), 1U);
  EXPECT_EQ(utf8_length("\xC2\x80"), 2U);
  EXPECT_EQ(utf8_length("\xE0\xA0\x80"), 3U);
  EXPECT_EQ(utf8_length("\xED\x9F\xBF"), 3U);
  EXPECT_EQ(utf8_length("\xF0\x90\x80\x80"), 4U);
  EXPECT_EQ(utf8_length("\xF4\x8F\xBF\xBF"), 4U);
  for (const char* bad :
       {"\x80", "\xC1\x80", "\xC2", "\xC2\x41", "\xE0\x9F\x80", "\xED\xA0\x80", "\xE2\x82",
        "\xF0\x8F\x80\x80", "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\xF0\x9F\xA4"}) {
    EXPECT_EQ(utf8_length(bad), 0U);
  }
}

}  // namespace
}  // namespace batuta::host
