// SPDX-License-Identifier: MIT
#include "plans.hpp"

#include <cmath>

#include "batuta/mechanics/body.hpp"
#include "draws.hpp"

namespace batuta::worlds {
namespace {

constexpr double kDensity = 1000;
constexpr double kWallRadius = 0.12;
constexpr double kWallSpacing = 0.2;
constexpr double kSide = 0.70710678118654752;  // of a quarter turn
/// The turns that take z to x, y and z.
constexpr Quaternion kFromZ[] = {{kSide, 0, kSide, 0}, {kSide, -kSide, 0, 0}, {1, 0, 0, 0}};

Triple triple(const Vec3<double>& x) {
  return {x.x(), x.y(), x.z()};
}
Quaternion quaternion(const Quat<double>& q) {
  return {q.w(), q.x(), q.y(), q.z()};
}

BodyPlan solid(double half_length, double radius, double density = kDensity) {
  const Capsule<double> shape{{{0, 0, -half_length}, {0, 0, half_length}}, radius};
  const auto mass = solid_capsule(shape, density).value;
  BodyPlan body;
  body.half_length = half_length;
  body.radius = radius;
  body.mass = mass.mass;
  body.moment_across = mass.inertia_S(0, 0);
  body.moment_along = mass.inertia_S(2, 2);
  return body;
}

/// A wall of fixed capsules across `axis`, whose own axes lie along the next one.
void add_wall(Plan& plan, int axis, double at) {
  const int along = (axis + 1) % 3;
  const int over = (axis + 2) % 3;
  for (double x = -kHalfCage; x < kHalfCage + kWallSpacing / 2; x += kWallSpacing) {
    BodyPlan body;
    body.half_length = kHalfCage;
    body.radius = kWallRadius;
    Vec3<double> place = Vec3<double>::Zero();
    place[axis] = at;
    place[over] = x;
    body.start.place = triple(place);
    body.start.turn = kFromZ[along];
    plan.bodies.push_back(body);
  }
}

Capsule<double> shape_of(const BodyPlan& body) {
  const auto& q = body.start.turn;
  const auto& p = body.start.place;
  return to_world<double>({{p[0], p[1], p[2]}, {q[0], q[1], q[2], q[3]}},
                          {{{0, 0, -body.half_length}, {0, 0, body.half_length}}, body.radius});
}

/// Movers of a shape at random in a box, free of each other.
void add_movers(Plan& plan, test::Draws& draws, int count, const BodyPlan& shape,
                const Vec3<double>& half, double speed) {
  while (static_cast<int>(plan.bodies.size()) < count) {
    BodyPlan body = shape;
    const double x = draws.signed_unit();
    const double y = draws.signed_unit();
    const double z = draws.signed_unit();
    const Quat<double> q_WB = draws.rotation();
    const Vec3<double> v = draws.in_ball(speed);
    const Vec3<double> w = draws.in_ball(5 * speed);
    body.start = {triple(half.cwiseProduct(Vec3<double>(x, y, z))), quaternion(q_WB), triple(v),
                  triple(w)};
    bool is_free = true;
    for (const BodyPlan& other : plan.bodies) {
      is_free = is_free && capsule_gap(shape_of(body), shape_of(other)).gap > 0.01;
    }
    if (is_free) plan.bodies.push_back(body);
  }
}

Plan cage(test::Draws& draws) {
  Plan plan;
  plan.restitution = 1;
  add_movers(plan, draws, kMovers, solid(0.1, 0.03), {0.7, 0.7, 0.7}, 2);
  for (int axis = 0; axis < 3; ++axis) {
    add_wall(plan, axis, -kHalfCage);
    add_wall(plan, axis, kHalfCage);
  }
  return plan;
}

Plan pile(test::Draws& draws) {
  Plan plan;
  plan.gravity = {0, 0, -9.81};
  plan.friction = 0.5;
  plan.may_sleep = true;
  add_movers(plan, draws, kMovers, solid(0.1, 0.03), {0.5, 0.5, 0.7}, 0.2);
  add_wall(plan, 2, -kHalfCage);
  for (int axis = 0; axis < 2; ++axis) {
    add_wall(plan, axis, -kHalfCage);
    add_wall(plan, axis, kHalfCage);
  }
  return plan;
}

/// Pairs 1 m from each other along y; a rod is shot along x at one across its way.
Plan volley(test::Draws& draws) {
  Plan plan;
  plan.restitution = 1;
  for (int i = 0; i < kMovers / 2; ++i) {
    BodyPlan shot = solid(0.1, 0.01);
    const double off = draws.between(-0.05, 0.05);
    const double back = draws.between(1, 2);
    shot.start = {{-back, static_cast<double>(i), off}, kFromZ[0], {50, 0, 0}, {}};
    BodyPlan target = solid(0.1, 0.01);
    target.start.place[1] = i;
    plan.bodies.push_back(shot);
    plan.bodies.push_back(target);
  }
  return plan;
}

}  // namespace

const char* name(Play play) {
  constexpr const char* kNames[] = {"cage", "pile", "volley"};
  return kNames[static_cast<int>(play)];
}

double duration(Play play) {
  constexpr double kDurations[] = {10, 6, 0.1};
  return kDurations[static_cast<int>(play)];
}

Plan draw(Play play, std::uint64_t number) {
  test::Draws draws(2006, static_cast<std::uint64_t>(play), number);
  if (play == Play::kCage) return cage(draws);
  return play == Play::kPile ? pile(draws) : volley(draws);
}

Plan draw_bars(int bodies, std::uint64_t number) {
  constexpr int kLogs = 8;
  constexpr int kInLayer = 4;
  constexpr double kWood = 700;  // kg/m^3
  test::Draws draws(2007, static_cast<std::uint64_t>(bodies), number);
  Plan plan;
  plan.gravity = {0, 0, -9.81};
  plan.restitution = 0.2;
  plan.friction = 0.5;
  for (int i = 0; i < kLogs; ++i) {
    BodyPlan log;
    log.half_length = 1.5;
    log.radius = 0.06;
    log.start.place = {0.12 * (i - 3.5), 0, -0.06};
    log.start.turn = kFromZ[1];
    plan.bodies.push_back(log);
  }
  for (int i = 0; i < bodies - kLogs; ++i) {
    const int layer = i / kInLayer;
    const bool is_odd = layer % 2 == 1;
    const double aside = 0.08 * (i % kInLayer - 1.5);
    const double along = draws.between(-0.01, 0.01);
    const double half_yaw = draws.between(-0.05, 0.05);
    BodyPlan bar = solid(0.15, 0.03, kWood);
    bar.start.place = {is_odd ? aside : along, is_odd ? along : aside, 0.04 + 0.065 * layer};
    const auto& q = kFromZ[is_odd ? 1 : 0];
    const Quat<double> yaw(std::cos(half_yaw), 0, 0, std::sin(half_yaw));
    bar.start.turn = quaternion(yaw * Quat<double>(q[0], q[1], q[2], q[3]));
    plan.bodies.push_back(bar);
  }
  return plan;
}

double half_cube(int bodies) {
  return 0.25 * std::cbrt(bodies);
}

Plan draw_crowd(int bodies, std::uint64_t number) {
  test::Draws draws(2008, static_cast<std::uint64_t>(bodies), number);
  Plan plan;
  plan.restitution = 1;
  const double half = half_cube(bodies);
  add_movers(plan, draws, bodies, solid(0.1, 0.02), {half, half, half}, 1);
  return plan;
}

}  // namespace batuta::worlds
