// SPDX-License-Identifier: MIT
// Hand-made adversarial cases whose times of contact were computed in extended precision by other
// methods.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "batuta/detection/stepping.hpp"
#include "moving.hpp"

namespace batuta {
namespace {

using namespace testing_detection;

constexpr double kPi = 3.14159265358979324;
constexpr double kNever = -1;

struct Case {
  const char* name;
  Capsule64 A;
  Capsule64 B;
  double t = kNever;
};

const Vec3<double> kO = Vec3<double>::Zero();

Capsule64 bar_x(double half, double radius, const Vec3<double>& w = kO) {
  return {kO, {-half, 0, 0}, {half, 0, 0}, radius, kO, w};
}
Capsule64 bar_y(double x, double vx, const Vec3<double>& w = kO) {
  return {{x, 0, 0}, {0, -1, 0}, {0, 1, 0}, 0.1, {vx, 0, 0}, w};
}
Capsule64 post_z(const Vec3<double>& at, double radius) {
  return {at, {0, 0, -1}, {0, 0, 1}, radius};
}
Capsule64 ball(const Vec3<double>& at, double radius, const Vec3<double>& v) {
  return {at, kO, kO, radius, v};
}

std::vector<Case> plain_cases() {
  return {
      {"T01", bar_y(0, 0), bar_y(3, -4), 0.7},
      {"T02", bar_y(0, 0), {{3, 0, 0}, {0, 0, -1}, {0, 0, 1}, .1, {-4, 0, 0}}, 0.7},
      {"T03", bar_x(1, .1), {{5, 0, 0}, {-1, 0, 0}, {1, 0, 0}, .1, {-4, 0, 0}}, 0.7},
      {"T04", post_z(kO, .01), ball({-50, 0, 0}, .01, {1000, 0, 0}), 0.04998},
      {"T06", post_z(kO, .1), ball({-2, .2001, 0}, .1, {4, 0, 0})},
      {"T07", post_z(kO, .1), ball({-2, .1999, 0}, .1, {4, 0, 0}), 0.498419058825},
      {"T21", bar_y(0, 0), {{2, 0, 0}, {-1e-4, -1, 0}, {1e-4, 1, 0}, .1, {-2.5, 0, 0}}, 0.71996},
      {"T22", bar_y(0, 0), bar_y(2, -2.5, {0, 0, .01}), 0.717131498593},
      {"T29", bar_y(0, 0), bar_y(4.20001, -4)},
      {"T56", bar_y(0, 5), bar_y(.201, 5)},
  };
}

std::vector<Case> turning_cases() {
  const Capsule64 post = post_z({0, .8, 0}, .05);
  return {
      {"T08", bar_x(1, .05, {0, 0, kPi}), post, 0.460106912325},
      {"T09", bar_x(1, .05, {0, 0, 20 * kPi}), post, 0.023005345616},
      {"T27", bar_x(1, .05, {0, 0, 4 * kPi}), post, 0.115026728081},
      {"T10", bar_x(1, .05, {0, 0, kPi}), post_z({0, 1.10001, 0}, .05)},
      {"T11", bar_x(1, .05, {0, 0, kPi}), post_z({0, 1.09999, 0}, .05), 0.499570799784},
      {"T13", bar_x(1, .05, {0, 0, kPi}), ball({.5, -3, 0}, .02, {0, 6, 0})},
      {"T14", bar_x(1, .05, {0, 0, kPi}), ball({.5, 3, 0}, .02, {0, -6.5, 0}), 0.321612165526},
      {"T15", {kO, kO, {1, 0, 0}, .03, kO, {0, 0, -2}}, ball({.6, -.7, 0}, .1, kO), 0.360346887607},
      {"T16",
       {kO, {-.3, 0, 0}, {.7, 0, 0}, .01, {.2, 0, 0}, {0, 0, 1.8}},
       {{.5, .6, .015}, {-.6, 0, 0}, {.4, 0, 0}, .01, {-.1, -.5, 0}, {0, 0, -1}},
       0.310374270625},
      {"T17",
       bar_x(1, .05, {0, 0, kPi}),
       {{0, 0, .102}, {-.9, .3, 0}, {.9, -.3, 0}, .05, kO, {0, 0, -2.2}}},
      {"T26",
       {kO, kO, {10, 0, 0}, .001, kO, {0, 0, .1}},
       post_z({9.9, .5, 0}, .001),
       0.502604109741},
  };
}

std::vector<Case> spatial_cases() {
  const double dip = 40 * kPi / 180;
  const Vec3<double> d(-std::sin(dip / 2), 0, -std::cos(dip / 2));
  const Capsule64 skew{kO, {-.8, .3, .1}, {.5, -.2, -.1}, .07, {.3, -.1, .2}, {2.1, -1.3, .7}};
  const Vec3<double> a(-.2, .6, .5);
  const Vec3<double> b(.3, -.7, -.4);
  const Vec3<double> w(-1.7, .4, 2.3);
  return {
      {"T31", post_z(kO, .1), {{.5, 0, -3}, {-.25, 0, 0}, {.25, 0, 0}, .04, {0, 0, 6}, {0, 0, 12}}},
      {"T32",
       post_z(kO, .1),
       {{.45, 0, -3}, {-.35, 0, 0}, {.35, 0, 0}, .04, {0, 0, 6}, {0, 0, 12}},
       0.502972383158},
      {"T33",
       post_z(kO, .2),
       {{.5, 0, 1.6}, {0, 0, -.6}, {0, 0, .6}, .1, {0, 0, -2}, {0, 3, 0}},
       0.113278969818},
      {"T34", skew, {{.85, .6, -.3}, a, b, .05, {-1.1, -.8, .6}, w}, 0.915277838431},
      {"T35", skew, {{1.2, .9, -.4}, a, b, .05, {-1.1, -.8, 1.9}, w}},
      {"T36",
       bar_x(1, .05),
       {{0, 0, .6}, {.2, 0, 0}, {.8, 0, 0}, .05, kO, {0, 2, 0}},
       0.337565766469},
      {"T37", bar_x(2, .05), {{0, 0, 1.05}, .5 * d, d, .05, kO, {0, -dip, 0}}, 0.045128191531},
      {"T39",
       bar_x(1, .1),
       {{-2, 0, .3}, {-.5, 0, 0}, {.5, 0, 0}, .05, {4, 0, -.4}, {0, 1, 0}},
       0.167098070717},
      {"T40", bar_x(3, .01, {.02, 0, .3}), {{2.5, .9, .05}, {0, -.6, 0}, {0, .6, 0}, .01}},
      {"T41",
       {kO, kO, {1, 0, 0}, .02, kO, {0, 0, kPi / 2}},
       {{1.3, 1.3, 0}, kO, {-1, 0, 0}, .02, kO, {0, 0, kPi / 2}},
       0.486147886736},
      {"T42",
       post_z(kO, .02),
       {{-300, .4, 0}, {-.5, 0, 0}, {.5, 0, 0}, .02, {600, 0, 0}, {0, 0, 2}},
       0.500348215385},
      {"T43",
       bar_x(2, .05),
       {{0, 0, 1.2}, {0, 0, -1.0999}, {0, 0, 1.0999}, .05, {0, 0, -.35}, {0, 2, 0}},
       0.000286229210},
  };
}

SearchResult<double> answer(const Case& c, double epsilon) {
  const auto pair = make_moving_pair(moving(c.A), moving(c.B));
  EXPECT_TRUE(pair.ok()) << c.name;
  SteppingOptions<double> options;
  options.epsilon = epsilon;
  options.max_steps = 10'000'000;
  options.halvings = kMaxHalvings;
  return search_stepping(pair.value, options);
}

/// @param epsilon  times the thinner radius; grazes of 1e-4 and less need a small one
void expect_answer(const Case& c, double epsilon) {
  constexpr double kDigitsGiven = 2e-12;
  const SearchResult<double> found = answer(c, epsilon);
  if (c.t == kNever) {
    EXPECT_EQ(found.outcome, Outcome::kFree) << c.name;
    return;
  }
  ASSERT_EQ(found.outcome, Outcome::kContact) << c.name;
  EXPECT_NEAR(found.t_hit, c.t, kDigitsGiven) << c.name;
  EXPECT_NEAR(found.t_free, c.t, kDigitsGiven) << c.name;
}

TEST(SteppingCases, Translation_FindsTheTime) {
  for (const Case& c : plain_cases()) expect_answer(c, 1e-3);
}
TEST(SteppingCases, Turning_FindsTheTime) {
  for (const Case& c : turning_cases()) expect_answer(c, 2e-4);
}
TEST(SteppingCases, InSpace_FindsTheTime) {
  for (const Case& c : spatial_cases()) expect_answer(c, 0.01);
}

TEST(SteppingCases, AnyScale_SameTime) {  // T38
  for (const double scale : {1e-6, 1e6}) {
    const auto pair = make_moving_pair(
        moving<float>({kO, {-scale, 0, 0}, {scale, 0, 0}, .05 * scale, kO, {0, 0, kPi}}),
        moving<float>({{0, .8 * scale, 0}, {0, 0, -scale}, {0, 0, scale}, .05 * scale}));
    SteppingOptions<float> options;
    options.halvings = kMaxHalvings;
    const auto found = search_stepping(pair.value, options);
    ASSERT_EQ(found.outcome, Outcome::kContact);
    EXPECT_NEAR(found.t_hit, 0.460106912325F, 1e-6F);
  }
}

TEST(SteppingCases, FastAndSmall_IsSlowAndLarge) {  // T52: T08 with lengths and times 1e-6
  const double k = 1e-6;
  const auto pair =
      make_moving_pair(moving({kO, {-k, 0, 0}, {k, 0, 0}, .05 * k, kO, {0, 0, kPi / k}}, k),
                       moving({{0, .8 * k, 0}, {0, 0, -k}, {0, 0, k}, .05 * k}, k));
  const auto found = search_stepping(pair.value, SteppingOptions<double>{});
  ASSERT_EQ(found.outcome, Outcome::kContact);
  EXPECT_NEAR(found.t_hit / k, 0.460106912325, 1e-6);
}

TEST(SteppingCases, AstronomicAndMinute_NeverFreeWrongly) {  // T53
  const auto fast =
      make_moving_pair(moving<float>(bar_y(0, 0), 1e-19), moving<float>(bar_y(3, -4e19), 1e-19));
  ASSERT_TRUE(fast.ok());
  EXPECT_EQ(search_stepping(fast.value, {}).outcome, Outcome::kContact);
  const double k = 1e-25;
  const auto small = make_moving_pair(
      moving<float>({kO, {0, -k, 0}, {0, k, 0}, .1 * k}),
      moving<float>({{3 * k, 0, 0}, {0, -k, 0}, {0, k, 0}, .1 * k, {-4 * k, 0, 0}}));
  ASSERT_TRUE(small.ok());
  const auto found = search_stepping(small.value, {});
  EXPECT_EQ(found.outcome, Outcome::kContact);
  EXPECT_NEAR(found.t_hit, 0.7F, 1e-5F);
}

}  // namespace
}  // namespace batuta
