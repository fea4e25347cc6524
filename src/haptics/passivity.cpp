// SPDX-License-Identifier: MIT
#include "batuta/haptics/passivity.hpp"

#include "batuta/geometry/direction.hpp"

namespace batuta::haptics {
namespace {

template <class Scalar>
bool is_at_least_zero(Scalar x) {
  return is_finite(x) && x >= Scalar(0);
}

/// The square of the least way that an axis can have gone, u^2: an encoder may show a step too
/// much.
template <class Scalar>
Scalar sure_square(Scalar moved, Scalar encoder_step) {
  const Scalar way = (moved < Scalar(0) ? -moved : moved) - encoder_step;
  return way > Scalar(0) ? way * way : Scalar(0);
}

}  // namespace

template <class Scalar>
Status validate(const PassivitySettings<Scalar>& settings) {
  const bool device = is_positive(settings.period) && is_at_least_zero(settings.device_damping) &&
                      is_at_least_zero(settings.encoder_step);
  const bool book = is_at_least_zero(settings.most_credit) && is_positive(settings.most_debt);
  const bool action =
      is_at_least_zero(settings.largest_damping) && is_positive(settings.largest_force);
  return device && book && action ? Status::kOk : Status::kInvalidArgument;
}

template <class Scalar>
Status PassivityObserver<Scalar>::configure(const PassivitySettings<Scalar>& settings) {
  const Status status = validate(settings);
  if (status != Status::kOk) return status;
  *this = PassivityObserver<Scalar>();
  settings_ = settings;
  return status;
}

template <class Scalar>
Status PassivityObserver<Scalar>::restart(const Vec2<Scalar>& position, Scalar stored) {
  if (!is_finite(position) || !is_at_least_zero(stored)) return Status::kInvalidArgument;
  position_ = position;
  stored_ = stored;
  moved_.setZero();
  is_placed_ = true;
  return Status::kOk;
}

template <class Scalar>
Status PassivityObserver<Scalar>::supply(Scalar work) {
  if (!is_at_least_zero(work)) return Status::kInvalidArgument;
  credit_ = min_of(credit_ + work, settings_.most_credit);
  return Status::kOk;
}

template <class Scalar>
Status PassivityObserver<Scalar>::observe(const Vec2<Scalar>& held, const Vec2<Scalar>& position,
                                          Scalar stored) {
  if (!(settings_.period > Scalar(0))) return Status::kUnavailable;
  if (!is_placed_ && is_finite(held)) return restart(position, stored);
  const Vec2<Scalar> moved = position - position_;
  const Scalar sure = sure_square(moved.x(), settings_.encoder_step) +
                      sure_square(moved.y(), settings_.encoder_step);
  const Scalar taken = settings_.device_damping / settings_.period * sure;
  const Scalar credit = credit_ + (stored_ - stored - held.dot(moved)) + taken;
  if (!is_finite(credit) || !is_finite(position) || !is_at_least_zero(stored)) {
    return Status::kInvalidArgument;
  }
  position_ = position;
  moved_ = moved;
  stored_ = stored;
  book(credit);
  return Status::kOk;
}

template <class Scalar>
void PassivityObserver<Scalar>::book(Scalar credit) {
  state_ = credit < Scalar(0) ? Passivity::kDissipating : Passivity::kPassive;
  if (credit < -settings_.most_debt) {
    state_ = Passivity::kCannot;
    if (cannot_count_ < std::numeric_limits<std::uint32_t>::max()) ++cannot_count_;
  }
  credit_ = clamp(credit, -settings_.most_debt, settings_.most_credit);
}

template <class Scalar>
Scalar owed_damping(const PassivityObserver<Scalar>& observer) {
  const PassivitySettings<Scalar>& settings = observer.settings();
  const Scalar owed = -observer.credit();
  if (!(owed > Scalar(0))) return Scalar(0);
  // A damper d takes d |moved|^2 / T in a period like the last one.
  const Scalar taken_by_one = observer.moved().squaredNorm() / settings.period;
  const Scalar most = settings.largest_damping * taken_by_one;
  return owed < most ? owed / taken_by_one : settings.largest_damping;
}

template <class Scalar>
Result<PassiveForce<Scalar>> passive_force(const PassivityObserver<Scalar>& observer,
                                           const Vec2<Scalar>& demanded) {
  const Scalar damping = owed_damping(observer);
  Vec2<Scalar> force = demanded;
  if (damping > Scalar(0)) force -= damping / observer.settings().period * observer.moved();
  const Vec3<Scalar> flat(force.x(), force.y(), Scalar(0));  // its length at any scale
  const Scalar size = length(flat);
  if (!is_finite(force) || !is_finite(size)) {
    return failure<PassiveForce<Scalar>>(Status::kInvalidArgument);
  }
  const Scalar largest = observer.settings().largest_force;
  if (!(size > largest)) return success(PassiveForce<Scalar>{force, Scalar(0)});
  const Scalar excess = min_of(size / largest - Scalar(1), std::numeric_limits<Scalar>::max());
  return success(PassiveForce<Scalar>{largest * unit(flat).template head<2>(), excess});
}

#define BATUTA_INSTANTIATE(S)                                    \
  template Status validate(const PassivitySettings<S>&);         \
  template class PassivityObserver<S>;                           \
  template S owed_damping(const PassivityObserver<S>& observer); \
  template Result<PassiveForce<S>> passive_force(const PassivityObserver<S>&, const Vec2<S>&);
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta::haptics
