// SPDX-License-Identifier: MIT
#include "programs/query_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

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
  EXPECT_EQ(row.number("x"), 1.0F);
  EXPECT_EQ(row.decimal("d"), 0.5);
  ASSERT_TRUE(file.next(row));
  EXPECT_EQ(row.line(), 2);
  EXPECT_EQ(row.decimal("d"), 2);
  EXPECT_TRUE(row.ok());
  EXPECT_FALSE(file.next(row));
}

/// The numbers of a line, and what was wrong with it.
struct ReadLine {
  std::vector<float> numbers;
  std::string error;
};

ReadLine numbers_of(const std::string& line) {
  std::istringstream in("x,y,z,d\n" + line + ",0.5\n");
  QueryFile file(in);
  QueryRow row;
  EXPECT_TRUE(file.next(row));
  ReadLine read;
  for (const char* column : {"x", "y", "z"}) read.numbers.push_back(row.number(column));
  EXPECT_EQ(row.decimal("d"), row.ok() ? 0.5 : 0) << "an answer says nothing of how numbers are";
  row.check_notation();
  read.error = row.error();
  return read;
}

TEST(QueryRow, NumberByBitsOrDecimal_IsThatFloat) {
  EXPECT_THAT(numbers_of("3f8,4,c00e").numbers, testing::ElementsAre(1.0F, 2.0F, -2.21875F));
  EXPECT_THAT(numbers_of("0x3f8,0x4,0x0").numbers, testing::ElementsAre(1.0F, 2.0F, 0.0F));
  EXPECT_THAT(numbers_of("1.0,-2,0.1").numbers, testing::ElementsAre(1.0F, -2.0F, 0.1F));
  EXPECT_THAT(numbers_of("+2,1e-3,0").numbers, testing::ElementsAre(2.0F, 1e-3F, 0.0F));
  EXPECT_THAT(numbers_of("inf,-inf,0x4").numbers, testing::ElementsAre(INFINITY, -INFINITY, 2.0F));
  EXPECT_THAT(numbers_of("1.5,3f8,0").numbers, testing::ElementsAre(1.5F, 1.0F, 0.0F));
  for (const char* line : {"3f8,4,c00e", "0x3f8,0x4,0x0", "1.0,-2,0.1", "+2,1e-3,0", "inf,-inf,0x4",
                           "1.5,3f8,0", "3f8,40000000,0", "0,0,00", "3f8,2,1e5"}) {
    EXPECT_EQ(numbers_of(line).error, "") << line;
  }
}

TEST(QueryRow, NumberThatMayBeMeantEitherWay_IsRefused) {
  EXPECT_THAT(numbers_of("2,0,0").error, HasSubstr("line 1, column x: 2 is not clear"));
  EXPECT_THAT(numbers_of("0,1e5,0").error,
              HasSubstr("column y: 1e5 is not clear: 0x1e5 for bits, 1.0e5 for a number"));
  EXPECT_THAT(numbers_of("0,0,10000000").error, HasSubstr("column z: 10000000 is not clear"));
  EXPECT_THAT(numbers_of("2.0,3,0").error, HasSubstr("column y: 3 is not clear"));
  EXPECT_THAT(numbers_of("3f8,3,-1").error, HasSubstr("column y: 3 is not clear"));
}

TEST(QueryRow, NumberThatIsNone_IsRefused) {
  for (const char* line : {"1.5x,0,0", "0x,0,0", "0x123456789,0,0", "1.0e39,0,0", "--1,0,0", ",0,0",
                           "+-1,0,0", "0x1.8,0,0", "NaN,0,0"}) {
    EXPECT_THAT(numbers_of(line).error, HasSubstr("column x")) << line;
  }
}

TEST(QueryFile, AllThatIsWrongWithAHeader_IsSaidAtOnce) {
  std::istringstream in("x,,y,x,x\n");
  QueryFile file(in);
  file.require({"x", "q", "r"});
  EXPECT_EQ(file.error(),
            "header: column 2 has no name; there are two columns x; there is no column q, r");
}

TEST(QueryFile, WindowsLineEndsByteOrderMarkAndNoFinalNewline_AreRead) {
  std::istringstream in("\xEF\xBB\xBFx,y\r\n3f8,4\r\n4,3f8");
  QueryFile file(in);
  QueryRow row;
  ASSERT_TRUE(file.next(row));
  EXPECT_EQ(row.number("y"), 2.0F);
  ASSERT_TRUE(file.next(row));
  EXPECT_EQ(row.number("x"), 2.0F);
  EXPECT_EQ(row.number("y"), 1.0F);
  EXPECT_TRUE(row.ok()) << row.error();
}

TEST(QueryFile, MalformedField_IsReportedWithLineAndColumnAndTheNextRowIsRead) {
  std::istringstream in("x,y\n3f8,oops\n3f8,3f8\n");
  QueryFile file(in);
  QueryRow row;
  ASSERT_TRUE(file.next(row));
  EXPECT_EQ(row.number("x"), 1.0F);
  EXPECT_EQ(row.number("y"), 0.0F);
  EXPECT_THAT(row.error(), HasSubstr("line 1, column y"));
  ASSERT_TRUE(file.next(row));
  EXPECT_EQ(row.number("y"), 1.0F);
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
  row.number("x");
  row.number("missing");
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
  EXPECT_EQ(row.number("z"), 0.0F);
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
  EXPECT_EQ(row.number("x"), 1.0F);
  EXPECT_TRUE(row.ok());
}

TEST(QueryFile, BinaryRubbish_IsABadRow) {
  std::istringstream in(std::string("x\n\0\xFF\x01\n3f8\n", 11));
  QueryFile file(in);
  QueryRow row;
  ASSERT_TRUE(file.next(row));
  row.number("x");
  EXPECT_FALSE(row.ok());
  ASSERT_TRUE(file.next(row));
  EXPECT_EQ(row.number("x"), 1.0F);
}

TEST(QueryFile, StreamThatCannotBeRead_HasNoHeader) {
  std::istream in(nullptr);
  QueryFile file(in);
  EXPECT_FALSE(file.ok());
}

TEST(QueryRow, NeverFilled_FailsPlainly) {
  QueryRow row;
  EXPECT_EQ(row.text("x"), "");
  EXPECT_EQ(row.number("x"), 0.0F);
  EXPECT_FALSE(row.ok());
}

}  // namespace
}  // namespace batuta::host
