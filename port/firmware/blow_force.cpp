// SPDX-License-Identifier: MIT

#include "firmware/blow_force.hpp"

namespace batuta::firmware {

Momentum<float> blow_about(const Vec3<float>& p_W, Side side, const DuelEvents& events) {
  Momentum<float> blow;
  const float sign = side == Side::kLeft ? 1.0F : -1.0F;  // slot 0, body A, is the left blade
  for (const auto& event : events) {                      // Bound: DuelScene::kMaxEvents
    const Vec3<float> impulse_W = (sign * event.impulse) * event.contact.normal_BA_W;
    blow.p_W += impulse_W;
    blow.b_W += (event.contact.point_W - p_W).cross(impulse_W);
  }
  return blow;
}

Vec2<float> stick_force(const StickJacobian<float>& jacobian, const Momentum<float>& blow,
                        float dt) {
  Vec2<float> force;
  for (int i = 0; i < 2; ++i) {  // Bound: the stick's coordinates
    const Vec3<float> along = jacobian.col(i).head<3>();
    const Vec3<float> about = jacobian.col(i).tail<3>();
    force[i] = (along.dot(blow.p_W) + about.dot(blow.b_W)) / dt;
  }
  return force;
}

ForceShare as_share(const Vec2<float>& force, float full_scale) {
  if (!is_finite(force)) return {Vec2<float>::Zero(), true};
  const float largest = max_of(std::abs(force.x()), std::abs(force.y()));
  if (largest <= full_scale) return {force / full_scale, false};
  // First to the range, then to the unit: the larger coordinate becomes 1 exactly, whatever it was.
  const auto to_unit = [&](float x) { return clamp(x / largest, -1.0F, 1.0F); };
  return {{to_unit(force.x()), to_unit(force.y())}, true};
}

}  // namespace batuta::firmware
