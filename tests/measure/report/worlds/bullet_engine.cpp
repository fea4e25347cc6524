// SPDX-License-Identifier: MIT
// Bullet: btDiscreteDynamicsWorld with its default solver and broad phase, in the package's double
// build. Masses, moments, restitution and friction are the plan's: Bullet multiplies those of two
// bodies, so each gets the square root. Damping is off, as nothing in the plans damps; the solver's
// threshold of restitution is that below which the library calls a contact resting (0.01 m/s).

#include <btBulletDynamicsCommon.h>

#include <cmath>

#include "engine.hpp"

namespace batuta::worlds {
namespace {

constexpr double kRestSpeed = 0.01;

btVector3 vector(const Triple& x) {
  return {x[0], x[1], x[2]};
}
Triple triple(const btVector3& x) {
  return {x.x(), x.y(), x.z()};
}

enum class Way : std::uint8_t {
  kDefault,
  kTouching,  ///< contacts count once they touch, not from 2 cm before: else short steps take the
              ///< rebound away
  kSwept,     ///< continuous detection: a ball of 0.9 radius swept beyond half a radius a step
};

struct Pace {
  const char* name;
  int hz;  ///< steps a second
  Way way;
};

/// A world and what it points at, in the order in which it has to go.
class Stage {
 public:
  Stage(const Plan& plan, const Pace& pace) {
    world_.setGravity(vector(plan.gravity));
    world_.getSolverInfo().m_restitutionVelocityThreshold = kRestSpeed;
    for (const BodyPlan& body : plan.bodies) add(plan, body, pace);
  }
  ~Stage() {
    for (const auto& body : bodies_) world_.removeRigidBody(body.get());
  }
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  void step(double dt) { world_.stepSimulation(dt, 0); }
  const btRigidBody& body(int i) const { return *bodies_[static_cast<std::size_t>(i)]; }
  btRigidBody& body(int i) { return *bodies_[static_cast<std::size_t>(i)]; }

 private:
  void add(const Plan& plan, const BodyPlan& given, const Pace& pace) {
    shapes_.push_back(std::make_unique<btCapsuleShapeZ>(given.radius, 2 * given.half_length));
    const btVector3 moments(given.moment_across, given.moment_across, given.moment_along);
    btRigidBody::btRigidBodyConstructionInfo info(given.mass, nullptr, shapes_.back().get(),
                                                  given.mass > 0 ? moments : btVector3(0, 0, 0));
    const Quaternion& q = given.start.turn;
    info.m_startWorldTransform =
        btTransform(btQuaternion(q[1], q[2], q[3], q[0]), vector(given.start.place));
    info.m_restitution = std::sqrt(plan.restitution);
    info.m_friction = std::sqrt(plan.friction);
    auto body = std::make_unique<btRigidBody>(info);
    body->setLinearVelocity(vector(given.start.v));
    body->setAngularVelocity(vector(given.start.w));
    if (!plan.may_sleep) body->setActivationState(DISABLE_DEACTIVATION);
    if (pace.way == Way::kTouching) body->setContactProcessingThreshold(0);
    if (pace.way == Way::kSwept) {
      body->setCcdMotionThreshold(given.radius / 2);
      body->setCcdSweptSphereRadius(given.radius * 0.9);
    }
    world_.addRigidBody(body.get());
    bodies_.push_back(std::move(body));
  }

  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
};

class BulletEngine : public Engine {
 public:
  explicit BulletEngine(const Pace& pace) : pace_(pace) {}

  std::string name() const override { return pace_.name; }
  std::string setting() const override {
    constexpr const char* kWays[] = {"no more", "setContactProcessingThreshold(0)",
                                     "setCcdMotionThreshold(radius / 2) and a swept sphere"};
    return "double; " + std::to_string(pace_.hz) + " steps a second; " +
           kWays[static_cast<int>(pace_.way)];
  }
  int steps_per_second() const override { return pace_.hz; }
  void load(const Plan& plan) override { stage_ = std::make_unique<Stage>(plan, pace_); }
  void step() override { stage_->step(1.0 / pace_.hz); }
  BodyState state(int i) const override {
    const btRigidBody& body = stage_->body(i);
    const btQuaternion q = body.getWorldTransform().getRotation();
    return {triple(body.getWorldTransform().getOrigin()),
            {q.w(), q.x(), q.y(), q.z()},
            triple(body.getLinearVelocity()),
            triple(body.getAngularVelocity())};
  }
  void mirror(int i, int axis) override {
    btRigidBody& body = stage_->body(i);
    btVector3 v = body.getLinearVelocity();
    v[axis] = -v[axis];
    body.setLinearVelocity(v);
  }

 private:
  Pace pace_;
  std::unique_ptr<Stage> stage_;
};

}  // namespace

std::vector<EnginePtr> bullet_engines() {
  std::vector<EnginePtr> engines;
  constexpr Pace kPaces[] = {{"Bullet 60", 60, Way::kDefault},
                             {"Bullet 240", 240, Way::kDefault},
                             {"Bullet 1000", 1000, Way::kDefault},
                             {"Bullet 60 touching", 60, Way::kTouching},
                             {"Bullet 1000 touching", 1000, Way::kTouching},
                             {"Bullet 60 swept", 60, Way::kSwept}};
  for (const Pace& pace : kPaces) {
    engines.push_back(std::make_unique<BulletEngine>(pace));
  }
  return engines;
}

EnginePtr bullet_engine(int hz) {
  return std::make_unique<BulletEngine>(Pace{"Bullet", hz, Way::kDefault});
}

}  // namespace batuta::worlds
