// SPDX-License-Identifier: MIT
// A bat turns about a hinge at a steady rate, whatever it hits, and strikes a ball. The bat is
// moved by a controller that is written here: plain data with three members. AnyController lets the
// ball of the same scene fly freely.
#include <cmath>
#include <cstdio>
#include <limits>

#include "batuta/world/any_controller.hpp"
#include "batuta/world/make_actor.hpp"
#include "batuta/world/world.hpp"
using namespace batuta;

constexpr float kStep = 1e-3F;  // s

// Turns a body about the world's z axis, with its middle 0.5 m from there.
struct Swing {
  float rate = 0;   // rad/s
  float begun = 0;  // when the step began, s
  int blows = 0;    // so far

  Pose<float> pose_at(float time) const {
    const float angle = rate * time;
    const Quat<float> q_WB(std::cos(angle / 2), 0, 0, std::sin(angle / 2));
    return {{0.5F * std::cos(angle), 0.5F * std::sin(angle), 0}, q_WB};
  }

  // From where the body is to where it belongs at the end of the step, in the time that is left,
  // but never in a hurry: after a contact at the very end of a step it comes a little late.
  PlannedMotion<float> plan(const Body<float>& body, float t, float duration) const {
    const float left = max_of(max_of(kStep - t, kLeastHorizon<float> * kStep), duration);
    Motion<float> motion = motion_between(body.X_WB, pose_at(begun + kStep), left);
    motion.duration = duration;
    return {motion, false};  // false: not by the momentum of the body
  }
  void on_contact(const Body<float>& /*body*/, const Feedback<float>& feedback) {
    if (feedback.impulse > 0) ++blows;
  }
  void on_step_end(const Body<float>& /*body*/, float dt) { begun += dt; }
};

constexpr SceneOptions batting() {
  return {};
}
using Batting = Scene<batting, Advancement<float>, AnyController<float, FreeFlight<float>, Swing>>;

int main() {
  const Capsule<float> wood = {{{-0.4F, 0, 0}, {0.4F, 0, 0}}, 0.02F};  // the hinge is 0.1 m away
  Swing swing;
  swing.rate = 3;
  const float fixed = std::numeric_limits<float>::infinity();  // no blow turns the bat aside
  auto bat = make_actor<Batting>(wood, fixed, swing.pose_at(0));
  bat.value.controller = swing;
  auto ball = make_actor<Batting>(Capsule<float>::sphere({0, 0, 0}, 0.05F), 150.0F,
                                  {{0, 0.6F, 0}, Quat<float>::Identity()});
  ball.value.restitution = 0.5F;
  World<Batting> world;
  const auto bat_id = world.add(bat.value);
  const auto ball_id = world.add(ball.value);
  if (!bat.ok() || !ball.ok() || !bat_id.ok() || !ball_id.ok()) return 1;

  for (int millisecond = 0; millisecond < 1000; ++millisecond) {
    if (world.step(kStep) != Status::kOk || !world.report().complete()) return 1;
    for (const auto& event : world.events()) {
      if (event.kind != EventKind::kBegin) continue;
      std::printf("the bat strikes the ball at %.4f s\n",
                  1e-3 * millisecond + static_cast<double>(event.time));
    }
  }
  const Twist<float> flight = twist_of(world.get(ball_id.value)->body);
  const Vec3<float> p_W = world.get(bat_id.value)->body.X_WB.p_W;
  const Swing* swung = world.get(bat_id.value)->controller.as<Swing>();
  if (swung == nullptr) return 1;
  std::printf("the ball flies at (%.4f %.4f %.4f) m/s\n", static_cast<double>(flight.v_W.x()),
              static_cast<double>(flight.v_W.y()), static_cast<double>(flight.v_W.z()));
  std::printf("after 1 s and %d blow the bat is at %.4f rad\n", swung->blows,
              std::atan2(static_cast<double>(p_W.y()), static_cast<double>(p_W.x())));
  return swung->blows == 1 ? 0 : 1;
}
