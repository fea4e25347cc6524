// SPDX-License-Identifier: MIT
#include "check.hpp"

#include <algorithm>
#include <cstdio>

namespace batuta::peers {

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kDegree = kPi / 180;

// Engines stop before the contact, at a gap of their own: 1 mm in Bullet, 1e-4 of a step times a
// bound of the speed in FCL. At the speeds below that is at most this early, over the duration of
// 1 s. A wrong lever arm or centre of mass is ten times worse.
constexpr double kEarly = 6e-3;
constexpr double kLate = 1e-5;

struct Case {
  const char* name;
  PeerQuery query;
  bool contact = true;
  double t = 0;        ///< of the contact, computed by two independent certified methods
  bool lasts = false;  ///< the overlap lasts long enough for samples 1/16 s apart
  bool hard = false;   ///< takes a conservative search some 200 rounds: an engine may give up
};

PeerBody body(const Triple& center, const Triple& a, const Triple& b, double radius) {
  PeerBody body;
  body.center_W = center;
  body.a_B = a;
  body.b_B = b;
  body.radius = radius;
  return body;
}
PeerBody moving(PeerBody body, const Triple& v, const Triple& w) {
  body.v_W = v;
  body.w_W = w;
  return body;
}
PeerBody post(const Triple& center, double radius) {
  return body(center, {0, 0, -1}, {0, 0, 1}, radius);
}
/// A bar along x that turns about z.
PeerBody bar(double radius, double rate) {
  return moving(body({0, 0, 0}, {-1, 0, 0}, {1, 0, 0}, radius), {}, {0, 0, rate});
}
/// Turned by a quarter about z, with the ends turned back: the same capsule, another body frame.
PeerBody in_another_frame(PeerBody body) {
  const Quaternion quarter = turn({0, 0, 1}, kPi / 2);
  const Quaternion back = turn({0, 0, 1}, -kPi / 2);
  body.q_WB = quarter;
  body.a_B = turned(back, body.a_B);
  body.b_B = turned(back, body.b_B);
  return body;
}

std::vector<Case> linear_cases() {
  const PeerBody upright = body({0, 0, 0}, {0, -1, 0}, {0, 1, 0}, 0.1);
  const PeerBody parallel = moving(body({3, 0, 0}, {0, -1, 0}, {0, 1, 0}, 0.1), {-4, 0, 0}, {});
  const PeerBody crossing = moving(post({3, 0, 0}, 0.1), {-4, 0, 0}, {});
  const PeerBody offset = moving(body({3, -5, 0}, {0, 4, 0}, {0, 6, 0}, 0.1), {-4, 0, 0}, {});
  const PeerBody ball = moving(body({-2, 0, 0}, {}, {}, 0.1), {4, 0, 0}, {});
  const PeerBody passing = moving(body({-2, 0.3, 0}, {}, {}, 0.1), {4, 0, 0}, {});
  return {{"parallel axes", {upright, parallel, 1}, true, 0.7, true},
          {"crossing axes", {upright, crossing, 1}, true, 0.7, true},
          {"centre of mass off the axis' middle", {upright, offset, 1}, true, 0.7, true},
          {"ball on post", {post({}, 0.1), ball, 1}, true, 0.45, true},
          {"ball past post", {post({}, 0.1), passing, 1}, false, 0, false}};
}

std::vector<Case> turning_cases() {
  const PeerBody far_post = post({0, 0.8, 0}, 0.05);
  const PeerBody ball = moving(body({0.5, -3, 0}, {}, {}, 0.02), {0, 6, 0}, {});
  const PeerBody flipper = moving(body({}, {0, 0, 0}, {1, 0, 0}, 0.03), {}, {0, 0, -2});
  const PeerBody target = body({0.6, -0.7, 0}, {}, {}, 0.1);
  const PeerBody sinking = moving(body({0, 0, 0.6}, {0.2, 0, 0}, {0.8, 0, 0}, 0.05), {}, {0, 2, 0});
  const PeerBody rod = moving(body({}, {0, 0, 0}, {10, 0, 0}, 1e-3), {}, {0, 0, 0.1});
  const PeerBody slanting =
      moving(body({-2, 0, 0.3}, {-0.5, 0, 0}, {0.5, 0, 0}, 0.05), {4, 0, -0.4}, {0, 1, 0});
  return {{"half turn onto a post", {bar(0.05, kPi), far_post, 1}, true, 0.460106912325, true},
          {"the same in another body frame",
           {in_another_frame(bar(0.05, kPi)), in_another_frame(far_post), 1},
           true,
           0.460106912325,
           true},
          {"ten turns", {bar(0.05, 20 * kPi), far_post, 1}, true, 0.023005345616, false},
          {"ball through a turning bar's gap", {bar(0.05, kPi), ball, 1}, false, 0, false},
          {"flipper about its end", {flipper, target, 1}, true, 0.360346887607, true},
          {"bar tipping over its end", {bar(0.05, 0), sinking, 1}, true, 0.337565766469, true},
          {"long thin rod about its end",
           {rod, post({9.9, 0.5, 0}, 1e-3), 1},
           true,
           0.502604109741,
           false},
          {"flying and tipping", {bar(0.1, 0), slanting, 1}, true, 0.167098070717, true}};
}

std::vector<Case> full_cases() {
  const PeerBody parrying =
      moving(body({}, {-0.3, 0, 0}, {0.7, 0, 0}, 0.01), {0.2, 0, 0}, {0, 0, 1.8});
  const PeerBody parried =
      moving(body({0.5, 0.6, 0.015}, {-0.6, 0, 0}, {0.4, 0, 0}, 0.01), {-0.1, -0.5, 0}, {0, 0, -1});
  const PeerBody skew_A = moving(body({}, {-0.8, 0.3, 0.1}, {0.5, -0.2, -0.1}, 0.07),
                                 {0.3, -0.1, 0.2}, {2.1, -1.3, 0.7});
  const PeerBody skew_B = moving(body({0.85, 0.6, -0.3}, {-0.2, 0.6, 0.5}, {0.3, -0.7, -0.4}, 0.05),
                                 {-1.1, -0.8, 0.6}, {-1.7, 0.4, 2.3});
  const Triple d = {-std::sin(20 * kDegree), 0, -std::cos(20 * kDegree)};
  const PeerBody pendulum =
      moving(body({0, 0, 1.05}, along({}, 0.5, d), d, 0.05), {}, {0, -40 * kDegree, 0});
  const PeerBody long_bar = body({}, {-2, 0, 0}, {2, 0, 0}, 0.05);
  return {{"parry", {parrying, parried, 1}, true, 0.310374270625, false},
          {"everything at once", {skew_A, skew_B, 1}, true, 0.915277838431, false, true},
          {"pendulum, clear at both ends", {long_bar, pendulum, 1}, true, 0.045128191531, true}};
}

double turn_until(const Case& c) {
  const double time = c.contact ? c.t : c.query.duration;
  return time * std::max(length(c.query.A.w_W), length(c.query.B.w_W));
}
bool nothing_turns(const PeerQuery& query) {
  return length(query.A.w_W) == 0 && length(query.B.w_W) == 0;
}
/// Whether the engine claims to answer such a question.
bool applies(const Peer& peer, const Case& c) {
  if (peer.only_translation() && !nothing_turns(c.query)) return false;
  if (turn_until(c) > peer.largest_turn()) return false;
  return peer.sampling() == 0 || !c.contact || c.lasts;
}
bool is_right(const Peer& peer, const Case& c, const PeerAnswer& answer) {
  if (answer.gave_up) return c.hard;
  if (answer.contact != c.contact) return false;
  if (!c.contact) return true;
  const bool samples = peer.sampling() > 0;
  const double late = samples ? peer.sampling() * c.query.duration : kLate;
  return answer.t >= c.t - (samples ? kLate : kEarly) && answer.t <= c.t + late;
}

int check_case(Peer& peer, const Case& c) {
  if (!applies(peer, c)) return 0;
  peer.load(c.query);
  const PeerAnswer answer = peer.ask();
  const bool right = is_right(peer, c, answer);
  std::printf("%-6s %-20s %-36s %s %.9f, truth %s %.9f%s\n", right ? "ok" : "WRONG", peer.name(),
              c.name, answer.contact ? "contact" : "free", answer.t, c.contact ? "contact" : "free",
              c.t, answer.gave_up ? ", gave up" : "");
  return right ? 0 : 1;
}

}  // namespace

int check(const Roster& roster) {
  int wrong = 0;
  for (const auto& cases : {linear_cases(), turning_cases(), full_cases()}) {
    for (const Case& c : cases) {
      for (const PeerPtr& peer : roster.present) wrong += check_case(*peer, c);
    }
  }
  for (const std::string& name : roster.absent) {
    std::printf("skipped %s: its package is not installed\n", name.c_str());
  }
  return wrong;
}

}  // namespace batuta::peers
