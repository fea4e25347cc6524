// SPDX-License-Identifier: MIT
#include "batuta/haptics/gain_advisor.hpp"

namespace batuta::haptics {
namespace {

/// What rounding here and in the caller's sums may add to a bound: src/haptics/gain_advisor.md.
template <class Scalar>
constexpr Scalar kRounded = Scalar(1) + Scalar(8) * kRoundOff<Scalar>;

/// What overflows is beyond.
template <class Scalar>
bool is_within(Scalar x, Scalar most) {
  const Scalar rounded = kRounded<Scalar> * most;
  return is_finite(x) && x <= rounded;
}

template <class Scalar>
Scalar magnitude(Scalar x) {
  return x < Scalar(0) ? -x : x;
}

/// T (n + 1/2): the mean age of a held force, s.
template <class Scalar>
Scalar age(const DeviceProfile<Scalar>& profile) {
  return profile.period * (static_cast<Scalar>(profile.delay) + Scalar(0.5));
}

template <class Scalar>
bool is_not_negative(Scalar x) {
  return is_finite(x) && x >= Scalar(0);
}

/// The smaller of what the two bounds leave.
template <class Scalar>
Result<GainLimit<Scalar>> smaller(Scalar by_sampling, Scalar by_encoder) {
  GainLimit<Scalar> limit{by_sampling, GainBound::kSampling};
  // What is left of infinities is not a number, and no bound: it is taken, and refused.
  if (!(by_encoder >= by_sampling)) limit = {by_encoder, GainBound::kEncoder};
  limit.largest = max_of(limit.largest, Scalar(0));
  if (!is_finite(limit.largest)) return failure<GainLimit<Scalar>>(Status::kInvalidArgument);
  return success(limit);
}

}  // namespace

template <class Scalar>
Status validate(const DeviceProfile<Scalar>& profile) {
  const bool mechanism = is_not_negative(profile.damping) && is_not_negative(profile.friction);
  const bool loop = is_positive(profile.period) && profile.delay >= 0 &&
                    is_positive(age(profile)) && is_not_negative(profile.encoder_step);
  const bool ends = is_positive(profile.force_limit) && is_positive(profile.travel);
  return mechanism && loop && ends ? Status::kOk : Status::kInvalidArgument;
}

template <class Scalar>
Result<GainLimit<Scalar>> largest_stiffness(const DeviceProfile<Scalar>& profile, Scalar damping) {
  if (validate(profile) != Status::kOk || !is_finite(damping)) {
    return failure<GainLimit<Scalar>>(Status::kInvalidArgument);
  }
  const Scalar spent = magnitude(damping);
  const Scalar by_sampling = (profile.damping - spent) / age(profile);
  if (profile.encoder_step == Scalar(0)) return smaller(by_sampling, by_sampling);
  const Scalar steps = profile.friction / profile.encoder_step;
  return smaller(by_sampling, Scalar(2) * (steps - spent / profile.period));
}

template <class Scalar>
Result<GainLimit<Scalar>> largest_damping(const DeviceProfile<Scalar>& profile, Scalar stiffness) {
  if (validate(profile) != Status::kOk || !is_not_negative(stiffness)) {
    return failure<GainLimit<Scalar>>(Status::kInvalidArgument);
  }
  const Scalar by_sampling = profile.damping - stiffness * age(profile);
  if (profile.encoder_step == Scalar(0)) return smaller(by_sampling, by_sampling);
  const Scalar steps = profile.friction / profile.encoder_step;
  return smaller(by_sampling, profile.period * (steps - stiffness / Scalar(2)));
}

template <class Scalar>
GainVerdict check(const DeviceProfile<Scalar>& profile, const Gains<Scalar>& gains) {
  if (validate(profile) != Status::kOk) return GainVerdict::kInvalidProfile;
  if (!is_not_negative(gains.stiffness) || !is_finite(gains.damping))
    return GainVerdict::kInvalidGains;
  const Scalar spent = magnitude(gains.damping);
  const Scalar lag = gains.stiffness * age(profile) + spent;
  if (!is_within(lag, profile.damping)) return GainVerdict::kBeyondSampling;
  if (profile.encoder_step == Scalar(0)) return GainVerdict::kInside;
  const Scalar jump = profile.encoder_step * (gains.stiffness / Scalar(2) + spent / profile.period);
  return is_within(jump, profile.friction) ? GainVerdict::kInside : GainVerdict::kBeyondEncoder;
}

template <class Scalar>
Result<Scalar> unsaturated_stiffness(const DeviceProfile<Scalar>& profile) {
  if (validate(profile) != Status::kOk) return failure<Scalar>(Status::kInvalidArgument);
  const Scalar stiffness = profile.force_limit / profile.travel;
  return is_finite(stiffness) ? success(stiffness) : failure<Scalar>(Status::kInvalidArgument);
}

#define BATUTA_INSTANTIATE(S)                                                  \
  template Status validate(const DeviceProfile<S>&);                           \
  template Result<GainLimit<S>> largest_stiffness(const DeviceProfile<S>&, S); \
  template Result<GainLimit<S>> largest_damping(const DeviceProfile<S>&, S);   \
  template GainVerdict check(const DeviceProfile<S>&, const Gains<S>&);        \
  template Result<S> unsaturated_stiffness(const DeviceProfile<S>&);
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta::haptics
