// SPDX-License-Identifier: MIT
#include "batuta/mechanics/straight.hpp"

namespace batuta {

template <class Scalar>
Result<StraightBody<Scalar>> make_straight_body(const Vec3<Scalar>& p_W, Scalar mass) {
  Result<StraightBody<Scalar>> made;
  const Scalar inverse_mass = Scalar(1) / mass;
  const bool has_mass = mass > Scalar(0) && is_finite(inverse_mass);
  if (!has_mass || !is_finite(p_W)) return made;
  made.status = Status::kOk;
  made.value.p_W = p_W;
  made.value.inverse_mass = inverse_mass;
  return made;
}

template <class Scalar>
Vec3<Scalar> velocity_of(const StraightBody<Scalar>& body) {
  return body.inverse_mass * body.momentum_W;
}

template <class Scalar>
Scalar kinetic_energy(const StraightBody<Scalar>& body) {
  return velocity_of(body).dot(body.momentum_W) / Scalar(2);
}

template <class Scalar>
Vec3<Scalar> detail::position_at(const detail::StraightMotion<Scalar>& motion, Scalar t) {
  return motion.p_W + motion.v_W * t;
}

template <class Scalar>
bool is_valid(const detail::StraightMotion<Scalar>& motion) {
  // What is not finite makes it so: infinity times zero is NaN.
  const Vec3<Scalar> end = motion.p_W + motion.duration * motion.v_W;
  return is_finite(end) && motion.duration >= Scalar(0);
}

#define BATUTA_INSTANTIATE(Scalar)                                                          \
  template Result<StraightBody<Scalar>> make_straight_body(const Vec3<Scalar>&, Scalar);    \
  template Vec3<Scalar> velocity_of(const StraightBody<Scalar>&);                           \
  template Scalar kinetic_energy(const StraightBody<Scalar>&);                              \
  template Vec3<Scalar> detail::position_at(const detail::StraightMotion<Scalar>&, Scalar); \
  template bool is_valid(const detail::StraightMotion<Scalar>&);
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta
