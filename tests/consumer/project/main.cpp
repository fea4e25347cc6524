// SPDX-License-Identifier: MIT
// How far are two blades apart?
#include <cstdio>

#include "batuta/geometry/capsule.hpp"

int main() {
  using batuta::Vec3;
  batuta::Capsule<float> ours;
  ours.axis = {Vec3<float>(0, 0, 0), Vec3<float>(1, 0, 0)};
  ours.radius = 0.25F;
  batuta::Capsule<float> theirs = ours;
  theirs.axis = {Vec3<float>(0.5F, -1, 1), Vec3<float>(0.5F, 1, 1)};

  const auto answer = batuta::capsule_gap(ours, theirs);
  std::printf("gap %g m\n", static_cast<double>(answer.gap));
  return answer.proximity == batuta::Proximity::kSeparated && answer.gap == 0.5F ? 0 : 1;
}
