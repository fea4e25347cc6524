// SPDX-License-Identifier: MIT
#include "batuta/response/impulse.hpp"

#include "lever.hpp"

namespace batuta {

namespace {

/// How one body gives way to a unit impulse along a unit direction n at the contact point.
template <class Scalar>
struct Yield {
  Vec3<Scalar> lever_W = Vec3<Scalar>::Zero();  ///< r, from the centre of mass to the point
  Vec3<Scalar> v_W = Vec3<Scalar>::Zero();      ///< change of velocity
  Vec3<Scalar> w_W = Vec3<Scalar>::Zero();      ///< change of angular velocity
  Scalar along_n = 0;                           ///< change of the point's velocity along n; n . K n
};

/// The quadratic form is a sum of squares in the body's own axes: unequal moments cancel nothing
/// [Kavan eq. 28, 29].
template <class Scalar>
Yield<Scalar> yield_of(const Collider<Scalar>& body, const Contact<Scalar>& contact) {
  const Vec3<Scalar>& n = contact.normal_BA_W;
  const Mat3<Scalar> R_WB = detail::to_matrix(body.X_WB.q_WB);
  Yield<Scalar> yield;
  yield.lever_W = contact.point_W - body.X_WB.p_W;
  const Vec3<Scalar> moment_B = R_WB.transpose() * yield.lever_W.cross(n);
  const Vec3<Scalar> turn_B = body.inverse_moments.cwiseProduct(moment_B);
  yield.v_W = body.inverse_mass * n;
  yield.w_W = R_WB * turn_B;
  yield.along_n = body.inverse_mass + turn_B.dot(moment_B);
  return yield;
}

/// The twist after. In place: a copy costs as much as the product.
template <class Scalar>
void push(Twist<Scalar>& after, const Twist<Scalar>& twist, const Yield<Scalar>& yield, Scalar j) {
  after.v_W = twist.v_W + j * yield.v_W;
  after.w_W = twist.w_W + j * yield.w_W;
}

/// Of what is not finite v_rel or the softness tells (impulse.md, "Numbers").
template <class Scalar>
bool may_give_way(const Collider<Scalar>& body) {
  return body.inverse_mass >= Scalar(0) && body.inverse_moments.minCoeff() >= Scalar(0);
}

}  // namespace

template <class Scalar>
bool is_sound(const Impulse<Scalar>& hit) {
  Scalar lost = 0;  // times zero: a sum of the numbers could overflow where none of them did
  const auto look_at = [&lost](const Vec3<Scalar>& v) {
    for (int i = 0; i < 3; ++i) lost += Scalar(0) * v[i];  // Bound: 3; expressions double the code
  };
  look_at(hit.twist_A.v_W);
  look_at(hit.twist_A.w_W);
  look_at(hit.twist_B.v_W);
  look_at(hit.twist_B.w_W);
  look_at(hit.on_A.linear_W);
  look_at(hit.on_A.angular_W);
  look_at(hit.on_B.angular_W);
  return lost == Scalar(0);
}

template <class Scalar>
Collider<Scalar> collider_of(const Body<Scalar>& body) {
  return {body.X_WB, twist_of(body), body.inverse_mass, body.inverse_moments};
}

template <class Scalar>
Result<Impulse<Scalar>> collision_impulse(const Collider<Scalar>& A, const Collider<Scalar>& B,
                                          const Contact<Scalar>& contact, Scalar restitution) {
  Result<Impulse<Scalar>> result;
  const bool is_restitution = restitution >= Scalar(0) && restitution <= Scalar(1);
  if (!may_give_way(A) || !may_give_way(B) || !is_restitution) return result;
  const Scalar v_rel = relative_velocity(contact, A.X_WB, A.twist, B.X_WB, B.twist);
  const Yield<Scalar> yield_A = yield_of(A, contact);
  const Yield<Scalar> yield_B = yield_of(B, contact);
  const Scalar give = yield_A.along_n + yield_B.along_n;
  if (!is_finite(v_rel) || !is_finite(give)) return result;

  result.status = Status::kOk;
  Impulse<Scalar>& impulse = result.value;
  impulse.v_rel = v_rel;
  if (v_rel < Scalar(0) && give > Scalar(0)) {
    const Scalar j = -(Scalar(1) + restitution) * v_rel / give;
    const Vec3<Scalar> J_W = j * contact.normal_BA_W;
    impulse.magnitude = j;
    impulse.on_A = impulse_on<Scalar>(yield_A.lever_W, J_W);
    impulse.on_B = impulse_on<Scalar>(yield_B.lever_W, -J_W);
    push(impulse.twist_A, A.twist, yield_A, j);
    push(impulse.twist_B, B.twist, yield_B, -j);
    if (!is_sound(impulse)) result = {};
  } else {
    impulse.twist_A = A.twist;
    impulse.twist_B = B.twist;
  }
  return result;
}

#define BATUTA_INSTANTIATE(Scalar)                            \
  template bool is_sound(const Impulse<Scalar>&);             \
  template Collider<Scalar> collider_of(const Body<Scalar>&); \
  template Result<Impulse<Scalar>> collision_impulse(         \
      const Collider<Scalar>&, const Collider<Scalar>&, const Contact<Scalar>&, Scalar);
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta
