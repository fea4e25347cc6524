// SPDX-License-Identifier: MIT

#include "batuta/haptics/force_map.hpp"

namespace batuta::haptics {

template <class Scalar>
Wrench<Scalar> moved(const Wrench<Scalar>& about_from, const Vec3<Scalar>& p_from_W,
                     const Vec3<Scalar>& p_to_W) {
  return {about_from.force_W, about_from.moment_W + (p_from_W - p_to_W).cross(about_from.force_W)};
}

template <class Scalar>
Vec2<Scalar> stick_force(const StickJacobian<Scalar>& jacobian, const Wrench<Scalar>& wrench) {
  Vec2<Scalar> force;
  for (int i = 0; i < 2; ++i) {  // Bound: the stick's coordinates
    const Vec3<Scalar> along = jacobian.col(i).template head<3>();
    const Vec3<Scalar> about = jacobian.col(i).template tail<3>();
    force[i] = along.dot(wrench.force_W) + about.dot(wrench.moment_W);
  }
  return force;
}

#define BATUTA_INSTANTIATE(S)                                                 \
  template Wrench<S> moved(const Wrench<S>&, const Vec3<S>&, const Vec3<S>&); \
  template Vec2<S> stick_force(const StickJacobian<S>&, const Wrench<S>&);
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta::haptics
