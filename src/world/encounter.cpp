// SPDX-License-Identifier: MIT
#include "batuta/world/encounter.hpp"

namespace batuta {
namespace {

template <class Scalar>
Collider<Scalar> collider(const Party<Scalar>& party) {
  return {party.body->X_WB, party.twist, party.body->inverse_mass, party.body->inverse_moments};
}

template <class Scalar>
void add(Body<Scalar>& body, const Momentum<Scalar>& change) {
  if (body.inverse_mass > Scalar(0)) body.momentum.p_W += change.p_W;
  if (body.inverse_moments != Vec3<Scalar>::Zero()) body.momentum.b_W += change.b_W;
}

/// To D if the contact is to be separated, else just clear of rounding, for which no time is
/// charged.
template <class Scalar>
Result<Separation<Scalar>> shifts_for(const Party<Scalar>& A, const Party<Scalar>& B,
                                      const Contact<Scalar>& contact,
                                      const EncounterAnswer<Scalar>& answer,
                                      const EncounterOptions<Scalar>& options) {
  SeparationOptions<Scalar> how;
  how.distance = answer.separated ? max_of(options.separation, options.margin) : options.margin;
  how.rest_speed = options.rest_speed;
  how.min_duration = options.min_separation_time;
  how.limit_A = A.room;
  how.limit_B = B.room;
  auto shifts = separate(contact, answer.v_rel, A.body->inverse_mass, B.body->inverse_mass, how);
  if (!answer.separated) shifts.value.duration = 0;
  return shifts;
}

}  // namespace

template <class Scalar>
Result<EncounterAnswer<Scalar>> answer_contact(const Party<Scalar>& A, const Party<Scalar>& B,
                                               const Contact<Scalar>& contact,
                                               const EncounterOptions<Scalar>& options) {
  if (!(options.separation > Scalar(0)))
    return failure<EncounterAnswer<Scalar>>(Status::kInvalidArgument);
  const auto hit = collision_impulse(collider(A), collider(B), contact, options.restitution);
  if (!hit.ok()) return failure<EncounterAnswer<Scalar>>(hit.status);

  EncounterAnswer<Scalar> answer;
  answer.v_rel = hit.value.v_rel;
  answer.kind = classify(answer.v_rel, options.rest_speed);
  const bool colliding = answer.kind == ContactKind::kColliding;
  const bool overlapping = contact.gap < -options.margin;
  answer.separated = answer.kind == ContactKind::kResting || overlapping;
  const auto shifts = shifts_for(A, B, contact, answer, options);
  if (!shifts.ok()) return failure<EncounterAnswer<Scalar>>(shifts.status);
  answer.separation = shifts.value;
  A.body->X_WB.p_W += shifts.value.shift_A_W;
  B.body->X_WB.p_W += shifts.value.shift_B_W;
  if (colliding) {
    answer.impulse = hit.value.magnitude;
    add(*A.body, hit.value.on_A);
    add(*B.body, hit.value.on_B);
  }
  return success(answer);
}

#define BATUTA_INSTANTIATE(S)                         \
  template Result<EncounterAnswer<S>> answer_contact( \
      const Party<S>&, const Party<S>&, const Contact<S>&, const EncounterOptions<S>&);
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta
