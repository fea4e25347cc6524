// SPDX-License-Identifier: MIT
#include "batuta/world/detail/resolution.hpp"

namespace batuta::detail {
namespace {

template <class Scalar>
void add(Body<Scalar>& body, const Momentum<Scalar>& change) {
  if (body.inverse_mass > Scalar(0)) body.momentum.linear_W += change.linear_W;
  if (body.inverse_moments != Vec3<Scalar>::Zero()) body.momentum.angular_W += change.angular_W;
}

/// To D if the contact is to be separated, else just clear of rounding, for which no time is
/// charged.
template <class Scalar>
Result<Separation<Scalar>> shifts_for(const ContactSide<Scalar>& A, const ContactSide<Scalar>& B,
                                      const Contact<Scalar>& contact,
                                      const Resolution<Scalar>& resolution,
                                      const ResolutionOptions<Scalar>& options) {
  SeparationOptions<Scalar> how;
  how.distance = resolution.separated ? max_of(options.separation, options.margin) : options.margin;
  how.rest_speed = options.rest_speed;
  how.min_duration = options.min_separation_time;
  how.limit_A = A.room;
  how.limit_B = B.room;
  auto shifts =
      separate(contact, resolution.v_rel, A.body->inverse_mass, B.body->inverse_mass, how);
  if (!resolution.separated) shifts.value.duration = 0;
  return shifts;
}

}  // namespace

template <class Scalar>
Collider<Scalar> collider_of(const ContactSide<Scalar>& side) {
  return {side.body->X_WB, side.twist, side.body->inverse_mass, side.body->inverse_moments};
}

template <class Scalar>
Result<Resolution<Scalar>> resolve_contact(const ContactSide<Scalar>& A,
                                           const ContactSide<Scalar>& B,
                                           const Contact<Scalar>& contact,
                                           const Result<Impulse<Scalar>>& impulse,
                                           const ResolutionOptions<Scalar>& options) {
  if (!impulse.ok() || !(options.separation > Scalar(0)))
    return failure<Resolution<Scalar>>(Status::kInvalidArgument);

  Resolution<Scalar> resolution;
  resolution.v_rel = impulse.value.v_rel;
  resolution.kind = classify(resolution.v_rel, options.rest_speed);
  const bool resting = resolution.kind == ContactKind::kResting;
  const bool pushes = resolution.kind == ContactKind::kColliding || (options.settles && resting);
  const bool overlapping = contact.gap < -options.margin;
  resolution.separated = resting || overlapping;
  const auto shifts = shifts_for(A, B, contact, resolution, options);
  if (!shifts.ok()) return failure<Resolution<Scalar>>(shifts.status);
  resolution.separation = shifts.value;
  A.body->X_WB.p_W += shifts.value.shift_A_W;
  B.body->X_WB.p_W += shifts.value.shift_B_W;
  if (pushes) {
    resolution.impulse = impulse.value.magnitude;
    add(*A.body, impulse.value.on_A);
    add(*B.body, impulse.value.on_B);
  }
  return success(resolution);
}

#define BATUTA_INSTANTIATE(S)                                                                  \
  template Collider<S> collider_of(const ContactSide<S>&);                                     \
  template Result<Resolution<S>> resolve_contact(const ContactSide<S>&, const ContactSide<S>&, \
                                                 const Contact<S>&, const Result<Impulse<S>>&, \
                                                 const ResolutionOptions<S>&);
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta::detail
