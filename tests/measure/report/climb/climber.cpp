// SPDX-License-Identifier: MIT
#include "climber.hpp"

#include <algorithm>
#include <array>

#include "batuta/detection/advancement.hpp"
#include "batuta/mechanics/rotation.hpp"
#include "draws.hpp"

namespace batuta::report {

namespace {

constexpr std::uint64_t kSeed = 20070312;

/// A body in the numbers that a climb changes. Its axis lies along its x-axis.
enum Gene : std::size_t {
  kCenter = 0,     // of mass, m
  kRotation = 3,   // rotation vector, rad
  kVelocity = 6,   // m/s
  kSpin = 9,       // rad/s, cut to the turn of the ground
  kLength = 12,    // of the axis, m
  kPlace = 13,     // of the centre of mass along the axis, 0 ... 1
  kOffset = 14,    // of the axis from the centre of mass, m
  kThickness = 15  // radius, m
};
constexpr std::size_t kGenes = 16;
using Body = std::array<double, kGenes>;
using Bodies = std::array<Body, 2>;

constexpr double kShortest = 0.2;
constexpr double kLongest = 2;
constexpr double kThinnest = 0.02;
constexpr double kFarthestOff = 1.25;

double thickest(Start start) {
  return start == Start::kGeneric ? 0.3 : 0.95;
}

Vec3<double> vector_at(const Body& body, Gene first) {
  return {body[first], body[first + 1], body[first + 2]};
}

void put(Body& body, Gene first, const Vec3<double>& v) {
  for (int i = 0; i < 3; ++i) body[first + static_cast<std::size_t>(i)] = v[i];
}

MovingCapsule<float> capsule_of(const Body& body, const Ground& ground) {
  const double length = std::clamp(body[kLength], kShortest, kLongest);
  const double place = std::clamp(body[kPlace], 0.0, 1.0);
  const double offset = std::clamp(body[kOffset], -kFarthestOff, kFarthestOff);
  const double radius = std::clamp(body[kThickness], kThinnest, thickest(ground.start));
  Vec3<double> spin = vector_at(body, kSpin);
  if (spin.norm() > ground.most_turn) spin *= ground.most_turn / spin.norm();
  MovingCapsule<float> moving;
  moving.capsule_B.axis.a = Vec3<double>(-place * length, offset, 0).cast<float>();
  moving.capsule_B.axis.b = Vec3<double>((1 - place) * length, offset, 0).cast<float>();
  moving.capsule_B.radius = static_cast<float>(radius);
  moving.motion.X_WB.p_W = vector_at(body, kCenter).cast<float>();
  moving.motion.X_WB.q_WB = exp_map<double>(vector_at(body, kRotation)).cast<float>();
  moving.motion.twist.v_W = vector_at(body, kVelocity).cast<float>();
  moving.motion.twist.w_W = spin.cast<float>();
  moving.motion.duration = 1;
  return moving;
}

test::Query query_of(const Bodies& bodies, const Ground& ground) {
  return {capsule_of(bodies[0], ground), capsule_of(bodies[1], ground)};
}

Vec3<double> in_cube(test::Draws& draws, double half) {
  const double x = half * draws.signed_unit();
  const double y = half * draws.signed_unit();
  const double z = half * draws.signed_unit();
  return {x, y, z};
}

Body draw_generic_body(test::Draws& draws, const Ground& ground) {
  Body body{};
  put(body, kRotation, in_cube(draws, 3));
  put(body, kSpin, in_cube(draws, ground.most_turn));
  body[kLength] = draws.between(kShortest, kLongest);
  body[kPlace] = draws.unit();
  body[kThickness] = draws.between(kThinnest, thickest(Start::kGeneric));
  if (draws.chance(0.5)) body[kOffset] = 0.1 * draws.signed_unit();
  return body;
}

/// B flies more or less towards A.
Bodies draw_generic(test::Draws& draws, const Ground& ground) {
  Bodies bodies{};
  for (Body& body : bodies) body = draw_generic_body(draws, ground);
  const Vec3<double> from_A = in_cube(draws, 3);
  const double haste = 2 * draws.unit();
  const Vec3<double> aside = in_cube(draws, 0.3);
  put(bodies[1], kCenter, from_A);
  put(bodies[1], kVelocity, aside - haste * from_A);
  return bodies;
}

/// B's axis goes round A's at a gap of 2^-20 ... 2^-8 m, tilted by up to half a right angle. Both
/// axes are symmetric, so that the nearest points stay in the middle.
Bodies draw_sliding(test::Draws& draws, const Ground& ground) {
  Bodies bodies{};
  const double gap = draws.power_of_two(-20, -8);
  const double tilt = draws.chance(0.25) ? 0 : draws.power_of_two(-8, 0) * 0.78;
  for (Body& body : bodies) {
    body[kLength] = draws.between(kShortest, kLongest);
    body[kPlace] = 0.5;
    body[kThickness] = draws.between(kThinnest, 0.6);
  }
  Body& around = bodies[1];
  around[kRotation + 1] = tilt;
  around[kOffset] = bodies[0][kThickness] + around[kThickness] + gap;
  around[kSpin] = ground.most_turn;
  return bodies;
}

Bodies draw(test::Draws& draws, const Ground& ground) {
  return ground.start == Start::kGeneric ? draw_generic(draws, ground)
                                         : draw_sliding(draws, ground);
}

/// One to three numbers change by 2^-23 ... 1, now and then to zero.
Bodies mutated(test::Draws& draws, const Bodies& from) {
  constexpr double kToZero = 1.0 / 40;
  Bodies bodies = from;
  const std::uint64_t changes = 1 + draws.bits() % 3;
  for (std::uint64_t i = 0; i < changes; ++i) {  // Bound: 3
    double& gene = bodies[draws.bits() % 2][draws.bits() % kGenes];
    const double size = draws.power_of_two(-23, 0);
    gene += size * draws.signed_unit();
    if (draws.chance(kToZero)) gene = 0;
  }
  return bodies;
}

}  // namespace

std::uint32_t evaluations_of(const test::Query& query) {
  const auto pair = make_moving_pair(test::cast<double>(query.A), test::cast<double>(query.B));
  if (!pair.ok()) return 0;
  AdvancementOptions<double> options;
  options.contact_tolerance = kTau / pair.value.scale;
  options.budget = kMaxBudget;
  return search_advancement(pair.value, options).evaluations;
}

Summit climb(const Ground& ground, std::uint64_t index, std::uint64_t mutations) {
  const auto stream = static_cast<std::uint64_t>(ground.most_turn * 1024) * 2 +
                      static_cast<std::uint64_t>(ground.start);
  test::Draws draws(kSeed, stream, index);
  Bodies at{};
  Summit summit;
  for (std::uint64_t i = 0; i < kFirst + mutations; ++i) {  // Bound: as it says
    const Bodies next = i < kFirst ? draw(draws, ground) : mutated(draws, at);
    const test::Query query = query_of(next, ground);
    const std::uint32_t evaluations = evaluations_of(query);
    if (evaluations < summit.evaluations) continue;
    at = next;
    summit = {query, evaluations};
  }
  return summit;
}

}  // namespace batuta::report
