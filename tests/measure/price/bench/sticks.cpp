// SPDX-License-Identifier: MIT
#include "sticks.hpp"

namespace batuta::price {

void Sticks::take(std::uint32_t step, const InputSample* (&taken)[2]) {
  taken[0] = taken[1] = nullptr;
  while (any_ && step_ <= step) {  // Bound: the records of the chunk
    samples_[side_] = ahead_;
    taken[side_] = &samples_[side_];
    advance();
  }
}

void Sticks::advance() {
  digest::Record record;
  any_ = input_.next(record);
  if (!any_) return;
  step_ = record.word();
  side_ = record.word() & 1U;
  ahead_.time = record.word();
  ahead_.x = record.number();
  ahead_.y = record.number();
  ahead_.buttons = record.word();
  ahead_.sequence = record.word();
}

}  // namespace batuta::price
