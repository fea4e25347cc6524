// SPDX-License-Identifier: MIT
#include "batuta/response/contact.hpp"

namespace batuta {

template <class Scalar>
Contact<Scalar> contact_from(const CapsuleGap<Scalar>& witness, const Vec3<Scalar>& origin_W) {
  const Vec3<Scalar> to_B = witness.surface_B - witness.surface_A;
  return {origin_W + (witness.surface_A + to_B / 2), -witness.axes.normal_AB, witness.gap};
}

template <class Scalar>
Scalar relative_velocity(const Contact<Scalar>& contact, const Pose<Scalar>& X_WA,
                         const Twist<Scalar>& twist_A, const Pose<Scalar>& X_WB,
                         const Twist<Scalar>& twist_B) {
  const Vec3<Scalar> turning_A = twist_A.w_W.cross(contact.point_W - X_WA.p_W);
  const Vec3<Scalar> turning_B = twist_B.w_W.cross(contact.point_W - X_WB.p_W);
  // Centres first: a velocity that both share is gone before anything is rounded against it.
  return contact.normal_BA_W.dot((twist_A.v_W - twist_B.v_W) + (turning_A - turning_B));
}

template <class Scalar>
ContactKind classify(Scalar v_rel, Scalar eps_r) {
  if (v_rel < -eps_r) return ContactKind::kColliding;
  return v_rel > eps_r ? ContactKind::kReceding : ContactKind::kResting;
}

#define BATUTA_INSTANTIATE(Scalar)                                                       \
  template Contact<Scalar> contact_from(const CapsuleGap<Scalar>&, const Vec3<Scalar>&); \
  template Scalar relative_velocity(const Contact<Scalar>&, const Pose<Scalar>&,         \
                                    const Twist<Scalar>&, const Pose<Scalar>&,           \
                                    const Twist<Scalar>&);                               \
  template ContactKind classify(Scalar, Scalar);
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta
