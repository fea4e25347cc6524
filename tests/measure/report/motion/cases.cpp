// SPDX-License-Identifier: MIT
#include "cases.hpp"

#include "batuta/mechanics/solid.hpp"

namespace batuta::worlds {
namespace {

constexpr double kSide = 0.70710678118654752;  // of a quarter turn
constexpr Quaternion kToX = {kSide, 0, kSide, 0};
constexpr Quaternion kToY = {kSide, -kSide, 0, 0};

BodyPlan solid(double half_length, double radius, const Triple& place,
               const Quaternion& turn = {1, 0, 0, 0}) {
  constexpr double kDensity = 700;
  const Capsule<double> shape{{{0, 0, -half_length}, {0, 0, half_length}}, radius};
  const auto mass = solid_capsule(shape, kDensity).value;
  BodyPlan body;
  body.half_length = half_length;
  body.radius = radius;
  body.mass = mass.mass;
  body.moment_across = mass.inertia_S(0, 0);
  body.moment_along = mass.inertia_S(2, 2);
  body.start.place = place;
  body.start.turn = turn;
  return body;
}

BodyPlan fixed(double half_length, double radius, const Triple& place, const Quaternion& turn) {
  BodyPlan body = solid(half_length, radius, place, turn);
  body.mass = body.moment_across = body.moment_along = 0;
  return body;
}

Plan bounce() {
  Plan plan;
  plan.gravity = {0, 0, -9.81};
  plan.restitution = 1;
  plan.bodies.push_back(solid(0, 0.05, {0, 0, 1.05}));
  plan.bodies.push_back(fixed(5, 0.05, {0, 0, -0.05}, kToX));
  return plan;
}

Plan row() {
  Plan plan;
  plan.restitution = 0.5;
  for (int i = 0; i < 5; ++i) {
    BodyPlan ball = solid(0, 0.05, {0.105 * i, 0, 0});
    ball.start.v = {25.05 - 0.025 * i, 0, 0};
    plan.bodies.push_back(ball);
  }
  return plan;
}

Plan tumble() {
  Plan plan;
  BodyPlan rod = solid(0.3, 0.03, {0, 0, 0});
  rod.start.w = {6, 0, 8};
  plan.bodies.push_back(rod);
  return plan;
}

Plan stack() {
  Plan plan;
  plan.gravity = {0, 0, -9.81};
  plan.friction = 0.5;
  for (int layer = 0; layer < 10; ++layer) {
    for (const double side : {-0.2, 0.2}) {
      const double z = 0.03 + 0.06 * layer + 5e-5 * (layer + 1);
      const bool is_even = layer % 2 == 0;
      plan.bodies.push_back(is_even ? solid(0.3, 0.03, {0, side, z}, kToX)
                                    : solid(0.3, 0.03, {side, 0, z}, kToY));
    }
  }
  for (const double x : {-0.2, 0.2}) plan.bodies.push_back(fixed(0.5, 0.03, {x, 0, -0.03}, kToY));
  return plan;
}

}  // namespace

const char* name(Case which) {
  constexpr const char* kNames[] = {"bounce", "row", "tumble", "stack"};
  return kNames[static_cast<int>(which)];
}

double duration(Case which) {
  constexpr double kDurations[] = {30, 2, 20, 30};
  return kDurations[static_cast<int>(which)];
}

Plan plan_of(Case which) {
  switch (which) {
    case Case::kBounce:
      return bounce();
    case Case::kRow:
      return row();
    case Case::kTumble:
      return tumble();
    case Case::kStack:
      return stack();
  }
  return {};
}

}  // namespace batuta::worlds
