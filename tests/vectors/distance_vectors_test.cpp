// SPDX-License-Identifier: MIT
// Closest points of segments against exact answers, for both scalars.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wpsabi"  // lanes wider than this machine's are never passed on
#endif

#include <gtest/gtest.h>

#include <cstdio>
#include <string>

#include "batuta/geometry/segment.hpp"
#include "exact_distance.hpp"
#include "judge_file.hpp"
#include "segment_columns.hpp"

namespace batuta {
namespace {

constexpr double kBound = 4;  // in u S, for the excess and for the error of the distance

template <class Scalar>
Vec3<Scalar> read_point(host::QueryRow& row, const std::string& name) {
  return {Scalar(row.number(name + "x")), Scalar(row.number(name + "y")),
          Scalar(row.number(name + "z"))};
}

struct Worst {
  double figure = 0;
  long line = 0;

  void see(double value, long at_line) {
    if (value > figure) *this = {value, at_line};
  }
};

template <class Scalar>
void expect_same(const ClosestPoints<Scalar>& x, const ClosestPoints<Scalar>& y, long line) {
  EXPECT_EQ(x.distance, y.distance) << "line " << line;
  EXPECT_EQ(x.p_A, y.p_A) << "line " << line;
  EXPECT_EQ(x.p_B, y.p_B) << "line " << line;
}

template <class Scalar>
void expect_symmetric(const Segment<Scalar>& A, const Segment<Scalar>& B,
                      const ClosestPoints<Scalar>& answer, long line) {
  const Segment<Scalar> A_turned{A.b, A.a};
  const Segment<Scalar> B_turned{B.b, B.a};
  expect_same(closest_points(A_turned, B), answer, line);
  expect_same(closest_points(A, B_turned), answer, line);
  ClosestPoints<Scalar> swapped = closest_points(B_turned, A);
  swapped.p_A.swap(swapped.p_B);
  expect_same(swapped, answer, line);
}

/// Checks the answers to one file and keeps the worst figures.
template <class Scalar>
class Judge {
 public:
  void judge(host::QueryRow& row) {
    ++queries_;
    const Segment<Scalar> A{read_point<Scalar>(row, "A0"), read_point<Scalar>(row, "A1")};
    const Segment<Scalar> B{read_point<Scalar>(row, "B0"), read_point<Scalar>(row, "B1")};
    const exact::Real truth = row.decimal("d");
    ASSERT_TRUE(row.ok()) << row.error();

    const ClosestPoints<Scalar> answer = closest_points(A, B);
    ASSERT_TRUE(answer.s >= 0 && answer.s <= 1 && answer.u >= 0 && answer.u <= 1) << row.line();
    EXPECT_NEAR(answer.normal_AB.template cast<double>().norm(), 1, 4 * kRoundOff<Scalar>);
    const exact::Real unit = kRoundOff<Scalar> * exact::visible_length(A, B);
    const exact::Real found = exact::distance_at(A, B, answer.s, answer.u);
    if (unit > 0) {
      excess_.see(static_cast<double>((found - truth) / unit), row.line());
      error_.see(static_cast<double>(std::abs(answer.distance - truth) / unit), row.line());
    } else {
      EXPECT_EQ(answer.distance, 0);
    }
    expect_symmetric(A, B, answer, row.line());
  }

  void report(const char* scalar, const test::Evidence& evidence) const {
    EXPECT_GE(queries_, evidence.rows);
    EXPECT_LE(excess_.figure, kBound) << "line " << excess_.line;
    EXPECT_LE(error_.figure, kBound) << "line " << error_.line;
    testing::Test::RecordProperty("worst_excess_uS", std::to_string(excess_.figure));
    testing::Test::RecordProperty("worst_error_uS", std::to_string(error_.figure));
    std::printf("distance, %s: worst excess %.2f u S (line %ld), worst error %.2f u S (line %ld)\n",
                scalar, excess_.figure, excess_.line, error_.figure, error_.line);
  }

 private:
  std::size_t queries_ = 0;
  Worst excess_;
  Worst error_;
};

/// Whether many at once have the bits of one at a time.
template <class Scalar>
class ArraysJudge {
 public:
  void judge(host::QueryRow& row) {
    const Segment<Scalar> A{read_point<Scalar>(row, "A0"), read_point<Scalar>(row, "A1")};
    const Segment<Scalar> B{read_point<Scalar>(row, "B0"), read_point<Scalar>(row, "B1")};
    ASSERT_TRUE(row.ok()) << row.error();
    pairs_.push(A, B);
  }
  void report(const char* scalar, const test::Evidence& evidence) const {
    EXPECT_GE(pairs_.size(), evidence.rows);
    const std::size_t unlike = test::count_unlike_at_any_width(pairs_);
    EXPECT_EQ(unlike, 0U);
    std::printf("arrays, %s: %zu of %zu pairs have other bits\n", scalar, unlike, pairs_.size());
  }

 private:
  test::SegmentColumns<Scalar> pairs_;
};

template <class Scalar>
class DistanceVectors : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(DistanceVectors, Scalars);

TYPED_TEST(DistanceVectors, EveryLine_WithinFourRoundOffs) {
  test::judge_file<Judge<TypeParam>>(test::kDistances, sizeof(TypeParam) == 4 ? "float" : "double");
}

TYPED_TEST(DistanceVectors, EveryLine_InArraysHasTheBitsOfOneAtATime) {
  test::judge_file<ArraysJudge<TypeParam>>(test::kDistances,
                                           sizeof(TypeParam) == 4 ? "float" : "double");
}

}  // namespace
}  // namespace batuta
