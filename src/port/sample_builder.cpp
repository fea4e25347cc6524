// SPDX-License-Identifier: MIT

#include "batuta/port/sample_builder.hpp"

#include <initializer_list>

namespace batuta {
namespace {

std::int32_t clamp_counts(std::int64_t counts, const AxisCalibration& axis) {
  if (counts < axis.min) return axis.min;
  if (counts > axis.max) return axis.max;
  return static_cast<std::int32_t>(counts);
}

std::int32_t centre(const AxisCalibration& axis) {
  return static_cast<std::int32_t>((std::int64_t{axis.min} + axis.max) / 2);
}

}  // namespace

float deflection(const AxisCalibration& axis, std::int32_t counts) {
  // Twice the counts, so that a centre between two counts is an integer too; 64 bits, so that
  // nothing overflows.
  const std::int64_t twice_off = 2 * std::int64_t{clamp_counts(counts, axis)} - axis.min - axis.max;
  const std::int64_t twice_flat = 2 * std::int64_t{axis.flat};
  const std::int64_t twice_half = std::int64_t{axis.max} - axis.min;
  const std::int64_t size = twice_off < 0 ? -twice_off : twice_off;
  if (size <= twice_flat) return 0.0F;
  // size <= twice_half < 2^32, and rounding is monotone: the quotient cannot exceed 1. A part
  // without an FPU makes a float of 64 bits by way of double.
  const float share = static_cast<float>(static_cast<std::uint32_t>(size - twice_flat)) /
                      static_cast<float>(static_cast<std::uint32_t>(twice_half - twice_flat));
  return (twice_off < 0) != axis.reversed ? -share : share;
}

Status SampleBuilder::configure(const AxisCalibration& x, const AxisCalibration& y) {
  if (!is_valid(x) || !is_valid(y)) return Status::kInvalidArgument;
  *this = SampleBuilder{};
  return set_pair(0, x, y);
}

Status SampleBuilder::configure_feet(const AxisCalibration& x, const AxisCalibration& y) {
  if (!is_valid(x) || !is_valid(y)) return Status::kInvalidArgument;
  count_ = 2 * kPair;
  return set_pair(kPair, x, y);
}

/// @pre both valid
Status SampleBuilder::set_pair(std::size_t first, const AxisCalibration& x,
                               const AxisCalibration& y) {
  axes_[first] = x;
  axes_[first + 1] = y;
  for (State* state : {&synced_, &pending_}) {  // Bound: 2
    state->at[first] = centre(x);
    state->at[first + 1] = centre(y);
  }
  return Status::kOk;
}

void SampleBuilder::axis(Axis which, std::int32_t counts) {
  const auto index = static_cast<std::size_t>(which);
  if (discarding_ || index >= count_) return;
  const AxisCalibration& calibration = axes_[index];
  std::int32_t& position = pending_.at[index];
  const bool relative = calibration.kind == AxisKind::kRelative;
  position = clamp_counts(relative ? std::int64_t{position} + counts : counts, calibration);
}

Status SampleBuilder::button(int index, bool pressed) {
  if (index < 0 || index >= kMaxButtons) return Status::kInvalidArgument;
  if (discarding_) return Status::kOk;
  const std::uint32_t bit = std::uint32_t{1} << static_cast<unsigned>(index);
  pending_.buttons = pressed ? pending_.buttons | bit : pending_.buttons & ~bit;
  return Status::kOk;
}

void SampleBuilder::lost() {
  pending_ = synced_;
  discarding_ = true;
  ++losses_;
}

Result<InputSample> SampleBuilder::sync(Microseconds time) {
  if (discarding_) {
    discarding_ = false;
    return failure<InputSample>(Status::kUnavailable);
  }
  synced_ = pending_;
  InputSample sample;
  sample.time = time;
  sample.x = deflection(axes_[0], synced_.at[0]);
  sample.y = deflection(axes_[1], synced_.at[1]);
  if (count_ > kPair) {
    sample.feet_x = deflection(axes_[kPair], synced_.at[kPair]);
    sample.feet_y = deflection(axes_[kPair + 1], synced_.at[kPair + 1]);
  }
  sample.buttons = synced_.buttons;
  sample.sequence = sequence_;
  ++sequence_;
  return success(sample);
}

}  // namespace batuta
