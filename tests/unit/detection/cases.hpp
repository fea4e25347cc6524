// SPDX-License-Identifier: MIT
#pragma once
// Hand-made adversarial cases whose times of contact were computed in extended precision by other
// methods. Duration 1 s; lengths in m.

#include <cmath>
#include <string>
#include <vector>

#include "moving.hpp"

namespace batuta::testing_detection {

inline constexpr double kPi = 3.14159265358979324;
inline constexpr double kNever = -1;

struct Case {
  const char* name;
  Capsule64 A;
  Capsule64 B;
  double t = kNever;  ///< of the first contact; kNever: free
};

inline const Vec3<double> kO = Vec3<double>::Zero();

inline Capsule64 bar_x(double half, double radius, const Vec3<double>& w = kO) {
  return {kO, {-half, 0, 0}, {half, 0, 0}, radius, kO, w};
}
inline Capsule64 bar_y(double x, double vx, const Vec3<double>& w = kO) {
  return {{x, 0, 0}, {0, -1, 0}, {0, 1, 0}, 0.1, {vx, 0, 0}, w};
}
inline Capsule64 post_z(const Vec3<double>& at, double radius) {
  return {at, {0, 0, -1}, {0, 0, 1}, radius};
}
inline Capsule64 ball(const Vec3<double>& at, double radius, const Vec3<double>& v) {
  return {at, kO, kO, radius, v};
}

inline std::vector<Case> plain_cases() {
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

inline std::vector<Case> turning_cases() {
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

inline std::vector<Case> spatial_cases() {
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

/// Contacts and passes that a search which samples cannot be held to: exact grazes, gaps of a few
/// contact tolerances that last, contact at the last instant. Rounded to float they may go either
/// way.
inline std::vector<Case> delicate_cases() {
  const Capsule64 thick{kO, {0, 0, -1}, {0, 0, 1}, .9};
  const auto roller = [](double x, double y, double z) {
    return Capsule64{kO, {x, -y, -z}, {x, y, z}, .1, kO, {0, 0, kPi}};
  };
  return {
      {"T05", post_z(kO, .1), ball({-2, .2, 0}, .1, {4, 0, 0}), 0.5},
      {"T12", bar_x(1, .05, {0, 0, kPi}), post_z({0, 1.1, 0}, .05), 0.5},
      {"T18", thick, roller(1.002, 0, 1)},
      {"T19", thick, roller(1.002, .5, .5)},
      {"T19b", thick, roller(1.002, std::sin(.02), std::cos(.02))},
      {"T19b, 2e-6", thick, roller(1.000002, std::sin(.02), std::cos(.02))},
      {"T28", bar_y(0, 0), bar_y(4.2, -4), 1},
      {"T30", bar_y(0, 0), bar_y(.2001, -1e-3), 0.1},
  };
}

/// Axes without radii: the gap comes down to 0 and does not change its sign.
inline std::vector<Case> bare_cases() {
  const Capsule64 x{kO, {-1, 0, 0}, {1, 0, 0}, 0};
  return {
      {"T23", x, {{0, 0, 2}, {0, -1, 0}, {0, 1, 0}, 0, {0, 0, -4}}, 0.5},
      {"T24", x, {{0, 0, .5}, {0, -1, 0}, {0, 1, 0}, 0, kO, {2, 0, 0}}, 0.785398163397},
      {"T25", ball(kO, 0, kO), ball({2, 0, 0}, 0, {-4, 0, 0}), 0.5},
  };
}

/// Cases whose outcome survives rounding to float.
inline std::vector<Case> robust_cases() {
  std::vector<Case> all = plain_cases();
  for (const auto& more : {turning_cases(), spatial_cases()}) {
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}
inline std::vector<Case> all_cases() {
  std::vector<Case> all = robust_cases();
  for (const auto& more : {delicate_cases(), bare_cases()}) {
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

}  // namespace batuta::testing_detection
