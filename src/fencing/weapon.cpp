// SPDX-License-Identifier: MIT
#include "batuta/fencing/weapon.hpp"

#include "batuta/mechanics/mass.hpp"

namespace batuta::fencing {
namespace {

template <class Scalar>
Result<MassProperties<Scalar>> mass_of(const WeaponPart<Scalar>& part) {
  if (!is_valid(part.capsule_H)) return failure<MassProperties<Scalar>>(Status::kInvalidArgument);
  if (part.capsule_H.radius == Scalar(0))
    return point_mass(part.mass, part.capsule_H.axis.at(Scalar(0.5)));
  const auto of_water =
      solid_capsule(part.capsule_H, Scalar(1000));  // kg/m^3; the true density follows
  if (!of_water.ok() || !(part.mass > Scalar(0))) {
    return failure<MassProperties<Scalar>>(Status::kInvalidArgument);
  }
  return solid_capsule(part.capsule_H, Scalar(1000) * (part.mass / of_water.value.mass));
}

template <class Scalar>
Capsule<Scalar> in_body(const Pose<Scalar>& X_HB, const Capsule<Scalar>& capsule_H) {
  return {{to_body(X_HB, capsule_H.axis.a), to_body(X_HB, capsule_H.axis.b)}, capsule_H.radius};
}

}  // namespace

template <class Scalar>
Result<WeaponBody<Scalar>> weapon_body(const Weapon<Scalar>& weapon) {
  auto sum = mass_of(weapon.parts[0]);
  if (!sum.ok()) return failure<WeaponBody<Scalar>>(sum.status);
  for (std::size_t i = 1; i < weapon.parts.size(); ++i) {  // Bound: kParts
    const auto part = mass_of(weapon.parts[i]);
    if (!part.ok()) return failure<WeaponBody<Scalar>>(part.status);
    sum.value = sum.value + part.value;
  }
  const PrincipalFrame<Scalar> frame = principal_frame(sum.value);

  WeaponBody<Scalar> body;
  body.mass = sum.value.mass;
  body.moments = frame.moments;
  body.X_HB = {frame.center_S, frame.q_SB};
  body.blade_B = in_body(body.X_HB, weapon.parts[0].capsule_H);
  body.guard_B = in_body(body.X_HB, weapon.parts[1].capsule_H);
  body.hand_B = in_body(body.X_HB, weapon.hand_H);
  body.restitution = weapon.restitution;
  const Status status = validate(body);
  return status == Status::kOk ? success(body) : failure<WeaponBody<Scalar>>(status);
}

template <class Scalar>
Status validate(const WeaponBody<Scalar>& weapon) {
  const bool good = is_finite(weapon.mass) && is_finite(weapon.moments) &&
                    make_body(weapon.X_HB, weapon.mass, weapon.moments).ok() &&
                    batuta::detail::is_turn(weapon.X_HB.q_WB) && is_valid(weapon.blade_B) &&
                    is_valid(weapon.guard_B) && is_valid(weapon.hand_B) &&
                    weapon.restitution >= Scalar(0) && weapon.restitution <= Scalar(1);
  return good ? Status::kOk : Status::kInvalidArgument;
}

template <class Scalar>
Pose<Scalar> chained(const Pose<Scalar>& X_AB, const Pose<Scalar>& X_BC) {
  return {to_world(X_AB, X_BC.p_W), batuta::detail::composed(X_AB.q_WB, X_BC.q_WB)};
}

template <class Scalar>
Pose<Scalar> inverse(const Pose<Scalar>& X_AB) {
  const Quat<Scalar> q_BA = X_AB.q_WB.conjugate();
  return {-(q_BA * X_AB.p_W), q_BA};
}

#define BATUTA_INSTANTIATE(S)                                   \
  template Result<WeaponBody<S>> weapon_body(const Weapon<S>&); \
  template Status validate(const WeaponBody<S>&);               \
  template Pose<S> chained(const Pose<S>&, const Pose<S>&);     \
  template Pose<S> inverse(const Pose<S>&);
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta::fencing
