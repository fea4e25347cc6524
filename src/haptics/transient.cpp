// SPDX-License-Identifier: MIT

#include "batuta/haptics/transient.hpp"

namespace batuta::haptics {
namespace {

/// The largest s in [0, 1] with |blow + s rest| <= limit.
template <class Scalar>
Scalar share_that_fits(Scalar blow, Scalar rest, Scalar limit) {
  const Scalar room = max_of(rest < Scalar(0) ? limit + blow : limit - blow, Scalar(0));
  const Scalar wanted = std::abs(rest);
  return wanted > room ? room / wanted : Scalar(1);
}

}  // namespace

template <class Scalar>
Status validate(const TransientSettings<Scalar>& settings) {
  const bool good = is_finite(settings.gain) && settings.gain >= Scalar(0) &&
                    is_positive(settings.duration) && is_finite(settings.longest) &&
                    settings.longest >= settings.duration &&
                    settings.longest <= kLongestPulse<Scalar> && is_positive(settings.max_force);
  return good ? Status::kOk : Status::kInvalidArgument;
}

template <class Scalar>
Status ImpactTransient<Scalar>::configure(const TransientSettings<Scalar>& settings) {
  if (validate(settings) != Status::kOk) return Status::kInvalidArgument;
  *this = {};
  settings_ = settings;
  return Status::kOk;
}

template <class Scalar>
Status ImpactTransient<Scalar>::strike(const Vec2<Scalar>& impulse) {
  const Vec2<Scalar> sum = left_ + settings_.gain * impulse;
  if (!is_finite(sum)) return Status::kInvalidArgument;
  if (sum == left_) return Status::kOk;  // no blow: the pulse that is being played keeps its end
  left_ = sum;
  age_ = 0;
  return Status::kOk;
}

template <class Scalar>
Vec2<Scalar> ImpactTransient<Scalar>::advance(Scalar dt) {
  if (left_ == Vec2<Scalar>::Zero()) {
    excess_ = 0;
    return left_;
  }
  // To the nearest step: no sliver of a pulse is left for one more. What ends, ends exactly.
  const bool ends = !(settings_.duration - age_ > Scalar(1.5F) * dt);
  const Scalar time_left = ends ? dt : settings_.duration - age_;
  const Scalar most = settings_.max_force;
  // What fits at its first step fits at all others, but for rounding; later levels grow by what was
  // held back before, and are no measure of the blow.
  if (age_ == Scalar(0)) {
    excess_ = max_of(left_.cwiseAbs().maxCoeff() / time_left / most - Scalar(1), Scalar(0));
  }
  bool is_cut = false;
  Vec2<Scalar> force;
  for (int i = 0; i < 2; ++i) {  // Bound: the stick's coordinates
    const Scalar level = left_(i) / time_left;
    force(i) = clamp(level, -most, most);
    is_cut = is_cut || force(i) != level;
    left_(i) = ends && force(i) == level ? Scalar(0) : left_(i) - dt * force(i);
  }
  if (!is_cut) excess_ = 0;
  age_ += dt;
  if (ends && age_ + dt / 2 >= settings_.longest) {  // rounding may find the longest before the end
    lost_ += std::abs(left_.x()) + std::abs(left_.y());
    left_.setZero();
  }
  return force;
}

template <class Scalar>
Vec2<Scalar> mixed(const Vec2<Scalar>& blow, const Vec2<Scalar>& rest, Scalar limit) {
  const Scalar share = min_of(share_that_fits(blow.x(), rest.x(), limit),
                              share_that_fits(blow.y(), rest.y(), limit));
  // Rounding may carry the sum beyond the limit by one place.
  const auto within = [limit](Scalar x) { return clamp(x, -limit, limit); };
  return {within(blow.x() + share * rest.x()), within(blow.y() + share * rest.y())};
}

#define BATUTA_INSTANTIATE(S)                            \
  template Status validate(const TransientSettings<S>&); \
  template class ImpactTransient<S>;                     \
  template Vec2<S> mixed(const Vec2<S>&, const Vec2<S>&, S);
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta::haptics
