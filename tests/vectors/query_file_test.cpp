// SPDX-License-Identifier: MIT
#include "programs/query_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>

namespace batuta::host {
namespace {

using testing::HasSubstr;

TEST(FloatOfBits, KnownPatterns_AreExact) {
  EXPECT_EQ(float_of_bits("3f8"), 1.0F);
  EXPECT_EQ(float_of_bits("3F800000"), 1.0F);
  EXPECT_EQ(float_of_bits("3dcccccd"), 0.1F);
  EXPECT_EQ(float_of_bits("c00e"), -2.21875F);
  EXPECT_EQ(float_of_bits("0"), 0.0F);
  EXPECT_EQ(float_of_bits("00000001"), std::numeric_limits<float>::denorm_min());
  EXPECT_EQ(float_of_bits("7f8"), std::numeric_limits<float>::infinity());
  EXPECT_TRUE(std::signbit(float_of_bits("8").value()));
  EXPECT_TRUE(std::isnan(float_of_bits("7fc").value()));
}

TEST(FloatOfBits, Malformed_IsNothing) {
  for (const char* text : {"", " 3f8", "3f8 ", "3f8000000", "0x3f8", "-3f8", "+1", "g", "3f.8"}) {
    EXPECT_FALSE(float_of_bits(text)) << '"' << text << '"';
  }
}

TEST(DoubleOfDecimal, Numbers_AreRoundedCorrectly) {
  EXPECT_EQ(double_of_decimal("0.86219338273881418"), 0.86219338273881418);
  EXPECT_EQ(double_of_decimal("-8e-09"), -8e-09);
  EXPECT_EQ(double_of_decimal("inf"), std::numeric_limits<double>::infinity());
}

TEST(DoubleOfDecimal, Malformed_IsNothing) {
  for (const char* text : {"", "x", "1x", "1,0", " 1", "1e999", "0x10"}) {
    EXPECT_FALSE(double_of_decimal(text)) << '"' << text << '"';
  }
}

TEST(QueryFile, GoodRows_AreReadByColumnName) {
  std::istringstream in("family,x,d\nfirst,3f8,0.5\nsecond,4,2\n");
  QueryFile file(in);
  ASSERT_TRUE(file.ok()) << file.error();
  EXPECT_TRUE(file.has("d"));
  EXPECT_FALSE(file.has("D"));
  QueryRow row;
  ASSERT_TRUE(file.next(row));
  EXPECT_EQ(row.line(), 1);
  EXPECT_EQ(row.text("family"), "first");
  EXPECT_EQ(row.bits("x"), 1.0F);
  EXPECT_EQ(row.decimal("d"), 0.5);
  ASSERT_TRUE(file.next(row));
  EXPECT_EQ(row.line(), 2);
  EXPECT_EQ(row.decimal("d"), 2);
  EXPECT_TRUE(row.ok());
  EXPECT_FALSE(file.next(row));
}

TEST(QueryFile, WindowsLineEndsByteOrderMarkAndNoFinalNewline_AreRead) {
  std::istringstream in("\xEF\xBB\xBFx,y\r\n3f8,4\r\n4,3f8");
  QueryFile file(in);
  QueryRow row;
  ASSERT_TRUE(file.next(row));
  EXPECT_EQ(row.bits("y"), 2.0F);
  ASSERT_TRUE(file.next(row));
  EXPECT_EQ(row.bits("x"), 2.0F);
  EXPECT_EQ(row.bits("y"), 1.0F);
  EXPECT_TRUE(row.ok()) << row.error();
}

TEST(QueryFile, MalformedField_IsReportedWithLineAndColumnAndTheNextRowIsRead) {
  std::istringstream in("x,y\n3f8,oops\n3f8,3f8\n");
  QueryFile file(in);
  QueryRow row;
  ASSERT_TRUE(file.next(row));
  EXPECT_EQ(row.bits("x"), 1.0F);
  EXPECT_EQ(row.bits("y"), 0.0F);
  EXPECT_THAT(row.error(), HasSubstr("line 1, column y"));
  ASSERT_TRUE(file.next(row));
  EXPECT_EQ(row.bits("y"), 1.0F);
  EXPECT_TRUE(row.ok());
}

TEST(QueryFile, FirstErrorOfARow_IsKept) {
  std::istringstream in("x,y\na,b,\nq,r\n");
  QueryFile file(in);
  QueryRow row;
  ASSERT_TRUE(file.next(row));
  EXPECT_THAT(row.error(), HasSubstr("line 1: expected 2 fields, found 3"));
  ASSERT_TRUE(file.next(row));
  row.decimal("y");
  row.bits("x");
  row.bits("missing");
  EXPECT_THAT(row.error(), HasSubstr("line 2, column y"));
}

TEST(QueryFile, TooFewFieldsOrAnEmptyLine_IsABadRow) {
  std::istringstream in("x,y\n3f8\n\n3f8,3f8\n");
  QueryFile file(in);
  QueryRow row;
  ASSERT_TRUE(file.next(row));
  EXPECT_FALSE(row.ok());
  ASSERT_TRUE(file.next(row));
  EXPECT_THAT(row.error(), HasSubstr("line 2"));
  EXPECT_EQ(row.text("x"), "");
  ASSERT_TRUE(file.next(row));
  EXPECT_TRUE(row.ok());
  EXPECT_EQ(row.line(), 3);
}

TEST(QueryFile, MissingColumn_IsReported) {
  std::istringstream in("x\n3f8\n");
  QueryFile file(in);
  QueryRow row;
  ASSERT_TRUE(file.next(row));
  EXPECT_EQ(row.bits("z"), 0.0F);
  EXPECT_THAT(row.error(), HasSubstr("column z: the file has no such column"));
}

TEST(QueryFile, UnusableHeaders_AreErrorsWithoutRows) {
  const std::string too_long(QueryFile::kMaxLineLength + 1, 'x');
  for (const std::string& text : {std::string(), std::string("\n1\n"), std::string("x,x\n1,1\n"),
                                  std::string("x,\n1,1\n"), too_long + "\n1\n"}) {
    std::istringstream in(text);
    QueryFile file(in);
    EXPECT_FALSE(file.ok());
    EXPECT_THAT(file.error(), HasSubstr("header"));
    QueryRow row;
    EXPECT_FALSE(file.next(row));
  }
}

TEST(QueryFile, VeryLongLine_IsReportedAndSkipped) {
  std::istringstream in("x\n" + std::string(3 * QueryFile::kMaxLineLength, '0') + "\n3f8\n");
  QueryFile file(in);
  QueryRow row;
  ASSERT_TRUE(file.next(row));
  EXPECT_THAT(row.error(), HasSubstr("line 1: longer than"));
  ASSERT_TRUE(file.next(row));
  EXPECT_EQ(row.bits("x"), 1.0F);
  EXPECT_TRUE(row.ok());
}

TEST(QueryFile, BinaryRubbish_IsABadRow) {
  std::istringstream in(std::string("x\n\0\xFF\x01\n3f8\n", 11));
  QueryFile file(in);
  QueryRow row;
  ASSERT_TRUE(file.next(row));
  row.bits("x");
  EXPECT_FALSE(row.ok());
  ASSERT_TRUE(file.next(row));
  EXPECT_EQ(row.bits("x"), 1.0F);
}

TEST(QueryFile, StreamThatCannotBeRead_HasNoHeader) {
  std::istream in(nullptr);
  QueryFile file(in);
  EXPECT_FALSE(file.ok());
}

TEST(QueryRow, NeverFilled_FailsPlainly) {
  QueryRow row;
  EXPECT_EQ(row.text("x"), "");
  EXPECT_EQ(row.bits("x"), 0.0F);
  EXPECT_FALSE(row.ok());
}

}  // namespace
}  // namespace batuta::host
