// SPDX-License-Identifier: MIT
#include "measure.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <sstream>

namespace batuta::report {
namespace {

/// Two balls of radius 0.125 m: the second flies past the first, or into it after 0.7 s of 1 s.
Case balls(float aside) {
  test::Query query;
  query.A.capsule_B.radius = query.B.capsule_B.radius = 0.125F;
  query.A.motion.duration = query.B.motion.duration = 1;
  query.B.motion.X_WB.p_W = {3, aside, 0};
  query.B.motion.twist.v_W = {-4, 0, 0};
  return case_of(query);
}

constexpr double kContact = 2.75 / 4;

SearchResult<double> answered(Outcome outcome, double t_free, double t_hit) {
  SearchResult<double> answer;
  answer.outcome = outcome;
  answer.t_free = t_free;
  answer.t_hit = t_hit;
  answer.evaluations = 5;
  return answer;
}

/// The score of one answer as it stands in the file, by column.
std::map<std::string, std::string> scored(const Case& query, const SearchResult<double>& answer) {
  Score score;
  score.add(answer, {query, 1e-6, 10});
  Options options;
  options.out = testing::TempDir() + "measure_test";
  const std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
  Table table(options, name);
  score.write(table);
  EXPECT_EQ(table.write(), 0);
  std::ifstream file(options.out + "/" + name + ".csv");
  std::string head;
  std::string row;
  std::getline(file, head);
  std::getline(file, row);
  std::istringstream columns(head);
  std::istringstream cells(row);
  std::map<std::string, std::string> found;
  std::string column;
  std::string cell;
  while (std::getline(columns, column, ',')) {
    std::getline(cells, cell, ',');
    found[column] = cell;
    cell.clear();
  }
  return found;
}

TEST(Truth, Balls_MeetWhenTheirDistanceSays) {
  EXPECT_TRUE(balls(0).truth.contact);
  EXPECT_NEAR(balls(0).truth.time, kContact, 1e-14);
  EXPECT_FALSE(balls(1).truth.contact);
  EXPECT_NEAR(balls(1).truth.least_gap, 0.75, 1e-12);
  EXPECT_EQ(balls(1).truth.time, 1);
}

TEST(Score, Contact_IsJudgedByBothEndsOfItsBracket) {
  auto found = scored(balls(0), answered(Outcome::kContact, kContact - 0.125, kContact + 0.0625));
  EXPECT_EQ(found["contacts:sum"], "1");
  EXPECT_EQ(found["said_contact:sum"], "1");
  EXPECT_EQ(found["misses:sum"], "0");
  EXPECT_EQ(found["late:sum"], "0");
  EXPECT_NEAR(std::stod(found["worst_error_free:max"]), 0.125, 1e-12);
  EXPECT_NEAR(std::stod(found["worst_error_hit:max"]), 0.0625, 1e-12);
  EXPECT_NEAR(std::stod(found["overlap_hit:max"]), 0.025, 1e-12);
  EXPECT_EQ(found["evaluations_sum:sum"], "5");
  EXPECT_EQ(found["contact_evaluations_sum:sum"], "5");
}

TEST(Score, Late_TellsTheDeepestOverlapThatWasPassed) {
  // The centres meet at 0.75: 0.25 m deep, of which S = 10 m.
  auto found = scored(balls(0), answered(Outcome::kBudget, 0.875, 1));
  EXPECT_EQ(found["late:sum"], "1");
  EXPECT_EQ(found["said_budget:sum"], "1");
  EXPECT_NEAR(std::stod(found["worst_late:max"]), 0.875 - kContact, 1e-12);
  EXPECT_NEAR(std::stod(found["overlap_passed:max"]), 0.025, 1e-9);
  EXPECT_EQ(found["error_free:hist"], "");
}

TEST(Score, Free_IsAMissWhereThereIsContact) {
  auto found = scored(balls(0), answered(Outcome::kFree, 1, 1));
  EXPECT_EQ(found["misses:sum"], "1");
  EXPECT_NEAR(std::stod(found["missed_depth:max"]), 0.025, 1e-9);
  found = scored(balls(1), answered(Outcome::kFree, 1, 1));
  EXPECT_EQ(found["misses:sum"], "0");
  EXPECT_EQ(found["near_evaluations_sum:sum"], "0");
}

TEST(Score, Contact_IsFalseWhereTheGapStaysAboveTheTolerance) {
  auto found = scored(balls(1), answered(Outcome::kContact, 0.5, 0.5));
  EXPECT_EQ(found["false_contacts:sum"], "1");
  EXPECT_EQ(found["error_free:hist"], "");
  found = scored(balls(0.25F + 0x1p-20F), answered(Outcome::kContact, 0.5, 0.5));
  EXPECT_EQ(found["false_contacts:sum"], "0");
}

}  // namespace
}  // namespace batuta::report
