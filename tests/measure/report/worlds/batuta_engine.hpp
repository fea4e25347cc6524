// SPDX-License-Identifier: MIT
#pragma once
// The library's world as an engine, whatever its scene: in float, with what the plan says of the
// surfaces where the scene has a place for it.

#include "batuta/world/world.hpp"
#include "engine.hpp"

namespace batuta::worlds {

template <class SceneT>
class BatutaEngine : public Engine {
 public:
  explicit BatutaEngine(int hz) : hz_(hz) {}

  std::string name() const override { return "batuta " + std::to_string(hz_); }
  std::string setting() const override {
    return "float; " + std::to_string(hz_) + " steps a second; defaults";
  }
  int steps_per_second() const override { return hz_; }

  void load(const Plan& plan) override {
    world_ = std::make_unique<World<SceneT>>();
    if constexpr (SceneT::kGravity) {
      WorldSettings<SceneT> settings;
      settings.gravity_W = vec(plan.gravity);
      (void)world_->configure(settings);
    }
    incomplete_ = 0;
    for (const BodyPlan& body : plan.bodies) (void)world_->add(actor_of(plan, body));
  }
  void step() override {
    (void)world_->step(1.0F / static_cast<float>(hz_));
    incomplete_ += world_->report().complete() ? 0 : 1;
  }
  BodyState state(int body) const override {
    const World<SceneT>& world = *world_;
    const auto& B = world.get(world.id_at(static_cast<std::uint16_t>(body)))->body;
    const Quat<float>& q = B.X_WB.q_WB;
    const Twist<float> twist = twist_of(B);
    return {triple(B.X_WB.p_W),
            {double{q.w()}, double{q.x()}, double{q.y()}, double{q.z()}},
            triple(twist.v_W),
            triple(twist.w_W)};
  }
  void mirror(int body, int axis) override {
    auto* actor = world_->get(world_->id_at(static_cast<std::uint16_t>(body)));
    actor->body.momentum.linear_W[axis] *= -1.0F;
  }
  int incomplete() const override { return incomplete_; }
  std::size_t bytes() const override { return sizeof(World<SceneT>); }

 private:
  static Vec3<float> vec(const Triple& x) { return Vec3<double>(x[0], x[1], x[2]).cast<float>(); }
  static Triple triple(const Vec3<float>& x) {
    return {double{x.x()}, double{x.y()}, double{x.z()}};
  }

  static Actor<SceneT> actor_of(const Plan& plan, const BodyPlan& body) {
    Actor<SceneT> actor;
    const auto half = static_cast<float>(body.half_length);
    actor.capsule_B = {{{0, 0, -half}, {0, 0, half}}, static_cast<float>(body.radius)};
    actor.restitution = static_cast<float>(plan.restitution);
    if constexpr (SceneT::kFriction) actor.friction = static_cast<float>(plan.friction);
    const auto& q = body.start.turn;
    const Quat<float> q_WB = Quat<double>(q[0], q[1], q[2], q[3]).cast<float>();
    const Pose<float> X_WB = {vec(body.start.place), q_WB};
    actor.body.X_WB = X_WB;
    if (body.mass > 0) {
      const auto across = static_cast<float>(body.moment_across);
      const auto along = static_cast<float>(body.moment_along);
      actor.body =
          make_body<float>(X_WB, static_cast<float>(body.mass), {across, across, along}).value;
      actor.body.momentum = momentum_of(actor.body, {vec(body.start.v), vec(body.start.w)});
    }
    return actor;
  }

  int hz_;
  int incomplete_ = 0;
  std::unique_ptr<World<SceneT>> world_;
};

}  // namespace batuta::worlds
