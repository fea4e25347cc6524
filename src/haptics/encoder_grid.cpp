// SPDX-License-Identifier: MIT
#include "batuta/haptics/detail/encoder_grid.hpp"

#include "batuta/haptics/detail/whole.hpp"

namespace batuta::detail {
namespace {

/// Of a difference of two positions that are rounded to float, and itself.
constexpr float kRoundedWay = 4 * kRoundOff<float>;
/// A remainder is one, or none, only where its error is less than this share of the step.
constexpr float kClear = 0.125F;

}  // namespace

void EncoderGrid::take(float shown) {
  const float way = std::abs(shown - last_);
  const bool has_way = has_last_;
  last_ = shown;
  has_last_ = true;
  largest_ = max_of(largest_, std::abs(shown));
  rounding_ = kRoundedWay * largest_;
  if (!has_way || way <= rounding_) return;
  if (block_.step == 0.0F) {
    block_ = {way, rounding_};
  } else if (!is_fine_) {
    if (divide(way)) ++count_;
    is_fine_ = block_.step < kLeastSteps * rounding_;
  }
}

/// A block that found a step has one vote; the step that more than half of them agree on is left at
/// the end (Boyer and Moore), with a lead that is no more than it has.
void EncoderGrid::end_block() {
  const bool is_found = is_fine_ || count_ >= kEnough;
  const GridStep found = is_fine_ ? GridStep{0, kLeastSteps * rounding_} : block_;
  block_ = {};
  count_ = 0;
  is_fine_ = false;
  if (!is_found) return;
  ++blocks_;
  if (lead_ > 0 && is_same(found, most_)) {
    ++lead_;
    // Of two steps the one that is known better; of two limits the one that holds for both.
    const bool is_better =
        found.step > 0.0F ? found.error < most_.error : found.error > most_.error;
    if (is_better) most_ = found;
  } else if (lead_ > 0) {
    --lead_;
  } else {
    most_ = found;
    lead_ = 1;
  }
}

bool EncoderGrid::is_same(const GridStep& one, const GridStep& other) const {
  if (one.step == 0.0F || other.step == 0.0F) return one.step == other.step;
  return std::abs(one.step - other.step) <= one.error + other.error;
}

/// Euclid, with an error that is carried along. @returns whether it came to an end
bool EncoderGrid::divide(float way) {
  float error = rounding_;
  for (int i = 0; i < kDivisions; ++i) {  // Bound: kDivisions
    const float whole = whole_below(way / block_.step + 0.5F);
    const float rest = std::abs(way - whole * block_.step);
    const float rest_error = error + whole * block_.error;
    if (rest_error > kClear * block_.step) return false;  // too many steps for what is known of one
    if (rest <= rest_error) {
      if (whole > 0.0F && error / whole < block_.error) {
        block_.step = way / whole;
        block_.error = error / whole;
      }
      return true;
    }
    way = block_.step;
    error = block_.error;
    block_.step = rest;
    block_.error = rest_error;
  }
  return false;
}

}  // namespace batuta::detail
