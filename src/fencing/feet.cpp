// SPDX-License-Identifier: MIT
#include "batuta/fencing/feet.hpp"

namespace batuta::fencing {
namespace {

/// The greatest speed towards the end of `room` after a step from which one can still stop there
/// (feet.md). @pre room >= 0
template <class Scalar>
Scalar speed_limit(Scalar speed, Scalar room, Scalar acceleration, Scalar dt) {
  const Scalar half = dt / Scalar(2);
  const Scalar left = max_of(room - speed * half, Scalar(0));
  return acceleration * (std::sqrt(half * half + Scalar(2) * left / acceleration) - half);
}

}  // namespace

template <class Scalar>
Status validate(const FeetSettings<Scalar>& settings) {
  const bool good =
      is_positive(settings.forward_speed) && settings.forward_speed <= kFastestFeet<Scalar> &&
      is_positive(settings.backward_speed) && settings.backward_speed <= kFastestFeet<Scalar> &&
      settings.acceleration >= kLeastPush<Scalar> && settings.acceleration <= kLargestPush<Scalar>;
  return good ? Status::kOk : Status::kInvalidArgument;
}

template <class Scalar>
Scalar Feet<Scalar>::stopping_way(const FeetSettings<Scalar>& settings) const {
  const Scalar speed = max_of(velocity_, Scalar(0));
  return speed * speed / (Scalar(2) * settings.acceleration);
}

template <class Scalar>
void Feet<Scalar>::advance(const FeetSettings<Scalar>& settings, Scalar order,
                           const FeetRoom<Scalar>& room, Scalar dt) {
  BATUTA_ASSERT(order >= Scalar(-1) && order <= Scalar(1) && dt > Scalar(0));
  const Scalar ahead = max_of(room.forward, Scalar(0));
  const Scalar behind = max_of(room.backward, Scalar(0));
  const Scalar wanted =
      order * (order > Scalar(0) ? settings.forward_speed : settings.backward_speed);
  const Scalar change = settings.acceleration * dt;
  const Scalar reached = clamp(wanted, velocity_ - change, velocity_ + change);
  const Scalar next = clamp(reached, -speed_limit(-velocity_, behind, settings.acceleration, dt),
                            speed_limit(velocity_, ahead, settings.acceleration, dt));
  way_ += clamp((velocity_ + next) * (dt / Scalar(2)), -behind, ahead);
  velocity_ = next;
}

template <class Scalar>
bool Feet<Scalar>::is_within(const FeetSettings<Scalar>& settings) const {
  return velocity_ <= settings.forward_speed && velocity_ >= -settings.backward_speed;
}

template <class Scalar>
std::array<FeetRoom<Scalar>, 2> rooms_of(const BothFeet<Scalar>& feet,
                                         const FeetSettings<Scalar>& settings, Scalar between,
                                         const Vec2<Scalar>& behind) {
  const Vec2<Scalar> stopping(feet[0].stopping_way(settings), feet[1].stopping_way(settings));
  const Scalar share = (between - stopping.x() - stopping.y()) / Scalar(2);
  return {{{stopping.x() + share, behind.x()}, {stopping.y() + share, behind.y()}}};
}

#define BATUTA_INSTANTIATE(S)                                                                 \
  template Status validate(const FeetSettings<S>&);                                           \
  template class Feet<S>;                                                                     \
  template std::array<FeetRoom<S>, 2> rooms_of(const BothFeet<S>&, const FeetSettings<S>&, S, \
                                               const Vec2<S>&);
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta::fencing
