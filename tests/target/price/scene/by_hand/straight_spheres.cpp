// SPDX-License-Identifier: MIT
// StraightSpheres as one writes it by hand: the same answers for the same eight balls, from the
// kernels alone. Bodies that are not finite are left out; only pairs whose boxes meet are searched,
// and those of a contact anew; ties go to the lower pair; a pair whose search has no answer, and
// contacts beyond kMaxContacts, stop their bodies for the rest of the step, and are counted.

#include "../runs.hpp"
#include "../scene.hpp"
#include "batuta/detection/sphere_flight.hpp"
#include "batuta/response/straight_impulse.hpp"

namespace {

using namespace batuta;

constexpr int kPairs = price::kBalls * (price::kBalls - 1) / 2;
constexpr int kMaxContacts = 8;

struct Ball {
  StraightBody<float> body;
  float radius = 0;
  float restitution = 0;
  // Of the step.
  StraightMotion<float> motion;
  Aabb<float> box;
  float start = 0;
  bool present = false;
  bool held = false;
  bool fresh = false;  ///< its pairs are not searched yet
};

/// A pair that is going to meet.
struct Meeting {
  std::uint8_t a = 0;
  std::uint8_t b = 0;
  bool is_contact = false;
  float free_until = 0;
  float hit_at = 0;
};

struct Report {
  std::uint32_t collisions = 0;
  std::uint32_t cut = 0;
  std::uint32_t invalid = 0;
};

Ball balls[price::kBalls];
Meeting meetings[kPairs];
int meeting_count;
Report report;

bool is_usable(const Ball& ball) {
  return is_finite(ball.body.p_W) && is_finite(ball.body.momentum_W) &&
         is_finite(ball.body.inverse_mass) && ball.body.inverse_mass >= 0.F &&
         is_finite(ball.radius) && ball.radius >= 0.F && ball.restitution >= 0.F &&
         ball.restitution <= 1.F;
}

void plan(Ball& ball, float now, float dt) {
  ball.fresh = ball.present = is_usable(ball);
  if (!ball.present) {
    ++report.invalid;
    return;
  }
  ball.start = now;
  ball.motion = {ball.body.p_W, velocity_of(ball.body), dt - now};
  if (ball.held) ball.motion.v_W.setZero();
  ball.box = sphere_aabb(ball.motion, ball.radius);
}

void search(int a, int b, float now, float dt) {
  const Ball& A = balls[a];
  const Ball& B = balls[b];
  const Vec3<float> between =
      position_at(B.motion, now - B.start) - position_at(A.motion, now - A.start);
  const SphereFlight<float> flight = {between, B.motion.v_W - A.motion.v_W, A.radius + B.radius,
                                      dt - now};
  const auto answer = search_spheres(flight, 0.F);
  const bool parts = answer.outcome == Outcome::kTouching && !(flight.between.dot(flight.v) < 0.F);
  if (answer.outcome == Outcome::kFree || parts) return;
  Meeting& meeting = meetings[meeting_count++];
  meeting.a = static_cast<std::uint8_t>(a);
  meeting.b = static_cast<std::uint8_t>(b);
  meeting.is_contact = answer.outcome == Outcome::kContact || answer.outcome == Outcome::kTouching;
  meeting.free_until = now + answer.t_free;
  meeting.hit_at = now + answer.t_hit;
}

/// Every pair of which a body is fresh. Bound: kPairs.
void search_fresh(float now, float dt) {
  for (int a = 0; a < price::kBalls; ++a) {
    for (int b = a + 1; b < price::kBalls; ++b) {
      const Ball& A = balls[a];
      const Ball& B = balls[b];
      const bool is_new = (A.fresh || B.fresh) && A.present && B.present && !(A.held && B.held);
      const bool walls = A.body.inverse_mass == 0.F && B.body.inverse_mass == 0.F;
      if (is_new && !walls && overlaps<float, 6>(A.box, B.box)) search(a, b, now, dt);
    }
  }
  for (Ball& ball : balls) ball.fresh = false;
}

int first_meeting() {
  int first = -1;
  for (int i = 0; i < meeting_count; ++i) {  // Bound: kPairs
    if (first < 0 || meetings[i].free_until < meetings[first].free_until) first = i;
  }
  if (first < 0 || !meetings[first].is_contact) return first;
  const auto order = [](const Meeting& m) { return m.a * price::kBalls + m.b; };
  const float until = meetings[first].hit_at;
  for (int i = 0; i < meeting_count; ++i) {  // Bound: kPairs
    const bool ties = meetings[i].is_contact && !(until < meetings[i].free_until);
    if (ties && order(meetings[i]) < order(meetings[first])) first = i;
  }
  return first;
}

void forget_meetings_of(int a, int b) {
  for (int i = meeting_count - 1; i >= 0; --i) {  // Bound: kPairs
    const Meeting& m = meetings[i];
    if (m.a == a || m.b == a || m.a == b || m.b == b) meetings[i] = meetings[--meeting_count];
  }
}

/// Brings both to the contact and pushes them apart.
void answer(const Meeting& meeting, float now, bool may_push) {
  Ball& A = balls[meeting.a];
  Ball& B = balls[meeting.b];
  A.body.p_W = position_at(A.motion, now - A.start);
  B.body.p_W = position_at(B.motion, now - B.start);
  if (!meeting.is_contact || !may_push) {
    A.held = B.held = true;
    ++report.cut;
    return;
  }
  const Vec3<float> to_A = A.body.p_W - B.body.p_W;
  const float distance = to_A.norm();
  const Vec3<float> normal =
      distance > 0.F ? Vec3<float>(to_A / distance) : Vec3<float>(Vec3<float>::UnitX());
  const auto hit = straight_impulse(A.body, B.body, normal, max_of(A.restitution, B.restitution));
  if (hit.impulse > 0.F) ++report.collisions;
}

}  // namespace

bool price_scene_place(float restitution) {
  for (int i = 0; i < price::kBalls; ++i) {
    balls[i].body = price::straight_body(price::ball_start(i));
    balls[i].radius = price::kBallRadius;
    balls[i].restitution = restitution;
    if (!is_usable(balls[i])) return false;
  }
  return true;
}

Status price_scene_step(float dt) {
  if (!is_positive(dt)) return Status::kInvalidArgument;
  report = {};
  meeting_count = 0;
  for (Ball& ball : balls) {
    ball.held = false;
    plan(ball, 0, dt);
  }
  float now = 0;
  // Bound: each round but the last ends with a contact, or holds two bodies for good.
  for (int contacts = 0; contacts <= kMaxContacts + price::kBalls; ++contacts) {
    search_fresh(now, dt);
    const int first = first_meeting();
    if (first < 0) break;
    const Meeting meeting = meetings[first];
    now = min_of(meeting.free_until, dt);
    answer(meeting, now, contacts < kMaxContacts);
    forget_meetings_of(meeting.a, meeting.b);
    plan(balls[meeting.a], now, dt);
    plan(balls[meeting.b], now, dt);
  }
  for (Ball& ball : balls) {
    if (ball.present) ball.body.p_W = position_at(ball.motion, dt - ball.start);
  }
  return Status::kOk;
}

std::uint32_t price_scene_contacts() {
  return report.collisions;
}

std::uint32_t price_scene_state() {
  std::uint32_t hash = price::kEmptyHash;
  for (const Ball& ball : balls) hash = price::mixed(hash, ball.body);
  return hash;
}
