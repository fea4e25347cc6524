// SPDX-License-Identifier: MIT
// A hand feels a post. The stick leads a ball, the world keeps the ball out of the post, and a
// spring between where the hand wants the ball and where it is becomes the force on the stick,
// through the output stage, until the emergency stop. The stick is simulated: no hardware.
#include <cstdio>

#include "batuta/control/stick.hpp"
#include "batuta/haptics/coupling.hpp"
#include "batuta/haptics/output_stage.hpp"
#include "batuta/world/any_controller.hpp"
#include "batuta/world/make_actor.hpp"
#include "batuta/world/scenes.hpp"
#include "batuta/world/world.hpp"
#include "shared/simulated/stick.hpp"
using namespace batuta;

using Lead = Hand<float>;  // carries a body to a target by the end of each step
using Touch = Scene<two_blades, Advancement<float>, AnyController<float, Fixed<float>, Lead>>;
constexpr float kScale = 0.2F;  // m that the ball moves for each unit of the stick

struct Loop {
  port_simulated::SimulatedStick stick;
  haptics::OutputStage stage{stick.force()};
  StickTracker<float> tracker;  // position and velocity of the stick
  World<Touch> world;
  World<Touch>::BodyId ball;

  bool configure() {
    port_simulated::StickSettings device;
    device.x.mass = 0.01;
    device.x.damping = 0.05;
    device.x.hand_stiffness = 5;  // of the arm that leads it, N m for each unit
    device.x.hand_damping = 0.05;
    device.force_limit = 100;  // N m for each unit: what the stage's default gain is made for
    const auto mover = make_actor<Touch>(Capsule<float>::sphere({0, 0, 0}, 0.02F), 1000.0F, {});
    ball = world.add(mover.value).value;
    Actor<Touch> post;  // of no inverse mass: nothing moves it
    post.capsule_B = {{{0.14F, 0, -1}, {0.14F, 0, 1}}, 0.02F};
    return mover.ok() && world.get(ball) != nullptr && world.add(post).ok() &&
           stick.configure(device) == Status::kOk && tracker.configure({}) == Status::kOk &&
           stage.configure({}) == Status::kOk && stage.enable() == Status::kOk;
  }

  // What a firmware does each millisecond.
  Status tick() {
    InputSample sample;
    haptics::StageInput input;
    input.time = stick.now();
    input.fresh_sample = stick.input().read(stick.now(), sample) == Status::kOk;
    if (input.fresh_sample) (void)tracker.accept(sample);  // what it refuses, its report() counts
    tracker.advance(1e-3F);
    input.position = tracker.position();
    input.velocity = tracker.velocity();
    const haptics::MovingFrame<float> wanted = {{{kScale * input.position.x(), 0, 0}}, {}};
    world.get(ball)->controller = Lead{wanted.X_W, 1e-3F};
    if (world.step(1e-3F) != Status::kOk || !world.report().complete()) return Status::kDegenerate;
    const Body<float>& body = world.get(ball)->body;
    const haptics::CouplingSettings<float> spring{200, 0};  // N/m, and no damper
    const auto wrench = coupling_wrench(spring, wanted, {body.X_WB, twist_of(body)});
    input.demanded.x() = kScale * wrench.force_W.x();  // the same power at stick and ball
    input.fresh_command = true;
    return stage.step(input);
  }
};

int main() {
  Loop loop;
  if (!loop.configure()) return 1;
  for (int ms = 1; ms <= 5000; ++ms) {  // the arm goes further than the post lets the ball go
    loop.stick.advance({ms < 1000 ? 0.8e-3 * ms : 0.8, 0});
    if (loop.tick() != (ms <= 3000 ? Status::kOk : Status::kUnavailable)) return 1;
    if (ms == 500 || ms == 3000 || ms == 3001 || ms == 5000) {
      std::printf("%4d ms: stick at %.4f, ball at %.4f m, force %.4f N m for each unit\n", ms,
                  loop.stick.x().position(),
                  static_cast<double>(loop.world.get(loop.ball)->body.X_WB.p_W.x()),
                  loop.stick.held().x());
    }
    if (ms == 3000) loop.stage.stop(loop.stick.now());
  }
}
