// SPDX-License-Identifier: MIT
// StraightSpheres as one writes it by hand: the same answers for the same eight balls, from the
// kernels alone. Every round searches all pairs over the rest of the step and moves everybody to
// the first contact; of contacts that are near already, the lowest pair is first. A ball that is
// not finite is left out. Where a search has no answer, or there are more than kMaxContacts, the
// two go on with their common velocity; all are counted.

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
  unsigned group = 0;  ///< who goes on together: a bit for each
};

struct Meeting {
  int pair = 0;  ///< kBalls a + b
  Outcome outcome = Outcome::kFree;
  float t_free = 0;
};

Ball balls[kBalls];
StepReport<float> report;
float left_s;

bool is_usable(const Ball& ball) {
  const StraightBody<float>& body = ball.body;
  return is_finite(ball.radius) && ball.radius >= 0.F && ball.restitution >= 0.F &&
         ball.restitution <= 1.F && is_finite(body.p_W) && is_finite(body.momentum_W) &&
         is_finite(body.inverse_mass) && body.inverse_mass >= 0.F &&
         can_hold(body.p_W, ball.radius);
}

bool is_contact(Outcome outcome) {
  return outcome == Outcome::kContact || outcome == Outcome::kTouching;
}

void aim(Ball& ball) {
  for (int i = 0; i < 3; ++i) ball.v_W[i] = ball.body.inverse_mass * ball.body.momentum_W[i];
}

/// What is too fast for the numbers stands, with the momentum that it has.
void begin(int i) {
  Ball& ball = balls[i];
  ball.group = 1U << i;
  ball.present = is_usable(ball);
  ball.moves = ball.present && ball.body.inverse_mass > 0.F;
  aim(ball);
  const bool is_too_fast = ball.present && !is_finite(ball.v_W);
  if (is_too_fast) {
    ball.v_W.setZero();
    ball.moves = false;
    report.time_held = left_s;
  }
  if (is_too_fast || !ball.present) ++report.plans_invalid;
}

/// Balls that touch and part are free for good; they also part where rounding is all by which they
/// approach, and that is not more than half of their gap.
SphereResult<float> search(const Ball& A, const Ball& B) {
  SphereFlight<float> flight;
  float pace = 0;
  for (int i = 0; i < 3; ++i) {
    flight.between[i] = B.body.p_W[i] - A.body.p_W[i];
    flight.v[i] = B.v_W[i] - A.v_W[i];
    pace += std::abs(A.v_W[i]) + std::abs(B.v_W[i]);
  }
  flight.radii = A.radius + B.radius;
  flight.duration = left_s;
  SphereResult<float> answer = search_spheres(flight, 0.F);
  const float noise = 16 * kRoundOff<float> * (pace * left_s);
  const float slack = max_of(min_of(noise, answer.gap / 2), 0.F);
  const bool closes = answer.closing > slack * flight.radii;
  if (answer.outcome == Outcome::kTouching && !closes) answer.outcome = Outcome::kFree;
  return answer;
}

bool may_meet(int a, int b) {
  const Ball& A = balls[a];
  const Ball& B = balls[b];
  return a < b && A.present && B.present && (A.moves || B.moves) && (A.group & (1U << b)) == 0;
}

/// @param is_begin  of the step: then it is told who is in each other
Meeting first_meeting(bool is_begin) {
  float near_after[kBalls * kBalls];
  Meeting first;
  first.t_free = left_s;
  for (int pair = 0; pair < kBalls * kBalls; ++pair) {
    near_after[pair] = std::numeric_limits<float>::max();
    if (!may_meet(pair / kBalls, pair % kBalls)) continue;
    const auto answer = search(balls[pair / kBalls], balls[pair % kBalls]);
    ++report.pairs;
    ++report.evaluations;
    if (is_begin && answer.gap < 0.F) {
      ++report.overlaps_at_start;
      report.deepest_overlap = max_of(report.deepest_overlap, -answer.gap);
    }
    if (is_contact(answer.outcome)) {
      near_after[pair] = answer.t_free - (answer.t_hit - answer.t_free);
    }
    if (answer.outcome != Outcome::kFree && answer.t_free < first.t_free) {
      first = {pair, answer.outcome, answer.t_free};
    }
  }
  if (is_contact(first.outcome)) {
    first.pair = 0;
    while (first.t_free < near_after[first.pair]) ++first.pair;  // Bound: kBalls^2
  }
  return first;
}

void hit(Ball& A, Ball& B) {
  Vec3<float> normal;
  float square = 0;
  for (int i = 0; i < 3; ++i) {
    normal[i] = A.body.p_W[i] - B.body.p_W[i];
    square += normal[i] * normal[i];
  }
  normal /= std::sqrt(square);
  const auto done =
      detail::straight_impulse(A.body, B.body, normal, max_of(A.restitution, B.restitution));
  if (done.impulse > 0.F) ++report.collisions;
  aim(A);
  aim(B);
}

/// The two, and who goes with one of them already; where one of the two stands, all do.
void go_together(const Ball& A, const Ball& B) {
  const unsigned group = A.group | B.group;
  const bool goes = A.moves && B.moves;
  float mass = 0;
  Vec3<float> sum_W = Vec3<float>::Zero();
  for (int i = 0; i < kBalls; ++i) {
    const Ball& ball = balls[i];
    if ((group & (1U << i)) == 0 || !ball.moves) continue;
    mass += 1 / ball.body.inverse_mass;
    sum_W += ball.body.momentum_W;
  }
  for (int i = 0; i < kBalls; ++i) {
    Ball& ball = balls[i];
    if ((group & (1U << i)) == 0 || !ball.moves) continue;
    const float share = goes ? 1 / (mass * ball.body.inverse_mass) : 0.F;
    ball.body.momentum_W = share * sum_W;
    ball.moves = goes;
    ball.group = group;
    aim(ball);
  }
  report.time_held = max_of(report.time_held, left_s);
}

void answer(const Meeting& meeting, int& contacts) {
  const int a = meeting.pair / kBalls;
  const int b = meeting.pair % kBalls;
  if (is_contact(meeting.outcome)) {
    const bool are_alone = balls[a].group == 1U << a && balls[b].group == 1U << b;
    if (contacts == kMaxContacts) {
      ++report.contacts_dropped;
    } else {
      ++contacts;
      if (are_alone) return hit(balls[a], balls[b]);
    }
  } else if (meeting.outcome == Outcome::kBudget) {
    ++report.searches_cut;
  } else {
    ++report.searches_invalid;
  }
  go_together(balls[a], balls[b]);
}

void run_round(bool is_begin, int& contacts) {
  const Meeting meeting = first_meeting(is_begin);
  for (Ball& ball : balls) {
    // A blow may have left a speed beyond the numbers: no time, no way.
    if (!ball.moves || !(meeting.t_free > 0.F)) continue;
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
  for (int i = 0; i < kBalls; ++i) begin(i);
  int contacts = 0;
  for (int round = 0; round < kMaxRounds && left_s > 0.F; ++round) {
    run_round(round == 0, contacts);
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
