// SPDX-License-Identifier: MIT
#include "batuta/haptics/device_measurement.hpp"

#include <new>

#include "batuta/haptics/detail/whole.hpp"

namespace batuta::haptics {
namespace {

using State = MeasurementState;

// src/haptics/device_measurement.md, "The motion"
constexpr int kSettling = 200;         ///< periods without a force
constexpr float kStill = 0.02F;        ///< share of the excursion that it may move in them
constexpr int kRamp = 3000;            ///< periods to most_share
constexpr float kBrokenAway = 0.125F;  ///< share of the excursion
constexpr float kAboveRamp = 1.25F;    ///< of the share at which it broke away
constexpr float kLeastShare = 1.0F / 4096;
constexpr float kTurned = 1.0F / 16;  ///< share of the excursion that it comes back from a turn
constexpr float kHalfTheRest = 0.5F;  ///< a push that is longer by x is braked for x longer
constexpr float kLearnt = 0.25F;      ///< of what a turn missed the excursion by
constexpr float kMostChange = 1.25F;  ///< of the share, from stroke to stroke
constexpr int kLongestStroke = 2000;  ///< periods; then the push is made stronger

/// Strokes of about so many periods.
struct Sweep {
  float length;
  int strokes;
};
constexpr Sweep kSweeps[] = {{200, 14}, {120, 12}, {400, 10}, {800, 6}};
constexpr int kLastSweep = 3;

// "What is refused"
constexpr int kMostMissing = 10;
constexpr int kMostLost = 1000;
constexpr float kMostJitter = 0.2F;  ///< of a period
/// Of the mean period, over each stretch of kStretch: damping goes with it, and mass with its
/// square.
constexpr float kMostPeriodError = 0.0025F;
constexpr int kStretch = 1024;  ///< periods
/// What is left of kMostPeriodError for a clock that is off: the ends of a stretch may be off, too.
constexpr float kMostDrift = kMostPeriodError - kMostJitter / kStretch;
constexpr float kUsPerSecond = 1e6F;
constexpr int kMostHeldBack = 3000;
constexpr float kRounding = 1e-4F;  ///< of a share: 12 bits and more
constexpr int kLeastRows = 100;
constexpr float kMostMisfit = 0.05F;
constexpr float kMostResidual = 3;  ///< times what the encoder makes
constexpr float kSureSpring = 5;    ///< sigmas: of 500 free devices none has it
/// Sigmas between what some sweeps say and what all do: of 1000 free devices 6 have more.
constexpr float kSameDevice = 2;
constexpr float kSureMass = 0.1F;  ///< its sigma, as a share of it
constexpr float kSureDelay = 0.25F;
constexpr float kSureForce = 0.1F;  ///< sigma of friction, as a share of the force

// measured_profile()
constexpr float kNarrow = 0.1F;  ///< periods beyond a whole number, which are paid with damping

/// @param clock  share by which the unit may be off
Estimate in_unit(const detail::Fitted& fitted, float unit, float clock = 0) {
  const float off = clock * fitted.value;
  return {unit * fitted.value, unit * std::sqrt(fitted.sigma * fitted.sigma + off * off)};
}

bool is_same(const detail::Fitted& part, const detail::Fitted& whole) {
  return std::abs(part.value - whole.value) <= kSameDevice * part.sigma;
}

/// Whether a part of the motion says the same as all of it, if it says anything.
bool is_same(const detail::MomentumResult& part, const detail::MomentumResult& whole) {
  return !part.is_good ||
         (is_same(part.mass, whole.mass) && is_same(part.damping, whole.damping) &&
          is_same(part.friction, whole.friction) && is_same(part.stiffness, whole.stiffness) &&
          is_same(part.delay, whole.delay));
}

/// Whether every number is one, and no standard error is on the side that is not safe.
bool is_usable(const DeviceEstimates& estimates) {
  bool good = is_finite(estimates.misfit);
  const Estimate* const all[] = {&estimates.damping,     &estimates.friction, &estimates.mass,
                                 &estimates.stiffness,   &estimates.offset,   &estimates.delay,
                                 &estimates.encoder_step};
  for (const Estimate* x : all) {  // Bound: 7
    good = good && is_finite(x->value) && is_finite(x->sigma) && x->sigma >= 0.0F;
  }
  return good;
}

/// Of a delay in parts of a period: the whole periods that are told, and by how much damping has to
/// be less for them. src/haptics/gain_advisor.md, "Delays in parts".
struct WholeDelay {
  float periods;
  float damping;  ///< share that is left
};

WholeDelay whole_delay(float delay) {
  const float whole = detail::whole_below(delay);
  const float rest = delay - whole;
  if (!(rest <= kNarrow)) return {whole + 1, 1};
  const float age = whole + 0.5F;
  return {whole, age / (age + 1.5F * rest)};
}

}  // namespace

Status validate(const MeasurementSettings& settings) {
  const bool good = is_positive(settings.period) && is_positive(settings.force_limit) &&
                    is_positive(settings.travel) && is_positive(settings.most_share) &&
                    settings.most_share <= 1.0F && is_positive(settings.excursion) &&
                    settings.safe_window > settings.excursion &&
                    settings.safe_window <= settings.travel && is_finite(settings.most_stiffness) &&
                    settings.most_stiffness >= 0.0F &&
                    is_positive(settings.period * settings.period * settings.force_limit) &&
                    settings.period * kUsPerSecond < 1e6F;
  return good ? Status::kOk : Status::kInvalidArgument;
}

Status DeviceMeasurement::configure(const MeasurementSettings& settings) {
  if (validate(settings) != Status::kOk) return Status::kInvalidArgument;
  // Where it is, and not from a copy: that is 3.6 KB, more than a firmware's whole stack.
  ::new (static_cast<void*>(this)) DeviceMeasurement();  // deviation: placement-new
  settings_ = settings;
  state_ = State::kRunning;
  return Status::kOk;
}

float DeviceMeasurement::step(const MeasurementInput& input) {
  if (state_ != State::kRunning) return 0;
  ++steps_;
  state_ = watch(input);
  if (state_ == State::kRunning && steps_ >= kMostSteps) state_ = State::kNoMotion;
  if (state_ == State::kRunning && has_time_) {
    fit_.take(position_, input.applied, input.fresh);
    if (input.fresh) grid_.take(position_);
    state_ = move();
  }
  if (state_ != State::kRunning) asked_ = 0;
  return asked_;
}

/// Whether it is safe, and of any use, to go on.
State DeviceMeasurement::watch(const MeasurementInput& input) {
  if (!is_finite(input.applied) || (input.fresh && !is_finite(input.position))) {
    return State::kNotANumber;
  }
  ++silent_;
  if (!input.fresh) {
    ++lost_;
    ++missing_;
    return missing_ > kMostMissing || lost_ > kMostLost ? State::kNoSamples : State::kRunning;
  }
  missing_ = 0;
  if (!is_timed(input.time)) return State::kWrongPeriod;
  position_ = input.position;
  if (std::abs(position_) > settings_.safe_window) return State::kLeftWindow;
  if (std::abs(input.applied) > settings_.most_share + kRounding) return State::kHeldBack;
  if (std::abs(input.applied) < 0.5F * std::abs(asked_)) ++held_back_;
  return held_back_ > kMostHeldBack ? State::kHeldBack : State::kRunning;
}

/// Whether a sample is where the one before says, and all of the stretch where its first one says.
bool DeviceMeasurement::is_timed(Microseconds time) {
  const float period = settings_.period;
  const float waited = static_cast<float>(elapsed_us(time_, time)) / kUsPerSecond;
  const float late = has_time_ ? waited - static_cast<float>(silent_) * period : 0.0F;
  if (!has_time_ || stretch_ >= kStretch) {
    stretch_ = 0;
    drift_ = 0;
  }
  stretch_ += has_time_ ? silent_ : 0;
  drift_ += late;
  late_ += late;
  time_ = time;
  has_time_ = true;
  silent_ = 0;
  const float most = kMostJitter + kMostDrift * static_cast<float>(stretch_);
  return std::abs(late) <= kMostJitter * period && std::abs(drift_) <= most * period;
}

State DeviceMeasurement::move() {
  ++in_phase_;
  switch (phase_) {
    case Phase::kSettling:
      return settle();
    case Phase::kRamping:
      return ramp();
    case Phase::kSweeping:
      return sweep();
  }
  return State::kIdle;
}

State DeviceMeasurement::settle() {
  if (in_phase_ == 1) start_ = position_;
  if (std::abs(position_ - start_) > kStill * settings_.excursion) return State::kNotStill;
  if (std::abs(start_) + settings_.excursion > settings_.safe_window) return State::kNotStill;
  if (in_phase_ < kSettling) return State::kRunning;
  phase_ = Phase::kRamping;
  in_phase_ = 0;
  return State::kRunning;
}

State DeviceMeasurement::ramp() {
  if (in_phase_ > kRamp) return State::kNoMotion;
  push(settings_.most_share * static_cast<float>(in_phase_) / static_cast<float>(kRamp));
  if (std::abs(position_ - start_) < kBrokenAway * settings_.excursion) return State::kRunning;
  direction_ =
      position_ < start_ ? -1.0F : 1.0F;  // positive, unless an axis is wired the other way
  if (direction_ < 0.0F) return State::kNoMotion;
  share_ = min_of(kAboveRamp * asked_, settings_.most_share);
  least_share_ = min_of(kLeastShare, share_);
  extreme_ = position_;
  phase_ = Phase::kSweeping;
  in_phase_ = 0;
  return State::kRunning;
}

/// A stroke: pushed, from a place on braked, until it has turned; the brake is the next one's push.
State DeviceMeasurement::sweep() {
  const float way = direction_ * (position_ - start_);
  if (!brakes_ && way > brake_at_) brakes_ = true;
  extreme_ = direction_ * max_of(direction_ * extreme_, direction_ * position_);
  const float back = direction_ * (extreme_ - position_);
  if (brakes_ && back > kTurned * settings_.excursion) return turn();
  if (in_phase_ > kLongestStroke) {
    if (share_ >= settings_.most_share) return State::kNoMotion;
    share_ = min_of(kMostChange * share_, settings_.most_share);
    least_share_ = share_;
    in_phase_ = 0;
  }
  push(brakes_ ? -direction_ * share_ : direction_ * share_);
  return State::kRunning;
}

/// The next stroke goes as far as the excursion, and lasts as long as the sweep wants.
State DeviceMeasurement::turn() {
  const float reached = direction_ * (extreme_ - start_);
  const float missed = settings_.excursion - reached;
  learnt_[direction_ < 0.0F ? 1 : 0] += kLearnt * missed;
  const float brake_at = kHalfTheRest * missed + learnt_[direction_ < 0.0F ? 0 : 1];
  brake_at_ = clamp(brake_at, -settings_.excursion, settings_.excursion);
  const float slow = static_cast<float>(in_phase_) / kSweeps[sweep_].length;
  share_ =
      clamp(share_ * clamp(slow, 1 / kMostChange, kMostChange), least_share_, settings_.most_share);
  grid_.end_block();
  direction_ = -direction_;
  extreme_ = position_;
  brakes_ = false;
  in_phase_ = 0;
  if (++strokes_ < kSweeps[sweep_].strokes) return State::kRunning;
  strokes_ = 0;
  if (sweep_ == kLastSweep) return conclude();
  early_[static_cast<std::size_t>(sweep_)] = fit_.solve(grid_.step());
  ++sweep_;
  return State::kRunning;
}

State DeviceMeasurement::conclude() {
  estimates_.encoder_step = {grid_.step(), grid_.error()};
  if (!grid_.is_known() || fit_.rows() < kLeastRows) return State::kTooFew;
  if (!grid_.is_sure()) return State::kCannotTell;
  const detail::MomentumResult fit = fit_.solve(grid_.step());
  // No grid, but noise: an encoder as coarse as what is left is the most that it can be.
  if (!(grid_.step() > 0.0F)) {
    estimates_.encoder_step.sigma = max_of(grid_.error(), fit.coarsest);
  }
  const float T = settings_.period;
  const float F = settings_.force_limit;
  const float clock = std::abs(late_) / (static_cast<float>(steps_) * T);
  estimates_.mass = in_unit(fit.mass, F * T * T, 2 * clock);
  estimates_.damping = in_unit(fit.damping, F * T, clock);
  estimates_.friction = in_unit(fit.friction, F);
  estimates_.stiffness = in_unit(fit.stiffness, F);
  estimates_.offset = in_unit(fit.offset, F);
  estimates_.delay = {fit.delay.value, fit.delay.sigma};
  estimates_.misfit = fit.residual / fit.response;
  if (!fit.is_good) return fit.delay.value > 0.0F ? State::kDelayTooLong : State::kCannotTell;
  if (!(fit.residual < kMostMisfit * fit.response + kMostResidual * fit.expected)) {
    return State::kDoesNotFit;
  }
  const float pulled = estimates_.stiffness.value - kSureSpring * estimates_.stiffness.sigma;
  if (pulled > settings_.most_stiffness) return State::kHeld;
  for (const detail::MomentumResult& part : early_) {  // Bound: the sweeps but one
    if (!is_same(part, fit)) return State::kDoesNotFit;
  }
  const bool is_sure = fit.mass.sigma < kSureMass * fit.mass.value &&
                       fit.delay.sigma < kSureDelay &&
                       fit.friction.sigma < kSureForce * fit.response;
  return is_sure ? State::kMeasured : State::kCannotTell;
}

Result<DeviceProfile<float>> measured_profile(const MeasurementSettings& settings,
                                              const DeviceEstimates& estimates, float margin) {
  using Profile = DeviceProfile<float>;
  const auto low = [margin](const Estimate& x) { return max_of(x.value - margin * x.sigma, 0.0F); };
  const auto high = [margin](const Estimate& x) { return x.value + margin * x.sigma; };
  const WholeDelay delay = whole_delay(max_of(high(estimates.delay), 0.0F));
  const bool good = validate(settings) == Status::kOk && is_finite(margin) && margin >= 0.0F &&
                    is_usable(estimates) && is_finite(high(estimates.delay)) &&
                    delay.periods <= static_cast<float>(detail::MomentumFit::kMostDelay + 1);
  if (!good) return failure<Profile>(Status::kInvalidArgument);
  Profile profile;
  profile.period = settings.period;
  profile.delay = static_cast<int>(delay.periods);
  profile.damping = delay.damping * low(estimates.damping);
  profile.friction = low(estimates.friction);
  profile.encoder_step = high(estimates.encoder_step);
  profile.force_limit = settings.force_limit;
  profile.travel = settings.travel;
  return validate(profile) == Status::kOk ? success(profile)
                                          : failure<Profile>(Status::kInvalidArgument);
}

}  // namespace batuta::haptics
