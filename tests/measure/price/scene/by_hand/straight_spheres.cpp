// SPDX-License-Identifier: MIT
// StraightSpheres as one writes it by hand: the same answers for the same eight balls, from the
// kernels alone. Every round searches all pairs over the rest of the step and moves everybody to
// the first contact; ties go to the lower pair. A ball that is not finite is left out, a pair whose
// search has no answer stops, and so does one beyond kMaxContacts; all are counted.

#include "../runs.hpp"
#include "../scene.hpp"
#include "batuta/detection/sphere_flight.hpp"
#include "batuta/response/straight_impulse.hpp"
#include "batuta/world/event.hpp"

namespace {

using namespace batuta;

constexpr int kBalls = price::kBalls;
constexpr int kMaxContacts = 8;
constexpr int kMaxRounds = kMaxContacts + kBalls + 1;

struct Ball {
  StraightBody<float> body;
  float radius = 0;
  float restitution = 0;
  // Of the step.
  Vec3<float> v_W = Vec3<float>::Zero();
  bool present = false;
  bool moves = false;
};

struct Meeting {
  int a = 0;
  int b = 0;
  Outcome outcome = Outcome::kFree;
  float t_free = 0;
  float t_hit = 0;
};

Ball balls[kBalls];
StepReport<float> report;
float left_s;

bool is_usable(const Ball& ball) {
  const StraightBody<float>& body = ball.body;
  return is_finite(ball.radius) && ball.radius >= 0.F && ball.restitution >= 0.F &&
         ball.restitution <= 1.F && is_finite(body.p_W) && is_finite(body.momentum_W) &&
         is_finite(body.inverse_mass) && body.inverse_mass >= 0.F;
}

bool is_contact(Outcome outcome) {
  return outcome == Outcome::kContact || outcome == Outcome::kTouching;
}

void hold(Ball& ball) {
  ball.v_W.setZero();
  ball.moves = false;
  report.time_held = max_of(report.time_held, left_s);
}

void begin(Ball& ball) {
  ball.v_W.setZero();
  ball.present = is_usable(ball);
  ball.moves = ball.present && ball.body.inverse_mass > 0.F;
  if (!ball.present) ++report.plans_invalid;
}

void aim(Ball& ball) {
  if (!ball.moves) return;
  for (int i = 0; i < 3; ++i) ball.v_W[i] = ball.body.inverse_mass * ball.body.momentum_W[i];
  if (is_finite(ball.v_W)) return;
  ++report.plans_invalid;
  hold(ball);
}

SphereResult<float> search(const Ball& A, const Ball& B) {
  SphereFlight<float> flight;
  for (int i = 0; i < 3; ++i) {
    flight.between[i] = B.body.p_W[i] - A.body.p_W[i];
    flight.v[i] = B.v_W[i] - A.v_W[i];
  }
  flight.radii = A.radius + B.radius;
  flight.duration = left_s;
  SphereResult<float> answer = search_spheres(flight, 0.F);
  const bool parts = answer.outcome == Outcome::kTouching && !(flight.between.dot(flight.v) < 0.F);
  if (parts) answer.outcome = Outcome::kFree;
  return answer;
}

Meeting first_meeting() {
  float contact_after[kBalls][kBalls];
  Meeting first;
  first.t_free = left_s;
  for (int a = 0; a < kBalls; ++a) {
    for (int b = 0; b < kBalls; ++b) {
      contact_after[a][b] = std::numeric_limits<float>::max();
      const Ball& A = balls[a];
      const Ball& B = balls[b];
      if (a >= b || !A.present || !B.present || !(A.moves || B.moves)) continue;
      const auto answer = search(A, B);
      ++report.pairs;
      ++report.evaluations;
      if (is_contact(answer.outcome)) contact_after[a][b] = answer.t_free;
      if (answer.outcome != Outcome::kFree && answer.t_free < first.t_free) {
        first = {a, b, answer.outcome, answer.t_free, answer.t_hit};
      }
    }
  }
  if (is_contact(first.outcome)) {
    int pair = 0;
    while (first.t_hit < (&contact_after[0][0])[pair]) ++pair;  // Bound: kBalls^2
    first.a = pair / kBalls;
    first.b = pair % kBalls;
  }
  return first;
}

void hit(Ball& A, Ball& B, Outcome outcome) {
  const Vec3<float> to_A = A.body.p_W - B.body.p_W;
  const float distance = to_A.norm();
  const float gap = distance - (A.radius + B.radius);
  Vec3<float> normal = Vec3<float>::UnitX();
  if (distance > 0.F) normal = to_A / distance;
  const auto done =
      detail::straight_impulse(A.body, B.body, normal, max_of(A.restitution, B.restitution));
  if (done.impulse > 0.F) ++report.collisions;
  if (outcome == Outcome::kTouching && !(gap > 0.F)) {
    ++report.overlaps_at_start;
    report.deepest_overlap = max_of(report.deepest_overlap, -gap);
  }
}

void answer(const Meeting& meeting, int& contacts) {
  Ball& A = balls[meeting.a];
  Ball& B = balls[meeting.b];
  if (is_contact(meeting.outcome)) {
    if (contacts++ < kMaxContacts) return hit(A, B, meeting.outcome);
    ++report.contacts_dropped;
  } else if (meeting.outcome == Outcome::kBudget) {
    ++report.searches_cut;
  } else {
    ++report.searches_invalid;
  }
  hold(A);
  hold(B);
}

void run_round(int& contacts) {
  for (Ball& ball : balls) aim(ball);
  const Meeting meeting = first_meeting();
  for (Ball& ball : balls) {
    if (!ball.moves) continue;
    for (int i = 0; i < 3; ++i) ball.body.p_W[i] += ball.v_W[i] * meeting.t_free;
  }
  left_s -= meeting.t_free;
  if (meeting.outcome != Outcome::kFree) answer(meeting, contacts);
}

}  // namespace

bool price_scene_place(float restitution) {
  for (int i = 0; i < kBalls; ++i) {
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
  left_s = dt;
  for (Ball& ball : balls) begin(ball);
  int contacts = 0;
  for (int round = 0; round < kMaxRounds && left_s > 0.F; ++round) run_round(contacts);
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
