// SPDX-License-Identifier: MIT
// Closest points and times of contact for C: every row of the files with exact answers against its
// truth, and against the library's own answer to the bit.

#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <string>
#include <vector>

#include "batuta/c.h"
#include "batuta/detection/advancement.hpp"
#include "contact_row.hpp"
#include "exact_distance.hpp"

namespace batuta {
namespace {

constexpr double kBound = 4;  // of a distance, in u S: segment.hpp
constexpr std::size_t kLeastRows = 2000;

template <class Scalar>
struct CalledFromC;
template <>
struct CalledFromC<float> {
  using Closest = batuta_closest_f;
  using Search = batuta_search_f;
  using Contact = batuta_contact_f;
  static constexpr auto kClosestPoints = batuta_closest_points_f;
  static constexpr auto kClosestPointsMany = batuta_closest_points_many_f;
  static constexpr auto kTimeOfContact = batuta_time_of_contact_f;
  static constexpr auto kTimeOfContactMany = batuta_time_of_contact_many_f;
  static constexpr auto kTwistBetween = batuta_twist_between_f;
  static constexpr auto kTwistBetweenMany = batuta_twist_between_many_f;
};
template <>
struct CalledFromC<double> {
  using Closest = batuta_closest_d;
  using Search = batuta_search_d;
  using Contact = batuta_contact_d;
  static constexpr auto kClosestPoints = batuta_closest_points_d;
  static constexpr auto kClosestPointsMany = batuta_closest_points_many_d;
  static constexpr auto kTimeOfContact = batuta_time_of_contact_d;
  static constexpr auto kTimeOfContactMany = batuta_time_of_contact_many_d;
  static constexpr auto kTwistBetween = batuta_twist_between_d;
  static constexpr auto kTwistBetweenMany = batuta_twist_between_many_d;
};

template <class Scalar>
void append(std::vector<Scalar>& numbers, const Vec3<Scalar>& v) {
  numbers.insert(numbers.end(), {v.x(), v.y(), v.z()});
}
template <class Scalar>
void append(std::vector<Scalar>& numbers, const Capsule<Scalar>& capsule) {
  append(numbers, capsule.axis.a);
  append(numbers, capsule.axis.b);
  numbers.push_back(capsule.radius);
}
/// The quaternion is not renewed: that is for the called one to do.
void append(std::vector<double>& numbers, const MovingCapsule<float>& moving) {
  const auto& [X_WB, twist, duration] = moving.motion;
  append(numbers, test::cast<double>(moving).capsule_B);
  append(numbers, Vec3<double>(X_WB.p_W.cast<double>()));
  const Quat<float>& q = X_WB.q_WB;
  for (const float x : {q.w(), q.x(), q.y(), q.z()}) numbers.push_back(static_cast<double>(x));
  append(numbers, Vec3<double>(twist.v_W.cast<double>()));
  append(numbers, Vec3<double>(twist.w_W.cast<double>()));
}
void append(std::vector<float>& numbers, const MovingCapsule<float>& moving) {
  std::vector<double> wide;
  append(wide, moving);
  for (const double x : wide) numbers.push_back(static_cast<float>(x));  // exact: they were floats
}

template <class Row>
std::size_t for_each_row(const char* name, Row row_of) {
  std::ifstream in(std::string(BATUTA_COMMITTED_VECTORS "/") + name);
  host::QueryFile file(in);
  host::QueryRow row;
  std::size_t rows = 0;
  while (file.next(row)) {  // Bound: the length of the file
    SCOPED_TRACE(testing::Message() << name << ", line " << row.line());
    row_of(row);
    EXPECT_TRUE(row.ok()) << row.error();
    ++rows;
  }
  return rows;
}

Vec3<float> read_point(host::QueryRow& row, const std::string& name) {
  const float x = row.number(name + 'x');
  const float y = row.number(name + 'y');
  const float z = row.number(name + 'z');
  return {x, y, z};
}

template <class Scalar>
Segment<Scalar> read_segment(host::QueryRow& row, const std::string& name) {
  return {read_point(row, name + '0').template cast<Scalar>(),
          read_point(row, name + '1').template cast<Scalar>()};
}

template <class Scalar>
void expect_bits(const typename CalledFromC<Scalar>::Closest& told, const CapsuleGap<Scalar>& own) {
  EXPECT_EQ(told.gap, own.gap);
  EXPECT_EQ(told.distance, own.axes.distance);
  EXPECT_EQ(told.s, own.axes.s);
  EXPECT_EQ(told.u, own.axes.u);
  EXPECT_EQ(Vec3<Scalar>(told.p_A), own.axes.p_A);
  EXPECT_EQ(Vec3<Scalar>(told.p_B), own.axes.p_B);
  EXPECT_EQ(Vec3<Scalar>(told.normal_AB), own.axes.normal_AB);
  EXPECT_EQ(told.arbitrary, own.axes.arbitrary ? 1 : 0);
}

template <class Scalar>
class QueriesForC : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(QueriesForC, Scalars);

TYPED_TEST(QueriesForC, ClosestPoints_OfEveryRow) {
  using Scalar = TypeParam;
  using C = CalledFromC<Scalar>;
  std::vector<Scalar> all_A;
  std::vector<Scalar> all_B;
  std::vector<CapsuleGap<Scalar>> own;
  const auto judge = [&](host::QueryRow& row) {
    const Capsule<Scalar> A = {read_segment<Scalar>(row, "A"), Scalar(0)};
    const Capsule<Scalar> B = {read_segment<Scalar>(row, "B"), Scalar(0)};
    const exact::Real truth = row.decimal("d");
    const std::size_t at = all_A.size();
    append(all_A, A);
    append(all_B, B);
    typename C::Closest told;
    ASSERT_EQ(C::kClosestPoints(&all_A[at], &all_B[at], &told), BATUTA_OK);
    const exact::Real error = std::abs(static_cast<exact::Real>(told.distance) - truth);
    EXPECT_LE(error, kBound * kRoundOff<Scalar> * exact::visible_length(A.axis, B.axis));
    own.push_back(capsule_gap(A, B));
    expect_bits<Scalar>(told, own.back());
  };
  ASSERT_GE(for_each_row("dist.csv", judge), kLeastRows);

  std::vector<typename C::Closest> many(own.size());
  ASSERT_EQ(C::kClosestPointsMany(all_A.data(), all_B.data(), many.size(), many.data()),
            many.size());
  for (std::size_t i = 0; i < many.size(); ++i) expect_bits<Scalar>(many[i], own[i]);
}

/// What is promised of a first contact, in the words of the file.
template <class Contact>
void expect_true(const Contact& told, const test::ContactTruth& truth) {
  EXPECT_NE(told.outcome, BATUTA_BUDGET);
  EXPECT_TRUE(truth.kind != test::kAtStart || told.outcome == BATUTA_TOUCHING);
  if (truth.kind != test::kOnTheWay) return;
  EXPECT_NE(told.outcome, BATUTA_FREE);
  EXPECT_LE(static_cast<double>(told.t_free), truth.t);
}

template <class Scalar>
void expect_bits(const typename CalledFromC<Scalar>::Contact& told,
                 const SearchResult<Scalar>& own) {
  EXPECT_EQ(told.outcome, static_cast<int>(own.outcome));
  EXPECT_EQ(told.evaluations, own.evaluations);
  EXPECT_EQ(told.t_free, own.t_free);
  EXPECT_EQ(told.t_hit, own.t_hit);
}

TYPED_TEST(QueriesForC, TimeOfContact_OfEveryRow) {
  using Scalar = TypeParam;
  using C = CalledFromC<Scalar>;
  std::size_t contacts = 0;
  const auto judge = [&](host::QueryRow& row) {
    std::vector<Scalar> A;
    std::vector<Scalar> B;
    append(A, test::read_bits(row, "A"));
    append(B, test::read_bits(row, "B"));
    AdvancementOptions<Scalar> ample;
    ample.budget = 64;
    const typename C::Search search = {static_cast<Scalar>(row.number("T")),
                                       ample.contact_tolerance, ample.budget};
    typename C::Contact told;
    ASSERT_EQ(C::kTimeOfContact(A.data(), B.data(), &search, &told), BATUTA_OK);
    const test::ContactTruth truth = test::read_truth(row);
    expect_true(told, truth);
    contacts += truth.kind == test::kOnTheWay ? 1U : 0U;
    const auto pair = test::read_pair<Scalar>(row);
    ASSERT_TRUE(pair.ok());
    expect_bits<Scalar>(told, search_advancement(pair.value, ample));
  };
  ASSERT_GE(for_each_row("toc.csv", judge), kLeastRows);
  EXPECT_GE(contacts, kLeastRows / 2);
}

TYPED_TEST(QueriesForC, TimeOfContactMany_UpToTheFirstThatIsRefused) {
  using Scalar = TypeParam;
  using C = CalledFromC<Scalar>;
  constexpr std::size_t kCount = 5;
  const Capsule<Scalar> ball = Capsule<Scalar>::sphere(Vec3<Scalar>::Zero(), Scalar(0.25));
  std::vector<Scalar> A;
  std::vector<Scalar> B;
  for (std::size_t i = 0; i < kCount; ++i) {
    // Balls 1 m apart that close at i m/s: the gap of 0.5 m is over after 0.5 / i.
    append(A, ball);
    append(B, ball);
    A.insert(A.end(), {0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0});
    B.insert(B.end(), {1, 0, 0, 2, 0, 0, 0, -static_cast<Scalar>(i), 0, 0, 0, 0, 0});
  }
  const typename C::Search search = {Scalar(1), Scalar(1e-6), 30};
  std::vector<typename C::Contact> told(kCount);
  ASSERT_EQ(C::kTimeOfContactMany(A.data(), B.data(), kCount, &search, told.data()), kCount);
  EXPECT_EQ(told[0].outcome, BATUTA_FREE);
  for (std::size_t i = 1; i < kCount; ++i) {
    EXPECT_EQ(told[i].outcome, BATUTA_CONTACT);
    EXPECT_NEAR(static_cast<double>(told[i].t_hit), 0.5 / static_cast<double>(i), 1e-5);
  }

  B[3 * BATUTA_MOVING_NUMBERS + 6] = -1;  // a radius
  std::vector<typename C::Contact> untold(kCount);
  ASSERT_EQ(C::kTimeOfContactMany(A.data(), B.data(), kCount, &search, untold.data()), 3U);
  EXPECT_EQ(untold[2].t_hit, told[2].t_hit);
  EXPECT_EQ(untold[3].t_hit, Scalar(0));
  EXPECT_EQ(untold[4].t_hit, Scalar(0));
}

TYPED_TEST(QueriesForC, TwistBetween_CarriesOnePoseIntoTheOther) {
  using Scalar = TypeParam;
  const Scalar half = Scalar(0.70710678118654752440L);  // a quarter of a turn about z, 2 m along y
  const std::array<Scalar, 7> from = {1, 2, 3, 2, 0, 0, 0};
  const std::array<Scalar, 7> to = {1, 4, 3, half, 0, 0, half};
  std::array<Scalar, 6> twist{};
  ASSERT_EQ(CalledFromC<Scalar>::kTwistBetween(from.data(), to.data(), Scalar(0.5), twist.data()),
            BATUTA_OK);
  const std::array<double, 6> by_pencil = {0, 4, 0, 0, 0, 3.14159265358979323846};
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_NEAR(static_cast<double>(twist[i]), by_pencil[i], 8 * kRoundOff<Scalar> * 4);
  }

  std::vector<Scalar> many_from(from.begin(), from.end());
  std::vector<Scalar> many_to(to.begin(), to.end());
  many_from.insert(many_from.end(), {0, 0, 0, 1, 0, 0, 0});
  many_to.insert(many_to.end(), {1, 0, 0, 1, 0, 0, 0});
  std::vector<Scalar> twists(12);
  ASSERT_EQ(CalledFromC<Scalar>::kTwistBetweenMany(many_from.data(), many_to.data(), 2, Scalar(0.5),
                                                   twists.data()),
            2U);
  EXPECT_TRUE(std::equal(twist.begin(), twist.end(), twists.begin()));
  EXPECT_EQ(twists[6], Scalar(2));
}

}  // namespace
}  // namespace batuta
