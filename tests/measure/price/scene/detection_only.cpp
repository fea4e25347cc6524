// SPDX-License-Identifier: MIT
// Two moving capsules, one question: when do they first touch? Detection alone, no bodies, no
// response.

#include "batuta/detection/advancement.hpp"

namespace {

using batuta::MovingCapsule;
using batuta::Outcome;

// Volatile ends of the question: what is asked is not known to the compiler.
MovingCapsule<float> left;
MovingCapsule<float> right;
float volatile deadline;
float volatile answer;

Outcome ask() {
  const auto pair = batuta::make_moving_pair(left, right);
  if (!pair.ok()) return Outcome::kInvalid;
  const auto found = batuta::search_advancement(pair.value, batuta::AdvancementOptions<float>{});
  answer = found.t_free;
  return found.outcome;
}

}  // namespace

int main() {
  left.motion.duration = deadline;
  right.motion.duration = deadline;
  return static_cast<int>(ask());
}
