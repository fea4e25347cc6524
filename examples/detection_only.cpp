// SPDX-License-Identifier: MIT
// Detection without a world: how far two capsules are apart and where they are closest, and when
// two that move meet. One reads how to choose between `t_free` and `t_hit`, and that "unknown" is
// an answer of its own.
#include <cstdio>

#include "batuta/detection/search.hpp"
using namespace batuta;

// Two rods that cross in the air.
bool print_closest() {
  const Capsule<float> lower = {{{-1, 0, 0}, {1, 0, 0}}, 0.1F};
  const Capsule<float> upper = {{{0.25F, -1, 0.5F}, {0.25F, 1, 0.5F}}, 0.15F};
  const CapsuleGap<float> found = capsule_gap(lower, upper);
  if (found.proximity != Proximity::kSeparated) return false;
  std::printf("gap %.6f m, from (%.6f %.6f %.6f) to (%.6f %.6f %.6f)\n",
              static_cast<double>(found.gap), static_cast<double>(found.surface_A.x()),
              static_cast<double>(found.surface_A.y()), static_cast<double>(found.surface_A.z()),
              static_cast<double>(found.surface_B.x()), static_cast<double>(found.surface_B.y()),
              static_cast<double>(found.surface_B.z()));
  return true;
}

// A rod of 2 m turns about its middle, once round in pi seconds; a ball waits 0.8 m away, a quarter
// of a turn ahead of an end. Where the time that is looked at is too short, they do not meet.
bool print_contact(float seconds, std::uint32_t budget) {
  MovingCapsule<float> rod;
  rod.capsule_B = {{{-1, 0, 0}, {1, 0, 0}}, 0.02F};
  rod.motion.twist.w_W = {0, 0, 2};
  rod.motion.duration = seconds;
  MovingCapsule<float> ball;
  ball.capsule_B = Capsule<float>::sphere({0, 0, 0}, 0.05F);
  ball.motion = still(Pose<float>{{0, 0.8F, 0}, Quat<float>::Identity()}, seconds);

  const auto pair = make_moving_pair(rod, ball);
  if (!pair.ok()) return false;  // not finite, unequal durations, or too large a turn
  AdvancementOptions<float> options;
  options.budget = budget;
  const SearchResult<float> found = search_advancement(pair.value, options);
  switch (found.outcome) {
    case Outcome::kFree:
      std::printf("free for all of %.6f s\n", static_cast<double>(found.t_free));
      return true;
    case Outcome::kContact:  // proven free up to t_free; t_hit is the best estimate of the contact
      std::printf("contact: free up to %.6f s, hit at %.6f s, %u evaluations\n",
                  static_cast<double>(found.t_free), static_cast<double>(found.t_hit),
                  found.evaluations);
      return true;
    case Outcome::kBudget:  // stop at t_free; what comes after is not known
      std::printf("unknown after %.6f s, for %u evaluations were not enough\n",
                  static_cast<double>(found.t_free), found.evaluations);
      return true;
    default:
      return false;
  }
}

int main() {
  const bool good =
      print_closest() && print_contact(0.5F, 64) && print_contact(1, 64) && print_contact(1, 2);
  return good ? 0 : 1;
}
