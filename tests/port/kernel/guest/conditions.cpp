// SPDX-License-Identifier: MIT
// What answers to the stick: where it is, how fast it goes, how fast that changes.

#include "checks.hpp"
#include "effects.hpp"
#include "truth.hpp"

namespace guest {
namespace {

constexpr unsigned short kWhole = 0xFFFF;
/// Full scale of the device: port/shared/hid_pid/device.hpp, Scales.
constexpr double kFullVelocity = 10;
constexpr double kFullAcceleration = 100;
/// The stage of differences in the device has forgotten all else.
constexpr int kLongEnough = 100;

struct Side {
  const char* name;
  Force way;
};
constexpr Side kSides[] = {
    {"right", {1, 0}}, {"left", {-1, 0}}, {"up", {0, 1}}, {"down", {0, -1}}, {"up left", {-1, 1}}};

Force times(const Force& way, double size) {
  return {way.x * size, way.y * size};
}

}  // namespace

void spring(Checks& checks) {
  checks.begin("spring");
  const std::pair<const char*, ff_condition_effect> kinds[] = {
      {"plain", {kWhole, kWhole, 0x6000, 0x6000, 0, 0}},
      {"stiffer on one side", {kWhole, kWhole, 0x6000, 0x3000, 0, 0}},
      {"saturated", {0x5000, 0x2000, 0x7FFF, 0x7FFF, 0, 0}},
      {"dead band", {kWhole, kWhole, 0x7000, 0x7000, 0x3000, 0}},
      {"from a centre", {kWhole, kWhole, 0x5000, 0x5000, 0x1000, 0x2000}}};
  for (const auto& [name, condition] : kinds) {
    ff_effect e = conditional(FF_SPRING, condition);
    checks.start(e);
    for (const Side& side : kSides) {
      const Force at = times(side.way, 0.75);
      checks.force(std::string(name) + ", " + side.name, conditions(e, at),
                   checks.line.move(1, {at, {}, {}}).force);
    }
    checks.force(std::string(name) + ", a little right", conditions(e, {0.1, 0}),
                 checks.line.move(1, {{0.1, 0}, {}, {}}).force);
    checks.end(e);
  }
  ff_effect e = conditional(FF_SPRING, kinds[0].second);
  e.u.condition[1].right_coeff = e.u.condition[1].left_coeff = 0x2000;
  checks.start(e);
  const Force at{0.5, 0.5};
  checks.force("unlike axes", conditions(e, at), checks.line.move(1, {at, {}, {}}).force);
  checks.end(e);
}

void motion(Checks& checks) {
  const ff_condition_effect plain = {kWhole, kWhole, 0x6000, 0x4000, 0, 0};
  const double speed = 0.4 * kFullVelocity;
  for (const auto& [name, type] :
       {std::pair("damper", FF_DAMPER), std::pair("friction", FF_FRICTION),
        std::pair("inertia", FF_INERTIA)}) {
    checks.begin(name);
    ff_effect e = conditional(type, plain);
    checks.start(e);
    for (const Side& side : kSides) {
      Movement movement;
      Force share = times(side.way, 0.4);
      if (type == FF_INERTIA) {
        movement.acceleration = times(side.way, 0.4 * kFullAcceleration);
      } else {
        movement.velocity = times(side.way, speed);
      }
      // Friction does not grow with the speed: beyond its knee it is whole.
      if (type == FF_FRICTION) share = side.way;
      checks.force(side.name, conditions(e, share), checks.line.move(kLongEnough, movement).force);
    }
    checks.later("at rest", kLongEnough, {});
    checks.end(e);
  }
}

}  // namespace guest
